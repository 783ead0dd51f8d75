//! Interned values, by number.

use rustc_hash::FxHashMap;

use crate::work;

/// Values with ids in order of first appearance.
#[derive(Debug)]
pub struct Interner<T> {
    values: Vec<T>,
    ids: FxHashMap<T, u32>,
}

impl<T> Default for Interner<T> {
    fn default() -> Self {
        Self { values: Vec::new(), ids: FxHashMap::default() }
    }
}

impl<T: Clone + Eq + std::hash::Hash> Interner<T> {
    pub fn get(&self, id: u32) -> &T {
        &self.values[id as usize]
    }

    /// All values, in order of first appearance.
    pub fn values(&self) -> &[T] {
        &self.values
    }

    pub fn len(&self) -> usize {
        self.values.len()
    }

    pub fn intern(&mut self, value: T) -> u32 {
        work::count(1);
        if let Some(&id) = self.ids.get(&value) {
            return id;
        }
        let id = u32::try_from(self.values.len()).unwrap_or(u32::MAX);
        self.values.push(value.clone());
        self.ids.insert(value, id);
        id
    }
}
