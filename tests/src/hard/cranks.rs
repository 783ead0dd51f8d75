//! Parallel cranks under one coupler: every crank after the second repeats what the others demand.

use ezy_core::model;

model! {
    /// A coupler on n equal cranks, a metre apart.
    pub model ParallelCranks {
        count n = 5;
        param l: m = 1.0;
        /// of each crank; the motion depends on the sum alone
        param m: kg = 3.0;
        param m_coupler: kg = 10.0;
        param i_coupler: kg*m^2 = 0.7;
        /// pin of the first crank, behind the coupler's centre of mass
        param behind: m = 1.3;
        body coupler { mass: m_coupler, inertia: i_coupler }
        body crank[n] { mass: m, inertia: m*l^2/12 }
        for i in 0..n {
            hinge foot[i]: ground(i, 0) ~ crank[i](-l/2, 0);
            hinge head[i]: crank[i](l/2, 0) ~ coupler(i - behind, 0);
        }
        gravity (0, -9.81);
        start aside { coupler near angle 0; for i in 0..n { crank[i] angle 1; } at rest; }
        scene fall { start aside; until 10 s; }
    }
}
