//! A scene as a functional mock-up unit (FMU): what its archive holds.
//!
//! The library is C: the equations that [`C`](super::Language::C) prints, `scene.h` with sizes, and `fmu.c`, which is the same for all scenes. So an
//! importer on another system can compile it from its sources.

mod description;
mod units;

use std::fmt::Write as _;

use super::c::{C, SOLVE};
use super::head::file_name;
use super::{ExportError, Source, Start, prepared};
use crate::model::{Direction, EventKind, Scene, SceneInfo};

/// Version of the standard.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Version {
    /// FMI 2.0.4.
    Two,
    /// FMI 3.0.
    Three,
}

impl Version {
    /// Its first number.
    pub const fn number(self) -> usize {
        match self {
            Self::Two => 2,
            Self::Three => 3,
        }
    }
}

/// What an archive holds besides the compiled library.
#[derive(Debug, Clone)]
pub struct Unit {
    /// Name of the library, without its ending.
    pub identifier: String,
    /// Paths in the archive with their texts; the library is compiled from `sources/fmu.c`, with `sources` as the only folder of includes.
    pub files: Vec<(String, String)>,
}

/// A unit for model exchange and co-simulation.
///
/// # Errors
/// [`ExportError`] for what cannot be exported, and for scenes whose rows are switched or whose inputs are integrated: those need a run.
pub fn unit(scene: &dyn Scene, version: Version, start: Start<'_>) -> Result<Unit, ExportError> {
    let (source, equations) = prepared(scene, start)?;
    let info = &source.info;
    if let Some(switch) = info.switches.first() {
        let row = info.rows[switch.row].name.to_string();
        return Err(ExportError::Switched { scene: info.name, row });
    }
    if let Some(&place) = info.integrated_inputs.first() {
        return Err(ExportError::IntegratedInput { scene: info.name, input: info.inputs[place].name });
    }
    let kernels = source.kernels.with_derivatives(info, equations);
    let source = Source { kernels, ..source };
    let equations = C.file(&source);
    let sizes = sizes(&source, version);
    let token = token(&[&equations, &sizes]);
    let sizes = format!("{sizes}#define TOKEN {token:?}\n");
    let identifier = file_name(&source.info);
    let mut files = vec![
        ("modelDescription.xml".to_owned(), description::description(&source, version, &identifier, &token)),
        ("sources/fmu.c".to_owned(), include_str!("fmu.c").to_owned()),
        ("sources/equations.c".to_owned(), equations),
        ("sources/scene.h".to_owned(), sizes),
        ("sources/solve.c".to_owned(), SOLVE.to_owned()),
    ];
    files.extend(match version {
        Version::Two => vec![("sources/fmi2.c".to_owned(), include_str!("fmi2.c").to_owned())],
        Version::Three => vec![
            ("sources/fmi3.c".to_owned(), include_str!("fmi3.c").to_owned()),
            ("sources/buildDescription.xml".to_owned(), description::build(&identifier)),
        ],
    });
    Ok(Unit { identifier, files })
}

/// What the sources say, as a token that the description and the library have in common (FNV-1a, 128 bits).
fn token(texts: &[&str]) -> String {
    const START: u128 = 0x6c62_272e_07bb_0142_62b8_2175_6295_c58d;
    const PRIME: u128 = 0x0000_0000_0100_0000_0000_0000_0000_013b;
    let bytes = texts.iter().flat_map(|text| text.bytes());
    let hash = bytes.fold(START, |hash, byte| (hash ^ u128::from(byte)).wrapping_mul(PRIME));
    let hex = format!("{hash:032x}");
    format!("{{{}-{}-{}-{}-{}}}", &hex[..8], &hex[8..12], &hex[12..16], &hex[16..20], &hex[20..])
}

/// The sizes of a scene, and which arguments its functions take.
fn sizes(source: &Source<'_>, version: Version) -> String {
    let (info, kernels) = (&source.info, &source.kernels);
    let pivots = kernels.pivot.as_ref().map_or(0, |kernel| kernel.returned[0].values.len());
    let sizes = [
        ("FMI", version.number()),
        ("N_P", info.parameters.len()),
        ("N_U", info.n_inputs()),
        ("N_Q", info.n_coordinates()),
        ("N_V", info.n_velocities()),
        ("N_Z", info.n_states()),
        ("N_CONSTANTS", info.n_constants),
        ("N_ROWS", info.n_rows()),
        ("N_POSITION_ROWS", info.n_position_rows),
        ("N_OUTPUTS", info.n_outputs()),
        ("N_EVENTS", info.events.len()),
        ("N_PIVOTS", pivots),
        ("HAS_DERIVATIVES", usize::from(kernels.derivatives.is_some())),
    ];
    let letters =
        |groups: Vec<super::kernels::Group>| groups.iter().map(|group| group.letter()).collect::<Vec<_>>().join(", ");
    let mut text = "/* Sizes of the scene, and the arguments of its functions. */\n".to_owned();
    for (name, n) in sizes {
        let _ = writeln!(text, "#define {name} {n}");
    }
    let _ = writeln!(text, "#define SCENE_NAME \"{}/{}\"", info.model, info.name);
    let _ = writeln!(text, "#define CALL(function) {}_##function", file_name(info));
    let _ = writeln!(text, "#define ARGUMENTS {}", letters(kernels.variables.of_motion()));
    let _ = writeln!(text, "#define SEEDS {}", letters(kernels.variables.seeds()));
    let _ = writeln!(text, "#define START_TIME {:?}", source.start.t);
    let _ =
        writeln!(text, "/* Of each event function: 1 ends the scene where it rises through zero, 2 where it falls. */");
    let ends: Vec<String> = info.events.iter().map(|event| ends(event.kind, event.direction).to_string()).collect();
    let _ = writeln!(text, "#define ENDS {{{}}}", ends.join(", "));
    text
}

/// In which direction a root ends the scene.
const fn ends(kind: EventKind, direction: Direction) -> u8 {
    match (kind, direction) {
        (EventKind::End, Direction::Rising) => 1,
        (EventKind::End, Direction::Falling) => 2,
        (EventKind::End, Direction::Either) => 3,
        _ => 0,
    }
}

/// What each value of a unit is called, in the order of its references: the time, parameters, inputs, states, their derivatives, multipliers, outputs,
/// event functions.
fn value_names(info: &SceneInfo) -> Vec<String> {
    let owned = |name: &str| name.to_owned();
    let states = || {
        let of_motion = info.coordinates.iter().chain(&*info.velocities).map(|of| of.name.to_string());
        of_motion.chain(info.states.iter().map(|of| owned(of.name)))
    };
    std::iter::once(owned("time"))
        .chain(info.parameters.iter().chain(info.inputs).map(|of| owned(of.name)))
        .chain(states())
        .chain(states().map(|name| format!("der({name})")))
        .chain(info.rows.iter().map(|row| format!("multiplier.{}", row.name)))
        .chain(info.outputs.iter().map(|of| of.name.to_string()))
        .chain((1..=info.events.len()).map(|i| format!("event[{i}]")))
        .collect()
}
