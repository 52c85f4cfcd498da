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
    damping: float = 0.0


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


def from_urdf(name, path, flies=False):
    """Reads a robot from a URDF file, on the ground or with floating root; fixed links are merged into their parents."""
    root = ElementTree.parse(path).getroot()
    links = {link.get("name"): link for link in root.iter("link")}
    joints = list(root.iter("joint"))
    moved = {joint.find("child").get("link") for joint in joints}
    first = next(link for link in links if link not in moved)
    bodies, places = [], {first: (-1, [0, 0, 0], IDENTITY)}

    def add(parent, axis, at, turn, damping=0.0):
        bodies.append(Body(parent, axis, at, turn, 0.0, [0, 0, 0], [[0] * 3 for _ in range(3)], damping))
        return len(bodies) - 1, [0, 0, 0], IDENTITY

    if flies:
        places[first] = add(-1, None, [0, 0, 0], IDENTITY)
    for joint in joints:
        carrier, place, turned = places[joint.find("parent").get("link")]
        origin, dynamics = joint.find("origin"), joint.find("dynamics")
        at = plus(place, times(turned, numbers(origin, "xyz", "0 0 0")))
        turn = product(turned, matrix([half_turns(angle) for angle in numbers(origin, "rpy", "0 0 0")]))
        if joint.get("type") == "fixed":
            fixed = carrier, at, turn
        else:
            axis = [int(x) for x in numbers(joint.find("axis"), "xyz", "1 0 0")]
            fixed = add(carrier, axis, at, turn, *numbers(dynamics, "damping", "0"))
        places[joint.find("child").get("link")] = fixed
    for link, (carrier, place, turned) in places.items():
        inertial = links[link].find("inertial")
        if inertial is None or carrier < 0:
            continue
        if turned != IDENTITY:
            raise ValueError(f"{link}: only fixed links that are not turned are known here")
        entries = inertial.find("inertia")
        xx, xy, xz, yy, yz, zz = (float(entries.get(f"i{what}")) for what in ("xx", "xy", "xz", "yy", "yz", "zz"))
        com = plus(place, numbers(inertial.find("origin"), "xyz", "0 0 0"))
        mass = float(inertial.find("mass").get("value"))
        join(bodies[carrier], mass, com, [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    return Robot(name, [0, 0, -9.81], bodies, flies=flies)


def numbers(element, what, default):
    """Numbers of an attribute; the element and the attribute may be missing."""
    return [float(x) for x in (default if element is None else element.get(what, default)).split()]


IDENTITY = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]


def plus(a, b):
    return [x + y for x, y in zip(a, b)]


def times(matrix, v):
    return [sum(x * y for x, y in zip(row, v)) for row in matrix]


def product(a, b):
    return [[sum(x * y for x, y in zip(row, column)) for column in zip(*b)] for row in a]


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


def half_turns(angle):
    """Converts an angle, such as `-pi/2` or a number of radians, to units of pi; decimals are rounded quarter turns."""
    if "pi" in str(angle):
        factor, _, divisor = angle.partition("/")
        return Fraction({"pi": 1, "-pi": -1}[factor], int(divisor or 1))
    turns = Fraction(round(2 * float(angle) / pi), 2)
    if abs(float(angle) - pi * float(turns)) > 1e-4:
        raise ValueError(f"{angle} is not a multiple of pi/2")
    return turns


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
