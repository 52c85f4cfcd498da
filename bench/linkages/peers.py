"""Simulates linkages and a top with MuJoCo, Pinocchio, CVODES by CasADi, and heyoka.

Argument: a folder with `task.json`, into which `results.json` is written. Timed functions have been called before. Peers
that are not installed are left out.
"""

import json
import sys
import time
from pathlib import Path

import numpy as np


def timed(call, rounds=5):
    """Minimum time of some rounds, and the last result."""
    times = []
    for _ in range(rounds):
        since = time.perf_counter()
        result = call()
        times.append(time.perf_counter() - since)
    return min(times), result


BARS = """
<mujoco>
  <option gravity="0 -9.81 0" timestep="{step}" integrator="RK4"/>
  <worldbody>
    <body name="crank">
      <joint type="hinge" axis="0 0 1" damping="0.02"/>
      <inertial pos="0.1 0 0" mass="0.5" diaginertia="2e-5 0.001666666666666667 0.001666666666666667"/>
      <body name="coupler" pos="0.2 0 0">
        <joint type="hinge" axis="0 0 1"/>
        <site name="pin" pos="0.5 0 0"/>
        <inertial pos="0.25 0 0" mass="1.1" diaginertia="0.000275 0.02291666666666667 0.02291666666666667"/>
      </body>
    </body>
    <body name="rocker" pos="0.6 0 0">
      <joint type="hinge" axis="0 0 1" damping="0.05"/>
      <site name="eye" pos="0.4 0 0"/>
      <inertial pos="0.2 0 0" mass="0.9" diaginertia="0.000144 0.012 0.012"/>
    </body>
  </worldbody>
  <equality><connect site1="pin" site2="eye"{hard}/></equality>
</mujoco>
"""


def gap(q):
    """Distance between the ends of the loop."""
    a, b, c = q[0], q[0] + q[1], q[2]
    x = 0.2 * np.cos(a) + 0.5 * np.cos(b) - 0.6 - 0.4 * np.cos(c)
    y = 0.2 * np.sin(a) + 0.5 * np.sin(b) - 0.4 * np.sin(c)
    return float(np.hypot(x, y).max())


def mujoco(task):
    import mujoco as mj
    from mujoco import rollout

    results = []
    q, v = np.array(task["bars"]["q"]), np.array(task["bars"]["v"])
    for step in task["bars"]["steps"]:
        # the stiffest time constant that MuJoCo allows is twice the step
        for kind, hard in [("as it is set", ""), ("as stiff as allowed", f' solref="{2 * step} 1" solimp="0.999 0.9999 1e-6"')]:
            model = mj.MjModel.from_xml_string(BARS.format(step=step, hard=hard))
            data = mj.MjData(model)
            data.qpos[:], data.qvel[:] = q, v
            mj.mj_forward(model, data)
            size = mj.mj_stateSize(model, mj.mjtState.mjSTATE_FULLPHYSICS)
            start = np.empty(size)
            mj.mj_getState(model, data, start, mj.mjtState.mjSTATE_FULLPHYSICS)
            count = round(task["bars"]["end"] / step)
            seconds, (states, _) = timed(lambda: rollout.rollout(model, data, start[None, :], nstep=count), 3)
            motion = states[0][:, 1:7]
            results.append(
                {
                    "scene": "bars",
                    "name": f"MuJoCo {mj.__version__}, {kind}",
                    "setting": step,
                    "seconds": seconds,
                    "evaluations": 4 * count,
                    "end": [float(motion[-1, 0]), float(motion[-1, 3])],
                    "gap": gap(motion[:, :3].T),
                }
            )
    return results


def pinocchio(task):
    import pinocchio as pin

    model = pin.Model()
    model.gravity = pin.Motion(np.array([0.0, -9.81, 0.0]), np.zeros(3))

    def body(parent, at, mass, com, inertia):
        joint = model.addJoint(parent, pin.JointModelRZ(), pin.SE3(np.eye(3), np.array(at)), "")
        model.appendBodyToJoint(joint, pin.Inertia(mass, np.array(com), np.diag(inertia)), pin.SE3.Identity())
        return joint

    crank = body(0, [0.0, 0, 0], 0.5, [0.1, 0, 0], [2e-5, 0.001666666666666667, 0.001666666666666667])
    coupler = body(crank, [0.2, 0, 0], 1.1, [0.25, 0, 0], [0.000275, 0.02291666666666667, 0.02291666666666667])
    rocker = body(0, [0.6, 0, 0], 0.9, [0.2, 0, 0], [0.000144, 0.012, 0.012])
    ends = [pin.SE3(np.eye(3), np.array([x, 0.0, 0.0])) for x in (0.5, 0.4)]
    data = model.createData()
    results = []
    for kind, gain in [("open loop", 0.0), ("with correction", 100.0)]:
        closing = pin.RigidConstraintModel(
            pin.ContactType.CONTACT_3D, model, coupler, ends[0], rocker, ends[1], pin.ReferenceFrame.LOCAL
        )
        closing.setBaumgarteCorrectorParameters(pin.BaumgarteCorrectorParameters(gain**2, 2.0 * gain))
        models, datas = pin.StdVec_RigidConstraintModel(), pin.StdVec_RigidConstraintData()
        models.append(closing)
        datas.append(closing.createData())
        pin.initConstraintDynamics(model, data, models, datas)
        settings = pin.ProximalSettings(1e-12, 1e-10, 20)
        friction = np.array([0.02, 0.0, 0.05])

        def forward(q, v):
            return pin.constraintDynamics(model, data, q, v, -friction * v, models, datas, settings)

        for step in task["bars"]["steps"]:

            def run():
                q, v = np.array(task["bars"]["q"]), np.array(task["bars"]["v"])
                motion = [q]
                for _ in range(round(task["bars"]["end"] / step)):
                    a1 = forward(q, v).copy()
                    v2 = v + step / 2 * a1
                    a2 = forward(q + step / 2 * v, v2).copy()
                    v3 = v + step / 2 * a2
                    a3 = forward(q + step / 2 * v2, v3).copy()
                    v4 = v + step * a3
                    a4 = forward(q + step * v3, v4).copy()
                    q = q + step / 6 * (v + 2 * v2 + 2 * v3 + v4)
                    v = v + step / 6 * (a1 + 2 * a2 + 2 * a3 + a4)
                    motion.append(q)
                return np.array(motion), v

            motion, v = run()
            q = np.array(task["bars"]["q"])
            calls = 10_000
            seconds, _ = timed(lambda: [forward(q, v) for _ in range(calls)], 3)
            count = 4 * round(task["bars"]["end"] / step)
            results.append(
                {
                    "scene": "bars",
                    "name": f"Pinocchio {pin.__version__}, {kind}",
                    "setting": step,
                    # time of the calls alone, from Python
                    "seconds": seconds / calls * count,
                    "evaluations": count,
                    "end": [float(motion[-1, 0]), float(v[0])],
                    "gap": gap(motion.T),
                }
            )
    return results


def casadi(task):
    """Andrews' mechanism as seven bodies, whose accelerations are solved together with six multipliers."""
    import casadi as ca

    scene = task["andrews"]
    bodies, loops = scene["bodies"], scene["loops"]
    n = len(bodies)
    q, v = ca.SX.sym("q", n), ca.SX.sym("v", n)
    frames = []
    for k, body in enumerate(bodies):
        at, angle = (ca.SX.zeros(2), 0) if body["parent"] < 0 else frames[body["parent"]]

        def turned(angle, p):
            c, s = ca.cos(angle), ca.sin(angle)
            return ca.vertcat(c * p[0] - s * p[1], s * p[0] + c * p[1])

        frames.append((at + turned(angle, body["at"]), angle + q[k]))

    def point(k, p):
        if k < 0:
            return ca.SX(p[:2])
        at, angle = frames[k]
        return at + turned(angle, p)

    kinetic, potential = 0, 0
    for k, body in enumerate(bodies):
        velocity = ca.jtimes(point(k, body["com"]), q, v)
        spin = ca.jtimes(ca.SX(frames[k][1]), q, v)
        kinetic += 0.5 * body["mass"] * ca.dot(velocity, velocity) + 0.5 * body["inertia"] * spin**2
    for spring in scene["springs"]:
        apart = point(spring["a"], spring["at_a"]) - point(spring["b"], spring["at_b"])
        potential += 0.5 * spring["k"] * (ca.norm_2(apart) - spring["l0"]) ** 2
    momentum = ca.gradient(kinetic, v)
    mass = ca.jacobian(momentum, v)
    force = ca.SX(scene["torque"]) - ca.gradient(potential, q) + ca.gradient(kinetic, q) - ca.jtimes(momentum, q, v)
    closed = ca.vertcat(*[point(loop["a"], loop["at_a"]) - point(loop["b"], loop["at_b"]) for loop in loops])
    across = ca.jacobian(closed, q)
    bend = ca.jtimes(ca.jtimes(closed, q, v), q, v)
    whole = ca.blockcat([[mass, across.T], [across, ca.SX.zeros(closed.numel(), closed.numel())]])
    parts = ca.Function("parts", [q, v], [whole, ca.vertcat(force, -bend)])
    x = ca.MX.sym("x", 2 * n)
    matrix, right = parts(x[:n], x[n:])
    rates = ca.vertcat(x[n:], ca.solve(matrix, right, "qr")[:n])
    results = []
    start = np.array(scene["start"])
    for tolerance in scene["tolerances"]:
        options = {
            "abstol": tolerance,
            "reltol": tolerance,
            "linear_multistep_method": "adams",
            "nonlinear_solver_iteration": "functional",
            "max_num_steps": 1_000_000,
            "jit": True,
            "compiler": "shell",
            "jit_options": {"compiler": "gcc", "flags": ["-O3", "-march=native"], "verbose": False},
        }
        follow = ca.integrator("follow", "cvodes", {"x": x, "ode": rates}, 0.0, scene["end"], options)
        seconds, end = timed(lambda: np.array(follow(x0=start)["xf"]).ravel())
        results.append(
            {
                "scene": "andrews",
                "name": f"CVODES of SUNDIALS, by CasADi {ca.__version__}",
                "setting": tolerance,
                "seconds": seconds,
                "evaluations": follow.stats().get("nfevals", 0),
                "end": [float(end[0]), float(end[n])],
                "gap": None,
            }
        )
    return results


def heyoka(task):
    import heyoka as hy

    w, x, y, z, a, b, c = hy.make_vars("w", "x", "y", "z", "a", "b", "c")
    across, along, moment = 0.234375 + 15.0, 0.46875, 15.0 * 9.81
    # direction of the weight in body coordinates, times the arm
    tx = moment * 2.0 * (y * z + w * x)
    ty = -moment * 2.0 * (x * z - w * y)
    equations = [
        (w, 0.5 * (-x * a - y * b - z * c)),
        (x, 0.5 * (w * a + y * c - z * b)),
        (y, 0.5 * (w * b + z * a - x * c)),
        (z, 0.5 * (w * c + x * b - y * a)),
        (a, (tx - (along - across) * b * c) / across),
        (b, (ty - (across - along) * c * a) / across),
        (c, 0.0 * a),
    ]
    results = []
    for tolerance in task["top"]["tolerances"]:
        integrator = hy.taylor_adaptive(equations, task["top"]["start"], tol=tolerance)

        def run():
            integrator.time = 0.0
            integrator.state[:] = task["top"]["start"]
            integrator.propagate_until(task["top"]["end"])
            return integrator.state.copy()

        run()
        seconds, end = timed(run, 20)
        results.append(
            {
                "scene": "top",
                "name": f"heyoka {hy.__version__}",
                "setting": tolerance,
                "seconds": seconds,
                "evaluations": 0,
                "end": [float(v) for v in end],
                "gap": abs(float(np.linalg.norm(end[:4])) - 1.0),
            }
        )
    return results


def main():
    folder = Path(sys.argv[1])
    task = json.loads((folder / "task.json").read_text())
    results = []
    for peer in (mujoco, pinocchio, casadi, heyoka):
        try:
            results += peer(task)
        except ImportError as error:
            print(f"{peer.__name__} is left out: {error}", file=sys.stderr)
    (folder / "results.json").write_text(json.dumps(results))


main()
