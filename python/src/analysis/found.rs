//! What `ezy_core::analysis` finds.

use super::{Matrix, PyEquilibrium, PyLinearization, Request};
use crate::error::wrong;
use crate::signals::left_to_itself;
use ezy_core::analysis::{Course, Linearization, Rests, Spectrum, SteadyMotion};
use ezy_core::dynamics::System;
use ezy_core::model::{Scene, SceneInfo, Start};
use ezy_core::simulate::Simulation;
use numpy::Complex64;
use pyo3::prelude::*;
use std::sync::Arc;

type Assembled = (System<Arc<dyn Scene>>, Start);

/// Starts of a search for all rests: more take hours.
const MOST_STARTS: usize = 100_000;

impl Request {
    fn assembled(&self) -> PyResult<Assembled> {
        let of = Simulation::new(Arc::clone(&self.scene));
        let of = self.start.iter().fold(of, |of, (name, value)| of.start(name, *value));
        let of = self.inputs.iter().fold(of, |of, (name, value)| of.input(name, *value));
        of.system_at_start().map_err(wrong)
    }

    fn hold(&self) -> Vec<&str> {
        self.hold.iter().map(String::as_str).collect()
    }
}

pub(crate) fn equilibrium(py: Python<'_>, request: Request) -> PyResult<PyEquilibrium> {
    left_to_itself(py, move || {
        let (mut system, start) = request.assembled()?;
        let motion = SteadyMotion::near(&mut system, &start, &request.hold()).map_err(wrong)?;
        Ok(PyEquilibrium::new(&request.scene.info(), &motion))
    })?
}

pub(crate) fn equilibria(py: Python<'_>, request: Request, n_starts: usize) -> PyResult<Vec<PyEquilibrium>> {
    if !(1..=MOST_STARTS).contains(&n_starts) {
        return Err(wrong(format!(
            "`n_starts` takes a whole number from 1 to {MOST_STARTS}, but was given {n_starts}"
        )));
    }
    left_to_itself(py, move || {
        let (mut system, start) = request.assembled()?;
        let rests = Rests::of(&mut system, &start, &request.hold(), n_starts).map_err(wrong)?;
        let info = request.scene.info();
        Ok(rests.found.iter().map(|rest| PyEquilibrium::new(&info, &rest.motion)).collect())
    })?
}

pub(crate) fn linearize(py: Python<'_>, request: Request) -> PyResult<PyLinearization> {
    let (motion, linear, spectrum) = left_to_itself(py, move || {
        let (mut system, start) = request.assembled()?;
        let motion = SteadyMotion::near(&mut system, &start, &request.hold()).map_err(wrong)?;
        let linear = Linearization::of(&mut system, &motion).map_err(wrong)?;
        let spectrum = linear.spectrum().map_err(wrong)?;
        Ok::<_, PyErr>((motion, linear, spectrum))
    })??;
    PyLinearization::new(py, &motion, &linear, &spectrum)
}

/// Names of coordinates, velocities and first-order states.
fn names(info: &SceneInfo) -> impl Iterator<Item = String> {
    let moving = info.coordinates.iter().chain(&*info.velocities).map(|c| c.name.to_string());
    moving.chain(info.states.iter().map(|state| state.name.to_owned()))
}

impl PyEquilibrium {
    fn new(info: &SceneInfo, motion: &SteadyMotion) -> Self {
        let state = &motion.state;
        let values = state.q.iter().chain(&state.v).chain(&state.z).copied();
        let rows = info.rows.iter().map(|row| row.name.to_string());
        let frame = motion.frame;
        Self {
            scene: format!("{}/{}", info.model, info.name),
            state: names(info).zip(values).collect(),
            n: [info.n_coordinates(), info.n_velocities()],
            multipliers: rows.zip(motion.multipliers.iter().copied()).collect(),
            kind: match motion.course() {
                Course::Rest => "rest",
                Course::InPlace => "in place",
                Course::Straight { .. } => "straight",
                Course::Circle { .. } => "circle",
            },
            frame: [frame.vx, frame.vy, frame.omega],
            free: motion.free.iter().map(|name| name.to_string()).collect(),
        }
    }
}

/// Any matrix of the analysis, by its shape and its entries.
fn matrix(shape: (usize, usize), entry: impl Fn(usize, usize) -> f64) -> Matrix {
    let (n_rows, n_columns) = shape;
    let entry = &entry;
    let numbers = (0..n_rows).flat_map(|i| (0..n_columns).map(move |j| entry(i, j))).collect();
    Matrix { shape: shape.into(), numbers }
}

impl PyLinearization {
    fn new(py: Python<'_>, motion: &SteadyMotion, linear: &Linearization, spectrum: &Spectrum) -> PyResult<Self> {
        let info = linear.info();
        let [a, b, c, d, basis] =
            [&linear.a, &linear.b, &linear.c, &linear.d, &linear.basis].map(|of| matrix(of.shape(), |i, j| of[(i, j)]));
        let inputs = linear.inputs.iter().map(|name| (*name).to_owned()).collect();
        let outputs = info.outputs.iter().map(|output| output.name.to_string()).collect();
        Ok(Self {
            equilibrium: Py::new(py, PyEquilibrium::new(info, motion))?,
            names: [names(info).collect(), inputs, outputs],
            eigenvalues: spectrum.eigenvalues.iter().map(|s| Complex64::new(s.re, s.im)).collect(),
            n_zero: spectrum.n_zero,
            n_unstable: spectrum.n_unstable(),
            a,
            b,
            c,
            d,
            basis,
        })
    }
}
