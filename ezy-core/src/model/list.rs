//! Lists of a description, of which those of scenes with counts are made when somebody reads them.

use std::fmt;
use std::ops::{Deref, Range};
use std::panic::{RefUnwindSafe, UnwindSafe};
use std::sync::{Arc, OnceLock};

/// A list of a description. It is read as a slice.
#[derive(Clone)]
pub enum List<T: 'static> {
    /// Data of the program.
    Borrowed(&'static [T]),
    /// Made at run time.
    Owned(Vec<T>),
    /// Of a scene with counts: made when it is first read as a slice.
    Counted(Arc<Counted<T>>),
}

/// A list that the loops of a scene with counts make.
pub struct Counted<T> {
    len: usize,
    items: OnceLock<Vec<T>>,
    make: Box<dyn Fn(Range<usize>) -> Vec<T> + Send + Sync + UnwindSafe + RefUnwindSafe>,
}

impl<T> List<T> {
    /// `make`: makes the items at these places.
    pub(crate) fn counted(
        len: usize,
        make: impl Fn(Range<usize>) -> Vec<T> + Send + Sync + UnwindSafe + RefUnwindSafe + 'static,
    ) -> Self {
        Self::Counted(Arc::new(Counted { len, items: OnceLock::new(), make: Box::new(make) }))
    }

    /// Number of items; none is made.
    #[inline]
    pub fn len(&self) -> usize {
        match self {
            Self::Borrowed(items) => items.len(),
            Self::Owned(items) => items.len(),
            Self::Counted(counted) => counted.len,
        }
    }

    /// Whether there is no item; none is made.
    #[inline]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The item at `place`, without the others.
    ///
    /// # Panics
    /// If there is no such item.
    /// # Cost
    /// A scene with counts goes through its loops: where many are wanted, read the slice.
    pub fn item(&self, place: usize) -> T
    where
        T: Clone,
    {
        self.range(place..place + 1).pop().expect("the place of an item")
    }

    /// The items at these places, without the others.
    ///
    /// # Panics
    /// If there are no such items.
    /// # Cost
    /// As [`Self::item`].
    pub fn range(&self, places: Range<usize>) -> Vec<T>
    where
        T: Clone,
    {
        match self {
            Self::Counted(counted) if counted.items.get().is_none() => (counted.make)(places),
            _ => self[places].to_vec(),
        }
    }
}

#[cfg(test)]
impl<T> List<T> {
    /// Whether all items are there.
    pub(crate) fn is_made(&self) -> bool {
        !matches!(self, Self::Counted(counted) if counted.items.get().is_none())
    }
}

impl<T> Deref for List<T> {
    type Target = [T];

    fn deref(&self) -> &[T] {
        match self {
            Self::Borrowed(items) => items,
            Self::Owned(items) => items,
            // nothing is asked of the loops of a scene that cannot be set up
            Self::Counted(counted) if counted.len == 0 => &[],
            Self::Counted(counted) => counted.items.get_or_init(|| (counted.make)(0..counted.len)),
        }
    }
}

impl<'a, T> IntoIterator for &'a List<T> {
    type Item = &'a T;
    type IntoIter = std::slice::Iter<'a, T>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

impl<T> From<Vec<T>> for List<T> {
    fn from(items: Vec<T>) -> Self {
        Self::Owned(items)
    }
}

impl<T: PartialEq> PartialEq for List<T> {
    fn eq(&self, other: &Self) -> bool {
        **self == **other
    }
}

impl<T: Eq> Eq for List<T> {}

impl<T: fmt::Debug> fmt::Debug for List<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_list().entries(self.iter()).finish()
    }
}
