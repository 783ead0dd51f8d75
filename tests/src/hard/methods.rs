//! Every hard case by every method at three tolerances: `docs/hard-cases-methods.md`.

use super::case::{By, Case, Check, Ended, Findings, How, METHODS, Purpose};
use crate::garage::worse;
use std::collections::BTreeSet;
use std::fmt::Write;

/// From coarse to fine.
pub const TOLERANCES: [f64; 3] = [1e-6, 1e-9, 1e-12];

/// Errors at the end of a run in its tolerances: some hundred steps, each with an error of about one.
const OF_TOLERANCE: f64 = 1e3;

/// Where a motion makes errors larger than that, the median over the methods with a tolerance, at 1e-6 and 1e-9, says how much; a method may be
/// this many times worse.
const OF_MEDIAN: f64 = 30.0;

/// RK4 has no tolerance; three digits are right.
const OF_RK4: f64 = 1e-3;

/// Cases whose runs took this much processor time together when the page was written are run again by `--check`, s.
const QUICK_S: f64 = 1.0;

/// What came of one run, from worst to best.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Verdict {
    /// It ended, with an error that its tolerance does not explain.
    Off,
    /// It stopped, or ended as not to be trusted.
    Refused,
    /// Its steps reached the limit.
    Cut,
    /// Within its tolerance, or what RK4 is right to.
    Right,
    /// All bounds of the case are kept.
    Kept,
}

/// One run.
#[derive(Debug, Clone)]
pub struct Cell {
    verdict: Verdict,
    /// As on the page.
    text: String,
}

/// A case by every method.
pub struct Row<'c> {
    case: &'c Case,
    /// By method and tolerance.
    cells: Vec<Vec<Cell>>,
    seconds: f64,
}

/// Runs a case by every method; none where they do not all run.
pub fn examine(case: &Case) -> Option<Row<'_>> {
    if case.by != By::Methods {
        return None;
    }
    let began = processor_s();
    let mut found = Vec::new();
    for (name, method) in METHODS {
        for tolerance in TOLERANCES {
            let findings = (case.examine)(How { method, tolerance, purpose: Purpose::Matrix });
            if let Some(why) = &findings.stopped {
                eprintln!("{}, {name} {tolerance:.0e}: {why}", case.name);
            }
            found.push((method.map(|_| tolerance), findings));
        }
    }
    let growth = growth(&found);
    let cells = found.chunks(TOLERANCES.len()).map(|of_method| {
        let cell = |(tolerance, findings): &(Option<f64>, Findings)| {
            let allowed = tolerance.map_or(OF_RK4, |tolerance| OF_TOLERANCE.max(OF_MEDIAN * growth) * tolerance);
            cell(findings, allowed, tolerance.is_none())
        };
        of_method.iter().map(cell).collect()
    });
    let cells = cells.collect();
    Some(Row { case, cells, seconds: processor_s() - began })
}

/// Median of error over tolerance, of methods with a tolerance that is not at the edge of rounding.
fn growth(found: &[(Option<f64>, Findings)]) -> f64 {
    let finest = TOLERANCES[TOLERANCES.len() - 1];
    let of = |(tolerance, findings): &(Option<f64>, Findings)| {
        let tolerance = tolerance.filter(|tolerance| *tolerance > finest)?;
        (findings.ended == Some(Ended::Reached)).then(|| error(findings) / tolerance)
    };
    let mut ratios: Vec<f64> = found.iter().filter_map(of).collect();
    ratios.sort_by(f64::total_cmp);
    ratios.get(ratios.len() / 2).copied().unwrap_or(0.0)
}

/// The largest error that depends on the tolerance.
fn error(findings: &Findings) -> f64 {
    let checks = findings.checks.iter().filter(|check| !check.is_time && !check.is_for_all);
    checks.map(|check| check.reached).fold(0.0, worse)
}

/// `allowed` is an error that the tolerance explains. Samples between fixed steps are interpolated and not projected, so that gaps are
/// errors like others.
fn cell(findings: &Findings, allowed: f64, is_fixed: bool) -> Cell {
    let checks = || findings.checks.iter().filter(|check| !check.is_time);
    let error = error(findings);
    let is_right = |check: &Check| check.is_met() || (is_fixed || !check.is_for_all) && check.reached <= allowed;
    let of_all =
        checks().filter(|check| check.is_for_all && !check.is_met()).map(|check| check.reached).fold(0.0, worse);
    let verdict = match findings.ended {
        _ if checks().all(|check| check.is_met()) => Verdict::Kept,
        Some(Ended::Cut) => Verdict::Cut,
        Some(Ended::Refused(_)) => Verdict::Refused,
        _ if checks().all(is_right) => Verdict::Right,
        _ => Verdict::Off,
    };
    let steps = findings.steps;
    let text = match (verdict, findings.ended) {
        (Verdict::Kept, Some(Ended::Refused(why))) => format!("kept: {why}"),
        (Verdict::Kept, _) => format!("kept: {error:.0e}, {steps}"),
        (Verdict::Right, _) => format!("{error:.0e}, {steps}"),
        (Verdict::Cut, _) => format!("cut after {steps}"),
        (_, Some(Ended::Refused(why))) => format!("refused: {why}"),
        _ if of_all > 0.0 => format!("**off: {error:.0e}, of a bound for all {of_all:.0e}**, {steps}"),
        _ => format!("**off: {error:.0e}**, {steps}"),
    };
    Cell { verdict, text }
}

/// The table, and what it counts.
pub fn table(rows: &[Row<'_>]) -> String {
    let mut text = String::from(
        "| method | runs | bounds kept | within the tolerance | cut | refused | off |\n|---|---:|---:|---:|---:|---:|---:|\n",
    );
    for (k, (name, _)) in METHODS.iter().enumerate() {
        for (i, tolerance) in TOLERANCES.iter().enumerate() {
            let n = |verdict: Verdict| rows.iter().filter(|row| row.cells[k][i].verdict == verdict).count();
            let [kept, right, cut, refused, off] =
                [Verdict::Kept, Verdict::Right, Verdict::Cut, Verdict::Refused, Verdict::Off].map(n);
            let _ = writeln!(
                text,
                "| {name} {tolerance:.0e} | {} | {kept} | {right} | {cut} | {refused} | {off} |",
                rows.len()
            );
        }
    }
    let _ = writeln!(text, "\n{}\n|---|---:|---|{}", head(), "---|".repeat(TOLERANCES.len()));
    for row in rows {
        for (k, (name, _)) in METHODS.iter().enumerate() {
            let seconds = if k == 0 { format!("{:.1}", row.seconds) } else { String::new() };
            let cells: Vec<&str> = row.cells[k].iter().map(|cell| cell.text.as_str()).collect();
            let _ = writeln!(text, "| `{}` | {seconds} | {name} | {} |", row.case.name, cells.join(" | "));
        }
    }
    text
}

/// A line of the page.
pub struct Line<'p> {
    /// Its name.
    pub case: &'p str,
    /// Processor time, where it was measured.
    pub seconds: Option<f64>,
    /// Its name.
    pub method: &'p str,
    /// What came of it at each tolerance.
    pub cells: Vec<&'p str>,
}

/// The lines that a page has.
pub fn lines(page: &str) -> impl Iterator<Item = Line<'_>> {
    page.lines().filter_map(|line| {
        let mut cells = line.strip_prefix("| `")?.trim_end_matches('|').split('|').map(str::trim);
        let case = cells.next()?.strip_suffix('`')?;
        let (seconds, method) = (cells.next()?.parse().ok(), cells.next()?);
        Some(Line { case, seconds, method, cells: cells.collect() })
    })
}

/// Whether the page says that a case is quick.
pub fn is_quick(page: &str, case: &Case) -> bool {
    lines(page).any(|line| line.case == case.name && line.seconds.is_some_and(|seconds| seconds <= QUICK_S))
}

/// The columns of the table.
fn head() -> String {
    let heads: Vec<String> = TOLERANCES.iter().map(|tolerance| format!("{tolerance:.0e}")).collect();
    format!("| case | time, s | method | {} |", heads.join(" | "))
}

/// Cases, methods and tolerances that only the page has, or only the program; and what `found` has lost.
pub fn broken(page: &str, cases: &[&Case], found: &[Row<'_>]) -> Vec<String> {
    let mut broken = Vec::new();
    let cases = cases.iter().filter(|case| case.by == By::Methods);
    let named: BTreeSet<(&str, &str)> =
        cases.flat_map(|case| METHODS.map(|(method, _)| (case.name.as_str(), method))).collect();
    let listed: BTreeSet<(&str, &str)> = lines(page).map(|line| (line.case, line.method)).collect();
    for (case, method) in listed.difference(&named) {
        broken.push(format!("{case}, {method}: on the page of methods, but not run"));
    }
    for (case, method) in named.difference(&listed) {
        broken.push(format!("{case}, {method}: not on the page of methods"));
    }
    if !page.lines().any(|line| line == head()) {
        broken.push(format!("the page of methods has no table with the columns {}", head()));
    }
    for line in lines(page).filter(|line| line.cells.len() != TOLERANCES.len()) {
        broken.push(format!("{}, {}: not at every tolerance on the page of methods", line.case, line.method));
    }
    for row in found {
        for ((name, _), cells) in METHODS.iter().zip(&row.cells) {
            let line = lines(page).find(|line| line.case == row.case.name && line.method == *name);
            let said = line.map(|line| line.cells).unwrap_or_default();
            for ((said, cell), tolerance) in said.iter().zip(cells).zip(TOLERANCES) {
                if cell.verdict < verdict_of(said) {
                    broken
                        .push(format!("{}, {name} {tolerance:.0e}: {}; on the page {said}", row.case.name, cell.text));
                }
            }
        }
    }
    broken
}

fn verdict_of(text: &str) -> Verdict {
    match text {
        text if text.starts_with("kept") => Verdict::Kept,
        text if text.starts_with("**off") => Verdict::Off,
        text if text.starts_with("refused") => Verdict::Refused,
        text if text.starts_with("cut") => Verdict::Cut,
        _ => Verdict::Right,
    }
}

/// Processor time of this program, s; where the system does not tell, time since some moment.
fn processor_s() -> f64 {
    let told = std::fs::read_to_string("/proc/self/schedstat").ok();
    let told = told.and_then(|text| text.split_whitespace().next()?.parse::<f64>().ok());
    told.map_or_else(
        || std::time::UNIX_EPOCH.elapsed().map_or(0.0, |elapsed| elapsed.as_secs_f64()),
        |nanoseconds| 1e-9 * nanoseconds,
    )
}
