//! Studies of mechanisms that [`ezy_core`] runs: sweeps, what accuracy costs, tables, figures and drawings.
//!
//! | | |
//! |---|---|
//! | [`sweep`] | thousands of cases on all cores, into files that survive a kill |
//! | [`accuracy`] | what accuracy costs: every method, against a reference |
//! | [`report`] | equations and numbers as tables and pages; with the feature `figures` plots as SVG and PNG |
//! | [`report::drawing`] | the mechanism as a drawing, and as a moving picture |
//! | [`report::reactions`] | the largest forces in the joints, and where power flows |
//! | [`output`] | files that take their place when they are complete |
//!
//! A crate of its own, because none of it computes a motion: `ezy-core` is optimised, and this need not be.
//!
//! # Layers
//!
//! `output ← report ← accuracy`; `output ← sweep`.

#![warn(unreachable_pub)]
// who works on this crate reads the links to what is private
#![allow(rustdoc::private_intra_doc_links)]

pub mod accuracy;
pub mod output;
pub mod report;
pub mod sweep;

/// The program of the README, run as a documentation test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub mod readme {}
