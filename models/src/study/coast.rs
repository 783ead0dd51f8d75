//! Part (e): coasting for one second.

use ezy_core::model::{Name, Scene};
use ezy_study::report::figure::Figure;
use ezy_study::report::page::Page;
use ezy_study::report::table::{Table, fixed};

use super::error::StudyError;
use super::motion::Motion;
use super::output::{Output, Plate};
use super::parts::largest;
use crate::ezy_roller::Coast;
use std::sync::atomic::AtomicBool;

const STEP_S: f64 = 1e-3;
const EVERY_S: f64 = 5e-3;
/// Samples between the instants at which the bodies are drawn.
const DRAWN_EVERY: usize = 50;
/// Half of the seat's rear axle, half a wheel, and how far below the path of A times stand, m: how the drawing looks, nothing else.
const SEAT_AXLE_M: f64 = 0.12;
const TIMES_BELOW_M: f64 = 0.16;
const WHEEL_M: f64 = 0.04;

/// What part (e) found.
pub struct Coasting {
    /// Assembled start velocities, by name.
    pub start: Vec<(Name, f64)>,
    /// Heading of the seat at the end, rad.
    pub end_heading: f64,
    /// Kinetic energy at the start, J.
    pub kinetic_energy: f64,
    /// Largest change of the kinetic energy, J.
    pub energy_drift: f64,
}

impl Coasting {
    /// Runs, and puts figure and numbers on the page.
    pub fn study(page: &mut Page, output: &Output, interrupt: &AtomicBool) -> Result<Self, StudyError> {
        let scene = Coast::default();
        let motion = Motion::new(&scene, STEP_S, scene.info().until_s, EVERY_S, interrupt)?;
        let (first, last) = (motion.run.first(), motion.run.last());
        let names = first.info.velocities.iter().map(|c| c.name.clone());
        let found = Self {
            start: names.zip(first.velocities.iter().copied()).collect(),
            end_heading: last.get("seat.phi")?,
            kinetic_energy: first.energy.kinetic,
            energy_drift: largest(motion.run.samples().map(|s| s.energy.balance)),
        };
        page.section("e", "(e) Coasting");
        page.paragraph(
            "The bar stands across the seat, the seat moves at 1 m/s without turning, nothing drives or brakes. Given are the seat's position, \
             both angles, the forward velocity of the seat and its rate; the bar's position and all other velocities are assembled from the \
             constraints.",
        );
        page.html(&found.start_table(&motion).html("Start and end of the coasting run"));
        output.plate(page, found.plate(&motion)?)?;
        page.paragraph(&format!(
            "The front wheel swings behind the hinge within a fraction of a second, and the seat has turned by {:.3} degrees when the second is over. \
             Nothing does work: the kinetic energy stays at {:.4} J to {:.0e} J.",
            found.end_heading.to_degrees(),
            found.kinetic_energy,
            found.energy_drift
        ));
        Ok(found)
    }

    /// The assembled start value of a velocity.
    pub fn start_of(&self, name: &str) -> f64 {
        self.start.iter().find(|(known, _)| *known == name).map_or(f64::NAN, |(_, value)| *value)
    }

    fn start_table(&self, motion: &Motion<'_>) -> Table {
        let (first, last) = (motion.run.first(), motion.run.last());
        let mut table = Table::new(["coordinate", "start", "start velocity", "end", "end velocity", "unit"]);
        for (i, coordinate) in first.info.coordinates.iter().enumerate() {
            let cells = [first.coordinates[i], first.velocities[i], last.coordinates[i], last.velocities[i]];
            let [q0, v0, q1, v1] = cells.map(|value| fixed(value, 9));
            table.push([&*coordinate.name, &q0, &v0, &q1, &v1, coordinate.unit]);
        }
        table
    }

    fn plate<'a>(&self, motion: &Motion<'_>) -> Result<Plate<'a>, StudyError> {
        let [a, b, c] = ["A", "B", "C"].map(|point| motion.path(point));
        let (a, b, c) = (a?, b?, c?);
        let (phi_1, phi_2, t) = (motion.column("seat.phi")?, motion.column("bar.phi")?, motion.column("t")?);
        let n = t.len();
        let mut figure = Figure::track("Coasting for one second");
        for i in (0..n).step_by(DRAWN_EVERY) {
            let shade = i as f64 / (n - 1) as f64;
            let [at_a, at_b, at_c] = [&a, &b, &c].map(|path| [path.0[i], path.1[i]]);
            figure = with_bodies(figure, at_a, at_b, at_c, [phi_1[i], phi_2[i]], shade);
            figure = figure.note(at_a[0], a.1[0] - TIMES_BELOW_M, &format!("{:.2} s", t[i]));
        }
        figure = figure.line("rear wheel A", a.0.clone(), a.1.clone()).line("hinge B", b.0.clone(), b.1.clone()).line(
            "front wheel C",
            c.0.clone(),
            c.1.clone(),
        );
        Ok(Plate {
            name: "coast_motion",
            figure,
            columns: vec![
                ("t [s]", t),
                ("A.x [m]", a.0),
                ("A.y [m]", a.1),
                ("B.x [m]", b.0),
                ("B.y [m]", b.1),
                ("C.x [m]", c.0),
                ("C.y [m]", c.1),
                ("seat.phi [rad]", phi_1),
                ("bar.phi [rad]", phi_2),
            ],
            caption: "The bodies at five instants, faint at the start and strong at the end, with the paths of A, B and C. The triangle is the seat, from its \
                      rear axle to the hinge (ring); the line is the bar, from the hinge to its wheel; thick strokes are wheels. The seat is drawn with \
                      two wheels to look like a vehicle: the equations have one, A, in the middle of its axle."
                .to_owned(),
            alternative:
                "The seat moves to the right by one metre; the bar, at first across, swings behind the hinge; \
                          all three paths end almost straight."
                    .to_owned(),
        })
    }
}

/// The seat as a triangle from its axle to the hinge, the bar as a line to its wheel.
fn with_bodies(figure: Figure, a: [f64; 2], b: [f64; 2], c: [f64; 2], phi: [f64; 2], shade: f64) -> Figure {
    let [e1, e2] = phi.map(|phi| [phi.cos(), phi.sin()]);
    let across = |at: [f64; 2], e: [f64; 2], s: f64| [at[0] - s * e[1], at[1] + s * e[0]];
    let (left, right) = (across(a, e1, SEAT_AXLE_M), across(a, e1, -SEAT_AXLE_M));
    let wheel = |figure: Figure, at: [f64; 2], e: [f64; 2]| {
        let ends = [-WHEEL_M, WHEEL_M].map(|s| [at[0] + s * e[0], at[1] + s * e[1]]);
        figure.wheel(vec![ends[0][0], ends[1][0]], vec![ends[0][1], ends[1][1]], shade)
    };
    let outline = [b, left, right, b, c];
    let (x, y) = outline.iter().map(|p| (p[0], p[1])).unzip();
    let figure = figure.body("", x, y, shade);
    let figure = [left, right].into_iter().fold(figure, |figure, at| wheel(figure, at, e1));
    let figure = wheel(figure, c, e2);
    figure.hinges("", vec![b[0]], vec![b[1]])
}
