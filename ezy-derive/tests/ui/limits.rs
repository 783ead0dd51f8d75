//! Limits of skates: a force, and one skate of a scene at most that has one.

ezy_core::model! {
    pub model Written {
        param mu: 1 = 0.5;
        body sled { mass: 1, inertia: 1 }
        skate none: at sled(0, 0) along sled(1, 0) limit;
        skate word: at sled(0, 0) along sled(1, 0) max 3;
        skate comma: at sled(0, 0) along sled(1, 0), limit 3;
        skate colon: at sled(0, 0) along sled(1, 0): limit 3;
        skate open: at sled(0, 0) along sled(1, 0)
        skate twice: at sled(0, 0) along sled(1, 0) limit 3, limit 4;
        roll wheel: at sled(0, 0) along sled(1, 0) = 0 limit 3;
        skate ratio: at sled(0, 0) along sled(1, 0) limit mu;
        skate pulls: at sled(0, 0) along sled(1, 0) limit -3;
        skate vector: at sled(0, 0) along sled(1, 0) limit (0, 3);
        start s { at rest; }
        scene run { start s; until 1 s; }
    }
}

ezy_core::model! {
    pub model Many {
        count n = 3;
        body sled[n] { mass: 1, inertia: 1 }
        for i in 0..n { skate blade[i]: at sled[i](0, 0) along sled[i](1, 0) limit 3; }
        start s { at rest; }
        scene run { start s; until 1 s; }
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
