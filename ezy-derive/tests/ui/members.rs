//! Faults of arrays whose members differ.

ezy_core::model! {
    pub model Chain {
        count n = 5;
        count m = 2;
        param l: m = 1.0;
        param mass0: kg = 1.0;
        body link[n] { mass: mass0 * (1 - i/(2*n)), inertia: 0.1 }
        body node[n, m] { mass: mass0 * (1 + j), inertia: 0.1 }
        body rod[n] { mass: mas0, inertia: 0.1 }
        body bead[b] { mass: mass0 * b, inertia: 0.1 * b }
        for i in 0..n { body ring[j] { mass: mass0 * i, inertia: 0.1 * i } }
        for i in 0..n { body disc { mass: mass0 * i, inertia: 0.1 } }
        for i in 1..n { body bar[i] { mass: mass0 * i, inertia: 0.1 } }
        for i in 0..n { for j in 0..i { body row[i, j] { mass: mass0 * j, inertia: 0.1 } } }
        for i in 0..n { body wheel[i] { mass: l * i, inertia: 0.1 * k } }
        for i in 0..n { body foot[i] { mass: mass0 * (1 + link[i].x), inertia: 0.1 } }
        for i in 0..n { effect e { torque link[i]: 1; } }
        hinge pin: ground(i, 0) ~ link[0](0, 0);
        for i in 0..n { spring ground(i, 0) ~ wheel[i+1](l*i/n, 0): stiffness 1; }
        start level { at rest; }
        scene swing { start level; until 1 s; }
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
