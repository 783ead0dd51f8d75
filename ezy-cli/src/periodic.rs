//! The command `periodic`. Without the feature `analysis`, how to get it.

use super::Models;
use super::failure::Failure;
use super::periodic_arguments::PeriodicArguments;

#[cfg(not(feature = "analysis"))]
pub(super) fn periodic(_: Models<'_>, _: &PeriodicArguments) -> Result<(), Failure> {
    Err(super::linearize::without_analysis())
}

#[cfg(feature = "analysis")]
pub(super) use with_analysis::periodic;

#[cfg(feature = "analysis")]
mod with_analysis {
    use super::super::motion::refused;
    use super::super::periodic_text::Found;
    use super::super::shown::Forms;
    use super::super::steady::{Request, failed};
    use super::{Failure, Models, PeriodicArguments};
    use ezy_core::analysis::{AnalysisError, Period, PeriodicMotion};
    use ezy_core::dynamics::State;
    use ezy_core::integrate::Method;
    use ezy_core::model::{Scene, SceneInfo, Start};
    use ezy_core::simulate::Simulation;

    /// Why a search ended: a run, or the analysis.
    enum Ended {
        Run(Failure),
        Analysis(AnalysisError),
    }

    impl From<AnalysisError> for Ended {
        fn from(error: AnalysisError) -> Self {
            Self::Analysis(error)
        }
    }

    pub(in super::super) fn periodic(models: Models<'_>, arguments: &PeriodicArguments) -> Result<(), Failure> {
        let PeriodicArguments { period, period_near, after, rtol, out, plot, json, .. } = arguments;
        let forms = Forms::new("motions", out.as_deref(), plot.as_deref(), *json)?;
        let period = match (period, period_near) {
            (Some(period), _) => Period::Given(*period),
            (None, near) => Period::Near(near.unwrap_or_default()),
        };
        let (Period::Given(length) | Period::Near(length)) = period;
        if length <= 0.0 {
            return Err(failed(AnalysisError::Period { period: length }));
        }
        let request = Request::new(models, &arguments.steady)?;
        let scene = request.scene()?;
        let (mut system, mut start) =
            request.simulation(scene.as_ref(), Method::default())?.system_at_start().map_err(refused)?;
        let info = request.info();
        let flow = |state: &State, times: &[f64]| {
            let simulation = request.simulation(scene.as_ref(), Method::dop853(*rtol))?;
            states(simulation, &info, state, times)
        };
        if *after > 0 {
            let state = system.consistent_start(&start).map_err(|error| failed(error.into()))?;
            let states = flow(&state, &[state.t, state.t + f64::from(*after) * length])?;
            near(&mut start, &info, &states[states.len() - 1]);
        }
        let mut flow = |state: &State, times: &[f64]| flow(state, times).map_err(Ended::Run);
        let motion = PeriodicMotion::near(&mut system, &start, period, &request.hold(), &mut flow);
        let motion = motion.map_err(|ended| match ended {
            Ended::Run(failure) => failure,
            Ended::Analysis(error) => failed(error),
        })?;
        forms.show(&Found { info: &info, motion: &motion })
    }

    /// States of a run from a state.
    fn states<'s>(
        mut simulation: Simulation<'s, &'s (dyn Scene + 's)>,
        info: &SceneInfo,
        state: &State,
        times: &[f64],
    ) -> Result<Vec<State>, Failure> {
        let names = info.coordinates.iter().chain(&*info.velocities).map(|c| &*c.name);
        let names = names.chain(info.states.iter().map(|state| state.name));
        for (name, value) in names.zip(state.q.iter().chain(&state.v).chain(&state.z)) {
            simulation = simulation.start(name, *value);
        }
        let until_s = times.last().copied().unwrap_or_default();
        let run = simulation.until(until_s).at(times.iter().copied()).project_start().run().map_err(refused)?;
        if run.samples().len() < times.len() {
            return Err(Failure::stopped(format!("a run of {until_s} s, the period that was tried, {}", run.outcome)));
        }
        let of = |sample: ezy_core::record::Sample<'_>| State {
            t: sample.t,
            q: sample.coordinates.to_vec(),
            v: sample.velocities.to_vec(),
            z: sample.states.to_vec(),
            work: state.work.clone(),
        };
        Ok(run.samples().map(of).collect())
    }

    /// Begins at a state; the time stays.
    fn near(start: &mut Start, info: &SceneInfo, state: &State) {
        state.q.iter().enumerate().for_each(|(i, q)| start.near_position(i, *q));
        state.v.iter().enumerate().for_each(|(i, v)| start.near_velocity(i, *v));
        state.z.iter().enumerate().for_each(|(i, z)| start.give_state(info, i, *z));
    }
}
