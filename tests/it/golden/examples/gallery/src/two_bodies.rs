#[allow(non_snake_case)]
mod __TwoBodies {
    ///Parameters of [`TwoBodies`].
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct TwoBodiesParams {
        ///In kg.
        pub m1: f64,
        ///In m.
        pub c1: f64,
        ///In kg m^2.
        pub i1: f64,
        ///In N m s.
        pub gamma1: f64,
        ///In kg.
        pub m2: f64,
        ///In m.
        pub c2: f64,
        ///In kg m^2.
        pub i2: f64,
        ///In N m s.
        pub gamma2: f64,
        ///In m.
        pub d: f64,
        ///In m.
        pub side: f64,
        ///In m/s^2.
        pub g: f64,
    }
    impl ::core::default::Default for TwoBodiesParams {
        #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
        fn default() -> Self {
            Self {
                m1: 1.7f64,
                c1: 0.43f64,
                i1: 0.31f64,
                gamma1: 0.05f64,
                m2: 0.8f64,
                c2: 0.55f64,
                i2: 0.12f64,
                gamma2: 0.02f64,
                d: 0.9f64,
                side: 0.1f64,
                g: 9.81f64,
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl TwoBodiesParams {
        /// The names of the parameters, in the order of their declaration.
        pub const NAMES: [&'static str; 11] = [
            "m1",
            "c1",
            "i1",
            "gamma1",
            "m2",
            "c2",
            "i2",
            "gamma2",
            "d",
            "side",
            "g",
        ];
        /// The values of the parameters, in the order of [`NAMES`](Self::NAMES).
        pub const fn to_array(self) -> [f64; 11] {
            [
                self.m1,
                self.c1,
                self.i1,
                self.gamma1,
                self.m2,
                self.c2,
                self.i2,
                self.gamma2,
                self.d,
                self.side,
                self.g,
            ]
        }
        /// The parameters with these values, in the order of [`NAMES`](Self::NAMES).
        pub const fn from_array(values: [f64; 11]) -> Self {
            let [v0, v1, v2, v3, v4, v5, v6, v7, v8, v9, v10] = values;
            Self {
                m1: v0,
                c1: v1,
                i1: v2,
                gamma1: v3,
                m2: v4,
                c2: v5,
                i2: v6,
                gamma2: v7,
                d: v8,
                side: v9,
                g: v10,
            }
        }
    }
    /// Two different bodies with friction in both axles.
    ///
    /**# Equations of motion

```text
A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints

A[theta1, theta1] = i1 + m1*side^2 + m1*c1^2 + m2*d^2
A[theta1, theta2] = m2*c2*d*cos(theta1 - theta2) - m2*d*side*sin(theta1 - theta2)
A[theta2, theta2] = i2 + m2*side^2 + m2*c2^2
b[theta1] = m1*side*g*cos(theta1) + (m1*c1*g + m2*d*g)*sin(theta1) + m2*d*side*dot(theta2)^2*cos(theta1 - theta2)
    + m2*c2*d*dot(theta2)^2*sin(theta1 - theta2)
b[theta2] = m2*c2*g*sin(theta2) - m2*d*side*dot(theta1)^2*cos(theta1 - theta2)
    - m2*c2*d*dot(theta1)^2*sin(theta1 - theta2) - m2*side*g*cos(theta2)
Q[theta1] = gamma2*dot(theta2) - (gamma1 + gamma2)*dot(theta1)
Q[theta2] = gamma2*dot(theta1) - gamma2*dot(theta2)
```

# Constants, computed by `new`

```text
k0 = c1
k1 = c2
k2 = gamma2
k3 = d
k4 = side
k5 = 2*c2
k6 = m2*c2*d
k7 = m2*d*side
k8 = i2 + m2*side^2 + m2*c2^2
k9 = m1*c1*g + m2*d*g
k10 = m1*side*g
k11 = m2*c2*g
k12 = m2*side*g
k13 = gamma1 + gamma2
k14 = m1*c1^2*m2*c2^2 + m1*c1^2*m2*side^2 + m1*c1^2*i2 + m1*m2*c2^2*side^2 + m1*m2*side^4 + m1*i2*side^2 + i1*m2*c2^2 + i1*m2*side^2 + i1*i2 + m2*i2*d^2
k15 = m2^2*d^2*side^2
k16 = m2^2*c2^2*d^2
k17 = m1*c1*m2*c2^2*g/(i2 + m2*side^2 + m2*c2^2) + m1*c1*m2*side^2*g/(i2 + m2*side^2 + m2*c2^2) + m1*c1*i2*g/(i2 + m2*side^2 + m2*c2^2) + m2*i2*d*g/(i2 + m2*side^2 + m2*c2^2)
k18 = m1*m2*c2^2*side*g/(i2 + m2*side^2 + m2*c2^2) + m1*m2*side^3*g/(i2 + m2*side^2 + m2*c2^2) + m1*i2*side*g/(i2 + m2*side^2 + m2*c2^2)
k19 = m2^2*d*side^2*g/(i2 + m2*side^2 + m2*c2^2)
k20 = m2^2*c2^2*d*g/(i2 + m2*side^2 + m2*c2^2)
k21 = m2^2*c2*d*side*g/(i2 + m2*side^2 + m2*c2^2)
k22 = 0.5*(i1 + m1*side^2 + m1*c1^2 + m2*d^2)
k23 = 0.5*(i2 + m2*side^2 + m2*c2^2)
k24 = 2*m2^2*c2*d^2*side
k25 = -1/(i2 + m2*side^2 + m2*c2^2)
k26 = -m2*c2*d/(i2 + m2*side^2 + m2*c2^2)
k27 = -m2*d*side/(i2 + m2*side^2 + m2*c2^2)
```
*/
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct TwoBodies<T = f64> {
        params: TwoBodiesParams,
        constants: [T; 28],
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl TwoBodies {
        /// Builds the model: checks the parameters, and computes once whatever depends on them alone.
        ///
        /// # Errors
        ///
        /// The first parameter, or combination of parameters, that is not finite or that no rigid body can
        /// have.
        pub fn new(
            params: TwoBodiesParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            #[inline]
            fn rules<T: ::pendulum_core::real::Real>(given: [T; 11]) -> [T; 6] {
                let [p_m1, p_c1, p_i1, p_gamma1, p_m2, p_c2, p_i2, p_gamma2, p_d, p_side,
                p_g] = given;
                [p_m1, p_i1, p_gamma1, p_m2, p_i2, p_gamma2]
            }
            #[inline]
            fn constants<T: ::pendulum_core::real::Real>(given: [T; 11]) -> [T; 28] {
                let [p_m1, p_c1, p_i1, p_gamma1, p_m2, p_c2, p_i2, p_gamma2, p_d, p_side,
                p_g] = given;
                let t0 = T::from_f64(2.0) * p_c2;
                let t1 = p_g * (p_m1 * p_side);
                let t2 = p_g * (p_m2 * p_side);
                let t3 = p_gamma1 + p_gamma2;
                let t4 = p_m2 * p_c2;
                let t5 = p_g * t4;
                let t6 = p_d * t4;
                let t7 = p_m2 * p_d;
                let t8 = p_side * t7;
                let t9 = T::from_f64(2.0) * (t6 * t8);
                let t10 = p_side * p_side;
                let t11 = p_c2 * p_c2;
                let t12 = p_i2 + (p_m2 * t10 + p_m2 * t11);
                let t13 = T::from_f64(0.5) * t12;
                let t14 = p_m1 * p_c1;
                let t15 = p_g * t14 + p_g * t7;
                let t16 = p_m1 * (p_c1 * p_c1);
                let t17 = p_m2 * t16;
                let t18 = p_m1 * p_m2;
                let t19 = t11 * t18;
                let t20 = t11 * t17 + t10 * t17 + p_i2 * t16 + t10 * t19
                    + t18 * (p_side * p_side * p_side * p_side);
                let t21 = p_m1 * p_i2;
                let t22 = p_i1 * p_m2;
                let t23 = t20 + t10 * t21 + t11 * t22 + t10 * t22 + p_i1 * p_i2;
                let t24 = p_d * p_d;
                let t25 = T::from_f64(0.5) * (p_i1 + (p_m1 * t10 + t16) + p_m2 * t24);
                let t26 = p_m2 * p_i2;
                let t27 = t23 + t24 * t26;
                let t28 = p_m2 * p_m2;
                let t29 = t10 * (t24 * t28);
                let t30 = t11 * t28;
                let t31 = t24 * t30;
                let t32 = p_m2 * t14;
                let t33 = T::from_f64(1.0) / t12;
                let t34 = p_g * (t11 * t32) * t33 + t33 * (p_g * (t10 * t32))
                    + t33 * (p_g * (p_i2 * t14));
                let t35 = t34 + t33 * (p_g * (p_d * t26));
                let t36 = t33 * (p_g * (p_side * t19))
                    + t33 * (p_g * (t18 * (p_side * p_side * p_side)));
                let t37 = t36 + t33 * (p_g * (p_side * t21));
                let t38 = t33 * (p_g * (t10 * (p_d * t28)));
                let t39 = t33 * (p_g * (p_d * t30));
                let t40 = t33 * (p_g * (p_side * (p_d * (p_c2 * t28))));
                let t41 = T::from_f64(-1.0) / t12;
                let t42 = t6 * t41;
                let t43 = t8 * t41;
                [
                    p_c1,
                    p_c2,
                    p_gamma2,
                    p_d,
                    p_side,
                    t0,
                    t6,
                    t8,
                    t12,
                    t15,
                    t1,
                    t5,
                    t2,
                    t3,
                    t27,
                    t29,
                    t31,
                    t35,
                    t37,
                    t38,
                    t39,
                    t40,
                    t25,
                    t13,
                    t9,
                    t41,
                    t42,
                    t43,
                ]
            }
            let given = params.to_array();
            for (name, value) in TwoBodiesParams::NAMES.into_iter().zip(given) {
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
            let [r0, r1, r2, r3, r4, r5] = rules(given);
            if !(r0 > 0.0) {
                return Err(
                    ::pendulum_core::ParameterError::new(
                        "m1",
                        r0,
                        "the mass of `upper` must be positive",
                        &[],
                    ),
                );
            }
            if !(r1 >= 0.0) {
                return Err(
                    ::pendulum_core::ParameterError::new(
                        "i1",
                        r1,
                        "the inertia of `upper` must not be negative",
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
            if !(r3 > 0.0) {
                return Err(
                    ::pendulum_core::ParameterError::new(
                        "m2",
                        r3,
                        "the mass of `lower` must be positive",
                        &[],
                    ),
                );
            }
            if !(r4 >= 0.0) {
                return Err(
                    ::pendulum_core::ParameterError::new(
                        "i2",
                        r4,
                        "the inertia of `lower` must not be negative",
                        &[],
                    ),
                );
            }
            if !(r5 >= 0.0) {
                return Err(
                    ::pendulum_core::ParameterError::new(
                        "gamma2",
                        r5,
                        "the friction of `lower` must not be negative",
                        &[],
                    ),
                );
            }
            let constants = constants(given);
            let names: [&'static str; 28] = [
                "c1",
                "c2",
                "gamma2",
                "d",
                "side",
                "2*c2",
                "m2*c2*d",
                "m2*d*side",
                "i2 + m2*side^2 + m2*c2^2",
                "m1*c1*g + m2*d*g",
                "m1*side*g",
                "m2*c2*g",
                "m2*side*g",
                "gamma1 + gamma2",
                "m1*c1^2*m2*c2^2 + m1*c1^2*m2*side^2 + m1*c1^2*i2 + m1*m2*c2^2*side^2 + m1*m2*side^4 + m1*i2*side^2 + i1*m2*c2^2 + i1*m2*side^2 + i1*i2 + m2*i2*d^2",
                "m2^2*d^2*side^2",
                "m2^2*c2^2*d^2",
                "m1*c1*m2*c2^2*g/(i2 + m2*side^2 + m2*c2^2) + m1*c1*m2*side^2*g/(i2 + m2*side^2 + m2*c2^2) + m1*c1*i2*g/(i2 + m2*side^2 + m2*c2^2) + m2*i2*d*g/(i2 + m2*side^2 + m2*c2^2)",
                "m1*m2*c2^2*side*g/(i2 + m2*side^2 + m2*c2^2) + m1*m2*side^3*g/(i2 + m2*side^2 + m2*c2^2) + m1*i2*side*g/(i2 + m2*side^2 + m2*c2^2)",
                "m2^2*d*side^2*g/(i2 + m2*side^2 + m2*c2^2)",
                "m2^2*c2^2*d*g/(i2 + m2*side^2 + m2*c2^2)",
                "m2^2*c2*d*side*g/(i2 + m2*side^2 + m2*c2^2)",
                "0.5*(i1 + m1*side^2 + m1*c1^2 + m2*d^2)",
                "0.5*(i2 + m2*side^2 + m2*c2^2)",
                "2*m2^2*c2*d^2*side",
                "-1/(i2 + m2*side^2 + m2*c2^2)",
                "-m2*c2*d/(i2 + m2*side^2 + m2*c2^2)",
                "-m2*d*side/(i2 + m2*side^2 + m2*c2^2)",
            ];
            for (name, value) in names.into_iter().zip(constants) {
                if !value.is_finite() {
                    let given: [_; 11] = ::core::array::from_fn(|n| (
                        TwoBodiesParams::NAMES[n],
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
        pub fn cast<T: ::pendulum_core::real::Real>(&self) -> TwoBodies<T> {
            TwoBodies {
                params: self.params,
                constants: self.constants.map(T::from_f64),
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> TwoBodies<T> {
        /// The parameters that the model was built from.
        pub fn params(&self) -> &TwoBodiesParams {
            &self.params
        }
        /// The model with other parameters, in the same number type. Its constants are computed anew.
        ///
        /// # Errors
        ///
        /// Those of `new`.
        pub fn with_params(
            &self,
            params: TwoBodiesParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            Ok(<TwoBodies>::new(params)?.cast())
        }
    }
    impl TwoBodies {
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
                            "closed form, factors of the state first, exact quotient",
                            ::pendulum_core::Operations::new(22, 34, 1, 2, 0, 33),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, L^T D L",
                                    ::pendulum_core::Operations::new(18, 27, 1, 2, 0, 33),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L",
                                    ::pendulum_core::Operations::new(18, 27, 1, 2, 0, 36),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, adjugate",
                                    ::pendulum_core::Operations::new(29, 35, 1, 2, 0, 38),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C, adjugate",
                                    ::pendulum_core::Operations::new(35, 43, 1, 2, 0, 39),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "articulated bodies",
                                    ::pendulum_core::Operations::new(35, 51, 2, 2, 0, 49),
                                ),
                            ],
                        ),
                ),
                (
                    "kinetic",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(4, 7, 0, 1, 0, 27),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(4, 7, 0, 1, 0, 27),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(4, 7, 0, 1, 0, 27),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(19, 27, 0, 2, 0, 33),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C",
                                    ::pendulum_core::Operations::new(24, 25, 0, 2, 0, 35),
                                ),
                            ],
                        ),
                ),
                (
                    "potential",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(3, 4, 0, 2, 0, 24),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(3, 4, 0, 2, 0, 24),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(3, 4, 0, 2, 0, 24),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C",
                                    ::pendulum_core::Operations::new(3, 4, 0, 2, 0, 24),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(3, 4, 0, 2, 0, 24),
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
        pub const EQUATIONS: &'static str = "A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints\n\nA[theta1, theta1] = i1 + m1*side^2 + m1*c1^2 + m2*d^2\nA[theta1, theta2] = m2*c2*d*cos(theta1 - theta2) - m2*d*side*sin(theta1 - theta2)\nA[theta2, theta2] = i2 + m2*side^2 + m2*c2^2\nb[theta1] = m1*side*g*cos(theta1) + (m1*c1*g + m2*d*g)*sin(theta1) + m2*d*side*dot(theta2)^2*cos(theta1 - theta2)\n    + m2*c2*d*dot(theta2)^2*sin(theta1 - theta2)\nb[theta2] = m2*c2*g*sin(theta2) - m2*d*side*dot(theta1)^2*cos(theta1 - theta2)\n    - m2*c2*d*dot(theta1)^2*sin(theta1 - theta2) - m2*side*g*cos(theta2)\nQ[theta1] = gamma2*dot(theta2) - (gamma1 + gamma2)*dot(theta1)\nQ[theta2] = gamma2*dot(theta1) - gamma2*dot(theta2)\n";
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::System<T, 4> for TwoBodies<T> {
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn rhs(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 4> {
            let [q_theta1, q_theta2, qd_theta1, qd_theta2] = x.data.0[0];
            let k2 = self.constants[2];
            let k6 = self.constants[6];
            let k7 = self.constants[7];
            let k8 = self.constants[8];
            let k11 = self.constants[11];
            let k12 = self.constants[12];
            let k13 = self.constants[13];
            let k14 = self.constants[14];
            let k15 = self.constants[15];
            let k16 = self.constants[16];
            let k17 = self.constants[17];
            let k18 = self.constants[18];
            let k19 = self.constants[19];
            let k20 = self.constants[20];
            let k21 = self.constants[21];
            let k24 = self.constants[24];
            let k25 = self.constants[25];
            let k26 = self.constants[26];
            let k27 = self.constants[27];
            let [(sin_theta1, cos_theta1), (sin_theta2, cos_theta2)] = q_theta1
                .sin_cos_pair(q_theta2);
            let t0 = sin_theta1 * cos_theta2 - cos_theta1 * sin_theta2;
            let t1 = cos_theta2 * cos_theta1 + sin_theta1 * sin_theta2;
            let t2 = k14 + k16 * t0 * t0 + t1 * (k24 * t0 + k15 * t1);
            let t3 = k17 * sin_theta1 + k18 * cos_theta1 + k19 * sin_theta2 * t1
                + k20 * cos_theta2 * t0;
            let t4 = k7 * t1 + k6 * t0;
            let t5 = t3 + k21 * (cos_theta2 * t1 + sin_theta2 * t0) + k13 * qd_theta1
                + qd_theta2 * (qd_theta2 * t4 - k2);
            let t6 = k26 * t1 - k27 * t0;
            let t7 = k2 * qd_theta2 - qd_theta1 * (k2 + qd_theta1 * t4);
            let t8 = k8 / t2 * (t5 + t6 * t7);
            ::pendulum_core::nalgebra::SVector::from([
                qd_theta1,
                qd_theta2,
                -t8,
                k25 * (t7 + k11 * sin_theta2 - k12 * cos_theta2) - t6 * t8,
            ])
        }
        #[inline]
        fn layout(
            &self,
        ) -> ::core::option::Option<&'static ::pendulum_core::StateLayout> {
            Some(&<TwoBodies>::LAYOUT)
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Energy<T, 4> for TwoBodies<T> {
        #[inline]
        fn kinetic(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 4>) -> T {
            let [q_theta1, q_theta2, qd_theta1, qd_theta2] = x.data.0[0];
            let k6 = self.constants[6];
            let k7 = self.constants[7];
            let k22 = self.constants[22];
            let k23 = self.constants[23];
            let t0 = q_theta1 - q_theta2;
            let (sin1, cos1) = t0.sin_cos();
            qd_theta2 * (qd_theta2 * k23)
                + qd_theta1 * (qd_theta2 * (cos1 * k6 - sin1 * k7) + qd_theta1 * k22)
        }
        #[inline]
        fn potential(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 4>) -> T {
            let [q_theta1, q_theta2, _, _] = x.data.0[0];
            let k9 = self.constants[9];
            let k10 = self.constants[10];
            let k11 = self.constants[11];
            let k12 = self.constants[12];
            let [(sin_theta1, cos_theta1), (sin_theta2, cos_theta2)] = q_theta1
                .sin_cos_pair(q_theta2);
            sin_theta1 * k10 - cos_theta1 * k9 - sin_theta2 * k12 - cos_theta2 * k11
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::shapes::Shapes<4> for TwoBodies {
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
                        kind: ::pendulum_core::shapes::ShapeKind::Mass,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "lower",
                        kind: ::pendulum_core::shapes::ShapeKind::Mass,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "upper",
                        kind: ::pendulum_core::shapes::ShapeKind::Rod,
                        points: 2,
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
                        name: "tip",
                        kind: ::pendulum_core::shapes::ShapeKind::Point,
                        points: 1,
                        radius: false,
                    },
                ],
                &{
                    let [q_theta1, q_theta2, _, _] = x.data.0[0];
                    let k0 = self.constants[0];
                    let k1 = self.constants[1];
                    let k3 = self.constants[3];
                    let k4 = self.constants[4];
                    let k5 = self.constants[5];
                    let [(sin_theta1, cos_theta1), (sin_theta2, cos_theta2)] = q_theta1
                        .sin_cos_pair(q_theta2);
                    let t0 = k4 * cos_theta1 + k0 * sin_theta1;
                    let t1 = k4 * sin_theta1 - k0 * cos_theta1;
                    let t2 = k3 * sin_theta1;
                    let t3 = t2 + (k1 * sin_theta2 - k4 * cos_theta2);
                    let t4 = t2 + k5 * sin_theta2;
                    let t5 = k3 * cos_theta1;
                    let t6 = -(t5 + (k4 * sin_theta2 + k1 * cos_theta2));
                    let t7 = -(t5 + k5 * cos_theta2);
                    let t8 = -t5;
                    [
                        t0,
                        t1,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t3,
                        t6,
                        T::from_f64(0.0),
                        t2,
                        t8,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t2,
                        t8,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t2,
                        t8,
                        T::from_f64(0.0),
                        t4,
                        t7,
                        T::from_f64(0.0),
                    ]
                },
            )
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::Cast<4> for TwoBodies {
        type In<T: ::pendulum_core::real::Real> = TwoBodies<T>;
        fn cast<T: ::pendulum_core::real::Real>(&self) -> TwoBodies<T> {
            TwoBodies::cast(self)
        }
        #[inline]
        fn gather<'m, T: ::pendulum_core::real::lanes::Lanes>(
            models: impl ::core::ops::Fn(usize) -> &'m Self,
        ) -> TwoBodies<T>
        where
            Self: 'm,
        {
            let scalar = <<T as ::pendulum_core::real::lanes::Lanes>::Scalar as ::pendulum_core::real::Real>::from_f64;
            TwoBodies {
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
pub use __TwoBodies::{TwoBodies, TwoBodiesParams};
