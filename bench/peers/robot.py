"""Open chains and trees of revolute joints, read from the tests' reference data, so that all peers use the same numbers."""

import json
from dataclasses import dataclass
from fractions import Fraction
from math import cos, pi, sin
from xml.etree import ElementTree


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
    flies: bool = False  # true if the first body is floating


# Points whose positions and Jacobians are measured, as in `src/peers/flange.rs`.
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


def flying(path):
    """Reads a robot with floating root from a URDF file; fixed links are merged into their parents."""
    root = ElementTree.parse(path).getroot()
    links = {link.get("name"): link for link in root.iter("link")}
    joints = list(root.iter("joint"))
    numbers = lambda element, what, default: [float(x) for x in (element.get(what) if element is not None else default).split()]
    moved = {joint.find("child").get("link") for joint in joints}
    first = next(name for name in links if name not in moved)
    bodies, places = [], {first: (0, [0, 0, 0], IDENTITY)}

    def add(name, parent, axis, at, turn):
        bodies.append(Body(parent, axis, at, turn, 0.0, [0, 0, 0], [[0] * 3 for _ in range(3)]))

    add(first, -1, None, [0, 0, 0], IDENTITY)
    for joint in joints:
        parent, name = joint.find("parent").get("link"), joint.find("child").get("link")
        carrier, place, turned = places[parent]
        origin = joint.find("origin")
        at = plus(place, times(turned, numbers(origin, "xyz", "0 0 0")))
        if any(numbers(origin, "rpy", "0 0 0")):
            raise ValueError(f"{name}: only joints that are not turned are known here")
        if joint.get("type") == "fixed":
            places[name] = carrier, at, turned
        else:
            axis = [int(x) for x in numbers(joint.find("axis"), "xyz", "1 0 0")]
            add(name, carrier, axis, at, turned)
            places[name] = len(bodies) - 1, [0, 0, 0], IDENTITY
    for name, (carrier, place, _) in places.items():
        inertial = links[name].find("inertial")
        if inertial is not None:
            entries = inertial.find("inertia")
            xx, xy, xz, yy, yz, zz = (float(entries.get(f"i{what}")) for what in ("xx", "xy", "xz", "yy", "yz", "zz"))
            com = plus(place, numbers(inertial.find("origin"), "xyz", "0 0 0"))
            mass = float(inertial.find("mass").get("value"))
            join(bodies[carrier], mass, com, [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    return Robot(root.get("name"), [0, 0, -9.81], bodies, flies=True)


IDENTITY = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]


def plus(a, b):
    return [x + y for x, y in zip(a, b)]


def times(matrix, v):
    return [sum(x * y for x, y in zip(row, v)) for row in matrix]


def join(body, mass, com, inertia):
    """Adds a mass with its inertia about its own centre."""
    total = body.mass + mass
    centre = [(body.mass * a + mass * b) / total for a, b in zip(body.com, com)]
    parts = [(body.mass, body.com, body.inertia), (mass, com, inertia)]

    def entry(i, j):
        def about(m, at, own):
            d = [a - b for a, b in zip(at, centre)]
            return own[i][j] + m * ((sum(x * x for x in d) if i == j else 0) - d[i] * d[j])

        return sum(about(*part) for part in parts)

    body.inertia = [[entry(i, j) for j in range(3)] for i in range(3)]
    body.mass, body.com = total, centre


def double_pendulum(p):
    """The chain of the double pendulum in relative angles, without friction."""
    still = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
    inertia = [[0, 0, 0], [0, 0, 0], [0, 0, p["inertia"]]]
    bodies = [
        Body(n - 1, [0, 0, 1], [0, -n * p["d"], 0], still, p["m"], [0, -p["c"], 0], inertia) for n in range(2)
    ]
    return Robot("eq22", [0, -p["g"], 0], bodies)


def half_turns(text):
    """Parses an angle such as `-pi/2`, in units of pi."""
    text = str(text)
    if "pi" not in text:
        if float(text) != 0:
            raise ValueError(f"{text} is not a multiple of pi")
        return Fraction(0)
    factor, _, divisor = text.partition("/")
    return Fraction({"pi": 1, "-pi": -1}[factor], int(divisor or 1))


def exact(function, angle):
    """Sine or cosine of an angle in units of pi; exact integers at quarter turns, without residues of 1e-17."""
    value = function(pi * float(angle))
    return round(value) if (2 * angle).denominator == 1 else value


def matrix(rpy):
    """Rotation matrix of a URDF's roll, pitch and yaw."""
    (sr, cr), (sp, cp), (sy, cy) = ((exact(sin, angle), exact(cos, angle)) for angle in rpy)
    return [
        [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
        [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
        [-sp, cp * sr, cp * cr],
    ]
