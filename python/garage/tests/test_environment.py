"""Scenes as environments of Gymnasium: what Gymnasium checks of them, and what EZY promises besides."""

import pickle
import subprocess
import sys

import ezy
import numpy as np
import pytest

gymnasium = pytest.importorskip("gymnasium")
from gymnasium.utils.env_checker import check_env  # noqa: E402

STEP = 1e-2
KEPT = {"inputs": {"torque": (-1, 1)}, "reward": lambda now: now["bar.omega"]}


def environment(**changes):
    return ezy.Environment(ezy.ezyroller.ridden(), STEP, **{**KEPT, **changes})


@pytest.mark.filterwarnings("ignore:.*:UserWarning")
def test_gymnasium_finds_no_fault():
    check_env(environment(start={"bar.phi": (-0.1, 0.1)}, every=0.05))


def test_an_episode_is_the_stepper_with_the_same_inputs():
    env = environment(every=5 * STEP, observe=["bar.phi", "t"])
    stepper = ezy.ezyroller.ridden().stepper(STEP)
    assert env.reset()[0].tolist() == [stepper["bar.phi"], 0]
    for torque in np.random.default_rng(1).uniform(-1, 1, 20):
        seen, reward, terminated, truncated, info = env.step(np.array([torque]))
        stepper.step(5, torque=torque)
        assert seen.tolist() == [stepper["bar.phi"], stepper.t]
        assert reward == stepper["bar.omega"] and info == {"t": stepper.t}
        assert not terminated and not truncated


def test_actions_are_held_at_their_bounds():
    env = environment()
    env.reset()
    env.step([7.0])
    assert env.stepper["torque"] == 1


def test_a_seed_repeats_the_start_and_reset_begins_anew():
    env = environment(start={"bar.phi": (-0.3, 0.3)}, observe=["bar.phi"])
    first = env.reset(seed=3)[0]
    second = env.reset()[0]
    env.step([0.5])
    assert abs(first[0]) <= 0.3 and first != second
    assert env.reset(seed=3)[0] == first and env.reset()[0] == second
    assert env.reset(options={"start": {"bar.phi": 0.2}})[0] == 0.2
    assert env.stepper.t == 0 and env.stepper["torque"] == ezy.ezyroller.ridden.inputs["torque"][0]
    drawn = environment(start=lambda random: {"bar.phi": random.normal(0, 0.1)}, observe=["bar.phi"])
    assert drawn.reset(seed=3)[0] == drawn.reset(seed=3)[0] != drawn.reset(seed=4)[0]


def test_an_episode_ends_by_its_condition_and_by_its_time():
    env = environment(terminated=lambda now: now.t > 2.5 * STEP, until=4 * STEP)
    env.reset()
    assert [env.step([0.0])[2:4] for _ in range(4)] == [(False, False), (False, False), (True, False), (True, True)]
    env.reset()
    assert env.step([0.0])[2:4] == (False, False)
    # not a whole multiple: the last action that ends in time
    env = environment(every=3 * STEP, until=0.1)
    env.reset()
    assert [env.step([0.0])[3] for _ in range(3)] == [False, False, True]


def test_a_motion_that_cannot_go_on_is_truncated_with_the_reason():
    """By a torque that no step of this length follows."""
    env = environment(inputs={"torque": (-1e30, 1e30)}, until=np.inf)
    env.reset()
    for _ in range(100):
        seen, reward, terminated, truncated, info = env.step([1e30])
        if truncated:
            break
    assert truncated and not terminated and info["error"] and np.isfinite(seen).all() and reward == 0
    assert np.isfinite(env.reset()[0]).all() and not env.step([0.0])[3]


def test_the_class_is_one_and_found_by_pickle():
    assert issubclass(ezy.Environment, gymnasium.Env) and ezy.Environment is ezy.Environment
    assert pickle.loads(pickle.dumps(ezy.Environment)) is ezy.Environment


@pytest.mark.parametrize(
    "call, words",
    [
        (lambda: environment(inputs={"torqe": (-1, 1)}), "did you mean `torque`?"),
        (lambda: environment(inputs={}), "this scene has: torque"),
        (lambda: environment(inputs={"torque": 1}), "takes its low and high bound"),
        (lambda: environment(inputs={"torque": (1, -1)}), "a low bound below its high bound"),
        (lambda: environment(observe=["bar.fi"]), "did you mean `bar.phi`?"),
        (lambda: environment(observe="bar.phi"), "a list of names"),
        (lambda: environment(reward=1), "`reward` takes a function"),
        (lambda: environment(every=0.015), "`every` takes a whole multiple of `step`"),
        (lambda: environment(every=-1.0), "`every` takes a whole multiple of `step`"),
        (lambda: environment(until=STEP / 2), "`until` takes 0.01 s"),
        (lambda: environment(every="x"), "`every` takes a number of seconds"),
        (lambda: environment(until=[1]), "`until` takes a number of seconds"),
        (lambda: environment(until=np.nan), "`until` takes 0.01 s"),
        (lambda: environment(inputs=["torque"]), "`inputs` takes a dictionary"),
        (lambda: environment(start=3), "`start` takes a dictionary"),
        (lambda: environment(start={"bar.phi": "x"}), "start `bar.phi` takes its low and high bound"),
        (lambda: environment(start={"bar.fi": 1}).reset(), "did you mean `bar.phi`?"),
        (lambda: environment().reset(options={"strt": 1}), "'strt'"),
        (lambda: environment().step([1, 2]), "an action has the shape (1,)"),
        (lambda: environment().step([np.nan]), "finite"),
    ],
)
def test_wrong_use_has_words(call, words):
    with pytest.raises(ezy.EzyError) as error:
        call()
    assert words in str(error.value)


def test_without_gymnasium_all_else_works():
    text = """
import sys
sys.modules["gymnasium"] = None
import ezy
assert ezy.pendulum.swing().run(until=0.1)
try:
    ezy.Environment
except ImportError as error:
    assert "pip install gymnasium" in str(error), error
else:
    raise AssertionError("made without Gymnasium")
"""
    done = subprocess.run([sys.executable, "-c", text], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
