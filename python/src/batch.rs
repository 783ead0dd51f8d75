//! Many steppers of one scene that step together.

use crate::error::{StoppedError, wrong};
use crate::inputs::{Numbers, Values, numbers_of_members};
use crate::signals::BETWEEN_SIGNALS;
use crate::stepper::{Places, value};
use ezy_core::model::{Scene, SceneInfo};
use ezy_core::record::input_index;
use ezy_core::simulate::{EightSteppers, SetupError, Simulation, Stepper};
use numpy::{PyArray1, PyArray2, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyMapping};
use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::available_parallelism;
use std::time::Instant;

/// Steps that are taken, or left undone, at once in lanes; and most of them between two looks for signals.
const PIECE: u64 = 64;
const LONGEST: u64 = 1 << 20;

/// Members that step at once in lanes.
const N_LANES: usize = 8;

/// Work that is worth a thread, s: to start one, and to wait for it on a busy machine, takes some 20 to 100 µs.
const LEAST_WORK_S: f64 = 3e-4;

/// Many steppers of one scene, each with its own start, inputs and parameters, that step together on all cores.
#[pyclass(name = "Batch", module = "ezy")]
pub(crate) struct PyBatch {
    /// Locked because Python may call from any thread.
    members: Mutex<Vec<Member>>,
    /// For eight members each; none where members step by themselves.
    lanes: Mutex<Vec<EightSteppers<Arc<dyn Scene>>>>,
    places: Places,
    info: Arc<SceneInfo>,
    most_threads: usize,
    /// What a step of a member took last, s.
    seconds_of_step: f64,
}

/// One stepper of a batch.
struct Member {
    stepper: Stepper<'static, Arc<dyn Scene>>,
    /// Why its motion cannot go on.
    stopped: Option<String>,
}

/// What a member is made with.
pub(crate) struct Settings {
    pub(crate) scenes: Vec<Arc<dyn Scene>>,
    pub(crate) start: Numbers,
    pub(crate) inputs: Numbers,
    pub(crate) n_threads: Option<usize>,
    /// Whether eight members step at once.
    pub(crate) in_lanes: bool,
}

impl PyBatch {
    /// One member for each scene, of which there is one at least.
    pub(crate) fn new(
        py: Python<'_>,
        settings: &Settings,
        simulation: impl Fn(Arc<dyn Scene>) -> Simulation<'static, Arc<dyn Scene>> + Sync,
    ) -> PyResult<Self> {
        let Settings { scenes, start, inputs, n_threads, in_lanes } = settings;
        let n_cores = available_parallelism().map_or(1, usize::from);
        let most_threads = n_threads.unwrap_or(n_cores).min(n_cores);
        let made = |i: usize| {
            let of = simulation(Arc::clone(&scenes[i]));
            let of = start.iter().fold(of, |of, (name, values)| of.start(name, values.at(i)));
            inputs.iter().fold(of, |of, (name, values)| of.input(name, values.at(i))).stepper()
        };
        let mut all: Vec<(usize, Option<Result<_, SetupError>>)> = (0..scenes.len()).map(|i| (i, None)).collect();
        py.detach(|| on_threads(&mut all, most_threads, |(i, stepper)| *stepper = Some(made(*i))));
        let member = |(i, stepper): (usize, Option<Result<_, SetupError>>)| match stepper {
            Some(Ok(stepper)) => Some(Ok(Member { stepper, stopped: None })),
            Some(Err(error)) => Some(Err(wrong(format!("member {i}: {error}")))),
            None => None,
        };
        let mut members = all.into_iter().filter_map(member).collect::<PyResult<Vec<_>>>()?;
        let eight = |members: &mut [Member]| EightSteppers::new(&mut steppers(members)).map_err(wrong);
        let lanes = match in_lanes {
            true => members.chunks_mut(N_LANES).map(eight).collect::<PyResult<_>>()?,
            false => Vec::new(),
        };
        let info = scenes[0].info();
        let places = Places::new(&info);
        let (members, lanes) = (Mutex::new(members), Mutex::new(lanes));
        Ok(Self { members, lanes, places, info, most_threads, seconds_of_step: f64::INFINITY })
    }

    /// `&mut self` excludes others: there is nothing to wait for.
    fn members(&mut self) -> &mut Vec<Member> {
        self.members.get_mut().unwrap_or_else(PoisonError::into_inner)
    }

    /// A row for each member.
    fn table<'py>(
        &mut self,
        py: Python<'py>,
        n_columns: usize,
        row: impl Fn(&mut Stepper<'static, Arc<dyn Scene>>, &mut Vec<f64>),
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let members = self.members();
        let mut all = Vec::with_capacity(members.len() * n_columns);
        members.iter_mut().for_each(|member| row(&mut member.stepper, &mut all));
        PyArray1::from_vec(py, all).reshape([members.len(), n_columns])
    }

    /// Indices from indices or a mask.
    fn chosen(&mut self, members: Option<&Bound<'_, PyAny>>) -> PyResult<Vec<usize>> {
        let n = self.members().len();
        let Some(members) = members else { return Ok((0..n).collect()) };
        let is_mask = |mask: &Vec<bool>| mask.len() == n;
        if let Some(mask) = members.extract::<Vec<bool>>().ok().filter(is_mask) {
            return Ok(mask.into_iter().enumerate().filter_map(|(i, is_chosen)| is_chosen.then_some(i)).collect());
        }
        let chosen: Option<Vec<usize>> = members.extract().ok();
        chosen.filter(|chosen| chosen.iter().all(|i| *i < n)).ok_or_else(|| {
            wrong(format!(
                "`members` takes indices from 0 to {}, or {n} times True or False, but was given {members}",
                n - 1
            ))
        })
    }
}

#[pymethods]
impl PyBatch {
    /// Sets inputs by name, each a number or an array with one for each member, takes `n` steps, and returns the times, s.
    ///
    /// A member whose motion cannot go on stays where it is until it is reset: its reason is in `stopped`, and StoppedError is raised once,
    /// when all the others have taken their steps.
    #[pyo3(signature = (n=1, **inputs))]
    fn step<'py>(
        &mut self,
        py: Python<'py>,
        n: u64,
        inputs: Option<&Bound<'py, PyDict>>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        self.set(inputs)?;
        let n_members = self.members().len() as f64;
        let were_stopped = self.members().iter().filter(|member| member.stopped.is_some()).count();
        let mut left = n;
        while left > 0 {
            // a float too large for a whole number is as many as there are
            let worth = (self.seconds_of_step * left as f64 * n_members / LEAST_WORK_S) as usize;
            let n_threads = self.most_threads.min(worth.max(1));
            // all have taken as many steps when a signal comes
            let until_signals = BETWEEN_SIGNALS.as_secs_f64() * n_threads as f64 / (self.seconds_of_step * n_members);
            // in pieces that do not depend on the time, so that lanes always lead to the same bits
            let n = left.min((until_signals as u64 / PIECE * PIECE).clamp(PIECE, LONGEST));
            let began = Instant::now();
            let members = self.members.get_mut().unwrap_or_else(PoisonError::into_inner);
            let lanes = self.lanes.get_mut().unwrap_or_else(PoisonError::into_inner);
            py.detach(|| match lanes.is_empty() {
                true => on_threads(members, n_threads, |member| member.step(n)),
                false => {
                    let mut groups: Vec<_> = lanes.iter_mut().zip(members.chunks_mut(N_LANES)).collect();
                    on_threads(&mut groups, n_threads, |(lanes, members)| step_in_lanes(lanes, members, n));
                }
            });
            self.seconds_of_step = began.elapsed().as_secs_f64() * n_threads as f64 / (n as f64 * n_members);
            left -= n;
            py.check_signals()?;
        }
        let members = self.members();
        let stopped: Vec<(usize, &String)> =
            members.iter().enumerate().filter_map(|(i, member)| Some((i, member.stopped.as_ref()?))).collect();
        if let (Some((i, why)), true) = (stopped.first(), stopped.len() > were_stopped) {
            let text = format!("{} of {} members stopped; member {i}: {why}", stopped.len(), members.len());
            return Err(StoppedError::new_err(text));
        }
        Ok(self.t(py))
    }

    /// Sets inputs by name, each a number or an array with one for each member; none of them where one cannot be set.
    #[pyo3(signature = (**inputs))]
    fn set(&mut self, inputs: Option<&Bound<'_, PyDict>>) -> PyResult<()> {
        let n = self.members().len();
        let of = |(name, values): (String, Values)| {
            if let Some(i) = (0..n).find(|i| !values.at(*i).is_finite()) {
                let value = values.at(i);
                return Err(wrong(format!(
                    "input `{name}` takes finite numbers, but was given {value} for member {i}"
                )));
            }
            Ok((input_index(&self.info, &name).map_err(wrong)?, values))
        };
        let all = numbers_of_members(inputs.map(|all| all.as_mapping()), n)?;
        let all = all.into_iter().map(of).collect::<PyResult<Vec<_>>>()?;
        for (place, values) in all {
            let members = self.members().iter_mut().enumerate();
            members.for_each(|(i, member)| member.stepper.inputs_mut()[place] = values.at(i));
        }
        Ok(())
    }

    /// Brings members back to their starts: all of them, or those of indices or of a mask. start has values by name, each a number or an
    /// array with one for each of these members. Where a member cannot take its start it stays where it is, and the others are reset.
    #[pyo3(signature = (members=None, start=None))]
    fn reset(
        &mut self,
        py: Python<'_>,
        members: Option<&Bound<'_, PyAny>>,
        start: Option<&Bound<'_, PyMapping>>,
    ) -> PyResult<()> {
        let chosen = self.chosen(members)?;
        let start = numbers_of_members(start, chosen.len())?;
        let mut place_of = vec![None; self.members().len()];
        chosen.iter().enumerate().for_each(|(place, i)| place_of[*i] = Some(place));
        let n_threads = self.most_threads;
        let all = self.members().iter_mut().zip(place_of).enumerate();
        let mut all: Vec<_> = all.filter_map(|(i, (member, place))| Some((i, member, place?, Ok(())))).collect();
        // a start that is given is assembled, one that is not is copied
        let n_threads = if start.is_empty() { 1 } else { n_threads };
        py.detach(|| {
            on_threads(&mut all, n_threads, |(_, member, place, outcome)| *outcome = member.reset(&start, *place));
        });
        let failed = all.into_iter().find_map(|(i, _, _, outcome)| Some((i, outcome.err()?)));
        failed.map_or(Ok(()), |(i, error)| Err(wrong(format!("member {i}: {error}"))))
    }

    /// The present values of a coordinate, velocity, output or input, or of the time `t`, by its name: one for each member.
    fn __getitem__<'py>(&mut self, py: Python<'py>, name: &str) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let place = self.places.find(name)?;
        let values = self.members().iter_mut().map(|member| value(&mut member.stepper, place)).collect();
        Ok(PyArray1::from_vec(py, values))
    }

    fn __len__(&mut self) -> usize {
        self.members().len()
    }

    /// Time of each member, s.
    #[getter]
    fn t<'py>(&mut self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_vec(py, self.members().iter().map(|member| member.stepper.state().t).collect())
    }

    /// Coordinates: a row for each member, in the order of `names`.
    #[getter]
    fn q<'py>(&mut self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        self.table(py, self.info.n_coordinates(), |stepper, all| all.extend(&stepper.state().q))
    }

    /// Velocities: a row for each member.
    #[getter]
    fn v<'py>(&mut self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        self.table(py, self.info.n_velocities(), |stepper, all| all.extend(&stepper.state().v))
    }

    /// Outputs, with the present inputs: a row for each member.
    #[getter]
    fn outputs<'py>(&mut self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        self.table(py, self.info.n_outputs(), |stepper, all| all.extend(stepper.outputs()))
    }

    /// Present inputs by name, one for each member.
    #[getter]
    fn inputs<'py>(&mut self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let all = PyDict::new(py);
        for (i, input) in Arc::clone(&self.info).inputs.iter().enumerate() {
            let values = self.members().iter().map(|member| member.stepper.inputs()[i]).collect();
            all.set_item(input.name, PyArray1::from_vec(py, values))?;
        }
        Ok(all)
    }

    /// Names of coordinates, velocities and outputs.
    #[getter]
    fn names(&self) -> BTreeMap<&'static str, Vec<String>> {
        crate::stepper::names(&self.info)
    }

    /// The members whose motion cannot go on, by index, with the reason.
    #[getter]
    fn stopped(&mut self) -> BTreeMap<usize, String> {
        let members = self.members().iter().enumerate();
        members.filter_map(|(i, member)| Some((i, member.stopped.clone()?))).collect()
    }

    fn __repr__(&mut self) -> String {
        format!("<batch of {} steppers of {}/{}>", self.members().len(), self.info.model, self.info.name)
    }
}

impl Member {
    fn step(&mut self, n: u64) {
        if self.stopped.is_none() {
            self.stopped = self.stepper.step(n).err().map(|error| error.to_string());
        }
    }

    /// To its start, with the values at this place if there are any.
    fn reset(&mut self, start: &Numbers, place: usize) -> Result<(), SetupError> {
        if start.is_empty() {
            self.stepper.reset();
        } else {
            let given: Vec<(&str, f64)> = start.iter().map(|(name, of)| (name.as_str(), of.at(place))).collect();
            self.stepper.reset_with(&given)?;
        }
        self.stopped = None;
        Ok(())
    }
}

/// Takes `n` steps of eight members, one after the other where it is not possible at once.
fn step_in_lanes(lanes: &mut EightSteppers<Arc<dyn Scene>>, members: &mut [Member], n: u64) {
    let can_go_on = members.iter().all(|member| member.stopped.is_none());
    let mut left = n;
    while left > 0 {
        let n = left.min(PIECE);
        if !can_go_on || !lanes.step(&mut steppers(members), n) {
            members.iter_mut().for_each(|member| member.step(n));
        }
        left -= n;
    }
}

fn steppers(members: &mut [Member]) -> Vec<&mut Stepper<'static, Arc<dyn Scene>>> {
    members.iter_mut().map(|member| &mut member.stepper).collect()
}

/// Does the work of each item, on so many threads. An item knows nothing of the others: the numbers do not depend on the threads.
fn on_threads<T: Send>(items: &mut [T], n_threads: usize, work: impl Fn(&mut T) + Sync) {
    let n_of_thread = items.len().div_ceil(n_threads.max(1)).max(1);
    let work = &work;
    std::thread::scope(|scope| {
        let mut parts = items.chunks_mut(n_of_thread);
        let own = parts.next();
        parts.for_each(|part| {
            scope.spawn(move || part.iter_mut().for_each(work));
        });
        own.into_iter().flatten().for_each(work);
    });
}
