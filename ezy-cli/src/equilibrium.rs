//! The command `equilibrium`. Without the feature `analysis`, how to get it.

use super::Models;
use super::failure::Failure;
use super::steady_arguments::EquilibriumArguments;

#[cfg(not(feature = "analysis"))]
pub(super) fn equilibrium(_: Models<'_>, _: &EquilibriumArguments) -> Result<(), Failure> {
    Err(super::linearize::without_analysis())
}

#[cfg(feature = "analysis")]
pub(super) fn equilibrium(models: Models<'_>, arguments: &EquilibriumArguments) -> Result<(), Failure> {
    use super::equilibrium_text::{motion_text, rests_json, rests_text, with_spectrum};
    use super::failure::print;
    use super::json::print_json;
    use super::steady::Request;

    let request = Request::new(models, &arguments.steady)?;
    let info = request.info();
    if let Some(variation) = &arguments.vary {
        return super::bifurcation_diagram::print_diagram(&request, arguments, variation);
    }
    if arguments.all {
        let (rests, spectra) = request.rests()?;
        return if arguments.json {
            print_json(&rests_json(&info, &rests, &spectra))
        } else {
            print(&rests_text(&info, &rests, &spectra))
        };
    }
    let (motion, linear) = request.linearized(None)?;
    let spectrum = linear.spectrum().map_err(Failure::stopped)?;
    if arguments.json {
        let mut found = with_spectrum(&info, &motion, &spectrum);
        found["model"] = info.model.into();
        found["scene"] = info.name.into();
        return print_json(&found);
    }
    print(&motion_text(&info, &motion, &spectrum))
}
