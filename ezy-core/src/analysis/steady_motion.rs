//! Rest and steady motions, by damped Newton steps on the exact Jacobian.

use super::derivatives;
use super::error::AnalysisError;
use super::frame::Frame;
use super::tolerances::search::{FREE, LAST, MAX_HALVINGS, MAX_STEPS, MET, STILL, STRAIGHT};
use crate::dynamics::{By, Gradients, Of, OperatingPoint, State, System};
use crate::model::coordinate::{N_OF_BODY, body_and_component, n_bodies, place};
use crate::model::{Equations as _, Name, SceneInfo, SceneRef, Start};
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
        Search::new(system, info, moves)?.run(Point { state, frame, multipliers }, hold)
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

/// The unknowns.
#[derive(Clone)]
struct Point {
    state: State,
    frame: Frame,
    multipliers: Vec<f64>,
}

/// The equations at a point: those of motion, position rows, all rows of velocities, rates of states; where it moves, velocities less those of the frame.
struct Equations {
    residual: DVector<f64>,
    /// By q, z, λ; where it moves by v and the frame.
    jacobian: DMatrix<f64>,
    /// Largest term of the equations of its kind.
    terms: DVector<f64>,
}

struct Search<'s, P: SceneRef> {
    system: &'s mut System<P>,
    info: Arc<SceneInfo>,
    gradients: Gradients<P>,
    moves: bool,
    /// Coordinates whose velocities are those of the frame: not those that nothing depends on, such as the angle of a wheel.
    carried: Vec<usize>,
}

impl<'s, P: SceneRef> Search<'s, P> {
    fn new(system: &'s mut System<P>, info: Arc<SceneInfo>, moves: bool) -> Result<Self, AnalysisError> {
        let gradients = Gradients::new(system)?;
        let is_read = |i: usize| info.feedback.is_none_or(|feedback| feedback.binary_search(&i).is_ok());
        let carried = (0..info.n_coordinates()).filter(|&i| !info.coordinates[i].is_angle() || is_read(i)).collect();
        Ok(Self { system, info, gradients, moves, carried })
    }

    fn run(mut self, start: Point, hold: &[&str]) -> Result<SteadyMotion, AnalysisError> {
        let held = self.held(hold)?;
        let (mut point, mut equations) = (start.clone(), self.equations(&start));
        let sizes = equations.jacobian.column_iter().zip(&held);
        let columns: Vec<f64> =
            sizes.map(|(column, held)| if *held { 0.0 } else { reciprocal(column.norm()) }).collect();
        let rows: Vec<f64> = (equations.jacobian.row_iter())
            .map(|row| reciprocal(row.iter().zip(&columns).map(|(x, c)| (x * c).powi(2)).sum::<f64>().sqrt()))
            .collect();
        let scaled = |equations: &Equations| {
            let jacobian =
                DMatrix::from_fn(rows.len(), columns.len(), |i, j| rows[i] * equations.jacobian[(i, j)] * columns[j]);
            (jacobian, DVector::from_fn(rows.len(), |i, _| rows[i] * equations.residual[i]))
        };
        for n_steps in 0..MAX_STEPS {
            let (jacobian, residual) = scaled(&equations);
            let svd = jacobian.svd(true, true);
            let tolerance = FREE * svd.singular_values.max();
            let step = svd.solve(&-&residual, tolerance).unwrap_or_else(|_| DVector::zeros(columns.len()));
            let step = DVector::from_fn(columns.len(), |j, _| columns[j] * step[j]);
            let (norm, mut share, mut found) = (residual.norm(), 1.0, None);
            for _ in 0..MAX_HALVINGS {
                let tried = self.moved(&point, &step, share);
                let at = self.equations(&tried);
                if scaled(&at).1.norm() < norm {
                    found = Some((tried, at));
                    break;
                }
                share *= 0.5;
            }
            let is_last = found.is_none() || self.is_small(&point, &step);
            if let Some((tried, at)) = found {
                (point, equations) = (tried, at);
            }
            if is_last {
                return self.end(point, &equations, &svd, &columns, n_steps);
            }
        }
        Err(self.not_found(&equations, MAX_STEPS))
    }

    fn is_small(&self, point: &Point, step: &DVector<f64>) -> bool {
        let size = point.state.q.iter().chain(&point.state.v).fold(1.0, |size: f64, x| size.max(x.abs()));
        let n = self.info.n_coordinates();
        step.iter().take(n).all(|x| x.abs() <= LAST * size)
    }

    fn end(
        self,
        point: Point,
        equations: &Equations,
        svd: &SVD<f64, Dyn, Dyn>,
        columns: &[f64],
        n_steps: usize,
    ) -> Result<SteadyMotion, AnalysisError> {
        let is_left = |(r, terms): (&f64, &f64)| r.abs() > MET * terms;
        if equations.residual.iter().zip(&equations.terms).any(is_left) {
            return Err(self.not_found(equations, n_steps));
        }
        let free = self.free(svd, columns);
        let Point { state, frame, multipliers } = point;
        let mut accelerations = vec![0.0; state.v.len()];
        frame.turn(&state.v, &mut accelerations);
        Ok(SteadyMotion { state, accelerations, multipliers, frame, free, n_steps })
    }

    /// Names of as many unknowns as directions are free, each the largest of what is left of one.
    fn free(&self, svd: &SVD<f64, Dyn, Dyn>, columns: &[f64]) -> Vec<Name> {
        let Some(v_t) = &svd.v_t else { return Vec::new() };
        let tolerance = FREE * svd.singular_values.max();
        let fixed: Vec<usize> = (0..v_t.nrows()).filter(|&i| svd.singular_values[i] > tolerance).collect();
        let range = v_t.select_rows(&fixed);
        // the projector onto the null space
        let mut left = DMatrix::identity(columns.len(), columns.len()) - range.tr_mul(&range);
        let names = self.names();
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
    fn held(&self, hold: &[&str]) -> Result<Vec<bool>, AnalysisError> {
        let names = self.names();
        let mut held = vec![false; names.len()];
        for name in hold {
            let place = names.iter().position(|of| of.as_deref() == Some(*name));
            let place =
                place.ok_or_else(|| AnalysisError::UnknownHeld { scene: self.info.name, name: (*name).to_owned() })?;
            held[place] = true;
        }
        Ok(held)
    }

    /// Names of the unknowns; none of multipliers and of the frame.
    fn names(&self) -> Vec<Option<Name>> {
        let info = &self.info;
        let coordinates = info.coordinates.iter().map(|c| Some(c.name.clone()));
        let states = info.states.iter().map(|state| Some(state.name.into()));
        let mut names: Vec<_> = coordinates.chain(states).chain((0..info.n_rows()).map(|_| None)).collect();
        if self.moves {
            names.extend(info.velocities.iter().map(|v| Some(v.name.clone())));
            names.extend([None, None, None]);
        }
        names
    }

    fn not_found(&self, equations: &Equations, steps: usize) -> AnalysisError {
        let shares = equations.residual.iter().zip(&equations.terms).map(|(r, terms)| r.abs() * reciprocal(*terms));
        let worst = shares.enumerate().max_by(|a, b| a.1.total_cmp(&b.1)).map_or(0, |(i, _)| i);
        let info = &self.info;
        let [n_v, n_h, n_c, n_z] = [info.n_velocities(), info.n_position_rows, info.n_rows(), info.n_states()];
        let left = equations.residual[worst].abs();
        let (what, unit) = match worst {
            i if i < n_v && info.velocities[i].is_angle() => (info.coordinates[i].name.clone(), "N m"),
            i if i < n_v => (info.coordinates[i].name.clone(), "N"),
            i if i < n_v + n_h => (info.rows[i - n_v].name.clone(), "m"),
            i if i < n_v + n_h + n_c => (info.rows[i - n_v - n_h].name.clone(), "m/s"),
            i if i < n_v + n_h + n_c + n_z => (info.states[i - n_v - n_h - n_c].name.into(), "of its unit a second"),
            i => (info.velocities[self.carried[i - n_v - n_h - n_c - n_z]].name.clone(), "m/s"),
        };
        AnalysisError::NotFound { scene: info.name, what, left, unit, steps }
    }

    /// The point a share of a step on.
    fn moved(&self, from: &Point, step: &DVector<f64>, share: f64) -> Point {
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

    /// Sizes of the unknowns, whose rounding is felt: a coordinate that is zero is as exact as the others are, and so is a frame that does not turn.
    fn sizes(&self, point: &Point) -> Vec<f64> {
        let Point { state: State { q, v, z, .. }, frame, multipliers } = point;
        let largest = |x: &[f64]| x.iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
        let [extent, speed] = [q, v].map(|x| largest(x));
        let lengths = self.info.coordinates.iter().zip(q).filter(|(info, _)| info.is_length());
        let length = lengths.fold(0.0, |length: f64, (_, x)| length.max(x.abs()));
        let length = if length > 0.0 { length } else { self.system.length() };
        let units = self.info.coordinates.iter().map(|info| if info.is_length() { length } else { 1.0 });
        let mut sizes: Vec<f64> = q.iter().zip(units).map(|(x, unit)| x.abs().max(unit)).collect();
        sizes.extend(z.iter().chain(multipliers).map(|x| x.abs()));
        if self.moves {
            sizes.extend(v.iter().map(|v| v.abs()));
            let turn = if extent > 0.0 { speed / extent } else { speed };
            sizes.extend([speed, speed, frame.omega.abs().max(turn)]);
        }
        sizes
    }

    fn equations(&mut self, point: &Point) -> Equations {
        let Self { system, info, gradients, moves, carried } = &mut *self;
        let Point { state: State { t, q, v, z, .. }, frame, multipliers } = point;
        system.place_states(z);
        let [n_q, n_h, n_c, n_z] = [info.n_coordinates(), info.n_position_rows, info.n_rows(), info.n_states()];
        let mut a = vec![0.0; n_q];
        frame.turn(v, &mut a);
        let at = OperatingPoint { fixed: system.fixed(), t: *t, q, v, accelerations: &a, multipliers };
        let mut derivatives = |of, by| derivatives(gradients, &at, of, by);
        let (scene, fixed) = (system.scene(), system.fixed());
        let mut force = vec![0.0; n_q];
        scene.applied_force(fixed, *t, q, v, &mut force);
        let mut g = vec![0.0; info.jacobian.n_nonzeros()];
        scene.velocity_jacobian(fixed, *t, q, &mut g);
        let (mut c, mut rates_of_rows) = (vec![0.0; n_h], vec![0.0; n_c]);
        scene.position_constraint(fixed, *t, q, &mut c);
        scene.velocity_constraint(fixed, *t, q, v, &mut rates_of_rows);
        let mut rates = vec![0.0; n_z];
        system.state_rates(*t, q, v, &mut rates);

        let n_moving = if *moves { carried.len() } else { 0 };
        let n_rows = n_q + n_h + n_c + n_z + n_moving;
        let n_columns = n_q + n_z + n_c + if *moves { n_q + 3 } else { 0 };
        let (of_z, of_lambda, of_v) = (n_q, n_q + n_z, n_q + n_z + n_c);
        let (at_c, at_rows, at_rates, at_frame) = (n_q, n_q + n_h, n_q + n_h + n_c, n_q + n_h + n_c + n_z);
        let mut residual = DVector::zeros(n_rows);
        let mut terms = DVector::zeros(n_rows);
        let mut jacobian = DMatrix::zeros(n_rows, n_columns);
        let mass = system.mass_matrix();
        for i in 0..n_q {
            residual[i] = force[i] - mass[i] * a[i];
            terms[i] = force[i].abs().max((mass[i] * a[i]).abs());
        }
        for (k, row, column) in info.jacobian.entries() {
            let reaction = g[k] * multipliers[row];
            residual[column] -= reaction;
            jacobian[(column, of_lambda + row)] -= g[k];
            if *moves {
                jacobian[(at_rows + row, of_v + column)] += g[k];
            }
        }
        for (first, values) in [(at_c, &c), (at_rows, &rates_of_rows), (at_rates, &rates)] {
            residual.rows_mut(first, values.len()).copy_from_slice(values);
        }
        let by = |of: By| if of == By::States { of_z } else { 0 };
        for of in [By::Positions, By::States] {
            let motion = derivatives(Of::Motion, of);
            let n = motion.ncols();
            let mut put = |first: usize, part: nalgebra::DMatrixView<'_, f64>| {
                let mut block = jacobian.view_mut((first, by(of)), (part.nrows(), n));
                block += part;
            };
            put(0, motion.rows(0, n_q));
            put(at_rates, motion.rows(n_q + n_c, n_z));
            put(at_rows, derivatives(Of::VelocityRows, of).rows(0, n_c));
            if of == By::Positions {
                put(at_c, derivatives(Of::PositionRows, of).rows(0, n_h));
            }
        }
        if *moves {
            let motion = derivatives(Of::Motion, By::Velocities);
            let mut block = jacobian.view_mut((0, of_v), (n_q, n_q));
            block += motion.rows(0, n_q);
            let mut block = jacobian.view_mut((at_rates, of_v), (n_z, n_q));
            block += motion.rows(n_q + n_c, n_z);
            let mut carry = vec![0.0; n_q];
            frame.carry(q, &mut carry);
            for body in 0..n_bodies(n_q) {
                let [x, y] = [0, 1].map(|component| place(body, component));
                // of M ω e_z × v
                jacobian[(x, of_v + y)] += mass[x] * frame.omega;
                jacobian[(y, of_v + x)] -= mass[y] * frame.omega;
                jacobian[(x, of_v + n_q + 2)] += mass[x] * v[y];
                jacobian[(y, of_v + n_q + 2)] -= mass[y] * v[x];
            }
            for (k, &i) in carried.iter().enumerate() {
                let row = at_frame + k;
                residual[row] = v[i] - carry[i];
                jacobian[(row, of_v + i)] = 1.0;
                let (body, component) = body_and_component(i);
                let [x, y] = [0, 1].map(|component| place(body, component));
                let of_frame = of_v + n_q;
                let slopes: &[(usize, f64)] = match component {
                    0 => &[(y, frame.omega), (of_frame, -1.0), (of_frame + 2, q[y])],
                    1 => &[(x, -frame.omega), (of_frame + 1, -1.0), (of_frame + 2, -q[x])],
                    _ => &[(of_frame + 2, -1.0)],
                };
                slopes.iter().for_each(|&(column, slope)| jacobian[(row, column)] += slope);
            }
        }
        let sizes = self.sizes(point);
        let mass = self.system.mass_matrix();
        (0..n_q).for_each(|i| terms[i] = f64::max(terms[i], STILL * mass[i] * sizes[i]));
        for (terms, row) in terms.iter_mut().zip(jacobian.row_iter()) {
            *terms = row.iter().zip(&sizes).fold(*terms, |terms, (slope, size)| terms.max((slope * size).abs()));
        }
        for (first, n) in [(0, n_q), (at_c, n_h), (at_rows, n_c), (at_rates, n_z), (at_frame, n_moving)] {
            let largest = terms.rows(first, n).amax();
            terms.rows_mut(first, n).fill(largest);
        }
        Equations { residual, jacobian, terms }
    }
}

fn reciprocal(x: f64) -> f64 {
    if x > 0.0 { x.recip() } else { 1.0 }
}
