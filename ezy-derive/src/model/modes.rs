//! Skates with a limit, and stops: they give a scene several modes.

use super::context::Context;
use super::{Model, Scene};
use crate::diag::scenes;
use proc_macro2::Ident;

/// Something that a scene has one of at most.
struct Changing<'a> {
    name: &'a Ident,
    /// "skate" or "stop".
    what: &'static str,
}

impl Context<'_> {
    /// Scenes have one skate with a limit or one stop at most, and bodies of their own.
    pub fn check_modes(&mut self, model: &Model) {
        if model.is_repeated() {
            let limited = model.rows.iter().filter(|row| row.limit().is_some());
            limited.for_each(|row| self.diag.error(scenes::limit_with_counts(&row.name)));
            model.stops.iter().for_each(|stop| self.diag.error(scenes::stop_with_counts(&stop.name)));
            return;
        }
        for scene in &model.scenes {
            if let [first, second, ..] = &changing(model, scene)[..] {
                let (first, second) = ((first.name, first.what), (second.name, second.what));
                self.diag.error(scenes::two_changing(&scene.name, first, second));
            }
        }
    }
}

fn changing<'a>(model: &'a Model, scene: &'a Scene) -> Vec<Changing<'a>> {
    let limited = model.rows_of(scene).filter(|(_, row)| row.limit().is_some());
    let skates = limited.map(|(_, row)| Changing { name: &row.name, what: "skate" });
    skates.chain(model.stops_of(scene).map(|stop| Changing { name: &stop.name, what: "stop" })).collect()
}
