//! The command `workspace`. Without the feature `analysis`, how to get it.

use super::Models;
use super::failure::Failure;
use super::workspace_arguments::WorkspaceArguments;

#[cfg(not(feature = "analysis"))]
pub(super) fn workspace(_: Models<'_>, _: &WorkspaceArguments) -> Result<(), Failure> {
    Err(super::linearize::without_analysis())
}

/// Places of a map at most: each takes some factorisations.
#[cfg(feature = "analysis")]
const MOST_PLACES: usize = 1_000_000;

#[cfg(feature = "analysis")]
pub(super) fn workspace(models: Models<'_>, arguments: &WorkspaceArguments) -> Result<(), Failure> {
    use super::names;
    use super::shown::Forms;
    use super::steady::Request;
    use super::workspace_text::Reached;
    use ezy_core::record::find_name;

    let WorkspaceArguments { steady, over, without, of, out, plot, json } = arguments;
    let request = Request::new(models, steady)?;
    let info = request.info();
    let coordinates = || info.coordinates.iter().map(|c| &*c.name);
    let of = of.as_ref().map(|of| find_name("coordinate", of, coordinates())).transpose()?;
    if over.len() > 2 {
        return Err(Failure::wrong_use("--over: a workspace is over one or two coordinates; hold others by --hold"));
    }
    for name in over.iter().map(|over| &over.name).chain(&steady.hold) {
        find_name("coordinate", name, coordinates())?;
    }
    let drives = || info.rows.iter().take(info.n_position_rows).filter(|row| row.kind == "drive");
    for name in without {
        let mut known: Vec<&str> = drives().map(|row| names::base(&row.name)).collect();
        known.extend(drives().map(|row| &*row.name));
        known.sort_unstable();
        known.dedup();
        find_name("drive", name, known.into_iter())?;
    }
    let forms = Forms::new("workspaces", out.as_deref(), plot.as_deref(), *json)?;
    let axes = over.iter().map(axis).collect::<Result<Vec<_>, _>>()?;
    let n: usize = axes.iter().map(|axis| axis.values.len()).product();
    if n > MOST_PLACES {
        return Err(Failure::wrong_use(format!("--over: {n} places, more than {MOST_PLACES}; give longer steps")));
    }
    let workspace = request.workspace(&axes, without)?;
    forms.show(&Reached::new(request.path(), &info, &workspace, of))
}

/// The values of a coordinate, in ascending order.
#[cfg(feature = "analysis")]
fn axis(over: &super::vary::Variation) -> Result<ezy_core::analysis::Axis, Failure> {
    let wrong = |why: &str| Failure::wrong_use(format!("--over {}: {why}", over.name));
    let values = over.values.iter().map(|value| super::value::parse_number(value)).collect::<Result<Vec<f64>, _>>();
    let mut values = values.map_err(|why| wrong(&why))?;
    values.sort_by(f64::total_cmp);
    values.dedup();
    if values.len() < 2 {
        return Err(wrong("one value is no range; write COORDINATE=START:END:STEP, such as crank.phi=0:6.28:0.02"));
    }
    Ok(ezy_core::analysis::Axis { name: over.name.clone(), values })
}
