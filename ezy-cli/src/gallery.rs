//! The command `gallery`.

use std::path::PathBuf;

use ezy_core::model::{ModelInfo, SceneEntry};
use ezy_core::simulate::Simulation;
use ezy_study::report::drawing;
use ezy_study::report::page::{escape, prose};

use super::Models;
use super::animate::{page_of, write};
use super::arguments::GalleryArguments;
use super::failure::{Failure, print};
use super::interruption::Interruption;
use super::motion::refused;
use super::motion_arguments::MotionArguments;
use super::out_path::check_folder_name;
use super::selection::{path, selected, typed};

const PAGE: &str = include_str!("gallery/page.html");
/// Largest sketch, pixels: in the narrowest column, of 302 pixels, its letters of 15 are shown with at least 10.
const LARGEST: [f64; 2] = [450.0, 500.0];

/// Writes a sketch of each model, a page for each scene and the index.
pub(super) fn gallery(models: Models<'_>, arguments: &GalleryArguments) -> Result<(), Failure> {
    let directory = arguments.out.clone().unwrap_or_else(|| PathBuf::from("out/gallery"));
    check_folder_name(&directory)?;
    let interruption = Interruption::listen();
    // every scene as it is declared
    let motion = MotionArguments::default();
    let mut items = String::new();
    let mut faults = Vec::new();
    for (model, scenes) in selected(models, arguments.path.as_deref())? {
        let name = typed(model.name);
        if let Some(entry) = scenes.first() {
            write(&directory.join(format!("{name}.svg")), &sketch(entry)?)?;
        }
        let mut links = String::new();
        for entry in scenes {
            let scene = (entry.new)();
            let (page, run) = page_of(&motion, scene.as_ref(), interruption)?;
            let file = format!("{name}-{}.html", entry.name);
            write(&directory.join(&file), &page)?;
            if !run.outcome.reached_end() {
                faults.push(format!("{}: the run {}", path(model, entry), run.outcome));
            }
            let documentation = prose(scene.info().documentation);
            links += &format!("<li><a href=\"{file}\">{}</a> {documentation}</li>\n", entry.name);
            if interruption.is_asked() {
                return Err(interruption.failure("the gallery was interrupted; its index was not written"));
            }
        }
        items += &item(model, &name, &links);
        print(&format!("{name}\n"))?;
    }
    let index = directory.join("index.html");
    write(&index, PAGE.replace("{{MODELS}}", &items))?;
    print(&format!("The gallery: {}\n", index.display()))?;
    match &faults[..] {
        [] => Ok(()),
        faults => Err(Failure::stopped(faults.join("\n"))),
    }
}

fn item(model: &ModelInfo, name: &str, links: &str) -> String {
    let (title, documentation) = (escape(model.name), prose(model.documentation));
    format!(
        "<article id=\"{name}\">\n<h2>{title}</h2>\n<p>{documentation}</p>\n\
         <img src=\"{name}.svg\" alt=\"Sketch of {title}\" loading=\"lazy\">\n<ul>\n{links}</ul>\n</article>\n"
    )
}

fn sketch(entry: &SceneEntry) -> Result<String, Failure> {
    let scene = (entry.new)();
    let run = Simulation::new(scene.as_ref()).until(0.0).run().map_err(refused)?;
    Ok(drawing::sketch_within(scene.as_ref(), &run.last(), LARGEST))
}
