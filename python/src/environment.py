"""A scene as an environment of Gymnasium, or as many that step together."""

import math
from collections.abc import Mapping

import gymnasium
import gymnasium.vector
import numpy as np

#: Share of `every` by which it, or `until`, may miss a whole multiple: decimal fractions are no binary ones.
ROUNDING = 1e-9


class _Task:
    """What is done, observed, rewarded and ended: of one stepper, or of each member of a batch."""

    def __init__(self, now, scene, step, *, inputs, reward, terminated, observe, start, every, until):
        self.now = now
        self.inputs, self.action_space = _actions(now, inputs)
        names = now.names
        self.observe = [*names["q"], *names["v"]] if observe is None else _listed(observe)
        for name in self.observe:
            now[name]  # an unknown name is an error now
        self.observation_space = gymnasium.spaces.Box(-np.inf, np.inf, (len(self.observe),), np.float64)
        self.reward = _function("reward", reward)
        self.terminated = _function("terminated", terminated) if terminated is not None else lambda now: False
        self._start = start if callable(start) else _distributions(start or {})
        every = step if every is None else _seconds("every", every)
        self.n_steps = _whole("every", every, "step", step)
        until = scene.until if until is None else _seconds("until", until)
        self._n_actions = until / every * (1 + ROUNDING)
        if not self._n_actions >= 1:
            raise EzyError(f"`until` takes {every} s, the time between actions, at least, but was given {until} s")

    def drawn(self, generator):
        """A start."""
        return self._start(generator) if callable(self._start) else _drawn(self._start, generator)

    def act(self, action, shape):
        """Sets the inputs, each a number or an array, and takes the steps."""
        action = np.asarray(action, dtype=np.float64)
        if action.shape != shape:
            raise EzyError(
                f"an action has the shape {shape}, a number for each of {', '.join(self.inputs)}, but this one has {action.shape}"
            )
        action = np.clip(action, self.action_space.low, self.action_space.high)
        self.now.step(self.n_steps, **dict(zip(self.inputs, action.T)))

    def is_over(self, n_taken):
        """Whether time is up after so many actions."""
        return n_taken + 1 > self._n_actions

    def observation(self):
        return np.stack([self.now[name] for name in self.observe], axis=-1, dtype=np.float64)


class Environment(gymnasium.Env):
    """A scene as an environment of Gymnasium.

    scene and step are the scene and the step of its stepper, s. Every `every` s (`step` if not given) an action sets the inputs, which hold
    until the next one: inputs has the low and high bound of each by its name, and an action beyond a bound is taken at the bound. observe
    names what is observed, all coordinates and velocities if not given. reward and terminated are functions of the stepper after the action:
    `now["bar.phi"]` is a number by its name. start gives values to begin with by name, each a number or the bounds of an even distribution;
    or it is a function of the random generator that returns such numbers. After `until` s, those of the scene if not given, an episode is
    truncated; and when the motion cannot go on, with the reason in `info["error"]`.

    Raises EzyError for what cannot be used.
    """

    metadata = {"render_modes": []}

    def __init__(self, scene, step, *, inputs, reward, terminated=None, observe=None, start=None, every=None, until=None):
        self.stepper = scene.stepper(step)
        kept = dict(inputs=inputs, reward=reward, terminated=terminated, observe=observe, start=start, every=every, until=until)
        self._task = _Task(self.stepper, scene, step, **kept)
        self.inputs, self.observe = self._task.inputs, self._task.observe
        self.action_space, self.observation_space = self._task.action_space, self._task.observation_space
        self._n_taken = 0

    def reset(self, *, seed=None, options=None):
        """Begins an episode; options may have a `start` with values by name, which go before those of the environment."""
        super().reset(seed=seed)
        given = _options(options, "start").get("start", {})
        self.stepper.reset({**self._task.drawn(self.np_random), **given})
        self._n_taken = 0
        return self._task.observation(), self._info()

    def step(self, action):
        """Sets the inputs and goes on by `every` s."""
        try:
            self._task.act(action, self.action_space.shape)
        except StoppedError as error:
            return self._task.observation(), 0.0, False, True, {**self._info(), "error": str(error)}
        self._n_taken += 1
        terminated, reward = bool(self._task.terminated(self.stepper)), float(self._task.reward(self.stepper))
        return self._task.observation(), reward, terminated, self._task.is_over(self._n_taken), self._info()

    def _info(self):
        return {"t": self.stepper.t}


class VectorEnvironment(gymnasium.vector.VectorEnv):
    """Many environments of one scene that step together, on all cores: a VectorEnv of Gymnasium.

    num_envs is how many; scene, step and all else are as for Environment. reward and terminated are functions of the batch after the actions:
    `now["bar.phi"]` is an array with a number for each member, and so is what they return. parameters has arrays by name, one number for each
    member; threads is how many work at most, and lanes lets eight step at once, as for a batch. autoreset_mode is one of Gymnasium's: "NextStep", "SameStep" or "Disabled". The numbers are
    those of `gymnasium.vector.SyncVectorEnv` of so many Environments, without lanes to the bit.

    Raises EzyError for what cannot be used.
    """

    def __init__(
        self,
        scene,
        num_envs,
        step,
        *,
        inputs,
        reward,
        terminated=None,
        observe=None,
        start=None,
        every=None,
        until=None,
        parameters=None,
        threads=None,
        lanes=False,
        autoreset_mode="NextStep",
    ):
        self.batch = scene.batch(num_envs, step, parameters=parameters, threads=threads, lanes=lanes)
        kept = dict(inputs=inputs, reward=reward, terminated=terminated, observe=observe, start=start, every=every, until=until)
        self._task = _Task(self.batch, scene, step, **kept)
        self.num_envs = num_envs
        self.inputs, self.observe = self._task.inputs, self._task.observe
        self.single_action_space, self.single_observation_space = self._task.action_space, self._task.observation_space
        self.action_space = gymnasium.vector.utils.batch_space(self.single_action_space, num_envs)
        self.observation_space = gymnasium.vector.utils.batch_space(self.single_observation_space, num_envs)
        self._mode = _autoreset_mode(autoreset_mode)
        self.metadata = {"render_modes": [], "autoreset_mode": self._mode}
        self._generators = [gymnasium.utils.seeding.np_random()[0] for _ in range(num_envs)]
        self._n_taken = np.zeros(num_envs, dtype=np.int64)
        self._has_ended = np.zeros(num_envs, dtype=bool)

    def reset(self, *, seed=None, options=None):
        """Begins episodes; options may have a `start` with values by name, and a `reset_mask` of the environments that are meant.

        seed is that of the first environment, and the next ones have the next numbers; or it is a list with one for each.
        """
        options = _options(options, "start", "reset_mask")
        chosen = np.flatnonzero(_mask(options.get("reset_mask"), self.num_envs))
        for i, own in zip(chosen, _seeds(seed, self.num_envs)[chosen]):
            if own is not None:
                self._generators[i] = gymnasium.utils.seeding.np_random(own)[0]
        self._begin(chosen, options.get("start", {}))
        return self._task.observation(), self._infos()

    def step(self, actions):
        """Sets the inputs and goes on by `every` s."""
        ended = self._has_ended
        if ended.any() and self._mode.value == "Disabled":
            who = np.flatnonzero(ended).tolist()
            raise EzyError(f'environments {who} have ended: reset them by reset(options={{"reset_mask": …}}) before the next step')
        try:
            self._task.act(actions, self.action_space.shape)
        except StoppedError:
            pass  # the batch knows which ones, and why
        self._n_taken += 1
        stopped = {i: why for i, why in self.batch.stopped.items() if not ended[i]}
        is_stopped = np.isin(np.arange(self.num_envs), list(stopped))
        rewards = np.where(ended | is_stopped, 0.0, self._each("reward", self._task.reward, np.float64))
        terminations = self._each("terminated", self._task.terminated, bool) & ~ended & ~is_stopped
        truncations = (self._task.is_over(self._n_taken) | is_stopped) & ~ended
        # with "NextStep": they began an episode in place of a step
        self._begin(np.flatnonzero(ended), {})
        self._has_ended = terminations | truncations
        infos, observations = self._infos(stopped), self._task.observation()
        if self._mode.value == "SameStep" and self._has_ended.any():
            observations, infos = self._next_episodes(observations, stopped)
        return observations, rewards, terminations, truncations, infos

    def _next_episodes(self, last, stopped):
        """With "SameStep": what is observed at the starts; infos have what was observed at the ends."""
        t, infos, ended = self.batch.t, {}, np.flatnonzero(self._has_ended)
        for i in ended:
            error = {"error": stopped[i]} if i in stopped else {}
            infos = self._add_info(infos, {"final_obs": last[i], "final_info": {"t": t[i], **error}}, i)
        self._begin(ended, {})
        return self._task.observation(), {**infos, **self._infos()}

    def _begin(self, chosen, given):
        """Starts the next episodes of these environments."""
        if len(chosen) == 0:
            return
        starts = [{**self._task.drawn(self._generators[i]), **given} for i in chosen]
        names = {name: None for start in starts for name in start}
        if any(len(start) != len(names) for start in starts):
            # a function of the generator may give other names each time
            for i, start in zip(chosen, starts):
                self.batch.reset([i], start)
        else:
            self.batch.reset(chosen, {name: [start[name] for start in starts] for name in names})
        self._n_taken[chosen] = 0
        self._has_ended[chosen] = False

    def _each(self, what, function, dtype):
        """What a function of the batch returns, for each environment."""
        found = np.asarray(function(self.batch))
        if found.shape not in [(), (self.num_envs,)] or found.dtype.kind not in "bif":
            raise EzyError(
                f"`{what}` returns an array with one number for each of {self.num_envs} environments, but returned {found!r}"
            )
        return np.broadcast_to(found, self.num_envs).astype(dtype)

    def _infos(self, stopped=None):
        infos = {"t": self.batch.t, "_t": np.ones(self.num_envs, dtype=bool)}
        for i, why in (stopped or {}).items():
            infos = self._add_info(infos, {"error": why}, i)
        return infos


def _options(given, *known):
    options = dict(given or {})
    other = [repr(name) for name in options if name not in known]
    if other:
        raise EzyError(f"`reset` takes the options {' and '.join(f'`{name}`' for name in known)}, but was given {', '.join(other)}")
    return options


def _mask(given, n):
    mask = np.ones(n, dtype=bool) if given is None else np.asarray(given)
    if mask.shape != (n,) or mask.dtype != bool:
        raise EzyError(f"`reset_mask` takes {n} times True or False, but was given {given!r}")
    return mask


def _seeds(seed, n):
    try:
        seeds = [seed] * n if seed is None else [seed + i for i in range(n)] if isinstance(seed, (int, np.integer)) else list(seed)
    except TypeError:
        seeds = []
    if len(seeds) != n:
        raise EzyError(f"`seed` takes a whole number, or {n} of them, but was given {seed!r}")
    return np.array(seeds, dtype=object)


def _autoreset_mode(given):
    try:
        modes = gymnasium.vector.AutoresetMode
    except AttributeError:
        raise EzyError("VectorEnvironment takes Gymnasium from 1.1 on: `pip install -U gymnasium`") from None
    try:
        return modes(given)
    except ValueError:
        known = ", ".join(f'"{mode.value}"' for mode in modes)
        raise EzyError(f"`autoreset_mode` takes one of {known}, but was given {given!r}") from None


def _actions(stepper, inputs):
    """Names and space of the actions."""
    if not inputs:
        raise EzyError(f"`inputs` names no input to act with; this scene has: {', '.join(stepper.inputs) or 'none'}")
    bounds = [_bounds(f"input `{name}`", pair) for name, pair in _by_name("inputs", inputs)]
    stepper.set(**dict.fromkeys(inputs, 0.0))  # an unknown name is an error now
    stepper.reset()
    low, high = np.array(bounds, dtype=np.float64).T
    return list(inputs), gymnasium.spaces.Box(low, high, dtype=np.float64)


def _by_name(what, given):
    if not isinstance(given, Mapping):
        raise EzyError(f"`{what}` takes a dictionary of names and their bounds, such as {{'a': (-1, 1)}}, but was given {given!r}")
    return given.items()


def _bounds(what, pair):
    try:
        low, high = map(float, pair)
    except (TypeError, ValueError):
        raise EzyError(f"{what} takes its low and high bound, such as (-1, 1), but was given {pair!r}") from None
    if not low < high:
        raise EzyError(f"{what} takes a low bound below its high bound, but was given {pair!r}")
    return low, high


def _listed(names):
    if isinstance(names, str):
        raise EzyError(f"`observe` takes a list of names, such as [{names!r}], but was given {names!r}")
    return list(names)


def _function(what, given):
    if not callable(given):
        raise EzyError(f'`{what}` takes a function of the stepper, such as lambda now: now["t"], but was given {given!r}')
    return given


def _distributions(start):
    def of(name, value):
        return value if isinstance(value, (int, float, np.number)) else _bounds(f"start `{name}`", value)

    return {name: of(name, value) for name, value in _by_name("start", start)}


def _drawn(start, generator):
    return {name: generator.uniform(*value) if isinstance(value, tuple) else value for name, value in start.items()}


def _seconds(what, given):
    try:
        return float(given)
    except (TypeError, ValueError):
        raise EzyError(f"`{what}` takes a number of seconds, but was given {given!r}") from None


def _whole(what, length, of, part):
    """How many times `part` goes into `length`."""
    n = round(length / part) if math.isfinite(length) else 0
    if n < 1 or abs(n * part - length) > ROUNDING * length:
        raise EzyError(f"`{what}` takes a whole multiple of `{of}`, {part} s, but was given {length} s")
    return n
