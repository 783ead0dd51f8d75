//! Two paths of joints, each from an end of a tree inwards, side by side in vector registers.

use super::columns::{Rows, bodies, layout};
use super::form::{Form, Layout};
use super::fraction::Fraction;
use super::two::{Number, Two};
use super::{Block, Bodies, Column, Node, OfBody, RightSide, apply, dot, product_times, subtract, sum, times};
use crate::linalg::VanishedPivot;
use crate::linalg::joints::{BODIES, Plan};
use crate::linalg::tolerances::blocks::NEGLIGIBLE;
use crate::model::SparsityPattern;
use crate::model::coordinate::N_OF_BODY;
use crate::pages::in_large_pages;
use std::array::from_fn;

/// A joint of either path, and what is their own in the factors. Their columns have one block below the diagonal, in the row of the next twin.
#[derive(Debug)]
struct Twin<const B: usize, const N: usize> {
    /// Their parts of Γ: of the bodies that the joints before hold, and of those that the next ones hold.
    slots: [[Two; N]; BODIES],
    /// Of their blocks of D.
    inverse: Block<B, Two>,
    /// Of L.
    lower: Block<B, Two>,
    /// y of the right side.
    y: Column<B, Two>,
    places: [Place; 2],
}

/// Where a joint of a path stands.
#[derive(Debug, Clone, Copy)]
struct Place {
    /// In the order of the slots; of a joint that holds one body alone, that one twice.
    bodies: [u32; BODIES],
    first_entry: u32,
    layout: u32,
    rows: Rows,
}

/// Both paths.
#[derive(Debug)]
pub(super) struct Paths<const B: usize, const N: usize> {
    twins: Vec<Twin<B, N>>,
    /// The joint behind each path among those that are in none, and the place there of the body that both hold.
    ends: [(usize, usize); 2],
    /// Multipliers below this are zero.
    negligible: Two,
}

/// All pairs of paths of a plan.
pub(super) fn paths<F: Form<B, N>, const B: usize, const N: usize>(
    plan: &Plan,
    pattern: &SparsityPattern,
    layouts: &mut Vec<Layout<N>>,
    negligible: f64,
) -> Vec<Paths<B, N>> {
    let (Plan { joints, later, paths }, n_in_paths) = (plan, plan.n_in_paths());
    // of a path every joint has one behind it, with which it shares one body: its places here and there
    let behind = |k: usize| {
        let sides = joints[k].bodies.iter().enumerate();
        let shared = sides.filter_map(|(side, &body)| Some((side, joints[later[k][0]].side_of(body)?))).next();
        (later[k][0], shared.unwrap_or_default())
    };
    let mut place = |k: usize| {
        let (joint, is_turned) = (&joints[k], behind(k).1.0 == 0);
        let mut bodies = bodies(joint);
        if is_turned {
            bodies.swap(0, 1);
        }
        let first_entry = pattern.row(joint.first_row).start as u32;
        let layout = layout::<F, B, N>(joint, is_turned, pattern, layouts);
        Place { bodies, first_entry, layout, rows: Rows::new(joint) }
    };
    let mut first = 0;
    let both = paths.iter().map(|&n| {
        let places: Vec<[Place; 2]> = (0..n).map(|i| [0, 1].map(|lane| place(first + 2 * i + lane))).collect();
        first += 2 * n;
        let end = |k: usize| (behind(k).0 - n_in_paths, behind(k).1.1);
        Paths::new(&places, [end(first - 2), end(first - 1)], negligible)
    });
    both.collect()
}

/// What is factored.
pub(super) struct Given<'a, const N: usize> {
    pub layouts: &'a [Layout<N>],
    pub jacobian: &'a [f64],
    pub roots: &'a [OfBody],
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
        // without a question at each entry
        let usual = |turned| usual_slots::<F, B, N>(entries.map(|entries| &entries[..BODIES * N]), turned, roots);
        match places.each_ref().map(|place| place.layout) {
            [0, 0] => return usual([0, 0]),
            [0, 1] => return usual([0, 1]),
            [1, 0] => return usual([1, 0]),
            [1, 1] => return usual([1, 1]),
            _ => {}
        }
        let of_lane: [[[f64; N]; BODIES]; 2] = from_fn(|lane| {
            let mut slots = [[0.0; N]; BODIES];
            let roots = roots.map(|root| root.map(|root| root.lanes()[lane]));
            F::scale(&self.layouts[places[lane].layout as usize], entries[lane], roots.each_ref(), &mut slots);
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

/// Whether what this twin passes on is tested for negligible numbers: not at every one, since the next one waits for it.
#[inline(always)]
fn is_tested(i: usize) -> bool {
    i % 16 == 15
}

/// What is done with each pair of joints while they are eliminated.
trait Along<F, const B: usize, const N: usize> {
    /// Once Γ is known, with the roots of the bodies behind the joints.
    fn begin(&mut self, twin: &mut Twin<B, N>, roots: &OfBody<Two>);

    /// Once L is known.
    fn end(&mut self, i: usize, twin: &Twin<B, N>);
}

impl<F, const B: usize, const N: usize> Along<F, B, N> for () {
    fn begin(&mut self, _twin: &mut Twin<B, N>, _roots: &OfBody<Two>) {}

    fn end(&mut self, _i: usize, _twin: &Twin<B, N>) {}
}

/// What joints along the paths lose by those before.
struct Pull<const B: usize> {
    negligible: Two,
    pulled: Column<B, Two>,
}

impl<const B: usize> Pull<B> {
    fn new(negligible: Two) -> Self {
        Self { negligible, pulled: [Two::from_f64(0.0); B] }
    }

    #[inline(always)]
    fn by<const N: usize>(&mut self, i: usize, twin: &Twin<B, N>) {
        self.pulled = apply(&twin.lower, &twin.y);
        if is_tested(i) {
            self.pulled = self.pulled.map(|y| y.or_zero_below(self.negligible));
        }
    }

    /// To the joints behind the paths.
    fn hand_on<const N: usize>(self, nodes: &mut [Node<B, N>], ends: &[(usize, usize); 2]) {
        for (lane, (node, _)) in ends.iter().enumerate() {
            subtract(&mut nodes[*node].y, &self.pulled.map(|y| y.lanes()[lane]));
        }
    }
}

/// `L y = Γ x − s` along the paths.
struct Substitution<'a, const B: usize> {
    x: Bodies<'a>,
    s: &'a [f64],
    /// x of the bodies before the next joints.
    before: OfBody<Two>,
    pull: Pull<B>,
}

impl<'a, const B: usize> Substitution<'a, B> {
    fn new(x: Bodies<'a>, s: &'a [f64], first: &[Place; 2], negligible: Two) -> Self {
        let before = scaled(gathered(x.of, first, 0), &gathered(x.roots, first, 0));
        Self { x, s, before, pull: Pull::new(negligible) }
    }
}

impl<F: Form<B, N>, const B: usize, const N: usize> Along<F, B, N> for Substitution<'_, B> {
    #[inline(always)]
    fn begin(&mut self, twin: &mut Twin<B, N>, roots: &OfBody<Two>) {
        let behind = scaled(gathered(self.x.of, &twin.places, 1), roots);
        let mut sum = rows::<F, B, N>(&twin.places, self.s).map(|s| -s);
        F::add(&mut sum, &twin.slots[0], &self.before);
        F::add(&mut sum, &twin.slots[1], &behind);
        // what waits for earlier joints comes last
        subtract(&mut sum, &self.pull.pulled);
        twin.y = sum;
        self.before = behind;
    }

    #[inline(always)]
    fn end(&mut self, i: usize, twin: &Twin<B, N>) {
        self.pull.by(i, twin);
    }
}

#[inline(always)]
fn scaled(x: OfBody<Two>, roots: &OfBody<Two>) -> OfBody<Two> {
    from_fn(|i| x[i] * roots[i])
}

impl<const B: usize, const N: usize> Paths<B, N> {
    fn new(places: &[[Place; 2]], ends: [(usize, usize); 2], negligible: f64) -> Self {
        let zero = Two::from_f64(0.0);
        let twin = |&places| Twin {
            slots: [[zero; N]; BODIES],
            inverse: [[zero; B]; B],
            lower: [[zero; B]; B],
            y: [zero; B],
            places,
        };
        let mut twins = in_large_pages(Vec::with_capacity(places.len()));
        twins.extend(places.iter().map(twin));
        Self { twins, ends, negligible: Two::from_f64(negligible) }
    }

    pub(super) fn n_joints(&self) -> usize {
        2 * self.twins.len()
    }

    /// Bodies that no other joints hold.
    pub(super) fn within(&self) -> impl Iterator<Item = usize> {
        let first = self.twins.first().into_iter().flat_map(|twin| &twin.places);
        // one that holds a body alone has none before it
        let before = first.filter(|place| place.bodies[0] != place.bodies[1]).map(|place| place.bodies[0]);
        let between = self.twins.iter().skip(1).flat_map(|twin| &twin.places).map(|place| place.bodies[0]);
        before.chain(between).map(|body| body as usize)
    }

    /// Eliminates the paths, and hands on what they leave to the joints behind; forward substitution, [`Self::forward`], where a right side is given. Returns the
    /// smallest pivot.
    pub(super) fn eliminate<F: Form<B, N>>(
        &mut self,
        nodes: &mut [Node<B, N>],
        given: &Given<'_, N>,
        right_side: Option<RightSide<'_>>,
    ) -> Result<f64, VanishedPivot> {
        let (one, zero) = (Two::from_f64(1.0), Two::from_f64(0.0));
        // zero as long as all numbers are finite, and so is one over each denominator
        let (mut smallest, mut not_finite) = (one, zero);
        let judge = |_: &[Place; 2], inverse: &Fraction<B, Two>, reciprocal: Two| {
            let all = inverse.pivots.iter().fold(inverse.denominator + reciprocal, |sum, &pivot| sum + pivot);
            not_finite = not_finite + all * zero;
            smallest = inverse.pivots.iter().fold(smallest, |smallest, pivot| pivot.min(smallest));
            Ok(())
        };
        let swept = match right_side.zip(self.twins.first()) {
            Some(((x, s), first)) => {
                let mut substitution = Substitution::new(x, s, &first.places, self.negligible);
                let swept = self.sweep::<F>(nodes, given, judge, &mut substitution);
                substitution.pull.hand_on(nodes, &self.ends);
                swept
            }
            None => self.sweep::<F>(nodes, given, judge, &mut ()),
        };
        let [a, b] = smallest.lanes();
        if swept.is_ok() && a > given.least && b > given.least && not_finite.lanes() == [0.0; 2] {
            return Ok(a.min(b));
        }
        Err(self.vanished::<F>(nodes, given))
    }

    /// The first pivot that is too small, looked for once more.
    #[cold]
    fn vanished<F: Form<B, N>>(&mut self, nodes: &mut [Node<B, N>], given: &Given<'_, N>) -> VanishedPivot {
        let judge = |places: &[Place; 2], inverse: &Fraction<B, Two>, _| {
            for (lane, place) in places.iter().enumerate() {
                let pivots = inverse.pivots.map(|pivot| pivot.lanes()[lane]);
                if !(pivots.iter().all(|&pivot| pivot > given.least) && inverse.denominator.lanes()[lane].is_normal()) {
                    return Err(place.rows.vanished(&pivots, given.least));
                }
            }
            Ok(())
        };
        let swept = self.sweep::<F>(nodes, given, judge, &mut ());
        swept.err().unwrap_or(VanishedPivot { relative: f64::NAN, row: None })
    }

    /// Writes Γ and eliminates, and lets every inverse of a block of D be judged: where the joints stand, the inverse, and one over its denominator.
    ///
    /// The elimination is a chain of operations that wait for each other; what goes along fills the time.
    #[inline(always)]
    fn sweep<F: Form<B, N>>(
        &mut self,
        nodes: &mut [Node<B, N>],
        given: &Given<'_, N>,
        mut judge: impl FnMut(&[Place; 2], &Fraction<B, Two>, Two) -> Result<(), VanishedPivot>,
        along: &mut impl Along<F, B, N>,
    ) -> Result<(), VanishedPivot> {
        let Some(first) = self.twins.first_mut() else { return Ok(()) };
        let of_first = gathered(given.roots, &first.places, 0);
        let mut before = gathered(given.roots, &first.places, 1);
        first.slots = given.slots::<F, B>(&first.places, [&of_first, &before]);
        // what the joints before take from a block of D, of which the triangle below is read
        let mut taken = [[Two::from_f64(0.0); B]; B];
        let mut rest = &mut self.twins[..];
        for i in 0.. {
            let Some((twin, later)) = rest.split_first_mut() else { break };
            along.begin(twin, &before);
            // Γ of the next twin, whose operations do not wait for those of this one
            if let Some(next) = later.first_mut() {
                let behind = gathered(given.roots, &next.places, 1);
                next.slots = given.slots::<F, B>(&next.places, [&before, &behind]);
                before = behind;
            }
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
                    let [one, other] = self.ends.map(|(node, side)| &nodes[node].slots[side]);
                    F::product(&from_fn(|at| Two::new([one[at], other[at]])), late)
                }
            };
            let scaled = inverse.numerator.map(|of_row| apply(&block, &of_row));
            taken = product_times(&scaled, &block, reciprocal);
            twin.lower = times(&scaled, reciprocal);
            if is_tested(i) {
                for (c, column) in taken.iter_mut().enumerate() {
                    let least = column[c] * Two::from_f64(NEGLIGIBLE);
                    column[c + 1..].iter_mut().for_each(|entry| *entry = entry.or_zero_below(least));
                }
            }
            along.end(i, twin);
            rest = later;
        }
        for (lane, (node, _)) in self.ends.iter().enumerate() {
            for (c, column) in nodes[*node].pending.iter_mut().enumerate() {
                (c..B).for_each(|r| column[r] -= taken[c][r].lanes()[lane]);
            }
        }
        Ok(())
    }

    /// `L y = Γ x − s`, as far as the joints behind the paths.
    pub(super) fn forward<F: Form<B, N>>(&mut self, nodes: &mut [Node<B, N>], x: Bodies<'_>, s: &[f64]) {
        let Some(first) = self.twins.first() else { return };
        let mut substitution = Substitution::new(x, s, &first.places, self.negligible);
        for (i, twin) in self.twins.iter_mut().enumerate() {
            let roots = gathered(x.roots, &twin.places, 1);
            Along::<F, B, N>::begin(&mut substitution, twin, &roots);
            Along::<F, B, N>::end(&mut substitution, i, twin);
        }
        substitution.pull.hand_on(nodes, &self.ends);
    }

    /// `L y = y`, in the same way.
    pub(super) fn forward_again(&mut self, nodes: &mut [Node<B, N>]) {
        let mut pull = Pull::new(self.negligible);
        for (i, twin) in self.twins.iter_mut().enumerate() {
            subtract(&mut twin.y, &pull.pulled);
            pull.by(i, twin);
        }
        pull.hand_on(nodes, &self.ends);
    }

    /// `D Lᵀ y = y` from the joints behind the paths on, then `x −= Γᵀ y`; y is written into s, or added to it by the second pass of a refined solution. The
    /// first one leaves what is left of the rows in y: where it `BEGINS` and does not end, as far as [`Self::leave`].
    #[inline(always)]
    pub(super) fn backward<F: Form<B, N>, const BEGINS: bool, const ENDS: bool>(
        &mut self,
        nodes: &[Node<B, N>],
        x: &mut [OfBody],
        roots: &[OfBody],
        s: &mut [f64],
    ) {
        let Some(last) = self.twins.last() else { return };
        let [one, other] = self.ends.map(|(node, _)| &nodes[node].y);
        let mut y: Column<B, Two> = from_fn(|r| Two::new([one[r], other[r]]));
        let mut places = last.places;
        // the bodies behind the paths are scaled with those of the other joints
        let (mut behind, mut scale) = (gathered(x, &places, 1), [Two::from_f64(1.0); N_OF_BODY]);
        // of the rows of the joints behind, without the bodies before them, which lose some more
        let mut left = [Two::from_f64(0.0); B];
        for i in (0..self.twins.len()).rev() {
            let [twin, late @ ..] = &mut self.twins[i..] else { break };
            places = twin.places;
            let mut solved = apply(&twin.inverse, &twin.y);
            subtract(&mut solved, &twin.lower.map(|of_row| dot(&of_row, &y)));
            y = solved;
            let (mut before, root) = (gathered(x, &places, 0), gathered(roots, &places, 0));
            if BEGINS {
                before = scaled(before, &root);
            }
            // joints before do not wait for this test
            let kept = y.map(|y| y.or_zero_below(self.negligible));
            F::subtract_transposed(&mut behind, &twin.slots[1], &kept);
            F::subtract_transposed(&mut before, &twin.slots[0], &kept);
            if ENDS {
                behind = scaled(behind, &scale);
            } else {
                match late {
                    // other paths may take from the bodies behind these
                    [] => twin.y = kept,
                    [_] => {}
                    [late, ..] => {
                        F::add(&mut left, &late.slots[0], &behind);
                        late.y = left;
                    }
                }
                left = rows::<F, B, N>(&places, s).map(|s| -s);
                F::add(&mut left, &twin.slots[1], &behind);
            }
            for (lane, place) in places.iter().enumerate() {
                x[place.bodies[1] as usize] = behind.map(|x| x.lanes()[lane]);
                if ENDS || !late.is_empty() {
                    place.rows.put::<F, B, N, BEGINS>(&kept.map(|y| y.lanes()[lane]), s);
                }
            }
            if is_tested(i) {
                y = y.map(|y| y.or_zero_below(self.negligible));
            }
            (behind, scale) = (before, root);
        }
        if ENDS {
            behind = scaled(behind, &scale);
        } else if let [first, _, ..] = &mut self.twins[..] {
            F::add(&mut left, &first.slots[0], &behind);
            first.y = left;
        }
        for (lane, Place { bodies: [before, of_first], .. }) in places.iter().enumerate() {
            // one that holds a body alone has none before it
            if before != of_first {
                x[*before as usize] = behind.map(|x| x.lanes()[lane]);
            }
        }
    }

    /// The rest of what [`Self::backward`] leaves of the rows in y, once all bodies have lost what they lose.
    pub(super) fn leave<F: Form<B, N>>(&mut self, x: &[OfBody], s: &mut [f64]) {
        let Some(Twin { slots, y, places, .. }) = self.twins.last_mut() else { return };
        let mut left = rows::<F, B, N>(places, s).map(|s| -s);
        for (side, slot) in slots.iter().enumerate() {
            F::add(&mut left, slot, &gathered(x, places, side));
        }
        for (lane, place) in places.iter().enumerate() {
            place.rows.put::<F, B, N, true>(&y.map(|y| y.lanes()[lane]), s);
        }
        *y = left;
    }
}
