//! The columns of a sample, by name and unit.

use super::{UnknownName, Wanted, find_name};
use crate::model::SceneInfo;

/// One column of a sample.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Column {
    /// `t`, `seat.x`, `seat.vx`, `seat.ax`, `lambda.rear`, `work.pump`, `kinetic`, …
    pub name: String,
    /// SI unit.
    pub unit: String,
}

impl Column {
    fn new(name: impl Into<String>, unit: impl Into<String>) -> Self {
        Self { name: name.into(), unit: unit.into() }
    }
}

/// Name of the forces with a potential among the powers.
pub const POTENTIAL: &str = "potential";

/// The columns of every sample of a scene, in the order in which a sample stores them.
///
/// Time; coordinates; velocities; accelerations (`body.ax`, `body.ay`, `body.alpha`); multipliers (`lambda.<row>`);
/// inputs (`input.<name>`); first-order states (`state.<name>`); outputs (`output.<name>`), if wanted; work of each effect (`work.<effect>`) and total
/// `work`, if wanted; power of each effect (`power.<effect>`) and `power.potential`, if wanted; `kinetic`, `potential`; `balance`, if work is wanted; `residual.position` and
/// `residual.velocity`.
pub fn columns(info: &SceneInfo, wanted: Wanted) -> Vec<Column> {
    let mut all = vec![Column::new("t", "s")];
    all.extend(info.coordinates.iter().chain(&*info.velocities).map(|c| Column::new(&*c.name, c.unit)));
    all.extend(info.velocities.iter().map(|v| Column::new(acceleration_name(&v.name), format!("{}^2", v.unit))));
    all.extend(info.rows.iter().map(|r| Column::new(format!("lambda.{}", r.name), r.multiplier_unit)));
    all.extend(info.inputs.iter().map(|i| Column::new(format!("input.{}", i.name), i.unit)));
    all.extend(info.states.iter().map(|z| Column::new(format!("state.{}", z.name), z.unit)));
    if wanted.outputs {
        all.extend(info.outputs.iter().map(|o| Column::new(format!("output.{}", o.name), o.unit)));
    }
    if wanted.work {
        all.extend(info.effects.iter().map(|e| Column::new(format!("work.{}", e.name), "J")));
    }
    if wanted.power {
        let names = info.effects.iter().map(|effect| effect.name).chain([POTENTIAL]);
        all.extend(names.map(|name| Column::new(format!("power.{name}"), "W")));
    }
    let energies = ["work", "kinetic", "potential", "balance"].into_iter();
    let energies = energies.filter(|name| wanted.work || !matches!(*name, "work" | "balance"));
    all.extend(energies.map(|name| Column::new(name, "J")));
    // hinges leave metres (and metres a second), other rows may leave radians: the largest of a mixture has no unit
    all.extend(["residual.position", "residual.velocity"].map(|name| Column::new(name, "")));
    all
}

/// Place of a column among those of a sample.
///
/// # Errors
/// [`UnknownName`] with the most similar column, or with what the run should have been asked for.
pub(crate) fn column_index(info: &SceneInfo, wanted: Wanted, name: &str) -> Result<usize, UnknownName> {
    let has = |wanted: Wanted| columns(info, wanted).iter().any(|column| column.name == name);
    let remedy = || {
        let asked = [
            ("work", Wanted { work: true, ..wanted }),
            ("outputs", Wanted { outputs: true, ..wanted }),
            ("power", Wanted { power: true, ..wanted }),
        ];
        asked.into_iter().find(|(_, wanted)| has(*wanted)).map(|(word, _)| word)
    };
    let all = columns(info, wanted);
    let found = find_name("column", name, all.iter().map(|column| column.name.as_str()));
    found.map_err(|unknown| UnknownName { remedy: remedy(), ..unknown })
}

/// `seat.vx` becomes `seat.ax`, `seat.omega` becomes `seat.alpha`, `top.omega_x` becomes `top.alpha_x`.
fn acceleration_name(velocity_name: &str) -> String {
    let (body, component) = velocity_name.rsplit_once('.').unwrap_or(("", velocity_name));
    match (component.strip_prefix("omega"), component.strip_prefix('v')) {
        (Some(axis), _) => format!("{body}.alpha{axis}"),
        (None, Some(axis)) => format!("{body}.a{axis}"),
        (None, None) => format!("{body}.a_{component}"),
    }
}
