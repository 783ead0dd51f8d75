//! Every threshold of the layer, with its unit, where it comes from, and the test that fails when it is another one.

/// Lengths of steps.
pub(crate) mod steps {
    /// Shortest step, relative to the time or to one second: shorter steps change nothing.
    pub(crate) const SHORTEST: f64 = 1e-14;

    /// The last step may be longer by this part, so that no tiny step is left.
    pub(crate) const STRETCH: f64 = 1e-3;

    /// Attempts of one step to end at a discontinuity: each one locates it better.
    pub(crate) const MAX_DISCONTINUITIES: u32 = 3;

    /// Stages of a long step that ends at a discontinuity may be beyond it by their own error and then see the other law. So a step covers
    /// this part of the way to the discontinuity, and the rest is a short step of its own.
    pub(crate) const APPROACH: f64 = 31.0 / 32.0;

    /// The rest is short when it is below this part of the attempted step.
    pub(crate) const LEFT: f64 = 1.0 / 16.0;

    /// A step to a discontinuity that is shorter than this part of the attempted one follows another discontinuity closely, as where dry friction
    /// sticks. The next step is then not attempted at full length.
    pub(crate) const SPLINTER: f64 = 1e-5;

    /// A sample within this fraction of a step of a step's end is that end.
    pub(crate) const ON_STEP: f64 = 1e-9;

    /// Number of progress reports.
    pub(crate) const N_PROGRESS: f64 = 100.0;
}

/// Steps next to singular positions.
pub(crate) mod singular {
    /// Singular positions are searched for within this many usual steps.
    pub(crate) const NEAR: f64 = 1.6;

    /// A pivot vanishes where it falls below this part of its present value on the predicted path.
    pub(crate) const VANISHES: f64 = 0.02;

    /// The part of the path that is searched, in predicted distances.
    pub(crate) const SEARCHED: std::ops::Range<f64> = 0.0..1.6;

    /// Where rows are redundant, pivots are evaluated at this many points ahead, each twice as far as the one before. The smallest pivot of
    /// independent rows hardly changes until the last quarter of a radian before a singular position, so that its trend predicts nothing. A
    /// position between two points is at most half as far from one of them as from the present state.
    pub(crate) const N_AHEAD: i32 = 7;

    /// Golden sections: they reduce the path to 1/2000.
    pub(crate) const N_SECTIONS: usize = 16;

    /// The golden section.
    pub(crate) const GOLDEN: f64 = 0.618_033_988_749_894_9;

    /// The usual length falls by this part of each shorter step.
    pub(crate) const FADING: f64 = 0.1;

    /// A step that ends at a singular position is shortened by this factor, since accelerations are inaccurate there.
    pub(crate) const SHORTENED: f64 = 0.9;

    /// A step ends next to a singular position when the smallest pivot falls below this part of its value at the start.
    pub(crate) const TOO_NEAR: f64 = 0.03;

    /// A step whose end cannot be projected is taken again, shorter by this factor, as in CVODE (Hindmarsh and others, ACM Trans. Math.
    /// Softw. 31, 2005).
    pub(crate) const QUARTERED: f64 = 0.25;

    /// Part of the usual length below which steps next to a singular position end the run: six cranks that pass their level position at
    /// 29.7 rad/s take 3,566 steps of dop853 at 1e-13 there, and leave their branch (`level_cranks.rs`).
    pub(crate) const CREEPING: f64 = 1e-4;

    /// Repetitions of one step.
    pub(crate) const MAX_SHORTENED: usize = 3;
}

/// Steps across singular positions.
pub(crate) mod crossing {
    /// Place of the singular position in the crossing step, from 0 to 1: 0.13 of the step from the nearest node of DOP853.
    pub(crate) const MIDDLE: f64 = 0.46;

    /// Its place where the crossing step would otherwise end next to another singular position: 0.07 of the step from the nearest node.
    pub(crate) const BESIDE: [f64; 2] = [0.40, 0.53];

    /// A crossing step ends next to a singular position when the pivot at its end is below this part of the pivot at its start.
    pub(crate) const TOO_NEAR: f64 = 0.1;

    /// The crossing step may begin this factor too far from its ideal start.
    pub(crate) const ABOUT: f64 = 1.1;

    /// Relative error that the shortest steps may have: it is noise.
    pub(crate) const NOISE: f64 = 1e-10;

    /// Attempts of one step.
    pub(crate) const MAX_TRIES: u32 = 10;

    /// Smallest useful tolerance: below it error estimates next to a singular position are rounding.
    pub(crate) const FINEST: f64 = 1e-13;

    /// Tolerance for methods with a fixed step, whose own errors are larger.
    pub(crate) const OF_FIXED_STEPS: f64 = 1e-9;

    /// Next to rank loss, steps are not shorter than this part of the usual length at first. One such step across a singular position
    /// stays farther from it, and from the noise there, than many short ones.
    pub(crate) const SHORTEST: f64 = 1.0 / 16.0;
}

/// Where a force is not smooth.
pub(crate) mod discontinuities {
    /// A discontinuity this close to an end of a step is ignored, in resolutions of the time.
    pub(crate) const AT_END: f64 = 10.0;

    /// Steps end this far behind a discontinuity, in resolutions of the time, so that the next one begins on its other side.
    pub(crate) const BEHIND: f64 = 2.0;

    /// Uncertainty of the predicted distance to a discontinuity, relative to that distance, for a whole step. For shorter distances it
    /// falls in proportion to the distance.
    pub(crate) const UNKNOWN: f64 = 1.0 / 32.0;

    /// Guard against chattering: each shortened step adds [`CUT`], each full step subtracts one. From [`CHATTERING_GUARD`] on discontinuities are
    /// stepped over, as where dry friction sticks or where a value is only rounding.
    pub(crate) const CUT: u32 = 2;

    /// See [`CUT`].
    pub(crate) const CHATTERING_GUARD: u32 = 48;

    /// Shortest step across a discontinuity, relative to the time: shorter steps move nothing.
    pub(crate) const SHORTEST_CROSSING: f64 = 2e-14;
}

/// Roots of event functions.
pub(crate) mod events {
    /// Events are located to this accuracy, s, or to the resolution of the time.
    pub(crate) const RESOLUTION_S: f64 = 1e-12;

    /// More evaluations are never needed: each second one halves the bracket at least, from an hour to 1e-12 s in 52.
    pub(crate) const MAX_EVALUATIONS: usize = 200;

    /// Parts of a step at whose ends event functions are sampled.
    pub(crate) const N_PARTS: usize = 4;

    /// An initial value below this part of the largest one in the first step is rounding: its sign is taken as zero.
    pub(crate) const NOTHING: f64 = 1e-10;

    /// Parabolas that are tried, each through the last three samples.
    pub(crate) const MAX_PARABOLAS: usize = 3;

    /// A predicted minimum above this part of the smaller end value does not reach zero.
    pub(crate) const SHALLOW: f64 = 0.5;
}

/// Changes of mode.
pub(crate) mod modes {
    /// Smallest step, relative to the requested one, when a mode ends where it begins. In shorter steps the rounding of an
    /// interpolated value dominates.
    pub(crate) const SHORTEST: f64 = 1e-5;

    /// The step is shortened by this factor when a mode may end within a quarter of it.
    pub(crate) const SHORTER: f64 = 0.25;

    /// Changes of mode at one time after which the run gives up.
    pub(crate) const MAX_AT_ONCE: usize = 8;

    /// Bounces become shorter and shorter, infinitely many in a finite time. A flight shorter than this many times the resolution
    /// of time is skipped: the stop holds.
    pub(crate) const SHORTEST_FLIGHT: f64 = 1e3;

    /// A flight lower than this many roundings of the quantity is skipped, too.
    pub(crate) const LOWEST_FLIGHT: f64 = 16.0;

    /// A flight ends within this factor of its duration under a constant force.
    pub(crate) const LONG_ENOUGH: f64 = 1.25;

    /// A start may be beyond an end by this many position tolerances.
    pub(crate) const BEYOND: f64 = 100.0;
}

/// What a run watches.
pub(crate) mod monitors {
    /// Unknowns up to which a dense factorisation at start and end is cheap beside a run.
    pub(crate) const LARGEST_WATCHED: usize = 200;

    /// Steps between two looks at least; in larger scenes the square of their unknowns.
    pub(crate) const FEWEST_BETWEEN: u64 = 4096;

    /// What a sum of a handful of terms may lose to rounding, over their size.
    pub(crate) const ROUNDING: f64 = 16.0 * f64::EPSILON;

    /// Default limit on the steps of a method that chooses their length: about a minute of computing. The number of fixed steps is
    /// checked when the run is built.
    pub(crate) const MAX_CHOSEN_STEPS: u64 = 10_000_000;

    /// Steps between two evaluations of velocity residuals. One costs a third of an evaluation of the accelerations, and after a
    /// projection the residual is rounding.
    pub(crate) const N_BETWEEN_LOOKS: u64 = 16;

    /// More intervals say nothing new: the mechanism passes a singular position at every turn.
    pub(crate) const MAX_INTERVALS: usize = 16;
}

/// What may be ordered.
pub(crate) mod orders {
    /// A quarter of an hour at 100 ns a step; more is a typing error.
    pub(crate) const MAX_STEPS: f64 = 1e10;

    /// A larger tolerance accepts any motion.
    pub(crate) const LARGEST_TOLERANCE: f64 = 1.0;

    /// Samples of a run: a few hundred bytes each, some gigabytes.
    pub(crate) const MAX_SAMPLES: f64 = 1e7;

    /// Numbers in all samples together: 8 GB. A sample of ten thousand bodies has a hundred thousand numbers.
    pub(crate) const MAX_NUMBERS: f64 = 1e9;
}
