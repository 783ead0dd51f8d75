//! Bodies.

use super::constant::{at_defaults, literal};
use super::context::{Context, Purpose};
use super::dimension::Dimension;
use super::{Expr, Row};
use crate::diag::rules;
use crate::parse::ast;

impl Context<'_> {
    /// Mass and inertia of a declared body, or of each member of a declared array.
    pub fn body_item(&mut self, array: usize, body: &ast::Body, loops: &[ast::Loop], defaults: &[f64]) {
        self.enter_array(array, loops);
        let mass = self.inertial(&body.mass, body, "mass", "kg", Dimension::MASS, defaults);
        let inertia = self.inertial(&body.inertia, body, "inertia", "kg*m^2", Dimension::INERTIA, defaults);
        if let (Some(mass), Some(inertia)) = (mass, inertia) {
            (self.arrays[array].mass, self.arrays[array].inertia) = (mass, inertia);
        }
        self.leave();
    }

    /// Mass or inertia: parameters alone, not negative as declared.
    fn inertial(
        &mut self,
        expr: &ast::Expr,
        body: &ast::Body,
        word: &str,
        unit: &str,
        dimension: Dimension,
        defaults: &[f64],
    ) -> Option<Expr> {
        let what = format!("the {word} of body `{}`", body.name.word);
        let value = self.scalar(expr, &Purpose::fixed(None, what.clone()), &what, Some(dimension))?;
        if let Some(number) = at_defaults(&value, defaults).filter(|number| *number < 0.0) {
            self.diag.error(rules::negative_mass(expr.extent(), &what, number, unit));
        }
        Some(value)
    }

    /// Bodies whose mass or inertia is written as zero need a row that holds them.
    pub fn check_massless(&mut self, bodies: &[(&ast::Body, &[ast::Loop])], rows: &[Row]) {
        for (i, (body, _)) in bodies.iter().enumerate() {
            if rows.iter().any(|row| touches(row, |body| self.slots[body.0].array == i)) {
                continue;
            }
            let array = &self.arrays[i];
            for (word, at, value) in [("mass", &body.mass, &array.mass), ("inertia", &body.inertia, &array.inertia)] {
                if literal(value) == Some(0.0) {
                    self.diag.error(rules::massless_and_free(at.extent(), &body.name, word));
                }
            }
        }
    }
}

/// Whether a row restricts a body: the bodies of an equation are not looked for.
fn touches(row: &Row, is_wanted: impl Fn(super::BodyId) -> bool) -> bool {
    row.word.may_be_unnamed() || row.arguments.all_bodies().any(is_wanted)
}

impl ast::Place {
    /// The name that a message about the place sits on.
    pub const fn owner(&self) -> &ast::Name {
        match self {
            Self::Named(name) => name,
            Self::OnBody(place) => &place.body,
        }
    }
}
