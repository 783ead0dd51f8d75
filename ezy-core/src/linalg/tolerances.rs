//! Every threshold of the layer: where it comes from, its unit, and a test that fails when it is a hundred times as large or as small,
//! or gone.

/// Which rows depend on which.
pub(crate) mod rank {
    /// An entry may be the pivot when it is at least this part of the largest; the coordinate with the least mass is taken. A tenth is the
    /// usual bound of threshold pivoting (Duff, Erisman, Reid, Direct Methods for Sparse Matrices, 1986, section 5.4).
    /// Unit: 1.
    /// Test: `invariant_no_dependent_coordinate_multiplies_rounding_by_more_than_ten`.
    pub(crate) const PIVOT_SHARE: f64 = 0.1;

    /// Pivots of rows that count as independent at positions that carry rounding, of rows scaled to one; see [`RankRevealing`](crate::linalg::RankRevealing).
    /// Unit: 1.
    /// Test: `reference_snakeboard_is_steered_through_a_right_angle`,
    /// and `analytic_rank_loss_is_seen_within_rounding`.
    pub(crate) const INDEPENDENT: f64 = 1e-5;

    /// The same at positions that are exact: half of the digits of what the row decides are left, ε/p = √ε.
    /// Unit: 1.
    /// Test: `invariant_wheels_within_rounding_of_one_axle_are_refused_by_name`.
    pub(crate) const INDEPENDENT_EXACTLY: f64 = 1e-8;
}

/// What a solution may leave of its equations.
pub(crate) mod refinement {
    /// Refinements of a solution: each leaves about the ratio of masses times ε of its error, 1e-4 at a ratio of 1e12.
    /// Unit: passes.
    /// Test: `invariant_every_equation_keeps_its_digits_whatever_the_masses`.
    pub(crate) const MAX_REFINEMENTS: usize = 6;

    /// Share of the terms of an equation that counts as their rounding.
    /// Unit: share of the terms of an equation.
    /// Test: `invariant_every_equation_keeps_its_digits_whatever_the_masses`.
    pub(crate) const ROUNDING: f64 = 4.0 * f64::EPSILON;

    /// Terms smaller than this part of the largest may be rounding altogether: what an equation leaves is measured by no less.
    /// Unit: 1.
    /// Test: `analytic_rounding_of_a_coordinate_that_is_held_at_zero_does_not_matter`.
    pub(crate) const NEGLIGIBLE: f64 = 1e-2;
}

/// The elimination over blocks.
#[cfg(feature = "sparse")]
pub(crate) mod blocks {
    /// Below this pivot solutions are refined: 3 of 16 digits are lost there, and a ratio of masses of 1e3 has it.
    /// Unit: 1, of what the pivot started from.
    /// Test: `analytic_small_pivots_cost_no_digits`.
    pub(crate) const REFINED: f64 = 1e-3;

    /// Multipliers below this many times the smallest mass are zero. So is what couples two rows, beside what the first of them takes from itself.
    /// Multipliers of a level chain fall by 3.7 from rod to rod, their products twice as fast and more, and below 2.2e-308 the processor takes longer for
    /// each operation.
    /// Unit: m/s², or 1/s² of a moment of inertia; 1.
    /// Test: `analytic_rods_of_a_level_chain_turn_less_and_less_and_then_not_at_all`.
    pub(crate) const NEGLIGIBLE: f64 = 1e-60;
}

/// Large systems with redundant rows.
pub(crate) mod damped {
    /// ε: with a relative rounding of 1e-16 in positions, what σ = 3e-5 tells about
    /// accelerations (rounding/σ³) is noise.
    /// Unit: 1.
    /// Test: `analytic_a_row_at_an_angle_of_1e_4_holds_and_a_repeated_one_does_not_matter`.
    pub(crate) const SHARE: f64 = 1e-9;

    /// A pass squares what it leaves of well determined directions; the others stop here.
    /// Unit: passes.
    /// Test: `analytic_flat_linkage_names_its_rows_or_the_first_that_fails`.
    pub(crate) const MAX_PASSES: usize = 10;
}

/// What is too large.
pub(crate) mod sizes {
    /// Largest n_q + n_c for which a dense K is made: 70 MB and some seconds a factorisation.
    /// Unit: equations.
    /// Test: `invariant_backends_that_do_not_fit_are_refused`.
    pub(crate) const LARGEST_DENSE: usize = 3_000;

    /// Largest n_q + n_c of a scene whose rank is asked: full pivoting of larger ones takes longer than anyone waits.
    /// Unit: equations.
    /// Test: `analytic_flat_linkage_names_its_rows_or_the_first_that_fails`.
    pub(crate) const LARGEST_DIAGNOSED: usize = 500;

    #[cfg(feature = "sparse")]
    /// A coordinate in more rows than this is a hub: taken before its rows it would couple each of them with all others,
    /// so that a body with n joints would cost n². A hinge on each side of a body and a few more are no hub.
    /// Unit: rows.
    /// Test: `invariant_factors_of_any_tree_grow_with_its_size`.
    pub(crate) const HUB_ROWS: usize = 24;

    #[cfg(feature = "sparse")]
    /// Beyond this many products of blocks a joint, as in a net of 13 × 13 knots, the sparse factors of K are as fast: they take columns
    /// together, where products over blocks are a list in memory. Measured, decision 052.
    /// Unit: products a joint.
    /// Test: `invariant_blocks_refuse_what_they_cannot_take`.
    pub(crate) const PRODUCTS_PER_JOINT: usize = 50;

    #[cfg(feature = "sparse")]
    /// Beyond this many pairs of rows that share a coordinate the order with coordinates first is not tried.
    /// Unit: pairs.
    /// Test: `invariant_a_hub_that_couples_all_rows_is_refused_before_memory_is_full`.
    pub(crate) const MAX_PAIRS: usize = 100_000_000;
}

/// The condition number.
pub(crate) mod conditioning {
    /// Pairs of solves of an estimate; two are the rule.
    /// Unit: pairs.
    /// Test: `invariant_condition_rises_where_rows_come_near_each_other`.
    pub(crate) const MAX_SOLVES: usize = 5;

    /// Passes of the equilibration: each takes the root of the exponent that is left, so that the largest ratio of two doubles, 10^632,
    /// ends at 1.4.
    /// Unit: passes.
    /// Test: `analytic_condition_does_not_depend_on_units`.
    pub(crate) const PASSES: usize = 12;
}
