//! Several skates on one body: rows that repeat each other, or lock it.

// the rows that repeat others are the case
#![allow(deprecated)]

use ezy_core::model;

model! {
    /// A sleigh on two wheels of one axle: the second row repeats the first.
    pub model Coaxial {
        param m: kg = 2.0;
        param i: kg*m^2 = 0.5;
        /// axle, behind the centre of mass
        param a: m = 0.3;
        /// wheels, beside the middle
        param w: m = 0.25;
        /// how far the right wheel toes in
        param toe: rad = 0.0;
        body sleigh { mass: m, inertia: i }
        skate left: at sleigh(-a, w) along sleigh(1, 0);
        skate right: at sleigh(-a, -w) along sleigh(cos(toe), sin(toe));
        start turning { sleigh at (a, 0) angle 0 velocity (1, _) rate 1; }
        scene coast { start turning; until 5 s; }
    }
}

model! {
    /// A body on three skates in any places.
    pub model ThreeSkates {
        param m: kg = 3.0;
        param i: kg*m^2 = 0.4;
        param x1: m = 1.0;
        param y1: m = 0.0;
        param h1: rad = 0.0;
        param x2: m = -0.8;
        param y2: m = 0.3;
        param h2: rad = 0.0;
        param x3: m = 0.1;
        param y3: m = -0.6;
        param h3: rad = 0.0;
        body plate { mass: m, inertia: i }
        skate first: at plate(x1, y1) along plate(cos(h1), sin(h1));
        skate second: at plate(x2, y2) along plate(cos(h2), sin(h2));
        skate third: at plate(x3, y3) along plate(cos(h3), sin(h3));
        /// A steady force at the centre of mass.
        effect push {
            param fx: N = 5.0;
            param fy: N = 2.0;
            force at plate(0, 0): (fx, fy);
        }
        start here { plate at (0, 0) angle 0; at rest; }
        scene free { start here; until 10 s; }
        scene pushed { start here; until 10 s; with push; }
    }
}
