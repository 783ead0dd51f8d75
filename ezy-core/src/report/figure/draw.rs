//! A figure as a picture: where title, panels and legends stand.

use super::canvas::{Anchor, Canvas, Frame};
use super::legend::Legend;
use super::panel::{Scales, TICK, TICK_GAP, TICK_SIZE, draw_axes, draw_curves, draw_notes};
use super::ticks::{self, Ticks};
use super::{Axes, Figure, FigureError, lettering, range};

/// How wide a picture is, in points.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Width {
    /// For a page, a slide, a paper.
    Wide,
    /// For the screen of a telephone.
    Narrow,
}

const TITLE_SIZE: f64 = 16.0;
const LABEL_SIZE: f64 = 13.5;
/// From the edge of the picture to what is on it.
const MARGIN: f64 = 10.0;
/// Space between two panels.
const BETWEEN: f64 = 14.0;
/// Height of a line of text over the size of its letters.
const LINE: f64 = 1.3;
/// Least distance of two ticks with labels: across, and down.
const TICKS_ACROSS: f64 = 64.0;
const TICKS_DOWN: f64 = 29.0;
/// Width of the axes of equal scale when their height is bound.
const LEAST_EQUAL_WIDTH: f64 = 150.0;

impl Width {
    fn points(self) -> f64 {
        match self {
            Self::Wide => 800.0,
            Self::Narrow => 390.0,
        }
    }

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
    let Some((x, y)) = range::limits(figure) else {
        let positive = if figure.axes == Axes::LogLog { " above zero, as its logarithmic axes need" } else { "" };
        return Err(FigureError::Empty { title: figure.title.clone(), positive });
    };
    let n_panels = figure.panels.len();
    let n_down = |height: f64| (height / TICKS_DOWN) as usize;
    let mut height = width.height(figure);
    // the labels of the ordinate say how far the axes begin from the edge, for all panels
    let label_lines: Vec<Vec<String>> =
        figure.panels.iter().map(|panel| lettering::wrapped(&panel.y_label, LABEL_SIZE, height)).collect();
    let label_width = label_lines.iter().map(Vec::len).max().unwrap_or(0) as f64 * LINE * LABEL_SIZE;
    let tick_width =
        |ticks: &Ticks| ticks.major.iter().map(|(_, label)| lettering::width(label, TICK_SIZE)).fold(0.0, f64::max);
    let first_ticks = y.iter().map(|y| axis_ticks(figure.axes, *y, n_down(height)));
    let widest = first_ticks.map(|ticks| tick_width(&ticks)).fold(0.0, f64::max);
    let left = MARGIN + label_width + 4.0 + widest + TICK_GAP + TICK;
    let mut axes_width = width.points() - left - MARGIN - 12.0;
    if figure.axes == Axes::Equal {
        let shape = (y[0][1] - y[0][0]) / (x[1] - x[0]);
        height = (axes_width * shape).min(width.equal_height());
        axes_width = (height / shape).max(LEAST_EQUAL_WIDTH);
        height = axes_width * shape;
    }
    let total_width = left + axes_width + MARGIN + 12.0;
    let x_ticks = axis_ticks(figure.axes, x, (axes_width / TICKS_ACROSS) as usize);

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
        let y_ticks = axis_ticks(figure.axes, y[k], n_down(height));
        if y_ticks.scale.is_some() {
            top += LINE * TICK_SIZE;
        }
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
        let inside = legend.as_ref().and_then(|legend| legend.inside(&at.frame, &room));
        if let (Some(legend), None) = (&legend, inside) {
            at = scales(top + legend.height_above(axes_width));
            legend.draw_above(&mut canvas, &at.frame, axes_width);
        }
        let is_lowest = k + 1 == n_panels;
        draw_axes(&mut canvas, &at, &x_ticks, &y_ticks, is_lowest);
        let mut room = draw_curves(&mut canvas, &at, panel);
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
    canvas.set_height((top + MARGIN).ceil());
    Ok(canvas)
}

fn axis_ticks(axes: Axes, limits: [f64; 2], n: usize) -> Ticks {
    match axes {
        Axes::LogLog => ticks::logarithmic(limits, n),
        Axes::Series | Axes::Plane | Axes::Equal => ticks::linear(limits, n),
    }
}
