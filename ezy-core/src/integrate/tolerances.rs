//! Every threshold of the layer: where it comes from, its unit, and a test that fails when it is a hundred times as large or as small,
//! or gone.

/// Lengths of steps.
pub(crate) mod steps {
    /// Shortest step, relative to the time or to one second: shorter steps change nothing.
    /// Unit: share of the time, or s.
    /// Test: `order_rk4_is_four_across_discontinuities`.
    pub(crate) const SHORTEST: f64 = 1e-14;

    /// Attempts of one step to end at a discontinuity: each one locates it better.
    /// Unit: attempts.
    /// Test: `analytic_springs_that_meet_are_followed_as_well_as_one`.
    pub(crate) const MAX_DISCONTINUITIES: u32 = 3;

    /// Stages of a long step that ends at a discontinuity may be beyond it by their own error and then see the other law. So a step covers
    /// this part of the way to the discontinuity, and the rest is a short step of its own.
    /// Unit: 1.
    /// Test: `analytic_springs_that_meet_are_followed_as_well_as_one`.
    pub(crate) const APPROACH: f64 = 31.0 / 32.0;

    /// The rest is short when it is below this part of the attempted step.
    /// Unit: 1.
    /// Test: `analytic_springs_that_meet_are_followed_as_well_as_one`.
    pub(crate) const LEFT: f64 = 1.0 / 16.0;

    /// Parts of a step at whose ends event functions are sampled, but for steps of `gauss`, which go over more of a period.
    /// Unit: parts.
    /// Test: `analytic_two_passages_within_one_step_are_both_found`,
    /// and `analytic_slide_shorter_than_a_quarter_of_a_step_is_followed`.
    pub(crate) const EVENT_PARTS: usize = 4;

    /// Values between the ends of a step of DOP853 come from its polynomial while the estimate of its error is at most this many tolerances;
    /// the estimate is three to ten times the error, so that samples are as good as ends of steps.
    /// Unit: tolerances.
    /// Test: `cross_dop853_samples_between_steps_keep_to_the_tolerance`.
    pub(crate) const LARGEST_DENSE_ERROR: f64 = 10.0;

    /// Largest change of a velocity by projection after a step of Radau. In 494 of 495 runs of the shipped scenes no step has more.
    /// Unit: tolerances of a velocity.
    /// Test: `cross_radau_follows_a_caster_on_a_trail_of_half_a_millimetre`.
    pub(crate) const LARGEST_CORRECTION: f64 = 10.0;

    /// What a step of a quarter of the length leaves at most of a correction that is an error of the step; a method of order 1 leaves a quarter.
    /// Unit: 1.
    /// Test: `invariant_radau_takes_no_rounding_for_an_error`.
    pub(crate) const RESOLVED: f64 = 0.5;

    /// Growth of steps after one that was taken again for such a correction: four steps later they are as long again.
    /// Unit: 1.
    /// Test: `invariant_radau_seldom_repeats_steps_in_a_steady_circle`.
    pub(crate) const GROW_AGAIN: f64 = 1.5;

    /// A step whose end cannot be projected is taken again, shorter by this factor, as in CVODE (Hindmarsh and others, ACM Trans. Math.
    /// Softw. 31, 2005).
    /// Unit: 1.
    /// Test: `analytic_parallel_cranks_leave_their_level_position`.
    pub(crate) const QUARTERED: f64 = 0.25;

    /// Accelerations of a series at the end of its step that differ from those of the equations by more than this, times the length of the
    /// step and for each order, are not the motion. Where they are, what is left out is about the tolerance, and its derivative as many times
    /// that as the series has orders: half of all steps have 0.5 to 1.3, one or two in a hundred more than 5.
    /// Unit: tolerances of a velocity for each order.
    /// Test: `cross_taylor_steps_do_not_pass_over_a_friction_layer`.
    pub(crate) const LARGEST_DEFECT: f64 = 5.0;

    /// What of such a difference may be rounding.
    /// Unit: share of the largest acceleration.
    /// Test: `invariant_taylor_takes_few_steps_again_where_forces_are_smooth`.
    pub(crate) const DEFECT_OF_ROUNDING: f64 = 1e-12;

    /// Change of a velocity by projection that steps along a series aim at, at most: corrections of one sign add up over some hundred steps.
    /// Unit: tolerances of a velocity.
    /// Test: `cross_taylor_keeps_to_the_tolerance_over_short_levers`.
    pub(crate) const SERIES_CORRECTION: f64 = 0.25;

    /// What of such a change may be rounding: positions are projected to 1e-12 of their size.
    /// Unit: share of a velocity.
    /// Test: `analytic_level_cranks_by_taylor_are_a_pendulum_or_refused`.
    pub(crate) const CORRECTION_OF_ROUNDING: f64 = 1e-12;

    /// Steps along a series become at most this part as long for such a change. At order 6 it leaves 1/64 of an error of the step.
    /// Unit: 1.
    /// Test: `analytic_corrections_shorten_steps_of_a_series`.
    pub(crate) const SHORTEST_OF_SERIES: f64 = 0.5;
}

/// Where a force is not smooth.
pub(crate) mod discontinuities {
    /// A discontinuity this close to an end of a step is ignored, in resolutions of the time.
    /// Unit: resolutions of the time.
    /// Test: `analytic_springs_that_meet_are_followed_as_well_as_one`,
    /// and `order_rk4_is_four_across_discontinuities`.
    pub(crate) const AT_END: f64 = 10.0;

    /// Steps end this far behind a discontinuity, in resolutions of the time, so that the next one begins on its other side.
    /// Unit: resolutions of the time.
    /// Test: `analytic_limit_with_a_discontinuity_is_followed_in_every_mode`.
    pub(crate) const BEHIND: f64 = 2.0;

    /// Uncertainty of the predicted distance to a discontinuity, relative to that distance, for a whole step. For shorter distances it
    /// falls in proportion to the distance.
    /// Unit: 1.
    /// Test: `order_rk4_is_four_across_discontinuities`.
    pub(crate) const UNKNOWN: f64 = 1.0 / 32.0;

    /// A step in which the share of a smoothed law changes by more than this passes its layer: half of all it can change by.
    /// Unit: share of the largest force.
    /// Test: `cross_dop853_steps_do_not_pass_over_a_friction_layer`,
    /// and `invariant_resolved_friction_costs_dop853_no_steps`.
    pub(crate) const TURNED: f64 = 1.0;

    /// Guard against chattering: each shortened step adds [`CUT`], each full step subtracts one. From [`CHATTERING_GUARD`] on discontinuities are
    /// stepped over, as where dry friction sticks or where a value is only rounding.
    /// Unit: points.
    /// Test: `analytic_dry_friction_is_followed_through_every_reversal`.
    pub(crate) const CUT: u32 = 2;

    /// See [`CUT`].
    /// Unit: points.
    /// Test: `analytic_dry_friction_is_followed_through_every_reversal`.
    pub(crate) const CHATTERING_GUARD: u32 = 48;
}

/// Roots of functions of the time.
pub(crate) mod roots {
    /// Events are located to this accuracy, s, or to the resolution of the time.
    /// Unit: s.
    /// Test: `analytic_events_of_a_throw_are_located_by_every_method`.
    pub(crate) const RESOLUTION_S: f64 = 1e-12;

    /// More evaluations are never needed: each second one halves the bracket at least, from an hour to 1e-12 s in 52.
    /// Unit: evaluations.
    /// Test: `analytic_events_of_a_throw_are_located_by_every_method`.
    pub(crate) const MAX_EVALUATIONS: usize = 200;
}

/// The runs beside one that estimate its error.
pub(crate) mod second_run {
    /// Tolerance of the second run over that of the first. A method follows its tolerance roughly: at a hundredth, errors of the second run are as large as those
    /// of the first once in some ten thousand runs; at a thousandth it takes one and a half to four times the time.
    /// Unit: 1.
    /// Test: `cross_estimates_of_a_first_run_that_is_lucky_are_not_too_small`.
    pub(crate) const TIGHTER: f64 = 1e-3;

    /// Below this tolerance errors are rounding, which a thousandth of the tolerance does not change.
    /// Unit: 1.
    /// Test: `cross_estimates_are_within_a_factor_of_five_of_the_error`.
    pub(crate) const ROUNDING: f64 = 1e-13;

    /// The same for Radau, whose iteration leaves more of it.
    /// Unit: 1.
    /// Test: `cross_estimates_are_within_a_factor_of_five_of_the_error`.
    pub(crate) const ROUNDING_OF_RADAU: f64 = 1e-11;
}

/// Lengths of steps of DOP853, and the clock of fixed steps.
pub(crate) mod step_control {
    /// Steps are aimed at this part of the largest allowed error, so that few are rejected.
    /// Unit: 1.
    /// Test: `analytic_steady_errors_ask_for_their_eighth_root_less_what_damps`.
    pub(crate) const SAFETY: f64 = 0.9;

    /// A step becomes at most this part of the last one, or of the one that was tried.
    /// Unit: 1.
    /// Test: `analytic_steps_change_by_six_and_a_third_at_most`.
    pub(crate) const SHRINK: f64 = 1.0 / 3.0;

    /// A step becomes at most this many times as long.
    /// Unit: 1.
    /// Test: `analytic_steps_change_by_six_and_a_third_at_most`.
    pub(crate) const GROW: f64 = 6.0;

    /// Exponent of the integral part of the controller, which damps oscillations of the step length.
    /// Unit: 1.
    /// Test: `analytic_steady_errors_ask_for_their_eighth_root_less_what_damps`.
    pub(crate) const BETA: f64 = 0.04;

    /// Smallest error that is used for prediction.
    /// Unit: tolerances.
    /// Test: `analytic_steps_change_by_six_and_a_third_at_most`.
    pub(crate) const LEAST_ERROR: f64 = 1e-4;

    /// A remainder of the run below this fraction of a step is rounding of `n h`, not a step.
    /// Unit: share of a step.
    /// Test: `analytic_clock_lands_on_its_end`.
    pub(crate) const REST: f64 = 1e-9;
}

/// When DOP853 calls a motion stiff, and where its estimate of the error is rounding.
pub(crate) mod dop853 {
    /// Edge of the region in which the method is stable, along the negative real axis, for h |λ|.
    /// Unit: 1.
    /// Test: `regress_fifteen_steps_at_the_edge_are_stiff`.
    pub(crate) const STABLE: f64 = 6.1;

    /// One step in this many is examined until one is at the edge.
    /// Unit: steps.
    /// Test: `regress_steps_are_examined_when_due`.
    pub(crate) const EVERY: u32 = 50;

    /// This many steps at the edge mean stiffness, unless [`N_OTHERS`] others in a row come between them.
    /// Unit: steps.
    /// Test: `regress_fifteen_steps_at_the_edge_are_stiff`.
    pub(crate) const N_AT_EDGE: u32 = 15;

    /// See [`N_AT_EDGE`].
    /// Unit: steps.
    /// Test: `regress_six_others_in_a_row_begin_the_count_again`.
    pub(crate) const N_OTHERS: u32 = 6;

    /// Below this tolerance errors are rounding, of which the divided difference makes more than the error of order 5: next to singular positions
    /// steps would not end.
    /// Unit: 1.
    /// Test: `analytic_sixth_differences_count_above_rounding`.
    pub(crate) const ROUNDING: f64 = 1e-11;
}

/// Quasi-velocities.
pub(crate) mod quasi_velocities {
    /// Quasi-velocities give back the velocities that they are taken from up to the rounding of some ten operations over the smallest pivot: a length, such
    /// as that from a hinge to an axle, which may be a thousandth of the others.
    /// Unit: share of the fastest velocity.
    /// Test: `invariant_steps_from_velocities_off_the_rows_are_those_of_rows`.
    pub(crate) const SAME: f64 = 1e-12;
}

/// Sweeps and lengths of steps of collocation.
pub(crate) mod gauss {
    /// Sweeps end where the next one would change a velocity by less than this part of its tolerance.
    /// Unit: tolerances.
    /// Test: `cross_sweeps_of_a_swing_end_where_they_have_converged_or_do_not`.
    pub(crate) const OF_SWEEPS: f64 = 0.1;

    /// What the first step changes a number of the state by, relative to its size and its unit.
    /// Unit: 1.
    /// Test: `analytic_first_step_changes_a_number_by_a_tenth`.
    pub(crate) const FIRST_CHANGE: f64 = 0.1;

    /// Most sweeps of a step; more are no gain over a shorter step.
    /// Unit: sweeps.
    /// Test: `cross_sweeps_of_a_swing_end_where_they_have_converged_or_do_not`.
    pub(crate) const MAX_SWEEPS: u32 = 50;

    /// A change of the accelerations that sweeps do not make smaller is rounding below this part of them, and so is what their polynomial lacks.
    /// Unit: share of an acceleration.
    /// Test: `analytic_changes_that_are_rounding_end_sweeps`.
    pub(crate) const ROUNDING: f64 = 1e-12;

    /// What a polynomial lacks at its end is a jump behind its last node from so many times on what its coefficients tell and what it lacks at its start.
    /// Of smooth motions these tell it within a small factor.
    /// Unit: 1.
    /// Test: `analytic_jump_behind_the_last_node_is_seen_at_the_end`.
    pub(crate) const UNEXPECTED: f64 = 10.0;

    /// A step in which the share of a smoothed law changes by more than this up to a node is not resolved by its order. Of v/√(v² + k²) with v from k/√3 on, a
    /// change by a half, coefficients fall by three a degree, and by 4e-8 to the degree that the end sees; for twice the change by 3e-6.
    /// Unit: share of the largest force.
    /// Test: `cross_gauss_samples_of_slow_wheels_keep_to_the_tolerance`.
    pub(crate) const TURNED_WITHIN: f64 = 0.5;

    /// Sweeps of this rate do not converge.
    /// Unit: 1.
    /// Test: `cross_sweeps_of_a_swing_end_where_they_have_converged_or_do_not`.
    pub(crate) const STALLED: f64 = 0.9;

    /// Changes may grow in so many sweeps: of a linear motion sweep n multiplies them by about z/n.
    /// Unit: sweeps.
    /// Test: `cross_sweeps_of_a_swing_end_where_they_have_converged_or_do_not`.
    pub(crate) const GROWING: u32 = 8;

    /// Steps aim at this error over the tolerance, since errors of neighbouring steps differ by as much: few are rejected.
    /// Unit: tolerances.
    /// Test: `analytic_errors_change_lengths_by_their_seventeenth_root`.
    pub(crate) const AIM: f64 = 0.01;

    /// A step becomes at most this part of the last one.
    /// Unit: 1.
    /// Test: `analytic_errors_change_lengths_by_their_seventeenth_root`.
    pub(crate) const SHRINK: f64 = 0.2;

    /// A step becomes at most this many times as long.
    /// Unit: 1.
    /// Test: `analytic_errors_change_lengths_by_their_seventeenth_root`.
    pub(crate) const GROW: f64 = 4.0;

    /// A step whose sweeps do not converge is taken again shorter by this.
    /// Unit: 1.
    /// Test: `invariant_steps_do_not_grow_after_one_that_failed`.
    pub(crate) const DIVERGED: f64 = 0.5;

    /// Largest steepness of a step: the number of its sweeps times their mean rate, which is up to e times the z of linear equations, whose sweep n multiplies changes
    /// by z/n. From 4 to 12 sweeps for a length of time are about as many, and longer steps save what a step costs besides; beyond, changes grow in the first
    /// sweeps, and steps fail.
    /// Unit: 1.
    /// Test: `analytic_steep_equations_shorten_steps`.
    pub(crate) const BEST_STEEPNESS: f64 = 6.0;
}

/// Iterations and lengths of steps of Radau.
pub(crate) mod radau {
    /// Largest number of Newton iterations of a step.
    /// Unit: iterations.
    /// Test: `regress_iterations_end_after_seven_passes`.
    pub(crate) const MAX_PASSES: u32 = 7;

    /// The iteration ends when its error is below this part of the tolerance, or below the root of the tolerance.
    /// Unit: 1.
    /// Test: `analytic_goal_is_the_root_of_the_tolerance_within_bounds`.
    pub(crate) const PART: f64 = 0.03;

    /// Rounding of sums of some terms, in parts of the largest: changes and residuals below it are zero.
    /// Unit: 1.
    /// Test: `analytic_goal_is_the_root_of_the_tolerance_within_bounds`.
    pub(crate) const ROUNDING: f64 = 10.0 * f64::EPSILON;

    /// Factor for the step after an iteration that diverges.
    /// Unit: 1.
    /// Test: `analytic_slow_iterations_ask_for_a_shorter_step`.
    pub(crate) const SHORTEN: f64 = 0.5;

    /// Largest rate of convergence.
    /// Unit: 1.
    /// Test: `analytic_slow_iterations_ask_for_a_shorter_step`.
    pub(crate) const SLOWEST: f64 = 0.99;

    /// Exponent of the previous rate in the estimate for the first iteration.
    /// Unit: 1.
    /// Test: `analytic_goal_is_the_root_of_the_tolerance_within_bounds`.
    pub(crate) const FORGET: f64 = 0.8;

    /// The stages are also taken as solved when a pass has left at most this part of the residual. A stiff force that levels off makes
    /// passes with small changes that leave nearly all of it.
    /// Unit: 1.
    /// Test: `invariant_small_changes_that_leave_residuals_do_not_end_the_iteration`.
    pub(crate) const TRUSTED: f64 = 0.1;

    /// Rate of convergence that is assumed when one iteration sufficed.
    /// Unit: 1.
    /// Test: `analytic_linear_equations_take_one_pass_and_keep_their_factors`.
    pub(crate) const AT_ONCE: f64 = 1e-3;

    /// Steps are aimed at this part of the largest allowed error, less where the iteration is slow.
    /// Unit: 1.
    /// Test: `analytic_next_step_is_the_fourth_root_of_the_error`.
    pub(crate) const SAFETY: f64 = 0.9;

    /// A step becomes at most this part of the last one.
    /// Unit: 1.
    /// Test: `analytic_trend_of_errors_shortens_the_next_step`.
    pub(crate) const SHRINK: f64 = 0.2;

    /// A step becomes at most this many times as long.
    /// Unit: 1.
    /// Test: `analytic_next_step_is_the_fourth_root_of_the_error`.
    pub(crate) const GROW: f64 = 8.0;

    /// A step that would grow by less keeps its length and its factors.
    /// Unit: 1.
    /// Test: `invariant_nearly_equal_steps_keep_their_factors`.
    pub(crate) const KEEP: f64 = 1.2;

    /// Smallest error that is used for prediction.
    /// Unit: tolerances.
    /// Test: `analytic_trend_of_errors_shortens_the_next_step`.
    pub(crate) const LEAST_ERROR: f64 = 1e-2;

    /// The first step is a guess: what remains of it after a rejection.
    /// Unit: 1.
    /// Test: `analytic_rejected_steps_become_shorter_and_do_not_grow_at_once`.
    pub(crate) const FIRST_REJECTED: f64 = 0.1;

    /// Jacobians and factors are kept as long as a pass leaves less than this of the error.
    /// Unit: 1.
    /// Test: `analytic_linear_equations_take_one_pass_and_keep_their_factors`.
    pub(crate) const FAST: f64 = 1e-3;

    /// Steps with coupled stages before the simplified iteration is tried again.
    /// Unit: steps.
    /// Test: `regress_twenty_steps_have_slopes_at_every_stage_after_one_that_diverged`.
    pub(crate) const N_COUPLED: u32 = 20;

    /// Factors are reused for steps whose length differs by less than this part.
    /// Unit: 1.
    /// Test: `analytic_linear_equations_take_one_pass_and_keep_their_factors`.
    pub(crate) const SAME_STEP: f64 = 1e-9;

    /// A step is stiff where forces by the Jacobians make this part of a residual: stages then have an order of their own, which is lower. Over the
    /// shipped scenes the part is below 0.2, with stiff bushings below 0.75.
    /// Unit: 1.
    /// Test: `analytic_second_look_is_none_of_a_stiff_step`.
    pub(crate) const STIFF: f64 = 0.5;

    /// First step, in parts of the time in which the state changes by its own size.
    /// Unit: 1.
    /// Test: `analytic_first_step_is_a_part_of_the_time_of_change`.
    pub(crate) const FIRST: f64 = 1e-2;

    /// The shortest first step, s.
    /// Unit: s.
    /// Test: `analytic_first_step_is_a_part_of_the_time_of_change`.
    pub(crate) const LEAST_FIRST_S: f64 = 1e-6;

    /// Diagonal entry of the rows of G, relative to the largest entry of the scaled row: far above the rounding of redundant rows,
    /// far below what would slow the iteration.
    /// Unit: 1.
    /// Test: `analytic_matrices_with_a_dependent_row_are_regular`.
    pub(crate) const DAMPING: f64 = 1e-11;

    /// Number of equations from which on sparse factors take less time: a chain of 25 equations takes as long either way, one of 50
    /// less than half, one of 100 a twentieth.
    /// Unit: equations.
    /// Test: `regress_fifty_equations_have_sparse_factors`.
    pub(crate) const SPARSE_FROM: usize = 50;

    /// Number of equations up to which all stages are solved together: dense factors of 240 unknowns take some milliseconds.
    /// Seven parallel cranks have 52 equations, and take 34 steps at 1e-6 with it and 295 without.
    /// Unit: equations.
    /// Test: `cross_coupled_and_transformed_stages_agree`,
    /// and `analytic_seven_level_cranks_by_radau_are_a_pendulum_in_few_steps`.
    pub(crate) const LARGEST_COUPLED: usize = 80;
}

/// Steps of Taylor's method.
pub(crate) mod taylor {
    /// Orders above the optimum for a cost proportional to the square of the order: factorisations and projections cost the same
    /// at any order, and longer steps need fewer of them.
    /// Unit: orders.
    /// Test: `analytic_order_grows_with_the_logarithm_of_the_tolerance`.
    pub(crate) const MORE_ORDERS: f64 = 2.0;

    /// Steps stay below this part of the radius of convergence, however small the terms are.
    /// Unit: logarithm to the base 2 of a share of the radius.
    /// Test: `analytic_geometric_series_are_cut_off_at_the_tolerance`.
    pub(crate) const LOG_WITHIN_RADIUS: f64 = -1.0;

    /// The remainder counts at least as this part of the last term.
    /// Unit: logarithm to the base 2 of a share of the last term.
    /// Test: `analytic_geometric_series_are_cut_off_at_the_tolerance`.
    pub(crate) const LOG_LEAST_REST: f64 = -4.0;

    /// Newton passes to a node of the quadrature of works: each doubles the digits of an estimate that has three.
    /// Unit: passes.
    /// Test: `analytic_gauss_nodes_are_exact_to_their_degree`.
    pub(crate) const NODE_PASSES: usize = 5;
}

/// Motions in double-double numbers.
pub(crate) mod precise {
    /// Tolerance of a step, absolute and relative: the last digit but one.
    /// Unit: m, rad, m/s, rad/s, and 1.
    /// Test: `reference_double_double_driven_to_29_digits`.
    pub(crate) const TOLERANCE: f64 = 1e-30;

    /// Newton corrections at most: each gains at least the ten digits of a factorisation in f64.
    /// Unit: corrections.
    /// Test: `invariant_precise_motion_keeps_energy_and_hinge`.
    pub(crate) const MAX_CORRECTIONS: usize = 8;

    /// Refinements of a solution by factors in f64 at most.
    /// Unit: refinements.
    /// Test: `invariant_precise_motion_by_refined_factors_keeps_energies_and_hinges`.
    pub(crate) const MAX_REFINEMENTS: usize = 12;
}
