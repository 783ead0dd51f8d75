//! Which values are looked at.

use crate::dynamics::{MotionError, System};
use crate::model::Scene;

/// What passes zero.
pub(in crate::simulate) enum Sought {
    /// The events of the scene.
    Events,
    /// What the row of a skate that holds has left up to its limit.
    Reserve { row: usize, a: Vec<f64>, lambda: Vec<f64> },
    /// The velocity across a skate that slides, to this side.
    Slide { side: f64 },
}

impl Sought {
    pub fn read<S: Scene + ?Sized>(
        &mut self,
        system: &mut System<'_, S>,
        t: f64,
        [q, v]: [&[f64]; 2],
        out: &mut [f64],
    ) -> Result<(), MotionError> {
        match self {
            Self::Events => system.events(t, q, v, out),
            Self::Reserve { row, a, lambda } => {
                system.accelerations(t, q, v, a, lambda)?;
                let [limit, _] = system.grip(t, q, v);
                out.fill(limit - lambda[*row].abs());
            }
            Self::Slide { side } => {
                let [_, velocity] = system.grip(t, q, v);
                out.fill(*side * velocity);
            }
        }
        Ok(())
    }
}
