//! Stops, skates with a limit, and motions that end.

use crate::analysis::tolerances::continuation::SHORTEST;
use crate::analysis::{AnalysisError, BifurcationDiagram, BranchEnd, Course, Linearization, Rests, SteadyMotion};
use crate::dynamics::system_of;
use crate::linalg::Backend;

crate::model! {
    /// A ball above a floor, or on a spring that lifts it.
    pub model Ball {
        param lift: N = 0;
        param k: N/m = 0;
        body ball { mass: 2, inertia: 1 }
        slider rail: ground(0, 0) ~ ball(0, 0) along ground(0, 1);
        stop floor: ball.y from 0 to 3 restitution 0.5;
        force at ball(0, 0): (0, lift - k*ball.y - 20 N);
        start above { ball at (0, 1) angle 0; at rest; }
        start below { ball at (0, 0) angle 0; at rest; }
        scene falls { start above; until 1 s; }
        scene lies { start below; until 1 s; }
    }
}

#[test]
fn analytic_ball_rests_on_its_floor_its_ceiling_or_its_spring() {
    // the force up without the stop, the stiffness, then place and multiplier of the stop
    let cases = [
        (0.0, 0.0, 0.0, -20.0),
        (50.0, 0.0, 3.0, 30.0),
        (60.0, 20.0, 2.0, 0.0),
        (10.0, 20.0, 0.0, -10.0),
        (90.0, 20.0, 3.0, 10.0),
    ];
    for (lift, k, y, multiplier) in cases {
        for scene in [&ball::Falls { lift, k } as &dyn crate::model::Scene, &ball::Lies { lift, k }] {
            let mut system = system_of(scene, Backend::Auto).unwrap();
            let start = system.scene_start();
            let motion = SteadyMotion::near(&mut system, &start, &[]).unwrap();
            let stop = system.info().stop.unwrap().row;
            assert!((motion.state.q[1] - y).abs() <= 1e-12, "{lift} {k}: {:?}", motion.state.q);
            assert!((motion.multipliers[stop] - multiplier).abs() <= 1e-12, "{lift} {k}: {:?}", motion.multipliers);
            // held by the stop it does not move
            let n_modes = Linearization::of(&mut system, &motion).unwrap().a.nrows();
            assert_eq!(n_modes, if multiplier == 0.0 { 2 } else { 0 });
            let rests = Rests::of(&mut system, &start, &[], 16).unwrap();
            assert_eq!(rests.found.len(), 1);
            assert!((rests.found[0].motion.state.q[1] - y).abs() <= 1e-12);
        }
    }
}

/// On the floor up to a force of the weight, on the spring up to the ceiling: on which rows it rests changes there.
#[test]
fn analytic_diagram_ends_where_the_stop_lets_go_or_is_met() {
    for (lift, range, last, end) in [
        (0.0, [0.0, 90.0], 20.0, BranchEnd::Switch),
        (50.0, [50.0, 90.0], 80.0, BranchEnd::Switch),
        (85.0, [85.0, 90.0], 90.0, BranchEnd::Range),
    ] {
        let scene = ball::Falls { lift, k: 20.0 };
        let mut system = system_of(&scene, Backend::Auto).unwrap();
        let start = system.scene_start();
        let diagram = BifurcationDiagram::of(&mut system, &start, &[], "lift", range, 1.0).unwrap();
        assert_eq!((diagram.branches.len(), diagram.branches[0].ends), (1, [BranchEnd::Range, end]));
        let points = &diagram.branches[0].points;
        let found = points[points.len() - 1].value;
        assert!((found - last).abs() <= SHORTEST, "{found} for {last}");
    }
}

crate::model! {
    /// A block above a floor that pushes it away, the more the higher it is.
    pub model Repelled {
        body block { mass: 2, inertia: 1 }
        slider rail: ground(0, 0) ~ block(0, 0) along ground(0, 1);
        stop floor: block.y from 0 restitution 0.5;
        force at block(0, 0): (0, 10 N + 20 N/m*block.y);
        start above { block at (0, 1) angle 0; at rest; }
        scene rises { start above; until 1 s; }
    }
}

#[test]
fn analytic_stop_that_would_have_to_pull_is_no_rest() {
    let scene = repelled::Rises::default();
    let mut system = system_of(&scene, Backend::Auto).unwrap();
    let start = system.scene_start();
    let error = SteadyMotion::near(&mut system, &start, &[]).unwrap_err();
    assert!(matches!(&error, AnalysisError::BeyondStop { stop: "floor", .. }), "{error}");
    let rests = Rests::of(&mut system, &start, &[], 8).unwrap();
    assert_eq!((rests.found.len(), rests.n_lost), (0, 8));
}

crate::model! {
    /// A runner on ice that is pushed sideways.
    pub model Runner {
        param push: N = 5;
        body runner { mass: 2, inertia: 1 }
        skate blade: at runner(0, 0) along runner(1, 0) limit 10 N;
        force at runner(0, 0) along runner(0, 1): push;
        start ahead { runner at (0, 0) angle 0 velocity (3, 0) rate 0; }
        scene glides { start ahead; until 1 s; }
    }
}

#[test]
fn analytic_skate_holds_up_to_its_limit_and_slides_beyond() {
    for (push, holds) in [(5.0, true), (9.999, true), (10.001, false)] {
        let scene = runner::Glides { push };
        let mut system = system_of(&scene, Backend::Auto).unwrap();
        let start = system.scene_start();
        match SteadyMotion::near(&mut system, &start, &["runner.vx", "runner.omega"]) {
            Ok(motion) => assert!(holds && (motion.multipliers[0] - push).abs() <= 1e-12, "{motion:?}"),
            Err(AnalysisError::Slides { force, limit, .. }) => assert!(!holds && force == push && limit == 10.0),
            Err(error) => panic!("{error}"),
        }
    }
}

crate::model! {
    /// A cart that a brake stops.
    pub model Braked {
        param d: N*s/m = 3;
        body cart { mass: 2, inertia: 1 }
        slider rail: ground(0, 0) ~ cart(0, 0) along ground(1, 0);
        force at cart(0, 0): (-d*cart.vx, 0);
        start runs { cart at (0, 0) angle 0 velocity (3, 0) rate 0; }
        scene stops { start runs; until 1 s; }
    }
}

#[test]
fn invariant_motion_that_comes_to_rest_is_rest() {
    let scene = braked::Stops::default();
    let mut system = system_of(&scene, Backend::Auto).unwrap();
    let start = system.scene_start();
    let motion = SteadyMotion::near(&mut system, &start, &[]).unwrap();
    assert_eq!(motion.course(), Course::Rest);
    assert_eq!(motion.free, ["cart.x"]);
}

crate::model! {
    /// A rod on a pin, let go level.
    pub model Level {
        param i: kg*m^2 = 0.1;
        body rod { mass: 2, inertia: i }
        hinge pin: ground(0, 0) ~ rod(-0.5, 0);
        gravity (0, -9.81);
        start level { rod near angle 0; at rest; }
        scene falls { start level; until 1 s; }
    }
}

#[test]
fn analytic_pendulum_sinks_to_its_nearest_rest() {
    use std::f64::consts::FRAC_PI_2;
    // below the pin, but for starts near the upper rest
    let cases = [
        (0.0, -FRAC_PI_2),
        (-0.1, -FRAC_PI_2),
        (-1.0, -FRAC_PI_2),
        (-2.5, -FRAC_PI_2),
        (1.3, FRAC_PI_2),
        (1.9, FRAC_PI_2),
    ];
    for (angle, rest) in cases {
        for i in [0.0, 0.1] {
            let scene = level::Falls { i };
            let mut system = system_of(&scene, Backend::Auto).unwrap();
            let mut start = system.scene_start();
            start.q[2] = angle;
            let motion = SteadyMotion::near(&mut system, &start, &[]).unwrap();
            assert!((motion.state.q[2] - rest).abs() <= 1e-12, "{angle} {i}: {:?}", motion.state.q);
        }
    }
}
