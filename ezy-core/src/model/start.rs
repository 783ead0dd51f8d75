//! Start values, which a scene prescribes or a user gives.

use super::body_kind::set_upright;
use super::scene_info::SceneInfo;
use super::{LayoutFault, Scene};

/// Start values that a scene prescribes. What is not given is assembled from the constraints.
#[derive(Debug, Clone, PartialEq)]
pub struct Start {
    /// Start time, s.
    pub t: f64,
    /// `n_q` coordinates; a guess where not given.
    pub q: Vec<f64>,
    /// Which coordinates are given.
    pub q_given: Vec<bool>,
    /// `n_v` velocities; a guess where not given.
    pub v: Vec<f64>,
    /// Which velocities are given.
    pub v_given: Vec<bool>,
    /// Which given coordinates may change when the constraints cannot be satisfied with them.
    pub q_near: Vec<bool>,
    /// Which given velocities may change then.
    pub v_near: Vec<bool>,
    /// `n_z` first-order states; empty for those that are declared.
    pub z: Vec<f64>,
}

impl Start {
    /// Nothing given, everything zero, with as many velocities as coordinates.
    pub fn free(n_coordinates: usize) -> Self {
        Self::of(n_coordinates, n_coordinates)
    }

    /// Nothing given, everything zero, for a scene; bodies in space have the axes of the ground.
    pub fn free_of(info: &SceneInfo) -> Self {
        let mut start = Self::of(info.n_coordinates(), info.n_velocities());
        set_upright(&info.kinds, &mut start.q);
        start
    }

    /// That which a scene declares.
    ///
    /// # Errors
    /// [`LayoutFault`] when the counts of the scene cannot be used.
    pub fn declared<S: Scene + ?Sized>(scene: &S) -> Result<Self, LayoutFault> {
        let info = scene.info();
        info.check_counts()?;
        let mut c = info.declared_values();
        scene.constants(&scene.parameters(), &mut c);
        Ok(Self::declared_with(scene, &info, &c))
    }

    /// The same with constants, and inputs, that are there already.
    pub(crate) fn declared_with<S: Scene + ?Sized>(scene: &S, info: &SceneInfo, c: &[f64]) -> Self {
        let mut start = Self::free_of(info);
        start.z.extend(info.states.iter().map(|state| state.default));
        scene.start(c, &mut start);
        start
    }

    /// Nothing given, everything zero, for so many coordinates and velocities.
    pub(crate) fn of(n_coordinates: usize, n_velocities: usize) -> Self {
        Self {
            t: 0.0,
            q: vec![0.0; n_coordinates],
            q_given: vec![false; n_coordinates],
            v: vec![0.0; n_velocities],
            v_given: vec![false; n_velocities],
            q_near: vec![false; n_coordinates],
            v_near: vec![false; n_velocities],
            z: Vec::new(),
        }
    }

    /// Takes the values of a start of the same scene, without allocation.
    pub(crate) fn copy_from(&mut self, other: &Self) {
        self.t = other.t;
        self.q.copy_from_slice(&other.q);
        self.v.copy_from_slice(&other.v);
        self.q_given.copy_from_slice(&other.q_given);
        self.v_given.copy_from_slice(&other.v_given);
        self.q_near.copy_from_slice(&other.q_near);
        self.v_near.copy_from_slice(&other.v_near);
        self.z.clone_from(&other.z);
    }

    /// The same start with the values that are near made free; `None` when there are none.
    pub(crate) fn without_near(&self) -> Option<Self> {
        if !self.q_near.iter().chain(&self.v_near).any(|near| *near) {
            return None;
        }
        let mut free = self.clone();
        free.q_given.iter_mut().zip(&self.q_near).for_each(|(given, near)| *given &= !near);
        free.v_given.iter_mut().zip(&self.v_near).for_each(|(given, near)| *given &= !near);
        Some(free)
    }

    /// Lets all given values change, as little as the constraints demand, when these cannot be satisfied with them.
    pub fn give_way(&mut self) {
        self.q_near.copy_from_slice(&self.q_given);
        self.v_near.copy_from_slice(&self.v_given);
    }

    /// Holds coordinate `i` at `value`.
    pub fn give_position(&mut self, i: usize, value: f64) {
        self.q[i] = value;
        self.q_given[i] = true;
        self.q_near[i] = false;
    }

    /// Holds velocity `i` at `value`.
    pub fn give_velocity(&mut self, i: usize, value: f64) {
        self.v[i] = value;
        self.v_given[i] = true;
        self.v_near[i] = false;
    }

    /// Lets first-order state `i` of the scene begin with `value`, in its unit.
    ///
    /// # Panics
    /// If the scene has no such state.
    pub fn give_state(&mut self, info: &SceneInfo, i: usize, value: f64) {
        let declared = info.states.iter().skip(self.z.len()).map(|state| state.default);
        self.z.extend(declared);
        self.z[i] = value;
    }

    /// Holds coordinate `i` at `value` if the constraints can be satisfied with it.
    pub fn near_position(&mut self, i: usize, value: f64) {
        self.give_position(i, value);
        self.q_near[i] = true;
    }

    /// Holds velocity `i` at `value` if the constraints can be satisfied with it.
    pub fn near_velocity(&mut self, i: usize, value: f64) {
        self.give_velocity(i, value);
        self.v_near[i] = true;
    }
}
