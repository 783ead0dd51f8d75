//! The assembled constraints: C, G, the velocity constraints and the convective terms, all derived from C and S v.

use super::expression::Writer;
use super::rows::{ResidualKind, ScalarRow};
use super::symbols::Meaning;
use crate::symbolic::{SumId, Symbol};

/// The constraint equations of a scene, position constraints first.
#[derive(Debug)]
pub struct Constraints {
    pub rows: Vec<ScalarRow>,
    pub n_position_rows: usize,
    /// C, one for each position constraint.
    pub position: Vec<SumId>,
    /// C_q v + C_t, then S v + s_t.
    pub velocity: Vec<SumId>,
    /// g_t: C_t, then s_t; zero for rows that stand still.
    pub drift: Vec<SumId>,
    /// Rows of G as (column, entry), ascending, zeros left out.
    pub jacobian: Vec<Vec<(usize, SumId)>>,
    /// h, then s.
    pub convective: Vec<SumId>,
}

impl Constraints {
    pub fn derive(writer: &mut Writer<'_>, rows: Vec<ScalarRow>) -> Self {
        let (position_rows, velocity_rows): (Vec<_>, Vec<_>) =
            rows.into_iter().partition(|row| matches!(row.residual, ResidualKind::Position(_)));
        let n_position_rows = position_rows.len();
        let rows: Vec<ScalarRow> = position_rows.into_iter().chain(velocity_rows).collect();

        let (mut position, mut velocity, mut jacobian, mut convective) = (vec![], vec![], vec![], vec![]);
        let mut drift = vec![];
        for row in &rows {
            let residual = row.switched(writer.algebra);
            let rate = match residual {
                ResidualKind::Position(c) => {
                    position.push(c);
                    writer.time_derivative(c)
                }
                ResidualKind::Velocity(rate) => rate,
            };
            velocity.push(rate);
            drift.push(match residual {
                ResidualKind::Position(c) => writer.algebra.diff(c, Symbol::TIME),
                ResidualKind::Velocity(rate) => {
                    let is_velocity = |symbol| matches!(writer.symbols.meaning(symbol), Meaning::Velocity(_));
                    writer.algebra.at_zero(rate, &is_velocity)
                }
            });
            let velocities = writer.algebra.symbols_of(rate).into_iter();
            let velocities = velocities.filter_map(|symbol| Some((writer.symbols.velocity_of(symbol)?, symbol)));
            jacobian.push(
                velocities
                    .map(|(i, symbol)| (i, writer.algebra.diff(rate, symbol)))
                    .filter(|(_, entry)| !entry.is_zero())
                    .collect(),
            );
            // d/dt (G v + g_t) = G a + [h; s], so the convective term is the time derivative at constant velocities
            convective.push(writer.time_derivative(rate));
        }
        Self { rows, n_position_rows, position, velocity, drift, jacobian, convective }
    }

    /// Leaves out a position constraint.
    pub fn remove_position_row(&mut self, row: usize) {
        self.n_position_rows -= 1;
        self.rows.remove(row);
        self.jacobian.remove(row);
        for sums in [&mut self.position, &mut self.velocity, &mut self.drift, &mut self.convective] {
            sums.remove(row);
        }
    }
}
