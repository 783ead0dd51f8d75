//! One self-contained HTML page: no script, no font, no picture from elsewhere.

use std::fmt::Write as _;

use super::typeset::typeset;

/// A page that is built from top to bottom.
#[derive(Debug, Clone)]
pub struct Page {
    title: String,
    body: String,
    contents: String,
    n_figures: usize,
}

/// SVG texts of one figure.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Picture {
    /// For a screen, a slide, paper.
    pub wide: String,
    /// For the screen of a telephone; empty: the wide one serves.
    pub narrow: String,
}

impl From<&str> for Picture {
    fn from(svg: &str) -> Self {
        Self { wide: svg.to_owned(), narrow: String::new() }
    }
}

/// Readable on a screen and on paper; wide equations and tables scroll inside their own box.
const STYLE: &str = "\
:root { color-scheme: light dark; --ink: #1a1a1a; --paper: #fff; --head: #002d62; --link: #00509e; --soft: #444; --line: #ccc; }
@media screen and (prefers-color-scheme: dark) {
  :root { --ink: #e4e4e4; --paper: #191919; --head: #9cc4f5; --link: #8ab8f0; --soft: #b8b8b8; --line: #4a4a4a; }
  /* white becomes the paper of the page, hues stay; sketches take the colours of the page */
  figure svg:not(.ezy) { filter: invert(.902) hue-rotate(180deg); }
}
body { max-width: 62rem; margin: 2rem auto; padding: 0 1rem; font: 1rem/1.55 system-ui, sans-serif; color: var(--ink); background: var(--paper); }
h1, h2, h3 { line-height: 1.25; color: var(--head); }
h2 { margin-top: 2.6rem; border-bottom: 1px solid var(--line); }
nav ol { columns: 20rem 2; padding-left: 1.6rem; }
nav li { break-inside: avoid; }
a { color: var(--link); }
figure { margin: 1.4rem 0; break-inside: avoid; }
figure svg { width: 100%; height: auto; max-height: 40rem; }
figure .narrow { display: none; }
figcaption, caption { color: var(--soft); font-size: .95em; text-align: left; }
figcaption a { overflow-wrap: anywhere; }
/* a shadow at the side where more is hidden; what is at the end covers it */
.scroll, main > table {
  --shadow: color-mix(in srgb, var(--ink) 25%, transparent);
  background: linear-gradient(90deg, var(--paper) 50%, transparent) 0 0 / 2rem 100% no-repeat local,
    linear-gradient(270deg, var(--paper) 50%, transparent) 100% 0 / 2rem 100% no-repeat local,
    linear-gradient(90deg, var(--shadow), transparent) 0 0 / .5rem 100% no-repeat,
    linear-gradient(270deg, var(--shadow), transparent) 100% 0 / .5rem 100% no-repeat;
}
.scroll { overflow-x: auto; }
math { font-family: \"STIX Two Math\", \"Cambria Math\", \"Latin Modern Math\", \"TeX Gyre Termes Math\", \"Libertinus Math\", \"DejaVu Math TeX Gyre\", math; }
math[display=block] { margin: .9rem 0; }
table { border-collapse: collapse; margin: 1rem 0; font-variant-numeric: tabular-nums; }
th, td { padding: .25rem .8rem; border-bottom: 1px solid var(--line); text-align: left; vertical-align: top; }
.number { text-align: right; }
.compact { font-size: .85em; }
.compact td { white-space: nowrap; padding: .1rem .5rem; }
pre { overflow-x: auto; }
@media screen and (max-width: 40rem) {
  body { margin: 1rem auto; }
  .scroll > math { font-size: .85em; }
  th, td { padding: .2rem .4rem; }
  /* tables of numbers scroll, their captions do not */
  main > table:not(.words) { display: block; overflow-x: auto; }
  main > table:not(.words) caption { display: block; position: sticky; left: 0; }
  main > table:not(.words) td { white-space: nowrap; }
  /* of a table with sentences each row is a box: short cells beside each other, sentences below */
  .words, .words caption, .words thead, .words tbody { display: block; }
  .words tr { display: grid; grid-template-columns: repeat(var(--short), minmax(min-content, 1fr)); column-gap: .4rem; padding: .4rem 0; border-bottom: 1px solid var(--line); }
  .words th, .words td { border: 0; padding: 0; text-align: left; grid-row: 1; overflow-wrap: break-word; }
  .words .sentence { grid-column: 1 / -1; grid-row: auto; }
  .words td.sentence::before { content: attr(data-head) \": \"; color: var(--soft); }
  .words th.sentence { display: none; }
  figure .wide { display: none; }
  figure .narrow { display: block; }
}
@media print {
  :root { --ink: #000; --paper: #fff; --head: #002d62; --link: #000; --soft: #333; --line: #bbb; }
  body { max-width: none; margin: 0; font-size: 10pt; }
  nav, details { display: none; }
  h2 { margin-top: 1.4rem; }
  h2, h3, caption, p:has(+ .scroll), p:has(+ figure) { break-after: avoid; }
  tr, main > table, .scroll > math { break-inside: avoid; }
  thead { display: table-header-group; }
  .scroll { overflow: visible; }
  .scroll, main > table { background: none; }
  .compact { font-size: .7em; }
  figure svg { max-height: 8cm; }
  th, td { padding: .1rem .4rem; }
}
";

/// A matrix in MathML from its rows, `<mtr>` elements, in brackets like those of the equations of a scene.
pub fn bracketed(rows: &str) -> String {
    let border = "border: solid; border-width: 0 .09em; border-radius: .7em; padding: .1em .2em";
    format!("<mtable style=\"{border}\">{rows}</mtable>")
}

impl Page {
    /// An empty page with its headline.
    pub fn new(title: &str) -> Self {
        Self { title: title.to_owned(), body: String::new(), contents: String::new(), n_figures: 0 }
    }

    /// Starts a section, and lists it in the table of contents under `id`.
    pub fn section(&mut self, id: &str, heading: &str) -> &mut Self {
        let heading = escape(heading);
        _ = writeln!(self.contents, "<li><a href=\"#{id}\">{heading}</a></li>");
        self.html(&format!("<h2 id=\"{id}\">{heading}</h2>"))
    }

    /// A heading inside a section.
    #[cfg(feature = "figures")]
    pub(crate) fn heading(&mut self, heading: &str) -> &mut Self {
        self.html(&format!("<h3>{}</h3>", escape(heading)))
    }

    /// A paragraph of plain text, with its numbers as people write them.
    pub fn paragraph(&mut self, text: &str) -> &mut Self {
        self.html(&format!("<p>{}</p>", escape(&typeset(text))))
    }

    /// A `<math>` element, in a box of its own that scrolls when it is wide.
    pub fn equation(&mut self, mathml: &str) -> &mut Self {
        self.html(&format!("<div class=\"scroll\">{mathml}</div>"))
    }

    /// A figure. `alternative` says what is seen, for those who do not see it; `files` names the files beside the page that
    /// hold the same figure and its numbers.
    pub fn figure(
        &mut self,
        picture: impl Into<Picture>,
        caption: &str,
        alternative: &str,
        files: &[&str],
    ) -> &mut Self {
        self.n_figures += 1;
        let Picture { wide, narrow } = picture.into();
        let svg = match narrow.is_empty() {
            true => labelled(&wide, alternative),
            false => format!(
                "<div class=\"wide\">{}</div><div class=\"narrow\">{}</div>",
                labelled(&wide, alternative),
                labelled(&narrow, alternative)
            ),
        };
        let links = files.iter().map(|file| format!("<a href=\"{file}\">{file}</a>")).collect::<Vec<_>>().join(", ");
        let links = if links.is_empty() { links } else { format!(" ({links})") };
        let caption = format!("Figure {}. {}{links}", self.n_figures, escape(&typeset(caption)));
        self.html(&format!("<figure>\n{svg}<figcaption>{caption}</figcaption>\n</figure>"))
    }

    /// HTML as it is.
    pub fn html(&mut self, html: &str) -> &mut Self {
        self.body += html;
        self.body.push('\n');
        self
    }

    /// The whole page.
    pub fn finish(&self) -> String {
        let Self { body, contents, .. } = self;
        let title = escape(&self.title);
        format!(
            "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{title}</title>\n\
             <style>\n{STYLE}</style>\n</head>\n<body>\n<h1>{title}</h1>\n\
             <nav aria-label=\"Contents\">\n<ol>\n{contents}</ol>\n</nav>\n<main>\n{body}</main>\n</body>\n</html>\n"
        )
    }
}

/// Text as it may stand between tags and in attributes.
pub fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// Text of a documentation: what stands in backquotes is code.
pub fn prose(text: &str) -> String {
    let parts = escape(text.trim());
    let parts = parts.split('`').enumerate();
    parts.map(|(i, part)| if i % 2 == 0 { part.to_owned() } else { format!("<code>{part}</code>") }).collect()
}

/// Makes an SVG document an element of a page: no XML header, a label.
fn labelled(svg: &str, alternative: &str) -> String {
    let element = svg.find("<svg").map_or("", |start| &svg[start + "<svg".len()..]);
    let element = element.replacen(" xmlns=\"http://www.w3.org/2000/svg\"", "", 1);
    format!("<svg role=\"img\" aria-label=\"{}\"{element}", escape(alternative))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn invariant_page_shows_one_of_two_widths_and_says_what_is_seen() {
        let svg = |width: u8| {
            format!(
                "<?xml version=\"1.0\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"ezy\" viewBox=\"0 0 {width} 5\"></svg>\n"
            )
        };
        let mut page = Page::new("A < B");
        let picture = Picture { wide: svg(9), narrow: svg(4) };
        page.section("s", "One").figure(picture, "first", "a \"curve\"", &["a.svg"]).figure(
            &*svg(9),
            "second",
            "b",
            &[],
        );
        let html = page.finish();
        for expected in [
            // the picture keeps the class that its colours belong to
            "<div class=\"wide\"><svg role=\"img\" aria-label=\"a &quot;curve&quot;\" class=\"ezy\" viewBox=\"0 0 9 5\">",
            "<div class=\"narrow\"><svg role=\"img\" aria-label=\"a &quot;curve&quot;\" class=\"ezy\" viewBox=\"0 0 4 5\">",
            "<svg role=\"img\" aria-label=\"b\" class=\"ezy\" viewBox=\"0 0 9 5\">",
        ] {
            assert!(html.contains(expected), "{expected} in {html}");
        }
        assert!(html.contains("<title>A &lt; B</title>") && !html.contains("<?xml") && !html.contains("http:"));
    }
}
