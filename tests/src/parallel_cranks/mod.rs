//! Parallel cranks under one coupler, and the pendulum that they are.
//!
//! ```text
//!        o────────o──────────────o         the coupler: it translates, since all cranks are as long
//!       /        /   ·          /
//!      / l      /              /           every crank beyond the second repeats rows for good
//!     o        o              o            the feet, on a straight line
//! ```
//!
//! Where the cranks lie along the line of the feet the rank of the rows falls by one more, and the mechanism could leave its
//! branch: one crank could go on while another one turns back. The cranks pass that position at a finite speed, so their motion is unique and smooth:
//! that of a pendulum of one degree of freedom, which [`pendulum`] integrates by itself.

pub mod judge;
pub mod mechanism;
pub mod members;
pub mod pendulum;
pub mod table;
