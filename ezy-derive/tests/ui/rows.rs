//! Faults that only the equations show.

ezy_core::model! {
    pub model NotLinear {
        body one { mass: 1, inertia: 1 }
        velocity constraint fast: one.vx * one.vy = 0;
        start s { at rest; }
        scene run { start s; until 1 s; }
    }
}

ezy_core::model! {
    pub model Nothing {
        param w: rad/s = 1.0;
        body one { mass: 1, inertia: 1 }
        constraint empty: 0 * one.x = 0;
        drive clock: w * t = 1;
        velocity constraint still: one.vx - one.vx = 0;
        start s { at rest; }
        scene run { start s; until 1 s; }
    }
}

ezy_core::model! {
    pub model Repeated {
        body one { mass: 1, inertia: 1 }
        body two { mass: 1, inertia: 1 }
        weld both: one(1, 0) ~ two(0, 0);
        gear again: one ~ two ratio 1;
        effect locked { rod third: one(0, 0) ~ two(1, 0) length 2; }
        start s { at rest; }
        scene free { start s; until 1 s; }
        scene run { start s; until 1 s; with locked; }
    }
}

ezy_core::model! {
    pub model TooMuch {
        body one { mass: 1, inertia: 1 }
        hinge pin: ground(0, 0) ~ one(-1, 0);
        start aside { one at (3, 0) angle 0; at rest; }
        start along { one at (1, 0) angle 0; }
        scene run { start aside; until 1 s; }
        scene good { start along; until 1 s; }
    }
}

ezy_core::model! {
    pub model Released {
        body one { mass: 1, inertia: 1 }
        skate edge: at one(0, 0) along one(1, 0);
        effect slip { release edge; }
        effect skid { release edge; }
        start s { at rest; }
        scene run { start s; until 1 s; with slip, skid; }
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
