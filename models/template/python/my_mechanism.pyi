# Written by `type_stub()` of this module.
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any, SupportsFloat, TypeAlias, final

import gymnasium
import numpy as np
import numpy.typing as npt

_Array: TypeAlias = npt.NDArray[np.float64]
_Times: TypeAlias = Sequence[float] | npt.NDArray[Any]
#: Default, unit and meaning by name.
_Declared: TypeAlias = dict[str, tuple[float, str, str]]
#: A number, or its low and high bound.
_Start: TypeAlias = Mapping[str, float | tuple[float, float]]

class EzyError(ValueError):
    """A name, value or setting that cannot be used; the text says how to mend it."""

class StoppedError(EzyError):
    """A run that ended before its time; its attribute `run` has everything up to there."""

    run: Run

class Model:
    """A model: its scenes are attributes."""

    @property
    def name(self) -> str:
        """Name of the model."""
    @property
    def scenes(self) -> list[str]:
        """Its scenes, in declared order."""
    def __dir__(self) -> list[str]: ...

class SceneType:
    """A scene without parameters yet; called with some, it makes the scene."""

    @property
    def name(self) -> str:
        """Name of the scene."""
    @property
    def parameters(self) -> _Declared:
        """Name, default, unit and meaning of each parameter."""
    @property
    def inputs(self) -> _Declared:
        """Name, default, unit and meaning of each input."""
    @property
    def counts(self) -> dict[str, int]:
        """Names and defaults of the counts."""
    def __call__(self, *args: Any, **parameters: Any) -> Scene:
        """The scene with these parameters and counts."""

@final
class Scene:
    """A scene with its parameters."""

    @property
    def name(self) -> str:
        """Name of the scene."""
    @property
    def parameters(self) -> dict[str, float]:
        """Present values of the parameters and counts."""
    @property
    def until(self) -> float:
        """End of a run that is given none, s."""
    @property
    def coordinates(self) -> list[str]:
        """Names of the coordinates."""
    def run(
        self,
        until: float | None = None,
        *,
        rtol: float | None = None,
        atol: float | None = None,
        step: float | None = None,
        method: str | None = None,
        every: float | None = None,
        at: _Times | None = None,
        start: Mapping[str, float] | None = None,
        inputs: Mapping[str, float | tuple[_Times, _Times]] | None = None,
        project_start: bool = False,
        estimate: bool = False,
        work: bool = False,
    ) -> Run:
        """Simulates the scene and returns its run.

        until: end, s; that of the scene if not given
        rtol, atol: tolerances of a method that chooses its steps
        step: step of a method that does not, s
        method: "dop853", "taylor", "radau", "rk4", …
        every: time between samples, s; a 500th of the run if neither it nor `at` is given
        at: times of samples, s
        start: values to begin with, by name
        inputs: numbers, or pairs of times and values, by name
        project_start: moves values of the start that contradict the constraints to the nearest that do not
        estimate: runs once more and tells the error
        work: integrates the works of the effects

        Raises EzyError for what cannot be run, and StoppedError for a run that ends before its time; its attribute `run` has everything up to
        there.
        """
    def stepper(
        self, step: float, *, start: Mapping[str, float] | None = None, inputs: Mapping[str, float] | None = None
    ) -> Stepper:
        """A stepper: the scene in fixed steps of `step` s by rk4, to be driven from outside.

        start and inputs as for `run`, inputs as numbers alone.
        """
    def check(self) -> None:
        """Compares the equations of the scene with finite differences; raises EzyError where they differ."""

@final
class Run:
    """A finished run: a mapping from the names of columns to arrays with a number for each sample."""

    def __getitem__(self, name: str, /) -> _Array: ...
    def __len__(self) -> int: ...
    def __contains__(self, name: str, /) -> bool: ...
    def __iter__(self) -> Iterator[str]: ...
    def keys(self) -> list[str]:
        """Names of the columns."""
    def items(self) -> list[tuple[str, _Array]]:
        """Names and arrays."""
    def to_dict(self) -> dict[str, _Array]:
        """A dictionary of the arrays: `pandas.DataFrame(run.to_dict())`."""
    @property
    def t(self) -> _Array:
        """Times of the samples, s."""
    @property
    def units(self) -> dict[str, str]:
        """Units of the columns, by name."""
    @property
    def outcome(self) -> str:
        """How it ended."""
    @property
    def events(self) -> list[tuple[float, str]]:
        """Times, s, and names of the events."""
    @property
    def cost(self) -> dict[str, float]:
        """Steps, evaluations and seconds of a processor that it took."""
    @property
    def estimate(self) -> dict[str, float] | str | None:
        """With `estimate=True` the largest error of positions, velocities and so on, each in its unit; a text where there is no estimate."""

@final
class Stepper:
    """A scene in fixed steps. Inputs hold until they are set again."""

    def step(self, n: int = 1, **inputs: float) -> float:
        """Sets inputs by name, takes `n` steps, and returns the time, s."""
    def set(self, **inputs: float) -> None:
        """Sets inputs by name; none of them where one cannot be set."""
    def reset(self, start: Mapping[str, float] | None = None) -> None:
        """Goes back to the start, with these values by name if there are any."""
    def __getitem__(self, name: str, /) -> float:
        """The present value of a coordinate, velocity, output or input, or of the time `t`, by its name."""
    def save(self) -> Checkpoint:
        """Where it is now."""
    def restore(self, checkpoint: Checkpoint) -> None:
        """Goes to where it was saved."""
    @property
    def t(self) -> float:
        """Time, s."""
    @property
    def q(self) -> _Array:
        """Coordinates, in the order of `names`."""
    @property
    def v(self) -> _Array:
        """Velocities."""
    @property
    def outputs(self) -> _Array:
        """Outputs, with the present inputs."""
    @property
    def inputs(self) -> dict[str, float]:
        """Present inputs by name."""
    @property
    def names(self) -> dict[str, list[str]]:
        """Names of coordinates, velocities and outputs."""

@final
class Checkpoint:
    """Where a stepper was: from there the same steps lead to the same bits."""

class Environment(gymnasium.Env[_Array, _Array]):
    """A scene as an environment of Gymnasium.

    scene and step are the scene and the step of its stepper, s. Every `every` s (`step` if not given) an action sets the inputs, which hold
    until the next one: inputs has the low and high bound of each by its name, and an action beyond a bound is taken at the bound. observe
    names what is observed, all coordinates and velocities if not given. reward and terminated are functions of the stepper after the action:
    `now["bar.phi"]` is a number by its name. start gives values to begin with by name, each a number or the bounds of an even distribution;
    or it is a function of the random generator that returns such numbers. After `until` s, those of the scene if not given, an episode is
    truncated; and when the motion cannot go on, with the reason in `info["error"]`.

    Raises EzyError for what cannot be used.
    """

    stepper: Stepper
    inputs: list[str]
    observe: list[str]
    def __init__(
        self,
        scene: Scene,
        step: float,
        *,
        inputs: Mapping[str, tuple[float, float]],
        reward: Callable[[Stepper], SupportsFloat],
        terminated: Callable[[Stepper], bool] | None = None,
        observe: Sequence[str] | None = None,
        start: _Start | Callable[[np.random.Generator], Mapping[str, float]] | None = None,
        every: float | None = None,
        until: float | None = None,
    ) -> None: ...
    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[_Array, dict[str, Any]]:
        """Begins an episode; options may have a `start` with values by name, which go before those of the environment."""
    def step(self, action: npt.ArrayLike) -> tuple[_Array, float, bool, bool, dict[str, Any]]:
        """Sets the inputs and goes on by `every` s."""

def type_stub() -> str:
    """The types of this module as the text of its `.pyi` file."""

class _Coast(SceneType):
    def __call__(self, *, l: float = 0.5, trail: float = 0.05, m: float = 80.0, i: float = 6.0, k: float = 0.3) -> Scene:
        """It rolls out against the air.

        l: from the frame's centre of mass to the rear wheel, and to the head [m]
        trail: from the head back to where the front wheel touches the ground [m]
        m: mass of frame and rider [kg]
        i: their moment of inertia [kg*m^2]
        k: force per square of the speed [N*s^2/m^2]
        """

class _Ridden(SceneType):
    def __call__(self, *, l: float = 0.5, trail: float = 0.05, m: float = 80.0, i: float = 6.0, k: float = 0.3) -> Scene:
        """Somebody steers: set `steer`.

        l: from the frame's centre of mass to the rear wheel, and to the head [m]
        trail: from the head back to where the front wheel touches the ground [m]
        m: mass of frame and rider [kg]
        i: their moment of inertia [kg*m^2]
        k: force per square of the speed [N*s^2/m^2]
        """

coast: _Coast
ridden: _Ridden
