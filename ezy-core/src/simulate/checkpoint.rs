//! What a stepper needs to go on to the last bit, as data.

use crate::archive::Archive;
use crate::dynamics::MotionError;
use crate::model::Scene;

/// Where a motion is, and all that its continuation depends on, made by [`Stepper::save`](super::Stepper::save): time, coordinates, velocities,
/// first-order states, works, inputs, and what the method keeps from one step to the next.
///
/// With the feature `serde` it can be written and read in formats with unsigned integers of 64 bits, such as JSON by serde_json: numbers are kept
/// as the bits of doubles, since few formats have infinities.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Checkpoint {
    of: Origin,
    numbers: Vec<u64>,
    scalars: Vec<u64>,
}

/// What a checkpoint belongs to.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Origin {
    /// Of the words of the model file; 0 of a scene written by hand.
    fingerprint: u64,
    /// The scene and how it is stepped, by name.
    settings: Vec<(String, String)>,
    /// Names of parameters and counts, with the bits of their values.
    parameters: Vec<(String, u64)>,
}

impl Origin {
    pub(super) fn new<S: Scene + ?Sized>(scene: &S, settings: &[(&str, String)]) -> Self {
        let info = scene.info();
        let of_scene = ("scene", format!("{}/{}", info.model, info.name));
        let settings = std::iter::once(&of_scene).chain(settings);
        let values = scene.parameters().into_iter().map(f64::to_bits);
        Self {
            fingerprint: info.fingerprint,
            settings: settings.map(|(name, value)| ((*name).to_owned(), value.clone())).collect(),
            parameters: info.parameters.iter().map(|parameter| parameter.name.to_owned()).zip(values).collect(),
        }
    }

    /// That a checkpoint of `self` belongs to `other`.
    fn check(&self, other: &Self) -> Result<(), CheckpointError> {
        let counts = |of: &Self| (of.settings.len(), of.parameters.len());
        let mut settings = self.settings.iter().zip(&other.settings);
        if let Some(((name, of), (_, to))) = settings.find(|(one, other)| one != other) {
            return Err(CheckpointError::OfAnother { what: name.clone(), of: of.clone(), to: to.clone() });
        }
        if self.fingerprint != other.fingerprint {
            return Err(CheckpointError::OfAnotherModelFile);
        }
        if counts(self) != counts(other) {
            return Err(CheckpointError::Damaged);
        }
        let mut parameters = self.parameters.iter().zip(&other.parameters);
        match parameters.find(|(one, other)| one != other) {
            Some(((name, of), (_, to))) => {
                let [of, to] = [of, to].map(|bits| f64::from_bits(*bits).to_string());
                Err(CheckpointError::OfAnother { what: name.clone(), of, to })
            }
            None => Ok(()),
        }
    }
}

/// A checkpoint cannot be restored.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CheckpointError {
    /// It is one of another scene, setting or parameter.
    #[error("the checkpoint is of {what} {of}, and the stepper has {to}; make the stepper as it was made then")]
    OfAnother {
        /// What differs: `scene`, `method`, `step`, another setting, or the name of a parameter.
        what: String,
        /// That of the checkpoint.
        of: String,
        /// That of the stepper.
        to: String,
    },
    /// The model file has changed since.
    #[error("the model file has changed since the checkpoint was made")]
    OfAnotherModelFile,
    /// Its numbers are too few, too many, or those of no motion.
    #[error("the checkpoint is damaged: its numbers are not those of the scene")]
    Damaged,
    /// Accelerations cannot be found where it was made.
    #[error(transparent)]
    Motion(#[from] MotionError),
}

impl Checkpoint {
    pub(super) fn new(of: Origin, archive: Archive) -> Self {
        let bits = |numbers: Vec<f64>| numbers.into_iter().map(f64::to_bits).collect();
        let (numbers, scalars) = archive.into_parts();
        Self { of, numbers: bits(numbers), scalars: bits(scalars) }
    }

    /// To be read by a stepper of this origin.
    pub(super) fn archive(&self, to: &Origin) -> Result<Archive, CheckpointError> {
        self.of.check(to)?;
        let numbers = |bits: &[u64]| bits.iter().copied().map(f64::from_bits).collect();
        Ok(Archive::of(numbers(&self.numbers), numbers(&self.scalars)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::integrate::Method;
    use crate::simulate::simulation;

    crate::model! {
        /// A stone that falls.
        pub model Stone {
            param m: kg = 2;
            body stone { mass: m, inertia: 1 }
            gravity (0, -10);
            start high { stone at (0, 5) angle 0; at rest; }
            scene falls { start high; until 1 s; }
        }
    }

    /// Numbers that are not finite have no place in JSON, their bits have.
    #[cfg(feature = "serde")]
    #[test]
    fn invariant_checkpoint_comes_back_from_a_text() {
        let scene = stone::Falls::default();
        let mut stepper = simulation(&scene).method(Method::rk4(1e-2)).stepper().unwrap();
        stepper.step(3).unwrap();
        let checkpoint = stepper.save();
        let text = serde_json::to_string(&checkpoint).unwrap();
        assert!(checkpoint.numbers.iter().any(|bits| !f64::from_bits(*bits).is_finite()), "{text}");
        assert_eq!(serde_json::from_str::<Checkpoint>(&text).unwrap(), checkpoint);
    }

    /// The stepper is then at its start, and goes on.
    #[test]
    fn invariant_damaged_checkpoint_is_refused() {
        let scene = stone::Falls::default();
        let mut stepper = simulation(&scene).method(Method::rk4(1e-2)).stepper().unwrap();
        stepper.step(10).unwrap();
        let (whole, state) = (stepper.save(), stepper.state().clone());
        let with = |i: usize, x: f64| {
            let mut numbers = whole.numbers.clone();
            numbers[i] = x.to_bits();
            numbers
        };
        for damaged in [
            Checkpoint { numbers: whole.numbers[1..].to_vec(), ..whole.clone() },
            Checkpoint { scalars: [&whole.scalars[..], &[0]].concat(), ..whole.clone() },
            // no count of steps, and no time
            Checkpoint { numbers: with(0, f64::INFINITY), ..whole.clone() },
            Checkpoint { numbers: with(4, f64::NAN), ..whole.clone() },
            Checkpoint { of: Origin { parameters: Vec::new(), ..whole.of.clone() }, ..whole.clone() },
        ] {
            assert_eq!(stepper.restore(&damaged), Err(CheckpointError::Damaged));
            stepper.reset();
            stepper.step(10).unwrap();
            assert_eq!(stepper.state(), &state);
        }
        let of = Origin { fingerprint: 1, ..whole.of.clone() };
        assert_eq!(stepper.restore(&Checkpoint { of, ..whole }), Err(CheckpointError::OfAnotherModelFile));
    }
}
