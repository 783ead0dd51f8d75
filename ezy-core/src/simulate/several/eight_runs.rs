//! Eight runs of one scene in lanes.

use super::trajectory::{Trajectory, check_end, checked};
use crate::dynamics::{InLanes, MotionError, State, System, SystemOf};
use crate::integrate::{InQuasiVelocities, Method, MethodKind};
use crate::model::{Eight, N_LANES, SceneRef};
use crate::scalar::packed;
use crate::simulate::SetupError;
use std::array::from_fn;
use std::sync::Arc;

/// One to eight runs of one scene that step together; the last one fills the lanes that are left.
pub(in crate::simulate) struct EightRuns<P> {
    form: Form<P>,
}

/// `dop853` takes quasi-velocities where the scene has them: fewer numbers, fewer operations, and no rows to project onto.
enum Form<P> {
    OfRows(Trajectory<SystemOf<InLanes<P>, Eight>, Eight>),
    InQuasiVelocities(InQuasiVelocities<P>),
}

impl<P: SceneRef> EightRuns<P> {
    /// Runs by the kernels of `scene`, each with its constants in `fixed`, from `starts`, which meet the rows and have one time; `first` is the system of the first run.
    ///
    /// # Errors
    /// [`SetupError`] when the scene or the method cannot be used.
    pub(in crate::simulate) fn new(
        scene: P,
        first: &System<P>,
        fixed: &[&[f64]],
        starts: &[&State],
        method: Method,
    ) -> Result<Self, SetupError> {
        let of_run = |lane: usize| lane.min(starts.len() - 1);
        let info = Arc::clone(first.info());
        let fixed = packed(from_fn::<_, N_LANES, _>(|lane| fixed[of_run(lane)]));
        let state_of = |lane: usize| starts[of_run(lane)];
        let q = packed(from_fn(|lane| &state_of(lane).q[..]));
        let v = packed(from_fn(|lane| &state_of(lane).v[..]));
        let z = packed(from_fn(|lane| &state_of(lane).z[..]));
        let t = starts[0].t;
        let start = State { t, q, v, z, work: Vec::new() };
        let method = checked(&info, method)?;
        let tolerance = method.tolerance().filter(|_| method.kind() == MethodKind::Dop853 && start.z.is_empty());
        let quasi = tolerance.and_then(|tolerance| InQuasiVelocities::new(scene.clone(), &fixed, &start, tolerance));
        let form = match quasi {
            Some(runs) => Form::InQuasiVelocities(runs),
            None => {
                let system = SystemOf::new(InLanes(scene), first, fixed);
                Form::OfRows(Trajectory::new(system, info, start, method)?)
            }
        };
        Ok(Self { form })
    }

    /// Steps all runs to `until_s`; nothing happens when they are there already.
    ///
    /// # Errors
    /// [`MotionError`] of any run; the state is then the last good one.
    pub(in crate::simulate) fn advance(&mut self, until_s: f64) -> Result<(), MotionError> {
        match &mut self.form {
            Form::OfRows(trajectory) => trajectory.advance(until_s),
            Form::InQuasiVelocities(runs) => {
                check_end(runs.time(), until_s)?;
                while runs.time() < until_s {
                    runs.step(until_s)?;
                }
                Ok(())
            }
        }
    }

    /// One step towards `until_s`, of a method that chooses its steps.
    ///
    /// # Errors
    /// As [`EightRuns::advance`].
    pub(in crate::simulate) fn step_towards(&mut self, until_s: f64) -> Result<(), MotionError> {
        match &mut self.form {
            Form::OfRows(trajectory) => trajectory.step(until_s - trajectory.now.t, until_s),
            Form::InQuasiVelocities(runs) => runs.step(until_s),
        }
    }

    /// How many steps a run would have taken so far if it had chosen them alone, to compare runs; zero where that is not known.
    pub(in crate::simulate) fn n_steps_of_its_own(&self, lane: usize) -> f64 {
        match &self.form {
            Form::OfRows(_) => 0.0,
            Form::InQuasiVelocities(runs) => runs.n_steps_of_its_own(lane),
        }
    }

    /// Present time, s.
    pub(in crate::simulate) fn time(&self) -> f64 {
        match &self.form {
            Form::OfRows(trajectory) => trajectory.now.t,
            Form::InQuasiVelocities(runs) => runs.time(),
        }
    }

    /// The smallest pivot so far. In quasi-velocities there are none: rows that give velocities by pivots of parameters alone never become dependent.
    pub(in crate::simulate) fn smallest_pivot(&self) -> f64 {
        match &self.form {
            Form::OfRows(trajectory) => trajectory.system.smallest_pivot,
            Form::InQuasiVelocities(_) => f64::INFINITY,
        }
    }

    /// Where a run is, without works.
    pub(in crate::simulate) fn state(&self, lane: usize) -> State {
        let of_lane = |x: &[Eight]| x.iter().map(|x| x.0[lane]).collect();
        let [q, v, z] = match &self.form {
            Form::OfRows(Trajectory { now, .. }) => [&now.q[..], &now.v, &now.z].map(of_lane),
            Form::InQuasiVelocities(runs) => {
                let [q, v] = runs.state().map(of_lane);
                [q, v, Vec::new()]
            }
        };
        State { t: self.time(), q, v, z, work: Vec::new() }
    }
}
