//! Motions that come back to themselves, by shooting.

use super::error::AnalysisError;
use super::linearization::null_space;
use super::mode::Mode;
use super::monodromy::{Monodromy, eigenvalues};
use super::return_map::{ReturnMap, depends_on_time, has_period, name, values};
use super::tolerances::periodic::{
    ENOUGH, FREE, LAST, MAX_HALVINGS, MAX_STEPS, N_STEPS, NEUTRAL, RETURNS, SLOW, STRIDE,
};
use crate::dynamics::{Metric, Projection, State, System};
use crate::model::coordinate::N_OF_BODY;
use crate::model::{Name, SceneRef, Start};
use nalgebra::{DMatrix, DVector};

/// What is known of the period.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Period {
    /// It is this, s: that of what drives the scene, or a multiple of it.
    Given(f64),
    /// It is near this, s, and found with the motion, of a scene that does not depend on time.
    Near(f64),
}

/// Deviations that a periodic motion does not damp or amplify by its nature: each has a multiplier of modulus 1.
#[derive(Debug, Clone, PartialEq)]
pub enum Trivial {
    /// Everything is as good at another place.
    Place,
    /// Everything is as good in another direction.
    Heading,
    /// Nothing depends on this angle, such as that of a wheel.
    Angle(Name),
    /// Everything is as good a little later, where nothing depends on time.
    Time,
}

/// What becomes of small deviations from a periodic motion, those that are [`Trivial`] left out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stability {
    /// All fade.
    Stable,
    /// One grows, at least.
    Unstable,
    /// None grows, and one stays, at least, to first order: as where energy is kept.
    Neutral,
}

/// A motion that comes back to its start after a period: to the same state or, where nothing depends on place or heading, to that state moved
/// on and turned with the first body, as the gait of a vehicle does.
///
/// # Source
/// Seydel, Practical Bifurcation and Stability Analysis (2010), chapter 7.
#[derive(Debug, Clone)]
pub struct PeriodicMotion {
    /// States at [`Monodromy::times`] of the period: the first and the last are start and end.
    pub states: Vec<State>,
    /// T, s.
    pub period: f64,
    /// M with its basis, how far the first body has gone, where nothing depends on that, and what does not return.
    pub monodromy: Monodromy,
    /// What has a multiplier of modulus 1 by nature.
    pub trivial: Vec<Trivial>,
    /// By how much M leaves the deviations of these: what is rounding and error of the runs.
    pub trivial_left: f64,
    /// The other multipliers by falling modulus, as eigenvalues of M, with their eigenvectors.
    pub modes: Vec<Mode>,
    /// Largest change of an entry of M when the steps of its collocation were halved.
    pub change: f64,
    /// Newton steps that it took.
    pub n_steps: usize,
}

impl PeriodicMotion {
    /// The periodic motion near the consistent state of a start, by Newton's method on what does not return, with M − 1 as its exact Jacobian.
    ///
    /// `flow` gives the states of a run from a consistent state at ascending times, the first of which is that of the state; its tolerance should be
    /// 1e-12 or less. Values that are named in `hold` keep their values of the start; what else is free, such as place, heading and, where
    /// energy is kept, amplitude, stays near the start. Rows that come and go, and jumps of forces within the period, are not told to M.
    ///
    /// # Errors
    /// [`AnalysisError`], and what `flow` returns; [`AnalysisError::NoReturn`] names what does not return.
    pub fn near<P: SceneRef, E: From<AnalysisError>>(
        system: &mut System<P>,
        start: &Start,
        period: Period,
        hold: &[&str],
        flow: impl FnMut(&State, &[f64]) -> Result<Vec<State>, E>,
    ) -> Result<Self, E> {
        let info = std::sync::Arc::clone(system.info());
        let (Period::Given(guess) | Period::Near(guess)) = period;
        if !(guess > 0.0 && guess.is_finite()) {
            return Err(AnalysisError::Period { period: guess }.into());
        }
        if !info.is_planar() {
            return Err(AnalysisError::Spatial { scene: info.name }.into());
        }
        let n = info.n_coordinates() + info.n_velocities() + info.n_states();
        let place = |held: &&str| {
            let unknown = || AnalysisError::UnknownHeld { scene: info.name, name: (*held).to_owned() };
            (0..n).find(|&i| *name(&info, i).0 == **held).ok_or_else(unknown)
        };
        let held = hold.iter().map(place).collect::<Result<Vec<_>, _>>()?;
        let state = system.consistent_start(start).map_err(AnalysisError::from)?;
        let mut search = Search::new(system, state, period, held, flow)?;
        let n_steps = search.find()?;
        search.found(n_steps)
    }

    /// Where it begins.
    pub fn start(&self) -> &State {
        &self.states[0]
    }

    /// By the largest multiplier; a modulus within 1e-6 of one is one.
    pub fn stability(&self) -> Stability {
        match self.modes.first().map_or(0.0, |mode| mode.eigenvalue.norm()) {
            largest if largest > 1.0 + NEUTRAL => Stability::Unstable,
            largest if largest < 1.0 - NEUTRAL => Stability::Stable,
            _ => Stability::Neutral,
        }
    }
}

struct Search<'s, P: SceneRef, F> {
    map: ReturnMap<'s, P>,
    flow: F,
    held: Vec<usize>,
    /// Their values, and those of all others, at the start.
    first: DVector<f64>,
    depends_on_time: bool,
    /// Whether the period is an unknown.
    is_unknown: bool,
    period: f64,
    states: Vec<State>,
    /// The largest rate of the first start.
    rate: f64,
}

impl<'s, P: SceneRef, E: From<AnalysisError>, F: FnMut(&State, &[f64]) -> Result<Vec<State>, E>> Search<'s, P, F> {
    fn new(system: &'s mut System<P>, state: State, period: Period, held: Vec<usize>, mut flow: F) -> Result<Self, E> {
        let (Period::Given(guess) | Period::Near(guess)) = period;
        let states = flow(&state, &Monodromy::times(state.t, guess, N_STEPS[0]))?;
        let scene = system.info().name;
        let some = [0, 2 * states.len() / 7, states.len() / 2].map(|i| states[i].clone());
        let depends_on_time = depends_on_time(system, &some, guess)?;
        match period {
            Period::Near(_) if depends_on_time => {
                return Err(AnalysisError::TimeDependent { scene, how: String::new() }.into());
            }
            Period::Given(period) if depends_on_time && !has_period(system, &some, period)? => {
                let how = format!(", and are not the same {period} s later");
                return Err(AnalysisError::TimeDependent { scene, how }.into());
            }
            _ => {}
        }
        let mut map = ReturnMap::of(system, &states)?;
        let rate = map.rates(&states[0], &states[0])?.amax();
        let first = values(&states[0]);
        let is_unknown = matches!(period, Period::Near(_));
        Ok(Self { map, flow, held, first, depends_on_time, is_unknown, period: guess, states, rate })
    }

    /// Newton's steps, halved until less is left.
    fn find(&mut self) -> Result<usize, E> {
        let mut norm = self.norm(&self.states);
        for n_steps in 0..MAX_STEPS {
            let (step, stretch) = self.step()?;
            let is_last = self.map.share(&step) <= LAST && stretch.abs() <= LAST * self.period;
            let mut found = None;
            let mut share = (STRIDE * self.period / stretch.abs()).min(1.0);
            for _ in 0..MAX_HALVINGS {
                // where no run goes, a shorter step is tried
                if let Ok(tried) = self.tried(&step, stretch, share)
                    && self.norm(&tried.0) < norm
                {
                    found = Some(tried);
                    break;
                }
                share *= 0.5;
            }
            let goes_on = found.is_some() && !is_last;
            if let Some(found) = found {
                (self.states, self.period) = found;
                norm = self.norm(&self.states);
            }
            if goes_on {
                continue;
            }
            self.check(n_steps)?;
            return Ok(n_steps);
        }
        self.check(MAX_STEPS)?;
        Ok(MAX_STEPS)
    }

    /// That what is left is nothing, and that something moves.
    fn check(&mut self, n_steps: usize) -> Result<(), AnalysisError> {
        let left = self.map.left(&self.states);
        if self.norm(&self.states) > RETURNS {
            return Err(self.map.no_return(&left, self.period, n_steps));
        }
        let rate = self.map.rates(&self.states[0], &self.states[0])?.amax();
        if self.is_unknown && rate <= SLOW * self.rate {
            return Err(AnalysisError::AtRest { scene: self.map.info.name });
        }
        Ok(())
    }

    /// The largest share by which something does not return or is not held.
    fn norm(&self, states: &[State]) -> f64 {
        let now = values(&states[0]);
        let mut moved = DVector::zeros(now.len());
        self.held.iter().for_each(|&i| moved[i] = now[i] - self.first[i]);
        self.map.share(&self.map.left(states)).max(self.map.share(&moved))
    }

    /// The change of the start and that of the period.
    fn step(&mut self) -> Result<(DVector<f64>, f64), AnalysisError> {
        let (first, last) = (&self.states[0], &self.states[self.states.len() - 1]);
        let (basis, x) = self.map.deviations(&self.states)?;
        let m = basis.ncols();
        let left = self.map.left(&self.states);
        let n = left.len();
        let mut jacobian = DMatrix::zeros(n + self.held.len() + 1, m + 1);
        let mut right = DMatrix::zeros(jacobian.nrows(), 1);
        jacobian.view_mut((0, 0), (n, m)).copy_from(&self.map.counted(first, x - &basis));
        right
            .view_mut((0, 0), (n, 1))
            .copy_from(&self.map.counted(first, -DMatrix::from_column_slice(n, 1, left.as_slice())));
        let now = values(first);
        for (k, &i) in self.held.iter().enumerate() {
            jacobian.view_mut((n + k, 0), (1, m)).copy_from(&basis.row(i));
            right[n + k] = self.first[i] - now[i];
        }
        let mut scale = 0.0;
        if self.is_unknown {
            let rates = self.map.rates(first, last)?;
            scale = rates.norm().max(f64::MIN_POSITIVE).recip();
            let column = self.map.counted(first, DMatrix::from_column_slice(n, 1, rates.as_slice()) * scale);
            jacobian.view_mut((0, m), (n, 1)).copy_from(&column);
            // the start moves across the motion, unless something that is held says where along it
            if self.held.is_empty() {
                let along = basis.tr_mul(&self.map.rates(first, first)?);
                jacobian.view_mut((n, 0), (1, m)).copy_from(&(along.transpose() * scale));
            }
        }
        let step = (jacobian.svd(true, true))
            .solve(&right, FREE)
            .map_err(|_| AnalysisError::NoEigenvalues { scene: self.map.info.name })?;
        Ok((basis * step.rows(0, m).column(0), scale * step[m]))
    }

    /// The states of a run from a start that is a share of a step on.
    fn tried(&mut self, step: &DVector<f64>, stretch: f64, share: f64) -> Result<(Vec<State>, f64), E> {
        let mut state = self.states[0].clone();
        let State { t, q, v, z, .. } = &mut state;
        let steps = step.iter().map(|x| share * x);
        q.iter_mut().chain(v.iter_mut()).chain(z).zip(steps).for_each(|(x, step)| *x += step);
        let system = &mut *self.map.system;
        system.project(*t, q, v, Projection::Both, Metric::Mass).map_err(AnalysisError::from)?;
        let period = self.period + share * stretch;
        let states = (self.flow)(&state, &Monodromy::times(state.t, period, N_STEPS[0]))?;
        Ok((states, period))
    }

    /// The result, with as many steps of the collocation as M needs.
    fn found(mut self, n_steps: usize) -> Result<PeriodicMotion, E> {
        let [mut n, most] = N_STEPS;
        let (basis, x) = self.map.deviations(&self.states)?;
        let mut matrix = basis.tr_mul(&x);
        let change = loop {
            n *= 2;
            self.states = (self.flow)(&self.states[0], &Monodromy::times(self.states[0].t, self.period, n))?;
            let finer = basis.tr_mul(&self.map.deviations(&self.states)?.1);
            let change = (&finer - &matrix).amax();
            matrix = finer;
            if change <= ENOUGH * matrix.amax() || n >= most {
                break change;
            }
        };
        let left = self.map.left(&self.states);
        let moved = self.map.symmetry.moved(&self.states[0], &self.states[self.states.len() - 1]);
        let monodromy = Monodromy { matrix, basis, moved, gap: left.amax() };
        let (trivial, spanned) = self.trivial(&monodromy.basis)?;
        let scene = self.map.info.name;
        let lost = || AnalysisError::NoEigenvalues { scene };
        let (trivial_left, rest) = deflated(&monodromy.matrix, &spanned).ok_or_else(lost)?;
        let of = [self.map.info.n_coordinates(), self.map.info.n_velocities()];
        let multipliers = eigenvalues(&rest).ok_or_else(lost)?.into_iter();
        let modes = Mode::all(&monodromy.matrix, &monodromy.basis, of, multipliers).ok_or_else(lost)?;
        let Self { states, period, .. } = self;
        Ok(PeriodicMotion { states, period, monodromy, trivial, trivial_left, modes, change, n_steps })
    }

    /// What has a multiplier of modulus 1 by nature, and its deviations in the tangent space, orthonormal.
    fn trivial(&mut self, basis: &DMatrix<f64>) -> Result<(Vec<Trivial>, DMatrix<f64>), AnalysisError> {
        let state = &self.states[0];
        let directions = self.map.symmetry.directions(state);
        let kinds = (0..N_OF_BODY).filter(|&k| self.map.symmetry.rigid[k]);
        let kinds = kinds.map(|k| if k < 2 { Trivial::Place } else { Trivial::Heading });
        let mut all: Vec<(Trivial, DVector<f64>)> =
            kinds.zip(directions.column_iter().map(|column| basis.tr_mul(&column))).collect();
        for i in self.map.free_angles() {
            let along = basis.row(i).transpose();
            all.push((Trivial::Angle(name(&self.map.info, i).0), along));
        }
        if !self.depends_on_time {
            let rates = self.map.rates(state, state)?;
            all.push((Trivial::Time, basis.tr_mul(&rates)));
        }
        let (mut trivial, mut spanned) = (Vec::new(), DMatrix::zeros(basis.ncols(), 0));
        for (kind, direction) in all {
            let size = direction.norm();
            let across = &direction - &spanned * spanned.tr_mul(&direction);
            // a motion that goes on as the place does is no further direction
            if size > 0.0 && across.norm() > NEUTRAL * size {
                let n = spanned.ncols();
                spanned = spanned.insert_column(n, 0.0);
                spanned.column_mut(n).copy_from(&across.normalize());
                trivial.push(kind);
            }
        }
        Ok((trivial, spanned))
    }
}

/// By how much a matrix leaves a subspace, and what it is on what is left beside that: its eigenvalues are those of the matrix but for those
/// of the subspace. None where they are not finite.
fn deflated(matrix: &DMatrix<f64>, subspace: &DMatrix<f64>) -> Option<(f64, DMatrix<f64>)> {
    let rest = null_space(subspace.transpose())?;
    let left = if subspace.ncols() == 0 { 0.0 } else { rest.tr_mul(&(matrix * subspace)).amax() };
    Some((left, rest.tr_mul(matrix) * &rest))
}
