//! Section 4 of the paper with numbers: H. Williams, "A compound double pendulum with friction" (2023).
//!
//! `cargo run --release --example paper` declares the pendulum, prints the generated equations beside the paper's Eq.
//! 22, integrates the paper's three cases, compares the final states with reference trajectories, and draws Fig. 2.

mod figure;

use std::error::Error;
use std::path::Path;

use charts::page::Picture;
use pendulum_core::Solution;
use pendulum_core::prelude::*;

mechanism! {
    /// Two identical plates on axles with friction: Williams (2023), Eq. 22.
    DoublePendulum {
        params {
            /// Mass of each plate.
            m: kg = 1.0,
            /// Rotational inertia of each plate about its centre of mass.
            inertia: kg m^2 = 1.0,
            /// Distance from a plate's axle to its centre of mass.
            c: m = 1.0,
            /// Distance between the two axles.
            d: m = 1.0,
            /// Acceleration of gravity.
            g: m/s^2 = 9.8,
            /// Friction of the upper axle.
            gamma1: N m s = 0.1,
            /// Friction of the lower axle.
            gamma2: N m s = 0.1,
        }
        gravity: [0, -g, 0],

        shape plate { mass: m, com: [0, -c, 0], inertia: inertia }

        body upper on ground: plate {
            joint: revolute(z) at [0, 0, 0],
            coordinate: theta1,
            friction: gamma1,
        }
        body lower on upper: plate {
            joint: revolute(z) at [0, -d, 0],
            coordinate: theta2 absolute,
            friction: gamma2,
        }
    }
}

/// End time of the paper's Fig. 2, in seconds.
const T_END: f64 = 20.0;

/// The paper's friction coefficients, in N m s and equal in both joints, each with the final state from
/// `testbed/data/trajectories.json`: extrapolation in 45-digit arithmetic.
const CASES: [(f64, [f64; 4]); 3] = [
    (
        1.0,
        [
            -0.0023460967175107186,
            -0.0028406012575600747,
            -0.011810929987796216,
            -0.02311664090811846,
        ],
    ),
    (
        0.4,
        [
            -0.00462796086200308,
            -0.007393892064396361,
            -0.025597668333579973,
            -0.051479553754473335,
        ],
    ),
    (
        0.1,
        [
            -0.010788488456521843,
            -0.008208154950024884,
            -0.041513966769451745,
            -0.07342803925508985,
        ],
    ),
];

fn main() -> Result<(), Box<dyn Error>> {
    print_equations();
    print_operations();
    println!(
        "From theta1 = 0, theta2 = 4 degrees at rest to t = {T_END} s; gamma in N m s, angles in rad, rates in rad/s"
    );
    println!("error: the largest of the four differences from the reference (45-digit extrapolation)");
    let mut runs = Vec::new();
    for (gamma, end) in CASES {
        runs.push((gamma, run(gamma, &SVector::from(end))?));
    }
    println!("\nFig. 2, drawn from the dense output of Rk45:");
    for path in figure::figure2(&runs, T_END)?.save(Path::new("out/paper/fig2"))? {
        println!("{}", path.display());
    }
    Ok(())
}

/// Eq. 22, corrected: the left sides as in `EQUATIONS`, where `theta'` is written `dot(theta)`.
///
/// The paper prints theta2'^2 in b[theta2]; with that the energy is not conserved at gamma1 = gamma2 = 0.
const EQ_22: [(&str, &str); 7] = [
    ("A[theta1, theta1]", "I + 2 m d^2"),
    ("A[theta1, theta2]", "m d^2 cos(theta1 - theta2)"),
    ("A[theta2, theta2]", "I + m d^2"),
    (
        "b[theta1]",
        "m d^2 theta2'^2 sin(theta1 - theta2) + 2 m g d sin(theta1)",
    ),
    ("b[theta2]", "-m d^2 theta1'^2 sin(theta1 - theta2) + m g d sin(theta2)"),
    ("Q[theta1]", "-gamma1 theta1' - gamma2 (theta1' - theta2')"),
    ("Q[theta2]", "gamma2 (theta1' - theta2')"),
];

/// Prints each generated term with the corresponding term of Eq. 22 below it.
fn print_equations() {
    println!("The generated equations, and below each term that of Williams (2023), Eq. 22, corrected:");
    println!("two identical plates, whose centre of mass is as far from the axle as the other axle, c = d\n");
    for line in DoublePendulum::EQUATIONS.lines() {
        println!("{}", format!("  {line}").trim_end());
        let term = line.split(" = ").next();
        if let Some((term, by_hand)) = EQ_22.iter().find(|(name, _)| Some(*name) == term) {
            println!("  {:>width$} = {by_hand}", "Eq. 22", width = term.len());
        }
    }
    println!("\n  Printed in the paper's b[theta2], but not energy-conserving: theta2'^2 in place of theta1'^2.\n");
}

fn print_operations() {
    println!("Operations of one evaluation");
    println!("  right-hand side  {}", DoublePendulum::COST["rhs"]);
    println!("  state Jacobian   {}\n", DoublePendulum::COST["jacobian"]);
}

/// Integrates the case with the friction `gamma` in both joints with two methods, and prints their errors.
fn run(gamma: f64, reference: &SVector<f64, 4>) -> Result<Solution<f64, 4>, Box<dyn Error>> {
    let params = DoublePendulumParams {
        gamma1: gamma,
        gamma2: gamma,
        ..Default::default()
    };
    let pendulum = DoublePendulum::new(params)?;
    let start = [0.0, 4.0_f64.to_radians(), 0.0, 0.0];
    let adaptive = Rk45::new()
        .rtol(1e-10)
        .atol(1e-10)
        .solve(&pendulum, 0.0, T_END, start)?;
    let fixed = Rk4::new(0.01).solve(&pendulum, 0.0, T_END, start)?;

    print_header(gamma);
    print_row("reference", reference);
    println!();
    for (name, solution) in [("Rk45, tol 1e-10", &adaptive), ("Rk4, h = 0.01", &fixed)] {
        let (_, end) = solution.last();
        print_row(name, &end);
        let work = solution.statistics();
        let error = (end - reference).amax();
        println!("  {error:>7.1e}  {:>5}  {:>5}", work.accepted, work.evaluations);
    }
    print_energy(&pendulum, &adaptive);
    Ok(adaptive)
}

fn print_header(gamma: f64) {
    print!("\n  {:<16}", format!("gamma = {gamma}"));
    for name in ["theta1", "theta2", "theta1'", "theta2'"] {
        print!("  {name:>15}");
    }
    println!("  {:>7}  {:>5}  {:>5}", "error", "steps", "evals");
}

fn print_row(name: &str, x: &SVector<f64, 4>) {
    print!("  {name:<16}");
    for component in x {
        print!("  {component:>15.12}");
    }
}

/// Prints the energy above hanging at rest: with friction it only decreases.
fn print_energy(pendulum: &DoublePendulum, solution: &Solution<f64, 4>) {
    let rest = pendulum.energy(0.0, &SVector::zeros());
    let energies: Vec<f64> = solution.points().map(|(t, x)| pendulum.energy(t, x) - rest).collect();
    let steps = energies.len() - 1;
    let falling = energies.windows(2).filter(|pair| pair[1] < pair[0]).count();
    println!(
        "  energy {:.6e} J at the start, {:.6e} J at the end; it falls in {falling} of {steps} steps",
        energies[0], energies[steps],
    );
}
