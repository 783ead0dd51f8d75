//! Joints, and what they bear.

use std::ops::Range;

use super::largest::{Curve, Largest};
use ezy_core::model::SceneInfo;
use ezy_core::record::Sample;

/// Components of the force of a joint, in the order of its rows.
const COMPONENTS: [&str; 3] = ["x", "y", "z"];

/// Unit of the rows that are components of one force.
const OF_FORCES: &str = "N";

/// A constraint whose reaction is one force or one torque: a hinge with its two rows, or a single row.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Joint {
    /// Its name; that of the row where it is one of several that are no components: `S.across`.
    pub name: String,
    /// The word that declared it: `hinge`, `skate`, …
    pub kind: &'static str,
    /// Unit of its reaction: N or N*m.
    pub unit: &'static str,
    /// Its rows in [`SceneInfo::rows`].
    pub rows: Range<usize>,
}

impl Joint {
    /// The joints of a scene, in the order of its rows.
    pub fn all(info: &SceneInfo) -> Vec<Self> {
        let mut joints = Vec::new();
        let mut first = 0;
        while let Some(row) = info.rows.get(first) {
            let n = n_components(info, first);
            let whole = row.name.rsplit_once('.').map_or(&*row.name, |(joint, _)| joint);
            let name = if n > 1 { whole } else { &*row.name };
            let (kind, unit) = (row.kind, row.multiplier_unit);
            joints.push(Self { name: name.to_owned(), kind, unit, rows: first..first + n });
            first += n;
        }
        joints
    }

    /// Whether its reaction is a vector.
    pub fn is_vector(&self) -> bool {
        self.rows.len() > 1
    }

    /// The norm of its reaction in N; of a single row the multiplier with its sign, in N or N m.
    pub fn reaction(&self, multipliers: &[f64]) -> f64 {
        match multipliers[self.rows.clone()] {
            [multiplier] => multiplier,
            ref components => components.iter().fold(0.0, |norm: f64, component| norm.hypot(*component)),
        }
    }
}

/// How many rows from this one on are components of one force: `B.x`, `B.y`. One where it is none.
fn n_components(info: &SceneInfo, first: usize) -> usize {
    let of = |row: usize, component: &str| {
        let row = info.rows.get(row).filter(|row| row.multiplier_unit == OF_FORCES)?;
        Some((row.kind, row.name.strip_suffix(component)?.strip_suffix('.')?))
    };
    let joint = of(first, COMPONENTS[0]);
    let alike =
        (1..).zip(&COMPONENTS[1..]).take_while(|(i, component)| joint.is_some() && of(first + i, component) == joint);
    1 + alike.count()
}

/// What a joint bears over a run.
///
/// Reactions are multipliers, with the signs of `docs/notation.md`. Of a vector the norm is told, of a single row the multiplier with its sign.
#[derive(Debug, Clone, PartialEq)]
pub struct JointReaction {
    /// The joint.
    pub joint: Joint,
    /// The reaction of largest magnitude.
    pub largest: Largest,
    /// Direction of the largest reaction of a joint with two rows, rad, from the axis of its first row to that of the second one.
    pub direction: Option<f64>,
    /// Mean over time.
    pub mean: f64,
    /// Root mean square over time.
    pub rms: f64,
}

impl JointReaction {
    pub(super) fn of(joint: Joint, times: &[f64], samples: &[Sample<'_>]) -> Self {
        let reaction = Curve::new(times, samples, |sample| joint.reaction(sample.multipliers));
        let [mean, rms] = reaction.mean_and_rms();
        let mut of = Self { joint, largest: Largest { value: 0.0, t: 0.0 }, direction: None, mean, rms };
        of.find_largest(times, samples);
        of
    }

    /// Looks for the largest reaction in samples.
    pub(super) fn find_largest(&mut self, times: &[f64], samples: &[Sample<'_>]) {
        let size = size(&self.joint, times, samples);
        let Some(peak) = size.largest() else { return };
        let component = |row: usize| size.at_peak(&peak, &Curve::new(times, samples, |sample| sample.multipliers[row]));
        let Largest { value, t } = peak.largest;
        self.largest = match self.joint.is_vector() {
            true => peak.largest,
            false => Largest { value: value.copysign(component(self.joint.rows.start)), t },
        };
        self.direction = match self.joint.rows.clone().collect::<Vec<_>>()[..] {
            [x, y] => Some(component(y).atan2(component(x))),
            _ => None,
        };
    }
}

/// Magnitude of the reaction of a joint.
pub(super) fn size<'a>(joint: &Joint, times: &'a [f64], samples: &[Sample<'_>]) -> Curve<'a> {
    Curve::new(times, samples, |sample| joint.reaction(sample.multipliers).abs())
}
