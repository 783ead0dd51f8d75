//! The values of contours beside their lines, where there is room.

use super::canvas::{Anchor, Canvas, Frame, Place};
use super::color_bar::ColorBar;
use super::contour::{Contour, length};
use super::lettering;
use super::room::Room;

/// Size of the letters, and the ground around them.
const SIZE: f64 = 10.5;
const PADDING: f64 = 2.0;
/// Labels of a contour at most, and the length in points from which a piece has one.
const MOST: usize = 2;
const LEAST_LENGTH: f64 = 90.0;
/// Distance in points in which places are tried, and the part of a piece at each end that stays free.
const STEP: f64 = 8.0;
const END: f64 = 0.15;
/// Part of its ground that a label may take from what is drawn there: its own line crosses it.
const MOST_TAKEN: f64 = 0.35;

/// Labels the longest pieces of each contour; `room` knows what will lie over them, and in the end the labels.
pub(super) fn draw(canvas: &mut Canvas, contours: &[Contour], bar: &ColorBar, room: &mut Room) {
    let mut lines = room.clone();
    let pieces = contours.iter().flat_map(|contour| &contour.pieces);
    pieces.flat_map(|piece| piece.windows(2)).for_each(|pair| lines.take_line(pair[0], pair[1]));
    for contour in contours {
        let size = [lettering::width(&contour.label, SIZE), lettering::RISE * SIZE];
        let mut pieces: Vec<&Vec<Place>> =
            contour.pieces.iter().filter(|piece| length(piece) >= LEAST_LENGTH).collect();
        pieces.sort_by(|a, b| length(b).total_cmp(&length(a)));
        for piece in pieces.into_iter().take(MOST) {
            let frames = tried(piece).into_iter().map(|place| around(place, size).widened(PADDING));
            let free = frames.filter(|frame| room.taken(frame) == Some(0.0));
            let free = free.filter_map(|frame| Some((lines.taken(&frame)?, frame)));
            let Some((taken, frame)) = free.min_by(|a, b| a.0.total_cmp(&b.0)) else { continue };
            if taken <= MOST_TAKEN {
                canvas.fill(&frame, bar.scale.color(contour.value));
                let place = [0.5 * (frame.left + frame.right), frame.bottom - PADDING];
                canvas.text_in(bar.scale.ink(contour.value), &contour.label, place, Anchor::Middle, SIZE);
                room.take(&frame.widened(PADDING));
            }
        }
    }
}

fn around([x, y]: Place, [width, height]: [f64; 2]) -> Frame {
    Frame { left: x - 0.5 * width, right: x + 0.5 * width, top: y - 0.5 * height, bottom: y + 0.5 * height }
}

/// Places along a piece, away from its ends.
fn tried(piece: &[Place]) -> Vec<Place> {
    let total = length(piece);
    let mut next = END * total;
    let mut walked = 0.0;
    let mut places = Vec::new();
    for pair in piece.windows(2) {
        walked += length(pair);
        if walked >= next && walked <= (1.0 - END) * total {
            places.push(pair[1]);
            next = walked + STEP;
        }
    }
    places
}
