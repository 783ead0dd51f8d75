//! A moving picture, read again: its frames, their times, and where the body is in each.

use ezy_core::prelude::*;
use ezy_core_tests::simulation;
use ezy_models::ezy_roller::Driven;
use ezy_models::pendulum::Swing;
use ezy_study::report::drawing::{Drawing, Elements, Film, Placed};

const WIDTH: u32 = 300;
const N_FRAMES: usize = 8;
const SECONDS: f64 = 3.0;

/// Of a colour that the palette rounds, in each of red, green and blue.
const OF_PALETTE: i32 = 2;

/// Where the pendulum hangs nearer to the vertical, m, its outline covers the mirror image of its middle as well.
const NEAR_VERTICAL: f64 = 0.15;

/// Of the colours of edges, which the palette of a GIF has in fewer steps.
const OF_EDGES: i32 = 40;

/// Frames of a file as they are seen, red, green and blue of each pixel, and their times in hundredths of a second.
fn frames(file: &[u8]) -> (usize, Vec<Vec<[u8; 3]>>, Vec<u16>) {
    let mut options = gif::DecodeOptions::new();
    options.set_color_output(gif::ColorOutput::RGBA);
    let mut decoder = options.read_info(file).unwrap();
    let (width, height) = (usize::from(decoder.width()), usize::from(decoder.height()));
    let mut seen = vec![[0; 3]; width * height];
    let (mut frames, mut times) = (Vec::new(), Vec::new());
    while let Some(frame) = decoder.read_next_frame().unwrap() {
        for (i, rgba) in frame.buffer.chunks_exact(4).enumerate().filter(|(_, rgba)| rgba[3] != 0) {
            let (x, y) = (i % usize::from(frame.width), i / usize::from(frame.width));
            seen[(y + usize::from(frame.top)) * width + x + usize::from(frame.left)] = [rgba[0], rgba[1], rgba[2]];
        }
        frames.push(seen.clone());
        times.push(frame.delay);
    }
    (width, frames, times)
}

/// Left, top and width of the picture, from the text of its SVG.
fn view(svg: &str) -> [f64; 3] {
    let text = svg.split_once("viewBox=\"").unwrap().1.split_once('"').unwrap().0;
    let numbers: Vec<f64> = text.split(' ').map(|x| x.parse().unwrap()).collect();
    [numbers[0], numbers[1], numbers[2]]
}

#[test]
fn cross_body_of_a_moving_picture_is_where_the_run_has_it() {
    let scene = Swing::default();
    let run = simulation(&scene).method(Method::rk4(1e-3)).until(1.4).every(0.2).run().unwrap();
    let elements = Elements::new(&scene);
    let placed: Vec<Placed> = run.samples().map(|sample| elements.at_sample(&scene, &sample)).collect();
    let drawing = Drawing::new(&scene, elements, &placed[0], &placed, None);
    let film = Film::new(&drawing, &placed, "pendulum");
    let (width, frames, times) = frames(&film.gif(SECONDS, WIDTH).unwrap());
    assert_eq!((width, frames.len()), (WIDTH as usize, N_FRAMES));
    assert_eq!(times.iter().sum::<u16>(), 300, "{times:?}");
    assert!(times.iter().all(|time| (37..=38).contains(time)), "{times:?}");
    assert!(frames.windows(2).all(|pair| pair[0] != pair[1]));
    let [left, top, view_width] = view(&film.frames().next().unwrap());
    let pixels = f64::from(WIDTH) / view_width;
    // a fifth of the first hue over white
    let body = [0x3b, 0x82, 0xc4].map(|x| 255 - (255 - x) / 5);
    let is_body = |color: [u8; 3]| (0..3).all(|k| (i32::from(color[k]) - body[k]).abs() <= OF_PALETTE);
    for (frame, sample) in frames.iter().zip(run.samples()) {
        // half way from the pin at the origin to the centre of mass, and as far on the other side of the pin
        let [x, y] = [sample.coordinates[0] / 2.0, sample.coordinates[1] / 2.0];
        let at = |x: f64, y: f64| {
            let column = ((x * drawing.scale - left) * pixels) as usize;
            let row = ((-y * drawing.scale - top) * pixels) as usize;
            frame[row * width + column]
        };
        assert!(is_body(at(x, y)), "t = {}: {:?}", sample.t, at(x, y));
        if y > -0.1 {
            continue;
        }
        assert!(!is_body(at(-x, y)) || x.abs() < NEAR_VERTICAL, "t = {}", sample.t);
    }
}

/// The arc of a torque in a sketch points counterclockwise; in a motion it would also where the torque has changed its sign.
#[test]
fn invariant_arc_of_a_torque_is_in_the_sketch_alone() {
    let scene = Driven::default();
    let run = simulation(&scene).method(Method::rk4(1e-3)).until(0.4).every(0.2).run().unwrap();
    let elements = Elements::new(&scene);
    let placed: Vec<Placed> = run.samples().map(|sample| elements.at_sample(&scene, &sample)).collect();
    let drawing = Drawing::new(&scene, elements, &placed[0], &placed, None);
    assert!(drawing.parts.iter().any(|part| part.class == "torque"));
    let film = Film::new(&drawing, &placed, "roller");
    assert!(film.frames().all(|frame| !frame.contains("torque")));
    assert!(!film.moving(SECONDS).contains("torque"));
}

#[test]
fn invariant_frame_as_pixels_is_the_frame_of_the_moving_picture() {
    let scene = Swing::default();
    let run = simulation(&scene).method(Method::rk4(1e-3)).until(0.4).every(0.2).run().unwrap();
    let elements = Elements::new(&scene);
    let placed: Vec<Placed> = run.samples().map(|sample| elements.at_sample(&scene, &sample)).collect();
    let drawing = Drawing::new(&scene, elements, &placed[0], &placed, None);
    let film = Film::new(&drawing, &placed, "pendulum");
    let (width, frames, _) = frames(&film.gif(SECONDS, WIDTH).unwrap());
    let png = tiny_skia::Pixmap::decode_png(&film.png(2, WIDTH).unwrap()).unwrap();
    assert_eq!((png.width() as usize, png.pixels().len()), (width, frames[2].len()));
    for (pixel, seen) in png.pixels().iter().zip(&frames[2]) {
        let is_seen = |x: u8, y: u8| (i32::from(x) - i32::from(y)).abs() <= OF_EDGES;
        let [red, green, blue] = *seen;
        assert!(is_seen(pixel.red(), red) && is_seen(pixel.green(), green) && is_seen(pixel.blue(), blue), "{seen:?}");
    }
    assert!(film.png(3, WIDTH).is_none() && film.width() <= 960);
}
