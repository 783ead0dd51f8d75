#!/usr/bin/env python3
"""Plays animations in headless Chromium and checks what a user would see.

    tests/browser/check.py target/release/ezy [--shots DIR] [MODEL/SCENE ...]

Frames move, keys work, nothing is reported to the console, phone, dark and print look as they should be able to. With --shots
the pictures stay in DIR, to be looked at. Needs Python 3.9, and Chromium or Chrome in PATH or in $CHROMIUM (Debian: the package
`chromium`), and nothing else. Exit status 0: all holds; 1: a check failed; 77: there is no Chromium.
"""

import argparse
import pathlib
import subprocess
import sys
import tempfile
import time

import chromium

SCENES = ["ezyroller/driven", "fourbar/turning", "slidercrank/pushed", "wheeledsnake/slithering", "andrews/squeeze", "chain/swing"]
CALM = ("prefers-reduced-motion", "reduce")
DARK = ("prefers-color-scheme", "dark")

# what a reader of the page sees
PICTURE = "document.getElementById('canvas').toDataURL()"
CLOCK = "document.getElementById('clock').textContent"
PLAYING = "document.body.classList.contains('playing')"
WIDE = "document.documentElement.scrollWidth - document.documentElement.clientWidth"
# brightness of the page and of its text, from 0 to 1
COLOURS = """['backgroundColor', 'color'].map(of => getComputedStyle(document.body)[of]
    .match(/\\d+/g).slice(0, 3).reduce((sum, x) => sum + x / 765, 0))"""
# parts inside the picture: pixels of the canvas with ink
INSIDE = """(() => { const canvas = document.getElementById('canvas');
    const pixels = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
    let inked = 0;
    for (let i = 3; i < pixels.length; i += 4) inked += pixels[i] > 0;
    return inked > 100; })()"""
# on paper the parts are SVG, where they are on the screen
ON_PAPER = """[getComputedStyle(document.getElementById('parts')).display !== 'none',
    getComputedStyle(document.getElementById('canvas')).display === 'none'].every(Boolean)"""
TRANSFORMS = "[...document.querySelectorAll('#parts > g')].map(g => g.getAttribute('transform'))"

failures = []


def expect(holds, what):
    if not holds:
        failures.append(what)
        print(f"FAILED {what}", flush=True)


def check(browser, page, name, shots):
    def shot(kind):
        browser.screenshot(shots / f"{name.replace('/', '-')}-{kind}.png")

    # plays by itself, and space stops it
    browser.open(page)
    expect(browser.evaluate(PLAYING), f"{name} plays when it is opened")
    before = browser.evaluate(PICTURE)
    time.sleep(0.5)
    expect(browser.evaluate(PICTURE) != before, f"{name} moves")
    browser.press(" ")
    expect(not browser.evaluate(PLAYING), f"space stops {name}")
    expect(not browser.errors, f"{name} reports {browser.errors}")

    # who asks for less motion gets it; keys do what the list says
    browser.open(page, features=[CALM])
    expect(not browser.evaluate(PLAYING), f"{name} stands still for who prefers it")
    first, clock = browser.evaluate(PICTURE), browser.evaluate(CLOCK)
    browser.press("ArrowRight", shift=True)
    expect(browser.evaluate(PICTURE) != first and browser.evaluate(CLOCK) != clock, f"right arrow moves {name}")
    browser.press("ArrowLeft", shift=True)
    expect(browser.evaluate(PICTURE) == first, f"left arrow takes {name} back")
    browser.press("End")
    end = browser.evaluate(CLOCK)
    browser.press("Home")
    expect(browser.evaluate(CLOCK) == clock != end, f"Home and End move {name}")
    browser.press("?")
    expect(browser.evaluate("document.getElementById('keys').open"), f"? lists the keys of {name}")
    browser.press("Escape")
    browser.evaluate("document.getElementById('keys').close()")
    browser.press("f")
    for _ in range(25):
        browser.press("ArrowRight", shift=True)
    arrows = browser.evaluate("[...document.querySelectorAll('#arrows path')].filter(a => a.getAttribute('d')).length")
    offered = browser.evaluate("!document.getElementById('showforces').closest('label').hidden")
    expect(arrows > 0 or not offered, f"{name} has arrows of forces")
    expect(browser.evaluate(INSIDE), f"{name} is in the picture")
    shot("wide")

    browser.open(page, 390, 844, 2, [CALM])
    for _ in range(25):
        browser.press("ArrowRight", shift=True)
    expect(browser.evaluate(WIDE) <= 0, f"{name} is as wide as a phone")
    expect(browser.evaluate(INSIDE), f"{name} is in the picture of a phone")
    shot("phone")

    browser.open(page, features=[CALM, DARK])
    paper, ink = browser.evaluate(COLOURS)
    expect(paper < 0.2 and ink > 0.8, f"{name} is dark where that is preferred: {paper:.2f}, {ink:.2f}")
    shot("dark")
    browser.media("print", [DARK])
    paper, ink = browser.evaluate(COLOURS)
    expect(paper > 0.9 and ink < 0.1, f"{name} is printed in black on white: {paper:.2f}, {ink:.2f}")
    expect(browser.evaluate(ON_PAPER), f"{name} is printed sharp")
    browser.press("ArrowRight", shift=True)
    before = browser.evaluate(TRANSFORMS)
    browser.print(shots / f"{name.replace('/', '-')}.pdf")
    expect(browser.evaluate(TRANSFORMS) != before, f"{name} is printed as it is shown")
    expect(not browser.errors, f"{name} reports {browser.errors}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--shots", type=pathlib.Path)
    parser.add_argument("scenes", nargs="*", default=SCENES)
    arguments = parser.parse_intermixed_args()
    path = chromium.find()
    if path is None:
        print("no Chromium in PATH or in $CHROMIUM")
        return 77
    with tempfile.TemporaryDirectory() as folder, chromium.Browser(path) as browser:
        folder = pathlib.Path(folder)
        shots = arguments.shots or folder
        shots.mkdir(parents=True, exist_ok=True)
        for name in arguments.scenes:
            page = folder / f"{name.replace('/', '-')}.html"
            subprocess.run([arguments.program, "animate", name, "--method", "dop853", "--out", page], check=True, stdout=subprocess.DEVNULL)
            expect(page.stat().st_size < 2_000_000, f"{name} is smaller than 2 MB")
            check(browser, page, name, shots)
            print(f"{name}: played", flush=True)
        moving = folder / "moving.svg"
        subprocess.run([arguments.program, "animate", SCENES[0], "--out", moving], check=True, stdout=subprocess.DEVNULL)
        browser.open(moving)
        pose = "getComputedStyle(document.querySelector('.part')).transform"
        before = browser.evaluate(pose)
        time.sleep(0.5)
        expect(browser.evaluate(pose) != before, "the picture for slides moves")
    print(f"{len(failures)} failed")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
