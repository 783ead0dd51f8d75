"""`ezy new --python`: the names that it refuses are Python's, and what it writes is built and tested.

Building takes minutes: EZY_TEST_NEW=1 asks for it, with the program `ezy` on the path or in EZY_PROGRAM.
"""

import keyword
import os
import pathlib
import subprocess
import sys
import venv

import pytest

ROOT = pathlib.Path(__file__).parents[3]
TAKEN = (ROOT / "models/src/new/taken_by_python.txt").read_text(encoding="utf-8").split()


def test_python_s_names_are_refused():
    # a crate has no name with an underscore in front, or of one letter
    own = {name.lower() for name in {*sys.stdlib_module_names, *keyword.kwlist} if not name.startswith("_")}
    assert sorted(TAKEN) == TAKEN and own <= {*TAKEN, "_"}, own - {*TAKEN}


@pytest.mark.skipif(not os.environ.get("EZY_TEST_NEW"), reason="takes minutes: EZY_TEST_NEW=1 asks for it")
def test_a_new_module_is_built_and_passes_its_own_test(tmp_path):
    program = os.environ.get("EZY_PROGRAM", "ezy")
    project = tmp_path / "my-robot"

    def run(*command):
        folder = project if project.exists() else tmp_path
        done = subprocess.run([*map(str, command)], capture_output=True, text=True, cwd=folder)
        assert done.returncode == 0, f"{command}: {done.stdout}{done.stderr}"
        return done.stdout

    run(program, "new", "--python", project, "--ezy", ROOT)
    venv.create(tmp_path / "venv", with_pip=True)
    python = tmp_path / "venv" / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
    run(python, "-m", "pip", "install", ".[test,gym]")
    assert "reached the end" in run(python, "-c", "import my_robot; print(my_robot.coast().run())")
    run(python, "-c", "import my_robot; my_robot.Environment")
    assert "5 passed" in run(python, "-m", "pytest")
    assert "myrobot/coast" in run("cargo", "run", "--quiet", "--", "list")
