//! Tells the crate how far it is optimised: a debug build may optimise it all the same.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    let level = std::env::var("OPT_LEVEL").unwrap_or_else(|_| "unknown".to_owned());
    println!("cargo::rustc-env=EZY_OPT_LEVEL={level}");
}
