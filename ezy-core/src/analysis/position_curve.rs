//! The curve of the positions that constraints allow, over one coordinate: places at given values, and where it is singular.
//!
//! # Source
//! Keller (1977), Numerical solution of bifurcation and nonlinear eigenvalue problems; Haug (1989), section 3.7: singular configurations.

use super::orientation::Orientation;
use super::position_rows::{PositionRows, bordered, solve};
use super::root::{BETWEEN, lagrange, sign_change};
use super::tolerances::continuation::{BESIDE, COARSE, FOLD, MAX_POINTS, SAME, SHORTEST, STRIDE, TURN};
use crate::model::SceneRef;
use nalgebra::{DMatrix, DVector};
use std::f64::consts::TAU;

/// A place with the tangent there, a unit vector in scaled coordinates.
#[derive(Debug, Clone)]
pub(super) struct Node {
    pub q: Vec<f64>,
    pub tangent: DVector<f64>,
}

/// What a place of the curve is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Mark {
    /// The end of a step.
    Step,
    /// That of a value, by its place among the values.
    Value(usize),
    /// The coordinate turns back.
    DeadCentre,
    /// Another curve is met.
    ChangePoint,
}

/// How a walk ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum WalkEnd {
    /// Outside the range.
    Range,
    /// Where it began.
    Closed,
    /// Newton's method leads no further.
    Lost,
    /// After so many steps as are made at most.
    TooLong,
}

/// Places in the order in which they were met, without the first one.
pub(super) struct Walk {
    pub points: Vec<(Vec<f64>, Mark)>,
    pub end: WalkEnd,
}

pub(super) struct PositionCurve<'r, 's, P: SceneRef> {
    pub rows: &'r PositionRows<'s, P>,
    /// Place of the coordinate among those that may move.
    pub held: usize,
    /// Ascending values at which places are asked for.
    pub values: &'r [f64],
    /// Where a walk ends.
    pub range: [f64; 2],
    /// Which of what may move is an angle.
    pub angles: Vec<bool>,
}

/// Points are too far apart.
struct Unclear;

/// What happens on a step, by its length up to there.
type Events = Vec<(f64, Vec<f64>, Mark)>;

impl<P: SceneRef> PositionCurve<'_, '_, P> {
    fn value(&self, q: &[f64]) -> f64 {
        q[self.rows.active()[self.held]]
    }

    /// How the value changes along the tangent.
    fn slope(&self, node: &Node) -> f64 {
        node.tangent[self.held]
    }

    /// The place a length along the tangent on, with the tangent there.
    pub(super) fn step(&self, from: &Node, length: f64) -> Option<Node> {
        let borders = DMatrix::from_columns(std::slice::from_ref(&from.tangent));
        let q = self.rows.corrected(&from.q, &borders, &(&from.tangent * length), STRIDE)?;
        let jacobian = self.rows.at(&q)?.jacobian;
        let mut right = DVector::zeros(jacobian.nrows() + 1);
        right[jacobian.nrows()] = 1.0;
        let found = solve(bordered(&jacobian, &borders), &DMatrix::from_columns(&[right]))?;
        let tangent = found.column(0).normalize();
        tangent.iter().all(|x| x.is_finite()).then_some(Node { q, tangent })
    }

    /// The longest step.
    pub(super) fn longest(node: &Node) -> f64 {
        STRIDE / node.tangent.amax()
    }

    /// Along the tangent of the first place, until the range is left.
    pub(super) fn walk(&self, start: &Node) -> Walk {
        let (mut points, mut from, mut share) = (Vec::new(), start.clone(), 1.0_f64);
        for n in 0..MAX_POINTS {
            share = (2.0 * share).min(1.0);
            let (mut length, mut to, mut events) = loop {
                let length = share * Self::longest(&from);
                if let Some((to, events)) = self.next(&from, length) {
                    break (length, to, events);
                }
                share *= 0.5;
                if share < SHORTEST {
                    return Walk { points, end: WalkEnd::Lost };
                }
            };
            let closing = if n == 0 { None } else { self.passing(&from, length, start) };
            let closed = closing.and_then(|on| self.next(&from, on).map(|(to, events)| (on, to, events)));
            let is_closed = closed.is_some();
            if let Some(closed) = closed {
                (length, to, events) = closed;
            }
            let is_out = self.put(&from, &to, length, events, &mut points);
            if is_closed || is_out {
                return Walk { points, end: if is_out { WalkEnd::Range } else { WalkEnd::Closed } };
            }
            from = to;
        }
        Walk { points, end: WalkEnd::TooLong }
    }

    /// The place a step on, and what is singular on the way; none where the step is too long.
    fn next(&self, from: &Node, length: f64) -> Option<(Node, Events)> {
        let to = self.step(from, length)?;
        if from.tangent.dot(&to.tangent) < TURN {
            return None;
        }
        let fold = self.fold(from, &to, length).ok()?;
        let change = self.change(from, &to, length).ok()?;
        let mut events: Events = fold.into_iter().chain(change).collect();
        events.sort_by(|a, b| a.0.total_cmp(&b.0));
        Some((to, events))
    }

    /// Where the value turns back.
    fn fold(&self, from: &Node, to: &Node, length: f64) -> Result<Option<(f64, Vec<f64>, Mark)>, Unclear> {
        let ends = [self.slope(from), self.slope(to)];
        if ends[0].is_sign_positive() == ends[1].is_sign_positive() {
            return Ok(None);
        }
        let slope = |x: f64| self.step(from, x).map(|node| self.slope(&node)).ok_or(Unclear);
        let [a, b] = sign_change([0.0, length], ends, FOLD * length, slope)?;
        let on = 0.5 * (a + b);
        let node = self.step(from, on).ok_or(Unclear)?;
        Ok(Some((on, node.q, Mark::DeadCentre)))
    }

    /// Where another curve is met: the smallest singular value of the bordered Jacobian vanishes. Beside such a place rounding is amplified, so it is
    /// interpolated from places at a distance.
    fn change(&self, from: &Node, to: &Node, length: f64) -> Result<Option<(f64, Vec<f64>, Mark)>, Unclear> {
        let borders = DMatrix::from_columns(std::slice::from_ref(&from.tangent));
        let matrix = |q: &[f64]| self.rows.at(q).map(|at| bordered(&at.jacobian, &borders)).ok_or(Unclear);
        let first = matrix(&from.q)?;
        let seen = Orientation::of(first.clone());
        let ends = [seen.smallest(&first), seen.smallest(&matrix(&to.q)?)];
        if ends[0].is_sign_positive() == ends[1].is_sign_positive() {
            return Ok(None);
        }
        let sample = |x: f64| {
            let node = self.step(from, x).ok_or(Unclear)?;
            Ok((seen.smallest(&matrix(&node.q)?), self.rows.apart(&from.q, &node.q)))
        };
        let [a, b] = sign_change([0.0, length], ends, COARSE * length, |x| sample(x).map(|(f, _)| f))?;
        let (middle, offset) = (0.5 * (a + b), BESIDE * length);
        let places = BETWEEN.map(|place| middle + offset * place);
        let samples = places.into_iter().map(sample).collect::<Result<Vec<_>, _>>()?;
        let f = |x: f64| lagrange(&places, x).iter().zip(&samples).map(|(weight, (f, _))| weight * f).sum::<f64>();
        let bounds = [middle - offset, middle + offset];
        let values = bounds.map(f);
        if values[0].is_sign_positive() == values[1].is_sign_positive() {
            return Err(Unclear);
        }
        let [a, b] = sign_change(bounds, values, FOLD * length, |x| Ok::<_, Unclear>(f(x)))?;
        let on = 0.5 * (a + b);
        let mut step = DVector::zeros(from.tangent.len());
        lagrange(&places, on).iter().zip(&samples).for_each(|(weight, (_, sample))| step += sample * *weight);
        Ok(Some((on, self.rows.moved(&from.q, &step), Mark::ChangePoint)))
    }

    /// Writes what is met on a step; whether it leaves the range.
    fn put(&self, from: &Node, to: &Node, length: f64, events: Events, points: &mut Vec<(Vec<f64>, Mark)>) -> bool {
        let [least, most] = self.range;
        let mut begin = (0.0, self.value(&from.q));
        for (on, q, mark) in events.into_iter().chain([(length, to.q.clone(), Mark::Step)]) {
            let value = self.value(&q);
            points.extend(self.values_between(from, begin, (on, value)));
            if !(least..=most).contains(&value) {
                return true;
            }
            points.push((q, mark));
            begin = (on, value);
        }
        false
    }

    /// Places at the values that are passed between two lengths, where the coordinate changes in one sense.
    fn values_between(&self, from: &Node, a: (f64, f64), b: (f64, f64)) -> Vec<(Vec<f64>, Mark)> {
        let is_passed = |value: &f64| (a.1 < *value && *value <= b.1) || (b.1 <= *value && *value < a.1);
        let passed = self.values.iter().enumerate().filter(|(_, value)| is_passed(value));
        let mut found: Vec<(f64, Vec<f64>, Mark)> = passed
            .filter_map(|(i, &value)| {
                let ends = [a.1 - value, b.1 - value];
                let on = match ends[1] == 0.0 {
                    true => b.0,
                    false => {
                        let off = |x: f64| self.step(from, x).map(|node| self.value(&node.q) - value).ok_or(Unclear);
                        let [c, d] = sign_change([a.0, b.0], ends, FOLD * (b.0 - a.0), off).ok()?;
                        0.5 * (c + d)
                    }
                };
                let mut q = self.step(from, on)?.q;
                q[self.rows.active()[self.held]] = value;
                Some((on, q, Mark::Value(i)))
            })
            .collect();
        found.sort_by(|x, y| x.0.total_cmp(&y.0));
        found.into_iter().map(|(_, q, mark)| (q, mark)).collect()
    }

    /// How far along the tangent the first place is, where a step passes it, but for whole turns.
    fn passing(&self, from: &Node, length: f64, start: &Node) -> Option<f64> {
        let on = self.without_turns(&from.q, &start.q).dot(&from.tangent);
        if !(0.0 < on && on <= length) || self.without_turns(&from.q, &start.q).amax() > 2.0 * STRIDE {
            return None;
        }
        let node = self.step(from, on)?;
        (self.without_turns(&node.q, &start.q).amax() <= SAME * STRIDE).then_some(on)
    }

    /// The scaled step between two places, without whole turns of what is not held.
    fn without_turns(&self, from: &[f64], to: &[f64]) -> DVector<f64> {
        let mut apart = self.rows.apart(from, to);
        for (j, apart) in apart.iter_mut().enumerate() {
            if self.angles[j] && j != self.held {
                *apart -= TAU * (*apart / TAU).round();
            }
        }
        apart
    }
}
