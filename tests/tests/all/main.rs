//! Properties of every scene and every solver, one a file.

mod scenes;

mod accuracy;
mod adaptive;
mod angles;
mod architecture;
mod assembly_modes;
mod backends;
#[cfg(feature = "analysis")]
mod bifurcations;
mod circles;
mod control;
mod count_table;
mod degenerate_forces;
mod discontinuities;
mod dop853;
mod drawing;
mod drives;
mod ensemble;
#[cfg(feature = "analysis")]
mod equilibria;
mod error_estimate;
mod events;
mod exact_start;
mod feedback;
mod fields;
mod first_order;
mod fuzz;
mod garage;
#[cfg(feature = "analysis")]
mod gradients;
mod guide;
mod hand_and_generated;
mod hard;
#[cfg(feature = "analysis")]
mod inverse_dynamics;
mod large;
mod level_cranks;
#[cfg(feature = "analysis")]
mod linear;
mod local_order;
mod long_runs;
mod massless;
mod massless_links;
mod methods;
mod monitors;
mod moving_pictures;
mod names;
mod order;
mod other_mechanisms;
mod outputs;
mod packages;
mod parallel_cranks;
#[cfg(feature = "analysis")]
mod periodic_motions;
mod precise;
mod projection;
mod radau;
mod rank;
mod recording;
mod redundant;
mod repeats;
mod scale_lengths;
mod scale_masses;
mod selection;
mod self_check;
mod sensitivity;
mod setup;
mod singular_starts;
mod singularity_crossing;
mod singularity_crossing_cases;
mod space;
mod start;
mod starts_assembly;
mod starts_projected;
mod steered;
mod stepper;
mod stick_slip;
mod stop;
mod straight_and_locked;
mod switched_rows;
mod symmetries;
mod taylor;
mod threes;
mod tolerances;
#[cfg(feature = "analysis")]
mod towed;
mod trajectories;
mod treads;
mod unequal_masses;
mod unequal_members;
mod walks;
mod work;
#[cfg(feature = "analysis")]
mod workspaces;
