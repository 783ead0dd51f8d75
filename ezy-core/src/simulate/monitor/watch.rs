//! The monitors, step by step.

use super::condition::ConditionWatch;
use super::energy::EnergyWatch;
use super::{EnergyError, ExceededLimit, LeastPivot, Limits, Monitors, Peak};
use crate::dynamics::{Projected, Projection, State, System, Worst};
use crate::model::{SceneInfo, SceneRef};
use crate::simulate::tolerances::monitors::{ATTEMPTS_OF_A_PACE, N_BETWEEN_LOOKS};
use std::sync::Arc;

/// The monitors of a run under way.
pub(in crate::simulate) struct Watch {
    /// Rows at the start.
    n_rows: usize,
    /// Attempted steps and time, s, from which the present pace counts.
    pace_from: (u64, f64),
    limits: Limits,
    projection: Projection,
    n_steps: u64,
    position_residual: Option<Peak>,
    velocity_residual: Option<Peak>,
    position_drift: Option<Peak>,
    velocity_drift: Option<Peak>,
    pivot: Option<LeastPivot>,
    energy: Option<EnergyWatch>,
    condition: Option<Box<ConditionWatch>>,
    shortest_s: f64,
    longest_s: f64,
    last_s: f64,
}

impl Watch {
    /// From the start of a run. `work`: whether the run integrates works.
    pub(crate) fn new<P: SceneRef>(
        system: &mut System<P>,
        start: &State,
        limits: Limits,
        projection: Projection,
        work: bool,
    ) -> Self {
        let info = Arc::clone(system.info());
        let State { t, q, v, .. } = start;
        system.take_least_pivot();
        let peak = |worst: Worst| Peak { value: worst.value, t: *t, row: info.rows[worst.row].name.clone() };
        let (of_positions, of_rows) = (info.n_position_rows > 0, info.n_rows() > 0);
        let measured = work || info.n_effects() == 0;
        Self {
            n_rows: info.n_rows(),
            pace_from: (0, *t),
            limits,
            projection,
            n_steps: 0,
            position_residual: of_positions.then(|| peak(system.worst_position(*t, q))),
            velocity_residual: of_rows.then(|| peak(system.worst_velocity(*t, q, v))),
            position_drift: (of_positions && projection.positions()).then(|| peak(Worst::default())),
            velocity_drift: (of_rows && projection.velocities()).then(|| peak(Worst::default())),
            pivot: of_rows.then(|| LeastPivot { value: system.pivot_at(*t, q), t: *t }),
            condition: ConditionWatch::new(system, start),
            energy: measured.then(|| EnergyWatch::new(system, start)),
            shortest_s: f64::INFINITY,
            longest_s: 0.0,
            last_s: 0.0,
        }
    }

    /// Whether another step may be taken from `t` towards `end`, s; `n_rejected` were rejected.
    pub(crate) fn admits_step(
        &mut self,
        chooses_steps: bool,
        n_rejected: u64,
        t: f64,
        end: f64,
    ) -> Result<(), ExceededLimit> {
        let limit = self.limits.most_steps(chooses_steps);
        let attempts = self.n_steps + n_rejected;
        if attempts >= limit {
            return Err(ExceededLimit::Steps { limit, step_s: self.last_s });
        }
        let (since, from) = self.pace_from;
        if self.limits.steps.is_some() || !chooses_steps || attempts - since < ATTEMPTS_OF_A_PACE {
            return Ok(());
        }
        self.pace_from = (attempts, t);
        let pace_s = (t - from) / (attempts - since) as f64;
        let needed = (end - t) / pace_s;
        if needed <= limit as f64 { Ok(()) } else { Err(ExceededLimit::Pace { attempts, pace_s, needed, limit }) }
    }

    /// Monitors the projected end of a step that began at `from`, s. A state beyond a limit is not counted.
    pub(crate) fn look<P: SceneRef>(
        &mut self,
        system: &mut System<P>,
        from: f64,
        state: &State,
        projected: &Projected,
        last: bool,
    ) -> Result<(), ExceededLimit> {
        self.look_at_positions(system, state, projected)?;
        self.look_at_velocities(system, state, projected, last)?;
        if let Some(energy) = &mut self.energy {
            let (now, limit) = (energy.balance(system, state), self.limits.energy_error);
            if !keeps(now.relative, limit) {
                let EnergyError { joules, relative, t } = now;
                return Err(ExceededLimit::EnergyError { t, joules, relative, limit });
            }
            energy.keep(now);
        }
        let pivot = system.take_least_pivot();
        if system.info().n_rows() > 0 && self.pivot.is_none_or(|least| pivot < least.value) {
            self.pivot = Some(LeastPivot { value: pivot, t: state.t });
        }
        self.n_steps += 1;
        // only with the constraints of the start
        if let Some(condition) = &mut self.condition
            && system.info().n_rows() == self.n_rows
        {
            condition.look(system, state, self.n_steps, last);
        }
        self.last_s = state.t - from;
        self.shortest_s = self.shortest_s.min(self.last_s);
        self.longest_s = self.longest_s.max(self.last_s);
        Ok(())
    }

    fn look_at_positions<P: SceneRef>(
        &mut self,
        system: &mut System<P>,
        state: &State,
        projected: &Projected,
    ) -> Result<(), ExceededLimit> {
        if system.info().n_position_rows == 0 {
            return Ok(());
        }
        let worst = if self.projection.positions() {
            raise(&mut self.position_drift, projected.positions_before, state.t, system.info());
            projected.positions_after
        } else {
            system.worst_position(state.t, &state.q)
        };
        self.check(system.info(), worst, state.t, "position")?;
        raise(&mut self.position_residual, worst, state.t, system.info());
        Ok(())
    }

    fn look_at_velocities<P: SceneRef>(
        &mut self,
        system: &mut System<P>,
        state: &State,
        projected: &Projected,
        last: bool,
    ) -> Result<(), ExceededLimit> {
        if system.info().n_rows() == 0 {
            return Ok(());
        }
        if self.projection.velocities() {
            raise(&mut self.velocity_drift, projected.velocities_before, state.t, system.info());
        }
        let looks = last || self.limits.drift.is_finite() || self.n_steps.is_multiple_of(N_BETWEEN_LOOKS);
        if !looks {
            return Ok(());
        }
        let worst = system.worst_velocity(state.t, &state.q, &state.v);
        self.check(system.info(), worst, state.t, "velocity")?;
        raise(&mut self.velocity_residual, worst, state.t, system.info());
        Ok(())
    }

    fn check(&self, info: &SceneInfo, worst: Worst, t: f64, level: &'static str) -> Result<(), ExceededLimit> {
        let limit = self.limits.drift;
        if keeps(worst.value, limit) {
            return Ok(());
        }
        Err(ExceededLimit::Drift { t, level, row: info.rows[worst.row].name.clone(), value: worst.value, limit })
    }

    /// Whether an energy balance speaks for the run. That of fixed steps can be too large, unless a limit was set.
    pub(crate) fn trusts(&self, energy: EnergyError, chooses_steps: bool) -> bool {
        chooses_steps || self.limits.energy_error.is_finite() || energy.may_be_of_fixed_steps()
    }

    /// What was watched. An energy balance below `rounding_j`, J, is rounding.
    pub(crate) fn monitors(&self, rounding_j: f64) -> Monitors {
        let without_rounding = |energy: EnergyError| match energy.joules.abs() <= rounding_j {
            true => EnergyError { relative: 0.0, ..energy },
            false => energy,
        };
        Monitors {
            position_residual: self.position_residual.clone(),
            velocity_residual: self.velocity_residual.clone(),
            position_drift: self.position_drift.clone(),
            velocity_drift: self.velocity_drift.clone(),
            pivot: self.pivot,
            energy: self.energy.as_ref().map(|energy| without_rounding(energy.largest)),
            condition: self.condition.as_ref().map(|condition| condition.peak.clone()),
            steps_s: (self.n_steps > 0).then_some([self.shortest_s, self.longest_s]),
        }
    }
}

/// Whether a value is within a limit; NaN is not.
fn keeps(value: f64, limit: f64) -> bool {
    value <= limit || limit == f64::INFINITY
}

/// Raises a peak; a NaN stays. The name is written over that of the last peak, since a step does not allocate.
fn raise(peak: &mut Option<Peak>, worst: Worst, t: f64, info: &SceneInfo) {
    let row = || &info.rows[worst.row].name;
    match peak {
        Some(peak) if worst.value.is_nan() || worst.value > peak.value => {
            (peak.value, peak.t) = (worst.value, t);
            peak.row.clone_from(row());
        }
        Some(_) => {}
        None => *peak = Some(Peak { value: worst.value, t, row: row().clone() }),
    }
}
