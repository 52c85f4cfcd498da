//! # Thrown die
//!
//! A die thrown onto a smooth table, with a wall for each corner. It bounces from corner to corner and slides on, flat
//! on one of its faces. The table changes neither its velocity along the table nor its spin about the normal.

use nalgebra::Vector3;
use pendulum_core::prelude::*;

use crate::{Check, Run, larger, orientation};

mechanism! {
    /// A die whose edges have the length `2 b`.
    pub ThrownDie {
        params { b: m = 0.01, e: 1 = 0.6 }
        gravity: [0, 0, -9.81],
        body die on ground {
            solids: [cuboid(0.01, [2*b, 2*b, 2*b], [0, 0, 0])], joint: free, orientation: o, position: p,
        }
        point c1 on die at [b, b, b], point c2 on die at [-b, b, b],
        point c3 on die at [b, -b, b], point c4 on die at [-b, -b, b],
        point c5 on die at [b, b, -b], point c6 on die at [-b, b, -b],
        point c7 on die at [b, -b, -b], point c8 on die at [-b, -b, -b],
        wall at_c1 { gap: c1.z, restitution: e }
        wall at_c2 { gap: c2.z, restitution: e }
        wall at_c3 { gap: c3.z, restitution: e }
        wall at_c4 { gap: c4.z, restitution: e }
        wall at_c5 { gap: c5.z, restitution: e }
        wall at_c6 { gap: c6.z, restitution: e }
        wall at_c7 { gap: c7.z, restitution: e }
        wall at_c8 { gap: c8.z, restitution: e }
        generate: [rhs, energy, shapes],
    }
}

/// Checks the impacts on one corner against their closed form, the conserved quantities, and the state of rest.
///
/// A corner at `r` from the centre hits the table with the rate `v`. With the normal `n`, the mass `m` and the moment
/// of inertia `I`, which a cube has about every axis, the impulse is `P = -(1 + e) v / (1/m + |r x n|^2 / I)`. The
/// velocity changes by `P n / m`, and the angular velocity by `P r x n / I`.
pub fn run() -> Result<Run, Box<dyn std::error::Error>> {
    let ThrownDieParams { b, e } = ThrownDieParams::default();
    let (model, m, normal) = (ThrownDie::new(ThrownDieParams { b, e })?, 0.01, Vector3::z());
    let inertia = 2.0 / 3.0 * m * b * b;
    let start = [0.0, 0.0, 0.08, 0.8, 0.36, 0.0, 0.48, 0.3, 0.0, -0.5, 20.0, -15.0, 5.0];
    let end = 0.6;
    let solution = Vern9::new().rtol(1e-12).atol(1e-12).solve(&model, 0.0, end, start)?;
    let velocity = |x: &SVector<f64, 13>| Vector3::from(x.fixed_rows::<3>(ThrownDie::DOT_P_X));
    let spin = |x: &SVector<f64, 13>| orientation(x, ThrownDie::O) * Vector3::from(x.fixed_rows::<3>(ThrownDie::DOT_O));
    let (mut error, mut alone) = (0.0, 0);
    for impact in solution.impacts() {
        let mut pushes = impact.pushes();
        let (Some((corner, impulse)), None) = (pushes.next(), pushes.next()) else {
            continue;
        };
        let (before, after) = (&impact.before, &impact.after);
        let sign = |bit: usize| if corner & bit == 0 { b } else { -b };
        let arm = orientation(before, ThrownDie::O) * Vector3::new(sign(1), sign(2), sign(4));
        let lever = arm.cross(&normal);
        let rate = velocity(before).z + spin(before).dot(&lever);
        // the lowest rebounds end at once
        if rate.abs() < 1e-3 {
            continue;
        }
        let known = -(1.0 + e) * rate / (1.0 / m + lever.norm_squared() / inertia);
        error = larger(error, (impulse - known).abs() / m);
        error = larger(error, (velocity(after) - velocity(before) - known / m * normal).norm());
        error = larger(error, b * (spin(after) - spin(before) - known / inertia * lever).norm());
        alone += 1;
    }
    let (mut along, mut about, mut low, mut length, mut gained) = (0.0, 0.0, 0.0, 0.0, 0.0);
    let first = SVector::from(start);
    let mut energy = model.energy(0.0, &first);
    let whole = energy;
    for (t, x) in solution.points() {
        along = larger(along, (velocity(x) - velocity(&first)).xy().norm());
        about = larger(about, (spin(x).z - spin(&first).z).abs());
        let gaps = model.measures(t, x).map(|[gap, _]| -gap);
        low = larger(low, gaps.into_iter().fold(0.0, f64::max));
        length = larger(length, (x.fixed_rows::<4>(ThrownDie::O).norm() - 1.0).abs());
        let now = model.energy(t, x);
        gained = larger(gained, (now - energy) / whole);
        energy = now;
    }
    let x = solution.end();
    let gaps = model.measures(end, &x).into_iter().map(|[gap, _]| gap);
    let touching = gaps.filter(|gap| gap.abs() < 1e-13).count();
    let turning = spin(&x);
    let checks = vec![
        Check::new("impacts on one corner, in m/s", error, 0.0, 1e-11),
        Check::new(
            "more than 10 of them (1: yes)",
            f64::from(u8::from(alone > 10)),
            1.0,
            0.0,
        ),
        Check::new("velocity along the table, in m/s", along, 0.0, 1e-12),
        Check::new("spin about the normal, in rad/s", about, 0.0, 1e-9),
        Check::new("a corner in the table, in m", low, 0.0, 1e-13),
        Check::new("length of the quaternion", length, 0.0, 1e-15),
        Check::new("gain of energy, in the energy at the start", gained, 0.0, 1e-12),
        Check::new("corners on the table at the end", touching as f64, 4.0, 0.0),
        Check::same(
            "height in m, and rates off the table at the end",
            &[x[ThrownDie::P_X + 2], velocity(&x).z, b * turning.x, b * turning.y],
            &[b, 0.0, 0.0, 0.0],
            1e-13,
        ),
    ];
    Run::new(
        checks,
        model,
        solution,
        |_, _| Vec::new(),
        |drawing| drawing.seen_from([0.4, -1.0, 0.45], [0.0, 0.0, 1.0]).ghosts(6),
    )
}
