//! Hard cases with their bounds, what EZY reaches, and what a plain program does.
//!
//! `cargo run --release -p ezy-tests --example hard_cases` runs all of them, a few minutes, and prints the tables; with
//! `-- --write` they go into `docs/hard-cases.md`, with `-- --check` it fails where a bound that the page says is kept is missed, but for bounds on times.
//! A further word runs only the cases whose name holds it.

use ezy_tests::hard::families::families;
use ezy_tests::hard::page::{broken, table};
use ezy_tests::page::{docs, write_part};
use std::error::Error;
use std::time::Instant;

const PAGE: &str = "hard-cases.md";

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let asks = |word: &str| arguments.iter().any(|argument| argument == word);
    let filter = arguments.iter().find(|argument| !argument.starts_with("--"));
    if filter.is_some() && asks("--write") {
        return Err("`--write` takes all cases; leave the name out".into());
    }
    let page = if asks("--check") { std::fs::read_to_string(docs(PAGE))? } else { String::new() };
    let mut different = Vec::new();
    for family in families() {
        let cases = family.cases.iter().filter(|case| filter.is_none_or(|word| case.name.contains(word)));
        let found: Vec<_> = cases
            .map(|case| {
                let clock = Instant::now();
                let findings = (case.examine)(!asks("--check"));
                eprintln!("{}: {:.1} s", case.name, clock.elapsed().as_secs_f64());
                (case, findings)
            })
            .collect();
        if found.is_empty() {
            continue;
        }
        let text = table(&found);
        println!("\n{text}");
        if asks("--write") {
            write_part(PAGE, family.name, &text)?;
        }
        if asks("--check") {
            different.extend(broken(&page, &found));
        }
    }
    if different.is_empty() { Ok(()) } else { Err(different.join("\n").into()) }
}
