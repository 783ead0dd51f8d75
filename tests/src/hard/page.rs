//! The tables of `docs/hard-cases.md`: every case at the tolerance of its reference, by every method.

use super::case::{By, Case, Check, Ended, Findings, How, METHODS, Pace, Purpose, WithTolerance};
use ezy_core::prelude::Tolerance;
use std::collections::BTreeSet;
use std::fmt::Write;

/// Characters of a message that are shown.
const LONGEST: usize = 240;

/// What the page says of a bound that all methods keep that were asked.
const ALL: &str = "all";
/// What it says of one that no method keeps.
const NONE: &str = "**none**";
/// What it says of one that needs no method, and is kept.
const KEPT: &str = "yes, ";
/// Of a bound that goes with the steps that a method takes.
const OF_STEPS: &str = "by its steps";

/// A case with what each method found, in the order of [`METHODS`]; of a case without methods one.
pub type Found<'c> = (&'c Case, Vec<Findings>);

/// The columns of a table.
fn head() -> String {
    let methods: Vec<&str> = METHODS.iter().map(|(name, _)| *name).collect();
    format!("| case | what | bound | {} | kept by | plain RK4 | how it ran |", methods.join(" | "))
}

/// A row of a table, before it is text: a quantity, and what each method made of it.
struct Quantity<'f> {
    what: &'f str,
    /// In the order of the methods; none where a method was not asked.
    checks: Vec<Option<&'f Check>>,
}

/// The quantities of a case, in the order in which the methods name them.
fn quantities(found: &[Findings]) -> Vec<Quantity<'_>> {
    let mut names: Vec<&str> = Vec::new();
    for check in found.iter().flat_map(|findings| &findings.checks) {
        if !names.contains(&check.what.as_str()) {
            names.push(&check.what);
        }
    }
    let of = |what: &str| found.iter().map(|f| f.checks.iter().find(|check| check.what == what)).collect();
    names.into_iter().map(|what| Quantity { what, checks: of(what) }).collect()
}

impl Quantity<'_> {
    fn bound(&self) -> String {
        let bounds: BTreeSet<String> = self.checks.iter().flatten().map(|check| short(check.bound)).collect();
        if bounds.len() > 1 { OF_STEPS.to_owned() } else { bounds.into_iter().next().unwrap_or_default() }
    }

    /// By which methods it is kept.
    fn kept_by(&self, case: &Case) -> String {
        let asked = || self.checks.iter().zip(METHODS).filter_map(|(check, (name, _))| Some((check.as_ref()?, name)));
        if case.by == By::Nothing {
            let of = |check: &Check| {
                let (verdict, reached) = (if check.is_met() { KEPT } else { "**no**, " }, short(check.reached));
                format!("{verdict}{reached}")
            };
            return self.checks.iter().flatten().map(|check| of(check)).collect();
        }
        let kept: Vec<&str> = asked().filter(|(check, _)| check.is_met()).map(|(_, name)| name).collect();
        match kept.len() {
            0 => NONE.to_owned(),
            n if n == asked().count() => ALL.to_owned(),
            _ => kept.join(", "),
        }
    }
}

/// The cases of a family and what was found in each, as text; `reasons` are what [`reasons`] says of the misses.
pub fn table(found: &[Found<'_>], reasons: &[String]) -> String {
    let mut text = String::new();
    let mut line = |line: String| {
        let _ = writeln!(text, "{line}");
    };
    for (case, _) in found {
        let at = if case.by == By::Nothing { String::new() } else { format!(", at {:.0e}", case.tolerance) };
        line(format!("- `{}`{at}: {}.", case.name, case.why));
    }
    line(format!("\n{}", head()));
    line(format!("|---|---|---:|{}---|---:|---|", "---:|".repeat(METHODS.len())));
    for (case, found) in found {
        let naive_by = found.iter().find_map(|findings| findings.naive_by.as_deref()).unwrap_or_default();
        for (i, quantity) in quantities(found).iter().enumerate() {
            let cells: Vec<String> = (0..METHODS.len())
                .map(|k| match (quantity.checks.get(k).copied().flatten(), case.by) {
                    (Some(check), By::Methods | By::Only(_)) => cell(check, &found[k], i == 0),
                    _ => String::new(),
                })
                .collect();
            let (name, what, bound, kept) = (&case.name, quantity.what, quantity.bound(), quantity.kept_by(case));
            let naive = quantity.checks.iter().flatten().find_map(|check| check.naive).map_or(String::new(), short);
            let naive_by = if i == 0 { naive_by } else { "" };
            line(format!("| `{name}` | {what} | {bound} | {} | {kept} | {naive} | {naive_by} |", cells.join(" | ")));
        }
    }
    for (i, reason) in reasons.iter().enumerate() {
        line(format!("{}{reason}", if i == 0 { "\n" } else { "" }));
    }
    text
}

fn cell(check: &Check, findings: &Findings, with_steps: bool) -> String {
    let reached = match findings.ended {
        Some(Ended::Cut) if !check.is_met() => return format!("cut after {}", findings.steps),
        Some(Ended::Refused(why)) if !check.is_met() => return format!("refused: {why}"),
        _ => short(check.reached),
    };
    let reached = if check.is_met() { reached } else { format!("**{reached}**") };
    if with_steps { format!("{reached}; {} steps", findings.steps) } else { reached }
}

/// Why methods miss bounds of a case: by how much, and from which tolerance on they keep them; or what they say.
pub fn reasons(case: &Case, found: &[Findings]) -> Vec<String> {
    let mut reasons = Vec::new();
    if case.by == By::Nothing {
        return reasons;
    }
    for ((name, method), findings) in METHODS.iter().zip(found) {
        let missed: Vec<&Check> = findings.checks.iter().filter(|check| !check.is_time && !check.is_met()).collect();
        let why = match (&findings.stopped, method) {
            _ if missed.is_empty() || findings.ended == Some(Ended::Cut) => continue,
            (Some(why), _) => beginning(why),
            // the steps are the plain program's
            (None, None) => continue,
            (None, Some(method)) => kept_from(case, *method, &missed),
        };
        reasons.push(format!("- `{}`, {name}: {why}", case.name));
    }
    reasons
}

/// By how much bounds are missed, and from which tolerance on a method keeps them.
fn kept_from(case: &Case, method: WithTolerance, missed: &[&Check]) -> String {
    let mut from = vec![format!("not kept down to {:.0e}", Tolerance::SMALLEST_RELATIVE); missed.len()];
    let mut open: Vec<usize> = (0..missed.len()).collect();
    // as it is written: 1e-11, not a tenth of 1e-10
    let tighter = |k: i32| format!("{:.0e}", case.tolerance * 0.1_f64.powi(k)).parse::<f64>().expect("a number");
    for tolerance in (1..).map(tighter).take_while(|tolerance| *tolerance >= Tolerance::SMALLEST_RELATIVE) {
        let findings = (case.examine)(How { method: Some(method), tolerance, purpose: Purpose::Page });
        if findings.ended == Some(Ended::Cut) {
            open.iter()
                .for_each(|&i| from[i] = format!("not kept before the steps reach the limit, at {tolerance:.0e}"));
            break;
        }
        let is_kept = |i: &usize| findings.checks.iter().any(|check| check.what == missed[*i].what && check.is_met());
        open.iter().filter(|i| is_kept(i)).for_each(|&i| {
            from[i] = format!("kept from {tolerance:.0e} on ({} steps)", findings.steps);
        });
        open.retain(|i| !is_kept(i));
        if open.is_empty() {
            break;
        }
    }
    let of = |(check, from): (&&Check, &String)| {
        let ratio = check.reached / check.bound;
        let ratio = if ratio < 10.0 { format!("{ratio:.2}") } else { short(ratio) };
        format!("{}: {ratio} times the bound, {from}", check.what)
    };
    missed.iter().zip(&from).map(of).collect::<Vec<_>>().join("; ")
}

/// The rows of a page as cells.
fn rows(page: &str) -> impl Iterator<Item = Vec<&str>> {
    let rows = page.lines().filter(|line| line.starts_with("| `"));
    rows.map(|line| line.trim_matches('|').split('|').map(str::trim).collect())
}

/// Columns of a row.
const NAME: usize = 0;
const WHAT: usize = 1;
const BOUND: usize = 2;
const FIRST_METHOD: usize = 3;
const KEPT_BY: usize = FIRST_METHOD + METHODS.len();

/// What a page and the cases do not share: cases that are on one of them alone, and tables without the columns of all methods.
pub fn gone(page: &str, cases: &[&Case], n_tables: usize) -> Vec<String> {
    let listed: BTreeSet<&str> = log(page).map(|row| row[NAME].trim_matches('`')).collect();
    let named: BTreeSet<&str> = cases.iter().map(|case| case.name.as_str()).collect();
    let mut gone: Vec<String> =
        listed.difference(&named).map(|name| format!("{name}: on the page, but no case")).collect();
    gone.extend(named.difference(&listed).map(|name| format!("{name}: a case that is not on the page")));
    let (head, n) = (head(), page.lines().filter(|line| line.starts_with("| case |")).count());
    let n_right = page.lines().filter(|line| **line == *head).count();
    if (n, n_right) != (n_tables, n_tables) {
        gone.push(format!(
            "{n_right} of {n} tables have the columns of the methods, of {n_tables} that there should be"
        ));
    }
    gone
}

/// Rows of the log: the table by symptom has fewer columns.
fn log(page: &str) -> impl Iterator<Item = Vec<&str>> {
    rows(page).filter(|row| row.len() > KEPT_BY)
}

/// Bounds that a page says a method keeps and that `found` misses; bounds and quantities that are only on the page, or only
/// found. What is made of times is the machine's, and left out.
pub fn broken(page: &str, found: &[Found<'_>]) -> Vec<String> {
    let mut broken = Vec::new();
    for (case, found) in found {
        let name = format!("`{}`", case.name);
        let said: Vec<Vec<&str>> = log(page).filter(|row| row[NAME] == name).collect();
        let asked = quantities(found);
        let listed: BTreeSet<(String, String)> =
            said.iter().map(|row| (row[WHAT].to_owned(), row[BOUND].to_owned())).collect();
        let measured: BTreeSet<(String, String)> = asked.iter().map(|q| (q.what.to_owned(), q.bound())).collect();
        for (what, bound) in listed.difference(&measured) {
            broken.push(format!("{}, {what}, {bound}: on the page, but not asked any more", case.name));
        }
        for (what, bound) in measured.difference(&listed) {
            broken.push(format!("{}, {what}, {bound}: not on the page", case.name));
        }
        for (k, (name, _)) in METHODS.iter().enumerate().take(if case.by == By::Nothing { 1 } else { METHODS.len() }) {
            broken.extend(lost(page, case, k, &found[k]));
            let is_run = |row: &Vec<&str>| found[k].checks.iter().any(|check| check.what == row[WHAT]);
            for row in said.iter().filter(|row| !row[FIRST_METHOD + k].is_empty() && !is_run(row)) {
                broken.push(format!("{}, {}, {name}: on the page, but not run", case.name, row[WHAT]));
            }
        }
    }
    broken
}

/// Bounds that a page says method `k` keeps and that `findings` miss.
pub fn lost(page: &str, case: &Case, k: usize, findings: &Findings) -> Vec<String> {
    let (name, method) = (format!("`{}`", case.name), METHODS[k].0);
    let missed = findings.checks.iter().filter(|check| !check.is_time && !check.is_met());
    let was_kept = |check: &&Check| {
        let mut rows = log(page).filter(|row| row[NAME] == name && row[WHAT] == check.what);
        let kept = rows.next().map_or("", |row| row[KEPT_BY]);
        kept == ALL || kept.starts_with(KEPT) || kept.split(", ").any(|kept| kept == method)
    };
    let lost = missed.filter(was_kept);
    let text = |check: &Check| {
        let why = findings.stopped.as_deref().unwrap_or_default();
        format!("{}, {}, {method}: kept on the page, now {:.1e} {why}", case.name, check.what, check.reached)
    };
    lost.map(text).collect()
}

/// Whether `--check` runs a case.
pub fn is_checked(case: &Case, with_long: bool) -> bool {
    with_long || case.pace < Pace::Long
}

/// The beginning of a message that may list many rows.
fn beginning(why: &str) -> String {
    let mut text: String = why.chars().take(LONGEST).map(|c| if c == '\n' { ' ' } else { c }).collect();
    if why.chars().count() > LONGEST {
        text.push('…');
    }
    text
}

fn short(x: f64) -> String {
    match x {
        x if x.is_nan() => "–".to_owned(),
        x if x == 0.0 || (1.0..1e5).contains(&x) => format!("{}", (x * 10.0).round() / 10.0),
        x => format!("{x:.1e}"),
    }
}
