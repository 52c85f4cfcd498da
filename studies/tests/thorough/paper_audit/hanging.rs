//! Section 5: hanging at rest is asymptotically stable for any friction, and standing is unstable.

use nalgebra::SVector;
use pendulum_core::stability::{Equilibrium, Stability, equilibria};

use super::quartic::{characteristic, is_stable, largest_root};
use testbed::printed::Pendulum;
use testbed::scenes::{DoublePendulum, DoublePendulumParams};

/// Equilibria of the paper's pendulum; each plate hangs (1) or stands (-1).
fn states_of_rest(gamma1: f64, gamma2: f64) -> Vec<([f64; 2], Equilibrium<4>)> {
    let params = DoublePendulumParams {
        gamma1,
        gamma2,
        ..Default::default()
    };
    let model = DoublePendulum::new(params).expect("physical");
    let found = equilibria(&model, [SVector::from([0.1, 0.1, 0.0, 0.0])]).expect("autonomous");
    assert_eq!(found.len(), 4);
    let named = found
        .into_iter()
        .map(|e| ([e.x[0].cos().round(), e.x[1].cos().round()], e));
    named.collect()
}

/// Zero, and powers of ten from 1e-3 to 1e4, in N m s.
fn frictions() -> Vec<f64> {
    let powers = (-3..=4).map(|n| 10.0_f64.powi(n));
    std::iter::once(0.0).chain(powers).collect()
}

#[test]
fn hanging_is_asymptotically_stable_with_any_friction() {
    let (mut least, mut samples) = (f64::INFINITY, 0);
    for gamma1 in frictions() {
        for gamma2 in frictions() {
            if gamma1 == 0.0 && gamma2 == 0.0 {
                continue;
            }
            for (plates, rest) in states_of_rest(gamma1, gamma2) {
                let quartic = characteristic(&Pendulum::paper(gamma1, gamma2), plates);
                let hangs = plates == [1.0, 1.0];
                assert_eq!(is_stable(quartic), hangs);
                let expected = if hangs {
                    Stability::AsymptoticallyStable
                } else {
                    Stability::Unstable
                };
                assert_eq!(rest.stability(), expected, "{plates:?} at {gamma1}, {gamma2}: {rest:?}");
                if hangs {
                    least = least.min(-rest.spectrum.modes()[0].growth_rate());
                    samples += 1;
                }
            }
        }
    }
    println!("Section 5: hanging decays in all {samples} cases, at {least:.2e} 1/s or faster");
    assert_eq!(samples, 80);
}

/// The growth rate is the largest root of the characteristic polynomial.
#[test]
fn standing_grows_as_linear_theory_says() {
    for gamma1 in frictions() {
        for gamma2 in frictions() {
            for (plates, rest) in states_of_rest(gamma1, gamma2) {
                if plates == [1.0, 1.0] {
                    continue;
                }
                let mode = &rest.spectrum.modes()[0];
                let expected = largest_root(characteristic(&Pendulum::paper(gamma1, gamma2), plates));
                let error = (mode.growth_rate() - expected).abs();
                assert!(
                    error <= 1e-12 * expected + 2.0 * mode.uncertainty,
                    "{plates:?} at {gamma1}, {gamma2}: {error:e}"
                );
                if gamma1 == gamma2 && (gamma1 == 0.0 || gamma1 == 0.1) {
                    println!("Section 5: {plates:?} with gamma {gamma1} grows at {expected:.6} 1/s, error {error:.1e}");
                }
            }
        }
    }
}

/// `(I^2 + 3 I m d^2 + m^2 d^4) w^4 - (3 I + 4 m d^2) m g d w^2 + 2 (m g d)^2 = 0`: with ones,
/// `5 w^4 - 7 g w^2 + 2 g^2 = 0`, so `w^2` is `g` or `2 g / 5`.
#[test]
fn without_friction_hanging_swings_for_ever() {
    let states = states_of_rest(0.0, 0.0);
    let (_, hanging) = states
        .iter()
        .find(|(plates, _)| *plates == [1.0, 1.0])
        .expect("it hangs");
    assert_eq!(hanging.stability(), Stability::Undecided);
    let frequencies = [9.8_f64.sqrt(), (0.4 * 9.8_f64).sqrt()];
    for (n, mode) in hanging.spectrum.modes().iter().enumerate() {
        assert!(mode.growth_rate().abs() <= mode.uncertainty);
        let error = frequencies.map(|w| (mode.angular_frequency() - w).abs());
        println!(
            "Section 5: without friction mode {n} has {:.6} rad/s, grows at {:.1e} 1/s",
            mode.angular_frequency(),
            mode.growth_rate()
        );
        assert!(error[0].min(error[1]) < 1e-13);
    }
}
