//! Random mechanisms: trees and loops of bodies with every kind of row and force, as text and as numbers.
//!
//! Each is built around a configuration in which its rows hold, so that it can be started there.

use std::f64::consts::PI;
use std::fmt::Write;

use crate::random::Random;

/// A number with the text that stands for it: itself or the name of a parameter.
#[derive(Debug, Clone)]
pub struct Value {
    pub number: f64,
    text: String,
}

#[derive(Debug, Clone)]
pub struct Place {
    pub body: Option<usize>,
    pub x: Value,
    pub y: Value,
}

/// A direction of a body, by its angle in the body's own axes and a length that must not matter.
#[derive(Debug, Clone)]
pub struct Direction {
    pub body: usize,
    pub x: Value,
    pub y: Value,
}

#[derive(Debug, Clone)]
pub enum Row {
    Hinge(Place, Place),
    Weld(Place, Place, Value),
    Slider(Place, Place, Direction, Value),
    Slot(Place, Place, Direction),
    Rod(Place, Place, Value),
    Gear(usize, usize, Value, Value),
    /// φ = angle + amplitude sin(ω t)
    Drive(usize, Value, Value, Value),
    /// y = height + bend x²
    Track(usize, Value, Value),
    Skate(Place, Direction),
    /// e · v_P = radius φ̇
    Roll(Place, Direction, Value, usize),
    /// v_y = slope x φ̇ + speed cos(t)
    Twist(usize, Value, Value),
}

/// A scalar law.
#[derive(Debug, Clone)]
pub enum Law {
    /// amplitude cos(ω t)
    Cosine(Value, Value),
    /// −k φ̇ |v_x|
    Damping(Value, usize),
    /// k sin(φ) x
    Position(Value, usize),
}

#[derive(Debug, Clone)]
pub enum Force {
    Gravity(Value, Value),
    /// A law along x, −k y along y.
    Vector(Place, Law, Value),
    Along(Place, Direction, Law),
    Across(Place, Direction, Law),
    Torque(usize, Option<usize>, Law),
    Spring(Place, Place, Value, Value, Option<Value>),
    Damper(Place, Place, Value),
    Torsion(usize, Option<usize>, Value, Value, Option<Value>),
    Drag(Place, Value, Value, Value),
    Friction(Place, Value, Value),
    FrictionAlong(Place, Direction, Value, Value),
    FrictionCouple(usize, Option<usize>, Value, Value),
    Tyre(Place, Direction, Value, Option<Value>, Value),
    /// On a tread that runs at radius φ̇ of a body.
    FrictionOnTread(Place, Direction, Value, Value, Value, usize),
    TyreWithTread(Place, Direction, Value, Option<Value>, Value, Value, usize),
}

#[derive(Debug, Default)]
pub struct Mechanism {
    /// Mass and moment of inertia.
    pub bodies: Vec<[Value; 2]>,
    pub rows: Vec<Row>,
    pub forces: Vec<Force>,
    /// Where the rows hold at t = 0: x, y, φ of each body.
    pub assembled: Vec<f64>,
    parameters: Vec<Value>,
}

/// Builds one mechanism.
struct Builder {
    random: Random,
    made: Mechanism,
}

/// A mechanism of `n_bodies`; equal seeds give equal mechanisms.
pub fn mechanism(seed: u64, n_bodies: usize) -> Mechanism {
    let mut builder = Builder { random: Random::new(seed), made: Mechanism::default() };
    for body in 0..n_bodies {
        let values = [builder.value(0.5, 2.0), builder.value(0.2, 1.0)];
        builder.made.bodies.push(values);
        let [x, y] = [0, 1].map(|_| builder.random.between(-2.0, 2.0));
        let angle = builder.random.between(-PI, PI);
        builder.made.assembled.extend([x, y, angle]);
        builder.join(body);
    }
    builder.close();
    for _ in 0..builder.random.below(7) {
        let force = builder.force();
        builder.made.forces.push(force);
    }
    builder.made
}

impl Builder {
    fn value(&mut self, low: f64, high: f64) -> Value {
        let number = self.random.between(low, high);
        if self.random.below(4) > 0 {
            return Value::number(number);
        }
        let value = Value { number, text: format!("p{}", self.made.parameters.len()) };
        self.made.parameters.push(value.clone());
        value
    }

    /// A value away from zero, of either sign.
    fn signed(&mut self) -> Value {
        if self.random.below(2) == 0 { self.value(0.3, 1.5) } else { self.value(-1.5, -0.3) }
    }

    fn place(&mut self, body: Option<usize>) -> Place {
        Place { body, x: self.value(-1.0, 1.0), y: self.value(-1.0, 1.0) }
    }

    /// The place on `body` that is at `position` in the assembled configuration.
    fn place_at(&self, body: usize, position: [f64; 2]) -> Place {
        let q = &self.made.assembled[3 * body..3 * body + 3];
        let (sin, cos) = q[2].sin_cos();
        let (x, y) = (position[0] - q[0], position[1] - q[1]);
        Place { body: Some(body), x: Value::number(cos * x + sin * y), y: Value::number(cos * y - sin * x) }
    }

    fn direction(&mut self, body: usize) -> Direction {
        Direction { body, x: self.signed(), y: self.signed() }
    }

    fn angle(&self, body: Option<usize>) -> f64 {
        body.map_or(0.0, |body| self.made.assembled[3 * body + 2])
    }

    fn position(&self, place: &Place) -> [f64; 2] {
        super::oracle::position(place, &self.made.assembled)
    }

    /// Ties a body to the ground or to an earlier one, or leaves it free.
    fn join(&mut self, body: usize) {
        let parent = self.random.below(body + 1).checked_sub(1);
        let row = match self.random.below(12) {
            0 => return,
            1 => self.weld(parent, body),
            2 => self.slider(parent, body),
            3 => self.slot(parent, body),
            4 => self.rod(parent, body),
            _ => self.hinge(parent, body),
        };
        self.made.rows.push(row);
    }

    /// Rows that close loops, steer or drive, while there is freedom left for forces to act on.
    fn close(&mut self) {
        let n_bodies = self.made.bodies.len();
        let freedom = (3 * n_bodies).saturating_sub(self.made.rows.iter().map(Row::n_rows).sum::<usize>());
        let wanted = self.random.below(freedom.max(1));
        let mut n_rows = 0;
        for _ in 0..4 * n_bodies {
            let body = self.random.below(n_bodies);
            let other = self.random.below(n_bodies + 1).checked_sub(1).filter(|&other| other != body);
            let row = match self.random.below(15) {
                0 => self.hinge(other, body),
                1 => self.slot(other, body),
                2 | 3 => self.rod(other, body),
                4 => self.gear(other, body),
                5 => self.drive(body),
                6 => self.track(body),
                7..=10 => Row::Skate(self.place(Some(body)), self.direction(body)),
                11 | 12 => {
                    Row::Roll(self.place(Some(body)), self.direction(body), self.signed(), other.unwrap_or(body))
                }
                _ => Row::Twist(body, self.signed(), self.signed()),
            };
            if n_rows + row.n_rows() <= wanted {
                n_rows += row.n_rows();
                self.made.rows.push(row);
            }
        }
    }

    fn hinge(&mut self, a: Option<usize>, b: usize) -> Row {
        let a = self.place(a);
        let position = self.position(&a);
        Row::Hinge(a, self.place_at(b, position))
    }

    fn weld(&mut self, a: Option<usize>, b: usize) -> Row {
        let turned = Value::number(self.angle(Some(b)) - self.angle(a));
        let a = self.place(a);
        let position = self.position(&a);
        Row::Weld(a, self.place_at(b, position), turned)
    }

    /// A place on `b` that is on the line through `a` along the direction, which belongs to the first body.
    fn on_line(&mut self, a: Option<usize>, b: usize) -> (Place, Place, Direction) {
        let a = self.place(a);
        let direction = self.direction(a.body.unwrap_or(b));
        let along = super::oracle::unit(&direction, &self.made.assembled);
        let (start, distance) = (self.position(&a), self.random.between(-1.0, 1.0));
        let b = self.place_at(b, [0, 1].map(|i| start[i] + distance * along[i]));
        (a, b, direction)
    }

    fn slider(&mut self, a: Option<usize>, b: usize) -> Row {
        let turned = Value::number(self.angle(Some(b)) - self.angle(a));
        let (a, b, direction) = self.on_line(a, b);
        Row::Slider(a, b, direction, turned)
    }

    fn slot(&mut self, a: Option<usize>, b: usize) -> Row {
        let (a, b, direction) = self.on_line(a, b);
        Row::Slot(a, b, direction)
    }

    fn rod(&mut self, a: Option<usize>, b: usize) -> Row {
        let (a, b) = (self.place(a), self.place(Some(b)));
        let (p, q) = (self.position(&a), self.position(&b));
        Row::Rod(a, b, Value::number((q[0] - p[0]).hypot(q[1] - p[1])))
    }

    fn gear(&mut self, a: Option<usize>, b: usize) -> Row {
        let Some(a) = a else { return self.drive(b) };
        let ratio = self.signed();
        let offset = self.angle(Some(a)) - ratio.number * self.angle(Some(b));
        Row::Gear(a, b, ratio, Value::number(offset))
    }

    fn drive(&mut self, body: usize) -> Row {
        Row::Drive(body, Value::number(self.angle(Some(body))), self.signed(), self.value(0.5, 2.0))
    }

    fn track(&mut self, body: usize) -> Row {
        let bend = self.signed();
        let (x, y) = (self.made.assembled[3 * body], self.made.assembled[3 * body + 1]);
        Row::Track(body, Value::number(y - bend.number * x * x), bend)
    }

    fn law(&mut self) -> Law {
        let body = self.random.below(self.made.bodies.len());
        match self.random.below(3) {
            0 => Law::Cosine(self.signed(), self.value(0.5, 2.0)),
            1 => Law::Damping(self.signed(), body),
            _ => Law::Position(self.signed(), body),
        }
    }

    fn force(&mut self) -> Force {
        let n_bodies = self.made.bodies.len();
        let body = self.random.below(n_bodies);
        let other = self.random.below(n_bodies + 1).checked_sub(1).filter(|&other| other != body);
        let at = self.place(Some(body));
        let direction = self.direction(other.unwrap_or(body));
        let damping = (self.random.below(2) == 0).then(|| self.value(0.3, 1.5));
        match self.random.below(15) {
            0 => Force::Gravity(self.signed(), self.signed()),
            1 => Force::Vector(at, self.law(), self.signed()),
            2 => Force::Along(at, direction, self.law()),
            3 => Force::Across(at, direction, self.law()),
            4 => Force::Torque(body, other, self.law()),
            5 => Force::Spring(self.place(other), at, self.value(1.0, 5.0), self.value(0.0, 1.0), damping),
            6 => Force::Damper(self.place(other), at, self.value(0.3, 1.5)),
            7 => Force::Torsion(body, other, self.value(1.0, 5.0), self.signed(), damping),
            8 => Force::Drag(at, self.value(0.3, 1.5), self.value(0.3, 1.5), self.value(0.3, 1.5)),
            9 => Force::Friction(at, self.value(0.3, 1.5), self.value(0.3, 1.5)),
            10 => Force::FrictionAlong(at, direction, self.value(0.3, 1.5), self.value(0.3, 1.5)),
            11 => Force::FrictionCouple(body, other, self.value(0.3, 1.5), self.value(0.3, 1.5)),
            12 => Force::Tyre(at, direction, self.value(1.0, 5.0), damping, self.value(0.3, 1.5)),
            13 => {
                let [largest, knee] = [self.value(0.3, 1.5), self.value(0.3, 1.5)];
                Force::FrictionOnTread(at, direction, largest, knee, self.signed(), other.unwrap_or(body))
            }
            _ => {
                let [stiffness, knee] = [self.value(1.0, 5.0), self.value(0.3, 1.5)];
                Force::TyreWithTread(at, direction, stiffness, damping, knee, self.signed(), other.unwrap_or(body))
            }
        }
    }
}

impl Value {
    fn number(number: f64) -> Self {
        let sign = if number < 0.0 { "-" } else { "" };
        Self { number, text: format!("{sign}{:?}", number.abs()) }
    }
}

impl Row {
    pub fn n_rows(&self) -> usize {
        match self {
            Self::Weld(..) => 3,
            Self::Hinge(..) | Self::Slider(..) => 2,
            _ => 1,
        }
    }

    fn text(&self, i: usize) -> String {
        match self {
            Self::Hinge(a, b) => format!("hinge r{i}: {a} ~ {b};"),
            Self::Weld(a, b, angle) => format!("weld r{i}: {a} ~ {b} angle {angle};"),
            Self::Slider(a, b, along, angle) => format!("slider r{i}: {a} ~ {b} along {along} angle {angle};"),
            Self::Slot(a, b, along) => format!("slot r{i}: {a} ~ {b} along {along};"),
            Self::Rod(a, b, length) => format!("rod r{i}: {a} ~ {b} length {length};"),
            Self::Gear(a, b, ratio, offset) => format!("gear r{i}: b{a} ~ b{b} ratio {ratio}, offset {offset};"),
            Self::Drive(body, angle, amplitude, omega) => {
                format!("drive r{i}: b{body}.phi = {angle} + {amplitude} * sin({omega} * t);")
            }
            Self::Track(body, height, bend) => {
                format!("constraint r{i}: b{body}.y = {height} + {bend} * b{body}.x^2;")
            }
            Self::Skate(at, along) => format!("skate r{i}: at {at} along {along};"),
            Self::Roll(at, along, radius, wheel) => {
                format!("roll r{i}: at {at} along {along} = {radius} * b{wheel}.omega;")
            }
            Self::Twist(body, slope, speed) => {
                let b = format!("b{body}");
                format!("velocity constraint r{i}: {b}.vy = {slope} * {b}.x * {b}.omega + {speed} * cos(t);")
            }
        }
    }
}

impl Force {
    fn text(&self) -> String {
        let couple = |body: &usize, other: &Option<usize>| format!("b{body} ~ {}", name(*other));
        let limited = |limit: &Option<Value>| limit.as_ref().map(|f| format!(", limit {f}")).unwrap_or_default();
        let damped = |damping: &Option<Value>| damping.as_ref().map(|c| format!(", damping {c}")).unwrap_or_default();
        match self {
            Self::Gravity(x, y) => format!("gravity ({x}, {y});"),
            Self::Vector(at, law, k) => {
                let body = name(at.body);
                format!("force at {at}: ({law}, -{k} * {body}.y);")
            }
            Self::Along(at, along, law) => format!("force at {at} along {along}: {law};"),
            Self::Across(at, along, law) => format!("force at {at} across {along}: {law};"),
            Self::Torque(body, None, law) => format!("torque b{body}: {law};"),
            Self::Torque(body, other, law) => format!("torque {}: {law};", couple(body, other)),
            Self::Spring(a, b, k, l, c) => format!("spring {a} ~ {b}: stiffness {k}, length {l}{};", damped(c)),
            Self::Damper(a, b, c) => format!("damper {a} ~ {b}: damping {c};"),
            Self::Torsion(body, other, k, angle, c) => {
                format!("torsion {}: stiffness {k}, angle {angle}{};", couple(body, other), damped(c))
            }
            Self::Drag(at, k1, k2, k3) => format!("drag at {at}: linear {k1}, quadratic {k2}, angular {k3};"),
            Self::Friction(at, force, speed) => format!("friction at {at}: force {force}, speed {speed};"),
            Self::FrictionAlong(at, along, force, speed) => {
                format!("friction at {at} along {along}: force {force}, speed {speed};")
            }
            Self::FrictionCouple(body, other, torque, rate) => {
                format!("friction {}: torque {torque}, rate {rate};", couple(body, other))
            }
            Self::Tyre(at, along, c, limit, speed) => {
                format!("tyre at {at} along {along}: stiffness {c}{}, speed {speed};", limited(limit))
            }
            Self::FrictionOnTread(at, along, force, speed, radius, wheel) => {
                format!(
                    "friction at {at} along {along}: force {force}, speed {speed}, tread {radius} * b{wheel}.omega;"
                )
            }
            Self::TyreWithTread(at, along, c, limit, speed, radius, wheel) => {
                let limit = limited(limit);
                format!(
                    "tyre at {at} along {along}: stiffness {c}{limit}, speed {speed}, tread {radius} * b{wheel}.omega;"
                )
            }
        }
    }
}

impl Mechanism {
    /// The model file, without `model!`.
    pub fn text(&self, name: &str) -> String {
        let mut text = format!("pub model {name} {{\n");
        let mut line = |words: String| writeln!(text, "    {words}").expect("a string takes text");
        for p in &self.parameters {
            line(format!("param {} = {:?};", p.text, p.number));
        }
        for (i, [mass, inertia]) in self.bodies.iter().enumerate() {
            line(format!("body b{i} {{ mass: {mass}, inertia: {inertia} }}"));
        }
        self.rows.iter().enumerate().for_each(|(i, row)| line(row.text(i)));
        self.forces.iter().for_each(|force| line(force.text()));
        let values = self.assembled.chunks_exact(3).enumerate().map(|(i, q)| {
            let [x, y, angle] = [q[0], q[1], q[2]].map(Value::number);
            format!("b{i} at ({x}, {y}) angle {angle};")
        });
        line(format!("start assembled {{ {} at rest; }}", values.collect::<Vec<_>>().join(" ")));
        line("scene run { start assembled; until 0.2 s; }".to_owned());
        text + "}\n"
    }
}

fn name(body: Option<usize>) -> String {
    body.map_or("ground".to_owned(), |body| format!("b{body}"))
}

impl std::fmt::Display for Value {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.text)
    }
}

impl std::fmt::Display for Place {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}({}, {})", name(self.body), self.x, self.y)
    }
}

impl std::fmt::Display for Direction {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "b{}({}, {})", self.body, self.x, self.y)
    }
}

impl std::fmt::Display for Law {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Cosine(amplitude, omega) => write!(f, "{amplitude} * cos({omega} * t)"),
            Self::Damping(k, body) => write!(f, "-{k} * b{body}.omega * abs(b{body}.vx)"),
            Self::Position(k, body) => write!(f, "{k} * sin(b{body}.phi) * b{body}.x"),
        }
    }
}
