//! Runs of one scene with parameters and starts of their own that step together, eight at once; only their ends are known.

use super::eight_runs::EightRuns;
use crate::dynamics::{Metric, Projection, Rows, State, System};
use crate::integrate::{Method, MethodKind, Tolerance};
use crate::linalg::Backend;
use crate::model::{AsDynScene as _, Derived as _, EventKind, N_LANES, Scene, SceneRef};
use crate::record::Wanted;
use crate::simulate::recording::sampler::Sampler;
use crate::simulate::stepping::snapshot::Snapshot;
use crate::simulate::tolerances::monitors::ATTEMPTS_OF_A_PACE;
use crate::simulate::tolerances::singular::TOO_NEAR;
use crate::simulate::{InputTable, Simulation};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// A run that waits for others to step with.
#[derive(Debug, Clone, PartialEq)]
pub struct WaitingRun {
    /// Of its scene.
    identity: (&'static str, &'static str, u64),
    parameters: Vec<f64>,
    inputs: Vec<f64>,
    start: State,
    until_s: f64,
    tolerance: Tolerance,
}

/// The end of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct EndOfRun {
    /// Those of the columns of a sample with outputs and without works.
    pub numbers: Vec<f64>,
    /// Its time, s.
    pub t: f64,
    /// x and y of each point, m.
    pub points: Vec<f64>,
    /// Steps of all runs together.
    pub n_steps: u64,
}

/// Why a run steps by itself.
pub type Alone = &'static str;

impl<P: SceneRef> Simulation<'_, P> {
    /// The run as one that waits for others.
    ///
    /// # Errors
    /// Why it has to step by itself, also to say what is wrong with it.
    pub fn waiting(&self) -> Result<WaitingRun, Alone> {
        let (settings, info) = (&self.settings, self.scene.info());
        let solver = &settings.solver;
        let Some(tolerance) = solver.method.tolerance().filter(|_| solver.method.kind() == MethodKind::Dop853) else {
            return Err("only dop853 steps in lanes");
        };
        let is_located = |kind| kind != EventKind::Mark;
        let is_usual = (solver.projection, solver.metric) == (Projection::default(), Metric::default());
        let changes = |(_, table): &(String, InputTable)| table.constant().is_none();
        let reasons = [
            (!info.switches.is_empty(), "its constraints change"),
            (
                info.events.iter().any(|event| is_located(event.kind)),
                "what ends it, or is not smooth, has to be located",
            ),
            (
                settings.sampling.wanted.work || settings.estimated || settings.limits.are_given(),
                "more than its end is asked for",
            ),
            (!is_usual, "projections are not the usual ones"),
            (self.hooks.law.is_some() || settings.inputs.iter().any(changes), "its inputs change"),
            (!info.integrated_inputs.is_empty(), "its inputs are integrated"),
            (!info.states.is_empty(), "it has first-order states"),
            (self.scene.in_lanes().is_none(), WITHOUT_ELIMINATION),
        ];
        if let Some((_, reason)) = reasons.into_iter().find(|(holds, _)| *holds) {
            return Err(reason);
        }
        crate::simulate::checked::check_tolerance(tolerance).map_err(|_| CANNOT_START)?;
        let (system, _, start) = settings.assembled(self.scene.as_dyn()).map_err(|_| CANNOT_START)?;
        if !system.uses_elimination() {
            return Err(WITHOUT_ELIMINATION);
        }
        let until_s = settings.until_s;
        let can_end = until_s.is_finite() && until_s >= start.t;
        let (parameters, inputs) = (self.scene.parameters(), system.inputs().to_vec());
        if can_end {
            Ok(WaitingRun { identity: info.identity(), parameters, inputs, start, until_s, tolerance })
        } else {
            Err(CANNOT_START)
        }
    }
}

const CANNOT_START: Alone = "it cannot start";
const WITHOUT_ELIMINATION: Alone = "the scene has no elimination of its own";
const STOPS: Alone = "one of the eight stops early, or comes close to a singular position";

/// The ends of one to eight runs.
///
/// # Errors
/// Why they have to step by themselves, one by one; also once a flag is set.
pub fn run_together(
    scene: &dyn Scene,
    runs: &[WaitingRun],
    interrupts: &[&AtomicBool],
) -> Result<Vec<EndOfRun>, Alone> {
    let first = runs.first().ok_or(CANNOT_START)?;
    let is_same =
        |run: &WaitingRun| (run.start.t, run.until_s, run.tolerance) == (first.start.t, first.until_s, first.tolerance);
    if !runs.iter().all(is_same) {
        return Err("the eight have different times or tolerances");
    }
    let info = scene.info();
    if runs.len() > N_LANES {
        return Err("they are more than eight");
    }
    if runs.iter().any(|run| run.identity != info.identity()) {
        return Err("they are of different scenes");
    }
    scene.in_lanes().ok_or(WITHOUT_ELIMINATION)?;
    let mut systems = Vec::with_capacity(runs.len());
    for run in runs {
        let mut system = System::with_parameters(scene, &run.parameters, Backend::Auto).map_err(|_| CANNOT_START)?;
        system.inputs_mut().copy_from_slice(&run.inputs);
        systems.push(system);
    }
    let starts: Vec<&State> = runs.iter().map(|run| &run.start).collect();
    let mut together = EightRuns::new(scene, &systems, &starts, Method::default().with_tolerance(first.tolerance))
        .map_err(|_| CANNOT_START)?;
    let pivot = |(system, run): (&mut System<&dyn Scene>, &WaitingRun)| {
        system.at_with(run.start.t, &run.start.q, Rows::Held).smallest_pivot()
    };
    let too_near = TOO_NEAR * systems.iter_mut().zip(runs).map(pivot).fold(0.0, f64::max);
    let mut n_steps = 0;
    while together.time() < first.until_s {
        let is_over = interrupts.iter().any(|flag| flag.load(Ordering::Relaxed));
        if is_over || n_steps == ATTEMPTS_OF_A_PACE {
            return Err("the eight take very many steps");
        }
        together.step_towards(first.until_s).map_err(|_| STOPS)?;
        if together.smallest_pivot() < too_near {
            return Err(STOPS);
        }
        n_steps += 1;
    }
    let end = |(lane, mut system): (usize, System<&dyn Scene>)| {
        let (mut at, t) = (Snapshot::zero(&info, false), together.time());
        at.state = together.state(lane);
        at.evaluate(&mut system).ok()?;
        let mut sampler = Sampler::new(Arc::clone(&info), Wanted { outputs: true, ..Wanted::default() }, None);
        sampler.keep(&mut system, &at).ok()?;
        let numbers = sampler.record.samples().next()?.numbers().collect();
        let mut points = vec![0.0; 2 * info.points.len()];
        scene.points(system.fixed(), t, &at.state.q, &mut points);
        Some(EndOfRun { numbers, t, points, n_steps })
    };
    systems.into_iter().enumerate().map(end).collect::<Option<_>>().ok_or(STOPS)
}
