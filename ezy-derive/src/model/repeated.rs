//! What the `for` of a resolved model say: whole numbers that coefficients depend on, and their values as declared.

use super::whole::{CountId, IndexId, Values, Whole};
use super::{Loop, Model};

impl Model {
    /// The whole numbers that coefficients depend on: counts, indices of `for`, then quotients.
    fn wholes(&self) -> impl Iterator<Item = Whole> {
        let counts = (0..self.counts.len()).map(|i| Whole::Count(CountId(i)));
        let indices = (0..self.indices.len()).map(|i| Whole::Index(IndexId(i)));
        counts.chain(indices).chain(self.quotients.iter().cloned())
    }

    /// The one at this place.
    pub fn whole(&self, place: usize) -> Option<Whole> {
        self.wholes().nth(place)
    }

    /// How many parameters and whole numbers there are.
    pub fn n_values(&self) -> usize {
        self.parameters.len() + self.wholes().count()
    }

    /// Parameters and whole numbers as declared: counts, and indices in the first pass of their `for`; NaN where there is none. Last the
    /// switches of as many rows that hold as a scene may have.
    pub fn defaults(&self) -> Vec<f64> {
        let counts: Vec<i64> = self.counts.iter().map(|count| count.default).collect();
        let mut indices = Vec::new();
        for id in (0..self.indices.len()).map(IndexId) {
            let values = Values { counts: &counts, indices: &indices };
            let range = self.loops_to(id).last().map(|range| [&range.from, &range.to].map(|end| end.evaluate(&values)));
            if let Some([Some(from), Some(to)]) = range
                && from < to
            {
                indices.push((id, from));
            }
        }
        let values = Values { counts: &counts, indices: &indices };
        let wholes = self.wholes().map(|whole| whole.evaluate(&values).map_or(f64::NAN, |value| value as f64));
        let n_switched = self.rows.iter().filter(|row| row.limit().is_some()).count() + self.stops.len().min(1);
        let switches = std::iter::repeat_n([1.0, 0.0], n_switched).flatten();
        self.parameters.iter().map(|parameter| parameter.default).chain(wholes).chain(switches).collect()
    }

    /// The `for` of an index with those around it, outermost first.
    pub fn loops_to(&self, index: IndexId) -> &[Loop] {
        let to_index = |loops: &[Loop]| loops.iter().position(|around| around.index == index);
        self.all_loops().find_map(|loops| Some(&loops[..=to_index(loops)?])).unwrap_or_default()
    }

    /// The `for` around each item and each start value.
    fn all_loops(&self) -> impl Iterator<Item = &[Loop]> {
        let bodies = self.arrays.iter().map(|of| &of.loops);
        let (points, rows) = (self.points.iter().map(|of| &of.loops), self.rows.iter().map(|of| &of.loops));
        let (forces, outputs) = (self.forces.iter().map(|of| &of.loops), self.outputs.iter().map(|of| &of.loops));
        let starts = self.starts.iter().flat_map(|start| &start.values).map(|of| &of.loops);
        bodies.chain(points).chain(rows).chain(forces).chain(outputs).chain(starts).map(|loops| &loops[..])
    }
}
