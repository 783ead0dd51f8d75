//! Powers of the effects over a run, and the balance of their works.

use super::largest::{Curve, Largest};
use ezy_core::record::{POTENTIAL, Sample};

/// Powers below this part of the largest one of a run are rounding of the sums that they are.
const ROUNDING: f64 = 1e-12;

/// The power of an effect over a run.
#[derive(Debug, Clone, PartialEq)]
pub struct PowerFlow {
    /// Name of the effect; `model`, `drives`, `stops` as in [`SceneInfo::effects`](ezy_core::model::SceneInfo::effects); `potential`: all forces with
    /// a potential together, such as gravity and springs.
    pub name: &'static str,
    /// Largest power that it delivers to the mechanism, W; `None` where it delivers none.
    pub delivered: Option<Largest>,
    /// Largest power that it takes from the mechanism, W, a positive number; `None` where it takes none.
    pub absorbed: Option<Largest>,
    /// Its work over the run, J; NaN where the run recorded no works.
    pub work: f64,
}

/// The works of all effects beside the change of kinetic energy.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WorkBalance {
    /// Work of all effects and of the forces with a potential, J; NaN where the run recorded no works.
    pub work: f64,
    /// Kinetic energy at the end less that at the start, J.
    pub kinetic: f64,
}

impl WorkBalance {
    /// Work less change of kinetic energy, J: zero but for the error of the method.
    pub fn difference(&self) -> f64 {
        self.work - self.kinetic
    }

    pub(super) fn of(samples: &[Sample<'_>], flows: &[PowerFlow]) -> Self {
        let kinetic =
            [samples.first(), samples.last()].map(|sample| sample.map_or(0.0, |sample| sample.energy.kinetic));
        Self { work: flows.iter().fold(0.0, |sum, flow| sum + flow.work), kinetic: kinetic[1] - kinetic[0] }
    }
}

impl PowerFlow {
    /// Of every effect, and of the forces with a potential where there is one; none where the run recorded no powers.
    pub(super) fn all(times: &[f64], samples: &[Sample<'_>]) -> Vec<Self> {
        let [Some(first), Some(last)] = [samples.first(), samples.last()] else { return Vec::new() };
        let names: Vec<&'static str> = first.info.effects.iter().map(|effect| effect.name).chain([POTENTIAL]).collect();
        let has_potential = samples.iter().any(|sample| sample.energy.potential != 0.0);
        let n = if has_potential { names.len() } else { names.len() - 1 };
        let mut flows: Vec<Self> = (0..n.min(first.power.len()))
            .map(|i| {
                let of_potential = first.energy.potential - last.energy.potential;
                let work = last.work.get(i).copied();
                let work = work.unwrap_or(if i + 1 == names.len() { of_potential } else { f64::NAN });
                Self { name: names[i], delivered: None, absorbed: None, work }
            })
            .collect();
        find_largest(&mut flows, times, samples);
        flows
    }
}

/// Looks for the largest powers in samples.
pub(super) fn find_largest(flows: &mut [PowerFlow], times: &[f64], samples: &[Sample<'_>]) {
    let powers = samples.iter().flat_map(|sample| &sample.power[..flows.len().min(sample.power.len())]);
    let extremes = find_extremes(powers, flows.len(), |i| curves(i, times, samples));
    for (flow, [delivered, absorbed]) in flows.iter_mut().zip(extremes) {
        (flow.delivered, flow.absorbed) = (delivered, absorbed);
    }
}

/// The largest power that each of `n` delivers and takes, by its two curves; `all` are the powers that tell what is rounding.
pub(super) fn find_extremes<'a, 'p>(
    all: impl Iterator<Item = &'p f64>,
    n: usize,
    curves: impl Fn(usize) -> [Curve<'a>; 2],
) -> Vec<[Option<Largest>; 2]> {
    let least = ROUNDING * all.fold(0.0, |most: f64, power| most.max(power.abs()));
    // a parabola through samples of friction that comes to rest passes zero where no sample does
    let has_some = |curve: &Curve<'_>| curve.values.iter().any(|power| *power > least);
    let largest = |curve: Curve<'_>| Some(curve).filter(has_some)?.largest().map(|peak| peak.largest);
    (0..n).map(|i| curves(i).map(largest)).collect()
}

/// The power that effect `i` delivers, and that it takes.
pub(super) fn curves<'a>(i: usize, times: &'a [f64], samples: &[Sample<'_>]) -> [Curve<'a>; 2] {
    [1.0, -1.0].map(|sign| Curve::new(times, samples, |sample| sign * sample.power.get(i).copied().unwrap_or_default()))
}
