"""Writes the URDF files of this folder, trimmed, and reference.json with Pinocchio's results for them. Those in `declared`
are the robots of ../robots.json, which the testbed declares by hand, with the same numbers.

Run in this folder, with `pin` 4.1 and `example-robot-data` 6.0 from PyPI: `python3 reference.py`; it takes a second.

Trimmed files contain only elements that affect the motion, with the original numbers. Like the generator, the script
snaps angles that were rounded from a multiple of 45 degrees, or are within 1e-8 of one, to that multiple, and angles
and lengths below 1e-12 to zero, in the data passed to Pinocchio. The files here keep the original values.

Robots in `FREE` have a floating root, as declared in the test; `flying.urdf` has joints of more than one coordinate in
the file. Their rates `r` differ from those of Pinocchio, whose linear velocities are along the axes of the body:
`v = S r + ..`. So the mass matrix is `S^T A S`, the bias `S^T (b + A S' r)`, and `r' = S^-1 (v' - S' r)`, where `aba`
computes `v'`.

`mass_matrix` and `bias` (velocity terms and gravity) are Pinocchio's, the energies follow from its matrix and its
frames. The acceleration is `A^-1 (Q - b)`, where Q is the friction of the joints: `-damping v - friction sign(v)`.
Coordinates are in the order of the joints in the file; joints that mimic others have none. The potential energy excludes
bodies fixed to the ground. """

import json
import math
import pathlib
import sysconfig
import xml.etree.ElementTree as ET

import numpy as np
import pinocchio as pin

ROBOTS = pathlib.Path(sysconfig.get_paths()["purelib"]) / "cmeel.prefix/share/example-robot-data/robots"
FILES = {
    "asr_twodof": "asr_twodof_description/urdf/TwoDofs.urdf",
    "baxter": "baxter_description/urdf/baxter.urdf",
    "double_pendulum": "double_pendulum_description/urdf/double_pendulum_simple.urdf",
    "finger_edu": "finger_edu_description/robots/finger_edu.urdf",
    "hextilt_arm": "hextilt_description/urdf/hextilt_flying_arm_5.urdf",
    "kinova": "kinova_description/robots/kinova.urdf",
    "panda_with_hand": "panda_description/urdf/panda.urdf",
    "so100": "so_arm_description/urdf/so100.urdf",
    "ur3": "ur_description/urdf/ur3_robot.urdf",
    "ur5": "ur_description/urdf/ur5_robot.urdf",
    "ur10": "ur_description/urdf/ur10_robot.urdf",
    "xarm7": "xarm_description/urdf/xarm7.urdf",
}
FREE = {"solo12": ("solo_description/robots/solo12.urdf", "base_link")}
KEPT = {
    "robot": ["link", "joint"],
    "link": ["inertial"],
    "inertial": ["origin", "mass", "inertia"],
    "joint": ["origin", "parent", "child", "axis", "limit", "dynamics", "mimic"],
}
SAMPLES = 3


def trim(node):
    for child in list(node):
        if child.tag in KEPT.get(node.tag, []):
            trim(child)
        else:
            node.remove(child)
    node.text = node.tail = None


def exact(text):
    """Undoes the rounding of an angle."""
    value = float(text)
    count = round(value / (math.pi / 4))
    mantissa, _, exponent = text.lower().partition("e")
    decimals = len(mantissa.partition(".")[2]) - int(exponent or 0)
    near = max(1e-8, 10.0**-decimals if decimals >= 4 else 0)
    if count and abs(value - count * math.pi / 4) <= near:
        return repr(count * math.pi / 4)
    return dust(text)


def dust(text):
    return "0" if abs(float(text)) < 1e-12 else text


def meant(robot):
    robot = ET.fromstring(ET.tostring(robot))
    for attribute, read in (("rpy", exact), ("xyz", dust)):
        for node in robot.iter():
            if attribute in node.attrib:
                node.set(attribute, " ".join(map(read, node.get(attribute).split())))
    return robot


def coefficients(joint, name):
    dynamics = joint.find("dynamics")
    return float(dynamics.get(name, 0)) if dynamics is not None else 0.0


def potential(model, data, q):
    """Potential energy of all moving bodies; Pinocchio's own function ignores mimic joints."""
    pin.forwardKinematics(model, data, q)
    places = [(body.mass, place.act(body.lever)) for body, place in zip(model.inertias, data.oMi)]
    return -sum(mass * model.gravity.linear @ place for mass, place in places[1:])


def reference(robot, random):
    model = pin.buildModelFromXML(ET.tostring(meant(robot), encoding="unicode"), True)
    data = model.createData()
    moving = [joint for joint in robot.iter("joint") if joint.get("type") not in (None, "fixed")]
    free = [joint for joint in moving if joint.find("mimic") is None]
    names = [joint.get("name") for joint in free]
    assert len(names) == model.nv
    at = [model.joints[model.getJointId(name)].idx_v for name in names]
    samples = []
    for _ in range(SAMPLES):
        ours, rates = random.uniform(-2, 2, model.nv).round(3), random.uniform(-2, 2, model.nv).round(3)
        q, v, force = np.zeros(model.nq), np.zeros(model.nv), np.zeros(model.nv)
        for name, angle, rate in zip(names, ours, rates):
            joint = model.joints[model.getJointId(name)]
            q[joint.idx_q : joint.idx_q + joint.nq] = [angle] if joint.nq == 1 else [math.cos(angle), math.sin(angle)]
            v[joint.idx_v] = rate
        for joint in moving:
            mimic = joint.find("mimic")
            leader = joint.get("name") if mimic is None else mimic.get("joint")
            factor = 1.0 if mimic is None else float(mimic.get("multiplier", 1))
            k = model.joints[model.getJointId(leader)].idx_v
            rate = factor * v[k]
            damping, friction = coefficients(joint, "damping"), coefficients(joint, "friction")
            force[k] -= factor * (damping * rate + friction * np.sign(rate))
        matrix = pin.crba(model, data, q)
        matrix = np.triu(matrix) + np.triu(matrix, 1).T
        bias = pin.nonLinearEffects(model, data, q, v)
        acceleration = np.linalg.solve(matrix, force - bias)
        samples.append(
            {
                "q": ours.tolist(),
                "qd": rates.tolist(),
                "kinetic": v @ matrix @ v / 2,
                "potential": potential(model, data, q),
                "mass_matrix": [matrix[i, at[: n + 1]].tolist() for n, i in enumerate(at)],
                "bias": bias[at].tolist(),
                "acceleration": acceleration[at].tolist(),
            }
        )
    return {"coordinates": names, "samples": samples}


def freely(robot, random, change=lambda model: None):
    """Samples of a floating robot, or one with joints of more than one coordinate. None has friction."""
    model = pin.buildModelFromXML(ET.tostring(meant(robot), encoding="unicode"))
    change(model)
    data = model.createData()
    moving = [joint for joint in robot.iter("joint") if joint.get("type") not in (None, "fixed")]
    assert all(joint.find("mimic") is None for joint in moving)
    assert all(coefficients(joint, what) == 0 for joint in moving for what in ("damping", "friction"))
    number = lambda: round(random.uniform(-2, 2), 3)
    names, samples = [], []
    for _ in range(SAMPLES):
        names, ours, rates = [], [], []
        q = np.zeros(model.nq)
        # rates of Pinocchio as function of ours, and their drift
        slopes, drift = np.zeros((model.nv, model.nv)), np.zeros(model.nv)
        for joint in moving:
            name, kind = joint.get("name"), joint.get("type")
            known = model.joints[model.getJointId(name)]
            i, j, n = known.idx_q, known.idx_v, len(rates)
            if kind == "floating":
                place, turn = [number() for _ in range(3)], np.array([number() for _ in range(4)])
                turn /= np.linalg.norm(turn)
                w, x, y, z = turn.tolist()
                velocity, spin = np.array([number() for _ in range(3)]), np.array([number() for _ in range(3)])
                back = pin.Quaternion(w, x, y, z).toRotationMatrix().T
                names += [f"{name}_position.{axis}" for axis in "xyz"] + [f"{name}_orientation"]
                ours += place + [w, x, y, z]
                rates += velocity.tolist() + spin.tolist()
                q[i : i + 7] = place + [x, y, z, w]
                slopes[j : j + 3, n : n + 3], slopes[j + 3 : j + 6, n + 3 : n + 6] = back, np.eye(3)
                drift[j : j + 3] = -np.cross(spin, back @ velocity)
            elif kind == "planar":
                # Pinocchio supports no other plane
                assert joint.find("axis").get("xyz") == "0 0 1"
                x, y, angle, turn = [number() for _ in range(4)]
                velocity = np.array([number(), number()])
                back = np.array([[math.cos(angle), math.sin(angle)], [-math.sin(angle), math.cos(angle)]])
                names += [f"{name}_{part}" for part in ("x", "y", "turn")]
                ours += [x, y, angle]
                rates += velocity.tolist() + [turn]
                q[i : i + 4] = [x, y, math.cos(angle), math.sin(angle)]
                slopes[j : j + 2, n : n + 2], slopes[j + 2, n + 2] = back, 1
                drift[j : j + 2] = turn * np.array([[0, 1], [-1, 0]]) @ back @ velocity
            else:
                angle, rate = number(), number()
                names.append(name)
                ours.append(angle)
                rates.append(rate)
                q[i : i + known.nq] = [angle] if known.nq == 1 else [math.cos(angle), math.sin(angle)]
                slopes[j, n] = 1
        v = slopes @ rates
        matrix = pin.crba(model, data, q)
        matrix = np.triu(matrix) + np.triu(matrix, 1).T
        bias = pin.nonLinearEffects(model, data, q, v)
        acceleration = pin.aba(model, data, q, v, np.zeros(model.nv))
        in_ours = slopes.T @ matrix @ slopes
        samples.append(
            {
                "q": ours,
                "qd": rates,
                "kinetic": v @ matrix @ v / 2,
                "potential": potential(model, data, q),
                "mass_matrix": [row[: n + 1].tolist() for n, row in enumerate(in_ours)],
                "bias": (slopes.T @ (bias + matrix @ drift)).tolist(),
                "acceleration": np.linalg.solve(slopes, acceleration - drift).tolist(),
            }
        )
    return {"coordinates": names, "samples": samples}


def flying(robot, root):
    """Attaches the robot to a world by a floating root."""
    flown = ET.fromstring(ET.tostring(robot))
    joint = ET.Element("joint", name="base", type="floating")
    ET.SubElement(joint, "parent", link="world")
    ET.SubElement(joint, "child", link=root)
    flown[:0] = [ET.Element("link", name="world"), joint]
    return flown


def declared(robot):
    """The URDF file of a robot of robots.json."""
    root = ET.Element("robot", name=robot["name"])
    ET.SubElement(root, "link", name="base")
    number = lambda x: {"pi/2": "1.57079632679", "-pi/2": "-1.57079632679"}.get(x) or format(x, ".12g")
    text = lambda numbers: " ".join(map(number, numbers))
    for n, body in enumerate(robot["bodies"], 1):
        link = ET.SubElement(root, "link", name=f"b{n}")
        inertial = ET.SubElement(link, "inertial")
        ET.SubElement(inertial, "origin", xyz=text(body["com"]))
        ET.SubElement(inertial, "mass", value=number(body["mass"]))
        entry = lambda a, b: number(body["inertia"]["xyz".index(a)]["xyz".index(b)])
        pairs = ("xx", "xy", "xz", "yy", "yz", "zz")
        ET.SubElement(inertial, "inertia", {f"i{pair}": entry(*pair) for pair in pairs})
        joint = ET.SubElement(root, "joint", name=f"q{n}", type=body["joint"]["type"])
        ET.SubElement(joint, "origin", xyz=text(body["joint"]["at"]), rpy=text(body["joint"]["rpy"]))
        ET.SubElement(joint, "parent", link=f"b{body['parent'] + 1}" if body["parent"] >= 0 else "base")
        ET.SubElement(joint, "child", link=f"b{n}")
        ET.SubElement(joint, "axis", xyz=text(body["joint"]["axis"]))
        ET.SubElement(joint, "limit", lower="-3", upper="3", effort="100", velocity="2")
    return root


def write(robot, path, note):
    ET.indent(robot, "  ")
    text = ET.tostring(robot, encoding="unicode").replace(" />", "/>")
    pathlib.Path(path).write_text(f"<!-- {note} -->\n{text}\n")


def main():
    pathlib.Path("declared").mkdir(exist_ok=True)
    for robot in json.loads(pathlib.Path("../robots.json").read_text())["mechanisms"]:
        write(declared(robot), f"declared/{robot['name']}.urdf", "The numbers of ../robots.json, by reference.py.")
    random = np.random.default_rng(2026)
    robots = {}
    def trimmed(name, path):
        robot = ET.parse(ROBOTS / path).getroot()
        trim(robot)
        note = f"Trimmed from {path} of example-robot-data 6.0.0; see README.md for source and licence."
        write(robot, f"{name}.urdf", note)
        return robot

    for name, path in FILES.items():
        robots[name] = reference(trimmed(name, path), random)
    made_up = ET.parse("made_up.urdf").getroot()
    robots["made_up"] = reference(made_up, random)
    for name, (path, root) in FREE.items():
        robots[name] = freely(flying(trimmed(name, path), root), random)
    robots["flying"] = freely(ET.parse("flying.urdf").getroot(), random)
    robots["geared"] = reference(ET.parse("geared.urdf").getroot(), random)
    lines = [f" {json.dumps(name)}: {json.dumps(robot)}" for name, robot in robots.items()]
    pathlib.Path("reference.json").write_text("{\n" + ",\n".join(lines) + "\n}\n")


if __name__ == "__main__":
    main()
