//! Forces along joints: springs, torques of any form, inputs. Also joints that fix bodies to each other.

use approx::assert_relative_eq;
use nalgebra::{SMatrix, SVector};
use pendulum_core::Real;
use pendulum_core::prelude::*;
use testbed::dual::Dual;

mechanism! {
    /// A driven pendulum on a cart with a spring: every kind of force, and two inputs.
    pub Driven {
        units: none,
        params {
            m: kg = 0.4,
            l: m = 0.7,
            k: N/m = 3,
            rest: m = 0.2,
            c: N m s = 0.05,
            amplitude: N m = 0.3,
        }
        /// Push on the cart.
        input push: N,
        input twist: N m,
        gravity: [0, -9.81, 0],
        let wave = amplitude * sin(3*t + 1/2),

        body cart on ground {
            mass: 2,
            joint: prismatic(x),
            coordinate: s,
            spring: (k, rest),
            torque: push - 0.1 * tanh(5*qd) * abs(qd)^(1/2) * exp(-q^2),
        }
        body rod on cart {
            solids: [rod(m, [0, 0, 0], [0, -l, 0]), point(m/4, [0, -l, 0])],
            joint: revolute(z),
            coordinate: theta,
            friction: c,
            torque: wave + twist * cos(theta) - 0.02 * dot(s) * atan2(sin(q), 2 + cos(q)),
        }
    }
}

fn driven<T: Real>() -> Driven<T> {
    Driven::new(DrivenParams::default()).expect("physical").cast()
}

#[test]
fn joint_forces_act_as_declared() {
    let model = driven::<f64>();
    let (s, theta, ds, dtheta) = (0.3_f64, 0.8_f64, -0.6_f64, 1.1_f64);
    let inputs = DrivenInputs { push: 1.5, twist: -0.4 };
    let t = 0.9_f64;
    let rhs = model.eval(t, &SVector::from([s, theta, ds, dtheta]), &inputs);
    let (m, l, bob) = (0.4, 0.7, 0.1);
    // by hand: a rod and a point at its end on a cart
    let (first, second) = (m * l / 2.0 + bob * l, m * l * l / 3.0 + bob * l * l);
    let (sine, cosine) = theta.sin_cos();
    let slide = 1.5 - 0.1 * (5.0 * ds).tanh() * ds.abs().sqrt() * (-s * s).exp() - 3.0 * (s - 0.2);
    let wave = 0.3 * (3.0 * t + 0.5).sin();
    let turn = wave - 0.4 * cosine - 0.02 * ds * sine.atan2(2.0 + cosine) - 0.05 * dtheta;
    let (a, b, d) = (2.0 + m + bob, first * cosine, second);
    let f = slide + first * sine * dtheta * dtheta;
    let g = turn - 9.81 * first * sine;
    let determinant = a * d - b * b;
    assert_relative_eq!(rhs[2], (d * f - b * g) / determinant, max_relative = 1e-13);
    assert_relative_eq!(rhs[3], (a * g - b * f) / determinant, max_relative = 1e-13);
}

#[test]
fn jacobians_by_state_and_by_inputs_are_the_derivatives() {
    let (model, dual) = (driven::<f64>(), driven::<Dual>());
    let (t, x, u) = (0.9, [0.3, 0.8, -0.6, 1.1], [1.5, -0.4]);
    let column = |which: usize| {
        let at = |n: usize, value: f64| Dual::new(value, if n == which { 1.0 } else { 0.0 });
        let state = SVector::<Dual, 4>::from_fn(|n, _| at(n, x[n]));
        let inputs = DrivenInputs {
            push: at(4, u[0]),
            twist: at(5, u[1]),
        };
        dual.eval(Dual::new(t, 0.0), &state, &inputs)
            .map(|component| component.slope)
    };
    let inputs = DrivenInputs {
        push: u[0],
        twist: u[1],
    };
    let by_state = SMatrix::from_columns(&[0, 1, 2, 3].map(column));
    let by_inputs = SMatrix::from_columns(&[4, 5].map(column));
    assert_relative_eq!(
        model.eval_with_jacobian(t, &SVector::from(x), &inputs).1,
        by_state,
        epsilon = 1e-13
    );
    assert_relative_eq!(
        model.input_jacobian(t, &SVector::from(x), &inputs),
        by_inputs,
        epsilon = 1e-13
    );
}

#[test]
fn a_law_for_the_inputs_makes_a_system() {
    let model = driven::<f64>();
    let law = |t: f64, x: &SVector<f64, 4>| DrivenInputs {
        push: -20.0 * x[0] - 8.0 * x[2],
        twist: 0.1 * t,
    };
    let closed = model.with_inputs(law);
    let solution = Rk45::new()
        .solve(&closed, 0.0, 10.0, [0.5, 0.1, 0.0, 0.0])
        .expect("regular");
    let (t, x) = solution.last();
    assert_eq!(t, 10.0);
    assert_eq!(closed.rhs(t, &x), model.eval(t, &x, &law(t, &x)));
    assert!(x[0].abs() < 0.5, "the cart is held");
}

mechanism! {
    /// A mass on a spring in a turned frame: `x'' = -k (x - rest) / m`.
    pub Oscillator {
        params { m: kg = 2, k: N/m = 8, rest: m = 0.5 }
        body bead on ground { mass: m, joint: prismatic([1, 1, 0]) rpy [0.3, 0.2, 0.1], coordinate: x,
            spring: (k, rest) }
    }
}

#[test]
fn a_spring_keeps_its_energy() {
    let model = Oscillator::new(OscillatorParams::default()).expect("physical");
    assert_eq!(Oscillator::COST["rhs"].flops(), 2, "{}", Oscillator::COST["rhs"]);
    let solution = Rk45::new()
        .rtol(1e-10)
        .atol(1e-10)
        .solve(&model, 0.0, 10.0, [1.5, 0.0])
        .expect("regular");
    for (t, x) in solution.points() {
        assert_relative_eq!(x[0], 0.5 + (2.0 * t).cos(), epsilon = 1e-8);
        assert_relative_eq!(model.energy(t, x), 4.0, epsilon = 1e-7);
    }
}

mechanism! {
    /// One body of two solids.
    pub OnePiece {
        gravity: [1, -9.81, 2],
        body stick on ground { mass: 1, com: [0, -0.5, 0], inertia: [0.1, 0.02, 0.1], joint: revolute(z),
            coordinate: q1 }
        body hammer on stick {
            solids: [rod(0.5, [0, 0, 0], [0, -1, 0]), cuboid(1.2, [0.2, 0.1, 0.1], [0.1, -1, 0.3])],
            joint: revolute([1, 2, 3]) at [0, -1, 0],
            coordinate: q2,
        }
    }
}

mechanism! {
    /// `OnePiece` in three bodies, one of them massless, fixed to each other in turned frames.
    pub Pieces {
        gravity: [1, -9.81, 2],
        body stick on ground { mass: 1, com: [0, -0.5, 0], inertia: [0.1, 0.02, 0.1], joint: revolute(z),
            coordinate: q1 }
        body handle on stick {
            solids: [rod(0.5, [0, 0, 0], [0, -1, 0])],
            joint: revolute([1, 2, 3]) at [0, -1, 0],
            coordinate: q2,
        }
        body socket on handle { joint: fixed at [0, -1, 0] rpy [0, 0, pi/2] }
        // y of the socket is -x of the handle, x of the socket is its y
        body head on socket { solids: [cuboid(1.2, [0.1, 0.2, 0.1], [0, -0.1, 0.3])], joint: fixed }
    }
}

#[test]
fn bodies_fixed_to_each_other_are_one() {
    let one = OnePiece::new(OnePieceParams {}).expect("physical");
    let pieces = Pieces::new(PiecesParams {}).expect("physical");
    let counts =
        [OnePiece::COST, Pieces::COST].map(|cost| ["rhs", "jacobian", "kinetic"].map(|name| cost[name].operations));
    assert_eq!(counts[0], counts[1]);
    let x = SVector::from([0.4, -1.3, 0.8, 2.0]);
    assert_relative_eq!(one.rhs(0.0, &x), pieces.rhs(0.0, &x), epsilon = 1e-12);
    assert_relative_eq!(one.energy(0.0, &x), pieces.energy(0.0, &x), epsilon = 1e-12);
}

mechanism! {
    /// Children may be declared before their parents.
    pub Backwards {
        gravity: [0, -9.81, 0],
        body lower on upper { mass: 1, com: [0, -1, 0], joint: revolute(z) at [0, -1, 0], coordinate: second }
        body upper on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: first }
    }
}

#[test]
fn coordinates_stand_in_the_order_of_the_text() {
    assert_eq!(Backwards::COORDINATES, ["second", "first"]);
    let model = Backwards::new(BackwardsParams {}).expect("physical");
    // only the lower body is turned from the vertical: gravity pulls it back, and nothing pulls the upper one first
    let rhs = model.rhs(0.0, &SVector::from([0.1, 0.0, 0.0, 0.0]));
    assert!(rhs[2] < 0.0);
}

mechanism! {
    /// A joint on a skew axis with a pitch, as a screw about a point.
    pub Screw {
        gravity: [0, 0, -10],
        body nut on ground {
            mass: 2, com: [0, 0, 0], inertia: [0.5, 0.5, 0.5],
            // w = (0, 0, 2), v = p x w + h w for p = (0.3, 0, 0) and h = 0.1; w need not be a unit vector
            joint: screw([0, 0, 2, 0, -0.6, 0.2]),
            coordinate: turn,
        }
    }
}

#[test]
fn a_screw_turns_about_its_own_line() {
    let model = Screw::new(ScrewParams {}).expect("physical");
    let x = SVector::from([0.7, 1.5]);
    // the nut is 0.3 m off the axis and climbs 0.1 m per radian
    let inertia = 0.5 + 2.0 * (0.3 * 0.3 + 0.1 * 0.1);
    assert_relative_eq!(model.kinetic(0.0, &x), 0.5 * inertia * 1.5 * 1.5, epsilon = 1e-14);
    assert_relative_eq!(model.potential(0.0, &x), 2.0 * 10.0 * 0.1 * 0.7, epsilon = 1e-14);
    assert_relative_eq!(model.rhs(0.0, &x)[1], -2.0 * 10.0 * 0.1 / inertia, epsilon = 1e-14);
}
