"""Declarations for the tests."""

import pendulum_dynamics as pendulum
import pytest

DOUBLE = """
/// Two rods with friction in their joints.
pub Double {
    params {
        /// Length of each rod.
        l: m = 1,
        gamma: N m s = 0.1,
    }
    gravity: [0, -9.81, 0],
    generate: [rhs, jacobian, energy, shapes, mass_matrix, inverse_dynamics],
    point tip on lower at [0, -l, 0],
    output tip: tip,
    event turns: dot(b),
    body upper on ground {
        solids: [rod(1, [0, 0, 0], [0, -l, 0])], joint: revolute(z), coordinate: a, friction: gamma,
    }
    body lower on upper {
        solids: [rod(1, [0, 0, 0], [0, -l, 0])], joint: revolute(z) at [0, -l, 0], coordinate: b, friction: gamma,
    }
}
"""

BALL = """
pub Ball {
    params { e: 1 = 0.8 }
    units: none,
    gravity: [0, -9.81, 0],
    point centre on ball at [0, 0, 0],
    wall floor { gap: centre.y, restitution: e }
    body ball on ground { mass: 1, joint: prismatic(y), coordinate: y }
}
"""


def chain(links: int) -> str:
    """A chain of rods."""
    bodies = "".join(
        f"body b{n} on {f'b{n - 1}' if n else 'ground'} {{ mass: 1, joint: revolute(z) at [0, {-n and -1}, 0], "
        f"com: [0, -1, 0], coordinate: q{n} }}\n"
        for n in range(links)
    )
    return f"pub Chain {{ gravity: [0, -9.81, 0], generate: [rhs], {bodies} }}"


@pytest.fixture(scope="session")
def double() -> pendulum.Model:
    return pendulum.Model(DOUBLE)


@pytest.fixture(scope="session")
def ball() -> pendulum.Model:
    return pendulum.Model(BALL)
