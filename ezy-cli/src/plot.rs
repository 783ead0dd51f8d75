//! The command `plot`.

use super::Models;
use super::arguments::PlotArguments;
use super::drawing;
use super::failure::Failure;

#[cfg(not(feature = "figures"))]
pub(super) fn plot(_: Models<'_>, _: &PlotArguments) -> Result<(), Failure> {
    drawing::check()
}

#[cfg(feature = "figures")]
pub(super) fn plot(models: Models<'_>, arguments: &PlotArguments) -> Result<(), Failure> {
    use super::drawing_of_columns::Picture;
    use super::failure::print;
    use super::names::scene_entry;
    use super::runs::Runs;
    use super::selection::{find, path};

    let (scenes, patterns): (Vec<&String>, Vec<&String>) = arguments.what.iter().partition(|word| word.contains('/'));
    let Some(first) = scenes.first() else {
        let word = patterns.first().map_or("", |word| word.as_str());
        // a model, or what may be one, is answered with its scenes
        if let [word, ..] = patterns[..] {
            match find(models, word) {
                Ok(_) => scene_entry(models, word).map(|_| ())?,
                Err(unknown) if unknown.known.iter().any(|known| known.contains('/')) => return Err(unknown.into()),
                Err(_) => {}
            }
        }
        return Err(Failure::wrong_use(format!("`{word}` names no scene; write MODEL/SCENE before the columns")));
    };
    let (model, entry) = scene_entry(models, first)?;
    let out = arguments.out.clone().unwrap_or_else(|| format!("{}.svg", path(model, entry).replace('/', "-")).into());
    drawing::check_name(&out)?;
    let runs = Runs { variations: &arguments.vary, every: arguments.every, n_scenes: scenes.len() };
    let mut motions = Vec::new();
    let mut stopped = None;
    for scene in &scenes {
        stopped = stopped.or(runs.motions(models, scene, &arguments.motion, &mut motions)?);
    }
    if patterns.is_empty() {
        let known: Vec<&str> = motions[0].columns[1..].iter().map(|column| column.name.as_str()).collect();
        return Err(Failure::wrong_use(format!("give one column or several; {first} has: {}", known.join(", "))));
    }
    let names: Vec<String> = scenes.iter().map(|scene| scene.to_lowercase()).collect();
    let title = names.join(", ");
    let against = arguments.against.as_deref();
    Picture { title: &title, motions: &motions, patterns: &patterns, against }.write(&out)?;
    print(&format!("{}\n", out.display()))?;
    stopped.map_or(Ok(()), Err)
}
