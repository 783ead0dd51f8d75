//! Steppers of one scene that step together.

use super::trajectory::Trajectory;
use crate::dynamics::{InLanes, Metric, Projection, Rows, State, SystemOf};
use crate::integrate::MethodKind;
use crate::model::{Derived as _, Eight, EventKind, N_LANES, SceneRef};
use crate::scalar::{Lanes, packed};
use crate::simulate::Stepper;
use crate::simulate::tolerances::singular::TOO_NEAR;
use std::array::from_fn;
use std::sync::Arc;

/// Takes steps of one to eight steppers of one scene at once, in the vector registers of the machine. They have their own parameters, inputs, starts
/// and times, and one step length.
///
/// Their numbers are those of single steppers but for what projections leave, 1e-12 of the size of a row. What it cannot do together it leaves undone, so that they step by themselves: where
/// a motion comes close to a singular position, or cannot be continued.
///
/// ```
/// use ezy_core::prelude::*;
/// # ezy_core::model! {
/// #     model Pendulum {
/// #         param l: m = 0.5;
/// #         body bob { mass: 1, inertia: 0.01 }
/// #         hinge pivot: ground(0, 0) ~ bob(0, l);
/// #         gravity (0, -9.81);
/// #         start raised { bob angle 0.5; at rest; }
/// #         scene swing { start raised; until 2 s; }
/// #     }
/// # }
/// # use pendulum::Swing;
/// let scenes: Vec<Swing> = (0..8).map(|i| Swing { l: 0.5 + 0.1 * f64::from(i) }).collect();
/// let steppers = scenes.iter().map(|scene| Simulation::new(scene).method(Method::rk4(1e-3)).stepper());
/// let mut steppers = steppers.collect::<Result<Vec<_>, _>>()?;
/// let mut all: Vec<_> = steppers.iter_mut().collect();
/// let mut together = EightSteppers::new(&mut all)?;
/// if !together.step(&mut all, 100) {
///     all.iter_mut().try_for_each(|stepper| stepper.step(100))?;
/// }
/// assert_eq!(steppers[7].state().t, 0.1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct EightSteppers<P: SceneRef> {
    trajectory: Trajectory<SystemOf<InLanes<P>, Eight>, Eight>,
    n: usize,
    step_s: f64,
    /// The largest of the smallest pivots: those of the lanes at their starts, and of all lanes in a step.
    pivot: f64,
}

/// Why steppers cannot step together.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("the steppers cannot step in lanes: {0}")]
pub struct NotTogether(&'static str);

impl<P: SceneRef> EightSteppers<P> {
    /// Of one to eight steppers.
    ///
    /// # Errors
    /// [`NotTogether`]: with another method than `rk4`, other projections than the usual ones, works, laws or tables of inputs; and in scenes without
    /// a generated elimination, with first-order states or integrated inputs, and where something on the way has to be located.
    pub fn new(steppers: &mut [&mut Stepper<'_, P>]) -> Result<Self, NotTogether> {
        let pivot = |Stepper { stepper, .. }: &mut &mut Stepper<'_, P>| {
            let State { t, q, .. } = &stepper.now.state;
            stepper.system.at_with(*t, q, Rows::Held).smallest_pivot()
        };
        let pivot = steppers.iter_mut().map(pivot).fold(0.0, f64::max);
        let first = steppers.first().ok_or(NotTogether("there are none"))?;
        let (info, system) = (Arc::clone(first.info()), &first.stepper.system);
        let is_alike = |stepper: &&mut Stepper<'_, P>| {
            let (other, solver) = (stepper.info(), &stepper.solver);
            let is_usual = (solver.projection, solver.metric) == (Projection::default(), Metric::default());
            let is_same = other.identity() == info.identity();
            let is_rk4 = solver.method.kind() == MethodKind::Rk4 && stepper.step_s == first.step_s;
            is_same && is_usual && is_rk4 && !stepper.stepper.work && stepper.stepper.system.uses_elimination()
        };
        let reasons = [
            (steppers.len() > N_LANES, "they are more than eight"),
            (system.scene().in_lanes().is_none(), "the scene has no elimination of its own"),
            (!info.switches.is_empty(), "its constraints change"),
            (info.events.iter().any(|event| event.kind != EventKind::Mark), "something on the way has to be located"),
            (!info.states.is_empty(), "it has first-order states"),
            (!info.integrated_inputs.is_empty(), "its inputs are integrated"),
            (!steppers.iter().all(|stepper| stepper.control.is_idle()), "their inputs change by themselves"),
            (
                !steppers.iter().all(is_alike),
                "they are not of one scene, by rk4 with one step and the usual projections",
            ),
        ];
        if let Some((_, why)) = reasons.into_iter().find(|(holds, _)| *holds) {
            return Err(NotTogether(why));
        }
        let of_lane = |lane: usize| &steppers[lane.min(steppers.len() - 1)].stepper.system;
        let fixed = packed(from_fn(|lane| of_lane(lane).fixed()));
        let kernels = SystemOf::new(InLanes(system.scene_ref().clone()), system, fixed);
        let start = State::zeros([info.n_coordinates(), info.n_velocities()], 0, 0);
        let trajectory = Trajectory::new(kernels, info, start, first.solver.method);
        let trajectory = trajectory.map_err(|_| NotTogether("the method does not step in lanes"))?;
        Ok(Self { trajectory, n: steppers.len(), step_s: first.step_s, pivot })
    }

    /// Takes `n` steps of the steppers that this was made of, in their order, or leaves them where they are and returns false. The same calls
    /// lead to the same bits.
    ///
    /// # Cost
    /// Four evaluations of the accelerations and the projections a step, for all eight; no allocation.
    pub fn step(&mut self, steppers: &mut [&mut Stepper<'_, P>], n: u64) -> bool {
        if steppers.len() != self.n || !self.gather(steppers) {
            return false;
        }
        for i in 0..n {
            // times are those of single steppers, whatever was stepped at once before
            let times: [f64; N_LANES] = from_fn(|lane| steppers[lane.min(self.n - 1)].time_after(i));
            let Self { trajectory, step_s, pivot, .. } = self;
            trajectory.system.ahead_s = Lanes(times);
            trajectory.system.smallest_pivot = f64::INFINITY;
            trajectory.now.t = 0.0;
            let outcome = trajectory.step(*step_s, *step_s);
            let smallest = trajectory.system.smallest_pivot;
            // one bound for all lanes: that of the one whose rows are farthest apart
            if outcome.is_err() || smallest < TOO_NEAR * *pivot {
                return false;
            }
            *pivot = pivot.max(smallest);
        }
        let now = &self.trajectory.now;
        for (lane, stepper) in steppers.iter_mut().enumerate() {
            stepper.go_on(n, self.pivot, |q, v| {
                q.iter_mut().zip(&now.q).for_each(|(q, eight)| *q = eight.0[lane]);
                v.iter_mut().zip(&now.v).for_each(|(v, eight)| *v = eight.0[lane]);
            });
        }
        true
    }

    /// Takes over where the steppers are, and their inputs; fewer than eight fill the rest with the last one. False where they are not those that
    /// this was made of, or one has stopped within a step.
    fn gather(&mut self, steppers: &[&mut Stepper<'_, P>]) -> bool {
        self.trajectory.restart();
        let Trajectory { system, now, .. } = &mut self.trajectory;
        for lane in 0..N_LANES {
            let stepper = &steppers[lane.min(steppers.len() - 1)];
            let (State { t, q, v, .. }, fixed) = (stepper.state(), stepper.stepper.system.fixed());
            let n_inputs = stepper.inputs().len();
            let is_same = fixed.len() == system.fixed.len()
                && system.fixed[n_inputs..].iter().zip(&fixed[n_inputs..]).all(|(eight, one)| eight.0[lane] == *one);
            if !is_same || *t != stepper.time_after(0) {
                return false;
            }
            now.q.iter_mut().zip(q).for_each(|(eight, q)| eight.0[lane] = *q);
            now.v.iter_mut().zip(v).for_each(|(eight, v)| eight.0[lane] = *v);
            system.fixed.iter_mut().zip(stepper.inputs()).for_each(|(eight, input)| eight.0[lane] = *input);
        }
        true
    }
}
