//! The same motion by every method: what tolerance and the motion's own amplification do not explain is a fault; for RK4, what half the
//! step does not tell.

use std::ops::Range;

use ezy_core::integrate::PreciseMotion;
use ezy_core::model::{Name, SceneEntry};
use ezy_core::prelude::*;
use ezy_core::simulate::SetupError;

use super::draw::Draw;
use super::parameters::{Scenes, change};
use crate::garage::worse;

/// Tolerances that methods are judged at; a random case draws two between the first and the last.
const TOLERANCES: [f64; 5] = [1e-4, 1e-6, 1e-8, 1e-10, 1e-12];
const N_DRAWN: usize = 2;
const DECADES: [f64; 2] = [-12.0, -4.0];

/// Steps of RK4 over a run.
const RK4_STEPS: [f64; 2] = [1e3, 1e4];

/// Tolerance of the two references where there is none in double-double: below it a step of DOP853 has one witness, and rounding of Radau
/// shows.
const REFERENCE: f64 = 1e-11;

/// Tolerances below this many times that of such references are not judged by them.
const ABOVE_REFERENCE: f64 = 10.0;

/// Tolerance of the steps that carry RK4 across singular positions: half the step does not change them.
const CROSSING: f64 = 1e-9;

/// What an error may be, in tolerances times amplification, since steps add up; for RK4, in differences to half the step.
pub const MARGIN: f64 = 100.0;

/// From so many steps on a run tells that errors of its steps add up to as many tolerances.
const MANY_STEPS: u64 = 1_000;

/// Share of a scene's time that is run, as powers of ten: up to three times of it.
const SHARES: [f64; 2] = [-2.0, 0.477];

/// Samples that are compared.
const N_SAMPLES: usize = 32;

/// Steps times unknowns after which a run is ended: a reference needs some hundred steps, and stiffness is no fault.
const MOST_NUMBERS: u64 = 200_000;

/// What starts are moved by to see the amplification, of their scale; differences of runs at the tolerance of references are
/// below a thousandth of it.
const MOVED: f64 = 1e-8;

/// Starts that are moved at random. One more is faster by the same part: errors of steps add up in the energy, and faster motions drift
/// apart.
const N_MOVED: usize = 2;

/// Motions that amplify more are not compared: differences are no longer linear.
const LARGEST_AMPLIFICATION: f64 = 1e5;

/// A motion to be computed by every method.
#[derive(Clone)]
pub struct Case {
    model: &'static ModelInfo,
    entry: &'static SceneEntry,
    /// Parameters and counts that differ from the scene's.
    changed: Vec<(&'static str, f64)>,
    /// Start values.
    pub(super) given: Vec<(Name, f64)>,
    pub(super) until_s: f64,
    tolerances: Vec<f64>,
    /// What starts are moved by is drawn from it.
    seed: u64,
}

/// What came of one run.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Judgement {
    /// The motion has no reference, or two that do not agree, or none for a tolerance as small: one is refused, stops or takes too many steps.
    NoReference,
    /// The method does not apply to the scene.
    NotForIt,
    /// It amplifies errors too much.
    Amplifies,
    /// Within its bound.
    Right,
    /// It stopped and said why.
    Stopped,
    /// Beyond its bound, and it says why: it passes beside a singular position, where small errors decide, or energy and works differ by more than the
    /// tolerance explains.
    Doubtful,
    /// Beyond its bound without a word.
    Fault,
}

/// What came of a run, and its figures.
#[derive(Debug, Clone, Copy)]
pub struct Told {
    /// By which method.
    pub method: Method,
    /// What came of it.
    pub judgement: Judgement,
    /// Its error in tolerances times amplification, or in differences to half the step; NaN where there is none.
    pub excess: f64,
    /// How much the motion amplifies errors.
    pub amplification: f64,
    /// Steps, with rejected ones.
    pub n_steps: u64,
    /// Samples that are not compared, since they lie in a crossing of a singular position.
    pub n_skipped: usize,
}

/// A run that is wrong without a word.
pub struct Fault {
    case: Case,
    method: Method,
    /// Error in tolerances times amplification, or in differences to half the step.
    excess: f64,
    amplification: f64,
}

/// What a run computed.
#[derive(Clone)]
struct Motion {
    /// Coordinates, velocities, multipliers and works.
    samples: Vec<Vec<f64>>,
    /// Largest energy, which works are relative to, J.
    energy: f64,
    /// Times of events, s.
    events: Vec<f64>,
    /// Samples in stretches across a singular position, which the run names: at a distance D from it velocities carry errors of
    /// positions multiplied by 1/D².
    crosses: Vec<bool>,
    crosses_any: bool,
    /// The run remarks that it passes beside a singular position.
    beside: bool,
    /// The largest difference of energy and works, relative to the energy turned over.
    energy_error: f64,
    n_steps: u64,
}

/// Ranges of states, multipliers and works in a sample.
type Parts = [Range<usize>; 3];

/// What runs are compared with.
struct Reference {
    motion: Motion,
    /// What tolerances are relative to: one more than the largest of each number.
    scale: Vec<f64>,
    /// Where the parts of a sample begin: states, multipliers, works.
    parts: Parts,
    /// How much errors of a state grow, in each part of later samples.
    amplification: [f64; 3],
    /// How much they move events, s for the scale of a number; none where a moved start has more or fewer events.
    of_events: Option<f64>,
    /// The smallest tolerance that it can judge.
    least: f64,
}

impl Case {
    /// Case `i` of a seed.
    pub fn new(scenes: &Scenes, seed: u64, i: u64) -> Self {
        let mut draw = Draw::new(seed, i);
        let (model, entry) = scenes.pick(&mut draw);
        let mut scene = (entry.new)();
        let changed = change(&mut *scene, &mut draw, false);
        let info = scene.info();
        let mut given = Vec::new();
        for name in info.coordinates.iter().zip(&*info.velocities).flat_map(|(c, v)| [&c.name, &v.name]) {
            if draw.once_in(12) {
                given.push((name.clone(), draw.instead_of(1.0, false)));
            }
        }
        let [low, high] = SHARES;
        let until_s = info.until_s * draw.decades(low, high);
        let [low, high] = DECADES;
        let tolerances = (0..N_DRAWN).map(|_| draw.decades(low, high)).collect();
        Self { model, entry, changed, given, until_s, tolerances, seed: i }
    }

    /// A scene as it is, over so many times its time.
    pub fn shipped(model: &'static ModelInfo, entry: &'static SceneEntry, times: f64) -> Self {
        let until_s = times * (entry.new)().info().until_s;
        let tolerances = TOLERANCES.to_vec();
        Self { model, entry, changed: Vec::new(), given: Vec::new(), until_s, tolerances, seed: 0 }
    }

    /// The same over another time.
    pub(super) fn over(self, until_s: f64) -> Self {
        Self { until_s, ..self }
    }

    pub(super) fn scene(&self) -> Box<dyn Scene> {
        let mut scene = (self.entry.new)();
        let info = scene.info();
        for (name, value) in &self.changed {
            match info.counts().iter().position(|count| count.name == *name) {
                Some(i) => scene.set_count(i, *value as usize),
                None => {
                    let i = info.parameters.iter().position(|parameter| parameter.name == *name);
                    scene.set_parameter(i.expect("a parameter of the scene"), *value);
                }
            }
        }
        scene
    }

    fn order<'s>(&self, scene: &'s dyn Scene, method: Method) -> Simulation<'s, &'s dyn Scene> {
        let every_s = self.until_s / N_SAMPLES as f64;
        let order = Simulation::new(scene).method(method).until(self.until_s).every(every_s);
        let info = scene.info();
        let n_unknowns = (info.n_coordinates() + info.n_rows()).max(1) as u64;
        let order = order.max_steps(MOST_NUMBERS / n_unknowns).project_start();
        // with works energy tells that a fixed step is too long, too
        let order = order.work();
        self.given.iter().fold(order, |order, (name, value)| order.start(&**name, *value))
    }

    /// Samples of a run that reached its end.
    fn run(&self, scene: &dyn Scene, method: Method) -> Result<Motion, Judgement> {
        match self.order(scene, method).run() {
            Ok(run) => motion(&run),
            Err(SetupError::NoSeries { .. } | SetupError::NoJacobians { .. }) => Err(Judgement::NotForIt),
            Err(_) => Err(Judgement::Stopped),
        }
    }

    /// What comes of a start that is moved: `by` says what is added to a number of this size.
    fn moved(&self, scene: &dyn Scene, start: &[f64], mut by: impl FnMut(usize) -> f64) -> Option<Motion> {
        let info = scene.info();
        let names = info.coordinates.iter().chain(&*info.velocities).map(|c| &*c.name);
        let start = names.zip(start).enumerate();
        let order = start.fold(self.order(scene, Method::dop853(REFERENCE)), |order, (i, (name, value))| {
            order.start(name, value + MOVED * by(i))
        });
        order.run().ok().and_then(|run| motion(&run).ok())
    }

    /// The motion of `explicit` in double-double; none where the scene has no series, changes its modes, or crosses a singular position.
    fn precise(&self, scene: &dyn Scene, explicit: &Motion) -> Option<Motion> {
        if explicit.crosses_any || !scene.info().switches.is_empty() {
            return None;
        }
        let n_q = scene.info().n_coordinates();
        let start = &explicit.samples[0];
        let start = State {
            t: 0.0,
            q: start[..n_q].to_vec(),
            v: start[n_q..2 * n_q].to_vec(),
            z: scene.info().states.iter().map(|state| state.default).collect(),
            work: Vec::new(),
        };
        let mut precise = PreciseMotion::new(scene, &start).ok()?;
        let mut motion = explicit.clone();
        for (i, sample) in motion.samples.iter_mut().enumerate() {
            precise.advance_to(self.until_s * i as f64 / N_SAMPLES as f64).ok()?;
            let numbers = precise.q().iter().chain(precise.v()).chain(precise.lambda());
            sample.iter_mut().zip(numbers).for_each(|(sample, number)| *sample = number.high());
        }
        Some(motion)
    }

    /// What runs of the case are compared with.
    fn reference(&self, scene: &dyn Scene) -> Result<Reference, Judgement> {
        let explicit = self.run(scene, Method::dop853(REFERENCE)).map_err(|_| Judgement::NoReference)?;
        let n_state = 2 * scene.info().n_coordinates();
        let mut scale = scale(&explicit);
        let start = &explicit.samples[0];
        let n_multipliers = start.len() - n_state - scene.info().n_effects();
        let parts = [0..n_state, n_state..n_state + n_multipliers, n_state + n_multipliers..start.len()];
        scale[parts[2].clone()].iter_mut().for_each(|scale| *scale += explicit.energy);
        let mut draw = Draw::new(self.seed, 1);
        let faster = self.moved(scene, start, |i| if i < n_state / 2 { 0.0 } else { start[i] });
        let moved = (0..N_MOVED).map(|_| self.moved(scene, start, |i| scale[i] * draw.between(-1.0, 1.0)));
        let moved = std::iter::once(faster).chain(moved).collect::<Option<Vec<Motion>>>();
        let moved = moved.ok_or(Judgement::NoReference)?;
        let grown = moved.iter().map(|moved| amplification(moved, &explicit, &scale, &parts));
        let (amplification, of_events) = grown.fold(([1.0; 3], Some(1.0)), |most, grown| {
            let of_events = most.1.zip(grown.1).map(|(most, grown)| worse(most, grown));
            ([0, 1, 2].map(|i| worse(most.0[i], grown.0[i])), of_events)
        });
        if amplification[0] > LARGEST_AMPLIFICATION {
            return Err(Judgement::Amplifies);
        }
        let reference = |motion, least| Reference { motion, scale, parts, amplification, of_events, least };
        if let Some(precise) = self.precise(scene, &explicit) {
            let reference = reference(precise, 0.0);
            // works and events have no other; and amplification is not what small moves of the start tell where the motion all but branches
            let is_known = reference.excess(&explicit, REFERENCE) <= MARGIN.max(explicit.n_steps as f64);
            return if is_known { Ok(reference) } else { Err(Judgement::NoReference) };
        }
        let reference = reference(explicit, ABOVE_REFERENCE * REFERENCE);
        let second = match self.run(scene, Method::taylor(REFERENCE)) {
            Err(Judgement::NotForIt) => self.run(scene, Method::radau(REFERENCE)),
            second => second,
        };
        match second {
            Ok(second) if reference.excess(&second, REFERENCE) <= MARGIN => Ok(reference),
            _ => Err(Judgement::NoReference),
        }
    }

    /// Runs the case by every method, tells what came of each run, and returns the faults.
    pub fn judge(&self, mut tell: impl FnMut(Told)) -> Vec<Fault> {
        let scene = self.scene();
        let scene = &*scene;
        let told = |method, judgement, excess, amplification| Told {
            method,
            judgement,
            excess,
            amplification,
            n_steps: 0,
            n_skipped: 0,
        };
        let reference = match self.reference(scene) {
            Ok(reference) => reference,
            Err(judgement) => {
                tell(told(Method::dop853(REFERENCE), judgement, f64::NAN, f64::NAN));
                return Vec::new();
            }
        };
        let amplification = reference.amplification[0];
        let mut faults = Vec::new();
        let mut judge = |method: Method, outcome: Result<(Motion, f64), Judgement>| {
            let (motion, excess) = match outcome {
                Ok(judged) => judged,
                Err(judgement) => return tell(told(method, judgement, f64::NAN, amplification)),
            };
            let told_by_run = if motion.n_steps > MANY_STEPS { motion.n_steps as f64 } else { MARGIN };
            let is_right = excess <= told_by_run;
            // from here on `ezy run` remarks on the energy
            let explained =
                MARGIN.max(motion.n_steps as f64) * method.tolerance().map_or(f64::INFINITY, |t| t.relative);
            let judgement = match is_right {
                true => Judgement::Right,
                false if motion.beside || motion.energy_error > explained => Judgement::Doubtful,
                false => Judgement::Fault,
            };
            if judgement == Judgement::Fault {
                faults.push(Fault { case: self.clone(), method, excess, amplification });
            }
            let n_skipped = motion.crosses.iter().filter(|crosses| **crosses).count();
            tell(Told { n_steps: motion.n_steps, n_skipped, ..told(method, judgement, excess, amplification) });
        };
        for &tolerance in &self.tolerances {
            for method in [Method::dop853, Method::taylor, Method::gauss, Method::radau] {
                let method = method(tolerance);
                if tolerance < reference.least {
                    judge(method, Err(Judgement::NoReference));
                    continue;
                }
                let run = self.run(scene, method);
                judge(
                    method,
                    run.map(|motion| {
                        let excess = reference.excess(&motion, tolerance);
                        (motion, excess)
                    }),
                );
            }
        }
        for n in RK4_STEPS {
            let [method, finer] = [n, 2.0 * n].map(|n| Method::rk4(self.until_s / n));
            // without a second run nothing is said
            let run = self.run(scene, method).and_then(|motion| {
                let finer = self.run(scene, finer).map_err(|_| Judgement::NoReference)?;
                let least = if motion.crosses_any { CROSSING } else { REFERENCE };
                let told = reference.error(&motion, &finer).max(least);
                let excess = reference.error(&motion, &reference.motion) / told;
                Ok((motion, excess))
            });
            judge(method, run);
        }
        faults
    }
}

impl Reference {
    /// The largest difference of two runs over what errors of states grow to, of the scale of each number, or of times of events.
    fn error(&self, a: &Motion, b: &Motion) -> f64 {
        let [of_motion, of_rest] = self.errors(a, b);
        worse(of_motion, of_rest)
    }

    /// The same of states and multipliers, and of works and events.
    fn errors(&self, a: &Motion, b: &Motion) -> [f64; 2] {
        let of_events = self.of_events.map_or(0.0, |grown| late(a, b) / grown);
        differences(a, b, &self.scale, &self.parts).fold([0.0, of_events], |most, apart| {
            let [state, multipliers, works] = [0, 1, 2].map(|i| apart[i] / self.amplification[i]);
            [worse(worse(most[0], state), multipliers), worse(most[1], works)]
        })
    }

    /// The error of a run in tolerances times amplification. Works and events have no reference in double-double.
    fn excess(&self, motion: &Motion, tolerance: f64) -> f64 {
        let [of_motion, of_rest] = self.errors(motion, &self.motion);
        let known = tolerance >= ABOVE_REFERENCE * REFERENCE;
        (if known { worse(of_motion, of_rest) } else { of_motion }) / tolerance
    }
}

impl Fault {
    /// The same fault with as few changes of the scene as it takes.
    pub fn shrunk(mut self) -> Self {
        let fails = |case: &Case, method: Method| {
            let mut faults = case.judge(|_| {});
            let at = faults.iter().position(|fault| fault.method == method);
            at.map(|at| faults.swap_remove(at))
        };
        let mut i = 0;
        while i < self.case.changed.len() + self.case.given.len() {
            let mut fewer = self.case.clone();
            let n_changed = fewer.changed.len();
            match i.checked_sub(n_changed) {
                None => drop(fewer.changed.remove(i)),
                Some(given) => drop(fewer.given.remove(given)),
            }
            match fails(&fewer, self.method) {
                Some(fault) => self = fault,
                None => i += 1,
            }
        }
        self
    }
}

/// What went wrong, and the command line that shows it.
impl std::fmt::Display for Fault {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { case, method, excess, amplification } = self;
        let of = match method.tolerance() {
            None => "its difference to half the step",
            Some(_) => "tolerance and amplification",
        };
        let name = method.name();
        writeln!(f, "{name} is off by {excess:.1e} times {of} (amplification {amplification:.1e})")?;
        write!(f, "  {}", case.command(*method))
    }
}

impl Case {
    /// The command line that runs it.
    pub(super) fn command(&self, method: Method) -> String {
        let Self { model, entry, changed, given, until_s, .. } = self;
        let option = if method.info().chooses_steps { "--rtol" } else { "--step" };
        let id: String = model.name.chars().filter(|c| *c != '_').collect::<String>().to_lowercase();
        let mut line = format!(
            "ezy run {id}/{} --project-start --until {until_s} --method {} {option} {:e}",
            entry.name,
            method.name(),
            method.setting()
        );
        changed.iter().for_each(|(name, value)| line += &format!(" --set {name}={value:e}"));
        given.iter().for_each(|(name, value)| line += &format!(" --start {name}={value:e}"));
        line
    }
}

/// What a run that reached its end computed.
fn motion(run: &Run) -> Result<Motion, Judgement> {
    match run.outcome {
        Outcome::ReachedEnd | Outcome::ReachedEvent { .. } => {
            // a sample at an event is at another time in each run
            let n = run.samples().len() - usize::from(matches!(run.outcome, Outcome::ReachedEvent { .. }));
            let crosses =
                |t: f64| run.rank.crossings.iter().any(|crossed| (crossed.from_s..=crossed.to_s).contains(&t));
            Ok(Motion {
                samples: run
                    .samples()
                    .take(n)
                    .map(|sample| [sample.coordinates, sample.velocities, sample.multipliers, sample.work].concat())
                    .collect(),
                energy: run
                    .samples()
                    .fold(0.0, |most: f64, sample| most.max(sample.energy.kinetic + sample.energy.potential.abs())),
                events: run.events().iter().map(|occurred| occurred.state.t).collect(),
                crosses: run.samples().take(n).map(|sample| crosses(sample.t)).collect(),
                crosses_any: !run.rank.crossings.is_empty(),
                beside: run.rank.crossings.iter().any(|crossed| crossed.is_beside()),
                energy_error: run.monitors.energy.map_or(0.0, |energy| energy.relative),
                n_steps: run.cost.steps + run.cost.rejected,
            })
        }
        _ => Err(Judgement::Stopped),
    }
}

/// What tolerances are relative to: one more than the largest of each number.
fn scale(reference: &Motion) -> Vec<f64> {
    let largest = |i: usize| reference.samples.iter().fold(0.0, |m: f64, sample| m.max(sample[i].abs()));
    (0..reference.samples[0].len()).map(|i| 1.0 + largest(i)).collect()
}

/// The largest differences of states, multipliers and works in each pair of samples that can be compared, of their scale; NaN where one is none.
fn differences(a: &Motion, b: &Motion, scale: &[f64], parts: &Parts) -> impl Iterator<Item = [f64; 3]> {
    let pairs = a.samples.iter().zip(&b.samples).zip(a.crosses.iter().zip(&b.crosses));
    pairs.filter(|(_, (a, b))| !*a && !*b).map(move |((a, b), _)| {
        parts.clone().map(|range| range.fold(0.0, |m: f64, i| worse(m, (a[i] - b[i]) / scale[i])))
    })
}

/// The largest difference of times of events, s; infinite where there are more or fewer.
fn late(a: &Motion, b: &Motion) -> f64 {
    if a.events.len() != b.events.len() {
        return f64::INFINITY;
    }
    a.events.iter().zip(&b.events).map(|(a, b)| a - b).fold(0.0, worse)
}

/// How much a difference of states grows, from the move of the start, and from any sample to any later one: in states, in multipliers and in
/// works, and in times of events, where these are as many.
fn amplification(moved: &Motion, reference: &Motion, scale: &[f64], parts: &Parts) -> ([f64; 3], Option<f64>) {
    let (mut least, mut most) = (MOVED, [1.0_f64; 3]);
    for [state, others @ ..] in differences(moved, reference, scale, parts) {
        let state = state.max(REFERENCE);
        least = least.min(state);
        let [multipliers, works] = others.map(|other| other / least);
        most = [most[0].max(state / least), most[1].max(multipliers), most[2].max(works)];
    }
    let late = late(moved, reference);
    (most, late.is_finite().then_some(late / least))
}
