//! What a scene says about itself: names, sizes, formulas, equations.

use super::body_kind::{BodyKind, Component};
use super::event::{EventInfo, StickSlipInfo, StopInfo};
use super::repeats::{CountInfo, LayoutFault, Repeats};
use super::series::SeriesInfo;
use super::{
    Abbreviation, CoordinateInfo, EffectInfo, EliminationStep, Equation, Formula, InputInfo, List, Name, Operations,
    OutputInfo, ParameterInfo, PointInfo, QuasiVelocitiesInfo, RowInfo, SparsityPattern, StateInfo, SwitchInfo,
};

/// Everything about a scene that does not depend on parameters: known at compile time or, for a scene with counts, made
/// when it is used with these counts.
#[derive(Debug, Clone)]
pub struct SceneInfo {
    /// Name of the model type, as written: `EzyRoller`.
    pub model: &'static str,
    /// Name of the scene, as written: `driven`.
    pub name: &'static str,
    /// Doc comment of the scene.
    pub documentation: &'static str,
    /// Hash of the words of the model file, without comments and documentation (FNV-1a, 64 bits); 0 of a scene written by hand.
    pub fingerprint: u64,
    /// Bodies in declared order; planar body `i` has the coordinates x, y and φ at `3 i`, `3 i + 1`, `3 i + 2`.
    pub bodies: List<Name>,
    /// The kind of each body; none where all are planar, as in every scene that `model!` generates.
    pub kinds: List<BodyKind>,
    /// `n_q` coordinates.
    pub coordinates: List<CoordinateInfo>,
    /// `n_v` velocities; in a scene of planar bodies those of the coordinates.
    pub velocities: List<CoordinateInfo>,
    /// `n_p` named points; a hinge is listed by its point on the first body.
    pub points: List<PointInfo>,
    /// `n_c` rows, position constraints first.
    pub rows: List<RowInfo>,
    /// `n_h`, the number of position constraints.
    pub n_position_rows: usize,
    /// Parameters of the model and of the scene's effects.
    pub parameters: &'static [ParameterInfo],
    /// `n_i` inputs of the model and of the scene's effects.
    pub inputs: &'static [InputInfo],
    /// Places of the inputs that a run integrates (`by acceleration`). Behind each stand its rate, its acceleration, and the time of value
    /// and rate, as inputs of their own.
    pub integrated_inputs: &'static [usize],
    /// `n_z` first-order states of the model and of the scene's effects.
    pub states: &'static [StateInfo],
    /// `n_o` outputs of the model and of the scene's effects.
    pub outputs: List<OutputInfo>,
    /// `n_s` events of the model and of the scene's effects, then the conditions that end this scene, then the discontinuities of
    /// its forces; a scene with counts does not know its discontinuities.
    pub events: &'static [EventInfo],
    /// The skates with a limit (stick–slip friction).
    pub limited_skates: &'static [StickSlipInfo],
    /// The stop (unilateral contact), if there is one.
    pub stop: Option<&'static StopInfo>,
    /// How the rows of those skates and of that stop take part, those of one row behind each other: first whether it holds, 1 or 0; then its
    /// side, which a stop with one end does not have: 1 while a skate slides to the left and for the lower end, -1 to the right and for the
    /// upper one.
    pub switches: &'static [SwitchInfo],
    /// `n_e` groups of forces that do work: those outside any effect come first, under the name `model`, when there are
    /// some; then the effects; then the constraints that move with time, under the name `drives`, when there are some; last
    /// the impacts on the stop, under the name `stops`, where there is one.
    pub effects: &'static [EffectInfo],
    /// End of the run that the scene declares, s.
    pub until_s: f64,
    /// Numbers that depend on parameters alone, and on counts and indices where there are some; they follow inputs and first-order states in `c`.
    pub n_constants: usize,
    /// Pattern of G = [C_q; S], `n_c × n_v`; of C_q along the velocities where q' ≠ v.
    pub jacobian: SparsityPattern,
    /// Entries of G in the order of [`SceneInfo::jacobian`].
    pub jacobian_entries: &'static [Formula],
    /// Diagonal of M.
    pub mass_entries: &'static [Formula],
    /// F.
    pub force_entries: &'static [Formula],
    /// V: 0 where no force has a potential.
    pub potential_energy: Formula,
    /// Definitions of the symbols in these formulas, besides coordinates, parameters and inputs.
    pub abbreviations: &'static [Abbreviation],
    /// All of this as equations, from the coordinates to the equations of motion; of a scene with counts these alone: its
    /// items have their own.
    pub equations: &'static [Equation],
    /// Order in which the generated elimination takes the rows; empty without one.
    pub elimination: &'static [EliminationStep],
    /// Operations of [`Equations::accelerations`](super::Equations::accelerations).
    pub acceleration_operations: Operations,
    /// Operations of [`Equations::correction`](super::Equations::correction).
    pub correction_operations: Operations,
    /// The coordinates that accelerations and multipliers depend on, ascending; the others follow from the motion without any influence on it,
    /// such as the place of a vehicle on a plane. `None` where that is not known.
    pub feedback: Option<&'static [usize]>,
    /// The equations in quasi-velocities ([`Derived::in_quasi_velocities`](super::Derived::in_quasi_velocities)), where they were derived.
    pub quasi_velocities: Option<QuasiVelocitiesInfo>,
    /// Whether there is a Taylor series ([`Derived::series`](super::Derived::series)).
    pub series: SeriesInfo,
    /// Additional data of a scene with counts; `None` for a scene whose sizes are known at compile time. A scene with
    /// counts has no generated elimination, its formulas are those of [`Repeats::templates`], and the lists of
    /// entries (Jacobian, masses, forces) are empty.
    pub repeats: Option<Repeats>,
}

impl SceneInfo {
    /// Whether [`Equations::accelerations`](super::Equations::accelerations) and [`Equations::correction`](super::Equations::correction)
    /// solve: not in scenes with counts, nor where more than 24 rows meet in one body, for which rustc takes minutes.
    pub fn has_elimination(&self) -> bool {
        self.repeats.is_none() && (self.rows.is_empty() || !self.elimination.is_empty())
    }

    /// How many position constraints, and how many rows, hold at the start.
    pub fn n_rows_at_start(&self) -> [usize; 2] {
        let off = || self.holding_switches().filter(|(_, switch)| switch.start == 0.0);
        [self.n_position_rows, self.n_rows()].map(|n| n - off().filter(|(_, switch)| switch.row < n).count())
    }

    /// The switches that say whether their rows hold, with their places in [`SceneInfo::switches`].
    pub(crate) fn holding_switches(&self) -> impl Iterator<Item = (usize, &'static SwitchInfo)> + use<> {
        let all = self.switches;
        all.iter().enumerate().filter(|&(i, switch)| i == 0 || all[i - 1].row != switch.row)
    }

    /// The counts, in declared order.
    pub const fn counts(&self) -> &'static [CountInfo] {
        match &self.repeats {
            Some(repeats) => repeats.counts,
            None => &[],
        }
    }

    /// Number of unknowns of the equations of motion, n_v + n_c.
    #[inline]
    pub fn n_unknowns(&self) -> usize {
        self.velocities.len() + self.rows.len()
    }

    /// n_v.
    #[inline]
    pub fn n_velocities(&self) -> usize {
        self.velocities.len()
    }

    /// The bodies that pictures show: they are of the plane, and show none where a body moves in space.
    pub fn drawn_bodies(&self) -> &[Name] {
        if self.is_planar() { &self.bodies } else { &[] }
    }

    /// The places of each body in v.
    pub fn velocities_of_bodies(&self) -> impl Iterator<Item = std::ops::Range<usize>> + '_ {
        let mut first = 0;
        (0..self.bodies.len()).map(move |i| {
            let n = self.kinds.get(i).copied().unwrap_or_default().velocities().len();
            first += n;
            first - n..first
        })
    }

    /// The components of all bodies, by what a body of each kind has.
    pub(crate) fn components(
        &self,
        of: fn(BodyKind) -> &'static [Component],
    ) -> impl Iterator<Item = &'static Component> {
        let kind = |i| self.kinds.get(i).copied().unwrap_or_default();
        (0..self.bodies.len()).flat_map(move |i| of(kind(i)))
    }

    /// Whether all bodies are planar, so that q' = v.
    #[inline]
    pub fn is_planar(&self) -> bool {
        self.kinds.is_empty()
    }

    /// n_q.
    #[inline]
    pub fn n_coordinates(&self) -> usize {
        self.coordinates.len()
    }

    /// n_c.
    #[inline]
    pub fn n_rows(&self) -> usize {
        self.rows.len()
    }

    /// n_e.
    pub const fn n_effects(&self) -> usize {
        self.effects.len()
    }

    /// n_i.
    pub const fn n_inputs(&self) -> usize {
        self.inputs.len()
    }

    /// Places of value, rate and time of the input at `first`, which a run integrates; between rate and time stands its acceleration.
    pub(crate) const fn integrated_places(first: usize) -> [usize; 3] {
        const SINCE: usize = 3;
        [first, first + 1, first + SINCE]
    }

    /// n_z.
    pub const fn n_states(&self) -> usize {
        self.states.len()
    }

    /// n_o.
    #[inline]
    pub fn n_outputs(&self) -> usize {
        self.outputs.len()
    }

    /// Length of `c`: inputs, then first-order states, then constants.
    pub const fn n_fixed(&self) -> usize {
        self.inputs.len() + self.states.len() + self.n_constants
    }

    /// Model, scene, and hash of the model file: alike where equations are, whatever parameters and counts.
    pub fn identity(&self) -> (&'static str, &'static str, u64) {
        (self.model, self.name, self.fingerprint)
    }

    /// That its counts can be used.
    ///
    /// # Errors
    /// [`LayoutFault`] when there is no room for so many bodies, or an index leaves its array.
    pub(crate) fn check_counts(&self) -> Result<(), LayoutFault> {
        self.repeats.as_ref().and_then(|repeats| repeats.fault.clone()).map_or(Ok(()), Err)
    }

    /// `c` with inputs and first-order states as declared; [`Equations::constants`](super::Equations::constants) writes what is behind them.
    pub fn declared_values(&self) -> Vec<f64> {
        let mut c = vec![0.0; self.n_fixed()];
        let declared = self.inputs.iter().chain(self.states);
        c.iter_mut().zip(declared).for_each(|(value, declared)| *value = declared.default);
        c
    }
}
