///Parameters of [`DoublePendulum`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DoublePendulumParams {
    /// Mass of each plate.
    ///In kg.
    pub m: f64,
    /// Rotational inertia of each plate about its centre of mass.
    ///In kg m^2.
    pub inertia: f64,
    /// Distance from a plate's axle to its centre of mass.
    ///In m.
    pub c: f64,
    /// Distance between the two axles.
    ///In m.
    pub d: f64,
    /// Acceleration of gravity.
    ///In m/s^2.
    pub g: f64,
    /// Friction of the upper axle.
    ///In N m s.
    pub gamma1: f64,
    /// Friction of the lower axle.
    ///In N m s.
    pub gamma2: f64,
}
impl ::core::default::Default for DoublePendulumParams {
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    fn default() -> Self {
        Self {
            m: 1f64,
            inertia: 1f64,
            c: 1f64,
            d: 1f64,
            g: 9.8f64,
            gamma1: 0.1f64,
            gamma2: 0.1f64,
        }
    }
}
/// Two identical plates on axles with friction: Williams (2023), Eq. 22.
///
/**# Equations of motion

```text
A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints

A[theta1, theta1] = inertia + m*c^2 + m*d^2
A[theta1, theta2] = m*c*d*cos(theta1 - theta2)
A[theta2, theta2] = inertia + m*c^2
b[theta1] = m*c*d*dot(theta2)^2*sin(theta1 - theta2) + (m*c*g + m*d*g)*sin(theta1)
b[theta2] = m*c*g*sin(theta2) - m*c*d*dot(theta1)^2*sin(theta1 - theta2)
Q[theta1] = gamma2*dot(theta2) - (gamma1 + gamma2)*dot(theta1)
Q[theta2] = gamma2*dot(theta1) - gamma2*dot(theta2)
```

# Constants, computed by `new`

```text
k0 = gamma2
k1 = inertia + m*c^2
k2 = inertia + m*c^2 + m*d^2
k3 = m*c*d
k4 = m*c*g
k5 = m*c*g + m*d*g
k6 = gamma1 + gamma2
k7 = 2*m*inertia*c^2 + m*inertia*d^2 + m^2*c^4 + inertia^2
k8 = 0.5*(inertia + m*c^2 + m*d^2)
k9 = 0.5*(inertia + m*c^2)
```
*/
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DoublePendulum<T = f64> {
    params: DoublePendulumParams,
    constants: [T; 10],
}
#[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
impl DoublePendulum {
    /// Builds the model: checks the parameters, and computes once whatever depends on them alone.
    ///
    /// # Errors
    ///
    /// The first parameter, or combination of parameters, that is not finite or that no rigid body can have.
    pub fn new(
        params: DoublePendulumParams,
    ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
        #[inline]
        fn rules<T: ::pendulum_core::real::Real>(given: [T; 7]) -> [T; 4] {
            let [p_m, p_inertia, p_c, p_d, p_g, p_gamma1, p_gamma2] = given;
            [p_m, p_inertia, p_gamma1, p_gamma2]
        }
        #[inline]
        fn constants<T: ::pendulum_core::real::Real>(given: [T; 7]) -> [T; 10] {
            let [p_m, p_inertia, p_c, p_d, p_g, p_gamma1, p_gamma2] = given;
            let t0 = p_c * p_c;
            let t1 = p_m * t0;
            let t2 = p_inertia + t1;
            let t3 = p_d * p_d;
            let t4 = p_inertia + (t1 + p_m * t3);
            let t5 = p_m * p_c;
            let t6 = p_g * t5;
            let t7 = t0 * (p_inertia * (T::from_f64(2.0) * p_m)) + t3 * (p_m * p_inertia)
                + p_m * p_m * (p_c * p_c * p_c * p_c);
            [
                p_gamma2,
                t2,
                t4,
                p_d * t5,
                t6,
                t6 + p_g * (p_m * p_d),
                p_gamma1 + p_gamma2,
                t7 + p_inertia * p_inertia,
                T::from_f64(0.5) * t4,
                T::from_f64(0.5) * t2,
            ]
        }
        let given: [f64; 7] = [
            params.m,
            params.inertia,
            params.c,
            params.d,
            params.g,
            params.gamma1,
            params.gamma2,
        ];
        let names: [&'static str; 7] = [
            "m",
            "inertia",
            "c",
            "d",
            "g",
            "gamma1",
            "gamma2",
        ];
        for (name, value) in names.into_iter().zip(given) {
            if !value.is_finite() {
                return Err(::pendulum_core::ParameterError {
                    name,
                    value,
                    rule: "a parameter must be finite",
                });
            }
        }
        let [r0, r1, r2, r3] = rules(given);
        if !(r0 > 0.0) {
            return Err(::pendulum_core::ParameterError {
                name: "m",
                value: r0,
                rule: "the mass of `plate` must be positive",
            });
        }
        if !(r1 >= 0.0) {
            return Err(::pendulum_core::ParameterError {
                name: "inertia",
                value: r1,
                rule: "the inertia of `plate` must not be negative",
            });
        }
        if !(r2 >= 0.0) {
            return Err(::pendulum_core::ParameterError {
                name: "gamma1",
                value: r2,
                rule: "the friction of `upper` must not be negative",
            });
        }
        if !(r3 >= 0.0) {
            return Err(::pendulum_core::ParameterError {
                name: "gamma2",
                value: r3,
                rule: "the friction of `lower` must not be negative",
            });
        }
        let constants = constants(given);
        let names: [&'static str; 10] = [
            "gamma2",
            "inertia + m*c^2",
            "inertia + m*c^2 + m*d^2",
            "m*c*d",
            "m*c*g",
            "m*c*g + m*d*g",
            "gamma1 + gamma2",
            "2*m*inertia*c^2 + m*inertia*d^2 + m^2*c^4 + inertia^2",
            "0.5*(inertia + m*c^2 + m*d^2)",
            "0.5*(inertia + m*c^2)",
        ];
        for (name, value) in names.into_iter().zip(constants) {
            if !value.is_finite() {
                let rule = "this combination of parameters must be finite: a divisor is zero, or a coordinate has no inertia";
                return Err(::pendulum_core::ParameterError {
                    name,
                    value,
                    rule,
                });
            }
        }
        Ok(Self { params, constants })
    }
    /// The same model in another number type, such as `f32`. Its constants are computed in double precision and
    /// then rounded.
    pub fn cast<T: ::pendulum_core::real::Real>(&self) -> DoublePendulum<T> {
        DoublePendulum {
            params: self.params,
            constants: self.constants.map(T::from_f64),
        }
    }
}
#[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
impl<T: ::pendulum_core::real::Real> DoublePendulum<T> {
    /// The parameters that the model was built from.
    pub fn params(&self) -> &DoublePendulumParams {
        &self.params
    }
}
impl DoublePendulum {
    /// The number of degrees of freedom; the state has twice as many components.
    pub const DOF: usize = 2;
    /// The names of the coordinates, in the order in which they, and then their rates, stand in the state.
    pub const COORDINATES: [&'static str; 2] = ["theta1", "theta2"];
    /// Counted operations of each generated function.
    pub const COST: ::pendulum_core::Cost = ::pendulum_core::Cost {
        rhs: ::pendulum_core::Operations {
            additions: 11,
            multiplications: 21,
            divisions: 1,
            sincos: 2,
            functions: 0,
        },
        jacobian: ::pendulum_core::Operations {
            additions: 28,
            multiplications: 50,
            divisions: 1,
            sincos: 2,
            functions: 0,
        },
        kinetic: ::pendulum_core::Operations {
            additions: 3,
            multiplications: 6,
            divisions: 0,
            sincos: 1,
            functions: 0,
        },
        potential: ::pendulum_core::Operations {
            additions: 2,
            multiplications: 2,
            divisions: 0,
            sincos: 2,
            functions: 0,
        },
        ..::pendulum_core::Cost::ZERO
    };
    /// The equations of motion as text.
    pub const EQUATIONS: &'static str = "A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints\n\nA[theta1, theta1] = inertia + m*c^2 + m*d^2\nA[theta1, theta2] = m*c*d*cos(theta1 - theta2)\nA[theta2, theta2] = inertia + m*c^2\nb[theta1] = m*c*d*dot(theta2)^2*sin(theta1 - theta2) + (m*c*g + m*d*g)*sin(theta1)\nb[theta2] = m*c*g*sin(theta2) - m*c*d*dot(theta1)^2*sin(theta1 - theta2)\nQ[theta1] = gamma2*dot(theta2) - (gamma1 + gamma2)*dot(theta1)\nQ[theta2] = gamma2*dot(theta1) - gamma2*dot(theta2)\n";
}
#[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
impl<T: ::pendulum_core::real::Real> ::pendulum_core::System<T, 4>
for DoublePendulum<T> {
    #[inline]
    fn rhs(
        &self,
        t: T,
        x: &::pendulum_core::nalgebra::SVector<T, 4>,
    ) -> ::pendulum_core::nalgebra::SVector<T, 4> {
        let [q_theta1, q_theta2, qd_theta1, qd_theta2] = x.data.0[0];
        let k0 = self.constants[0];
        let k1 = self.constants[1];
        let k2 = self.constants[2];
        let k3 = self.constants[3];
        let k4 = self.constants[4];
        let k5 = self.constants[5];
        let k6 = self.constants[6];
        let k7 = self.constants[7];
        let (sin_theta1, cos_theta1) = q_theta1.sin_cos();
        let (sin_theta2, cos_theta2) = q_theta2.sin_cos();
        let t0 = k3 * (sin_theta1 * cos_theta2 - cos_theta1 * sin_theta2);
        let t1 = T::from_f64(-1.0) / (k7 + t0 * t0);
        let t2 = k5 * sin_theta1 + k6 * qd_theta1 + qd_theta2 * (qd_theta2 * t0 - k0);
        let t3 = k3 * (cos_theta2 * cos_theta1 + sin_theta1 * sin_theta2);
        let t4 = k4 * sin_theta2 + k0 * qd_theta2 - qd_theta1 * (k0 + qd_theta1 * t0);
        ::pendulum_core::nalgebra::SVector::from([
            qd_theta1,
            qd_theta2,
            t1 * (k1 * t2 - t3 * t4),
            t1 * (k2 * t4 - t2 * t3),
        ])
    }
}
#[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
impl<T: ::pendulum_core::real::Real> ::pendulum_core::Jacobian<T, 4>
for DoublePendulum<T> {
    #[inline]
    fn jacobian(
        &self,
        t: T,
        x: &::pendulum_core::nalgebra::SVector<T, 4>,
    ) -> ::pendulum_core::nalgebra::SMatrix<T, 4, 4> {
        let [q_theta1, q_theta2, qd_theta1, qd_theta2] = x.data.0[0];
        let k0 = self.constants[0];
        let k1 = self.constants[1];
        let k2 = self.constants[2];
        let k3 = self.constants[3];
        let k4 = self.constants[4];
        let k5 = self.constants[5];
        let k6 = self.constants[6];
        let k7 = self.constants[7];
        let (sin_theta1, cos_theta1) = q_theta1.sin_cos();
        let (sin_theta2, cos_theta2) = q_theta2.sin_cos();
        let t0 = sin_theta1 * cos_theta2 - cos_theta1 * sin_theta2;
        let t1 = k3 * t0;
        let t2 = T::from_f64(-1.0) / (k7 + t1 * t1);
        let t3 = k1 * t2;
        let t4 = k3 * qd_theta2;
        let t5 = cos_theta2 * cos_theta1 + sin_theta1 * sin_theta2;
        let t6 = k3 * qd_theta1;
        let t7 = k0 + t0 * t6;
        let t8 = k4 * sin_theta2 + k0 * qd_theta2 - qd_theta1 * t7;
        let t9 = k2 * t2;
        let t10 = t0 * t4 - k0;
        let t11 = k5 * sin_theta1 + k6 * qd_theta1 + qd_theta2 * t10;
        let t12 = k3 * t2 * t5;
        let t13 = qd_theta2 * t4 * t5 - (t8 * t9 - t11 * t12) * t1;
        let t14 = k5 * cos_theta1 + t13;
        let t15 = t5 * qd_theta1 * t6 + t1 * (t3 * t11 - t8 * t12);
        let t16 = t15 + k4 * cos_theta2;
        let t17 = t7 + qd_theta1 * t1;
        let t18 = t10 + qd_theta2 * t1;
        ::pendulum_core::nalgebra::SMatrix::from([
            [
                T::from_f64(0.0),
                T::from_f64(0.0),
                t3 * t14 + t12 * t15,
                -(t9 * t15 + t12 * t14),
            ],
            [
                T::from_f64(0.0),
                T::from_f64(0.0),
                -(t3 * t13 + t12 * t16),
                t9 * t16 + t12 * t13,
            ],
            [
                T::from_f64(1.0),
                T::from_f64(0.0),
                k6 * t3 + t12 * t17,
                -(t9 * t17 + k6 * t12),
            ],
            [
                T::from_f64(0.0),
                T::from_f64(1.0),
                t3 * t18 - k0 * t12,
                k0 * t9 - t12 * t18,
            ],
        ])
    }
}
#[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
impl<T: ::pendulum_core::real::Real> ::pendulum_core::Energy<T, 4>
for DoublePendulum<T> {
    #[inline]
    fn kinetic(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 4>) -> T {
        let [q_theta1, q_theta2, qd_theta1, qd_theta2] = x.data.0[0];
        let k1 = self.constants[1];
        let k2 = self.constants[2];
        let k3 = self.constants[3];
        let k8 = self.constants[8];
        let k9 = self.constants[9];
        let (_, cos0) = (q_theta1 - q_theta2).sin_cos();
        k9 * qd_theta2 * qd_theta2 + qd_theta1 * (k3 * qd_theta2 * cos0 + k8 * qd_theta1)
    }
    #[inline]
    fn potential(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 4>) -> T {
        let [q_theta1, q_theta2, _, _] = x.data.0[0];
        let k4 = self.constants[4];
        let k5 = self.constants[5];
        let (_, cos_theta1) = q_theta1.sin_cos();
        let (_, cos_theta2) = q_theta2.sin_cos();
        -(k5 * cos_theta1 + k4 * cos_theta2)
    }
}
