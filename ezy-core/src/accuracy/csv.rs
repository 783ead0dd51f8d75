//! The measurement as a CSV file.

use super::command::setting;
use super::errors::Errors;
use super::measured::WorkPrecision;
use super::point::{Measured, Point, PointResult};
use crate::dynamics::{Metric, Projection};

/// Columns that identify a point.
const WHAT: [&str; 5] = ["method", "setting [s or tolerance]", "projection", "metric", "outcome"];

/// Columns of its measurements.
const NUMBERS: [&str; 25] = [
    "position error at the end [m or rad]",
    "scaled position error at the end",
    "velocity error at the end [m/s or rad/s]",
    "scaled velocity error at the end",
    "reaction error at the end [N or N*m]",
    "scaled reaction error at the end",
    "largest position error [m or rad]",
    "scaled largest position error",
    "largest velocity error [m/s or rad/s]",
    "scaled largest velocity error",
    "largest reaction error [N or N*m]",
    "scaled largest reaction error",
    "known from [m or rad]",
    "largest position residual",
    "largest velocity residual",
    "largest energy balance [J]",
    "steps",
    "rejected",
    "evaluations",
    "factorizations",
    "shortest time [s]",
    "median time [s]",
    "runs timed",
    "time on the grid [s]",
    "grid points",
];

impl WorkPrecision {
    /// One row a setting, with 17 significant digits; what was not measured has no numbers.
    pub fn csv(&self) -> String {
        let mut rows = ::csv::Writer::from_writer(Vec::new());
        // writing into memory does not fail
        _ = rows.write_record(WHAT.iter().chain(&NUMBERS));
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
        let outcome = match &point.result {
            PointResult::Measured(_) => "measured",
            PointResult::Stopped(reason) => reason,
            PointResult::NotRun => "not run",
        };
        let what = [point.method.name(), &format!("{:e}", setting(point.method)), projection, metric, outcome];
        let numbers = match point.measured() {
            Some(measured) => self.numbers(measured).map(|x| format!("{x:.16e}")),
            None => [const { String::new() }; NUMBERS.len()],
        };
        what.map(str::to_owned).into_iter().chain(numbers).collect()
    }

    fn numbers(&self, m: &Measured) -> [f64; NUMBERS.len()] {
        let [a, b, c, d, e, f] = six(m.error.end);
        let [g, h, i, j, k, l] = six(m.error.grid);
        let known = self.reference.uncertainty.grid.position.absolute;
        let counts = [m.cost.steps, m.cost.rejected, m.cost.evaluations, m.cost.factorizations].map(|n| n as f64);
        let [steps, rejected, evaluations, factorizations] = counts;
        [
            a,
            b,
            c,
            d,
            e,
            f,
            g,
            h,
            i,
            j,
            k,
            l,
            known,
            m.position_residual,
            m.velocity_residual,
            m.energy_balance,
            steps,
            rejected,
            evaluations,
            factorizations,
            m.seconds_min,
            m.seconds_median,
            m.n_timed as f64,
            m.seconds_on_grid,
            self.reference.trajectory.times().len() as f64,
        ]
    }
}

fn six(errors: Errors) -> [f64; 6] {
    let Errors { position, velocity, reaction } = errors;
    [position.absolute, position.scaled, velocity.absolute, velocity.scaled, reaction.absolute, reaction.scaled]
}
