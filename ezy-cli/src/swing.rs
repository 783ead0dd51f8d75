//! `linearize --mode N --animate FILE`: the mechanism swinging in one mode.

use std::path::Path;

use serde_json::{Value, json};

use super::animate::{Animation, Kind, N_PICTURES, Plot, Told, n_of_gif, seconds, write};
use super::failure::Failure;
use super::steady::Request;
use super::steady_arguments::LinearizeArguments;
use super::steady_text::course_text;
use ezy_core::analysis::{Mode, SteadyMotion, Swing};
use ezy_core::dynamics::State;
use ezy_core::model::{Scene, SceneInfo};
use ezy_core::record::{EnergyState, Sample, Wanted};
use ezy_core::scalar::rounded;
use ezy_study::report::drawing::{Drawing, Elements, Placed};
use ezy_study::report::table::fixed;

/// Digits of what describes.
const DIGITS: usize = 6;

/// What was written of a mode.
pub(super) struct Shown {
    kind: Kind,
    caption: String,
    json: Value,
    file: String,
}

impl Shown {
    /// The caption and the file, below the table of modes.
    pub(super) fn text(&self) -> String {
        format!("\n{}\nThe {}: {}\n", self.caption, self.kind.name(), self.file)
    }

    pub(super) fn json(self) -> Value {
        self.json
    }
}

/// A mode about its motion, in a scene.
struct Picture<'a> {
    scene: &'a dyn Scene,
    info: &'a SceneInfo,
    inputs: &'a [f64],
    elements: Elements,
    motion: &'a SteadyMotion,
    mode: &'a Mode,
    swing: Swing<'a>,
    /// Number in the table.
    number: usize,
}

/// Checks what can be checked before anything is computed.
pub(super) fn check(arguments: &LinearizeArguments) -> Result<(), Failure> {
    let Some(path) = &arguments.animate else { return Ok(()) };
    if Kind::of(path, "--animate")? == Kind::Gif {
        super::drawing::check()?;
    }
    match arguments.amplitude {
        Some(amplitude) if !(amplitude > 0.0 && amplitude.is_finite()) => Err(Failure::wrong_use(format!(
            "--amplitude {amplitude}: it is a length in m or an angle in rad above zero, by which what moves most in the mode deviates"
        ))),
        _ => Ok(()),
    }
}

/// Writes the animation that is asked for; none is without --animate.
pub(super) fn animate_mode(
    request: &Request,
    arguments: &LinearizeArguments,
    motion: &SteadyMotion,
    modes: &[Mode],
) -> Result<Option<Shown>, Failure> {
    let (Some(path), Some(number)) = (&arguments.animate, arguments.mode) else { return Ok(None) };
    let Some(mode) = number.checked_sub(1).and_then(|i| modes.get(i)) else {
        return Err(Failure::wrong_use(match modes.len() {
            0 => format!("--mode {number}: all eigenvalues are zero, and the table has no mode"),
            n => format!("--mode {number}: the table has {n} modes; give a number from 1 to {n}"),
        }));
    };
    let (scene, inputs) = request.scene_with_inputs()?;
    let (elements, info) = (Elements::new(scene.as_ref()), request.info());
    let swing = Swing::new(motion, mode);
    let (scene, info, inputs) = (scene.as_ref(), &*info, &*inputs);
    Picture { scene, info, inputs, elements, motion, mode, swing, number }.write(path, arguments.amplitude).map(Some)
}

impl Picture<'_> {
    fn write(self, path: &Path, amplitude: Option<f64>) -> Result<Shown, Failure> {
        let kind = Kind::of(path, "--animate")?;
        let still = self.placed(&self.motion.state, 0.0);
        let drawing = Drawing::new(self.scene, self.elements.clone(), &still, &[], None);
        let [_, _, width, height] = drawing.outline();
        let visible = self.swing.visible_amplitude(width.max(height) / drawing.scale).ok_or_else(|| {
            Failure::wrong_use(format!(
                "--mode {}: it moves no body, but first-order states alone; give the number of another mode",
                self.number
            ))
        })?;
        let amplitude = amplitude.unwrap_or(visible);
        let period_s = self.swing.period_s();
        let length_s = seconds(period_s);
        let n = if kind == Kind::Gif { n_of_gif(length_s) } else { N_PICTURES } as usize;
        // a GIF goes on with its first frame, others with their last
        let times = (0..if kind == Kind::Gif { n } else { n + 1 }).map(|i| period_s * i as f64 / n as f64);
        let states: Vec<(f64, State)> = times.map(|t| (t, self.swing.at(amplitude, t))).collect();
        let frames = states.iter().map(|(t, state)| self.placed(state, *t)).collect();
        let caption = self.caption(amplitude);
        let told = Told {
            title: format!(", mode {}", self.number),
            note: caption.clone(),
            origin: "Linear equations of small deviations from a steady motion".to_owned(),
            repeats: true,
            ..Told::default()
        };
        let plots = self.plots(&states);
        let animation = Animation::of_frames(self.scene, self.elements, frames, plots, told);
        write(path, kind.bytes(&animation, length_s, animation.width())?)?;
        let json = json!({
            "mode": self.number,
            "amplitude": amplitude,
            "period": period_s,
            "oscillates": self.swing.oscillates(),
            "file": path.display().to_string(),
        });
        Ok(Shown { kind, caption, json, file: path.display().to_string() })
    }

    /// A frame: a state as a sample of a run, `after_s` the first one.
    fn placed(&self, state: &State, after_s: f64) -> Placed {
        let sample = Sample {
            info: self.info,
            wanted: Wanted::default(),
            t: state.t,
            coordinates: &state.q,
            velocities: &state.v,
            accelerations: &[],
            multipliers: &[],
            inputs: self.inputs,
            states: &state.z,
            outputs: &[],
            work: &[],
            power: &[],
            energy: EnergyState::default(),
            position_residual: 0.0,
            velocity_residual: 0.0,
        };
        Placed { t: after_s, ..self.elements.at_sample(self.scene, &sample) }
    }

    /// What moves most, by its unit, less its value in the steady motion.
    fn plots(&self, states: &[(f64, State)]) -> Vec<Plot> {
        let still = &self.motion.state;
        let all = |state: &State, place: usize| state.q.iter().chain(&state.v).chain(&state.z).nth(place).copied();
        let mut plots: Vec<Plot> = Vec::new();
        for &place in &self.mode.largest {
            let (name, unit) = name_and_unit(self.info, place);
            let Some(from) = all(still, place) else { continue };
            let values = states.iter().filter_map(|(_, state)| Some(all(state, place)? - from)).collect();
            match plots.iter_mut().find(|plot| plot.unit == unit) {
                Some(plot) => plot.curves.push((name, values)),
                None => plots.push(Plot { title: "deviation".to_owned(), unit, curves: vec![(name, values)] }),
            }
        }
        plots
    }

    fn caption(&self, amplitude: f64) -> String {
        let s = self.mode.eigenvalue;
        let short = |x: f64| rounded(x, DIGITS);
        let (name, unit) = self.mode.largest.first().map(|place| name_and_unit(self.info, *place)).unwrap_or_default();
        let how = match self.swing.oscillates() {
            true => format!(
                "{} ± {}i 1/s, {} Hz: one period of {} s",
                fixed(s.re, DIGITS),
                fixed(s.im.abs(), DIGITS),
                short(self.mode.frequency_hz()),
                short(self.swing.period_s())
            ),
            false => format!("{} 1/s, without oscillation: out and back once", fixed(s.re, DIGITS)),
        };
        format!(
            "mode {}: {how}, without growth or decay; {name} deviates by {} {unit}; seen from the frame of the steady motion, {}",
            self.number,
            short(amplitude),
            course_text(self.info, self.motion)
        )
    }
}

/// Of a row of the basis.
fn name_and_unit(info: &SceneInfo, place: usize) -> (String, &'static str) {
    let states = info.states.iter().map(|state| (state.name.to_owned(), state.unit));
    let moved = info.coordinates.iter().chain(&*info.velocities).map(|of| (of.name.to_string(), of.unit));
    moved.chain(states).nth(place).unwrap_or_default()
}
