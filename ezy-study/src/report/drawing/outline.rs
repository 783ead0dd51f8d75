//! Shapes of bodies: what spans their points.

use super::elements::Vector;
use super::number;

/// Closed path at the distance `r` around the convex hull of some points.
pub(super) fn rounded_hull(points: &[Vector], r: f64) -> String {
    let hull = convex_hull(points);
    let [first, ..] = hull[..] else { return String::new() };
    if hull.len() == 1 {
        let [x, y] = first;
        let (left, right, y, r) = (number(x - r), number(x + r), number(y), number(r));
        return format!("M{left} {y}A{r} {r} 0 1 1 {right} {y}A{r} {r} 0 1 1 {left} {y}Z");
    }
    let mut path = String::new();
    for (i, &a) in hull.iter().enumerate() {
        let b = hull[(i + 1) % hull.len()];
        let length = (b[0] - a[0]).hypot(b[1] - a[1]);
        // to the right of the edge, which is outside
        let out = [(b[1] - a[1]) / length * r, (a[0] - b[0]) / length * r];
        let [from, to] = [a, b].map(|p| format!("{} {}", number(p[0] + out[0]), number(p[1] + out[1])));
        let radius = number(r);
        path += &if i == 0 { format!("M{from}") } else { format!("A{radius} {radius} 0 0 1 {from}") };
        path += &format!("L{to}");
        if i + 1 == hull.len() {
            let c = hull[1 % hull.len()];
            let a = hull[0];
            let length = (c[0] - a[0]).hypot(c[1] - a[1]);
            let out = [(c[1] - a[1]) / length * r, (a[0] - c[0]) / length * r];
            path += &format!("A{radius} {radius} 0 0 1 {} {}Z", number(a[0] + out[0]), number(a[1] + out[1]));
        }
    }
    path
}

/// Corners of the convex hull, by Andrew's monotone chain; two for points on a line.
fn convex_hull(points: &[Vector]) -> Vec<Vector> {
    let mut sorted = points.to_vec();
    sorted.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    sorted.dedup();
    if sorted.len() < 3 {
        return sorted;
    }
    let half = |points: &mut dyn Iterator<Item = Vector>| {
        let mut chain: Vec<Vector> = Vec::new();
        for p in points {
            while let [.., a, b] = chain[..] {
                if (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) > 0.0 {
                    break;
                }
                chain.pop();
            }
            chain.push(p);
        }
        chain.pop();
        chain
    };
    let mut hull = half(&mut sorted.iter().copied());
    hull.extend(half(&mut sorted.iter().rev().copied()));
    hull
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_hull_leaves_out_what_is_inside_or_on_an_edge() {
        let square = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [1.0, 1.0], [1.0, 0.0]];
        assert_eq!(convex_hull(&square), [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]]);
        assert_eq!(convex_hull(&[[3.0, 3.0], [1.0, 1.0], [2.0, 2.0]]), [[1.0, 1.0], [3.0, 3.0]]);
    }

    #[test]
    fn analytic_outline_of_two_points_is_a_bar_with_round_ends() {
        let bar = rounded_hull(&[[0.0, 0.0], [10.0, 0.0]], 2.0);
        assert_eq!(bar, "M0 -2L10 -2A2 2 0 0 1 10 2L0 2A2 2 0 0 1 0 -2Z");
    }
}
