"""Jansen's leg with MuJoCo and Pinocchio: the largest distance of the joints that close its loops, over ten seconds."""

import mujoco as mj
import numpy as np
import pinocchio as pin

END, STEP = 10.0, 1e-3
STALL, FAST = 2.0, 12.0
#: Gap at which a leg counts as apart, in m.
APART = 1.0
#: Bodies in the order of their angles: name, parent, place of the joint, ends of their rods.
BODIES = [
    ("crank", None, [0.0, 0.0], [[0.15, 0.0]]),
    ("upper", "crank", [0.15, 0.0], [[0.5, 0.0]]),
    ("rocker", None, [-0.38, -0.078], [[0.415, 0.0], [0.0261, 0.4001]]),
    ("lower", "crank", [0.15, 0.0], [[0.619, 0.0]]),
    ("knee", None, [-0.38, -0.078], [[0.393, 0.0]]),
    ("shin", "rocker", [0.0261, 0.4001], [[0.394, 0.0]]),
    ("foot", "knee", [0.393, 0.0], [[0.367, 0.0], [-0.0775, 0.4838]]),
]
CLOSED = [("upper", 0.5, "rocker", 0.415), ("lower", 0.619, "knee", 0.393), ("shin", 0.394, "foot", 0.367)]
GUESS = np.array([0.5, 2.1, 1.4, -2.7, -1.2, -2.4, -2.3])
PLACES = [name for name, *_ in BODIES]


def inertia(ends):
    """Mass, centre and moment about it of rods of 0.2 kg from the origin."""
    ends = np.array(ends)
    mass, centre = 0.2 * len(ends), ends.mean(axis=0) / 2
    return mass, centre, float(sum(0.2 * end @ end / 3 for end in ends) - mass * centre @ centre)


def gaps(q):
    """Vectors between the ends of each loop, one row for each."""
    frames = {}
    for (name, parent, at, _), angle in zip(BODIES, q):
        place, turned = frames.get(parent, (np.zeros(2), 0.0))
        cos, sin = np.cos(turned), np.sin(turned)
        frames[name] = (place + np.array([cos * at[0] - sin * at[1], sin * at[0] + cos * at[1]]), turned + angle)

    def end(body, length):
        place, angle = frames[body]
        return place + length * np.array([np.cos(angle), np.sin(angle)])

    return np.array([end(a, at) - end(b, on) for a, at, b, on in CLOSED])


def assembled():
    """Angles at which the loops are closed, with the crank at 0.5 rad."""
    q, h = GUESS.copy(), 1e-7
    for _ in range(20):
        columns = [(gaps(q + h * e) - gaps(q - h * e)).ravel() / (2 * h) for e in np.eye(7)[1:]]
        q[1:] -= np.linalg.solve(np.array(columns).T, gaps(q).ravel())
    return q


def widest(q):
    return float(np.linalg.norm(gaps(q), axis=1).max())


def scene(option, connect):
    children = {name: "" for name, *_ in BODIES}
    text = ""
    for name, parent, at, ends in reversed(BODIES):
        mass, centre, moment = inertia(ends)
        damping = STALL / FAST if name == "crank" else 0.0
        body = (
            f'<body name="{name}" pos="{at[0]} {at[1]} 0"><joint name="{name}" type="hinge" axis="0 0 1" damping="{damping}"/>'
            f'<inertial pos="{centre[0]} {centre[1]} 0" mass="{mass}" diaginertia="{moment / 2} {moment / 2} {moment}"/>'
        )
        for k, (a, at_a, b, at_b) in enumerate(CLOSED):
            for other, length in ((a, at_a), (b, at_b)):
                if other == name:
                    body += f'<site name="{name}{k}" pos="{length} 0 0"/>'
        body += children[name] + "</body>"
        if parent:
            children[parent] = body + children[parent]
        else:
            text = body + text
    closing = "".join(
        f'<connect site1="{a}{k}" site2="{b}{k}" {connect}/>' for k, (a, _, b, _) in enumerate(CLOSED)
    )
    return (
        f'<mujoco><option gravity="0 -9.81 0" timestep="{STEP}" {option}/><worldbody>{text}</worldbody>'
        f'<actuator><motor joint="crank"/></actuator><equality>{closing}</equality></mujoco>'
    )


def by_mujoco(name, option, connect):
    model = mj.MjModel.from_xml_string(scene(option, connect))
    data = mj.MjData(model)
    places = [model.joint(body).qposadr[0] for body in PLACES]
    data.qpos[places] = assembled()
    data.ctrl[0] = STALL
    largest = 0.0
    for _ in range(round(END / STEP)):
        mj.mj_step(model, data)
        largest = max(largest, widest(data.qpos[places]))
    turns = (data.qpos[places[0]] - 0.5) / (2 * np.pi)
    return (f"MuJoCo {mj.__version__}, {name}", largest, f"the joints part by {largest:.0e} m in {turns:.0f} turns")


def by_pinocchio(name, gain):
    model = pin.Model()
    model.gravity = pin.Motion(np.array([0.0, -9.81, 0.0]), np.zeros(3))
    joints = {None: 0}
    for body, parent, at, ends in BODIES:
        mass, centre, moment = inertia(ends)
        place = pin.SE3(np.eye(3), np.array([*at, 0.0]))
        joints[body] = model.addJoint(joints[parent], pin.JointModelRZ(), place, body)
        own = pin.Inertia(mass, np.array([*centre, 0.0]), np.diag([moment / 2, moment / 2, moment]))
        model.appendBodyToJoint(joints[body], own, pin.SE3.Identity())
    models, datas = pin.StdVec_RigidConstraintModel(), pin.StdVec_RigidConstraintData()
    for a, at_a, b, at_b in CLOSED:
        ends = [pin.SE3(np.eye(3), np.array([x, 0.0, 0.0])) for x in (at_a, at_b)]
        closing = pin.RigidConstraintModel(
            pin.ContactType.CONTACT_3D, model, joints[a], ends[0], joints[b], ends[1], pin.ReferenceFrame.LOCAL
        )
        closing.setBaumgarteCorrectorParameters(pin.BaumgarteCorrectorParameters(gain**2, 2.0 * gain))
        models.append(closing)
        datas.append(closing.createData())
    data = model.createData()
    pin.initConstraintDynamics(model, data, models, datas)
    settings = pin.ProximalSettings(1e-12, 1e-10, 20)
    # angles are in the order of the joints, which is that of `model.names`
    order = [joints[body] - 1 for body in PLACES]
    motor = joints["crank"] - 1

    def forward(q, v):
        torque = np.zeros(7)
        torque[motor] = STALL * (1.0 - v[motor] / FAST)
        return pin.constraintDynamics(model, data, q, v, torque, models, datas, settings).copy()

    q, v, largest = np.zeros(7), np.zeros(7), 0.0
    q[order] = assembled()
    for step in range(round(END / STEP)):
        a1 = forward(q, v)
        v2 = v + STEP / 2 * a1
        a2 = forward(q + STEP / 2 * v, v2)
        v3 = v + STEP / 2 * a2
        a3 = forward(q + STEP / 2 * v2, v3)
        v4 = v + STEP * a3
        a4 = forward(q + STEP * v3, v4)
        q, v = q + STEP / 6 * (v + 2 * v2 + 2 * v3 + v4), v + STEP / 6 * (a1 + 2 * a2 + 2 * a3 + a4)
        largest = float(np.maximum(largest, widest(q[order])))
        # also where it is not a number
        if not largest <= APART:
            text = f"the leg comes apart after {(step + 1) * STEP:.1f} s"
            return (f"Pinocchio {pin.__version__}, {name}", APART, text)
    turns = (q[motor] - 0.5) / (2 * np.pi)
    return (f"Pinocchio {pin.__version__}, {name}", largest, f"the joints part by {largest:.0e} m in {turns:.0f} turns")


def answers():
    stiff = f'solref="{2 * STEP} 1" solimp="0.999 0.9999 1e-6"'
    return [
        by_mujoco("as it is set", "", ""),
        by_mujoco("as stiff as allowed", 'integrator="RK4"', stiff),
        by_pinocchio("Runge-Kutta without correction", 0.0),
        by_pinocchio("Runge-Kutta with a correction (Baumgarte) of 600 1/s", 600.0),
    ]
