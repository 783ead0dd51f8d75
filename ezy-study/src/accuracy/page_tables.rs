//! The tables of the page.

use super::advice::three_digits;
use super::ladder::command;
use super::measured::WorkPrecision;
use super::tables::{METHOD, SETTING};
use super::variant::Variant;
use crate::report::table::Table;
use ezy_core::integrate::Method;

impl WorkPrecision {
    /// All that was measured with the default projection.
    pub(super) fn error_table(&self) -> Table {
        self.table_of(&[
            METHOD,
            SETTING,
            ("position, end", |all, _, m| all.end_error(m)),
            ("largest", |all, _, m| all.largest_error(m)),
            ("scaled", |_, _, m| two_digits(m.error.grid.position.scaled)),
            ("velocity", |_, _, m| two_digits(m.error.grid.velocity.absolute)),
            ("scaled", |_, _, m| two_digits(m.error.grid.velocity.scaled)),
            ("reaction", |_, _, m| two_digits(m.error.grid.reaction.absolute)),
            ("scaled", |_, _, m| two_digits(m.error.grid.reaction.scaled)),
            ("|C|", |_, _, m| two_digits(m.position_residual)),
            ("velocity constraints", |_, _, m| two_digits(m.velocity_residual)),
            ("energy [J]", |_, _, m| two_digits(m.energy_balance)),
        ])
    }

    /// Costs with the default projection: counts, which are the same on every machine, and times.
    pub(super) fn cost_table(&self) -> Table {
        self.table_of(&[
            METHOD,
            SETTING,
            ("largest error", |all, _, m| all.largest_error(m)),
            ("steps", |_, _, m| m.cost.steps.to_string()),
            ("rejected", |_, _, m| m.cost.rejected.to_string()),
            ("evaluations", |_, _, m| m.cost.evaluations.to_string()),
            ("factorisations", |_, _, m| m.cost.factorizations.to_string()),
            ("shortest [ms]", |_, _, m| three_digits(1e3 * m.seconds_min)),
            ("median [ms]", |_, _, m| three_digits(1e3 * m.seconds_median)),
            ("runs", |_, _, m| m.n_timed.to_string()),
            ("on the grid [ms]", |_, _, m| three_digits(1e3 * m.seconds_on_grid)),
        ])
    }

    /// Every projection at one setting of each method: the finest one that all of them were measured with and that costs
    /// at most `1e-9` of error, or the finest one at all.
    pub(super) fn projection_table(&self) -> Table {
        let mut table = Table::new([
            "method",
            "setting",
            "projection",
            "largest error",
            "|C|",
            "velocity constraints",
            "energy [J]",
            "time [ms]",
            "of none",
        ]);
        for name in self.methods() {
            let Some(method) = self.compared_setting(name) else { continue };
            let at = |variant: Variant| self.curve(name, variant).find(|(m, _)| *m == method).map(|(_, found)| found);
            let none = at(Variant::NONE).map(|m| m.seconds_min);
            for variant in Variant::all(&self.info) {
                let Some(m) = at(variant) else { continue };
                let ratio = none.map_or_else(String::new, |none| format!("{:.2}", m.seconds_min / none));
                table.push([
                    name.to_owned(),
                    command(method),
                    variant.name().to_owned(),
                    self.largest_error(m),
                    two_digits(m.position_residual),
                    two_digits(m.velocity_residual),
                    two_digits(m.energy_balance),
                    three_digits(1e3 * m.seconds_min),
                    ratio,
                ]);
            }
        }
        table
    }

    /// The setting that projections are compared at: with an error near the middle of the ladder, so that there is
    /// something to see.
    fn compared_setting(&self, name: &str) -> Option<Method> {
        let with_all = |method: Method| {
            let measured = |variant: Variant| self.curve(name, variant).any(|(m, _)| m == method);
            Variant::all(&self.info).into_iter().all(measured)
        };
        let all: Vec<(Method, f64)> = self
            .curve(name, Variant::default())
            .filter(|(method, _)| with_all(*method))
            .map(|(method, m)| (method, m.error.grid.position.absolute))
            .collect();
        let fine_enough = all.iter().filter(|(_, error)| *error <= COMPARED_ERROR).max_by(|a, b| a.1.total_cmp(&b.1));
        fine_enough.or(all.last()).map(|(method, _)| *method)
    }
}

/// Error that projections are compared at, m or rad: above rounding, below what is seen.
const COMPARED_ERROR: f64 = 1e-6;

fn two_digits(x: f64) -> String {
    format!("{x:.1e}")
}
