//! The EzyRoller study: equations, both runs, long runs, and what they say about the report that they grew from.
//!
//! Everything that the page states is measured while it is written.

pub mod averaged;
mod claims;
mod coast;
pub mod command;
mod driven;
mod equations_part;
mod error;
mod findings;
mod growth;
mod motion;
mod output;
pub mod parts;
mod projection;
mod slips;
mod steps;
pub mod straight;

use std::path::{Path, PathBuf};
use std::sync::LazyLock;
use std::sync::atomic::AtomicBool;

use ezy_study::report::page::Page;
use ezy_study::report::table::Table;

use crate::ezy_roller::Driven;
use findings::Findings;
use output::Output;

pub use error::StudyError;

/// A study that is done.
#[derive(Debug)]
pub struct Study {
    /// The page.
    pub page: PathBuf,
    /// Key numbers, one a line.
    pub summary: Table,
}

/// Parts that are told to `progress`.
const PARTS: [&str; 5] = ["coasting", "driven", "smaller and smaller steps", "long runs", "page"];

static DRIVEN: LazyLock<Driven> = LazyLock::new(Driven::default);

/// Runs everything and writes page, figures and numbers into `directory`; calls `progress` with the fraction done
/// and the part that comes next. Once `interrupt` is true it ends with a page of the parts that are done.
///
/// # Errors
/// [`StudyError`] when a run stops, a file cannot be written, or the study is interrupted.
pub fn study(
    directory: &Path,
    interrupt: &AtomicBool,
    mut progress: impl FnMut(f64, &str),
) -> Result<Study, StudyError> {
    let mut tell = |part: usize| progress(part as f64 / PARTS.len() as f64, PARTS[part]);
    let output = Output::new(directory)?;
    let mut page = Page::new("The EzyRoller: equations, motion and energy");
    let summary = write_parts(&mut page, &output, interrupt, &mut tell);
    if let Err(StudyError::Interrupted { .. }) = summary {
        page.section("interrupted", "Interrupted");
        page.paragraph("The study was interrupted here. The parts that follow are missing, and their files are those of an earlier study.");
    }
    write_versions(&mut page);
    match summary {
        Ok(summary) => Ok(Study { page: output.write("index.html", &page.finish())?, summary }),
        Err(StudyError::Interrupted { .. }) => {
            Err(StudyError::Interrupted { page: Some(output.write("index.html", &page.finish())?) })
        }
        Err(error) => Err(error),
    }
}

/// Writes each part as soon as it is measured, and returns the key numbers.
fn write_parts(
    page: &mut Page,
    output: &Output,
    interrupt: &AtomicBool,
    tell: &mut dyn FnMut(usize),
) -> Result<Table, StudyError> {
    let driven = &*DRIVEN;
    tell(0);
    let projections = projection::Projections::measure()?;
    equations_part::write(page, output, driven)?;
    projections.write(page);
    let coasting = coast::Coasting::study(page, output, interrupt)?;
    let straight = straight::Straight::study(page, output, interrupt)?;
    tell(1);
    let drive = driven::Drive::measure(driven, interrupt)?;
    drive.write(page, output)?;
    tell(2);
    let steps = steps::Steps::measure(driven, interrupt)?;
    steps.write_work(page, output, &drive)?;
    tell(3);
    let growth = growth::Growth::measure(driven, interrupt)?;
    growth.write(page, output)?;
    steps.write_order(page, output)?;
    let found = Findings {
        projections: &projections,
        coasting: &coasting,
        straight: &straight,
        drive: &drive,
        steps: &steps,
        growth: &growth,
    };
    tell(4);
    claims::write(page, &found, driven)?;
    Ok(summary(&found))
}

fn write_versions(page: &mut Page) {
    page.section("versions", "Versions");
    let build = if cfg!(debug_assertions) { "debug" } else { "release" };
    let table = Table::new(["what", "version"])
        .row(["EZY", env!("CARGO_PKG_VERSION")])
        .row(["compiler", env!("EZY_COMPILER")])
        .row(["libraries", env!("EZY_LIBRARIES")])
        .row(["build", &format!("{build}, {} {}", std::env::consts::ARCH, std::env::consts::OS)]);
    page.html(&table.html("What made this page"));
    page.paragraph("The command ezy study makes it again.");
}

fn summary(found: &Findings<'_>) -> Table {
    let Findings { projections, coasting, straight, drive, steps, growth } = found;
    let [driven_order, coast_order] = steps.orders();
    let last_exponent = growth.exponents.last().map_or(f64::NAN, |e| e.2);
    Table::new(["measured", "value"])
        .row([
            "coasting, start: bar.vx, bar.omega".to_owned(),
            format!("{:.6} m/s, {:.6} rad/s", coasting.start_of("bar.vx"), coasting.start_of("bar.omega")),
        ])
        .row([
            "coasting, 1 s: heading, kinetic energy".to_owned(),
            format!("{:.9} rad, {:.6} J", coasting.end_heading, coasting.kinetic_energy),
        ])
        .row([
            "straight on at 1 m/s, bar ahead: growth of a small angle".to_owned(),
            format!("{:.4} 1/s in a run, {:.6} 1/s by the eigenvalue", straight.measured, straight.expected),
        ])
        .row([
            "driven, 60 s: speed, kinetic energy".to_owned(),
            format!("{:.9} m/s, {:.9} J", drive.end_speed, drive.end_energy),
        ])
        .row(["driven: |kinetic energy - work| at most".to_owned(), format!("{:.1e} J", drive.energy_gap)])
        .row([
            "driven: constraint residuals at most".to_owned(),
            format!("{:.0e} m, {:.0e} m/s", drive.residuals[0], drive.residuals[1]),
        ])
        .row([
            "right-endpoint sum of work: gap, order".to_owned(),
            format!("{:.3e} J at h = {} s, {:.3}", steps.sum_gap[0], steps.steps[0], steps.sum_order()),
        ])
        .row(["order of the method: driven, coasting".to_owned(), format!("{driven_order:.3}, {coast_order:.3}")])
        .row([
            "projection: |C| before, after".to_owned(),
            format!("{:.1e} m, {:.0e} m", projections.position_before, projections.mass.position_residual),
        ])
        .row([
            "driven, 600 s: speed, kinetic energy".to_owned(),
            format!("{:.4} m/s, {:.3} J", growth.speed, growth.energy),
        ])
        .row([
            "driven, long: last exponent of the energy".to_owned(),
            format!("{last_exponent:.2} (no level, limit law 0.40)"),
        ])
}
