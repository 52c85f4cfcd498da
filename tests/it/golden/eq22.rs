#[allow(non_snake_case)]
mod __DoublePendulum {
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
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl DoublePendulumParams {
        /// Names of the parameters, in the order of their declaration.
        pub const NAMES: [&'static str; 7] = [
            "m",
            "inertia",
            "c",
            "d",
            "g",
            "gamma1",
            "gamma2",
        ];
        /// Returns the values of the parameters, in the order of [`NAMES`](Self::NAMES).
        pub const fn to_array(self) -> [f64; 7] {
            [self.m, self.inertia, self.c, self.d, self.g, self.gamma1, self.gamma2]
        }
        /// Builds parameters from their values, in the order of [`NAMES`](Self::NAMES).
        pub const fn from_array(values: [f64; 7]) -> Self {
            let [v0, v1, v2, v3, v4, v5, v6] = values;
            Self {
                m: v0,
                inertia: v1,
                c: v2,
                d: v3,
                g: v4,
                gamma1: v5,
                gamma2: v6,
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
k7 = (m*c*d)^2
k8 = 2*m*inertia*c^2 + m*inertia*d^2 + m^2*c^4 + inertia^2
k9 = 0.5*(inertia + m*c^2 + m*d^2)
k10 = 0.5*(inertia + m*c^2)
k11 = -1/(inertia + m*c^2)
k12 = -m*c*d/(inertia + m*c^2)
```
*/
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct DoublePendulum<T = f64> {
        params: DoublePendulumParams,
        constants: [T; 13],
    }
    /// Constants of the model, from its parameters.
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    #[inline]
    fn constants<T: ::pendulum_core::real::Real>(given: [T; 7]) -> [T; 13] {
        let [p_m, p_inertia, p_c, p_d, p_g, p_gamma1, p_gamma2] = given;
        let t0 = p_gamma1 + p_gamma2;
        let t1 = p_c * p_c;
        let t2 = p_m * t1;
        let t3 = p_inertia + t2;
        let t4 = T::from_f64(0.5) * t3;
        let t5 = T::from_f64(-1.0) / t3;
        let t6 = p_d * p_d;
        let t7 = p_inertia + p_m.mul_add(t6, t2);
        let t8 = (p_m * p_m)
            .mul_add(
                p_c * p_c * p_c * p_c,
                t6.mul_add(p_m * p_inertia, t1 * (p_inertia * (T::from_f64(2.0) * p_m))),
            );
        let t9 = p_inertia.mul_add(p_inertia, t8);
        let t10 = T::from_f64(0.5) * t7;
        let t11 = p_m * p_c;
        let t12 = p_d * t11;
        let t13 = t12 * t5;
        let t14 = t12 * t12;
        let t15 = p_g * t11;
        let t16 = p_g.mul_add(p_m * p_d, t15);
        [p_gamma2, t3, t7, t12, t15, t16, t0, t14, t9, t10, t4, t5, t13]
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl DoublePendulum {
        /// Builds the model: checks the parameters, and computes all constants that depend on them alone.
        ///
        /// # Errors
        ///
        /// Returns the first parameter, or combination of parameters, that is not finite or is impossible for a
        /// rigid body.
        pub fn new(
            params: DoublePendulumParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            #[inline]
            fn rules<T: ::pendulum_core::real::Real>(given: [T; 7]) -> [T; 4] {
                let [p_m, p_inertia, p_c, p_d, p_g, p_gamma1, p_gamma2] = given;
                [p_m, p_inertia, p_gamma1, p_gamma2]
            }
            let given = params.to_array();
            for (name, value) in DoublePendulumParams::NAMES.into_iter().zip(given) {
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
            let [r0, r1, r2, r3] = rules(given);
            if !(r0 > 0.0) {
                return Err(
                    ::pendulum_core::ParameterError::new(
                        "m",
                        r0,
                        "the mass of `plate` must be positive",
                        &[],
                    ),
                );
            }
            if !(r1 >= 0.0) {
                return Err(
                    ::pendulum_core::ParameterError::new(
                        "inertia",
                        r1,
                        "the inertia of `plate` must not be negative",
                        &[],
                    ),
                );
            }
            if !(r2 >= 0.0) {
                return Err(
                    ::pendulum_core::ParameterError::new(
                        "gamma1",
                        r2,
                        "the friction of `upper` must not be negative",
                        &[],
                    ),
                );
            }
            if !(r3 >= 0.0) {
                return Err(
                    ::pendulum_core::ParameterError::new(
                        "gamma2",
                        r3,
                        "the friction of `lower` must not be negative",
                        &[],
                    ),
                );
            }
            let constants = constants(given);
            let names: [&'static str; 13] = [
                "gamma2",
                "inertia + m*c^2",
                "inertia + m*c^2 + m*d^2",
                "m*c*d",
                "m*c*g",
                "m*c*g + m*d*g",
                "gamma1 + gamma2",
                "(m*c*d)^2",
                "2*m*inertia*c^2 + m*inertia*d^2 + m^2*c^4 + inertia^2",
                "0.5*(inertia + m*c^2 + m*d^2)",
                "0.5*(inertia + m*c^2)",
                "-1/(inertia + m*c^2)",
                "-m*c*d/(inertia + m*c^2)",
            ];
            for (name, value) in names.into_iter().zip(constants) {
                if !value.is_finite() {
                    let given: [_; 7] = ::core::array::from_fn(|n| (
                        DoublePendulumParams::NAMES[n],
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
        /// Converts the model to another number type, such as `f32`. Its constants are computed in double
        /// precision and then rounded.
        pub fn cast<T: ::pendulum_core::real::Real>(&self) -> DoublePendulum<T> {
            DoublePendulum {
                params: self.params,
                constants: self.constants.map(T::from_f64),
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> DoublePendulum<T> {
        /// Returns the parameters from which the model was built.
        pub fn params(&self) -> &DoublePendulumParams {
            &self.params
        }
        /// Returns a model with other parameters, in the same number type, and recomputes its constants.
        ///
        /// # Errors
        ///
        /// Returns the errors of `new`.
        pub fn with_params(
            &self,
            params: DoublePendulumParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            Ok(<DoublePendulum>::new(params)?.cast())
        }
    }
    impl DoublePendulum {
        ///Index of `theta1` in the state, in rad.
        pub const THETA1: usize = 0;
        ///Index of `dot(theta1)` in the state, in rad/s.
        pub const DOT_THETA1: usize = 2;
        ///Index of `theta2` in the state, in rad.
        pub const THETA2: usize = 1;
        ///Index of `dot(theta2)` in the state, in rad/s.
        pub const DOT_THETA2: usize = 3;
        /// Number of degrees of freedom. The state has twice as many components.
        pub const DOF: usize = 2;
        /// Names of the coordinates. The state holds their positions and then their rates in this order.
        pub const COORDINATES: [&'static str; 2] = ["theta1", "theta2"];
        /// Operation counts of each generated function, in its own form and in others.
        pub const COST: ::pendulum_core::Cost = ::pendulum_core::Cost::new(
            &[
                (
                    "rhs",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factored, L^T D L",
                            ::pendulum_core::Operations::new(12, 19, 1, 2, 0, 32),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L",
                                    ::pendulum_core::Operations::new(12, 19, 1, 2, 0, 33),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, adjugate",
                                    ::pendulum_core::Operations::new(24, 30, 1, 2, 0, 37),
                                ),
                            ],
                        ),
                ),
                (
                    "jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factored, inverse, derived in the graph",
                            ::pendulum_core::Operations::new(28, 50, 1, 2, 0, 38),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, inverse, derived and expanded",
                                    ::pendulum_core::Operations::new(28, 50, 1, 2, 0, 38),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, inverse, derived in the graph",
                                    ::pendulum_core::Operations::new(50, 65, 1, 2, 0, 49),
                                ),
                            ],
                        ),
                ),
                (
                    "kinetic",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factored",
                            ::pendulum_core::Operations::new(3, 6, 0, 1, 0, 25),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(3, 6, 0, 1, 0, 26),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(15, 23, 0, 2, 0, 32),
                                ),
                            ],
                        ),
                ),
                (
                    "potential",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factored",
                            ::pendulum_core::Operations::new(2, 2, 0, 2, 0, 22),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(2, 2, 0, 2, 0, 22),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(3, 2, 0, 2, 0, 23),
                                ),
                            ],
                        ),
                ),
                (
                    "canonical",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factored, derived and expanded",
                            ::pendulum_core::Operations::new(10, 16, 0, 2, 0, 26),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, derived and expanded",
                                    ::pendulum_core::Operations::new(9, 17, 0, 2, 0, 26),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, derived in the graph",
                                    ::pendulum_core::Operations::new(34, 54, 0, 2, 0, 30),
                                ),
                            ],
                        ),
                ),
                (
                    "canonical_jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factored, derived and expanded",
                            ::pendulum_core::Operations::new(13, 13, 0, 2, 0, 24),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, derived and expanded",
                                    ::pendulum_core::Operations::new(13, 13, 0, 2, 0, 24),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, derived in the graph",
                                    ::pendulum_core::Operations::new(76, 71, 0, 2, 0, 29),
                                ),
                            ],
                        ),
                ),
                (
                    "taylor",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factored, inverse",
                            ::pendulum_core::Operations::new(28, 37, 0, 0, 0, 12),
                        )
                        .with_products(12)
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                        "closed form, expanded, inverse",
                                        ::pendulum_core::Operations::new(30, 36, 0, 0, 0, 12),
                                    )
                                    .with_products(12),
                                ::pendulum_core::FunctionCost::new(
                                        "recursion, inverse",
                                        ::pendulum_core::Operations::new(69, 59, 0, 0, 0, 18),
                                    )
                                    .with_products(22),
                            ],
                        ),
                ),
            ],
        );
        /// Layout of the state.
        pub const LAYOUT: ::pendulum_core::StateLayout<'static> = ::pendulum_core::StateLayout::new(
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
        /// Equations of motion as text.
        pub const EQUATIONS: &'static str = "A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints\n\nA[theta1, theta1] = inertia + m*c^2 + m*d^2\nA[theta1, theta2] = m*c*d*cos(theta1 - theta2)\nA[theta2, theta2] = inertia + m*c^2\nb[theta1] = m*c*d*dot(theta2)^2*sin(theta1 - theta2) + (m*c*g + m*d*g)*sin(theta1)\nb[theta2] = m*c*g*sin(theta2) - m*c*d*dot(theta1)^2*sin(theta1 - theta2)\nQ[theta1] = gamma2*dot(theta2) - (gamma1 + gamma2)*dot(theta1)\nQ[theta2] = gamma2*dot(theta1) - gamma2*dot(theta2)\n";
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::System<T, 4>
    for DoublePendulum<T> {
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn rhs(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 4> {
            let [q_theta1, q_theta2, qd_theta1, qd_theta2] = x.data.0[0];
            let k0 = self.constants[0];
            let k1 = self.constants[1];
            let k3 = self.constants[3];
            let k4 = self.constants[4];
            let k5 = self.constants[5];
            let k6 = self.constants[6];
            let k8 = self.constants[8];
            let k11 = self.constants[11];
            let k12 = self.constants[12];
            let [(sin_theta1, cos_theta1), (sin_theta2, cos_theta2)] = q_theta1
                .sin_cos_pair(q_theta2);
            let t0 = k3 * cos_theta1.mul_neg_add(sin_theta2, sin_theta1 * cos_theta2);
            let t1 = qd_theta1
                .mul_neg_add(
                    qd_theta1.mul_add(t0, k0),
                    k0.mul_add(qd_theta2, k4 * sin_theta2),
                );
            let t2 = k12 * sin_theta1.mul_add(sin_theta2, cos_theta2 * cos_theta1);
            let t3 = t1
                .mul_add(
                    t2,
                    qd_theta2
                        .mul_add(
                            qd_theta2.mul_sub(t0, k0),
                            k6.mul_add(qd_theta1, k5 * sin_theta1),
                        ),
                );
            let t4 = k1 / t0.mul_add(t0, k8) * t3;
            ::pendulum_core::nalgebra::SVector::from([
                qd_theta1,
                qd_theta2,
                -t4,
                t2.mul_neg_add(t4, k11 * t1),
            ])
        }
        #[inline]
        fn layout(&self) -> ::core::option::Option<::pendulum_core::StateLayout<'_>> {
            Some(<DoublePendulum>::LAYOUT)
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
            let k8 = self.constants[8];
            let t0 = k3 * qd_theta2;
            let t1 = k3 * qd_theta1;
            let [(sin_theta1, cos_theta1), (sin_theta2, cos_theta2)] = q_theta1
                .sin_cos_pair(q_theta2);
            let t2 = cos_theta1.mul_neg_add(sin_theta2, sin_theta1 * cos_theta2);
            let t3 = t0.mul_sub(t2, k0);
            let t4 = qd_theta2.mul_add(t3, k6.mul_add(qd_theta1, k5 * sin_theta1));
            let t5 = k3 * t2;
            let t6 = t2.mul_add(t1, k0);
            let t7 = qd_theta2.mul_add(t5, t3);
            let t8 = T::from_f64(-1.0) / t5.mul_add(t5, k8);
            let t9 = k1 * t8;
            let t10 = qd_theta1.mul_neg_add(t6, k0.mul_add(qd_theta2, k4 * sin_theta2));
            let t11 = qd_theta1.mul_add(t5, t6);
            let t12 = sin_theta1.mul_add(sin_theta2, cos_theta2 * cos_theta1);
            let t13 = k3 * t8 * t12;
            let t14 = k2 * t8;
            let t15 = t13.mul_add(t11, k6 * t9);
            let t16 = -t14.mul_add(t11, k6 * t13);
            let t17 = k0.mul_neg_add(t13, t9 * t7);
            let t18 = t13.mul_neg_add(t7, k0 * t14);
            let t19 = t10.mul_neg_add(t13, t4 * t9);
            let t20 = t4.mul_neg_add(t13, t10 * t14);
            let t21 = t20.mul_neg_add(t5, qd_theta2 * t0 * t12);
            let t22 = t19.mul_add(t5, qd_theta1 * t1 * t12);
            let t23 = k5.mul_add(cos_theta1, t21);
            let t24 = k4.mul_add(cos_theta2, t22);
            let t25 = t13.mul_add(t22, t9 * t23);
            let t26 = -t14.mul_add(t22, t13 * t23);
            let t27 = -t13.mul_add(t24, t9 * t21);
            let t28 = t13.mul_add(t21, t14 * t24);
            (
                ::pendulum_core::nalgebra::SVector::from([
                    qd_theta1,
                    qd_theta2,
                    t19,
                    t20,
                ]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [T::from_f64(0.0), T::from_f64(0.0), t25, t26],
                    [T::from_f64(0.0), T::from_f64(0.0), t27, t28],
                    [T::from_f64(1.0), T::from_f64(0.0), t15, t16],
                    [T::from_f64(0.0), T::from_f64(1.0), t17, t18],
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
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Canonical<T, 4>
    for DoublePendulum<T> {
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn canonical(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 4>,
            ::pendulum_core::nalgebra::SVector<T, 4>,
        ) {
            let [q_theta1, q_theta2, qd_theta1, qd_theta2] = x.data.0[0];
            let k0 = self.constants[0];
            let k1 = self.constants[1];
            let k2 = self.constants[2];
            let k3 = self.constants[3];
            let k4 = self.constants[4];
            let k5 = self.constants[5];
            let k6 = self.constants[6];
            let t0 = qd_theta2 * k3;
            let t1 = k0 * qd_theta2;
            let [(sin_theta1, cos_theta1), (sin_theta2, cos_theta2)] = q_theta1
                .sin_cos_pair(q_theta2);
            let t2 = t0 * cos_theta1.mul_neg_add(sin_theta2, sin_theta1 * cos_theta2);
            let t3 = sin_theta1.mul_add(sin_theta2, cos_theta1 * cos_theta2);
            (
                ::pendulum_core::nalgebra::SVector::from([
                    q_theta1,
                    q_theta2,
                    t0.mul_add(t3, qd_theta1 * k2),
                    (qd_theta1 * k3).mul_add(t3, qd_theta2 * k1),
                ]),
                ::pendulum_core::nalgebra::SVector::from([
                    qd_theta1,
                    qd_theta2,
                    qd_theta1.mul_neg_add(k6 + t2, sin_theta1.mul_neg_add(k5, t1)),
                    qd_theta1.mul_sub(k0 + t2, sin_theta2.mul_add(k4, t1)),
                ]),
            )
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn canonical_jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> (
            ::pendulum_core::nalgebra::SMatrix<T, 4, 4>,
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
            let t0 = qd_theta1 * k3;
            let [(sin_theta1, cos_theta1), (sin_theta2, cos_theta2)] = q_theta1
                .sin_cos_pair(q_theta2);
            let t1 = cos_theta1.mul_neg_add(sin_theta2, sin_theta1 * cos_theta2);
            let t2 = qd_theta2 * k3 * t1;
            let t3 = -t2;
            let t4 = t0 * t1;
            let t5 = -t4;
            let t6 = -(k6 + t2);
            let t7 = k0 + t2;
            let t8 = k0 - t4;
            let t9 = t4 - k0;
            let t10 = sin_theta1.mul_add(sin_theta2, cos_theta1 * cos_theta2);
            let t11 = qd_theta2 * t0 * t10;
            let t12 = k3 * t10;
            let t13 = -cos_theta1.mul_add(k5, t11);
            let t14 = -cos_theta2.mul_add(k4, t11);
            (
                ::pendulum_core::nalgebra::SMatrix::from([
                    [T::from_f64(1.0), T::from_f64(0.0), t3, t5],
                    [T::from_f64(0.0), T::from_f64(1.0), t2, t4],
                    [T::from_f64(0.0), T::from_f64(0.0), k2, t12],
                    [T::from_f64(0.0), T::from_f64(0.0), t12, k1],
                ]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [T::from_f64(0.0), T::from_f64(0.0), t13, t11],
                    [T::from_f64(0.0), T::from_f64(0.0), t11, t14],
                    [T::from_f64(1.0), T::from_f64(0.0), t6, t7],
                    [T::from_f64(0.0), T::from_f64(1.0), t8, t9],
                ]),
            )
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Energy<T, 4>
    for DoublePendulum<T> {
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn kinetic(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 4>) -> T {
            let [q_theta1, q_theta2, qd_theta1, qd_theta2] = x.data.0[0];
            let k3 = self.constants[3];
            let k9 = self.constants[9];
            let k10 = self.constants[10];
            let (_, cos0) = (q_theta1 - q_theta2).sin_cos();
            qd_theta1
                .mul_add(
                    qd_theta1.mul_add(k9, cos0 * (qd_theta2 * k3)),
                    qd_theta2 * (qd_theta2 * k10),
                )
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn potential(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 4>) -> T {
            let [q_theta1, q_theta2, _, _] = x.data.0[0];
            let k4 = self.constants[4];
            let k5 = self.constants[5];
            let [(_, cos_theta1), (_, cos_theta2)] = q_theta1.sin_cos_pair(q_theta2);
            -cos_theta2.mul_add(k4, cos_theta1 * k5)
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::taylor::Linearized<4, 2, 13, 9, 19, 12> for DoublePendulum {
        type Parameters = DoublePendulumParams;
        #[inline]
        fn with_constants<T: ::pendulum_core::real::Real>(
            params: &DoublePendulumParams,
            constants: [T; 13],
        ) -> DoublePendulum<T> {
            DoublePendulum {
                params: *params,
                constants,
            }
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn start<T: ::pendulum_core::real::Real>(
            constants: &[T; 13],
            state: &::pendulum_core::nalgebra::SVector<T, 4>,
            accelerations: &[T; 2],
        ) -> (::pendulum_core::taylor::Matrices<T, 2>, [T; 9], [T; 19]) {
            let q_theta1 = state[0];
            let q_theta2 = state[1];
            let qd_theta1 = state[2];
            let qd_theta2 = state[3];
            let qdd_theta1 = accelerations[0];
            let qdd_theta2 = accelerations[1];
            let k0 = constants[0];
            let k1 = constants[1];
            let k2 = constants[2];
            let k3 = constants[3];
            let k4 = constants[4];
            let k5 = constants[5];
            let k6 = constants[6];
            let k7 = constants[7];
            let k8 = constants[8];
            let t0 = -qd_theta2;
            let t1 = qd_theta2 - qd_theta1;
            let t2 = k3 * qdd_theta2;
            let t3 = k3 * qdd_theta1;
            let t4 = k3 * qd_theta2;
            let t5 = k3 * qd_theta1;
            let [(sin_theta1, cos_theta1), (sin_theta2, cos_theta2)] = q_theta1
                .sin_cos_pair(q_theta2);
            let t6 = sin_theta1.mul_add(sin_theta2, cos_theta1 * cos_theta2);
            let t7 = t6 * t4;
            let t8 = qd_theta2 * t7;
            let t9 = cos_theta1.mul_neg_add(sin_theta2, cos_theta2 * sin_theta1);
            let t10 = k3 * t9;
            let t11 = qd_theta2.mul_add(t10, t4 * t9) - k0;
            let t12 = -t10.mul_add(qd_theta1, t9.mul_add(t5, k0));
            let t13 = t6 * t5;
            let t14 = t10.mul_add(qdd_theta1, qd_theta1 * t13);
            let t15 = qdd_theta2 * t10;
            let t16 = k5.mul_add(cos_theta1, t8 - t15);
            let t17 = k4.mul_add(cos_theta2, t14);
            let t18 = t15 - t8;
            let t19 = -t14;
            let t20 = k3 * t6;
            let t21 = qd_theta2 * t9;
            let t22 = t6.mul_add(qdd_theta2, qd_theta2 * t21);
            let t23 = t9 * qd_theta1;
            let t24 = qd_theta1.mul_neg_add(t23, t6 * qdd_theta1);
            let t25 = T::from_f64(-1.0) / (k7 * t9).mul_add(t9, k8);
            let t26 = t20 * t25;
            let t27 = k1 * t25;
            let t28 = k2 * t25;
            (
                [
                    [[t16, t18], [t19, t17]],
                    [[k6, t11], [t12, k0]],
                    [[k2, t20], [t20, k1]],
                ],
                [
                    t0,
                    qdd_theta1,
                    t22,
                    sin_theta1,
                    qd_theta1,
                    t1,
                    qdd_theta2,
                    t24,
                    sin_theta2,
                ],
                [
                    qd_theta1,
                    qd_theta2,
                    qdd_theta1,
                    qdd_theta2,
                    t6,
                    t9,
                    t20,
                    t4,
                    t5,
                    t27,
                    t26,
                    t28,
                    t7,
                    t10,
                    t13,
                    t21,
                    t23,
                    t2,
                    t3,
                ],
            )
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn order<T: ::pendulum_core::real::Real>(
            constants: &[T; 13],
            kept: &[T; 19],
            k: usize,
            sums: &[T; 12],
            coefficients: &::pendulum_core::nalgebra::SVector<T, 4>,
            accelerations: &[T; 2],
            motion: &::pendulum_core::taylor::Products<T, 12>,
        ) -> (::pendulum_core::taylor::Matrices<T, 2>, [T; 9], [[T; 12]; 2]) {
            let order = T::from_f64(k as f64);
            let over_order = T::from_f64(1.0 / k as f64);
            let [left, right] = motion.factors(k);
            let qdd_theta1 = accelerations[0];
            let qdd_theta2 = accelerations[1];
            let k3 = constants[3];
            let k4 = constants[4];
            let k5 = constants[5];
            let x2 = coefficients[2];
            let x3 = coefficients[3];
            let s0 = sums[0];
            let s1 = sums[1];
            let s2 = sums[2];
            let s3 = sums[3];
            let s4 = sums[4];
            let s5 = sums[5];
            let s6 = sums[6];
            let s7 = sums[7];
            let s8 = sums[8];
            let s9 = sums[9];
            let s10 = sums[10];
            let s11 = sums[11];
            let h0 = kept[0];
            let h1 = kept[1];
            let h2 = kept[2];
            let h3 = kept[3];
            let h4 = kept[4];
            let h5 = kept[5];
            let h6 = kept[6];
            let h7 = kept[7];
            let h8 = kept[8];
            let h12 = kept[12];
            let h13 = kept[13];
            let h14 = kept[14];
            let h15 = kept[15];
            let h16 = kept[16];
            let h17 = kept[17];
            let h18 = kept[18];
            let f2 = left[2];
            let f3 = left[3];
            let f5 = left[5];
            let f12 = right[0];
            let f15 = right[3];
            let f18 = right[6];
            let f20 = right[8];
            let f22 = right[10];
            let f23 = right[11];
            let t0 = x3.mul_add(h13, k3.mul_add(s6, h7.mul_add(f2, f15)));
            let t1 = -h13.mul_add(x2, k3.mul_add(s7, f2.mul_add(h8, f20)));
            let t2 = -f3;
            let t3 = x3 - x2;
            let t4 = f5.mul_add(h7, k3.mul_add(s0, x3 * h6));
            let t5 = x3.mul_add(h12, h1.mul_add(t4, s1));
            let t6 = qdd_theta2.mul_add(h13, k3.mul_add(s2, f2 * h17));
            let t7 = k5.mul_add(f12, t5 - t6);
            let t8 = t6 - t5;
            let t9 = f5.mul_add(h8, k3.mul_add(s3, h6 * x2));
            let t10 = x2.mul_add(h14, h0.mul_add(t9, s4))
                + h13.mul_add(qdd_theta1, k3.mul_add(s5, f2 * h18));
            let t11 = -t10;
            let t12 = k4.mul_add(f18, t10);
            let t13 = k3 * f5;
            let t14 = x3.mul_add(h5, h1.mul_add(f2, s6));
            let t15 = qdd_theta2
                .mul_add(h4, f5.mul_add(h3, x3.mul_add(h15, h1.mul_add(t14, s8))) + s9);
            let t16 = x2.mul_add(h5, f2.mul_add(h0, s7));
            let t17 = x2
                .mul_neg_add(
                    h16,
                    h0.mul_neg_add(t16, qdd_theta1.mul_add(h4, f5.mul_add(h2, s10)))
                        - s11,
                );
            (
                [
                    [[t7, t8], [t11, t12]],
                    [[T::from_f64(0.0), t0], [t1, T::from_f64(0.0)]],
                    [[T::from_f64(0.0), t13], [t13, T::from_f64(0.0)]],
                ],
                [t2, qdd_theta1, t15, f22, x2, t3, qdd_theta2, t17, f23],
                [
                    [
                        f5,
                        x3,
                        qdd_theta2,
                        f5,
                        x2,
                        qdd_theta1,
                        x3,
                        x2,
                        x3,
                        qdd_theta2,
                        qdd_theta1,
                        x2,
                    ],
                    [x3, t4, f2, x2, t9, f2, f2, f2, t14, f5, f5, t16],
                ],
            )
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn step<T: ::pendulum_core::real::Real>(
            constants: &[T; 13],
            kept: &[T; 19],
            by_constants: &[T; 9],
            sums: &[T; 2],
            of_constants: &[T; 13],
        ) -> [T; 2] {
            let w0 = of_constants[0];
            let w1 = of_constants[1];
            let w2 = of_constants[2];
            let w3 = of_constants[3];
            let w4 = of_constants[4];
            let w5 = of_constants[5];
            let w6 = of_constants[6];
            let s0 = sums[0];
            let s1 = sums[1];
            let h9 = kept[9];
            let h10 = kept[10];
            let h11 = kept[11];
            let l0 = by_constants[0];
            let l1 = by_constants[1];
            let l2 = by_constants[2];
            let l3 = by_constants[3];
            let l4 = by_constants[4];
            let l5 = by_constants[5];
            let l6 = by_constants[6];
            let l7 = by_constants[7];
            let l8 = by_constants[8];
            let t0 = w6
                .mul_add(l4, w5.mul_add(l3, w3.mul_add(l2, w2.mul_add(l1, w0 * l0))));
            let t1 = s0 + t0;
            let t2 = s1 + w4.mul_add(l8, w3.mul_add(l7, w1.mul_add(l6, w0 * l5)));
            [t2.mul_neg_add(h10, t1 * h9), t1.mul_neg_add(h10, t2 * h11)]
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::taylor::TaylorSeries<T, 4>
    for DoublePendulum<T> {
        type Workspace = ::pendulum_core::taylor::Products<T, 12>;
        #[inline]
        fn workspace(&self) -> Self::Workspace {
            ::pendulum_core::taylor::Products::new()
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn series(
            &self,
            t: T,
            x: &mut [::pendulum_core::nalgebra::SVector<T, 4>],
            work: &mut Self::Workspace,
        ) {
            if x.len() < 2 {
                return;
            }
            if const { T::TAKEN_APART } {
                ::pendulum_core::taylor::series_by_tangents::<
                    DoublePendulum,
                    T,
                    4,
                    2,
                    13,
                    9,
                    19,
                    12,
                >(&self.params, &self.constants, t, x);
                return;
            }
            let (
                a0,
                a1,
                a2,
                a3,
                h0,
                h1,
                h2,
                h3,
                h4,
                h5,
                h6,
                h7,
                h8,
                h9,
                h10,
                h11,
                h12,
                h13,
                h14,
                h15,
                h16,
                h17,
            ) = {
                let x = &x[0];
                {
                    let [q_theta1, q_theta2, qd_theta1, qd_theta2] = x.data.0[0];
                    let k0 = self.constants[0];
                    let k1 = self.constants[1];
                    let k2 = self.constants[2];
                    let k3 = self.constants[3];
                    let k4 = self.constants[4];
                    let k5 = self.constants[5];
                    let k6 = self.constants[6];
                    let k8 = self.constants[8];
                    let t0 = k3 * qd_theta2;
                    let t1 = k3 * qd_theta1;
                    let [(sin_theta1, cos_theta1), (sin_theta2, cos_theta2)] = q_theta1
                        .sin_cos_pair(q_theta2);
                    let t2 = cos_theta1.mul_neg_add(sin_theta2, sin_theta1 * cos_theta2);
                    let t3 = t0.mul_sub(t2, k0);
                    let t4 = qd_theta2
                        .mul_add(t3, k6.mul_add(qd_theta1, k5 * sin_theta1));
                    let t5 = t2.mul_add(t1, k0);
                    let t6 = k3 * t2;
                    let t7 = T::from_f64(-1.0) / t6.mul_add(t6, k8);
                    let t8 = qd_theta1
                        .mul_neg_add(t5, k0.mul_add(qd_theta2, k4 * sin_theta2));
                    let t9 = sin_theta1.mul_add(sin_theta2, cos_theta2 * cos_theta1);
                    let t10 = k3 * t7 * t9;
                    let t11 = k1 * t7;
                    let t12 = t8.mul_neg_add(t10, t4 * t11);
                    let t13 = k3 * t12;
                    let t14 = k2 * t7;
                    let t15 = t4.mul_neg_add(t10, t8 * t14);
                    let t16 = k3 * t15;
                    (
                        qd_theta1,
                        qd_theta2,
                        t12,
                        t15,
                        qd_theta1,
                        qd_theta2,
                        sin_theta1,
                        cos_theta1,
                        sin_theta2,
                        cos_theta2,
                        t9,
                        t2,
                        t0,
                        t1,
                        t3,
                        t5,
                        t11,
                        t10,
                        t14,
                        t6,
                        t16,
                        t13,
                    )
                }
            };
            x[1] = ::pendulum_core::nalgebra::SVector::from([a0, a1, a2, a3]);
            let k0 = self.constants[0];
            let k3 = self.constants[3];
            let k4 = self.constants[4];
            let k5 = self.constants[5];
            let k6 = self.constants[6];
            let mut over_next = T::from_f64(1.0);
            let mut newest = ::pendulum_core::taylor::Newest::new();
            for k in 1..x.len() - 1 {
                let order = T::from_f64(k as f64);
                let over_order = over_next;
                over_next = T::from_f64(1.0 / (k + 1) as f64);
                let [s0, s1, s2, s3, s4, s5, s6, s7, s8, s9, s10, s11] = newest
                    .add(work.sums(k));
                let [x0, x1, x2, x3] = x[k].data.0[0];
                let t0 = -x0.mul_add(h2, s10.scaled(over_order));
                let t1 = -x1.mul_add(h4, s11.scaled(over_order));
                let t2 = x0.mul_add(h3, s0.scaled(over_order));
                let t3 = x0 - x1;
                let t4 = t3.mul_add(h6, s1.scaled(over_order));
                let t5 = x3.mul_add(h15, h8.mul_add(t4, k3 * s2));
                let t6 = k5.mul_add(t2, k6 * x2) + h1.mul_add(t5, x3.mul_add(h10, s3));
                let t7 = x2.mul_add(h15, h9.mul_add(t4, k3 * s7));
                let t8 = t3.mul_add(h7, s4.scaled(over_order));
                let t9 = t6 + h16.mul_neg_add(t8, k3 * s5);
                let t10 = t3.scaled(order);
                let t11 = x1.mul_add(h5, s6.scaled(over_order));
                let t12 = k4.mul_add(t11, k0 * x3) - h0.mul_add(t7, x2.mul_add(h11, s8));
                let t13 = t12 + h17.mul_neg_add(t8, k3 * s9);
                let t14 = -t8;
                let t15 = h13.mul_neg_add(t13, h12 * t9);
                let t16 = h13.mul_neg_add(t9, h14 * t13);
                let t17 = x0.scaled(order);
                let t18 = x1.scaled(order);
                let (left, right) = (
                    [t17, t10, t4, x3, t10, t14, t18, t4, x2, t14, t17, t18],
                    [t0, t14, x3, t5, t4, t16, t1, x2, t7, t15, t2, t11],
                );
                newest.push(k, left, right);
                work.set(k, left, right);
                x[k + 1] = ::pendulum_core::nalgebra::SVector::from([
                    x2.scaled(over_next),
                    x3.scaled(over_next),
                    t15.scaled(over_next),
                    t16.scaled(over_next),
                ]);
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::taylor::CastTaylor<4> for DoublePendulum {
        type Workspace<T: ::pendulum_core::real::Real> = ::pendulum_core::taylor::Products<
            T,
            12,
        >;
        #[inline]
        fn with_series<T: ::pendulum_core::real::Real>(
            model: &DoublePendulum<T>,
        ) -> &impl ::pendulum_core::taylor::TaylorSeries<
            T,
            4,
            Workspace = ::pendulum_core::taylor::Products<T, 12>,
        > {
            model
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::Parametric<4, 7> for DoublePendulum {
        fn parameters(&self) -> [f64; 7] {
            self.params.to_array()
        }
        fn parameter_names(&self) -> [&str; 7] {
            DoublePendulumParams::NAMES
        }
        fn check_parameters(
            &self,
            parameters: &[f64; 7],
        ) -> ::core::result::Result<(), ::pendulum_core::ParameterError> {
            Self::new(DoublePendulumParams::from_array(*parameters)).map(|_| ())
        }
        fn with_parameters<T: ::pendulum_core::real::Real>(
            &self,
            parameters: [T; 7],
        ) -> DoublePendulum<T> {
            DoublePendulum {
                params: self.params,
                constants: constants(parameters),
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::CastJacobian<4> for DoublePendulum {
        #[inline]
        fn with_jacobian<T: ::pendulum_core::real::Real>(
            model: &DoublePendulum<T>,
        ) -> &impl ::pendulum_core::Jacobian<T, 4> {
            model
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::Cast<4> for DoublePendulum {
        type In<T: ::pendulum_core::real::Real> = DoublePendulum<T>;
        fn cast<T: ::pendulum_core::real::Real>(&self) -> DoublePendulum<T> {
            DoublePendulum::cast(self)
        }
        #[inline]
        fn gather<'m, T: ::pendulum_core::real::lanes::Lanes>(
            models: impl ::core::ops::Fn(usize) -> &'m Self,
        ) -> DoublePendulum<T>
        where
            Self: 'm,
        {
            let scalar = <<T as ::pendulum_core::real::lanes::Lanes>::Scalar as ::pendulum_core::real::Real>::from_f64;
            DoublePendulum {
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
pub use __DoublePendulum::{DoublePendulum, DoublePendulumParams};
