//! The equations of a scene with counts, item by item.

use super::Page;
use super::mathml::{column, display, letter, lines, named_column, zero};
use super::tables::unit;
use crate::emit::templates::{indices, lengths, ranges};
use crate::mechanics::{RowTemplate, Templates};
use crate::model::{Loop, Model};
use crate::symbolic::SumId;
use crate::symbolic::print::print;

pub fn write(page: &mut Page, model: &Model, templates: &Templates<'_>) {
    let printer = Printer { model, templates };
    page.heading("Bodies");
    for (i, (array, masses)) in model.arrays.iter().zip(&templates.masses).enumerate() {
        page.paragraph(titled("body", &array.name.to_string(), &lengths(model, i)));
        let entries: Vec<String> = masses.iter().map(|&mass| printer.entry(mass)).collect();
        let diagonal = format!("<mi>diag</mi><mo>(</mo>{}<mo>)</mo>", entries.join("<mo>,</mo>"));
        page.paragraph(display(&[letter("M"), diagonal]));
    }
    if !templates.rows.is_empty() {
        page.heading("Rows");
        templates.rows.iter().for_each(|row| printer.row(page, row));
    }
    if !templates.forces.is_empty() {
        page.heading("Forces");
        for force in &templates.forces {
            page.paragraph(titled(force.force.word.word, "", &ranges(model, &force.force.loops)));
            page.paragraph(display(&[letter("F"), printer.by_coordinate(&force.entries)]));
            if !force.potential.is_zero() {
                page.paragraph(display(&[letter("V"), printer.entry(force.potential)]));
            }
        }
    }
    if !templates.points.is_empty() {
        page.heading("Points");
        for point in &templates.points {
            page.paragraph(titled("point", &point.point.name.to_string(), &ranges(model, &point.point.loops)));
            page.paragraph(display(&[column(point.position.map(|x| printer.entry(x)))]));
        }
    }
    if !templates.outputs.is_empty() {
        page.heading("Outputs");
        for output in &templates.outputs {
            let (name, suffix) = (&output.output.name, &output.output.suffix);
            let title = titled("output", &format!("{name}{suffix}"), &ranges(model, &output.output.loops));
            page.paragraph(format!("{title}, in {} {}", unit(&output.output.unit), output.output.documentation));
            page.paragraph(display(&[printer.entry(output.value)]));
        }
    }
}

/// hinge `pin`, i in 1..n
fn titled(word: &str, name: &str, ranges: &[String]) -> String {
    let name = if name.is_empty() { String::new() } else { format!(" `{name}`") };
    ranges.iter().fold(format!("{word}{name}"), |title, range| format!("{title}, `{range}`"))
}

struct Printer<'a> {
    model: &'a Model,
    templates: &'a Templates<'a>,
}

impl Printer<'_> {
    fn entry(&self, sum: SumId) -> String {
        print(&self.templates.algebra, &self.templates.symbols, sum).mathml
    }

    fn row(&self, page: &mut Page, template: &RowTemplate<'_>) {
        let (constraints, loops): (_, &[Loop]) = (&template.constraints, &template.row.loops);
        let stem = template.row.name.to_string();
        page.paragraph(titled(template.row.word.word, &stem, &ranges(self.model, loops)));
        let names = constraints.rows.iter().map(|row| {
            let suffix = row.name.strip_prefix(&stem).unwrap_or_default();
            format!("{stem}{}{suffix}", indices(self.model, loops))
        });
        let names: Vec<String> = names.collect();
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        let (symbols, values) = match template.is_position() {
            true => (["C", "h"], &constraints.position),
            false => (["S v", "s"], &constraints.velocity),
        };
        let entries: Vec<String> = values.iter().map(|&value| self.entry(value)).collect();
        page.paragraph(display(&[zero(), letter(symbols[0]), named_column(&entries, &names)]));
        let jacobian = constraints.jacobian.iter().zip(&names);
        let jacobian = jacobian.map(|(row, name)| vec![format!("<mtext>{name}</mtext>"), self.listed(row)]);
        page.paragraph(display(&[letter("G"), lines(jacobian)]));
        let convective = constraints.convective.iter().map(|&value| self.entry(value));
        page.paragraph(display(&[letter(symbols[1]), column(convective)]));
    }

    /// What is not zero, with its coordinate, in one line.
    fn listed(&self, entries: &[(usize, SumId)]) -> String {
        self.with_coordinates(entries).collect::<Vec<_>>().join("<mo>,</mo><mspace width=\"0.8em\"/>")
    }

    /// The same in lines.
    fn by_coordinate(&self, entries: &[(usize, SumId)]) -> String {
        lines(self.with_coordinates(entries).map(|entry| vec![entry]))
    }

    fn with_coordinates(&self, entries: &[(usize, SumId)]) -> impl Iterator<Item = String> {
        let coordinates = self.templates.symbols.coordinate_names();
        entries.iter().map(move |&(i, entry)| format!("{}<mo>:</mo>{}", coordinates[i].mathml, self.entry(entry)))
    }
}
