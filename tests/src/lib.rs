//! Oracles shared by the tests of EZY.
