//! A skate that holds up to a limit: one scene for each of its modes, and the way from one to the next.

use super::events::{Lookout, Occurrence, Sought};
use super::motion::Motion;
use crate::dynamics::MotionError;
use crate::model::{EventInfo, GripInfo, Scene};

/// A slide that begins is followed down to this part of a step: rounding of a velocity inside of a step grows as steps shrink.
const SHORTEST: f64 = 1e-5;

/// A slide shorter than a quarter of a step is looked for in a step of this part.
const SHORTER: f64 = 0.25;

/// More changes at one time never lead to a motion.
const MAX_AT_ONCE: usize = 8;

/// What the skate does.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Mode {
    Holds,
    /// To the left of its direction 1, to the right -1.
    Slides(f64),
}

/// The modes that are not under way, and what ends the one that is.
pub(super) struct Grip<'s, S: Scene + ?Sized> {
    info: &'static GripInfo,
    mode: Mode,
    parked: [(Mode, Motion<'s, S>); 2],
    lookout: Lookout,
    /// Whether a slide has made no step yet, so that its velocity begins at zero.
    begins: bool,
    pub occurred: Vec<Occurrence>,
}

/// How a step ends.
enum Cut {
    /// As it is.
    Whole,
    /// Where the mode changes.
    AtChange,
    /// It does not begin: the mode changes at its start.
    AtOnce,
}

impl<'s, S: Scene + ?Sized> Grip<'s, S> {
    /// A skate that holds; `left` and `right` are the motions in which it slides.
    pub fn new(info: &'static GripInfo, holds: &Motion<'s, S>, left: Motion<'s, S>, right: Motion<'s, S>) -> Self {
        let parked = [(Mode::Slides(1.0), left), (Mode::Slides(-1.0), right)];
        let lookout = lookout(info, Mode::Holds, holds);
        Self { info, mode: Mode::Holds, parked, lookout, begins: false, occurred: Vec::new() }
    }

    /// To which side it slides, and its row.
    pub fn slide(&self) -> Option<(usize, f64)> {
        match self.mode {
            Mode::Holds => None,
            Mode::Slides(side) => Some((self.info.row, side)),
        }
    }

    pub fn parked(&self) -> impl Iterator<Item = &Motion<'s, S>> {
        self.parked.iter().map(|(_, motion)| motion)
    }

    /// A step, up to where the skate lets go or stops; whether it ends there.
    pub fn advance(&mut self, motion: &mut Motion<'s, S>, h: f64, t_next: f64) -> Result<bool, MotionError> {
        self.settle(motion)?;
        for _ in 0..MAX_AT_ONCE {
            motion.advance(h, t_next)?;
            match self.cut(motion)? {
                Cut::Whole => {
                    self.begins = false;
                    return Ok(false);
                }
                Cut::AtChange => return Ok(true),
                Cut::AtOnce => self.change(motion)?,
            }
        }
        Err(MotionError::StepCollapsed { t: motion.now.state.t, step_s: 0.0 })
    }

    /// Lets the skate go where it needs more than its limit.
    pub fn settle(&mut self, motion: &mut Motion<'s, S>) -> Result<(), MotionError> {
        if self.mode == Mode::Holds && self.reaction(motion).abs() > limit(motion) {
            self.change(motion)?;
        }
        Ok(())
    }

    /// From holding to the slide that its reaction opposes; from a slide to holding, or on to the other side.
    pub fn change(&mut self, motion: &mut Motion<'s, S>) -> Result<(), MotionError> {
        let held = self.mode == Mode::Holds;
        if !held {
            self.occurred.push(occurrence(&self.info.stops, motion));
            self.switch(Mode::Holds, motion)?;
        }
        let reaction = self.reaction(motion);
        if held || reaction.abs() > limit(motion) {
            self.occurred.push(occurrence(&self.info.slides, motion));
            self.switch(Mode::Slides(reaction.signum()), motion)?;
        }
        self.lookout = lookout(self.info, self.mode, motion);
        self.begins = self.mode != Mode::Holds;
        Ok(())
    }

    /// Force of the skate that holds, N.
    fn reaction(&self, motion: &Motion<'s, S>) -> f64 {
        motion.now.lambda[self.info.row]
    }

    fn switch(&mut self, mode: Mode, motion: &mut Motion<'s, S>) -> Result<(), MotionError> {
        let Some((parked, other)) = self.parked.iter_mut().find(|(parked, _)| *parked == mode) else { return Ok(()) };
        other.take_over(motion)?;
        std::mem::swap(other, motion);
        *parked = std::mem::replace(&mut self.mode, mode);
        Ok(())
    }

    /// Makes a step again that goes past the end of the mode.
    fn cut(&mut self, motion: &mut Motion<'s, S>) -> Result<Cut, MotionError> {
        let start = motion.now.state.t;
        let shortest = SHORTEST * (motion.next.state.t - start);
        loop {
            motion.evaluate_next()?;
            if let Some(t) = self.lookout.first(motion, self.begins)? {
                if t <= start {
                    return Ok(Cut::AtOnce);
                }
                motion.advance_again(t - start, t)?;
                return Ok(if motion.next.state.t < t { Cut::Whole } else { Cut::AtChange });
            }
            if !self.lookout.ends_below() {
                return Ok(Cut::Whole);
            }
            // a slide that begins ends before a value tells
            let h = SHORTER * (motion.next.state.t - start);
            if h < shortest || start + h <= start {
                return Ok(Cut::AtOnce);
            }
            motion.advance_again(h, start + h)?;
        }
    }
}

/// What ends a mode.
fn lookout<S: Scene + ?Sized>(info: &'static GripInfo, mode: Mode, motion: &Motion<'_, S>) -> Lookout {
    let (n_q, n_works) = (motion.now.state.q.len(), motion.now.state.work.len());
    let (sought, event) = match mode {
        Mode::Holds => {
            let (a, lambda) = (motion.now.a.clone(), motion.now.lambda.clone());
            (Sought::Reserve { row: info.row, a, lambda }, &info.slides)
        }
        Mode::Slides(side) => (Sought::Slide { side }, &info.stops),
    };
    Lookout::new(sought, std::slice::from_ref(event), n_q, n_works)
}

fn limit<S: Scene + ?Sized>(motion: &Motion<'_, S>) -> f64 {
    let state = &motion.now.state;
    motion.system.grip(state.t, &state.q, &state.v)[0]
}

fn occurrence<S: Scene + ?Sized>(event: &'static EventInfo, motion: &Motion<'_, S>) -> Occurrence {
    Occurrence { event, state: motion.now.state.clone() }
}
