//! Tells the study which compiler and which libraries it was made with.

use std::process::Command;

/// Libraries whose versions can change a digit or a picture.
const LIBRARIES: [&str; 3] = ["nalgebra", "faer", "ruviz"];

fn main() {
    println!("cargo::rerun-if-changed=../Cargo.lock");
    let rustc = std::env::var("RUSTC").unwrap_or_else(|_| "rustc".to_owned());
    let answer = Command::new(rustc).arg("--version").output();
    let compiler =
        answer.map_or_else(|_| "rustc".to_owned(), |out| String::from_utf8_lossy(&out.stdout).trim().to_owned());
    println!("cargo::rustc-env=EZY_COMPILER={compiler}");
    let lock = std::fs::read_to_string("../Cargo.lock").unwrap_or_default();
    let versions: Vec<String> = LIBRARIES.iter().filter_map(|name| locked(&lock, name)).collect();
    println!("cargo::rustc-env=EZY_LIBRARIES={}", versions.join(", "));
}

/// `name version` as the lock file has it.
fn locked(lock: &str, name: &str) -> Option<String> {
    let (_, entry) = lock.split_once(&format!("name = \"{name}\"\nversion = \""))?;
    Some(format!("{name} {}", entry.split('"').next()?))
}
