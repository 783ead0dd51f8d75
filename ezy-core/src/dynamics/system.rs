//! A scene with its constants, solver and buffers.

use super::SystemError;
use super::active_set::ActiveSet;
use super::counters::Counters;
use super::euclidean::Euclidean;
use super::factors::{Factors, Solver};
use super::geometry::Geometry;
use super::sines::Sines;
use super::tolerances::backend::{FURTHEST_APART, LARGEST_FOR_LIGHT, LIGHTEST, RANGE};
use crate::linalg::{Backend, HAS_SPARSE, KktFactorization, LARGEST_DENSE, SparseKkt, by_joints};
use crate::model::body_kind;
use crate::model::{Equations as _, Name, Scene as _, SceneInfo, SceneRef, Start};
use crate::pages::in_large_pages;
use std::sync::Arc;

/// A scene made ready for computing: inputs, constants, masses, solver and every buffer, allocated once.
///
/// ```text
/// let mut system = System::new(&scene, Backend::Auto)?;
/// let state = system.consistent_start(&system.scene_start())?;
/// system.accelerations(state.t, &state.q, &state.v, &mut a, &mut lambda)?;
/// ```
pub struct System<P: SceneRef> {
    pub(super) scene: P,
    pub(super) info: Arc<SceneInfo>,
    /// What kernels read as `c`: inputs, first-order states, then constants.
    pub(super) fixed: Vec<f64>,
    /// Value, rate and their time of the inputs that a run integrates.
    pub(super) integrated: Vec<[f64; 3]>,
    pub(super) mass: Vec<f64>,
    pub(super) geometry: Geometry,
    pub(super) solver: Solver,
    pub(super) active: ActiveSet,
    pub(super) factors: Factors,
    pub(super) sines: Sines,
    /// Made at the first Euclidean correction.
    pub(super) euclidean: Option<Box<Euclidean>>,
    /// `n_c`.
    pub(super) residual: Vec<f64>,
    pub(super) counters: Counters,
}

impl<P: SceneRef> System<P> {
    /// Checks parameters and masses, computes the constants, chooses the solver.
    ///
    /// # Errors
    /// [`SystemError`] naming the parameter, count or body that cannot be used.
    pub fn new(scene: P, backend: Backend) -> Result<Self, SystemError> {
        let parameters = scene.parameters();
        Self::with_parameters(scene, &parameters, backend)
    }

    /// As [`System::new`], with these parameters in place of those of the scene.
    ///
    /// # Errors
    /// As [`System::new`].
    pub(crate) fn with_parameters(scene: P, parameters: &[f64], backend: Backend) -> Result<Self, SystemError> {
        let Checked { info, fixed, mass, active, start, jacobian, is_out_of_range } =
            Checked::new(&scene, parameters, backend)?;
        let integrated =
            info.integrated_inputs.iter().map(|&i| SceneInfo::integrated_places(i).map(|place| fixed[place])).collect();
        let [n_q, n_v, n_c] = [info.n_coordinates(), info.n_velocities(), info.n_rows()];
        let geometry = Geometry::new(&info, &jacobian, &start);
        let takes_sines = scene.takes_sines();
        let needs_pivots = is_out_of_range || geometry.lightness(&mass) < LIGHTEST;
        let solver = solver(&info, &mass, needs_pivots, backend)?;
        Ok(Self {
            scene,
            geometry,
            active,
            factors: Factors::new([n_q, n_v], n_c, jacobian, matches!(solver, Solver::Generated)),
            solver,
            sines: Sines::new(n_q, takes_sines),
            fixed,
            integrated,
            mass,
            euclidean: None,
            residual: vec![0.0; n_c],
            counters: Counters::new(),
            info,
        })
    }

    /// The scene.
    pub fn scene(&self) -> &P::Target {
        &self.scene
    }

    /// The scene, as this holds it.
    pub(crate) fn scene_ref(&self) -> &P {
        &self.scene
    }

    /// Names and sizes.
    pub fn info(&self) -> &Arc<SceneInfo> {
        &self.info
    }

    /// Inputs, the first-order states that were set last, and everything that depends on parameters alone, to hand to the kernels of the scene as `c`.
    pub fn fixed(&self) -> &[f64] {
        &self.fixed
    }

    /// Present inputs, `n_i`, each in its unit.
    pub(crate) fn inputs(&self) -> &[f64] {
        &self.fixed[..self.info.n_inputs()]
    }

    /// The inputs, to set them; they start with their declared values.
    pub fn inputs_mut(&mut self) -> &mut [f64] {
        if self.info.n_inputs() > 0 {
            self.factors.forget();
        }
        &mut self.fixed[..self.info.n_inputs()]
    }

    /// Sets the first-order states, `n_z`, each in its unit, that all that follows is computed with;
    /// [`System::consistent_start`] sets those of the start.
    ///
    /// # Panics
    /// If `z` has another length.
    #[inline]
    pub fn place_states(&mut self, z: &[f64]) {
        if z.is_empty() && self.info.states.is_empty() {
            return;
        }
        assert_eq!(z.len(), self.info.n_states(), "first-order states of the scene");
        let n_inputs = self.info.n_inputs();
        let present = &mut self.fixed[n_inputs..][..z.len()];
        if present != z {
            present.copy_from_slice(z);
            // no row depends on them, but forces do
            self.factors.ahead.forget();
        }
    }

    /// Rates of the first-order states that were set, in their units over s, at a state; writes `n_z`.
    #[inline]
    pub fn state_rates(&self, t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
        if !out.is_empty() {
            self.scene.state_rates(&self.fixed, t, q, v, out);
        }
    }

    /// q' = N(q) v, the rates of the coordinates: the velocities themselves where all bodies are planar. Writes `n_q`.
    #[inline]
    pub fn position_rates(&self, q: &[f64], v: &[f64], out: &mut [f64]) {
        body_kind::position_rates(&self.info.kinds, q, v, out);
    }

    /// Moves the coordinates `q` by the small displacement `delta` (`n_v`) in the axes of the velocities: q + delta where all bodies are planar.
    #[inline]
    pub fn retract(&self, q: &mut [f64], delta: &[f64]) {
        body_kind::retract(&self.info.kinds, q, delta);
    }

    /// Diagonal of M.
    pub fn mass_matrix(&self) -> &[f64] {
        &self.mass
    }

    /// Length that goes with an angle of one radian, m: the longest lever of a row.
    #[cfg(feature = "analysis")]
    pub(crate) fn length(&self) -> f64 {
        self.geometry.length
    }

    /// Work done so far, and what a method adds.
    pub(crate) fn counters(&mut self) -> &mut Counters {
        &mut self.counters
    }
}

/// What [`System::fixed`] would be of a scene that takes the generated elimination.
///
/// # Errors
/// As [`System::new`].
pub(crate) fn eliminated_constants<P: SceneRef>(scene: P) -> Result<Vec<f64>, SystemError> {
    let Checked { info, fixed, mass, .. } = Checked::new(&scene, &scene.parameters(), Backend::Generated)?;
    solver(&info, &mass, false, Backend::Generated)?;
    Ok(fixed)
}

/// A scene whose parameters and masses can be used, and G at its start.
struct Checked {
    info: Arc<SceneInfo>,
    fixed: Vec<f64>,
    mass: Vec<f64>,
    active: ActiveSet,
    start: Start,
    jacobian: Vec<f64>,
    is_out_of_range: bool,
}

impl Checked {
    fn new<P: SceneRef>(scene: &P, parameters: &[f64], backend: Backend) -> Result<Self, SystemError> {
        let info = scene.info();
        info.check_counts()?;
        for (parameter, &value) in info.parameters.iter().zip(parameters) {
            if !value.is_finite() {
                return Err(SystemError::ParameterNotFinite { name: parameter.name, value });
            }
        }
        let mut fixed = info.declared_values();
        // a row that is off at the start counts for what is measured here
        let active = ActiveSet::new(&info, parameters);
        let of_all_rows = (!info.switches.is_empty()).then(|| active.with_all_rows(&info));
        scene.constants(of_all_rows.as_deref().unwrap_or(parameters), &mut fixed);
        let mut mass = vec![0.0; info.n_velocities()];
        scene.mass_matrix(&fixed, &mut mass);
        if let Some(i) = mass.iter().position(|m| !(m.is_finite() && *m >= 0.0)) {
            let (body, quantity) = body_of(&info, i);
            return Err(SystemError::Mass { body, quantity, value: mass[i] });
        }
        let mut start = Start::free_of(&info);
        scene.start(&fixed, &mut start);
        let mut jacobian = in_large_pages(vec![0.0; info.jacobian.n_nonzeros()]);
        scene.velocity_jacobian(&fixed, start.t, &start.q, &mut jacobian);
        let is_out_of_range = is_out_of_range(&info, &mass, &jacobian);
        if is_out_of_range && backend == Backend::Generated {
            return Err(SystemError::OutOfRange { scene: info.name });
        }
        if of_all_rows.is_some() {
            scene.constants(parameters, &mut fixed);
        }
        Ok(Self { info, fixed, mass, active, start, jacobian, is_out_of_range })
    }
}

/// Whether the generated elimination, which does not scale, leaves the range of doubles or mixes what is too far apart.
fn is_out_of_range(info: &SceneInfo, mass: &[f64], jacobian: &[f64]) -> bool {
    let mut of_rows = vec![0.0_f64; info.n_rows()];
    for (k, row, column) in info.jacobian.entries() {
        let power = jacobian[k].abs() / mass[column].sqrt();
        if mass[column] == 0.0 || power == 0.0 || !power.is_finite() {
            continue;
        }
        if !RANGE.contains(&power) {
            return true;
        }
        of_rows[row] = of_rows[row].max(power);
    }
    let largest = of_rows.iter().fold(0.0_f64, |largest, power| largest.max(*power));
    of_rows.iter().any(|power| *power > 0.0 && largest > FURTHEST_APART * power)
}

fn solver(info: &SceneInfo, mass: &[f64], needs_pivots: bool, backend: Backend) -> Result<Solver, SystemError> {
    let massless = mass.iter().position(|m| *m == 0.0);
    let needs_mass = |backend| match massless {
        None => Ok(()),
        Some(i) => {
            let (body, quantity) = body_of(info, i);
            Err(SystemError::BackendNeedsMass { body, quantity, backend })
        }
    };
    // in scenes with counts the dense solver costs n³ where the sparse one costs n
    let largest = match (info.has_elimination(), massless) {
        (true, _) | (_, Some(_)) => LARGEST_DENSE,
        (false, None) => LARGEST_FOR_LIGHT,
    };
    match backend {
        Backend::Auto if needs_pivots && info.n_unknowns() <= largest => dense(info),
        Backend::Auto if !info.has_elimination() => match massless.map(|i| body_of(info, i)) {
            None => without_elimination(info, mass),
            Some((body, quantity)) => {
                let (n, limit) = (info.n_unknowns(), LARGEST_DENSE);
                Err(SystemError::MasslessInLargeScene { body, quantity, n, limit })
            }
        },
        Backend::Auto if needs_pivots => dense(info),
        Backend::Auto => Ok(Solver::Generated),
        Backend::Dense => dense(info),
        Backend::Generated if !info.has_elimination() => Err(SystemError::NoElimination { scene: info.name }),
        Backend::Generated => needs_mass("generated").map(|()| Solver::Generated),
        Backend::Sparse => needs_mass("sparse").and_then(|()| sparse(info, mass)).map(Solver::Sparse),
    }
}

fn dense(info: &SceneInfo) -> Result<Solver, SystemError> {
    let (n, limit) = (info.n_unknowns(), LARGEST_DENSE);
    if n > limit {
        return Err(SystemError::TooLargeForDense { n, limit });
    }
    Ok(Solver::Dense)
}

/// Sparse factors; without the feature for them the dense solver, as far as it goes.
fn without_elimination(info: &SceneInfo, mass: &[f64]) -> Result<Solver, SystemError> {
    if !HAS_SPARSE && info.n_unknowns() <= LARGEST_DENSE {
        return Ok(Solver::Dense);
    }
    sparse(info, mass).map(Solver::Sparse)
}

/// Factors over blocks of joints where they cost less, else those of K.
pub(super) fn sparse(info: &SceneInfo, mass: &[f64]) -> Result<Box<dyn KktFactorization>, SystemError> {
    if !HAS_SPARSE {
        return Err(SystemError::WithoutSparse { scene: info.name });
    }
    let n_rows = info.n_rows();
    let joints = if info.is_planar() { by_joints(mass, &info.jacobian, n_rows) } else { None };
    Ok(match joints {
        Some(kkt) => kkt,
        None => Box::new(SparseKkt::new(mass, &info.jacobian, n_rows)?),
    })
}

/// The backend that takes a scene without a generated elimination, with which factors and at what cost, or why none can; `None` for a scene that has one.
pub fn described_solver(info: &SceneInfo) -> Option<(Backend, String)> {
    let masses = vec![1.0; info.n_velocities()];
    let describe = || match without_elimination(info, &masses) {
        Ok(Solver::Sparse(kkt)) => (Backend::Sparse, kkt.describe()),
        Ok(_) => (Backend::Dense, format!("null-space method, {} equations", info.n_unknowns())),
        Err(error) => (Backend::Sparse, error.to_string()),
    };
    (!info.has_elimination()).then(describe)
}

/// Body and kind of the mass that stands at entry `i` of the diagonal of M.
fn body_of(info: &SceneInfo, i: usize) -> (Name, &'static str) {
    let velocity = info.velocities.item(i);
    let body = velocity.name.rsplit_once('.').map_or(&*velocity.name, |(body, _)| body);
    (body.to_owned().into(), if velocity.is_angle() { "inertia" } else { "mass" })
}

/// A system of any scene, so that unit tests do not compile the solver for each of fifty types.
#[cfg(test)]
pub(crate) fn system_of<'s>(
    scene: &'s (dyn crate::model::Scene + 's),
    backend: Backend,
) -> Result<System<&'s dyn crate::model::Scene>, SystemError> {
    System::new(scene, backend)
}
