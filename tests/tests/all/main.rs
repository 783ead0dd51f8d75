//! Properties of every scene and every solver, one a file.

mod scenes;

mod accuracy;
mod architecture;
mod backends;
mod control;
mod degenerate_forces;
mod dop853;
mod drives;
mod ensemble;
mod exact_start;
mod garage;
mod hand_and_generated;
mod large;
mod local_order;
mod massless;
mod order;
mod other_mechanisms;
mod outputs;
mod paid_when_asked;
mod precise;
mod projection;
mod rank;
mod recording;
mod repeats;
mod selection;
mod self_check;
mod sensitivity;
mod setup;
mod start;
mod stepper;
mod straight_and_locked;
mod symmetries;
mod taylor;
mod trajectories;
mod work;
