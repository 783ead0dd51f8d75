//! Folds of a curve, and where it meets others.
//!
//! # Source
//! Govaerts, Numerical Methods for Bifurcations of Dynamical Equilibria (2000), chapter 4.

use super::curve::{Curve, Node, Place};
use super::error::AnalysisError;
use super::orientation::Orientation;
use super::position_rows::bordered;
use super::root::{BETWEEN, lagrange, sign_change};
use super::tolerances::continuation::{ACROSS, BESIDE, COARSE, FOLD};
use crate::model::SceneRef;
use nalgebra::{DMatrix, DVector};

/// What is between two points.
pub(super) enum Between<T> {
    Nothing,
    Found(T),
    /// The points are too far apart to tell.
    Unclear,
}

impl<P: SceneRef> Curve<'_, '_, P> {
    /// How the value changes along the tangent.
    pub(super) fn slope(&self, node: &Node) -> f64 {
        node.tangent[self.of_value()]
    }

    /// The fold between a point and one that is `length` on, where the value turns back.
    pub(super) fn fold(&mut self, from: &Node, to: &Node, length: f64) -> Result<Between<Place>, AnalysisError> {
        let ends = [self.slope(from), self.slope(to)];
        if ends[0].is_sign_positive() == ends[1].is_sign_positive() {
            return Ok(Between::Nothing);
        }
        let found = sign_change([0.0, length], ends, FOLD * length, |x| {
            let node = self.step(from, x)?.ok_or(Stop::Unclear)?;
            Ok(self.slope(&node))
        });
        let middle = match found {
            Ok([a, b]) => self.step(from, 0.5 * (a + b))?,
            Err(Stop::Unclear) => None,
            Err(Stop::Failed(error)) => return Err(error),
        };
        Ok(middle.map_or(Between::Unclear, |node| Between::Found(node.place)))
    }

    /// Where another curve is met between a point and one that is `length` on: where the bordered Jacobian is singular, as its determinant
    /// changes its sign.
    pub(super) fn meeting(&mut self, from: &Node, to: &Node, length: f64) -> Result<Between<Node>, AnalysisError> {
        let borders = self.borders(&from.kept, &from.tangent);
        let first = bordered(&self.at(&from.place)?.jacobian, &borders);
        let last = bordered(&self.at(&to.place)?.jacobian, &borders);
        let seen = Seen { from, borders, orientation: Orientation::of(first.clone()) };
        let ends = [&first, &last].map(|matrix| seen.orientation.smallest(matrix));
        if ends[0].is_sign_positive() == ends[1].is_sign_positive() {
            return Ok(Between::Nothing);
        }
        match self.singular(&seen, ends, length) {
            Ok(place) => Ok(self.across(place, &seen)?.map_or(Between::Unclear, Between::Found)),
            Err(Stop::Unclear) => Ok(Between::Unclear),
            Err(Stop::Failed(error)) => Err(error),
        }
    }

    /// Where the smallest singular value vanishes. Beside such a place rounding is amplified, so it is interpolated from points at a distance.
    fn singular(&mut self, seen: &Seen<'_>, ends: [f64; 2], length: f64) -> Result<Place, Stop> {
        let from = seen.from;
        let [a, b] = sign_change([0.0, length], ends, COARSE * length, |x| self.sample(seen, x).map(|(f, _)| f))?;
        let (middle, offset) = (0.5 * (a + b), BESIDE * length);
        let places = BETWEEN.map(|place| middle + offset * place);
        let samples = places.into_iter().map(|x| self.sample(seen, x)).collect::<Result<Vec<_>, _>>()?;
        let weights = |x: f64| lagrange(&places, x);
        let f = |x: f64| weights(x).iter().zip(&samples).map(|(weight, (f, _))| weight * f).sum::<f64>();
        let bounds = [middle - offset, middle + offset];
        let values = bounds.map(f);
        // a sign that changes where nothing is singular: the directions have turned too far
        if values[0].is_sign_positive() == values[1].is_sign_positive() || values[0].abs() > ends[0].abs() {
            return Err(Stop::Unclear);
        }
        let [a, b] = sign_change(bounds, values, FOLD * length, |x| Ok::<_, Stop>(f(x)))?;
        let mut vector = DVector::zeros(from.tangent.len());
        weights(0.5 * (a + b)).iter().zip(&samples).for_each(|(weight, (_, sample))| vector += sample * *weight);
        Ok(self.moved(&from.place, &(vector - self.vector(&from.place))))
    }

    /// The smallest singular value and the place, a length on.
    fn sample(&mut self, seen: &Seen<'_>, x: f64) -> Result<(f64, DVector<f64>), Stop> {
        let node = self.step(seen.from, x)?.ok_or(Stop::Unclear)?;
        let matrix = bordered(&self.at(&node.place)?.jacobian, &seen.borders);
        Ok((seen.orientation.smallest(&matrix), self.vector(&node.place)))
    }

    /// A place where another curve is met, with the direction of that.
    fn across(&mut self, place: Place, seen: &Seen<'_>) -> Result<Option<Node>, AnalysisError> {
        let svd = bordered(&self.at(&place)?.jacobian, &seen.borders).svd(false, true);
        let smallest = svd.singular_values.imin();
        let kept = seen.from.kept.clone();
        Ok(svd.v_t.map(|v_t| Node { place, tangent: v_t.row(smallest).transpose(), kept }))
    }

    /// The first point of the other curve of a meeting, on one side.
    pub(super) fn other(&mut self, of: &Node, side: f64, share: f64) -> Result<Option<Node>, AnalysisError> {
        let start = Node { tangent: &of.tangent * side, ..of.clone() };
        let length = share * self.longest(&start);
        let Some(node) = self.step(&start, length)? else { return Ok(None) };
        // the curve it comes from is as far across only where it is far away
        let apart = self.vector(&node.place) - self.vector(&of.place);
        Ok(Some(node).filter(|_| apart.norm() <= ACROSS * length))
    }
}

/// From where signs of determinants are seen.
struct Seen<'n> {
    from: &'n Node,
    borders: DMatrix<f64>,
    orientation: Orientation,
}

/// Why a place between two points is not found.
enum Stop {
    Unclear,
    Failed(AnalysisError),
}

impl From<AnalysisError> for Stop {
    fn from(error: AnalysisError) -> Self {
        Self::Failed(error)
    }
}
