"""The standard algorithms on CasADi's scalar graphs: recursive Newton-Euler, composite and articulated bodies.

After R. Featherstone, Rigid Body Dynamics Algorithms (2008), chapters 5 to 8. The PyPI wheel of Pinocchio has no bindings
to CasADi, so the graphs are built here. All quantities are in the frame of their body, as in Pinocchio, and all joints are
revolute, except for a floating first body: it has a quaternion, and rates in its own frame.
"""

import casadi as cs


def vector(values):
    return cs.SX(cs.DM(values))


def skew(a):
    """Matrix of the cross product with `a`."""
    return cs.vertcat(
        cs.horzcat(0, -a[2], a[1]),
        cs.horzcat(a[2], 0, -a[0]),
        cs.horzcat(-a[1], a[0], 0),
    )


def scaled(inverse, a):
    """Product with an inverse, which CasADi would otherwise simplify from `(1 / d) x` to a division `x / d`."""
    a = cs.sparsify(a)
    cs.GlobalOptions.setSimplificationOnTheFly(False)
    product = inverse * a
    cs.GlobalOptions.setSimplificationOnTheFly(True)
    return cs.densify(product)


def symmetric(a):
    """Mirrors the lower triangle of `a`, and discards the upper one."""
    return cs.tril2symm(cs.tril(a))


class Link:
    """Parameters of a body, and the rotation from its frame to its parent's."""

    def __init__(self, body, q):
        self.parent = body.parent
        self.flies = body.axis is None
        self.at = vector(body.at)
        self.mass = body.mass
        com = cs.DM(body.com)
        self.moment = cs.SX(body.mass * com)
        self.inertia = cs.SX(cs.DM(body.inertia) + body.mass * (cs.dot(com, com) * cs.DM.eye(3) - com @ com.T))
        if self.flies:
            self.turn = of_quaternion(q)
            return
        self.axis = vector(body.axis)
        s, c = cs.sin(q), cs.cos(q)
        turn = c * cs.SX.eye(3) + s * skew(self.axis) + (1 - c) * (self.axis @ self.axis.T)
        # About a coordinate axis, `c + (1 - c)` would stay in the graph.
        along = [n for n in range(3) if abs(body.axis[n]) == 1]
        for n in along:
            turn[n, n] = 1
        self.turn = vector(body.turn) @ turn


def of_quaternion(q):
    """Rotation from the frame of a body by its unit quaternion, scalar part first."""
    w, x, y, z = (q[n] for n in range(4))
    return cs.vertcat(
        cs.horzcat(1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)),
        cs.horzcat(2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)),
        cs.horzcat(2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)),
    )


def links(robot, q):
    """Splits the positions into the quaternion of a floating body and the joint angles."""
    if not robot.flies:
        return [Link(body, q[n]) for n, body in enumerate(robot.bodies)]
    first, *others = robot.bodies
    return [Link(first, q[:4])] + [Link(body, q[4 + n]) for n, body in enumerate(others)]


def frames(links):
    """Origin and rotation of each body in the frame of the ground."""
    found = []
    for link in links:
        if link.parent < 0:
            found.append((link.at, link.turn))
        else:
            origin, turn = found[link.parent]
            found.append((origin + turn @ link.at, turn @ link.turn))
    return found


def carried(links, point):
    """A point of the last body in the frame of the ground, from body to body."""
    n = len(links) - 1
    while n >= 0:
        point = links[n].at + links[n].turn @ point
        n = links[n].parent
    return point


def rates_of(links, v):
    """Splits a vector by joints; a floating first body has two vectors, along and about its axes."""
    if not links[0].flies:
        return [v[n] for n in range(len(links))]
    return [(v[:3], v[3:6])] + [v[6 + n] for n in range(len(links) - 1)]


def whirl_of(rate, turning):
    """Matrix `whirl` for which a point at `p` has the acceleration of the origin plus `whirl p`."""
    return skew(turning) + (rate @ rate.T - cs.dot(rate, rate) * cs.SX.eye(3))


def inverse_dynamics(robot, links, qd, qdd):
    """Recursive Newton-Euler algorithm (RNEA): joint torques."""
    motions = []
    qd, qdd = rates_of(links, qd), rates_of(links, qdd)
    for n, link in enumerate(links):
        if link.flies:
            # independent of its linear velocity
            rate, turning, pull = qd[n][1], qdd[n][1], qdd[n][0] - link.turn.T @ vector(robot.gravity)
            motions.append((rate, turning, pull, whirl_of(rate, turning)))
            continue
        if link.parent < 0:
            rate, turning, pull = cs.SX(3, 1), cs.SX(3, 1), -vector(robot.gravity)
        else:
            rate, turning, pull, whirl = motions[link.parent]
            pull = pull + whirl @ link.at
        back = link.turn.T
        rate, turning, pull = back @ rate, back @ turning, back @ pull
        spin = link.axis * qd[n]
        turning = turning + link.axis * qdd[n] + cs.cross(rate, spin)
        rate = rate + spin
        motions.append((rate, turning, pull, whirl_of(rate, turning)))
    wrenches = []
    for link, (rate, turning, pull, whirl) in zip(links, motions):
        momentum = link.inertia @ rate
        torque = link.inertia @ turning + cs.cross(rate, momentum) + cs.cross(link.moment, pull)
        wrenches.append([torque, link.mass * pull + whirl @ link.moment])
    torques = [None] * len(links)
    for n in reversed(range(len(links))):
        link = links[n]
        torque, force = wrenches[n]
        torques[n] = cs.vertcat(force, torque) if link.flies else cs.dot(link.axis, torque)
        if link.parent >= 0:
            force = link.turn @ force
            wrenches[link.parent][0] += link.turn @ torque + cs.cross(link.at, force)
            wrenches[link.parent][1] += force
    return cs.vertcat(*torques)


def mass_matrix(links):
    """Composite rigid bodies (CRBA): rows of the lower triangle."""
    count = len(links)
    composite = [[link.mass, link.moment, link.inertia] for link in links]
    before = 5 if links[0].flies else 0
    rows = [[cs.SX(0)] * (count + before) for _ in range(count + before)]
    for n in reversed(range(count)):
        link = links[n]
        mass, moment, inertia = composite[n]
        if link.flies:
            block = cs.blockcat([[mass * cs.SX.eye(3), -skew(moment)], [skew(moment), inertia]])
            for i in range(6):
                rows[i][: i + 1] = [block[i, j] for j in range(i + 1)]
            continue
        torque, force = inertia @ link.axis, cs.cross(link.axis, moment)
        rows[n + before][n + before] = cs.dot(link.axis, torque)
        at = n
        while links[at].parent >= 0:
            force = links[at].turn @ force
            torque = links[at].turn @ torque + cs.cross(links[at].at, force)
            at = links[at].parent
            if links[at].flies:
                both = cs.vertcat(force, torque)
                rows[n + before][:6] = [both[j] for j in range(6)]
            else:
                rows[n + before][at + before] = cs.dot(links[at].axis, torque)
        if link.parent >= 0:
            onto = composite[link.parent]
            turned = link.turn @ moment
            both = link.at @ turned.T
            shift = 2 * cs.trace(both) * cs.SX.eye(3) - both - both.T
            steiner = mass * (cs.dot(link.at, link.at) * cs.SX.eye(3) - link.at @ link.at.T)
            onto[0] = onto[0] + mass
            onto[1] = onto[1] + turned + mass * link.at
            onto[2] = symmetric(onto[2] + link.turn @ inertia @ link.turn.T + shift + steiner)
    return rows


class Factor:
    """Factorisation `M = L^T D L` from the tips to the root, which preserves the sparsity of trees."""

    def __init__(self, rows):
        rows = [list(row) for row in rows]
        self.rows, self.inverse = rows, [None] * len(rows)
        for k in reversed(range(len(rows))):
            self.inverse[k] = 1 / rows[k][k]
            for i in reversed(range(k)):
                if rows[k][i].is_zero():
                    continue
                quotient = scaled(self.inverse[k], rows[k][i])
                for j in range(i + 1):
                    rows[i][j] = rows[i][j] - quotient * rows[k][j]
                rows[k][i] = quotient

    def solve(self, right):
        x = [right[n, :] for n in range(right.shape[0])]
        for i in reversed(range(len(x))):
            for j in range(i):
                x[j] = x[j] - self.rows[i][j] * x[i]
        for i in range(len(x)):
            x[i] = scaled(self.inverse[i], x[i])
            for j in range(i):
                x[i] = x[i] - self.rows[i][j] * x[j]
        return cs.vertcat(*x)


def articulated(robot, links, qd, tau):
    """Articulated bodies (ABA): joint accelerations. Inertias are blocks: rotation, coupling, translation."""
    count = len(links)
    rates, drifts, inertias, biases = [], [], [], []
    qd = rates_of(links, qd)
    for n, link in enumerate(links):
        # independent of the linear velocity of a floating body
        spin = qd[n][1] if link.flies else link.axis * qd[n]
        rate, speed = spin, cs.SX(3, 1)
        if link.parent >= 0:
            turning, shifting = rates[link.parent]
            rate = link.turn.T @ turning + spin
            speed = link.turn.T @ (shifting + cs.cross(turning, link.at))
        rates.append((rate, speed))
        drifts.append((cs.cross(rate, spin), cs.cross(speed, spin)))
        momentum = link.mass * speed + cs.cross(rate, link.moment)
        angular = link.inertia @ rate + cs.cross(link.moment, speed)
        biases.append([cs.cross(rate, angular) + cs.cross(speed, momentum), cs.cross(rate, momentum)])
        inertias.append([link.inertia, skew(link.moment), link.mass * cs.SX.eye(3)])
    pivots = [None] * count
    for n in reversed(range(count)):
        link = links[n]
        (turning, mixed, shifting), (torque, force) = inertias[n], biases[n]
        if link.flies:
            block = cs.blockcat([[shifting, mixed.T], [mixed, turning]])
            factor = Factor([[block[i, j] for j in range(6)] for i in range(6)])
            pivots[n] = factor.solve(-cs.vertcat(force, torque))
            continue
        u, v = turning @ link.axis, mixed.T @ link.axis
        inverse = 1 / cs.dot(link.axis, u)
        rest = tau[n] - cs.dot(link.axis, torque)
        pivots[n] = (u, v, inverse, rest)
        if link.parent < 0:
            continue
        turning = symmetric(turning - inverse * (u @ u.T))
        mixed = mixed - inverse * (u @ v.T)
        shifting = symmetric(shifting - inverse * (v @ v.T))
        (drift, slide), share = drifts[n], inverse * rest
        torque = torque + turning @ drift + mixed @ slide + u * share
        force = force + mixed.T @ drift + shifting @ slide + v * share
        # transform to the parent's frame and origin
        turn, cross = link.turn, skew(link.at)
        shifting = symmetric(turn @ shifting @ turn.T)
        mixed = turn @ mixed @ turn.T
        turning = turn @ turning @ turn.T
        lever = mixed @ cross
        onto = inertias[link.parent]
        onto[0] = symmetric(onto[0] + turning - lever - lever.T - cross @ shifting @ cross)
        onto[1] = onto[1] + mixed + cross @ shifting
        onto[2] = onto[2] + shifting
        force = turn @ force
        biases[link.parent][0] += turn @ torque + cs.cross(link.at, force)
        biases[link.parent][1] += force
    qdd, accelerations = [], []
    for n, link in enumerate(links):
        turning, pull = cs.SX(3, 1), -vector(robot.gravity)
        if link.flies:
            pull, turning = pivots[n][:3], pivots[n][3:]
            qdd.append(cs.vertcat(pull + link.turn.T @ vector(robot.gravity), turning))
            accelerations.append((turning, pull))
            continue
        if link.parent >= 0:
            turning, pull = accelerations[link.parent]
            pull = pull + cs.cross(turning, link.at)
        drift, slide = drifts[n]
        turning, pull = link.turn.T @ turning + drift, link.turn.T @ pull + slide
        u, v, inverse, rest = pivots[n]
        qdd.append(inverse * (rest - cs.dot(u, turning) - cs.dot(v, pull)))
        accelerations.append((turning + link.axis * qdd[n], pull))
    return cs.vertcat(*qdd)
