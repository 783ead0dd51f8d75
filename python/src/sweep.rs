//! Runs of a scene over values of its parameters, counts, starts and inputs.

use crate::error::wrong;
use crate::motion::Motion;
use crate::signals::watched;
use ezy_core::model::{Scene, SceneInfo};
use ezy_core::record::find_name;
use ezy_study::sweep::{Case, Cell, Finished, Kind, Plan, Refused, Sweep, Table};
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// Cases in memory: more belong into files, as `ezy sweep` writes them.
const MOST_CASES: u64 = 10_000_000;

/// What is varied, and how the cases run.
pub(crate) struct Request {
    pub(crate) vary: Vec<(String, Vec<f64>)>,
    /// Whether the first values belong together, then the second ones, and so on; else each value meets each other one.
    pub(crate) together: bool,
    pub(crate) keep: Vec<String>,
    pub(crate) every_s: Option<f64>,
    pub(crate) n_threads: Option<usize>,
    pub(crate) in_lanes: bool,
    pub(crate) motion: Motion,
}

/// What a value of a case belongs to.
enum Target {
    Parameter(usize),
    Count(usize),
    Input,
    Start,
}

impl Request {
    /// Makes the scene of a case by `make` and runs it.
    pub(crate) fn run<'py>(
        &self,
        py: Python<'py>,
        scene: &dyn Scene,
        make: impl Fn() -> Box<dyn Scene> + Sync,
    ) -> PyResult<Bound<'py, PyDict>> {
        let (plan, flag) = (self.plan()?, AtomicBool::new(false));
        let info = scene.info();
        let targets = plan.names().into_iter().map(|name| target(name, &info)).collect::<PyResult<Vec<_>>>()?;
        let table = watched(py, &flag, || {
            let run = |case: &Case<'_>| self.case(make(), &targets, case);
            let mut sweep = Sweep::new(scene, plan.clone(), run).interrupted_by(&flag);
            let moving = info.coordinates.iter().chain(&*info.velocities).map(|of| &*of.name);
            sweep = match self.keep.is_empty() {
                true => sweep.keep(moving),
                false => sweep.keep(self.keep.iter().map(String::as_str)),
            };
            if let Some(every_s) = self.every_s {
                sweep = sweep.every(every_s);
            }
            if let Some(n_threads) = self.n_threads {
                sweep = sweep.threads(n_threads);
            }
            if self.in_lanes {
                sweep = sweep.in_lanes(scene);
            }
            sweep.run()
        })?;
        columns(py, &table.map_err(wrong)?)
    }

    fn plan(&self) -> PyResult<Plan> {
        let n_first = self.vary.first().map_or(0, |(_, values)| values.len());
        let plan = if self.together {
            if let Some((name, values)) = self.vary.iter().find(|(_, values)| values.len() != n_first) {
                let n = values.len();
                return Err(wrong(format!("`{name}` has {n} values where `{}` has {n_first}", self.vary[0].0)));
            }
            let numbers = (0..n_first).flat_map(|i| self.vary.iter().map(move |(_, values)| values[i])).collect();
            Plan::new().list(self.vary.iter().map(|(name, _)| name), numbers)
        } else {
            self.vary.iter().fold(Plan::new(), |plan, (name, values)| plan.grid(name, values.iter().copied()))
        };
        match plan.n_cases().map_err(wrong)? {
            n if n > MOST_CASES => Err(wrong(format!(
                "a sweep in memory has {MOST_CASES} cases at most, and this one has {n}; make several, or let `ezy sweep` write files"
            ))),
            _ => Ok(plan),
        }
    }

    fn case(&self, mut scene: Box<dyn Scene>, targets: &[Target], case: &Case<'_>) -> Result<Finished, Refused> {
        let values =
            || targets.iter().zip(&self.vary).zip(case.values()).map(|((of, (name, _)), x)| (of, name, x.number()));
        for (target, name, value) in values() {
            match target {
                Target::Parameter(i) => scene.set_parameter(*i, value),
                Target::Count(_) if value < 1.0 || value.fract() != 0.0 => {
                    return Err(Refused::new(format!(
                        "`{name}` takes a whole number from 1 on, but was given {value}"
                    )));
                }
                Target::Count(i) => scene.set_count(*i, value as usize),
                Target::Input | Target::Start => {}
            }
        }
        let mut simulation = self.motion.simulation(Arc::from(scene));
        for (target, name, value) in values() {
            simulation = match target {
                Target::Input => simulation.input(name, value),
                Target::Start => simulation.start(name, value),
                Target::Parameter(_) | Target::Count(_) => simulation,
            };
        }
        Ok(case.run(simulation)?)
    }
}

fn target(name: &str, info: &SceneInfo) -> PyResult<Target> {
    let parameters = info.parameters.iter().map(|of| of.name);
    let counts = info.counts().iter().map(|of| of.name);
    let inputs = info.inputs.iter().map(|of| of.name);
    let moving = info.coordinates.iter().chain(&*info.velocities).map(|of| &*of.name);
    let known = parameters.chain(counts).chain(inputs).chain(moving).chain(info.states.iter().map(|of| of.name));
    let i = find_name("parameter, count, input or start value", name, known).map_err(wrong)?;
    let Some(i) = i.checked_sub(info.parameters.len()) else { return Ok(Target::Parameter(i)) };
    let Some(i) = i.checked_sub(info.counts().len()) else { return Ok(Target::Count(i)) };
    Ok(if i < info.n_inputs() { Target::Input } else { Target::Start })
}

/// A dictionary of the columns: arrays, and lists of texts.
fn columns<'py>(py: Python<'py>, table: &Table) -> PyResult<Bound<'py, PyDict>> {
    let all = PyDict::new(py);
    let names: Vec<&str> = table.columns.iter().map(|column| column.name.as_str()).collect();
    // the number of the case is its place
    for (i, column) in table.columns.iter().skip(1).enumerate() {
        let cells = table.rows.iter().map(|row| &row.cells[i]);
        // what is varied may be kept, too: where it was, and where it comes to
        let name = match names[..=i].contains(&names[i + 1]) {
            true => format!("end:{}", column.name),
            false => column.name.clone(),
        };
        match column.kind {
            Kind::Text => {
                let texts = cells.map(|cell| if let Cell::Text(text) = cell { text.as_str() } else { "" });
                all.set_item(name, texts.collect::<Vec<_>>())?;
            }
            Kind::Number | Kind::Count => {
                let numbers = cells.map(|cell| match cell {
                    Cell::Number(x) => *x,
                    Cell::Count(n) => *n as f64,
                    Cell::Text(_) => f64::NAN,
                });
                all.set_item(name, PyArray1::from_iter(py, numbers))?;
            }
        }
    }
    Ok(all)
}
