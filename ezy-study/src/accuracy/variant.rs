//! The ways to keep to the constraints.

use ezy_core::dynamics::{Metric, Projection};
use ezy_core::model::SceneInfo;

/// What is projected after each step, and in which metric.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Variant {
    /// What is projected.
    pub projection: Projection,
    /// In which metric the correction is smallest.
    pub metric: Metric,
}

impl Variant {
    /// Nothing is projected.
    pub const NONE: Self = Self { projection: Projection::None, metric: Metric::Mass };

    /// Every variant that makes a difference in a scene, the default one first: a scene without position constraints has no
    /// positions to project, one without rows nothing at all.
    pub fn all(info: &SceneInfo) -> Vec<Self> {
        use Metric::{Euclidean, Mass};
        use Projection::{Both, Positions, Velocities};
        let default = Self::default();
        let of = |(projection, metric)| Self { projection, metric };
        match (info.n_rows(), info.n_position_rows) {
            (0, _) => vec![default],
            // `both` is `velocities`
            (_, 0) => vec![default, Self::NONE, of((Velocities, Euclidean))],
            _ => {
                let others = [(Positions, Mass), (Velocities, Mass)].into_iter();
                let others = others.chain([Both, Positions, Velocities].map(|projection| (projection, Euclidean)));
                [default, Self::NONE].into_iter().chain(others.map(of)).collect()
            }
        }
    }

    /// How it is named in reports.
    pub fn name(self) -> &'static str {
        match (self.projection, self.metric) {
            (Projection::None, _) => "none",
            (Projection::Positions, Metric::Mass) => "positions",
            (Projection::Velocities, Metric::Mass) => "velocities",
            (Projection::Both, Metric::Mass) => "both",
            (Projection::Positions, Metric::Euclidean) => "positions, Euclidean",
            (Projection::Velocities, Metric::Euclidean) => "velocities, Euclidean",
            (Projection::Both, Metric::Euclidean) => "both, Euclidean",
        }
    }
}
