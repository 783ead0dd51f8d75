//! Sketches and animations: what the program writes, and how it refuses.

use crate::{assert_current, assert_wrong_use, directory, ezy, output, text};
use ezy_core::prelude::*;
use ezy_models::ezy_roller::Driven;
use ezy_models::registry::MODELS;
use ezy_study::report::drawing::sketch_within;
use serde_json::Value;
use std::path::Path;

/// A README loads at once, also on a telephone.
const LARGEST_PICTURE: usize = 300_000;
/// Largest sketch of a page of the documentation, pixels.
const DOCUMENTED: [f64; 2] = [450.0, 500.0];
/// Seconds that a visitor looks.
const GLANCE_S: f64 = 5.0;

/// The numbers of a page.
fn data(page: &str) -> Value {
    let from = page.split_once("<script type=\"application/json\" id=\"data\">").unwrap().1;
    serde_json::from_str(from.split_once("</script>").unwrap().0).unwrap()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

#[test]
fn cross_page_of_an_animation_holds_the_samples_of_the_run() {
    let file = directory("animation").join("driven.html");
    let path = file.to_str().unwrap();
    let done =
        output(&["animate", "ezyroller/driven", "--until", "2", "--every", "0.1", "--set", "m0=3", "--out", path]);
    assert!(done.contains("reached the end") && done.contains(path), "{done}");
    let page = std::fs::read_to_string(&file).unwrap();
    for elsewhere in ["http:", "https:", "src=", "<link", "@import", "{{"] {
        let svg = page.replace("http://www.w3.org/2000/svg", "");
        assert!(!svg.contains(elsewhere), "{elsewhere}");
    }
    let data = data(&page);
    let scene = Driven { m0: 3.0, ..Driven::default() };
    let run = Simulation::new(&scene).until(2.0).every(0.1).work().run().unwrap();
    assert_eq!(data["t"].as_array().unwrap().len(), run.samples().len());
    // positions are rounded to a hundredth of a pixel, energies to five digits
    let pixel = 1.0 / number(&data["scale"]);
    for (k, sample) in run.samples().enumerate() {
        assert_eq!(number(&data["t"][k]), sample.t);
        for (i, &q) in sample.coordinates.iter().enumerate() {
            let error = (number(&data["poses"][i / 3][i % 3][k]) - q).abs();
            let bound = if i % 3 == 2 { 0.5e-4 } else { 0.005 * pixel };
            assert!(error <= bound * (1.0 + 1e-9), "coordinate {i} of frame {k}: {error:e}");
        }
        let energy = number(&data["plots"][0]["curves"][0]["values"][k]);
        assert!((energy - sample.energy.kinetic).abs() <= 1e-4 * run.last().energy.kinetic, "{energy}");
    }
    // the reaction of the rear skate is across the seat, as large as its multiplier
    let arrows = data["arrows"].as_array().unwrap();
    let rear = arrows.iter().find(|arrow| arrow["name"] == "rear").unwrap();
    for (k, sample) in run.samples().enumerate() {
        let (sin, cos) = sample.coordinates[2].sin_cos();
        let lambda = sample.get("lambda.rear").unwrap();
        let [x, y] = [0, 1].map(|i| number(&rear["values"][k][i]));
        assert!((x - lambda * sin).abs() < 1e-3 && (y + lambda * cos).abs() < 1e-3, "{x} {y} {lambda}");
    }
    let torque = arrows.iter().find(|arrow| arrow["name"] == "torque").unwrap();
    // on the seat, the first body of `torque seat ~ bar`
    assert!((number(&torque["values"][0][0]) - 3.0).abs() < 1e-3, "{torque}");
}

#[test]
fn invariant_every_model_has_an_animation_with_a_transform_for_each_part() {
    let folder = directory("all");
    for model in MODELS {
        let (scene, until_s) = (model.scenes[0].name, (model.scenes[0].info)().until_s / 200.0);
        let (path, until) = (format!("{}/{scene}", model.name), until_s.to_string());
        let file = folder.join(format!("{}.html", model.name));
        let arguments = ["--until", &until, "--method", "dop853", "--rtol", "1e-4", "--out", file.to_str().unwrap()];
        output(&[&["animate", &path], &arguments[..]].concat());
        let page = std::fs::read_to_string(&file).unwrap();
        let data = data(&page);
        assert_eq!(data["parts"].as_array().unwrap().len(), page.matches("<g class=\"part ").count(), "{path}");
        let n_frames = data["t"].as_array().unwrap().len();
        let poses = data["poses"].as_array().unwrap();
        assert!(
            poses.iter().flat_map(|pose| pose.as_array().unwrap()).all(|x| x.as_array().unwrap().len() == n_frames)
        );
        assert!(page.len() < 2_000_000 && !page.contains("NaN"), "{path}: {}", page.len());
    }
}

#[test]
fn invariant_run_that_stops_early_gives_a_page_with_the_reason() {
    let file = directory("stopped").join("stopped.html");
    let steps = ["--step", "1e-3", "--max-steps", "100"];
    let done = ezy(&[&["animate", "ezyroller/driven", "--out", file.to_str().unwrap()], &steps[..]].concat());
    assert_eq!(done.status.code(), Some(1));
    assert!(text(&done.stderr).contains("the run stopped at t = 0.1 s"), "{}", text(&done.stderr));
    let page = std::fs::read_to_string(&file).unwrap();
    assert!(page.contains("role=\"alert\"") && page.contains("The run stopped at t = 0.1 s"));
}

#[test]
fn invariant_moving_picture_and_frames_are_svg() {
    let folder = directory("frames");
    let (file, frames) = (folder.join("moving.svg"), folder.join("frames"));
    let arguments = ["animate", "fourbar/turning", "--until", "1", "--every", "0.25", "--out", file.to_str().unwrap()];
    output(&[&arguments[..], &["--frames", frames.to_str().unwrap()]].concat());
    let moving = std::fs::read_to_string(&file).unwrap();
    assert!(
        moving.starts_with("<svg") && moving.contains("@keyframes p0") && moving.contains("prefers-reduced-motion")
    );
    assert_eq!(std::fs::read_dir(&frames).unwrap().count(), 5);
    let first = std::fs::read_to_string(frames.join("frame-0000.svg")).unwrap();
    assert!(first.starts_with("<svg") && !first.contains("@keyframes"));
}

#[test]
fn invariant_frames_are_pixels_where_that_is_asked_for() {
    let folder = directory("pixels");
    let (file, frames) = (folder.join("moving.gif"), folder.join("frames"));
    let arguments = ["animate", "fourbar/turning", "--until", "1", "--every", "0.5", "--out", file.to_str().unwrap()];
    let done = output(
        &[&arguments[..], &["--frames", frames.to_str().unwrap(), "--format", "png", "--width", "123"]].concat(),
    );
    assert!(done.contains("frame-0000.png"), "{done}");
    let moving = std::fs::read(&file).unwrap();
    assert_eq!((&moving[..6], &moving[6..8]), (&b"GIF89a"[..], &[123, 0][..]));
    let names = std::fs::read_dir(&frames).unwrap().map(|entry| entry.unwrap().path());
    let all: Vec<Vec<u8>> = names.map(|path| std::fs::read(path).unwrap()).collect();
    assert_eq!(all.len(), 3);
    assert!(all.iter().all(|png| png.starts_with(b"\x89PNG") && png[16..20] == [0, 0, 0, 123]));
    // time goes on
    assert!(all[0] != all[1] && all[1] != all[2]);
}

#[test]
fn invariant_sketch_has_the_lengths_of_the_model_and_its_own_time() {
    let file = directory("sketch").join("later.svg");
    output(&["sketch", "EzyRoller/coast", "--at", "0.5", "--set", "a=0.3", "--out", file.to_str().unwrap()]);
    let svg = std::fs::read_to_string(&file).unwrap();
    assert!(svg.contains("at t = 0.5 s") && svg.contains("skate rear") && svg.contains("hinge B"), "{svg}");
    for length in ["a", "b", "c", "d"] {
        assert!(svg.contains(&format!(">{length}</text>")), "{length}");
    }
}

#[test]
fn invariant_wrong_arguments_of_pictures_exit_with_2() {
    assert_wrong_use(&["sketch", "ezyroller"], "names no scene");
    assert_wrong_use(&["sketch", "ezyroller/driven", "--start", "seat.w=1"], "seat.w");
    assert_wrong_use(&["sketch", "ezyroller/driven", "--at", "-1"], "-1");
    assert_wrong_use(&["animate", "ezyroller/drivne"], "driven");
    assert_wrong_use(&["animate", "ezyroller/driven", "--every", "0"], "positive interval");
    assert_wrong_use(&["animate", "ezyroller/driven", "--step", "1e-3", "--rtol", "1e-6"], "rk4 has a fixed step");
    assert_wrong_use(&["animate", "ezyroller/driven", "--out", "a.apng"], ".html, .svg or .gif");
    assert_wrong_use(&["animate", "ezyroller/driven", "--width", "300"], "--out FILE.gif");
    assert_wrong_use(&["animate", "ezyroller/driven", "--format", "png"], "--frames");
    assert_wrong_use(&["animate", "ezyroller/driven", "--out", "a.gif", "--width", "5"], "50..=4000");
    let folder = directory("taken");
    assert_wrong_use(&["sketch", "ezyroller/driven", "--out", folder.to_str().unwrap()], "--out");
}

#[test]
fn regress_documentation_of_each_model_has_its_sketch() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    for model in MODELS {
        let name = model.name.to_lowercase();
        let scene = (model.scenes[0].new)();
        let run = Simulation::new(scene.as_ref()).until(0.0).run().unwrap();
        let svg = sketch_within(scene.as_ref(), &run.last(), DOCUMENTED);
        // lines without a blank one are HTML for rustdoc; names have a rim in the colour of its theme
        assert!(!svg.contains("\n\n"), "{name}");
        let html =
            format!("<div style=\"overflow-x: auto; --paper: var(--main-background-color, Canvas)\">\n{svg}</div>\n");
        assert_current(&folder.join("sketches").join(format!("{name}.html")), &html);
    }
}

#[test]
fn regress_readme_opens_with_the_roller_as_its_command_draws_it() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let read = |name: &str| std::fs::read_to_string(root.join(name)).unwrap();
    let kept = "docs/ezyroller.svg";
    let readme = read("README.md");
    let mut paragraphs = readme.split("\n\n");
    assert_eq!(paragraphs.next(), Some("# EZY"));
    let picture = paragraphs.next().unwrap_or_default();
    assert!(picture.starts_with("![") && picture.ends_with(&format!("]({kept})")), "{picture}");
    let pages = read("docs/pages/README.md");
    let command = pages.lines().find(|line| line.ends_with(kept)).expect("the command that writes the picture");
    let file = directory("readme").join("roller.svg");
    let mut words: Vec<&str> = command.split(' ').skip(1).collect();
    *words.last_mut().unwrap() = file.to_str().unwrap();
    output(&words);
    let made = std::fs::read_to_string(&file).unwrap();
    assert!(made.len() <= LARGEST_PICTURE, "{} bytes", made.len());
    assert_current(&root.join(kept), &made);
    // at first sight: it drives as far as it is long, and its bar swings
    let scene = Driven { m0: 5.0, ..Driven::default() };
    let run = Simulation::new(&scene).until(GLANCE_S).every(0.05).run().unwrap();
    let at = |name: &str| run.last().get(name).unwrap() - run.first().get(name).unwrap();
    assert!(at("seat.x").hypot(at("seat.y")) > scene.a + scene.b);
    let opening = run.samples().map(|s| s.get("bar.phi").unwrap() - s.get("seat.phi").unwrap() - std::f64::consts::PI);
    let (low, high) = opening.fold((0.0_f64, 0.0_f64), |(low, high), x| (low.min(x), high.max(x)));
    assert!(high - low > 0.5, "{low} {high}");
}
