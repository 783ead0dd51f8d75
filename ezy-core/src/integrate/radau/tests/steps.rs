//! Steps of m x'' + c x' + k x = 0, of which all parts are known in closed form.

use super::super::control::values_over_estimate;
use super::super::tableau::{GAMMA, NODES, START_SLOPE, UNSEEN, UNSEEN_REMAINDER, through_nodes};
use super::super::{Attempt, Radau};
use super::free;
use crate::dynamics::system_of;
use crate::dynamics::{State, System};
use crate::integrate::{Node, Tolerance};
use crate::linalg::Backend;
use crate::model::Scene;

const M: f64 = 4.0;

const TOLERANCE: Tolerance = Tolerance::new(1e-6, 1e-6);

/// Rounding of sums of numbers of ten, over parts of a step of 1e-4 of them.
const ROUNDING: f64 = 1e-10;

/// A step that was tried from x = 1 m, x' = -0.5 m/s.
struct Tried<'s> {
    system: System<&'s dyn Scene>,
    radau: Radau,
    from: State,
    a: [f64; 3],
    power: [f64; 1],
    to: State,
    error: f64,
    n_passes: u32,
}

impl<'s> Tried<'s> {
    fn new(scene: &'s free::Swings, h: f64) -> Self {
        Self::with_velocity(scene, -0.5, h)
    }

    fn with_velocity(scene: &'s free::Swings, v: f64, h: f64) -> Self {
        let system = system_of(scene, Backend::Auto).unwrap();
        let mut from = State::zero(3, 1);
        (from.q[0], from.v[0]) = (1.0, v);
        let force = -(scene.k + scene.c * v);
        let (a, power) = ([force / M, 0.0, 0.0], [force * v]);
        let to = from.clone();
        let radau = Radau::new(scene, 1).unwrap().unwrap();
        let mut tried = Self { system, radau, from, a, power, to, error: 0.0, n_passes: 0 };
        tried.attempt(h);
        tried
    }

    fn attempt(&mut self, h: f64) {
        let Self { system, radau, from, a, power, to, .. } = self;
        let from = Node { state: from, q_rate: &from.v, a, rate: &[], power };
        let Attempt::Solved { error, n_passes } = radau.attempt(system, from, h, TOLERANCE, to).unwrap() else {
            panic!("a linear equation is solved at once")
        };
        (self.error, self.n_passes) = (error, n_passes);
    }

    /// Filtered and unfiltered.
    fn estimate(&mut self, h: f64) -> (f64, f64) {
        self.radau
            .estimate(Node { state: &self.from, q_rate: &self.from.v, a: &self.a, rate: &[], power: &self.power }, h)
    }

    fn second_look(&mut self, h: f64, estimate: f64) -> f64 {
        self.radau.second_look(&mut self.system, &self.from, h, TOLERANCE, estimate)
    }

    /// Over the tolerances of x and x': the root mean square over six numbers.
    fn size(&self, x: f64, v: f64) -> f64 {
        let of = |x: f64, at: f64| x / (1e-6 + 1e-6 * at);
        ((of(x, 1.0).powi(2) + of(v, 0.5).powi(2)) / 6.0).sqrt()
    }
}

/// One pass solves a linear equation, with factors that serve as long as steps are equally long.
#[test]
fn analytic_linear_equations_take_one_pass_and_keep_their_factors() {
    let scene = free::Swings::default();
    let mut tried = Tried::new(&scene, 0.01);
    let mut n_factored = tried.system.counters().factorizations;
    for (h, more) in [(0.01, 0), (0.01 * (1.0 + 5e-10), 0), (0.01 * (1.0 + 2e-9), 1), (0.005, 1), (0.005, 0), (0.01, 1)]
    {
        tried.radau.accept(h);
        tried.from.copy_from(&tried.to.clone());
        tried.a[0] = -(scene.k * tried.from.q[0] + scene.c * tried.from.v[0]) / M;
        tried.attempt(h);
        assert!(tried.n_passes <= 2 && tried.radau.keeps_factors(), "{} passes", tried.n_passes);
        let now = tried.system.counters().factorizations;
        assert_eq!(now - n_factored, more, "h = {h}");
        n_factored = now;
    }
}

/// The difference of the slope at the start from that of the stages' polynomial, over μ − J.
#[test]
fn analytic_estimate_is_the_missing_slope_at_the_start_filtered() {
    let (h, scene) = (0.1, free::Swings::default());
    let mut tried = Tried::new(&scene, h);
    let (filtered, unfiltered) = tried.estimate(h);
    let missing = |slope: f64, of: &[Vec<f64>; 3]| slope + (0..3).map(|i| START_SLOPE[i] * of[i][0]).sum::<f64>() / h;
    let (x, v) = (missing(-0.5, &tried.radau.stages.q), missing(tried.a[0], &tried.radau.stages.v));
    assert!((unfiltered / tried.size(x * h / GAMMA, v * h / GAMMA) - 1.0).abs() <= ROUNDING, "{unfiltered}");
    // (μ − J)⁻¹ of two equations by Cramer's rule
    let (mu, k, c) = (GAMMA / h, scene.k / M, scene.c / M);
    let determinant = mu * (mu + c) + k;
    let (x, v) = (((mu + c) * x + v) / determinant, (mu * v - k * x) / determinant);
    assert!((filtered / tried.size(x, v) - 1.0).abs() <= ROUNDING, "{filtered} {}", tried.size(x, v));
    // of works the same without a filter
    let work =
        (h * tried.power[0] + (0..3).map(|i| START_SLOPE[i] * tried.radau.stages.work[i][0]).sum::<f64>()) / GAMMA;
    assert!((tried.radau.error.work[0] / work - 1.0).abs() <= ROUNDING && work != 0.0, "{work}");
    // the Jacobians at the end are those at the start
    let from = Node { state: &tried.from, q_rate: &tried.from.v, a: &tried.a, rate: &[], power: &tried.power };
    let n_factored = tried.system.counters().factorizations;
    let at_end = tried.radau.estimate_at_end(&mut tried.system, from, h, &tried.to);
    assert!((at_end / filtered - 1.0).abs() <= ROUNDING, "{at_end} {filtered}");
    assert_eq!(tried.system.counters().factorizations - n_factored, 1);
}

/// A damper that pushes with c = −m μ takes the whole of M + c/μ: no error is known there, and none is not zero.
#[test]
fn analytic_estimate_with_a_singular_matrix_is_infinite() {
    // without rounding
    let mu = 32.0;
    let (h, scene) = (GAMMA / mu, free::Swings::default());
    let mut tried = Tried::new(&scene, h);
    let singular = free::Swings { k: 0.0, c: -M * mu };
    let mut system = system_of(&singular, Backend::Auto).unwrap();
    let from = Node { state: &tried.from, q_rate: &tried.from.v, a: &tried.a, rate: &[], power: &tried.power };
    assert_eq!(tried.radau.estimate_at_end(&mut system, from, h, &tried.to), f64::INFINITY);
    assert!(tried.radau.estimate_at_end(&mut tried.system, from, h, &tried.to) < 1e9);
}

/// The estimate goes with the fourth power of the step, the second look with the fifth.
#[test]
fn order_of_the_estimate_is_four_and_of_the_second_look_five() {
    let scene = free::Swings::default();
    let [coarse, fine] = [0.1, 0.05].map(|h| {
        let mut tried = Tried::new(&scene, h);
        [tried.estimate(h).0, tried.second_look(h, 0.0)]
    });
    for (i, order) in [4.0, 5.0].into_iter().enumerate() {
        let found = (coarse[i] / fine[i]).log2();
        assert!((found - order).abs() <= 0.2, "order {found:.2} for {order}");
    }
}

/// What the polynomial of the stages leaves of the equation between the first two of them, less what of it the estimate is, over N(μ) μ; in
/// tolerances of values between steps.
#[test]
fn analytic_second_look_is_the_residual_between_the_stages() {
    let (h, scene) = (0.1, free::Swings::default());
    let mut tried = Tried::new(&scene, h);
    tried.estimate(h);
    let stages = &tried.radau.stages;
    // integrals of the quadratic polynomial of accelerations by Simpson's rule, exact for it; twice for positions
    let a = |s: f64| (0..3).map(|i| through_nodes(s)[i] * stages.a[i][0]).sum::<f64>();
    let v = |s: f64| -0.5 + h * s / 6.0 * (a(0.0) + 4.0 * a(0.5 * s) + a(s));
    let x = |s: f64| 1.0 + h * s / 6.0 * (v(0.0) + 4.0 * v(0.5 * s) + v(s));
    assert!((v(NODES[1]) - (-0.5 + stages.v[1][0])).abs() <= 1e-14, "collocation");
    let residual = -scene.k * x(UNSEEN) - scene.c * v(UNSEEN) - M * a(UNSEEN);
    let mu = GAMMA / h;
    let left = residual / (M + scene.c / mu + scene.k / (mu * mu)) / mu + UNSEEN_REMAINDER * tried.radau.error.v[0];
    let expected = tried.size(0.0, left) * 1e-6_f64.powf(-0.25);
    let found = tried.second_look(h, 0.0);
    assert!((found / expected - 1.0).abs() <= 1e-6, "{found} {expected}");
    assert_eq!(tried.second_look(h, 2.0 * found), 2.0 * found, "the larger one counts");
    let both = tried.estimate(h).0.max(found);
    assert!((tried.error / both - 1.0).abs() <= ROUNDING || tried.error > 1.0, "{} {both}", tried.error);
}

/// x'' = −x from x = 1, x' = −1 ends at cos h − sin h and −sin h − cos h, and has the same error in every direction: in steps that resolve it, and the part
/// (3/h)² of it in those that damp it at once.
#[test]
fn analytic_error_of_oscillations_is_the_error_of_a_swing_at_any_step() {
    let scene = free::Swings { k: M, c: 0.0 };
    for h in [0.1_f64, 0.3, 1.0, 3.0, 10.0, 100.0, 1e4] {
        let mut tried = Tried::with_velocity(&scene, -1.0, h);
        tried.estimate(h);
        let missed = (tried.to.q[0] - (h.cos() - h.sin())).hypot(tried.to.v[0] + h.sin() + h.cos());
        // both weights are those of 1 m and 1 m/s
        let error = missed / (2e-6 * 6.0_f64.sqrt());
        let found = tried.radau.error_of_oscillations(h, TOLERANCE, f64::INFINITY) / values_over_estimate(TOLERANCE);
        let part = found / error * (h / 3.0).max(1.0).powi(2);
        assert!((0.5..2.5).contains(&part), "{h}: {found} {error}");
        assert_eq!(tried.radau.error_of_oscillations(h, TOLERANCE, 0.9 / values_over_estimate(TOLERANCE)), 0.0);
    }
}

/// A force that makes half of N(μ), c > m μ, hides what is left: for a step that is stiff by it the estimate counts.
#[test]
fn analytic_second_look_is_none_of_a_stiff_step() {
    let h = 0.01;
    for (share, is_stiff) in [(0.98, false), (1.02, true)] {
        let scene = free::Swings { k: 10.0, c: share * M * GAMMA / h };
        let mut tried = Tried::new(&scene, h);
        tried.estimate(h);
        assert_eq!(tried.second_look(h, 1e-9) == 1e-9, is_stiff, "{share} {}", tried.second_look(h, 0.0));
        let scene = free::Swings { k: share * M * (GAMMA / h).powi(2), c: 0.0 };
        let mut tried = Tried::new(&scene, h);
        tried.estimate(h);
        assert_eq!(tried.second_look(h, 1e-9) == 1e-9, is_stiff, "{share} {}", tried.second_look(h, 0.0));
    }
}

/// The end is that of the rational function of the method: for x' = z x/h with real z, (1 + 2z/5 + z²/20)/(1 − 3z/5 + 3z²/20 − z³/60); here of a
/// velocity that a damper holds back, whose work is what kinetic energy loses to order 5.
#[test]
fn analytic_step_of_a_damped_velocity_is_the_stability_function() {
    let (h, scene) = (0.4, free::Swings { k: 0.0, c: 6.0 });
    let tried = Tried::new(&scene, h);
    let z = -scene.c / M * h;
    let share = (1.0 + z * (0.4 + 0.05 * z)) / (1.0 - z * (0.6 - z * (0.15 - z / 60.0)));
    assert!((tried.to.v[0] + 0.5 * share).abs() <= 1e-14, "{}", tried.to.v[0]);
    // x' − x'₀ = −c/m (x − x₀)
    assert!((tried.to.q[0] - (1.0 - M / scene.c * (tried.to.v[0] + 0.5))).abs() <= 1e-14, "{}", tried.to.q[0]);
    assert!((tried.to.t - h).abs() <= 1e-16);
    let lost = 0.5 * M * (tried.to.v[0].powi(2) - 0.25);
    assert!((tried.to.work[0] - lost).abs() <= 1e-4 && lost < -0.2, "{} {lost}", tried.to.work[0]);
}

/// A hundredth of the time in which the state changes by its own size; a microsecond at least, and no longer than what is left.
#[test]
fn analytic_first_step_is_a_part_of_the_time_of_change() {
    let scene = free::Swings::default();
    let mut tried = Tried::new(&scene, 0.01);
    let first = |longest: f64, tried: &mut Tried<'_>| {
        tried.radau.first_step(
            Node { state: &tried.from, q_rate: &tried.from.v, a: &tried.a, rate: &[], power: &tried.power },
            longest,
            TOLERANCE,
        )
    };
    let ratio = tried.size(1.0, -0.5) / tried.size(-0.5, tried.a[0]);
    let found = first(10.0, &mut tried);
    assert!((found / (0.01 * ratio) - 1.0).abs() <= ROUNDING, "{found}");
    assert_eq!(first(1e-4, &mut tried), 1e-4);
    tried.a[0] = 1e12;
    assert_eq!(first(1.0, &mut tried), 1e-6);
    (tried.a[0], tried.from.v[0]) = (0.0, 0.0);
    assert_eq!(first(1.0, &mut tried), 1e-6, "nothing changes");
}

/// Largest change of a velocity that residuals beyond rounding make, over its tolerance.
#[test]
fn analytic_what_residuals_would_change_velocities_by() {
    let scene = free::Swings::default();
    let mut tried = Tried::new(&scene, 0.01);
    tried.radau.newton.residual = [vec![3.0, 0.0, -9.0], vec![-8.0, 1.0, 0.0], vec![0.0, 0.0, 2.0]];
    tried.radau.rounding = vec![2.0, 0.0, 1.0];
    tried.radau.weights = vec![1e9, 1e9, 1e9, 10.0, 10.0, 1.0];
    // of x (8 − 2)/4 · 10, of the angle (9 − 1)/1
    assert_eq!(tried.radau.unsolved(&[4.0, 4.0, 1.0], 0.5), 7.5);
    assert_eq!(tried.radau.unsolved(&[4.0, 4.0, 0.4], 0.5), 10.0);
    assert_eq!(tried.radau.unsolved(&[0.0, 0.0, 1.0], 0.5), 4.0, "without mass there is no velocity of its own");
}

/// Beside the slow motion of a stiff damper by 1e-8 m/s, a third of the tolerance of values between steps, accelerations are large: only their estimate without the filter
/// is. The Jacobians at the end of the step are then asked, too, which takes a factorisation.
#[test]
fn invariant_large_slopes_that_the_filter_hides_are_looked_at_again() {
    let (h, scene) = (0.1, free::Swings { k: 7.0, c: 1e6 });
    // c v + k x + m a = 0 with a = −k/c v
    let slow = -scene.k / (scene.c - M * scene.k / scene.c);
    let [on, beside] = [0.0, 1e-8].map(|by| {
        let mut tried = Tried::with_velocity(&scene, slow + by, h);
        let (filtered, unfiltered) = tried.estimate(h);
        assert!(tried.error < 1.0 && filtered < 1.0 && (unfiltered > 1.0) == (by > 0.0), "{filtered} {unfiltered}");
        tried.system.counters().factorizations
    });
    assert_eq!(beside, on + 1);
}

/// From x = 0, where the slope of −s x³ is zero: passes without it go further away each time. This step and the nineteen after it are solved with
/// slopes at every stage.
#[test]
fn regress_twenty_steps_have_slopes_at_every_stage_after_one_that_diverged() {
    let scene = free::Hits::default();
    let mut system = system_of(&scene, Backend::Auto).unwrap();
    let mut radau = Radau::new(&scene, 0).unwrap().unwrap();
    let mut from = State::zero(3, 0);
    from.v[0] = 1.0;
    let mut to = from.clone();
    let from = Node { state: &from, q_rate: &from.v, a: &[0.0; 3], rate: &[], power: &[] };
    radau.attempt(&mut system, from, 1.0, TOLERANCE, &mut to).unwrap();
    assert_eq!(radau.n_coupled, 19);
}
