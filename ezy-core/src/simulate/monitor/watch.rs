//! The monitors, step by step.

use super::condition::ConditionWatch;
use super::energy::EnergyWatch;
use super::limits::keeps;
use super::residuals::ResidualWatch;
use super::steps::StepWatch;
use super::{EnergyError, ExceededLimit, LeastPivot, Limits, Monitors};
use crate::dynamics::{Projected, Projection, Rows, State, System};
use crate::model::{SceneInfo, SceneRef};
use crate::simulate::tolerances::monitors::N_BETWEEN_LOOKS;

/// The monitors of a run under way.
pub(in crate::simulate) struct Watch {
    limits: Limits,
    projection: Projection,
    steps: StepWatch,
    positions: ResidualWatch,
    velocities: ResidualWatch,
    pivot: Option<LeastPivot>,
    energy: Option<EnergyWatch>,
    condition: Option<Box<ConditionWatch>>,
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
        let State { t, q, v, .. } = start;
        system.counters().take_least_pivot();
        let [n_position_rows, n_rows] = system.active().n_on();
        let (of_positions, of_rows) = (n_position_rows > 0, n_rows > 0);
        let position = of_positions.then(|| system.projector().worst_position(*t, q));
        let velocity = of_rows.then(|| system.projector().worst_velocity(*t, q, v));
        let measured = work || system.info().n_effects() == 0;
        Self {
            limits,
            projection,
            steps: StepWatch::new(*t),
            positions: ResidualWatch::new("position", position, projection.positions(), *t),
            velocities: ResidualWatch::new("velocity", velocity, projection.velocities(), *t),
            pivot: of_rows.then(|| LeastPivot { value: system.at_with(*t, q, Rows::Held).pivot_at_hand(), t: *t }),
            condition: ConditionWatch::new(system, start),
            energy: measured.then(|| EnergyWatch::new(system, start)),
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
        self.steps.admit(&self.limits, chooses_steps, n_rejected, t, end)
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
        let pivot = system.counters().take_least_pivot();
        let [_, n_rows] = system.active().n_on();
        if n_rows > 0 && self.pivot.is_none_or(|least| pivot < least.value) {
            self.pivot = Some(LeastPivot { value: pivot, t: state.t });
        }
        self.steps.count(state.t - from);
        if let Some(condition) = &mut self.condition {
            condition.look(system, state, self.steps.n, last);
        }
        Ok(())
    }

    fn look_at_positions<P: SceneRef>(
        &mut self,
        system: &mut System<P>,
        state: &State,
        projected: &Projected,
    ) -> Result<(), ExceededLimit> {
        if system.active().n_on()[0] == 0 {
            return Ok(());
        }
        let worst = if self.projection.positions() {
            self.positions.see_removed(projected.positions_before, state.t);
            projected.positions_after
        } else {
            system.projector().worst_position(state.t, &state.q)
        };
        self.positions.see(worst, self.limits.drift, state.t, system.info())
    }

    fn look_at_velocities<P: SceneRef>(
        &mut self,
        system: &mut System<P>,
        state: &State,
        projected: &Projected,
        last: bool,
    ) -> Result<(), ExceededLimit> {
        if system.active().n_on()[1] == 0 {
            return Ok(());
        }
        if self.projection.velocities() {
            self.velocities.see_removed(projected.velocities_before, state.t);
        }
        let looks = last || self.limits.drift.is_finite() || self.steps.n.is_multiple_of(N_BETWEEN_LOOKS);
        if !looks {
            return Ok(());
        }
        let worst = system.projector().worst_velocity(state.t, &state.q, &state.v);
        self.velocities.see(worst, self.limits.drift, state.t, system.info())
    }

    /// Whether an energy balance speaks for the run. That of fixed steps can be too large, unless a limit was set.
    pub(crate) fn trusts(&self, energy: EnergyError, chooses_steps: bool) -> bool {
        chooses_steps || self.limits.energy_error.is_finite() || energy.may_be_of_fixed_steps()
    }

    /// What was watched, beside impacts. An energy balance below `rounding_j`, J, is rounding.
    pub(crate) fn monitors(&self, info: &SceneInfo, rounding_j: f64) -> Monitors {
        let without_rounding = |energy: EnergyError| match energy.joules.abs() <= rounding_j {
            true => EnergyError { relative: 0.0, ..energy },
            false => energy,
        };
        let [position_residual, position_drift] = self.positions.peaks(info);
        let [velocity_residual, velocity_drift] = self.velocities.peaks(info);
        Monitors {
            position_residual,
            velocity_residual,
            position_drift,
            velocity_drift,
            pivot: self.pivot,
            energy: self.energy.as_ref().map(|energy| without_rounding(energy.largest)),
            condition: self.condition.as_ref().map(|condition| condition.peak(info)),
            softest_impact: None,
            steps_s: self.steps.range_s(),
        }
    }
}
