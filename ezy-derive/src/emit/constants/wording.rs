//! Constants in words of what they are computed from: `m_over_l`.

/// A name, and what it is read as.
pub struct Wording {
    pub text: String,
    pub shape: Shape,
}

#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Shape {
    Product,
    Quotient,
    Sum,
}

/// None where the order of the parts is not plain.
pub fn sum(x: &Wording, y: &Wording, negative: [bool; 2]) -> Option<Wording> {
    if x.shape == Shape::Sum || y.shape == Shape::Sum {
        return None;
    }
    let text = match negative {
        [false, false] => format!("{}_plus_{}", x.text, y.text),
        [false, true] => format!("{}_minus_{}", x.text, y.text),
        [true, false] => format!("{}_minus_{}", y.text, x.text),
        [true, true] => return None,
    };
    Some(Wording { text, shape: Shape::Sum })
}

pub fn square(x: &Wording) -> Option<Wording> {
    (x.shape == Shape::Product).then(|| Wording { text: format!("{}_squared", x.text), shape: Shape::Product })
}

pub fn product(x: &Wording, y: &Wording) -> Option<Wording> {
    let (text, shape) = match (x.shape, y.shape) {
        (Shape::Product, Shape::Product) => (format!("{}_{}", x.text, y.text), Shape::Product),
        (Shape::Product, Shape::Quotient) => (over(&x.text, &y.text), Shape::Quotient),
        (Shape::Quotient, Shape::Product) => (over(&y.text, &x.text), Shape::Quotient),
        _ => return None,
    };
    Some(Wording { text, shape })
}

pub fn quotient(x: &Wording, y: &Wording) -> Option<Wording> {
    let of_products = x.shape == Shape::Product && y.shape == Shape::Product;
    of_products.then(|| Wording { text: format!("{}_over_{}", x.text, y.text), shape: Shape::Quotient })
}

/// A factor before a quotient, within its numerator.
fn over(factor: &str, quotient: &str) -> String {
    match quotient.strip_prefix("one_over_") {
        Some(divisor) => format!("{factor}_over_{divisor}"),
        None => format!("{factor}_{quotient}"),
    }
}
