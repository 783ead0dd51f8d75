//! A curve of steady motions over a value: points on it, and its tangent.
//!
//! # Source
//! Keller (1977), Numerical solution of bifurcation and nonlinear eigenvalue problems; Govaerts, Numerical Methods for Bifurcations of
//! Dynamical Equilibria (2000), chapter 2.

use super::Linearization;
use super::error::AnalysisError;
use super::position_rows::{bordered, solve};
use super::row_space::RowSpace;
use super::scaling::reciprocal;
use super::spectrum::Spectrum;
use super::steady_equations::{SteadyEquations, Unknowns};
use super::steady_motion::SteadyMotion;
use super::tolerances::continuation::{CORRECTIONS, FAR, LAST_CORRECTION, SAME, STRIDE};
use super::tolerances::search::FREE;
use crate::dynamics::By;
use crate::model::{Name, SceneRef};
use nalgebra::{DMatrix, DVector};
use std::f64::consts::TAU;

/// What varies along a curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Varied {
    /// A parameter of the scene.
    Parameter(usize),
    /// An input.
    Input(usize),
    /// One of the unknowns.
    Unknown(usize),
}

/// A point of the curve.
#[derive(Debug, Clone)]
pub(super) struct Place {
    pub unknowns: Unknowns,
    pub value: f64,
}

/// A point with the tangent of the curve, a unit vector in scaled unknowns.
#[derive(Debug, Clone)]
pub(super) struct Node {
    pub place: Place,
    pub tangent: DVector<f64>,
    /// Which unknowns keep their values, as many as are free everywhere: the place and the heading of a vehicle, for one.
    pub kept: Vec<usize>,
}

pub(super) struct Curve<'e, 's, P: SceneRef> {
    pub equations: &'e mut SteadyEquations<'s, P>,
    varied: Varied,
    parameters: Vec<f64>,
    /// Which of the unknowns, and behind them the value where it is none of them, change.
    active: Vec<usize>,
    /// A stride of each, in its own unit; zero where none is seen, of multipliers and of the frame.
    strides: DVector<f64>,
    /// The units in which steps are measured: strides, and what makes columns of the Jacobian alike where there is none.
    units: DVector<f64>,
    /// The largest multiplier so far.
    force: f64,
    /// Names of what is free, as of the start.
    free: Vec<Name>,
}

/// The equations at a place, scaled.
pub(super) struct Scaled {
    pub jacobian: DMatrix<f64>,
    residual: DVector<f64>,
    is_met: bool,
}

impl<'e, 's, P: SceneRef> Curve<'e, 's, P> {
    /// Through a steady motion, over a value whose steps are at most `step`, with some unknowns that do not change.
    pub(super) fn new(
        equations: &'e mut SteadyEquations<'s, P>,
        motion: &SteadyMotion,
        varied: Varied,
        held: &[bool],
        step: f64,
    ) -> Result<(Self, Place), AnalysisError> {
        let unknowns =
            Unknowns { state: motion.state.clone(), frame: motion.frame, multipliers: motion.multipliers.clone() };
        let values = equations.values(&unknowns);
        let parameters = equations.parameters();
        let value = match varied {
            Varied::Parameter(i) => parameters[i],
            Varied::Input(i) => equations.system.inputs()[i],
            Varied::Unknown(i) => values[i],
        };
        let mut active: Vec<usize> = (0..values.len()).filter(|&i| !held[i]).collect();
        if !matches!(varied, Varied::Unknown(_)) {
            active.push(values.len());
        }
        let mut strides = equations.strides(&unknowns, STRIDE);
        let of_value = match varied {
            Varied::Unknown(i) => i,
            _ => {
                strides.push(0.0);
                values.len()
            }
        };
        strides[of_value] = step;
        let strides = DVector::from_iterator(active.len(), active.iter().map(|&i| strides[i]));
        let place = Place { unknowns, value };
        let units = DVector::from_element(active.len(), 1.0);
        let mut new =
            Self { equations, varied, parameters, active, units, strides, force: 0.0, free: motion.free.clone() };
        let at = new.at(&place)?;
        let columns = at.jacobian.column_iter().zip(&new.strides);
        let units = columns.map(|(column, stride)| if *stride > 0.0 { *stride } else { reciprocal(column.norm()) });
        new.units = DVector::from_iterator(new.active.len(), units);
        Ok((new, place))
    }

    /// Place of the value among what changes.
    pub(super) fn of_value(&self) -> usize {
        let i = match self.varied {
            Varied::Unknown(i) => i,
            _ => return self.active.len() - 1,
        };
        self.active.binary_search(&i).unwrap_or_default()
    }

    /// What changes, as a scaled vector.
    pub(super) fn vector(&self, place: &Place) -> DVector<f64> {
        let values = self.equations.values(&place.unknowns);
        DVector::from_fn(self.active.len(), |j, _| {
            values.get(self.active[j]).copied().unwrap_or(place.value) / self.units[j]
        })
    }

    /// The place a scaled step on.
    pub(super) fn moved(&self, from: &Place, step: &DVector<f64>) -> Place {
        let n = self.equations.values(&from.unknowns).len();
        let mut all = DVector::zeros(n + 1);
        self.active.iter().enumerate().for_each(|(j, &i)| all[i] = self.units[j] * step[j]);
        let unknowns = self.equations.moved(&from.unknowns, &all.rows(0, n).into_owned(), 1.0);
        let value = match self.varied {
            Varied::Unknown(i) => self.equations.values(&unknowns)[i],
            _ => from.value + all[n],
        };
        Place { unknowns, value }
    }

    /// Sets the value where the scene reads it.
    pub(super) fn place_value(&mut self, value: f64) -> Result<(), AnalysisError> {
        match self.varied {
            Varied::Parameter(i) if self.parameters[i] != value => {
                self.parameters[i] = value;
                self.equations.place_parameters(&self.parameters)
            }
            Varied::Input(i) => {
                self.equations.system.inputs_mut()[i] = value;
                Ok(())
            }
            _ => Ok(()),
        }
    }

    pub(super) fn at(&mut self, place: &Place) -> Result<Scaled, AnalysisError> {
        self.place_value(place.value)?;
        let mut at = self.equations.at(&place.unknowns);
        let n = at.jacobian.ncols();
        let by_value = match self.varied {
            Varied::Parameter(i) => Some(self.equations.slopes(&place.unknowns, By::Parameters).column(i).into_owned()),
            Varied::Input(i) => Some(self.equations.slopes(&place.unknowns, By::Inputs).column(i).into_owned()),
            Varied::Unknown(_) => None,
        };
        let mut jacobian = DMatrix::zeros(at.jacobian.nrows(), self.active.len());
        for (j, &i) in self.active.iter().enumerate() {
            match &by_value {
                Some(by_value) if i == n => jacobian.set_column(j, by_value),
                _ => jacobian.set_column(j, &at.jacobian.column(i)),
            }
            jacobian.column_mut(j).scale_mut(self.units[j]);
        }
        // where forces cancel, that of the value may be their largest term
        let size = place.value.abs().max(self.strides[self.of_value()]);
        let of_value = at.terms.iter_mut().zip(by_value.iter().flat_map(|by_value| by_value.iter()));
        of_value.for_each(|(terms, slope)| *terms = terms.max((slope * size).abs()));
        let is_met = at.is_met();
        let mut residual = at.residual;
        for (mut row, residual) in jacobian.row_iter_mut().zip(residual.iter_mut()) {
            let scale = reciprocal(row.norm());
            row *= scale;
            *residual *= scale;
        }
        Ok(Scaled { jacobian, residual, is_met })
    }

    /// The first point, with the tangent along which the value rises. None where the value cannot change there.
    pub(super) fn first(&mut self, place: Place) -> Result<Option<Node>, AnalysisError> {
        let jacobian = self.at(&place)?.jacobian;
        let scene = self.equations.info.name;
        let mut rows = RowSpace::of(&jacobian, FREE).ok_or(AnalysisError::NotFinite { scene })?;
        let basis = rows.null_space();
        let along = basis.row(self.of_value()).transpose();
        let norm = along.norm();
        if basis.is_empty() || norm <= FREE.sqrt() {
            return Ok(None);
        }
        // the value's own direction in the null space, and what is orthogonal to it there
        let tangent = &basis * along / norm;
        let left = &basis - &tangent * (tangent.transpose() * &basis);
        let kept = self.to_keep(left, basis.ncols() - 1);
        self.node(place, &tangent, &kept)
    }

    /// Of as many directions as are free the unknowns that are moved most: coordinates before velocities, and multipliers last.
    fn to_keep(&self, mut left: DMatrix<f64>, n: usize) -> Vec<usize> {
        let n_q = self.equations.info.n_coordinates();
        let is_coordinate = |j: &usize| self.active[*j] < n_q;
        let is_seen = |j: &usize| self.strides[*j] > 0.0;
        let mut kept = Vec::new();
        for _ in 0..n {
            let largest = |places: &dyn Fn(&usize) -> bool| {
                let norms = (0..left.nrows()).filter(places).map(|j| (j, left.row(j).norm()));
                norms.max_by(|a, b| a.1.total_cmp(&b.1))
            };
            let most = largest(&|_| true).map_or(0.0, |(_, norm)| norm);
            let first = [largest(&is_coordinate), largest(&is_seen), largest(&|_| true)];
            let Some((j, norm)) = first.into_iter().flatten().find(|(_, norm)| *norm >= most / FAR) else { break };
            let row = left.row(j).transpose() / norm;
            left -= (&left * &row) * row.transpose();
            kept.push(j);
        }
        kept
    }

    /// The longest step that is no more than a stride of anything.
    pub(super) fn longest(&self, node: &Node) -> f64 {
        seen(&node.tangent, &self.strides).amax().recip()
    }

    /// Differences of two places, each in its unit; of angles without whole turns.
    fn apart(&self, from: &Place, to: &Place) -> DVector<f64> {
        let mut apart = self.vector(to) - self.vector(from);
        for (j, &i) in self.active.iter().enumerate() {
            apart[j] *= self.units[j];
            if self.equations.info.coordinates.get(i).is_some_and(|c| c.is_angle()) {
                apart[j] -= TAU * (apart[j] / TAU).round();
            }
        }
        apart
    }

    /// Cosine of the angle by which what is seen of the curve turns.
    pub(super) fn cosine(&self, from: &Node, to: &Node) -> f64 {
        let [from, to] = [from, to].map(|node| seen(&node.tangent, &self.strides));
        from.dot(&to) / (from.norm() * to.norm())
    }

    /// Newton's method from a step on, whose components along the borders stay: none where it does not converge.
    fn corrected(
        &mut self,
        from: &Place,
        borders: &DMatrix<f64>,
        step: &DVector<f64>,
    ) -> Result<Option<Place>, AnalysisError> {
        let (first, goal) = (self.vector(from), borders.tr_mul(step));
        let mut place = self.moved(from, step);
        for _ in 0..CORRECTIONS {
            let at = match self.at(&place) {
                Ok(at) => at,
                // a mass below zero, for one: the curve ends before it
                Err(AnalysisError::System(_)) => return Ok(None),
                Err(error) => return Err(error),
            };
            if at.residual.iter().any(|r| !r.is_finite()) || at.jacobian.iter().any(|x| !x.is_finite()) {
                return Ok(None);
            }
            let left = &goal - borders.tr_mul(&(self.vector(&place) - &first));
            let mut right = DVector::zeros(at.residual.len() + left.len());
            right.rows_mut(0, at.residual.len()).copy_from(&-&at.residual);
            right.rows_mut(at.residual.len(), left.len()).copy_from(&left);
            let Some(change) = solve(bordered(&at.jacobian, borders), &DMatrix::from_columns(&[right])) else {
                return Ok(None);
            };
            let change = change.column(0).into_owned();
            place = self.moved(&place, &change);
            if seen(&change, &self.strides).amax() <= LAST_CORRECTION {
                return Ok(if self.at(&place)?.is_met { Some(place) } else { None });
            }
        }
        Ok(None)
    }

    /// A border for each unknown that is kept, and `last`.
    pub(super) fn borders(&self, kept: &[usize], last: &DVector<f64>) -> DMatrix<f64> {
        let mut borders = DMatrix::zeros(last.len(), kept.len() + 1);
        kept.iter().enumerate().for_each(|(k, &j)| borders[(j, k)] = 1.0);
        borders.set_column(kept.len(), last);
        borders
    }

    /// The point a length along the tangent on, with the tangent there; none where Newton's method does not lead to one.
    pub(super) fn step(&mut self, from: &Node, length: f64) -> Result<Option<Node>, AnalysisError> {
        let borders = self.borders(&from.kept, &from.tangent);
        let Some(place) = self.corrected(&from.place, &borders, &(&from.tangent * length))? else { return Ok(None) };
        self.node(place, &from.tangent, &from.kept)
    }

    /// The tangent at a place, from one nearby; other unknowns are kept where those would move others far.
    fn node(&mut self, place: Place, near: &DVector<f64>, kept: &[usize]) -> Result<Option<Node>, AnalysisError> {
        let jacobian = self.at(&place)?.jacobian;
        self.force = place.unknowns.multipliers.iter().fold(self.force, |largest, x| largest.max(x.abs()));
        let mut kept = kept.to_vec();
        loop {
            let k = kept.len();
            let mut right = DMatrix::zeros(jacobian.nrows() + k + 1, k + 1);
            right.rows_mut(jacobian.nrows(), k + 1).fill_with_identity();
            let borders = self.borders(&kept, near);
            let Some(found) = solve(bordered(&jacobian, &borders), &right) else { return Ok(None) };
            let free = found.columns(0, k).into_owned();
            let others = self.to_keep(free.clone().qr().q(), k);
            if free.iter().any(|x| x.abs() > FAR) && others != kept {
                kept = others;
                continue;
            }
            let tangent = found.column(k).normalize();
            return Ok(Some(Node { place, tangent, kept }));
        }
    }

    /// The point at which the value is `value`, between two points.
    pub(super) fn at_value(&mut self, from: &Node, to: &Node, value: f64) -> Result<Option<Node>, AnalysisError> {
        let share = (value - from.place.value) / (to.place.value - from.place.value);
        let step = (self.vector(&to.place) - self.vector(&from.place)) * share;
        let mut own = DVector::zeros(step.len());
        own[self.of_value()] = 1.0;
        let borders = self.borders(&from.kept, &own);
        let Some(mut place) = self.corrected(&from.place, &borders, &step)? else { return Ok(None) };
        if let Varied::Parameter(_) | Varied::Input(_) = self.varied {
            place.value = value;
        }
        self.node(place, &from.tangent, &from.kept)
    }

    /// How far along the tangent a place is.
    pub(super) fn length(&self, from: &Node, to: &Place) -> f64 {
        (self.vector(to) - self.vector(&from.place)).dot(&from.tangent)
    }

    /// The point at which a step passes a place, but for whole turns, and how far that is.
    pub(super) fn passing(
        &mut self,
        from: &Node,
        length: f64,
        place: &Place,
    ) -> Result<Option<(Node, f64)>, AnalysisError> {
        if !self.is_same(&from.place, place, 2.0) {
            return Ok(None);
        }
        let apart = self.apart(&from.place, place);
        let on = apart.component_div(&self.units).dot(&from.tangent);
        if !(0.0..=length).contains(&on) {
            return Ok(None);
        }
        let node = self.step(from, on)?;
        Ok(node.filter(|node| self.is_same(&node.place, place, SAME)).map(|node| (node, on)))
    }

    /// Whether two places are one, but for whole turns, within a share of a stride.
    pub(super) fn is_same(&self, a: &Place, b: &Place, share: f64) -> bool {
        let apart = self.apart(a, b);
        let mut multipliers = a.unknowns.multipliers.iter().zip(&b.unknowns.multipliers);
        apart.iter().zip(&self.strides).all(|(apart, stride)| *stride == 0.0 || apart.abs() <= share * stride)
            && multipliers.all(|(a, b)| (a - b).abs() <= share * self.force)
    }

    /// The error of a curve that is lost where it was seen.
    pub(super) fn lost(&mut self, at: &Place) -> AnalysisError {
        let equations = self.equations.at(&at.unknowns);
        self.equations.not_found(&equations, CORRECTIONS)
    }

    /// The steady motion at a place with its eigenvalues.
    pub(super) fn motion(&mut self, place: &Place) -> Result<(SteadyMotion, Spectrum), AnalysisError> {
        self.place_value(place.value)?;
        let motion = SteadyMotion::of(place.unknowns.clone(), self.free.clone(), 0);
        let spectrum = Linearization::of(self.equations.system, &motion)?.spectrum()?;
        Ok((motion, spectrum))
    }
}

/// What is seen of a step: no multipliers.
fn seen(step: &DVector<f64>, strides: &DVector<f64>) -> DVector<f64> {
    step.zip_map(strides, |step, stride| if stride > 0.0 { step } else { 0.0 })
}
