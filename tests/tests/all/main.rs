//! Properties of every scene and every solver, one a file.

mod scenes;

mod exact_start;
mod self_check;
mod trajectories;
