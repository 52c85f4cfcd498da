"""Equations of the problems as expressions of heyoka: written by hand, or made from the tape of a problem."""

import math


def pendulum(friction):
    """Eq. 22 with m = I = c = d = 1 and g = 9.8, solved for the accelerations."""

    def make(hy):
        t1, t2, w1, w2 = hy.make_vars("t1", "t2", "w1", "w2")
        m12, turn = hy.cos(t1 - t2), hy.sin(t1 - t2)
        rub = friction * (w1 - w2)
        f1 = -(friction * w1 + rub + turn * w2**2 + 19.6 * hy.sin(t1))
        f2 = rub + turn * w1**2 - 9.8 * hy.sin(t2)
        determinant = 6.0 - m12**2
        return [
            (t1, w1),
            (t2, w2),
            (w1, (2.0 * f1 - m12 * f2) / determinant),
            (w2, (3.0 * f2 - m12 * f1) / determinant),
        ]

    return make


def arenstorf(hy):
    x, y, u, v = hy.make_vars("x", "y", "u", "v")
    moon = 0.012277471
    earth = 1.0 - moon
    to_earth = ((x + moon) ** 2 + y**2) ** -1.5
    to_moon = ((x - earth) ** 2 + y**2) ** -1.5
    return [
        (x, u),
        (y, v),
        (u, x + 2.0 * v - earth * (x + moon) * to_earth - moon * (x - earth) * to_moon),
        (v, y - 2.0 * u - earth * y * to_earth - moon * y * to_moon),
    ]


def pleiades(hy):
    stars = range(7)
    x, y = [hy.make_vars(*[f"{name}{star}" for star in stars]) for name in "xy"]
    u, v = [hy.make_vars(*[f"{name}{star}" for star in stars]) for name in "uv"]
    along, across = [[] for _ in stars], [[] for _ in stars]
    for i in stars:
        for j in range(i + 1, 7):
            dx, dy = x[j] - x[i], y[j] - y[i]
            cube = hy.sum([dx**2, dy**2]) ** -1.5
            for one, other, sign in ((i, j, 1.0), (j, i, -1.0)):
                along[one].append(sign * (other + 1.0) * (dx * cube))
                across[one].append(sign * (other + 1.0) * (dy * cube))
    slopes = [hy.sum(terms) for both in zip(along, across) for terms in both]
    positions = [name for both in zip(x, y) for name in both]
    rates = [name for both in zip(u, v) for name in both]
    return list(zip(positions, rates)) + list(zip(rates, slopes))


def henon_heiles(hy):
    x, y, u, v = hy.make_vars("x", "y", "u", "v")
    return [(x, u), (y, v), (u, -x - 2.0 * x * y), (v, y**2 - y - x**2)]


def heavy_top(hy):
    w, x, y, z, a, b, c = hy.make_vars("w", "x", "y", "z", "a", "b", "c")
    across, along, moment = 0.234375 + 15.0, 0.46875, 15.0 * 9.81
    # direction of the weight in body coordinates, times the arm
    tx = moment * 2.0 * (y * z + w * x)
    ty = -moment * 2.0 * (x * z - w * y)
    return [
        (w, 0.5 * (-x * a - y * b - z * c)),
        (x, 0.5 * (w * a + y * c - z * b)),
        (y, 0.5 * (w * b + z * a - x * c)),
        (z, 0.5 * (w * c + x * b - y * a)),
        (a, (tx - (along - across) * b * c) / across),
        (b, (ty - (across - along) * c * a) / across),
        (c, 0.0 * a),
    ]


OWN = {
    "regular": pendulum(0.1),
    "chaotic": pendulum(0.0),
    "arenstorf": arenstorf,
    "pleiades": pleiades,
    "henon_heiles": henon_heiles,
    "heavy_top": heavy_top,
}


def from_tape(hy, problem):
    """Equations of the tape of a problem."""
    lines = [line.rstrip("\n").split("\t") for line in open(problem["tape"])]
    given = problem["parameters"]
    parameters = [given.get(line[1], line[3]) for line in lines if line[0] == "parameter"]
    parameters = [float(value) for value in parameters]
    constants = evaluate(hy, block(lines, ["code", "constants"]), {"parameter": parameters})
    state = hy.make_vars(*[f"s{n}" for n in range(len(problem["x0"]))])
    slopes = evaluate(hy, block(lines, ["routine", "rhs"]), {"state": state, "constant": constants})
    # an equation of heyoka depends on some variable
    return [(x, slope if isinstance(slope, hy.expression) else slope + 0.0 * x) for x, slope in zip(state, slopes)]


def block(lines, head):
    """Lines of a block up to its results."""
    start = next(n for n, line in enumerate(lines) if line[:2] == head)
    end = next(n for n in range(start, len(lines)) if lines[n][0] == "result")
    return lines[start + 1 : end + 1]


def evaluate(hy, lines, known):
    """Results of a block, whose operations act on numbers or on expressions."""

    def function(name):
        return lambda a: getattr(math if isinstance(a, float) else hy, name)(a)

    sin, cos = function("sin"), function("cos")
    run = {
        "add": lambda a, b: [a + b],
        "sub": lambda a, b: [a - b],
        "mul": lambda a, b: [a * b],
        "div": lambda a, b: [a / b],
        "neg": lambda a: [-a],
        "sqrt": lambda a: [function("sqrt")(a)],
        "atan2": lambda a, b: [hy.atan2(a, b)],
        "powf": lambda a, b: [a**b],
        "mul_add": lambda a, b, c: [a * b + c],
        "mul_sub": lambda a, b, c: [a * b - c],
        "mul_neg_add": lambda a, b, c: [c - a * b],
        "sin_cos": lambda a: [sin(a), cos(a)],
        "sin_cos_pair": lambda a, b: [sin(a), cos(a), sin(b), cos(b)],
    }
    results = {"sin_cos": 2, "sin_cos_pair": 4}
    registers, reads = {}, 0
    for head, *rest in lines:
        if head == "registers":
            continue
        if head == "read":
            for index in map(int, rest[1].split()):
                registers[reads] = known[rest[0]][index]
                reads += 1
        elif head == "number":
            registers[int(rest[0])] = float(rest[1])
        elif head == "result":
            return [registers[int(n)] for n in rest[0].split()] if rest[0] else []
        else:
            numbers = [int(n) for n in rest[0].split()]
            count = results.get(head, 1)
            values = run[head](*[registers[n] for n in numbers[count:]])
            registers.update(zip(numbers[:count], values))
