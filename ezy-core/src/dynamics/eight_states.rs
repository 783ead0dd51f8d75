//! Accelerations at eight states at once.

use super::{MotionError, Rows, System};
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
    /// What kernels read as `c`, in each lane and once.
    pub fixed: Vec<Eight>,
    of_each: Vec<f64>,
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
            of_each: Vec::new(),
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

    /// Takes over what kernels read in the present step.
    pub(crate) fn begin<P: SceneRef>(&mut self, system: &System<P>) {
        let Self { fixed, of_each, .. } = self;
        // all are compared, without a branch at each
        let change = of_each.iter().zip(&system.fixed).fold(0, |change, (x, y)| change | (x.to_bits() ^ y.to_bits()));
        if change != 0 || of_each.len() != system.fixed.len() {
            of_each.clone_from(&system.fixed);
            fixed.clear();
            fixed.extend(of_each.iter().map(|&x| Eight::from_f64(x)));
        }
    }

    /// Accelerations and multipliers within a run, as those of stages: by the elimination of the scene all at once, or one after the other.
    ///
    /// # Errors
    /// [`MotionError`] of any of them.
    pub(crate) fn accelerate<P: SceneRef>(&mut self, system: &mut System<P>) -> Result<(), MotionError> {
        if system.uses_elimination() && Self::has_all_rows(system) && self.eliminate(system) {
            return Ok(());
        }
        self.smallest_pivot = f64::INFINITY;
        for lane in 0..self.t.0.len() {
            self.one(lane);
            let OneState { q, v, a, lambda } = &mut self.one;
            system.at_with(self.t.0[lane], q, Rows::Held).accelerations(v, a, lambda)?;
            self.a.iter_mut().zip(a).for_each(|(eight, one)| eight.0[lane] = *one);
            self.lambda.iter_mut().zip(lambda).for_each(|(eight, one)| eight.0[lane] = *one);
        }
        Ok(())
    }

    /// Whether all rows of the scene hold, none of them redundant.
    pub(crate) fn has_all_rows<P: SceneRef>(system: &System<P>) -> bool {
        !system.active.leaves_out_redundant()
    }

    /// Power of each effect, W, with the multipliers that were found; writes nothing into an empty `out`.
    pub(crate) fn powers<P: SceneRef>(&mut self, system: &System<P>, out: &mut [Eight]) {
        if out.is_empty() {
            return;
        }
        if let Some(scene) = system.scene.in_lanes() {
            scene.powers_in_lanes(&self.fixed, &self.t, &self.q, &self.v, &self.lambda, out);
            return;
        }
        let mut of_one = vec![0.0; out.len()];
        for lane in 0..self.t.0.len() {
            let t = self.t.0[lane];
            let one = self.one(lane);
            system.power(t, &one.q, &one.v, &one.lambda, &mut of_one);
            out.iter_mut().zip(&of_one).for_each(|(out, one)| out.0[lane] = *one);
        }
    }

    /// Whether the elimination of the scene solved for all of them.
    fn eliminate<P: SceneRef>(&mut self, system: &mut System<P>) -> bool {
        let Some(scene) = system.scene.in_lanes() else { return false };
        let Self { t, q, v, a, lambda, smallest_pivot, fixed, .. } = self;
        let pivots = scene.accelerations_in_lanes(fixed, t, q, v, a, lambda);
        system.counters.evaluations += t.0.len() as u64;
        let smallest = system.counters.eliminated(pivots);
        *smallest_pivot = smallest.unwrap_or(f64::INFINITY);
        smallest.is_some()
    }
}
