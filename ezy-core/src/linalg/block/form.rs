//! How a joint keeps its part of Γ = G M^−½: as much as its rows can have.

use super::two::Number;
use super::{Block, Column};
use crate::linalg::joints::BODIES;
use crate::model::coordinate::N_OF_BODY;

/// Where each number that a joint keeps stands among its entries of G, for each body; beyond all of them where it is zero.
pub(super) type Layout<const N: usize> = [[u32; N]; BODIES];

/// With the second body before the first.
pub(super) fn turned<const N: usize>([first, second]: Layout<N>) -> Layout<N> {
    [second, first]
}

/// How the part of Γ = G M^−½ that one joint has of one body is kept, in `N` numbers. Γ Γᵀ is A, and nothing else asks for masses.
pub(super) trait Form<const B: usize, const N: usize>: Send {
    /// Whether all joints have `B` rows.
    const WHOLE: bool;

    /// That of rows which have all their entries, as many as there are numbers, the first body before the second.
    const USUAL: Layout<N>;

    /// The component of the number that stands there.
    fn component(at: usize) -> usize;

    /// Where the entry of a row and a component is kept; none where it always is zero.
    fn place(row: usize, component: usize) -> Option<usize>;

    /// Writes the part of Γ by the entries of G of a joint, and the roots of the inverse masses of its bodies.
    #[inline(always)]
    fn scale(layout: &Layout<N>, entries: &[f64], roots: [&[f64; N_OF_BODY]; BODIES], slots: &mut [[f64; N]; BODIES]) {
        for ((slot, layout), root) in slots.iter_mut().zip(layout).zip(roots) {
            for (at, (number, &entry)) in slot.iter_mut().zip(layout).enumerate() {
                *number = entries.get(entry as usize).map_or(0.0, |entry| entry * root[Self::component(at)]);
            }
        }
    }

    /// `a bᵀ` for the same body.
    fn product<T: Number>(a: &[T; N], b: &[T; N]) -> Block<B, T>;

    /// `sum += slot x`.
    fn add<T: Number>(sum: &mut Column<B, T>, slot: &[T; N], x: &[T; N_OF_BODY]);

    /// `x −= slotᵀ y`.
    fn subtract_transposed<T: Number>(x: &mut [T; N_OF_BODY], slot: &[T; N], y: &Column<B, T>);
}

/// Column after column.
pub(super) struct Full;

impl<const B: usize, const N: usize> Form<B, N> for Full {
    const WHOLE: bool = false;
    const USUAL: Layout<N> = {
        let mut layout = [[0; N]; BODIES];
        let mut at = 0;
        while at < N {
            let (row, component) = (at % B, at / B);
            let mut side = 0;
            while side < BODIES {
                layout[side][at] = ((row * BODIES + side) * N_OF_BODY + component) as u32;
                side += 1;
            }
            at += 1;
        }
        layout
    };

    #[inline]
    fn component(at: usize) -> usize {
        at / B
    }

    fn place(row: usize, component: usize) -> Option<usize> {
        Some(component * B + row)
    }

    #[inline]
    fn product<T: Number>(a: &[T; N], b: &[T; N]) -> Block<B, T> {
        let mut block = [[T::from_f64(0.0); B]; B];
        for (a, b) in a.chunks_exact(B).zip(b.chunks_exact(B)) {
            for (column, b) in block.iter_mut().zip(b) {
                column.iter_mut().zip(a).for_each(|(entry, a)| *entry = *entry + *a * *b);
            }
        }
        block
    }

    #[inline]
    fn add<T: Number>(sum: &mut Column<B, T>, slot: &[T; N], x: &[T; N_OF_BODY]) {
        for (column, x) in slot.chunks_exact(B).zip(x) {
            sum.iter_mut().zip(column).for_each(|(sum, g)| *sum = *sum + *g * *x);
        }
    }

    #[inline]
    fn subtract_transposed<T: Number>(x: &mut [T; N_OF_BODY], slot: &[T; N], y: &Column<B, T>) {
        for (x, column) in x.iter_mut().zip(slot.chunks_exact(B)) {
            *x = column.iter().zip(y).map(|(g, y)| *g * *y).reduce(T::add).map_or(*x, |sum| *x - sum);
        }
    }
}

/// Of joints of two rows, of which the first has nothing of y and the second nothing of x, as a hinge: x of the first, y of the second, φ of both.
pub(super) struct Aligned;

impl Form<2, 4> for Aligned {
    const WHOLE: bool = true;
    const USUAL: Layout<4> = [[0, 4, 1, 5], [2, 6, 3, 7]];

    #[inline]
    fn component(at: usize) -> usize {
        at.min(2)
    }

    fn place(row: usize, component: usize) -> Option<usize> {
        match component {
            2 => Some(2 + row),
            _ => (component == row).then_some(row),
        }
    }

    #[inline]
    fn product<T: Number>(a: &[T; 4], b: &[T; 4]) -> Block<2, T> {
        [[a[2] * b[2] + a[0] * b[0], a[3] * b[2]], [a[2] * b[3], a[3] * b[3] + a[1] * b[1]]]
    }

    #[inline]
    fn add<T: Number>(sum: &mut Column<2, T>, slot: &[T; 4], &[x, y, phi]: &[T; N_OF_BODY]) {
        *sum = [sum[0] + (slot[0] * x + slot[2] * phi), sum[1] + (slot[1] * y + slot[3] * phi)];
    }

    #[inline]
    fn subtract_transposed<T: Number>([x, y, phi]: &mut [T; N_OF_BODY], slot: &[T; 4], of: &Column<2, T>) {
        (*x, *y) = (*x - slot[0] * of[0], *y - slot[1] * of[1]);
        *phi = *phi - (slot[2] * of[0] + slot[3] * of[1]);
    }
}
