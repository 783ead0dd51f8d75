//! Which rows hold: those that a run has switched on, and of rows that depend on each other those that a step keeps to.

use crate::model::SceneInfo;

/// The rows of a scene that take part.
pub(crate) struct ActiveSet {
    /// Parameters, then switches: what the constants of the scene are computed from.
    parameters: Vec<f64>,
    /// Rows that are switched off, ascending: their equations are 0 = 0.
    off: Vec<usize>,
    n_on: [usize; 2],
    /// The independent rows at the start of a step, where others were redundant.
    pub(super) held: Vec<usize>,
}

impl ActiveSet {
    /// As the scene starts, with these parameters and its switches.
    pub(super) fn new(info: &SceneInfo, parameters: &[f64]) -> Self {
        let mut new = Self { parameters: parameters.to_vec(), off: Vec::new(), n_on: [0; 2], held: Vec::new() };
        new.find_off(info);
        new
    }

    /// Parameters, then switches as they are now.
    #[cfg(feature = "analysis")]
    pub(super) fn parameters(&self) -> &[f64] {
        &self.parameters
    }

    /// Parameters with every row switched on.
    pub(super) fn with_all_rows(&self, info: &SceneInfo) -> Vec<f64> {
        let mut parameters = self.parameters.clone();
        parameters[info.parameters.len()..].fill(1.0);
        parameters
    }

    /// Rows that are switched off, ascending.
    pub(super) fn off(&self) -> &[usize] {
        &self.off
    }

    /// How many position constraints, and how many rows, are not switched off.
    pub(crate) fn n_on(&self) -> [usize; 2] {
        self.n_on
    }

    /// Whether rows were redundant at the start of the step: those that depend on others are left out.
    #[inline]
    pub(crate) fn leaves_out_redundant(&self) -> bool {
        !self.held.is_empty()
    }

    /// Switches a row; the constants of the scene are then to be computed from what is returned.
    pub(super) fn switch(&mut self, info: &SceneInfo, row: usize, holds: bool, side: f64) -> &[f64] {
        let switches = self.parameters[info.parameters.len()..].iter_mut().zip(info.switches);
        let of_row = switches.filter(|(_, switch)| switch.row == row);
        // a stop with one end has no side
        of_row.zip([f64::from(u8::from(holds)), side]).for_each(|((present, _), value)| *present = value);
        self.find_off(info);
        self.held.clear();
        &self.parameters
    }

    fn find_off(&mut self, info: &SceneInfo) {
        self.off.clear();
        let switches = &self.parameters[info.parameters.len()..];
        self.off.extend(info.holding_switches().filter(|&(i, _)| switches[i] == 0.0).map(|(_, switch)| switch.row));
        self.off.sort_unstable();
        self.n_on = [info.n_position_rows, info.n_rows()].map(|n| n - self.off.iter().filter(|row| **row < n).count());
    }
}

#[cfg(test)]
mod tests {
    use crate::dynamics::system_of;
    use crate::dynamics::{Metric, Projection, System};
    use crate::linalg::{Backend, INDEPENDENT, Independent};
    use crate::model::Scene;

    crate::model! {
        /// A bead on a rail, and a stop across it.
        model Bead {
            param wall: m = 0.75;
            body bead { mass: 2, inertia: 1 }
            constraint rail: bead.y = 0;
            stop end: bead.x from -wall to wall restitution 0.5;
            effect push { force at bead(0, 0): (6 N, 0); }
            start middle { bead at (0.5, 0) angle 0; bead velocity (1, 0) rate 0; }
            scene slides { start middle; until 1 s; with push; }
        }
    }

    /// The rank, the redundant rows, the acceleration along the rail and the multiplier of the stop.
    fn seen(system: &mut System<&dyn Scene>, q: &[f64], v: &[f64]) -> (usize, usize, f64, f64) {
        let found =
            system.at(0.0, q).rank(Independent::Above(INDEPENDENT)).map(|found| (found.rank(), found.n_redundant()));
        let (rank, redundant) = found.unwrap();
        let (mut a, mut lambda) = ([0.0; 3], [0.0; 2]);
        system.accelerations(0.0, q, v, &mut a, &mut lambda).unwrap();
        let stop = system.info().stop.unwrap().row;
        (rank, redundant, a[0], lambda[stop])
    }

    /// A row that is off is no redundant one, and no force; on a side it holds the bead at that bound, whatever solves.
    #[test]
    fn analytic_switched_row_holds_its_side() {
        let scene = bead::Slides::default();
        for backend in [Backend::Auto, Backend::Dense] {
            let mut system = system_of(&scene, backend).unwrap();
            let (mut q, mut v) = ([0.5, 0.0, 0.0], [1.0, 0.0, 0.0]);
            let (rank, redundant, a, lambda) = seen(&mut system, &q, &v);
            assert_eq!((rank, redundant, lambda), (1, 0, 0.0));
            assert!((a - 3.0).abs() <= 1e-15, "{a}");

            system.switch(1, true, -1.0);
            system.project(0.0, &mut q, &mut v, Projection::Both, Metric::Mass).unwrap();
            assert!((q[0] - 0.75).abs() <= 1e-15 && v[0].abs() <= 1e-15, "{q:?} {v:?}");
            let (rank, redundant, a, lambda) = seen(&mut system, &q, &v);
            assert_eq!((rank, redundant), (2, 0));
            assert!(a.abs() <= 1e-15 && (lambda - 6.0).abs() <= 1e-14, "{a} {lambda}");

            system.switch(1, false, 0.0);
            let (rank, redundant, a, lambda) = seen(&mut system, &q, &v);
            assert_eq!((rank, redundant, lambda), (1, 0, 0.0));
            assert!((a - 3.0).abs() <= 1e-15, "{a}");
        }
    }

    /// What a system is measured by does not depend on whether its row holds at the start.
    #[test]
    fn invariant_a_row_that_is_off_has_its_size() {
        let scene = bead::Slides::default();
        let system = system_of(&scene, Backend::Auto).unwrap();
        let stop = system.info().stop.unwrap().row;
        assert_eq!(system.geometry.sizes[stop], system.geometry.length);
    }
}
