//! A slider-crank whose slider is a body of its own, led by two points.

use ezy_core::model;

model! {
    /// Crank and rod are uniform; where they are equally long the slider reaches the crank's bearing.
    pub model SlidingBlock {
        param l1: m = 1.0;
        param l2: m = 1.0;
        param m1: kg = 1.0;
        param m2: kg = 1.0;
        param m3: kg = 2.0;
        param i3: kg*m^2 = 0.1;
        /// half the length of the slider
        param s: m = 0.1;
        body crank { mass: m1, inertia: m1*l1^2/12 }
        body rod { mass: m2, inertia: m2*l2^2/12 }
        body slider { mass: m3, inertia: i3 }
        hinge bearing: ground(0, 0) ~ crank(-l1/2, 0);
        hinge pin: crank(l1/2, 0) ~ rod(-l2/2, 0);
        hinge wrist: rod(l2/2, 0) ~ slider(0, 0);
        slot rear: ground(0, 0) ~ slider(-s, 0) along ground(1, 0);
        slot front: ground(0, 0) ~ slider(s, 0) along ground(1, 0);
        gravity (0, -9.81);
        start turning { crank angle 1 rate 4; rod near angle -1; slider near angle 0; }
        scene falling { start turning; until 3 s; }
    }
}
