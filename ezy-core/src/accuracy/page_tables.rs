//! The tables of the page.

use super::advice::three_digits;
use super::errors::Errors;
use super::ladder::command;
use super::measured::WorkPrecision;
use super::variant::Variant;
use crate::integrate::Method;
use crate::report::table::Table;

impl WorkPrecision {
    /// All that was measured with the default projection.
    pub(super) fn error_table(&self) -> Table {
        let mut table = Table::new([
            "method",
            "setting",
            "position, end",
            "largest",
            "scaled",
            "velocity",
            "scaled",
            "reaction",
            "scaled",
            "|C|",
            "velocity constraints",
            "energy [J]",
        ]);
        for (method, m) in self.main_curves() {
            let [end, grid] = self.position_errors(m);
            let Errors { position, velocity, reaction } = m.error.grid;
            let rest = [position.scaled, velocity.absolute, velocity.scaled, reaction.absolute, reaction.scaled];
            let residuals = [m.position_residual, m.velocity_residual, m.energy_balance];
            let cells = [method.name().to_owned(), command(method), end, grid].into_iter();
            table.push(cells.chain(rest.into_iter().chain(residuals).map(|x| format!("{x:.1e}"))));
        }
        table
    }

    /// Costs with the default projection: counts, which are the same on every machine, and times.
    pub(super) fn cost_table(&self) -> Table {
        let mut table = Table::new([
            "method",
            "setting",
            "largest error",
            "steps",
            "rejected",
            "evaluations",
            "factorisations",
            "shortest [ms]",
            "median [ms]",
            "runs",
            "on the grid [ms]",
        ]);
        for (method, m) in self.main_curves() {
            let [_, grid] = self.position_errors(m);
            let counts = [m.cost.steps, m.cost.rejected, m.cost.evaluations, m.cost.factorizations];
            let times = [m.seconds_min, m.seconds_median].map(|s| three_digits(1e3 * s));
            let cells = [method.name().to_owned(), command(method), grid].into_iter();
            let cells = cells.chain(counts.map(|n| n.to_string())).chain(times);
            table.push(cells.chain([m.n_timed.to_string(), three_digits(1e3 * m.seconds_on_grid)]));
        }
        table
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
            for variant in Variant::all(self.info) {
                let Some(m) = at(variant) else { continue };
                let [_, grid] = self.position_errors(m);
                let ratio = none.map_or_else(String::new, |none| format!("{:.2}", m.seconds_min / none));
                table.push([
                    name.to_owned(),
                    command(method),
                    variant.name().to_owned(),
                    grid,
                    format!("{:.1e}", m.position_residual),
                    format!("{:.1e}", m.velocity_residual),
                    format!("{:.1e}", m.energy_balance),
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
            Variant::all(self.info).into_iter().all(measured)
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
