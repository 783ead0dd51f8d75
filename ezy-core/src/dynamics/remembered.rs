//! What a system knows of a motion besides its state.

use super::System;
use super::solved::Rows;
use crate::archive::Archive;
use crate::model::SceneRef;

impl<P: SceneRef> System<P> {
    /// Writes it, or reads it from a system of the same scene. Factors are made again where they were made.
    pub(crate) fn remember(&mut self, archive: &mut Archive) {
        let (n_set, n_rows) = (self.info.n_inputs() + self.info.n_states(), self.info.n_rows());
        archive.numbers(&mut self.fixed[..n_set]);
        archive.numbers(self.integrated.as_flattened_mut());
        archive.places(&mut self.active.held, n_rows);
        let factored = self.factors.factored;
        let mut t = if factored.is_some() { self.factors.t } else { f64::NAN };
        archive.number(&mut t);
        archive.numbers(&mut self.factors.q);
        let mut of_rows = [Rows::Projected, Rows::Held].map(|rows| factored == Some(rows));
        of_rows.iter_mut().for_each(|is_it| archive.flag(is_it));
        if archive.is_read() {
            let q = self.factors.q.clone();
            let rows = match of_rows {
                [true, _] => Rows::Projected,
                [_, true] => Rows::Held,
                _ => Rows::Exact,
            };
            let counters = self.counters;
            self.factors.forget();
            if t.is_finite() && self.at_with(t, &q, rows).factor().is_err() {
                self.factors.forget();
            }
            self.counters = counters;
        }
        self.factors.ahead.remember(archive);
    }
}
