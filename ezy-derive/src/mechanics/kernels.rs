//! The kernels of a scene: a program for each quantity that is computed from a state, and where its outputs go.

use std::collections::BTreeMap;

use crate::model::{BodyId, Loop};
use crate::symbolic::Symbol;
use crate::symbolic::program::{Count, Program};

/// What a kernel computes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Quantity {
    MassMatrix,
    PositionConstraint,
    VelocityConstraint,
    VelocityJacobian,
    ConvectiveTerm,
    AppliedForce,
    /// Of the first-order states.
    StateRates,
    Accelerations,
    Correction,
    ProjectedAccelerations,
    /// From coordinates and velocities.
    QuasiVelocities,
    /// From coordinates and quasi-velocities.
    Velocities,
    /// What the next one reads that depends on time and inputs alone.
    OfTime,
    /// From coordinates and quasi-velocities, then the rates of the coordinates that they depend on, then sines that these rates read.
    QuasiAccelerations,
    /// These rates, from these sines.
    QuasiRates,
    /// The angles of these sines.
    QuasiAngles,
    /// From coordinates and quasi-velocities, then the rates of the coordinates that are integrated.
    QuasiMotion,
    /// Coordinates, with those that position constraints give from the others, then velocities, from quasi-velocities.
    WholeState,
    Power,
    Points,
    Outputs,
    Events,
    LimitedSkates,
    Stop,
    PotentialEnergy,
    Start,
    Jacobians,
    /// The same by first-order states.
    StateJacobians,
    /// Points, directions and loads of what a picture shows.
    Elements,
    /// Of each force element.
    ElementPowers,
    /// Of the Taylor series: the start of a step, then three kernels an order.
    SeriesBegin,
    SeriesRightSide,
    SeriesSolution,
    SeriesFinish,
}

/// The kernels of a scene.
pub type Kernels<'m> = BTreeMap<Quantity, Kernel<'m>>;

/// A quantity as programs: one of a scene whose bodies are known, one for each item of a scene with counts.
#[derive(Debug)]
pub struct Kernel<'m> {
    pub passes: Vec<Pass<'m>>,
    /// Of an elimination, rows of each watched pivot. Pivots and their thresholds are the last outputs of the program.
    pub pivots: Option<Vec<Vec<usize>>>,
}

impl<'m> Kernel<'m> {
    pub fn of(passes: Vec<Pass<'m>>) -> Self {
        Self { passes, pivots: None }
    }

    /// How many of these one member of each pass has.
    pub fn n(&self, what: Entries) -> usize {
        self.passes.iter().map(|pass| pass.n(what)).sum()
    }

    /// Operations of all passes, each made once.
    pub fn count(&self) -> Count {
        self.passes.iter().map(|pass| pass.program.count()).sum()
    }
}

/// A program that is run for each member of an item.
#[derive(Debug)]
pub struct Pass<'m> {
    /// The `for` around it, outermost first.
    pub loops: &'m [Loop],
    /// The bodies that it refers to.
    pub slots: Vec<BodyId>,
    pub program: Program,
    /// Where each output goes.
    pub puts: Vec<Put>,
    /// What it reads besides time, coordinates, velocities and inputs; ascending by symbol.
    pub reads: Vec<(Symbol, Read)>,
    /// How many rows and entries of a series a member has for itself, where a kernel counts them.
    pub lengths: Vec<(Entries, usize)>,
}

impl<'m> Pass<'m> {
    /// Made once, without anything to count.
    pub fn once(program: Program, puts: Vec<Put>, reads: Vec<(Symbol, Read)>) -> Self {
        Self { loops: &[], slots: Vec::new(), program, puts, reads, lengths: Vec::new() }
    }

    /// How many of these a member has for itself.
    pub fn n(&self, what: Entries) -> usize {
        self.lengths.iter().find(|(other, _)| *other == what).map_or(0, |&(_, n)| n)
    }

    /// What a symbol stands for that is no time, coordinate, velocity or input.
    pub fn read(&self, symbol: Symbol) -> Option<Read> {
        self.reads.binary_search_by_key(&symbol, |&(other, _)| other).ok().map(|place| self.reads[place].1)
    }
}

/// What an array has entries for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Entries {
    Coordinates,
    Rows,
    QuasiVelocities,
    OfTime,
    /// Sines and cosines of angles.
    Sines,
    /// Products of series.
    Products,
    /// Numbers of a whole step.
    Base,
    /// Coefficients that later orders read.
    Kept,
}

/// Where an output goes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Put {
    /// To the next place of a vector: its number among those that the kernel writes.
    Next(usize),
    /// Added to the entry of a coordinate.
    Coordinate(usize),
    /// Added to the entry of a group.
    Group(usize),
    /// Added to the value of the kernel.
    Total,
    /// A start value of a coordinate.
    Start { index: usize, rate: bool, near: bool },
    /// To the storage of a series.
    Slot(Slot),
}

/// What a symbol stands for.
#[derive(Debug, Clone, Copy)]
pub enum Read {
    /// Of a coordinate.
    Acceleration(usize),
    /// Of a row, among those of the pass.
    Multiplier(usize),
    /// Of a row.
    Residual(usize),
    QuasiVelocity(usize),
    OfTime(usize),
    /// Sine or cosine of an angle.
    Sine(usize),
    /// Of the storage of a series.
    Slot(Slot),
}

/// A number in the storage of a series. `Ahead` counts orders from the present one, k: what belongs to order k + 2 is 2 ahead.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Slot {
    /// A value at the start of the step, or of the factors of K.
    Base(usize),
    /// The sum of a product.
    Sum(usize),
    /// A coefficient that later orders read.
    Kept(Ahead, usize),
    /// A coefficient of q.
    Coordinate(Ahead, usize),
    /// A coefficient of z, which stands first among those that are kept.
    State(Ahead, usize),
    /// f of order k.
    Force(usize),
    /// r of order k.
    Row(usize),
    /// a of order k.
    Acceleration(usize),
    /// λ of order k.
    Multiplier(usize),
    /// A coefficient of the left factor of a product.
    Left(Ahead, usize),
    /// A coefficient of the right factor of a product.
    Right(Ahead, usize),
    /// The order as a number.
    Order(Ahead),
    /// Its reciprocal.
    InverseOrder(Ahead),
}

/// Orders after the present one.
pub type Ahead = usize;
