//! Derivatives of a motion by start values and parameters.

use super::trajectory::Trajectory;
use crate::dynamics::{MotionError, State, System, SystemOf};
use crate::integrate::Method;
use crate::linalg::Backend;
use crate::model::{Equations, Scene, SceneInfo, SceneRef, Start};
use crate::record::find_name;
use crate::scalar::Dual;
use crate::simulate::SetupError;
use std::sync::Arc;

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
pub struct Sensitivities<'s, S: ?Sized, const N: usize> {
    trajectory: Trajectory<SystemOf<'s, S, Dual<N>>, Dual<N>>,
}

/// What a name stands for.
enum Quantity {
    Parameter(usize),
    Position(usize),
    Velocity(usize),
    State(usize),
}

impl<'s, S: Scene + Equations<Dual<N>> + ?Sized, const N: usize> Sensitivities<'s, S, N> {
    /// The run of `scene` from the consistent state that belongs to `start`, with derivatives `by` the named parameters and
    /// given start values. Inputs keep their declared values.
    ///
    /// # Errors
    /// [`SetupError`] when a name is unknown or not given, or when scene, start or method cannot be used: `dop853`, `rk4` and `midpoint`
    /// can, on scenes with a generated elimination.
    pub fn new(scene: &'s S, start: &Start, by: [&str; N], method: Method) -> Result<Self, SetupError> {
        let mut system = System::new(scene, Backend::Generated)?;
        let info = Arc::clone(system.info());
        let State { t, q, v, z, .. } = system.consistent_start(start)?;
        let mut parameters: Vec<Dual<N>> = scene.parameters().into_iter().map(Dual::constant).collect();
        let mut q: Vec<Dual<N>> = q.into_iter().map(Dual::constant).collect();
        let mut v: Vec<Dual<N>> = v.into_iter().map(Dual::constant).collect();
        let mut z: Vec<Dual<N>> = z.into_iter().map(Dual::constant).collect();
        for (direction, name) in by.into_iter().enumerate() {
            let seeded = match quantity(&info, start, name)? {
                Quantity::Parameter(i) => &mut parameters[i],
                Quantity::Position(i) => &mut q[i],
                Quantity::Velocity(i) => &mut v[i],
                Quantity::State(i) => &mut z[i],
            };
            *seeded = Dual::variable(seeded.value, direction);
        }
        let mut fixed: Vec<Dual<N>> = system.fixed().iter().map(|&x| Dual::constant(x)).collect();
        scene.constants(&parameters, &mut fixed);

        let values: Vec<f64> = q.iter().map(|q| q.value).collect();
        let mut residual = vec![Dual::constant(0.0); info.n_rows()];
        let rows = &mut residual[..info.n_position_rows];
        scene.position_constraint(&fixed, Dual::constant(t), &q, rows);
        follow(&mut system, t, &values, rows, &start.q_given, &mut q);
        scene.velocity_constraint(&fixed, Dual::constant(t), &q, &v, &mut residual);
        follow(&mut system, t, &values, &residual, &start.v_given, &mut v);

        let start = State { t, q, v, z, work: Vec::new() };
        Ok(Self { trajectory: Trajectory::new(SystemOf::new(scene, Arc::clone(&info), fixed), info, start, method)? })
    }

    /// Runs on to `until_s`.
    ///
    /// # Errors
    /// [`MotionError`]; [`Sensitivities::state`] is then the last good state.
    pub fn advance(&mut self, until_s: f64) -> Result<(), MotionError> {
        self.trajectory.advance(until_s)
    }

    /// Where the run is, without works.
    pub fn state(&self) -> State {
        let values = |x: &[Dual<N>]| x.iter().map(|x| x.value).collect();
        let State { t, q, v, z, .. } = &self.trajectory.now;
        State { t: *t, q: values(q), v: values(v), z: values(z), work: Vec::new() }
    }

    /// Derivatives of the present state, in the order of the names.
    pub fn tangents(&self) -> [Tangent; N] {
        let State { q, v, z, .. } = &self.trajectory.now;
        std::array::from_fn(|i| {
            let along = |x: &[Dual<N>]| x.iter().map(|x| x.derivatives[i]).collect();
            Tangent { q: along(q), v: along(v), z: along(z) }
        })
    }
}

/// Lets what is not given follow the derivatives of the rows.
fn follow<P: SceneRef, const N: usize>(
    system: &mut System<P>,
    t: f64,
    q: &[f64],
    residual: &[Dual<N>],
    given: &[bool],
    x: &mut [Dual<N>],
) {
    for direction in 0..N {
        let changed: Vec<f64> = residual.iter().map(|row| row.derivatives[direction]).collect();
        let tangent = system.assembly().free_tangent(t, q, &changed, given);
        x.iter_mut().zip(tangent).for_each(|(x, change)| x.derivatives[direction] += change);
    }
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
