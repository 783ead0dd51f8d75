//! The model with every name resolved: what `mechanics` reads.
//!
//! Expressions are scalar here; vectors of the model file have been split into components.

mod array;
pub mod case;
mod constant;
mod context;
mod coordinate;
mod dimension;
mod event;
mod expression;
mod function;
mod lazy;
mod mechanism;
mod member;
mod names;
mod output;
mod point_array;
mod repeat;
mod repeated;
mod resolve;
mod scene;
mod start;
mod state;
mod statement;
mod stop;
#[cfg(test)]
mod tests;
mod unit;
mod value;
pub mod whole;

pub use crate::function::{Function, Operator};
pub use crate::parse::ast::{Part, Relation};
pub use coordinate::{Component, Coordinate};
pub use resolve::resolve;

use crate::grammar::Word;
use proc_macro2::{Ident, TokenStream};
pub use unit::Unit;
use whole::{CountId, IndexId, QuotientId, Whole};

/// Index into [`Model::bodies`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct BodyId(pub usize);
/// Index into [`Model::parameters`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ParameterId(pub usize);
/// Index into [`Model::inputs`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct InputId(pub usize);
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
    /// The path of `ezy-core` where the model stands.
    pub core: TokenStream,
    pub visibility: syn::Visibility,
    /// Name of the model as written, CamelCase.
    pub name: Ident,
    pub documentation: String,
    /// Hash of the text.
    pub fingerprint: u64,
    /// Numbers of a run that say how often things are repeated.
    pub counts: Vec<Count>,
    /// Names of the indices of `for`.
    pub indices: Vec<String>,
    /// Quotients of whole numbers that are used as values.
    pub quotients: Vec<Whole>,
    /// Declared bodies, single or in arrays.
    pub arrays: Vec<Array>,
    /// Single bodies, and members of arrays as they are referred to.
    pub bodies: Vec<Body>,
    /// `let` values, by component: equations are printed with their names.
    pub lets: Vec<NamedValue>,
    /// Parameters of the model and of its effects, in declared order.
    pub parameters: Vec<Parameter>,
    /// Inputs and first-order states of the model and of its effects, in declared order; declared like parameters.
    pub inputs: Vec<Parameter>,
    /// Outputs of the model, then of its effects.
    pub outputs: Vec<Output>,
    /// Events of the model, then of its effects.
    pub events: Vec<Event>,
    /// Named points in declared order; each hinge adds the point that carries its name (its place on the first body).
    pub points: Vec<Point>,
    pub rows: Vec<Row>,
    /// Stops of the model, then of its effects.
    pub stops: Vec<Stop>,
    pub forces: Vec<Force>,
    pub effects: Vec<Effect>,
    pub starts: Vec<Start>,
    pub scenes: Vec<Scene>,
}

#[derive(Debug)]
pub struct Count {
    pub name: Ident,
    pub default: i64,
    pub documentation: String,
}

/// Bodies that are declared together.
#[derive(Debug, Clone)]
pub struct Array {
    pub name: Ident,
    /// None for a single body.
    pub lengths: Vec<Whole>,
    /// The `for` over its members, outermost first; none for a single body.
    pub loops: Vec<Loop>,
    /// Of the member that has the indices of `loops`.
    pub mass: Expr,
    pub inertia: Expr,
}

/// A member of an array as it is referred to.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Slot {
    /// Index into [`Model::arrays`].
    pub array: usize,
    /// None for a single body.
    pub index: Vec<Whole>,
}

/// A `for` around a declaration.
#[derive(Debug, Clone)]
pub struct Loop {
    pub index: IndexId,
    pub from: Whole,
    pub to: Whole,
}

#[derive(Debug)]
pub struct Body {
    /// `seat`, or `link[i-1]`.
    pub name: String,
    pub slot: Slot,
    pub mass: Expr,
    pub inertia: Expr,
}

#[derive(Debug)]
pub struct Parameter {
    pub name: Ident,
    /// As written, blanks removed; empty when none was declared.
    pub unit: String,
    /// The unit, or that of a plain number.
    pub size: Unit,
    /// In its unit.
    pub default: f64,
    /// As written.
    pub default_text: String,
    pub documentation: String,
    /// The effect that declares it.
    pub effect: Option<EffectId>,
    /// Of an input `by acceleration`, whose parts follow each other.
    pub part: Option<Part>,
    /// Of a first-order state, in its unit over s.
    pub rate: Option<Expr>,
}

/// A scalar output; a vector is two of them.
#[derive(Debug)]
pub struct Output {
    pub name: Ident,
    /// `.x` and `.y` of a vector.
    pub suffix: String,
    /// The `for` around its declaration, outermost first.
    pub loops: Vec<Loop>,
    /// As written, blanks removed; empty when none was declared.
    pub unit: String,
    pub documentation: String,
    /// The effect that declares it.
    pub effect: Option<EffectId>,
    /// In its unit.
    pub value: Expr,
}

/// An event: a value that passes zero during a run.
#[derive(Debug, Clone)]
pub struct Event {
    pub name: String,
    pub documentation: String,
    /// The effect that declares it.
    pub effect: Option<EffectId>,
    pub value: Expr,
    pub relation: Relation,
}

#[derive(Debug)]
pub struct Point {
    pub name: Ident,
    /// The `for` around its declaration, outermost first.
    pub loops: Vec<Loop>,
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
    pub word: &'static Word,
    /// The effect that declares it; `None` when the model itself does.
    pub effect: Option<EffectId>,
    /// The `for` around its declaration, outermost first.
    pub loops: Vec<Loop>,
    pub arguments: Arguments,
}

impl Row {
    /// The force up to which a skate holds; `None` for a skate without a limit.
    pub fn limit(&self) -> Option<&Expr> {
        if self.word.word == "skate" { self.arguments.settings.first()?.as_ref() } else { None }
    }
}

/// The bounds of a quantity.
#[derive(Debug)]
pub struct Stop {
    pub name: Ident,
    /// The effect that declares it; `None` when the model itself does.
    pub effect: Option<EffectId>,
    /// Depends on positions, parameters and the time, as its bounds do.
    pub quantity: Expr,
    /// The lower one and the upper one; one of them may be missing.
    pub bounds: [Option<Expr>; 2],
    /// Rate after an impact over the rate before it.
    pub restitution: Expr,
    /// Unit of the multiplier where it holds; empty when it is not known.
    pub multiplier_unit: String,
}

#[derive(Debug)]
pub struct Force {
    pub word: &'static Word,
    /// What it is and where: `spring A ~ B`; another one may have the same.
    pub name: String,
    /// Number of its declaration: a gravity that acts on arrays becomes several forces.
    pub declaration: usize,
    /// The effect that declares it; `None` when the model itself does.
    pub effect: Option<EffectId>,
    /// The `for` around its declaration, outermost first.
    pub loops: Vec<Loop>,
    pub arguments: Arguments,
}

/// Arguments of a constraint or force, by kind, in written order; their numbers follow from the form of the word.
#[derive(Debug, Default)]
pub struct Arguments {
    pub places: Vec<Place>,
    /// `None` is the ground.
    pub bodies: Vec<Option<BodyId>>,
    pub directions: Vec<Direction>,
    /// Whether the direction was written behind `across`.
    pub across: bool,
    /// Scalars; of an equation, the left side minus the right side.
    pub scalars: Vec<Expr>,
    pub vector: Option<(Expr, Expr)>,
    /// Unit of the multiplier of an equation; empty when it is not known.
    pub multiplier_unit: String,
    /// One for each setting of the form; `None` where a law lacks this part.
    pub settings: Vec<Option<Expr>>,
}

#[derive(Debug)]
pub struct Effect {
    pub name: Ident,
    pub documentation: String,
    /// Constraints that scenes with this effect leave out.
    pub releases: Vec<RowId>,
}

/// A start: what is given; `at rest` gives nothing, since the guess of every velocity is zero.
#[derive(Debug)]
pub struct Start {
    pub name: Ident,
    pub values: Vec<StartValue>,
}

/// A component of a `let` value.
#[derive(Debug)]
pub struct NamedValue {
    /// `name`, or `name.x` of a vector.
    pub name: String,
    pub effect: Option<EffectId>,
    pub value: Expr,
}

#[derive(Debug)]
pub struct StartValue {
    pub body: BodyId,
    pub component: Component,
    /// False: the coordinate; true: its velocity.
    pub rate: bool,
    /// Whether it may change when the constraints cannot be satisfied with it.
    pub near: bool,
    /// Depends on parameters alone.
    pub value: Expr,
    /// The `for` around it, outermost first.
    pub loops: Vec<Loop>,
}

#[derive(Debug, Clone)]
pub struct Scene {
    /// As written, snake_case; the generated type is its CamelCase form.
    pub name: Ident,
    pub documentation: String,
    pub start: StartId,
    pub until_s: f64,
    pub effects: Vec<EffectId>,
    /// Declared events that end it: places in [`Model::events`].
    pub ends: Vec<usize>,
    /// Conditions of its own that end it.
    pub conditions: Vec<Event>,
}

impl Scene {
    /// Whether what an effect declares belongs to it; what stands outside effects always does.
    pub fn calls_for(&self, effect: Option<EffectId>) -> bool {
        effect.is_none_or(|effect| self.effects.contains(&effect))
    }
}

/// A number that says how the row of a skate with a limit, or of a stop, takes part. A run sets it; equations read it like a parameter.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Switch {
    /// 1 while the row holds, 0 otherwise.
    Holds,
    /// Of a skate 1 while it slides to the left of its direction, -1 to the right, 0 while it holds; of a stop 1 for the lower end, -1 for
    /// the upper one.
    Side,
}

/// A switch of a scene.
#[derive(Debug)]
pub struct DeclaredSwitch {
    /// The skate with a limit, or the stop.
    pub of: String,
    pub switch: Switch,
    /// In equations.
    pub name: String,
    /// Its value at the start.
    pub start: f64,
    pub documentation: &'static str,
}

impl Switch {
    /// In the order of their places.
    pub const ALL: [Self; 2] = [Self::Holds, Self::Side];

    /// Behind the name of the row.
    pub fn suffix(self) -> &'static str {
        match self {
            Self::Holds => "holds",
            Self::Side => "side",
        }
    }
}

/// An end of a stop.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Bound {
    Lower,
    Upper,
}

impl Stop {
    /// Its ends.
    pub fn ends(&self) -> impl Iterator<Item = (Bound, &Expr)> {
        let ends = [Bound::Lower, Bound::Upper].into_iter().zip(&self.bounds);
        ends.filter_map(|(bound, value)| Some((bound, value.as_ref()?)))
    }
}

impl Arguments {
    /// Every body that takes part.
    pub fn all_bodies(&self) -> impl Iterator<Item = BodyId> {
        let places = self.places.iter().filter_map(|place| place.body);
        places.chain(self.bodies.iter().copied().flatten()).chain(self.directions.iter().filter_map(|d| d.body))
    }
}

impl Model {
    /// Whether sizes are numbers of a run.
    pub fn is_repeated(&self) -> bool {
        !self.counts.is_empty() || !self.indices.is_empty() || self.arrays.iter().any(|a| !a.lengths.is_empty())
    }

    /// The events of a scene and whether they end it.
    pub fn events_of<'a>(&'a self, scene: &'a Scene) -> impl Iterator<Item = (&'a Event, bool)> {
        let called = |event: &Event| scene.calls_for(event.effect);
        let declared = self.events.iter().enumerate().filter(move |(_, event)| called(event));
        let declared = declared.map(|(i, event)| (event, scene.ends.contains(&i)));
        declared.chain(scene.conditions.iter().map(|condition| (condition, true)))
    }

    /// The rows of a scene: those of the model and of its effects, without what its effects release.
    pub fn rows_of<'a>(&'a self, scene: &'a Scene) -> impl Iterator<Item = (RowId, &'a Row)> {
        let called = |row: &Row| scene.calls_for(row.effect);
        let released = |id: RowId| scene.effects.iter().any(|effect| self.effects[effect.0].releases.contains(&id));
        let rows = self.rows.iter().enumerate().map(|(i, row)| (RowId(i), row));
        rows.filter(move |(id, row)| called(row) && !released(*id))
    }

    /// The outputs of a scene with their places: those of the model and of its effects.
    pub fn outputs_of(&self, scene: &Scene) -> impl Iterator<Item = (usize, &Output)> {
        self.outputs.iter().enumerate().filter(|(_, output)| scene.calls_for(output.effect))
    }

    /// The inputs among these, and the first-order states, which stand behind them.
    pub fn split_states<'i>(&self, inputs: &'i [InputId]) -> [&'i [InputId]; 2] {
        let (inputs, states) = inputs.split_at(inputs.partition_point(|id| self.inputs[id.0].rate.is_none()));
        [inputs, states]
    }

    /// The stop of a scene.
    pub fn stop_of<'a>(&'a self, scene: &'a Scene) -> Option<&'a Stop> {
        self.stops_of(scene).next()
    }

    /// Every stop that a scene calls for.
    fn stops_of<'a>(&'a self, scene: &'a Scene) -> impl Iterator<Item = &'a Stop> {
        self.stops.iter().filter(|stop| scene.calls_for(stop.effect))
    }

    /// The switches of a scene as they start, those of one row behind each other: skates hold, a stop is open. A stop with one end has no side.
    pub fn switches_of(&self, scene: &Scene) -> Vec<DeclaredSwitch> {
        let declared = |row: &Ident, start: [f64; 2], said: &[&'static str]| -> Vec<DeclaredSwitch> {
            let switches = Switch::ALL.iter().zip(start).zip(said);
            let declare = |((switch, start), said): ((&Switch, f64), &&'static str)| DeclaredSwitch {
                of: row.to_string(),
                switch: *switch,
                name: format!("{row}_{}", switch.suffix()),
                start,
                documentation: said,
            };
            switches.map(declare).collect()
        };
        let sides = "1 while it slides to the left of its direction, -1 to the right, else 0";
        let of_skates = ["1 while it holds, 0 while it slides", sides];
        let skates = self.limited_skates_of(scene).flat_map(|(row, _)| declared(&row.name, [1.0, 0.0], &of_skates));
        let of_stop = ["1 while it holds, 0 while it is open", "1 at the lower end, -1 at the upper one"];
        let stop = self.stop_of(scene).into_iter();
        let stop = stop.flat_map(|stop| declared(&stop.name, [0.0, 0.0], &of_stop[..stop.ends().count()]));
        skates.chain(stop).collect()
    }

    /// The skates of a scene that hold up to a limit, and their limits.
    pub fn limited_skates_of<'a>(&'a self, scene: &'a Scene) -> impl Iterator<Item = (&'a Row, &'a Expr)> {
        self.rows_of(scene).filter_map(|(_, row)| Some((row, row.limit()?)))
    }
}

/// A scalar expression with every name resolved.
#[derive(Debug, Clone)]
pub enum Expr {
    /// A literal; exact decimals as written keep their nearest f64.
    Number(f64),
    Pi,
    Time,
    /// In SI units.
    Parameter(ParameterId),
    /// In its unit.
    Input(InputId),
    /// A first-order state, in its unit.
    State(InputId),
    /// What turns numbers of a unit into SI units. Equations hold between quantities, so that it is not printed.
    Conversion(Unit),
    /// The value at the present time of an input `by acceleration`, or its rate; by the first of its parts.
    Integrated(InputId, Part),
    /// `body.x`, `body.y`, `body.phi`
    Coordinate(BodyId, Component),
    /// `body.vx`, `body.vy`, `body.omega`
    Velocity(BodyId, Component),
    /// `point.x`, `point.y` (world coordinates; never `Phi`)
    PointPosition(PointId, Component),
    /// `point.vx`, `point.vy`
    PointVelocity(PointId, Component),
    /// Position of a member of an array of points.
    MemberPosition(Box<Place>, Component),
    /// Velocity of a member of an array of points.
    MemberVelocity(Box<Place>, Component),
    Count(CountId),
    /// The index of a `for`, as a number.
    Index(IndexId),
    /// A quotient of whole numbers, rounded down.
    Quotient(QuotientId),
    /// `hinge.angle` = φ_b − φ_a
    HingeAngle(RowId),
    /// `hinge.rate` = φ̇_b − φ̇_a
    HingeRate(RowId),
    Neg(Box<Expr>),
    Binary(Operator, Box<Expr>, Box<Expr>),
    Call(Function, Vec<Expr>),
}

impl Expr {
    pub fn binary(operator: Operator, a: Self, b: Self) -> Self {
        Self::Binary(operator, Box::new(a), Box::new(b))
    }

    /// What an operator or a function is applied to.
    pub fn operands(&self) -> Vec<&Self> {
        match self {
            Self::Neg(a) => vec![a],
            Self::Binary(_, a, b) => vec![a, b],
            Self::Call(_, arguments) => arguments.iter().collect(),
            _ => Vec::new(),
        }
    }
}

impl Expr {
    /// Whether it depends on an index of a `for`, or on a quotient that may do so.
    pub fn reads_index(&self) -> bool {
        matches!(self, Self::Index(_) | Self::Quotient(_)) || self.operands().into_iter().any(Self::reads_index)
    }

    /// With other values of some indices.
    pub fn with_indices(&self, values: &[(IndexId, Self)]) -> Self {
        let inside = |expr: &Self| expr.with_indices(values);
        match self {
            Self::Index(id) => values.iter().find(|(index, _)| index == id).map_or(self, |(_, value)| value).clone(),
            Self::Neg(a) => -inside(a),
            Self::Binary(operator, a, b) => Self::binary(*operator, inside(a), inside(b)),
            Self::Call(function, arguments) => Self::Call(*function, arguments.iter().map(inside).collect()),
            _ => self.clone(),
        }
    }
}

impl std::ops::Neg for Expr {
    type Output = Self;

    fn neg(self) -> Self {
        Self::Neg(Box::new(self))
    }
}

macro_rules! operators {
    ($($operation:ident $method:ident $operator:ident)*) => {
        $(impl std::ops::$operation for Expr {
            type Output = Self;

            fn $method(self, other: Self) -> Self {
                Self::binary(Operator::$operator, self, other)
            }
        })*
    };
}

operators! { Add add Add  Sub sub Subtract  Mul mul Multiply  Div div Divide }
