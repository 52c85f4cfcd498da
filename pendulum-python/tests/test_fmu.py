"""FMUs that the generator writes, in fmpy, beside this package."""

import pathlib
import re
import shutil
import subprocess

import numpy as np
import pendulum_dynamics as pendulum
import pytest

fmpy = pytest.importorskip("fmpy", reason="FMPy is not installed", exc_type=ImportError)
from fmpy.validation import validate_fmu  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
# Largest error of an end at a tolerance of 1e-12, in SI units. FMPy exchanges models with CVode, whose errors add up to
# more than those of the method in the FMU.
ERRORS = {"ModelExchange": 5e-8, "CoSimulation": 1e-9}

CART_POLE = """
/// A pole on a cart that is pushed: by < 10 N & > -10 N.
pub CartPole {
    params { l: m = 0.6, mass: kg }
    /// Force on the cart.
    input push: N,
    gravity: [0, -9.81, 0],
    point tip on pole at [0, -l, 0],
    output tip: tip,
    output speed: dot(tip.x),
    body cart on ground { mass: mass, joint: prismatic(x), coordinate: s, friction: 0.2, torque: push }
    body pole on cart { solids: [rod(0.4, [0, 0, 0], [0, -l, 0])], joint: revolute(z), coordinate: θ, friction: 0.01 }
}
"""

FOUR_BAR = """
pub FourBar {
    gravity: [0, -9.81, 0],
    output angle: psi,
    body crank on ground { mass: 0.5, com: [0.1, 0, 0], inertia: 0.002, joint: revolute(z), coordinate: theta near 0.8 }
    body coupler on crank {
        mass: 1.1, com: [0.25, 0, 0], inertia: 0.02,
        joint: revolute(z) at [0.2, 0, 0], coordinate: phi depends near -0.3,
    }
    body rocker on ground {
        mass: 0.9, com: [0.2, 0, 0], inertia: 0.01,
        joint: revolute(z) at [0.6, 0, 0], coordinate: psi depends near 1.6,
    }
    close coupler at [0.5, 0, 0] to rocker at [0.4, 0, 0]: revolute(z),
}
"""

SPATIAL = """
pub Spatial {
    gravity: [0, 1, -9.81],
    generate: [rhs],
    body crank on ground { mass: 2, com: [0.01, 0, 0], inertia: 0.1, joint: revolute(z), coordinate: theta near 0.8 }
    body yoke on crank {
        mass: 0.1, inertia: 0.001, joint: revolute(z) at [0.06, 0, 0.02], coordinate: alpha depends near 0.1,
    }
    body rod on yoke {
        mass: 0.4, com: [0.4, 0, 0], inertia: [0.01, 0.01, 0.01],
        joint: revolute(y), coordinate: beta depends near -0.7,
    }
    body rocker on ground {
        mass: 0.9, com: [0, 0.3, 0.1], inertia: 0.02,
        joint: revolute([1, 0, 0.02]) at [0.4, 0, 0.1], coordinate: gamma depends near 0.6, friction: 0.3,
    }
    close rod at [0.815, 0, 0] to rocker at [0, 0.7, 0.1]: ball,
}
"""

# The numbers in its declaration.
GUESS = {"theta": 0.8, "alpha": 0.1, "beta": -0.7, "gamma": 0.6}

FLYING = """
pub Flying {
    params { k: N/m = 3 }
    gravity: [0, 0, -9.81],
    output turn: rotation(craft),
    event lands: reach.z,
    point reach on craft at [0, 0, -0.5],
    state heat { unit: J, rate: k*reach.x*dot(reach.x) }
    body craft on ground {
        mass: 3, com: [0.1, 0.1, -0.1], inertia: [0.3, 0.25, 0.2],
        joint: free at [1, 0, 0], orientation: craft, position: at,
    }
}
"""

# The declaration of the paper's pendulum.
PAPER = re.search(
    r"mechanism! \{\n(.*?)\n\}\n", (ROOT / "testbed/src/scenes.rs").read_text(encoding="utf-8"), re.DOTALL
).group(1)

# Declarations, start values, and the length of the motion in s.
MOTIONS = {
    "DoublePendulum": (PAPER, {"theta2": np.radians(4)}, 20.0),
    "CartPole": (CART_POLE, {"θ": 1.0, "push": 2.0, "mass": 2.0}, 5.0),
    "FourBar": (FOUR_BAR, {"theta": -1.5}, 5.0),
    "Spatial": (SPATIAL, {**GUESS, "theta": 0.9}, 2.0),
    "Flying": (FLYING, {"craft.omega.x": 1.0, "craft.omega.z": -2.0, "der(at.x)": 0.5}, 2.0),
}


def emit(folder, texts, **options):
    """Writes the FMUs of declarations into a folder."""
    source = folder / "models.rs"
    source.write_text("".join(f"mechanism! {{{text}}}\n" for text in texts), encoding="utf-8")
    command = ["cargo", "run", "--quiet", "--package", "pendulum-codegen", "--example", "emitted", "--"]
    return subprocess.run([*command, "--fmu", str(source), str(folder)], cwd=ROOT, **options)


@pytest.fixture(scope="session")
def folder(tmp_path_factory) -> pathlib.Path:
    """A folder with the FMUs of all declarations."""
    for program in ["cargo", "cc"]:
        if not shutil.which(program):
            pytest.skip(f"`{program}` is not installed")
    folder = tmp_path_factory.mktemp("fmus")
    emit(folder, [text for text, *_ in MOTIONS.values()], check=True)
    return folder


def simulate(folder, name, mode, tolerance):
    """End of a simulation, by the names of this package."""
    _, start, length = MOTIONS[name]
    path = str(folder / f"{name}.fmu")
    variables = fmpy.read_model_description(path).modelVariables
    result = fmpy.simulate_fmu(
        path,
        fmi_type=mode,
        stop_time=length,
        output_interval=length / 50,
        relative_tolerance=tolerance,
        start_values=start,
        output=[own.name for own in variables if own.causality == "output"],
    )
    assert result["time"][-1] == pytest.approx(length)
    return {own(name): float(result[name][-1]) for name in result.dtype.names}


def own(name):
    """Name in this package of a variable: ``dot(craft).x`` for ``craft.omega.x``, ``dot(s)`` for ``der(s)``."""
    name = re.sub(r"(\w+)\.omega\.", r"dot(\1).", name)
    return name.replace("der(", "dot(").replace(",", ", ")


def end(name):
    """The same end by this package."""
    text, start, length = MOTIONS[name]
    values = {own(key): value for key, value in start.items()}
    model = pendulum.Model(text, {"mass": values.pop("mass")} if "mass" in values else {})
    model = model.with_inputs({key: values.pop(key) for key in model.inputs})
    solution = model.solve((0.0, length), model.assemble(model.state(values)), rtol=1e-13, atol=1e-13)
    assert solution.success
    return dict(zip(model.states, solution.y[:, -1])) | model.output(length, solution.y[:, -1])


@pytest.mark.parametrize("name", MOTIONS)
def test_an_fmu_is_valid(folder, name):
    assert validate_fmu(str(folder / f"{name}.fmu")) == []


@pytest.mark.parametrize("mode", ERRORS)
@pytest.mark.parametrize("name", MOTIONS)
def test_ends_are_those_of_this_package(folder, name, mode):
    found, expected = simulate(folder, name, mode, 1e-12), end(name)
    assert {key: found[key] for key in expected} == pytest.approx(expected, rel=0, abs=ERRORS[mode])
    assert set(found) - set(expected) == {"time"}


def test_variables_have_names_units_and_starts(folder):
    description = fmpy.read_model_description(str(folder / "CartPole.fmu"))
    found = {v.name: (v.causality, v.unit, v.start) for v in description.modelVariables}
    assert found["l"] == ("parameter", "m", "0.6")
    assert found["mass"] == ("parameter", "kg", "NaN")
    assert found["push"] == ("input", "N", "0.0")
    assert found["der(s)"] == ("output", "m/s", "0.0")
    assert found["der(θ,2)"] == ("local", "rad/s^2", None)
    assert found["speed"] == ("output", "m/s", None)
    # loops start closed
    variables = fmpy.read_model_description(str(folder / "Spatial.fmu")).modelVariables
    starts = {v.name: float(v.start) for v in variables if v.name in GUESS}
    model = pendulum.Model(SPATIAL)
    closed = dict(zip(model.states, model.assemble(model.state(GUESS))))
    assert starts == pytest.approx({key: closed[key] for key in GUESS}, rel=0, abs=1e-12)


@pytest.mark.parametrize("mode", ERRORS)
@pytest.mark.parametrize("mass", [None, -2.0])
def test_wrong_parameters_are_named(folder, mode, mass):
    messages = []
    with pytest.raises(fmpy.fmi1.FMICallException):
        fmpy.simulate_fmu(
            str(folder / "CartPole.fmu"),
            fmi_type=mode,
            start_values={} if mass is None else {"mass": mass},
            logger=lambda environment, status, category, message: messages.append(message.decode()),
        )
    assert any("`mass`" in message for message in messages), messages


def test_scenes_that_switch_modes_are_refused(folder, tmp_path):
    text = """pub Stopped { gravity: [0, -9.81, 0], body b on ground {
        mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: a, stop: [-1, 1], dry_friction: 0.1 } }"""
    done = emit(tmp_path, [text], capture_output=True, text=True)
    assert done.returncode != 0
    assert "an FMU has no dry friction, stops or walls" in done.stderr and "help: " in done.stderr
    assert list(tmp_path.glob("*.fmu")) == []
