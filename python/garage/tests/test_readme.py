"""The Python blocks of the page, one after the other as a reader types them."""

import importlib.util
import pathlib
import re

import pytest

PAGE = pathlib.Path(__file__).parents[2] / "README.md"


def test_blocks_of_the_page_run(tmp_path, monkeypatch):
    pytest.importorskip("matplotlib").use("agg")
    monkeypatch.chdir(tmp_path)
    blocks = re.findall(r"```python\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL)
    assert len(blocks) >= 3
    if importlib.util.find_spec("gymnasium") is None:
        blocks = [block for block in blocks if "Environment" not in block]
    names = {}
    for block in blocks:
        exec(compile(block, str(PAGE), "exec"), names)
    assert (tmp_path / "path.svg").stat().st_size > 1000
