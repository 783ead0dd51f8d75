//! Errors, first step and stability of a step, against closed forms.

use super::*;

/// x'' = −w² x − c x' + f(t) for the first coordinate, x'' = 0 for the second; the power is x' times 3.
struct Swing {
    w: f64,
    c: f64,
}

impl Dynamics<f64> for Swing {
    fn accelerations(&mut self, _: f64, q: &[f64], v: &[f64], a: &mut [f64], _: &mut [f64]) -> Result<(), MotionError> {
        a.copy_from_slice(&[-self.w * self.w * q[0] - self.c * v[0], 0.0]);
        Ok(())
    }

    fn position_rates(&self, _: &[f64], v: &[f64], out: &mut [f64]) {
        out.copy_from_slice(v);
    }

    fn place_states(&mut self, _: &[f64]) {}

    fn state_rates(&self, _: f64, _: &[f64], _: &[f64], _: &mut [f64]) {}

    fn power(&self, _: f64, _: &[f64], v: &[f64], _: &[f64], out: &mut [f64]) {
        out.fill(3.0 * v[0]);
    }

    fn project_onto_null_space(&mut self, t: f64, q: &[f64], x: &mut [f64]) -> bool {
        x[0] = 0.0;
        t == 7.0 && q[0] > 0.0
    }
}

const TOLERANCE: Tolerance = Tolerance::new(1e-3, 1e-2);

/// Rounding of some tens of operations.
const ROUNDING: f64 = 1e-12;

/// Of the numbers of one body (x, y, φ and their rates) the angle alone has the tolerance of angles.
#[test]
fn analytic_tolerance_of_angles_is_none_of_their_rates() {
    let tolerance = Tolerance { angle: Some(1e-9), ..TOLERANCE };
    let found: Vec<f64> = (0..6).map(|i| scale_of(tolerance, i, 3, 2.0)).collect();
    let other = 1e-2 + 1e-3 * 2.0;
    assert_eq!(found, [other, other, 1e-9, other, other, other]);
}

fn close(x: f64, y: f64) {
    assert!((x - y).abs() <= ROUNDING * y.abs().max(1.0), "{x} {y}");
}

fn state(q: f64, v: f64) -> State {
    State { t: 0.5, q: vec![q, 0.0], v: vec![v, 0.0], z: Vec::new(), work: vec![0.0] }
}

/// Numbers of a step as they stand in blocks: two positions, two velocities, a work and zeros.
fn blocks(x: [f64; 5]) -> Vec<Block<f64>> {
    vec![[x[0], x[1], x[2], x[3]], [x[4], 0.0, 0.0, 0.0]]
}

/// With the errors e₅, e₃ and e₆ over their tolerances: h E/√(n (E + 0.01 |e₃|²)), where E is the larger one of |e₅|² and |e₆|². The error of a
/// work does not count.
#[test]
fn analytic_error_is_that_of_orders_five_and_three() {
    let mut method = Dop853::<f64>::new(Sizes { n_q: 2, n_v: 2, n_c: 0, n_z: 0, n_works: 1 });
    method.start = blocks([1.0, 0.0, -2.0, 0.0, 0.0]);
    method.stage = blocks([-3.0, 0.0, 1.0, 0.0, 0.0]);
    let (q, v) = (0.01 + 0.003, 0.01 + 0.002);
    let square = |x: f64, y: f64| (x / q).powi(2) + (y / v).powi(2);
    for sixes in [[0.001, 0.0, 0.002, 0.0, 50.0], [0.5, 0.0, 0.1, 0.0, 50.0]] {
        method.errors = [blocks([0.1, 0.0, 0.2, 0.0, 90.0]), blocks([2.0, 0.0, -1.0, 0.0, 70.0]), blocks(sixes)];
        let (five, three, six) = (square(0.1, 0.2), square(2.0, 1.0), square(sixes[0], sixes[2]));
        let expected = |five: f64| 0.5 * five / (4.0 * (five + 0.01 * three)).sqrt();
        close(method.weighted_error(-0.5, TOLERANCE), expected(five.max(six)));
        close(method.error_of_order_5(-0.5, TOLERANCE), 0.5 * (five / 4.0).sqrt());
    }
    method.errors = [blocks([0.0; 5]), blocks([0.0; 5]), blocks([0.0; 5])];
    assert_eq!(method.weighted_error(0.5, TOLERANCE), 0.0);
}

/// Below a tolerance of 1e-11 sixth differences are rounding, and do not count.
#[test]
fn analytic_sixth_differences_count_above_rounding() {
    let mut method = Dop853::<f64>::new(Sizes { n_q: 1, n_v: 1, n_c: 0, n_z: 0, n_works: 0 });
    (method.start, method.stage) = (vec![[1.0, -2.0, 0.0, 0.0]], vec![[-3.0, 1.0, 0.0, 0.0]]);
    method.errors = [0.1, 2.0, 0.5].map(|x| vec![[3.0 * x, 2.0 * x, 0.0, 0.0]]);
    for (relative, larger) in [(0.9e-11, 0.1_f64), (1.1e-11, 0.5)] {
        // errors over their tolerances are 0.1, 2 and 0.5 over the relative one
        let (five, three) = (2.0 * (larger / relative).powi(2), 2.0 * (2.0 / relative).powi(2));
        let expected = 0.5 * five / (2.0 * (five + 0.01 * three)).sqrt();
        let found = method.weighted_error(0.5, Tolerance::new(relative, 0.0));
        assert!((found / expected - 1.0).abs() <= ROUNDING, "{relative:e}: {found} {expected}");
    }
}

/// Errors that a projection at the end removes do not count.
#[test]
fn analytic_tangential_error_leaves_out_what_projection_removes() {
    let mut method = Dop853::<f64>::new(Sizes { n_q: 2, n_v: 2, n_c: 0, n_z: 0, n_works: 1 });
    let errors = |first: f64| [0.1, 0.2, 0.3].map(|x| blocks([first * x, x, first * x, 2.0 * x, 0.0]));
    method.errors = errors(0.0);
    let expected = method.weighted_error(0.5, TOLERANCE);
    method.errors = errors(1e3);
    let mut end = state(1.0, 0.0);
    assert_eq!(method.tangential_error(&mut Swing { w: 1.0, c: 0.0 }, 0.5, TOLERANCE, &end), None);
    end.t = 7.0;
    assert_eq!(method.tangential_error(&mut Swing { w: 1.0, c: 0.0 }, 0.5, TOLERANCE, &end), Some(expected));
}

/// Hairer's first step: with d₀, d₁, d₂ the sizes of the state, its slope and that of its change over an Euler step of 0.01 d₀/d₁, the eighth
/// root of 0.01/max(d₁, d₂), at most a hundred such steps.
#[test]
fn analytic_first_step_is_that_of_the_slope_and_its_change() {
    let first = |q: f64, v: f64, longest: f64, swing: &mut Swing| {
        let from = state(q, v);
        let a = [-swing.w * swing.w * q - swing.c * v, 0.0];
        let node = Node { state: &from, q_rate: &from.v, a: &a, rate: &[], power: &[0.0] };
        Dop853::<f64>::new(Sizes { n_q: 2, n_v: 2, n_c: 0, n_z: 0, n_works: 1 })
            .first_step(swing, node, longest, TOLERANCE)
            .unwrap()
    };
    for (w, q, v) in [(3.0_f64, 1.0_f64, 0.5_f64), (0.1, 1.0, 0.5), (200.0, 0.2, -4.0)] {
        let size = |x: f64, y: f64| {
            let of = |x: f64, at: f64| x / (0.01 + 1e-3 * at.abs());
            ((of(x, q).powi(2) + of(y, v).powi(2)) / 4.0).sqrt()
        };
        let a = -w * w * q;
        let (d0, d1) = (size(q, v), size(v, a));
        let guess = 0.01 * d0 / d1;
        // an Euler step changes the slopes (v, −w² x) by (a, −w² v) times its length
        let d2 = size(a, -w * w * v);
        let expected = (0.01 / d1.max(d2)).powf(0.125).min(100.0 * guess);
        let found = first(q, v, 10.0, &mut Swing { w, c: 0.0 });
        assert!((found / expected - 1.0).abs() <= 1e-9, "{found} {expected}");
        assert_eq!(first(q, v, 1e-4, &mut Swing { w, c: 0.0 }), 1e-4);
    }
    // from rest at zero nothing tells a length: a microsecond, and a hundred of them when nothing changes
    assert_eq!(first(0.0, 0.0, 1.0, &mut Swing { w: 1.0, c: 0.0 }), 1e-6);
}

/// The slope of x' = −c x' − w² x changes by its matrix times what the state changes by: with w = 1 and c = 0 that is as long, and with a large c
/// nearly c times as long.
#[test]
fn analytic_stability_is_the_step_times_the_largest_eigenvalue() {
    for (swing, h, expected, within) in
        [(Swing { w: 1.0, c: 0.0 }, 0.1, 0.1, 1e-9), (Swing { w: 0.0, c: 50.0 }, 0.1, 5.0, 1e-3)]
    {
        let mut swing = swing;
        let mut method = Dop853::<f64>::new(Sizes { n_q: 2, n_v: 2, n_c: 0, n_z: 0, n_works: 1 });
        let (from, mut to) = (state(1.0, 0.7), state(0.0, 0.0));
        let mut a = [0.0; 2];
        swing.accelerations(0.5, &from.q, &from.v, &mut a, &mut []).unwrap();
        method
            .attempt(
                &mut swing,
                Node { state: &from, q_rate: &from.v, a: &a, rate: &[], power: &[2.1] },
                h,
                TOLERANCE,
                &mut to,
            )
            .unwrap();
        method.accept();
        assert!((to.t - 0.5 - h).abs() <= 1e-16);
        // 3 x' works as much as x goes
        close(to.work[0], 3.0 * (to.q[0] - 1.0));
        swing.accelerations(to.t, &to.q, &to.v, &mut a, &mut []).unwrap();
        let found = method.stability(h, Node { state: &to, q_rate: &to.v, a: &a, rate: &[], power: &[0.0] });
        assert!((found / expected - 1.0).abs() <= within, "{found} {expected}");
    }
    // nothing moves: no eigenvalue shows
    let (mut method, rest) =
        (Dop853::<f64>::new(Sizes { n_q: 2, n_v: 2, n_c: 0, n_z: 0, n_works: 1 }), state(0.0, 0.0));
    assert_eq!(
        method.stability(0.1, Node { state: &rest, q_rate: &rest.v, a: &[0.0; 2], rate: &[], power: &[0.0] }),
        0.0
    );
}

/// The polynomial of a step with the numbers c₀ … c₆ is c₀ s + c₁ s (1 − s) + c₂ s² (1 − s) + …, and its error that of the next number, as
/// much smaller than c₆ as that is than c₅, times s⁴ (1 − s)⁴ = 1/256.
#[test]
fn analytic_values_between_and_their_error() {
    let mut method = Dop853::<f64>::new(Sizes { n_q: 1, n_v: 1, n_c: 0, n_z: 0, n_works: 1 });
    let coefficients = [0.5, -0.3, 0.7, 1.1, -0.9, 0.08, 0.02];
    for (k, c) in coefficients.into_iter().enumerate() {
        method.dense[k] = [c, -2.0 * c, 3.0 * c, 0.0];
    }
    method.start = vec![[1.0, 2.0, 4.0, 0.0]];
    let mut out = State { t: 9.0, q: vec![0.0], v: vec![0.0], z: Vec::new(), work: vec![0.0] };
    for s in [0.0_f64, 0.2, 0.5, 0.9, 1.0] {
        method.dense_at(s, &mut out);
        let r = 1.0 - s;
        let powers = [s, s * r, s * s * r, (s * r).powi(2), s * (s * r).powi(2), (s * r).powi(3), s * (s * r).powi(3)];
        let value: f64 = powers.iter().zip(coefficients).map(|(power, c)| power * c).sum();
        close(out.q[0], 1.0 + value);
        close(out.v[0], 2.0 - 2.0 * value);
        close(out.work[0], 4.0 + 3.0 * value);
        assert_eq!(out.t, 9.0);
    }
    method.stage = vec![[-3.0, 1.0, 1e9, 0.0]];
    let tolerance = Tolerance::new(0.01, 0.1);
    // of q over 0.1 + 0.03, of v over 0.1 + 0.02; the larger one of each number counts
    let (last, before) = (0.04 / 0.12, 0.16 / 0.12);
    close(256.0 * method.dense_error(tolerance), last * last / before);
    method.dense[5] = [1e-9; WIDTH];
    close(256.0 * method.dense_error(tolerance), last);
}
