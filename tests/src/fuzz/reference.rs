//! What runs by every method are compared with, and how far apart two motions are.

use std::ops::Range;

use ezy_core::prelude::*;

use crate::garage::worse;

/// Tolerance of the two references where there is none in double-double: below it a step of DOP853 has one witness, and rounding of Radau
/// shows.
pub(super) const REFERENCE: f64 = 1e-11;

/// Tolerances below this many times that of such references are not judged by them.
pub(super) const ABOVE_REFERENCE: f64 = 10.0;

/// What an error may be, in tolerances times amplification, since steps add up; for RK4, in differences to half the step.
pub const MARGIN: f64 = 100.0;

/// What starts are moved by to see the amplification, of their scale; differences of runs at the tolerance of references are
/// below a thousandth of it.
pub(super) const MOVED: f64 = 1e-8;

/// An error is judged by its bound where that is at most this part of the velocities: larger differences are no longer proportional.
pub(super) const LARGEST_BOUND: f64 = 0.1;

/// What a run computed.
#[derive(Clone)]
pub(super) struct Motion {
    /// Coordinates, velocities, first-order states, multipliers and works.
    pub(super) samples: Vec<Vec<f64>>,
    /// Largest energy, which works are relative to, J.
    pub(super) energy: f64,
    /// Times of events, s.
    pub(super) events: Vec<f64>,
    /// Samples in stretches across a singular position, which the run names: at a distance D from it velocities carry errors of
    /// positions multiplied by 1/D².
    pub(super) crosses: Vec<bool>,
    /// Times of samples, s.
    pub(super) times: Vec<f64>,
    pub(super) crosses_any: bool,
    /// The run remarks that it passes beside a singular position.
    pub(super) beside: bool,
    /// The largest difference of energy and works, relative to the energy turned over.
    pub(super) energy_error: f64,
    /// What rounding makes of accelerations and multipliers.
    pub(super) rounding: f64,
    /// The softest impact, m/s or rad/s.
    pub(super) softest: f64,
    pub(super) n_steps: u64,
}

/// Ranges of states, with those of first order, of multipliers and of works in a sample.
pub(super) type Parts = [Range<usize>; 3];

/// How much errors of a state grow.
#[derive(Debug, Clone, Copy)]
pub(super) struct Amplification {
    /// Of later states, multipliers and works.
    pub(super) parts: [f64; 3],
    /// How much they move events, s for the scale of a number; none where a moved start has more or fewer events.
    pub(super) of_events: Option<f64>,
}

impl Amplification {
    pub(super) const NONE: Self = Self { parts: [1.0; 3], of_events: Some(1.0) };

    pub(super) fn of_states(self) -> f64 {
        self.parts[0]
    }

    /// The larger of two.
    pub(super) fn max(self, other: Self) -> Self {
        let of_events = self.of_events.zip(other.of_events).map(|(one, other)| worse(one, other));
        Self { parts: [0, 1, 2].map(|i| worse(self.parts[i], other.parts[i])), of_events }
    }
}

/// What runs are compared with.
pub(super) struct Reference {
    pub(super) motion: Motion,
    /// What tolerances are relative to: one more than the largest of each number.
    pub(super) scale: Vec<f64>,
    pub(super) parts: Parts,
    /// Where velocities are in a sample.
    pub(super) velocities: Range<usize>,
    pub(super) amplification: Amplification,
    /// Whether more starts were moved to see it.
    pub(super) is_wide: bool,
    /// The smallest tolerance that it can judge.
    pub(super) least: f64,
}

impl Reference {
    /// The largest difference of two runs over what errors of states grow to, of the scale of each number, or of times of events.
    pub(super) fn error(&self, a: &Motion, b: &Motion) -> f64 {
        let [of_motion, of_works] = self.errors(a, b);
        worse(worse(of_motion, of_works), self.error_of_events(a, b))
    }

    /// The same of states and multipliers, and of works.
    pub(super) fn errors(&self, a: &Motion, b: &Motion) -> [f64; 2] {
        differences(a, b, &self.scale, &self.parts).fold([0.0; 2], |most, apart| {
            let [state, multipliers, works] = [0, 1, 2].map(|i| apart[i] / self.amplification.parts[i]);
            [worse(worse(most[0], state), multipliers), worse(most[1], works)]
        })
    }

    /// Whether the bound of an error is so large a part of the motion that errors are no longer proportional, and the run is no farther from the reference
    /// than that, or than two motions of this size can be.
    pub(super) fn branches(&self, motion: &Motion, tolerance: f64) -> bool {
        // a scale is one more than the largest value
        let velocities = self.scale[self.velocities.clone()].iter().map(|scale| (scale - 1.0) / scale);
        let fastest = velocities.fold(0.0, f64::max);
        let bound = MARGIN * tolerance * self.amplification.of_states();
        bound > LARGEST_BOUND * fastest && self.apart(motion, &self.motion) <= bound.max(2.0 * fastest)
    }

    /// The largest difference of states, of their scale.
    pub(super) fn apart(&self, a: &Motion, b: &Motion) -> f64 {
        differences(a, b, &self.scale, &self.parts).fold(0.0, |most, [states, ..]| worse(most, states))
    }

    /// Samples that are not compared.
    pub(super) fn n_skipped(&self, motion: &Motion) -> usize {
        let n = motion.samples.len().min(self.motion.samples.len());
        (0..n).filter(|n| is_skipped(motion, &self.motion, *n)).count()
    }

    pub(super) fn error_of_events(&self, a: &Motion, b: &Motion) -> f64 {
        self.amplification.of_events.map_or(0.0, |grown| late(a, b) / grown)
    }

    /// The error of a run in tolerances times amplification. Works and events have no reference in double-double.
    pub(super) fn excess(&self, motion: &Motion, tolerance: f64) -> f64 {
        let but_for_events = self.excess_but_for_events(motion, tolerance);
        let known = tolerance >= ABOVE_REFERENCE * REFERENCE;
        if known {
            worse(but_for_events, self.error_of_events(motion, &self.motion) / tolerance)
        } else {
            but_for_events
        }
    }

    pub(super) fn excess_but_for_events(&self, motion: &Motion, tolerance: f64) -> f64 {
        let [of_motion, of_works] = self.errors(motion, &self.motion);
        let known = tolerance >= ABOVE_REFERENCE * REFERENCE;
        (if known { worse(of_motion, of_works) } else { of_motion }) / tolerance
    }
}

/// What a run that reached its end computed.
pub(super) fn motion(run: &Run) -> Option<Motion> {
    match run.outcome {
        Outcome::ReachedEnd | Outcome::ReachedEvent { .. } => {
            // a sample at an event is at another time in each run
            let n = run.samples().len() - usize::from(matches!(run.outcome, Outcome::ReachedEvent { .. }));
            let crosses =
                |t: f64| run.rank.crossings.iter().any(|crossed| (crossed.from_s..=crossed.to_s).contains(&t));
            Some(Motion {
                samples: run
                    .samples()
                    .take(n)
                    .map(|Sample { coordinates, velocities, states, multipliers, work, .. }| {
                        [coordinates, velocities, states, multipliers, work].concat()
                    })
                    .collect(),
                energy: run
                    .samples()
                    .fold(0.0, |most: f64, sample| most.max(sample.energy.kinetic + sample.energy.potential.abs())),
                events: run.events().iter().map(|occurred| occurred.state.t).collect(),
                crosses: run.samples().take(n).map(|sample| crosses(sample.t)).collect(),
                times: run.samples().take(n).map(|sample| sample.t).collect(),
                crosses_any: !run.rank.crossings.is_empty(),
                beside: run.rank.crossings.iter().any(|crossed| crossed.is_beside()),
                energy_error: run.monitors.energy.map_or(0.0, |energy| energy.relative),
                rounding: run.monitors.condition.as_ref().map_or(0.0, |condition| condition.rounding),
                softest: run.monitors.softest_impact.map_or(f64::INFINITY, |impact| impact.speed),
                n_steps: run.cost.steps,
            })
        }
        _ => None,
    }
}

/// What tolerances are relative to: one more than the largest of each number.
pub(super) fn scale(reference: &Motion) -> Vec<f64> {
    let largest = |i: usize| reference.samples.iter().fold(0.0, |m: f64, sample| m.max(sample[i].abs()));
    (0..reference.samples[0].len()).map(|i| 1.0 + largest(i)).collect()
}

/// The largest differences of states, multipliers and works in each pair of samples that can be compared, of their scale; NaN where one is none.
pub(super) fn differences(a: &Motion, b: &Motion, scale: &[f64], parts: &Parts) -> impl Iterator<Item = [f64; 3]> {
    let pairs = a.samples.iter().zip(&b.samples).enumerate().filter(|(n, _)| !is_skipped(a, b, *n));
    pairs.map(move |(_, (a, b))| {
        parts.clone().map(|range| range.fold(0.0, |m: f64, i| worse(m, (a[i] - b[i]) / scale[i])))
    })
}

/// Whether sample `n` of two runs is not compared: in a stretch across a singular position, or after an event of one run and before that of the other, where an
/// impact parts velocities; times of events are compared by themselves.
pub(super) fn is_skipped(a: &Motion, b: &Motion, n: usize) -> bool {
    let t = a.times[n];
    let parted =
        a.events.len() == b.events.len() && a.events.iter().zip(&b.events).any(|(a, b)| (*a <= t) != (*b <= t));
    a.crosses[n] || b.crosses[n] || parted
}

/// The largest difference of times of events, s; infinite where there are more or fewer.
pub(super) fn late(a: &Motion, b: &Motion) -> f64 {
    if a.events.len() != b.events.len() {
        return f64::INFINITY;
    }
    a.events.iter().zip(&b.events).map(|(a, b)| a - b).fold(0.0, worse)
}

/// How much a difference of states grows, from the move of the start, and from any sample to any later one: in states, in multipliers and in
/// works, and in times of events, where these are as many.
pub(super) fn amplification(moved: &Motion, reference: &Motion, scale: &[f64], parts: &Parts) -> Amplification {
    let (mut least, mut most) = (MOVED, [1.0_f64; 3]);
    for [state, others @ ..] in differences(moved, reference, scale, parts) {
        let state = state.max(REFERENCE);
        least = least.min(state);
        let [multipliers, works] = others.map(|other| other / least);
        most = [most[0].max(state / least), most[1].max(multipliers), most[2].max(works)];
    }
    let late = late(moved, reference);
    Amplification { parts: most, of_events: late.is_finite().then_some(late / least) }
}
