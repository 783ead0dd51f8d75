//! Powers of the single forces of a scene over a run.

use super::largest::{Curve, Largest};
use super::power_flow::{PowerFlow, find_extremes};
use ezy_core::model::{ForceElement, Scene};
use ezy_core::record::{Column, POTENTIAL, Sample};

/// A skate slides where its multiplier is its limit, but for the rounding of both.
const SLIDES: f64 = 1.0 - 1e-12;

/// The power of one force over a run.
#[derive(Debug, Clone, PartialEq)]
pub struct ElementFlow {
    /// What it is.
    pub element: ForceElement,
    /// Largest power that it delivers to the mechanism, W; `None` where it delivers none.
    pub delivered: Option<Largest>,
    /// Largest power that it takes from the mechanism, W, a positive number; `None` where it takes none.
    pub absorbed: Option<Largest>,
    /// Its work over the run, J: that which the run integrated or the difference of the potential energy where no other force takes part in it, else
    /// the integral of the power over the samples.
    pub work: f64,
}

/// The power of each force of a scene over a run, and at its samples.
///
/// Forces are those of [`Derived::force_elements`](ezy_core::model::Derived::force_elements), in their order.
#[derive(Debug, Clone, PartialEq)]
pub struct ElementFlows {
    /// What each force delivers and takes.
    pub all: Vec<ElementFlow>,
    /// By sample.
    powers: Vec<Vec<f64>>,
    near_largest: Vec<f64>,
}

impl ElementFlows {
    /// Of a run of this scene with these parameters; none of a scene written by hand. With works
    /// ([`Simulation::work`](ezy_core::simulate::Simulation::work)) the work of a force that is alone in its effect is the integrated one.
    pub fn of(scene: &dyn Scene, samples: &[Sample<'_>]) -> Self {
        let times: Vec<f64> = samples.iter().map(|sample| sample.t).collect();
        let powers = powers(scene, samples);
        let elements = scene.force_elements();
        let mut near_largest = Vec::new();
        let of = |(i, element): (usize, &ForceElement)| {
            for curve in curves(i, &times, &powers) {
                curve.times_near_peaks(&mut near_largest);
            }
            let [delivered, _] = curves(i, &times, &powers);
            let work = recorded_work(element, elements, samples).unwrap_or_else(|| delivered.integral());
            ElementFlow { element: *element, delivered: None, absorbed: None, work }
        };
        let all = elements.iter().enumerate().map(of).collect();
        let mut flows = Self { all, powers, near_largest };
        flows.find_largest(&times);
        flows
    }

    /// Times near the largest values, s, for [`Simulation::at`](ezy_core::simulate::Simulation::at).
    pub fn times_near_largest(&self) -> &[f64] {
        &self.near_largest
    }

    /// Finds the largest values in samples at the times near them. Powers at samples and works stay those of the first run.
    pub fn refine(&mut self, scene: &dyn Scene, samples: &[Sample<'_>]) {
        let times: Vec<f64> = samples.iter().map(|sample| sample.t).collect();
        let of_samples = std::mem::replace(&mut self.powers, powers(scene, samples));
        self.find_largest(&times);
        self.powers = of_samples;
    }

    /// Power of each force at sample `i`, W.
    pub fn powers(&self, i: usize) -> &[f64] {
        &self.powers[i]
    }

    /// The powers as columns of a table, `power.spring A ~ B`.
    pub fn columns(&self) -> Vec<Column> {
        let of = |flow: &ElementFlow| Column { name: format!("power.{}", flow.element.name), unit: "W".to_owned() };
        self.all.iter().map(of).collect()
    }

    /// The powers of effects that these do not tell already: all of them but that of the forces with a potential together.
    pub fn besides<'f>(&self, effects: &'f [PowerFlow]) -> &'f [PowerFlow] {
        match effects.split_last() {
            Some((last, others)) if last.name == POTENTIAL && !self.all.is_empty() => others,
            _ => effects,
        }
    }

    fn find_largest(&mut self, times: &[f64]) {
        let Self { all, powers, .. } = self;
        let extremes = find_extremes(powers.iter().flatten(), all.len(), |i| curves(i, times, powers));
        for (flow, [delivered, absorbed]) in all.iter_mut().zip(extremes) {
            (flow.delivered, flow.absorbed) = (delivered, absorbed);
        }
    }
}

/// The power that force `i` delivers, and that it takes.
fn curves<'a>(i: usize, times: &'a [f64], powers: &[Vec<f64>]) -> [Curve<'a>; 2] {
    [1.0, -1.0].map(|sign| Curve { times, values: powers.iter().map(|powers| sign * powers[i]).collect() })
}

/// The work of a force that is the only one in each sum that a run records and it takes part in: the work of its effect, the potential energy.
fn recorded_work(of: &ForceElement, all: &[ForceElement], samples: &[Sample<'_>]) -> Option<f64> {
    let (first, last) = (samples.first()?, samples.last()?);
    let mut work = 0.0;
    if of.has_potential {
        let is_alone = all.iter().filter(|other| other.has_potential).count() == 1;
        work += is_alone.then_some(first.energy.potential - last.energy.potential)?;
    }
    if of.does_work {
        let is_alone = all.iter().filter(|other| other.does_work && other.effect == of.effect).count() == 1;
        let group = of.effect.unwrap_or("model");
        let i = first.info.effects.iter().position(|effect| effect.name == group).filter(|_| is_alone)?;
        work += last.work.get(i)? - first.work.get(i)?;
    }
    Some(work)
}

/// The power of each force at each sample.
fn powers(scene: &dyn Scene, samples: &[Sample<'_>]) -> Vec<Vec<f64>> {
    let (info, n) = (scene.info(), scene.force_elements().len());
    let (n_inputs, n_states) = (info.n_inputs(), info.n_states());
    let mut c = vec![0.0; info.n_fixed()];
    let mut parameters = scene.parameters();
    let switches = info.parameters.len();
    scene.constants(&parameters, &mut c);
    let mut limits = vec![0.0; 2 * info.limited_skates.len()];
    let at = |sample: &Sample<'_>| {
        let Sample { t, coordinates: q, velocities: v, multipliers, .. } = *sample;
        c[..n_inputs].copy_from_slice(sample.inputs);
        c[n_inputs..n_inputs + n_states].copy_from_slice(sample.states);
        if !limits.is_empty() {
            scene.limited_skates(&c, t, q, v, &mut limits);
            for (skate, limit) in info.limited_skates.iter().zip(limits.iter().step_by(2)) {
                let multiplier = multipliers[skate.row];
                let side = if multiplier.abs() >= SLIDES * limit { multiplier.signum() } else { 0.0 };
                let of_skate = parameters[switches..].iter_mut().zip(info.switches);
                let of_skate = of_skate.filter(|(_, switch)| switch.row == skate.row);
                let holds = f64::from(u8::from(side == 0.0));
                of_skate.zip([holds, side]).for_each(|((present, _), value)| *present = value);
            }
            scene.constants(&parameters, &mut c);
        }
        let mut out = vec![0.0; n];
        scene.element_powers(&c, t, q, v, &mut out);
        out
    };
    samples.iter().map(at).collect()
}
