//! Exact derivatives of the equations of motion, and what is made of them: rests, stability, periodic motions, torques, workspaces.

mod bifurcations;
mod equilibria;
mod gradients;
mod inverse_dynamics;
mod large;
mod linear;
mod periodic_motions;
mod sensitivities;
mod towed;
mod workspaces;
