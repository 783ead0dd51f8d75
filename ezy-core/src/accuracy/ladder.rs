//! The settings of the methods that are compared.

use crate::integrate::Method;

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

/// A method and its settings.
pub(super) struct Family {
    pub name: &'static str,
    pub rungs: fn(&Ladder, f64) -> Vec<Method>,
    /// Order of the method, if it has a fixed one: computing time is proportional to the error to the power −1/order.
    #[cfg(feature = "figures")]
    pub order: Option<u32>,
}

/// Every method. `rungs` is called with the ladder and a long step of the motion, s.
pub(super) const FAMILIES: [Family; 5] = [
    Family {
        name: "taylor",
        rungs: |ladder, _| with_tolerances(ladder, Method::taylor),
        #[cfg(feature = "figures")]
        order: None,
    },
    Family {
        name: "dop853",
        rungs: |ladder, _| with_tolerances(ladder, Method::dop853),
        #[cfg(feature = "figures")]
        order: Some(8),
    },
    Family {
        name: "gauss",
        rungs: |ladder, _| with_tolerances(ladder, Method::gauss),
        #[cfg(feature = "figures")]
        order: None,
    },
    Family {
        name: "radau",
        rungs: |ladder, _| with_tolerances(ladder, Method::radau),
        #[cfg(feature = "figures")]
        order: Some(5),
    },
    Family {
        name: "rk4",
        rungs: |ladder, long_s| with_steps(ladder, long_s, Method::rk4),
        #[cfg(feature = "figures")]
        order: Some(4),
    },
];

fn with_tolerances(ladder: &Ladder, method: fn(f64) -> Method) -> Vec<Method> {
    ladder.tolerances.iter().map(|&tolerance| method(tolerance)).collect()
}

fn with_steps(ladder: &Ladder, long_s: f64, method: fn(f64) -> Method) -> Vec<Method> {
    one_two_five(long_s).take(ladder.n_steps).map(method).collect()
}

/// The numbers 1, 2 and 5 times powers of ten from `largest` down.
fn one_two_five(largest: f64) -> impl Iterator<Item = f64> {
    let decade = largest.log10().floor() as i32;
    let all = (0..).flat_map(move |k| [5, 2, 1].map(|digit| format!("{digit}e{}", decade - k)));
    all.filter_map(|text| text.parse().ok()).skip_while(move |step: &f64| *step > largest * (1.0 + 1e-9))
}

/// The step of a method with a fixed step, s, or the relative tolerance of one that chooses its steps.
pub(crate) fn setting(method: Method) -> f64 {
    match method {
        Method::Rk4 { step_s } => step_s,
        Method::Dop853(tolerance) | Method::Taylor(tolerance) | Method::Gauss(tolerance) | Method::Radau(tolerance) => {
            tolerance.relative
        }
    }
}

/// The method's setting as an option of the command line: `--step 0.001`, `--rtol 1e-9`.
pub(super) fn command(method: Method) -> String {
    match method {
        Method::Rk4 { step_s } => format!("--step {}", number(step_s)),
        _ => format!("--rtol {}", number(setting(method))),
    }
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
        for family in FAMILIES {
            let rungs = (family.rungs)(&Ladder::default(), 0.07);
            let settings: Vec<f64> = rungs.into_iter().map(setting).collect();
            assert!(settings.windows(2).all(|pair| pair[1] < pair[0]), "{}: {settings:?}", family.name);
        }
    }
}
