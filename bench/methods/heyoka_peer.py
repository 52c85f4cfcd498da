"""Times heyoka's Taylor integrators on scenes given in JSON, one trajectory at a time and eight in a batch.

Arguments: the scenes, and the output file. The time of a call that integrates over no time is measured and subtracted.
"""

import json
import statistics
import sys
import time

import heyoka as hy
import numpy as np

# Time budget for all settings of a scene together, in seconds, and minimum number of rounds.
BUDGET, ROUNDS = 6.0, 31


def equations(gamma):
    """Eq. 22 with m = I = c = d = 1 and g = 9.8, solved for the accelerations."""
    t1, t2, w1, w2 = hy.make_vars("t1", "t2", "w1", "w2")
    m12, turn = hy.cos(t1 - t2), hy.sin(t1 - t2)
    rub = gamma * (w1 - w2)
    f1 = -(gamma * w1 + rub + turn * w2**2 + 19.6 * hy.sin(t1))
    f2 = rub + turn * w1**2 - 9.8 * hy.sin(t2)
    determinant = 6.0 - m12**2
    return [
        (t1, w1),
        (t2, w2),
        (w1, (2.0 * f1 - m12 * f2) / determinant),
        (w2, (3.0 * f2 - m12 * f1) / determinant),
    ]


def alone(scene, tolerance):
    integrator = hy.taylor_adaptive(equations(scene["gamma"]), [0.0] * 4, tol=tolerance, compact_mode=False)
    start = np.array(scene["x0"])

    def run(end):
        integrator.time = 0.0
        integrator.state[:] = start
        integrator.propagate_until(end)

    return run, lambda: (integrator.time, integrator.state.tolist()), 1


def batch(scene, tolerance, size=8):
    integrator = hy.taylor_adaptive_batch(
        equations(scene["gamma"]), np.zeros((4, size)), tol=tolerance, compact_mode=False
    )
    start = np.repeat(np.array(scene["x0"])[:, None], size, axis=1)
    start[0] += scene["apart"] * np.arange(size)
    zero = np.zeros(size)

    def run(end):
        integrator.set_time(zero)
        integrator.state[:] = start
        integrator.propagate_until(end)

    return run, lambda: (float(integrator.time[0]), integrator.state[:, 0].tolist()), size


def seconds(run, end):
    start = time.perf_counter()
    run(end)
    return time.perf_counter() - start


def measure(scene, make):
    """Final states and times for all tolerances, measured in turn."""
    runs, points = [], []
    for tolerance in scene["tolerances"]:
        run, state, size = make(scene, tolerance)
        end = scene["t1"] if size == 1 else np.full(size, scene["t1"])
        none = 0.0 if size == 1 else np.zeros(size)
        run(end)
        t, x = state()
        runs.append((run, end, none, size))
        points.append({"tolerance": tolerance, "t": t, "x": x})
    times = [([], []) for _ in runs]
    start = time.perf_counter()
    while len(times[-1][0]) < ROUNDS or time.perf_counter() - start < BUDGET:
        for (run, end, none, _), (whole, nothing) in zip(runs, times):
            seconds(run, end)
            whole.append(seconds(run, end))
            nothing.append(seconds(run, none))
    for point, (whole, nothing), (_, _, _, size) in zip(points, times, runs):
        point["overhead"] = 1e9 * min(nothing) / size
        point["least"] = 1e9 * (min(whole) - min(nothing)) / size
        point["median"] = 1e9 * (statistics.median(whole) - statistics.median(nothing)) / size
    return points


scenes = json.load(open(sys.argv[1]))
results = {"version": hy.__version__, "alone": [], "batch": []}
for scene in scenes:
    results["alone"].append(measure(scene, alone))
    results["batch"].append(measure(scene, batch))
json.dump(results, open(sys.argv[2], "w"))
