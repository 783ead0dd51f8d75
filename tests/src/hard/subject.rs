//! The scenes of the hard cases: each reference with the model that is held against it, its numbers set from the file.

use super::{cranks, rods, skates, slider, spin, springs};
use crate::garage::{Names, case, list, load, number, number_or_zero, set};
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

/// Files with cases, and the cases that have a `model` block.
pub const SUBJECTS: &[(&str, &[&str])] = &[
    (
        "torture",
        &[
            "mass_ratio_heavy_below",
            "mass_ratio_heavy_above",
            "mass_ratio_sandwich",
            "massless_coupler",
            "massless_middle_link",
            "stiff_spring_undamped",
            "stiff_spring_damped",
            "fast_rotor_off_centre",
            "fast_counter_rotating_pair",
            "inconsistent_velocities",
            "coaxial_wheels",
            "three_skates_concurrent",
            "three_skates_locked",
            "caster_trail_1e-2",
            "caster_trail_1e-3",
            "slider_crank_equal_lengths",
            "five_cranks_hanging",
            "five_cranks_from_top",
            "driven_four_bar",
            "snakeboard_through_90deg",
        ],
    ),
    ("a01_simple_pendulum", &[""]),
    ("a02_n_four_bar", &[""]),
    ("a03_andrews", &[""]),
    ("slider_crank_ida", &[""]),
    ("knife_edge_incline", &["scipy_dae", "dae4py", "fast_turn"]),
    ("chaplygin_sleigh", &["bloch", "spin", "reversal", "com_behind"]),
    ("snakeboard", &["drive_gait", "rotate_gait", "locked_steering", "torque_driven"]),
    ("roller_racer", &["free_racer", "rowed_racer", "twistcar"]),
    ("car_trailers", &["locked_circle", "driven_slalom", "heavy_tractor_tractrix"]),
];

/// The scene for a case of a file; for a file without cases the name is empty.
///
/// # Panics
/// When there is no such case: the test or program that asks for it fails.
pub fn subject(file: &str, name: &str) -> Subject {
    let file_data = load(file);
    let data = if name.is_empty() { file_data.clone() } else { case(&file_data, name).clone() };
    let block = data.get("model").or_else(|| data.get("model_N2")).cloned().unwrap_or(Value::Null);
    let (scene, names) = scene_of(file, name, &data, &block);
    Subject { data, block, scene, names }
}

fn scene_of(file: &str, name: &str, data: &Value, block: &Value) -> (Box<dyn Scene>, Names<'static>) {
    match (file, name) {
        (_, "mass_ratio_heavy_below" | "mass_ratio_heavy_above") => {
            let mut scene = double_pendulum::Swing::default();
            [scene.m1, scene.m2] = [0, 1].map(|i| number(&block["bodies"][i]["mass"]));
            (Box::new(scene), &[("r1", "upper"), ("r2", "lower")])
        }
        (_, "mass_ratio_sandwich" | "massless_middle_link") => (Box::new(three_rods(block)), &[]),
        (_, "massless_coupler") => {
            let scene = four_bar::Turning { base: 2.0, l2: 2.0, l3: 1.5, m2: 0.0, m3: 2.0, ..Default::default() };
            (Box::new(scene), &[])
        }
        (_, "driven_four_bar") => {
            let (angle, omega) = (number(&block["drivers"][0]["c0"]), number(&block["drivers"][0]["rate"]));
            let lengths = four_bar::Driven { base: 3.0, l2: 3.0, l3: 2.5, m2: 2.0, m3: 1.5, ..Default::default() };
            (Box::new(four_bar::Driven { angle, omega, swing: 0.0, ..lengths }), &[])
        }
        (_, "stiff_spring_undamped" | "stiff_spring_damped") => {
            let c = number(&block["springs"][0]["c"]);
            (Box::new(springs::spring_pendulum::Swing { c, ..Default::default() }), &[("M", "bob")])
        }
        (_, "fast_rotor_off_centre") => (Box::new(spin::rotor::Spin::default()), &[("R", "rotor")]),
        (_, "fast_counter_rotating_pair") => {
            (Box::new(spin::spinning_pair::Flight::default()), &[("A", "first"), ("B", "second")])
        }
        (_, "coaxial_wheels") => (Box::new(skates::coaxial::Coast::default()), &[("S", "sleigh")]),
        (_, "three_skates_concurrent") => {
            (three_skates(skates::three_skates::Free::default(), block), &[("B", "plate")])
        }
        (_, "three_skates_locked") => (three_skates(skates::three_skates::Pushed::default(), block), &[("B", "plate")]),
        (_, "slider_crank_equal_lengths") => (Box::new(slider::sliding_block::Falling::default()), &[]),
        (_, "five_cranks_hanging" | "five_cranks_from_top") => (Box::new(cranks::five_cranks::Fall::default()), &[]),
        (_, "inconsistent_velocities") | ("a02_n_four_bar", _) => (Box::new(n_four_bar::Fall::default()), LINKAGE),
        (_, "snakeboard_through_90deg" | "drive_gait" | "rotate_gait" | "locked_steering") => {
            (Box::new(gait(block)), &[])
        }
        (_, "torque_driven") => (Box::new(snakeboard::Stroked::default()), &[]),
        (_, "caster_trail_1e-2" | "caster_trail_1e-3" | "free_racer" | "heavy_tractor_tractrix") => {
            (racer(roller_racer::Coast::default(), block), RACER)
        }
        (_, "rowed_racer") => (racer(roller_racer::Rowed::default(), block), RACER),
        (_, "twistcar") => {
            let (torque, torsion) = (&block["torques"][0], &block["torsion"][0]);
            let mut scene = racer(roller_racer::Twistcar::default(), block);
            let of = |value: &Value, names: [(&'static str, &str); 3]| {
                names.map(|(ours, theirs)| (ours, number(&value[theirs])))
            };
            set(&mut *scene, &of(torque, [("m0", "amp"), ("omega", "freq"), ("phase", "phase")]));
            set(&mut *scene, &of(torsion, [("k", "k"), ("damping", "c"), ("angle", "angle0")]));
            (scene, RACER)
        }
        (_, "locked_circle") => (Box::new(tractor_trailers::Locked::default()), TRAIN),
        (_, "driven_slalom") => (Box::new(tractor_trailers::Winding::default()), TRAIN),
        ("a01_simple_pendulum", _) => (Box::new(pendulum::Swing::default()), &[("P", "bob")]),
        ("a03_andrews", _) => (Box::new(andrews::Squeeze::default()), &[]),
        ("slider_crank_ida", _) => (Box::new(slider_crank::Pushed::default()), &[]),
        ("knife_edge_incline", _) => {
            let p = |name: &str| number(&data["parameters"][name]);
            let scene = knife_edge::Cycloid { m: p("m"), j: p("J"), g: p("g"), alpha: p("incline_alpha") };
            (Box::new(scene), &[("S", "blade")])
        }
        ("chaplygin_sleigh", _) => {
            let p = |name: &str| number(&data["parameters"][name]);
            (Box::new(chaplygin_sleigh::Coast { m: p("m"), j: p("J"), a: p("a") }), &[("S", "sleigh")])
        }
        _ => panic!("no scene for `{name}` of {file}.json"),
    }
}

fn three_rods(block: &Value) -> rods::three_rods::Swing {
    let mut scene = rods::three_rods::Swing::default();
    let of = |name: &str| [0, 1, 2].map(|i| number(&block["bodies"][i][name]));
    [scene.m1, scene.m2, scene.m3] = of("mass");
    [scene.i1, scene.i2, scene.i3] = of("inertia");
    [scene.l1, scene.l2, scene.l3] = [0, 1, 2].map(|i| -2.0 * number(&block["hinges"][i]["pb"][0]));
    scene
}

fn three_skates(mut scene: impl Scene + 'static, block: &Value) -> Box<dyn Scene> {
    for (skate, names) in
        list(&block["skates"]).iter().zip([["x1", "y1", "h1"], ["x2", "y2", "h2"], ["x3", "y3", "h3"]])
    {
        let values = [&skate["point"][0], &skate["point"][1], &skate["heading"]].map(number);
        set(&mut scene, &[0, 1, 2].map(|k| (names[k], values[k])));
    }
    Box::new(scene)
}

/// Two bodies with a hinge and a skate each.
fn racer(mut scene: impl Scene + 'static, block: &Value) -> Box<dyn Scene> {
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
            for (member, value) in [
                ("x", &body["com"][0]),
                ("y", &body["com"][1]),
                ("phi", &body["angle"]),
                ("vx", &body["vel"][0]),
                ("vy", &body["vel"][1]),
                ("omega", &body["omega"]),
            ] {
                given.push((format!("{name}.{member}"), number_or_zero(value)));
            }
        }
        given
    }
}
