//! The linear algebra of a step against differences of the equations of motion.

use super::super::coupled::Coupled;
use super::super::matrix::Matrices;
use super::super::newton::Newton;
use super::super::stages::Stages;
use super::super::tableau::{ALPHA, BETA, GAMMA, Triple};
use super::free;
use crate::dynamics::{Jacobians, State, System};
use crate::linalg::Backend;
use crate::model::{Derived as _, Scene};
use nalgebra::Complex;

crate::model! {
    /// A cart with a rod on a hinge, held by a spring and a damper.
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
        start here { cart at (0.4, 0) angle 0 velocity (0.7, 0); rod angle 0.5 rate 1.5; }
        scene once { start here; until 1 s; with wind; }
    }
}

const H: f64 = 0.05;

/// Central differences: rounding 1e-16 over a step of 1e-5 of numbers up to 1e2, and a third derivative of 1e2 times 1e-10.
const BY_DIFFERENCES: f64 = 1e-8;
const STEP: f64 = 1e-5;

/// Rounding of some eliminations of matrices with a condition of some thousands.
const ROUNDING: f64 = 1e-12;

/// A state with its accelerations, multipliers and Jacobians.
struct At<'s, S: Scene> {
    system: System<&'s S>,
    state: State,
    a: Vec<f64>,
    lambda: Vec<f64>,
    jacobians: Jacobians,
}

impl<'s, S: Scene> At<'s, S> {
    fn start_of(scene: &'s S) -> Self {
        let mut system = System::new(scene, Backend::Dense).unwrap();
        let start = system.scene_start();
        let state = system.consistent_start(&start).unwrap();
        let info = scene.info();
        let (mut a, mut lambda) = (vec![0.0; info.n_coordinates()], vec![0.0; info.n_rows()]);
        let State { t, q, v, .. } = &state;
        system.accelerations(*t, q, v, &mut a, &mut lambda).unwrap();
        let mut jacobians = Jacobians::zero(&info, &scene.jacobian_places().unwrap());
        system.jacobians(*t, q, v, &a, &lambda, &mut jacobians);
        Self { system, state, a, lambda, jacobians }
    }

    fn matrices(&self) -> Matrices {
        let scene = self.system.scene();
        let mut matrices = Matrices::new(&scene.info(), &scene.jacobian_places().unwrap()).unwrap();
        matrices.write(self.system.mass_matrix(), &self.jacobians);
        assert!(matrices.factor(H));
        matrices
    }

    /// Minus the slope of the residual where q, v and (a, λ) change in these directions.
    fn falls(&mut self, of_q: &[f64], of_v: &[f64], of_a: &[f64]) -> Vec<f64> {
        let along = |x: &[f64], by: f64, d: &[f64]| -> Vec<f64> { x.iter().zip(d).map(|(x, d)| x + by * d).collect() };
        let n_q = self.a.len();
        let [before, behind] = [-STEP, STEP].map(|by| {
            let (q, v) = (along(&self.state.q, by, of_q), along(&self.state.v, by, of_v));
            let (a, lambda) = (along(&self.a, by, &of_a[..n_q]), along(&self.lambda, by, &of_a[n_q..]));
            let mut residual = vec![0.0; of_a.len()];
            self.system.residual(self.state.t, &q, &v, &a, &lambda, &mut residual);
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

/// N(μ) is minus the slope of the residual where accelerations change velocities by 1/μ of themselves, and positions by 1/μ².
#[test]
fn fd_factors_solve_with_the_slope_of_the_residual() {
    for heavy in [2.0, 2e4] {
        let scene = carriages::Once { heavy, ..Default::default() };
        let mut at = At::start_of(&scene);
        let mut matrices = at.matrices();
        let n_q = at.a.len();
        let (mu, x) = (GAMMA / H, numbers(n_q + at.lambda.len(), 0.1));
        let mut solution = at.falls(&scaled(&x[..n_q], 1.0 / (mu * mu)), &scaled(&x[..n_q], 1.0 / mu), &x);
        matrices.solve_real(&mut solution);
        assert_close(&solution, &x, BY_DIFFERENCES * heavy);

        let y = numbers(x.len(), 0.7);
        let length = Complex::new(H, 0.0) / Complex::new(ALPHA, BETA);
        let times = |factor: Complex<f64>| -> [Vec<f64>; 2] {
            let products = || x.iter().zip(&y).map(|(x, y)| factor * Complex::new(*x, *y));
            [products().map(|z| z.re).collect(), products().map(|z| z.im).collect()]
        };
        let (of_q, of_v, of_a) = (times(length * length), times(length), times(Complex::new(1.0, 0.0)));
        let [re, im] = [0, 1].map(|i| at.falls(&of_q[i][..n_q], &of_v[i][..n_q], &of_a[i]));
        let mut solution: Vec<_> = re.into_iter().zip(im).map(|(re, im)| Complex::new(re, im)).collect();
        matrices.solve_complex(&mut solution);
        let [re, im] = [|z: &Complex<f64>| z.re, |z: &Complex<f64>| z.im].map(|of| solution.iter().map(of).collect());
        let (re, im): (Vec<f64>, Vec<f64>) = (re, im);
        assert_close(&re, &x, BY_DIFFERENCES * heavy);
        assert_close(&im, &y, BY_DIFFERENCES * heavy);
    }
}

/// The filter divides by μ − J, where J are the slopes of (v, a) in (q, v): what μ − J makes of a vector, it takes back.
#[test]
fn fd_filter_divides_by_the_slopes_of_the_motion() {
    let scene = carriages::Once::default();
    let mut at = At::start_of(&scene);
    let mut matrices = at.matrices();
    let (n_q, mu) = (at.a.len(), GAMMA / H);
    let (x, y) = (numbers(n_q, 0.3), numbers(n_q, 0.9));
    let State { t, q, v, .. } = at.state.clone();
    let mut accelerations = |by: f64| {
        let along = |from: &[f64], d: &[f64]| -> Vec<f64> { from.iter().zip(d).map(|(q, d)| q + by * d).collect() };
        let (mut a, mut lambda) = (vec![0.0; n_q], at.lambda.clone());
        at.system.accelerations(t, &along(&q, &x), &along(&v, &y), &mut a, &mut lambda).unwrap();
        a
    };
    let slopes: Vec<f64> =
        accelerations(STEP).iter().zip(accelerations(-STEP)).map(|(b, a)| (b - a) / (2.0 * STEP)).collect();
    let mut of_q: Vec<f64> = x.iter().zip(&y).map(|(x, y)| mu * x - y).collect();
    let mut of_v: Vec<f64> = y.iter().zip(&slopes).map(|(y, slope)| mu * y - slope).collect();
    let mut buffer = vec![0.0; n_q + at.lambda.len()];
    matrices.filter(H, &mut of_q, &mut of_v, &mut buffer);
    assert_close(&of_q, &x, BY_DIFFERENCES);
    assert_close(&of_v, &y, BY_DIFFERENCES);
    // the real factors alone are enough for it
    assert!(matrices.factor_real(H));
    let (mut of_q, mut of_v) = (scaled(&x, mu), scaled(&y, mu));
    of_q.iter_mut().zip(&y).for_each(|(q, y)| *q -= y);
    of_v.iter_mut().zip(&slopes).for_each(|(v, slope)| *v -= slope);
    matrices.filter(H, &mut of_q, &mut of_v, &mut buffer);
    assert_close(&of_q, &x, BY_DIFFERENCES);
    assert_close(&of_v, &y, BY_DIFFERENCES);
}

#[test]
fn fd_slopes_along_a_change_of_positions_and_velocities() {
    let scene = carriages::Once::default();
    let mut at = At::start_of(&scene);
    let n_q = at.a.len();
    let (x, y) = (numbers(n_q, 0.2), numbers(n_q, 0.4));
    let n = n_q + at.lambda.len();
    let expected = scaled(&at.falls(&x, &y, &vec![0.0; n]), -1.0);
    let mut found = vec![0.0; n];
    at.matrices().slope_along(&x, &y, &mut found);
    // forces of 1e2
    assert_close(&found, &expected, 10.0 * BY_DIFFERENCES);
}

/// For m x'' + c x' + k x = 0 without rows: ten roundings of k x, c v and m a.
#[test]
fn analytic_rounding_is_that_of_the_terms_of_the_equations() {
    let scene = free::Swings::default();
    let at = At::start_of(&scene);
    let mut rounding = vec![0.0; 3];
    at.matrices().rounding_along(&[2.0, 0.0, 0.0], &[-3.0, 0.0, 0.0], &[5.0, 0.0, 0.0], &[], &mut rounding);
    let expected = 10.0 * f64::EPSILON * (7.0 * 2.0 + 0.5 * 3.0 + 4.0 * 5.0);
    assert!((rounding[0] / expected - 1.0).abs() <= ROUNDING && rounding[1..] == [0.0; 2], "{rounding:?}");
}

/// With the same Jacobians at all stages, the equations of all stages together and those that a transformation takes apart are the same: one
/// pass of either gives the same stages and the same size of their changes.
#[test]
fn cross_coupled_and_transformed_stages_agree() {
    for heavy in [2.0, 2e4] {
        let scene = carriages::Once { heavy, ..Default::default() };
        let at = At::start_of(&scene);
        let (n_q, n_c) = (at.a.len(), at.lambda.len());
        let (info, places) = (scene.info(), scene.jacobian_places().unwrap());
        let residual: Triple<Vec<f64>> = [0.15, 0.35, 0.55].map(|seed| numbers(n_q + n_c, seed));
        let weights: Vec<f64> = (1..=2 * n_q).map(|i| 10.0 * i as f64).collect();
        let mut one = Stages::zero(n_q, n_c, 0);
        one.hold(&at.a, &at.lambda);
        one.follow(&at.state.v, H);
        let mut other = one.clone();

        let mut newton = Newton::new(n_q + n_c);
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
        }
        assert!((other_change / change - 1.0).abs() <= within, "{change} {other_change}");
        // root mean square of what changed, over what is tolerated
        let mut start = Stages::zero(n_q, n_c, 0);
        start.hold(&at.a, &at.lambda);
        start.follow(&at.state.v, H);
        let mut squares = 0.0;
        for i in 0..3 {
            for j in 0..n_q {
                squares += ((one.q[i][j] - start.q[i][j]) * weights[j]).powi(2);
                squares += ((one.v[i][j] - start.v[i][j]) * weights[n_q + j]).powi(2);
            }
        }
        let mean = (squares / (6 * n_q) as f64).sqrt();
        assert!((change / mean - 1.0).abs() <= 1e-9, "{change} {mean}");
    }
}

/// Constant accelerations: the stages stand where the parabola does, works grow with the power, and the next step's stages are foreseen.
#[test]
fn analytic_stages_of_constant_acceleration_lie_on_a_parabola() {
    let nodes = [0.4 - 0.1 * 6.0_f64.sqrt(), 0.4 + 0.1 * 6.0_f64.sqrt(), 1.0];
    let mut stages = Stages::zero(1, 1, 1);
    stages.hold(&[3.0], &[7.0]);
    stages.follow(&[-2.0], 0.5);
    stages.add_works(&[vec![4.0], vec![4.0], vec![4.0]], 0.5);
    let mut start = State::zero(1, 1);
    (start.q[0], start.v[0]) = (10.0, -2.0);
    for (i, c) in nodes.into_iter().enumerate() {
        let t = 0.5 * c;
        let (mut q, mut v) = ([0.0], [0.0]);
        stages.write_state(i, &start, &mut q, &mut v);
        assert_close(
            &[q[0], v[0], stages.work[i][0]],
            &[10.0 - 2.0 * t + 1.5 * t * t, -2.0 + 3.0 * t, 4.0 * t],
            ROUNDING,
        );
    }
    // accelerations and multipliers that are quadratic in time go on being so, over a step twice as long
    let quadratic = |t: f64| 1.0 + t * (2.0 - 3.0 * t);
    for (i, c) in nodes.into_iter().enumerate() {
        (stages.a[i][0], stages.lambda[i][0]) = (quadratic(0.5 * c), -quadratic(0.5 * c));
    }
    let mut next = Stages::zero(1, 1, 1);
    next.extrapolate(&stages, 2.0);
    for (i, c) in nodes.into_iter().enumerate() {
        let expected = quadratic(0.5 + c);
        assert_close(&[next.a[i][0], next.lambda[i][0]], &[expected, -expected], ROUNDING * 10.0);
    }
}
