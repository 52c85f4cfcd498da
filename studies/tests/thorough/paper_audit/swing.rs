//! Section 4, Fig. 2 and the abstract: at 4 degrees the motion is the sum of two damped modes, neither in phase nor
//! chaotic nor periodic.

use nalgebra::SVector;
use pendulum_core::method::{Explicit, Fixed};
use pendulum_core::prelude::*;
use pendulum_core::stability::{Lyapunov, equilibrium};
use pendulum_core::tableau::DormandPrince5;

use testbed::fit::{ModalFit, eigenvalues_of, fit};
use testbed::printed::Pendulum;
use testbed::random::Random;
use testbed::scenes::{DoublePendulum, double_pendulum};

/// Frictions of Fig. 2, in N m s.
const FRICTIONS: [f64; 3] = [0.1, 0.4, 1.0];
/// End time of Fig. 2, in s.
const END: f64 = 20.0;
/// Initial angle of the lower plate, in degrees; the upper one hangs, and both are at rest.
const AMPLITUDE: f64 = 4.0;

type Samples = Vec<(f64, SVector<f64, 4>)>;

/// Initial condition at rest with the upper plate hanging.
fn start(degrees: f64) -> SVector<f64, 4> {
    SVector::from([0.0, degrees.to_radians(), 0.0, 0.0])
}

fn samples(system: &impl System<f64, 4>, degrees: f64) -> Samples {
    samples_from(system, start(degrees))
}

fn samples_from(system: &impl System<f64, 4>, start: SVector<f64, 4>) -> Samples {
    let method = Vern9::new().rtol(1e-12).atol(1e-14);
    let solution = method.solve(system, 0.0, END, start).expect("regular");
    let times = (0..=200).map(|n| END * f64::from(n) / 200.0);
    times.map(|t| (t, solution.at(t).expect("within the span"))).collect()
}

fn modes(gamma: f64, samples: &Samples) -> ModalFit {
    let rest = equilibrium(&double_pendulum(gamma), SVector::zeros()).expect("it hangs");
    fit(&rest.spectrum, samples)
}

/// The residual of the fit by two modes is of third order in the angles, so it decreases with the third power of the
/// amplitude.
#[test]
fn fig_2_is_two_damped_modes() {
    for gamma in FRICTIONS {
        let residual = |degrees: f64| {
            let samples = samples(&double_pendulum(gamma), degrees);
            modes(gamma, &samples).residual(&samples).to_degrees()
        };
        let (one, four) = (residual(0.25 * AMPLITUDE), residual(AMPLITUDE));
        let power = (four / one).log(4.0);
        println!(
            "Fig. 2, gamma {gamma}: two modes leave {four:.5} of {AMPLITUDE} degrees; at 1 degree {one:.2e}: power \
             {power:.3}"
        );
        assert!(four < 0.01 * AMPLITUDE);
        assert!((power - 3.0).abs() < 0.05);
    }
}

/// The eigenvalues of the motion of Fig. 2 equal those of the linearisation, up to terms of second order in the
/// amplitude.
#[test]
fn fig_2_has_the_eigenvalues_of_the_jacobian() {
    for gamma in FRICTIONS {
        let error = |degrees: f64| {
            let samples = samples(&double_pendulum(gamma), degrees);
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
            "Fig. 2, gamma {gamma}: eigenvalues of the motion differ by {four:.1e} 1/s; power of the amplitude \
             {power:.3}"
        );
        assert!(four < 5e-3);
        assert!((power - 2.0).abs() < 0.05);
    }
}

/// The misprint of Eq. 22b is also of third order in the amplitude: Fig. 2 looks the same with and without it.
#[test]
fn fig_2_hardly_depends_on_eq_22b() {
    for gamma in FRICTIONS {
        let paper = Pendulum::paper(gamma, gamma);
        let printed = FnSystem(|_t, x: &SVector<f64, 4>| paper.eq22b_printed(x));
        let (right, printed) = (
            samples(&double_pendulum(gamma), AMPLITUDE),
            samples(&printed, AMPLITUDE),
        );
        let apart = right
            .iter()
            .zip(&printed)
            .map(|((_, a), (_, b))| (a - b).fixed_rows::<2>(0).amax());
        let apart = apart.fold(0.0, f64::max).to_degrees();
        println!("Fig. 2, gamma {gamma}: Eq. 22b as printed moves the angles by {apart:.5} degrees at most");
        assert!(apart > 0.0 && apart < 0.01 * AMPLITUDE);
    }
}

/// With friction, neighbouring motions converge, in the long run at the decay rate of the slowest mode.
///
/// Within a swing of that mode, of frequency `w` in rad/s, the length of a tangent (in rad and rad/s) varies by a
/// factor of `w`. This leaves an uncertainty of `ln(w) / t` in the mean growth rate over a time `t`.
#[test]
fn fig_2_is_not_chaotic() {
    for gamma in FRICTIONS {
        let model = double_pendulum(gamma);
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

/// In regular motion, neighbours separate in proportion to time: four times as far in four times the time. Within a
/// swing of frequency `w` their distance varies by a factor of `w`, at most 3.2 in small swings. In chaos they separate
/// exponentially. `examples/paper_audit` covers the amplitudes in between.
#[test]
fn without_friction_only_the_largest_swings_are_chaotic() {
    let model = double_pendulum(0.0);
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
            "Section 4, no friction, {degrees} degrees: {value:.5} +- {uncertainty:.5} 1/s; from 150 to 600 s grown by \
             exp({grown:.2})"
        );
        if chaotic {
            assert!(value > 0.04 && value > 4.0 * uncertainty && grown > 15.0);
        } else {
            assert!(value < 3.0 * uncertainty && grown < (4.0 * 3.2_f64).ln());
        }
    }
}

/// After a release at the same angle both modes swing, since the slow mode has twice the angle at the lower plate: the
/// difference of the angles exceeds each of them, and they have opposite signs.
#[test]
fn released_at_the_same_angle_plates_do_not_stay_in_phase() {
    let angle = AMPLITUDE.to_radians();
    let samples = samples_from(&double_pendulum(0.1), SVector::from([angle, angle, 0.0, 0.0]));
    let most = |value: fn(&SVector<f64, 4>) -> f64| samples.iter().map(|(_, x)| value(x)).fold(0.0, f64::max);
    let difference = most(|x| (x[0] - x[1]).abs()).to_degrees();
    // the smaller of two angles with opposite signs
    let opposite = most(|x| {
        if x[0] * x[1] < 0.0 {
            x[0].abs().min(x[1].abs())
        } else {
            0.0
        }
    })
    .to_degrees();
    println!("Section 4, from 4, 4 degrees: angles differ by {difference:.2} degrees, are opposite by {opposite:.2}");
    assert!((difference - 4.6).abs() < 0.05);
    assert!(opposite > 0.9);
}

/// Order of convergence of the error after 20 s, for a swing large enough to excite all its terms.
fn order<M: Method<DoublePendulum, f64, 4>>(method: fn(f64) -> M, exact: &SVector<f64, 4>) -> f64 {
    let [long, short] = [0.04, 0.02].map(|h| {
        let solution = method(h)
            .solve(&double_pendulum(0.1), 0.0, END, start(60.0))
            .expect("regular");
        (solution.end() - exact).norm()
    });
    (long / short).log2()
}

/// ode45 is the pair 5(4) of Dormand and Prince (L. F. Shampine, M. W. Reichelt, "The MATLAB ODE suite", SIAM J. Sci.
/// Comput. 18 (1997) 1-22). Halving the step divides its error by 32, and the error of the fourth-order Runge-Kutta
/// method by 16.
#[test]
fn ode45_is_no_fourth_order_runge_kutta_method() {
    let (_, exact) = samples(&double_pendulum(0.1), 60.0)[200];
    let dormand_prince = order(Fixed::<Explicit<DormandPrince5, 7>>::new, &exact);
    let runge_kutta = order(Rk4::new, &exact);
    println!("Section 4: order of the method of ode45 {dormand_prince:.2}, of Runge and Kutta {runge_kutta:.2}");
    assert!((dormand_prince - 5.0).abs() < 0.2);
    assert!((runge_kutta - 4.0).abs() < 0.2);
}

/// The energy decreases at the rate `gamma1 omega1^2 + gamma2 (omega1 - omega2)^2`, which is positive unless both
/// plates are at rest. A periodic motion would return to its initial energy.
#[test]
fn no_damped_motion_is_periodic() {
    let mut random = Random::new(6);
    let (mut error, mut largest) = (0.0_f64, 0.0_f64);
    for gamma in [1e-3, 0.1, 0.4, 1.0] {
        let model = double_pendulum(gamma);
        for _ in 0..1000 {
            let x = SVector::from([3.2, 3.2, 5.0, 5.0].map(|most| random.between(-most, most)));
            let rate = model.rhs(0.0, &x);
            let reach = 1e-5;
            let [before, after] = [-reach, reach].map(|reach| model.energy(0.0, &(x + reach * rate)));
            let power = gamma * (x[2] * x[2] + (x[2] - x[3]) * (x[2] - x[3]));
            error = error.max(((before - after) / (2.0 * reach) - power).abs());
            largest = largest.max(power);
        }
        for degrees in [AMPLITUDE, 168.0] {
            let energies: Vec<f64> = samples(&model, degrees)
                .iter()
                .map(|(_, x)| model.energy(0.0, x))
                .collect();
            assert!(
                energies.windows(2).all(|pair| pair[1] < pair[0]),
                "gamma {gamma} from {degrees} degrees"
            );
        }
    }
    println!("Abstract: the energy falls by the power of friction, {error:.1e} of up to {largest:.0} W");
    assert!(error < 1e-7 * largest);
}
