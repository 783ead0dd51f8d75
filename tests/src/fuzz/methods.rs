//! The same motion by every method: what tolerance and the motion's own amplification do not explain is a fault; for RK4, what half the
//! step does not tell.

use ezy_core::integrate::PreciseMotion;
use ezy_core::model::{Name, SceneEntry};
use ezy_core::prelude::*;
use ezy_core::simulate::SetupError;

use super::draw::Draw;
use super::parameters::{Scenes, change};
use crate::garage::worse;

/// Tolerances that methods are judged at.
const TOLERANCES: [f64; 5] = [1e-4, 1e-6, 1e-8, 1e-10, 1e-12];

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

/// Share of a scene's time that is run, as powers of ten: up to three times of it.
const SHARES: [f64; 2] = [-2.0, 0.477];

/// Samples that are compared.
const N_SAMPLES: usize = 32;

/// Steps after which a run is ended: a reference needs some hundred, and stiffness is no fault.
const MOST_STEPS: u64 = 20_000;

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
    given: Vec<(Name, f64)>,
    until_s: f64,
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
    /// Coordinates, velocities and multipliers.
    samples: Vec<Vec<f64>>,
    /// Samples in stretches across a singular position, which the run names: at a distance D from it velocities carry errors of
    /// positions multiplied by 1/D².
    crosses: Vec<bool>,
    crosses_any: bool,
    n_steps: u64,
}

/// What runs are compared with.
struct Reference {
    motion: Motion,
    /// What tolerances are relative to: one more than the largest of each number.
    scale: Vec<f64>,
    /// Coordinates and velocities among the numbers of a sample; multipliers follow.
    n_state: usize,
    /// How much errors of a state grow, in later states and in multipliers.
    amplification: [f64; 2],
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
        for name in info.coordinates.iter().flat_map(|c| [&c.name, &c.velocity_name]) {
            if draw.once_in(12) {
                given.push((name.clone(), draw.instead_of(1.0, false)));
            }
        }
        let [low, high] = SHARES;
        Self { model, entry, changed, given, until_s: info.until_s * draw.decades(low, high), seed: i }
    }

    /// A scene as it is, over so many times its time.
    pub fn shipped(model: &'static ModelInfo, entry: &'static SceneEntry, times: f64) -> Self {
        let until_s = times * (entry.new)().info().until_s;
        Self { model, entry, changed: Vec::new(), given: Vec::new(), until_s, seed: 0 }
    }

    fn scene(&self) -> Box<dyn Scene> {
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

    fn order<'s>(&self, scene: &'s dyn Scene, method: Method) -> Simulation<'s, dyn Scene + 's> {
        let every_s = self.until_s / N_SAMPLES as f64;
        let order = Simulation::new(scene).method(method).until(self.until_s).every(every_s);
        let order = order.max_steps(MOST_STEPS).project_start();
        // energy tells that a fixed step is too long, and takes works as the command line does
        let order = if method.tolerance().is_none() { order.work() } else { order };
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
        let names = info.coordinates.iter().map(|c| &*c.name).chain(info.coordinates.iter().map(|c| &*c.velocity_name));
        let start = names.zip(start).enumerate();
        let order = start.fold(self.order(scene, Method::dop853(REFERENCE)), |order, (i, (name, value))| {
            order.start(name, value + MOVED * by(i))
        });
        order.run().ok().and_then(|run| motion(&run).ok())
    }

    /// The motion of `explicit` in double-double; none where the scene has no series, changes its modes, or crosses a singular position.
    fn precise(&self, scene: &dyn Scene, explicit: &Motion) -> Option<Motion> {
        if explicit.crosses_any || !scene.modes().is_empty() {
            return None;
        }
        let n_q = scene.info().n_coordinates();
        let start = &explicit.samples[0];
        let start = State { t: 0.0, q: start[..n_q].to_vec(), v: start[n_q..2 * n_q].to_vec(), work: Vec::new() };
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
        let scale = scale(&explicit);
        let start = &explicit.samples[0];
        let mut draw = Draw::new(self.seed, 1);
        let faster = self.moved(scene, start, |i| if i < n_state / 2 { 0.0 } else { start[i] });
        let moved = (0..N_MOVED).map(|_| self.moved(scene, start, |i| scale[i] * draw.between(-1.0, 1.0)));
        let moved = std::iter::once(faster).chain(moved).collect::<Option<Vec<Motion>>>();
        let moved = moved.ok_or(Judgement::NoReference)?;
        let grown = moved.iter().map(|moved| amplification(moved, &explicit, &scale, n_state));
        let amplification = grown.fold([1.0; 2], |most, grown| [0, 1].map(|i| worse(most[i], grown[i])));
        if amplification[0] > LARGEST_AMPLIFICATION {
            return Err(Judgement::Amplifies);
        }
        let precise = self.precise(scene, &explicit);
        let is_precise = precise.is_some();
        let motion = precise.unwrap_or(explicit);
        let least = if is_precise { 0.0 } else { ABOVE_REFERENCE * REFERENCE };
        let reference = Reference { motion, scale, n_state, amplification, least };
        if is_precise {
            return Ok(reference);
        }
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
            let is_right = excess <= MARGIN;
            let judgement = if is_right { Judgement::Right } else { Judgement::Fault };
            if !is_right {
                faults.push(Fault { case: self.clone(), method, excess, amplification });
            }
            let n_skipped = motion.crosses.iter().filter(|crosses| **crosses).count();
            tell(Told { n_steps: motion.n_steps, n_skipped, ..told(method, judgement, excess, amplification) });
        };
        for tolerance in TOLERANCES {
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
    /// The largest difference of two runs over what errors of states grow to, of the scale of each number.
    fn error(&self, a: &Motion, b: &Motion) -> f64 {
        let [of_state, of_multipliers] = self.amplification;
        let grown = |[state, multipliers]: [f64; 2]| worse(state / of_state, multipliers / of_multipliers);
        differences(a, b, &self.scale, self.n_state).map(grown).fold(0.0, worse)
    }

    /// The error of a run in tolerances times amplification.
    fn excess(&self, motion: &Motion, tolerance: f64) -> f64 {
        self.error(motion, &self.motion) / tolerance
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
        let Self { case: Case { model, entry, changed, given, until_s, .. }, method, excess, amplification } = self;
        let name = method.name();
        let (setting, of) = match (method, method.tolerance()) {
            (Method::Rk4 { step_s }, _) => (format!("--step {step_s:e}"), "its difference to half the step"),
            (_, tolerance) => {
                let relative = tolerance.map_or(f64::NAN, |tolerance| tolerance.relative);
                (format!("--rtol {relative:e}"), "tolerance and amplification")
            }
        };
        writeln!(f, "{name} with {setting} is off by {excess:.1e} times {of} (amplification {amplification:.1e})")?;
        let id = |name: &str| name.chars().filter(|c| *c != '_').collect::<String>().to_lowercase();
        write!(
            f,
            "  ezy run {}/{} --project-start --until {until_s} --method {name} {setting}",
            id(model.name),
            entry.name
        )?;
        changed.iter().try_for_each(|(name, value)| write!(f, " --set {name}={value:e}"))?;
        given.iter().try_for_each(|(name, value)| write!(f, " --start {name}={value:e}"))
    }
}

/// What a run that reached its end computed.
fn motion(run: &Run) -> Result<Motion, Judgement> {
    match run.outcome {
        Outcome::ReachedEnd => {
            let crosses =
                |t: f64| run.rank.crossings.iter().any(|crossed| (crossed.from_s..=crossed.to_s).contains(&t));
            Ok(Motion {
                samples: run
                    .samples()
                    .map(|sample| [sample.coordinates, sample.velocities, sample.multipliers].concat())
                    .collect(),
                crosses: run.samples().map(|sample| crosses(sample.t)).collect(),
                crosses_any: !run.rank.crossings.is_empty(),
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

/// The largest differences of states and of multipliers in each pair of samples that can be compared, of their scale; NaN where one is none.
fn differences(a: &Motion, b: &Motion, scale: &[f64], n_state: usize) -> impl Iterator<Item = [f64; 2]> {
    let pairs = a.samples.iter().zip(&b.samples).zip(a.crosses.iter().zip(&b.crosses));
    pairs.filter(|(_, (a, b))| !*a && !*b).map(move |((a, b), _)| {
        let largest = |range: std::ops::Range<usize>| range.fold(0.0, |m: f64, i| worse(m, (a[i] - b[i]) / scale[i]));
        [largest(0..n_state), largest(n_state..scale.len())]
    })
}

/// How much a difference of states grows, from the move of the start, and from any sample to any later one: in states, and in multipliers.
fn amplification(moved: &Motion, reference: &Motion, scale: &[f64], n_state: usize) -> [f64; 2] {
    let (mut least, mut most) = (MOVED, [1.0_f64; 2]);
    for [state, multipliers] in differences(moved, reference, scale, n_state) {
        let state = state.max(REFERENCE);
        least = least.min(state);
        most = [most[0].max(state / least), most[1].max(multipliers / least)];
    }
    most
}
