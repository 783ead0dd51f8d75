//! Models of many bodies, each written out, in a dev build with debug information.

use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

const N_BODIES: usize = 200;
const N_CASTERS: usize = 40;

/// A chain twice: rod by rod, with a generated elimination, and with a count, solved by the sparse solver. Positions are of
/// order 100 m, errors of both runs of order 1e-9. And a cart on casters, each written out and with a count: the sparse
/// solver does the same for both, so that they differ by rounding.
fn program() -> String {
    let mut rods = String::new();
    for i in 0..N_BODIES {
        let place = if i == 0 { "ground(0, 0)".to_owned() } else { format!("b{}(l/2, 0)", i - 1) };
        let _ = writeln!(rods, "body b{i} {{ mass: m, inertia: m*l^2/12 }} hinge h{i}: {place} ~ b{i}(-l/2, 0);");
    }
    let shared = "param l: m = 1.0; param m: kg = 1.0; gravity (0, -9.81); start level { at rest; }
        scene swing { start level; until 0.1 s; }";
    let cart = "param l: m = 0.1; param r: m = 0.5; body cart { mass: 10, inertia: 5 } torque cart: 1;
        force at cart(0, 0): (2, 0); start rest { at rest; } scene run { start rest; until 0.5 s; }";
    let mut casters = String::new();
    for i in 0..N_CASTERS {
        let _ = writeln!(
            casters,
            "body a{i} {{ mass: 1, inertia: 0.1 }} hinge p{i}: cart(0.1*{i}, r) ~ a{i}(l, 0);
            skate s{i}: at a{i}(-l, 0) along a{i}(1, 0);"
        );
    }
    format!(
        "use ezy_core::prelude::*;
        mod written {{ use ezy_core::prelude::*; model! {{ pub model Chain {{ {shared} {rods} }} }}
            model! {{ pub model Cart {{ {cart} {casters} }} }} }}
        mod counted {{ use ezy_core::prelude::*; model! {{ pub model Chain {{ {shared}
            count n = {N_BODIES};
            body b[n] {{ mass: m, inertia: m*l^2/12 }}
            hinge h0: ground(0, 0) ~ b[0](-l/2, 0);
            for i in 1..n {{ hinge h[i]: b[i-1](l/2, 0) ~ b[i](-l/2, 0); }}
        }} }}
        model! {{ pub model Cart {{ {cart}
            count n = {N_CASTERS};
            body a[n] {{ mass: 1, inertia: 0.1 }}
            for i in 0..n {{
                hinge p[i]: cart(0.1*i, r) ~ a[i](l, 0);
                skate s[i]: at a[i](-l, 0) along a[i](1, 0);
            }}
        }} }} }}
        fn apart(written: &dyn Scene, counted: &dyn Scene, method: Method) -> f64 {{
            let last = |scene: &dyn Scene| {{
                let run = Simulation::new(scene).method(method).run().expect(\"the run ends\");
                run.last().coordinates.to_vec()
            }};
            let (written, counted) = (last(written), last(counted));
            assert_eq!(written.len(), counted.len());
            written.iter().zip(&counted).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
        }}
        fn main() {{
            assert!(written::chain::Swing::INFO.has_elimination());
            let (chain, counted_chain) = (written::chain::Swing::default(), counted::chain::Swing::default());
            let of_chain = apart(&chain, &counted_chain, Method::dop853(1e-10));
            assert!(of_chain < 1e-7, \"{{of_chain}} m\");
            // so many rows of the cart that there is no elimination
            assert!(!written::cart::Run::INFO.has_elimination());
            let (cart, counted_cart) = (written::cart::Run::default(), counted::cart::Run::default());
            for method in [Method::dop853(1e-9), Method::taylor(1e-9), Method::radau(1e-9)] {{
                let of_cart = apart(&cart, &counted_cart, method);
                assert!(of_cart < 1e-12, \"{{of_cart}} m\");
            }}
        }}
        "
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
