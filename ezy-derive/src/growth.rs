//! How the work of the macro grows with the model.

mod long_run;
mod texts;

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

/// Twice the bodies may take so many times the work: a tenth more than twice, for what each model has once.
const LINEAR: f64 = 2.2;

#[test]
fn order_work_of_a_chain_is_linear() {
    check_growth(Shape::Chain, 24);
}

fn check_growth(shape: Shape, n: usize) {
    let [small, large] = [n, 2 * n].map(|n| Cost::of(shape, n));
    let ratio = large.work as f64 / small.work as f64;
    assert!(ratio <= LINEAR, "{shape:?}: {} steps for {n}, {} for {}", small.work, large.work, 2 * n);
    assert!(small.signs < large.signs && small.temporaries < large.temporaries);
}
