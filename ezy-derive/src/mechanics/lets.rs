//! The `let` values of a scene, for printed equations.

use super::expression::Writer;
use super::symbols::{Let, Symbols};
use crate::model::{Model, Scene};
use crate::symbolic::coefficient::CoefficientNode;
use crate::symbolic::{Algebra, spelling};

/// Writes the `let` values of the model and of the scene's effects, last: what is derived does not depend on them.
pub fn write_lets(model: &Model, scene: &Scene, algebra: &mut Algebra, symbols: &mut Symbols) {
    let mut writer = Writer::new(model, algebra, symbols);
    let of_scene = model.lets.iter().filter(|value| scene.calls_for(value.effect));
    let lets = of_scene.map(|named| {
        let value = writer.write(&named.value);
        let coefficient = writer.algebra.as_coefficient(value).filter(|k| {
            use CoefficientNode::{Add, Call, Div, Mul};
            // a number is no quantity of its own, and a parameter has its name
            matches!(writer.algebra.coefficients.node(k.id), Add(..) | Mul(..) | Div(..) | Call(..))
        });
        Let { name: spelling::name(&named.name), value, coefficient }
    });
    let lets = lets.collect();
    symbols.name_lets(lets);
}
