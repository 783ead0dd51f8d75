//! Scenes with their parameters.

use crate::analysis::{self, PyEquilibrium, PyLinearization, Request};
use crate::batch::{PyBatch, Settings};
use crate::error::{StoppedError, wrong};
use crate::inputs::{Numbers, lists, numbers, numbers_of_members, tables};
use crate::motion::{MethodChoice, Motion};
use crate::notebook::{PySketch, latex};
use crate::run::PyRun;
use crate::sensitivities::{PySensitivities, Samples, sensitivities};
use crate::signals::{left_to_itself, simulate};
use crate::stepper::PyStepper;
use crate::sweep;
use ezy_core::integrate::Method;
use ezy_core::model::{ModelInfo, Scene, SceneEntry};
use ezy_core::record::find_name;
use ezy_core::simulate::{Outcome, Run, Simulation};
use ezy_study::report::drawing;
use pyo3::exceptions::PyKeyboardInterrupt;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList, PyMapping};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// Steppers of a batch: each takes some kilobytes, and what is too much ends the process.
const MOST_MEMBERS: usize = 1_000_000;

/// A scene with its parameters.
#[pyclass(frozen, name = "Scene", module = "ezy")]
pub(crate) struct PyScene {
    model: &'static ModelInfo,
    entry: &'static SceneEntry,
    scene: Arc<dyn Scene>,
}

impl PyScene {
    pub(crate) fn new(model: &'static ModelInfo, entry: &'static SceneEntry, scene: Arc<dyn Scene>) -> Self {
        Self { model, entry, scene }
    }

    /// The scene for each of `n` members, with their own values of these parameters.
    fn for_members(&self, n: usize, parameters: &Numbers) -> PyResult<Vec<Arc<dyn Scene>>> {
        let info = self.scene.info();
        let names = info.parameters.iter().map(|of| of.name).chain(info.counts().iter().map(|of| of.name));
        let index = |name: &str| {
            let i = find_name("parameter", name, names.clone()).map_err(wrong)?;
            match i < info.parameters.len() {
                true => Ok(i),
                false => Err(wrong(format!("`{name}` is a count, which all members share: give it to the scene"))),
            }
        };
        let places = parameters.iter().map(|(name, _)| index(name)).collect::<PyResult<Vec<_>>>()?;
        let own = |i: usize| {
            let mut scene = self.copy();
            places.iter().zip(parameters).for_each(|(k, (_, values))| scene.set_parameter(*k, values.at(i)));
            Arc::from(scene)
        };
        Ok(match places.is_empty() {
            true => vec![Arc::clone(&self.scene); n],
            false => (0..n).map(own).collect(),
        })
    }

    /// One like it, to be changed.
    fn copy(&self) -> Box<dyn Scene> {
        let (mut scene, info) = ((self.entry.new)(), self.scene.info());
        (0..info.counts().len()).for_each(|k| scene.set_count(k, self.scene.count(k)));
        (0..info.parameters.len()).for_each(|k| scene.set_parameter(k, self.scene.parameter(k)));
        scene
    }

    /// The run, or an exception that has it.
    fn finished(&self, py: Python<'_>, run: Run, method: Method) -> PyResult<PyRun> {
        match run.outcome.reached_end() {
            true => Ok(PyRun::new(run, Arc::clone(&self.scene), method)),
            false => Err(self.stopped(py, run, method)),
        }
    }

    /// The exception of a run that did not reach its end; it has the run.
    fn stopped(&self, py: Python<'_>, run: Run, method: Method) -> PyErr {
        let text = format!("the run {}", run.outcome);
        if let Outcome::Interrupted { .. } = run.outcome {
            return PyKeyboardInterrupt::new_err(text);
        }
        let error = StoppedError::new_err(text);
        let set = error.value(py).setattr("run", PyRun::new(run, Arc::clone(&self.scene), method));
        set.err().unwrap_or(error)
    }

    fn simulation<'s>(&self) -> Simulation<'s, Arc<dyn Scene>> {
        Simulation::new(Arc::clone(&self.scene))
    }
}

#[pymethods]
impl PyScene {
    /// Name of the scene.
    #[getter]
    fn name(&self) -> &'static str {
        self.entry.name
    }

    /// Present values of the parameters and counts.
    #[getter]
    fn parameters<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let (all, info) = (PyDict::new(py), self.scene.info());
        for (i, known) in info.parameters.iter().enumerate() {
            all.set_item(known.name, self.scene.parameter(i))?;
        }
        for (i, known) in info.counts().iter().enumerate() {
            all.set_item(known.name, self.scene.count(i))?;
        }
        Ok(all)
    }

    /// Simulates the scene and returns its run.
    ///
    /// until: end, s; that of the scene if not given
    /// rtol, atol: tolerances of a method that chooses its steps
    /// step: step of a method that does not, s
    /// method: "dop853", "taylor", "radau", "rk4", …
    /// every: time between samples, s; a 500th of the run if neither it nor `at` is given
    /// at: times of samples, s
    /// start: values to begin with, by name
    /// inputs: numbers, or pairs of times and values, by name
    /// project_start: moves values of the start that contradict the constraints to the nearest that do not
    /// estimate: runs once more and tells the error
    /// work: integrates the works of the effects
    ///
    /// Raises EzyError for what cannot be run, and StoppedError for a run that ends before its time; its attribute `run` has everything up to
    /// there.
    #[pyo3(signature = (until=None, *, rtol=None, atol=None, step=None, method=None, every=None, at=None, start=None, inputs=None, project_start=false, estimate=false, work=false))]
    #[expect(clippy::too_many_arguments, reason = "they are keywords in Python")]
    fn run(
        &self,
        py: Python<'_>,
        until: Option<f64>,
        rtol: Option<f64>,
        atol: Option<f64>,
        step: Option<f64>,
        method: Option<&str>,
        every: Option<f64>,
        at: Option<Vec<f64>>,
        start: Option<&Bound<'_, PyMapping>>,
        inputs: Option<&Bound<'_, PyMapping>>,
        project_start: bool,
        estimate: bool,
        work: bool,
    ) -> PyResult<PyRun> {
        let choice = MethodChoice { name: method, rtol, atol, step };
        let motion = Motion::new(&choice, until, start, tables(inputs)?, project_start)?;
        let (scene, flag) = (&self.scene, AtomicBool::new(false));
        let mut simulation = motion.simulation(Arc::clone(scene)).interrupted_by(&flag);
        if scene.info().n_outputs() > 0 {
            simulation = simulation.outputs();
        }
        let by_itself = if at.is_none() { motion.interval(&**scene) } else { None };
        if let Some(every) = every.or(by_itself) {
            simulation = simulation.every(every);
        }
        if let Some(at) = at {
            simulation = simulation.at(at);
        }
        if estimate {
            simulation = simulation.estimate_error();
        }
        if work {
            simulation = simulation.work();
        }
        let run = simulate(py, simulation, &flag)?;
        self.finished(py, run, motion.method)
    }

    /// Runs the scene for all values of what `vary` names, on all cores: parameters, counts, inputs and start values. Returns a dictionary of
    /// arrays with a number for each run: `pandas.DataFrame(table)`.
    ///
    /// vary: sequences of values by name; each value meets each other one, the last name varies fastest
    /// together: the first values belong together, then the second ones, and so on
    /// keep: what is kept of each run: "seat.vx" at its end ("end:seat.vx" where it is varied), "max:output.speed", "event:landed"; positions and
    ///     velocities if not given
    /// threads: how many work at most
    /// lanes: runs eight neighbours together where they are run by dop853 with one count and only their ends are kept, others one by one
    /// every: time between the samples from which extremes are taken, s
    /// until, rtol, atol, step, method, start, inputs and project_start as for `run`
    ///
    /// A run that fails is a row with its outcome and a message.
    #[pyo3(signature = (vary, *, together=false, keep=vec![], threads=None, lanes=false, every=None, until=None, rtol=None, atol=None, step=None, method=None, start=None, inputs=None, project_start=false))]
    #[expect(clippy::too_many_arguments, reason = "they are keywords in Python")]
    fn sweep<'py>(
        &self,
        py: Python<'py>,
        vary: &Bound<'py, PyMapping>,
        together: bool,
        keep: Vec<String>,
        threads: Option<usize>,
        lanes: bool,
        every: Option<f64>,
        until: Option<f64>,
        rtol: Option<f64>,
        atol: Option<f64>,
        step: Option<f64>,
        method: Option<&str>,
        start: Option<&Bound<'py, PyMapping>>,
        inputs: Option<&Bound<'py, PyMapping>>,
        project_start: bool,
    ) -> PyResult<Bound<'py, PyDict>> {
        let choice = MethodChoice { name: method, rtol, atol, step };
        let request = sweep::Request {
            vary: lists(vary)?,
            together,
            keep,
            every_s: every,
            n_threads: threads,
            in_lanes: lanes,
            motion: Motion::new(&choice, until, start, tables(inputs)?, project_start)?,
        };
        request.run(py, &*self.scene, || self.copy())
    }

    /// A run with the exact derivatives of coordinates, velocities and first-order states by what `by` names: parameters, and values that the
    /// start gives. They are those of the computed motion,
    /// whose steps end at the samples. It does not end at events, and where a law jumps the derivatives lack the jump; stops and limits of skates are
    /// refused.
    ///
    /// until, rtol, atol, step, method, every, at, start and project_start as for `run`, inputs as numbers alone. Methods are "dop853", "rk4" and
    /// "midpoint". Start values stay as they are when a parameter changes, and what the start does not give follows the constraints.
    ///
    /// Raises EzyError for what cannot be run, and StoppedError where the motion cannot go on.
    #[pyo3(signature = (by, until=None, *, rtol=None, atol=None, step=None, method=None, every=None, at=None, start=None, inputs=None, project_start=false))]
    #[expect(clippy::too_many_arguments, reason = "they are keywords in Python")]
    fn sensitivities(
        &self,
        py: Python<'_>,
        by: Vec<String>,
        until: Option<f64>,
        rtol: Option<f64>,
        atol: Option<f64>,
        step: Option<f64>,
        method: Option<&str>,
        every: Option<f64>,
        at: Option<Vec<f64>>,
        start: Option<&Bound<'_, PyMapping>>,
        inputs: Option<&Bound<'_, PyMapping>>,
        project_start: bool,
    ) -> PyResult<PySensitivities> {
        let choice = MethodChoice { name: method, rtol, atol, step };
        let inputs = numbers(inputs)?.into_iter().map(|(name, value)| (name, value.into())).collect();
        let motion = Motion::new(&choice, until, start, inputs, project_start)?;
        let samples = match (at, every.or(motion.interval(&*self.scene))) {
            (Some(at), _) => Samples::At(at),
            (None, every) => Samples::Every(every.unwrap_or(f64::INFINITY)),
        };
        sensitivities(py, &self.scene, &motion, &by, &samples)
    }

    /// A stepper: the scene in fixed steps of `step` s by rk4, to be driven from outside.
    ///
    /// start and inputs as for `run`, inputs as numbers alone.
    #[pyo3(signature = (step, *, start=None, inputs=None))]
    fn stepper(
        &self,
        step: f64,
        start: Option<&Bound<'_, PyMapping>>,
        inputs: Option<&Bound<'_, PyMapping>>,
    ) -> PyResult<PyStepper> {
        let mut simulation = self.simulation().method(Method::rk4(step));
        for (name, value) in numbers(start)? {
            simulation = simulation.start(name, value);
        }
        for (name, value) in numbers(inputs)? {
            simulation = simulation.input(name, value);
        }
        Ok(PyStepper::new(simulation.stepper().map_err(wrong)?))
    }

    /// `n` steppers that step together on all cores, without the global lock.
    ///
    /// start, inputs and parameters have values by name, each a number or an array with one for each member; threads is how many work at
    /// most. The numbers are those of single steppers, whatever the number of threads; with lanes=True eight members step at once, 2.6 times as
    /// fast, and their numbers are those but for 1e-12 of their size a step.
    #[pyo3(signature = (n, step, *, start=None, inputs=None, parameters=None, threads=None, lanes=false))]
    #[expect(clippy::too_many_arguments, reason = "they are keywords in Python")]
    fn batch(
        &self,
        py: Python<'_>,
        n: usize,
        step: f64,
        start: Option<&Bound<'_, PyMapping>>,
        inputs: Option<&Bound<'_, PyMapping>>,
        parameters: Option<&Bound<'_, PyMapping>>,
        threads: Option<usize>,
        lanes: bool,
    ) -> PyResult<PyBatch> {
        for (name, number) in [("n", Some(n)), ("threads", threads)] {
            if number == Some(0) {
                return Err(wrong(format!("`{name}` takes a whole number from 1 on, but was given 0")));
            }
        }
        if n > MOST_MEMBERS {
            return Err(wrong(format!(
                "a batch has {MOST_MEMBERS} members at most, but `n` was given as {n}; make several batches"
            )));
        }
        let settings = Settings {
            scenes: self.for_members(n, &numbers_of_members(parameters, n)?)?,
            start: numbers_of_members(start, n)?,
            inputs: numbers_of_members(inputs, n)?,
            n_threads: threads,
            in_lanes: lanes,
        };
        PyBatch::new(py, &settings, |scene| Simulation::new(scene).method(Method::rk4(step)))
    }

    /// Compares the equations of the scene with finite differences; raises EzyError where they differ.
    fn check(&self, py: Python<'_>) -> PyResult<()> {
        let scene = Arc::clone(&self.scene);
        left_to_itself(py, move || ezy_core::testing::check_scene(&*scene).map(|_| ()).map_err(wrong))?
    }

    /// The equilibrium near the start: rest, or motion that is constant seen from a frame that travels and turns evenly.
    ///
    /// start and inputs as for `run`, inputs as numbers alone. hold names coordinates, velocities and states that keep their value of the start.
    #[pyo3(signature = (*, start=None, inputs=None, hold=vec![]))]
    fn equilibrium(
        &self,
        py: Python<'_>,
        start: Option<&Bound<'_, PyMapping>>,
        inputs: Option<&Bound<'_, PyMapping>>,
        hold: Vec<String>,
    ) -> PyResult<PyEquilibrium> {
        analysis::equilibrium(py, Request::new(&self.scene, start, inputs, hold)?)
    }

    /// All equilibria at rest that `n_starts` starts lead to: that of the scene, and others at random, which are the same each time.
    ///
    /// start, inputs and hold as for `equilibrium`. A rest that no start leads to is not found.
    #[pyo3(signature = (*, n_starts=128, start=None, inputs=None, hold=vec![]))]
    fn equilibria(
        &self,
        py: Python<'_>,
        n_starts: usize,
        start: Option<&Bound<'_, PyMapping>>,
        inputs: Option<&Bound<'_, PyMapping>>,
        hold: Vec<String>,
    ) -> PyResult<Vec<PyEquilibrium>> {
        analysis::equilibria(py, Request::new(&self.scene, start, inputs, hold)?, n_starts)
    }

    /// The linear equations x' = A x + B u, y = C x + D u of small deviations from the equilibrium near the start, with exact derivatives.
    ///
    /// start, inputs and hold as for `equilibrium`.
    #[pyo3(signature = (*, start=None, inputs=None, hold=vec![]))]
    fn linearize(
        &self,
        py: Python<'_>,
        start: Option<&Bound<'_, PyMapping>>,
        inputs: Option<&Bound<'_, PyMapping>>,
        hold: Vec<String>,
    ) -> PyResult<PyLinearization> {
        analysis::linearize(py, Request::new(&self.scene, start, inputs, hold)?)
    }

    /// The equations of the scene in LaTeX, as displayed mathematics with titles; the package `amsmath` has what they take.
    fn equations(&self) -> String {
        latex(&self.scene.info(), ["\\[", "\\]"])
    }

    /// A sketch of the mechanism at the time `at`, s. A notebook shows it, and `save(path)` writes it.
    ///
    /// start has values to begin with by name, as for `run`.
    #[pyo3(signature = (at=0.0, *, start=None))]
    fn sketch(&self, py: Python<'_>, at: f64, start: Option<&Bound<'_, PyMapping>>) -> PyResult<PySketch> {
        let flag = AtomicBool::new(false);
        let mut simulation = self.simulation().until(at).interrupted_by(&flag);
        for (name, value) in numbers(start)? {
            simulation = simulation.start(name, value);
        }
        let run = simulate(py, simulation, &flag)?;
        match run.outcome.reached_end() {
            true => Ok(PySketch { svg: drawing::sketch(&*self.scene, &run.last()) }),
            false => Err(self.stopped(py, run, Method::default())),
        }
    }

    fn _repr_latex_(&self) -> String {
        latex(&self.scene.info(), ["$$", "$$"])
    }

    /// End of a run that is given none, s.
    #[getter]
    fn until(&self) -> f64 {
        self.scene.info().until_s
    }

    /// Names of the coordinates.
    #[getter]
    fn coordinates<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyList>> {
        PyList::new(py, self.scene.info().coordinates.iter().map(|c| c.name.to_string()))
    }

    fn __repr__(&self) -> String {
        let info = self.scene.info();
        let values =
            info.parameters.iter().enumerate().map(|(i, of)| format!("{}={:?}", of.name, self.scene.parameter(i)));
        let counts = info.counts().iter().enumerate().map(|(i, of)| format!("{}={}", of.name, self.scene.count(i)));
        let values: Vec<String> = counts.chain(values).collect();
        format!("{}.{}({})", self.model.name.to_lowercase(), self.entry.name, values.join(", "))
    }
}
