"""The wheel as its users call it: values against closed forms, wrong use against EZY's own words."""

import gc
import math
import os
import random
import resource
import signal
import threading
import time
import types

import ezy
import numpy as np
import pytest

#: A global error is some hundred times the tolerance of a step at most (docs/accuracy.md).
AMPLIFIED = 100


def test_analytic_pendulum_has_its_period():
    """Let go level, it turns back after half of 4 K(sin θ/2) √(l/g), by the arithmetic-geometric mean."""
    run = ezy.pendulum.swing(l=0.7, g=9.0).run(until=3, rtol=1e-11)
    a, b = 1.0, math.cos(math.pi / 4)
    for _ in range(5):
        a, b = (a + b) / 2, math.sqrt(a * b)
    period = 2 * math.pi * math.sqrt(0.7 / 9.0) / a
    turns = [t for t, name in run.events if name == "turning"]
    assert turns and abs(turns[0] - period / 2) <= AMPLIFIED * 1e-11


def test_columns_are_arrays_by_name():
    run = ezy.ezyroller.driven(m0=3).run(until=1, rtol=1e-9, every=0.1)
    assert run.outcome.startswith("reached the end")
    phi = run["bar.phi"]
    assert isinstance(phi, np.ndarray) and phi.dtype == np.float64 and phi.shape == (11,)
    assert np.allclose(run.t, np.linspace(0, 1, 11), rtol=0, atol=1e-15)
    # the same array each time: nothing is copied
    assert run["bar.phi"] is phi and dict(run)["bar.phi"] is phi
    assert run.units["bar.phi"] == "rad" and "bar.phi" in run and "bar.psi" not in run
    assert set(run.keys()) == set(run.to_dict()) and len(run) == len(list(run))


def test_parameters_and_names_are_those_of_the_model():
    driven = ezy.ezyroller.driven
    default, unit, meaning = driven.parameters["m0"]
    assert unit == "N*m" and meaning and driven(m0=3).parameters["m0"] == 3
    assert driven().parameters["m0"] == default
    assert "ezyroller.driven(" in repr(driven()) and "driven" in dir(ezy.ezyroller)


def test_counts_change_the_size():
    assert len(ezy.chain.swing(n=4).coordinates) == 12
    assert ezy.chain.swing(n=4).run(until=0.1)["link[3].x"].shape[0] >= 2


def test_estimate_and_check():
    run = ezy.doublependulum.swing().run(until=1, rtol=1e-8, estimate=True)
    assert 0 < run.estimate["positions [rad]"] < 1e-4
    ezy.ezyroller.coast().check()


@pytest.mark.parametrize(
    "call, words",
    [
        (lambda: ezy.ezyroler, "did you mean `ezyroller`?"),
        (lambda: ezy.ezyroller.driven().stepper(1e-3)["bar.fi"], "did you mean `bar.phi`?"),
        (lambda: ezy.ezyroller.drivn, "did you mean `driven`?"),
        (lambda: ezy.ezyroller.driven(omga=3), "did you mean `omega`?"),
        (lambda: ezy.ezyroller.driven(m0="three"), "`m0` takes a number"),
        (lambda: ezy.chain.swing(n=0), "a whole number from 1 on"),
        (lambda: ezy.chain.swing(n=2.5), "a whole number from 1 on"),
        (lambda: ezy.ezyroller.driven(m0=math.nan).run(), "m0"),
        (lambda: ezy.ezyroller.driven().run(method="dop85"), "did you mean `dop853`?"),
        (lambda: ezy.ezyroller.driven().run(step=1e-3, rtol=1e-6), "has a fixed step and no tolerance"),
        (lambda: ezy.ezyroller.driven().run(method="rk4"), "give `step`"),
        (lambda: ezy.ezyroller.driven().run(start={"bar.fi": 1}), "did you mean `bar.phi`?"),
        (lambda: ezy.ezyroller.ridden().run(inputs={"torqe": 1}), "torqe"),
        (lambda: ezy.ezyroller.driven().run(until=1)["bar.pi"], "did you mean `bar.phi`?"),
        (lambda: ezy.ezyroller.driven().run(until=-1), "-1"),
    ],
)
def test_wrong_use_has_the_words_of_ezy(call, words):
    with pytest.raises((ezy.EzyError, AttributeError)) as error:
        call()
    assert words in str(error.value)


def test_a_run_that_is_worth_nothing_says_so_and_keeps_what_it_has():
    """Of steps that are far too long."""
    with pytest.raises(ezy.StoppedError) as error:
        ezy.doublependulum.swing().run(until=5, step=0.3)
    assert error.value.run["t"].shape[0] >= 1 and str(error.value).startswith("the run ")


MODELS = [model for model in map(ezy.__dict__.get, dir(ezy)) if isinstance(model, ezy.Model)]


def scene_with_input():
    """The first scene that has an input, with its name."""
    kinds = (getattr(model, name) for model in MODELS for name in model.scenes)
    kind = next(kind for kind in kinds if kind.inputs)
    return kind(), next(iter(kind.inputs))


def test_stepper_repeats_itself_to_the_bit():
    scene, name = scene_with_input()
    stepper = scene.stepper(1e-3)
    stepper.step(50)
    saved = stepper.save()
    stepper.step(100, **{name: 0.01})
    there = stepper.q.copy()
    stepper.restore(saved)
    assert abs(stepper.t - 0.05) <= 1e-15
    stepper.step(100, **{name: 0.01})
    assert (stepper.q == there).all() and stepper.inputs[name] == 0.01
    stepper.reset()
    assert stepper.t == 0
    with pytest.raises(ezy.EzyError, match="finite"):
        stepper.step(1, **{name: math.nan})
    with pytest.raises(ezy.EzyError, match="not known"):
        stepper.step(1, no_such_input=1)


def test_stepper_is_the_run_of_rk4():
    stepper = ezy.ezyroller.driven().stepper(1e-2)
    stepper.step(100)
    run = ezy.ezyroller.driven().run(until=1, step=1e-2)
    names = stepper.names["q"]
    assert np.array_equal(stepper.q, [run[name][-1] for name in names])


def test_stepper_has_its_numbers_by_name():
    stepper = ezy.ezyroller.ridden().stepper(1e-2, start=types.MappingProxyType({"bar.phi": 0.2}))
    stepper.step(10, torque=0.3)
    names, values = stepper.names, {"q": stepper.q, "v": stepper.v, "outputs": stepper.outputs}
    for kind in ["q", "v", "outputs"]:
        assert [stepper[name] for name in names[kind]] == values[kind].tolist()
    assert stepper["t"] == stepper.t and stepper["torque"] == 0.3
    assert ezy.ezyroller.ridden().until == 10


def test_threads_run_beside_each_other():
    scene = ezy.ezyroller.driven()
    alone = scene.run(until=5, rtol=1e-9)["bar.phi"][-1]
    found = []
    threads = [threading.Thread(target=lambda: found.append(scene.run(until=5, rtol=1e-9)["bar.phi"][-1])) for _ in range(4)]
    [thread.start() for thread in threads]
    [thread.join() for thread in threads]
    assert found == [alone] * 4


#: Each would take hours.
LONG = {
    "run": lambda: ezy.doublependulum.swing().run(until=1e5, step=1e-4, every=1e4),
    "sweep": lambda: ezy.doublependulum.swing().sweep({"m1": [1, 2, 3]}, until=1e5, step=1e-4),
    "sensitivities": lambda: ezy.doublependulum.swing().sensitivities(["m1"], until=1e4, step=1e-4),
    "batch": lambda: ezy.doublependulum.swing().batch(8, 1e-4).step(10**9),
    "equilibria": lambda: ezy.doublependulum.swing().equilibria(n_starts=100_000),
}


@pytest.mark.parametrize("work", LONG.values(), ids=LONG)
def test_control_c_ends_what_takes_long(work):
    """Within seconds, also where the shell let this program ignore it."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    timer = threading.Timer(0.3, lambda: os.kill(os.getpid(), signal.SIGINT))
    timer.start()
    began = time.monotonic()
    try:
        with pytest.raises(KeyboardInterrupt):
            work()
    finally:
        signal.signal(signal.SIGINT, before)
    assert time.monotonic() - began < 10


def test_random_calls_raise_and_never_crash():
    """Wrong names, kinds and numbers, ten thousand times: each is an exception with words, or a run."""
    rng = random.Random(20261126)
    strange = [None, "x", -1, 0, 1.5, math.nan, math.inf, [], {}, [1, 2], ([0, 1], [0, 1]), ([1, 0], [0, 1]), object(), 10**400, b"x"]
    keys = ["until", "rtol", "atol", "step", "method", "every", "at", "start", "inputs", "estimate", "work", "nonsense"]
    n_raised = 0
    for _ in range(10_000):
        model = rng.choice(MODELS)
        scene = getattr(model, rng.choice(model.scenes))
        try:
            parameters = {rng.choice([*scene.parameters, "wrong"]): rng.choice(strange) for _ in range(rng.randrange(2))}
            made = scene(**parameters)
            arguments = {"until": 1e-3, **{rng.choice(keys): rng.choice(strange) for _ in range(rng.randrange(1, 3))}}
            # what would rightly take hours
            if arguments["until"] in (1.5, math.inf, 10**400) or arguments.get("n", 1) == 10**400:
                arguments["until"] = 1e-3
            made.run(**arguments)
        except (ValueError, TypeError, AttributeError, OverflowError) as error:
            n_raised += 1
            assert str(error)
    assert n_raised > 5000


def test_memory_stays():
    stepper = ezy.ezyroller.driven().stepper(1e-3)
    scene = ezy.pendulum.swing()
    sizes = []
    for _ in range(10):
        stepper.step(100_000)
        for _ in range(200):
            scene.run(until=0.1, every=0.001)
            stepper.q, stepper.v
        gc.collect()
        sizes.append(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss)
    assert sizes[-1] <= sizes[2] * 1.05, sizes
