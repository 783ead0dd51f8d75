"""What notebooks show: equations, sketches and animations."""

import html
import json
import re
import xml.etree.ElementTree as xml

import ezy
import numpy as np
import pytest

MODELS = [model for model in vars(ezy).values() if isinstance(model, ezy.Model)]
SCENES = [getattr(model, name) for model in MODELS for name in model.scenes]


@pytest.mark.parametrize("kind", SCENES, ids=repr)
def test_equations_are_whole_latex(kind):
    """Each has its delimiters, and what is opened is closed."""
    scene = kind()
    text, shown = scene.equations(), scene._repr_latex_()
    displayed = re.findall(r"^\\\[\n(.*?)\n\\\]$", text, re.DOTALL | re.MULTILINE)
    assert displayed and len(displayed) == text.count("\\[\n") == text.count("\n\\]") == shown.count("$$") / 2
    for equation in displayed:
        assert equation in shown
        # \\{ and \\} are signs of the text; \\left and \\right come in pairs, too
        bare = equation.replace("\\{", "").replace("\\}", "")
        assert bare.count("{") == bare.count("}") > 0
        assert len(re.findall(r"\\left\b", bare)) == len(re.findall(r"\\right\b", bare))
        begun, ended = (sorted(re.findall(rf"\\{word}\{{(\w+\*?)\}}", bare)) for word in ["begin", "end"])
        assert begun == ended


def test_equations_have_the_symbols_of_the_model():
    text = ezy.pendulum.swing().equations()
    assert "\\sin" in text and "\\varphi" in text and "\\lambda" in text and re.search(r"^[A-Z][\w ,]+:$", text, re.MULTILINE)


def test_a_sketch_is_a_picture_of_its_time(tmp_path):
    scene = ezy.ezyroller.driven()
    sketch = scene.sketch()
    assert xml.fromstring(sketch.svg).tag.endswith("svg") and sketch._repr_svg_() == sketch.svg
    assert scene.sketch(at=1).svg != sketch.svg != scene.sketch(start={"bar.phi": 0.5}).svg
    sketch.save(tmp_path / "sketch.svg")
    assert (tmp_path / "sketch.svg").read_text(encoding="utf-8") == sketch.svg


@pytest.mark.parametrize("work", [False, True])
def test_an_animation_shows_the_samples_of_its_run(tmp_path, work):
    run = ezy.ezyroller.driven().run(until=2, every=0.1, work=work)
    animation = run.animation()
    animation.save(tmp_path / "page.html")
    page = (tmp_path / "page.html").read_text(encoding="utf-8")
    found = re.search(r'<script[^>]*type="application/json"[^>]*>(.*?)</script>', page, re.DOTALL)
    data = json.loads(found.group(1))
    assert data["t"] == run.t.tolist()
    i = data["bodies"].index("bar")
    assert np.allclose(data["poses"][i][2], run["bar.phi"], rtol=0, atol=1e-4)
    energies = next(plot for plot in data["plots"] if plot["title"] == "energy")
    # work that was not integrated is no curve
    assert ("work" in [curve["name"] for curve in energies["curves"]]) == work


def test_a_notebook_has_the_page_in_a_frame_of_its_own(tmp_path):
    animation = ezy.pendulum.swing().run(until=1).animation()
    shown = animation._repr_html_()
    animation.save(str(tmp_path / "page.html"))
    page = (tmp_path / "page.html").read_text(encoding="utf-8")
    assert shown.startswith("<iframe ") and html.unescape(re.search(r'srcdoc="([^"]*)"', shown).group(1)) == page
    animation.save(tmp_path / "moving.svg")
    assert "@keyframes" in xml.tostring(xml.parse(tmp_path / "moving.svg").getroot(), encoding="unicode")


def test_a_run_that_stopped_is_shown_up_to_there(tmp_path):
    with pytest.raises(ezy.StoppedError) as error:
        ezy.doublependulum.swing().run(until=5, step=0.3)
    error.value.run.animation().save(tmp_path / "stopped.html")
    assert 'role="alert"' in (tmp_path / "stopped.html").read_text(encoding="utf-8")


@pytest.mark.parametrize(
    "call, words",
    [
        (lambda folder: ezy.pendulum.swing().sketch(start={"bob.fi": 1}), "did you mean `bob.phi`?"),
        (lambda folder: ezy.pendulum.swing().sketch(at=-1), "-1"),
        (lambda folder: ezy.pendulum.swing().sketch(at=np.nan), "NaN"),
        (lambda folder: ezy.pendulum.swing().sketch().save(folder / "a.png"), "sketches are written as .svg"),
        (lambda folder: ezy.pendulum.swing().sketch().save(folder / "no/a.svg"), "give a file in a folder that exists"),
        (lambda folder: ezy.pendulum.swing().run(until=1).animation().save(folder / "a.gif"), "as .html or .svg"),
        (lambda folder: ezy.pendulum.swing().run(until=1, every=1e-4).animation(), "5000 frames at most"),
    ],
)
def test_wrong_use_has_words(tmp_path, call, words):
    with pytest.raises(ezy.EzyError) as error:
        call(tmp_path)
    assert words in str(error.value)
