//! The equations of rest and steady motion, and their exact Jacobian.

use super::derivatives;
use super::error::AnalysisError;
use super::frame::Frame;
use super::tolerances::search::{MET, NO_STATE, STILL};
use crate::dynamics::{By, Gradients, Of, OperatingPoint, State, System, SystemError};
use crate::linalg::Backend;
use crate::model::coordinate::{body_and_component, n_bodies, place};
use crate::model::{Equations as _, Name, SceneInfo, SceneRef};
use nalgebra::{DMatrix, DMatrixView, DVector};
use std::sync::Arc;

/// The unknowns, in this order: coordinates, first-order states, multipliers; where it moves velocities and the frame.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Unknowns {
    pub state: State,
    pub frame: Frame,
    pub multipliers: Vec<f64>,
}

/// The equations at a point, in the order of [`Rows`].
pub(super) struct Evaluated {
    pub residual: DVector<f64>,
    /// By the unknowns.
    pub jacobian: DMatrix<f64>,
    /// Largest term of the equations of its kind.
    pub terms: DVector<f64>,
}

impl Evaluated {
    /// Whether all are numbers: singular values of others are none.
    pub(super) fn is_finite(&self) -> bool {
        self.residual.iter().chain(&self.jacobian).all(|x| x.is_finite())
    }

    /// Whether rounding alone is left.
    pub(super) fn is_met(&self) -> bool {
        self.residual.iter().zip(&self.terms).all(|(r, terms)| r.abs() <= MET * terms)
    }
}

/// Where the equations of each kind begin: those of motion at zero.
struct Rows {
    positions: usize,
    velocities: usize,
    states: usize,
    /// Velocities less those of the frame.
    frame: usize,
    end: usize,
}

/// Where the unknowns of each kind begin: coordinates at zero.
struct Columns {
    states: usize,
    multipliers: usize,
    velocities: usize,
    frame: usize,
    end: usize,
}

pub(super) struct SteadyEquations<'s, P: SceneRef> {
    pub system: &'s mut System<P>,
    pub info: Arc<SceneInfo>,
    gradients: Gradients<P>,
    /// Whether a frame may travel and turn.
    pub moves: bool,
    /// The largest velocity of the start, in whose units velocities are nothing but rounding.
    speed: f64,
    /// Coordinates whose velocities are those of the frame: not those that nothing depends on, such as the angle of a wheel.
    carried: Vec<usize>,
}

/// Gives a system other parameters; inputs stay.
pub(super) fn place_parameters<P: SceneRef>(system: &mut System<P>, parameters: &[f64]) -> Result<(), SystemError> {
    let inputs = system.inputs().to_vec();
    *system = System::with_parameters(system.scene_ref().clone(), parameters, Backend::Auto)?;
    system.inputs_mut().copy_from_slice(&inputs);
    Ok(())
}

/// Components of the frame: vx, vy, omega.
const N_OF_FRAME: usize = 3;

impl<'s, P: SceneRef> SteadyEquations<'s, P> {
    /// Of a motion that begins with velocities `v`; at rest there is no frame that moves.
    pub(super) fn new(system: &'s mut System<P>, v: &[f64]) -> Result<Self, AnalysisError> {
        let info = Arc::clone(system.info());
        let gradients = Gradients::new(system)?;
        let is_read = |i: usize| info.feedback.is_none_or(|feedback| feedback.binary_search(&i).is_ok());
        let carried = (0..info.n_coordinates()).filter(|&i| !info.coordinates[i].is_angle() || is_read(i)).collect();
        let speed = v.iter().fold(0.0, |speed: f64, v| speed.max(v.abs()));
        Ok(Self { system, info, gradients, moves: speed > 0.0, speed, carried })
    }

    /// The parameters, in the order of the scene, and behind them which rows are switched on.
    pub(super) fn parameters(&self) -> Vec<f64> {
        self.gradients.parameters()
    }

    /// Sets them.
    pub(super) fn place_parameters(&mut self, parameters: &[f64]) -> Result<(), AnalysisError> {
        place_parameters(self.system, parameters)?;
        self.gradients = Gradients::new(self.system)?;
        Ok(())
    }

    fn rows(&self) -> Rows {
        let positions = self.info.n_velocities();
        let velocities = positions + self.info.n_position_rows;
        let states = velocities + self.info.n_rows();
        let frame = states + self.info.n_states();
        Rows { positions, velocities, states, frame, end: frame + if self.moves { self.carried.len() } else { 0 } }
    }

    fn columns(&self) -> Columns {
        let states = self.info.n_coordinates();
        let multipliers = states + self.info.n_states();
        let velocities = multipliers + self.info.n_rows();
        let frame = velocities + if self.moves { self.info.n_velocities() } else { 0 };
        Columns { states, multipliers, velocities, frame, end: frame + if self.moves { N_OF_FRAME } else { 0 } }
    }

    /// Names of the unknowns; none of multipliers and of the frame.
    pub(super) fn names(&self) -> Vec<Option<Name>> {
        let info = &self.info;
        let mut names = vec![None; self.columns().end];
        let states = info.states.iter().map(|state| state.name.into());
        let named = info.coordinates.iter().map(|c| c.name.clone()).chain(states);
        names.iter_mut().zip(named).for_each(|(name, known)| *name = Some(known));
        if self.moves {
            let velocities = names[self.columns().velocities..].iter_mut().zip(&*info.velocities);
            velocities.for_each(|(name, known)| *name = Some(known.name.clone()));
        }
        names
    }

    /// A share of the sizes of the unknowns that are seen: of coordinates, states and velocities; zero for the others.
    pub(super) fn strides(&self, point: &Unknowns, share: f64) -> Vec<f64> {
        let (sizes, columns) = (self.sizes(point, 0.0), self.columns());
        let is_seen = |i: usize| i < columns.multipliers || (columns.velocities..columns.frame).contains(&i);
        let largest = |of: std::ops::Range<usize>| sizes[of].iter().fold(0.0, |largest: f64, x| largest.max(*x));
        let speed = largest(columns.velocities..columns.frame);
        let size = |i: usize| match i {
            i if i < columns.states && self.info.coordinates[i].is_angle() => 1.0,
            i if i < columns.states => largest(0..columns.states),
            i if i < columns.multipliers && sizes[i] <= NO_STATE => 1.0,
            i if i < columns.multipliers => sizes[i],
            _ => speed,
        };
        (0..columns.end).map(|i| if is_seen(i) { share * size(i) } else { 0.0 }).collect()
    }

    /// The largest part of a step, in turns of 1 rad, of sizes of the mechanism and of its speed.
    pub(super) fn reach(&self, point: &Unknowns, step: &DVector<f64>) -> f64 {
        let strides = self.strides(point, 1.0);
        let seen = step.iter().zip(&strides).filter(|(_, stride)| **stride > 0.0);
        seen.fold(
            0.0,
            |reach: f64, (step, stride)| if step.is_finite() { reach.max(step.abs() / stride) } else { f64::INFINITY },
        )
    }

    /// The unknowns a share of a step on.
    pub(super) fn moved(&self, from: &Unknowns, step: &DVector<f64>, share: f64) -> Unknowns {
        let mut to = from.clone();
        let mut steps = step.iter().map(|x| share * x);
        let State { q, v, z, .. } = &mut to.state;
        q.iter_mut().chain(z).chain(&mut to.multipliers).zip(&mut steps).for_each(|(x, step)| *x += step);
        if self.moves {
            let Frame { vx, vy, omega } = &mut to.frame;
            v.iter_mut().chain([vx, vy, omega]).zip(steps).for_each(|(x, step)| *x += step);
        }
        to
    }

    /// The unknowns as a vector.
    pub(super) fn values(&self, point: &Unknowns) -> DVector<f64> {
        let Unknowns { state: State { q, v, z, .. }, frame: Frame { vx, vy, omega }, multipliers } = point;
        let all: Vec<f64> = match self.moves {
            true => [q, z, multipliers, v, &[*vx, *vy, *omega][..]].concat(),
            false => [&**q, z, multipliers].concat(),
        };
        DVector::from_vec(all)
    }

    /// The point without what rounding leaves of velocities where it came to rest.
    pub(super) fn settled(&self, mut point: Unknowns) -> Unknowns {
        if point.state.v.iter().all(|v| v.abs() <= MET * self.speed) {
            point.state.v.fill(0.0);
            point.frame = Frame::default();
        }
        point
    }

    /// Whether a step changes coordinates by no more than a share of the largest one.
    pub(super) fn is_small(&self, point: &Unknowns, step: &DVector<f64>, share: f64) -> bool {
        let size = point.state.q.iter().chain(&point.state.v).fold(1.0, |size: f64, x| size.max(x.abs()));
        step.iter().take(self.info.n_coordinates()).all(|x| x.abs() <= share * size)
    }

    /// Sizes of the unknowns, whose rounding is felt: a coordinate that is zero is as exact as the others are, and so is a frame that does not turn.
    fn sizes(&self, point: &Unknowns, least_speed: f64) -> Vec<f64> {
        let Unknowns { state: State { q, v, z, .. }, frame, multipliers } = point;
        let largest = |x: &[f64]| x.iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
        let [extent, speed] = [largest(q), largest(v).max(least_speed)];
        let lengths = self.info.coordinates.iter().zip(q).filter(|(info, _)| info.is_length());
        // rounding beside the origin is no size: the longest lever is one; where there is none, a metre
        let lever = Some(self.system.length()).filter(|lever| *lever > 0.0).unwrap_or(1.0);
        let length = lengths.fold(lever, |length: f64, (_, x)| length.max(x.abs()));
        let units = self.info.coordinates.iter().map(|info| if info.is_length() { length } else { 1.0 });
        let mut sizes: Vec<f64> = q.iter().zip(units).map(|(x, unit)| x.abs().max(unit)).collect();
        sizes.extend(z.iter().map(|x| x.abs().max(NO_STATE)));
        sizes.extend(multipliers.iter().map(|x| x.abs()));
        if self.moves {
            sizes.extend(v.iter().map(|v| v.abs().max(least_speed)));
            let turn = if extent > 0.0 { speed / extent } else { speed };
            sizes.extend([speed, speed, frame.omega.abs().max(turn)]);
        }
        sizes
    }

    pub(super) fn at(&mut self, point: &Unknowns) -> Evaluated {
        self.system.place_states(&point.state.z);
        let (rows, columns) = (self.rows(), self.columns());
        let mut residual = DVector::zeros(rows.end);
        let mut terms = DVector::zeros(rows.end);
        let mut jacobian = DMatrix::zeros(rows.end, columns.end);
        self.put_values(point, &mut residual, &mut terms, &mut jacobian);
        for (by, first) in [(By::Positions, 0), (By::States, columns.states)] {
            let slopes = self.slopes(point, by);
            let mut block = jacobian.view_mut((0, first), slopes.shape());
            block += slopes;
        }
        if self.moves {
            let slopes = self.slopes(point, By::Velocities);
            // rows of velocities have them by their Jacobian
            for (first, end) in [(0, rows.positions), (rows.states, rows.frame)] {
                let mut block = jacobian.view_mut((first, columns.velocities), (end - first, slopes.ncols()));
                block += slopes.rows_range(first..end);
            }
            self.put_frame(point, &mut residual, &mut jacobian);
        }
        self.put_terms(point, &jacobian, &mut terms);
        Evaluated { residual, jacobian, terms }
    }

    /// Derivatives of the equations, but for those of the frame, by what the scene depends on.
    pub(super) fn slopes(&mut self, point: &Unknowns, by: By) -> DMatrix<f64> {
        let rows = self.rows();
        let Self { system, info, gradients, .. } = self;
        let Unknowns { state: State { t, q, v, z, .. }, frame, multipliers } = point;
        system.place_states(z);
        let mut a = vec![0.0; v.len()];
        frame.turn(v, &mut a);
        let at = OperatingPoint { fixed: system.fixed(), t: *t, q, v, accelerations: &a, multipliers };
        let mut slopes = DMatrix::zeros(rows.end, gradients.n_columns(by));
        let mut put = |first: usize, part: DMatrixView<'_, f64>| slopes.rows_mut(first, part.nrows()).copy_from(&part);
        let motion = derivatives(gradients, &at, Of::Motion, by);
        put(0, motion.rows(0, info.n_velocities()));
        put(rows.states, motion.rows(info.n_unknowns(), info.n_states()));
        put(rows.positions, derivatives(gradients, &at, Of::PositionRows, by).as_view());
        put(rows.velocities, derivatives(gradients, &at, Of::VelocityRows, by).as_view());
        slopes
    }

    /// What is left of the equations, and what is linear in multipliers and velocities.
    fn put_values(
        &self,
        point: &Unknowns,
        residual: &mut DVector<f64>,
        terms: &mut DVector<f64>,
        jacobian: &mut DMatrix<f64>,
    ) {
        let (rows, columns) = (self.rows(), self.columns());
        let Self { system, info, moves, .. } = self;
        let Unknowns { state: State { t, q, v, .. }, frame, multipliers } = point;
        let n_v = info.n_velocities();
        let (scene, fixed, mass) = (system.scene(), system.fixed(), system.mass_matrix());
        let (mut a, mut force) = (vec![0.0; n_v], vec![0.0; n_v]);
        frame.turn(v, &mut a);
        scene.applied_force(fixed, *t, q, v, &mut force);
        for i in 0..n_v {
            residual[i] = force[i] - mass[i] * a[i];
            terms[i] = force[i].abs().max((mass[i] * a[i]).abs());
        }
        let mut g = vec![0.0; info.jacobian.n_nonzeros()];
        scene.velocity_jacobian(fixed, *t, q, &mut g);
        for (k, row, column) in info.jacobian.entries() {
            residual[column] -= g[k] * multipliers[row];
            jacobian[(column, columns.multipliers + row)] -= g[k];
            if *moves {
                jacobian[(rows.velocities + row, columns.velocities + column)] += g[k];
            }
        }
        let values = residual.as_mut_slice();
        scene.position_constraint(fixed, *t, q, &mut values[rows.positions..rows.velocities]);
        scene.velocity_constraint(fixed, *t, q, v, &mut values[rows.velocities..rows.states]);
        system.state_rates(*t, q, v, &mut values[rows.states..rows.frame]);
    }

    /// The turn of the frame in the equations of motion, and velocities less those of the frame.
    fn put_frame(&self, point: &Unknowns, residual: &mut DVector<f64>, jacobian: &mut DMatrix<f64>) {
        let (rows, columns) = (self.rows(), self.columns());
        let Unknowns { state: State { q, v, .. }, frame, .. } = point;
        let mass = self.system.mass_matrix();
        let (of_v, of_frame) = (columns.velocities, columns.frame);
        let mut carry = vec![0.0; q.len()];
        frame.carry(q, &mut carry);
        for body in 0..n_bodies(q.len()) {
            let [x, y] = [0, 1].map(|component| place(body, component));
            // of M ω e_z × v
            jacobian[(x, of_v + y)] += mass[x] * frame.omega;
            jacobian[(y, of_v + x)] -= mass[y] * frame.omega;
            jacobian[(x, of_frame + 2)] += mass[x] * v[y];
            jacobian[(y, of_frame + 2)] -= mass[y] * v[x];
        }
        for (k, &i) in self.carried.iter().enumerate() {
            let row = rows.frame + k;
            residual[row] = v[i] - carry[i];
            jacobian[(row, of_v + i)] = 1.0;
            let (body, component) = body_and_component(i);
            let [x, y] = [0, 1].map(|component| place(body, component));
            let slopes: &[(usize, f64)] = match component {
                0 => &[(y, frame.omega), (of_frame, -1.0), (of_frame + 2, q[y])],
                1 => &[(x, -frame.omega), (of_frame + 1, -1.0), (of_frame + 2, -q[x])],
                _ => &[(of_frame + 2, -1.0)],
            };
            slopes.iter().for_each(|&(column, slope)| jacobian[(row, column)] += slope);
        }
    }

    /// The largest term of the equations of each kind.
    fn put_terms(&self, point: &Unknowns, jacobian: &DMatrix<f64>, terms: &mut DVector<f64>) {
        let rows = self.rows();
        let (sizes, mass) = (self.sizes(point, self.speed), self.system.mass_matrix());
        (0..mass.len()).for_each(|i| terms[i] = f64::max(terms[i], STILL * mass[i] * sizes[i]));
        for (terms, row) in terms.iter_mut().zip(jacobian.row_iter()) {
            *terms = row.iter().zip(&sizes).fold(*terms, |terms, (slope, size)| terms.max((slope * size).abs()));
        }
        let ends = [rows.positions, rows.velocities, rows.states, rows.frame, rows.end];
        let mut first = 0;
        for end in ends {
            let mut kind = terms.rows_mut(first, end - first);
            let largest = kind.amax();
            kind.fill(largest);
            first = end;
        }
    }

    /// The error that names the equation of which most is left.
    pub(super) fn not_found(&self, equations: &Evaluated, steps: usize) -> AnalysisError {
        let Evaluated { residual, terms, .. } = equations;
        let share = |i: &usize| if terms[*i] > 0.0 { residual[*i].abs() / terms[*i] } else { residual[*i].abs() };
        let worst = (0..residual.len()).max_by(|i, j| share(i).total_cmp(&share(j))).unwrap_or_default();
        let (info, rows) = (&self.info, self.rows());
        let (what, unit) = match worst {
            i if i < rows.positions && info.velocities[i].is_angle() => (info.coordinates[i].name.clone(), "N m"),
            i if i < rows.positions => (info.coordinates[i].name.clone(), "N"),
            i if i < rows.velocities => (info.rows[i - rows.positions].name.clone(), "m"),
            i if i < rows.states => (info.rows[i - rows.velocities].name.clone(), "m/s"),
            i if i < rows.frame => (info.states[i - rows.states].name.into(), "of its unit a second"),
            i => (info.velocities[self.carried[i - rows.frame]].name.clone(), "m/s"),
        };
        AnalysisError::NotFound { scene: info.name, what, left: residual[worst].abs(), unit, steps }
    }
}
