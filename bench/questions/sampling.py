"""The sampled cart with SciPy: the commands are known, and the right-hand side looks up the one that holds."""

import numpy as np
import scipy
from scipy.integrate import solve_ivp
from scipy.linalg import expm

PERIOD, DELAY, SAMPLES = 0.1, 0.03, 20
PLANT = np.array([[0.0, 1.0, 0.0], [-20.0, -0.5, 1.0], [0.0, 0.0, 0.0]])


def exact():
    """Final state and commands."""
    before, after = expm(PLANT * DELAY), expm(PLANT * (PERIOD - DELAY))
    x, pushes = np.array([1.0, 0.0]), [0.0]
    for _ in range(SAMPLES):
        command = -4.0 * x[0] - 2.0 * x[1]
        x = (before @ np.append(x, pushes[-1]))[:2]
        x = (after @ np.append(x, command))[:2]
        pushes.append(command)
    return x, np.array(pushes)


def answers():
    end, pushes = exact()
    found = []
    for rtol in (1e-3, 1e-6, 1e-9):

        def rates(t, x):
            push = pushes[max(0, int(np.floor((t - DELAY) / PERIOD)) + 1)]
            return [x[1], push - 20.0 * x[0] - 0.5 * x[1]]

        run = solve_ivp(rates, (0.0, PERIOD * SAMPLES), [1.0, 0.0], rtol=rtol, atol=1e-3 * rtol)
        error = float(np.abs(run.y[:, -1] - end).max())
        text = f"error {error:.0e} m with {run.nfev} evaluations"
        found.append((f"SciPy {scipy.__version__}, solve_ivp, rtol {rtol:g}", error, text))
    return found
