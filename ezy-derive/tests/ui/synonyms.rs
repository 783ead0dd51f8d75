//! Words of other languages and books: the message leads to that of this one.

ezy_core::model! {
    pub model Machine {
        constant a: m = 0.2;
        body arm { mass: 1, inertia: 1 }
        revolute A: world(0, 0) ~ arm(a, 0);
        prismatic B: ground(0, 0) ~ arm(0, 0) along ground(1, 0);
        motor C: arm.phi = t;
        wheel D: at arm(0, 0) along arm(1, 0);
        hinge E: world(0, 0) ~ arm(0, 0);
        constraint F: arm.theta == arm.y_dot;
        constraint G: arm.theta = arm.y_dot;
        effect push { moment arm: if t < 1 { 2 } else { 0 }; dashpot arm(0, 0) ~ ground(0, 0): damping 1; }
        contact H: arm.y from 0;
        rope I: ground(0, 0) ~ arm(0, 0) length 1;
        state J: m = 0 rate arm.x;
        output K: N = lambda.E.y;
        output L: m/s^2 = arm.ax;
        output M: m/s = der(arm.x);
        output N: m = arm.x > 0 ? 1 : 2;
        start here { arm at (0, 0) theta 0; }
        spring arm(0, 0) ~ ground(0, 0): stiffness = 40;
        scene runs { start here; until 1 s; with push; }
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
