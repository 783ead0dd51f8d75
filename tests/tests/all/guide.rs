//! The book of `docs` is whole: its table of contents lists each page once, and links and pictures lead somewhere.

use std::fs;
use std::path::{Path, PathBuf};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs")
}

/// Files of `docs` and of its folders.
fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    entries.flat_map(|path| if path.is_dir() { files(&path) } else { vec![path] }).collect()
}

/// Pages but the table of contents.
fn pages() -> Vec<PathBuf> {
    let is_page =
        |path: &PathBuf| path.extension().is_some_and(|ending| ending == "md") && !path.ends_with("SUMMARY.md");
    files(&folder()).into_iter().filter(is_page).collect()
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
fn invariant_book_lists_each_page_once() {
    let summary = fs::read_to_string(folder().join("SUMMARY.md")).unwrap();
    let mut listed: Vec<PathBuf> = targets(&summary).map(|target| folder().join(target)).collect();
    listed.sort_unstable();
    let mut found = pages();
    found.sort_unstable();
    assert_eq!(listed, found);
}

#[test]
fn invariant_links_and_pictures_of_the_book_exist() {
    let is_picture = |path: &PathBuf| path.parent().is_some_and(|folder| folder.ends_with("pictures"));
    let mut pictures: Vec<PathBuf> = files(&folder()).into_iter().filter(is_picture).collect();
    for page in pages() {
        let text = prose(&page);
        for target in targets(&text) {
            let (file, anchor) = target.split_once('#').unwrap_or((target, ""));
            let path = if file.is_empty() { page.clone() } else { page.with_file_name(file) };
            assert!(path.exists(), "{} links to `{target}`, which is not there", page.display());
            let known = anchor.is_empty() || anchors(&prose(&path)).iter().any(|of| of == anchor);
            assert!(known, "{} links to `{target}`, which is no heading", page.display());
            // mdBook takes a page for one of its own
            let is_page = file.ends_with(".md");
            let is_within = || path.canonicalize().unwrap().starts_with(folder().canonicalize().unwrap());
            assert!(!is_page || is_within(), "{} links to `{target}`, which is not in the book", page.display());
            pictures.retain(|picture| *picture != path);
        }
    }
    assert!(pictures.is_empty(), "no page shows {pictures:?}");
}
