//! # Tumbling handle
//!
//! A T-handle that floats in space and spins about its stem flips over, again and again: of its three moments of
//! inertia, the one about the stem is the intermediate one (tennis racket theorem). The time between two flips has a
//! closed form.

use nalgebra::Vector3;
use pendulum_core::prelude::*;

use crate::{Check, Run, jacobian_by_differences, larger, orientation};

mechanism! {
    /// A stem on the middle of a bar, without gravity.
    pub TumblingBody {
        body handle on ground {
            solids: [cylinder(0.1, 0.01, [0, 0, 0], [0.08, 0, 0]), cylinder(0.3, 0.01, [0, -0.1, 0], [0, 0.1, 0])],
            joint: free, orientation: o, position: p,
        }
        point tip on handle at [0.08, 0, 0],
        output tip: tip,
        event turns: dot(o).x,
        generate: [rhs, jacobian, energy, shapes],
    }
}

/// Masses of the stem and of the bar, in kg.
const MASSES: [f64; 2] = [0.1, 0.3];
/// Lengths of the stem and of the bar, in m.
const LENGTHS: [f64; 2] = [0.08, 0.2];
/// Radius of both, in m.
const RADIUS: f64 = 0.01;
/// Position of the centre of mass along the stem, in m.
const CENTRE: f64 = 0.01;

/// Moments of inertia about the centre of mass.
fn inertia() -> Vector3<f64> {
    let along = MASSES.map(|m| m * RADIUS.powi(2) / 2.0);
    let across = [0, 1].map(|k| MASSES[k] * (3.0 * RADIUS.powi(2) + LENGTHS[k].powi(2)) / 12.0);
    let off = MASSES[0] * (LENGTHS[0] / 2.0 - CENTRE).powi(2) + MASSES[1] * CENTRE.powi(2);
    Vector3::new(
        along[0] + across[1],
        across[0] + along[1] + off,
        across[0] + across[1] + off,
    )
}

/// Half of the period of the rate about the intermediate axis: `2 K` in the units of Landau and Lifshitz, Mechanics,
/// §37, for moments of inertia and rates along the axes in ascending order of the moments.
fn between_turns(inertia: [f64; 3], rates: [f64; 3]) -> f64 {
    // M^2 - 2 E I
    let beyond = |moment: f64| -> f64 {
        let terms = inertia.iter().zip(rates);
        terms.map(|(i, rate)| i * (i - moment) * rate * rate).sum()
    };
    let [mut least, middle, mut most] = inertia;
    if beyond(middle) < 0.0 {
        (least, most) = (most, least);
    }
    let pace = (most - middle) * beyond(least);
    // 1 - k^2, without the difference
    let complement = (most - least) * beyond(middle) / pace;
    let (mut a, mut b) = (1.0, complement.sqrt());
    while (a - b).abs() > 1e-15 * a {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    // K = pi / (2 a)
    std::f64::consts::PI / a * (least * middle * most / pace).sqrt()
}

/// Checks the conserved quantities, the straight path of the centre of mass, the time between two flips against its
/// closed form, and the Jacobian.
pub fn run() -> Result<Run, Box<dyn std::error::Error>> {
    let model = TumblingBody::new(TumblingBodyParams {})?;
    let (inertia, centre) = (inertia(), Vector3::new(CENTRE, 0.0, 0.0));
    let (rates, drift) = (Vector3::new(12.0, 0.05, 0.1), Vector3::new(0.18, 0.0, 0.0));
    // the stem points upward, along y
    let half = std::f64::consts::FRAC_1_SQRT_2;
    let mut start = SVector::from([0.0; 13]);
    (start[TumblingBody::O], start[TumblingBody::O + 3]) = (half, half);
    let turned = orientation(&start, TumblingBody::O);
    let velocity = drift - turned * rates.cross(&centre);
    start.fixed_rows_mut::<3>(TumblingBody::DOT_P_X).copy_from(&velocity);
    start.fixed_rows_mut::<3>(TumblingBody::DOT_O).copy_from(&rates);
    let solution = Vern9::new()
        .rtol(1e-13)
        .atol(1e-13)
        .solve_with(&model, 0.0, 5.36, start, &[model.turns_event()])?;
    let spin = |x: &SVector<f64, 13>| {
        let rates: Vector3<f64> = x.fixed_rows::<3>(TumblingBody::DOT_O).into_owned();
        orientation(x, TumblingBody::O) * inertia.component_mul(&rates)
    };
    let middle = |x: &SVector<f64, 13>| {
        let place: Vector3<f64> = x.fixed_rows::<3>(TumblingBody::P_X).into_owned();
        place + orientation(x, TumblingBody::O) * centre
    };
    let (mut energy, mut angular, mut off) = (0.0, 0.0, 0.0);
    let known = inertia.dot(&rates.component_mul(&rates)) / 2.0 + 0.4 * drift.norm_squared() / 2.0;
    for (t, x) in solution.points() {
        energy = larger(energy, (model.energy(t, x) / known - 1.0).abs());
        angular = larger(angular, (spin(x) - spin(&start)).norm() / spin(&start).norm());
        off = larger(off, (middle(x) - middle(&start) - t * drift).norm());
    }
    let times: Vec<f64> = solution.events().iter().map(|event| event.t).collect();
    let passed: Vec<f64> = times.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let closed = between_turns([inertia.y, inertia.x, inertia.z], [rates.y, rates.x, rates.z]);
    let checks = vec![
        Check::new("energy, in its value by hand", energy, 0.0, 1e-12),
        Check::new("angular momentum in space, in its length", angular, 0.0, 1e-12),
        Check::new("centre of mass off its straight way, in m", off, 0.0, 1e-13),
        Check::new("turns", times.len() as f64, 4.0, 0.0),
        Check::same("times between turns, in s", &passed, &[closed; 3], 1e-10),
        jacobian_by_differences(&model, 0.0, start.into()),
    ];
    Run::new(
        checks,
        model,
        solution,
        |_, _| Vec::new(),
        // a quarter of the motion is little more than a turn: the stem points alternately up and down, and the bar
        // across the view
        |drawing| drawing.seen_from([0.15, 0.35, 1.0], [0.0, 1.0, 0.0]).ghosts(4),
    )
}
