//! Points of bodies, the forces on them, and their outputs: against kinematics by hand, dual numbers, and the same
//! mechanism without any of these.

use approx::assert_relative_eq;
use nalgebra::{Isometry3, Matrix3, SMatrix, SVector, Translation3, Unit, UnitQuaternion, Vector3};
use pendulum_core::prelude::*;
use testbed::dual::Dual;
use testbed::power_series;
use testbed::random::Random;
use testbed::robots::{Ur5Flange, Ur5FlangeParams};

/// Bodies of an arm in space, with further items.
macro_rules! arm {
    ($name:ident { $($items:tt)* }) => {
        mechanism! {
            pub $name {
                units: none,
                params { l: m = 0.4, k: N/m = 3, c: N s/m = 0.4, w: rad/s = 2 }
                $($items)*
                gravity: [1, -2, -9.81],
                body a on ground { mass: 2, com: [0.1, l, 0.3], inertia: [0.3, 0.4, 0.5, 0.01, 0.02, 0.03],
                    joint: revolute([1, 2, -1]) at [0.1, 0, 0.4], coordinate: q1 }
                body b on a { mass: 1.5, com: [0, -0.3, 0.1], inertia: [0.2, 0.3, 0.25],
                    joint: revolute([0, 1, 1]) at [0.3, 0.1, 0] rpy [0.4, -0.7, 1.1], coordinate: q2 }
                body c on b { mass: 0.7, com: [0.2, 0, 0], inertia: [0.1, 0.1, 0.1],
                    joint: fixed at [0, 0.2, 0.5] rpy [1, 0.2, 0] }
                body d on a { mass: 0.5, com: [0.2, 0, 0], inertia: [0.1, 0.1, 0.1],
                    joint: prismatic(-y) at [0, 0.2, 0.5], coordinate: q3 }
            }
        }
    };
}

arm!(Bare { output unused: [k, c, w], generate: [rhs, mass_matrix, bias], });

arm!(Arm {
    point nail on ground at [1, 2, 3],
    point elbow on a at [0.3, 0, 0.1],
    point hand on c at [0, 0.2, l],
    point horn on b at [0.1, 0, 0],
    let wave = sin(w*t),
    force on hand: [elbow.y, wave, dot(hand.x)],
    force on horn: [1, dot(q2), horn.z] in b,
    force q2: -0.2*dot(q1)^3,
    spring between hand and nail: (k, 0.7),
    spring between elbow and nail: (2, 0),
    damper between nail and horn: c,
    potential: 0.2*hand.z^4 + cos(q1)*t,
    dissipation: 0.1*(dot(q2) + dot(hand.y))^2,
    /// Where the hand is.
    output hand: hand,
    output speed: [dot(hand.x), dot(hand.y), dot(hand.z)],
    output turned: rotation(c),
    output far: distance(hand, nail),
    output approach: dot(distance(hand, nail)),
    event passes: hand.z - 1/2,
    generate: [rhs, jacobian, energy, taylor, canonical, parameter_jacobian],
});

const STATES: usize = 5;

#[test]
fn the_flange_of_a_robot_is_where_its_joints_take_it() {
    let robot = Ur5Flange::new(Ur5FlangeParams {}).expect("no parameters");
    let turned = |axis: Vector3<f64>, angle| UnitQuaternion::from_axis_angle(&Unit::new_normalize(axis), angle);
    let (y, z, quarter) = (Vector3::y(), Vector3::z(), std::f64::consts::FRAC_PI_2);
    let joints = [
        ([0.0, 0.0, 0.089159], 0.0, z),
        ([0.0, 0.13585, 0.0], quarter, y),
        ([0.0, -0.1197, 0.425], 0.0, y),
        ([0.0, 0.0, 0.39225], quarter, y),
        ([0.0, 0.093, 0.0], 0.0, z),
        ([0.0, 0.0, 0.09465], 0.0, y),
    ];
    for (t, x) in states::<12>() {
        let mut pose = Isometry3::identity();
        let mut axes = Vec::new();
        for (k, &(at, pitch, axis)) in joints.iter().enumerate() {
            pose *= Isometry3::from_parts(Translation3::from(Vector3::from(at)), turned(y, pitch));
            axes.push((pose.translation.vector, pose.rotation * axis));
            pose *= turned(axis, x[k]);
        }
        let flange = pose.transform_point(&[0.0, 0.0823, 0.0].into()).coords;
        let (place, jacobian) = robot.flange_and_jacobian(t, &x);
        assert_relative_eq!(place, flange, epsilon = 1e-15);
        for (k, (origin, axis)) in axes.into_iter().enumerate() {
            let column = axis.cross(&(flange - origin));
            assert_relative_eq!(jacobian.column(k).into_owned(), column, epsilon = 1e-15);
        }
    }
    let operations = Ur5Flange::COST["flange_and_jacobian"].operations;
    assert_eq!(
        (operations.additions + operations.multiplications, operations.sincos),
        (51, 5)
    );
}

fn arm() -> Arm {
    Arm::new(ArmParams::default()).expect("physical")
}

/// Random times and states.
fn states<const N: usize>() -> impl Iterator<Item = (f64, SVector<f64, N>)> {
    let mut random = Random::new(7);
    (0..STATES).map(move |_| {
        (
            random.between(0.0, 2.0),
            SVector::from_fn(|_, _| random.between(-1.5, 1.5)),
        )
    })
}

/// Derivative of `f` along a direction of time and state.
fn along<const N: usize, const M: usize>(
    f: impl Fn(Dual, &SVector<Dual, N>) -> SVector<Dual, M>,
    (t, x): (f64, &SVector<f64, N>),
    (dt, dx): (f64, &SVector<f64, N>),
) -> SVector<f64, M> {
    let state = SVector::from_fn(|n, _| Dual::new(x[n], dx[n]));
    f(Dual::new(t, dt), &state).map(|value| value.slope)
}

/// Derivatives of `f` with respect to the state.
fn by_state<const N: usize, const M: usize>(
    f: impl Fn(Dual, &SVector<Dual, N>) -> SVector<Dual, M>,
    at: (f64, &SVector<f64, N>),
) -> SMatrix<f64, M, N> {
    let columns: Vec<_> = (0..N)
        .map(|n| along(&f, at, (0.0, &SVector::from_fn(|i, _| f64::from(u8::from(i == n))))))
        .collect();
    SMatrix::from_columns(&columns)
}

/// Poses of the bodies a, b and c by hand.
fn poses(x: &SVector<f64, 6>) -> [Isometry3<f64>; 3] {
    let turn =
        |axis: [f64; 3], angle| UnitQuaternion::from_axis_angle(&Unit::new_normalize(Vector3::from(axis)), angle);
    let at = |place: [f64; 3], turned: UnitQuaternion<f64>| {
        Isometry3::from_parts(Translation3::from(Vector3::from(place)), turned)
    };
    let a = at([0.1, 0.0, 0.4], turn([1.0, 2.0, -1.0], x[0]));
    let b = a * at(
        [0.3, 0.1, 0.0],
        UnitQuaternion::from_euler_angles(0.4, -0.7, 1.1) * turn([0.0, 1.0, 1.0], x[1]),
    );
    [
        a,
        b,
        b * at([0.0, 0.2, 0.5], UnitQuaternion::from_euler_angles(1.0, 0.2, 0.0)),
    ]
}

#[test]
fn points_are_where_their_bodies_are() {
    for (t, x) in states::<6>() {
        let [_, _, c] = poses(&x);
        let hand = c.transform_point(&[0.0, 0.2, 0.4].into()).coords;
        assert_relative_eq!(arm().hand(t, &x), hand, epsilon = 1e-14);
        assert_relative_eq!(
            arm().turned(t, &x),
            c.rotation.to_rotation_matrix().into_inner(),
            epsilon = 1e-14
        );
        assert_relative_eq!(
            arm().far(t, &x),
            (hand - Vector3::new(1.0, 2.0, 3.0)).norm(),
            epsilon = 1e-14
        );
    }
}

#[test]
fn rates_and_jacobians_are_those_of_the_values() {
    let (model, dual) = (arm(), arm().cast::<Dual>());
    for (t, x) in states::<6>() {
        let rate = model.rhs(t, &x);
        let at = (t, &x);
        let along_motion = (1.0, &rate);
        assert_relative_eq!(
            model.hand_rate(t, &x),
            along(|t, x| dual.hand(t, x), at, along_motion),
            epsilon = 1e-13
        );
        assert_relative_eq!(model.hand_rate(t, &x), model.speed(t, &x), epsilon = 1e-14);
        let acceleration = along(|t, x| dual.speed(t, x), at, along_motion);
        assert_relative_eq!(model.speed_rate(t, &x), acceleration, max_relative = 1e-12);
        let all = along(|t, x| dual.outputs(t, x), at, along_motion);
        assert_relative_eq!(model.output_rates(t, &x), all, max_relative = 1e-12);
        let (values, jacobian) = model.outputs_and_jacobian(t, &x);
        assert_relative_eq!(values, model.outputs(t, &x), epsilon = 1e-14);
        assert_relative_eq!(jacobian, by_state(|t, x| dual.outputs(t, x), at), epsilon = 1e-12);
        let (hand, of_hand) = model.hand_and_jacobian(t, &x);
        assert_relative_eq!(hand, model.hand(t, &x), epsilon = 1e-14);
        assert_relative_eq!(of_hand, jacobian.fixed_rows::<3>(0).into_owned(), epsilon = 1e-13);
        let (turned, of_turned) = model.turned_and_jacobian(t, &x);
        let places = [(0, 0), (2, 0), (1, 2)];
        for (row, column) in places {
            assert_relative_eq!(turned[(row, column)], values[6 + row + 3 * column], epsilon = 1e-14);
            let (ours, all) = (of_turned.row(row + 3 * column), jacobian.row(6 + row + 3 * column));
            assert_relative_eq!(ours.into_owned(), all.into_owned(), epsilon = 1e-13);
        }
    }
    assert_eq!(Arm::OUTPUTS[..4], ["hand.x", "hand.y", "hand.z", "speed[0]"]);
    assert_eq!(Arm::OUTPUTS.len(), 17);
}

/// `A qdd + b = Q` with A and b of the arm alone, and Q from the Jacobians of the points of application.
#[test]
fn forces_act_through_the_jacobians_of_their_points() {
    let (model, bare) = (arm(), Bare::new(BareParams::default()).expect("physical"));
    for (t, x) in states::<6>() {
        let qdd = model.rhs(t, &x).fixed_rows::<3>(3).into_owned();
        let left = bare.mass_matrix(t, &x) * qdd + bare.bias(t, &x);
        let [_, b, _] = poses(&x);
        let qd = x.fixed_rows::<3>(3).into_owned();
        // Jacobians of the other points by differences of poses, accurate to 1e-10
        let by_differences = |point: &dyn Fn(&[Isometry3<f64>; 3]) -> Vector3<f64>| {
            let columns = [0, 1, 2].map(|n| {
                let moved = |h: f64| {
                    let mut x = x;
                    x[n] += h;
                    point(&poses(&x))
                };
                let slope = |h: f64| (moved(h) - moved(-h)) / (2.0 * h);
                (4.0 * slope(1e-3) - slope(2e-3)) / 3.0
            });
            Matrix3::from_columns(&columns)
        };
        let (hand, of_hand) = model.hand_and_jacobian(t, &x);
        let of_hand: Matrix3<f64> = of_hand.fixed_columns::<3>(0).into_owned();
        let nail = Vector3::new(1.0, 2.0, 3.0);
        let at_elbow = |poses: &[Isometry3<f64>; 3]| poses[0].transform_point(&[0.3, 0.0, 0.1].into()).coords;
        let at_horn = |poses: &[Isometry3<f64>; 3]| poses[1].transform_point(&[0.1, 0.0, 0.0].into()).coords;
        let (elbow, horn) = (at_elbow(&poses(&x)), at_horn(&poses(&x)));
        let (of_elbow, of_horn) = (by_differences(&at_elbow), by_differences(&at_horn));
        let (hand_rate, horn_rate) = (of_hand * qd, of_horn * qd);
        let push = Vector3::new(elbow.y, (2.0 * t).sin(), hand_rate.x);
        let thrust = b.rotation * Vector3::new(1.0, qd[1], horn.z);
        let spring =
            |from: Vector3<f64>, k: f64, length: f64| k * (1.0 - length / (nail - from).norm()) * (nail - from);
        let axis = (horn - nail).normalize();
        let damper = -0.4 * axis.dot(&horn_rate) * axis;
        let lost = 0.2 * (qd[1] + hand_rate.y);
        let on_hand = push + spring(hand, 3.0, 0.7) - Vector3::new(0.0, lost, 0.8 * hand.z.powi(3));
        let mut force = of_hand.transpose() * on_hand;
        force += of_horn.transpose() * (thrust + damper) + of_elbow.transpose() * spring(elbow, 2.0, 0.0);
        force += Vector3::new(x[0].sin() * t, -0.2 * qd[0].powi(3) - lost, 0.0);
        assert_relative_eq!(left, force, epsilon = 1e-10, max_relative = 1e-10);
    }
}

#[test]
fn derivatives_follow_through_points() {
    let (model, dual) = (arm(), arm().cast::<Dual>());
    for (t, x) in states::<6>() {
        let at = (t, &x);
        assert_relative_eq!(
            model.jacobian(t, &x),
            by_state(|t, x| dual.rhs(t, x), at),
            max_relative = 1e-11
        );
        let by_time = along(|t, x| dual.rhs(t, x), at, (1.0, &SVector::zeros()));
        assert_relative_eq!(
            model.time_derivative(t, &x),
            by_time,
            max_relative = 1e-12,
            epsilon = 1e-12
        );
        let rate = model.rhs(t, &x);
        let (variables, rates) = model.canonical(t, &x);
        assert_relative_eq!(
            along(|t, x| dual.canonical(t, x).0, at, (1.0, &rate)),
            rates,
            epsilon = 1e-11
        );
        let of_both = model.canonical_jacobian(t, &x);
        assert_relative_eq!(of_both.0, by_state(|t, x| dual.canonical(t, x).0, at), epsilon = 1e-12);
        assert_relative_eq!(of_both.1, by_state(|t, x| dual.canonical(t, x).1, at), epsilon = 1e-11);
        assert_relative_eq!(variables.fixed_rows::<3>(0), x.fixed_rows::<3>(0));
        let slopes = model.parameter_jacobian(t, &x);
        for n in 0..4 {
            let moved = |h: f64| {
                let mut params = model.params().to_array();
                params[n] += h;
                let moved = model.with_params(ArmParams::from_array(params)).expect("physical");
                moved.rhs(t, &x)
            };
            let slope = |h: f64| (moved(h) - moved(-h)) / (2.0 * h);
            let by_differences = (4.0 * slope(1e-3) - slope(2e-3)) / 3.0;
            assert_relative_eq!(
                slopes.column(n).into_owned(),
                by_differences,
                epsilon = 1e-8,
                max_relative = 1e-8
            );
        }
    }
}

#[test]
fn series_follow_through_points() {
    let (model, independent) = (arm(), arm().cast::<power_series::Series>());
    for (t, x) in states::<6>() {
        let mut series = vec![x; 13];
        model.series(t, &mut series, &mut model.workspace());
        for (ours, theirs) in series.iter().zip(power_series::motion(&independent, t, x)) {
            let scale = theirs.amax().max(1.0);
            assert_relative_eq!(ours, &theirs, epsilon = 1e-10 * scale);
        }
    }
}

/// The rate of the energy is the power of the forces without potential, plus the partial time derivative of the
/// potential.
#[test]
fn the_power_of_forces_is_the_change_of_energy() {
    let (model, dual) = (arm(), arm().cast::<Dual>());
    for (t, x) in states::<6>() {
        let rate = model.rhs(t, &x);
        let energy = |t, x: &SVector<Dual, 6>| SVector::from([dual.energy(t, x)]);
        let change = along(energy, (t, &x), (1.0, &rate))[0];
        let [a, b, _] = poses(&x);
        let qd = x.fixed_rows::<3>(3).into_owned();
        let velocity = model.hand_rate(t, &x);
        let push = Vector3::new(
            a.transform_point(&[0.3, 0.0, 0.1].into()).y,
            (2.0 * t).sin(),
            velocity.x,
        );
        let axis_a = Vector3::new(1.0, 2.0, -1.0).normalize();
        let spin = axis_a * qd[0] + b.rotation * Vector3::new(0.0, 1.0, 1.0).normalize() * qd[1];
        let horn = b.transform_point(&[0.1, 0.0, 0.0].into()).coords;
        let origin = b.translation.vector;
        let horn_rate = (axis_a * qd[0]).cross(&(origin - a.translation.vector)) + spin.cross(&(horn - origin));
        let thrust = b.rotation * Vector3::new(1.0, qd[1], horn.z);
        let axis = (horn - Vector3::new(1.0, 2.0, 3.0)).normalize();
        let powers = [
            push.dot(&velocity),
            thrust.dot(&horn_rate),
            -0.2 * qd[0].powi(3) * qd[1],
            -0.4 * axis.dot(&horn_rate).powi(2),
            -0.2 * (qd[1] + velocity.y).powi(2),
            x[0].cos(),
        ];
        let largest = powers.iter().fold(0.0_f64, |largest, power| largest.max(power.abs()));
        assert_relative_eq!(change, powers.iter().sum::<f64>(), epsilon = 1e-12 * largest.max(1.0));
    }
}

#[test]
fn an_event_is_found_where_its_function_vanishes() -> Result<(), Box<dyn std::error::Error>> {
    let model = arm();
    let x0 = [0.3, 0.2, 0.1, 0.0, 0.0, 0.0];
    let solution = Vern9::new()
        .rtol(1e-12)
        .atol(1e-12)
        .solve_with(&model, 0.0, 4.0, x0, &model.events())?;
    assert!(solution.events().len() > 1);
    for event in solution.events() {
        assert!((model.hand(event.t, &event.x).z - 0.5).abs() < 1e-12);
        assert!(model.passes(event.t, &event.x).abs() < 1e-12);
    }
    let alone = Vern9::new().rtol(1e-12).atol(1e-12);
    let alone = alone.solve_with(&model, 0.0, 4.0, x0, &[model.passes_event().terminal()])?;
    assert_eq!(alone.t().last(), Some(&solution.events()[0].t));
    assert_eq!(Arm::EVENTS, ["passes"]);
    Ok(())
}

mechanism! {
    /// Two pendulums on a cart, without forces.
    Plain {
        gravity: [0, -9.81, 0],
        body cart on ground { mass: 2, joint: prismatic(x), coordinate: s }
        body upper on cart { mass: 1, com: [0.1, -1, 0], inertia: 0.2, joint: revolute(z) at [0.3, 0.2, 0],
            coordinate: th1 }
        body lower on upper { mass: 1.5, com: [0, -1.2, 0], inertia: 0.1, joint: revolute(z) at [0, -2, 0],
            coordinate: th2 }
        body bracket on ground { mass: 3, joint: fixed at [0.5, 0.2, 0] rpy [0, 0, 0.7] }
        body side on bracket { mass: 1, com: [0.1, -1, 0], inertia: 0.2, joint: revolute(z), coordinate: th3 }
    }
}

mechanism! {
    /// `Plain` with items that change nothing: zero forces, outputs, an event, a constant motion.
    Idle {
        gravity: [0, -9.81, 0],
        point tip on lower at [0, -2, 0],
        point nail on ground,
        force on tip: [0, 0, 0],
        force on tip: [0, 0, 0] in upper,
        force th1: 0,
        spring between tip and nail: (0, 1),
        damper between tip and nail: 0,
        potential: 0,
        output tip: tip,
        output turned: rotation(lower),
        output rise: dot(tip.y),
        event passes: tip.x,
        body cart on ground { mass: 2, joint: prismatic(x), coordinate: s }
        body upper on cart { mass: 1, com: [0.1, -1, 0], inertia: 0.2, joint: revolute(z) at [0.3, 0.2, 0],
            coordinate: th1 }
        body lower on upper { mass: 1.5, com: [0, -1.2, 0], inertia: 0.1, joint: revolute(z) at [0, -2, 0],
            coordinate: th2 }
        body bracket on ground { mass: 3, joint: revolute(z) at [0.5, 0.2, 0], motion: 0.7 }
        body side on bracket { mass: 1, com: [0.1, -1, 0], inertia: 0.2, joint: revolute(z), coordinate: th3 }
    }
}

#[test]
fn what_changes_nothing_costs_nothing() {
    for routine in ["rhs", "jacobian", "kinetic", "potential"] {
        assert_eq!(Plain::COST[routine], Idle::COST[routine], "{routine}");
    }
    let (plain, idle) = (Plain::new(PlainParams {}), Idle::new(IdleParams {}));
    let (plain, idle) = (plain.expect("physical"), idle.expect("physical"));
    for (t, x) in states::<8>() {
        assert_eq!(plain.rhs(t, &x), idle.rhs(t, &x));
        assert_eq!(plain.rhs_and_jacobian(t, &x), idle.rhs_and_jacobian(t, &x));
    }
}

#[test]
fn functions_take_states_as_solve_does() {
    mechanism! {
        Swing {
            gravity: [0, -9.81, 0],
            generate: [rhs, energy, mass_matrix, inverse_dynamics],
            point tip on bob at [0, -1, 0],
            output height: tip.y,
            event passes: tip.x,
            body bob on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: angle }
        }
    }
    let (model, array) = (Swing::new(SwingParams {}).expect("physical"), [0.4, -0.3]);
    let x = SVector::from(array);
    assert_eq!(
        model.energy(0.0, &array),
        model.kinetic(0.0, &x) + model.potential(0.0, &x)
    );
    assert_eq!(model.energy(0.0, &x), model.energy(0.0, &array));
    assert_eq!(model.height(0.0, &array), model.height(0.0, &x));
    assert_eq!(model.height_rate(0.0, &array), model.height_rate(0.0, &x));
    assert_eq!(model.passes(0.0, &array), model.passes(0.0, &x));
    assert_eq!(model.mass_matrix(0.0, &array), model.mass_matrix(0.0, &x));
    assert_eq!(
        model.inverse_dynamics(0.0, &array, &[0.5]),
        model.inverse_dynamics(0.0, &x, &SVector::from([0.5]))
    );
}
