//! Transfer functions from one input to one output.

use super::error::AnalysisError;
use super::linearization::Linearization;
use super::realization::Realization;
use super::spectrum::Spectrum;
use nalgebra::{Complex, DMatrix};

/// G(s) = cᵀ (s − A)⁻¹ b + d of one input and one output, without the modes that the input does not move or the output does not show.
///
/// Such a mode gives a zero on a pole. The pairs are not looked for among poles and zeros, but taken out before these are computed, so that
/// multiple ones stay sharp.
#[derive(Debug, Clone)]
pub struct Transfer {
    /// Name of the scene.
    pub scene: &'static str,
    /// Name of the input.
    pub input: &'static str,
    /// Name of the output.
    pub output: String,
    /// Poles, 1/s: the eigenvalues of A that are seen.
    pub poles: Spectrum,
    /// Zeros, 1/s: an input exp(z t) gives no output. Those that are zero are told apart, too.
    pub zeros: Spectrum,
    /// k in G(s) ≈ k s^−r for large s, with r the [relative degree](Self::relative_degree); unit of the output over that of the input, s^−r. Zero
    /// where the output does not depend on the input.
    pub gain: f64,
    /// How many eigenvalues of A are no poles.
    pub n_unseen: usize,
    pub(super) realization: Realization,
}

impl Linearization {
    /// The transfer function from an input to an output, by name.
    ///
    /// # Errors
    /// [`AnalysisError::Unknown`] with the names that there are, [`AnalysisError::NoEigenvalues`].
    ///
    /// # Cost
    /// O(n³).
    pub fn transfer(&self, input: &str, output: &str) -> Result<Transfer, AnalysisError> {
        let outputs: Vec<&str> = self.info().outputs.iter().map(|output| &*output.name).collect();
        let i_in = self.place("input", input, &self.inputs, "`input push: N = 0;`")?;
        let i_out = self.place("output", output, &outputs, "`output place: m = BODY.x;`")?;
        let full = Realization {
            a: self.a.clone(),
            b: self.b.column(i_in).into_owned(),
            c: self.c.row(i_out).transpose(),
            d: self.d[(i_out, i_in)],
        };
        let fault = || AnalysisError::NoEigenvalues { scene: self.info().name };
        let is_finite = |x: &f64| x.is_finite();
        if !(full.a.iter().chain(&full.b).chain(&full.c).all(is_finite) && full.d.is_finite()) {
            return Err(fault());
        }
        let realization = full.minimal();
        let poles = Spectrum::of(&realization.a).ok_or_else(fault)?;
        let (gain, matrix) = match realization.zero_dynamics() {
            Some(zeros) => (zeros.gain, zeros.matrix),
            None => (0.0, DMatrix::zeros(0, 0)),
        };
        let zeros = Spectrum::of(&matrix).ok_or_else(fault)?;
        let n_unseen = self.a.nrows() - realization.a.nrows();
        let (scene, input, output) = (self.info().name, self.inputs[i_in], output.to_owned());
        Ok(Transfer { scene, input, output, poles, zeros, gain, n_unseen, realization })
    }

    fn place(&self, kind: &'static str, name: &str, known: &[&str], such_as: &str) -> Result<usize, AnalysisError> {
        known.iter().position(|known| *known == name).ok_or_else(|| AnalysisError::Unknown {
            scene: self.info().name,
            kind,
            name: name.to_owned(),
            known: match known {
                [] => format!("no {kind} that forces use; declare one in the model, such as {such_as}"),
                known => known.join(", "),
            },
        })
    }
}

impl Transfer {
    /// G(s), in the unit of the output over that of the input; none where s is a pole.
    ///
    /// # Cost
    /// O(n²).
    pub fn at(&self, s: Complex<f64>) -> Option<Complex<f64>> {
        self.realization.at(s)
    }

    /// G(iω), with ω in rad/s.
    pub fn at_frequency(&self, omega: f64) -> Option<Complex<f64>> {
        self.at(Complex::new(0.0, omega))
    }

    /// r in G(s) ≈ k s^−r: how many times the output has to be differentiated before the input shows in it.
    pub fn relative_degree(&self) -> usize {
        let [n_poles, n_zeros] = [&self.poles, &self.zeros].map(|of| of.eigenvalues.len() + of.n_zero);
        n_poles.saturating_sub(n_zeros)
    }

    /// G(0), by which a constant input moves the output where all poles are stable; none where zero is a pole.
    pub fn static_gain(&self) -> Option<f64> {
        match (self.poles.n_zero, self.zeros.n_zero) {
            (0, 0) => self.at(Complex::new(0.0, 0.0)).map(|g| g.re),
            (0, _) => Some(0.0),
            _ => None,
        }
    }

    /// d ln G(iω)/dω: of its magnitude the real part, of its phase the imaginary one, s.
    pub(super) fn logarithmic_slope(&self, omega: f64) -> Complex<f64> {
        let s = Complex::new(0.0, omega);
        let sum = |of: &Spectrum| -> Complex<f64> {
            of.eigenvalues.iter().map(|z| (s - z).inv()).sum::<Complex<f64>>() + s.inv() * of.n_zero as f64
        };
        Complex::<f64>::i() * (sum(&self.zeros) - sum(&self.poles))
    }
}
