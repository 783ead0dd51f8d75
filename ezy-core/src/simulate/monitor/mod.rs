//! Monitors of a run: residuals, drift, energy, steps; and the limits that end it.

mod caller;
mod condition;
mod energy;
mod limits;
pub(in crate::simulate) mod processor_time;
pub(in crate::simulate) mod rank_watch;
mod residuals;
mod steps;
mod watch;

pub(super) use caller::Caller;
pub use condition::ConditionPeak;
pub use energy::EnergyError;
pub use limits::ExceededLimit;
pub(super) use limits::Limits;
pub(super) use watch::Watch;

use crate::model::Name;

/// The monitors of a run, over all of its steps.
#[derive(Debug, Clone, PartialEq)]
pub struct Monitors {
    /// Largest residual of a position constraint in the states that the run went through, m or rad; none without such rows. A stop
    /// that holds is one.
    pub position_residual: Option<Peak>,
    /// Largest residual of a row at velocity level in these states, m/s or rad/s; none without rows. Looked at where the
    /// run starts and ends and after every sixteenth step; after every step when `max_drift` was ordered.
    pub velocity_residual: Option<Peak>,
    /// Largest residual of a position constraint that a projection removed after a step, zero where all steps end on the rows by themselves; none when
    /// positions are not projected.
    pub position_drift: Option<Peak>,
    /// Largest residual of a row at velocity level that a projection removed; none when velocities are not projected.
    pub velocity_drift: Option<Peak>,
    /// Largest energy balance; none where effects do work that the run does not integrate.
    pub energy: Option<EnergyError>,
    /// Smallest relative pivot at ends and stages of all steps ([`Solved::smallest_pivot`](crate::dynamics::Solved::smallest_pivot));
    /// none without rows.
    pub pivot: Option<LeastPivot>,
    /// Condition of the equations of motion; none without rows, and in scenes of more than 200 unknowns.
    pub condition: Option<ConditionPeak>,
    /// The softest impact on a stop; none without impacts.
    pub softest_impact: Option<SoftestImpact>,
    /// Shortest and longest step, s; none in a run without a step. The shortest may be what was left to the end.
    pub steps_s: Option<[f64; 2]>,
}

/// A smallest pivot, with its time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LeastPivot {
    /// The pivot, relative to what it started from; zero where constraints depended on each other.
    pub value: f64,
    /// Its time, s.
    pub t: f64,
}

/// The impact of the smallest speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SoftestImpact {
    /// Speed of approach, m/s or rad/s.
    pub speed: f64,
    /// Its time, s.
    pub t: f64,
}

/// A largest value, with its time and row.
#[derive(Debug, Clone, PartialEq)]
pub struct Peak {
    /// The value.
    pub value: f64,
    /// Its time, s.
    pub t: f64,
    /// Name of the row.
    pub row: Name,
}
