//! The commands of every program, their arguments and their help.

use std::path::PathBuf;

use clap::{Args, Subcommand, ValueEnum};

use super::export_arguments::ExportArguments;
use super::inverse_arguments::InverseArguments;
use super::motion_arguments::MotionArguments;
use super::periodic_arguments::PeriodicArguments;
use super::steady_arguments::{EquilibriumArguments, LinearizeArguments};
use super::sweep_arguments::SweepArguments;
use super::value::{Assignment, parse_assignment, parse_number};
use super::vary::{Variation, parse_variation};
use super::workspace_arguments::WorkspaceArguments;

// what a command does is said at its arguments
#[derive(Debug, Subcommand)]
pub(super) enum Command {
    /// Lists models and scenes with their effects, sizes and degrees of freedom
    List(ListArguments),
    Show(ShowArguments),
    Run(RunArguments),
    Plot(PlotArguments),
    Compare(CompareArguments),
    Reactions(ReactionsArguments),
    Sweep(SweepArguments),
    Merge(MergeArguments),
    Linearize(LinearizeArguments),
    Animate(AnimateArguments),
    Sketch(SketchArguments),
    Gallery(GalleryArguments),
    Check(CheckArguments),
    Accuracy(AccuracyArguments),
    Equilibrium(EquilibriumArguments),
    Inverse(InverseArguments),
    Periodic(PeriodicArguments),
    Workspace(WorkspaceArguments),
    Export(ExportArguments),
    Completions(CompletionsArguments),
    Man(ManArguments),
}

#[derive(Debug, Args)]
pub(super) struct ListArguments {
    /// A model or a scene, to list it alone
    #[arg(value_name = "MODEL[/SCENE]")]
    pub path: Option<String>,
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
}

/// Prints the derived equations of a model or scene
///
/// Shows the constraints, their Jacobians and convective terms, the mass matrix, the forces and the equations of
/// motion, all printed from the compiled expressions. Then follow the sparsity of the Jacobian, the order of
/// elimination and the operations of one evaluation; for scenes with counts, how their equations are factored and
/// what that costs with these counts.
#[derive(Debug, Args)]
pub(super) struct ShowArguments {
    /// Its name; case and underscores do not matter
    #[arg(value_name = "MODEL[/SCENE]")]
    pub path: String,
    /// Change a count; may be repeated
    #[arg(long, value_name = "NAME=VALUE", value_parser = parse_assignment)]
    pub set: Vec<Assignment>,
    /// How the equations are written
    #[arg(long, value_enum, ignore_case = true, default_value_t)]
    pub format: Format,
}

#[derive(Debug, Clone, Copy, Default, ValueEnum)]
pub(super) enum Format {
    /// Plain text in the names of the model file
    #[default]
    Text,
    /// LaTeX displays
    Latex,
    /// One JSON object with every expression as text, LaTeX and MathML
    Json,
}

/// Runs a scene and prints where it ends
///
/// Numbers may be written as 2, -0.5, 1e-3, pi, -pi/2 or 2*pi. Ctrl-C ends the run with all that it has.
#[derive(Debug, Args)]
pub(super) struct RunArguments {
    /// Its name; case and underscores do not matter
    #[arg(value_name = "MODEL/SCENE")]
    pub path: String,
    #[command(flatten)]
    pub motion: MotionArguments,
    /// Seconds between the rows of --out; needs --out [default: a thousandth of the run]
    #[arg(long, value_name = "DT", value_parser = parse_number, allow_negative_numbers = true)]
    pub every: Option<f64>,
    /// Seconds at which --out has rows, besides the start and the end: 0.1,0.25,2; needs --out
    #[arg(long, value_name = "T,T,…", value_parser = parse_number, value_delimiter = ',', allow_negative_numbers = true, conflicts_with = "every")]
    pub at: Vec<f64>,
    /// Write the motion as CSV: time, coordinates, velocities, accelerations, multipliers, inputs, outputs, work, energies,
    /// residuals
    ///
    /// Rows go to FILE.csv.partial, which becomes FILE.csv when the run ends. A run that is killed leaves the older FILE.csv. A
    /// second run into the same file is refused.
    #[arg(long, value_name = "FILE.csv")]
    pub out: Option<PathBuf>,
    /// Estimate the error of positions, velocities and multipliers, by a second and a third run on other cores
    ///
    /// The second run keeps to a thousandth of the tolerance, or to 1e-13 by dop853 beside fixed steps; the difference, and what the second may be off by itself, is the error. The third one,
    /// from a start that is moved a little, shows how much the motion amplifies errors. The motion itself is the same. FILE.csv
    /// begins with a line `# estimated error …`.
    #[arg(long)]
    pub estimate_error: bool,
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
}

/// Runs a scene and writes an animation of it: one HTML page that needs nothing else
///
/// The page plays the motion, with its forces, outputs and energies. A run that stops early gives a page, too, with the reason.
#[derive(Debug, Args)]
pub(super) struct AnimateArguments {
    /// Its name; case and underscores do not matter
    #[arg(value_name = "MODEL/SCENE")]
    pub path: String,
    #[command(flatten)]
    pub motion: MotionArguments,
    /// Seconds between the frames [default: a thousandth of the run, or more where the page would become large]
    #[arg(long, value_name = "DT", value_parser = parse_number, allow_negative_numbers = true)]
    pub every: Option<f64>,
    /// The page, .html, or a picture that moves: .gif for slides, .svg for web pages [default: out/animation-MODEL-SCENE.html]
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
    /// Write the frames as pictures into a directory, too
    #[arg(long, value_name = "DIR")]
    pub frames: Option<PathBuf>,
    /// How the frames are written
    #[arg(long, value_enum, ignore_case = true, default_value_t, requires = "frames")]
    pub format: FrameFormat,
    /// Pixels across a frame of a .gif or .png [default: 960 along its longer side]
    #[arg(long, value_name = "PIXELS", value_parser = clap::value_parser!(u32).range(50..=4000))]
    pub width: Option<u32>,
}

#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, ValueEnum)]
pub(super) enum FrameFormat {
    /// SVG, sharp at any size
    #[default]
    Svg,
    /// PNG, for programs that make videos
    Png,
}

/// Draws the mechanism of a scene: bodies, joints, wheels and springs with their names and lengths, as SVG
///
/// Lengths have the names of the model. The picture shows the start, or the motion at a time.
#[derive(Debug, Args)]
pub(super) struct SketchArguments {
    /// Its name; case and underscores do not matter
    #[arg(value_name = "MODEL/SCENE")]
    pub path: String,
    /// Change a parameter or a count; may be repeated
    #[arg(long, value_name = "NAME=VALUE", value_parser = parse_assignment)]
    pub set: Vec<Assignment>,
    /// Hold a start value, as in `run`; may be repeated
    #[arg(long, value_name = "NAME=VALUE", value_parser = parse_assignment)]
    pub start: Vec<Assignment>,
    /// Time of the picture in seconds; the scene is run to it
    #[arg(long, value_name = "S", value_parser = parse_number, allow_negative_numbers = true, default_value = "0")]
    pub at: f64,
    /// The picture [default: out/sketch-MODEL-SCENE.svg]
    #[arg(long, value_name = "FILE.svg")]
    pub out: Option<PathBuf>,
}

/// Writes a page with a sketch of every model and an animation of every scene
///
/// Runs every scene as it is declared, by dop853.
#[derive(Debug, Args)]
pub(super) struct GalleryArguments {
    /// A model or a scene, to show it alone
    #[arg(value_name = "MODEL[/SCENE]")]
    pub path: Option<String>,
    /// Directory to write into; made if it does not exist [default: out/gallery]
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}

/// Draws columns of the motion over time, or over each other
///
/// Columns are those of `run --out`, and points: A.x, A.y. `*` stands for any letters. Columns of different units are drawn in panels
/// above each other. Several scenes, or several values with --vary, are drawn into one figure.
#[derive(Debug, Args)]
pub(super) struct PlotArguments {
    /// One scene or several, then columns, such as seat.phi or '*.omega'
    #[arg(value_name = "MODEL/SCENE|COLUMN", required = true)]
    pub what: Vec<String>,
    /// Draw over this column in place of time: a path, a phase plane; two lengths are drawn with equal axes
    #[arg(long, value_name = "COLUMN")]
    pub against: Option<String>,
    /// Run with each of these values: of a parameter, count, input or start value, or of method, step, rtol, atol, angle-tol, project,
    /// metric; may be repeated. 40:60:5 stands for 40,45,50,55,60
    #[arg(long, value_name = "NAME=A,B,…|START:END:STEP", value_parser = parse_variation)]
    pub vary: Vec<Variation>,
    /// The file: .svg, .png or .html [default: MODEL-SCENE.svg]
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
    /// Seconds between points [default: a two-thousandth of the run]
    #[arg(long, value_name = "DT", value_parser = parse_number, allow_negative_numbers = true)]
    pub every: Option<f64>,
    #[command(flatten)]
    pub motion: MotionArguments,
}

/// Compares two motions: the largest difference of each column, and when it occurs
///
/// A motion is a file that `run --out` wrote, or a scene, which is run. One scene with two values of --vary makes two motions. Where
/// the times differ, the second motion is interpolated between its rows by straight lines.
#[derive(Debug, Args)]
pub(super) struct CompareArguments {
    /// Two motions, or one with --vary; then columns, such as '*.phi' [default: all]
    #[arg(value_name = "FILE.csv|MODEL/SCENE|COLUMN", required = true)]
    pub what: Vec<String>,
    /// Run with each of two values: of a parameter, count, input or start value, or of method, step, rtol, atol, angle-tol, project, metric
    #[arg(long, value_name = "NAME=A,B", value_parser = parse_variation)]
    pub vary: Vec<Variation>,
    /// Draw both motions and their difference; .svg, .png or .html. Without columns, that with the largest relative difference
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
    /// Seconds between the times at which runs are compared [default: a two-thousandth of the run]
    #[arg(long, value_name = "DT", value_parser = parse_number, allow_negative_numbers = true)]
    pub every: Option<f64>,
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
    #[command(flatten)]
    pub motion: MotionArguments,
}

/// Runs a scene and prints what its joints bear, and which power each effect and each force has
///
/// For each joint: the largest reaction, its direction and time, mean and root mean square over time, in N or N*m. For each effect and each force: the largest power that
/// it delivers and that it takes, in W, and its work in J; last, works beside the change of kinetic energy. Signs are those of docs/notation.md.
/// Impulses of stops are left out. The scene is run twice, the second time with samples near the largest values.
///
/// Exit status 1 when the run stopped before its end; what it has is printed.
#[derive(Debug, Args)]
pub(super) struct ReactionsArguments {
    /// Its name; case and underscores do not matter
    #[arg(value_name = "MODEL/SCENE")]
    pub path: String,
    #[command(flatten)]
    pub motion: MotionArguments,
    /// Seconds between samples, and between the rows of --out; what is shorter may be missed [default: a two-thousandth of the run]
    #[arg(long, value_name = "DT", value_parser = parse_number, allow_negative_numbers = true)]
    pub every: Option<f64>,
    /// Write multipliers, norms and powers over time as CSV
    #[arg(long, value_name = "FILE.csv")]
    pub out: Option<PathBuf>,
    /// Draw the reaction of each joint with two rows as a curve, its y over its x: a hodograph; .svg, .png or .html
    #[arg(long, value_name = "FILE")]
    pub plot: Option<PathBuf>,
    /// Draw the powers over time; .svg, .png or .html
    #[arg(long, value_name = "FILE")]
    pub plot_power: Option<PathBuf>,
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
}

/// Joins the results of a sweep, and checks that each case is there once
///
/// Shares of a sweep may be in one folder or in several. Without --out the results are only checked.
#[derive(Debug, Args)]
pub(super) struct MergeArguments {
    /// Folders that `sweep --out` named
    #[arg(value_name = "DIR", required = true)]
    pub folders: Vec<PathBuf>,
    /// The table as one file, .csv or .parquet
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
    /// Join what is there, though parts are missing
    #[arg(long)]
    pub incomplete: bool,
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
}

/// Prints what a shell needs to complete commands and options; bash and zsh complete models and scenes, too
///
/// A shell looks for them in a file: bash in `~/.local/share/bash-completion/completions/PROGRAM`, zsh in `_PROGRAM` in a folder of
/// its `fpath`, fish in `~/.config/fish/completions/PROGRAM.fish`.
#[derive(Debug, Args)]
pub(super) struct CompletionsArguments {
    /// The shell
    #[arg(value_enum)]
    pub shell: clap_complete::Shell,
}

/// Prints the manual page of the program, or of a command
///
/// To read the page of `run`: write what `man run` prints into `run.1`, and call `man ./run.1`.
#[derive(Debug, Args)]
pub(super) struct ManArguments {
    /// The command
    pub command: Option<String>,
}

/// Checks the generated equations of a model or scene against independent computations
///
/// At a thousand random states: Jacobians and convective terms against finite differences, the generated
/// elimination against the dense and the sparse solver, the power of the effects against force times velocity; then
/// the rank of the constraints at the start and the energy balance of a short run. Exit status 1 when a check fails.
#[derive(Debug, Args)]
pub(super) struct CheckArguments {
    /// Its name; case and underscores do not matter
    #[arg(value_name = "MODEL[/SCENE]")]
    pub path: String,
}

/// Measures what accuracy costs in time: every method, tolerance and projection against a reference
///
/// Prints which method to use for an error of 1e-3, 1e-6, 1e-9 and 1e-12.
#[cfg_attr(
    feature = "figures",
    doc = "Writes index.html, which needs nothing else, its figures as SVG and PNG, and accuracy.csv."
)]
#[cfg_attr(not(feature = "figures"), doc = "Writes accuracy.csv (with the feature `figures` of ezy-cli also a page).")]
/// Errors are those achieved against a reference that a second method
/// confirms; times are processor times of repeated runs that record nothing between their ends. Ctrl-C ends the measurement
/// and writes what was measured.
#[derive(Debug, Args)]
pub(super) struct AccuracyArguments {
    /// Its name; case and underscores do not matter
    #[arg(value_name = "MODEL/SCENE")]
    pub path: String,
    /// End of the runs in seconds [default: what the scene says]
    #[arg(long, value_name = "S", value_parser = parse_number, allow_negative_numbers = true)]
    pub until: Option<f64>,
    /// Change a parameter or a count; may be repeated
    #[arg(long, value_name = "NAME=VALUE", value_parser = parse_assignment)]
    pub set: Vec<Assignment>,
    /// Hold a start value, as in `run`; may be repeated
    #[arg(long, value_name = "NAME=VALUE", value_parser = parse_assignment)]
    pub start: Vec<Assignment>,
    /// Set an input for the whole run, in its unit; may be repeated
    #[arg(long, value_name = "NAME=VALUE", value_parser = parse_assignment)]
    pub input: Vec<Assignment>,
    /// Budget of the measurement in seconds of processor time; settings that are not measured are listed
    #[arg(long, value_name = "SECONDS", value_parser = parse_number, allow_negative_numbers = true, default_value = "60")]
    pub budget: f64,
    /// Directory to write into; made if it does not exist [default: out/accuracy-MODEL-SCENE]
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
}
