//! `ezy study`.

use super::arguments::StudyArguments;
use super::failure::Failure;

pub fn study(_arguments: &StudyArguments) -> Result<(), Failure> {
    Err(Failure::stopped("x"))
}
