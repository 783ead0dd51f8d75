//! A scene in numbers with derivatives, solved by the factors of its values.

use super::{Dynamics, Metric, MotionError, Projecting, Projection, Rows, System};
use crate::model::{EquationsWithDerivatives, SceneInfo, SceneRef, Start, body_kind};
use crate::scalar::Dual;
use std::sync::Arc;

/// The parts of the residual R of the equations of motion ([`JacobianPlaces`](crate::model::JacobianPlaces)) with their derivatives.
pub(super) struct Motion<const N: usize> {
    mass: Vec<Dual<N>>,
    jacobian: Vec<Dual<N>>,
    /// F, then `[h; s]`.
    terms: Vec<Dual<N>>,
}

impl<const N: usize> Motion<N> {
    pub(super) fn new(info: &SceneInfo) -> Self {
        let zeros = |n: usize| vec![Dual::constant(0.0); n];
        Self {
            mass: zeros(info.n_velocities()),
            jacobian: zeros(info.jacobian.n_nonzeros()),
            terms: zeros(info.n_unknowns()),
        }
    }

    pub(super) fn evaluate(
        &mut self,
        kernels: &dyn EquationsWithDerivatives<N>,
        fixed: &[Dual<N>],
        t: f64,
        q: &[Dual<N>],
        v: &[Dual<N>],
    ) {
        let (t, (force, convective)) = (Dual::constant(t), self.terms.split_at_mut(v.len()));
        kernels.mass_matrix_with_derivatives(fixed, &mut self.mass);
        kernels.velocity_jacobian_with_derivatives(fixed, t, q, &mut self.jacobian);
        kernels.applied_force_with_derivatives(fixed, t, q, v, force);
        kernels.convective_term_with_derivatives(fixed, t, q, v, convective);
    }

    /// One derivative of R at accelerations `a` and multipliers `lambda`, `n_v + n_c`.
    pub(super) fn write(&self, info: &SceneInfo, direction: usize, a: &[f64], lambda: &[f64], out: &mut [f64]) {
        let (force, rows) = out.split_at_mut(a.len());
        let (of_force, of_rows) = self.terms.split_at(a.len());
        for (((force, of), m), a) in force.iter_mut().zip(of_force).zip(&self.mass).zip(a) {
            *force = of.derivatives[direction] - m.derivatives[direction] * a;
        }
        rows.iter_mut().zip(of_rows).for_each(|(row, h)| *row = -h.derivatives[direction]);
        for (k, row, i) in info.jacobian.entries() {
            let g = self.jacobian[k].derivatives[direction];
            force[i] -= g * lambda[row];
            rows[row] -= g * a[i];
        }
    }

    /// Changes the right side of `[M Gᵀ; G 0] [x; y] = [force; row]` to that of the same x with M⁻¹ force taken away: `[0; row − G M⁻¹ force]`,
    /// and writes −(row − G M⁻¹ force) into `residual` and M⁻¹ force into `x`.
    fn take_force(&self, info: &SceneInfo, column: &[f64], x: &mut [f64], residual: &mut [f64]) {
        let (force, rows) = column.split_at(x.len());
        x.iter_mut().zip(force).zip(&self.mass).for_each(|((x, force), m)| *x = force / m.value);
        residual.iter_mut().zip(rows).for_each(|(residual, row)| *residual = -row);
        for (k, row, i) in info.jacobian.entries() {
            residual[row] += self.jacobian[k].value * x[i];
        }
    }
}

/// A scene in numbers with `N` derivatives. Values are those of a [`System`], and derivatives are solved for by what solves for the values, so all
/// backends serve. Multipliers have no derivatives, since no motion needs them; it integrates no works.
pub(crate) struct SystemWithDerivatives<P: SceneRef, const N: usize> {
    system: System<P>,
    kernels: Kernels<P, N>,
    /// Inputs, first-order states, then constants.
    fixed: Vec<Dual<N>>,
    motion: Motion<N>,
    rows: Vec<Dual<N>>,
    values: Values,
    change: Values,
    residual: Vec<f64>,
    column: Vec<f64>,
}

/// Hands out the kernels of a scene on numbers with `N` derivatives.
pub(crate) type Kernels<P, const N: usize> = fn(&P) -> &dyn EquationsWithDerivatives<N>;

/// Of a state and its solution.
struct Values {
    q: Vec<f64>,
    v: Vec<f64>,
    z: Vec<f64>,
    a: Vec<f64>,
    lambda: Vec<f64>,
}

impl Values {
    fn zero(info: &SceneInfo) -> Self {
        let (n_q, n_v) = (info.n_coordinates(), info.n_velocities());
        let zeros = |n: usize| vec![0.0; n];
        Self { q: zeros(n_q), v: zeros(n_v), z: zeros(info.n_states()), a: zeros(n_v), lambda: zeros(info.n_rows()) }
    }
}

impl<P: SceneRef, const N: usize> SystemWithDerivatives<P, N> {
    /// Of `system` with its present inputs; `parameters` may vary.
    pub(crate) fn new(system: System<P>, kernels: Kernels<P, N>, parameters: &[Dual<N>]) -> Self {
        let info = Arc::clone(system.info());
        let mut fixed: Vec<_> = system.fixed().iter().map(|x| Dual::constant(*x)).collect();
        kernels(system.scene_ref()).constants_with_derivatives(parameters, &mut fixed);
        Self {
            kernels,
            fixed,
            motion: Motion::new(&info),
            rows: vec![Dual::constant(0.0); info.n_rows()],
            values: Values::zero(&info),
            change: Values::zero(&info),
            residual: vec![0.0; info.n_rows()],
            column: vec![0.0; info.n_unknowns()],
            system,
        }
    }

    /// The system of the values, and what kernels read as `c`.
    pub(crate) fn into_parts(self) -> (System<P>, Vec<Dual<N>>) {
        (self.system, self.fixed)
    }

    /// Lets the positions `q` and velocities `v` of `start` follow the rows, which hold for the derivatives, too: what is not given, and of near values
    /// what has to.
    ///
    /// # Errors
    /// The derivative that contradicts what is given.
    pub(crate) fn follow_rows(&mut self, start: &Start, q: &mut [Dual<N>], v: &mut [Dual<N>]) -> Result<(), usize> {
        let Self { system, kernels, fixed, rows, values: Values { q: values, .. }, .. } = self;
        let (info, scene, t) = (Arc::clone(system.info()), system.scene_ref().clone(), start.t);
        let (kernels, time) = (kernels(&scene), Dual::constant(t));
        copy_values(q, values);
        let without_near = start.without_near();
        let stages: Vec<&Start> = [start].into_iter().chain(&without_near).collect();
        // as in the assembly, centres give way before angles
        let mut positions: Vec<Vec<bool>> = stages.iter().map(|start| start.q_given.clone()).collect();
        if let [given, free] = &positions[..] {
            let lengths = system.geometry.lengths.iter();
            let centres = lengths
                .zip(given.iter().zip(free))
                .map(|(is_length, (given, free))| if *is_length { *free } else { *given });
            let centres = centres.collect();
            positions.insert(1, centres);
        }
        let positions: Vec<Vec<bool>> = positions.iter().map(|given| body_kind::held(&info.kinds, given)).collect();
        let velocities: Vec<Vec<bool>> = stages.iter().map(|start| start.v_given.clone()).collect();

        let of_positions = &mut rows[..info.n_position_rows];
        kernels.position_constraint_with_derivatives(fixed, time, q, of_positions);
        let mut rates = vec![0.0; info.n_coordinates()];
        for direction in 0..N {
            let tangent = follow(system, t, values, of_positions, direction, &positions).ok_or(direction)?;
            system.position_rates(values, &tangent, &mut rates);
            add_derivative(q, direction, &rates);
        }
        kernels.velocity_constraint_with_derivatives(fixed, time, q, v, rows);
        for direction in 0..N {
            let tangent = follow(system, t, values, rows, direction, &velocities).ok_or(direction)?;
            add_derivative(v, direction, &tangent);
        }
        Ok(())
    }
}

/// What follows of all that is free in one direction.
fn follow<P: SceneRef, const N: usize>(
    system: &mut System<P>,
    t: f64,
    q: &[f64],
    rows: &[Dual<N>],
    direction: usize,
    given: &[Vec<bool>],
) -> Option<Vec<f64>> {
    let changed: Vec<f64> = rows.iter().map(|row| row.derivatives[direction]).collect();
    system.assembly().following(t, q, &changed, given)
}

impl<P: SceneRef, const N: usize> Dynamics<Dual<N>> for SystemWithDerivatives<P, N> {
    fn accelerations(
        &mut self,
        t: f64,
        q: &[Dual<N>],
        v: &[Dual<N>],
        a: &mut [Dual<N>],
        lambda: &mut [Dual<N>],
    ) -> Result<(), MotionError> {
        let Self { system, kernels, fixed, motion, values, change, residual, column, .. } = self;
        copy_values(q, &mut values.q);
        copy_values(v, &mut values.v);
        let info = Arc::clone(system.info());
        let mut at = system.at_with(t, &values.q, Rows::Held);
        at.accelerations(&values.v, &mut values.a, &mut values.lambda)?;
        a.iter_mut().zip(&values.a).for_each(|(a, value)| *a = Dual::constant(*value));
        lambda.iter_mut().zip(&values.lambda).for_each(|(lambda, value)| *lambda = Dual::constant(*value));
        motion.evaluate(kernels(at.scene()), fixed, t, q, v);
        for direction in 0..N {
            motion.write(&info, direction, &values.a, &values.lambda, column);
            if at.may_eliminate() {
                // without multipliers it is a correction
                motion.take_force(&info, column, &mut change.v, residual);
                at.correction(residual, &mut change.a)?;
                change.a.iter_mut().zip(&change.v).for_each(|(a, of_force)| *a += of_force);
            } else {
                at.factor()?;
                let (force, rows) = column.split_at(values.a.len());
                at.solve(force, rows, &mut change.a, &mut change.lambda);
            }
            add_derivative(a, direction, &change.a);
        }
        Ok(())
    }

    fn position_rates(&self, q: &[Dual<N>], v: &[Dual<N>], out: &mut [Dual<N>]) {
        body_kind::position_rates(&self.system.info().kinds, q, v, out);
    }

    fn place_states(&mut self, z: &[Dual<N>]) {
        let n_inputs = self.system.info().n_inputs();
        self.fixed[n_inputs..][..z.len()].copy_from_slice(z);
        copy_values(z, &mut self.values.z);
        self.system.place_states(&self.values.z);
    }

    fn state_rates(&self, t: f64, q: &[Dual<N>], v: &[Dual<N>], out: &mut [Dual<N>]) {
        if !out.is_empty() {
            let kernels = (self.kernels)(self.system.scene_ref());
            kernels.state_rates_with_derivatives(&self.fixed, Dual::constant(t), q, v, out);
        }
    }

    fn power(&self, _t: f64, _q: &[Dual<N>], _v: &[Dual<N>], _lambda: &[Dual<N>], _out: &mut [Dual<N>]) {}
}

impl<P: SceneRef, const N: usize> Projecting<Dual<N>> for SystemWithDerivatives<P, N> {
    /// Derivatives follow the rows at the projected values. What they miss of the way there is as small as what a step leaves of the rows, which is
    /// the error of the step.
    fn project(&mut self, t: f64, q: &mut [Dual<N>], v: &mut [Dual<N>]) -> Result<(), MotionError> {
        let Self { system, kernels, fixed, rows, values, change, residual, .. } = self;
        let info = Arc::clone(system.info());
        body_kind::normalize(&info.kinds, q);
        copy_values(q, &mut values.q);
        copy_values(v, &mut values.v);
        system.project(t, &mut values.q, &mut values.v, Projection::Both, Metric::Mass)?;
        q.iter_mut().zip(&values.q).for_each(|(q, value)| q.value = *value);
        v.iter_mut().zip(&values.v).for_each(|(v, value)| v.value = *value);

        let time = Dual::constant(t);
        let mut at = system.at_with(t, &values.q, Rows::Projected);
        let n_h = info.n_position_rows;
        kernels(at.scene()).position_constraint_with_derivatives(fixed, time, q, &mut rows[..n_h]);
        residual[n_h..].fill(0.0);
        for direction in 0..N {
            residual.iter_mut().zip(&rows[..n_h]).for_each(|(residual, row)| *residual = row.derivatives[direction]);
            at.correction(residual, &mut change.v)?;
            body_kind::position_rates(&info.kinds, &values.q, &change.v, &mut change.q);
            add_derivative(q, direction, &change.q);
        }
        kernels(at.scene()).velocity_constraint_with_derivatives(fixed, time, q, v, rows);
        for direction in 0..N {
            residual.iter_mut().zip(&*rows).for_each(|(residual, row)| *residual = row.derivatives[direction]);
            at.correction(residual, &mut change.v)?;
            add_derivative(v, direction, &change.v);
        }
        Ok(())
    }
}

fn copy_values<const N: usize>(from: &[Dual<N>], to: &mut [f64]) {
    to.iter_mut().zip(from).for_each(|(to, from)| *to = from.value);
}

fn add_derivative<const N: usize>(to: &mut [Dual<N>], direction: usize, change: &[f64]) {
    to.iter_mut().zip(change).for_each(|(to, change)| to.derivatives[direction] += change);
}
