"""The robots of example-robot-data, or those of the folder $ROBOTS, in Pinocchio.

`compare.py files` prints the folder, and each URDF file with its root link. `compare.py compare FOLDER` reads `task.json` there, compiles
the C code beside it, and writes `errors.json`: for each robot the largest error of the accelerations and the energies at
random states, relative to the largest of each state, and the largest residual force when the accelerations are inserted
into Pinocchio's equations, relative to the largest force in them.
"""

import ctypes
import json
import os
import re
import subprocess
import sys
import xml.etree.ElementTree as ET
from pathlib import Path

import numpy as np
import pinocchio as pin

sys.path.append(str(Path(__file__).parents[2] / "testbed/data/urdf"))
import reference  # noqa: E402

reference.SAMPLES = 10
ROBOTS = Path(os.environ.get("ROBOTS", reference.ROBOTS))


def files():
    print(ROBOTS)
    for path in sorted(ROBOTS.rglob("*.urdf")):
        robot = ET.parse(path).getroot()
        carried = {child.get("link") for child in robot.iter("child")}
        roots = [link.get("name") for link in robot.findall("link") if link.get("name") not in carried]
        print(path.relative_to(ROBOTS), *roots[:1], sep="\t")


def repaired(model):
    """Clamps negative second moments of mass about the centre of mass to zero."""
    for n, body in enumerate(model.inertias):
        second = np.trace(body.inertia) / 2 * np.eye(3) - body.inertia
        values, axes = np.linalg.eigh(second)
        if n > 0 and values[0] < -max(1e-6 * np.abs(values).sum(), 1e-12 * body.mass):
            second = axes @ np.diag(values.clip(0)) @ axes.T
            model.inertias[n] = pin.Inertia(body.mass, body.lever, np.trace(second) * np.eye(3) - second)


def robot(task):
    """Reads a robot without dry friction, with joints locked and root floating as in the generated model."""
    root = ET.parse(ROBOTS / task["file"]).getroot()
    reference.trim(root)
    for element in root.iter():
        # Pinocchio's parser rejects white space behind a number
        element.attrib.update({name: value.strip() for name, value in element.attrib.items()})
    for joint in root.iter("joint"):
        if (dynamics := joint.find("dynamics")) is not None:
            dynamics.attrib.pop("friction", None)
            dynamics.set("damping", dynamics.get("damping", "0"))
        if re.sub(r"\W", "_", joint.get("name", "")) in task["held"]:
            joint.set("type", "fixed")
            for part in ("mimic", "dynamics"):
                joint.remove(joint.find(part)) if joint.find(part) is not None else None
    return reference.flying(root, task["free"]) if task["free"] else root


def sampled(robot, random, change):
    """Samples for joints of one coordinate. Mimic joints follow `q = G q' + offset`, with the independent coordinates q':
    the matrix is `G^T A G`, the bias `G^T b`. (Pinocchio's own mimic joints must follow earlier ones.)"""
    free = ET.fromstring(ET.tostring(robot))
    for joint in free.iter("joint"):
        if (mimic := joint.find("mimic")) is not None:
            joint.remove(mimic)
    model = pin.buildModelFromXML(ET.tostring(reference.meant(free), encoding="unicode"))
    change(model)
    data = model.createData()
    moving = [joint for joint in robot.iter("joint") if joint.get("type") not in (None, "fixed")]
    names = [joint.get("name") for joint in moving if joint.find("mimic") is None]
    column = {name: n for n, name in enumerate(names)}
    follow, offset, damping = np.zeros((model.nv, len(names))), np.zeros(model.nv), np.zeros(model.nv)
    by_name = {joint.get("name"): joint for joint in moving}

    def followed(joint):
        """Coordinate that a joint follows, with the factor and the offset."""
        mimic = joint.find("mimic")
        if mimic is None:
            return column[joint.get("name")], 1.0, 0.0
        leader, factor, shift = followed(by_name[mimic.get("joint")])
        own = float(mimic.get("multiplier", 1))
        return leader, own * factor, own * shift + float(mimic.get("offset", 0))

    for joint in moving:
        at = model.joints[model.getJointId(joint.get("name"))].idx_v
        leader, follow_by, offset[at] = followed(joint)
        follow[at, leader] = follow_by
        damping[at] = reference.coefficients(joint, "damping")
    samples = []
    for _ in range(reference.SAMPLES):
        ours, rates = random.uniform(-2, 2, len(names)), random.uniform(-2, 2, len(names))
        positions, v = follow @ ours + offset, follow @ rates
        q = np.zeros(model.nq)
        for joint in model.joints[1:]:
            angle = positions[joint.idx_v]
            q[joint.idx_q : joint.idx_q + joint.nq] = [angle] if joint.nq == 1 else [np.cos(angle), np.sin(angle)]
        matrix = pin.crba(model, data, q)
        matrix = follow.T @ (np.triu(matrix) + np.triu(matrix, 1).T) @ follow
        force = follow.T @ (-damping * v - pin.nonLinearEffects(model, data, q, v))
        samples.append(
            {
                "q": ours.tolist(),
                "qd": rates.tolist(),
                "kinetic": rates @ matrix @ rates / 2,
                "potential": reference.potential(model, data, q),
                "mass_matrix": [row[: n + 1].tolist() for n, row in enumerate(matrix)],
                "acceleration": np.linalg.solve(matrix, force).tolist(),
            }
        )
    return {"samples": samples}


def compare(folder, task):
    random = np.random.default_rng(40)
    root, change = robot(task), repaired if task["repair"] else lambda model: None
    many = any(joint.get("type") in ("floating", "planar") for joint in root.iter("joint"))
    samples = (reference.freely if many else sampled)(root, random, change)["samples"]
    own = folder / task["name"]
    library = own / "robot.so"
    flags = ["-std=c99", "-O1", "-ffp-contract=off", "-shared", "-fPIC", "-lm"]
    subprocess.run(["gcc", own / "robot.c", "-o", library, *flags], check=True)
    code, size = ctypes.CDLL(str(library)), len(samples[0]["q"]) + len(samples[0]["qd"])
    assert size == task["length"], f"{size} numbers in the state, not {task['length']}"
    state, out = (ctypes.c_double * size)(), (ctypes.c_double * size)()
    model = ctypes.create_string_buffer(8 * task["constants"] + 64)
    assert code.robot_new(model, ctypes.byref(ctypes.c_double.in_dll(code, "robot_defaults"))) == 0
    code.robot_kinetic.restype = code.robot_potential.restype = ctypes.c_double
    worst = {"accelerations": 0.0, "energies": 0.0, "forces": 0.0}
    first = None
    for sample in samples:
        state[:] = sample["q"] + sample["qd"]
        zero, dof = ctypes.c_double(0), len(sample["qd"])
        code.robot_rhs(model, zero, state, out)
        accelerations, theirs = np.array(out[size - dof :]), np.array(sample["acceleration"])
        energies = np.array([call(model, zero, state) for call in (code.robot_kinetic, code.robot_potential)])
        expected = np.array([sample["kinetic"], sample["potential"]])
        # Pinocchio's potential energy excludes fixed bodies
        first = energies - expected if first is None else first
        energies[1] -= first[1]
        matrix = np.zeros((dof, dof))
        for n, row in enumerate(sample["mass_matrix"]):
            matrix[n, : n + 1] = matrix[: n + 1, n] = row
        left, size_of = matrix @ (accelerations - theirs), np.abs(matrix) @ np.abs(theirs)
        errors = {
            "accelerations": np.abs(accelerations - theirs).max() / (np.abs(theirs).max() or 1),
            "energies": (np.abs(energies - expected) / (np.abs(expected).max() or 1)).max(),
            "forces": np.abs(left).max() / (size_of.max() or 1),
        }
        worst = {what: max(worst[what], float(error)) for what, error in errors.items()}
    return worst


def main():
    if sys.argv[1:] == ["files"]:
        return files()
    folder = Path(sys.argv[2])
    errors = {}
    for task in json.loads((folder / "task.json").read_text()):
        try:
            errors[task["file"]] = compare(folder, task)
        except Exception as wrong:  # for example if Pinocchio rejects a file
            errors[task["file"]] = {"refused": str(wrong).splitlines()[0]}
        print(task["file"], errors[task["file"]], flush=True)
    (folder / "errors.json").write_text(json.dumps(errors))


main()
