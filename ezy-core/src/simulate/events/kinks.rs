//! Kinks of laws: a step that goes over one is made again up to it.
//!
//! Across a kink a method of high order has a low one: its error estimate may miss that, or halve the steps until they
//! have crept over. Where the values of the scene say that a step went over a kink, its interpolation tells where.

use super::root::root;
use super::{RESOLUTION_S, side_of};
use crate::dynamics::{State, System};
use crate::integrate::{Knot, interpolate};
use crate::model::{EventKind, Scene, SceneInfo};

/// A kink this close to an end of a step is left to the step control, in resolutions of its place.
const AT_END: f64 = 10.0;

/// So much behind a kink steps end, in resolutions: the next one begins on its other side.
const BEHIND: f64 = 2.0;

/// The kinks of a scene, with room to look for them.
pub(in crate::simulate) struct Kinks {
    /// Places among the events.
    places: Vec<usize>,
    /// Values at the start of the step, at its end, and between.
    values: [Vec<f64>; 3],
    a: Vec<f64>,
    lambda: Vec<f64>,
    between: State,
}

impl Kinks {
    pub fn new(info: &SceneInfo) -> Self {
        let is_kink = |&i: &usize| info.events[i].kind == EventKind::Kink;
        let places: Vec<usize> = (0..info.events.len()).filter(is_kink).collect();
        // without kinks there is nothing to look for
        let [n_s, n_q, n_c] =
            [info.events.len(), info.n_coordinates(), info.n_rows()].map(|n| if places.is_empty() { 0 } else { n });
        let zeros = |n: usize| vec![0.0; n];
        Self {
            places,
            values: [zeros(n_s), zeros(n_s), zeros(n_s)],
            a: zeros(n_q),
            lambda: zeros(n_c),
            between: State::zero(n_q, 0),
        }
    }

    /// Length of the step from `from` that ends at the first kink, s, where the step to `end` goes over one.
    pub fn up_to<S: Scene + ?Sized>(&mut self, system: &mut System<'_, S>, from: Knot<'_>, end: &State) -> Option<f64> {
        let Self { places, values, a, lambda, between } = self;
        if places.is_empty() {
            return None;
        }
        let [before, after, inside] = values;
        system.events(from.state.t, &from.state.q, &from.state.v, before);
        system.events(end.t, &end.q, &end.v, after);
        places.iter().find(|&&i| side_of(before[i]) * side_of(after[i]) < 0.0)?;
        system.accelerations(end.t, &end.q, &end.v, a, lambda).ok()?;
        let (start, last) = (from.state.t, end.t);
        // works do not matter here
        let to = Knot { state: end, a, power: from.power };
        let resolution = RESOLUTION_S.max(2.0 * f64::EPSILON * last.abs());
        let mut first = last;
        for &i in places.iter().filter(|&&i| side_of(before[i]) * side_of(after[i]) < 0.0) {
            let Ok(t) = root((start, before[i]), (last, after[i]), resolution, |t| {
                interpolate(from, to, t, between);
                system.events(t, &between.q, &between.v, inside);
                Ok::<f64, std::convert::Infallible>(inside[i])
            });
            first = first.min(t);
        }
        let near = AT_END * resolution;
        let length = first - start;
        (length > near && last - first > near).then_some(length + BEHIND * resolution)
    }
}
