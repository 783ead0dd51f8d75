//! The event functions.

use super::laws;
use crate::dynamics::{MotionError, Rows, State, System};
use crate::model::{Equations as _, SceneRef, StopInfo};

/// What is located.
pub(in crate::simulate) enum EventFunction {
    /// The events of the scene.
    Events,
    /// Limit less reaction of a skate that holds, by its place among those with a limit; here and below vectors are buffers.
    Reserve { skate: usize, a: Vec<f64>, lambda: Vec<f64>, values: Vec<f64> },
    /// Velocity across a skate that slides to this side.
    Slide { skate: usize, side: f64, values: Vec<f64> },
    /// Distances to the ends of a stop.
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
            Self::Events => system.scene().events(system.fixed(), t, q, v, out),
            Self::Reserve { skate, a, lambda, values } => {
                system.at_with(t, q, Rows::Projected).accelerations(v, a, lambda)?;
                let [limit, _] = laws::limited_skate(system, *skate, t, q, v, values)?;
                out.fill(limit - lambda[system.info().limited_skates[*skate].row].abs());
            }
            Self::Slide { skate, side, values } => {
                let [_, velocity] = laws::limited_skate(system, *skate, t, q, v, values)?;
                out.fill(*side * velocity);
            }
            Self::Gaps { info, values } => {
                laws::stop(system, info, t, q, v, values)?;
                out.iter_mut().zip(values.iter().step_by(2)).for_each(|(out, gap)| *out = *gap);
            }
            Self::Push { row, side, a, lambda } => {
                system.at_with(t, q, Rows::Projected).accelerations(v, a, lambda)?;
                out.fill(-*side * lambda[*row]);
            }
        }
        Ok(())
    }
}
