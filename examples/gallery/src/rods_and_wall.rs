//! # Rods and a wall
//!
//! Two rods swing against a rigid wall, from which elbow and tip rebound with a tenth of their speed (after
//! F. A. Potra, M. Anitescu, B. Gavrea and J. Trinkle 2006). A series of rebounds ends in a contact, which lasts until
//! the wall would have to pull.

use std::f64::consts::PI;

use pendulum_core::prelude::*;

use crate::{Check, Run, impacts, larger};

mechanism! {
    /// Two equal rods, and a wall to the left of both.
    pub RodsAndWall {
        params { m: kg = 1, l: m = 1, e: 1 = 0.1 }
        gravity: [0, -9.81, 0],
        shape arm { solids: [rod(m, [0, 0, 0], [0, -l, 0])] }
        point tip on lower at [0, -l, 0],
        point elbow on upper at [0, -l, 0],
        wall beside_tip { gap: tip.x + 0.1, restitution: e }
        wall beside_elbow { gap: elbow.x + 0.1, restitution: e }
        body upper on ground: arm { joint: revolute(z), coordinate: theta1 }
        body lower on upper: arm { joint: revolute(z) at [0, -l, 0], coordinate: theta2 absolute }
        generate: [rhs, energy, shapes],
    }
}

/// Checks the law of each impact, the gaps, and the energy, which is constant except for losses at impacts.
pub fn run() -> Result<Run, Box<dyn std::error::Error>> {
    const END: f64 = 4.0;
    let params = RodsAndWallParams::default();
    let model = RodsAndWall::new(params)?;
    let start = [PI / 3.0, PI / 5.0, 0.0, 0.0];
    let solution = Vern9::new().rtol(1e-13).atol(1e-13).solve(&model, 0.0, END, start)?;
    let gaps = |t: f64, x: &SVector<f64, 4>| -> [[f64; 2]; 2] { [0, 1].map(|wall| model.measures(t, x)[wall]) };
    let (mut law, mut lost) = (0.0, 0.0);
    for (t, before, after) in impacts(&solution) {
        for ([gap, approach], [_, leave]) in gaps(t, &before).into_iter().zip(gaps(t, &after)) {
            // The last rebound of a series ends in contact.
            if gap < 1e-12 && approach < 0.0 && leave > 0.0 {
                law = larger(law, (leave + params.e * approach).abs());
            }
        }
        lost += model.energy(t, &before) - model.energy(t, &after);
    }
    let energies: Vec<f64> = solution.points().map(|(t, x)| model.energy(t, x)).collect();
    let growth = energies.windows(2).map(|pair| pair[1] - pair[0]).fold(0.0, larger);
    let beyond = |t: f64, x: &SVector<f64, 4>| gaps(t, x).map(|[gap, _]| -gap).into_iter().fold(0.0, larger);
    let at_steps = solution.points().map(|(t, x)| beyond(t, x)).fold(0.0, larger);
    let mut between = 0.0;
    for n in 0..=10_000 {
        let t = END * f64::from(n) / 1e4;
        between = larger(between, beyond(t, &solution.at(t)?));
    }
    let checks = vec![
        Check::new("law of the impacts, in m/s", law, 0.0, 1e-12),
        Check::new("growth of the energy in a step, in J", growth, 0.0, 1e-12),
        Check::new(
            "energy that impacts take, in J",
            lost,
            energies[0] - energies[energies.len() - 1],
            1e-11,
        ),
        Check::new("beyond the wall at any step, in m", at_steps, 0.0, 1e-13),
        Check::new("beyond the wall between steps, in m", between, 0.0, 1e-12),
    ];
    Run::new(
        checks,
        model,
        solution,
        |_, _| Vec::new(),
        |drawing| drawing.wall([-0.1, 0.0, 0.0], [-0.1, -2.1, 0.0]),
    )
}
