//! Eq. 20 and 22, compared with the generated model and with conservation of energy.

use nalgebra::{SVector, Vector2};
use pendulum_core::prelude::*;

use super::units::{OTHER, apart};
use testbed::printed::Pendulum;
use testbed::random::Random;
use testbed::scenes::{DoublePendulum, DoublePendulumParams};

const SAMPLES: usize = 1000;

fn random_state(random: &mut Random) -> SVector<f64, 4> {
    SVector::from([3.2, 3.2, 5.0, 5.0].map(|most| random.between(-most, most)))
}

/// A pendulum with random parameters, and its generated model with the centres of mass at `c`, where `c_over_d` is c /
/// d.
fn random_pendulum(random: &mut Random, c_over_d: f64) -> (Pendulum, DoublePendulum) {
    let p = Pendulum {
        m: random.between(0.2, 3.0),
        inertia: random.between(0.05, 2.0),
        d: random.between(0.2, 1.5),
        g: random.between(1.0, 20.0),
        gamma1: random.between(0.0, 2.0),
        gamma2: random.between(0.0, 2.0),
    };
    let Pendulum {
        m,
        inertia,
        d,
        g,
        gamma1,
        gamma2,
    } = p;
    let c = c_over_d * d;
    let params = DoublePendulumParams {
        m,
        inertia,
        c,
        d,
        g,
        gamma1,
        gamma2,
    };
    (p, DoublePendulum::new(params).expect("physical"))
}

fn free() -> DoublePendulum {
    let params = DoublePendulumParams {
        gamma1: 0.0,
        gamma2: 0.0,
        ..Default::default()
    };
    DoublePendulum::new(params).expect("physical")
}

/// Largest decrease and increase of the energy from its initial value within 20 s without friction, in joules, after a
/// release at rest at the given angles.
fn energy_drift(system: &impl System<f64, 4>, [theta1, theta2]: [f64; 2]) -> [f64; 2] {
    let model = free();
    let solution = Vern9::new()
        .rtol(1e-12)
        .atol(1e-12)
        .solve(system, 0.0, 20.0, [theta1, theta2, 0.0, 0.0]);
    let solution = solution.expect("regular");
    let energy = |x: &SVector<f64, 4>| model.energy(0.0, x);
    let first = energy(&solution.x()[0]);
    let drift = |[low, high]: [f64; 2], x| [low.min(energy(x) - first), high.max(energy(x) - first)];
    solution.x().iter().fold([0.0, 0.0], drift)
}

fn assert_conserves([low, high]: [f64; 2]) {
    assert!(
        high - low < 1e-9,
        "the right equation drifts from {low:e} to {high:e} J"
    );
}

#[test]
fn eq_20_squares_the_rates() {
    let mut random = Random::new(1);
    let (mut right, mut printed) = (0.0_f64, 0.0_f64);
    for _ in 0..SAMPLES {
        let (p, _) = random_pendulum(&mut random, 1.0);
        let x = random_state(&mut random);
        let (other, there) = (OTHER.pendulum(&p), OTHER.state(&x));
        right = right.max(apart(&other.eq22(&there), &OTHER.rate(&p.eq22(&x))));
        printed = printed.max(apart(&other.eq20_printed(&there), &OTHER.rate(&p.eq20_printed(&x))));
    }
    println!("Eq. 20: after a change of units squared {right:.1e}, printed up to {printed:.2} of the largest rate");
    assert!(right < 1e-12);
    assert!(printed > 0.1);

    let paper = Pendulum::paper(0.0, 0.0);
    let printed = FnSystem(|_t, x: &SVector<f64, 4>| paper.eq20_printed(x));
    let start = [1.2, -0.6];
    let (right, [low, high]) = (energy_drift(&free(), start), energy_drift(&printed, start));
    println!(
        "Eq. 20: energy in 20 s from {start:?} right within {:.0e} J, printed {low:.3} to {high:+.3} J",
        right[1] - right[0]
    );
    assert_conserves(right);
    assert!(high - low > 1.0);
}

/// Eq. 20 and 22 have a single length. They are correct for `c = d`, and for no other `c`.
#[test]
fn eq_22_holds_for_c_equal_to_d() {
    let mut random = Random::new(2);
    for (c_over_d, holds) in [(1.0, true), (0.5, false), (0.9, false), (1.1, false)] {
        let mut errors = Vec::new();
        for _ in 0..SAMPLES {
            let (p, model) = random_pendulum(&mut random, c_over_d);
            let x = random_state(&mut random);
            errors.push(apart(&p.eq22(&x), &model.rhs(0.0, &x)));
        }
        errors.sort_by(f64::total_cmp);
        let (median, largest) = (errors[SAMPLES / 2], errors[SAMPLES - 1]);
        println!("Eq. 22 at c = {c_over_d} d: error {median:.1e} in the median, {largest:.1e} at most");
        if holds {
            assert!(largest < 1e-12);
        } else {
            assert!(median > 0.01);
        }
    }
}

/// The generated motion does not satisfy the printed second line; the residual is the misprint, to the last digits.
#[test]
fn eq_22b_has_the_rate_of_the_other_plate() {
    let mut random = Random::new(3);
    let (mut difference, mut largest) = (0.0_f64, 0.0_f64);
    for _ in 0..SAMPLES {
        let (p, model) = random_pendulum(&mut random, 1.0);
        let x = random_state(&mut random);
        let rate = model.rhs(0.0, &x);
        let residual = p.eq22b_printed_residual(&x, Vector2::new(rate[2], rate[3]));
        let slip = p.m * p.d * p.d * (x[2] * x[2] - x[3] * x[3]) * (x[0] - x[1]).sin();
        let scale = p.m * p.d * p.d * 50.0 + 2.0 * p.m * p.g * p.d;
        difference = difference.max((residual - Vector2::new(0.0, slip)).amax() / scale);
        largest = largest.max(slip.abs() / scale);
        assert!(apart(&p.eq22(&x), &rate) < 1e-12);
    }
    println!("Eq. 22b: residual less m d^2 (w1^2 - w2^2) sin(th1 - th2) {difference:.1e}, itself up to {largest:.2}");
    assert!(difference < 1e-13);
    assert!(largest > 0.1);
}

/// The effect of the misprint changes sign with the direction of motion: from one initial condition the energy
/// decreases, from another it increases.
#[test]
fn eq_22b_as_printed_does_not_conserve_energy() {
    let paper = Pendulum::paper(0.0, 0.0);
    let printed = FnSystem(|_t, x: &SVector<f64, 4>| paper.eq22b_printed(x));
    for (start, falls, rises) in [([1.2, -0.6], 1.0, 0.0), ([0.5, 2.0], 0.0, 10.0)] {
        let (right, [low, high]) = (energy_drift(&free(), start), energy_drift(&printed, start));
        println!(
            "Eq. 22b: energy in 20 s from {start:?} right within {:.0e} J, printed {low:.3} to {high:+.3} J",
            right[1] - right[0]
        );
        assert_conserves(right);
        assert!(low <= -falls && high >= rises);
    }
}
