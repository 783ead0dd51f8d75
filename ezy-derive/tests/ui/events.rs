//! Events, and what ends a scene: conditions that pass from one side to the other; a time is the latest end.

ezy_core::model! {
    pub model Signs {
        body ball { mass: 1, inertia: 1 }
        event landing: ball.y;
        event low: ball.y <= 0;
        event level: ball.y == 0;
        event beside: ball.y != 0;
        event between: 0 < ball.y < 1;
        event both: ball.y < 0 && ball.vy < 0;
        start s { at rest; }
        scene fall { start s; until ball.y >= 1; until 1 s; }
    }
}

ezy_core::model! {
    pub model Throw {
        param h: m = 1.0;
        body ball { mass: 1, inertia: 1 }
        point P = ball(0, h);
        event landing: ball.y < 0;
        event never: h < 2;
        event unlike: ball.y > ball.phi;
        event place: P.r = 0;
        event landing: ball.y < h;
        effect wind { force at P: (1, 0); event gone: ball.x > 3; }
        output down: m = landing;
        start s { at rest; }
        scene flight { start s; until 2 s; until landin; }
        scene blown { start s; until 2 s; until gone; until ball; until ball.v > 3; }
        scene lasting { start s; until ball.y < 0; }
        scene short { start s; until 2 s; until 3 s; }
        scene bare { start s; until 2; }
        scene long { start s; until 2 m; }
        scene turning { start s; until h s; }
    }
}

ezy_core::model! {
    pub model Row {
        count n = 3;
        body ball[n] { mass: 1, inertia: 1 }
        for i in 0..n { event landing: ball[i].y < 0; }
        start s { at rest; }
        scene fall { start s; until 1 s; }
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
