//! Which values of one or two coordinates a mechanism reaches, and where it is singular.

use super::error::AnalysisError;
use super::position_rows::PositionRows;
use super::tolerances::workspace::{INDEPENDENT, UNMOVED};
use super::workspace_branch::{AssemblyBranch, SingularPosition};
use super::workspace_curve::over_one;
use super::workspace_grid::Grid;
use crate::dynamics::System;
use crate::model::{SceneInfo, SceneRef, Start};
use nalgebra::DMatrix;
use std::sync::Arc;

/// A coordinate and the values at which it is held.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    /// Name of the coordinate.
    pub name: String,
    /// Values in m or rad, ascending.
    pub values: Vec<f64>,
}

/// The positions of a mechanism with one or two coordinates held at the values of a grid.
#[derive(Debug, Clone, PartialEq)]
pub struct Workspace {
    /// The coordinates that are held.
    pub axes: Vec<Axis>,
    /// Ways of assembly, that of the start first. Over one coordinate those that dead centres join to it; over two that of the start alone.
    pub branches: Vec<AssemblyBranch>,
    /// Singular positions over one coordinate, in ascending order of it; of two coordinates the map of singular values tells.
    pub singular: Vec<SingularPosition>,
}

/// How a workspace is asked for, resolved.
struct Request {
    axes: Vec<usize>,
    active: Vec<usize>,
    left_out: Vec<usize>,
}

impl Workspace {
    /// Assembles the mechanism near a start with the coordinates of `axes`, one or two, held at their values, from neighbour to neighbour. Coordinates
    /// named in `hold` keep their values of the start. Position rows named in `without`, the drives of what is held, are left out; a name stands for all
    /// rows that begin with it and a dot.
    ///
    /// Over one coordinate the curve of all positions through the start is followed around dead centres; singular positions on it are found to
    /// 1e-10 of an angle in rad and of the mechanism's length. Other ways of assembly, which meet it in change points or nowhere, need a start of
    /// their own.
    ///
    /// # Errors
    /// [`AnalysisError`]; [`AnalysisError::Prescribed`] names drives to leave out, [`AnalysisError::Undetermined`] coordinates to hold.
    ///
    /// # Cost
    /// A factorisation of all position rows for each place and each Newton step, 20 to 40 steps a radian over one coordinate.
    pub fn of<P: SceneRef>(
        system: &mut System<P>,
        start: &Start,
        axes: &[Axis],
        hold: &[&str],
        without: &[&str],
    ) -> Result<Self, AnalysisError> {
        let info = Arc::clone(system.info());
        if !info.is_planar() {
            return Err(AnalysisError::Spatial { scene: info.name });
        }
        let request = Request::new(&info, axes, hold, without)?;
        let state = system.consistent_start(start)?;
        let rows = PositionRows::new(system, state.t, &request.left_out, request.active.clone());
        let held = request.places();
        let null = rows.null_space(&state.q, INDEPENDENT)?;
        request.check(&info, &rows, &null)?;
        let (branches, singular) = match (&held[..], axes) {
            (&[held], [axis]) => over_one(&info, &rows, held, &axis.values, state.q, &null)?,
            (&[first, second], [x, y]) => {
                let grid = Grid { rows: &rows, held: [first, second], values: [&x.values, &y.values] };
                let positions = grid.positions(&state.q);
                (vec![AssemblyBranch::new(&rows, &held, positions, None)], Vec::new())
            }
            _ => return Err(AnalysisError::Axes { what: format!("the number of them, {}", axes.len()) }),
        };
        Ok(Self { axes: axes.to_vec(), branches, singular })
    }
}

impl Request {
    fn new(info: &SceneInfo, axes: &[Axis], hold: &[&str], without: &[&str]) -> Result<Self, AnalysisError> {
        if !(1..=2).contains(&axes.len()) {
            return Err(AnalysisError::Axes { what: format!("the number of them, {}", axes.len()) });
        }
        let unknown = |kind, name: &str, known: Vec<&str>| AnalysisError::Unknown {
            scene: info.name,
            kind,
            name: name.to_owned(),
            known: known.join(", "),
        };
        let coordinate = |name: &str| {
            let found = info.coordinates.iter().position(|c| *c.name == *name);
            found.ok_or_else(|| unknown("coordinate", name, info.coordinates.iter().map(|c| &*c.name).collect()))
        };
        let held = hold.iter().map(|name| coordinate(name)).collect::<Result<Vec<_>, _>>()?;
        let mut places = Vec::new();
        for Axis { name, values } in axes {
            let place = coordinate(name)?;
            if places.contains(&place) || held.contains(&place) {
                return Err(AnalysisError::Axes { what: format!("`{name}`, which is named twice") });
            }
            if values.len() < 2 || !values.windows(2).all(|pair| pair[0] < pair[1]) || !values[0].is_finite() {
                return Err(AnalysisError::Axes { what: format!("the values of `{name}`") });
            }
            places.push(place);
        }
        let position_rows = || info.rows.iter().take(info.n_position_rows);
        let mut left_out = Vec::new();
        for name in without {
            let is_meant = |row: &str| row == *name || base(row) == *name;
            let found = position_rows().enumerate().filter(|(_, row)| is_meant(&row.name)).map(|(i, _)| i);
            let n = left_out.len();
            left_out.extend(found);
            if left_out.len() == n {
                return Err(unknown("position row", name, position_rows().map(|row| &*row.name).collect()));
            }
        }
        let active = (0..info.n_coordinates()).filter(|i| !held.contains(i)).collect();
        Ok(Self { axes: places, active, left_out })
    }

    /// Places of the axes among what may move.
    fn places(&self) -> Vec<usize> {
        self.axes.iter().filter_map(|axis| self.active.binary_search(axis).ok()).collect()
    }

    /// That the held coordinates can change, and determine all others.
    fn check<P: SceneRef>(
        &self,
        info: &SceneInfo,
        rows: &PositionRows<'_, P>,
        null: &DMatrix<f64>,
    ) -> Result<(), AnalysisError> {
        let (scene, places) = (info.name, self.places());
        let moves = null.select_rows(&places);
        let n_moves = if moves.is_empty() {
            0
        } else {
            moves.clone().svd(false, false).singular_values.iter().filter(|x| **x > UNMOVED).count()
        };
        let names = |of: &[usize]| of.iter().map(|&i| &*info.coordinates[i].name).collect::<Vec<_>>().join("`, `");
        if n_moves < places.len() {
            let mut drives: Vec<String> = (rows.kept().iter())
                .filter(|&&row| info.rows[row].kind == "drive")
                .map(|&row| format!("`{}`", base(&info.rows[row].name)))
                .collect();
            drives.dedup();
            let names = names(&self.axes);
            if !drives.is_empty() {
                return Err(AnalysisError::Prescribed { scene, names, rows: drives.join(", ") });
            }
            // at a dead centre one coordinate stands still, and moves nonetheless
            if places.len() > 1 || null.ncols() == 0 {
                return Err(AnalysisError::Fixed { scene, names });
            }
        }
        if null.ncols() > places.len() {
            let extent = |j: &usize| null.row(*j).norm();
            let mut free: Vec<usize> = (0..self.active.len()).filter(|j| !places.contains(j)).collect();
            free.sort_by(|a, b| {
                let is_angle = |j: &usize| info.coordinates[self.active[*j]].is_angle();
                is_angle(b).cmp(&is_angle(a)).then(extent(b).total_cmp(&extent(a)))
            });
            let free: Vec<usize> = free.into_iter().filter(|j| extent(j) > UNMOVED).map(|j| self.active[j]).collect();
            let names = format!("`{}`", names(&free[..free.len().min(null.ncols() - places.len())]));
            return Err(AnalysisError::Undetermined { scene, n_free: null.ncols(), n_axes: places.len(), names });
        }
        Ok(())
    }
}

/// The name of what has several rows: `motor` of `motor.x`.
fn base(row: &str) -> &str {
    row.rsplit_once('.').map_or(row, |(base, _)| base)
}
