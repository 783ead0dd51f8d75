//! Derivatives that are too long: rows and stops are differentiated twice, and nested quotients multiply.

ezy_core::model! {
    pub model Nested {
        param a: m = 1.0;
        param b: m = 2.0;
        body one { mass: 1, inertia: 1 }
        body two { mass: 1, inertia: 1 }
        point P = one(a, b);
        point Q = two(b, a);
        constraint g: norm(P.r) / (2 + smooth_step(norm(P.r), 1, norm(Q.r))) = a;
        stop h: norm(P.r) / (2 + smooth_step(norm(P.r), 1, norm(Q.r))) to a;
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
