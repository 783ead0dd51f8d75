//! Equilibria of scenes, and the linear equations about them.

#[cfg(feature = "analysis")]
mod found;

use crate::error::wrong;
use crate::inputs::numbers;
use ezy_core::model::Scene;
use ezy_core::record::find_name;
#[cfg(feature = "analysis")]
pub(crate) use found::{equilibria, equilibrium, linearize};
use numpy::{Complex64, PyArray1, PyArray2, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyMapping;
use std::collections::BTreeMap;
use std::sync::Arc;
#[cfg(not(feature = "analysis"))]
pub(crate) use without::{equilibria, equilibrium, linearize, missing};

/// What is asked for of a scene.
#[cfg_attr(not(feature = "analysis"), expect(dead_code, reason = "what is asked for is refused"))]
pub(crate) struct Request {
    scene: Arc<dyn Scene>,
    start: Vec<(String, f64)>,
    inputs: Vec<(String, f64)>,
    hold: Vec<String>,
}

impl Request {
    pub(crate) fn new(
        scene: &Arc<dyn Scene>,
        start: Option<&Bound<'_, PyMapping>>,
        inputs: Option<&Bound<'_, PyMapping>>,
        hold: Vec<String>,
    ) -> PyResult<Self> {
        let info = scene.info();
        let known = info.coordinates.iter().chain(&*info.velocities).map(|c| &*c.name);
        let known = known.chain(info.states.iter().map(|state| state.name));
        hold.iter().try_for_each(|name| find_name("start value", name, known.clone()).map(|_| ())).map_err(wrong)?;
        Ok(Self { scene: Arc::clone(scene), start: numbers(start)?, inputs: numbers(inputs)?, hold })
    }
}

/// Rest, or motion that is constant seen from a frame that travels and turns evenly.
#[pyclass(frozen, name = "Equilibrium", module = "ezy")]
pub(crate) struct PyEquilibrium {
    scene: String,
    /// Names and values of coordinates, velocities and first-order states.
    state: Vec<(String, f64)>,
    n: [usize; 2],
    multipliers: Vec<(String, f64)>,
    kind: &'static str,
    frame: [f64; 3],
    free: Vec<String>,
}

#[pymethods]
impl PyEquilibrium {
    /// The value of a coordinate, velocity or first-order state by its name.
    fn __getitem__(&self, name: &str) -> PyResult<f64> {
        let names = self.state.iter().map(|(name, _)| name.as_str());
        Ok(self.state[find_name("name", name, names).map_err(wrong)?].1)
    }

    /// Coordinates.
    #[getter]
    fn q<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        self.values(py, 0, self.n[0])
    }

    /// Velocities.
    #[getter]
    fn v<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        self.values(py, self.n[0], self.n[1])
    }

    /// Coordinates, velocities and first-order states by name.
    #[getter]
    fn state(&self) -> BTreeMap<&str, f64> {
        self.state.iter().map(|(name, value)| (name.as_str(), *value)).collect()
    }

    /// Multipliers by the names of their rows.
    #[getter]
    fn multipliers(&self) -> BTreeMap<&str, f64> {
        self.multipliers.iter().map(|(name, value)| (name.as_str(), *value)).collect()
    }

    /// Kind of the motion: "rest", "in place" where parts turn and no body moves on, "straight" or "circle"; see `frame`.
    #[getter]
    fn kind(&self) -> &'static str {
        self.kind
    }

    /// Velocity of the frame in which it rests, at the origin along x and y, m/s, and its rate of turn, rad/s.
    #[getter]
    fn frame(&self) -> (f64, f64, f64) {
        self.frame.into()
    }

    /// Coordinates, velocities and states in which the equilibria next to it differ; hold names some.
    #[getter]
    fn free(&self) -> Vec<&str> {
        self.free.iter().map(String::as_str).collect()
    }

    fn __repr__(&self) -> String {
        let values: Vec<String> = self.state[..self.n[0]].iter().map(|(name, x)| format!("{name}={x:.6}")).collect();
        format!("<equilibrium of {}, {}: {}>", self.scene, self.kind, values.join(", "))
    }
}

impl PyEquilibrium {
    fn values<'py>(&self, py: Python<'py>, first: usize, n: usize) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_vec(py, self.state[first..][..n].iter().map(|(_, value)| *value).collect())
    }
}

/// A matrix: its shape, and its numbers row after row.
struct Matrix {
    shape: [usize; 2],
    numbers: Vec<f64>,
}

impl Matrix {
    fn array<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        PyArray1::from_slice(py, &self.numbers).reshape(self.shape)
    }
}

/// The linear equations x' = A x + B u, y = C x + D u of small deviations from an equilibrium.
///
/// x are coordinates of the tangent space of the constraints: the deviations of what `names` lists are `basis` x, seen from the frame of the
/// equilibrium.
#[pyclass(frozen, name = "Linearization", module = "ezy")]
pub(crate) struct PyLinearization {
    equilibrium: Py<PyEquilibrium>,
    a: Matrix,
    b: Matrix,
    c: Matrix,
    d: Matrix,
    basis: Matrix,
    names: [Vec<String>; 3],
    eigenvalues: Vec<Complex64>,
    n_zero: usize,
    n_unstable: usize,
}

#[pymethods]
#[expect(non_snake_case, reason = "the matrices have these names in Python")]
impl PyLinearization {
    /// What it deviates from.
    #[getter]
    fn equilibrium(&self, py: Python<'_>) -> Py<PyEquilibrium> {
        self.equilibrium.clone_ref(py)
    }

    /// A, 1/s: a row and a column for each x.
    #[getter]
    fn A<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        self.a.array(py)
    }

    /// B: a column for each of `inputs`.
    #[getter]
    fn B<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        self.b.array(py)
    }

    /// C: a row for each of `outputs`.
    #[getter]
    fn C<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        self.c.array(py)
    }

    /// D: a row for each of `outputs` and a column for each of `inputs`.
    #[getter]
    fn D<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        self.d.array(py)
    }

    /// A row for each of `names`, and a column for each x; the columns are orthonormal.
    #[getter]
    fn basis<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        self.basis.array(py)
    }

    /// Coordinates, velocities and first-order states.
    #[getter]
    fn names(&self) -> &[String] {
        &self.names[0]
    }

    /// Names of the inputs u.
    #[getter]
    fn inputs(&self) -> &[String] {
        &self.names[1]
    }

    /// Names of the outputs y.
    #[getter]
    fn outputs(&self) -> &[String] {
        &self.names[2]
    }

    /// Eigenvalues of A that are not zero, 1/s, by falling real part; of a pair the one with the positive imaginary part first.
    #[getter]
    fn eigenvalues<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<Complex64>> {
        PyArray1::from_slice(py, &self.eigenvalues)
    }

    /// How many eigenvalues of A are zero.
    #[getter]
    fn n_zero(&self) -> usize {
        self.n_zero
    }

    /// How many eigenvalues have a positive real part.
    #[getter]
    fn n_unstable(&self) -> usize {
        self.n_unstable
    }

    fn __repr__(&self) -> String {
        let [n, n_inputs] = self.b.shape;
        let scene = &self.equilibrium.get().scene;
        format!("<linear equations of {scene}: {n} states, {n_inputs} inputs, {} outputs>", self.c.shape[0])
    }
}

/// Without the feature, how to get it.
#[cfg(not(feature = "analysis"))]
mod without {
    use super::{PyEquilibrium, PyLinearization, Request, wrong};
    use pyo3::prelude::*;

    /// What the features do not have.
    pub(crate) fn missing() -> PyErr {
        wrong(
            "this module was built without analysis; add it to the features of ezy-python in Cargo.toml: \
             ezy-python = { …, features = [\"analysis\"] }",
        )
    }

    pub(crate) fn equilibrium(_: Python<'_>, _: Request) -> PyResult<PyEquilibrium> {
        Err(missing())
    }

    pub(crate) fn equilibria(_: Python<'_>, _: Request, _: usize) -> PyResult<Vec<PyEquilibrium>> {
        Err(missing())
    }

    pub(crate) fn linearize(_: Python<'_>, _: Request) -> PyResult<PyLinearization> {
        Err(missing())
    }
}
