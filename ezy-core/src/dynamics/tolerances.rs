//! Every threshold of the layer: where it comes from, its unit, and a test that fails when it is a hundred times as large or as small,
//! or gone.

/// What counts as zero.
pub(crate) mod geometry {
    /// Residual of a row, as a share of its size, that counts as zero; a size beyond 1 counts as 1.
    /// Unit: share of the size of a row; m, rad, m/s or rad/s below a size of 1.
    /// Test: `invariant_both_projections_leave_no_residual`.
    pub(crate) const TOLERANCE: f64 = 1e-12;

    /// Rounding of a row in units of ε times the size of its terms: a row sums a handful of them.
    /// Unit: 1.
    /// Test: `invariant_motion_in_any_unit_of_length_and_mass`.
    pub(crate) const ROUNDING_OF_ROWS: f64 = 8.0 * f64::EPSILON;

    /// Beyond this a coordinate keeps less than a micrometre, and the geometry of a body drowns in its rounding.
    /// Unit: m, rad, m/s, rad/s.
    /// Test: `invariant_start_value_beyond_a_billion_is_refused_by_name`.
    pub(crate) const LARGEST_VALUE: f64 = 1e9;
}

/// Back onto the constraints.
pub(crate) mod projection {
    /// Gauss–Newton passes; from the drift of one step two are plenty.
    /// Unit: passes.
    /// Test: `invariant_projection_brings_a_disturbed_state_back`.
    pub(crate) const MAX_PASSES: usize = 10;

    /// Passes before a residual may be taken for rounding of a large angle: at 1e6 rad a correction of the angle is lost, but what x and y take of it
    /// is not, so that each pass leaves a part.
    /// Unit: passes.
    /// Test: `invariant_rotor_keeps_its_hinge_at_a_million_radians`.
    pub(crate) const PASSES_TO_ROUNDING: usize = 3;

    /// The first one converges quadratically, the second one removes its rounding.
    /// Unit: passes.
    /// Test: `cross_four_bars_of_unequal_bars_pass_their_level_positions_on_one_branch`.
    pub(crate) const PASSES_NEAR_RANK_LOSS: usize = 2;

    /// |C| that the last pass may leave, of coordinates beyond 1 m or rad this part of the largest: what redundant rows differ by is rounding of
    /// lengths. Forty four-bars in their level position leave some 1e-11 m (`a02_n_four_bar, N = 40` in docs/hard-cases.md), and the next step,
    /// farther away, removes it.
    /// Unit: m or rad.
    /// Test: `analytic_motors_that_part_are_followed_to_a_tenth_of_a_nanometre`.
    pub(crate) const LARGEST_LEFT: f64 = 1e-10;

    /// A velocity correction this many times as large as the residual that it removes, with angles weighed by their levers, too, shows
    /// rows that nearly depend on each other.
    /// Unit: 1.
    /// Test: `cross_four_bars_of_unequal_bars_pass_their_level_positions_on_one_branch`.
    pub(crate) const NEAR_RANK_LOSS: f64 = 1e3;
}

/// Rows that depend on each other.
pub(crate) mod rank {
    /// Part of the accelerations that redundant rows may leave: where a step ends next to a singular position, rounding of
    /// positions over p³ is far below this, rows that contradict each other far above.
    /// Unit: share of the largest acceleration.
    /// Test: `analytic_belts_that_differ_are_refused_where_they_begin_to`.
    pub(crate) const ACCELERATIONS_AGREE: f64 = 1e-2;

    /// The same of velocities, in which two factors of p less are noise.
    /// Unit: share of the largest velocity.
    /// Test: `analytic_belts_that_differ_are_refused_where_they_begin_to`.
    pub(crate) const VELOCITIES_AGREE: f64 = 1e-6;

    /// Pivots of rows next to dependent ones: sixteen digits of positions leave thirteen of accelerations there, ε/p³.
    /// Unit: 1.
    /// Test: `analytic_motor_against_a_stretched_rod_ends_the_run_with_the_rows`.
    pub(crate) const NEARLY_DEPENDENT: f64 = 0.1;
}

/// Positions in which constraints depend on each other, and not beside them.
pub(crate) mod singular_position {
    /// How far beside a position its rows are looked at. A row that depends on others in this position only has a pivot of about this size
    /// there, a hundred times [`INDEPENDENT`](crate::linalg::INDEPENDENT).
    /// Unit: rad and longest levers.
    /// Test: `analytic_stretched_bars_are_refused_by_every_method`.
    pub(crate) const BESIDE: f64 = 1e-3;

    /// Shorter ways are no motion, but rounding of positions.
    /// Unit: rad and longest levers.
    /// Test: `analytic_stretched_bars_are_refused_by_every_method`.
    pub(crate) const SHORTEST: f64 = 1e-8;

    /// What a redundant row may leave of velocities after a way, as a share of the way. Where the motion leads on it is the square of the
    /// way, 1e-3 of it; where it does not, about 1.
    /// Unit: 1.
    /// Test: `analytic_stretched_bars_are_refused_by_every_method`,
    /// and `analytic_parallel_cranks_leave_their_level_position`.
    pub(crate) const LEAVES: f64 = 0.1;
}

/// A consistent start.
pub(crate) mod start {
    /// Gauss–Newton passes: far guesses need some tens, with a step that is halved when it overshoots.
    /// Unit: passes.
    /// Test: `invariant_start_assembles_angles_from_a_far_guess`.
    pub(crate) const MAX_PASSES: usize = 100;

    /// Farthest that one pass turns a body, rad. Longer steps leave the neighbourhood in which the slopes hold, and can end with
    /// an elbow on its other side.
    /// Unit: rad.
    /// Test: `invariant_elbows_of_a_four_bar_stay_on_their_side`,
    /// and `invariant_start_leaves_the_symmetry_of_flat_loops`.
    pub(crate) const LARGEST_TURN: f64 = 0.2;

    /// Halvings of one step before the search counts as stuck.
    /// Unit: halvings.
    /// Test: `invariant_start_assembles_angles_from_a_far_guess`.
    pub(crate) const MAX_HALVINGS: usize = 20;

    /// Tries from places nearby when the search is stuck; out of a symmetry the first one or two lead.
    /// Unit: tries.
    /// Test: `invariant_start_leaves_the_symmetry_of_a_rod`.
    pub(crate) const MAX_NUDGES: usize = 10;

    /// Directions whose singular value is below this fraction of the largest are left alone.
    /// Unit: share of the largest singular value.
    /// Test: `analytic_accelerations_of_any_ratio_of_masses`.
    pub(crate) const RANK_TOLERANCE: f64 = 1e-10;

    /// What may be left of the derivatives of rows that a start follows: rounding of corrections of rows that depend on each other but for
    /// `RANK_TOLERANCE`. What contradicts given values leaves as much as it changes.
    /// Unit: share of what the rows change by.
    /// Test: `analytic_what_a_start_does_not_let_change_is_told`.
    pub(crate) const FOLLOWED: f64 = 1e-5;

    /// A given value that moves by no more only gets its last digits: guesses are written with six or so.
    /// Unit: rad, share of the longest lever, share of the largest velocity.
    /// Test: `analytic_last_digits_of_a_guess_are_not_told`.
    pub(crate) const LAST_DIGITS: f64 = 1e-6;

    /// Coordinates beyond which corrections come from a sparse factorisation instead of singular values.
    /// Unit: coordinates.
    /// Test: `analytic_massless_coordinates_follow_at_no_cost`.
    pub(crate) const LARGEST_DENSE_START: usize = 150;

    /// Share of the diagonal of G M⁻¹ Gᵀ that is added to it in sparse corrections, so that rows which repeat others, or
    /// that given values alone decide, leave it regular. Rounding is 1e-4 of it; directions with a singular value of
    /// 1e-4 of the largest still converge by four digits a pass.
    /// Unit: 1.
    /// Test: `invariant_rest_of_a_long_chain_follows_a_rod_that_is_given`.
    pub(crate) const DAMPING: f64 = 1e-12;
}

/// Which solver a system takes.
pub(crate) mod backend {
    /// The generated elimination divides by masses: of a body this much lighter than the heaviest, under its load, the
    /// accelerations keep twelve digits. Below it the pivoted solver is chosen, which keeps all of them.
    /// Unit: 1.
    /// Test: `analytic_accelerations_of_any_ratio_of_masses`,
    /// and `invariant_shipped_scenes_with_masses_are_eliminated`.
    pub(crate) const LIGHTEST: f64 = 1e-4;

    /// Number of equations of a scene with counts up to which light bodies are worth the dense solver. Beyond it the sparse
    /// one is taken, which divides by masses like the generated elimination.
    /// Unit: equations.
    /// Test: `cross_accelerations_of_a_rope_of_light_rods_are_the_dense_ones`.
    pub(crate) const LARGEST_FOR_LIGHT: usize = 100;

    /// Range of `g/√m`, whose fourth powers are the determinants of the generated elimination, and whose sums and products with
    /// each other must not leave the range of doubles either.
    /// Unit: 1/√kg.
    /// Test: `invariant_masses_whose_powers_are_no_doubles_are_not_eliminated`.
    pub(crate) const RANGE: std::ops::Range<f64> = 1e-50..1e50;

    /// Largest ratio of such numbers between rows: where it is larger, what a row takes from another is rounding.
    /// Unit: 1.
    /// Test: `invariant_levers_and_masses_too_far_apart_are_not_eliminated`.
    pub(crate) const FURTHEST_APART: f64 = 1e12;
}

/// What messages say.
pub(crate) mod report {
    /// Names that a message lists; of more the rest is counted.
    /// Unit: names.
    /// Test: `invariant_start_that_cannot_be_met_is_refused_at_any_length`.
    pub(crate) const MAX_LISTED: usize = 40;
}
