//! Taylor series of random mechanisms against the equations of motion along them.

use std::collections::HashMap;

use super::oracle::State;
use super::run::outputs;
use super::{Trial, trials};
use crate::function::Function;
use crate::mechanics::kernels::{Entries, Pass, Put, Read, Slot};
use crate::mechanics::series::Series;
use crate::symbolic::Symbol;

/// Orders of the accelerations.
const N_ORDERS: usize = 12;

/// A coefficient errs by some thousand roundings times the condition of K: sums of up to a dozen products an order.
const PER_CONDITION: f64 = 1e-12;

/// Coefficients of one step, as the emitted code would store them.
struct Store<'t> {
    trial: &'t Trial,
    series: &'t Series<'t>,
    state: &'t State,
    /// By slot with its order in place of how far ahead it is; what belongs to no order stands at 0.
    numbers: HashMap<(Slot, usize), f64>,
}

impl<'t> Store<'t> {
    fn new(trial: &'t Trial, series: &'t Series<'t>, state: &'t State) -> Self {
        let mut store = Self { trial, series, state, numbers: HashMap::new() };
        for i in 0..state.q.len() {
            store.numbers.insert((Slot::Coordinate(0, i), 0), state.q[i]);
            store.numbers.insert((Slot::Coordinate(0, i), 1), state.v[i]);
        }
        store.run(&series.begin, -1);
        let solution = series.solution.as_ref().expect("a small mechanism has an elimination");
        store.run(&solution.pass, 0);
        store.sums(2);
        store.run(&series.finish, 0);
        for k in 1..N_ORDERS as isize {
            store.sums(k as usize + 2);
            store.run(&series.right_side, k);
            store.run(&solution.pass, k);
            store.run(&series.finish, k);
        }
        store
    }

    /// What a slot is called when the present order is k.
    fn key(slot: Slot, k: isize) -> (Slot, usize) {
        let order = |ahead: usize| usize::try_from(k + ahead as isize).expect("orders start at 0");
        match slot {
            Slot::Kept(ahead, i) => (Slot::Kept(0, i), order(ahead)),
            Slot::Coordinate(ahead, i) => (Slot::Coordinate(0, i), order(ahead)),
            Slot::Left(ahead, i) => (Slot::Left(0, i), order(ahead)),
            Slot::Right(ahead, i) => (Slot::Right(0, i), order(ahead)),
            Slot::Multiplier(_) | Slot::Acceleration(_) => (slot, order(0)),
            _ => (slot, 0),
        }
    }

    fn number(&self, slot: Slot, k: isize) -> f64 {
        match slot {
            Slot::Order(ahead) => (k + ahead as isize) as f64,
            Slot::InverseOrder(ahead) => 1.0 / (k + ahead as isize) as f64,
            _ => self.numbers.get(&Self::key(slot, k)).copied().unwrap_or(0.0),
        }
    }

    fn run(&mut self, pass: &Pass<'_>, k: isize) {
        let other = |symbol: Symbol| {
            let Some(Read::Slot(slot)) = pass.read(symbol) else { panic!("programs read slots") };
            self.number(slot, k)
        };
        let found = outputs(self.trial, &pass.program, self.state, &other);
        for (put, value) in pass.puts.iter().zip(found) {
            let &Put::Slot(target) = put else { panic!("series fill slots") };
            self.numbers.insert(Self::key(target, k), value);
        }
    }

    fn sums(&mut self, n: usize) {
        for i in 0..self.series.begin.n(Entries::Products) {
            let get = |slot, order| self.numbers.get(&(slot, order)).copied().unwrap_or(0.0);
            let sum = (1..n).map(|j| get(Slot::Left(0, i), j) * get(Slot::Right(0, i), n - j)).sum();
            self.numbers.insert((Slot::Sum(i), 0), sum);
        }
    }

    fn coefficients(&self, slot: fn(usize) -> Slot, i: usize, n_orders: usize) -> Vec<f64> {
        (0..n_orders).map(|k| self.numbers[&(slot(i), k)]).collect()
    }
}

fn at(coefficients: &[f64], h: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, x| sum * h + x)
}

fn slope(coefficients: &[f64], h: f64) -> f64 {
    let terms = coefficients.iter().enumerate().skip(1);
    terms.rev().fold(0.0, |sum, (k, x)| sum * h + k as f64 * x)
}

/// The state that the series predict, and with them accelerations and multipliers, solve the equations of motion there.
#[test]
fn cross_series_of_random_mechanisms_solve_the_equations_of_motion_ahead() {
    let mut n_checked = 0;
    for trial in trials() {
        let Ok(series) = &trial.series else { continue };
        // one state a mechanism: a series is many evaluations
        if let Some(state) = trial.states().iter().find(|state| trial.is_regular(state)) {
            let store = Store::new(trial, series, state);
            let (n_q, n_c) = (state.q.len(), trial.equations.constraints.rows.len());
            let q: Vec<_> = (0..n_q).map(|i| store.coefficients(|i| Slot::Coordinate(0, i), i, N_ORDERS + 2)).collect();
            let acceleration = (0..n_q).map(|i| store.coefficients(Slot::Acceleration, i, N_ORDERS));
            let lambda = (0..n_c).map(|i| store.coefficients(Slot::Multiplier, i, N_ORDERS));
            let series: Vec<_> = acceleration.chain(lambda).collect();
            // a step whose last terms are e^-36 of the first ones
            let last =
                |of: &Vec<f64>| (of[N_ORDERS - 1].abs() / of[0].abs().max(1.0)).powf(1.0 / (N_ORDERS - 1) as f64);
            let h = (-3.0f64).exp() / series.iter().map(last).fold(1.0, f64::max);
            let ahead = State {
                t: state.t + h,
                q: q.iter().map(|q| at(q, h)).collect(),
                v: q.iter().map(|q| slope(q, h)).collect(),
            };
            let k = trial.kkt(&ahead);
            let mut right_side = trial.values(&trial.equations.force, &ahead);
            right_side.extend(trial.values(&trial.equations.constraints.convective, &ahead).iter().map(|x| -x));
            let expected = k.solve(&right_side).expect("the state is regular");
            let found: Vec<f64> = series.iter().map(|of| at(of, h)).collect();
            trial.compare("series", &found, &expected, PER_CONDITION * k.condition());
            n_checked += 1;
        }
    }
    assert!(n_checked > 10, "{n_checked}");
}

#[test]
fn analytic_laws_are_all_that_series_are_refused_for() {
    for trial in trials() {
        if let Err(function) = trial.series {
            assert!(matches!(function, Function::Abs | Function::Sign | Function::Min | Function::Max), "{function:?}");
        }
    }
}
