//! Skates that hold up to a limit: where they make sense.

use super::context::Context;
use super::{Model, Scene};
use crate::diag::scenes;

impl Context<'_> {
    /// Scenes have one such skate at most, and bodies of their own.
    pub fn check_grips(&mut self, model: &Model) {
        if model.is_repeated() {
            let limited = model.rows.iter().filter(|row| row.limit().is_some());
            limited.for_each(|row| self.diag.error(scenes::limit_with_counts(&row.name)));
            return;
        }
        for scene in &model.scenes {
            self.check_grips_of(model, scene);
        }
    }

    fn check_grips_of(&mut self, model: &Model, scene: &Scene) {
        let mut limited = model.rows_of(scene).filter(|(_, row)| row.limit().is_some());
        let Some((_, first)) = limited.next() else { return };
        if let Some((_, second)) = limited.next() {
            self.diag.error(scenes::two_limits(&scene.name, &first.name, &second.name));
        }
    }
}
