//! Riccati equations of random pairs.

use pendulum_core::control::StateSpace;
use pendulum_core::nalgebra::SMatrix;

use super::{Random, dynamic};

/// Largest residuals of the continuous and the discrete equation, relative to bounds on their terms.
#[derive(Debug, Default)]
struct Worst([f64; 2]);

fn tried<const N: usize, const M: usize>(random: &mut Random, worst: &mut Worst, rough: f64) {
    // Powers of 10 by which units differ.
    let mut power = || 10.0_f64.powf(rough * random.number());
    let (units, price) = (SMatrix::<f64, N, 1>::from_fn(|_, _| power()), power());
    let (scale, over) = (
        SMatrix::from_diagonal(&units),
        SMatrix::from_diagonal(&units.map(f64::recip)),
    );
    let a = scale * random.matrix::<N, N>() * over;
    let b = scale * random.matrix::<N, M>();
    let c: SMatrix<f64, M, N> = random.matrix::<M, N>() * over;
    let weights: SMatrix<f64, M, M> = random.matrix();
    let q = c.transpose() * c;
    let r = (weights.transpose() * weights + SMatrix::identity() * 0.1) * price;
    for is_sampled in [false, true] {
        let model = if is_sampled {
            StateSpace::sampled(a, b, 1.0).expect("period")
        } else {
            StateSpace::new(a, b)
        };
        let regulator = model
            .lqr(&q, &r)
            .unwrap_or_else(|error| panic!("{N} {M} {is_sampled}: {error}"));
        let [q, r, p] = [dynamic(&q), dynamic(&r), dynamic(&regulator.cost)];
        // In the units of the draw, since eigenvalues of a matrix without scaling have its rounding errors.
        let closed = over * (a - b * regulator.law.gain) * scale;
        let values = dynamic(&closed).complex_eigenvalues();
        let growth = values
            .iter()
            .map(|value| if is_sampled { value.norm() - 1.0 } else { value.re });
        assert!(growth.fold(f64::NEG_INFINITY, f64::max) < 0.0, "{N} {M} {is_sampled}");
        let [a, b] = [dynamic(&a), dynamic(&b)];
        let [na, np] = [a.norm(), p.norm()];
        let pa = &p * &a;
        let (difference, terms) = if is_sampled {
            let (apa, pb) = (a.transpose() * &pa, b.transpose() * &pa);
            let inner = (r + b.transpose() * &p * &b).cholesky().expect("positive");
            let last = pb.transpose() * inner.solve(&pb);
            (&apa - &p - &last + &q, q.norm() + np * (1.0 + na * na))
        } else {
            let pb = b.transpose() * &p;
            let inner = r.cholesky().expect("positive");
            let last = pb.transpose() * inner.solve(&pb);
            let spread = (&b * inner.solve(&b.transpose())).norm();
            (
                &pa + pa.transpose() - &last + &q,
                q.norm() + np * (2.0 * na + np * spread),
            )
        };
        let worst = &mut worst.0[usize::from(is_sampled)];
        *worst = worst.max(difference.norm() / terms);
    }
}

/// 1,008 pairs in units of four spreads with `PENDULUM_THOROUGH` set, and a ninth of them without.
#[test]
fn residuals_are_rounding_errors() {
    let rounds = if std::env::var_os("PENDULUM_THOROUGH").is_some() {
        9
    } else {
        1
    };
    for rough in [0.0, 1.0, 2.0, 3.0] {
        let (mut worst, mut random) = (Worst::default(), Random(1));
        for _ in 0..rounds {
            macro_rules! each {
                ($($order:literal)*) => { $(
                    tried::<$order, 1>(&mut random, &mut worst, rough);
                    tried::<$order, 3>(&mut random, &mut worst, rough);
                )* };
            }
            each!(1 2 3 4 5 6 7 8 9 10 11 12 13 14);
        }
        println!("units within 10^+-{rough}: {worst:?}");
        assert!(worst.0.iter().all(|&residual| residual < 1e-12), "{rough}: {worst:?}");
    }
}
