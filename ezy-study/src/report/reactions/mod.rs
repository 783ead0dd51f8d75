//! What the joints of a run bear, and which power each effect and each force has: largest values, means, works.

mod element_flow;
mod joint;
mod largest;
mod power_flow;

pub use element_flow::{ElementFlow, ElementFlows};
pub use joint::{Joint, JointReaction};
pub use largest::Largest;
pub use power_flow::{PowerFlow, WorkBalance};

use ezy_core::record::{Column, Sample};

/// What the joints of a run bear, and which power each effect has.
///
/// Largest values are found in two runs. The samples of the first one say near which times they are, and a second run is asked for samples
/// there. The second run is the same motion, since samples never change it.
///
/// ```
/// # use ezy_core::prelude::*;
/// # use ezy_study::report::reactions::Reactions;
/// model! {
///     /// A point mass of 2 kg that swings through half a circle.
///     pub model Swing {
///         body bob { mass: 2, inertia: 0 }
///         hinge pin: ground(0, 0) ~ bob(-1, 0);
///         gravity (0, -9.81);
///         start level { bob angle 0; at rest; }
///         scene swings { start level; until 2 s; }
///     }
/// }
/// let scene = swing::Swings::default();
/// let simulation = || Simulation::new(&scene).work().power();
/// let run = simulation().every(1e-3).run()?;
/// let mut reactions = Reactions::of(&run.samples().collect::<Vec<_>>());
/// let near = simulation().at(reactions.times_near_largest().iter().copied()).run()?;
/// reactions.refine(&near.samples().collect::<Vec<_>>());
///
/// // at the lowest point it bears three times the weight
/// assert!((reactions.joints[0].largest.value - 3.0 * 2.0 * 9.81).abs() < 1e-6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Accuracy
/// Times and largest values are those of a parabola through three samples of the second run, which are 1/16 of the interval of the first one
/// apart, h. Of a smooth curve the value is as good as the run, but for h³/16 of its third derivative. At a jump, a kink or an end of the run it is
/// a sample, and late or early by h at most. What is shorter than the interval of the first run may be missed. Means are sums of trapezoids over the first run.
///
/// Impulses of stops are no reactions: they are left out. Powers of the single forces are in [`ElementFlows`].
#[derive(Debug, Clone, PartialEq)]
pub struct Reactions {
    /// What each joint bears, in the order of the rows.
    pub joints: Vec<JointReaction>,
    /// The power of each effect; empty where the run recorded no powers.
    pub powers: Vec<PowerFlow>,
    /// Works and kinetic energy.
    pub balance: WorkBalance,
    near_largest: Vec<f64>,
}

impl Reactions {
    /// Of a run that recorded works and powers ([`Simulation::work`](ezy_core::simulate::Simulation::work),
    /// [`Simulation::power`](ezy_core::simulate::Simulation::power)).
    pub fn of(samples: &[Sample<'_>]) -> Self {
        let times: Vec<f64> = samples.iter().map(|sample| sample.t).collect();
        let joints = samples.first().map(|sample| Joint::all(sample.info)).unwrap_or_default();
        let joints: Vec<_> = joints.into_iter().map(|joint| JointReaction::of(joint, &times, samples)).collect();
        let powers = PowerFlow::all(&times, samples);
        let mut near_largest = Vec::new();
        for of in &joints {
            joint::size(&of.joint, &times, samples).times_near_peaks(&mut near_largest);
        }
        for curve in (0..powers.len()).flat_map(|i| power_flow::curves(i, &times, samples)) {
            curve.times_near_peaks(&mut near_largest);
        }
        near_largest.sort_by(f64::total_cmp);
        near_largest.dedup();
        let balance = WorkBalance::of(samples, &powers);
        Self { joints, powers, balance, near_largest }
    }

    /// Times near the largest values, s, for [`Simulation::at`](ezy_core::simulate::Simulation::at).
    pub fn times_near_largest(&self) -> &[f64] {
        &self.near_largest
    }

    /// Finds the largest values in samples at the times near them. They hold powers, too.
    pub fn refine(&mut self, samples: &[Sample<'_>]) {
        let times: Vec<f64> = samples.iter().map(|sample| sample.t).collect();
        for joint in &mut self.joints {
            joint.find_largest(&times, samples);
        }
        power_flow::find_largest(&mut self.powers, &times, samples);
    }

    /// Time, the multipliers and norms of all joints, and the powers, as columns of a table.
    pub fn columns(&self) -> Vec<Column> {
        let column = |name: String, unit: &str| Column { name, unit: unit.to_owned() };
        let mut columns = vec![column("t".to_owned(), "s")];
        for JointReaction { joint, .. } in &self.joints {
            match joint.is_vector() {
                true => {
                    let components = ["x", "y", "z"].iter().take(joint.rows.len());
                    columns.extend(components.map(|axis| column(format!("lambda.{}.{axis}", joint.name), joint.unit)));
                    columns.push(column(format!("norm.{}", joint.name), joint.unit));
                }
                false => columns.push(column(format!("lambda.{}", joint.name), joint.unit)),
            }
        }
        columns.extend(self.powers.iter().map(|flow| column(format!("power.{}", flow.name), "W")));
        columns
    }

    /// The numbers of a sample in these columns.
    pub fn row(&self, sample: &Sample<'_>) -> Vec<f64> {
        let mut row = vec![sample.t];
        for JointReaction { joint, .. } in &self.joints {
            row.extend_from_slice(&sample.multipliers[joint.rows.clone()]);
            if joint.is_vector() {
                row.push(joint.reaction(sample.multipliers));
            }
        }
        row.extend(sample.power.iter().take(self.powers.len()));
        row
    }
}

#[cfg(test)]
mod tests;
