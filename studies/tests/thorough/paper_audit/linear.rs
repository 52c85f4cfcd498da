//! Eq. 24 to 26: small motions about hanging, compared with the generated Jacobian.

use nalgebra::{Matrix2, SMatrix, SVector};
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

/// Largest growth rate of a motion, in 1/s.
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

/// Largest defect of a form under a change of units, relative to the largest entry.
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
        assert!(apart(&p.eq25_printed(), &jacobian) > 1e-3);
        assert!(apart(&p.linear_with_sign_of_gravity(), &jacobian) > 1e-3);
        assert!(apart(&p.linear_with_sign_of_friction(), &jacobian) > 1e-3);
    }
    assert!(unit_defect(Pendulum::linear) < 1e-13);
}

/// With the sign of Eq. 24a the friction of the upper joint drives the plates. The lower joint still brakes them, and
/// dominates if it has more friction.
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
    // the slow mode, of shape (1, 2)
    let p = Pendulum::paper(1e-4, 3e-4);
    assert!((growth(&p.linear()) + (p.gamma1 + p.gamma2) / 30.0).abs() < 1e-10);
    assert!((growth(&p.linear_with_sign_of_24a()) + (p.gamma2 - p.gamma1) / 30.0).abs() < 1e-10);
}

/// Plates of 1 kg, for which the powers of `m` in the printed Eq. 25 make no difference.
fn random_pendulum_of_1_kg(random: &mut Random) -> Pendulum {
    Pendulum {
        m: 1.0,
        ..random_pendulum(random)
    }
}

/// Eq. 24 with `gamma1 theta1''` in place of the printed `gamma1 theta1'` among the torques, solved for the
/// accelerations.
fn eq24_with_an_acceleration_for_a_rate(p: &Pendulum) -> StateMatrix {
    let (md2, mgd) = (p.m * p.d * p.d, p.m * p.g * p.d);
    let mass = Matrix2::new(2.0 * md2 + p.inertia - p.gamma1, md2, md2, md2 + p.inertia);
    let stiffness = Matrix2::new(2.0 * mgd, 0.0, 0.0, mgd);
    let damping = Matrix2::new(p.gamma2, -p.gamma2, -p.gamma2, p.gamma2);
    let mut matrix = StateMatrix::zeros();
    matrix.fixed_view_mut::<2, 2>(0, 2).fill_with_identity();
    for (column, torques) in [(0, stiffness), (2, damping)] {
        let accelerations = mass.lu().solve(&-torques).expect("gamma1 is not at the threshold");
        matrix.fixed_view_mut::<2, 2>(2, column).copy_from(&accelerations);
    }
    matrix
}

/// The `a` of Section 5: the `gamma1` at which the denominator of the printed Eq. 25 vanishes.
fn threshold(p: &Pendulum) -> f64 {
    let md2 = p.m * p.d * p.d;
    (md2 * md2 + 3.0 * md2 * p.inertia + p.inertia * p.inertia) / (md2 + p.inertia)
}

/// Number of eigenvalues with a positive real part; none may be so small that its sign is due to rounding.
fn unstable(matrix: &StateMatrix) -> usize {
    let spectrum = Spectrum::of(matrix).expect("finite");
    for mode in spectrum.modes() {
        assert!(mode.growth_rate().abs() > mode.uncertainty, "{mode:?}");
    }
    spectrum.eigenvalues().filter(|eigenvalue| eigenvalue.re > 0.0).count()
}

/// The tests of the generator derive the same result symbolically.
#[test]
fn eq_25_is_eq_24a_with_an_acceleration_for_a_rate() {
    let mut random = Random::new(4);
    let (mut origin, mut right) = (0.0_f64, f64::INFINITY);
    for _ in 0..100 {
        let p = random_pendulum_of_1_kg(&mut random);
        origin = origin.max(apart(&eq24_with_an_acceleration_for_a_rate(&p), &p.eq25_printed()));
        right = right.min(apart(&p.linear(), &p.eq25_printed()));
    }
    println!("Eq. 25: from Eq. 24a with theta1'' for theta1' {origin:.1e}, from the right one {right:.1e} or more");
    assert!(origin < 1e-13);
    assert!(right > 1e-2);
}

/// A torque `gamma1 theta1''` reduces an inertia by `gamma1`. From the threshold on, the mass matrix has a negative
/// eigenvalue, so one motion grows. With the sign of Eq. 24a alone, none, two or four grow.
#[test]
fn section_5_is_what_the_printed_eq_25_says() {
    let mut random = Random::new(5);
    let unit = Pendulum::paper(0.0, 0.0);
    assert_eq!(threshold(&unit), 2.5);
    let (mut pendulums, mut samples) = (vec![unit], 0);
    pendulums.extend((0..20).map(|_| random_pendulum_of_1_kg(&mut random)));
    for p in pendulums {
        let a = threshold(&p);
        for gamma2 in [0.01, 0.1, 1.0, 10.0, 100.0] {
            for part in [0.0, 0.5, 0.96, 0.999, 1.001, 1.04, 2.0, 100.0] {
                let p = Pendulum {
                    gamma1: part * a,
                    gamma2,
                    ..p
                };
                let printed = unstable(&p.eq25_printed());
                assert_eq!(printed, usize::from(part > 1.0), "gamma1 at {part} a, {p:?}");
                assert_eq!(unstable(&generated(&p)), 0, "{p:?}");
                assert!([0, 2, 4].contains(&unstable(&p.linear_with_sign_of_24a())), "{p:?}");
                samples += 1;
            }
        }
    }
    println!("Section 5: of {samples} printed Eq. 25 those with gamma1 > a have one growing motion, the others none");
}

/// Table of the page: growth rates in 1/s to five digits, each with the number of growing eigenvalues, at
/// `gamma2 = 0.1`.
#[test]
fn growth_rates_right_and_as_printed() {
    for (gamma1, expected) in [
        (0.1, [(-0.00666, 0), (0.00001, 2), (-0.00365, 0)]),
        (1.0, [(-0.03644, 0), (0.10009, 4), (-0.00669, 0)]),
        (2.4, [(-0.08006, 0), (0.33605, 4), (-0.01086, 0)]),
        (2.6, [(-0.08582, 0), (0.37025, 4), (15.98252, 1)]),
        (10.0, [(-0.12991, 0), (1.83571, 4), (1.66181, 1)]),
    ] {
        let p = Pendulum::paper(gamma1, 0.1);
        let forms = [generated(&p), p.linear_with_sign_of_24a(), p.eq25_printed()];
        for (form, (rate, count)) in forms.iter().zip(expected) {
            assert!((growth(form) - rate).abs() < 6e-6, "gamma1 {gamma1}: {rate}");
            assert_eq!(unstable(form), count, "gamma1 {gamma1}: {rate}");
        }
    }
}

/// The denominator is `det M`. With `gamma1` in it, as if it were an inertia, its terms differ in their units.
#[test]
fn eq_25_and_26_have_no_friction_in_the_denominator() {
    let (right, printed) = (unit_defect(Pendulum::linear), unit_defect(Pendulum::eq25_printed));
    println!("Eq. 25: after a change of units right {right:.1e}, printed {printed:.3} of the largest entry");
    assert!(right < 1e-13);
    assert!(printed > 0.01);
}

/// For plates of 1 kg a power of `m` makes no difference, so no figure of the paper shows it.
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
            "Eq. 25, 26, {name}: after a change of units {defect:.1e}; at m = 2 kg frequencies {ratio:.4} times the \
             right ones"
        );
        assert!(defect > 1.0);
        assert!((ratio - factor).abs() < 1e-10);
    }
}

/// Without `gamma1` the printed Eq. 25 is correct. A sign of Eq. 26 with which hanging is unstable there contradicts
/// it.
#[test]
fn eq_26_contradicts_eq_25() {
    let p = Pendulum::paper(0.0, 0.1);
    assert!(apart(&p.eq25_printed(), &generated(&p)) < 1e-14);
    assert_eq!(unstable(&p.eq25_printed()), 0);
    let forms = [
        ("gravity", p.linear_with_sign_of_gravity()),
        ("friction", p.linear_with_sign_of_friction()),
    ];
    for (name, form) in forms {
        let (printed, right) = (growth(&form), growth(&p.eq25_printed()));
        println!("Eq. 26, sign of {name}: growth {printed:.5} 1/s, by Eq. 25 {right:.5}");
        assert!(printed > 1e-3);
    }
}
