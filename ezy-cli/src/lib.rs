//! The command line of a crate with models: `list`, `show`, `run`, `plot`, `compare`, `reactions`, `sweep`, `merge`, `equilibrium`, `linearize`, `inverse`, `periodic`, `workspace`, `export`, `animate`,
//! `sketch`, `gallery`, `check`, `accuracy`, `completions`, `man` and `help`.
//!
//! A crate gets a program of its own in one line:
//!
//! ```no_run
//! # mod my_model { pub static MODEL: ezy_core::model::ModelInfo = ezy_core::model::ModelInfo {
//! #     name: "Nothing", documentation: "", effects: &[], scenes: &[] }; }
//! fn main() -> std::process::ExitCode {
//!     ezy_cli::main(&[&my_model::MODEL])
//! }
//! ```
//!
//! Each `model!` emits the `MODEL`. [`CommandLine`] takes further commands and another text of help. One command is one file
//! here; everything that a command does is done through the public parts of `ezy-core`.

mod accuracy;
mod animate;
mod arguments;
#[cfg(feature = "analysis")]
mod bifurcation_diagram;
mod check;
mod command_line;
mod compare;
mod drawing;
#[cfg(feature = "figures")]
mod drawing_of_columns;
mod equilibrium;
#[cfg(feature = "analysis")]
mod equilibrium_text;
mod examples;
mod export;
mod export_arguments;
#[cfg(feature = "export")]
mod export_unit;
mod failure;
mod gallery;
mod interruption;
mod inverse;
mod inverse_arguments;
#[cfg(feature = "analysis")]
mod inverse_text;
#[cfg(feature = "analysis")]
mod inverse_values;
mod json;
mod leads;
mod linearize;
#[cfg(feature = "analysis")]
mod linearize_text;
mod list;
mod merge;
mod motion;
mod motion_arguments;
mod motion_table;
mod names;
mod out_file;
mod out_path;
mod periodic;
mod periodic_arguments;
#[cfg(feature = "analysis")]
mod periodic_text;
mod plot;
mod progress;
mod quantity;
mod reactions;
mod reactions_text;
#[cfg(feature = "analysis")]
mod response;
#[cfg(feature = "analysis")]
mod response_text;
#[cfg(feature = "analysis")]
mod root_locus;
mod run;
mod run_end;
mod run_error;
mod run_monitors;
mod runs;
mod selection;
mod shell;
mod show;
#[cfg(feature = "analysis")]
mod shown;
mod sketch;
mod slurm;
#[cfg(feature = "analysis")]
mod steady;
mod steady_arguments;
#[cfg(feature = "analysis")]
mod steady_text;
mod sweep;
mod sweep_arguments;
mod sweep_maps;
#[cfg(feature = "analysis")]
mod swing;
mod value;
mod vary;
mod word;
mod workspace;
mod workspace_arguments;
#[cfg(all(feature = "analysis", feature = "figures"))]
mod workspace_figure;
#[cfg(feature = "analysis")]
mod workspace_text;

use std::process::ExitCode;

pub use animate::animation_page;
pub use clap;
pub use command_line::CommandLine;
pub use failure::{Failure, print};
pub use interruption::Interruption;
pub use progress::Progress;
pub use selection::{Selection, find};

use ezy_core::model::ModelInfo;

/// The models of a program, in the order in which they are listed.
type Models<'m> = &'m [&'static ModelInfo];

/// Reads the arguments of the program, does what they ask of `models`, and returns the exit status.
///
/// The status is 0 when the command is done, 1 when it stopped before its end, 2 for wrong use, 130 or 143 when it was interrupted.
pub fn main(models: &[&'static ModelInfo]) -> ExitCode {
    CommandLine::new(models).main()
}
