//! Every threshold of the layer: where it comes from, its unit, and a test that needs it.

/// The search for steady motions.
pub(crate) mod search {
    /// Newton steps at most. From a start that is near, ten suffice.
    /// Unit: steps.
    /// Test: `invariant_motion_that_is_not_steady_names_what_is_left`.
    pub(crate) const MAX_STEPS: usize = 60;

    /// Times that a step is halved at most: a millionth of a millionth of it is none.
    /// Unit: halvings.
    /// Test: `invariant_motion_that_is_not_steady_names_what_is_left`.
    pub(crate) const MAX_HALVINGS: usize = 40;

    /// Singular values below this share of the largest leave a direction free: a thousand times what rounding leaves of those that are
    /// zero, far below those of an equation that is scaled to one.
    /// Unit: 1.
    /// Test: `analytic_roller_keeps_to_a_circle_that_is_held`.
    pub(crate) const FREE: f64 = 1e-11;

    /// Steps that change positions by less, as a share of the largest one, change nothing but rounding.
    /// Unit: 1.
    /// Test: `analytic_rod_hangs_and_stands`.
    pub(crate) const LAST: f64 = 1e-13;

    /// What may be left of an equation where steps end, as a share of the largest term of its kind.
    /// Unit: 1.
    /// Test: `invariant_motion_that_is_not_steady_names_what_is_left`.
    pub(crate) const MET: f64 = 1e-10;
}

/// Linear equations about a steady motion.
pub(crate) mod linear {
    /// Singular values of rows that are scaled to one, as a share of the largest: below it a row repeats others.
    /// Unit: 1.
    /// Test: `analytic_roller_keeps_to_a_circle_that_is_held`.
    pub(crate) const INDEPENDENT: f64 = 1e-10;

    /// What may leave the manifold of the constraints, as a share of the rates.
    /// Unit: 1.
    /// Test: `invariant_motion_that_turns_with_the_ground_is_not_steady`.
    pub(crate) const STEADY: f64 = 1e-7;
}

/// Eigenvalues.
pub(crate) mod spectrum {
    /// Singular values below this share of the largest entry are those of zero: rounding of the entries leaves 1e-15 of it, and a chain of n
    /// zeros n times that.
    /// Unit: 1.
    /// Test: `analytic_chain_of_zeros_is_one_block`.
    pub(crate) const ZERO: f64 = 1e-11;

    /// Real parts below this share of the largest eigenvalue say nothing: double eigenvalues split by the root of rounding.
    /// Unit: 1.
    /// Test: `analytic_rod_without_friction_is_neutral`.
    pub(crate) const ROUNDING: f64 = 1e-8;

    /// Iterations for the Schur form at most: some three an eigenvalue suffice.
    /// Unit: iterations.
    /// Test: `analytic_chain_of_zeros_is_one_block`.
    pub(crate) const MAX_ITERATIONS: usize = 10_000;
}

/// Inputs in place of drives.
pub(crate) mod inverse {
    /// Newton steps at most: one where forces are linear in the inputs, and one for its rounding.
    /// Unit: steps.
    /// Test: `analytic_inputs_that_are_not_enough_name_the_drive`.
    pub(crate) const MAX_STEPS: usize = 30;

    /// What may be left of the force of a drive, as a share of the largest term.
    /// Unit: 1.
    /// Test: `analytic_inputs_that_are_not_enough_name_the_drive`.
    pub(crate) const BALANCED: f64 = 1e-12;

    /// Singular values of the effects of inputs on drives, as a share of the largest: below it inputs act alike.
    /// Unit: 1.
    /// Test: `analytic_inputs_that_act_alike_are_refused`.
    pub(crate) const INDEPENDENT: f64 = 1e-12;
}
