"""Results."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .drawing import page

if TYPE_CHECKING:
    from .model import Model


@dataclass(frozen=True, eq=False)
class Impact:
    """An impact at a stop or a wall.

    Attributes
    ----------
    t
        Time, in s.
    before
        State before.
    after
        State after.
    impulses
        Impulses by the names of the constraints, in N s or N m s.
    """

    t: float
    before: NDArray[np.float64]
    after: NDArray[np.float64]
    impulses: dict[str, float]


@dataclass(frozen=True, repr=False, eq=False)
class Solution:
    """A trajectory, with the names of ``scipy.integrate.solve_ivp``.

    Attributes
    ----------
    t
        Times, of shape ``(k,)``, in s.
    y
        States, of shape ``(n, k)``.
    sol
        States at other times: ``sol(t)`` of shape ``(n,)`` or ``(n, k)``; ``None`` if ``t_eval`` was given.
    t_events
        Times of each event.
    y_events
        States at each event, each of shape ``(events, n)``.
    nfev, njev, nlu
        Numbers of evaluations of the right-hand side, of the Jacobian, and of factorisations.
    status
        -1 if the integration stopped early, 0 at the end of the span, 1 at a terminal event.
    message
        Why it ended.
    success
        True unless it stopped early.
    end
        Last time and state that were reached.
    modes
        Mode switches: time, and the constraints that stick or touch from then on.
    impacts
        Impacts.
    warnings
        Reasons to doubt the trajectory.
    model
        The model.
    """

    t: NDArray[np.float64]
    y: NDArray[np.float64]
    sol: Callable[[ArrayLike], NDArray[np.float64]] | None
    t_events: list[NDArray[np.float64]]
    y_events: list[NDArray[np.float64]]
    nfev: int
    njev: int
    nlu: int
    status: int
    message: str
    success: bool
    end: tuple[float, NDArray[np.float64]]
    modes: list[tuple[float, str]]
    impacts: list[Impact]
    warnings: list[str]
    model: Model = field(repr=False)

    @classmethod
    def _of(cls, model: Model, native: Any, events: int, dense: bool) -> Solution:
        def sol(t: ArrayLike) -> NDArray[np.float64]:
            if t is None:
                raise TypeError("t must be a number, or an array of numbers")
            times = np.asarray(t, dtype=np.float64)
            if times.ndim > 1:
                raise ValueError(f"t must be a number or have one dimension, not the shape {times.shape}")
            states: NDArray[np.float64] = native.at(np.ascontiguousarray(np.atleast_1d(times))).T
            return states if times.ndim else states[:, 0]

        of_events = [native.event(index) for index in range(events)]
        evaluations, jacobians, factorizations, _, _ = native.statistics()
        return cls(
            t=native.t(),
            y=native.x().T,
            sol=sol if dense else None,
            t_events=[t for t, _ in of_events],
            y_events=[x for _, x in of_events],
            nfev=evaluations,
            njev=jacobians,
            nlu=factorizations,
            status=native.status,
            message=native.message,
            success=native.status >= 0,
            end=native.end(),
            modes=native.modes(),
            impacts=[Impact(*impact) for impact in native.impacts()],
            warnings=native.warnings(),
            model=model,
        )

    def __getstate__(self) -> dict[str, Any]:
        # states between the points stay behind
        return {**self.__dict__, "sol": None}

    def outputs(self) -> dict[str, NDArray[np.float64]]:
        """Outputs along the trajectory, by name, each of shape ``(k,)``."""
        values = [list(self.model.output(t, x).values()) for t, x in zip(self.t, self.y.T)]
        table = np.array(values).reshape(len(self.t), len(self.model.outputs))
        return {name: table[:, n] for n, name in enumerate(self.model.outputs)}

    def energy(self) -> NDArray[np.float64]:
        """Total energy along the trajectory, of shape ``(k,)``, in J."""
        return np.array([self.model.energy(t, x) for t, x in zip(self.t, self.y.T)])

    def animate(self, speed: float = 1.0, rate: float = 30.0) -> Animation:
        """The motion as an animation for a notebook; the declaration must have ``shapes`` in ``generate``.

        Parameters
        ----------
        speed
            Seconds of the motion for each second of the animation.
        rate
            Frames per second.
        """
        if not (speed > 0.0 and rate > 0.0):
            raise ValueError("speed and rate must be positive")
        if self.sol is None:
            times, states = self.t, self.y.T
        else:
            count = int(abs(self.t[-1] - self.t[0]) / speed * rate) + 1
            times = np.linspace(self.t[0], self.t[-1], min(count, 3000))
            states = self.sol(times).T
        frames = [self.model.shapes(t, np.ascontiguousarray(x)) for t, x in zip(times, states)]
        return Animation(self.model.name, times, frames, speed)

    def _repr_html_(self) -> str:
        try:
            return self.animate()._repr_html_()
        except ValueError:
            # without shapes
            return f"<pre>{self!r}</pre>"

    def __repr__(self) -> str:
        count = sum(len(t) for t in self.t_events)
        events = f"; {count} events" if count else ""
        impacts = f"; {len(self.impacts)} impacts" if self.impacts else ""
        t, _ = self.end
        return f"<Solution of {self.model.name} to t = {t:g}, {len(self.t)} points: {self.message}{events}{impacts}>"


@dataclass(frozen=True, repr=False, eq=False)
class Animation:
    """Shapes of a mechanism at many times; a notebook shows them in motion.

    Attributes
    ----------
    name
        Name of the mechanism.
    t
        Time of each frame, in s.
    frames
        Shapes of each frame: see ``Model.shapes``.
    speed
        Seconds of the motion for each second of the animation.
    """

    name: str
    t: NDArray[np.float64]
    frames: list[list[tuple[str, str, str, NDArray[np.float64], float]]] = field(repr=False)
    speed: float

    def __repr__(self) -> str:
        return f"<Animation of {self.name}, {len(self.t)} frames>"

    def html(self) -> str:
        """The animation as a page without other files."""
        return f"<!doctype html><meta charset=utf-8><title>{self.name}</title>{self._repr_html_()}"

    def save(self, path: str) -> None:
        """Writes the page to a file."""
        with open(path, "w", encoding="utf-8") as file:
            file.write(self.html())

    def _repr_html_(self) -> str:
        return page(self.name, self.t, self.frames, self.speed)


@dataclass(frozen=True, repr=False, eq=False)
class Ensemble:
    """States of many trajectories.

    Attributes
    ----------
    t
        Times at which states were kept, of shape ``(k,)``.
    y
        States of each trajectory at these times, of shape ``(m, n, k)``; NaN after a trajectory stopped.
    y_end
        Final states, of shape ``(m, n)``.
    success
        True for each trajectory that reached the end, of shape ``(m,)``.
    messages
        Messages of those that stopped, by index.
    """

    t: NDArray[np.float64]
    y: NDArray[np.float64]
    y_end: NDArray[np.float64]
    success: NDArray[np.bool_]
    messages: dict[int, str]

    def __repr__(self) -> str:
        return f"<Ensemble of {len(self.success)} trajectories, {int(self.success.sum())} of which reached the end>"


@dataclass(frozen=True, eq=False)
class Equilibrium:
    """A state at which the right-hand side vanishes.

    Attributes
    ----------
    x
        State.
    stability
        ``asymptotically stable``, ``unstable``, or ``undecided`` by the linearisation.
    eigenvalues
        Eigenvalues of the linearisation in 1/s, the fastest growing first.
    """

    x: NDArray[np.float64]
    stability: str
    eigenvalues: NDArray[np.complex128]


@dataclass(frozen=True)
class Choice:
    """A method with the settings by which it keeps within an error.

    Attributes
    ----------
    method
        Name of the method.
    rtol, atol
        Tolerances; ``None`` for a method with fixed steps.
    h
        Length of fixed steps, in s; ``None`` for a method with tolerances.
    error
        Largest relative error at the end of the pilot runs.
    nfev
        Number of evaluations of the right-hand side for a trajectory, on average.
    time
        Time for a trajectory, on average, in s.
    """

    method: str
    rtol: float | None
    atol: float | None
    h: float | None
    error: float
    nfev: float
    time: float

    @property
    def settings(self) -> dict[str, Any]:
        """Arguments of ``Model.solve`` and ``Model.ensemble``."""
        return {"method": self.method, "rtol": self.rtol, "atol": self.atol, "h": self.h}


@dataclass(frozen=True)
class Simpler:
    """A simpler declaration, with its errors.

    Attributes
    ----------
    changes
        Changes of the declaration, one or two.
    declaration
        The simpler declaration. The values of the model's parameters are its defaults; inputs stay inputs. A parameter
        that fixes a joint is where the joint is at the first start. A linear model has states such as ``theta_rate``,
        outputs such as ``end_x`` and the inputs that act to first order, about the values of the model's; it has
        neither dry friction, stops nor walls.
    predicted
        Errors by output that are predicted before the model runs, to first order in the change; infinite if they could
        not be computed.
    observed
        Errors by output of its motions.
    operations
        Operations of an evaluation of the right-hand side.
    total
        Operations for a motion, on average.
    """

    changes: list[str]
    declaration: str
    predicted: dict[str, float]
    observed: dict[str, float]
    operations: int
    total: float


@dataclass(frozen=True, repr=False)
class Answer:
    """Simpler models for a question; printed, it is a table.

    Attributes
    ----------
    simplest
        The cheapest model that keeps within the error and costs less than the full one; ``None`` if the full one is
        the simplest.
    simpler
        All simpler models, the cheapest first.
    refused
        Changes that lead to no model, each with the reason.
    """

    simplest: Simpler | None
    simpler: list[Simpler]
    refused: list[tuple[list[str], str]]
    table: str

    def __repr__(self) -> str:
        return self.table


class Interrupted(KeyboardInterrupt):
    """Ctrl-C during an integration.

    Attributes
    ----------
    result
        Solution or Ensemble with what was reached.
    """

    def __init__(self, result: Solution | Ensemble) -> None:
        super().__init__("interrupted; the attribute `result` has what was reached")
        self.result = result


class Equilibria(Sequence[Equilibrium]):
    """Equilibria, and the coordinates that were not searched completely."""

    def __init__(self, found: list[Equilibrium], unsearched: list[str]) -> None:
        self._found = found
        #: Coordinates whose range was not searched completely.
        self.unsearched = unsearched

    def __getitem__(self, index: Any) -> Any:
        return self._found[index]

    def __len__(self) -> int:
        return len(self._found)

    def __iter__(self) -> Iterator[Equilibrium]:
        return iter(self._found)

    def __repr__(self) -> str:
        lines = [f"{own.x}: {own.stability}" for own in self._found]
        more = [f"not searched completely: {', '.join(self.unsearched)}"] if self.unsearched else []
        return "\n".join(lines + more)


@dataclass(frozen=True, eq=False)
class Resting:
    """A state that dry friction and contacts hold at rest.

    Attributes
    ----------
    x
        State; its rates are zero.
    mode
        Constraints that stick or touch.
    margin
        Smallest relative reserve of any friction force: 1 without load, 0 at the limit of sticking.
    """

    x: NDArray[np.float64]
    mode: str
    margin: float


@dataclass(frozen=True, eq=False)
class Exponents:
    """Lyapunov exponents of a trajectory.

    Attributes
    ----------
    values
        Exponents in 1/s, the largest first.
    uncertainty
        Standard error of each.
    """

    values: NDArray[np.float64]
    uncertainty: NDArray[np.float64]

    def horizon(self, start: float, end: float) -> float:
        """Time in s for an error to grow from ``start`` to ``end``; infinite without growth."""
        largest = float(self.values[0])
        return float(np.log(end / start) / largest) if largest > 0.0 else float("inf")


@dataclass(frozen=True, eq=False)
class Sensitivity:
    """States at given times, with their derivatives.

    Attributes
    ----------
    t
        Times, of shape ``(k,)``.
    y
        States, of shape ``(n, k)``.
    derivatives
        Derivatives, of shape ``(n, v, k)``: of each component, by each variable, at each time.
    by
        Names of the variables.
    """

    t: NDArray[np.float64]
    y: NDArray[np.float64]
    derivatives: NDArray[np.float64]
    by: list[str]


@dataclass(frozen=True, repr=False, eq=False)
class Fit:
    """Result of a fit.

    Attributes
    ----------
    parameters
        Values of all parameters by name; those that are not free are the model's.
    estimates, deviations, intervals
        Values of the free parameters by name, their standard deviations, and intervals that hold them with 95 %.
    covariance
        Covariance of the estimates, of shape ``(p, p)``.
    starts
        States at the start of each window.
    residuals
        Measured minus computed values of each output of each experiment.
    noise
        Standard deviations of the noise by output.
    warnings
        Reasons to doubt the result.
    success
        True if the search converged.
    nit
        Number of steps of the search.
    summary
        Table of the estimates, with warnings.
    """

    parameters: dict[str, float]
    estimates: dict[str, float]
    deviations: dict[str, float]
    intervals: dict[str, tuple[float, float]]
    covariance: NDArray[np.float64]
    starts: list[NDArray[np.float64]]
    residuals: list[tuple[str, NDArray[np.float64]]]
    noise: dict[str, float]
    warnings: list[str]
    success: bool
    nit: int
    summary: str
    _model: Model

    @classmethod
    def _of(cls, model: Model, result: dict[str, Any]) -> Fit:
        estimates = result["estimates"]
        return cls(
            parameters=dict(zip(model.parameters, result["parameters"])),
            estimates={name: value for name, value, _, _ in estimates},
            deviations={name: deviation for name, _, deviation, _ in estimates},
            intervals={name: tuple(interval) for name, _, _, interval in estimates},
            covariance=result["covariance"],
            starts=[np.array(start) for start in result["starts"]],
            residuals=[(name, np.array(values)) for name, values in result["residuals"]],
            noise=dict(result["noise"]),
            warnings=result["warnings"],
            success=result["converged"],
            nit=result["iterations"],
            summary=result["summary"],
            _model=model,
        )

    @property
    def model(self) -> Model:
        """The model with the fitted parameters; an error if no body can have them, of which a warning tells."""
        return self._model.with_parameters(self.parameters)

    def __repr__(self) -> str:
        return self.summary
