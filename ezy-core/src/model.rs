//! What a generated scene implements. No solver type appears here.
//!
//! Signs, symbols and units: `docs/notation.md`. A scene is immutable while it runs: its parameters are
//! fields, and everything that depends on parameters alone is computed once ([`Equations::constants`]). Kernels read a
//! vector `c` of numbers that do not change within a step: the `n_i` *inputs*, which the caller sets, then the *constants*.
//!
//! Shapes: `n_q` coordinates, `n_h` position constraints, `n_c` rows in all (position constraints first), `n_e` effects,
//! `n_p` points, `n_i` inputs, `n_o` outputs, `n_s` events. Kernels panic when a slice has another length; the layers above always
//! pass the right ones.

pub(crate) mod body_kind;
pub(crate) mod coordinate;
mod derived;
mod element;
pub(crate) mod equations;
mod event;
pub(crate) mod in_lanes;
mod member;
mod named;
pub(crate) mod named_bodies;
pub(crate) mod named_outputs;
pub(crate) mod pivots;
pub(crate) mod repeats;
pub(crate) mod series;
#[cfg(feature = "analysis")]
pub(crate) mod with_derivatives;

pub use body_kind::{BodyKind, Component};
pub use derived::{Derived, JacobianPlaces};
pub use element::{ElementInfo, LoadKind, LocalVector};
pub use equations::Equations;
pub(crate) use equations::PreciseScene;
pub use event::{Direction, EventInfo, EventKind, StickSlipInfo, StopInfo};
#[cfg(feature = "sweep")]
pub(crate) use in_lanes::N_LANES;
pub(crate) use in_lanes::{Eight, EquationsInLanes};
pub use member::ArrayIndex;
pub use named::{NamedInputs, NamedScene, NoInputs, NoOutputs};
pub use named_bodies::{BodyArray, BodyState};
pub use named_outputs::{OutputArray, Vector};
#[cfg(feature = "sparse")]
pub(crate) use pivots::PIVOT_TOLERANCE;
pub(crate) use pivots::Pivots;
pub(crate) use repeats::LARGEST_N_MEMBERS;
pub use repeats::{CountInfo, LayoutFault};
pub(crate) use repeats::{Repeats, TemplateInfo};
pub use series::SeriesInfo;
pub(crate) use series::{PRODUCT_GROUP, Series, SeriesStore};
use std::borrow::Cow;
use std::ops::Deref;
use std::sync::Arc;
#[cfg(feature = "analysis")]
pub(crate) use with_derivatives::N_DERIVATIVES;
#[cfg(feature = "analysis")]
pub use with_derivatives::{Derivatives, EquationsWithDerivatives};

/// A name: text of the program, or made at run time for a member of an array. It prints as text and compares with `"x"`.
pub type Name = Cow<'static, str>;

/// A list of a description: data of the program, or made at run time for a scene with counts.
pub type List<T> = Cow<'static, [T]>;

/// The three renderings of one expression, all printed from the expression that is compiled.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Formula {
    /// Plain text, in the names of the model file: `seat.x + b*cos(seat.phi)`.
    pub text: &'static str,
    /// LaTeX, without delimiters.
    pub latex: &'static str,
    /// MathML, one `<mrow>` element.
    pub mathml: &'static str,
}

/// One equation of a scene in the three renderings.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Equation {
    /// What it is, in words: `position constraint`.
    pub name: &'static str,
    /// Plain text, several aligned lines.
    pub text: &'static str,
    /// LaTeX, to stand in display mode.
    pub latex: &'static str,
    /// A `<math>` element.
    pub mathml: &'static str,
}

/// A coordinate or a velocity.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CoordinateInfo {
    /// `body.x`, `body.phi`; `body.vx`, `body.omega`.
    pub name: Name,
    /// Unit: `m` or `rad`; `m/s` or `rad/s`.
    pub unit: &'static str,
    /// How it is printed in equations; `None` in a scene with counts.
    pub symbol: Option<Formula>,
}

impl CoordinateInfo {
    /// Whether it is an angle, or the rate of one.
    pub(crate) fn is_angle(&self) -> bool {
        matches!(self.unit, "rad" | "rad/s")
    }

    /// Whether it is a length, or the rate of one.
    pub(crate) fn is_length(&self) -> bool {
        matches!(self.unit, "m" | "m/s")
    }
}

/// A constraint row.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RowInfo {
    /// `B.x`, `rear`, …
    pub name: Name,
    /// The word that declared it: `hinge`, `skate`, …
    pub kind: &'static str,
    /// Unit of the row's multiplier: `N` or `N*m`.
    pub multiplier_unit: &'static str,
    /// Position constraints: C, with C = 0. Velocity constraints: S v + s_t, with S v + s_t = 0.
    pub constraint: Formula,
    /// h of a position constraint, s of a velocity constraint.
    pub convective_term: Formula,
}

/// A parameter or an input of a scene.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ParameterInfo {
    /// Name in the model file; of a parameter that of the field, too.
    pub name: &'static str,
    /// Unit as written, empty when none was declared; values are in this unit.
    pub unit: &'static str,
    /// Declared value.
    pub default: f64,
    /// Declared value as written.
    pub default_text: &'static str,
    /// Doc comment of the declaration.
    pub documentation: &'static str,
    /// The effect that declares it; `None` when the model itself does.
    pub effect: Option<&'static str>,
    /// How it is printed in equations.
    pub symbol: Formula,
}

/// A number that the caller sets during a run: by a controller, a table or a learning program. It has the declared value
/// until it is set.
pub type InputInfo = ParameterInfo;

/// A number with a rate of its own, such as a current: a first-order state z, which a run integrates beside the motion. Its default is the
/// value at the start.
pub type StateInfo = ParameterInfo;

/// A number that a scene computes from its state on request.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct OutputInfo {
    /// Name in the model file; a vector `p` is two outputs, `p.x` and `p.y`.
    pub name: Name,
    /// Unit as written, empty when none was declared.
    pub unit: &'static str,
    /// Doc comment of the declaration.
    pub documentation: &'static str,
    /// What it is, in terms of the state.
    pub formula: Formula,
}

/// A named point.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PointInfo {
    /// Name in the model file; a hinge is a point too.
    pub name: Name,
    /// Index of the body that carries it; `None` for the ground.
    pub body: Option<usize>,
    /// Where it is: x, y; `None` in a scene with counts.
    pub position: Option<[Formula; 2]>,
}

/// An effect that the scene calls for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct EffectInfo {
    /// Name in the model file.
    pub name: &'static str,
    /// Doc comment of the declaration.
    pub documentation: &'static str,
}

/// Sparsity pattern of a matrix by rows: the columns of row `i` are `columns[starts[i]..starts[i + 1]]`. In scenes with
/// counts they may come in any order and more than once; entries with the same row and column are added.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SparsityPattern {
    /// `n_rows + 1` offsets into `columns`.
    pub starts: List<usize>,
    /// Column of each stored entry.
    pub columns: List<usize>,
}

impl SparsityPattern {
    /// Of data of the program.
    pub const fn new(starts: &'static [usize], columns: &'static [usize]) -> Self {
        Self { starts: List::Borrowed(starts), columns: List::Borrowed(columns) }
    }

    /// Number of rows.
    pub(crate) fn n_rows(&self) -> usize {
        self.starts.len() - 1
    }

    /// Number of stored entries.
    pub fn n_nonzeros(&self) -> usize {
        self.columns.len()
    }

    /// The stored entries in order, as (index of the value, row, column).
    pub fn entries(&self) -> impl Iterator<Item = (usize, usize, usize)> + '_ {
        let (starts, columns) = (&*self.starts, &*self.columns);
        (0..self.n_rows()).flat_map(move |i| (starts[i]..starts[i + 1]).map(move |k| (k, i, columns[k])))
    }
}

/// A symbol for a long expression that occurs in others.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Abbreviation {
    /// `u1`
    pub symbol: Formula,
    /// What it stands for.
    pub formula: Formula,
}

/// Operations of one evaluation of a kernel, as emitted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Operations {
    /// Additions, subtractions and sign changes.
    pub add: usize,
    /// Multiplications.
    pub mul: usize,
    /// Divisions.
    pub div: usize,
    /// Sine–cosine pairs (a lone sine or cosine counts as one).
    pub trig: usize,
    /// Calls of other functions.
    pub calls: usize,
}

impl Operations {
    /// `add + mul + div`: trigonometry and other calls are counted apart.
    pub const fn arithmetic(&self) -> usize {
        self.add + self.mul + self.div
    }
}

/// One step of the generated elimination.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct EliminationStep {
    /// The rows that are eliminated together (indices into [`SceneInfo::rows`]).
    pub rows: &'static [usize],
    /// Whether the pivot depends on parameters alone, so that it is computed once.
    pub constant_pivot: bool,
}

/// Everything about a scene that does not depend on parameters: known at compile time or, for a scene with counts, made
/// when it is used with these counts.
#[derive(Debug, Clone)]
pub struct SceneInfo {
    /// Name of the model type, as written: `EzyRoller`.
    pub model: &'static str,
    /// Name of the scene, as written: `driven`.
    pub name: &'static str,
    /// Doc comment of the scene.
    pub documentation: &'static str,
    /// Hash of the words of the model file, without comments and documentation (FNV-1a, 64 bits); 0 of a scene written by hand.
    pub fingerprint: u64,
    /// Bodies in declared order; planar body `i` has the coordinates x, y and φ at `3 i`, `3 i + 1`, `3 i + 2`.
    pub bodies: List<Name>,
    /// The kind of each body; none where all are planar, as in every scene that `model!` generates.
    pub kinds: List<BodyKind>,
    /// `n_q` coordinates.
    pub coordinates: List<CoordinateInfo>,
    /// `n_v` velocities; in a scene of planar bodies those of the coordinates.
    pub velocities: List<CoordinateInfo>,
    /// `n_p` named points; a hinge is listed by its point on the first body.
    pub points: List<PointInfo>,
    /// `n_c` rows, position constraints first.
    pub rows: List<RowInfo>,
    /// `n_h`, the number of position constraints.
    pub n_position_rows: usize,
    /// Parameters of the model and of the scene's effects.
    pub parameters: &'static [ParameterInfo],
    /// `n_i` inputs of the model and of the scene's effects.
    pub inputs: &'static [InputInfo],
    /// Places of the inputs that a run integrates (`by acceleration`). Behind each stand its rate, its acceleration, and the time of value
    /// and rate, as inputs of their own.
    pub integrated_inputs: &'static [usize],
    /// `n_z` first-order states of the model and of the scene's effects.
    pub states: &'static [StateInfo],
    /// `n_o` outputs of the model and of the scene's effects.
    pub outputs: List<OutputInfo>,
    /// `n_s` events of the model and of the scene's effects, then the conditions that end this scene, then the discontinuities of
    /// its forces; a scene with counts does not know its discontinuities.
    pub events: &'static [EventInfo],
    /// The skate with a limit (stick–slip friction), if there is one.
    pub stick_slip: Option<&'static StickSlipInfo>,
    /// The stop (unilateral contact), if there is one.
    pub stop: Option<&'static StopInfo>,
    /// Numbers that say which row of these holds, as they are at the start: 1 while it holds, else 0; then its side: 1 for a skate that
    /// slides to the left and for the lower end of a stop, -1 to the right and for the upper end. None without such a row.
    pub switches: &'static [f64],
    /// `n_e` groups of forces that do work: those outside any effect come first, under the name `model`, when there are
    /// some; then the effects; then the constraints that move with time, under the name `drives`, when there are some; last
    /// the impacts on the stop, under the name `stops`, where there is one.
    pub effects: &'static [EffectInfo],
    /// End of the run that the scene declares, s.
    pub until_s: f64,
    /// Numbers that depend on parameters alone, and on counts and indices where there are some; they follow inputs and first-order states in `c`.
    pub n_constants: usize,
    /// Pattern of G = [C_q; S], `n_c × n_v`; of C_q along the velocities where q' ≠ v.
    pub jacobian: SparsityPattern,
    /// Entries of G in the order of [`SceneInfo::jacobian`].
    pub jacobian_entries: &'static [Formula],
    /// Diagonal of M.
    pub mass_entries: &'static [Formula],
    /// F.
    pub force_entries: &'static [Formula],
    /// V: 0 where no force has a potential.
    pub potential_energy: Formula,
    /// Definitions of the symbols in these formulas, besides coordinates, parameters and inputs.
    pub abbreviations: &'static [Abbreviation],
    /// All of this as equations, from the coordinates to the equations of motion; of a scene with counts these alone: its
    /// items have their own.
    pub equations: &'static [Equation],
    /// Order in which the generated elimination takes the rows; empty without one.
    pub elimination: &'static [EliminationStep],
    /// Operations of [`Equations::accelerations`].
    pub acceleration_operations: Operations,
    /// Operations of [`Equations::correction`].
    pub correction_operations: Operations,
    /// The coordinates that accelerations and multipliers depend on, ascending; the others follow from the motion without any influence on it,
    /// such as the place of a vehicle on a plane. `None` where that is not known.
    pub feedback: Option<&'static [usize]>,
    /// Whether there is a Taylor series ([`Derived::series`]).
    pub series: SeriesInfo,
    /// Additional data of a scene with counts; `None` for a scene whose sizes are known at compile time. A scene with
    /// counts has no generated elimination, its formulas are those of [`Repeats::templates`], and the lists of
    /// entries (Jacobian, masses, forces) are empty.
    pub repeats: Option<Repeats>,
}

/// What the switches of a skate say.
#[cfg(feature = "cli")]
const SWITCHES_OF_SKATE: [&str; 2] =
    ["1 while it holds, 0 while it slides", "1 while it slides to the left of its direction, -1 to the right, else 0"];
/// What those of a stop say.
#[cfg(feature = "cli")]
const SWITCHES_OF_STOP: [&str; 2] = ["1 while it holds, 0 while it is open", "1 at the lower end, -1 at the upper one"];

impl SceneInfo {
    /// Whether [`Equations::accelerations`] and [`Equations::correction`] solve: not in scenes with counts, nor where more
    /// than 24 rows meet in one body, for which rustc takes minutes.
    pub fn has_elimination(&self) -> bool {
        self.repeats.is_none() && (self.rows.is_empty() || !self.elimination.is_empty())
    }

    /// Names that equations have for [`SceneInfo::switches`], and what they say; without the side of a stop with one end, which nothing reads.
    #[cfg(feature = "cli")]
    pub(crate) fn switch_names(&self) -> Vec<(String, &'static str)> {
        let (name, said) = match (self.stick_slip, self.stop) {
            (Some(skate), _) => (skate.name, SWITCHES_OF_SKATE),
            (_, Some(stop)) => (stop.name, SWITCHES_OF_STOP),
            _ => return Vec::new(),
        };
        let n = if self.stop.is_some_and(|stop| stop.sides.len() == 1) { 1 } else { 2 };
        ["holds", "side"].iter().zip(said).take(n).map(|(suffix, said)| (format!("{name}_{suffix}"), said)).collect()
    }

    /// How many position constraints, and how many rows, hold at the start.
    #[cfg(feature = "cli")]
    pub(crate) fn n_rows_at_start(&self) -> [usize; 2] {
        let off = self.switched_row().filter(|_| self.switches.first() == Some(&0.0));
        [self.n_position_rows, self.n_rows()].map(|n| n - usize::from(off.is_some_and(|row| row < n)))
    }

    /// The row that [`SceneInfo::switches`] tell of.
    pub(crate) fn switched_row(&self) -> Option<usize> {
        self.stick_slip.map(|skate| skate.row).or(self.stop.map(|stop| stop.row))
    }

    /// The counts, in declared order.
    pub const fn counts(&self) -> &'static [CountInfo] {
        match &self.repeats {
            Some(repeats) => repeats.counts,
            None => &[],
        }
    }

    /// Number of unknowns of the equations of motion, n_v + n_c.
    #[inline]
    pub fn n_unknowns(&self) -> usize {
        self.velocities.len() + self.rows.len()
    }

    /// n_v.
    #[inline]
    pub fn n_velocities(&self) -> usize {
        self.velocities.len()
    }

    /// The bodies that pictures show: they are of the plane, and show none where a body moves in space.
    pub(crate) fn drawn_bodies(&self) -> &[Name] {
        if self.is_planar() { &self.bodies } else { &[] }
    }

    /// The places of each body in v.
    #[cfg(feature = "cli")]
    pub(crate) fn velocities_of_bodies(&self) -> impl Iterator<Item = std::ops::Range<usize>> + '_ {
        let mut first = 0;
        (0..self.bodies.len()).map(move |i| {
            let n = self.kinds.get(i).copied().unwrap_or_default().velocities().len();
            first += n;
            first - n..first
        })
    }

    /// Whether all bodies are planar, so that q' = v.
    #[inline]
    pub fn is_planar(&self) -> bool {
        self.kinds.is_empty()
    }

    /// n_q.
    #[inline]
    pub fn n_coordinates(&self) -> usize {
        self.coordinates.len()
    }

    /// n_c.
    #[inline]
    pub fn n_rows(&self) -> usize {
        self.rows.len()
    }

    /// n_e.
    pub const fn n_effects(&self) -> usize {
        self.effects.len()
    }

    /// n_i.
    pub const fn n_inputs(&self) -> usize {
        self.inputs.len()
    }

    /// Places of value, rate and time of the input at `first`, which a run integrates; between rate and time stands its acceleration.
    pub(crate) const fn integrated_places(first: usize) -> [usize; 3] {
        const SINCE: usize = 3;
        [first, first + 1, first + SINCE]
    }

    /// n_z.
    pub const fn n_states(&self) -> usize {
        self.states.len()
    }

    /// n_o.
    #[inline]
    pub fn n_outputs(&self) -> usize {
        self.outputs.len()
    }

    /// Length of `c`: inputs, then first-order states, then constants.
    pub const fn n_fixed(&self) -> usize {
        self.inputs.len() + self.states.len() + self.n_constants
    }
}

/// Start values that a scene prescribes. What is not given is assembled from the constraints.
#[derive(Debug, Clone, PartialEq)]
pub struct Start {
    /// Start time, s.
    pub t: f64,
    /// `n_q` coordinates; a guess where not given.
    pub q: Vec<f64>,
    /// Which coordinates are given.
    pub q_given: Vec<bool>,
    /// `n_v` velocities; a guess where not given.
    pub v: Vec<f64>,
    /// Which velocities are given.
    pub v_given: Vec<bool>,
    /// Which given coordinates may change when the constraints cannot be satisfied with them.
    pub q_near: Vec<bool>,
    /// Which given velocities may change then.
    pub v_near: Vec<bool>,
    /// `n_z` first-order states; empty for those that are declared.
    pub z: Vec<f64>,
}

impl Start {
    /// Nothing given, everything zero, with as many velocities as coordinates.
    pub fn free(n_coordinates: usize) -> Self {
        Self::of(n_coordinates, n_coordinates)
    }

    /// Nothing given, everything zero, for a scene; bodies in space have the axes of the ground.
    pub fn free_of(info: &SceneInfo) -> Self {
        let mut start = Self::of(info.n_coordinates(), info.n_velocities());
        body_kind::set_upright(&info.kinds, &mut start.q);
        start
    }

    /// Nothing given, everything zero, for so many coordinates and velocities.
    pub(crate) fn of(n_coordinates: usize, n_velocities: usize) -> Self {
        Self {
            t: 0.0,
            q: vec![0.0; n_coordinates],
            q_given: vec![false; n_coordinates],
            v: vec![0.0; n_velocities],
            v_given: vec![false; n_velocities],
            q_near: vec![false; n_coordinates],
            v_near: vec![false; n_velocities],
            z: Vec::new(),
        }
    }

    /// Takes the values of a start of the same scene, without allocation.
    pub(crate) fn copy_from(&mut self, other: &Self) {
        self.t = other.t;
        self.q.copy_from_slice(&other.q);
        self.v.copy_from_slice(&other.v);
        self.q_given.copy_from_slice(&other.q_given);
        self.v_given.copy_from_slice(&other.v_given);
        self.q_near.copy_from_slice(&other.q_near);
        self.v_near.copy_from_slice(&other.v_near);
        self.z.clone_from(&other.z);
    }

    /// The same start with the values that are near made free; `None` when there are none.
    pub(crate) fn without_near(&self) -> Option<Self> {
        if !self.q_near.iter().chain(&self.v_near).any(|near| *near) {
            return None;
        }
        let mut free = self.clone();
        free.q_given.iter_mut().zip(&self.q_near).for_each(|(given, near)| *given &= !near);
        free.v_given.iter_mut().zip(&self.v_near).for_each(|(given, near)| *given &= !near);
        Some(free)
    }

    /// Lets all given values change, as little as the constraints demand, when these cannot be satisfied with them.
    pub fn give_way(&mut self) {
        self.q_near.copy_from_slice(&self.q_given);
        self.v_near.copy_from_slice(&self.v_given);
    }

    /// Holds coordinate `i` at `value`.
    pub fn give_position(&mut self, i: usize, value: f64) {
        self.q[i] = value;
        self.q_given[i] = true;
        self.q_near[i] = false;
    }

    /// Holds velocity `i` at `value`.
    pub fn give_velocity(&mut self, i: usize, value: f64) {
        self.v[i] = value;
        self.v_given[i] = true;
        self.v_near[i] = false;
    }

    /// Lets first-order state `i` of the scene begin with `value`, in its unit.
    ///
    /// # Panics
    /// If the scene has no such state.
    pub fn give_state(&mut self, info: &SceneInfo, i: usize, value: f64) {
        let declared = info.states.iter().skip(self.z.len()).map(|state| state.default);
        self.z.extend(declared);
        self.z[i] = value;
    }

    /// Holds coordinate `i` at `value` if the constraints can be satisfied with it.
    pub fn near_position(&mut self, i: usize, value: f64) {
        self.give_position(i, value);
        self.q_near[i] = true;
    }

    /// Holds velocity `i` at `value` if the constraints can be satisfied with it.
    pub fn near_velocity(&mut self, i: usize, value: f64) {
        self.give_velocity(i, value);
        self.v_near[i] = true;
    }
}

/// A scene: one selection of constraints and effects of a model, with its own equations.
///
/// `model!` generates the types that implement it. A scene written by hand implements [`Equations<f64>`](Equations), this trait,
/// and [`Derived`] with an empty block: then it runs with `rk4`, `dop853` and the solvers of `linalg`.
pub trait Scene: Derived {
    /// Names, sizes and equations; for a scene with counts, those of the present counts. Their description is freed when
    /// nobody holds it and the scene was asked for that of other counts. A scene written by hand keeps its own in a
    /// `static` [`LazyLock`](std::sync::LazyLock).
    fn info(&self) -> Arc<SceneInfo>;

    /// Value of parameter `index` of [`SceneInfo::parameters`].
    fn parameter(&self, index: usize) -> f64;

    /// Changes parameter `index`; constants computed before are then out of date.
    fn set_parameter(&mut self, index: usize, value: f64);

    /// Present values of [`SceneInfo::parameters`], then [`SceneInfo::switches`], for [`Equations::constants`].
    fn parameters(&self) -> Vec<f64> {
        let info = self.info();
        (0..info.parameters.len()).map(|i| self.parameter(i)).chain(info.switches.iter().copied()).collect()
    }

    /// Start values of the scene.
    fn start(&self, c: &[f64], start: &mut Start);

    /// Power of each effect, W, without forces that [`Scene::potential_energy`] counts. The power of rows that move
    /// with time is λ · g_t with the multipliers `lambda` (`n_c`) and G v + g_t = 0. Writes `n_e`.
    fn power(&self, c: &[f64], t: f64, q: &[f64], v: &[f64], lambda: &[f64], out: &mut [f64]);

    /// Potential energy of all conservative forces, J; zero without any.
    fn potential_energy(&self, c: &[f64], t: f64, q: &[f64]) -> f64;

    /// Positions of the named points, x then y of each. Writes `2 n_p`.
    fn points(&self, c: &[f64], t: f64, q: &[f64], out: &mut [f64]);
}

/// A scene that is borrowed or shared: `&S`, `Arc<S>`, `Arc<dyn Scene>`, `Rc<S>`. What holds an `Arc` lives as long as it likes.
pub trait SceneRef: Deref<Target: Scene> + Clone {}

impl<P: Deref<Target: Scene> + Clone> SceneRef for P {}

/// A scene of a model, for registries.
#[derive(Debug, Clone, Copy)]
pub struct SceneEntry {
    /// Name of the scene, as written.
    pub name: &'static str,
    /// Names, sizes and equations; with the declared counts where there are any.
    pub info: fn() -> Arc<SceneInfo>,
    /// Makes the scene with its declared parameters.
    pub new: fn() -> Box<dyn Scene>,
}

/// A model and its scenes, for registries.
#[derive(Debug, Clone, Copy)]
pub struct ModelInfo {
    /// Name of the model type, as written.
    pub name: &'static str,
    /// Doc comment of the model.
    pub documentation: &'static str,
    /// Effects that the model declares.
    pub effects: &'static [EffectInfo],
    /// Scenes in declared order.
    pub scenes: &'static [SceneEntry],
}
