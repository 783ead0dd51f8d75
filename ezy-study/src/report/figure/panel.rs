//! One pair of axes with its curves.

use super::canvas::{Anchor, BLACK, Canvas, Color, Frame, Place, Segment, WHITE};
use super::room::Room;
use super::ticks::Ticks;
use super::{Axes, Panel, lettering, marker, range, thin};

/// Sizes of letters.
pub(super) const TICK_SIZE: f64 = 12.5;
const NOTE_SIZE: f64 = 12.0;
/// Length of ticks, and the gap between a tick and its label.
pub(super) const TICK: f64 = 4.5;
const MINOR_TICK: f64 = 2.5;
pub(super) const TICK_GAP: f64 = 4.0;

const GRID: Color = [0xe2; 3];

/// Where a panel stands and what its axes show.
pub(super) struct Scales {
    pub axes: Axes,
    pub frame: Frame,
    pub x: [f64; 2],
    pub y: [f64; 2],
}

impl Scales {
    /// The place of a point in the picture.
    pub(super) fn place(&self, [x, y]: [f64; 2]) -> Place {
        let part = |[low, high]: [f64; 2], value: f64, is_log: bool| match is_log {
            true => (value / low).log10() / (high / low).log10(),
            // halves, so that a span of the largest numbers is one
            false => (0.5 * value - 0.5 * low) / (0.5 * high - 0.5 * low),
        };
        let [log_x, log_y] = self.axes.are_logarithmic();
        let Frame { left, bottom, .. } = self.frame;
        [left + part(self.x, x, log_x) * self.frame.width(), bottom - part(self.y, y, log_y) * self.frame.height()]
    }

    fn x_place(&self, x: f64) -> f64 {
        self.place([x, self.y[0]])[0]
    }

    fn y_place(&self, y: f64) -> f64 {
        self.place([self.x[0], y])[1]
    }
}

/// Grid, frame and ticks; labels of the abscissa below the lowest panel alone.
pub(super) fn draw_axes(canvas: &mut Canvas, scales: &Scales, x_ticks: &Ticks, y_ticks: &Ticks, is_lowest: bool) {
    let frame = scales.frame;
    for (x, _) in &x_ticks.major {
        let x = scales.x_place(*x);
        canvas.line([x, frame.top], [x, frame.bottom], GRID, 1.0);
    }
    for (y, _) in &y_ticks.major {
        let y = scales.y_place(*y);
        canvas.line([frame.left, y], [frame.right, y], GRID, 1.0);
    }
    let below = |canvas: &mut Canvas, x: f64, length: f64| {
        let x = scales.x_place(x);
        canvas.line([x, frame.bottom], [x, frame.bottom + length], BLACK, 1.0);
        x
    };
    for x in &x_ticks.minor {
        below(canvas, *x, MINOR_TICK);
    }
    let baseline = frame.bottom + TICK + TICK_GAP + lettering::RISE * TICK_SIZE;
    for (x, label) in &x_ticks.major {
        let x = below(canvas, *x, TICK);
        if is_lowest {
            canvas.text(label, [x, baseline], Anchor::Middle, TICK_SIZE);
        }
    }
    for y in &y_ticks.minor {
        let y = scales.y_place(*y);
        canvas.line([frame.left - MINOR_TICK, y], [frame.left, y], BLACK, 1.0);
    }
    for (y, label) in &y_ticks.major {
        let y = scales.y_place(*y);
        canvas.line([frame.left - TICK, y], [frame.left, y], BLACK, 1.0);
        canvas.text(label, [frame.left - TICK - TICK_GAP, y + 0.36 * TICK_SIZE], Anchor::End, TICK_SIZE);
    }
    canvas.frame(&frame, BLACK, 1.0);
    if let Some(scale) = &y_ticks.scale {
        canvas.text(scale, [frame.left, frame.top - 5.0], Anchor::Start, TICK_SIZE);
    }
}

/// The curves, and the room that they leave.
pub(super) fn draw_curves(canvas: &mut Canvas, scales: &Scales, panel: &Panel) -> Room {
    let mut room = Room::new(scales.frame);
    for curve in &panel.curves {
        let look = &curve.look;
        // on the colours of a map any colour of a curve is lost
        let halo = panel.map.is_some().then(|| look.halo());
        let places: Vec<Option<Place>> =
            range::points(scales.axes, curve).map(|point| point.map(|point| scales.place(point))).collect();
        let pieces: Vec<&[Option<Place>]> = places.split(Option::is_none).collect();
        for piece in pieces {
            let places: Vec<Place> = piece.iter().flatten().copied().collect();
            if look.width > 0.0 {
                let places = thin::thinned(&places);
                let mut outline: Vec<Segment> = places.iter().map(|place| Segment::Line(*place)).collect();
                if let Some(first) = outline.first_mut() {
                    *first = Segment::Move(places[0]);
                    if let Some(halo) = &halo {
                        canvas.stroke(outline.clone(), halo.color, halo.width, &[]);
                    }
                    canvas.stroke(outline, look.color, look.width, look.dash);
                }
                places.windows(2).for_each(|pair| room.take_line(pair[0], pair[1]));
            }
            // of a single point no line is seen
            let dot = (places.len() == 1 && look.marker.is_none()).then(|| look.clone().with_marker(0));
            let look = dot.as_ref().unwrap_or(look);
            if look.marker.is_some() {
                for place in places {
                    if let Some(halo) = &halo {
                        marker::draw(canvas, halo, place);
                    }
                    marker::draw(canvas, look, place);
                    let [x, y] = place;
                    room.take(&Frame { left: x, top: y, right: x, bottom: y }.widened(0.5 * look.size));
                }
            }
        }
    }
    room
}

/// Directions and distances from its place in which a note is tried.
const DIRECTIONS: [[f64; 2]; 9] =
    [[0.0, 0.0], [0.0, -1.0], [0.0, 1.0], [1.0, 0.0], [-1.0, 0.0], [1.0, -1.0], [-1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
const DISTANCES: [f64; 4] = [4.0, 12.0, 22.0, 36.0];

/// Each note at its place, or beside it where something is drawn there.
pub(super) fn draw_notes(canvas: &mut Canvas, scales: &Scales, panel: &Panel, room: &mut Room) {
    for note in &panel.notes {
        if !range::is_drawable(scales.axes, [note.x, note.y]) {
            continue;
        }
        let [x, y] = scales.place([note.x, note.y]);
        let (half_width, half_height) = (0.5 * lettering::width(&note.text, NOTE_SIZE), 0.5 * NOTE_SIZE);
        let around = |[dx, dy]: [f64; 2], distance: f64| {
            let (x, y) = (x + dx * (distance + half_width), y + dy * (distance + half_height));
            Frame { left: x - half_width, top: y - half_height, right: x + half_width, bottom: y + half_height }
        };
        let tried = DISTANCES.iter().flat_map(|distance| DIRECTIONS.map(|direction| around(direction, *distance)));
        let tried = tried.filter_map(|frame| Some((room.taken(&frame.widened(2.0))?, frame)));
        let Some((taken, frame)) = tried.min_by(|a, b| a.0.total_cmp(&b.0)) else { continue };
        if taken > 0.0 || panel.map.is_some() {
            canvas.fill(&frame.widened(1.0), WHITE);
        }
        let middle = 0.5 * (frame.left + frame.right);
        canvas.text(&note.text, [middle, frame.bottom - 0.14 * NOTE_SIZE], Anchor::Middle, NOTE_SIZE);
        room.take(&frame);
    }
}
