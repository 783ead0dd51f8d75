//! Derivatives of a motion by start values and parameters.

use super::trajectory::Trajectory;
#[cfg(feature = "analysis")]
use crate::dynamics::SystemError;
use crate::dynamics::{
    Dynamics as _, Kernels, MotionError, Projecting, State, System, SystemOf, SystemWithDerivatives,
};
use crate::integrate::Method;
use crate::linalg::Backend;
#[cfg(feature = "analysis")]
use crate::model::{Derived as _, N_DERIVATIVES};
use crate::model::{Equations, Scene, SceneInfo, SceneRef, Start};
use crate::record::find_name;
use crate::scalar::Dual;
use crate::simulate::SetupError;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// Derivatives of a state by one quantity.
#[derive(Debug, Clone, PartialEq)]
pub struct Tangent {
    /// Of the coordinates, `n_q`.
    pub q: Vec<f64>,
    /// Of the velocities, `n_q`.
    pub v: Vec<f64>,
    /// Of the first-order states, `n_z`.
    pub z: Vec<f64>,
}

/// A run that carries the derivatives of its state by `N` quantities: start values and parameters, by name.
///
/// The rows hold for the derivatives, too: a start value or parameter moves what the start does not give, in the way of the
/// rows, and as little as possible in the mass matrix where the rows leave a choice. Start values stay as they are when a
/// parameter changes.
///
/// The derivatives are those of the computed motion with its steps held, so their error is that of the motion.
///
/// ```
/// use ezy_core::prelude::*;
/// # ezy_core::model! {
/// #     model Cart {
/// #         param m: kg = 2;
/// #         param f: N = 3;
/// #         body cart { mass: m, inertia: 1 }
/// #         effect push { force at cart(0, 0): (f, 0); }
/// #         start home { cart at (0, 0) angle 0; cart velocity (1, 0) rate 0; }
/// #         scene run { start home; until 2 s; with push; }
/// #     }
/// # }
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let scene = cart::Run::default();
/// let start = System::new(&scene, Backend::Auto)?.scene_start();
/// let mut run = Sensitivities::new(&scene, &start, ["f", "cart.vx"], Method::dop853(1e-12))?;
/// run.advance(2.0)?;
/// let [by_force, by_speed] = run.tangents();
/// assert!((by_force.q[0] - 1.0).abs() < 1e-10); // t² / (2 m)
/// assert!((by_speed.q[0] - 2.0).abs() < 1e-10); // t
/// # Ok(())
/// # }
/// ```
pub struct Sensitivities<'s, const N: usize> {
    run: Box<dyn Carrying<N> + 's>,
}

/// A run with derivatives, whatever solves its equations.
trait Carrying<const N: usize> {
    fn advance_unless(&mut self, until_s: f64, is_over: &AtomicBool) -> Result<(), MotionError>;
    fn now(&self) -> &State<Dual<N>>;
}

impl<D: Projecting<Dual<N>>, const N: usize> Carrying<N> for Trajectory<D, Dual<N>> {
    fn advance_unless(&mut self, until_s: f64, is_over: &AtomicBool) -> Result<(), MotionError> {
        self.advance_unless(until_s, is_over)
    }

    fn now(&self) -> &State<Dual<N>> {
        &self.now
    }
}

/// What a name stands for.
enum Quantity {
    Parameter(usize),
    Position(usize),
    Velocity(usize),
    State(usize),
}

impl<'s, const N: usize> Sensitivities<'s, N> {
    /// The run of `scene` from the consistent state that belongs to `start`, with derivatives `by` the named parameters and
    /// given start values. Inputs keep their declared values.
    ///
    /// # Errors
    /// [`SetupError`] when a name is unknown or not given, or when scene, start or method cannot be used: `dop853`, `rk4` and `midpoint` can.
    /// # Cost
    /// With a generated elimination about that of N single runs, else of two times as many.
    pub fn new<S: Scene + Equations<Dual<N>>>(
        scene: &'s S,
        start: &Start,
        by: [&str; N],
        method: Method,
    ) -> Result<Self, SetupError> {
        let system = System::new(scene, Backend::Auto)?;
        let is_eliminated = system.uses_elimination();
        let (system, info, start) = at_start(system, |scene| *scene, start, &by)?;
        if !is_eliminated {
            return Self::of(system, info, start, method);
        }
        let (system, fixed) = system.into_parts();
        let system = SystemOf::new(scene, &system, fixed);
        Self::of(system, info, start, method)
    }

    fn of(
        system: impl Projecting<Dual<N>> + 's,
        info: Arc<SceneInfo>,
        start: State<Dual<N>>,
        method: Method,
    ) -> Result<Self, SetupError> {
        Ok(Self { run: Box::new(Trajectory::new(system, info, start, method)?) })
    }

    /// Runs on to `until_s`.
    ///
    /// # Errors
    /// [`MotionError`]; [`Sensitivities::state`] is then the last good state.
    pub fn advance(&mut self, until_s: f64) -> Result<(), MotionError> {
        self.advance_unless(until_s, &AtomicBool::new(false))
    }

    /// The same, unless `is_over` is set on the way: the state is then that of the last step.
    ///
    /// # Errors
    /// As [`Sensitivities::advance`].
    pub fn advance_unless(&mut self, until_s: f64, is_over: &AtomicBool) -> Result<(), MotionError> {
        self.run.advance_unless(until_s, is_over)
    }

    /// Where the run is, without works.
    pub fn state(&self) -> State {
        let values = |x: &[Dual<N>]| x.iter().map(|x| x.value).collect();
        let State { t, q, v, z, .. } = self.run.now();
        State { t: *t, q: values(q), v: values(v), z: values(z), work: Vec::new() }
    }

    /// Derivatives of the present state, in the order of the names.
    pub fn tangents(&self) -> [Tangent; N] {
        let State { q, v, z, .. } = self.run.now();
        std::array::from_fn(|i| {
            let along = |x: &[Dual<N>]| x.iter().map(|x| x.derivatives[i]).collect();
            Tangent { q: along(q), v: along(v), z: along(z) }
        })
    }
}

#[cfg(feature = "analysis")]
impl<'s> Sensitivities<'s, N_DERIVATIVES> {
    /// The run of the scene of `system`, with its inputs, from the consistent state that belongs to `start`
    /// ([`Simulation::system_at_start`](super::super::Simulation::system_at_start)), by at most [`N_DERIVATIVES`] quantities; further derivatives are
    /// zero. For a scene whose type is not known where it is run.
    ///
    /// # Errors
    /// As [`Sensitivities::new`]; [`SetupError::TooManyDerivatives`], and [`SystemError::WithoutDerivatives`] for a scene whose kernels run on `f64`
    /// alone.
    pub fn of_scene<P: SceneRef + 's>(
        system: System<P>,
        start: &Start,
        by: &[&str],
        method: Method,
    ) -> Result<Self, SetupError> {
        if system.scene().with_derivatives().is_none() {
            return Err(SystemError::WithoutDerivatives { scene: system.info().name }.into());
        }
        if by.len() > N_DERIVATIVES {
            return Err(SetupError::TooManyDerivatives { n: by.len(), limit: N_DERIVATIVES });
        }
        let kernels: Kernels<P, N_DERIVATIVES> = |scene| scene.with_derivatives().expect("seen above");
        let (system, info, start) = at_start(system, kernels, start, by)?;
        Self::of(system, info, start, method)
    }
}

/// A system and a state that carry the derivatives by what is named.
type AtStart<P, const N: usize> = (SystemWithDerivatives<P, N>, Arc<SceneInfo>, State<Dual<N>>);

fn at_start<P: SceneRef, const N: usize>(
    mut system: System<P>,
    kernels: Kernels<P, N>,
    start: &Start,
    by: &[&str],
) -> Result<AtStart<P, N>, SetupError> {
    let info = Arc::clone(system.info());
    let State { t, q, v, z, .. } = system.consistent_start(start)?;
    let constant = |values: Vec<f64>| values.into_iter().map(Dual::constant).collect::<Vec<_>>();
    let [mut parameters, mut q, mut v, mut z] = [system.scene().parameters(), q, v, z].map(constant);
    for (direction, name) in by.iter().enumerate() {
        let seeded = match quantity(&info, start, name)? {
            Quantity::Parameter(i) => &mut parameters[i],
            Quantity::Position(i) => &mut q[i],
            Quantity::Velocity(i) => &mut v[i],
            Quantity::State(i) => &mut z[i],
        };
        *seeded = Dual::variable(seeded.value, direction);
    }
    let mut system = SystemWithDerivatives::new(system, kernels, &parameters);
    system.place_states(&z);
    let of_state = Start { t, ..start.clone() };
    let follows = system.follow_rows(&of_state, &mut q, &mut v);
    follows.map_err(|direction| SetupError::HeldByStart { name: by[direction].to_owned() })?;
    Ok((system, info, State { t, q, v, z, work: Vec::new() }))
}

fn quantity(info: &SceneInfo, start: &Start, name: &str) -> Result<Quantity, SetupError> {
    let parameters = info.parameters.iter().map(|parameter| parameter.name);
    let positions = info.coordinates.iter().map(|c| &*c.name);
    let velocities = info.velocities.iter().map(|c| &*c.name);
    let states = info.states.iter().map(|state| state.name);
    let i = find_name("parameter or start value", name, parameters.chain(positions).chain(velocities).chain(states))?;
    let Some(i) = i.checked_sub(info.parameters.len()) else { return Ok(Quantity::Parameter(i)) };
    let n_q = info.n_coordinates();
    if let Some(i) = i.checked_sub(n_q + info.n_velocities()) {
        return Ok(Quantity::State(i));
    }
    let (quantity, given, name) = match i.checked_sub(n_q) {
        None => (Quantity::Position(i), start.q_given[i], &info.coordinates[i].name),
        Some(i) => (Quantity::Velocity(i), start.v_given[i], &info.velocities[i].name),
    };
    if given { Ok(quantity) } else { Err(SetupError::NotGiven { name: name.clone() }) }
}
