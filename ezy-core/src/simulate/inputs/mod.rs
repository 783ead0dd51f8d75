//! What acts from outside while a scene runs: numbers, tables, files, control laws, and start values by name.

pub(in crate::simulate) mod control;
pub(in crate::simulate) mod given;
pub(in crate::simulate) mod input_file;
pub(in crate::simulate) mod input_table;
pub(in crate::simulate) mod inputs_guard;
pub(in crate::simulate) mod now;
