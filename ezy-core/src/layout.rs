//! Descriptions of scenes with counts, made at run time by the loops that generated code runs.
//!
//! A description is shared by all who hold it, and freed when nobody does and another one was asked for.

use crate::memory;
use crate::model::coordinate::place as place_of;
use crate::model::{
    BodyKind, Component, CoordinateInfo, LARGEST_COUNT, LARGEST_N_MEMBERS, LayoutFault, List, Name, OutputInfo,
    PointInfo, Repeats, RowInfo, SceneInfo, SparsityPattern, TemplateInfo,
};
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::fmt::Write;
use std::sync::{Arc, Mutex, PoisonError, Weak};

/// The descriptions of one scene that somebody holds, by counts, and the one that was asked for last.
#[derive(Debug, Default)]
pub struct Known(Mutex<Held>);

#[derive(Debug, Default)]
struct Held {
    by_counts: BTreeMap<Vec<usize>, Weak<SceneInfo>>,
    /// So that one question after the other about a scene makes one description.
    last: Option<Arc<SceneInfo>>,
}

impl Known {
    /// None yet.
    pub const fn new() -> Self {
        Self(Mutex::new(Held { by_counts: BTreeMap::new(), last: None }))
    }

    /// The description for these counts. `fixed` is what does not depend on them, its `repeats` with the declared
    /// counts and templates; `fill` adds bodies, points and rows.
    pub fn info(&self, fixed: &SceneInfo, counts: &[usize], fill: impl Fn(&mut Layout)) -> Arc<SceneInfo> {
        let mut held = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(info) = held.by_counts.get(counts).and_then(Weak::upgrade) {
            held.last = Some(Arc::clone(&info));
            return info;
        }
        let empty = counts.iter().zip(fixed.counts()).find(|(count, _)| **count == 0);
        let empty = empty.map(|(_, count)| LayoutFault::NoMembers { name: count.name });
        let large = counts.iter().zip(fixed.counts()).find(|(count, _)| **count > LARGEST_COUNT);
        let large = large.map(|(&count, of)| LayoutFault::LargeCount { name: of.name, count });
        // what cannot be set up is found before anything is
        let mut counted = Layout { counts_only: true, fault: empty.or(large), ..Layout::default() };
        if counted.fault.is_none() {
            fill(&mut counted);
        }
        // freed before the memory is looked at
        held.last = None;
        held.by_counts.retain(|_, info| info.strong_count() > 0);
        let fault = counted.fault.or_else(|| memory_fault(counted.n_members));
        let is_short_of_memory = matches!(fault, Some(LayoutFault::Memory { .. }));
        let mut layout = Layout { fault, ..Layout::default() };
        if layout.fault.is_none() {
            fill(&mut layout);
        }
        let info = Arc::new(layout.finish(fixed, counts));
        // memory may be there the next time
        if !is_short_of_memory {
            held.by_counts.insert(counts.to_vec(), Arc::downgrade(&info));
            held.last = Some(Arc::clone(&info));
        }
        info
    }
}

/// Bytes that a body or a member of a `for` needs in a run: half of it is its description, the rest is the state, rows and
/// factors. Measured in chains of 10,000 and 100,000 rods and nets of 10,000 knots: 900 to 1,200.
const BYTES_OF_A_MEMBER: u64 = 1_200;

/// Refuses members that need more memory than there is.
fn memory_fault(n_members: usize) -> Option<LayoutFault> {
    let needed = n_members as u64 * BYTES_OF_A_MEMBER;
    memory::too_little_for(needed).map(|available| LayoutFault::Memory { n_members, needed, available })
}

/// An array of bodies, or a single body.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Bodies<'l> {
    /// Name of the array.
    pub name: &'static str,
    /// Index of its first member among all bodies.
    pub first: usize,
    /// Its number of members along each of its indices; none for a single body.
    pub lengths: &'l [usize],
}

/// A description that is being made.
#[derive(Debug, Default)]
pub struct Layout {
    /// Whether only members are counted and indices checked.
    counts_only: bool,
    /// Bodies and members of `for` so far.
    n_members: usize,
    n_bodies: usize,
    bodies: Vec<Name>,
    coordinates: Vec<CoordinateInfo>,
    velocities: Vec<CoordinateInfo>,
    points: Vec<PointInfo>,
    outputs: Vec<OutputInfo>,
    position_rows: Rows,
    velocity_rows: Rows,
    /// Constants of members.
    n_constants: usize,
    fault: Option<LayoutFault>,
}

#[derive(Debug, Default)]
struct Rows {
    rows: Vec<RowInfo>,
    /// End of each row in `columns`.
    ends: Vec<usize>,
    columns: Vec<usize>,
}

impl Layout {
    /// Adds a body, or an array of bodies whose members are ordered by their indices, the last one fastest.
    pub fn bodies<'l>(&mut self, name: &'static str, lengths: &'l [usize]) -> Bodies<'l> {
        let first = self.n_bodies;
        let n_members = lengths.iter().fold(1, |n: usize, length| n.saturating_mul(*length));
        let has_room = self.has_room(n_members);
        self.n_bodies = self.n_bodies.saturating_add(n_members);
        if has_room && !self.counts_only {
            for i in 0..n_members {
                let mut index = vec![0; lengths.len()];
                let mut rest = i;
                for (index, length) in index.iter_mut().zip(lengths).rev() {
                    *index = (rest % length) as i64;
                    rest /= length;
                }
                self.push_body(member(name, &index, ""));
            }
        }
        Bodies { name, first, lengths }
    }

    /// The indices of a `for`; none once the description is faulty.
    pub fn range(&mut self, from: i64, to: i64) -> std::ops::Range<i64> {
        let length = usize::try_from(to.saturating_sub(from)).unwrap_or(0);
        if self.has_room(length) { from..to } else { 0..0 }
    }

    fn has_room(&mut self, more: usize) -> bool {
        self.n_members = self.n_members.saturating_add(more);
        if self.n_members > LARGEST_N_MEMBERS {
            self.fault.get_or_insert(LayoutFault::TooManyMembers { n_members: self.n_members });
        }
        self.fault.is_none()
    }

    fn push_body(&mut self, name: Name) {
        let of = |component: &str| Cow::Owned([&name, ".", component].concat());
        let of_planar = [
            (&mut self.coordinates, BodyKind::Planar.positions()),
            (&mut self.velocities, BodyKind::Planar.velocities()),
        ];
        for (infos, components) in of_planar {
            let named = |c: &Component| CoordinateInfo { name: of(c.name), unit: c.unit, symbol: None };
            infos.extend(components.iter().map(named));
        }
        self.bodies.push(name);
    }

    /// Index among all bodies of a member of an array, which the item `template` with the indices `at` uses. A member
    /// that does not exist is a fault of the description, and stands for the first body.
    pub fn member(&mut self, template: &TemplateInfo, at: &[i64], array: Bodies<'_>, index: &[i64]) -> usize {
        let mut place = 0;
        for (&index, &length) in index.iter().zip(array.lengths) {
            match usize::try_from(index) {
                Ok(i) if i < length => place = place * length + i,
                _ => {
                    if self.fault.is_none() {
                        let item = item_name(template, at);
                        self.fault = Some(LayoutFault::IndexOutOfRange { item, array: array.name, index, length });
                    }
                    return 0;
                }
            }
        }
        array.first + place
    }

    /// The rows of the member `at` of a template, on the bodies `slots` that it refers to.
    pub fn rows(&mut self, template: &TemplateInfo, at: &[i64], slots: &[usize]) {
        if self.fault.is_some() || self.counts_only {
            return;
        }
        for row in template.rows {
            let name = member(template.name, at, row.suffix);
            let rows = if row.position { &mut self.position_rows } else { &mut self.velocity_rows };
            rows.columns.extend(row.entries.iter().map(|place| place_of(slots[place.slot], place.component)));
            rows.ends.push(rows.columns.len());
            rows.rows.push(RowInfo { name, ..row.row.clone() });
        }
    }

    /// A named point on a body; `None`: on the ground.
    pub fn point(&mut self, name: &str, at: &[i64], body: Option<usize>) {
        if !self.counts_only {
            self.points.push(PointInfo { name: member(name, at, ""), body, position: None });
        }
    }

    /// An output; what stands behind its indices is `suffix`.
    pub fn output(&mut self, output: &OutputInfo, at: &[i64], suffix: &str) {
        if !self.counts_only {
            self.outputs.push(OutputInfo { name: member(&output.name, at, suffix), ..output.clone() });
        }
    }

    /// Counts the constants that members have besides those of the scene. Asks where they stand in `c`, the end last, only where
    /// the sizes are sound.
    pub fn constants<const N: usize>(&mut self, places: impl FnOnce() -> [usize; N]) {
        if self.fault.is_none() && !self.counts_only {
            let places = places();
            self.n_constants = places[N - 1] - places[0];
        }
    }

    fn finish(self, fixed: &SceneInfo, counts: &[usize]) -> SceneInfo {
        let (position, velocity) = (self.position_rows, self.velocity_rows);
        let n_position_entries = position.columns.len();
        let ends = position.ends.iter().copied().chain(velocity.ends.iter().map(|end| n_position_entries + end));
        let starts = std::iter::once(0).chain(ends).collect();
        let repeats = fixed.repeats.clone();
        SceneInfo {
            bodies: list(self.bodies),
            coordinates: list(self.coordinates),
            velocities: list(self.velocities),
            points: list(self.points),
            outputs: list(self.outputs),
            n_constants: fixed.n_constants + self.n_constants,
            n_position_rows: position.rows.len(),
            rows: both(position.rows, velocity.rows),
            jacobian: SparsityPattern { starts: list(starts), columns: both(position.columns, velocity.columns) },
            repeats: repeats.map(|repeats| Repeats { values: list(counts.to_vec()), fault: self.fault, ..repeats }),
            ..fixed.clone()
        }
    }
}

/// A list that holds no more memory than it needs.
fn list<T: Clone>(mut items: Vec<T>) -> List<T> {
    items.shrink_to_fit();
    Cow::Owned(items)
}

fn both<T: Clone>(mut first: Vec<T>, second: Vec<T>) -> List<T> {
    first.extend(second);
    list(first)
}

/// Characters of an index with the bracket or comma before it: those of `i64::MIN` and one.
const LONGEST_INDEX: usize = 21;

/// `pin[3].x`, or `node[2,3]`; without brackets when there is no index.
pub fn member(name: &str, at: &[i64], suffix: &str) -> Name {
    let mut text = String::with_capacity(name.len() + suffix.len() + at.len() * LONGEST_INDEX + 1);
    text.push_str(name);
    for (i, index) in at.iter().enumerate() {
        // writing to a string cannot fail
        let _ = write!(text, "{}{index}", if i == 0 { '[' } else { ',' });
    }
    if !at.is_empty() {
        text.push(']');
    }
    text.push_str(suffix);
    text.shrink_to_fit();
    Cow::Owned(text)
}

/// How a message calls a member of a template: hinge `pin[3]`, or force at i = 3.
fn item_name(template: &TemplateInfo, at: &[i64]) -> String {
    let word = template.word;
    if !template.name.is_empty() {
        return format!("{word} `{}`", member(template.name, at, ""));
    }
    let indices = template.ranges.iter().zip(at).map(|(range, i)| {
        let variable = range.split(" in ").next().unwrap_or_default();
        format!("{variable} = {i}")
    });
    let place = indices.collect::<Vec<_>>().join(", ");
    if place.is_empty() { format!("a `{word}`") } else { format!("the `{word}` at {place}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_members_that_memory_does_not_hold_are_refused_with_the_figure() {
        assert_eq!(memory_fault(1_000), None);
        let (n_members, needed, available) = (3_000_000, 3_600_000_000, 2_000_000_000);
        let fault = LayoutFault::Memory { n_members, needed, available }.to_string();
        assert!(fault.contains("need about 3.6 GB; the machine has 2.0 GB left: give a smaller count"), "{fault}");
        #[cfg(target_os = "linux")]
        assert!(matches!(memory_fault(usize::MAX >> 20), Some(LayoutFault::Memory { .. })));
    }
}
