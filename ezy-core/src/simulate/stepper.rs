//! A scene that the caller steps: for controllers, learning programs and animation.

use super::checkpoint::{Checkpoint, CheckpointError, Origin};
use super::inputs::control::{Control, check_inputs};
use super::stepping::solver::Solver;
use super::stepping::starts::Starts;
use super::stepping::stepper_state::StepperState;
use super::{Inputs, InputsGuard, Now, SetupError};
use crate::archive::Archive;
use crate::archive::LARGEST_COUNT;
use crate::dynamics::{MotionError, Solved, State, state_not_finite};
use crate::model::{NamedScene, SceneInfo, SceneRef};
use crate::record::EnergyState;
use std::sync::Arc;

/// A scene with its state and inputs, made by [`Simulation::stepper`](super::Simulation::stepper).
///
/// It gives the numbers of a run with the same step, repeats to the bit, and allocates nothing in steps, observations
/// and resets to a start that it has assembled last. Many of one scene can be stepped on as many threads.
///
/// A rider who holds the hinge of the EzyRoller at a right angle:
///
/// ```
/// use ezy_core::prelude::*;
///
/// model! {
///     pub model Rider {
///         body seat { mass: 46, inertia: 10 }
///         body bar { mass: 1, inertia: 0.005 }
///         hinge B: seat(0.6, 0) ~ bar(-0.1, 0);
///         skate rear: at seat(-0.2, 0) along seat(1, 0);
///         skate front: at bar(0.1, 0) along bar(1, 0);
///         output angle: rad = B.angle;
///         output rate: rad/s = B.rate;
///         effect arms { input torque: N*m = 0; torque bar ~ seat: torque; }
///         start rolling { seat at (0, 0) angle 0; bar angle pi/3; seat velocity (1, _); }
///         scene steered { start rolling; until 10 s; with arms; }
///     }
/// }
///
/// let scene = rider::Steered::default();
/// let mut roller = Simulation::new(&scene).method(Method::rk4(1e-3)).stepper()?;
/// for _episode in 0..2 {
///     roller.reset();
///     for _decision in 0..500 {
///         let seen = roller.now().outputs();
///         roller.set().torque = 200.0 * (std::f64::consts::FRAC_PI_2 - seen.angle) - 40.0 * seen.rate;
///         roller.step(10)?;
///     }
///     assert_eq!(roller.now().t, 5.0);
///     assert!((roller.now().outputs().angle - std::f64::consts::FRAC_PI_2).abs() < 0.02);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Stepper<'s, P: SceneRef> {
    pub(super) stepper: StepperState<P>,
    pub(super) control: Control<'s>,
    pub(super) solver: Solver,
    pub(super) step_s: f64,
    starts: Starts,
    /// Steps since the start.
    n_steps: u64,
    /// Whether accelerations and powers belong to the present state and inputs.
    evaluated: bool,
    /// Time of the present start, s.
    start_s: f64,
    /// Kinetic and potential energy there, J.
    initial_energy: f64,
    outputs: Vec<f64>,
}

impl<'s, P: SceneRef> Stepper<'s, P> {
    pub(super) fn new(
        stepper: StepperState<P>,
        control: Control<'s>,
        solver: Solver,
        step_s: f64,
        starts: Starts,
    ) -> Self {
        let outputs = vec![0.0; stepper.system.info().n_outputs()];
        let mut new = Self {
            stepper,
            control,
            solver,
            step_s,
            starts,
            n_steps: 0,
            evaluated: false,
            start_s: 0.0,
            initial_energy: 0.0,
            outputs,
        };
        new.reset();
        new
    }

    /// Names and sizes.
    pub fn info(&self) -> &Arc<SceneInfo> {
        self.stepper.system.info()
    }

    /// Returns to the start and the inputs of the simulation. A controller keeps its state.
    ///
    /// # Cost
    /// A copy.
    pub fn reset(&mut self) {
        self.stepper.place(self.starts.home());
        self.begin();
    }

    /// Moves to the start of the simulation with these values, by the names of [`Simulation::start`](super::Simulation::start).
    ///
    /// # Errors
    /// [`SetupError`] when a name is not known or the rows cannot be met; the state is then what it was.
    /// # Cost
    /// A copy when the values are those of the last call; otherwise an assembly
    /// ([`System::consistent_start`](crate::dynamics::System::consistent_start)).
    pub fn reset_with(&mut self, given: &[(&str, f64)]) -> Result<(), SetupError> {
        let state = self.starts.with(given, &mut self.stepper.system)?;
        self.stepper.place(state);
        self.begin();
        Ok(())
    }

    fn begin(&mut self) {
        self.starts.set_inputs(self.stepper.now.state.t, &mut self.stepper.system);
        self.n_steps = 0;
        self.evaluated = false;
        self.start_s = self.stepper.now.state.t;
        let (kinetic, potential) = self.mechanical_energy();
        self.initial_energy = kinetic + potential;
    }

    /// Where the motion is, and all that its continuation depends on: the same steps with the same inputs lead to the same bits from there, in
    /// this stepper and in any other one of the same simulation, also of another process. A control law keeps its own state.
    pub fn save(&mut self) -> Checkpoint {
        let mut archive = Archive::new();
        // what is written needs no evaluation, which alone can fail
        let _ = self.remember(&mut archive);
        Checkpoint::new(self.origin(), archive)
    }

    /// Goes back, or on, to where a checkpoint was made: by this stepper, or another one of the same simulation.
    ///
    /// # Errors
    /// [`CheckpointError`] when it is one of another scene, method, step or parameter; or damaged, and the stepper is then at its start.
    pub fn restore(&mut self, checkpoint: &Checkpoint) -> Result<(), CheckpointError> {
        let mut archive = checkpoint.archive(&self.origin())?;
        let outcome = self.remember(&mut archive);
        let is_whole = archive.is_read_whole() && self.is_somewhere();
        if outcome.is_err() || !is_whole {
            self.reset();
        }
        outcome?;
        if is_whole { Ok(()) } else { Err(CheckpointError::Damaged) }
    }

    /// Whether time, numbers of the state and the count of steps are those of a motion.
    fn is_somewhere(&self) -> bool {
        let state = &self.stepper.now.state;
        let is_counted = self.n_steps < LARGEST_COUNT && self.start_s.is_finite() && state.t.is_finite();
        is_counted && state_not_finite(self.info(), state).is_none()
    }

    fn origin(&self) -> Origin {
        Origin::new(self.stepper.system.scene(), &self.solver.named(self.step_s, self.stepper.work))
    }

    fn remember(&mut self, archive: &mut Archive) -> Result<(), MotionError> {
        archive.count(&mut self.n_steps);
        archive.flag(&mut self.evaluated);
        archive.number(&mut self.start_s);
        archive.number(&mut self.initial_energy);
        self.stepper.remember(archive)
    }

    /// The present state by the names of the model file.
    ///
    /// # Cost
    /// A copy of the state; no allocation.
    pub fn now(&mut self) -> Now<'_, P::Target>
    where
        P::Target: NamedScene,
    {
        self.stepper.system.place_states(&self.stepper.now.state.z);
        let system = &self.stepper.system;
        Now::new(system.scene(), &self.stepper.now.state, system, &mut self.outputs)
    }

    /// The inputs by the names of the model file, to set them: they hold until they are set again.
    pub fn set(&mut self) -> InputsGuard<'_, Inputs<P::Target>>
    where
        P::Target: NamedScene,
    {
        InputsGuard::new(self.inputs_mut())
    }

    /// Present inputs by index, `n_i`, each in its unit.
    pub fn inputs(&self) -> &[f64] {
        self.stepper.system.inputs()
    }

    /// The inputs by index, to set them: they hold until they are set again.
    pub fn inputs_mut(&mut self) -> &mut [f64] {
        self.evaluated = false;
        self.stepper.system.inputs_mut()
    }

    /// Takes `n` steps. Tables and the control law, if there are any, set their inputs at the start of each.
    ///
    /// # Errors
    /// [`MotionError`] when the motion cannot be continued; the state is then the last good one.
    /// # Cost
    /// Four evaluations of the accelerations and the projections, each; no allocation.
    pub fn step(&mut self, n: u64) -> Result<(), MotionError> {
        for _ in 0..n {
            if !self.control.is_idle() {
                self.evaluated = false;
                self.control.act(&self.stepper.now.state, self.step_s, &mut self.stepper.system)?;
            }
            let t_next = self.time_after(1);
            let mut h = self.step_s;
            while self.stepper.now.state.t < t_next {
                self.evaluate()?;
                self.stepper.advance(h, t_next)?;
                self.stepper.accept();
                self.evaluated = false;
                // from a discontinuity on
                h = t_next - self.stepper.now.state.t;
            }
            self.stepper.system.integrated_inputs().integrate(self.stepper.now.state.t);
            self.n_steps += 1;
        }
        Ok(())
    }

    /// Time after `n` more steps, s.
    pub(super) fn time_after(&self, n: u64) -> f64 {
        self.start_s + (self.n_steps + n) as f64 * self.step_s
    }

    /// Moves on by `n` steps that something else took, to the positions and velocities that it writes; `pivot` is what its smallest ones are compared with.
    pub(super) fn go_on(&mut self, n: u64, pivot: f64, write: impl FnOnce(&mut [f64], &mut [f64])) {
        let t = self.time_after(n);
        self.n_steps += n;
        let now = &mut *self.stepper.now;
        write(&mut now.state.q, &mut now.state.v);
        now.state.t = t;
        now.end = Solved::regular(pivot);
        self.stepper.restart();
        self.evaluated = false;
    }

    fn evaluate(&mut self) -> Result<(), MotionError> {
        if !self.evaluated {
            check_inputs(self.stepper.now.state.t, &mut self.stepper.system)?;
            self.stepper.evaluate_now()?;
            if self.n_steps == 0 && self.stepper.now.state.t == self.start_s {
                self.stepper.check_beginning(f64::INFINITY)?;
            }
            self.evaluated = true;
        }
        Ok(())
    }

    /// Time, coordinates, velocities and first-order states by index, and works with [`Simulation::work`](super::Simulation::work).
    pub fn state(&self) -> &State {
        &self.stepper.now.state
    }

    /// Accelerations, `n_q`, with the present inputs.
    ///
    /// # Errors
    /// [`MotionError`] when the motion cannot be continued from here.
    pub fn accelerations(&mut self) -> Result<&[f64], MotionError> {
        self.evaluate()?;
        Ok(&self.stepper.now.a)
    }

    /// Multipliers, `n_c`, with the present inputs; the reaction on the bodies is −Gᵀ λ.
    ///
    /// # Errors
    /// [`MotionError`] when the motion cannot be continued from here.
    pub fn multipliers(&mut self) -> Result<&[f64], MotionError> {
        self.evaluate()?;
        Ok(&self.stepper.now.lambda)
    }

    /// Outputs by index, `n_o`, each in its unit, with the present inputs.
    pub fn outputs(&mut self) -> &[f64] {
        let State { t, q, v, z, .. } = &self.stepper.now.state;
        self.stepper.system.place_states(z);
        self.stepper.system.outputs(*t, q, v, &mut self.outputs);
        &self.outputs
    }

    /// Energies, J; work and balance with [`Simulation::work`](super::Simulation::work).
    pub fn energy(&self) -> EnergyState {
        let (kinetic, potential) = self.mechanical_energy();
        match self.stepper.work {
            true => EnergyState::with_work(kinetic, potential, &self.stepper.now.state.work, self.initial_energy),
            false => EnergyState::without_work(kinetic, potential),
        }
    }

    fn mechanical_energy(&self) -> (f64, f64) {
        let (system, State { t, q, v, .. }) = (&self.stepper.system, &self.stepper.now.state);
        (system.kinetic_energy(v), system.potential_energy(*t, q))
    }
}
