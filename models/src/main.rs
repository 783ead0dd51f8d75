//! The `ezy` command line.
fn main() {}
