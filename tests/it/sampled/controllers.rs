//! Ready controllers: PID, output feedback.

use nalgebra::{SMatrix, SVector};
use pendulum_core::control::{Controller, Pid, Sampled, linearize};
use pendulum_core::prelude::*;

use super::{Cart, CartParams, cart};

/// Commands of a controller for measurements with a period of 0.1 s.
fn commands(pid: Pid, measured: &[f64], limits: [f64; 2]) -> Vec<f64> {
    let mut state = Controller::<f64, 1, 1>::start(&pid, 0.1);
    let sample = |&y: &f64| {
        let command = pid.sample(0.0, &SVector::from([y]), &mut state);
        pid.sent(
            &command,
            &command.map(|u: f64| u.clamp(limits[0], limits[1])),
            &mut state,
        );
        command[0]
    };
    measured.iter().map(sample).collect()
}

fn assert_near(found: &[f64], expected: &[f64]) {
    assert!(
        found.iter().zip(expected).all(|(x, y)| (x - y).abs() < 1e-12),
        "{found:?} {expected:?}"
    );
}

#[test]
fn the_parts_of_a_pid_controller_are_those_of_its_definition() {
    let free = [f64::NEG_INFINITY, f64::INFINITY];
    let y = [0.0, 1.0, 3.0, 3.0];
    assert_near(
        &commands(Pid::new(2.0, 0.0, 0.0).set_point(5.0), &y, free),
        &[10.0, 8.0, 4.0, 4.0],
    );
    assert_near(
        &commands(Pid::new(2.0, 0.0, 0.0).set_point(5.0).weight(0.5), &y, free),
        &[5.0, 3.0, -1.0, -1.0],
    );
    assert_near(
        &commands(Pid::new(0.0, 3.0, 0.0).set_point(2.0), &y, free),
        &[0.0, 0.6, 0.9, 0.6],
    );
    assert_near(
        &commands(Pid::new(0.0, 3.0, 0.0).set_point(2.0).offset(1.5), &y, free),
        &[1.5, 2.1, 2.4, 2.1],
    );
    assert_near(
        &commands(Pid::new(0.0, 0.0, 4.0).set_point(2.0), &y, free),
        &[0.0, -40.0, -80.0, 0.0],
    );
    // D = (0.3 D - 4 dy) / 0.4
    let filtered = [0.0, -10.0, -27.5, -20.625];
    assert_near(&commands(Pid::new(0.0, 0.0, 4.0).filter(0.3), &y, free), &filtered);
    // integral: 0.6, minus half of the excess of 8.1 over 6
    let tracked = commands(
        Pid::new(2.0, 3.0, 0.0).set_point(2.0).offset(4.1).tracking(0.2),
        &[0.0, 0.0],
        [0.0, 6.0],
    );
    assert_near(&tracked, &[8.1, 4.0 + 4.1 + 0.6 - 1.05]);
}

#[test]
fn a_limited_integral_does_not_wind_up() {
    let overshoot = |pid: Pid| {
        let sampled = Sampled::of_components(pid.set_point(1.0), 0.01, [Cart::S]).limits([-10.0], [10.0]);
        let motion = sampled
            .solve(&Vern7::new(), &cart(), 0.0, 30.0, [0.0, 0.0])
            .expect("a motion");
        let highest = motion.trajectory.x().iter().map(|x| x[0]).fold(0.0, f64::max);
        assert!(
            (motion.trajectory.end()[0] - 1.0).abs() < 1e-3,
            "{}",
            motion.trajectory.end()
        );
        assert!(motion.samples.iter().any(|sample| sample.sent == [10.0]));
        highest - 1.0
    };
    let pid = Pid::new(40.0, 40.0, 16.0);
    let (tracked, wound_up) = (overshoot(pid), overshoot(pid.tracking(f64::INFINITY)));
    assert!(
        0.0 < tracked && tracked < 0.1 && wound_up > 2.0 * tracked,
        "{tracked} {wound_up}"
    );
}

#[test]
fn errors_of_an_estimate_have_the_covariance_that_the_filter_predicts() {
    let (period, push, error) = (0.05, 2.0, 0.02);
    let model = Cart::new(CartParams::default()).expect("physical");
    let linear = linearize(&model, 0.0, [0.0; 2], [0.0]).expect("regular");
    let linear = linear
        .with_outputs(|_t, x, _u| [x[Cart::S]])
        .discretize(period)
        .expect("regular");
    let law = linear
        .lqr(&SMatrix::from_diagonal(&[100.0, 1.0].into()), &SMatrix::from([[0.1]]))
        .expect("regular")
        .law;
    let disturbance = linear.b * linear.b.transpose() * (push * push);
    let filter = linear
        .kalman(&disturbance, &SMatrix::from([[error * error]]))
        .expect("regular");
    let controller = linear.output_feedback(&law, &filter).expect("regular");
    let sampled = Sampled::of_components(controller, period, [Cart::S])
        .noise([error])
        .input_noise([push])
        .seed(3);
    let motion = sampled
        .solve(&tight(), &model, 0.0, 4000.0, [0.0, 0.0])
        .expect("a motion");
    // predictions of the filter, from what it measured and sent
    let mut estimate = SVector::from([0.0, 0.0]);
    let mut covariance = SMatrix::<f64, 2, 2>::zeros();
    let mut spread = SMatrix::<f64, 2, 2>::zeros();
    let count = motion.samples.len() as f64;
    for sample in &motion.samples {
        let x = motion.trajectory.at(sample.t).expect("regular");
        covariance += (x - estimate) * (x - estimate).transpose() / count;
        spread += x * x.transpose() / count;
        estimate += filter.gain * (sample.measured[0] - estimate[0]);
        assert!((sample.command[0] + (law.gain * estimate)[0]).abs() < 1e-9);
        estimate = linear.a * estimate + linear.b * sample.sent[0];
    }
    // the errors of a covariance over 80,000 correlated samples
    let size = |i: usize, j: usize| (filter.covariance[(i, i)] * filter.covariance[(j, j)]).sqrt();
    for (i, j) in [(0, 0), (0, 1), (1, 1)] {
        let deviation = (covariance[(i, j)] - filter.covariance[(i, j)]) / size(i, j);
        assert!(deviation.abs() < 0.03, "{covariance} {}", filter.covariance);
    }
    // the state has the covariance of the closed loop: x+ = A x - B K z + B w, z the corrected estimate
    let closed = |p: SMatrix<f64, 4, 4>| {
        let (a, b, l) = (linear.a, linear.b, filter.gain);
        let feedback = b * law.gain;
        let corrected = SMatrix::identity() - l * linear.c;
        let mut whole = SMatrix::<f64, 4, 4>::zeros();
        // state, and error of the prediction e: z = x - (1 - L C) e + L v
        whole.fixed_view_mut::<2, 2>(0, 0).copy_from(&(a - feedback));
        whole.fixed_view_mut::<2, 2>(0, 2).copy_from(&(feedback * corrected));
        whole.fixed_view_mut::<2, 2>(2, 2).copy_from(&(a * corrected));
        let mut noise = SMatrix::<f64, 4, 2>::zeros();
        noise.fixed_view_mut::<2, 1>(0, 0).copy_from(&(b * push));
        noise.fixed_view_mut::<2, 1>(2, 0).copy_from(&(b * push));
        noise.fixed_view_mut::<2, 1>(0, 1).copy_from(&(-feedback * l * error));
        noise.fixed_view_mut::<2, 1>(2, 1).copy_from(&(-a * l * error));
        whole * p * whole.transpose() + noise * noise.transpose()
    };
    let expected = (0..10_000).fold(SMatrix::<f64, 4, 4>::zeros(), |p, _| closed(p));
    for i in 0..2 {
        let ratio = spread[(i, i)] / expected[(i, i)];
        assert!((ratio - 1.0).abs() < 0.03, "{spread} {expected}");
    }
}

fn tight() -> Tsit5 {
    Tsit5::new().rtol(1e-9).atol(1e-10)
}

#[test]
fn a_filter_knows_what_was_sent() {
    // under limits the estimate converges to the state without noise
    let linear = linearize(&cart(), 0.0, [0.5, 0.0], [4.0]).expect("regular");
    let linear = linear
        .with_outputs(|_t, x, _u| [x[Cart::S]])
        .discretize(0.02)
        .expect("regular");
    let law = linear
        .lqr(&SMatrix::from_diagonal(&[1e4, 1.0].into()), &SMatrix::from([[0.1]]))
        .expect("regular")
        .law;
    let filter = linear
        .kalman(&SMatrix::from_diagonal(&[1e-8, 1.0].into()), &SMatrix::from([[1e-6]]))
        .expect("regular");
    let controller = linear
        .output_feedback(&law, &filter)
        .expect("regular")
        .guess([0.0, 1.0]);
    let sampled = Sampled::of_components(controller, 0.02, [Cart::S]).limits([-5.0], [5.0]);
    let motion = sampled
        .solve(&tight(), &cart(), 0.0, 20.0, [-2.0, 3.0])
        .expect("a motion");
    let late = &motion.samples[50..];
    assert!(late.iter().any(|sample| sample.sent != sample.command));
    for sample in late {
        let x = motion.trajectory.at(sample.t).expect("regular");
        let exact = law.u0[0] - (law.gain * (x - law.x0))[0];
        assert!(
            (sample.command[0] - exact).abs() < 1e-3,
            "{} {exact}",
            sample.command[0]
        );
    }
    assert!((motion.trajectory.end() - SVector::from([0.5, 0.0])).amax() < 1e-2);
}
