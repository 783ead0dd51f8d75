//! Steady motions over a value that varies: branches, folds, branch points, and where stability changes.

use super::curve::{Curve, Node, Place, Varied};
use super::curve_meetings::Between;
use super::error::AnalysisError;
use super::locus::{Instability, Locus};
use super::newton::held;
use super::one_sided;
use super::spectrum::Spectrum;
use super::steady_equations::{SteadyEquations, place_parameters};
use super::steady_motion::SteadyMotion;
use super::tolerances::continuation::{ASIDE, MAX_BRANCHES, MAX_POINTS, SAME, SHORTEST, TURN};
use crate::dynamics::{Gradients, System};
use crate::model::{SceneRef, Start};

/// The steady motions of a scene over a value.
#[derive(Debug, Clone, PartialEq)]
pub struct BifurcationDiagram {
    /// What varies.
    pub name: String,
    /// The branch of the start first, then those that leave others at branch points, in the order in which they were met.
    pub branches: Vec<Branch>,
    /// Whether branch points are left that were not followed, because there were too many.
    pub is_complete: bool,
}

/// A curve of steady motions.
#[derive(Debug, Clone, PartialEq)]
pub struct Branch {
    /// Along the curve.
    pub points: Vec<BranchPoint>,
    /// Why it ends at its first and at its last point.
    pub ends: [BranchEnd; 2],
}

/// A steady motion on a branch.
#[derive(Debug, Clone, PartialEq)]
pub struct BranchPoint {
    /// The value that varies.
    pub value: f64,
    /// The motion.
    pub motion: SteadyMotion,
    /// Its eigenvalues.
    pub spectrum: Spectrum,
    /// What happens there; at most points nothing.
    pub bifurcation: Option<Bifurcation>,
}

/// A point at which solutions appear, meet, or change their stability.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Bifurcation {
    /// The value turns back: two motions meet and vanish. Also known as a limit point or saddle-node.
    Fold,
    /// Two branches cross.
    BranchPoint,
    /// A pair of eigenvalues ±iω crosses the imaginary axis: a Hopf bifurcation.
    Oscillation {
        /// ω, rad/s.
        omega: f64,
    },
    /// A real eigenvalue crosses zero, and neither a fold nor a branch point is there.
    Divergence,
}

/// Why a branch ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BranchEnd {
    /// At an end of the values.
    Range,
    /// At the branch point at which it begins, or where it began.
    Closed,
    /// At a branch point, from which other branches go on.
    BranchPoint,
    /// The equations have no solution next to it: a position that cannot be passed, or a law that is not smooth.
    Lost,
    /// A stop is met, or would have to pull, or a skate would have to hold more than its limit: other rows hold beyond.
    Switch,
    /// It goes on; it has too many points.
    TooLong,
}

/// A branch to one side, as it was walked.
struct Half {
    nodes: Vec<Node>,
    points: Vec<BranchPoint>,
    /// Length to the next node.
    lengths: Vec<f64>,
    /// Behind which node, how far, and what.
    met: Vec<(usize, f64, Met)>,
    end: BranchEnd,
}

enum Met {
    Fold(Place),
    /// With the direction of the other branch.
    Meeting(Node),
}

impl BifurcationDiagram {
    /// The branch through the steady motion near a start, over the values from `range[0]` to `range[1]`, in steps of at most `step`, and all branches that leave it.
    /// What varies is, by its name, a parameter, an input, or a coordinate, velocity or first-order state of the start. It begins at the present value, or, where
    /// that is out of range, at the nearest end. `hold` is that of [`SteadyMotion::near`]; what is free otherwise stays as near to the start as it can.
    ///
    /// Folds and branch points are right to 1e-10 of the value. A branch that touches no other one and not the start's is not found: see
    /// [`Rests`](super::Rests).
    ///
    /// # Errors
    /// Those of [`SteadyMotion::near`] at the first value; [`AnalysisError::Unknown`], [`AnalysisError::CannotVary`].
    ///
    /// # Cost
    /// For each point some five factorisations of the equations, the eigenvalues, and one singular value decomposition.
    pub fn of<P: SceneRef>(
        system: &mut System<P>,
        start: &Start,
        hold: &[&str],
        name: &str,
        range: [f64; 2],
        step: f64,
    ) -> Result<Self, AnalysisError> {
        // what varies keeps its value at the first point alone
        let hold: Vec<&str> = hold.iter().copied().filter(|held| *held != name).collect();
        let (motion, varied) = first_motion(system, start, &hold, name, range)?;
        let pushing = one_sided::pushing(system.info().stop, &motion);
        let mut equations = SteadyEquations::new(system, &motion.state.v)?;
        let varied = match varied {
            Named::Parameter(i) => Varied::Parameter(i),
            Named::Input(i) => Varied::Input(i),
            Named::Start => {
                let place = equations.names().iter().position(|known| known.as_deref() == Some(name));
                place.map(Varied::Unknown).ok_or_else(|| cannot_vary(&equations, name))?
            }
        };
        let held = held(&equations, &hold)?;
        let (mut curve, place) = Curve::new(&mut equations, &motion, varied, &held, step)?;
        let Some(first) = curve.first(place)? else { return Err(cannot_vary(curve.equations, name)) };
        let mut explorer =
            Explorer { curve, range, meetings: Vec::new(), branches: Vec::new(), pushing, is_switched: false };
        explorer.branch(&first)?;
        let mut next = 0;
        while next < explorer.meetings.len() && explorer.branches.len() < MAX_BRANCHES {
            explorer.follow(next)?;
            next += 1;
        }
        let is_complete = next == explorer.meetings.len();
        Ok(Self { name: name.to_owned(), branches: explorer.branches, is_complete })
    }
}

fn cannot_vary<P: SceneRef>(equations: &SteadyEquations<'_, P>, name: &str) -> AnalysisError {
    AnalysisError::CannotVary { scene: equations.info.name, name: name.to_owned() }
}

/// What a name belongs to.
enum Named {
    Parameter(usize),
    Input(usize),
    Start,
}

/// The steady motion at the first value.
fn first_motion<P: SceneRef>(
    system: &mut System<P>,
    start: &Start,
    hold: &[&str],
    name: &str,
    range: [f64; 2],
) -> Result<(SteadyMotion, Named), AnalysisError> {
    let info = std::sync::Arc::clone(system.info());
    let within = |value: f64| value.clamp(range[0].min(range[1]), range[0].max(range[1]));
    let mut start = start.clone();
    let mut hold = hold.to_vec();
    let named = if let Some(i) = info.parameters.iter().position(|known| known.name == name) {
        let mut parameters = Gradients::new(system)?.parameters();
        parameters[i] = within(parameters[i]);
        place_parameters(system, &parameters)?;
        Named::Parameter(i)
    } else if let Some(i) = info.inputs.iter().position(|known| known.name == name) {
        let value = within(system.inputs()[i]);
        system.inputs_mut()[i] = value;
        Named::Input(i)
    } else {
        if let Some(i) = info.coordinates.iter().position(|known| *known.name == *name) {
            start.give_position(i, within(start.q[i]));
        } else if let Some(i) = info.velocities.iter().position(|known| *known.name == *name) {
            start.give_velocity(i, within(start.v[i]));
        } else if let Some(i) = info.states.iter().position(|known| known.name == name) {
            start.z[i] = within(start.z[i]);
        } else {
            let known =
                info.parameters.iter().map(|known| known.name).chain(info.inputs.iter().map(|known| known.name));
            let known = known.chain(info.coordinates.iter().chain(&*info.velocities).map(|known| &*known.name));
            let known = known.chain(info.states.iter().map(|known| known.name)).collect::<Vec<_>>().join(", ");
            return Err(AnalysisError::Unknown { scene: info.name, kind: "value", name: name.to_owned(), known });
        }
        hold.push(name);
        Named::Start
    };
    Ok((SteadyMotion::near(system, &start, &hold)?, named))
}

struct Explorer<'e, 's, P: SceneRef> {
    curve: Curve<'e, 's, P>,
    range: [f64; 2],
    /// Branch points, and whether the branches there are known.
    meetings: Vec<(Node, bool)>,
    branches: Vec<Branch>,
    /// The end of the stop that pushes at the start.
    pushing: Option<usize>,
    /// Whether the last attempt failed because other rows would hold.
    is_switched: bool,
}

impl<P: SceneRef> Explorer<'_, '_, P> {
    /// Walks to both sides of a point.
    fn branch(&mut self, first: &Node) -> Result<(), AnalysisError> {
        let forwards = self.walk(vec![first.clone()], Vec::new())?;
        let branch = if forwards.end == BranchEnd::Closed {
            let points = self.points(&forwards)?;
            Branch { points, ends: [BranchEnd::Closed; 2] }
        } else {
            let backwards = self.walk(vec![Node { tangent: -&first.tangent, ..first.clone() }], Vec::new())?;
            let mut points = self.points(&backwards)?;
            points.reverse();
            points.pop();
            points.extend(self.points(&forwards)?);
            Branch { points, ends: [backwards.end, forwards.end] }
        };
        self.branches.push(branch);
        Ok(())
    }

    /// The branches that leave a branch point across the one on which it was met.
    fn follow(&mut self, i: usize) -> Result<(), AnalysisError> {
        if self.meetings[i].1 {
            return Ok(());
        }
        self.meetings[i].1 = true;
        let meeting = self.meetings[i].0.clone();
        for side in [1.0, -1.0] {
            let Some(first) = self.curve.other(&meeting, side, ASIDE)? else { continue };
            let from = Node { place: meeting.place.clone(), ..first.clone() };
            let length = ASIDE * self.curve.longest(&first);
            let half = self.walk(vec![from, first], vec![length])?;
            let (points, end) = (self.points(&half)?, half.end);
            self.branches.push(Branch { points, ends: [BranchEnd::BranchPoint, end] });
            if end == BranchEnd::Closed {
                break;
            }
        }
        Ok(())
    }

    /// From the last of the nodes on, to where the branch ends.
    fn walk(&mut self, nodes: Vec<Node>, lengths: Vec<f64>) -> Result<Half, AnalysisError> {
        let points = nodes.iter().map(|node| self.point(&node.place, None)).collect::<Result<Vec<_>, _>>()?;
        let mut half = Half { nodes, points, lengths, met: Vec::new(), end: BranchEnd::TooLong };
        let mut share: f64 = 1.0;
        while half.nodes.len() < MAX_POINTS && half.end == BranchEnd::TooLong {
            let from = half.nodes[half.nodes.len() - 1].clone();
            let Some(step) = self.attempt(&from, share * self.curve.longest(&from))? else {
                share *= 0.5;
                if share < SHORTEST {
                    half.end = if self.is_switched { BranchEnd::Switch } else { BranchEnd::Lost };
                }
                continue;
            };
            share = (2.0 * share).min(1.0);
            let closed =
                if half.nodes.len() > 2 { self.curve.passing(&from, step.length, &half.nodes[0].place)? } else { None };
            let (to, point, length) = match closed {
                Some((to, length)) => {
                    half.end = BranchEnd::Closed;
                    let point = self.point(&to.place, None)?;
                    (to, point, length)
                }
                None => {
                    if step.is_last {
                        half.end = BranchEnd::Range;
                    }
                    (step.to, step.point, step.length)
                }
            };
            let segment = half.lengths.len();
            for (at, met) in step.met {
                if let Met::Meeting(meeting) = &met {
                    self.note(meeting);
                }
                if at < length {
                    half.met.push((segment, at, met));
                }
            }
            half.lengths.push(length);
            half.points.push(point);
            half.nodes.push(to);
        }
        Ok(half)
    }

    /// One step; none where it is too long.
    fn attempt(&mut self, from: &Node, length: f64) -> Result<Option<Step>, AnalysisError> {
        self.is_switched = false;
        let Some(mut to) = self.curve.step(from, length)? else { return Ok(None) };
        if self.curve.cosine(from, &to) < TURN {
            return Ok(None);
        }
        let (mut length, value) = (length, to.place.value);
        let bound = value.clamp(self.range[0].min(self.range[1]), self.range[0].max(self.range[1]));
        let is_last = value != bound;
        if is_last {
            let Some(end) = self.curve.at_value(from, &to, bound)? else { return Ok(None) };
            to = end;
            length = self.curve.length(from, &to.place);
        }
        // next to where a mechanism ends, forces grow until nothing else is left of the equations
        let point = match self.point(&to.place, None) {
            Err(AnalysisError::NotSteady { .. } | AnalysisError::NoEigenvalues { .. }) => return Ok(None),
            point => point?,
        };
        if !one_sided::is_kept(self.curve.equations.system, self.pushing, &point.motion) {
            self.is_switched = true;
            return Ok(None);
        }
        let mut met = Vec::new();
        match self.curve.meeting(from, &to, length)? {
            Between::Unclear => return Ok(None),
            Between::Found(meeting) => met.push((self.curve.length(from, &meeting.place), Met::Meeting(meeting))),
            Between::Nothing => {}
        }
        match self.curve.fold(from, &to, length)? {
            Between::Unclear => return Ok(None),
            // the curve that is met may fold there
            Between::Found(fold) if met.iter().all(|(_, met)| !self.curve.is_same(&fold, met.place(), SAME)) => {
                met.push((self.curve.length(from, &fold), Met::Fold(fold)));
            }
            Between::Found(_) | Between::Nothing => {}
        }
        met.sort_by(|a, b| a.0.total_cmp(&b.0));
        Ok(Some(Step { to, point, length, met, is_last }))
    }

    /// Keeps a branch point, or remembers that the branches at a known one are known.
    fn note(&mut self, meeting: &Node) {
        let curve = &self.curve;
        match self.meetings.iter_mut().find(|(known, _)| curve.is_same(&known.place, &meeting.place, SAME)) {
            Some((_, is_known)) => *is_known = true,
            None => self.meetings.push((meeting.clone(), false)),
        }
    }

    /// The motions of a half, with their eigenvalues, and where stability changes.
    fn points(&mut self, half: &Half) -> Result<Vec<BranchPoint>, AnalysisError> {
        let mut points: Vec<BranchPoint> = Vec::new();
        for (i, next) in half.points.iter().enumerate() {
            if let (Some(before), Some(segment)) = (points.last(), i.checked_sub(1)) {
                let counts = [before, next].map(|point| point.spectrum.n_unstable());
                let mut met = half.met.iter().filter(|(at, ..)| *at == segment).peekable();
                if met.peek().is_some() {
                    let met = met.map(|(.., met)| self.point(met.place(), Some(met.kind())));
                    points.extend(met.collect::<Result<Vec<_>, _>>()?);
                } else if counts[0] != counts[1] && before.spectrum.n_zero == next.spectrum.n_zero {
                    points.extend(self.changes(&half.nodes[segment], half.lengths[segment])?);
                }
            }
            points.push(next.clone());
        }
        Ok(points)
    }

    fn point(&mut self, place: &Place, bifurcation: Option<Bifurcation>) -> Result<BranchPoint, AnalysisError> {
        let (motion, spectrum) = self.curve.motion(place)?;
        Ok(BranchPoint { value: place.value, motion, spectrum, bifurcation })
    }

    /// Where eigenvalues cross the imaginary axis within a step.
    fn changes(&mut self, from: &Node, length: f64) -> Result<Vec<BranchPoint>, AnalysisError> {
        let place = |curve: &mut Curve<'_, '_, P>, x: f64| {
            let node = curve.step(from, x)?;
            // a shorter step than one that led on
            node.map(|node| node.place).ok_or_else(|| curve.lost(&from.place))
        };
        let curve = &mut self.curve;
        let locus = Locus::of(&[0.0, length], |x| {
            let place = place(curve, x)?;
            Ok::<_, AnalysisError>(curve.motion(&place)?.1)
        })?;
        let critical = locus.critical.into_iter().map(|critical| {
            let kind = match critical.kind {
                Instability::Oscillation { omega } => Bifurcation::Oscillation { omega },
                Instability::Divergence => Bifurcation::Divergence,
            };
            let place = place(&mut self.curve, critical.value)?;
            self.point(&place, Some(kind))
        });
        critical.collect()
    }
}

/// A step along a branch.
struct Step {
    to: Node,
    point: BranchPoint,
    length: f64,
    met: Vec<(f64, Met)>,
    is_last: bool,
}

impl Met {
    fn place(&self) -> &Place {
        match self {
            Self::Fold(place) => place,
            Self::Meeting(meeting) => &meeting.place,
        }
    }

    fn kind(&self) -> Bifurcation {
        match self {
            Self::Fold(_) => Bifurcation::Fold,
            Self::Meeting(_) => Bifurcation::BranchPoint,
        }
    }
}
