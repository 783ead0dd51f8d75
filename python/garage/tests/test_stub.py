"""The types in `ezy.pyi` are those of the module. UPDATE_GOLDEN=1 writes them anew."""

import ast
import inspect
import os
import pathlib
import re
import subprocess
import sys

import ezy
import pytest

STUB = pathlib.Path(__file__).parents[1] / "ezy.pyi"
PAGE = pathlib.Path(__file__).parents[2] / "README.md"

#: What stubtest finds and no stub needs to say: names without a stub of their own, and that two classes have no common heir.
ALLOWED = ["ezy.__all__", "ezy.ezy", "ezy.Model", "ezy.SceneType"]


def python(*arguments, **options):
    done = subprocess.run([sys.executable, *map(str, arguments)], capture_output=True, text=True, **options)
    assert done.returncode == 0, done.stdout + done.stderr


def test_types_are_those_of_the_models():
    types = ezy.type_stub()
    if os.environ.get("UPDATE_GOLDEN"):
        STUB.write_text(types, encoding="utf-8", newline="\n")
    assert STUB.read_text(encoding="utf-8") == types, "UPDATE_GOLDEN=1 writes ezy.pyi anew; build the module again then"


def test_every_scene_has_its_parameters_and_counts():
    classes = {node.name: node for node in ast.parse(ezy.type_stub()).body if isinstance(node, ast.ClassDef)}
    n_scenes = 0
    for model in (model for model in vars(ezy).values() if isinstance(model, ezy.Model)):
        lines = classes[f"_{model.name}"].body
        of_model = {line.target.id: line.annotation.id for line in lines if isinstance(line, ast.AnnAssign)}
        assert list(of_model) == model.scenes
        for scene, name in of_model.items():
            arguments = classes[name].body[0].args
            pairs = zip(arguments.kwonlyargs, arguments.kw_defaults)
            given = {of.arg: ast.literal_eval(default) for of, default in pairs}
            assert given == getattr(model, scene)().parameters
            n_scenes += 1
    assert n_scenes > 40


def documented():
    """Each class and member that the stub documents, with the text that Python has of it."""
    for node in ast.parse(ezy.type_stub()).body:
        if isinstance(node, ast.ClassDef) and not node.name.startswith("_"):
            functions = [member for member in node.body if isinstance(member, ast.FunctionDef)]
            members = [member for member in functions if ast.get_docstring(member)]
            # the documentation of a model is that of its file, which a class cannot have
            of_class = [] if node.name == "Model" else [(node, getattr(ezy, node.name))]
            yield from of_class
            yield from ((member, getattr(getattr(ezy, node.name), member.name)) for member in members)


def test_documentation_is_that_of_the_classes():
    pytest.importorskip("gymnasium")
    words = lambda text: re.sub(r"\s+", " ", text).strip()
    all_of_it = list(documented())
    assert len(all_of_it) > 40
    for node, known in all_of_it:
        # what Python has of its own special methods
        if not node.name.startswith("__"):
            assert words(ast.get_docstring(node)) == words(inspect.getdoc(known)), node.name


def test_types_are_those_of_the_classes(tmp_path):
    pytest.importorskip("mypy")
    pytest.importorskip("gymnasium")
    allowed = tmp_path / "allowed.txt"
    # a model has a type of its own in the stub alone: `test_every_scene_has_its_parameters_and_counts` compares these
    models = [f"ezy.{name}" for name, model in vars(ezy).items() if isinstance(model, ezy.Model)]
    allowed.write_text("\n".join(ALLOWED + models), encoding="utf-8")
    python("-m", "mypy.stubtest", "ezy", "--allowlist", allowed, "--ignore-unused-allowlist", cwd=tmp_path)


def test_blocks_of_the_page_have_the_types(tmp_path):
    pytest.importorskip("mypy")
    pytest.importorskip("gymnasium")
    blocks = re.findall(r"```python\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL)
    (tmp_path / "page.py").write_text("\n".join(blocks), encoding="utf-8")
    python("-m", "mypy", "--strict", "--ignore-missing-imports", "page.py", cwd=tmp_path)


@pytest.mark.parametrize(
    "line, words",
    [
        ("ezy.ezyroller.drivn()", "maybe \"driven\""),
        ("ezy.ezyroller.driven(m=3)", "Unexpected keyword argument"),
        ("ezy.ezyroller.driven(m0='three')", "incompatible type"),
        ("ezy.ezyroller.driven().run(rtoll=1e-6)", "Unexpected keyword argument"),
    ],
)
def test_mypy_finds_wrong_names(tmp_path, line, words):
    pytest.importorskip("mypy")
    (tmp_path / "wrong.py").write_text(f"import ezy\n{line}\n", encoding="utf-8")
    command = [sys.executable, "-m", "mypy", "--ignore-missing-imports", "wrong.py"]
    done = subprocess.run(command, capture_output=True, text=True, cwd=tmp_path)
    assert done.returncode == 1 and words in done.stdout, done.stdout + done.stderr
