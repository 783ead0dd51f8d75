//! The results of a sweep as figures: curves over one value, maps over two.

use std::path::Path;

use super::failure::Failure;
use ezy_study::sweep::Plan;

/// Cells of all figures together, at most: they are in memory at once.
const MOST_CELLS: u64 = 50_000_000;

/// The values of `--vary` that have more than one, and that all others have one.
fn axes(plan: &Plan) -> Option<Vec<(&str, &[f64])>> {
    let axes: Vec<_> = plan.axes()?.into_iter().filter(|(_, values)| values.len() > 1).collect();
    (1..=2).contains(&axes.len()).then_some(axes)
}

/// That the results can be drawn, found before the runs.
pub(super) fn check(plan: &Plan) -> Result<(), Failure> {
    let axes = axes(plan).ok_or_else(|| {
        Failure::wrong_use("--plot draws over one or two values of --vary with several numbers each; draw other results with a program that reads the table")
    })?;
    let is_distinct = |values: &[f64]| {
        let mut sorted = values.to_vec();
        sorted.sort_by(f64::total_cmp);
        sorted.windows(2).all(|pair| pair[0] < pair[1])
    };
    if let Some((name, _)) = axes.iter().find(|(_, values)| !is_distinct(values)) {
        return Err(Failure::wrong_use(format!("--plot: `{name}` has the same value twice; give each once")));
    }
    match plan.n_cases() {
        Ok(n) if n <= MOST_CELLS => Ok(()),
        _ => Err(Failure::wrong_use(format!(
            "--plot draws up to {MOST_CELLS} cases; draw more with a program that reads the table"
        ))),
    }
}

#[cfg(not(feature = "figures"))]
pub(super) fn write(_: &Path, _: &Plan, _: &str) -> Result<(), Failure> {
    super::drawing::check()
}

/// Draws each column that is kept, as SVG and PNG, and a page with all of them. Without all parts nothing is drawn.
#[cfg(feature = "figures")]
pub(super) fn write(folder: &Path, plan: &Plan, scene: &str) -> Result<(), Failure> {
    use super::drawing_of_columns::axis;
    use ezy_study::output;
    use ezy_study::report::figure::Figure;
    use ezy_study::report::page::Page;
    use ezy_study::sweep::{Cell, Kind, Results};

    let Some(axes) = axes(plan) else { return check(plan) };
    let results = Results::open(&[folder]).map_err(Failure::stopped)?;
    results.check_complete().map_err(|why| Failure::stopped(format!("nothing is drawn: {why}")))?;
    let columns = results.columns();
    let n_varied = plan.names().len();
    // behind the number of the case and what is varied, before `end`, `steps`, `outcome`, `message`
    let kept: Vec<usize> =
        (1 + n_varied..columns.len().saturating_sub(4)).filter(|i| columns[*i].kind == Kind::Number).collect();
    let n = usize::try_from(results.n_cases()).map_err(Failure::stopped)?;
    let mut values = vec![vec![f64::NAN; n]; kept.len()];
    let mut n_failed = 0;
    for part in results.parts() {
        for row in part.map_err(Failure::stopped)? {
            if !row.is_good() {
                n_failed += 1;
                continue;
            }
            for (values, column) in values.iter_mut().zip(&kept) {
                if let Cell::Number(x) = row.cells[column - 1] {
                    values[row.index as usize] = x;
                }
            }
        }
    }
    // ascending, whatever the order of --vary
    let order = |of: &[f64]| {
        let mut order: Vec<usize> = (0..of.len()).collect();
        order.sort_by(|a, b| of[*a].total_cmp(&of[*b]));
        order
    };
    let label = |name: &str| {
        let column = columns.iter().find(|column| column.name == name);
        axis(name, column.map_or("", |column| &column.unit))
    };
    let mut page = Page::new(&format!("{scene}: {n} runs"));
    let varied: Vec<String> = axes.iter().map(|(name, of)| format!("{} values of {}", of.len(), label(name))).collect();
    page.paragraph(&format!(
        "{}. {}",
        varied.join(" and "),
        if n_failed == 0 {
            "Every run reached its end.".to_owned()
        } else {
            format!("{n_failed} of {n} runs failed; they are left out.")
        }
    ));
    for (values, column) in values.into_iter().zip(&kept) {
        let column = &columns[*column];
        let z_label = axis(&column.name, &column.unit);
        let figure = match axes[..] {
            [(y_name, y), (x_name, x)] => {
                let (rows, places) = (order(y), order(x));
                let z = rows
                    .iter()
                    .flat_map(|row| places.iter().map(move |place| row * x.len() + place))
                    .map(|i| values[i]);
                let z: Vec<f64> = z.collect();
                let sorted = |order: &[usize], of: &[f64]| order.iter().map(|i| of[*i]).collect::<Vec<_>>();
                let (x, y) = (sorted(&places, x), sorted(&rows, y));
                Figure::map(&format!("{scene}: {}", column.name), &label(x_name), &label(y_name), &z_label, x, y, z)
            }
            [(name, x)] => {
                let places = order(x);
                let of = |numbers: &[f64]| places.iter().map(|i| numbers[*i]).collect::<Vec<_>>();
                Figure::plane(&format!("{scene}: {}", column.name), &label(name), &z_label).line(
                    &column.name,
                    of(x),
                    of(&values),
                )
            }
            _ => continue,
        };
        let file: String = column.name.chars().map(|c| if c.is_alphanumeric() || c == '.' { c } else { '-' }).collect();
        match figure.save(folder, &file) {
            Ok(picture) => {
                let over = axes.iter().map(|(name, _)| *name).collect::<Vec<_>>().join(" and ");
                let [svg, png] = ["svg", "png"].map(|ending| format!("{file}.{ending}"));
                page.figure(
                    picture,
                    &format!("{} over {over}", column.name),
                    &format!("{} over {over}", column.name),
                    &[&svg, &png],
                );
            }
            Err(why) => {
                page.paragraph(&format!("{}: {why}", column.name));
            }
        }
    }
    let path = folder.join("index.html");
    output::write(&path, page.finish()).map_err(|cause| Failure::stopped(format!("`{}`: {cause}", path.display())))
}
