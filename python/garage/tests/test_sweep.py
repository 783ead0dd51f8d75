"""Sweeps: the numbers of single runs, in order."""

import ezy
import numpy as np
import pytest


def test_cross_a_grid_has_the_numbers_of_single_runs():
    table = ezy.pendulum.swing().sweep({"l": [0.5, 1.0], "bob.phi": np.array([-1.0, 0.0, 0.5])}, keep=["bob.x", "max:bob.y"])
    assert list(table) == ["l", "bob.phi", "bob.x", "max:bob.y", "end", "steps", "outcome", "message"]
    assert table["l"].tolist() == [0.5] * 3 + [1.0] * 3 and table["bob.phi"].tolist() == [-1.0, 0.0, 0.5] * 2
    assert table["outcome"] == ["end"] * 6
    for i, (l, phi) in enumerate(zip(table["l"], table["bob.phi"])):
        scene = ezy.pendulum.swing(l=l)
        run = scene.run(at=[scene.until], start={"bob.phi": phi})
        # steps that end at other samples end there elsewhere, within the tolerance
        assert table["bob.x"][i] == pytest.approx(run["bob.x"][-1], abs=1e-6)


def test_rows_that_belong_together_and_ends_by_themselves():
    table = ezy.pendulum.swing().sweep({"l": [0.5, 1.0], "g": [9.81, 1.6]}, together=True, until=0.5, rtol=1e-10)
    assert table["g"].tolist() == [9.81, 1.6] and len(table["bob.omega"]) == 2 and table["end"].tolist() == [0.5] * 2


def test_lanes_keep_the_tolerance():
    vary = {"l": np.linspace(0.5, 1.5, 20)}
    one, eight = (ezy.pendulum.swing().sweep(vary, until=1, rtol=1e-10, lanes=lanes)["bob.x"] for lanes in (False, True))
    assert np.abs(one - eight).max() <= 1e-7


def test_what_is_varied_may_be_kept():
    table = ezy.pendulum.swing().sweep({"bob.phi": [-1, 0.5]}, until=0.5)
    assert table["bob.phi"].tolist() == [-1, 0.5]
    for phi, end in zip(table["bob.phi"], table["end:bob.phi"]):
        run = ezy.pendulum.swing().run(until=0.5, at=[0.5], start={"bob.phi": phi})
        assert end == pytest.approx(run["bob.phi"][-1], abs=1e-6)


def test_columns_of_other_counts_are_found_by_name():
    table = ezy.chain.swing().sweep({"n": [2, 20]}, until=0.1, keep=["link[0].omega", "link[4].phi"])
    for n, omega, phi in zip((2, 20), table["link[0].omega"], table["link[4].phi"]):
        run = ezy.chain.swing(n=n).run(until=0.1, at=[0.1])
        assert omega == pytest.approx(run["link[0].omega"][-1], abs=1e-6)
        assert np.isnan(phi) if n == 2 else phi == pytest.approx(run["link[4].phi"][-1], abs=1e-6)


def test_counts_and_failures_are_rows():
    table = ezy.chain.swing().sweep({"n": [2, 3, 2.5]}, until=0.1, keep=["link[0].phi"])
    assert table["outcome"] == ["end", "end", "refused"] and "whole number" in table["message"][2]
    assert np.isnan(table["link[0].phi"][2])


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        ({"vary": {}}, "vari"),
        ({"vary": {"ll": [1]}}, "did you mean `l`"),
        ({"vary": {"l": [1, 2], "g": [1]}, "together": True}, "has 1 values where"),
        ({"vary": {"l": "long"}}, "takes numbers"),
        ({"vary": {"l": [1]}, "keep": ["bob.z"]}, "bob"),
        ({"vary": {"l": range(10_000), "g": range(10_000)}}, "at most"),
    ],
)
def test_wrong_use_is_told(arguments, says):
    with pytest.raises(ezy.EzyError, match=says):
        ezy.pendulum.swing().sweep(**arguments)
