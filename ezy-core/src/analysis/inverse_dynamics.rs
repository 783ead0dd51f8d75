//! Inputs in place of drives: the forces and torques that a prescribed motion takes.

use super::derivatives;
use super::error::AnalysisError;
use super::tolerances::inverse::{BALANCED, INDEPENDENT, KEPT, MAX_STEPS};
use crate::dynamics::{By, Gradients, Of, OperatingPoint, Rows, State, System};
use crate::model::{Equations as _, Name, SceneRef};
use nalgebra::{DMatrix, DVector};

/// Which inputs do what drives do otherwise: with them the drives have nothing left to push.
///
/// Where an input is the torque at a joint that a drive moves, its value is minus the multiplier of the drive. Where motors sit at other
/// places than what is prescribed, as those of an arm whose tool is led along a path, they are found together.
///
/// ```
/// use ezy_core::analysis::InverseDynamics;
/// use ezy_core::prelude::*;
/// # ezy_core::model! {
/// #     model Arm {
/// #         param l: m = 1; param g: m/s^2 = 9.81;
/// #         input motor: N*m = 0;
/// #         body arm { mass: 2, inertia: 0.5 }
/// #         hinge pivot: ground(0, 0) ~ arm(-l/2, 0);
/// #         torque arm: motor;
/// #         gravity (0, -g);
/// #         drive path: arm.phi = 0.5 rad/s * t;
/// #         start level { arm at (l/2, 0) angle 0; arm velocity (0, l/2 * 0.5 rad/s) rate 0.5; }
/// #         scene lifts { start level; until 1 s; }
/// #     }
/// # }
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let scene = arm::Lifts::default();
/// let mut system = System::new(&scene, Backend::Auto)?;
/// let start = system.consistent_start(&system.scene_start())?;
/// let mut inverse = InverseDynamics::new(&system, &["path"], &["motor"])?;
/// let required = inverse.at(&mut system, &start)?;
/// assert!((required.inputs[0] - 9.81).abs() < 1e-12); // m g l/2
/// # Ok(())
/// # }
/// ```
pub struct InverseDynamics<P: SceneRef> {
    gradients: Gradients<P>,
    /// Rows of the drives.
    rows: Vec<usize>,
    inputs: Vec<usize>,
}

/// What a motion takes at a state.
#[derive(Debug, Clone, PartialEq)]
pub struct Required {
    /// The inputs, in the order in which they were named, each in its unit.
    pub inputs: Vec<f64>,
    /// Accelerations, `n_v`.
    pub accelerations: Vec<f64>,
    /// Multipliers, `n_c`: those of the drives are zero but for rounding, the others are the reactions.
    pub multipliers: Vec<f64>,
}

impl<P: SceneRef> InverseDynamics<P> {
    /// With constraints of the scene by name, of which drives are the usual ones, and as many inputs as these have rows.
    ///
    /// # Errors
    /// [`AnalysisError::Unknown`], [`AnalysisError::Unequal`], and those of [`Gradients::new`].
    pub fn new(system: &System<P>, drives: &[&str], inputs: &[&str]) -> Result<Self, AnalysisError> {
        let info = system.info();
        let unknown = |kind, name: &str, known: Vec<String>| AnalysisError::Unknown {
            scene: info.name,
            kind,
            name: name.to_owned(),
            known: known.join(", "),
        };
        let mut rows = Vec::new();
        for name in drives {
            let known = rows.len();
            // a constraint of two rows has one name, and each row one behind a dot
            let is_of = |row: &Name| row == name || row.strip_prefix(name).is_some_and(|rest| rest.starts_with('.'));
            rows.extend((0..info.n_rows()).filter(|&i| is_of(&info.rows[i].name)));
            if rows.len() == known {
                return Err(unknown("constraint", name, info.rows.iter().map(|row| row.name.to_string()).collect()));
            }
        }
        let places = inputs.iter().map(|name| {
            let place = info.inputs.iter().position(|input| input.name == *name);
            place.ok_or_else(|| unknown("input", name, info.inputs.iter().map(|input| input.name.to_owned()).collect()))
        });
        let inputs = places.collect::<Result<Vec<_>, _>>()?;
        if inputs.len() != rows.len() {
            return Err(AnalysisError::Unequal { n_rows: rows.len(), n_inputs: inputs.len() });
        }
        Ok(Self { gradients: Gradients::new(system)?, rows, inputs })
    }

    /// The inputs that a state takes, which meets the constraints; the system keeps them. The search begins at its present inputs; where
    /// forces are linear in them, as torques are, it is over in one step.
    ///
    /// # Errors
    /// [`AnalysisError::Alike`] where the inputs do not determine the forces of the drives, as in a singular position,
    /// [`AnalysisError::Unbalanced`] where no value is enough, and those of the accelerations.
    pub fn at(&mut self, system: &mut System<P>, state: &State) -> Result<Required, AnalysisError> {
        let State { t, q, v, z, .. } = state;
        system.place_states(z);
        let scene = system.info().name;
        let mut accelerations = vec![0.0; system.info().n_velocities()];
        let mut multipliers = vec![0.0; system.info().n_rows()];
        let mut left = f64::INFINITY;
        for step in 0..MAX_STEPS {
            system.accelerations(*t, q, v, &mut accelerations, &mut multipliers)?;
            let forces = DVector::from_iterator(self.rows.len(), self.rows.iter().map(|&row| multipliers[row]));
            let effects = self.effects(system, state, &accelerations, &multipliers)?;
            // what the forces are sums of
            let terms = effects.row_iter().map(|row| {
                let of_inputs = row.iter().zip(&self.inputs).map(|(effect, &i)| (effect * system.inputs()[i]).abs());
                of_inputs.fold(0.0, f64::max)
            });
            let largest = multipliers.iter().fold(0.0, |m: f64, x| m.max(x.abs())).max(terms.fold(0.0, f64::max));
            let before = std::mem::replace(&mut left, forces.amax());
            // it ends with its rounding
            if left <= BALANCED * largest && left > 0.5 * before || left == 0.0 {
                let inputs = self.inputs.iter().map(|&i| system.inputs()[i]).collect();
                return Ok(Required { inputs, accelerations, multipliers });
            }
            let svd = effects.svd(true, true);
            let (most, least) = (svd.singular_values.max(), svd.singular_values.min());
            let correction = svd.solve(&-forces, 0.0).ok().filter(|_| least > INDEPENDENT * most);
            let Some(correction) = correction else {
                if step == 0 {
                    return Err(AnalysisError::Alike { scene, t: *t });
                }
                break;
            };
            self.inputs.iter().zip(correction.iter()).for_each(|(&i, change)| system.inputs_mut()[i] += change);
        }
        let worst = self.rows.iter().max_by(|&&i, &&j| multipliers[i].abs().total_cmp(&multipliers[j].abs()));
        let drive = worst.map(|&row| system.info().rows[row].name.clone()).unwrap_or_default();
        Err(AnalysisError::Unbalanced { scene, t: *t, drive, left })
    }

    /// As [`InverseDynamics::at`], at a state of a motion that the drives lead, with its accelerations (`n_v`). Where drives leave something
    /// free, inputs that act at other places than the drives would move it differently: then the motion is not theirs.
    ///
    /// # Errors
    /// Those of [`InverseDynamics::at`], and [`AnalysisError::OtherMotion`].
    pub fn along(
        &mut self,
        system: &mut System<P>,
        state: &State,
        accelerations: &[f64],
    ) -> Result<Required, AnalysisError> {
        let required = self.at(system, state)?;
        let State { t, q, v, .. } = state;
        let mut forces = vec![0.0; accelerations.len()];
        system.scene().applied_force(system.fixed(), *t, q, v, &mut forces);
        // an acceleration is the difference of what forces and reactions do to a mass
        let of_forces = forces.iter().zip(system.mass_matrix()).filter(|(_, mass)| **mass > 0.0).map(|(f, m)| f / m);
        let largest = of_forces.chain(accelerations.iter().copied()).fold(0.0, |most: f64, a| most.max(a.abs()));
        let differences =
            required.accelerations.iter().zip(accelerations).map(|(with, without)| (with - without).abs());
        let worst = differences.enumerate().max_by(|(_, x), (_, y)| x.total_cmp(y));
        match worst {
            Some((i, difference)) if difference > KEPT * largest => {
                let info = system.info();
                let [with_inputs, with_drives] = [required.accelerations[i], accelerations[i]];
                let name = info.velocities[i].name.clone();
                Err(AnalysisError::OtherMotion { scene: info.name, t: *t, name, with_inputs, with_drives })
            }
            _ => Ok(required),
        }
    }

    /// How the forces of the drives depend on the inputs, from K [δa; δλ] = R_u δu.
    fn effects(
        &mut self,
        system: &mut System<P>,
        state: &State,
        accelerations: &[f64],
        multipliers: &[f64],
    ) -> Result<DMatrix<f64>, AnalysisError> {
        let State { t, q, v, .. } = state;
        let at = OperatingPoint { fixed: system.fixed(), t: *t, q, v, accelerations, multipliers };
        let by_inputs = derivatives(&mut self.gradients, &at, Of::Motion, By::Inputs).select_columns(&self.inputs);
        let (n_v, n_c) = (accelerations.len(), multipliers.len());
        let (mut a, mut lambda) = (vec![0.0; n_v], vec![0.0; n_c]);
        let mut effects = DMatrix::zeros(self.rows.len(), self.inputs.len());
        let mut at = system.at_with(*t, q, Rows::Projected);
        at.factor()?;
        for (mut effect, by_input) in effects.column_iter_mut().zip(by_inputs.column_iter()) {
            let by_input = by_input.as_slice();
            at.solve(&by_input[..n_v], &by_input[n_v..n_v + n_c], &mut a, &mut lambda);
            effect.iter_mut().zip(&self.rows).for_each(|(effect, &row)| *effect = lambda[row]);
        }
        Ok(effects)
    }
}
