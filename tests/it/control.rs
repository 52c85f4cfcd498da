//! Generated mechanisms, linearized and held by regulators.

use approx::assert_relative_eq;
use nalgebra::{Complex, SMatrix, SVector};
use pendulum_core::control::{ControlError, linearize};
use pendulum_core::prelude::*;
use pendulum_core::stability::{Stability, equilibrium};

mechanism! {
    /// A double pendulum on a cart; the angles are 0 upright, the second is relative to the first.
    pub Balancer {
        params { cart: kg = 1, l1: m = 0.5, l2: m = 0.6, g: m/s^2 = 9.81 }
        input push: N,
        gravity: [0, -g, 0],
        body slider on ground { mass: cart, joint: prismatic(x), coordinate: s, torque: push, friction: 0.1 }
        body lower on slider {
            solids: [rod(0.3, [0, 0, 0], [0, l1, 0])], joint: revolute(z), coordinate: theta, friction: 0.002,
        }
        body upper on lower {
            solids: [rod(0.2, [0, 0, 0], [0, l2, 0])], joint: revolute(z) at [0, l1, 0], coordinate: phi,
        }
        point tip on upper at [0, l2, 0],
        output tip: tip,
    }
}

mechanism! {
    /// A plate in flight with four thrusts along its own vertical, which have no torque about it.
    pub Quadrotor {
        params { m: kg = 0.8, l: m = 0.18 }
        input front: N, input back: N, input left: N, input right: N,
        gravity: [0, 0, -9.81],
        body frame on ground {
            solids: [cuboid(m, [0.2, 0.2, 0.04], [0, 0, 0])], joint: free, orientation: o, position: p,
        }
        point f on frame at [l, 0, 0], point b on frame at [-l, 0, 0],
        point s on frame at [0, l, 0], point r on frame at [0, -l, 0],
        force on f: [0, 0, front] in frame, force on b: [0, 0, back] in frame,
        force on s: [0, 0, left] in frame, force on r: [0, 0, right] in frame,
    }
}

mechanism! {
    /// The plate with a pair of forces that turns it about the vertical.
    pub Steered {
        input front: N, input back: N, input left: N, input right: N, input yaw: N,
        gravity: [0, 0, -9.81],
        body frame on ground {
            solids: [cuboid(0.8, [0.2, 0.2, 0.04], [0, 0, 0])], joint: free, orientation: o, position: p,
        }
        point f on frame at [0.18, 0, 0], point b on frame at [-0.18, 0, 0],
        point s on frame at [0, 0.18, 0], point r on frame at [0, -0.18, 0],
        force on f: [0, yaw, front] in frame, force on b: [0, -yaw, back] in frame,
        force on s: [0, 0, left] in frame, force on r: [0, 0, right] in frame,
    }
}

mechanism! {
    /// A cart that sticks, with a pole.
    pub Sticking {
        input push: N,
        gravity: [0, -9.81, 0],
        body slider on ground {
            mass: 1, joint: prismatic(x), coordinate: s, torque: push, friction: 0.3, dry_friction: 0.5,
        }
        body pole on slider {
            solids: [rod(0.2, [0, 0, 0], [0, 0.6, 0])], joint: revolute(z), coordinate: theta,
        }
    }
}

fn balancer() -> Balancer {
    Balancer::new(BalancerParams::default()).expect("physical")
}

fn weights() -> SMatrix<f64, 6, 6> {
    SMatrix::from_diagonal(&[10.0, 10.0, 10.0, 1.0, 1.0, 1.0].into())
}

#[test]
fn a_linear_model_has_the_derivatives_of_the_mechanism() {
    let (model, x, push) = (balancer(), SVector::from([0.3, 0.2, -0.4, 0.5, -0.6, 0.7]), 1.5);
    let dual = model.cast();
    let linear = linearize(&model, 0.0, x, [push])
        .expect("regular")
        .with_outputs(|t, x, u| {
            let tip = dual.tip(t, x);
            [tip[0], tip[1], x[Balancer::DOT_THETA] * u[0]]
        });
    let rhs = |x: &SVector<f64, 6>, push: f64| model.eval(0.0, x, &BalancerInputs { push });
    assert_eq!(linear.drift, rhs(&x, push));
    let h = 1e-5;
    for n in 0..6 {
        let mut change = SVector::zeros();
        change[n] = h;
        let column = (rhs(&(x + change), push) - rhs(&(x - change), push)) / (2.0 * h);
        assert_relative_eq!(linear.a.column(n).into_owned(), column, epsilon = 1e-7);
        let by_tip = (model.tip(0.0, &(x + change)) - model.tip(0.0, &(x - change))) / (2.0 * h);
        assert_relative_eq!(
            linear.c.fixed_view::<2, 1>(0, n),
            by_tip.fixed_rows::<2>(0),
            epsilon = 1e-9
        );
    }
    let column = (rhs(&x, push + h) - rhs(&x, push - h)) / (2.0 * h);
    assert_relative_eq!(linear.b, column, epsilon = 1e-8);
    assert_relative_eq!(linear.c[(2, Balancer::DOT_THETA)], push);
    assert_relative_eq!(linear.d, SMatrix::from([[0.0, 0.0, x[Balancer::DOT_THETA]]]));
    assert_relative_eq!(linear.y0[1], model.tip(0.0, &x)[1]);
    let error = linear.lqr(&weights(), &SMatrix::from([[0.1]])).expect_err("it moves");
    assert!(
        matches!(&error, ControlError::NotAtRest { component, .. } if component.starts_with("dot(")),
        "{error}"
    );
}

#[test]
fn a_double_pendulum_on_a_cart_is_balanced() {
    let model = balancer();
    let price = 0.1;
    let upright = linearize(&model, 0.0, [0.0; 6], [0.0]).expect("regular");
    let regulator = upright
        .lqr(&weights(), &SMatrix::from([[price]]))
        .expect("controllable");
    let closed = model.with_law(regulator.law);
    let held = equilibrium(&closed, [0.01; 6]).expect("upright");
    assert_eq!(held.stability(), Stability::AsymptoticallyStable);
    let fastest = |values: &mut dyn Iterator<Item = Complex<f64>>| values.map(|value| value.norm()).fold(0.0, f64::max);
    let [of_loop, of_design] = [
        fastest(&mut held.spectrum.eigenvalues()),
        fastest(&mut regulator.eigenvalues.iter().copied()),
    ];
    assert_relative_eq!(of_loop, of_design, max_relative = 1e-9);
    // From 5 degrees in both joints.
    let mut start = SVector::zeros();
    (start[Balancer::THETA], start[Balancer::PHI]) = (5.0_f64.to_radians(), -5.0_f64.to_radians());
    let method = Vern9::new().rtol(1e-10).atol(1e-12);
    let end = method.solve(&closed, 0.0, 20.0, start).expect("balanced").end();
    assert!(end.amax() < 1e-5, "{end}");
    // The Riccati equation gives the cost of a small deviation.
    let (law, q) = (regulator.law, weights());
    let start = start * 1e-3;
    let with_cost = FnSystem(|t: f64, x: &SVector<f64, 7>| {
        let state = x.fixed_rows::<6>(0).into_owned();
        let push = -(law.gain * state)[0];
        let rate = closed.rhs(t, &state);
        SVector::from_fn(|n, _| {
            if n < 6 {
                rate[n]
            } else {
                state.dot(&(q * state)) + price * push * push
            }
        })
    });
    let method = Vern9::new().rtol(1e-10).atol(1e-18);
    let longer = SVector::from_fn(|n, _| if n < 6 { start[n] } else { 0.0 });
    let spent = method.solve(&with_cost, 0.0, 40.0, longer).expect("balanced").end()[6];
    assert_relative_eq!(spent, start.dot(&(regulator.cost * start)), max_relative = 1e-5);
}

#[test]
fn a_sampled_regulator_balances_with_held_inputs() {
    let model = balancer();
    let period = 0.02;
    let sampled = linearize(&model, 0.0, [0.0; 6], [0.0])
        .and_then(|upright| upright.discretize(period))
        .expect("regular");
    let regulator = sampled.lqr(&weights(), &SMatrix::from([[0.1]])).expect("controllable");
    let mut x = SVector::zeros();
    (x[Balancer::THETA], x[Balancer::PHI]) = (0.03, -0.02);
    // The first samples follow the linear model to second order.
    let mut predicted = x;
    let method = Vern7::new().rtol(1e-9).atol(1e-12);
    for n in 0..1000 {
        let push = -(regulator.law.gain * x)[0];
        let held = model.with_inputs(move |_, _| BalancerInputs { push });
        x = method.solve(&held, 0.0, period, x).expect("regular").end();
        predicted = (sampled.a - sampled.b * regulator.law.gain) * predicted;
        assert!((x - predicted).amax() < 2e-3, "{n}: {x} {predicted}");
    }
    assert!(x.amax() < 1e-6, "{x}");
}

/// Four thrusts do not turn the frame about its vertical: the heading and its rate are lost, in the names of the model.
/// Both modes have the eigenvalue 0 and the same left eigenvector, the rate.
#[test]
fn a_quadrotor_cannot_be_turned_about_its_vertical() {
    let model = Quadrotor::new(QuadrotorParams::default()).expect("physical");
    let mut hover = SVector::from([0.0; 13]);
    hover[Quadrotor::O] = 1.0;
    let thrust = 0.25 * 0.8 * 9.81;
    let linear = linearize(&model, 0.0, hover, [thrust; 4]).expect("regular");
    let error = linear
        .lqr(&SMatrix::identity(), &SMatrix::identity())
        .expect_err("the heading is lost");
    let ControlError::Unstabilizable(lost) = &error else {
        panic!("{error}")
    };
    assert_eq!(lost.modes.len(), 2, "{error}");
    assert!(lost.modes.iter().all(|mode| mode.eigenvalue.norm() < 1e-7), "{error}");
    let [o_z, dot_o_z] = [Quadrotor::O + 3, Quadrotor::DOT_O + 2];
    for mode in &lost.modes {
        for n in (0..13).filter(|&n| n != o_z && n != dot_o_z) {
            assert!(mode.direction[n].norm() < 1e-9, "{error}");
        }
    }
    assert_eq!(
        error.to_string(),
        "the model cannot be stabilized: no input acts on 2 modes: 0 1/s along dot(o).z, 0 1/s along dot(o).z\n\
         help: add an input that acts along them, fix the joint, or give it friction"
    );
}

#[test]
fn a_body_with_a_quaternion_is_held_in_its_admissible_directions() {
    let model = Steered::new(SteeredParams {}).expect("physical");
    let mut hover = SVector::from([0.0; 13]);
    hover[Steered::O] = 1.0;
    let thrust = 0.25 * 0.8 * 9.81;
    let linear = linearize(&model, 0.0, hover, [thrust, thrust, thrust, thrust, 0.0]).expect("regular");
    assert!(linear.controllability().expect("finite").is_complete());
    let regulator = linear
        .lqr(&SMatrix::identity(), &SMatrix::identity())
        .expect("stabilizable");
    assert_eq!(regulator.eigenvalues.len(), 12);
    // The direction that leaves the unit sphere has no gain.
    assert!(regulator.law.gain.column(Steered::O).amax() < 1e-12);
    let mut start = hover;
    let turned = 0.4_f64;
    (start[Steered::O], start[Steered::O + 1], start[Steered::O + 3]) =
        (turned.cos(), turned.sin() * 0.6, turned.sin() * 0.8);
    start[Steered::P_X] = 0.5;
    let end = Vern7::new()
        .solve(&model.with_law(regulator.law), 0.0, 40.0, start)
        .expect("held")
        .end();
    assert!((end - hover).amax() < 1e-4, "{end}");
    // All positions and the orientation are measured.
    let observed = linear.with_outputs(|_, x, _| std::array::from_fn::<_, 7, _>(|n| x[n]));
    assert!(observed.observability().expect("finite").is_complete());
    let filter = observed
        .kalman(&SMatrix::identity(), &SMatrix::identity())
        .expect("detectable");
    assert!(filter.eigenvalues.len() == 12 && filter.eigenvalues.iter().all(|value| value.re < 0.0));
}

#[test]
fn dry_friction_is_left_out() {
    let model = Sticking::new(StickingParams {}).expect("physical");
    let linear = linearize(&model, 0.0, [0.0; 4], [0.0]).expect("regular");
    // Mass of the cart and of the pole, whose center is at 0.3 m: s'' = (push - 0.3 s') / (m + M / 4) for the pair of
    // equations (M + m) s'' - m c theta'' = push - 0.3 s', -m c s'' + (4/3) m c^2 theta'' = m g c theta.
    let effective = 1.0 + 0.2 * (1.0 - 0.75);
    assert_relative_eq!(linear.b[(Sticking::DOT_S, 0)], 1.0 / effective, max_relative = 1e-14);
    assert_relative_eq!(
        linear.a[(Sticking::DOT_S, Sticking::DOT_S)],
        -0.3 / effective,
        max_relative = 1e-13
    );
}
