//! Scenes with modes: one motion for each mode, and the changes between modes.

mod contact;
mod stick_slip;

use super::SetupError;
use super::events::{EventDetector, Occurrence};
use super::stepping::stepper_state::StepperState;
use crate::dynamics::MotionError;
use crate::integrate::resolution_at;
use crate::model::{EventInfo, SceneInfo, SceneRef, StickSlipInfo, StopInfo};
use crate::simulate::tolerances::events::N_PARTS;
use crate::simulate::tolerances::modes::MAX_AT_ONCE;
use std::sync::Arc;

/// The law that gives a scene its modes.
#[derive(Clone, Copy)]
enum Law {
    StickSlip(&'static StickSlipInfo),
    Stop(&'static StopInfo),
}

/// The inactive modes, and the event that ends the active one.
pub(super) struct Modes<P: SceneRef> {
    law: Law,
    /// Index of the active one in `Derived::modes`.
    mode: usize,
    parked: Vec<(usize, StepperState<P>)>,
    detector: EventDetector,
    /// Whether the mode has made no step yet. Its event function may then begin at zero.
    begins: bool,
    /// Whether the next step begins with a change of mode.
    is_due: bool,
    /// Steps that were made and discarded.
    n_taken_back: u64,
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

impl<P: SceneRef> Modes<P> {
    /// For a scene that starts in mode `first` and may change to `others`; `None` for a scene without modes.
    pub(super) fn new(first: &StepperState<P>, others: Vec<StepperState<P>>) -> Option<Self> {
        let info = first.system.info();
        let law = info.stick_slip.map(Law::StickSlip).or(info.stop.map(Law::Stop))?;
        let detector = detector(law, 0, first);
        let parked: Vec<_> = (1..).zip(others).collect();
        let modes = Self {
            law,
            mode: 0,
            parked,
            detector,
            begins: false,
            is_due: false,
            n_taken_back: 0,
            occurred: Vec::new(),
        };
        (!modes.parked.is_empty()).then_some(modes)
    }

    /// Description of the mode with the most constraints.
    pub(super) fn record_info(&self, stepper: &StepperState<P>) -> Arc<SceneInfo> {
        let infos = self.parked().chain([stepper]).map(|stepper| stepper.system.info());
        Arc::clone(infos.max_by_key(|info| info.n_rows()).unwrap_or(stepper.system.info()))
    }

    /// The constraint that the active mode does not have, and its multiplier as a multiple of the skate's limit.
    pub(super) fn lacking(&self) -> Option<(usize, f64)> {
        match self.law {
            Law::StickSlip(info) => stick_slip::side(self.mode).map(|side| (info.row, side)),
            Law::Stop(info) => (self.mode == 0).then_some((info.row, 0.0)),
        }
    }

    pub(super) fn parked(&self) -> impl Iterator<Item = &StepperState<P>> {
        self.parked.iter().map(|(_, stepper)| stepper)
    }

    /// Rejected steps of the inactive modes, and discarded steps of all modes.
    pub(super) fn n_rejected(&self) -> u64 {
        self.n_taken_back + self.parked().map(StepperState::n_rejected).sum::<u64>()
    }

    /// Chooses the mode of the start.
    ///
    /// # Errors
    /// [`SetupError::BeyondStop`], and those of laws that cannot be read and of the change.
    pub(super) fn start(&mut self, stepper: &mut StepperState<P>) -> Result<(), SetupError> {
        match self.law {
            Law::StickSlip(_) => Ok(self.settle(stepper)?),
            Law::Stop(info) => contact::start(self, info, stepper),
        }
    }

    /// One step, up to the change of mode if there is one; returns whether the mode changes at its end.
    pub(super) fn advance(&mut self, stepper: &mut StepperState<P>, h: f64, t_next: f64) -> Result<bool, MotionError> {
        self.settle(stepper)?;
        for _ in 0..MAX_AT_ONCE {
            stepper.advance(h, t_next)?;
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

    /// Changes the mode when the active one is not admissible at the present state.
    fn settle(&mut self, stepper: &mut StepperState<P>) -> Result<(), MotionError> {
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
    pub(super) fn change(&mut self, stepper: &mut StepperState<P>) -> Result<(), MotionError> {
        stepper.place_now();
        self.begins = match self.law {
            Law::StickSlip(info) => stick_slip::change(self, info, stepper)?,
            Law::Stop(info) => contact::change(self, info, stepper)?,
        };
        self.detector = detector(self.law, self.mode, stepper);
        Ok(())
    }

    fn switch(&mut self, mode: usize, stepper: &mut StepperState<P>) -> Result<(), MotionError> {
        if let Some(other) = self.parked_in(mode) {
            other.take_over(stepper)?;
        }
        self.swap(mode, stepper);
        Ok(())
    }

    /// Makes a mode the active one, with its own state.
    fn swap(&mut self, mode: usize, stepper: &mut StepperState<P>) {
        if let Some((parked, other)) = self.parked.iter_mut().find(|(parked, _)| *parked == mode) {
            std::mem::swap(other, stepper);
            *parked = std::mem::replace(&mut self.mode, mode);
        }
    }

    fn parked_in(&mut self, mode: usize) -> Option<&mut StepperState<P>> {
        self.parked.iter_mut().find(|(parked, _)| *parked == mode).map(|(_, stepper)| stepper)
    }

    fn tell(&mut self, event: &'static EventInfo, stepper: &StepperState<P>) {
        self.occurred.push(Occurrence { event, state: stepper.now.state.clone() });
    }

    /// Repeats a step that goes past the end of the mode.
    fn cut(&mut self, stepper: &mut StepperState<P>) -> Result<Cut, MotionError> {
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
    fn end_before(&mut self, fault: MotionError, stepper: &mut StepperState<P>) -> Result<(), MotionError> {
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
    fn advance_again(&mut self, stepper: &mut StepperState<P>, t: f64) -> Result<(), MotionError> {
        self.n_taken_back += 1;
        stepper.advance_again(t - stepper.now.state.t, t)
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
