//! Samples in memory.

use super::{RecordError, Recorder, Sample, UnknownName, Wanted, column_index, columns};
use crate::model::SceneInfo;
use std::sync::Arc;

/// Samples of one run, one after the other in a single vector.
#[derive(Debug, Clone)]
pub(crate) struct Record {
    info: Arc<SceneInfo>,
    wanted: Wanted,
    n_numbers: usize,
    numbers: Vec<f64>,
}

impl Record {
    /// An empty record of samples that hold what is wanted.
    pub(crate) fn new(info: Arc<SceneInfo>, wanted: Wanted) -> Self {
        Self { n_numbers: Sample::n_numbers(&info, wanted), info, wanted, numbers: Vec::new() }
    }

    /// Adds a sample.
    pub(crate) fn push(&mut self, sample: &Sample<'_>) {
        self.numbers.extend(sample.numbers());
    }

    /// Drops all samples but the first.
    pub(crate) fn keep_first(&mut self) {
        self.numbers.truncate(self.n_numbers);
    }

    /// A number of the last sample that is none, with the name of its column.
    pub(crate) fn no_number_at_end(&self) -> Option<(String, f64)> {
        let last = self.samples().next_back()?;
        let (i, value) = last.numbers().enumerate().find(|(_, x)| !x.is_finite())?;
        Some((columns(&self.info, self.wanted).swap_remove(i).name, value))
    }

    /// Number of samples.
    pub(crate) fn len(&self) -> usize {
        self.numbers.len() / self.n_numbers
    }

    /// Sample `i`, `None` past the last.
    pub(crate) fn get(&self, i: usize) -> Option<Sample<'_>> {
        (i < self.len()).then(|| self.at(i))
    }

    /// Sample `i`, which the caller knows to be there.
    pub(crate) fn at(&self, i: usize) -> Sample<'_> {
        Sample::from_numbers(&self.info, self.wanted, &self.numbers[i * self.n_numbers..][..self.n_numbers])
    }

    /// The samples in order of time.
    pub(crate) fn samples(&self) -> impl DoubleEndedIterator<Item = Sample<'_>> + ExactSizeIterator {
        self.numbers.chunks_exact(self.n_numbers).map(|numbers| Sample::from_numbers(&self.info, self.wanted, numbers))
    }

    /// One column of every sample.
    ///
    /// # Errors
    /// [`UnknownName`] with the nearest column.
    pub(crate) fn column(&self, name: &str) -> Result<Vec<f64>, UnknownName> {
        let i = column_index(&self.info, self.wanted, name)?;
        Ok(self.numbers.chunks_exact(self.n_numbers).map(|numbers| numbers[i]).collect())
    }
}

impl Recorder for Record {
    fn record(&mut self, sample: &Sample<'_>) -> Result<(), RecordError> {
        self.push(sample);
        Ok(())
    }
}
