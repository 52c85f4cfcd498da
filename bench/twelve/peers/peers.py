"""Integrates the twelve problems with heyoka and SciPy, on request.

The first line of the input has the problems as JSON, the first line of the output the versions, the entrants of each
problem and what is missing. Each further line asks for [problem, entrant, tolerance, times, outputs], and is answered with
the end of the last of so many integrations, the nanoseconds of one, and the states at the output times.
"""

import ctypes
import json
import math
import signal
import sys
import time
import warnings

import numpy as np
from counted import series
from equations import OWN, from_tape

warnings.filterwarnings("ignore")

# Seconds after which an integration by SciPy is given up.
PATIENCE = 1.0


def give_up(*_):
    raise TimeoutError(f"took more than {PATIENCE} s")


def output_times(problem, outputs):
    """Times at equal distances within the span."""
    between = problem["t1"] / (outputs + 1)
    return [n * between for n in range(1, outputs + 1)]


class Heyoka:
    """Taylor integrators, compiled when they are first called. The time of integrations over no time is subtracted."""

    by = "heyoka"

    def __init__(self, problem, form, compact):
        import heyoka

        self.hy, self.problem, self.compact = heyoka, problem, compact
        self.method = f"Taylor, {form}" + (", compact" if compact else "")
        self.equations = OWN[problem["name"]](heyoka) if form == "own form" else from_tape(heyoka, problem)
        self.compiled, self.nothing, self.flops = {}, math.inf, {}

    def integrator(self, tolerance):
        if tolerance not in self.compiled:
            start = self.problem["x0"]
            self.compiled[tolerance] = self.hy.taylor_adaptive(
                self.equations, start, tol=tolerance, compact_mode=self.compact, fast_math=True
            )
        return self.compiled[tolerance]

    def operations(self, tolerance):
        """Additions and multiplications of a step's series."""
        if tolerance not in self.flops:
            integrator = self.integrator(tolerance)
            self.flops[tolerance] = series(integrator.decomposition, len(self.problem["x0"]), integrator.order)
        return self.flops[tolerance]

    def run(self, tolerance, times, outputs):
        integrator, start = self.integrator(tolerance), np.array(self.problem["x0"])

        def restart():
            integrator.time = 0.0
            integrator.state[:] = start

        def seconds(end):
            since = time.perf_counter()
            for _ in range(times):
                restart()
                reached = integrator.propagate_until(end)
            return time.perf_counter() - since, reached[3]

        # the least of all calls: a difference of two disturbed times may be too small
        seconds(0.0)
        self.nothing = min(self.nothing, seconds(0.0)[0] / times)
        whole, steps = seconds(self.problem["t1"])
        answer = {
            "t": integrator.time,
            "x": integrator.state.tolist(),
            "evaluations": steps,
            "operations": steps * self.operations(tolerance),
            "nanoseconds": 1e9 * (whole / times - self.nothing),
        }
        if outputs:
            restart()
            grid = [0.0, *output_times(self.problem, outputs)]
            answer["along"] = integrator.propagate_grid(grid)[-1][1:].tolist()
        return answer


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

    def run(self, tolerance, times, outputs):
        start, end = self.problem["x0"], self.problem["t1"]
        settings = {"method": self.method, "rtol": tolerance, "atol": self.problem["absolute"] * tolerance, **self.more}

        def solve(**more):
            return self.solve(self.slope, (0.0, end), start, **settings, **more)

        # a clock in the right-hand side would slow it
        signal.setitimer(signal.ITIMER_REAL, PATIENCE * (times + (outputs > 0)))
        try:
            since = time.perf_counter()
            for _ in range(times):
                solution = solve()
            seconds = time.perf_counter() - since
            along = solve(t_eval=output_times(self.problem, outputs)).y.T.tolist() if outputs else []
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0.0)
        if not solution.success:
            raise RuntimeError(solution.message)
        return {
            "t": float(solution.t[-1]),
            "x": solution.y[:, -1].tolist(),
            "evaluations": int(solution.nfev),
            "jacobians": int(solution.njev),
            "nanoseconds": 1e9 * seconds / times,
            "along": along,
        }


def entrants(problem, missing):
    """Entrants of a problem. Adds the reasons why others are missing, with the problems."""
    found, kinds = [], []
    if not problem["is_stiff"]:
        # code without loops is faster, unless it is larger than caches; code of our form is slower where there is another
        form = "own form" if problem["name"] in OWN else "our form"
        kinds.append((Heyoka, form, False))
        if len(problem["x0"]) > 7 or problem["name"] not in OWN:
            kinds.append((Heyoka, form, True))
    for method in ["Radau", "BDF", "LSODA"] if problem["is_stiff"] else ["DOP853", "LSODA"]:
        kinds.append((SciPy, method))
    for kind, *settings in kinds:
        try:
            found.append(kind(problem, *settings))
        except Exception as error:  # one that does not load must not end the others
            why = f"{kind.by}: {type(error).__name__}: {error}"
            missing.setdefault(why, []).append(problem["name"])
    return found


def versions():
    found = {}
    for name in ("heyoka", "scipy", "numba"):
        try:
            found[name] = __import__(name).__version__
        except Exception:  # its entrants are missing, with the reason
            pass
    return found


def main():
    answers = sys.stdout
    sys.stdout = sys.stderr
    signal.signal(signal.SIGALRM, give_up)
    missing = {}
    all_entrants = [entrants(problem, missing) for problem in json.loads(sys.stdin.readline())]
    head = {
        "versions": list(versions().items()),
        "missing": [f"{why} ({', '.join(dict.fromkeys(names))})" for why, names in missing.items()],
        "entrants": [[[entrant.by, entrant.method] for entrant in found] for found in all_entrants],
    }
    print(json.dumps(head), file=answers, flush=True)
    for line in sys.stdin:
        problem, entrant, *request = json.loads(line)
        since = time.perf_counter()
        try:
            answer = json.dumps(all_entrants[problem][entrant].run(*request), allow_nan=False)
        except Exception as error:  # the reason is written into the results
            seconds = time.perf_counter() - since
            answer = json.dumps({"error": f"{type(error).__name__}: {error}", "nanoseconds": 1e9 * seconds})
        print(answer, file=answers, flush=True)


if __name__ == "__main__":
    main()
