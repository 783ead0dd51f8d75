//! Stops: they bound positions, and a scene has one of them at most.

ezy_core::model! {
    pub model Written {
        body ball { mass: 1, inertia: 1 }
        stop wall: ball.x;
        stop floor: ball.y >= 0;
        stop turned: ball.x to 1 from 0;
        stop comma: ball.x from 0, restitution 0.5;
        stop elastic: ball.x from 0 restitution;
        stop hard: ball.x from 0 resitution 0.5;
        start s { at rest; }
        scene run { start s; until 1 s; }
    }
}

ezy_core::model! {
    pub model Bounded {
        param k: m = 1.0;
        input u: m = 1.0;
        body ball { mass: 1, inertia: 1 }
        stop none: k from 0;
        stop clock: t to 3;
        stop speed: ball.vx to 1;
        stop set: ball.x from u;
        stop place: ball.r to 1;
        stop unlike: ball.x from 0 to ball.phi;
        stop gains: ball.x from 0 restitution 1.5;
        stop ratio: ball.x from 0 restitution k;
        output o = gains;
        event e: gains.rate > 0;
        effect free { release gains; }
        effect stops { force at ball(0, 0): (1, 0); }
        start s { at rest; }
        scene run { start s; until 1 s; }
    }
}

ezy_core::model! {
    pub model Two {
        body ball { mass: 1, inertia: 1 }
        stop floor: ball.y from 0;
        effect wall { stop wall: ball.x from 0; }
        start s { at rest; }
        scene free { start s; until 1 s; }
        scene walled { start s; until 1 s; with wall; }
    }
}

ezy_core::model! {
    pub model Many {
        count n = 3;
        body ball[n] { mass: 1, inertia: 1 }
        stop floor: ball[0].y from 0;
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
