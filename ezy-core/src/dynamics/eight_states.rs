//! Accelerations at eight states at once.

use super::{MotionError, System};
use crate::model::{Derived as _, Eight, Scene, SceneRef};
use crate::scalar::Scalar;

/// Eight states of a scene, one a lane, and what is computed there.
#[derive(Debug)]
pub(crate) struct EightStates {
    /// Times, s.
    pub t: Eight,
    /// Coordinates, `n_q`.
    pub q: Vec<Eight>,
    /// Velocities, `n_q`.
    pub v: Vec<Eight>,
    /// Accelerations, `n_q`.
    pub a: Vec<Eight>,
    /// Multipliers, `n_c`.
    pub lambda: Vec<Eight>,
    /// The smallest pivot of the eliminations of all eight; infinite where they were not eliminated.
    pub smallest_pivot: f64,
    /// What kernels read as `c`.
    fixed: Vec<Eight>,
    one: OneState,
}

/// A state out of the eight.
#[derive(Debug, Clone)]
pub(crate) struct OneState {
    pub q: Vec<f64>,
    pub v: Vec<f64>,
    pub a: Vec<f64>,
    pub lambda: Vec<f64>,
}

impl EightStates {
    /// Zeros.
    pub(crate) fn new<S: Scene + ?Sized>(scene: &S) -> Self {
        let info = scene.info();
        let (n_q, n_c) = (info.n_coordinates(), info.n_rows());
        let zeros = |n: usize| vec![Eight::from_f64(0.0); n];
        let zero = |n: usize| vec![0.0; n];
        Self {
            t: Eight::from_f64(0.0),
            q: zeros(n_q),
            v: zeros(n_q),
            a: zeros(n_q),
            lambda: zeros(n_c),
            smallest_pivot: f64::INFINITY,
            fixed: Vec::new(),
            one: OneState { q: zero(n_q), v: zero(n_q), a: zero(n_q), lambda: zero(n_c) },
        }
    }

    /// State `lane`, with the accelerations that were found there.
    pub(crate) fn one(&mut self, lane: usize) -> &OneState {
        let Self { q, v, a, lambda, one, .. } = self;
        for (one, eight) in [(&mut one.q, &*q), (&mut one.v, &*v), (&mut one.a, &*a), (&mut one.lambda, &*lambda)] {
            one.iter_mut().zip(eight).for_each(|(one, eight)| *one = eight.0[lane]);
        }
        &self.one
    }
}

impl<P: SceneRef> System<P> {
    /// Takes over what kernels read in the present step.
    pub(crate) fn begin_eight(&self, states: &mut EightStates) {
        states.fixed.clear();
        states.fixed.extend(self.fixed.iter().map(|&x| Eight::from_f64(x)));
    }

    /// Accelerations and multipliers within a run, as those of stages: by the elimination of the scene all at once, or one after the other.
    ///
    /// # Errors
    /// [`MotionError`] of any of them.
    pub(crate) fn accelerations_of_eight(&mut self, states: &mut EightStates) -> Result<(), MotionError> {
        if self.uses_elimination() && !self.active.leaves_out_redundant() && self.eliminate_eight(states) {
            return Ok(());
        }
        states.smallest_pivot = f64::INFINITY;
        for lane in 0..states.t.0.len() {
            states.one(lane);
            let OneState { q, v, a, lambda } = &mut states.one;
            self.accelerations_of_stage(states.t.0[lane], q, v, a, lambda)?;
            states.a.iter_mut().zip(a).for_each(|(eight, one)| eight.0[lane] = *one);
            states.lambda.iter_mut().zip(lambda).for_each(|(eight, one)| eight.0[lane] = *one);
        }
        Ok(())
    }

    /// Whether the elimination of the scene solved for all of them.
    fn eliminate_eight(&mut self, states: &mut EightStates) -> bool {
        let Some(scene) = self.scene.in_lanes() else { return false };
        let EightStates { t, q, v, a, lambda, smallest_pivot, fixed, .. } = states;
        let pivots = scene.accelerations_in_lanes(fixed, t, q, v, a, lambda);
        self.counters.evaluations += t.0.len() as u64;
        let smallest = self.eliminated(pivots);
        *smallest_pivot = smallest.unwrap_or(f64::INFINITY);
        smallest.is_some()
    }
}
