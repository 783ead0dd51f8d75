//! Detection of stiffness: whether stability and not accuracy limits the steps.

use super::Dop853;
use super::tableau::N_STAGES;
use crate::archive::Archive;
use crate::integrate::Node;
use crate::integrate::tolerances::dop853::{EVERY, N_AT_EDGE, N_OTHERS, STABLE};
use crate::scalar::Scalar;

/// Counts steps at the edge of stability.
///
/// # Source
/// Shampine, Hiebert, Appl. Math. Comp. 3 (1977); Hairer, Wanner, Solving Ordinary Differential Equations II (1996), IV.2, and
/// the constants of the program DOP853 there.
#[derive(Debug, Default)]
pub(crate) struct StiffnessWatch {
    n_steps: u32,
    n_at_edge: u32,
    n_others: u32,
    since: Option<f64>,
}

impl StiffnessWatch {
    /// Forgets the motion so far.
    pub(crate) fn restart(&mut self) {
        (self.n_at_edge, self.n_others) = (0, 0);
    }

    /// Writes it, or reads another one over it.
    pub(super) fn remember<T: Scalar>(&mut self, archive: &mut Archive<T>) {
        [&mut self.n_steps, &mut self.n_at_edge, &mut self.n_others].into_iter().for_each(|n| archive.count_of_few(n));
        archive.option(&mut self.since);
    }

    /// Whether the last step is to be examined.
    pub(crate) fn is_due(&mut self) -> bool {
        self.n_steps += 1;
        self.since.is_none() && (self.n_at_edge > 0 || self.n_steps.is_multiple_of(EVERY))
    }

    /// Notes h |λ| of the step that ended at `t`, s.
    pub(crate) fn note(&mut self, product: f64, t: f64) {
        if product > STABLE {
            self.n_others = 0;
            self.n_at_edge += 1;
            if self.n_at_edge == N_AT_EDGE {
                self.since = Some(t);
            }
        } else {
            self.n_others += 1;
            if self.n_others == N_OTHERS {
                self.restart();
            }
        }
    }

    /// Time of detection, s.
    pub(crate) fn since(&self) -> Option<f64> {
        self.since
    }
}

impl<T: Scalar> Dop853<T> {
    /// `h |λ|` of the largest eigenvalue λ of the motion, from the last two slopes of the step of length `h` that was accepted
    /// last and ended at `to`: both belong to its end.
    pub(crate) fn stability(&mut self, h: f64, to: Node<'_, T>) -> f64 {
        let last = N_STAGES - 1;
        Self::STAGES[last - 1](&self.slopes, &self.start, h, &mut self.stage);
        let n = self.n_controlled();
        let difference = |x: &[T], parts: [&[T]; 3]| {
            let squares = x[..n].iter().zip(parts.into_iter().flatten()).map(|(x, y)| (*x - *y) * (*x - *y));
            squares.fold(T::from_f64(0.0), |sum, square| sum + square).sqrt().magnitude()
        };
        let state = difference(self.stage.as_flattened(), [&to.state.q, &to.state.v, &to.state.z]);
        let slope = difference(self.slopes[last * self.n..].as_flattened(), [to.q_rate, to.a, to.rate]);
        if state > 0.0 { h * slope / state } else { 0.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Examines steps that end at 1 s, 2 s, … with these h |λ|; the time of detection.
    fn detected(products: impl IntoIterator<Item = f64>) -> Option<f64> {
        let mut watch = StiffnessWatch::default();
        products.into_iter().zip(1..).for_each(|(product, t)| watch.note(product, f64::from(t)));
        watch.since()
    }

    #[test]
    fn regress_fifteen_steps_at_the_edge_are_stiff() {
        assert_eq!(detected([6.2; 14]), None);
        assert_eq!(detected([6.2; 40]), Some(15.0));
        assert_eq!(detected([6.0; 40]), None);
    }

    /// Five others between them do not matter, six begin the count again.
    #[test]
    fn regress_six_others_in_a_row_begin_the_count_again() {
        let between = |n: usize| {
            let at_edge = |n: usize| std::iter::repeat_n(7.0, n);
            at_edge(10).chain(std::iter::repeat_n(1.0, n)).chain(at_edge(5)).chain([1.0; 5]).chain(at_edge(9))
        };
        assert_eq!(detected(between(5)), Some(20.0));
        assert_eq!(detected(between(6)), None);
        // others are counted in a row
        assert_eq!(detected([7.0, 1.0, 1.0, 1.0].repeat(20)), Some(57.0));
    }

    /// One step in 50 is examined, then each one as long as steps are at the edge, and none once stiffness is known.
    #[test]
    fn regress_steps_are_examined_when_due() {
        let mut watch = StiffnessWatch::default();
        let due: Vec<u32> = (1..=120).filter(|_| watch.is_due()).collect();
        assert_eq!(due.len(), 2);
        let mut watch = StiffnessWatch::default();
        for n in 1..50 {
            assert!(!watch.is_due(), "{n}");
        }
        for n in 0..15 {
            assert!(watch.is_due(), "{n}");
            watch.note(7.0, 1.0);
        }
        assert!((0..60).all(|_| !watch.is_due()));
        let mut watch = StiffnessWatch::default();
        watch.note(7.0, 1.0);
        assert!(watch.is_due());
        watch.restart();
        assert!(!watch.is_due());
    }
}
