//! The steady motion that arguments ask for, and the linear equations about it.

use super::Models;
use super::failure::Failure;
use super::motion::{refused, simulation};
use super::motion_arguments::MotionArguments;
use super::names::{check_assignments, scene_entry, scene_with};
use super::steady_arguments::SteadyArguments;
use super::value::parse_number;
use super::vary::{Target, set, target};
use ezy_core::analysis::{
    AnalysisError, Axis, BifurcationDiagram, Linearization, Rests, Spectrum, SteadyMotion, Workspace,
};
use ezy_core::integrate::Method;
use ezy_core::model::{ModelInfo, Scene, SceneEntry, SceneInfo};
use ezy_core::record::find_name;
use ezy_core::simulate::Simulation;
use std::sync::Arc;

/// What is asked for of a scene.
pub(super) struct Request {
    model: &'static ModelInfo,
    entry: &'static SceneEntry,
    motion: MotionArguments,
    hold: Vec<String>,
    /// Names and sizes, with the counts that are set.
    info: Arc<SceneInfo>,
}

impl Request {
    pub(super) fn new(models: Models<'_>, arguments: &SteadyArguments) -> Result<Self, Failure> {
        let SteadyArguments { path, set, start, input, hold } = arguments;
        let (model, entry) = scene_entry(models, path)?;
        check_assignments(model, entry, start, input)?;
        let info = scene_with(model, entry, set)?.info();
        for name in hold {
            let states = info.states.iter().map(|state| state.name);
            let known = info.coordinates.iter().chain(&*info.velocities).map(|c| &*c.name).chain(states);
            find_name("start value", name, known)?;
        }
        let motion = MotionArguments {
            set: set.clone(),
            start: start.clone(),
            input: input.clone(),
            ..MotionArguments::default()
        };
        Ok(Self { model, entry, motion, hold: hold.clone(), info })
    }

    pub(super) fn info(&self) -> Arc<SceneInfo> {
        Arc::clone(&self.info)
    }

    /// The scene with its parameters.
    pub(super) fn scene(&self) -> Result<Box<dyn Scene>, Failure> {
        scene_with(self.model, self.entry, &self.motion.set)
    }

    /// A run of it.
    pub(super) fn simulation<'s>(
        &self,
        scene: &'s (dyn Scene + 's),
        method: Method,
    ) -> Result<Simulation<'s, &'s (dyn Scene + 's)>, Failure> {
        simulation(&self.motion, scene, method)
    }

    /// Names of what is held.
    pub(super) fn hold(&self) -> Vec<&str> {
        self.hold.iter().map(String::as_str).collect()
    }

    /// How the scene is typed.
    pub(super) fn path(&self) -> String {
        super::selection::path(self.model, self.entry)
    }

    /// The steady motion near the start, with a value that varies, and the linear equations about it.
    pub(super) fn linearized(&self, varied: Option<(&str, &str)>) -> Result<(SteadyMotion, Linearization), Failure> {
        let (mut motion, mut hold) = (self.motion.clone(), self.hold.clone());
        if let Some((name, value)) = varied {
            set(&mut motion, name, value, &self.info())?;
            let is_start = target(name, &self.info())? == Target::Start;
            // at rest no velocity is an unknown
            let moves = || !self.info().velocities.iter().any(|v| *v.name == *name) || parse_number(value) != Ok(0.0);
            if is_start && moves() && !hold.iter().any(|held| held == name) {
                hold.push(name.to_owned());
            }
        }
        let scene = scene_with(self.model, self.entry, &motion.set)?;
        let run = simulation(&motion, scene.as_ref(), Method::default())?;
        let (mut system, start) = run.system_at_start().map_err(refused)?;
        let hold: Vec<&str> = hold.iter().map(String::as_str).collect();
        let found = SteadyMotion::near(&mut system, &start, &hold).map_err(failed)?;
        let linear = Linearization::of(&mut system, &found).map_err(failed)?;
        Ok((found, linear))
    }

    /// The scene with its parameters, and the values of its inputs.
    pub(super) fn scene_with_inputs(&self) -> Result<(Box<dyn Scene>, Vec<f64>), Failure> {
        let scene = scene_with(self.model, self.entry, &self.motion.set)?;
        let (system, _) =
            simulation(&self.motion, scene.as_ref(), Method::default())?.system_at_start().map_err(refused)?;
        let inputs = system.fixed().iter().take(system.info().n_inputs()).copied().collect();
        drop(system);
        Ok((scene, inputs))
    }

    /// The steady motions over a value that varies.
    pub(super) fn diagram(&self, name: &str, range: [f64; 2], step: f64) -> Result<BifurcationDiagram, Failure> {
        let scene = scene_with(self.model, self.entry, &self.motion.set)?;
        let run = simulation(&self.motion, scene.as_ref(), Method::default())?;
        let (mut system, start) = run.system_at_start().map_err(refused)?;
        let hold: Vec<&str> = self.hold.iter().map(String::as_str).collect();
        BifurcationDiagram::of(&mut system, &start, &hold, name, range, step).map_err(failed)
    }

    /// The positions over one or two coordinates, without some drives.
    pub(super) fn workspace(&self, axes: &[Axis], without: &[String]) -> Result<Workspace, Failure> {
        let scene = scene_with(self.model, self.entry, &self.motion.set)?;
        let run = simulation(&self.motion, scene.as_ref(), Method::default())?;
        let (mut system, start) = run.system_at_start().map_err(refused)?;
        let [hold, without] =
            [&self.hold[..], without].map(|names| names.iter().map(String::as_str).collect::<Vec<_>>());
        Workspace::of(&mut system, &start, axes, &hold, &without).map_err(|error| match error {
            AnalysisError::Prescribed { .. } => Failure::wrong_use(format!("{error} by --without")),
            AnalysisError::Undetermined { .. } => Failure::wrong_use(format!("{error} (--hold, --start)")),
            AnalysisError::Fixed { .. } => Failure::wrong_use(format!("{error} (--over, --start)")),
            error => failed(error),
        })
    }

    /// Every rest that many starts lead to, with its eigenvalues, or why it has none.
    pub(super) fn rests(&self) -> Result<(Rests, Vec<Result<Spectrum, AnalysisError>>), Failure> {
        let scene = scene_with(self.model, self.entry, &self.motion.set)?;
        let run = simulation(&self.motion, scene.as_ref(), Method::default())?;
        let (mut system, start) = run.system_at_start().map_err(refused)?;
        let hold: Vec<&str> = self.hold.iter().map(String::as_str).collect();
        let rests = Rests::of(&mut system, &start, &hold, N_STARTS).map_err(failed)?;
        let spectra = rests.found.iter().map(|rest| Linearization::of(&mut system, &rest.motion)?.spectrum());
        let spectra = spectra.collect();
        Ok((rests, spectra))
    }
}

/// Starts of the search for all rests.
pub(super) const N_STARTS: usize = 128;

/// Why there is no result, by exit status.
pub(super) fn failed(error: AnalysisError) -> Failure {
    match error {
        AnalysisError::UnknownHeld { .. }
        | AnalysisError::Unknown { .. }
        | AnalysisError::Spatial { .. }
        | AnalysisError::Period { .. }
        | AnalysisError::TimeDependent { .. }
        | AnalysisError::System(_)
        | AnalysisError::Start(_) => Failure::wrong_use(error),
        error => Failure::stopped(error),
    }
}
