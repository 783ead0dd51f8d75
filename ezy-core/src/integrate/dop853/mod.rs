//! The method of Dormand and Prince of order 8, with error estimates of orders 5 and 3 and dense output of order 7.

mod dense;
mod tableau;

use super::step_control::Tolerance;
use super::{Knot, compensated};
use crate::dynamics::{MotionError, State, System};
use crate::model::Scene;
use tableau::{ERROR_3, ERROR_5, N_STAGES, N_STAGES_OF_DENSE_OUTPUT, NODES, STAGES};

/// Order of the error estimate's power of the step.
pub const ERROR_ORDER: i32 = 8;

/// Stages of the method for q' = v, v' = a(t, q, v), w' = power of each effect, as one vector y = (q, v, w).
///
/// Works are integrated beside the motion and do not choose its steps. What rounding cuts off a sum is added to the next
/// one, as in [`Rk4`](super::Rk4).
///
/// # Source
/// Prince, Dormand, J. Comp. Appl. Math. 7 (1981); Hairer, Nørsett, Wanner, Solving Ordinary Differential Equations I (1993),
/// II.5, II.6 and II.10.
#[derive(Debug)]
pub struct Dop853 {
    n_q: usize,
    /// Length of y.
    n: usize,
    /// Slopes of all stages, each `n` long.
    slopes: Vec<f64>,
    start: Vec<f64>,
    stage: Vec<f64>,
    /// What rounding cut off the last accepted step, and what it would cut off the present one.
    rest: Vec<f64>,
    next_rest: Vec<f64>,
    lambda: Vec<f64>,
    /// Coefficients of the dense output, each `n` long.
    dense: Vec<f64>,
}

impl Dop853 {
    /// Storage for a scene with these sizes.
    pub fn new(n_coordinates: usize, n_rows: usize, n_works: usize) -> Self {
        let n = 2 * n_coordinates + n_works;
        Self {
            n_q: n_coordinates,
            n,
            slopes: vec![0.0; N_STAGES_OF_DENSE_OUTPUT * n],
            start: vec![0.0; n],
            stage: vec![0.0; n],
            rest: vec![0.0; n],
            next_rest: vec![0.0; n],
            lambda: vec![0.0; n_rows],
            dense: vec![0.0; dense::N_COEFFICIENTS * n],
        }
    }

    /// Forgets what rounding cut off, before another run.
    pub fn restart(&mut self) {
        self.rest.fill(0.0);
    }

    /// One step of length `h` from `from`; writes `to`, not yet projected, and returns its error over the tolerance: a
    /// step is good when that is at most 1.
    ///
    /// # Errors
    /// [`MotionError`] of a stage; `to` is then unspecified.
    /// # Cost
    /// Eleven evaluations of the accelerations; no allocation.
    pub fn attempt<S: Scene + ?Sized>(
        &mut self,
        system: &mut System<'_, S>,
        from: Knot<'_>,
        h: f64,
        tolerance: Tolerance,
        to: &mut State,
    ) -> Result<f64, MotionError> {
        self.begin(from);
        for stage in 1..N_STAGES {
            self.evaluate(system, from.state.t, h, stage)?;
        }
        self.increment(h, STAGES[N_STAGES - 1]);
        for i in 0..self.n {
            self.next_rest[i] = self.rest[i];
            self.stage[i] = compensated::add(self.start[i], self.stage[i], &mut self.next_rest[i]);
        }
        write(&self.stage, to);
        to.t = from.state.t + h;
        Ok(self.error(h, tolerance))
    }

    /// Keeps what rounding cut off the step that was tried last.
    pub fn accept(&mut self) {
        std::mem::swap(&mut self.rest, &mut self.next_rest);
    }

    /// A first step: the slope and its change tell how long a step of order 8 with this tolerance may be.
    ///
    /// # Errors
    /// As [`Dop853::attempt`].
    pub fn first_step<S: Scene + ?Sized>(
        &mut self,
        system: &mut System<'_, S>,
        from: Knot<'_>,
        longest: f64,
        tolerance: Tolerance,
    ) -> Result<f64, MotionError> {
        self.begin(from);
        let n = 2 * self.n_q;
        let norm = |x: &[f64], start: &[f64]| {
            let scaled = x.iter().zip(start).map(|(x, y)| x / (tolerance.absolute + tolerance.relative * y.abs()));
            (scaled.map(|x| x * x).sum::<f64>() / n.max(1) as f64).sqrt()
        };
        let size = norm(&self.start[..n], &self.start);
        let rate = norm(&self.slopes[..n], &self.start);
        let guess = if size < 1e-10 || rate < 1e-10 { 1e-6 } else { 0.01 * size / rate };
        let guess = guess.min(longest);
        self.evaluate_euler(system, from.state.t, guess)?;
        let (first, second) = self.slopes.split_at(self.n);
        let change: Vec<f64> = second[..n].iter().zip(first).map(|(b, a)| b - a).collect();
        let bend = norm(&change, &self.start) / guess;
        let steepest = rate.max(bend);
        let step = if steepest <= 1e-15 {
            (1e-3 * guess).max(1e-6)
        } else {
            (0.01 / steepest).powf(1.0 / f64::from(ERROR_ORDER))
        };
        Ok(step.min(100.0 * guess).min(longest))
    }

    fn begin(&mut self, from: Knot<'_>) {
        let Knot { state, a, power } = from;
        read(&mut self.start, [&state.q, &state.v, &state.work]);
        read(&mut self.slopes[..self.n], [&state.v, a, power]);
    }

    /// `stage = start + h Σ weight · slope`
    fn combine(&mut self, h: f64, weights: &[(usize, f64)]) {
        self.increment(h, weights);
        self.stage.iter_mut().zip(&self.start).for_each(|(sum, start)| *sum += start);
    }

    /// `stage = h Σ weight · slope`
    fn increment(&mut self, h: f64, weights: &[(usize, f64)]) {
        self.stage.fill(0.0);
        for &(stage, weight) in weights {
            let slope = &self.slopes[stage * self.n..][..self.n];
            self.stage.iter_mut().zip(slope).for_each(|(sum, slope)| *sum += weight * slope);
        }
        self.stage.iter_mut().for_each(|sum| *sum *= h);
    }

    /// The slope of a stage.
    fn evaluate<S: Scene + ?Sized>(
        &mut self,
        system: &mut System<'_, S>,
        t: f64,
        h: f64,
        stage: usize,
    ) -> Result<(), MotionError> {
        self.combine(h, STAGES[stage - 1]);
        self.slope_at_stage(system, t + NODES[stage] * h, stage)
    }

    fn evaluate_euler<S: Scene + ?Sized>(
        &mut self,
        system: &mut System<'_, S>,
        t: f64,
        h: f64,
    ) -> Result<(), MotionError> {
        self.combine(h, &[(0, 1.0)]);
        self.slope_at_stage(system, t + h, 1)
    }

    fn slope_at_stage<S: Scene + ?Sized>(
        &mut self,
        system: &mut System<'_, S>,
        t: f64,
        stage: usize,
    ) -> Result<(), MotionError> {
        let n_q = self.n_q;
        let (q, rest) = self.stage.split_at(n_q);
        let v = &rest[..n_q];
        let slope = &mut self.slopes[stage * self.n..][..self.n];
        let (velocities, rest) = slope.split_at_mut(n_q);
        let (accelerations, powers) = rest.split_at_mut(n_q);
        velocities.copy_from_slice(v);
        system.accelerations(t, q, v, accelerations, &mut self.lambda)?;
        system.power(t, q, v, &self.lambda, powers);
        Ok(())
    }

    /// Error of the motion over the tolerance, from both embedded solutions.
    fn error(&self, h: f64, tolerance: Tolerance) -> f64 {
        let (mut five, mut three) = (0.0, 0.0);
        let n = 2 * self.n_q;
        for i in 0..n {
            let size = self.start[i].abs().max(self.stage[i].abs());
            let scale = tolerance.absolute + tolerance.relative * size;
            let estimate = |weights: &[(usize, f64)]| {
                weights.iter().map(|&(stage, weight)| weight * self.slopes[stage * self.n + i]).sum::<f64>() / scale
            };
            five += estimate(ERROR_5).powi(2);
            three += estimate(ERROR_3).powi(2);
        }
        if five == 0.0 {
            return 0.0;
        }
        h.abs() * five / ((five + 0.01 * three) * n as f64).sqrt()
    }
}

/// y = (q, v, w) from its parts.
fn read(y: &mut [f64], parts: [&[f64]; 3]) {
    let mut rest = y;
    for part in parts {
        let (this, others) = rest.split_at_mut(part.len());
        this.copy_from_slice(part);
        rest = others;
    }
}

fn write(y: &[f64], to: &mut State) {
    let (q, rest) = y.split_at(to.q.len());
    let (v, work) = rest.split_at(to.v.len());
    to.q.copy_from_slice(q);
    to.v.copy_from_slice(v);
    to.work.copy_from_slice(work);
}
