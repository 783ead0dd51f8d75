//! Models that are hard on purpose: mass ratios, stiff springs, fast spin, rows that repeat each other.

// the rows that repeat others are the case
#![allow(deprecated)]

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

model! {
    /// A pendulum whose rod is a spring, with or without a damper.
    pub model SpringPendulum {
        param m: kg = 1.0;
        param i: kg*m^2 = 1.0;
        param k: N/m = 1e9;
        param l: m = 1.0;
        param c: N*s/m = 0.0;
        body bob { mass: m, inertia: i }
        spring ground(0, 0) ~ bob(0, 0): stiffness k, length l, damping c;
        gravity (0, -9.81);
        start level { bob at (l, 0) angle 0; at rest; }
        scene swing { start level; until 1 s; }
    }
}

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

model! {
    /// A coupler on five equally long cranks, a metre apart, each a kilogram heavier than the one before.
    pub model FiveCranks {
        param l: m = 1.0;
        param m: kg = 1.0;
        param m_coupler: kg = 10.0;
        param i_coupler: kg*m^2 = 0.7;
        /// pin of the first crank, behind the coupler's centre of mass
        param behind: m = 1.3;
        body coupler { mass: m_coupler, inertia: i_coupler }
        body c0 { mass: m, inertia: m*l^2/12 }
        body c1 { mass: 2*m, inertia: 2*m*l^2/12 }
        body c2 { mass: 3*m, inertia: 3*m*l^2/12 }
        body c3 { mass: 4*m, inertia: 4*m*l^2/12 }
        body c4 { mass: 5*m, inertia: 5*m*l^2/12 }
        hinge foot0: ground(0, 0) ~ c0(-l/2, 0);
        hinge head0: c0(l/2, 0) ~ coupler(-behind, 0);
        hinge foot1: ground(1, 0) ~ c1(-l/2, 0);
        hinge head1: c1(l/2, 0) ~ coupler(1 - behind, 0);
        hinge foot2: ground(2, 0) ~ c2(-l/2, 0);
        hinge head2: c2(l/2, 0) ~ coupler(2 - behind, 0);
        hinge foot3: ground(3, 0) ~ c3(-l/2, 0);
        hinge head3: c3(l/2, 0) ~ coupler(3 - behind, 0);
        hinge foot4: ground(4, 0) ~ c4(-l/2, 0);
        hinge head4: c4(l/2, 0) ~ coupler(4 - behind, 0);
        gravity (0, -9.81);
        start aside { c0 angle 1; c1 near angle 1; c2 near angle 1; c3 near angle 1; c4 near angle 1; at rest; }
        scene fall { start aside; until 10 s; }
    }
}
