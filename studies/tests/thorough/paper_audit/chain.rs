//! Chains of revolute joints with bodies made of point masses: A, B and C by screws, as printed and as corrected, and
//! computed from the point masses without screws.

use nalgebra::{DMatrix, DVector, Matrix3, Matrix6, Unit, UnitQuaternion, Vector3, Vector6};

/// Body and its joint, at zero angles, in the ground frame.
pub(crate) struct Body {
    pub(crate) axis: Vector3<f64>,
    pub(crate) through: Vector3<f64>,
    /// Masses with their positions.
    pub(crate) points: Vec<(f64, Vector3<f64>)>,
}

pub(crate) struct Chain {
    pub(crate) bodies: Vec<Body>,
    /// Acceleration of gravity.
    pub(crate) gravity: Vector3<f64>,
}

/// The paper's pendulum, each plate as two points beside its centre of mass: `m = I = d = 1`, `g = 9.8`; the distance
/// from a joint to the centre of mass is `c`.
pub(crate) fn pendulum(c: f64) -> Chain {
    let plate = |axle: f64| Body {
        axis: Vector3::z(),
        through: Vector3::new(0.0, -axle, 0.0),
        points: vec![
            (0.5, Vector3::new(1.0, -axle - c, 0.0)),
            (0.5, Vector3::new(-1.0, -axle - c, 0.0)),
        ],
    };
    Chain {
        bodies: vec![plate(0.0), plate(1.0)],
        gravity: Vector3::new(0.0, -9.8, 0.0),
    }
}

/// Three bodies on skew axes.
pub(crate) fn arm() -> Chain {
    let body = |axis: [f64; 3], through: [f64; 3], shift: f64| Body {
        axis: Vector3::from(axis).normalize(),
        through: Vector3::from(through),
        points: (0..4)
            .map(|n| {
                let n = f64::from(n);
                let offset = Vector3::new((2.0 * n + shift).sin(), (3.0 * n).cos(), (1.0 + n * shift).sin());
                (0.5 + 0.2 * n, Vector3::from(through) + 0.4 * offset)
            })
            .collect(),
    };
    Chain {
        bodies: vec![
            body([0.0, 0.2, 1.0], [0.0, 0.0, 0.0], 0.3),
            body([1.0, -0.5, 0.1], [0.1, 0.2, 0.5], 0.7),
            body([0.3, 1.0, 0.4], [0.6, 0.1, 0.9], 1.1),
        ],
        gravity: Vector3::new(0.0, -1.0, -9.8),
    }
}

/// Displacement of central differences, for which half of the digits remain.
const REACH: f64 = 1e-5;

impl Chain {
    pub(crate) fn dof(&self) -> usize {
        self.bodies.len()
    }

    /// Position at the joint angles `q` of a point `p` of a body.
    fn place(&self, body: usize, p: Vector3<f64>, q: &DVector<f64>) -> Vector3<f64> {
        (0..=body).rev().fold(p, |p, joint| {
            let Body { axis, through, .. } = &self.bodies[joint];
            through + self.turn(joint, axis, q) * (p - through)
        })
    }

    fn turn(&self, joint: usize, axis: &Vector3<f64>, q: &DVector<f64>) -> UnitQuaternion<f64> {
        UnitQuaternion::from_axis_angle(&Unit::new_normalize(*axis), q[joint])
    }

    /// Point masses with the derivatives of their positions by the joint angles.
    fn slopes(&self, q: &DVector<f64>) -> Vec<(f64, Vec<Vector3<f64>>)> {
        let points = self.bodies.iter().enumerate();
        let points = points.flat_map(|(body, Body { points, .. })| points.iter().map(move |&point| (body, point)));
        points
            .map(|(body, (mass, p))| {
                let slope = |joint| difference(q, joint, |q| self.place(body, p, q));
                (mass, (0..self.dof()).map(slope).collect())
            })
            .collect()
    }

    /// Mass matrix from the kinetic energy of the points, `sum m v^2 / 2`.
    pub(crate) fn mass_matrix_of_points(&self, q: &DVector<f64>) -> DMatrix<f64> {
        let slopes = self.slopes(q);
        let entry = |i: usize, j: usize| slopes.iter().map(|(m, slope)| m * slope[i].dot(&slope[j])).sum();
        DMatrix::from_fn(self.dof(), self.dof(), entry)
    }

    /// Derivatives of the potential energy of the points.
    pub(crate) fn slope_of_potential(&self, q: &DVector<f64>) -> DVector<f64> {
        let slopes = self.slopes(q);
        let entry = |i: usize, _| slopes.iter().map(|(m, slope)| -m * self.gravity.dot(&slope[i])).sum();
        DVector::from_fn(self.dof(), entry)
    }

    /// Velocity, per unit of joint velocity, of a point of the body that the joint carries, and the position of the
    /// point.
    pub(crate) fn carried(&self, joint: usize, q: &DVector<f64>) -> (Vector3<f64>, Vector3<f64>) {
        let p = self.bodies[joint].points[0].1;
        let velocity = difference(q, joint, |q| self.place(joint, p, q));
        (velocity, self.place(joint, p, q))
    }

    /// Joint screws `(w; p x w)`.
    pub(crate) fn screws(&self, q: &DVector<f64>) -> Vec<Vector6<f64>> {
        let screw = |joint: usize| {
            let Body { axis, through, .. } = &self.bodies[joint];
            let axis = (0..joint).rev().fold(*axis, |axis, outer| {
                self.turn(outer, &self.bodies[outer].axis, q) * axis
            });
            let at = self.place(joint, *through, q);
            stack(axis, at.cross(&axis))
        };
        (0..self.dof()).map(screw).collect()
    }

    /// Spatial inertia of each body about the origin.
    pub(crate) fn inertias(&self, q: &DVector<f64>) -> Vec<Matrix6<f64>> {
        let bodies = self.bodies.iter().enumerate();
        bodies
            .map(|(body, Body { points, .. })| {
                let point = |&(mass, p): &(f64, Vector3<f64>)| {
                    let cross = self.place(body, p, q).cross_matrix();
                    let mut n = Matrix6::zeros();
                    n.fixed_view_mut::<3, 3>(0, 0)
                        .copy_from(&(mass * cross * cross.transpose()));
                    n.fixed_view_mut::<3, 3>(0, 3).copy_from(&(mass * cross));
                    n.fixed_view_mut::<3, 3>(3, 0).copy_from(&(mass * cross.transpose()));
                    n.fixed_view_mut::<3, 3>(3, 3).copy_from(&(mass * Matrix3::identity()));
                    n
                };
                points.iter().map(point).sum()
            })
            .collect()
    }

    /// Total inertia of a body and of all bodies that it carries.
    fn carried_inertia(&self, body: usize, q: &DVector<f64>) -> Matrix6<f64> {
        self.inertias(q)[body..].iter().sum()
    }

    /// Corrected Eq. 17: the inertia carried by the outer one of both bodies.
    pub(crate) fn eq17(&self, q: &DVector<f64>) -> DMatrix<f64> {
        let s = self.screws(q);
        let entry = |i: usize, j: usize| s[i].dot(&(self.carried_inertia(i.max(j), q) * s[j]));
        DMatrix::from_fn(self.dof(), self.dof(), entry)
    }

    /// Eq. 17 as printed: the inertia of all bodies in every entry.
    pub(crate) fn eq17_printed(&self, q: &DVector<f64>) -> DMatrix<f64> {
        let s = self.screws(q);
        let all = self.carried_inertia(0, q);
        DMatrix::from_fn(self.dof(), self.dof(), |i, j| s[i].dot(&(all * s[j])))
    }

    /// Corrected Eq. 18: for `j <= k`, and symmetric in `j` and `k`.
    pub(crate) fn eq18(&self, q: &DVector<f64>, i: usize, j: usize, k: usize) -> f64 {
        self.eq18_printed(q, i, j.min(k), j.max(k))
    }

    /// Eq. 18 as printed: the same expression for all `j` and `k`.
    pub(crate) fn eq18_printed(&self, q: &DVector<f64>, i: usize, j: usize, k: usize) -> f64 {
        let s = self.screws(q);
        let n = self.carried_inertia(i.max(j).max(k), q);
        let term = |a: usize, b: usize, c: usize| s[a].dot(&(n * bracket(&s[b], &s[c])));
        0.5 * (term(j, i, k) + term(k, i, j) - term(i, k, j))
    }

    /// Christoffel symbols of the mass matrix: `B_ijk = (dA_ij/dq_k + dA_ik/dq_j - dA_jk/dq_i) / 2`.
    pub(crate) fn christoffel(&self, q: &DVector<f64>) -> impl Fn(usize, usize, usize) -> f64 {
        let slopes: Vec<DMatrix<f64>> = (0..self.dof()).map(|k| difference(q, k, |q| self.eq17(q))).collect();
        move |i, j, k| 0.5 * (slopes[k][(i, j)] + slopes[j][(i, k)] - slopes[i][(j, k)])
    }

    /// Corrected Eq. 19: `- s_i^T N_i^+ (0; g)`, where `g` is the acceleration of gravity and points down.
    pub(crate) fn eq19(&self, q: &DVector<f64>) -> DVector<f64> {
        -self.eq19_printed(q)
    }

    /// Eq. 19 as printed: `+ s_i^T N_i^+ (0; g)` with `g` pointing down.
    pub(crate) fn eq19_printed(&self, q: &DVector<f64>) -> DVector<f64> {
        let s = self.screws(q);
        let g = stack(Vector3::zeros(), self.gravity);
        DVector::from_fn(self.dof(), |i, _| s[i].dot(&(self.carried_inertia(i, q) * g)))
    }
}

fn difference<V>(q: &DVector<f64>, joint: usize, f: impl Fn(&DVector<f64>) -> V) -> V
where
    V: std::ops::Sub<Output = V> + std::ops::Div<f64, Output = V>,
{
    let at = |reach: f64| {
        let mut q = q.clone();
        q[joint] += reach;
        f(&q)
    };
    (at(REACH) - at(-REACH)) / (2.0 * REACH)
}

fn stack(angular: Vector3<f64>, linear: Vector3<f64>) -> Vector6<f64> {
    Vector6::new(angular.x, angular.y, angular.z, linear.x, linear.y, linear.z)
}

/// Lie bracket `[a, b] = (a_w x b_w ; a_v x b_w + a_w x b_v)`.
fn bracket(a: &Vector6<f64>, b: &Vector6<f64>) -> Vector6<f64> {
    let [aw, av, bw, bv] = [(a, 0), (a, 3), (b, 0), (b, 3)].map(|(s, n)| s.fixed_rows::<3>(n).into_owned());
    stack(aw.cross(&bw), av.cross(&bw) + aw.cross(&bv))
}
