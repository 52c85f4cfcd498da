//! Section 4 and Fig. 2: at 4 degrees the motion is the sum of two damped modes, and not chaotic.

use nalgebra::SVector;
use pendulum_core::prelude::*;
use pendulum_core::stability::{Lyapunov, equilibrium};

use testbed::fit::{ModalFit, eigenvalues_of, fit};
use testbed::printed::Pendulum;
use testbed::scenes::{DoublePendulum, DoublePendulumParams};

/// The frictions of Fig. 2, in N m s, and its end, in s.
const FRICTIONS: [f64; 3] = [0.1, 0.4, 1.0];
const END: f64 = 20.0;
/// Of the lower plate, in degrees; the upper one hangs, and both are at rest.
const AMPLITUDE: f64 = 4.0;

type Samples = Vec<(f64, SVector<f64, 4>)>;

fn model(gamma: f64) -> DoublePendulum {
    let params = DoublePendulumParams {
        gamma1: gamma,
        gamma2: gamma,
        ..Default::default()
    };
    DoublePendulum::new(params).expect("physical")
}

fn start(degrees: f64) -> SVector<f64, 4> {
    SVector::from([0.0, degrees.to_radians(), 0.0, 0.0])
}

fn samples(system: &impl System<f64, 4>, degrees: f64) -> Samples {
    let method = Vern9::new().rtol(1e-12).atol(1e-14);
    let solution = method.solve(system, 0.0, END, start(degrees)).expect("regular");
    let times = (0..=200).map(|n| END * f64::from(n) / 200.0);
    times.map(|t| (t, solution.at(t).expect("within the span"))).collect()
}

fn modes(gamma: f64, samples: &Samples) -> ModalFit {
    let rest = equilibrium(&model(gamma), SVector::zeros()).expect("it hangs");
    fit(&rest.spectrum, samples)
}

/// What two modes leave of the angles comes from the third power of these, so it falls with the third power of the amplitude.
#[test]
fn fig_2_is_two_damped_modes() {
    for gamma in FRICTIONS {
        let residual = |degrees: f64| {
            let samples = samples(&model(gamma), degrees);
            modes(gamma, &samples).residual(&samples).to_degrees()
        };
        let (one, four) = (residual(0.25 * AMPLITUDE), residual(AMPLITUDE));
        let power = (four / one).log(4.0);
        println!(
            "Fig. 2, gamma {gamma}: two modes leave {four:.5} of {AMPLITUDE} degrees; at 1 degree {one:.2e}: power {power:.3}"
        );
        assert!(four < 0.01 * AMPLITUDE);
        assert!((power - 3.0).abs() < 0.05);
    }
}

/// The motion of Fig. 2 has the eigenvalues of the linearisation, but for the square of the amplitude.
#[test]
fn fig_2_has_the_eigenvalues_of_the_jacobian() {
    for gamma in FRICTIONS {
        let error = |degrees: f64| {
            let samples = samples(&model(gamma), degrees);
            let seen = eigenvalues_of(&samples).expect("two modes");
            let modes = modes(gamma, &samples).modes;
            assert_eq!((seen.len(), modes.len()), (2, 2));
            let apart = seen
                .iter()
                .zip(&modes)
                .map(|(seen, mode)| (seen - mode.eigenvalue).norm());
            apart.fold(0.0, f64::max)
        };
        let (one, four) = (error(0.25 * AMPLITUDE), error(AMPLITUDE));
        let power = (four / one).log(4.0);
        println!(
            "Fig. 2, gamma {gamma}: eigenvalues of the motion differ by {four:.1e} 1/s; power of the amplitude {power:.3}"
        );
        assert!(four < 5e-3);
        assert!((power - 2.0).abs() < 0.05);
    }
}

/// The slip of Eq. 22b is of the third power of the amplitude too: Fig. 2 looks the same with and without it.
#[test]
fn fig_2_hardly_depends_on_eq_22b() {
    for gamma in FRICTIONS {
        let paper = Pendulum::paper(gamma, gamma);
        let printed = FnSystem(|_t, x: &SVector<f64, 4>| paper.eq22b_printed(x));
        let (right, printed) = (samples(&model(gamma), AMPLITUDE), samples(&printed, AMPLITUDE));
        let apart = right
            .iter()
            .zip(&printed)
            .map(|((_, a), (_, b))| (a - b).fixed_rows::<2>(0).amax());
        let apart = apart.fold(0.0, f64::max).to_degrees();
        println!("Fig. 2, gamma {gamma}: Eq. 22b as printed moves the angles by {apart:.5} degrees at most");
        assert!(apart > 0.0 && apart < 0.01 * AMPLITUDE);
    }
}

/// With friction neighbouring motions come together, at last as slowly as the slowest mode decays.
///
/// Within a swing of that mode, of frequency `w` in rad/s, the length of a tangent (in rad and rad/s) goes through a factor of `w`. Its
/// mean growth rate over a time `t` is open by `ln(w) / t` for that reason.
#[test]
fn fig_2_is_not_chaotic() {
    for gamma in FRICTIONS {
        let model = model(gamma);
        let exponent = Lyapunov::new()
            .transient(200.0)
            .duration(2000.0)
            .largest(&model, start(AMPLITUDE));
        let exponent = exponent.expect("regular").values[0];
        let rest = equilibrium(&model, SVector::zeros()).expect("it hangs");
        let slowest = &rest.spectrum.modes()[0];
        let open = slowest.angular_frequency().ln() / 2000.0;
        println!(
            "Section 4, gamma {gamma}: exponent {exponent:.5} +- {open:.5} 1/s, slowest mode {:.5}",
            slowest.growth_rate()
        );
        assert!((exponent - slowest.growth_rate()).abs() < 1.1 * open);
        assert!(exponent + 2.0 * open < 0.0);
    }
}

/// In regular motion neighbours part in proportion to time, four times as far in four times the time, while within a swing of frequency `w` their
/// distance goes through a factor of `w`, at most 3.2 in small swings. In chaos they part exponentially. `examples/paper_audit` looks between these amplitudes.
#[test]
fn without_friction_only_the_largest_swings_are_chaotic() {
    let model = model(0.0);
    for (degrees, chaotic) in [
        (AMPLITUDE, false),
        (45.0, false),
        (90.0, false),
        (150.0, false),
        (168.0, true),
    ] {
        let [early, late] = [150.0, 600.0].map(|duration| {
            let exponent = Lyapunov::new().tolerance(1e-9).duration(duration);
            exponent.largest(&model, start(degrees)).expect("regular")
        });
        let (value, uncertainty) = (late.values[0], late.uncertainty[0]);
        let grown = 600.0 * value - 150.0 * early.values[0];
        println!(
            "Section 4, no friction, {degrees} degrees: {value:.5} +- {uncertainty:.5} 1/s; from 150 to 600 s grown by exp({grown:.2})"
        );
        if chaotic {
            assert!(value > 0.04 && value > 4.0 * uncertainty && grown > 15.0);
        } else {
            assert!(value < 3.0 * uncertainty && grown < (4.0 * 3.2_f64).ln());
        }
    }
}
