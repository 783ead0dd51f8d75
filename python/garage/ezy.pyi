# Written by `type_stub()` of this module.
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

class _EzyRollerCoast(SceneType):
    def __call__(self, *, a: float = 0.2, b: float = 0.6, c: float = 0.1, d: float = 0.1, m1: float = 46.0, i1: float = 10.0, m2: float = 1.0, i2: float = 0.005) -> Scene:
        """No forces: the bar stands across, the seat moves at 1 m/s.

        a: rear wheel A, behind the seat's centre of mass [m]
        b: hinge B, ahead of the seat's centre of mass [m]
        c: front wheel C, beyond the bar's centre of mass [m]
        d: bar's centre of mass, beyond the hinge [m]
        m1: mass of seat and rider [kg]
        i1: moment of inertia of seat and rider [kg*m^2]
        m2: mass of the bar [kg]
        i2: moment of inertia of the bar [kg*m^2]
        """

class _EzyRollerDriven(SceneType):
    def __call__(self, *, a: float = 0.2, b: float = 0.6, c: float = 0.1, d: float = 0.1, m1: float = 46.0, i1: float = 10.0, m2: float = 1.0, i2: float = 0.005, m0: float = 2.0, omega: float = 3.141592653589793) -> Scene:
        """From rest, folded, driven by the rider's torque.

        a: rear wheel A, behind the seat's centre of mass [m]
        b: hinge B, ahead of the seat's centre of mass [m]
        c: front wheel C, beyond the bar's centre of mass [m]
        d: bar's centre of mass, beyond the hinge [m]
        m1: mass of seat and rider [kg]
        i1: moment of inertia of seat and rider [kg*m^2]
        m2: mass of the bar [kg]
        i2: moment of inertia of the bar [kg*m^2]
        m0: largest torque [N*m]
        omega: angular frequency of the torque [rad/s]
        """

class _EzyRollerDrivenOnTarmac(SceneType):
    def __call__(self, *, a: float = 0.2, b: float = 0.6, c: float = 0.1, d: float = 0.1, m1: float = 46.0, i1: float = 10.0, m2: float = 1.0, i2: float = 0.005, m0: float = 2.0, omega: float = 3.141592653589793, k: float = 0.5) -> Scene:
        """Driven, with rolling resistance.

        a: rear wheel A, behind the seat's centre of mass [m]
        b: hinge B, ahead of the seat's centre of mass [m]
        c: front wheel C, beyond the bar's centre of mass [m]
        d: bar's centre of mass, beyond the hinge [m]
        m1: mass of seat and rider [kg]
        i1: moment of inertia of seat and rider [kg*m^2]
        m2: mass of the bar [kg]
        i2: moment of inertia of the bar [kg*m^2]
        m0: largest torque [N*m]
        omega: angular frequency of the torque [rad/s]
        k: drag per speed [N*s/m]
        """

class _EzyRollerDrift(SceneType):
    def __call__(self, *, a: float = 0.2, b: float = 0.6, c: float = 0.1, d: float = 0.1, m1: float = 46.0, i1: float = 10.0, m2: float = 1.0, i2: float = 0.005, m0: float = 2.0, omega: float = 3.141592653589793, k: float = 0.5, cornering: float = 400.0, creep: float = 0.1) -> Scene:
        """Driven, with a rear wheel that slips and rolls with resistance.

        a: rear wheel A, behind the seat's centre of mass [m]
        b: hinge B, ahead of the seat's centre of mass [m]
        c: front wheel C, beyond the bar's centre of mass [m]
        d: bar's centre of mass, beyond the hinge [m]
        m1: mass of seat and rider [kg]
        i1: moment of inertia of seat and rider [kg*m^2]
        m2: mass of the bar [kg]
        i2: moment of inertia of the bar [kg*m^2]
        m0: largest torque [N*m]
        omega: angular frequency of the torque [rad/s]
        k: drag per speed [N*s/m]
        cornering: side force per slip angle [N/rad]
        creep: speed below which the wheel creeps [m/s]
        """

class _EzyRollerSkid(SceneType):
    def __call__(self, *, a: float = 0.2, b: float = 0.6, c: float = 0.1, d: float = 0.1, m1: float = 46.0, i1: float = 10.0, m2: float = 1.0, i2: float = 0.005, m0: float = 2.0, omega: float = 3.141592653589793, hold: float = 4.0) -> Scene:
        """Driven, with a rear wheel on ice that holds and slides by turns.

        a: rear wheel A, behind the seat's centre of mass [m]
        b: hinge B, ahead of the seat's centre of mass [m]
        c: front wheel C, beyond the bar's centre of mass [m]
        d: bar's centre of mass, beyond the hinge [m]
        m1: mass of seat and rider [kg]
        i1: moment of inertia of seat and rider [kg*m^2]
        m2: mass of the bar [kg]
        i2: moment of inertia of the bar [kg*m^2]
        m0: largest torque [N*m]
        omega: angular frequency of the torque [rad/s]
        hold: largest side force [N]
        """

class _EzyRollerRidden(SceneType):
    def __call__(self, *, a: float = 0.2, b: float = 0.6, c: float = 0.1, d: float = 0.1, m1: float = 46.0, i1: float = 10.0, m2: float = 1.0, i2: float = 0.005) -> Scene:
        """At 1 m/s with the bar across, in the hands of a rider: set `torque`.

        a: rear wheel A, behind the seat's centre of mass [m]
        b: hinge B, ahead of the seat's centre of mass [m]
        c: front wheel C, beyond the bar's centre of mass [m]
        d: bar's centre of mass, beyond the hinge [m]
        m1: mass of seat and rider [kg]
        i1: moment of inertia of seat and rider [kg*m^2]
        m2: mass of the bar [kg]
        i2: moment of inertia of the bar [kg*m^2]
        """

class _EzyRoller(Model):
    """A seat on a rear wheel, steered and driven by swinging a front bar on its own wheel."""

    coast: _EzyRollerCoast
    driven: _EzyRollerDriven
    driven_on_tarmac: _EzyRollerDrivenOnTarmac
    drift: _EzyRollerDrift
    skid: _EzyRollerSkid
    ridden: _EzyRollerRidden

ezyroller: _EzyRoller

class _RollerRacerCoast(SceneType):
    def __call__(self, *, a: float = 0.3, b: float = 0.2, h: float = 0.0, c: float = -0.1, m1: float = 2.0, i1: float = 0.05, m2: float = 0.3, i2: float = 0.004) -> Scene:
        """Rolls freely.

        a: rear axle, behind the seat's centre of mass [m]
        b: hinge, ahead of the seat's centre of mass [m]
        h: handle's centre of mass, beyond the hinge [m]
        c: front axle, beyond the handle's centre of mass [m]
        m1: mass of seat and rider [kg]
        i1: moment of inertia of seat and rider [kg*m^2]
        m2: mass of the handle [kg]
        i2: moment of inertia of the handle [kg*m^2]
        """

class _RollerRacerRowed(SceneType):
    def __call__(self, *, a: float = 0.3, b: float = 0.2, h: float = 0.0, c: float = -0.1, m1: float = 2.0, i1: float = 0.05, m2: float = 0.3, i2: float = 0.004, m0: float = 0.3, mean: float = 0.0, omega: float = 4.0, phase: float = 0.0) -> Scene:
        """From rest, rowed.

        a: rear axle, behind the seat's centre of mass [m]
        b: hinge, ahead of the seat's centre of mass [m]
        h: handle's centre of mass, beyond the hinge [m]
        c: front axle, beyond the handle's centre of mass [m]
        m1: mass of seat and rider [kg]
        i1: moment of inertia of seat and rider [kg*m^2]
        m2: mass of the handle [kg]
        i2: moment of inertia of the handle [kg*m^2]
        m0: amplitude of the torque on the handle [N*m]
        mean: its mean [N*m]
        omega: angular frequency [rad/s]
        phase: phase at t = 0 [rad]
        """

class _RollerRacerRowedOnTarmac(SceneType):
    def __call__(self, *, a: float = 0.3, b: float = 0.2, h: float = 0.0, c: float = -0.1, m1: float = 2.0, i1: float = 0.05, m2: float = 0.3, i2: float = 0.004, m0: float = 0.3, mean: float = 0.0, omega: float = 4.0, phase: float = 0.0, resistance: float = 0.2, knee: float = 0.01) -> Scene:
        """From rest, rowed against rolling resistance.

        a: rear axle, behind the seat's centre of mass [m]
        b: hinge, ahead of the seat's centre of mass [m]
        h: handle's centre of mass, beyond the hinge [m]
        c: front axle, beyond the handle's centre of mass [m]
        m1: mass of seat and rider [kg]
        i1: moment of inertia of seat and rider [kg*m^2]
        m2: mass of the handle [kg]
        i2: moment of inertia of the handle [kg*m^2]
        m0: amplitude of the torque on the handle [N*m]
        mean: its mean [N*m]
        omega: angular frequency [rad/s]
        phase: phase at t = 0 [rad]
        resistance: resistance of each wheel [N]
        knee: speed at which it has grown to seven tenths [m/s]
        """

class _RollerRacerTwistcar(SceneType):
    def __call__(self, *, a: float = 0.3, b: float = 0.2, h: float = 0.0, c: float = -0.1, m1: float = 2.0, i1: float = 0.05, m2: float = 0.3, i2: float = 0.004, m0: float = 0.3, mean: float = 0.0, omega: float = 4.0, phase: float = 0.0, k: float = 0.8, damping: float = 0.05, angle: float = 0.0) -> Scene:
        """Rowed against a spring.

        a: rear axle, behind the seat's centre of mass [m]
        b: hinge, ahead of the seat's centre of mass [m]
        h: handle's centre of mass, beyond the hinge [m]
        c: front axle, beyond the handle's centre of mass [m]
        m1: mass of seat and rider [kg]
        i1: moment of inertia of seat and rider [kg*m^2]
        m2: mass of the handle [kg]
        i2: moment of inertia of the handle [kg*m^2]
        m0: amplitude of the torque on the handle [N*m]
        mean: its mean [N*m]
        omega: angular frequency [rad/s]
        phase: phase at t = 0 [rad]
        k: stiffness [N*m]
        damping: damping [N*m*s]
        angle: angle of the handle without torque [rad]
        """

class _RollerRacerRollingOut(SceneType):
    def __call__(self, *, a: float = 0.3, b: float = 0.2, h: float = 0.0, c: float = -0.1, m1: float = 2.0, i1: float = 0.05, m2: float = 0.3, i2: float = 0.004, resistance: float = 0.2, knee: float = 0.01) -> Scene:
        """Rolls out.

        a: rear axle, behind the seat's centre of mass [m]
        b: hinge, ahead of the seat's centre of mass [m]
        h: handle's centre of mass, beyond the hinge [m]
        c: front axle, beyond the handle's centre of mass [m]
        m1: mass of seat and rider [kg]
        i1: moment of inertia of seat and rider [kg*m^2]
        m2: mass of the handle [kg]
        i2: moment of inertia of the handle [kg*m^2]
        resistance: resistance of each wheel [N]
        knee: speed at which it has grown to seven tenths [m/s]
        """

class _RollerRacer(Model):
    """Two hinged bodies, each on one axle, rowed by a torque between them."""

    coast: _RollerRacerCoast
    rowed: _RollerRacerRowed
    rowed_on_tarmac: _RollerRacerRowedOnTarmac
    twistcar: _RollerRacerTwistcar
    rolling_out: _RollerRacerRollingOut

rollerracer: _RollerRacer

class _SnakeboardSerpentine(SceneType):
    def __call__(self, *, r: float = 0.2, m_board: float = 4.0, j_board: float = 0.016, m_rotor: float = 2.0, j_rotor: float = 0.072, m_truck: float = 0.0, j_truck: float = 0.0013, twist_offset: float = 0.0, twist_rate: float = 0.0, twist_swing: float = 0.7, twist_nu: float = 1.0, twist_phase: float = 0.0, front_offset: float = 0.0, front_rate: float = 0.0, front_swing: float = 0.3, front_nu: float = 1.0, front_phase: float = 0.0, back_offset: float = 0.0, back_rate: float = 0.0, back_swing: float = -0.3, back_nu: float = 1.0, back_phase: float = 0.0) -> Scene:
        """From rest: twist and steering in step, which drives the board forward.

        r: truck, from the middle of the board [m]
        m_board: mass of the board [kg]
        j_board: moment of inertia of the board [kg*m^2]
        m_rotor: mass of the rider [kg]
        j_rotor: moment of inertia of the rider [kg*m^2]
        m_truck: mass of a truck [kg]
        j_truck: moment of inertia of a truck [kg*m^2]
        twist_offset: Without a description. [rad]
        twist_rate: Without a description. [rad/s]
        twist_swing: Without a description. [rad]
        twist_nu: Without a description. [rad/s]
        twist_phase: Without a description. [rad]
        front_offset: Without a description. [rad]
        front_rate: Without a description. [rad/s]
        front_swing: Without a description. [rad]
        front_nu: Without a description. [rad/s]
        front_phase: Without a description. [rad]
        back_offset: Without a description. [rad]
        back_rate: Without a description. [rad/s]
        back_swing: Without a description. [rad]
        back_nu: Without a description. [rad/s]
        back_phase: Without a description. [rad]
        """

class _SnakeboardStroked(SceneType):
    def __call__(self, *, r: float = 0.2, m_board: float = 4.0, j_board: float = 0.016, m_rotor: float = 2.0, j_rotor: float = 0.072, m_truck: float = 0.0, j_truck: float = 0.0013, m0: float = 0.08, mean: float = 0.0, omega: float = 2.0, phase: float = 0.5, k: float = 0.05, c: float = 0.002) -> Scene:
        """Rolling, with sprung trucks and a torque between board and rider.

        r: truck, from the middle of the board [m]
        m_board: mass of the board [kg]
        j_board: moment of inertia of the board [kg*m^2]
        m_rotor: mass of the rider [kg]
        j_rotor: moment of inertia of the rider [kg*m^2]
        m_truck: mass of a truck [kg]
        j_truck: moment of inertia of a truck [kg*m^2]
        m0: amplitude of the torque on the rider [N*m]
        mean: its mean [N*m]
        omega: angular frequency [rad/s]
        phase: phase at t = 0 [rad]
        k: stiffness [N*m]
        c: damping [N*m*s]
        """

class _Snakeboard(Model):
    """A board on two steerable trucks with a rider who twists."""

    serpentine: _SnakeboardSerpentine
    stroked: _SnakeboardStroked

snakeboard: _Snakeboard

class _SkateboardCarved(SceneType):
    def __call__(self, *, r: float = 0.4, m_deck: float = 3.0, j_deck: float = 0.15, m_rider: float = 60.0, j_rider: float = 1.5, m_truck: float = 0.8, j_truck: float = 0.003, delta: float = 0.0, swing: float = 0.3, nu: float = 3.0) -> Scene:
        """Carves with prescribed steering, the rider still.

        r: truck, from the middle of the deck [m]
        m_deck: mass of the deck [kg]
        j_deck: moment of inertia of the deck [kg*m^2]
        m_rider: mass of the rider [kg]
        j_rider: moment of inertia of the rider [kg*m^2]
        m_truck: mass of a truck with its wheels [kg]
        j_truck: moment of inertia of a truck with its wheels [kg*m^2]
        delta: mean steering angle of the front truck [rad]
        swing: amplitude of the swing about the mean [rad]
        nu: angular frequency of the swing [rad/s]
        """

class _SkateboardRidden(SceneType):
    def __call__(self, *, r: float = 0.4, m_deck: float = 3.0, j_deck: float = 0.15, m_rider: float = 60.0, j_rider: float = 1.5, m_truck: float = 0.8, j_truck: float = 0.003, m0: float = 4.0, omega: float = 3.0, k: float = 20.0, c: float = 0.8, k_rider: float = 15.0, f: float = 80.0, nu_push: float = 4.0) -> Scene:
        """Twists and pushes on sprung trucks.

        r: truck, from the middle of the deck [m]
        m_deck: mass of the deck [kg]
        j_deck: moment of inertia of the deck [kg*m^2]
        m_rider: mass of the rider [kg]
        j_rider: moment of inertia of the rider [kg*m^2]
        m_truck: mass of a truck with its wheels [kg]
        j_truck: moment of inertia of a truck with its wheels [kg*m^2]
        m0: largest torque on the rider [N*m]
        omega: angular frequency [rad/s]
        k: stiffness of a truck [N*m]
        c: damping of a truck [N*m*s]
        k_rider: stiffness of the rider [N*m]
        f: largest force along the deck [N]
        nu_push: strokes per time [rad/s]
        """

class _Skateboard(Model):
    """A deck with a rider on two trucks that steer against each other."""

    carved: _SkateboardCarved
    ridden: _SkateboardRidden

skateboard: _Skateboard

class _ChaplyginSleighCoast(SceneType):
    def __call__(self, *, a: float = 1.0, m: float = 1.0, j: float = 1.0) -> Scene:
        """On a level plane.

        a: centre of mass, ahead of the blade [m]
        m: mass [kg]
        j: moment of inertia about the centre of mass [kg*m^2]
        """

class _ChaplyginSleighDownhill(SceneType):
    def __call__(self, *, a: float = 1.0, m: float = 1.0, j: float = 1.0, slope: float = 1.0) -> Scene:
        """On an inclined plane.

        a: centre of mass, ahead of the blade [m]
        m: mass [kg]
        j: moment of inertia about the centre of mass [kg*m^2]
        slope: gravity along the plane [m/s^2]
        """

class _ChaplyginSleigh(Model):
    """A body on one blade."""

    coast: _ChaplyginSleighCoast
    downhill: _ChaplyginSleighDownhill

chaplyginsleigh: _ChaplyginSleigh

class _KnifeEdgeCycloid(SceneType):
    def __call__(self, *, m: float = 1.25, j: float = 0.13, g: float = 9.81, alpha: float = 0.7853981633974483) -> Scene:
        """From rest along the blade, turning steadily: one period of the cycloid.

        m: mass [kg]
        j: moment of inertia [kg*m^2]
        g: gravity [m/s^2]
        alpha: inclination of the plane [rad]
        """

class _KnifeEdge(Model):
    """A blade that turns on an inclined plane."""

    cycloid: _KnifeEdgeCycloid

knifeedge: _KnifeEdge

class _TractorTrailersLocked(SceneType):
    def __call__(self, *, front: float = 0.6, rear: float = 0.4, hitch1: float = 0.3, hook1: float = 0.8, axle1: float = 0.1, hitch2: float = 0.2, hook2: float = 0.7, axle2: float = 0.1, m_steer: float = 0.4, i_steer: float = 0.01, m_tractor: float = 6.0, i_tractor: float = 0.9, m_first: float = 3.0, i_first: float = 0.4, m_second: float = 2.0, i_second: float = 0.25, delta: float = 0.35, delta_rate: float = 0.0, swing: float = 0.0, nu: float = 1.0, nu_phase: float = 0.0) -> Scene:
        """Coasts with locked steering.

        front: steered axle, ahead of the tractor's centre of mass [m]
        rear: rear axle, behind the tractor's centre of mass [m]
        hitch1: hitch, behind the tractor's centre of mass [m]
        hook1: hitch, ahead of the first trailer's centre of mass [m]
        axle1: axle, behind the first trailer's centre of mass [m]
        hitch2: hitch, behind the first trailer's centre of mass [m]
        hook2: hitch, ahead of the second trailer's centre of mass [m]
        axle2: axle, behind the second trailer's centre of mass [m]
        m_steer: mass of the steered axle [kg]
        i_steer: moment of inertia of the steered axle [kg*m^2]
        m_tractor: mass of the tractor [kg]
        i_tractor: moment of inertia of the tractor [kg*m^2]
        m_first: mass of the first trailer [kg]
        i_first: moment of inertia of the first trailer [kg*m^2]
        m_second: mass of the second trailer [kg]
        i_second: moment of inertia of the second trailer [kg*m^2]
        delta: mean angle [rad]
        delta_rate: rate of the mean angle [rad/s]
        swing: amplitude of a swing about the mean [rad]
        nu: angular frequency of the swing [rad/s]
        nu_phase: phase at t = 0 [rad]
        """

class _TractorTrailersTowed(SceneType):
    def __call__(self, *, front: float = 0.6, rear: float = 0.4, hitch1: float = 0.3, hook1: float = 0.8, axle1: float = 0.1, hitch2: float = 0.2, hook2: float = 0.7, axle2: float = 0.1, m_steer: float = 0.4, i_steer: float = 0.01, m_tractor: float = 6.0, i_tractor: float = 0.9, m_first: float = 3.0, i_first: float = 0.4, m_second: float = 2.0, i_second: float = 0.25, delta: float = 0.35, delta_rate: float = 0.0, swing: float = 0.0, nu: float = 1.0, nu_phase: float = 0.0, f: float = 3.0, linear: float = 0.5, angular: float = 0.1) -> Scene:
        """Round a circle with locked steering, under thrust and drag.

        front: steered axle, ahead of the tractor's centre of mass [m]
        rear: rear axle, behind the tractor's centre of mass [m]
        hitch1: hitch, behind the tractor's centre of mass [m]
        hook1: hitch, ahead of the first trailer's centre of mass [m]
        axle1: axle, behind the first trailer's centre of mass [m]
        hitch2: hitch, behind the first trailer's centre of mass [m]
        hook2: hitch, ahead of the second trailer's centre of mass [m]
        axle2: axle, behind the second trailer's centre of mass [m]
        m_steer: mass of the steered axle [kg]
        i_steer: moment of inertia of the steered axle [kg*m^2]
        m_tractor: mass of the tractor [kg]
        i_tractor: moment of inertia of the tractor [kg*m^2]
        m_first: mass of the first trailer [kg]
        i_first: moment of inertia of the first trailer [kg*m^2]
        m_second: mass of the second trailer [kg]
        i_second: moment of inertia of the second trailer [kg*m^2]
        delta: mean angle [rad]
        delta_rate: rate of the mean angle [rad/s]
        swing: amplitude of a swing about the mean [rad]
        nu: angular frequency of the swing [rad/s]
        nu_phase: phase at t = 0 [rad]
        f: thrust [N]
        linear: drag per speed [N*s/m]
        angular: torque per rate [N*m*s]
        """

class _TractorTrailersPiloted(SceneType):
    def __call__(self, *, front: float = 0.6, rear: float = 0.4, hitch1: float = 0.3, hook1: float = 0.8, axle1: float = 0.1, hitch2: float = 0.2, hook2: float = 0.7, axle2: float = 0.1, m_steer: float = 0.4, i_steer: float = 0.01, m_tractor: float = 6.0, i_tractor: float = 0.9, m_first: float = 3.0, i_first: float = 0.4, m_second: float = 2.0, i_second: float = 0.25, heading: float = 0.5, kp: float = 0.6, ki: float = 0.05, stiff: float = 4.0, damp: float = 0.6, pull: float = 0.3, f: float = 3.0, linear: float = 0.5, angular: float = 0.1) -> Scene:
        """An autopilot turns the last trailer to a heading.

        front: steered axle, ahead of the tractor's centre of mass [m]
        rear: rear axle, behind the tractor's centre of mass [m]
        hitch1: hitch, behind the tractor's centre of mass [m]
        hook1: hitch, ahead of the first trailer's centre of mass [m]
        axle1: axle, behind the first trailer's centre of mass [m]
        hitch2: hitch, behind the first trailer's centre of mass [m]
        hook2: hitch, ahead of the second trailer's centre of mass [m]
        axle2: axle, behind the second trailer's centre of mass [m]
        m_steer: mass of the steered axle [kg]
        i_steer: moment of inertia of the steered axle [kg*m^2]
        m_tractor: mass of the tractor [kg]
        i_tractor: moment of inertia of the tractor [kg*m^2]
        m_first: mass of the first trailer [kg]
        i_first: moment of inertia of the first trailer [kg*m^2]
        m_second: mass of the second trailer [kg]
        i_second: moment of inertia of the second trailer [kg*m^2]
        heading: wanted heading of the second trailer [rad]
        kp: wanted steering angle per error of the heading [1]
        ki: wanted steering angle per integral of that error [1/s]
        stiff: torque per error of the steering angle [N*m/rad]
        damp: torque per rate of the steering angle [N*m*s/rad]
        pull: torque that pulls the steered axle aside [N*m]
        f: thrust [N]
        linear: drag per speed [N*s/m]
        angular: torque per rate [N*m*s]
        """

class _TractorTrailersWinding(SceneType):
    def __call__(self, *, front: float = 0.6, rear: float = 0.4, hitch1: float = 0.3, hook1: float = 0.8, axle1: float = 0.1, hitch2: float = 0.2, hook2: float = 0.7, axle2: float = 0.1, m_steer: float = 0.4, i_steer: float = 0.01, m_tractor: float = 6.0, i_tractor: float = 0.9, m_first: float = 3.0, i_first: float = 0.4, m_second: float = 2.0, i_second: float = 0.25, m0: float = 0.8, mean: float = 0.0, omega: float = 1.5, phase: float = 0.0, k: float = 1.5, c: float = 0.2, f: float = 3.0, linear: float = 0.5, angular: float = 0.1) -> Scene:
        """Winds under a swinging torque on the steering.

        front: steered axle, ahead of the tractor's centre of mass [m]
        rear: rear axle, behind the tractor's centre of mass [m]
        hitch1: hitch, behind the tractor's centre of mass [m]
        hook1: hitch, ahead of the first trailer's centre of mass [m]
        axle1: axle, behind the first trailer's centre of mass [m]
        hitch2: hitch, behind the first trailer's centre of mass [m]
        hook2: hitch, ahead of the second trailer's centre of mass [m]
        axle2: axle, behind the second trailer's centre of mass [m]
        m_steer: mass of the steered axle [kg]
        i_steer: moment of inertia of the steered axle [kg*m^2]
        m_tractor: mass of the tractor [kg]
        i_tractor: moment of inertia of the tractor [kg*m^2]
        m_first: mass of the first trailer [kg]
        i_first: moment of inertia of the first trailer [kg*m^2]
        m_second: mass of the second trailer [kg]
        i_second: moment of inertia of the second trailer [kg*m^2]
        m0: amplitude of the torque [N*m]
        mean: its mean [N*m]
        omega: angular frequency [rad/s]
        phase: phase at t = 0 [rad]
        k: stiffness [N*m]
        c: damping [N*m*s]
        f: thrust [N]
        linear: drag per speed [N*s/m]
        angular: torque per rate [N*m*s]
        """

class _TractorTrailers(Model):
    """A steered tractor that pulls two trailers hitched off their axles."""

    locked: _TractorTrailersLocked
    towed: _TractorTrailersTowed
    piloted: _TractorTrailersPiloted
    winding: _TractorTrailersWinding

tractortrailers: _TractorTrailers

class _RoadTrainCircling(SceneType):
    def __call__(self, *, n: int = 5, wheelbase: float = 1.0, centre: float = 0.4, c: float = 0.2, l: float = 0.9, m_tractor: float = 6.0, i_tractor: float = 0.9, m: float = 2.0, i: float = 0.3, m_steer: float = 0.4, i_steer: float = 0.01, delta: float = 0.2, swing: float = 0.0, nu: float = 0.5) -> Scene:
        """Enters a circle with locked steering.

        wheelbase: steered axle, ahead of the tractor's rear axle [m]
        centre: tractor's centre of mass, ahead of its rear axle [m]
        c: hitch, behind the rear axle of the tractor or the axle of a trailer [m]
        l: axle of a trailer, behind its hitch [m]
        m_tractor: mass of the tractor [kg]
        i_tractor: moment of inertia of the tractor [kg*m^2]
        m: mass of a trailer, centred on its axle [kg]
        i: moment of inertia of a trailer [kg*m^2]
        m_steer: mass of the steered axle [kg]
        i_steer: moment of inertia of the steered axle [kg*m^2]
        delta: mean angle [rad]
        swing: amplitude of a swing about the mean [rad]
        nu: angular frequency of the swing [rad/s]
        """

class _RoadTrain(Model):
    """A steered tractor and a row of equal trailers."""

    circling: _RoadTrainCircling

roadtrain: _RoadTrain

class _DifferentialRobotCircle(SceneType):
    def __call__(self, *, w: float = 0.2, r: float = 0.05, a: float = 0.0, m: float = 4.0, j: float = 0.08, m_wheel: float = 0.3, i_wheel: float = 0.0004, left_torque: float = 0.02, right_torque: float = 0.03) -> Scene:
        """From rest, by steady torques.

        w: half the distance of the wheels [m]
        r: radius of a wheel [m]
        a: chassis's centre of mass, ahead of the axle [m]
        m: mass of the chassis [kg]
        j: moment of inertia of the chassis [kg*m^2]
        m_wheel: mass of a wheel [kg]
        i_wheel: moment of inertia of a wheel about its axle [kg*m^2]
        left_torque: torque on the left wheel [N*m]
        right_torque: torque on the right wheel [N*m]
        """

class _DifferentialRobotCruise(SceneType):
    def __call__(self, *, w: float = 0.2, r: float = 0.05, a: float = 0.0, m: float = 4.0, j: float = 0.08, m_wheel: float = 0.3, i_wheel: float = 0.0004, left_torque: float = 0.02, right_torque: float = 0.03, c: float = 0.005) -> Scene:
        """From rest, by steady torques against the bearings.

        w: half the distance of the wheels [m]
        r: radius of a wheel [m]
        a: chassis's centre of mass, ahead of the axle [m]
        m: mass of the chassis [kg]
        j: moment of inertia of the chassis [kg*m^2]
        m_wheel: mass of a wheel [kg]
        i_wheel: moment of inertia of a wheel about its axle [kg*m^2]
        left_torque: torque on the left wheel [N*m]
        right_torque: torque on the right wheel [N*m]
        c: torque per rate [N*m*s]
        """

class _DifferentialRobotElectric(SceneType):
    def __call__(self, *, w: float = 0.2, r: float = 0.05, a: float = 0.0, m: float = 4.0, j: float = 0.08, m_wheel: float = 0.3, i_wheel: float = 0.0004, left_voltage: float = 6.0, right_voltage: float = 7.0, resistance: float = 1.5, inductance: float = 0.02, k: float = 0.06, c: float = 0.005) -> Scene:
        """From rest, by electric motors against the bearings.

        w: half the distance of the wheels [m]
        r: radius of a wheel [m]
        a: chassis's centre of mass, ahead of the axle [m]
        m: mass of the chassis [kg]
        j: moment of inertia of the chassis [kg*m^2]
        m_wheel: mass of a wheel [kg]
        i_wheel: moment of inertia of a wheel about its axle [kg*m^2]
        left_voltage: voltage of the left motor [V]
        right_voltage: voltage of the right motor [V]
        resistance: resistance of a winding [ohm]
        inductance: inductance of a winding [H]
        k: torque of a motor per current, and voltage per rate [N*m/A]
        c: torque per rate [N*m*s]
        """

class _DifferentialRobotPrescribed(SceneType):
    def __call__(self, *, w: float = 0.2, r: float = 0.05, a: float = 0.0, m: float = 4.0, j: float = 0.08, m_wheel: float = 0.3, i_wheel: float = 0.0004, left_rate: float = 8.0, right_rate: float = 10.0) -> Scene:
        """At prescribed speeds.

        w: half the distance of the wheels [m]
        r: radius of a wheel [m]
        a: chassis's centre of mass, ahead of the axle [m]
        m: mass of the chassis [kg]
        j: moment of inertia of the chassis [kg*m^2]
        m_wheel: mass of a wheel [kg]
        i_wheel: moment of inertia of a wheel about its axle [kg*m^2]
        left_rate: rate of the left wheel [rad/s]
        right_rate: rate of the right wheel [rad/s]
        """

class _DifferentialRobot(Model):
    """A chassis on two driven wheels."""

    circle: _DifferentialRobotCircle
    cruise: _DifferentialRobotCruise
    electric: _DifferentialRobotElectric
    prescribed: _DifferentialRobotPrescribed

differentialrobot: _DifferentialRobot

class _SingleTrackCarCornering(SceneType):
    def __call__(self, *, lf: float = 1.2, lr: float = 1.4, m: float = 1500.0, j: float = 2500.0, delta: float = 0.02, u: float = 20.0, cf: float = 80000.0, cr: float = 90000.0) -> Scene:
        """Enters a steady corner at held speed.

        lf: front axle, ahead of the centre of mass [m]
        lr: rear axle, behind the centre of mass [m]
        m: mass [kg]
        j: moment of inertia [kg*m^2]
        delta: steering angle [rad]
        u: speed [m/s]
        cf: cornering stiffness of the front axle [N]
        cr: cornering stiffness of the rear axle [N]
        """

class _SingleTrackCarRelaxing(SceneType):
    def __call__(self, *, lf: float = 1.2, lr: float = 1.4, m: float = 1500.0, j: float = 2500.0, delta: float = 0.02, u: float = 20.0, cf: float = 80000.0, cr: float = 90000.0, sigma: float = 0.6) -> Scene:
        """The same on tyres with a relaxation length.

        lf: front axle, ahead of the centre of mass [m]
        lr: rear axle, behind the centre of mass [m]
        m: mass [kg]
        j: moment of inertia [kg*m^2]
        delta: steering angle [rad]
        u: speed [m/s]
        cf: cornering stiffness of the front axle [N]
        cr: cornering stiffness of the rear axle [N]
        sigma: relaxation length [m]
        """

class _SingleTrackCarLimit(SceneType):
    def __call__(self, *, lf: float = 1.2, lr: float = 1.4, m: float = 1500.0, j: float = 2500.0, delta: float = 0.02, u: float = 20.0, cf: float = 80000.0, cr: float = 90000.0, ff: float = 6000.0, fr: float = 5200.0) -> Scene:
        """The same on tyres that level off.

        lf: front axle, ahead of the centre of mass [m]
        lr: rear axle, behind the centre of mass [m]
        m: mass [kg]
        j: moment of inertia [kg*m^2]
        delta: steering angle [rad]
        u: speed [m/s]
        cf: cornering stiffness of the front axle [N]
        cr: cornering stiffness of the rear axle [N]
        ff: largest side force of the front axle [N]
        fr: largest side force of the rear axle [N]
        """

class _SingleTrackCarThrust(SceneType):
    def __call__(self, *, lf: float = 1.2, lr: float = 1.4, m: float = 1500.0, j: float = 2500.0, delta: float = 0.02, cf: float = 80000.0, cr: float = 90000.0, ff: float = 6000.0, fr: float = 5200.0, f: float = 400.0, drag: float = 0.5) -> Scene:
        """Rolls round a corner under a steady thrust.

        lf: front axle, ahead of the centre of mass [m]
        lr: rear axle, behind the centre of mass [m]
        m: mass [kg]
        j: moment of inertia [kg*m^2]
        delta: steering angle [rad]
        cf: cornering stiffness of the front axle [N]
        cr: cornering stiffness of the rear axle [N]
        ff: largest side force of the front axle [N]
        fr: largest side force of the rear axle [N]
        f: thrust [N]
        drag: drag per square of the speed [N*s^2/m^2]
        """

class _SingleTrackCar(Model):
    """A car on two tyres, one behind the other."""

    cornering: _SingleTrackCarCornering
    relaxing: _SingleTrackCarRelaxing
    limit: _SingleTrackCarLimit
    thrust: _SingleTrackCarThrust

singletrackcar: _SingleTrackCar

class _WheeledSnakeSlithering(SceneType):
    def __call__(self, *, l: float = 0.14, m: float = 1.0, i: float = 0.0016, amplitude: float = 0.5, omega: float = 2.0, beta: float = 0.7, k: float = 2.0, c: float = 0.05) -> Scene:
        """On wheels, bent by muscles.

        l: length of a link [m]
        m: mass of a link [kg]
        i: moment of inertia of a link [kg*m^2]
        amplitude: amplitude of the wave [rad]
        omega: angular frequency of the wave [rad/s]
        beta: phase from joint to joint [rad]
        k: stiffness [N*m]
        c: damping [N*m*s]
        """

class _WheeledSnakeCrawling(SceneType):
    def __call__(self, *, l: float = 0.14, m: float = 1.0, i: float = 0.0016, amplitude: float = 0.5, omega: float = 2.0, beta: float = 0.7, along: float = 0.5, across: float = 10.0) -> Scene:
        """The wave prescribed, on viscous ground.

        l: length of a link [m]
        m: mass of a link [kg]
        i: moment of inertia of a link [kg*m^2]
        amplitude: amplitude of the wave [rad]
        omega: angular frequency of the wave [rad/s]
        beta: phase from joint to joint [rad]
        along: friction along the link [N*s/m]
        across: friction across the link [N*s/m]
        """

class _WheeledSnakeFloating(SceneType):
    def __call__(self, *, l: float = 0.14, m: float = 1.0, i: float = 0.0016, amplitude: float = 0.5, omega: float = 2.0, beta: float = 0.7) -> Scene:
        """The wave prescribed, with nothing to push against.

        l: length of a link [m]
        m: mass of a link [kg]
        i: moment of inertia of a link [kg*m^2]
        amplitude: amplitude of the wave [rad]
        omega: angular frequency of the wave [rad/s]
        beta: phase from joint to joint [rad]
        """

class _WheeledSnake(Model):
    """Ten links on wheels that move by bending in a wave."""

    slithering: _WheeledSnakeSlithering
    crawling: _WheeledSnakeCrawling
    floating: _WheeledSnakeFloating

wheeledsnake: _WheeledSnake

class _PendulumSwing(SceneType):
    def __call__(self, *, l: float = 1.0, m: float = 1.0, i: float = 0.0, g: float = 9.81) -> Scene:
        """Released level, on the right of the pin.

        l: centre of mass, away from the pin [m]
        m: mass [kg]
        i: moment of inertia about the centre of mass, zero for a point [kg*m^2]
        g: gravity, downwards [m/s^2]
        """

class _PendulumMirrored(SceneType):
    def __call__(self, *, l: float = 1.0, m: float = 1.0, i: float = 0.0, g: float = 9.81) -> Scene:
        """Released level, on the left of the pin.

        l: centre of mass, away from the pin [m]
        m: mass [kg]
        i: moment of inertia about the centre of mass, zero for a point [kg*m^2]
        g: gravity, downwards [m/s^2]
        """

class _PendulumQuarter(SceneType):
    def __call__(self, *, l: float = 1.0, m: float = 1.0, i: float = 0.0, g: float = 9.81) -> Scene:
        """Released level, on the right of the pin, until it hangs below.

        l: centre of mass, away from the pin [m]
        m: mass [kg]
        i: moment of inertia about the centre of mass, zero for a point [kg*m^2]
        g: gravity, downwards [m/s^2]
        """

class _PendulumKnocking(SceneType):
    def __call__(self, *, l: float = 1.0, m: float = 1.0, i: float = 0.0, g: float = 9.81, e: float = 0.8) -> Scene:
        """Released level, on the right of the pin, against the post.

        l: centre of mass, away from the pin [m]
        m: mass [kg]
        i: moment of inertia about the centre of mass, zero for a point [kg*m^2]
        g: gravity, downwards [m/s^2]
        e: part of the speed that an impact gives back []
        """

class _Pendulum(Model):
    """A body that swings about a pin."""

    swing: _PendulumSwing
    mirrored: _PendulumMirrored
    quarter: _PendulumQuarter
    knocking: _PendulumKnocking

pendulum: _Pendulum

class _DoublePendulumSwing(SceneType):
    def __call__(self, *, l1: float = 1.0, l2: float = 1.0, m1: float = 1.0, m2: float = 1.0, g: float = 9.81) -> Scene:
        """Released level and straight.

        l1: length of the upper rod [m]
        l2: length of the lower rod [m]
        m1: mass of the upper rod [kg]
        m2: mass of the lower rod [kg]
        g: gravity, downwards [m/s^2]
        """

class _DoublePendulum(Model):
    """Two rods that swing about a pin and an elbow."""

    swing: _DoublePendulumSwing

doublependulum: _DoublePendulum

class _SliderCrankPushed(SceneType):
    def __call__(self, *, r: float = 0.5, l: float = 1.0, r_centre: float = 0.0, l_centre: float = 1.0, m1: float = 1.0, i1: float = 1.0, m2: float = 1.0, i2: float = 2.0, k: float = 1.0, l0: float = 1.0, c: float = 1.0, f: float = 1.0, tip: float = 1.0) -> Scene:
        """From rest, with the crank upright.

        r: crank, from bearing to pin [m]
        l: rod, from pin to slider [m]
        r_centre: crank's centre of mass, from the bearing [m]
        l_centre: rod's centre of mass, from the pin [m]
        m1: mass of the crank [kg]
        i1: moment of inertia of the crank [kg*m^2]
        m2: mass of the rod [kg]
        i2: moment of inertia of the rod [kg*m^2]
        k: stiffness [N/m]
        l0: length without force [m]
        c: damping [N*s/m]
        f: force [N]
        tip: tip of the rod, beyond the slider [m]
        """

class _SliderCrankFalling(SceneType):
    def __call__(self, *, r: float = 0.5, l: float = 1.0, r_centre: float = 0.0, l_centre: float = 1.0, m1: float = 1.0, i1: float = 1.0, m2: float = 1.0, i2: float = 2.0, g: float = 9.81) -> Scene:
        """Under its weight alone.

        r: crank, from bearing to pin [m]
        l: rod, from pin to slider [m]
        r_centre: crank's centre of mass, from the bearing [m]
        l_centre: rod's centre of mass, from the pin [m]
        m1: mass of the crank [kg]
        i1: moment of inertia of the crank [kg*m^2]
        m2: mass of the rod [kg]
        i2: moment of inertia of the rod [kg*m^2]
        g: gravity, downwards [m/s^2]
        """

class _SliderCrank(Model):
    """A crank and a rod whose end is led along a straight line."""

    pushed: _SliderCrankPushed
    falling: _SliderCrankFalling

slidercrank: _SliderCrank

class _FourBarTurning(SceneType):
    def __call__(self, *, base: float = 1.0, l1: float = 1.0, l2: float = 1.0, l3: float = 1.0, m1: float = 1.0, m2: float = 1.0, m3: float = 1.0, g: float = 9.81) -> Scene:
        """Falls from upright with 1 m/s and turns on.

        base: distance of the two bearings [m]
        l1: length of the crank [m]
        l2: length of the coupler [m]
        l3: length of the rocker [m]
        m1: mass of the crank [kg]
        m2: mass of the coupler [kg]
        m3: mass of the rocker [kg]
        g: gravity, downwards [m/s^2]
        """

class _FourBarDriven(SceneType):
    def __call__(self, *, base: float = 1.0, l1: float = 1.0, l2: float = 1.0, l3: float = 1.0, m1: float = 1.0, m2: float = 1.0, m3: float = 1.0, g: float = 9.81, angle: float = 1.5707963267948966, omega: float = 0.0, swing: float = 0.5, nu: float = 3.0) -> Scene:
        """The crank is swung to and fro.

        base: distance of the two bearings [m]
        l1: length of the crank [m]
        l2: length of the coupler [m]
        l3: length of the rocker [m]
        m1: mass of the crank [kg]
        m2: mass of the coupler [kg]
        m3: mass of the rocker [kg]
        g: gravity, downwards [m/s^2]
        angle: angle at t = 0 [rad]
        omega: mean angular velocity [rad/s]
        swing: amplitude of a swing about the mean [rad]
        nu: angular frequency of the swing [rad/s]
        """

class _FourBar(Model):
    """A closed loop of three bars on a base."""

    turning: _FourBarTurning
    driven: _FourBarDriven

fourbar: _FourBar

class _AndrewsSqueeze(SceneType):
    def __call__(self, *, xa: float = -0.06934, ya: float = -0.00227, xb: float = -0.03635, yb: float = 0.03273, xc: float = 0.014, yc: float = 0.072, d: float = 0.028, da: float = 0.0115, e: float = 0.02, ea: float = 0.01421, rr: float = 0.007, ra: float = 0.00092, ss: float = 0.035, sa: float = 0.01874, sb: float = 0.01043, sc: float = 0.018, sd: float = 0.02, ta: float = 0.02308, tb: float = 0.00916, u: float = 0.04, ua: float = 0.01228, ub: float = 0.00449, zf: float = 0.02, zt: float = 0.04, fa: float = 0.01421, c0: float = 4530.0, l0: float = 0.07785, mom: float = 0.033, m1: float = 0.04325, m2: float = 0.00365, m3: float = 0.02373, m4: float = 0.00706, m5: float = 0.0705, m6: float = 0.00706, m7: float = 0.05498, i1: float = 2.194e-6, i2: float = 4.41e-7, i3: float = 5.255e-6, i4: float = 5.667e-7, i5: float = 1.169e-5, i6: float = 5.667e-7, i7: float = 1.912e-5) -> Scene:
        """From rest; the crank turns two and a half times.

        xa: point A on the ground [m]
        ya: Without a description. [m]
        xb: point B on the ground [m]
        yb: Without a description. [m]
        xc: point C on the ground, end of the spring [m]
        yc: Without a description. [m]
        d: K2, F to E [m]
        da: K2, F to its centre of mass [m]
        e: K4, E to G [m]
        ea: K4, E to its centre of mass [m]
        rr: K1, O to F [m]
        ra: K1, O to its centre of mass [m]
        ss: K3, B to E, across [m]
        sa: K3, B to its centre of mass, across [m]
        sb: K3, B to its centre of mass, along [m]
        sc: K3, B to D, across [m]
        sd: K3, B to D, along [m]
        ta: K5, A to its centre of mass, along [m]
        tb: K5, A to its centre of mass, across [m]
        u: K7, A to H [m]
        ua: K7, A to its centre of mass, along the line to H [m]
        ub: K7, A to its centre of mass, beside that line [m]
        zf: K6, E to H [m]
        zt: K5, A to G [m]
        fa: K6, E to its centre of mass [m]
        c0: stiffness of the spring [N/m]
        l0: length of the spring without force [m]
        mom: torque of the motor [N*m]
        m1: Without a description. [kg]
        m2: Without a description. [kg]
        m3: Without a description. [kg]
        m4: Without a description. [kg]
        m5: Without a description. [kg]
        m6: Without a description. [kg]
        m7: Without a description. [kg]
        i1: Without a description. [kg*m^2]
        i2: Without a description. [kg*m^2]
        i3: Without a description. [kg*m^2]
        i4: Without a description. [kg*m^2]
        i5: Without a description. [kg*m^2]
        i6: Without a description. [kg*m^2]
        i7: Without a description. [kg*m^2]
        """

class _Andrews(Model):
    """Seven bodies in three loops, driven by a steady torque."""

    squeeze: _AndrewsSqueeze

andrews: _Andrews

class _ChainSwing(SceneType):
    def __call__(self, *, n: int = 10, l: float = 1.0, m: float = 1.0, g: float = 9.81) -> Scene:
        """Released level and straight.

        l: length of a rod [m]
        m: mass of a rod [kg]
        g: gravity, downwards [m/s^2]
        """

class _ChainSettle(SceneType):
    def __call__(self, *, n: int = 10, l: float = 1.0, m: float = 1.0, g: float = 9.81, d: float = 0.1) -> Scene:
        """Released level and straight, with friction.

        l: length of a rod [m]
        m: mass of a rod [kg]
        g: gravity, downwards [m/s^2]
        d: torque at a rate of one [N*m*s]
        """

class _Chain(Model):
    """Rods in a row, hung from one end."""

    swing: _ChainSwing
    settle: _ChainSettle

chain: _Chain

class _NFourBarFall(SceneType):
    def __call__(self, *, n: int = 2, l: float = 1.0, m: float = 1.0, g: float = 9.81) -> Scene:
        """Falls over to the right, up to shortly before the cranks lie level.

        l: length of every rod [m]
        m: mass of every rod [kg]
        g: gravity, downwards [m/s^2]
        """

class _NFourBar(Model):
    """Parallelograms side by side."""

    fall: _NFourBarFall

nfourbar: _NFourBar

class _HangingNetSwing(SceneType):
    def __call__(self, *, rows: int = 3, columns: int = 3, a: float = 0.1, m: float = 0.01, inertia: float = 1e-5, g: float = 9.81, push: float = 0.5) -> Scene:
        """Swings from a push at its lower corner.

        a: side of a mesh [m]
        m: mass of a knot [kg]
        inertia: inertia of a knot [kg*m^2]
        g: gravity, downwards [m/s^2]
        push: speed with which the lower corner is pushed [m/s]
        """

class _HangingNet(Model):
    """Knots in rows and columns with rigid threads between them."""

    swing: _HangingNetSwing

hangingnet: _HangingNet
