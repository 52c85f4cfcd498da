//! Eq. 4, 9, 11 and 12: the Newton-Euler equations of the plates, which the generated accelerations must satisfy.

use nalgebra::{SVector, Vector2};
use pendulum_core::prelude::*;

use testbed::random::Random;
use testbed::scenes::{DoublePendulum, DoublePendulumParams};

/// Plate of the pendulum in motion, in the ground frame, with the upper joint at the origin.
struct Plate {
    /// Position and acceleration of its joint.
    r: [Vector2<f64>; 2],
    /// Position and acceleration of its centre of mass.
    c: [Vector2<f64>; 2],
    /// Derivatives of the position of its centre of mass by the angles of the upper and of the lower plate.
    slopes: [Vector2<f64>; 2],
    angular_acceleration: f64,
}

/// Both plates at a state, given its derivative.
fn plates(p: &DoublePendulumParams, x: &SVector<f64, 4>, rate: &SVector<f64, 4>) -> [Plate; 2] {
    // position and its derivative by the angle, for a point at this distance below the joint of a plate
    let arm = |plate: usize, length: f64| {
        let (sin, cos) = x[plate].sin_cos();
        let (position, slope) = (length * Vector2::new(sin, -cos), length * Vector2::new(cos, sin));
        let acceleration = slope * rate[2 + plate] - position * x[2 + plate] * x[2 + plate];
        ([position, acceleration], slope)
    };
    let ((r2, r2_slope), (c1, c1_slope), (c2, c2_slope)) = (arm(0, p.d), arm(0, p.c), arm(1, p.c));
    let zero = Vector2::zeros();
    [
        Plate {
            r: [zero; 2],
            c: c1,
            slopes: [c1_slope, zero],
            angular_acceleration: rate[2],
        },
        Plate {
            r: r2,
            c: [r2[0] + c2[0], r2[1] + c2[1]],
            slopes: [r2_slope, c2_slope],
            angular_acceleration: rate[3],
        },
    ]
}

fn random_state(random: &mut Random) -> SVector<f64, 4> {
    SVector::from([3.2, 3.2, 5.0, 5.0].map(|most| random.between(-most, most)))
}

/// Friction torques on the upper and on the lower plate.
fn friction(p: &DoublePendulumParams, x: &SVector<f64, 4>) -> [f64; 2] {
    let lower = p.gamma2 * (x[2] - x[3]);
    [-p.gamma1 * x[2] - lower, lower]
}

/// Forces of inertia, weight and friction together do no virtual work in any rotation of a plate (d'Alembert). With
/// `r2'' + c2''` as acceleration of the lower plate they would: the `c2` of Eq. 4 is measured from the ground, and so
/// includes `r2` already.
#[test]
fn eq_11_counts_the_lower_axle_twice() {
    let p = DoublePendulumParams::default();
    let model = DoublePendulum::new(p).expect("physical");
    let weight = Vector2::new(0.0, -p.m * p.g);
    let mut random = Random::new(1);
    let (mut right, mut printed, mut largest) = (0.0_f64, 0.0_f64, 0.0_f64);
    for _ in 0..1000 {
        let x = random_state(&mut random);
        let plates = plates(&p, &x, &model.rhs(0.0, &x));
        for turned in [0, 1] {
            // virtual work per radian of rotation of one plate
            let forces = |acceleration: fn(&Plate) -> Vector2<f64>| -> f64 {
                let force = |plate: &Plate| (weight - p.m * acceleration(plate)).dot(&plate.slopes[turned]);
                plates.iter().map(force).sum()
            };
            let torque = friction(&p, &x)[turned] - p.inertia * plates[turned].angular_acceleration;
            right = right.max((forces(|plate| plate.c[1]) + torque).abs());
            printed = printed.max((forces(|plate| plate.r[1] + plate.c[1]) + torque).abs());
            largest = largest.max(torque.abs());
        }
    }
    println!(
        "Eq. 11: torque left over with c2'' {right:.1e}, with r2'' + c2'' up to {printed:.1} N m, beside {largest:.1}"
    );
    assert!(right < 1e-14 * largest);
    assert!(printed > 0.1 * largest);
}

/// The angular momentum of both plates about the upper joint changes by the friction there and by the moments of the
/// weights, `c x (-m g j)`. Without these moments, plates would rest at any angles.
#[test]
fn eq_12_wants_the_moment_of_gravity() {
    let p = DoublePendulumParams::default();
    let model = DoublePendulum::new(p).expect("physical");
    let weight = Vector2::new(0.0, -p.m * p.g);
    let mut random = Random::new(2);
    let (mut right, mut printed) = (0.0_f64, 0.0_f64);
    for _ in 0..1000 {
        let x = random_state(&mut random);
        let plates = plates(&p, &x, &model.rhs(0.0, &x));
        let sum = |part: &dyn Fn(&Plate) -> f64| plates.iter().map(part).sum::<f64>();
        let change = sum(&|plate| p.m * plate.c[0].perp(&plate.c[1]) + p.inertia * plate.angular_acceleration);
        let moment = sum(&|plate| plate.c[0].perp(&weight));
        let without = change + p.gamma1 * x[2];
        right = right.max((without - moment).abs());
        printed = printed.max(without.abs());
    }
    // both weights, with level plates
    let largest = 3.0 * p.m * p.g * p.d;
    println!("Eq. 12: moment left over with gravity {right:.1e}, without up to {printed:.1} N m of {largest:.1}");
    assert!(right < 1e-14 * largest);
    assert!(printed > 0.9 * largest);

    let weightless = DoublePendulum::new(DoublePendulumParams { g: 0.0, ..p }).expect("physical");
    let leaning = SVector::from([0.5, -1.2, 0.0, 0.0]);
    assert_eq!(weightless.rhs(0.0, &leaning).amax(), 0.0);
    assert!(model.rhs(0.0, &leaning).amax() > 1.0);
}
