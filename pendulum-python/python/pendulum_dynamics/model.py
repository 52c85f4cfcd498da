"""Models of mechanisms."""

from __future__ import annotations

import copy
import operator
import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native
from .results import (
    Animation,
    Answer,
    Choice,
    Ensemble,
    Equilibria,
    Equilibrium,
    Exponents,
    Fit,
    Interrupted,
    Resting,
    Sensitivity,
    Simpler,
    Solution,
)

What = Union[str, "tuple[str, float]", Callable[[float, NDArray[np.float64]], float]]

#: An input: a constant; or samples, as times, values and, if not linear, the interpolation between them.
Input = Union[float, "tuple[ArrayLike, ArrayLike]", "tuple[ArrayLike, ArrayLike, str]"]

Samples = tuple[NDArray[np.float64], NDArray[np.float64], str]


@dataclass(frozen=True)
class Event:
    """An event, and what it does.

    Attributes
    ----------
    what
        Name of a declared event; name of an output or component with a value, such as ``("tip.y", 0.0)``; or a
        function ``event(t, x)``, which is zero at the event. A terminal event does not end the integration at its
        start.
    terminal
        True if it ends the integration. Default: the attribute of the function, or false.
    direction
        1: only where the function, or the output, rises; -1: only where it falls. Default: the attribute of the
        function, or 0.
    """

    what: What
    terminal: bool | None = None
    direction: float | None = None


#: Message of the native part at an interrupt.
INTERRUPTED = "interrupted"

#: Names of the methods, and what each is for.
METHODS = {
    "Rk4": "order 4, fixed step",
    "Gauss4": "order 4, fixed step, structure-preserving; needs `canonical` in `generate`",
    "Gauss6": "order 6, fixed step, structure-preserving; needs `canonical` in `generate`",
    "Gauss16": "order 16, fixed step, structure-preserving; needs `canonical` in `generate`",
    "Rk45": "order 5, Dormand and Prince",
    "Tsit5": "order 5, Tsitouras",
    "Vern7": "order 7, Verner",
    "Vern9": "order 9, Verner",
    "Taylor": "power series of any order; needs `taylor` in `generate`",
    "Rodas4": "order 4, stiff; needs `jacobian` in `generate`, as it has by default",
    "Rodas5P": "order 5, stiff; needs `jacobian`",
    "Radau5": "order 5, stiff, implicit; needs `jacobian`",
    "Radau9": "order 9, stiff, implicit, tight tolerances; needs `jacobian`",
    "Radau13": "order 13, stiff, implicit, the tightest tolerances; needs `jacobian`",
    "Auto": "explicit, and implicit while the system is stiff; needs `jacobian`",
}


def _vector(what: str, values: ArrayLike) -> NDArray[np.float64]:
    """An array of one dimension for the native part, or an error that names it."""
    return _array(what, values, 1)


def _numbers(what: str, values: ArrayLike) -> NDArray[np.float64]:
    if np.ma.is_masked(values):
        raise TypeError(f"{what} must be an array of numbers, without a mask")
    try:
        array = np.asarray(values)
    except ValueError as error:
        raise TypeError(f"{what} must be an array of numbers: {error}") from None
    if array.dtype.kind not in "biuf":
        raise TypeError(f"{what} must be an array of real numbers, not {values!r:.80}")
    return array.astype(np.float64, copy=False)


def _array(what: str, values: ArrayLike, dimensions: int) -> NDArray[np.float64]:
    array = _numbers(what, values)
    if array.ndim != dimensions:
        shape = "one dimension" if dimensions == 1 else f"{dimensions} dimensions"
        raise ValueError(f"{what} must have {shape}, not the shape {array.shape}")
    return np.ascontiguousarray(array)


def _span(t_span: Sequence[float]) -> list[float]:
    span = _vector("t_span", t_span)
    if len(span) != 2:
        raise ValueError(f"t_span must have two entries, the start and the end, not {len(span)}")
    return [float(span[0]), float(span[1])]


def _number(name: str, value: Any) -> float:
    """A number, or an error that names it."""
    if isinstance(value, str):
        raise TypeError(f"{name} must be a number, not {value!r}")
    try:
        return float(value)
    except (TypeError, ValueError):
        raise TypeError(f"{name} must be a number, not {value!r}") from None


def _named(
    values: Mapping[str, float] | None, more: Mapping[str, float] = MappingProxyType({})
) -> list[tuple[str, float]]:
    if values is not None and not isinstance(values, Mapping):
        raise TypeError(f"give values by name, as a dict, not {values!r:.80}")
    return [(name, _number(name, value)) for name, value in {**(values or {}), **more}.items()]


def _samples(name: str, value: Any, dimensions: int = 1) -> Samples | None:
    """Samples of an input, or nothing of a constant."""
    if not isinstance(value, tuple):
        return None
    if len(value) not in (2, 3):
        raise ValueError(f"samples of {name} are times, values and an interpolation, not {len(value)} entries")
    times, values = _vector(f"the times of {name}", value[0]), _array(f"the values of {name}", value[1], dimensions)
    return times.copy(), values.copy(), str(value[2]) if len(value) == 3 else "linear"


def _inputs(
    inputs: Mapping[str, Input] | None, more: Mapping[str, Input] = MappingProxyType({})
) -> tuple[list[tuple[str, float]], dict[str, Samples]]:
    """Inputs that are constant, and samples of the others."""
    if inputs is not None and not isinstance(inputs, Mapping):
        raise TypeError(f"give inputs by name, as a dict, not {inputs!r:.80}")
    constants, samples = [], {}
    for name, value in {**(inputs or {}), **more}.items():
        own = _samples(name, value)
        if own is not None:
            samples[name] = own
            continue
        try:
            constants.append((name, _number(name, value)))
        except TypeError:
            raise TypeError(f"{name} must be a number, or a tuple of times and values, not {value!r:.80}") from None
    return constants, samples


def _names(what: str, names: str | Iterable[str] | None) -> list[str] | None:
    if names is None:
        return None
    own = [names] if isinstance(names, str) else list(names)
    if not all(isinstance(name, str) for name in own):
        raise TypeError(f"{what} must be names, not {own!r}")
    return own


def _method(
    method: str,
    *,
    h: float | None = None,
    rtol: float | None = None,
    atol: float | None = None,
    first_step: float | None = None,
    min_step: float | None = None,
    max_step: float | None = None,
    max_steps: int | None = None,
) -> dict[str, Any]:
    """Settings under their names in the native part."""

    def number(name: str, value: float | None) -> float | None:
        return None if value is None else _number(name, value)

    steps = None if max_steps is None else operator.index(max_steps)
    if steps is not None and steps < 1:
        raise ValueError(f"max_steps must be positive, not {steps}")
    return {
        "method": str(method),
        "h": number("h", h),
        "rtol": number("rtol", rtol),
        "atol": number("atol", atol),
        "h0": number("first_step", first_step),
        "h_min": number("min_step", min_step),
        "h_max": number("max_step", max_step),
        "max_steps": steps,
    }


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
        self._text, self._folder = text, os.fspath(folder)
        self._samples: dict[str, Samples] = {}
        self._native = _native.Model(text, self._folder, _named(parameters))

    @classmethod
    def from_urdf(
        cls,
        path: str | os.PathLike[str],
        *,
        gravity: Sequence[float] = (0.0, 0.0, -9.81),
        limits: bool = False,
        repair: bool = False,
        generate: str | Iterable[str] | None = None,
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
        own = _vector("gravity", gravity)
        if len(own) != 3 or not np.isfinite(own).all():
            raise ValueError(f"gravity must have three finite components, not {gravity!r}")
        file = os.path.abspath(path)
        with open(file, encoding="utf-8"):
            # the error of a file that cannot be opened
            pass
        words = _names("generate", generate)
        return cls(_native.Model.robot(file, own.tolist(), bool(limits), bool(repair), words))

    def _with(self, native: _native.Model) -> Model:
        model = copy.copy(self)
        model._native = native
        return model

    def __copy__(self) -> Model:
        model = type(self).__new__(type(self))
        model.__dict__.update(self.__dict__)
        return model

    def __deepcopy__(self, memo: Any) -> Model:
        return self

    def __reduce__(self) -> tuple[Any, ...]:
        return _rebuilt, (type(self), self._text, self._folder, self.parameters, self.inputs)

    @property
    def declaration(self) -> str:
        """Text of the declaration, also of a robot from a file."""
        return self._text

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
    def inputs(self) -> dict[str, float | Samples]:
        """Values of the inputs by name, zero at first; samples of those that follow some: see ``with_inputs``."""
        return {name: self._samples.get(name, value) for name, _, value, _ in self._native.inputs()}

    @property
    def states(self) -> list[str]:
        """Names of the components of a state: coordinates, then their rates, then first-order states."""
        return [name for name, _ in self._native.components()]

    @property
    def units(self) -> dict[str, str]:
        """Units of parameters, inputs and components of the state, by name."""
        quantities = self._native.parameters() + self._native.inputs()
        return {name: unit for name, unit, _, _ in quantities} | dict(self._native.components())

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
        values = [f"{name}={value:g}" for name, value in self.parameters.items()]
        for name, own in self.inputs.items():
            values.append(f"{name}={len(own[0])} samples" if isinstance(own, tuple) else f"{name}={own:g}")
        return f"<Model {self.name}({', '.join(values)}) with the states {', '.join(self.states)}>"

    # Other values.

    def with_parameters(self, values: Mapping[str, float] | None = None, /, **more: float) -> Model:
        """Returns the model with other values of some parameters, in microseconds."""
        return self._with(self._native.with_parameters(_named(values, more)))

    def with_inputs(self, values: Mapping[str, Input] | None = None, /, **more: Input) -> Model:
        """Returns the model with other values of some inputs, or with samples that they follow.

        All functions of the model, such as ``rhs``, ``solve`` and ``fit``, use the values at the time in question.

        Parameters
        ----------
        values
            By name, numbers for constants; or tuples ``(times, values)``, between which inputs are linear, such as
            ``model.with_inputs(torque=(t, measured))``. A third entry is the interpolation: ``"hold"`` keeps each value
            until the next sample, ``"cubic"`` is a natural spline, ``"linear"`` the default. Before the first sample
            and after the last one, inputs keep its value. Methods with a tolerance shorten their steps at jumps and
            kinks: where samples are dense, ``"Rk4"`` with steps ``h`` about as long as their intervals is faster.
        """
        constants, samples = _inputs(values, more)
        model = self._with(self._native.with_inputs(constants, [(name, *own) for name, own in samples.items()]))
        changed = {name for name, _ in constants}
        model._samples = {name: own for name, own in self._samples.items() if name not in changed} | samples
        return model

    def state(self, values: Mapping[str, float] | None = None, /, **more: float) -> NDArray[np.float64]:
        """A state with these components by name: ``model.state({"dot(theta)": 1}, theta=0.4)``.

        Others are zero, and orientations those of the declaration.
        """
        return self._native.state(_named(values, more))

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

    def evaluate(self, function: str, t: float, x: ArrayLike, *arguments: ArrayLike) -> Any:
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
        own = tuple(_of_dimensions(array, dimensions) for array, dimensions in results)
        return own[0] if len(own) == 1 else own

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
        events: What | Event | Iterable[What | Event] | None = None,
        h: float | None = None,
        first_step: float | None = None,
        min_step: float | None = None,
        max_step: float | None = None,
        max_steps: int | None = None,
    ) -> Solution:
        """Integrates from a state over a span, like ``scipy.integrate.solve_ivp``.

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
            Relative and absolute tolerance, each one number. Default: 1e-6 and 1e-9.
        events
            One event or several: names of declared ones; names of outputs or components with a value, such as
            ``("tip.y", 0.0)``; functions ``event(t, x)`` that are zero at the event; or an ``Event`` with one of these.
            A function may have the attributes ``terminal`` and ``direction``, as for SciPy.
        h
            Length of the steps of ``Rk4`` and the Gauss methods, in s, which have no tolerances.
        first_step, min_step, max_step
            Lengths of steps of the other methods, in s.
        max_steps
            Maximum number of steps. Default: a million.

        Returns
        -------
        Solution
            With ``success`` false if the integration stopped early: it then has what was reached, and ``message`` says
            why.

        Raises
        ------
        Interrupted
            A ``KeyboardInterrupt`` at Ctrl-C, with what was reached as its ``result``.
        """
        settings = _method(
            method,
            h=h,
            rtol=rtol,
            atol=atol,
            first_step=first_step,
            min_step=min_step,
            max_step=max_step,
            max_steps=max_steps,
        )
        if events is None:
            given: list[What | Event] = []
        elif isinstance(events, (str, Event)) or callable(events) or _is_value(events):
            given = [events]  # type: ignore[list-item]
        else:
            given = list(events)  # type: ignore[arg-type]
        times = None if t_eval is None else _vector("t_eval", t_eval)
        own = [_event(event) for event in given]
        native = self._native.solve(settings, _span(t_span), _vector("x0", x0), times, own)
        solution = Solution._of(self, native, len(given), dense=times is None)
        if solution.message == INTERRUPTED:
            raise Interrupted(solution)
        return solution

    def ensemble(
        self,
        t_span: Sequence[float],
        x0: ArrayLike,
        *,
        parameters: Mapping[str, ArrayLike] | None = None,
        inputs: Mapping[str, ArrayLike | Input] | None = None,
        t_eval: ArrayLike | None = None,
        method: str = "Vern9",
        rtol: float | None = None,
        atol: float | None = None,
        h: float | None = None,
        max_step: float | None = None,
        max_steps: int | None = None,
    ) -> Ensemble:
        """Integrates many trajectories on all processors, with the GIL released.

        Each trajectory has the bits of ``solve``. ``Rk4``, ``Tsit5``, ``Vern7`` and ``Vern9`` run side by side in
        vector registers, unless the mechanism has dry friction, stops or walls.

        Parameters
        ----------
        x0
            Initial states, of shape ``(m, n)``; or one state of shape ``(n,)`` for all.
        parameters
            Values of parameters by name, each of shape ``(m,)``, or one number for all.
        inputs
            Inputs by name, as for ``with_inputs``: one for all, or one for each trajectory, as constants of shape
            ``(m,)``, or as ``(times, values)`` with values of shape ``(m, k)`` at ``k`` times. The others are those of
            the model.
        t_eval
            Times at which states are kept. Default: none, only the final states.

        Raises
        ------
        Interrupted
            A ``KeyboardInterrupt`` at Ctrl-C, with what was reached as its ``result``.
        """
        starts = _numbers("x0", x0)
        columns = {name: _numbers(name, values) for name, values in (parameters or {}).items()}
        shared, of_each = _of_each(inputs or {})
        if starts.ndim == 1:
            counts = [len(values) for values in columns.values() if values.ndim]
            count = max(counts + [len(values) for _, values, _ in of_each.values()], default=1)
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
                    # the error that names the most similar one
                    self.with_parameters({name: 1.0})
                if values.shape not in ((), (len(starts),)):
                    raise ValueError(f"{name} has the shape {values.shape}, and there are {len(starts)} initial states")
                table[:, list(own).index(name)] = values
        for name, (_, values, _) in of_each.items():
            if len(values) != len(starts):
                raise ValueError(f"{name} has {len(values)} rows of values, and there are {len(starts)} initial states")
        settings = _method(method, h=h, rtol=rtol, atol=atol, max_step=max_step, max_steps=max_steps)
        times = _vector("t_eval", np.empty(0) if t_eval is None else t_eval)
        own_inputs = [(name, *samples) for name, samples in of_each.items()]
        native = self.with_inputs(shared)._native
        ends, samples, stopped = native.ensemble(settings, _span(t_span), starts, table, own_inputs, times)
        success = np.ones(len(starts), dtype=bool)
        success[[index for index, _, _ in stopped]] = False
        messages = {index: f"stopped at t = {t}: {reason}" for index, t, reason in stopped}
        ensemble = Ensemble(t=times, y=samples.transpose(0, 2, 1), y_end=ends, success=success, messages=messages)
        if any(reason == INTERRUPTED for _, _, reason in stopped):
            raise Interrupted(ensemble)
        return ensemble

    # Analyses.

    def equilibria(self, *seeds: ArrayLike) -> Equilibria:
        """Searches for equilibria from some states; from the zero state if none is given."""
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
        by: str | Iterable[str],
        *,
        method: str = "Vern9",
        rtol: float | None = None,
        atol: float | None = None,
        h: float | None = None,
    ) -> Sensitivity:
        """Derivatives of a trajectory by parameters and by components of its initial state, given by name.

        Parameters
        ----------
        t
            Times at which states are computed; the first is the start.
        by
            Names, such as ``["l", "theta"]``.
        method
            ``Vern9``; ``Rodas5P`` for stiff systems; or ``Rk4`` with steps ``h``, for inputs with dense samples.
        """
        names = _names("by", by) or []
        times = _vector("t", t)
        settings = _method(method, h=h, rtol=rtol, atol=atol)
        x, derivatives = self._native.sensitivity(settings, times, _vector("x0", x0), names)
        return Sensitivity(t=times, y=x.T, derivatives=np.array(derivatives).transpose(1, 2, 0), by=names)

    def tune(self, t_span: Sequence[float], x0: ArrayLike, error: float, *, scale: float = 1.0) -> list[Choice]:
        """The methods and settings that keep within an error at the end of a span, the fastest first.

        ``model.solve(t_span, x0, **choices[0].settings)`` integrates by the fastest one. Pilot runs measure errors and
        times, as long as some thousand trajectories; those of two methods with tolerances far below the error tell the
        true end. Methods take part for which ``generate`` has the functions: ``jacobian``, ``taylor``, ``canonical``.

        Parameters
        ----------
        x0
            Initial states, of shape ``(m, n)``, or one of shape ``(n,)``; of many, sixteen are tried.
        error
            Largest error of a component at the end, relative to the larger of its size and ``scale``.
        scale
            Size of a component, in its unit, below which errors are relative to this size.

        Raises
        ------
        ValueError
            If no method reaches the error, for example where a motion is chaotic.
        """
        starts = np.atleast_2d(_numbers("x0", x0))
        found = self._native.tune(_span(t_span), starts.tolist(), float(error), float(scale))
        return [
            Choice(method, rtol, atol, h, reached, nfev, time) for method, (rtol, atol, h), reached, nfev, time in found
        ]

    def simplest(
        self,
        horizon: float,
        x0: ArrayLike,
        error: float = 0.01,
        *,
        outputs: str | Iterable[str] | None = None,
    ) -> Answer:
        """The simplest declaration whose motions keep within an error.

        Tries a linear model about the equilibrium nearest to each start, the removal of each friction, each joint fixed
        where it starts, each spring of a joint rigid, and all pairs of these. The error of each is predicted before it
        runs. Balls, free joints and springs between points are left as they are.

        Parameters
        ----------
        horizon
            Time up to which motions are followed, in s.
        x0
            Initial states, of shape ``(m, n)``, or one of shape ``(n,)``.
        error
            Largest error of each output, at 200 times between 0 and the horizon, relative to its largest size in all
            motions.
        outputs
            Outputs and components of the state that matter, such as ``tip.y``, or ``tip`` for all components of a
            point. Default: all outputs, or all components if there are none.
        """
        starts = _array("x0", np.atleast_2d(_numbers("x0", x0)), 2).tolist()
        asked = (_number("horizon", horizon), _number("error", error))
        own = self._native.simplest(self._text, self._folder, asked, starts, _names("outputs", outputs) or [])
        names, rows, refused, chosen, table = own
        simpler = [
            Simpler(changes, text, dict(zip(names, predicted)), dict(zip(names, observed)), operations, total)
            for changes, text, predicted, observed, operations, total in rows
        ]
        return Answer(None if chosen is None else simpler[chosen], simpler, refused, table)

    def fit(
        self,
        t: ArrayLike | Sequence[Mapping[str, Any]],
        outputs: Mapping[str, ArrayLike] | None = None,
        *,
        free: str | Iterable[str] | None = None,
        noise: Mapping[str, float] | None = None,
        guess: ArrayLike | None = None,
        known: ArrayLike | None = None,
        inputs: Mapping[str, Input] | None = None,
        bounds: Mapping[str, tuple[float, float]] | None = None,
        loss: str | tuple[str, float] = "squares",
        windows: float | None = None,
        separate_windows: float | None = None,
        max_iterations: int = 200,
        method: str = "Vern9",
        rtol: float | None = None,
        atol: float | None = None,
        h: float | None = None,
    ) -> Fit:
        """Fits parameters, and unknown initial states, to measured outputs.

        Parameters
        ----------
        t
            Times of the samples, in s; or a list of experiments, each a dict with ``t``, ``outputs`` and, if need be,
            ``noise``, ``guess``, ``known`` and ``inputs``.
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
        inputs
            Inputs during the measurement by name, as for ``with_inputs``, such as ``{"torque": (t, measured)}``. Their
            samples cover the measurement. Where some are given, all are, in each experiment: 0 if nothing acts.
        bounds
            Bounds of parameters by name.
        loss
            ``"squares"``, or ``("huber", threshold)``, ``("soft_l1", threshold)``, ``("cauchy", threshold)`` against
            outliers, with the threshold in standard deviations of the noise.
        windows, separate_windows
            Splits the motion into windows of this length in s: ``windows`` are joined in the end (multiple shooting),
            for long or chaotic motions; ``separate_windows`` are not, for motions with disturbances. One at most.
        method
            ``Vern9``; ``Rodas5P`` for stiff systems; or ``Rk4`` with steps ``h``, for inputs with dense samples.
        """
        own = {"noise": noise, "guess": guess, "known": known, "inputs": inputs}
        if outputs is None:
            if any(value is not None for value in own.values()):
                raise ValueError("of several experiments, each has its own `noise`, `guess`, `known` and `inputs`")
            experiments: list[Any] = list(t)  # type: ignore[arg-type]
        else:
            experiments = [{"t": t, "outputs": outputs, **own}]
        options = {
            "free": _names("free", free),
            "bounds": [_bounds(name, pair) for name, pair in (bounds or {}).items()],
            "loss": _loss(loss),
            "windows": None if windows is None else _number("windows", windows),
            "separate_windows": None if separate_windows is None else _number("separate_windows", separate_windows),
            "max_iterations": operator.index(max_iterations),
        }
        settings = _method(method, h=h, rtol=rtol, atol=atol)
        result = self._native.fit(settings, [_experiment(given) for given in experiments], options)
        return Fit._of(self, result)

    def shapes(self, t: float, x: ArrayLike) -> list[tuple[str, str, str, NDArray[np.float64], float]]:
        """Shapes for drawing: name, body, kind, points of shape ``(k, 3)`` in m, and radius in m."""
        return self._native.shapes(t, _vector("x", x))

    def draw(self, x: ArrayLike | None = None, t: float = 0.0) -> Animation:
        """A picture of the mechanism in a state, by default the zero state, for a notebook."""
        return Animation(self.name, np.array([t]), [self.shapes(t, self.state() if x is None else x)], 1.0)


def _rebuilt(
    kind: type[Model], text: str, folder: str, parameters: dict[str, float], inputs: dict[str, Input]
) -> Model:
    """A model from its pickle."""
    model = kind(text, parameters, folder=folder)
    return model.with_inputs(inputs) if inputs else model


def _of_dimensions(array: NDArray[np.float64], dimensions: int) -> Any:
    if dimensions == 0:
        return float(array[0, 0])
    return array[:, 0] if dimensions == 1 else array


def _held(value: float | NDArray[np.float64]) -> Samples:
    """Samples of an input that is constant, or of one for each trajectory."""
    return np.zeros(1), np.asarray(value)[..., np.newaxis], "hold"


def _of_each(inputs: Mapping[str, Any]) -> tuple[dict[str, Input], dict[str, Samples]]:
    """Inputs that all trajectories share, and those of each trajectory, with a row of values for each."""
    shared: dict[str, Input] = {}
    of_each: dict[str, Samples] = {}
    for name, value in inputs.items():
        if isinstance(value, tuple) and len(value) > 1 and np.ndim(value[1]) == 2:
            of_each[name] = _samples(name, value, 2)  # type: ignore[assignment]
        elif isinstance(value, tuple) or np.ndim(value) == 0:
            shared[name] = value
        else:
            of_each[name] = _held(_vector(name, value))
    return shared, of_each


def _is_value(event: Any) -> bool:
    """True for a name with a value."""
    return isinstance(event, tuple) and len(event) == 2 and isinstance(event[0], str) and np.isscalar(event[1])


def _event(event: What | Event) -> tuple[Any, int, bool]:
    own = event if isinstance(event, Event) else Event(event)
    what = own.what
    terminal = getattr(what, "terminal", False) if own.terminal is None else own.terminal
    way = getattr(what, "direction", 0) if own.direction is None else own.direction
    direction = np.nan_to_num(_number("the direction of an event", way))
    if terminal > 1:
        raise ValueError("an event ends the integration where it first occurs: terminal is true or false, not a count")
    if _is_value(what):
        name, value = what  # type: ignore[misc, str-unpack]
        return (name, _number("the value of an event", value)), int(np.sign(direction)), bool(terminal)
    if not isinstance(what, str) and not callable(what):
        raise TypeError(f"an event is a name, a name with a value, or a function, not {what!r}")
    return what, int(np.sign(direction)), bool(terminal)


def _bounds(name: str, pair: tuple[float, float]) -> tuple[str, float, float]:
    if np.shape(pair) != (2,):
        raise ValueError(f"the bounds of {name} are two numbers, which may be infinite, not {pair!r}")
    return name, _number("a bound", pair[0]), _number("a bound", pair[1])


def _loss(loss: str | tuple[str, float]) -> tuple[str, float]:
    name, threshold = (loss, None) if isinstance(loss, str) else loss
    if threshold is None and name != "squares":
        raise ValueError(f'give the threshold of the loss, in standard deviations of the noise: ("{name}", 1.5)')
    return str(name), 0.0 if threshold is None else _number("the threshold of the loss", threshold)


def _experiment(given: Mapping[str, Any]) -> dict[str, Any]:
    if not isinstance(given, Mapping):
        raise TypeError(f"give `outputs`, or a list of experiments, each a dict, not {given!r}")
    unknown = set(given) - {"t", "outputs", "noise", "guess", "known", "inputs"}
    if unknown or "t" not in given or "outputs" not in given:
        raise ValueError("an experiment has `t` and `outputs`, and may have `noise`, `guess`, `known` and `inputs`")
    times, noise = _vector("t", given["t"]), given.get("noise") or {}
    if strange := set(noise) - set(given["outputs"]):
        raise ValueError(f"`noise` names {', '.join(sorted(strange))}, which is not among the outputs")
    outputs = [(name, _vector(name, values), noise.get(name)) for name, values in given["outputs"].items()]
    guess, known = given.get("guess"), given.get("known")
    if guess is not None and known is not None:
        raise ValueError("the state at the first sample is either known, or guessed")
    begin = float(times[0]) if len(times) else 0.0
    constants, samples = _inputs(given.get("inputs"))
    held = {name: _held(value) for name, value in constants}
    return {
        "t": times,
        "outputs": outputs,
        "guess": None if guess is None else _vector("guess", guess).tolist(),
        "known": None if known is None else (begin, _vector("known", known).tolist()),
        "inputs": [(name, *own) for name, own in {**samples, **held}.items()],
    }
