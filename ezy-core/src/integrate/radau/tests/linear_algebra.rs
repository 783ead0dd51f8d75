//! The linear algebra of a step against differences of the equations of motion.

use super::super::coupled::Coupled;
use super::super::matrix::Matrices;
use super::super::newton::Newton;
use super::super::stages::Stages;
use super::super::tableau::{ALPHA, BETA, GAMMA, Triple};
use super::free;
use crate::dynamics::system_of;
use crate::dynamics::{Jacobians, ResidualPlaces, State, System};
use crate::integrate::family::Sizes;
use crate::linalg::Backend;
use crate::model::Scene;
use nalgebra::Complex;

crate::model! {
    /// A cart with a rod on a hinge, held by a spring and a damper; a motor turns the rod, and the cart is held by a force that follows it.
    pub model Carriages {
        param heavy: kg = 2;
        param stiff: N/m = 30;
        body cart { mass: heavy, inertia: 1 }
        body rod { mass: 1, inertia: 0.2 }
        slider rail: ground(0, 0) ~ cart(0, 0) along ground(1, 0);
        hinge pivot: cart(0.1, 0.2) ~ rod(-0.5, 0);
        spring ground(0, 0.3) ~ rod(0.2, 0.1): stiffness stiff, damping 4;
        effect wind {
            param drag: kg/m = 3;
            force at rod(0.5, 0): (-drag * rod.vx^2, drag * rod.vx * rod.vy * sin(rod.phi));
        }
        effect motor {
            param u: V = 3;
            param R: ohm = 2;
            param L: H = 0.05;
            param k: N*m/A = 0.6;
            param p: N/A = 0.9;
            param f: 1/s = 4;
            param g: m/(A*s) = 0.3;
            state current: A = 0.4 rate (u - R*current - k*(rod.omega - cart.phi * (1 rad/s)))/L;
            state lag: m = 0.2 rate f*(cart.x*cos(rod.phi) - lag) + g*current;
            torque rod: k*current + p*current*lag;
            force at cart(0, 0): (-stiff*lag, 0);
        }
        start here { cart at (0.4, 0) angle 0 velocity (0.7, 0); rod angle 0.5 rate 1.5; }
        scene once { start here; until 1 s; with wind; }
        scene driven { start here; until 1 s; with wind, motor; }
    }
}

crate::model! {
    /// A puck whose two constraints say the same at the angle 0.
    pub model Guided {
        param w: m = 1;
        body puck { mass: 1, inertia: 1 }
        constraint wall: puck.x = 0;
        constraint guide: puck.x + w * puck.phi^2 / 2 = 0;
        start here { puck at (0, 0) angle 0; at rest; }
        scene rests { start here; until 1 s; }
    }
}

const H: f64 = 0.05;

/// Central differences: rounding 1e-16 over a step of 1e-5 of numbers up to 1e2, and a third derivative of 1e2 times 1e-10.
const BY_DIFFERENCES: f64 = 1e-8;
const STEP: f64 = 1e-5;

/// Rounding of some eliminations of matrices with a condition of some thousands.
const ROUNDING: f64 = 1e-12;

/// A state with its accelerations, multipliers, rates and Jacobians.
struct At<'s> {
    system: System<&'s dyn Scene>,
    state: State,
    a: Vec<f64>,
    lambda: Vec<f64>,
    rates: Vec<f64>,
    jacobians: Jacobians,
}

impl<'s> At<'s> {
    fn start_of(scene: &'s dyn Scene) -> Self {
        let mut system = system_of(scene, Backend::Dense).unwrap();
        let start = system.scene_start();
        let state = system.consistent_start(&start).unwrap();
        let info = scene.info();
        let (mut a, mut lambda) = (vec![0.0; info.n_coordinates()], vec![0.0; info.n_rows()]);
        let State { t, q, v, z, .. } = &state;
        system.place_states(z);
        system.accelerations(*t, q, v, &mut a, &mut lambda).unwrap();
        let mut rates = vec![0.0; z.len()];
        system.state_rates(*t, q, v, &mut rates);
        let mut jacobians = Jacobians::zero(&info, &ResidualPlaces::of(scene).unwrap());
        system.at(*t, q).jacobians(v, &a, &lambda, &mut jacobians);
        Self { system, state, a, lambda, rates, jacobians }
    }

    fn matrices(&self) -> Matrices {
        let scene = self.system.scene();
        let mut matrices = Matrices::new(&scene.info(), &ResidualPlaces::of(scene).unwrap()).unwrap();
        matrices.write(self.system.mass_matrix(), &self.jacobians);
        assert!(matrices.factor(H));
        matrices
    }

    /// Numbers of coordinates, rows and states.
    fn sizes(&self) -> Sizes {
        Sizes::new(self.system.info(), 0)
    }

    /// Number of unknowns.
    fn n(&self) -> usize {
        self.a.len() + self.lambda.len() + self.rates.len()
    }

    /// The part of unknowns that are rates.
    fn rates_of<'x>(&self, unknowns: &'x [f64]) -> &'x [f64] {
        &unknowns[self.a.len() + self.lambda.len()..]
    }

    /// Minus the slope of the residual where q, v, z and (a, λ, z') change in these directions.
    fn falls(&mut self, [of_q, of_v, of_z]: [&[f64]; 3], of_unknowns: &[f64]) -> Vec<f64> {
        let along = |x: &[f64], by: f64, d: &[f64]| -> Vec<f64> { x.iter().zip(d).map(|(x, d)| x + by * d).collect() };
        let (of_a, rest) = of_unknowns.split_at(self.a.len());
        let (of_lambda, of_rates) = rest.split_at(self.lambda.len());
        let [before, behind] = [-STEP, STEP].map(|by| {
            let (q, v) = (along(&self.state.q, by, of_q), along(&self.state.v, by, of_v));
            let (a, lambda) = (along(&self.a, by, of_a), along(&self.lambda, by, of_lambda));
            let rates = along(&self.rates, by, of_rates);
            self.system.place_states(&along(&self.state.z, by, of_z));
            let mut residual = vec![0.0; of_unknowns.len()];
            self.system.at(self.state.t, &q).residual(&v, &a, &lambda, &rates, &mut residual);
            residual
        });
        before.iter().zip(behind).map(|(before, behind)| (before - behind) / (2.0 * STEP)).collect()
    }
}

/// Numbers without symmetry between -1 and 1.
fn numbers(n: usize, seed: f64) -> Vec<f64> {
    (1..=n).map(|i| 2.0 * (i as f64 * 0.618_034 + seed).fract() - 1.0).collect()
}

fn scaled(x: &[f64], by: f64) -> Vec<f64> {
    x.iter().map(|x| by * x).collect()
}

fn assert_close(found: &[f64], expected: &[f64], within: f64) {
    for (x, y) in found.iter().zip(expected) {
        assert!((x - y).abs() <= within * y.abs().max(1.0), "{found:?} {expected:?}");
    }
}

/// N(μ) is minus the slope of the residual where accelerations change velocities by 1/μ of themselves, and positions by 1/μ², and rates
/// change states by 1/μ.
fn solve_with_the_slope_of_the_residual<S: Scene>(scene: &S, within: f64) {
    let mut at = At::start_of(scene);
    let mut matrices = at.matrices();
    let n_q = at.a.len();
    let (mu, x) = (GAMMA / H, numbers(at.n(), 0.1));
    let (of_q, of_v) = (scaled(&x[..n_q], 1.0 / (mu * mu)), scaled(&x[..n_q], 1.0 / mu));
    let of_z = scaled(at.rates_of(&x), 1.0 / mu);
    let mut solution = at.falls([&of_q, &of_v, &of_z], &x);
    matrices.solve_real(&mut solution);
    assert_close(&solution, &x, within);

    let y = numbers(x.len(), 0.7);
    let length = Complex::new(H, 0.0) / Complex::new(ALPHA, BETA);
    let times = |factor: Complex<f64>| -> [Vec<f64>; 2] {
        let products = || x.iter().zip(&y).map(|(x, y)| factor * Complex::new(*x, *y));
        [products().map(|z| z.re).collect(), products().map(|z| z.im).collect()]
    };
    let (by_square, by_length, of_unknowns) = (times(length * length), times(length), times(Complex::new(1.0, 0.0)));
    let [re, im] = [0, 1].map(|i| {
        let of_z = at.rates_of(&by_length[i]).to_vec();
        at.falls([&by_square[i][..n_q], &by_length[i][..n_q], &of_z], &of_unknowns[i])
    });
    let mut solution: Vec<_> = re.into_iter().zip(im).map(|(re, im)| Complex::new(re, im)).collect();
    matrices.solve_complex(&mut solution);
    let [re, im] = [|z: &Complex<f64>| z.re, |z: &Complex<f64>| z.im].map(|of| solution.iter().map(of).collect());
    let (re, im): (Vec<f64>, Vec<f64>) = (re, im);
    assert_close(&re, &x, within);
    assert_close(&im, &y, within);
}

/// A dependent row is held by its small diagonal.
#[test]
fn analytic_matrices_with_a_dependent_row_are_regular() {
    let scene = guided::Rests::default();
    let mut system = system_of(&scene, Backend::Dense).unwrap();
    let places = ResidualPlaces::of(&scene).unwrap();
    let (info, zeros) = (scene.info(), [0.0; 3]);
    let mut jacobians = Jacobians::zero(&info, &places);
    system.at(0.0, &zeros).jacobians(&zeros, &zeros, &[0.0; 2], &mut jacobians);
    let mut matrices = Matrices::new(&info, &places).unwrap();
    matrices.write(system.mass_matrix(), &jacobians);
    assert!(matrices.factor(H));
}

#[test]
fn fd_factors_solve_with_the_slope_of_the_residual() {
    for heavy in [2.0, 2e4] {
        solve_with_the_slope_of_the_residual(&carriages::Once { heavy, ..Default::default() }, BY_DIFFERENCES * heavy);
        solve_with_the_slope_of_the_residual(
            &carriages::Driven { heavy, ..Default::default() },
            BY_DIFFERENCES * heavy,
        );
    }
}

/// What μ − J makes of a vector, where J are the slopes of (v, a, z') in (q, v, z), the filter takes back.
fn filter_divides_by_the_slopes_of_the_motion<S: Scene>(scene: &S) {
    let mut at = At::start_of(scene);
    let mut matrices = at.matrices();
    let (n_q, n_z, mu) = (at.a.len(), at.rates.len(), GAMMA / H);
    let (x, y, w) = (numbers(n_q, 0.3), numbers(n_q, 0.9), numbers(n_z, 0.5));
    let State { t, q, v, z, .. } = at.state.clone();
    let mut slopes_at = |by: f64| {
        let along = |from: &[f64], d: &[f64]| -> Vec<f64> { from.iter().zip(d).map(|(q, d)| q + by * d).collect() };
        let (mut a, mut lambda, mut rates) = (vec![0.0; n_q], at.lambda.clone(), vec![0.0; n_z]);
        let (q, v) = (along(&q, &x), along(&v, &y));
        at.system.place_states(&along(&z, &w));
        at.system.accelerations(t, &q, &v, &mut a, &mut lambda).unwrap();
        at.system.state_rates(t, &q, &v, &mut rates);
        [a, rates].concat()
    };
    let (before, behind) = (slopes_at(-STEP), slopes_at(STEP));
    let slopes: Vec<f64> = behind.iter().zip(before).map(|(b, a)| (b - a) / (2.0 * STEP)).collect();
    let times_mu_less =
        |x: &[f64], slopes: &[f64]| -> Vec<f64> { x.iter().zip(slopes).map(|(x, slope)| mu * x - slope).collect() };
    let mut of = at.state.clone();
    let mut buffer = vec![0.0; at.n()];
    // the real factors alone are enough for it
    for factor_again in [false, true] {
        assert!(!factor_again || matrices.factor_real(H));
        of.q = times_mu_less(&x, &y);
        of.v = times_mu_less(&y, &slopes[..n_q]);
        of.z = times_mu_less(&w, &slopes[n_q..]);
        matrices.filter(H, &mut of, &mut buffer);
        assert_close(&of.q, &x, BY_DIFFERENCES);
        assert_close(&of.v, &y, BY_DIFFERENCES);
        assert_close(&of.z, &w, BY_DIFFERENCES);
    }
}

#[test]
fn fd_filter_divides_by_the_slopes_of_the_motion() {
    filter_divides_by_the_slopes_of_the_motion(&carriages::Once::default());
    filter_divides_by_the_slopes_of_the_motion(&carriages::Driven::default());
}

#[test]
fn fd_slopes_along_a_change_of_a_state() {
    let scene = carriages::Driven::default();
    let mut at = At::start_of(&scene);
    let n_q = at.a.len();
    let of = State { q: numbers(n_q, 0.2), v: numbers(n_q, 0.4), z: numbers(2, 0.6), ..at.state.clone() };
    let n = at.n();
    let expected = scaled(&at.falls([&of.q, &of.v, &of.z], &vec![0.0; n]), -1.0);
    let mut found = vec![0.0; n];
    at.matrices().slope_along(&of, &mut found);
    // forces of 1e2
    assert_close(&found, &expected, 10.0 * BY_DIFFERENCES);
}

/// For m x'' + c x' + k x = 0 without rows: ten roundings of k x, c v and m a.
#[test]
fn analytic_rounding_is_that_of_the_terms_of_the_equations() {
    let scene = free::Swings::default();
    let at = At::start_of(&scene);
    let mut rounding = vec![0.0; 3];
    let of = State { q: vec![2.0, 0.0, 0.0], v: vec![-3.0, 0.0, 0.0], ..at.state.clone() };
    at.matrices().rounding_along(&of, [&[5.0, 0.0, 0.0], &[], &[]], &mut rounding);
    let expected = 10.0 * f64::EPSILON * (7.0 * 2.0 + 0.5 * 3.0 + 4.0 * 5.0);
    assert!((rounding[0] / expected - 1.0).abs() <= ROUNDING && rounding[1..] == [0.0; 2], "{rounding:?}");
    // of a current: R/L i, k/L ω, k/L rad/s φ and the rate
    let scene = carriages::Driven::default();
    let at = At::start_of(&scene);
    let (mut q, mut v, mut rounding) = (vec![0.0; 6], vec![0.0; 6], vec![0.0; 8]);
    (q[2], v[5]) = (-0.3, 7.0);
    let of = State { q, v, z: vec![-2.0, 0.0], ..at.state.clone() };
    at.matrices().rounding_along(&of, [&[0.0; 6], &[0.0; 4], &[11.0, 0.0]], &mut rounding);
    let expected = 10.0 * f64::EPSILON * (2.0 / 0.05 * 2.0 + 0.6 / 0.05 * (7.0 + 0.3) + 11.0);
    assert!((rounding[6] / expected - 1.0).abs() <= ROUNDING, "{rounding:?}");
}

/// With the same Jacobians at all stages, the equations of all stages together and those that a transformation takes apart are the same: one
/// pass of either gives the same stages and the same size of their changes.
fn coupled_and_transformed_stages_agree<S: Scene>(scene: &S, heavy: f64) {
    let at = At::start_of(scene);
    let (n_q, n_z) = (at.a.len(), at.rates.len());
    let (info, places) = (scene.info(), ResidualPlaces::of(scene).unwrap());
    let residual: Triple<Vec<f64>> = [0.15, 0.35, 0.55].map(|seed| numbers(at.n(), seed));
    let weights: Vec<f64> = (1..=2 * n_q + n_z).map(|i| 10.0 * i as f64).collect();
    let mut one = Stages::zero(at.sizes());
    one.hold(&at.a, &at.lambda, &at.rates);
    one.follow(&at.state.v, H);
    let mut other = one.clone();

    let mut newton = Newton::new(at.n());
    newton.residual = residual.clone();
    let change = newton.improve(&mut at.matrices(), &mut one, H, &weights);

    let mut coupled = Coupled::new(&info, &places).unwrap();
    coupled.jacobians = at.jacobians.clone();
    (0..3).for_each(|i| coupled.write(i, H, at.system.mass_matrix()));
    let other_change = coupled.improve(&residual, &mut other, H, &weights);

    // both are damped by 1e-11, each in its own scale
    let within = 1e-9 * heavy;
    for i in 0..3 {
        assert_close(&other.a[i], &one.a[i], within);
        assert_close(&other.lambda[i], &one.lambda[i], within);
        assert_close(&other.v[i], &one.v[i], within);
        assert_close(&other.q[i], &one.q[i], within);
        assert_close(&other.rates[i], &one.rates[i], within);
        assert_close(&other.z[i], &one.z[i], within);
    }
    assert!((other_change / change - 1.0).abs() <= within, "{change} {other_change}");
    // root mean square of what changed, over what is tolerated
    let mut start = Stages::zero(at.sizes());
    start.hold(&at.a, &at.lambda, &at.rates);
    start.follow(&at.state.v, H);
    let mut squares = 0.0;
    for i in 0..3 {
        for j in 0..n_q {
            squares += ((one.q[i][j] - start.q[i][j]) * weights[j]).powi(2);
            squares += ((one.v[i][j] - start.v[i][j]) * weights[n_q + j]).powi(2);
        }
        for j in 0..n_z {
            squares += ((one.z[i][j] - start.z[i][j]) * weights[2 * n_q + j]).powi(2);
        }
    }
    let mean = (squares / (3 * weights.len()) as f64).sqrt();
    assert!((change / mean - 1.0).abs() <= 1e-9, "{change} {mean}");
}

#[test]
fn cross_coupled_and_transformed_stages_agree() {
    for heavy in [2.0, 2e4] {
        coupled_and_transformed_stages_agree(&carriages::Once { heavy, ..Default::default() }, heavy);
        coupled_and_transformed_stages_agree(&carriages::Driven { heavy, ..Default::default() }, heavy);
    }
}

/// Constant accelerations and rates: the stages stand where the parabola does, states and works grow, and the next step's stages are foreseen.
#[test]
fn analytic_stages_of_constant_acceleration_lie_on_a_parabola() {
    let nodes = [0.4 - 0.1 * 6.0_f64.sqrt(), 0.4 + 0.1 * 6.0_f64.sqrt(), 1.0];
    let mut stages = Stages::zero(Sizes { n_q: 1, n_v: 1, n_c: 1, n_z: 1, n_works: 1 });
    stages.hold(&[3.0], &[7.0], &[-6.0]);
    stages.follow(&[-2.0], 0.5);
    stages.add_works(&[vec![4.0], vec![4.0], vec![4.0]], 0.5);
    let mut start = State::zeros([1; 2], 1, 1);
    (start.q[0], start.v[0], start.z[0]) = (10.0, -2.0, 20.0);
    for (i, c) in nodes.into_iter().enumerate() {
        let t = 0.5 * c;
        let (mut q, mut v, mut z) = ([0.0], [0.0], [0.0]);
        stages.write_state(i, &start, [&mut q, &mut v, &mut z]);
        assert_close(
            &[q[0], v[0], z[0], stages.work[i][0]],
            &[10.0 - 2.0 * t + 1.5 * t * t, -2.0 + 3.0 * t, 20.0 - 6.0 * t, 4.0 * t],
            ROUNDING,
        );
    }
    // accelerations, multipliers and rates that are quadratic in time go on being so, over a step twice as long
    let quadratic = |t: f64| 1.0 + t * (2.0 - 3.0 * t);
    for (i, c) in nodes.into_iter().enumerate() {
        (stages.a[i][0], stages.lambda[i][0]) = (quadratic(0.5 * c), -quadratic(0.5 * c));
        stages.rates[i][0] = 2.0 * quadratic(0.5 * c);
    }
    let mut next = Stages::zero(Sizes { n_q: 1, n_v: 1, n_c: 1, n_z: 1, n_works: 1 });
    next.extrapolate(&stages, 2.0);
    for (i, c) in nodes.into_iter().enumerate() {
        let expected = quadratic(0.5 + c);
        let found = [next.a[i][0], next.lambda[i][0], next.rates[i][0]];
        assert_close(&found, &[expected, -expected, 2.0 * expected], ROUNDING * 10.0);
    }
}
