"""Derivatives of runs by closed forms and by differences of runs."""

import ezy
import numpy as np
import pytest

#: Of runs with a tolerance of 1e-11: what a derivative may have more than the motion itself.
CLOSE = 1e-8


def test_analytic_small_swing_of_a_pendulum():
    """ω² = g/l of a point on a rod, at small angles: the derivatives of φ₀ cos ωt by φ₀ and l."""
    small, l, g = 1e-6, 0.7, 9.81
    scene = ezy.pendulum.swing(l=l, g=g)
    found = scene.sensitivities(["bob.phi", "l"], 2, rtol=1e-12, start={"bob.phi": small - np.pi / 2, "bob.omega": 0})
    omega, t = np.sqrt(g / l), found.t
    assert len(t) == 501 and t[-1] == 2
    # the equation of the pendulum differs from the linear one by φ³/6
    assert np.allclose(found["bob.phi", "bob.phi"], np.cos(omega * t), atol=CLOSE)
    by_length = small * np.sin(omega * t) * omega * t / (2 * l)
    assert np.allclose(found["bob.phi", "l"], by_length, atol=small * 1e-3)
    assert np.allclose(found["bob.phi"] + np.pi / 2, small * np.cos(omega * t), atol=1e-10)
    jacobian = found.jacobian("bob.phi", "bob.omega")
    assert jacobian.shape == (501, 2, 2) and np.array_equal(jacobian[:, 0, 1], found["bob.phi", "l"])
    assert found.jacobian().shape == (501, len(found.columns), 2) and found.by == ["bob.phi", "l"]
    assert found.units["bob.phi"] == "rad" and found.units["l"] == "m"


def test_more_than_eight_quantities_and_differences_of_runs():
    scene = ezy.ezyroller.driven()
    start = {name: 0.0 for name in ("seat.x", "seat.y", "seat.phi", "seat.vx", "seat.omega")} | {"bar.phi": 0.7}
    by = [*start, "m0", "a", "b", "i1", "i2"]
    found = scene.sensitivities(by, rtol=1e-11, at=[0, 0.5, 1.5], start=start)
    assert found.jacobian().shape == (3, 12, len(by))
    for name in ("bar.phi", "m0", "b"):
        h = 1e-4

        def end(change):
            other = ezy.ezyroller.driven(**({name: scene.parameters[name] + change} if name in scene.parameters else {}))
            begin = start | ({name: start[name] + change} if name in start else {})
            return other.run(1.5, rtol=1e-12, at=[1.5], start=begin)["bar.phi"][-1]

        difference = (end(h) - end(-h)) / (2 * h)
        assert found["bar.phi", name][-1] == pytest.approx(difference, rel=1e-5, abs=1e-6), name


def test_start_alone():
    found = ezy.pendulum.swing(l=0.7).sensitivities(["l"], 0)
    assert found.t.tolist() == [0] and found["bob.x", "l"].tolist() == [1]


def test_scenes_with_counts_have_derivatives():
    scene = ezy.chain.swing(n=6)
    found = scene.sensitivities(["m"], 0.3, rtol=1e-10, at=[0.3])
    # of a chain under its weight alone all masses may be multiplied
    assert np.abs(found.jacobian()).max() <= CLOSE


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        ({"by": []}, "`by` names nothing"),
        ({"by": ["bob.fi"]}, "did you mean `bob.phi`"),
        ({"by": ["l"], "method": "radau"}, "use dop853, rk4 or midpoint"),
        ({"by": ["l"], "at": [1, 0.5]}, "ascending"),
        ({"by": ["l"], "every": 0}, "above 0 s"),
        ({"by": ["l"], "every": 1e-9}, "are possible"),
        ({"by": ["l"], "at": [100]}, "to the end at 10 s"),
        ({"by": ["l"], "until": -1}, "`until` takes a time"),
        ({"by": ["bob.x"]}, "is not given by the start"),
    ],
)
def test_wrong_use_is_told(arguments, says):
    with pytest.raises(ezy.EzyError, match=says):
        ezy.pendulum.swing().sensitivities(**arguments)
