//! Random mechanisms, derived and evaluated, against plain kinematics, finite differences and dense solutions.

mod dense;
mod differences;
mod equations;
mod laws;
mod mechanism;
mod models;
mod oracle;
mod quasi;
mod run;
mod series;
mod solutions;
mod states;

use std::sync::OnceLock;

use super::quasi::QuasiVelocities;
use super::series::Series;
use super::solve::Solutions;
use super::symbols::Meaning;
use super::{Equations, check};
use crate::diag::Diagnostics;
use crate::function::Function;
use crate::random::Random;
use crate::symbolic::coefficient::unsigned;
use crate::symbolic::evaluate::Point;
use crate::symbolic::lower::ConstantPool;
use crate::symbolic::{SumId, Symbol};
use crate::{model, parse};
use mechanism::Mechanism;
use oracle::State;

/// Three mechanisms of each size from 1 to 12 bodies.
const N_MECHANISMS: u64 = 36;
const MOST_BODIES: u64 = 12;

/// Differences of sums of some hundred products of values of order one to ten.
const ROUNDING: f64 = 1e-11;

/// A mechanism with all that is derived of it.
struct Trial {
    seed: u64,
    made: Mechanism,
    parameters: Vec<f64>,
    equations: Equations,
    /// Of the vector of constants.
    numbers: Vec<f64>,
    solutions: Solutions,
    /// Or the function that has none.
    series: Result<Series<'static>, Function>,
    /// Where rows give velocities by constant pivots.
    quasi: Option<QuasiVelocities>,
}

/// Every mechanism that the macro accepts.
fn trials() -> &'static [Trial] {
    static TRIALS: OnceLock<Vec<Trial>> = OnceLock::new();
    TRIALS.get_or_init(|| {
        let made = |seed| mechanism::mechanism(seed, 1 + (seed % MOST_BODIES) as usize);
        (0..N_MECHANISMS).filter_map(|seed| Trial::new(seed, made(seed))).collect()
    })
}

impl Trial {
    /// `None` when the macro refuses it, which it must where rows are dependent and nowhere else.
    fn new(seed: u64, made: Mechanism) -> Option<Self> {
        let text = made.text("Random");
        let mut diag = Diagnostics::default();
        let syntax = parse::parse(text.parse().expect("the text has tokens"), &mut diag);
        let Some(model) = model::resolve(syntax, &mut diag).filter(|_| diag.is_empty()) else {
            panic!("seed {seed}: {}\n{text}", diag.into_compile_errors());
        };
        let mut equations = Equations::derive(&model, &model.scenes[0]);
        check::rows(&model, &mut diag);
        let accepted = diag.is_empty();
        let mut constants = ConstantPool::default();
        let solutions = Solutions::derive(&mut equations, &mut constants).expect("few rows meet in one body");
        let series = Series::derive(&mut equations, &mut constants);
        let quasi = QuasiVelocities::of_rows(&mut equations, &solutions, &mut constants);
        let parameters = model.parameters.iter().map(|parameter| parameter.default).collect();
        let mut trial = Self { seed, made, parameters, equations, numbers: Vec::new(), solutions, series, quasi };
        let state = &trial.states()[0];
        let at = At { trial: &trial, state, lambda: &[] };
        let number = |&id| trial.equations.algebra.evaluate_coefficient(unsigned(id), &at);
        trial.numbers = constants.coefficients().iter().map(number).collect();
        let independent = trial.states().iter().any(|state| trial.is_regular(state));
        assert_eq!(accepted, independent, "seed {seed}: {}\n{text}", diag.into_compile_errors());
        accepted.then_some(trial)
    }

    /// The assembled configuration, and states that are special in no way.
    fn states(&self) -> Vec<State> {
        let mut random = Random::new(!self.seed);
        let mut numbers = || (0..self.made.assembled.len()).map(|_| random.between(-1.5, 1.5)).collect::<Vec<_>>();
        let mut states = vec![State { t: 0.0, q: self.made.assembled.clone(), v: numbers() }];
        states.extend([0.3, 1.1].map(|t| State { t, q: numbers(), v: numbers() }));
        states
    }

    fn value(&self, sum: SumId, state: &State) -> f64 {
        self.equations.algebra.evaluate(sum, &At { trial: self, state, lambda: &[] })
    }

    fn values(&self, sums: &[SumId], state: &State) -> Vec<f64> {
        sums.iter().map(|&sum| self.value(sum, state)).collect()
    }

    /// G, dense.
    fn jacobian(&self, state: &State) -> Vec<Vec<f64>> {
        let rows = self.equations.constraints.jacobian.iter().map(|row| {
            let mut dense = vec![0.0; state.q.len()];
            row.iter().for_each(|&(column, entry)| dense[column] = self.value(entry, state));
            dense
        });
        rows.collect()
    }

    fn masses(&self) -> Vec<f64> {
        self.made.bodies.iter().flat_map(|[mass, inertia]| [mass.number, mass.number, inertia.number]).collect()
    }

    /// Whether the rows are independent at a state: K can be inverted.
    fn is_regular(&self, state: &State) -> bool {
        self.kkt(state).condition() < 1e10
    }

    /// K = [M Gᵀ; G 0].
    fn kkt(&self, state: &State) -> dense::Matrix {
        let (masses, jacobian) = (self.masses(), self.jacobian(state));
        let n_q = masses.len();
        let mut k = dense::Matrix::zeros(n_q + jacobian.len());
        masses.iter().enumerate().for_each(|(i, &mass)| k.rows[i][i] = mass);
        for (i, row) in jacobian.iter().enumerate() {
            for (j, &g) in row.iter().enumerate() {
                k.rows[n_q + i][j] = g;
                k.rows[j][n_q + i] = g;
            }
        }
        k
    }

    /// Compares two vectors; `tolerance` is relative to the largest number of either, and to one.
    fn compare(&self, what: &str, found: &[f64], expected: &[f64], tolerance: f64) {
        assert_eq!(found.len(), expected.len(), "seed {}: {what}", self.seed);
        let largest = found.iter().chain(expected).fold(1.0, |m: f64, x| m.max(x.abs()));
        for (i, (x, y)) in found.iter().zip(expected).enumerate() {
            let close = f64::abs(x - y) <= tolerance * largest;
            assert!(close, "seed {}: {what} {i}: {x} against {y}\n{}", self.seed, self.made.text("Random"));
        }
    }
}

/// A state with the declared values of the parameters.
struct At<'a> {
    trial: &'a Trial,
    state: &'a State,
    /// Multipliers, for the power of rows that move with time.
    lambda: &'a [f64],
}

impl Point for At<'_> {
    fn symbol(&self, symbol: Symbol) -> f64 {
        match self.trial.equations.symbols.meaning(symbol) {
            Meaning::Time => self.state.t,
            Meaning::Coordinate(i) => self.state.q[i],
            Meaning::Velocity(i) => self.state.v[i],
            Meaning::Input(_) => f64::NAN,
            Meaning::Named(_) => {
                let row = self.trial.equations.multipliers.iter().find(|(other, _)| *other == symbol);
                row.and_then(|&(_, row)| self.lambda.get(row)).copied().unwrap_or(f64::NAN)
            }
        }
    }

    fn parameter(&self, index: usize) -> f64 {
        self.trial.parameters[index]
    }
}
