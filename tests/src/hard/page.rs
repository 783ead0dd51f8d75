//! The tables of `docs/hard-cases.md`.

use super::case::{Case, Check, Findings};
use std::fmt::Write;

/// Characters of a message that are shown.
const LONGEST: usize = 240;

/// What the page says of a bound that is kept.
const KEPT: &str = "yes";

/// The cases of a family and what was found in each, as text.
pub fn table(found: &[(&Case, Findings)]) -> String {
    let mut text = String::new();
    let mut line = |line: String| {
        let _ = writeln!(text, "{line}");
    };
    for (case, _) in found {
        line(format!("- `{}`: {}.", case.name, case.why));
    }
    line("\n| case | what | bound | EZY | kept | how EZY ran | plain RK4 | how it ran |".to_owned());
    line("|---|---|---:|---:|---|---|---:|---|".to_owned());
    for (case, findings) in found {
        for (i, check) in findings.checks.iter().enumerate() {
            let naive_by = findings.naive_by.as_deref().unwrap_or_default();
            let (by, naive_by) = if i == 0 { (findings.by.as_str(), naive_by) } else { ("", "") };
            let (name, what, bound, reached) = (&case.name, &check.what, short(check.bound), short(check.reached));
            let (kept, naive) = (verdict(check), check.naive.map_or(String::new(), short));
            line(format!("| `{name}` | {what} | {bound} | {reached} | {kept} | {by} | {naive} | {naive_by} |"));
        }
    }
    let stopped = found.iter().filter_map(|(case, findings)| Some((case, findings.stopped.as_ref()?)));
    for (i, (case, why)) in stopped.enumerate() {
        let opening = if i == 0 { "\n" } else { "" };
        line(format!("{opening}- `{}` {}", case.name, beginning(why)));
    }
    text
}

/// Cases of a page that are no longer there.
pub fn gone(page: &str, cases: &[&Case]) -> Vec<String> {
    let mut gone: Vec<&str> =
        page.lines().filter_map(|line| Some(line.strip_prefix("| `")?.split_once("` |")?.0)).collect();
    gone.dedup();
    gone.retain(|name| !cases.iter().any(|case| case.name == *name));
    gone.iter().map(|name| format!("{name}: on the page, but no case")).collect()
}

/// Bounds that a page says are kept and that `found` misses, bounds that it does not know, and bounds of it that are gone. What is
/// made of times is the machine's, and left out.
pub fn broken(page: &str, found: &[(&Case, Findings)]) -> Vec<String> {
    let kept: Vec<Vec<&str>> = page.lines().map(|line| line.split('|').map(str::trim).collect()).collect();
    let says = |case: &Case, check: &Check| {
        let name = format!("`{}`", case.name);
        kept.iter().find(|cells| cells.len() > 5 && cells[1] == name && cells[2] == check.what).map(|cells| cells[5])
    };
    let mut broken = Vec::new();
    for (case, findings) in found {
        let name = format!("`{}`", case.name);
        for cells in kept.iter().filter(|cells| cells.len() > 5 && cells[1] == name) {
            if !findings.checks.iter().any(|check| check.what == cells[2]) {
                broken.push(format!("{}, {}: on the page, but not asked any more", case.name, cells[2]));
            }
        }
        for check in findings.checks.iter().filter(|check| !check.is_time) {
            let fault = match says(case, check) {
                None => "not on the page",
                Some(KEPT) if !check.is_met() => "kept on the page, missed now",
                Some(_) => continue,
            };
            broken.push(format!("{}, {}: {fault} ({})", case.name, check.what, short(check.reached)));
        }
    }
    broken
}

/// The beginning of a message that may list many rows.
fn beginning(why: &str) -> String {
    let mut text: String = why.chars().take(LONGEST).map(|c| if c == '\n' { ' ' } else { c }).collect();
    if why.chars().count() > LONGEST {
        text.push('…');
    }
    text
}

fn verdict(check: &Check) -> &'static str {
    if check.is_met() { KEPT } else { "**no**" }
}

fn short(x: f64) -> String {
    match x {
        x if x.is_nan() => "–".to_owned(),
        x if x == 0.0 || (1.0..1e5).contains(&x) => format!("{}", (x * 10.0).round() / 10.0),
        x => format!("{x:.1e}"),
    }
}
