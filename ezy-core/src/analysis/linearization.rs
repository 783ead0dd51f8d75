//! The linear equations of small deviations, on the manifold of the constraints.

use super::derivatives;
use super::error::AnalysisError;
use super::frame::Frame;
use super::mode::Mode;
use super::row_space::RowSpace;
use super::spectrum::Spectrum;
use super::steady_motion::SteadyMotion;
use super::tolerances::linear::{INDEPENDENT, STEADY};
use crate::dynamics::{By, Gradients, Of, OperatingPoint, Rows, State, System};
use crate::model::{SceneInfo, SceneRef};
use nalgebra::{Complex, DMatrix};
use std::sync::Arc;

/// x' = A x + B u, y = C x + D u, in coordinates x of the tangent space of the constraints: deviations of q, v and z are `basis` x.
///
/// Seen from the frame of the steady motion, deviations satisfy C_q δq = 0 and (G v)_q δq + G δv = 0. The change of directions with
/// positions counts, of reactions in K [δa; δλ] = R_x δx as well as of rows. In the turning frame δq' = δv − ω e_z × δq and
/// δv' = δa − ω e_z × δv.
#[derive(Debug, Clone)]
pub struct Linearization {
    info: Arc<SceneInfo>,
    /// Names of the inputs u. Those `by acceleration` are none of them: rows may read them, and then they move the manifold of the constraints
    /// itself.
    pub inputs: Vec<&'static str>,
    /// A, `n × n`, 1/s.
    pub a: DMatrix<f64>,
    /// B, `n ×` the number of inputs.
    pub b: DMatrix<f64>,
    /// C, `n_o × n`.
    pub c: DMatrix<f64>,
    /// D, `n_o ×` the number of inputs.
    pub d: DMatrix<f64>,
    /// Deviations of `n_q` coordinates, `n_v` velocities and `n_z` states by x; its columns are orthonormal.
    pub basis: DMatrix<f64>,
}

impl Linearization {
    /// About a steady motion of the system.
    ///
    /// # Errors
    /// [`AnalysisError::NotSteady`] where what is linearised changes with time, place or heading.
    pub fn of<P: SceneRef>(system: &mut System<P>, motion: &SteadyMotion) -> Result<Self, AnalysisError> {
        let info = Arc::clone(system.info());
        let mut gradients = Gradients::new(system)?;
        let SteadyMotion { state: State { t, q, v, z, .. }, accelerations, multipliers, .. } = motion;
        system.place_states(z);
        let at = OperatingPoint { fixed: system.fixed(), t: *t, q, v, accelerations, multipliers };
        let n = q.len() + v.len() + z.len();
        let rows = rows_by_states(&mut gradients, &at);
        let slopes = by_states(&mut gradients, &at, Of::Motion);
        let is_part = |input: &usize| {
            info.integrated_inputs.iter().any(|&first| {
                let [value, _, since] = SceneInfo::integrated_places(first);
                (value..=since).contains(input)
            })
        };
        let inputs: Vec<usize> = (0..info.n_inputs()).filter(|input| !is_part(input)).collect();
        let by_inputs = derivatives(&mut gradients, &at, Of::Motion, By::Inputs).select_columns(&inputs);
        let outputs = by_states(&mut gradients, &at, Of::Outputs);
        let d = derivatives(&mut gradients, &at, Of::Outputs, By::Inputs).select_columns(&inputs);
        let inputs = inputs.into_iter().map(|input| info.inputs[input].name).collect();

        let basis = null_space(rows).ok_or(AnalysisError::NotFinite { scene: info.name })?;
        let along = along(motion, n);
        let changes = rates(system, &motion.state, motion.frame, &along, &(&slopes * &along))?;
        let rates = rates(system, &motion.state, motion.frame, &basis, &(&slopes * &basis))?;
        let a = basis.tr_mul(&rates);
        let left = (&rates - &basis * &a).amax().max(changes.amax() / along.amax().max(f64::MIN_POSITIVE));
        let change = left / rates.amax().max(f64::MIN_POSITIVE);
        if change > STEADY {
            return Err(AnalysisError::NotSteady { scene: info.name, change });
        }
        let zeros = DMatrix::zeros(n, by_inputs.ncols());
        let b = basis.tr_mul(&self::rates(system, &motion.state, Frame::default(), &zeros, &by_inputs)?);
        Ok(Self { info, inputs, a, b, c: outputs * &basis, d, basis })
    }

    /// Names and sizes of the scene.
    pub fn info(&self) -> &Arc<SceneInfo> {
        &self.info
    }

    /// The response G(s) = C (s − A)⁻¹ B + D of the outputs to the inputs; none where s is an eigenvalue.
    pub fn response(&self, s: Complex<f64>) -> Option<DMatrix<Complex<f64>>> {
        let complex = |x: &DMatrix<f64>| x.map(|x| Complex::new(x, 0.0));
        let n = self.a.nrows();
        let resolvent = (DMatrix::identity(n, n) * s - complex(&self.a)).lu();
        Some(complex(&self.c) * resolvent.solve(&complex(&self.b))? + complex(&self.d))
    }

    /// The eigenvalues of A.
    ///
    /// # Errors
    /// [`AnalysisError::NoEigenvalues`].
    pub fn spectrum(&self) -> Result<Spectrum, AnalysisError> {
        Spectrum::of(&self.a).ok_or_else(|| self.no_eigenvalues())
    }

    /// The modes of the eigenvalues of a spectrum, in its order. A double eigenvalue with one eigenvector has that twice.
    ///
    /// # Errors
    /// [`AnalysisError::NoEigenvalues`].
    ///
    /// # Cost
    /// n² operations for each eigenvalue, besides a reduction of A to Hessenberg form.
    pub fn modes(&self, spectrum: &Spectrum) -> Result<Vec<Mode>, AnalysisError> {
        let n = [self.info.n_coordinates(), self.info.n_velocities()];
        let modes = Mode::all(&self.a, &self.basis, n, spectrum.eigenvalues.iter().copied());
        modes.ok_or_else(|| self.no_eigenvalues())
    }

    fn no_eigenvalues(&self) -> AnalysisError {
        AnalysisError::NoEigenvalues { scene: self.info.name }
    }
}

/// Derivatives by coordinates, velocities and first-order states, side by side.
pub(super) fn by_states<P: SceneRef>(gradients: &mut Gradients<P>, at: &OperatingPoint<'_>, of: Of) -> DMatrix<f64> {
    let parts = [By::Positions, By::Velocities, By::States].map(|by| derivatives(gradients, at, of, by));
    let mut joined = DMatrix::zeros(parts[0].nrows(), parts.iter().map(DMatrix::ncols).sum());
    let mut first = 0;
    for part in &parts {
        joined.columns_mut(first, part.ncols()).copy_from(part);
        first += part.ncols();
    }
    joined
}

/// What deviations must satisfy: C_q δq = 0, and the change of all rows of velocities.
pub(super) fn rows_by_states<P: SceneRef>(gradients: &mut Gradients<P>, at: &OperatingPoint<'_>) -> DMatrix<f64> {
    let positions = derivatives(gradients, at, Of::PositionRows, By::Positions);
    let velocities = by_states(gradients, at, Of::VelocityRows);
    let mut rows = DMatrix::zeros(positions.nrows() + velocities.nrows(), velocities.ncols());
    rows.view_mut((0, 0), positions.shape()).copy_from(&positions);
    rows.rows_mut(positions.nrows(), velocities.nrows()).copy_from(&velocities);
    rows
}

/// The deviation that a while of the frame's motion is: what is steady does not change with it.
fn along(motion: &SteadyMotion, n: usize) -> DMatrix<f64> {
    let SteadyMotion { state: State { q, v, .. }, frame, .. } = motion;
    let mut along = DMatrix::zeros(n, 1);
    let (of_q, rest) = along.as_mut_slice().split_at_mut(q.len());
    frame.carry(q, of_q);
    frame.turn(v, &mut rest[..v.len()]);
    along
}

/// Rates of the deviations `basis`, one a column, where R changes by `slopes` with them.
pub(super) fn rates<P: SceneRef>(
    system: &mut System<P>,
    state: &State,
    frame: Frame,
    basis: &DMatrix<f64>,
    slopes: &DMatrix<f64>,
) -> Result<DMatrix<f64>, AnalysisError> {
    let State { t, q, .. } = state;
    let (n_q, n_c) = (system.info().n_velocities(), system.info().n_rows());
    let mut rates = DMatrix::zeros(basis.nrows(), basis.ncols());
    let (mut turned, mut a, mut lambda) = (vec![0.0; n_q], vec![0.0; n_q], vec![0.0; n_c]);
    let mut at = system.at_with(*t, q, Rows::Projected);
    at.factor()?;
    for (j, mut rate) in rates.column_iter_mut().enumerate() {
        let (deviation, slope) = (basis.column(j), slopes.column(j));
        let slope = slope.as_slice();
        // K [δa; δλ] = R_x δx
        at.solve(&slope[..n_q], &slope[n_q..n_q + n_c], &mut a, &mut lambda);
        let deviation = deviation.as_slice();
        frame.turn(&deviation[..n_q], &mut turned);
        (0..n_q).for_each(|i| rate[i] = deviation[n_q + i] - turned[i]);
        frame.turn(&deviation[n_q..2 * n_q], &mut turned);
        (0..n_q).for_each(|i| rate[n_q + i] = a[i] - turned[i]);
        slope[n_q + n_c..].iter().enumerate().for_each(|(i, slope)| rate[2 * n_q + i] = *slope);
    }
    Ok(rates)
}

/// An orthonormal basis of what all rows leave; none where they are not finite.
pub(super) fn null_space(mut rows: DMatrix<f64>) -> Option<DMatrix<f64>> {
    for mut row in rows.row_iter_mut() {
        let norm = row.norm();
        if norm > 0.0 {
            row /= norm;
        }
    }
    Some(RowSpace::of(&rows, INDEPENDENT)?.null_space())
}
