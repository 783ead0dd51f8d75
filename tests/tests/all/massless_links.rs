//! Links that are mere distances: massless, without inertia, between bodies that have both.

use ezy_core::prelude::*;
use ezy_core_tests::simulation;

ezy_core::model! {
    /// `massless_coupler` of `torture.json`.
    pub model PureCoupler {
        body crank { mass: 1, inertia: 1/12 }
        body coupler { mass: 0, inertia: 0 }
        body rocker { mass: 2, inertia: 0.375 }
        hinge A: ground(0, 0) ~ crank(-0.5, 0);
        hinge B: crank(0.5, 0) ~ coupler(-1, 0);
        hinge C: coupler(1, 0) ~ rocker(0.75, 0);
        hinge D: ground(2, 0) ~ rocker(-0.75, 0);
        gravity (0, -9.81);
        start bent { crank angle 1.2; coupler near angle 0.2734; rocker near angle 1.3776; at rest; }
        scene swing { start bent; until 1 s; }
    }
}

ezy_core::model! {
    /// `massless_middle_link` of `torture.json`.
    model PureMiddle {
        body upper { mass: 1, inertia: 0.1 }
        body link { mass: 0, inertia: 0 }
        body lower { mass: 2, inertia: 0.2 }
        hinge A: ground(0, 0) ~ upper(-0.5, 0);
        hinge B: upper(0.5, 0) ~ link(-0.25, 0);
        hinge C: link(0.25, 0) ~ lower(-0.5, 0);
        gravity (0, -9.81);
        start bent { upper angle 0.2; link angle -0.4; lower angle 0.5; at rest; }
        scene swing { start bent; until 1 s; }
    }
}

ezy_core::model! {
    /// A link on one hinge alone: nothing turns it.
    model Dangling {
        body rod { mass: 1, inertia: 0.1 }
        body tail { mass: 0, inertia: 0 }
        hinge A: ground(0, 0) ~ rod(-0.5, 0);
        hinge B: rod(0.5, 0) ~ tail(-0.25, 0);
        gravity (0, -9.81);
        start bent { rod angle 0.2; tail angle -0.4; at rest; }
        scene swing { start bent; until 1 s; }
    }
}

/// The bound of `torture.json`, fifty times what the methods leave here.
const STATES: f64 = 1e-9;

fn assert_angles<S: Scene>(scene: &S, angles: &[f64]) {
    for method in [Method::dop853(1e-11), Method::taylor(1e-12), Method::gauss(1e-12), Method::radau(1e-12)] {
        let run = simulation(scene).method(method).run().unwrap();
        assert!(run.outcome.reached_end(), "{}: {}", method.name(), run.outcome);
        let q = run.last().coordinates;
        let found: Vec<f64> = q.iter().skip(2).step_by(3).copied().collect();
        let error = crate::scenes::distance(&found, angles);
        assert!(error <= STATES, "{}: {error:.1e} rad", method.name());
    }
}

#[test]
fn reference_four_bar_with_a_massless_coupler() {
    assert_angles(&pure_coupler::Swing::default(), &[-1.0600222220106124, 1.3370601130449502, 2.344253762584637]);
}

#[test]
fn reference_chain_with_a_massless_middle() {
    assert_angles(&pure_middle::Swing::default(), &[-2.21710469106001, -2.2836681596165405, -1.734867634988195]);
}

#[test]
fn invariant_link_that_nothing_turns_is_named() {
    let error = simulation(&dangling::Swing::default()).run().unwrap_err().to_string();
    assert!(error.contains("tail.phi") && error.contains("no mass"), "{error}");
}
