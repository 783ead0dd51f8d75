//! The model text as a tree: what was written and where, without meaning.

use crate::diag::Extent;
use crate::function::Operator;
use crate::grammar::{Expected, Setting, Word};
use proc_macro2::{Ident, Span, TokenStream};
use std::ops::Deref;

pub struct Model {
    /// The path of `ezy-core` where the model stands.
    pub core: TokenStream,
    pub visibility: syn::Visibility,
    pub name: Ident,
    pub documentation: String,
    /// Of the whole text.
    pub fingerprint: u64,
    pub items: Vec<Item>,
    /// Names of items that could not be parsed: their uses give no further errors.
    pub broken: Vec<Ident>,
    /// Every `for`, once, with those around it.
    pub loops: Vec<(Loop, Vec<Loop>)>,
}

#[derive(Debug)]
pub struct Item {
    pub documentation: String,
    /// The `for` around the item, outermost first.
    pub loops: Vec<Loop>,
    pub kind: ItemKind,
}

/// `for variable in from..to`
#[derive(Debug, Clone)]
pub struct Loop {
    pub variable: Ident,
    pub from: Expr,
    pub to: Expr,
}

/// A name with what stands in brackets behind it: `link[i-1]`.
#[derive(Debug, Clone)]
pub struct Name {
    pub word: Ident,
    pub indices: Vec<Expr>,
    /// As written, blanks removed: `link[i-1]`.
    pub text: String,
    /// The last token.
    pub end: Span,
}

#[derive(Debug)]
pub enum ItemKind {
    Count(Count),
    Parameter(Parameter),
    /// Written like a parameter; with a rate, it is a first-order state.
    Input(Parameter),
    Output(Output),
    Let(Let),
    Body(Body),
    Point(Point),
    Statement(Statement),
    Release(Ident),
    Event(Event),
    Stop(Stop),
    Effect(Effect),
    Start(Start),
    Scene(Scene),
}

#[derive(Debug)]
pub struct Count {
    pub name: Ident,
    pub value: Expr,
}

#[derive(Debug)]
pub struct Parameter {
    pub name: Ident,
    pub unit: Option<Unit>,
    pub value: Expr,
    /// The value as written, blanks removed.
    pub value_text: String,
    /// Of an input `by acceleration`.
    pub part: Option<Part>,
    /// Of a first-order state.
    pub rate: Option<Expr>,
}

/// One of the four numbers of an input `by acceleration`, in the order in which they are declared.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Part {
    Value,
    Rate,
    Acceleration,
    /// The time of value and rate.
    Since,
}

#[derive(Debug)]
pub struct Output {
    pub name: Name,
    pub unit: Option<Unit>,
    pub value: Expr,
}

#[derive(Debug)]
pub struct Let {
    pub name: Ident,
    pub value: Expr,
}

#[derive(Debug)]
pub struct Body {
    /// The indices are the lengths of an array.
    pub name: Name,
    pub mass: Expr,
    pub inertia: Expr,
}

#[derive(Debug)]
pub struct Point {
    pub name: Name,
    pub place: OnBody,
}

/// A constraint or a force.
#[derive(Debug)]
pub struct Statement {
    pub word: &'static Word,
    /// The word as written.
    pub keyword: Ident,
    /// Forces have none, some rows need none.
    pub name: Option<Name>,
    pub phrases: Vec<Phrase>,
}

/// What was written for a part of a statement.
#[derive(Debug)]
pub enum Phrase {
    Pair(Box<[Place; 2]>),
    At(Place),
    Couple(Name, Name),
    Body(Name),
    Direction { across: bool, direction: OnBody },
    Scalar(Expected, Expr),
    Vector(Expected, Expr),
    Equation { left: Expr, equals: Span, right: Expr },
    Settings(&'static [Setting], Vec<Option<Expr>>),
}

#[derive(Debug)]
pub struct Effect {
    pub name: Ident,
    pub items: Vec<Item>,
}

#[derive(Debug)]
pub struct Start {
    pub name: Ident,
    pub given: Vec<Given>,
    /// The word `rest` of `at rest;`.
    pub at_rest: Option<Ident>,
}

/// One quantity of a body in a start.
#[derive(Debug)]
pub struct Given {
    /// The `for` around it, outermost first.
    pub loops: Vec<Loop>,
    pub body: Name,
    /// Whether it may change when the constraints cannot be satisfied with it.
    pub near: bool,
    pub quantity: Quantity,
    /// The word that gives it.
    pub word: Ident,
    pub values: GivenValues,
}

/// What a start gives.
#[derive(Debug)]
pub enum GivenValues {
    /// One value, or two for a pair; `None` where a component is left free.
    Each(Vec<Option<Expr>>),
    /// Both components by one expression.
    Vector(Expr),
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Quantity {
    Position,
    Angle,
    Velocity,
    Rate,
    X,
    Y,
    VelocityX,
    VelocityY,
}

#[derive(Debug)]
pub struct Scene {
    pub name: Ident,
    pub start: Option<Ident>,
    pub until: Option<Duration>,
    /// What ends it before.
    pub ends: Vec<End>,
    pub effects: Vec<Ident>,
    /// Whether a statement could not be parsed, so that a missing one gives no further error.
    pub broken: bool,
}

/// `event name: a < b;`
#[derive(Debug)]
pub struct Event {
    pub name: Ident,
    pub condition: Condition,
}

/// `stop name: quantity from a to b restitution e;`
#[derive(Debug)]
pub struct Stop {
    pub name: Ident,
    pub quantity: Expr,
    /// Behind `from` and behind `to`.
    pub bounds: [Option<Expr>; 2],
    pub restitution: Option<Expr>,
}

/// `a < b`, `a > b`, `a = b`: what begins to hold, or is passed.
#[derive(Debug)]
pub struct Condition {
    pub left: Expr,
    pub relation: Relation,
    /// The sign.
    pub at: Span,
    pub right: Expr,
    /// As written, with blanks around the sign alone.
    pub text: String,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Relation {
    Less,
    Greater,
    Equal,
}

impl Relation {
    pub const fn sign(self) -> &'static str {
        match self {
            Self::Less => "<",
            Self::Greater => ">",
            Self::Equal => "=",
        }
    }
}

/// What ends a scene before its time.
#[derive(Debug)]
pub enum End {
    Condition(Condition),
    /// The name of an event.
    Event(Ident),
}

#[derive(Debug)]
pub struct Duration {
    pub value: Expr,
    pub unit: Ident,
}

/// A point by its name, or a point on a body.
#[derive(Debug)]
pub enum Place {
    Named(Name),
    OnBody(OnBody),
}

/// `body(x, y)`: a place or a direction in the axes of a body.
#[derive(Debug)]
pub struct OnBody {
    pub body: Name,
    pub x: Expr,
    pub y: Expr,
}

/// A product of powers of units.
#[derive(Debug, Clone)]
pub struct Unit {
    /// As written, blanks removed.
    pub text: String,
    pub factors: Vec<UnitFactor>,
}

#[derive(Debug, Clone)]
pub struct UnitFactor {
    pub name: Ident,
    pub exponent: i32,
}

#[derive(Debug, Clone)]
pub enum Expr {
    Number {
        value: f64,
        span: Span,
    },
    /// A number with a unit behind it.
    Quantity {
        value: f64,
        unit: Unit,
        start: Span,
        end: Span,
    },
    Name(Ident),
    /// A name with indices and no member.
    Indexed(Box<Name>),
    Member {
        owner: Box<Name>,
        member: Ident,
    },
    Call {
        function: Ident,
        arguments: Vec<Expr>,
        end: Span,
    },
    Vector {
        x: Box<Expr>,
        y: Box<Expr>,
        start: Span,
        end: Span,
    },
    Negative {
        sign: Span,
        operand: Box<Expr>,
    },
    Binary {
        operator: Operator,
        span: Span,
        left: Box<Expr>,
        right: Box<Expr>,
    },
}

impl Deref for Name {
    type Target = Ident;

    fn deref(&self) -> &Ident {
        &self.word
    }
}

impl From<&Name> for Extent {
    fn from(name: &Name) -> Self {
        Self { first: name.word.span(), last: name.end }
    }
}

impl Expr {
    /// A name alone, with or without indices.
    pub fn as_name(&self) -> Option<Name> {
        match self {
            Self::Name(word) => {
                Some(Name { text: word.to_string(), word: word.clone(), indices: Vec::new(), end: word.span() })
            }
            Self::Indexed(name) => Some(Name::clone(name)),
            _ => None,
        }
    }

    pub fn extent(&self) -> Extent {
        match self {
            Self::Number { span, .. } => (*span).into(),
            Self::Name(name) => name.into(),
            Self::Indexed(name) => (&**name).into(),
            Self::Member { owner, member } => Extent { first: owner.span(), last: member.span() },
            Self::Call { function, end, .. } => Extent { first: function.span(), last: *end },
            Self::Quantity { start, end, .. } | Self::Vector { start, end, .. } => Extent { first: *start, last: *end },
            Self::Negative { sign, operand } => Extent { first: *sign, last: operand.extent().last },
            Self::Binary { left, right, .. } => Extent { first: left.extent().first, last: right.extent().last },
        }
    }
}
