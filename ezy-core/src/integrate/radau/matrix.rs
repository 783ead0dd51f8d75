//! The factored matrices of the simplified Newton iteration.

use super::entries::Entries;
use super::factors::Factors;
use super::tableau::{ALPHA, BETA, GAMMA};
use crate::archive::Archive;
use crate::dynamics::{Jacobians, ResidualPlaces, State};
use crate::linalg::SparseKktError;
use crate::model::SceneInfo;
use nalgebra::Complex;

/// `N(μ) = [K 0; 0 1] − [R_v/μ + R_q/μ² | 0 | R_z/μ]`, factored for the real and one of the complex eigenvalues μ of A⁻¹/h.
pub(super) struct Matrices {
    entries: Entries,
    real: Factors<f64>,
    complex: Factors<Complex<f64>>,
    /// h of the factors, s; none before the first.
    step_s: Option<f64>,
    /// Whether the determinant of K was negative when it was last asked for.
    negative_at_rest: Option<bool>,
    has_regular_k: bool,
}

impl Matrices {
    /// Storage for the matrices of a scene.
    ///
    /// # Errors
    /// [`SparseKktError`] when there is no memory for an analysis.
    pub(super) fn new(info: &SceneInfo, jacobians: &ResidualPlaces) -> Result<Self, SparseKktError> {
        let entries = Entries::new(info, jacobians);
        let (real, complex) = (entries.factors()?, entries.factors()?);
        Ok(Self { entries, real, complex, step_s: None, negative_at_rest: None, has_regular_k: true })
    }

    /// Writes for which steps they are factored, or reads it and factors them; then they hold M, G and the Jacobians.
    pub(super) fn remember(&mut self, archive: &mut Archive) {
        let mut step_s = self.step_s;
        archive.option(&mut step_s);
        if let Some(h) = step_s.filter(|_| archive.is_read()) {
            self.factor(h);
        }
        let mut negative = [self.negative_at_rest.is_some(), self.negative_at_rest == Some(true)];
        negative.iter_mut().for_each(|flag| archive.flag(flag));
        self.negative_at_rest = negative[0].then_some(negative[1]);
        archive.flag(&mut self.has_regular_k);
    }

    /// h of the factors, s.
    pub(super) fn step_s(&self) -> Option<f64> {
        self.step_s
    }

    /// Takes M, G and the Jacobians at one state; what was factored is forgotten.
    pub(super) fn write(&mut self, mass: &[f64], jacobians: &Jacobians) {
        self.entries.write(mass, jacobians);
        self.step_s = None;
    }

    /// Factors for steps of length `h`; false when a matrix is singular, or where a mode grows so fast that the step would damp it.
    ///
    /// N(μ) is singular where μ is an eigenvalue of the linearised motion, and K for an infinite one. Determinants of different signs tell that an odd
    /// number of real eigenvalues is larger than μ: such modes grow by more than e^3.6 in a step, and the method, which damps what its steps do
    /// not resolve, would lose them.
    pub(super) fn factor(&mut self, h: f64) -> bool {
        self.entries.scale(GAMMA / h);
        self.entries.assemble(GAMMA / h, &mut self.real);
        self.entries.assemble(Complex::new(ALPHA, BETA) / h, &mut self.complex);
        let regular = self.real.factor() && self.loses_no_growth(h) && self.complex.factor();
        self.step_s = regular.then_some(h);
        regular
    }

    /// Compares signs of determinants; the real factors are those for steps of length `h`, before and after. Where coordinates without mass leave K
    /// singular nothing is compared.
    fn loses_no_growth(&mut self, h: f64) -> bool {
        let negative = self.real.has_negative_determinant();
        if negative == self.negative_at_rest || !self.has_regular_k {
            return true;
        }
        self.entries.assemble(f64::INFINITY, &mut self.real);
        self.has_regular_k = self.real.factor();
        self.negative_at_rest = self.real.has_negative_determinant();
        self.entries.assemble(GAMMA / h, &mut self.real);
        self.real.factor() && (negative == self.negative_at_rest || !self.has_regular_k)
    }

    /// Factors for [`Matrices::filter`] alone; false when the matrix is singular.
    pub(super) fn factor_real(&mut self, h: f64) -> bool {
        self.entries.scale(GAMMA / h);
        self.entries.assemble(GAMMA / h, &mut self.real);
        self.real.factor()
    }

    /// As [`Entries::rounding_along`].
    pub(super) fn rounding_along(&self, at: &State, unknowns: [&[f64]; 3], out: &mut [f64]) {
        self.entries.rounding_along(at, unknowns, out);
    }

    /// As [`Entries::slope_along`].
    pub(super) fn slope_along(&self, of: &State, out: &mut [f64]) {
        self.entries.slope_along(of, out);
    }

    /// Solves with the real eigenvalue, in place.
    pub(super) fn solve_real(&mut self, x: &mut [f64]) {
        self.entries.solve(&mut self.real, x);
    }

    /// Solves with the complex eigenvalue, in place.
    pub(super) fn solve_complex(&mut self, x: &mut [Complex<f64>]) {
        self.entries.solve(&mut self.complex, x);
    }

    /// `(μ − J)⁻¹ [q; v; z]` in place for the real eigenvalue μ of steps of length `h`, where J are the Jacobians of (v, a, z');
    /// `solution` (`n_q + n_c + n_z`) is overwritten.
    pub(super) fn filter(&mut self, h: f64, of: &mut State, solution: &mut [f64]) {
        let mu = GAMMA / h;
        // with α = μ dv − v, ω = μ dz − z and μ dq = dv + q: N [α; ω] = R_v v/μ + R_q (v/μ + q)/μ + R_z z/μ
        of.v.iter_mut().chain(&mut of.z).for_each(|x| *x /= mu);
        of.q.iter_mut().zip(&of.v).for_each(|(q, v)| *q = (*q + v) / mu);
        self.entries.slope_along(of, solution);
        self.solve_real(solution);
        for ((q, v), alpha) in of.q.iter_mut().zip(&mut of.v).zip(&*solution) {
            *v += *alpha / mu;
            *q += *alpha / (mu * mu);
        }
        let omega = &solution[solution.len() - of.z.len()..];
        of.z.iter_mut().zip(omega).for_each(|(z, omega)| *z += *omega / mu);
    }
}
