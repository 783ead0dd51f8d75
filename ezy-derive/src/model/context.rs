//! The state of name resolution.

use std::collections::BTreeSet;

use super::names::{Names, Scope};
use super::unit::Unit;
use super::value::Value;
use super::whole::Whole;
use super::{Array, EffectId, Expr, Loop, Place, Slot};
use crate::diag::Diagnostics;
use crate::parse::ast;
use proc_macro2::Ident;

/// The tables of a model while its names are resolved.
pub struct Context<'a> {
    pub diag: &'a mut Diagnostics,
    pub names: Names,
    /// By [`super::ParameterId`].
    pub units: Vec<Option<Unit>>,
    /// By [`super::InputId`].
    pub input_units: Vec<Option<Unit>>,
    /// By [`super::InputId`].
    pub input_parts: Vec<Option<ast::Part>>,
    pub lets: Vec<Lazy<(Scope, &'a ast::Let), Value>>,
    /// How many `let` values are in work.
    pub n_lets_in_work: usize,
    /// By [`super::PointId`].
    pub points: Vec<Lazy<PointSource<'a>, Place>>,
    /// Points and hinges that are declared in a `for`: each use has a place of its own.
    pub point_arrays: Vec<Lazy<ArraySource<'a>, ()>>,
    /// Name and declared value of each count.
    pub counts: Vec<(String, i64)>,
    /// Names of indices by [`super::whole::IndexId`].
    pub indices: Vec<String>,
    /// Quotients that are used as values, by [`super::whole::QuotientId`].
    pub quotients: Vec<Whole>,
    /// The `for` around the present item, outermost first.
    pub loops: Vec<Loop>,
    /// Present values of the indices.
    pub bound: Vec<(String, Whole)>,
    /// The array whose members are described, without an index that tells them apart.
    pub alike: Option<usize>,
    /// Declarations that were reported since another effect of a scene has the name, too.
    pub shared_parameters: BTreeSet<(EffectId, String)>,
    /// By the `array` of a [`Slot`].
    pub arrays: Vec<Array>,
    /// By [`super::BodyId`].
    pub slots: Vec<Slot>,
}

impl<'a> Context<'a> {
    pub fn new(diag: &'a mut Diagnostics) -> Self {
        Self {
            diag,
            names: Names::default(),
            units: Vec::new(),
            input_units: Vec::new(),
            input_parts: Vec::new(),
            lets: Vec::new(),
            n_lets_in_work: 0,
            points: Vec::new(),
            point_arrays: Vec::new(),
            counts: Vec::new(),
            indices: Vec::new(),
            quotients: Vec::new(),
            loops: Vec::new(),
            bound: Vec::new(),
            alike: None,
            shared_parameters: BTreeSet::new(),
            arrays: Vec::new(),
            slots: Vec::new(),
        }
    }
}

/// A declaration in a `for`.
#[derive(Clone, Copy)]
pub struct ArraySource<'a> {
    pub source: PointSource<'a>,
    pub loops: &'a [ast::Loop],
}

/// Where the place of a point is written.
#[derive(Clone, Copy)]
pub enum PointSource<'a> {
    Point(&'a ast::Point),
    /// A hinge by its name and its places, which may use names of its effect.
    Hinge(&'a Ident, &'a ast::Place, &'a ast::Place, Scope),
}

impl PointSource<'_> {
    pub const fn what_array(self) -> &'static str {
        match self {
            Self::Point(_) => "an array of points",
            Self::Hinge(..) => "an array of hinges",
        }
    }
}

/// Something that is resolved when it is first used.
pub struct Lazy<S, T> {
    pub source: S,
    pub state: State<T>,
}

impl<S, T> Lazy<S, T> {
    pub const fn waiting(source: S) -> Self {
        Self { source, state: State::Waiting }
    }
}

/// State of a lazy value.
#[derive(Debug, Clone)]
pub enum State<T> {
    Waiting,
    /// Meeting it again means that it depends on itself.
    InWork,
    Done(T),
    /// Its fault has been reported.
    Faulty,
}

/// The most that an expression may depend on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Motion {
    Parameters,
    Time,
    Position,
    Velocity,
    /// An input, which the caller sets during a run; its rate is unknown.
    Input,
    /// A first-order state, whose second derivative is unknown.
    State,
}

impl Motion {
    /// In a sentence: "cannot depend on …".
    pub const fn text(self) -> &'static str {
        match self {
            Self::Parameters => "parameters",
            Self::Time => "the time",
            Self::Position => "the position",
            Self::Velocity => "the velocity",
            Self::Input => "an input",
            Self::State => "a state",
        }
    }
}

/// What an expression is for.
#[derive(Clone)]
pub struct Purpose {
    pub scope: Scope,
    /// The quantity, for messages: `the mass of body `seat``.
    pub limit: Option<(String, Motion)>,
    /// Whether it is for a stop, which has messages of its own.
    pub is_stop: bool,
}

impl Purpose {
    /// Anything may be used.
    pub const fn moving(scope: Scope) -> Self {
        Self { scope, limit: None, is_stop: false }
    }

    /// Depends on parameters alone.
    pub const fn fixed(scope: Scope, what: String) -> Self {
        Self::up_to(scope, what, Motion::Parameters)
    }

    pub const fn up_to(scope: Scope, what: String, motion: Motion) -> Self {
        Self { scope, limit: Some((what, motion)), is_stop: false }
    }

    /// The quantity of a stop, or a bound.
    pub const fn stop(scope: Scope, what: String) -> Self {
        Self { scope, limit: Some((what, Motion::Position)), is_stop: true }
    }
}

/// What an expression depends on.
pub fn motion(expr: &Expr) -> Motion {
    match expr {
        Expr::Input(_) => Motion::Input,
        Expr::State(_) => Motion::State,
        // a rate in a position constraint would let velocities jump with the acceleration
        Expr::Integrated(_, ast::Part::Rate) => Motion::Velocity,
        Expr::Time | Expr::Integrated(..) => Motion::Time,
        Expr::Coordinate(..) | Expr::PointPosition(..) | Expr::MemberPosition(..) | Expr::HingeAngle(_) => {
            Motion::Position
        }
        Expr::Velocity(..) | Expr::PointVelocity(..) | Expr::MemberVelocity(..) | Expr::HingeRate(_) => {
            Motion::Velocity
        }
        _ => expr.operands().into_iter().map(motion).max().unwrap_or(Motion::Parameters),
    }
}
