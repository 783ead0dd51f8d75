//! What the motions of a run, of a sweep and of its derivatives depend on.

use crate::error::wrong;
use crate::inputs::numbers;
use ezy_core::integrate::{Method, MethodKind, Tolerance};
use ezy_core::model::Scene;
use ezy_core::record::find_name;
use ezy_core::simulate::{InputTable, Simulation};
use pyo3::prelude::*;
use pyo3::types::PyMapping;
use std::sync::Arc;

/// Samples, besides the first, of a run that says nothing of them: a figure shows no corners.
const N_INTERVALS: f64 = 500.0;

/// Method, end, start and inputs.
pub(crate) struct Motion {
    pub(crate) method: Method,
    /// End, s; that of the scene if not given.
    pub(crate) until_s: Option<f64>,
    start: Vec<(String, f64)>,
    inputs: Vec<(String, InputTable)>,
    project_start: bool,
}

/// The method by its name and its setting.
pub(crate) struct MethodChoice<'a> {
    pub(crate) name: Option<&'a str>,
    pub(crate) rtol: Option<f64>,
    pub(crate) atol: Option<f64>,
    pub(crate) step: Option<f64>,
}

impl Motion {
    pub(crate) fn new(
        method: &MethodChoice<'_>,
        until_s: Option<f64>,
        start: Option<&Bound<'_, PyMapping>>,
        inputs: Vec<(String, InputTable)>,
        project_start: bool,
    ) -> PyResult<Self> {
        Ok(Self { method: method.method()?, until_s, start: numbers(start)?, inputs, project_start })
    }

    /// End of the motion of `scene`, s.
    pub(crate) fn end(&self, scene: &dyn Scene) -> f64 {
        self.until_s.unwrap_or_else(|| scene.info().until_s)
    }

    /// Time between samples where nobody says when they are, s.
    pub(crate) fn interval(&self, scene: &dyn Scene) -> Option<f64> {
        let until_s = self.end(scene);
        (until_s > 0.0).then_some(until_s / N_INTERVALS)
    }

    pub(crate) fn simulation<'s>(&self, scene: Arc<dyn Scene>) -> Simulation<'s, Arc<dyn Scene>> {
        let until_s = self.end(&*scene);
        let of = Simulation::new(scene).method(self.method).until(until_s);
        let of = self.start.iter().fold(of, |of, (name, value)| of.start(name, *value));
        let of = self.inputs.iter().fold(of, |of, (name, table)| of.input(name, table.clone()));
        if self.project_start { of.project_start() } else { of }
    }
}

impl MethodChoice<'_> {
    fn method(&self) -> PyResult<Method> {
        let Self { name, rtol, atol, step } = *self;
        let kind = match name {
            Some(name) => {
                let i = find_name("method", name, MethodKind::ALL.iter().map(|kind| kind.name())).map_err(wrong)?;
                MethodKind::ALL[i]
            }
            None if step.is_some() => MethodKind::Rk4,
            None => Method::default().kind(),
        };
        let name = kind.name();
        let has_tolerance = rtol.or(atol).is_some();
        if let Some(step) = step {
            let method = kind.with_step(step).filter(|_| !has_tolerance);
            return method.ok_or_else(|| {
                wrong(match kind.with_step(step) {
                    Some(_) => format!("{name} has a fixed step and no tolerance: give `step` alone, or a method with a tolerance, such as \"dop853\""),
                    None => format!("{name} chooses the length of its steps: give `rtol` in place of `step`"),
                })
            });
        }
        let relative = rtol.unwrap_or(Tolerance::DEFAULT);
        let tolerance = Tolerance::new(relative, atol.unwrap_or(relative));
        kind.with_tolerance(tolerance).ok_or_else(|| {
            wrong(format!("{name} has a fixed step and no tolerance: give `step`, in s, or a method with a tolerance, such as \"dop853\""))
        })
    }
}
