"""C code by CasADi: several forms of the same dynamics, as none is the fastest for all models."""

import casadi as cs
import featherstone
from candidate import Operations, loop
from robot import double_pendulum

ADDITIONS = {cs.OP_ADD, cs.OP_SUB, cs.OP_NEG, cs.OP_TWICE}
MULTIPLICATIONS = {cs.OP_MUL, cs.OP_SQ}
DIVISIONS = {cs.OP_DIV, cs.OP_INV}
FREE = {cs.OP_CONST, cs.OP_INPUT, cs.OP_OUTPUT, cs.OP_PARAMETER}


def write(folder, robots, pendulum):
    for robot in robots:
        add(folder, robot.name, flying_forms(robot) if robot.flies else robot_forms(robot))
        if robot.point:
            add(folder, robot.name, point_forms(robot), "point")
    add(folder, "eq22", pendulum_forms(pendulum))


def robot_forms(robot):
    count = len(robot.bodies)
    x = cs.SX.sym("x", 2 * count)
    links = featherstone.links(robot, x[:count])
    rows = featherstone.mass_matrix(links)
    rates = x[count:]
    applied = -cs.SX(cs.DM([body.damping for body in robot.bodies])) * rates

    def torques(qdd):
        return featherstone.inverse_dynamics(robot, links, rates, qdd)

    return forms(x, rows, torques, applied, featherstone.articulated(robot, links, rates, applied))


def flying_forms(robot):
    """Converts the state of the generated code, with position and velocity in the ground frame."""
    joints = len(robot.bodies) - 1
    x = cs.SX.sym("x", 13 + 2 * joints)
    q, v = x[3 : 7 + joints], cs.vertcat(cs.SX(3, 1), x[10 + joints :])
    links = featherstone.links(robot, q)
    none = cs.SX.zeros(6 + joints)

    def in_ground(qdd):
        return cs.vertcat(links[0].turn @ qdd[:3], qdd[3:])

    yield "ABA", x, in_ground(featherstone.articulated(robot, links, v, none)), None
    lacking = -featherstone.inverse_dynamics(robot, links, v, none)
    yield "CRBA + LDLt", x, in_ground(featherstone.Factor(featherstone.mass_matrix(links)).solve(lacking)), None


def point_forms(robot):
    """Name, state, position and its Jacobian: by derivatives of two graphs, and by the textbook formula of the columns."""
    count = len(robot.bodies)
    x = cs.SX.sym("x", 2 * count)
    q = x[:count]
    links = featherstone.links(robot, q)
    frames = featherstone.frames(links)
    point = featherstone.vector(robot.point)
    last, turn = frames[-1]
    place = last + turn @ point
    for name, position in [("frames", place), ("nested", featherstone.carried(links, point))]:
        yield f"d({name})", x, position, cs.jacobian(position, q)
        yield f"d({name}), backward", x, position, cs.jtimes(position, q, cs.SX.eye(3), True).T
    columns = [cs.cross(turn @ link.axis, place - origin) for link, (origin, turn) in zip(links, frames)]
    yield "z x (p - o)", x, place, cs.horzcat(*columns)


def forms(x, rows, torques, applied, articulated):
    """Name, state, qdd and its Jacobian (or none) for each form; `torques(qdd)` computes inverse dynamics."""
    count = x.shape[0] // 2
    factor = featherstone.Factor(rows)
    composite = factor.solve(applied - torques(cs.SX.zeros(count)))
    yield "ABA", x, articulated, None
    yield "CRBA + LDLt", x, composite, None
    yield "d(ABA)", x, articulated, cs.jacobian(articulated, x)
    yield "d(CRBA + LDLt)", x, composite, cs.jacobian(composite, x)
    # From M dqdd = -dRNEA at fixed qdd; forward and reverse differentiation yield graphs of different size.
    a = cs.SX.sym("a", count)
    lacking = applied - torques(a)
    for name, derivative in [
        ("forward", cs.jtimes(lacking, x, cs.SX.eye(2 * count))),
        ("backward", cs.jtimes(lacking, x, cs.SX.eye(count), True).T),
    ]:
        yield f"-M^-1 dRNEA, {name}", x, composite, factor.solve(cs.substitute(derivative, a, composite))


def pendulum_forms(p):
    """Forms in absolute angles. The recursions use relative angles; the second is the difference."""
    x = cs.SX.sym("x", 4)
    relative = cs.vertcat(x[0], x[1] - x[0], x[2], x[3] - x[2])
    chain = double_pendulum(p)
    links = featherstone.links(chain, relative[:2])
    rub = -cs.vertcat(p["gamma1"] * relative[2], p["gamma2"] * relative[3])

    def absolute(qdd):
        return cs.vertcat(qdd[0], qdd[0] + qdd[1])

    aba = absolute(featherstone.articulated(chain, links, relative[2:], rub))
    bias = featherstone.inverse_dynamics(chain, links, relative[2:], cs.SX.zeros(2))
    crba = absolute(featherstone.Factor(featherstone.mass_matrix(links)).solve(rub - bias))
    yield "ABA", x, aba, None
    yield "CRBA + LDLt", x, crba, None
    yield "d(ABA)", x, aba, cs.jacobian(aba, x)
    yield "d(CRBA + LDLt)", x, crba, cs.jacobian(crba, x)
    for name, difference in [("Lagrange", None), ("Lagrange, sines of the two angles", True)]:
        rows, torques, applied = lagrange(p, x, difference)
        for form, state, qdd, jacobian in forms(x, rows, torques, applied, crba):
            if "ABA" not in form:
                yield form.replace("CRBA + LDLt", "LDLt").replace("RNEA", "f") + f", {name}", state, qdd, jacobian


def lagrange(p, x, expanded):
    """Mass matrix and forces of the textbooks."""
    mass, c, d = p["m"], p["c"], p["d"]
    mixed = mass * c * d
    s1, s2 = cs.sin(x[0]), cs.sin(x[1])
    if expanded:
        c1, c2 = cs.cos(x[0]), cs.cos(x[1])
        sine, cosine = s1 * c2 - c1 * s2, c1 * c2 + s1 * s2
    else:
        sine, cosine = cs.sin(x[0] - x[1]), cs.cos(x[0] - x[1])
    tip = p["inertia"] + mass * c * c
    rows = [[tip + mass * d * d, cs.SX(0)], [mixed * cosine, tip]]
    weight = mass * c * p["g"]
    bias = cs.vertcat(
        mixed * sine * x[3] ** 2 + (weight + mass * d * p["g"]) * s1,
        weight * s2 - mixed * sine * x[2] ** 2,
    )
    between = p["gamma2"] * (x[3] - x[2])
    applied = cs.vertcat(between - p["gamma1"] * x[2], -between)

    def torques(qdd):
        m11, m21, m22 = rows[0][0], rows[1][0], rows[1][1]
        return cs.vertcat(m11 * qdd[0] + m21 * qdd[1], m21 * qdd[0] + m22 * qdd[1]) + bias

    return rows, torques, applied


def add(folder, model, forms, derived="jacobian"):
    """Adds the forms; `derived` names the forms with a Jacobian."""
    for form, x, values, jacobian in forms:
        outputs = values if jacobian is None else cs.vertcat(values, cs.vec(cs.densify(jacobian)))
        # The graph was simplified while it was built; here inverses must be preserved.
        cs.GlobalOptions.setSimplificationOnTheFly(False)
        function = cs.Function("f", [x], [cs.densify(cs.cse(outputs))])
        cs.GlobalOptions.setSimplificationOnTheFly(True)
        kind = "rhs" if jacobian is None else derived
        folder.add(model, kind, "CasADi", form, code(function, x.shape[0], values.shape[0]), count(function))


def code(function, length, values):
    generator = cs.CodeGenerator("f.c", {"with_export": False})
    generator.add(function)
    body = "    const double *arg[1] = {x};\n    double *res[1] = {out};\n    casadi_f0(arg, res, 0, 0, 0);"
    return generator.dump() + loop(length, values, body)


def count(function):
    kinds = [function.instruction_id(n) for n in range(function.n_instructions())]
    known = ADDITIONS | MULTIPLICATIONS | DIVISIONS | FREE | {cs.OP_SIN, cs.OP_COS}
    return Operations(
        additions=sum(kind in ADDITIONS for kind in kinds),
        multiplications=sum(kind in MULTIPLICATIONS for kind in kinds),
        divisions=sum(kind in DIVISIONS for kind in kinds),
        sincos=max(kinds.count(cs.OP_SIN), kinds.count(cs.OP_COS)),
        functions=sum(kind not in known for kind in kinds),
    )
