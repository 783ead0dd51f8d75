//! Ways of assembly and singular positions over one coordinate, off the curve of all positions.

use super::error::AnalysisError;
use super::position_curve::{Mark, Node, PositionCurve, Walk, WalkEnd};
use super::position_rows::PositionRows;
use super::tolerances::workspace::{END, UNMOVED};
use super::workspace_branch::{AssemblyBranch, Limit, ReachEnd, SingularPosition, Singularity};
use crate::model::{SceneInfo, SceneRef};
use nalgebra::DMatrix;

/// All coordinates at each value; none where that is not reached.
type Positions = Vec<Option<Vec<f64>>>;

/// Branches and singular positions over one coordinate.
pub(super) fn over_one<P: SceneRef>(
    info: &SceneInfo,
    rows: &PositionRows<'_, P>,
    held: usize,
    values: &[f64],
    q: Vec<f64>,
    null: &DMatrix<f64>,
) -> Result<(Vec<AssemblyBranch>, Vec<SingularPosition>), AnalysisError> {
    let of_value = rows.active()[held];
    let [least, most] = [values[0], values[values.len() - 1]];
    // from a start outside the range, the walk leads into it
    let range = [least.min(q[of_value]), most.max(q[of_value])];
    let angles = rows.active().iter().map(|&i| info.coordinates[i].is_angle()).collect();
    let curve = PositionCurve { rows, held, values, range, angles };
    let start = Node { q, tangent: null.column(0).into_owned() };
    let stands_still = |node: &Node| node.tangent[held].abs() <= UNMOVED;
    if stands_still(&start) {
        let next = curve.step(&start, PositionCurve::<P>::longest(&start));
        if next.is_none_or(|next| stands_still(&next)) {
            let names = info.coordinates[of_value].name.to_string();
            return Err(AnalysisError::Fixed { scene: info.name, names });
        }
    }
    let path = Path::of(&curve, &start, values);
    let over = Over { of_value, values, path: &path };
    let (mut branches, mut of_start) = (Vec::new(), 0);
    for piece in path.pieces() {
        if piece.iter().any(|(q, _)| *q == start.q) {
            of_start = branches.len();
        }
        if let Some((positions, ends)) = over.reached(piece) {
            branches.push(AssemblyBranch::new(rows, &[held], positions, Some(ends)));
        }
    }
    if of_start < branches.len() {
        branches[..=of_start].rotate_right(1);
    }
    Ok((branches, over.singular()))
}

/// A curve over the values of one coordinate.
struct Over<'a> {
    /// Place of the coordinate.
    of_value: usize,
    values: &'a [f64],
    path: &'a Path,
}

impl Over<'_> {
    fn range(&self) -> [f64; 2] {
        [self.values[0], self.values[self.values.len() - 1]]
    }

    /// Differences of values that are rounding.
    fn slack(&self) -> f64 {
        let [least, most] = self.range();
        END * (most - least)
    }

    fn is_inside(&self, q: &[f64]) -> bool {
        let ([least, most], value) = (self.range(), q[self.of_value]);
        least - self.slack() <= value && value <= most + self.slack()
    }

    /// Positions at the values, and where a piece of the curve ends within their range; none where it is outside.
    fn reached(&self, piece: &[(Vec<f64>, Mark)]) -> Option<(Positions, [ReachEnd; 2])> {
        let within: Vec<&(Vec<f64>, Mark)> = piece.iter().filter(|(q, _)| self.is_inside(q)).collect();
        let mut positions = vec![None; self.values.len()];
        for (q, mark) in &within {
            match mark {
                Mark::Value(i) => positions[*i] = Some(q.clone()),
                // of a value that is one but for rounding, where no step ends
                Mark::DeadCentre | Mark::ChangePoint => {
                    let is_here = |value: &f64| (value - q[self.of_value]).abs() <= self.slack();
                    self.values.iter().position(is_here).into_iter().for_each(|i| positions[i] = Some(q.clone()));
                }
                Mark::Step => {}
            }
        }
        let by_value =
            |a: &&&(Vec<f64>, Mark), b: &&&(Vec<f64>, Mark)| a.0[self.of_value].total_cmp(&b.0[self.of_value]);
        let [first, last] = [within.iter().min_by(by_value)?, within.iter().max_by(by_value)?].map(|end| self.end(end));
        Some((positions, [first, last]))
    }

    fn end(&self, (q, mark): &(Vec<f64>, Mark)) -> ReachEnd {
        let value = q[self.of_value];
        let at_end = self.range().iter().any(|end| (value - end).abs() <= self.slack());
        let is_first = self.path.points.first().is_some_and(|point| point.0 == *q);
        let limit = match (mark, at_end) {
            (Mark::DeadCentre, _) => Limit::DeadCentre,
            (_, true) => Limit::Range,
            _ => self.path.ends[usize::from(!is_first)],
        };
        ReachEnd { value, q: q.clone(), limit }
    }

    /// In ascending order of the coordinate.
    fn singular(&self) -> Vec<SingularPosition> {
        // the first dead centre of a closed curve is its last one, too
        let points = self.path.points.iter().skip(usize::from(self.path.is_closed));
        let mut singular: Vec<SingularPosition> = points
            .filter(|(q, _)| self.is_inside(q))
            .filter_map(|(q, mark)| {
                let kind = match mark {
                    Mark::DeadCentre => Singularity::DeadCentre,
                    Mark::ChangePoint => Singularity::ChangePoint,
                    Mark::Step | Mark::Value(_) => return None,
                };
                Some(SingularPosition { value: q[self.of_value], q: q.clone(), kind })
            })
            .collect();
        singular.sort_by(|a, b| a.value.total_cmp(&b.value));
        singular
    }
}

/// All places of the curve, one after the other.
struct Path {
    points: Vec<(Vec<f64>, Mark)>,
    ends: [Limit; 2],
    /// A closed curve begins and ends at the same dead centre.
    is_closed: bool,
}

impl Path {
    fn of<P: SceneRef>(curve: &PositionCurve<'_, '_, P>, start: &Node, values: &[f64]) -> Self {
        let value = start.q[curve.rows.active()[curve.held]];
        let mark = values.iter().position(|known| *known == value).map_or(Mark::Step, Mark::Value);
        let first = (start.q.clone(), mark);
        let Walk { points: mut ahead, end } = curve.walk(start);
        if end == WalkEnd::Closed {
            // without a dead centre a coordinate that comes back does not change
            let turn = ahead.iter().position(|(_, mark)| *mark == Mark::DeadCentre).unwrap_or_default();
            // the last place is the first one again
            ahead.pop();
            ahead.push(first);
            ahead.rotate_left(turn);
            ahead.extend(ahead.first().cloned());
            return Self { points: ahead, ends: [Limit::DeadCentre; 2], is_closed: true };
        }
        let back = curve.walk(&Node { q: start.q.clone(), tangent: -&start.tangent });
        let ends = [back.end, end].map(|end| match end {
            WalkEnd::Range | WalkEnd::Closed => Limit::Range,
            WalkEnd::Lost => Limit::Lost,
            WalkEnd::TooLong => Limit::TooLong,
        });
        let points = back.points.into_iter().rev().chain([first]).chain(ahead).collect();
        Self { points, ends, is_closed: false }
    }

    /// From dead centre to dead centre, both included.
    fn pieces(&self) -> Vec<&[(Vec<f64>, Mark)]> {
        let last = self.points.len().saturating_sub(1);
        let turns = self.points.iter().enumerate().filter(|(_, (_, mark))| *mark == Mark::DeadCentre).map(|(i, _)| i);
        let mut bounds: Vec<usize> = [0].into_iter().chain(turns).chain([last]).collect();
        bounds.dedup();
        bounds.windows(2).map(|pair| &self.points[pair[0]..=pair[1]]).collect()
    }
}
