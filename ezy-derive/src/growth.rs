//! How the work of the macro grows with the model.

mod long_run;
mod texts;

use proc_macro2::TokenTree;

use crate::emit::LONGEST_WHOLE;
use crate::work;
use texts::Shape;

/// What a text costs.
struct Cost {
    /// Steps of work.
    work: usize,
    /// Length of the emitted text.
    signs: usize,
    /// Temporaries of all kernels.
    temporaries: usize,
}

impl Cost {
    fn of(shape: Shape, n: usize) -> Self {
        let tokens = shape.text(n).parse().expect("the text consists of tokens");
        let before = work::steps();
        let items = crate::pipeline::expand(tokens);
        let work = work::steps() - before;
        let text = items.to_string();
        assert!(!text.contains("compile_error"), "{text}");
        Self { work, signs: text.len(), temporaries: text.matches("let ").count() }
    }
}

/// Twice the bodies may take so many times the steps. Linear growth is 2, less what a model has once; a body in many rows
/// has sums of many terms, whose common factors are found in steps that grow faster.
const MOST_GROWTH: [(Shape, f64); 3] = [(Shape::Chain, 2.2), (Shape::Hub, 2.6), (Shape::Casters, 2.8)];

/// The hub and the cart are in so many rows that there is no elimination.
#[test]
fn order_work_is_linear_in_the_number_of_bodies() {
    for (shape, most) in MOST_GROWTH {
        let [small, large] = [24, 48].map(|n| Cost::of(shape, n));
        let ratio = large.work as f64 / small.work as f64;
        assert!(ratio <= most, "{shape:?}: {} steps for 24, {} for 48", small.work, large.work);
        assert!(small.signs < large.signs && small.temporaries < large.temporaries);
    }
}

/// The limit of `docs/decisions/041-no-elimination-of-wide-hubs.md`. A loop has two rows on the hub, a caster two on the cart.
#[test]
fn analytic_elimination_is_written_up_to_24_rows_of_a_body() {
    for (shape, n, is_written) in
        [(Shape::Hub, 12, true), (Shape::Hub, 13, false), (Shape::Casters, 12, true), (Shape::Casters, 13, false)]
    {
        let tokens = shape.text(n).parse().expect("the text consists of tokens");
        let text = crate::pipeline::expand(tokens).to_string();
        assert_eq!(text.contains("fn accelerations"), is_written, "{shape:?}: {} rows", 2 * n);
    }
}

/// The vectors that a kernel opens.
const VECTORS: usize = 15;

/// rustc overflows its stack on some 3,000 `let` in one function.
#[test]
fn invariant_no_function_of_a_large_model_is_long() {
    let tokens = Shape::Chain.text(60).parse().expect("the text consists of tokens");
    let mut open = vec![crate::pipeline::expand(tokens)];
    let mut n_temporaries = 0;
    while let Some(stream) = open.pop() {
        let trees: Vec<_> = stream.into_iter().collect();
        let is_let = |tree: &&TokenTree| matches!(tree, TokenTree::Ident(ident) if ident == "let");
        let lets = trees.iter().filter(is_let).count();
        assert!(lets <= LONGEST_WHOLE + VECTORS, "{lets} temporaries in one block");
        n_temporaries += lets;
        open.extend(trees.into_iter().filter_map(|tree| match tree {
            TokenTree::Group(group) => Some(group.stream()),
            _ => None,
        }));
    }
    assert!(n_temporaries > 10 * LONGEST_WHOLE, "{n_temporaries} temporaries in all");
}
