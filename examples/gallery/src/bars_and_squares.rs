//! # Double bar and double square
//!
//! Two equal rods end to end, and two equal square plates that hang by opposite corners (reference 6). Inertia follows
//! from the solids.

use pendulum_core::prelude::*;

use crate::{Check, Run, frequencies, two_modes};

mechanism! {
    /// Two equal rods.
    pub DoubleBar {
        params { m: kg = 0.8, l: m = 0.6, g: m/s^2 = 9.81 }
        gravity: [0, -g, 0],
        shape bar { solids: [rod(m, [0, 0, 0], [0, -l, 0])] }
        body upper on ground: bar { joint: revolute(z), coordinate: theta1 absolute }
        body lower on upper: bar { joint: revolute(z) at [0, -l, 0], coordinate: theta2 absolute }
        generate: [rhs, jacobian, mass_matrix],
    }
}

mechanism! {
    /// Two equal squares of side `a`, each hung by a corner, the second from the opposite corner of the first.
    pub DoubleSquare {
        params { m: kg = 0.8, a: m = 0.5, g: m/s^2 = 9.81 }
        gravity: [0, -g, 0],
        let d = a * sqrt(2),
        shape square { solids: [plate(m, [[0, 0], [-d/2, -d/2], [0, -d], [d/2, -d/2]])] }
        body upper on ground: square { joint: revolute(z), coordinate: theta1 absolute }
        body lower on upper: square { joint: revolute(z) at [0, -d, 0], coordinate: theta2 absolute }
        point corner on lower at [0, -d, 0],
        generate: [rhs, jacobian, energy, mass_matrix, shapes],
    }
}

/// Checks inertia and frequencies against closed forms, and the energy.
pub fn run() -> Result<Run, Box<dyn std::error::Error>> {
    let bars = DoubleBar::new(DoubleBarParams::default())?;
    let squares = DoubleSquare::new(DoubleSquareParams::default())?;
    let (m, l, a, g) = (0.8, 0.6, 0.5, 9.81_f64);
    let still = [0.0; 4];
    let of_bars = bars.mass_matrix(0.0, &still);
    // w^2 = (3 -+ 6/sqrt 7) g/l
    let of_bar = [-1.0, 1.0].map(|sign| ((3.0 + sign * 6.0 / 7.0_f64.sqrt()) * g / l).sqrt());
    // a square about its corner: m a^2 (1/6 + 1/2)
    let (about_corner, d) = (m * a * a * 2.0 / 3.0, a * 2.0_f64.sqrt());
    let mass = [
        [about_corner + m * d * d, m * d * d / 2.0],
        [m * d * d / 2.0, about_corner],
    ];
    let weight = [[1.5 * m * d * g, 0.0], [0.0, 0.5 * m * d * g]];
    let of_squares = squares.mass_matrix(0.0, &still);
    let checks = vec![
        Check::new(
            "inertia of both bars, in kg m^2",
            of_bars[(0, 0)],
            4.0 / 3.0 * m * l * l,
            1e-15,
        ),
        Check::same(
            "modes of the bars, in rad/s",
            &frequencies(&bars, [0.0; 4])?,
            &of_bar,
            1e-12,
        ),
        Check::new(
            "inertia of both squares, in kg m^2",
            of_squares[(0, 0)],
            mass[0][0],
            1e-15,
        ),
        Check::same(
            "modes of the squares, in rad/s",
            &frequencies(&squares, [0.0; 4])?,
            &two_modes(mass, weight),
            1e-12,
        ),
    ];
    let solution = Vern9::new()
        .rtol(1e-12)
        .atol(1e-12)
        .solve(&squares, 0.0, 4.0, [1.8, 0.9, 0.0, 0.0])?;
    Run::new(checks, squares, solution, |_, _| vec![], |drawing| drawing)
}
