//! Columns of motions as a figure: panels by unit, one line for each motion and column.

use std::path::Path;

use super::animate;
use super::failure::Failure;
use super::motion_table::MotionTable;
use super::out_path::ending;
use ezy_core::record::{Column, UnknownName};
use ezy_study::report::figure::Figure;
use ezy_study::report::page::Page;

/// What is drawn.
pub(super) struct Picture<'a> {
    pub title: &'a str,
    pub motions: &'a [MotionTable],
    /// Names of columns, or patterns.
    pub patterns: &'a [&'a String],
    /// The abscissa; time when there is none.
    pub against: Option<&'a str>,
}

impl Picture<'_> {
    /// Draws the figure into a file, whose ending says how.
    pub(super) fn write(&self, path: &Path) -> Result<(), Failure> {
        write(&self.figure()?, self.title, &self.alternative(), path)
    }

    /// What is seen, for those who do not see it.
    fn alternative(&self) -> String {
        let columns = self.patterns.iter().map(|pattern| pattern.as_str()).collect::<Vec<_>>().join(", ");
        format!("{columns} over {}", self.against.unwrap_or("time"))
    }

    fn figure(&self) -> Result<Figure, Failure> {
        let columns = self.columns()?;
        let mut units: Vec<&str> = Vec::new();
        for column in &columns {
            if !units.contains(&column.unit.as_str()) {
                units.push(&column.unit);
            }
        }
        let first = &self.motions[0];
        let abscissa = &first.columns[self.against.map_or(Ok(0), |name| first.index(name))?];
        let x_label = if self.against.is_none() { "time [s]".to_owned() } else { axis(&abscissa.name, &abscissa.unit) };
        let is_equal = self.against.is_some() && units == ["m"] && abscissa.unit == "m";
        let mut figure: Option<Figure> = None;
        for unit in &units {
            let here: Vec<&&Column> = columns.iter().filter(|column| column.unit == *unit).collect();
            let y_label = match here[..] {
                [column] => axis(&column.name, unit),
                _ => axis(quantity(unit), unit),
            };
            let mut panel = match figure {
                Some(figure) => figure.panel(&y_label),
                None if is_equal => Figure::equal(self.title, &x_label, &y_label),
                None if self.against.is_some() => Figure::plane(self.title, &x_label, &y_label),
                None => Figure::time_series(self.title, &x_label, &y_label),
            };
            let mut starts = Vec::new();
            for motion in self.motions {
                let x = &motion.values[motion.index(&abscissa.name)?];
                for column in &here {
                    let Ok(i) = motion.index(&column.name) else { continue };
                    let name = match (self.motions.len(), here.len()) {
                        (1, _) => column.name.clone(),
                        (_, 1) => motion.name.clone(),
                        _ => format!("{}, {}", column.name, motion.name),
                    };
                    panel = panel.line(&name, x.clone(), motion.values[i].clone());
                    starts.extend(x.first().copied().zip(motion.values[i].first().copied()));
                }
            }
            if self.against.is_some() {
                let (x, y) = starts.into_iter().unzip();
                panel = panel.hinges("start", x, y);
            }
            figure = Some(panel);
        }
        figure.ok_or_else(|| Failure::wrong_use("give one column or several"))
    }

    /// The columns that the patterns mean, each once. A column may be missing in some of the motions, not in all.
    fn columns(&self) -> Result<Vec<&Column>, UnknownName> {
        let mut columns: Vec<&Column> = Vec::new();
        for pattern in self.patterns {
            let found: Vec<_> =
                self.motions.iter().map(|motion| motion.select(pattern).map(|found| (motion, found))).collect();
            if let (true, Some(Err(unknown))) = (found.iter().all(Result::is_err), found.first()) {
                return Err(unknown.clone());
            }
            for (motion, places) in found.iter().flatten() {
                for &i in places {
                    if !columns.iter().any(|column| column.name == motion.columns[i].name) {
                        columns.push(&motion.columns[i]);
                    }
                }
            }
        }
        Ok(columns)
    }
}

/// Name and unit as they stand beside an axis.
pub(super) fn axis(name: &str, unit: &str) -> String {
    match unit {
        "" => name.to_owned(),
        _ => format!("{name} [{}]", typeset(unit)),
    }
}

/// `kg*m^2` as kg·m².
fn typeset(unit: &str) -> String {
    unit.replace('*', "·").replace("^2", "²").replace("^3", "³")
}

/// What columns of one unit are together.
pub(super) fn quantity(unit: &str) -> &'static str {
    match unit {
        "m" => "length",
        "rad" => "angle",
        "m/s" => "velocity",
        "rad/s" => "angular velocity",
        "m/s^2" => "acceleration",
        "rad/s^2" => "angular acceleration",
        "N" => "force",
        "N*m" => "torque",
        "J" => "energy",
        "W" => "power",
        _ => "value",
    }
}

/// Draws a figure into a file, whose ending says how.
pub(super) fn write(figure: &Figure, title: &str, alternative: &str, path: &Path) -> Result<(), Failure> {
    let bytes = match ending(path).as_deref() {
        Some("png") => figure.png().map_err(Failure::stopped)?,
        Some("html") => {
            let mut page = Page::new(title);
            page.figure(figure.picture().map_err(Failure::stopped)?, alternative, alternative, &[]);
            page.finish().into_bytes()
        }
        _ => figure.picture().map_err(Failure::stopped)?.wide.into_bytes(),
    };
    animate::write(path, bytes)
}
