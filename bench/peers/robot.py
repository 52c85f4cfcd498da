"""Open chains of revolute joints, read from the tests' reference data, so that all sides hold the same numbers."""

import json
from dataclasses import dataclass
from fractions import Fraction
from math import cos, pi, sin


@dataclass
class Body:
    """One link: `at` and `turn` place its joint in the frame of the parent, the rest is in the frame of the joint."""

    parent: int
    axis: list
    at: list
    turn: list
    mass: float
    com: list
    inertia: list  # about the centre of mass


@dataclass
class Robot:
    name: str
    gravity: list
    bodies: list
    point: list | None = None  # in the frame of the last body


# The points whose positions and Jacobians are asked for, as in `src/peers/flange.rs`.
POINTS = {"ur5": [0, 0.0823, 0]}


def read(path):
    """The robots of `testbed/data/robots.json`."""
    return [robot(data) for data in json.loads(path.read_text())["mechanisms"]]


def robot(data):
    bodies = []
    for body in data["bodies"]:
        joint = body["joint"]
        if joint["type"] != "revolute" or joint["friction"] != 0:
            raise ValueError(f"{data['name']}: only revolute joints without friction are known here")
        turn = matrix([half_turns(angle) for angle in joint["rpy"]])
        shape = body["mass"], body["com"], body["inertia"]
        bodies.append(Body(body["parent"], joint["axis"], joint["at"], turn, *shape))
    return Robot(data["name"], data["gravity"], bodies, POINTS.get(data["name"]))


def double_pendulum(p):
    """Its chain in relative angles, without the friction of the axles."""
    still = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
    inertia = [[0, 0, 0], [0, 0, 0], [0, 0, p["inertia"]]]
    bodies = [
        Body(n - 1, [0, 0, 1], [0, -n * p["d"], 0], still, p["m"], [0, -p["c"], 0], inertia) for n in range(2)
    ]
    return Robot("eq22", [0, -p["g"], 0], bodies)


def half_turns(text):
    """An angle such as `-pi/2`, in units of pi."""
    text = str(text)
    if "pi" not in text:
        if float(text) != 0:
            raise ValueError(f"{text} is not a multiple of pi")
        return Fraction(0)
    factor, _, divisor = text.partition("/")
    return Fraction({"pi": 1, "-pi": -1}[factor], int(divisor or 1))


def exact(function, angle):
    """Sine or cosine of an angle in units of pi; whole numbers at quarter turns, with no 1e-17 to multiply along."""
    value = function(pi * float(angle))
    return round(value) if (2 * angle).denominator == 1 else value


def matrix(rpy):
    """The rotation of a URDF's roll, pitch and yaw."""
    (sr, cr), (sp, cp), (sy, cy) = ((exact(sin, angle), exact(cos, angle)) for angle in rpy)
    return [
        [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
        [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
        [-sp, cp * sr, cp * cr],
    ]
