//! What a sweep keeps of each run.

use ezy_core::model::{Scene, SceneInfo};
use ezy_core::record::{Column, UnknownName, Wanted, columns, find_name};
use ezy_core::simulate::{EndOfRun, Run, SetupError};
use std::fmt;

/// One thing to keep of each run; as text `seat.vx`, `max:output.speed`, `event:landed`, `error`, `samples`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Kept {
    /// A column at the end of the run, by the names of [`columns`] or of a point: `A.x`.
    End(String),
    /// The least value of a column among the samples.
    Smallest(String),
    /// The largest value of a column among the samples.
    Largest(String),
    /// When an event takes place first, s.
    FirstTime(String),
    /// How often an event takes place.
    Count(String),
    /// The estimated error of positions, velocities and multipliers, the largest of each unit, and how much the motion amplifies errors.
    /// Each run is then computed three times.
    Error,
    /// All samples of the run, in a file of its own: `runs/part-000000/case-000017.csv` beside the rows.
    Samples,
}

impl From<&str> for Kept {
    fn from(text: &str) -> Self {
        let named = |name: &str| name.trim().to_owned();
        match text.split_once(':') {
            Some(("end", name)) => Self::End(named(name)),
            Some(("min", name)) => Self::Smallest(named(name)),
            Some(("max", name)) => Self::Largest(named(name)),
            Some(("event", name)) => Self::FirstTime(named(name)),
            Some(("count", name)) => Self::Count(named(name)),
            _ if text.trim() == "error" => Self::Error,
            _ if text.trim() == "samples" => Self::Samples,
            _ => Self::End(named(text)),
        }
    }
}

impl fmt::Display for Kept {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::End(name) => write!(f, "{name}"),
            Self::Smallest(name) => write!(f, "min:{name}"),
            Self::Largest(name) => write!(f, "max:{name}"),
            Self::FirstTime(name) => write!(f, "event:{name}"),
            Self::Count(name) => write!(f, "count:{name}"),
            Self::Error => write!(f, "error"),
            Self::Samples => write!(f, "samples"),
        }
    }
}

/// Where the numbers of [`Kept`] are found in the runs of a scene.
#[derive(Debug)]
pub(super) struct Reader {
    pub(super) columns: Vec<Column>,
    places: Vec<Place>,
    /// Places of the columns of runs with works in those of runs without.
    without_work: Vec<Option<usize>>,
    pub(super) needs_work: bool,
    has_points: bool,
    pub(super) needs_samples: bool,
    pub(super) needs_error: bool,
    pub(super) keeps_samples: bool,
    /// All columns of the scene, with its own counts.
    all: Vec<Column>,
    kept: Vec<Kept>,
    /// Columns of each of them.
    n_places: Vec<usize>,
}

#[derive(Debug, Clone, PartialEq)]
enum Place {
    /// Column of a sample at the end.
    End(usize),
    Smallest(usize),
    Largest(usize),
    /// A coordinate of a point at the end.
    Point(usize),
    FirstTime(String),
    Count(String),
    /// The errors of the unit, and the amplification where there is none.
    Error(Option<String>),
}

/// What runs are asked for besides the motion, where it is kept.
const OUTPUTS: Wanted = Wanted { outputs: true, work: false, power: false };
const ALL: Wanted = Wanted { outputs: true, work: true, power: false };

impl Reader {
    /// # Errors
    /// [`UnknownName`] of a column, point or event.
    pub(super) fn new(info: &SceneInfo, kept: &[Kept]) -> Result<Self, UnknownName> {
        let (all, without) = (columns(info, ALL), columns(info, OUTPUTS));
        let place = |name: &str| without.iter().position(|column| column.name == name);
        let without_work: Vec<Option<usize>> = all.iter().map(|column| place(&column.name)).collect();
        let points: Vec<String> =
            info.points.iter().flat_map(|point| ["x", "y"].map(|axis| format!("{}.{axis}", point.name))).collect();
        let mut of = Self {
            columns: Vec::new(),
            places: Vec::new(),
            without_work,
            needs_work: false,
            has_points: false,
            needs_samples: false,
            needs_error: false,
            keeps_samples: false,
            all: all.clone(),
            kept: kept.to_vec(),
            n_places: Vec::new(),
        };
        let column = |name: &str| find_name("column", name, all.iter().map(|column| column.name.as_str()));
        let event =
            |name: &str| find_name("event", name, info.events.iter().map(|event| event.name)).map(|_| name.to_owned());
        for kept in kept {
            let mut push = |unit: &str, place: Place| {
                of.columns.push(Column { name: kept.to_string(), unit: unit.to_owned() });
                of.places.push(place);
            };
            match kept {
                Kept::End(name) => match points.iter().position(|point| point == name) {
                    Some(i) if column(name).is_err() => {
                        push("m", Place::Point(i));
                        of.has_points = true;
                    }
                    _ => column(name).map(|i| push(&all[i].unit, Place::End(i)))?,
                },
                Kept::Smallest(name) => column(name).map(|i| push(&all[i].unit, Place::Smallest(i)))?,
                Kept::Largest(name) => column(name).map(|i| push(&all[i].unit, Place::Largest(i)))?,
                Kept::FirstTime(name) => event(name).map(|name| push("s", Place::FirstTime(name)))?,
                Kept::Count(name) => event(name).map(|name| push("", Place::Count(name)))?,
                Kept::Error => {
                    let lengths = info.coordinates.iter().map(|coordinate| coordinate.unit);
                    let units = lengths.clone().map(str::to_owned).chain(lengths.map(|unit| format!("{unit}/s")));
                    let units = units.chain(info.rows.iter().map(|row| row.multiplier_unit.to_owned()));
                    let mut seen: Vec<String> = Vec::new();
                    for unit in units {
                        if !seen.contains(&unit) {
                            of.columns.push(Column { name: format!("error:{unit}"), unit: unit.clone() });
                            of.places.push(Place::Error(Some(unit.clone())));
                            seen.push(unit);
                        }
                    }
                    of.columns.push(Column { name: "error:amplification".to_owned(), unit: String::new() });
                    of.places.push(Place::Error(None));
                    of.needs_error = true;
                }
                Kept::Samples => of.keeps_samples = true,
            }
            if let Some(Place::End(i) | Place::Smallest(i) | Place::Largest(i)) = of.places.last() {
                of.needs_work |= of.without_work[*i].is_none();
            }
            of.n_places.push(of.places.len() - of.n_places.iter().sum::<usize>());
            of.needs_samples |= matches!(kept, Kept::Smallest(_) | Kept::Largest(_) | Kept::Error | Kept::Samples);
        }
        Ok(of)
    }

    /// The numbers of a run, NaN where it has none.
    ///
    /// # Errors
    /// [`SetupError`] when points are kept, and the scene cannot be used.
    pub(super) fn numbers<S: Scene + ?Sized>(&self, scene: &S, run: &Run) -> Result<Vec<f64>, SetupError> {
        let info = scene.info();
        if !info.counts().is_empty() && columns(&info, ALL) != self.all {
            // another count has other columns, and may have none of a name
            let other =
                self.kept.iter().map(|kept| Self::new(&info, std::slice::from_ref(kept)).ok()).collect::<Vec<_>>();
            let mut numbers = Vec::with_capacity(self.places.len());
            for (other, n) in other.into_iter().zip(&self.n_places) {
                match other {
                    Some(other) => numbers.extend(other.numbers(scene, run)?),
                    None => numbers.resize(numbers.len() + n, f64::NAN),
                }
            }
            return Ok(numbers);
        }
        let mut points = Vec::new();
        if self.has_points {
            let mut c = info.declared_values();
            scene.constants(&scene.parameters(), &mut c);
            let last = run.last();
            points.resize(2 * info.points.len(), 0.0);
            scene.points(&c, last.t, last.coordinates, &mut points);
        }
        let has_work = run.first().wanted.work;
        let column = |i: usize| if has_work { Some(i) } else { self.without_work[i] };
        let last: Vec<f64> = run.last().numbers().collect();
        let extreme = |i: usize, choose: fn(f64, f64) -> f64| {
            let of_sample = |sample: ezy_core::record::Sample<'_>| sample.numbers().nth(column(i)?);
            run.samples().filter_map(of_sample).reduce(choose).unwrap_or(f64::NAN)
        };
        let events =
            |name: &str| run.events().iter().filter(move |occurred| occurred.event.name == name).collect::<Vec<_>>();
        let number = |place: &Place| match place {
            Place::End(i) => column(*i).map_or(f64::NAN, |i| last[i]),
            Place::Smallest(i) => extreme(*i, f64::min),
            Place::Largest(i) => extreme(*i, f64::max),
            Place::Point(i) => points[*i],
            Place::FirstTime(name) => events(name).first().map_or(f64::NAN, |occurred| occurred.state.t),
            Place::Count(name) => events(name).len() as f64,
            Place::Error(unit) => match (&run.error_estimate, unit) {
                (Some(Ok(estimate)), Some(unit)) => {
                    let of_unit = estimate.errors.iter().filter(|error| error.unit == *unit && error.quantity != "end");
                    of_unit.map(|error| error.largest).reduce(f64::max).unwrap_or(f64::NAN)
                }
                (Some(Ok(estimate)), None) => estimate.amplification.unwrap_or(f64::NAN),
                _ => f64::NAN,
            },
        };
        Ok(self.places.iter().map(number).collect())
    }

    /// The numbers at the end of a run of which no more is known: those of a sample without works, and the points.
    pub(super) fn numbers_of_end(&self, EndOfRun { numbers, points, .. }: &EndOfRun) -> Vec<f64> {
        let number = |place: &Place| match place {
            Place::End(i) => self.without_work[*i].map_or(f64::NAN, |i| numbers[i]),
            Place::Point(i) => points[*i],
            _ => f64::NAN,
        };
        self.places.iter().map(number).collect()
    }

    /// The first of what is kept that is not known from the end of a run alone.
    pub(super) fn beyond_end(&self) -> Option<&str> {
        let is_beyond = |place: &Place| match place {
            Place::End(i) => self.without_work[*i].is_none(),
            place => !matches!(place, Place::Point(_)),
        };
        let column = self.places.iter().position(is_beyond).map(|i| self.columns[i].name.as_str());
        column.or(self.keeps_samples.then_some("samples"))
    }
}

#[cfg(test)]
mod tests {
    use crate::sweep::{Case, Plan, Sweep};
    use ezy_core::model::Derived as _;
    use ezy_core::simulate::Simulation;

    ezy_core::model! {
        /// Balls that fly apart.
        pub model Volley {
            count n = 5;
            param v: m/s = 1;
            body ball[n] { mass: 1, inertia: 1 }
            start here { for i in 0..n { ball[i] at (0, 0) angle 0 velocity (v*i, 0) rate 0; } }
            scene flies { start here; until 1 s; }
        }
    }

    /// Ball i is at i m after 1 s, whatever the count of the case; two have no fifth.
    #[test]
    fn analytic_columns_of_other_counts_are_found_by_name() {
        let run = |case: &Case<'_>| {
            let mut scene = volley::Flies::default();
            scene.set_count(0, case.get("n")? as usize);
            Ok(case.run(Simulation::new(&scene))?)
        };
        let sweep = Sweep::new(&volley::Flies::default(), Plan::new().grid("n", [5.0, 2.0, 7.0]), run);
        let table = sweep.keep(["ball[1].vx", "max:ball[4].x", "kinetic"]).run().unwrap();
        let numbers = |name: &str| table.numbers(name).unwrap();
        // of a run at its usual tolerance, on numbers up to 50
        let near = |x: f64, y: f64| (x - y).abs() <= 1e-8;
        assert!(numbers("ball[1].vx").iter().all(|v| near(*v, 1.0)));
        let [five, two, seven] = numbers("max:ball[4].x")[..] else { panic!("three cases") };
        assert!(near(five, 4.0) && two.is_nan() && near(seven, 4.0), "{five} {two} {seven}");
        let kinetic = numbers("kinetic");
        assert!(near(kinetic[0], 15.0) && near(kinetic[1], 0.5) && near(kinetic[2], 45.5), "{kinetic:?}");
    }
}
