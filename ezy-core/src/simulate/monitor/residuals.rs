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
    residual: Option<Largest>,
    /// The largest one that a projection removed; none where nothing is projected.
    drift: Option<Largest>,
}

/// A residual with its time, s.
#[derive(Clone, Copy)]
struct Largest {
    worst: Worst,
    t: f64,
}

impl ResidualWatch {
    /// At the start, at `t`, where the largest residual is `worst`, if there are rows. `projects`: whether the level is projected.
    pub(super) fn new(level: &'static str, worst: Option<Worst>, projects: bool, t: f64) -> Self {
        let drift = (worst.is_some() && projects).then(|| Largest { worst: Worst::default(), t });
        Self { level, residual: worst.map(|worst| Largest { worst, t }), drift }
    }

    /// Sees what a projection removed at `t`.
    pub(super) fn see_removed(&mut self, removed: Worst, t: f64) {
        raise(&mut self.drift, removed, t);
    }

    /// Sees the largest residual of a state at `t`. One beyond the limit is not counted.
    pub(super) fn see(&mut self, worst: Worst, limit: f64, t: f64, info: &SceneInfo) -> Result<(), ExceededLimit> {
        if !keeps(worst.value, limit) {
            let (level, row) = (self.level, info.rows.item(worst.row).name);
            return Err(ExceededLimit::Drift { t, level, row, value: worst.value, limit });
        }
        raise(&mut self.residual, worst, t);
        Ok(())
    }

    /// The largest residual, and the largest one that a projection removed.
    pub(super) fn peaks(&self, info: &SceneInfo) -> [Option<Peak>; 2] {
        let peak = |Largest { worst, t }| Peak { value: worst.value, t, row: info.rows.item(worst.row).name };
        [self.residual, self.drift].map(|largest| largest.map(peak))
    }
}

/// Raises a largest residual; a NaN stays.
fn raise(largest: &mut Option<Largest>, worst: Worst, t: f64) {
    let raises = largest.is_none_or(|largest| worst.value.is_nan() || worst.value > largest.worst.value);
    if raises {
        *largest = Some(Largest { worst, t });
    }
}
