//! Every threshold of the layer: where it comes from, its unit, and a test that needs it.

/// The search for steady motions.
pub(crate) mod search {
    /// Newton steps at most. From a start that is near, ten suffice.
    /// Unit: steps.
    /// Test: `invariant_motion_that_is_not_steady_names_what_is_left`.
    pub(crate) const MAX_STEPS: usize = 60;

    /// Times that a step is halved at most: a millionth of a millionth of it is none.
    /// Unit: halvings.
    /// Test: `analytic_rod_hangs_and_stands`.
    pub(crate) const MAX_HALVINGS: usize = 40;

    /// Longest step, in turns of 1 rad and sizes of the mechanism: a longer one leads away from the nearest rest.
    /// Unit: 1.
    /// Test: `analytic_pendulum_sinks_to_its_nearest_rest`.
    pub(crate) const LONGEST: f64 = 1.0;

    /// Singular values below this share of the largest leave a direction free: a thousand times what rounding leaves of those that are
    /// zero, far below those of an equation that is scaled to one.
    /// Unit: 1.
    /// Test: `analytic_roller_keeps_to_a_circle_that_is_held`.
    pub(crate) const FREE: f64 = 1e-11;

    /// Steps that change positions by less, as a share of the largest one, change nothing but rounding.
    /// Unit: 1.
    /// Test: `analytic_ezyroller_runs_straight`.
    pub(crate) const LAST: f64 = 1e-13;

    /// Where there are no forces, those that move a mass by less of the mechanism's size are rounding: a [`MET`]th of it moves nothing by more than
    /// 1e-16 of the size in 1e7 s.
    /// Unit: 1/s².
    /// Test: `invariant_rests_that_are_free_are_one`.
    pub(crate) const STILL: f64 = 1e-20;

    /// First-order states below this are rounding of zero, which is no size: a step by 1 leaves 1e-16 of them, and a thousand times that is for what
    /// they are multiplied with.
    /// Unit: that of the state.
    /// Test: `invariant_mode_of_a_state_alone_moves_no_body`.
    pub(crate) const NO_STATE: f64 = 1e-13;

    /// Where the turn of a frame moves no part of the mechanism by more than this share of the speed, the motion is straight: ten times what is
    /// left of velocities where steps end.
    /// Unit: 1.
    /// Test: `analytic_slow_turn_is_straight`.
    pub(crate) const STRAIGHT: f64 = 10.0 * MET;

    /// What may be left of an equation where steps end, as a share of the largest term of its kind.
    /// Unit: 1.
    /// Test: `analytic_rod_hangs_and_stands`.
    pub(crate) const MET: f64 = 1e-10;
}

/// The way to a rest that is far.
pub(crate) mod relaxation {
    /// Steps at most: a chain of forty rods takes a hundred.
    /// Unit: steps.
    /// Test: `analytic_hanging_chain_of_forty_rods_swings_as_its_energies_say`.
    pub(crate) const MAX_STEPS: usize = 1000;

    /// Longest step: the largest turn, rad, and the largest displacement as a share of the mechanism's size.
    /// Unit: 1.
    /// Test: `analytic_hanging_chain_of_forty_rods_swings_as_its_energies_say`.
    pub(crate) const STRIDE: f64 = 0.3;

    /// Steps below this share of the longest one lead to where Newton's steps go on.
    /// Unit: 1.
    /// Test: `analytic_hanging_chain_of_forty_rods_swings_as_its_energies_say`.
    pub(crate) const NEAR: f64 = 1e-3;

    /// Least and most by which what resists changes from step to step.
    /// Unit: 1.
    /// Test: `analytic_hanging_chain_of_forty_rods_swings_as_its_energies_say`.
    pub(crate) const FURTHER: f64 = 0.2;
    /// Unit: 1.
    /// Test: `analytic_hanging_chain_of_forty_rods_swings_as_its_energies_say`.
    pub(crate) const SHORTER: f64 = 10.0;
}

/// What rows hold and leave free.
pub(crate) mod row_space {
    /// From more columns on, sparse factors are faster than singular values, which take n³.
    /// Unit: columns.
    /// Test: `cross_sparse_rows_leave_the_same_free`.
    pub(crate) const LARGEST_DENSE: usize = 100;

    /// ε: rows of length one keep four digits of the pivots of those that repeat others.
    /// Unit: 1.
    /// Test: `cross_sparse_rows_leave_the_same_free`.
    pub(crate) const DAMPING: f64 = 1e-12;

    /// Passes: they leave 1e-3 of a direction of σ = √ε, which Newton steps take away.
    /// Unit: passes.
    /// Test: `cross_sparse_rows_leave_the_same_free`.
    pub(crate) const PASSES: usize = 10;

    /// Random directions of length one, of which less is left, are no new ones: a thousandth of a thousandth of what is left of one among a
    /// thousand, far above what rounding leaves.
    /// Unit: 1.
    /// Test: `cross_sparse_rows_leave_the_same_free`.
    pub(crate) const LEFT: f64 = 1e-6;

    /// More directions than there are columns without rows: place and heading, and some.
    /// Unit: directions.
    /// Test: `cross_sparse_rows_leave_the_same_free`.
    pub(crate) const SPARE: usize = 8;
}

/// All rests from many starts.
pub(crate) mod rests {
    use super::search::MET;

    /// Forces at the same place after whole turns differ by less, as a share of the largest of all starts, unless a spring was wound.
    /// Unit: 1.
    /// Test: `analytic_weak_spring_is_wound_or_not`.
    pub(crate) const UNWOUND: f64 = MET;

    /// Rests at less distance are one, in rad and as a share of the mechanism's length: the root of [`MET`], because where two rests merge the
    /// forces grow with the square of the distance from there.
    /// Unit: 1.
    /// Test: `analytic_double_pendulum_has_four_rests`.
    pub(crate) const SAME: f64 = 1e-5;
}

/// Curves of steady motions over a value.
pub(crate) mod continuation {
    /// The longest step changes an angle by so many radians, and lengths and velocities by this share of the largest: what a figure shows as
    /// one line.
    /// Unit: 1.
    /// Test: `analytic_sprung_rod_buckles_at_a_branch_point`.
    pub(crate) const STRIDE: f64 = 0.05;

    /// Cosine of the largest angle by which a step may turn what is seen of the curve: a chord of it leaves the curve by a twentieth.
    /// Unit: 1.
    /// Test: `analytic_sprung_rod_buckles_at_a_branch_point`.
    pub(crate) const TURN: f64 = 0.95;

    /// Newton steps of a correction at most: from a step that is short enough four suffice.
    /// Unit: steps.
    /// Test: `analytic_folds_of_a_slider_crank_over_its_torque`.
    pub(crate) const CORRECTIONS: usize = 8;

    /// A correction of this share of the longest step is the last one: what is left after it is its square.
    /// Unit: 1.
    /// Test: `analytic_folds_of_a_slider_crank_over_its_torque`.
    pub(crate) const LAST_CORRECTION: f64 = 1e-7;

    /// Where a step of this share of the longest one leads nowhere, the curve ends.
    /// Unit: 1.
    /// Test: `analytic_curve_ends_where_the_mechanism_does`.
    pub(crate) const SHORTEST: f64 = 1e-6;

    /// Width in which a fold or a meeting is found along the curve, as a share of the step. The value at a fold is right to its square.
    /// Unit: 1.
    /// Test: `analytic_folds_of_a_slider_crank_over_its_torque`.
    pub(crate) const FOLD: f64 = 1e-13;

    /// Width in which a meeting is bracketed, as a share of the step, before it is interpolated.
    /// Unit: 1.
    /// Test: `analytic_sprung_rod_buckles_at_a_branch_point`.
    pub(crate) const COARSE: f64 = 1e-2;

    /// Distance of the points from which a meeting is interpolated, as a share of the step: the sixth power of it, times that of a step, is below rounding,
    /// and rounding, amplified by one over it, below what is promised.
    /// Unit: 1.
    /// Test: `analytic_sprung_rod_buckles_at_a_branch_point`.
    pub(crate) const BESIDE: f64 = 0.2;

    /// First step on the other curve of a meeting, as a share of the longest one: the curve itself is as far across only at the root of that.
    /// Unit: 1.
    /// Test: `analytic_sprung_rod_buckles_at_a_branch_point`.
    pub(crate) const ASIDE: f64 = 0.02;

    /// How far away the first point of the other curve may be, in its first steps: more is on the curve that is left.
    /// Unit: 1.
    /// Test: `analytic_sprung_rod_buckles_at_a_branch_point`.
    pub(crate) const ACROSS: f64 = 5.0;

    /// Where a stride of an unknown that is kept would move another one by more strides, others are kept.
    /// Unit: 1.
    /// Test: `analytic_oversteering_car_turns_to_both_sides`.
    pub(crate) const FAR: f64 = 10.0;

    /// Places are one that differ by less, as a share of the longest step.
    /// Unit: 1.
    /// Test: `analytic_folds_of_a_slider_crank_over_its_torque`.
    pub(crate) const SAME: f64 = 1e-3;

    /// Points of a branch to one side at most.
    /// Unit: points.
    /// Test: `invariant_endless_branch_says_that_it_goes_on`.
    pub(crate) const MAX_POINTS: usize = 4_000;

    /// Branches at most.
    /// Unit: branches.
    /// Test: `analytic_sprung_rod_buckles_at_a_branch_point`.
    pub(crate) const MAX_BRANCHES: usize = 32;
}

/// Workspaces.
pub(crate) mod workspace {
    /// Singular values of position rows that are scaled to one, as a share of the largest: below it a row repeats others. Rounding leaves 1e-15
    /// of those that are zero.
    /// Unit: 1.
    /// Test: `analytic_rails_at_a_small_angle_hold_the_block_or_are_one`.
    pub(crate) const INDEPENDENT: f64 = 1e-10;

    /// Component of the tangent of a curve, a unit vector, along a coordinate: below it that does not change.
    /// Unit: 1.
    /// Test: `invariant_what_cannot_be_held_is_named`.
    pub(crate) const UNMOVED: f64 = 1e-9;

    /// How far a step may lead to a neighbouring place, in rad and lengths of the mechanism: beyond half a radian its tangent says little.
    /// Unit: 1.
    /// Test: `analytic_arm_reaches_a_ring`.
    pub(crate) const AHEAD: f64 = 0.5;

    /// How far a correction may move from where the tangent leads, in rad and lengths of the mechanism: more may be another way of assembly.
    /// Unit: 1.
    /// Test: `analytic_arm_reaches_a_ring`.
    pub(crate) const ASTRAY: f64 = 0.1;

    /// Steps to a neighbouring place are halved down to this share of the way.
    /// Unit: 1.
    /// Test: `analytic_arm_reaches_a_ring`.
    pub(crate) const SHORTEST: f64 = 1.0 / 256.0;

    /// A value that differs by less, as a share of the range, is an end of it: far above rounding, far below the distance of values.
    /// Unit: 1.
    /// Test: `analytic_parallelogram_has_change_points`.
    pub(crate) const END: f64 = 1e-12;
}

/// Linear equations about a steady motion.
pub(crate) mod linear {
    /// Singular values of rows that are scaled to one, as a share of the largest: below it a row repeats others.
    /// Unit: 1.
    /// Test: `analytic_rows_at_a_small_angle_are_told_from_equal_ones`.
    pub(crate) const INDEPENDENT: f64 = 1e-10;

    /// What may leave the manifold of the constraints, as a share of the rates.
    /// Unit: 1.
    /// Test: `invariant_motion_that_turns_with_the_ground_is_not_steady`.
    pub(crate) const STEADY: f64 = 1e-7;
}

/// Periodic motions.
pub(crate) mod periodic {
    /// Newton steps at most: from a start that is near, six suffice.
    /// Unit: steps.
    /// Test: `analytic_pendulum_has_its_period`.
    pub(crate) const MAX_STEPS: usize = 40;

    /// Times that a step is halved at most; each costs a run.
    /// Unit: halvings.
    /// Test: `analytic_pendulum_has_its_period`.
    pub(crate) const MAX_HALVINGS: usize = 10;

    /// What may be left of a return, as a share of the largest value of its kind: a hundred times what runs at a tolerance of 1e-12 leave.
    /// Unit: 1.
    /// Test: `analytic_pendulum_has_its_period`.
    pub(crate) const RETURNS: f64 = 1e-9;

    /// From here on a step changes nothing but what runs leave, as a share of the largest value of its kind.
    /// Unit: 1.
    /// Test: `analytic_driven_oscillator_has_one_motion`.
    pub(crate) const LAST: f64 = 1e-12;

    /// Singular values of M − 1 below this leave a direction free, such as the amplitude where energy is kept: those of such directions are as
    /// large as what does not yet return, which they may then not be divided by.
    /// Unit: 1.
    /// Test: `invariant_motion_without_return_names_what_does_not`.
    pub(crate) const FREE: f64 = 1e-5;

    /// What equations may change by where a rigid motion, a time or a whole turn is said to change nothing, as a share of their largest entry:
    /// rounding, and a thousand times that.
    /// Unit: 1.
    /// Test: `analytic_driven_oscillator_has_one_motion`.
    pub(crate) const SAME: f64 = 1e-11;

    /// Largest change of a period in a step, as a share of it.
    /// Unit: 1.
    /// Test: `analytic_pendulum_has_its_period`.
    pub(crate) const STRIDE: f64 = 0.3;

    /// A motion this much slower than the one that the search began with is a rest.
    /// Unit: 1.
    /// Test: `invariant_motion_without_return_names_what_does_not`.
    pub(crate) const SLOW: f64 = 1e-6;

    /// Steps of the collocation to begin with, and at most.
    /// Unit: steps.
    /// Test: `analytic_van_der_pol_by_liouville`.
    pub(crate) const N_STEPS: [usize; 2] = [200, 1600];

    /// Where twice as many steps change M by less of its largest entry, they are enough.
    /// Unit: 1.
    /// Test: `analytic_driven_oscillator_has_one_motion`.
    pub(crate) const ENOUGH: f64 = 1e-9;

    /// A modulus nearer to one is one: a double multiplier splits by the root of what runs and collocation leave, 1e-12.
    /// Unit: 1.
    /// Test: `analytic_pendulum_has_its_period`.
    pub(crate) const NEUTRAL: f64 = 1e-6;
}

/// Eigenvalues.
pub(crate) mod spectrum {
    /// Singular values below this share of the largest entry are those of zero: rounding of the entries leaves 1e-15 of it, and a chain of n
    /// zeros n times that.
    /// Unit: 1.
    /// Test: `analytic_eigenvalue_beside_zero_is_told_from_zero`.
    pub(crate) const ZERO: f64 = 1e-11;

    /// Real parts below this share of the largest eigenvalue say nothing: double eigenvalues split by the root of rounding.
    /// Unit: 1.
    /// Test: `analytic_real_part_beside_zero_says_nothing`.
    pub(crate) const ROUNDING: f64 = 1e-8;

    /// Iterations for the Schur form at most: some three an eigenvalue suffice.
    /// Unit: iterations.
    /// Test: `analytic_two_hundred_eigenvalues_converge`.
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
    /// Test: `analytic_rod_on_a_sine_takes_its_torque`.
    pub(crate) const BALANCED: f64 = 1e-12;

    /// Singular values of the effects of inputs on drives, as a share of the largest: below it inputs act alike.
    /// Unit: 1.
    /// Test: `analytic_inputs_that_act_nearly_alike_are_refused`.
    pub(crate) const INDEPENDENT: f64 = 1e-12;

    /// What accelerations with inputs and with drives may differ by, as a share of the largest: what [`BALANCED`] leaves, on a body that is ten
    /// thousand times lighter than what it carries.
    /// Unit: 1.
    /// Test: `analytic_inputs_that_move_what_is_free_are_refused`.
    pub(crate) const KEPT: f64 = 1e4 * BALANCED;
}

/// Eigenvectors.
pub(crate) mod mode {
    /// Shifts beside the eigenvalue, as a share of the norm of the matrix: rounding, and more where a pivot vanishes exactly.
    /// Unit: 1.
    /// Test: `invariant_modes_are_eigenvectors`.
    pub(crate) const SHIFTS: [f64; 3] = [1e-15, 1e-14, 1e-13];

    /// Inverse iterations: the first one leaves a share of 1e-10 of other modes at worst, the third one rounding.
    /// Unit: iterations.
    /// Test: `invariant_modes_are_eigenvectors`.
    pub(crate) const ITERATIONS: usize = 3;

    /// What moves by less than this share of what moves most is not named.
    /// Unit: 1.
    /// Test: `invariant_modes_are_eigenvectors`.
    pub(crate) const VISIBLE: f64 = 0.1;

    /// Deviations that differ by less, as a share of the largest one, are alike: far above rounding.
    /// Unit: 1.
    /// Test: `invariant_modes_are_eigenvectors`.
    pub(crate) const ALIKE: f64 = 1e-6;

    /// Largest angle of a mode that is shown: well seen, and its cosine within a fiftieth of one.
    /// Unit: rad.
    /// Test: `analytic_swing_is_as_large_as_is_seen`.
    pub(crate) const SEEN_ANGLE_RAD: f64 = 0.2;

    /// Largest displacement of a mode that is shown, as a share of the size of the mechanism.
    /// Unit: 1.
    /// Test: `analytic_swing_is_as_large_as_is_seen`.
    pub(crate) const SEEN_SHARE: f64 = 0.1;

    /// Where all coordinates deviate by less, in m and rad, and a first-order state by one, no body moves: a hundred thousand times what rounding leaves.
    /// Unit: m, rad.
    /// Test: `invariant_mode_of_a_state_alone_moves_no_body`.
    pub(crate) const STILL: f64 = 1e-11;
}

/// Root loci.
pub(crate) mod locus {
    /// Width of the interval in which a critical value is found, as a share of it: a hundredth of the 1e-10 that is promised; rounding of
    /// eigenvalues leaves some 1e-12.
    /// Unit: 1.
    /// Test: `analytic_trailer_sways_from_its_critical_speed_on`.
    pub(crate) const WIDTH: f64 = 1e-12;
}

/// Transfer functions.
pub(crate) mod transfer {
    /// What moves a state or shows in the output by less of the largest entry, after balancing, is rounding: entries are right to some 1e-15 of
    /// it, and a thousand times that is for the forces that they come from.
    /// Unit: 1.
    /// Test: `analytic_modes_that_are_not_seen_are_counted`.
    pub(crate) const NEGLIGIBLE: f64 = 1e-12;

    /// Times that all states are balanced at most: three or four suffice.
    /// Unit: sweeps.
    /// Test: `cross_transfer_is_the_response_in_any_units`.
    pub(crate) const MAX_SWEEPS: usize = 20;

    /// Zeros whose real part is less, as a share of the imaginary one, may be on the imaginary axis: where curves touch, two of them split by the
    /// root of rounding, some 1e-7. What is left there decides.
    /// Unit: 1.
    /// Test: `analytic_margins_of_a_third_order_loop`.
    pub(crate) const ON_AXIS: f64 = 1e-6;

    /// What may be left of ln |G|/γ and of the angle of G, where they are to vanish: far above rounding, far below what frequencies beside
    /// the axis leave.
    /// Unit: 1; rad.
    /// Test: `analytic_margins_of_a_third_order_loop`.
    pub(crate) const MET: f64 = 1e-9;

    /// Newton steps for a frequency at most: from an eigenvalue that is right to 1e-7, two suffice.
    /// Unit: steps.
    /// Test: `analytic_bandwidth_beside_a_far_pole`.
    pub(crate) const POLISH: usize = 5;

    /// Levels of the search for the largest magnitude at most: it converges as its square, so that five or six suffice.
    /// Unit: levels.
    /// Test: `analytic_oscillator_has_its_resonance_and_bandwidth`.
    pub(crate) const MAX_LEVELS: usize = 40;

    /// The stationary point is between the frequencies where the magnitude is less than the largest by this share.
    /// Unit: 1.
    /// Test: `analytic_oscillator_has_its_resonance_and_bandwidth`.
    pub(crate) const BRACKET: f64 = 1e-3;

    /// Width of the interval in which the frequency of the largest magnitude is found, as a share of it.
    /// Unit: 1.
    /// Test: `analytic_oscillator_has_its_resonance_and_bandwidth`.
    pub(crate) const WIDTH: f64 = 1e-14;

    /// A phase that is less below half a turn than this is half a turn, and told as negative.
    /// Unit: rad.
    /// Test: `analytic_phase_is_followed_over_wide_steps`.
    pub(crate) const FAR: f64 = 1e-9;

    /// Half the width of a peak or notch without damping in the frequencies of a Bode plot, as a share of its frequency.
    /// Unit: 1.
    /// Test: `analytic_frequencies_stand_close_beside_a_pole_without_damping`.
    pub(crate) const NARROW: f64 = 1e-3;
}
