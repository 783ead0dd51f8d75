//! A finished measurement.

use super::advice::{Advice, Candidate, TARGETS, advise};
use super::point::{Measured, Point, PointResult};
use super::reference::Reference;
use super::variant::Variant;
use ezy_core::integrate::{Method, MethodKind};
use ezy_core::model::SceneInfo;
use ezy_core::simulate::OPT_LEVEL;
use std::sync::Arc;

/// Errors and times of every setting.
#[derive(Debug, Clone)]
pub struct WorkPrecision {
    /// Names and sizes.
    pub info: Arc<SceneInfo>,
    /// Start of the runs, s.
    pub start_s: f64,
    /// End of the runs, s.
    pub until_s: f64,
    /// The requested end, s. The runs end earlier when the reference is not known up to there.
    pub asked_until_s: f64,
    /// Relative difference of the reference runs at the requested end, when the runs end earlier.
    pub unknown: Option<f64>,
    /// The reference.
    pub reference: Reference,
    /// Every setting, also those that were not run.
    pub points: Vec<Point>,
    /// The machine.
    pub machine: String,
    /// Budget of the measurement, s of processor time.
    pub budget_s: f64,
    /// What the measurement took, s of processor time.
    pub seconds: f64,
    /// Processor time of the measurement over its wall time; `None` where the system does not tell processor time.
    pub processor_share: Option<f64>,
    /// Whether it was ended before all settings were tried.
    pub interrupted: bool,
}

/// Share of a processor below which other programs disturb times: by caches, by clock rate, by threads of one core.
const QUIET: f64 = 0.9;

/// Settings of one method that were not measured.
#[derive(Debug, Clone, PartialEq)]
pub struct Missing {
    /// Name of the method.
    pub method: &'static str,
    /// With which projections.
    pub variants: Vec<Variant>,
    /// The settings, from coarse to fine.
    pub settings: Vec<Method>,
    /// Why; `None`: the budget.
    pub reason: Option<String>,
}

impl WorkPrecision {
    /// Names of the methods.
    pub(super) fn methods(&self) -> impl Iterator<Item = &'static str> {
        MethodKind::ALL.iter().map(|kind| kind.name())
    }

    /// The points of one method with one projection, from coarse to fine.
    pub fn curve(&self, method: &str, variant: Variant) -> impl Iterator<Item = (Method, &Measured)> {
        let of_curve = move |point: &&Point| point.method.name() == method && point.variant == variant;
        self.points.iter().filter(of_curve).filter_map(|point| Some((point.method, point.measured()?)))
    }

    /// Whether anything was measured.
    pub fn is_empty(&self) -> bool {
        self.points.iter().all(|point| point.measured().is_none())
    }

    /// The settings among which advice chooses: those with the default projection, by their largest error of positions
    /// over the grid, or that of the reference where it is larger.
    fn candidates(&self) -> Vec<Candidate> {
        let known = self.reference.uncertainty.grid.position.absolute;
        let all = self.methods().flat_map(|method| self.curve(method, Variant::default()));
        let candidate = |(method, measured): (Method, &Measured)| Candidate {
            method,
            error: measured.error.grid.position.absolute.max(known),
            seconds: measured.seconds_min,
        };
        all.map(candidate).filter(|candidate| candidate.error.is_finite()).collect()
    }

    /// Which method to use for each of [`TARGETS`].
    pub fn advice(&self) -> Vec<Advice> {
        let candidates = self.candidates();
        let known = self.reference.uncertainty.grid.position.absolute;
        let unfinished: Vec<&'static str> = self.methods().filter(|method| self.is_unfinished(method)).collect();
        TARGETS.iter().map(|&target| advise(target, known, &candidates, &unfinished)).collect()
    }

    /// Whether settings of a method, with the default projection, were not run for lack of time.
    fn is_unfinished(&self, method: &str) -> bool {
        let of_curve = |point: &&Point| point.method.name() == method && point.variant == Variant::default();
        let mut results = self.points.iter().filter(of_curve).map(|point| &point.result);
        results.any(|result| matches!(result, PointResult::NotRun | PointResult::Interrupted))
    }

    /// Whether other programs took so much of the machine that its times are no ground for a choice.
    pub fn was_busy(&self) -> bool {
        self.processor_share.is_some_and(|share| share < QUIET)
    }

    /// What is to be known before the advice is read, as sentences: an interruption, a busy machine, a build that is
    /// not optimised.
    pub fn reservations(&self) -> Vec<String> {
        let interrupted = self
            .interrupted
            .then(|| format!("The measurement was interrupted after {:.1} s: settings are missing.", self.seconds));
        let busy = self.processor_share.filter(|_| self.was_busy()).map(|share| {
            format!(
                "The machine was too busy for advice by time: the measurement had {:.0} % of a processor. Errors and counts of steps hold; \
                 measure again when the machine is idle before you choose by time.",
                100.0 * share
            )
        });
        let slow = (OPT_LEVEL != "3").then(|| {
            format!(
                "ezy-core was built at opt-level {OPT_LEVEL}: times are longer than those of a release build, and not all by the same \
                 factor. Errors and counts of steps hold."
            )
        });
        interrupted.into_iter().chain(busy).chain(slow).collect()
    }

    /// What was not measured: settings with the same reason together, and projections with the same settings.
    pub fn missing(&self) -> Vec<Missing> {
        let mut all: Vec<Missing> = Vec::new();
        for point in &self.points {
            let reason = match &point.result {
                PointResult::Measured(_) => continue,
                PointResult::Stopped(reason) => Some(reason.clone()),
                PointResult::NotRun => None,
                PointResult::Interrupted => Some("not run before the interruption".to_owned()),
            };
            let (method, variants) = (point.method.name(), vec![point.variant]);
            let alike = |m: &&mut Missing| m.method == method && m.variants == variants && m.reason == reason;
            match all.iter_mut().find(alike) {
                Some(missing) => missing.settings.push(point.method),
                None => all.push(Missing { method, variants, settings: vec![point.method], reason }),
            }
        }
        let mut merged: Vec<Missing> = Vec::new();
        for missing in all {
            let Missing { method, settings, reason, .. } = &missing;
            let alike = |m: &&mut Missing| m.method == *method && m.settings == *settings && m.reason == *reason;
            match merged.iter_mut().find(alike) {
                Some(earlier) => earlier.variants.extend(missing.variants),
                None => merged.push(missing),
            }
        }
        merged
    }
}

/// Whether the solver was built without optimisation, so that times mean nothing.
pub const IS_UNOPTIMISED: bool = matches!(OPT_LEVEL.as_bytes(), b"0");

/// Processor, target and kind of build.
pub(super) fn machine() -> String {
    let build = match OPT_LEVEL {
        "3" => "optimised build".to_owned(),
        level => format!("ezy-core at opt-level {level}"),
    };
    let target = format!("{} {}", std::env::consts::ARCH, std::env::consts::OS);
    let wide = if cfg!(target_feature = "avx2") { " with AVX2" } else { "" };
    let processor = processor().map(|name| format!("{name}, ")).unwrap_or_default();
    format!("{processor}{target}{wide}, {build}, one core")
}

/// The processor's name, where the system tells it in a file.
fn processor() -> Option<String> {
    let text = std::fs::read_to_string("/proc/cpuinfo").ok()?;
    let line = text.lines().find(|line| line.starts_with("model name"))?;
    Some(line.split_once(':')?.1.trim().to_owned())
}
