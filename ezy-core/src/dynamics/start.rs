//! A start that fulfils the constraints, from values that are given only in part.

use super::projection::{ROUNDING_OF_ROWS, position_tolerance};
use super::{StartError, State, System, max_abs};
use crate::model::{Scene, Start};

/// Gauss–Newton passes: far guesses need some tens, with a step that is halved when it overshoots.
const MAX_PASSES: usize = 100;

/// Halvings of one step before the search counts as stuck.
const MAX_HALVINGS: usize = 20;

/// Tries from places nearby when the search is stuck; out of a symmetry the first one or two lead.
const MAX_NUDGES: usize = 10;

/// Farthest that such a place is off in an angle, rad: well out of symmetry, without turning a body over.
const NUDGE: f64 = 0.5;

/// Another place replaces the one found first when it leaves less than this share of its residual.
const NOTICEABLY_LESS: f64 = 0.9;

/// Beyond this a coordinate keeps less than a micrometre, and the geometry of a body drowns in its rounding.
const LARGEST_VALUE: f64 = 1e9;

/// Passes over the velocity rows, which are linear: one solve and one that removes its rounding; with damping, some
/// more for directions of small singular values.
const VELOCITY_PASSES: usize = 2;
const DAMPED_VELOCITY_PASSES: usize = 10;

/// Residual of the velocity rows that counts as zero at moderate speeds, m/s and rad/s.
const VELOCITY_TOLERANCE: f64 = 1e-12;

const GOLDEN_RATIO: f64 = 1.618_033_988_749_895;

/// What a place leaves of the position rows.
struct Residual {
    /// The largest.
    norm: f64,
    /// All of them, as the length of a vector.
    length: f64,
}

impl<S: Scene + ?Sized> System<'_, S> {
    /// The start values of the scene.
    pub fn scene_start(&self) -> Start {
        let mut start = Start::free(self.info.n_coordinates());
        self.scene.start(&self.fixed, &mut start);
        start
    }

    /// A state that fulfils all rows: given values stay to the last bit, unless they are only near it and the rows cannot
    /// be met with them, the others move as little as possible in
    /// the mass matrix, positions by Gauss–Newton to |C| ≤ 1e-12, then velocities by a linear solve. A start that
    /// is consistent already is not touched. From a guess whose symmetry hides where to go (all bars of a loop in one
    /// line) the search goes on a little beside it, at places that are the same each time.
    ///
    /// Coordinates without mass count with the smallest positive mass or inertia.
    ///
    /// # Errors
    /// [`StartError`] when a value or a row is not finite, or when the rows cannot be met with the given values held.
    /// # Cost
    /// A dense singular value decomposition a pass; beyond 150 coordinates a sparse factorisation.
    pub fn consistent_start(&mut self, start: &Start) -> Result<State, StartError> {
        self.check_finite(start)?;
        let mut state = State::zero(self.info.n_coordinates(), self.info.n_effects());
        state.t = start.t;
        state.q.copy_from_slice(&start.q);
        state.v.copy_from_slice(&start.v);
        let free = start.without_near();
        self.assemble_positions(start, &mut state.q).or_else(|error| match &free {
            // from the best that could be done while they were held
            Some(free) => self.assemble_positions(free, &mut state.q),
            None => Err(error),
        })?;
        self.assemble_velocities(start, &state.q, &mut state.v).or_else(|error| match &free {
            Some(free) => self.assemble_velocities(free, &state.q, &mut state.v),
            None => Err(error),
        })?;
        Ok(state)
    }

    fn check_finite(&self, start: &Start) -> Result<(), StartError> {
        let positions = self.info.coordinates.iter().map(|c| c.name).zip(&start.q);
        let velocities = self.info.coordinates.iter().map(|c| c.velocity_name).zip(&start.v);
        for (name, &value) in positions.chain(velocities) {
            if !value.is_finite() {
                return Err(StartError::NotFinite { name, value });
            }
            if value.abs() > LARGEST_VALUE {
                return Err(StartError::TooLarge { name, value, largest: LARGEST_VALUE });
            }
        }
        Ok(())
    }

    fn assemble_positions(&mut self, start: &Start, q: &mut [f64]) -> Result<(), StartError> {
        let mut left = self.approach(start, q);
        let mut trial = q.to_vec();
        for n in 0..MAX_NUDGES {
            if left.norm <= position_tolerance(q) || start.q_given.iter().all(|given| *given) {
                break;
            }
            trial.copy_from_slice(q);
            self.nudge(&mut trial, &start.q_given, left.norm, n);
            let other = self.approach(start, &mut trial);
            let is_met = other.norm <= position_tolerance(&trial);
            if is_met || left.length.is_nan() || other.length < NOTICEABLY_LESS * left.length {
                q.copy_from_slice(&trial);
                left = other;
            }
        }
        let tolerance = position_tolerance(q);
        if left.norm <= tolerance {
            return Ok(());
        }
        self.position_residual(start.t, q);
        let held = start.q_given.iter().zip(self.info.coordinates).filter(|(given, _)| **given).map(|(_, c)| c.name);
        Err(self.contradiction("position", self.info.n_position_rows, tolerance, held.collect()))
    }

    /// Gauss–Newton from `q` as far as it goes, with steps halved until they shorten the residual.
    fn approach(&mut self, start: &Start, q: &mut [f64]) -> Residual {
        let (t, n_h) = (start.t, self.info.n_position_rows);
        let mut trial = q.to_vec();
        let mut left = self.position_residual_and_length(t, q);
        for _ in 0..MAX_PASSES {
            if left.norm <= position_tolerance(q) {
                break;
            }
            let Some(step) = self.free_correction(t, q, n_h, &start.q_given) else { break };
            // a least-squares step shortens the vector of residuals, not always the largest of them
            let mut fraction = 1.0;
            let mut improved = false;
            for _ in 0..MAX_HALVINGS {
                trial.iter_mut().zip(q.iter()).zip(&step).for_each(|((x, q), s)| *x = q + fraction * s);
                let there = self.position_residual_and_length(t, &trial);
                if there.length < left.length {
                    q.copy_from_slice(&trial);
                    left = there;
                    improved = true;
                    break;
                }
                fraction *= 0.5;
            }
            if !improved {
                break;
            }
        }
        left
    }

    fn position_residual_and_length(&mut self, t: f64, q: &[f64]) -> Residual {
        let norm = self.position_residual(t, q);
        Residual { norm, length: self.residual_length(self.info.n_position_rows) }
    }

    /// Moves what is not given: angles by up to [`NUDGE`], lengths by up to `length`, the residual (1 m where that is
    /// not a number). The amounts are multiples of the golden ratio without their whole parts, which fill an interval evenly.
    fn nudge(&self, q: &mut [f64], given: &[bool], length: f64, n: usize) {
        let length = if length.is_finite() { length } else { 1.0 };
        let n_q = q.len();
        for (i, x) in q.iter_mut().enumerate().filter(|(i, _)| !given[*i]) {
            let share = 2.0 * ((n * n_q + i + 1) as f64 * GOLDEN_RATIO).fract() - 1.0;
            *x += share * if self.info.coordinates[i].unit == "rad" { NUDGE } else { length };
        }
    }

    fn assemble_velocities(&mut self, start: &Start, q: &[f64], v: &mut [f64]) -> Result<(), StartError> {
        let (t, n_c) = (start.t, self.info.n_rows());
        let mut norm = self.velocity_residual(t, q, v);
        let mut length = self.residual_length(n_c);
        let mut trial = v.to_vec();
        let passes = if self.starts_sparse() { DAMPED_VELOCITY_PASSES } else { VELOCITY_PASSES };
        for _ in 0..passes {
            if norm <= velocity_tolerance(v) {
                return Ok(());
            }
            let Some(step) = self.free_correction(t, q, n_c, &start.v_given) else { break };
            trial.iter_mut().zip(v.iter()).zip(&step).for_each(|((x, v), s)| *x = v + s);
            let trial_norm = self.velocity_residual(t, q, &trial);
            let trial_length = self.residual_length(n_c);
            if trial_length.is_nan() || trial_length >= length {
                break;
            }
            v.copy_from_slice(&trial);
            (norm, length) = (trial_norm, trial_length);
        }
        let tolerance = velocity_tolerance(v);
        if norm <= tolerance {
            return Ok(());
        }
        self.velocity_residual(t, q, v);
        let names = self.info.coordinates.iter().map(|c| c.velocity_name);
        let held = start.v_given.iter().zip(names).filter(|(given, _)| **given).map(|(_, name)| name);
        Err(self.contradiction("velocity", n_c, tolerance, held.collect()))
    }

    /// Euclidean length of the first residuals in the buffer.
    fn residual_length(&self, n_rows: usize) -> f64 {
        self.buffers.residual[..n_rows].iter().map(|r| r * r).sum::<f64>().sqrt()
    }

    /// Names the rows whose residual in the buffer exceeds the tolerance, or one that is no number.
    fn contradiction(&self, level: &'static str, n_rows: usize, tolerance: f64, held: Vec<&'static str>) -> StartError {
        let residual = &self.buffers.residual[..n_rows];
        if let Some(i) = residual.iter().position(|r| !r.is_finite()) {
            return StartError::UndefinedRow { row: self.info.rows[i].name };
        }
        let mut rows: Vec<usize> = (0..n_rows).filter(|&i| residual[i].abs() > tolerance).collect();
        rows.sort_by(|&i, &j| residual[j].abs().total_cmp(&residual[i].abs()));
        let rows = rows.into_iter().map(|i| self.info.rows[i].name).collect();
        StartError::Contradiction { level, rows, residual: max_abs(residual), tolerance, held }
    }
}

fn velocity_tolerance(v: &[f64]) -> f64 {
    VELOCITY_TOLERANCE.max(ROUNDING_OF_ROWS * max_abs(v))
}
