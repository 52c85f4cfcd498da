"""The double pendulum of dysts: its tabulated exponents, and how far its equations are from Hamilton's."""

from importlib.metadata import version

import numpy as np
from dysts.flows import DoublePendulum


def hamiltonian(x):
    a, b, p, q = x
    kinetic = (p * p + 2 * q * q - 2 * p * q * np.cos(a - b)) / (2 * (1 + np.sin(a - b) ** 2))
    return kinetic - 9.81 * (2 * np.cos(a) + np.cos(b))


def answers():
    system = DoublePendulum()
    values = system.lyapunov_spectrum_estimated
    start, h = np.array(system.ic), 1e-6
    slope = np.array([(hamiltonian(start + h * e) - hamiltonian(start - h * e)) / (2 * h) for e in np.eye(4)])
    power = float(slope @ np.array(system.rhs(start, 0.0)))
    unpaired = max(abs(values[0] + values[3]), abs(values[1] + values[2]))
    listed = ", ".join(f"{value:.2f}" for value in values)
    text = f"lists {listed} 1/s; its equations change the energy by {power:.2f} W at their start"
    return [(f"dysts {version('dysts')}", unpaired, text)]
