//! The legend of a panel: within the axes where there is room, else above them.

use super::canvas::{Anchor, Canvas, Frame, Segment, WHITE};
use super::look::Look;
use super::room::Room;
use super::{Panel, lettering, marker};

/// Size of its letters.
pub(super) const SIZE: f64 = 12.5;
/// Length of the line before a name, and the gap after it.
const SAMPLE: f64 = 36.0;
const GAP: f64 = 7.0;
/// Height of a row, and the space between entries of one row.
const ROW: f64 = 19.0;
const SPACE: f64 = 22.0;
/// From the frame of the legend to what is in it, and from the axes to the legend.
const PADDING: f64 = 6.0;
const MARGIN: f64 = 8.0;
/// Places that are tried in each direction.
const N_PLACES: u8 = 8;

/// Named curves in the order in which they are drawn.
pub(super) struct Legend<'f> {
    entries: Vec<(&'f str, &'f Look)>,
}

impl<'f> Legend<'f> {
    /// The legend of a panel; a single curve has none, the axis names it if there is no map.
    pub(super) fn new(panel: &'f Panel) -> Option<Self> {
        let named = panel.curves.iter().filter(|curve| !curve.name.is_empty());
        let mut entries: Vec<(&str, &Look)> = Vec::new();
        for curve in named {
            if !entries.iter().any(|(name, _)| *name == curve.name) {
                entries.push((&curve.name, &curve.look));
            }
        }
        ((panel.curves.len() > 1 || panel.map.is_some()) && !entries.is_empty()).then_some(Self { entries })
    }

    /// Names in their order.
    pub(super) fn names(&self) -> Vec<&'f str> {
        self.entries.iter().map(|(name, _)| *name).collect()
    }

    /// Widths of the entries.
    fn widths(&self) -> impl Iterator<Item = f64> + '_ {
        self.entries.iter().map(|(name, _)| SAMPLE + GAP + lettering::width(name, SIZE))
    }

    /// The frame within the axes that covers nothing; `None` where there is no such room. Corners come first.
    pub(super) fn inside(&self, axes: &Frame, room: &Room) -> Option<Frame> {
        let width = self.widths().fold(0.0, f64::max) + 2.0 * PADDING;
        let height = self.entries.len() as f64 * ROW + 2.0 * PADDING;
        let [across, down] = [axes.width() - width, axes.height() - height].map(|free| free - 2.0 * MARGIN);
        if across < 0.0 || down < 0.0 {
            return None;
        }
        let part = |k: u8| f64::from(k) / f64::from(N_PLACES);
        let places = (0..=N_PLACES).flat_map(|j| (0..=N_PLACES).map(move |i| [N_PLACES - i, j]));
        let mut places: Vec<[u8; 2]> = places.collect();
        let from_corner = |[i, j]: &[u8; 2]| i.min(&(N_PLACES - i)) + j.min(&(N_PLACES - j));
        places.sort_by_key(from_corner);
        let frame = |[i, j]: [u8; 2]| {
            let (left, top) = (axes.left + MARGIN + part(i) * across, axes.top + MARGIN + part(j) * down);
            Frame { left, top, right: left + width, bottom: top + height }
        };
        places.into_iter().map(frame).find(|frame| room.taken(&frame.widened(PADDING)) == Some(0.0))
    }

    /// Draws the entries below each other.
    pub(super) fn draw_inside(&self, canvas: &mut Canvas, frame: &Frame) {
        canvas.fill(frame, WHITE);
        for (k, entry) in self.entries.iter().enumerate() {
            draw_entry(canvas, *entry, frame.left + PADDING, frame.top + PADDING + (k as f64 + 0.5) * ROW);
        }
    }

    /// Entries of each row, as many as fit into `width`.
    fn rows(&self, width: f64) -> Vec<Vec<(usize, f64)>> {
        let mut rows: Vec<Vec<(usize, f64)>> = vec![Vec::new()];
        let mut left = 0.0;
        for (i, of_entry) in self.widths().enumerate() {
            if left > 0.0 && left + of_entry > width {
                rows.push(Vec::new());
                left = 0.0;
            }
            rows.last_mut().expect("there is a first row").push((i, left));
            left += of_entry + SPACE;
        }
        rows
    }

    /// Height of the legend above axes of this width.
    pub(super) fn height_above(&self, width: f64) -> f64 {
        self.rows(width).len() as f64 * ROW + PADDING
    }

    /// Draws the entries beside each other, the last row above the axes.
    pub(super) fn draw_above(&self, canvas: &mut Canvas, axes: &Frame, width: f64) {
        let top = axes.top - self.height_above(width);
        for (k, row) in self.rows(width).into_iter().enumerate() {
            for (i, left) in row {
                draw_entry(canvas, self.entries[i], axes.left + left, top + (k as f64 + 0.5) * ROW);
            }
        }
    }
}

fn draw_entry(canvas: &mut Canvas, (name, look): (&str, &Look), left: f64, middle: f64) {
    if look.width > 0.0 {
        let line = vec![Segment::Move([left, middle]), Segment::Line([left + SAMPLE, middle])];
        canvas.stroke(line, look.color, look.width, look.dash);
    }
    marker::draw(canvas, look, [left + 0.5 * SAMPLE, middle]);
    canvas.text(name, [left + SAMPLE + GAP, middle + 0.36 * SIZE], Anchor::Start, SIZE);
}
