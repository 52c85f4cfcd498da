#[allow(non_snake_case)]
mod __FourBar {
    ///Parameters of [`FourBar`].
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct FourBarParams {
        ///In m.
        pub a: f64,
        ///In m.
        pub b: f64,
        ///In m.
        pub c: f64,
        ///In m.
        pub d: f64,
        ///In N m s.
        pub gamma: f64,
    }
    impl ::core::default::Default for FourBarParams {
        #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
        fn default() -> Self {
            Self {
                a: 0.2f64,
                b: 0.5f64,
                c: 0.4f64,
                d: 0.6f64,
                gamma: 0.02f64,
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl FourBarParams {
        /// Names of the parameters, in the order of their declaration.
        pub const NAMES: [&'static str; 5] = ["a", "b", "c", "d", "gamma"];
        /// Returns the values of the parameters, in the order of [`NAMES`](Self::NAMES).
        pub const fn to_array(self) -> [f64; 5] {
            [self.a, self.b, self.c, self.d, self.gamma]
        }
        /// Builds parameters from their values, in the order of [`NAMES`](Self::NAMES).
        pub const fn from_array(values: [f64; 5]) -> Self {
            let [v0, v1, v2, v3, v4] = values;
            Self {
                a: v0,
                b: v1,
                c: v2,
                d: v3,
                gamma: v4,
            }
        }
    }
    /// Three bars between two pivots on the ground, the last with friction.
    ///
    /**# Equations of motion

```text
A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints

A[theta, theta] = 0.3*c^2*slope_angle_rocker_theta^2 + 28/15*a^2 + 0.02*t14*slope_angle_coupler_theta*t12
    + 0.18*a*slope_angle_coupler_theta*t13 + slope_angle_coupler_theta*t15
b[theta] = 0.09*a*dot(theta)^2*slope_angle_coupler_theta*t12 + 19.1295*a*c_theta + 0.01*t14*dot(angle_coupler)^2*t13
    + drift_angle_coupler*t15 + 0.0981*(18 + 55*b)*slope_angle_coupler_theta*cos(angle_coupler)
    + 0.3*c^2*slope_angle_rocker_theta*drift_angle_rocker + 4.4145*c*slope_angle_rocker_theta*cos(angle_rocker)
    + 0.01*t14*drift_angle_coupler*t12 + 0.09*a*drift_angle_coupler*t13
    - 0.01*t14*dot(theta)^2*slope_angle_coupler_theta*t13 - 0.09*a*dot(angle_coupler)^2*t12
    - 0.8829*slope_angle_coupler_theta*sin(angle_coupler)
Q[theta] = -gamma*dot(psi)*slope_angle_rocker_theta

where
c_theta = cos(theta)
t0 = d - a*c_theta
t1 = t0^2 + (a*sin(theta))^2
t2 = 0.5 + 0.5*(b^2 - c^2)/t1
t3 = sqrt(b^2/t1 - t2^2)
t4 = t0*t2 + a*sin(theta)*t3
t5 = t0*t3 - a*sin(theta)*t2
angle_coupler = atan2(t5/b, t4/b)
t7 = t0 - t4
t6 = a*sin(theta)*t2 - t0*t3
t8 = t6 - a*sin(theta)
angle_rocker = atan2(-t8/c, -t7/c)
t9 = a*sin(theta) - t6
slope_angle_coupler_theta = -(a*sin(theta)*t7 + a*c_theta*t9)/(t1*t3)
dot(angle_coupler) = dot(theta)*slope_angle_coupler_theta
slope_angle_rocker_theta = (a*sin(theta)*t4 + a*c_theta*t6)/(t1*t3)
dot(angle_rocker) = dot(theta)*slope_angle_rocker_theta
t10 = a*dot(theta)^2*c_theta + t4*dot(angle_coupler)^2 + t7*dot(angle_rocker)^2
t11 = a*dot(theta)^2*sin(theta) + t5*dot(angle_coupler)^2 + t8*dot(angle_rocker)^2
drift_angle_coupler = (t9*t11 - t7*t10)/(t1*t3)
drift_angle_rocker = -(t6*t11 - t4*t10)/(t1*t3)
dot(psi) = dot(angle_rocker)
t12 = cos(theta - angle_coupler)
t13 = sin(theta - angle_coupler)
t14 = 18*a + 55*a*b
t15 = 1/750*(54 + 275*b^2)*slope_angle_coupler_theta
```

# Constants, computed by `new`

```text
k0 = a
k1 = b
k2 = c
k3 = d
k4 = gamma
k5 = b^2
k6 = b^2 - c^2
k7 = 0.5*(b^2 - c^2)
k8 = sqrt(b^2*c^2)
k9 = 1 - atan2(0, a^2 - d^2)/pi
k10 = pi + atan2(0, a)
k11 = d*(1 + atan2(0, a^2 - d^2)/pi - 1)
k12 = (1 + atan2(0, a^2 - d^2)/pi - 1)*atan2(0, d)
k13 = atan2(0, b)
k14 = 0.02*(18*a + 55*a*b)
k15 = 0.18*a
k16 = 1/750*(54 + 275*b^2)
k17 = 28/15*a^2
k18 = 0.3*c^2
k19 = 0.09*a
k20 = 0.01*(18*a + 55*a*b)
k21 = 0.0981*(18 + 55*b)
k22 = 4.4145*c
k23 = 14/15*a^2
k24 = 1/1500*(54 + 275*b^2)
k25 = 0.15*c^2
k26 = 19.1295*a
k27 = 1/b
k28 = 1/sqrt(b^2*c^2)
k29 = 1/c
k30 = 1*4.4145
k31 = 1*0.0981*(18 + 55*b)/b
k32 = 1*0.8829/b
k33 = 2*pi - pi - atan2(0, c)
k34 = 1
k35 = 1
k36 = -1
```
*/
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct FourBar<T = f64> {
        params: FourBarParams,
        constants: [T; 37],
    }
    /// Constants of the model, from its parameters.
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    #[inline]
    fn constants<T: ::pendulum_core::real::Real>(given: [T; 5]) -> [T; 37] {
        let [p_a, p_b, p_c, p_d, p_gamma] = given;
        let t0 = T::from_f64(3.141592653589793) + T::from_f64(0.0).atan2(p_a);
        let t1 = T::from_f64(0.0).atan2(p_b);
        let t2 = T::from_f64(0.18) * p_a;
        let t3 = T::from_f64(0.09) * p_a;
        let t4 = T::from_f64(19.1295) * p_a;
        let t5 = T::from_f64(6.283185307179586)
            - (T::from_f64(3.141592653589793) + T::from_f64(0.0).atan2(p_c));
        let t6 = p_b * p_b;
        let t7 = p_c * p_c;
        let t8 = T::from_f64(0.3) * t7;
        let t9 = T::from_f64(0.15) * t7;
        let t10 = t6 - t7;
        let t11 = T::from_f64(0.5) * t10;
        let t12 = t7 * t6;
        let t13 = t12.sqrt();
        let t14 = T::from_f64(1.0) / t12.sqrt();
        let t15 = T::from_f64(275.0).mul_add(t6, T::from_f64(54.0));
        let t16 = T::from_f64(0.0013333333333333333) * t15;
        let t17 = T::from_f64(0.0006666666666666666) * t15;
        let t18 = p_a * p_a;
        let t19 = T::from_f64(1.8666666666666667) * t18;
        let t20 = T::from_f64(0.9333333333333333) * t18;
        let t21 = T::from_f64(1.0)
            - T::from_f64(0.0).atan2(p_d.mul_neg_add(p_d, t18))
                / T::from_f64(3.141592653589793);
        let t22 = T::from_f64(1.0) - t21;
        let t23 = p_d * t22;
        let t24 = t22 * T::from_f64(0.0).atan2(p_d);
        let t25 = p_b.mul_add(T::from_f64(55.0) * p_a, T::from_f64(18.0) * p_a);
        let t26 = T::from_f64(0.02) * t25;
        let t27 = T::from_f64(0.01) * t25;
        let t28 = T::from_f64(0.0981)
            * T::from_f64(55.0).mul_add(p_b, T::from_f64(18.0));
        let t29 = T::from_f64(4.4145) * p_c;
        let t30 = T::from_f64(1.0) / p_b;
        let t31 = t28 * t30;
        let t32 = T::from_f64(0.8829) * t30;
        let t33 = p_b * t30;
        let t34 = T::from_f64(1.0) / p_c;
        let t35 = t29 * t34;
        let t36 = p_c * t34;
        let t37 = -t36;
        [
            p_a,
            p_b,
            p_c,
            p_d,
            p_gamma,
            t6,
            t10,
            t11,
            t13,
            t21,
            t0,
            t23,
            t24,
            t1,
            t26,
            t2,
            t16,
            t19,
            t8,
            t3,
            t27,
            t28,
            t29,
            t20,
            t17,
            t9,
            t4,
            t30,
            t14,
            t34,
            t35,
            t31,
            t32,
            t5,
            t33,
            t36,
            t37,
        ]
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl FourBar {
        /// Builds the model: checks the parameters, and computes all constants that depend on them alone.
        ///
        /// # Errors
        ///
        /// Returns the first parameter, or combination of parameters, that is not finite or is impossible for a
        /// rigid body.
        pub fn new(
            params: FourBarParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            #[inline]
            fn rules<T: ::pendulum_core::real::Real>(given: [T; 5]) -> [T; 1] {
                let [p_a, p_b, p_c, p_d, p_gamma] = given;
                [p_gamma]
            }
            let given = params.to_array();
            for (name, value) in FourBarParams::NAMES.into_iter().zip(given) {
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
            if !(r0 >= 0.0) {
                return Err(
                    ::pendulum_core::ParameterError::new(
                        "gamma",
                        r0,
                        "the friction of `rocker` must not be negative",
                        &[],
                    ),
                );
            }
            let constants = constants(given);
            let names: [&'static str; 37] = [
                "a",
                "b",
                "c",
                "d",
                "gamma",
                "b^2",
                "b^2 - c^2",
                "0.5*(b^2 - c^2)",
                "sqrt(b^2*c^2)",
                "1 - atan2(0, a^2 - d^2)/pi",
                "pi + atan2(0, a)",
                "d*(1 + atan2(0, a^2 - d^2)/pi - 1)",
                "(1 + atan2(0, a^2 - d^2)/pi - 1)*atan2(0, d)",
                "atan2(0, b)",
                "0.02*(18*a + 55*a*b)",
                "0.18*a",
                "1/750*(54 + 275*b^2)",
                "28/15*a^2",
                "0.3*c^2",
                "0.09*a",
                "0.01*(18*a + 55*a*b)",
                "0.0981*(18 + 55*b)",
                "4.4145*c",
                "14/15*a^2",
                "1/1500*(54 + 275*b^2)",
                "0.15*c^2",
                "19.1295*a",
                "1/b",
                "1/sqrt(b^2*c^2)",
                "1/c",
                "1*4.4145",
                "1*0.0981*(18 + 55*b)/b",
                "1*0.8829/b",
                "2*pi - pi - atan2(0, c)",
                "1",
                "1",
                "-1",
            ];
            for (name, value) in names.into_iter().zip(constants) {
                if !value.is_finite() {
                    let given: [_; 5] = ::core::array::from_fn(|n| (
                        FourBarParams::NAMES[n],
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
        pub fn cast<T: ::pendulum_core::real::Real>(&self) -> FourBar<T> {
            FourBar {
                params: self.params,
                constants: self.constants.map(T::from_f64),
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> FourBar<T> {
        /// Returns the parameters from which the model was built.
        pub fn params(&self) -> &FourBarParams {
            &self.params
        }
        /// Returns a model with other parameters, in the same number type, and recomputes its constants.
        ///
        /// # Errors
        ///
        /// Returns the errors of `new`.
        pub fn with_params(
            &self,
            params: FourBarParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            Ok(<FourBar>::new(params)?.cast())
        }
    }
    impl FourBar {
        ///Index of `theta` in the state, in rad.
        pub const THETA: usize = 0;
        ///Index of `dot(theta)` in the state, in rad/s.
        pub const DOT_THETA: usize = 1;
        /// Number of degrees of freedom. The state has twice as many components.
        pub const DOF: usize = 1;
        /// Names of the coordinates. The state holds their positions and then their rates in this order.
        pub const COORDINATES: [&'static str; 1] = ["theta"];
        /// Operation counts of each generated function, in its own form and in others.
        pub const COST: ::pendulum_core::Cost = ::pendulum_core::Cost::new(
            &[
                (
                    "rhs",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, expanded, L^T D L",
                            ::pendulum_core::Operations::new(33, 65, 4, 1, 1, 57),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factored, L^T D L",
                                    ::pendulum_core::Operations::new(34, 66, 4, 1, 1, 58),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, L^T D L",
                                    ::pendulum_core::Operations::new(49, 70, 4, 1, 1, 59),
                                ),
                            ],
                        ),
                ),
                (
                    "loop_margins",
                    ::pendulum_core::FunctionCost::new(
                        "as declared",
                        ::pendulum_core::Operations::new(7, 22, 4, 1, 1, 43),
                    ),
                ),
                (
                    "jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factored, L^T D L, derived in the graph",
                            ::pendulum_core::Operations::new(107, 184, 6, 1, 1, 76),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L, derived in the graph",
                                    ::pendulum_core::Operations::new(114, 200, 6, 1, 1, 73),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, L^T D L, derived in the graph",
                                    ::pendulum_core::Operations::new(143, 203, 6, 1, 1, 79),
                                ),
                            ],
                        ),
                ),
                (
                    "kinetic",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factored",
                            ::pendulum_core::Operations::new(16, 34, 2, 1, 1, 47),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(16, 34, 2, 1, 1, 47),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(26, 41, 2, 1, 1, 53),
                                ),
                            ],
                        ),
                ),
                (
                    "potential",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factored",
                            ::pendulum_core::Operations::new(10, 15, 2, 1, 1, 46),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(10, 15, 2, 1, 1, 46),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(12, 16, 2, 1, 1, 45),
                                ),
                            ],
                        ),
                ),
                (
                    "follow",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(17, 14, 1, 1, 4, 49),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factored",
                                    ::pendulum_core::Operations::new(17, 14, 1, 1, 4, 49),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(17, 14, 1, 1, 4, 49),
                                ),
                            ],
                        ),
                ),
                (
                    "follow_rate",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(12, 19, 2, 1, 1, 44),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factored",
                                    ::pendulum_core::Operations::new(12, 19, 2, 1, 1, 44),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(12, 19, 2, 1, 1, 44),
                                ),
                            ],
                        ),
                ),
                (
                    "follow_and_jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(24, 25, 2, 1, 4, 49),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factored",
                                    ::pendulum_core::Operations::new(24, 25, 2, 1, 4, 49),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(24, 25, 2, 1, 4, 49),
                                ),
                            ],
                        ),
                ),
                (
                    "gap",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(12, 15, 1, 1, 1, 42),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factored",
                                    ::pendulum_core::Operations::new(12, 15, 1, 1, 1, 42),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(12, 15, 1, 1, 1, 42),
                                ),
                            ],
                        ),
                ),
                (
                    "gap_rate",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factored",
                            ::pendulum_core::Operations::new(14, 30, 2, 1, 1, 47),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(14, 30, 2, 1, 1, 47),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "as declared",
                                    ::pendulum_core::Operations::new(14, 30, 2, 1, 1, 48),
                                ),
                            ],
                        ),
                ),
                (
                    "gap_and_jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(18, 30, 2, 1, 1, 45),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factored",
                                    ::pendulum_core::Operations::new(18, 32, 2, 1, 1, 46),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(18, 32, 2, 1, 1, 46),
                                ),
                            ],
                        ),
                ),
                (
                    "rocking",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(7, 16, 2, 1, 1, 43),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factored",
                                    ::pendulum_core::Operations::new(7, 16, 2, 1, 1, 43),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(7, 16, 2, 1, 1, 43),
                                ),
                            ],
                        ),
                ),
                (
                    "rocking_rate",
                    ::pendulum_core::FunctionCost::new(
                        "as declared",
                        ::pendulum_core::Operations::new(39, 71, 4, 1, 1, 56),
                    ),
                ),
                (
                    "rocking_and_jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(20, 41, 5, 1, 1, 51),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factored",
                                    ::pendulum_core::Operations::new(45, 68, 6, 1, 2, 58),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(54, 299, 6, 1, 2, 74),
                                ),
                            ],
                        ),
                ),
                (
                    "outputs",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(26, 27, 2, 1, 4, 49),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factored",
                                    ::pendulum_core::Operations::new(26, 27, 2, 1, 4, 49),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(26, 27, 2, 1, 4, 49),
                                ),
                            ],
                        ),
                ),
                (
                    "output_rates",
                    ::pendulum_core::FunctionCost::new(
                        "as declared",
                        ::pendulum_core::Operations::new(45, 82, 3, 1, 1, 56),
                    ),
                ),
                (
                    "outputs_and_jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(45, 63, 5, 1, 4, 51),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factored",
                                    ::pendulum_core::Operations::new(70, 92, 6, 1, 5, 58),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(84, 319, 10, 1, 5, 74),
                                ),
                            ],
                        ),
                ),
            ],
        );
        /// Layout of the state.
        pub const LAYOUT: ::pendulum_core::StateLayout<'static> = ::pendulum_core::StateLayout::new(
                &[
                    ::pendulum_core::Slot::new(
                            "theta",
                            ::pendulum_core::SlotKind::Angle,
                            0..1,
                            1..2,
                        )
                        .periodic(),
                ],
            )
            .autonomous();
        /// Equations of motion as text.
        pub const EQUATIONS: &'static str = "A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints\n\nA[theta, theta] = 0.3*c^2*slope_angle_rocker_theta^2 + 28/15*a^2 + 0.02*t14*slope_angle_coupler_theta*t12\n    + 0.18*a*slope_angle_coupler_theta*t13 + slope_angle_coupler_theta*t15\nb[theta] = 0.09*a*dot(theta)^2*slope_angle_coupler_theta*t12 + 19.1295*a*c_theta + 0.01*t14*dot(angle_coupler)^2*t13\n    + drift_angle_coupler*t15 + 0.0981*(18 + 55*b)*slope_angle_coupler_theta*cos(angle_coupler)\n    + 0.3*c^2*slope_angle_rocker_theta*drift_angle_rocker + 4.4145*c*slope_angle_rocker_theta*cos(angle_rocker)\n    + 0.01*t14*drift_angle_coupler*t12 + 0.09*a*drift_angle_coupler*t13\n    - 0.01*t14*dot(theta)^2*slope_angle_coupler_theta*t13 - 0.09*a*dot(angle_coupler)^2*t12\n    - 0.8829*slope_angle_coupler_theta*sin(angle_coupler)\nQ[theta] = -gamma*dot(psi)*slope_angle_rocker_theta\n\nwhere\nc_theta = cos(theta)\nt0 = d - a*c_theta\nt1 = t0^2 + (a*sin(theta))^2\nt2 = 0.5 + 0.5*(b^2 - c^2)/t1\nt3 = sqrt(b^2/t1 - t2^2)\nt4 = t0*t2 + a*sin(theta)*t3\nt5 = t0*t3 - a*sin(theta)*t2\nangle_coupler = atan2(t5/b, t4/b)\nt7 = t0 - t4\nt6 = a*sin(theta)*t2 - t0*t3\nt8 = t6 - a*sin(theta)\nangle_rocker = atan2(-t8/c, -t7/c)\nt9 = a*sin(theta) - t6\nslope_angle_coupler_theta = -(a*sin(theta)*t7 + a*c_theta*t9)/(t1*t3)\ndot(angle_coupler) = dot(theta)*slope_angle_coupler_theta\nslope_angle_rocker_theta = (a*sin(theta)*t4 + a*c_theta*t6)/(t1*t3)\ndot(angle_rocker) = dot(theta)*slope_angle_rocker_theta\nt10 = a*dot(theta)^2*c_theta + t4*dot(angle_coupler)^2 + t7*dot(angle_rocker)^2\nt11 = a*dot(theta)^2*sin(theta) + t5*dot(angle_coupler)^2 + t8*dot(angle_rocker)^2\ndrift_angle_coupler = (t9*t11 - t7*t10)/(t1*t3)\ndrift_angle_rocker = -(t6*t11 - t4*t10)/(t1*t3)\ndot(psi) = dot(angle_rocker)\nt12 = cos(theta - angle_coupler)\nt13 = sin(theta - angle_coupler)\nt14 = 18*a + 55*a*b\nt15 = 1/750*(54 + 275*b^2)*slope_angle_coupler_theta\n";
        ///Names of the components of all outputs.
        pub const OUTPUTS: [&'static str; 5] = [
            "follow[0]",
            "follow[1]",
            "gap[0]",
            "gap[1]",
            "rocking",
        ];
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::System<T, 2> for FourBar<T> {
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn rhs(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 2> {
            let [q_theta, qd_theta] = x.data.0[0];
            let k0 = self.constants[0];
            let k2 = self.constants[2];
            let k3 = self.constants[3];
            let k4 = self.constants[4];
            let k5 = self.constants[5];
            let k7 = self.constants[7];
            let k14 = self.constants[14];
            let k15 = self.constants[15];
            let k16 = self.constants[16];
            let k17 = self.constants[17];
            let k18 = self.constants[18];
            let k19 = self.constants[19];
            let k20 = self.constants[20];
            let k21 = self.constants[21];
            let k22 = self.constants[22];
            let k26 = self.constants[26];
            let k27 = self.constants[27];
            let t0 = qd_theta * qd_theta;
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            let t1 = k0 * cos_theta;
            let t2 = k3 - t1;
            let t3 = k0 * sin_theta;
            let t4 = t3.mul_add(t3, t2 * t2);
            let t5 = T::from_f64(1.0) / t4;
            let t6 = k7.mul_add(t5, T::from_f64(0.5));
            let t7 = t6.mul_neg_add(t6, k5 * t5).sqrt();
            let t8 = T::from_f64(1.0) / (t4 * t7);
            let t9 = t3.mul_neg_add(t6, t2 * t7);
            let t10 = t3.mul_add(t7, t2 * t6);
            let t11 = t2 - t10;
            let t12 = t3 + t9;
            let t13 = t8 * t1.mul_add(t12, t3 * t11);
            let t14 = qd_theta * t13;
            let t15 = t14 * t14;
            let t16 = t8 * t1.mul_neg_add(t9, t3 * t10);
            let t17 = qd_theta * t16;
            let t18 = t17 * t17;
            let t19 = t12.mul_neg_add(t18, t9.mul_add(t15, t3 * t0));
            let t20 = t11.mul_add(t18, t10.mul_add(t15, t1 * t0));
            let t21 = k18 * t16;
            let t22 = k27 * t9;
            let t23 = k27 * t10;
            let t24 = cos_theta.mul_neg_add(t22, sin_theta * t23);
            let t25 = sin_theta.mul_add(t22, cos_theta * t23);
            let t26 = k19.mul_neg_add(t25, k20 * t24);
            let t27 = t13
                .mul_add(
                    k21
                        .mul_neg_add(
                            t23,
                            qd_theta.mul_add(qd_theta * t26, T::from_f64(0.8829) * t22),
                        ),
                    (t8 * t10.mul_add(t20, t9 * t19)).mul_add(t21, k26 * cos_theta),
                );
            let t28 = k16 * t13;
            let t29 = t8 * t11.mul_neg_add(t20, t12 * t19)
                * (k20.mul_add(t25, k19 * t24) - t28);
            let t30 = t16
                .mul_add(
                    k22.mul_neg_add(t11 / k2, k4 * t17),
                    t14.mul_add(t14 * t26, t27 + t29),
                );
            let t31 = t13
                .mul_add(
                    k15.mul_neg_add(t24, k14.mul_neg_add(t25, t28)),
                    t16.mul_add(t21, k17),
                );
            ::pendulum_core::nalgebra::SVector::from([
                qd_theta,
                t30 * (T::from_f64(-1.0) / t31),
            ])
        }
        #[inline]
        fn each_output(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
            tell: &mut dyn FnMut(&str, T),
        ) {
            for (name, output) in <FourBar>::OUTPUTS.iter().zip(&self.outputs(t, x)) {
                tell(name, *output);
            }
        }
        #[inline]
        fn layout(&self) -> ::core::option::Option<::pendulum_core::StateLayout<'_>> {
            Some(<FourBar>::LAYOUT)
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn margins(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
            tell: &mut dyn FnMut([&str; 2], [T; 2]),
        ) {
            let (margins, rates) = self.loop_margins(t, x);
            tell(["coupler", "rocker"], [margins[0], rates[0]]);
        }
    }
    struct __Code<'a, T> {
        t: T,
        x: &'a ::pendulum_core::nalgebra::SVector<T, 2>,
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<
        T: ::pendulum_core::real::Real,
    > ::pendulum_core::real::lanes::Routine<(), FourBar<T>> for __Code<'_, T> {
        type Output = (
            ::pendulum_core::nalgebra::SVector<T, 2>,
            ::pendulum_core::nalgebra::SMatrix<T, 2, 2>,
        );
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn run(
            self,
            (): &mut (),
            model: &FourBar<T>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 2>,
            ::pendulum_core::nalgebra::SMatrix<T, 2, 2>,
        ) {
            let Self { t, x } = self;
            let [q_theta, qd_theta] = x.data.0[0];
            let k0 = model.constants[0];
            let k3 = model.constants[3];
            let k4 = model.constants[4];
            let k5 = model.constants[5];
            let k7 = model.constants[7];
            let k14 = model.constants[14];
            let k15 = model.constants[15];
            let k16 = model.constants[16];
            let k17 = model.constants[17];
            let k18 = model.constants[18];
            let k19 = model.constants[19];
            let k20 = model.constants[20];
            let k21 = model.constants[21];
            let k26 = model.constants[26];
            let k27 = model.constants[27];
            let k30 = model.constants[30];
            let t0 = qd_theta * qd_theta;
            let t1 = T::from_f64(2.0) * qd_theta;
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            let t2 = k0 * cos_theta;
            let t3 = k3 - t2;
            let t4 = k0 * sin_theta;
            let t5 = t4.mul_add(t4, t3 * t3);
            let t6 = T::from_f64(1.0) / t5;
            let t7 = t4 * (T::from_f64(2.0) * (t2 + t3));
            let t8 = k7.mul_add(t6, T::from_f64(0.5));
            let t9 = t8.mul_neg_add(t8, k5 * t6).sqrt();
            let t10 = t7 * (T::from_f64(1.0) / (t5 * t5));
            let t11 = k7 * t10;
            let t12 = T::from_f64(0.5) * (T::from_f64(1.0) / t9)
                * k5.mul_neg_add(t10, T::from_f64(2.0) * t8 * t11);
            let t13 = t5 * t9;
            let t14 = t5.mul_add(t12, t9 * t7) * (T::from_f64(1.0) / (t13 * t13));
            let t15 = T::from_f64(1.0) / t13;
            let t16 = t4 * t9;
            let t17 = t4 * t8;
            let t18 = t3.mul_add(t8, t16);
            let t19 = t4.mul_neg_add(t11, t2 * t8) - t3.mul_add(t12, t16);
            let t20 = t3.mul_neg_add(t11, t4.mul_add(t12, t2.mul_add(t9, t17)));
            let t21 = t3.mul_neg_add(t9, t17);
            let t22 = t3 - t18;
            let t23 = t4 - t21;
            let t24 = t2.mul_add(t23, t4 * t22);
            let t25 = t2.mul_add(t21, t4 * t18);
            let t26 = t2 - t19;
            let t27 = t4 - t20;
            let t28 = t15
                .mul_neg_add(t4.mul_add(t27 - t23, t2 * (t22 + t26)), t24 * t14);
            let t29 = t15 * t24;
            let t30 = t25
                .mul_neg_add(t14, t15 * t4.mul_add(t20 - t21, t2 * (t18 + t19)));
            let t31 = t15 * t25;
            let t32 = qd_theta * t29;
            let t33 = qd_theta * t31;
            let t34 = T::from_f64(2.0) * t32;
            let t35 = t32 * t32;
            let t36 = qd_theta * t28 * t34;
            let t37 = t29 * t34;
            let t38 = qd_theta * t30;
            let t39 = T::from_f64(2.0) * t33;
            let t40 = t4 * t0;
            let t41 = t33 * t33;
            let t42 = t2 * t0;
            let t43 = t38 * t39;
            let t44 = t31 * t39;
            let t45 = t23.mul_neg_add(t44, t21.mul_neg_add(t37, t4 * t1));
            let t46 = t22.mul_add(t44, t18.mul_add(t37, t2 * t1));
            let t47 = t23
                .mul_neg_add(
                    t43,
                    t26.mul_neg_add(t41, t19.mul_neg_add(t35, t21.mul_add(t36, t42))),
                );
            let t48 = t18
                .mul_neg_add(t36, t22.mul_add(t43, t27.mul_add(t41, t20 * t35)) - t40);
            let t49 = t23.mul_neg_add(t41, t21.mul_neg_add(t35, t40));
            let t50 = t22.mul_add(t41, t18.mul_add(t35, t42));
            let t51 = t15
                * t22
                    .mul_neg_add(t48, t50.mul_neg_add(t27, t23.mul_add(t47, t49 * t26)));
            let t52 = t15
                * t18
                    .mul_neg_add(t48, t50.mul_neg_add(t20, t21.mul_add(t47, t49 * t19)));
            let t53 = k27 * t18;
            let t54 = k27 * t21;
            let t55 = cos_theta.mul_add(t54, sin_theta * t53);
            let t56 = sin_theta.mul_neg_add(t54, cos_theta * t53);
            let t57 = t22.mul_neg_add(t50, t23 * t49);
            let t58 = t18.mul_neg_add(t50, t21 * t49);
            let t59 = (k30 * t23)
                .mul_neg_add(t31, k18.mul_add(t58.mul_sub(t14, t52), k4 * t38));
            let t60 = t57.mul_neg_add(t14, t51);
            let t61 = t15 * t22.mul_neg_add(t46, t23 * t45);
            let t62 = k19
                .mul_add(
                    t56.mul_neg_add(t37, t55 * t61),
                    k20 * t56.mul_add(t61, t55 * t37),
                );
            let t63 = t15 * t57;
            let t64 = k18 * t15;
            let t65 = t31
                .mul_add(
                    t18.mul_neg_add(t46, t21 * t45).mul_neg_add(t64, k4 * t31),
                    t62,
                );
            let t66 = k30.mul_neg_add(t22, t58.mul_neg_add(t64, k4 * t33));
            let t67 = k16.mul_neg_add(t29, k15.mul_add(t55, k14 * t56));
            let t68 = qd_theta * k20.mul_neg_add(t55, k19 * t56);
            let t69 = qd_theta
                .mul_add(
                    t68,
                    k21.mul_add(t53, T::from_f64(0.8829).mul_add(t54, k16 * t63)),
                );
            let t70 = k18 * t31;
            let t71 = T::from_f64(1.0) + t29;
            let t72 = T::from_f64(-1.0) / t29.mul_neg_add(t67, t31.mul_add(t70, k17));
            let t73 = t56 * t71;
            let t74 = t55 * t71;
            let t75 = k20
                .mul_add(t73, k19 * t74)
                .mul_neg_add(
                    t0,
                    t29
                        .mul_add(
                            k21.mul_neg_add(t54, T::from_f64(0.8829) * t53),
                            k16 * t60,
                        ),
                );
            let t76 = t29
                .mul_neg_add(
                    k14.mul_neg_add(t74, k15.mul_add(t73, k16 * t28)),
                    t30.mul_add(t70 + t70, t67 * t28),
                );
            let t77 = k20
                * t63
                    .mul_neg_add(t74, t55.mul_neg_add(t36, t56.mul_add(t60, t73 * t35)));
            let t78 = k19
                * t74.mul_add(t35, t56.mul_add(t36, t63.mul_add(t73, t55 * t60)));
            let t79 = t31
                .mul_add(
                    t59,
                    t66
                        .mul_add(
                            t30,
                            t69.mul_add(t28, t77) + k26.mul_neg_add(sin_theta, t78),
                        ),
                );
            let t80 = k20
                .mul_add(
                    t63.mul_add(t56, t55 * t35),
                    k19.mul_add(t56.mul_neg_add(t35, t55 * t63), k26 * cos_theta),
                );
            let t81 = t29.mul_neg_add(t69, t31.mul_add(t66, t80)) * t72;
            (
                ::pendulum_core::nalgebra::SVector::from([qd_theta, t81]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [
                        T::from_f64(0.0),
                        t72 * t29.mul_neg_add(t75, t81.mul_add(t76, t79)),
                    ],
                    [
                        T::from_f64(1.0),
                        t72
                            * t29
                                .mul_neg_add(T::from_f64(2.0).mul_add(t68, k16 * t61), t65),
                    ],
                ]),
            )
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Jacobian<T, 2> for FourBar<T> {
        #[inline]
        fn jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
        ) -> ::pendulum_core::nalgebra::SMatrix<T, 2, 2> {
            T::apart(
                ::pendulum_core::real::lanes::Second(__Code { t, x }),
                &mut (),
                self,
            )
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn rhs_and_jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 2>,
            ::pendulum_core::nalgebra::SMatrix<T, 2, 2>,
        ) {
            T::apart(__Code { t, x }, &mut (), self)
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn time_derivative(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 2> {
            ::pendulum_core::nalgebra::SVector::from([
                T::from_f64(0.0),
                T::from_f64(0.0),
            ])
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Energy<T, 2> for FourBar<T> {
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn kinetic(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 2>) -> T {
            let [q_theta, qd_theta] = x.data.0[0];
            let k0 = self.constants[0];
            let k3 = self.constants[3];
            let k5 = self.constants[5];
            let k7 = self.constants[7];
            let k19 = self.constants[19];
            let k20 = self.constants[20];
            let k23 = self.constants[23];
            let k24 = self.constants[24];
            let k25 = self.constants[25];
            let k27 = self.constants[27];
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            let t0 = k0 * sin_theta;
            let t1 = k0 * cos_theta;
            let t2 = k3 - t1;
            let t3 = t0.mul_add(t0, t2 * t2);
            let t4 = T::from_f64(1.0) / t3;
            let t5 = k7.mul_add(t4, T::from_f64(0.5));
            let t6 = t5.mul_neg_add(t5, k5 * t4).sqrt();
            let t7 = qd_theta * (T::from_f64(1.0) / (t3 * t6));
            let t8 = t0.mul_add(t6, t2 * t5);
            let t9 = t2.mul_neg_add(t6, t0 * t5);
            let t10 = t1.mul_add(t0 - t9, t0 * (t2 - t8)) * t7;
            let t11 = t1.mul_add(t9, t0 * t8) * t7;
            let t12 = k27 * t8;
            let t13 = k27 * t9;
            let t14 = k19
                .mul_add(
                    cos_theta.mul_add(t13, sin_theta * t12),
                    k20 * sin_theta.mul_neg_add(t13, cos_theta * t12),
                );
            qd_theta
                .mul_add(
                    t10.mul_neg_add(t14, k23 * qd_theta),
                    (k25 * t11).mul_add(t11, k24 * t10 * t10),
                )
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn potential(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 2>) -> T {
            let [q_theta, _] = x.data.0[0];
            let k0 = self.constants[0];
            let k2 = self.constants[2];
            let k3 = self.constants[3];
            let k5 = self.constants[5];
            let k7 = self.constants[7];
            let k22 = self.constants[22];
            let k26 = self.constants[26];
            let k31 = self.constants[31];
            let k32 = self.constants[32];
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            let t0 = k0.mul_neg_add(cos_theta, k3);
            let t1 = k0 * sin_theta;
            let t2 = T::from_f64(1.0) / t1.mul_add(t1, t0 * t0);
            let t3 = k7.mul_add(t2, T::from_f64(0.5));
            let t4 = t3.mul_neg_add(t3, k5 * t2).sqrt();
            let t5 = t0.mul_neg_add(t4, t1 * t3);
            let t6 = k22
                .mul_neg_add(
                    (t5 - t1) / k2,
                    k32.mul_add(t1.mul_add(t4, t0 * t3), k26 * sin_theta),
                );
            k31.mul_neg_add(t5, t6)
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> FourBar<T> {
        ///Margin of each closed loop from its singularity (toggle), in the order of the declaration: 0 there, and at most 1. Then the rates of the margins.
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        pub fn loop_margins(
            &self,
            t: T,
            x: &(impl ::pendulum_core::IntoState<T, 2> + Copy),
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 1>,
            ::pendulum_core::nalgebra::SVector<T, 1>,
        ) {
            let x = ::pendulum_core::IntoState::into_state(*x);
            let [q_theta, qd_theta] = x.data.0[0];
            let k0 = self.constants[0];
            let k3 = self.constants[3];
            let k5 = self.constants[5];
            let k6 = self.constants[6];
            let k7 = self.constants[7];
            let k8 = self.constants[8];
            let k28 = self.constants[28];
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            let t0 = k0 * cos_theta;
            let t1 = k0 * sin_theta;
            let t2 = k3 - t0;
            let t3 = t1.mul_add(t1, t2 * t2);
            let t4 = T::from_f64(2.0) * (t1 * qd_theta);
            let t5 = t0.mul_add(t4, t2 * t4);
            let t6 = t5 * (T::from_f64(1.0) / (t3 * t3));
            let t7 = T::from_f64(1.0) / t3;
            let t8 = k7.mul_add(t7, T::from_f64(0.5));
            let t9 = t8.mul_neg_add(t8, k5 * t7).sqrt();
            let t10 = T::from_f64(0.5) * t3 * k5.mul_neg_add(t6, k6 * t8 * t6)
                * (T::from_f64(1.0) / t9);
            (
                ::pendulum_core::nalgebra::SVector::from([t3 * t9 / k8]),
                ::pendulum_core::nalgebra::SVector::from([k28 * t9.mul_add(t5, t10)]),
            )
        }
        ///Output `follow`.
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        pub fn follow(
            &self,
            t: T,
            x: &(impl ::pendulum_core::IntoState<T, 2> + Copy),
        ) -> ::pendulum_core::nalgebra::SVector<T, 2> {
            let x = ::pendulum_core::IntoState::into_state(*x);
            let [q_theta, _] = x.data.0[0];
            let k0 = self.constants[0];
            let k3 = self.constants[3];
            let k5 = self.constants[5];
            let k7 = self.constants[7];
            let k9 = self.constants[9];
            let k10 = self.constants[10];
            let k11 = self.constants[11];
            let k12 = self.constants[12];
            let k13 = self.constants[13];
            let k33 = self.constants[33];
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            let t0 = k0 * cos_theta;
            let t1 = k0 * sin_theta;
            let t2 = k3 - t0;
            let t3 = k9.mul_neg_add(t0, k11);
            let t4 = T::from_f64(1.0) / t1.mul_add(t1, t2 * t2);
            let t5 = k7.mul_add(t4, T::from_f64(0.5));
            let t6 = t5.mul_neg_add(t5, k5 * t4).sqrt();
            let t7 = k9 * t1;
            let t8 = k9.mul_add(k10 + q_theta, k12)
                + t1.mul_neg_add(t3, t2 * t7).atan2(t1.mul_add(t7, t2 * t3));
            ::pendulum_core::nalgebra::SVector::from([
                t6.atan2(t5) + t8 - q_theta - k13,
                k33 + t8 + (-t6).atan2(T::from_f64(1.0) - t5),
            ])
        }
        ///Rate of `follow` along the motion.
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        pub fn follow_rate(
            &self,
            t: T,
            x: &(impl ::pendulum_core::IntoState<T, 2> + Copy),
        ) -> ::pendulum_core::nalgebra::SVector<T, 2> {
            let x = ::pendulum_core::IntoState::into_state(*x);
            let [q_theta, qd_theta] = x.data.0[0];
            let k0 = self.constants[0];
            let k3 = self.constants[3];
            let k5 = self.constants[5];
            let k7 = self.constants[7];
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            let t0 = k0 * sin_theta;
            let t1 = k0 * cos_theta;
            let t2 = k3 - t1;
            let t3 = t0.mul_add(t0, t2 * t2);
            let t4 = T::from_f64(1.0) / t3;
            let t5 = k7.mul_add(t4, T::from_f64(0.5));
            let t6 = t5.mul_neg_add(t5, k5 * t4).sqrt();
            let t7 = qd_theta * (T::from_f64(1.0) / (t3 * t6));
            let t8 = t0.mul_add(t6, t2 * t5);
            let t9 = t2.mul_neg_add(t6, t0 * t5);
            ::pendulum_core::nalgebra::SVector::from([
                -t1.mul_add(t0 - t9, t0 * (t2 - t8)).mul_add(t7, qd_theta),
                t1.mul_add(t9, t0 * t8) * t7,
            ])
        }
        ///Value of `follow`, and its derivatives with respect to the state: one row for each component, with the components of a matrix in column-major order.
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        pub fn follow_and_jacobian(
            &self,
            t: T,
            x: &(impl ::pendulum_core::IntoState<T, 2> + Copy),
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 2>,
            ::pendulum_core::nalgebra::SMatrix<T, 2, 2>,
        ) {
            let x = ::pendulum_core::IntoState::into_state(*x);
            let [q_theta, _] = x.data.0[0];
            let k0 = self.constants[0];
            let k3 = self.constants[3];
            let k5 = self.constants[5];
            let k7 = self.constants[7];
            let k9 = self.constants[9];
            let k10 = self.constants[10];
            let k11 = self.constants[11];
            let k12 = self.constants[12];
            let k13 = self.constants[13];
            let k33 = self.constants[33];
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            let t0 = k0 * cos_theta;
            let t1 = k0 * sin_theta;
            let t2 = k3 - t0;
            let t3 = k9.mul_neg_add(t0, k11);
            let t4 = t1.mul_add(t1, t2 * t2);
            let t5 = T::from_f64(1.0) / t4;
            let t6 = k7.mul_add(t5, T::from_f64(0.5));
            let t7 = t6.mul_neg_add(t6, k5 * t5).sqrt();
            let t8 = T::from_f64(1.0) / (t4 * t7);
            let t9 = k9 * t1;
            let t10 = k9.mul_add(k10 + q_theta, k12)
                + t1.mul_neg_add(t3, t2 * t9).atan2(t1.mul_add(t9, t2 * t3));
            let t11 = t1.mul_add(t7, t2 * t6);
            let t12 = t2.mul_neg_add(t7, t1 * t6);
            (
                ::pendulum_core::nalgebra::SVector::from([
                    t7.atan2(t6) + t10 - q_theta - k13,
                    k33 + t10 + (-t7).atan2(T::from_f64(1.0) - t6),
                ]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [
                        t8
                            .mul_neg_add(
                                t0.mul_add(t1 - t12, t1 * (t2 - t11)),
                                T::from_f64(-1.0),
                            ),
                        t8 * t0.mul_add(t12, t1 * t11),
                    ],
                    [T::from_f64(0.0), T::from_f64(0.0)],
                ]),
            )
        }
        ///Output `gap`.
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        pub fn gap(
            &self,
            t: T,
            x: &(impl ::pendulum_core::IntoState<T, 2> + Copy),
        ) -> ::pendulum_core::nalgebra::SVector<T, 2> {
            let x = ::pendulum_core::IntoState::into_state(*x);
            let [q_theta, _] = x.data.0[0];
            let k0 = self.constants[0];
            let k3 = self.constants[3];
            let k5 = self.constants[5];
            let k7 = self.constants[7];
            let k34 = self.constants[34];
            let k35 = self.constants[35];
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            let t0 = k0 * sin_theta;
            let t1 = k0.mul_sub(cos_theta, k3);
            let t2 = T::from_f64(1.0) / t0.mul_add(t0, t1 * t1);
            let t3 = k7.mul_add(t2, T::from_f64(0.5));
            let t4 = t3.mul_neg_add(t3, k5 * t2).sqrt();
            let t5 = t1.mul_neg_add(t3, t0 * t4);
            let t6 = t0.mul_add(t3, t1 * t4);
            ::pendulum_core::nalgebra::SVector::from([
                k35.mul_neg_add(t1 + t5, k34.mul_add(t5, t1)),
                k34.mul_neg_add(t6, k35.mul_add(t6 - t0, t0)),
            ])
        }
        ///Rate of `gap` along the motion.
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        pub fn gap_rate(
            &self,
            t: T,
            x: &(impl ::pendulum_core::IntoState<T, 2> + Copy),
        ) -> ::pendulum_core::nalgebra::SVector<T, 2> {
            let x = ::pendulum_core::IntoState::into_state(*x);
            let [q_theta, qd_theta] = x.data.0[0];
            let k0 = self.constants[0];
            let k1 = self.constants[1];
            let k2 = self.constants[2];
            let k3 = self.constants[3];
            let k5 = self.constants[5];
            let k7 = self.constants[7];
            let k27 = self.constants[27];
            let k29 = self.constants[29];
            let t0 = k0 * qd_theta;
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            let t1 = k0 * sin_theta;
            let t2 = k0 * cos_theta;
            let t3 = k3 - t2;
            let t4 = t1.mul_add(t1, t3 * t3);
            let t5 = T::from_f64(1.0) / t4;
            let t6 = k7.mul_add(t5, T::from_f64(0.5));
            let t7 = t6.mul_neg_add(t6, k5 * t5).sqrt();
            let t8 = qd_theta * (T::from_f64(1.0) / (t4 * t7));
            let t9 = t1.mul_neg_add(t6, t3 * t7);
            let t10 = t1.mul_add(t7, t3 * t6);
            let t11 = t3 - t10;
            let t12 = k29 * (k2 * t2.mul_neg_add(t9, t1 * t10) * t8);
            let t13 = t1 + t9;
            let t14 = k27 * (k1 * t2.mul_add(t13, t1 * t11) * t8);
            ::pendulum_core::nalgebra::SVector::from([
                t13.mul_sub(t12, t9.mul_neg_add(t14, sin_theta * t0)),
                t10.mul_neg_add(t14, t11.mul_add(t12, t0 * cos_theta)),
            ])
        }
        ///Value of `gap`, and its derivatives with respect to the state: one row for each component, with the components of a matrix in column-major order.
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        pub fn gap_and_jacobian(
            &self,
            t: T,
            x: &(impl ::pendulum_core::IntoState<T, 2> + Copy),
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 2>,
            ::pendulum_core::nalgebra::SMatrix<T, 2, 2>,
        ) {
            let x = ::pendulum_core::IntoState::into_state(*x);
            let [q_theta, _] = x.data.0[0];
            let k0 = self.constants[0];
            let k1 = self.constants[1];
            let k2 = self.constants[2];
            let k3 = self.constants[3];
            let k5 = self.constants[5];
            let k7 = self.constants[7];
            let k27 = self.constants[27];
            let k29 = self.constants[29];
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            let t0 = k0 * sin_theta;
            let t1 = k0 * cos_theta;
            let t2 = t1 - k3;
            let t3 = t0.mul_add(t0, t2 * t2);
            let t4 = T::from_f64(1.0) / t3;
            let t5 = k7.mul_add(t4, T::from_f64(0.5));
            let t6 = t5.mul_neg_add(t5, k5 * t4).sqrt();
            let t7 = T::from_f64(1.0) / (t3 * t6);
            let t8 = t2.mul_neg_add(t5, t0 * t6);
            let t9 = t0.mul_add(t5, t2 * t6);
            let t10 = t2 + t8;
            let t11 = k1 * (k27 * t8);
            let t12 = t7 * t1.mul_add(t9, t0 * t8);
            let t13 = k2 * (k29 * t10);
            let t14 = k1 * (k27 * t9);
            let t15 = t0 - t9;
            let t16 = t7 * t0.mul_neg_add(t10, t1 * t15);
            let t17 = k2 * (k29 * t15);
            (
                ::pendulum_core::nalgebra::SVector::from([
                    t11 + t2 - t13,
                    t0 - t14 - t17,
                ]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [
                        t17.mul_sub(t12, t14.mul_add(t16, t0)),
                        t13.mul_neg_add(t12, t11.mul_neg_add(t16, t1)),
                    ],
                    [T::from_f64(0.0), T::from_f64(0.0)],
                ]),
            )
        }
        ///Output `rocking`.
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        pub fn rocking(
            &self,
            t: T,
            x: &(impl ::pendulum_core::IntoState<T, 2> + Copy),
        ) -> T {
            let x = ::pendulum_core::IntoState::into_state(*x);
            let [q_theta, qd_theta] = x.data.0[0];
            let k0 = self.constants[0];
            let k3 = self.constants[3];
            let k5 = self.constants[5];
            let k7 = self.constants[7];
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            let t0 = k0 * cos_theta;
            let t1 = k0 * sin_theta;
            let t2 = k3 - t0;
            let t3 = t1.mul_add(t1, t2 * t2);
            let t4 = T::from_f64(1.0) / t3;
            let t5 = t4.mul_add(k7, T::from_f64(0.5));
            let t6 = t5.mul_neg_add(t5, k5 * t4).sqrt();
            let t7 = t0
                .mul_add(t2.mul_neg_add(t6, t1 * t5), t1 * t1.mul_add(t6, t2 * t5));
            qd_theta * (T::from_f64(1.0) / (t3 * t6) * t7)
        }
        ///Rate of `rocking` along the motion.
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        pub fn rocking_rate(
            &self,
            t: T,
            x: &(impl ::pendulum_core::IntoState<T, 2> + Copy),
        ) -> T {
            let x = ::pendulum_core::IntoState::into_state(*x);
            let [q_theta, qd_theta] = x.data.0[0];
            let k0 = self.constants[0];
            let k2 = self.constants[2];
            let k3 = self.constants[3];
            let k4 = self.constants[4];
            let k5 = self.constants[5];
            let k7 = self.constants[7];
            let k14 = self.constants[14];
            let k15 = self.constants[15];
            let k16 = self.constants[16];
            let k17 = self.constants[17];
            let k18 = self.constants[18];
            let k19 = self.constants[19];
            let k20 = self.constants[20];
            let k21 = self.constants[21];
            let k22 = self.constants[22];
            let k26 = self.constants[26];
            let k27 = self.constants[27];
            let t0 = qd_theta * qd_theta;
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            let t1 = k0 * cos_theta;
            let t2 = k3 - t1;
            let t3 = k0 * sin_theta;
            let t4 = t3.mul_add(t3, t2 * t2);
            let t5 = T::from_f64(1.0) / t4;
            let t6 = k7.mul_add(t5, T::from_f64(0.5));
            let t7 = t6.mul_neg_add(t6, k5 * t5).sqrt();
            let t8 = T::from_f64(1.0) / (t4 * t7);
            let t9 = t3.mul_add(t7, t2 * t6);
            let t10 = t2.mul_neg_add(t7, t3 * t6);
            let t11 = t2 - t9;
            let t12 = t8 * t1.mul_add(t10, t3 * t9);
            let t13 = t12 * qd_theta;
            let t14 = k27 * t9;
            let t15 = k27 * t10;
            let t16 = cos_theta.mul_add(t15, sin_theta * t14);
            let t17 = sin_theta.mul_neg_add(t15, cos_theta * t14);
            let t18 = k19.mul_neg_add(t17, k20 * t16);
            let t19 = t3 - t10;
            let t20 = t1.mul_add(t19, t3 * t11);
            let t21 = t3 * t0;
            let t22 = t1 * t0;
            let t23 = t8 * t20;
            let t24 = t8 * qd_theta * t20;
            let t25 = t24 * t24;
            let t26 = qd_theta * t23;
            let t27 = t26 * t26;
            let t28 = t23
                .mul_add(
                    k21.mul_neg_add(t14, T::from_f64(0.8829).mul_neg_add(t15, t18 * t0)),
                    t18.mul_add(t27, t12 * k22.mul_neg_add(t11 / k2, k4 * t13)),
                );
            let t29 = t13 * t13;
            let t30 = t19 * t29;
            let t31 = t11 * t29;
            let t32 = t9
                .mul_neg_add(
                    t9.mul_add(t25, t22) + t31,
                    t10 * (t10.mul_neg_add(t25, t21) - t30),
                );
            let t33 = t10.mul_neg_add(t27, t21) - t30;
            let t34 = t9.mul_add(t27, t31 + t22);
            let t35 = k16 * t23;
            let t36 = t11.mul_neg_add(t34, t19 * t33)
                * (k20.mul_add(t17, k19 * t16) - t35);
            let t37 = k18 * t12;
            let t38 = t8
                .mul_add(
                    t37.mul_add(t10.mul_neg_add(t33, t9 * t34), t36),
                    k26.mul_add(cos_theta, t28),
                );
            let t39 = t23
                .mul_add(
                    k15.mul_neg_add(t16, k14.mul_neg_add(t17, t35)),
                    t12.mul_add(t37, k17),
                );
            t8.mul_neg_add(t32, t12 * t38 * (T::from_f64(-1.0) / t39))
        }
        ///Value of `rocking`, and its derivatives with respect to the state: one row for each component, with the components of a matrix in column-major order.
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        pub fn rocking_and_jacobian(
            &self,
            t: T,
            x: &(impl ::pendulum_core::IntoState<T, 2> + Copy),
        ) -> (T, ::pendulum_core::nalgebra::SMatrix<T, 1, 2>) {
            let x = ::pendulum_core::IntoState::into_state(*x);
            let [q_theta, qd_theta] = x.data.0[0];
            let k0 = self.constants[0];
            let k3 = self.constants[3];
            let k5 = self.constants[5];
            let k7 = self.constants[7];
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            let t0 = k0 * cos_theta;
            let t1 = k0 * sin_theta;
            let t2 = k3 - t0;
            let t3 = t1.mul_add(t1, t2 * t2);
            let t4 = T::from_f64(1.0) / t3;
            let t5 = k7.mul_add(t4, T::from_f64(0.5));
            let t6 = t5.mul_neg_add(t5, k5 * t4).sqrt();
            let t7 = t3 * t6;
            let t8 = T::from_f64(1.0) / t7;
            let t9 = t1 * t6;
            let t10 = t2.mul_add(t5, t9);
            let t11 = t1 * t5;
            let t12 = t2.mul_neg_add(t6, t11);
            let t13 = t0.mul_add(t12, t1 * t10);
            let t14 = t8 * t13;
            let t15 = t1 * (T::from_f64(2.0) * (t0 + t2));
            let t16 = T::from_f64(1.0) / (t3 * t3) * t15;
            let t17 = k7 * t16;
            let t18 = T::from_f64(0.5) * (T::from_f64(1.0) / t6)
                * k5.mul_neg_add(t16, T::from_f64(2.0) * t5 * t17);
            let t19 = t0
                * (t10 + t2.mul_neg_add(t18, t1.mul_neg_add(t17, t0.mul_sub(t5, t9))));
            let t20 = t1
                * (t2.mul_neg_add(t17, t1.mul_add(t18, t0.mul_add(t6, t11))) - t12);
            let t21 = (t13 * t3.mul_add(t18, t6 * t15))
                .mul_neg_add(T::from_f64(1.0) / (t7 * t7), t8 * (t19 + t20));
            (
                qd_theta * t14,
                ::pendulum_core::nalgebra::SMatrix::from([[qd_theta * t21], [t14]]),
            )
        }
        ///All outputs, in the order of `OUTPUTS`.
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        pub fn outputs(
            &self,
            t: T,
            x: &(impl ::pendulum_core::IntoState<T, 2> + Copy),
        ) -> ::pendulum_core::nalgebra::SVector<T, 5> {
            let x = ::pendulum_core::IntoState::into_state(*x);
            let [q_theta, qd_theta] = x.data.0[0];
            let k0 = self.constants[0];
            let k3 = self.constants[3];
            let k5 = self.constants[5];
            let k7 = self.constants[7];
            let k9 = self.constants[9];
            let k10 = self.constants[10];
            let k11 = self.constants[11];
            let k12 = self.constants[12];
            let k13 = self.constants[13];
            let k33 = self.constants[33];
            let k34 = self.constants[34];
            let k35 = self.constants[35];
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            let t0 = k0 * cos_theta;
            let t1 = k0 * sin_theta;
            let t2 = k3 - t0;
            let t3 = k9.mul_neg_add(t0, k11);
            let t4 = t1.mul_add(t1, t2 * t2);
            let t5 = T::from_f64(1.0) / t4;
            let t6 = k7.mul_add(t5, T::from_f64(0.5));
            let t7 = t6.mul_neg_add(t6, k5 * t5).sqrt();
            let t8 = k9 * t1;
            let t9 = k9.mul_add(k10 + q_theta, k12)
                + t1.mul_neg_add(t3, t2 * t8).atan2(t1.mul_add(t8, t2 * t3));
            let t10 = t1.mul_add(t7, t2 * t6);
            let t11 = t1.mul_neg_add(t6, t2 * t7);
            ::pendulum_core::nalgebra::SVector::from([
                t7.atan2(t6) + t9 - q_theta - k13,
                k33 + t9 + (-t7).atan2(T::from_f64(1.0) - t6),
                k35.mul_add(t2 - t10, k34 * t10) - t2,
                k35.mul_neg_add(t1 + t11, k34.mul_add(t11, t1)),
                qd_theta * (T::from_f64(1.0) / (t4 * t7)) * t0.mul_neg_add(t11, t1 * t10),
            ])
        }
        ///Rate of all outputs along the motion.
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        pub fn output_rates(
            &self,
            t: T,
            x: &(impl ::pendulum_core::IntoState<T, 2> + Copy),
        ) -> ::pendulum_core::nalgebra::SVector<T, 5> {
            let x = ::pendulum_core::IntoState::into_state(*x);
            let [q_theta, qd_theta] = x.data.0[0];
            let k0 = self.constants[0];
            let k1 = self.constants[1];
            let k2 = self.constants[2];
            let k3 = self.constants[3];
            let k4 = self.constants[4];
            let k5 = self.constants[5];
            let k7 = self.constants[7];
            let k14 = self.constants[14];
            let k15 = self.constants[15];
            let k16 = self.constants[16];
            let k17 = self.constants[17];
            let k18 = self.constants[18];
            let k19 = self.constants[19];
            let k20 = self.constants[20];
            let k21 = self.constants[21];
            let k22 = self.constants[22];
            let k26 = self.constants[26];
            let k27 = self.constants[27];
            let k29 = self.constants[29];
            let t0 = k0 * qd_theta;
            let t1 = qd_theta * qd_theta;
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            let t2 = k0 * cos_theta;
            let t3 = k3 - t2;
            let t4 = k0 * sin_theta;
            let t5 = t4.mul_add(t4, t3 * t3);
            let t6 = T::from_f64(1.0) / t5;
            let t7 = k7.mul_add(t6, T::from_f64(0.5));
            let t8 = t7.mul_neg_add(t7, k5 * t6).sqrt();
            let t9 = T::from_f64(1.0) / (t5 * t8);
            let t10 = t4.mul_add(t8, t3 * t7);
            let t11 = t3.mul_neg_add(t8, t4 * t7);
            let t12 = t3 - t10;
            let t13 = t4 - t11;
            let t14 = t2.mul_add(t13, t4 * t12);
            let t15 = qd_theta * t9 * t14;
            let t16 = t9 * t14;
            let t17 = t9 * t2.mul_add(t11, t4 * t10);
            let t18 = t4 * t1;
            let t19 = t2 * t1;
            let t20 = qd_theta * t17;
            let t21 = k2 * t20;
            let t22 = k27 * t11;
            let t23 = k1 * t15;
            let t24 = t15 * t15;
            let t25 = k29 * t12;
            let t26 = k27 * t10;
            let t27 = cos_theta.mul_add(t22, sin_theta * t26);
            let t28 = sin_theta.mul_neg_add(t22, cos_theta * t26);
            let t29 = k19.mul_neg_add(t28, k20 * t27);
            let t30 = qd_theta * t16;
            let t31 = t30 * t30;
            let t32 = t16
                .mul_add(
                    k21.mul_neg_add(t26, T::from_f64(0.8829).mul_neg_add(t22, t29 * t1)),
                    t29.mul_add(t31, t17 * k22.mul_neg_add(t25, k4 * t20)),
                );
            let t33 = t20 * t20;
            let t34 = t13 * t33;
            let t35 = t12 * t33;
            let t36 = t10
                .mul_neg_add(
                    t10.mul_add(t24, t19) + t35,
                    t11 * (t11.mul_neg_add(t24, t18) - t34),
                );
            let t37 = t11.mul_neg_add(t31, t18) - t34;
            let t38 = t10.mul_add(t31, t35 + t19);
            let t39 = k16 * t16;
            let t40 = t12.mul_neg_add(t38, t13 * t37)
                * (k20.mul_add(t28, k19 * t27) - t39);
            let t41 = k18 * t17;
            let t42 = t9
                .mul_add(
                    t41.mul_add(t11.mul_neg_add(t37, t10 * t38), t40),
                    k26.mul_add(cos_theta, t32),
                );
            let t43 = t16
                .mul_add(
                    k15.mul_neg_add(t27, k14.mul_neg_add(t28, t39)),
                    t17.mul_add(t41, k17),
                );
            ::pendulum_core::nalgebra::SVector::from([
                -(qd_theta + t15),
                t20,
                (k29 * t13).mul_sub(t21, t22.mul_add(t23, sin_theta * t0)),
                t26.mul_neg_add(t23, t25.mul_add(t21, cos_theta * t0)),
                t9.mul_neg_add(t36, t17 * t42 * (T::from_f64(-1.0) / t43)),
            ])
        }
        ///Value of all outputs, and its derivatives with respect to the state: one row for each component, with the components of a matrix in column-major order.
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        pub fn outputs_and_jacobian(
            &self,
            t: T,
            x: &(impl ::pendulum_core::IntoState<T, 2> + Copy),
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 5>,
            ::pendulum_core::nalgebra::SMatrix<T, 5, 2>,
        ) {
            let x = ::pendulum_core::IntoState::into_state(*x);
            let [q_theta, qd_theta] = x.data.0[0];
            let k0 = self.constants[0];
            let k1 = self.constants[1];
            let k2 = self.constants[2];
            let k3 = self.constants[3];
            let k5 = self.constants[5];
            let k7 = self.constants[7];
            let k9 = self.constants[9];
            let k10 = self.constants[10];
            let k11 = self.constants[11];
            let k12 = self.constants[12];
            let k13 = self.constants[13];
            let k27 = self.constants[27];
            let k29 = self.constants[29];
            let k33 = self.constants[33];
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            let t0 = k0 * cos_theta;
            let t1 = k0 * sin_theta;
            let t2 = k3 - t0;
            let t3 = t1.mul_add(t1, t2 * t2);
            let t4 = T::from_f64(1.0) / t3;
            let t5 = t1 * (T::from_f64(2.0) * (t0 + t2));
            let t6 = k7.mul_add(t4, T::from_f64(0.5));
            let t7 = t6.mul_neg_add(t6, k5 * t4).sqrt();
            let t8 = k9.mul_neg_add(t0, k11);
            let t9 = k9 * t1;
            let t10 = k9.mul_add(k10 + q_theta, k12)
                + t1.mul_neg_add(t8, t2 * t9).atan2(t1.mul_add(t9, t2 * t8));
            let t11 = t7.atan2(t6) + t10 - q_theta - k13;
            let t12 = k33 + t10 + (-t7).atan2(T::from_f64(1.0) - t6);
            let t13 = T::from_f64(1.0) / (t3 * t3) * t5;
            let t14 = k7 * t13;
            let t15 = T::from_f64(0.5) * (T::from_f64(1.0) / t7)
                * k5.mul_neg_add(t13, T::from_f64(2.0) * t6 * t14);
            let t16 = t1 * t7;
            let t17 = t1 * t6;
            let t18 = t2.mul_add(t6, t16);
            let t19 = t0
                * (t18 + t2.mul_neg_add(t15, t1.mul_neg_add(t14, t0.mul_sub(t6, t16))));
            let t20 = t2.mul_sub(t7, t17);
            let t21 = t1
                * (t20 + t2.mul_neg_add(t14, t1.mul_add(t15, t0.mul_add(t7, t17))));
            let t22 = t3 * t7;
            let t23 = T::from_f64(1.0) / t22;
            let t24 = t0.mul_neg_add(t20, t1 * t18);
            let t25 = (t24 * t3.mul_add(t15, t7 * t5))
                .mul_neg_add(T::from_f64(1.0) / (t22 * t22), t23 * (t19 + t21));
            let t26 = qd_theta * t25;
            let t27 = t23 * t24;
            let t28 = qd_theta * t27;
            let t29 = t2 - t18;
            let t30 = k1 * (k27 * t18);
            let t31 = t1 + t20;
            let t32 = t23 * t0.mul_add(t31, t1 * t29);
            let t33 = k2 * (k29 * t29);
            let t34 = t30.mul_neg_add(t32, t33.mul_add(t27, t0));
            let t35 = t30 + t33 - t2;
            let t36 = k1 * (k27 * t20);
            let t37 = k2 * (k29 * t31);
            let t38 = t37.mul_sub(t27, t36.mul_neg_add(t32, t1));
            let t39 = t1 + t36 - t37;
            let t40 = T::from_f64(-1.0) - t32;
            (
                ::pendulum_core::nalgebra::SVector::from([t11, t12, t35, t39, t28]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [t40, t27, t38, t34, t26],
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t27,
                    ],
                ]),
            )
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::shapes::Shapes<2> for FourBar {
        fn shapes(
            &self,
            t: f64,
            x: &::pendulum_core::nalgebra::SVector<f64, 2>,
        ) -> ::pendulum_core::shapes::Vec<::pendulum_core::shapes::Shape<'_>> {
            trait Values<T> {
                fn values(
                    &self,
                    t: T,
                    x: &::pendulum_core::nalgebra::SVector<T, 2>,
                ) -> [T; 45];
            }
            #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
            impl<T: ::pendulum_core::real::Real> Values<T> for FourBar<T> {
                fn values(
                    &self,
                    t: T,
                    x: &::pendulum_core::nalgebra::SVector<T, 2>,
                ) -> [T; 45] {
                    {
                        let [q_theta, _] = x.data.0[0];
                        let k0 = self.constants[0];
                        let k1 = self.constants[1];
                        let k3 = self.constants[3];
                        let k5 = self.constants[5];
                        let k7 = self.constants[7];
                        let k27 = self.constants[27];
                        let k35 = self.constants[35];
                        let k36 = self.constants[36];
                        let (sin_theta, cos_theta) = q_theta.sin_cos();
                        let t0 = k0 * cos_theta;
                        let t1 = k0 * sin_theta;
                        let t2 = k3 - t0;
                        let t3 = T::from_f64(1.0) / t1.mul_add(t1, t2 * t2);
                        let t4 = k7.mul_add(t3, T::from_f64(0.5));
                        let t5 = t4.mul_neg_add(t4, k5 * t3).sqrt();
                        let t6 = t1.mul_add(t5, t2 * t4);
                        let t7 = t2.mul_neg_add(t5, t1 * t4);
                        let t8 = k35.mul_neg_add(t2 - t6, k3);
                        let t9 = k27 * t6;
                        let t10 = k36 * (t7 - t1);
                        let t11 = k27 * t7;
                        let t12 = k1.mul_add(t9, t0);
                        let t13 = T::from_f64(0.3) * t9;
                        let t14 = t0 + t13;
                        let t15 = k1.mul_neg_add(t11, t1);
                        let t16 = T::from_f64(0.3) * t11;
                        let t17 = t1 - t16;
                        let t18 = t14 + t16;
                        let t19 = t13 + t17;
                        [
                            T::from_f64(0.0),
                            T::from_f64(0.0),
                            T::from_f64(0.0),
                            t0,
                            t1,
                            T::from_f64(0.0),
                            k3,
                            T::from_f64(0.0),
                            T::from_f64(0.0),
                            t8,
                            t10,
                            T::from_f64(0.0),
                            t0,
                            t1,
                            T::from_f64(0.0),
                            t12,
                            t15,
                            T::from_f64(0.0),
                            t14,
                            t17,
                            T::from_f64(0.0),
                            t18,
                            t19,
                            T::from_f64(0.0),
                            T::from_f64(0.0),
                            T::from_f64(0.0),
                            T::from_f64(0.0),
                            k3,
                            T::from_f64(0.0),
                            T::from_f64(0.0),
                            t0,
                            t1,
                            T::from_f64(0.0),
                            t12,
                            t15,
                            T::from_f64(0.0),
                            t18,
                            t19,
                            T::from_f64(0.0),
                            t12,
                            t15,
                            T::from_f64(0.0),
                            t8,
                            t10,
                            T::from_f64(0.0),
                        ]
                    }
                }
            }
            ::pendulum_core::shapes::placed(
                &[
                    ::pendulum_core::shapes::Outline {
                        name: "crank",
                        body: "crank",
                        kind: ::pendulum_core::shapes::ShapeKind::Rod,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "rocker",
                        body: "rocker",
                        kind: ::pendulum_core::shapes::ShapeKind::Rod,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "coupler",
                        body: "coupler",
                        kind: ::pendulum_core::shapes::ShapeKind::Rod,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "coupler",
                        body: "coupler",
                        kind: ::pendulum_core::shapes::ShapeKind::Rod,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "crank",
                        body: "crank",
                        kind: ::pendulum_core::shapes::ShapeKind::Support,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "rocker",
                        body: "rocker",
                        kind: ::pendulum_core::shapes::ShapeKind::Support,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "coupler",
                        body: "coupler",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "coupler",
                        body: "coupler",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "tip",
                        body: "coupler",
                        kind: ::pendulum_core::shapes::ShapeKind::Point,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "end",
                        body: "coupler",
                        kind: ::pendulum_core::shapes::ShapeKind::Point,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "other",
                        body: "rocker",
                        kind: ::pendulum_core::shapes::ShapeKind::Point,
                        points: 1,
                        radius: false,
                    },
                ],
                &self.values(t, x),
            )
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::Parametric<2, 5> for FourBar {
        fn parameters(&self) -> [f64; 5] {
            self.params.to_array()
        }
        fn parameter_names(&self) -> [&str; 5] {
            FourBarParams::NAMES
        }
        fn check_parameters(
            &self,
            parameters: &[f64; 5],
        ) -> ::core::result::Result<(), ::pendulum_core::ParameterError> {
            Self::new(FourBarParams::from_array(*parameters)).map(|_| ())
        }
        fn with_parameters<T: ::pendulum_core::real::Real>(
            &self,
            parameters: [T; 5],
        ) -> FourBar<T> {
            FourBar {
                params: self.params,
                constants: constants(parameters),
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::CastJacobian<2> for FourBar {
        #[inline]
        fn with_jacobian<T: ::pendulum_core::real::Real>(
            model: &FourBar<T>,
        ) -> &impl ::pendulum_core::Jacobian<T, 2> {
            model
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::Cast<2> for FourBar {
        type In<T: ::pendulum_core::real::Real> = FourBar<T>;
        fn cast<T: ::pendulum_core::real::Real>(&self) -> FourBar<T> {
            FourBar::cast(self)
        }
        #[inline]
        fn gather<'m, T: ::pendulum_core::real::lanes::Lanes>(
            models: impl ::core::ops::Fn(usize) -> &'m Self,
        ) -> FourBar<T>
        where
            Self: 'm,
        {
            let scalar = <<T as ::pendulum_core::real::lanes::Lanes>::Scalar as ::pendulum_core::real::Real>::from_f64;
            FourBar {
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
pub use __FourBar::{FourBar, FourBarParams};
