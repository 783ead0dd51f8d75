//! Tells the study which compiler and which libraries it was made with.

use std::path::Path;
use std::process::Command;

/// Libraries whose versions can change a digit or a picture.
const LIBRARIES: [&str; 3] = ["nalgebra", "faer", "tiny-skia"];

/// The lock file of the workspace, and the one inside a package, with what the study says of versions from there.
const LOCK_FILES: [(&str, &str); 2] = [("../Cargo.lock", ""), ("Cargo.lock", " (as packaged)")];

fn main() {
    let (path, remark) = LOCK_FILES.into_iter().find(|(path, _)| Path::new(path).exists()).unwrap_or_default();
    // a path that is not there would build the package anew each time
    if !path.is_empty() {
        println!("cargo::rerun-if-changed={path}");
    }
    let rustc = std::env::var("RUSTC").unwrap_or_else(|_| "rustc".to_owned());
    let answer = Command::new(rustc).arg("--version").output();
    let compiler =
        answer.map_or_else(|_| "rustc".to_owned(), |out| String::from_utf8_lossy(&out.stdout).trim().to_owned());
    println!("cargo::rustc-env=EZY_COMPILER={compiler}");
    let lock = std::fs::read_to_string(path).unwrap_or_default();
    let versions: Vec<String> = LIBRARIES.iter().filter_map(|name| locked(&lock, name)).collect();
    println!("cargo::rustc-env=EZY_LIBRARIES={}{remark}", versions.join(", "));
}

/// `name version` as the lock file has it.
fn locked(lock: &str, name: &str) -> Option<String> {
    let (_, entry) = lock.split_once(&format!("name = \"{name}\"\nversion = \""))?;
    Some(format!("{name} {}", entry.split('"').next()?))
}
