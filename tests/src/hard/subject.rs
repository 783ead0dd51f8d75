//! The scenes of the hard cases: each reference with the model that is held against it, its numbers set from the file.

use super::models::{
    coaxial, five_cranks, rotor, sliding_block, spinning_pair, spring_pendulum, three_rods, three_skates,
};
use crate::garage::{Names, case, list, load, number, number_or_zero, set, start_values};
use ezy_core::model::Scene;
use ezy_models::{
    andrews, chaplygin_sleigh, double_pendulum, four_bar, knife_edge, n_four_bar, pendulum, roller_racer, slider_crank,
    snakeboard, tractor_trailers,
};
use serde_json::Value;

/// A scene, and the reference that it is compared with.
pub struct Subject {
    /// The case of the reference, or the whole file where it has one.
    pub data: Value,
    /// Its bodies and what acts on them.
    pub block: Value,
    /// The scene, with the numbers of the reference.
    pub scene: Box<dyn Scene>,
    /// Names of bodies there and here; a body that is not listed has the same name.
    pub names: Names<'static>,
}

/// A case of a reference, and the scene that is held against it.
pub struct Entry {
    /// The file, without `.json`.
    pub file: &'static str,
    /// The case; empty for a file without cases.
    pub case: &'static str,
    /// Of the case and its `model` block.
    scene: fn(&Value, &Value) -> Box<dyn Scene>,
    names: Names<'static>,
}

const fn entry(
    file: &'static str,
    case: &'static str,
    scene: fn(&Value, &Value) -> Box<dyn Scene>,
    names: Names<'static>,
) -> Entry {
    Entry { file, case, scene, names }
}

const SAME: Names<'static> = &[];
const PLATE: Names<'static> = &[("B", "plate")];
const RODS: Names<'static> = &[("r1", "upper"), ("r2", "lower")];
const SLEIGH: Names<'static> = &[("S", "sleigh")];
const RACER: Names<'static> = &[
    ("seat", "seat"),
    ("handle", "handle"),
    ("body", "seat"),
    ("steer", "handle"),
    ("cart", "seat"),
    ("caster", "handle"),
    ("tractor", "seat"),
    ("trailer", "handle"),
];
const TRAIN: Names<'static> = &[("front", "steer"), ("car", "tractor"), ("trailer1", "first"), ("trailer2", "second")];
const LINKAGE: Names<'static> =
    &[("c0", "crank[0]"), ("c1", "crank[1]"), ("c2", "crank[2]"), ("h0", "coupler[0]"), ("h1", "coupler[1]")];

/// Every case that has a `model` block.
pub static SUBJECTS: &[Entry] = &[
    entry("torture", "mass_ratio_heavy_below", two_rods, RODS),
    entry("torture", "mass_ratio_heavy_above", two_rods, RODS),
    entry("torture", "mass_ratio_sandwich", chain_of_rods, SAME),
    entry("torture", "massless_coupler", massless_coupler, SAME),
    entry("torture", "massless_middle_link", chain_of_rods, SAME),
    entry("torture", "stiff_spring_undamped", stiff_spring, &[("M", "bob")]),
    entry("torture", "stiff_spring_damped", stiff_spring, &[("M", "bob")]),
    entry("torture", "fast_rotor_off_centre", declared::<rotor::Spin>, &[("R", "rotor")]),
    entry(
        "torture",
        "fast_counter_rotating_pair",
        declared::<spinning_pair::Flight>,
        &[("A", "first"), ("B", "second")],
    ),
    entry("torture", "inconsistent_velocities", declared::<n_four_bar::Fall>, LINKAGE),
    entry("torture", "coaxial_wheels", declared::<coaxial::Coast>, SLEIGH),
    entry("torture", "three_skates_concurrent", plate_on_skates::<three_skates::Free>, PLATE),
    entry("torture", "three_skates_locked", plate_on_skates::<three_skates::Pushed>, PLATE),
    entry("torture", "caster_trail_1e-2", racer::<roller_racer::Coast>, RACER),
    entry("torture", "caster_trail_1e-3", racer::<roller_racer::Coast>, RACER),
    entry("torture", "slider_crank_equal_lengths", declared::<sliding_block::Falling>, SAME),
    entry("torture", "five_cranks_hanging", declared::<five_cranks::Fall>, SAME),
    entry("torture", "five_cranks_from_top", declared::<five_cranks::Fall>, SAME),
    entry("torture", "driven_four_bar", driven_four_bar, SAME),
    entry("torture", "snakeboard_through_90deg", snakeboard_gait, SAME),
    entry("a01_simple_pendulum", "", declared::<pendulum::Swing>, &[("P", "bob")]),
    entry("a02_n_four_bar", "", declared::<n_four_bar::Fall>, LINKAGE),
    entry("a03_andrews", "", declared::<andrews::Squeeze>, SAME),
    entry("slider_crank_ida", "", declared::<slider_crank::Pushed>, SAME),
    entry("knife_edge_incline", "scipy_dae", blade, &[("S", "blade")]),
    entry("knife_edge_incline", "dae4py", blade, &[("S", "blade")]),
    entry("knife_edge_incline", "fast_turn", blade, &[("S", "blade")]),
    entry("chaplygin_sleigh", "bloch", sleigh, SLEIGH),
    entry("chaplygin_sleigh", "spin", sleigh, SLEIGH),
    entry("chaplygin_sleigh", "reversal", sleigh, SLEIGH),
    entry("chaplygin_sleigh", "com_behind", sleigh, SLEIGH),
    entry("snakeboard", "drive_gait", snakeboard_gait, SAME),
    entry("snakeboard", "rotate_gait", snakeboard_gait, SAME),
    entry("snakeboard", "locked_steering", snakeboard_gait, SAME),
    entry("snakeboard", "torque_driven", declared::<snakeboard::Stroked>, SAME),
    entry("roller_racer", "free_racer", racer::<roller_racer::Coast>, RACER),
    entry("roller_racer", "rowed_racer", racer::<roller_racer::Rowed>, RACER),
    entry("roller_racer", "twistcar", twistcar, RACER),
    entry("car_trailers", "locked_circle", declared::<tractor_trailers::Locked>, TRAIN),
    entry("car_trailers", "driven_slalom", declared::<tractor_trailers::Winding>, TRAIN),
    entry("car_trailers", "heavy_tractor_tractrix", racer::<roller_racer::Coast>, RACER),
];

/// The scene for a case of a file; for a file without cases the name is empty.
///
/// # Panics
/// When there is no such case: the test or program that asks for it fails.
pub fn subject(file: &str, name: &str) -> Subject {
    let entry = SUBJECTS.iter().find(|entry| (entry.file, entry.case) == (file, name));
    let entry = entry.unwrap_or_else(|| panic!("no scene for `{name}` of {file}.json"));
    let file_data = load(file);
    let data = if name.is_empty() { file_data } else { case(&file_data, name).clone() };
    let block = data.get("model").or_else(|| data.get("model_N2")).cloned().unwrap_or(Value::Null);
    let scene = (entry.scene)(&data, &block);
    Subject { data, block, scene, names: entry.names }
}

/// With the parameters of its declaration.
fn declared<S: Scene + Default + 'static>(_: &Value, _: &Value) -> Box<dyn Scene> {
    Box::new(S::default())
}

fn two_rods(_: &Value, block: &Value) -> Box<dyn Scene> {
    let [m1, m2] = [0, 1].map(|i| number(&block["bodies"][i]["mass"]));
    Box::new(double_pendulum::Swing { m1, m2, ..Default::default() })
}

fn massless_coupler(_: &Value, _: &Value) -> Box<dyn Scene> {
    Box::new(four_bar::Turning { base: 2.0, l2: 2.0, l3: 1.5, m2: 0.0, m3: 2.0, ..Default::default() })
}

fn driven_four_bar(_: &Value, block: &Value) -> Box<dyn Scene> {
    let (angle, omega) = (number(&block["drivers"][0]["c0"]), number(&block["drivers"][0]["rate"]));
    let lengths = four_bar::Driven { base: 3.0, l2: 3.0, l3: 2.5, m2: 2.0, m3: 1.5, ..Default::default() };
    Box::new(four_bar::Driven { angle, omega, swing: 0.0, ..lengths })
}

fn stiff_spring(_: &Value, block: &Value) -> Box<dyn Scene> {
    let c = number(&block["springs"][0]["c"]);
    Box::new(spring_pendulum::Swing { c, ..Default::default() })
}

fn twistcar(data: &Value, block: &Value) -> Box<dyn Scene> {
    let mut scene = racer::<roller_racer::Twistcar>(data, block);
    let (torque, torsion) = (&block["torques"][0], &block["torsion"][0]);
    let of_torque =
        [("m0", "amp"), ("omega", "freq"), ("phase", "phase")].map(|(ours, theirs)| (ours, &torque[theirs]));
    let of_torsion = [("k", "k"), ("damping", "c"), ("angle", "angle0")].map(|(ours, theirs)| (ours, &torsion[theirs]));
    for (ours, value) in of_torque.into_iter().chain(of_torsion) {
        set(&mut *scene, &[(ours, number(value))]);
    }
    scene
}

fn blade(data: &Value, _: &Value) -> Box<dyn Scene> {
    let [m, j, g, alpha] = ["m", "J", "g", "incline_alpha"].map(|name| number(&data["parameters"][name]));
    Box::new(knife_edge::Cycloid { m, j, g, alpha })
}

fn sleigh(data: &Value, _: &Value) -> Box<dyn Scene> {
    let [m, j, a] = ["m", "J", "a"].map(|name| number(&data["parameters"][name]));
    Box::new(chaplygin_sleigh::Coast { m, j, a })
}

fn chain_of_rods(_: &Value, block: &Value) -> Box<dyn Scene> {
    let mut scene = three_rods::Swing::default();
    let of = |name: &str| [0, 1, 2].map(|i| number(&block["bodies"][i][name]));
    [scene.m1, scene.m2, scene.m3] = of("mass");
    [scene.i1, scene.i2, scene.i3] = of("inertia");
    [scene.l1, scene.l2, scene.l3] = [0, 1, 2].map(|i| -2.0 * number(&block["hinges"][i]["pb"][0]));
    Box::new(scene)
}

fn plate_on_skates<S: Scene + Default + 'static>(_: &Value, block: &Value) -> Box<dyn Scene> {
    let mut scene = S::default();
    for (skate, names) in
        list(&block["skates"]).iter().zip([["x1", "y1", "h1"], ["x2", "y2", "h2"], ["x3", "y3", "h3"]])
    {
        let values = [&skate["point"][0], &skate["point"][1], &skate["heading"]].map(number);
        set(&mut scene, &[0, 1, 2].map(|k| (names[k], values[k])));
    }
    Box::new(scene)
}

/// Two bodies with a hinge and a skate each.
fn racer<S: Scene + Default + 'static>(_: &Value, block: &Value) -> Box<dyn Scene> {
    let mut scene = S::default();
    set(&mut scene, &racer_geometry(block));
    Box::new(scene)
}

/// Parameters of a roller racer by the `model` block of a reference with two bodies, a hinge and two skates.
///
/// # Panics
/// When a number is missing.
pub fn racer_geometry(block: &Value) -> [(&'static str, f64); 8] {
    let (bodies, hinge, skates) = (&block["bodies"], &block["hinges"][0], &block["skates"]);
    [
        ("a", -number(&skates[0]["point"][0])),
        ("b", number(&hinge["pa"][0])),
        ("h", -number(&hinge["pb"][0])),
        ("c", number(&skates[1]["point"][0])),
        ("m1", number(&bodies[0]["mass"])),
        ("i1", number(&bodies[0]["inertia"])),
        ("m2", number(&bodies[1]["mass"])),
        ("i2", number(&bodies[1]["inertia"])),
    ]
}

fn snakeboard_gait(_: &Value, block: &Value) -> Box<dyn Scene> {
    Box::new(gait(block))
}

/// A snakeboard whose three angles are prescribed by the drivers of a `model` block.
///
/// # Panics
/// When a number is missing.
pub fn gait(block: &Value) -> snakeboard::Serpentine {
    let mut scene = snakeboard::Serpentine::default();
    for (driver, name) in list(&block["drivers"]).iter().zip(["twist", "front", "back"]) {
        let names = [("c0", "offset"), ("rate", "rate"), ("amp", "swing"), ("freq", "nu"), ("phase", "phase")];
        for (theirs, ours) in names {
            set(&mut scene, &[(&format!("{name}_{ours}"), number(&driver[theirs]))]);
        }
    }
    scene
}

impl Subject {
    /// Name of a body of the reference in the scene.
    pub fn body<'n>(&self, theirs: &'n str) -> &'n str {
        self.names.iter().find(|(name, _)| *name == theirs).map_or(theirs, |&(_, ours)| ours)
    }

    /// Index of the first coordinate of a body of the reference.
    ///
    /// # Panics
    /// When the scene has no such body.
    pub fn first_coordinate(&self, theirs: &str) -> usize {
        let ours = self.body(theirs);
        let i = self.scene.info().bodies.iter().position(|name| *name == ours);
        3 * i.unwrap_or_else(|| panic!("no body `{ours}`"))
    }

    /// Start values of all bodies of the block, by the names of the scene.
    pub fn given(&self) -> Vec<(String, f64)> {
        let mut given = Vec::new();
        for body in list(&self.block["bodies"]) {
            let name = self.body(body["name"].as_str().unwrap_or_default());
            given.extend(start_values(body).map(|(member, value)| (format!("{name}.{member}"), number_or_zero(value))));
        }
        given
    }
}
