//! Rows that cannot hold together with others.

ezy_core::model! {
    pub model EzyRoller {
        body seat { mass: 46.0, inertia: 10.0 }
        body bar { mass: 1.0, inertia: 0.005 }
        hinge B: seat(0.6, 0) ~ bar(-0.1, 0);
        skate rear_left: at seat(-0.2, 0.3) along seat(1, 0);
        skate rear_right: at seat(-0.2, -0.3) along seat(1, 0);
        start folded { at rest; }
        scene coast { start folded; until 1 s; }
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
