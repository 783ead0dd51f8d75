//! Every threshold of the layer, with its unit, where it comes from, and the test that fails when it is another one.

/// What counts as zero.
pub(crate) mod geometry {
    /// Residual of a row, as a share of its size, that counts as zero; a size beyond 1 counts as 1.
    pub(crate) const TOLERANCE: f64 = 1e-12;

    /// Rounding of a row in units of ε times the size of its terms: a row sums a handful of them.
    pub(crate) const ROUNDING_OF_ROWS: f64 = 8.0 * f64::EPSILON;

    /// However large the coordinates, a residual above this is not rounding: the motion has run away.
    pub(crate) const LARGEST_TOLERANCE: f64 = 1e-6;
}

/// Back onto the constraints.
pub(crate) mod projection {
    /// Gauss–Newton passes; from the drift of one step two are plenty.
    pub(crate) const MAX_PASSES: usize = 10;

    /// Passes before a residual may be taken for rounding: at 1e6 rad a correction of an angle is lost, but what x and y take of it
    /// is not, so that each pass leaves a part.
    pub(crate) const PASSES_TO_ROUNDING: usize = 3;

    /// The first one converges quadratically, the second one removes its rounding.
    pub(crate) const PASSES_NEAR_RANK_LOSS: usize = 2;

    /// |C| that may stay where constraints nearly depend on each other: there its square root is a displacement, and the next step,
    /// farther away, removes both.
    pub(crate) const TOLERANCE_AT_RANK_LOSS: f64 = 1e-10;

    /// A velocity correction this many times as large as the residual that it removes shows rows that nearly depend on each
    /// other; levers of a centimetre make it a hundred times as large.
    pub(crate) const NEAR_RANK_LOSS: f64 = 1e3;

    /// Velocity corrections below this fraction of the velocities are rounding, or harmless.
    pub(crate) const NOTICEABLE: f64 = 1e-10;
}

/// Rows that depend on each other.
pub(crate) mod rank {
    /// Part of the accelerations that redundant rows may leave: where a step ends next to a singular position, rounding of
    /// positions over p³ is far below this, rows that contradict each other far above.
    pub(crate) const ACCELERATIONS_AGREE: f64 = 1e-2;

    /// The same of velocities, in which two factors of p less are noise.
    pub(crate) const VELOCITIES_AGREE: f64 = 1e-6;

    /// Pivots of rows next to dependent ones: sixteen digits of positions leave thirteen of accelerations there, ε/p³.
    pub(crate) const NEARLY_DEPENDENT: f64 = 0.1;

    /// Share of the terms of an equation that accelerations may leave of it. Rows that agree within this share count as redundant.
    pub(crate) const VERIFIED: f64 = 1e-12;
}

/// A consistent start.
pub(crate) mod start {
    /// Gauss–Newton passes: far guesses need some tens, with a step that is halved when it overshoots.
    pub(crate) const MAX_PASSES: usize = 100;

    /// Farthest that one pass turns a body, rad. Longer steps leave the neighbourhood in which the slopes hold, and can end with
    /// an elbow on its other side.
    pub(crate) const LARGEST_TURN: f64 = 0.2;

    /// Halvings of one step before the search counts as stuck.
    pub(crate) const MAX_HALVINGS: usize = 20;

    /// Tries from places nearby when the search is stuck; out of a symmetry the first one or two lead.
    pub(crate) const MAX_NUDGES: usize = 10;

    /// Farthest that such a place is off in an angle, rad: well out of symmetry, without turning a body over.
    pub(crate) const PERTURBATION: f64 = 0.5;

    /// Another place replaces the one found first when it leaves less than this share of its residual.
    pub(crate) const NOTICEABLY_LESS: f64 = 0.9;

    /// Beyond this a coordinate keeps less than a micrometre, and the geometry of a body drowns in its rounding.
    pub(crate) const LARGEST_VALUE: f64 = 1e9;

    /// Passes over the velocity constraints, which are linear: one solve and one that removes its rounding; with damping, some
    /// more for directions of small singular values.
    pub(crate) const VELOCITY_PASSES: usize = 2;

    /// See [`VELOCITY_PASSES`].
    pub(crate) const DAMPED_VELOCITY_PASSES: usize = 10;

    /// Its multiples without their whole parts fill an interval evenly.
    pub(crate) const GOLDEN_RATIO: f64 = 1.618_033_988_749_895;

    /// Directions whose singular value is below this fraction of the largest are left alone.
    pub(crate) const RANK_TOLERANCE: f64 = 1e-10;

    /// Smaller entries of M count as this: their reciprocals would overflow in products.
    pub(crate) const LEAST_WEIGHT: f64 = 1e-280;

    /// Coordinates beyond which corrections come from a sparse factorisation instead of singular values.
    pub(crate) const LARGEST_DENSE_START: usize = 150;

    /// Share of the diagonal of G M⁻¹ Gᵀ that is added to it in sparse corrections, so that rows which repeat others, or
    /// that given values alone decide, leave it regular. Rounding is 1e-4 of it; directions with a singular value of
    /// 1e-4 of the largest still converge by four digits a pass.
    pub(crate) const DAMPING: f64 = 1e-12;
}

/// Which solver a system takes.
pub(crate) mod backend {
    /// The generated elimination divides by masses: of a body this much lighter than the heaviest, under its load, the
    /// accelerations keep twelve digits. Below it the pivoted solver is chosen, which keeps all of them.
    pub(crate) const LIGHTEST: f64 = 1e-4;

    /// Number of equations of a scene with counts up to which light bodies are worth the dense solver. Beyond it the sparse
    /// one is taken, which divides by masses like the generated elimination.
    pub(crate) const LARGEST_FOR_LIGHT: usize = 100;

    /// Range of `g/√m`, whose fourth powers are the determinants of the generated elimination, and whose sums and products with
    /// each other must not leave the range of doubles either.
    pub(crate) const RANGE: std::ops::Range<f64> = 1e-50..1e50;

    /// Largest ratio of such numbers between rows: where it is larger, what a row takes from another is rounding.
    pub(crate) const FURTHEST_APART: f64 = 1e12;
}

/// What messages say.
pub(crate) mod report {
    /// An applied force with at least this part of the largest acceleration is taken for its cause.
    pub(crate) const PART: f64 = 0.25;

    /// Names that a message lists; of more the rest is counted.
    pub(crate) const MAX_LISTED: usize = 40;
}
