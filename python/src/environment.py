"""A scene as an environment of Gymnasium."""

import math
from collections.abc import Mapping

import gymnasium
import numpy as np

#: Share of `every` by which it, or `until`, may miss a whole multiple: decimal fractions are no binary ones.
ROUNDING = 1e-9


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
        self.inputs, self.action_space = _actions(self.stepper, inputs)
        names = self.stepper.names
        self.observe = [*names["q"], *names["v"]] if observe is None else _listed(observe)
        for name in self.observe:
            self.stepper[name]  # an unknown name is an error now
        self.observation_space = gymnasium.spaces.Box(-np.inf, np.inf, (len(self.observe),), np.float64)
        self._reward = _function("reward", reward)
        self._terminated = _function("terminated", terminated) if terminated is not None else lambda now: False
        self._start = start if callable(start) else _distributions(start or {})
        every = step if every is None else _seconds("every", every)
        self._n_steps = _whole("every", every, "step", step)
        until = scene.until if until is None else _seconds("until", until)
        self._n_actions = until / every * (1 + ROUNDING)
        if not self._n_actions >= 1:
            raise EzyError(f"`until` takes {every} s, the time between actions, at least, but was given {until} s")
        self._n_taken = 0

    def reset(self, *, seed=None, options=None):
        """Begins an episode; options may have a `start` with values by name, which go before those of the environment."""
        super().reset(seed=seed)
        options = dict(options or {})
        given = options.pop("start", {})
        if options:
            raise EzyError(f"`reset` takes the option `start` alone, but was given {', '.join(map(repr, options))}")
        drawn = self._start(self.np_random) if callable(self._start) else _drawn(self._start, self.np_random)
        self.stepper.reset({**drawn, **given})
        self._n_taken = 0
        return self._observation(), self._info()

    def step(self, action):
        """Sets the inputs and goes on by `every` s."""
        action = np.asarray(action, dtype=np.float64)
        if action.shape != self.action_space.shape:
            raise EzyError(
                f"an action has the shape {self.action_space.shape}, a number for each of {', '.join(self.inputs)}, "
                f"but this one has {action.shape}"
            )
        action = np.clip(action, self.action_space.low, self.action_space.high)
        try:
            self.stepper.step(self._n_steps, **dict(zip(self.inputs, action.tolist())))
        except StoppedError as error:
            return self._observation(), 0.0, False, True, {**self._info(), "error": str(error)}
        self._n_taken += 1
        terminated = bool(self._terminated(self.stepper))
        is_over = self._n_taken + 1 > self._n_actions
        return self._observation(), float(self._reward(self.stepper)), terminated, is_over, self._info()

    def _observation(self):
        return np.array([self.stepper[name] for name in self.observe], dtype=np.float64)

    def _info(self):
        return {"t": self.stepper.t}


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
