"""Equations of motion, integration, stability and fits of pendulums and other mechanisms.

A mechanism is declared in a text, or read from a URDF file::

    from pendulum_dynamics import Model

    model = Model('''
    pub Pendulum {
        params { l: m = 0.5 }
        gravity: [0, -9.81, 0],
        body bob on ground { mass: 1, com: [0, -l, 0], joint: revolute(z), coordinate: theta }
    }
    ''')
    solution = model.solve((0, 10), model.state(theta=0.4), rtol=1e-10, atol=1e-10)

Numbers are in SI units, and angles in rad. States are arrays with the components of ``model.states``.
"""

from ._native import DeclarationError
from .model import METHODS, Event, Model
from .results import (
    Animation,
    Answer,
    Choice,
    Ensemble,
    Equilibria,
    Equilibrium,
    Exponents,
    Fit,
    Impact,
    Interrupted,
    Resting,
    Sensitivity,
    Simpler,
    Solution,
)

__version__ = "0.1.0"

__all__ = [
    "METHODS",
    "Animation",
    "Answer",
    "Choice",
    "DeclarationError",
    "Ensemble",
    "Equilibria",
    "Equilibrium",
    "Event",
    "Exponents",
    "Fit",
    "Impact",
    "Interrupted",
    "Model",
    "Resting",
    "Sensitivity",
    "Simpler",
    "Solution",
]
