//! Curves with more points than a picture can show.

use super::canvas::Place;

/// Points of a column, which is narrower than the narrowest line.
const COLUMN: f64 = 0.3;

/// The curve without the points that cannot be seen: of successive points in one narrow column the first, the lowest, the highest
/// and the last stay, in their order. Extremes are kept, and no point that is left out is further than a column from the line.
pub(super) fn thinned(points: &[Place]) -> Vec<Place> {
    let mut kept = Vec::new();
    for column in points.chunk_by(|a, b| (a[0] / COLUMN).floor() == (b[0] / COLUMN).floor()) {
        let order = |i: &usize, j: &usize| column[*i][1].total_cmp(&column[*j][1]);
        let all = 0..column.len();
        let extremes = [all.clone().min_by(order), all.clone().max_by(order)];
        let mut places = vec![0, column.len() - 1];
        places.extend(extremes.into_iter().flatten());
        places.sort_unstable();
        places.dedup();
        kept.extend(places.into_iter().map(|i| column[i]));
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn invariant_thinned_curve_keeps_ends_and_the_extremes_of_each_column() {
        let wave = |i: usize| [i as f64 * 1e-3, 100.0 * (i as f64 * 0.37).sin()];
        let mut points: Vec<Place> = (0..300_000).map(wave).collect();
        points[123_456][1] = 250.0;
        let thin = thinned(&points);
        assert!(thin.len() <= 4 * 1001, "{}", thin.len());
        assert_eq!((thin[0], thin[thin.len() - 1]), (points[0], points[points.len() - 1]));
        assert!(thin.contains(&points[123_456]));
        let least = |points: &[Place]| points.iter().map(|p| p[1]).fold(f64::INFINITY, f64::min);
        assert_eq!(least(&thin), least(&points));
    }

    #[test]
    fn invariant_curve_with_few_points_stays_as_it_is() {
        let points = [[0.0, 1.0], [5.0, 2.0], [5.0, 3.0], [2.0, 0.0]];
        assert_eq!(thinned(&points), points);
    }
}
