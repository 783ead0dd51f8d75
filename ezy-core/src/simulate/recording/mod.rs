//! Which states are kept, completed to samples.

pub(in crate::simulate) mod run_samples;
pub(in crate::simulate) mod sample_times;
pub(in crate::simulate) mod sampler;
