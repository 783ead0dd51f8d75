//! The same motion by every method: what tolerance and the motion's own amplification do not explain is a fault; for RK4, what half the
//! step does not tell.

use ezy_core::model::{Name, SceneEntry};
use ezy_core::prelude::*;
use ezy_core::simulate::SetupError;

use super::draw::Draw;
use super::parameters::{Scenes, change};
use crate::garage::worse;

/// Tolerances that methods are judged at.
const TOLERANCES: [f64; 4] = [1e-4, 1e-6, 1e-8, 1e-10];

/// Steps of RK4 over a run.
const RK4_STEPS: [f64; 2] = [1e3, 1e4];

/// Tolerance of the two references: below it a step of DOP853 has one witness, and rounding of Radau shows.
const REFERENCE: f64 = 1e-11;

/// Tolerance of the steps that carry RK4 across singular positions: half the step does not change them.
const CROSSING: f64 = 1e-9;

/// What an error may be, in tolerances times amplification, since steps add up; for RK4, in differences to half the step. A run of more steps
/// than this may err by a tolerance each.
const MARGIN: f64 = 100.0;

/// Share of a scene's time that is run, as powers of ten.
const SHARES: [f64; 2] = [-2.0, -0.3];

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
    /// The motion has no two references: one is refused, stops or takes too many steps.
    NoReference,
    /// The method does not apply to the scene.
    NotForIt,
    /// It amplifies errors too much.
    Amplifies,
    /// Within its bound.
    Right,
    /// Within a tolerance for each of its steps, which are more than those of the bound.
    Adds,
    /// It stopped and said why.
    Stopped,
    /// Beyond its bound without a word.
    Fault,
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
struct Motion {
    /// Coordinates and velocities.
    samples: Vec<Vec<f64>>,
    /// Samples in stretches across a singular position, which the run names: at a distance D from it velocities carry errors of
    /// positions multiplied by 1/D².
    crosses: Vec<bool>,
    crosses_any: bool,
    n_steps: u64,
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
    fn moved(&self, scene: &dyn Scene, reference: &Motion, mut by: impl FnMut(usize) -> f64) -> Option<Motion> {
        let info = scene.info();
        let names = info.coordinates.iter().map(|c| &*c.name).chain(info.coordinates.iter().map(|c| &*c.velocity_name));
        let start = names.zip(&reference.samples[0]).enumerate();
        let order = start.fold(self.order(scene, Method::dop853(REFERENCE)), |order, (i, (name, value))| {
            order.start(name, value + MOVED * by(i))
        });
        order.run().ok().and_then(|run| motion(&run).ok())
    }

    /// Runs the case by every method with a tolerance, tells what came of each run, and returns the faults.
    pub fn judge(&self, mut tell: impl FnMut(Method, Judgement)) -> Vec<Fault> {
        let scene = self.scene();
        let scene = &*scene;
        let explicit = Method::dop853(REFERENCE);
        let mut other: fn(f64) -> Method = Method::taylor;
        let mut second = self.run(scene, other(REFERENCE));
        if let Err(Judgement::NotForIt) = second {
            other = Method::radau;
            second = self.run(scene, other(REFERENCE));
        }
        let (Ok(reference), Ok(second)) = (self.run(scene, explicit), second) else {
            tell(explicit, Judgement::NoReference);
            return Vec::new();
        };
        let scale = scale(&reference);
        let mut draw = Draw::new(self.seed, 1);
        let n_q = scale.len() / 2;
        let faster = self.moved(scene, &reference, |i| if i < n_q { 0.0 } else { reference.samples[0][i] });
        let moved = (0..N_MOVED).map(|_| self.moved(scene, &reference, |i| scale[i] * draw.between(-1.0, 1.0)));
        let Some(moved) = std::iter::once(faster).chain(moved).collect::<Option<Vec<Motion>>>() else {
            tell(explicit, Judgement::NoReference);
            return Vec::new();
        };
        let mut amplification = moved.iter().map(|moved| amplification(moved, &reference, &scale)).fold(1.0, worse);
        if distance(&second, &reference, &scale) > MARGIN * REFERENCE * amplification {
            // what errors on the way grow to, by both references: one alone may be wrong
            let grown = |method: fn(f64) -> Method, of: &Motion| {
                let finer = self.run(scene, method(0.1 * REFERENCE));
                finer.map_or(1.0, |finer| distance(&finer, of, &scale) / REFERENCE)
            };
            amplification = worse(amplification, grown(Method::dop853, &reference).min(grown(other, &second)));
        }
        if amplification > LARGEST_AMPLIFICATION {
            tell(explicit, Judgement::Amplifies);
            return Vec::new();
        }
        let mut faults = Vec::new();
        let mut judge = |method: Method, outcome: Result<Motion, Judgement>, tolerance: f64| {
            let verdict = outcome.map_or_else(
                |verdict| verdict,
                |motion| {
                    let excess = distance(&motion, &reference, &scale) / (tolerance * amplification);
                    if excess <= MARGIN {
                        return Judgement::Right;
                    }
                    if method.tolerance().is_some() && excess <= motion.n_steps as f64 {
                        return Judgement::Adds;
                    }
                    faults.push(Fault { case: self.clone(), method, excess, amplification });
                    Judgement::Fault
                },
            );
            tell(method, verdict);
        };
        judge(other(REFERENCE), Ok(second), REFERENCE);
        for tolerance in TOLERANCES {
            for method in [
                Method::dop853(tolerance),
                Method::taylor(tolerance),
                Method::gauss(tolerance),
                Method::radau(tolerance),
            ] {
                judge(method, self.run(scene, method), tolerance);
            }
        }
        for n in RK4_STEPS {
            let [method, finer] = [n, 2.0 * n].map(|n| Method::rk4(self.until_s / n));
            let (motion, finer) = (self.run(scene, method), self.run(scene, finer));
            let difference = match (&motion, &finer) {
                (Ok(motion), Ok(finer)) => {
                    let least = if motion.crosses_any { CROSSING } else { REFERENCE };
                    distance(motion, finer, &scale).max(least * amplification)
                }
                // without a second run nothing is said
                _ => f64::INFINITY,
            };
            judge(method, motion, difference / amplification);
        }
        faults
    }
}

impl Fault {
    /// The same fault with as few changes of the scene as it takes.
    pub fn shrunk(mut self) -> Self {
        let fails = |case: &Case, method: Method| {
            let mut faults = case.judge(|_, _| {});
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
                samples: run.samples().map(|sample| [sample.coordinates, sample.velocities].concat()).collect(),
                crosses: run.samples().map(|sample| crosses(sample.t)).collect(),
                crosses_any: !run.rank.crossings.is_empty(),
                n_steps: run.cost.steps,
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

/// The largest difference of each pair of samples that can be compared, of its scale; NaN where one is none.
fn differences(a: &Motion, b: &Motion, scale: &[f64]) -> impl Iterator<Item = f64> {
    let pairs = a.samples.iter().zip(&b.samples).zip(a.crosses.iter().zip(&b.crosses));
    pairs.filter(|(_, (a, b))| !*a && !*b).map(move |((a, b), _)| {
        a.iter().zip(b).zip(scale).fold(0.0, |m: f64, ((a, b), scale)| worse(m, (a - b) / scale))
    })
}

/// The largest difference of two runs.
fn distance(a: &Motion, b: &Motion, scale: &[f64]) -> f64 {
    differences(a, b, scale).fold(0.0, worse)
}

/// How much a difference grows, from the move of the start, and from any sample to any later one.
fn amplification(moved: &Motion, reference: &Motion, scale: &[f64]) -> f64 {
    let grown = |(least, most): (f64, f64), difference: f64| {
        (least.min(difference), most.max(difference / least.min(difference)))
    };
    differences(moved, reference, scale).map(|difference| difference.max(REFERENCE)).fold((MOVED, 1.0), grown).1
}
