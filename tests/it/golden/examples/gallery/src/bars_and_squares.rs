#[allow(non_snake_case)]
mod __DoubleBar {
    ///Parameters of [`DoubleBar`].
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct DoubleBarParams {
        ///In kg.
        pub m: f64,
        ///In m.
        pub l: f64,
        ///In m/s^2.
        pub g: f64,
    }
    impl ::core::default::Default for DoubleBarParams {
        #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
        fn default() -> Self {
            Self {
                m: 0.8f64,
                l: 0.6f64,
                g: 9.81f64,
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl DoubleBarParams {
        /// The names of the parameters, in the order of their declaration.
        pub const NAMES: [&'static str; 3] = ["m", "l", "g"];
        /// The values of the parameters, in the order of [`NAMES`](Self::NAMES).
        pub const fn to_array(self) -> [f64; 3] {
            [self.m, self.l, self.g]
        }
        /// The parameters with these values, in the order of [`NAMES`](Self::NAMES).
        pub const fn from_array(values: [f64; 3]) -> Self {
            let [v0, v1, v2] = values;
            Self { m: v0, l: v1, g: v2 }
        }
    }
    /// Two equal rods.
    ///
    /**# Equations of motion

```text
A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints

A[theta1, theta1] = 4/3*m*l^2
A[theta1, theta2] = 0.5*m*l^2*cos(theta1 - theta2)
A[theta2, theta2] = 1/3*m*l^2
b[theta1] = 0.5*m*l^2*dot(theta2)^2*sin(theta1 - theta2) + 1.5*m*l*g*sin(theta1)
b[theta2] = 0.5*m*l*g*sin(theta2) - 0.5*m*l^2*dot(theta1)^2*sin(theta1 - theta2)
```

# Constants, computed by `new`

```text
k0 = m*l^2
k1 = 4/3*m*l^2
k2 = 0.5*m*l^2
k3 = 1/3*m*l^2
k4 = 1.5*m*l*g
k5 = 7/36*(m*l^2)^2
k6 = 0.25*(m*l^2)^2
k7 = 0.5*m*l*g
k8 = -1/(1/3*m*l^2)
k9 = -0.5/(1/3)
```
*/
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct DoubleBar<T = f64> {
        params: DoubleBarParams,
        constants: [T; 10],
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl DoubleBar {
        /// Builds the model: checks the parameters, and computes once whatever depends on them alone.
        ///
        /// # Errors
        ///
        /// The first parameter, or combination of parameters, that is not finite or that no rigid body can
        /// have.
        pub fn new(
            params: DoubleBarParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            #[inline]
            fn rules<T: ::pendulum_core::real::Real>(given: [T; 3]) -> [T; 1] {
                let [p_m, p_l, p_g] = given;
                [p_m]
            }
            #[inline]
            fn constants<T: ::pendulum_core::real::Real>(given: [T; 3]) -> [T; 10] {
                let [p_m, p_l, p_g] = given;
                let t0 = p_m * (p_l * p_l);
                let t1 = T::from_f64(1.3333333333333333) * t0;
                let t2 = T::from_f64(0.5) * t0;
                let t3 = T::from_f64(0.3333333333333333) * t0;
                let t4 = t0 * t0;
                let t5 = T::from_f64(0.19444444444444445) * t4;
                let t6 = T::from_f64(0.25) * t4;
                let t7 = T::from_f64(-1.0) / t3;
                let t8 = t2 * t7;
                let t9 = p_g * (p_m * p_l);
                let t10 = T::from_f64(1.5) * t9;
                let t11 = T::from_f64(0.5) * t9;
                [t0, t1, t2, t3, t10, t5, t6, t11, t7, t8]
            }
            let given = params.to_array();
            for (name, value) in DoubleBarParams::NAMES.into_iter().zip(given) {
                if !value.is_finite() {
                    return Err(
                        ::pendulum_core::ParameterError::new(
                            name,
                            value,
                            "a parameter must be finite",
                            &[],
                        ),
                    );
                }
            }
            let [r0] = rules(given);
            if !(r0 > 0.0) {
                return Err(
                    ::pendulum_core::ParameterError::new(
                        "m",
                        r0,
                        "the mass of a rod of `bar` must be positive",
                        &[],
                    ),
                );
            }
            let constants = constants(given);
            let names: [&'static str; 10] = [
                "m*l^2",
                "4/3*m*l^2",
                "0.5*m*l^2",
                "1/3*m*l^2",
                "1.5*m*l*g",
                "7/36*(m*l^2)^2",
                "0.25*(m*l^2)^2",
                "0.5*m*l*g",
                "-1/(1/3*m*l^2)",
                "-0.5/(1/3)",
            ];
            for (name, value) in names.into_iter().zip(constants) {
                if !value.is_finite() {
                    let given: [_; 3] = ::core::array::from_fn(|n| (
                        DoubleBarParams::NAMES[n],
                        given[n],
                    ));
                    return Err(
                        ::pendulum_core::ParameterError::new(
                            name,
                            value,
                            "a constant of the equations is not finite: a coordinate has no inertia, a divisor is zero, or a number is too large",
                            &given,
                        ),
                    );
                }
            }
            Ok(Self { params, constants })
        }
        /// The same model in another number type, such as `f32`. Its constants are computed in double precision
        /// and then rounded.
        pub fn cast<T: ::pendulum_core::real::Real>(&self) -> DoubleBar<T> {
            DoubleBar {
                params: self.params,
                constants: self.constants.map(T::from_f64),
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> DoubleBar<T> {
        /// The parameters that the model was built from.
        pub fn params(&self) -> &DoubleBarParams {
            &self.params
        }
        /// The model with other parameters, in the same number type. Its constants are computed anew.
        ///
        /// # Errors
        ///
        /// Those of `new`.
        pub fn with_params(
            &self,
            params: DoubleBarParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            Ok(<DoubleBar>::new(params)?.cast())
        }
    }
    impl DoubleBar {
        ///The place of `theta1` in the state, where it stands in rad.
        pub const THETA1: usize = 0;
        ///The place of `dot(theta1)` in the state, where it stands in rad/s.
        pub const DOT_THETA1: usize = 2;
        ///The place of `theta2` in the state, where it stands in rad.
        pub const THETA2: usize = 1;
        ///The place of `dot(theta2)` in the state, where it stands in rad/s.
        pub const DOT_THETA2: usize = 3;
        /// The number of degrees of freedom; the state has twice as many components.
        pub const DOF: usize = 2;
        /// The names of the coordinates, in the order in which they, and then their rates, stand in the state.
        pub const COORDINATES: [&'static str; 2] = ["theta1", "theta2"];
        /// Counted operations of each generated function, in the form that it has and in others.
        pub const COST: ::pendulum_core::Cost = ::pendulum_core::Cost::new(
            &[
                (
                    "rhs",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first, L^T D L",
                            ::pendulum_core::Operations::new(8, 18, 1, 2, 0, 32),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, L^T D L",
                                    ::pendulum_core::Operations::new(8, 18, 1, 2, 0, 32),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L",
                                    ::pendulum_core::Operations::new(8, 18, 1, 2, 0, 32),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, adjugate",
                                    ::pendulum_core::Operations::new(21, 28, 1, 2, 0, 37),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C, adjugate",
                                    ::pendulum_core::Operations::new(33, 40, 1, 2, 0, 37),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "articulated bodies",
                                    ::pendulum_core::Operations::new(24, 40, 2, 2, 0, 48),
                                ),
                            ],
                        ),
                ),
                (
                    "jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, expanded, inverse, derived and expanded",
                            ::pendulum_core::Operations::new(19, 44, 1, 2, 0, 38),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first, inverse, derived and expanded",
                                    ::pendulum_core::Operations::new(19, 48, 1, 2, 0, 40),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, inverse, derived and expanded",
                                    ::pendulum_core::Operations::new(19, 48, 1, 2, 0, 40),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, inverse, derived in the graph",
                                    ::pendulum_core::Operations::new(43, 59, 1, 2, 0, 49),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C, inverse, derived in the graph",
                                    ::pendulum_core::Operations::new(91, 95, 1, 2, 0, 44),
                                ),
                            ],
                        ),
                ),
                (
                    "mass_matrix",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(1, 1, 0, 1, 0, 22),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(1, 1, 0, 1, 0, 22),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(1, 1, 0, 1, 0, 22),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(14, 12, 0, 2, 0, 29),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C",
                                    ::pendulum_core::Operations::new(19, 16, 0, 2, 0, 30),
                                ),
                            ],
                        ),
                ),
            ],
        );
        /// What each part of the state is.
        pub const LAYOUT: ::pendulum_core::StateLayout = ::pendulum_core::StateLayout::new(
                &[
                    ::pendulum_core::Slot::new(
                            "theta1",
                            ::pendulum_core::SlotKind::Angle,
                            0..1,
                            2..3,
                        )
                        .periodic(),
                    ::pendulum_core::Slot::new(
                            "theta2",
                            ::pendulum_core::SlotKind::Angle,
                            1..2,
                            3..4,
                        )
                        .periodic(),
                ],
            )
            .autonomous();
        /// The equations of motion as text.
        pub const EQUATIONS: &'static str = "A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints\n\nA[theta1, theta1] = 4/3*m*l^2\nA[theta1, theta2] = 0.5*m*l^2*cos(theta1 - theta2)\nA[theta2, theta2] = 1/3*m*l^2\nb[theta1] = 0.5*m*l^2*dot(theta2)^2*sin(theta1 - theta2) + 1.5*m*l*g*sin(theta1)\nb[theta2] = 0.5*m*l*g*sin(theta2) - 0.5*m*l^2*dot(theta1)^2*sin(theta1 - theta2)\n";
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::System<T, 4> for DoubleBar<T> {
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn rhs(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 4> {
            let [q_theta1, q_theta2, qd_theta1, qd_theta2] = x.data.0[0];
            let k2 = self.constants[2];
            let k3 = self.constants[3];
            let k4 = self.constants[4];
            let k5 = self.constants[5];
            let k6 = self.constants[6];
            let k7 = self.constants[7];
            let k8 = self.constants[8];
            let k9 = self.constants[9];
            let [(sin_theta1, cos_theta1), (sin_theta2, cos_theta2)] = q_theta1
                .sin_cos_pair(q_theta2);
            let t0 = sin_theta1 * cos_theta2 - cos_theta1 * sin_theta2;
            let t1 = k2 * t0;
            let t2 = k7 * sin_theta2 - t1 * qd_theta1 * qd_theta1;
            let t3 = k9 * (cos_theta2 * cos_theta1 + sin_theta1 * sin_theta2);
            let t4 = k3 / (k5 + k6 * t0 * t0)
                * (k4 * sin_theta1 + t1 * qd_theta2 * qd_theta2 + t2 * t3);
            ::pendulum_core::nalgebra::SVector::from([
                qd_theta1,
                qd_theta2,
                -t4,
                k8 * t2 - t3 * t4,
            ])
        }
        #[inline]
        fn layout(
            &self,
        ) -> ::core::option::Option<&'static ::pendulum_core::StateLayout> {
            Some(&<DoubleBar>::LAYOUT)
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Jacobian<T, 4>
    for DoubleBar<T> {
        #[inline]
        fn jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SMatrix<T, 4, 4> {
            self.rhs_and_jacobian(t, x).1
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn rhs_and_jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 4>,
            ::pendulum_core::nalgebra::SMatrix<T, 4, 4>,
        ) {
            let [q_theta1, q_theta2, qd_theta1, qd_theta2] = x.data.0[0];
            let k0 = self.constants[0];
            let k1 = self.constants[1];
            let k2 = self.constants[2];
            let k3 = self.constants[3];
            let k4 = self.constants[4];
            let k5 = self.constants[5];
            let k6 = self.constants[6];
            let k7 = self.constants[7];
            let t0 = k2 * qd_theta2 * qd_theta2;
            let t1 = k2 * qd_theta1 * qd_theta1;
            let [(sin_theta1, cos_theta1), (sin_theta2, cos_theta2)] = q_theta1
                .sin_cos_pair(q_theta2);
            let t2 = sin_theta1 * cos_theta2 - cos_theta1 * sin_theta2;
            let t3 = k4 * sin_theta1 + t0 * t2;
            let t4 = T::from_f64(-1.0) / (k5 + k6 * t2 * t2);
            let t5 = k3 * t4;
            let t6 = cos_theta2 * cos_theta1 + sin_theta1 * sin_theta2;
            let t7 = k2 * t4 * t6;
            let t8 = k1 * t4;
            let t9 = k7 * sin_theta2 - t2 * t1;
            let t10 = t3 * t5 - t7 * t9;
            let t11 = t9 * t8 - t3 * t7;
            let t12 = k2 * t2;
            let t13 = t0 * t6 - t11 * t12;
            let t14 = t6 * t1 + t10 * t12;
            let t15 = k0 * t2;
            let t16 = k4 * cos_theta1 + t13;
            let t17 = t14 + k7 * cos_theta2;
            let t18 = t5 * t16 + t7 * t14;
            let t19 = -(t7 * t16 + t8 * t14);
            let t20 = -(t5 * t13 + t7 * t17);
            let t21 = t8 * t17 + t7 * t13;
            let t22 = qd_theta1 * t15;
            let t23 = -(t8 * t22);
            let t24 = t7 * t22;
            let t25 = qd_theta2 * t15;
            let t26 = t5 * t25;
            let t27 = -(t7 * t25);
            (
                ::pendulum_core::nalgebra::SVector::from([
                    qd_theta1,
                    qd_theta2,
                    t10,
                    t11,
                ]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [T::from_f64(0.0), T::from_f64(0.0), t18, t19],
                    [T::from_f64(0.0), T::from_f64(0.0), t20, t21],
                    [T::from_f64(1.0), T::from_f64(0.0), t24, t23],
                    [T::from_f64(0.0), T::from_f64(1.0), t26, t27],
                ]),
            )
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn time_derivative(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 4> {
            ::pendulum_core::nalgebra::SVector::from([
                T::from_f64(0.0),
                T::from_f64(0.0),
                T::from_f64(0.0),
                T::from_f64(0.0),
            ])
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> DoubleBar<T> {
        ///The mass matrix.
        #[inline]
        pub fn mass_matrix(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SMatrix<T, 2, 2> {
            let [q_theta1, q_theta2, _, _] = x.data.0[0];
            let k1 = self.constants[1];
            let k2 = self.constants[2];
            let k3 = self.constants[3];
            let (_, cos0) = (q_theta1 - q_theta2).sin_cos();
            let a0 = k1;
            let a1 = cos0 * k2;
            let a2 = k3;
            ::pendulum_core::nalgebra::SMatrix::from([[a0, a1], [a1, a2]])
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::CastJacobian<4> for DoubleBar {
        #[inline]
        fn with_jacobian<T: ::pendulum_core::real::Real>(
            model: &DoubleBar<T>,
        ) -> &impl ::pendulum_core::Jacobian<T, 4> {
            model
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::Cast<4> for DoubleBar {
        type In<T: ::pendulum_core::real::Real> = DoubleBar<T>;
        fn cast<T: ::pendulum_core::real::Real>(&self) -> DoubleBar<T> {
            DoubleBar::cast(self)
        }
        #[inline]
        fn gather<'m, T: ::pendulum_core::real::lanes::Lanes>(
            models: impl ::core::ops::Fn(usize) -> &'m Self,
        ) -> DoubleBar<T>
        where
            Self: 'm,
        {
            let scalar = <<T as ::pendulum_core::real::lanes::Lanes>::Scalar as ::pendulum_core::real::Real>::from_f64;
            DoubleBar {
                params: models(0).params,
                constants: ::core::array::from_fn(|k| {
                    <T as ::pendulum_core::real::lanes::Lanes>::from_fn(|lane| scalar(
                        models(lane).constants[k],
                    ))
                }),
            }
        }
    }
}
#[allow(unreachable_pub, unused_imports)]
pub use __DoubleBar::{DoubleBar, DoubleBarParams};

#[allow(non_snake_case)]
mod __DoubleSquare {
    ///Parameters of [`DoubleSquare`].
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct DoubleSquareParams {
        ///In kg.
        pub m: f64,
        ///In m.
        pub a: f64,
        ///In m/s^2.
        pub g: f64,
    }
    impl ::core::default::Default for DoubleSquareParams {
        #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
        fn default() -> Self {
            Self {
                m: 0.8f64,
                a: 0.5f64,
                g: 9.81f64,
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl DoubleSquareParams {
        /// The names of the parameters, in the order of their declaration.
        pub const NAMES: [&'static str; 3] = ["m", "a", "g"];
        /// The values of the parameters, in the order of [`NAMES`](Self::NAMES).
        pub const fn to_array(self) -> [f64; 3] {
            [self.m, self.a, self.g]
        }
        /// The parameters with these values, in the order of [`NAMES`](Self::NAMES).
        pub const fn from_array(values: [f64; 3]) -> Self {
            let [v0, v1, v2] = values;
            Self { m: v0, a: v1, g: v2 }
        }
    }
    /// Two equal squares of side `a`, each hung by a corner, the second from the opposite corner of the first.
    ///
    /**# Equations of motion

```text
A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints

A[theta1, theta1] = 8/3*m*a^2
A[theta1, theta2] = m*a^2*cos(theta1 - theta2)
A[theta2, theta2] = 2/3*m*a^2
b[theta1] = m*a^2*dot(theta2)^2*sin(theta1 - theta2) + 1.5*sqrt(2)*m*a*g*sin(theta1)
b[theta2] = 0.5*sqrt(2)*m*a*g*sin(theta2) - m*a^2*dot(theta1)^2*sin(theta1 - theta2)
```

# Constants, computed by `new`

```text
k0 = sqrt(2)*a
k1 = 0.5*sqrt(2)*a
k2 = m*a^2
k3 = 8/3*m*a^2
k4 = 2/3*m*a^2
k5 = 1.5*sqrt(2)*m*a*g
k6 = 0.5*sqrt(2)*m*a*g
k7 = 7/9*(m*a^2)^2
k8 = -1/(2/3*m*a^2)
k9 = -1/(2/3)
```
*/
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct DoubleSquare<T = f64> {
        params: DoubleSquareParams,
        constants: [T; 10],
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl DoubleSquare {
        /// Builds the model: checks the parameters, and computes once whatever depends on them alone.
        ///
        /// # Errors
        ///
        /// The first parameter, or combination of parameters, that is not finite or that no rigid body can
        /// have.
        pub fn new(
            params: DoubleSquareParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            #[inline]
            fn rules<T: ::pendulum_core::real::Real>(given: [T; 3]) -> [T; 1] {
                let [p_m, p_a, p_g] = given;
                [p_m]
            }
            #[inline]
            fn constants<T: ::pendulum_core::real::Real>(given: [T; 3]) -> [T; 10] {
                let [p_m, p_a, p_g] = given;
                let t0 = p_a * T::from_f64(1.4142135623730951);
                let t1 = T::from_f64(0.5) * t0;
                let t2 = p_m * (p_a * p_a);
                let t3 = T::from_f64(2.6666666666666665) * t2;
                let t4 = T::from_f64(0.7777777777777778) * (t2 * t2);
                let t5 = T::from_f64(0.6666666666666666) * t2;
                let t6 = T::from_f64(-1.0) / t5;
                let t7 = t2 * t6;
                let t8 = T::from_f64(1.4142135623730951) * (p_g * (p_m * p_a));
                let t9 = T::from_f64(1.5) * t8;
                let t10 = T::from_f64(0.5) * t8;
                [t0, t1, t2, t3, t5, t9, t10, t4, t6, t7]
            }
            let given = params.to_array();
            for (name, value) in DoubleSquareParams::NAMES.into_iter().zip(given) {
                if !value.is_finite() {
                    return Err(
                        ::pendulum_core::ParameterError::new(
                            name,
                            value,
                            "a parameter must be finite",
                            &[],
                        ),
                    );
                }
            }
            let [r0] = rules(given);
            if !(r0 > 0.0) {
                return Err(
                    ::pendulum_core::ParameterError::new(
                        "m",
                        r0,
                        "the mass of a plate of `square` must be positive",
                        &[],
                    ),
                );
            }
            let constants = constants(given);
            let names: [&'static str; 10] = [
                "sqrt(2)*a",
                "0.5*sqrt(2)*a",
                "m*a^2",
                "8/3*m*a^2",
                "2/3*m*a^2",
                "1.5*sqrt(2)*m*a*g",
                "0.5*sqrt(2)*m*a*g",
                "7/9*(m*a^2)^2",
                "-1/(2/3*m*a^2)",
                "-1/(2/3)",
            ];
            for (name, value) in names.into_iter().zip(constants) {
                if !value.is_finite() {
                    let given: [_; 3] = ::core::array::from_fn(|n| (
                        DoubleSquareParams::NAMES[n],
                        given[n],
                    ));
                    return Err(
                        ::pendulum_core::ParameterError::new(
                            name,
                            value,
                            "a constant of the equations is not finite: a coordinate has no inertia, a divisor is zero, or a number is too large",
                            &given,
                        ),
                    );
                }
            }
            Ok(Self { params, constants })
        }
        /// The same model in another number type, such as `f32`. Its constants are computed in double precision
        /// and then rounded.
        pub fn cast<T: ::pendulum_core::real::Real>(&self) -> DoubleSquare<T> {
            DoubleSquare {
                params: self.params,
                constants: self.constants.map(T::from_f64),
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> DoubleSquare<T> {
        /// The parameters that the model was built from.
        pub fn params(&self) -> &DoubleSquareParams {
            &self.params
        }
        /// The model with other parameters, in the same number type. Its constants are computed anew.
        ///
        /// # Errors
        ///
        /// Those of `new`.
        pub fn with_params(
            &self,
            params: DoubleSquareParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            Ok(<DoubleSquare>::new(params)?.cast())
        }
    }
    impl DoubleSquare {
        ///The place of `theta1` in the state, where it stands in rad.
        pub const THETA1: usize = 0;
        ///The place of `dot(theta1)` in the state, where it stands in rad/s.
        pub const DOT_THETA1: usize = 2;
        ///The place of `theta2` in the state, where it stands in rad.
        pub const THETA2: usize = 1;
        ///The place of `dot(theta2)` in the state, where it stands in rad/s.
        pub const DOT_THETA2: usize = 3;
        /// The number of degrees of freedom; the state has twice as many components.
        pub const DOF: usize = 2;
        /// The names of the coordinates, in the order in which they, and then their rates, stand in the state.
        pub const COORDINATES: [&'static str; 2] = ["theta1", "theta2"];
        /// Counted operations of each generated function, in the form that it has and in others.
        pub const COST: ::pendulum_core::Cost = ::pendulum_core::Cost::new(
            &[
                (
                    "rhs",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first, L^T D L",
                            ::pendulum_core::Operations::new(8, 17, 1, 2, 0, 32),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, L^T D L",
                                    ::pendulum_core::Operations::new(8, 17, 1, 2, 0, 32),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L",
                                    ::pendulum_core::Operations::new(8, 17, 1, 2, 0, 32),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, adjugate",
                                    ::pendulum_core::Operations::new(22, 28, 1, 2, 0, 37),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C, adjugate",
                                    ::pendulum_core::Operations::new(33, 40, 1, 2, 0, 37),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "articulated bodies",
                                    ::pendulum_core::Operations::new(26, 40, 2, 2, 0, 48),
                                ),
                            ],
                        ),
                ),
                (
                    "jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first, inverse, derived in the graph",
                            ::pendulum_core::Operations::new(19, 43, 1, 2, 0, 38),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, inverse, derived in the graph",
                                    ::pendulum_core::Operations::new(19, 43, 1, 2, 0, 38),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, inverse, derived and expanded",
                                    ::pendulum_core::Operations::new(19, 43, 1, 2, 0, 38),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, inverse, derived in the graph",
                                    ::pendulum_core::Operations::new(44, 59, 1, 2, 0, 49),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C, inverse, derived in the graph",
                                    ::pendulum_core::Operations::new(91, 95, 1, 2, 0, 44),
                                ),
                            ],
                        ),
                ),
                (
                    "kinetic",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(3, 6, 0, 1, 0, 26),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(3, 6, 0, 1, 0, 26),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(3, 6, 0, 1, 0, 26),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(15, 23, 0, 2, 0, 32),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C",
                                    ::pendulum_core::Operations::new(22, 23, 0, 2, 0, 35),
                                ),
                            ],
                        ),
                ),
                (
                    "potential",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(2, 2, 0, 2, 0, 22),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(2, 2, 0, 2, 0, 22),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(2, 2, 0, 2, 0, 22),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C",
                                    ::pendulum_core::Operations::new(3, 2, 0, 2, 0, 23),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(3, 2, 0, 2, 0, 23),
                                ),
                            ],
                        ),
                ),
                (
                    "mass_matrix",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(1, 1, 0, 1, 0, 22),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(1, 1, 0, 1, 0, 22),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(1, 1, 0, 1, 0, 22),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(16, 12, 0, 2, 0, 29),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C",
                                    ::pendulum_core::Operations::new(19, 16, 0, 2, 0, 30),
                                ),
                            ],
                        ),
                ),
            ],
        );
        /// What each part of the state is.
        pub const LAYOUT: ::pendulum_core::StateLayout = ::pendulum_core::StateLayout::new(
                &[
                    ::pendulum_core::Slot::new(
                            "theta1",
                            ::pendulum_core::SlotKind::Angle,
                            0..1,
                            2..3,
                        )
                        .periodic(),
                    ::pendulum_core::Slot::new(
                            "theta2",
                            ::pendulum_core::SlotKind::Angle,
                            1..2,
                            3..4,
                        )
                        .periodic(),
                ],
            )
            .autonomous();
        /// The equations of motion as text.
        pub const EQUATIONS: &'static str = "A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints\n\nA[theta1, theta1] = 8/3*m*a^2\nA[theta1, theta2] = m*a^2*cos(theta1 - theta2)\nA[theta2, theta2] = 2/3*m*a^2\nb[theta1] = m*a^2*dot(theta2)^2*sin(theta1 - theta2) + 1.5*sqrt(2)*m*a*g*sin(theta1)\nb[theta2] = 0.5*sqrt(2)*m*a*g*sin(theta2) - m*a^2*dot(theta1)^2*sin(theta1 - theta2)\n";
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::System<T, 4>
    for DoubleSquare<T> {
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn rhs(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 4> {
            let [q_theta1, q_theta2, qd_theta1, qd_theta2] = x.data.0[0];
            let k2 = self.constants[2];
            let k4 = self.constants[4];
            let k5 = self.constants[5];
            let k6 = self.constants[6];
            let k7 = self.constants[7];
            let k8 = self.constants[8];
            let k9 = self.constants[9];
            let [(sin_theta1, cos_theta1), (sin_theta2, cos_theta2)] = q_theta1
                .sin_cos_pair(q_theta2);
            let t0 = k2 * (sin_theta1 * cos_theta2 - cos_theta1 * sin_theta2);
            let t1 = k6 * sin_theta2 - qd_theta1 * qd_theta1 * t0;
            let t2 = k9 * (cos_theta2 * cos_theta1 + sin_theta1 * sin_theta2);
            let t3 = k4 / (k7 + t0 * t0)
                * (k5 * sin_theta1 + qd_theta2 * qd_theta2 * t0 + t1 * t2);
            ::pendulum_core::nalgebra::SVector::from([
                qd_theta1,
                qd_theta2,
                -t3,
                k8 * t1 - t2 * t3,
            ])
        }
        #[inline]
        fn layout(
            &self,
        ) -> ::core::option::Option<&'static ::pendulum_core::StateLayout> {
            Some(&<DoubleSquare>::LAYOUT)
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Jacobian<T, 4>
    for DoubleSquare<T> {
        #[inline]
        fn jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SMatrix<T, 4, 4> {
            self.rhs_and_jacobian(t, x).1
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn rhs_and_jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 4>,
            ::pendulum_core::nalgebra::SMatrix<T, 4, 4>,
        ) {
            let [q_theta1, q_theta2, qd_theta1, qd_theta2] = x.data.0[0];
            let k2 = self.constants[2];
            let k3 = self.constants[3];
            let k4 = self.constants[4];
            let k5 = self.constants[5];
            let k6 = self.constants[6];
            let k7 = self.constants[7];
            let t0 = k2 * qd_theta2;
            let t1 = qd_theta2 * t0;
            let t2 = k2 * qd_theta1;
            let t3 = qd_theta1 * t2;
            let [(sin_theta1, cos_theta1), (sin_theta2, cos_theta2)] = q_theta1
                .sin_cos_pair(q_theta2);
            let t4 = sin_theta1 * cos_theta2 - cos_theta1 * sin_theta2;
            let t5 = k5 * sin_theta1 + t1 * t4;
            let t6 = k2 * t4;
            let t7 = T::from_f64(-1.0) / (k7 + t6 * t6);
            let t8 = k4 * t7;
            let t9 = k6 * sin_theta2 - t4 * t3;
            let t10 = T::from_f64(2.0) * t4;
            let t11 = t2 * t10;
            let t12 = t0 * t10;
            let t13 = t8 * t12;
            let t14 = cos_theta2 * cos_theta1 + sin_theta1 * sin_theta2;
            let t15 = k2 * t7 * t14;
            let t16 = -(t15 * t12);
            let t17 = k3 * t7;
            let t18 = t15 * t11;
            let t19 = -(t17 * t11);
            let t20 = t5 * t8 - t9 * t15;
            let t21 = t9 * t17 - t5 * t15;
            let t22 = t1 * t14 - t21 * t6;
            let t23 = t3 * t14 + t20 * t6;
            let t24 = k5 * cos_theta1 + t22;
            let t25 = t23 + k6 * cos_theta2;
            let t26 = t8 * t24 + t15 * t23;
            let t27 = -(t15 * t24 + t17 * t23);
            let t28 = -(t8 * t22 + t15 * t25);
            let t29 = t17 * t25 + t15 * t22;
            (
                ::pendulum_core::nalgebra::SVector::from([
                    qd_theta1,
                    qd_theta2,
                    t20,
                    t21,
                ]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [T::from_f64(0.0), T::from_f64(0.0), t26, t27],
                    [T::from_f64(0.0), T::from_f64(0.0), t28, t29],
                    [T::from_f64(1.0), T::from_f64(0.0), t18, t19],
                    [T::from_f64(0.0), T::from_f64(1.0), t13, t16],
                ]),
            )
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn time_derivative(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 4> {
            ::pendulum_core::nalgebra::SVector::from([
                T::from_f64(0.0),
                T::from_f64(0.0),
                T::from_f64(0.0),
                T::from_f64(0.0),
            ])
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Energy<T, 4>
    for DoubleSquare<T> {
        #[inline]
        fn kinetic(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 4>) -> T {
            let [q_theta1, q_theta2, qd_theta1, qd_theta2] = x.data.0[0];
            let k2 = self.constants[2];
            let (_, cos0) = (q_theta1 - q_theta2).sin_cos();
            k2
                * (qd_theta2 * (T::from_f64(0.3333333333333333) * qd_theta2)
                    + qd_theta1
                        * (qd_theta2 * cos0
                            + T::from_f64(1.3333333333333333) * qd_theta1))
        }
        #[inline]
        fn potential(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 4>) -> T {
            let [q_theta1, q_theta2, _, _] = x.data.0[0];
            let k5 = self.constants[5];
            let k6 = self.constants[6];
            let [(_, cos_theta1), (_, cos_theta2)] = q_theta1.sin_cos_pair(q_theta2);
            -(k5 * cos_theta1 + k6 * cos_theta2)
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> DoubleSquare<T> {
        ///The mass matrix.
        #[inline]
        pub fn mass_matrix(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SMatrix<T, 2, 2> {
            let [q_theta1, q_theta2, _, _] = x.data.0[0];
            let k2 = self.constants[2];
            let k3 = self.constants[3];
            let k4 = self.constants[4];
            let (_, cos0) = (q_theta1 - q_theta2).sin_cos();
            let a0 = k3;
            let a1 = k2 * cos0;
            let a2 = k4;
            ::pendulum_core::nalgebra::SMatrix::from([[a0, a1], [a1, a2]])
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::shapes::Shapes<4> for DoubleSquare {
        fn shapes(
            &self,
            t: f64,
            x: &::pendulum_core::nalgebra::SVector<f64, 4>,
        ) -> ::pendulum_core::shapes::Vec<::pendulum_core::shapes::Shape> {
            use ::pendulum_core::real::Real as _;
            type T = f64;
            ::pendulum_core::shapes::placed(
                &[
                    ::pendulum_core::shapes::Outline {
                        name: "upper",
                        kind: ::pendulum_core::shapes::ShapeKind::Plate,
                        points: 4,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "lower",
                        kind: ::pendulum_core::shapes::ShapeKind::Plate,
                        points: 4,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "upper",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "lower",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "corner",
                        kind: ::pendulum_core::shapes::ShapeKind::Point,
                        points: 1,
                        radius: false,
                    },
                ],
                &{
                    let [q_theta1, q_theta2, _, _] = x.data.0[0];
                    let k0 = self.constants[0];
                    let k1 = self.constants[1];
                    let [(sin_theta1, cos_theta1), (sin_theta2, cos_theta2)] = q_theta1
                        .sin_cos_pair(q_theta2);
                    let t0 = k1 * sin_theta1;
                    let t1 = k1 * cos_theta1;
                    let t2 = t0 - t1;
                    let t3 = t1 + t0;
                    let t4 = -t3;
                    let t5 = k0 * sin_theta1;
                    let t6 = k0 * cos_theta1;
                    let t7 = -t6;
                    let t8 = k1 * sin_theta2;
                    let t9 = k1 * cos_theta2;
                    let t10 = t8 - t9;
                    let t11 = t9 + t8;
                    let t12 = t5 + t10;
                    let t13 = t10 - t6;
                    let t14 = -(t6 + t11);
                    let t15 = t5 + t11;
                    let t16 = t5 + k0 * sin_theta2;
                    let t17 = -(t6 + k0 * cos_theta2);
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t2,
                        t4,
                        T::from_f64(0.0),
                        t5,
                        t7,
                        T::from_f64(0.0),
                        t3,
                        t2,
                        T::from_f64(0.0),
                        t5,
                        t7,
                        T::from_f64(0.0),
                        t12,
                        t14,
                        T::from_f64(0.0),
                        t16,
                        t17,
                        T::from_f64(0.0),
                        t15,
                        t13,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t5,
                        t7,
                        T::from_f64(0.0),
                        t16,
                        t17,
                        T::from_f64(0.0),
                    ]
                },
            )
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::CastJacobian<4> for DoubleSquare {
        #[inline]
        fn with_jacobian<T: ::pendulum_core::real::Real>(
            model: &DoubleSquare<T>,
        ) -> &impl ::pendulum_core::Jacobian<T, 4> {
            model
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::Cast<4> for DoubleSquare {
        type In<T: ::pendulum_core::real::Real> = DoubleSquare<T>;
        fn cast<T: ::pendulum_core::real::Real>(&self) -> DoubleSquare<T> {
            DoubleSquare::cast(self)
        }
        #[inline]
        fn gather<'m, T: ::pendulum_core::real::lanes::Lanes>(
            models: impl ::core::ops::Fn(usize) -> &'m Self,
        ) -> DoubleSquare<T>
        where
            Self: 'm,
        {
            let scalar = <<T as ::pendulum_core::real::lanes::Lanes>::Scalar as ::pendulum_core::real::Real>::from_f64;
            DoubleSquare {
                params: models(0).params,
                constants: ::core::array::from_fn(|k| {
                    <T as ::pendulum_core::real::lanes::Lanes>::from_fn(|lane| scalar(
                        models(lane).constants[k],
                    ))
                }),
            }
        }
    }
}
#[allow(unreachable_pub, unused_imports)]
pub use __DoubleSquare::{DoubleSquare, DoubleSquareParams};
