"""Ensembles and analyses."""

import numpy as np
import pytest
from pendulum_dynamics import Model

START = np.array([2.0, 1.0, 0.0, 0.5])


def test_an_ensemble_has_the_bits_of_single_trajectories(double):
    random = np.random.default_rng(1)
    starts, lengths = random.uniform(-1, 1, (50, 4)), random.uniform(0.5, 2, 50)
    many = double.ensemble((0, 2), starts, parameters={"l": lengths}, t_eval=[0.5, 1.0], rtol=1e-8, atol=1e-8)
    assert many.y.shape == (50, 4, 2) and many.success.all() and not many.messages
    for n in (0, 17, 49):
        model = double.with_parameters(l=lengths[n])
        one = model.solve((0, 2), starts[n], t_eval=[0.5, 1.0], rtol=1e-8, atol=1e-8)
        assert one.end[1].tolist() == many.y_end[n].tolist()
        assert one.y.tolist() == many.y[n].tolist()


def test_members_that_stop(double):
    starts = np.tile(START, (3, 1))
    many = double.ensemble((0, 100), starts, max_steps=20)
    assert not many.success.any() and "20 steps" in many.messages[1]


def test_one_start_with_many_parameters(double):
    many = double.ensemble((0, 1), START, parameters={"l": [1.0, 2.0], "gamma": 0.2}, method="Rk4", h=0.01)
    assert many.y_end.shape == (2, 4) and many.y_end[0, 0] != many.y_end[1, 0]


def test_an_invalid_start_stops_its_member_only(double, ball):
    for model, method in ((double, "Vern9"), (double, "Radau5"), (ball, "Vern9")):
        starts = np.zeros((3, len(model.states)))
        starts[:, 0] = [1.0, np.nan, 2.0]
        many = model.ensemble((0, 0.1), starts, method=method)
        assert many.success.tolist() == [True, False, True] and "finite" in many.messages[1]


def test_bounces_of_many_balls(ball):
    heights = np.linspace(0.5, 2, 20)
    many = ball.ensemble((0, 1), np.c_[heights, np.zeros(20)])
    assert many.success.all() and (many.y_end[:, 0] >= -1e-9).all()


def test_equilibria(double):
    found = double.equilibria([0.1, 0.1, 0, 0])
    assert [own.stability for own in found] == ["asymptotically stable", *3 * ["unstable"]]
    assert found[0].eigenvalues.dtype == complex and len(found[0].eigenvalues) == 4
    assert found.unsearched == []


def test_rest(ball):
    rest = ball.resting([0.3, 0.0])
    assert abs(rest.x[0]) < 1e-12 and "floor" in rest.mode


def test_chaos(double):
    model = double.with_parameters(gamma=0.0)
    exponents = model.lyapunov(START, 2, duration=100)
    assert exponents.values[0] > 3 * exponents.uncertainty[0] > 0.0
    assert 0.0 < exponents.horizon(1e-9, 1.0) < 100.0


def test_tuned_methods_keep_within_the_error(double):
    starts = np.outer([0.5, 1.0], START)
    choices = double.tune((0, 3), starts, 1e-7)
    assert choices[0].time == min(choice.time for choice in choices)
    for choice in choices:
        assert (choice.h is None) != (choice.rtol is None)
        for start in starts:
            end = double.solve((0, 3), start, **choice.settings).end[1]
            known = double.solve((0, 3), start, rtol=1e-13, atol=1e-13).end[1]
            assert (np.abs(end - known) <= 1e-7 * np.maximum(1.0, np.abs(known))).all()
    with pytest.raises(ValueError, match="at least 8 ulps"):
        double.tune((0, 3), starts, 1e-17)
    with pytest.raises(ValueError, match="4 are needed"):
        double.tune((0, 3), [0.0], 1e-7)


def test_small_motion_is_linear(double):
    answer = double.simplest(1.0, 0.05 * START, outputs=["a", "b"])
    assert answer.simplest is not None and answer.simplest in answer.simpler
    assert max(answer.simplest.observed.values()) <= 0.01
    linear = next(one for one in answer.simpler if one.changes == ["linear about a = 0, b = 0"])
    assert linear.predicted["a"] == pytest.approx(linear.observed["a"], rel=0.1)
    # the declarations are models
    assert Model(linear.declaration).states == ["a", "b", "a_rate", "b_rate"]
    fixed = next(one for one in answer.simpler if one.changes == ["with the joint of `lower` fixed"])
    assert Model(fixed.declaration).parameters["b"] == 0.05
    assert "simplest within" in str(answer)
    with pytest.raises(ValueError, match="no output or component `theta`"):
        double.simplest(1.0, START, outputs="theta")


def test_derivatives(double):
    found = double.sensitivity([0, 0.5, 1], START, ["l", "a"], rtol=1e-11, atol=1e-11)
    assert found.y.shape == (4, 3) and found.derivatives.shape == (4, 2, 3)
    step = 1e-5
    ends = [
        double.with_parameters(l=length).solve((0, 1), START, rtol=1e-12, atol=1e-12).end[1]
        for length in (1 - step, 1 + step)
    ]
    assert np.abs((ends[1] - ends[0]) / (2 * step) - found.derivatives[:, 0, 2]).max() < 1e-6


def test_a_fit(double):
    truth = double.with_parameters(l=1.2, gamma=0.15)
    times = np.linspace(0, 2, 80)
    noise = 1e-4 * np.random.default_rng(2).normal(size=(2, 80))
    a, b = truth.solve((0, 2), [0.8, 0.3, 0, 0], t_eval=times, rtol=1e-10, atol=1e-10).y[:2] + noise
    fit = double.fit(times, {"a": a, "b": b}, rtol=1e-8, atol=1e-9)
    assert fit.success and "converged" in repr(fit)
    assert fit.model.parameters == pytest.approx({"l": 1.2, "gamma": 0.15}, rel=1e-3)
    assert fit.intervals["l"][0] < 1.2 < fit.intervals["l"][1]
    assert fit.noise["a"] == pytest.approx(1e-4, rel=0.3)
    assert fit.covariance.shape == (2, 2) and len(fit.residuals) == 2
    known = double.fit(times, {"a": a}, free=["l"], known=fit.starts[0], bounds={"l": (0.5, 2)}, loss=("huber", 1.5))
    assert known.estimates["l"] == pytest.approx(1.2, rel=0.1)


def test_an_animation(double, tmp_path):
    solution = double.solve((0, 1), START)
    page = solution._repr_html_()
    assert "<canvas" in double.draw(START)._repr_html_()
    assert "<canvas" in page and "NaN" not in page
    solution.animate(speed=0.5).save(tmp_path / "motion.html")
    assert (tmp_path / "motion.html").read_text().startswith("<!doctype html>")
