//! The measurement as a page.

use super::measured::WorkPrecision;
use crate::report::page::{Page, Picture, escape};
use crate::report::typeset::typeset;

/// The figures; `None` where there is nothing to draw.
pub(super) struct Pictures {
    pub end: Option<Picture>,
    pub grid: Option<Picture>,
    pub drift: Option<Picture>,
    pub energy: Option<Picture>,
}

impl WorkPrecision {
    pub(super) fn page(&self, pictures: &Pictures) -> String {
        let mut page = Page::new(&format!("What accuracy costs: {}/{}", self.info.model, self.info.name));
        self.write_advice(&mut page);
        self.write_cost(&mut page, pictures);
        self.write_errors(&mut page);
        self.write_projections(&mut page, pictures);
        self.write_reference(&mut page);
        self.write_method(&mut page);
        page.finish()
    }

    fn write_advice(&self, page: &mut Page) {
        page.section("advice", "Which method to use");
        self.reservations().iter().for_each(|text| {
            page.paragraph(text);
        });
        list(page, &self.advice());
        page.paragraph(&format!(
            "The motion runs from {} s to {} s. A time is the shortest processor time of repeated runs that keep only their two ends, with positions and velocities \
             projected after each step; {}.",
            self.start_s, self.until_s, self.machine
        ));
    }

    fn write_cost(&self, page: &mut Page, pictures: &Pictures) {
        page.section("cost", "Time against error");
        page.paragraph(
            "Each point is one setting: a tolerance, or a step of a method with a fixed step. Errors are those that were achieved against the \
             reference, not those that were asked for. Every method runs the same compiled equations. Further down is faster, further to the left \
             more accurate; where a curve turns upright, rounding is all that is left.",
        );
        picture(
            page,
            &pictures.end,
            "work-precision",
            "Time of a run against the largest error of a position at the end.",
        );
        picture(
            page,
            &pictures.grid,
            "work-precision-grid",
            "Time of a run against the largest error of a position over a grid of equal intervals. Values between steps cost further evaluations, \
             which the times leave out; the table states them apart.",
        );
        scrolled(page, &self.cost_table().html("Counts are the same on every machine, times belong to this one"));
    }

    fn write_errors(&self, page: &mut Page) {
        page.section("errors", "Errors");
        page.paragraph(
            "The largest over the grid, in m and rad, m/s and rad/s, N and N m; scaled ones are divided by the largest magnitude that components of \
             the same unit reach. Residuals and energy are the largest over the grid.",
        );
        scrolled(page, &self.error_table().html("Errors against the reference, positions and velocities projected"));
    }

    fn write_projections(&self, page: &mut Page, pictures: &Pictures) {
        page.section("projection", "What projections do");
        if self.info.n_rows() == 0 {
            page.paragraph("The scene has no constraints, so there is nothing to drift off.");
            return;
        }
        let drift = "Drift off the constraints, the largest over the grid, for each projection.";
        picture(page, &pictures.drift, "drift", drift);
        let energy = "Kinetic and potential energy less work: its largest change over the grid, for each projection.";
        picture(page, &pictures.energy, "energy", energy);
        scrolled(page, &self.projection_table().html("Each projection at one setting of each method"));
    }

    fn write_reference(&self, page: &mut Page) {
        page.section("reference", "The reference");
        for text in self.reference_text() {
            page.paragraph(&text);
        }
    }

    fn write_method(&self, page: &mut Page) {
        page.section("method", "How it was measured");
        page.paragraph(&format!(
            "Each setting runs once on a grid of {} intervals, with works and energy balance; that run gives errors and residuals and warms up. \
             Then runs that keep only their two ends are timed: at least seven, fewer where one takes longer than a tenth of a second. \
             Other projections than the default one take every second setting. EZY {}, {}. Times are processor times of one thread{}. The measurement took {:.1} s of {} s.",
            self.reference.trajectory.times().len() - 1,
            ezy_core::simulate::VERSION,
            self.machine,
            self.processor_share.map_or(", as far as the system tells them apart from wall times", |_| ""),
            self.seconds,
            self.budget_s
        ));
        let missing = self.missing_text();
        if !missing.is_empty() {
            page.heading("Not measured");
            list(page, &missing);
        }
    }
}

fn list<T: ToString>(page: &mut Page, items: &[T]) {
    let items: String =
        items.iter().map(|item| format!("<li>{}</li>\n", escape(&typeset(&item.to_string())))).collect();
    page.html(&format!("<ul>\n{items}</ul>"));
}

fn scrolled(page: &mut Page, table: &str) {
    page.html(&format!("<div class=\"scroll compact\">{table}</div>"));
}

fn picture(page: &mut Page, picture: &Option<Picture>, name: &str, caption: &str) {
    match picture {
        Some(picture) => {
            let [svg_file, png_file] = ["svg", "png"].map(|extension| format!("{name}.{extension}"));
            page.figure(picture.clone(), caption, caption, &[&svg_file, &png_file, "accuracy.csv"]);
        }
        None => {
            page.paragraph(&format!("{caption} It is zero throughout, so that there is nothing to draw."));
        }
    }
}
