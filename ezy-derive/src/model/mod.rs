//! The model with every name resolved: what `mechanics` reads.
//!
//! Expressions are scalar here; vectors of the model file have been split into components.

pub mod case;
mod constant;
mod context;
mod dimension;
mod expression;
mod force;
mod function;
mod lazy;
mod mechanism;
mod member;
mod names;
mod resolve;
mod scene;
mod start;
#[cfg(test)]
mod tests;
mod unit;
mod value;

pub use crate::function::Function;
pub use resolve::resolve;

use proc_macro2::Ident;

/// Index into [`Model::bodies`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct BodyId(pub usize);
/// Index into [`Model::parameters`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ParameterId(pub usize);
/// Index into [`Model::points`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct PointId(pub usize);
/// Index into [`Model::rows`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct RowId(pub usize);
/// Index into [`Model::effects`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct EffectId(pub usize);
/// Index into [`Model::starts`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct StartId(pub usize);

/// A model file, resolved.
pub struct Model {
    pub visibility: syn::Visibility,
    /// Name of the model as written, CamelCase.
    pub name: Ident,
    pub documentation: String,
    pub bodies: Vec<Body>,
    /// Parameters of the model and of its effects, in declared order.
    pub parameters: Vec<Parameter>,
    /// Named points in declared order; each hinge adds the point that carries its name (its place on the first body).
    pub points: Vec<Point>,
    pub rows: Vec<Row>,
    pub forces: Vec<Force>,
    pub effects: Vec<Effect>,
    pub starts: Vec<Start>,
    pub scenes: Vec<Scene>,
}

#[derive(Debug)]
pub struct Body {
    pub name: Ident,
    pub mass: Expr,
    pub inertia: Expr,
}

#[derive(Debug)]
pub struct Parameter {
    pub name: Ident,
    /// As written, blanks removed; empty when none was declared.
    pub unit: String,
    pub default: f64,
    /// As written.
    pub default_text: String,
    pub documentation: String,
    /// The effect that declares it.
    pub effect: Option<EffectId>,
}

#[derive(Debug)]
pub struct Point {
    pub name: Ident,
    pub place: Place,
}

/// A point fixed to a body (`None`: the ground), in the body's own axes from its centre of mass.
#[derive(Debug, Clone)]
pub struct Place {
    pub body: Option<BodyId>,
    pub x: Expr,
    pub y: Expr,
}

/// A direction fixed to a body (`None`: the ground); need not have length one.
#[derive(Debug, Clone)]
pub struct Direction {
    pub body: Option<BodyId>,
    pub x: Expr,
    pub y: Expr,
}

#[derive(Debug)]
pub struct Row {
    pub name: Ident,
    pub kind: RowKind,
}

#[derive(Debug)]
pub enum RowKind {
    /// `hinge B: a ~ b`: both places coincide; rows `B.x`, `B.y`, C = place(a) − place(b).
    Hinge { a: Place, b: Place },
    /// `skate S: at P along d`: no velocity of P across d (d turned by +90°); one row `S`.
    Skate { at: Place, along: Direction },
}

#[derive(Debug)]
pub struct Force {
    /// The effect that declares it; `None` when the model itself does.
    pub effect: Option<EffectId>,
    pub kind: ForceKind,
}

#[derive(Debug)]
pub enum ForceKind {
    /// `torque body: value`
    Torque { body: BodyId, value: Expr },
    /// `torque a ~ b: value`, `+value` on a and `-value` on b (`None`: the ground).
    TorquePair { a: Option<BodyId>, b: Option<BodyId>, value: Expr },
    /// `force at P: vector`, and `force at P along/across d: scalar` after multiplying out.
    ForceAt { at: Place, x: Expr, y: Expr },
    /// `force at P along d: value`, `force at P across d: value` (d turned by +90°); d is scaled to length one.
    ForceAlong { at: Place, direction: Direction, across: bool, value: Expr },
}

#[derive(Debug)]
pub struct Effect {
    pub name: Ident,
    pub documentation: String,
}

/// A start: what is given; `at rest` gives nothing, since the guess of every velocity is zero.
#[derive(Debug)]
pub struct Start {
    pub values: Vec<StartValue>,
}

#[derive(Debug)]
pub struct StartValue {
    pub body: BodyId,
    pub component: Component,
    /// False: the coordinate; true: its velocity.
    pub rate: bool,
    /// Depends on parameters alone.
    pub value: Expr,
}

#[derive(Debug)]
pub struct Scene {
    /// As written, snake_case; the generated type is its CamelCase form.
    pub name: Ident,
    pub documentation: String,
    pub start: StartId,
    pub until_s: f64,
    pub effects: Vec<EffectId>,
}

/// x, y or φ of a body.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Component {
    X,
    Y,
    Phi,
}

/// A scalar expression with every name resolved.
#[derive(Debug, Clone)]
pub enum Expr {
    /// A literal; exact decimals as written keep their nearest f64.
    Number(f64),
    Pi,
    Time,
    Parameter(ParameterId),
    /// `body.x`, `body.y`, `body.phi`
    Coordinate(BodyId, Component),
    /// `body.vx`, `body.vy`, `body.omega`
    Velocity(BodyId, Component),
    /// `point.x`, `point.y` (world coordinates; never `Phi`)
    PointPosition(PointId, Component),
    /// `point.vx`, `point.vy`
    PointVelocity(PointId, Component),
    /// `hinge.angle` = φ_b − φ_a
    HingeAngle(RowId),
    /// `hinge.rate` = φ̇_b − φ̇_a
    HingeRate(RowId),
    Neg(Box<Expr>),
    Add(Box<Expr>, Box<Expr>),
    Sub(Box<Expr>, Box<Expr>),
    Mul(Box<Expr>, Box<Expr>),
    Div(Box<Expr>, Box<Expr>),
    Pow(Box<Expr>, Box<Expr>),
    Call(Function, Vec<Expr>),
}
