//! Several runs of one scene that step together.

use super::eight_runs::EightRuns;
use crate::dynamics::{MotionError, State, System, eliminated_constants};
use crate::integrate::Method;
use crate::linalg::Backend;
use crate::model::{N_LANES, Scene};
use crate::simulate::SetupError;

/// `L` runs of one scene, up to eight, with their own parameters and starts, in lanes: one pass through the equations advances all
/// of them. Steps are shared; those of `dop853` keep to the tolerance in every run. Positions and velocities obey the rows
/// behind each step. With `rk4` a run has the numbers that it has by itself, to rounding.
///
/// Fewer than eight runs cost as much as eight, in the vector registers that the machine has; `dop853` takes equations in quasi-velocities where the scene has them. On an x86-64 processor without AVX2 they are computed one after the other, and allocate.
///
/// ```
/// use ezy_core::prelude::*;
/// # ezy_core::model! {
/// #     model Pendulum {
/// #         param l: m = 0.5;
/// #         param g: m/s^2 = 9.81;
/// #         body bob { mass: 1, inertia: 0.01 }
/// #         hinge pivot: ground(0, 0) ~ bob(0, l);
/// #         effect weight { gravity (0, -g); }
/// #         start raised { bob angle 0.5; at rest; }
/// #         scene swing { start raised; until 2 s; with weight; }
/// #     }
/// # }
/// # use pendulum::Swing;
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let scenes: [Swing; 4] = std::array::from_fn(|i| Swing { l: 0.5 + 0.1 * i as f64, ..Swing::default() });
/// let mut starts = Vec::new();
/// for scene in &scenes {
///     let mut system = System::new(scene, Backend::Auto)?;
///     starts.push(system.consistent_start(&system.scene_start())?);
/// }
/// let mut ensemble = Ensemble::<_, 4>::new(&scenes, std::array::from_fn(|i| &starts[i]), Method::rk4(1e-3))?;
/// ensemble.advance(2.0)?;
/// println!("{:?}", ensemble.state(3).q);
/// # Ok(())
/// # }
/// ```
pub struct Ensemble<'s, S, const L: usize> {
    runs: EightRuns<&'s S>,
}

impl<'s, S: Scene, const L: usize> Ensemble<'s, S, L> {
    /// The runs of `scenes`, at most eight, from `starts`, which meet the rows and have one time. Inputs keep their declared values.
    ///
    /// # Errors
    /// [`SetupError`] when a scene, a start or the method cannot be used: `dop853`, `rk4` and `midpoint` can, on scenes with a generated
    /// elimination.
    pub fn new(scenes: &'s [S; L], starts: [&State; L], method: Method) -> Result<Self, SetupError> {
        const { assert!(0 < L && L <= N_LANES, "an ensemble has one to eight runs") };
        if let Some(other) = starts.iter().find(|start| start.t != starts[0].t) {
            return Err(SetupError::DifferentTimes { first: starts[0].t, other: other.t });
        }
        let first = System::new(&scenes[0], Backend::Generated)?;
        let others = scenes[1..].iter().map(eliminated_constants);
        let others: Vec<Vec<f64>> = others.collect::<Result<_, _>>()?;
        let info = first.info();
        if let Some(start) = starts.iter().find(|start| start.z.len() != info.n_states()) {
            return Err(SetupError::StartLength { expected: info.n_states(), found: start.z.len() });
        }
        let expected = [info.n_coordinates(), info.n_velocities()];
        let lengths = starts.iter().flat_map(|start| [start.q.len(), start.v.len()].into_iter().zip(expected));
        if let Some((found, expected)) = lengths.into_iter().find(|(n, expected)| n != expected) {
            return Err(SetupError::StartLength { expected, found });
        }
        let fixed: Vec<&[f64]> = std::iter::once(first.fixed()).chain(others.iter().map(Vec::as_slice)).collect();
        Ok(Self { runs: EightRuns::new(&scenes[0], &first, &fixed, &starts, method)? })
    }

    /// Steps all runs to `until_s`; nothing happens when they are there already.
    ///
    /// # Errors
    /// [`MotionError`] of any run; [`Ensemble::state`] is then the last good state.
    pub fn advance(&mut self, until_s: f64) -> Result<(), MotionError> {
        self.runs.advance(until_s)
    }

    /// Present time, s.
    pub fn time(&self) -> f64 {
        self.runs.time()
    }

    /// Where run `lane` is, without works.
    ///
    /// # Panics
    /// When there is no such run.
    pub fn state(&self, lane: usize) -> State {
        assert!(lane < L, "an ensemble of {L} runs has no run {lane}");
        self.runs.state(lane)
    }
}
