//! The six machines of the guide: their examples, each against a second route.

mod belt;
mod pantograph;
mod segway;
mod skid_steer;
mod trailer;

use ezy_core::testing::check_model;
use std::fs;
use std::path::Path;

/// The programs of the examples, without their `main`.
#[allow(dead_code)]
#[path = "../../examples"]
mod examples {
    pub mod belt;
    pub mod pantograph;
    pub mod segway;
    pub mod skid_steer;
    pub mod trailer;
    pub mod tricycle;
}

const MACHINES: [&str; 6] = ["tricycle", "skid_steer", "pantograph", "segway", "trailer", "belt"];

#[test]
fn fd_machines_pass_their_checks() {
    let models = [
        &examples::tricycle::tricycle::MODEL,
        &examples::skid_steer::skid_steer::MODEL,
        &examples::pantograph::pantograph::MODEL,
        &examples::segway::segway::MODEL,
        &examples::trailer::trailer::MODEL,
        &examples::belt::belt::MODEL,
    ];
    for model in models {
        check_model(model).unwrap_or_else(|error| panic!("{error}"));
    }
}

/// Lines that are neither empty nor comments.
fn count<'l>(lines: impl Iterator<Item = &'l str>) -> usize {
    lines.map(str::trim).filter(|line| !line.is_empty() && !line.starts_with("//")).count()
}

/// The longest model that the guide shows as a small one.
const MOST_LINES: usize = 40;

#[test]
fn invariant_table_of_the_guide_counts_the_lines() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let page = fs::read_to_string(root.join("../docs/guide/src/machines.md")).unwrap();
    for machine in MACHINES {
        let program = fs::read_to_string(root.join("examples").join(machine).with_extension("rs")).unwrap();
        let model = program.lines().skip_while(|line| !line.contains("pub model")).take_while(|line| *line != "}");
        // without the bracket of the model, as from its name to its last item
        let n_model = count(model) - 1;
        let row = format!(
            "| [{machine}.rs](../../../models/examples/{machine}.rs) | {n_model} | {} |",
            count(program.lines())
        );
        assert!(page.contains(&row), "the page needs `{row}`");
        assert!(n_model <= MOST_LINES, "{machine}: {n_model}");
    }
}
