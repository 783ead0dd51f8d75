//! A chain of three rods of any masses and lengths, hung from a pin: mass ratios, and a middle rod without mass.

use ezy_core::model;

model! {
    /// Rods hinged at their ends, centres of mass in their middles.
    pub model ThreeRods {
        param l1: m = 1.0;
        param l2: m = 1.0;
        param l3: m = 1.0;
        param m1: kg = 1.0;
        param m2: kg = 1.0;
        param m3: kg = 1.0;
        param i1: kg*m^2 = 0.1;
        param i2: kg*m^2 = 0.1;
        param i3: kg*m^2 = 0.1;
        body r1 { mass: m1, inertia: i1 }
        body r2 { mass: m2, inertia: i2 }
        body r3 { mass: m3, inertia: i3 }
        hinge top: ground(0, 0) ~ r1(-l1/2, 0);
        hinge upper: r1(l1/2, 0) ~ r2(-l2/2, 0);
        hinge lower: r2(l2/2, 0) ~ r3(-l3/2, 0);
        gravity (0, -9.81);
        start level { r1 angle 0; r2 angle 0; r3 angle 0; at rest; }
        scene swing { start level; until 2 s; }
    }
}
