//! The tableaus against the order conditions of Runge-Kutta methods.

use pendulum_core::tableau::{ButcherTableau, DormandPrince5, Kutta4, Tableau};

/// `weights . v - exact` for every rooted tree up to `order`, where `theta` is the fraction of the step that `weights` cover.
///
/// Hairer, Norsett, Wanner I, II.2, Table 2.2: 17 trees up to order 5.
fn order_defects<const S: usize>(
    tableau: &ButcherTableau<S>,
    weights: &[f64; S],
    order: usize,
    theta: f64,
) -> Vec<f64> {
    let a = |v: [f64; S]| -> [f64; S] { std::array::from_fn(|i| (0..S).map(|j| tableau.a[i][j] * v[j]).sum()) };
    let mul = |u: [f64; S], v: [f64; S]| -> [f64; S] { std::array::from_fn(|i| u[i] * v[i]) };
    let c = tableau.c;
    let (c2, ac) = (mul(c, c), a(c));
    let (c3, ac2, aac) = (mul(c2, c), a(c2), a(ac));
    let trees: [(usize, f64, [f64; S]); 17] = [
        (1, 1.0, [1.0; S]),
        (2, 2.0, c),
        (3, 3.0, c2),
        (3, 6.0, ac),
        (4, 4.0, c3),
        (4, 8.0, mul(c, ac)),
        (4, 12.0, ac2),
        (4, 24.0, aac),
        (5, 5.0, mul(c3, c)),
        (5, 10.0, mul(c2, ac)),
        (5, 20.0, mul(ac, ac)),
        (5, 15.0, mul(c, ac2)),
        (5, 30.0, mul(c, aac)),
        (5, 20.0, a(c3)),
        (5, 40.0, a(mul(c, ac))),
        (5, 60.0, a(ac2)),
        (5, 120.0, a(aac)),
    ];
    trees
        .iter()
        .filter(|tree| tree.0 <= order)
        .map(|&(nodes, density, v)| {
            let sum: f64 = (0..S).map(|i| weights[i] * v[i]).sum();
            sum - theta.powi(i32::try_from(nodes).expect("small")) / density
        })
        .collect()
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, value| value.abs().max(most))
}

/// The weights that the dense output has at `theta`.
fn weights_at<const S: usize>(tableau: &ButcherTableau<S>, theta: f64) -> [f64; S] {
    std::array::from_fn(|i| {
        let rows = tableau.dense.iter().rev();
        rows.fold(0.0, |sum, row| (sum + row[i]) * theta)
    })
}

/// All conditions up to the orders that a tableau states hold, and the next order's do not: the stated orders are exact.
fn check_order_conditions<const S: usize>(tableau: &ButcherTableau<S>) {
    // The coefficients are below 12, and so many roundings of such numbers stay well below this.
    let tolerance = 1e-13;
    for (row, c) in tableau.a.iter().zip(tableau.c) {
        assert!((row.iter().sum::<f64>() - c).abs() < tolerance, "row sum");
    }
    assert!(largest(&order_defects(tableau, &tableau.b, tableau.order, 1.0)) < tolerance);
    if tableau.order < 5 {
        assert!(largest(&order_defects(tableau, &tableau.b, tableau.order + 1, 1.0)) > 1e-3);
    }
    if let Some(b_hat) = &tableau.b_hat {
        assert!(largest(&order_defects(tableau, b_hat, tableau.order_hat, 1.0)) < tolerance);
        assert!(largest(&order_defects(tableau, b_hat, tableau.order_hat + 1, 1.0)) > 1e-4);
    }
    for theta in [0.1, 0.3, 0.5, 0.77, 1.0] {
        let weights = weights_at(tableau, theta);
        let order = tableau.dense_order;
        assert!(largest(&order_defects(tableau, &weights, order, theta)) < tolerance);
        if theta < 1.0 {
            assert!(largest(&order_defects(tableau, &weights, order + 1, theta)) > 1e-5);
        }
    }
    for (weight, b) in weights_at(tableau, 1.0).iter().zip(tableau.b) {
        assert!((weight - b).abs() < tolerance, "dense output misses the end");
    }
}

#[test]
fn tableaus_satisfy_their_order_conditions() {
    check_order_conditions(&Kutta4::TABLEAU);
    check_order_conditions(&DormandPrince5::TABLEAU);
}
