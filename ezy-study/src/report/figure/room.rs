//! Where a picture has room for a legend or a note.

use super::canvas::{Frame, Place};

/// Side of a cell in points.
const CELL: f64 = 3.0;

/// Which cells of a frame are taken.
#[derive(Debug, Clone)]
pub(super) struct Room {
    frame: Frame,
    n_across: usize,
    taken: Vec<bool>,
}

impl Room {
    /// A free frame.
    pub(super) fn new(frame: Frame) -> Self {
        let cells = |length: f64| (length / CELL).ceil().max(1.0) as usize;
        let (n_across, n_down) = (cells(frame.width()), cells(frame.height()));
        Self { frame, n_across, taken: vec![false; n_across * n_down] }
    }

    fn cell(&self, [x, y]: Place) -> Option<usize> {
        let [i, j] = [(x - self.frame.left) / CELL, (y - self.frame.top) / CELL];
        let is_inside = i >= 0.0 && j >= 0.0 && i < self.n_across as f64;
        let cell = is_inside.then(|| j as usize * self.n_across + i as usize)?;
        (cell < self.taken.len()).then_some(cell)
    }

    /// Takes the cells along a line.
    pub(super) fn take_line(&mut self, from: Place, to: Place) {
        let length = (to[0] - from[0]).hypot(to[1] - from[1]);
        let n = (2.0 * length / CELL).ceil().max(1.0);
        for k in 0..=n as usize {
            let part = k as f64 / n;
            let place = [from[0] + part * (to[0] - from[0]), from[1] + part * (to[1] - from[1])];
            if let Some(cell) = self.cell(place) {
                self.taken[cell] = true;
            }
        }
    }

    /// Takes the cells of a frame.
    pub(super) fn take(&mut self, frame: &Frame) {
        for cell in self.cells(frame) {
            self.taken[cell] = true;
        }
    }

    /// Part of a frame that is taken; `None` where it leaves the room.
    pub(super) fn taken(&self, frame: &Frame) -> Option<f64> {
        if !self.frame.holds(frame) {
            return None;
        }
        let cells = self.cells(frame);
        Some(cells.iter().filter(|cell| self.taken[**cell]).count() as f64 / cells.len().max(1) as f64)
    }

    fn cells(&self, frame: &Frame) -> Vec<usize> {
        let places = |from: f64, to: f64| {
            (0..=((to - from) / CELL).ceil() as usize).map(move |k| (from + k as f64 * CELL).min(to))
        };
        let down = places(frame.top, frame.bottom);
        down.flat_map(|y| places(frame.left, frame.right).filter_map(move |x| self.cell([x, y]))).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_room_below_a_diagonal_is_free_and_on_it_is_not() {
        let frame = Frame { left: 10.0, top: 10.0, right: 110.0, bottom: 110.0 };
        let mut room = Room::new(frame);
        room.take_line([10.0, 10.0], [110.0, 110.0]);
        let square = |left: f64, top: f64| Frame { left, top, right: left + 30.0, bottom: top + 30.0 };
        assert_eq!(room.taken(&square(15.0, 75.0)), Some(0.0));
        assert!(room.taken(&square(45.0, 45.0)).unwrap() > 0.05);
        assert_eq!(room.taken(&square(95.0, 20.0)), None);
    }
}
