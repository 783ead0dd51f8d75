//! The equations as an integrator wants them, in two ways: by hand and by EZY.

use ezy_core::model::Scene;
use nalgebra::{Const, DimMin, SMatrix, SVector};
use std::sync::atomic::{AtomicU64, Ordering};

/// Coordinates of two bodies: all scenes here have two.
pub const N_Q: usize = 6;

/// Coordinates, then velocities.
pub type State = [f64; 2 * N_Q];

/// The accelerations at one state.
pub trait RightSide: Sync {
    fn accelerations(&self, t: f64, q: &[f64; N_Q], v: &[f64; N_Q]) -> [f64; N_Q];

    /// `y' = (v, a)` for `y = (q, v)`, both [`State`]s.
    #[inline(always)]
    fn slope(&self, t: f64, y: &[f64], slope: &mut [f64]) {
        let (q, v) = (array(&y[..N_Q]), array(&y[N_Q..2 * N_Q]));
        slope[..N_Q].copy_from_slice(v);
        slope[N_Q..2 * N_Q].copy_from_slice(&self.accelerations(t, q, v));
    }
}

fn array(part: &[f64]) -> &[f64; N_Q] {
    part.try_into().expect("half a state")
}

/// What is written without EZY: M, G, F and the convective term worked out on paper, K solved by LU with pivoting.
pub struct ByHand<const C: usize> {
    pub mass: [f64; N_Q],
    pub equations: fn(f64, &[f64; N_Q], &[f64; N_Q]) -> Equations<C>,
}

/// `M a + Gᵀ λ = F` and `G a = −h` at one state, with `C` rows.
pub struct Equations<const C: usize> {
    pub jacobian: [[f64; N_Q]; C],
    pub force: [f64; N_Q],
    pub convective: [f64; C],
}

impl RightSide for ByHand<4> {
    #[inline]
    fn accelerations(&self, t: f64, q: &[f64; N_Q], v: &[f64; N_Q]) -> [f64; N_Q] {
        solve::<4, 10>(&self.mass, &(self.equations)(t, q, v))
    }
}

impl RightSide for ByHand<5> {
    #[inline]
    fn accelerations(&self, t: f64, q: &[f64; N_Q], v: &[f64; N_Q]) -> [f64; N_Q] {
        solve::<5, 11>(&self.mass, &(self.equations)(t, q, v))
    }
}

/// K on the stack, its size known to the compiler.
#[inline]
pub fn solve<const C: usize, const N: usize>(mass: &[f64; N_Q], equations: &Equations<C>) -> [f64; N_Q]
where
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
{
    let mut k = SMatrix::<f64, N, N>::zeros();
    let mut x = SVector::<f64, N>::zeros();
    for i in 0..N_Q {
        k[(i, i)] = mass[i];
        x[i] = equations.force[i];
    }
    for (r, row) in equations.jacobian.iter().enumerate() {
        for (i, g) in row.iter().enumerate() {
            k[(N_Q + r, i)] = *g;
            k[(i, N_Q + r)] = *g;
        }
        x[N_Q + r] = -equations.convective[r];
    }
    // of a singular K nothing is left to compare: the run then shows NaN
    let regular = k.lu().solve_mut(&mut x);
    std::array::from_fn(|i| if regular { x[i] } else { f64::NAN })
}

/// What EZY derives from the model file.
pub struct Generated<'s, S: Scene> {
    scene: &'s S,
    constants: Vec<f64>,
    n_rows: usize,
}

/// Rows of the scenes here, at most.
const MAX_ROWS: usize = 5;

impl<'s, S: Scene> Generated<'s, S> {
    pub fn new(scene: &'s S) -> Self {
        let mut constants = vec![0.0; scene.info().n_fixed()];
        let parameters: Vec<f64> = (0..scene.info().parameters.len()).map(|i| scene.parameter(i)).collect();
        scene.constants(&parameters, &mut constants);
        Self { scene, constants, n_rows: scene.info().n_rows() }
    }
}

impl<S: Scene> RightSide for Generated<'_, S> {
    #[inline]
    fn accelerations(&self, t: f64, q: &[f64; N_Q], v: &[f64; N_Q]) -> [f64; N_Q] {
        let (mut a, mut lambda) = ([0.0; N_Q], [0.0; MAX_ROWS]);
        self.scene.accelerations(&self.constants, t, q, v, &mut a, &mut lambda[..self.n_rows]);
        a
    }
}

/// Counts evaluations of another right side; for runs that are not timed.
pub struct Counted<'r, R> {
    right_side: &'r R,
    n: AtomicU64,
}

impl<'r, R> Counted<'r, R> {
    pub fn new(right_side: &'r R) -> Self {
        Self { right_side, n: AtomicU64::new(0) }
    }

    pub fn n(&self) -> u64 {
        self.n.load(Ordering::Relaxed)
    }
}

impl<R: RightSide> RightSide for Counted<'_, R> {
    fn accelerations(&self, t: f64, q: &[f64; N_Q], v: &[f64; N_Q]) -> [f64; N_Q] {
        self.n.fetch_add(1, Ordering::Relaxed);
        self.right_side.accelerations(t, q, v)
    }
}
