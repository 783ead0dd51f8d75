//! Fits and searches with known answers.

use super::model::{Model, Runs};
use super::*;
use crate::__model as model;
use crate::dynamics::system_of;
use crate::integrate::Method;
use crate::linalg::Backend;
use crate::simulate::simulation;
use crate::simulate::{Run, SetupError};
use std::f64::consts::TAU;

model! {
    model Cart {
        param k: N/m = 8;
        param s = 1;
        param c: N*s/m = 0.4;
        body cart { mass: 2, inertia: 1 }
        slider rail: ground(0, 0) ~ cart(0, 0) along ground(1, 0);
        effect pull { force at cart(0, 0): (-k*s*cart.x - c*cart.vx, 0); }
        start aside { cart at (0.1, 0) velocity (0, 0); }
        scene glide { start aside; until 2 s; }
        scene swing { start aside; until 3 s; with pull; }
    }
}

model! {
    model Pendulum {
        param l: m = 0.8;
        param c: N*m*s = 0.05;
        body bob { mass: 1, inertia: 0.01 }
        hinge pin: ground(0, 0) ~ bob(-l, 0);
        gravity (0, -9.81);
        torque bob: -c*bob.omega;
        start aside { bob angle 0.3; at rest; }
        scene swing { start aside; until 4 s; }
    }
}

/// Numbers that look random, the same for the same seed (SplitMix64 of Steele, Lea and Flood, 2014).
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Normal, by the transformation of Box and Muller.
    fn normal(&mut self) -> f64 {
        let (u, v) = (1.0 - self.unit(), self.unit());
        (-2.0 * u.ln()).sqrt() * (TAU * v).cos()
    }
}

fn times(n: usize, end_s: f64) -> Vec<f64> {
    (1..=n).map(|i| end_s * i as f64 / n as f64).collect()
}

/// The cart on its spring with stiffness and damping.
fn swing(k: f64, c: f64, data: &Measured) -> Result<Run, SetupError> {
    let scene = cart::Swing { k, c, ..Default::default() };
    simulation(&scene).at(data.times().to_vec()).run()
}

/// x of the cart: an oscillation with damping from 0.1 m at rest.
fn swung(k: f64, c: f64, t: f64) -> f64 {
    let (m, x0) = (2.0, 0.1);
    let delta = c / (2.0 * m);
    let omega = (k / m - delta * delta).sqrt();
    x0 * (-delta * t).exp() * ((omega * t).cos() + delta / omega * (omega * t).sin())
}

/// Measured positions of the cart with k = 8 N/m and c = 0.4 N s/m, and errors of 1 mm.
fn noisy(seed: u64) -> Measured {
    let mut random = Random(seed);
    let times = times(30, 3.0);
    let values: Vec<f64> = times.iter().map(|t| swung(8.0, 0.4, *t) + 1e-3 * random.normal()).collect();
    Measured::new(times).column("cart.x", values)
}

fn stiffness_and_damping() -> [Free; 2] {
    [Free::new("k", 5.0).within(0.0, f64::INFINITY), Free::between("c", 0.0, 3.0)]
}

/// The glide is linear in time and exact to rounding; differences with a step of 1e-3 leave 1e-13 of it, the condition of the line a factor of ten.
const ROUNDING_OF_DIFFERENCES: f64 = 1e-10;
/// Values of t in the closed form of the test have ten digits.
const DIGITS_OF_T: f64 = 1e-8;

/// x = x₀ + v t: slope and intercept of a straight line (Draper and Smith, "Applied Regression Analysis", ch. 1).
#[test]
fn analytic_line_has_values_errors_and_intervals_of_regression() {
    let y = [1.1, 1.9, 3.2, 3.8, 5.3];
    let data = Measured::new(times(5, 2.0)).column("cart.x", y);
    let free = [Free::new("cart.x", 0.5), Free::new("cart.vx", 1.0)];
    let scene = cart::Glide::default();
    let run = |values: &[f64]| {
        let simulation = simulation(&scene).start("cart.x", values[0]).start("cart.vx", values[1]);
        simulation.at(data.times().to_vec()).run()
    };
    let fitted = Fit::new(free, &data, run).solve().unwrap();

    let t = data.times();
    let (t_mean, y_mean) = (t.iter().sum::<f64>() / 5.0, y.iter().sum::<f64>() / 5.0);
    let s_tt: f64 = t.iter().map(|t| (t - t_mean).powi(2)).sum();
    let s_ty: f64 = t.iter().zip(y).map(|(t, y)| (t - t_mean) * (y - y_mean)).sum();
    let slope = s_ty / s_tt;
    let intercept = y_mean - slope * t_mean;
    let sum: f64 = t.iter().zip(y).map(|(t, y)| (y - intercept - slope * t).powi(2)).sum();
    let s = (sum / 3.0).sqrt();
    let errors = [s * (1.0 / 5.0 + t_mean * t_mean / s_tt).sqrt(), s / s_tt.sqrt()];
    let quantile = 3.182_446_305_3; // t of 3 degrees of freedom, 0.975
    for ((estimate, value), error) in fitted.estimates.iter().zip([intercept, slope]).zip(errors) {
        assert!(
            (estimate.value - value).abs() <= ROUNDING_OF_DIFFERENCES * value.abs().max(1.0),
            "{estimate:?}, {value}"
        );
        assert!((estimate.standard_error / error - 1.0).abs() <= ROUNDING_OF_DIFFERENCES, "{estimate:?}, {error}");
        let half = estimate.interval.1 - estimate.value;
        assert!((half / (quantile * error) - 1.0).abs() <= DIGITS_OF_T, "{estimate:?}");
    }
    let correlation = -t_mean / (s_tt / 5.0 + t_mean * t_mean).sqrt();
    assert!((fitted.correlation[0][1] - correlation).abs() <= ROUNDING_OF_DIFFERENCES, "{fitted:?}");
    assert!((fitted.sum_of_squares / sum - 1.0).abs() <= ROUNDING_OF_DIFFERENCES);
    assert_eq!((fitted.end, fitted.degrees_of_freedom), (FitEnd::Converged, 3));
}

/// Errors of 1e-9 of the runs over the change of the angle by a parameter, of order one: a factor of ten for four seconds.
const OF_THE_RUNS: f64 = 1e-8;

#[test]
fn reference_pendulum_is_identified_from_exact_data() {
    let data = Measured::new(times(40, 4.0));
    let run = |l: f64, c: f64, times: &[f64]| {
        let scene = pendulum::Swing { l, c };
        simulation(&scene).at(times.to_vec()).run()
    };
    let truth = run(0.8, 0.05, data.times()).unwrap();
    let sampled = truth.column("bob.phi").unwrap();
    let data = data.column("bob.phi", &sampled[1..]);
    // starts up to three times off: their periods differ by a factor of √3
    for (length, damping) in [(1.15, 0.2), (0.27, 0.15), (2.4, 0.15), (2.4, 0.017)] {
        let positive = |name, start| Free::new(name, start).within(0.0, f64::INFINITY);
        let free = [positive("l", length), positive("c", damping)];
        let fitted = Fit::new(free, &data, |values| run(values[0], values[1], data.times())).solve().unwrap();
        let [l, c] = &fitted.estimates[..] else { panic!("{fitted:?}") };
        assert!((l.value - 0.8).abs() <= OF_THE_RUNS && (c.value - 0.05).abs() <= OF_THE_RUNS, "{fitted}");
        assert!(fitted.undetermined.is_empty() && fitted.end == FitEnd::Converged, "{fitted}");
    }
}

/// Truncation and runs leave ε^(2/3) = 1e-6 of a column each; a factor of ten for the constants of both.
const OF_DIFFERENCES: f64 = 1e-5;

#[test]
fn fd_jacobian_of_runs_is_that_of_sensitivities() {
    let data = noisy(1);
    let runs = Runs::new(|values: &[f64]| swing(values[0], values[1], &data));
    let free = stiffness_and_damping().to_vec();
    let mut model = Model { free, data: &data, runs, derivatives: None, tolerance: 1e-9 };
    let scene = cart::Swing::default();
    let start = system_of(&scene, Backend::Auto).unwrap().scene_start();
    let exact = sensitivities_at(&scene, &start, ["k", "c"], Method::dop853(1e-11), &data).unwrap();
    // the second time from a start that is five hundred times too large
    for start in [[5.0, 1.5], [4000.0, 200.0]] {
        for (free, start) in model.free.iter_mut().zip(start) {
            *free = Free::new(free.name.clone(), start).within(0.0, f64::INFINITY);
        }
        let by_differences = model.by_differences(&[8.0, 0.4]);
        for (exact, found) in exact.iter().zip(&by_differences) {
            let size = exact.iter().fold(0.0, |size: f64, d| size.max(d.abs()));
            for (exact, found) in exact.iter().zip(found) {
                assert!((exact - found).abs() <= OF_DIFFERENCES * size, "{found} for {exact}");
            }
        }
    }
}

/// The values of both fits are the least squares to the error of their derivatives, in parts of standard errors.
const OF_STANDARD_ERRORS: f64 = 1e-3;

#[test]
fn cross_fit_by_sensitivities_is_that_by_differences_and_of_the_closed_form() {
    let data = noisy(2);
    let by_differences = || Fit::new(stiffness_and_damping(), &data, |x| swing(x[0], x[1], &data));
    let first = by_differences().solve().unwrap();
    let second = by_differences().derivatives(|x| {
        let scene = cart::Swing { k: x[0], c: x[1], ..Default::default() };
        let start = system_of(&scene, Backend::Auto).ok()?.scene_start();
        sensitivities_at(&scene, &start, ["k", "c"], Method::dop853(1e-10), &data).ok()
    });
    let second = second.solve().unwrap();
    assert!(second.n_runs < first.n_runs, "{} and {} runs", second.n_runs, first.n_runs);
    for (first, second) in first.estimates.iter().zip(&second.estimates) {
        let apart = (first.value - second.value).abs() / first.standard_error;
        assert!(apart <= OF_STANDARD_ERRORS, "{first:?} {second:?}");
        assert!((first.standard_error / second.standard_error - 1.0).abs() <= OF_STANDARD_ERRORS);
    }
    // the gradient of the closed form's sum of squares vanishes there
    let at = |k: f64, c: f64| -> f64 { data.points().map(|point| (swung(k, c, point.t) - point.value).powi(2)).sum() };
    let (k, c) = (&first.estimates[0], &first.estimates[1]);
    let least = at(k.value, c.value);
    for (dk, dc) in [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)] {
        assert!(at(k.value + 0.01 * dk * k.standard_error, c.value + 0.01 * dc * c.standard_error) > least);
    }
}

/// 200 intervals of 95 %: 190 hold the truth, with a deviation of √(200 · 0.95 · 0.05) = 3.1; four of these.
const FEWEST_THAT_HOLD: usize = 178;

#[test]
fn analytic_intervals_hold_the_truth_as_often_as_they_say() {
    let mut held = [0, 0];
    for seed in 0..200 {
        let data = noisy(1000 + seed);
        let fitted = Fit::new(stiffness_and_damping(), &data, |x| swing(x[0], x[1], &data)).solve().unwrap();
        for ((held, estimate), truth) in held.iter_mut().zip(&fitted.estimates).zip([8.0, 0.4]) {
            *held += usize::from(estimate.interval.0 <= truth && truth <= estimate.interval.1);
        }
    }
    assert!(held.iter().all(|held| (FEWEST_THAT_HOLD..200).contains(held)), "{held:?} of 200");
}

#[test]
fn invariant_product_of_two_parameters_is_told_as_such() {
    let data = noisy(3);
    let free = [Free::new("k", 5.0), Free::new("s", 1.3), Free::new("c", 0.3)];
    let fitted = Fit::new(free, &data, |x| {
        let scene = cart::Swing { k: x[0], s: x[1], c: x[2] };
        simulation(&scene).at(data.times().to_vec()).run()
    });
    let fitted = fitted.solve().unwrap();
    assert_eq!(fitted.undetermined, [["k", "s"]], "{fitted}");
    let [k, s, c] = &fitted.estimates[..] else { panic!("{fitted:?}") };
    assert!(k.standard_error.is_infinite() && s.standard_error.is_infinite() && c.standard_error.is_finite());
    assert!(fitted.to_string().contains("do not determine `k` and `s` separately"), "{fitted}");
    assert!((k.value * s.value - 8.0).abs() < 0.5, "{fitted}");
}

#[test]
fn invariant_parameter_without_influence_is_named_alone() {
    let data = noisy(4);
    let free = [Free::new("k", 5.0), Free::new("unused", 2.0)];
    let fitted = Fit::new(free, &data, |x| swing(x[0], 0.4, &data)).solve().unwrap();
    assert_eq!(fitted.undetermined, [["unused"]], "{fitted}");
    assert!(fitted.estimates[0].standard_error.is_finite());
}

#[test]
fn invariant_region_of_failing_runs_does_not_end_the_fit() {
    let data = &noisy(5);
    let with = |fails: fn(f64) -> bool| {
        Fit::new([Free::new("k", 3.0)], data, move |x: &[f64]| {
            if fails(x[0]) {
                Err("no motion".to_owned())
            } else {
                swing(x[0], 0.4, data).map_err(|error| error.to_string())
            }
        })
        .solve()
    };
    let everywhere = with(|_| false).unwrap();
    // the first step from 3 N/m goes beyond 9
    let guarded = with(|k| !(2.9..8.5).contains(&k)).unwrap();
    let apart = (guarded.estimates[0].value - everywhere.estimates[0].value) / everywhere.estimates[0].standard_error;
    assert!(apart.abs() <= OF_STANDARD_ERRORS, "{guarded} {everywhere}");
    assert!(matches!(with(|_| true), Err(OptimiseError::Start { reason }) if reason == "no motion"));
}

#[test]
fn invariant_value_that_the_data_push_to_a_bound_is_told() {
    let data = noisy(6);
    let fitted = Fit::new([Free::between("k", 9.0, 20.0)], &data, |x| swing(x[0], 0.4, &data)).solve().unwrap();
    let k = &fitted.estimates[0];
    assert!(k.at_bound && (9.0..9.0 + 1e-4).contains(&k.value), "{fitted}");
}

#[test]
fn invariant_wrong_requests_say_what_is_missing() {
    let data = noisy(7);
    let short = |data: &Measured| {
        let scene = cart::Swing::default();
        Fit::new([Free::new("k", 8.0)], data, |_| simulation(&scene).run()).solve().unwrap_err().to_string()
    };
    assert!(short(&data).contains("call `.at(data.times().to_vec())`"), "{}", short(&data));
    let misspelt = Measured::new([3.0]).column("cart.z", [1.0]).column("cart.x", [1.0]);
    assert!(short(&misspelt).contains("did you mean"), "{}", short(&misspelt));
    let few = Fit::new(stiffness_and_damping(), &misspelt, |x| swing(x[0], x[1], &data)).solve();
    assert!(matches!(few, Err(OptimiseError::TooFewValues { n_values: 2, n_free: 2 })));
}

/// A run with two start values to look for: it glides from `x0` with `v`.
fn glide(values: &[f64]) -> Result<Run, SetupError> {
    let scene = cart::Glide::default();
    simulation(&scene).until(1.0).start("cart.x", values[0]).start("cart.vx", values[1]).run()
}

/// The function of Himmelblau less a slope: four minima, of which the slope makes that near (3, 2) the least.
fn four_valleys(run: &Run) -> f64 {
    let [x, y] = [run.first().coordinates[0], run.first().velocities[0]];
    (x * x + y - 11.0).powi(2) + (x + y * y - 7.0).powi(2) + 0.1 * ((x - 3.0).powi(2) + (y - 2.0).powi(2))
}

/// The polish ends when its simplex and the differences of its numbers are below 1e-8; a number that is quadratic leaves the root of it.
const OF_THE_POLISH: f64 = 1e-3;

#[test]
fn analytic_least_of_four_minima_is_found() {
    let free = || [Free::between("x", -6.0, 6.0), Free::between("v", -6.0, 6.0)];
    for seed in 0..5 {
        let found = Search::new(free(), glide).seed(seed).minimise(four_valleys).unwrap();
        assert!(
            (found.values[0] - 3.0).abs() <= OF_THE_POLISH && (found.values[1] - 2.0).abs() <= OF_THE_POLISH,
            "{found:?}"
        );
        let largest = Search::new(free(), glide).seed(seed).maximise(|run| -four_valleys(run)).unwrap();
        assert_eq!((&largest.values, largest.number), (&found.values, -found.number));
    }
}

/// x(1 s) = x₀ + v is largest in the corner.
#[test]
fn analytic_optimum_in_a_corner_is_told_with_its_bounds() {
    let free = [Free::between("x", -1.0, 2.0), Free::between("v", 0.0, 3.0)];
    let found = Search::new(free, glide).maximise_column("cart.x").unwrap();
    assert!((found.number - 5.0).abs() <= OF_THE_POLISH && found.at_bounds == ["x", "v"], "{found:?}");
}

#[test]
fn invariant_search_is_the_same_for_the_same_seed_on_one_core_and_on_two() {
    let on = |n_threads: usize, seed: u64| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(n_threads).build().unwrap();
        let free = [Free::between("x", -6.0, 6.0), Free::between("v", -6.0, 6.0)];
        pool.install(|| Search::new(free, glide).seed(seed).generations(5).minimise(four_valleys).unwrap())
    };
    let first = on(1, 7);
    assert_eq!(first, on(2, 7));
    assert_ne!(first.values, on(2, 8).values);
}

#[test]
fn invariant_failing_runs_count_as_worst() {
    let free = [Free::between("x", -1.0, 2.0), Free::between("v", 0.0, 3.0)];
    let guarded = |values: &[f64]| {
        if values[0] > 1.0 { Err("too far".to_owned()) } else { glide(values).map_err(|e| e.to_string()) }
    };
    let found = Search::new(free.clone(), guarded).maximise_column("cart.x").unwrap();
    assert!((found.number - 4.0).abs() <= OF_THE_POLISH && found.n_failed > 0, "{found:?}");
    let nowhere = Search::new(free.clone(), |_: &[f64]| Err("no way".to_owned())).minimise(four_valleys);
    assert!(matches!(&nowhere, Err(OptimiseError::NoRun { reason, .. }) if reason == "no way"), "{nowhere:?}");
    let unknown = Search::new(free, glide).maximise_column("cart.z").unwrap_err().to_string();
    assert!(unknown.contains("cart.z"), "{unknown}");
    let unbounded = Search::new([Free::new("x", 1.0)], glide).minimise(four_valleys);
    assert!(matches!(unbounded, Err(OptimiseError::Unbounded { name }) if name == "x"));
}
