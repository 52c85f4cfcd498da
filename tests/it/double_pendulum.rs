//! The first scene in numbers: generated code against hand-written Eq. 22, its Jacobian, its energy, its cost.

use approx::assert_relative_eq;
use nalgebra::{SMatrix, SVector};
use pendulum_core::prelude::*;
use testbed::dual::Dual;
use testbed::eq22::{Eq22, Plate};
use testbed::plates::{Plates, PlatesParams, RelativePlates, RelativePlatesParams};
use testbed::random::Random;
use testbed::scenes::{DoublePendulum, DoublePendulumParams};

/// Relative tolerance: both sides have some thirty rounding errors of numbers of similar size.
const TOLERANCE: f64 = 1e-13;
const SAMPLES: usize = 5000;

fn assert_close<const R: usize, const C: usize>(ours: SMatrix<f64, R, C>, theirs: SMatrix<f64, R, C>, tolerance: f64) {
    let error = (ours - theirs).amax() / theirs.amax();
    assert!(
        error < tolerance,
        "error {error:e} of the largest entry\n{ours}{theirs}"
    );
}

fn random_state(random: &mut Random) -> SVector<f64, 4> {
    SVector::from([3.2, 3.2, 5.0, 5.0].map(|most| random.between(-most, most)))
}

fn random_plates(random: &mut Random) -> (Plate, Plate, f64, f64) {
    let mut plate = || Plate {
        mass: random.between(0.2, 3.0),
        inertia: random.between(0.05, 2.0),
        c: random.between(0.1, 1.5),
        friction: random.between(0.0, 2.0),
    };
    let (upper, lower) = (plate(), plate());
    (upper, lower, random.between(0.2, 1.5), random.between(1.0, 20.0))
}

fn plates((upper, lower, d, g): (Plate, Plate, f64, f64)) -> PlatesParams {
    PlatesParams {
        m1: upper.mass,
        m2: lower.mass,
        inertia1: upper.inertia,
        inertia2: lower.inertia,
        c1: upper.c,
        c2: lower.c,
        d,
        g,
        gamma1: upper.friction,
        gamma2: lower.friction,
    }
}

#[test]
fn generated_and_hand_written_agree() {
    let mut random = Random::new(1);
    for _ in 0..SAMPLES {
        let given = random_plates(&mut random);
        let generated = Plates::new(plates(given)).expect("physical");
        let by_hand: Eq22 = Eq22::new(given.0, given.1, given.2, given.3);
        let x = random_state(&mut random);
        assert_close(generated.rhs(0.0, &x), by_hand.rhs(0.0, &x), TOLERANCE);
        assert_close(generated.jacobian(0.0, &x), by_hand.jacobian(0.0, &x), TOLERANCE);
        let energy = generated.kinetic(0.0, &x).abs() + generated.potential(0.0, &x).abs();
        assert_relative_eq!(
            generated.energy(0.0, &x),
            by_hand.energy(0.0, &x),
            epsilon = TOLERANCE * energy
        );
    }
}

#[test]
fn identical_plates_agree_too() {
    let mut random = Random::new(2);
    for _ in 0..SAMPLES {
        let (plate, other, d, g) = random_plates(&mut random);
        let Plate {
            mass: m,
            inertia,
            c,
            friction: gamma1,
        } = plate;
        let gamma2 = other.friction;
        let generated = DoublePendulum::new(DoublePendulumParams {
            m,
            inertia,
            c,
            d,
            g,
            gamma1,
            gamma2,
        })
        .expect("physical");
        let by_hand: Eq22 = Eq22::new(
            plate,
            Plate {
                friction: gamma2,
                ..plate
            },
            d,
            g,
        );
        let x = random_state(&mut random);
        assert_close(generated.rhs(0.0, &x), by_hand.rhs(0.0, &x), TOLERANCE);
        assert_close(generated.jacobian(0.0, &x), by_hand.jacobian(0.0, &x), TOLERANCE);
    }
}

/// Dual numbers propagate one exact derivative through the right-hand side.
#[test]
fn the_jacobian_is_the_derivative() {
    let mut random = Random::new(3);
    for _ in 0..SAMPLES {
        let params = plates(random_plates(&mut random));
        let model = Plates::new(params).expect("physical");
        let exact = Plates::new(params).expect("physical").cast::<Dual>();
        let x = random_state(&mut random);
        let columns = [0, 1, 2, 3].map(|k| {
            let x = SVector::from_fn(|n, _| Dual::new(x[n], if n == k { 1.0 } else { 0.0 }));
            exact.rhs(Dual::default(), &x).map(|component| component.slope)
        });
        assert_close(model.jacobian(0.0, &x), SMatrix::from_columns(&columns), TOLERANCE);
    }
}

/// `theta2 = q1 + q2`: other coordinates for the same motion.
#[test]
fn relative_and_absolute_angles_agree() {
    let mut random = Random::new(4);
    for _ in 0..SAMPLES {
        let p = plates(random_plates(&mut random));
        let PlatesParams {
            m1,
            m2,
            inertia1,
            inertia2,
            c1,
            c2,
            d,
            g,
            gamma1,
            gamma2,
        } = p;
        let absolute = Plates::new(p).expect("physical");
        let same = RelativePlatesParams {
            m1,
            m2,
            inertia1,
            inertia2,
            c1,
            c2,
            d,
            g,
            gamma1,
            gamma2,
        };
        let relative = RelativePlates::new(same).expect("physical");
        let x = random_state(&mut random);
        let joint = SVector::from([x[0], x[1] - x[0], x[2], x[3] - x[2]]);
        let (ours, theirs) = (absolute.rhs(0.0, &x), relative.rhs(0.0, &joint));
        let theirs = SVector::from([theirs[0], theirs[0] + theirs[1], theirs[2], theirs[2] + theirs[3]]);
        // the rates differ before they are added up, which costs some digits
        assert_close(theirs, ours, 10.0 * TOLERANCE);
    }
}

/// The heat dissipated in the axles is integrated along with the motion.
#[test]
fn what_the_energy_loses_is_the_work_of_friction() {
    let model = DoublePendulum::new(DoublePendulumParams::default()).expect("physical");
    let with_heat = FnSystem(|t, x: &SVector<f64, 5>| {
        let rhs = model.rhs(t, &x.fixed_rows::<4>(0).into_owned());
        let heating = 0.1 * x[2] * x[2] + 0.1 * (x[2] - x[3]) * (x[2] - x[3]);
        SVector::from([rhs[0], rhs[1], rhs[2], rhs[3], heating])
    });
    let method = Rk45::new().rtol(1e-10).atol(1e-10);
    let solution = method
        .solve(&with_heat, 0.0, 20.0, [2.0, 2.5, 0.0, 0.0, 0.0])
        .expect("regular");
    let energy = |x: &SVector<f64, 5>| model.energy(0.0, &x.fixed_rows::<4>(0).into_owned());
    let first = energy(&solution.x()[0]);
    for x in solution.x() {
        assert_relative_eq!(energy(x) + x[4], first, epsilon = 1e-7);
    }
    assert!(solution.end()[4] > 20.0, "the plates hardly swung");
}

/// The rate of the energy equals the power of friction at every state: `dE/dt = -gamma1 w1^2 - gamma2 (w1 - w2)^2`.
#[test]
fn the_loss_of_energy_is_the_power_of_friction() {
    let params = DoublePendulumParams {
        gamma1: 0.7,
        gamma2: 0.3,
        c: 0.6,
        ..Default::default()
    };
    let exact = DoublePendulum::new(params).expect("physical").cast::<Dual>();
    let mut random = Random::new(5);
    for _ in 0..SAMPLES {
        let x = random_state(&mut random);
        let rate = exact.rhs(Dual::default(), &x.map(|value| Dual::new(value, 0.0)));
        let moving = SVector::from_fn(|n, _| Dual::new(x[n], rate[n].value));
        let power = exact.energy(Dual::default(), &moving).slope;
        let friction = -0.7 * x[2] * x[2] - 0.3 * (x[2] - x[3]) * (x[2] - x[3]);
        assert_relative_eq!(power, friction, epsilon = 1e-10);
    }
}

/// The hand-written equation takes 34 operations, with its parameters regrouped and the adjugate written out.
#[test]
fn the_right_hand_side_is_as_short_as_by_hand() {
    let [rhs, jacobian] = ["rhs", "jacobian"].map(|name| DoublePendulum::COST[name]);
    assert!(rhs.flops() <= 34, "{rhs}");
    assert!(Plates::COST["rhs"].flops() <= 34, "{}", Plates::COST["rhs"]);
    assert_eq!(
        (
            rhs.operations.divisions,
            rhs.operations.sincos,
            rhs.operations.functions
        ),
        (1, 2, 0)
    );
    assert!(jacobian.flops() <= 95, "{jacobian}");
    assert_eq!((jacobian.operations.divisions, jacobian.operations.sincos), (1, 2));
}

/// Heavy on light and light on heavy: the determinant is a sum of positive terms, so no digits are lost.
/// `solve_accuracy.rs` has more states and scenes.
#[test]
fn extreme_mass_ratios_lose_no_digits() {
    for ratio in [1e-8, 1e-4, 1e4, 1e8] {
        let params = PlatesParams {
            m1: 1.0,
            m2: ratio,
            inertia1: 0.0,
            inertia2: 0.0,
            c1: 1.0,
            c2: 1.0,
            d: 1.0,
            g: 9.81,
            gamma1: 0.0,
            gamma2: 0.0,
        };
        let model = Plates::new(params).expect("physical");
        let x = SVector::<f64, 4>::from([0.3, 0.30001, 0.0, 0.0]);
        let rhs = model.rhs(0.0, &x);
        // two point masses from rest: th1'' = -g (sin th1 - m cos(th1 - th2) sin th2 + m sin th1) / (1 + m sin^2(th1 -
        // th2)) with sin th1 - cos(th1 - th2) sin th2 = sin(th1 - th2) cos th2, which has no cancellation
        let (sine, _) = (x[0] - x[1]).sin_cos();
        let first = -9.81 * (x[0].sin() + ratio * sine * x[1].cos()) / (1.0 + ratio * sine * sine);
        assert_relative_eq!(rhs[2], first, max_relative = 1e-9);
    }
}

#[test]
fn single_precision_runs_the_same_code() {
    let double = DoublePendulum::new(DoublePendulumParams::default()).expect("physical");
    let single = DoublePendulum::new(DoublePendulumParams::default())
        .expect("physical")
        .cast::<f32>();
    let mut random = Random::new(6);
    for _ in 0..SAMPLES {
        let x = random_state(&mut random);
        let rounded = x.map(|value| value as f32);
        let ours = single.rhs(0.0, &rounded).map(f64::from);
        assert_close(ours, double.rhs(0.0, &rounded.map(f64::from)), 1e-5);
    }
}

#[test]
fn facts_are_constants_of_the_type() {
    assert_eq!(DoublePendulum::DOF, 2);
    assert_eq!(DoublePendulum::COORDINATES, ["theta1", "theta2"]);
    let text = DoublePendulum::EQUATIONS;
    assert!(
        text.contains("A[theta1, theta2] = m*c*d*cos(theta1 - theta2)"),
        "{text}"
    );
    assert!(text.contains("A[theta1, theta1] = inertia + m*c^2 + m*d^2"), "{text}");
}

#[test]
fn impossible_parameters_are_refused() {
    let good = DoublePendulumParams::default();
    let refused = |params: DoublePendulumParams| {
        let error = DoublePendulum::new(params).expect_err("impossible");
        (error.name, error.value, error.to_string())
    };
    let (name, value, text) = refused(DoublePendulumParams { m: -1.0, ..good });
    assert_eq!((name, value), ("m", -1.0));
    assert_eq!(text, "parameter `m` is -1: the mass of `plate` must be positive");
    assert_eq!(refused(DoublePendulumParams { m: 0.0, ..good }).0, "m");
    assert_eq!(refused(DoublePendulumParams { inertia: -0.5, ..good }).0, "inertia");
    assert_eq!(refused(DoublePendulumParams { gamma2: -1e-9, ..good }).0, "gamma2");
    assert_eq!(
        refused(DoublePendulumParams {
            g: f64::INFINITY,
            ..good
        })
        .0,
        "g"
    );
    assert!(refused(DoublePendulumParams { d: f64::NAN, ..good }).1.is_nan());
    // point masses on the axles: no coordinate has inertia, which a constant of the model has as divisor
    let points = DoublePendulumParams {
        inertia: 0.0,
        c: 0.0,
        d: 0.0,
        ..good
    };
    let (_, value, text) = refused(points);
    assert!(value.is_infinite() || value.is_nan(), "{value}");
    assert!(text.contains("a coordinate has no inertia"), "{text}");
    assert!(text.contains("inertia = 0, c = 0, d = 0"), "{text}");
}
