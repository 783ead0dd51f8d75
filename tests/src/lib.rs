//! What the tests of EZY share: an EzyRoller written by hand, and the reference trajectories.

pub mod hand_roller;
pub mod reference;
