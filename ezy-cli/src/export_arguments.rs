//! The arguments of `export`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::value::{Assignment, parse_assignment};

/// Writes a scene for other tools: its equations in another language, or a functional mock-up unit (FMU)
///
/// A file with equations depends on nothing of EZY. It has functions for the constants that follow from parameters, for masses, constraints, their Jacobian and convective terms, forces,
/// outputs, rates of first-order states, and for accelerations with multipliers, all printed from the equations that runs compute with; names,
/// units and values of coordinates, parameters and inputs are lists in it. Of a model without a scene each scene gets a file.
#[derive(Debug, Args)]
#[cfg_attr(not(feature = "export"), allow(dead_code, reason = "told how to get the command"))]
pub(super) struct ExportArguments {
    /// The language, or the library that the file is for
    pub to: Target,
    /// Its name; case and underscores do not matter
    #[arg(value_name = "MODEL[/SCENE]")]
    pub path: String,
    /// Change a parameter or a count; may be repeated
    #[arg(long, value_name = "NAME=VALUE", value_parser = parse_assignment)]
    pub set: Vec<Assignment>,
    /// Hold a start value, as in `run`; may be repeated
    #[arg(long, value_name = "NAME=VALUE", value_parser = parse_assignment)]
    pub start: Vec<Assignment>,
    /// Project a start that contradicts the constraints onto them, as in `run`
    #[arg(long)]
    pub project_start: bool,
    /// The version of an FMU
    #[arg(long, value_name = "VERSION", default_value = "2")]
    pub fmi: Fmi,
    /// The file, or of a model without a scene the folder [default: out/MODEL_SCENE with the ending of the language]
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum Target {
    /// C99, which C++ reads, too
    C,
    /// Python with NumPy; a state may be a column of many
    Numpy,
    /// Julia, for numbers of any type
    Julia,
    /// MATLAB and GNU Octave
    Matlab,
    /// Python with SymPy
    Sympy,
    /// Python with CasADi
    Casadi,
    /// A functional mock-up unit, for model exchange and co-simulation, with its C sources
    Fmu,
    /// A document with the equations, for reading
    Latex,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum Fmi {
    /// FMI 2.0, which most tools read
    #[value(name = "2")]
    Two,
    /// FMI 3.0
    #[value(name = "3")]
    Three,
}
