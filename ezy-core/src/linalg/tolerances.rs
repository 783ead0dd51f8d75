//! Every threshold of the layer, with its unit, where it comes from, and the test that fails when it is another one.

/// Which rows depend on which.
pub(crate) mod rank {
    /// An entry may be the pivot when it is at least this part of the largest; the coordinate with the least mass is taken. A tenth is the
    /// usual bound of threshold pivoting (Duff, Erisman, Reid, Direct Methods for Sparse Matrices, 1986, section 5.4).
    pub(crate) const PIVOT_SHARE: f64 = 0.1;

    /// Pivots of rows that count as independent at positions that carry rounding, of rows scaled to one; see [`RankRevealing`](crate::linalg::RankRevealing).
    pub(crate) const INDEPENDENT: f64 = 1e-5;

    /// The same at positions that are exact: half of the digits of what the row decides are left, ε/p = √ε.
    pub(crate) const INDEPENDENT_EXACTLY: f64 = 1e-8;

    /// A row or column takes part in a dependency when its share of the combination exceeds this.
    pub(crate) const PARTICIPATION: f64 = 1e-4;
}

/// What a solution may leave of its equations.
pub(crate) mod refinement {
    /// Refinements of a solution: each leaves about the ratio of masses times ε of its error, 1e-4 at a ratio of 1e12.
    pub(crate) const MAX_REFINEMENTS: usize = 6;

    /// Share of the terms of an equation that counts as their rounding.
    pub(crate) const ROUNDING: f64 = 4.0 * f64::EPSILON;

    /// Terms smaller than this part of the largest may be rounding altogether: what an equation leaves is measured by no less.
    pub(crate) const NEGLIGIBLE: f64 = 1e-2;
}

/// Large systems with redundant rows.
pub(crate) mod damped {
    /// ε: with a relative rounding of 1e-16 in positions, what σ = 3e-5 tells about
    /// accelerations (rounding/σ³) is noise.
    pub(crate) const SHARE: f64 = 1e-9;

    /// A pass squares what it leaves of well determined directions; the others stop here.
    pub(crate) const MAX_PASSES: usize = 10;

    /// A pass that changes x by less than this share of it was the last one.
    pub(crate) const CONVERGED: f64 = 1e-15;
}

/// What is too large.
pub(crate) mod sizes {
    /// Largest n_q + n_c for which a dense K is made: 70 MB and some seconds a factorisation.
    pub(crate) const LARGEST_DENSE: usize = 3_000;

    /// Largest n_q + n_c of a scene whose rank is asked: full pivoting of larger ones takes longer than anyone waits.
    pub(crate) const LARGEST_DIAGNOSED: usize = 500;

    /// Squares of larger numbers, and sums of these, overflow.
    pub(crate) const LARGEST_ENTRY: f64 = 1e150;

    /// A coordinate in more rows than this is a hub: taken before its rows it would couple each of them with all others,
    /// so that a body with n joints would cost n². A hinge on each side of a body and a few more are no hub.
    pub(crate) const HUB_ROWS: usize = 24;

    /// Beyond this many pairs of rows that share a coordinate the order with coordinates first is not tried.
    pub(crate) const MAX_PAIRS: usize = 100_000_000;
}

/// The condition number.
pub(crate) mod conditioning {
    /// Solves of an estimate; two or three are the rule.
    pub(crate) const MAX_SOLVES: usize = 5;

    /// Passes of the equilibration: each takes the root of the exponent that is left, so that the largest ratio of two doubles, 10^632,
    /// ends at 1.4.
    pub(crate) const PASSES: usize = 12;
}
