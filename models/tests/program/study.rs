//! The study, done once: what it prints and what it writes.

use crate::{assert_wrong_use, directory, ezy, text};
use ezy_models::ezy_roller::{Coast, Driven};
use ezy_models::study::averaged::Averaged;
use ezy_models::study::parts::{geometric, log_slope};
use ezy_models::study::straight::{Bar, eigenvalues};

/// Figures, each as SVG, PNG and CSV.
const FIGURES: [&str; 11] = [
    "coast_motion",
    "straight_eigenvalues",
    "driven_paths",
    "driven_paths_beginning",
    "driven_speed",
    "driven_energy",
    "driven_hinge",
    "driven_work",
    "work_gap",
    "long_run",
    "order",
];

/// The last row of a CSV file.
fn last_row(text: &str) -> Vec<f64> {
    text.lines().last().unwrap().split(',').map(|cell| cell.parse().unwrap_or(f64::NAN)).collect()
}

#[test]
fn reference_study_writes_what_the_equations_say() {
    let directory = directory("study");
    let done = ezy(&["study", "--out", directory.to_str().unwrap()]);
    let (stdout, stderr) = (text(&done.stdout), text(&done.stderr));
    assert_eq!(done.status.code(), Some(0), "{stderr}");
    // speed and kinetic energy after ten minutes, from a solution with 36 digits
    assert!(stdout.contains("2.0786 m/s, 101.555 J") && stdout.contains("index.html"), "{stdout}");

    let read = |name: &str| std::fs::read(directory.join(name)).unwrap_or_else(|error| panic!("{name}: {error}"));
    let read_text = |name: &str| String::from_utf8(read(name)).unwrap();
    for figure in FIGURES {
        assert!(read_text(&format!("{figure}.svg")).contains("<svg"), "{figure}");
        assert!(read(&format!("{figure}.png")).starts_with(b"\x89PNG"), "{figure}");
        assert!(read_text(&format!("{figure}.csv")).lines().count() > 4, "{figure}");
    }
    check_page(&read_text("index.html"));

    // t, A.x, A.y, C.x, C.y at 60 s; RK4 at h = 1e-3 leaves 6e-11
    let end = last_row(&read_text("driven_paths.csv"));
    let expected = [60.0, 12.419_757_809_423_2, -21.903_636_915_969_9, 12.701_748_468_322_6, -22.433_578_240_236_2];
    for (value, expected) in end.iter().zip(expected) {
        assert!((value - expected).abs() < 2e-10, "{value} {expected}");
    }
    // t, kinetic energy
    let end = last_row(&read_text("driven_energy.csv"));
    assert!((end[1] - 12.965_177_349_343_9).abs() < 1e-9, "{end:?}");
}

/// The page stands alone and says what is seen in each figure.
fn check_page(page: &str) {
    assert!(page.starts_with("<!DOCTYPE html>\n<html lang=\"en\">"));
    for elsewhere in ["http:", "https:", "<script", "<img", "<link", "url(h"] {
        assert!(!page.contains(elsewhere), "{elsewhere}");
    }
    // each for wide and for narrow screens; the sketch of the vehicle comes first
    assert_eq!(page.matches("<div class=\"wide\"><svg role=\"img\" aria-label=").count(), 1 + FIGURES.len());
    assert_eq!(page.matches("<div class=\"narrow\"><svg role=\"img\" aria-label=").count(), 1 + FIGURES.len());
    assert_eq!(page.matches("role=\"img\" aria-label=").count(), 2 + 2 * FIGURES.len());
    let mut sketches = page.split("<svg").skip(1).filter_map(|svg| svg.split("</svg>").next());
    let (sketch, narrow) = (sketches.next().unwrap(), sketches.next().unwrap());
    // a screen of 390 pixels and the margins of the page
    let width: f64 =
        narrow.split(" width=\"").nth(1).and_then(|width| width.split('"').next()).unwrap().parse().unwrap();
    assert!(width <= 390.0 - 2.0 * 16.0, "letters shrink with a sketch that is {width} wide");
    // an element has one class; a second one, of a style sheet, would be ignored
    for svg in [sketch, narrow] {
        let element = svg.split('>').next().unwrap();
        assert_eq!(element.matches("class=").count(), 1, "{element}");
    }
    for length in ["a", "b", "c", "d"] {
        assert!(sketch.contains(&format!("text-anchor=\"middle\">{length}</text>")), "{length} in {sketch}");
    }
    assert!(page.matches("<math display=\"block\">").count() >= 11);
    for part in
        ["(a) Hinge", "(b) Wheels", "(c) Equations", "(d) Proj", "(e) Coast", "(f) Driven", "(g)", "(h)", "(i)", "(j)"]
    {
        assert!(page.contains(part), "{part}");
    }
    // the right-endpoint sum with the step of the report, run with that step
    assert!(page.contains("at the report's step of 10⁻⁴ s it is 2.733·10⁻³ J"), "the gap of the summed work");
    // numbers are as people write them; paths of figures and equations as text are not read as sentences
    let text = page.split("<p>").skip(1).filter_map(|rest| rest.split("</p>").next());
    let cells = page.split("<td").skip(1).filter_map(|rest| rest.split("</td>").next());
    for text in text.chain(cells) {
        let is_typed = |word: &str| {
            let number = word.trim_end_matches([')', ',', ';', '.', ':']);
            number.parse::<f64>().is_ok() && number.contains(['e', '-'])
        };
        assert!(!text.split([' ', '>', '(']).any(is_typed), "{text}");
    }
    assert!(!page.contains("NaN") && !page.contains("inf "), "a number is missing");
}

#[test]
fn invariant_study_into_a_file_exits_with_2() {
    let file = directory("no_study").join("not_a_directory");
    std::fs::write(&file, "").unwrap();
    assert_wrong_use(&["study", "--out", file.to_str().unwrap()], "choose another directory");
}

#[test]
fn analytic_slope_of_a_power_law_is_its_exponent() {
    let x = geometric(0.1, 2.0, 5);
    let y: Vec<f64> = x.iter().map(|x| 3.0 * x.powi(4)).collect();
    assert!((log_slope(&x, &y) - 4.0).abs() < 1e-12);
}

#[test]
fn analytic_mean_power_tends_to_the_limit_law() {
    let law = Averaged::of(&Driven::default()).unwrap();
    let v: f64 = 1e6;
    let limit = 5.0 * law.mean_power(v) * v.powi(3) / law.mass;
    // the law misses terms of order 1/v²
    assert!((limit / law.limit() - 1.0).abs() < 1e-9, "{limit} {}", law.limit());
}

/// Against another derivation, with 32 digits, and the growth of a small angle in the run of the study.
#[test]
fn reference_eigenvalues_of_straight_running() {
    let roller = Coast::default();
    let cases = [
        (Bar::Ahead, 1.0, [5.035_749_090_511_275, -0.789_060_348_789_421]),
        (Bar::Folded, 1.0, [-0.790_041_551_870_144, -5.029_494_871_970_915]),
    ];
    for (bar, speed, expected) in cases {
        let found = eigenvalues(&roller, bar, speed);
        let backwards = eigenvalues(&roller, bar, -speed);
        for (i, (found, expected)) in found.iter().zip(expected).enumerate() {
            assert!((found - expected).abs() <= 1e-12 * 5.1, "{found} {expected}");
            assert_eq!(backwards[1 - i], -found);
        }
    }
}

/// The closed form against the eigenvalues of the linear equations of the model.
#[cfg(feature = "analysis")]
#[test]
fn analytic_eigenvalues_of_the_study_are_those_of_the_model() {
    for (bar, angle) in [(Bar::Ahead, "bar.phi=0"), (Bar::Folded, "bar.phi=pi")] {
        for speed in [-2.0, 0.5, 3.0] {
            let start = format!("seat.vx={speed}");
            let found = crate::json(&["linearize", "ezyroller/coast", "--start", angle, "--start", &start, "--json"]);
            let mut found: Vec<f64> =
                found["eigenvalues"].as_array().unwrap().iter().map(|s| s["real"].as_f64().unwrap()).collect();
            found.sort_by(|a, b| b.total_cmp(a));
            let expected = eigenvalues(&Coast::default(), bar, speed);
            assert_eq!(found.len(), 2);
            for (found, expected) in found.iter().zip(expected) {
                assert!((found - expected).abs() <= 1e-10 * 16.0, "{found} {expected} at {start}");
            }
        }
    }
}
