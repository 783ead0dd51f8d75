//! The search for rest and steady motions, by damped Newton steps on the exact Jacobian.

use super::error::AnalysisError;
use super::frame::Frame;
use super::relaxation::relaxed;
use super::scaling::Scaling;
use super::steady_equations::{SteadyEquations, Unknowns};
use super::steady_motion::SteadyMotion;
use super::tolerances::search::{FREE, LAST, MAX_HALVINGS, MAX_STEPS};
use crate::dynamics::System;
use crate::model::{Name, SceneRef, Start};
use nalgebra::DMatrix;
use std::sync::Arc;

/// The steady motion near the consistent state of a start, with the rows as they are switched now. Newton's steps are at most `longest`, in turns
/// of 1 rad and sizes of the mechanism.
pub(super) fn with_rows<P: SceneRef>(
    system: &mut System<P>,
    start: &Start,
    hold: &[&str],
    longest: f64,
) -> Result<SteadyMotion, AnalysisError> {
    let info = Arc::clone(system.info());
    let state = system.consistent_start(start)?;
    let still = state.v.iter().all(|v| *v == 0.0);
    let frame = if still { Frame::default() } else { Frame::of(&state.q, &state.v) };
    let mut multipliers = vec![0.0; info.n_rows()];
    // a first guess; next to a singular position there is none
    if system.accelerations(state.t, &state.q, &state.v, &mut vec![0.0; info.n_velocities()], &mut multipliers).is_err()
    {
        multipliers.fill(0.0);
    }
    let mut equations = SteadyEquations::new(system, &state.v)?;
    search(&mut equations, Unknowns { state, frame, multipliers }, hold, longest)
}

/// Newton's steps from `start`; where they find no rest, from where the mechanism would come to rest by itself.
fn search<P: SceneRef>(
    equations: &mut SteadyEquations<'_, P>,
    start: Unknowns,
    hold: &[&str],
    longest: f64,
) -> Result<SteadyMotion, AnalysisError> {
    let held = held(equations, hold)?;
    let found = newton(equations, start.clone(), &held, longest);
    if equations.moves || !matches!(found, Err(AnalysisError::NotFound { .. })) {
        return found;
    }
    match relaxed(equations, &start, &held) {
        Some(nearer) => newton(equations, nearer, &held, longest).or(found),
        None => found,
    }
}

/// Newton's steps, at most `longest`, halved until the residual falls.
fn newton<P: SceneRef>(
    equations: &mut SteadyEquations<'_, P>,
    mut point: Unknowns,
    held: &[bool],
    longest: f64,
) -> Result<SteadyMotion, AnalysisError> {
    let not_finite = AnalysisError::NotFinite { scene: equations.info.name };
    let mut at = equations.at(&point);
    if !at.is_finite() {
        return Err(not_finite);
    }
    let scaling = Scaling::of(&at.jacobian, held);
    for n_steps in 0..MAX_STEPS {
        let residual = scaling.residual(&at);
        let Some((mut rows, step)) = scaling.step(&at.jacobian, &residual) else { return Err(not_finite) };
        let longest = longest / equations.reach(&point, &step);
        let (norm, mut share, mut found) = (residual.norm(), longest.min(1.0), None);
        for _ in 0..MAX_HALVINGS {
            let tried = equations.moved(&point, &step, share);
            let at = equations.at(&tried);
            if at.is_finite() && scaling.residual(&at).norm() < norm {
                found = Some((tried, at));
                break;
            }
            share *= 0.5;
        }
        let (no_better, is_small) = (found.is_none(), equations.is_small(&point, &step, LAST));
        if let Some(found) = found {
            (point, at) = found;
        }
        // of velocities and multipliers a step may leave more than of positions
        let is_last = no_better || is_small && at.is_met();
        if !is_last {
            continue;
        }
        if !at.is_met() {
            return Err(equations.not_found(&at, n_steps));
        }
        let point = equations.settled(point);
        return Ok(SteadyMotion::of(point, free(&equations.names(), rows.null_space(), &scaling.columns), n_steps));
    }
    Err(equations.not_found(&at, MAX_STEPS))
}

/// Names of as many unknowns as directions are free, each the largest of what is left of one.
fn free(names: &[Option<Name>], mut left: DMatrix<f64>, columns: &[f64]) -> Vec<Name> {
    let mut free = Vec::new();
    for _ in 0..left.ncols() {
        let places = (0..names.len()).filter(|&j| names[j].is_some() && columns[j] > 0.0);
        let norms = places.map(|j| (j, left.row(j).norm()));
        let Some((best, norm)) = norms.max_by(|a, b| a.1.total_cmp(&b.1)) else { break };
        let Some(name) = names[best].clone().filter(|_| norm * norm > FREE.sqrt()) else { break };
        let row = left.row(best).transpose() / norm;
        left -= (&left * &row) * row.transpose();
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
