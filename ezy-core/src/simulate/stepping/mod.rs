//! One step at a time: a state with its accelerations, the step that leads on, and the way across singular positions.

mod projected_stages;
pub(in crate::simulate) mod schedule;
pub(in crate::simulate) mod singular;
pub(in crate::simulate) mod singular_positions;
pub(in crate::simulate) mod singularity_crossing;
pub(in crate::simulate) mod snapshot;
pub(in crate::simulate) mod solver;
pub(in crate::simulate) mod starts;
pub(in crate::simulate) mod state_projection;
mod step_method;
pub(in crate::simulate) mod stepper_state;
