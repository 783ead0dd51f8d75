"""The Python blocks of the pages, one after the other as a reader types them."""

import importlib.util
import pathlib
import re

import pytest

ROOT = pathlib.Path(__file__).parents[3]


@pytest.mark.parametrize("page", ["python/README.md", "docs/guide/src/python.md"])
def test_blocks_of_the_page_run(tmp_path, monkeypatch, page):
    pytest.importorskip("matplotlib").use("agg")
    monkeypatch.chdir(tmp_path)
    blocks = re.findall(r"```python\n(.*?)```", (ROOT / page).read_text(encoding="utf-8"), re.DOTALL)
    assert len(blocks) >= 3
    if importlib.util.find_spec("gymnasium") is None:
        blocks = [block for block in blocks if "Environment" not in block]
    names = {}
    for block in blocks:
        exec(compile(block, page, "exec"), names)
    assert (tmp_path / "path.svg").stat().st_size > 1000
