//! A workspace as a figure: curves over one coordinate, a map over two.

use super::drawing_of_columns::axis;
use super::shown::Drawing;
use super::workspace_text::Reached;
use ezy_core::analysis::{AssemblyBranch, Limit};
use ezy_study::report::figure::Figure;

const SMALLEST: &str = "smallest singular value";

impl Reached<'_> {
    pub(super) fn drawn(&self) -> Drawing {
        let title = format!("{}: workspace", self.path);
        let names: Vec<&str> = self.workspace.axes.iter().map(|axis| &*axis.name).collect();
        let figure = if self.held.len() == 1 { self.curves(&title) } else { self.map(&title) };
        Drawing { figure, title, alternative: format!("{SMALLEST} over {}", names.join(" and ")) }
    }

    fn label(&self, i: usize) -> String {
        let coordinate = &self.info.coordinates[i];
        axis(&coordinate.name, coordinate.unit)
    }

    fn map(&self, title: &str) -> Figure {
        let [x, y] = [&self.workspace.axes[0], &self.workspace.axes[1]];
        let (n, m) = (x.values.len(), y.values.len());
        let z = self.workspace.branches.first().map_or(&[][..], |branch| &branch.smallest_singular_value);
        // the map's abscissa is fastest
        let z = (0..n * m).map(|k| z[(k % n) * m + k / n]).collect();
        let [x_label, y_label] = [self.label(self.held[0]), self.label(self.held[1])];
        Figure::map(title, &x_label, &y_label, SMALLEST, x.values.clone(), y.values.clone(), z)
    }

    /// The smallest singular value, and below it a coordinate; rings in singular positions.
    fn curves(&self, title: &str) -> Figure {
        let branches = &self.workspace.branches;
        let name = |i: usize| if branches.len() == 1 { String::new() } else { format!("branch {}", i + 1) };
        let mut figure = Figure::plane(title, &self.label(self.held[0]), SMALLEST);
        for (i, branch) in branches.iter().enumerate() {
            let (x, y) = self.curve(branch, |_| 0.0, |branch, i, _| branch.smallest_singular_value[i]);
            figure = figure.line(&name(i), x, y);
        }
        let singular = |of: &dyn Fn(&[f64]) -> f64| -> (Vec<f64>, Vec<f64>) {
            self.workspace.singular.iter().map(|singular| (singular.value, of(&singular.q))).unzip()
        };
        let (x, y) = singular(&|_| 0.0);
        figure = figure.hinges(if x.is_empty() { "" } else { "singular" }, x, y).panel(&self.label(self.of));
        for (i, branch) in branches.iter().enumerate() {
            let (x, y) = self.curve(branch, |q| q[self.of], |_, _, q| q[self.of]);
            figure = figure.line(&name(i), x, y);
        }
        let (x, y) = singular(&|q| q[self.of]);
        figure.hinges("", x, y)
    }

    /// A value over a branch, from dead centre to dead centre.
    fn curve(
        &self,
        branch: &AssemblyBranch,
        at_dead_centre: impl Fn(&[f64]) -> f64,
        of: impl Fn(&AssemblyBranch, usize, &[f64]) -> f64,
    ) -> (Vec<f64>, Vec<f64>) {
        let places = branch.positions.iter().enumerate();
        let inner = places.filter_map(|(i, q)| Some((self.place(i)[0], of(branch, i, q.as_ref()?))));
        let end = |k: usize| {
            let end = branch.ends.as_ref().map(|ends| &ends[k]);
            end.filter(|end| end.limit == Limit::DeadCentre).map(|end| (end.value, at_dead_centre(&end.q)))
        };
        end(0).into_iter().chain(inner).chain(end(1)).unzip()
    }
}
