//! Parallel cranks under one coupler: every crank after the second repeats what the others demand.

// the rows that repeat others are the case
#![allow(deprecated)]

use ezy_core::model;

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
