//! Eq. 20, 22 and 24 to 26 for two equal plates with `c = d`, each as printed and as corrected.
//!
//! The name of each form states its error. Eq. 25 is implemented as printed for plates of 1 kg, where powers of `m`
//! make no difference. The other misprints of Eq. 25 and 26 are variants: the correct linearisation with one of the
//! misprints each.

use nalgebra::{Matrix2, SMatrix, SVector, Vector2};

/// Parameters of the pendulum of the paper, with the friction of the upper and of the lower joint.
#[derive(Clone, Copy, Debug)]
pub struct Pendulum {
    pub m: f64,
    pub inertia: f64,
    pub d: f64,
    pub g: f64,
    pub gamma1: f64,
    pub gamma2: f64,
}

impl Pendulum {
    /// Values of the paper's Fig. 2, with the friction of each joint.
    pub fn paper(gamma1: f64, gamma2: f64) -> Self {
        Self {
            m: 1.0,
            inertia: 1.0,
            d: 1.0,
            g: 9.8,
            gamma1,
            gamma2,
        }
    }

    /// Corrected Eq. 22: the derivative of `x = (theta1, theta2, omega1, omega2)`.
    pub fn eq22(&self, x: &SVector<f64, 4>) -> SVector<f64, 4> {
        let turn = self.turn(x);
        self.rhs(x, Vector2::new(turn * x[3] * x[3], -turn * x[2] * x[2]))
    }

    /// Eq. 22b as printed: `- m d^2 theta2'^2 sin(theta1 - theta2)`.
    pub fn eq22b_printed(&self, x: &SVector<f64, 4>) -> SVector<f64, 4> {
        let turn = self.turn(x);
        self.rhs(x, Vector2::new(turn * x[3] * x[3], -turn * x[3] * x[3]))
    }

    /// Eq. 20 as printed: the rates are not squared.
    pub fn eq20_printed(&self, x: &SVector<f64, 4>) -> SVector<f64, 4> {
        let turn = self.turn(x);
        self.rhs(x, Vector2::new(turn * x[3], -turn * x[2]))
    }

    /// Residual (left side minus right side) of the two lines of Eq. 22, the second as printed, for given
    /// accelerations.
    pub fn eq22b_printed_residual(&self, x: &SVector<f64, 4>, accelerations: Vector2<f64>) -> Vector2<f64> {
        let turn = self.turn(x);
        let velocity = Vector2::new(turn * x[3] * x[3], -turn * x[3] * x[3]);
        self.mass_matrix(x[0] - x[1]) * accelerations + velocity + self.gravity(x) - self.friction(x)
    }

    fn turn(&self, x: &SVector<f64, 4>) -> f64 {
        self.m * self.d * self.d * (x[0] - x[1]).sin()
    }

    fn mass_matrix(&self, angle: f64) -> Matrix2<f64> {
        let md2 = self.m * self.d * self.d;
        let coupling = md2 * angle.cos();
        Matrix2::new(self.inertia + 2.0 * md2, coupling, coupling, self.inertia + md2)
    }

    fn gravity(&self, x: &SVector<f64, 4>) -> Vector2<f64> {
        let mgd = self.m * self.g * self.d;
        Vector2::new(2.0 * mgd * x[0].sin(), mgd * x[1].sin())
    }

    fn friction(&self, x: &SVector<f64, 4>) -> Vector2<f64> {
        let lower = self.gamma2 * (x[2] - x[3]);
        Vector2::new(-self.gamma1 * x[2] - lower, lower)
    }

    /// Solves `A theta'' + velocity + gravity = friction`.
    fn rhs(&self, x: &SVector<f64, 4>, velocity: Vector2<f64>) -> SVector<f64, 4> {
        let [[a11, a21], [a12, a22]] = self.mass_matrix(x[0] - x[1]).data.0;
        let force = self.friction(x) - velocity - self.gravity(x);
        let determinant = a11 * a22 - a12 * a21;
        SVector::from([
            x[2],
            x[3],
            (a22 * force[0] - a12 * force[1]) / determinant,
            (a11 * force[1] - a21 * force[0]) / determinant,
        ])
    }

    /// Corrected Eq. 25 and 26: state matrix of small motions about hanging.
    pub fn linear(&self) -> SMatrix<f64, 4, 4> {
        self.state_matrix(self.determinant(), self.damping(), self.stiffness())
    }

    /// With the sign of `gamma1 theta1'` as printed in Eq. 24a, with which the friction of the upper joint drives it.
    pub fn linear_with_sign_of_24a(&self) -> SMatrix<f64, 4, 4> {
        let mut damping = self.damping();
        damping[(0, 0)] = self.gamma2 - self.gamma1;
        self.state_matrix(self.determinant(), damping, self.stiffness())
    }

    /// Eq. 25 as printed for `m = 1`, entry by entry: friction in the denominator and in two more entries, and no
    /// damping by `gamma1`.
    pub fn eq25_printed(&self) -> SMatrix<f64, 4, 4> {
        let Self {
            m,
            inertia,
            d,
            g,
            gamma1,
            gamma2,
        } = *self;
        let md2 = d * d * m;
        let gravity = [
            [-2.0 * m * g * d * (md2 + inertia), m * m * g * d.powi(3)],
            [2.0 * m * m * g * d.powi(3), -m * g * d * (2.0 * md2 - gamma1 + inertia)],
        ];
        let (upper, lower) = (gamma2 * (2.0 * md2 + inertia), gamma2 * (3.0 * md2 - gamma1 + inertia));
        let friction = [[-upper, upper], [lower, -lower]];
        let denominator = self.determinant() - gamma1 * (md2 + inertia);
        SMatrix::from_fn(|row, column| match (row, column) {
            (0 | 1, _) => f64::from(u8::from(column == row + 2)),
            (_, 0 | 1) => gravity[row - 2][column] / denominator,
            (_, _) => friction[row - 2][column - 2] / denominator,
        })
    }

    /// With `m^2` in place of `m` in the torques of gravity.
    pub fn linear_with_m_squared(&self) -> SMatrix<f64, 4, 4> {
        self.state_matrix(self.determinant(), self.damping(), self.stiffness() * self.m)
    }

    /// With `m^3` in place of `m` in the torques of gravity.
    pub fn linear_with_m_cubed(&self) -> SMatrix<f64, 4, 4> {
        self.state_matrix(self.determinant(), self.damping(), self.stiffness() * self.m * self.m)
    }

    /// With the opposite sign of the gravity of the lower plate.
    pub fn linear_with_sign_of_gravity(&self) -> SMatrix<f64, 4, 4> {
        let mut stiffness = self.stiffness();
        stiffness[(1, 1)] = -stiffness[(1, 1)];
        self.state_matrix(self.determinant(), self.damping(), stiffness)
    }

    /// With the opposite sign of the friction of the lower joint in the second line.
    pub fn linear_with_sign_of_friction(&self) -> SMatrix<f64, 4, 4> {
        let mut damping = self.damping();
        damping[(1, 0)] = -damping[(1, 0)];
        damping[(1, 1)] = -damping[(1, 1)];
        self.state_matrix(self.determinant(), damping, self.stiffness())
    }

    fn determinant(&self) -> f64 {
        let Self { m, inertia, d, .. } = *self;
        d.powi(4) * m * m + 3.0 * d * d * m * inertia + inertia * inertia
    }

    fn damping(&self) -> Matrix2<f64> {
        let Self { gamma1, gamma2, .. } = *self;
        Matrix2::new(gamma1 + gamma2, -gamma2, -gamma2, gamma2)
    }

    fn stiffness(&self) -> Matrix2<f64> {
        let mgd = self.m * self.g * self.d;
        Matrix2::new(2.0 * mgd, 0.0, 0.0, mgd)
    }

    /// `theta'' = -adj(A) (damping theta' + stiffness theta) / determinant`.
    fn state_matrix(&self, determinant: f64, damping: Matrix2<f64>, stiffness: Matrix2<f64>) -> SMatrix<f64, 4, 4> {
        let a = self.mass_matrix(0.0);
        let adjugate = Matrix2::new(a[(1, 1)], -a[(0, 1)], -a[(1, 0)], a[(0, 0)]);
        let mut matrix = SMatrix::<f64, 4, 4>::zeros();
        matrix.fixed_view_mut::<2, 2>(0, 2).fill_with_identity();
        matrix
            .fixed_view_mut::<2, 2>(2, 0)
            .copy_from(&(-adjugate * stiffness / determinant));
        matrix
            .fixed_view_mut::<2, 2>(2, 2)
            .copy_from(&(-adjugate * damping / determinant));
        matrix
    }
}
