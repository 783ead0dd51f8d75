//! Faults of repeating: counts, arrays and `for`.

ezy_core::model! {
    pub model Chain {
        count n = 2.5;
        param l: m = 1.0;
        body link[4] { mass: 1.0, inertia: 0.1 }
        body hub { mass: 1.0, inertia: 0.1 }
        hinge top: ground(0, 0) ~ link(-l/2, 0);
        for i in 0..4 { hinge pin[i]: link[i-1](l/2, 0) ~ link[i](-l/2, 0); }
        for i in 1..4 { hinge hook: hub(0, 0) ~ link[i](0, l); }
        for l in 0..4 { torque link[l]: 0.1; }
        torque hub[0]: 0.1;
        torque link[m]: 0.1;
        torque link[1, 2]: 0.1;
        output bend: rad = pin[2];
        start level { for i in 0..4 { link[i] angle 0.1*i; } link[4] rate 1; }
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
