//! What a mechanism demands and feels, by plain kinematics and no other rule than the notation's.

use super::mechanism::{Direction, Force, Law, Mechanism, Place, Row};

/// A state of motion.
#[derive(Debug, Clone)]
pub struct State {
    pub t: f64,
    pub q: Vec<f64>,
    pub v: Vec<f64>,
}

impl State {
    /// The state after τ on a path along which velocities are held.
    pub fn ahead(&self, tau: f64) -> Self {
        let q = self.q.iter().zip(&self.v).map(|(q, v)| q + tau * v).collect();
        Self { t: self.t + tau, q, v: self.v.clone() }
    }
}

pub fn position(place: &Place, q: &[f64]) -> [f64; 2] {
    let Some(body) = place.body else { return [place.x.number, place.y.number] };
    let arm = arm(place, q);
    [q[3 * body] + arm[0], q[3 * body + 1] + arm[1]]
}

/// From the centre of mass to the place.
fn arm(place: &Place, q: &[f64]) -> [f64; 2] {
    place.body.map_or([0.0; 2], |body| turned([place.x.number, place.y.number], q[3 * body + 2]))
}

fn velocity(place: &Place, at: &State) -> [f64; 2] {
    let Some(body) = place.body else { return [0.0; 2] };
    let [x, y] = arm(place, &at.q);
    let omega = at.v[3 * body + 2];
    [at.v[3 * body] - omega * y, at.v[3 * body + 1] + omega * x]
}

/// The unit vector along a direction.
pub fn unit(direction: &Direction, q: &[f64]) -> [f64; 2] {
    let (x, y) = (direction.x.number, direction.y.number);
    turned([x / x.hypot(y), y / x.hypot(y)], q[3 * direction.body + 2])
}

fn turned([x, y]: [f64; 2], angle: f64) -> [f64; 2] {
    let (sin, cos) = angle.sin_cos();
    [cos * x - sin * y, sin * x + cos * y]
}

fn across([x, y]: [f64; 2]) -> [f64; 2] {
    [-y, x]
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

fn times(k: f64, a: [f64; 2]) -> [f64; 2] {
    a.map(|x| k * x)
}

fn gap(a: &Place, b: &Place, q: &[f64]) -> [f64; 2] {
    let (a, b) = (position(a, q), position(b, q));
    [b[0] - a[0], b[1] - a[1]]
}

fn angle(body: Option<usize>, of: &[f64]) -> f64 {
    body.map_or(0.0, |body| of[3 * body + 2])
}

/// C of all position constraints, in declared order.
pub fn position_rows(made: &Mechanism, q: &[f64], t: f64) -> Vec<f64> {
    let mut rows = Vec::new();
    for row in &made.rows {
        match row {
            Row::Hinge(a, b) => rows.extend(times(-1.0, gap(a, b, q))),
            Row::Weld(a, b, offset) => {
                rows.extend(times(-1.0, gap(a, b, q)));
                rows.push(angle(b.body, q) - angle(a.body, q) - offset.number);
            }
            Row::Slider(a, b, along, offset) => {
                rows.push(dot(across(unit(along, q)), gap(a, b, q)));
                rows.push(angle(b.body, q) - angle(a.body, q) - offset.number);
            }
            Row::Slot(a, b, along) => rows.push(dot(across(unit(along, q)), gap(a, b, q))),
            Row::Rod(a, b, length) => {
                let gap = gap(a, b, q);
                rows.push((dot(gap, gap) / length.number - length.number) / 2.0);
            }
            Row::Gear(a, b, ratio, offset) => {
                rows.push(q[3 * a + 2] - ratio.number * q[3 * b + 2] - offset.number);
            }
            Row::Drive(body, start, amplitude, omega) => {
                rows.push(q[3 * body + 2] - start.number - amplitude.number * (omega.number * t).sin());
            }
            Row::Track(body, height, bend) => {
                rows.push(q[3 * body + 1] - height.number - bend.number * q[3 * body].powi(2));
            }
            Row::Skate(..) | Row::Roll(..) | Row::Twist(..) => {}
        }
    }
    rows
}

/// S v + s_t of all velocity constraints, in declared order.
pub fn velocity_rows(made: &Mechanism, at: &State) -> Vec<f64> {
    let rows = made.rows.iter().filter_map(|row| match row {
        Row::Skate(place, along) => Some(dot(across(unit(along, &at.q)), velocity(place, at))),
        Row::Roll(place, along, radius, wheel) => {
            Some(dot(unit(along, &at.q), velocity(place, at)) - radius.number * at.v[3 * wheel + 2])
        }
        Row::Twist(body, slope, speed) => {
            let twist = slope.number * at.q[3 * body] * at.v[3 * body + 2];
            Some(at.v[3 * body + 1] - twist - speed.number * at.t.cos())
        }
        _ => None,
    });
    rows.collect()
}

fn law(law: &Law, at: &State) -> f64 {
    match law {
        Law::Cosine(amplitude, omega) => amplitude.number * (omega.number * at.t).cos(),
        Law::Damping(k, body) => -k.number * at.v[3 * body + 2] * at.v[3 * body].abs(),
        Law::Position(k, body) => k.number * at.q[3 * body + 2].sin() * at.q[3 * body],
    }
}

/// F, and the potential energy of those forces that have one.
pub fn forces(made: &Mechanism, at: &State) -> (Vec<f64>, f64) {
    let mut felt = Felt { force: vec![0.0; at.q.len()], at };
    let mut potential = 0.0;
    for force in &made.forces {
        match force {
            Force::Gravity(x, y) => {
                for (i, [mass, _]) in made.bodies.iter().enumerate() {
                    felt.force[3 * i] += mass.number * x.number;
                    felt.force[3 * i + 1] += mass.number * y.number;
                    potential -= mass.number * (x.number * at.q[3 * i] + y.number * at.q[3 * i + 1]);
                }
            }
            Force::Vector(place, x, k) => {
                let height = place.body.map_or(0.0, |body| at.q[3 * body + 1]);
                felt.push(place, [law(x, at), -k.number * height]);
            }
            Force::Along(place, along, value) => felt.push(place, times(law(value, at), unit(along, &at.q))),
            Force::Across(place, along, value) => felt.push(place, times(law(value, at), across(unit(along, &at.q)))),
            Force::Torque(body, other, value) => felt.twist(Some(*body), *other, law(value, at)),
            Force::Spring(a, b, stiffness, length, damping) => {
                let gap = gap(a, b, &at.q);
                let stretch = gap[0].hypot(gap[1]) - length.number;
                potential += stiffness.number * stretch * stretch / 2.0;
                felt.pull(a, b, stiffness.number * stretch, damping.as_ref().map_or(0.0, |c| c.number));
            }
            Force::Damper(a, b, damping) => felt.pull(a, b, 0.0, damping.number),
            Force::Torsion(body, other, stiffness, offset, damping) => {
                let turned = |of: &[f64]| angle(*other, of) - angle(Some(*body), of);
                let twist = turned(&at.q) - offset.number;
                potential += stiffness.number * twist * twist / 2.0;
                let damping = damping.as_ref().map_or(0.0, |c| c.number);
                felt.twist(Some(*body), *other, stiffness.number * twist + damping * turned(&at.v));
            }
            Force::Drag(place, k1, k2, k3) => {
                let v = velocity(place, at);
                felt.push(place, times(-k1.number - k2.number * v[0].hypot(v[1]), v));
                felt.twist(place.body, None, -k3.number * angle(place.body, &at.v));
            }
            Force::Friction(place, largest, knee) => {
                let v = velocity(place, at);
                felt.push(place, times(-largest.number / v[0].hypot(v[1]).hypot(knee.number), v));
            }
            Force::FrictionAlong(place, along, largest, knee) => {
                let along = unit(along, &at.q);
                let speed = dot(along, velocity(place, at));
                felt.push(place, times(-largest.number * speed / speed.hypot(knee.number), along));
            }
            Force::FrictionCouple(body, other, largest, knee) => {
                let rate = angle(*other, &at.v) - angle(Some(*body), &at.v);
                felt.twist(Some(*body), *other, largest.number * rate / rate.hypot(knee.number));
            }
            Force::Tyre(place, along, stiffness, limit, knee) => {
                let (along, v) = (unit(along, &at.q), velocity(place, at));
                let slip = dot(across(along), v).atan2(dot(along, v).hypot(knee.number));
                let side = match limit {
                    Some(limit) => limit.number * (stiffness.number * slip / limit.number).tanh(),
                    None => stiffness.number * slip,
                };
                felt.push(place, times(-side, across(along)));
            }
            Force::FrictionOnTread(place, along, largest, knee, radius, wheel) => {
                let along = unit(along, &at.q);
                let slip = dot(along, velocity(place, at)) - radius.number * at.v[3 * wheel + 2];
                let force = -largest.number * slip / slip.hypot(knee.number);
                felt.push(place, times(force, along));
                felt.twist(Some(*wheel), None, -radius.number * force);
            }
            Force::TyreWithTread(place, along, stiffness, limit, knee, radius, wheel) => {
                let (along, v) = (unit(along, &at.q), velocity(place, at));
                let rolling = radius.number * at.v[3 * wheel + 2];
                let slip = [dot(along, v) - rolling, dot(across(along), v)];
                let speed = slip[0].hypot(slip[1]);
                let elastic = stiffness.number * speed.atan2(rolling.hypot(knee.number));
                let size = limit.as_ref().map_or(elastic, |limit| limit.number * (elastic / limit.number).tanh());
                let force = times(-size / speed, slip);
                felt.push(place, times(force[0], along));
                felt.push(place, times(force[1], across(along)));
                felt.twist(Some(*wheel), None, -radius.number * force[0]);
            }
        }
    }
    (felt.force, potential)
}

/// Forces on the bodies, gathered.
struct Felt<'a> {
    force: Vec<f64>,
    at: &'a State,
}

impl Felt<'_> {
    fn push(&mut self, place: &Place, force: [f64; 2]) {
        let Some(body) = place.body else { return };
        self.force[3 * body] += force[0];
        self.force[3 * body + 1] += force[1];
        self.force[3 * body + 2] += dot(across(arm(place, &self.at.q)), force);
    }

    /// A torque on the first body and its reaction on the other.
    fn twist(&mut self, body: Option<usize>, other: Option<usize>, torque: f64) {
        for (body, torque) in [(body, torque), (other, -torque)] {
            if let Some(body) = body {
                self.force[3 * body + 2] += torque;
            }
        }
    }

    /// Places that attract each other with a tension, and with `damping` times the rate of their distance.
    fn pull(&mut self, a: &Place, b: &Place, tension: f64, damping: f64) {
        let gap = gap(a, b, &self.at.q);
        let line = times(1.0 / gap[0].hypot(gap[1]), gap);
        let (u, w) = (velocity(a, self.at), velocity(b, self.at));
        let rate = dot(line, [w[0] - u[0], w[1] - u[1]]);
        let force = times(tension + damping * rate, line);
        self.push(a, force);
        self.push(b, times(-1.0, force));
    }
}
