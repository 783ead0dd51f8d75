//! The same motion by every method: what tolerance and the motion's own amplification do not explain is a fault; for RK4, what half the
//! step does not tell.

use ezy_core::integrate::PreciseMotion;
use ezy_core::model::{Name, SceneEntry};
use ezy_core::prelude::*;
use ezy_core::simulate::{EnergyError, SetupError};

use super::draw::Draw;
use super::parameters::{Scenes, change};
pub use super::reference::MARGIN;
use super::reference::{
    ABOVE_REFERENCE, Amplification, MOVED, Motion, REFERENCE, Reference, amplification, late, motion, scale,
};
use crate::garage::worse;
use ezy_core_tests::{simulation, system_of};

/// Tolerances that methods are judged at; a random case draws two between the first and the last.
const TOLERANCES: [f64; 5] = [1e-4, 1e-6, 1e-8, 1e-10, 1e-12];
const N_DRAWN: usize = 2;
const DECADES: [f64; 2] = [-12.0, -4.0];

/// Steps of RK4 over a run.
const RK4_STEPS: [f64; 2] = [1e3, 1e4];

/// Tolerance of the steps that carry RK4 across singular positions: half the step does not change them.
const CROSSING: f64 = 1e-9;

/// Share of a scene's time that is run, as powers of ten: up to three times of it.
const SHARES: [f64; 2] = [-2.0, 0.477];

/// Samples that are compared.
const N_SAMPLES: usize = 32;

/// Steps times unknowns after which a run is ended: a reference needs some hundred steps, and stiffness is no fault.
const MOST_NUMBERS: u64 = 200_000;

/// Starts that are moved at random. One more is faster by the same part: errors of steps add up in the energy, and faster motions drift
/// apart.
const N_MOVED: usize = 2;

/// More of them, before a run is called off: two directions of many may miss the one that grows most.
const N_MOVED_MORE: usize = 30;

/// And at so many places on the way, where other directions may grow than those that the start leads to.
const N_PLACES: usize = 8;
const N_MOVED_THERE: usize = 4;

/// A run from a sample goes on as the motion does where the two are apart by at most this part of what a moved start makes.
const GOES_ON: f64 = 0.1;

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
    /// It amplifies errors too much: by more than 1e5, or so that the bound is a tenth of the motion.
    Amplifies,
    /// Within its bound.
    Right,
    /// It stopped and said why.
    Stopped,
    /// Beyond its bound, and it says why: errors of its steps add up to more, it passes beside a singular position, where small errors decide, energy and works
    /// differ by more than the tolerance explains, the equations round to more than that, or impacts are softer.
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
    /// Steps.
    pub n_steps: u64,
    /// Samples that are not compared: in a crossing of a singular position, or between an event of one run and of another.
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

/// A run with its errors, in tolerances times amplification.
struct Judged {
    motion: Motion,
    n_skipped: usize,
    excess: f64,
    of_states: f64,
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
    pub fn over(self, until_s: f64) -> Self {
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
        let order = simulation(scene).method(method).until(self.until_s).every(every_s);
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
            Ok(run) => motion(&run).ok_or(Judgement::Stopped),
            Err(SetupError::NoSeries { .. } | SetupError::NoJacobians { .. }) => Err(Judgement::NotForIt),
            Err(_) => Err(Judgement::Stopped),
        }
    }

    /// What comes of a start that is moved: `by` says what is added to a number.
    fn moved(
        &self,
        scene: &dyn Scene,
        start: &[f64],
        mut by: impl FnMut(usize) -> f64,
        [until_s, every_s]: [f64; 2],
    ) -> Option<Motion> {
        let info = scene.info();
        let names = info.coordinates.iter().chain(&*info.velocities).map(|c| &*c.name);
        let names = names.chain(info.states.iter().map(|state| state.name));
        let start = names.zip(start).enumerate();
        let order = self.order(scene, Method::dop853(REFERENCE)).until(until_s).every(every_s);
        let order = start.fold(order, |order, (i, (name, value))| order.start(name, value + by(i)));
        order.run().ok().and_then(|run| motion(&run))
    }

    /// The motion of `explicit` in double-double; none where the scene has no series, changes its modes, or crosses a singular position.
    fn precise(&self, scene: &dyn Scene, explicit: &Motion) -> Option<Motion> {
        if explicit.crosses_any || !scene.info().switches.is_empty() {
            return None;
        }
        let n_q = scene.info().n_coordinates();
        let (q, rest) = explicit.samples[0].split_at(n_q);
        let (v, rest) = rest.split_at(n_q);
        let z = &rest[..scene.info().n_states()];
        let start = State { t: 0.0, q: q.to_vec(), v: v.to_vec(), z: z.to_vec(), work: Vec::new() };
        let mut precise = PreciseMotion::new(scene, &start).ok()?;
        let mut motion = explicit.clone();
        for (i, sample) in motion.samples.iter_mut().enumerate() {
            precise.advance_to(self.until_s * i as f64 / N_SAMPLES as f64).ok()?;
            let numbers = precise.q().iter().chain(precise.v()).chain(precise.z()).chain(precise.lambda());
            sample.iter_mut().zip(numbers).for_each(|(sample, number)| *sample = number.high());
        }
        Some(motion)
    }

    /// What runs of the case are compared with.
    fn reference(&self, scene: &dyn Scene) -> Result<Reference, Judgement> {
        let explicit = self.run(scene, Method::dop853(REFERENCE)).map_err(|_| Judgement::NoReference)?;
        let info = scene.info();
        let (n_q, n_state) = (info.n_coordinates(), 2 * info.n_coordinates() + info.n_states());
        let mut scale = scale(&explicit);
        let start = &explicit.samples[0];
        let n_multipliers = start.len() - n_state - info.n_effects();
        let parts = [0..n_state, n_state..n_state + n_multipliers, n_state + n_multipliers..start.len()];
        let velocities = n_q..2 * n_q;
        let masses = system_of(scene, Backend::Auto).map_err(|_| Judgement::NoReference)?;
        let kinetic = masses.mass_matrix().iter().zip(&scale[velocities.clone()]);
        let kinetic: f64 = kinetic.map(|(mass, scale)| mass * (scale - 1.0) * scale).sum();
        // a work is known as well as the energy of a state
        scale[parts[2].clone()].iter_mut().for_each(|scale| *scale += explicit.energy + kinetic);
        let mut draw = Draw::new(self.seed, 1);
        let over = [self.until_s, self.until_s / N_SAMPLES as f64];
        let faster = |i| if velocities.contains(&i) { MOVED * start[i] } else { 0.0 };
        let faster = self.moved(scene, start, faster, over);
        let moved =
            (0..N_MOVED).map(|_| self.moved(scene, start, |i| MOVED * scale[i] * draw.between(-1.0, 1.0), over));
        let moved = std::iter::once(faster).chain(moved).collect::<Option<Vec<Motion>>>();
        let moved = moved.ok_or(Judgement::NoReference)?;
        let grown = moved.iter().map(|moved| amplification(moved, &explicit, &scale, &parts));
        let amplification = grown.fold(Amplification::NONE, Amplification::max);
        if amplification.of_states() > LARGEST_AMPLIFICATION {
            return Err(Judgement::Amplifies);
        }
        let reference =
            |motion, least| Reference { motion, scale, parts, velocities, amplification, is_wide: false, least };
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
        let mut reference = match self.reference(scene) {
            Ok(reference) => reference,
            Err(judgement) => {
                tell(told(Method::dop853(REFERENCE), judgement, f64::NAN, f64::NAN));
                return Vec::new();
            }
        };
        let mut faults = Vec::new();
        let mut judge = |method: Method, amplification: f64, outcome: Result<Judged, Judgement>| {
            let Judged { motion, n_skipped, excess, of_states } = match outcome {
                Ok(judged) => judged,
                Err(judgement) => return tell(told(method, judgement, f64::NAN, amplification)),
            };
            let is_right = excess <= MARGIN;
            // a run tells what errors of its steps add up to
            let told_by_run = MARGIN.max(motion.n_steps as f64);
            let adds_up = excess <= told_by_run;
            // from here on `ezy run` remarks on the energy
            let tolerance = method.tolerance().map_or(f64::INFINITY, |t| t.relative);
            let explained = (told_by_run * tolerance).min(EnergyError::LARGEST_OF_FIXED_STEPS);
            let attainable = motion.rounding.max(method.iteration_floor()).max(tolerance);
            let is_rounding = excess * tolerance <= told_by_run * attainable;
            // a soft impact more or less hardly moves the bodies
            let is_soft = method.tolerance().is_some_and(|t| motion.softest < MARGIN * t.absolute);
            let is_soft = is_soft && of_states <= told_by_run;
            let remarks = adds_up || motion.beside || motion.energy_error > explained || is_rounding || is_soft;
            let judgement = match is_right {
                true => Judgement::Right,
                false if remarks => Judgement::Doubtful,
                false => Judgement::Fault,
            };
            if judgement == Judgement::Fault {
                faults.push(Fault { case: self.clone(), method, excess, amplification });
            }
            tell(Told { n_steps: motion.n_steps, n_skipped, ..told(method, judgement, excess, amplification) });
        };
        for &tolerance in &self.tolerances {
            for method in [Method::dop853, Method::taylor, Method::gauss, Method::radau] {
                let method = method(tolerance);
                if tolerance < reference.least {
                    judge(method, reference.amplification.of_states(), Err(Judgement::NoReference));
                    continue;
                }
                let judged = self.run(scene, method).and_then(|motion| {
                    let excess = self.excess(scene, &mut reference, &motion, tolerance);
                    let of_states = reference.apart(&motion, &reference.motion) / reference.amplification.of_states();
                    let of_states = of_states / tolerance;
                    let amplifies = excess > MARGIN && reference.branches(&motion, tolerance);
                    let is_known = !amplifies && reference.amplification.of_states() <= LARGEST_AMPLIFICATION;
                    let n_skipped = reference.n_skipped(&motion);
                    if is_known {
                        Ok(Judged { motion, n_skipped, excess, of_states })
                    } else {
                        Err(Judgement::Amplifies)
                    }
                });
                judge(method, reference.amplification.of_states(), judged);
            }
        }
        for n in RK4_STEPS {
            let [method, finer] = [n, 2.0 * n].map(|n| Method::rk4(self.until_s / n));
            // without a second run nothing is said
            let run = self.run(scene, method).and_then(|motion| {
                let finer = self.run(scene, finer).map_err(|_| Judgement::NoReference)?;
                let least = if motion.crosses_any { CROSSING } else { REFERENCE };
                let told = reference.error(&motion, &finer).max(least);
                // more events or fewer with half the step tell that either is wrong
                let excess = if told.is_finite() { reference.error(&motion, &reference.motion) / told } else { 1.0 };
                Ok(Judged { n_skipped: reference.n_skipped(&motion), motion, excess, of_states: f64::NAN })
            });
            judge(method, reference.amplification.of_states(), run);
        }
        faults
    }

    /// The error of a run in tolerances times amplification; where it is beyond the bound, by all that tells of amplification.
    fn excess(&self, scene: &dyn Scene, reference: &mut Reference, motion: &Motion, tolerance: f64) -> f64 {
        let is_right = |excess: f64| excess <= MARGIN;
        let excess = reference.excess(motion, tolerance);
        if is_right(excess) {
            return excess;
        }
        let start = reference.motion.samples[0].clone();
        let [mut draw, mut draw_off] = [2, 3].map(|part| Draw::new(self.seed, part));
        let mut moved = |size: f64, reference: &Reference| {
            let over = [self.until_s, self.until_s / N_SAMPLES as f64];
            self.moved(scene, &start, |i| size * reference.scale[i] * draw.between(-1.0, 1.0), over)
        };
        if !std::mem::replace(&mut reference.is_wide, true) {
            for _ in 0..N_MOVED_MORE {
                let Some(moved) = moved(MOVED, reference) else { continue };
                let grown = amplification(&moved, &reference.motion, &reference.scale, &reference.parts);
                reference.amplification = reference.amplification.max(grown);
            }
            let mut parts = [1.0, self.of_multipliers(scene, reference, &mut draw_off).unwrap_or(1.0), 1.0];
            for grown in self.on_the_way(scene, reference, &mut draw_off) {
                parts = [0, 1, 2].map(|i| worse(parts[i], grown[i]));
            }
            reference.amplification = reference.amplification.max(Amplification { parts, ..Amplification::NONE });
        }
        let excess = reference.excess(motion, tolerance);
        if is_right(excess) || late(motion, &reference.motion).is_finite() {
            return excess;
        }
        // a knock too soft, or a limit hardly passed: errors within the bound make more events, or fewer
        let is_settled = (0..N_MOVED_MORE)
            .filter_map(|_| moved(MARGIN * tolerance, reference))
            .all(|moved| late(&moved, &reference.motion).is_finite());
        if is_settled { excess } else { reference.excess_but_for_events(motion, tolerance) }
    }

    /// How much errors that are made on the way grow, of motions that go on from a sample as from a start: those without a clock and modes.
    fn on_the_way(&self, scene: &dyn Scene, reference: &Reference, draw: &mut Draw) -> Vec<[f64; 3]> {
        let Reference { motion, scale, parts, .. } = reference;
        let mut found = Vec::new();
        for place in (1..N_PLACES).map(|i| i * N_SAMPLES / N_PLACES) {
            let until_s = self.until_s * (1.0 - place as f64 / N_SAMPLES as f64);
            let Some(start) = motion.samples.get(place) else { break };
            let rest = Motion {
                samples: motion.samples[place..].to_vec(),
                crosses: motion.crosses[place..].to_vec(),
                ..motion.clone()
            };
            // works begin anew
            let parts = [parts[0].clone(), parts[1].clone(), 0..0];
            let every_s = self.until_s / N_SAMPLES as f64;
            let mut go_on = |size: f64| {
                let by = |i: usize| size * scale[i] * draw.between(-1.0, 1.0);
                let moved = self.moved(scene, start, by, [until_s, every_s])?;
                Some((reference.apart(&moved, &rest), amplification(&moved, &rest, scale, &parts).parts))
            };
            let Some((unmoved, _)) = go_on(0.0) else { continue };
            let moved = (0..N_MOVED_THERE).filter_map(|_| go_on(MOVED));
            found.extend(moved.filter(|(moved, _)| unmoved <= GOES_ON * moved).map(|(_, parts)| parts));
        }
        found
    }

    /// How much multipliers grow by errors of the states that they belong to, which obey the rows to 1e-12 alone; none where rows are switched, or
    /// multipliers at such a state cannot be computed.
    fn of_multipliers(&self, scene: &dyn Scene, reference: &Reference, draw: &mut Draw) -> Option<f64> {
        let info = scene.info();
        if !info.switches.is_empty() {
            return None;
        }
        let mut system = system_of(scene, Backend::Auto).ok()?;
        let Reference { motion, scale, parts: [of_states, of_multipliers, _], .. } = reference;
        let mut multipliers = |t: f64, state: &[f64]| {
            let (q, rest) = state.split_at(info.n_coordinates());
            let (v, z) = rest.split_at(q.len());
            system.place_states(z);
            let (mut a, mut lambda) = (vec![0.0; v.len()], vec![0.0; info.n_rows()]);
            system.accelerations(t, q, v, &mut a, &mut lambda).ok().map(|_| lambda)
        };
        let mut most = 1.0;
        for (i, sample) in motion.samples.iter().enumerate() {
            let t = self.until_s * i as f64 / N_SAMPLES as f64;
            let state = &sample[of_states.clone()];
            let there = multipliers(t, state)?;
            for _ in 0..N_MOVED_MORE {
                let moved = state.iter().zip(scale).map(|(x, scale)| x + MOVED * scale * draw.between(-1.0, 1.0));
                let moved = multipliers(t, &moved.collect::<Vec<_>>())?;
                let grown =
                    there.iter().zip(&moved).zip(&scale[of_multipliers.clone()]).map(|((x, y), scale)| (x - y) / scale);
                most = grown.map(|grown| grown.abs() / MOVED).fold(most, worse);
            }
        }
        Some(most)
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
