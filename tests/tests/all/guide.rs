//! The guide is whole: its table of contents lists each page once, and links and pictures lead somewhere.

use std::fs;
use std::path::{Path, PathBuf};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/guide/src")
}

/// A page without its programs and what they print.
fn prose(path: &Path) -> String {
    let page = fs::read_to_string(path).unwrap();
    page.split("\n```").step_by(2).collect()
}

/// Targets of links and pictures, but those to other hosts.
fn targets(page: &str) -> impl Iterator<Item = &str> {
    let links = page.split("](").skip(1).filter_map(|rest| rest.split_once(')'));
    links.map(|(target, _)| target).filter(|target| !target.contains("://"))
}

/// Names by which a page's headings are linked.
fn anchors(page: &str) -> Vec<String> {
    let headings = page.lines().filter(|line| line.starts_with('#'));
    let slug = |heading: &str| {
        let kept = heading.trim_start_matches('#').trim().to_lowercase();
        kept.chars()
            .filter(|c| c.is_alphanumeric() || "-_ ".contains(*c))
            .map(|c| if c == ' ' { '-' } else { c })
            .collect()
    };
    headings.map(slug).collect()
}

#[test]
fn invariant_guide_lists_each_page_once() {
    let summary = fs::read_to_string(folder().join("SUMMARY.md")).unwrap();
    let mut listed: Vec<&str> = targets(&summary).collect();
    listed.sort_unstable();
    let names = fs::read_dir(folder()).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let mut found: Vec<String> = names.filter(|name| name.ends_with(".md") && name != "SUMMARY.md").collect();
    found.sort_unstable();
    assert_eq!(listed, found);
}

#[test]
fn invariant_links_and_pictures_of_the_guide_exist() {
    let mut pictures: Vec<PathBuf> =
        fs::read_dir(folder().join("pictures")).unwrap().map(|entry| entry.unwrap().path()).collect();
    for page in fs::read_dir(folder()).unwrap().map(|entry| entry.unwrap().path()).filter(|path| path.is_file()) {
        let text = prose(&page);
        for target in targets(&text) {
            let (file, anchor) = target.split_once('#').unwrap_or((target, ""));
            let path = if file.is_empty() { page.clone() } else { folder().join(file) };
            assert!(path.exists(), "{} links to `{target}`, which is not there", page.display());
            let known = anchor.is_empty() || anchors(&prose(&path)).iter().any(|of| of == anchor);
            assert!(known, "{} links to `{target}`, which is no heading", page.display());
            pictures.retain(|picture| *picture != path);
        }
    }
    assert!(pictures.is_empty(), "no page shows {pictures:?}");
}
