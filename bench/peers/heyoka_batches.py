"""Times heyoka's compiled functions on batches of states of the double pendulum (Eq. 22).

They read and write columns of numbers, and have the parameters of `double_pendulum.json` as numbers.
"""

import json
import time
from pathlib import Path

import heyoka as hy
import numpy as np

p = json.loads(Path(__file__).with_name("double_pendulum.json").read_text())
m, inertia, c, d, g, gamma1, gamma2 = (p[key] for key in ("m", "inertia", "c", "d", "g", "gamma1", "gamma2"))
angle1, angle2, rate1, rate2 = state = hy.make_vars("angle1", "angle2", "rate1", "rate2")
m11, m22 = inertia + m * (c * c + d * d), inertia + m * c * c
m12, turn = m * c * d * hy.cos(angle1 - angle2), m * c * d * hy.sin(angle1 - angle2)
torque1 = gamma2 * (rate2 - rate1) - gamma1 * rate1 - turn * rate2**2 - m * g * (c + d) * hy.sin(angle1)
torque2 = gamma2 * (rate1 - rate2) + turn * rate1**2 - m * g * c * hy.sin(angle2)
determinant = m11 * m22 - m12**2
rates = [(m22 * torque1 - m12 * torque2) / determinant, (m11 * torque2 - m12 * torque1) / determinant]
jacobian = [hy.diff(rate, by) for rate in rates for by in state]

print(f"heyoka {hy.__version__}, batches of {hy.recommended_simd_size()}")
states = np.random.default_rng(22).uniform(-3.0, 3.0, (4, 1 << 14))
for name, functions in [("right-hand side", rates), ("with Jacobian", rates + jacobian)]:
    for fast in (False, True):
        function = hy.cfunc(functions, list(state), fast_math=fast, compact_mode=False)
        results = np.zeros((len(functions), states.shape[1]))
        least = float("inf")
        for _ in range(1000):
            since = time.perf_counter()
            function(states, outputs=results)
            least = min(least, time.perf_counter() - since)
        print(f"{name}, fast_math {fast}: {1e9 * least / states.shape[1]:.2f} ns")
