//! The only file that calls the plotting library.

use ruviz::core::config::PlotConfig;
use ruviz::core::plot::Plot;
use ruviz::prelude::{AxisScale, Color, LegendPosition, LineStyle, MarkerStyle, TextStyle};

use super::look::Marker;
use super::{Axes, Curve, Figure, FigureError, Note};

/// Pixels per inch of the PNG: 2000 across, sharp on a projector.
const PNG_DPI: u32 = 220;
/// Points; axis labels of 13 pt on a 9 in figure are readable from the last row.
const FONT_PT: f32 = 13.0;
const MARKER_PT: f32 = 7.0;
const RING_PT: f32 = 6.0;
const CLOUD_PT: f32 = 4.0;
/// Share of the span left free around the data.
const MARGIN: f64 = 0.04;
/// Height over width that a figure with equal axes has at least and at most: flat paths keep room for texts.
const EQUAL_SHAPE: [f64; 2] = [0.25, 0.75];
/// Letters that fit into one row of the legend.
const LEGEND_LETTERS: usize = 62;
/// Inches across, and what title, axis labels and legend take of the height.
const WIDTH_IN: f32 = 9.0;
const FRAME_IN: f32 = 1.9;

pub(super) fn svg(figure: &Figure) -> Result<String, FigureError> {
    plot(figure)?.render_to_svg().map_err(|e| refused(figure, &e))
}

pub(super) fn png(figure: &Figure) -> Result<Vec<u8>, FigureError> {
    plot(figure)?.dpi(PNG_DPI).render_png_bytes().map_err(|e| refused(figure, &e))
}

fn refused(figure: &Figure, cause: &dyn std::fmt::Display) -> FigureError {
    FigureError::Draw { title: figure.title.clone(), cause: cause.to_string() }
}

fn plot(figure: &Figure) -> Result<Plot, FigureError> {
    let ([x0, x1], [y0, y1]) = limits(figure)?;
    let (width_in, height_in) = match figure.axes {
        Axes::Linear => (WIDTH_IN, 5.0),
        Axes::LogLog => (WIDTH_IN, 6.0),
        Axes::Equal => (WIDTH_IN, (WIDTH_IN - 1.3) * ((y1 - y0) / (x1 - x0)) as f32 + FRAME_IN),
    };
    let config = PlotConfig::builder().figure(width_in, height_in).font_size(FONT_PT).build();
    let mut plot = Plot::with_config(config)
        .title(figure.title.as_str())
        .xlabel(figure.x_label.as_str())
        .ylabel(figure.y_label.as_str())
        .xlim(x0, x1)
        .ylim(y0, y1)
        .grid(true);
    plot = match figure.axes {
        Axes::Linear => plot,
        Axes::Equal => plot.aspect_equal(),
        Axes::LogLog => plot.xscale(AxisScale::Log).yscale(AxisScale::Log),
    };
    for curve in &figure.curves {
        plot = add_curve(plot, curve, figure.axes);
    }
    for note in &figure.notes {
        plot = add_note(plot, note);
    }
    Ok(match legend_columns(figure) {
        0 => plot,
        columns => plot.legend(LegendPosition::OutsideLower).legend_columns(columns),
    })
}

/// Columns of the legend: none for a single curve, which the title names; all columns are as wide as the longest name.
fn legend_columns(figure: &Figure) -> usize {
    let names: Vec<usize> = figure.curves.iter().map(|c| c.name.chars().count()).filter(|n| *n > 0).collect();
    match names.iter().max() {
        Some(longest) if names.len() > 1 => (LEGEND_LETTERS / longest).clamp(1, 3.min(names.len())),
        _ => 0,
    }
}

fn add_curve(plot: Plot, curve: &Curve, axes: Axes) -> Plot {
    let look = &curve.look;
    let drawable = |v: f64| v.is_finite() && (axes != Axes::LogLog || v > 0.0);
    let (x, y): (Vec<f64>, Vec<f64>) =
        curve.x.iter().zip(&curve.y).filter(|(x, y)| drawable(**x) && drawable(**y)).unzip();
    if x.is_empty() {
        return plot;
    }
    let color = Color::from_rgb(look.color[0], look.color[1], look.color[2]);
    if look.width_pt == 0.0 {
        let (size, edge) = if look.is_ring { (RING_PT, 1.4) } else { (CLOUD_PT, 0.2) };
        let marker = marker_style(look.marker).unwrap_or(MarkerStyle::Circle);
        let markers = plot.scatter(&x, &y).color(color).marker(marker).marker_size(size);
        let markers = markers.edge_color(Color::from_rgb(0, 0, 0)).edge_width(edge);
        return if curve.name.is_empty() { markers.into() } else { markers.label(curve.name.as_str()).into() };
    }
    let style = if look.dash.is_empty() { LineStyle::Solid } else { LineStyle::Custom(look.dash.to_vec()) };
    let mut line = plot.line(&x, &y).color(color).line_width(look.width_pt).line_style(style);
    if let Some(marker) = marker_style(look.marker) {
        line = line.marker(marker).marker_size(MARKER_PT);
    }
    if !curve.name.is_empty() {
        line = line.label(curve.name.as_str());
    }
    line.into()
}

fn marker_style(marker: Marker) -> Option<MarkerStyle> {
    match marker {
        Marker::None => None,
        Marker::Circle => Some(MarkerStyle::Circle),
        Marker::Square => Some(MarkerStyle::Square),
        Marker::Triangle => Some(MarkerStyle::Triangle),
        Marker::Diamond => Some(MarkerStyle::Diamond),
    }
}

fn add_note(plot: Plot, note: &Note) -> Plot {
    let background = Some(Color::from_rgb(255, 255, 255));
    let style = TextStyle { font_size: FONT_PT - 2.0, background, ..TextStyle::default() };
    plot.text_styled(note.x, note.y, note.text.as_str(), style)
}

/// Limits of both axes around everything that can be drawn.
fn limits(figure: &Figure) -> Result<([f64; 2], [f64; 2]), FigureError> {
    let log = figure.axes == Axes::LogLog;
    let range = |pick: fn(&Curve) -> &Vec<f64>, place: fn(&Note) -> f64| {
        let all = figure.curves.iter().flat_map(pick).copied().chain(figure.notes.iter().map(place));
        let shown = all.filter(|v| v.is_finite() && (!log || *v > 0.0));
        let scaled = shown.map(|v| if log { v.log10() } else { v });
        scaled.fold([f64::INFINITY, f64::NEG_INFINITY], |[lo, hi], v| [lo.min(v), hi.max(v)])
    };
    let (x, y) = (range(|c| &c.x, |n| n.x), range(|c| &c.y, |n| n.y));
    if !(x[0].is_finite() && y[0].is_finite()) {
        let positive = if log { " above zero, as its logarithmic axes need" } else { "" };
        return Err(FigureError::Empty { title: figure.title.clone(), positive });
    }
    let widen = |[lo, hi]: [f64; 2], share: f64| {
        let span = if hi > lo { hi - lo } else { 1.0 };
        let unscale = |v: f64| if log { 10f64.powf(v) } else { v };
        [unscale(lo - share * span), unscale(hi + share * span)]
    };
    // time runs to the edges of its axis
    let x_margin = if figure.axes == Axes::Linear { 0.0 } else { MARGIN };
    let (x, y) = (widen(x, x_margin), widen(y, MARGIN));
    Ok(if figure.axes == Axes::Equal { shaped(x, y) } else { (x, y) })
}

/// Widens one of two linear ranges about its middle until height over width lies within [`EQUAL_SHAPE`].
fn shaped(x: [f64; 2], y: [f64; 2]) -> ([f64; 2], [f64; 2]) {
    let about = |[lo, hi]: [f64; 2], span: f64| [0.5 * (lo + hi - span), 0.5 * (lo + hi + span)];
    let (width, height) = (x[1] - x[0], y[1] - y[0]);
    (about(x, width.max(height / EQUAL_SHAPE[1])), about(y, height.max(width * EQUAL_SHAPE[0])))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn invariant_limits_of_equal_axes_keep_a_shape_of_one_quarter_at_least() {
        let flat = Figure::track("flat").line("path", vec![0.0, 10.0], vec![0.0, 0.1]);
        let ([x0, x1], [y0, y1]) = limits(&flat).unwrap();
        assert!((y1 - y0) >= 0.25 * (x1 - x0) * (1.0 - 1e-12), "{x0} {x1} {y0} {y1}");
    }

    #[test]
    fn invariant_limits_of_logarithmic_axes_skip_values_that_have_no_logarithm() {
        let figure = Figure::log_log("gap", "h", "gap").points("gap", vec![0.1, 1.0, 10.0], vec![0.0, 1e-3, f64::NAN]);
        let (_, [y0, y1]) = limits(&figure).unwrap();
        assert!(y0 > 1e-4 && y0 < 1e-3 && y1 > 1e-3 && y1 < 1e-2, "{y0} {y1}");
    }

    #[test]
    fn invariant_figure_without_finite_points_is_an_error() {
        let empty = Figure::time_series("empty", "t", "v").line("v", vec![0.0], vec![f64::NAN]);
        assert!(matches!(svg(&empty), Err(FigureError::Empty { .. })));
    }
}
