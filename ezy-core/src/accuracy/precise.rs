//! The reference in double-double arithmetic.

use std::time::Instant;

use super::runs::Runs;
use super::trajectory::Trajectory;
use crate::dynamics::State;
use crate::integrate::PreciseMotion;
use crate::record::Sample;

/// How it is named in reports.
pub(super) const NAME: &str = "Taylor's method of order 38 in double-double, with 31 digits";

/// The motion from `start` at each of `times`, rounded to f64, or why there is none.
pub(super) fn precise(
    runs: &Runs<'_>,
    start: &Sample<'_>,
    times: &[f64],
    deadline: Instant,
) -> Result<Trajectory, String> {
    if !runs.inputs.is_empty() {
        return Err("inputs are set, and the motion in double-double takes them as declared".to_owned());
    }
    let state = State { t: start.t, q: start.coordinates.to_vec(), v: start.velocities.to_vec(), work: Vec::new() };
    let mut motion = PreciseMotion::new(runs.scene, &state).map_err(|error| error.to_string())?;
    let mut trajectory = Trajectory::empty(start.info);
    for &t in times {
        motion.advance_to(t).map_err(|error| error.to_string())?;
        if Instant::now() >= deadline {
            return Err(format!("the motion in double-double had come to t = {t} s when its time was over"));
        }
        let [q, v, lambda] = [motion.q(), motion.v(), motion.lambda()]
            .map(|numbers| numbers.iter().map(|x| x.high()).collect::<Vec<f64>>());
        trajectory.push(t, &q, &v, &lambda);
    }
    Ok(trajectory)
}
