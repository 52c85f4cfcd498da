//! Loss functions.

/// The loss of a residual `z`, measured in standard deviations of the noise. Robust losses grow more slowly than the
/// square, so that outliers have less influence. Each argument is the residual at which a loss departs from the square.
///
/// P. J. Huber, E. M. Ronchetti, "Robust Statistics", 2nd ed. (2009); names as in SciPy's `least_squares`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Loss {
    /// `z^2`: least squares.
    #[default]
    Squares,
    /// `z^2` up to `c`, then `2 c |z| - c^2`.
    Huber(f64),
    /// `2 c^2 (sqrt(1 + (z/c)^2) - 1)`, which is smooth.
    SoftL1(f64),
    /// `c^2 ln(1 + (z/c)^2)`, which nearly ignores distant outliers.
    Cauchy(f64),
}

impl Loss {
    /// The loss, and its derivative with respect to `z^2`, which is the weight of the residual.
    pub(super) fn of(self, z: f64) -> [f64; 2] {
        let square = z * z;
        match self {
            Self::Squares => [square, 1.0],
            Self::Huber(c) if z.abs() <= c => [square, 1.0],
            Self::Huber(c) => [2.0 * c * z.abs() - c * c, c / z.abs()],
            Self::SoftL1(c) => {
                let root = (1.0 + square / (c * c)).sqrt();
                // without the cancellation of `root - 1`
                [2.0 * square / (root + 1.0), 1.0 / root]
            }
            Self::Cauchy(c) => {
                let ratio = square / (c * c);
                [c * c * libm::log1p(ratio), 1.0 / (1.0 + ratio)]
            }
        }
    }

    /// Second derivative of half the loss by `z`.
    pub(super) fn curvature(self, z: f64) -> f64 {
        let part = |c: f64| z * z / (c * c);
        match self {
            Self::Huber(c) if z.abs() > c => 0.0,
            Self::Squares | Self::Huber(_) => 1.0,
            Self::SoftL1(c) => {
                let root = (1.0 + part(c)).sqrt();
                1.0 / (root * root * root)
            }
            Self::Cauchy(c) => {
                let whole = 1.0 + part(c);
                (2.0 - whole) / (whole * whole)
            }
        }
    }

    /// The residual at which the loss departs from the square, if it does.
    pub(super) fn threshold(self) -> Option<f64> {
        match self {
            Self::Squares => None,
            Self::Huber(c) | Self::SoftL1(c) | Self::Cauchy(c) => Some(c),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Loss;

    #[test]
    fn weights_are_derivatives_by_the_square() {
        for loss in [Loss::Squares, Loss::Huber(1.5), Loss::SoftL1(1.5), Loss::Cauchy(1.5)] {
            for z in [-7.0, -1.4, -1e-3, 0.2, 1.6, 30.0_f64] {
                let square = z * z;
                let at = |square: f64| loss.of(square.sqrt())[0];
                let h = 1e-6 * square;
                let slope = (at(square + h) - at(square - h)) / (2.0 * h);
                assert!((loss.of(z)[1] - slope).abs() < 1e-8, "{loss:?} at {z}");
                let bent = (loss.of(z + 1e-5)[1] * (z + 1e-5) - loss.of(z - 1e-5)[1] * (z - 1e-5)) / 2e-5;
                assert!((loss.curvature(z) - bent).abs() < 1e-8, "{loss:?} at {z}");
                assert!(loss.of(z)[0] <= square * (1.0 + 1e-15));
            }
            assert_eq!(loss.of(0.0), [0.0, 1.0]);
        }
    }
}
