//! Figures as data: panels, curves, bodies, maps, axes. [`Figure::save`] draws one as SVG and PNG.
//!
//! Curves differ in dash and in lightness, so that a figure keeps its meaning when it is printed in grey. Text is drawn from an
//! embedded face, so a figure is the same to the byte on every machine.

mod canvas;
mod color_bar;
mod color_scale;
mod contour;
mod contour_labels;
mod contours;
mod draw;
mod hatch;
mod legend;
pub(super) mod lettering;
mod look;
mod map;
mod marker;
pub(super) mod outline;
mod panel;
pub(super) mod png;
mod range;
mod raster;
mod room;
mod sheet;
mod svg;
mod thin;
mod ticks;

use std::path::{Path, PathBuf};

use super::page::Picture;
use look::Look;
use map::Map;
use sheet::Width;

/// How the axes are scaled.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Axes {
    /// Both linear; the abscissa ends with the data: for values over time.
    Series,
    /// Both linear, with room on all sides.
    Plane,
    /// Both linear, with the same length for one unit: for paths and shapes.
    Equal,
    /// Both linear; both end with the cells of a map.
    Map,
    /// Both logarithmic.
    LogLog,
    /// The abscissa logarithmic, the ordinate linear: for values over the frequency.
    LogX,
}

impl Axes {
    /// Whether abscissa and ordinate are logarithmic.
    fn are_logarithmic(self) -> [bool; 2] {
        [matches!(self, Self::LogLog | Self::LogX), self == Self::LogLog]
    }
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
    x: f64,
    y: f64,
    /// What it says.
    text: String,
}

/// One pair of axes.
#[derive(Debug, Clone)]
struct Panel {
    /// Name and unit of the ordinate.
    y_label: String,
    /// What lies under the curves.
    map: Option<Map>,
    /// What is drawn, in this order.
    curves: Vec<Curve>,
    /// Texts over the curves.
    notes: Vec<Note>,
    n_lines: usize,
}

/// A figure with one pair of axes, or with several above each other that share the abscissa.
///
/// ```no_run
/// use ezy_study::report::figure::Figure;
///
/// let (t, x, v) = (vec![0.0, 1.0, 2.0], vec![0.0, 0.2, 0.8], vec![0.0, 0.5, 0.7]);
/// let figure = Figure::time_series("A cart", "time [s]", "place [m]")
///     .line("cart", t.clone(), x)
///     .panel("speed [m/s]")
///     .line("cart", t, v);
/// figure.save("out".as_ref(), "cart")?; // out/cart.svg and out/cart.png
/// # Ok::<(), ezy_study::report::figure::FigureError>(())
/// ```
#[derive(Debug, Clone)]
pub struct Figure {
    /// Headline.
    title: String,
    /// Name and unit of the abscissa.
    x_label: String,
    /// Scaling of the axes.
    axes: Axes,
    /// From the upper one to the lower one; never empty.
    panels: Vec<Panel>,
}

/// Why a figure could not be made.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum FigureError {
    /// No point of any curve and no cell of a map can be shown.
    #[error(
        "figure `{title}` has nothing to draw: no finite point{positive}; give at least one curve or map with values"
    )]
    Empty {
        /// Headline of the figure.
        title: String,
        /// ` above zero, as its logarithmic axes need`, or empty.
        positive: &'static str,
    },
    /// The places and values of a map are no grid.
    #[error(
        "the map of figure `{title}` has no grid: {fault}; give finite ascending x and y, and a z for each pair of them"
    )]
    Grid {
        /// Headline of the figure.
        title: String,
        /// What is wrong, such as `z has 3 values in place of 2 × 2`.
        fault: String,
    },
    /// The picture has more pixels than the machine can keep.
    #[error("figure `{title}` could not be drawn as PNG: {width} × {height} points are too many")]
    TooLarge {
        /// Headline of the figure.
        title: String,
        /// Points across.
        width: f64,
        /// Points down.
        height: f64,
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
        Self::new(title, x_label, y_label, Axes::Series)
    }

    /// Linear axes with room on all sides, for one value over another: a phase plane.
    pub fn plane(title: &str, x_label: &str, y_label: &str) -> Self {
        Self::new(title, x_label, y_label, Axes::Plane)
    }

    /// Equal axes in metres, for paths and bodies in the plane.
    pub fn track(title: &str) -> Self {
        Self::equal(title, "x [m]", "y [m]")
    }

    /// Linear axes with the same length for one unit, for two values of the same unit.
    pub fn equal(title: &str, x_label: &str, y_label: &str) -> Self {
        Self::new(title, x_label, y_label, Axes::Equal)
    }

    /// Logarithmic axes, for convergence and growth.
    pub fn log_log(title: &str, x_label: &str, y_label: &str) -> Self {
        Self::new(title, x_label, y_label, Axes::LogLog)
    }

    /// A logarithmic abscissa and a linear ordinate, for values over the frequency.
    pub fn log_x(title: &str, x_label: &str, y_label: &str) -> Self {
        Self::new(title, x_label, y_label, Axes::LogX)
    }

    /// Values over a rectangular grid of two parameters: a heat map with contours and a colour bar. What is drawn after it lies over it.
    ///
    /// | name | shape | meaning |
    /// |---|---|---|
    /// | `x` | `n_x`, ascending | centres of the columns |
    /// | `y` | `n_y`, ascending | centres of the rows |
    /// | `z` | `n_y · n_x`, `z[i_y * n_x + i_x]` | values; NaN where there is none |
    ///
    /// Cells end in the middle between two centres, the outer ones as far beyond their centre. The axes end with them, or with curves that go
    /// further. Above 256 cells along a side the picture shows at most 256 groups of them, with the mean of those that have a value.
    ///
    /// Colours are those of viridis in 128 steps, from dark for the least value to light for the largest. Cells without value are grey and
    /// hatched, and the colour bar says so. The cells are one image within the SVG.
    ///
    /// Contours are drawn at the ticks of the colour bar, by linear interpolation between centres; there is none beside a cell without
    /// value. Contours in noise are left out: those that extend less than 18 points of the picture, and all if they cover 15 % of the map.
    ///
    /// What is no grid (see [`FigureError::Grid`]) is refused when the figure is drawn.
    ///
    /// ```
    /// use ezy_study::report::figure::Figure;
    ///
    /// let (x, y) = (vec![1.0, 2.0, 3.0], vec![10.0, 20.0]);
    /// let speed = vec![0.1, 0.2, 0.3, 0.2, f64::NAN, 0.6];
    /// let map = Figure::map("Speed", "frequency [Hz]", "amplitude [mm]", "speed [m/s]", x, y, speed);
    /// let svg = map.picture()?.wide;
    /// # Ok::<(), ezy_study::report::figure::FigureError>(())
    /// ```
    pub fn map(
        title: &str,
        x_label: &str,
        y_label: &str,
        z_label: &str,
        x: Vec<f64>,
        y: Vec<f64>,
        z: Vec<f64>,
    ) -> Self {
        let mut figure = Self::new(title, x_label, y_label, Axes::Map);
        figure.current().map = Some(Map::new(z_label, x, y, z));
        figure
    }

    fn new(title: &str, x_label: &str, y_label: &str, axes: Axes) -> Self {
        let (title, x_label) = (title.to_owned(), x_label.to_owned());
        Self { title, x_label, axes, panels: vec![Panel::new(y_label)] }
    }

    /// A further panel below, with the same abscissa and an ordinate of its own; what follows is drawn there. Of the panels of
    /// [`Figure::equal`] only one is of use.
    #[must_use]
    pub fn panel(mut self, y_label: &str) -> Self {
        self.panels.push(Panel::new(y_label));
        self
    }

    /// The panel that is drawn in.
    fn current(&mut self) -> &mut Panel {
        let last = self.panels.len() - 1;
        &mut self.panels[last]
    }

    /// A line, in the next look of its panel: dark and solid, lighter and dashed, light and dash-dotted, ….
    #[must_use]
    pub fn line(self, name: &str, x: Vec<f64>, y: Vec<f64>) -> Self {
        self.next_line(name, x, y, |look, _| look)
    }

    /// A line with a marker at each point, in the next look: for measured values.
    #[must_use]
    pub fn points(self, name: &str, x: Vec<f64>, y: Vec<f64>) -> Self {
        self.next_line(name, x, y, Look::with_marker)
    }

    /// Markers alone, in the next look: for values that do not follow each other.
    #[must_use]
    pub fn cloud(self, name: &str, x: Vec<f64>, y: Vec<f64>) -> Self {
        self.next_line(name, x, y, |look, index| look.with_marker(index).without_line())
    }

    fn next_line(mut self, name: &str, x: Vec<f64>, y: Vec<f64>, look: fn(Look, usize) -> Look) -> Self {
        let index = self.current().n_lines;
        self.current().n_lines += 1;
        self.push(name, x, y, look(Look::line(index), index))
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

    /// Small dots on curves: marks of time on a path.
    #[must_use]
    pub fn marks(self, name: &str, x: Vec<f64>, y: Vec<f64>) -> Self {
        self.push(name, x, y, Look::marks())
    }

    /// A text centred at a place of the axes, or beside it where something is drawn there.
    #[must_use]
    pub fn note(mut self, x: f64, y: f64, text: &str) -> Self {
        self.current().notes.push(Note { x, y, text: text.to_owned() });
        self
    }

    fn push(mut self, name: &str, x: Vec<f64>, y: Vec<f64>, look: Look) -> Self {
        debug_assert_eq!(x.len(), y.len(), "curve `{name}` of figure `{}`", self.title);
        self.current().curves.push(Curve { name: name.to_owned(), x, y, look });
        self
    }

    /// The figure as SVG for a page, in two widths: for wide and for narrow screens.
    ///
    /// # Errors
    /// [`FigureError::Empty`], [`FigureError::Grid`].
    pub fn picture(&self) -> Result<Picture, FigureError> {
        let [wide, narrow] = [Width::Wide, Width::Narrow].map(|width| draw::picture(self, width));
        Ok(Picture { wide: svg::svg(&wide?), narrow: svg::svg(&narrow?) })
    }

    /// The figure as the bytes of a PNG file.
    ///
    /// # Errors
    /// [`FigureError::Empty`], [`FigureError::Grid`], [`FigureError::TooLarge`].
    pub fn png(&self) -> Result<Vec<u8>, FigureError> {
        let canvas = draw::picture(self, Width::Wide)?;
        let (width, height) = (canvas.width, canvas.height);
        png::png(&canvas).ok_or_else(|| FigureError::TooLarge { title: self.title.clone(), width, height })
    }

    /// Writes `directory/name.svg` and `directory/name.png`, and returns the SVG for a page.
    ///
    /// # Errors
    /// [`FigureError`]: nothing to draw, or a file that cannot be written.
    pub fn save(&self, directory: &Path, name: &str) -> Result<Picture, FigureError> {
        let (picture, png) = (self.picture()?, self.png()?);
        for (extension, bytes) in [("svg", picture.wide.as_bytes()), ("png", &png)] {
            let path = directory.join(format!("{name}.{extension}"));
            crate::output::write(&path, bytes).map_err(|cause| FigureError::Write { path, cause })?;
        }
        Ok(picture)
    }
}

impl Panel {
    fn new(y_label: &str) -> Self {
        Self { y_label: y_label.to_owned(), map: None, curves: Vec::new(), notes: Vec::new(), n_lines: 0 }
    }
}
