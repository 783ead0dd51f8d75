//! Rest and steady motions, by damped Newton steps on the exact Jacobian.

use super::error::AnalysisError;
use super::frame::Frame;
use super::steady_equations::{Evaluated, SteadyEquations, Unknowns};
use super::tolerances::search::{FREE, LAST, MAX_HALVINGS, MAX_STEPS, STRAIGHT};
use crate::dynamics::{State, System};
use crate::model::coordinate::N_OF_BODY;
use crate::model::{Name, SceneRef, Start};
use nalgebra::{DMatrix, DVector, Dyn, SVD};
use std::sync::Arc;

/// A motion that is constant seen from a frame; at rest in that of the ground where nothing moves.
#[derive(Debug, Clone, PartialEq)]
pub struct SteadyMotion {
    /// Time, coordinates, velocities and first-order states.
    pub state: State,
    /// Accelerations, `n_v`: those of the turn of the frame.
    pub accelerations: Vec<f64>,
    /// Multipliers, `n_c`.
    pub multipliers: Vec<f64>,
    /// The frame in which it rests.
    pub frame: Frame,
    /// Coordinates, velocities and states in which the steady motions next to it differ: as many as directions are free.
    pub free: Vec<Name>,
    /// Newton steps that it took.
    pub n_steps: usize,
}

impl SteadyMotion {
    /// The steady motion near the consistent state of a start. Where all velocities of that are zero, it is rest; else a frame may travel
    /// and turn. Coordinates, velocities and first-order states that are named in `hold` keep their values of the start; what else the
    /// equations leave free stays as near to the start as it can.
    ///
    /// # Errors
    /// [`AnalysisError`]; [`AnalysisError::NotFound`] names the equation that is left most.
    pub fn near<P: SceneRef>(system: &mut System<P>, start: &Start, hold: &[&str]) -> Result<Self, AnalysisError> {
        let info = Arc::clone(system.info());
        if !info.is_planar() {
            return Err(AnalysisError::Spatial { scene: info.name });
        }
        let state = system.consistent_start(start)?;
        let moves = state.v.iter().any(|v| *v != 0.0);
        let frame = if moves { Frame::of(&state.q, &state.v) } else { Frame::default() };
        let mut multipliers = vec![0.0; info.n_rows()];
        // a first guess; next to a singular position there is none
        if system
            .accelerations(state.t, &state.q, &state.v, &mut vec![0.0; info.n_velocities()], &mut multipliers)
            .is_err()
        {
            multipliers.fill(0.0);
        }
        search(&mut SteadyEquations::new(system, moves)?, Unknowns { state, frame, multipliers }, hold)
    }

    /// That of a point at which the equations are met.
    pub(super) fn of(point: Unknowns, free: Vec<Name>, n_steps: usize) -> Self {
        let Unknowns { state, frame, multipliers } = point;
        let mut accelerations = vec![0.0; state.v.len()];
        frame.turn(&state.v, &mut accelerations);
        Self { state, accelerations, multipliers, frame, free, n_steps }
    }

    /// How it goes on: of which kind the frame is.
    pub fn course(&self) -> Course {
        let (State { q, v, .. }, Frame { vx, vy, omega }) = (&self.state, self.frame);
        if v.iter().all(|v| *v == 0.0) {
            return Course::Rest;
        }
        let first = [0, 1].map(|part| q.get(part).copied().unwrap_or_default());
        let speed = f64::hypot(vx - omega * first[1], vy + omega * first[0]);
        // distances from the first body: what the place of the whole mechanism is does not matter
        let size = q.chunks_exact(N_OF_BODY).map(|q| f64::hypot(q[0] - first[0], q[1] - first[1])).fold(1.0, f64::max);
        match (omega * size).abs() <= STRAIGHT * speed || omega == 0.0 {
            true if speed == 0.0 => Course::InPlace,
            true => Course::Straight { speed },
            false => {
                let centre = [-vy / omega, vx / omega];
                Course::Circle { centre, turn_rate: omega, speed, radius: speed / omega.abs() }
            }
        }
    }
}

/// How a steady motion goes on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Course {
    /// Nothing moves.
    Rest,
    /// No body moves on, but parts turn evenly, such as wheels and disks.
    InPlace,
    /// Along a straight line.
    Straight {
        /// Speed, m/s.
        speed: f64,
    },
    /// Around a point.
    Circle {
        /// The point, m.
        centre: [f64; 2],
        /// Turn rate, rad/s, against the clock.
        turn_rate: f64,
        /// Speed of the first body, m/s.
        speed: f64,
        /// Of the centre of mass of the first body, m.
        radius: f64,
    },
}

/// Newton's steps from `start`, halved until the residual falls.
fn search<P: SceneRef>(
    equations: &mut SteadyEquations<'_, P>,
    start: Unknowns,
    hold: &[&str],
) -> Result<SteadyMotion, AnalysisError> {
    let held = held(equations, hold)?;
    let (mut point, mut at) = (start.clone(), equations.at(&start));
    let sizes = at.jacobian.column_iter().zip(&held);
    let columns: Vec<f64> = sizes.map(|(column, held)| if *held { 0.0 } else { reciprocal(column.norm()) }).collect();
    let rows: Vec<f64> = (at.jacobian.row_iter())
        .map(|row| reciprocal(row.iter().zip(&columns).map(|(x, c)| (x * c).powi(2)).sum::<f64>().sqrt()))
        .collect();
    let scaled = |at: &Evaluated| {
        let jacobian = DMatrix::from_fn(rows.len(), columns.len(), |i, j| rows[i] * at.jacobian[(i, j)] * columns[j]);
        (jacobian, DVector::from_fn(rows.len(), |i, _| rows[i] * at.residual[i]))
    };
    for n_steps in 0..MAX_STEPS {
        let (jacobian, residual) = scaled(&at);
        let svd = jacobian.svd(true, true);
        let tolerance = FREE * svd.singular_values.max();
        let step = svd.solve(&-&residual, tolerance).unwrap_or_else(|_| DVector::zeros(columns.len()));
        let step = DVector::from_fn(columns.len(), |j, _| columns[j] * step[j]);
        let (norm, mut share, mut found) = (residual.norm(), 1.0, None);
        for _ in 0..MAX_HALVINGS {
            let tried = equations.moved(&point, &step, share);
            let at = equations.at(&tried);
            if scaled(&at).1.norm() < norm {
                found = Some((tried, at));
                break;
            }
            share *= 0.5;
        }
        let is_last = found.is_none() || equations.is_small(&point, &step, LAST);
        if let Some(found) = found {
            (point, at) = found;
        }
        if !is_last {
            continue;
        }
        if !at.is_met() {
            return Err(equations.not_found(&at, n_steps));
        }
        return Ok(SteadyMotion::of(point, free(&equations.names(), &svd, &columns), n_steps));
    }
    Err(equations.not_found(&at, MAX_STEPS))
}

/// Names of as many unknowns as directions are free, each the largest of what is left of one.
fn free(names: &[Option<Name>], svd: &SVD<f64, Dyn, Dyn>, columns: &[f64]) -> Vec<Name> {
    let Some(v_t) = &svd.v_t else { return Vec::new() };
    let tolerance = FREE * svd.singular_values.max();
    let fixed: Vec<usize> = (0..v_t.nrows()).filter(|&i| svd.singular_values[i] > tolerance).collect();
    let range = v_t.select_rows(&fixed);
    // the projector onto the null space
    let mut left = DMatrix::identity(columns.len(), columns.len()) - range.tr_mul(&range);
    let mut free = Vec::new();
    while free.len() + fixed.len() < columns.len() {
        let places = (0..names.len()).filter(|&j| names[j].is_some() && columns[j] > 0.0);
        let best = places.max_by(|&i, &j| left[(i, i)].total_cmp(&left[(j, j)]));
        let Some((best, name)) = best.and_then(|best| Some((best, names[best].clone()?))) else { break };
        if left[(best, best)] <= FREE.sqrt() {
            break;
        }
        let column = left.column(best).clone_owned() / left[(best, best)].sqrt();
        left -= &column * column.transpose();
        free.push(name);
    }
    free
}

/// Which unknowns are held.
pub(super) fn held<P: SceneRef>(equations: &SteadyEquations<'_, P>, hold: &[&str]) -> Result<Vec<bool>, AnalysisError> {
    let names = equations.names();
    let mut held = vec![false; names.len()];
    for name in hold {
        let place = names.iter().position(|of| of.as_deref() == Some(*name));
        let scene = equations.info.name;
        held[place.ok_or_else(|| AnalysisError::UnknownHeld { scene, name: (*name).to_owned() })?] = true;
    }
    Ok(held)
}

pub(super) fn reciprocal(x: f64) -> f64 {
    if x > 0.0 { x.recip() } else { 1.0 }
}
