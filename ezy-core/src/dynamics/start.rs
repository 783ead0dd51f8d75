//! A start that fulfils the constraints, from values that are given only in part.

use super::assembly::Assembly;
use super::moved::MovedValue;
use super::tolerances::geometry::LARGEST_VALUE;
use super::tolerances::start::{LARGEST_TURN, LAST_DIGITS, MAX_HALVINGS, MAX_NUDGES, MAX_PASSES};
use super::{StartError, State, System, max_abs};
use crate::model::{CoordinateInfo, List, Name, SceneRef, Start, body_kind};
use crate::scalar::GOLDEN_RATIO;

/// What a place leaves of the position constraints.
struct Residual {
    /// The largest, in units of what counts as zero.
    excess: f64,
    /// The largest, in units of the sizes of the rows.
    share: f64,
    /// All of them in these units, as the length of a vector.
    length: f64,
}

impl Residual {
    fn is_met(&self) -> bool {
        self.excess <= 1.0
    }
}

impl<P: SceneRef> System<P> {
    /// The start values of the scene.
    pub fn scene_start(&self) -> Start {
        Start::declared_with(&*self.scene, &self.info, &self.fixed)
    }

    /// A state that fulfils all rows: given values stay to the last bit, unless they are only near it
    /// ([`Start::give_way`]) and the rows cannot be met with them; the others move as little as possible in the mass matrix,
    /// positions by Gauss–Newton, then velocities by a linear solve: `(v − v₀)ᵀ M (v − v₀)` is smallest, also where rows
    /// repeat each other. A start that is consistent already (1e-12 of the sizes of the rows) is not touched; what is
    /// assembled goes on to rounding. Quaternions are brought to unit length. A pass turns no body by more than 0.2 rad, so that elbows of loops stay on the side of
    /// the guess, and of near values centres give way before angles. From a guess whose symmetry hides where to go (all bars of a loop in one line) the search goes on a little
    /// beside it, at places that are the same each time.
    ///
    /// Coordinates without mass follow the others at no cost and, where these leave a choice, move as little as possible.
    ///
    /// # Errors
    /// [`StartError`] when a value or a row is not finite, when the rows cannot be met with the given values held, or when they are met in
    /// another assembly mode than near values ask for.
    /// # Cost
    /// A dense singular value decomposition a pass; beyond 150 coordinates a sparse factorisation.
    pub fn consistent_start(&mut self, start: &Start) -> Result<State, StartError> {
        self.assembly().consistent_start(start)
    }

    /// The given values of `start` that changed when `state` was assembled from it, coordinates first. Those that only got their last
    /// digits (1e-6 rad, or as much of the longest lever; of the largest velocity for velocities) are left out.
    pub fn moved_values(&self, start: &Start, state: &State) -> Vec<MovedValue> {
        let geometry = &self.geometry;
        let speed = geometry.extent_of_velocities(&start.v).max(geometry.extent_of_velocities(&state.v));
        let size_of = |info: &CoordinateInfo| if info.is_length() { geometry.length } else { 1.0 };
        let moved = |infos: &List<CoordinateInfo>, near: &[bool], given: &[f64], got: &[f64], speed: f64| {
            if !near.contains(&true) {
                return Vec::new();
            }
            let values = infos.iter().zip(near).zip(given).zip(got).filter(|(((_, near), _), _)| **near);
            let moved =
                values.filter(|(((info, _), given), got)| (*got - *given).abs() > LAST_DIGITS * size_of(info) * speed);
            moved.map(|(((info, _), given), got)| MovedValue::of(info, *given, *got)).collect::<Vec<_>>()
        };
        let mut values = moved(&self.info.coordinates, &start.q_near, &start.q, &state.q, 1.0);
        values.extend(moved(&self.info.velocities, &start.v_near, &start.v, &state.v, speed));
        values
    }
}

impl<P: SceneRef> Assembly<'_, P> {
    /// As [`System::consistent_start`].
    fn consistent_start(&mut self, start: &Start) -> Result<State, StartError> {
        self.check_finite(start)?;
        let (n_z, n_effects) = (self.system.info.n_states(), self.system.info.n_effects());
        let mut state =
            State::zeros([self.system.info.n_coordinates(), self.system.info.n_velocities()], n_z, n_effects);
        state.t = start.t;
        let given = start.z.iter().copied().map(Some).chain(std::iter::repeat(None));
        let values =
            self.system.info.states.iter().zip(given).map(|(declared, given)| given.unwrap_or(declared.default));
        state.z.iter_mut().zip(values).for_each(|(z, value)| *z = value);
        self.system.place_states(&state.z);
        state.q.copy_from_slice(&start.q);
        body_kind::normalize(&self.system.info.kinds, &mut state.q);
        state.v.copy_from_slice(&start.v);
        let free = start.without_near();
        if !self.assemble_positions(start, &mut state.q) {
            let Some(free) = &free else { return Err(self.contradicted_positions(start, &state.q)) };
            let guess = state.q.clone();
            // from the best that could be done while they were held; centres give way before angles
            let mut angles = start.clone();
            (0..angles.q.len())
                .filter(|&i| self.system.geometry.lengths[i])
                .for_each(|i| angles.q_given[i] = free.q_given[i]);
            if !self.assemble_positions(&angles, &mut state.q) {
                if !self.assemble_positions(free, &mut state.q) {
                    return Err(self.contradicted_positions(free, &state.q));
                }
                self.check_mode(start, &guess, &state)?;
            }
        }
        if !self.assemble_velocities(start, &state.q, &mut state.v) {
            let Some(free) = &free else { return Err(self.contradicted_velocities(start, &state.q, &state.v)) };
            if !self.assemble_velocities(free, &state.q, &mut state.v) {
                return Err(self.contradicted_velocities(free, &state.q, &state.v));
            }
        }
        Ok(state)
    }

    fn check_finite(&self, start: &Start) -> Result<(), StartError> {
        let (expected, found) = (self.system.info.n_states(), start.z.len());
        if found > expected {
            return Err(StartError::States { expected, found });
        }
        if let Some(body) = body_kind::without_attitude(&self.system.info.kinds, &start.q) {
            return Err(StartError::NoAttitude { body: self.system.info.bodies.item(body) });
        }
        let states = self.system.info.states.iter().map(|state| state.name).zip(&start.z);
        if let Some((name, &value)) = states.clone().find(|(_, value)| !value.is_finite()) {
            return Err(StartError::NotFinite { name: name.into(), value });
        }
        for (infos, values) in [(&self.system.info.coordinates, &start.q), (&self.system.info.velocities, &start.v)] {
            let name = |i: usize| infos.item(i).name;
            if let Some((i, &value)) =
                values.iter().enumerate().find(|(_, x)| !x.is_finite() || x.abs() > LARGEST_VALUE)
            {
                return Err(match value.is_finite() {
                    true => StartError::TooLarge { name: name(i), value, largest: LARGEST_VALUE },
                    false => StartError::NotFinite { name: name(i), value },
                });
            }
        }
        Ok(())
    }

    /// Whether the position constraints are met with what `start` gives held.
    fn assemble_positions(&mut self, start: &Start, q: &mut [f64]) -> bool {
        let held = body_kind::held(&self.system.info.kinds, &start.q_given);
        let mut left = self.approach(start.t, &held, q);
        let mut trial = q.to_vec();
        for n in 0..MAX_NUDGES {
            if left.is_met() || held.iter().all(|held| *held) {
                break;
            }
            trial.copy_from_slice(q);
            self.perturb(&mut trial, &held, left.share, n);
            let other = self.approach(start.t, &held, &mut trial);
            if other.is_met() || left.length.is_nan() || other.length < left.length {
                q.copy_from_slice(&trial);
                left = other;
            }
        }
        left.is_met()
    }

    fn contradicted_positions(&mut self, start: &Start, q: &[f64]) -> StartError {
        self.system.position_residual(start.t, q);
        let held = held_names(&self.system.info.coordinates, &start.q_given);
        let extent = self.system.geometry.extent(q);
        let tolerances =
            (0..self.system.info.n_position_rows).map(|row| self.system.geometry.position_tolerance(row, extent));
        self.contradiction("position", &tolerances.collect::<Vec<_>>(), held)
    }

    /// Gauss–Newton from `q` as far as it goes, with steps halved until they shorten the residual. Rows that are met at the
    /// first look leave `q` alone; else one pass more, for rounding, follows the one that meets them, and takes its whole step or none. What is `held`
    /// (`n_v`) does not move.
    fn approach(&mut self, t: f64, held: &[bool], q: &mut [f64]) -> Residual {
        let n_h = self.system.info.n_position_rows;
        let (mut trial, mut part) = (q.to_vec(), vec![0.0; held.len()]);
        let mut left = self.position_residual_at(t, q);
        if left.is_met() {
            return left;
        }
        for _ in 0..MAX_PASSES {
            let is_last = left.is_met();
            self.system.position_residual(t, q);
            let Some(step) = self.free_correction(t, q, n_h, held) else { break };
            let turns = step.iter().zip(&self.system.geometry.turns).filter(|(_, turns)| **turns);
            let turn = turns.fold(0.0, |turn: f64, (angle, _)| turn.max(angle.abs()));
            // a least-squares step shortens the vector of residuals, not always the largest of them
            let mut fraction = (LARGEST_TURN / turn).min(1.0);
            let mut improved = false;
            let n_trials = if is_last { 1 } else { MAX_HALVINGS };
            for _ in 0..n_trials {
                trial.copy_from_slice(q);
                part.iter_mut().zip(&step).for_each(|(part, step)| *part = fraction * step);
                self.system.retract(&mut trial, &part);
                let there = self.position_residual_at(t, &trial);
                if there.length < left.length {
                    q.copy_from_slice(&trial);
                    left = there;
                    improved = true;
                    break;
                }
                fraction *= 0.5;
            }
            if is_last || !improved {
                break;
            }
        }
        left
    }

    fn position_residual_at(&mut self, t: f64, q: &[f64]) -> Residual {
        self.system.position_residual(t, q);
        let residual = &self.system.residual[..self.system.info.n_position_rows];
        Residual {
            excess: self.system.geometry.position_excess(residual, q),
            share: self.system.geometry.share(residual),
            length: self.residual_length(residual.len()),
        }
    }

    /// Moves what is not `held` (`n_v`): angles by up to [`LARGEST_TURN`], lengths by up to `share` of the mechanism's, the residual (all of it
    /// where that is not a number). The amounts are multiples of the golden ratio without their whole parts, which fill an interval evenly.
    fn perturb(&self, q: &mut [f64], held: &[bool], share: f64, n: usize) {
        let length = self.system.geometry.length * if share.is_finite() { share } else { 1.0 };
        let mut by = vec![0.0; held.len()];
        for (i, by) in by.iter_mut().enumerate().filter(|(i, _)| !held[*i]) {
            let amount = 2.0 * ((n * held.len() + i + 1) as f64 * GOLDEN_RATIO).fract() - 1.0;
            *by = amount * if self.system.geometry.turns[i] { LARGEST_TURN } else { length };
        }
        self.system.retract(q, &by);
    }

    /// Whether all rows are met at velocity level with what `start` gives held.
    fn assemble_velocities(&mut self, start: &Start, q: &[f64], v: &mut [f64]) -> bool {
        let (t, n_c) = (start.t, self.system.info.n_rows());
        let mut trial = vec![0.0; v.len()];
        let drive = self.drive(start, q);
        let mut excess = self.velocity_excess(t, q, v, drive);
        let mut length = self.residual_length(n_c);
        for _ in 0..MAX_PASSES {
            if excess <= 1.0 {
                break;
            }
            self.system.velocity_residual(t, q, v);
            let Some(step) = self.free_correction(t, q, n_c, &start.v_given) else { break };
            trial.iter_mut().zip(v.iter()).zip(&step).for_each(|((x, v), s)| *x = v + s);
            let trial_excess = self.velocity_excess(t, q, &trial, drive);
            let trial_length = self.residual_length(n_c);
            if trial_length.is_nan() || trial_length >= length {
                break;
            }
            v.copy_from_slice(&trial);
            (excess, length) = (trial_excess, trial_length);
        }
        excess <= 1.0
    }

    /// What moves by itself: rows that depend on time. Where the guess can only come to rest, what is left of it is rounding.
    fn drive(&mut self, start: &Start, q: &[f64]) -> f64 {
        self.system.velocity_residual(start.t, q, &vec![0.0; start.v.len()]);
        let share = self.system.geometry.share(&self.system.residual);
        share.max(self.system.geometry.extent_of_velocities(&start.v))
    }

    fn contradicted_velocities(&mut self, start: &Start, q: &[f64], v: &[f64]) -> StartError {
        let drive = self.drive(start, q);
        self.system.velocity_residual(start.t, q, v);
        let held = held_names(&self.system.info.velocities, &start.v_given);
        let extent = self.system.geometry.extent_of_velocities(v).max(drive);
        let tolerances = (0..self.system.info.n_rows()).map(|row| self.system.geometry.velocity_tolerance(row, extent));
        self.contradiction("velocity", &tolerances.collect::<Vec<_>>(), held)
    }

    fn velocity_excess(&mut self, t: f64, q: &[f64], v: &[f64], drive: f64) -> f64 {
        self.system.velocity_residual(t, q, v);
        self.system
            .geometry
            .velocity_excess(&self.system.residual, self.system.geometry.extent_of_velocities(v).max(drive))
    }

    /// Euclidean length of the first residuals in the buffer, in units of the sizes of their rows.
    fn residual_length(&self, n_rows: usize) -> f64 {
        let rows = self.system.residual[..n_rows].iter().zip(&self.system.geometry.sizes);
        rows.map(|(r, size)| (r / size).powi(2)).sum::<f64>().sqrt()
    }

    /// Names the rows whose residual in the buffer exceeds its tolerance, or one that is no number.
    fn contradiction(&self, level: &'static str, tolerances: &[f64], held: Vec<Name>) -> StartError {
        let residual = &self.system.residual[..tolerances.len()];
        if let Some(i) = residual.iter().position(|r| !r.is_finite()) {
            return StartError::UndefinedRow { row: self.system.info.rows.item(i).name };
        }
        let mut rows: Vec<usize> = (0..residual.len()).filter(|&i| residual[i].abs() > tolerances[i]).collect();
        rows.sort_by(|&i, &j| residual[j].abs().total_cmp(&residual[i].abs()));
        let tolerance = rows.first().map_or(0.0, |&row| tolerances[row]);
        let rows = rows.into_iter().map(|i| self.system.info.rows[i].name.clone()).collect();
        StartError::Contradiction { level, rows, residual: max_abs(residual), tolerance, held }
    }
}

fn held_names(infos: &[CoordinateInfo], given: &[bool]) -> Vec<Name> {
    infos.iter().zip(given).filter(|(_, given)| **given).map(|(info, _)| info.name.clone()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::system_of;
    use crate::dynamics::tests::linkage;
    use crate::linalg::Backend;

    /// Guesses that fail are moved: angles by at most a fifth of a radian and lengths by the share of the longest lever that the residual is, each
    /// time by other amounts, which fill these intervals evenly.
    #[test]
    fn analytic_moved_guesses_fill_the_neighbourhood() {
        let scene = linkage::Turns::default();
        let mut system = system_of(&scene, Backend::Auto).unwrap();
        let (share, longest) = (0.1, system.geometry.length);
        let mut given = [false; 9];
        given[2] = true;
        let mut parts = Vec::new();
        for n in 0..25 {
            let mut q = [5.0; 9];
            system.assembly().perturb(&mut q, &given, share, n);
            assert_eq!(q[2], 5.0, "what is given stays");
            let moved = q.iter().enumerate().filter(|(i, _)| *i != 2);
            parts.extend(moved.map(|(i, q)| (q - 5.0) / if i % 3 == 2 { LARGEST_TURN } else { share * longest }));
        }
        assert!(parts.iter().all(|part| part.abs() <= 1.0 + 1e-12), "{parts:?}");
        parts.sort_by(f64::total_cmp);
        // two hundred parts of an interval of 2, evenly to a factor of 4
        let widest = parts.windows(2).map(|pair| pair[1] - pair[0]).fold(0.0, f64::max);
        assert!(
            widest <= 4.0 * 2.0 / parts.len() as f64 && parts[0] <= -0.96 && parts[parts.len() - 1] >= 0.96,
            "{widest}"
        );
        // a residual that is no number tells no size: the longest lever is taken
        let mut q = [0.0; 9];
        system.assembly().perturb(&mut q, &given, f64::NAN, 0);
        let mut by_one = [0.0; 9];
        system.assembly().perturb(&mut by_one, &given, 1.0, 0);
        assert_eq!(q, by_one);
    }
}
