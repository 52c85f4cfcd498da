"""Trajectories, beside SciPy's."""

import _thread
import os
import pickle
import threading
import time

import numpy as np
import pendulum_dynamics as pendulum
import pytest
from conftest import chain
from scipy.integrate import solve_ivp

START = [2.0, 1.0, 0.0, 0.5]


def test_a_trajectory_is_that_of_scipy(double):
    times = np.linspace(0.0, 2.0, 21)
    own = double.solve((0, 2), START, t_eval=times, rtol=1e-12, atol=1e-12)
    other = solve_ivp(double.rhs, (0, 2), START, method="DOP853", t_eval=times, rtol=1e-12, atol=1e-12)
    assert own.y.shape == other.y.shape == (4, 21)
    assert np.abs(own.y - other.y).max() < 1e-8
    assert (own.status, own.success, own.sol) == (0, True, None)
    assert own.nfev > 0 and own.t.tolist() == times.tolist()


def test_the_jacobian_serves_scipy(double):
    own = double.solve((0, 2), START, method="Radau5", rtol=1e-9, atol=1e-9)
    other = solve_ivp(double.rhs, (0, 2), START, method="Radau", jac=double.jacobian, rtol=1e-9, atol=1e-9)
    assert np.abs(own.end[1] - other.y[:, -1]).max() < 1e-5
    assert own.njev > 0 and own.nlu > 0


def test_states_between_steps(double):
    own = double.solve((0, 2), START, rtol=1e-10, atol=1e-10)
    assert own.sol(0.0).tolist() == START
    assert own.sol([0.5, 1.0, 2.0]).shape == (4, 3)
    assert np.abs(own.sol(own.t) - own.y).max() < 1e-12
    with pytest.raises(ValueError, match="2.5"):
        own.sol(2.5)


def test_backward_in_time(double):
    there = double.solve((0, 1), START, rtol=1e-12, atol=1e-12)
    back = double.solve((1, 0), there.end[1], t_eval=[1, 0.5, 0], rtol=1e-12, atol=1e-12)
    assert np.abs(back.y[:, -1] - START).max() < 1e-9


@pytest.mark.parametrize("method", ["Rk45", "Tsit5", "Vern7", "Vern9", "Rodas4", "Rodas5P", "Radau5", "Auto"])
def test_every_method_with_a_tolerance(double, method):
    exact = double.solve((0, 1), START, rtol=1e-13, atol=1e-13).end[1]
    assert np.abs(double.solve((0, 1), START, method=method, rtol=1e-9, atol=1e-9).end[1] - exact).max() < 1e-6


def test_events_are_those_of_scipy(double):
    def hanging(t, x):
        return x[0]

    hanging.direction = -1

    def late(t, x):
        return t - 3.0

    late.terminal = True
    own = double.solve((0, 5), START, events=[hanging, late, "turns", ("tip.x", 0.0)], rtol=1e-10, atol=1e-10)
    other = solve_ivp(double.rhs, (0, 5), START, method="DOP853", events=[hanging, late], rtol=1e-10, atol=1e-10)
    assert own.status == other.status == 1
    assert abs(own.end[0] - 3.0) < 1e-12
    assert np.abs(own.t_events[0] - other.t_events[0]).max() < 1e-7
    assert own.y_events[0].shape == other.y_events[0].shape
    assert np.abs(own.y_events[2][:, 3]).max() < 1e-9 and len(own.t_events[2]) > 0
    assert all(abs(double.output(t, x)["tip.x"]) < 1e-9 for t, x in zip(own.t_events[3], own.y_events[3]))


def test_an_event_has_a_direction_and_an_end(double):
    rising = pendulum.Event(("tip.x", 0.0), direction=1)
    own = double.solve((0, 5), START, events=(rising, pendulum.Event("turns", terminal=True)))
    assert own.status == 1 and len(own.t_events[1]) == 1 and own.end[0] == own.t_events[1][0]
    falling = lambda t, x: x[0]  # noqa: E731
    falling.direction = -1
    one, other = (double.solve((0, 5), START, events=event) for event in (falling, pendulum.Event(falling)))
    assert one.t_events[0].tolist() == other.t_events[0].tolist()
    with pytest.raises(ValueError, match="count"):
        double.solve((0, 5), START, events=pendulum.Event("turns", terminal=3))


def test_a_function_may_solve(double):
    lengths = []

    def event(t, x):
        lengths.append(len(double.solve((0, 0.01), START).t))
        return 1.0

    assert double.solve((0, 0.1), START, events=event).success and len(lengths) > 2


def test_a_solution_can_be_sent(double):
    own = double.solve((0, 1), START)
    other = pickle.loads(pickle.dumps(own))
    assert other.y.tolist() == own.y.tolist() and other.sol is None and other.model.parameters == double.parameters


@pytest.mark.skipif(not hasattr(os, "fork"), reason="there are no forks")
def test_a_fork_has_threads_of_its_own(double):
    double.ensemble((0, 0.1), [START, START])
    child = os.fork()
    if child == 0:
        double.solve((0, 0.1), START)
        double.ensemble((0, 0.1), [START, START])
        os._exit(7)
    _, status = os.waitpid(child, 0)
    assert os.waitstatus_to_exitcode(status) == 7


def test_a_ball_bounces(ball):
    own = ball.solve((0, 2), [1.0, 0.0], rtol=1e-10, atol=1e-10)
    fall = np.sqrt(2 / 9.81)
    assert abs(own.impacts[0].t - fall) < 1e-9
    assert abs(own.impacts[0].after[1] + 0.8 * own.impacts[0].before[1]) < 1e-12
    assert abs(own.impacts[0].impulses["floor"] - 1.8 * 9.81 * fall) < 1e-8
    assert len(own.modes) > 0


def test_an_exception_of_an_event_is_raised(double):
    def event(t, x):
        if t > 0.5:
            raise KeyError("mine")
        return 1.0

    with pytest.raises(KeyError, match="mine"):
        double.solve((0, 1e6), START, events=event)
    with pytest.raises(TypeError):
        double.solve((0, 1), START, events=lambda t, x: "no number")


def test_an_interrupt_has_what_was_reached(double):
    for model, start in ((double, START), (pendulum.Model(chain(12)), [0.1] * 24)):
        threading.Timer(0.3, _thread.interrupt_main).start()
        began = time.monotonic()
        with pytest.raises(KeyboardInterrupt) as caught:
            model.solve((0, 1e9), start, max_steps=10**9, t_eval=[0.0, 1e-3], events=[lambda t, x: -1.0])
        assert time.monotonic() - began < 2.0
        own = caught.value.result
        assert isinstance(caught.value, pendulum.Interrupted)
        assert (own.status, own.success, own.message) == (-1, False, "interrupted")
        assert own.end[0] > 1e-3 and own.t.tolist() == [0.0, 1e-3] and len(own.t_events[0]) == 0


@pytest.mark.parametrize(
    "call",
    [
        lambda m: m.ensemble((0, 1e9), [START] * 40, max_steps=10**9),
        lambda m: m.lyapunov(START, 4, duration=1e9),
        lambda m: m.sensitivity([0, 1e9], START, ["l"]),
    ],
)
def test_an_interrupt_ends_what_is_long(double, call):
    threading.Timer(0.3, _thread.interrupt_main).start()
    began = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        call(double)
    assert time.monotonic() - began < 3.0


def test_too_many_steps_return_what_was_reached(double):
    own = double.solve((0, 100), START, max_steps=20)
    assert own.status == -1 and "20 steps" in own.message and 0.0 < own.end[0] < 100.0


def test_outputs_and_energy_along_a_trajectory(double):
    own = double.solve((0, 1), START)
    assert own.outputs()["tip.x"].shape == own.t.shape
    assert (np.diff(own.energy()) < 1e-6).all()
