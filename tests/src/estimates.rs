//! Estimates of the error of a run beside its true error.

use crate::garage::worse;
use ezy_core::integrate::PreciseMotion;
use ezy_core::model::Name;
use ezy_core::prelude::*;
use ezy_core::simulate::QuantityError;
use ezy_core_tests::simulation;

/// Intervals between samples.
const N_INTERVALS: f64 = 100.0;

/// Tolerances of the reference where the scene has no Taylor series or the motion is singular on the way.
const TIGHTEST: [f64; 3] = [1e-15, 1e-14, 1e-13];

/// Smaller errors, of one and the largest number with their unit, are rounding: both runs may round alike.
const ROUNDING: f64 = 512.0 * f64::EPSILON;

/// An error that passes through zero at the end is smaller than this part of the largest one; its estimate is of the size of the error of the second
/// run.
const PASSES_ZERO: f64 = 0.04;

/// Samples of a motion: time, positions, velocities, multipliers.
type Motion = Vec<(f64, [Vec<f64>; 3])>;

/// An estimate and the true error.
#[derive(Debug, Clone)]
pub struct Judged {
    /// `positions`, `velocities` or `multipliers`.
    pub quantity: &'static str,
    /// Their unit.
    pub unit: String,
    /// At the end, or the largest of all samples.
    pub is_at_end: bool,
    /// What the run says.
    pub estimate: f64,
    /// What it is off by.
    pub error: f64,
}

impl Judged {
    /// The estimate over the error.
    pub fn ratio(&self) -> f64 {
        self.estimate / self.error
    }
}

/// A motion to be judged against, as exact as there is one.
pub struct Reference {
    motion: Motion,
    /// The errors of positions, velocities and multipliers, by unit, that the best of all runs leaves: rounding, and how far a start is consistent.
    known: Vec<f64>,
}

/// Runs whose error is estimated.
pub struct Question<'s> {
    /// The scene.
    pub scene: &'s dyn Scene,
    /// Start values in place of the scene's.
    pub given: &'s [(Name, f64)],
    /// End, s.
    pub until_s: f64,
    /// Steps after which a run is ended.
    pub most_steps: u64,
    /// Whether errors count that the best run in doubles leaves, too.
    pub counts_rounding: bool,
}

impl<'s> Question<'s> {
    /// A scene as it is.
    pub fn of(scene: &'s dyn Scene) -> Self {
        Self { scene, given: &[], until_s: scene.info().until_s, most_steps: u64::MAX, counts_rounding: true }
    }

    fn order(&self, method: Method) -> Simulation<'s, &'s dyn Scene> {
        let order = simulation(self.scene).method(method).until(self.until_s).every(self.until_s / N_INTERVALS);
        let order = order.without_events().project_start().max_steps(self.most_steps);
        self.given.iter().fold(order, |order, (name, value)| order.start(&**name, *value))
    }
}

fn motion(run: &Run) -> Motion {
    let of = |sample: Sample<'_>| {
        (sample.t, [sample.coordinates, sample.velocities, sample.multipliers].map(<[f64]>::to_vec))
    };
    run.samples().map(of).collect()
}

impl Reference {
    /// In double-double where that is possible, otherwise by DOP853 with the smallest tolerance that comes to the end.
    pub fn of(question: &Question<'_>) -> Option<Self> {
        let ran = |tolerance: f64| {
            question.order(Method::dop853(tolerance)).run().ok().filter(|run| run.outcome.reached_end())
        };
        let mut runs = TIGHTEST.into_iter().filter_map(ran).map(|run| motion(&run));
        let (exact, other) = match precise(question) {
            Some(exact) if question.counts_rounding => (exact.clone(), exact),
            Some(exact) => (exact, runs.next()?),
            None => (runs.next()?, runs.next()?),
        };
        let known = differences(question.scene, &exact, &other).into_iter().map(|(.., [_, most])| most).collect();
        Some(Self { motion: exact, known })
    }

    /// The estimates of a run, and what it is off by; of errors that are known.
    pub fn judge(&self, question: &Question<'_>, method: Method) -> Result<(Vec<Judged>, Option<f64>), String> {
        let run = question.order(method).estimate_error().run().map_err(|error| error.to_string())?;
        let estimate = run.error_estimate.as_ref().expect("asked for");
        let estimate = estimate.as_ref().map_err(ToString::to_string)?;
        // what a run says of its rounding: of accelerations and multipliers, and of its iteration
        let rounding = run.monitors.condition.as_ref().map_or(0.0, |condition| condition.rounding);
        let iterated = ROUNDING.max(method.iteration_floor());
        let mut judged = Vec::new();
        let apart = differences(question.scene, &motion(&run), &self.motion);
        for ((quantity, unit, size, errors), known) in apart.into_iter().zip(&self.known) {
            let theirs = |of: &&QuantityError| of.quantity == quantity && of.unit == unit;
            let QuantityError { at_end, largest, .. } = estimate.errors.iter().find(theirs).expect("an estimate");
            let least = match quantity {
                _ if question.counts_rounding => ROUNDING,
                "multipliers" => rounding.max(iterated),
                _ => iterated,
            };
            for (is_at_end, estimate, error) in [(true, *at_end, errors[0]), (false, *largest, errors[1])] {
                if error > least * (1.0 + size) + 10.0 * known && error > PASSES_ZERO * errors[1] {
                    judged.push(Judged { quantity, unit: unit.clone(), is_at_end, estimate, error });
                }
            }
        }
        Ok((judged, estimate.amplification))
    }
}

fn precise(question: &Question<'_>) -> Option<Motion> {
    let scene = question.scene;
    if !scene.info().switches.is_empty() {
        return None;
    }
    let run = question.order(Method::taylor(1e-6)).run().ok().filter(|run| run.outcome.reached_end())?;
    let first = run.first();
    let start = State {
        t: first.t,
        q: first.coordinates.to_vec(),
        v: first.velocities.to_vec(),
        z: first.states.to_vec(),
        work: Vec::new(),
    };
    let mut precise = PreciseMotion::new(scene, &start).ok()?;
    let mut motion = Motion::new();
    for sample in run.samples() {
        precise.advance_to(sample.t).ok()?;
        let numbers = [precise.q(), precise.v(), precise.lambda()];
        motion.push((sample.t, numbers.map(|numbers| numbers.iter().map(|x| x.high()).collect())));
    }
    Some(motion)
}

/// Quantity, unit, largest number, and the largest differences at the end and of all samples.
fn differences(scene: &dyn Scene, one: &Motion, other: &Motion) -> Vec<(&'static str, String, f64, [f64; 2])> {
    let info = scene.info();
    let units: [(&str, Vec<String>); 3] = [
        ("positions", info.coordinates.iter().map(|c| c.unit.to_owned()).collect()),
        ("velocities", info.coordinates.iter().map(|c| format!("{}/s", c.unit)).collect()),
        ("multipliers", info.rows.iter().map(|row| row.multiplier_unit.to_owned()).collect()),
    ];
    let mut found = Vec::new();
    for (level, (quantity, units)) in units.into_iter().enumerate() {
        let mut distinct = units.clone();
        distinct.sort();
        distinct.dedup();
        for unit in distinct {
            let (mut size, mut most, mut last) = (0.0, 0.0, 0.0);
            for ((_, a), (_, b)) in one.iter().zip(other) {
                last = 0.0;
                for i in (0..units.len()).filter(|&i| units[i] == unit) {
                    last = worse(last, a[level][i] - b[level][i]);
                    size = worse(size, b[level][i]);
                }
                most = worse(most, last);
            }
            found.push((quantity, unit, size, [last, most]));
        }
    }
    found
}
