//! Faults of syntax: each is reported, on its own token.

ezy_core::model! {
    pub model EzyRoller {
        param a: m 0.2;
        param b: m = 2**3;
        body seat { mass: 46.0, inertia: }
        body bar { mass: 1.0, inertia: 0.005 }
        spring s: seat ~ bar;
        hinge B: seat(b, 0) ~ bar(-1);
        skate rear: at A across seat(1, 0);
        effect pump { torque seat bar: 2 * cos(t); }
        start folded { seat at (0, 0) angel 0; at rest; }
        scene driven { start folded; until 60; with pump; }
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
