//! The linear algebra of the rules against plain sums, and what the rules say of small models.

use super::basis::{Basis, Row, largest};
use super::{DEPENDENT, RandomState, fraction, scale_columns};
use crate::diag::Diagnostics;
use crate::function::Function;
use crate::mechanics::symbols::Meaning;
use crate::mechanics::{Derived, Equations, Templates};
use crate::model::{InputId, Model};
use crate::random::Random;
use crate::symbolic::Symbol;
use crate::symbolic::evaluate::Point;
use crate::{model, parse};

/// Some tens of operations on numbers of one, with pivots down to 1e-3.
const ROUNDING: f64 = 1e-10;

const N_COLUMNS: usize = 9;

/// A row with about half of its columns.
fn random_row(random: &mut Random) -> Row {
    let columns: Vec<usize> = (0..N_COLUMNS).filter(|_| random.once_in(2)).collect();
    columns.into_iter().chain([N_COLUMNS - 1]).map(|column| (column, random.between(-2.0, 2.0))).collect()
}

fn combined(rows: &[Row], factors: &[(usize, f64)]) -> Row {
    let mut sum = Row::new();
    for &(place, factor) in factors {
        rows[place].iter().for_each(|(&column, x)| *sum.entry(column).or_insert(0.0) += factor * x);
    }
    sum
}

fn distance(a: &Row, b: &Row) -> f64 {
    let at = |row: &Row, column| row.get(&column).copied().unwrap_or(0.0);
    (0..N_COLUMNS).map(|column| f64::abs(at(a, column) - at(b, column))).fold(0.0, f64::max)
}

#[test]
fn analytic_rows_that_others_combine_are_found_with_their_factors() {
    for seed in 0..60 {
        let mut random = Random::new(seed);
        let n = 1 + random.below(6);
        let rows: Vec<Row> = (0..n).map(|_| random_row(&mut random)).collect();
        let mut basis = Basis::default();
        for row in &rows {
            let reduced = basis.reduce(row.clone());
            assert!(reduced.size() > 1e-3 * DEPENDENT, "{seed}: random rows are independent");
            basis.push(reduced);
        }
        let factors: Vec<(usize, f64)> = (0..n).map(|place| (place, random.between(-3.0, 3.0))).collect();
        let sum = combined(&rows, &factors);
        let reduced = basis.reduce(sum.clone());
        assert!(reduced.size() <= ROUNDING, "{seed}: {}", reduced.size());
        let found = basis.combination(&reduced);
        assert!(distance(&combined(&rows, &found), &sum) <= ROUNDING, "{seed}: {found:?} {factors:?}");
        for ((place, factor), (expected_place, expected)) in found.iter().zip(&factors) {
            assert!(
                place == expected_place && (factor - expected).abs() <= 1e3 * ROUNDING,
                "{seed}: {found:?} {factors:?}"
            );
        }
        // what none of them reaches is left
        let free = basis.reduce(random_row(&mut random));
        assert!(free.size() > DEPENDENT, "{seed}");
    }
}

/// Of 9 coordinates and n rows 9 − n are free; each vector is one free coordinate and what follows, and every row takes it to zero.
#[test]
fn analytic_null_space_is_taken_to_zero_by_every_row() {
    for seed in 0..60 {
        let mut random = Random::new(!seed);
        let n = 1 + random.below(6);
        let rows: Vec<Row> = (0..n).map(|_| random_row(&mut random)).collect();
        let mut basis = Basis::default();
        for row in &rows {
            let reduced = basis.reduce(row.clone());
            basis.push(reduced);
        }
        let space = basis.null_space(N_COLUMNS);
        let free: Vec<usize> = (0..N_COLUMNS).filter(|&column| space[column] == Row::from([(column, 1.0)])).collect();
        assert_eq!(free.len(), N_COLUMNS - n, "{seed}");
        for coordinate in &free {
            let vector = |column: usize| space[column].get(coordinate).copied().unwrap_or(0.0);
            let size = (0..N_COLUMNS).map(|column| vector(column).abs()).fold(0.0, f64::max);
            for row in &rows {
                let product: f64 = row.iter().map(|(&column, x)| x * vector(column)).sum();
                assert!(product.abs() <= ROUNDING * size, "{seed}: {product:.1e}");
            }
        }
    }
}

#[test]
fn analytic_largest_entry_is_the_first_of_the_largest() {
    assert_eq!(largest(&Row::from([(2, 1.0), (3, -4.0), (5, 4.0)])), (3, -4.0));
    assert_eq!(largest(&Row::new()), (0, 0.0));
    let mut rows = [Row::from([(0, 2.0), (1, 0.5)]), Row::from([(0, -8.0), (2, 0.0)])];
    scale_columns(&mut rows);
    assert_eq!(rows, [Row::from([(0, 0.25), (1, 1.0)]), Row::from([(0, -1.0), (2, 0.0)])]);
}

#[test]
fn invariant_random_states_are_spread_and_repeat() {
    let all: Vec<f64> = (0..4).flat_map(|seed| (0..500).map(move |index| fraction(seed, index))).collect();
    assert!(all.iter().all(|x| (0.0..1.0).contains(x)));
    let mean = all.iter().sum::<f64>() / all.len() as f64;
    // of 2000 uniform numbers: 0.29/√2000 is a standard deviation
    assert!((mean - 0.5).abs() <= 0.03, "{mean}");
    for tenth in 0..10 {
        let n = all.iter().filter(|x| (**x * 10.0) as usize == tenth).count();
        assert!((140..=260).contains(&n), "{n} of 200 in part {tenth}");
    }
    let mut sorted = all.clone();
    sorted.sort_by(f64::total_cmp);
    sorted.dedup();
    assert_eq!(sorted.len(), all.len(), "no two are equal");
    let mut diag = Diagnostics::default();
    let text = "model M { body one { mass: 1, inertia: 1 } start s { at rest; } scene run { start s; until 1 s; } }";
    let model = resolved(text, &mut diag);
    let equations = Equations::derive(&model, &model.scenes[0]);
    let state = |seed| RandomState { symbols: &equations.symbols, seed };
    let positions: Vec<f64> = (0..200).map(|seed| state(seed).symbol(equations.symbols.coordinate_at(1))).collect();
    assert!(positions.iter().all(|x| (-1.5..1.5).contains(x)) && positions.iter().any(|x| *x < -1.2));
    let times: Vec<f64> = (0..200).map(|seed| state(seed).symbol(Symbol::TIME)).collect();
    assert!(times.iter().all(|t| (0.1..3.1).contains(t)) && times.iter().any(|t| *t > 2.5));
    let parameters: Vec<f64> = (0..200).map(|index| state(1).parameter(index)).collect();
    assert!(parameters.iter().all(|p| (0.5..1.5).contains(p)));
    let (low, high) = parameters.iter().fold((1.0, 1.0), |(low, high), p| (f64::min(low, *p), f64::max(high, *p)));
    assert!(low < 0.55 && high > 1.45 && state(1).parameter(7) == parameters[7], "{low} {high}");
    assert_ne!(state(1).parameter(7), state(2).parameter(7));
}

/// What the rules say of a model with these items beside two bodies, and a start.
fn messages(items: &str, start: &str) -> String {
    let text = format!(
        "model Trial {{ param a: m = 1.0; param b: m = 2.0; body one {{ mass: 1, inertia: 1 }} \
         body two {{ mass: 1, inertia: 1 }} {items} start s {{ {start} }} scene run {{ start s; until 1 s; }} }}"
    );
    let mut diag = Diagnostics::default();
    let model = resolved(&text, &mut diag);
    super::rows(&model, &mut diag);
    diag.into_compile_errors().to_string()
}

fn resolved(text: &str, diag: &mut Diagnostics) -> Model {
    let syntax = parse::parse(text.parse().expect("the text has tokens"), diag);
    model::resolve(syntax, diag).filter(|_| diag.is_empty()).expect("it is a model")
}

/// A start may leave 1e-3 in a row whose coordinates it gives, and gives fewer or fitting values otherwise.
#[test]
fn analytic_starts_that_break_a_row_are_refused_with_what_they_leave() {
    let pivot = "hinge P: ground(0, 0) ~ one(-a, 0);";
    for (start, level) in [
        ("one at (1, 0) angle 0; at rest;", None),
        ("one at (1.0009, 0) angle 0; at rest;", None),
        ("one at (1.0011, 0) angle 0; at rest;", Some(("0.001 in constraint `P.x`", "position"))),
        ("one at (0.9989, 0) angle 0; at rest;", Some(("-0.001 in constraint `P.x`", "position"))),
        ("one at (1, 0.5) angle 0; at rest;", Some(("0.500 in constraint `P.y`", "position"))),
        ("one at (1, 0.5); at rest;", None),
        ("one near at (1, 0.5) angle 0; at rest;", None),
        ("one at (0, 1) angle pi/2; at rest;", None),
    ] {
        let found = messages(pivot, start);
        match level {
            None => assert!(!found.contains("compile_error"), "{start}: {found}"),
            Some((left, level)) => {
                let signs = [left.to_owned(), left.replace("0.", "-0.").replace("--", "")];
                let is_told =
                    signs.iter().any(|left| found.contains(left)) && found.contains(&format!("at {level} level"));
                assert!(found.contains("start `s` fixes too much") && is_told, "{start}: {found}");
            }
        }
    }
    let skate = "skate r: at one(0, 0) along one(1, 0);";
    for (start, left) in [
        ("one at (1, 0) angle 0 velocity (1, 0) rate 2;", None),
        ("one at (1, 0) angle 0 velocity (1, 0.5) rate 2;", Some("0.500 in constraint `r` at velocity level")),
        ("one at (1, 0) angle 0 velocity (1, 0.5);", Some("0.500 in constraint `r` at velocity level")),
        // a row that turns with its body is not known without its angle
        ("one at (1, 0) velocity (1, 0.5) rate 2;", None),
        ("one at (1, 0) angle 0 velocity (1, _) rate 2;", None),
        ("one at (1, 0) angle 0 velocity (1, 0.0009) rate 2;", None),
    ] {
        let found = messages(skate, start);
        match left {
            None => assert!(!found.contains("compile_error"), "{start}: {found}"),
            Some(left) => assert!(found.contains(left), "{start}: {found}"),
        }
    }
}

/// What repeats others for any parameters is an error, with the rows that it repeats and no other; each fault is told once.
#[test]
fn analytic_rows_that_repeat_others_are_named_with_these() {
    let both = "constraint p: one.x + two.x = a; constraint q: one.y = b; constraint r: two.y - one.x = 0; ";
    let found = messages(&format!("{both} constraint s: two.y + two.x = b;"), "at rest;");
    assert!(found.contains("constraint `s` repeats what `p`, `r` already demand"), "{found}");
    assert_eq!(found.matches("compile_error").count(), 1, "{found}");
    let found = messages(&format!("{both} constraint s: two.y + 2 * two.x = b;"), "at rest;");
    assert!(!found.contains("repeats"), "{found}");
    // with a small factor it is one of them, too
    let found = messages(&format!("{both} constraint s: 0.001 * one.y = a;"), "at rest;");
    assert!(found.contains("constraint `s` repeats what `q` already demands"), "{found}");
    // a small row is not
    let found = messages(&format!("{both} constraint s: 0.000001 * two.x = a;"), "at rest;");
    assert!(!found.contains("repeats"), "{found}");
    let found = messages("constraint p: one.x - one.x = 0;", "at rest;");
    assert!(found.contains("constraint `p` restricts no motion"), "{found}");
    let found = messages("velocity constraint p: one.vx^2 = a * one.omega * one.vx;", "at rest;");
    assert!(found.contains("`p` is not linear"), "{found}");
    let eight: String = (0..4).map(|i| format!("hinge h{i}: one(a, {i}) ~ two({i}, b);")).collect();
    let found = messages(&eight, "at rest;");
    assert!(found.contains("8 constraint equations but only 6 coordinates"), "{found}");
    let six: String = (0..2).map(|i| format!("hinge h{i}: ground({i}, {i}) ~ one({i}, b);")).collect();
    for few in [&six[..], "hinge h: ground(0, 0) ~ one(a, b);"] {
        assert!(!messages(few, "at rest;").contains("coordinates"), "{few}");
    }
}

/// Rows of positions stand before those of velocities, and each reads the bodies that it holds, not those whose values cancel.
#[test]
fn invariant_templates_are_ordered_and_read_what_they_hold() {
    let mut diag = Diagnostics::default();
    let text = "model M { count n = 3; body car[n] { mass: 1, inertia: 1 } body wheel { mass: 1, inertia: 1 } \
                for i in 0..n { skate runner[i]: at car[i](0, 0) along car[i](1, 0); } \
                for i in 1..n { hinge pin[i]: car[i-1](0.5, 0) ~ car[i](-0.5, 0); } \
                constraint level: car[0].y + wheel.x - wheel.x = 0; \
                start s { at rest; } scene run { start s; until 1 s; } }";
    let model = resolved(text, &mut diag);
    let templates = Templates::derive(&model, &model.scenes[0]);
    let rows: Vec<(String, usize, bool)> = (templates.rows.iter())
        .map(|row| (row.row.name.to_string(), row.slots.len(), row.constraints.n_position_rows > 0))
        .collect();
    let expected = [("pin", 2, true), ("level", 1, true), ("runner", 1, false)];
    assert_eq!(rows, expected.map(|(name, slots, holds)| (name.to_owned(), slots, holds)));
}

/// A force that bends has no series: its function is named.
#[test]
fn analytic_forces_that_bend_have_no_series() {
    for (force, bends) in
        [("max(one.phi, 0)", Some(Function::Max)), ("min(one.phi, 2)", Some(Function::Min)), ("one.phi", None)]
    {
        let mut diag = Diagnostics::default();
        let text = format!(
            "model M {{ body one {{ mass: 1, inertia: 1 }} force at one(0, 0): (-3 N * ({force}), 0); \
             start s {{ at rest; }} scene run {{ start s; until 1 s; }} }}"
        );
        let model = resolved(&text, &mut diag);
        assert_eq!(Derived::new(&model, &model.scenes[0]).series.err(), bends, "{force}");
    }
}

/// Every symbol stands for what it was made for.
#[test]
fn invariant_symbols_keep_their_meaning() {
    let mut diag = Diagnostics::default();
    let text = "model M { input first: N = 1; input second: N = 2; input third: N = 3; body one { mass: 1, inertia: 1 } \
                body two { mass: 1, inertia: 1 } force at one(0, 0): (first + second, third); start s { at rest; } \
                scene run { start s; until 1 s; } }";
    let model = resolved(text, &mut diag);
    let mut symbols = Equations::derive(&model, &model.scenes[0]).symbols;
    assert_eq!(symbols.meaning(Symbol::TIME), Meaning::Time);
    for i in 0..6 {
        assert_eq!(symbols.meaning(symbols.coordinate_at(i)), Meaning::Coordinate(i));
        assert_eq!(symbols.meaning(symbols.velocity_at(i)), Meaning::Velocity(i));
    }
    for i in 0..3 {
        assert_eq!(symbols.input(InputId(i)).map(|symbol| symbols.meaning(symbol)), Some(Meaning::Input(i)));
    }
    for i in 0..2 {
        let named = symbols.new_named(format!("value_{i}"));
        assert_eq!((symbols.meaning(named), symbols.code_name(named)), (Meaning::Named(i), format!("value_{i}")));
    }
}

/// With the declared lengths alone: where two hinges hold two points of both bodies, their distances agree. One of all assemblies that the
/// guesses lead to is enough to accept a row.
#[test]
fn analytic_rows_that_repeat_others_as_declared_are_warned_of() {
    for (items, repeats) in [
        ("hinge P: one(0, 0) ~ two(0, 0); hinge Q: one(a, 0) ~ two(a, 0);", Some("`Q.y` repeats what")),
        ("hinge P: one(0, 0) ~ two(0, 0); hinge Q: one(a, 0) ~ two(b, 0);", None),
        ("hinge P: one(0, 0) ~ two(0, 0); hinge Q: one(a, b) ~ two(a, b);", Some("`Q.y` repeats what")),
        ("hinge P: one(0, 0) ~ two(0, 0); hinge Q: one(a, b) ~ two(b, a);", Some("`Q.y` repeats what")),
        (
            "rod P: ground(0, 0) ~ one(0, 0) length b; rod Q: ground(1, 0) ~ one(1, 0) length b; \
             rod R: ground(3, a) ~ two(3, a) length b;",
            None,
        ),
        ("hinge P: ground(0, 0) ~ one(0, 0); rod Q: ground(0, b) ~ one(0, a) length 1.5;", None),
        (
            "hinge P: ground(0, 0) ~ one(a, 0); hinge R: one(0, 0) ~ two(a, 0); rod Q: ground(3, 0) ~ two(0, 0) length b;",
            None,
        ),
    ] {
        let found = messages(items, "at rest;");
        let is_told = found.contains("with the declared parameters constraint");
        assert_eq!(is_told, repeats.is_some(), "{items}: {found}");
        assert!(
            repeats.is_none_or(|repeats| found.contains(repeats)) && !found.contains("compile_error"),
            "{items}: {found}"
        );
    }
}
