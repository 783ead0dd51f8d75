from collections.abc import Callable, Iterator, Mapping, Sequence
from os import PathLike
from typing import Any, Literal, SupportsFloat, TypeAlias, final

import gymnasium
import gymnasium.vector
import numpy as np
import numpy.typing as npt

_Array: TypeAlias = npt.NDArray[np.float64]
_Times: TypeAlias = Sequence[float] | npt.NDArray[Any]
#: Default, unit and meaning by name.
_Declared: TypeAlias = dict[str, tuple[float, str, str]]
#: A number for all members of a batch, or one for each.
_Numbers: TypeAlias = float | Sequence[float] | npt.NDArray[Any]
#: Indices of members, or True or False for each.
_Members: TypeAlias = Sequence[int] | Sequence[bool] | npt.NDArray[Any]
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
    def sweep(
        self,
        vary: Mapping[str, _Times],
        *,
        together: bool = False,
        keep: Sequence[str] = ...,
        threads: int | None = None,
        lanes: bool = False,
        every: float | None = None,
        until: float | None = None,
        rtol: float | None = None,
        atol: float | None = None,
        step: float | None = None,
        method: str | None = None,
        start: Mapping[str, float] | None = None,
        inputs: Mapping[str, float | tuple[_Times, _Times]] | None = None,
        project_start: bool = False,
    ) -> dict[str, Any]:
        """Runs the scene for all values of what `vary` names, on all cores: parameters, counts, inputs and start values. Returns a dictionary of
        arrays with a number for each run: `pandas.DataFrame(table)`.

        vary: sequences of values by name; each value meets each other one, the last name varies fastest
        together: the first values belong together, then the second ones, and so on
        keep: what is kept of each run: "seat.vx" at its end ("end:seat.vx" where it is varied), "max:output.speed", "event:landed"; positions and
            velocities if not given
        threads: how many work at most
        lanes: runs eight neighbours together where they are run by dop853 with one count and only their ends are kept, others one by one
        every: time between the samples from which extremes are taken, s
        until, rtol, atol, step, method, start, inputs and project_start as for `run`

        A run that fails is a row with its outcome and a message.
        """
    def sensitivities(
        self,
        by: Sequence[str],
        until: float | None = None,
        *,
        rtol: float | None = None,
        atol: float | None = None,
        step: float | None = None,
        method: str | None = None,
        every: float | None = None,
        at: _Times | None = None,
        start: Mapping[str, float] | None = None,
        inputs: Mapping[str, float] | None = None,
        project_start: bool = False,
    ) -> Sensitivities:
        """A run with the exact derivatives of coordinates, velocities and first-order states by what `by` names: parameters, and values that the
        start gives. They are those of the computed motion,
        whose steps end at the samples. It does not end at events, and where a law jumps the derivatives lack the jump; stops and limits of skates are
        refused.

        until, rtol, atol, step, method, every, at, start and project_start as for `run`, inputs as numbers alone. Methods are "dop853", "rk4" and
        "midpoint". Start values stay as they are when a parameter changes, and what the start does not give follows the constraints.

        Raises EzyError for what cannot be run, and StoppedError where the motion cannot go on.
        """
    def stepper(
        self, step: float, *, start: Mapping[str, float] | None = None, inputs: Mapping[str, float] | None = None
    ) -> Stepper:
        """A stepper: the scene in fixed steps of `step` s by rk4, to be driven from outside.

        start and inputs as for `run`, inputs as numbers alone.
        """
    def batch(
        self,
        n: int,
        step: float,
        *,
        start: Mapping[str, _Numbers] | None = None,
        inputs: Mapping[str, _Numbers] | None = None,
        parameters: Mapping[str, _Numbers] | None = None,
        threads: int | None = None,
        lanes: bool = False,
    ) -> Batch:
        """`n` steppers that step together on all cores, without the global lock.

        start, inputs and parameters have values by name, each a number or an array with one for each member; threads is how many work at
        most. The numbers are those of single steppers, whatever the number of threads; with lanes=True eight members step at once, 2.6 times as
        fast, and their numbers are those but for 1e-12 of their size a step.
        """
    def equilibrium(
        self,
        *,
        start: Mapping[str, float] | None = None,
        inputs: Mapping[str, float] | None = None,
        hold: Sequence[str] = ...,
    ) -> Equilibrium:
        """The equilibrium near the start: rest, or motion that is constant seen from a frame that travels and turns evenly.

        start and inputs as for `run`, inputs as numbers alone. hold names coordinates, velocities and states that keep their value of the start.
        """
    def equilibria(
        self,
        *,
        n_starts: int = 128,
        start: Mapping[str, float] | None = None,
        inputs: Mapping[str, float] | None = None,
        hold: Sequence[str] = ...,
    ) -> list[Equilibrium]:
        """All equilibria at rest that `n_starts` starts lead to: that of the scene, and others at random, which are the same each time.

        start, inputs and hold as for `equilibrium`. A rest that no start leads to is not found.
        """
    def linearize(
        self,
        *,
        start: Mapping[str, float] | None = None,
        inputs: Mapping[str, float] | None = None,
        hold: Sequence[str] = ...,
    ) -> Linearization:
        """The linear equations x' = A x + B u, y = C x + D u of small deviations from the equilibrium near the start, with exact derivatives.

        start, inputs and hold as for `equilibrium`.
        """
    def equations(self) -> str:
        """The equations of the scene in LaTeX, as displayed mathematics with titles; the package `amsmath` has what they take."""
    def sketch(self, at: float = 0.0, *, start: Mapping[str, float] | None = None) -> Sketch:
        """A sketch of the mechanism at the time `at`, s. A notebook shows it, and `save(path)` writes it.

        start has values to begin with by name, as for `run`.
        """
    def _repr_latex_(self) -> str: ...
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
    def animation(self) -> Animation:
        """An animation of the run, with a frame for each sample. A notebook shows it, and `save(path)` writes it."""
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
class Sensitivities:
    """A run with the derivatives of coordinates, velocities and first-order states by some quantities, at each sample."""

    def __getitem__(self, key: str | tuple[str, str], /) -> _Array:
        """The values of a column by its name; with a pair of names its derivatives: `found["bar.phi", "m0"]`."""
    def jacobian(self, *columns: str) -> _Array:
        """Derivatives of these columns, all if none are named: an array of samples × columns × quantities."""
    @property
    def t(self) -> _Array:
        """Times of the samples, s."""
    @property
    def columns(self) -> list[str]:
        """Names of the columns: coordinates, velocities and first-order states."""
    @property
    def by(self) -> list[str]:
        """Names of the quantities that it is differentiated by."""
    @property
    def units(self) -> dict[str, str]:
        """Units of columns and quantities, by name; a derivative has the one over the other."""

@final
class Equilibrium:
    """Rest, or motion that is constant seen from a frame that travels and turns evenly."""

    def __getitem__(self, name: str, /) -> float:
        """The value of a coordinate, velocity or first-order state by its name."""
    @property
    def q(self) -> _Array:
        """Coordinates."""
    @property
    def v(self) -> _Array:
        """Velocities."""
    @property
    def state(self) -> dict[str, float]:
        """Coordinates, velocities and first-order states by name."""
    @property
    def multipliers(self) -> dict[str, float]:
        """Multipliers by the names of their rows."""
    @property
    def kind(self) -> str:
        """Kind of the motion: "rest", "in place" where parts turn and no body moves on, "straight" or "circle"; see `frame`."""
    @property
    def frame(self) -> tuple[float, float, float]:
        """Velocity of the frame in which it rests, at the origin along x and y, m/s, and its rate of turn, rad/s."""
    @property
    def free(self) -> list[str]:
        """Coordinates, velocities and states in which the equilibria next to it differ; hold names some."""

@final
class Linearization:
    """The linear equations x' = A x + B u, y = C x + D u of small deviations from an equilibrium.

    x are coordinates of the tangent space of the constraints: the deviations of what `names` lists are `basis` x, seen from the frame of the
    equilibrium.
    """

    @property
    def equilibrium(self) -> Equilibrium:
        """What it deviates from."""
    @property
    def A(self) -> _Array:
        """A, 1/s: a row and a column for each x."""
    @property
    def B(self) -> _Array:
        """B: a column for each of `inputs`."""
    @property
    def C(self) -> _Array:
        """C: a row for each of `outputs`."""
    @property
    def D(self) -> _Array:
        """D: a row for each of `outputs` and a column for each of `inputs`."""
    @property
    def basis(self) -> _Array:
        """A row for each of `names`, and a column for each x; the columns are orthonormal."""
    @property
    def names(self) -> list[str]:
        """Coordinates, velocities and first-order states."""
    @property
    def inputs(self) -> list[str]:
        """Names of the inputs u."""
    @property
    def outputs(self) -> list[str]:
        """Names of the outputs y."""
    @property
    def eigenvalues(self) -> npt.NDArray[np.complex128]:
        """Eigenvalues of A that are not zero, 1/s, by falling real part; of a pair the one with the positive imaginary part first."""
    @property
    def n_zero(self) -> int:
        """How many eigenvalues of A are zero."""
    @property
    def n_unstable(self) -> int:
        """How many eigenvalues have a positive real part."""

@final
class Sketch:
    """A technical drawing of a mechanism. A notebook shows it."""

    @property
    def svg(self) -> str:
        """The text of the SVG file."""
    def save(self, path: str | PathLike[str]) -> None:
        """Writes the SVG file."""
    def _repr_svg_(self) -> str: ...

@final
class Animation:
    """An animation of a run: a page with the mechanism, its forces and its plots. A notebook shows it."""

    def save(self, path: str | PathLike[str]) -> None:
        """Writes it: as the page that `ezy animate` writes, .html, or as a picture that moves, .svg."""
    def _repr_html_(self) -> str: ...

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

@final
class Batch:
    """Many steppers of one scene, each with its own start, inputs and parameters, that step together on all cores."""

    def step(self, n: int = 1, **inputs: _Numbers) -> _Array:
        """Sets inputs by name, each a number or an array with one for each member, takes `n` steps, and returns the times, s.

        A member whose motion cannot go on stays where it is until it is reset: its reason is in `stopped`, and StoppedError is raised once,
        when all the others have taken their steps.
        """
    def set(self, **inputs: _Numbers) -> None:
        """Sets inputs by name, each a number or an array with one for each member; none of them where one cannot be set."""
    def reset(self, members: _Members | None = None, start: Mapping[str, _Numbers] | None = None) -> None:
        """Brings members back to their starts: all of them, or those of indices or of a mask. start has values by name, each a number or an
        array with one for each of these members. Where a member cannot take its start it stays where it is, and the others are reset.
        """
    def __getitem__(self, name: str, /) -> _Array:
        """The present values of a coordinate, velocity, output or input, or of the time `t`, by its name: one for each member."""
    def __len__(self) -> int: ...
    @property
    def t(self) -> _Array:
        """Time of each member, s."""
    @property
    def q(self) -> _Array:
        """Coordinates: a row for each member, in the order of `names`."""
    @property
    def v(self) -> _Array:
        """Velocities: a row for each member."""
    @property
    def outputs(self) -> _Array:
        """Outputs, with the present inputs: a row for each member."""
    @property
    def inputs(self) -> dict[str, _Array]:
        """Present inputs by name, one for each member."""
    @property
    def names(self) -> dict[str, list[str]]:
        """Names of coordinates, velocities and outputs."""
    @property
    def stopped(self) -> dict[int, str]:
        """The members whose motion cannot go on, by index, with the reason."""

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

class VectorEnvironment(gymnasium.vector.VectorEnv[_Array, _Array, npt.NDArray[Any]]):
    """Many environments of one scene that step together, on all cores: a VectorEnv of Gymnasium.

    num_envs is how many; scene, step and all else are as for Environment. reward and terminated are functions of the batch after the actions:
    `now["bar.phi"]` is an array with a number for each member, and so is what they return. parameters has arrays by name, one number for each
    member; threads is how many work at most, and lanes lets eight step at once, as for a batch. autoreset_mode is one of Gymnasium's: "NextStep", "SameStep" or "Disabled". The numbers are
    those of `gymnasium.vector.SyncVectorEnv` of so many Environments, without lanes to the bit.

    Raises EzyError for what cannot be used.
    """

    batch: Batch
    inputs: list[str]
    observe: list[str]
    def __init__(
        self,
        scene: Scene,
        num_envs: int,
        step: float,
        *,
        inputs: Mapping[str, tuple[float, float]],
        reward: Callable[[Batch], npt.ArrayLike],
        terminated: Callable[[Batch], npt.ArrayLike] | None = None,
        observe: Sequence[str] | None = None,
        start: _Start | Callable[[np.random.Generator], Mapping[str, float]] | None = None,
        every: float | None = None,
        until: float | None = None,
        parameters: Mapping[str, _Numbers] | None = None,
        threads: int | None = None,
        lanes: bool = False,
        autoreset_mode: Literal["NextStep", "SameStep", "Disabled"] | gymnasium.vector.AutoresetMode = "NextStep",
    ) -> None: ...
    def reset(
        self, *, seed: int | Sequence[int | None] | None = None, options: dict[str, Any] | None = None
    ) -> tuple[_Array, dict[str, Any]]:
        """Begins episodes; options may have a `start` with values by name, and a `reset_mask` of the environments that are meant.

        seed is that of the first environment, and the next ones have the next numbers; or it is a list with one for each.
        """
    def step(
        self, actions: npt.ArrayLike
    ) -> tuple[_Array, npt.NDArray[Any], npt.NDArray[Any], npt.NDArray[Any], dict[str, Any]]:
        """Sets the inputs and goes on by `every` s."""

def type_stub() -> str:
    """The types of this module as the text of its `.pyi` file."""
