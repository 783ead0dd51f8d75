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
    /// Tolerance of the second run over that of the first. A method follows its tolerance roughly: at a tenth, the errors of the second run
    /// are now and then as large as those of the first; at a thousandth it takes two to five times the time.
    /// Unit: 1.
    /// Test: `cross_estimates_are_within_a_factor_of_five_of_the_error`.
    pub(crate) const TIGHTER: f64 = 1e-2;

    /// Below this tolerance errors are rounding, which a hundredth of the tolerance does not change.
    /// Unit: 1.
    /// Test: `cross_estimates_are_within_a_factor_of_five_of_the_error`.
    pub(crate) const ROUNDING: f64 = 1e-13;

    /// The same for Radau, whose iteration leaves more of it.
    /// Unit: 1.
    /// Test: `cross_estimates_are_within_a_factor_of_five_of_the_error`.
    pub(crate) const ROUNDING_OF_RADAU: f64 = 1e-11;
}
