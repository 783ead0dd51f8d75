//! A model of 200 bodies, each written out, in a dev build with debug information.

use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

const N_BODIES: usize = 200;

/// The same chain twice: rod by rod, with a generated elimination, and with a count, solved by the sparse solver. Both
/// fall for a tenth of a second; positions are of order 100 m, errors of both runs of order 1e-9.
fn program() -> String {
    let mut rods = String::new();
    for i in 0..N_BODIES {
        let place = if i == 0 { "ground(0, 0)".to_owned() } else { format!("b{}(l/2, 0)", i - 1) };
        let _ = writeln!(rods, "body b{i} {{ mass: m, inertia: m*l^2/12 }} hinge h{i}: {place} ~ b{i}(-l/2, 0);");
    }
    let shared = "param l: m = 1.0; param m: kg = 1.0; gravity (0, -9.81); start level { at rest; }
        scene swing { start level; until 0.1 s; }";
    format!(
        "use ezy_core::prelude::*;
        mod written {{ use ezy_core::prelude::*; model! {{ pub model Chain {{ {shared} {rods} }} }} }}
        mod counted {{ use ezy_core::prelude::*; model! {{ pub model Chain {{ {shared}
            count n = {N_BODIES};
            body b[n] {{ mass: m, inertia: m*l^2/12 }}
            hinge h0: ground(0, 0) ~ b[0](-l/2, 0);
            for i in 1..n {{ hinge h[i]: b[i-1](l/2, 0) ~ b[i](-l/2, 0); }}
        }} }} }}
        fn last(scene: &dyn Scene) -> Vec<f64> {{
            let run = Simulation::new(scene).method(Method::dop853(1e-10)).run().expect(\"the chain falls\");
            run.last().coordinates.to_vec()
        }}
        fn main() {{
            assert!(written::chain::Swing::INFO.has_elimination());
            let (written, counted) =
                (last(&written::chain::Swing::default()), last(&counted::chain::Swing::default()));
            assert_eq!(written.len(), {n_q});
            let apart = written.iter().zip(&counted).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(apart < 1e-7, \"{{apart}} m\");
        }}
        ",
        n_q = 3 * N_BODIES
    )
}

/// rustc 1.95 overflows its stack on such a model where a kernel is one function.
#[test]
#[ignore = "builds ezy-core and a large program: a few minutes"]
fn cross_many_bodies_compile_with_debug_information_and_move_like_counted_ones() {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let root = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("many_bodies");
    fs::create_dir_all(root.join("src")).expect("the folder can be made");
    fs::copy(here.join("../Cargo.lock"), root.join("Cargo.lock")).expect("the lock file can be copied");
    let core = here.join("../ezy-core");
    let manifest = format!(
        "[workspace]\n[package]\nname = \"many-bodies\"\nedition = \"2024\"\n\
         [dependencies]\nezy-core = {{ path = {core:?} }}\n[profile.dev]\ndebug = \"full\"\n"
    );
    fs::write(root.join("Cargo.toml"), manifest).expect("the manifest can be written");
    fs::write(root.join("src/main.rs"), program()).expect("the program can be written");
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let run = Command::new(cargo).args(["run", "--quiet"]).current_dir(&root).output().expect("cargo runs");
    assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
}
