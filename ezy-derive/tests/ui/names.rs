//! Faults of names: unknown ones with the nearest known, names declared twice with both places.

ezy_core::model! {
    pub model EzyRoller {
        param a: m = 0.2;
        param b: metre = 0.6;
        param t: s = 1;
        body seat { mass: 46.0, inertia: 10.0 }
        body bar { mass: 1.0, inertia: 0.005 }
        point A = seat(-a, 0);
        point a = bar(0, 0);
        hinge B: seat(b, 0) ~ baar(-0.1, 0);
        skate rear: at C along seat(1, 0);
        effect pump { torque seat ~ bar: m0 * cosine(t) * seat.z; }
        start folded { sead at (0, 0); }
        scene driven { start foldet; until 60 s; with pump, pmp; }
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
