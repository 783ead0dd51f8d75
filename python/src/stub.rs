//! The types of a module as the text of its `.pyi` file: editors complete the names of its scenes and parameters, and mypy checks them.

use ezy_core::model::{ModelInfo, ParameterInfo, SceneEntry};

/// The classes are the same in all modules. A test in Python compares them with the module.
const CLASSES: &str = include_str!("classes.pyi");

/// Names that a model may have and that Python keeps for itself: they are left out, as they cannot be typed.
const KEYWORDS: [&str; 19] = [
    "and", "assert", "class", "def", "del", "elif", "except", "finally", "from", "global", "import", "is", "lambda",
    "nonlocal", "not", "or", "pass", "raise", "with",
];

/// The classes, and each model with its scenes; of a single model the scenes are in the module itself.
pub(crate) fn text(models: &[&'static ModelInfo]) -> String {
    let mut text = format!("# Written by `type_stub()` of this module.\n{CLASSES}");
    for model in models {
        text += &if models.len() == 1 { scenes_in(model, "_", "") } else { model_class(model) };
    }
    text
}

/// The classes of the scenes, and then the scenes.
fn scenes_in(model: &ModelInfo, prefix: &str, between: &str) -> String {
    let class = |scene: &SceneEntry| format!("{prefix}{}", scene.name.split('_').map(capital).collect::<String>());
    let classes: String = scenes(model).map(|scene| scene_class(&class(scene), scene)).collect();
    let indent = if between.is_empty() { "" } else { "    " };
    let all: String = scenes(model).map(|scene| format!("{indent}{}: {}\n", scene.name, class(scene))).collect();
    format!("{classes}\n{between}{all}")
}

/// The class of a model, and the model.
fn model_class(model: &ModelInfo) -> String {
    let name = model.name.to_lowercase();
    let class = format!("_{}", model.name);
    let head = format!("class {class}(Model):\n    \"\"\"{}\"\"\"\n\n", documentation(model.documentation));
    format!("{}\n{name}: {class}\n", scenes_in(model, &class, &head))
}

fn scenes(model: &ModelInfo) -> impl Iterator<Item = &'static SceneEntry> + use<> {
    model.scenes.iter().filter(|scene| can_be_typed(scene.name))
}

fn can_be_typed(name: &str) -> bool {
    !KEYWORDS.contains(&name)
}

fn capital(name: &str) -> String {
    let mut letters = name.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

/// The class of a scene: its parameters are keywords, with their units and meanings as documentation.
fn scene_class(class: &str, scene: &SceneEntry) -> String {
    let info = (scene.info)();
    let parameters = info.parameters.iter().filter(|of| can_be_typed(of.name));
    let counts = info.counts().iter().filter(|of| can_be_typed(of.name));
    let mut arguments: Vec<String> = counts.map(|of| format!("{}: int = {}", of.name, of.default)).collect();
    arguments.extend(parameters.clone().map(|of| format!("{}: float = {}", of.name, number(of.default))));
    let arguments = match &*arguments {
        [] => String::new(),
        all => format!(", *, {}", all.join(", ")),
    };
    let mut meanings: String = parameters.map(meaning).collect();
    if !meanings.is_empty() {
        meanings = format!("\n\n{meanings}        ");
    }
    let documentation = documentation(info.documentation);
    format!(
        "\nclass {class}(SceneType):\n    def __call__(self{arguments}) -> Scene:\n        \"\"\"{documentation}{meanings}\"\"\"\n"
    )
}

fn meaning(of: &ParameterInfo) -> String {
    format!("        {}: {} [{}]\n", of.name, documentation(of.documentation), of.unit)
}

fn number(value: f64) -> String {
    if value.is_finite() { format!("{value:?}") } else { "...".to_owned() }
}

/// The first paragraph as one line that may stand in a string of Python.
fn documentation(text: &str) -> String {
    let paragraph = text.lines().map(str::trim).skip_while(|line| line.is_empty()).take_while(|line| !line.is_empty());
    let line = paragraph.collect::<Vec<_>>().join(" ").replace('\\', "\\\\").replace('"', "\\\"");
    if line.is_empty() { "Without a description.".to_owned() } else { line }
}
