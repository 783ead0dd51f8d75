//! What a controller sees.

use super::control::Controlled;
use crate::dynamics::State;
use crate::model::NamedScene;
use std::cell::{Cell, OnceCell};
use std::ops::Deref;

/// The inputs of a scene by the names of its model file.
pub type Inputs<S> = <S as NamedScene>::Inputs;

/// The present state of a scene, by the names of its model file: `now.t`, `now.seat.x`, `now.outputs().angle`.
///
/// Every body of the model is a field, a [`BodyState`](crate::model::BodyState); an array of bodies is a
/// [`BodyArray`](crate::model::BodyArray).
pub struct Now<'a, S: NamedScene + ?Sized> {
    /// Time, s.
    pub t: f64,
    bodies: S::Bodies<'a>,
    state: &'a State,
    scene: &'a S,
    controlled: &'a dyn Controlled,
    /// Room for the outputs, taken when they are asked for.
    room: Cell<&'a mut [f64]>,
    outputs: OnceCell<&'a [f64]>,
}

impl<'a, S: NamedScene + ?Sized> Now<'a, S> {
    /// `room` has place for the outputs of the scene.
    pub(in crate::simulate) fn new(
        scene: &'a S,
        state: &'a State,
        controlled: &'a dyn Controlled,
        room: &'a mut [f64],
    ) -> Self {
        let bodies = scene.bodies_by_name(&state.q, &state.v);
        let (room, outputs) = (Cell::new(room), OnceCell::new());
        Self { t: state.t, bodies, state, scene, controlled, room, outputs }
    }

    /// The outputs of the scene, each in its unit, with the inputs that hold now: those of the step before, and of tables
    /// that were read for this one. They are computed at the first call.
    pub fn outputs(&self) -> S::Outputs<'a> {
        let values = self.outputs.get_or_init(|| {
            let room = self.room.take();
            self.controlled.outputs(self.state, room);
            room
        });
        self.scene.outputs_by_name(values)
    }

    /// Time, all coordinates, all velocities, first-order states, and works, by index.
    pub fn state(&self) -> &'a State {
        self.state
    }
}

impl<'a, S: NamedScene + ?Sized> Deref for Now<'a, S> {
    type Target = S::Bodies<'a>;

    fn deref(&self) -> &S::Bodies<'a> {
        &self.bodies
    }
}
