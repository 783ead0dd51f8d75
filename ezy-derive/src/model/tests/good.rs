//! Texts without faults.

use super::{EZY_ROLLER, good};

#[test]
fn analytic_model_of_ezy_roller_has_every_item() {
    let model = good(EZY_ROLLER);
    let counts = [model.bodies.len(), model.parameters.len(), model.points.len(), model.rows.len()];
    assert_eq!(counts, [2, 11, 3, 3]);
    let counts = [model.forces.len(), model.effects.len(), model.starts.len(), model.scenes.len()];
    assert_eq!(counts, [2, 2, 2, 3]);
}
