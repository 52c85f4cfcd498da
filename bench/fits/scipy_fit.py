"""Fit of the measured double pendulum as in `examples/measured`, viscous friction and encoders that are not aligned, by
SciPy's `least_squares` and `solve_ivp`. The states at the starts of the windows are unknowns; their derivatives are
differences of all windows at once, so that a Jacobian takes 12 evaluations of the residuals.

Usage: python3 scipy_fit.py ../../examples/measured/data/run_1.csv"""

import sys
import time

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import least_squares

data = np.genfromtxt(sys.argv[1], delimiter=",", names=True)
t = data["time_s"]
q = np.stack([data["q1_rad"], data["q2_rad"]], 1)
tau = [data["tau1_Nm"], data["tau2_Nm"]]
M1, M2, L, G = 0.559, 0.604, 0.3, 9.81
PARAMETERS = ["i1", "i2", "r1", "r2", "viscous1", "viscous2", "zero1", "zero2"]
START = np.array([0.0535, 0.0239, 0.3, 0.184, 0.001, 0.001, 0.0, 0.0])
SIZES = np.array([0.05, 0.02, 0.3, 0.2, 0.02, 0.01, 0.02, 0.02])
K = len(PARAMETERS)

# windows of equal length, at most 0.5 s
count = int(np.ceil((t[-1] - t[0]) / 0.5))
bounds = np.searchsorted(t, t[0] + (t[-1] - t[0]) * np.arange(count + 1) / count)
bounds[-1] = len(t)
windows = [slice(a, b) for a, b in zip(bounds[:-1], bounds[1:])]


def rhs(time, x, p):
    i1, i2, r1, r2, d1, d2 = p[:6]
    q1, q2, v1, v2 = x
    c, s = np.cos(q2), np.sin(q2)
    h = M2 * L * r2
    m11 = i1 + i2 + M2 * L * L + 2 * h * c
    m12 = i2 + h * c
    lower = M2 * r2 * G * np.sin(q1 + q2)
    f1 = np.interp(time, t, tau[0]) - d1 * v1 - (M1 * r1 + M2 * L) * G * np.sin(q1) - lower + h * s * v2 * (2 * v1 + v2)
    f2 = np.interp(time, t, tau[1]) - d2 * v2 - lower - h * s * v1 * v1
    det = m11 * i2 - m12 * m12
    return [v1, v2, (i2 * f1 - m12 * f2) / det, (m11 * f2 - m12 * f1) / det]


def residuals(x):
    p, starts = x[:K], x[K:].reshape(-1, 4)
    parts = []
    for window, start in zip(windows, starts):
        times = t[window]
        solution = solve_ivp(rhs, (times[0], times[-1]), start, t_eval=times, rtol=1e-6, atol=1e-8, args=(p,))
        parts.append((solution.y[:2].T - p[6:8] - q[window]).ravel())
    return np.concatenate(parts)


def jacobian(x, step=3e-3):
    at = residuals(x)
    rows = np.zeros((len(at), len(x)))
    for j in range(K):
        moved = x.copy()
        moved[j] += step * SIZES[j]
        rows[:, j] = (residuals(moved) - at) / (step * SIZES[j])
    for c in range(4):
        moved = x.copy()
        moved[K + c :: 4] += step
        change = (residuals(moved) - at) / step
        for w, window in enumerate(windows):
            own = slice(2 * window.start, 2 * window.stop)
            rows[own, K + 4 * w + c] = change[own]
    return rows


def first_states():
    for window in windows:
        near = slice(max(window.start - 8, 0), window.start + 9)
        fits = [np.polyfit(t[near] - t[window.start], q[near, j], 3) for j in (0, 1)]
        yield [fits[0][-1], fits[1][-1], fits[0][-2], fits[1][-2]]


start = time.perf_counter()
fit = least_squares(
    residuals, np.r_[START, np.ravel(list(first_states()))], jacobian, x_scale="jac", ftol=1e-6, xtol=1e-8, max_nfev=60
)
seconds = time.perf_counter() - start
rms = np.sqrt(np.mean(fit.fun.reshape(-1, 2) ** 2, 0))
print(f"{seconds:.1f} s, {fit.njev} Jacobians: residuals {1e3 * rms[0]:.3f} and {1e3 * rms[1]:.3f} mrad")
print({name: round(value, 5) for name, value in zip(PARAMETERS, fit.x)})
