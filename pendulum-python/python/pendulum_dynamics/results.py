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
    """An impact at a stop or a wall."""

    #: Time, in s.
    t: float
    #: State before.
    before: NDArray[np.float64]
    #: State after.
    after: NDArray[np.float64]
    #: Impulses by the names of the constraints, in N s or N m s.
    impulses: dict[str, float]


@dataclass(frozen=True, repr=False, eq=False)
class Solution:
    """A trajectory, with the names of ``scipy.integrate.solve_ivp``."""

    #: Times, of shape ``(k,)``, in s.
    t: NDArray[np.float64]
    #: States, of shape ``(n, k)``.
    y: NDArray[np.float64]
    #: States at other times: ``sol(t)`` of shape ``(n,)`` or ``(n, k)``; ``None`` if ``t_eval`` was given.
    sol: Callable[[ArrayLike], NDArray[np.float64]] | None
    #: Times of each event.
    t_events: list[NDArray[np.float64]]
    #: States at each event, each of shape ``(events, n)``.
    y_events: list[NDArray[np.float64]]
    #: Numbers of evaluations of the right-hand side, of the Jacobian, and of factorisations.
    nfev: int
    njev: int
    nlu: int
    #: -1 if the integration stopped early, 0 at the end of the span, 1 at a terminal event.
    status: int
    #: Why it ended.
    message: str
    #: True unless it stopped early.
    success: bool
    #: Last time and state that were reached.
    end: tuple[float, NDArray[np.float64]]
    #: Mode switches: time, and the constraints that stick or touch from then on.
    modes: list[tuple[float, str]]
    #: Impacts.
    impacts: list[Impact]
    #: Reasons to doubt the trajectory.
    warnings: list[str]
    #: The model.
    model: Model = field(repr=False)

    @classmethod
    def _of(cls, model: Model, native: Any, events: int, dense: bool) -> Solution:
        def sol(t: ArrayLike) -> NDArray[np.float64]:
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
        events = "".join(f"; {len(t)} times event {n}" for n, t in enumerate(self.t_events))
        impacts = f"; {len(self.impacts)} impacts" if self.impacts else ""
        t, _ = self.end
        return f"<Solution of {self.model.name} to t = {t:g}, {len(self.t)} points: {self.message}{events}{impacts}>"


@dataclass(frozen=True, eq=False)
class Animation:
    """Shapes of a mechanism at many times; a notebook shows them in motion."""

    name: str
    #: Time of each frame, in s.
    t: NDArray[np.float64]
    #: Shapes of each frame: see ``Model.shapes``.
    frames: list[list[tuple[str, str, str, NDArray[np.float64], float]]] = field(repr=False)
    #: Seconds of the motion for each second of the animation.
    speed: float

    def html(self) -> str:
        """The animation as a page without other files."""
        return f"<!doctype html><meta charset=utf-8><title>{self.name}</title>{self._repr_html_()}"

    def save(self, path: str) -> None:
        """Writes the page to a file."""
        with open(path, "w", encoding="utf-8") as file:
            file.write(self.html())

    def _repr_html_(self) -> str:
        return page(self.name, self.t, self.frames, self.speed)


@dataclass(frozen=True, eq=False)
class Ensemble:
    """States of many trajectories."""

    #: Times at which states were kept, of shape ``(k,)``.
    t: NDArray[np.float64]
    #: States of each trajectory at these times, of shape ``(m, n, k)``; NaN after a trajectory stopped.
    y: NDArray[np.float64]
    #: Final states, of shape ``(m, n)``.
    y_end: NDArray[np.float64]
    #: True for each trajectory that reached the end, of shape ``(m,)``.
    success: NDArray[np.bool_]
    #: Messages of those that stopped, by index.
    messages: dict[int, str]


@dataclass(frozen=True, eq=False)
class Equilibrium:
    """A state at which the right-hand side vanishes."""

    #: State.
    x: NDArray[np.float64]
    #: ``asymptotically stable``, ``unstable``, or ``undecided`` by the linearisation.
    stability: str
    #: Eigenvalues of the linearisation in 1/s, the fastest growing first.
    eigenvalues: NDArray[np.complex128]


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
    """A state that dry friction and contacts hold at rest."""

    #: State; its rates are zero.
    x: NDArray[np.float64]
    #: Constraints that stick or touch.
    mode: str
    #: Smallest relative reserve of any friction force: 1 without load, 0 at the limit of sticking.
    margin: float


@dataclass(frozen=True, eq=False)
class Exponents:
    """Lyapunov exponents of a trajectory."""

    #: Exponents in 1/s, the largest first.
    values: NDArray[np.float64]
    #: Standard error of each.
    uncertainty: NDArray[np.float64]

    def horizon(self, start: float, end: float) -> float:
        """Time in s for an error to grow from ``start`` to ``end``; infinite without growth."""
        largest = float(self.values[0])
        return float(np.log(end / start) / largest) if largest > 0.0 else float("inf")


@dataclass(frozen=True, eq=False)
class Sensitivity:
    """States at given times, with their derivatives."""

    #: Times, of shape ``(k,)``.
    t: NDArray[np.float64]
    #: States, of shape ``(n, k)``.
    y: NDArray[np.float64]
    #: Derivatives, of shape ``(n, v, k)``: of each component, by each variable, at each time.
    derivatives: NDArray[np.float64]
    #: Names of the variables.
    by: list[str]


@dataclass(frozen=True, repr=False, eq=False)
class Fit:
    """Result of a fit."""

    #: Model with the fitted parameters.
    model: Model
    #: Estimates of the free parameters by name.
    estimates: dict[str, float]
    #: Their standard deviations.
    deviations: dict[str, float]
    #: Their 95 % confidence intervals.
    intervals: dict[str, tuple[float, float]]
    #: Covariance of the estimates, in their order.
    covariance: NDArray[np.float64]
    #: State at the start of each window.
    starts: list[NDArray[np.float64]]
    #: Measured minus computed values: a list of output and values, for each experiment in turn.
    residuals: list[tuple[str, NDArray[np.float64]]]
    #: Standard deviations of the noise by output.
    noise: dict[str, float]
    #: Reasons to doubt the result.
    warnings: list[str]
    #: True if the search converged.
    success: bool
    #: Number of steps of the search.
    nit: int
    #: Table of the estimates, with warnings.
    summary: str

    @classmethod
    def _of(cls, model: Model, result: dict[str, Any]) -> Fit:
        estimates = result["estimates"]
        return cls(
            model=model.with_parameters(dict(zip(model.parameters, result["parameters"]))),
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
        )

    def __repr__(self) -> str:
        return self.summary
