//! Residuals of rows, and what projections remove of them.

use super::limits::keeps;
use super::{ExceededLimit, Peak};
use crate::dynamics::Worst;
use crate::model::SceneInfo;

/// The rows at one level over a run.
pub(super) struct ResidualWatch {
    /// `position` or `velocity`.
    level: &'static str,
    /// The largest residual in the states that the run went through; none without rows.
    pub residual: Option<Peak>,
    /// The largest one that a projection removed; none where nothing is projected.
    pub drift: Option<Peak>,
}

impl ResidualWatch {
    /// At the start, at `t`, where the largest residual is `worst`, if there are rows. `projects`: whether the level is projected.
    pub(super) fn new(level: &'static str, worst: Option<Worst>, projects: bool, t: f64, info: &SceneInfo) -> Self {
        let peak = |worst: Worst| Peak { value: worst.value, t, row: info.rows[worst.row].name.clone() };
        Self { level, residual: worst.map(peak), drift: (worst.is_some() && projects).then(|| peak(Worst::default())) }
    }

    /// Sees what a projection removed at `t`.
    pub(super) fn see_removed(&mut self, removed: Worst, t: f64, info: &SceneInfo) {
        raise(&mut self.drift, removed, t, info);
    }

    /// Sees the largest residual of a state at `t`. One beyond the limit is not counted.
    pub(super) fn see(&mut self, worst: Worst, limit: f64, t: f64, info: &SceneInfo) -> Result<(), ExceededLimit> {
        if !keeps(worst.value, limit) {
            let (level, row) = (self.level, info.rows[worst.row].name.clone());
            return Err(ExceededLimit::Drift { t, level, row, value: worst.value, limit });
        }
        raise(&mut self.residual, worst, t, info);
        Ok(())
    }
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
