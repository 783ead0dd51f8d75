//! The measurement as tables and sentences.

use super::advice::three_digits;
use super::errors::{Comparison, Size};
use super::ladder::command;
use super::measured::{Missing, WorkPrecision};
use super::point::Measured;
use super::variant::Variant;
use crate::report::table::Table;
use ezy_core::integrate::Method;
use ezy_core::scalar::legible_time;

/// A column of a table of settings: its head, and its cell.
pub(super) type Column = (&'static str, fn(&WorkPrecision, Method, &Measured) -> String);

pub(super) const METHOD: Column = ("method", |_, method, _| method.name().to_owned());
pub(super) const SETTING: Column = ("setting", |_, method, _| command(method));

impl WorkPrecision {
    /// Errors of positions and their cost, with the default projection; errors below the uncertainty of the reference are
    /// marked with ≤.
    pub fn table(&self) -> Table {
        self.table_of(&[
            METHOD,
            SETTING,
            ("end [m, rad]", |all, _, m| all.end_error(m)),
            ("largest [m, rad]", |all, _, m| all.largest_error(m)),
            ("steps", |_, _, m| m.cost.steps.to_string()),
            ("evaluations", |_, _, m| m.cost.evaluations.to_string()),
            ("time [ms]", |_, _, m| three_digits(1e3 * m.seconds_min)),
        ])
    }

    /// A row for each setting with the default projection.
    pub(super) fn table_of(&self, columns: &[Column]) -> Table {
        let mut table = Table::new(columns.iter().map(|(head, _)| *head));
        for (method, measured) in self.methods().flat_map(|method| self.curve(method, Variant::default())) {
            table.push(columns.iter().map(|(_, cell)| cell(self, method, measured)));
        }
        table
    }

    /// Error of positions at the end, marked when below the uncertainty of the reference.
    pub(super) fn end_error(&self, measured: &Measured) -> String {
        marked(measured.error.end.position, self.reference.uncertainty.end.position)
    }

    /// The same of the largest error.
    pub(super) fn largest_error(&self, measured: &Measured) -> String {
        marked(measured.error.grid.position, self.reference.uncertainty.grid.position)
    }

    /// The reference and its uncertainty, as sentences.
    pub fn reference_text(&self) -> Vec<String> {
        let reference = &self.reference;
        let Comparison { end, grid } = reference.uncertainty;
        let mut all = vec![format!(
            "The reference is {}, positions and velocities projected. {} by {:.1e} m or rad at the end and by {:.1e} at most; \
             errors up to there are not known, and tables mark them with ≤.",
            reference.by, reference.doubt, end.position.absolute, grid.position.absolute
        )];
        all.extend(reference.imprecise.as_ref().map(|why| format!("There is none in double-double: {why}.")));
        all.push(match &reference.second {
            Ok(second) => format!(
                "A second method, {}, differs from it by {:.1e} at most; its own last two runs differ by {:.1e}{}.",
                second.by,
                second.difference.grid.position.absolute,
                second.own.grid.position.absolute,
                if second.confirms() { "" } else { ", so that it does not confirm the reference" }
            ),
            Err(why) => format!("It was not validated by a second method: {why}."),
        });
        if let Some(unknown) = self.unknown {
            all.push(format!(
                "The runs end at t = {} s in place of {} s: there, the tightest runs differ by {unknown:.1e} of \
                 the size of the motion. The motion multiplies rounding until no digit is left, and no method of this \
                 precision gets further.",
                legible_time(self.until_s),
                legible_time(self.asked_until_s)
            ));
        }
        all
    }

    /// What was not measured, as sentences.
    pub fn missing_text(&self) -> Vec<String> {
        self.missing().iter().map(missing_line).collect()
    }
}

fn marked(error: Size, known: Size) -> String {
    let mark = if error.absolute <= known.absolute { "≤" } else { "" };
    format!("{mark}{:.1e}", error.absolute.max(if mark.is_empty() { 0.0 } else { known.absolute }))
}

fn missing_line(missing: &Missing) -> String {
    let [first, last] =
        [missing.settings.first(), missing.settings.last()].map(|m| m.copied().map_or(String::new(), command));
    let settings = match missing.settings.len() {
        1 => first,
        n => format!("{first} to {last} ({n} settings)"),
    };
    let projections: Vec<&str> = missing.variants.iter().map(|variant| variant.name()).collect();
    let (method, projections) = (missing.method, projections.join("; "));
    let reason = missing.reason.as_deref().unwrap_or("not run within the budget");
    format!("{method} {settings}, projection {projections}: {reason}")
}
