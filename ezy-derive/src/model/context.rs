//! What resolving knows while it goes through the tree.

use super::names::{Names, Scope};
use super::unit::Unit;
use super::value::Value;
use super::{Expr, Place};
use crate::diag::Diagnostics;
use crate::parse::ast;

/// The tables of a model while its names are resolved.
pub struct Context<'a> {
    pub diag: &'a mut Diagnostics,
    pub names: Names,
    /// By [`super::ParameterId`].
    pub units: Vec<Option<Unit>>,
    pub lets: Vec<Lazy<(Scope, &'a ast::Let), Value>>,
    /// How many `let` values are in work.
    pub n_lets_in_work: usize,
    /// By [`super::PointId`].
    pub points: Vec<Lazy<PointSource<'a>, Place>>,
}

/// Where the place of a point is written.
#[derive(Clone, Copy)]
pub enum PointSource<'a> {
    Point(&'a ast::Point),
    Hinge(&'a ast::Hinge),
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

/// How far a lazy thing is.
#[derive(Debug, Clone)]
pub enum State<T> {
    Waiting,
    /// Meeting it again means that it depends on itself.
    InWork,
    Done(T),
    /// Its fault has been reported.
    Faulty,
}

/// What an expression is for.
#[derive(Clone)]
pub struct Purpose {
    pub scope: Scope,
    /// What must not move, when it must depend on parameters alone: `the mass of body `seat``.
    pub fixed: Option<String>,
}

impl Purpose {
    pub const fn moving(scope: Scope) -> Self {
        Self { scope, fixed: None }
    }

    pub const fn fixed(scope: Scope, what: String) -> Self {
        Self { scope, fixed: Some(what) }
    }
}

/// Whether an expression depends on the time or the motion, and if so on what.
pub fn motion(expr: &Expr) -> Option<&'static str> {
    match expr {
        Expr::Number(_) | Expr::Pi | Expr::Parameter(_) => None,
        Expr::Time => Some("the time"),
        Expr::Coordinate(..) | Expr::PointPosition(..) | Expr::HingeAngle(_) => Some("the position"),
        Expr::Velocity(..) | Expr::PointVelocity(..) | Expr::HingeRate(_) => Some("the velocity"),
        Expr::Neg(a) => motion(a),
        Expr::Add(a, b) | Expr::Sub(a, b) | Expr::Mul(a, b) | Expr::Div(a, b) | Expr::Pow(a, b) => {
            motion(a).or_else(|| motion(b))
        }
        Expr::Call(_, arguments) => arguments.iter().find_map(motion),
    }
}
