//! The programs of the README and of the manual, run as documentation tests.
#![doc = include_str!("../../README.md")]
#![doc = include_str!("../../docs/language.md")]
