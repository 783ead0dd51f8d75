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
use std::ops::Range;
use std::panic::{RefUnwindSafe, UnwindSafe};
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
    pub fn info(
        &self,
        fixed: &SceneInfo,
        counts: &[usize],
        fill: impl Fn(&mut Layout) + Send + Sync + UnwindSafe + RefUnwindSafe + 'static,
    ) -> Arc<SceneInfo> {
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
        let mut counted = Layout { fault: empty.or(large), ..Layout::default() };
        if counted.fault.is_none() {
            fill(&mut counted);
        }
        // freed before the memory is looked at
        held.last = None;
        held.by_counts.retain(|_, info| info.strong_count() > 0);
        let fault = counted.fault.or_else(|| memory_fault(counted.n_members));
        let is_short_of_memory = matches!(fault, Some(LayoutFault::Memory { .. }));
        let mut layout = Layout { pass: Pass::Pattern, fault, ..Layout::default() };
        if layout.fault.is_none() {
            fill(&mut layout);
        }
        let info = Arc::new(layout.finish(fixed, counts, Arc::new(fill)));
        // memory may be there the next time
        if !is_short_of_memory {
            held.by_counts.insert(counts.to_vec(), Arc::downgrade(&info));
            held.last = Some(Arc::clone(&info));
        }
        info
    }
}

/// Bytes that a body or a member of a `for` needs in a run: 750 in a chain of 100,000 rods, 1,200 in a net of 10,000 knots. Names come on
/// top where somebody reads them, as much again in a chain.
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
    pass: Pass,
    /// Bodies and members of `for` so far.
    n_members: usize,
    bodies: Items<Name>,
    coordinates: Items<CoordinateInfo>,
    velocities: Items<CoordinateInfo>,
    points: Items<PointInfo>,
    outputs: Items<OutputInfo>,
    position_rows: Items<RowInfo>,
    velocity_rows: Items<RowInfo>,
    position_columns: Columns,
    velocity_columns: Columns,
    /// Constants of members.
    n_constants: usize,
    fault: Option<LayoutFault>,
}

/// What the loops are gone through for.
#[derive(Debug, Default, Clone, Copy, PartialEq, Eq)]
enum Pass {
    /// Members are counted, and indices checked.
    #[default]
    Members,
    /// Items are counted, and the pattern of the Jacobian is made.
    Pattern,
    /// The items that are wanted are made.
    Items,
}

/// Items of one list, of which those at some places are made.
#[derive(Debug)]
struct Items<T> {
    /// Those so far.
    n: usize,
    wanted: Range<usize>,
    made: Vec<T>,
}

impl<T> Default for Items<T> {
    fn default() -> Self {
        Self::of(0..0)
    }
}

impl<T> Items<T> {
    fn of(wanted: Range<usize>) -> Self {
        Self { n: 0, made: Vec::with_capacity(wanted.len()), wanted }
    }

    fn push(&mut self, make: impl FnOnce() -> T) {
        if self.wanted.contains(&self.n) {
            self.made.push(make());
        }
        self.n += 1;
    }
}

/// The columns of rows of G.
#[derive(Debug, Default)]
struct Columns {
    /// End of each row in `columns`.
    ends: Vec<u32>,
    columns: Vec<u32>,
}

/// The loops of a scene with these counts.
type Fill = Arc<dyn Fn(&mut Layout) + Send + Sync + UnwindSafe + RefUnwindSafe>;

impl Layout {
    /// Adds a body, or an array of bodies whose members are ordered by their indices, the last one fastest.
    pub fn bodies<'l>(&mut self, name: &'static str, lengths: &'l [usize]) -> Bodies<'l> {
        let first = self.bodies.n;
        let n_members = lengths.iter().fold(1, |n: usize, length| n.saturating_mul(*length));
        if self.has_room(n_members) {
            for i in 0..n_members {
                self.push_body(name, lengths, i);
            }
        }
        Bodies { name, first, lengths }
    }

    /// The indices of a `for`; none once the description is faulty.
    pub fn range(&mut self, from: i64, to: i64) -> Range<i64> {
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

    fn push_body(&mut self, name: &str, lengths: &[usize], i: usize) {
        let named = |component: &str| {
            let mut index = vec![0; lengths.len()];
            let mut rest = i;
            for (index, length) in index.iter_mut().zip(lengths).rev() {
                *index = (rest % length) as i64;
                rest /= length;
            }
            member(name, &index, component)
        };
        let info = |c: &Component| CoordinateInfo { name: named(&[".", c.name].concat()), unit: c.unit, symbol: None };
        self.bodies.push(|| named(""));
        BodyKind::Planar.positions().iter().for_each(|c| self.coordinates.push(|| info(c)));
        BodyKind::Planar.velocities().iter().for_each(|c| self.velocities.push(|| info(c)));
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
        if self.fault.is_some() || self.pass == Pass::Members {
            return;
        }
        for row in template.rows {
            let (rows, columns) = match row.position {
                true => (&mut self.position_rows, &mut self.position_columns),
                false => (&mut self.velocity_rows, &mut self.velocity_columns),
            };
            rows.push(|| RowInfo { name: member(template.name, at, row.suffix), ..row.row.clone() });
            if self.pass == Pass::Pattern {
                let places = row.entries.iter().map(|place| place_of(slots[place.slot], place.component) as u32);
                columns.columns.extend(places);
                columns.ends.push(columns.columns.len() as u32);
            }
        }
    }

    /// A named point on a body; `None`: on the ground.
    pub fn point(&mut self, name: &str, at: &[i64], body: Option<usize>) {
        self.points.push(|| PointInfo { name: member(name, at, ""), body, position: None });
    }

    /// An output; what stands behind its indices is `suffix`.
    pub fn output(&mut self, output: &OutputInfo, at: &[i64], suffix: &str) {
        self.outputs.push(|| OutputInfo { name: member(&output.name, at, suffix), ..output.clone() });
    }

    /// Counts the constants that members have besides those of the scene. Asks where they stand in `c`, the end last, only where
    /// the sizes are sound.
    pub fn constants<const N: usize>(&mut self, places: impl FnOnce() -> [usize; N]) {
        if self.fault.is_none() && self.pass == Pass::Pattern {
            let places = places();
            self.n_constants = places[N - 1] - places[0];
        }
    }

    fn finish(self, fixed: &SceneInfo, counts: &[usize], fill: Fill) -> SceneInfo {
        let (position, velocity) = (self.position_columns, self.velocity_columns);
        let n_position_entries = position.columns.len() as u32;
        let mut starts = Vec::with_capacity(1 + position.ends.len() + velocity.ends.len());
        starts.push(0);
        starts.extend(position.ends);
        starts.extend(velocity.ends.iter().map(|end| n_position_entries + end));
        let mut columns = position.columns;
        columns.extend(velocity.columns);
        columns.shrink_to_fit();
        let repeats = fixed.repeats.clone();
        SceneInfo {
            bodies: list(&self.bodies, &fill, |layout| &mut layout.bodies),
            coordinates: list(&self.coordinates, &fill, |layout| &mut layout.coordinates),
            velocities: list(&self.velocities, &fill, |layout| &mut layout.velocities),
            points: list(&self.points, &fill, |layout| &mut layout.points),
            outputs: list(&self.outputs, &fill, |layout| &mut layout.outputs),
            n_constants: fixed.n_constants + self.n_constants,
            n_position_rows: self.position_rows.n,
            rows: list_of_rows([self.position_rows.n, self.velocity_rows.n], fill),
            jacobian: SparsityPattern::of(starts, columns),
            repeats: repeats.map(|repeats| Repeats { values: counts.to_vec().into(), fault: self.fault, ..repeats }),
            ..fixed.clone()
        }
    }
}

fn list<T>(all: &Items<T>, fill: &Fill, of: fn(&mut Layout) -> &mut Items<T>) -> List<T> {
    let fill = Arc::clone(fill);
    List::counted(all.n, move |places| {
        let mut layout = Layout { pass: Pass::Items, ..Layout::default() };
        *of(&mut layout) = Items::of(places);
        fill(&mut layout);
        std::mem::take(of(&mut layout)).made
    })
}

/// Position constraints first.
fn list_of_rows([n_position, n_velocity]: [usize; 2], fill: Fill) -> List<RowInfo> {
    List::counted(n_position + n_velocity, move |places| {
        let position_rows = Items::of(places.start.min(n_position)..places.end.min(n_position));
        let velocity_rows =
            Items::of(places.start.max(n_position) - n_position..places.end.max(n_position) - n_position);
        let mut layout = Layout { pass: Pass::Items, position_rows, velocity_rows, ..Layout::default() };
        fill(&mut layout);
        let mut rows = layout.position_rows.made;
        rows.append(&mut layout.velocity_rows.made);
        rows
    })
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
    use crate::integrate::Method;
    use crate::model::Scene as _;
    use crate::simulate::Simulation;

    #[test]
    fn analytic_members_that_memory_does_not_hold_are_refused_with_the_figure() {
        assert_eq!(memory_fault(1_000), None);
        let (n_members, needed, available) = (3_000_000, 3_600_000_000, 2_000_000_000);
        let fault = LayoutFault::Memory { n_members, needed, available }.to_string();
        assert!(fault.contains("need about 3.6 GB; the machine has 2.0 GB left: give a smaller count"), "{fault}");
        #[cfg(target_os = "linux")]
        assert!(matches!(memory_fault(usize::MAX >> 20), Some(LayoutFault::Memory { .. })));
    }

    crate::model! {
        /// Rods in a row, each with a wheel.
        pub model Row {
            count n = 3;
            body rod[n] { mass: 1, inertia: 1 }
            hinge top: ground(0, 0) ~ rod[0](-0.5, 0);
            for i in 1..n { hinge pin[i]: rod[i-1](0.5, 0) ~ rod[i](-0.5, 0); }
            for i in 0..n { skate wheel[i]: at rod[i](0, 0) along rod[i](1, 0); }
            for i in 0..n { point tip[i] = rod[i](0.5, 0); }
            for i in 0..n { output height[i] = rod[i].y; }
            start level { for i in 0..n { rod[i] angle 0; } at rest; }
            scene rolls { start level; until 1 s; }
        }
    }

    /// Each item alone, then all of them.
    fn one_by_one<T: Clone + PartialEq + std::fmt::Debug>(list: &List<T>) {
        let alone: Vec<T> = (0..list.len()).map(|i| list.item(i)).collect();
        assert!(!list.is_made());
        assert_eq!((list.range(1..list.len()), alone), (list[1..].to_vec(), list.to_vec()));
    }

    #[test]
    fn invariant_items_are_the_same_alone_and_in_their_list() {
        let info = row::Rolls { n: 4 }.info();
        assert_eq!([info.bodies.len(), info.rows.len(), info.points.len(), info.outputs.len()], [4, 12, 8, 4]);
        one_by_one(&info.bodies);
        one_by_one(&info.coordinates);
        one_by_one(&info.velocities);
        one_by_one(&info.points);
        one_by_one(&info.rows);
        one_by_one(&info.outputs);
        let names = [&info.rows[0].name, &info.rows[7].name, &info.rows[8].name, &info.coordinates[11].name];
        assert_eq!(names, ["top.x", "pin[3].y", "wheel[0]", "rod[3].phi"]);
    }

    #[test]
    fn regress_lists_of_scenes_that_cannot_be_set_up_are_empty() {
        for n in [0, 1 << 40, usize::MAX >> 1] {
            let info = row::Rolls { n }.info();
            assert!(info.check_counts().is_err() && info.bodies.is_empty(), "{n}");
            assert_eq!([info.bodies.iter().count(), info.rows.iter().count(), info.coordinates.iter().count()], [0; 3]);
        }
    }

    /// A run looks at names of one row at a time, also where its start gives way.
    #[test]
    fn invariant_a_run_makes_no_lists() {
        let scene = row::Rolls { n: 7 };
        let order = Simulation::new(&scene).method(Method::rk4(1e-3)).until(2e-3);
        // a place that the hinge at the top contradicts
        let run = order.start("rod[0].x", 0.4).project_start().run().unwrap();
        assert!(run.outcome.reached_end() && !run.moved.is_empty());
        let monitors = run.monitors.velocity_residual.map(|peak| peak.row);
        assert!(monitors.is_some());
        let info = scene.info();
        assert!(!info.rows.is_made() && !info.bodies.is_made() && !info.points.is_made() && !info.outputs.is_made());
    }
}
