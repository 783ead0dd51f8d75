//! `input steer: rad = 0 by acceleration;`: an input that a run integrates. Besides its value there are the inputs `steer_rate`,
//! `steer_acceleration`, which is to be set, and `steer_since`, the time of value and rate.

use proc_macro2::Ident;

use super::ast::{Expr, Item, ItemKind, Parameter, Part, Unit, UnitFactor};

/// The three inputs that follow that of the value; none of another item.
pub fn parts(item: &Item) -> Vec<Item> {
    let ItemKind::Input(value) = &item.kind else { return Vec::new() };
    if value.part.is_none() {
        return Vec::new();
    }
    let name = &value.name;
    let over_time = |exponent: i32| {
        let unit = value.unit.as_ref()?;
        let second = UnitFactor { name: Ident::new("s", name.span()), exponent: -exponent };
        let power = if exponent == 1 { String::new() } else { format!("^{exponent}") };
        let factors = unit.factors.iter().cloned().chain([second]).collect();
        Some(Unit { text: format!("{}/s{power}", unit.text), factors })
    };
    let time = UnitFactor { name: Ident::new("s", name.span()), exponent: 1 };
    let seconds = Some(Unit { text: "s".to_owned(), factors: vec![time] });
    let parts = [
        (Part::Rate, "rate", over_time(1), format!("Rate of `{name}`, which a run integrates.")),
        (
            Part::Acceleration,
            "acceleration",
            over_time(2),
            format!("Acceleration of `{name}`, to be set; held over a step."),
        ),
        (Part::Since, "since", seconds, format!("Time of `{name}` and `{name}_rate`, which a run sets.")),
    ];
    let parts = parts.into_iter().map(|(part, word, unit, documentation)| {
        let name = Ident::new(&format!("{name}_{word}"), name.span());
        let zero = Expr::Number { value: 0.0, span: name.span() };
        let input = Parameter { name, unit, value: zero, value_text: "0".to_owned(), part: Some(part), rate: None };
        Item { documentation, loops: item.loops.clone(), kind: ItemKind::Input(input) }
    });
    parts.collect()
}
