//! Characteristic polynomial of small motions about the equilibria, derived by hand: independent of the generated
//! Jacobian and of matrix eigenvalues.

use testbed::printed::Pendulum;

/// `det(M lambda^2 + D lambda + K)` by descending powers of `lambda`, where each plate hangs (`1.0`) or stands
/// (`-1.0`).
///
/// With `M = [[I + 2 m d^2, +-m d^2], [.., I + m d^2]]`, `D = [[gamma1 + gamma2, -gamma2], [-gamma2, gamma2]]`, and
/// `K = diag(+-2 m g d, +-m g d)`.
pub(crate) fn characteristic(p: &Pendulum, [upper, lower]: [f64; 2]) -> [f64; 5] {
    let md2 = p.m * p.d * p.d;
    let (m11, m12, m22) = (p.inertia + 2.0 * md2, upper * lower * md2, p.inertia + md2);
    let (d11, d12, d22) = (p.gamma1 + p.gamma2, -p.gamma2, p.gamma2);
    let (k1, k2) = (upper * 2.0 * p.m * p.g * p.d, lower * p.m * p.g * p.d);
    [
        m11 * m22 - m12 * m12,
        m11 * d22 + m22 * d11 - 2.0 * m12 * d12,
        m11 * k2 + m22 * k1 + d11 * d22 - d12 * d12,
        d11 * k2 + d22 * k1,
        k1 * k2,
    ]
}

/// Largest real root, if no root has a larger real part: Newton's iteration converges to it from above all roots.
pub(crate) fn largest_root(a: [f64; 5]) -> f64 {
    let value = |x: f64| a.iter().fold(0.0, |sum, c| sum * x + c);
    let slope = |x: f64| (0..4).fold(0.0, |sum, n| sum * x + (4 - n) as f64 * a[n]);
    // Cauchy's bound
    let mut x = 1.0 + a.iter().fold(0.0_f64, |most, c| most.max((c / a[0]).abs()));
    loop {
        let next = x - value(x) / slope(x);
        if next >= x {
            return x;
        }
        x = next;
    }
}

/// True if all roots have negative real parts (Routh and Hurwitz).
pub(crate) fn is_stable([a4, a3, a2, a1, a0]: [f64; 5]) -> bool {
    [a4, a3, a2, a1, a0].iter().all(|&a| a > 0.0) && a3 * a2 * a1 > a4 * a1 * a1 + a3 * a3 * a0
}
