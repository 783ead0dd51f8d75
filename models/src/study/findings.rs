//! What the measured parts of the study found: the page of claims and the key numbers are written from it.

use super::coast::Coasting;
use super::driven::Drive;
use super::growth::Growth;
use super::projection::Projections;
use super::steps::Steps;
use super::straight::Straight;

/// The parts that are measured, each borrowed.
pub struct Findings<'a> {
    pub projections: &'a Projections,
    pub coasting: &'a Coasting,
    pub straight: &'a Straight,
    pub drive: &'a Drive,
    pub steps: &'a Steps,
    pub growth: &'a Growth,
}
