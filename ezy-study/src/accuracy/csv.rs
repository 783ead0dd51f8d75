//! The measurement as a CSV file.

use super::measured::WorkPrecision;
use super::point::{Measured, Point};
use ezy_core::dynamics::{Metric, Projection};

/// Columns that identify a point.
const WHAT: [&str; 5] = ["method", "setting [s or tolerance]", "projection", "metric", "outcome"];

/// A column of measurements and its value for one setting.
type Column = (&'static str, fn(&WorkPrecision, &Measured) -> f64);

const COLUMNS: [Column; 25] = [
    ("position error at the end [m or rad]", |_, m| m.error.end.position.absolute),
    ("scaled position error at the end", |_, m| m.error.end.position.scaled),
    ("velocity error at the end [m/s or rad/s]", |_, m| m.error.end.velocity.absolute),
    ("scaled velocity error at the end", |_, m| m.error.end.velocity.scaled),
    ("reaction error at the end [N or N*m]", |_, m| m.error.end.reaction.absolute),
    ("scaled reaction error at the end", |_, m| m.error.end.reaction.scaled),
    ("largest position error [m or rad]", |_, m| m.error.grid.position.absolute),
    ("scaled largest position error", |_, m| m.error.grid.position.scaled),
    ("largest velocity error [m/s or rad/s]", |_, m| m.error.grid.velocity.absolute),
    ("scaled largest velocity error", |_, m| m.error.grid.velocity.scaled),
    ("largest reaction error [N or N*m]", |_, m| m.error.grid.reaction.absolute),
    ("scaled largest reaction error", |_, m| m.error.grid.reaction.scaled),
    ("known from [m or rad]", |all, _| all.reference.uncertainty.grid.position.absolute),
    ("largest position residual", |_, m| m.position_residual),
    ("largest velocity residual", |_, m| m.velocity_residual),
    ("largest energy balance [J]", |_, m| m.energy_balance),
    ("steps", |_, m| m.cost.steps as f64),
    ("rejected", |_, m| m.cost.rejected as f64),
    ("evaluations", |_, m| m.cost.evaluations as f64),
    ("factorizations", |_, m| m.cost.factorizations as f64),
    ("shortest time [s]", |_, m| m.seconds_min),
    ("median time [s]", |_, m| m.seconds_median),
    ("runs timed", |_, m| m.n_timed as f64),
    ("time on the grid [s]", |_, m| m.seconds_on_grid),
    ("grid points", |all, _| all.reference.trajectory.times().len() as f64),
];

impl WorkPrecision {
    /// One row a setting, numbers as short as gives back the same `f64`; what was not measured has no numbers.
    pub fn csv(&self) -> String {
        let mut rows = ::csv::Writer::from_writer(Vec::new());
        // writing into memory does not fail
        _ = rows.write_record(WHAT.into_iter().chain(COLUMNS.map(|(name, _)| name)));
        for point in &self.points {
            _ = rows.write_record(self.row(point));
        }
        rows.into_inner().map(|bytes| String::from_utf8_lossy(&bytes).into_owned()).unwrap_or_default()
    }

    fn row(&self, point: &Point) -> Vec<String> {
        let projection = match point.variant.projection {
            Projection::None => "none",
            Projection::Positions => "positions",
            Projection::Velocities => "velocities",
            Projection::Both => "both",
        };
        let metric = match point.variant.metric {
            Metric::Mass => "mass",
            Metric::Euclidean => "euclidean",
        };
        let what = [point.method.name(), &format!("{:e}", point.method.setting()), projection, metric, point.outcome()];
        let number =
            |(_, value): Column| point.measured().map_or_else(String::new, |m| format!("{:?}", value(self, m)));
        what.map(str::to_owned).into_iter().chain(COLUMNS.map(number)).collect()
    }
}
