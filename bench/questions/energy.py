"""Gymnasium's Acrobot-v1, its equations and its Runge-Kutta steps, without torque and without limits of the rates."""

import gymnasium
import numpy as np
from gymnasium.envs.classic_control.acrobot import AcrobotEnv, rk4


def energy(state):
    a, b, u, v = state
    across, along = 2.5 + np.cos(b) + 1.0, 1.25
    coupling = 1.25 + 0.5 * np.cos(b)
    kinetic = 0.5 * across * u * u + coupling * u * v + 0.5 * along * v * v
    return kinetic - 9.8 * (1.5 * np.cos(a) + 0.5 * np.cos(a + b))


def answers():
    env = AcrobotEnv()
    start = np.array([1.0, 0.0, 0.0, 0.0])
    found = []
    for step in (0.2, 0.05, 0.01):
        state, drift = start, 0.0
        for _ in range(round(100.0 / step)):
            state = rk4(env._dsdt, np.append(state, 0.0), [0.0, step])[:4]
            drift = max(drift, abs(energy(state) - energy(start)))
        drift /= energy(start) - energy(np.zeros(4))
        found.append((f"Gymnasium {gymnasium.__version__}, steps of {step} s", drift, f"the energy changes by {drift:.1e}"))
    return found
