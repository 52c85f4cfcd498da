//! Generated right-hand side and Jacobian of Eq. 22 compared with hand-written ones:
//! `cargo bench --bench double_pendulum`.
//!
//! The last lines are ratios of times measured in turn, which are more reliable on a noisy machine than the times
//! themselves.

use std::hint::black_box;

use divan::Bencher;
use nalgebra::SVector;
use pendulum_core::prelude::*;
use testbed::eq22::Eq22;
use testbed::scenes::{DoublePendulum, DoublePendulumParams};

use ratio::ratio;

mod ratio;

/// Number of evaluations between two readings of the clock.
const BATCH: usize = 1000;
/// Number of pairs of batches; the ratio is their median.
const PAIRS: usize = 2001;

fn main() {
    divan::main();
    let (generated, by_hand, x) = (generated(), by_hand(), state());
    let rhs = ratio(
        PAIRS,
        BATCH,
        || generated.rhs(0.0, black_box(&x)),
        || by_hand.rhs(0.0, black_box(&x)),
    );
    println!("generated / by hand, right-hand side: {rhs:.3}");
    let jacobian = ratio(
        PAIRS,
        BATCH,
        || generated.jacobian(0.0, black_box(&x)),
        || by_hand.jacobian(0.0, black_box(&x)),
    );
    println!("generated / by hand, Jacobian:        {jacobian:.3}");
}

fn generated() -> DoublePendulum {
    match DoublePendulum::new(DoublePendulumParams::default()) {
        Ok(model) => model,
        Err(error) => panic!("the default parameters are physical: {error}"),
    }
}

fn by_hand() -> Eq22 {
    Eq22::paper(0.1)
}

fn state() -> SVector<f64, 4> {
    SVector::from([0.7, -1.2, 0.4, 2.1])
}

#[divan::bench]
fn rhs_generated(bencher: Bencher) {
    let (model, x) = (generated(), state());
    bencher.bench(|| model.rhs(0.0, black_box(&x)));
}

#[divan::bench]
fn rhs_by_hand(bencher: Bencher) {
    let (model, x) = (by_hand(), state());
    bencher.bench(|| model.rhs(0.0, black_box(&x)));
}

#[divan::bench]
fn jacobian_generated(bencher: Bencher) {
    let (model, x) = (generated(), state());
    bencher.bench(|| model.jacobian(0.0, black_box(&x)));
}

#[divan::bench]
fn jacobian_by_hand(bencher: Bencher) {
    let (model, x) = (by_hand(), state());
    bencher.bench(|| model.jacobian(0.0, black_box(&x)));
}
