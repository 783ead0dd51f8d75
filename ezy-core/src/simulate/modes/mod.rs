//! Scenes with modes: a skate with a limit, or a stop, switches its row on and off.

mod contact;
mod stick_slip;

use super::SetupError;
use super::events::{EventDetector, Occurrence, laws};
use super::stepping::stepper_state::StepperState;
use crate::dynamics::{MotionError, State, System};
use crate::integrate::resolution_at;
use crate::model::{EventInfo, SceneRef, StickSlipInfo, StopInfo};
use crate::simulate::tolerances::events::N_PARTS;
use crate::simulate::tolerances::modes::MAX_AT_ONCE;

/// The law that gives a scene its modes.
#[derive(Clone, Copy)]
enum Law {
    StickSlip(&'static StickSlipInfo),
    Stop(&'static StopInfo),
}

/// The mode of a scene, and the event that ends it.
pub(super) struct Modes {
    law: Law,
    /// 0 at the start, in which a skate holds and a stop is open; a number more for each side or end.
    mode: usize,
    detector: EventDetector,
    /// Whether the mode has made no step yet. Its event function may then begin at zero.
    begins: bool,
    /// Whether the next step begins with a change of mode.
    is_due: bool,
    /// Steps that were made and discarded.
    pub n_taken_back: u64,
    pub occurred: Vec<Occurrence>,
}

/// How a step ends.
enum Cut {
    /// At its end: the mode does not change.
    Whole,
    /// Where the mode changes.
    AtChange,
    /// The mode changes at the start of the step, which is discarded.
    AtOnce,
}

impl Modes {
    /// For a scene at its start; `None` for a scene without modes.
    pub(super) fn new<P: SceneRef>(stepper: &StepperState<P>) -> Option<Self> {
        let info = stepper.system.info();
        let law = info.stick_slip.map(Law::StickSlip).or(info.stop.map(Law::Stop))?;
        let detector = detector(law, 0, stepper);
        let occurred = Vec::new();
        Some(Self { law, mode: 0, detector, begins: false, is_due: false, n_taken_back: 0, occurred })
    }

    /// The row of a skate that slides, and its multiplier as a multiple of the limit.
    pub(super) fn sliding(&self) -> Option<(usize, f64)> {
        match self.law {
            Law::StickSlip(info) => stick_slip::side(self.mode).map(|side| (info.row, side)),
            Law::Stop(_) => None,
        }
    }

    /// Chooses the mode of the start.
    ///
    /// # Errors
    /// [`SetupError::BeyondStop`], and those of laws that cannot be read and of the change.
    pub(super) fn start<P: SceneRef>(&mut self, stepper: &mut StepperState<P>) -> Result<(), SetupError> {
        match self.law {
            Law::StickSlip(_) => Ok(self.settle(stepper)?),
            Law::Stop(info) => contact::start(self, info, stepper),
        }
    }

    /// One step, up to the change of mode if there is one; returns whether the mode changes at its end.
    pub(super) fn advance<P: SceneRef>(
        &mut self,
        stepper: &mut StepperState<P>,
        h: f64,
        t_next: f64,
    ) -> Result<bool, MotionError> {
        self.settle(stepper)?;
        for _ in 0..MAX_AT_ONCE {
            self.advance_where_defined(stepper, h, t_next)?;
            match self.cut(stepper)? {
                Cut::Whole => {
                    self.begins = false;
                    return Ok(false);
                }
                Cut::AtChange => return Ok(true),
                Cut::AtOnce => {
                    self.n_taken_back += 1;
                    self.change(stepper)?;
                }
            }
        }
        Err(MotionError::StepCollapsed { t: stepper.now.state.t, step_s: 0.0 })
    }

    /// A step that ends before the law of the row is no number, where it comes to that: equations read the law in every mode.
    fn advance_where_defined<P: SceneRef>(
        &mut self,
        stepper: &mut StepperState<P>,
        h: f64,
        t_next: f64,
    ) -> Result<(), MotionError> {
        let start = stepper.now.state.t;
        let (mut outcome, mut ahead_s) = (stepper.advance(h, t_next), t_next - start);
        while let Err(error @ (MotionError::NotFinite { .. } | MotionError::StepCollapsed { .. })) = outcome {
            let fault = self.fault_of_law(stepper, ahead_s).ok_or(error)?;
            ahead_s *= 0.5;
            if ahead_s <= resolution_at(start) {
                return Err(fault);
            }
            outcome = self.advance_again(stepper, start + ahead_s);
        }
        outcome
    }

    /// What is wrong with the law of the row so much later, s, if the motion went on as it is now.
    fn fault_of_law<P: SceneRef>(&self, stepper: &StepperState<P>, ahead_s: f64) -> Option<MotionError> {
        let (system, now) = (&stepper.system, &stepper.now);
        let along =
            |x: &[f64], rate: &[f64]| x.iter().zip(rate).map(|(x, rate)| x + ahead_s * rate).collect::<Vec<_>>();
        let [q, v] = [(&now.state.q, now.node().q_rate), (&now.state.v, &now.a)].map(|(x, rate)| along(x, rate));
        fault_of_law(system, now.state.t + ahead_s, &q, &v)
    }

    /// Changes the mode when the active one is not admissible at the present state.
    fn settle<P: SceneRef>(&mut self, stepper: &mut StepperState<P>) -> Result<(), MotionError> {
        stepper.place_now();
        let ends = match self.law {
            Law::StickSlip(info) => stick_slip::ends(self, info, stepper)?,
            Law::Stop(info) => contact::ends(self, info, stepper),
        };
        if std::mem::take(&mut self.is_due) || ends {
            self.change(stepper)?;
        }
        Ok(())
    }

    /// Changes to the next mode.
    pub(super) fn change<P: SceneRef>(&mut self, stepper: &mut StepperState<P>) -> Result<(), MotionError> {
        stepper.place_now();
        self.begins = match self.law {
            Law::StickSlip(info) => stick_slip::change(self, info, stepper)?,
            Law::Stop(info) => contact::change(self, info, stepper)?,
        };
        self.detector = detector(self.law, self.mode, stepper);
        Ok(())
    }

    fn switch<P: SceneRef>(&mut self, mode: usize, stepper: &mut StepperState<P>) -> Result<(), MotionError> {
        let switches = |mode| match self.law {
            Law::StickSlip(_) => stick_slip::switches(mode),
            Law::Stop(info) => contact::switches(info, mode),
        };
        let ((holds, side), (held, was)) = (switches(mode), switches(self.mode));
        let (q, v) = (stepper.now.state.q.clone(), stepper.now.state.v.clone());
        stepper.switch(holds, side)?;
        let State { t, q: on_q, v: on_v, .. } = &stepper.now.state;
        if let Some(fault) = fault_of_law(&stepper.system, *t, on_q, on_v) {
            // the last sample belongs to the mode that was
            stepper.system.switch(held, was);
            (stepper.now.state.q, stepper.now.state.v) = (q, v);
            return Err(fault);
        }
        self.mode = mode;
        stepper.evaluate_now()
    }

    fn tell<P: SceneRef>(&mut self, event: &'static EventInfo, stepper: &StepperState<P>) {
        self.occurred.push(Occurrence { event, state: stepper.now.state.clone() });
    }

    /// Repeats a step that goes past the end of the mode.
    fn cut<P: SceneRef>(&mut self, stepper: &mut StepperState<P>) -> Result<Cut, MotionError> {
        let start = stepper.now.state.t;
        loop {
            stepper.evaluate_next()?;
            let first = match self.detector.first(stepper, self.begins) {
                Ok(first) => first,
                Err(fault) => {
                    self.end_before(fault, stepper)?;
                    continue;
                }
            };
            if let Some(t) = first {
                if t <= start {
                    return Ok(Cut::AtOnce);
                }
                self.advance_again(stepper, t)?;
                return Ok(if stepper.next.state.t < t { Cut::Whole } else { Cut::AtChange });
            }
            if !self.detector.ends_below() {
                return Ok(Cut::Whole);
            }
            // the event function began at zero and is below it at all samples: the mode ends before the first one
            let h = (stepper.next.state.t - start) / N_PARTS as f64;
            if h <= resolution_at(start) {
                return Ok(Cut::AtOnce);
            }
            self.advance_again(stepper, start + h)?;
        }
    }

    /// Repeats a step up to the last time at which the event function is defined, since the mode may end before. When no
    /// step is left, the error ends the run.
    fn end_before<P: SceneRef>(
        &mut self,
        fault: MotionError,
        stepper: &mut StepperState<P>,
    ) -> Result<(), MotionError> {
        let (MotionError::SkateLimit { t, .. } | MotionError::StopNotFinite { t, .. }) = fault else {
            return Err(fault);
        };
        let last = self.detector.last_defined(stepper, t);
        if last - stepper.now.state.t <= resolution_at(last) {
            return Err(fault);
        }
        self.advance_again(stepper, last)
    }

    /// Discards the present step and makes one that ends at `t`.
    fn advance_again<P: SceneRef>(&mut self, stepper: &mut StepperState<P>, t: f64) -> Result<(), MotionError> {
        self.n_taken_back += 1;
        stepper.advance_again(t - stepper.now.state.t, t)
    }
}

/// What is wrong with the law of the row that can be switched.
pub(super) fn fault_of_law<P: SceneRef>(system: &System<P>, t: f64, q: &[f64], v: &[f64]) -> Option<MotionError> {
    let info = system.info();
    match (info.stick_slip, info.stop) {
        (Some(skate), _) => laws::stick_slip(system, skate, t, q, v).err(),
        (_, Some(stop)) => contact::fault(stop, system, t, q, v),
        _ => None,
    }
}

/// What ends a mode.
fn detector<P: SceneRef>(law: Law, mode: usize, stepper: &StepperState<P>) -> EventDetector {
    let (function, events) = match law {
        Law::StickSlip(info) => stick_slip::function(info, mode, stepper),
        Law::Stop(info) => contact::function(info, mode, stepper),
    };
    EventDetector::new(function, events, &stepper.now.state)
}
