//! All rests of a scene, from many starts.

use super::error::AnalysisError;
use super::one_sided;
use super::steady_motion::SteadyMotion;
use super::tolerances::rests::{SAME, UNWOUND};
use crate::dynamics::{State, System};
use crate::model::{Equations as _, Name, SceneInfo, SceneRef, Start};
use crate::scalar::SplitMix64;
use std::f64::consts::{PI, TAU};
use std::sync::Arc;

/// First state of the generator of starts: any number serves, so long as it stays.
const SEED: u64 = 0x5EED;

/// The rests that a number of starts lead to.
#[derive(Debug, Clone, PartialEq)]
pub struct Rests {
    /// Each rest once, by rising coordinates.
    pub found: Vec<Rest>,
    /// How many starts led to none: they cannot be assembled, or the search ended beside a rest.
    pub n_lost: usize,
}

/// A rest, and how many starts led there.
#[derive(Debug, Clone, PartialEq)]
pub struct Rest {
    /// The rest.
    pub motion: SteadyMotion,
    /// How many starts led there.
    pub n_starts: usize,
}

impl Rests {
    /// Searches from `n_starts` starts: the first is `start` without its velocities, the others have every coordinate at random, angles over a
    /// full turn, places as far from the origin as the mechanism reaches, and are assembled from there, in either way of assembly. They are the
    /// same each time. What is named in `hold` keeps its value of `start`, and so do first-order states where the search begins.
    ///
    /// Rests whose angles differ by whole turns are one, unless the turns wind a spring. Of rests that are free to move ([`SteadyMotion::free`])
    /// the one is told that has the free coordinates of `start`, where there is one.
    ///
    /// A rest that no start leads to is not found: there is no bound on their number.
    ///
    /// # Errors
    /// [`AnalysisError`] where no search can begin: a start that cannot be assembled, an unknown name in `hold`, a scene without derivatives or
    /// with bodies in space.
    /// # Cost
    /// That of [`SteadyMotion::near`], `n_starts` times.
    pub fn of<P: SceneRef>(
        system: &mut System<P>,
        start: &Start,
        hold: &[&str],
        n_starts: usize,
    ) -> Result<Self, AnalysisError> {
        let info = Arc::clone(system.info());
        if !info.is_planar() {
            return Err(AnalysisError::Spatial { scene: info.name });
        }
        let mut still = start.clone();
        still.v.fill(0.0);
        still.v_given.fill(false);
        still.v_near.fill(false);
        one_sided::release(system);
        let first = system.consistent_start(&still)?;
        let extent = info.coordinates.iter().zip(&first.q).filter(|(info, _)| info.is_length());
        let length = extent.fold(system.length(), |length, (_, x)| length.max(x.abs()));
        let mut all = Collection { system, info, first, hold, length, force: 0.0, rests: Vec::new() };
        let mut random = SplitMix64(SEED);
        let mut n_lost = 0;
        for i in 0..n_starts {
            let drawn = if i == 0 { still.clone() } else { all.draw(&mut random) };
            if !all.take(&drawn)? {
                n_lost += 1;
            }
        }
        let mut found = all.rests;
        found.sort_by_cached_key(|rest| {
            // in steps that are wider than rounding
            rest.motion.state.q.iter().map(|x| (x / (SAME * length.max(1.0))).round() as i64).collect::<Vec<_>>()
        });
        Ok(Self { found, n_lost })
    }
}

struct Collection<'s, P: SceneRef> {
    system: &'s mut System<P>,
    info: Arc<SceneInfo>,
    /// The start that was given, assembled.
    first: State,
    hold: &'s [&'s str],
    /// As far as the mechanism reaches, m.
    length: f64,
    /// Largest force at a start.
    force: f64,
    rests: Vec<Rest>,
}

impl<P: SceneRef> Collection<'_, P> {
    /// A start with everything at random but what is held.
    fn draw(&self, random: &mut SplitMix64) -> Start {
        let mut start = self.near(|name| self.hold.contains(&&**name));
        for (i, info) in self.info.coordinates.iter().enumerate() {
            let drawn = random.symmetric() * if info.is_length() { self.length } else { PI };
            if !start.q_given[i] {
                start.q[i] = drawn;
            }
        }
        start
    }

    /// The start that was given, as a guess but for coordinates that are held.
    fn near(&self, is_held: impl Fn(&Name) -> bool) -> Start {
        let mut start = Start::free_of(&self.info);
        start.t = self.first.t;
        start.z.clone_from(&self.first.z);
        for (i, _) in self.info.coordinates.iter().enumerate().filter(|(_, info)| is_held(&info.name)) {
            start.give_position(i, self.first.q[i]);
        }
        start
    }

    /// Takes in the rest that a start leads to; whether there is one.
    fn take(&mut self, start: &Start) -> Result<bool, AnalysisError> {
        one_sided::release(self.system);
        let Ok(assembled) = self.system.consistent_start(start) else { return Ok(false) };
        let force = self.force_at(&assembled.q, &assembled);
        self.force = force.iter().fold(self.force, |largest, x| largest.max(x.abs()));
        let motion = match one_sided::near(self.system, start, self.hold, f64::INFINITY) {
            Ok(motion) if is_at_rest(&motion) => self.settled(motion),
            Ok(_)
            | Err(
                AnalysisError::Start(_)
                | AnalysisError::Motion(_)
                | AnalysisError::NotFound { .. }
                | AnalysisError::NotFinite { .. }
                | AnalysisError::BeyondStop { .. }
                | AnalysisError::Slides { .. },
            ) => return Ok(false),
            Err(error) => return Err(error),
        };
        let mut rests = std::mem::take(&mut self.rests);
        match rests.iter_mut().find(|rest| self.is_same(&rest.motion.state, &motion.state)) {
            Some(rest) => {
                rest.n_starts += 1;
                // of those that differ by whole turns, the one that is turned least
                if self.turned(&motion) + SAME < self.turned(&rest.motion) {
                    rest.motion = motion;
                }
            }
            None => rests.push(Rest { motion, n_starts: 1 }),
        }
        self.rests = rests;
        Ok(true)
    }

    /// Where it is free to move, the rest that has the free values of the start.
    fn settled(&mut self, motion: SteadyMotion) -> SteadyMotion {
        if motion.free.is_empty() {
            return motion;
        }
        let free = &motion.free;
        let mut start = self.near(|name| free.contains(name) || self.hold.contains(&&**name));
        for i in 0..start.q.len() {
            if !start.q_given[i] {
                start.q[i] = motion.state.q[i];
            }
        }
        for (i, state) in self.info.states.iter().enumerate() {
            if !free.iter().any(|name| name == state.name) {
                start.z[i] = motion.state.z[i];
            }
        }
        let held: Vec<&str> = self.hold.iter().copied().chain(free.iter().map(|name| &**name)).collect();
        match one_sided::near(self.system, &start, &held, f64::INFINITY) {
            Ok(other) if is_at_rest(&other) => SteadyMotion { free: free.clone(), ..other },
            _ => motion,
        }
    }

    /// Sum of the angles, without their signs, rad.
    fn turned(&self, motion: &SteadyMotion) -> f64 {
        let angles = self.info.coordinates.iter().zip(&motion.state.q).filter(|(info, _)| info.is_angle());
        angles.map(|(_, angle)| angle.abs()).sum()
    }

    /// Whether two rests are one: the same places, angles that differ by whole turns, and the same forces after these turns.
    fn is_same(&mut self, a: &State, b: &State) -> bool {
        let mut turned = a.q.clone();
        for (i, info) in self.info.coordinates.iter().enumerate() {
            let apart = b.q[i] - a.q[i];
            let (turns, size) = if info.is_length() { (0.0, self.length) } else { ((apart / TAU).round(), 1.0) };
            if (apart - turns * TAU).abs() > SAME * size {
                return false;
            }
            turned[i] += turns * TAU;
        }
        let is_near = |(a, b): (&f64, &f64)| (a - b).abs() <= SAME * a.abs().max(b.abs()).max(1.0);
        if !a.z.iter().zip(&b.z).all(is_near) {
            return false;
        }
        if turned == a.q {
            return true;
        }
        let (before, after) = (self.force_at(&a.q, a), self.force_at(&turned, a));
        before.iter().zip(&after).all(|(before, after)| (before - after).abs() <= UNWOUND * self.force)
    }

    /// The applied forces at coordinates `q`, at rest, with the states of `state`.
    fn force_at(&mut self, q: &[f64], state: &State) -> Vec<f64> {
        self.system.place_states(&state.z);
        let mut force = vec![0.0; self.info.n_velocities()];
        let still = vec![0.0; self.info.n_velocities()];
        self.system.scene().applied_force(self.system.fixed(), state.t, q, &still, &mut force);
        force
    }
}

fn is_at_rest(motion: &SteadyMotion) -> bool {
    motion.state.v.iter().all(|v| *v == 0.0)
}
