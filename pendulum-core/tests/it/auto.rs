//! The method that looks for stiffness itself: what it does is read off its statistics.

use approx::assert_abs_diff_eq;
use pendulum_core::Statistics;
use pendulum_core::prelude::*;

/// `x'' = -lambda (x - cos t)` as friction would do it, to first order: it is as stiff as `lambda` is large.
struct Prothero {
    lambda: f64,
}

impl System<f64, 1> for Prothero {
    fn rhs(&self, t: f64, x: &SVector<f64, 1>) -> SVector<f64, 1> {
        SVector::from([-self.lambda * (x[0] - t.cos()) - t.sin()])
    }
}

impl Jacobian<f64, 1> for Prothero {
    fn jacobian(&self, _t: f64, _x: &SVector<f64, 1>) -> SMatrix<f64, 1, 1> {
        SMatrix::from([[-self.lambda]])
    }
}

#[test]
fn stiff_systems_are_left_to_the_implicit_method() {
    for (tolerance, lambda) in [(1e-3, 1e4), (1e-6, 1e4), (1e-9, 1e4), (1e-6, 1e8)] {
        let system = Prothero { lambda };
        let method = Auto::new().rtol(tolerance).atol(tolerance);
        let solution = method.solve(&system, 0.0, 20.0, [1.5]).expect("regular");
        let Statistics {
            accepted,
            stiff,
            switches,
            ..
        } = solution.statistics();
        assert_eq!(switches, 1, "{lambda} {tolerance}");
        assert!(
            stiff + 100 > accepted && accepted < 1000,
            "{lambda} {tolerance}: {stiff} of {accepted}"
        );
        assert_abs_diff_eq!(solution.end()[0], 20.0_f64.cos(), epsilon = 10.0 * tolerance);
    }
}

#[test]
fn systems_that_are_not_stiff_are_left_to_the_explicit_method() {
    for tolerance in [1e-3, 1e-6, 1e-9] {
        let system = Prothero { lambda: 0.5 };
        let method = Auto::new().rtol(tolerance).atol(tolerance);
        let statistics = method.solve(&system, 0.0, 200.0, [1.5]).expect("regular").statistics();
        assert_eq!(
            (statistics.switches, statistics.stiff, statistics.jacobians),
            (0, 0, 0),
            "{tolerance}"
        );
    }
}

/// Van der Pol's oscillator, which creeps and jumps by turns.
struct VanDerPol {
    mu: f64,
}

impl System<f64, 2> for VanDerPol {
    fn rhs(&self, _t: f64, x: &SVector<f64, 2>) -> SVector<f64, 2> {
        SVector::from([x[1], self.mu * (1.0 - x[0] * x[0]) * x[1] - x[0]])
    }
}

impl Jacobian<f64, 2> for VanDerPol {
    fn jacobian(&self, _t: f64, x: &SVector<f64, 2>) -> SMatrix<f64, 2, 2> {
        let (x, v) = (x[0], x[1]);
        SMatrix::from([[0.0, -2.0 * self.mu * x * v - 1.0], [1.0, self.mu * (1.0 - x * x)]])
    }
}

#[test]
fn it_changes_with_the_motion() {
    let system = VanDerPol { mu: 1000.0 };
    let method = Auto::new().rtol(1e-8).atol(1e-8);
    let solution = method.solve(&system, 0.0, 3000.0, [2.0, 0.0]).expect("regular");
    let Statistics {
        accepted,
        rejected,
        stiff,
        switches,
        ..
    } = solution.statistics();
    assert!(switches >= 3, "{switches}");
    assert!(
        stiff * 2 > accepted && accepted + rejected < 4000,
        "{stiff} of {accepted} and {rejected}"
    );
    let implicit = Rodas5P::new().rtol(1e-10).atol(1e-10);
    let expected = implicit.solve(&system, 0.0, 3000.0, [2.0, 0.0]).expect("regular").end();
    assert_abs_diff_eq!(solution.end(), expected, epsilon = 1e-4);
}
