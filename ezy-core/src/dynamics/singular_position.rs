//! Positions in which constraints depend on each other, and not beside them.

use super::diagnosis::Diagnosis;
use super::tolerances::singular_position::{BESIDE, LEAVES, SHORTEST};
use super::{Metric, MotionError, Rows, Solved, State, System};
use crate::linalg::{INDEPENDENT, Independent, LARGEST_DIAGNOSED};
use crate::model::SceneRef;
use crate::scalar::GOLDEN_RATIO;

impl<P: SceneRef> Diagnosis<'_, P> {
    /// Whether a motion can begin at a state with accelerations `a`, where rows may be redundant: what is redundant there has to remain
    /// satisfied along the motion for `within_s`.
    ///
    /// Two bars that are stretched between two fixed points fulfil all rows, but first-order motions of their joint do not lead on: no
    /// finite force holds it.
    ///
    /// # Errors
    /// [`MotionError::SingularPosition`], and those of [`System::accelerations`].
    pub(crate) fn check_beginning(
        &mut self,
        state: &State,
        a: &[f64],
        solved: Solved,
        within_s: f64,
    ) -> Result<(), MotionError> {
        let State { t, q, v, .. } = state;
        let (speed, pull) =
            (self.system.geometry.extent_of_velocities(v), self.system.geometry.extent_of_velocities(a));
        if !solved.is_rank_deficient || self.system.info.n_unknowns() > LARGEST_DIAGNOSED || speed + pull == 0.0 {
            return Ok(());
        }
        let s = within_s.min(2.0 * BESIDE / (speed + (speed * speed + 2.0 * pull * BESIDE).sqrt()));
        let way: Vec<f64> = v.iter().zip(a).map(|(v, a)| s * (v + 0.5 * s * a)).collect();
        let mut there = q.clone();
        self.system.retract(&mut there, &way);
        let velocities: Vec<f64> = v.iter().zip(a).map(|(v, a)| v + s * a).collect();
        let way = self.system.geometry.extent_of_velocities(&way);
        if way < SHORTEST {
            return Ok(());
        }
        let left = self.with_rows_of(*t, q, |system| {
            let mut projector = system.projector();
            projector.polish_positions(t + s, &mut there)?;
            projector.worst_velocity(t + s, &there, &velocities);
            projector.correct(t + s, &there, Metric::Mass, Rows::Held).map(|solved| solved.left)
        })?;
        let size = self.system.geometry.units.iter().zip(&velocities).map(|(unit, v)| (unit * v).abs());
        let share = left.rows / size.fold(left.scale, f64::max);
        if share <= LEAVES * way || !self.is_singular_position(*t, q) {
            return Ok(());
        }
        let rows = self.rank_loss(*t, q).rows;
        Err(MotionError::SingularPosition { t: *t, rows, level: "the velocities", residual: share })
    }

    /// Whether rows depend on each other at a configuration, but not beside it on a motion that the independent ones allow.
    #[cold]
    pub(super) fn is_singular_position(&mut self, t: f64, q: &[f64]) -> bool {
        let here =
            self.system.at(t, q).rank(Independent::Above(INDEPENDENT)).map(|rank| (rank.rank(), rank.n_redundant()));
        let Some((rank, 1..)) = here else { return false };
        // a direction without symmetry
        let units = self.system.geometry.units.iter().enumerate();
        let mut way: Vec<f64> = units.map(|(i, unit)| ((i + 1) as f64 * GOLDEN_RATIO).fract() / unit).collect();
        if self.system.at_with(t, q, Rows::Projected).project_onto_null_space(&mut way).is_err() {
            return false;
        }
        let share = BESIDE / self.system.geometry.extent_of_velocities(&way);
        way.iter_mut().for_each(|way| *way *= share);
        let mut there = q.to_vec();
        self.system.retract(&mut there, &way);
        // of an error of 1e-6 one correction leaves 1e-12
        let corrected = self.with_rows_of(t, q, |system| system.projector().polish_positions(t, &mut there));
        let beside = self.system.at(t, &there).rank(Independent::Above(INDEPENDENT)).map(|rank| rank.rank());
        corrected.is_ok() && beside.is_some_and(|beside| beside > rank)
    }

    /// What rows that leave something are said to do: contradict each other, or depend on each other in one position.
    #[cold]
    pub(super) fn disagreement(
        &mut self,
        t: f64,
        q: &[f64],
        level: &'static str,
        residual: f64,
        tolerance: f64,
    ) -> MotionError {
        let rows = self.rank_loss(t, q).rows;
        match self.is_singular_position(t, q) {
            true => MotionError::SingularPosition { t, rows, level, residual },
            false => MotionError::ContradictoryRows { t, rows, level, residual, tolerance },
        }
    }

    /// Holds the rows that are independent at a configuration, for as long as `ask` runs.
    fn with_rows_of<T>(&mut self, t: f64, q: &[f64], ask: impl FnOnce(&mut System<P>) -> T) -> T {
        let held = std::mem::take(&mut self.system.active.held);
        self.system.at(t, q).hold_rows(true);
        let answer = ask(self.system);
        self.system.active.held = held;
        self.system.factors.forget();
        answer
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::system_of;
    use crate::linalg::Backend;

    crate::model! {
        /// Two bars between two fixed points, which they just reach.
        pub model Stretched {
            body left { mass: 1, inertia: 1/12 }
            body right { mass: 1, inertia: 1/12 }
            hinge A: ground(0, 0) ~ left(-0.5, 0);
            hinge B: left(0.5, 0) ~ right(-0.5, 0);
            hinge C: right(0.5, 0) ~ ground(2, 0);
            start straight { left angle 0; right angle 0; at rest; }
            scene hangs { start straight; until 0.1 s; }
        }
    }

    /// Both bars turn, from rest or not, until their centres have moved across by [`BESIDE`]: the bars of 1 m are at twice that as an angle then,
    /// and the rows are off by twice the angle times the rate, whatever the rate is.
    #[test]
    fn analytic_stretched_bars_are_refused_at_any_rate() {
        let scene = stretched::Hangs::default();
        let mut system = system_of(&scene, Backend::Auto).unwrap();
        let mut state = State { q: vec![0.5, 0.0, 0.0, 1.5, 0.0, 0.0], ..State::zero(6, 0) };
        let (mut a, mut lambda) = ([0.0; 6], [0.0; 6]);
        let solved = system.accelerations(0.0, &state.q, &state.v, &mut a, &mut lambda).unwrap();
        let motion = |rate: f64| vec![0.0, 0.5 * rate, rate, 0.0, 0.5 * rate, -rate];
        for (rate, acceleration) in
            [(1.0, 0.0), (1e-6, 0.0), (100.0, 0.0), (0.0, 1.0), (0.0, 1e-6), (0.0, 1e4), (0.1, 1.0)]
        {
            state.v = motion(rate);
            let refused = system.diagnosis().check_beginning(&state, &motion(acceleration), solved, f64::INFINITY);
            let Err(MotionError::SingularPosition { residual, .. }) = refused else {
                panic!("{rate} {acceleration}: {refused:?}")
            };
            assert!(
                (residual / (4.0 * BESIDE) - 1.0).abs() <= 4.0 * BESIDE * BESIDE,
                "{rate} {acceleration}: {residual}"
            );
        }
    }
}
