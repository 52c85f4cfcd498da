"""Writes mass_ratios.json: accelerations of mechanisms with one body much lighter or heavier than the others, to 50 digits.

Run in this folder, with sympy (and the mpmath that comes with it): `python3 mass_ratios.py`; it takes some seconds.

The equations are Lagrange's, from positions of points and their velocities; a thin rod is given by its ends. The inputs
are the doubles in the file, taken as exact numbers. `condition` is the sum over all inputs p (parameters and state) of
|p dqdd/dp| for each acceleration, by differences in 130-digit arithmetic: the change of the acceleration for relative
errors of one unit in all inputs.
"""

import json

import mpmath
import sympy as sp

mpmath.mp.dps = 130
RATIOS = [f"1e{k}" for k in range(-8, 9)]
STEP = mpmath.mpf(10) ** -40  # relative step of the differences: their error is its square, their rounding 1e-90
Q = sp.symbols("q1:4")
QD = sp.symbols("v1:4")


class Scene:
    """Sums kinetic energy, potential energy and joint forces body by body."""

    def __init__(self, dof, names):
        self.q, self.qd = sp.Matrix(Q[:dof]), sp.Matrix(QD[:dof])
        self.p = sp.symbols(names)
        self.kinetic, self.potential, self.force = sp.S(0), sp.S(0), sp.zeros(dof, 1)

    def velocity(self, at):
        return at.jacobian(self.q) * self.qd

    def point(self, mass, at, up):
        v = self.velocity(at)
        self.kinetic += mass * v.dot(v) / 2
        self.potential += mass * up * at[-1]

    def rod(self, mass, start, end, up):
        u, v = self.velocity(start), self.velocity(end)
        self.kinetic += mass * (u.dot(u) + u.dot(v) + v.dot(v)) / 6
        self.potential += mass * up * (start + end)[-1] / 2

    def accelerations(self):
        """Returns a function of parameters and state."""
        momentum = sp.Matrix([self.kinetic]).jacobian(self.qd).T
        lagrangian = sp.Matrix([self.kinetic - self.potential])
        rest = momentum.jacobian(self.q) * self.qd - lagrangian.jacobian(self.q).T - self.force
        system = [momentum.jacobian(self.qd), rest]
        known = sp.lambdify([*self.p, *self.q, *self.qd], system, "mpmath", cse=True)

        def solve(inputs):
            matrix, rest = known(*inputs)
            return -mpmath.lu_solve(matrix, rest)

        return solve


def hanging(angle):
    """Direction of a link in the plane, from its upper end: right, then up."""
    return sp.Matrix([sp.sin(angle), -sp.cos(angle)])


def points(count, relative=False):
    """Point masses on a chain of massless rods."""
    n = range(1, count + 1)
    s = Scene(count, [f"m{k}" for k in n] + [f"l{k}" for k in n] + ["g"])
    masses, lengths, g = s.p[:count], s.p[count : 2 * count], s.p[-1]
    at, angle = sp.zeros(2, 1), sp.S(0)
    for mass, length, q in zip(masses, lengths, s.q):
        angle = angle + q if relative else q
        at += length * hanging(angle)
        s.point(mass, at, g)
    return s


def plates():
    """Two plates with friction in the joints, in absolute angles."""
    s = Scene(2, "m1 m2 inertia1 inertia2 c1 c2 d g gamma1 gamma2".split())
    m1, m2, inertia1, inertia2, c1, c2, d, g, gamma1, gamma2 = s.p
    s.point(m1, c1 * hanging(s.q[0]), g)
    s.point(m2, d * hanging(s.q[0]) + c2 * hanging(s.q[1]), g)
    s.kinetic += inertia1 * s.qd[0] ** 2 / 2 + inertia2 * s.qd[1] ** 2 / 2
    turned = s.qd[1] - s.qd[0]
    s.force += sp.Matrix([gamma2 * turned - gamma1 * s.qd[0], -gamma2 * turned])
    return s


def cart():
    """A point mass on a massless rod, on a cart."""
    s = Scene(2, "m1 m2 l g".split())
    m1, m2, l, g = s.p
    pivot = sp.Matrix([s.q[0], 0])
    s.point(m1, pivot, g)
    s.point(m2, pivot + l * hanging(s.q[1]), g)
    return s


def arm():
    """Three thin rods: the first turns about z and the second about y, both along x; the third about x, along -z."""
    s = Scene(3, "m1 m2 m3 l1 l2 l3 g".split())
    m1, m2, m3, l1, l2, l3, g = s.p
    (c1, c2, c3), (s1, s2, s3) = [[f(q) for q in s.q] for f in (sp.cos, sp.sin)]
    first = sp.Matrix([[c1, -s1, 0], [s1, c1, 0], [0, 0, 1]])
    second = first * sp.Matrix([[c2, 0, s2], [0, 1, 0], [-s2, 0, c2]])
    third = second * sp.Matrix([[1, 0, 0], [0, c3, -s3], [0, s3, c3]])
    shoulder = first * sp.Matrix([l1, 0, 0])
    elbow = shoulder + second * sp.Matrix([l2, 0, 0])
    s.rod(m1, sp.zeros(3, 1), shoulder, g)
    s.rod(m2, shoulder, elbow, g)
    s.rod(m3, elbow, elbow + third * sp.Matrix([0, 0, -l3]), g)
    return s


RIGHT = 1.5707963267948966  # the double below a right angle
HALF = 2 * RIGHT
TWO = [
    [0.7, -1.9, 1.3, -0.8],  # generic
    [0.3, 0.30001, 0.4, -0.6],  # nearly aligned
    [0.3, 0.3, 0.5, -0.7],  # aligned
    [0.3, 0.3 + HALF, 0.5, -0.7],  # folded
    [1e-4, -2e-4, 0.3, 0.2],  # hanging almost at rest, with hardly any sensitivity to the angles
    [RIGHT, RIGHT + 1e-9, 0.0, 0.0],  # aligned and level, with minimal sensitivity of gravity to the angles
]
TWO_RELATIVE = [
    [0.7, -2.6, 1.3, -2.1],
    [0.3, 1e-5, 0.4, -1.0],
    [0.3, 0.0, 0.5, -1.2],
    [0.3, HALF, 0.5, -1.2],
    [1e-4, -3e-4, 0.3, -0.1],
    [RIGHT, 1e-9, 0.0, 0.0],
]
THREE = [
    [0.7, -1.9, 0.4, 1.3, -0.8, 0.6],
    [0.3, 0.30001, 0.29997, 0.4, -0.6, 0.1],
    [0.3, 0.3, 0.3, 0.5, -0.7, 0.2],
    [0.3, 0.3 + HALF, 0.3, 0.5, -0.7, 0.2],
    [1e-4, -2e-4, 1.5e-4, 0.3, 0.2, -0.1],
    [RIGHT, RIGHT + 1e-9, RIGHT - 2e-9, 0.0, 0.0, 0.0],
]
CART = [
    [0.4, 0.7, 1.3, -0.8],
    [0.4, 0.01, 0.3, 0.2],
    [0.4, 1e-4, 0.3, 0.2],
    [0.4, HALF - 1e-4, 0.3, 0.2],
    [0.4, RIGHT, 0.5, -0.7],
]
ARM = [
    [0.7, -1.9, 0.4, 1.3, -0.8, 0.6],
    [0.3, 1e-5, -2e-5, 0.4, -0.6, 0.1],  # the last rod hangs
    [0.3, 0.0, 0.0, 0.5, -0.7, 0.2],
    [0.3, HALF - 1e-5, 2e-5, 0.4, -0.6, 0.1],  # the last rod nearly on the axis of the first joint
    [0.3, HALF, 0.0, 0.5, -0.7, 0.2],  # the last rod on the axis of the first joint
]
POINTS = {"m1": 1.0, "m2": 1.0, "l1": 1.1, "l2": 0.9, "g": 9.81}
CHAIN = POINTS | {"m3": 1.0, "l3": 0.7}
PLATES = dict(m1=1.0, m2=1.0, inertia1=0.3, inertia2=0.2, c1=0.6, c2=0.45, d=1.1, g=9.81, gamma1=0.1, gamma2=0.05)
LAST_ARM = dict(m1=1.0, m2=0.8, m3=1.0, l1=0.5, l2=0.5, l3=0.7, g=9.81)
# name, equations, parameters, parameters that are multiplied by the ratio, states
SCENES = [
    ("points", points(2), POINTS, ["m2"], TWO),
    ("points_relative", points(2, relative=True), POINTS, ["m2"], TWO_RELATIVE),
    ("plates", plates(), PLATES, ["m2", "inertia2"], TWO),
    ("plates_slight", plates(), PLATES | {"inertia1": 1e-10, "inertia2": 1e-10}, ["m2"], TWO),
    ("cart", cart(), dict(m1=1.0, m2=1.0, l=0.9, g=9.81), ["m1"], CART),
    ("chain_last", points(3), CHAIN, ["m3"], THREE),
    ("chain_middle", points(3), CHAIN, ["m2"], THREE),
    ("arm", arm(), LAST_ARM, ["m3"], ARM),
]


def sample(solve, inputs):
    exact = [mpmath.mpf(x) for x in inputs]
    value = solve(exact)
    condition = [mpmath.mpf(0)] * len(value)
    for k, p in enumerate(exact):
        if p != 0:
            moved = [solve(exact[:k] + [p * (1 + sign * STEP)] + exact[k + 1 :]) for sign in (1, -1)]
            change = (moved[0] - moved[1]) / (2 * STEP)
            condition = [sum_ + abs(d) for sum_, d in zip(condition, change)]
    digits = lambda values, count: [mpmath.nstr(x, count) for x in values]
    return {"acceleration": digits(value, 50), "condition": digits(condition, 6)}


def scene(name, equations, parameters, varied, states):
    solve = equations.accelerations()
    cases = []
    for ratio in RATIOS:
        # products of doubles, rounded to doubles: these are the inputs
        given = {k: v * float(ratio) if k in varied else v for k, v in parameters.items()}
        values = [given[str(p)] for p in equations.p]
        samples = [sample(solve, values + state) for state in states]
        cases.append({"ratio": ratio, "parameters": {k: repr(v) for k, v in given.items()}, "samples": samples})
    return {"name": name, "varied": varied, "states": [[repr(x) for x in state] for state in states], "cases": cases}


if __name__ == "__main__":
    doc = (
        "Made by mass_ratios.py. SI units. Numbers are strings, since the inputs are exactly these doubles and the accelerations"
        " have 50 digits; states are coordinates, then rates; samples are in the order of the states. condition: the sum over all"
        " parameters and state variables p of |p dqdd/dp|, for each acceleration."
    )
    scenes = [scene(*entry) for entry in SCENES]
    lines = ",\n".join(
        json.dumps({k: v for k, v in s.items() if k != "cases"})[:-1]
        + ', "cases": [\n'
        + ",\n".join(json.dumps(case) for case in s["cases"])
        + "\n]}"
        for s in scenes
    )
    with open("mass_ratios.json", "w", encoding="utf-8") as file:
        file.write(f'{{"doc": {json.dumps(doc)},\n"scenes": [\n{lines}\n]}}\n')
