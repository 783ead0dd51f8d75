//! Bodies and rows.

use super::constant::at_defaults;
use super::context::{Context, Purpose};
use super::dimension::Dimension;
use super::{Body, Row, RowId, RowKind};
use crate::diag::{Extent, rules};
use crate::parse::ast;

impl Context<'_> {
    pub fn body_item(&mut self, body: &ast::Body, defaults: &[f64]) -> Option<Body> {
        let mass = self.inertial(&body.mass, body, "mass", "kg", Dimension::MASS, defaults);
        let inertia = self.inertial(&body.inertia, body, "inertia", "kg*m^2", Dimension::INERTIA, defaults);
        Some(Body { name: body.name.clone(), mass: mass?, inertia: inertia? })
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
    ) -> Option<super::Expr> {
        let what = format!("the {word} of body `{}`", body.name);
        let value = self.scalar(expr, &Purpose::fixed(None, what.clone()), &what, Some(dimension))?;
        if let Some(number) = at_defaults(&value, defaults).filter(|number| *number < 0.0) {
            self.diag.error(rules::negative_mass(expr.extent(), &what, number, unit));
        }
        Some(value)
    }

    pub fn hinge(&mut self, hinge: &ast::Hinge, id: RowId) -> Option<Row> {
        let point = match self.names.lookup(None, &hinge.name) {
            Some(super::names::Symbol::Hinge(row, point)) if row == id => Some(point),
            _ => None, // its name is taken, which has been reported
        };
        let a = match point {
            Some(point) => self.point_place(point, &hinge.name),
            None => self.place(&hinge.a, None),
        };
        let b = self.place(&hinge.b, None);
        let (a, b) = (a?, b?);
        if a.body == b.body {
            let body = hinge.b.owner();
            self.diag.error(rules::hinge_within_body(body, &hinge.name, a.body.is_none()));
            return None;
        }
        Some(Row { name: hinge.name.clone(), kind: RowKind::Hinge { a, b } })
    }

    pub fn skate(&mut self, skate: &ast::Skate) -> Option<Row> {
        let at = self.place(&skate.at, None);
        let along = self.direction(&skate.along, None);
        let (at, along) = (at?, along?);
        if at.body.is_none() {
            self.diag.error(rules::skate_on_ground(skate.at.owner(), &skate.name));
            return None;
        }
        Some(Row { name: skate.name.clone(), kind: RowKind::Skate { at, along } })
    }

    /// Bodies whose mass or inertia is written as zero need a row that holds them.
    pub fn check_massless(&mut self, bodies: &[(&ast::Body, Body)], rows: &[Row]) {
        for (i, (source, body)) in bodies.iter().enumerate() {
            let held = rows.iter().any(|row| {
                let touched = match &row.kind {
                    RowKind::Hinge { a, b } => [a.body, b.body],
                    RowKind::Skate { at, along } => [at.body, along.body],
                };
                touched.contains(&Some(super::BodyId(i)))
            });
            if held {
                continue;
            }
            for (word, expr, value) in [("mass", &source.mass, &body.mass), ("inertia", &source.inertia, &body.inertia)]
            {
                if at_defaults(value, &[]) == Some(0.0) {
                    let at: Extent = expr.extent();
                    self.diag.error(rules::massless_and_free(at, &body.name, word));
                }
            }
        }
    }
}

impl ast::Place {
    /// The name that a message about the place sits on.
    pub const fn owner(&self) -> &proc_macro2::Ident {
        match self {
            Self::Named(name) => name,
            Self::OnBody(place) => &place.body,
        }
    }
}
