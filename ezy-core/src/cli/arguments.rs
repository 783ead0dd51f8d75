//! The commands of every program, their arguments and their help.

use std::path::PathBuf;

use crate::dynamics::{Metric, Projection};
use clap::builder::PossibleValue;
use clap::{Args, Subcommand, ValueEnum};

use super::value::{Assignment, parse_assignment, parse_count, parse_number};

// what a command does is said at its arguments
#[derive(Debug, Subcommand)]
pub(super) enum Command {
    /// Lists models and scenes with their effects, sizes and degrees of freedom
    List(ListArguments),
    Show(ShowArguments),
    Run(RunArguments),
    Animate(AnimateArguments),
    Sketch(SketchArguments),
    Gallery(GalleryArguments),
    Check(CheckArguments),
    Accuracy(AccuracyArguments),
    Completions(CompletionsArguments),
    Man(ManArguments),
}

#[derive(Debug, Args)]
pub(super) struct ListArguments {
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
}

/// Prints the derived equations of a model or scene
///
/// Shows the constraints, their Jacobians and convective terms, the mass matrix, the forces and the equations of
/// motion, all printed from the compiled expressions. Then follow the sparsity of the Jacobian, the order of
/// elimination and the operations of one evaluation.
#[derive(Debug, Args)]
pub(super) struct ShowArguments {
    /// Its name; case and underscores do not matter
    #[arg(value_name = "MODEL[/SCENE]")]
    pub path: String,
    /// How the equations are written
    #[arg(long, value_enum, default_value_t)]
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
    #[command(flatten)]
    pub motion: MotionArguments,
    /// Seconds between the rows of --out; needs --out [default: a thousandth of the run]
    #[arg(long, value_name = "DT", value_parser = parse_number, allow_negative_numbers = true)]
    pub every: Option<f64>,
    /// Write the motion as CSV: time, coordinates, velocities, accelerations, multipliers, inputs, outputs, work, energies,
    /// residuals
    ///
    /// Rows go to FILE.csv.partial, which becomes FILE.csv when the run ends. A run that is killed leaves the older FILE.csv. A
    /// second run into the same file is refused.
    #[arg(long, value_name = "FILE.csv")]
    pub out: Option<PathBuf>,
    /// Estimate the error of positions, velocities and multipliers, by a second and a third run on other cores
    ///
    /// The second run keeps to a hundredth of the tolerance, or takes half the step; the difference is the error. The third one,
    /// from a start that is moved a little, shows how much the motion amplifies errors. The motion itself is the same. FILE.csv
    /// begins with a line `# estimated error …`.
    #[arg(long)]
    pub estimate_error: bool,
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
}

/// What a run computes.
#[derive(Debug, Args)]
pub(super) struct MotionArguments {
    /// Its name; case and underscores do not matter
    #[arg(value_name = "MODEL/SCENE")]
    pub path: String,
    /// End of the run in seconds [default: what the scene says]
    #[arg(long, value_name = "S", value_parser = parse_number, allow_negative_numbers = true)]
    pub until: Option<f64>,
    /// Integration method
    #[arg(long, value_enum, default_value_t)]
    pub method: MethodName,
    /// Step in seconds, of a method with a fixed step [default: 1e-3]
    #[arg(long, value_name = "H", value_parser = parse_number, allow_negative_numbers = true)]
    pub step: Option<f64>,
    /// Relative tolerance, of a method that chooses its steps [default: 1e-9]
    #[arg(long, value_name = "R", value_parser = parse_number, allow_negative_numbers = true)]
    pub rtol: Option<f64>,
    /// Absolute tolerance in m, rad, m/s, rad/s [default: that of --rtol]
    #[arg(long, value_name = "A", value_parser = parse_number, allow_negative_numbers = true)]
    pub atol: Option<f64>,
    /// What is projected onto the constraints after each step
    #[arg(long, value_enum, default_value_t)]
    pub project: Projection,
    /// Metric in which the projection is smallest
    #[arg(long, value_enum, default_value_t)]
    pub metric: Metric,
    /// Stop before the residual of a constraint exceeds R: m or rad in positions, m/s or rad/s in velocities
    #[arg(long, value_name = "R", value_parser = parse_number, allow_negative_numbers = true)]
    pub max_drift: Option<f64>,
    /// Stop before energy and work differ by more than this part of the energy turned over
    #[arg(long, value_name = "R", value_parser = parse_number, allow_negative_numbers = true)]
    pub max_energy_error: Option<f64>,
    /// Stop after N steps, rejected ones included [default: ten million when the method chooses them]
    #[arg(long, value_name = "N", value_parser = parse_count, allow_negative_numbers = true)]
    pub max_steps: Option<u64>,
    /// Change a parameter or a count; may be repeated
    #[arg(long, value_name = "NAME=VALUE", value_parser = parse_assignment)]
    pub set: Vec<Assignment>,
    /// Hold a start value: seat.x, seat.y, seat.phi, seat.vx, seat.vy, seat.omega, …; may be repeated
    ///
    /// A given value replaces that of the scene and is held. Values that neither gives follow from the constraints.
    #[arg(long, value_name = "NAME=VALUE", value_parser = parse_assignment)]
    pub start: Vec<Assignment>,
    /// Project a start that contradicts the constraints onto them instead of refusing it
    ///
    /// All values then change as little as possible in the mass metric: positions first, then velocities.
    #[arg(long)]
    pub project_start: bool,
    /// Set an input, in its unit; may be repeated
    #[arg(long, value_name = "NAME=VALUE", value_parser = parse_assignment)]
    pub input: Vec<Assignment>,
    /// Read inputs from a CSV file with a column t and one for each input
    ///
    /// Straight lines join the rows; two rows at one time are a jump. Columns may carry their unit: `torque [N*m]`. Of a
    /// file that --out wrote, each value holds until the next row.
    #[arg(long, value_name = "FILE.csv")]
    pub inputs: Option<PathBuf>,
}

impl MotionArguments {
    /// A scene as it is declared, by a method that chooses its steps.
    pub(super) fn of(path: String) -> Self {
        Self {
            path,
            until: None,
            method: MethodName::Dop853,
            step: None,
            rtol: None,
            atol: None,
            project: Projection::default(),
            metric: Metric::default(),
            max_drift: None,
            max_energy_error: None,
            max_steps: None,
            set: Vec::new(),
            start: Vec::new(),
            project_start: false,
            input: Vec::new(),
            inputs: None,
        }
    }
}

/// Runs a scene and writes an animation of it: one HTML page that needs nothing else
///
/// The page plays the motion, with its forces, outputs and energies. A run that stops early gives a page, too, with the reason.
#[derive(Debug, Args)]
pub(super) struct AnimateArguments {
    #[command(flatten)]
    pub motion: MotionArguments,
    /// Seconds between the frames [default: a thousandth of the run, or more where the page would become large]
    #[arg(long, value_name = "DT", value_parser = parse_number, allow_negative_numbers = true)]
    pub every: Option<f64>,
    /// The page; a name that ends in .svg gets a picture that moves, for slides [default: out/animation-MODEL-SCENE.html]
    #[arg(long, value_name = "FILE.html")]
    pub out: Option<PathBuf>,
    /// Write the frames as SVG pictures into a directory, too
    #[arg(long, value_name = "DIR")]
    pub frames: Option<PathBuf>,
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
    /// Directory to write into; made if it does not exist [default: out/gallery]
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
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

#[derive(Debug, Clone, Copy, Default, ValueEnum)]
pub(super) enum MethodName {
    /// Classical Runge-Kutta method of order 4 with a fixed step
    #[default]
    Rk4,
    /// Method of Dormand and Prince of order 8 with steps that keep to a tolerance
    Dop853,
    /// Taylor's method with order and steps that keep to a tolerance
    Taylor,
    /// Implicit method Radau IIA of order 5 with steps that keep to a tolerance, for stiff scenes
    Radau,
}

impl ValueEnum for Projection {
    fn value_variants<'a>() -> &'a [Self] {
        &[Self::Both, Self::Positions, Self::Velocities, Self::None]
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        let (name, help) = match self {
            Self::Both => ("both", "Positions, then velocities at the projected positions"),
            Self::Positions => ("positions", "Positions only"),
            Self::Velocities => ("velocities", "Velocities only"),
            Self::None => ("none", "Nothing: the constraints may drift"),
        };
        Some(PossibleValue::new(name).help(help))
    }
}

impl ValueEnum for Metric {
    fn value_variants<'a>() -> &'a [Self] {
        &[Self::Mass, Self::Euclidean]
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        let (name, help) = match self {
            Self::Mass => ("mass", "Weighted by the masses: never adds kinetic energy"),
            Self::Euclidean => ("euclidean", "Unweighted: adds metres to radians; for comparison"),
        };
        Some(PossibleValue::new(name).help(help))
    }
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
#[cfg_attr(not(feature = "figures"), doc = "Writes accuracy.csv (with the feature `figures` of ezy-core also a page).")]
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
