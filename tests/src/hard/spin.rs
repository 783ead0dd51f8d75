//! Bodies that turn at 10,000 rad/s.

use ezy_core::model;

model! {
    /// An unbalanced rotor on a bearing.
    pub model Rotor {
        param m: kg = 1.0;
        param i: kg*m^2 = 0.01;
        /// bearing, beside the centre of mass
        param r: m = 0.05;
        body rotor { mass: m, inertia: i }
        hinge bearing: ground(0, 0) ~ rotor(0, r);
        gravity (0, -9.81);
        start hanging { rotor angle 0 rate 1e4; }
        scene spin { start hanging; until 1 s; }
    }
}

model! {
    /// Two bodies thrown together, spinning against each other.
    pub model SpinningPair {
        param m1: kg = 2.0;
        param i1: kg*m^2 = 0.03;
        param m2: kg = 1.0;
        param i2: kg*m^2 = 0.02;
        /// hinge, beside the centre of mass of the first
        param r: m = 0.4;
        body first { mass: m1, inertia: i1 }
        body second { mass: m2, inertia: i2 }
        hinge pin: first(r, 0) ~ second(0, 0);
        gravity (0, -9.81);
        start thrown { first at (0, 0) angle 0 velocity (1.5, 4) rate 1e4; second angle 0 rate -1e4; }
        scene flight { start thrown; until 1 s; }
    }
}
