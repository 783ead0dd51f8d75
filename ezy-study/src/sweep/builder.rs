//! A sweep: its settings, then [`Sweep::run`] into memory or [`Sweep::write`] into files.

use super::case::{Case, OwnNumber, Refused};
use super::error::SweepError;
use super::finished::Finished;
use super::format::Format;
use super::group::{Computed, Group, Runner, Together};
use super::kept::{Kept, Reader};
use super::manifest::{self, CASES_PER_PART, Manifest};
use super::part::{self, Part};
use super::plan::{Factor, Plan, Value};
use super::row::{Cell, Column, Row, columns, heading};
use super::trajectories::Trajectories;
use super::workers::in_order;
use ezy_core::model::{N_LANES, Scene, SceneInfo};
use ezy_core::record::{self, UnknownName, find_name};
use ezy_core::simulate::{Run, VERSION, run_together};
use serde_json::{Map, json};
use std::convert::Infallible;
use std::io;
use std::ops::Range;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use std::thread;

/// Many runs of a scene, on all cores, in order.
///
/// Results do not depend on the number of threads, to the last bit. A case that cannot be run, or that stops early, is a row with its
/// outcome.
///
/// ```
/// use ezy_core::prelude::*;
/// use ezy_study::sweep::{Plan, Sweep};
///
/// model! {
///     pub model Throw {
///         param speed: m/s = 10;
///         param angle: rad = 0.5;
///         body ball { mass: 1, inertia: 1 }
///         gravity (0, -9.81);
///         event lands: ball.y < 0;
///         start up { ball at (0, 0) velocity (speed*cos(angle), speed*sin(angle)); }
///         scene flight { start up; until 20 s; until lands; }
///     }
/// }
///
/// let plan = Plan::new().grid("speed", [5.0, 10.0]).grid("angle", [0.2, 0.4, 0.6, 0.8]);
/// let sweep = Sweep::new(&throw::Flight::default(), plan, |case| {
///     let scene = throw::Flight { speed: case.get("speed")?, angle: case.get("angle")? };
///     Ok(case.run(Simulation::new(&scene))?)
/// });
/// let table = sweep.keep(["ball.x", "max:ball.y"]).run()?;
/// let widths = table.numbers("ball.x")?;
/// assert_eq!(widths.len(), 8);
/// let expected = 10.0 * 10.0 * (2.0 * 0.8_f64).sin() / 9.81;
/// assert!((widths[7] / expected - 1.0).abs() < 1e-6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Sweep<'a> {
    info: Arc<SceneInfo>,
    plan: Plan,
    runner: Box<Runner<'a>>,
    kept: Vec<Kept>,
    own: Vec<OwnNumber<'a>>,
    every_s: Option<f64>,
    n_threads: Option<usize>,
    n_per_part: Option<u64>,
    shard: Option<[u64; 2]>,
    format: Format,
    resumes: bool,
    settings: Map<String, serde_json::Value>,
    together: Option<(Arc<SceneInfo>, Box<Together<'a>>)>,
    interrupt: Option<&'a AtomicBool>,
    on_progress: Box<dyn FnMut(Progress) + 'a>,
}

/// How far a sweep is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Progress {
    /// Cases that this call computed.
    pub n_done: u64,
    /// Cases that it computes in all: those of its share that were not there.
    pub n_cases: u64,
    /// Cases done that are not complete and sound ([`Ended::is_good`](super::Ended::is_good)).
    pub n_failed: u64,
}

/// All rows of a sweep.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    /// Number of the case, values, what is kept, `end`, `steps`, `outcome`, `message`.
    pub columns: Vec<Column>,
    /// In the order of the cases.
    pub rows: Vec<Row>,
}

/// What [`Sweep::write`] has done.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Written {
    /// What was computed.
    pub progress: Progress,
    /// Cases of the share that were there.
    pub n_found: u64,
    /// The first case that failed, and why.
    pub first_failure: Option<(u64, String)>,
    /// Parts of the share that are complete, and all of them.
    pub n_parts: [u64; 2],
    /// Of a sweep in lanes, what this call computed without them.
    pub alone: Option<RanAlone>,
}

/// Cases of a sweep in lanes that ran by themselves.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct RanAlone {
    /// How many.
    pub n_cases: u64,
    /// Number of the first one.
    pub first: u64,
    /// Why it did.
    pub why: &'static str,
}

/// Cases of a part that nobody chose: few, so that a machine that is lost takes little with it; more where a thousand parts would not do.
const CASES: u64 = 1000;
const MOST_PARTS: u64 = 1000;
const MOST_CASES: u64 = 100_000;
/// Parts of a share at least, where there are as many cases: shares then take about the same time.
const PARTS_OF_A_SHARE: u64 = 4;

impl<'a> Sweep<'a> {
    /// A sweep of `plan`, whose cases `run` computes: it makes a scene and its simulation from the values of the case, and hands it to
    /// [`Case::run`]. `scene` tells names and units.
    pub fn new<S: Scene + ?Sized>(
        scene: &S,
        plan: Plan,
        run: impl Fn(&Case<'_>) -> Result<Finished, Refused> + Sync + 'a,
    ) -> Self {
        Self {
            info: scene.info(),
            plan,
            runner: Box::new(run),
            kept: Vec::new(),
            own: Vec::new(),
            every_s: None,
            n_threads: None,
            n_per_part: None,
            shard: None,
            format: Format::default(),
            resumes: false,
            settings: Map::new(),
            together: None,
            interrupt: None,
            on_progress: Box::new(|_| {}),
        }
    }

    /// Keeps more of each run: `seat.vx`, `max:output.speed`, `event:landed`, … ([`Kept`]).
    #[must_use]
    pub fn keep<K: Into<Kept>>(mut self, kept: impl IntoIterator<Item = K>) -> Self {
        self.kept.extend(kept.into_iter().map(Into::into));
        self
    }

    /// Keeps a number that `read` takes from each run, under a name with a unit.
    #[must_use]
    pub fn keep_number(
        mut self,
        name: impl Into<String>,
        unit: impl Into<String>,
        read: impl Fn(&Run) -> f64 + Sync + 'a,
    ) -> Self {
        self.own.push((record::Column { name: name.into(), unit: unit.into() }, Box::new(read)));
        self
    }

    /// Interval of the samples from which extremes are taken, s; without it a thousandth of each run.
    #[must_use]
    pub fn every(mut self, every_s: f64) -> Self {
        self.every_s = Some(every_s);
        self
    }

    /// Number of threads; without it as many as the machine runs at once.
    #[must_use]
    pub fn threads(mut self, n: usize) -> Self {
        self.n_threads = Some(n.max(1));
        self
    }

    /// Cases of each file; without it 1,000, more beyond a million cases, fewer where shares would be uneven.
    #[must_use]
    pub fn cases_per_part(mut self, n: u64) -> Self {
        self.n_per_part = Some(n.max(1));
        self
    }

    /// Computes share `i` of `n`, from 1 to `n`, and no other: every n-th part of the same plan. Shares may write into one folder at
    /// once. A share that was begun goes on where it ended.
    #[must_use]
    pub fn shard(mut self, i: u64, n: u64) -> Self {
        self.shard = Some([i, n]);
        self
    }

    /// Runs cases in lanes: eight neighbours step together, by dop853 with steps that keep to the tolerance in each of them, about three times
    /// as fast. Of 640 cases and more those go together that take steps of similar length, among forty neighbours. Only their ends can be kept. `scene`: one of the scenes that the cases make.
    ///
    /// A case runs by itself where something on its way has to be located, as a discontinuity of a law, where it is not run by dop853, and
    /// where its neighbours come close to a singular position or stop early; [`Written::alone`] says how many. Steps, and so the last digits
    /// within the tolerance, depend on the neighbours, and on nothing else.
    #[must_use]
    pub fn in_lanes(mut self, scene: &'a dyn Scene) -> Self {
        let together: Box<Together<'a>> = Box::new(move |runs, interrupts| run_together(scene, runs, interrupts));
        self.together = Some((scene.info(), together));
        self
    }

    /// How the files are written.
    #[must_use]
    pub fn format(mut self, format: Format) -> Self {
        self.format = format;
        self
    }

    /// Goes on with results that are in the folder, if they are of the same sweep. Each case is computed once.
    #[must_use]
    pub fn resume(mut self) -> Self {
        self.resumes = true;
        self
    }

    /// Tells what else the results depend on: a method, a tolerance, an end. A folder with results of other settings is refused.
    #[must_use]
    pub fn setting(mut self, name: impl Into<String>, value: impl Into<serde_json::Value>) -> Self {
        self.settings.insert(name.into(), value.into());
        self
    }

    /// Ends early once `flag` is true. What was computed is kept; runs under way are not.
    #[must_use]
    pub fn interrupted_by(mut self, flag: &'a AtomicBool) -> Self {
        self.interrupt = Some(flag);
        self
    }

    /// Calls `progress` after each case.
    #[must_use]
    pub fn on_progress(mut self, progress: impl FnMut(Progress) + 'a) -> Self {
        self.on_progress = Box::new(progress);
        self
    }

    /// That plan and names can be used, without a run.
    ///
    /// # Errors
    /// [`SweepError`] as of [`Sweep::run`].
    pub fn check(&self) -> Result<(), SweepError> {
        self.begin().map(|_| ())
    }

    /// Number of cases, and where what is kept is found.
    fn begin(&self) -> Result<(u64, Reader), SweepError> {
        let (n, reader) = (self.plan.n_cases()?, Reader::new(&self.info, &self.kept)?);
        let own = self.own.first().map(|(column, _)| column.name.as_str());
        match reader.beyond_end().or(own) {
            Some(kept) if self.together.is_some() => Err(SweepError::BeyondEnd { kept: kept.to_owned() }),
            _ => Ok((n, reader)),
        }
    }

    /// Computes all cases, or those of the share, into memory. After an interruption the table ends early.
    ///
    /// # Errors
    /// [`SweepError`] when the sweep cannot begin.
    pub fn run(mut self) -> Result<Table, SweepError> {
        let (n, reader) = self.begin()?;
        if reader.keeps_samples {
            return Err(SweepError::NoFolder);
        }
        let n_per_part = self.cases_of_a_part(n, None);
        let parts = self.parts(n, n_per_part)?;
        let mut rows = Vec::new();
        let cases = parts.iter().map(|part| cases_of(*part, n, n_per_part));
        let done = self.compute(&reader, None, cases, n, |computed| {
            rows.extend(computed.map(|computed| computed.row));
            Ok::<(), Infallible>(())
        });
        done.unwrap_or_else(|never| match never {});
        Ok(Table { columns: self.columns(&reader), rows })
    }

    /// Computes all cases, or those of the share, into files of `folder`: `sweep.json` says what they are of, `part-000000.csv` and so on
    /// have the rows. What is there of a part stands in `part-000000.csv.partial` until it is complete.
    ///
    /// # Errors
    /// [`SweepError`] when the sweep cannot begin, or a row cannot be written. Rows before it are in the files.
    pub fn write(mut self, folder: &Path) -> Result<Written, SweepError> {
        let (n, reader) = self.begin()?;
        let columns = self.columns(&reader);
        let manifest = self.claim(folder, n, &columns)?;
        let n_per_part = manifest.number(CASES_PER_PART).unwrap_or(CASES);
        let of_file = |path: &Path, cause: io::Error| SweepError::File { path: path.to_owned(), cause };
        let (heading, format) = (heading(&columns), self.format);
        let parts = self.parts(n, n_per_part)?;
        let mut written = Written { n_parts: [0, parts.len() as u64], ..Written::default() };
        // parts to compute, with the rows that are there
        let mut pending: Vec<(u64, u64)> = Vec::new();
        for &part in &parts {
            let (path, rows) = (part::path(folder, part, format), n_rows(part, n, n_per_part));
            if path.exists() {
                written.n_found += rows;
                written.n_parts[0] += 1;
                continue;
            }
            let left = std::fs::read(part::partial(folder, part)).unwrap_or_default();
            let (n_found, _) = part::whole_rows(&left, &heading, part * n_per_part, rows);
            written.n_found += n_found;
            pending.push((part, n_found));
        }
        let mut open: Option<(u64, Part)> = None;
        let begin = |part: u64, n_found: u64| {
            let path = part::path(folder, part, Format::Csv);
            let rows = n_rows(part, n, n_per_part);
            let busy = || io::Error::new(io::ErrorKind::ResourceBusy, "another program is writing it");
            let open = Part::open(&path, &heading, part * n_per_part, rows);
            // somebody else wrote since it was looked at
            let open = open.and_then(|open| if open.n_found == n_found { Ok(open) } else { Err(busy()) });
            open.map_err(|cause| of_file(&path, cause))
        };
        let complete = |number: u64, part: Part| {
            let done = part.complete(&part::path(folder, number, format), format, &columns, &manifest);
            done.map_err(|cause| of_file(&part::path(folder, number, format), cause))
        };
        // killed between its last row and its name
        for (part, n_found) in &pending {
            if *n_found == n_rows(*part, n, n_per_part) {
                complete(*part, begin(*part, *n_found)?)?;
                written.n_parts[0] += 1;
            }
        }
        let found: std::collections::HashMap<u64, u64> = pending.iter().copied().collect();
        let cases = pending.iter().map(|(part, n_found)| {
            let cases = cases_of(*part, n, n_per_part);
            cases.start + n_found..cases.end
        });
        let mut lines = String::new();
        let (mut n_complete, mut first_failure, mut alone) = (0, None, None);
        let trajectories = Trajectories { folder, format, n_per_part, manifest: &manifest };
        let trajectories = reader.keeps_samples.then_some(trajectories);
        let progress = self.compute(&reader, trajectories, cases, n, |computed| {
            let Some(Computed { row, failure, alone: why_alone, unwritten }) = computed else {
                if let Some((number, part)) = &mut open {
                    part.write(&lines).map_err(|cause| of_file(&part::path(folder, *number, format), cause))?;
                }
                lines.clear();
                return Ok(());
            };
            // the row of a case without its file would be found when the sweep goes on; those before it are written
            if let Some((path, cause)) = unwritten {
                if let Some((_, part)) = &mut open {
                    let _ = part.write(&lines);
                }
                return Err(of_file(&path, cause));
            }
            let number = row.index / n_per_part;
            let path = || part::path(folder, number, format);
            if open.is_none() {
                open = Some((number, begin(number, found[&number])?));
            }
            row.write_line(&mut lines);
            if first_failure.is_none() {
                first_failure = failure.map(|why| (row.index, why));
            }
            if let Some(why) = why_alone {
                alone.get_or_insert(RanAlone { n_cases: 0, first: row.index, why }).n_cases += 1;
            }
            if row.index + 1 == (number * n_per_part).saturating_add(n_per_part).min(n)
                && let Some((_, mut part)) = open.take()
            {
                part.write(&lines).map_err(|cause| of_file(&path(), cause))?;
                lines.clear();
                complete(number, part)?;
                n_complete += 1;
            }
            Ok::<(), SweepError>(())
        })?;
        written.n_parts[0] += n_complete;
        Ok(Written { progress, first_failure, alone, ..written })
    }

    /// Runs `cases`, which are neighbours in each range, and hands over what became of each, or `None` where nothing waits. `n`: cases of
    /// the plan.
    fn compute<E>(
        &mut self,
        reader: &Reader,
        trajectories: Option<Trajectories<'_>>,
        cases: impl Iterator<Item = Range<u64>> + Clone + Send,
        n: u64,
        mut take: impl FnMut(Option<Computed>) -> Result<(), E>,
    ) -> Result<Progress, E> {
        let over = AtomicBool::new(false);
        let interrupt = self.interrupt.unwrap_or(&over);
        let n_of_group = self.cases_of_a_group(n);
        let on_progress = &mut self.on_progress;
        let group = Group {
            plan: &self.plan,
            runner: &*self.runner,
            together: self.together.as_ref().map(|(info, together)| (&**info, &**together)),
            reader,
            own: &self.own,
            every_s: self.every_s,
            trajectories,
            interrupts: [interrupt, &over],
        };
        // groups are the same whatever is computed of them
        let groups = cases.clone().flat_map(|cases| {
            let first = cases.start / n_of_group;
            (first..cases.end.div_ceil(n_of_group)).map(move |i| {
                let whole = i * n_of_group..(i + 1).saturating_mul(n_of_group).min(n);
                let asked = cases.start.max(whole.start)..cases.end.min(whole.end);
                (whole, asked)
            })
        });
        let n_threads = self.n_threads.unwrap_or_else(|| thread::available_parallelism().map_or(1, usize::from));
        let mut progress =
            Progress { n_cases: cases.map(|cases| cases.end - cases.start).sum(), ..Progress::default() };
        in_order(
            groups,
            n_threads,
            &over,
            |(whole, asked)| group.compute(whole, &asked),
            |computed| {
                let Some(computed) = computed else { return take(None) };
                for computed in computed {
                    let n_failed = u64::from(computed.failure.is_some());
                    take(Some(computed))?;
                    progress.n_done += 1;
                    progress.n_failed += n_failed;
                    on_progress(progress);
                }
                Ok(())
            },
        )?;
        Ok(progress)
    }

    /// Neighbours that a thread computes: one case, or eight in lanes. Where sixteen processors have enough to do all the same they are five times eight, which are sorted by the
    /// length of their steps.
    fn cases_of_a_group(&self, n: u64) -> u64 {
        const EIGHT: u64 = N_LANES as u64;
        match self.together {
            None => 1,
            Some(_) if n < 16 * 5 * EIGHT => EIGHT,
            Some(_) => 5 * EIGHT,
        }
    }

    /// Cases of each part; `kept`: what an earlier program chose. A group that stands in two parts is computed for each.
    pub(super) fn cases_of_a_part(&self, n: u64, kept: Option<u64>) -> u64 {
        let n_shares = self.shard.map_or(1, |[_, n]| n.max(1));
        let even = (n / n_shares / PARTS_OF_A_SHARE).max(1);
        let chosen = n.div_ceil(MOST_PARTS).clamp(CASES, MOST_CASES);
        let chosen = if n_shares > 1 { chosen.min(even) } else { chosen };
        self.n_per_part.or(kept).unwrap_or(chosen.next_multiple_of(self.cases_of_a_group(n)))
    }

    /// The parts of the share.
    fn parts(&self, n: u64, n_per_part: u64) -> Result<Vec<u64>, SweepError> {
        let [i, n_shares] = self.shard.unwrap_or([1, 1]);
        if !(1..=n_shares).contains(&i) {
            return Err(SweepError::Shard { i, n: n_shares });
        }
        Ok((i - 1..n.div_ceil(n_per_part)).step_by(n_shares as usize).collect())
    }

    fn columns(&self, reader: &Reader) -> Vec<Column> {
        let units: Vec<String> = self.plan.names().iter().map(|name| unit(&self.info, name)).collect();
        let kept: Vec<record::Column> =
            reader.columns.iter().chain(self.own.iter().map(|(column, _)| column)).cloned().collect();
        columns(&self.plan, &units, &kept)
    }

    /// Makes the folder that of this sweep.
    fn claim(&self, folder: &Path, n: u64, columns: &[Column]) -> Result<Manifest, SweepError> {
        let of_folder = |cause| SweepError::File { path: folder.to_owned(), cause };
        std::fs::create_dir_all(folder).map_err(of_folder)?;
        let before = Manifest::of_folder(folder).map_err(of_folder)?;
        let n_per_part = self.cases_of_a_part(n, before.as_ref().and_then(|before| before.number(CASES_PER_PART)));
        let now = self.manifest(n, n_per_part, columns);
        let Some(before) = before else {
            now.put_into(folder).map_err(of_folder)?;
            return Ok(now);
        };
        let differences = before.differences(&now);
        if !differences.is_empty() {
            return Err(SweepError::Changed { folder: folder.to_owned(), differences });
        }
        if !self.resumes && self.shard.is_none() {
            let n_parts = n.div_ceil(n_per_part);
            let n_complete = (0..n_parts).filter(|part| part::path(folder, *part, self.format).exists()).count() as u64;
            return Err(SweepError::Exists { folder: folder.to_owned(), n_parts: [n_complete, n_parts] });
        }
        Ok(now)
    }

    fn manifest(&self, n: u64, n_per_part: u64, columns: &[Column]) -> Manifest {
        let mut of = Manifest(Map::new());
        of.set("ezy", VERSION);
        of.set("model", self.info.model);
        of.set("model hash", format!("{:016x}", self.info.fingerprint));
        of.set("scene", self.info.name);
        self.settings.iter().for_each(|(name, value)| of.set(name, value.clone()));
        for factor in &self.plan.factors {
            match factor {
                Factor::Grid { name, values } => of.set(&format!("grid {name}"), manifest::digest(values)),
                Factor::Words { name, words } => of.set(&format!("grid {name}"), json!(words)),
                Factor::List { names, numbers } => {
                    of.set(&format!("list {}", names.join(" ")), manifest::digest(numbers));
                }
                Factor::Samples(samples) => {
                    of.set("samples", samples.n);
                    of.set("design", samples.design.name());
                    of.set("seed", samples.seed);
                    for (name, low, high) in &samples.ranges {
                        of.set(&format!("sampled {name}"), json!([low, high]));
                    }
                }
            }
        }
        let own = self.own.iter().map(|(column, _)| column.name.clone());
        of.set(manifest::KEPT, json!(self.kept.iter().map(ToString::to_string).chain(own).collect::<Vec<_>>()));
        of.set("every", json!(self.every_s));
        of.set("lanes", json!(self.together.as_ref().map(|_| N_LANES)));
        of.set_columns(columns);
        of.set("format", self.format.name());
        of.set("cases", n);
        of.set(CASES_PER_PART, n_per_part);
        of
    }
}

/// The cases of a part.
fn cases_of(part: u64, n: u64, n_per_part: u64) -> Range<u64> {
    let first = part * n_per_part;
    first..first.saturating_add(n_per_part).min(n)
}

fn n_rows(part: u64, n: u64, n_per_part: u64) -> u64 {
    let cases = cases_of(part, n, n_per_part);
    cases.end - cases.start
}

/// Unit of what is varied; of a name of the caller's own, none.
fn unit(info: &SceneInfo, name: &str) -> String {
    let parameters = info.parameters.iter().chain(info.inputs).chain(info.states).map(|known| (known.name, known.unit));
    let starts = info.coordinates.iter().chain(&*info.velocities).map(|c| (&*c.name, c.unit));
    let mut all = parameters.chain(starts).chain([("step", "s")]);
    all.find(|(known, _)| *known == name).map_or_else(String::new, |(_, unit)| unit.to_owned())
}

impl Table {
    /// A column of numbers; NaN where a case has none.
    ///
    /// # Errors
    /// [`UnknownName`] with the nearest column.
    pub fn numbers(&self, name: &str) -> Result<Vec<f64>, UnknownName> {
        let i = find_name("column", name, self.columns.iter().map(|column| column.name.as_str()))?;
        let number = |row: &Row| match i.checked_sub(1).map(|i| &row.cells[i]) {
            None => row.index as f64,
            Some(Cell::Number(x)) => *x,
            Some(Cell::Count(n)) => *n as f64,
            Some(Cell::Text(_)) => f64::NAN,
        };
        Ok(self.rows.iter().map(number).collect())
    }
}

impl Value<'_> {
    /// The number; NaN of a word.
    pub fn number(self) -> f64 {
        match self {
            Self::Number(x) => x,
            Self::Word(_) => f64::NAN,
        }
    }
}
