//! What the macro makes of models, compared with `tests/answers/expanded`: some parts word for word, of all others a
//! hash and counts.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use proc_macro2::{Delimiter, Spacing, TokenStream, TokenTree};

use crate::golden;
use crate::model::case::snake_case;
use crate::parse::Hash;
use crate::pipeline::expand;

/// The models whose expansion is compared. Together they have every word of the language.
const MODELS: [&str; 4] = [
    "models/src/vehicles/ezy_roller.rs",
    "models/src/mechanisms/chain.rs",
    "models/src/mechanisms/pendulum.rs",
    "tests/src/random_models.rs",
];

/// Parts that are kept as examples, by the beginning of their names: a scene, what a limit adds to it, and what loops make of
/// the same in a scene with counts.
const EXAMPLES: [&str; 11] = [
    "ezy_roller/module.",
    "ezy_roller/names.",
    "ezy_roller/coast/",
    "ezy_roller/skid/derived.rs",
    "chain/module.",
    "chain/names.",
    "chain/swing/page.",
    "chain/swing/equations.rs",
    "chain/swing/scene.rs",
    "chain/swing/derived.rs",
    "chain/swing/series.rs",
];

/// The parts of an expansion by name, such as `chain/swing/equations.rs`.
pub type Parts = BTreeMap<String, String>;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn answers() -> PathBuf {
    root().join("tests/answers/expanded")
}

/// The `model!` texts of a file of this workspace.
pub fn model_texts(file: &Path) -> Vec<TokenStream> {
    let source = fs::read_to_string(file).expect("the file is there");
    texts(source.parse().expect("the file has tokens"))
}

/// The `model!` texts among tokens.
pub fn texts(tokens: TokenStream) -> Vec<TokenStream> {
    let mut texts = Vec::new();
    collect(tokens, &mut texts);
    texts
}

fn collect(tokens: TokenStream, texts: &mut Vec<TokenStream>) {
    let mut before = [String::new(), String::new()];
    for token in tokens {
        if let TokenTree::Group(group) = &token {
            match before == ["model", "!"] && group.delimiter() == Delimiter::Brace {
                true => texts.push(group.stream()),
                false => collect(group.stream(), texts),
            }
        }
        before = [std::mem::take(&mut before[1]), token.to_string()];
    }
}

/// The text of a model file with one model.
pub fn model_text(file: &str) -> TokenStream {
    model_texts(&root().join("models/src").join(file)).pop().expect("the file holds a model")
}

/// What a model becomes, part by part.
pub fn parts(model: TokenStream) -> Parts {
    let items: syn::File = syn::parse2(expand(model)).expect("the expansion is Rust");
    let mut parts = BTreeMap::new();
    items.items.into_iter().for_each(|item| add(item, "", &mut parts));
    let text = |(name, Part { items, page }): (String, Part)| {
        let file = syn::parse2(quote::quote!(#(#items)*)).expect("items are a file");
        let page = (!page.is_empty()).then(|| (format!("{name}.md"), page + "\n"));
        let code = (!items.is_empty()).then(|| (format!("{name}.rs"), prettyplease::unparse(&file)));
        code.into_iter().chain(page)
    };
    parts.into_iter().flat_map(text).collect()
}

/// Items that stand together, and the page that only rustdoc reads.
#[derive(Default)]
struct Part {
    items: Vec<syn::Item>,
    page: String,
}

/// Adds an item to its part: that of its scene and trait, or of the module around it.
fn add(mut item: syn::Item, folder: &str, parts: &mut BTreeMap<String, Part>) {
    let last = |path: &syn::Path| path.segments.last().map(|last| snake_case(&last.ident.to_string()));
    let part = match &mut item {
        syn::Item::Mod(module) if ["names", "events"].iter().any(|name| module.ident == name) => {
            format!("{folder}names")
        }
        syn::Item::Mod(module) => {
            let inside = format!("{folder}{}/", snake_case(&module.ident.to_string()));
            let items = module.content.take().into_iter().flat_map(|(_, items)| items);
            items.for_each(|item| add(item, &inside, parts));
            module.content = Some(Default::default());
            let page = take_page(&mut module.attrs);
            let part = parts.entry(format!("{inside}module")).or_default();
            part.page = page;
            return part.items.insert(0, item);
        }
        syn::Item::Struct(scene) => {
            let folder = format!("{folder}{}", snake_case(&scene.ident.to_string()));
            parts.entry(format!("{folder}/page")).or_default().page = take_page(&mut scene.attrs);
            format!("{folder}/info")
        }
        syn::Item::Impl(block) => {
            let syn::Type::Path(scene) = &*block.self_ty else { panic!("scenes are named") };
            let of = block.trait_.as_ref().and_then(|(.., path, _)| last(path)).filter(|of| of != "default");
            format!("{folder}{}/{}", last(&scene.path).unwrap_or_default(), of.as_deref().unwrap_or("info"))
        }
        _ => format!("{folder}module"),
    };
    parts.entry(part).or_default().items.push(item);
}

/// The text of `#[cfg_attr(doc, doc = "…")]`.
fn take_page(attributes: &mut Vec<syn::Attribute>) -> String {
    let text = |attribute: &syn::Attribute| {
        let syn::Meta::List(list) = &attribute.meta else { return None };
        let text = list.path.is_ident("cfg_attr").then(|| list.tokens.clone().into_iter().last())??;
        syn::parse2::<syn::LitStr>(text.into()).ok().map(|text| text.value())
    };
    let pages = attributes.iter().filter_map(text).collect();
    attributes.retain(|attribute| text(attribute).is_none());
    pages
}

/// What a part is, without its text: a row of the table of digests.
fn digest(name: &str, text: &str) -> String {
    let (hash, lines) = (Hash::of(text.bytes()), text.lines().count());
    let Counts { functions, statements, sums, products, fused } = match name.ends_with(".rs") {
        true => count(text.parse().expect("the part has tokens"), false),
        false => Counts::default(),
    };
    format!("| {name} | {hash:016x} | {lines} | {functions} | {statements} | {sums} | {products} | {fused} |\n")
}

#[derive(Default)]
struct Counts {
    functions: usize,
    statements: usize,
    sums: usize,
    products: usize,
    fused: usize,
}

/// Counts tokens; semicolons are statements within braces alone.
fn count(tokens: TokenStream, in_braces: bool) -> Counts {
    let mut counts = Counts::default();
    let mut tokens = tokens.into_iter().peekable();
    while let Some(token) = tokens.next() {
        match token {
            TokenTree::Group(group) => {
                let inside = count(group.stream(), group.delimiter() == Delimiter::Brace);
                counts.functions += inside.functions;
                counts.statements += inside.statements;
                counts.sums += inside.sums;
                counts.products += inside.products;
                counts.fused += inside.fused;
            }
            TokenTree::Ident(word) if word == "fn" => counts.functions += 1,
            TokenTree::Ident(word) if word == "fused" => counts.fused += 1,
            TokenTree::Punct(sign) => {
                let arrow = sign.spacing() == Spacing::Joint
                    && matches!(tokens.peek(), Some(TokenTree::Punct(next)) if next.as_char() == '>');
                match sign.as_char() {
                    ';' if in_braces => counts.statements += 1,
                    '+' | '-' if !arrow => counts.sums += 1,
                    '*' | '/' => counts.products += 1,
                    _ => {}
                }
            }
            _ => {}
        }
    }
    counts
}

const DIGEST_HEAD: &str = "\
Parts that are not kept as text. `+ −` counts signs and `× ÷` products and quotients as written, `fused` the products that a sum
takes in. What such a part is today: `EXPANSIONS=FOLDER cargo test -p ezy-derive --lib expansions -- --ignored`.

| part | hash (FNV-1a) | lines | functions | statements | + − | × ÷ | fused |
| --- | --- | --- | --- | --- | --- | --- | --- |
";

#[test]
fn regress_expansions_are_unchanged() {
    let mut files = BTreeMap::new();
    let mut digests = DIGEST_HEAD.to_owned();
    for (name, text) in MODELS.iter().flat_map(|file| model_texts(&root().join(file))).flat_map(parts) {
        match EXAMPLES.iter().any(|example| name.starts_with(example)) {
            true => {
                files.insert(answers().join(name), text);
            }
            false => digests += &digest(&name, &text),
        }
    }
    files.insert(answers().join("digests.md"), digests);
    golden::compare_all(&files);
    let kept = files_below(&answers()).into_iter().filter(|file| !file.ends_with("README.md"));
    let kept: Vec<PathBuf> = kept.filter(|file| !files.contains_key(file)).collect();
    assert!(kept.is_empty(), "the macro does not make {kept:?}");
}

fn files_below(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("the folder is there").map(|entry| entry.expect("an entry").path());
    entries.flat_map(|path| if path.is_dir() { files_below(&path) } else { vec![path] }).collect()
}

/// Writes the expansion of every model of the workspace into the folder that `EXPANSIONS` names, so that two versions of
/// the macro can be compared with `diff -r`.
#[test]
#[ignore = "a tool: it writes files and checks nothing"]
fn write_all_expansions() {
    let Some(folder) = std::env::var_os("EXPANSIONS").map(PathBuf::from) else { return };
    let sources = ["models", "tests/src", "tests/tests", "ezy-core/src", "ezy-derive/tests"];
    for file in sources.iter().flat_map(|source| files_below(&root().join(source))) {
        if file.extension().is_none_or(|extension| extension != "rs") {
            continue;
        }
        let name = file.strip_prefix(root()).expect("the file is in the workspace").with_extension("");
        for (i, text) in model_texts(&file).into_iter().enumerate() {
            for (part, text) in parts(text) {
                golden::write(&folder.join(&name).join(i.to_string()).join(part), &text);
            }
        }
    }
}

#[test]
fn invariant_expansion_does_not_depend_on_the_count() {
    let text = model_text("mechanisms/chain.rs").to_string();
    let with = |n: &str| {
        let text = text.replace("count n = 10", &format!("count n = {n}"));
        let expanded = expand(text.parse().expect("the text has tokens")).to_string();
        // the hash of the text, which is another one
        let mut parts = expanded.split("fingerprint : ");
        let first = parts.next().unwrap_or_default().to_owned();
        parts.fold(first, |all, part| all + part.trim_start_matches(|c: char| c.is_ascii_alphanumeric()))
    };
    let (small, large) = (with("3"), with("777777"));
    assert!(large.contains("777777") && !large.contains("compile_error"), "{large}");
    assert!(large.len() - small.len() < 100, "{} and {} signs", small.len(), large.len());
    assert_eq!(with("777777"), with("555555").replace("555555", "777777"));
}

#[test]
fn invariant_expansion_is_the_same_twice() {
    assert_eq!(parts(model_text("vehicles/ezy_roller.rs")), parts(model_text("vehicles/ezy_roller.rs")));
}

/// The equations of the scene `coast` of a roller with more items: `impl Equations` and `impl Scene`, as emitted.
fn equations_of_coast(more: &str) -> String {
    let text = format!(
        "model Roller {{ param a: m = 0.2; param b: m = 0.6; param m: kg = 46; param i: kg*m^2 = 10; \
         body seat {{ mass: m, inertia: i }} body bar {{ mass: 1, inertia: 0.005 }} point A = seat(-a, 0); \
         hinge B: seat(b, 0) ~ bar(-0.1, 0); skate rear: at A along seat(1, 0); \
         skate front: at bar(0.1, 0) along bar(1, 0); {more} \
         start folded {{ bar angle pi; at rest; }} scene coast {{ start folded; until 1 s; }} }}"
    );
    let parts = parts(text.parse().expect("the text has tokens"));
    ["equations", "scene"].iter().fold(String::new(), |all, part| all + &parts[&format!("roller/coast/{part}.rs")])
}

#[test]
fn invariant_effects_that_a_scene_does_not_name_leave_its_code_as_it_is() {
    let with_effects = equations_of_coast(
        "effect pump { param m0: N*m = 2; torque seat ~ bar: m0 * cos(3 * t); } \
         effect slip { param c: N = 400; release rear; tyre at A along seat(1, 0): stiffness c; } \
         effect tie { rod tie: A ~ ground(0, 0) length 1; } \
         effect motor { state current: A = 0 rate 2 A/s - current / (3 s); torque seat ~ bar: current * 2 (N*m/A); } \
         scene driven { start folded; until 1 s; with pump, slip, tie, motor; }",
    );
    assert!(with_effects == equations_of_coast(""), "{with_effects}");
}

#[test]
fn invariant_scene_without_an_effect_has_no_cosine_of_time() {
    let coast = ["equations", "scene", "series"].map(|part| format!("ezy_roller/coast/{part}.rs"));
    let parts = parts(model_text("vehicles/ezy_roller.rs"));
    let coast = coast.iter().fold(String::new(), |all, part| all + &parts[part]);
    assert!(coast.contains("fn accelerations") && !coast.contains("cos(product"), "{coast}");
}

#[test]
fn analytic_states_are_read_behind_inputs_and_have_a_method_for_their_rates() {
    let text = "model Motor { param k: N*m/A = 0.05; body wheel { mass: 1, inertia: 2 } \
                state current: A = 0.5 rate 3 A/s - u*current; input u: Hz = 2; torque wheel: k*current; \
                start s { at rest; } scene run { start s; until 1 s; } }";
    let parts = parts(text.parse().expect("the text has tokens"));
    let equations = &parts["motor/run/equations.rs"];
    let (_, rates) = equations.split_once("fn state_rates").expect("the scene has rates");
    let (rates, _) = rates.split_once("fn ").expect("other methods follow");
    for line in
        ["let c = ezy::array::<4usize, T>(c);", "let u = c[0usize];", "let current = c[1usize];", "out[0usize] = "]
    {
        assert!(rates.contains(line), "{line}: {rates}");
    }
    assert!(equations.contains("c[2usize] = k_half;"), "{equations}");
    let info = &parts["motor/run/info.rs"];
    let between = |begin: &str, end: &str| {
        let (_, behind) = info.split_once(begin).expect("the description says so");
        behind.split_once(end).expect("the description goes on").0.to_owned()
    };
    let (inputs, states) = (between("inputs:", "integrated_inputs:"), between("states:", "outputs:"));
    assert!(inputs.contains("\"u\"") && !inputs.contains("\"current\""), "{inputs}");
    assert!(states.contains("\"current\"") && states.contains("0.5") && !states.contains("\"u\""), "{states}");
    assert!(info.contains("series: ezy::SeriesInfo::Analytic") && info.contains("d/dt current = "), "{info}");
    let code: String = parts.iter().filter(|(name, _)| name.ends_with(".rs")).map(|(_, code)| code.as_str()).collect();
    assert!(!code.contains("pub current"), "{code}");
    let series = &parts["motor/run/series.rs"];
    let (begin, orders) = series.split_once("fn right_side").expect("the scene has a series");
    let (right_side, finish) = orders.split_once("fn finish").expect("other methods follow");
    for (method, order) in [(begin, "0"), (begin, "1"), (right_side, "k + 1")] {
        let written = format!("ezy::row_mut::<1usize, T>(&mut store.kept, {order})");
        assert!(method.contains(&written), "{written}: {method}");
    }
    assert!(right_side.contains("ezy::row::<1usize, T>(&store.kept, k + 0)"), "{right_side}");
    assert!(!finish.contains("kept"), "{finish}");
    // the torque, then the rate
    let (_, places) = code.split_once("fn state_jacobian_places").expect("the scene has states");
    assert!(places.contains("vec![(2usize, 0usize), (3usize, 0usize)]"), "{places}");
    assert!(places.contains("out[1usize] = -u;"), "{places}");
}

#[test]
fn analytic_digest_tells_statements_and_operations() {
    let code = "fn f(a: [f64; 2]) -> f64 { let x = a[0] * a[1] + a[0]; let y = T::fused(x, x, -x); { x / y } }";
    let row = digest("f.rs", code);
    assert_eq!(row, format!("| f.rs | {:016x} | 1 | 1 | 2 | 2 | 2 | 1 |\n", Hash::of(code.bytes())));
    // the value for "a" of the reference
    assert_eq!(Hash::of(*b"a"), 0xaf63_dc4c_8601_ec8c);
}
