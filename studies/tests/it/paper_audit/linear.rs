//! Eq. 24 to 26: small motions about hanging, against the generated Jacobian.

use nalgebra::{SMatrix, SVector};
use pendulum_core::prelude::*;
use pendulum_core::stability::Spectrum;

use super::units::{OTHER, apart};
use testbed::printed::Pendulum;
use testbed::random::Random;
use testbed::scenes::{DoublePendulum, DoublePendulumParams};

type StateMatrix = SMatrix<f64, 4, 4>;
type Form = fn(&Pendulum) -> StateMatrix;

fn generated(p: &Pendulum) -> StateMatrix {
    let params = DoublePendulumParams {
        m: p.m,
        inertia: p.inertia,
        c: p.d,
        d: p.d,
        g: p.g,
        gamma1: p.gamma1,
        gamma2: p.gamma2,
    };
    let model = DoublePendulum::new(params).expect("physical");
    model.jacobian(0.0, &SVector::zeros())
}

/// The largest growth rate of a motion, in 1/s.
fn growth(matrix: &StateMatrix) -> f64 {
    Spectrum::of(matrix).expect("finite").modes()[0].growth_rate()
}

fn random_pendulum(random: &mut Random) -> Pendulum {
    let mut between = |low, high| random.between(low, high);
    Pendulum {
        m: between(0.2, 3.0),
        inertia: between(0.05, 2.0),
        d: between(0.2, 1.5),
        g: between(1.0, 20.0),
        gamma1: between(0.1, 2.0),
        gamma2: between(0.1, 2.0),
    }
}

/// The largest defect of a form after a change of units, over the largest entry.
fn unit_defect(form: impl Fn(&Pendulum) -> StateMatrix) -> f64 {
    let p = Pendulum {
        m: 1.3,
        ..Pendulum::paper(0.4, 0.3)
    };
    apart(&form(&OTHER.pendulum(&p)), &OTHER.matrix(&form(&p)))
}

#[test]
fn the_linearisation_of_eq_22_is_the_generated_jacobian() {
    let mut random = Random::new(1);
    for _ in 0..1000 {
        let p = random_pendulum(&mut random);
        let jacobian = generated(&p);
        assert!(apart(&p.linear(), &jacobian) < 1e-13);
        assert!(apart(&p.linear_with_sign_of_24a(), &jacobian) > 1e-3);
        assert!(apart(&p.linear_with_friction_in_denominator(), &jacobian) > 1e-3);
        assert!(apart(&p.linear_with_sign_of_gravity(), &jacobian) > 1e-3);
        assert!(apart(&p.linear_with_sign_of_friction(), &jacobian) > 1e-3);
    }
    assert!(unit_defect(Pendulum::linear) < 1e-13);
}

/// With the sign of Eq. 24a the upper axle drives the plates. The lower one still brakes them, and wins while it has more friction.
#[test]
fn eq_24a_brakes() {
    for (gamma1, gamma2) in [
        (0.05, 0.1),
        (0.1, 0.1),
        (0.4, 0.4),
        (1.0, 1.0),
        (0.2, 0.1),
        (1.0, 0.1),
        (10.0, 1.0),
    ] {
        let p = Pendulum::paper(gamma1, gamma2);
        let (right, printed) = (growth(&p.linear()), growth(&p.linear_with_sign_of_24a()));
        println!("Eq. 24a, gamma1 {gamma1}, gamma2 {gamma2}: growth right {right:.3e}, printed {printed:.3e} 1/s");
        assert!((growth(&generated(&p)) - right).abs() < 1e-10);
        assert!(right < -1e-3);
        assert_eq!(printed > 0.0, gamma1 >= gamma2);
        assert!(printed - right > 1e-3);
    }
}

/// The denominator is `det M`. With `gamma1` in it, as if that were an inertia, it falls to zero at
/// `gamma1 = det M / (m d^2 + I)`, which is 2.5 for the numbers of the paper, and from there on the plates fall upward.
#[test]
fn eq_25_and_26_have_no_friction_in_the_denominator() {
    let (right, printed) = (
        unit_defect(Pendulum::linear),
        unit_defect(Pendulum::linear_with_friction_in_denominator),
    );
    println!(
        "Eq. 25, 26, denominator: after a change of units right {right:.1e}, printed {printed:.3} of the largest entry"
    );
    assert!(right < 1e-13);
    assert!(printed > 0.01);
    for (gamma1, stable) in [(0.1, true), (1.0, true), (2.49, true), (2.51, false), (10.0, false)] {
        let p = Pendulum::paper(gamma1, 0.1);
        let (right, printed) = (growth(&p.linear()), growth(&p.linear_with_friction_in_denominator()));
        println!(
            "Eq. 25, 26, denominator, gamma1 {gamma1}, gamma2 0.1: growth right {right:.4}, printed {printed:.4} 1/s"
        );
        assert!(right < 0.0);
        assert_eq!(printed < 0.0, stable);
    }
}

/// For plates of 1 kg a power of `m` makes no difference, so that no figure of the paper shows it.
#[test]
fn eq_25_and_26_are_of_first_order_in_m() {
    assert!(unit_defect(Pendulum::linear) < 1e-13);
    let heavy = Pendulum {
        m: 2.0,
        ..Pendulum::paper(0.0, 0.0)
    };
    let frequency = |matrix: &StateMatrix| {
        let spectrum = Spectrum::of(matrix).expect("finite");
        spectrum
            .modes()
            .iter()
            .map(|mode| mode.angular_frequency())
            .fold(f64::INFINITY, f64::min)
    };
    let right = frequency(&generated(&heavy));
    assert!((frequency(&heavy.linear()) / right - 1.0).abs() < 1e-10);
    let forms: [(&str, Form, f64); 2] = [
        ("m^2", Pendulum::linear_with_m_squared, 2.0_f64.sqrt()),
        ("m^3", Pendulum::linear_with_m_cubed, 2.0),
    ];
    for (name, form, factor) in forms {
        let paper = Pendulum::paper(0.1, 0.1);
        assert_eq!(form(&paper), paper.linear());
        let (defect, ratio) = (unit_defect(form), frequency(&form(&heavy)) / right);
        println!(
            "Eq. 25, 26, {name}: after a change of units {defect:.1e}; at m = 2 kg frequencies {ratio:.4} times the right ones"
        );
        assert!(defect > 1.0);
        assert!((ratio - factor).abs() < 1e-10);
    }
}

#[test]
fn eq_25_and_26_have_the_signs_of_a_braked_hanging_pendulum() {
    let p = Pendulum::paper(0.1, 0.1);
    let right = growth(&p.linear());
    assert!(right < 0.0 && (growth(&generated(&p)) - right).abs() < 1e-10);
    let forms = [
        ("gravity", p.linear_with_sign_of_gravity()),
        ("friction", p.linear_with_sign_of_friction()),
    ];
    for (name, form) in forms {
        let printed = growth(&form);
        println!("Eq. 25, 26, sign of {name}: growth right {right:.4}, printed {printed:.4} 1/s");
        assert!(printed > 1e-3);
    }
}
