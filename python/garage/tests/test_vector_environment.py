"""Many environments that step together: the numbers of Gymnasium's own vector of single ones."""

import pickle

import ezy
import numpy as np
import pytest

gymnasium = pytest.importorskip("gymnasium")
vector = pytest.importorskip("gymnasium.vector")

STEP = 1e-2
N = 5
KEPT = {
    "inputs": {"torque": (-1, 1)},
    "reward": lambda now: now["bar.omega"],
    "terminated": lambda now: abs(now["bar.phi"]) > 0.35,
    "start": {"bar.phi": (-0.3, 0.3)},
    "every": 5 * STEP,
    "until": 60 * STEP,
}


def environments(n=N, **changes):
    return ezy.VectorEnvironment(ezy.ezyroller.ridden(), n, STEP, **{**KEPT, **changes})


def equal(one, other):
    """Of infos: dictionaries of arrays, of which some hold objects."""
    if isinstance(one, dict):
        return one.keys() == other.keys() and all(equal(one[key], other[key]) for key in one)
    if getattr(one, "dtype", None) == object:
        return all(a is b or np.array_equal(a, b) for a, b in zip(one, other))
    return np.array_equal(one, other)


@pytest.mark.parametrize("mode", ["NextStep", "SameStep"])
def test_episodes_are_those_of_single_environments(mode):
    """Over many ends, by condition and by time, with starts from the same seeds."""
    together = environments(autoreset_mode=mode)
    single = lambda: ezy.Environment(ezy.ezyroller.ridden(), STEP, **KEPT)
    alone = vector.SyncVectorEnv([single] * N, autoreset_mode=vector.AutoresetMode(mode))
    assert together.observation_space == alone.observation_space and together.action_space == alone.action_space
    assert together.num_envs == N and together.metadata["autoreset_mode"] == alone.metadata["autoreset_mode"]
    seen, info = together.reset(seed=7)
    expected, expected_info = alone.reset(seed=7)
    assert np.array_equal(seen, expected) and equal(info, expected_info)
    together.action_space.seed(1)
    n_ends = np.zeros(2, dtype=int)
    for _ in range(80):
        actions = together.action_space.sample()
        *found, info = together.step(actions)
        *expected, expected_info = alone.step(actions)
        for one, other in zip(found, expected):
            assert np.array_equal(one, other) and one.dtype == other.dtype
        assert equal(info, expected_info)
        n_ends += [found[2].sum(), found[3].sum()]
    assert (n_ends > 0).all(), n_ends


def test_without_autoreset_the_caller_resets():
    of = environments(autoreset_mode="Disabled", terminated=None, until=10 * STEP)
    of.reset(seed=1)
    actions = np.zeros((N, 1))
    of.step(actions)
    assert of.step(actions)[3].all()
    with pytest.raises(ezy.EzyError, match="reset_mask"):
        of.step(actions)
    of.reset(options={"reset_mask": np.ones(N, dtype=bool), "start": {"bar.phi": 0.1}})
    assert (of.batch["bar.phi"] == 0.1).all() and not of.step(actions)[3].any()
    of.reset(options={"reset_mask": np.arange(N) == 2})
    assert of.batch.t[2] == 0 and of.batch.t[1] > 0


@pytest.mark.parametrize("mode", ["NextStep", "SameStep"])
def test_a_motion_that_cannot_go_on_is_truncated_with_the_reason(mode):
    of = environments(inputs={"torque": (-1e30, 1e30)}, until=np.inf, terminated=None, autoreset_mode=mode)
    of.reset(seed=1)
    actions = np.where(np.arange(N) == 3, 1e30, 0.0)[:, None]
    for _ in range(100):
        seen, rewards, terminations, truncations, infos = of.step(actions)
        if truncations.any():
            break
    assert truncations.tolist() == [False, False, False, True, False] and not terminations.any() and rewards[3] == 0
    told = infos["final_info"] if mode == "SameStep" else infos
    assert told["error"][3] and told["_error"].tolist() == truncations.tolist() and np.isfinite(seen).all()
    seen, rewards, terminations, truncations, infos = of.step(np.zeros((N, 1)))
    assert not truncations.any() and "error" not in infos and of.batch.stopped == {}
    assert of.batch.t[3] == (0 if mode == "NextStep" else 5 * STEP)


def test_parameters_and_starts_differ_between_members():
    name, (default, _, _) = next(iter(ezy.ezyroller.ridden.parameters.items()))
    start = lambda random: {"bar.phi": random.normal(0, 0.1)}
    of = environments(parameters={name: default * np.linspace(0.9, 1.1, N)}, start=start, terminated=None)
    first = of.reset(seed=3)[0]
    assert len(np.unique(of.batch["bar.phi"])) == N
    of.reset(seed=4)
    assert np.array_equal(of.reset(seed=[3, 4, 5, 6, 7])[0], first)
    # a start may name one value in one episode and another one in the next
    of = environments(start=lambda random: {"bar.phi": 0.1} if random.random() < 0.5 else {})
    assert set(of.reset(seed=3)[0][:, of.observe.index("bar.phi")]) == {0.1, ezy.ezyroller.ridden().stepper(STEP)["bar.phi"]}


def test_wrappers_of_gymnasium_take_it():
    of = gymnasium.wrappers.vector.RecordEpisodeStatistics(environments())
    of.reset(seed=1)
    lengths = []
    for _ in range(60):
        infos = of.step(of.action_space.sample())[4]
        lengths += list(infos["episode"]["l"][infos["_episode"]]) if "episode" in infos else []
    assert lengths and max(lengths) <= 12


def test_the_class_is_one_and_found_by_pickle():
    assert issubclass(ezy.VectorEnvironment, vector.VectorEnv) and ezy.VectorEnvironment is ezy.VectorEnvironment
    assert pickle.loads(pickle.dumps(ezy.VectorEnvironment)) is ezy.VectorEnvironment


@pytest.mark.parametrize(
    "call, words",
    [
        (lambda: environments(0), "`n` takes a whole number from 1 on"),
        (lambda: environments(inputs={"torqe": (-1, 1)}), "did you mean `torque`?"),
        (lambda: environments(observe=["bar.fi"]), "did you mean `bar.phi`?"),
        (lambda: environments(parameters={"no": 1}), "parameter `no` is not known"),
        (lambda: environments(autoreset_mode="no"), '`autoreset_mode` takes one of "NextStep"'),
        (lambda: environments(start={"bar.fi": 1}).reset(), "did you mean `bar.phi`?"),
        (lambda: environments().reset(options={"strt": 1}), "`start` and `reset_mask`, but was given 'strt'"),
        (lambda: environments().reset(options={"reset_mask": [0, 1]}), "`reset_mask` takes 5 times True or False"),
        (lambda: environments().reset(seed=[1, 2]), "`seed` takes a whole number, or 5 of them"),
        (lambda: environments().reset(seed=1.5), "`seed` takes a whole number, or 5 of them"),
        (lambda: environments().step([1, 2]), "an action has the shape (5, 1)"),
        (lambda: environments().step(np.full((N, 1), np.nan)), "finite"),
        (lambda: environments(reward=lambda now: [1, 2]).step(np.zeros((N, 1))), "`reward` returns an array"),
        (lambda: environments(terminated=lambda now: "x").step(np.zeros((N, 1))), "`terminated` returns an array"),
    ],
)
def test_wrong_use_has_words(call, words):
    with pytest.raises(ezy.EzyError) as error:
        call()
    assert words in str(error.value)
