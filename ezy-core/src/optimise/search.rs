//! Values of free quantities that make a number of a run largest or smallest.

use super::model::Runs;
use super::{Free, OptimiseError};
use crate::simulate::Run;
use basin::{BoxBounds, ConstraintDescription, ConstraintSet, Constraints, CostFunction};
use basin::{De, Executor, NelderMead, PopulationProgress, SimplexProgress};
use rayon::prelude::*;
use std::convert::Infallible;
use std::fmt::Display;

/// A search for the best values of free quantities between bounds: differential evolution of four populations, then the method of Nelder
/// and Mead from the best. It needs no derivatives and may leave a local optimum.
///
/// The same seed gives the same result, on any number of cores.
///
/// ```
/// use ezy_core::optimise::{Free, Search};
/// use ezy_core::prelude::*;
///
/// model! {
///     pub model Throw {
///         body ball { mass: 1, inertia: 1 }
///         gravity (0, -10);
///         start up { ball at (0, 0) velocity (0, 0); }
///         scene flight { start up; until 5 s; until ball.y < 0; }
///     }
/// }
/// // with 12 m/s, farthest at 45 degrees: v²/g = 14.4 m
/// let scene = throw::Flight::default();
/// let search = Search::new([Free::between("angle", 0.1, 1.5)], |values| {
///     let (sin, cos) = values[0].sin_cos();
///     Simulation::new(&scene).start("ball.vx", 12.0 * cos).start("ball.vy", 12.0 * sin).run()
/// });
/// let farthest = search.maximise_column("ball.x")?;
/// assert!((farthest.number - 14.4).abs() < 1e-6, "{farthest:?}");
/// # Ok::<(), ezy_core::optimise::OptimiseError>(())
/// ```
pub struct Search<'f> {
    free: Vec<Free>,
    runs: Runs<'f>,
    seed: u64,
    n_generations: u64,
}

/// Populations that evolve by themselves, on as many cores: each may end at an optimum of its own, and the best counts.
const ISLANDS: u64 = 4;
/// Members of a population for each free quantity: half of what Storn and Price advise (Journal of Global Optimization 11 (1997), 341),
/// since there are four.
const MEMBERS: usize = 5;
/// Each member is made of three others.
const FEWEST_MEMBERS: usize = 8;
/// Generations when the caller does not say how many: enough to find the valley; the polish finds its bottom.
const GENERATIONS: u64 = 25;
/// First simplex of the polish, in parts of the bounds.
const SIMPLEX: f64 = 0.01;
/// Steps of the polish for each free quantity: a simplex shrinks to 1e-8 of its size in about fifty.
const POLISHING_STEPS: u64 = 100;

impl<'f> Search<'f> {
    /// A search over `free`, all of it with bounds; `run` makes a run with given values, in the order of `free`. Runs that fail, or stop
    /// before their end, count as worst.
    pub fn new<E: Display>(free: impl Into<Vec<Free>>, run: impl Fn(&[f64]) -> Result<Run, E> + Sync + 'f) -> Self {
        Self { free: free.into(), runs: Runs::new(run), seed: 0, n_generations: GENERATIONS }
    }

    /// Seed of the random numbers; 0 without it.
    #[must_use]
    pub fn seed(mut self, seed: u64) -> Self {
        self.seed = seed;
        self
    }

    /// Generations, of twenty runs for each free quantity; 25 without it. Many free quantities, or many optima, need more.
    #[must_use]
    pub fn generations(mut self, n: u64) -> Self {
        self.n_generations = n;
        self
    }

    /// The values with the largest number. NaN counts as a run that failed.
    ///
    /// # Errors
    /// [`OptimiseError`] when bounds are missing, or no run came to its end.
    pub fn maximise(self, number: impl Fn(&Run) -> f64 + Sync) -> Result<Optimum, OptimiseError> {
        self.solve(&|run| Ok(-number(run))).map(|found| Optimum { number: -found.number, ..found })
    }

    /// The values with the smallest number, as [`Search::maximise`].
    ///
    /// # Errors
    /// Those of [`Search::maximise`].
    pub fn minimise(self, number: impl Fn(&Run) -> f64 + Sync) -> Result<Optimum, OptimiseError> {
        self.solve(&|run| Ok(number(run)))
    }

    /// The values with the largest number in a column at the end of the run.
    ///
    /// # Errors
    /// Those of [`Search::maximise`]; a column that is not known is the reason for [`OptimiseError::NoRun`].
    pub fn maximise_column(self, name: &str) -> Result<Optimum, OptimiseError> {
        let at_end = |run: &Run| run.last().get(name).map(|number| -number).map_err(|unknown| unknown.to_string());
        self.solve(&at_end).map(|found| Optimum { number: -found.number, ..found })
    }

    /// The values with the smallest number in a column at the end of the run, as [`Search::maximise_column`].
    ///
    /// # Errors
    /// Those of [`Search::maximise_column`].
    pub fn minimise_column(self, name: &str) -> Result<Optimum, OptimiseError> {
        self.solve(&|run| run.last().get(name).map_err(|unknown| unknown.to_string()))
    }

    fn solve(self, number: &(dyn Fn(&Run) -> Result<f64, String> + Sync)) -> Result<Optimum, OptimiseError> {
        let n = self.free.len();
        if n == 0 {
            return Err(OptimiseError::NothingFree);
        }
        for free in &self.free {
            free.checked()?;
            if !(free.lower.is_finite() && free.upper.is_finite()) {
                return Err(OptimiseError::Unbounded { name: free.name.clone() });
            }
        }
        let problem =
            || Problem { free: &self.free, runs: &self.runs, number, lower: vec![0.0; n], upper: vec![1.0; n] };

        // by islands, whatever the number of cores
        let evolve = |island: u64| {
            let seed = self.seed.wrapping_mul(ISLANDS).wrapping_add(island);
            let evolution = De::new(seed).with_pop_size((MEMBERS * n).max(FEWEST_MEMBERS)).with_dither(0.5, 1.0);
            let run =
                Executor::new(problem(), evolution, PopulationProgress::empty()).max_iter(self.n_generations).run();
            // where every run failed there is none
            run.ok()?.state.best().map(|(place, number)| (place.clone(), number))
        };
        let evolved: Vec<_> = (0..ISLANDS).into_par_iter().map(evolve).collect();
        let best = evolved.into_iter().flatten().min_by(|a, b| a.1.total_cmp(&b.1));
        let Some((place, least)) = best.filter(|(_, least)| least.is_finite()) else { return Err(self.no_run()) };
        let simplex = SimplexProgress::from_simplex(simplex(&place));
        let polish = Executor::new(problem(), NelderMead::new().projected(), simplex);
        let polished = polish.max_iter(POLISHING_STEPS * n as u64).run().ok();
        let (place, number) = match &polished {
            Some(polished) if polished.best_cost() < least => (polished.best_param(), polished.best_cost()),
            _ => (&place, least),
        };
        let values = problem().values(place);
        let at_bounds = self.free.iter().zip(&values).filter(|(free, value)| free.is_at_bound(**value));
        Ok(Optimum {
            at_bounds: at_bounds.map(|(free, _)| free.name.clone()).collect(),
            values,
            number,
            n_runs: self.runs.n_runs(),
            n_failed: self.runs.n_failed(),
        })
    }

    fn no_run(&self) -> OptimiseError {
        OptimiseError::NoRun { n_runs: self.runs.n_runs(), reason: self.runs.last_failure() }
    }
}

/// A place and its neighbours along each axis, inside of the unit box.
fn simplex(place: &[f64]) -> Vec<Vec<f64>> {
    let neighbour = |i: usize| {
        let mut neighbour = place.to_vec();
        neighbour[i] += if place[i] > 0.5 { -SIMPLEX } else { SIMPLEX };
        neighbour
    };
    std::iter::once(place.to_vec()).chain((0..place.len()).map(neighbour)).collect()
}

/// The bounds of every quantity make the unit box.
type UnitBox = ConstraintSet<BoxBounds<Vec<f64>>>;

/// The number over the unit box.
struct Problem<'p, 'f> {
    free: &'p [Free],
    runs: &'p Runs<'f>,
    number: &'p (dyn Fn(&Run) -> Result<f64, String> + Sync),
    lower: Vec<f64>,
    upper: Vec<f64>,
}

impl Problem<'_, '_> {
    fn values(&self, place: &[f64]) -> Vec<f64> {
        let value = |(free, part): (&Free, &f64)| (free.lower + part * (free.upper - free.lower)).min(free.upper);
        self.free.iter().zip(place).map(value).collect()
    }
}

impl CostFunction for Problem<'_, '_> {
    type Param = Vec<f64>;
    type Output = f64;
    type Error = Infallible;

    fn cost(&self, place: &Vec<f64>) -> Result<f64, Infallible> {
        let read = |run: &Run| match (self.number)(run)? {
            number if number.is_nan() => Err("its number is NaN".to_owned()),
            number => Ok(number),
        };
        Ok(self.runs.read(&self.values(place), read).unwrap_or(f64::INFINITY))
    }
}

impl Constraints for Problem<'_, '_> {
    type Set = UnitBox;

    fn constraints(&self) -> <UnitBox as ConstraintDescription>::Borrowed<'_> {
        ConstraintSet::new().with_bounds(BoxBounds::new(Some(&self.lower), Some(&self.upper)))
    }
}

/// The result of a search.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Optimum {
    /// The best values, in the order of the free quantities.
    pub values: Vec<f64>,
    /// The number of the run with them.
    pub number: f64,
    /// Names of the quantities that are at a bound: beyond it the number may be better.
    pub at_bounds: Vec<String>,
    /// Runs that were made.
    pub n_runs: usize,
    /// Runs of them that failed.
    pub n_failed: usize,
}
