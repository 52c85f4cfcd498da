"""The ball with SciPy: an event ends the flight, and the next one starts with half the rate, as in its documentation.

Of the rebounds 1000 are followed.
"""

import numpy as np
import scipy
from scipy.integrate import solve_ivp


def floor(_t, x):
    return x[1] + 1.0


floor.terminal, floor.direction = True, -1


def answers():
    t, x, impacts = 0.0, np.array([0.0, 0.0, 1.0, 1.0]), 0
    while t < 2.0 and impacts < 1_000:
        flight = solve_ivp(lambda t, x: [x[2], x[3], 0.0, -9.8], (t, 2.0), x, events=floor, rtol=1e-9, atol=1e-12)
        t, x = flight.t[-1], flight.y[:, -1].copy()
        if flight.status != 1:
            break
        x[3] *= -0.5
        impacts += 1
    below = max(0.0, -1.0 - x[1])
    text = f"at {t:.9f} s after {impacts} rebounds, {below:.2g} m below the floor"
    return [(f"SciPy {scipy.__version__}, solve_ivp with an event", t, text)]
