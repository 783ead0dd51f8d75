//! The figures: time against error, drift and energy against tolerance.

use super::measured::WorkPrecision;
use super::point::Measured;
use super::variant::Variant;
use crate::report::figure::Figure;
use ezy_core::dynamics::{Metric, Projection};
use ezy_core::integrate::MethodKind;

/// Where the error of a work-precision figure is taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Where {
    End,
    Grid,
}

/// A guide line is drawn this factor above its curve.
const GUIDE_GAP: f64 = 1.6;

/// Errors up to this many times the smallest one say nothing about the order.
const FLOOR: f64 = 10.0;

impl WorkPrecision {
    /// Time against error of positions, one curve a method.
    pub(super) fn work_precision(&self, place: Where) -> Figure {
        let (what, label) = match place {
            Where::End => ("at the end", format!("largest error of a position at t = {} s [m, rad]", self.until_s)),
            Where::Grid => ("throughout", "largest error of a position over the run [m, rad]".to_owned()),
        };
        let title = format!("{}/{}: what accuracy costs, {what}", self.info.model, self.info.name);
        let mut figure = Figure::log_log(&title, &label, "time of a run [ms]");
        for &kind in MethodKind::ALL {
            let (x, y) = self.costs(kind, place);
            figure = figure.points(kind.name(), x, y);
        }
        for &kind in MethodKind::ALL {
            figure = self.with_slope(figure, kind, place);
        }
        let [fastest, slowest] = self.range_of_times();
        let all = MethodKind::ALL.iter().flat_map(|&kind| self.costs(kind, place).0);
        let least = all.filter(|error| *error > 0.0).fold(f64::INFINITY, f64::min);
        if !least.is_finite() {
            return figure;
        }
        let known = self.known(place);
        let (name, floor) = match known >= least {
            true => (format!("the reference is known to {known:.0e}"), known),
            false => (format!("floor of rounding: {least:.0e}"), least),
        };
        figure.guide(&name, vec![floor, floor], vec![fastest, slowest])
    }

    fn known(&self, place: Where) -> f64 {
        let of = self.reference.uncertainty;
        match place {
            Where::End => of.end.position.absolute,
            Where::Grid => of.grid.position.absolute,
        }
    }

    /// Errors and times in ms of one method.
    fn costs(&self, kind: MethodKind, place: Where) -> (Vec<f64>, Vec<f64>) {
        let cost = |m: &Measured| {
            let error = match place {
                Where::End => m.error.end,
                Where::Grid => m.error.grid,
            };
            (error.position.absolute, 1e3 * m.seconds_min)
        };
        self.curve(kind.name(), Variant::default()).map(|(_, m)| cost(m)).unzip()
    }

    /// Shortest and longest time with the default projection, ms.
    fn range_of_times(&self) -> [f64; 2] {
        let all = MethodKind::ALL.iter().flat_map(|&kind| self.costs(kind, Where::End).1);
        all.fold([f64::INFINITY, 0.0], |[low, high], t| [low.min(t), high.max(t)])
    }

    /// The slope −1/order above the middle of a curve, away from the floor of rounding.
    fn with_slope(&self, figure: Figure, kind: MethodKind, place: Where) -> Figure {
        let (x, y) = self.costs(kind, place);
        let least = x.iter().copied().filter(|error| *error > 0.0).fold(f64::INFINITY, f64::min);
        let floor = FLOOR * least.max(self.known(place));
        let usable: Vec<(f64, f64)> = x.into_iter().zip(y).filter(|(x, _)| *x > floor && x.is_finite()).collect();
        let (Some(order), true) = (kind.info().order, usable.len() >= 4) else { return figure };
        let (first, last) = (usable.len() / 4, usable.len() - 1 - usable.len() / 4);
        let (x0, y0) = usable[first];
        let x1 = usable[last].0;
        let at = |x: f64| GUIDE_GAP * y0 * (x / x0).powf(-1.0 / f64::from(order));
        // nearer to the fine end, where curves are further apart
        let x = x0 * (x1 / x0).powf(0.75);
        let name = format!("slope −1/{order}");
        figure.guide("", vec![x0, x1], vec![at(x0), at(x1)]).note(x, GUIDE_GAP * at(x), &name)
    }

    /// Largest residual against tolerance, one curve a projection; `None` for a scene without rows.
    pub(super) fn drift(&self) -> Option<Figure> {
        let (pick, label): (fn(&Measured) -> f64, _) = match (self.info.n_rows(), self.info.n_position_rows) {
            (0, _) => return None,
            (_, 0) => (|m| m.velocity_residual, "largest residual of a velocity constraint"),
            _ => (|m| m.position_residual, "largest residual of a position constraint, |C|"),
        };
        let title = format!("{}/{}: drift off the constraints", self.info.model, self.info.name);
        let shown = [Projection::None, Projection::Positions, Projection::Velocities, Projection::Both];
        Some(self.by_variant(
            &title,
            label,
            &shown.map(|projection| Variant { projection, metric: Metric::Mass }),
            pick,
        ))
    }

    /// Largest energy balance against tolerance, one curve a projection.
    pub(super) fn energy(&self) -> Figure {
        let title = format!("{}/{}: kinetic and potential energy less work", self.info.model, self.info.name);
        let both = Projection::Both;
        let shown = [
            Variant::NONE,
            Variant { projection: Projection::Velocities, metric: Metric::Mass },
            Variant { projection: both, metric: Metric::Mass },
            Variant { projection: both, metric: Metric::Euclidean },
        ];
        self.by_variant(&title, "largest change [J]", &shown, |m| m.energy_balance)
    }

    fn by_variant(&self, title: &str, label: &str, shown: &[Variant], pick: fn(&Measured) -> f64) -> Figure {
        let method = DRAWN;
        let mut figure = Figure::log_log(title, &format!("tolerance of {method}"), label);
        for &variant in shown {
            let (x, y): (Vec<f64>, Vec<f64>) =
                self.curve(method, variant).map(|(method, m)| (method.setting(), pick(m))).unzip();
            if !x.is_empty() {
                figure = figure.points(variant.name(), x, y);
            }
        }
        figure
    }
}

/// The method whose projections are drawn: it takes every scene and knows nothing of constraints.
const DRAWN: &str = "dop853";
