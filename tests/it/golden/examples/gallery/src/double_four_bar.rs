#[allow(non_snake_case)]
mod __DoubleFourBar {
    ///Parameters of [`DoubleFourBar`].
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct DoubleFourBarParams {
        ///In kg.
        pub m: f64,
        ///In m.
        pub l: f64,
        ///In m/s^2.
        pub g: f64,
    }
    impl ::core::default::Default for DoubleFourBarParams {
        #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
        fn default() -> Self {
            Self {
                m: 1f64,
                l: 1f64,
                g: 9.81f64,
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl DoubleFourBarParams {
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
    /// Five bars of length `l` and mass `m`.
    ///
    /**# Equations of motion

```text
A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints

A[theta, theta] = 4/3*m*l^2 + m*l^2*slope_angle_beam_theta*t21
    + m*l^2*slope_angle_second_theta*slope_angle_other_theta*t23 + 1/3*m*l^2*slope_angle_beam_theta^2
    + 4/3*m*l^2*slope_angle_second_theta^2 + 1/3*m*l^2*slope_angle_other_theta^2 + 1/3*m*l^2*slope_angle_third_theta^2
b[theta] = 0.5*m*l^2*dot(theta)^2*slope_angle_beam_theta*t22 + 1.5*m*l*g*s_theta
    + 0.5*m*l^2*dot(angle_second)^2*slope_angle_other_theta*t24 + 1/3*m*l^2*slope_angle_beam_theta*drift_angle_beam
    + 0.5*m*l*g*slope_angle_beam_theta*cos(angle_beam) + 4/3*m*l^2*slope_angle_second_theta*drift_angle_second
    + 1.5*m*l*g*slope_angle_second_theta*t10 + 0.5*m*l^2*slope_angle_second_theta*drift_angle_other*t23
    + 0.5*m*l^2*drift_angle_beam*t21 + 0.5*m*l^2*drift_angle_second*slope_angle_other_theta*t23
    + 1/3*m*l^2*slope_angle_other_theta*drift_angle_other + 0.5*m*l*g*slope_angle_other_theta*cos(angle_other)
    + 1/3*m*l^2*slope_angle_third_theta*drift_angle_third + 0.5*m*l*g*slope_angle_third_theta*sin(angle_third)
    - 0.5*m*l^2*dot(angle_beam)^2*t22 - 0.5*m*l^2*slope_angle_second_theta*dot(angle_other)^2*t24

where
s_theta = sin(theta)
t0 = l - l*s_theta
t1 = 2*l^2 - 2*l^2*s_theta
t2 = sqrt(l^2/t1 - 0.25)
t3 = 0.5*t0 + l*cos(theta)*t2
t4 = 0.5*l*cos(theta) - t0*t2
angle_beam = atan2(t4/l, t3/l)
t5 = t0*t2 - 0.5*l*cos(theta)
t7 = l*cos(theta) + t5
angle_second = atan2((t3 - t0)/l, t7/l)
t6 = t0 - t3
slope_angle_beam_theta = -(l*cos(theta)*t6 + l*s_theta*t7)/(t1*t2)
dot(angle_beam) = dot(theta)*slope_angle_beam_theta
slope_angle_second_theta = (l*cos(theta)*t3 - l*s_theta*t5)/(t1*t2)
dot(angle_second) = dot(theta)*slope_angle_second_theta
t8 = l*dot(theta)^2*s_theta + t3*dot(angle_beam)^2 + t6*dot(angle_second)^2
t9 = l*dot(theta)^2*cos(theta) - t4*dot(angle_beam)^2 - t7*dot(angle_second)^2
drift_angle_beam = -(t7*t9 - t6*t8)/(t1*t2)
drift_angle_second = -(t3*t8 + t5*t9)/(t1*t2)
t10 = sin(angle_second)
t11 = 2*l - l - l*t10
t12 = 2*l^2 - 2*l^2*t10
t13 = sqrt(l^2/t12 - 0.25)
t14 = 0.5*t11 + l*cos(angle_second)*t13
t15 = 0.5*l*cos(angle_second) - t11*t13
angle_other = atan2(t15/l, t14/l)
t16 = t11*t13 - 0.5*l*cos(angle_second)
t18 = l*cos(angle_second) + t16
angle_third = atan2((t14 - t11)/l, t18/l)
t17 = t11 - t14
slope_angle_other_theta = -(l*slope_angle_second_theta*cos(angle_second)*t17
    + l*slope_angle_second_theta*t10*t18)/(t12*t13)
dot(angle_other) = dot(theta)*slope_angle_other_theta
slope_angle_third_theta = (l*slope_angle_second_theta*cos(angle_second)*t14
    - l*slope_angle_second_theta*t10*t16)/(t12*t13)
dot(angle_third) = dot(theta)*slope_angle_third_theta
t19 = l*drift_angle_second*cos(angle_second) - l*dot(angle_second)^2*t10 - t14*dot(angle_other)^2
    - t17*dot(angle_third)^2
t20 = l*drift_angle_second*t10 + l*dot(angle_second)^2*cos(angle_second) - t15*dot(angle_other)^2
    - t18*dot(angle_third)^2
drift_angle_other = -(t17*t19 + t18*t20)/(t12*t13)
drift_angle_third = (t14*t19 - t16*t20)/(t12*t13)
t21 = sin(theta - angle_beam)
t22 = cos(theta - angle_beam)
t23 = sin(angle_second - angle_other)
t24 = cos(angle_second - angle_other)
```

# Constants, computed by `new`

```text
k0 = l
k1 = -l
k2 = l^2
k3 = 2*l
k4 = 2*l^2
k5 = atan2(0, l)
k6 = atan2(0, l) + 0.5*pi
k7 = 2*l - l
k8 = 1 - atan2(0, l^2 - (2*l - l)^2)/pi
k9 = (2*l - l)*(1 + atan2(0, l^2 - (2*l - l)^2)/pi - 1)
k10 = (1 + atan2(0, l^2 - (2*l - l)^2)/pi - 1)*atan2(0, 2*l - l)
k11 = m*l^2
k12 = 0.5*m*l^2
k13 = 1.5*m*l*g
k14 = 0.5*m*l*g
k15 = 2/3*m*l^2
k16 = 1/6*m*l^2
k17 = 1/l
k18 = 1*0.5*m*g
k19 = 1
k20 = 1/sqrt(l^4)
k21 = 1/sqrt(l^4)
k22 = 1*2*l
k23 = 0.5*l^2
k24 = 0.5*l^2
k25 = 1*0.5*m*l
k26 = -1
```
*/
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct DoubleFourBar<T = f64> {
        params: DoubleFourBarParams,
        constants: [T; 27],
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl DoubleFourBar {
        /// Builds the model: checks the parameters, and computes once whatever depends on them alone.
        ///
        /// # Errors
        ///
        /// The first parameter, or combination of parameters, that is not finite or that no rigid body can
        /// have.
        pub fn new(
            params: DoubleFourBarParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            #[inline]
            fn rules<T: ::pendulum_core::real::Real>(given: [T; 3]) -> [T; 1] {
                let [p_m, p_l, p_g] = given;
                [p_m]
            }
            #[inline]
            fn constants<T: ::pendulum_core::real::Real>(given: [T; 3]) -> [T; 27] {
                let [p_m, p_l, p_g] = given;
                let t0 = -p_l;
                let t1 = p_l * (T::from_f64(0.5) * p_l);
                let t2 = p_l * p_l;
                let t3 = T::from_f64(0.5) * t2;
                let t4 = T::from_f64(2.0) * p_l;
                let t5 = t4 - p_l;
                let t6 = T::from_f64(2.0) * t2;
                let t7 = T::from_f64(0.0).atan2(p_l);
                let t8 = t7 + T::from_f64(1.5707963267948966);
                let t9 = T::from_f64(1.0)
                    - T::from_f64(0.0).atan2(t2 - t5 * t5)
                        / T::from_f64(3.141592653589793);
                let t10 = T::from_f64(1.0) - t9;
                let t11 = t5 * t10;
                let t12 = t10 * T::from_f64(0.0).atan2(t5);
                let t13 = p_m * t2;
                let t14 = T::from_f64(0.6666666666666666) * t13;
                let t15 = T::from_f64(0.16666666666666666) * t13;
                let t16 = T::from_f64(0.5) * t13;
                let t17 = p_g * (p_m * p_l);
                let t18 = T::from_f64(1.5) * t17;
                let t19 = T::from_f64(0.5) * t17;
                let t20 = T::from_f64(1.0) / p_l;
                let t21 = t19 * t20;
                let t22 = t6 * t20;
                let t23 = t16 * t20;
                let t24 = p_l * t20;
                let t25 = -t24;
                let t26 = p_l * p_l * p_l * p_l;
                let t27 = T::from_f64(1.0) / t26.sqrt();
                let t28 = T::from_f64(1.0) / t26.sqrt();
                [
                    p_l,
                    t0,
                    t2,
                    t4,
                    t6,
                    t7,
                    t8,
                    t5,
                    t9,
                    t11,
                    t12,
                    t13,
                    t16,
                    t18,
                    t19,
                    t14,
                    t15,
                    t20,
                    t21,
                    t24,
                    t27,
                    t28,
                    t22,
                    t3,
                    t1,
                    t23,
                    t25,
                ]
            }
            let given = params.to_array();
            for (name, value) in DoubleFourBarParams::NAMES.into_iter().zip(given) {
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
                        "the mass of a rod of `hanging` must be positive",
                        &[],
                    ),
                );
            }
            let constants = constants(given);
            let names: [&'static str; 27] = [
                "l",
                "-l",
                "l^2",
                "2*l",
                "2*l^2",
                "atan2(0, l)",
                "atan2(0, l) + 0.5*pi",
                "2*l - l",
                "1 - atan2(0, l^2 - (2*l - l)^2)/pi",
                "(2*l - l)*(1 + atan2(0, l^2 - (2*l - l)^2)/pi - 1)",
                "(1 + atan2(0, l^2 - (2*l - l)^2)/pi - 1)*atan2(0, 2*l - l)",
                "m*l^2",
                "0.5*m*l^2",
                "1.5*m*l*g",
                "0.5*m*l*g",
                "2/3*m*l^2",
                "1/6*m*l^2",
                "1/l",
                "1*0.5*m*g",
                "1",
                "1/sqrt(l^4)",
                "1/sqrt(l^4)",
                "1*2*l",
                "0.5*l^2",
                "0.5*l^2",
                "1*0.5*m*l",
                "-1",
            ];
            for (name, value) in names.into_iter().zip(constants) {
                if !value.is_finite() {
                    let given: [_; 3] = ::core::array::from_fn(|n| (
                        DoubleFourBarParams::NAMES[n],
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
        pub fn cast<T: ::pendulum_core::real::Real>(&self) -> DoubleFourBar<T> {
            DoubleFourBar {
                params: self.params,
                constants: self.constants.map(T::from_f64),
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> DoubleFourBar<T> {
        /// The parameters that the model was built from.
        pub fn params(&self) -> &DoubleFourBarParams {
            &self.params
        }
        /// The model with other parameters, in the same number type. Its constants are computed anew.
        ///
        /// # Errors
        ///
        /// Those of `new`.
        pub fn with_params(
            &self,
            params: DoubleFourBarParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            Ok(<DoubleFourBar>::new(params)?.cast())
        }
    }
    impl DoubleFourBar {
        ///The place of `theta` in the state, where it stands in rad.
        pub const THETA: usize = 0;
        ///The place of `dot(theta)` in the state, where it stands in rad/s.
        pub const DOT_THETA: usize = 1;
        /// The number of degrees of freedom; the state has twice as many components.
        pub const DOF: usize = 1;
        /// The names of the coordinates, in the order in which they, and then their rates, stand in the state.
        pub const COORDINATES: [&'static str; 1] = ["theta"];
        /// Counted operations of each generated function, in the form that it has and in others.
        pub const COST: ::pendulum_core::Cost = ::pendulum_core::Cost::new(
            &[
                (
                    "rhs",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first, L^T D L",
                            ::pendulum_core::Operations::new(57, 114, 5, 1, 2, 72),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, L^T D L",
                                    ::pendulum_core::Operations::new(57, 114, 5, 1, 2, 72),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L",
                                    ::pendulum_core::Operations::new(57, 115, 5, 1, 2, 72),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, L^T D L",
                                    ::pendulum_core::Operations::new(90, 129, 5, 1, 2, 79),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C, L^T D L",
                                    ::pendulum_core::Operations::new(122, 153, 5, 1, 2, 79),
                                ),
                            ],
                        ),
                ),
                (
                    "loop_margins",
                    ::pendulum_core::FunctionCost::new(
                        "as declared",
                        ::pendulum_core::Operations::new(12, 36, 7, 1, 2, 54),
                    ),
                ),
                (
                    "jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first, L^T D L, derived in the graph",
                            ::pendulum_core::Operations::new(194, 332, 11, 1, 2, 96),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, L^T D L, derived in the graph",
                                    ::pendulum_core::Operations::new(194, 332, 11, 1, 2, 96),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L, derived in the graph",
                                    ::pendulum_core::Operations::new(202, 362, 11, 1, 2, 101),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, L^T D L, derived in the graph",
                                    ::pendulum_core::Operations::new(287, 396, 11, 1, 2, 108),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C, L^T D L, derived in the graph",
                                    ::pendulum_core::Operations::new(346, 448, 11, 1, 2, 100),
                                ),
                            ],
                        ),
                ),
                (
                    "kinetic",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, expanded",
                            ::pendulum_core::Operations::new(26, 54, 4, 1, 2, 61),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(26, 55, 4, 1, 2, 61),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(26, 56, 4, 1, 2, 61),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(42, 70, 4, 1, 2, 66),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C",
                                    ::pendulum_core::Operations::new(67, 86, 4, 1, 2, 66),
                                ),
                            ],
                        ),
                ),
                (
                    "potential",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(16, 18, 2, 1, 2, 54),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(16, 18, 2, 1, 2, 54),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(16, 18, 2, 1, 2, 55),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C",
                                    ::pendulum_core::Operations::new(18, 19, 2, 1, 2, 57),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(18, 19, 2, 1, 2, 57),
                                ),
                            ],
                        ),
                ),
                (
                    "parallel",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(36, 23, 2, 1, 8, 62),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(36, 23, 2, 1, 8, 62),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(36, 23, 2, 1, 8, 62),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(36, 23, 2, 1, 8, 62),
                                ),
                            ],
                        ),
                ),
                (
                    "parallel_rate",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(22, 36, 4, 1, 2, 56),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(22, 36, 4, 1, 2, 56),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(22, 36, 4, 1, 2, 56),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "as declared",
                                    ::pendulum_core::Operations::new(24, 36, 4, 1, 2, 56),
                                ),
                            ],
                        ),
                ),
                (
                    "parallel_and_jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(49, 43, 4, 1, 8, 62),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(48, 44, 4, 1, 8, 62),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(48, 44, 4, 1, 8, 62),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(48, 44, 4, 1, 8, 62),
                                ),
                            ],
                        ),
                ),
                (
                    "margins",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(7, 12, 3, 1, 2, 53),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(7, 12, 3, 1, 2, 53),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(7, 12, 3, 1, 2, 53),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(7, 12, 3, 1, 2, 53),
                                ),
                            ],
                        ),
                ),
                (
                    "margins_rate",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(12, 33, 7, 1, 2, 54),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(18, 35, 6, 1, 3, 52),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(18, 36, 6, 1, 3, 53),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(18, 37, 6, 1, 3, 53),
                                ),
                            ],
                        ),
                ),
                (
                    "margins_and_jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(12, 34, 7, 1, 2, 56),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(20, 38, 7, 1, 4, 52),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(20, 39, 7, 1, 4, 52),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(20, 40, 7, 1, 4, 53),
                                ),
                            ],
                        ),
                ),
                (
                    "outputs",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(36, 27, 2, 1, 8, 62),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(36, 27, 2, 1, 8, 62),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(36, 27, 2, 1, 8, 62),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(36, 27, 2, 1, 8, 62),
                                ),
                            ],
                        ),
                ),
                (
                    "output_rates",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(26, 55, 8, 1, 2, 56),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(32, 57, 8, 1, 4, 56),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(32, 59, 8, 1, 4, 56),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(33, 59, 8, 1, 4, 56),
                                ),
                            ],
                        ),
                ),
                (
                    "outputs_and_jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(51, 64, 8, 1, 8, 62),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(58, 65, 8, 1, 10, 62),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(58, 67, 8, 1, 10, 62),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(59, 67, 8, 1, 10, 62),
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
                            "theta",
                            ::pendulum_core::SlotKind::Angle,
                            0..1,
                            1..2,
                        )
                        .periodic(),
                ],
            )
            .autonomous();
        /// The equations of motion as text.
        pub const EQUATIONS: &'static str = "A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints\n\nA[theta, theta] = 4/3*m*l^2 + m*l^2*slope_angle_beam_theta*t21\n    + m*l^2*slope_angle_second_theta*slope_angle_other_theta*t23 + 1/3*m*l^2*slope_angle_beam_theta^2\n    + 4/3*m*l^2*slope_angle_second_theta^2 + 1/3*m*l^2*slope_angle_other_theta^2 + 1/3*m*l^2*slope_angle_third_theta^2\nb[theta] = 0.5*m*l^2*dot(theta)^2*slope_angle_beam_theta*t22 + 1.5*m*l*g*s_theta\n    + 0.5*m*l^2*dot(angle_second)^2*slope_angle_other_theta*t24 + 1/3*m*l^2*slope_angle_beam_theta*drift_angle_beam\n    + 0.5*m*l*g*slope_angle_beam_theta*cos(angle_beam) + 4/3*m*l^2*slope_angle_second_theta*drift_angle_second\n    + 1.5*m*l*g*slope_angle_second_theta*t10 + 0.5*m*l^2*slope_angle_second_theta*drift_angle_other*t23\n    + 0.5*m*l^2*drift_angle_beam*t21 + 0.5*m*l^2*drift_angle_second*slope_angle_other_theta*t23\n    + 1/3*m*l^2*slope_angle_other_theta*drift_angle_other + 0.5*m*l*g*slope_angle_other_theta*cos(angle_other)\n    + 1/3*m*l^2*slope_angle_third_theta*drift_angle_third + 0.5*m*l*g*slope_angle_third_theta*sin(angle_third)\n    - 0.5*m*l^2*dot(angle_beam)^2*t22 - 0.5*m*l^2*slope_angle_second_theta*dot(angle_other)^2*t24\n\nwhere\ns_theta = sin(theta)\nt0 = l - l*s_theta\nt1 = 2*l^2 - 2*l^2*s_theta\nt2 = sqrt(l^2/t1 - 0.25)\nt3 = 0.5*t0 + l*cos(theta)*t2\nt4 = 0.5*l*cos(theta) - t0*t2\nangle_beam = atan2(t4/l, t3/l)\nt5 = t0*t2 - 0.5*l*cos(theta)\nt7 = l*cos(theta) + t5\nangle_second = atan2((t3 - t0)/l, t7/l)\nt6 = t0 - t3\nslope_angle_beam_theta = -(l*cos(theta)*t6 + l*s_theta*t7)/(t1*t2)\ndot(angle_beam) = dot(theta)*slope_angle_beam_theta\nslope_angle_second_theta = (l*cos(theta)*t3 - l*s_theta*t5)/(t1*t2)\ndot(angle_second) = dot(theta)*slope_angle_second_theta\nt8 = l*dot(theta)^2*s_theta + t3*dot(angle_beam)^2 + t6*dot(angle_second)^2\nt9 = l*dot(theta)^2*cos(theta) - t4*dot(angle_beam)^2 - t7*dot(angle_second)^2\ndrift_angle_beam = -(t7*t9 - t6*t8)/(t1*t2)\ndrift_angle_second = -(t3*t8 + t5*t9)/(t1*t2)\nt10 = sin(angle_second)\nt11 = 2*l - l - l*t10\nt12 = 2*l^2 - 2*l^2*t10\nt13 = sqrt(l^2/t12 - 0.25)\nt14 = 0.5*t11 + l*cos(angle_second)*t13\nt15 = 0.5*l*cos(angle_second) - t11*t13\nangle_other = atan2(t15/l, t14/l)\nt16 = t11*t13 - 0.5*l*cos(angle_second)\nt18 = l*cos(angle_second) + t16\nangle_third = atan2((t14 - t11)/l, t18/l)\nt17 = t11 - t14\nslope_angle_other_theta = -(l*slope_angle_second_theta*cos(angle_second)*t17\n    + l*slope_angle_second_theta*t10*t18)/(t12*t13)\ndot(angle_other) = dot(theta)*slope_angle_other_theta\nslope_angle_third_theta = (l*slope_angle_second_theta*cos(angle_second)*t14\n    - l*slope_angle_second_theta*t10*t16)/(t12*t13)\ndot(angle_third) = dot(theta)*slope_angle_third_theta\nt19 = l*drift_angle_second*cos(angle_second) - l*dot(angle_second)^2*t10 - t14*dot(angle_other)^2\n    - t17*dot(angle_third)^2\nt20 = l*drift_angle_second*t10 + l*dot(angle_second)^2*cos(angle_second) - t15*dot(angle_other)^2\n    - t18*dot(angle_third)^2\ndrift_angle_other = -(t17*t19 + t18*t20)/(t12*t13)\ndrift_angle_third = (t14*t19 - t16*t20)/(t12*t13)\nt21 = sin(theta - angle_beam)\nt22 = cos(theta - angle_beam)\nt23 = sin(angle_second - angle_other)\nt24 = cos(angle_second - angle_other)\n";
        ///The names of the components of all outputs.
        pub const OUTPUTS: [&'static str; 6] = [
            "parallel[0]",
            "parallel[1]",
            "parallel[2]",
            "parallel[3]",
            "margins[0]",
            "margins[1]",
        ];
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::System<T, 2>
    for DoubleFourBar<T> {
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
            let k4 = self.constants[4];
            let k7 = self.constants[7];
            let k11 = self.constants[11];
            let k13 = self.constants[13];
            let k14 = self.constants[14];
            let k17 = self.constants[17];
            let t0 = qd_theta * qd_theta;
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            let t1 = k0 * sin_theta;
            let t2 = k0 - t1;
            let t3 = k0 * cos_theta;
            let t4 = k4 - k4 * sin_theta;
            let t5 = (k2 * (T::from_f64(1.0) / t4) - T::from_f64(0.25)).sqrt();
            let t6 = T::from_f64(1.0) / (t4 * t5);
            let t7 = T::from_f64(0.5) * t2 + t3 * t5;
            let t8 = t2 * t5 - T::from_f64(0.5) * t3;
            let t9 = t2 - t7;
            let t10 = k17 * t9;
            let t11 = t6 * (t3 * t7 - t1 * t8);
            let t12 = k0 * t10;
            let t13 = k7 + t12;
            let t14 = t3 + t8;
            let t15 = k17 * t14;
            let t16 = k0 * t15;
            let t17 = k4 + k4 * t10;
            let t18 = (k2 * (T::from_f64(1.0) / t17) - T::from_f64(0.25)).sqrt();
            let t19 = T::from_f64(1.0) / (t17 * t18);
            let t20 = T::from_f64(0.5) * t13 + t16 * t18;
            let t21 = t13 * t18 - T::from_f64(0.5) * t16;
            let t22 = t13 - t20;
            let t23 = t11 * t16;
            let t24 = t11 * t12;
            let t25 = t19 * (t20 * t23 + t21 * t24);
            let t26 = k17 * t7;
            let t27 = t6 * (t3 * t9 + t1 * t14);
            let t28 = k17 * t20;
            let t29 = t16 + t21;
            let t30 = t19 * (t23 * t22 - t24 * t29);
            let t31 = k13 * (sin_theta - t10 * t11)
                - k14 * (k17 * t22 * t25 + t26 * t27 + t28 * t30);
            let t32 = t27 * qd_theta;
            let t33 = t32 * t32;
            let t34 = t11 * qd_theta;
            let t35 = t34 * t34;
            let t36 = t3 * t0 + t8 * t33 - t14 * t35;
            let t37 = t1 * t0 + t7 * t33 + t9 * t35;
            let t38 = t6 * (t14 * t36 - t9 * t37);
            let t39 = t6 * (t7 * t37 + t8 * t36);
            let t40 = k17 * t8;
            let t41 = t30 * qd_theta;
            let t42 = t41 * t41;
            let t43 = t25 * qd_theta;
            let t44 = t43 * t43;
            let t45 = t16 * t35 + t12 * t39 + t21 * t42 - t29 * t44;
            let t46 = t16 * t39 + t20 * t42 + t22 * t44 - t12 * t35;
            let t47 = t19 * (t29 * t45 - t22 * t46);
            let t48 = t27 * t38 + t30 * t47 - t19 * t25 * (t20 * t46 + t21 * t45);
            let t49 = k17 * t21;
            let t50 = T::from_f64(1.3333333333333333) * t11;
            let t51 = sin_theta * t26 + cos_theta * t40;
            let t52 = t38 * t51 + (cos_theta * t26 - sin_theta * t40) * (t33 + t27 * t0);
            let t53 = t15 * t28 + t10 * t49;
            let t54 = t15 * t49 - t10 * t28;
            let t55 = t52 + t30 * (t53 * t35 - t39 * t54)
                + t11 * (t53 * t42 + t47 * t54);
            let t56 = T::from_f64(1.3333333333333333) + t11 * (t50 - t30 * t54)
                + T::from_f64(0.3333333333333333) * (t27 * t27 + t30 * t30 + t25 * t25);
            ::pendulum_core::nalgebra::SVector::from([
                qd_theta,
                (t31
                    + k11
                        * (T::from_f64(0.3333333333333333) * t48 - t39 * t50
                            - T::from_f64(0.5) * t55))
                    * (T::from_f64(-1.0) / (k11 * (t56 - t27 * t51))),
            ])
        }
        #[inline]
        fn layout(
            &self,
        ) -> ::core::option::Option<&'static ::pendulum_core::StateLayout> {
            Some(&<DoubleFourBar>::LAYOUT)
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn margins(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
            tell: &mut dyn FnMut([&'static str; 2], [T; 2]),
        ) {
            let (margins, rates) = self.loop_margins(t, x);
            tell(["beam", "second"], [margins[0], rates[0]]);
            tell(["other", "third"], [margins[1], rates[1]]);
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Jacobian<T, 2>
    for DoubleFourBar<T> {
        #[inline]
        fn jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
        ) -> ::pendulum_core::nalgebra::SMatrix<T, 2, 2> {
            self.rhs_and_jacobian(t, x).1
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
            let [q_theta, qd_theta] = x.data.0[0];
            let k0 = self.constants[0];
            let k2 = self.constants[2];
            let k4 = self.constants[4];
            let k7 = self.constants[7];
            let k11 = self.constants[11];
            let k13 = self.constants[13];
            let k14 = self.constants[14];
            let k17 = self.constants[17];
            let k24 = self.constants[24];
            let t0 = qd_theta * qd_theta;
            let t1 = T::from_f64(2.0) * qd_theta;
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            let t2 = k0 * sin_theta;
            let t3 = k0 - t2;
            let t4 = k0 * cos_theta;
            let t5 = k4 - k4 * sin_theta;
            let t6 = (k2 * (T::from_f64(1.0) / t5) - T::from_f64(0.25)).sqrt();
            let t7 = t4 * t6;
            let t8 = T::from_f64(0.5) * t3 + t7;
            let t9 = t3 - t8;
            let t10 = k17 * t9;
            let t11 = t5 * t6;
            let t12 = T::from_f64(1.0) / t11;
            let t13 = T::from_f64(0.5) * t4;
            let t14 = t3 * t6 - t13;
            let t15 = t4 * t8 - t2 * t14;
            let t16 = t12 * t15;
            let t17 = t10 * t16;
            let t18 = k0 * t10;
            let t19 = k7 + t18;
            let t20 = t4 + t14;
            let t21 = k17 * t20;
            let t22 = k0 * t21;
            let t23 = k4 + k4 * t10;
            let t24 = (k2 * (T::from_f64(1.0) / t23) - T::from_f64(0.25)).sqrt();
            let t25 = T::from_f64(0.5) * t19 + t22 * t24;
            let t26 = t19 - t25;
            let t27 = k17 * t26;
            let t28 = t23 * t24;
            let t29 = T::from_f64(1.0) / t28;
            let t30 = t16 * t22;
            let t31 = t19 * t24 - T::from_f64(0.5) * t22;
            let t32 = t16 * t18;
            let t33 = t25 * t30 + t31 * t32;
            let t34 = t29 * t33;
            let t35 = k17 * t8;
            let t36 = t4 * t9 + t2 * t20;
            let t37 = t12 * t36;
            let t38 = k17 * t25;
            let t39 = t22 + t31;
            let t40 = t30 * t26 - t32 * t39;
            let t41 = t29 * t40;
            let t42 = k13 * (sin_theta - t17)
                - k14 * (t27 * t34 + t35 * t37 + t38 * t41);
            let t43 = k0 * t17;
            let t44 = t4 * t0;
            let t45 = t37 * qd_theta;
            let t46 = t45 * t45;
            let t47 = T::from_f64(2.0) * t45;
            let t48 = t16 * qd_theta;
            let t49 = t48 * t48;
            let t50 = T::from_f64(2.0) * t48;
            let t51 = t44 + t14 * t46 - t20 * t49;
            let t52 = t2 * t0;
            let t53 = t52 + t8 * t46 + t9 * t49;
            let t54 = t20 * t51 - t9 * t53;
            let t55 = t12 * t54;
            let t56 = t8 * t53 + t14 * t51;
            let t57 = t12 * t56;
            let t58 = t41 * qd_theta;
            let t59 = t58 * t58;
            let t60 = T::from_f64(2.0) * t58;
            let t61 = t34 * qd_theta;
            let t62 = t61 * t61;
            let t63 = T::from_f64(2.0) * t61;
            let t64 = t22 * t49 + t18 * t57 + t31 * t59 - t39 * t62;
            let t65 = t22 * t57 + t25 * t59 + t26 * t62 - t18 * t49;
            let t66 = t39 * t64 - t26 * t65;
            let t67 = t29 * t66;
            let t68 = t25 * t65 + t31 * t64;
            let t69 = t29 * t68;
            let t70 = T::from_f64(1.3333333333333333) * t16;
            let t71 = T::from_f64(0.3333333333333333)
                * (t37 * t55 + t41 * t67 - t34 * t69) - t57 * t70;
            let t72 = k17 * t14;
            let t73 = sin_theta * t35 + cos_theta * t72;
            let t74 = cos_theta * t35 - sin_theta * t72;
            let t75 = t46 + t37 * t0;
            let t76 = k17 * t31;
            let t77 = t21 * t38 + t10 * t76;
            let t78 = t21 * t76 - t10 * t38;
            let t79 = t16 * t21;
            let t80 = t77 * t49 - t57 * t78;
            let t81 = t77 * t59 + t67 * t78;
            let t82 = T::from_f64(0.5) * (t55 * t73 + t74 * t75 + t41 * t80 + t16 * t81);
            let t83 = t70 - t41 * t78;
            let t84 = t37 * t37;
            let t85 = t41 * t41;
            let t86 = t34 * t34;
            let t87 = T::from_f64(1.3333333333333333) + t16 * t83
                + T::from_f64(0.3333333333333333) * (t84 + t85 + t86) - t37 * t73;
            let t88 = T::from_f64(-1.0) / (k11 * t87);
            let t89 = (t42 + k11 * (t71 - t82)) * t88;
            let t90 = k4 * cos_theta;
            let t91 = k24 * (T::from_f64(1.0) / t6) * (T::from_f64(1.0) / (t5 * t5))
                * t90;
            let t92 = (t5 * t91 - t6 * t90) * (T::from_f64(1.0) / (t11 * t11));
            let t93 = t4 * t91 - t13 - t2 * t6;
            let t94 = t3 * t91 + T::from_f64(0.5) * t2 - t7;
            let t95 = t12 * (t4 * (t93 - t14) - t2 * (t8 + t94)) - t15 * t92;
            let t96 = t94 - t2;
            let t97 = t4 + t93;
            let t98 = t36 * t92 - t12 * (t2 * (t96 - t9) + t4 * (t20 - t97));
            let t99 = k4 * t79;
            let t100 = k24 * (T::from_f64(1.0) / t24) * (T::from_f64(1.0) / (t23 * t23))
                * t99;
            let t101 = (t23 * t100 - t24 * t99) * (T::from_f64(1.0) / (t28 * t28));
            let t102 = t22 * t95 + t16 * t43;
            let t103 = k0 * t79;
            let t104 = t19 * t100 - t24 * t103 - T::from_f64(0.5) * t43;
            let t105 = t22 * t100 + t24 * t43 - T::from_f64(0.5) * t103;
            let t106 = t16 * t103 - t18 * t95;
            let t107 = t103 + t105;
            let t108 = t43 + t104;
            let t109 = t29 * (t26 * t102 + t39 * t106 - t30 * t107 - t32 * t108);
            let t110 = t29 * (t30 * t105 + t25 * t102 + t32 * t104 - t31 * t106);
            let t111 = t40 * t101 - t109;
            let t112 = t35 * t98 + t72 * t84 + t38 * t111 + t76 * t85 + k17 * t39 * t86;
            let t113 = t110 - t33 * t101;
            let t114 = k13 * (cos_theta + t16 * t79 - t10 * t95)
                + k14 * (t112 - t27 * t113);
            let t115 = qd_theta * t95 * t50;
            let t116 = t16 * t50;
            let t117 = qd_theta * t98 * t47;
            let t118 = t44 + t46 * t93 + t9 * t115 - t8 * t117 - t97 * t49;
            let t119 = t52 + t14 * t117 + t96 * t49 + t20 * t115 - t46 * t94;
            let t120 = t12 * (t53 * t93 + t8 * t118 + t51 * t94 - t14 * t119);
            let t121 = t12 * (t51 * t96 + t53 * t97 - t20 * t119 - t9 * t118);
            let t122 = t56 * t92 - t120;
            let t123 = t54 * t92 - t121;
            let t124 = t37 * t47;
            let t125 = t2 * t1 + t8 * t124 + t9 * t116;
            let t126 = t4 * t1 + t14 * t124 - t20 * t116;
            let t127 = t12 * (t8 * t125 + t14 * t126);
            let t128 = t12 * (t20 * t126 - t9 * t125);
            let t129 = t73 * t128 + t74 * (t124 + t37 * t1)
                + t41 * (t77 * t116 - t78 * t127);
            let t130 = qd_theta * t111 * t60;
            let t131 = t41 * t60;
            let t132 = t22 * t122 + t18 * t115 + t25 * t130 + t107 * t62 - t57 * t43;
            let t133 = t22 * t115 + t43 * t49 + t104 * t59 - t18 * t122 - t57 * t103;
            let t134 = qd_theta * t113 * t63;
            let t135 = t132 - t103 * t49 - t105 * t59 - t26 * t134;
            let t136 = t133 - t31 * t130 - t108 * t62 - t39 * t134;
            let t137 = t29 * (t25 * t135 - t65 * t105 - t64 * t104 - t31 * t136);
            let t138 = t29 * (t65 * t107 + t26 * t135 + t64 * t108 + t39 * t136);
            let t139 = t34 * (t68 * t101 + t137) - t69 * t113 - t55 * t98 - t37 * t123;
            let t140 = t66 * t101 - t138;
            let t141 = t34 * t63;
            let t142 = t16 + t41;
            let t143 = t78 * t142;
            let t144 = t77 * t142;
            let t145 = t41 * (t77 * t115 + t78 * t122 - t143 * t49 - t57 * t144);
            let t146 = t16 * (t78 * t140 + t77 * t130 + t143 * t59 - t67 * t144);
            let t147 = T::from_f64(1.0) + t37;
            let t148 = t74 * (t117 + t98 * t0) + t80 * t111 + t146
                + t73 * (t123 + t75 * t147);
            let t149 = t74 * t147;
            let t150 = t70 * t122
                + T::from_f64(0.3333333333333333) * (t139 - t67 * t111 - t41 * t140)
                + T::from_f64(0.5) * (t148 - t55 * t149 - t145 - t81 * t95);
            let t151 = T::from_f64(1.3333333333333333) * t95;
            let t152 = t73 * t98 + t83 * t95 + t16 * (t151 + t78 * t111 - t41 * t144);
            let t153 = t152
                + T::from_f64(0.6666666666666666) * (t34 * t113 - t37 * t98 - t41 * t111)
                - t37 * t149;
            let t154 = t22 * t127 + t25 * t131 + t26 * t141 - t18 * t116;
            let t155 = t22 * t116 + t18 * t127 + t31 * t131 - t39 * t141;
            let t156 = t29 * (t39 * t155 - t26 * t154);
            let t157 = t29 * t34 * (t25 * t154 + t31 * t155) - t37 * t128 - t41 * t156;
            let t158 = t70 * t127 + T::from_f64(0.3333333333333333) * t157
                + T::from_f64(0.5) * (t129 + t16 * (t78 * t156 + t77 * t131));
            (
                ::pendulum_core::nalgebra::SVector::from([qd_theta, t89]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [
                        T::from_f64(0.0),
                        t88 * (t114 + k11 * (t150 - t57 * t151 + t89 * t153)),
                    ],
                    [T::from_f64(1.0), -(k11 * t88 * t158)],
                ]),
            )
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
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Energy<T, 2>
    for DoubleFourBar<T> {
        #[inline]
        fn kinetic(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 2>) -> T {
            let [q_theta, qd_theta] = x.data.0[0];
            let k0 = self.constants[0];
            let k2 = self.constants[2];
            let k4 = self.constants[4];
            let k7 = self.constants[7];
            let k12 = self.constants[12];
            let k15 = self.constants[15];
            let k16 = self.constants[16];
            let k17 = self.constants[17];
            let k25 = self.constants[25];
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            let t0 = k4 - k4 * sin_theta;
            let t1 = (k2 * (T::from_f64(1.0) / t0) - T::from_f64(0.25)).sqrt();
            let t2 = T::from_f64(1.0) / (t0 * t1);
            let t3 = k0 * cos_theta;
            let t4 = k0 * sin_theta;
            let t5 = k0 - t4;
            let t6 = T::from_f64(0.5) * t5 + t3 * t1;
            let t7 = T::from_f64(0.5) * t3 - t5 * t1;
            let t8 = t5 - t6;
            let t9 = t3 - t7;
            let t10 = qd_theta * t2 * (t3 * t8 + t4 * t9);
            let t11 = t2 * (t3 * t6 + t4 * t7);
            let t12 = k15 * qd_theta
                - k12 * (k17 * (sin_theta * t6 - cos_theta * t7) * t10);
            let t13 = k17 * t8;
            let t14 = k17 * t9;
            let t15 = k0 * t13;
            let t16 = k7 + t15;
            let t17 = t15 * t11;
            let t18 = k0 * t14;
            let t19 = k4 + k4 * t13;
            let t20 = (k2 * (T::from_f64(1.0) / t19) - T::from_f64(0.25)).sqrt();
            let t21 = qd_theta * (T::from_f64(1.0) / (t19 * t20));
            let t22 = T::from_f64(0.5) * t16 + t18 * t20;
            let t23 = T::from_f64(0.5) * t18 - t16 * t20;
            let t24 = t18 * t11;
            let t25 = ((t16 - t22) * t24 - (t18 - t23) * t17) * t21;
            let t26 = (t22 * t24 - t23 * t17) * t21;
            let t27 = k16 * (t10 * t10 + t25 * t25 + t26 * t26) + qd_theta * t12;
            let t28 = qd_theta * t11;
            let t29 = t28 * (t25 * (k25 * (t13 * t22 + t14 * t23)) + k15 * t28);
            t27 + t29
        }
        #[inline]
        fn potential(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 2>) -> T {
            let [q_theta, _] = x.data.0[0];
            let k0 = self.constants[0];
            let k2 = self.constants[2];
            let k4 = self.constants[4];
            let k7 = self.constants[7];
            let k13 = self.constants[13];
            let k17 = self.constants[17];
            let k18 = self.constants[18];
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            let t0 = k0 * cos_theta;
            let t1 = k0 - k0 * sin_theta;
            let t2 = (k2 * (T::from_f64(1.0) / (k4 - k4 * sin_theta))
                - T::from_f64(0.25))
                .sqrt();
            let t3 = t1 * t2 - T::from_f64(0.5) * t0;
            let t4 = k17 * (T::from_f64(0.5) * t1 + t0 * t2 - t1);
            let t5 = k17 * (t0 + t3);
            let t6 = k0 * t5;
            let t7 = (k7 - k0 * t4)
                * (k2 * (T::from_f64(1.0) / (k4 - k4 * t4)) - T::from_f64(0.25)).sqrt();
            let t8 = T::from_f64(0.5) * t6 - t7;
            k18 * (t8 - t3 - (t6 - t8)) - k13 * (cos_theta + t5)
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> DoubleFourBar<T> {
        ///How far each closed loop is from its toggle, in the order of the declaration: 0 there, and at most 1. And the rates of that.
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        pub fn loop_margins(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 2>,
            ::pendulum_core::nalgebra::SVector<T, 2>,
        ) {
            let [q_theta, qd_theta] = x.data.0[0];
            let k0 = self.constants[0];
            let k2 = self.constants[2];
            let k4 = self.constants[4];
            let k17 = self.constants[17];
            let k20 = self.constants[20];
            let k21 = self.constants[21];
            let k22 = self.constants[22];
            let k23 = self.constants[23];
            let t0 = k4 * qd_theta;
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            let t1 = k4 - k4 * sin_theta;
            let t2 = (k2 * (T::from_f64(1.0) / t1) - T::from_f64(0.25)).sqrt();
            let t3 = t1 * t2;
            let t4 = k0 * sin_theta;
            let t5 = k0 - t4;
            let t6 = k0 * cos_theta;
            let t7 = cos_theta * t0;
            let t8 = k23 * t1 * t7 * (T::from_f64(1.0) / (t1 * t1))
                * (T::from_f64(1.0) / t2) - t2 * t7;
            let t9 = T::from_f64(0.5) * t5 + t2 * t6;
            let t10 = t2 * t5 - T::from_f64(0.5) * t6;
            let t11 = k17 * (t6 + t10) * (T::from_f64(1.0) / t3) * (t6 * t9 - t4 * t10);
            let t12 = k4 - k22 * (t9 - t5);
            let t13 = t11 * t0;
            let t14 = (k2 * (T::from_f64(1.0) / t12) - T::from_f64(0.25)).sqrt();
            let t15 = k23 * t12 * t13 * (T::from_f64(1.0) / (t12 * t12))
                * (T::from_f64(1.0) / t14) - t14 * t13;
            (
                ::pendulum_core::nalgebra::SVector::from([k21 * t3, k21 * t12 * t14]),
                ::pendulum_core::nalgebra::SVector::from([k20 * t8, k20 * t15]),
            )
        }
        ///Output `parallel`.
        #[inline]
        pub fn parallel(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 4> {
            let [q_theta, _] = x.data.0[0];
            let k0 = self.constants[0];
            let k2 = self.constants[2];
            let k4 = self.constants[4];
            let k5 = self.constants[5];
            let k6 = self.constants[6];
            let k7 = self.constants[7];
            let k8 = self.constants[8];
            let k9 = self.constants[9];
            let k10 = self.constants[10];
            let k17 = self.constants[17];
            let k19 = self.constants[19];
            let t0 = k6 + q_theta;
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            let t1 = (k2 * (T::from_f64(1.0) / (k4 - k4 * sin_theta))
                - T::from_f64(0.25))
                .sqrt();
            let t2 = k0 * cos_theta;
            let t3 = k0 * sin_theta;
            let t4 = k0 - t3;
            let t5 = (-(t2 * (t3 + t4))).atan2(t2 * t2 - t3 * t4) + t0;
            let t6 = k6 - (t5 + t1.atan2(T::from_f64(0.5)));
            let t7 = k17 * (T::from_f64(0.5) * t4 + t1 * t2 - t4);
            let t8 = k19 * (t2 + t1 * t4 - T::from_f64(0.5) * t2);
            let t9 = (k2 * (T::from_f64(1.0) / (k4 - k4 * t7)) - T::from_f64(0.25))
                .sqrt();
            let t10 = k0 * t7;
            let t11 = k9 - k8 * t10;
            let t12 = k7 - t10;
            let t13 = k8 * t8;
            let t14 = k10 + k8 * (k6 - t6)
                + (t8 * t11 - t13 * t12).atan2(t11 * t12 + t8 * t13);
            ::pendulum_core::nalgebra::SVector::from([
                q_theta + (-t1).atan2(T::from_f64(0.5)) + t5 - q_theta - k5,
                q_theta + t6,
                (-t9).atan2(T::from_f64(0.5)) + t14 + t6 - t6 - k5,
                t0 - t14 - t9.atan2(T::from_f64(0.5)),
            ])
        }
        ///The rate of `parallel` along the motion.
        #[inline]
        pub fn parallel_rate(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 4> {
            let [q_theta, qd_theta] = x.data.0[0];
            let k0 = self.constants[0];
            let k2 = self.constants[2];
            let k4 = self.constants[4];
            let k7 = self.constants[7];
            let k17 = self.constants[17];
            let k19 = self.constants[19];
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            let t0 = k4 - k4 * sin_theta;
            let t1 = (k2 * (T::from_f64(1.0) / t0) - T::from_f64(0.25)).sqrt();
            let t2 = T::from_f64(1.0) / (t0 * t1);
            let t3 = k0 * cos_theta;
            let t4 = k0 * sin_theta;
            let t5 = k0 - t4;
            let t6 = T::from_f64(0.5) * t5 + t1 * t3;
            let t7 = t1 * t5 - T::from_f64(0.5) * t3;
            let t8 = t2 * (t3 * t6 - t4 * t7);
            let t9 = t5 - t6;
            let t10 = t3 + t7;
            let t11 = k17 * t9;
            let t12 = k19 * t10;
            let t13 = k0 * t11;
            let t14 = k4 + k4 * t11;
            let t15 = k7 + t13;
            let t16 = t8 * t13;
            let t17 = t8 * t12;
            let t18 = (k2 * (T::from_f64(1.0) / t14) - T::from_f64(0.25)).sqrt();
            let t19 = qd_theta * (T::from_f64(1.0) / (t14 * t18));
            let t20 = T::from_f64(0.5) * t15 + t18 * t12;
            let t21 = t18 * t15 - T::from_f64(0.5) * t12;
            ::pendulum_core::nalgebra::SVector::from([
                -(qd_theta * t2 * (t3 * t9 + t4 * t10)),
                qd_theta - qd_theta * t8,
                -(((t15 - t20) * t17 - (t12 + t21) * t16) * t19),
                qd_theta - (t20 * t17 + t21 * t16) * t19,
            ])
        }
        ///The value of `parallel`, and its derivatives by the state: a row for each component, column by column for a matrix.
        #[inline]
        pub fn parallel_and_jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 4>,
            ::pendulum_core::nalgebra::SMatrix<T, 4, 2>,
        ) {
            let [q_theta, _] = x.data.0[0];
            let k0 = self.constants[0];
            let k2 = self.constants[2];
            let k4 = self.constants[4];
            let k5 = self.constants[5];
            let k6 = self.constants[6];
            let k7 = self.constants[7];
            let k8 = self.constants[8];
            let k9 = self.constants[9];
            let k10 = self.constants[10];
            let k17 = self.constants[17];
            let k19 = self.constants[19];
            let t0 = k6 + q_theta;
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            let t1 = k4 - k4 * sin_theta;
            let t2 = (k2 * (T::from_f64(1.0) / t1) - T::from_f64(0.25)).sqrt();
            let t3 = T::from_f64(1.0) / (t1 * t2);
            let t4 = k0 * cos_theta;
            let t5 = k0 * sin_theta;
            let t6 = k0 - t5;
            let t7 = (-(t4 * (t5 + t6))).atan2(t4 * t4 - t5 * t6) + t0;
            let t8 = q_theta + (-t2).atan2(T::from_f64(0.5)) + t7 - q_theta - k5;
            let t9 = k6 - (t7 + t2.atan2(T::from_f64(0.5)));
            let t10 = q_theta + t9;
            let t11 = T::from_f64(0.5) * t6 + t2 * t4;
            let t12 = t2 * t6 - T::from_f64(0.5) * t4;
            let t13 = t6 - t11;
            let t14 = t3 * (t4 * t11 - t5 * t12);
            let t15 = t4 + t12;
            let t16 = -(t3 * (t4 * t13 + t5 * t15));
            let t17 = k17 * t13;
            let t18 = k19 * t15;
            let t19 = T::from_f64(1.0) - t14;
            let t20 = k4 + k4 * t17;
            let t21 = k0 * t17;
            let t22 = (k2 * (T::from_f64(1.0) / t20) - T::from_f64(0.25)).sqrt();
            let t23 = T::from_f64(1.0) / (t20 * t22);
            let t24 = k9 + k8 * t21;
            let t25 = k8 * t18;
            let t26 = k7 + t21;
            let t27 = k10 + k8 * (k6 - t9)
                + (t18 * t24 - t25 * t26).atan2(t24 * t26 + t18 * t25);
            let t28 = (-t22).atan2(T::from_f64(0.5)) + t27 + t9 - t9 - k5;
            let t29 = t0 - t27 - t22.atan2(T::from_f64(0.5));
            let t30 = t21 * t14;
            let t31 = T::from_f64(0.5) * t26 + t22 * t18;
            let t32 = t22 * t26 - T::from_f64(0.5) * t18;
            let t33 = t18 * t14;
            let t34 = t14 - t14 - t23 * ((t26 - t31) * t33 - (t18 + t32) * t30);
            let t35 = T::from_f64(1.0) - t23 * (t31 * t33 + t32 * t30);
            (
                ::pendulum_core::nalgebra::SVector::from([t8, t10, t28, t29]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [t16, t19, t34, t35],
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                    ],
                ]),
            )
        }
        ///Output `margins`.
        #[inline]
        pub fn margins(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 2> {
            let [q_theta, _] = x.data.0[0];
            let k0 = self.constants[0];
            let k2 = self.constants[2];
            let k4 = self.constants[4];
            let k21 = self.constants[21];
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            let t0 = k4 - k4 * sin_theta;
            let t1 = (k2 * (T::from_f64(1.0) / t0) - T::from_f64(0.25)).sqrt();
            let t2 = k0 - k0 * sin_theta;
            let t3 = k4 - k4 * ((T::from_f64(0.5) * t2 + k0 * t1 * cos_theta - t2) / k0);
            ::pendulum_core::nalgebra::SVector::from([
                k21 * t0 * t1,
                k21 * t3 * (k2 * (T::from_f64(1.0) / t3) - T::from_f64(0.25)).sqrt(),
            ])
        }
        ///The rate of `margins` along the motion.
        #[inline]
        pub fn margins_rate(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 2> {
            let [q_theta, qd_theta] = x.data.0[0];
            let k0 = self.constants[0];
            let k2 = self.constants[2];
            let k4 = self.constants[4];
            let k17 = self.constants[17];
            let k20 = self.constants[20];
            let k22 = self.constants[22];
            let k23 = self.constants[23];
            let t0 = k4 * qd_theta;
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            let t1 = k4 - k4 * sin_theta;
            let t2 = cos_theta * t0;
            let t3 = (k2 * (T::from_f64(1.0) / t1) - T::from_f64(0.25)).sqrt();
            let t4 = k23 * t1 * t2 * (T::from_f64(1.0) / (t1 * t1))
                * (T::from_f64(1.0) / t3) - t2 * t3;
            let t5 = k0 * sin_theta;
            let t6 = k0 * cos_theta;
            let t7 = k0 - t5;
            let t8 = T::from_f64(0.5) * t7 + t3 * t6;
            let t9 = k4 - k22 * (t8 - t7);
            let t10 = t3 * t7 - T::from_f64(0.5) * t6;
            let t11 = k17 * (t6 + t10) * (T::from_f64(1.0) / (t1 * t3))
                * (t6 * t8 - t5 * t10);
            let t12 = t11 * t0;
            let t13 = (k2 * (T::from_f64(1.0) / t9) - T::from_f64(0.25)).sqrt();
            let t14 = k23 * t9 * t12 * (T::from_f64(1.0) / (t9 * t9))
                * (T::from_f64(1.0) / t13) - t12 * t13;
            ::pendulum_core::nalgebra::SVector::from([k20 * t4, k20 * t14])
        }
        ///The value of `margins`, and its derivatives by the state: a row for each component, column by column for a matrix.
        #[inline]
        pub fn margins_and_jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 2>,
            ::pendulum_core::nalgebra::SMatrix<T, 2, 2>,
        ) {
            let [q_theta, _] = x.data.0[0];
            let k0 = self.constants[0];
            let k2 = self.constants[2];
            let k4 = self.constants[4];
            let k20 = self.constants[20];
            let k21 = self.constants[21];
            let k22 = self.constants[22];
            let k23 = self.constants[23];
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            let t0 = k4 - k4 * sin_theta;
            let t1 = (k2 * (T::from_f64(1.0) / t0) - T::from_f64(0.25)).sqrt();
            let t2 = t0 * t1;
            let t3 = k0 * sin_theta;
            let t4 = k0 - t3;
            let t5 = k0 * cos_theta;
            let t6 = k4 * cos_theta;
            let t7 = k23 * t0 * (T::from_f64(1.0) / t1) * (T::from_f64(1.0) / (t0 * t0))
                * t6 - t1 * t6;
            let t8 = T::from_f64(0.5) * t4 + t1 * t5;
            let t9 = t1 * t4 - T::from_f64(0.5) * t5;
            let t10 = k22 * (t5 + t9) * (T::from_f64(1.0) / t2) * (t5 * t8 - t3 * t9);
            let t11 = k4 - k22 * (t8 - t4);
            let t12 = (k2 * (T::from_f64(1.0) / t11) - T::from_f64(0.25)).sqrt();
            let t13 = k23 * t11 * (T::from_f64(1.0) / t12)
                * (T::from_f64(1.0) / (t11 * t11)) * t10 - t12 * t10;
            (
                ::pendulum_core::nalgebra::SVector::from([k21 * t2, k21 * t11 * t12]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [k20 * t7, k20 * t13],
                    [T::from_f64(0.0), T::from_f64(0.0)],
                ]),
            )
        }
        ///All outputs, in the order of `OUTPUTS`.
        #[inline]
        pub fn outputs(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 6> {
            let [q_theta, _] = x.data.0[0];
            let k0 = self.constants[0];
            let k2 = self.constants[2];
            let k4 = self.constants[4];
            let k5 = self.constants[5];
            let k6 = self.constants[6];
            let k7 = self.constants[7];
            let k8 = self.constants[8];
            let k9 = self.constants[9];
            let k10 = self.constants[10];
            let k17 = self.constants[17];
            let k19 = self.constants[19];
            let k21 = self.constants[21];
            let t0 = k6 + q_theta;
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            let t1 = k4 - k4 * sin_theta;
            let t2 = (k2 * (T::from_f64(1.0) / t1) - T::from_f64(0.25)).sqrt();
            let t3 = k0 * cos_theta;
            let t4 = k0 * sin_theta;
            let t5 = k0 - t4;
            let t6 = (-(t3 * (t4 + t5))).atan2(t3 * t3 - t4 * t5) + t0;
            let t7 = k6 - (t6 + t2.atan2(T::from_f64(0.5)));
            let t8 = k17 * (T::from_f64(0.5) * t5 + t2 * t3 - t5);
            let t9 = k19 * (t3 + t2 * t5 - T::from_f64(0.5) * t3);
            let t10 = k4 - k4 * t8;
            let t11 = (k2 * (T::from_f64(1.0) / t10) - T::from_f64(0.25)).sqrt();
            let t12 = k0 * t8;
            let t13 = k9 - k8 * t12;
            let t14 = k7 - t12;
            let t15 = k8 * t9;
            let t16 = k10 + k8 * (k6 - t7)
                + (t9 * t13 - t15 * t14).atan2(t13 * t14 + t9 * t15);
            ::pendulum_core::nalgebra::SVector::from([
                q_theta + (-t2).atan2(T::from_f64(0.5)) + t6 - q_theta - k5,
                q_theta + t7,
                (-t11).atan2(T::from_f64(0.5)) + t16 + t7 - t7 - k5,
                t0 - t16 - t11.atan2(T::from_f64(0.5)),
                k21 * t1 * t2,
                k21 * t10 * t11,
            ])
        }
        ///The rate of all outputs along the motion.
        #[inline]
        pub fn output_rates(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 6> {
            let [q_theta, qd_theta] = x.data.0[0];
            let k0 = self.constants[0];
            let k2 = self.constants[2];
            let k4 = self.constants[4];
            let k7 = self.constants[7];
            let k17 = self.constants[17];
            let k20 = self.constants[20];
            let k23 = self.constants[23];
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            let t0 = k4 - k4 * sin_theta;
            let t1 = (k2 * (T::from_f64(1.0) / t0) - T::from_f64(0.25)).sqrt();
            let t2 = T::from_f64(1.0) / (t0 * t1);
            let t3 = k0 * cos_theta;
            let t4 = k0 * sin_theta;
            let t5 = k4 * qd_theta * cos_theta;
            let t6 = k23 * t0 * t5 * (T::from_f64(1.0) / (t0 * t0))
                * (T::from_f64(1.0) / t1) - t1 * t5;
            let t7 = k0 - t4;
            let t8 = T::from_f64(0.5) * t7 + t1 * t3;
            let t9 = t1 * t7 - T::from_f64(0.5) * t3;
            let t10 = t2 * (t3 * t8 - t4 * t9);
            let t11 = t7 - t8;
            let t12 = t3 + t9;
            let t13 = k17 * t11;
            let t14 = k17 * t12;
            let t15 = qd_theta * t10;
            let t16 = k4 * t15 * t14;
            let t17 = k0 * t14;
            let t18 = k0 * t13;
            let t19 = k4 + k4 * t13;
            let t20 = k7 + t18;
            let t21 = t10 * t18;
            let t22 = t10 * t17;
            let t23 = (k2 * (T::from_f64(1.0) / t19) - T::from_f64(0.25)).sqrt();
            let t24 = k23 * t19 * t16 * (T::from_f64(1.0) / (t19 * t19))
                * (T::from_f64(1.0) / t23) - t23 * t16;
            let t25 = qd_theta * (T::from_f64(1.0) / (t19 * t23));
            let t26 = T::from_f64(0.5) * t20 + t23 * t17;
            let t27 = t23 * t20 - T::from_f64(0.5) * t17;
            ::pendulum_core::nalgebra::SVector::from([
                qd_theta - qd_theta - qd_theta * t2 * (t3 * t11 + t4 * t12),
                qd_theta - t15,
                t15 - t15 - ((t20 - t26) * t22 - (t17 + t27) * t21) * t25,
                qd_theta - (t26 * t22 + t27 * t21) * t25,
                k20 * t6,
                k20 * t24,
            ])
        }
        ///The value of all outputs, and its derivatives by the state: a row for each component, column by column for a matrix.
        #[inline]
        pub fn outputs_and_jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 6>,
            ::pendulum_core::nalgebra::SMatrix<T, 6, 2>,
        ) {
            let [q_theta, _] = x.data.0[0];
            let k0 = self.constants[0];
            let k2 = self.constants[2];
            let k4 = self.constants[4];
            let k5 = self.constants[5];
            let k6 = self.constants[6];
            let k7 = self.constants[7];
            let k8 = self.constants[8];
            let k9 = self.constants[9];
            let k10 = self.constants[10];
            let k17 = self.constants[17];
            let k20 = self.constants[20];
            let k21 = self.constants[21];
            let k23 = self.constants[23];
            let t0 = k6 + q_theta;
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            let t1 = k4 - k4 * sin_theta;
            let t2 = (k2 * (T::from_f64(1.0) / t1) - T::from_f64(0.25)).sqrt();
            let t3 = k0 * sin_theta;
            let t4 = k0 * cos_theta;
            let t5 = k4 * cos_theta;
            let t6 = k23 * t1 * (T::from_f64(1.0) / t2) * (T::from_f64(1.0) / (t1 * t1))
                * t5 - t2 * t5;
            let t7 = k20 * t6;
            let t8 = t1 * t2;
            let t9 = k21 * t8;
            let t10 = T::from_f64(1.0) / t8;
            let t11 = k0 - t3;
            let t12 = (-(t3 * t4 + t4 * t11)).atan2(t4 * t4 - t3 * t11);
            let t13 = t12 + t0;
            let t14 = q_theta + (-t2).atan2(T::from_f64(0.5)) + t13 - q_theta - k5;
            let t15 = k6 - (t13 + t2.atan2(T::from_f64(0.5)));
            let t16 = q_theta + t15;
            let t17 = T::from_f64(0.5) * t11 + t2 * t4;
            let t18 = t2 * t11 - T::from_f64(0.5) * t4;
            let t19 = t11 - t17;
            let t20 = t10 * (t4 * t17 - t3 * t18);
            let t21 = t4 + t18;
            let t22 = -(t10 * (t4 * t19 + t3 * t21));
            let t23 = k17 * t19;
            let t24 = k17 * t21;
            let t25 = T::from_f64(1.0) - t20;
            let t26 = k4 + k4 * t23;
            let t27 = k0 * t23;
            let t28 = (k2 * (T::from_f64(1.0) / t26) - T::from_f64(0.25)).sqrt();
            let t29 = k0 * t24;
            let t30 = k4 * t24 * t20;
            let t31 = k23 * t26 * (T::from_f64(1.0) / t28)
                * (T::from_f64(1.0) / (t26 * t26)) * t30 - t28 * t30;
            let t32 = k20 * t31;
            let t33 = t26 * t28;
            let t34 = k21 * t33;
            let t35 = T::from_f64(1.0) / t33;
            let t36 = k9 + k8 * t27;
            let t37 = k8 * t29;
            let t38 = k7 + t27;
            let t39 = k10 + k8 * (k6 - t15)
                + (t29 * t36 - t37 * t38).atan2(t36 * t38 + t29 * t37);
            let t40 = (-t28).atan2(T::from_f64(0.5)) + t39 + t15 - t15 - k5;
            let t41 = t0 - t39 - t28.atan2(T::from_f64(0.5));
            let t42 = t27 * t20;
            let t43 = T::from_f64(0.5) * t38 + t28 * t29;
            let t44 = t28 * t38 - T::from_f64(0.5) * t29;
            let t45 = t29 * t20;
            let t46 = t20 - t20 - t35 * ((t38 - t43) * t45 - (t29 + t44) * t42);
            let t47 = T::from_f64(1.0) - t35 * (t43 * t45 + t44 * t42);
            (
                ::pendulum_core::nalgebra::SVector::from([t14, t16, t40, t41, t9, t34]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [t22, t25, t46, t47, t7, t32],
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                    ],
                ]),
            )
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::shapes::Shapes<2> for DoubleFourBar {
        fn shapes(
            &self,
            t: f64,
            x: &::pendulum_core::nalgebra::SVector<f64, 2>,
        ) -> ::pendulum_core::shapes::Vec<::pendulum_core::shapes::Shape> {
            use ::pendulum_core::real::Real as _;
            type T = f64;
            ::pendulum_core::shapes::placed(
                &[
                    ::pendulum_core::shapes::Outline {
                        name: "first",
                        kind: ::pendulum_core::shapes::ShapeKind::Rod,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "second",
                        kind: ::pendulum_core::shapes::ShapeKind::Rod,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "third",
                        kind: ::pendulum_core::shapes::ShapeKind::Rod,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "beam",
                        kind: ::pendulum_core::shapes::ShapeKind::Rod,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "other",
                        kind: ::pendulum_core::shapes::ShapeKind::Rod,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "first",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "second",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "third",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "beam",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "other",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "beam",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "other",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                ],
                &{
                    let [q_theta, _] = x.data.0[0];
                    let k0 = self.constants[0];
                    let k1 = self.constants[1];
                    let k2 = self.constants[2];
                    let k3 = self.constants[3];
                    let k4 = self.constants[4];
                    let k17 = self.constants[17];
                    let k19 = self.constants[19];
                    let k26 = self.constants[26];
                    let (sin_theta, cos_theta) = q_theta.sin_cos();
                    let t0 = k0 * sin_theta;
                    let t1 = k1 * cos_theta;
                    let t2 = k0 - t0;
                    let t3 = k0 * cos_theta;
                    let t4 = (k2 * (T::from_f64(1.0) / (k4 - k4 * sin_theta))
                        - T::from_f64(0.25))
                        .sqrt();
                    let t5 = T::from_f64(0.5) * t2 + t3 * t4;
                    let t6 = t2 * t4 - T::from_f64(0.5) * t3;
                    let t7 = k17 * (t5 - t2);
                    let t8 = t0 + k19 * t5;
                    let t9 = k0 + k0 * t7;
                    let t10 = (k2 * (T::from_f64(1.0) / (k4 - k4 * t7))
                        - T::from_f64(0.25))
                        .sqrt();
                    let t11 = t3 + t6;
                    let t12 = -(t3 + k19 * t6);
                    let t13 = k26 * t11;
                    let t14 = k19 * t11;
                    let t15 = k3 - t9;
                    let t16 = T::from_f64(0.5) * t15 + t14 * t10;
                    let t17 = k3 + k19 * (t16 - t15);
                    let t18 = t15 * t10 - T::from_f64(0.5) * t14;
                    let t19 = t9 + k19 * t16;
                    let t20 = k26 * (t14 + t18);
                    let t21 = -(t14 + k19 * t18);
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t0,
                        t1,
                        T::from_f64(0.0),
                        k0,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t9,
                        t13,
                        T::from_f64(0.0),
                        k3,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t17,
                        t20,
                        T::from_f64(0.0),
                        t0,
                        t1,
                        T::from_f64(0.0),
                        t8,
                        t12,
                        T::from_f64(0.0),
                        t9,
                        t13,
                        T::from_f64(0.0),
                        t19,
                        t21,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        k0,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        k3,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t0,
                        t1,
                        T::from_f64(0.0),
                        t9,
                        t13,
                        T::from_f64(0.0),
                        t8,
                        t12,
                        T::from_f64(0.0),
                        t19,
                        t21,
                        T::from_f64(0.0),
                    ]
                },
            )
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::CastJacobian<2> for DoubleFourBar {
        #[inline]
        fn with_jacobian<T: ::pendulum_core::real::Real>(
            model: &DoubleFourBar<T>,
        ) -> &impl ::pendulum_core::Jacobian<T, 2> {
            model
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::Cast<2> for DoubleFourBar {
        type In<T: ::pendulum_core::real::Real> = DoubleFourBar<T>;
        fn cast<T: ::pendulum_core::real::Real>(&self) -> DoubleFourBar<T> {
            DoubleFourBar::cast(self)
        }
        #[inline]
        fn gather<'m, T: ::pendulum_core::real::lanes::Lanes>(
            models: impl ::core::ops::Fn(usize) -> &'m Self,
        ) -> DoubleFourBar<T>
        where
            Self: 'm,
        {
            let scalar = <<T as ::pendulum_core::real::lanes::Lanes>::Scalar as ::pendulum_core::real::Real>::from_f64;
            DoubleFourBar {
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
pub use __DoubleFourBar::{DoubleFourBar, DoubleFourBarParams};
