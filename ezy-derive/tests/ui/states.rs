//! First-order states: each needs the equation of its rate, and no constraint can depend on one.

ezy_core::model! {
    pub model Motor {
        param u: V = 12.0;
        param R: ohm = 0.5;
        param L: mH = 2.0;
        param k: N*m/A = 0.05;
        state lost: J = 0;
        state start_up: A = u/R rate 0;
        state current: A = 0 rate (u - R*current - k*wheel.omega)/L;
        state heat: J = 0 rate R*current;
        state way: m = 0 rate wheel.v;
        state turned: rad = 0 rate weel.omega;
        body wheel { mass: 1.0 * current, inertia: 2e-3 }
        hinge axle: ground(0, 0) ~ wheel(0, 0);
        drive forced: wheel.phi = turned;
        torque wheel: current;
        for i in 0..3 { state each: m = 0 rate 1; }
        start standing { at rest; }
        scene spun_up { start standing; until 2 s; }
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
