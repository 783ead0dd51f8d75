//! Sines and cosines of the angles of one configuration, which all kernels of a scene with counts share.

use crate::model::N_LANES;
use crate::model::coordinate::{N_OF_BODY, n_bodies};
use crate::scalar::{Scalar as _, in_widest};

/// [sin φ, cos φ] of each body, kept until other angles are asked for. Empty in scenes whose kernels take none.
pub(super) struct Sines {
    angles: Vec<f64>,
    table: Vec<[f64; 2]>,
}

impl Sines {
    pub(super) fn new(n_q: usize, takes_sines: bool) -> Self {
        let n = if takes_sines { n_bodies(n_q) } else { 0 };
        Self { angles: vec![f64::NAN; n], table: vec![[f64::NAN; 2]; n] }
    }

    /// Of the configuration `q`.
    #[inline]
    pub(super) fn at(&mut self, q: &[f64]) -> &[[f64; 2]] {
        if !self.table.is_empty() {
            let bodies = q.as_chunks::<N_OF_BODY>().0;
            // without a branch at each, and nothing is written where none differs
            let differ = |(angles, bodies): (&[f64], &[[f64; N_OF_BODY]])| {
                let bits = angles.iter().zip(bodies).map(|(angle, [.., phi])| angle.to_bits() ^ phi.to_bits());
                bits.fold(0, |all, bits| all | bits) != 0
            };
            let at_once = N_LANES * N_LANES;
            if self.angles.chunks(at_once).zip(bodies.chunks(at_once)).any(differ) {
                self.angles.iter_mut().zip(bodies).for_each(|(angle, [.., phi])| *angle = *phi);
                in_widest(
                    #[inline(always)]
                    || f64::sin_cos_of_each(&self.angles, &mut self.table),
                );
            }
        }
        &self.table
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Angles that change by one bit, or only in their sign, are others; x and y do not matter.
    #[test]
    fn analytic_sines_are_those_of_the_last_angles() {
        let mut sines = Sines::new(6, true);
        for [first, second] in [[0.0, 1.0], [-0.0, 1.0], [-0.0, 1.0 + f64::EPSILON], [2.0, f64::NAN], [0.5, -3.0]] {
            for x in [0.0, 7.0] {
                let table = sines.at(&[x, 1.0, first, 2.0, x, second]);
                for (found, phi) in table.iter().zip([first, second]) {
                    let mut expected = [[0.0; 2]];
                    f64::sin_cos_of_each(&[phi], &mut expected);
                    assert_eq!(found.map(f64::to_bits), expected[0].map(f64::to_bits), "{phi}");
                }
                assert_eq!(table.len(), 2);
            }
        }
        assert!(Sines::new(6, false).at(&[0.0; 6]).is_empty());
    }
}
