//! The limits of the axes.

use super::{Axes, Curve, Figure, Panel, ticks};

/// Part of the span left free around the data.
const MARGIN: f64 = 0.04;
/// A span below this part of the values is rounding: the axis shows one value.
const ROUNDING: f64 = 1e-13;
/// Below this a span is too small for powers of ten: values are shown as zero.
const LEAST_SPAN: f64 = 1e-290;
/// Part of a value that an axis shows on both sides when it is the only one.
const AROUND_A_VALUE: f64 = 0.1;

/// Whether abscissa and ordinate have a place on axes of this kind.
pub(super) fn is_drawable(axes: Axes, [x, y]: [f64; 2]) -> bool {
    let [log_x, log_y] = axes.are_logarithmic();
    [(x, log_x), (y, log_y)].into_iter().all(|(value, is_log)| value.is_finite() && (!is_log || value > 0.0))
}

/// The points of a curve, with gaps (`None`) where a number has no place on its axis.
pub(super) fn points(axes: Axes, curve: &Curve) -> impl Iterator<Item = Option<[f64; 2]>> + '_ {
    let all = curve.x.iter().zip(&curve.y);
    all.map(move |(x, y)| is_drawable(axes, [*x, *y]).then_some([*x, *y]))
}

/// Limits of abscissa and ordinate around everything that can be drawn in `panel`; `None` where nothing can.
fn extent(axes: Axes, panel: &Panel) -> Option<[[f64; 2]; 2]> {
    let points = panel.curves.iter().flat_map(|curve| points(axes, curve).flatten());
    let notes = panel.notes.iter().map(|note| [note.x, note.y]);
    let map = panel.map.as_ref().and_then(|map| map.grid.as_ref().ok());
    let corners = map.into_iter().flat_map(|grid| {
        let ([left, right], [lower, upper]) = (grid.x.limits(), grid.y.limits());
        [[left, lower], [right, upper]]
    });
    let mut all = corners.chain(points).chain(notes.filter(|place| is_drawable(axes, *place)));
    let [x, y] = all.next()?;
    Some(all.fold([[x, x], [y, y]], |[[x0, x1], [y0, y1]], [x, y]| [[x0.min(x), x1.max(x)], [y0.min(y), y1.max(y)]]))
}

/// The limits of the common abscissa, and those of the ordinate of each panel; `None` where nothing can be drawn.
pub(super) fn limits(figure: &Figure) -> Option<([f64; 2], Vec<[f64; 2]>)> {
    let axes = figure.axes;
    let extents: Vec<_> = figure.panels.iter().map(|panel| extent(axes, panel)).collect();
    let of_all = |[a0, a1]: [f64; 2], [b0, b1]: [f64; 2]| [a0.min(b0), a1.max(b1)];
    let x = extents.iter().flatten().map(|[x, _]| *x).reduce(of_all)?;
    // a panel without points shows the values about zero
    let y = extents.iter().map(|extent| extent.map_or([0.0, 0.0], |[_, y]| y));
    Some(match axes {
        Axes::LogLog => {
            (ticks::log_limits(x), y.map(|y| if y[0] > 0.0 { ticks::log_limits(y) } else { [0.1, 10.0] }).collect())
        }
        Axes::LogX => (ticks::log_limits(x), y.map(|y| widened(y, MARGIN)).collect()),
        Axes::Map => (widened(x, 0.0), y.map(|y| widened(y, 0.0)).collect()),
        // time runs to the edges of its axis
        Axes::Series => (widened(x, 0.0), y.map(|y| widened(y, MARGIN)).collect()),
        Axes::Plane | Axes::Equal => (widened(x, MARGIN), y.map(|y| widened(y, MARGIN)).collect()),
    })
}

/// A range with `part` of its span more on each side, and with some room around a single value.
pub(super) fn widened([low, high]: [f64; 2], part: f64) -> [f64; 2] {
    let size = low.abs().max(high.abs());
    if is_single([low, high]) {
        let room = if size > LEAST_SPAN { AROUND_A_VALUE * size } else { 1.0 };
        return about([low, high], 2.0 * room);
    }
    let margin = part * (high - low);
    [low - margin, high + margin]
}

/// Whether the values of a range differ by rounding at most.
pub(super) fn is_single([low, high]: [f64; 2]) -> bool {
    high - low <= LEAST_SPAN.max(ROUNDING * low.abs().max(high.abs()))
}

/// A range of this span with the same middle.
pub(super) fn about([low, high]: [f64; 2], span: f64) -> [f64; 2] {
    let middle = 0.5 * low + 0.5 * high;
    [middle - 0.5 * span, middle + 0.5 * span]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn invariant_limits_of_logarithmic_axes_skip_values_that_have_no_logarithm() {
        let figure = Figure::log_log("gap", "h", "gap").points("gap", vec![0.1, 1.0, 10.0], vec![0.0, 1e-3, f64::NAN]);
        let (x, y) = limits(&figure).unwrap();
        assert_eq!(y[0].map(|y| format!("{y:e}")), ["1e-4", "1e-2"], "{x:?}");
    }

    #[test]
    fn invariant_ordinate_over_a_logarithmic_abscissa_may_be_negative() {
        let figure = Figure::log_x("G", "frequency", "phase").line("G", vec![0.0, 0.3, 10.0], vec![90.0, -10.0, -90.0]);
        let (x, y) = limits(&figure).unwrap();
        assert!((x[0] - 0.2).abs() < 1e-15 && (x[1] - 10.0).abs() < 1e-15, "{x:?}");
        assert!((y[0][0] + 93.2).abs() < 1e-12 && (y[0][1] + 6.8).abs() < 1e-12, "{y:?}");
    }

    #[test]
    fn invariant_values_without_powers_of_ten_are_shown_about_zero() {
        let figure = Figure::plane("little", "t", "v").line("v", vec![0.0, 1.0], vec![0.0, 1e-310]);
        assert_eq!(limits(&figure).unwrap().1, [[-1.0, 1.0]]);
    }

    #[test]
    fn invariant_constant_value_lies_in_the_middle_of_its_axis() {
        let figure = Figure::time_series("rest", "t", "v").line("v", vec![0.0, 1.0], vec![5.0, 5.0 + 1e-15]);
        let (_, y) = limits(&figure).unwrap();
        assert!((y[0][0] - 4.5).abs() < 1e-9 && (y[0][1] - 5.5).abs() < 1e-9, "{y:?}");
    }
}
