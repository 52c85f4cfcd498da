//! Table 1 and Section 2 of the paper: friction and inertia.

use nalgebra::{DVector, SVector};

use super::chain::pendulum;
use super::units::{OTHER, apart};
use testbed::printed::Pendulum;
use testbed::random::Random;

/// Friction is a torque per rate. Treated as a pure number, it makes the motion depend on the choice of units.
#[test]
fn table_1_friction_has_a_unit() {
    let paper = Pendulum::paper(0.4, 0.4);
    let mut random = Random::new(1);
    let (mut right, mut printed) = (0.0_f64, f64::INFINITY);
    for _ in 0..100 {
        let x = SVector::from_fn(|_, _| random.between(-2.0, 2.0));
        let expected = OTHER.rate(&paper.eq22(&x));
        let defect = |p: Pendulum| apart(&p.eq22(&OTHER.state(&x)), &expected);
        right = right.max(defect(OTHER.pendulum(&paper)));
        printed = printed.min(defect(OTHER.pendulum_without_unit_of_friction(&paper)));
    }
    println!(
        "Table 1: after a change of units N m s {right:.1e}, dimensionless {printed:.1e} or more of the largest rate"
    );
    assert!(right < 1e-13);
    assert!(printed > 1e-4);
}

/// Equal plates with `c = d = 1`: `A_22 = I + m d^2` is the inertia of the lower plate about its joint, so the `I` in
/// it is the inertia about the centre of mass.
#[test]
fn inertia_is_about_the_centre_of_mass() {
    let kinetic = pendulum(1.0).mass_matrix_of_points(&DVector::zeros(2))[(1, 1)];
    // two points of m/2 = 0.5, each 1 from the centre of mass and sqrt(2) from the joint
    let (about_the_centre, about_the_axle) = (0.5 * 2.0, 0.5 * 2.0 * 2.0);
    let a22 = |inertia: f64| inertia + 1.0 * 1.0_f64.powi(2);
    let (right, printed) = (a22(about_the_centre), a22(about_the_axle));
    println!(
        "Section 2: A_22 of point masses {kinetic:.9}; I about the centre {right}, about the axle {printed} kg m^2"
    );
    assert!((right - kinetic).abs() < 1e-9);
    assert!((printed - kinetic - 1.0).abs() < 1e-9);
}
