//! The page of an animation: markup, style and script in one file.

use ezy_core::scalar::legible;
use ezy_study::report::drawing::STYLE;
use ezy_study::report::page::{escape, prose};

use super::data::{Animation, Told};

const PAGE: &str = include_str!("page.html");
const LOOKS: &str = include_str!("page.css");
const SCRIPT: &str = include_str!("page.js");

/// Around the start, pixels: the view of a browser without scripts.
const MARGIN: f64 = 60.0;

/// The whole page.
pub(super) fn page(of: &Animation) -> String {
    let info = of.info();
    let parts = of.drawing.parts.iter().map(|part| {
        let (class, title, transform) = (&part.class, &part.title, of.drawing.transform(part, of.start()));
        format!(
            "<g class=\"part {class}\" transform=\"{transform}\"><title>{}</title>{}</g>\n",
            escape(title),
            part.svg
        )
    });
    let parameters = of.parameters().map(|(name, value, unit, documentation)| {
        let cells = [name, &legible(value).to_string(), unit, documentation].map(escape);
        format!(
            "<tr><th scope=\"row\">{}</th><td class=\"number\">{}</td><td>{}</td><td>{}</td></tr>\n",
            cells[0], cells[1], cells[2], cells[3]
        )
    });
    let Told { title, note, is_warning, origin, .. } = of.told();
    let note = match (&**note, is_warning) {
        ("", _) => String::new(),
        (note, true) => format!("<p role=\"alert\" class=\"stopped\">{}</p>", escape(note)),
        (note, false) => format!("<p class=\"note\">{}</p>", escape(note)),
    };
    // `</` would end the script
    let data = of.json().to_string().replace("</", "<\\/");
    let [x, y, width, height] = of.drawing.outline();
    let [width, height] = [width, height].map(|side| side + 2.0 * MARGIN);
    let view_box = format!("{:.0} {:.0} {width:.0} {height:.0}", x - MARGIN, y - MARGIN);
    let values = [
        ("MODEL", escape(info.model)),
        ("SCENE", escape(&format!("{}{title}", info.name))),
        ("DOCUMENTATION", prose(info.documentation)),
        ("NOTE", note),
        ("ORIGIN", escape(origin)),
        ("PARAMETERS", parameters.collect()),
        ("VIEWBOX", view_box),
        ("PARTS", parts.collect()),
        ("LOOKS", format!("{LOOKS}{STYLE}")),
        ("DATA", data),
        ("SCRIPT", SCRIPT.to_owned()),
    ];
    fill(PAGE, &values)
}

/// Replaces each `{{NAME}}` of a page once, from its beginning to its end.
fn fill(page: &str, values: &[(&str, String)]) -> String {
    let mut pieces = page.split("{{");
    let mut text = pieces.next().unwrap_or_default().to_owned();
    for piece in pieces {
        let (name, rest) = piece.split_once("}}").unwrap_or((piece, ""));
        text += values.iter().find(|(known, _)| *known == name).map_or("", |(_, value)| value);
        text += rest;
    }
    text
}
