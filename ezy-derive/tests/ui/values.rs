//! Faults of values: numbers of arguments, scalars and vectors, units, what must not move.

ezy_core::model! {
    pub model EzyRoller {
        param a: m = 0.2;
        param k: N*s/m = 0.5;
        param m0: N = 2.0;
        body seat { mass: -46.0, inertia: 10.0 * t }
        body bar { mass: a, inertia: 0.005 }
        point A = seat(-a * cos(seat.phi), 0);
        let u = v;
        let v = 2 * u;
        effect pump { torque seat ~ bar: m0 * cos(3 * t); }
        effect resistance { force at bar(a, 0): -k * norm(bar.v, 2); }
        effect drag { force at bar(a, 0): -k; }
        effect push { force at bar(a + bar.phi, 0): (1, bar.v); }
        effect twist { torque bar: a + seat.phi; }
        effect belt { friction at bar(a, 0) along bar(1, 0): force 2, speed 0.1, tread seat.omega; }
        effect track { friction at bar(a, 0): force 2, speed 0.1, tread a * seat.omega; }
        effect wheel { tyre at bar(a, 0) along bar(1, 0): stiffness 90, tread seat.r; }
        start folded { seat at (0, 0) angle 0; }
        scene driven { start folded; until 60 s; with pump, resistance, drag, push, twist, belt, wheel; }
    }
}

fn main() {}

// stands for ezy-core, which these tests do without
extern crate self as ezy_core;
#[macro_export]
macro_rules! model {
    ($($model:tt)*) => { ezy_derive::model! { $crate $($model)* } };
}
#[macro_export]
macro_rules! faulty_model {
    ($($model:tt)*) => {};
}
pub mod __private {
    pub use crate::faulty_model;
}
