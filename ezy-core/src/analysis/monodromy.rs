//! What becomes of small deviations over a while of a motion: Floquet multipliers.

use super::error::AnalysisError;
use super::frame::Frame;
use super::linearization::{by_states, null_space, rates, rows_by_states};
use super::tolerances::spectrum::MAX_ITERATIONS;
use crate::dynamics::{Gradients, Of, OperatingPoint, State, System};
use crate::model::SceneRef;
use crate::model::coordinate::N_OF_BODY;
use nalgebra::{Complex, DMatrix, Schur};
use std::sync::Arc;

/// Stages of a step: Gauss's formula of order 6.
const N_STAGES: usize = 3;
/// Where they are, and their weights.
///
/// # Source
/// Hairer, Lubich, Wanner, Geometric Numerical Integration (2006), section II.1.3.
fn gauss() -> ([f64; N_STAGES], [[f64; N_STAGES]; N_STAGES], [f64; N_STAGES]) {
    let s = 15f64.sqrt();
    let nodes = [0.5 - s / 10.0, 0.5, 0.5 + s / 10.0];
    let inner = [
        [5.0 / 36.0, 2.0 / 9.0 - s / 15.0, 5.0 / 36.0 - s / 30.0],
        [5.0 / 36.0 + s / 24.0, 2.0 / 9.0, 5.0 / 36.0 - s / 24.0],
        [5.0 / 36.0 + s / 30.0, 2.0 / 9.0 + s / 15.0, 5.0 / 36.0],
    ];
    (nodes, inner, [5.0 / 18.0, 4.0 / 9.0, 5.0 / 18.0])
}

/// The linear map of small deviations from their start to the end of a period, of a motion that comes back to itself: to the same state, or
/// to the same one seen from another place and heading, as a gait does.
///
/// Deviations satisfy all constraints; X' = F(t) X is integrated by collocation over the states of the motion, so that methods and steps of
/// the motion do not matter. From step to step the error falls by 2⁶ when steps are halved.
#[derive(Debug, Clone)]
pub struct Monodromy {
    /// M, `n × n`, in coordinates of the tangent space of the constraints at the start.
    pub matrix: DMatrix<f64>,
    /// Deviations of `n_q` coordinates, `n_v` velocities and `n_z` states by these; its columns are orthonormal.
    pub basis: DMatrix<f64>,
    /// How far the first body has gone along x and y, m, and turned, rad.
    pub moved: [f64; N_OF_BODY],
    /// What the end differs by from the start that is moved so: the largest of m, rad, m/s, rad/s and units of states. Angles that nothing
    /// depends on, as those of wheels, do not count.
    pub gap: f64,
}

impl Monodromy {
    /// Times, s, at which [`Monodromy::of`] needs the states of a period that begins at `start_s`, in `n_steps` equal steps.
    pub fn times(start_s: f64, period_s: f64, n_steps: usize) -> Vec<f64> {
        let h = period_s / n_steps as f64;
        let (nodes, ..) = gauss();
        let within = (0..n_steps).flat_map(|k| nodes.map(|node| start_s + h * (k as f64 + node)));
        std::iter::once(start_s).chain(within).chain([start_s + period_s]).collect()
    }

    /// Along a motion, by its states at [`Monodromy::times`]; inputs are those of the system.
    ///
    /// # Errors
    /// [`AnalysisError::NoPeriod`] where the states are not as many as the times of whole steps; [`AnalysisError::Spatial`]; those of
    /// [`Gradients::new`] and of the accelerations.
    pub fn of<P: SceneRef>(system: &mut System<P>, states: &[State]) -> Result<Self, AnalysisError> {
        let (basis, mut x) = deviations(system, states)?;
        let (first, last) = (&states[0], &states[states.len() - 1]);
        let feedback = system.info().feedback;
        let moved = [0, 1, 2].map(|part| last.q[part] - first.q[part]);
        turn_back(&mut x, first.q.len(), moved[2]);
        let gap = gap(first, last, moved, feedback);
        Ok(Self { matrix: basis.tr_mul(&x), basis, moved, gap })
    }

    /// The multipliers: eigenvalues of M, by falling modulus. Those of a place, a heading and of the time that the motion is at are 1; the motion
    /// is stable where the others are smaller. None where an entry is not finite.
    pub fn multipliers(&self) -> Option<Vec<Complex<f64>>> {
        eigenvalues(&self.matrix)
    }
}

/// Eigenvalues by falling modulus; none where an entry is not finite.
pub(super) fn eigenvalues(matrix: &DMatrix<f64>) -> Option<Vec<Complex<f64>>> {
    if matrix.iter().any(|x| !x.is_finite()) {
        return None;
    }
    let schur = Schur::try_new(matrix.clone(), f64::EPSILON, MAX_ITERATIONS)?;
    let mut all: Vec<_> = schur.complex_eigenvalues().iter().copied().collect();
    all.sort_by(|a, b| b.norm().total_cmp(&a.norm()).then(b.im.total_cmp(&a.im)));
    Some(all)
}

/// An orthonormal basis of the deviations that satisfy all constraints at the first state, and what becomes of it until the last one.
pub(super) fn deviations<P: SceneRef>(
    system: &mut System<P>,
    states: &[State],
) -> Result<(DMatrix<f64>, DMatrix<f64>), AnalysisError> {
    let info = Arc::clone(system.info());
    if states.len() <= N_STAGES || !(states.len() - 2).is_multiple_of(N_STAGES) {
        return Err(AnalysisError::NoPeriod { scene: info.name, n_states: states.len() });
    }
    if !info.is_planar() {
        return Err(AnalysisError::Spatial { scene: info.name });
    }
    let (first, last) = (&states[0], &states[states.len() - 1]);
    let mut gradients = Gradients::new(system)?;
    let n = first.q.len() + first.v.len() + first.z.len();
    let n_steps = (states.len() - 2) / N_STAGES;
    let h = (last.t - first.t) / n_steps as f64;
    let (_, inner, weights) = gauss();
    let (accelerations, multipliers) = accelerations(system, first)?;
    let State { t, q, v, .. } = first;
    let at =
        OperatingPoint { fixed: system.fixed(), t: *t, q, v, accelerations: &accelerations, multipliers: &multipliers };
    let rows = rows_by_states(&mut gradients, &at);
    let basis = null_space(rows).ok_or(AnalysisError::NotFinite { scene: info.name })?;
    let mut x = basis.clone();
    for stages in states[1..states.len() - 1].chunks(N_STAGES) {
        let flows = stages.iter().map(|state| flow(system, &mut gradients, state)).collect::<Result<Vec<_>, _>>()?;
        // (I − h F A) k = F x
        let mut matrix = DMatrix::identity(N_STAGES * n, N_STAGES * n);
        let mut right = DMatrix::zeros(N_STAGES * n, x.ncols());
        for (i, (flow, inner)) in flows.iter().zip(inner).enumerate() {
            for (j, share) in inner.into_iter().enumerate() {
                let mut block = matrix.view_mut((i * n, j * n), (n, n));
                block -= flow * (h * share);
            }
            right.rows_mut(i * n, n).copy_from(&(flow * &x));
        }
        let k = matrix.lu().solve(&right).ok_or(AnalysisError::NoEigenvalues { scene: info.name })?;
        (0..N_STAGES).for_each(|i| x += k.rows(i * n, n) * (h * weights[i]));
    }
    Ok((basis, x))
}

pub(super) fn accelerations<P: SceneRef>(
    system: &mut System<P>,
    state: &State,
) -> Result<(Vec<f64>, Vec<f64>), AnalysisError> {
    let State { t, q, v, z, .. } = state;
    system.place_states(z);
    let (mut a, mut lambda) = (vec![0.0; v.len()], vec![0.0; system.info().n_rows()]);
    system.accelerations(*t, q, v, &mut a, &mut lambda)?;
    Ok((a, lambda))
}

/// F: rates of deviations by these.
pub(super) fn flow<P: SceneRef>(
    system: &mut System<P>,
    gradients: &mut Gradients<P>,
    state: &State,
) -> Result<DMatrix<f64>, AnalysisError> {
    let (accelerations, multipliers) = accelerations(system, state)?;
    let State { t, q, v, z, .. } = state;
    let n = q.len() + v.len() + z.len();
    let at =
        OperatingPoint { fixed: system.fixed(), t: *t, q, v, accelerations: &accelerations, multipliers: &multipliers };
    let slopes = by_states(gradients, &at, Of::Motion);
    rates(system, state, Frame::default(), &DMatrix::identity(n, n), &slopes)
}

/// Turns vectors of deviations by minus an angle, in place.
pub(super) fn turn_back(x: &mut DMatrix<f64>, n_q: usize, angle: f64) {
    let (sin, cos) = angle.sin_cos();
    for first in (0..2 * n_q).step_by(N_OF_BODY) {
        for j in 0..x.ncols() {
            let (along, across) = (x[(first, j)], x[(first + 1, j)]);
            x[(first, j)] = cos * along + sin * across;
            x[(first + 1, j)] = cos * across - sin * along;
        }
    }
}

/// Largest difference of a state from another one that is moved with its first body.
fn gap(first: &State, last: &State, moved: [f64; N_OF_BODY], feedback: Option<&[usize]>) -> f64 {
    let (sin, cos) = moved[2].sin_cos();
    let turned = |x: &[f64]| [cos * x[0] - sin * x[1], sin * x[0] + cos * x[1]];
    let counts = |i: usize| i % N_OF_BODY < 2 || feedback.is_none_or(|feedback| feedback.binary_search(&i).is_ok());
    let mut largest: f64 = 0.0;
    let [before, after] = [first, last].map(|state| [state.q[0], state.q[1]]);
    for i in (0..first.q.len()).step_by(N_OF_BODY) {
        let relative = |q: &[f64], to: [f64; 2]| [q[i] - to[0], q[i + 1] - to[1]];
        let [from, to] = [turned(&relative(&first.q, before)), relative(&last.q, after)];
        let [v_from, v_to] = [turned(&first.v[i..]), [last.v[i], last.v[i + 1]]];
        (0..2).for_each(|k| largest = largest.max((to[k] - from[k]).abs()).max((v_to[k] - v_from[k]).abs()));
        if counts(i + 2) {
            largest = largest.max((last.q[i + 2] - first.q[i + 2] - moved[2]).abs());
        }
        largest = largest.max((last.v[i + 2] - first.v[i + 2]).abs());
    }
    first.z.iter().zip(&last.z).fold(largest, |largest, (x, y)| largest.max((x - y).abs()))
}
