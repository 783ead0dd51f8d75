//! Starts: what is given stays, what is free moves as little as possible, and what cannot be met is named.

use ezy_core::dynamics::StartError;
use ezy_core::model::Start;
use ezy_core::prelude::*;
use ezy_core_tests::system_of;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_3};

model! {
    /// Two blocks on rails that a rope over a tackle joins: one moves by half of what the other does.
    pub model Tackle {
        param m: kg = 3;
        param n: kg = 5;
        param l: m = 6;
        body left { mass: m, inertia: 1 }
        body right { mass: n, inertia: 1 }
        constraint rope: left.x + 2 * right.x = l + 0.5 * sin(3 * t);
        start slack { left angle 0; right angle 0; }
        scene moves { start slack; until 1 s; }
    }
}

model! {
    /// Rods of 1 m and 1 kg in a row, hung from one end.
    pub model Chain {
        count n = 3;
        param first: rad = 0.3;
        body rod[n] { mass: 1, inertia: 1/12 }
        hinge top: ground(0, 0) ~ rod[0](-0.5, 0);
        for i in 1..n { hinge pin[i]: rod[i-1](0.5, 0) ~ rod[i](-0.5, 0); }
        gravity (0, -9.81);
        start spread { for i in 0..n { rod[i] angle first + 0.1*i; } rod[0] rate 1; }
        scene swing { start spread; until 1 s; }
    }
}

model! {
    /// A crank, a coupler and a rocker.
    pub model FourBar {
        param base: m = 1.3;
        param crank_length: m = 1;
        param coupler_length: m = 1.4;
        param rocker_length: m = 1.2;
        body crank { mass: 1, inertia: 0.1 }
        body coupler { mass: 2, inertia: 0.3 }
        body rocker { mass: 1, inertia: 0.1 }
        hinge A: ground(0, 0) ~ crank(-crank_length/2, 0);
        hinge B: crank(crank_length/2, 0) ~ coupler(-coupler_length/2, 0);
        hinge C: coupler(coupler_length/2, 0) ~ rocker(rocker_length/2, 0);
        hinge D: ground(base, 0) ~ rocker(-rocker_length/2, 0);
        start upright { crank angle pi/2; coupler near angle 0; rocker near angle pi/2; at rest; }
        scene turning { start upright; until 1 s; }
    }
}

model! {
    /// A stone on a rod.
    pub model Tethered {
        param l: m = 1;
        body stone { mass: 2, inertia: 1 }
        rod tie: ground(0, 0) ~ stone(0, 0) length l;
        start anywhere { stone angle 0; }
        scene circles { start anywhere; until 1 s; }
    }
}

/// The assembly goes on to rounding of numbers of one; sizes of rows are near one.
const ASSEMBLED: f64 = 1e-12;

fn assembled(scene: &dyn Scene, start: &Start) -> State {
    let mut system = system_of(scene, Backend::Auto).unwrap();
    let state = system.consistent_start(start).unwrap_or_else(|error| panic!("{error}"));
    assert!(system.position_residual(state.t, &state.q) <= ASSEMBLED, "{:?}", state.q);
    assert!(system.velocity_residual(state.t, &state.q, &state.v) <= ASSEMBLED, "{:?}", state.v);
    state
}

fn refused(scene: &dyn Scene, start: &Start) -> StartError {
    system_of(scene, Backend::Auto).unwrap().consistent_start(start).expect_err("it cannot be met")
}

/// With G = [1, 2] and masses m, n: the rope asks each block for its share (1/m and 2/n) of the residual over 1/m + 4/n.
#[test]
fn analytic_what_is_free_moves_least_in_the_metric_of_the_masses() {
    for (m, n) in [(3.0, 5.0), (0.1, 40.0), (700.0, 2.0)] {
        let scene = tackle::Moves { m, n, ..Default::default() };
        let mut start = Start::free(6);
        (start.q[0], start.q[3], start.v[0], start.v[3]) = (0.5, -1.0, 2.0, 0.25);
        let state = assembled(&scene, &start);
        let share = 1.0 / m + 4.0 / n;
        // 0.5 − 2 falls short of 6 by 7.5, and 2 + 0.5 of 3 · 0.5 by −1
        for (found, expected) in [
            (state.q[0], 0.5 + 7.5 / m / share),
            (state.q[3], -1.0 + 7.5 * 2.0 / n / share),
            (state.v[0], 2.0 - 1.0 / m / share),
            (state.v[3], 0.25 - 2.0 / n / share),
        ] {
            assert!((found - expected).abs() <= ASSEMBLED, "{m} {n}: {found} {expected}");
        }
        for i in [1, 2, 4, 5] {
            assert_eq!((state.q[i], state.v[i]), (0.0, 0.0), "no row moves it");
        }
        // one of both held: the other takes all
        start.give_position(0, 0.5);
        start.give_velocity(3, 0.25);
        let state = assembled(&scene, &start);
        assert_eq!((state.q[0], state.v[3]), (0.5, 0.25));
        assert!((state.q[3] - 2.75).abs() <= ASSEMBLED && (state.v[0] - 1.0).abs() <= ASSEMBLED, "{state:?}");
    }
}

/// A start at another time is assembled there, with the rates of that time.
#[test]
fn analytic_rows_that_move_set_positions_and_velocities_at_their_time() {
    let scene = tackle::Moves::default();
    let mut start = Start::free(6);
    start.t = 0.4;
    start.give_position(3, 1.0);
    start.give_velocity(3, 0.0);
    let state = assembled(&scene, &start);
    assert_eq!(state.t, 0.4);
    assert!((state.q[0] - (4.0 + 0.5 * 1.2_f64.sin())).abs() <= ASSEMBLED, "{:?}", state.q);
    assert!((state.v[0] - 1.5 * 1.2_f64.cos()).abs() <= ASSEMBLED, "{:?}", state.v);
}

/// A block without mass moves at no cost: the other one stays, unless the massless one is held.
#[test]
fn analytic_massless_block_gives_way_first() {
    for (m, n, expected) in [(0.0, 5.0, [6.0, 0.0]), (3.0, 0.0, [0.0, 3.0]), (0.0, 0.0, [6.0 / 5.0, 12.0 / 5.0])] {
        let scene = tackle::Moves { m, n, ..Default::default() };
        let state = assembled(&scene, &Start::free(6));
        let close = (state.q[0] - expected[0]).abs().max((state.q[3] - expected[1]).abs()) <= ASSEMBLED;
        assert!(close, "{m} {n}: {:?}", state.q);
    }
    let scene = tackle::Moves { m: 0.0, ..Default::default() };
    let mut start = Start::free(6);
    start.give_position(0, 1.0);
    let state = assembled(&scene, &start);
    assert!(state.q[0] == 1.0 && (state.q[3] - 2.5).abs() <= ASSEMBLED, "{:?}", state.q);
}

/// Motions of a chain that its hinges allow: rod j turns at 1 rad/s and carries those below it.
fn motion(q: &[f64], j: usize) -> Vec<f64> {
    let mut v = vec![0.0; q.len()];
    let (sin, cos) = q[3 * j + 2].sin_cos();
    for i in j..q.len() / 3 {
        let arm = if i == j { 0.5 } else { 1.0 };
        (v[3 * i], v[3 * i + 1]) = (-arm * sin, arm * cos);
    }
    v[3 * j + 2] = 1.0;
    v
}

/// Up to 150 coordinates corrections come from singular values, beyond from a sparse factorisation with a damping of 1e-12: both
/// find the velocity that does no work in the metric of the masses on a motion that is free.
#[test]
fn analytic_velocities_of_a_chain_have_least_energy_by_both_solvers() {
    for n in [3, 50, 51] {
        let scene = chain::Swing { n, ..Default::default() };
        let system = system_of(&scene, Backend::Auto).unwrap();
        let start = system.scene_start();
        let state = assembled(&scene, &start);
        let mut end = [0.0, 0.0];
        for i in 0..n {
            let phi = 0.3 + 0.1 * i as f64;
            assert_eq!(state.q[3 * i + 2], phi);
            let centre = [end[0] + 0.5 * phi.cos(), end[1] + 0.5 * phi.sin()];
            assert!(
                (state.q[3 * i] - centre[0]).hypot(state.q[3 * i + 1] - centre[1]) <= 1e2 * ASSEMBLED,
                "{n}: rod {i}"
            );
            end = [end[0] + phi.cos(), end[1] + phi.sin()];
        }
        assert_eq!(state.v[2], 1.0);
        let mass = system.mass_matrix();
        for j in 1..n {
            let product: f64 = motion(&state.q, j).iter().zip(&state.v).zip(mass).map(|((u, v), m)| u * v * m).sum();
            assert!(product.abs() <= 1e2 * ASSEMBLED, "{n}: rod {j}, {product:.1e}");
        }
        assert!(state.v[3..].iter().any(|v| v.abs() > 0.1), "the others follow the first rod");
    }
}

/// Angles of two bars of these lengths, the first from `from`, the second to `to`, that meet: bent to one side and to the other.
pub fn two_bars(from: [f64; 2], to: [f64; 2], [first, second]: [f64; 2]) -> [[f64; 2]; 2] {
    let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
    let (distance, along) = (dx.hypot(dy), dy.atan2(dx));
    let angle = |a: f64, b: f64| ((a * a + distance * distance - b * b) / (2.0 * a * distance)).acos();
    let (at_first, at_second) = (angle(first, second), angle(second, first));
    [1.0, -1.0].map(|side| [along + side * at_first, along - side * at_second])
}

/// Whether coupler and rocker close the loop; the rocker points from its bearing to the coupler.
fn is_closed(q: &[f64], base: f64) -> bool {
    let crank = [q[2].cos(), q[2].sin()];
    let of = |[coupler, rocker]: [f64; 2]| {
        (q[5] - coupler).sin().abs() <= 1e2 * ASSEMBLED
            && (q[8] - rocker - std::f64::consts::PI).sin().abs() <= 1e2 * ASSEMBLED
    };
    two_bars(crank, [base, 0.0], [1.4, 1.2]).into_iter().any(of)
}

#[test]
fn analytic_four_bar_is_assembled_from_far() {
    let scene = four_bar::Turning::default();
    for held in [0.4, FRAC_PI_2, 2.0, -1.0] {
        for guess in [[0.0; 6], [3.0, -2.0, 1.0, 0.5, 4.0, -1.5], [-40.0, 30.0, 2.0, 25.0, -60.0, 1.0]] {
            let mut start = Start::free(9);
            start.give_position(2, held);
            start.q[3..].copy_from_slice(&guess);
            let state = assembled(&scene, &start);
            assert!(state.q[2] == held && is_closed(&state.q, scene.base), "{held} {guess:?}: {:?}", state.q);
        }
    }
}

/// What is consistent is left as it is, to the last bit; what is assembled ends at rounding, which is far below the tolerance.
#[test]
fn invariant_consistent_start_is_not_touched() {
    let scene = four_bar::Turning::default();
    let mut system = system_of(&scene, Backend::Auto).unwrap();
    let start = system.scene_start();
    let state = system.consistent_start(&start).unwrap();
    assert!(system.position_residual(0.0, &state.q) <= 4.0 * f64::EPSILON, "one pass more, for rounding");
    let mut free = Start::free(9);
    (free.q, free.v) = (state.q.clone(), state.v.clone());
    // within the tolerance, and not at rounding
    free.q[0] += 5e-13;
    let again = system.consistent_start(&free).unwrap();
    assert_eq!((&again.q, &again.v), (&free.q, &free.v));
    free.q[0] += 5e-12;
    assert_ne!(system.consistent_start(&free).unwrap().q, free.q);
}

/// All bars in one line, and a stone on its bearing's height: the slopes do not say where to go, and a place beside them does.
#[test]
fn analytic_start_leaves_a_symmetry() {
    let mut start = Start::free(3);
    start.give_position(0, 0.5);
    let state = assembled(&tethered::Circles::default(), &start);
    assert!(state.q[0] == 0.5 && (state.q[1].abs() - 0.75_f64.sqrt()).abs() <= ASSEMBLED, "{:?}", state.q);
    let flat = four_bar::Turning { base: 2.0, coupler_length: 2.0, rocker_length: 1.5, ..Default::default() };
    let mut start = Start::free(9);
    start.give_position(2, 0.0);
    let state = assembled(&flat, &start);
    let [bent, _] = two_bars([1.0, 0.0], [2.0, 0.0], [2.0, 1.5]);
    assert!((state.q[5].sin().abs() - bent[0].sin().abs()).abs() <= 10.0 * ASSEMBLED, "{:?}", state.q);
    // places that are the same each time
    assert_eq!(assembled(&flat, &start), state);
    let massive = four_bar::Turning { base: 2e3, crank_length: 1e3, coupler_length: 2e3, rocker_length: 1.5e3 };
    let mut system = system_of(&massive, Backend::Auto).unwrap();
    let large = system.consistent_start(&start).unwrap();
    assert!((large.q[5].sin().abs() - bent[0].sin().abs()).abs() <= 10.0 * ASSEMBLED, "{:?}", large.q);
}

#[test]
fn invariant_start_values_that_are_no_numbers_are_refused_by_name() {
    let scene = tackle::Moves::default();
    let error = |change: fn(&mut Start)| {
        let mut start = Start::free(6);
        change(&mut start);
        refused(&scene, &start).to_string()
    };
    assert_eq!(error(|start| start.give_position(3, f64::NAN)), "start value `right.x` is NaN; give it a finite value");
    assert_eq!(error(|start| start.v[2] = f64::INFINITY), "start value `left.omega` is inf; give it a finite value");
    let large = "start value `right.vy` is -2e9, beyond 1e9, where rounding hides the geometry; start nearer";
    assert_eq!(error(|start| start.v[4] = -2e9), large);
    let mut start = Start::free(6);
    start.give_position(1, 1e9);
    assert_eq!(system_of(&scene, Backend::Auto).unwrap().consistent_start(&start).unwrap().q[1], 1e9);
}

/// The rope is 0.75 m too short for both blocks, and runs at 2.5 m/s where it runs at 1.5 m/s.
#[test]
fn analytic_contradictions_name_level_rows_and_what_is_held() {
    let scene = tackle::Moves::default();
    let mut start = Start::free(6);
    start.give_position(0, 1.25);
    start.give_position(3, 2.0);
    let message = refused(&scene, &start).to_string();
    let expected = "the start contradicts the constraints: position of rope cannot be met, the best start leaves 7.500e-1 (tolerance \
                    1.0e-12); held: left.x, right.x. Give fewer values, values that fit, or let them give way: `project_start`, \
                    `--project-start`";
    assert_eq!(message, expected);
    start.give_position(0, 2.0);
    start.give_velocity(0, 2.0);
    start.give_velocity(3, 0.25);
    let StartError::Contradiction { level, rows, residual, held, tolerance } = refused(&scene, &start) else {
        panic!()
    };
    assert_eq!(level, "velocity");
    assert_eq!(rows, ["rope"]);
    assert_eq!(held, ["left.vx", "right.vx"]);
    assert!((residual - 1.0).abs() <= ASSEMBLED && (tolerance - 1e-12).abs() <= 1e-13, "{residual} {tolerance:e}");
}

/// The largest gap is named first: the coupler and the rocker are held 0.6 m apart along x and 0.3 m along y.
#[test]
fn analytic_rows_that_are_not_met_are_told_with_the_worst_first() {
    let scene = chain::Swing { n: 2, first: 0.0 };
    let mut start = Start::free(6);
    for (i, x) in [0.5, 0.0, 0.0, 1.5 + 0.3, -0.6, 0.0].into_iter().enumerate() {
        start.give_position(i, x);
    }
    let StartError::Contradiction { rows, residual, held, .. } = refused(&scene, &start) else { panic!() };
    assert_eq!(rows, ["pin[1].y", "pin[1].x"]);
    assert!((residual - 0.6).abs() <= ASSEMBLED && held.len() == 6, "{residual} {held:?}");
    let message = refused(&four_bar::Turning { base: 4.0, ..Default::default() }, &Start::free(9)).to_string();
    assert!(
        message.contains("position of ") && message.contains("; held: nothing. The constraints contradict"),
        "{message}"
    );
}

/// A chain of 60 rods whose last end cannot be where it is held: of all names that are held 40 are told.
#[test]
fn invariant_long_lists_of_names_are_cut_and_the_rest_counted() {
    let scene = chain::Swing { n: 15, ..Default::default() };
    let mut start = Start::free(45);
    (0..45).for_each(|i| start.give_position(i, 0.0));
    let message = refused(&scene, &start).to_string();
    assert!(message.contains("held: rod[0].x, ") && message.contains("rod[13].x and 5 more. Give fewer"), "{message}");
    let fits = chain::Swing { n: 13, ..Default::default() };
    let mut start = Start::free(39);
    (0..39).for_each(|i| start.give_position(i, 0.0));
    let message = refused(&fits, &start).to_string();
    assert!(message.contains("rod[12].phi. Give fewer"), "{message}");
}

#[test]
fn invariant_row_without_a_value_is_named() {
    let scene = tethered::Circles { l: 0.0 };
    let mut start = Start::free(3);
    start.give_position(0, 0.0);
    start.give_position(1, 0.0);
    let error = refused(&scene, &start);
    assert!(matches!(&error, StartError::UndefinedRow { row } if row == "tie"), "{error}");
}

/// A block of the tackle that is near is held if the rope allows it, and gives way if not; the other one stays held.
#[test]
fn analytic_near_values_give_way_and_are_told() {
    let scene = tackle::Moves::default();
    let mut system = system_of(&scene, Backend::Auto).unwrap();
    let mut start = Start::free(6);
    start.give_position(0, 2.0);
    start.near_position(3, 1.0);
    start.give_velocity(3, 0.5);
    start.near_velocity(0, -2.0);
    let state = system.consistent_start(&start).unwrap();
    assert!(state.q[0] == 2.0 && (state.q[3] - 2.0).abs() <= ASSEMBLED, "{:?}", state.q);
    assert!(state.v[3] == 0.5 && (state.v[0] - 0.5).abs() <= ASSEMBLED, "{:?}", state.v);
    let moved = system.moved_values(&start, &state);
    let told: Vec<_> = moved.iter().map(|value| (&*value.name, value.unit, value.given)).collect();
    assert_eq!(told, [("right.x", "m", 1.0), ("left.vx", "m/s", -2.0)]);
    assert_eq!(moved.iter().map(|value| value.got).collect::<Vec<_>>(), [state.q[3], state.v[0]]);
    // what fits is kept to the last bit, and nothing is told
    start.near_position(3, 2.0);
    start.near_velocity(0, 0.5);
    let state = system.consistent_start(&start).unwrap();
    assert_eq!((state.q[3], state.v[0], system.moved_values(&start, &state).len()), (2.0, 0.5, 0));
}

/// Last digits are 1e-6 of the longest lever, here of the tackle's 4 m, and of the largest velocity; of angles 1e-6 rad.
#[test]
fn analytic_last_digits_of_near_values_are_not_told() {
    let scene = tackle::Moves::default();
    let mut system = system_of(&scene, Backend::Auto).unwrap();
    let mut told = |q: f64, v: f64| {
        let mut start = Start::free(6);
        start.give_position(0, 2.0);
        start.give_velocity(0, -38.5);
        start.near_position(3, 2.0 + q);
        start.near_velocity(3, 20.0 + v);
        let state = system.consistent_start(&start).unwrap();
        system.moved_values(&start, &state).into_iter().map(|value| value.name).collect::<Vec<_>>()
    };
    assert_eq!(told(0.5e-6, 20e-6), [""; 0]);
    assert_eq!(told(-0.5e-6, -20e-6), [""; 0]);
    assert_eq!(told(2e-6, 20e-6), ["right.x"]);
    assert_eq!(told(-2e-6, -60e-6), ["right.x", "right.vx"]);
    let pendulum = chain::Swing { n: 1, ..Default::default() };
    let mut system = system_of(&pendulum, Backend::Auto).unwrap();
    for (off, n) in [(2e-7, 0), (-2e-7, 0), (1e-5, 1), (-1e-5, 1)] {
        let mut start = Start::free(3);
        start.give_position(0, 0.5 * FRAC_PI_3.cos());
        start.near_position(2, FRAC_PI_3 + off);
        let state = system.consistent_start(&start).unwrap();
        assert!((state.q[2] - FRAC_PI_3).abs() <= ASSEMBLED, "{off}");
        assert_eq!(system.moved_values(&start, &state).len(), n, "{off}");
    }
}

/// Of near values centres give way before angles; angles do when centres are not enough.
#[test]
fn analytic_centres_give_way_before_angles() {
    let pendulum = chain::Swing { n: 1, ..Default::default() };
    let mut start = Start::free(3);
    start.near_position(0, 2.0);
    start.near_position(1, -1.0);
    start.near_position(2, 0.7);
    let state = assembled(&pendulum, &start);
    assert_eq!(state.q[2], 0.7);
    assert!((state.q[0] - 0.5 * 0.7_f64.cos()).hypot(state.q[1] - 0.5 * 0.7_f64.sin()) <= ASSEMBLED, "{:?}", state.q);
    start.give_position(0, 0.5 * 0.9_f64.cos());
    let state = assembled(&pendulum, &start);
    assert!((state.q[2] - 0.9).abs() <= ASSEMBLED && state.q[0] == 0.5 * 0.9_f64.cos(), "{:?}", state.q);
}

/// Everything gives way: the nearest consistent velocity in the metric of the masses.
#[test]
fn analytic_start_that_gives_way_is_projected() {
    let scene = tackle::Moves::default();
    let mut start = Start::free(6);
    start.give_position(0, 0.5);
    start.give_position(3, -1.0);
    start.give_velocity(0, 2.0);
    start.give_velocity(3, 0.25);
    start.give_way();
    let state = assembled(&scene, &start);
    let share = 1.0 / 3.0 + 4.0 / 5.0;
    for (found, expected) in [
        (state.q[0], 0.5 + 7.5 / 3.0 / share),
        (state.q[3], -1.0 + 7.5 * 2.0 / 5.0 / share),
        (state.v[0], 2.0 - 1.0 / 3.0 / share),
        (state.v[3], 0.25 - 2.0 / 5.0 / share),
    ] {
        assert!((found - expected).abs() <= ASSEMBLED, "{found} {expected}");
    }
}
