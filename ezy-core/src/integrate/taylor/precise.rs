//! The motion in double-double arithmetic: a reference for other runs.

use super::expansion::{OrderSolver, expand, expand_with, increment};
use super::length::{longest_step, write_weights};
use super::states::States;
use crate::dynamics::{MotionError, Rows, State, System, SystemError, not_finite};
use crate::integrate::Tolerance;
use crate::integrate::tolerances::precise::{MAX_CORRECTIONS, MAX_REFINEMENTS, TOLERANCE};
use crate::integrate::tolerances::steps::SHORTEST;
use crate::linalg::Backend;
use crate::model::{Pivots, PreciseScene, Scene, SeriesStore};
use crate::scalar::{DoubleDouble, Scalar};

/// Order of a step; that of least time for [`TOLERANCE`].
const ORDER: usize = 38;

/// There is no motion in double-double.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PreciseError {
    /// The scene has no Taylor series.
    #[error("scene `{scene}` has no Taylor series, so there is no motion in double-double")]
    NoSeries {
        /// Name of the scene.
        scene: &'static str,
    },
    /// The start has not the first-order states of the scene.
    #[error("the start has {found} first-order states, and scene `{scene}` has {expected}")]
    States {
        /// Name of the scene.
        scene: &'static str,
        /// Of the scene.
        expected: usize,
        /// Of the start.
        found: usize,
    },
    /// Parameters or masses cannot be used.
    #[error(transparent)]
    System(#[from] SystemError),
    /// The motion cannot be continued.
    #[error(transparent)]
    Motion(#[from] MotionError),
}

/// The motion of a scene with 31 digits, by Taylor's method of order 38.
///
/// The scene's own elimination solves for the coefficients. If it has none, or a pivot vanishes, a factorisation in f64 with
/// iterative refinement does. After each step positions and velocities are brought back onto the rows.
///
/// ```text
/// let mut motion = PreciseMotion::new(&scene, &state)?;
/// motion.advance_to(60.0)?;
/// println!("{:?}", motion.q());
/// ```
pub struct PreciseMotion<'s> {
    scene: &'s dyn PreciseScene,
    solver: Refined<'s>,
    store: SeriesStore<DoubleDouble>,
    weights: Vec<f64>,
    t: f64,
    q: Vec<DoubleDouble>,
    v: Vec<DoubleDouble>,
    z: Vec<DoubleDouble>,
    states: States,
    lambda: Vec<DoubleDouble>,
    delta: Vec<DoubleDouble>,
    v_delta: Vec<DoubleDouble>,
    z_delta: Vec<DoubleDouble>,
    residual: Vec<DoubleDouble>,
}

impl<'s> PreciseMotion<'s> {
    /// From a state that meets the rows in f64, with the present parameters and the declared inputs.
    ///
    /// # Errors
    /// [`PreciseError`] when the scene has no series, cannot be set up, has other first-order states, or its constraints depend on each other
    /// at the start.
    pub fn new(scene: &'s dyn Scene, start: &State) -> Result<Self, PreciseError> {
        let parameters = (0..scene.info().parameters.len()).map(|i| scene.parameter(i).into());
        let parameters: Vec<DoubleDouble> = parameters.collect();
        let [q, v, z] = [&start.q, &start.v, &start.z].map(|x| x.iter().map(|x| (*x).into()).collect::<Vec<_>>());
        Self::from_numbers(scene, &parameters, start.t, [&q, &v, &z])
    }

    /// From a state and parameters, in the order of [`SceneInfo::parameters`](crate::model::SceneInfo::parameters), of
    /// which f64 holds the first half only. First-order states begin with their declared values.
    ///
    /// # Errors
    /// As [`PreciseMotion::new`].
    pub fn with_parameters(
        scene: &'s dyn Scene,
        parameters: &[DoubleDouble],
        t: f64,
        q: &[DoubleDouble],
        v: &[DoubleDouble],
    ) -> Result<Self, PreciseError> {
        let z: Vec<_> = scene.info().states.iter().map(|state| state.default.into()).collect();
        Self::from_numbers(scene, parameters, t, [q, v, &z])
    }

    fn from_numbers(
        scene: &'s dyn Scene,
        parameters: &[DoubleDouble],
        t: f64,
        [q, v, z]: [&[DoubleDouble]; 3],
    ) -> Result<Self, PreciseError> {
        let info = scene.info();
        let precise = scene.precise().ok_or(PreciseError::NoSeries { scene: info.name })?;
        let system = System::new(scene, Backend::Auto)?;
        let zeros = |n: usize| vec![DoubleDouble::default(); n];
        let (n_q, n_c, n_z) = (info.n_coordinates(), info.n_rows(), info.n_states());
        if z.len() != n_z {
            return Err(PreciseError::States { scene: info.name, expected: n_z, found: z.len() });
        }
        let mut fixed = zeros(info.n_fixed());
        fixed.iter_mut().zip(system.inputs()).for_each(|(input, value)| *input = (*value).into());
        precise.constants(parameters, &mut fixed);
        let mut mass = zeros(n_q);
        precise.mass_matrix(&fixed, &mut mass);
        let mut motion = Self {
            scene: precise,
            solver: Refined {
                scene: precise,
                system,
                fixed,
                mass,
                jacobian: zeros(info.jacobian.n_nonzeros()),
                rest: zeros(n_q + n_c),
                rest_f64: vec![0.0; n_q + n_c],
                solution: vec![0.0; n_q + n_c],
                t: f64::NAN,
                q: vec![0.0; n_q],
            },
            store: SeriesStore::new(precise.series_size(), ORDER + 1),
            states: States::new(n_z, precise.series_size()),
            weights: vec![0.0; 2 * n_q + n_z],
            t,
            q: q.to_vec(),
            v: v.to_vec(),
            z: z.to_vec(),
            lambda: zeros(n_c),
            delta: zeros(n_q),
            v_delta: zeros(n_q),
            z_delta: zeros(n_z),
            residual: zeros(n_c),
        };
        motion.project()?;
        motion.expand()?;
        Ok(motion)
    }

    /// Coordinates, `n_q`.
    pub fn q(&self) -> &[DoubleDouble] {
        &self.q
    }

    /// Velocities, `n_q`.
    pub fn v(&self) -> &[DoubleDouble] {
        &self.v
    }

    /// First-order states, `n_z`.
    pub fn z(&self) -> &[DoubleDouble] {
        &self.z
    }

    /// Multipliers, `n_c`.
    pub fn lambda(&self) -> &[DoubleDouble] {
        &self.lambda
    }

    /// Steps until `end`, s, which is not before the present time.
    ///
    /// # Errors
    /// [`MotionError`] when the motion cannot be continued; it is then of no further use.
    pub fn advance_to(&mut self, end: f64) -> Result<(), MotionError> {
        while self.t < end {
            self.step(end)?;
        }
        Ok(())
    }

    /// One step, which ends at `end` at the latest. It costs about a hundred steps of [`Taylor`](super::Taylor); no allocation.
    fn step(&mut self, end: f64) -> Result<(), MotionError> {
        let Self { store, states, weights, t, .. } = self;
        write_weights(store, *states, Tolerance::new(TOLERANCE, TOLERANCE), weights);
        let (length, left) = (longest_step(store, *states, ORDER, weights), end - *t);
        if length < left && length <= SHORTEST * t.abs().max(1.0) {
            return Err(MotionError::StepCollapsed { t: *t, step_s: length });
        }
        // times are doubles, and the difference of two is exact
        let t_next = if length < left { *t + length } else { end };
        let h = DoubleDouble::from(t_next) - DoubleDouble::from(*t);
        increment(store, ORDER, h, &mut self.delta, &mut self.v_delta);
        states.increment(store, ORDER, h, &mut self.z_delta);
        self.q.iter_mut().zip(&self.delta).for_each(|(q, delta)| *q = *q + *delta);
        self.v.iter_mut().zip(&self.v_delta).for_each(|(v, delta)| *v = *v + *delta);
        self.z.iter_mut().zip(&self.z_delta).for_each(|(z, delta)| *z = *z + *delta);
        self.check_finite()?;
        self.t = t_next;
        self.project()?;
        self.expand()
    }

    fn check_finite(&self) -> Result<(), MotionError> {
        let info = self.solver.system.info();
        let of_states = || self.z.iter().position(|z| !z.is_finite()).map(|i| info.states[i].name.into());
        let broken = not_finite(info, &self.q, &self.v).or_else(of_states);
        broken.map_or(Ok(()), |quantity| Err(MotionError::NotFinite { t: self.t, quantity }))
    }

    fn expand(&mut self) -> Result<(), MotionError> {
        let Self { scene, solver, store, t, q, v, z, lambda, .. } = self;
        let (n_q, n_inputs) = (q.len(), solver.system.info().n_inputs());
        solver.fixed[n_inputs..][..z.len()].copy_from_slice(z);
        store.q[..n_q].copy_from_slice(q);
        store.q[n_q..2 * n_q].copy_from_slice(v);
        let deficient = scene.begin(&solver.fixed, (*t).into(), store);
        if solver.accepts(deficient) {
            expand_by_elimination(*scene, &solver.fixed, store);
        } else {
            solver.factorize(*t, q)?;
            expand_with(*scene, solver, ORDER, store);
        }
        let n_c = lambda.len();
        lambda.copy_from_slice(&store.lambda[..n_c]);
        Ok(())
    }

    /// Positions onto their rows, then velocities onto all rows.
    fn project(&mut self) -> Result<(), MotionError> {
        let n_h = self.solver.system.info().n_position_rows;
        let mut left = f64::INFINITY;
        for _ in 0..MAX_CORRECTIONS {
            let Self { scene, solver, t, q, residual, .. } = self;
            residual.fill(DoubleDouble::default());
            scene.position_constraint(&solver.fixed, (*t).into(), q, &mut residual[..n_h]);
            if is_rounding(largest(residual), &mut left) {
                break;
            }
            self.correct()?;
            self.q.iter_mut().zip(&self.delta).for_each(|(q, delta)| *q = *q + *delta);
        }
        left = f64::INFINITY;
        for _ in 0..MAX_CORRECTIONS {
            let Self { scene, solver, t, q, v, residual, .. } = self;
            scene.velocity_constraint(&solver.fixed, (*t).into(), q, v, residual);
            if is_rounding(largest(residual), &mut left) {
                break;
            }
            self.correct()?;
            self.v.iter_mut().zip(&self.delta).for_each(|(v, delta)| *v = *v + *delta);
        }
        Ok(())
    }

    /// The smallest correction, in the mass metric, that removes the residual up to the rounding of the factors.
    fn correct(&mut self) -> Result<(), MotionError> {
        let Self { scene, solver, t, q, residual, delta, .. } = self;
        let deficient = scene.correction(&solver.fixed, (*t).into(), q, residual, delta);
        if !solver.accepts(deficient) {
            solver.factorize(*t, q)?;
            solver.correct(residual, delta);
        }
        Ok(())
    }
}

/// Solves K by factors in f64 and iterative refinement.
struct Refined<'s> {
    scene: &'s dyn PreciseScene,
    system: System<&'s dyn Scene>,
    fixed: Vec<DoubleDouble>,
    mass: Vec<DoubleDouble>,
    jacobian: Vec<DoubleDouble>,
    /// Residual of a solution for `[force; row]`, and its nearest f64.
    rest: Vec<DoubleDouble>,
    rest_f64: Vec<f64>,
    solution: Vec<f64>,
    /// Where K was factored.
    t: f64,
    q: Vec<f64>,
}

impl Refined<'_> {
    /// Whether the scene's own elimination is used.
    fn accepts(&self, pivots: Pivots) -> bool {
        pivots.all_keep() && self.system.uses_elimination()
    }

    fn factorize(&mut self, t: f64, q: &[DoubleDouble]) -> Result<(), MotionError> {
        self.scene.velocity_jacobian(&self.fixed, t.into(), q, &mut self.jacobian);
        self.q.iter_mut().zip(q).for_each(|(near, q)| *near = q.high());
        self.t = t;
        self.system.at_with(t, &self.q, Rows::Projected).factor()
    }

    /// K⁻¹ of the rest in f64, into the solution.
    fn solve_rest(&mut self) {
        let n_q = self.mass.len();
        self.rest_f64.iter_mut().zip(&self.rest).for_each(|(near, rest)| *near = rest.high());
        let (force, row) = self.rest_f64.split_at(n_q);
        let (a, lambda) = self.solution.split_at_mut(n_q);
        self.system.at_with(self.t, &self.q, Rows::Projected).solve(force, row, a, lambda);
    }

    fn correct(&mut self, residual: &[DoubleDouble], delta: &mut [DoubleDouble]) {
        let n_q = self.mass.len();
        self.rest[..n_q].fill(DoubleDouble::default());
        self.rest[n_q..].iter_mut().zip(residual).for_each(|(rest, residual)| *rest = -*residual);
        self.solve_rest();
        delta.iter_mut().zip(&self.solution).for_each(|(delta, x)| *delta = (*x).into());
    }
}

impl OrderSolver<DoubleDouble> for Refined<'_> {
    fn fixed(&self) -> &[DoubleDouble] {
        &self.fixed
    }

    fn solve(&mut self, k: usize, store: &mut SeriesStore<DoubleDouble>) {
        let SeriesStore { lambda, force, row, a, .. } = store;
        let (n_q, n_c) = (force.len(), row.len());
        let lambda = &mut lambda[k * n_c..][..n_c];
        a.fill(DoubleDouble::default());
        lambda.fill(DoubleDouble::default());
        let mut left = f64::INFINITY;
        for _ in 0..MAX_REFINEMENTS {
            let (of_force, of_row) = self.rest.split_at_mut(n_q);
            for (i, rest) in of_force.iter_mut().enumerate() {
                *rest = force[i] - self.mass[i] * a[i];
            }
            of_row.copy_from_slice(row);
            for (entry, i_row, column) in self.system.info().jacobian.entries() {
                let g = self.jacobian[entry];
                of_force[column] = of_force[column] - g * lambda[i_row];
                of_row[i_row] = of_row[i_row] - g * a[column];
            }
            self.solve_rest();
            let (da, dlambda) = self.solution.split_at(n_q);
            a.iter_mut().zip(da).for_each(|(a, change)| *a = *a + (*change).into());
            lambda.iter_mut().zip(dlambda).for_each(|(lambda, change)| *lambda = *lambda + (*change).into());
            let share = |x: &[DoubleDouble], change: &[f64]| {
                let change = change.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
                if change > 0.0 { change / largest(x) } else { 0.0 }
            };
            if is_rounding(share(a, da).max(share(lambda, dlambda)), &mut left) {
                break;
            }
        }
    }
}

/// Compiled with this crate, in one unit with all that it calls, whatever the crate of the scene.
fn expand_by_elimination(scene: &dyn PreciseScene, c: &[DoubleDouble], store: &mut SeriesStore<DoubleDouble>) {
    expand(scene, c, ORDER, store);
}

/// Whether what is left of an iteration is rounding: nothing, or no less than half of what was left before.
fn is_rounding(left: f64, before: &mut f64) -> bool {
    let before = std::mem::replace(before, left);
    left == 0.0 || left > 0.5 * before
}

fn largest(x: &[DoubleDouble]) -> f64 {
    x.iter().map(|x| x.magnitude()).fold(0.0, f64::max)
}
