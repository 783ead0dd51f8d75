//! Several runs beside each other: in lanes, with derivatives, to estimate an error.

pub(in crate::simulate) mod eight_runs;
pub(in crate::simulate) mod eight_steppers;
pub(in crate::simulate) mod ensemble;
pub(in crate::simulate) mod estimated_run;
pub(in crate::simulate) mod sensitivity;
pub(in crate::simulate) mod together;
pub(in crate::simulate) mod trajectory;
