//! The EzyRoller written without what a scene of it leaves out: one model file for each scene.
//!
//! A scene of the EzyRoller must be what the model written for it alone is.

use ezy_core::model;

model! {
    /// Neither effects nor their parameters.
    pub model Coasting {
        param a: m = 0.2;
        param b: m = 0.6;
        param c: m = 0.1;
        param d: m = 0.1;
        param m1: kg = 46.0;
        param i1: kg*m^2 = 10.0;
        param m2: kg = 1.0;
        param i2: kg*m^2 = 0.005;
        body seat { mass: m1, inertia: i1 }
        body bar { mass: m2, inertia: i2 }
        point A = seat(-a, 0);
        point C = bar(c, 0);
        hinge B: seat(b, 0) ~ bar(-d, 0);
        skate rear: at A along seat(1, 0);
        skate front: at C along bar(1, 0);
        start cross { seat at (a, 0) angle 0; bar angle pi/2; seat velocity (1, _) rate 0; }
        scene coast { start cross; until 1 s; }
    }
}

model! {
    /// With the rider's torque alone.
    pub model Pumped {
        param a: m = 0.2;
        param b: m = 0.6;
        param c: m = 0.1;
        param d: m = 0.1;
        param m1: kg = 46.0;
        param i1: kg*m^2 = 10.0;
        param m2: kg = 1.0;
        param i2: kg*m^2 = 0.005;
        param m0: N*m = 2.0;
        param omega: rad/s = pi;
        body seat { mass: m1, inertia: i1 }
        body bar { mass: m2, inertia: i2 }
        point A = seat(-a, 0);
        point C = bar(c, 0);
        hinge B: seat(b, 0) ~ bar(-d, 0);
        skate rear: at A along seat(1, 0);
        skate front: at C along bar(1, 0);
        torque seat ~ bar: m0 * cos(omega * t);
        start folded { seat at (0, 0) angle 0; bar angle pi; at rest; }
        scene driven { start folded; until 60 s; }
    }
}

model! {
    /// A tyre in place of the rear skate: nothing is there to be released.
    pub model Drifting {
        param a: m = 0.2;
        param b: m = 0.6;
        param c: m = 0.1;
        param d: m = 0.1;
        param m1: kg = 46.0;
        param i1: kg*m^2 = 10.0;
        param m2: kg = 1.0;
        param i2: kg*m^2 = 0.005;
        param m0: N*m = 2.0;
        param omega: rad/s = pi;
        param k: N*s/m = 0.5;
        param cornering: N/rad = 400.0;
        param creep: m/s = 0.1;
        body seat { mass: m1, inertia: i1 }
        body bar { mass: m2, inertia: i2 }
        point A = seat(-a, 0);
        point C = bar(c, 0);
        hinge B: seat(b, 0) ~ bar(-d, 0);
        skate front: at C along bar(1, 0);
        effect pump { torque seat ~ bar: m0 * cos(omega * t); }
        effect rolling_resistance { force at A: -k * A.v; }
        effect slip { tyre at A along seat(1, 0): stiffness cornering, speed creep; }
        start folded { seat at (0, 0) angle 0; bar angle pi; at rest; }
        scene drift { start folded; until 60 s; with pump, rolling_resistance, slip; }
    }
}
