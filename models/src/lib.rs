//! The models of EZY.
