//! A figure as a picture: where title, panels and legends stand.

use super::canvas::{Anchor, BLACK, Canvas, Frame};
use super::color_bar::ColorBar;
use super::contours::draw_map;
use super::legend::Legend;
use super::map::Grid;
use super::panel::{Scales, TICK, TICK_GAP, TICK_SIZE, draw_axes, draw_curves, draw_notes};
use super::sheet::{LABEL_SIZE, LINE, Width};
use super::ticks::{self, Ticks};
use super::{Axes, Figure, FigureError, lettering, range};

const TITLE_SIZE: f64 = 16.0;
/// From the edge of the picture to what is on it.
const MARGIN: f64 = 10.0;
/// Space between two panels.
const BETWEEN: f64 = 14.0;
/// Least distance of two ticks with labels: across, and down.
const TICKS_ACROSS: f64 = 64.0;
const TICKS_DOWN: f64 = 29.0;
/// Height that axes of equal scale have at least: flat paths keep room for texts.
const LEAST_EQUAL_HEIGHT: f64 = 175.0;
/// Width of the axes of equal scale when their height is bound.
const LEAST_EQUAL_WIDTH: f64 = 150.0;

impl Width {
    /// Height of the axes of a panel.
    fn height(self, figure: &Figure) -> f64 {
        let alone = match self {
            Self::Wide => 390.0,
            Self::Narrow => 280.0,
        };
        match figure.panels.len() {
            1 => alone,
            2 => 0.55 * alone,
            _ => 0.42 * alone,
        }
    }

    /// Largest height of axes of equal scale.
    fn equal_height(self) -> f64 {
        match self {
            Self::Wide => 520.0,
            Self::Narrow => 420.0,
        }
    }
}

/// Draws the figure.
pub(super) fn picture(figure: &Figure, width: Width) -> Result<Canvas, FigureError> {
    let empty = || {
        let positive =
            if figure.axes.are_logarithmic() == [true; 2] { " above zero, as its logarithmic axes need" } else { "" };
        FigureError::Empty { title: figure.title.clone(), positive }
    };
    let map = map(figure, width, &empty)?;
    let (x, mut y) = range::limits(figure).ok_or_else(empty)?;
    let [log_x, log_y] = figure.axes.are_logarithmic();
    let n_panels = figure.panels.len();
    let n_down = |height: f64| (height / TICKS_DOWN) as usize;
    let mut height = width.height(figure);
    // the labels of the ordinate say how far the axes begin from the edge, for all panels
    let label_lines: Vec<Vec<String>> =
        figure.panels.iter().map(|panel| lettering::wrapped(&panel.y_label, LABEL_SIZE, height)).collect();
    let label_width = label_lines.iter().map(Vec::len).max().unwrap_or(0) as f64 * LINE * LABEL_SIZE;
    let tick_width =
        |ticks: &Ticks| ticks.major.iter().map(|(_, label)| lettering::width(label, TICK_SIZE)).fold(0.0, f64::max);
    let first_ticks = y.iter().map(|y| axis_ticks(log_y, *y, n_down(height)));
    let widest = first_ticks.map(|ticks| tick_width(&ticks)).fold(0.0, f64::max);
    let left = MARGIN + label_width + 4.0 + widest + TICK_GAP + TICK;
    let right = map.as_ref().map_or(0.0, |(_, bar)| bar.beside()) + MARGIN + 12.0;
    let mut axes_width = width.points() - left - right;
    if figure.axes == Axes::Equal {
        let least = LEAST_EQUAL_HEIGHT / axes_width * (x[1] - x[0]);
        y[0] = range::about(y[0], (y[0][1] - y[0][0]).max(least));
        let shape = (y[0][1] - y[0][0]) / (x[1] - x[0]);
        height = (axes_width * shape).min(width.equal_height());
        axes_width = (height / shape).max(LEAST_EQUAL_WIDTH);
        height = axes_width * shape;
    }
    let total_width = left + axes_width + right;
    let x_ticks = axis_ticks(log_x, x, (axes_width / TICKS_ACROSS) as usize);

    let title = lettering::wrapped(&figure.title, TITLE_SIZE, total_width - 2.0 * MARGIN);
    let x_label = lettering::wrapped(&figure.x_label, LABEL_SIZE, total_width - 2.0 * MARGIN);
    // drawn first on a sheet without end; its height is known in the end
    let mut canvas = Canvas::new(total_width, 0.0);
    let mut top = MARGIN;
    for line in &title {
        top += LINE * TITLE_SIZE;
        canvas.text(line, [0.5 * total_width, top - 0.3 * TITLE_SIZE], Anchor::Middle, TITLE_SIZE);
    }
    top += 6.0;
    let mut known_names = Vec::new();
    for (k, panel) in figure.panels.iter().enumerate() {
        let y_ticks = axis_ticks(log_y, y[k], n_down(height));
        let map = map.as_ref().filter(|_| k == 0);
        let of_scale = if y_ticks.scale.is_some() { LINE * TICK_SIZE } else { 0.0 };
        top += map.map_or(0.0, |(_, bar)| bar.above()).max(of_scale);
        let legend = Legend::new(panel).filter(|legend| legend.names() != known_names);
        if let Some(legend) = &legend {
            known_names = legend.names();
        }
        let scales = |top: f64| Scales {
            axes: figure.axes,
            frame: Frame { left, top, right: left + axes_width, bottom: top + height },
            x,
            y: y[k],
        };
        let mut trial = Canvas::new(0.0, 0.0);
        let mut at = scales(top);
        let mut room = draw_curves(&mut trial, &at, panel);
        draw_notes(&mut trial, &at, panel, &mut room);
        // over a map it would hide cells
        let inside = legend.as_ref().filter(|_| map.is_none()).and_then(|legend| legend.inside(&at.frame, &room));
        if let (Some(legend), None) = (&legend, inside) {
            at = scales(top + legend.height_above(axes_width));
            legend.draw_above(&mut canvas, &at.frame, axes_width);
        }
        let is_lowest = k + 1 == n_panels;
        draw_axes(&mut canvas, &at, &x_ticks, &y_ticks, is_lowest);
        let mut room = if let Some((grid, bar)) = map {
            let mut room = draw_curves(&mut Canvas::new(0.0, 0.0), &at, panel);
            draw_map(&mut canvas, &at, grid, bar, &mut room);
            canvas.frame(&at.frame, BLACK, 1.0);
            if width == Width::Wide {
                bar.draw_beside(&mut canvas, &at.frame);
            }
            draw_curves(&mut canvas, &at, panel);
            room
        } else {
            draw_curves(&mut canvas, &at, panel)
        };
        draw_notes(&mut canvas, &at, panel, &mut room);
        if let (Some(legend), Some(frame)) = (&legend, inside) {
            legend.draw_inside(&mut canvas, &frame);
        }
        let n_lines = label_lines[k].len();
        for (i, line) in label_lines[k].iter().enumerate() {
            let from_right = (n_lines - 1 - i) as f64 * LINE * LABEL_SIZE;
            let place = [MARGIN + label_width - from_right - 0.3 * LABEL_SIZE, 0.5 * (at.frame.top + at.frame.bottom)];
            canvas.text_upwards(line, place, LABEL_SIZE);
        }
        top = at.frame.bottom + if is_lowest { 0.0 } else { BETWEEN };
    }
    top += TICK + TICK_GAP + LINE * TICK_SIZE;
    if let Some(scale) = &x_ticks.scale {
        top += LINE * TICK_SIZE;
        canvas.text(scale, [left + axes_width, top - 0.3 * TICK_SIZE], Anchor::End, TICK_SIZE);
    }
    for line in &x_label {
        top += LINE * LABEL_SIZE;
        canvas.text(line, [left + 0.5 * axes_width, top - 0.2 * LABEL_SIZE], Anchor::Middle, LABEL_SIZE);
    }
    if let (Some((_, bar)), Width::Narrow) = (&map, width) {
        top = bar.draw_below(&mut canvas, [left, left + axes_width], top);
    }
    canvas.set_height((top + MARGIN).ceil());
    Ok(canvas)
}

/// The cells of the map and its colour bar; the first panel alone has a map.
fn map<'f>(
    figure: &'f Figure,
    width: Width,
    empty: &impl Fn() -> FigureError,
) -> Result<Option<(&'f Grid, ColorBar)>, FigureError> {
    let Some(map) = &figure.panels[0].map else { return Ok(None) };
    let fault = |fault: &String| FigureError::Grid { title: figure.title.clone(), fault: fault.clone() };
    let grid = map.grid.as_ref().map_err(fault)?;
    let extent = grid.extent().ok_or_else(empty)?;
    Ok(Some((grid, ColorBar::new(map, grid, extent, width, width.height(figure)))))
}

fn axis_ticks(is_logarithmic: bool, limits: [f64; 2], n: usize) -> Ticks {
    if is_logarithmic { ticks::logarithmic(limits, n) } else { ticks::linear(limits, n) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::figure::canvas::{Segment, Shape};

    /// Figures of every kind, with legends, notes and panels.
    fn figures() -> Vec<Figure> {
        let t: Vec<f64> = (0..400).map(|i| f64::from(i) * 0.05).collect();
        let of = |f: fn(f64) -> f64| t.iter().map(|t| f(*t)).collect::<Vec<f64>>();
        let mut many = Figure::time_series("Nine waves", "time [s]", "angle [rad]");
        for k in 0..9 {
            let wave = t.iter().map(|t| (t + f64::from(k)).sin()).collect();
            many = many.line(&format!("k = {k}"), t.clone(), wave);
        }
        let panels = Figure::time_series("Panels", "time [s]", "angle [rad]")
            .line("one", t.clone(), of(f64::sin))
            .line("two", t.clone(), of(|t| 0.2 * t))
            .panel("a difference of two angles that is small [rad]")
            .line("", t.clone(), of(|t| 3e-9 * t));
        let path =
            Figure::track("A path").line("A", of(f64::cos), of(f64::sin)).marks("every 1 s", vec![1.0], vec![0.0]);
        let path = path.note(1.0, 0.0, "0 s").note(0.0, 1.0, "2 s");
        let flat =
            Figure::track("A flat path").line("A", t.clone(), of(|t| 1e-3 * t)).line("B", t.clone(), of(|_| 0.1));
        let steep = Figure::log_log("A slope", "step [s]", "error [m]").points(
            "rk4",
            t[1..].to_vec(),
            t[1..].iter().map(|t| t.powi(4)).collect(),
        );
        let wave = |hole: f64| {
            let (x, y) = (t[..60].to_vec(), t[..40].to_vec());
            let value =
                |x: f64, y: f64| if x.hypot(y - 1.0) < hole { f64::NAN } else { (3.0 * x).sin() * (4.0 * y).cos() };
            let z = y.iter().flat_map(|y| x.iter().map(|x| value(*x, *y))).collect();
            Figure::map("A map", "frequency [Hz]", "amplitude [rad]", "speed [m/s]", x, y, z)
        };
        let over = wave(0.4).line("", t[..50].to_vec(), of(|t| 0.3 * t)[..50].to_vec());
        let over = over.marks("measured", vec![1.0, 2.0], vec![0.5, 1.5]).note(1.0, 0.5, "1").note(1.4, 1.0, "second");
        let three = Figure::map(
            "Three",
            "x",
            "y",
            &"name ".repeat(30),
            t[..3].to_vec(),
            vec![1.0],
            of(|t| 12.0 + 1e-6 * t)[..3].to_vec(),
        );
        vec![
            wave(0.0),
            over,
            three,
            many,
            panels,
            path,
            flat,
            steep.guide("slope 4", vec![0.1, 1.0], vec![1e-5, 0.1]).note(0.3, 1e-3, "slope 4"),
        ]
    }

    fn texts(canvas: &Canvas) -> Vec<(&str, Frame)> {
        let text = |shape| match shape {
            &Shape::Text { ref text, frame, .. } => Some((text.as_str(), frame)),
            _ => None,
        };
        canvas.shapes.iter().filter_map(text).collect()
    }

    #[test]
    fn invariant_texts_stand_on_the_sheet_and_apart() {
        for (figure, width) in figures().iter().flat_map(|figure| [(figure, Width::Wide), (figure, Width::Narrow)]) {
            let canvas = picture(figure, width).unwrap();
            let sheet = Frame { left: 0.0, top: 0.0, right: canvas.width, bottom: canvas.height };
            let texts = texts(&canvas);
            assert!(texts.len() > 8, "{texts:?}");
            for (i, (text, frame)) in texts.iter().enumerate() {
                assert!(sheet.holds(frame), "`{text}` of `{}` leaves the sheet: {frame:?}", figure.title);
                for (other, of_other) in &texts[..i] {
                    let apart = frame.right <= of_other.left
                        || of_other.right <= frame.left
                        || frame.bottom <= of_other.top
                        || of_other.bottom <= frame.top;
                    assert!(apart, "`{text}` and `{other}` of `{}` in {width:?}", figure.title);
                }
            }
        }
    }

    #[test]
    fn invariant_text_covers_no_point_of_a_curve() {
        for figure in figures() {
            let canvas = picture(&figure, Width::Wide).unwrap();
            let texts = texts(&canvas);
            for shape in &canvas.shapes {
                let Shape::Stroke { outline, width, .. } = shape else { continue };
                // curves; axes and grid are thinner
                let is_curve = *width > 1.2 && outline.len() > 9;
                for segment in outline.iter().filter(|_| is_curve) {
                    let (Segment::Move([x, y]) | Segment::Line([x, y])) = segment else { continue };
                    let covering =
                        texts.iter().find(|(_, f)| f.left < *x && *x < f.right && f.top < *y && *y < f.bottom);
                    assert!(covering.is_none(), "{covering:?} of `{}`", figure.title);
                }
            }
        }
    }

    #[test]
    fn invariant_legend_is_drawn_once_for_panels_of_the_same_curves() {
        let line =
            |figure: Figure| figure.line("a", vec![0.0, 1.0], vec![0.0, 1.0]).line("b", vec![0.0, 1.0], vec![1.0, 0.0]);
        let figure = line(line(Figure::time_series("Twice", "t", "x [m]")).panel("v [m/s]"));
        let canvas = picture(&figure, Width::Wide).unwrap();
        assert_eq!(texts(&canvas).iter().filter(|(text, _)| *text == "a").count(), 1);
    }

    #[test]
    fn invariant_figure_without_finite_points_is_an_error() {
        let empty = Figure::time_series("empty", "t", "v").line("v", vec![0.0], vec![f64::NAN]);
        assert!(matches!(picture(&empty, Width::Wide), Err(FigureError::Empty { .. })));
    }

    #[test]
    fn invariant_gap_in_a_curve_is_not_bridged() {
        let curve = Figure::time_series("gap", "t", "v").line(
            "v",
            vec![0.0, 1.0, 2.0, 3.0, 4.0],
            vec![0.0, 1.0, f64::NAN, 1.0, 2.0],
        );
        let canvas = picture(&curve, Width::Wide).unwrap();
        let curves = canvas.shapes.iter().filter(|shape| matches!(shape, Shape::Stroke { width, .. } if *width > 1.2));
        assert_eq!(curves.count(), 2);
    }
}
