//! Samples in memory.

use super::{RecordError, Recorder, Sample, UnknownName, columns, find_name};
use crate::model::SceneInfo;

/// Samples of one run, one after the other in a single vector.
#[derive(Debug, Clone)]
pub struct Record {
    info: &'static SceneInfo,
    n_numbers: usize,
    numbers: Vec<f64>,
}

impl Record {
    /// An empty record.
    pub fn new(info: &'static SceneInfo) -> Self {
        Self { info, n_numbers: Sample::n_numbers(info), numbers: Vec::new() }
    }

    /// Adds a sample.
    pub fn push(&mut self, sample: &Sample<'_>) {
        self.numbers.extend(sample.numbers());
    }

    /// Number of samples.
    pub fn len(&self) -> usize {
        self.numbers.len() / self.n_numbers
    }

    /// Whether there is no sample.
    pub fn is_empty(&self) -> bool {
        self.numbers.is_empty()
    }

    /// Sample `i`, `None` past the last.
    pub fn get(&self, i: usize) -> Option<Sample<'_>> {
        (i < self.len()).then(|| self.at(i))
    }

    /// Sample `i`, which the caller knows to be there.
    pub(crate) fn at(&self, i: usize) -> Sample<'_> {
        Sample::from_numbers(self.info, &self.numbers[i * self.n_numbers..][..self.n_numbers])
    }

    /// The samples in order of time.
    pub fn samples(&self) -> impl DoubleEndedIterator<Item = Sample<'_>> + ExactSizeIterator {
        self.numbers.chunks_exact(self.n_numbers).map(|numbers| Sample::from_numbers(self.info, numbers))
    }

    /// One column of every sample.
    ///
    /// # Errors
    /// [`UnknownName`] with the nearest column.
    pub fn column(&self, name: &str) -> Result<Vec<f64>, UnknownName> {
        let all = columns(self.info);
        let i = find_name("column", name, all.iter().map(|c| c.name.as_str()))?;
        Ok(self.numbers.chunks_exact(self.n_numbers).map(|numbers| numbers[i]).collect())
    }
}

impl Recorder for Record {
    fn record(&mut self, sample: &Sample<'_>) -> Result<(), RecordError> {
        self.push(sample);
        Ok(())
    }
}
