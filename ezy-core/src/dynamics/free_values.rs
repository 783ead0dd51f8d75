//! Start values that neither the given ones nor the constraints determine.

use super::State;
use super::assembly::Assembly;
use super::tolerances::start::{MAX_PASSES, RANK_TOLERANCE};
use crate::model::body_kind;
use crate::model::{Name, SceneRef, Start};
use crate::scalar::GOLDEN_RATIO;

impl<P: SceneRef> Assembly<'_, P> {
    /// Names of the values of `start` that are not given and that the constraints leave free at `state`, coordinates first; velocities
    /// where one is given that is not 0.
    ///
    /// # Cost
    /// That of a pass of [`System::consistent_start`] at each level; of a few where it is sparse.
    pub(crate) fn free_values(&mut self, start: &Start, state: &State) -> Vec<Name> {
        let (n_h, n_c) = (self.system.info.n_position_rows, self.system.info.n_rows());
        let positions = self.free_places(state, n_h, &body_kind::held(&self.system.info.kinds, &start.q_given));
        let moves = start.v_given.iter().zip(&start.v).any(|(given, v)| *given && *v != 0.0);
        let velocities = if moves { self.free_places(state, n_c, &start.v_given) } else { Vec::new() };
        let moved = body_kind::coordinates_moved(&self.system.info.kinds, self.system.info.n_velocities());
        let positions = positions.iter().map(|&i| self.system.info.coordinates[moved[i]].name.clone());
        positions.chain(velocities.iter().map(|&i| self.system.info.velocities[i].name.clone())).collect()
    }

    /// Places that are not `given` and not determined by the first `n_rows` rows: a change of all that is not given, which the rows are
    /// then satisfied with again, leaves something of itself in these.
    fn free_places(&mut self, state: &State, n_rows: usize, given: &[bool]) -> Vec<usize> {
        let (length, turns) = (self.system.geometry.length, self.system.geometry.turns.clone());
        let unit = |i: usize| if turns[i] { 1.0 } else { length };
        // between half a unit and one, of no pattern that rows could have
        let amount = |i: usize| 0.5 + 0.5 * ((i + 1) as f64 * GOLDEN_RATIO).fract();
        let mut change: Vec<f64> = (0..given.len()).map(|i| if given[i] { 0.0 } else { amount(i) * unit(i) }).collect();
        let mut residual = vec![0.0; n_rows];
        // a pass leaves what the damping of sparse corrections takes of it, most where many bodies follow each other
        let passes = if self.starts_sparse() { MAX_PASSES } else { 1 };
        for _ in 0..passes {
            residual.fill(0.0);
            self.add_change(state.t, &state.q, &change, &mut residual);
            let back = self.free_tangent(state.t, &state.q, &residual, given);
            change.iter_mut().zip(&back).for_each(|(change, back)| *change += back);
            if back.iter().enumerate().all(|(i, back)| back.abs() <= RANK_TOLERANCE * unit(i)) {
                break;
            }
        }
        (0..given.len()).filter(|&i| !given[i] && change[i].abs() > RANK_TOLERANCE * unit(i)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::system_of;
    use crate::linalg::Backend;
    use crate::model::Scene;

    crate::model! {
        /// A trolley on a rail with a rod that hangs from it, and a stone that nobody placed.
        pub model Loose {
            body trolley { mass: 3, inertia: 1 }
            body rod { mass: 1, inertia: 1/12 }
            body stone { mass: 2, inertia: 1 }
            slider rail: ground(0, 0) ~ trolley(0, 0) along ground(1, 0);
            hinge pin: trolley(0, 0) ~ rod(0, 1/2);
            start placed { trolley at (1, _); rod angle 0.3; stone angle 0; at rest; }
            start pushed { trolley at (1, _) velocity (2, _); rod angle 0.3; stone at (0, 0) angle 0; }
            scene hangs { start placed; until 1 s; }
            scene rolls { start pushed; until 1 s; }
        }
    }

    fn free(scene: &dyn Scene) -> Vec<Name> {
        let mut system = system_of(scene, Backend::Auto).unwrap();
        let start = system.scene_start();
        let state = system.consistent_start(&start).unwrap();
        system.assembly().free_values(&start, &state)
    }

    /// The rail and the pin place the rod; nothing places the stone.
    #[test]
    fn analytic_what_constraints_determine_is_not_free() {
        assert_eq!(free(&loose::Hangs::default()), ["stone.x", "stone.y"]);
    }

    /// The rod may turn at any rate, and its centre moves with it; the stone was never said to be at rest.
    #[test]
    fn analytic_free_velocities_are_named_where_the_scene_moves() {
        let expected = ["rod.vx", "rod.vy", "rod.omega", "stone.vx", "stone.vy", "stone.omega"];
        assert_eq!(free(&loose::Rolls::default()), expected);
    }

    crate::model! {
        /// Rods in a row that hang from a pin, and a stone that nobody placed.
        pub model Hung {
            count n = 3;
            body rod[n] { mass: 1, inertia: 1/12 }
            body stone { mass: 2, inertia: 1 }
            hinge top: ground(0, 0) ~ rod[0](-1/2, 0);
            for i in 1..n { hinge pin[i]: rod[i-1](1/2, 0) ~ rod[i](-1/2, 0); }
            start level { for i in 0..n { rod[i] angle 0; } stone angle 0; at rest; }
            scene hangs { start level; until 1 s; }
        }
    }

    /// Thousands of centres follow the angles of their rods, one from the other.
    #[cfg(feature = "sparse")]
    #[test]
    fn analytic_what_a_long_chain_determines_is_not_free() {
        for n in [10, 60, 3000] {
            assert_eq!(free(&hung::Hangs { n }), ["stone.x", "stone.y"], "{n}");
        }
    }
}
