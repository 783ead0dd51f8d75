//! Machine instructions of a program, counted by valgrind.

use std::error::Error;
use std::process::Command;

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
