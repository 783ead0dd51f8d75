//! Which method and which setting to use.

use std::fmt;

use super::ladder::command;
use ezy_core::integrate::Method;

/// Errors that advice is given for: largest error of a position over the run, m or rad.
pub(super) const TARGETS: [f64; 4] = [1e-3, 1e-6, 1e-9, 1e-12];

/// A setting that may be recommended.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Candidate {
    /// The method with its setting.
    pub method: Method,
    /// Its error, m or rad.
    pub error: f64,
    /// Its time, s.
    pub seconds: f64,
}

/// One sentence for one target; printed by `Display`.
#[derive(Debug, Clone, PartialEq)]
pub struct Advice {
    /// Error that is allowed, m or rad.
    pub target: f64,
    /// Uncertainty of the reference, m or rad.
    pub known: f64,
    /// The fastest setting that reaches it.
    pub best: Option<Candidate>,
    /// The fastest setting of each other method that reaches it, fastest first.
    pub others: Vec<Candidate>,
    /// The setting with the smallest error, when none reaches it.
    pub closest: Option<Candidate>,
    /// Methods that are not known to reach it, but whose settings were not all run for lack of time.
    pub unfinished: Vec<&'static str>,
}

/// Number of finer settings that must reach a target, too.
const N_CONFIRMING: usize = 3;

/// Chooses for one target. A setting counts only when the next finer measured ones reach the target, too, since a loose
/// setting may be accurate by chance. `unfinished` are the methods whose settings were not all run.
pub(super) fn advise(target: f64, known: f64, candidates: &[Candidate], unfinished: &[&'static str]) -> Advice {
    let mut names: Vec<&str> = candidates.iter().map(|c| c.method.name()).collect();
    names.sort_unstable();
    names.dedup();
    let mut fastest: Vec<Candidate> = names.iter().filter_map(|name| fastest_of(name, target, candidates)).collect();
    fastest.sort_by(|a, b| a.seconds.total_cmp(&b.seconds));
    let reaches = |name: &str| fastest.iter().any(|candidate| candidate.method.name() == name);
    let unfinished = unfinished.iter().copied().filter(|name| !reaches(name)).collect();
    let mut reaching = fastest.into_iter();
    let best = reaching.next();
    let closest = match best {
        Some(_) => None,
        None => candidates.iter().copied().min_by(|a, b| a.error.total_cmp(&b.error)),
    };
    Advice { target, known, best, others: reaching.collect(), closest, unfinished }
}

fn fastest_of(name: &str, target: f64, candidates: &[Candidate]) -> Option<Candidate> {
    let mut rungs: Vec<Candidate> = candidates.iter().copied().filter(|c| c.method.name() == name).collect();
    rungs.sort_by(|a, b| b.method.setting().total_cmp(&a.method.setting()));
    let reached = |i: usize| rungs.get(i).is_none_or(|c| c.error <= target);
    let reliable = (0..rungs.len()).filter(|&i| (i..=i + N_CONFIRMING).all(reached));
    reliable.map(|i| rungs[i]).min_by(|a, b| a.seconds.total_cmp(&b.seconds))
}

impl fmt::Display for Advice {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Positions to {:e} (m, rad) throughout: ", self.target)?;
        match (self.best, self.closest) {
            (Some(best), _) => self.write_choice(f, best)?,
            (None, Some(_)) if self.known > self.target => {
                write!(f, "not known, since the reference itself is only known to {:.1e}", self.known)?;
            }
            (None, Some(closest)) => write!(
                f,
                "no measured setting reaches this; {} {} comes closest with {:.1e} in {}",
                closest.method.name(),
                command(closest.method),
                closest.error,
                duration(closest.seconds)
            )?,
            (None, None) => f.write_str("nothing was measured")?,
        }
        if !self.unfinished.is_empty() {
            write!(f, "; finer settings of {} were not run", self.unfinished.join(", "))?;
        }
        f.write_str(".")
    }
}

impl Advice {
    fn write_choice(&self, f: &mut fmt::Formatter<'_>, best: Candidate) -> fmt::Result {
        let (name, setting, time) = (best.method.name(), command(best.method), duration(best.seconds));
        write!(f, "use {name} {setting}; a run takes {time} and is off by {:.1e} at most", best.error)?;
        for other in &self.others {
            let (name, setting, ratio) = (other.method.name(), command(other.method), other.seconds / best.seconds);
            write!(f, "; {name} {setting} takes {ratio:.1} times as long")?;
        }
        Ok(())
    }
}

/// A length of time with three digits: `0.312 ms`, `31.0 µs`, `1.25 s`.
pub(super) fn duration(seconds: f64) -> String {
    match seconds {
        s if s < 1e-4 => format!("{} µs", three_digits(1e6 * s)),
        s if s < 1.0 => format!("{} ms", three_digits(1e3 * s)),
        s => format!("{} s", three_digits(s)),
    }
}

pub(super) fn three_digits(x: f64) -> String {
    let decimals = match x {
        x if x < 1.0 => 3,
        x if x < 10.0 => 2,
        x if x < 100.0 => 1,
        _ => 0,
    };
    format!("{x:.decimals$}")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn dop853(tolerance: f64, error: f64, seconds: f64) -> Candidate {
        Candidate { method: Method::dop853(tolerance), error, seconds }
    }

    fn rk4(step_s: f64, error: f64, seconds: f64) -> Candidate {
        Candidate { method: Method::rk4(step_s), error, seconds }
    }

    #[test]
    fn analytic_advice_is_the_fastest_setting_that_reaches_the_target() {
        let all = [
            dop853(1e-4, 2e-3, 1e-4),
            dop853(1e-6, 5e-7, 2e-4),
            dop853(1e-8, 4e-9, 3e-4),
            rk4(0.01, 8e-7, 5e-4),
            rk4(0.005, 5e-8, 1e-3),
        ];
        let advice = advise(1e-6, 1e-13, &all, &[]);
        assert_eq!((advice.best, &advice.others[..]), (Some(all[1]), &[all[3]][..]));
        let sentence = advice.to_string();
        assert_eq!(
            sentence,
            "Positions to 1e-6 (m, rad) throughout: use dop853 --rtol 1e-6; a run takes 0.200 ms and is off by 5.0e-7 at most; \
             rk4 --step 0.01 takes 2.5 times as long."
        );
    }

    #[test]
    fn analytic_advice_passes_over_a_setting_that_is_only_lucky() {
        let all = [rk4(0.1, 1e-7, 1e-4), rk4(0.05, 1e-5, 2e-4), rk4(0.02, 3e-7, 5e-4), rk4(0.01, 2e-8, 1e-3)];
        assert_eq!(advise(1e-6, 0.0, &all, &[]).best, Some(all[2]));
        let twice = [rk4(0.1, 1e-7, 1e-4), rk4(0.05, 1e-7, 2e-4), rk4(0.02, 1e-5, 5e-4), rk4(0.01, 2e-8, 1e-3)];
        assert_eq!(advise(1e-6, 0.0, &twice, &[]).best, Some(twice[3]));
    }

    #[test]
    fn analytic_advice_says_what_comes_closest_where_nothing_reaches_the_target() {
        let all = [dop853(1e-4, 2e-3, 1e-4), dop853(1e-14, 3e-11, 2e-3)];
        let advice = advise(1e-12, 1e-13, &all, &[]);
        assert_eq!((advice.best, advice.closest), (None, Some(all[1])));
        assert!(advice.to_string().contains("dop853 --rtol 1e-14 comes closest with 3.0e-11 in 2.00 ms"), "{advice}");
    }

    #[test]
    fn analytic_advice_says_where_the_reference_knows_too_little() {
        let advice = advise(1e-12, 1e-9, &[dop853(1e-14, 1e-9, 1e-3)], &[]);
        assert!(advice.to_string().contains("only known to 1.0e-9"), "{advice}");
        assert!(advise(1e-3, 0.0, &[], &[]).to_string().contains("nothing was measured"));
    }

    #[test]
    fn analytic_advice_names_the_methods_that_were_not_run_far_enough() {
        let all = [dop853(1e-6, 5e-7, 2e-4), dop853(1e-8, 4e-9, 3e-4), rk4(0.1, 1e-4, 1e-3)];
        let advice = advise(1e-6, 0.0, &all, &["dop853", "rk4"]);
        assert_eq!(advice.unfinished, ["rk4"]);
        assert!(advice.to_string().ends_with("5.0e-7 at most; finer settings of rk4 were not run."), "{advice}");
    }

    #[test]
    fn analytic_durations_have_three_digits() {
        assert_eq!(
            [3.3e-8, 4.2e-5, 3.12e-4, 0.0331, 0.5, 2.0].map(duration),
            ["0.033 µs", "42.0 µs", "0.312 ms", "33.1 ms", "500 ms", "2.00 s"]
        );
    }
}
