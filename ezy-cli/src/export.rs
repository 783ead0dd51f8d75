//! The command `export`. Without the feature of this name, how to get it.

use super::Models;
use super::export_arguments::ExportArguments;
use super::failure::Failure;

#[cfg(not(feature = "export"))]
pub(super) fn export(_: Models<'_>, _: &ExportArguments) -> Result<(), Failure> {
    Err(Failure::wrong_use(
        "this program was built without export; add \"export\" to the features of ezy-cli in Cargo.toml: \
         ezy-cli = { …, features = [\"export\"] }",
    ))
}

#[cfg(feature = "export")]
pub(super) use with_languages::export;

#[cfg(feature = "export")]
mod with_languages {
    use std::path::PathBuf;

    use super::super::animate::write;
    use super::super::export_arguments::{Fmi, Target};
    use super::super::export_unit::archive;
    use super::super::failure::print;
    use super::super::motion::refused;
    use super::super::names::{check_assignments, scene_with};
    use super::super::out_path::{check_ending, check_folder_name};
    use super::super::selection::find;
    use super::super::show;
    use super::{ExportArguments, Failure, Models};
    use ezy_core::export::fmu::{self, Version};
    use ezy_core::export::{Language, Start, file_name, source};
    use ezy_core::model::{ModelInfo, SceneEntry};
    use ezy_core::simulate::Simulation;

    pub(crate) fn export(models: Models<'_>, arguments: &ExportArguments) -> Result<(), Failure> {
        let selection = find(models, &arguments.path)?;
        let scenes: Vec<&SceneEntry> =
            selection.scene.map_or_else(|| selection.model.scenes.iter().collect(), |scene| vec![scene]);
        let ending = ending(arguments.to);
        let mut told = String::new();
        for entry in scenes {
            let file = format!("{}.{ending}", file_name(&(entry.info)()));
            let path = match (&arguments.out, selection.scene) {
                (None, _) => PathBuf::from("out").join(file),
                (Some(folder), None) => {
                    check_folder_name(folder)?;
                    folder.join(file)
                }
                (Some(path), Some(_)) => {
                    check_ending(path, "these equations", &[ending])?;
                    path.clone()
                }
            };
            let (bytes, remark) = content(selection.model, entry, arguments)?;
            write(&path, bytes)?;
            told += &format!("{}{remark}\n", path.display());
        }
        print(&told)
    }

    const fn ending(target: Target) -> &'static str {
        match language(target) {
            Some(language) => language.ending(),
            None if matches!(target, Target::Fmu) => "fmu",
            None => "tex",
        }
    }

    const fn language(target: Target) -> Option<Language> {
        Some(match target {
            Target::C => Language::C,
            Target::Numpy => Language::Numpy,
            Target::Julia => Language::Julia,
            Target::Matlab => Language::Matlab,
            Target::Sympy => Language::Sympy,
            Target::Casadi => Language::Casadi,
            Target::Fmu | Target::Latex => return None,
        })
    }

    /// The file of a scene, which starts where a run does, and what is told behind its name.
    fn content(
        model: &'static ModelInfo,
        entry: &'static SceneEntry,
        arguments: &ExportArguments,
    ) -> Result<(Vec<u8>, String), Failure> {
        check_assignments(model, entry, &arguments.start, &[])?;
        let scene = scene_with(model, entry, &arguments.set)?;
        if arguments.to == Target::Latex {
            return Ok((show::latex_document(&scene.info()).into_bytes(), String::new()));
        }
        let simulation = Simulation::new(scene.as_ref()).until(0.0);
        let mut given = arguments.start.iter().fold(simulation, |run, start| run.start(&start.name, start.value));
        if arguments.project_start {
            given = given.project_start();
        }
        let run = given.run().map_err(refused)?;
        let start = run.last();
        let start = Start { t: start.t, q: start.coordinates, v: start.velocities };
        if let Some(language) = language(arguments.to) {
            let text = source(scene.as_ref(), language, start).map_err(Failure::wrong_use)?;
            return Ok((text.into_bytes(), String::new()));
        }
        let version = match arguments.fmi {
            Fmi::Two => Version::Two,
            Fmi::Three => Version::Three,
        };
        let unit = fmu::unit(scene.as_ref(), version, start).map_err(Failure::wrong_use)?;
        let (bytes, system) = archive(&unit, version)?;
        let remark = match system {
            Some(system) => format!(": FMI {}.0, with a library for {system}", version.number()),
            None => format!(
                ": FMI {}.0, with sources alone, since there is no C compiler `cc` (or CC) here; some importers compile them",
                version.number()
            ),
        };
        Ok((bytes, remark))
    }
}
