//! Runs of one scene with parameters and starts of their own, of which eight at once step together; only their ends are known.

use super::eight_runs::EightRuns;
use crate::dynamics::{Metric, Projection, Rows, State, System};
use crate::integrate::{Method, MethodKind, Tolerance};
use crate::linalg::Backend;
use crate::model::{AsDynScene as _, Derived as _, EventKind, N_LANES, Scene, SceneRef};
use crate::record::Wanted;
use crate::simulate::recording::sampler::Sampler;
use crate::simulate::stepping::snapshot::Snapshot;
use crate::simulate::tolerances::lanes::LOOKED_AT;
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
    /// Steps, which eight runs share.
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

/// The ends of runs of one scene, of which eight at once share their steps; or why a run has to step by itself, also once a flag is set.
///
/// Where there are more than eight, and the scene has quasi-velocities, the first part of the motion tells how long steps of each run may be. Then those whose steps are of
/// similar length go on together.
pub fn run_together(
    scene: &dyn Scene,
    runs: &[WaitingRun],
    interrupts: &[&AtomicBool],
) -> Vec<Result<EndOfRun, Alone>> {
    let Some(first) = runs.first() else { return Vec::new() };
    let group = Group { scene, first, interrupts };
    let mut ends: Vec<Result<EndOfRun, Alone>> = vec![Err(STOPS); runs.len()];
    let mut members = Vec::new();
    for (i, run) in runs.iter().enumerate() {
        match group.member(i, run) {
            Ok(member) => members.push(member),
            Err(why) => ends[i] = Err(why),
        }
    }
    let WaitingRun { start: State { t, .. }, until_s, .. } = *first;
    if members.len() > N_LANES && scene.in_quasi_velocities().is_some() {
        members = group.advanced(members, t + LOOKED_AT * (until_s - t), &mut ends);
        members.sort_by(|one, other| one.n_steps_of_its_own.total_cmp(&other.n_steps_of_its_own));
    }
    for member in group.advanced(members, until_s, &mut ends) {
        let i = member.i;
        ends[i] = group.end(member).ok_or(STOPS);
    }
    ends
}

/// What runs have in common.
struct Group<'a> {
    scene: &'a dyn Scene,
    first: &'a WaitingRun,
    interrupts: &'a [&'a AtomicBool],
}

/// A run on its way.
struct Member<'a> {
    /// Its place in the list.
    i: usize,
    system: System<&'a dyn Scene>,
    state: State,
    /// The smallest pivot of its rows at the start.
    pivot: f64,
    n_steps: u64,
    /// How many it would have taken of its own; zero where that is not known.
    n_steps_of_its_own: f64,
}

impl<'a> Group<'a> {
    /// A run at its start.
    fn member(&self, i: usize, run: &WaitingRun) -> Result<Member<'a>, Alone> {
        let (Self { scene, first, .. }, info) = (self, self.scene.info());
        if run.identity != info.identity() {
            return Err("they are of different scenes");
        }
        if (run.start.t, run.until_s, run.tolerance) != (first.start.t, first.until_s, first.tolerance) {
            return Err("they have different times or tolerances");
        }
        scene.in_lanes().ok_or(WITHOUT_ELIMINATION)?;
        let system = System::with_parameters(*scene, &run.parameters, Backend::Auto);
        let mut system = system.map_err(|_| CANNOT_START)?;
        system.inputs_mut().copy_from_slice(&run.inputs);
        let State { t, q, .. } = &run.start;
        let pivot = system.at_with(*t, q, Rows::Held).smallest_pivot();
        Ok(Member { i, system, state: run.start.clone(), pivot, n_steps: 0, n_steps_of_its_own: 0.0 })
    }

    /// Those that come to this time, eight at once; why the others do not.
    fn advanced(
        &self,
        mut members: Vec<Member<'a>>,
        until_s: f64,
        ends: &mut [Result<EndOfRun, Alone>],
    ) -> Vec<Member<'a>> {
        for eight in members.chunks_mut(N_LANES) {
            if let Err(why) = self.advance(eight, until_s) {
                eight.iter().for_each(|member| ends[member.i] = Err(why));
            }
        }
        members.retain(|member| member.state.t == until_s);
        members
    }

    fn advance(&self, eight: &mut [Member<'_>], until_s: f64) -> Result<(), Alone> {
        let method = Method::default().with_tolerance(self.first.tolerance);
        let starts: Vec<&State> = eight.iter().map(|member| &member.state).collect();
        let fixed: Vec<&[f64]> = eight.iter().map(|member| member.system.fixed()).collect();
        let together = EightRuns::new(self.scene, &eight[0].system, &fixed, &starts, method);
        let mut together = together.map_err(|_| CANNOT_START)?;
        let too_near = TOO_NEAR * eight.iter().map(|member| member.pivot).fold(0.0, f64::max);
        let mut n_steps = 0;
        while together.time() < until_s {
            let is_over = self.interrupts.iter().any(|flag| flag.load(Ordering::Relaxed));
            if is_over || n_steps == ATTEMPTS_OF_A_PACE {
                return Err("the eight take very many steps");
            }
            together.step_towards(until_s).map_err(|_| STOPS)?;
            if together.smallest_pivot() < too_near {
                return Err(STOPS);
            }
            n_steps += 1;
        }
        for (lane, member) in eight.iter_mut().enumerate() {
            member.state = together.state(lane);
            member.n_steps += n_steps;
            member.n_steps_of_its_own = together.n_steps_of_its_own(lane);
        }
        Ok(())
    }

    /// What is known of a run at its end.
    fn end(&self, Member { mut system, state, n_steps, .. }: Member<'_>) -> Option<EndOfRun> {
        let (info, t) = (self.scene.info(), state.t);
        let mut at = Snapshot::zero(&info, false);
        at.state = state;
        at.evaluate(&mut system).ok()?;
        let mut sampler = Sampler::new(Arc::clone(&info), Wanted { outputs: true, ..Wanted::default() }, None);
        sampler.keep(&mut system, &at).ok()?;
        let numbers = sampler.record.samples().next()?.numbers().collect();
        let mut points = vec![0.0; 2 * info.points.len()];
        self.scene.points(system.fixed(), t, &at.state.q, &mut points);
        Some(EndOfRun { numbers, t, points, n_steps })
    }
}
