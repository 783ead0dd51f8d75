//! The arguments of `export`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::value::{Assignment, parse_assignment};

/// Writes the equations of a scene in another language, as one file without a dependency on EZY
///
/// The file has functions for the constants that follow from parameters, for masses, constraints, their Jacobian and convective terms, forces,
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
    /// A document with the equations, for reading
    Latex,
}
