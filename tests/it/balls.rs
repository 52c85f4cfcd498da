//! Ball and free joints: reference motions, and trees against the same trees with three successive hinges.

use nalgebra::{Quaternion, SMatrix, SVector, UnitQuaternion, Vector3};
use pendulum_core::method::{Fixed, Rosenbrock};
use pendulum_core::prelude::*;
use pendulum_core::real::Real;
use pendulum_core::real::lanes::Isa;
use pendulum_core::stability::{Complex, Lyapunov, Shooting, Stability, StabilityError, equilibria, equilibrium};
use pendulum_core::tableau::Steinebach5;
use pendulum_core::{Cast, Plant, Reason, SlotKind};
use testbed::dual::Dual;
use testbed::motions::{Top, motion};
use testbed::random::Random;

mechanism! {
    /// The heavy top of Kynema's tests.
    pub HeavyTop {
        params { m: kg = 15, h: m = 1, g: m/s^2 = 9.81 }
        gravity: [0, 0, -g],
        generate: [rhs, jacobian, energy, momentum, taylor],
        output height: tip.z,
        point tip on top at [0, 0, h],
        body top on ground {
            mass: m, com: [0, 0, h], inertia: [0.234375, 0.234375, 0.46875],
            joint: ball,
            orientation: o,
        }
    }
}

mechanism! {
    pub Spherical {
        params { gamma: N m s = 0.02 }
        gravity: [0, 0, -9.81],
        generate: [rhs, jacobian, energy, taylor],
        body bob on ground {
            mass: 1.3, com: [0, 0, -0.6], inertia: [0.04, 0.07, 0.05],
            joint: ball,
            orientation: o,
            friction: gamma,
        }
    }
}

mechanism! {
    /// A tumbling stone, thrown from a turned frame.
    pub Thrown {
        gravity: [0, 0, -9.81],
        generate: [rhs, jacobian, energy, taylor],
        point middle on stone at [0.1, -0.2, 0.3],
        output middle: middle,
        body stone on ground {
            mass: 2, com: [0.1, -0.2, 0.3], inertia: [2, 1.5, 0.8],
            joint: free at [1, 2, 3] rpy [0, 0.5, 0],
            orientation: o,
            position: p,
        }
    }
}

/// Two scenes that differ in three joints.
macro_rules! trees {
    ($($name:ident: [$($bob:tt)*] [$($foot:tt)*] [$($craft:tt)*] [$($more:tt)*])*) => {$(
        mechanism! {
            pub $name {
                params { gamma: N m s = 0.05, k: N/m = 4, m: kg = 0.8 }
                gravity: [0.3, -9.81, 1],
                generate: [rhs, jacobian, energy, mass_matrix, bias, momentum, inverse_dynamics, parameter_jacobian],
                $($more)*
                point tip on foot at [0.2, -0.1, 0.15],
                point nose on craft at [-0.3, 0.1, 0.2],
                point anchor on ground at [1, 1, 0],
                spring between tip and nose: (k, 0.4),
                damper between nose and anchor: 0.3,
                force on tip: [0.2, 0.1, -0.3] in leg,
                potential: 0.7 N/m*tip.x*nose.y,
                output tip: tip,
                output foot: rotation(foot),
                output speed: dot(nose.z),
                body pivot on ground { joint: prismatic(y), motion: 0.1*sin(3 rad/s*t) }
                body arm on pivot {
                    mass: 1.1, com: [0.1, -0.3, 0.05], inertia: [0.02, 0.03, 0.04, 0.001, -0.002, 0.003],
                    joint: revolute([1, 2, 0.5]) at [0.1, 0, 0], coordinate: s, friction: 0.1,
                }
                $($bob)*
                body leg on bob {
                    mass: 0.7, com: [0, -0.2, 0.1], inertia: [0.01, 0.02, 0.015],
                    joint: revolute(z) at [0.1, -0.2, 0.1], coordinate: theta, spring: (3, 0.2),
                }
                body slider on bob {
                    mass: 0.3, com: [0.1, 0, 0], joint: prismatic([1, 1, 0]) at [0, 0.1, 0], coordinate: d,
                    spring: (20, 0.1),
                }
                $($foot)*
                $($craft)*
                body tail on craft {
                    mass: 0.4, com: [0, 0, -0.3], inertia: [0.01, 0.01, 0.001],
                    joint: revolute(x) at [0.2, 0, 0], coordinate: tail, torque: 0.1 - 0.2*q,
                }
            }
        }
    )*};
}

trees! {
    Balls:
    [
        body bob on arm {
            mass: m, com: [0.05, -0.2, 0.1], inertia: [0.03, 0.02, 0.015, 0.002, 0.001, -0.001],
            joint: ball at [0.1, -0.5, 0.2] rpy [0.3, -0.2, 0.5], orientation: bob, friction: gamma,
        }
    ]
    [
        body sole on leg { joint: fixed at [0, -0.4, 0.1] }
        body foot on sole { mass: 0.5, com: [0.1, 0, 0.05], inertia: [0.01, 0.02, 0.03], joint: ball,
            orientation: foot }
    ]
    [
        body craft on ground {
            mass: 3, com: [0.1, 0.1, -0.1], inertia: [0.3, 0.25, 0.2, 0.01, 0.02, 0.03],
            joint: free at [1, 0, 0] rpy [0.1, 0.2, -0.3], orientation: craft, position: place,
        }
    ]
    [force on tip: [0.1 N*foot.w, 0.2 N s/rad*dot(bob).x, 0],]

    Turns:
    [
        body bobx on arm { joint: revolute(x) at [0.1, -0.5, 0.2] rpy [0.3, -0.2, 0.5], coordinate: bob1 }
        body boby on bobx { joint: revolute(y), coordinate: bob2 }
        body bob on boby {
            mass: m, com: [0.05, -0.2, 0.1], inertia: [0.03, 0.02, 0.015, 0.002, 0.001, -0.001],
            joint: revolute(z), coordinate: bob3,
        }
    ]
    [
        body footx on leg { joint: revolute(x) at [0, -0.4, 0.1], coordinate: foot1 }
        body footy on footx { joint: revolute(y), coordinate: foot2 }
        body foot on footy {
            mass: 0.5, com: [0.1, 0, 0.05], inertia: [0.01, 0.02, 0.03], joint: revolute(z), coordinate: foot3,
        }
    ]
    [
        body px on ground { joint: prismatic(x) at [1, 0, 0] rpy [0.1, 0.2, -0.3], coordinate: place1 }
        body py on px { joint: prismatic(y), coordinate: place2 }
        body pz on py { joint: prismatic(z), coordinate: place3 }
        body craftx on pz { joint: revolute(x), coordinate: craft1 }
        body crafty on craftx { joint: revolute(y), coordinate: craft2 }
        body craft on crafty {
            mass: 3, com: [0.1, 0.1, -0.1], inertia: [0.3, 0.25, 0.2, 0.01, 0.02, 0.03],
            joint: revolute(z), coordinate: craft3,
        }
    ]
    [
        // angular velocity of the ball along the axes of its body
        let p = cos(bob3)*cos(bob2)*dot(bob1) + sin(bob3)*dot(bob2),
        let q2 = cos(bob3)*dot(bob2) - sin(bob3)*cos(bob2)*dot(bob1),
        let r = sin(bob2)*dot(bob1) + dot(bob3),
        dissipation: 1/2*gamma*(p^2 + q2^2 + r^2),
        let scalar = cos(foot1/2)*cos(foot2/2)*cos(foot3/2) - sin(foot1/2)*sin(foot2/2)*sin(foot3/2),
        force on tip: [0.1 N*scalar, 0.2 N s/rad*p, 0],
    ]
}

/// Number of state components in `Balls`.
const BALLS: usize = 35;

/// Number of state components in `Turns`.
const TURNS: usize = 32;

/// Indices of three successive turns in `Turns`, and of the orientation that they form in `Balls`: positions and rates.
const ORIENTATIONS: [([usize; 2], [usize; 2]); 3] = [
    ([Turns::BOB1, Turns::DOT_BOB1], [Balls::BOB, Balls::DOT_BOB]),
    ([Turns::FOOT1, Turns::DOT_FOOT1], [Balls::FOOT, Balls::DOT_FOOT]),
    ([Turns::CRAFT1, Turns::DOT_CRAFT1], [Balls::CRAFT, Balls::DOT_CRAFT]),
];

/// Indices of the coordinates common to both.
const PLAIN: [([usize; 2], [usize; 2]); 7] = [
    ([Turns::S, Turns::DOT_S], [Balls::S, Balls::DOT_S]),
    ([Turns::THETA, Turns::DOT_THETA], [Balls::THETA, Balls::DOT_THETA]),
    ([Turns::D, Turns::DOT_D], [Balls::D, Balls::DOT_D]),
    ([Turns::TAIL, Turns::DOT_TAIL], [Balls::TAIL, Balls::DOT_TAIL]),
    ([Turns::PLACE1, Turns::DOT_PLACE1], [Balls::PLACE_X, Balls::DOT_PLACE_X]),
    ([Turns::PLACE2, Turns::DOT_PLACE2], [Balls::PLACE_Y, Balls::DOT_PLACE_Y]),
    ([Turns::PLACE3, Turns::DOT_PLACE3], [Balls::PLACE_Z, Balls::DOT_PLACE_Z]),
];

/// Converts a state of `Turns` to `Balls`.
fn with_balls<T: Real>(turns: &SVector<T, TURNS>) -> SVector<T, BALLS> {
    let zero = T::from_f64(0.0);
    let mut x = SVector::<T, BALLS>::from([zero; BALLS]);
    for ([from, rate_from], [to, rate_to]) in PLAIN {
        (x[to], x[rate_to]) = (turns[from], turns[rate_from]);
    }
    for ([from, rate_from], [to, rate_to]) in ORIENTATIONS {
        let half = T::from_f64(0.5);
        let [(s1, c1), (s2, c2), (s3, c3)] = [0, 1, 2].map(|n| (half * turns[from + n]).sin_cos());
        // (c1 + s1 i) (c2 + s2 j) (c3 + s3 k)
        x[to] = c1 * c2 * c3 - s1 * s2 * s3;
        x[to + 1] = s1 * c2 * c3 + c1 * s2 * s3;
        x[to + 2] = c1 * s2 * c3 - s1 * c2 * s3;
        x[to + 3] = c1 * c2 * s3 + s1 * s2 * c3;
        let [(s2, c2), (s3, c3)] = [1, 2].map(|n| turns[from + n].sin_cos());
        let [a, b, c] = [0, 1, 2].map(|n| turns[rate_from + n]);
        x[rate_to] = c3 * c2 * a + s3 * b;
        x[rate_to + 1] = c3 * b - s3 * c2 * a;
        x[rate_to + 2] = s2 * a + c;
    }
    x
}

fn close<const R: usize, const C: usize>(
    what: &str,
    ours: &SMatrix<f64, R, C>,
    theirs: &SMatrix<f64, R, C>,
    most: f64,
) {
    let error = (ours - theirs).amax() / theirs.amax();
    assert!(error < most, "{what}: {error:e}\n{ours}{theirs}");
}

fn states() -> impl Iterator<Item = (f64, SVector<f64, TURNS>)> {
    let mut random = Random::new(11);
    (0..20).map(move |_| {
        (
            random.between(0.0, 3.0),
            SVector::from_fn(|_, _| random.between(-1.2, 1.2)),
        )
    })
}

fn models() -> (Balls, Turns) {
    let balls = Balls::new(BallsParams::default()).expect("physical");
    (balls, Turns::new(TurnsParams::default()).expect("physical"))
}

#[test]
fn balls_accelerate_as_three_turns_in_a_row() {
    let (balls, turns) = models();
    assert_eq!((Balls::DOF, Balls::LAYOUT.positions()), (16, 19));
    for (t, x) in states() {
        let rates = turns.rhs(t, &x);
        // state of one scene along the motion of the other
        let moving = SVector::<Dual, TURNS>::from_fn(|n, _| Dual::new(x[n], rates[n]));
        let moving = with_balls(&moving);
        let (y, expected) = (moving.map(|x| x.value), moving.map(|x| x.slope));
        close("rates", &balls.rhs(t, &y), &expected, 1e-12);
        close("both", &balls.rhs_and_jacobian(t, &y).0, &expected, 1e-12);
        let energies = |kinetic, potential| SVector::from([kinetic, potential]);
        let ours = energies(balls.kinetic(t, &y), balls.potential(t, &y));
        close(
            "energies",
            &ours,
            &energies(turns.kinetic(t, &x), turns.potential(t, &x)),
            1e-13,
        );
        close("tip", &balls.tip(t, &y), &turns.tip(t, &x), 1e-13);
        close("tip", &balls.tip_rate(t, &y), &turns.tip_rate(t, &x), 1e-13);
        close("foot", &balls.foot(t, &y), &turns.foot(t, &x), 1e-13);
        close("foot", &balls.foot_rate(t, &y), &turns.foot_rate(t, &x), 1e-12);
        assert!((balls.speed_rate(t, &y) - turns.speed_rate(t, &x)).abs() < 1e-11);
        // other generated functions use the same equations
        let (rates, own) = (
            y.fixed_rows::<16>(19).into_owned(),
            expected.fixed_rows::<16>(19).into_owned(),
        );
        let matrix = balls.mass_matrix(t, &y);
        close("inverse", &(balls.inverse_dynamics(t, &y, &own) + own), &own, 1e-11);
        let apart = balls.inverse_dynamics(t, &y, &(2.0 * own)) - balls.inverse_dynamics(t, &y, &own);
        close("matrix", &apart, &(matrix * own), 1e-12);
        assert!((balls.kinetic(t, &y) - turns.kinetic(t, &x)).abs() < 1e-12);
        // a drive contributes to the momentum of the bodies that it carries
        let still = balls.momentum(t, &SVector::from_fn(|n, _| if n < 19 { y[n] } else { 0.0 }));
        close("momentum", &(balls.momentum(t, &y) - still), &(matrix * rates), 1e-12);
    }
}

/// Derivatives of the right-hand side with respect to the state, by dual numbers.
fn by_duals<M: Cast<N>, const N: usize>(model: &M, t: f64, x: &SVector<f64, N>) -> SMatrix<f64, N, N> {
    let dual = model.cast::<Dual>();
    let column = |k| {
        let x = SVector::from_fn(|n, _| Dual::new(x[n], if n == k { 1.0 } else { 0.0 }));
        dual.rhs(Dual::new(t, 0.0), &x).map(|x| x.slope)
    };
    SMatrix::from_columns(&std::array::from_fn::<_, N, _>(column))
}

#[test]
fn jacobians_are_those_of_the_right_hand_side_on_the_sphere_and_beside_it() {
    let (balls, _) = models();
    for (t, x) in states() {
        for scale in [1.0, 1.1] {
            let mut y = with_balls(&x);
            for (_, [to, _]) in ORIENTATIONS {
                y.fixed_rows_mut::<4>(to).apply(|q| *q *= scale);
            }
            close("Jacobian", &balls.jacobian(t, &y), &by_duals(&balls, t, &y), 1e-11);
            let dual = balls.cast::<Dual>();
            let by_time = dual
                .rhs(Dual::new(t, 1.0), &y.map(|x| Dual::new(x, 0.0)))
                .map(|x| x.slope);
            close("by time", &balls.time_derivative(t, &y), &by_time, 1e-11);
            let (tip, by_state) = balls.tip_and_jacobian(t, &y);
            close("tip", &tip, &balls.tip(t, &y), 1e-14);
            let rates = balls.rhs(t, &y);
            // off the sphere the rates of positions still follow the kinematics
            let drive = Vector3::new(0.0, 0.3 * (3.0 * t).cos(), 0.0);
            close("tip", &(by_state * rates + drive), &balls.tip_rate(t, &y), 1e-12);
        }
    }
}

#[test]
fn parameters_move_the_accelerations() {
    let params = BallsParams::default();
    let at = |n: usize, by: f64| {
        let mut values = params.to_array();
        values[n] += by;
        Balls::new(BallsParams::from_array(values)).expect("physical")
    };
    let balls = Balls::new(params).expect("physical");
    let (t, x) = states().next().expect("a state");
    let y = with_balls(&x);
    for n in 0..3 {
        let apart = at(n, 1e-5).rhs(t, &y) - at(n, -1e-5).rhs(t, &y);
        let expected = apart / 2e-5;
        let ours = balls.parameter_jacobian(t, &y).column(n).into_owned();
        close("parameters", &ours, &expected, 1e-8);
    }
}

/// Largest error of the states of a motion: of the quaternion, and of the rates relative to the largest.
fn error(name: &str, of: impl Fn(f64, SVector<f64, 7>) -> Result<SVector<f64, 7>, Reason>) -> f64 {
    let motion = motion(name);
    let errors = motion.states.iter().map(|(t, x)| {
        let error = of(*t, motion.x0).expect("it arrives") - x;
        let of_rates = error.fixed_rows::<3>(4).amax() / x.fixed_rows::<3>(4).amax();
        error.fixed_rows::<4>(0).amax().max(of_rates)
    });
    errors.fold(0.0, f64::max)
}

#[test]
fn generated_motions_agree_with_their_reference() {
    let top = HeavyTop::new(HeavyTopParams::default()).expect("physical");
    let spherical = Spherical::new(SphericalParams::default()).expect("physical");
    macro_rules! check {
        ($method:expr) => {{
            let method = $method.rtol(1e-14).atol(1e-16);
            let heavy = error("heavy_top_kynema", |t, x| method.stepper(&top, 0.0, t, x)?.run());
            let dry = error("spherical_pendulum_with_friction", |t, x| {
                method.stepper(&spherical, 0.0, t, x)?.run()
            });
            println!("{} {heavy:e} {dry:e}", stringify!($method));
            assert!(heavy < 1e-12 && dry < 1e-12, "{heavy:e} {dry:e}");
        }};
    }
    check!(Vern9::new());
    check!(Taylor::new());
}

#[test]
fn a_stone_turns_as_euler_says_and_its_middle_falls() {
    let thrown = Thrown::new(ThrownParams {}).expect("physical");
    let turning = Top {
        inertia: [2.0, 1.5, 0.8],
        weight: 0.0,
        friction: 0.0,
    };
    let x0 = SVector::from([1.0, 0.0, 0.0, 0.0, 0.01, 5.0, 0.02]);
    let mut y0 = SVector::<f64, 13>::zeros();
    y0.fixed_rows_mut::<4>(Thrown::O).copy_from(&x0.fixed_rows::<4>(0));
    y0.fixed_rows_mut::<3>(Thrown::DOT_O).copy_from(&x0.fixed_rows::<3>(4));
    (y0[Thrown::DOT_P_X], y0[Thrown::DOT_P_Z]) = (1.0, 9.0);
    let (from, rate) = (thrown.middle(0.0, &y0), thrown.middle_rate(0.0, &y0));
    let t = 6.0;
    let x = Vern9::new()
        .rtol(1e-13)
        .atol(1e-13)
        .stepper(&turning, 0.0, t, x0)
        .and_then(|mut s| s.run());
    let x = x.expect("it arrives");
    macro_rules! check {
        ($method:expr) => {{
            let method = $method.rtol(1e-13).atol(1e-13);
            let y = method
                .stepper(&thrown, 0.0, t, y0)
                .and_then(|mut s| s.run())
                .expect("it arrives");
            let fall = Vector3::new(0.0, 0.0, -9.81 / 2.0 * t * t);
            close("middle", &thrown.middle(t, &y), &(from + rate * t + fall), 1e-11);
            assert!((thrown.energy(t, &y) / thrown.energy(0.0, &y0) - 1.0).abs() < 1e-11);
            let turned = y.fixed_rows::<4>(Thrown::O).into_owned();
            close("turned", &turned, &x.fixed_rows::<4>(0).into_owned(), 1e-10);
        }};
    }
    check!(Vern9::new());
    check!(Taylor::new());
}

#[test]
fn a_top_is_that_of_eulers_equations_and_keeps_what_it_should() {
    let top = HeavyTop::new(HeavyTopParams::default()).expect("physical");
    let x0 = motion("heavy_top_kynema").x0;
    close("top", &top.rhs(0.0, &x0), &Top::HEAVY.rhs(0.0, &x0), 1e-15);
    let solution = Vern9::new()
        .rtol(1e-13)
        .atol(1e-13)
        .solve(&top, 0.0, 20.0, x0)
        .expect("it arrives");
    // angular momentum about the vertical
    let vertical = |x: &SVector<f64, 7>| {
        let turn = UnitQuaternion::new_unchecked(Quaternion::new(x[0], x[1], x[2], x[3]));
        (turn * top.momentum(0.0, x)).z
    };
    for x in solution.x() {
        assert!((top.energy(0.0, x) / top.energy(0.0, &x0) - 1.0).abs() < 1e-11);
        assert!((vertical(x) / vertical(&x0) - 1.0).abs() < 1e-11);
        assert!((x.fixed_rows::<4>(0).norm() - 1.0).abs() < 3e-16);
        assert_eq!(x[HeavyTop::DOT_O + 2], 150.0);
        let [w, x, y, z] = [0, 1, 2, 3].map(|n| x[HeavyTop::O + n]);
        assert!(
            (top.height(0.0, &SVector::from([w, x, y, z, 0.0, 0.0, 0.0])) - (1.0 - 2.0 * (x * x + y * y))).abs()
                < 1e-15
        );
    }
    let slot = &HeavyTop::LAYOUT.slots[0];
    assert_eq!((slot.name, slot.kind), ("o", SlotKind::Quaternion));
    assert_eq!((slot.positions.clone(), slot.rates.clone()), (0..4, 4..7));
    assert!(!slot.periodic && !slot.cyclic && HeavyTop::LAYOUT.autonomous);
    let names = "o.w o.x o.y o.z dot(o).x dot(o).y dot(o).z";
    assert_eq!(HeavyTop::LAYOUT.components().join(" "), names);
}

#[test]
fn friction_and_drives_take_what_the_energy_loses() {
    let (balls, _) = models();
    let dual = balls.cast::<Dual>();
    let gone = |t: f64, y: &SVector<f64, BALLS>| {
        let rates = balls.rhs(t, y);
        let moving = SVector::from_fn(|n, _| Dual::new(y[n], rates[n]));
        dual.energy(Dual::new(t, 1.0), &moving).slope
    };
    // more friction in the ball increases the lost power by the square of its rates
    let more = Balls::new(BallsParams {
        gamma: 0.05,
        ..BallsParams::default()
    })
    .expect("physical");
    let stiff = Balls::new(BallsParams {
        gamma: 1.05,
        ..BallsParams::default()
    })
    .expect("physical");
    for (t, x) in states() {
        let y = with_balls(&x);
        let by_friction = stiff.rhs(t, &y) - more.rhs(t, &y);
        let by_friction = by_friction.fixed_rows::<16>(19).dot(&balls.momentum(t, &y));
        let rates = y.fixed_rows::<3>(Balls::DOT_BOB);
        let drive = {
            let still = SVector::from_fn(|n, _| if n < 19 { y[n] } else { 0.0 });
            balls.momentum(t, &still)
        };
        let by_friction = by_friction - (stiff.rhs(t, &y) - more.rhs(t, &y)).fixed_rows::<16>(19).dot(&drive);
        assert!(
            (by_friction + rates.norm_squared()).abs() < 1e-9 * rates.norm_squared(),
            "{by_friction}"
        );
        assert!(gone(t, &y).is_finite());
    }
}

#[test]
fn implicit_methods_keep_their_order() {
    let spherical = Spherical::new(SphericalParams::default()).expect("physical");
    let name = "spherical_pendulum_with_friction";
    let of = |h: f64| {
        let method = Fixed::<Rosenbrock<Steinebach5, 8>>::new(h);
        error(name, |t, x| method.stepper(&spherical, 0.0, t, x)?.run())
    };
    let order = (of(0.02) / of(0.01)).log2();
    assert!((order - 5.0).abs() < 0.4, "of order {order}");
    let radau = error(name, |t, x| {
        Radau5::new()
            .rtol(1e-10)
            .atol(1e-10)
            .stepper(&spherical, 0.0, t, x)?
            .run()
    });
    assert!(radau < 1e-8, "{radau:e}");
}

mechanism! {
    /// A pushed ball pendulum, with outputs and events of its components.
    pub Pushed {
        input push: N,
        gravity: [0, 0, -9.81],
        point tip on bob at [0, 0, -0.6],
        force on tip: [push, 0, 0] in bob,
        output tilt: o.x*dot(o).y,
        event level: o.x,
        body bob on ground {
            mass: 1.3, com: [0, 0, -0.6], inertia: [0.04, 0.07, 0.05],
            joint: ball,
            orientation: o,
            friction: 0.02,
        }
    }
}

mechanism! {
    /// Two of them, one on the other.
    pub PushedTwice {
        input push: N,
        generate: [rhs],
        point tip on foot at [0, 0, -0.6],
        force on tip: [push, 0, 0],
        body bob on ground { mass: 1, com: [0, 0, -0.6], inertia: [0.04, 0.07, 0.05], joint: ball, orientation: o }
        body foot on bob {
            mass: 1, com: [0, 0, -0.6], inertia: [0.04, 0.07, 0.05], joint: ball at [0, 0, -1], orientation: p,
        }
    }
}

#[test]
fn a_quaternion_adds_no_degree_of_freedom() {
    let dof = |plant: &dyn Plant<f64, 14, Given = PushedTwiceInputs>| plant.dof();
    let twice = PushedTwice::new(PushedTwiceParams {}).expect("physical");
    assert_eq!((dof(&twice), PushedTwice::<f64>::DOF), (6, 6));
}

#[test]
fn inputs_push_a_ball_pendulum_that_stays_on_the_sphere() {
    let pushed = Pushed::new(PushedParams {}).expect("physical");
    let spherical = Spherical::new(SphericalParams::default()).expect("physical");
    let x0 = motion("spherical_pendulum_with_friction").x0;
    let law = |_: f64, x: &SVector<f64, 7>| PushedInputs {
        push: 0.5 * x[Pushed::DOT_O + 1],
    };
    let closed = pushed.with_inputs(law);
    // a force of u along x at the tip is a moment of -0.6 u about y
    let mut expected = spherical.rhs(0.0, &x0);
    expected[Pushed::DOT_O + 1] -= 0.6 * 0.5 * x0[Pushed::DOT_O + 1] / (0.07 + 1.3 * 0.36);
    close("pushed", &closed.rhs(0.0, &x0), &expected, 1e-14);
    let solution = Vern9::new()
        .solve_with(&closed, 0.0, 5.0, x0, &[pushed.level_event()])
        .expect("it arrives");
    assert!(!solution.events().is_empty());
    for x in solution.x() {
        assert!((x.fixed_rows::<4>(0).norm() - 1.0).abs() < 3e-16);
    }
    let (t, x) = solution.last();
    assert_eq!(pushed.tilt(t, &x), x[1] * x[5]);
    let rates = closed.rhs(t, &x);
    let rate = pushed.tilt_rate(t, &x, &law(t, &x));
    assert!((rate - (rates[1] * x[5] + x[1] * rates[5])).abs() < 1e-13);
}

#[test]
#[ignore = "takes long"]
fn exponents_leave_out_the_length_of_a_quaternion() {
    let spherical = Spherical::new(SphericalParams::default()).expect("physical");
    let x0 = motion("spherical_pendulum_with_friction").x0;
    // long after all motion has decayed, an error in the length of the quaternion would still show
    let lyapunov = Lyapunov::new().duration(3000.0);
    let exponents = lyapunov.exponents::<6, 7>(&spherical, x0).expect("it arrives");
    // the volume of rates shrinks by friction over inertia, the volume of orientations is constant
    let sum = -0.02 * (1.0 / (0.04 + 1.3 * 0.36) + 1.0 / (0.07 + 1.3 * 0.36) + 1.0 / 0.05);
    let ours: f64 = exponents.values.iter().sum();
    assert!((ours / sum - 1.0).abs() < 1e-6, "{ours} {sum}");
    // it comes to hang, turned about the vertical by any angle
    let largest = exponents.values[0];
    assert!(
        largest.abs() < 2e-3 && exponents.values[1] < -0.01,
        "{:?}",
        exponents.values
    );
    let all = lyapunov.exponents::<7, 7>(&spherical, x0);
    assert!(matches!(all, Err(StabilityError::Integration(_))), "{all:?}");
}

mechanism! {
    /// A bob on three hinges in place of a ball joint.
    pub Gimbal {
        gravity: [0, 0, -9.81],
        body outer on ground { joint: revolute(x), coordinate: u, friction: 0.1 }
        body inner on outer { joint: revolute(y), coordinate: v, friction: 0.1 }
        body bob on inner {
            mass: 1, com: [0, 0, -0.5], inertia: [0.01, 0.02, 0.02], joint: revolute(z), coordinate: w, friction: 0.1,
        }
    }
}

/// The error names the orientation and its length.
#[test]
fn a_quaternion_of_another_length_is_refused() {
    let model = Balls::new(BallsParams::default()).expect("physical");
    let start = SVector::from_element(0.5) * 2.0;
    let error = Vern9::new().solve(&model, 0.0, 1.0, start).expect_err("it is too long");
    let text = error.to_string();
    assert!(
        text.contains("`length of a quaternion in x0` is 2.0: it must be 1"),
        "{text}"
    );
}

/// The error of a reset names the orientation, its length, and the time.
#[test]
fn a_reset_to_a_quaternion_of_another_length_is_refused() {
    let model = Balls::new(BallsParams::default()).expect("physical");
    let start = SVector::from_element(0.5);
    let doubled = Event::new(|t, _x| t - 0.25).reset(|_t, x| x * 2.0);
    let error = Vern9::new().solve_with(&model, 0.0, 1.0, start, &[doubled]);
    let text = error.expect_err("it is too long").to_string();
    let said = "event 0 resets the state at t = 0.25 to an invalid one: the length of a quaternion is 2.0";
    let same = text.get(..said.len() - 3) == said.get(..said.len() - 3);
    assert!(same && text.contains("; it must be 1, to three digits"), "{text}");
}

/// The search ends where the right-hand side is exactly zero.
#[test]
fn a_bob_on_hinges_hangs() {
    let model = Gimbal::new(GimbalParams {}).expect("physical");
    for start in [[0.1, 0.1, 0.0, 0.0, 0.0, 0.0], [0.01, 0.01, 0.3, 0.0, 0.0, 0.0]] {
        let rest = equilibrium(&model, start).expect("it hangs");
        assert!(rest.x[0].abs() < 1e-12 && rest.x[1].abs() < 1e-12, "{}", rest.x);
    }
}

/// A ball pendulum either hangs, turned about the vertical by any angle, or stands. Its modes are two swings and a
/// spin.
#[test]
fn a_ball_hangs_and_stands() {
    let spherical = Spherical::new(SphericalParams::default()).expect("physical");
    let x0 = motion("spherical_pendulum_with_friction").x0;
    let (friction, weight) = (0.02, 1.3 * 9.81 * 0.6);
    let about = [0.04 + 1.3 * 0.36, 0.07 + 1.3 * 0.36];
    let turned = |sine: f64, rates: [f64; 3]| {
        let [a, b, c] = rates;
        SVector::from([(1.0 - sine * sine).sqrt(), sine, 0.0, 0.0, a, b, c])
    };
    for (seed, sign) in [(SVector::from(x0), 1.0), (turned(0.98, [0.0; 3]), -1.0)] {
        let found = equilibrium(&spherical, seed).expect("it is near");
        assert!(spherical.rhs(0.0, &found.x).amax() < 1e-13 && (found.x.fixed_rows::<4>(0).norm() - 1.0).abs() < 1e-15);
        // roots of I s^2 + c s +- m g l, and those of the spin
        let mut expected: Vec<Complex<f64>> = about
            .iter()
            .flat_map(|inertia| {
                let half = friction / (2.0 * inertia);
                let root = Complex::from(half * half - sign * weight / inertia).sqrt();
                [-half + root, -half - root]
            })
            .chain([Complex::from(0.0), Complex::from(-friction / 0.05)])
            .collect();
        let modes = found.spectrum.modes();
        assert_eq!(modes.len(), 6);
        for mode in modes {
            let near = |a: &Complex<f64>| (a - mode.eigenvalue).norm();
            let nearest = (0..expected.len()).min_by(|&a, &b| near(&expected[a]).total_cmp(&near(&expected[b])));
            let nearest = expected.swap_remove(nearest.expect("as many"));
            assert!(
                (nearest - mode.eigenvalue).norm() < 1e-9,
                "{nearest} {}",
                mode.eigenvalue
            );
            let image = found.jacobian.map(Complex::from) * mode.shape - mode.shape * mode.eigenvalue;
            assert!(image.norm() < 1e-9 * found.jacobian.norm(), "{image}");
        }
        let stability = if sign > 0.0 {
            Stability::Undecided
        } else {
            Stability::Unstable
        };
        assert_eq!(found.stability(), stability);
    }
    // the opposite quaternion is the same orientation, hence the same state of rest
    let hanging = equilibrium(&spherical, x0).expect("it is near").x;
    let mut opposite = hanging;
    opposite.fixed_rows_mut::<4>(0).neg_mut();
    let both = equilibria(&spherical, [hanging, opposite]).expect("it does not depend on time");
    assert_eq!(both.len(), 1);
}

/// A control law keeps the layout of the state.
#[test]
fn a_ball_under_a_law_stays_a_ball() {
    let pushed = Pushed::new(PushedParams {}).expect("physical");
    let spherical = Spherical::new(SphericalParams::default()).expect("physical");
    let x0 = motion("spherical_pendulum_with_friction").x0;
    let closed = pushed
        .with_inputs(|_: f64, _: &SVector<f64, 7>| PushedInputs { push: 0.0 })
        .by_differences();
    let [under_law, alone] = [equilibrium(&closed, x0), equilibrium(&spherical, x0)].map(|found| {
        let modes = found.expect("it is near").spectrum.modes().to_vec();
        modes.into_iter().map(|mode| mode.eigenvalue).collect::<Vec<_>>()
    });
    assert_eq!(under_law.len(), alone.len());
    for (a, b) in under_law.iter().zip(&alone) {
        assert!((a - b).norm() < 1e-9, "{a} {b}");
    }
    let error = Vern9::new()
        .solve(&closed, 0.0, 1.0, x0 * 2.0)
        .expect_err("it is too long");
    assert!(error.to_string().contains("length of a quaternion"), "{error}");
}

#[test]
fn periodic_orbits_of_balls_are_refused() {
    let spherical = Spherical::new(SphericalParams::default()).expect("physical");
    let x0 = motion("spherical_pendulum_with_friction").x0;
    let refused = |result: Option<StabilityError>| assert_eq!(result, Some(StabilityError::MorePositions));
    refused(Shooting::new().autonomous(&spherical, x0, 1.0).err());
    refused(Shooting::new().forced(&spherical, x0, 1.0).err());
}

#[test]
fn lanes_are_scalars_bit_for_bit() {
    let mut random = Random::new(5);
    let mut start = |turned: usize| {
        let mut x = SVector::<f64, 13>::from_fn(|_, _| random.between(-1.0, 1.0));
        let norm = x.fixed_rows::<4>(turned).norm();
        x.fixed_rows_mut::<4>(turned).apply(|q| *q /= norm);
        x
    };
    let stone = Thrown::new(ThrownParams {}).expect("physical");
    let starts: Vec<_> = (0..20).map(|_| start(Thrown::O)).collect();
    for isa in Isa::available() {
        let method = Tsit5::new();
        let ends = method
            .ensemble_on(isa, &[stone], 0.0, 2.0, &starts)
            .expect("they arrive");
        for (end, start) in ends.iter().zip(&starts) {
            let alone = method.stepper(&stone, 0.0, 2.0, *start).and_then(|mut s| s.run());
            assert_eq!(Ok(*end), alone);
            assert!((end.fixed_rows::<4>(Thrown::O).norm() - 1.0).abs() < 3e-16);
        }
    }
}
