//! The ways to keep to the constraints.

use crate::dynamics::{Metric, Projection};
use crate::model::SceneInfo;

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
        let projections: &[Projection] = match (info.n_rows(), info.n_position_rows) {
            (0, _) => &[],
            (_, 0) => &[Projection::Velocities],
            _ => &[Projection::Positions, Projection::Velocities],
        };
        let mut all = vec![Self::default()];
        if info.n_rows() == 0 {
            return all;
        }
        all.push(Self::NONE);
        let of = |metric: Metric| projections.iter().map(move |&projection| Self { projection, metric });
        // without position constraints `both` is `velocities`
        let besides = |v: &Self| info.n_position_rows > 0 || v.metric == Metric::Euclidean;
        all.extend(of(Metric::Mass).filter(besides));
        if info.n_position_rows > 0 {
            all.push(Self { projection: Projection::Both, metric: Metric::Euclidean });
        }
        all.extend(of(Metric::Euclidean));
        all
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
