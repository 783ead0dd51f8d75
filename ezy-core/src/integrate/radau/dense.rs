//! Values between the ends of a step.

use super::Radau;
use super::stages::add_combination;
use super::tableau::{N_STAGES, remainder, through_start_and_nodes};
use crate::dynamics::State;

impl Radau {
    /// The state at the part `s`, between 0 and 1, of the step that was made last, from `from` to `to`, which may be
    /// projected; not projected itself. The time is left alone.
    ///
    /// The polynomial of degree 3 through the start and the stages, and its first remainder, which the error estimate knows:
    /// of order 4. What projection changed at the end is spread over the step.
    pub(crate) fn dense_at(&self, from: &State, to: &State, s: f64, out: &mut State) {
        let (weights, left) = (through_start_and_nodes(s), remainder(s));
        let (stages, error, end) = (&self.stages, &self.error, N_STAGES - 1);
        for (out, from, to, stages, error) in [
            (&mut out.q, &from.q, &to.q, &stages.q, &error.q),
            (&mut out.v, &from.v, &to.v, &stages.v, &error.v),
            (&mut out.z, &from.z, &to.z, &stages.z, &error.z),
            (&mut out.work, &from.work, &to.work, &stages.work, &error.work),
        ] {
            for (i, out) in out.iter_mut().enumerate() {
                let change = to[i] - (from[i] + stages[end][i]);
                *out = from[i] + s * change + left * error[i];
            }
            add_combination(&weights, stages, out);
        }
    }
}
