//! The examples of help, in the names of the program's own models.

use super::Models;
use super::selection::{first_scene, path, typed};
use ezy_core::model::coordinate::is_angle;
use ezy_core::model::{SceneEntry, SceneInfo};
use ezy_core::scalar::rounded;
use std::sync::Arc;

/// Examples: commands, each with what it does.
pub(super) struct Examples {
    program: String,
    /// The first model as it is typed.
    model: String,
    /// Its first scene: as it is typed, its file, and what it knows.
    scene: String,
    file: String,
    info: Option<Arc<SceneInfo>>,
    /// A coordinate of it, an angle where there is one, and its velocity.
    column: String,
    velocity: String,
    /// The first scene with an input, and the input.
    input: Option<(String, &'static str)>,
    /// The first scene with a drive.
    driven: Option<String>,
}

impl Examples {
    pub(super) fn new(program: &str, models: Models<'_>) -> Self {
        let first = first_scene(models);
        let entries = models.iter().flat_map(|&model| model.scenes.iter().map(move |entry| (model, entry)));
        let info = |entry: &SceneEntry| (entry.info)();
        let coordinate = first.and_then(|(_, entry)| {
            let info = info(entry);
            let mut coordinates = info.coordinates.iter().zip(&*info.velocities);
            let angle = coordinates.find(|(coordinate, _)| coordinate.is_angle());
            angle.map(|(angle, rate)| (angle.name.to_string(), rate.name.to_string()))
        });
        let (column, velocity) = coordinate.unwrap_or_else(|| ("BODY.phi".to_owned(), "BODY.omega".to_owned()));
        let has_drive = |entry: &SceneEntry| info(entry).rows.iter().any(|row| row.kind == "drive");
        let driven = entries.clone().find(|(_, entry)| has_drive(entry)).map(|(model, entry)| path(model, entry));
        let input = entries.filter_map(|(model, entry)| Some((path(model, entry), info(entry).inputs.first()?.name)));
        Self {
            program: program.to_owned(),
            model: first.map_or("MODEL".to_owned(), |(model, _)| typed(model.name)),
            scene: first.map_or("MODEL/SCENE".to_owned(), |(model, entry)| path(model, entry)),
            file: first.map_or("motion.csv".to_owned(), |(_, entry)| format!("{}.csv", entry.name)),
            info: first.map(|(_, entry)| info(entry)),
            input: { input }.next(),
            driven,
            column,
            velocity,
        }
    }

    pub(super) fn of_program(&self) -> String {
        let Self { model, scene, file, .. } = self;
        self.lines(&[
            ("list".to_owned(), "which models and scenes there are"),
            (format!("show {scene}"), "its equations"),
            (format!("run {scene} --out {file}"), "its motion"),
            (format!("animate {scene}"), "a page that plays its motion"),
            (format!("check {model}"), "whether its equations are right"),
            (format!("accuracy {scene}"), "which method and tolerance it takes"),
        ])
    }

    pub(super) fn of_show(&self) -> String {
        let Self { model, scene, .. } = self;
        self.lines(&[
            (format!("show {model}"), "every scene"),
            (format!("show {scene} --format latex"), "to paste into a document"),
        ])
    }

    pub(super) fn of_run(&self) -> String {
        let Self { scene, file, .. } = self;
        let mut examples = vec![(format!("run {scene}"), "as the scene says")];
        if let Some(info) = &self.info {
            examples.push((format!("run {scene} --until {}", 10.0 * info.until_s), "ten times as long"));
            if let Some(parameter) = info.parameters.first() {
                let set = format!("run {scene} --set {}={}", parameter.name, parameter.default);
                examples.push((set, "with another value of a parameter"));
            }
            if let Some((angle, _)) = info.coordinates.iter().zip(0..).find(|&(_, i)| is_angle(i)) {
                examples.push((format!("run {scene} --start {}=pi/3", angle.name), "from another start"));
            }
        }
        examples.extend([
            (format!("run {scene} --out {file} --every 0.01"), "all of the motion, as CSV"),
            (format!("run {scene} --step 1e-4 --json"), "the end, for another program"),
            (format!("run {scene} --project none --max-drift 1e-9"), "only as long as the constraints hold"),
        ]);
        if let Some((scene, input)) = &self.input {
            examples.extend([
                (format!("run {scene} --input {input}=-0.5"), "an input, held"),
                (format!("run {scene} --inputs {input}.csv --step 1e-3"), "inputs from a table of times and values"),
            ]);
        }
        self.lines(&examples)
    }

    pub(super) fn of_plot(&self) -> String {
        let Self { scene, column, velocity, .. } = self;
        let mut examples = vec![
            (format!("plot {scene} {column} {velocity}"), "over time, in two panels"),
            (format!("plot {scene} {velocity} --against {column}"), "the phase plane"),
            (format!("plot {scene} kinetic --out energy.png"), "as PNG"),
        ];
        if let Some(parameter) = self.info.as_ref().and_then(|info| info.parameters.first()) {
            let (name, value) = (parameter.name, parameter.default);
            let vary = format!("plot {scene} {column} --vary {name}={value},{}", 2.0 * value);
            examples.push((vary, "with two values of a parameter"));
        }
        self.lines(&examples)
    }

    pub(super) fn of_sweep(&self) -> String {
        let Self { scene, velocity, .. } = self;
        let first = self.info.as_ref().and_then(|info| info.parameters.first());
        let (name, value) = first.map_or(("NAME", 1.0), |parameter| (parameter.name, parameter.default));
        let [low, high, step] = [0.5 * value, 1.5 * value, 0.01 * value].map(|x| rounded(x, 3));
        self.lines(&[
            (format!("sweep {scene} --vary {name}={low}:{high}:{step}"), "a hundred values of a parameter"),
            (
                format!("sweep {scene} --sample {name}={low}:{high} --samples 1000 --keep max:{velocity}"),
                "a thousand samples, and the largest velocity of each",
            ),
            (format!("sweep {scene} --vary {name}={low}:{high}:{step} --resume"), "goes on after an interruption"),
        ])
    }

    pub(super) fn of_linearize(&self) -> String {
        let info = self.info.as_ref();
        let first = info.and_then(|info| info.parameters.first());
        let (name, value) = first.map_or(("NAME", 1.0), |parameter| (parameter.name, parameter.default));
        let [low, high, step] = [0.5 * value, 1.5 * value, 0.1 * value].map(|x| rounded(x, 3));
        let velocity = info.and_then(|info| info.velocities.first()).map_or("BODY.vx", |velocity| &*velocity.name);
        let input = info.and_then(|info| info.inputs.first()).map_or("INPUT", |input| input.name);
        let output = info.and_then(|info| info.outputs.first()).map_or("OUTPUT", |output| &*output.name);
        let near = format!("linearize {} --start {}=0", self.scene, self.last_angle());
        self.lines(&[
            (near.clone(), "the steady motion near this start, and its eigenvalues"),
            (format!("{near} --hold {velocity}"), "with a velocity that is held"),
            (format!("{near} --vary {velocity}=0.5:5:0.5"), "eigenvalues over a velocity"),
            (
                format!("{near} --vary {name}={low}:{high}:{step} --out locus.csv --plot locus.svg"),
                "where stability changes with a parameter, as a table and a figure, too",
            ),
            (
                format!("{near} --response {input}:{output} --plot bode.svg"),
                "poles, zeros and margins from an input to an output, and a Bode plot",
            ),
            (format!("{near} --mode 1 --animate mode.html"), "the first mode of the table, as an animation"),
            (format!("{near} --json"), "A, B, C, D and modes, for another program"),
        ])
    }

    pub(super) fn of_compare(&self) -> String {
        let Self { scene, column, .. } = self;
        self.lines(&[
            ("compare first.csv second.csv".to_owned(), "two files of run --out"),
            (format!("compare {scene} --vary method=rk4,dop853"), "two methods"),
            (format!("compare {scene} --vary step=1e-2,1e-3 {column} --out steps.svg"), "two steps, as a figure"),
        ])
    }

    pub(super) fn of_reactions(&self) -> String {
        let Self { scene, .. } = self;
        self.lines(&[
            (format!("reactions {scene}"), "what joints bear, and which power effects have"),
            (format!("reactions {scene} --plot hinges.svg --plot-power power.svg"), "as figures, too"),
            (format!("reactions {scene} --out reactions.csv --every 0.01"), "over time, as CSV"),
        ])
    }

    pub(super) fn of_animate(&self) -> String {
        let Self { scene, .. } = self;
        self.lines(&[
            (format!("animate {scene}"), "a page that plays it"),
            (format!("animate {scene} --method dop853 --out motion.html"), "with another method, into another file"),
        ])
    }

    pub(super) fn of_sketch(&self) -> String {
        let Self { scene, .. } = self;
        let mut examples = vec![(format!("sketch {scene}"), "at its start")];
        if let Some((angle, _)) =
            self.info.iter().flat_map(|info| info.coordinates.iter().zip(0..)).find(|&(_, i)| is_angle(i))
        {
            examples.push((format!("sketch {scene} --start {}=pi/6", angle.name), "at another start"));
        }
        examples.push((format!("sketch {scene} --at 0.5 --out sketch.svg"), "half a second later"));
        self.lines(&examples)
    }

    pub(super) fn of_check(&self) -> String {
        let Self { model, scene, .. } = self;
        self.lines(&[(format!("check {model}"), "every scene"), (format!("check {scene}"), "one")])
    }

    pub(super) fn of_accuracy(&self) -> String {
        let Self { scene, .. } = self;
        self.lines(&[
            (format!("accuracy {scene}"), "in a minute"),
            (format!("accuracy {scene} --until 10 --budget 20"), "other runs, in 20 s"),
            (format!("accuracy {scene} --out out/accuracy --json"), "for another program"),
        ])
    }

    pub(super) fn of_equilibrium(&self) -> String {
        let near = format!("equilibrium {} --start {}=0", self.scene, self.last_angle());
        let first = self.info.as_ref().and_then(|info| info.coordinates.first());
        let first = first.map_or("BODY.x", |coordinate| &*coordinate.name);
        let parameter = self.info.as_ref().and_then(|info| info.parameters.first());
        let parameter = parameter.map_or("PARAMETER", |parameter| parameter.name);
        self.lines(&[
            (near.clone(), "the steady motion near this start, with its reactions"),
            (format!("{near} --hold {first}"), "with a coordinate that keeps its value"),
            (format!("equilibrium {} --all", self.scene), "every rest that many starts lead to"),
            (format!("{near} --vary {parameter}=START:END:STEP --plot diagram.svg"), "all steady motions over a value"),
            (format!("{near} --json"), "for another program"),
        ])
    }

    pub(super) fn of_inverse(&self) -> String {
        let scene = self.driven.as_deref().unwrap_or("MODEL/SCENE");
        self.lines(&[
            (format!("inverse {scene}"), "the torques and forces of its drives"),
            (format!("inverse {scene} --out torque.csv --plot torque.svg"), "as a table and a figure, too"),
            (format!("inverse {scene} --json"), "for another program"),
            ("inverse MODEL/SCENE --by INPUT --out INPUT.csv".to_owned(), "an input in place of the drive"),
            ("run MODEL/OTHER --inputs INPUT.csv --step 1e-3".to_owned(), "and back, where nothing is prescribed"),
        ])
    }

    pub(super) fn of_periodic(&self) -> String {
        let scene = &self.scene;
        self.lines(&[
            (format!("periodic {scene} --period 2"), "of a scene that is driven with a period of 2 s"),
            (format!("periodic {scene} --period 2 --after 30"), "from where 30 periods of a run lead"),
            (format!("periodic {scene} --period-near 1.5 --out motion.csv"), "the period is found, too"),
            (format!("periodic {scene} --period 2 --json"), "for another program"),
        ])
    }

    pub(super) fn of_export(&self) -> String {
        let Self { model, scene, .. } = self;
        self.lines(&[
            (format!("export c {scene} --out equations.c"), "C without a library"),
            (format!("export numpy {scene}"), "a Python module that takes and returns arrays"),
            (format!("export matlab {model} --out equations"), "all scenes of a model, into a folder"),
            (format!("export fmu {scene}"), "a functional mock-up unit, FMI 2.0; --fmi 3 for FMI 3.0"),
            (format!("export latex {scene}"), "a document"),
        ])
    }

    pub(super) fn of_workspace(&self) -> String {
        let angle = self.info.as_ref().and_then(|info| info.coordinates.iter().find(|c| c.is_angle()));
        let over = angle.map_or("BODY.phi", |angle| &*angle.name);
        let scene = &self.scene;
        self.lines(&[
            (
                format!("workspace {scene} --over {over}=-3:3:0.05"),
                "how far it goes, and singular positions on the way",
            ),
            (
                format!("workspace {scene} --over {over}=-3:3:0.05 --without DRIVE --plot reach.svg"),
                "without a drive that prescribes it, and as a figure",
            ),
            ("workspace MODEL/SCENE --over TIP.x=-1:1:0.02 --over TIP.y=-1:1:0.02 --plot map.svg".to_owned(), "a map"),
            (format!("workspace {scene} --over {over}=-3:3:0.05 --out reach.csv --json"), "for another program"),
        ])
    }

    /// Of the last body, which the others steer or pull.
    fn last_angle(&self) -> &str {
        let info = self.info.as_ref();
        let angle = info.and_then(|info| info.coordinates.iter().rev().find(|coordinate| coordinate.is_angle()));
        angle.map_or("BODY.phi", |coordinate| &*coordinate.name)
    }

    fn lines(&self, examples: &[(String, &str)]) -> String {
        let width = examples.iter().map(|(command, _)| command.chars().count()).max().unwrap_or_default();
        let line = |(command, what): &(String, &str)| format!("\n  {} {command:width$}   {what}", self.program);
        format!("Examples:{}", examples.iter().map(line).collect::<String>())
    }
}
