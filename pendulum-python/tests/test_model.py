"""Models: what they are, and what they compute."""

import copy
import pathlib
import pickle

import numpy as np
import pendulum_dynamics as pendulum
import pytest
from conftest import chain

ROOT = pathlib.Path(__file__).resolve().parents[2]


def test_what_a_model_is(double):
    assert double.name == "Double"
    assert double.docs == "Two rods with friction in their joints."
    assert double.parameters == {"l": 1.0, "gamma": 0.1}
    assert double.states == ["a", "b", "dot(a)", "dot(b)"]
    assert double.units["dot(b)"] == "rad/s" and double.units["gamma"] == "N m s"
    assert double.outputs == ["tip.x", "tip.y", "tip.z"]
    assert double.events == ["turns"]
    assert "mass_matrix" in double.functions
    assert double.costs["rhs"]["sincos"] == 2
    assert "A[a, a] =" in double.equations
    assert double._repr_latex_().startswith("$$\n") and r"\ddot" in double.latex
    assert "l=1" in repr(double)


def test_functions_of_time_and_state(double):
    x = [0.3, -0.2, 1.0, 0.5]
    step = 1e-6
    columns = [(double.rhs(0, x + step * e) - double.rhs(0, x - step * e)) / (2 * step) for e in np.eye(4)]
    assert np.abs(np.array(columns).T - double.jacobian(0, x)).max() < 1e-8
    assert double.energy(0, x) == double.kinetic(0, x) + double.potential(0, x)
    matrix = double.evaluate("mass_matrix", 0, x)
    assert matrix.shape == (2, 2) and matrix[0, 1] == matrix[1, 0]
    assert abs(0.5 * np.array(x[2:]) @ matrix @ x[2:] - double.kinetic(0, x)) < 1e-14
    torques = double.evaluate("inverse_dynamics", 0, x, double.rhs(0, x)[2:])
    assert np.abs(torques).max() < 1e-12
    tip = double.output(0, x)
    assert abs(tip["tip.x"] - (np.sin(0.3) + np.sin(0.1))) < 1e-15


def test_other_parameters(double):
    longer = double.with_parameters(l=4.0)
    assert longer.parameters["l"] == 4.0 and double.parameters["l"] == 1.0
    assert abs(longer.rhs(0, [0.1, 0, 0, 0])[2]) < abs(double.rhs(0, [0.1, 0, 0, 0])[2])
    assert double.state({"dot(b)": 2.0}, a=1.0).tolist() == [1.0, 0.0, 0.0, 2.0]


def test_results_keep_their_dimensions():
    model = pendulum.Model(
        """pub Single {
            gravity: [0, -9.81, 0],
            generate: [rhs, energy, mass_matrix],
            body bob on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: a }
        }"""
    )
    assert model.evaluate("mass_matrix", 0, [0.1, 0]).shape == (1, 1)
    assert model.evaluate("rhs", 0, [0.1, 0]).shape == (2,)
    assert isinstance(model.evaluate("kinetic", 0, [0.1, 0]), float)


def test_models_can_be_copied_and_sent(double):
    longer = double.with_parameters(l=3.0)
    for other in (pickle.loads(pickle.dumps(longer)), copy.copy(longer), copy.deepcopy(longer)):
        assert other.parameters == longer.parameters
        assert other.rhs(0, [1, 2, 3, 4]).tolist() == longer.rhs(0, [1, 2, 3, 4]).tolist()


def test_methods():
    assert sorted(pendulum.METHODS) == sorted(pendulum._native.METHODS)


def test_inputs():
    model = pendulum.Model(
        """pub Pushed {
            input force: N,
            body cart on ground { mass: 2, joint: prismatic(x), coordinate: s, torque: force }
        }"""
    )
    assert model.inputs == {"force": 0.0}
    assert model.with_inputs(force=3.0).rhs(0, [0, 0]).tolist() == [0.0, 1.5]


def test_a_robot_from_a_file():
    path = ROOT / "testbed/data/urdf/ur5.urdf"
    model = pendulum.Model.from_urdf(path)
    assert len(model.states) == 12
    held = model.evaluate("inverse_dynamics", 0, np.zeros(12), np.zeros(6))
    assert held.shape == (6,) and np.abs(held).max() > 10.0
    assert model.shapes(0, np.zeros(12))
    text = 'pub Robot { robot: urdf("ur5.urdf"), gravity: [0, 0, -9.81], generate: [rhs] }'
    assert len(pendulum.Model(text, folder=path.parent).states) == 12


def test_errors_have_their_place():
    with pytest.raises(pendulum.DeclarationError) as caught:
        pendulum.Model("pub A {\n    body bob on ground { mass: m, joint: revolute(z), coordinate: q }\n}")
    problem = caught.value.problems[0]
    assert (problem["line"], problem["column"], problem["width"]) == (2, 32, 1)
    assert problem["code"].startswith("M") and problem["help"]
    assert isinstance(caught.value, ValueError) and "line 2, column 32" in str(caught.value)


@pytest.mark.parametrize(
    ("call", "error", "says"),
    [
        (lambda m: m.rhs(0, [1, 2, 3]), ValueError, "3 entries, and 4 are needed"),
        (lambda m: m.rhs(0, [[1, 2, 3, 4]]), ValueError, "one dimension"),
        (lambda m: m.rhs(0, "abcd"), TypeError, "array of real numbers"),
        (lambda m: m.solve((0, 1), None), TypeError, "x0"),
        (lambda m: m.solve((0, 1), [None, 0, 0, 0]), TypeError, "x0"),
        (lambda m: m.state([1, 2]), TypeError, "by name"),
        (lambda m: m.equilibria([np.nan, 0, 0, 0]), ValueError, "finite"),
        (lambda m: m.fit([0, 1], {"a": [0, 1]}, guess=[0] * 4, known=[0] * 4), ValueError, "either"),
        (lambda m: m.solve((0, 1), [0] * 4, events=pendulum.Event("turns", direction="up")), TypeError, "direction"),
        (lambda m: m.rhs(0, [1j, 0, 0, 0]), TypeError, "numbers"),
        (lambda m: m.solve((0, 1), [0, 0, np.nan, 0]), ValueError, "finite"),
        (lambda m: m.solve((0, np.inf), [0, 0, 0, 0]), ValueError, "finite"),
        (lambda m: m.solve(1, [0, 0, 0, 0]), ValueError, "t_span"),
        (lambda m: m.solve((0, 1), [0, 0, 0, 0], method="Vern8"), ValueError, "did you mean `Vern7`"),
        (lambda m: m.solve((0, 1), [0, 0, 0, 0], method="Rk4"), ValueError, "fixed steps"),
        (lambda m: m.solve((0, 1), [0, 0, 0, 0], method="Taylor"), ValueError, "`taylor`"),
        (lambda m: m.solve((0, 1), [0, 0, 0, 0], rtol="tight"), TypeError, "rtol"),
        (lambda m: m.solve((0, 1), [0, 0, 0, 0], events="turn"), ValueError, "did you mean `turns`"),
        (lambda m: m.solve((0, 1), [0, 0, 0, 0], events=[("tip.w", 0)]), ValueError, "tip."),
        (lambda m: m.solve((0, 1), [0, 0, 0, 0], events=[3]), TypeError, "an event is"),
        (lambda m: m.solve((0, 1), [0, 0, 0, 0], t_eval=[0.5, 0.2]), ValueError, "sorted"),
        (lambda m: m.with_parameters(lenght=1), ValueError, "there is no parameter `lenght`"),
        (lambda m: m.with_parameters(l="long"), TypeError, "l must be a number"),
        (lambda m: m.with_parameters(l=np.inf), ValueError, "must be finite"),
        (lambda m: m.state(c=1), ValueError, "there is no component `c`"),
        (lambda m: m.evaluate("mass", 0, [0, 0, 0, 0]), ValueError, "there is no function `mass`"),
        (lambda m: m.ensemble((0, 1), np.zeros((3, 5))), ValueError, "5 components, and 4"),
        (lambda m: m.ensemble((0, 1), np.zeros((3, 4)), parameters={"l": [1, 2]}), ValueError, "shape"),
        (lambda m: m.ensemble((0, 1), np.zeros((3, 4)), parameters={"k": [1, 2, 3]}), ValueError, "no parameter `k`"),
        (lambda m: m.resting([0, 0, 0, 0]), ValueError, "dry friction"),
        (lambda m: m.lyapunov([0, 0, 0, 0], 5), ValueError, "5"),
        (lambda m: m.sensitivity([0, 1], [0, 0, 0, 0], ["m"]), ValueError, "there is no parameter or component `m`"),
        (lambda m: m.sensitivity([0, 1], [0, 0, 0, 0], ["l"], method="Rk45"), ValueError, "Vern9"),
        (lambda m: m.fit([0, 1], {"c": [0, 1]}), ValueError, "c"),
        (lambda m: m.fit([0, 1], {"a": [0, 1]}, free=["zz"]), ValueError, "no parameter `zz`"),
        (lambda m: m.fit([0, 1], {"a": [0, 1]}, noise={"b": 1}), ValueError, "noise"),
        (lambda m: m.fit([0, 1], {"a": [0, 1]}, bounds={"l": 1}), ValueError, "bounds of l"),
        (lambda m: m.fit([0, 1], {"a": [0, 1]}, loss="huber"), ValueError, "threshold"),
        (lambda m: m.fit([0, 1]), TypeError, "experiments"),
        (lambda m: m.sensitivity([1, 1], [0, 0, 0, 0], ["l"]), ValueError, "times"),
        (lambda m: m.sensitivity([0, 1], [0, 0, 0, 0], []), ValueError, "by"),
        (lambda m: m.lyapunov([0, 0, 0, 0], duration=-1), ValueError, "duration"),
        (lambda m: m.solve((0, 1), [0, 0, 0, 0], max_steps=-1), ValueError, "max_steps"),
        (lambda m: m.ensemble((0, 1), np.zeros((2, 4)) * 1j), TypeError, "real"),
        (lambda m: pendulum.Model.from_urdf("a.urdf", gravity=[0, 0, np.nan]), ValueError, "gravity"),
        (lambda m: m.fit([0, 1], {"a": [0, 1, 2]}), ValueError, "a"),
        (lambda m: pendulum.Model.from_urdf("nowhere.urdf"), FileNotFoundError, "nowhere.urdf"),
        (lambda m: pendulum.Model("pub A { ( }"), pendulum.DeclarationError, "bracket"),
    ],
)
def test_what_is_wrong_is_said(double, call, error, says):
    with pytest.raises(error, match=says.replace(".", r"\.")):
        call(double)


def test_the_longest_state():
    with pytest.raises(ValueError, match="66 entries, and at most 64"):
        pendulum.Model(chain(33))
