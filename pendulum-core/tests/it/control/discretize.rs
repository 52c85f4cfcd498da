//! Models from sample to sample.

use approx::assert_relative_eq;
use pendulum_core::Tsit5;
use pendulum_core::control::StateSpace;
use pendulum_core::nalgebra::{SMatrix, SVector};
use pendulum_core::prelude::*;

#[test]
fn a_harmonic_oscillator_turns_by_its_phase() {
    // Deviation and rate over the frequency turn by w h about the equilibrium u / w^2.
    for (frequency, period) in [(3.0_f64, 0.2_f64), (1e-3, 1.0), (2000.0, 0.013), (1.0, 1e-6)] {
        let a = SMatrix::<f64, 2, 2>::new(0.0, 1.0, -frequency * frequency, 0.0);
        let model = StateSpace::new(a, SMatrix::from([[0.0, 1.0]]));
        let sampled = model.discretize(period).expect("finite");
        let (sin, cos) = (frequency * period).sin_cos();
        let exact = SMatrix::<f64, 2, 2>::new(cos, sin / frequency, -frequency * sin, cos);
        let half = (0.5 * frequency * period).sin();
        let by_input = SMatrix::from([[2.0 * (half / frequency).powi(2), sin / frequency]]);
        // Rounding errors grow with the phase, by each halving of the exponential.
        let tolerance = 1e-14 * (1.0 + frequency * period);
        assert_relative_eq!(sampled.a, exact, epsilon = tolerance * frequency.max(1.0));
        assert_relative_eq!(sampled.b, by_input, max_relative = 100.0 * tolerance);
        assert_eq!(sampled.period, Some(period));
    }
}

/// Two coupled masses with damping, whose inputs act in N and in kN; the values are those of mpmath 1.4.1 with 50
/// digits.
#[test]
fn an_exponential_has_the_digits_of_its_reference() {
    let a = SMatrix::<f64, 4, 4>::from_row_slice(&[
        0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, -1200.0, 300.0, -2.5, 0.5, 400.0, -900.0, 0.25, -1.75,
    ]);
    let mut b = SMatrix::<f64, 4, 2>::zeros();
    (b[(2, 0)], b[(3, 1)]) = (2000.0, 0.001);
    let sampled = StateSpace::new(a, b).discretize(0.05).expect("finite");
    let known = SMatrix::<f64, 4, 4>::from_row_slice(&[
        -0.091_439_952_542_553_5,
        0.216_627_633_701_783,
        0.027_082_642_124_480_9,
        0.004_877_937_040_551_88,
        0.297_874_392_549_314,
        0.119_915_778_384_627,
        0.006_204_613_359_277_4,
        0.032_140_160_781_907_8,
        -30.547_995_733_156_3,
        3.734_649_300_847_57,
        -0.157_927_073_593_618,
        0.221_632_564_943_058,
        5.410_528_281_630_26,
        -27.064_760_695_933_8,
        0.290_397_899_346_597,
        0.066_772_803_695_927_4,
    ]);
    let by_inputs = SMatrix::<f64, 4, 2>::from_row_slice(&[
        1.865_926_882_932_47,
        7.029_044_304_231_93e-8,
        0.174_889_031_982_847,
        1.007_019_529_347_56e-6,
        54.165_284_248_961_8,
        4.877_937_040_551_88e-6,
        12.409_226_718_554_8,
        3.214_016_078_190_78e-5,
    ]);
    assert_relative_eq!(sampled.a, known, max_relative = 1e-13);
    assert_relative_eq!(sampled.b, by_inputs, max_relative = 1e-13);
}

#[test]
fn held_inputs_move_the_state_as_the_integration_does() {
    let a = SMatrix::<f64, 3, 3>::new(0.1, 2.0, 0.3, -1.0, -0.4, 0.5, 0.7, 0.2, 0.6);
    let b = SMatrix::<f64, 3, 2>::new(1.0, 0.0, -0.5, 2.0, 0.3, 0.4);
    let mut model = StateSpace::new(a, b);
    model.drift = SVector::from([0.3, -0.2, 0.1]);
    let (x, u) = (SVector::from([0.4, -0.3, 0.2]), SVector::from([0.7, -1.1]));
    let drift = model.drift;
    let motion = FnSystem(move |_t: f64, x: &SVector<f64, 3>| a * x + b * u + drift);
    let method = Tsit5::new().rtol(1e-12).atol(1e-12);
    let end = method.solve(&motion, 0.0, 0.8, x).expect("linear").end();
    let sampled = model.discretize(0.8).expect("finite");
    let next = sampled.a * x + sampled.b * u + sampled.drift;
    assert_relative_eq!(next, end, epsilon = 1e-10);
}
