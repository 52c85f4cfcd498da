//! Dense output from the slopes at the ends of a step, for methods whose stages are of lower order than their ends.

use nalgebra::SVector;

use crate::dense::{Step, polynomial};
use crate::real::Float;
use crate::statistics::Statistics;
use crate::system::System;

/// Coefficients, from the first power on, of the cubic through the states and slopes of both ends: of order 3.
///
/// Slopes are derivatives by the fraction of the step.
pub(super) fn cubic<S, T, const N: usize>(system: &S, step: &Step<T, N>, work: &mut Statistics) -> [SVector<T, N>; 3]
where
    S: System<T, N> + ?Sized,
    T: Float,
{
    work.evaluations += 2;
    let [two, three] = [2.0, 3.0].map(T::from_f64);
    let first = system.rhs(step.t0, &step.x0) * step.h;
    let last = system.rhs(step.t1, &step.x1) * step.h;
    let change = step.x1 - step.x0;
    [first, change * three - first * two - last, first + last - change * two]
}

/// Coefficients of the quintic that also has the slopes of the system at two interior points: of order 5.
///
/// It is the cubic plus `theta^2 (1 - theta)^2 (alpha + beta theta)`. The slopes are evaluated at states of the
/// previous polynomial, twice, and each pass raises the order by one (W. H. Enright, K. R. Jackson, S. P. Norsett, P.
/// G. Thomsen, "Interpolants for Runge-Kutta formulas", ACM TOMS 12 (1986) 193-218).
pub(super) fn quintic<S, T, const N: usize>(system: &S, step: &Step<T, N>, work: &mut Statistics) -> [SVector<T, N>; 5]
where
    S: System<T, N> + ?Sized,
    T: Float,
{
    /// Distance of the outer Gauss nodes from the middle: `1/2 -+ sqrt(15)/10`, where `theta (1 - theta)` is 1/10.
    const OFFSET: f64 = 0.387_298_334_620_741_7;
    let [c1, c2, c3] = cubic(system, step, work);
    let mut coefficients = [
        c1,
        c2,
        c3,
        SVector::from_element(T::default()),
        SVector::from_element(T::default()),
    ];
    let [two, three] = [2.0, 3.0].map(T::from_f64);
    for _ in 0..2 {
        let [left, right] = [0.5 - OFFSET, 0.5 + OFFSET].map(|theta| {
            let theta = T::from_f64(theta);
            let x = polynomial(&step.x0, &coefficients, theta);
            let slope = system.rhs(step.t0 + theta * step.h, &x) * step.h;
            slope - (c1 + (c2 * two + c3 * (three * theta)) * theta)
        });
        work.evaluations += 2;
        // with u = theta (1 - theta) the slopes require 2 u (5 u - 1) beta = left + right and 2 u (1 - 2 theta) (2
        // alpha + beta) = left - right
        let beta = (left + right) * T::from_f64(-10.0);
        let alpha = ((left - right) * T::from_f64(2.5 / OFFSET) - beta) * T::from_f64(0.5);
        coefficients[1] = c2 + alpha;
        coefficients[2] = c3 + beta - alpha * two;
        coefficients[3] = alpha - beta * two;
        coefficients[4] = beta;
    }
    coefficients
}
