"""The package `pendulum_dynamics` beside SciPy with numba, and heyoka, in one process.

The mechanism is the paper's double pendulum without friction: Eq. 22 with m = I = d = 1 and g = 9.8, from
(2.0, 2.5, 0, 0) to t = 10 s. All take turns, round by round; the least time of each counts. Errors are those of the
final state, relative to its own solution at 1e-13. Prints a table, and writes it with all samples to
`out/python.json`.
"""

import json
import platform
import sys
import time
from pathlib import Path

import numba
import numpy as np
import pendulum_dynamics as pendulum
from scipy.integrate import solve_ivp

TEXT = """
pub DoublePendulum {
    gravity: [0, -9.8, 0],
    generate: [rhs, jacobian, energy, taylor],
    body upper on ground { mass: 1, inertia: 1, com: [0, -1, 0], joint: revolute(z), coordinate: a }
    body lower on upper {
        mass: 1, inertia: 1, com: [0, -1, 0], joint: revolute(z) at [0, -1, 0], coordinate: b,
    }
}
"""
START = np.array([2.0, 2.5, 0.0, 0.0])
SPAN = (0.0, 10.0)
ROUNDS = 60


@numba.njit(fastmath=True)
def rhs(t, x):
    """The same equations by hand; angles of the second link are relative, as above."""
    a, b, da, db = x
    s, c = np.sin(b), np.cos(b)
    m11, m12, m22 = 5.0 + 2.0 * c, 2.0 + c, 2.0
    g2 = 9.8 * np.sin(a + b)
    b1 = -s * (2.0 * da + db) * db + 19.6 * np.sin(a) + g2
    b2 = s * da * da + g2
    det = m11 * m22 - m12 * m12
    return np.array([da, db, (m12 * b2 - m22 * b1) / det, (m12 * b1 - m11 * b2) / det])


def heyoka_runs():
    """An integration by heyoka for each tolerance, as functions, with the seconds of their compilation."""
    try:
        import heyoka as hy
    except ImportError:
        return {}
    a, b, da, db = hy.make_vars("a", "b", "da", "db")
    s, c = hy.sin(b), hy.cos(b)
    m11, m12, m22 = 5.0 + 2.0 * c, 2.0 + c, 2.0
    g2 = 9.8 * hy.sin(a + b)
    b1 = -s * (2.0 * da + db) * db + 19.6 * hy.sin(a) + g2
    b2 = s * da**2 + g2
    det = m11 * m22 - m12**2
    system = [(a, da), (b, db), (da, (m12 * b2 - m22 * b1) / det), (db, (m12 * b1 - m11 * b2) / det)]
    runs = {}
    for tolerance in (1e-8, 1e-10):
        began = time.perf_counter()
        own = hy.taylor_adaptive(system, START.copy(), tol=tolerance, fast_math=True)
        seconds = time.perf_counter() - began

        def run(own=own):
            own.time = 0.0
            own.state[:] = START
            own.propagate_until(SPAN[1])
            return own.state.copy()

        runs[f"heyoka {tolerance:g}"] = (run, seconds)
    return runs


def main():
    began = time.perf_counter()
    model = pendulum.Model(TEXT)
    model.rhs(0.0, START)
    seconds = time.perf_counter() - began
    assert np.abs(model.rhs(0.0, START + 0.3) - rhs(0.0, START + 0.3)).max() < 1e-12, "the equations differ"
    exact = model.solve(SPAN, START, rtol=1e-13, atol=1e-13).end[1]
    runs = {}
    for tolerance in (1e-8, 1e-10):
        at = {"rtol": tolerance, "atol": tolerance}
        for method in ("Vern9", "Taylor"):
            only = {"t_eval": [SPAN[1]], "method": method, **at}
            runs[f"pendulum {method} {tolerance:g}"] = (lambda o=only: model.solve(SPAN, START, **o).y[:, -1], seconds)
        dop = {"t_eval": [SPAN[1]], "method": "DOP853", **at}
        runs[f"SciPy DOP853, numba {tolerance:g}"] = (lambda o=dop: solve_ivp(rhs, SPAN, START, **o).y[:, -1], 0.0)
    runs.update(heyoka_runs())
    samples = {name: [] for name in runs}
    errors = {name: float(np.abs(run() - exact).max()) for name, (run, _) in runs.items()}
    for _ in range(ROUNDS):
        for name, (run, _) in runs.items():
            began = time.perf_counter()
            run()
            samples[name].append(time.perf_counter() - began)
    machine = platform.processor() or platform.machine()
    print(f"{machine}, Python {sys.version.split()[0]}; first evaluation {seconds * 1e3:.1f} ms")
    for name, times in samples.items():
        built = f", built in {runs[name][1]:.2f} s" if runs[name][1] else ""
        print(f"{name:28} {min(times) * 1e6:9.1f} us, error {errors[name]:.1e}{built}")
    out = Path("out")
    out.mkdir(exist_ok=True)
    record = {"errors": errors, "samples": samples, "first_evaluation": seconds, "python": sys.version}
    out.joinpath("python.json").write_text(json.dumps(record))


if __name__ == "__main__":
    main()
