//! First-order states: motors, filters, controllers, and scenes without bodies.

use approx::assert_relative_eq;
use pendulum_core::hybrid::Status;
use pendulum_core::prelude::*;
use pendulum_core::real::lanes::{F64x4, Lanes};
use pendulum_core::{StateVariable, stability};
use testbed::dual::Dual;

mechanism! {
    /// Lorenz' system.
    pub Lorenz {
        units: none,
        params { sigma: 1 = 10, rho: 1 = 28, beta: 1 = 2.6666666666666665 }
        state x { unit: 1, rate: sigma*(y - x) }
        state y { unit: 1, rate: x*(rho - z) - y }
        state z { unit: 1, rate: x*y - beta*z }
        event section: z - (rho - 1),
        generate: [rhs, jacobian, taylor, parameter_jacobian, adjoint, hessian_product],
    }
}

mechanism! {
    /// A stiff chemical reaction (Robertson 1966).
    pub Robertson {
        params { k1: 1/s = 0.04, k2: 1/s = 3e7, k3: 1/s = 1e4 }
        state a { unit: 1, rate: k3*b*c - k1*a }
        state b { unit: 1, rate: k1*a - k3*b*c - k2*b^2 }
        state c { unit: 1, rate: k2*b^2 }
    }
}

mechanism! {
    /// A pendulum on a motor with an armature, and a filter of its angle.
    pub Motor {
        params {
            m: kg = 1, l: m = 0.5, k: N m/A = 0.4, r: ohm = 0.5, ind: V s/A = 0.01, d: N m s = 0.01, tau: s = 0.1,
        }
        gravity: [0, -9.81, 0],
        input u: V,
        /// Current through the armature.
        state i { unit: A, rate: (u - r*i - k*dot(theta))/ind }
        state smooth { unit: rad, rate: (theta - smooth)/tau }
        body bob on ground {
            solids: [rod(m, [0, 0, 0], [0, -l, 0])], joint: revolute(z), coordinate: theta,
            friction: d, torque: k*i,
        }
        output heat: r*i^2,
        output lag: theta - smooth,
        generate: [
            rhs, jacobian, energy, parameter_jacobian, inverse_dynamics, adjoint, hessian_product,
        ],
    }
}

mechanism! {
    /// A motor that turns a wheel against dry friction, between stops.
    pub Servo {
        params {
            j: kg m^2 = 0.02, k: N m/A = 0.1, r: ohm = 2, ind: V s/A = 0.4, v: V = 12,
            slipping: N m = 0.2, sticking: N m = 0.3,
        }
        state i { unit: A, rate: (v - r*i - k*dot(theta))/ind }
        state turned { unit: rad s, rate: theta }
        body wheel on ground {
            mass: 1, inertia: j, joint: revolute(z), coordinate: theta, torque: k*i,
            dry_friction: slipping, static_friction: sticking, stop: [-1, 4] restitution(0.4),
        }
        generate: [rhs, jacobian, energy, taylor, parameter_jacobian, adjoint, hessian_product],
    }
}

mechanism! {
    /// A driven pivot, a ball joint, and a force that lags behind the bob.
    pub Mixed {
        params { m: kg = 0.7, w: rad/s = 3, k: N/m = 2, tau: s = 0.5 }
        gravity: [0, -9.81, 0],
        state lagging { unit: N, rate: (k*tip.x - lagging)/tau }
        body pivot on ground { joint: prismatic(x), motion: 0.1 m*sin(w*t) }
        body bob on pivot { mass: m, com: [0, -1, 0], inertia: [0.02, 0.03, 0.04], joint: ball, orientation: o }
        point tip on bob at [0, -1, 0],
        force on tip: [-lagging, 0, lagging/2],
        generate: [rhs, jacobian, energy, taylor, parameter_jacobian, adjoint, hessian_product],
    }
}

mechanism! {
    /// A four-bar linkage with a motor and a controller of its coupler.
    pub Linkage {
        params { k: N m/A = 0.3, ind: V s/A = 0.05, r: ohm = 0.7, gain: V/rad = 4 }
        gravity: [0, -9.81, 0],
        state i { unit: A, rate: (v - r*i - k*dot(theta))/ind }
        let v = gain*(0.2 - phi),
        body crank on ground { mass: 0.5, com: [0.1, 0, 0], inertia: 0.002, joint: revolute(z),
            coordinate: theta near 0.8, torque: k*i }
        body coupler on crank {
            mass: 1.1, com: [0.25, 0, 0], inertia: 0.02,
            joint: revolute(z) at [0.2, 0, 0], coordinate: phi depends near -0.3,
        }
        body rocker on ground {
            mass: 0.9, com: [0.2, 0, 0], inertia: 0.01, joint: revolute(z) at [0.6, 0, 0],
                coordinate: psi depends near 1.6,
        }
        close coupler at [0.5, 0, 0] to rocker at [0.4, 0, 0]: revolute(z),
        generate: [rhs, jacobian, energy, taylor, parameter_jacobian, adjoint, hessian_product],
    }
}

fn lorenz() -> Lorenz {
    Lorenz::new(LorenzParams::default()).expect("valid")
}

fn motor() -> Motor {
    Motor::new(MotorParams::default()).expect("physical")
}

fn servo() -> Servo {
    Servo::new(ServoParams::default()).expect("physical")
}

#[test]
fn states_follow_the_rates() {
    assert_eq!((Motor::THETA, Motor::DOT_THETA, Motor::I, Motor::SMOOTH), (0, 1, 2, 3));
    let layout = Motor::LAYOUT;
    assert_eq!(layout.components().join(" "), "theta dot(theta) i smooth");
    assert_eq!(
        layout.states,
        [StateVariable::new("i", "A", 2), StateVariable::new("smooth", "rad", 3)]
    );
    assert_eq!((layout.positions(), layout.rates(), Motor::DOF), (1, 1, 1));
    assert_eq!(Mixed::LAYOUT.states[0].index, 7);
    assert_eq!((Lorenz::X, Lorenz::Y, Lorenz::Z, Lorenz::DOF), (0, 1, 2, 0));
    assert!(Lorenz::LAYOUT.autonomous && Lorenz::LAYOUT.slots.is_empty());
    assert_eq!(
        Lorenz::EQUATIONS,
        "dot(x) = sigma*(y - x)\ndot(y) = x*(rho - z) - y\ndot(z) = x*y - beta*z\n"
    );
    assert!(Motor::EQUATIONS.contains("Q[theta] = k*i - d*dot(theta)"));
    assert!(Motor::EQUATIONS.contains("dot(i) = (u - r*i - k*dot(theta))/ind"));
}

#[test]
fn right_hand_sides_are_those_of_the_declaration() {
    let x = SVector::from([1.5, -2.0, 20.0]);
    assert_eq!(
        lorenz().rhs(0.0, &x),
        SVector::from([-35.0, 14.0, -3.0 - LorenzParams::default().beta * 20.0])
    );
    let (x, u) = (SVector::from([0.3, -1.2, 2.0, 0.1]), MotorInputs { u: 6.0 });
    let torque = 0.4 * 2.0 + 0.01 * 1.2 - 9.81 * 0.25 * 0.3_f64.sin();
    let expected = SVector::from([-1.2, torque / (0.25 / 3.0), (6.0 - 1.0 + 0.48) / 0.01, 2.0]);
    assert_relative_eq!(motor().eval(0.0, &x, &u), expected, max_relative = 1e-14);
    // inverse dynamics counts inputs as zero, but not states
    let forces = motor().inverse_dynamics(0.0, &x, &SVector::from([0.0]));
    assert_relative_eq!(forces[0], -torque, max_relative = 1e-14);
    assert_eq!(motor().heat(0.0, &x), 2.0);
    assert_relative_eq!(
        motor().heat_rate(0.0, &x, &u),
        2.0 * 0.5 * 2.0 * 548.0,
        max_relative = 1e-14
    );
    assert_relative_eq!(motor().lag_rate(0.0, &x, &u), -1.2 - 2.0, max_relative = 1e-14);
    let by_state = motor().outputs_and_jacobian(0.0, &x).1;
    assert_eq!(
        by_state,
        nalgebra::SMatrix::from([[0.0, 1.0], [0.0, 0.0], [2.0, 0.0], [0.0, -1.0]])
    );
}

/// Derivative of a function of time and state along a direction.
fn along<const N: usize>(
    f: impl Fn(Dual, &SVector<Dual, N>) -> SVector<Dual, N>,
    (t, x): (f64, &SVector<f64, N>),
    (by_t, by_x): (f64, &SVector<f64, N>),
) -> SVector<f64, N> {
    let x = SVector::from_fn(|n, _| Dual::new(x[n], by_x[n]));
    f(Dual::new(t, by_t), &x).map(|component| component.slope)
}

/// Checks the Jacobian and the derivative by time of a model, by dual numbers.
fn check_jacobian<M, const N: usize>(model: &M, t: f64, x: &SVector<f64, N>)
where
    M: pendulum_core::Cast<N> + Jacobian<f64, N>,
{
    let dual = model.cast::<Dual>();
    let (rates, jacobian) = model.rhs_and_jacobian(t, x);
    assert_relative_eq!(rates, model.rhs(t, x), epsilon = 1e-12, max_relative = 1e-12);
    for n in 0..N {
        let unit = SVector::from_fn(|m, _| f64::from(u8::from(m == n)));
        let column = along(|t, x| dual.rhs(t, x), (t, x), (0.0, &unit));
        assert_relative_eq!(
            jacobian.column(n).into_owned(),
            column,
            epsilon = 1e-11,
            max_relative = 1e-11
        );
    }
    let by_time = along(|t, x| dual.rhs(t, x), (t, x), (1.0, &SVector::from([0.0; N])));
    assert_relative_eq!(
        model.time_derivative(t, x),
        by_time,
        epsilon = 1e-11,
        max_relative = 1e-11
    );
}

#[test]
fn jacobians_have_rows_and_columns_of_states() {
    check_jacobian(&lorenz(), 0.0, &SVector::from([1.5, -2.0, 20.0]));
    let robertson = Robertson::new(RobertsonParams::default()).expect("valid");
    check_jacobian(&robertson, 0.0, &SVector::from([0.9, 2e-5, 0.1]));
    check_jacobian(&servo(), 0.0, &SVector::from([0.4, 1.0, 3.0, -0.2]));
    let mixed = Mixed::new(MixedParams::default()).expect("physical");
    let x = SVector::from([0.8, 0.4, 0.4, 0.2, 0.5, -0.7, 1.1, 2.5]);
    check_jacobian(&mixed, 0.7, &x);
    let linkage = Linkage::new(LinkageParams::default()).expect("physical");
    check_jacobian(&linkage, 0.0, &SVector::from([0.7, 2.0, 1.5]));
    let under = motor().with_inputs(|t: f64, x: &SVector<f64, 4>| MotorInputs {
        u: 4.0 * t.sin() - x[2],
    });
    let at = SVector::from([0.3, -1.2, 2.0, 0.1]);
    let u = MotorInputs {
        u: 4.0 * 0.6_f64.sin() - 2.0,
    };
    assert_eq!(under.rhs(0.6, &at), motor().eval(0.6, &at, &u));
    let by_input = motor().input_jacobian(0.6, &at, &u);
    assert_relative_eq!(
        by_input,
        nalgebra::SMatrix::from([[0.0, 0.0, 100.0, 0.0]]),
        max_relative = 1e-14
    );
}

/// Compares the derivatives by the parameters with differences, extrapolated to order four.
fn check_parameters<const N: usize, const P: usize>(
    rhs: impl Fn([f64; P]) -> SVector<f64, N>,
    params: [f64; P],
    jacobian: nalgebra::SMatrix<f64, N, P>,
) {
    for n in 0..P {
        let size = params[n].abs();
        let central = |h: f64| {
            let scaled = |step: f64| {
                let mut moved = params;
                moved[n] += step * size;
                rhs(moved)
            };
            (scaled(h) - scaled(-h)) / (2.0 * h * size)
        };
        let slope = (central(5e-4) * 4.0 - central(1e-3)) / 3.0;
        let column = jacobian.column(n).into_owned();
        let scale = 1.0 + slope.amax();
        assert!(
            (column - slope).amax() < 1e-8 * scale,
            "parameter {n}: {column} and not {slope}"
        );
    }
}

#[test]
fn rates_of_states_are_derived_by_parameters() {
    let x = SVector::from([1.5, -2.0, 20.0]);
    check_parameters(
        |p| Lorenz::new(LorenzParams::from_array(p)).expect("valid").rhs(0.0, &x),
        LorenzParams::default().to_array(),
        lorenz().parameter_jacobian(0.0, &x),
    );
    let (x, u) = (SVector::from([0.3, -1.2, 2.0, 0.1]), MotorInputs { u: 6.0 });
    check_parameters(
        |p| {
            Motor::new(MotorParams::from_array(p))
                .expect("physical")
                .eval(0.0, &x, &u)
        },
        MotorParams::default().to_array(),
        motor().parameter_jacobian(0.0, &x, &u),
    );
    let mixed = |p| Mixed::new(MixedParams::from_array(p)).expect("physical");
    let x = SVector::from([0.8, 0.4, 0.4, 0.2, 0.5, -0.7, 1.1, 2.5]);
    let params = MixedParams::default().to_array();
    check_parameters(
        |p| mixed(p).rhs(0.7, &x),
        params,
        mixed(params).parameter_jacobian(0.7, &x),
    );
    let linkage = |p| Linkage::new(LinkageParams::from_array(p)).expect("physical");
    let x = SVector::from([0.7, 2.0, 1.5]);
    let params = LinkageParams::default().to_array();
    check_parameters(
        |p| linkage(p).rhs(0.0, &x),
        params,
        linkage(params).parameter_jacobian(0.0, &x),
    );
}

#[test]
fn taylor_series_agree_with_runge_kutta() {
    let (vern9, taylor) = (
        Vern9::new().rtol(1e-13).atol(1e-13),
        Taylor::new().rtol(1e-14).atol(1e-14),
    );
    let start = [1.0, 1.0, 20.0];
    let ends = [
        vern9.solve(&lorenz(), 0.0, 3.0, start).expect("regular").end(),
        taylor.solve(&lorenz(), 0.0, 3.0, start).expect("regular").end(),
    ];
    assert_relative_eq!(ends[0], ends[1], max_relative = 1e-10);
    let mixed = Mixed::new(MixedParams::default()).expect("physical");
    let start = [1.0, 0.0, 0.0, 0.0, 0.5, -0.7, 1.1, 0.3];
    let ends = [
        vern9.solve(&mixed, 0.0, 3.0, start).expect("regular").end(),
        taylor.solve(&mixed, 0.0, 3.0, start).expect("regular").end(),
    ];
    assert_relative_eq!(ends[0], ends[1], epsilon = 1e-11);
    let linkage = Linkage::new(LinkageParams::default()).expect("physical");
    let ends = [
        vern9.solve(&linkage, 0.0, 1.0, [0.7, 0.0, 0.0]).expect("regular").end(),
        taylor
            .solve(&linkage, 0.0, 1.0, [0.7, 0.0, 0.0])
            .expect("regular")
            .end(),
    ];
    assert_relative_eq!(ends[0], ends[1], epsilon = 1e-11);
}

/// Explicit steps may make the second concentration negative, within the tolerance; the reactions then run away. With
/// tolerances above 1e-4 one step at the limit of stability is enough.
#[test]
fn reactions_are_left_to_the_implicit_method_after_few_steps() {
    let model = Robertson::new(RobertsonParams::default()).expect("valid");
    for (tolerance, most) in [(3.2e-4, 1), (1.01e-4, 1), (1e-4, 9), (1e-5, 13)] {
        let auto = Auto::new().rtol(tolerance).atol(tolerance);
        let solution = auto.solve(&model, 0.0, 1e11, [1.0, 0.0, 0.0]).expect("regular");
        let work = solution.statistics();
        assert!(
            (solution.end()[2] - 1.0).abs() < 1e-7,
            "{tolerance:e}: {}",
            solution.end()
        );
        assert!(
            work.accepted - work.stiff <= most && work.switches == 1,
            "{tolerance:e}: {work:?}"
        );
    }
}

/// Reference values of Hairer and Wanner's test set (Robertson, 1e11 s).
#[test]
fn stiff_reactions_reach_their_reference() {
    let model = Robertson::new(RobertsonParams::default()).expect("valid");
    let expected = [
        2.083_340_149_701_255e-8,
        8.333_360_770_334_713e-14,
        0.999_999_979_166_506,
    ];
    for end in [
        Radau5::new()
            .rtol(1e-10)
            .atol(1e-20)
            .solve(&model, 0.0, 1e11, [1.0, 0.0, 0.0]),
        Rodas5P::new()
            .rtol(1e-8)
            .atol(1e-18)
            .solve(&model, 0.0, 1e11, [1.0, 0.0, 0.0]),
    ]
    .map(|solution| solution.expect("regular").end())
    {
        for n in 0..3 {
            assert_relative_eq!(end[n], expected[n], max_relative = 1e-6);
        }
    }
}

/// With the wheel stuck the current is known, and with it the time at which the motor turns the wheel.
fn check_servo(method: &impl Method<Servo, f64, 4>) {
    let servo = servo();
    let ServoParams {
        k, r, ind, v, sticking, ..
    } = *servo.params();
    let current = sticking / k;
    let expected = -ind / r * (1.0 - r * current / v).ln();
    let solution = method.solve(&servo, 0.0, 6.0, [0.0; 4]).expect("regular");
    let (from, mode) = solution.modes()[1];
    assert_relative_eq!(from, expected, max_relative = 1e-9);
    assert_eq!(
        (solution.modes()[0].1.0[0], mode.0[0]),
        (Status::Stuck, Status::Forward)
    );
    assert_relative_eq!(
        solution.at(from).expect("inside")[Servo::I],
        current,
        max_relative = 1e-9
    );
    // at the stop the wheel rebounds with 0.4 of its rate, and keeps its current
    let [impact, ..] = solution.impacts() else {
        panic!("no impact")
    };
    let (before, after) = (impact.before, impact.after);
    assert_relative_eq!(
        after[Servo::DOT_THETA],
        -0.4 * before[Servo::DOT_THETA],
        max_relative = 1e-12
    );
    assert_eq!((after[Servo::THETA], after[Servo::I]), (4.0, before[Servo::I]));
    assert_eq!(after[Servo::TURNED], before[Servo::TURNED]);
    // it ends at the stop, where the motor is at rest and draws its stall current
    let end = solution.end();
    assert_eq!((end[0], end[1]), (4.0, 0.0));
    assert_relative_eq!(end[Servo::I], v / r, max_relative = 1e-8);
}

#[test]
fn a_motor_breaks_away_when_its_current_suffices() {
    check_servo(&Vern9::new().rtol(1e-11).atol(1e-11));
    check_servo(&Taylor::new().rtol(1e-12).atol(1e-12));
    check_servo(&Rodas5P::new().rtol(1e-10).atol(1e-10));
    check_servo(&Rk4::new(1e-3));
}

#[test]
fn lanes_have_the_bits_of_trajectories_alone() {
    let starts: Vec<SVector<f64, 3>> = (0..7).map(|n| SVector::from([1.0 + f64::from(n), 1.0, 20.0])).collect();
    let ends = Rk45::new().ensemble(&[lorenz()], 0.0, 2.0, &starts).expect("regular");
    for (start, end) in starts.iter().zip(ends) {
        assert_eq!(
            end,
            Rk45::new().solve(&lorenz(), 0.0, 2.0, *start).expect("regular").end()
        );
    }
    let starts: Vec<SVector<f64, 4>> = (0..9)
        .map(|n| SVector::from([0.1 * f64::from(n), f64::from(n) - 4.0, 0.3 * f64::from(n), 0.0]))
        .collect();
    let ends = Tsit5::new().ensemble(&[servo()], 0.0, 1.0, &starts).expect("regular");
    for (start, end) in starts.iter().zip(ends) {
        assert_eq!(
            end,
            Tsit5::new().solve(&servo(), 0.0, 1.0, *start).expect("regular").end()
        );
    }
    let x = SVector::from([0.3, -1.2, 2.0, 0.1]);
    let wide = motor().cast::<F64x4>().eval(
        F64x4::splat(0.0),
        &x.map(F64x4::splat),
        &MotorInputs { u: F64x4::splat(6.0) },
    );
    assert_eq!(
        wide.map(|component| component.lane(2)),
        motor().eval(0.0, &x, &MotorInputs { u: 6.0 })
    );
}

#[test]
fn analyses_take_states() {
    // the arm rests where the torque of the motor holds it
    let under = motor()
        .with_inputs(|_t: f64, _x: &SVector<f64, 4>| MotorInputs { u: 2.0 })
        .by_differences();
    let rest = stability::equilibrium(&under, [0.1, 0.0, 0.0, 0.0]).expect("it rests");
    let (current, angle) = (4.0, (0.4 * 4.0 / (9.81 * 0.25_f64)).asin());
    assert_relative_eq!(rest.x, SVector::from([angle, 0.0, current, angle]), epsilon = 1e-12);
    assert!(rest.spectrum.eigenvalues().all(|eigenvalue| eigenvalue.re < 0.0));
    // Lorenz' origin and the two others
    let found = stability::equilibrium(&lorenz(), [8.0, 8.0, 27.0]).expect("it rests");
    let side = (8.0_f64 / 3.0 * 27.0).sqrt();
    assert_relative_eq!(found.x, SVector::from([side, side, 27.0]), epsilon = 1e-12);
    // an event of a scene without bodies
    let solution = Vern9::new()
        .solve_with(&lorenz(), 0.0, 10.0, [1.0, 1.0, 20.0], &lorenz().events())
        .expect("regular");
    assert!(solution.events().len() > 10);
    let mut csv = Vec::new();
    solution.write_csv(&mut csv, &Lorenz::LAYOUT).expect("memory");
    assert!(csv.starts_with(b"t,x,y,z\n"));
    // a wheel that sticks rests where the integral of its angle rests
    let held = stability::resting(&servo_without_voltage(), [1.0, 0.5, 0.1, 0.0]).expect("it rests");
    assert!(held.x.norm() < 1e-12 && held.mode.0[0] == Status::Stuck, "{held:?}");
}

fn servo_without_voltage() -> Servo {
    servo()
        .with_params(ServoParams {
            v: 0.0,
            ..ServoParams::default()
        })
        .expect("physical")
}
