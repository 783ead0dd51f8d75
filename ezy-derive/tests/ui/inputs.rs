//! Inputs and outputs: an input is set while a scene runs, so rows cannot follow it and nothing fixed can depend on it.

ezy_core::model! {
    pub model EzyRoller {
        param m1: kg = 46.0;
        input torque: N*m = 0.0;
        input gap: m = 0.1;
        input shift: m = m1;
        input reach: m = 0.3 by acceleration;
        input tilt: rad = 0 by rate;
        body seat { mass: m1, inertia: 10.0 * gap }
        body bar { mass: 1.0, inertia: 0.005 }
        point A = seat(-gap, 0);
        rod strut: seat(0.6, 0) ~ bar(-0.1, 0) length gap;
        drive steering: bar.phi - seat.phi = atan2(gap, 1);
        rod brace: seat(0.6, 0) ~ bar(0.1, 0) length reach + reach_acceleration;
        rod stay: seat(0.5, 0) ~ bar(0.1, 0) length reach_rate;
        output speed: m = norm(seat.v);
        effect rider { torque seat ~ bar: torque * seat.omega; force at bar(0, 0): (speed, 0); }
        start folded { seat at (gap, 0) angle 0; }
        scene ridden { start folded; until 60 s; with rider; }
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
