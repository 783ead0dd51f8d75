//! Figures as data: curves, bodies, axes. [`Figure::save`] draws one as SVG and PNG.
//!
//! Curves differ in dash and in lightness, so that a figure keeps its meaning when it is printed in grey.

mod draw;
mod look;

use std::path::{Path, PathBuf};

use look::Look;

/// How the axes are scaled.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Axes {
    /// Both linear.
    Linear,
    /// Both linear, with the same length for one unit: for paths and shapes.
    Equal,
    /// Both logarithmic with the same length for one decade, so that slopes can be read off.
    LogLog,
}

/// Something drawn along points.
#[derive(Debug, Clone)]
struct Curve {
    /// Name in the legend; empty: no entry.
    name: String,
    /// Abscissae.
    x: Vec<f64>,
    /// Ordinates, as many as abscissae.
    y: Vec<f64>,
    look: Look,
}

/// A text at a place of the axes.
#[derive(Debug, Clone)]
struct Note {
    /// Abscissa of the middle of the text.
    x: f64,
    /// Ordinate of the middle of the text.
    y: f64,
    /// What it says.
    text: String,
}

/// A figure with one pair of axes.
///
/// ```no_run
/// use ezy_core::report::figure::Figure;
///
/// let (t, v) = (vec![0.0, 1.0, 2.0], vec![0.0, 0.5, 0.7]);
/// let figure = Figure::time_series("Speed", "time [s]", "speed [m/s]").line("cart", t, v);
/// figure.save("out".as_ref(), "speed")?; // out/speed.svg and out/speed.png
/// # Ok::<(), ezy_core::report::figure::FigureError>(())
/// ```
#[derive(Debug, Clone)]
pub struct Figure {
    /// Headline.
    title: String,
    /// Name and unit of the abscissa.
    x_label: String,
    /// Name and unit of the ordinate.
    y_label: String,
    /// Scaling of the axes.
    axes: Axes,
    /// What is drawn, in this order.
    curves: Vec<Curve>,
    /// Texts over the curves.
    notes: Vec<Note>,
    n_lines: usize,
}

/// Why a figure could not be made.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum FigureError {
    /// No point of any curve can be shown.
    #[error("figure `{title}` has nothing to draw: no finite point{positive}; give at least one curve with values")]
    Empty {
        /// Headline of the figure.
        title: String,
        /// ` above zero, as its logarithmic axes need`, or empty.
        positive: &'static str,
    },
    /// The plotting library refused.
    #[error("figure `{title}` could not be drawn: {cause}")]
    Draw {
        /// Headline of the figure.
        title: String,
        /// What the library said.
        cause: String,
    },
    /// A file could not be written.
    #[error("figure file {} could not be written: {cause}", path.display())]
    Write {
        /// The file.
        path: PathBuf,
        /// What the system said.
        cause: std::io::Error,
    },
}

impl Figure {
    /// Linear axes, wide, for values over time.
    pub fn time_series(title: &str, x_label: &str, y_label: &str) -> Self {
        Self::new(title, x_label, y_label, Axes::Linear)
    }

    /// Equal axes in metres, for paths and bodies in the plane.
    pub fn track(title: &str) -> Self {
        Self::new(title, "x [m]", "y [m]", Axes::Equal)
    }

    /// Logarithmic axes, for convergence and growth.
    pub fn log_log(title: &str, x_label: &str, y_label: &str) -> Self {
        Self::new(title, x_label, y_label, Axes::LogLog)
    }

    fn new(title: &str, x_label: &str, y_label: &str, axes: Axes) -> Self {
        let (title, x_label, y_label) = (title.to_owned(), x_label.to_owned(), y_label.to_owned());
        Self { title, x_label, y_label, axes, curves: Vec::new(), notes: Vec::new(), n_lines: 0 }
    }

    /// A line, in the next look: dark and solid, lighter and dashed, light and dash-dotted, ….
    #[must_use]
    pub fn line(self, name: &str, x: Vec<f64>, y: Vec<f64>) -> Self {
        let look = Look::line(self.n_lines);
        self.next_line(name, x, y, look)
    }

    /// A line with a marker at each point, in the next look: for measured values.
    #[must_use]
    pub fn points(self, name: &str, x: Vec<f64>, y: Vec<f64>) -> Self {
        let look = Look::line(self.n_lines).with_marker(self.n_lines);
        self.next_line(name, x, y, look)
    }

    /// Markers alone, in the next look: for values that do not follow each other.
    #[must_use]
    pub fn cloud(self, name: &str, x: Vec<f64>, y: Vec<f64>) -> Self {
        let look = Look::line(self.n_lines).with_marker(self.n_lines).without_line();
        self.next_line(name, x, y, look)
    }

    fn next_line(mut self, name: &str, x: Vec<f64>, y: Vec<f64>, look: Look) -> Self {
        self.n_lines += 1;
        self.push(name, x, y, look)
    }

    /// A broad light line, to lie under a line that may cover it.
    #[must_use]
    pub fn band(self, name: &str, x: Vec<f64>, y: Vec<f64>) -> Self {
        self.push(name, x, y, Look::band())
    }

    /// A thin grey dotted line to compare with: a law, a slope.
    #[must_use]
    pub fn guide(self, name: &str, x: Vec<f64>, y: Vec<f64>) -> Self {
        self.push(name, x, y, Look::guide())
    }

    /// The outline of a rigid body, from light (`shade` 0) to dark (`shade` 1).
    #[must_use]
    pub fn body(self, name: &str, x: Vec<f64>, y: Vec<f64>, shade: f64) -> Self {
        self.push(name, x, y, Look::body(shade))
    }

    /// A wheel as a short thick bar, in the shade of its body.
    #[must_use]
    pub fn wheel(self, x: Vec<f64>, y: Vec<f64>, shade: f64) -> Self {
        self.push("", x, y, Look::wheel(shade))
    }

    /// Hinges as rings.
    #[must_use]
    pub fn hinges(self, name: &str, x: Vec<f64>, y: Vec<f64>) -> Self {
        self.push(name, x, y, Look::hinge())
    }

    /// A text centred at a place of the axes.
    #[must_use]
    pub fn note(mut self, x: f64, y: f64, text: &str) -> Self {
        self.notes.push(Note { x, y, text: text.to_owned() });
        self
    }

    fn push(mut self, name: &str, x: Vec<f64>, y: Vec<f64>, look: Look) -> Self {
        debug_assert_eq!(x.len(), y.len(), "curve `{name}` of figure `{}`", self.title);
        self.curves.push(Curve { name: name.to_owned(), x, y, look });
        self
    }

    /// Writes `directory/name.svg` and `directory/name.png`, and returns the SVG text.
    ///
    /// # Errors
    /// [`FigureError`]: nothing to draw, or a file that cannot be written.
    pub fn save(&self, directory: &Path, name: &str) -> Result<String, FigureError> {
        let (svg, png) = (draw::svg(self)?, draw::png(self)?);
        for (extension, bytes) in [("svg", svg.as_bytes()), ("png", &png)] {
            let path = directory.join(name).with_extension(extension);
            crate::output::write(&path, bytes).map_err(|cause| FigureError::Write { path, cause })?;
        }
        Ok(svg)
    }
}
