"""Integrates the twelve problems with heyoka and SciPy, on request.

The first line of the input has the problems as JSON, the first line of the output the versions, the entrants of each
problem and what is missing. Each further line asks for [problem, entrant, tolerance, times], and is answered with the end
of the last of so many integrations and the nanoseconds of one.
"""

import ctypes
import json
import math
import sys
import time
import warnings

import numpy as np
from equations import OWN, from_tape

warnings.filterwarnings("ignore")

# Seconds after which an integration by SciPy is given up.
PATIENCE = 1.0


class Heyoka:
    """Taylor integrators, compiled when they are first called. The time of integrations over no time is subtracted."""

    by = "heyoka"

    def __init__(self, problem, form, compact):
        import heyoka

        self.hy, self.problem, self.compact = heyoka, problem, compact
        self.method = f"Taylor, {form}" + (", compact" if compact else "")
        self.equations = OWN[problem["name"]](heyoka) if form == "own form" else from_tape(heyoka, problem)
        self.compiled, self.nothing = {}, math.inf

    def integrator(self, tolerance):
        if tolerance not in self.compiled:
            start = self.problem["x0"]
            self.compiled[tolerance] = self.hy.taylor_adaptive(
                self.equations, start, tol=tolerance, compact_mode=self.compact, fast_math=True
            )
        return self.compiled[tolerance]

    def run(self, tolerance, times):
        integrator, start = self.integrator(tolerance), np.array(self.problem["x0"])

        def seconds(end):
            since = time.perf_counter()
            for _ in range(times):
                integrator.time = 0.0
                integrator.state[:] = start
                integrator.propagate_until(end)
            return time.perf_counter() - since

        # the least of all calls: a difference of two disturbed times may be too small
        seconds(0.0)
        self.nothing = min(self.nothing, seconds(0.0) / times)
        whole = seconds(self.problem["t1"]) / times
        return {
            "t": integrator.time,
            "x": integrator.state.tolist(),
            "evaluations": None,
            "nanoseconds": 1e9 * (whole - self.nothing),
        }


class SciPy:
    """`solve_ivp`, with the emitted C called by code that numba compiles."""

    by = "SciPy"

    def __init__(self, problem, method):
        import numba
        from scipy.integrate import solve_ivp

        self.problem, self.method, self.solve = problem, method, solve_ivp
        library, length = ctypes.CDLL(problem["library"]), len(problem["x0"])
        rhs, jacobian = library.rhs, library.jacobian
        for function in (rhs, jacobian):
            function.argtypes = [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_long]
            function.restype = None

        @numba.njit
        def slope(t, x):
            out = np.empty(length)
            rhs(x.ctypes.data, out.ctypes.data, 1)
            return out

        @numba.njit
        def rows(t, x):
            out = np.empty((length, length))
            jacobian(x.ctypes.data, out.ctypes.data, 1)
            return out.T

        self.slope, self.more = slope, {} if method == "DOP853" else {"jac": rows}
        # compiles them
        start = np.array(problem["x0"])
        slope(0.0, start), rows(0.0, start)

    def run(self, tolerance, times):
        give_up = time.perf_counter() + PATIENCE

        def slope(t, x):
            if time.perf_counter() > give_up:
                raise TimeoutError(f"took more than {PATIENCE} s")
            return self.slope(t, x)

        start, end = self.problem["x0"], self.problem["t1"]
        settings = {"method": self.method, "rtol": tolerance, "atol": self.problem["absolute"] * tolerance, **self.more}
        since = time.perf_counter()
        for _ in range(times):
            solution = self.solve(slope, (0.0, end), start, **settings)
        seconds = time.perf_counter() - since
        if not solution.success:
            raise RuntimeError(solution.message)
        return {
            "t": float(solution.t[-1]),
            "x": solution.y[:, -1].tolist(),
            "evaluations": int(solution.nfev),
            "nanoseconds": 1e9 * seconds / times,
        }


def entrants(problem):
    """Entrants of a problem, and the reasons why others are missing."""
    found, missing, makers = [], [], []
    if not problem["is_stiff"]:
        # code without loops is faster, unless it is larger than caches; code of our form is slower where there is another
        forms = [("own form", False)] if problem["name"] in OWN else [("our form", False)]
        if len(problem["x0"]) > 7 or problem["name"] not in OWN:
            forms += [(form, True) for form, _ in forms]
        makers += [lambda form=form, compact=compact: Heyoka(problem, form, compact) for form, compact in forms]
    for method in ["Radau", "BDF", "LSODA"] if problem["is_stiff"] else ["DOP853", "LSODA"]:
        makers.append(lambda method=method: SciPy(problem, method))
    for make in makers:
        try:
            found.append(make())
        except ImportError as error:
            missing.append(str(error))
    return found, missing


def versions():
    found = {}
    for name in ("heyoka", "scipy", "numba"):
        try:
            found[name] = __import__(name).__version__
        except ImportError:
            pass
    return found


def main():
    answers = sys.stdout
    sys.stdout = sys.stderr
    both = [entrants(problem) for problem in json.loads(sys.stdin.readline())]
    all_entrants = [found for found, _ in both]
    head = {
        "versions": list(versions().items()),
        "missing": sorted({line for _, missing in both for line in missing}),
        "entrants": [[[entrant.by, entrant.method] for entrant in found] for found in all_entrants],
    }
    print(json.dumps(head), file=answers, flush=True)
    for line in sys.stdin:
        problem, entrant, tolerance, times = json.loads(line)
        try:
            answer = json.dumps(all_entrants[problem][entrant].run(tolerance, times), allow_nan=False)
        except Exception as error:  # the reason is written into the results
            answer = json.dumps({"error": f"{type(error).__name__}: {error}"})
        print(answer, file=answers, flush=True)


if __name__ == "__main__":
    main()
