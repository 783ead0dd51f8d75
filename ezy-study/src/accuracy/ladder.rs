//! The settings of the methods that are compared.

use ezy_core::integrate::{Method, MethodKind, Tolerance};

/// Tolerances and steps, from coarse to fine.
#[derive(Debug, Clone, PartialEq)]
pub struct Ladder {
    /// Relative and absolute tolerances of methods that choose their steps.
    pub tolerances: Vec<f64>,
    /// Number of fixed steps, about 2.2 times shorter each.
    pub n_steps: usize,
}

/// From 1e-4 to 1e-15 in half decades.
const N_TOLERANCES: i32 = 23;
/// Four decades: sixteen of the error of a method of order four.
const N_STEPS: usize = 13;

impl Default for Ladder {
    fn default() -> Self {
        Self { tolerances: (0..N_TOLERANCES).map(half_decade).collect(), n_steps: N_STEPS }
    }
}

/// 10^-(4 + m/2) to two digits: 1e-4, 3.2e-5, 1e-5, …
fn half_decade(m: i32) -> f64 {
    let text = if m % 2 == 0 { format!("1e-{}", 4 + m / 2) } else { format!("3.2e-{}", 5 + m / 2) };
    text.parse().unwrap_or(f64::NAN)
}

impl Ladder {
    /// The method with each of its settings, from coarse to fine. `long_s` is a long step of the motion, s.
    pub(super) fn rungs(&self, kind: MethodKind, long_s: f64) -> Vec<Method> {
        if kind.info().chooses_steps {
            let tolerances = self.tolerances.iter().map(|&tolerance| Tolerance::new(tolerance, tolerance));
            return tolerances.filter_map(|tolerance| kind.with_tolerance(tolerance)).collect();
        }
        one_two_five(long_s).take(self.n_steps).filter_map(|step_s| kind.with_step(step_s)).collect()
    }
}

/// The numbers 1, 2 and 5 times powers of ten from `largest` down.
fn one_two_five(largest: f64) -> impl Iterator<Item = f64> {
    let decade = largest.log10().floor() as i32;
    let all = (0..).flat_map(move |k| [5, 2, 1].map(|digit| format!("{digit}e{}", decade - k)));
    all.filter_map(|text| text.parse().ok()).skip_while(move |step: &f64| *step > largest * (1.0 + 1e-9))
}

/// The method's setting as an option of the command line: `--step 0.001`, `--rtol 1e-9`.
pub(super) fn command(method: Method) -> String {
    let option = if method.info().chooses_steps { "--rtol" } else { "--step" };
    format!("{option} {}", number(method.setting()))
}

/// A setting with the digits it was made with: `0.001`, `1e-9`, `3.2e-7`.
fn number(value: f64) -> String {
    if (1e-3..1e4).contains(&value) { format!("{value}") } else { format!("{value:e}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_ladder_is_half_decades_and_one_two_five() {
        let ladder = Ladder::default();
        assert_eq!(ladder.tolerances[..3], [1e-4, 3.2e-5, 1e-5]);
        assert_eq!(ladder.tolerances.last(), Some(&1e-15));
        let steps: Vec<f64> = one_two_five(0.3).take(5).collect();
        assert_eq!(steps, [0.2, 0.1, 0.05, 0.02, 0.01]);
        assert_eq!(one_two_five(0.05).next(), Some(0.05));
    }

    #[test]
    fn invariant_rungs_get_finer() {
        for kind in MethodKind::ALL {
            let settings: Vec<f64> = Ladder::default().rungs(*kind, 0.07).into_iter().map(Method::setting).collect();
            let n = if kind.info().chooses_steps { N_TOLERANCES as usize } else { N_STEPS };
            assert!(settings.len() == n && settings.windows(2).all(|pair| pair[1] < pair[0]), "{kind:?}: {settings:?}");
        }
    }
}
