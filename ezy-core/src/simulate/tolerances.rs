//! Every threshold of the layer: where it comes from, its unit, and a test that fails when it is a hundred times as large or as small,
//! or gone.

/// What is kept and told of a run.
pub(crate) mod samples {
    /// A sample within this fraction of a step of a step's end is that end.
    /// Unit: share of a step.
    /// Test: `invariant_sample_on_the_end_of_a_step_costs_nothing`.
    pub(crate) const ON_STEP: f64 = 1e-9;

    /// Number of progress reports.
    /// Unit: reports.
    /// Test: `invariant_progress_rises_to_one`.
    pub(crate) const N_PROGRESS: f64 = 100.0;
}

/// Steps next to singular positions.
pub(crate) mod singular {
    /// A singular position may be this many times as far as predicted, and is searched for that far; one that may be within a usual
    /// step counts.
    /// Unit: 1.
    /// Test: `cross_parallelogram_stays_one_through_its_flat_positions`,
    /// and `cross_four_bars_of_unequal_bars_pass_their_level_positions_on_one_branch`.
    pub(crate) const NEAR: f64 = 1.6;

    /// A pivot vanishes where it falls below this part of its present value on the predicted path.
    /// Unit: 1.
    /// Test: `cross_four_bars_of_unequal_bars_pass_their_level_positions_on_one_branch`.
    pub(crate) const VANISHES: f64 = 0.02;

    /// Where rows are redundant, pivots are evaluated at this many points ahead, each twice as far as the one before. The smallest pivot of
    /// independent rows hardly changes until the last quarter of a radian before a singular position, so that its trend predicts nothing. A
    /// position between two points is at most half as far from one of them as from the present state.
    /// Unit: points.
    /// Test: `reference_five_cranks_pass_the_level_position`.
    pub(crate) const N_AHEAD: i32 = 7;

    /// Golden sections: they reduce the path to 1/2000.
    /// Unit: sections.
    /// Test: `cross_parallelogram_stays_one_through_its_flat_positions`.
    pub(crate) const N_SECTIONS: usize = 16;

    /// The usual length falls by this part of each shorter step.
    /// Unit: 1.
    /// Test: `cross_four_bars_of_unequal_bars_pass_their_level_positions_on_one_branch`,
    /// and `analytic_level_cranks_by_taylor_are_a_pendulum_or_refused`.
    pub(crate) const FADING: f64 = 0.1;

    /// A step that ends at a singular position is shortened by this factor, since accelerations are inaccurate there.
    /// Unit: 1.
    /// Test: `analytic_level_cranks_by_taylor_are_a_pendulum_or_refused`.
    pub(crate) const SHORTENED: f64 = 0.9;

    /// A step ends next to a singular position when the smallest pivot falls below this part of its value at the start.
    /// Unit: 1.
    /// Test: `cross_four_bars_of_unequal_bars_pass_their_level_positions_on_one_branch`.
    pub(crate) const TOO_NEAR: f64 = 0.03;

    /// Repetitions of one step.
    /// Unit: attempts.
    /// Test: `analytic_parallel_cranks_leave_their_level_position`.
    pub(crate) const MAX_SHORTENED: usize = 3;

    /// Part of the usual length below which steps next to a singular position end the run: six cranks that pass their level position at
    /// 29.7 rad/s take 3,566 steps of dop853 at 1e-13 there, and leave their branch (`level_cranks.rs`).
    /// Unit: share of the usual step.
    /// Test: `cross_four_bars_of_unequal_bars_pass_their_level_positions_on_one_branch`.
    pub(crate) const CREEPING: f64 = 1e-4;
}

/// Steps across singular positions.
pub(crate) mod crossing {
    /// Place of the singular position in the crossing step, from 0 to 1: 0.13 of the step from the nearest node of DOP853.
    /// Unit: share of the step.
    /// Test: `cross_parallelogram_stays_one_through_its_flat_positions`.
    pub(crate) const MIDDLE: f64 = 0.46;

    /// The crossing step may begin this factor too far from its ideal start.
    /// Unit: 1.
    /// Test: `cross_four_bars_of_unequal_bars_pass_their_level_positions_on_one_branch`,
    /// and `cross_parallelogram_stays_one_through_its_flat_positions`.
    pub(crate) const ABOUT: f64 = 1.1;

    /// Relative error that the shortest steps may have: it is noise.
    /// Unit: 1.
    /// Test: `cross_four_bars_of_unequal_bars_pass_their_level_positions_on_one_branch`.
    pub(crate) const NOISE: f64 = 1e-10;

    /// Attempts of one step.
    /// Unit: attempts.
    /// Test: `cross_four_bars_of_unequal_bars_pass_their_level_positions_on_one_branch`.
    pub(crate) const MAX_TRIES: u32 = 10;

    /// Tolerance of crossing steps for methods with a fixed step, whose own errors are larger. Shorter crossing steps end nearer to the position.
    /// Unit: 1, m or m/s.
    /// Test: `analytic_three_level_cranks_by_rk4_are_a_pendulum`.
    pub(crate) const OF_FIXED_STEPS: f64 = 1e-9;

    /// Smallest tolerance of crossing steps. What rounding makes of the forces at a distance of some thousandths, 1e-16 over its cube, is more than smaller ones:
    /// steps that are to keep them come nearer, where rounding is more, until none passes.
    /// Unit: 1, m or m/s.
    /// Test: `cross_change_points_are_passed_by_the_smallest_tolerance`.
    pub(crate) const LEAST_TOLERANCE: f64 = 1e-12;

    /// A step across a singular position is not made shorter than this part of the usual step: a shorter one would end in the noise next to
    /// the position. At this length an error up to [`NOISE`] is accepted.
    /// Unit: share of the usual step.
    /// Test: `cross_four_bars_of_unequal_bars_pass_their_level_positions_on_one_branch`,
    /// and `cross_parallelogram_stays_one_through_its_flat_positions`.
    pub(crate) const SHORTEST: f64 = 1.0 / 16.0;
}

/// Events between the ends of a step.
pub(crate) mod events {
    /// An initial value below this part of the largest one in the first step is rounding: its sign is taken as zero.
    /// Unit: 1.
    /// Test: `analytic_start_just_before_an_event_is_told_from_rounding`.
    pub(crate) const NOTHING: f64 = 1e-10;

    /// Parabolas that are tried, each through the last three samples.
    /// Unit: tries.
    /// Test: `analytic_events_of_a_throw_are_located_by_every_method`.
    pub(crate) const MAX_PARABOLAS: usize = 3;

    /// A predicted minimum above this part of the smaller end value does not reach zero.
    /// Unit: 1.
    /// Test: `analytic_value_that_stays_away_from_zero_costs_nothing`.
    pub(crate) const SHALLOW: f64 = 0.5;
}

/// Changes of mode.
pub(crate) mod modes {
    /// Changes of mode at one time after which the run gives up.
    /// Unit: changes.
    /// Test: `analytic_input_that_jumps_over_the_limit_lets_the_sled_go_at_once`.
    pub(crate) const MAX_AT_ONCE: usize = 8;

    /// Bounces become shorter and shorter, infinitely many in a finite time. A flight shorter than this many times the resolution
    /// of time is skipped: the stop holds.
    /// Unit: resolutions of the time.
    /// Test: `analytic_stone_bounces_until_it_rests_by_every_method`.
    pub(crate) const SHORTEST_FLIGHT: f64 = 1e3;

    /// A flight lower than this many roundings of the quantity is skipped, too.
    /// Unit: roundings of the quantity.
    /// Test: `analytic_stone_rests_on_a_floor_away_from_the_origin`.
    pub(crate) const LOWEST_FLIGHT: f64 = 16.0;
}

/// What a run watches.
pub(crate) mod monitors {
    /// Unknowns up to which a dense factorisation at start and end is cheap beside a run.
    /// Unit: unknowns.
    /// Test: `invariant_condition_rises_where_rows_come_near_each_other`.
    pub(crate) const LARGEST_WATCHED: usize = 200;

    /// Steps between two looks at least; in larger scenes the square of their unknowns.
    /// Unit: steps.
    /// Test: `analytic_condition_is_worst_on_the_way_where_crank_and_rod_are_upright`.
    pub(crate) const FEWEST_BETWEEN: u64 = 4096;

    /// What a sum of a handful of terms may lose to rounding, over their size.
    /// Unit: 1.
    /// Test: `invariant_rounding_of_a_large_potential_energy_is_no_error`.
    pub(crate) const ROUNDING: f64 = 16.0 * f64::EPSILON;

    /// Largest energy error of a run with fixed steps whose result is trusted. A fixed step has no tolerance to compare with, so this is the
    /// least that a result is good for: three digits. RK4 makes errors of positions that are larger than those of the energy: (hω)⁴/120 of a
    /// radian for every radian that an oscillator turns, against (hω)⁵/72 of its energy.
    /// Unit: share of the energy turned over.
    /// Test: `invariant_fixed_steps_that_lose_energy_are_not_trusted`.
    pub(crate) const LARGEST_ENERGY_ERROR: f64 = 1e-3;

    /// Default limit on the steps of a method that chooses their length: about a minute of computing. The number of fixed steps is
    /// checked when the run is built.
    /// Unit: steps.
    /// Test: `regress_chosen_steps_end_at_ten_million_as_the_manual_says`.
    pub(crate) const MAX_CHOSEN_STEPS: u64 = 10_000_000;

    /// Attempted steps from which the pace of a run is taken: some seconds of computing, in which a run that stalls shows it, and more than a
    /// motion spends on ringing before it becomes smooth.
    /// Unit: steps.
    /// Test: `cross_a_run_that_stalls_ends_within_seconds`.
    pub(crate) const ATTEMPTS_OF_A_PACE: u64 = 20_000;

    /// Steps between two evaluations of velocity residuals. One costs a third of an evaluation of the accelerations, and after a
    /// projection the residual is rounding.
    /// Unit: steps.
    /// Test: `analytic_velocity_residual_is_seen_between_the_ends_of_a_run`.
    pub(crate) const N_BETWEEN_LOOKS: u64 = 16;

    /// A path that comes nearer to a singular position than this part of its distance leads through it: the search finds the position to 1/2000
    /// of its range.
    /// Unit: 1.
    /// Test: `cross_crossings_beside_a_singular_position_are_told_from_those_through_it`.
    pub(crate) const BESIDE: f64 = 3e-3;

    /// More intervals say nothing new: the mechanism passes a singular position at every turn.
    /// Unit: intervals.
    /// Test: `analytic_rank_loss_names_the_rows`.
    pub(crate) const MAX_INTERVALS: usize = 16;
}

/// The runs that estimate an error.
pub(crate) mod error_estimate {
    /// Steps of a second run over those of the first up to which something else than the tolerance limits most of them. A thousandth of it asks an order of 8
    /// for 2.37 times as many, and a lower one for more.
    /// Unit: 1.
    /// Test: `cross_estimates_of_runs_with_steps_as_long_are_not_too_small`,
    /// and `invariant_estimate_of_a_run_of_many_steps_is_by_its_own_method`.
    pub(crate) const AS_MANY: f64 = 1.4;

    /// So many more are as many, too: the first steps of a run hardly depend on its tolerance.
    /// Unit: steps.
    /// Test: `cross_estimates_of_two_steps_and_of_three_are_not_too_small`,
    /// and `invariant_estimate_of_a_run_of_many_steps_is_by_its_own_method`.
    pub(crate) const FIRST_STEPS: f64 = 2.0;

    /// Tolerance of a second run over that of the first, where none with a smaller one comes to its end.
    /// Unit: 1.
    /// Test: `invariant_estimate_without_a_tighter_run_is_too_large`.
    pub(crate) const LOOSER: f64 = 10.0;

    /// What the start of the third run is moved by, over the tolerance of that run: a motion that makes its errors a thousand times as large
    /// as their tolerance makes the move as much larger.
    /// Unit: 1.
    /// Test: `cross_amplification_is_that_of_the_motion_with_every_method`,
    /// and `analytic_amplification_is_that_of_the_linear_motion`.
    pub(crate) const MOVED: f64 = 1e3;

    /// What it is moved by at least: a thousand times the rounding of a run.
    /// Unit: share of a number and its unit.
    /// Test: `analytic_amplification_is_that_of_the_linear_motion`.
    pub(crate) const SMALLEST_MOVE: f64 = 1e-9;
}

/// What may be ordered.
pub(crate) mod orders {
    /// A quarter of an hour at 100 ns a step; more is a typing error.
    /// Unit: steps.
    /// Test: `invariant_orders_out_of_proportion_are_refused_and_large_ones_accepted`.
    pub(crate) const MAX_STEPS: f64 = 1e10;

    /// A larger tolerance accepts any motion.
    /// Unit: 1, m, rad, m/s or rad/s.
    /// Test: `invariant_orders_out_of_proportion_are_refused_and_large_ones_accepted`.
    pub(crate) const LARGEST_TOLERANCE: f64 = 1.0;

    /// Numbers in all samples together: 8 GB. A sample of ten thousand bodies has a hundred thousand numbers.
    /// Unit: numbers.
    /// Test: `invariant_orders_out_of_proportion_are_refused_and_large_ones_accepted`.
    pub(crate) const MAX_NUMBERS: f64 = 1e9;
}

/// Runs in lanes.
pub(crate) mod lanes {
    /// How much of a motion tells which runs take steps of similar length. A tenth is more than the first steps, which are short in all of them.
    /// Unit: share of the run.
    /// Test: `invariant_runs_with_steps_of_similar_length_go_together`.
    pub(crate) const LOOKED_AT: f64 = 0.1;
}
