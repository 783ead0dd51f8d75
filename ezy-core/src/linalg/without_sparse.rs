//! What stands for sparse factorisations without the feature `sparse`: there are none.

use super::{KktFactorization, SparseKktError, VanishedPivot};
use crate::model::SparsityPattern;
use std::convert::Infallible;
use std::marker::PhantomData;

/// Numbers that sparse factors would take.
pub(crate) trait SparseNumber: Copy {}

impl<T: Copy> SparseNumber for T {}

fn refused(n: usize) -> SparseKktError {
    SparseKktError { n, cause: "`ezy-core` is built without its feature `sparse`".to_owned() }
}

/// Never made.
pub struct SparseKkt(Infallible);

impl SparseKkt {
    /// # Errors
    /// [`SparseKktError`].
    pub fn new(mass: &[f64], _: &SparsityPattern, n_rows: usize) -> Result<Self, SparseKktError> {
        Err(refused(mass.len() + n_rows))
    }

    /// # Errors
    /// [`SparseKktError`].
    pub fn from_entries(mass: &[f64], n_rows: usize, _: Vec<(usize, usize)>) -> Result<Self, SparseKktError> {
        Err(refused(mass.len() + n_rows))
    }
}

/// There are none.
pub(crate) fn by_joints(_: &[f64], _: &SparsityPattern, _: usize) -> Option<Box<dyn KktFactorization>> {
    None
}

impl KktFactorization for SparseKkt {
    fn factor(&mut self, _: &[f64]) -> Result<(), VanishedPivot> {
        match self.0 {}
    }

    fn factor_damped(&mut self, _: &[f64], _: &[f64]) -> Result<(), VanishedPivot> {
        match self.0 {}
    }

    fn smallest_pivot(&self) -> f64 {
        match self.0 {}
    }

    fn solve(&mut self, _: &mut [f64], _: &mut [f64]) {
        match self.0 {}
    }

    fn describe(&self) -> String {
        match self.0 {}
    }
}

/// Never made.
pub(crate) struct SparseLu<T>(Infallible, PhantomData<T>);

impl<T> SparseLu<T> {
    pub(crate) fn new(row_starts: &[usize], _: &[usize]) -> Result<Self, SparseKktError> {
        Err(refused(row_starts.len() - 1))
    }

    pub(crate) fn values_mut(&mut self) -> &mut [T] {
        match self.0 {}
    }

    pub(crate) fn factor(&mut self) -> bool {
        match self.0 {}
    }

    pub(crate) fn solve(&mut self, _: &mut [T]) {
        match self.0 {}
    }
}
