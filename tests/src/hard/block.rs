//! The `model` block of a reference, evaluated as it is written: a second derivation of rows and forces to hold a
//! scene against, so that no number of a hand-written model is mistyped.

use crate::garage::{Names, list, number, number_or_zero, worse};
use ezy_core::model::Scene;
use ezy_core::prelude::Backend;
use ezy_core_tests::system_of;
use serde_json::Value;

/// Random states at which a scene is compared.
const N_STATES: usize = 5;
/// Largest coordinate and velocity of a random state.
const RANGE: f64 = 2.0;

/// A state, and where the bodies of the block stand in it.
struct At<'a> {
    t: f64,
    q: &'a [f64],
    v: &'a [f64],
    /// Name in the block, index in the scene.
    bodies: &'a [(String, usize)],
}

/// A place with its velocity and the body that carries it.
struct Place {
    body: Option<usize>,
    /// From the centre of mass, along the axes of the ground.
    arm: [f64; 2],
    r: [f64; 2],
    v: [f64; 2],
}

impl At<'_> {
    fn body(&self, name: &Value) -> Option<usize> {
        self.bodies.iter().find(|(theirs, _)| name == theirs.as_str()).map(|&(_, i)| i)
    }

    fn place(&self, body: &Value, local: &Value) -> Place {
        let [x, y] = pair(local);
        let Some(i) = self.body(body) else { return Place { body: None, arm: [0.0; 2], r: [x, y], v: [0.0; 2] } };
        let (q, v) = (&self.q[3 * i..3 * i + 3], &self.v[3 * i..3 * i + 3]);
        let (sin, cos) = q[2].sin_cos();
        let arm = [x * cos - y * sin, x * sin + y * cos];
        Place { body: Some(i), arm, r: [q[0] + arm[0], q[1] + arm[1]], v: [v[0] - arm[1] * v[2], v[1] + arm[0] * v[2]] }
    }

    fn angle(&self, body: &Value) -> [f64; 2] {
        self.body(body).map_or([0.0; 2], |i| [self.q[3 * i + 2], self.v[3 * i + 2]])
    }

    /// Position constraints and their rates, then skates: the magnitudes of what must vanish, as signs and order are free.
    fn rows(&self, model: &Value) -> (Vec<f64>, Vec<f64>) {
        let (mut positions, mut rates) = (Vec::new(), Vec::new());
        for hinge in list(&model["hinges"]) {
            let (a, b) = (self.place(&hinge["a"], &hinge["pa"]), self.place(&hinge["b"], &hinge["pb"]));
            positions.extend([a.r[0] - b.r[0], a.r[1] - b.r[1]]);
            rates.extend([a.v[0] - b.v[0], a.v[1] - b.v[1]]);
        }
        for line in list(&model["lines"]) {
            let (p, [nx, ny]) = (self.place(&line["body"], &line["point"]), pair(&line["normal"]));
            positions.push(nx * p.r[0] + ny * p.r[1] - number(&line["offset"]));
            rates.push(nx * p.v[0] + ny * p.v[1]);
        }
        for driver in list(&model["drivers"]) {
            let ([a, a_rate], [b, b_rate]) = (self.angle(&driver["a"]), self.angle(&driver["b"]));
            let n = |name: &str| number_or_zero(&driver[name]);
            let phase = n("freq") * self.t + n("phase");
            positions.push(b - a - (n("c0") + n("rate") * self.t + n("amp") * phase.sin()));
            rates.push(b_rate - a_rate - (n("rate") + n("amp") * n("freq") * phase.cos()));
        }
        for skate in list(&model["skates"]) {
            let p = self.place(&skate["body"], &skate["point"]);
            let (sin, cos) = (self.angle(&skate["body"])[0] + number(&skate["heading"])).sin_cos();
            rates.push(-sin * p.v[0] + cos * p.v[1]);
        }
        (magnitudes(positions), magnitudes(rates))
    }

    /// Applied forces, as the scene states them.
    fn forces(&self, model: &Value, mass: &[f64]) -> Vec<f64> {
        let gravity = pair(&model["gravity"]);
        let mut out: Vec<f64> =
            mass.iter().enumerate().map(|(i, m)| m * [gravity[0], gravity[1], 0.0][i % 3]).collect();
        let mut push = |p: &Place, f: [f64; 2]| {
            if let Some(i) = p.body {
                out[3 * i] += f[0];
                out[3 * i + 1] += f[1];
                out[3 * i + 2] += p.arm[0] * f[1] - p.arm[1] * f[0];
            }
        };
        for spring in list(&model["springs"]) {
            let (a, b) = (self.place(&spring["a"], &spring["pa"]), self.place(&spring["b"], &spring["pb"]));
            let (dx, dy) = (b.r[0] - a.r[0], b.r[1] - a.r[1]);
            let length = dx.hypot(dy);
            let [ux, uy] = [dx / length, dy / length];
            let rate = ux * (b.v[0] - a.v[0]) + uy * (b.v[1] - a.v[1]);
            let pull = number(&spring["k"]) * (length - number(&spring["l0"])) + number_or_zero(&spring["c"]) * rate;
            push(&b, [-pull * ux, -pull * uy]);
            push(&a, [pull * ux, pull * uy]);
        }
        for force in list(&model["forces"]) {
            let (p, [fx, fy]) = (self.place(&force["body"], &force["point"]), pair(&force["f"]));
            let (sin, cos) =
                if force["frame"] == "body" { self.angle(&force["body"])[0].sin_cos() } else { (0.0, 1.0) };
            push(&p, [fx * cos - fy * sin, fx * sin + fy * cos]);
        }
        for drag in list(&model["drag"]) {
            let i = self.body(&drag["body"]).expect("a body with drag");
            let (linear, angular) = (number(&drag["lin"]), number(&drag["ang"]));
            for (k, factor) in [linear, linear, angular].into_iter().enumerate() {
                out[3 * i + k] -= factor * self.v[3 * i + k];
            }
        }
        let mut turn = |a: &Value, b: &Value, torque: f64| {
            for (body, torque) in [(a, -torque), (b, torque)] {
                if let Some(i) = self.body(body) {
                    out[3 * i + 2] += torque;
                }
            }
        };
        for torsion in list(&model["torsion"]) {
            let ([a, a_rate], [b, b_rate]) = (self.angle(&torsion["a"]), self.angle(&torsion["b"]));
            let n = |name: &str| number_or_zero(&torsion[name]);
            turn(&torsion["a"], &torsion["b"], -n("k") * (b - a - n("angle0")) - n("c") * (b_rate - a_rate));
        }
        for torque in list(&model["torques"]) {
            let n = |name: &str| number_or_zero(&torque[name]);
            turn(&torque["a"], &torque["b"], n("const") + n("amp") * (n("freq") * self.t + n("phase")).sin());
        }
        out
    }
}

/// Largest difference of masses, rows, their rates and applied forces between a scene and the `model` block of a
/// reference, at random states, relative where numbers are large. Rows may stand in another order, with another sign.
///
/// # Panics
/// When a number is missing in the block, a body in the scene, or the scene has another number of rows.
pub fn difference(model: &Value, scene: &dyn Scene, names: Names<'_>) -> f64 {
    let system = system_of(scene, Backend::Auto).expect("a scene that can be set up");
    let (info, c, mass) = (system.info(), system.fixed(), system.mass_matrix());
    let index = |body: &Value| {
        let theirs = body["name"].as_str().expect("a name");
        let ours = names.iter().find(|(name, _)| *name == theirs).map_or(theirs, |&(_, ours)| ours);
        let i = info.bodies.iter().position(|name| *name == ours).unwrap_or_else(|| panic!("no body `{ours}`"));
        (theirs.to_owned(), i)
    };
    let bodies: Vec<(String, usize)> = list(&model["bodies"]).iter().map(index).collect();
    assert_eq!(bodies.len(), info.bodies.len(), "bodies");
    let mut worst = 0.0;
    for (body, (_, i)) in list(&model["bodies"]).iter().zip(&bodies) {
        worst = worse(worst, relative(mass[3 * i], number(&body["mass"])));
        worst = worse(worst, relative(mass[3 * i + 2], number(&body["inertia"])));
    }
    let mut random = Random(1);
    for _ in 0..N_STATES {
        let q: Vec<f64> = mass.iter().map(|_| random.next()).collect();
        let v: Vec<f64> = mass.iter().map(|_| random.next()).collect();
        let at = At { t: random.next().abs(), q: &q, v: &v, bodies: &bodies };
        let (positions, rates) = at.rows(model);
        let (mut c_q, mut g_v) = (vec![0.0; info.n_position_rows], vec![0.0; info.n_rows()]);
        scene.position_constraint(c, at.t, &q, &mut c_q);
        scene.velocity_constraint(c, at.t, &q, &v, &mut g_v);
        let mut force = vec![0.0; q.len()];
        scene.applied_force(c, at.t, &q, &v, &mut force);
        for (ours, theirs) in [(magnitudes(c_q), positions), (magnitudes(g_v), rates), (force, at.forces(model, mass))]
        {
            assert_eq!(ours.len(), theirs.len(), "rows");
            worst = ours.iter().zip(&theirs).map(|(x, y)| relative(*x, *y)).fold(worst, worse);
        }
    }
    worst
}

fn magnitudes(mut numbers: Vec<f64>) -> Vec<f64> {
    numbers.iter_mut().for_each(|x| *x = x.abs());
    numbers.sort_by(f64::total_cmp);
    numbers
}

fn relative(x: f64, y: f64) -> f64 {
    (x - y).abs() / y.abs().max(1.0)
}

fn pair(value: &Value) -> [f64; 2] {
    [number(&value[0]), number(&value[1])]
}

/// Numbers in the range, the same each time.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        RANGE * ((self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0)
    }
}
