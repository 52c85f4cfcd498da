//! Figures of `docs/src/paper-audit.md`: effects of the misprints of the paper on its results.
//!
//! `cargo run --release -p studies --example paper_audit` prints growth rates of the printed and of the correct
//! linearisation, the energy under the printed equations, Fig. 2 as two damped modes, and Lyapunov exponents over the
//! amplitude, and draws them into `out/paper_audit/`. The printed forms are shared with `tests/it/paper_audit`, which
//! has a test for each of them.

mod energy;
mod exponent;
mod modes;
mod unstable;

use std::error::Error;
use std::path::Path;

use charts::chart::Figure;
use charts::page::Picture;
use testbed::scenes::{DoublePendulum, DoublePendulumParams};

/// Prints the numbers of a figure, and returns the figure.
type Measurement = fn() -> Result<Figure, Box<dyn Error>>;

fn main() -> Result<(), Box<dyn Error>> {
    let figures: [(&str, Measurement); 4] = [
        ("unstable", unstable::figure),
        ("energy", energy::figure),
        ("modes", modes::figure),
        ("exponent", exponent::figure),
    ];
    let mut files = Vec::new();
    for (name, figure) in figures {
        files.extend(figure()?.save(&Path::new("out/paper_audit").join(name))?);
        println!();
    }
    for file in files {
        println!("{}", file.display());
    }
    Ok(())
}

/// Generated model of the paper's pendulum.
fn model(gamma1: f64, gamma2: f64) -> Result<DoublePendulum, Box<dyn Error>> {
    let params = DoublePendulumParams {
        gamma1,
        gamma2,
        ..Default::default()
    };
    Ok(DoublePendulum::new(params)?)
}
