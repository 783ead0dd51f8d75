//! What notebooks show: equations, sketches and animations.

use crate::error::wrong;
use ezy_cli::animation_page;
use ezy_core::integrate::Method;
use ezy_core::model::{Equation, Scene, SceneInfo};
use ezy_core::simulate::Run;
use ezy_study::report::drawing::{Drawing, Elements, Film, Placed};
use ezy_study::report::page::escape;
use pyo3::prelude::*;
use std::path::{Path, PathBuf};

/// Frames of a page: more make it tens of megabytes.
const MOST_FRAMES: usize = 5000;

/// Height of an animation in a notebook, pixels: mechanism and plots without scrolling on usual screens.
const HEIGHT: u32 = 640;

/// A picture that moves takes real time between these, s.
const SHORTEST_S: f64 = 3.0;
const LONGEST_S: f64 = 20.0;

/// The equations of a scene, each with its title, between `before` and `after`: the delimiters of display mathematics. Of a scene with counts
/// those of each item come first.
pub(crate) fn latex(info: &SceneInfo, [before, after]: [&str; 2]) -> String {
    let items = info.repeats.iter().flat_map(|repeats| repeats.templates);
    let items = items.flat_map(|item| item.equations.iter().map(move |equation| (Some(item.title), equation)));
    let all = items.chain(info.equations.iter().map(|equation| (None, equation)));
    let of = |(item, Equation { name, latex, .. }): (Option<&str>, &Equation)| {
        let title = item.map_or_else(|| (*name).to_owned(), |item| format!("{item}, {name}"));
        let lines = latex.replace(" \\\\ ", " \\\\\n");
        format!("{}:\n{before}\n{lines}\n{after}\n", sentence(&title))
    };
    all.map(of).collect::<Vec<_>>().join("\n")
}

/// With a capital, and LaTeX's special characters as text.
fn sentence(title: &str) -> String {
    let mut signs = title.chars();
    let first = signs.next().into_iter().flat_map(char::to_uppercase);
    let text = |sign: char| match sign {
        '&' | '%' | '$' | '#' | '_' | '{' | '}' => format!("\\{sign}"),
        sign => sign.to_string(),
    };
    first.chain(signs).map(text).collect()
}

fn write(path: &Path, text: &str) -> PyResult<()> {
    std::fs::write(path, text).map_err(|cause| {
        wrong(format!("`{}` cannot be written: {cause}; give a file in a folder that exists", path.display()))
    })
}

/// The ending of a file's name in lower case.
fn ending(path: &Path) -> String {
    path.extension().unwrap_or_default().to_string_lossy().to_lowercase()
}

/// A technical drawing of a mechanism. A notebook shows it.
#[pyclass(frozen, name = "Sketch", module = "ezy")]
pub(crate) struct PySketch {
    pub(crate) svg: String,
}

#[pymethods]
impl PySketch {
    /// The text of the SVG file.
    #[getter]
    fn svg(&self) -> &str {
        &self.svg
    }

    /// Writes the SVG file.
    fn save(&self, path: PathBuf) -> PyResult<()> {
        if ending(&path) != "svg" {
            return Err(wrong(format!("`{}`: sketches are written as .svg; give such a file", path.display())));
        }
        write(&path, &self.svg)
    }

    fn _repr_svg_(&self) -> &str {
        &self.svg
    }
}

/// An animation of a run: a page with the mechanism, its forces and its plots. A notebook shows it.
#[pyclass(frozen, name = "Animation", module = "ezy")]
pub(crate) struct PyAnimation {
    page: String,
    film: String,
}

impl PyAnimation {
    /// With a frame for each sample of the run.
    pub(crate) fn new(scene: &dyn Scene, run: &Run, method: Method) -> PyResult<Self> {
        let n_frames = run.samples().len();
        if n_frames > MOST_FRAMES {
            return Err(wrong(format!(
                "an animation has {MOST_FRAMES} frames at most, one for each sample, but this run has {n_frames} samples; run the \
                 scene once more with a larger `every`"
            )));
        }
        let elements = Elements::new(scene);
        let frames: Vec<Placed> = run.samples().map(|sample| elements.at_sample(scene, &sample)).collect();
        let info = run.info();
        let drawing = Drawing::new(scene, elements, &frames[0], &frames, None);
        let film = Film::new(&drawing, &frames, &format!("{}, scene {}", info.model, info.name));
        let film = film.moving(run.last().t.clamp(SHORTEST_S, LONGEST_S));
        Ok(Self { page: animation_page(scene, run, method), film })
    }
}

#[pymethods]
impl PyAnimation {
    /// Writes it: as the page that `ezy animate` writes, .html, or as a picture that moves, .svg.
    fn save(&self, path: PathBuf) -> PyResult<()> {
        match ending(&path).as_str() {
            "html" | "htm" => write(&path, &self.page),
            "svg" => write(&path, &self.film),
            _ => Err(wrong(format!("`{}`: animations are written as .html or .svg; give such a file", path.display()))),
        }
    }

    /// The page in a frame of its own: its styles and its script know nothing of the notebook.
    fn _repr_html_(&self) -> String {
        let page = escape(&self.page);
        format!("<iframe srcdoc=\"{page}\" style=\"width: 100%; height: {HEIGHT}px; border: 0\"></iframe>")
    }
}
