//! Mechanisms that pass positions where their rows lose rank, and go on as they came.

use ezy_core::prelude::*;
use ezy_core_tests::simulation;
use ezy_models::{four_bar, n_four_bar};
use std::f64::consts::PI;

model! {
    /// The pendulum that a parallelogram of equal rods is.
    pub model Equivalent {
        body rod { mass: 4.0, inertia: 2.0/3 }
        hinge A: ground(0, 0) ~ rod(-0.5, 0);
        gravity (0, -9.81);
        start falling { rod angle pi/2 rate -1; }
        scene turn { start falling; until 20 s; }
    }
}

model! {
    /// A crank that is driven farther than its rod reaches.
    pub model ShortRod {
        /// speed of the motor
        param omega: rad/s = 1.0;
        body crank { mass: 1.0, inertia: 0.1 }
        body rod { mass: 1.0, inertia: 0.1 }
        body block { mass: 1.0, inertia: 0.1 }
        hinge A: ground(0, 0) ~ crank(0, 0);
        hinge B: crank(1, 0) ~ rod(0, 0);
        hinge C: rod(0.5, 0) ~ block(0, 0);
        slider guide: ground(0, 0) ~ block(0, 0) along ground(1, 0);
        drive motor: crank.phi = 0.2 + omega*t;
        start turning { rod near angle (-0.4); }
        scene turn { start turning; until 1 s; }
    }
}

/// Angle of a crank, in tolerances: how errors of 20 s of turning grow, and noise at 20 passages.
const AMPLIFICATION: f64 = 1e4;

/// A few steps of each method, s.
const STEPS: f64 = 1e-2;

/// What rounding at 20 passages leaves of the angle, rad: it was 1e-6 while steps could end next to singular positions.
const FLOOR: f64 = 1e-9;

/// What a tolerance leaves of the energy: some hundred steps, each with the errors of several numbers.
const OF_ENERGY: f64 = 1e3;

/// What rounding at 20 passages leaves of it.
const FLOOR_OF_ENERGY: f64 = 1e-9;

/// What rounding leaves of the angles there, rad: steps of DOP853 at 1e-14 begin so near to a level position that a passage
/// leaves 1e-10 of the energy, and bars that turn at 10 rad/s and nearly stop in between make hundreds of it.
const UNEQUAL: f64 = 1e-7;

/// Errors of RK4 at 1 ms in motions of 10 rad/s.
const RK4: f64 = 1e-6;

/// Errors of the methods in a motion of 30 J, J.
const ON_THE_WAY: f64 = 1e-6;

/// The projection's promise, m.
const GAP: f64 = 1e-12;

/// Where a level position is crossed, stages come as near as 0.13 of a step of 0.1 rad.
const NEAR_LEVEL: f64 = 1e-3;

/// RK4 at 1 ms, and 1e-10 a step, after 5 s.
const ROW: f64 = 1e-7;

/// Far more steps than any run here takes: one whose steps become too short fails at once.
const MOST_STEPS: u64 = 100_000;

fn crank(scene: &dyn Scene, method: Method) -> (Run, f64) {
    let run = simulation(scene).method(method).max_steps(MOST_STEPS).work().run().unwrap();
    assert!(run.outcome.reached_end(), "{method:?}: {}", run.outcome);
    let phi = run.last().coordinates[2];
    (run, phi)
}

#[test]
fn cross_parallelogram_stays_one_through_its_flat_positions() {
    let (_, expected) = crank(&equivalent::Turn::default(), Method::dop853(1e-13));
    let scene = four_bar::Turning::default();
    let (usual, _) = crank(&scene, Method::rk4(1e-3));
    for tolerance in [1e-8, 1e-10, 1e-12, 1e-13, 1e-14] {
        for method in [Method::dop853(tolerance), Method::taylor(tolerance)] {
            let (run, phi) = crank(&scene, method);
            let bound = (AMPLIFICATION * tolerance).max(FLOOR);
            assert!((phi - expected).abs() <= bound, "{method:?}: {:.1e} of {bound:.1e}", phi - expected);
            assert!((run.last().coordinates[8] - phi).abs() <= FLOOR, "{method:?}");
            assert!(run.cost.steps <= usual.cost.steps / 10, "{method:?}: {} steps", run.cost.steps);
        }
    }
}

/// A step of gauss is as long as the time between two flat positions: one that passes a flat position between its ends may end on the
/// other branch.
#[test]
fn cross_long_steps_of_gauss_do_not_change_the_branch() {
    let scene = four_bar::Turning::default();
    let turning = |method| simulation(&scene).method(method).until(60.0).run().unwrap();
    for tolerance in [1e-6, 1e-7, 1e-8, 1e-9] {
        let coupler = turning(Method::gauss(tolerance)).last().get("coupler.phi").unwrap();
        assert!(coupler.abs() <= FLOOR, "{coupler} at {tolerance:e}");
    }
}

#[test]
fn cross_crossings_of_level_positions_are_recorded_by_every_method() {
    let (rod, scene) = (equivalent::Turn::default(), four_bar::Turning::default());
    let turning = simulation(&rod).method(Method::dop853(1e-12)).until(5.0).every(1e-3).run().unwrap();
    // in half turns; between two samples the angle is linear to 1e-6 of them
    let turning: Vec<_> = turning.samples().map(|sample| (sample.t, sample.coordinates[2] / PI)).collect();
    let level = |pair: &[(f64, f64)]| {
        let [(t, from), (next_t, to)] = [pair[0], pair[1]];
        let half_turns = from.max(to).floor();
        (half_turns > from.min(to)).then(|| t + (half_turns - from) / (to - from) * (next_t - t))
    };
    let level: Vec<f64> = turning.windows(2).filter_map(level).collect();
    assert!(level.len() >= 2, "{level:?}");
    for method in
        [Method::rk4(1e-3), Method::dop853(1e-9), Method::taylor(1e-9), Method::gauss(1e-9), Method::radau(1e-9)]
    {
        let run = simulation(&scene).method(method).until(5.0).run().unwrap();
        let crossings = &run.rank.crossings;
        // a long step may begin and end far from a level position
        let least = if method.kind() == MethodKind::Rk4 { level.len() } else { 1 };
        assert!((least..=level.len()).contains(&crossings.len()), "{method:?}: {crossings:?} of {level:?}");
        for crossing in crossings {
            let n_level = level.iter().filter(|level_s| (crossing.from_s..crossing.to_s).contains(level_s)).count();
            // a step of gauss is as long as from one level position to the next but one
            let most = if method.kind() == MethodKind::Gauss { 2 } else { 1 };
            assert!((1..=most).contains(&n_level), "{method:?}: {crossing:?} of {level:?}");
        }
        let run = simulation(&rod).method(method).until(1.0).run().unwrap();
        assert!(run.rank.crossings.is_empty(), "{method:?}: {}", run.rank);
    }
}

/// Bars of which one is 1 mm longer than the others pass beside the level positions, and those of a parallelogram lead through them.
#[test]
fn cross_crossings_beside_a_singular_position_are_told_from_those_through_it() {
    let beside = |scene: &four_bar::Turning| {
        let run = simulation(scene).method(Method::dop853(1e-6)).project_start().run().unwrap();
        assert!(!run.rank.crossings.is_empty(), "{:?}", run.outcome);
        let text = run.rank.to_string();
        let told = [run.rank.crossings[0].is_beside(), text.contains("passed beside a singular position")];
        assert!(told == [true; 2] || told == [false; 2], "{told:?}: {text}");
        run.rank.crossings.iter().filter(|crossed| crossed.is_beside()).count()
    };
    assert_eq!(beside(&four_bar::Turning::default()), 0);
    assert!(beside(&four_bar::Turning { l2: 1.001, ..Default::default() }) > 0);
}

#[test]
fn cross_row_of_parallelograms_stays_one_through_its_flat_positions() {
    let (_, expected) = crank(&equivalent_to_two(), Method::dop853(1e-13));
    for method in [Method::rk4(1e-3), Method::dop853(1e-10), Method::taylor(1e-10)] {
        let scene = n_four_bar::Fall { n: 2, ..Default::default() };
        let run = simulation(&scene).method(method).until(5.0).run().unwrap();
        assert!(run.outcome.reached_end(), "{method:?}: {}", run.outcome);
        let phi = run.last().coordinates[2];
        assert!((phi - expected).abs() <= ROW, "{method:?}: {:.1e}", phi - expected);
    }
}

model! {
    /// The pendulum that two parallelograms side by side are: I = 3 kg·m², m g l = 34.335 N·m.
    pub model EquivalentToTwo {
        body rod { mass: 7.0, inertia: 1.25 }
        hinge A: ground(0, 0) ~ rod(-0.5, 0);
        gravity (0, -9.81);
        start falling { rod angle pi/2 rate -1; }
        scene turn { start falling; until 5 s; }
    }
}

fn equivalent_to_two() -> equivalent_to_two::Turn {
    equivalent_to_two::Turn::default()
}

/// Four-bars of bars as long in pairs of sums: crank and coupler turn round and lie level with the base once a turn.
fn change_points() -> [four_bar::Turning; 4] {
    let bars = |base, l1, l2, l3| four_bar::Turning { base, l1, l2, l3, ..Default::default() };
    [bars(1.1, 1.0, 1.3, 1.2), bars(1.2, 1.0, 1.1, 1.3), bars(1.5, 0.5, 2.0, 1.0), bars(1.0, 1.0, 1.5, 1.5)]
}

/// Of every method, with the tolerance that it keeps to.
fn methods() -> Vec<(Method, f64)> {
    let mut methods = vec![(Method::rk4(1e-3), RK4), (Method::radau(1e-7), 1e-7)];
    for tolerance in [1e-6, 1e-8, 1e-10, 1e-12, 1e-14] {
        methods.extend([Method::dop853(tolerance), Method::taylor(tolerance)].map(|method| (method, tolerance)));
    }
    methods
}

#[test]
fn cross_four_bars_of_unequal_bars_pass_their_level_positions_on_one_branch() {
    for scene in change_points() {
        let order = |method| simulation(&scene).method(method).until(4.0);
        let run = |method| order(method).max_steps(MOST_STEPS).run().unwrap();
        let expected = run(Method::dop853(1e-13)).last().coordinates.to_vec();
        for (method, tolerance) in methods() {
            let run = run(method);
            assert!(run.outcome.reached_end(), "{method:?}: {}", run.outcome);
            let energy = run.monitors.energy.unwrap().relative;
            assert!(energy <= (OF_ENERGY * tolerance).max(FLOOR_OF_ENERGY), "{method:?}: energy {energy:.1e}");
            let off = expected.iter().zip(run.last().coordinates).fold(0.0, |m: f64, (a, b)| m.max((a - b).abs()));
            assert!(off <= (AMPLIFICATION * tolerance).max(UNEQUAL), "{method:?}: {off:.1e}");
        }
    }
}

/// Of 40 sizes, which rounding tells apart.
#[test]
fn cross_change_points_are_passed_by_the_smallest_tolerance() {
    let [.., third, _] = change_points();
    for i in 0..40 {
        let size = 1.0 + 1e-4 * f64::from(i);
        let of = |length: f64| size * length;
        let four_bar::Turning { base, l1, l2, l3, .. } = third;
        let scene = four_bar::Turning { base: of(base), l1: of(l1), l2: of(l2), l3: of(l3), ..Default::default() };
        let run = |tolerance| simulation(&scene).method(Method::dop853(tolerance)).until(4.0).run().unwrap();
        let (least, larger) = (run(1e-14), run(1e-13));
        assert!(least.outcome.reached_end(), "{size}: {}", least.outcome);
        let both = larger.last().coordinates.iter().zip(least.last().coordinates);
        let off = both.fold(0.0, |m: f64, (a, b)| m.max((a - b).abs()));
        // each of them is off by what rounding leaves
        assert!(off <= 2.0 * UNEQUAL, "{size}: {off:.1e}");
    }
}

#[test]
fn invariant_samples_on_the_way_over_a_level_position_keep_to_rows_and_energy() {
    let scene = four_bar::Turning::default();
    for method in
        [Method::rk4(1e-3), Method::dop853(1e-12), Method::taylor(1e-12), Method::gauss(1e-12), Method::radau(1e-8)]
    {
        let run = simulation(&scene).method(method).until(2.0).every(1e-3).run().unwrap();
        let energy = |sample: &Sample<'_>| sample.energy.kinetic + sample.energy.potential;
        let samples: Vec<_> = run.samples().collect();
        for sample in &samples {
            let off = energy(sample) - energy(&samples[0]);
            assert!(off.abs() <= ON_THE_WAY, "{method:?}, t = {}: {off:.1e} J", sample.t);
            assert!(sample.position_residual <= GAP, "{method:?}, t = {}: {:.1e}", sample.t, sample.position_residual);
        }
    }
}

#[test]
fn invariant_smallest_pivot_is_seen_where_rods_lie_level() {
    let scene = four_bar::Turning::default();
    for method in
        [Method::rk4(1e-3), Method::dop853(1e-10), Method::taylor(1e-10), Method::gauss(1e-10), Method::radau(1e-8)]
    {
        let pivot = simulation(&scene).method(method).until(2.0).run().unwrap().monitors.pivot.unwrap();
        assert!(pivot.value < NEAR_LEVEL && pivot.value >= 0.0 && pivot.t > 0.0, "{method:?}: {pivot:?}");
    }
}

#[test]
fn analytic_motor_against_a_stretched_rod_ends_the_run_with_the_rows() {
    for method in [Method::rk4(1e-3), Method::dop853(1e-8), Method::taylor(1e-8)] {
        let run = simulation(&short_rod::Turn::default()).method(method).run().unwrap();
        let outcome = run.outcome.to_string();
        // the rod is upright when sin φ = 1/2
        let end = std::f64::consts::FRAC_PI_6 - 0.2;
        assert!((run.last().t - end).abs() <= STEPS, "{method:?}: {outcome}");
        assert!(outcome.contains("motor") && outcome.contains("guide"), "{method:?}: {outcome}");
    }
}
