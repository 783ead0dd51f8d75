"""Equilibria and linear equations: closed forms, and runs of the equations that are not linear."""

import math

import ezy
import numpy as np
import pytest

#: Of numbers that are solved for in double precision.
EXACT = 1e-12


def test_analytic_pendulum_hangs_and_swings():
    """A point mass m on a rod l: ω² = g / l."""
    scene = ezy.pendulum.swing(l=0.7, m=2, g=9.0)
    rest = scene.equilibrium(start={"bob.phi": -1.5})
    assert rest.kind == "rest" and rest.frame == (0, 0, 0) and rest.free == []
    assert abs(rest["bob.phi"] + math.pi / 2) <= EXACT and abs(rest.multipliers["pin.y"] - 2 * 9.0) <= 20 * EXACT
    assert rest.q.tolist() == [rest.state[name] for name in scene.coordinates] and not rest.v.any()
    linear = scene.linearize(start={"bob.phi": -1.5})
    omega = math.sqrt(9.0 / 0.7)
    assert np.allclose(linear.eigenvalues, [1j * omega, -1j * omega], rtol=EXACT, atol=EXACT)
    assert linear.n_zero == linear.n_unstable == 0 and linear.equilibrium["bob.phi"] == rest["bob.phi"]
    assert linear.B.shape == (2, 0) and linear.C.shape == (0, 2) and linear.D.shape == (0, 0)


def test_all_rests_are_found_and_the_standing_one_falls():
    scene = ezy.pendulum.swing()
    hanging, standing = sorted(scene.equilibria(), key=lambda rest: rest["bob.y"])
    assert abs(hanging["bob.y"] + 1) <= EXACT and abs(standing["bob.y"] - 1) <= EXACT
    linear = scene.linearize(start={"bob.phi": math.pi / 2})
    assert linear.n_unstable == 1 and linear.eigenvalues.real.max() == pytest.approx(math.sqrt(9.81), rel=EXACT)


def test_linear_equations_are_those_of_small_deviations():
    """By a small torque on straight motion: the linear solution against two runs, without and with it."""
    torque, end, step = 1e-5, 0.4, 1e-3
    scene, straight = ezy.ezyroller.ridden(), {"bar.phi": 0.0}
    linear = scene.linearize(start=straight)
    assert linear.equilibrium.kind == "straight" and linear.inputs == ["torque"] and len(linear.outputs) == 2
    x = np.zeros(len(linear.A))
    rates = lambda x: linear.A @ x + linear.B[:, 0] * torque
    for _ in range(round(end / step)):
        k1 = rates(x)
        k2 = rates(x + step / 2 * k1)
        k3 = rates(x + step / 2 * k2)
        x = x + step / 6 * (k1 + 2 * k2 + 2 * k3 + rates(x + step * k3))
    runs = [scene.run(until=end, rtol=1e-12, start=straight, inputs={"torque": of}) for of in (0.0, torque)]
    outputs = [f"output.{name}" for name in linear.outputs]
    for names, expected in [(linear.names, linear.basis @ x), (outputs, linear.C @ x + linear.D[:, 0] * torque)]:
        found = np.array([runs[1][name][-1] - runs[0][name][-1] for name in names])
        # deviations grow to 1e-5, and what is not linear is of their square; runs have 1e-11
        assert np.abs(expected).max() > 1e-6
        assert np.allclose(found, expected, rtol=1e-4, atol=1e-9), (found, expected)


def test_what_is_held_keeps_its_value():
    held = ezy.ezyroller.ridden().linearize(start={"bar.phi": 0.3}, hold=["bar.phi"]).equilibrium
    assert held.kind == "circle" and held["bar.phi"] == 0.3 and held.frame[2] != 0 and "bar.phi" not in held.free


@pytest.mark.parametrize(
    "call, words",
    [
        (lambda: ezy.pendulum.swing().equilibrium(hold=["bob.fi"]), "did you mean `bob.phi`?"),
        (lambda: ezy.pendulum.swing().equilibrium(start={"bob.fi": 1}), "did you mean `bob.phi`?"),
        (lambda: ezy.ezyroller.ridden().linearize(inputs={"torqe": 1}), "did you mean `torque`?"),
        (lambda: ezy.pendulum.swing().equilibria(n_starts=0), "`n_starts` takes a whole number from 1"),
        (lambda: ezy.ezyroller.driven().linearize(), "no steady motion was found near the start"),
        (lambda: ezy.chaplyginsleigh.downhill().linearize(), "is not steady"),
        (lambda: ezy.pendulum.swing().equilibrium()["bob.fi"], "did you mean `bob.phi`?"),
    ],
)
def test_wrong_use_has_words(call, words):
    with pytest.raises(ezy.EzyError) as error:
        call()
    assert words in str(error.value)
