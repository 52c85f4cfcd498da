"""C code by SymPy: Kane's method with common subexpression elimination."""

import sympy as sp
from candidate import Operations, loop
from sympy.physics.mechanics import KanesMethod, Point, ReferenceFrame, RigidBody, Vector, dynamicsymbols, inertia
from sympy.printing.c import C99CodePrinter

JACOBIAN_LEFT_OUT = (
    "SymPy's Jacobian of {}: in a trial it took two minutes and had 73,000 operations before the solution, "
    "nine times those of CasADi's."
)

# Print squares as products: `pow` is a call.
POWERS = C99CodePrinter(
    {
        "user_functions": {
            "Pow": [
                (lambda base, power: power == 2, lambda base, power: f"(({base})*({base}))"),
                (lambda base, power: power == -1, lambda base, power: f"(1.0/({base}))"),
                (lambda base, power: True, "pow"),
            ]
        }
    }
)


def write(folder, robots, p):
    pendulum(folder, p)
    for robot in robots:
        spatial(folder, robot)


def spatial(folder, robot):
    """Mass matrix and forces by Kane's method. They are solved in steps: expanded quotients would explode in size."""
    matrix, forces, x = kane_robot(robot)
    count = len(robot.bodies)
    lower = [matrix[n, k] for n in range(count) for k in range(n + 1)]
    known, results = sp.cse([*lower, *forces], symbols=sp.numbered_symbols("t"))
    steps = Steps(known)
    factor = Factor(steps, results[: len(lower)])
    finish(folder, robot.name, "rhs", "Kane + LDLt", x, steps.taken, factor.solve(results[len(lower) :]))
    if count > 6:
        folder.note(JACOBIAN_LEFT_OUT.format(robot.name))
        return
    # From M dqdd = d(f - M qdd), with symbols for qdd.
    qdd = sp.symbols(f"a0:{count}")
    lacking = (forces - matrix * sp.Matrix(qdd)).jacobian(x)
    known, results = sp.cse([*lower, *forces, *lacking], symbols=sp.numbered_symbols("t"))
    # Expressions with qdd come after the solution.
    late, early, waiting = set(qdd), [], []
    for name, e in known:
        if e.free_symbols & late:
            late.add(name)
            waiting.append((name, e))
        else:
            early.append((name, e))
    steps = Steps(early)
    factor = Factor(steps, results[: len(lower)])
    solution = factor.solve(results[len(lower) : len(lower) + count])
    steps.taken += [*zip(qdd, solution), *waiting]
    # The entries are stored row by row.
    derivative = sp.Matrix(count, 2 * count, results[len(lower) + count :])
    columns = [entry for n in range(2 * count) for entry in factor.solve(derivative[:, n])]
    finish(folder, robot.name, "jacobian", "M^-1 d(f - M qdd)", x, steps.taken, [*solution, *columns])


class Steps:
    """List of assignments in order."""

    def __init__(self, taken):
        self.taken, self.names = list(taken), sp.numbered_symbols("s")

    def hold(self, e):
        """Returns a name for the value, unless it is a name or a number already."""
        if e.is_Atom:
            return e
        name = next(self.names)
        self.taken.append((name, e))
        return name


class Factor:
    """Factorisation `M = L^T D L` from the tip to the root; `lower` is the lower triangle, row by row."""

    def __init__(self, steps, lower):
        entries = iter(lower)
        self.steps = steps
        self.rows, self.inverse = [], []
        while len(self.rows) * (len(self.rows) + 1) // 2 < len(lower):
            self.rows.append([steps.hold(next(entries)) for _ in range(len(self.rows) + 1)])
        self.inverse = [None] * len(self.rows)
        for k in reversed(range(len(self.rows))):
            row = self.rows[k]
            self.inverse[k] = steps.hold(1 / row[k])
            for i in reversed(range(k)):
                quotient = steps.hold(row[i] * self.inverse[k])
                for j in range(i + 1):
                    self.rows[i][j] = steps.hold(self.rows[i][j] - quotient * row[j])
                row[i] = quotient

    def solve(self, right):
        x = [self.steps.hold(entry) for entry in right]
        for i in reversed(range(len(x))):
            for j in range(i):
                x[j] = self.steps.hold(x[j] - self.rows[i][j] * x[i])
        for i in range(len(x)):
            x[i] = self.steps.hold(x[i] * self.inverse[i])
            for j in range(i):
                x[i] = self.steps.hold(x[i] - self.rows[i][j] * x[j])
        return x


def kane_robot(robot):
    """Mass matrix, forces and state, by the tools of `sympy.physics.mechanics`."""
    count = len(robot.bodies)
    q, u = dynamicsymbols(f"q0:{count}"), dynamicsymbols(f"u0:{count}")
    ground, axle = ReferenceFrame("N"), Point("O")
    axle.set_vel(ground, 0)
    frame, bodies, loads = ground, [], []
    for n, link in enumerate(robot.bodies):
        seat, turning = ReferenceFrame(f"S{n}"), ReferenceFrame(f"B{n}")
        seat.orient_explicit(frame, sp.Matrix(link.turn))
        seat.set_ang_vel(frame, 0)
        joint = axle.locatenew(f"J{n}", vector(link.at, frame))
        joint.v2pt_theory(axle, ground, frame)
        axle, frame = joint, turning
        axis = vector(link.axis, seat)
        frame.orient_axis(seat, q[n], axis)
        frame.set_ang_vel(seat, u[n] * axis)
        centre = axle.locatenew(f"C{n}", vector(link.com, frame))
        centre.v2pt_theory(axle, ground, frame)
        i = link.inertia
        about = inertia(frame, i[0][0], i[1][1], i[2][2], i[0][1], i[1][2], i[0][2])
        bodies.append(RigidBody(f"body{n}", centre, frame, sp.Float(link.mass), (about, centre)))
        loads.append((centre, vector([sp.Float(link.mass) * g for g in robot.gravity], ground)))
    method = KanesMethod(ground, q, u, kd_eqs=[a.diff() - b for a, b in zip(q, u)])
    method.kanes_equations(bodies, loads)
    x = sp.Matrix(sp.symbols(f"x0:{2 * count}"))
    plain = dict(zip([*q, *u], x))
    return method.mass_matrix.xreplace(plain), method.forcing.xreplace(plain), x


def vector(values, frame):
    # Keep integers: a factor 1.0 would not vanish.
    return sum((sp.nsimplify(v) if v == int(v) else sp.Float(v)) * e for v, e in zip(values, frame) if v) or Vector(0)


def pendulum(folder, p):
    matrix, forces, x = kane(p)
    for name, form in [("", sp.simplify), (", sines of the two angles", lambda e: sp.expand_trig(sp.simplify(e)))]:
        a, f = matrix.applyfunc(form), forces.applyfunc(form)
        determinant = a[0, 0] * a[1, 1] - a[0, 1] * a[1, 0]
        qdd = sp.Matrix([a[1, 1] * f[0] - a[0, 1] * f[1], a[0, 0] * f[1] - a[1, 0] * f[0]]) / determinant
        add(folder, "rhs", "Kane" + name, x, qdd)
        add(folder, "rhs", "Kane, LU" + name, x, a.LUsolve(f))
        add(folder, "jacobian", "d(Kane)" + name, x, qdd, qdd.jacobian(x))
        # From M dqdd = df - dM qdd, with symbols for qdd that are substituted after the differentiation.
        symbols = sp.Matrix(sp.symbols("a1 a2"))
        lacking = (f - a * symbols).jacobian(x)
        adjugate = sp.Matrix([[a[1, 1], -a[0, 1]], [-a[1, 0], a[0, 0]]])
        by_parts = (adjugate * lacking / determinant).subs(dict(zip(symbols, qdd)))
        add(folder, "jacobian", "M^-1 d(f - M qdd)" + name, x, qdd, by_parts)


def kane(p):
    """Mass matrix, forces and state, in absolute angles, as a user of `sympy.physics.mechanics` derives them."""
    q1, q2, w1, w2 = dynamicsymbols("q1 q2 w1 w2")
    ground, upper, lower = ReferenceFrame("N"), ReferenceFrame("A"), ReferenceFrame("B")
    upper.orient_axis(ground, q1, ground.z)
    lower.orient_axis(ground, q2, ground.z)
    upper.set_ang_vel(ground, w1 * ground.z)
    lower.set_ang_vel(ground, w2 * ground.z)
    m, i, c, d, g = (sp.Float(p[name]) for name in ["m", "inertia", "c", "d", "g"])
    gamma1, gamma2 = sp.Float(p["gamma1"]), sp.Float(p["gamma2"])
    axle = Point("O")
    axle.set_vel(ground, 0)
    joint = axle.locatenew("J", -d * upper.y)
    joint.v2pt_theory(axle, ground, upper)
    bodies, loads = [], []
    for frame, at in [(upper, axle), (lower, joint)]:
        centre = at.locatenew("C" + frame.name, -c * frame.y)
        centre.v2pt_theory(at, ground, frame)
        bodies.append(RigidBody("body" + frame.name, centre, frame, m, (inertia(frame, 0, 0, i), centre)))
        loads.append((centre, -m * g * ground.y))
    between = gamma2 * (w2 - w1)
    loads += [(upper, (between - gamma1 * w1) * ground.z), (lower, -between * ground.z)]
    method = KanesMethod(ground, [q1, q2], [w1, w2], kd_eqs=[q1.diff() - w1, q2.diff() - w2])
    method.kanes_equations(bodies, loads)
    x = sp.Matrix(sp.symbols("x0:4"))
    plain = dict(zip([q1, q2, w1, w2], x))
    return method.mass_matrix.subs(plain), method.forcing.subs(plain), x


def add(folder, kind, form, x, *outputs):
    flat = [entry for output in outputs for entry in output.T]
    steps, results = sp.cse(flat, symbols=sp.numbered_symbols("t"))
    finish(folder, "eq22", kind, form, x, steps, results)


def finish(folder, model, kind, form, x, steps, results):
    lines = [f"    const double {symbol} = x[{n}];" for n, symbol in enumerate(x)]
    lines += [f"    const double {name} = {POWERS.doprint(e)};" for name, e in steps]
    lines += [f"    out[{n}] = {POWERS.doprint(e)};" for n, e in enumerate(results)]
    source = "#include <math.h>\n" + loop(len(x), len(x) // 2, "\n".join(lines))
    folder.add(model, kind, "SymPy", form, source, count([e for _, e in steps] + results))


def count(expressions):
    total = sp.count_ops(expressions, visual=True)
    amounts = {str(name): int(total.coeff(name)) for name in total.free_symbols}
    known = {"ADD", "SUB", "NEG", "MUL", "POW", "DIV", "SIN", "COS"}
    return Operations(
        additions=sum(amounts.get(name, 0) for name in ["ADD", "SUB", "NEG"]),
        # The only powers here are squares.
        multiplications=amounts.get("MUL", 0) + amounts.get("POW", 0),
        divisions=amounts.get("DIV", 0),
        sincos=max(amounts.get("SIN", 0), amounts.get("COS", 0)),
        functions=sum(amount for name, amount in amounts.items() if name not in known),
    )
