//! Starts that give every coordinate of a row, but not so that the row holds.

use crate::diag::{Diagnostics, scenes as message};
use crate::mechanics::Equations;
use crate::mechanics::symbols::{Meaning, Symbols};
use crate::model::{Model, Scene};
use crate::symbolic::Symbol;
use crate::symbolic::evaluate::Point;

/// Given values may be rounded to some digits, such as 1.5708 for a right angle of an arm of metres.
const HOLDS: f64 = 1e-3;

/// Reports rows that the given values break, with the declared parameters and inputs.
pub fn start(model: &Model, scene: &Scene, equations: &mut Equations, diag: &mut Diagnostics) {
    let n_q = equations.mass.len();
    let Equations { algebra, symbols, inputs, constraints, start, .. } = equations;
    let inputs = inputs.iter().map(|id| model.inputs[id.0].default).collect();
    let mut state = Given { symbols, defaults: model.defaults(), inputs, q: vec![None; n_q], v: vec![None; n_q] };
    for given in start.iter().filter(|given| !given.near) {
        let value = algebra.evaluate(given.value, &state);
        let target = if given.rate { &mut state.v } else { &mut state.q };
        target[given.index] = Some(value);
    }
    for (i, row) in constraints.rows.iter().enumerate() {
        let mut columns = constraints.jacobian[i].iter().map(|(column, _)| *column);
        let all_given = columns.clone().all(|column| state.q[column].is_some());
        let (value, level) = match constraints.position.get(i) {
            Some(&c) if all_given => (algebra.evaluate(c, &state), "position"),
            None if all_given
                && columns.all(|column| state.v[column].is_some())
                && state.knows(&algebra.symbols_of(constraints.velocity[i])) =>
            {
                (algebra.evaluate(constraints.velocity[i], &state), "velocity")
            }
            _ => continue,
        };
        if value.abs() > HOLDS {
            let start = &model.starts[scene.start.0].name;
            diag.error(message::start_breaks_row(start, &row.name, level, value));
            return;
        }
    }
}

/// The given values; what is not given is never read.
struct Given<'a> {
    symbols: &'a Symbols,
    defaults: Vec<f64>,
    inputs: Vec<f64>,
    q: Vec<Option<f64>>,
    v: Vec<Option<f64>>,
}

impl Given<'_> {
    /// Whether every coordinate among them is given.
    fn knows(&self, symbols: &[Symbol]) -> bool {
        symbols.iter().filter_map(|&symbol| self.symbols.coordinate_of(symbol)).all(|i| self.q[i].is_some())
    }
}

impl Point for Given<'_> {
    fn symbol(&self, symbol: Symbol) -> f64 {
        match self.symbols.meaning(symbol) {
            Meaning::Coordinate(i) => self.q[i].unwrap_or(0.0),
            Meaning::Velocity(i) => self.v[i].unwrap_or(0.0),
            Meaning::Input(i) => self.inputs[i],
            Meaning::Time | Meaning::Named(_) => 0.0,
        }
    }

    fn parameter(&self, index: usize) -> f64 {
        self.defaults[index]
    }
}
