//! No text, however mistaken, panics; each becomes items or errors.

use crate::pipeline::expand;
use proc_macro2::{Group, TokenStream, TokenTree};
use std::str::FromStr;

const EZY_ROLLER: &str = include_str!("model/tests/ezy_roller.txt");

/// Mutated texts. So many meet every branch of the parser many times.
const N_TEXTS: usize = 2000;
/// Mistakes of one text: from one slip to a heap of words.
const MAX_MISTAKES: usize = 6;

/// Constructs that the EzyRoller does not need.
const MORE: &str = "pub model More {
    param angle: deg = 30; param k = 1.5e1; let lift = 2 * norm(A.v) ^ 2 - min(k, 3) / cross(A.v, (1, -k));
    body rear { mass: 1, inertia: 2 } body front { mass: 0, inertia: 0 }
    point A = ground(1, k); hinge pin: rear(0, k) ~ A; hinge next: pin ~ front(-k, 0);
    force at rear(0, 1) across front(1, 0): lift * pin.rate;
    start s { rear at (_, _) velocity (k, _) angle -pi / 4 * 0; front vx 1 vy 2; }
    body extra { mass: k, inertia: 1 }
    rod link: extra(1, 0) ~ front(0, 1) length 2 + k; slot groove: extra(0, 0) ~ ground(0, 0) along extra(k, 1);
    gravity (0, -9.81); spring A ~ front(0, 0): stiffness 3, length 1, damping k; friction rear ~ front: torque 1, rate k;
    velocity constraint rear.omega = k * smooth_step(t, 0, 1) * extra.vx; drive crank: pin.angle = sin(k * t);
    input u: N*m = 2 * 3; output place: mm = (A.x, u / 1e3); output slip = pin.rate;
    effect wind { input gust = -1; output side: N = gust * rear.vx; force at rear(0, 0): (gust, 2 * u); }
    effect grip { release groove; tyre at front(0, 0) along front(1, 0): stiffness k, limit 2; }
    effect drag { param c: N*s/m = 2; let f = -c * pin.v; force at pin: f; torque rear: c * 3; }
    scene only { start s; until 2 min; with drag, wind; }
}";

/// Counts, arrays and `for`.
const REPEATED: &str = "pub model Repeated {
    count n = 3; count m = 2; param l: m = 1; param c: N*m*s = 0.1;
    body link[n] { mass: 1, inertia: 1 } body node[n, m+1] { mass: n, inertia: 1 } body hub { mass: 1, inertia: 1 }
    hinge top: ground(0, 0) ~ link[0](-l/2, 0);
    for i in 1..n { hinge pin[i]: link[i-1](l/2, 0) ~ link[i](-l/2, 0); point P[i] = link[i](l*i/n, 0); }
    for i in 0..n { for j in 0..m { rod r[i, j]: node[i, j](0, 0) ~ node[i, j+1](0, 0) length l*(i + 1); } }
    for i in 1..n { constraint g[i]: P[i].y = 0.1 * i; output o[i]: rad = pin[i].angle; force at P[i]: (0, -2*i); }
    gravity (0, -9.81);
    effect rub { release g; for i in 1..n { torque link[i] ~ link[i-1]: -c * pin[i].rate; } torque hub: c * P[n-1].vx / l; }
    start s { for i in 0..n { link[i] angle 0.1*i; } link[n-1] rate 1; hub at (0, 0); }
    scene all { start s; until 1 s; } scene rubbed { start s; until 1 s; with rub; }
}";

/// A linear congruential generator (Knuth's MMIX constants): the same texts on every machine.
struct Random(u64);

impl Random {
    fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 33) as usize % n.max(1)
    }
}

#[test]
fn invariant_mutated_texts_give_a_model_or_an_error() {
    let mut random = Random(20);
    let texts = [EZY_ROLLER, MORE, REPEATED].map(|text| TokenStream::from_str(text).expect("good texts are tokens"));
    let all: Vec<TokenTree> = texts.iter().cloned().flat_map(flatten).collect();
    let mut n_models = 0;
    for i in 0..N_TEXTS {
        let mut text = texts[i % 3].clone();
        for _ in 0..=random.below(MAX_MISTAKES) {
            text = mutate(text, &all, &mut random);
        }
        n_models += usize::from(!is_error(&expand(text)));
    }
    assert!(0 < n_models && n_models < N_TEXTS, "the mutations are neither empty nor all fatal: {n_models}");
}

#[test]
fn invariant_other_constructs_are_a_model() {
    for text in [MORE, REPEATED] {
        let items = expand_text(text);
        assert!(!is_error(&items), "{items}");
    }
}

#[test]
fn invariant_deep_brackets_and_signs_end_in_an_error() {
    for (open, close) in [("(", ")"), ("-", ""), ("sin(", ")"), ("2^", ""), ("1 - (2 * ", ")"), ("a[", "]")] {
        let value = format!("{}1{}", open.repeat(2000), close.repeat(2000));
        let items = expand_text(&format!("pub model M {{ param a = {value}; }}"));
        assert!(items.to_string().contains(" more than "), "{items}");
    }
}

#[test]
fn invariant_deepest_expressions_are_a_model() {
    for (open, close, n) in [("(", ")", 49), ("-", "", 390), ("sin(", ")", 49), ("1.01^", "", 190), ("1 + ", "", 190)] {
        let value = format!("{}(2 * seat.x){}", open.repeat(n), close.repeat(n));
        assert!(!is_error(&expand_text(&with_torque("", &value))), "{open}");
    }
}

#[test]
fn invariant_values_of_values_are_a_model_or_an_error() {
    let lets: String = (1..9).map(|i| format!("let a{i} = a{} + sin(a{});", i - 1, i - 1)).collect();
    assert!(!is_error(&expand_text(&with_torque(&format!("let a0 = 2 * seat.x; {lets}"), "a8"))));
    let reverse: String = (0..2000).map(|i| format!("let a{i} = 1 + a{};", i + 1)).collect();
    assert!(expand_text(&with_torque(&reverse, "1")).to_string().contains("long chain of values"));
}

fn with_torque(items: &str, value: &str) -> String {
    format!(
        "pub model M {{ body seat {{ mass: 1, inertia: 1 }} {items} torque seat: {value};
         start s {{ }} scene c {{ start s; until 1 s; }} }}"
    )
}

fn expand_text(text: &str) -> TokenStream {
    expand(TokenStream::from_str(text).expect("the text consists of Rust tokens"))
}

fn is_error(items: &TokenStream) -> bool {
    items.to_string().contains("compile_error")
}

/// Deletes, repeats, swaps or inserts one token, somewhere in the tree.
fn mutate(text: TokenStream, all: &[TokenTree], random: &mut Random) -> TokenStream {
    let mut trees: Vec<TokenTree> = text.into_iter().collect();
    if trees.is_empty() {
        return trees.into_iter().collect();
    }
    let i = random.below(trees.len());
    if let (TokenTree::Group(group), 1..) = (&trees[i], random.below(8)) {
        let inside = mutate(group.stream(), all, random);
        trees[i] = Group::new(group.delimiter(), inside).into();
        return trees.into_iter().collect();
    }
    let j = random.below(trees.len());
    match random.below(5) {
        0 => drop(trees.remove(i)),
        1 => trees.insert(i, trees[j].clone()),
        2 => trees.swap(i, j),
        3 => trees.insert(i, all[random.below(all.len())].clone()),
        _ => trees[i] = all[random.below(all.len())].clone(),
    }
    trees.into_iter().collect()
}

/// Every token tree, also inside of brackets.
fn flatten(text: TokenStream) -> Vec<TokenTree> {
    let inside = |tree: TokenTree| match &tree {
        TokenTree::Group(group) => [vec![tree.clone()], flatten(group.stream())].concat(),
        _ => vec![tree],
    };
    text.into_iter().flat_map(inside).collect()
}
