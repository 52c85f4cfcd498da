//! Section 2 of the paper: A, B and C by screws, Eq. 17 to 19, compared with point masses computed without screws.

use nalgebra::{DMatrix, DVector, Vector6};

use super::chain::{Chain, arm, pendulum};
use testbed::scenes::DoublePendulum;

/// Tolerance for central differences: some roundings over 1e-5.
const DIFFERENCES: f64 = 1e-9;

/// A pendulum and an arm, each at given joint angles.
fn cases() -> Vec<(Chain, DVector<f64>)> {
    vec![
        (pendulum(1.0), DVector::from_vec(vec![0.7, -1.1])),
        (arm(), DVector::from_vec(vec![0.4, -0.9, 1.3])),
    ]
}

fn apart(a: &DMatrix<f64>, b: &DMatrix<f64>) -> f64 {
    (a - b).amax() / b.amax()
}

#[test]
fn eq_17_takes_the_inertia_of_what_the_outer_body_carries() {
    for (chain, q) in cases() {
        let points = chain.mass_matrix_of_points(&q);
        let right = apart(&chain.eq17(&q), &points);
        let printed = apart(&chain.eq17_printed(&q), &points);
        println!(
            "Eq. 17, {} joints: right {right:.1e}, printed {printed:.3} of the largest entry",
            chain.dof()
        );
        assert!(right < DIFFERENCES);
        assert!(printed > 0.1);
    }
    // A_22 = I + m d^2 = 2. The printed form adds the inertia of the upper plate about the lower joint, which passes
    // through its centre: I = 1.
    let (chain, q) = &cases()[0];
    let [right, printed] = [chain.eq17(q), chain.eq17_printed(q)].map(|a| a[(1, 1)]);
    println!("Eq. 17, pendulum: A_22 right {right:.9}, printed {printed:.9} kg m^2");
    assert!((right - 2.0).abs() < 1e-14 && (printed - 3.0).abs() < 1e-14);
}

/// A spatial inertia is six by six. A mass matrix has a row and a column for each joint: two for the pendulum.
#[test]
fn eq_17_is_a_matrix_of_two_rows() {
    let (chain, q) = &cases()[0];
    let joints = (DoublePendulum::DOF, DoublePendulum::DOF);
    assert_eq!(chain.eq17(q).shape(), joints);
    let printed = (6, 6);
    assert_ne!(printed, joints);
    assert_eq!(chain.inertias(q)[0].shape(), printed);
}

#[test]
fn eq_18_holds_for_ordered_indices() {
    for (chain, q) in cases() {
        let n = chain.dof();
        let christoffel = chain.christoffel(&q);
        let (mut right, mut printed, mut largest, mut ordered) = (0.0_f64, 0.0_f64, 0.0_f64, 0.0_f64);
        for (i, j, k) in (0..n * n * n).map(|m| (m / n / n, m / n % n, m % n)) {
            let symbol = christoffel(i, j, k);
            let wrong = (chain.eq18_printed(&q, i, j, k) - symbol).abs();
            right = right.max((chain.eq18(&q, i, j, k) - symbol).abs());
            printed = printed.max(wrong);
            largest = largest.max(symbol.abs());
            if j <= k {
                ordered = ordered.max(wrong);
            }
        }
        println!(
            "Eq. 18, {n} joints: right {:.1e}, printed {:.3} of the largest symbol (where j <= k {:.1e})",
            right / largest,
            printed / largest,
            ordered / largest
        );
        assert!(right < DIFFERENCES * largest && ordered < DIFFERENCES * largest);
        assert!(printed > 0.1 * largest);
    }
}

#[test]
fn eq_19_has_a_minus_where_gravity_points_down() {
    for (chain, q) in cases() {
        let slope = chain.slope_of_potential(&q);
        let error = |c: DVector<f64>| (c - &slope).amax() / slope.amax();
        let (right, printed) = (error(chain.eq19(&q)), error(chain.eq19_printed(&q)));
        println!(
            "Eq. 19, {} joints: right {right:.1e}, printed {printed:.6} of the largest torque",
            chain.dof()
        );
        assert!(right < DIFFERENCES);
        assert!((printed - 2.0).abs() < DIFFERENCES);
    }
}

/// The twist of the bodies that a joint carries is the screw of the joint. An eigenvector of the inertia matrix is not:
/// it does not rotate the plate about its joint.
#[test]
fn s_is_the_screw_of_the_joint_and_no_eigenvector() {
    let (chain, q) = &cases()[0];
    for joint in 0..chain.dof() {
        let (velocity, at) = chain.carried(joint, q);
        let error = |s: &Vector6<f64>| {
            let [angular, linear] = [0, 3].map(|row| s.fixed_rows::<3>(row).into_owned());
            (angular.cross(&at) + linear - velocity).norm() / velocity.norm()
        };
        let screw = chain.screws(q)[joint];
        let inertia = chain.inertias(q)[joint];
        // the eigenvector closest to the screw, scaled to the same angular velocity
        let eigenvectors = inertia.symmetric_eigen().eigenvectors;
        let closest = eigenvectors.column_iter().max_by(|a, b| {
            let [a, b] = [a, b].map(|v| v.dot(&screw).abs());
            a.total_cmp(&b)
        });
        let closest = closest.expect("there are six");
        let eigenvector = closest / closest[2];
        let moved = inertia * screw;
        let along = moved.dot(&screw) / screw.norm_squared();
        let sideways = (moved - along * screw).norm() / moved.norm();
        let (right, printed) = (error(&screw), error(&eigenvector));
        println!(
            "s_{}: screw {right:.1e}, closest eigenvector {printed:.3}; N s is {sideways:.3} beside s",
            joint + 1
        );
        assert!(right < DIFFERENCES);
        assert!(printed > 0.1 && sideways > 0.1);
    }
}
