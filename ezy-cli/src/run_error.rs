//! The estimated error of a run, as JSON, as text and as a line of CSV.

use serde_json::{Value, json};

use ezy_core::integrate::{Method, Tolerance};
use ezy_core::scalar::rounded;
use ezy_core::simulate::{ErrorEstimate, NoErrorEstimate, QuantityError, Run};
use ezy_study::report::table::{Table, fixed};

/// An estimate, or why there is none.
pub(super) type Estimate = Result<ErrorEstimate, NoErrorEstimate>;

/// A motion that makes errors larger than this is remarked on: three digits of its start are lost.
const LARGEST_AMPLIFICATION: f64 = 1e3;

/// The estimate as JSON; of a run without one the reason.
pub(super) fn error_json(estimate: &Estimate) -> Value {
    match estimate {
        Ok(ErrorEstimate { errors, amplification, second, .. }) => json!({
            "second": { "method": second.name(), "setting": setting(*second) },
            "amplification": amplification,
            "errors": errors.iter().map(|QuantityError { quantity, unit, at_end, largest, t, .. }| {
                json!({ "quantity": quantity, "unit": unit, "at_end": at_end, "largest": largest, "t": t })
            }).collect::<Vec<_>>(),
        }),
        Err(why) => json!({ "unknown": why.to_string() }),
    }
}

/// The estimate as a table.
pub(super) fn error_text(run: &Run) -> String {
    match &run.error_estimate {
        None => String::new(),
        Some(Err(why)) => format!("the error is not known: {why}\n"),
        Some(Ok(ErrorEstimate { errors, second, .. })) => {
            let mut table = Table::new(["estimated error", "at the end", "largest", "unit", "t [s]"]);
            for QuantityError { quantity, unit, at_end, largest, t, .. } in errors {
                table.push([*quantity, &format!("{at_end:.1e}"), &format!("{largest:.1e}"), unit, &fixed(*t, 6)]);
            }
            format!("\n{table}from a second run with --method {} {}\n", second.name(), setting(*second))
        }
    }
}

/// The remark on a motion that amplifies errors.
pub(super) fn error_remark(run: &Run) -> String {
    match run.error_estimate.as_ref().and_then(|estimate| estimate.as_ref().ok()?.amplification) {
        Some(factor) if factor > LARGEST_AMPLIFICATION => format!(
            "remark: the motion makes a small change of its start {factor:.0e} times as large: every method loses these digits; compare \
             over a shorter time, or compare energies\n"
        ),
        _ => String::new(),
    }
}

/// The estimate in one line of CSV.
pub(super) fn error_line(estimate: Option<&Estimate>) -> String {
    match estimate {
        Some(Ok(ErrorEstimate { errors, amplification, .. })) => {
            let errors = errors.iter().map(|QuantityError { quantity, unit, at_end, largest, .. }| {
                format!("{quantity} {at_end:.1e} {largest:.1e} {unit}")
            });
            let errors = errors.collect::<Vec<_>>().join(", ");
            let factor = amplification.map_or(String::new(), |factor| format!("; amplification {factor:.1e}"));
            format!("estimated error at the end and at most: {errors}{factor}")
        }
        Some(Err(why)) => format!("estimated error: not known: {why}"),
        None => "estimated error: not known: the run did not come to its end".to_owned(),
    }
}

/// How a method is set on the command line.
fn setting(method: Method) -> String {
    let short = |x: f64| rounded(x, 3);
    match method.tolerance() {
        Some(Tolerance { relative, absolute, angle }) => {
            let atol = if relative == absolute { String::new() } else { format!(" --atol {}", short(absolute)) };
            let angle_tol = angle.map_or(String::new(), |angle| format!(" --angle-tol {}", short(angle)));
            format!("--rtol {}{atol}{angle_tol}", short(relative))
        }
        None => format!("--step {}", short(method.setting())),
    }
}
