//! Scenes with modes: skates with a limit, and a stop, switch their rows on and off.

mod contact;
mod stick_slip;

use super::events::{EventDetector, Occurrence};
use super::recording::sampler::Sliding;
use super::stepping::stepper_state::StepperState;
use super::{SetupError, SoftestImpact};
use crate::dynamics::{MotionError, State, System};
use crate::integrate::resolution_at;
use crate::model::{EventInfo, SceneRef, StopInfo};
use crate::simulate::tolerances::modes::MAX_AT_ONCE;

/// The law of a row.
#[derive(Clone, Copy)]
enum Law {
    /// By its place in [`SceneInfo::limited_skates`](crate::model::SceneInfo::limited_skates).
    Skate(usize),
    Stop(&'static StopInfo),
}

/// A row that is switched.
struct SwitchedRow {
    law: Law,
    /// Its place among the rows.
    row: usize,
    /// 0 at the start, in which a skate holds and a stop is open; a number more for each side or end.
    mode: usize,
    /// Of the event that ends the mode.
    detector: EventDetector,
    /// Whether the mode has made no step yet. Its event function may then begin at zero.
    begins: bool,
    /// Whether the mode is to change before the next step.
    is_due: bool,
}

/// The modes of a scene, one for each row that is switched.
pub(super) struct Modes {
    rows: Vec<SwitchedRow>,
    /// Steps that were made and discarded.
    pub n_taken_back: u64,
    pub occurred: Vec<Occurrence>,
    pub softest: Option<SoftestImpact>,
}

/// How a step ends.
enum Cut {
    /// At its end: no mode changes.
    Whole,
    /// Where the mode of a row changes.
    AtChange(usize),
    /// The mode of a row changes at the start of the step, which is discarded.
    AtOnce(usize),
}

impl Modes {
    /// For a scene at its start; `None` for a scene without modes.
    pub(super) fn new<P: SceneRef>(stepper: &StepperState<P>) -> Option<Self> {
        let info = stepper.system.info();
        let skates = info.limited_skates.iter().enumerate().map(|(i, skate)| (Law::Skate(i), skate.row));
        let laws = skates.chain(info.stop.map(|stop| (Law::Stop(stop), stop.row)));
        let rows: Vec<_> = laws
            .map(|(law, row)| {
                let detector = detector(law, 0, stepper);
                SwitchedRow { law, row, mode: 0, detector, begins: false, is_due: false }
            })
            .collect();
        (!rows.is_empty()).then(|| Self { rows, n_taken_back: 0, occurred: Vec::new(), softest: None })
    }

    /// The skates that slide.
    pub(super) fn sliding(&self) -> impl Iterator<Item = Sliding> {
        self.rows.iter().filter_map(|of| match of.law {
            Law::Skate(skate) => stick_slip::side(of.mode).map(|side| Sliding { skate, side }),
            Law::Stop(_) => None,
        })
    }

    /// Chooses the modes of the start.
    ///
    /// # Errors
    /// [`SetupError::BeyondStop`], and those of laws that cannot be read and of the change.
    pub(super) fn start<P: SceneRef>(&mut self, stepper: &mut StepperState<P>) -> Result<(), SetupError> {
        for i in 0..self.rows.len() {
            if let Law::Stop(info) = self.rows[i].law {
                contact::start(self, i, info, stepper)?;
            }
        }
        Ok(self.settle(stepper)?)
    }

    /// One step, up to the first change of a mode if there is one; returns whether a mode changes at its end.
    pub(super) fn advance<P: SceneRef>(
        &mut self,
        stepper: &mut StepperState<P>,
        h: f64,
        t_next: f64,
    ) -> Result<bool, MotionError> {
        self.change_due(stepper)?;
        self.settle(stepper)?;
        for _ in 0..MAX_AT_ONCE * self.rows.len() {
            self.advance_where_defined(stepper, h, t_next)?;
            let cut = self.cut(stepper)?;
            if let Cut::AtOnce(i) = cut {
                self.n_taken_back += 1;
                self.change(i, stepper)?;
                continue;
            }
            self.rows.iter_mut().for_each(|of| of.begins = false);
            if let Cut::AtChange(i) = cut {
                self.rows[i].is_due = true;
            }
            return Ok(matches!(cut, Cut::AtChange(_)));
        }
        Err(MotionError::StepCollapsed { t: stepper.now.state.t, step_s: 0.0 })
    }

    /// A step that ends before a law is no number, where it comes to that: equations read the laws in every mode.
    fn advance_where_defined<P: SceneRef>(
        &mut self,
        stepper: &mut StepperState<P>,
        h: f64,
        t_next: f64,
    ) -> Result<(), MotionError> {
        let start = stepper.now.state.t;
        let (mut outcome, mut ahead_s) = (stepper.advance(h, t_next), t_next - start);
        while let Err(error @ (MotionError::NotFinite { .. } | MotionError::StepCollapsed { .. })) = outcome {
            let fault = fault_ahead(stepper, ahead_s).ok_or(error)?;
            ahead_s *= 0.5;
            if ahead_s <= resolution_at(start) {
                return Err(fault);
            }
            outcome = self.advance_again(stepper, start + ahead_s);
        }
        outcome
    }

    /// Changes the modes that are due.
    pub(super) fn change_due<P: SceneRef>(&mut self, stepper: &mut StepperState<P>) -> Result<(), MotionError> {
        for i in 0..self.rows.len() {
            if std::mem::take(&mut self.rows[i].is_due) {
                self.change(i, stepper)?;
            }
        }
        Ok(())
    }

    /// Changes modes that are not admissible at the present state; the change of one may end another.
    fn settle<P: SceneRef>(&mut self, stepper: &mut StepperState<P>) -> Result<(), MotionError> {
        for _ in 0..MAX_AT_ONCE * self.rows.len() {
            stepper.place_now();
            let mut ended = None;
            for i in 0..self.rows.len() {
                if ended.is_none() && self.ends(i, stepper)? {
                    ended = Some(i);
                }
            }
            let Some(i) = ended else { return Ok(()) };
            self.change(i, stepper)?;
        }
        Err(MotionError::StepCollapsed { t: stepper.now.state.t, step_s: 0.0 })
    }

    /// Whether a mode is not admissible at the present state.
    fn ends<P: SceneRef>(&self, i: usize, stepper: &StepperState<P>) -> Result<bool, MotionError> {
        let SwitchedRow { law, row, mode, .. } = self.rows[i];
        match law {
            Law::Skate(skate) => stick_slip::ends(mode, skate, row, stepper),
            Law::Stop(info) => Ok(contact::ends(mode, info, stepper)),
        }
    }

    /// Changes to the next mode of a row.
    fn change<P: SceneRef>(&mut self, i: usize, stepper: &mut StepperState<P>) -> Result<(), MotionError> {
        stepper.place_now();
        match self.rows[i].law {
            Law::Skate(skate) => stick_slip::change(self, i, skate, stepper),
            Law::Stop(info) => contact::change(self, i, info, stepper),
        }
    }

    /// Switches a row, and projects the state onto it where it holds.
    fn switch<P: SceneRef>(&mut self, i: usize, mode: usize, stepper: &mut StepperState<P>) -> Result<(), MotionError> {
        self.attempt(stepper, |modes, stepper| {
            let (holds, side) = switches(modes.rows[i].law, mode);
            stepper.switch(modes.rows[i].row, holds, side)?;
            let State { t, q, v, .. } = &stepper.now.state;
            if let Some(fault) = fault_of_laws(&stepper.system, *t, q, v) {
                return Err(fault);
            }
            modes.enter(i, mode, stepper);
            stepper.evaluate_now()
        })
    }

    /// Notes that a row, which is switched so, is in a mode.
    fn enter<P: SceneRef>(&mut self, i: usize, mode: usize, stepper: &StepperState<P>) {
        let of = &mut self.rows[i];
        (of.mode, of.detector) = (mode, detector(of.law, mode, stepper));
        of.begins = match of.law {
            Law::Skate(_) => stick_slip::side(mode).is_some(),
            Law::Stop(_) => mode == contact::FREE,
        };
    }

    /// A change of modes; where it fails, modes and state are those before it, as the last sample tells them.
    fn attempt<P: SceneRef>(
        &mut self,
        stepper: &mut StepperState<P>,
        change: impl FnOnce(&mut Self, &mut StepperState<P>) -> Result<(), MotionError>,
    ) -> Result<(), MotionError> {
        let modes: Vec<usize> = self.rows.iter().map(|of| of.mode).collect();
        let before = stepper.now.clone();
        let outcome = change(self, stepper);
        if outcome.is_err() {
            stepper.now = before;
            for (i, mode) in modes.into_iter().enumerate() {
                let (holds, side) = switches(self.rows[i].law, mode);
                stepper.system.switch(self.rows[i].row, holds, side);
                self.enter(i, mode, stepper);
            }
        }
        outcome
    }

    fn tell<P: SceneRef>(&mut self, event: &'static EventInfo, stepper: &StepperState<P>) {
        self.occurred.push(Occurrence { event, state: stepper.now.state.clone() });
    }

    /// Repeats a step that goes past the end of a mode.
    fn cut<P: SceneRef>(&mut self, stepper: &mut StepperState<P>) -> Result<Cut, MotionError> {
        let start = stepper.now.state.t;
        loop {
            stepper.evaluate_next()?;
            let (mut first, mut below) = (None, None);
            let mut undefined = None;
            for (i, SwitchedRow { detector, begins, .. }) in self.rows.iter_mut().enumerate() {
                match detector.first(stepper, *begins) {
                    Ok(Some(t)) if first.is_none_or(|(earliest, _)| t < earliest) => first = Some((t, i)),
                    Ok(Some(_)) => {}
                    Ok(None) if detector.ends_below() => below = below.or(Some(i)),
                    Ok(None) => {}
                    Err(fault) => {
                        undefined = Some((i, fault));
                        break;
                    }
                }
            }
            if let Some((i, fault)) = undefined {
                self.end_before(i, fault, stepper)?;
                continue;
            }
            if let Some(i) = below {
                // the event function began at zero and is below it at all samples: the mode ends before the first one
                let h = (stepper.next.state.t - start) / self.rows[i].detector.n_parts() as f64;
                if h <= resolution_at(start) {
                    return Ok(Cut::AtOnce(i));
                }
                self.advance_again(stepper, start + h)?;
                continue;
            }
            let Some((t, i)) = first else { return Ok(Cut::Whole) };
            if t <= start {
                return Ok(Cut::AtOnce(i));
            }
            self.advance_again(stepper, t)?;
            return Ok(if stepper.next.state.t < t { Cut::Whole } else { Cut::AtChange(i) });
        }
    }

    /// Repeats a step up to the last time at which the event function of a row is defined, since its mode may end before. When no
    /// step is left, the error ends the run.
    fn end_before<P: SceneRef>(
        &mut self,
        i: usize,
        fault: MotionError,
        stepper: &mut StepperState<P>,
    ) -> Result<(), MotionError> {
        let (MotionError::SkateLimit { t, .. } | MotionError::StopNotFinite { t, .. }) = fault else {
            return Err(fault);
        };
        let last = self.rows[i].detector.last_defined(stepper, t);
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

/// Switches of a mode: whether the row holds, and its side.
fn switches(law: Law, mode: usize) -> (bool, f64) {
    match law {
        Law::Skate(_) => stick_slip::switches(mode),
        Law::Stop(info) => contact::switches(info, mode),
    }
}

/// What is wrong with the laws of rows so much later, s, if the motion went on as it is now.
fn fault_ahead<P: SceneRef>(stepper: &StepperState<P>, ahead_s: f64) -> Option<MotionError> {
    let (system, now) = (&stepper.system, &stepper.now);
    let along = |x: &[f64], rate: &[f64]| x.iter().zip(rate).map(|(x, rate)| x + ahead_s * rate).collect::<Vec<_>>();
    let [q, v] = [(&now.state.q, now.node().q_rate), (&now.state.v, &now.a)].map(|(x, rate)| along(x, rate));
    fault_of_laws(system, now.state.t + ahead_s, &q, &v)
}

/// What is wrong with the law of a row that can be switched.
pub(super) fn fault_of_laws<P: SceneRef>(system: &System<P>, t: f64, q: &[f64], v: &[f64]) -> Option<MotionError> {
    let info = system.info();
    let of_skate = stick_slip::fault(system, t, q, v);
    of_skate.or_else(|| info.stop.and_then(|stop| contact::fault(stop, system, t, q, v)))
}

/// What ends a mode.
fn detector<P: SceneRef>(law: Law, mode: usize, stepper: &StepperState<P>) -> EventDetector {
    let (function, events) = match law {
        Law::Skate(skate) => stick_slip::function(skate, mode, stepper),
        Law::Stop(info) => contact::function(info, mode, stepper),
    };
    EventDetector::new(function, events, stepper)
}
