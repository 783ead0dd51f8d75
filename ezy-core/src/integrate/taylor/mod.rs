//! Taylor's method: the motion as a power series about the start of each step.

mod along_series;
mod expansion;
mod length;
mod precise;
mod states;
mod sums;
mod work;

use super::{Tolerance, compensated};
use crate::archive::Archive;
use crate::dynamics::{Configuration, MotionError, Rows, Solved, State, System};
use crate::model::{Derived as _, Scene, SceneRef, Series, SeriesStore};
use expansion::{OrderSolver, expand, expand_with, increment, second_derivative};
use states::States;
use work::Quadrature;

pub(crate) use along_series::AlongSeries;
use length::order_for;
pub use precise::{PreciseError, PreciseMotion};

/// Series of q, v, first-order states and the multipliers, one a step, from one factorisation of K.
///
/// No step is rejected: the coefficients determine its length before it is taken, and they are the interpolant within it.
/// Sums are compensated, as in [`Rk4`](super::Rk4). Works are integrated along the polynomials and do not influence the steps.
///
/// # Source
/// Jorba, Zou, Exp. Math. 14 (2005); for constrained motion see [`Series`].
pub(crate) struct Taylor {
    order: usize,
    n_q: usize,
    states: States,
    /// About the start of the step.
    now: SeriesStore<f64>,
    /// About its end, where the next one starts.
    next: SeriesStore<f64>,
    /// Reciprocals of what is tolerated: q, v, then z.
    weights: Vec<f64>,
    rest: State,
    increment: State,
    quadrature: Quadrature,
}

impl Taylor {
    /// Storage for steps of an order, which is at least 4; none for a scene without a Taylor series.
    pub(crate) fn new<S: Scene + ?Sized>(scene: &S, order: usize, n_works: usize) -> Option<Self> {
        let series = scene.series()?;
        let size = series.series_size();
        let (n_q, n_c, n_z) = (size.n_coordinates, size.n_rows, scene.info().n_states());
        let states = States::new(n_z, size);
        Some(Self {
            order,
            n_q,
            states,
            now: SeriesStore::new(size, order + 1),
            next: SeriesStore::new(size, order + 1),
            weights: vec![0.0; 2 * n_q + n_z],
            rest: State::zeros([n_q; 2], n_z, n_works),
            increment: State::zeros([n_q; 2], n_z, n_works),
            quadrature: Quadrature::new(order, [n_q, n_c], states, n_works),
        })
    }

    /// Number of coordinates.
    pub(crate) fn n_coordinates(&self) -> usize {
        self.n_q
    }

    /// Order of a step.
    pub(crate) fn order(&self) -> usize {
        self.order
    }

    /// Writes what rounding cut off, or reads it.
    fn remember(&mut self, archive: &mut Archive) {
        self.rest.remember(archive);
    }

    /// Forgets what rounding cut off, before another run.
    pub(crate) fn restart(&mut self) {
        let State { q, v, z, work, .. } = &mut self.rest;
        [q, v, z, work].into_iter().for_each(|rest| rest.fill(0.0));
    }

    /// The coefficients about the state where the next step starts, with accelerations `a` (`n_q`) and multipliers
    /// `lambda` (`n_c`) there. The present step keeps its own until [`Taylor::accept`].
    ///
    /// # Errors
    /// [`MotionError`] when K is singular.
    /// # Cost
    /// One factorisation, and as many solves and sums of products as the order; no allocation.
    pub(crate) fn expand<P: SceneRef>(
        &mut self,
        system: &mut System<P>,
        from: &State,
        a: &mut [f64],
        lambda: &mut [f64],
    ) -> Result<Solved, MotionError> {
        self.place(from);
        system.place_states(&from.z);
        let scene = system.scene_ref().clone();
        let without = || MotionError::NotFinite { t: from.t, quantity: "the series of a scene without one".into() };
        let series = scene.series().ok_or_else(without)?;
        let mut at = system.at_with(from.t, &from.q, Rows::Projected);
        let solved = match at.begin_series(series, &mut self.next)? {
            Some(smallest) => {
                self.expand_by_elimination(series, at.fixed());
                Solved::regular(smallest)
            }
            None => {
                let mut orders = FactoredOrders { at, first: None };
                expand_with(series, &mut orders, self.order, &mut self.next);
                orders.first.unwrap_or_default()
            }
        };
        self.write_accelerations(a, lambda);
        Ok(solved)
    }

    /// The last expansion: coefficients of q up to `order + 1`, of z up to `order`, of the multipliers up to `order - 1`.
    pub(crate) fn coefficients(&self) -> &SeriesStore<f64> {
        &self.next
    }

    /// Order `k` of the first-order states in the last expansion, `n_z`.
    pub(crate) fn state_coefficients(&self, k: usize) -> &[f64] {
        self.states.of_order(&self.next, k)
    }

    /// The next step begins: it starts at the state that was expanded last.
    pub(crate) fn accept(&mut self) {
        std::mem::swap(&mut self.now, &mut self.next);
    }

    /// The longest step that keeps to a tolerance, s; may be infinite.
    pub(crate) fn longest_step(&mut self, tolerance: Tolerance) -> f64 {
        length::write_weights(&self.now, self.states, tolerance, &mut self.weights);
        length::longest_step(&self.now, self.states, self.order, &self.weights)
    }

    /// Whether the series is the motion: whether its accelerations, and its rates of first-order states, at the end of a step, `h` after its
    /// start, are those of the equations there, `a` (`n_q`) and `rate` (`n_z`), to `most` tolerances of a velocity or a state for each
    /// order over `h`, and `rounding` of the largest. Before [`Taylor::accept`].
    pub(crate) fn follows(&mut self, h: f64, [a, rate]: [&[f64]; 2], most: f64, rounding: f64) -> bool {
        let Self { order, n_q, states, now: store, weights, increment, .. } = self;
        let most = most * (*order + 1) as f64 / h;
        let are_close = |of_equations: &[f64], of_series: &[f64], weights: &[f64]| {
            let size = of_equations.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
            let all = of_equations.iter().zip(of_series).zip(weights);
            all.into_iter().all(|((x, of_series), weight)| (x - *of_series).abs() <= most / weight + rounding * size)
        };
        let (of_v, of_z) = weights[*n_q..].split_at(*n_q);
        second_derivative(store, *order, h, &mut increment.v);
        states.derivative(store, *order, h, &mut increment.z);
        are_close(a, &increment.v, of_v) && are_close(rate, &increment.z, of_z)
    }

    /// A step of length `h` from `from`; writes `to`, not yet projected.
    pub(crate) fn advance<P: SceneRef>(&mut self, system: &mut System<P>, from: &State, h: f64, to: &mut State) {
        self.advance_motion(from, h, to);
        if !to.work.is_empty() {
            let Self { order, now: store, increment: by, rest, quadrature, .. } = self;
            by.work.fill(0.0);
            quadrature.add_works(system, store, *order, from, h, &mut by.work);
            compensated::add_each(&mut to.work, &from.work, &by.work, &mut rest.work);
        }
        to.t = from.t + h;
    }

    /// The state `s` after `from`, not projected, with works up to there.
    pub(crate) fn dense_at<P: SceneRef>(&mut self, system: &mut System<P>, from: &State, s: f64, out: &mut State) {
        self.motion_at(from, s, out);
        out.work.copy_from_slice(&from.work);
        let Self { order, now: store, quadrature, .. } = self;
        quadrature.add_works(system, store, *order, from, s, &mut out.work);
        out.t = from.t + s;
    }
}

/// Code that does not depend on the type of the scene, compiled with this crate so that its calls are inlined.
impl Taylor {
    fn place(&mut self, from: &State) {
        let (q, rest) = self.next.q.split_at_mut(self.n_q);
        q.copy_from_slice(&from.q);
        rest[..self.n_q].copy_from_slice(&from.v);
    }

    fn expand_by_elimination(&mut self, series: &dyn Series<f64>, c: &[f64]) {
        expand(series, c, self.order, &mut self.next);
    }

    fn write_accelerations(&self, a: &mut [f64], lambda: &mut [f64]) {
        a.iter_mut().zip(&self.next.q[2 * self.n_q..]).for_each(|(a, bend)| *a = 2.0 * bend);
        lambda.copy_from_slice(&self.next.lambda[..lambda.len()]);
    }

    fn advance_motion(&mut self, from: &State, h: f64, to: &mut State) {
        let Self { order, states, now: store, increment: by, rest, .. } = self;
        increment(store, *order, h, &mut by.q, &mut by.v);
        states.increment(store, *order, h, &mut by.z);
        compensated::add_each(&mut to.q, &from.q, &by.q, &mut rest.q);
        compensated::add_each(&mut to.v, &from.v, &by.v, &mut rest.v);
        compensated::add_each(&mut to.z, &from.z, &by.z, &mut rest.z);
    }

    fn motion_at(&self, from: &State, s: f64, out: &mut State) {
        increment(&self.now, self.order, s, &mut out.q, &mut out.v);
        self.states.increment(&self.now, self.order, s, &mut out.z);
        out.q.iter_mut().zip(&from.q).for_each(|(q, start)| *q += start);
        out.v.iter_mut().zip(&from.v).for_each(|(v, start)| *v += start);
        out.z.iter_mut().zip(&from.z).for_each(|(z, start)| *z += start);
    }
}

/// All orders by the factors of a configuration.
struct FactoredOrders<'m, P: SceneRef> {
    at: Configuration<'m, P>,
    /// How accelerations were solved for.
    first: Option<Solved>,
}

impl<P: SceneRef> OrderSolver<f64> for FactoredOrders<'_, P> {
    fn fixed(&self) -> &[f64] {
        self.at.fixed()
    }

    fn solve(&mut self, k: usize, store: &mut SeriesStore<f64>) {
        let SeriesStore { lambda, force, row, a, .. } = store;
        let n_c = row.len();
        let solved = self.at.solve(force, row, a, &mut lambda[k * n_c..][..n_c]);
        self.first.get_or_insert(solved);
    }
}
