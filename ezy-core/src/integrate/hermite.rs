//! Interpolation within a step.

use crate::dynamics::State;
use crate::scalar::Scalar;

/// A state with its accelerations, rates and powers, at one end of a step.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Node<'a, T = f64> {
    /// The state.
    pub state: &'a State<T>,
    /// Rates of the coordinates, `n_q`: the velocities themselves where all bodies are planar.
    pub q_rate: &'a [T],
    /// Accelerations, `n_v`.
    pub a: &'a [T],
    /// Rates of the first-order states, `n_z`.
    pub rate: &'a [T],
    /// Powers of the effects, W, `n_e`.
    pub power: &'a [T],
}

/// The state at the time `t` within the step: positions by the quintic polynomial through q, v, a at both ends,
/// velocities by its derivative, first-order states and works by the cubic through them and their rates. Where not all bodies are
/// planar, positions and velocities are by cubics, too.
///
/// The error of positions is of order 6 in the step, of velocities 5, of cubics 4: not above that of the steps. The
/// constraints are satisfied to the same order.
///
/// # Source
/// Hermite interpolation; Hairer, Nørsett, Wanner, Solving Ordinary Differential Equations I (1993), II.6.
pub(crate) fn interpolate<T: Scalar>(from: Node<'_, T>, to: Node<'_, T>, t: f64, out: &mut State<T>) {
    let h = to.state.t - from.state.t;
    let s = (t - from.state.t) / h;
    let (r, s2) = (1.0 - s, s * s);
    // s³ times the polynomials that carry the end, and their derivatives
    let end = s * s2 * (10.0 - 15.0 * s + 6.0 * s2);
    let end_rate = 30.0 * s2 * r * r;
    let slope_from = s * r * r * r * (1.0 + 3.0 * s);
    let slope_to = -s * s2 * r * (4.0 - 3.0 * s);
    let slope_from_rate = r * r * (1.0 + 2.0 * s - 15.0 * s2);
    let slope_to_rate = s2 * (-12.0 + 28.0 * s - 15.0 * s2);
    let bend_from = 0.5 * s2 * r * r * r;
    let bend_to = 0.5 * s * s2 * r * r;
    let bend_from_rate = 0.5 * s * r * r * (2.0 - 5.0 * s);
    let bend_to_rate = 0.5 * s2 * r * (3.0 - 5.0 * s);
    let [h, end, end_rate, slope_from, slope_to, bend_from, bend_to] =
        [h, end, end_rate, slope_from, slope_to, bend_from, bend_to].map(T::from_f64);
    let [slope_from_rate, slope_to_rate, bend_from_rate, bend_to_rate] =
        [slope_from_rate, slope_to_rate, bend_from_rate, bend_to_rate].map(T::from_f64);
    let is_planar = out.q.len() == out.v.len();
    for i in 0..if is_planar { out.q.len() } else { 0 } {
        let (q0, q1, v0, v1) = (from.state.q[i], to.state.q[i], from.state.v[i], to.state.v[i]);
        let (a0, a1) = (from.a[i], to.a[i]);
        let rise = q1 - q0;
        out.q[i] = q0 + end * rise + h * (slope_from * v0 + slope_to * v1 + h * (bend_from * a0 + bend_to * a1));
        out.v[i] = end_rate * rise / h
            + slope_from_rate * v0
            + slope_to_rate * v1
            + h * (bend_from_rate * a0 + bend_to_rate * a1);
    }
    let (rise, bulge) = (T::from_f64(s2 * (3.0 - 2.0 * s)), h * T::from_f64(s) * T::from_f64(r));
    let [r, s] = [r, s].map(T::from_f64);
    let cubic = |out: &mut [T], [begin, end]: [&[T]; 2], [at_begin, at_end]: [&[T]; 2]| {
        for i in 0..out.len() {
            let (w0, w1, p0, p1) = (begin[i], end[i], at_begin[i], at_end[i]);
            out[i] = w0 + rise * (w1 - w0) + bulge * (r * p0 - s * p1);
        }
    };
    if !is_planar {
        cubic(&mut out.q, [&from.state.q, &to.state.q], [from.q_rate, to.q_rate]);
        cubic(&mut out.v, [&from.state.v, &to.state.v], [from.a, to.a]);
    }
    cubic(&mut out.z, [&from.state.z, &to.state.z], [from.rate, to.rate]);
    cubic(&mut out.work, [&from.state.work, &to.state.work], [from.power, to.power]);
    out.t = t;
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rounding of sums of numbers of some tens.
    const ROUNDING: f64 = 1e-13;

    /// A quintic q, with its slope and curvature; a cubic work, with its power.
    fn quintic(t: f64) -> [f64; 3] {
        let coefficients = [0.7, -1.1, 0.4, 2.3, -1.7, 0.9];
        std::array::from_fn(|derivative| {
            let falling = |k: usize| (0..derivative).fold(1.0, |product, i| product * (k as f64 - i as f64));
            let terms = coefficients.iter().enumerate().skip(derivative);
            terms.map(|(k, c)| c * falling(k) * t.powi((k - derivative) as i32)).sum()
        })
    }

    fn cubic(t: f64) -> [f64; 2] {
        [0.3 + t * (1.2 + t * (-0.8 + 0.5 * t)), 1.2 + t * (-1.6 + 1.5 * t)]
    }

    /// Quintic motions and cubic works are reproduced, and their slopes.
    #[test]
    fn analytic_interpolation_of_a_quintic_motion_and_a_cubic_work() {
        let (begin, end) = (-0.4, 1.1);
        let at = |t: f64| {
            let mut state = State::zero(1, 1);
            (state.t, state.q[0], state.v[0], state.work[0]) = (t, quintic(t)[0], quintic(t)[1], cubic(t)[0]);
            (state, [quintic(t)[2]], [cubic(t)[1]])
        };
        let ((from, a, power), (to, a_to, power_to)) = (at(begin), at(end));
        let nodes = [
            Node { state: &from, q_rate: &from.v, a: &a, rate: &[], power: &power },
            Node { state: &to, q_rate: &to.v, a: &a_to, rate: &[], power: &power_to },
        ];
        for t in [begin, -0.1, 0.3, 0.9, end] {
            let mut found = State::zero(1, 1);
            interpolate(nodes[0], nodes[1], t, &mut found);
            let (expected, _, _) = at(t);
            assert_eq!(found.t, t);
            for (x, y) in [(found.q[0], expected.q[0]), (found.v[0], expected.v[0]), (found.work[0], expected.work[0])]
            {
                assert!((x - y).abs() <= ROUNDING, "at {t}: {x} {y}");
            }
        }
    }
}
