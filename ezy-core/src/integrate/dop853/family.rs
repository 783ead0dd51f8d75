//! The entry of DOP853 in the table of methods.

use super::adaptive::Adaptive;
use super::single_run::SingleRun;
use crate::dynamics::{Dynamics, System, SystemError};
use crate::integrate::family::{Family, MethodInfo, Needs, Sizes};
use crate::integrate::tolerances::second_run::{ROUNDING, TIGHTER};
use crate::integrate::{Integrator, Tolerance};
use crate::model::SceneRef;
use crate::scalar::Scalar;

impl Family for Adaptive {
    const INFO: MethodInfo = MethodInfo {
        name: "dop853",
        summary: "Method of Dormand and Prince of order 8 with steps that keep to a tolerance",
        order: Some(8),
        chooses_steps: true,
        is_implicit: false,
        needs: Needs::Nothing,
        takes_any_body: true,
        takes_states: true,
        tighter: TIGHTER,
        rounding: ROUNDING,
    };

    fn in_any_number<D: Dynamics<T>, T: Scalar>(
        sizes: Sizes,
        tolerance: Tolerance,
    ) -> Option<Box<dyn Integrator<D, T>>> {
        Some(Box::new(Adaptive::new(sizes, tolerance)))
    }

    fn of_system<P: SceneRef>(
        system: &System<P>,
        n_works: usize,
        tolerance: Tolerance,
        is_projected: bool,
    ) -> Result<Option<Box<dyn Integrator<System<P>>>>, SystemError> {
        let in_quasi_velocities = SingleRun::new(system, n_works, tolerance).filter(|_| is_projected);
        Ok(Some(match in_quasi_velocities {
            Some(run) => Box::new(run),
            None => Box::new(Adaptive::new(Sizes::new(system.info(), n_works), tolerance)),
        }))
    }
}
