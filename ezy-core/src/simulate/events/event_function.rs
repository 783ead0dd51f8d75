//! The event functions.

use crate::dynamics::{MotionError, Rows, State, System};
use crate::model::{SceneRef, StickSlipInfo, StopInfo};

/// What is located.
pub(in crate::simulate) enum EventFunction {
    /// The events of the scene.
    Events,
    /// Limit less reaction of a skate that holds.
    Reserve { info: &'static StickSlipInfo, a: Vec<f64>, lambda: Vec<f64> },
    /// Velocity across a skate that slides to this side.
    Slide { info: &'static StickSlipInfo, side: f64 },
    /// Distances to the ends of a stop; `values` is a buffer.
    Gaps { info: &'static StopInfo, values: Vec<f64> },
    /// Force of a closed contact on this side.
    Push { row: usize, side: f64, a: Vec<f64>, lambda: Vec<f64> },
}

impl EventFunction {
    pub(crate) fn read<P: SceneRef>(
        &mut self,
        system: &mut System<P>,
        at: &State,
        out: &mut [f64],
    ) -> Result<(), MotionError> {
        let State { t, q, v, z, .. } = at;
        let t = *t;
        system.place_states(z);
        match self {
            Self::Events => system.events(t, q, v, out),
            Self::Reserve { info, a, lambda } => {
                system.accelerations_unchecked(t, q, v, a, lambda, Rows::Projected)?;
                let [limit, _] = system.checked_stick_slip(info, t, q, v)?;
                out.fill(limit - lambda[info.row].abs());
            }
            Self::Slide { info, side } => {
                let [_, velocity] = system.checked_stick_slip(info, t, q, v)?;
                out.fill(*side * velocity);
            }
            Self::Gaps { info, values } => {
                system.checked_stop(info, t, q, v, values)?;
                out.iter_mut().zip(values.iter().step_by(2)).for_each(|(out, gap)| *out = *gap);
            }
            Self::Push { row, side, a, lambda } => {
                system.accelerations_unchecked(t, q, v, a, lambda, Rows::Projected)?;
                out.fill(-*side * lambda[*row]);
            }
        }
        Ok(())
    }
}
