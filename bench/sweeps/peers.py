"""Times heyoka's batches and Numba's parallel loops on a sweep given in a folder.

Arguments: the folder, which holds `starts.bin` (four numbers a trajectory) and `task.json`, and the output file.
Each function is called once before it is timed, which compiles it.
"""

import copy
import json
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np


def timed(call, rounds=3):
    """Minimum time of some rounds, and the last result."""
    times = []
    for _ in range(rounds):
        since = time.perf_counter()
        result = call()
        times.append(time.perf_counter() - since)
    return min(times), result


def heyoka(starts, end, tolerance, threads):
    import heyoka as hy

    t1, t2, w1, w2 = hy.make_vars("t1", "t2", "w1", "w2")
    m12, turn = hy.cos(t1 - t2), hy.sin(t1 - t2)
    f1 = -(turn * w2**2 + 19.6 * hy.sin(t1))
    f2 = turn * w1**2 - 9.8 * hy.sin(t2)
    determinant = 6.0 - m12**2
    equations = [(t1, w1), (t2, w2), (w1, (2.0 * f1 - m12 * f2) / determinant), (w2, (3.0 * f2 - m12 * f1) / determinant)]
    size = hy.recommended_simd_size()
    integrator = hy.taylor_adaptive_batch(equations, np.zeros((4, size)), tol=tolerance, compact_mode=False)

    # One integrator per thread: an ensemble would copy it for each batch, which takes longer than the batch.
    integrators = [copy.deepcopy(integrator) for _ in range(threads)]

    def run(batches):
        ends = np.empty((batches * size, 4))

        def share(own):
            for n in range(own, batches, threads):
                batch = integrators[own]
                batch.set_time(0.0)
                batch.state[:] = starts[n * size : (n + 1) * size].T
                batch.propagate_until(end)
                ends[n * size : (n + 1) * size] = batch.state.T

        list(pool.map(share, range(threads)))
        return ends

    with ThreadPoolExecutor(threads) as pool:
        run(4)
        seconds, ends = timed(lambda: run(len(starts) // size))
    return seconds, ends, f"heyoka {hy.__version__}, batches of {size}"


def numba(starts, end, steps, threads):
    import numba as nb

    nb.set_num_threads(threads)

    @nb.njit(inline="always")
    def slope(x):
        m12, turn = np.cos(x[0] - x[1]), np.sin(x[0] - x[1])
        f1 = -(turn * x[3] * x[3] + 19.6 * np.sin(x[0]))
        f2 = turn * x[2] * x[2] - 9.8 * np.sin(x[1])
        over = 1.0 / (6.0 - m12 * m12)
        return (x[2], x[3], (2.0 * f1 - m12 * f2) * over, (3.0 * f2 - m12 * f1) * over)

    @nb.njit(inline="always")
    def moved(x, k, h):
        return (x[0] + h * k[0], x[1] + h * k[1], x[2] + h * k[2], x[3] + h * k[3])

    @nb.njit(parallel=True)
    def run(starts, h, steps):
        ends = np.empty_like(starts)
        for n in nb.prange(len(starts)):
            x = (starts[n, 0], starts[n, 1], starts[n, 2], starts[n, 3])
            for _ in range(steps):
                k1 = slope(x)
                k2 = slope(moved(x, k1, 0.5 * h))
                k3 = slope(moved(x, k2, 0.5 * h))
                k4 = slope(moved(x, k3, h))
                x = moved(moved(moved(moved(x, k1, h / 6), k2, h / 3), k3, h / 3), k4, h / 6)
            ends[n, 0], ends[n, 1], ends[n, 2], ends[n, 3] = x
        return ends

    run(starts[:100], end / steps, steps)
    seconds, ends = timed(lambda: run(starts, end / steps, steps))
    return seconds, ends, f"Numba {nb.__version__}"


def main(folder):
    task = json.loads((folder / "task.json").read_text())
    starts = np.fromfile(folder / "starts.bin").reshape(-1, 4)
    results = []
    for kind, argument in task["settings"]:
        peer = {"heyoka": heyoka, "Rk4": numba}[kind]
        try:
            seconds, ends, name = peer(starts, task["end"], argument, task["threads"])
        except ImportError as error:
            print(f"left out: {error}", file=sys.stderr)
            continue
        results.append({"kind": kind, "argument": argument, "name": name, "seconds": seconds, "ends": ends[:100].tolist()})
    (folder / "results.json").write_text(json.dumps(results))


main(Path(sys.argv[1]))
