//! The equations of a scene at eight states at once.

use super::{Equations, Pivots, Powers};
use crate::scalar::{Lanes, Scalar};

/// States that kernels take at once.
pub const N_LANES: usize = 8;

/// Eight numbers, one a state.
pub(crate) type Eight = Lanes<N_LANES>;

/// Kernels of a scene with a generated elimination, at eight states at once, in vector registers of the machine. Arguments and shapes
/// are those of [`Equations`], with a time for each state.
pub trait EquationsInLanes: Send + Sync {
    /// [`Equations::accelerations`].
    fn accelerations_in_lanes(
        &self,
        c: &[Eight],
        t: &Eight,
        q: &[Eight],
        v: &[Eight],
        a: &mut [Eight],
        lambda: &mut [Eight],
    ) -> Pivots;

    /// [`Powers::powers`].
    fn powers_in_lanes(&self, c: &[Eight], t: &Eight, q: &[Eight], v: &[Eight], lambda: &[Eight], out: &mut [Eight]);

    /// [`Equations::position_constraint`].
    fn position_constraint_in_lanes(&self, c: &[Eight], t: &Eight, q: &[Eight], out: &mut [Eight]);

    /// [`Equations::velocity_constraint`].
    fn velocity_constraint_in_lanes(&self, c: &[Eight], t: &Eight, q: &[Eight], v: &[Eight], out: &mut [Eight]);

    /// [`Equations::correction`].
    fn correction_in_lanes(
        &self,
        c: &[Eight],
        t: &Eight,
        q: &[Eight],
        residual: &[Eight],
        delta: &mut [Eight],
    ) -> Pivots;

    /// [`Equations::state_rates`].
    fn state_rates_in_lanes(&self, c: &[Eight], t: &Eight, q: &[Eight], v: &[Eight], out: &mut [Eight]);
}

impl<S: Equations<f64> + Powers<f64> + Equations<Eight> + Powers<Eight>> EquationsInLanes for S {
    fn accelerations_in_lanes(
        &self,
        c: &[Eight],
        t: &Eight,
        q: &[Eight],
        v: &[Eight],
        a: &mut [Eight],
        lambda: &mut [Eight],
    ) -> Pivots {
        kernels::accelerations(self, c, t, q, v, a, lambda)
    }

    fn powers_in_lanes(&self, c: &[Eight], t: &Eight, q: &[Eight], v: &[Eight], lambda: &[Eight], out: &mut [Eight]) {
        kernels::powers(self, c, t, q, v, lambda, out);
    }

    fn position_constraint_in_lanes(&self, c: &[Eight], t: &Eight, q: &[Eight], out: &mut [Eight]) {
        kernels::position_constraint(self, c, t, q, out);
    }

    fn velocity_constraint_in_lanes(&self, c: &[Eight], t: &Eight, q: &[Eight], v: &[Eight], out: &mut [Eight]) {
        kernels::velocity_constraint(self, c, t, q, v, out);
    }

    fn correction_in_lanes(
        &self,
        c: &[Eight],
        t: &Eight,
        q: &[Eight],
        residual: &[Eight],
        delta: &mut [Eight],
    ) -> Pivots {
        kernels::correction(self, c, t, q, residual, delta)
    }

    fn state_rates_in_lanes(&self, c: &[Eight], t: &Eight, q: &[Eight], v: &[Eight], out: &mut [Eight]) {
        kernels::state_rates(self, c, t, q, v, out);
    }
}

/// Kernels in lanes as a processor has them: compiled for wide vector registers, or those of `f64` one state after the other, with the same bits for angles up to
/// 1e6 rad. These allocate.
pub(crate) mod kernels {
    use crate::model::quasi_velocities::QuasiVelocities;
    use crate::model::{Equations, Pivots, Powers};
    use crate::scalar::{Lanes, in_wide_or, in_widest_or};

    macro_rules! kernels {
        ($($name:ident of $equations:ident by $registers:ident: ($($read:ident),*) -> ($($written:ident),*) $(-> $result:ty)?;)*) => {
            $(#[expect(clippy::allow_attributes, reason = "some of them have few arguments")]
            #[allow(clippy::too_many_arguments, reason = "those of the kernel")]
            pub(crate) fn $name<const L: usize, S: $equations<f64> + $equations<Lanes<L>>>(
                scene: &S,
                c: &[Lanes<L>],
                t: &Lanes<L>,
                $($read: &[Lanes<L>],)*
                $($written: &mut [Lanes<L>],)*
            ) $(-> $result)? {
                // both closures write, and one is called
                let written = std::cell::RefCell::new([$($written),*]);
                $registers(
                    #[inline(always)]
                    || {
                        let [$($written),*] = &mut *written.borrow_mut();
                        $equations::<Lanes<L>>::$name(scene, c, *t, $($read,)* $($written),*)
                    },
                    || one_by_one::$name(scene, c, t, $($read,)* &mut *written.borrow_mut()),
                )
            })*

            /// For processors without these registers, compiled once, not for each scene.
            mod one_by_one {
                use super::super::one_by_one;
                use super::{Equations, Lanes, Pivots, Powers, QuasiVelocities};

                $(#[cold]
                pub(super) fn $name<const L: usize>(
                    scene: &dyn $equations<f64>,
                    c: &[Lanes<L>],
                    t: &Lanes<L>,
                    $($read: &[Lanes<L>],)*
                    written: &mut [&mut [Lanes<L>]; kernels!(count $($written)*)],
                ) $(-> $result)? {
                    one_by_one([c, std::slice::from_ref(t), $($read),*], written, |[c, t, $($read),*], [$($written),*]| {
                        scene.$name(c, t[0], $($read,)* $($written),*)
                    })
                })*
            }
        };
        (count $one:ident) => { 1 };
        (count $one:ident $two:ident) => { 2 };
    }
    kernels!(
        accelerations of Equations by in_wide_or: (q, v) -> (a, lambda) -> Pivots;
        correction of Equations by in_wide_or: (q, residual) -> (delta) -> Pivots;
        position_constraint of Equations by in_wide_or: (q) -> (out);
        velocity_constraint of Equations by in_wide_or: (q, v) -> (out);
        state_rates of Equations by in_wide_or: (q, v) -> (out);
        powers of Powers by in_wide_or: (q, v, lambda) -> (out);
        velocities of QuasiVelocities by in_wide_or: (q, u) -> (v);
        values_of_time of QuasiVelocities by in_wide_or: () -> (of_time);
        whole_state of QuasiVelocities by in_widest_or: (q, u) -> (out, v);
    );
}

/// What a kernel returns for several states.
pub(crate) trait OfEach {
    fn and(self, other: Self) -> Self;
}

impl OfEach for () {
    fn and(self, (): Self) {}
}

impl OfEach for Pivots {
    fn and(self, other: Self) -> Self {
        self.and(other)
    }
}

/// What `f` writes and returns for each state by itself.
pub(crate) fn one_by_one<const L: usize, const R: usize, const W: usize, P: OfEach>(
    read: [&[Lanes<L>]; R],
    written: &mut [&mut [Lanes<L>]; W],
    mut f: impl FnMut([&[f64]; R], [&mut [f64]; W]) -> P,
) -> P {
    let mut of_read = read.map(|lanes| vec![0.0; lanes.len()]);
    let mut of_written = written.each_ref().map(|lanes| vec![0.0; lanes.len()]);
    let mut of_lane = |lane: usize| {
        for (one, lanes) in of_read.iter_mut().zip(read) {
            one.iter_mut().zip(lanes).for_each(|(one, lanes)| *one = lanes.0[lane]);
        }
        let found = f(of_read.each_ref().map(|one| &one[..]), of_written.each_mut().map(|one| &mut one[..]));
        for (one, lanes) in of_written.iter().zip(&mut *written) {
            one.iter().zip(&mut **lanes).for_each(|(one, lanes)| lanes.0[lane] = *one);
        }
        found
    };
    let first = of_lane(0);
    (1..L).fold(first, |found, lane| found.and(of_lane(lane)))
}

/// A matrix, by columns, times the eight values of a number.
#[inline(always)]
pub(crate) fn times(matrix: &[Eight; N_LANES], values: &Eight) -> Eight {
    let product = |j: usize| matrix[j] * Eight::from_f64(values.0[j]);
    let [mut even, mut odd] = [product(0), product(1)];
    for j in [2, 4, 6] {
        even = matrix[j].fused(Eight::from_f64(values.0[j]), even);
        odd = matrix[j + 1].fused(Eight::from_f64(values.0[j + 1]), odd);
    }
    even + odd
}

/// The largest difference of a number, each with its weight; what is no number counts.
#[inline(always)]
pub(crate) fn largest_change(one: &[Eight], other: &[Eight], weights: &[f64]) -> f64 {
    let mut largest = Lanes([0.0; N_LANES]);
    for ((one, other), weight) in one.iter().zip(other).zip(weights) {
        let change = (*one - *other).abs() * Eight::from_f64(*weight);
        for i in 0..N_LANES {
            largest.0[i] = if change.0[i] <= largest.0[i] { largest.0[i] } else { change.0[i] };
        }
    }
    largest.magnitude()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::system_of;
    use crate::linalg::Backend;
    use crate::machine::narrow::assert_same_on_each_processor;
    use crate::model::{Derived as _, Scene};

    crate::model! {
        /// Eight bodies in a row, whose elimination is written in parts.
        model Row {
            body b1 { mass: 1, inertia: 1 }
            body b2 { mass: 2, inertia: 1 }
            body b3 { mass: 3, inertia: 1 }
            body b4 { mass: 4, inertia: 1 }
            body b5 { mass: 5, inertia: 1 }
            body b6 { mass: 6, inertia: 1 }
            body b7 { mass: 7, inertia: 1 }
            body b8 { mass: 8, inertia: 1 }
            hinge h1: b1(1, 0) ~ b2(-1, 0.1);
            hinge h2: b2(1, 0) ~ b3(-1, 0.1);
            hinge h3: b3(1, 0) ~ b4(-1, 0.1);
            hinge h4: b4(1, 0) ~ b5(-1, 0.1);
            hinge h5: b5(1, 0) ~ b6(-1, 0.1);
            hinge h6: b6(1, 0) ~ b7(-1, 0.1);
            hinge h7: b7(1, 0) ~ b8(-1, 0.1);
            effect push {
                force at b1(0, 0): ((3 N) * cos(t / (1 s)), (-1 N/m) * b1.y);
            }
            start bent { b1 at (0, 0) angle 0; b2 angle 0.3; b3 angle 0.1; b4 angle -0.4; b5 angle 0; b6 angle 0.2; b7 angle 0.5; b8 angle 1; at rest; }
            scene slides { start bent; until 1 s; with push; }
        }
    }

    /// Numbers that differ from lane to lane.
    fn moved(x: &[f64]) -> Vec<Eight> {
        let of_lane = |i: usize, lane: usize| ((3 * i + 5 * lane) as f64).sin();
        x.iter().enumerate().map(|(i, x)| Lanes(std::array::from_fn(|lane| x + of_lane(i, lane)))).collect()
    }

    /// Kernels of one state after the other are those in lanes.
    #[test]
    fn invariant_kernels_on_each_processor_have_the_same_bits() {
        let scene = row::Slides::default();
        let system = system_of(&scene as &dyn Scene, Backend::Auto).unwrap();
        let info = scene.info();
        let (n_q, n_c) = (info.n_coordinates(), info.n_rows());
        let kernels = scene.in_lanes().unwrap();
        let c: Vec<Eight> = system.fixed().iter().map(|&c| Eight::from_f64(c)).collect();
        let [q, v] = [system.scene_start().q, vec![0.0; n_q]].map(|x| moved(&x));
        let (t, residual) = (moved(&[1.0])[0], moved(&vec![0.0; n_c]));
        let computed = || {
            let zeros = |n: usize| vec![Eight::from_f64(0.0); n];
            let [mut of_positions, mut of_velocities, mut power] = [info.n_position_rows, n_c, 1].map(zeros);
            let [mut a, mut lambda, mut delta] = [n_q, n_c, n_q].map(zeros);
            kernels.position_constraint_in_lanes(&c, &t, &q, &mut of_positions);
            kernels.velocity_constraint_in_lanes(&c, &t, &q, &v, &mut of_velocities);
            let pivots = [
                kernels.accelerations_in_lanes(&c, &t, &q, &v, &mut a, &mut lambda),
                kernels.correction_in_lanes(&c, &t, &q, &residual, &mut delta),
            ];
            kernels.powers_in_lanes(&c, &t, &q, &v, &lambda, &mut power);
            let found = [of_positions, of_velocities, a, lambda, delta, power].concat();
            assert!(found.iter().all(|x| x.0.iter().all(|x| x.is_finite() && *x != 0.0)));
            (pivots.map(|pivots| (pivots.all_keep(), pivots.smallest())), found)
        };
        assert_same_on_each_processor(computed);
    }
}
