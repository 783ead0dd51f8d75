//! Wheels that a weld keeps from turning: the row compiles, and the vehicle hardly moves.

use crate::diag::{Diagnostics, equations as message};
use crate::model::{BodyId, Component, Expr, Model};

/// Warns of a weld between the body that rolls and the body by whose rate it rolls, each once.
pub fn wheels(model: &Model, diag: &mut Diagnostics) {
    let mut reported = Vec::new();
    for scene in &model.scenes {
        let of_word = |word| model.rows_of(scene).filter(move |(_, row)| row.word.word == word);
        for (id, weld) in of_word("weld") {
            let [Some(a), Some(b)] = [0, 1].map(|i| weld.arguments.places.get(i).and_then(|place| place.body)) else {
                continue;
            };
            let turns = |roll: &crate::model::Row, carrier: BodyId, wheel: BodyId| {
                let on_carrier = roll.arguments.places.first().is_some_and(|place| place.body == Some(carrier));
                on_carrier && roll.arguments.scalars.iter().any(|speed| reads_rate(speed, wheel))
            };
            let found = of_word("roll").find(|(_, roll)| turns(roll, a, b) || turns(roll, b, a));
            if let Some((_, roll)) = found.filter(|_| !reported.contains(&id)) {
                reported.push(id);
                diag.warning(message::welded_wheel(&weld.name, &roll.name.to_string()));
            }
        }
    }
}

fn reads_rate(expr: &Expr, of: BodyId) -> bool {
    matches!(expr, Expr::Velocity(body, Component::Phi) if *body == of)
        || expr.operands().into_iter().any(|operand| reads_rate(operand, of))
}
