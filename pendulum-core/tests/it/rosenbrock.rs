//! The tableaus of Rosenbrock methods against their order conditions.

use crate::tableaus::tree::{Tree, trees};
use nalgebra::{SMatrix, SVector};
use pendulum_core::prelude::*;
use pendulum_core::tableau::{HairerWanner4, RosenbrockMethod, Steinebach5};

/// Tolerance of order conditions. The coefficients are published to 16 digits; the entries of `Gamma^-1` reach 166, and
/// a condition contains products of only a few large ones.
const TOLERANCE: f64 = 1e-12;

/// Elementary weights `Phi_i(t)` for every tree: a node with one branch sums over `alpha_ij + gamma_ij`, a node with
/// several over `alpha_ij`.
///
/// Hairer, Wanner II, 2nd ed., IV.7.
fn elementary_weights<const S: usize>(
    trees: &[Tree],
    alpha: &SMatrix<f64, S, S>,
    gamma: &SMatrix<f64, S, S>,
) -> Vec<SVector<f64, S>> {
    let one = SVector::from_element(1.0);
    let (mut phi, mut by_alpha) = (Vec::new(), Vec::<SVector<f64, S>>::new());
    for tree in trees {
        let Some((trunk, branch)) = tree.parts else {
            phi.push(one);
            by_alpha.push(one);
            continue;
        };
        let product = by_alpha[trunk].component_mul(&(alpha * phi[branch]));
        phi.push(if trunk == 0 {
            (alpha + gamma) * phi[branch]
        } else {
            product
        });
        by_alpha.push(product);
    }
    phi
}

/// Largest `|sum_i weights_i Phi_i(t) - theta^order / gamma(t)|` of an order.
fn defect<const S: usize>(
    (trees, phi): (&[Tree], &[SVector<f64, S>]),
    weights: &SVector<f64, S>,
    order: usize,
    theta: f64,
) -> f64 {
    let of_order = trees.iter().zip(phi).filter(|(tree, _)| tree.order == order);
    let power: f64 = (0..order).map(|_| theta).product();
    let defects = of_order.map(|(tree, phi)| (weights.dot(phi) - power / tree.density).abs());
    defects.fold(0.0, f64::max)
}

fn check<B: RosenbrockMethod<S>, const S: usize>() {
    let tableau = &B::TABLEAU;
    let a = SMatrix::<f64, S, S>::from_fn(|i, j| tableau.a[i][j]);
    let c = SMatrix::<f64, S, S>::from_fn(|i, j| tableau.c[i][j]);
    let inverse = SMatrix::<f64, S, S>::identity() / tableau.gamma - c;
    let gamma = inverse.try_inverse().expect("triangular");
    let alpha = a * gamma;
    let sums = alpha.column_sum() - SVector::from(tableau.alpha);
    assert!(sums.amax() < TOLERANCE, "alpha: {}", sums.amax());
    let sums = gamma.column_sum() - SVector::from(tableau.gamma_sums);
    assert!(sums.amax() < TOLERANCE, "gamma: {}", sums.amax());

    let trees = trees(tableau.order + 1);
    let phi = elementary_weights(&trees, &alpha, &gamma);
    let check = |what: &str, weights: SVector<f64, S>, order: usize, theta: f64| {
        let weights = gamma.tr_mul(&weights);
        for order in 1..=order {
            let found = defect((&trees, &phi), &weights, order, theta);
            assert!(found < TOLERANCE, "{what}, order {order} at {theta}: {found:e}");
        }
        let next = defect((&trees, &phi), &weights, order + 1, theta);
        assert!(next > 1e6 * TOLERANCE, "{what}, order {order} at {theta}: {next:e}");
    };
    check("b", tableau.b.into(), tableau.order, 1.0);
    check("b_hat", tableau.b_hat.into(), tableau.order_hat, 1.0);
    let at = |theta: f64| {
        let rows = tableau.dense.iter().rev();
        rows.fold(SVector::zeros(), |sum: SVector<f64, S>, row| {
            (sum + SVector::from_row_slice(row)) * theta
        })
    };
    for theta in [0.2, 0.4, 0.7] {
        check("dense", at(theta), tableau.dense_order, theta);
    }
    assert!((at(1.0) - SVector::from(tableau.b)).amax() < TOLERANCE);

    // Stiffly accurate: the last stage starts at the end point of the embedded method, and its own weight is 1.
    assert_eq!(tableau.a[S - 1], tableau.b_hat);
    assert_eq!(tableau.b[S - 1], 1.0);
}

#[test]
fn rodas4() {
    check::<HairerWanner4, 6>();
}

#[test]
fn rodas5p() {
    check::<Steinebach5, 8>();
}

/// A fast drive, whose time derivative differences over some microseconds would miss.
#[test]
fn a_derivative_by_the_time_that_is_given_saves_steps() {
    let omega = 1e5;
    let driven = || {
        FnSystem::with_jacobian(
            move |t: f64, x: &SVector<f64, 1>| SVector::from([-x[0] + (omega * t).cos()]),
            |_t: f64, _x: &SVector<f64, 1>| SMatrix::from([[-1.0]]),
        )
    };
    let given =
        driven().with_time_derivative(move |t: f64, _x: &SVector<f64, 1>| SVector::from([-omega * (omega * t).sin()]));
    let method = Rodas5P::new().rtol(1e-8).atol(1e-10);
    let [by_differences, by_derivative] = [
        method.solve(&driven(), 0.0, 0.01, [0.0]).expect("a motion"),
        method.solve(&given, 0.0, 0.01, [0.0]).expect("a motion"),
    ];
    let expected = |t: f64| (omega * t).sin() / omega;
    let (t, x) = by_derivative.last();
    assert!((x[0] - expected(t)).abs() < 1e-8, "{x} {}", expected(t));
    let steps = [by_differences, by_derivative].map(|solution| solution.statistics().accepted);
    assert!(steps[1] * 5 < steps[0], "{steps:?}");
}
