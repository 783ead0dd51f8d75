//! Rigid motions of everything that leave the equations of a scene as they are.

use super::error::AnalysisError;
use super::linearization::rows_by_states;
use super::monodromy::{accelerations, flow};
use super::tolerances::periodic::SAME;
use crate::dynamics::{Gradients, OperatingPoint, State, System};
use crate::model::SceneRef;
use crate::model::coordinate::N_OF_BODY;
use nalgebra::DMatrix;
use std::f64::consts::TAU;

/// What a scene does not depend on, along a motion.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Symmetry {
    /// Place along x and y, and heading. Without a place, the heading turns about the origin.
    pub rigid: [bool; N_OF_BODY],
    /// Coordinates of which a whole turn changes nothing.
    turns: Vec<bool>,
}

impl Symmetry {
    /// Seen at each of some states.
    pub(super) fn of<P: SceneRef>(system: &mut System<P>, states: &[State]) -> Result<Self, AnalysisError> {
        let mut gradients = Gradients::new(system)?;
        let mut rigid = [true; N_OF_BODY];
        for state in states {
            let (a, lambda) = accelerations(system, state)?;
            let State { t, q, v, .. } = state;
            let at = OperatingPoint { fixed: system.fixed(), t: *t, q, v, accelerations: &a, multipliers: &lambda };
            let mut rows = rows_by_states(&mut gradients, &at);
            rows.row_iter_mut().filter(|row| row.norm() > 0.0).for_each(|mut row| row /= row.norm());
            let flow = flow(system, &mut gradients, state)?;
            let directions = directions(state);
            // a turn of everything turns the rates, too
            let mut turned = DMatrix::zeros(directions.nrows(), N_OF_BODY);
            turned.column_mut(2).copy_from(&directions_of(v, &a).column(0));
            let (left, of_rows) = (&flow * &directions - turned, rows * &directions);
            for (k, same) in rigid.iter_mut().enumerate() {
                let size = directions.column(k).amax();
                *same &= left.column(k).amax() <= SAME * flow.amax() * size
                    && (of_rows.nrows() == 0 || of_rows.column(k).amax() <= SAME * size);
            }
        }
        Ok(Self { rigid, turns: turns(system, &states[0])? })
    }

    /// The deviations that the rigid motions are.
    pub(super) fn directions(&self, state: &State) -> DMatrix<f64> {
        directions(state).select_columns((0..N_OF_BODY).filter(|&k| self.rigid[k]).collect::<Vec<_>>().iter())
    }

    /// How far a state is from another one, by the first body, and there alone where nothing depends on it.
    pub(super) fn moved(&self, first: &State, last: &State) -> [f64; N_OF_BODY] {
        std::array::from_fn(|k| if self.rigid[k] { last.q[k] - first.q[k] } else { 0.0 })
    }

    /// The last state, moved back so that its first body is where that of the first one is; whole turns are taken off.
    pub(super) fn back(&self, first: &State, last: &State) -> State {
        let moved = self.moved(first, last);
        let place = |state: &State, k: usize| if self.rigid[k] { state.q[k] } else { 0.0 };
        let [from, to] = [last, first].map(|state| [0, 1].map(|k| place(state, k)));
        let (sin, cos) = moved[2].sin_cos();
        let turned = |[x, y]: [f64; 2]| [cos * x + sin * y, cos * y - sin * x];
        let mut back = last.clone();
        for i in (0..last.q.len()).step_by(N_OF_BODY) {
            let [x, y] = turned([last.q[i] - from[0], last.q[i + 1] - from[1]]);
            let [vx, vy] = turned([last.v[i], last.v[i + 1]]);
            (back.q[i], back.q[i + 1]) = (x + to[0], y + to[1]);
            (back.v[i], back.v[i + 1]) = (vx, vy);
            let angle = &mut back.q[i + 2];
            *angle -= moved[2];
            if self.turns[i + 2] {
                *angle -= TAU * ((*angle - first.q[i + 2]) / TAU).round();
            }
        }
        back
    }
}

/// Deviations by a metre along x, along y, and by a radian about the origin.
fn directions(state: &State) -> DMatrix<f64> {
    let n_q = state.q.len();
    let mut directions = DMatrix::zeros(2 * n_q + state.z.len(), N_OF_BODY);
    directions.column_mut(2).rows_mut(0, 2 * n_q).copy_from(&directions_of(&state.q, &state.v));
    for i in (0..n_q).step_by(N_OF_BODY) {
        (directions[(i, 0)], directions[(i + 1, 1)], directions[(i + 2, 2)]) = (1.0, 1.0, 1.0);
    }
    directions
}

/// Two vectors, one below the other, after a turn by a radian, to first order.
fn directions_of(q: &[f64], v: &[f64]) -> DMatrix<f64> {
    let turned = |x: &[f64], i: usize| match i % N_OF_BODY {
        0 => -x[i + 1],
        1 => x[i - 1],
        _ => 0.0,
    };
    DMatrix::from_fn(q.len() + v.len(), 1, |i, _| if i < q.len() { turned(q, i) } else { turned(v, i - q.len()) })
}

/// Which angles change no acceleration by a whole turn: none where a spring is wound by it.
fn turns<P: SceneRef>(system: &mut System<P>, state: &State) -> Result<Vec<bool>, AnalysisError> {
    let (before, _) = accelerations(system, state)?;
    let mut turns = vec![false; state.q.len()];
    for i in (2..state.q.len()).step_by(N_OF_BODY) {
        let mut turned = state.clone();
        turned.q[i] += TAU;
        // a state without accelerations is not the same
        let Ok((after, _)) = accelerations(system, &turned) else { continue };
        let size = before.iter().chain(&after).fold(1.0, |size: f64, x| size.max(x.abs()));
        turns[i] = before.iter().zip(&after).all(|(x, y)| (x - y).abs() <= SAME * size);
    }
    Ok(turns)
}
