//! One self-contained HTML page: no script, no font, no picture from elsewhere.

use std::fmt::Write as _;

/// A page that is built from top to bottom.
#[derive(Debug, Clone)]
pub struct Page {
    title: String,
    body: String,
    contents: String,
    n_figures: usize,
}

/// Readable on a screen and on paper; wide equations and tables scroll inside their own box.
const STYLE: &str = "\
:root { color-scheme: light; }
body { max-width: 62rem; margin: 2rem auto; padding: 0 1rem; font: 1rem/1.55 system-ui, sans-serif; color: #1a1a1a; background: #fff; }
h1, h2, h3 { line-height: 1.25; color: #002d62; }
h2 { margin-top: 2.6rem; border-bottom: 1px solid #bbb; }
nav ol { columns: 2; }
a { color: #00509e; }
figure { margin: 1.4rem 0; break-inside: avoid; }
figure svg { width: 100%; height: auto; }
figcaption, caption { color: #444; font-size: .95em; text-align: left; }
.scroll { overflow-x: auto; }
math[display=block] { margin: .9rem 0; }
table { border-collapse: collapse; margin: 1rem 0; font-variant-numeric: tabular-nums; }
th, td { padding: .25rem .8rem; border-bottom: 1px solid #ddd; text-align: left; vertical-align: top; }
.number { text-align: right; }
.compact { font-size: .85em; }
.compact td { white-space: nowrap; padding: .1rem .5rem; }
@media print {
  body { max-width: none; margin: 0; font-size: 10pt; }
  nav, details { display: none; }
  h2, h3, caption, p:has(+ .scroll) { break-after: avoid; }
  tr, .scroll > math { break-inside: avoid; }
  .scroll { overflow: visible; }
  figure svg { max-height: 9cm; }
  th, td { padding: .15rem .4rem; }
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

    /// A paragraph of plain text.
    pub fn paragraph(&mut self, text: &str) -> &mut Self {
        self.html(&format!("<p>{}</p>", escape(text)))
    }

    /// A `<math>` element, in a box of its own that scrolls when it is wide.
    pub fn equation(&mut self, mathml: &str) -> &mut Self {
        self.html(&format!("<div class=\"scroll\">{mathml}</div>"))
    }

    /// A figure as SVG text. `alternative` says what is seen, for those who do not see it; `files` names the
    /// files beside the page that hold the same figure and its numbers.
    pub fn figure(&mut self, svg: &str, caption: &str, alternative: &str, files: &[&str]) -> &mut Self {
        self.n_figures += 1;
        let svg = inline_svg(svg, self.n_figures, alternative);
        let links = files.iter().map(|file| format!("<a href=\"{file}\">{file}</a>")).collect::<Vec<_>>().join(", ");
        let caption = format!("Figure {}. {} ({links})", self.n_figures, escape(caption));
        self.html(&format!("<figure>\n{svg}\n<figcaption>{caption}</figcaption>\n</figure>"))
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
#[cfg(feature = "cli")]
pub(crate) fn prose(text: &str) -> String {
    let parts = escape(text.trim());
    let parts = parts.split('`').enumerate();
    parts.map(|(i, part)| if i % 2 == 0 { part.to_owned() } else { format!("<code>{part}</code>") }).collect()
}

/// Makes an SVG document an element of a page: no XML header, scalable, labelled, identifiers of its own.
fn inline_svg(svg: &str, number: usize, alternative: &str) -> String {
    let element = svg.find("<svg").map_or(svg, |start| &svg[start..]).trim_end();
    let (open, rest) = element.split_once('>').unwrap_or((element, ""));
    let attribute = |name: &str| open.split_once(&format!(" {name}=\"")).and_then(|(_, tail)| tail.split('"').next());
    let view_box = match (attribute("viewBox"), attribute("width"), attribute("height")) {
        (None, Some(width), Some(height)) => format!(" viewBox=\"0 0 {width} {height}\""),
        _ => String::new(),
    };
    let open = open.replace(" xmlns=\"http://www.w3.org/2000/svg\"", "");
    let rest = rest
        .replace("id=\"clip", &format!("id=\"figure{number}-clip"))
        .replace("url(#clip", &format!("url(#figure{number}-clip"));
    format!("{open}{view_box} role=\"img\" aria-label=\"{}\">{rest}", escape(alternative))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn invariant_page_with_two_figures_has_distinct_identifiers() {
        let svg = "<?xml version=\"1.0\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"9\" height=\"5\"><clipPath id=\"clip1\"/><g clip-path=\"url(#clip1)\"/></svg>";
        let mut page = Page::new("A < B");
        page.section("s", "One").figure(svg, "first", "a \"curve\"", &["a.svg"]).figure(svg, "second", "b", &[]);
        let html = page.finish();
        for expected in ["id=\"figure1-clip1\"", "url(#figure2-clip1)", "viewBox=\"0 0 9 5\"", "a &quot;curve&quot;"] {
            assert!(html.contains(expected), "{expected} in {html}");
        }
        assert!(html.contains("<title>A &lt; B</title>") && !html.contains("<?xml") && !html.contains("http:"));
    }
}
