//! Mechanisms for the tests of this layer, and tests of its functions.

use super::moves_finitely;

crate::model! {
    /// A four-bar linkage with a coupler of 3 m.
    pub model Linkage {
        body crank { mass: 1, inertia: 0.1 }
        body coupler { mass: 1, inertia: 1 }
        body rocker { mass: 1, inertia: 0.5 }
        hinge A: ground(0, 0) ~ crank(0, 0);
        hinge B: crank(1, 0) ~ coupler(-1.5, 0);
        hinge C: coupler(1.5, 0) ~ rocker(2, 0);
        hinge D: ground(3, 0) ~ rocker(0, 0);
        start turning { crank angle 1 rate 1; coupler near angle 0.3; rocker near angle 1.5; }
        scene turns { start turning; until 1 s; }
    }
}

crate::model! {
    /// Rods in a row.
    pub model Row {
        count n = 20;
        body rods[n] { mass: 1, inertia: 1/12 }
        hinge top: ground(0, 0) ~ rods[0](-0.5 m, 0);
        for i in 1..n {
            hinge pins[i]: rods[i-1](0.5 m, 0) ~ rods[i](-0.5 m, 0);
        }
        start level { for i in 0..n { rods[i] angle 0; } at rest; }
        scene swings { start level; until 1 s; }
    }
}

/// One number that is not finite is seen at each place, among those that are taken four at a time and behind them; so is an energy that overflows.
#[test]
fn invariant_a_number_that_is_not_finite_is_seen_at_each_place() {
    for n in 1..10 {
        let (mass, zeros) = (vec![2.0; n], vec![0.0; n]);
        assert!(moves_finitely(&mass, &vec![f64::MAX; n], &vec![1e150; n]));
        for (i, bad) in (0..n).flat_map(|i| [f64::NAN, f64::INFINITY, f64::NEG_INFINITY].map(|bad| (i, bad))) {
            let mut x = vec![1.0; n];
            x[i] = bad;
            assert!(!moves_finitely(&mass, &x, &zeros) && !moves_finitely(&mass, &zeros, &x), "{n} {i} {bad}");
            x[i] = 1e160;
            assert!(moves_finitely(&mass, &x, &zeros) && !moves_finitely(&mass, &zeros, &x), "{n} {i}");
        }
    }
}
