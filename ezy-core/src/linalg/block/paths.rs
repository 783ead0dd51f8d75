//! Two paths of joints, each from a loose end inwards, side by side in vector registers.

use super::columns::Rows;
use super::form::{Form, Layout};
use super::fraction::Fraction;
use super::two::{Number, Two};
use super::{Block, Column, Node, apply, dot, product_times, subtract, sum, times};
use crate::linalg::VanishedPivot;
use crate::linalg::joints::BODIES;
use crate::model::coordinate::N_OF_BODY;
use std::array::from_fn;

/// Numbers of a body.
type OfBody<T = f64> = [T; N_OF_BODY];

/// A joint of either path, and what is their own in the factors. Their columns have one block below the diagonal, in the row of the next twin.
#[derive(Debug, Clone)]
pub(super) struct Twin<const B: usize, const N: usize> {
    /// Their parts of Γ: of the bodies that the joints before hold, and of those that the next ones hold.
    slots: [[Two; N]; BODIES],
    /// Of their blocks of D.
    inverse: Block<B, Two>,
    /// Of L.
    lower: Block<B, Two>,
    /// y of the right side and of the solution.
    y: Column<B, Two>,
    places: [Place; 2],
}

/// Where a joint of a path stands.
#[derive(Debug, Clone, Copy)]
pub(super) struct Place {
    /// In the order of the slots; of a joint that holds one body alone, that one twice.
    pub bodies: [u32; BODIES],
    pub first_entry: u32,
    pub layout: u32,
    pub rows: Rows,
    /// Whether its first body in G is the second one here.
    pub is_turned: bool,
}

/// Twins one behind the other.
#[derive(Debug, Clone)]
pub(super) struct Stretch {
    pub n_twins: usize,
    /// The joint behind each path among those that are in none, and the place there of the body that both hold.
    pub ends: [(usize, usize); 2],
    /// Whether the first joint of each path holds a body before it.
    pub begins_with_body: [bool; 2],
}

/// All paths.
pub(super) struct Paths<const B: usize, const N: usize> {
    twins: Vec<Twin<B, N>>,
    stretches: Vec<Stretch>,
    /// M^−½ of the bodies of each stretch, from that before its first twin on.
    roots: Vec<OfBody<Two>>,
}

/// What is factored.
pub(super) struct Given<'a, const N: usize> {
    pub layouts: &'a [Layout<N>],
    pub jacobian: &'a [f64],
    pub damping: Option<&'a [f64]>,
    pub least: f64,
}

impl<const N: usize> Given<'_, N> {
    /// The parts of Γ of two joints, by the roots of the bodies before and behind them.
    #[inline(always)]
    fn slots<F: Form<B, N>, const B: usize>(
        &self,
        places: &[Place; 2],
        roots: [&OfBody<Two>; BODIES],
    ) -> [[Two; N]; BODIES] {
        let entries = places.each_ref().map(|place| &self.jacobian[place.first_entry as usize..]);
        if places[0].layout | places[1].layout == 0 {
            // without a question at each entry
            let entries = entries.map(|entries| &entries[..BODIES * N]);
            return match places.each_ref().map(|place| place.is_turned) {
                [false, false] => usual_slots::<F, B, N>(entries, [0, 0], roots),
                [false, true] => usual_slots::<F, B, N>(entries, [0, 1], roots),
                [true, false] => usual_slots::<F, B, N>(entries, [1, 0], roots),
                [true, true] => usual_slots::<F, B, N>(entries, [1, 1], roots),
            };
        }
        let of_lane: [[[f64; N]; BODIES]; 2] = from_fn(|lane| {
            let place = &places[lane];
            let (mut slots, mut roots) = ([[0.0; N]; BODIES], roots.map(|root| root.map(|root| root.lanes()[lane])));
            if place.is_turned {
                roots.swap(0, 1);
            }
            F::scale(&self.layouts[place.layout as usize], entries[lane], roots.each_ref(), &mut slots);
            if place.is_turned {
                slots.swap(0, 1);
            }
            slots
        });
        from_fn(|side| from_fn(|at| Two::new([of_lane[0][side][at], of_lane[1][side][at]])))
    }
}

/// Those of joints with all their entries, of which `turned` says whose first body in G is the second one.
#[inline(always)]
fn usual_slots<F: Form<B, N>, const B: usize, const N: usize>(
    entries: [&[f64]; 2],
    turned: [usize; 2],
    roots: [&OfBody<Two>; BODIES],
) -> [[Two; N]; BODIES] {
    let mut slots = [[Two::from_f64(0.0); N]; BODIES];
    for side in 0..BODIES {
        for at in 0..N {
            let entry = Two::new(from_fn(|lane| entries[lane][F::USUAL[side ^ turned[lane]][at] as usize]));
            slots[side][at] = entry * roots[side][F::component(at)];
        }
    }
    slots
}

/// The numbers of the bodies of two joints on one side.
#[inline(always)]
fn gathered(of: &[OfBody], places: &[Place; 2], side: usize) -> OfBody<Two> {
    let [one, other] = places.each_ref().map(|place| &of[place.bodies[side] as usize]);
    from_fn(|i| Two::new([one[i], other[i]]))
}

/// The rows of two joints.
#[inline(always)]
fn rows<F: Form<B, N>, const B: usize, const N: usize>(places: &[Place; 2], of: &[f64]) -> Column<B, Two> {
    let [one, other] = places.each_ref().map(|place| place.rows.of::<F, B, N>(of));
    from_fn(|r| Two::new([one[r], other[r]]))
}

impl<const B: usize, const N: usize> Paths<B, N> {
    pub(super) fn new(places: &[[Place; 2]], stretches: Vec<Stretch>) -> Self {
        let zero = [[Two::from_f64(0.0); B]; B];
        let twin = |&places| Twin {
            slots: [[Two::from_f64(0.0); N]; BODIES],
            inverse: zero,
            lower: zero,
            y: [Two::from_f64(0.0); B],
            places,
        };
        Self { twins: places.iter().map(twin).collect(), stretches, roots: Vec::new() }
    }

    pub(super) fn n_joints(&self) -> usize {
        2 * self.twins.len()
    }

    /// Keeps the roots of other masses.
    pub(super) fn take_roots(&mut self, of_bodies: &[OfBody]) {
        self.roots.clear();
        let mut rest = &self.twins[..];
        for stretch in &self.stretches {
            let twins;
            (twins, rest) = rest.split_at(stretch.n_twins);
            self.roots.extend(twins.first().map(|first| gathered(of_bodies, &first.places, 0)));
            self.roots.extend(twins.iter().map(|twin| gathered(of_bodies, &twin.places, 1)));
        }
    }

    /// Eliminates all paths, and hands on what they leave to the joints behind. Returns the smallest pivot.
    pub(super) fn eliminate<F: Form<B, N>>(
        &mut self,
        nodes: &mut [Node<B, N>],
        given: &Given<'_, N>,
    ) -> Result<f64, VanishedPivot> {
        let (one, zero) = (Two::from_f64(1.0), Two::from_f64(0.0));
        // zero as long as all numbers are finite, and the denominators are not zero
        let (mut smallest, mut not_finite) = (one, zero);
        let swept = self.sweep::<F>(nodes, given, |_, inverse, reciprocal| {
            let all = inverse.pivots.iter().fold(inverse.denominator + reciprocal, |sum, &pivot| sum + pivot);
            not_finite = not_finite + all * zero;
            smallest = inverse.pivots.iter().fold(smallest, |smallest, pivot| pivot.min(smallest));
            Ok(())
        });
        let [a, b] = smallest.lanes();
        if swept.is_ok() && a > given.least && b > given.least && not_finite.lanes() == [0.0; 2] {
            return Ok(if a < b { a } else { b });
        }
        Err(self.vanished::<F>(nodes, given))
    }

    /// The first pivot that is too small, looked for once more.
    #[cold]
    fn vanished<F: Form<B, N>>(&mut self, nodes: &mut [Node<B, N>], given: &Given<'_, N>) -> VanishedPivot {
        let swept = self.sweep::<F>(nodes, given, |places, inverse, _| {
            for (lane, place) in places.iter().enumerate() {
                let pivots = inverse.pivots.map(|pivot| pivot.lanes()[lane]);
                if !(pivots.iter().all(|&pivot| pivot > given.least) && inverse.denominator.lanes()[lane].is_normal()) {
                    return Err(place.rows.vanished(&pivots, given.least));
                }
            }
            Ok(())
        });
        swept.err().unwrap_or(VanishedPivot { relative: f64::NAN, row: None })
    }

    /// Eliminates, and lets every inverse of a block of D be judged: where the joints stand, the inverse, and one over its denominator.
    #[inline(always)]
    fn sweep<F: Form<B, N>>(
        &mut self,
        nodes: &mut [Node<B, N>],
        given: &Given<'_, N>,
        mut judge: impl FnMut(&[Place; 2], &Fraction<B, Two>, Two) -> Result<(), VanishedPivot>,
    ) -> Result<(), VanishedPivot> {
        let (mut rest, mut roots) = (&mut self.twins[..], &self.roots[..]);
        for stretch in &self.stretches {
            let twins;
            (twins, rest) = std::mem::take(&mut rest).split_at_mut(stretch.n_twins);
            for (twin, roots) in twins.iter_mut().zip(roots.windows(BODIES)) {
                twin.slots = given.slots::<F, B>(&twin.places, [&roots[0], &roots[1]]);
            }
            roots = &roots[stretch.n_twins + 1..];
            // what the joints before take from a block of D, of which the triangle below is read
            let mut taken = [[Two::from_f64(0.0); B]; B];
            let mut behind = twins;
            while let Some((twin, later)) = behind.split_first_mut() {
                let [early, late] = &twin.slots;
                let mut own = sum(&F::product(early, early), &F::product(late, late));
                if let Some(damping) = given.damping {
                    let damping = rows::<F, B, N>(&twin.places, damping);
                    (0..B).for_each(|r| own[r][r] = own[r][r] + damping[r]);
                }
                let start = from_fn(|r| own[r][r]);
                let inverse = Fraction::inverse(&from_fn(|c| from_fn(|r| own[c][r] - taken[c][r])), &start);
                // the products do not wait for the division
                let reciprocal = Two::from_f64(1.0) / inverse.denominator;
                judge(&twin.places, &inverse, reciprocal)?;
                twin.inverse = times(&inverse.numerator, reciprocal);
                let block = match later.first() {
                    Some(next) => F::product(&next.slots[0], late),
                    None => {
                        let [one, other] = stretch.ends.map(|(node, side)| &nodes[node].slots[side]);
                        F::product(&from_fn(|at| Two::new([one[at], other[at]])), late)
                    }
                };
                let scaled = inverse.numerator.map(|of_row| apply(&block, &of_row));
                taken = product_times(&scaled, &block, reciprocal);
                twin.lower = times(&scaled, reciprocal);
                behind = later;
            }
            for (lane, (node, _)) in stretch.ends.iter().enumerate() {
                for (c, column) in nodes[*node].pending.iter_mut().enumerate() {
                    (c..B).for_each(|r| column[r] -= taken[c][r].lanes()[lane]);
                }
            }
        }
        Ok(())
    }

    /// `L y = Γ x − s`, as far as the joints behind the paths.
    pub(super) fn forward<F: Form<B, N>>(&mut self, nodes: &mut [Node<B, N>], x: &[OfBody], s: &[f64]) {
        let mut rest = &mut self.twins[..];
        for stretch in &self.stretches {
            let twins;
            (twins, rest) = std::mem::take(&mut rest).split_at_mut(stretch.n_twins);
            let Some(first) = twins.first() else { continue };
            let mut before = gathered(x, &first.places, 0);
            let mut pulled = [Two::from_f64(0.0); B];
            for twin in twins {
                let behind = gathered(x, &twin.places, 1);
                let mut sum = rows::<F, B, N>(&twin.places, s).map(|s| -s);
                F::add(&mut sum, &twin.slots[0], &before);
                F::add(&mut sum, &twin.slots[1], &behind);
                // what waits for earlier joints comes last
                subtract(&mut sum, &pulled);
                twin.y = sum;
                pulled = apply(&twin.lower, &sum);
                before = behind;
            }
            for (lane, (node, _)) in stretch.ends.iter().enumerate() {
                subtract(&mut nodes[*node].y, &pulled.map(|y| y.lanes()[lane]));
            }
        }
    }

    /// `D Lᵀ y = y` from the joints behind the paths on, then `x −= Γᵀ y`; hands out the rows of each joint, and y there.
    #[inline(always)]
    pub(super) fn backward<F: Form<B, N>>(
        &mut self,
        nodes: &[Node<B, N>],
        x: &mut [OfBody],
        mut found: impl FnMut(Rows, &Column<B>),
    ) {
        let mut rest = &mut self.twins[..];
        for stretch in self.stretches.iter().rev() {
            let twins;
            (rest, twins) = {
                let n_before = rest.len() - stretch.n_twins;
                std::mem::take(&mut rest).split_at_mut(n_before)
            };
            let Some(last) = twins.last() else { continue };
            let [one, other] = stretch.ends.map(|(node, _)| &nodes[node].y);
            let mut y: Column<B, Two> = from_fn(|r| Two::new([one[r], other[r]]));
            let mut behind = gathered(x, &last.places, 1);
            let mut places = last.places;
            for twin in twins.iter_mut().rev() {
                places = twin.places;
                let mut solved = apply(&twin.inverse, &twin.y);
                subtract(&mut solved, &twin.lower.map(|of_row| dot(&of_row, &y)));
                (twin.y, y) = (solved, solved);
                let mut before = gathered(x, &places, 0);
                F::subtract_transposed(&mut behind, &twin.slots[1], &y);
                F::subtract_transposed(&mut before, &twin.slots[0], &y);
                for (lane, place) in places.iter().enumerate() {
                    x[place.bodies[1] as usize] = behind.map(|x| x.lanes()[lane]);
                    found(place.rows, &y.map(|y| y.lanes()[lane]));
                }
                behind = before;
            }
            for (lane, place) in places.iter().enumerate() {
                if stretch.begins_with_body[lane] {
                    x[place.bodies[0] as usize] = behind.map(|x| x.lanes()[lane]);
                }
            }
        }
    }
}
