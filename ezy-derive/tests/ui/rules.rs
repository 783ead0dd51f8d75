//! Faults across items: what joins, what is given, what a scene needs.

ezy_core::model! {
    pub model EzyRoller {
        body seat { mass: 46.0, inertia: 10.0 }
        body bar { mass: 1.0, inertia: 0.005 }
        body ball { mass: 0, inertia: 1 }
        point A = seat(-0.2, 0);
        hinge B: seat(0.6, 0) ~ A;
        skate rear: at A along seat(0, 0);
        skate front: at ground(1, 0) along bar(1, 0);
        effect pump { torque seat ~ seat: 2 * cos(3 * t); }
        start folded { seat at (0, 0) x 1 velocity (1, 0); at rest; }
        scene coast { until 1 m; }
        scene driven { start folded; with pump, pump; }
        scene a_b { start folded; until 0 s; }
        scene aB { start folded; until 1 s; }
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
