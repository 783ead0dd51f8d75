//! What a period of a run makes of its start, and the exact derivative of that.

use super::error::AnalysisError;
use super::monodromy::{accelerations, deviations, flow, turn_back};
use super::symmetry::Symmetry;
use super::tolerances::periodic::SAME;
use crate::dynamics::{Gradients, State, System};
use crate::model::{Name, SceneInfo, SceneRef};
use nalgebra::{DMatrix, DVector};
use std::sync::Arc;

/// Shares of a period at which forces are compared: at no simple fraction of it.
const SHARES: [f64; 4] = [0.1371, 0.2913, 0.5237, 0.8119];

/// The return of a scene whose symmetry is known.
pub(super) struct ReturnMap<'s, P: SceneRef> {
    pub system: &'s mut System<P>,
    pub info: Arc<SceneInfo>,
    pub symmetry: Symmetry,
    /// Which values have to return: not angles that nothing depends on.
    counted: Vec<bool>,
    /// What is left is measured by these: the largest coordinate, velocity and state of the first run, one each.
    sizes: Vec<f64>,
}

impl<'s, P: SceneRef> ReturnMap<'s, P> {
    /// With the symmetry of the states of a run.
    pub(super) fn of(system: &'s mut System<P>, states: &[State]) -> Result<Self, AnalysisError> {
        let info = Arc::clone(system.info());
        let symmetry = Symmetry::of(system, states)?;
        let depends = |i: usize| info.feedback.is_none_or(|feedback| feedback.binary_search(&i).is_ok());
        let n_q = info.n_coordinates();
        let n = n_q + info.n_velocities() + info.n_states();
        let counted = (0..n).map(|i| i >= n_q || !info.coordinates[i].is_angle() || depends(i)).collect();
        let largest = |of: fn(&State) -> &[f64]| {
            let size = states.iter().flat_map(of).fold(0.0, |size: f64, x| size.max(x.abs()));
            if size > 0.0 { size } else { 1.0 }
        };
        let [q, v, z] = [largest(|state| &state.q), largest(|state| &state.v), largest(|state| &state.z)];
        let kind = |i: usize| {
            if i < n_q {
                q
            } else if i < 2 * n_q {
                v
            } else {
                z
            }
        };
        let sizes = (0..n).map(kind).collect();
        Ok(Self { system, info, symmetry, counted, sizes })
    }

    /// What does not return, of each coordinate, velocity and state.
    pub(super) fn left(&self, states: &[State]) -> DVector<f64> {
        let (first, last) = (&states[0], &states[states.len() - 1]);
        let left = values(&self.symmetry.back(first, last)) - values(first);
        DVector::from_fn(left.len(), |i, _| if self.counted[i] { left[i] } else { 0.0 })
    }

    /// The largest share of its size that something is away by.
    pub(super) fn share(&self, left: &DVector<f64>) -> f64 {
        left.iter().zip(&self.sizes).fold(0.0, |share: f64, (left, size)| share.max((left / size).abs()))
    }

    /// The basis of the tangent space, and what a period makes of it, moved back.
    pub(super) fn deviations(&mut self, states: &[State]) -> Result<(DMatrix<f64>, DMatrix<f64>), AnalysisError> {
        let (basis, mut x) = deviations(self.system, states)?;
        let moved = self.symmetry.moved(&states[0], &states[states.len() - 1]);
        turn_back(&mut x, states[0].q.len(), moved[2]);
        Ok((basis, x))
    }

    /// Takes away what need not return: a shift of the first body, and angles that nothing depends on.
    pub(super) fn counted(&self, state: &State, mut of: DMatrix<f64>) -> DMatrix<f64> {
        let mut directions = self.symmetry.directions(state);
        for i in (0..self.counted.len()).filter(|&i| !self.counted[i]) {
            of.row_mut(i).fill(0.0);
            directions.row_mut(i).fill(0.0);
        }
        let q = directions.qr().q();
        &of - &q * (q.tr_mul(&of))
    }

    /// Rates of coordinates, velocities and states, moved back with the last state.
    pub(super) fn rates(&mut self, first: &State, last: &State) -> Result<DVector<f64>, AnalysisError> {
        let moved = self.symmetry.moved(first, last);
        let mut rates = rates(self.system, last)?;
        turn_back(&mut rates, first.q.len(), moved[2]);
        Ok(rates.column(0).clone_owned())
    }

    /// Indices of angles that nothing depends on.
    pub(super) fn free_angles(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.counted.len()).filter(|&i| !self.counted[i])
    }

    /// The error that names what is farthest from its start.
    pub(super) fn no_return(&self, left: &DVector<f64>, period: f64, steps: usize) -> AnalysisError {
        let share = |i: &usize| (left[*i] / self.sizes[*i]).abs();
        let worst = (0..left.len()).max_by(|i, j| share(i).total_cmp(&share(j))).unwrap_or_default();
        let (what, unit) = name(&self.info, worst);
        AnalysisError::NoReturn { scene: self.info.name, what, left: left[worst].abs(), unit, period, steps }
    }
}

/// Name and unit of a coordinate, velocity or state.
pub(super) fn name(info: &SceneInfo, i: usize) -> (Name, &'static str) {
    let n_q = info.n_coordinates();
    match i {
        i if i < n_q => (info.coordinates[i].name.clone(), info.coordinates[i].unit),
        i if i < n_q + info.n_velocities() => (info.velocities[i - n_q].name.clone(), info.velocities[i - n_q].unit),
        i => {
            let state = &info.states[i - n_q - info.n_velocities()];
            (state.name.into(), state.unit)
        }
    }
}

/// Coordinates, velocities and states as one vector.
pub(super) fn values(state: &State) -> DVector<f64> {
    DVector::from_vec([&*state.q, &state.v, &state.z].concat())
}

/// Rates of coordinates, velocities and states.
fn rates<P: SceneRef>(system: &mut System<P>, state: &State) -> Result<DMatrix<f64>, AnalysisError> {
    let (a, _) = accelerations(system, state)?;
    let mut z = vec![0.0; state.z.len()];
    system.state_rates(state.t, &state.q, &state.v, &mut z);
    let rates = [&*state.v, &a, &z].concat();
    Ok(DMatrix::from_vec(rates.len(), 1, rates))
}

/// Whether the equations at some states are the same at times that are later by each of `shifts`.
fn is_same_later<P: SceneRef>(
    system: &mut System<P>,
    states: &[State],
    shifts: impl Fn(f64) -> Vec<[f64; 2]>,
) -> Result<bool, AnalysisError> {
    let mut gradients = Gradients::new(system)?;
    for state in states {
        let mut at = |t: f64| -> Result<DMatrix<f64>, AnalysisError> {
            let state = State { t, ..state.clone() };
            let rates = rates(system, &state)?;
            let flow = flow(system, &mut gradients, &state)?;
            let mut all = flow.insert_column(0, 0.0);
            all.column_mut(0).copy_from(&rates);
            Ok(all)
        };
        for [before, after] in shifts(state.t) {
            let (before, after) = (at(before)?, at(after)?);
            for (x, y) in before.column_iter().zip(after.column_iter()) {
                let size = x.amax().max(y.amax()).max(1.0);
                if (x - y).amax() > SAME * size {
                    return Ok(false);
                }
            }
        }
    }
    Ok(true)
}

/// Whether the equations depend on time.
pub(super) fn depends_on_time<P: SceneRef>(
    system: &mut System<P>,
    states: &[State],
    period: f64,
) -> Result<bool, AnalysisError> {
    Ok(!is_same_later(system, states, |t| SHARES.map(|share| [t, t + share * period]).to_vec())?)
}

/// Whether the equations are the same a period later.
pub(super) fn has_period<P: SceneRef>(
    system: &mut System<P>,
    states: &[State],
    period: f64,
) -> Result<bool, AnalysisError> {
    is_same_later(system, states, |t| SHARES.map(|share| [t + share * period, t + (1.0 + share) * period]).to_vec())
}
