//! The languages.

use super::Source;
use super::c::C;
use super::julia::Julia;
use super::matlab::Matlab;
use super::python::{CASADI, NUMPY, SYMPY};

/// A language, or a library of Python, that equations are written in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Language {
    /// C99, which is C++, too.
    C,
    /// Python with NumPy; coordinates and velocities may have columns, one for each state.
    Numpy,
    /// Julia, for numbers of any type.
    Julia,
    /// MATLAB and GNU Octave.
    Matlab,
    /// Python with SymPy: the functions take symbols.
    Sympy,
    /// Python with CasADi: functions of its `SX`.
    Casadi,
}

impl Language {
    /// All of them.
    pub const ALL: [Self; 6] = [Self::C, Self::Numpy, Self::Julia, Self::Matlab, Self::Sympy, Self::Casadi];

    /// As it is typed.
    pub const fn name(self) -> &'static str {
        match self {
            Self::C => "c",
            Self::Numpy => "numpy",
            Self::Julia => "julia",
            Self::Matlab => "matlab",
            Self::Sympy => "sympy",
            Self::Casadi => "casadi",
        }
    }

    /// Ending of its files.
    pub const fn ending(self) -> &'static str {
        match self {
            Self::C => "c",
            Self::Numpy | Self::Sympy | Self::Casadi => "py",
            Self::Julia => "jl",
            Self::Matlab => "m",
        }
    }

    pub(super) fn print(self, source: &Source<'_>) -> String {
        match self {
            Self::C => C.file(source),
            Self::Numpy => NUMPY.file(source),
            Self::Julia => Julia.file(source),
            Self::Matlab => Matlab.file(source),
            Self::Sympy => SYMPY.file(source),
            Self::Casadi => CASADI.file(source),
        }
    }
}
