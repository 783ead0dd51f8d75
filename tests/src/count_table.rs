//! Machine instructions: counted by valgrind, kept in a page of the documentation, compared with counts made anew.

use std::error::Error;
use std::fmt;
use std::process::Command;

/// Counts may differ by this part: the start of a program varies by a few instructions.
const BAND: f64 = 0.01;

/// Rows of counts under named columns, and where they were counted.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CountTable {
    surroundings: String,
    columns: Vec<String>,
    rows: Vec<(String, Vec<Option<u64>>)>,
}

impl CountTable {
    /// A table without rows.
    pub fn new(surroundings: String, columns: &[&str]) -> Self {
        Self { surroundings, columns: columns.iter().map(|&column| column.to_owned()).collect(), rows: Vec::new() }
    }

    /// Adds a row; `None` where there is nothing to count.
    pub fn push(&mut self, label: &str, counts: Vec<Option<u64>>) {
        self.rows.push((label.to_owned(), counts));
    }

    /// Reads what [`fmt::Display`] wrote.
    pub fn read(text: &str) -> Option<Self> {
        let (table, below) = text.split_once("\n\n")?;
        let surroundings = below.trim().strip_prefix("Counted with ")?.strip_suffix('.')?.to_owned();
        let cells = |line: &str| -> Vec<String> {
            line.trim_matches('|').split('|').map(|cell| cell.trim().to_owned()).collect()
        };
        let mut lines = table.lines();
        let columns = cells(lines.next()?).split_off(1);
        let rows = lines.skip(1).map(|line| {
            let mut cells = cells(line);
            let counts = cells.split_off(1).iter().map(|cell| cell.parse().ok()).collect();
            (cells.remove(0), counts)
        });
        Some(Self { surroundings, columns, rows: rows.collect() })
    }

    /// What to say of these counts beside recorded ones.
    ///
    /// # Errors
    /// The counts that differ by more than a hundredth, when both were counted in the same surroundings.
    pub fn compare(&self, recorded: &Self) -> Result<String, String> {
        if self.surroundings != recorded.surroundings {
            let (now, then) = (&self.surroundings, &recorded.surroundings);
            return Ok(format!("not compared: counted with {now}, recorded with {then}"));
        }
        if (&self.columns, self.rows.len()) != (&recorded.columns, recorded.rows.len()) {
            return Err("the recorded table has other columns or rows".to_owned());
        }
        let mut different = String::new();
        for ((label, counts), (recorded_label, recorded)) in self.rows.iter().zip(&recorded.rows) {
            for ((column, now), then) in self.columns.iter().zip(counts).zip(recorded) {
                if label != recorded_label || !is_near(*now, *then) {
                    different += &format!("{label}, {column}: {} recorded, {} counted\n", cell(*then), cell(*now));
                }
            }
        }
        if different.is_empty() { Ok("as recorded".to_owned()) } else { Err(different) }
    }
}

fn is_near(now: Option<u64>, then: Option<u64>) -> bool {
    match (now, then) {
        (Some(now), Some(then)) => now.abs_diff(then) as f64 <= BAND * then as f64,
        (now, then) => now == then,
    }
}

fn cell(count: Option<u64>) -> String {
    count.map_or_else(|| "–".to_owned(), |count| count.to_string())
}

impl fmt::Display for CountTable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "| scene | {} |", self.columns.join(" | "))?;
        writeln!(f, "|---{}|", "|---:".repeat(self.columns.len()))?;
        for (label, counts) in &self.rows {
            let counts: Vec<String> = counts.iter().map(|count| cell(*count)).collect();
            writeln!(f, "| {label} | {} |", counts.join(" | "))?;
        }
        writeln!(f, "\nCounted with {}.", self.surroundings)
    }
}

/// What instruction counts depend on besides the code: compiler, C library and processor.
pub fn surroundings() -> String {
    let first_line = |program: &str, argument: &str| {
        let output = Command::new(program).arg(argument).output().ok()?;
        String::from_utf8(output.stdout).ok()?.lines().next().map(str::to_owned)
    };
    let compiler = first_line("rustc", "--version").unwrap_or_else(|| "an unknown compiler".to_owned());
    let library = first_line("ldd", "--version").and_then(|line| Some(line.split_whitespace().next_back()?.to_owned()));
    let library = library.unwrap_or_else(|| "unknown".to_owned());
    let built = if cfg!(target_feature = "avx2") { "built for AVX2" } else { "no flags" };
    format!("{compiler}, C library {library}, {}, {built}", processor())
}

/// The C library chooses its sine by this.
#[cfg(target_arch = "x86_64")]
fn processor() -> &'static str {
    if std::arch::is_x86_feature_detected!("fma") { "x86-64 with FMA" } else { "x86-64 without FMA" }
}

#[cfg(not(target_arch = "x86_64"))]
fn processor() -> &'static str {
    std::env::consts::ARCH
}

/// Whether valgrind is installed.
pub fn is_installed() -> bool {
    Command::new("valgrind").arg("--version").output().is_ok()
}

/// Instructions of a run of the present program with these arguments.
///
/// # Errors
/// When valgrind cannot be started, or with what it answered instead of a count.
pub fn instructions(arguments: &[String]) -> Result<u64, Box<dyn Error>> {
    let output = Command::new("valgrind")
        .args(["--tool=cachegrind", "--cache-sim=no", "--cachegrind-out-file=/dev/null"])
        .arg(std::env::current_exe()?)
        .args(arguments)
        .output()?;
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    let line = text.lines().find(|line| line.contains("I refs") || line.contains("I   refs:"));
    let digits = line.and_then(|line| line.rsplit_once(':')).map(|(_, number)| number.replace([',', ' '], ""));
    digits.and_then(|digits| digits.parse().ok()).ok_or_else(|| format!("valgrind answered:\n{text}").into())
}
