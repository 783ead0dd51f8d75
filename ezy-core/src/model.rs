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
pub mod coordinate;
mod derived;
mod element;
pub(crate) mod equations;
mod event;
mod force_element;
pub(crate) mod in_lanes;
mod list;
mod member;
mod named;
pub(crate) mod named_bodies;
pub(crate) mod named_outputs;
pub(crate) mod pivots;
pub(crate) mod quasi_in_lanes;
pub(crate) mod quasi_velocities;
pub(crate) mod repeats;
mod scene_info;
pub(crate) mod series;
mod start;
pub(crate) mod with_derivatives;

pub use body_kind::{BodyKind, Component};
pub use derived::{Derived, JacobianPlaces};
pub use element::{ElementInfo, LoadKind, LocalVector};
pub use equations::Equations;
pub(crate) use equations::{Powers, PreciseScene};
pub use event::{Direction, EventInfo, EventKind, StickSlipInfo, StopInfo};
pub use force_element::ForceElement;
pub use in_lanes::N_LANES;
pub(crate) use in_lanes::{Eight, EquationsInLanes};
pub use list::List;
pub use member::ArrayIndex;
pub use named::{NamedInputs, NamedScene, NoInputs, NoOutputs};
pub use named_bodies::{BodyArray, BodyState};
pub use named_outputs::{OutputArray, Vector};
#[cfg(feature = "sparse")]
pub(crate) use pivots::PIVOT_TOLERANCE;
pub(crate) use pivots::Pivots;
pub(crate) use quasi_in_lanes::EquationsInQuasiVelocities;
pub use quasi_velocities::{QuasiVelocities, QuasiVelocitiesInfo};
pub(crate) use repeats::Repeats;
pub use repeats::{CountInfo, LayoutFault, TemplateInfo};
pub(crate) use repeats::{LARGEST_COUNT, LARGEST_N_MEMBERS};
pub use scene_info::SceneInfo;
pub use series::SeriesInfo;
pub(crate) use series::{PRODUCT_GROUP, Series, SeriesStore};
pub use start::Start;
use std::borrow::Cow;
use std::ops::{Deref, Range};
use std::sync::Arc;
#[cfg(feature = "analysis")]
pub use with_derivatives::Derivatives;
pub use with_derivatives::{EquationsWithDerivatives, N_DERIVATIVES};

/// A name: text of the program, or made at run time for a member of an array. It prints as text and compares with `"x"`.
pub type Name = Cow<'static, str>;

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
    pub fn is_angle(&self) -> bool {
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

/// A number that says how the row of a skate with a limit, or of a stop, takes part. A run sets it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SwitchInfo {
    /// Index of the row in [`SceneInfo::rows`].
    pub row: usize,
    /// Name in equations.
    pub name: &'static str,
    /// Value at the start.
    pub start: f64,
    /// What it says.
    pub documentation: &'static str,
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
    starts: List<u32>,
    /// Column of each stored entry.
    columns: List<u32>,
}

impl SparsityPattern {
    /// Of data of the program.
    pub const fn new(starts: &'static [u32], columns: &'static [u32]) -> Self {
        Self { starts: List::Borrowed(starts), columns: List::Borrowed(columns) }
    }

    /// Made at run time.
    pub(crate) fn of(starts: Vec<u32>, columns: Vec<u32>) -> Self {
        Self { starts: List::Owned(starts), columns: List::Owned(columns) }
    }

    /// Number of rows.
    pub(crate) fn n_rows(&self) -> usize {
        self.starts.len() - 1
    }

    /// Number of stored entries.
    pub fn n_nonzeros(&self) -> usize {
        self.columns.len()
    }

    /// The indices of the stored entries of a row.
    #[inline]
    pub fn row(&self, i: usize) -> Range<usize> {
        self.starts[i] as usize..self.starts[i + 1] as usize
    }

    /// The columns of the stored entries of a row.
    #[inline]
    pub(crate) fn columns_of(&self, i: usize) -> impl ExactSizeIterator<Item = usize> + Clone + '_ {
        self.columns[self.row(i)].iter().map(|column| *column as usize)
    }

    /// The stored entries in order, as (index of the value, row, column).
    pub fn entries(&self) -> impl Iterator<Item = (usize, usize, usize)> + '_ {
        let (starts, mut row) = (&self.starts[..], 0);
        self.columns.iter().enumerate().map(move |(k, column)| {
            while starts[row + 1] as usize <= k {
                row += 1;
            }
            (k, row, *column as usize)
        })
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

/// A scene: one selection of constraints and effects of a model, with its own equations.
///
/// `model!` generates the types that implement it. A scene written by hand implements [`Equations<f64>`](Equations), this trait,
/// and [`Derived`] with an empty block: then it runs with `rk4`, `dop853` and the solvers of `linalg`.
pub trait Scene: Derived + AsDynScene {
    /// Names, sizes and equations; for a scene with counts, those of the present counts. Their description is freed when
    /// nobody holds it and the scene was asked for that of other counts. A scene written by hand keeps its own in a
    /// `static` [`LazyLock`](std::sync::LazyLock).
    fn info(&self) -> Arc<SceneInfo>;

    /// Value of parameter `index` of [`SceneInfo::parameters`].
    fn parameter(&self, index: usize) -> f64;

    /// Changes parameter `index`; constants computed before are then out of date.
    fn set_parameter(&mut self, index: usize, value: f64);

    /// Present values of [`SceneInfo::parameters`], then those that [`SceneInfo::switches`] start with, for [`Equations::constants`].
    fn parameters(&self) -> Vec<f64> {
        let info = self.info();
        (0..info.parameters.len())
            .map(|i| self.parameter(i))
            .chain(info.switches.iter().map(|switch| switch.start))
            .collect()
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

/// A scene of any type as one behind its trait; every scene has it by itself.
pub trait AsDynScene {
    /// This scene.
    fn as_dyn(&self) -> &dyn Scene;
}

impl<S: Scene> AsDynScene for S {
    fn as_dyn(&self) -> &dyn Scene {
        self
    }
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
