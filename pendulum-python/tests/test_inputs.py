"""Inputs that follow samples, such as measured torques."""

import copy
import pathlib
import pickle
import re

import numpy as np
import pendulum_dynamics as pendulum
import pytest
from scipy.integrate import solve_ivp

SWING = """
pub Swing {
    params { l: m = 1, damping: N m s = 0.1 }
    input motor: N m,
    input wind: N m,
    gravity: [0, -9.81, 0],
    body bob on ground {
        solids: [point(1, [0, -l, 0])], joint: revolute(z), coordinate: angle, torque: motor + wind, friction: damping,
    }
}
"""

MEASURED = pathlib.Path(__file__).resolve().parents[2] / "examples/measured"
# The declaration of the arm.
ARM = re.search(r"mechanism! \{\n(.*?)\n\}\n", (MEASURED / "main.rs").read_text(encoding="utf-8"), re.DOTALL).group(1)

TIMES = np.linspace(0.0, 4.0, 81)
MOTOR = 2.0 * np.sin(3.0 * TIMES)


@pytest.fixture(scope="session")
def swing() -> pendulum.Model:
    return pendulum.Model(SWING)


@pytest.mark.parametrize("kind", ["hold", "linear", "cubic"])
def test_a_motion_under_samples_is_that_of_scipy(swing, kind):
    driven = swing.with_inputs(motor=(TIMES, MOTOR, kind), wind=0.3)
    value = MOTOR[24] if kind == "hold" else np.interp(1.23, TIMES, MOTOR)
    # of a mass of 1 kg at 1 m
    assert abs(driven.rhs(1.23, [0, 0])[1] - value - 0.3) < (1e-2 if kind == "cubic" else 1e-14)
    own = driven.solve((0, 4), [0.5, 0.0], rtol=1e-10, atol=1e-10)
    other = solve_ivp(driven.rhs, (0, 4), [0.5, 0.0], method="DOP853", rtol=1e-10, atol=1e-10, max_step=0.05)
    assert np.abs(own.y[:, -1] - other.y[:, -1]).max() < 1e-7


def test_a_model_keeps_its_samples(swing):
    driven = swing.with_inputs({"motor": (TIMES, MOTOR)}, wind=0.5)
    assert "motor=81 samples" in repr(driven) and "wind=0.5" in repr(driven)
    for other in (pickle.loads(pickle.dumps(driven)), copy.copy(driven), copy.deepcopy(driven)):
        assert other.inputs["wind"] == 0.5 and other.inputs["motor"][2] == "linear"
        assert other.rhs(1.1, [0.1, 0.2]).tolist() == driven.rhs(1.1, [0.1, 0.2]).tolist()
    longer = driven.with_parameters(l=1.5)
    assert abs(longer.rhs(1.1, [0, 0])[1] * 1.5**2 - driven.rhs(1.1, [0, 0])[1]) < 1e-14
    assert driven.with_inputs(motor=1).inputs == {"motor": 1.0, "wind": 0.5}
    assert driven.with_inputs(motor=1).rhs(1.1, [0, 0])[1] == 1.5
    # samples are copied
    values = MOTOR.copy()
    driven = swing.with_inputs(motor=(TIMES, values))
    values[:] = 0.0
    assert driven.inputs["motor"][1].tolist() == MOTOR.tolist()
    # lists and integers will do
    assert swing.with_inputs(motor=([0, 2], [0, 4])).rhs(1, [0, 0])[1] == 2.0


def test_an_ensemble_has_the_bits_of_single_trajectories(swing):
    random = np.random.default_rng(2)
    starts, motors, winds = random.uniform(-1, 1, (20, 2)), random.normal(size=(20, len(TIMES))), np.arange(20) / 10
    lengths = random.uniform(0.5, 1.0, 20)
    for kind, method in (("hold", {"method": "Rk4", "h": 0.05}), ("linear", {"rtol": 1e-6})):
        together = swing.ensemble(
            (0, 2), starts, parameters={"l": lengths}, inputs={"motor": (TIMES, motors, kind), "wind": winds}, **method
        )
        for n, end in enumerate(together.y_end):
            own = swing.with_parameters(l=lengths[n]).with_inputs(motor=(TIMES, motors[n], kind), wind=winds[n])
            assert own.solve((0, 2), starts[n], **method).y[:, -1].tolist() == end.tolist()
    shared = swing.ensemble((0, 2), starts, inputs={"motor": (TIMES, MOTOR), "wind": 0.2})
    alone = swing.with_inputs(motor=(TIMES, MOTOR), wind=0.2).solve((0, 2), starts[3])
    assert shared.y_end[3].tolist() == alone.y[:, -1].tolist()
    # the samples tell how many trajectories there are
    assert swing.ensemble((0, 2), [0.1, 0.0], inputs={"motor": (TIMES, motors)}).y_end.shape == (20, 2)


def test_a_fit_finds_parameters_from_several_experiments(swing):
    truth = swing.with_parameters(l=0.8, damping=0.15)
    experiments = []
    for kind, wind in (("linear", 0.0), ("hold", 0.4)):
        inputs = {"motor": (TIMES, MOTOR, kind), "wind": wind}
        motion = truth.with_inputs(inputs).solve((0, 4), [0.3, 0.0], t_eval=TIMES, method="Rk4", h=0.01)
        noise = 1e-5 * np.sin(1e4 * TIMES)
        experiments.append({"t": TIMES, "outputs": {"angle": motion.y[0] + noise}, "inputs": inputs})
    fit = swing.fit(experiments, method="Rk4", h=0.01)
    assert fit.success
    assert abs(fit.estimates["l"] - 0.8) < 1e-4 and abs(fit.estimates["damping"] - 0.15) < 1e-4
    assert fit.model.parameters == fit.parameters
    # the inputs of the model are those of an experiment without any
    single = experiments[0]
    of_model = swing.with_inputs(single["inputs"]).fit(TIMES, single["outputs"], method="Rk4", h=0.01)
    given = swing.fit(TIMES, single["outputs"], inputs=single["inputs"], method="Rk4", h=0.01)
    assert of_model.estimates == given.estimates
    # without the torque nothing fits
    assert abs(swing.fit(TIMES, single["outputs"], method="Rk4", h=0.01).estimates["l"] - 0.8) > 1e-2


def test_derivatives_under_samples(swing):
    driven = swing.with_inputs(motor=(TIMES, MOTOR))
    found = driven.sensitivity([0, 3], [0.3, 0.0], ["l"], method="Rk4", h=0.01)
    step = 1e-5
    ends = [
        driven.with_parameters(l=1 + side * step).solve((0, 3), [0.3, 0.0], method="Rk4", h=0.01).y[:, -1]
        for side in (-1, 1)
    ]
    assert np.abs(found.derivatives[:, 0, 1] - (ends[1] - ends[0]) / (2 * step)).max() < 1e-7


def test_measured_torques_of_a_real_arm():
    """Finds the estimates of the Rust example `measured` for its scene with viscous friction."""
    columns = np.loadtxt(MEASURED / "data/run_1.csv", delimiter=",", skiprows=1, unpack=True)
    t, q1, q2, _, _, torque1, torque2 = columns
    free = ["i1", "i2", "r1", "r2", "viscous1", "viscous2"]
    fit = pendulum.Model(ARM, {"dry1": 0.0, "dry2": 0.0, "rotor": 1e-12}).fit(
        t,
        {"q1": q1, "q2": q2},
        noise={"q1": 2e-4, "q2": 2e-4},
        inputs={"torque1": (t, torque1), "torque2": (t, torque2)},
        free=free,
        separate_windows=0.5,
        method="Rk4",
        h=0.004,
    )
    # by compiled code
    expected = [
        0.08129044532300114,
        0.02873472463791563,
        0.3968488254473054,
        0.19677129337622706,
        0.0963301754368983,
        0.02349021369415225,
    ]
    assert fit.success
    assert fit.estimates == pytest.approx(dict(zip(free, expected)), rel=1e-9)


@pytest.mark.parametrize(
    ("inputs", "error", "says"),
    [
        ({"moter": (TIMES, MOTOR)}, ValueError, "there is no input `moter`; did you mean `motor`?"),
        ({"motor": (TIMES, MOTOR, "nearest")}, ValueError, "there is no interpolation `nearest`"),
        ({"motor": (TIMES, MOTOR[1:])}, ValueError, "the input `motor`: `values` has 80 values for 81 times"),
        ({"motor": (TIMES[::-1], MOTOR)}, ValueError, "the input `motor`: the times of samples 0 and 1 are 4 and"),
        ({"motor": (TIMES, MOTOR * np.nan)}, ValueError, "the input `motor`: sample 0 of `values` is NaN"),
        ({"motor": ([0, np.nan], [0, 1])}, ValueError, "the input `motor`: the time of sample 1 is NaN"),
        ({"motor": ([], [])}, ValueError, "the input `motor`: there are 0 samples: at least 2 are needed"),
        ({"motor": (TIMES,)}, ValueError, "samples of motor are times, values and an interpolation, not 1"),
        ({"motor": (TIMES, [MOTOR])}, ValueError, "the values of motor must have one dimension"),
        ({"motor": (TIMES, "torque")}, TypeError, "the values of motor must be an array of real numbers"),
        ({"motor": [TIMES, MOTOR]}, TypeError, "motor must be a number, or a tuple of times and values"),
        ({"motor": np.inf}, ValueError, "motor: an input must be finite"),
        ([("motor", 1.0)], TypeError, "give inputs by name"),
    ],
)
def test_wrong_samples_are_named(swing, inputs, error, says):
    says = says.replace(".", r"\.").replace("?", r"\?")
    with pytest.raises(error, match=says):
        swing.with_inputs(inputs)
    if "finite" not in says:
        with pytest.raises(error, match=says):
            swing.fit(TIMES, {"angle": MOTOR}, inputs=inputs)


def test_inputs_of_fits_and_ensembles_are_checked(swing):
    given, wind = {"angle": MOTOR}, {"wind": 0}
    with pytest.raises(ValueError, match="the input `wind` of experiment 0: others have samples"):
        swing.fit(TIMES, given, inputs={"motor": (TIMES, MOTOR)})
    with pytest.raises(ValueError, match="the input `motor` of experiment 1: others have samples"):
        swing.fit(
            [
                {"t": TIMES, "outputs": given, "inputs": {"motor": (TIMES, MOTOR), **wind}},
                {"t": TIMES, "outputs": given, "inputs": wind},
            ]
        )
    with pytest.raises(ValueError, match="of 1.0 to 4.0 s, and the motion is of 0.0 to 4.0 s; give"):
        swing.fit(TIMES, given, inputs={"motor": (TIMES[20:], MOTOR[20:]), **wind})
    with pytest.raises(ValueError, match="each has its own"):
        swing.fit([{"t": TIMES, "outputs": given}], inputs=wind)
    with pytest.raises(ValueError, match="motor has 3 rows of values, and there are 2 initial states"):
        swing.ensemble((0, 1), np.zeros((2, 2)), inputs={"motor": (TIMES, [MOTOR] * 3)})
    with pytest.raises(ValueError, match="wind has 3 rows of values"):
        swing.ensemble((0, 1), np.zeros((2, 2)), inputs={"wind": [1, 2, 3]})
    with pytest.raises(ValueError, match="there is no input `winds`; did you mean `wind`"):
        swing.ensemble((0, 1), np.zeros((2, 2)), inputs={"winds": [1, 2]})
    with pytest.raises(ValueError, match="there is no input `winds`"):
        swing.ensemble((0, 1), np.zeros((2, 2)), inputs={"winds": 1})
    with pytest.raises(ValueError, match="time"):
        swing.with_inputs(motor=(TIMES, MOTOR)).equilibria()


def test_simpler_models_follow_the_samples(swing):
    driven = swing.with_inputs(motor=(TIMES, MOTOR, "cubic"))
    [answer, idle] = [model.simplest(2.0, [0.3, 0.0]) for model in (driven, swing)]
    [own, without] = [own.simpler[0].observed["angle"] for own in (answer, idle)]
    assert own != without
