//! Published cases and closed forms of Riccati equations.
//!
//! CAREX and DAREX are the collections of P. Benner, A. J. Laub, V. Mehrmann, "A collection of benchmark examples for
//! the numerical solution of algebraic Riccati equations", I: SPC 95-22, II: SPC 95-23, TU Chemnitz (1995).

use approx::assert_relative_eq;
use pendulum_core::control::StateSpace;
use pendulum_core::nalgebra::{SMatrix, SVector};
use pendulum_core::stability::Complex;

use super::{diagonal, dynamic, fixed};

/// Cost to go of a continuous problem, or a sampled one.
fn cost<const N: usize, const M: usize>(
    is_sampled: bool,
    a: SMatrix<f64, N, N>,
    b: SMatrix<f64, N, M>,
    q: SMatrix<f64, N, N>,
    r: SMatrix<f64, M, M>,
) -> SMatrix<f64, N, N> {
    let model = if is_sampled {
        StateSpace::sampled(a, b, 1.0).expect("period")
    } else {
        StateSpace::new(a, b)
    };
    model.lqr(&q, &r).expect("solvable").cost
}

/// Laub's example 2, number 2 of CAREX and 1 of DAREX: the mode of -1/2 is not reached, and is stable.
fn stabilizable() -> (SMatrix<f64, 2, 2>, SMatrix<f64, 2, 1>, SMatrix<f64, 2, 2>) {
    (
        SMatrix::<f64, 2, 2>::new(4.0, 3.0, -4.5, -3.5),
        SMatrix::from([[1.0, -1.0]]),
        SMatrix::<f64, 2, 2>::new(9.0, 6.0, 6.0, 4.0),
    )
}

/// Ones above the diagonal.
fn shift<const N: usize>() -> SMatrix<f64, N, N> {
    SMatrix::from_fn(|i, j| f64::from(u8::from(j == i + 1)))
}

fn last_axis<const N: usize>() -> SMatrix<f64, N, 1> {
    SMatrix::from_fn(|i, _| f64::from(u8::from(i == N - 1)))
}

#[test]
fn a_double_integrator_has_the_gain_of_its_closed_form() {
    let mass = StateSpace::new(shift::<2>(), last_axis());
    let regulator = mass
        .lqr(&SMatrix::identity(), &SMatrix::identity())
        .expect("controllable");
    assert_relative_eq!(
        regulator.law.gain,
        SMatrix::from([[1.0], [3.0_f64.sqrt()]]),
        epsilon = 1e-14
    );
    // Number 1 of CAREX: Laub's example 1.
    let solution = cost(
        false,
        shift::<2>(),
        last_axis(),
        diagonal([1.0, 2.0]),
        SMatrix::identity(),
    );
    assert_relative_eq!(solution, SMatrix::<f64, 2, 2>::new(2.0, 1.0, 1.0, 2.0), epsilon = 1e-14);
}

#[test]
fn modes_that_are_not_reached_may_decay_by_themselves() {
    let (a, b, q) = stabilizable();
    let one = SMatrix::identity();
    let factor = 1.0 + 2.0_f64.sqrt();
    assert_relative_eq!(cost(false, a, b, q, one), q * factor, max_relative = 1e-13);
    let factor = 0.5 * (1.0 + 5.0_f64.sqrt());
    assert_relative_eq!(cost(true, a, b, q, one), q * factor, max_relative = 1e-13);
}

#[test]
fn small_parameters_cost_few_digits() {
    for epsilon in [1.0, 1e-2, 1e-4, 1e-6_f64] {
        // Number 7 of CAREX: one mode is almost out of reach, which costs digits.
        let a = diagonal([1.0, -2.0]);
        let q = SMatrix::from_element(1.0);
        let root = (1.0 + epsilon * epsilon).sqrt();
        let coupling = 1.0 / (2.0 + root);
        let last = 0.25 * (1.0 - (epsilon * coupling).powi(2));
        let exact = SMatrix::<f64, 2, 2>::new((1.0 + root) / epsilon.powi(2), coupling, coupling, last);
        let found = cost(false, a, SMatrix::from([[epsilon, 0.0]]), q, SMatrix::identity());
        assert_relative_eq!(found, exact, max_relative = 1e-9);
        // Number 9 of CAREX: a chain that hardly holds together.
        let a = shift::<2>() * epsilon;
        let root = (1.0 + 2.0 * epsilon).sqrt();
        let exact = SMatrix::<f64, 2, 2>::new(root / epsilon, 1.0, 1.0, root);
        let found = cost(false, a, last_axis(), SMatrix::identity(), SMatrix::identity());
        assert_relative_eq!(found, exact, max_relative = 1e-13);
        // Number 13 of DAREX, in axes that are not those of the state, with decoupled scalar equations.
        let reflection: SMatrix<f64, 3, 3> = SMatrix::identity() - SMatrix::from_element(2.0 / 3.0);
        let rates = [0.0, 1.0, 3.0];
        let a = reflection * diagonal(rates) * reflection;
        let one = SMatrix::<f64, 3, 3>::identity();
        let found = cost(true, a, one, one / epsilon, one * epsilon);
        let solution = rates.map(|rate: f64| {
            // p = q + rate^2 p r / (p + r)
            let (q, r) = (1.0 / epsilon, epsilon);
            let half = 0.5 * (q + (rate * rate - 1.0) * r);
            half + (half * half + q * r).sqrt()
        });
        let exact = reflection * diagonal(solution) * reflection;
        assert!((found - exact).norm() < 1e-13 * exact.norm(), "{epsilon}");
    }
}

/// Chains of integrators, number 17 of CAREX, and of delays, number 15 of DAREX.
#[test]
fn chains_have_the_eigenvalues_of_butterworth_and_the_costs_of_delays() {
    const N: usize = 14;
    let mut first = SMatrix::<f64, N, N>::zeros();
    first[(0, 0)] = 1.0;
    let chain = StateSpace::new(shift::<N>(), last_axis());
    let regulator = chain.lqr(&first, &SMatrix::identity()).expect("controllable");
    assert_relative_eq!(regulator.cost[(0, N - 1)], 1.0, max_relative = 1e-9);
    for eigenvalue in &regulator.eigenvalues {
        let power: Complex<f64> = eigenvalue.powu(2 * N as u32);
        // The eigenvalues of a chain are ill-conditioned; their 28th powers are accurate to 1e-6.
        assert!((power - Complex::from(-1.0)).norm() < 1e-6, "{power}");
        assert!(eigenvalue.re < 0.0);
    }
    let delays = cost(
        true,
        shift::<N>(),
        last_axis(),
        SMatrix::identity(),
        SMatrix::identity(),
    );
    let exact = SMatrix::from_diagonal(&SVector::<f64, N>::from_fn(|n, _| n as f64 + 1.0));
    assert_relative_eq!(delays, exact, epsilon = 1e-12);
}

#[test]
fn a_singular_matrix_of_a_sampled_model_is_no_obstacle() {
    // Number 5 of DAREX.
    let (a, b) = (shift::<2>(), last_axis());
    let q = SMatrix::<f64, 2, 2>::new(1.0, 2.0, 2.0, 4.0);
    let exact = SMatrix::<f64, 2, 2>::new(1.0, 2.0, 2.0, 2.0 + 5.0_f64.sqrt());
    assert_relative_eq!(cost(true, a, b, q, SMatrix::identity()), exact, max_relative = 1e-13);
    // Number 12 of DAREX, with its parameter at 1e6.
    let found = cost(true, a * 1e6, b, SMatrix::identity(), SMatrix::identity());
    assert_relative_eq!(found, diagonal([1.0, 1.0 + 1e12]), max_relative = 1e-13);
}

/// A ring of neighbours, number 16 of CAREX: the solution is `A + sqrt(A^2 + I)`.
#[test]
fn a_ring_of_neighbours_has_the_solution_of_its_modes() {
    const N: usize = 12;
    let neighbours = |i: usize, j: usize| (i + 1) % N == j || (j + 1) % N == i;
    let a = SMatrix::<f64, N, N>::from_fn(|i, j| match i == j {
        true => -2.0,
        false => f64::from(u8::from(neighbours(i, j))),
    });
    let one = SMatrix::<f64, N, N>::identity();
    let eigen = dynamic(&a).symmetric_eigen();
    let values = eigen.eigenvalues.map(|value| value + (value * value + 1.0).sqrt());
    let axes = &eigen.eigenvectors;
    let exact: SMatrix<f64, N, N> =
        fixed(&(axes * pendulum_core::nalgebra::DMatrix::from_diagonal(&values) * axes.transpose()));
    assert_relative_eq!(cost(false, a, one, one, one), exact, epsilon = 1e-13);
}

/// "Control Tutorials for MATLAB and Simulink", University of Michigan: "Aircraft Pitch" and "Inverted Pendulum", state
/// space design, continuous and digital at 100 Hz. Digits beyond the printed ones by SciPy 1.17.1.
#[test]
fn gains_of_tutorials_are_reproduced() {
    let pitch = StateSpace::new(
        SMatrix::<f64, 3, 3>::new(-0.313, 56.7, 0.0, -0.0139, -0.426, 0.0, 0.0, 56.7, 0.0),
        SMatrix::from([[0.232, 0.0203, 0.0]]),
    );
    let gain = pitch
        .lqr(&diagonal([0.0, 0.0, 50.0]), &SMatrix::identity())
        .expect("controllable")
        .law
        .gain;
    let known = [[-0.643_456_656_624_2], [169.695_018_634], [7.071_067_811_865]];
    assert_relative_eq!(gain, SMatrix::from(known), max_relative = 1e-11);

    let [cart, mass, friction, inertia, g, l] = [0.5, 0.2, 0.1, 0.006, 9.8, 0.3];
    let p = inertia * (cart + mass) + cart * mass * l * l;
    let a = SMatrix::<f64, 4, 4>::from_row_slice(&[
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        -(inertia + mass * l * l) * friction / p,
        mass * mass * g * l * l / p,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        -mass * l * friction / p,
        mass * g * l * (cart + mass) / p,
        0.0,
    ]);
    let b = SMatrix::from([[0.0, (inertia + mass * l * l) / p, 0.0, mass * l / p]]);
    let pendulum = StateSpace::new(a, b);
    let (q, r) = (diagonal([5000.0, 0.0, 100.0, 0.0]), SMatrix::identity());
    let gain = pendulum.lqr(&q, &r).expect("controllable").law.gain;
    let known = [
        [-70.710_678_118_65],
        [-37.834_453_993_5],
        [105.529_781_916_0],
        [20.923_843_749_21],
    ];
    assert_relative_eq!(gain, SMatrix::from(known), max_relative = 1e-11);
    let gain = pendulum
        .discretize(0.01)
        .expect("finite")
        .lqr(&q, &r)
        .expect("controllable")
        .law
        .gain;
    let known = [
        [-61.993_344_331_3],
        [-33.503_967_567_9],
        [95.059_731_991_8],
        [18.830_023_082_94],
    ];
    assert_relative_eq!(gain, SMatrix::from(known), max_relative = 1e-10);
}

#[test]
fn an_unstable_mode_without_weight_is_mirrored() {
    // Cheapest stabilization (H. Kwakernaak, R. Sivan, "Linear Optimal Control Systems" (1972), 3.8): s = 2 becomes -2.
    let scalar = StateSpace::new(SMatrix::from([[2.0]]), SMatrix::from([[1.0]]));
    let regulator = scalar
        .lqr(&SMatrix::zeros(), &SMatrix::identity())
        .expect("stabilizable");
    assert_relative_eq!(regulator.law.gain[0], 4.0, max_relative = 1e-14);
    assert_relative_eq!(regulator.eigenvalues[0].re, -2.0, max_relative = 1e-14);
    // and the factor 4 from sample to sample 1/4
    let scalar = StateSpace::sampled(SMatrix::from([[4.0]]), SMatrix::from([[1.0]]), 0.1).expect("period");
    let regulator = scalar
        .lqr(&SMatrix::zeros(), &SMatrix::identity())
        .expect("stabilizable");
    assert_relative_eq!(regulator.eigenvalues[0].re, 0.25, max_relative = 1e-13);
}

#[test]
fn filters_of_a_tracked_mass_have_their_closed_forms() {
    let shown = SMatrix::<f64, 1, 2>::new(1.0, 0.0);
    let mass = StateSpace::new(shift::<2>(), last_axis()).with_output_matrices(shown, SMatrix::zeros());
    let filter = mass
        .kalman(&diagonal([0.0, 4.0]), &SMatrix::identity())
        .expect("observable");
    // With spectral densities w and v and the ratio s^2 = sqrt(w / v): L = [sqrt(2) s, s^2].
    assert_relative_eq!(filter.gain, SMatrix::from([[2.0, 2.0]]), max_relative = 1e-14);

    // The alpha-beta tracker (P. R. Kalata, IEEE Trans. Aerosp. Electron. Syst. 20 (1984) 174), for a random
    // acceleration in each period.
    for index in [0.01, 1.0, 10.0_f64] {
        let period = 0.1;
        let sampled = mass.discretize(period).expect("finite");
        let push = SMatrix::<f64, 2, 1>::new(0.5 * period * period, period);
        let noise = push * push.transpose() * (index / (period * period)).powi(2);
        let filter = sampled.kalman(&noise, &SMatrix::identity()).expect("observable");
        let r = 0.25 * (4.0 + index - (8.0 * index + index * index).sqrt());
        let alpha = 1.0 - r * r;
        let beta = 2.0 * (2.0 - alpha) - 4.0 * (1.0 - alpha).sqrt();
        assert_relative_eq!(
            filter.gain,
            SMatrix::from([[alpha, beta / period]]),
            max_relative = 1e-10
        );
        // The correction leaves the variance alpha V of the position.
        let corrected = (1.0 - filter.gain[0]) * filter.covariance[(0, 0)];
        assert_relative_eq!(corrected, alpha, max_relative = 1e-10);
    }
}
