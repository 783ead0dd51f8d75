//! A motion as an animated GIF, which every program for slides plays.

use std::collections::HashMap;

use gif::{DisposalMethod, Encoder, Frame, Repeat};
use tiny_skia::PremultipliedColorU8;

use super::film::Film;
use super::pixels::{BODY_OPACITY, HUES, INK, PAPER, RUBBER, Rgb};

/// Steps from a ground to ink, which the edges of lines take.
const N_STEPS: usize = 24;

/// Index of the colour of a pixel that stays as it was; no other colour has it.
const STAYS: u8 = u8::MAX;

/// Shortest time of a frame, hundredths of a second: of less, browsers make 10.
const SHORTEST: u16 = 2;

impl Film<'_> {
    /// All frames as the bytes of a GIF file so many pixels wide that moves for so many seconds, over and over; `None` where that
    /// is too large.
    pub fn gif(&self, seconds: f64, width: u32) -> Option<Vec<u8>> {
        let colors = palette();
        let height = self.pixels(0, width)?.height();
        let (columns, rows) = (u16::try_from(width).ok()?, u16::try_from(height).ok()?);
        let mut bytes = Vec::new();
        let mut encoder = Encoder::new(&mut bytes, columns, rows, &colors.concat()).ok()?;
        encoder.set_repeat(Repeat::Infinite).ok()?;
        let mut indices = Indices { colors, known: HashMap::new() };
        let mut last: Vec<u8> = Vec::new();
        // hundredths of a second up to a frame: what one is rounded by is not lost
        let until = |frame: usize| (100.0 * seconds * frame as f64 / self.frames.len() as f64).round() as u16;
        for frame in 0..self.frames.len() {
            let pixels = self.pixels(frame, width)?;
            let now = indices.of_all(pixels.pixels());
            let mut frame_of_file = difference(&last, &now, columns, rows);
            frame_of_file.delay = (until(frame + 1) - until(frame)).max(SHORTEST);
            encoder.write_frame(&frame_of_file).ok()?;
            last = now;
        }
        drop(encoder);
        Some(bytes)
    }
}

/// The rectangle that has changed; all of the first frame.
fn difference(last: &[u8], now: &[u8], columns: u16, rows: u16) -> Frame<'static> {
    let n = usize::from(columns);
    let changed = |i: usize| last.get(i) != Some(&now[i]);
    // most rows are as they were, and are compared as a whole
    let places = (0..now.len()).step_by(n).map(|first| first..first + n);
    let places = places.filter(|row| last.get(row.clone()) != now.get(row.clone()));
    let places = places.flatten().filter(|&i| changed(i)).map(|i| (i % n, i / n));
    let (mut left, mut right, mut top, mut bottom) = (n - 1, 0, usize::from(rows) - 1, 0);
    for (x, y) in places {
        (left, right, top, bottom) = (left.min(x), right.max(x), top.min(y), bottom.max(y));
    }
    if left > right || top > bottom {
        // nothing has: one pixel that stays
        (left, right, top, bottom) = (0, 0, 0, 0);
    }
    let within = (top..=bottom).flat_map(|y| (left..=right).map(move |x| y * n + x));
    let buffer: Vec<u8> = within.map(|i| if changed(i) { now[i] } else { STAYS }).collect();
    let [left, top, width, height] = [left, top, right - left + 1, bottom - top + 1].map(|x| x as u16);
    Frame {
        dispose: DisposalMethod::Keep,
        transparent: Some(STAYS),
        left,
        top,
        width,
        height,
        buffer: buffer.into(),
        ..Frame::default()
    }
}

/// Ink in steps over paper, over rubber, and over one body or two: the colours of all pictures.
fn palette() -> Vec<Rgb> {
    let over = |ground: Rgb, color: Rgb, opacity: f64| -> Rgb {
        [0, 1, 2].map(|k| (f64::from(ground[k]) * (1.0 - opacity) + f64::from(color[k]) * opacity).round() as u8)
    };
    let bodies = HUES.map(|hue| over(PAPER, hue, BODY_OPACITY));
    let pairs = bodies.iter().flat_map(|&body| HUES.map(|hue| over(body, hue, BODY_OPACITY)));
    let grounds = [PAPER, RUBBER].into_iter().chain(bodies);
    let inked = grounds.flat_map(|ground| (0..N_STEPS).map(move |i| over(ground, INK, i as f64 / N_STEPS as f64)));
    inked.chain(pairs).chain([INK]).collect()
}

/// Indices of the nearest colours.
struct Indices {
    colors: Vec<Rgb>,
    known: HashMap<Rgb, u8>,
}

impl Indices {
    /// Of opaque pixels; those of a run of one colour are looked up once.
    fn of_all(&mut self, pixels: &[PremultipliedColorU8]) -> Vec<u8> {
        let mut indices = Vec::with_capacity(pixels.len());
        for run in pixels.chunk_by(PartialEq::eq) {
            let index = self.of([run[0].red(), run[0].green(), run[0].blue()]);
            indices.resize(indices.len() + run.len(), index);
        }
        indices
    }

    fn of(&mut self, color: Rgb) -> u8 {
        let Self { colors, known } = self;
        *known.entry(color).or_insert_with(|| {
            let distance =
                |other: &Rgb| (0..3).map(|k| (i32::from(color[k]) - i32::from(other[k])).pow(2)).sum::<i32>();
            let nearest = colors.iter().enumerate().min_by_key(|(_, other)| distance(other));
            nearest.map_or(0, |(i, _)| i as u8)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn invariant_palette_leaves_a_place_for_what_stays() {
        assert!(palette().len() <= usize::from(STAYS));
    }

    #[test]
    fn analytic_difference_is_the_smallest_rectangle() {
        let (last, mut now) = (vec![1; 12], vec![1; 12]);
        now[5] = 2;
        now[10] = 3;
        let frame = difference(&last, &now, 4, 3);
        assert_eq!([frame.left, frame.top, frame.width, frame.height], [1, 1, 2, 2]);
        assert_eq!(*frame.buffer, [2, STAYS, STAYS, 3]);
        assert_eq!(*difference(&last, &last, 4, 3).buffer, [STAYS]);
        assert_eq!(difference(&[], &now, 4, 3).buffer.len(), 12);
    }
}
