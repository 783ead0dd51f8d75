//! Equations, and what is known of a scene, as `show` prints them.

use crate::{assert_wrong_use, json, output};

#[test]
fn invariant_show_text_holds_equations_sparsity_order_and_operations() {
    let show = output(&["show", "ezyroller/driven"]);
    let parts = [
        "degrees of freedom: 4 in position, 2 in velocity",
        "A = (seat.x - a*cos(seat.phi), seat.y - a*sin(seat.phi))",
        "C_q = [",
        "S v + s_t = [",
        "m0*cos(omega*t)",
        "sparsity",
        "front  ...   xxx",
        "order of elimination",
        "arithmetic in all",
        "Taylor series: 16 products of series",
    ];
    for part in parts {
        assert!(show.contains(part), "{part} in {show}");
    }
    let show = output(&["show", "singletrackcar/limit"]);
    assert!(show.contains("no Taylor series: a law calls `abs`"), "{show}");
}

#[test]
fn invariant_show_latex_of_a_model_holds_every_scene() {
    let show = output(&["show", "ezyroller", "--format", "latex"]);
    assert_eq!(show.matches("% equations of motion").count(), 6);
    assert!(show.contains("\\begin{bmatrix} M & C_q^T & S^T"), "{show}");
    assert!(show.contains("\\section*{EzyRoller/driven\\_on\\_tarmac}"), "{show}");
    for environment in ["tabular", "enumerate", "bmatrix", "aligned", "center"] {
        let count = |word: &str| show.matches(&format!("\\{word}{{{environment}}}")).count();
        assert!(count("begin") > 0 && count("begin") == count("end"), "{environment} in {show}");
    }
}

#[test]
fn invariant_show_json_counts_at_most_a_hundred_operations() {
    let operations = &json(&["show", "ezyroller/driven", "--format", "json"])["operations"]["accelerations"];
    let arithmetic: u64 = ["mul", "add", "div"].iter().map(|kind| operations[kind].as_u64().unwrap()).sum();
    assert!(arithmetic <= 100, "{arithmetic}");
}

#[test]
fn invariant_show_of_a_scene_with_counts_tells_its_equations_by_item() {
    let show = output(&["show", "chain/swing"]);
    for part in ["n         10", "hinge pin, i in 1..n", "link[i-1].x", "20 position constraints", "G = pin[i].x"] {
        assert!(show.contains(part), "{part} in {show}");
    }
}

#[test]
fn invariant_show_of_a_scene_with_counts_tells_its_solver() {
    // a chain of 10 rods fills nothing in
    let solver = "sparse solver: blocks of 2 x 2, 10 on the diagonal, 9 below it, 9 products of blocks";
    let show = output(&["show", "chain/swing"]);
    assert!(show.contains(solver), "{show}");
    let show = output(&["show", "chain/swing", "--set", "n=1000"]);
    assert!(show.contains("1000 on the diagonal, 999 below it, 999 products"), "{show}");
    let show = output(&["show", "hangingnet/swing", "--set", "rows=20", "--set", "columns=20"]);
    assert!(show.contains("sparse solver: factors of K, "), "{show}");
}

#[test]
fn invariant_show_refuses_parameters() {
    // equations hold for all of their values, and the table tells those of the model file
    assert_wrong_use(&["show", "chain/swing", "--set", "l=3"], "`l` is a parameter");
}
