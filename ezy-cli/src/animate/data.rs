//! What the page of an animation shows, as numbers.

use std::sync::Arc;

use serde_json::{Value, json};

use ezy_core::integrate::Method;
use ezy_core::model::coordinate::{body_and_component, is_angle, place};
use ezy_core::model::{ElementInfo, LoadKind, Scene, SceneInfo};
use ezy_core::record::Sample;
use ezy_core::simulate::Run;
use ezy_study::report::drawing::{Anchor, Drawing, Elements, Film, Motion, Placed};

/// Forces are drawn up to so many elements.
pub(super) const MOST_ARROWS: usize = 60;

/// A motion, ready to be shown.
pub(crate) struct Animation {
    info: Arc<SceneInfo>,
    pub(super) drawing: Drawing,
    frames: Vec<Placed>,
    parameters: Vec<f64>,
    arrows: Vec<Arrow>,
    plots: Vec<Plot>,
    /// Names and times.
    events: Vec<(String, f64)>,
    told: Told,
}

/// What is told beside the picture, in words.
#[derive(Default)]
pub(crate) struct Told {
    /// Behind the names of model and scene.
    pub title: String,
    /// Above the picture.
    pub note: String,
    /// Whether the note is a warning.
    pub is_warning: bool,
    /// How it was computed.
    pub origin: String,
    /// Whether the motion ends as it begins, and is played over and over.
    pub repeats: bool,
}

/// Curves over the frames.
pub(crate) struct Plot {
    pub title: String,
    pub unit: &'static str,
    /// A name and a value for each frame.
    pub curves: Vec<(String, Vec<f64>)>,
}

/// A force or a torque on a body.
struct Arrow {
    name: String,
    is_reaction: bool,
    unit: &'static str,
    /// `None`: at the centre of mass of the body.
    at: Option<Anchor>,
    body: usize,
    /// By frames: x and y, or the torque alone.
    values: Vec<Vec<f64>>,
}

impl Animation {
    /// Of a run.
    pub(super) fn new(scene: &dyn Scene, run: &Run, method: Method) -> Self {
        let elements = Elements::new(scene);
        let frames: Vec<Placed> = run.samples().map(|sample| elements.at_sample(scene, &sample)).collect();
        let arrows = arrows(scene, run, &elements, &frames);
        let events = run.events().iter().map(|event| (event.event.name.to_owned(), event.state.t)).collect();
        let is_warning = !run.outcome.reached_end();
        let note = if is_warning { format!("The run {}.", run.outcome) } else { String::new() };
        let origin = format!("{}; the run {}.", told(method), run.outcome);
        let told = Told { note, is_warning, origin, ..Told::default() };
        Self { arrows, events, ..Self::of_frames(scene, elements, frames, plots(run), told) }
    }

    /// Of frames, of which there is one at least, without forces.
    pub(crate) fn of_frames(
        scene: &dyn Scene,
        elements: Elements,
        frames: Vec<Placed>,
        plots: Vec<Plot>,
        told: Told,
    ) -> Self {
        let drawing = Drawing::new(scene, elements, &frames[0], &frames, None);
        let (info, parameters) = (scene.info(), scene.parameters());
        Self { info, drawing, frames, parameters, arrows: Vec::new(), plots, events: Vec::new(), told }
    }

    pub(super) fn info(&self) -> &SceneInfo {
        &self.info
    }

    pub(super) fn told(&self) -> &Told {
        &self.told
    }

    /// The first frame.
    pub(super) fn start(&self) -> &Placed {
        &self.frames[0]
    }

    /// Pixels across a GIF, unless others are asked for.
    #[cfg(feature = "analysis")]
    pub(crate) fn width(&self) -> u32 {
        self.film().width()
    }

    /// The motion as pictures.
    pub(super) fn film(&self) -> Film<'_> {
        let info = self.info();
        Film::new(&self.drawing, &self.frames, &format!("{}, scene {}{}", info.model, info.name, self.told.title))
    }

    /// Names, units and values of the parameters.
    pub(super) fn parameters(&self) -> impl Iterator<Item = (&str, f64, &str, &str)> {
        let infos = self.info().parameters.iter().zip(&self.parameters);
        infos.map(|(info, &value)| (info.name, value, info.unit, info.documentation))
    }

    /// All of it as one object.
    pub(super) fn json(&self) -> Value {
        let info = self.info();
        let scale = self.drawing.scale;
        // a hundredth of a pixel
        let digits = (100.0 * scale).log10().ceil() as i32;
        let length = |x: f64| round(x, digits);
        let pose = |i: usize, component: usize| -> Vec<f64> {
            let place = place(i, component);
            let digits = if is_angle(place) { 4 } else { digits };
            self.frames.iter().map(|frame| round(frame.q[place], digits)).collect()
        };
        let poses: Vec<Value> =
            (0..info.drawn_bodies().len()).map(|i| json!([pose(i, 0), pose(i, 1), pose(i, 2)])).collect();
        let mut anchors: Vec<Anchor> =
            self.drawing.anchors().chain(self.arrows.iter().filter_map(|arrow| arrow.at)).collect();
        anchors.sort_unstable();
        anchors.dedup();
        let index = |anchor: &Anchor| anchors.binary_search(anchor).unwrap_or(0);
        let anchor = |anchor: &Anchor| {
            let all: Vec<[f64; 2]> = self.frames.iter().map(|frame| frame.local(*anchor).map(length)).collect();
            let body = anchor.body.map_or(-1, |body| body as i64);
            if all.iter().all(|other| *other == all[0]) {
                json!([body, all[0][0], all[0][1]])
            } else {
                json!([body, all])
            }
        };
        let parts = self.drawing.parts.iter().map(|part| match &part.motion {
            Motion::Body(i) => json!(["body", i]),
            Motion::At { point, along } => json!(["at", index(point), along.as_ref().map(index)]),
            Motion::Span { from, to } => json!(["span", index(from), index(to)]),
        });
        let parts: Vec<Value> = parts.collect();
        let arrows = self.arrows.iter().map(|arrow| {
            let digits = digits_of(arrow.values.iter().flatten());
            let values = arrow.values.iter().map(|value| value.iter().map(|x| round(*x, digits)).collect::<Vec<_>>());
            json!({
                "name": arrow.name, "reaction": arrow.is_reaction, "unit": arrow.unit, "body": arrow.body,
                "at": arrow.at.as_ref().map(index), "values": values.collect::<Vec<_>>(),
            })
        });
        let arrows: Vec<Value> = arrows.collect();
        let points = self.drawing.elements.iter().filter(|(_, element)| matches!(element.kind, "point" | "hinge"));
        let points = points.map(|(i, element)| json!([element.name, index(&self.drawing.elements.point(i, 0))]));
        let points: Vec<Value> = points.take(MOST_ARROWS).collect();
        json!({
            "t": self.frames.iter().map(|frame| frame.t).collect::<Vec<_>>(),
            "repeats": self.told.repeats,
            "scale": scale,
            "bodies": info.drawn_bodies(),
            "poses": poses,
            "anchors": anchors.iter().map(anchor).collect::<Vec<_>>(),
            "parts": parts,
            "points": points,
            "arrows": arrows,
            "plots": self.plots.iter().map(Plot::json).collect::<Vec<_>>(),
            "events": self.events,
        })
    }
}

impl Plot {
    fn json(&self) -> Value {
        let Self { title, unit, curves } = self;
        let curves = curves.iter().map(|(name, values)| {
            let digits = digits_of(values.iter());
            let values: Vec<f64> = values.iter().map(|x| round(*x, digits)).collect();
            json!({ "name": name, "values": values })
        });
        json!({ "title": title, "unit": unit, "curves": curves.collect::<Vec<_>>() })
    }
}

/// Curves by unit: energies, then outputs.
fn plots(run: &Run) -> Vec<Plot> {
    let info = run.info();
    let curve = |name: &str, value: &dyn Fn(&Sample<'_>) -> f64| {
        (name.to_owned(), run.samples().map(|sample| value(&sample)).collect())
    };
    let mut energies = vec![curve("kinetic", &|sample| sample.energy.kinetic)];
    if run.samples().any(|sample| sample.energy.potential != 0.0) {
        energies.push(curve("potential", &|sample| sample.energy.potential));
    }
    if info.n_effects() > 0 && run.samples().any(|sample| sample.energy.work.is_finite()) {
        energies.push(curve("work", &|sample| sample.energy.work));
    }
    let mut plots = vec![Plot { title: "energy".to_owned(), unit: "J", curves: energies }];
    for (i, output) in info.outputs.iter().enumerate().take(MOST_PLOTS) {
        let curves = vec![curve(&output.name, &|sample| sample.outputs[i])];
        plots.push(Plot { title: output.name.to_string(), unit: output.unit, curves });
    }
    plots
}

/// A method in words.
fn told(method: Method) -> String {
    let name = method.name();
    match method.step_s() {
        Some(step_s) => format!("{name}, steps of {step_s} s"),
        None => format!("{name}, tolerance {:e}", method.setting()),
    }
}

/// Outputs that have a plot.
const MOST_PLOTS: usize = 12;

/// Rounded to a number of decimals, so that it prints short.
fn round(x: f64, digits: i32) -> f64 {
    if !x.is_finite() {
        return 0.0;
    }
    let factor = 10f64.powi(digits.clamp(-12, 12));
    let rounded = (x * factor).round() / factor;
    if rounded == 0.0 { 0.0 } else { rounded }
}

/// Decimals that show a curve to a few parts in a hundred thousand of its largest value.
fn digits_of<'a>(values: impl Iterator<Item = &'a f64>) -> i32 {
    let largest = values.filter(|x| x.is_finite()).fold(0.0_f64, |largest, x| largest.max(x.abs()));
    if largest > 0.0 { 4 - largest.log10().floor() as i32 } else { 0 }
}

fn arrows(scene: &dyn Scene, run: &Run, elements: &Elements, frames: &[Placed]) -> Vec<Arrow> {
    let info = scene.info();
    let mut all = Vec::new();
    let named = |i: usize, element: &ElementInfo| -> Option<(usize, Anchor)> {
        let k = element.points.iter().position(|point| point.body.is_some())?;
        Some((element.points[k].body?, elements.point(i, k)))
    };
    let mut reactions = Vec::new();
    for (i, element) in elements.iter() {
        if let Some((body, kind)) = element.load {
            let first = elements.load(i);
            let (unit, n) = match kind {
                LoadKind::Force => ("N", 2),
                LoadKind::Torque => ("N*m", 1),
            };
            let at = match kind {
                LoadKind::Force => named(i, element).map(|(_, at)| at),
                LoadKind::Torque => elements.joint_of(element),
            };
            let values = frames.iter().map(|frame| frame.values[first..first + n].to_vec()).collect();
            all.push(Arrow { name: element.kind.to_owned(), is_reaction: false, unit, at, body, values });
        } else if let Some((body, at)) = named(i, element) {
            let prefix = format!("{}.", element.name);
            let is_own = |name: &str| name == element.name || name.starts_with(&prefix);
            let rows: Vec<usize> = (0..info.n_rows()).filter(|&row| is_own(&info.rows[row].name)).collect();
            if !rows.is_empty() {
                reactions.push((element.name.to_string(), rows, body, at));
            }
        }
    }
    if all.len() + reactions.len() > MOST_ARROWS {
        return Vec::new();
    }
    let mut values = vec![Vec::new(); reactions.len()];
    let mut jacobian = vec![0.0; info.jacobian.n_nonzeros()];
    let mut c = elements.constants().to_vec();
    for sample in run.samples() {
        c[..info.n_inputs()].copy_from_slice(sample.inputs);
        c[info.n_inputs()..][..info.n_states()].copy_from_slice(sample.states);
        scene.velocity_jacobian(&c, sample.t, sample.coordinates, &mut jacobian);
        for ((_, rows, body, _), values) in reactions.iter().zip(&mut values) {
            // the reaction on the bodies is −Gᵀ λ
            let mut force = vec![0.0; 2];
            for (k, row, column) in info.jacobian.entries() {
                let (of, component) = body_and_component(column);
                if rows.contains(&row) && of == *body && !is_angle(column) {
                    force[component] -= jacobian[k] * sample.multipliers[row];
                }
            }
            values.push(force);
        }
    }
    for ((name, _, body, at), values) in reactions.into_iter().zip(values) {
        all.push(Arrow { name, is_reaction: true, unit: "N", at: Some(at), body, values });
    }
    all
}
