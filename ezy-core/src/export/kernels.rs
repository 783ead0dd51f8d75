//! What printers need of the kernels of a scene, and the variables that they read.

use crate::model::SceneInfo;
use crate::scalar::{Operand, Recorded, Tape};

/// A group of variables that a kernel reads.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Group {
    Time,
    Coordinates,
    Velocities,
    States,
    Inputs,
    Constants,
    Parameters,
    SeedsOfCoordinates,
    SeedsOfVelocities,
    SeedsOfStates,
    SeedsOfInputs,
}

impl Group {
    /// As an argument.
    pub(super) const fn letter(self) -> &'static str {
        match self {
            Self::Time => "t",
            Self::Coordinates => "q",
            Self::Velocities => "v",
            Self::States => "z",
            Self::Inputs => "u",
            Self::Constants => "c",
            Self::Parameters => "p",
            Self::SeedsOfCoordinates => "dq",
            Self::SeedsOfVelocities => "dv",
            Self::SeedsOfStates => "dz",
            Self::SeedsOfInputs => "du",
        }
    }

    const MOTION: [Self; 6] =
        [Self::Time, Self::Coordinates, Self::Velocities, Self::States, Self::Inputs, Self::Constants];
}

/// A vector or a matrix that a kernel returns. A matrix has its rows one behind the other.
#[derive(Debug)]
pub(super) struct Returned {
    pub name: &'static str,
    /// Columns of a matrix.
    pub n_columns: Option<usize>,
    pub values: Vec<Operand>,
}

/// A function of an exported file.
#[derive(Debug)]
pub(super) struct Kernel {
    pub name: &'static str,
    pub about: &'static str,
    pub arguments: Vec<Group>,
    pub tape: Tape,
    pub returned: Vec<Returned>,
}

/// All functions, in the order in which they are printed.
#[derive(Debug)]
pub(super) struct Kernels {
    pub constants: Kernel,
    pub of_motion: Vec<Kernel>,
    /// `None` where rows are there and no generated elimination solves: then the file solves a full matrix.
    pub accelerations: Option<Kernel>,
    pub pivot: Option<Kernel>,
    /// Derivatives of accelerations, multipliers, rates and outputs along a direction, where they are asked for.
    pub derivatives: Option<Kernel>,
    /// Variables of each group: the first one, and how many there are.
    pub variables: Variables,
}

/// Which variable is which, and which groups a scene has.
#[derive(Debug, Clone)]
pub(super) struct Variables {
    sizes: Vec<(Group, usize)>,
}

impl Variables {
    pub(super) fn new(info: &SceneInfo) -> Self {
        let sizes = [
            (Group::Time, 1),
            (Group::Coordinates, info.n_coordinates()),
            (Group::Velocities, info.n_velocities()),
            (Group::States, info.n_states()),
            (Group::Inputs, info.n_inputs()),
            (Group::Constants, info.n_constants),
            (Group::Parameters, info.parameters.len() + info.switches.len()),
            (Group::SeedsOfCoordinates, info.n_coordinates()),
            (Group::SeedsOfVelocities, info.n_velocities()),
            (Group::SeedsOfStates, info.n_states()),
            (Group::SeedsOfInputs, info.n_inputs()),
        ];
        Self { sizes: sizes.to_vec() }
    }

    pub(super) fn size(&self, group: Group) -> usize {
        self.sizes.iter().find(|&&(of, _)| of == group).map_or(0, |&(_, n)| n)
    }

    pub(super) fn recorded(&self, group: Group) -> Vec<Recorded> {
        let before = self.sizes.iter().take_while(|&&(of, _)| of != group);
        let first: usize = before.map(|&(_, n)| n).sum();
        (first..first + self.size(group)).map(Recorded::variable).collect()
    }

    /// Group and place of a variable.
    pub(super) fn place(&self, mut variable: usize) -> (Group, usize) {
        for &(group, n) in &self.sizes {
            if variable < n {
                return (group, variable);
            }
            variable -= n;
        }
        (Group::Time, 0)
    }

    /// The changes that derivatives take, in the order of the arguments.
    pub(super) fn seeds(&self) -> Vec<Group> {
        let all = [Group::SeedsOfCoordinates, Group::SeedsOfVelocities, Group::SeedsOfStates, Group::SeedsOfInputs];
        all.into_iter().filter(|&group| self.size(group) > 0).collect()
    }

    /// What functions of the motion take: first-order states and inputs only in scenes that have some.
    pub(super) fn of_motion(&self) -> Vec<Group> {
        let is_there = |&group: &Group| !matches!(group, Group::States | Group::Inputs) || self.size(group) > 0;
        Group::MOTION.into_iter().filter(is_there).collect()
    }
}

impl Kernels {
    /// All of them, the accelerations last.
    pub(super) fn all(&self) -> impl Iterator<Item = &Kernel> {
        let first = std::iter::once(&self.constants).chain(&self.of_motion);
        let last = [&self.accelerations, &self.pivot, &self.derivatives];
        first.chain(last.into_iter().flatten())
    }
}
