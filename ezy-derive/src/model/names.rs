//! Name tables. A model has one set of names for everything that expressions and points can use; each effect adds its
//! own.

use super::whole::CountId;
use super::{BodyId, EffectId, InputId, ParameterId, PointId, RowId};
use crate::diag::{Diagnostics, names as message};
use proc_macro2::{Ident, Span};

/// Names with a meaning of their own.
const RESERVED: [(&str, &str); 3] = [("t", "the time"), ("pi", "the number π"), ("ground", "what does not move")];

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Symbol {
    Body(BodyId),
    /// An array of bodies.
    Bodies(usize),
    Count(CountId),
    Parameter(ParameterId),
    Input(InputId),
    /// A first-order state, in the list of inputs.
    State(InputId),
    Output,
    /// Place among the declared events, with the effect that declares it.
    Event(usize, Scope),
    Stop,
    Let(usize),
    Point(PointId),
    Hinge(RowId, PointId),
    /// Points that are declared in a `for`.
    Points(usize),
    /// Hinges that are declared in a `for`.
    Hinges(RowId, usize),
    /// A row that is no point, and its word.
    Row(RowId, &'static str),
    /// Its declaration could not be read; uses give no further errors.
    Broken,
}

impl Symbol {
    /// In a sentence: ``"`rear` is " + …``.
    pub const fn what(self) -> &'static str {
        match self {
            Self::Body(_) => "a body",
            Self::Bodies(_) => "an array of bodies",
            Self::Count(_) => "a count",
            Self::Points(_) => "an array of points",
            Self::Hinges(..) => "an array of hinges",
            Self::Parameter(_) => "a parameter",
            Self::Input(_) => "an input",
            Self::State(_) => "a state",
            Self::Output => "an output",
            Self::Event(..) => "an event",
            Self::Stop => "a stop",
            Self::Let(_) => "a value",
            Self::Point(_) => "a point",
            Self::Hinge(..) => "a hinge",
            Self::Row(_, word) => a_row(word),
            Self::Broken => "not readable",
        }
    }

    const fn is_value(self) -> bool {
        matches!(self, Self::Parameter(_) | Self::Count(_) | Self::Input(_) | Self::State(_) | Self::Let(_))
    }

    const fn is_place(self) -> bool {
        matches!(self, Self::Point(_) | Self::Points(_) | Self::Hinge(..) | Self::Hinges(..))
    }
}

const fn a_row(word: &str) -> &'static str {
    match word.as_bytes() {
        b"skate" => "a skate",
        b"rod" => "a rod",
        _ => "a constraint",
    }
}

#[derive(Debug)]
struct Declared {
    name: String,
    span: Span,
    symbol: Symbol,
    /// A use is ambiguous, so that uses give no further errors.
    twice: bool,
}

/// `None` is the model, otherwise an effect.
pub type Scope = Option<EffectId>;

#[derive(Debug, Default)]
pub struct Names {
    model: Vec<Declared>,
    effects: Vec<Vec<Declared>>,
    effect_names: Vec<String>,
}

impl Names {
    /// Makes room for the names of one more effect.
    pub fn open_effect(&mut self, name: &Ident) {
        self.effect_names.push(name.to_string());
        self.effects.push(Vec::new());
    }

    /// Declares `name`, unless it is taken.
    pub fn declare(&mut self, scope: Scope, name: &Ident, symbol: Symbol, diag: &mut Diagnostics) {
        let text = name.to_string();
        if let Some((_, meaning)) = RESERVED.iter().find(|(reserved, _)| *reserved == text) {
            diag.error(message::reserved(name, meaning));
            return;
        }
        if let Some(first) = self.find_mut(scope, &text) {
            first.twice = true;
            diag.error(message::declared_twice(name, first.symbol.what(), first.span));
            return;
        }
        let declared = Declared { name: text, span: name.span(), symbol, twice: false };
        match scope {
            None => self.model.push(declared),
            Some(effect) => self.effects[effect.0].push(declared),
        }
    }

    /// Suppresses errors for uses of `name`, unless something else has this name.
    pub fn declare_broken(&mut self, name: &Ident) {
        let text = name.to_string();
        if self.find(None, &text).is_none() {
            self.model.push(Declared { name: text, span: name.span(), symbol: Symbol::Broken, twice: false });
        }
    }

    /// Whether an effect itself declares `name`.
    pub fn is_of_effect(&self, effect: EffectId, name: &Ident) -> bool {
        self.effects[effect.0].iter().any(|declared| name == &declared.name)
    }

    pub fn lookup(&self, scope: Scope, name: &Ident) -> Option<Symbol> {
        let declared = self.find(scope, &name.to_string())?;
        Some(if declared.twice { Symbol::Broken } else { declared.symbol })
    }

    /// The message for a name that is not found: it may be known in an effect alone.
    pub fn unknown(&self, name: &Ident, otherwise: impl FnOnce(&Self) -> syn::Error) -> syn::Error {
        let found = self.effects.iter().zip(&self.effect_names).find_map(|(declared, effect)| {
            let declared = declared.iter().find(|declared| name == &declared.name)?;
            Some(message::of_another_effect(name, declared.symbol.what(), effect))
        });
        found.unwrap_or_else(|| otherwise(self))
    }

    pub fn bodies(&self) -> Vec<&str> {
        of_kind(&self.model, |symbol| matches!(symbol, Symbol::Body(_) | Symbol::Bodies(_)))
    }

    pub fn places(&self) -> Vec<&str> {
        of_kind(&self.model, Symbol::is_place)
    }

    /// Parameters, inputs, states and `let` values.
    pub fn values(&self, scope: Scope) -> Vec<&str> {
        of_kind(self.visible(scope), Symbol::is_value)
    }

    /// Every event, those of effects too.
    pub fn events(&self) -> Vec<&str> {
        of_kind(self.model.iter().chain(self.effects.iter().flatten()), |symbol| matches!(symbol, Symbol::Event(..)))
    }

    /// The event of this name, of the model or of one of its effects.
    pub fn event(&self, name: &Ident) -> Option<Symbol> {
        let all = self.model.iter().chain(self.effects.iter().flatten());
        let named: Vec<_> = all.filter(|declared| name == &declared.name).collect();
        let event = named.iter().find(|declared| matches!(declared.symbol, Symbol::Event(..)));
        event.or(named.first()).map(|declared| if declared.twice { Symbol::Broken } else { declared.symbol })
    }

    /// Everything that can be released.
    pub fn rows(&self, scope: Scope) -> Vec<&str> {
        let is_row = |symbol| matches!(symbol, Symbol::Hinge(..) | Symbol::Hinges(..) | Symbol::Row(..));
        of_kind(self.visible(scope), is_row)
    }

    /// Everything that can stand before a dot.
    pub fn owners(&self) -> Vec<&str> {
        [self.bodies(), self.places()].concat()
    }

    fn find(&self, scope: Scope, name: &str) -> Option<&Declared> {
        self.visible(scope).find(|declared| declared.name == name)
    }

    fn find_mut(&mut self, scope: Scope, name: &str) -> Option<&mut Declared> {
        let own = scope.and_then(|effect| self.effects.get_mut(effect.0));
        own.into_iter().flatten().chain(&mut self.model).find(|declared| declared.name == name)
    }

    fn visible(&self, scope: Scope) -> impl Iterator<Item = &Declared> {
        let own = scope.and_then(|effect| self.effects.get(effect.0));
        own.into_iter().flatten().chain(&self.model)
    }
}

fn of_kind<'d>(declared: impl IntoIterator<Item = &'d Declared>, is_wanted: impl Fn(Symbol) -> bool) -> Vec<&'d str> {
    let wanted = declared.into_iter().filter(|declared| is_wanted(declared.symbol));
    wanted.map(|declared| declared.name.as_str()).collect()
}
