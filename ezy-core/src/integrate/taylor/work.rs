//! Works over a step, from powers along its polynomials.

use super::expansion::increment;
use super::states::States;
use crate::dynamics::{State, System};
use crate::integrate::tolerances::taylor::NODE_PASSES;
use crate::model::{SceneRef, SeriesStore};

/// Gauss's formula with nodes in (0, 1).
///
/// # Source
/// Nodes by Newton's method from the estimate of Abramowitz, Stegun (1964), 22.16.6; weights: 25.4.29.
#[derive(Debug)]
pub(super) struct Quadrature {
    nodes: Vec<(f64, f64)>,
    states: States,
    at: State,
    lambda: Vec<f64>,
}

impl Quadrature {
    /// Exact for polynomials of degree `degree`.
    pub(super) fn new(degree: usize, [n_q, n_c]: [usize; 2], states: States, n_works: usize) -> Self {
        let n = degree / 2 + 1;
        let nodes = if n_works == 0 { Vec::new() } else { (0..n).map(|i| node(n, i)).collect() };
        Self { nodes, states, at: State::zeros([n_q; 2], states.count(), n_works), lambda: vec![0.0; n_c] }
    }

    /// Adds to `work` what each power does over `h` from the state `from`.
    pub(super) fn add_works<P: SceneRef>(
        &mut self,
        system: &mut System<P>,
        store: &SeriesStore<f64>,
        order: usize,
        from: &State,
        h: f64,
        work: &mut [f64],
    ) {
        let Self { nodes, states, at, lambda } = self;
        for (node, weight) in nodes {
            let s = *node * h;
            increment(store, order, s, &mut at.q, &mut at.v);
            at.q.iter_mut().zip(&from.q).for_each(|(q, start)| *q += start);
            at.v.iter_mut().zip(&from.v).for_each(|(v, start)| *v += start);
            states.increment(store, order, s, &mut at.z);
            at.z.iter_mut().zip(&from.z).for_each(|(z, start)| *z += start);
            system.place_states(&at.z);
            multipliers(store, order, s, lambda);
            system.power(from.t + s, &at.q, &at.v, lambda, &mut at.work);
            work.iter_mut().zip(&at.work).for_each(|(work, power)| *work += h * *weight * power);
        }
    }
}

fn multipliers(store: &SeriesStore<f64>, order: usize, s: f64, lambda: &mut [f64]) {
    let n_c = lambda.len();
    lambda.fill(0.0);
    for k in (0..order).rev() {
        lambda.iter_mut().zip(&store.lambda[k * n_c..]).for_each(|(sum, x)| *sum = *sum * s + x);
    }
}

/// Node `i` of `n` and its weight.
fn node(n: usize, i: usize) -> (f64, f64) {
    let mut x = (std::f64::consts::PI * (i as f64 + 0.75) / (n as f64 + 0.5)).cos();
    let mut slope = 1.0;
    for _ in 0..NODE_PASSES {
        let (value, previous) = legendre(n, x);
        slope = n as f64 * (x * value - previous) / (x * x - 1.0);
        x -= value / slope;
    }
    (0.5 * (1.0 + x), 1.0 / ((1.0 - x * x) * slope * slope))
}

/// P_n and P_{n−1}.
fn legendre(n: usize, x: f64) -> (f64, f64) {
    let (mut value, mut previous) = (1.0, 0.0);
    for k in 0..n {
        let k = k as f64;
        (value, previous) = (((2.0 * k + 1.0) * x * value - k * previous) / (k + 1.0), value);
    }
    (value, previous)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::series::SeriesSize;

    const SIZE: SeriesSize = SeriesSize { n_coordinates: 0, n_rows: 2, n_products: 0, n_base: 0, n_kept: 0 };
    const NONE: States = States::new(0, SIZE);

    /// Nodes and weights integrate t^d over (0, 1) for all degrees d up to 2 n − 1, and not for 2 n.
    #[test]
    fn analytic_gauss_nodes_are_exact_to_their_degree() {
        for n in 1..=13 {
            let nodes: Vec<(f64, f64)> = (0..n).map(|i| node(n, i)).collect();
            let error = |degree: usize| {
                let sum: f64 = nodes.iter().map(|(x, weight)| weight * x.powi(degree as i32)).sum();
                (sum - 1.0 / (degree + 1) as f64).abs()
            };
            assert!((0..2 * n).all(|degree| error(degree) <= 1e-14), "{n}");
            assert!(n > 6 || error(2 * n) >= 1e-8, "{n}");
        }
    }

    /// A polynomial of degree d takes d/2 + 1 nodes, and none without works.
    #[test]
    fn regress_number_of_nodes() {
        for (degree, n) in [(6, 4), (7, 4), (24, 13)] {
            assert_eq!(Quadrature::new(degree, [3, 0], NONE, 1).nodes.len(), n);
            assert!(Quadrature::new(degree, [3, 0], NONE, 0).nodes.is_empty());
        }
    }

    /// Multipliers 1 + 2 s + 3 s² and −4 + s².
    #[test]
    fn analytic_multipliers_are_sums_of_their_coefficients() {
        let mut store = SeriesStore::<f64>::new(SIZE, 2);
        store.lambda = vec![1.0, -4.0, 2.0, 0.0, 3.0, 1.0];
        let mut lambda = [9.0; 2];
        multipliers(&store, 3, 0.5, &mut lambda);
        assert_eq!(lambda, [1.0 + 1.0 + 0.75, -3.75]);
        multipliers(&store, 2, 0.5, &mut lambda);
        assert_eq!(lambda, [2.0, -4.0]);
    }
}
