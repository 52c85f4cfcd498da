"""Models of mechanisms."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native
from .results import (
    Ensemble,
    Equilibria,
    Equilibrium,
    Exponents,
    Fit,
    Resting,
    Sensitivity,
    Solution,
)

Event = Union[str, "tuple[str, float]", Callable[[float, NDArray[np.float64]], float]]

#: Names of the methods, and what each is for.
METHODS = {
    "Rk4": "order 4, fixed step",
    "Gauss4": "order 4, fixed step, structure-preserving; needs `canonical` in `generate`",
    "Gauss6": "order 6, fixed step, structure-preserving; needs `canonical` in `generate`",
    "Rk45": "order 5, Dormand and Prince",
    "Tsit5": "order 5, Tsitouras",
    "Vern7": "order 7, Verner",
    "Vern9": "order 9, Verner",
    "Taylor": "power series of any order; needs `taylor` in `generate`",
    "Rodas4": "order 4, stiff",
    "Rodas5P": "order 5, stiff",
    "Radau5": "order 5, stiff, implicit",
    "Auto": "explicit, and implicit while the system is stiff",
}


def _vector(what: str, values: ArrayLike) -> NDArray[np.float64]:
    """An array of one dimension for the native part, or an error that names it."""
    return _array(what, values, 1)


def _array(what: str, values: ArrayLike, dimensions: int) -> NDArray[np.float64]:
    try:
        array = np.ascontiguousarray(values, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise TypeError(f"{what} must be an array of numbers: {error}") from None
    if np.iscomplexobj(values):
        raise TypeError(f"{what} must be an array of real numbers")
    if array.ndim != dimensions:
        shape = "one dimension" if dimensions == 1 else f"{dimensions} dimensions"
        raise ValueError(f"{what} must have {shape}, not the shape {np.shape(values)}")
    return array


def _span(t_span: Sequence[float]) -> list[float]:
    span = _vector("t_span", t_span)
    if len(span) != 2:
        raise ValueError(f"t_span must have two entries, the start and the end, not {len(span)}")
    return [float(span[0]), float(span[1])]


def _number(name: str, value: Any) -> float:
    """A number, or an error that names it."""
    try:
        return float(value)
    except (TypeError, ValueError):
        raise TypeError(f"{name} must be a number, not {value!r}") from None


def _named(values: Mapping[str, float]) -> list[tuple[str, float]]:
    return [(name, _number(name, value)) for name, value in values.items()]


def _method(method: str, settings: Mapping[str, float | None]) -> tuple[str, list[tuple[str, float]]]:
    given = [(name, _number(name, value)) for name, value in settings.items() if value is not None]
    return str(method), given


class Model:
    """A mechanism with values of its parameters and inputs; it does not change.

    Parameters
    ----------
    text
        Declaration of the mechanism.
    parameters
        Values of parameters by name, in SI units. Those without a default in the declaration must be given.
    folder
        Folder to which the paths of robot files in the declaration are relative. Default: the working directory.

    Raises
    ------
    DeclarationError
        If the declaration is wrong; its ``problems`` have line, column, message and help.
    """

    def __init__(
        self,
        text: str,
        parameters: Mapping[str, float] | None = None,
        *,
        folder: str | os.PathLike[str] = "",
    ) -> None:
        self._native = _native.Model(text, os.fspath(folder), _named(parameters or {}))

    @classmethod
    def from_urdf(
        cls,
        path: str | os.PathLike[str],
        *,
        gravity: Sequence[float] = (0.0, 0.0, -9.81),
        limits: bool = False,
        repair: bool = False,
        generate: Iterable[str] | None = None,
    ) -> Model:
        """The robot of a URDF file.

        Parameters
        ----------
        path
            The file.
        gravity
            Acceleration of gravity, in m/s^2.
        limits
            Turns the limits of joints into stops.
        repair
            Replaces inertias that no body can have by the nearest possible ones; ``repaired`` lists them.
        generate
            Functions to generate. Default: ``rhs``, ``jacobian``, ``energy``, ``inverse_dynamics``, ``shapes``.
        """
        gravity = _vector("gravity", gravity)
        if len(gravity) != 3:
            raise ValueError(f"gravity must have three components, not {len(gravity)}")
        words = None if generate is None else list(generate)
        return cls._of(_native.Model.robot(os.fspath(path), list(gravity), limits, repair, words))

    @classmethod
    def _of(cls, native: Any) -> Model:
        model = cls.__new__(cls)
        model._native = native
        return model

    # What it is.

    @property
    def name(self) -> str:
        """Name of the mechanism."""
        return self._native.name

    @property
    def docs(self) -> str:
        """Comment above the declaration."""
        return self._native.docs

    @property
    def parameters(self) -> dict[str, float]:
        """Values of the parameters by name, in SI units."""
        return {name: value for name, _, value, _ in self._native.parameters()}

    @property
    def inputs(self) -> dict[str, float]:
        """Values of the inputs by name; they are zero at first, and constant in time."""
        return {name: value for name, _, value, _ in self._native.inputs()}

    @property
    def states(self) -> list[str]:
        """Names of the components of a state: coordinates, then their rates, then first-order states."""
        return [name for name, _ in self._native.components()]

    @property
    def units(self) -> dict[str, str]:
        """Units of parameters, inputs and components of the state, by name."""
        quantities = self._native.parameters() + self._native.inputs()
        return {name: unit for name, unit, *_ in [*quantities, *self._native.components()]}

    @property
    def outputs(self) -> list[str]:
        """Names of the components of all outputs."""
        return self._native.outputs()

    @property
    def events(self) -> list[str]:
        """Names of the events in the declaration."""
        return self._native.events()

    @property
    def constraints(self) -> list[str]:
        """Names of the constraints: joints with dry friction or stops, and walls."""
        return self._native.constraints()

    @property
    def functions(self) -> dict[str, str]:
        """Functions for ``evaluate``, with their comments."""
        return {name: docs for name, docs, *_ in self._native.functions()}

    @property
    def costs(self) -> dict[str, dict[str, int]]:
        """Numbers of operations of each function."""
        kinds = ["additions", "multiplications", "divisions", "sincos", "functions"]
        return {name: dict(zip(kinds, counts)) for name, _, _, _, counts in self._native.functions()}

    @property
    def repaired(self) -> list[str]:
        """Repairs that ``repair`` made to the file of a robot."""
        return self._native.repaired()

    @property
    def equations(self) -> str:
        """Equations of motion as text, in the language of declarations."""
        return self._native.equations

    @property
    def latex(self) -> str:
        """Equations of motion in LaTeX."""
        return self._native.latex

    def _repr_latex_(self) -> str:
        return f"$$\n{self.latex}\n$$"

    def __repr__(self) -> str:
        values = ", ".join(f"{name}={value:g}" for name, value in self.parameters.items())
        return f"<Model {self.name}({values}) with the states {', '.join(self.states)}>"

    # Other values.

    def with_parameters(self, values: Mapping[str, float] | None = None, **more: float) -> Model:
        """Returns the model with other values of some parameters, in microseconds."""
        return self._of(self._native.with_parameters(_named({**(values or {}), **more})))

    def with_inputs(self, values: Mapping[str, float] | None = None, **more: float) -> Model:
        """Returns the model with other values of some inputs."""
        return self._of(self._native.with_inputs(_named({**(values or {}), **more})))

    def state(self, values: Mapping[str, float] | None = None, **more: float) -> NDArray[np.float64]:
        """A state with these components by name, and zeros elsewhere: ``model.state({"dot(theta)": 1}, theta=0.4)``."""
        return self._native.state(_named({**(values or {}), **more}))

    def assemble(self, x: ArrayLike, t: float = 0.0) -> NDArray[np.float64]:
        """Closes the loops of a state in which the dependent coordinates are guesses."""
        return self._native.assemble(t, _vector("x", x))

    # Functions of time and state.

    def rhs(self, t: float, x: ArrayLike) -> NDArray[np.float64]:
        """Derivative of the state, of shape ``(n,)``."""
        return self._native.rhs(t, _vector("x", x))

    def jacobian(self, t: float, x: ArrayLike) -> NDArray[np.float64]:
        """Derivative of ``rhs`` by the state, of shape ``(n, n)``: a row for each rate."""
        return self._native.jacobian(t, _vector("x", x))

    def energy(self, t: float, x: ArrayLike) -> float:
        """Total energy, in J."""
        return sum(self._native.energy(t, _vector("x", x)))

    def kinetic(self, t: float, x: ArrayLike) -> float:
        """Kinetic energy, in J."""
        return self._native.energy(t, _vector("x", x))[0]

    def potential(self, t: float, x: ArrayLike) -> float:
        """Potential energy, in J, up to a constant."""
        return self._native.energy(t, _vector("x", x))[1]

    def output(self, t: float, x: ArrayLike) -> dict[str, float]:
        """Components of all outputs, by name."""
        return dict(zip(self.outputs, self._native.outputs_at(t, _vector("x", x)).tolist()))

    def evaluate(
        self, function: str, t: float, x: ArrayLike, *arguments: ArrayLike
    ) -> NDArray[np.float64] | tuple[NDArray[np.float64], ...]:
        """Evaluates a function of ``functions``, such as ``mass_matrix``.

        Parameters
        ----------
        arguments
            Lists that the function takes beside time and state, such as the accelerations for ``inverse_dynamics``.

        Returns
        -------
        A matrix, a vector, or a number; several of them as a tuple.
        """
        lists = [_vector(f"argument {n + 1}", own) for n, own in enumerate(arguments)]
        results = self._native.evaluate(function, t, _vector("x", x), lists)
        results = tuple(own[:, 0] if own.shape[1] == 1 else own for own in results)
        return results[0] if len(results) == 1 else results

    # Motions.

    def solve(
        self,
        t_span: Sequence[float],
        x0: ArrayLike,
        *,
        t_eval: ArrayLike | None = None,
        method: str = "Vern9",
        rtol: float | None = None,
        atol: float | None = None,
        events: Event | Iterable[Event] | None = None,
        h: float | None = None,
        first_step: float | None = None,
        min_step: float | None = None,
        max_step: float | None = None,
        max_steps: int | None = None,
    ) -> Solution:
        """Integrates from a state over a span, in the manner of ``scipy.integrate.solve_ivp``.

        Parameters
        ----------
        t_span
            Start and end, in s; the end may lie before the start.
        x0
            Initial state, of shape ``(n,)``.
        t_eval
            Times at which states are kept. Default: the ends of all steps, with states between them by ``sol``.
        method
            Name of a method: see ``METHODS``.
        rtol, atol
            Relative and absolute tolerance.
        events
            Events: names of declared ones; names of outputs or components with a value, such as ``("tip.y", 0.0)``; or
            functions ``event(t, x)`` that are zero at the event. A function may have the attributes ``terminal`` (ends
            the integration) and ``direction`` (1: only where it rises, -1: only where it falls).
        h
            Length of the steps of ``Rk4``, ``Gauss4`` and ``Gauss6``, in s.
        first_step, min_step, max_step
            Lengths of steps of the other methods, in s.
        max_steps
            Maximum number of steps.

        Returns
        -------
        Solution
            With ``success`` false if the integration stopped early, or was interrupted by Ctrl-C: it then has what was
            reached.
        """
        settings = {
            "rtol": rtol,
            "atol": atol,
            "h": h,
            "h0": first_step,
            "h_min": min_step,
            "h_max": None if max_step is not None and np.isinf(max_step) else max_step,
            "max_steps": max_steps,
        }
        if events is None:
            given: list[Event] = []
        elif isinstance(events, (str, tuple)) or callable(events):
            given = [events]
        else:
            given = list(events)
        times = None if t_eval is None else _vector("t_eval", t_eval)
        native = self._native.solve(
            _method(method, settings), _span(t_span), _vector("x0", x0), times, [_event(event) for event in given]
        )
        return Solution._of(self, native, len(given), dense=times is None)

    def ensemble(
        self,
        t_span: Sequence[float],
        x0: ArrayLike,
        *,
        parameters: Mapping[str, ArrayLike] | None = None,
        t_eval: ArrayLike = (),
        method: str = "Vern9",
        rtol: float | None = None,
        atol: float | None = None,
        h: float | None = None,
        max_step: float | None = None,
        max_steps: int | None = None,
    ) -> Ensemble:
        """Integrates many trajectories on all processors, without the lock of the interpreter.

        Each trajectory has the bits of ``solve``. ``Rk4``, ``Tsit5``, ``Vern7`` and ``Vern9`` run side by side in
        vector registers, unless the mechanism has dry friction, stops or walls.

        Parameters
        ----------
        x0
            Initial states, of shape ``(m, n)``; or one state of shape ``(n,)`` for all.
        parameters
            Values of parameters by name, each of shape ``(m,)``.
        t_eval
            Times at which states are kept. Default: none, only the final states.
        """
        starts = np.asarray(x0, dtype=np.float64)
        columns = {name: _vector(name, values) for name, values in (parameters or {}).items()}
        lengths = {len(values) for values in columns.values()}
        if starts.ndim == 1:
            count = max(lengths, default=1)
            starts = np.broadcast_to(starts, (count, len(starts)))
        starts = _array("x0", starts, 2)
        if starts.shape[1] != len(self.states):
            raise ValueError(f"x0 has states of {starts.shape[1]} components, and {len(self.states)} are needed")
        table = None
        if columns:
            own = self.parameters
            table = np.tile(list(own.values()), (len(starts), 1))
            for name, values in columns.items():
                if name not in own:
                    self.with_parameters({name: float(values[0]) if len(values) else 0.0})
                if len(values) != len(starts):
                    raise ValueError(f"{name} has {len(values)} values, and there are {len(starts)} initial states")
                table[:, list(own).index(name)] = values
        settings = {"rtol": rtol, "atol": atol, "h": h, "h_max": max_step, "max_steps": max_steps}
        times = _vector("t_eval", t_eval)
        ends, samples, stopped = self._native.ensemble(_method(method, settings), _span(t_span), starts, table, times)
        success = np.ones(len(starts), dtype=bool)
        success[[index for index, _, _ in stopped]] = False
        messages = {index: f"stopped at t = {t}: {reason}" for index, t, reason in stopped}
        return Ensemble(t=times, x=samples, x_end=ends, success=success, messages=messages)

    # Analyses.

    def equilibria(self, *seeds: ArrayLike) -> Equilibria:
        """Searches equilibria from some states; from the zero state if none is given."""
        given = [_vector("seed", seed).tolist() for seed in seeds] or [self.state().tolist()]
        found, unsearched = self._native.equilibria(given)
        equilibria = [
            Equilibrium(x=x, stability=stability, eigenvalues=np.array([complex(*value) for value in eigenvalues]))
            for x, stability, eigenvalues in found
        ]
        return Equilibria(equilibria, unsearched)

    def resting(self, seed: ArrayLike) -> Resting:
        """Finds a state near a seed that dry friction, stops and walls hold at rest."""
        return Resting(*self._native.resting(_vector("seed", seed)))

    def lyapunov(
        self,
        x0: ArrayLike,
        count: int = 1,
        *,
        duration: float = 1000.0,
        transient: float = 0.0,
        tolerance: float = 1e-8,
    ) -> Exponents:
        """The largest Lyapunov exponents of a trajectory, 1 to 4 of them, in 1/s.

        Parameters
        ----------
        duration
            Time over which growth is counted, in s.
        transient
            Time before, in s.
        tolerance
            Relative and absolute tolerance of the trajectory and its tangents.
        """
        values, uncertainty = self._native.lyapunov(_vector("x0", x0), count, duration, transient, tolerance)
        return Exponents(np.array(values), np.array(uncertainty))

    def sensitivity(
        self,
        t: ArrayLike,
        x0: ArrayLike,
        by: Sequence[str],
        *,
        method: str = "Vern9",
        rtol: float | None = None,
        atol: float | None = None,
    ) -> Sensitivity:
        """Derivatives of a trajectory by parameters and by components of its initial state, given by name.

        Parameters
        ----------
        t
            Times at which states are computed; the first is the start.
        by
            Names, such as ``["l", "theta"]``.
        method
            ``Vern9``, or ``Rodas5P`` for stiff systems.
        """
        if isinstance(by, str):
            by = [by]
        times = _vector("t", t)
        settings = _method(method, {"rtol": rtol, "atol": atol})
        x, derivatives = self._native.sensitivity(settings, times, _vector("x0", x0), list(by))
        return Sensitivity(t=times, x=x.T, derivatives=np.array(derivatives), by=list(by))

    def fit(
        self,
        t: ArrayLike | Sequence[Mapping[str, Any]],
        outputs: Mapping[str, ArrayLike] | None = None,
        *,
        free: Iterable[str] | None = None,
        noise: Mapping[str, float] | None = None,
        guess: ArrayLike | None = None,
        known: ArrayLike | None = None,
        bounds: Mapping[str, tuple[float, float]] | None = None,
        loss: str | tuple[str, float] = "squares",
        windows: float | None = None,
        separate_windows: float | None = None,
        max_iterations: int = 200,
        method: str = "Vern9",
        rtol: float | None = None,
        atol: float | None = None,
    ) -> Fit:
        """Fits parameters, and unknown initial states, to measured outputs.

        Parameters
        ----------
        t
            Times of the samples, in s; or a list of experiments, each a dict with ``t``, ``outputs`` and, if need be,
            ``noise``, ``guess`` and ``known``.
        outputs
            Measured values by the names of outputs, or of components of the state; NaN where missing.
        free
            Names of the parameters to fit. Default: all.
        noise
            Standard deviations of the noise by name, where they are known.
        guess
            First guess of the state at the first sample.
        known
            Known state at the first sample.
        bounds
            Bounds of parameters by name.
        loss
            ``"squares"``, or ``("huber", threshold)``, ``("soft_l1", threshold)``, ``("cauchy", threshold)`` against
            outliers, with the threshold in standard deviations of the noise.
        windows, separate_windows
            Splits the motion into windows of this length in s, joined in the end (multiple shooting) or not.
        method
            ``Vern9``, or ``Rodas5P`` for stiff systems.
        """
        if outputs is None:
            experiments = list(t)  # type: ignore[arg-type]
        else:
            experiments = [{"t": t, "outputs": outputs, "noise": noise, "guess": guess, "known": known}]
        options = {
            "free": None if free is None else list(free),
            "bounds": [(name, *map(float, pair)) for name, pair in (bounds or {}).items()],
            "loss": (loss, 0.0) if isinstance(loss, str) else loss,
            "windows": windows,
            "separate_windows": separate_windows,
            "max_iterations": max_iterations,
        }
        settings = _method(method, {"rtol": rtol, "atol": atol})
        result = self._native.fit(settings, [_experiment(own) for own in experiments], options)
        return Fit._of(self, result)

    def shapes(self, t: float, x: ArrayLike) -> list[tuple[str, str, str, NDArray[np.float64], float]]:
        """Shapes for drawing: name, body, kind, points of shape ``(k, 3)`` in m, and radius in m."""
        return self._native.shapes(t, _vector("x", x))


def _event(event: Event) -> tuple[Any, int, bool]:
    if isinstance(event, str):
        return event, 0, False
    if isinstance(event, tuple):
        if len(event) != 2:
            raise TypeError(f"an event is a name, a name with a value, or a function, not {event!r}")
        return (str(event[0]), _number("the value of an event", event[1])), 0, False
    if not callable(event):
        raise TypeError(f"an event is a name, a name with a value, or a function, not {event!r}")
    direction = getattr(event, "direction", 0)
    return event, int(np.sign(direction)), bool(getattr(event, "terminal", False))


def _experiment(given: Mapping[str, Any]) -> dict[str, Any]:
    unknown = set(given) - {"t", "outputs", "noise", "guess", "known"}
    if unknown or "t" not in given or "outputs" not in given:
        raise ValueError("an experiment has `t` and `outputs`, and may have `noise`, `guess` and `known`")
    times, noise = _vector("t", given["t"]), given.get("noise") or {}
    outputs = [(name, _vector(name, values), noise.get(name)) for name, values in given["outputs"].items()]
    guess, known = given.get("guess"), given.get("known")
    return {
        "t": times,
        "outputs": outputs,
        "guess": None if guess is None else _vector("guess", guess).tolist(),
        "known": None if known is None else (float(times[0]), _vector("known", known).tolist()),
    }
