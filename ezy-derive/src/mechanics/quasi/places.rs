//! Coordinates that position constraints give from others.

use crate::mechanics::scene::Equations;
use crate::symbolic::coefficient::Coefficient;
use crate::symbolic::sum::SumId;
use std::ops::Range;

/// A coordinate, and its value where the row holds that gives it.
pub type Given = (usize, SumId);

/// What position constraints give of the coordinates `own` of a body, each from those of bodies before it, from its own that no row gives, and from those before it here.
/// `None` where they do not: each has to be linear in a coordinate of its own, with a factor that depends on parameters alone.
pub fn given(equations: &mut Equations, own: Range<usize>, rows: &[usize]) -> Option<Vec<Given>> {
    let rows: Vec<usize> = rows.iter().copied().filter(|&row| row < equations.constraints.n_position_rows).collect();
    in_some_order(equations, own, &rows)
}

fn in_some_order(equations: &mut Equations, own: Range<usize>, rows: &[usize]) -> Option<Vec<Given>> {
    // the last one may read what the others give, and they do not read what it gives
    let Some(n) = rows.len().checked_sub(1) else { return Some(Vec::new()) };
    for last in 0..=n {
        let row = rows[last];
        let others: Vec<usize> = rows.iter().copied().filter(|&other| other != row).collect();
        for i in own.clone() {
            let symbol = equations.symbols.coordinate_at(i);
            let residual = equations.constraints.position[row];
            let Equations { algebra, constraints, .. } = &mut *equations;
            let slope = algebra.diff(residual, symbol);
            let is_read = others.iter().any(|&other| algebra.symbols_of(constraints.position[other]).contains(&symbol));
            let Some(slope) = algebra.as_coefficient(slope).filter(|slope| !slope.is_zero() && !is_read) else {
                continue;
            };
            let inverse = algebra.coefficients.div(Coefficient::ONE, slope);
            let (before, change) = (algebra.symbol(symbol), algebra.scale(residual, inverse));
            let value = algebra.sub(before, change);
            if let Some(mut given) = in_some_order(equations, own.clone(), &others) {
                given.push((i, value));
                return Some(given);
            }
        }
    }
    None
}
