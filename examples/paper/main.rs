//! Section 4 of the paper on real numbers: H. Williams, "Chaotic dynamics of the compound double pendulum with friction",
//! Forces in Mechanics (2023), Eq. 22 and Fig. 2.
//!
//! `cargo run --release --example paper` declares the pendulum, prints its generated equations beside those of the paper,
//! compares its motion with reference data, and draws Fig. 2 into `out/paper/`.

#[path = "../common/chart.rs"]
mod chart;
mod figure;
mod reference;
#[path = "../common/typeset.rs"]
mod typeset;

use std::error::Error;

use pendulum_core::prelude::*;
use reference::Reference;

mechanism! {
    /// Two identical plates on axles with friction: Williams (2023), Eq. 22.
    pub DoublePendulum {
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

/// The paper's three frictions, the same in both axles, in N m s.
const GAMMAS: [f64; 3] = [1.0, 0.4, 0.1];

/// The length of the motion, in s.
const END: f64 = 20.0;

/// Relative and absolute tolerance of the adaptive method.
const TOLERANCE: f64 = 1e-10;

/// Step of the fixed-step method, in s.
const STEP: f64 = 0.01;

/// Eq. 22 in the order of the generated text; it holds for identical plates with `c = d`.
const EQ_22: &str = "\
A[theta1, theta1] = inertia + 2*m*d^2
A[theta1, theta2] = m*d^2*cos(theta1 - theta2)
A[theta2, theta2] = inertia + m*d^2
b[theta1] = 2*m*d*g*sin(theta1) + m*d^2*dot(theta2)^2*sin(theta1 - theta2)
b[theta2] = -m*d^2*dot(theta1)^2*sin(theta1 - theta2) + m*d*g*sin(theta2)
Q[theta1] = -gamma1*dot(theta1) - gamma2*(dot(theta1) - dot(theta2))
Q[theta2] = gamma2*(dot(theta1) - dot(theta2))";

/// The motion with one friction, by an accurate method and by a plain one.
struct Motion {
    gamma: f64,
    model: DoublePendulum,
    rk45: Solution<4>,
    rk4: Solution<4>,
}

impl Motion {
    fn new(gamma: f64) -> Result<Self, Box<dyn Error>> {
        let model = DoublePendulum::new(DoublePendulumParams {
            gamma1: gamma,
            gamma2: gamma,
            ..Default::default()
        })?;
        let start = [0.0, 4.0_f64.to_radians(), 0.0, 0.0];
        let rk45 = Rk45::new().rtol(TOLERANCE).atol(TOLERANCE);
        Ok(Self {
            gamma,
            rk45: rk45.solve(&model, 0.0, END, start)?,
            rk4: Rk4::new(STEP).solve(&model, 0.0, END, start)?,
            model,
        })
    }

    /// Energy above that at rest at each accepted point, in J.
    fn energies(&self) -> Vec<f64> {
        let rest = self.model.energy(0.0, &SVector::zeros());
        let points = self.rk45.t().iter().zip(self.rk45.x());
        points.map(|(&t, x)| self.model.energy(t, x) - rest).collect()
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    print_equations();
    let motions = GAMMAS.map(Motion::new).into_iter().collect::<Result<Vec<_>, _>>()?;
    print_end_states(&motions)?;
    print_energies(&motions)?;
    for path in figure::draw(&motions)? {
        println!("{}", path.display());
    }
    Ok(())
}

fn print_equations() {
    println!("GENERATED EQUATIONS\n{}", DoublePendulum::EQUATIONS);
    println!("EQ. 22, corrected, in the same order. It has identical plates, as here, and c = d:\n\n{EQ_22}\n");
    println!("Printed, Eq. 22b has dot(theta2)^2 where b[theta2] has dot(theta1)^2; that would not conserve energy.\n");
    println!("OPERATIONS");
    println!("right-hand side  {}", DoublePendulum::COST.rhs);
    println!("Jacobian         {}\n", DoublePendulum::COST.jacobian);
}

fn print_end_states(motions: &[Motion]) -> Result<(), Box<dyn Error>> {
    println!("END STATES, t = {END} s from theta1 = 0, theta2 = 4 degrees at rest; rad and rad/s");
    println!(
        "{:<7}{:<15}{:>14}{:>14}{:>14}{:>14}{:>11}{:>7}{:>13}",
        "gamma", "", "theta1", "theta2", "dot(theta1)", "dot(theta2)", "error", "steps", "evaluations"
    );
    for motion in motions {
        let reference = Reference::of(motion.gamma)?;
        let gamma = motion.gamma.to_string();
        println!("{gamma:<7}{:<15}{}", "reference", numbers(&reference.end));
        let rows = [
            (format!("Rk45, {TOLERANCE:e}"), &motion.rk45),
            (format!("Rk4, h = {STEP}"), &motion.rk4),
        ];
        for (method, solution) in rows {
            let (_, end) = solution.last();
            let (error, statistics) = ((end - reference.end).amax(), solution.statistics());
            println!(
                "{:<7}{method:<15}{}{error:>11.1e}{:>7}{:>13}",
                "",
                numbers(&end),
                statistics.accepted + statistics.rejected,
                statistics.evaluations
            );
        }
    }
    println!();
    Ok(())
}

/// The components of a state, side by side.
fn numbers(x: &SVector<f64, 4>) -> String {
    x.iter().map(|component| format!("{component:>14.10}")).collect()
}

/// Friction takes energy all the time: if it rose, the model or the method were wrong.
fn print_energies(motions: &[Motion]) -> Result<(), Box<dyn Error>> {
    println!("ENERGY above rest, in J, by Rk45");
    println!(
        "{:<7}{:>14}{:>14}{:>11}",
        "gamma",
        "t = 0 s",
        format!("t = {END} s"),
        "left"
    );
    for motion in motions {
        let energies = motion.energies();
        if energies.windows(2).any(|pair| pair[1] > pair[0]) {
            return Err(format!("with friction {} the energy rises", motion.gamma).into());
        }
        let (start, end) = (energies[0], energies[energies.len() - 1]);
        let left = 100.0 * end / start;
        println!("{:<7}{start:>14.6}{end:>14.6}{left:>9.2} %", motion.gamma);
    }
    println!();
    Ok(())
}
