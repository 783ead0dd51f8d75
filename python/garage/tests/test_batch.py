"""Batches: the numbers of single steppers, whatever the threads; members that are reset; wrong use."""

import threading

import ezy
import numpy as np
import pytest

STEP = 1e-2
N = 9
ANGLES = np.linspace(-0.3, 0.3, N)


def batch(n=N, **changes):
    return ezy.ezyroller.ridden().batch(n, STEP, **changes)


def test_members_have_the_numbers_of_steppers():
    """Each with its own start, input and parameter, to the bit."""
    name = next(iter(ezy.ezyroller.ridden.parameters))
    values = ezy.ezyroller.ridden.parameters[name][0] * np.linspace(0.9, 1.1, N)
    torques = np.linspace(-0.4, 0.4, N)
    together = batch(start={"bar.phi": ANGLES}, parameters={name: values}, inputs={"torque": torques})
    together.step(7)
    t = together.step(3, torque=-torques)
    assert together.q.shape == together.v.shape == (N, len(together.names["q"])) and len(together) == N
    for i in range(N):
        scene = ezy.ezyroller.ridden(**{name: values[i]})
        alone = scene.stepper(STEP, start={"bar.phi": ANGLES[i]}, inputs={"torque": torques[i]})
        alone.step(7)
        assert t[i] == alone.step(3, torque=-torques[i])
        assert np.array_equal(together.q[i], alone.q) and np.array_equal(together.v[i], alone.v)
        assert np.array_equal(together.outputs[i], alone.outputs)
        assert together["seat.vx"][i] == alone["seat.vx"] and together.inputs["torque"][i] == -torques[i]


@pytest.mark.parametrize("threads", [1, 2, 3, 100])
def test_threads_do_not_change_the_bits(threads):
    alone, together = batch(start={"bar.phi": ANGLES}, threads=1), batch(start={"bar.phi": ANGLES}, threads=threads)
    for steps in [1, 50, 3]:
        alone.step(steps), together.step(steps)
    assert np.array_equal(alone.q, together.q) and np.array_equal(alone.v, together.v)


def test_lanes_have_the_numbers_of_steppers_but_for_the_projection():
    """1e-12 of a row in each step; also with a member that is reset, and beside one that stops."""
    one, eight = (batch(start={"bar.phi": ANGLES}, lanes=lanes) for lanes in (False, True))
    for round in range(3):
        for of in (one, eight):
            of.reset([2], start={"bar.phi": [0.1 * round]})
            of.step(50, torque=0.3 * ANGLES)
        assert np.array_equal(one.t, eight.t)
        assert np.abs(one.q - eight.q).max() < 1e-10 and np.abs(one.v - eight.v).max() < 1e-10
    for of in (one, eight):
        with pytest.raises(ezy.StoppedError, match="member 4"):
            of.step(torque=np.where(np.arange(N) == 4, 1e300, 0))
        of.step(20, torque=0)
        assert list(of.stopped) == [4]
    assert np.abs(one.q - eight.q).max() < 1e-10


def test_scenes_that_do_not_step_in_lanes_say_why():
    with pytest.raises(ezy.EzyError, match="cannot step in lanes: the scene has no elimination"):
        ezy.chain.swing().batch(4, STEP, lanes=True)


def test_some_are_reset():
    of = batch(start={"bar.phi": ANGLES})
    of.step(5)
    before = of["bar.phi"]
    of.reset([1, 4], start={"bar.phi": [0.25, 0.15]})
    assert of["bar.phi"][[1, 4]].tolist() == [0.25, 0.15] and of.t.tolist() == [0 if i in (1, 4) else of.t[0] for i in range(N)]
    others = [i for i in range(N) if i not in (1, 4)]
    assert np.array_equal(of["bar.phi"][others], before[others])
    of.reset(np.arange(N) >= 4)
    assert np.array_equal(of["bar.phi"][4:], ANGLES[4:]) and of.t[1] == 0 and of.t[0] > 0
    of.reset([])
    assert of.t[0] > 0
    of.reset()
    assert np.array_equal(of["bar.phi"], ANGLES) and not of.t.any()


def test_a_member_that_cannot_go_on_waits_for_its_reset():
    of = batch()
    torque = np.where(np.arange(N) == 2, 1e30, 0.0)
    with pytest.raises(ezy.StoppedError, match="1 of 9 members stopped; member 2"):
        of.step(100, torque=torque)
    assert list(of.stopped) == [2] and np.isfinite(of.q).all() and of.t[2] < of.t[1] == of.t[0]
    stopped_at = of.t[2]
    of.step(10, torque=0.0)
    assert of.t[2] == stopped_at and of.t[1] > 1
    of.reset(list(of.stopped))
    assert of.stopped == {} and of.t[2] == 0 and of.step()[2] == STEP


def test_a_start_that_cannot_be_taken_is_said_with_its_member():
    of = batch()
    of.step()
    with pytest.raises(ezy.EzyError, match="member 3: "):
        of.reset([1, 3], start={"bar.phi": [0.1, np.inf]})
    assert of.t[1] == 0 and of.t[3] == STEP


def test_other_threads_of_python_run_meanwhile():
    of, n_turns = batch(), 0
    stepping = threading.Thread(target=lambda: of.step(20_000))
    stepping.start()
    while stepping.is_alive():
        n_turns += 1
        stepping.join(1e-3)
    assert n_turns > 10 and abs(of.t - 20_000 * STEP).max() < 1e-9


@pytest.mark.parametrize(
    "call, words",
    [
        (lambda: batch(0), "`n` takes a whole number from 1 on"),
        (lambda: batch(10**7), "1000000 members at most"),
        (lambda: batch(threads=0), "`threads` takes a whole number from 1 on"),
        (lambda: batch(start={"bar.fi": 0}), "did you mean `bar.phi`?"),
        (lambda: batch(start={"bar.phi": [1, 2]}), "an array of 9 numbers, but was given one of the shape [2]"),
        (lambda: batch(start={"bar.phi": np.zeros((N, 1))}), "one of the shape [9, 1]"),
        (lambda: batch(start={"bar.phi": "x"}), "`bar.phi` takes a number, or an array of 9 numbers, but was given x"),
        (lambda: batch(inputs={"torqe": 1}), "did you mean `torque`?"),
        (lambda: batch(parameters={"no": 1}), "parameter `no` is not known"),
        (lambda: ezy.chain.swing(n=3).batch(2, STEP, parameters={"n": 4}), "`n` is a count"),
        (lambda: batch().step(torque=np.full(N, np.nan)), "finite numbers, but was given NaN for member 0"),
        (lambda: batch().set(torqe=1), "did you mean `torque`?"),
        (lambda: batch().reset([N]), "indices from 0 to 8"),
        (lambda: batch().reset([-1]), "indices from 0 to 8"),
        (lambda: batch().reset(3), "indices from 0 to 8"),
        (lambda: batch()["bar.fi"], "did you mean `bar.phi`?"),
    ],
)
def test_wrong_use_has_words(call, words):
    with pytest.raises(ezy.EzyError) as error:
        call()
    assert words in str(error.value)
