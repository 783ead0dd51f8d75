//! Messages about equations: redundant, empty or contradictory constraints.

use super::nearest::quoted;
use super::{Warning, fault_with_help};
use proc_macro2::Ident;

messages! {
    restricts_nothing(at: &Ident, row: &str):
        "constraint `{row}` restricts no motion: no velocity appears in it",
        "remove it, or attach it to a body that moves";

    not_linear(at: &Ident, kind: &str, row: &str):
        "{kind} `{row}` is not linear in the velocities",
        "write sums of velocities times expressions of positions and `t`";
}

/// `what`: "row `g`".
pub fn too_long(at: &Ident, what: &str, n_terms: usize, most: usize) -> syn::Error {
    fault_with_help(
        at,
        format_args!(
            "{what} is too long to be differentiated twice: its second derivative has {n_terms} terms, more than {most}"
        ),
        "nest fewer functions and quotients, since derivatives multiply with each of them; \
         a quotient that is to be zero is its numerator",
    )
}

/// Without others the constraint itself is empty: its terms cancel.
pub fn dependent(at: &Ident, row: &str, others: &[&str]) -> syn::Error {
    if others.is_empty() {
        return restricts_nothing(at, row);
    }
    fault_with_help(
        at,
        format_args!(
            "constraint `{row}` repeats what {} already demand{}",
            quoted(others),
            if others.len() == 1 { "s" } else { "" }
        ),
        "remove one of these constraints: for any parameters they restrict the same motion",
    )
}

pub fn dependent_as_declared(at: &Ident, row: &str, others: &[&str]) -> Warning {
    let fault = match others {
        [] => "restricts no motion".to_owned(),
        [other] => format!("repeats what `{other}` already demands"),
        _ => format!("repeats what {} already demand", quoted(others)),
    };
    Warning {
        span: at.span(),
        name: "constraint_that_repeats_others",
        text: format!(
            "with the declared parameters constraint `{row}` {fault}; runs share the forces between them and say so, \
             remove it if that is not meant"
        ),
    }
}

pub fn welded_wheel(at: &Ident, roll: &str) -> Warning {
    Warning {
        span: at.span(),
        name: "a_wheel_that_cannot_turn",
        text: format!(
            "weld `{at}` keeps the wheel of `{roll}` from turning against the body that carries it; write `hinge {at}: …`, without an angle, at its hub"
        ),
    }
}

pub fn integrates(at: &Ident, kind: &str, row: &str) -> Warning {
    Warning {
        span: at.span(),
        name: "velocity_constraint_that_restricts_positions",
        text: format!(
            "{kind} `{row}` integrates to a position constraint, which would hold without drift; \
             write it as `constraint`, `gear` or `drive`, unless its constant is not known"
        ),
    }
}

pub fn more_rows_than_coordinates(at: &Ident, n_rows: usize, n_coordinates: usize) -> Warning {
    Warning {
        span: at.span(),
        name: "more_constraints_than_coordinates",
        text: format!(
            "`{at}` has {n_rows} constraint equations but only {n_coordinates} coordinates: it moves only where constraints repeat \
             each other; runs then share the forces between them and say so"
        ),
    }
}
