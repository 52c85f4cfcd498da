#[allow(non_snake_case)]
mod __Ur5 {
    ///Parameters of [`Ur5`].
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Ur5Params {}
    impl ::core::default::Default for Ur5Params {
        #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
        fn default() -> Self {
            Self {}
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl Ur5Params {
        /// Names of the parameters, in the order of their declaration.
        pub const NAMES: [&'static str; 0] = [];
        /// Returns the values of the parameters, in the order of [`NAMES`](Self::NAMES).
        pub const fn to_array(self) -> [f64; 0] {
            []
        }
        /// Builds parameters from their values, in the order of [`NAMES`](Self::NAMES).
        pub const fn from_array(values: [f64; 0]) -> Self {
            let [] = values;
            Self {}
        }
    }
    /// Universal Robots UR5: six revolute joints.
    ///
    /**# Equations of motion

```text
A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints

A[q1, q1] = 0.4395951218175 + 0.10510116377025*c234^2 + 1.75501953841*c2^2 + 0.59155695167475*c23^2
    + c234*(c234*(0.10971 + 0.016685526855*c6^2 + c5^2*t8) - 0.03337105371*c5*s6*c6*s234) + 0.85*t9
    - 0.0139521246075*c23*s234 - c5^2*t8
A[q1, q2] = A[q1, q3] + 0.408499208875*s2
A[q1, q3] = A[q1, q4] + 0.07714261911625*s23
A[q1, q4] = 0.00194120382525*c234 - 0.016685526855*s5*s6*c6*c234 - s5*c5*s234*t8
A[q1, q5] = 0.016685526855*c5*s6*c6*s234 - c234*A[q5, q5]
A[q1, q6] = -0.017136473145*s5*s234
A[q2, q2] = A[q3, q3] + 1.77012693841 + 0.85*t9 + 0.85*t10
A[q2, q3] = A[q3, q3] + 0.425*t9 + 0.425*t10
A[q2, q4] = A[q3, q4] + 0.007558512375*s2*c234 - 0.007558512375*c2*s234
A[q2, q5] = 0.016685526855*s5*s6*c6
A[q2, q6] = 0.017136473145*c5
A[q3, q3] = A[q4, q4] + 0.59565195167475 + 0.0139521246075*s23*c234 - 0.0139521246075*c23*s234
A[q3, q4] = A[q4, q4] + 0.00697606230375*s23*c234 - 0.00697606230375*c23*s234
A[q3, q5] = A[q2, q5]
A[q3, q6] = A[q2, q6]
A[q4, q4] = 0.25785083622975 + c5^2*t8 - 0.016685526855*c6^2
A[q4, q5] = A[q2, q5]
A[q4, q6] = A[q2, q6]
A[q5, q5] = 0.236556473145 + 0.016685526855*c6^2
A[q6, q6] = 0.017136473145
b[q1] = 0.602212521625*c2*t0 + 0.02581996229125*t6 + 0.051322656825*c23*w23^2 + 0.017784735*s234*(t7 + 0.39225*s23*t2)
    + s234*(c5*t20 + s5*t21) - 3.51003907682*dot(q1)*dot(q2)*s2*c2 - 0.19371331275*dot(q2)^2*c2
    - 0.602212521625*dot(q1)^2*c2 - 1.598759275*c23*t7 - 0.59155695167475*s23*c23*t2 - 0.00028722347025*s234*t11
    - 0.10510116377025*c234*s234*t4 - 0.001653980355*s234*w234^2 - c234*b[q5] - 0.00697606230375*c23*c234*t4
    - 0.425*c2*(1.598759275*s23*t2 + 0.017784735*c234*t4)
b[q2] = b[q3] + 1.75501953841*dot(q1)^2*s2*c2 - 43.486969725*c2
    - 0.425*c2*(1.598759275*s23*w23^2 + 0.017784735*c234*w234^2) - 0.425*s2*(0.017784735*s234*t11 - 1.598759275*t6)
b[q3] = b[q4] + 0.59155695167475*dot(q1)^2*s23*c23 + 0.679472691875*c2*s23*t0 + 0.051322656825*c23*(t1 - dot(q1)*w23)
    - 1.598759275*c23*t22 - 0.00697606230375*c23*c234*w234^2 - 0.00697606230375*s23*s234*t11
b[q4] = 0.10510116377025*dot(q1)^2*c234*s234 + 0.017784735*c234*(0.425*c2*t0 + 0.39225*t6) + s5*t20
    + 0.017784735*s234*(t22 + 0.39225*s23*w23^2) - 0.001653980355*s234*(t3 - dot(q1)*w234) - c5*t21
b[q5] = 0.236331*s234*t3 + c6*t17 + s6*t19 - 0.016911*t12*t13
b[q6] = -(0.017136473145*dot(q5)*t13 + 0.016685526855*t14*t18 + 0.017136473145*s5*c234*t3)

where
s2 = sin(q2)
c2 = cos(q2)
s5 = sin(q5)
c5 = cos(q5)
s6 = sin(q6)
c6 = cos(q6)
s23 = sin(q2 + q3)
c23 = cos(q2 + q3)
c234 = cos(q2 + q3 + q4)
s234 = sin(q2 + q3 + q4)
w23 = dot(q2) + dot(q3)
w234 = w23 + dot(q4)
t0 = dot(q1)^2 + dot(q2)^2
t1 = dot(q1)*dot(q2) + dot(q1)*dot(q3)
t2 = t1 + dot(q1)*w23
t3 = t1 + dot(q1)*dot(q4)
t4 = t3 + dot(q1)*w234
t5 = dot(q5) - dot(q1)*c234
t6 = c23*(dot(q1)^2 + w23^2)
t7 = 0.01615*dot(q1)^2 + 0.85*dot(q1)*dot(q2)*s2
t8 = 0.016685526855*c6^2 - 0.016685526855
t9 = c2*(1.598759275*c23 - 0.017784735*s234)
t10 = s2*(1.598759275*s23 + 0.017784735*c234)
t11 = dot(q1)^2 + w234^2
t12 = c5*w234 - dot(q1)*s5*s234
t13 = dot(q1)*c5*s234 + s5*w234
t14 = c6*t13 - s6*t5
t15 = dot(q5)*t12 + c5*c234*t3
t16 = t12 + dot(q6)
t17 = 0.016911*dot(q6)*t14 + 0.016911*c6*s234*t3 + 0.016911*s6*t15 + 0.016911*t14*t16
t18 = c6*t5 + s6*t13
t19 = 0.000225473145*dot(q6)*t18 + 0.000225473145*s6*s234*t3 + 0.000225473145*t16*t18 - 0.000225473145*c6*t15
t20 = 0.126621*dot(q5)*t12 + 0.126621*t5*t12 + 0.126621*c5*c234*t3 + s6*t17 - c6*t19
t21 = 0.126846473145*dot(q5)*t13 + 0.10971*t5*t13 + 0.016685526855*t14*t18 + 0.126846473145*s5*c234*t3
t22 = 9.81 + 0.425*dot(q2)^2*s2
```
*/
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Ur5<T = f64> {
        params: Ur5Params,
        constants: [T; 0],
    }
    /// Constants of the model, from its parameters.
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    #[inline]
    fn constants<T: ::pendulum_core::real::Real>(given: [T; 0]) -> [T; 0] {
        let [] = given;
        []
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl Ur5 {
        /// Builds the model: checks the parameters, and computes all constants that depend on them alone.
        ///
        /// # Errors
        ///
        /// Returns the first parameter, or combination of parameters, that is not finite or is impossible for a
        /// rigid body.
        pub fn new(
            params: Ur5Params,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            #[inline]
            fn rules<T: ::pendulum_core::real::Real>(given: [T; 0]) -> [T; 0] {
                let [] = given;
                []
            }
            let given = params.to_array();
            for (name, value) in Ur5Params::NAMES.into_iter().zip(given) {
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
            let [] = rules(given);
            let constants = constants(given);
            let names: [&'static str; 0] = [];
            for (name, value) in names.into_iter().zip(constants) {
                if !value.is_finite() {
                    let given: [_; 0] = ::core::array::from_fn(|n| (
                        Ur5Params::NAMES[n],
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
        pub fn cast<T: ::pendulum_core::real::Real>(&self) -> Ur5<T> {
            Ur5 {
                params: self.params,
                constants: self.constants.map(T::from_f64),
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> Ur5<T> {
        /// Returns the parameters from which the model was built.
        pub fn params(&self) -> &Ur5Params {
            &self.params
        }
        /// Returns a model with other parameters, in the same number type, and recomputes its constants.
        ///
        /// # Errors
        ///
        /// Returns the errors of `new`.
        pub fn with_params(
            &self,
            params: Ur5Params,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            Ok(<Ur5>::new(params)?.cast())
        }
    }
    impl Ur5 {
        ///Index of `q1` in the state, in rad.
        pub const Q1: usize = 0;
        ///Index of `dot(q1)` in the state, in rad/s.
        pub const DOT_Q1: usize = 6;
        ///Index of `q2` in the state, in rad.
        pub const Q2: usize = 1;
        ///Index of `dot(q2)` in the state, in rad/s.
        pub const DOT_Q2: usize = 7;
        ///Index of `q3` in the state, in rad.
        pub const Q3: usize = 2;
        ///Index of `dot(q3)` in the state, in rad/s.
        pub const DOT_Q3: usize = 8;
        ///Index of `q4` in the state, in rad.
        pub const Q4: usize = 3;
        ///Index of `dot(q4)` in the state, in rad/s.
        pub const DOT_Q4: usize = 9;
        ///Index of `q5` in the state, in rad.
        pub const Q5: usize = 4;
        ///Index of `dot(q5)` in the state, in rad/s.
        pub const DOT_Q5: usize = 10;
        ///Index of `q6` in the state, in rad.
        pub const Q6: usize = 5;
        ///Index of `dot(q6)` in the state, in rad/s.
        pub const DOT_Q6: usize = 11;
        /// Number of degrees of freedom. The state has twice as many components.
        pub const DOF: usize = 6;
        /// Names of the coordinates. The state holds their positions and then their rates in this order.
        pub const COORDINATES: [&'static str; 6] = ["q1", "q2", "q3", "q4", "q5", "q6"];
        /// Operation counts of each generated function, in its own form and in others.
        pub const COST: ::pendulum_core::Cost = ::pendulum_core::Cost::new(
            &[
                (
                    "rhs",
                    ::pendulum_core::FunctionCost::new(
                            "recursion, L^T D L",
                            ::pendulum_core::Operations::new(176, 202, 5, 5, 0, 79),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factored, L^T D L",
                                    ::pendulum_core::Operations::new(225, 358, 5, 5, 0, 72),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L",
                                    ::pendulum_core::Operations::new(314, 760, 5, 5, 0, 115),
                                ),
                            ],
                        ),
                ),
                (
                    "jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "recursion, L^T D L, derived in the graph",
                            ::pendulum_core::Operations::new(740, 839, 5, 5, 0, 120),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factored, L^T D L, derived in the graph",
                                    ::pendulum_core::Operations::new(951, 1359, 5, 5, 0, 103),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L, derived in the graph",
                                    ::pendulum_core::Operations::new(1741, 2576, 5, 5, 0, 135),
                                ),
                            ],
                        ),
                ),
                (
                    "kinetic",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factored",
                            ::pendulum_core::Operations::new(53, 77, 0, 5, 0, 39),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(53, 95, 0, 5, 0, 40),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(70, 92, 0, 5, 0, 51),
                                ),
                            ],
                        ),
                ),
                (
                    "potential",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factored",
                            ::pendulum_core::Operations::new(5, 3, 0, 3, 0, 24),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(5, 3, 0, 3, 0, 24),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(10, 9, 0, 3, 0, 31),
                                ),
                            ],
                        ),
                ),
                (
                    "mass_matrix",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factored",
                            ::pendulum_core::Operations::new(36, 51, 0, 5, 0, 34),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(36, 60, 0, 5, 0, 36),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(50, 49, 0, 5, 0, 41),
                                ),
                            ],
                        ),
                ),
                (
                    "bias",
                    ::pendulum_core::FunctionCost::new(
                            "recursion",
                            ::pendulum_core::Operations::new(85, 114, 0, 5, 0, 46),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factored",
                                    ::pendulum_core::Operations::new(169, 338, 0, 5, 0, 39),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(221, 645, 0, 5, 0, 101),
                                ),
                            ],
                        ),
                ),
                (
                    "momentum",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factored",
                            ::pendulum_core::Operations::new(57, 84, 0, 5, 0, 37),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(65, 85, 0, 5, 0, 47),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(64, 98, 0, 5, 0, 40),
                                ),
                            ],
                        ),
                ),
                (
                    "inverse_dynamics",
                    ::pendulum_core::FunctionCost::new(
                            "recursion",
                            ::pendulum_core::Operations::new(131, 151, 0, 5, 0, 53),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factored",
                                    ::pendulum_core::Operations::new(213, 333, 0, 5, 0, 49),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(290, 735, 0, 5, 0, 107),
                                ),
                            ],
                        ),
                ),
                (
                    "taylor",
                    ::pendulum_core::FunctionCost::new(
                            "recursion, L^T D L",
                            ::pendulum_core::Operations::new(444, 374, 0, 0, 0, 55),
                        )
                        .with_products(142)
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                        "closed form, factored, L^T D L",
                                        ::pendulum_core::Operations::new(839, 737, 0, 0, 0, 47),
                                    )
                                    .with_products(297),
                                ::pendulum_core::FunctionCost::new(
                                        "closed form, expanded, L^T D L",
                                        ::pendulum_core::Operations::new(1579, 1415, 0, 0, 0, 108),
                                    )
                                    .with_products(582),
                            ],
                        ),
                ),
            ],
        );
        /// Layout of the state.
        pub const LAYOUT: ::pendulum_core::StateLayout<'static> = ::pendulum_core::StateLayout::new(
                &[
                    ::pendulum_core::Slot::new(
                            "q1",
                            ::pendulum_core::SlotKind::Angle,
                            0..1,
                            6..7,
                        )
                        .periodic()
                        .cyclic(),
                    ::pendulum_core::Slot::new(
                            "q2",
                            ::pendulum_core::SlotKind::Angle,
                            1..2,
                            7..8,
                        )
                        .periodic(),
                    ::pendulum_core::Slot::new(
                            "q3",
                            ::pendulum_core::SlotKind::Angle,
                            2..3,
                            8..9,
                        )
                        .periodic(),
                    ::pendulum_core::Slot::new(
                            "q4",
                            ::pendulum_core::SlotKind::Angle,
                            3..4,
                            9..10,
                        )
                        .periodic(),
                    ::pendulum_core::Slot::new(
                            "q5",
                            ::pendulum_core::SlotKind::Angle,
                            4..5,
                            10..11,
                        )
                        .periodic(),
                    ::pendulum_core::Slot::new(
                            "q6",
                            ::pendulum_core::SlotKind::Angle,
                            5..6,
                            11..12,
                        )
                        .periodic(),
                ],
            )
            .autonomous();
        /// Equations of motion as text.
        pub const EQUATIONS: &'static str = "A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints\n\nA[q1, q1] = 0.4395951218175 + 0.10510116377025*c234^2 + 1.75501953841*c2^2 + 0.59155695167475*c23^2\n    + c234*(c234*(0.10971 + 0.016685526855*c6^2 + c5^2*t8) - 0.03337105371*c5*s6*c6*s234) + 0.85*t9\n    - 0.0139521246075*c23*s234 - c5^2*t8\nA[q1, q2] = A[q1, q3] + 0.408499208875*s2\nA[q1, q3] = A[q1, q4] + 0.07714261911625*s23\nA[q1, q4] = 0.00194120382525*c234 - 0.016685526855*s5*s6*c6*c234 - s5*c5*s234*t8\nA[q1, q5] = 0.016685526855*c5*s6*c6*s234 - c234*A[q5, q5]\nA[q1, q6] = -0.017136473145*s5*s234\nA[q2, q2] = A[q3, q3] + 1.77012693841 + 0.85*t9 + 0.85*t10\nA[q2, q3] = A[q3, q3] + 0.425*t9 + 0.425*t10\nA[q2, q4] = A[q3, q4] + 0.007558512375*s2*c234 - 0.007558512375*c2*s234\nA[q2, q5] = 0.016685526855*s5*s6*c6\nA[q2, q6] = 0.017136473145*c5\nA[q3, q3] = A[q4, q4] + 0.59565195167475 + 0.0139521246075*s23*c234 - 0.0139521246075*c23*s234\nA[q3, q4] = A[q4, q4] + 0.00697606230375*s23*c234 - 0.00697606230375*c23*s234\nA[q3, q5] = A[q2, q5]\nA[q3, q6] = A[q2, q6]\nA[q4, q4] = 0.25785083622975 + c5^2*t8 - 0.016685526855*c6^2\nA[q4, q5] = A[q2, q5]\nA[q4, q6] = A[q2, q6]\nA[q5, q5] = 0.236556473145 + 0.016685526855*c6^2\nA[q6, q6] = 0.017136473145\nb[q1] = 0.602212521625*c2*t0 + 0.02581996229125*t6 + 0.051322656825*c23*w23^2 + 0.017784735*s234*(t7 + 0.39225*s23*t2)\n    + s234*(c5*t20 + s5*t21) - 3.51003907682*dot(q1)*dot(q2)*s2*c2 - 0.19371331275*dot(q2)^2*c2\n    - 0.602212521625*dot(q1)^2*c2 - 1.598759275*c23*t7 - 0.59155695167475*s23*c23*t2 - 0.00028722347025*s234*t11\n    - 0.10510116377025*c234*s234*t4 - 0.001653980355*s234*w234^2 - c234*b[q5] - 0.00697606230375*c23*c234*t4\n    - 0.425*c2*(1.598759275*s23*t2 + 0.017784735*c234*t4)\nb[q2] = b[q3] + 1.75501953841*dot(q1)^2*s2*c2 - 43.486969725*c2\n    - 0.425*c2*(1.598759275*s23*w23^2 + 0.017784735*c234*w234^2) - 0.425*s2*(0.017784735*s234*t11 - 1.598759275*t6)\nb[q3] = b[q4] + 0.59155695167475*dot(q1)^2*s23*c23 + 0.679472691875*c2*s23*t0 + 0.051322656825*c23*(t1 - dot(q1)*w23)\n    - 1.598759275*c23*t22 - 0.00697606230375*c23*c234*w234^2 - 0.00697606230375*s23*s234*t11\nb[q4] = 0.10510116377025*dot(q1)^2*c234*s234 + 0.017784735*c234*(0.425*c2*t0 + 0.39225*t6) + s5*t20\n    + 0.017784735*s234*(t22 + 0.39225*s23*w23^2) - 0.001653980355*s234*(t3 - dot(q1)*w234) - c5*t21\nb[q5] = 0.236331*s234*t3 + c6*t17 + s6*t19 - 0.016911*t12*t13\nb[q6] = -(0.017136473145*dot(q5)*t13 + 0.016685526855*t14*t18 + 0.017136473145*s5*c234*t3)\n\nwhere\ns2 = sin(q2)\nc2 = cos(q2)\ns5 = sin(q5)\nc5 = cos(q5)\ns6 = sin(q6)\nc6 = cos(q6)\ns23 = sin(q2 + q3)\nc23 = cos(q2 + q3)\nc234 = cos(q2 + q3 + q4)\ns234 = sin(q2 + q3 + q4)\nw23 = dot(q2) + dot(q3)\nw234 = w23 + dot(q4)\nt0 = dot(q1)^2 + dot(q2)^2\nt1 = dot(q1)*dot(q2) + dot(q1)*dot(q3)\nt2 = t1 + dot(q1)*w23\nt3 = t1 + dot(q1)*dot(q4)\nt4 = t3 + dot(q1)*w234\nt5 = dot(q5) - dot(q1)*c234\nt6 = c23*(dot(q1)^2 + w23^2)\nt7 = 0.01615*dot(q1)^2 + 0.85*dot(q1)*dot(q2)*s2\nt8 = 0.016685526855*c6^2 - 0.016685526855\nt9 = c2*(1.598759275*c23 - 0.017784735*s234)\nt10 = s2*(1.598759275*s23 + 0.017784735*c234)\nt11 = dot(q1)^2 + w234^2\nt12 = c5*w234 - dot(q1)*s5*s234\nt13 = dot(q1)*c5*s234 + s5*w234\nt14 = c6*t13 - s6*t5\nt15 = dot(q5)*t12 + c5*c234*t3\nt16 = t12 + dot(q6)\nt17 = 0.016911*dot(q6)*t14 + 0.016911*c6*s234*t3 + 0.016911*s6*t15 + 0.016911*t14*t16\nt18 = c6*t5 + s6*t13\nt19 = 0.000225473145*dot(q6)*t18 + 0.000225473145*s6*s234*t3 + 0.000225473145*t16*t18 - 0.000225473145*c6*t15\nt20 = 0.126621*dot(q5)*t12 + 0.126621*t5*t12 + 0.126621*c5*c234*t3 + s6*t17 - c6*t19\nt21 = 0.126846473145*dot(q5)*t13 + 0.10971*t5*t13 + 0.016685526855*t14*t18 + 0.126846473145*s5*c234*t3\nt22 = 9.81 + 0.425*dot(q2)^2*s2\n";
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::System<T, 12> for Ur5<T> {
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn rhs(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 12>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 12> {
            struct __Code<'a, T> {
                t: T,
                x: &'a ::pendulum_core::nalgebra::SVector<T, 12>,
            }
            #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
            impl<
                T: ::pendulum_core::real::Real,
            > ::pendulum_core::real::lanes::Routine<(), Ur5<T>> for __Code<'_, T> {
                type Output = ::pendulum_core::nalgebra::SVector<T, 12>;
                #[cfg_attr(debug_assertions, inline)]
                #[cfg_attr(not(debug_assertions), inline(always))]
                fn run(
                    self,
                    (): &mut (),
                    model: &Ur5<T>,
                ) -> ::pendulum_core::nalgebra::SVector<T, 12> {
                    let Self { t, x } = self;
                    let [_, q_q2, q_q3, q_q4, q_q5, q_q6, qd_q1, qd_q2, qd_q3, qd_q4,
                    qd_q5, qd_q6] = x.data.0[0];
                    let t0 = q_q2 + q_q3;
                    let t1 = t0 + q_q4;
                    let (sin2, cos2) = t1.sin_cos();
                    let t3 = qd_q1 * qd_q2;
                    let t4 = qd_q1.mul_add(qd_q3, t3);
                    let t5 = T::from_f64(2.0) * t3;
                    let t6 = qd_q2 + qd_q3;
                    let t7 = sin2 * qd_q1;
                    let t8 = qd_q4 + t6;
                    let t9 = qd_q1.mul_add(qd_q4, t4);
                    let t10 = cos2.mul_neg_add(qd_q1, qd_q5);
                    let t11 = cos2 * t9;
                    let t12 = sin2 * t9;
                    let t13 = qd_q1 * qd_q1;
                    let t14 = qd_q2 * qd_q2;
                    let t15 = T::from_f64(0.10510116377025) * cos2;
                    let t16 = t13 + t14;
                    let t17 = t8 * t8;
                    let t18 = t6 * t6;
                    let t19 = qd_q1 * t6;
                    let t20 = T::from_f64(0.017784735) * cos2;
                    let t21 = t13 + t17;
                    let t22 = t13 + t18;
                    let t23 = t15 * sin2;
                    let t24 = T::from_f64(0.017784735) * sin2;
                    let t25 = T::from_f64(0.001653980355) * sin2;
                    let t26 = qd_q1 * t8;
                    let t27 = t24 * t21;
                    let t28 = t20 * t17;
                    let t29 = T::from_f64(0.13585) * t13;
                    let t30 = t4 + t19;
                    let t31 = t9 + t26;
                    let t32 = t20 * t31;
                    let [(sin33, cos33), (sin_q5, cos_q5)] = t0.sin_cos_pair(q_q5);
                    let t34 = sin_q5.mul_add(t8, cos_q5 * t7);
                    let t35 = sin_q5.mul_neg_add(t7, cos_q5 * t8);
                    let t36 = qd_q5.mul_add(t35, cos_q5 * t11);
                    let t37 = qd_q5.mul_add(t34, sin_q5 * t11);
                    let t38 = qd_q6 + (t35 + qd_q6);
                    let t39 = T::from_f64(0.39225) * cos33;
                    let t40 = T::from_f64(0.39225) * sin33;
                    let t41 = T::from_f64(0.59155695167475) * cos33;
                    let t42 = cos33 * t41;
                    let t43 = t41 * sin33;
                    let t44 = t39 * t24;
                    let t45 = t20 * t40;
                    let t46 = t34 * t35;
                    let t47 = T::from_f64(1.598759275) * cos33;
                    let t48 = T::from_f64(1.598759275) * sin33;
                    let t49 = T::from_f64(0.051322656825) * cos33;
                    let t50 = sin2 * sin_q5;
                    let t51 = T::from_f64(0.017136473145) * t50;
                    let t52 = t20 + t48;
                    let t53 = t47.mul_neg_add(t22, t27);
                    let t54 = T::from_f64(58.35506475215265) * t51;
                    let [(sin_q6, cos_q6), (sin_q2, cos_q2)] = q_q6.sin_cos_pair(q_q2);
                    let t55 = sin_q6.mul_add(t34, cos_q6 * t10);
                    let t56 = sin_q6.mul_neg_add(t10, cos_q6 * t34);
                    let t57 = T::from_f64(0.016911)
                        * t56.mul_add(t38, sin_q6.mul_add(t36, cos_q6 * t12));
                    let t58 = T::from_f64(0.000225473145)
                        * cos_q6.mul_neg_add(t36, t55.mul_add(t38, sin_q6 * t12));
                    let t59 = cos_q6
                        .mul_neg_add(
                            t58,
                            sin_q6
                                .mul_add(t57, T::from_f64(0.126621) * t10.mul_add(t35, t36)),
                        );
                    let t60 = T::from_f64(0.126621)
                        .mul_neg_add(
                            t46 - t12,
                            sin_q6
                                .mul_add(
                                    t58,
                                    cos_q6.mul_add(t57, T::from_f64(0.10971) * (t12 + t46)),
                                ),
                        );
                    let t61 = t55 * t56;
                    let t62 = T::from_f64(0.016911)
                        .mul_neg_add(
                            t61 + t37,
                            T::from_f64(0.000225473145) * (t61 - t37),
                        );
                    let t63 = T::from_f64(0.10971)
                        .mul_neg_add(t10.mul_add(t34, t37), t62);
                    let t64 = T::from_f64(0.016685526855) * cos_q6;
                    let t65 = cos_q6 * t64;
                    let t66 = t64 * sin_q6;
                    let t67 = T::from_f64(0.109935473145) + t65;
                    let t68 = T::from_f64(0.016911) - t65;
                    let t69 = cos_q5 * (t67 - T::from_f64(0.126621));
                    let t70 = cos_q5 * t69;
                    let t71 = sin2 * (cos_q5 * t66);
                    let t72 = t66 * sin_q5;
                    let t73 = T::from_f64(0.001653980355)
                        .mul_neg_add(cos2, cos2.mul_add(t72, t69 * t50));
                    let t74 = T::from_f64(0.126621) + t70;
                    let t75 = cos2
                        .mul_add(
                            T::from_f64(2.0).mul_neg_add(t71, cos2 * (t74 - t68)),
                            cos2 * t15,
                        );
                    let t76 = T::from_f64(0.00460883622975) + t68 + t75;
                    let t77 = T::from_f64(0.10971) + t74 - t75;
                    let t78 = T::from_f64(0.425) * cos_q2;
                    let t79 = T::from_f64(0.126621) + t67;
                    let t80 = cos2.mul_neg_add(t79, t71);
                    let t81 = T::from_f64(-1.0) / t79;
                    let t82 = t78 * t16;
                    let t83 = sin_q5
                        .mul_add(
                            t59,
                            t23.mul_add(t21 - t17, t20 * t39.mul_add(t22, t82)),
                        );
                    let t84 = T::from_f64(0.425) * sin_q2;
                    let t85 = t81 * t72;
                    let t86 = t72
                        .mul_neg_add(t85, T::from_f64(0.017136473145) * cos_q5 * cos_q5);
                    let t87 = t84.mul_neg_add(t14, T::from_f64(-9.81));
                    let t88 = t25
                        .mul_neg_add(
                            t9 - t26,
                            t24
                                .mul_neg_add(
                                    t40.mul_neg_add(t18, t87),
                                    cos_q5.mul_add(t63, t83),
                                ),
                        );
                    let t89 = t43
                        .mul_add(
                            t22 - t18,
                            t49
                                .mul_add(t4 - t19, t48.mul_add(t82, t47.mul_add(t87, t88))),
                        );
                    let t90 = t76 + t77;
                    let t91 = T::from_f64(2.0)
                        .mul_neg_add(t44, T::from_f64(0.0020475) + t42 + t76);
                    let t92 = T::from_f64(2.0)
                        .mul_add(t45, T::from_f64(0.59360445167475) + t77) - t42;
                    let t93 = t90 + t45 - t44 - t86;
                    let t94 = T::from_f64(-1.0) / (t90 - t86);
                    let t95 = t24.mul_neg_add(t78, t20.mul_add(t84, t93));
                    let t96 = t91 + t92 - t86;
                    let t97 = t94 * t93;
                    let t98 = T::from_f64(-1.0) / t93.mul_add(t97, t96);
                    let t99 = t85.mul_neg_add(t60, cos_q5 * t62);
                    let t100 = t40.mul_neg_add(t27, t39.mul_neg_add(t28, t89)) - t99;
                    let t101 = t88 - t99;
                    let t102 = t78 * (t47 - t24);
                    let t103 = t80.mul_add(t85, cos_q5 * t51);
                    let t104 = T::from_f64(1.75501953841) * cos_q2;
                    let t105 = t52 * t84;
                    let t106 = t97.mul_add(t95, t102 + t105) + t96;
                    let t107 = cos_q2 * t104;
                    let t108 = T::from_f64(2.0)
                        .mul_add(t102, T::from_f64(0.0075537) + t107 + t91);
                    let t109 = t104 * sin_q2;
                    let t110 = T::from_f64(0.1197)
                        .mul_neg_add(t52, T::from_f64(0.051322656825) * sin33) - t73
                        + t103;
                    let t111 = T::from_f64(0.00028722347025).mul_add(cos2, t103) - t73;
                    let t112 = t94 * t95;
                    let t113 = t98 * t106;
                    let t114 = t106
                        .mul_add(
                            t113,
                            t95
                                .mul_add(
                                    t112,
                                    T::from_f64(2.0)
                                        .mul_add(t105, T::from_f64(1.76257323841) + t108 + t92),
                                ),
                        );
                    let t115 = T::from_f64(-1.0) / (t114 - t107 - t86);
                    let t116 = t97.mul_add(t101, t100);
                    let t117 = T::from_f64(43.486969725)
                        .mul_neg_add(
                            cos_q2,
                            t113.mul_add(t116, t112.mul_add(t101, t109 * (t16 - t14)))
                                + t100,
                        );
                    let t118 = t84
                        .mul_neg_add(t53, t78.mul_neg_add(t48.mul_add(t18, t28), t117));
                    let t119 = t84
                        .mul_neg_add(t5, T::from_f64(0.1197).mul_sub(t13, t29));
                    let t120 = t25
                        .mul_add(
                            t13 - t21,
                            t47
                                .mul_add(
                                    t119,
                                    (T::from_f64(0.19371331275) * cos_q2)
                                        .mul_add(t13 - t16, t54 * t62),
                                ),
                        );
                    let t121 = t111.mul_add(t97, T::from_f64(0.13585) * t52) + t110;
                    let t122 = t121
                        .mul_add(
                            t113,
                            t111
                                .mul_add(
                                    t112,
                                    T::from_f64(0.13585)
                                        * T::from_f64(4.4329225).mul_add(sin_q2, t52),
                                ),
                        ) + t110;
                    let t123 = T::from_f64(0.19371331275).mul_neg_add(sin_q2, t122);
                    let t124 = T::from_f64(4.4329225) * cos_q2;
                    let t125 = t111 * t94;
                    let t126 = t121 * t98;
                    let t127 = t123 * t115;
                    let t128 = t127
                        .mul_add(
                            t118,
                            t126
                                .mul_add(
                                    t116,
                                    t125.mul_add(t101, T::from_f64(0.1197).mul_add(t53, t120)),
                                ),
                        );
                    let t129 = t80 * t81;
                    let t130 = t43
                        .mul_neg_add(
                            t30,
                            t5
                                .mul_neg_add(
                                    t109,
                                    t124.mul_neg_add(t29, t60.mul_add(t129 - cos2, t128)),
                                ),
                        );
                    let t131 = t23
                        .mul_neg_add(
                            t31,
                            t24
                                .mul_neg_add(
                                    t40.mul_neg_add(t30, t119),
                                    t49.mul_neg_add(t13 - t22, t130),
                                ),
                        );
                    let t132 = t78
                        .mul_neg_add(
                            t48.mul_add(t30, t32),
                            t39
                                .mul_neg_add(
                                    t32,
                                    sin2
                                        .mul_neg_add(cos_q5.mul_neg_add(t59, sin_q5 * t63), t131),
                                ),
                        );
                    let t133 = t121
                        .mul_add(
                            t126,
                            t111
                                .mul_add(
                                    t125,
                                    t80
                                        .mul_add(t129, T::from_f64(0.29853861244275) + t67 + t108),
                                ),
                        );
                    let t134 = T::from_f64(-1.0)
                        / t51.mul_neg_add(t54, t123.mul_add(t127, t133) - t70)
                        * T::from_f64(0.13585)
                            .mul_neg_add(t124.mul_neg_add(t16, t53), t132);
                    let t135 = t127.mul_add(t134, t115 * t118);
                    let t136 = t113.mul_add(t135, t126.mul_add(t134, t98 * t116));
                    let t137 = t97
                        .mul_add(
                            t136,
                            t112.mul_add(t135, t125.mul_add(t134, t94 * t101)),
                        );
                    let t138 = t137 + (t135 + t136);
                    let t139 = cos_q5
                        .mul_neg_add(
                            t138,
                            T::from_f64(58.35506475215265).mul_neg_add(t62, t54 * t134),
                        );
                    let t140 = t85.mul_add(t138, t129.mul_add(t134, t81 * t60));
                    ::pendulum_core::nalgebra::SVector::from([
                        qd_q1,
                        qd_q2,
                        qd_q3,
                        qd_q4,
                        qd_q5,
                        qd_q6,
                        t134,
                        t135,
                        t136,
                        t137,
                        t140,
                        t139,
                    ])
                }
            }
            T::apart(__Code { t, x }, &mut (), self)
        }
        #[inline(always)]
        fn is_apart(&self) -> bool {
            true
        }
        #[inline]
        fn layout(&self) -> ::core::option::Option<::pendulum_core::StateLayout<'_>> {
            Some(<Ur5>::LAYOUT)
        }
    }
    struct __Code<'a, T> {
        t: T,
        x: &'a ::pendulum_core::nalgebra::SVector<T, 12>,
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<
        T: ::pendulum_core::real::Real,
    > ::pendulum_core::real::lanes::Routine<(), Ur5<T>> for __Code<'_, T> {
        type Output = (
            ::pendulum_core::nalgebra::SVector<T, 12>,
            ::pendulum_core::nalgebra::SMatrix<T, 12, 12>,
        );
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn run(
            self,
            (): &mut (),
            model: &Ur5<T>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 12>,
            ::pendulum_core::nalgebra::SMatrix<T, 12, 12>,
        ) {
            let Self { t, x } = self;
            let [_, q_q2, q_q3, q_q4, q_q5, q_q6, qd_q1, qd_q2, qd_q3, qd_q4, qd_q5,
            qd_q6] = x.data.0[0];
            let (
                sin2,
                cos2,
                t5,
                t6,
                t7,
                t8,
                t10,
                t11,
                t16,
                t21,
                t22,
                t23,
                t25,
                t27,
                t28,
                t29,
                t30,
                t31,
                t32,
                t33,
                t34,
                t39,
                t41,
                t42,
                t46,
                t47,
                t49,
                t50,
                t51,
                t52,
                t53,
                t54,
                t55,
                t56,
                t57,
                t58,
                sin_q5,
                cos_q5,
                t62,
                t63,
                t65,
                t66,
                t68,
                t70,
                t73,
                t74,
                t75,
                t78,
                t79,
                t88,
                t90,
                t91,
                t94,
                t99,
                t100,
                t101,
                t102,
                t103,
                t104,
                t105,
                t106,
                t107,
                t108,
                t109,
                t110,
                t111,
                t112,
                t113,
                sin_q6,
                cos_q6,
                sin_q2,
                cos_q2,
                t120,
                t121,
                t134,
                t139,
                t140,
                t141,
                t144,
                t149,
                t150,
                t152,
                t153,
                t155,
                t156,
                t159,
                t162,
                t164,
                t165,
                t167,
                t168,
                t169,
                t170,
                t174,
                t195,
                t196,
                t200,
                t201,
                t202,
                t203,
                t204,
                t205,
                t206,
                t209,
                t210,
                t211,
                t212,
                t213,
                t214,
                t215,
                t216,
                t219,
                t220,
                t222,
                t223,
                t224,
                t225,
                t227,
                t229,
                t233,
                t234,
                t235,
                t238,
                t239,
                t240,
                t243,
                t246,
                t250,
                t251,
                t252,
                t253,
                t254,
            ) = {
                let t0 = q_q2 + q_q3;
                let t1 = t0 + q_q4;
                let (sin2, cos2) = t1.sin_cos();
                let t3 = T::from_f64(0.10510116377025) * cos2;
                let t4 = cos2 * t3;
                let t5 = t3 * sin2;
                let t6 = T::from_f64(0.017784735) * sin2;
                let t7 = T::from_f64(0.001653980355) * cos2;
                let t8 = T::from_f64(0.017784735) * cos2;
                let t9 = cos2 * qd_q1;
                let t10 = qd_q5 - t9;
                let t11 = sin2 * qd_q1;
                let t12 = qd_q2 + qd_q3;
                let t13 = qd_q4 + t12;
                let t14 = qd_q1 * qd_q2;
                let t15 = qd_q1.mul_add(qd_q3, t14);
                let t16 = T::from_f64(2.0) * t14;
                let t17 = qd_q1.mul_add(qd_q4, t15);
                let t18 = cos2 * t17;
                let t19 = qd_q1 * qd_q1;
                let t20 = qd_q2 * qd_q2;
                let t21 = t19 + t20;
                let t22 = t19 - t21;
                let t23 = T::from_f64(0.13585) * t19;
                let t24 = qd_q1 * t12;
                let t25 = t15 + t24;
                let t26 = t15 - t24;
                let t27 = T::from_f64(0.001653980355) * sin2;
                let t28 = t13 * t13;
                let t29 = t19 + t28;
                let t30 = t19 - t29;
                let t31 = t6 * t29;
                let t32 = t12 * t12;
                let t33 = T::from_f64(2.0) * t12;
                let t34 = t19 + t32;
                let t35 = t29 - t28;
                let t36 = sin2 * t17;
                let t37 = qd_q1 * t13;
                let t38 = t17 - t37;
                let t39 = t17 + t37;
                let t40 = t34 - t32;
                let t41 = t8 * t28;
                let t42 = t21 - t20;
                let t43 = t19 - t34;
                let t44 = t8 * t39;
                let t45 = T::from_f64(0.10510116377025) * sin2;
                let t46 = sin2.mul_neg_add(t45, t4);
                let t47 = cos2.mul_add(t45, t5);
                let t48 = cos2 * t13;
                let t49 = T::from_f64(0.2717) * qd_q1;
                let t50 = T::from_f64(2.0) * qd_q2;
                let t51 = T::from_f64(2.0) * qd_q1;
                let t52 = t6 * t51;
                let t53 = t5 * t51;
                let t54 = sin2 * t13;
                let t55 = T::from_f64(2.0) * t13;
                let t56 = t8 * t55;
                let t57 = t6 * t55;
                let t58 = t8 * t51;
                let [(sin59, cos59), (sin_q5, cos_q5)] = t0.sin_cos_pair(q_q5);
                let t60 = T::from_f64(0.59155695167475) * cos59;
                let t61 = cos59 * t60;
                let t62 = t60 * sin59;
                let t63 = T::from_f64(0.39225) * cos59;
                let t64 = t63 * t6;
                let t65 = T::from_f64(1.598759275) * cos59;
                let t66 = sin2 * sin_q5;
                let t67 = T::from_f64(0.017136473145) * t66;
                let t68 = T::from_f64(1.598759275) * sin59;
                let t69 = t8 + t68;
                let t70 = T::from_f64(0.39225) * sin59;
                let t71 = t8 * t70;
                let t72 = T::from_f64(0.051322656825) * sin59;
                let t73 = T::from_f64(58.35506475215265) * t67;
                let t74 = sin_q5.mul_add(t13, cos_q5 * t11);
                let t75 = sin_q5.mul_neg_add(t11, cos_q5 * t13);
                let t76 = qd_q5 * t74;
                let t77 = sin_q5.mul_add(t18, t76);
                let t78 = t70 * t25;
                let t79 = t65 * t34;
                let t80 = t31 - t79;
                let t81 = t63 * t34;
                let t82 = t70 * t32;
                let t83 = qd_q5 * t75;
                let t84 = cos_q5.mul_add(t18, t83);
                let t85 = t10 * t75;
                let t86 = t75 + qd_q6;
                let t87 = t10 * t74;
                let t88 = t74 * t75;
                let t89 = T::from_f64(0.051322656825) * cos59;
                let t90 = t68 * t32;
                let t91 = t68 * t25;
                let t92 = sin_q5 * t9;
                let t93 = cos_q5 * t9;
                let t94 = qd_q6 + t86;
                let t95 = t74.mul_neg_add(t92, t75 * t93);
                let t96 = T::from_f64(0.59155695167475) * sin59;
                let t97 = sin59.mul_neg_add(t96, t61);
                let t98 = cos59.mul_add(t96, t62);
                let t99 = cos_q5 * sin2;
                let t100 = qd_q5.mul_add(t99, sin_q5 * t48);
                let t101 = qd_q5.mul_neg_add(t66, cos_q5 * t48);
                let t102 = t65.mul_neg_add(t51, t52);
                let t103 = t74.mul_neg_add(t66, t75 * t99);
                let t104 = t62 * t51;
                let t105 = t70 * t33;
                let t106 = t63 * t56;
                let t107 = t70 * t51;
                let t108 = t63 * t33;
                let t109 = cos_q5.mul_add(qd_q5, t93);
                let t110 = sin_q5.mul_add(qd_q5, t92);
                let t111 = cos_q5.mul_add(t74, sin_q5 * t75);
                let t112 = t70.mul_add(t57, t106);
                let t113 = t65.mul_neg_add(t33, t57);
                let [(sin_q6, cos_q6), (sin_q2, cos_q2)] = q_q6.sin_cos_pair(q_q2);
                let t114 = T::from_f64(0.016685526855) * cos_q6;
                let t115 = cos_q6 * t114;
                let t116 = t114 * sin_q6;
                let t117 = T::from_f64(0.109935473145) + t115;
                let t118 = T::from_f64(0.016911) - t115;
                let t119 = T::from_f64(1.75501953841) * cos_q2;
                let t120 = cos_q2 * t119;
                let t121 = t119 * sin_q2;
                let t122 = cos_q5 * (t117 - T::from_f64(0.126621));
                let t123 = cos_q5 * t122;
                let t124 = T::from_f64(0.126621) + t123;
                let t125 = sin2 * (cos_q5 * t116);
                let t126 = cos2
                    .mul_add(
                        T::from_f64(2.0).mul_neg_add(t125, cos2 * (t124 - t118)),
                        t4,
                    );
                let t127 = T::from_f64(0.00460883622975) + t118 + t126;
                let t128 = T::from_f64(0.10971) + t124 - t126;
                let t129 = t116 * sin_q5;
                let t130 = cos2.mul_add(t129, t122 * t66) - t7;
                let t131 = T::from_f64(2.0)
                    .mul_neg_add(t64, T::from_f64(0.0020475) + t61 + t127);
                let t132 = t127 + t128;
                let t133 = T::from_f64(2.0)
                    .mul_add(t71, T::from_f64(0.59360445167475) + t128) - t61;
                let t134 = T::from_f64(0.425) * cos_q2;
                let t135 = t134 * (t65 - t6);
                let t136 = T::from_f64(2.0)
                    .mul_add(t135, T::from_f64(0.0075537) + t120 + t131);
                let t137 = T::from_f64(0.126621) + t117;
                let t138 = cos2.mul_neg_add(t137, t125);
                let t139 = T::from_f64(-1.0) / t137;
                let t140 = t138 * t139;
                let t141 = t139 * t129;
                let t142 = t129
                    .mul_neg_add(t141, T::from_f64(0.017136473145) * cos_q5 * cos_q5);
                let t143 = t132 + t71 - t64 - t142;
                let t144 = T::from_f64(-1.0) / (t132 - t142);
                let t145 = t131 + t133 - t142;
                let t146 = t138.mul_add(t141, cos_q5 * t67);
                let t147 = T::from_f64(0.00028722347025).mul_add(cos2, t146) - t130;
                let t148 = T::from_f64(0.1197).mul_neg_add(t69, t72) - t130 + t146;
                let t149 = t147 * t144;
                let t150 = t144 * t143;
                let t151 = t147.mul_add(t150, T::from_f64(0.13585) * t69) + t148;
                let t152 = T::from_f64(-1.0) / t143.mul_add(t150, t145);
                let t153 = t151 * t152;
                let t154 = t151
                    .mul_add(
                        t153,
                        t147
                            .mul_add(
                                t149,
                                t138
                                    .mul_add(t140, T::from_f64(0.29853861244275) + t117 + t136),
                            ),
                    );
                let t155 = T::from_f64(4.4329225) * sin_q2;
                let t156 = T::from_f64(0.425) * sin_q2;
                let t157 = t6.mul_neg_add(t134, t8.mul_add(t156, t143));
                let t158 = t156.mul_add(t16, T::from_f64(0.1197).mul_neg_add(t19, t23));
                let t159 = t144 * t157;
                let t160 = t69 * t156;
                let t161 = t150.mul_add(t157, t135 + t160) + t145;
                let t162 = t152 * t161;
                let t163 = t161
                    .mul_add(
                        t162,
                        t157
                            .mul_add(
                                t159,
                                T::from_f64(2.0)
                                    .mul_add(t160, T::from_f64(1.76257323841) + t136 + t133),
                            ),
                    );
                let t164 = T::from_f64(-1.0) / (t163 - t120 - t142);
                let t165 = T::from_f64(0.19371331275) * sin_q2;
                let t166 = t151
                    .mul_add(
                        t162,
                        t147.mul_add(t159, T::from_f64(0.13585) * (t69 + t155)),
                    ) + t148 - t165;
                let t167 = t166 * t164;
                let t168 = T::from_f64(-1.0)
                    / t67.mul_neg_add(t73, t166.mul_add(t167, t154) - t123);
                let t169 = sin_q6.mul_add(t74, cos_q6 * t10);
                let t170 = sin_q6.mul_neg_add(t10, cos_q6 * t74);
                let t171 = t169 * t170;
                let t172 = T::from_f64(0.016911)
                    .mul_neg_add(t171 + t77, T::from_f64(0.000225473145) * (t171 - t77));
                let t173 = T::from_f64(0.10971).mul_neg_add(t77 + t87, t172);
                let t174 = T::from_f64(0.19371331275) * cos_q2;
                let t175 = t27
                    .mul_add(t30, t6.mul_add(t158 + t78, t174.mul_add(t22, t73 * t172)));
                let t176 = t134 * t21;
                let t177 = t156.mul_add(t20, T::from_f64(9.81));
                let t178 = t170.mul_add(t86, t170 * qd_q6);
                let t179 = t169 * t86;
                let t180 = T::from_f64(0.016911)
                    * (sin_q6.mul_add(t84, cos_q6 * t36) + t178);
                let t181 = t169 * qd_q6;
                let t182 = T::from_f64(0.000225473145)
                    * cos_q6.mul_neg_add(t84, sin_q6.mul_add(t36, t179) + t181);
                let t183 = cos_q6
                    .mul_neg_add(
                        t182,
                        sin_q6.mul_add(t180, T::from_f64(0.126621) * (t84 + t85)),
                    );
                let t184 = T::from_f64(0.126621)
                    .mul_neg_add(
                        t88 - t36,
                        sin_q6
                            .mul_add(
                                t182,
                                cos_q6.mul_add(t180, T::from_f64(0.10971) * (t36 + t88)),
                            ),
                    );
                let t185 = sin_q5
                    .mul_add(
                        t183,
                        t5.mul_add(t35, t6.mul_add(t177 + t82, t8 * (t176 + t81))),
                    );
                let t186 = t27.mul_neg_add(t38, cos_q5.mul_add(t173, t185));
                let t187 = t141.mul_neg_add(t184, cos_q5 * t172);
                let t188 = t186 - t187;
                let t189 = t65
                    .mul_neg_add(
                        t177,
                        t62.mul_add(t40, t89.mul_add(t26, t68.mul_add(t176, t186))),
                    );
                let t190 = t70.mul_neg_add(t31, t63.mul_neg_add(t41, t189)) - t187;
                let t191 = t150.mul_add(t188, t190);
                let t192 = T::from_f64(43.486969725)
                    .mul_neg_add(
                        cos_q2,
                        t162.mul_add(t191, t159.mul_add(t188, t121 * t42)) + t190,
                    );
                let t193 = t156.mul_neg_add(t80, t134.mul_neg_add(t41 + t90, t192));
                let t194 = t167
                    .mul_add(
                        t193,
                        t153
                            .mul_add(
                                t191,
                                t149.mul_add(t188, T::from_f64(0.1197).mul_add(t80, t175)),
                            ),
                    );
                let t195 = t140 - cos2;
                let t196 = T::from_f64(4.4329225) * cos_q2;
                let t197 = t62
                    .mul_neg_add(
                        t25,
                        t16
                            .mul_neg_add(
                                t121,
                                t196.mul_neg_add(t23, t184.mul_add(t195, t194)),
                            ),
                    );
                let t198 = sin2
                    .mul_neg_add(
                        cos_q5.mul_neg_add(t183, sin_q5 * t173),
                        t5
                            .mul_neg_add(
                                t39,
                                t65.mul_neg_add(t158, t89.mul_neg_add(t43, t197)),
                            ),
                    );
                let t199 = T::from_f64(0.13585)
                    .mul_neg_add(
                        t196.mul_neg_add(t21, t80),
                        t134.mul_neg_add(t44 + t91, t63.mul_neg_add(t44, t198)),
                    );
                let t200 = t168 * t199;
                let t201 = t167.mul_add(t200, t164 * t193);
                let t202 = t162.mul_add(t201, t153.mul_add(t200, t152 * t191));
                let t203 = t150
                    .mul_add(t202, t159.mul_add(t201, t149.mul_add(t200, t144 * t188)));
                let t204 = t201 + t202;
                let t205 = t203 + t204;
                let t206 = t141.mul_add(t205, t140.mul_add(t200, t139 * t184));
                let t207 = cos2.mul_neg_add(t200, t36);
                let t208 = sin2.mul_add(t200, t18);
                let t209 = t6.mul_add(t200, t44);
                let t210 = sin_q5.mul_add(t205, cos_q5.mul_add(t208, t83));
                let t211 = t85 + t210;
                let t212 = t206 + t207;
                let t213 = t179 - sin_q6.mul_neg_add(t212, cos_q6.mul_sub(t210, t181));
                let t214 = sin_q6.mul_add(t210, cos_q6 * t212) + t178;
                let t215 = t134.mul_sub(t200, t158);
                let t216 = t68
                    .mul_sub(
                        t215,
                        t200
                            .mul_neg_add(
                                t98,
                                t25.mul_neg_add(t97, t89.mul_add(t204, t72 * t43)),
                            ),
                    );
                let t217 = t204 * t98;
                let t218 = cos_q5 * t205;
                let t219 = T::from_f64(58.35506475215265).mul_neg_add(t172, t73 * t200)
                    - t218;
                let t220 = sin_q5.mul_neg_add(t208, t218 - t76);
                let t221 = t219 + t220;
                let t222 = t87 - t220;
                let t223 = T::from_f64(0.10971)
                    .mul_neg_add(
                        t222,
                        T::from_f64(0.016911)
                            .mul_neg_add(
                                t171 - t221,
                                T::from_f64(0.000225473145) * (t171 + t221),
                            ),
                    );
                let t224 = t156.mul_add(t200, t134 * t16);
                let t225 = t70.mul_add(t200, t63 * t25);
                let t226 = t156 * t201;
                let t227 = t134.mul_add(t20, t226);
                let t228 = t70 * t204;
                let t229 = t63.mul_add(t32, t228);
                let t230 = t205 * t47;
                let t231 = t134 * t201;
                let t232 = t231 - t177;
                let t233 = t68
                    .mul_neg_add(
                        t232,
                        t72
                            .mul_neg_add(
                                t26,
                                t89.mul_add(t200, t40.mul_add(t97, t217)) - t217,
                            ),
                    );
                let t234 = t156.mul_sub(t21, t231);
                let t235 = t89.mul_neg_add(t33, t104)
                    - t134
                        .mul_neg_add(t68.mul_add(t51, t58), T::from_f64(0.1197) * t113);
                let t236 = t63 * t204;
                let t237 = t8
                    .mul_neg_add(
                        t232 + t236 - t82,
                        t7
                            .mul_neg_add(
                                t38,
                                t27.mul_neg_add(t200, t35.mul_add(t46, t230) - t230),
                            ),
                    );
                let t238 = t70.mul_neg_add(t34, t236);
                let t239 = T::from_f64(0.13585) * t200;
                let t240 = T::from_f64(0.1197).mul_sub(t200, t176) - t226 - t239;
                let t241 = qd_q5.mul_add(t92, cos_q5 * t207);
                let t242 = sin_q5.mul_neg_add(t207, qd_q5 * t93);
                let t243 = sin_q6 * t11;
                let t244 = cos_q6.mul_sub(t93, t243);
                let t245 = T::from_f64(0.016911)
                    * sin_q6
                        .mul_neg_add(
                            t241,
                            t170.mul_neg_add(t92, t244.mul_add(t94, cos_q6 * t208)),
                        );
                let t246 = cos_q6 * t11;
                let t247 = sin_q6.mul_add(t93, t246);
                let t248 = t169.mul_add(t244, t170 * t247);
                let t249 = T::from_f64(0.000225473145)
                    * t169
                        .mul_neg_add(
                            t92,
                            t247.mul_add(t94, sin_q6.mul_add(t208, cos_q6 * t241)),
                        );
                let t250 = cos_q6
                    .mul_neg_add(
                        t249,
                        sin_q6
                            .mul_add(
                                t245,
                                T::from_f64(0.126621)
                                    * (t10.mul_neg_add(t92, t11 * t75) - t241),
                            ),
                    );
                let t251 = T::from_f64(0.126621)
                    .mul_neg_add(
                        t95 - t208,
                        sin_q6
                            .mul_add(
                                t249,
                                cos_q6.mul_add(t245, T::from_f64(0.10971) * (t208 + t95)),
                            ),
                    );
                let t252 = T::from_f64(0.016911)
                    .mul_neg_add(
                        t248 + t242,
                        T::from_f64(0.000225473145) * (t248 - t242),
                    );
                let t253 = T::from_f64(0.10971)
                    .mul_neg_add(t11.mul_add(t74, t10.mul_add(t93, t242)), t252);
                let t254 = t237
                    + t6.mul_add(t240 - t81 - t228, cos_q5.mul_add(t253, sin_q5 * t250));
                (
                    sin2,
                    cos2,
                    t5,
                    t6,
                    t7,
                    t8,
                    t10,
                    t11,
                    t16,
                    t21,
                    t22,
                    t23,
                    t25,
                    t27,
                    t28,
                    t29,
                    t30,
                    t31,
                    t32,
                    t33,
                    t34,
                    t39,
                    t41,
                    t42,
                    t46,
                    t47,
                    t49,
                    t50,
                    t51,
                    t52,
                    t53,
                    t54,
                    t55,
                    t56,
                    t57,
                    t58,
                    sin_q5,
                    cos_q5,
                    t62,
                    t63,
                    t65,
                    t66,
                    t68,
                    t70,
                    t73,
                    t74,
                    t75,
                    t78,
                    t79,
                    t88,
                    t90,
                    t91,
                    t94,
                    t99,
                    t100,
                    t101,
                    t102,
                    t103,
                    t104,
                    t105,
                    t106,
                    t107,
                    t108,
                    t109,
                    t110,
                    t111,
                    t112,
                    t113,
                    sin_q6,
                    cos_q6,
                    sin_q2,
                    cos_q2,
                    t120,
                    t121,
                    t134,
                    t139,
                    t140,
                    t141,
                    t144,
                    t149,
                    t150,
                    t152,
                    t153,
                    t155,
                    t156,
                    t159,
                    t162,
                    t164,
                    t165,
                    t167,
                    t168,
                    t169,
                    t170,
                    t174,
                    t195,
                    t196,
                    t200,
                    t201,
                    t202,
                    t203,
                    t204,
                    t205,
                    t206,
                    t209,
                    t210,
                    t211,
                    t212,
                    t213,
                    t214,
                    t215,
                    t216,
                    t219,
                    t220,
                    t222,
                    t223,
                    t224,
                    t225,
                    t227,
                    t229,
                    t233,
                    t234,
                    t235,
                    t238,
                    t239,
                    t240,
                    t243,
                    t246,
                    t250,
                    t251,
                    t252,
                    t253,
                    t254,
                )
            };
            let (
                t306,
                t307,
                t308,
                t309,
                t311,
                t312,
                t316,
                t317,
                t318,
                t319,
                t321,
                t322,
                t326,
                t327,
                t328,
                t329,
                t331,
                t332,
                t348,
                t349,
                t350,
                t351,
                t353,
                t354,
                t361,
                t362,
                t363,
                t364,
                t366,
                t367,
                t393,
                t394,
                t395,
                t396,
                t398,
                t399,
                t427,
                t428,
                t429,
                t430,
                t432,
                t433,
                t441,
                t442,
                t443,
                t444,
                t446,
                t447,
                t451,
                t452,
                t453,
                t454,
                t456,
                t457,
                t467,
                t468,
                t469,
                t470,
                t472,
                t473,
                t480,
                t481,
                t482,
                t483,
                t485,
                t486,
            ) = {
                let t255 = t140
                    .mul_add(
                        t251,
                        t8.mul_neg_add(t63.mul_add(t200, t215) - t78, t73 * t252),
                    );
                let t256 = t8.mul_neg_add(t234 - t238, t6.mul_add(t227 + t229, t254));
                let t257 = t8.mul_add(t238, t6 * t229) + t254;
                let t258 = t141.mul_neg_add(t251, cos_q5 * t252);
                let t259 = T::from_f64(58.35506475215265) * t252;
                let t260 = t256 - t258;
                let t261 = t8 * t205;
                let t262 = t31 - t261;
                let t263 = t6.mul_neg_add(t28, t261);
                let t264 = t6 * t205;
                let t265 = t8.mul_add(t29, t264);
                let t266 = t41 + t264;
                let t267 = t70.mul_add(t265, t63 * t263);
                let t268 = t233
                    - t65.mul_add(t240, t70.mul_neg_add(t266, t63.mul_add(t262, t267)));
                let t269 = t68.mul_neg_add(t234, t65.mul_neg_add(t227, t256 + t268))
                    - t258;
                let t270 = t257 + t268 - t258;
                let t271 = t257 - t258;
                let t272 = t254 - t267 - t258;
                let t273 = t254 - t258;
                let t274 = t150.mul_add(t260, t269);
                let t275 = t153
                    .mul_add(
                        t274,
                        t149.mul_add(t260, t6.mul_add(t224 + t225, t155 * t23)),
                    );
                let t276 = T::from_f64(1.75501953841) * sin_q2;
                let t277 = sin_q2.mul_neg_add(t276, t120);
                let t278 = cos_q2.mul_add(t276, t121);
                let t279 = t201 * t278;
                let t280 = t159
                    .mul_add(
                        t260,
                        t42
                            .mul_add(
                                t277,
                                t196.mul_add(t239, T::from_f64(43.486969725) * sin_q2),
                            ) + t279,
                    );
                let t281 = t65 * t204;
                let t282 = t156
                    .mul_neg_add(
                        t281 - t90 - t266,
                        t174.mul_neg_add(t200, t162.mul_add(t274, t280) + t269 - t279),
                    );
                let t283 = t68.mul_add(t34, t265) - t281;
                let t284 = t68 * t204;
                let t285 = t156.mul_add(t283, t134 * (t65.mul_add(t32, t263) + t284));
                let t286 = t134.mul_neg_add(t262 - t79 - t284, t282) - t285;
                let t287 = t16
                    .mul_neg_add(
                        t277,
                        t174
                            .mul_neg_add(
                                t201,
                                t165.mul_neg_add(t22, t167.mul_add(t286, t275)),
                            ),
                    );
                let t288 = t156
                    .mul_neg_add(
                        t65.mul_sub(t200, t91) - t209,
                        t65.mul_neg_add(t224, t200.mul_neg_add(t278, t287)),
                    );
                let t289 = t6.mul_neg_add(t39, t8 * t200);
                let t290 = T::from_f64(0.016911) * t214;
                let t291 = T::from_f64(0.000225473145) * t214;
                let t292 = T::from_f64(0.000225473145) * t213;
                let t293 = T::from_f64(0.016911) * t213;
                let t294 = cos_q6.mul_neg_add(t292, sin_q6 * t290);
                let t295 = sin_q6.mul_add(t292, cos_q6 * t290);
                let t296 = cos_q5.mul_neg_add(t250, sin_q5 * t253)
                    - T::from_f64(0.126621)
                        .mul_neg_add(
                            t88 - t212,
                            T::from_f64(0.10971).mul_add(t88 + t212, t295),
                        );
                let t297 = cos_q6.mul_neg_add(t291, sin_q6.mul_neg_add(t293, t295));
                let t298 = cos_q6.mul_neg_add(t293, sin_q6 * t291) - t294;
                let t299 = T::from_f64(0.126621).mul_add(t211, t294);
                let t300 = cos_q5.mul_neg_add(t299, sin_q5 * t223);
                let t301 = t200
                    .mul_neg_add(
                        t47,
                        t39.mul_neg_add(t46, t27.mul_neg_add(t205, t7 * t30)),
                    ) - sin2.mul_add(t296, cos2 * (t300 + t251));
                let t302 = t301 + t255;
                let t303 = t139 * t251;
                let t304 = t63 * t289;
                let t305 = t134.mul_sub(t68.mul_add(t200, t65.mul_add(t25, t289)), t302)
                    + (t216
                        + T::from_f64(0.1197)
                            .mul_neg_add(t283, t70.mul_neg_add(t209, t304)));
                let t306 = t168
                    * (T::from_f64(0.13585)
                        .mul_neg_add(
                            t196.mul_neg_add(t201, t155.mul_add(t21, t283)),
                            t288,
                        ) - t305);
                let t307 = t167.mul_add(t306, t164 * t286);
                let t308 = t162.mul_add(t307, t153.mul_add(t306, t152 * t274));
                let t309 = t150
                    .mul_add(t308, t159.mul_add(t307, t149.mul_add(t306, t144 * t260)));
                let t310 = t309 + (t307 + t308);
                let t311 = t141.mul_add(t310, t140.mul_add(t306, t303));
                let t312 = cos_q5.mul_neg_add(t310, t73.mul_sub(t306, t259));
                let t313 = t150.mul_add(t271, t270);
                let t314 = t162.mul_add(t313, t159 * t271) + t270 - t285;
                let t315 = T::from_f64(0.13585)
                    .mul_neg_add(
                        t283,
                        t167
                            .mul_add(
                                t314,
                                t153.mul_add(t313, t149.mul_add(t271, t6 * t225)),
                            ),
                    );
                let t316 = t168 * (t315 - t305);
                let t317 = t167.mul_add(t316, t164 * t314);
                let t318 = t162.mul_add(t317, t153.mul_add(t316, t152 * t313));
                let t319 = t150
                    .mul_add(t318, t159.mul_add(t317, t149.mul_add(t316, t144 * t271)));
                let t320 = t319 + (t317 + t318);
                let t321 = t141.mul_add(t320, t140.mul_add(t316, t303));
                let t322 = cos_q5.mul_neg_add(t320, t73.mul_sub(t316, t259));
                let t323 = t150.mul_add(t273, t272);
                let t324 = t156
                    .mul_neg_add(
                        t265,
                        t134.mul_neg_add(t263, t162.mul_add(t323, t159 * t273) + t272),
                    );
                let t325 = T::from_f64(-0.01615)
                    .mul_add(t265, t167.mul_add(t324, t153.mul_add(t323, t149 * t273)))
                    + t302;
                let t326 = t168 * t134.mul_neg_add(t289, t325 - t304);
                let t327 = t167.mul_add(t326, t164 * t324);
                let t328 = t162.mul_add(t327, t153.mul_add(t326, t152 * t323));
                let t329 = t150
                    .mul_add(t328, t159.mul_add(t327, t149.mul_add(t326, t144 * t273)));
                let t330 = t329 + (t327 + t328);
                let t331 = t141.mul_add(t330, t140.mul_add(t326, t303));
                let t332 = cos_q5.mul_neg_add(t330, t73.mul_sub(t326, t259));
                let t333 = sin_q6 * t75;
                let t334 = cos_q6 * t75;
                let t335 = t169.mul_add(t334, t170 * t333);
                let t336 = T::from_f64(0.016911)
                    .mul_neg_add(
                        t210 + t335,
                        T::from_f64(0.000225473145) * (t335 - t210),
                    );
                let t337 = T::from_f64(0.10971).mul_neg_add(t211, t336);
                let t338 = T::from_f64(0.016911)
                    * t74.mul_neg_add(t170, t334.mul_add(t94, sin_q6 * t220));
                let t339 = T::from_f64(0.000225473145)
                    * cos_q6.mul_neg_add(t220, t74.mul_neg_add(t169, t333 * t94));
                let t340 = cos_q6
                    .mul_neg_add(
                        t339,
                        T::from_f64(0.126621).mul_neg_add(t222, sin_q6 * t338),
                    );
                let t341 = T::from_f64(-0.016911)
                    .mul_add(
                        t74.mul_neg_add(t74, t75 * t75),
                        sin_q6.mul_add(t339, cos_q6 * t338),
                    );
                let t342 = cos_q5.mul_add(t337 - t336, t141.mul_add(t341, sin_q5 * t340))
                    - t300;
                let t343 = T::from_f64(0.016911) * sin_q6.mul_neg_add(t94, t333);
                let t344 = T::from_f64(0.000225473145) * cos_q6.mul_sub(t94, t334);
                let t345 = t150.mul_add(t342, t342);
                let t346 = t162.mul_add(t345, t159.mul_add(t342, t342));
                let t347 = t341
                    .mul_add(
                        t195,
                        t167
                            .mul_add(
                                t346,
                                t153.mul_add(t345, t149.mul_add(t342, t73 * t336)),
                            ),
                    );
                let t348 = t168
                    * sin2
                        .mul_neg_add(
                            sin_q5.mul_add(t299 + t337, cos_q5 * (t223 - t340)),
                            t347,
                        );
                let t349 = t167.mul_add(t348, t164 * t346);
                let t350 = t162.mul_add(t349, t153.mul_add(t348, t152 * t345));
                let t351 = t150
                    .mul_add(t350, t159.mul_add(t349, t149.mul_add(t348, t144 * t342)));
                let t352 = t351 + (t349 + t350);
                let t353 = t141.mul_add(t352, t140.mul_add(t348, t139 * t341));
                let t354 = cos_q5
                    .mul_neg_add(
                        t352,
                        T::from_f64(58.35506475215265).mul_neg_add(t336, t73 * t348),
                    );
                let t355 = T::from_f64(-0.016685526855)
                    * t169.mul_neg_add(t169, t170 * t170);
                let t356 = cos_q5 * t355;
                let t357 = t141.mul_add(t298, sin_q5.mul_add(t297, t356)) - t356;
                let t358 = t150.mul_add(t357, t357);
                let t359 = t162.mul_add(t358, t159.mul_add(t357, t357));
                let t360 = t298
                    .mul_add(
                        t195,
                        t167
                            .mul_add(
                                t359,
                                t153.mul_add(t358, t149.mul_add(t357, t73 * t355)),
                            ),
                    );
                let t361 = t168
                    * sin2.mul_neg_add(cos_q5.mul_neg_add(t297, sin_q5 * t355), t360);
                let t362 = t167.mul_add(t361, t164 * t359);
                let t363 = t162.mul_add(t362, t153.mul_add(t361, t152 * t358));
                let t364 = t150
                    .mul_add(t363, t159.mul_add(t362, t149.mul_add(t361, t144 * t357)));
                let t365 = t364 + (t362 + t363);
                let t366 = t141.mul_add(t365, t140.mul_add(t361, t139 * t298));
                let t367 = cos_q5
                    .mul_neg_add(
                        t365,
                        T::from_f64(58.35506475215265).mul_neg_add(t355, t73 * t361),
                    );
                let t368 = cos2.mul_neg_add(cos_q6, sin_q6 * t99);
                let t369 = cos_q6.mul_add(t99, cos2 * sin_q6);
                let t370 = t169.mul_add(t369, t170 * t368);
                let t371 = T::from_f64(0.016911)
                    .mul_neg_add(
                        t370 + t100,
                        T::from_f64(0.000225473145) * (t370 - t100),
                    );
                let t372 = T::from_f64(0.016911)
                    * t170
                        .mul_neg_add(
                            t66,
                            t369.mul_add(t94, sin_q6.mul_add(t101, cos_q6 * t54)),
                        );
                let t373 = T::from_f64(0.000225473145)
                    * cos_q6
                        .mul_neg_add(
                            t101,
                            t169.mul_neg_add(t66, t368.mul_add(t94, sin_q6 * t54)),
                        );
                let t374 = cos_q6
                    .mul_neg_add(
                        t373,
                        sin_q6
                            .mul_add(
                                t372,
                                T::from_f64(0.126621)
                                    * cos2.mul_neg_add(t75, t10.mul_neg_add(t66, t101)),
                            ),
                    );
                let t375 = T::from_f64(0.126621)
                    .mul_neg_add(
                        t103 - t54,
                        sin_q6
                            .mul_add(
                                t373,
                                cos_q6.mul_add(t372, T::from_f64(0.10971) * (t54 + t103)),
                            ),
                    );
                let t376 = T::from_f64(0.10971)
                    .mul_neg_add(cos2.mul_neg_add(t74, t10.mul_add(t99, t100)), t371);
                let t377 = cos_q6
                    .mul_neg_add(
                        t344,
                        sin_q6.mul_add(t343, T::from_f64(0.253242) * t75),
                    );
                let t378 = sin_q6.mul_add(t344, cos_q6 * t343);
                let t379 = t156 * t50;
                let t380 = T::from_f64(0.2394).mul_sub(qd_q1, t49) - t379;
                let t381 = t134 * t51;
                let t382 = cos_q5
                    .mul_add(
                        t376,
                        sin_q5.mul_add(t374, t8.mul_add(t63.mul_add(t51, t381), t53)),
                    );
                let t383 = t141.mul_neg_add(t375, cos_q5 * t371);
                let t384 = t70.mul_neg_add(t52, t68.mul_add(t381, t382) + t104) - t383;
                let t385 = t382 - t383;
                let t386 = t150.mul_add(t385, t384);
                let t387 = t153
                    .mul_add(
                        t386,
                        t149
                            .mul_add(
                                t385,
                                T::from_f64(0.1197)
                                    .mul_add(t102, t65.mul_add(t380, t73 * t371)),
                            ),
                    );
                let t388 = t121 * t51;
                let t389 = t156
                    .mul_neg_add(
                        t102,
                        t162.mul_add(t386, t159.mul_add(t385, t388)) + t384,
                    );
                let t390 = t121
                    .mul_neg_add(
                        t50,
                        t196
                            .mul_neg_add(
                                t49,
                                t375.mul_add(t195, t167.mul_add(t389, t387)),
                            ),
                    );
                let t391 = sin2
                    .mul_neg_add(
                        cos_q5.mul_neg_add(t374, sin_q5 * t376),
                        t5
                            .mul_neg_add(
                                t55,
                                t6.mul_neg_add(t380 - t105, t62.mul_neg_add(t33, t390)),
                            ),
                    );
                let t392 = t134 * t68.mul_add(t33, t56);
                let t393 = t168
                    * T::from_f64(0.13585)
                        .mul_neg_add(t196.mul_neg_add(t51, t102), t391 - t106 - t392);
                let t394 = t167.mul_add(t393, t164 * t389);
                let t395 = t162.mul_add(t394, t153.mul_add(t393, t152 * t386));
                let t396 = t150
                    .mul_add(t395, t159.mul_add(t394, t149.mul_add(t393, t144 * t385)));
                let t397 = t396 + (t394 + t395);
                let t398 = t141.mul_add(t397, t140.mul_add(t393, t139 * t375));
                let t399 = cos_q5
                    .mul_neg_add(
                        t397,
                        T::from_f64(58.35506475215265).mul_neg_add(t371, t73 * t393),
                    );
                let t400 = t156 * t51;
                let t401 = t156.mul_add(t113, t392);
                let t402 = t134 * t50;
                let t403 = cos_q6 * sin_q5;
                let t404 = T::from_f64(0.016911)
                    * t403
                        .mul_add(t94, sin_q6.mul_add(t109, cos_q5.mul_add(t170, t246)));
                let t405 = sin_q6 * sin_q5;
                let t406 = T::from_f64(0.000225473145)
                    * cos_q6
                        .mul_neg_add(
                            t109,
                            t405.mul_add(t94, cos_q5.mul_add(t169, t243)),
                        );
                let t407 = t169.mul_add(t403, t170 * t405);
                let t408 = T::from_f64(0.126621)
                    .mul_neg_add(
                        t111 - t11,
                        sin_q6
                            .mul_add(
                                t406,
                                cos_q6.mul_add(t404, T::from_f64(0.10971) * (t11 + t111)),
                            ),
                    );
                let t409 = cos_q6
                    .mul_neg_add(
                        t406,
                        sin_q6
                            .mul_add(
                                t404,
                                T::from_f64(0.126621) * cos_q5.mul_add(t10, t109),
                            ),
                    );
                let t410 = T::from_f64(0.016911)
                    .mul_neg_add(
                        t407 + t110,
                        T::from_f64(0.000225473145) * (t407 - t110),
                    );
                let t411 = T::from_f64(0.10971)
                    .mul_neg_add(sin_q5.mul_add(t10, t110), t410);
                let t412 = t27.mul_add(t55, t53)
                    + cos2.mul_add(t408, sin2 * cos_q5.mul_neg_add(t409, sin_q5 * t411));
                let t413 = cos_q5.mul_add(t411, sin_q5 * t409);
                let t414 = t412 - t140.mul_add(t408, t63.mul_neg_add(t58, t73 * t410));
                let t415 = t414 + t235;
                let t416 = t8.mul_add(t402 + t108, t6 * (t379 + t105)) + t413;
                let t417 = t8.mul_add(t108, t6.mul_add(t105, t413));
                let t418 = t141.mul_neg_add(t408, cos_q5 * t410);
                let t419 = t65.mul_neg_add(t379, t68.mul_add(t402, t416)) - t112 - t418;
                let t420 = t416 - t418;
                let t421 = t139 * t408;
                let t422 = T::from_f64(58.35506475215265) * t410;
                let t423 = t150.mul_add(t420, t419);
                let t424 = t162.mul_add(t423, t159 * t420) + t419 - t401;
                let t425 = t167
                    .mul_add(
                        t424,
                        t153.mul_add(t423, t149.mul_add(t420, t6 * (t400 + t107))),
                    );
                let t426 = T::from_f64(0.13585)
                    .mul_neg_add(
                        t196.mul_neg_add(t50, t113),
                        t65.mul_neg_add(t400, t174.mul_neg_add(t50, t425 - t388)),
                    );
                let t427 = t168 * (t426 - t415);
                let t428 = t167.mul_add(t427, t164 * t424);
                let t429 = t162.mul_add(t428, t153.mul_add(t427, t152 * t423));
                let t430 = t150
                    .mul_add(t429, t159.mul_add(t428, t149.mul_add(t427, t144 * t420)));
                let t431 = t430 + (t428 + t429);
                let t432 = t141.mul_add(t431, t140.mul_add(t427, t421));
                let t433 = cos_q5.mul_neg_add(t431, t73.mul_sub(t427, t422));
                let t434 = t417 - t418;
                let t435 = t417 - t112 - t418;
                let t436 = t413 - t112 - t418;
                let t437 = t413 - t418;
                let t438 = t150.mul_add(t434, t435);
                let t439 = t162.mul_add(t438, t159 * t434) + t435 - t401;
                let t440 = T::from_f64(0.13585)
                    .mul_neg_add(
                        t113,
                        t167
                            .mul_add(
                                t439,
                                t153.mul_add(t438, t149.mul_add(t434, t6 * t107)),
                            ),
                    );
                let t441 = t168 * (t440 - t415);
                let t442 = t167.mul_add(t441, t164 * t439);
                let t443 = t162.mul_add(t442, t153.mul_add(t441, t152 * t438));
                let t444 = t150
                    .mul_add(t443, t159.mul_add(t442, t149.mul_add(t441, t144 * t434)));
                let t445 = t444 + (t442 + t443);
                let t446 = t141.mul_add(t445, t140.mul_add(t441, t421));
                let t447 = cos_q5.mul_neg_add(t445, t73.mul_sub(t441, t422));
                let t448 = t150.mul_add(t437, t436);
                let t449 = t156
                    .mul_neg_add(
                        t57,
                        t134.mul_neg_add(t56, t162.mul_add(t448, t159 * t437) + t436),
                    );
                let t450 = t134
                    .mul_neg_add(
                        t58,
                        T::from_f64(-0.01615)
                            .mul_add(
                                t57,
                                t167.mul_add(t449, t153.mul_add(t448, t149 * t437)),
                            ),
                    );
                let t451 = t168 * (t450 - t414);
                let t452 = t167.mul_add(t451, t164 * t449);
                let t453 = t162.mul_add(t452, t153.mul_add(t451, t152 * t448));
                let t454 = t150
                    .mul_add(t453, t159.mul_add(t452, t149.mul_add(t451, t144 * t437)));
                let t455 = t454 + (t452 + t453);
                let t456 = t141.mul_add(t455, t140.mul_add(t451, t421));
                let t457 = cos_q5.mul_neg_add(t455, t73.mul_sub(t451, t422));
                let t458 = sin_q6.mul_neg_add(t169, cos_q6 * t170);
                let t459 = T::from_f64(0.016911)
                    .mul_neg_add(t74 + t458, T::from_f64(0.000225473145) * (t458 - t74));
                let t460 = T::from_f64(0.21942).mul_neg_add(t74, t459);
                let t461 = T::from_f64(0.033822) * t170;
                let t462 = T::from_f64(0.00045094629) * t169;
                let t463 = cos_q5
                    .mul_add(t460 - t459, t141.mul_add(t378, sin_q5 * t377));
                let t464 = t150.mul_add(t463, t463);
                let t465 = t162.mul_add(t464, t159.mul_add(t463, t463));
                let t466 = t378
                    .mul_add(
                        t195,
                        t167
                            .mul_add(
                                t465,
                                t153.mul_add(t464, t149.mul_add(t463, t73 * t459)),
                            ),
                    );
                let t467 = t168
                    * sin2.mul_neg_add(cos_q5.mul_neg_add(t377, sin_q5 * t460), t466);
                let t468 = t167.mul_add(t467, t164 * t465);
                let t469 = t162.mul_add(t468, t153.mul_add(t467, t152 * t464));
                let t470 = t150
                    .mul_add(t469, t159.mul_add(t468, t149.mul_add(t467, t144 * t463)));
                let t471 = t470 + (t468 + t469);
                let t472 = t141.mul_add(t471, t140.mul_add(t467, t139 * t378));
                let t473 = cos_q5
                    .mul_neg_add(
                        t471,
                        T::from_f64(58.35506475215265).mul_neg_add(t459, t73 * t467),
                    );
                let t474 = cos_q6.mul_neg_add(t462, sin_q6 * t461);
                let t475 = sin_q6.mul_add(t462, cos_q6 * t461);
                let t476 = t141.mul_add(t475, sin_q5 * t474);
                let t477 = t150.mul_add(t476, t476);
                let t478 = t162.mul_add(t477, t159.mul_add(t476, t476));
                let t479 = t475
                    .mul_add(
                        t195,
                        t167
                            .mul_add(
                                t478,
                                t153.mul_add(t477, t149.mul_add(t476, t99 * t474)),
                            ),
                    );
                let t480 = t168 * t479;
                let t481 = t167.mul_add(t480, t164 * t478);
                let t482 = t162.mul_add(t481, t153.mul_add(t480, t152 * t477));
                let t483 = t150
                    .mul_add(t482, t159.mul_add(t481, t149.mul_add(t480, t144 * t476)));
                let t484 = t483 + (t481 + t482);
                let t485 = cos_q5.mul_neg_add(t484, t73 * t480);
                let t486 = t141.mul_add(t484, t140.mul_add(t480, t139 * t475));
                (
                    t306,
                    t307,
                    t308,
                    t309,
                    t311,
                    t312,
                    t316,
                    t317,
                    t318,
                    t319,
                    t321,
                    t322,
                    t326,
                    t327,
                    t328,
                    t329,
                    t331,
                    t332,
                    t348,
                    t349,
                    t350,
                    t351,
                    t353,
                    t354,
                    t361,
                    t362,
                    t363,
                    t364,
                    t366,
                    t367,
                    t393,
                    t394,
                    t395,
                    t396,
                    t398,
                    t399,
                    t427,
                    t428,
                    t429,
                    t430,
                    t432,
                    t433,
                    t441,
                    t442,
                    t443,
                    t444,
                    t446,
                    t447,
                    t451,
                    t452,
                    t453,
                    t454,
                    t456,
                    t457,
                    t467,
                    t468,
                    t469,
                    t470,
                    t472,
                    t473,
                    t480,
                    t481,
                    t482,
                    t483,
                    t485,
                    t486,
                )
            };
            (
                ::pendulum_core::nalgebra::SVector::from([
                    qd_q1,
                    qd_q2,
                    qd_q3,
                    qd_q4,
                    qd_q5,
                    qd_q6,
                    t200,
                    t201,
                    t202,
                    t203,
                    t206,
                    t219,
                ]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                    ],
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t306,
                        t307,
                        t308,
                        t309,
                        t311,
                        t312,
                    ],
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t316,
                        t317,
                        t318,
                        t319,
                        t321,
                        t322,
                    ],
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t326,
                        t327,
                        t328,
                        t329,
                        t331,
                        t332,
                    ],
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t348,
                        t349,
                        t350,
                        t351,
                        t353,
                        t354,
                    ],
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t361,
                        t362,
                        t363,
                        t364,
                        t366,
                        t367,
                    ],
                    [
                        T::from_f64(1.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t393,
                        t394,
                        t395,
                        t396,
                        t398,
                        t399,
                    ],
                    [
                        T::from_f64(0.0),
                        T::from_f64(1.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t427,
                        t428,
                        t429,
                        t430,
                        t432,
                        t433,
                    ],
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(1.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t441,
                        t442,
                        t443,
                        t444,
                        t446,
                        t447,
                    ],
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(1.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t451,
                        t452,
                        t453,
                        t454,
                        t456,
                        t457,
                    ],
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(1.0),
                        T::from_f64(0.0),
                        t467,
                        t468,
                        t469,
                        t470,
                        t472,
                        t473,
                    ],
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(1.0),
                        t480,
                        t481,
                        t482,
                        t483,
                        t486,
                        t485,
                    ],
                ]),
            )
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Jacobian<T, 12> for Ur5<T> {
        #[inline]
        fn jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 12>,
        ) -> ::pendulum_core::nalgebra::SMatrix<T, 12, 12> {
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
            x: &::pendulum_core::nalgebra::SVector<T, 12>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 12>,
            ::pendulum_core::nalgebra::SMatrix<T, 12, 12>,
        ) {
            T::apart(__Code { t, x }, &mut (), self)
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn time_derivative(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 12>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 12> {
            ::pendulum_core::nalgebra::SVector::from([
                T::from_f64(0.0),
                T::from_f64(0.0),
                T::from_f64(0.0),
                T::from_f64(0.0),
                T::from_f64(0.0),
                T::from_f64(0.0),
                T::from_f64(0.0),
                T::from_f64(0.0),
                T::from_f64(0.0),
                T::from_f64(0.0),
                T::from_f64(0.0),
                T::from_f64(0.0),
            ])
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Energy<T, 12> for Ur5<T> {
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn kinetic(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 12>) -> T {
            let [_, q_q2, q_q3, q_q4, q_q5, q_q6, qd_q1, qd_q2, qd_q3, qd_q4, qd_q5,
            qd_q6] = x.data.0[0];
            let t0 = T::from_f64(0.017136473145) * qd_q6;
            let t1 = qd_q4 + qd_q3 + qd_q2;
            let (sin_q4, cos_q4) = q_q4.sin_cos();
            let t2 = T::from_f64(0.00697606230375) * sin_q4;
            let [(sin_q6, cos_q6), (sin_q2, cos_q2)] = q_q6.sin_cos_pair(q_q2);
            let t3 = (qd_q5 * qd_q5)
                .mul_add(
                    (T::from_f64(0.0083427634275) * sin_q6)
                        .mul_neg_add(sin_q6, T::from_f64(0.126621)),
                    T::from_f64(0.0085682365725) * qd_q6 * qd_q6,
                );
            let t4 = sin_q6 * qd_q1;
            let [(sin_q5, cos_q5), (sin_q3, cos_q3)] = q_q5.sin_cos_pair(q_q3);
            let t5 = sin_q6 * sin_q5;
            let t6 = T::from_f64(0.016685526855) * t5;
            let t7 = (qd_q5 * cos_q6).mul_add(t6, cos_q5 * t0);
            let t8 = t5 * t6;
            let t9 = T::from_f64(0.0083427634275) * t5 * t5;
            let t10 = T::from_f64(0.24116530937475) + t8 - t2;
            let t11 = t9 - t2;
            let t12 = qd_q3
                .mul_add(
                    qd_q3
                        .mul_add(
                            T::from_f64(0.41840863052475) + t11,
                            qd_q4.mul_add(t10, t7),
                        ),
                    qd_q4
                        .mul_add(
                            qd_q4.mul_add(T::from_f64(0.120582654687375) + t9, t7),
                            t3,
                        ),
                );
            let t13 = sin_q4.mul_add(cos_q3, sin_q3 * cos_q4);
            let t14 = T::from_f64(0.007558512375) * t13;
            let t15 = T::from_f64(0.679472691875).mul_neg_add(cos_q3, t14);
            let t16 = qd_q3
                .mul_add(
                    T::from_f64(0.0139521246075)
                        .mul_neg_add(sin_q4, T::from_f64(0.8368172610495) + t8) - t15,
                    qd_q4.mul_add(t10 - t14, t7),
                );
            let t17 = sin_q4.mul_neg_add(sin_q3, cos_q4 * cos_q3);
            let t18 = sin_q3.mul_add(cos_q2, cos_q3 * sin_q2);
            let t19 = T::from_f64(0.07714261911625) * t18;
            let t20 = t13.mul_neg_add(sin_q2, cos_q2 * t17);
            let t21 = t13.mul_add(cos_q2, sin_q2 * t17);
            let t22 = T::from_f64(0.253242)
                .mul_neg_add(qd_q5, T::from_f64(0.00194120382525) * t1)
                .mul_add(
                    t20,
                    qd_q3
                        .mul_add(
                            t19,
                            qd_q2 * T::from_f64(0.408499208875).mul_add(sin_q2, t19),
                        ),
                );
            let t23 = cos_q5
                .mul_add(
                    cos_q6.mul_add(qd_q1.mul_neg_add(t20, qd_q5), t1 * t5),
                    t21 * t4,
                );
            let t24 = T::from_f64(0.016685526855)
                * t21
                    .mul_add(
                        t23,
                        t20 * (cos_q6 * sin_q5).mul_neg_add(t1, qd_q5 * sin_q6),
                    );
            let t25 = sin_q3.mul_neg_add(sin_q2, cos_q3 * cos_q2);
            let t26 = sin_q5 * t21;
            let t27 = (T::from_f64(0.295778475837375) * t18)
                .mul_neg_add(
                    t18,
                    (T::from_f64(0.877509769205) * sin_q2)
                        .mul_neg_add(
                            sin_q2,
                            (T::from_f64(0.679472691875) * cos_q2)
                                .mul_add(t25, T::from_f64(1.50883415126375)),
                        ),
                );
            let t28 = qd_q1
                * t21
                    .mul_neg_add(
                        T::from_f64(0.115748345312625)
                            .mul_add(
                                t21,
                                T::from_f64(0.00697606230375)
                                    .mul_add(t25, T::from_f64(0.007558512375) * cos_q2),
                            ),
                        t27,
                    );
            let t29 = sin_q6
                .mul_add(
                    (T::from_f64(0.0083427634275) * t26)
                        .mul_add(t26, T::from_f64(0.0083427634275))
                        .mul_neg_add(t4, t24),
                    t22 + t28,
                );
            qd_q1
                .mul_add(
                    t0.mul_neg_add(t26, t29),
                    qd_q2
                        .mul_add(
                            qd_q2
                                .mul_add(T::from_f64(1.30347209972975) + t11 - t15, t16),
                            t12,
                        ),
                )
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn potential(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 12>) -> T {
            let [_, q_q2, q_q3, q_q4, _, _, _, _, _, _, _, _] = x.data.0[0];
            let t0 = q_q2 + q_q3;
            let (_, cos1) = (q_q4 + t0).sin_cos();
            let [(sin_q2, _), (sin2, _)] = q_q2.sin_cos_pair(t0);
            T::from_f64(0.17446825035)
                .mul_neg_add(
                    cos1,
                    T::from_f64(15.68382848775)
                        .mul_neg_add(
                            sin2,
                            T::from_f64(43.486969725)
                                .mul_neg_add(sin_q2, T::from_f64(14.863711066281)),
                        ),
                )
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> Ur5<T> {
        ///The mass matrix.
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        pub fn mass_matrix(
            &self,
            t: T,
            x: &(impl ::pendulum_core::IntoState<T, 12> + Copy),
        ) -> ::pendulum_core::nalgebra::SMatrix<T, 6, 6> {
            let x = ::pendulum_core::IntoState::into_state(*x);
            let [_, q_q2, q_q3, q_q4, q_q5, q_q6, _, _, _, _, _, _] = x.data.0[0];
            let (sin_q6, cos_q6) = q_q6.sin_cos();
            let t0 = sin_q6 * sin_q6;
            let t1 = sin_q6 * cos_q6;
            let t2 = T::from_f64(0.016685526855) * t0;
            let t3 = T::from_f64(0.253242) - t2;
            let [(sin_q2, cos_q2), (sin_q3, cos_q3)] = q_q2.sin_cos_pair(q_q3);
            let t4 = sin_q2.mul_neg_add(sin_q3, cos_q2 * cos_q3);
            let t5 = cos_q2.mul_add(sin_q3, sin_q2 * cos_q3);
            let [(sin_q4, cos_q4), (sin_q5, cos_q5)] = q_q4.sin_cos_pair(q_q5);
            let t6 = sin_q3.mul_neg_add(sin_q4, cos_q3 * cos_q4);
            let t7 = cos_q3.mul_add(sin_q4, sin_q3 * cos_q4);
            let t8 = cos_q2.mul_add(t7, sin_q2 * t6);
            let t9 = sin_q2.mul_neg_add(t7, cos_q2 * t6);
            let t10 = -(T::from_f64(0.017136473145) * t8 * sin_q5);
            let t11 = T::from_f64(0.016685526855) * sin_q5;
            let t12 = sin_q5 * t11;
            let t13 = t11 * t1;
            let t14 = T::from_f64(0.0139521246075)
                .mul_neg_add(
                    t4,
                    T::from_f64(0.01511702475)
                        .mul_neg_add(
                            cos_q2,
                            t8
                                * (T::from_f64(0.03337105371) - t12)
                                    .mul_sub(t0, T::from_f64(0.23149669062525)),
                        ),
                );
            let t15 = t8
                .mul_add(
                    (T::from_f64(0.03337105371) * cos_q5 * t9).mul_neg_add(t1, t14),
                    (T::from_f64(1.35894538375) * cos_q2)
                        .mul_add(t4, T::from_f64(3.0176683025275)),
                );
            let t16 = (T::from_f64(0.59155695167475) * t5)
                .mul_neg_add(
                    t5,
                    (T::from_f64(1.75501953841) * sin_q2).mul_neg_add(sin_q2, t15),
                ) - t2;
            let t17 = cos_q5 * (T::from_f64(0.016685526855) * t8);
            let t18 = t9.mul_add(t2 - T::from_f64(0.253242), t1 * t17);
            let t19 = t9.mul_add(T::from_f64(0.00194120382525) - t13, sin_q5 * t0 * t17);
            let t20 = T::from_f64(0.07714261911625).mul_add(t5, t19);
            let t21 = T::from_f64(0.408499208875).mul_add(sin_q2, t20);
            let t22 = t12 * t0;
            let t23 = T::from_f64(0.0139521246075) * sin_q4;
            let t24 = T::from_f64(0.01511702475)
                .mul_neg_add(
                    t7,
                    T::from_f64(1.35894538375)
                        .mul_add(cos_q3, T::from_f64(2.6069441994595)) + t22,
                ) - t23;
            let t25 = T::from_f64(0.007558512375) * t7;
            let t26 = T::from_f64(0.8368172610495) + t22;
            let t27 = T::from_f64(0.679472691875).mul_sub(cos_q3, t25) - (t23 - t26);
            let t28 = t26 - t23;
            let t29 = T::from_f64(0.24116530937475) + t22;
            let t30 = T::from_f64(0.00697606230375).mul_neg_add(sin_q4, t29);
            let t31 = T::from_f64(0.017136473145) * cos_q5;
            let t32 = t30 - t25;
            let a0 = t16;
            let a1 = t21;
            let a2 = t20;
            let a3 = t19;
            let a4 = t18;
            let a5 = t10;
            let a6 = t24;
            let a7 = t27;
            let a8 = t32;
            let a9 = t13;
            let a10 = t31;
            let a11 = t28;
            let a12 = t30;
            let a13 = t13;
            let a14 = t31;
            let a15 = t29;
            let a16 = t13;
            let a17 = t31;
            let a18 = t3;
            let a19 = T::from_f64(0.0);
            let a20 = T::from_f64(0.017136473145);
            ::pendulum_core::nalgebra::SMatrix::from([
                [a0, a1, a2, a3, a4, a5],
                [a1, a6, a7, a8, a9, a10],
                [a2, a7, a11, a12, a13, a14],
                [a3, a8, a12, a15, a16, a17],
                [a4, a9, a13, a16, a18, a19],
                [a5, a10, a14, a17, a19, a20],
            ])
        }
        ///The bias: velocity terms, gravity and the inertia forces of the drives, as generalised forces.
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        pub fn bias(
            &self,
            t: T,
            x: &(impl ::pendulum_core::IntoState<T, 12> + Copy),
        ) -> ::pendulum_core::nalgebra::SVector<T, 6> {
            struct __Code<'a, T, __X0> {
                t: T,
                x: &'a __X0,
            }
            #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
            impl<
                T: ::pendulum_core::real::Real,
                __X0: ::pendulum_core::IntoState<T, 12> + ::core::marker::Copy,
            > ::pendulum_core::real::lanes::Routine<(), Ur5<T>> for __Code<'_, T, __X0> {
                type Output = ::pendulum_core::nalgebra::SVector<T, 6>;
                #[cfg_attr(debug_assertions, inline)]
                #[cfg_attr(not(debug_assertions), inline(always))]
                fn run(
                    self,
                    (): &mut (),
                    model: &Ur5<T>,
                ) -> ::pendulum_core::nalgebra::SVector<T, 6> {
                    let Self { t, x } = self;
                    let x = ::pendulum_core::IntoState::into_state(*x);
                    let [_, q_q2, q_q3, q_q4, q_q5, q_q6, qd_q1, qd_q2, qd_q3, qd_q4,
                    qd_q5, qd_q6] = x.data.0[0];
                    let t0 = q_q2 + q_q3;
                    let t1 = t0 + q_q4;
                    let t2 = qd_q1 * qd_q1;
                    let t3 = qd_q2 + qd_q3;
                    let t4 = t3 + qd_q4;
                    let t5 = t4 * t4;
                    let t6 = t2 + t5;
                    let t7 = t3 * t3;
                    let t8 = qd_q1 * t3;
                    let t9 = t2 + t7;
                    let t10 = T::from_f64(0.13585) * t2;
                    let t11 = qd_q1 * qd_q2;
                    let t12 = T::from_f64(2.0) * t11;
                    let t13 = qd_q1.mul_add(qd_q3, t11);
                    let t14 = t13 + t8;
                    let t15 = qd_q1.mul_add(qd_q4, t13);
                    let t16 = qd_q1 * t4;
                    let t17 = t15 + t16;
                    let t18 = qd_q2 * qd_q2;
                    let t19 = t2 + t18;
                    let (sin_q6, cos_q6) = q_q6.sin_cos();
                    let [(sin20, cos20), (sin_q2, cos_q2)] = t1.sin_cos_pair(q_q2);
                    let t21 = T::from_f64(0.017784735) * sin20;
                    let t22 = t21 * t6;
                    let t23 = T::from_f64(4.4329225) * cos_q2;
                    let t24 = T::from_f64(1.75501953841) * cos_q2 * sin_q2;
                    let t25 = T::from_f64(0.425) * sin_q2;
                    let t26 = t12.mul_neg_add(t25, T::from_f64(0.1197).mul_sub(t2, t10));
                    let t27 = t18.mul_neg_add(t25, T::from_f64(-9.81));
                    let t28 = T::from_f64(0.10510116377025) * sin20 * cos20;
                    let t29 = qd_q1.mul_neg_add(cos20, qd_q5);
                    let t30 = qd_q1 * sin20;
                    let t31 = cos20 * t15;
                    let t32 = sin20 * t15;
                    let t33 = T::from_f64(0.017784735) * cos20;
                    let t34 = t17 * t33;
                    let t35 = T::from_f64(0.425) * cos_q2;
                    let t36 = T::from_f64(0.001653980355) * sin20;
                    let t37 = t19 * t35;
                    let t38 = t5 * t33;
                    let [(sin39, cos39), (sin_q5, cos_q5)] = t0.sin_cos_pair(q_q5);
                    let t40 = T::from_f64(1.598759275) * cos39;
                    let t41 = t9.mul_neg_add(t40, t22);
                    let t42 = T::from_f64(0.59155695167475) * sin39 * cos39;
                    let t43 = T::from_f64(0.051322656825) * cos39;
                    let t44 = t43
                        .mul_add(t2 - t9, t42.mul_add(t14, t12.mul_add(t24, t23 * t10)));
                    let t45 = T::from_f64(0.39225) * sin39;
                    let t46 = t4.mul_add(sin_q5, cos_q5 * t30);
                    let t47 = sin_q5.mul_neg_add(t30, t4 * cos_q5);
                    let t48 = sin_q6.mul_add(t46, cos_q6 * t29);
                    let t49 = t29.mul_neg_add(sin_q6, cos_q6 * t46);
                    let t50 = t48 * t49;
                    let t51 = qd_q5.mul_add(t46, sin_q5 * t31);
                    let t52 = T::from_f64(0.016911)
                        .mul_neg_add(
                            t50 + t51,
                            T::from_f64(0.000225473145) * (t50 - t51),
                        );
                    let t53 = T::from_f64(0.10971)
                        .mul_neg_add(t29.mul_add(t46, t51), t52);
                    let t54 = qd_q5.mul_add(t47, cos_q5 * t31);
                    let t55 = t46 * t47;
                    let t56 = qd_q6 + (t47 + qd_q6);
                    let t57 = T::from_f64(0.016911)
                        * t49.mul_add(t56, sin_q6.mul_add(t54, cos_q6 * t32));
                    let t58 = T::from_f64(0.000225473145)
                        * cos_q6.mul_neg_add(t54, t48.mul_add(t56, sin_q6 * t32));
                    let t59 = cos_q6
                        .mul_neg_add(
                            t58,
                            sin_q6
                                .mul_add(t57, T::from_f64(0.126621) * t29.mul_add(t47, t54)),
                        );
                    let t60 = T::from_f64(0.126621)
                        .mul_neg_add(
                            t55 - t32,
                            sin_q6
                                .mul_add(
                                    t58,
                                    cos_q6.mul_add(t57, T::from_f64(0.10971) * (t32 + t55)),
                                ),
                        );
                    let t61 = sin20
                        .mul_add(
                            cos_q5.mul_neg_add(t59, sin_q5 * t53),
                            t28.mul_add(t17, t21.mul_add(t14.mul_neg_add(t45, t26), t44)),
                        );
                    let t62 = T::from_f64(0.39225) * cos39;
                    let t63 = sin_q5
                        .mul_add(t59, t28.mul_add(t6 - t5, t33 * t9.mul_add(t62, t37)));
                    let t64 = t36
                        .mul_neg_add(
                            t15 - t16,
                            t21
                                .mul_neg_add(
                                    t7.mul_neg_add(t45, t27),
                                    cos_q5.mul_add(t53, t63),
                                ),
                        );
                    let t65 = T::from_f64(1.598759275) * sin39;
                    let t66 = t42
                        .mul_add(
                            t9 - t7,
                            t43.mul_add(t13 - t8, t65.mul_add(t37, t40 * t27)),
                        );
                    let t67 = t35
                        .mul_add(
                            t14.mul_add(t65, t34),
                            t62.mul_add(t34, cos20.mul_add(t60, t61)),
                        );
                    let t68 = t45.mul_neg_add(t22, t62.mul_neg_add(t38, t66 + t64));
                    let t69 = t35
                        .mul_neg_add(
                            t7.mul_add(t65, t38),
                            T::from_f64(43.486969725)
                                .mul_neg_add(cos_q2, t24.mul_add(t19 - t18, t68)),
                        );
                    let t70 = (T::from_f64(0.19371331275) * cos_q2)
                        .mul_neg_add(
                            t2 - t19,
                            T::from_f64(0.13585).mul_add(t23.mul_neg_add(t19, t41), t67),
                        );
                    ::pendulum_core::nalgebra::SVector::from([
                        T::from_f64(0.1197)
                            .mul_sub(
                                t41,
                                t36.mul_neg_add(t2 - t6, t40.mul_neg_add(t26, t70)),
                            ),
                        t25.mul_neg_add(t41, t69),
                        t68,
                        t64,
                        t60,
                        t52,
                    ])
                }
            }
            T::apart(__Code { t, x }, &mut (), self)
        }
        ///The momenta of the coordinates: the mass matrix times their rates.
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        pub fn momentum(
            &self,
            t: T,
            x: &(impl ::pendulum_core::IntoState<T, 12> + Copy),
        ) -> ::pendulum_core::nalgebra::SVector<T, 6> {
            struct __Code<'a, T, __X0> {
                t: T,
                x: &'a __X0,
            }
            #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
            impl<
                T: ::pendulum_core::real::Real,
                __X0: ::pendulum_core::IntoState<T, 12> + ::core::marker::Copy,
            > ::pendulum_core::real::lanes::Routine<(), Ur5<T>> for __Code<'_, T, __X0> {
                type Output = ::pendulum_core::nalgebra::SVector<T, 6>;
                #[cfg_attr(debug_assertions, inline)]
                #[cfg_attr(not(debug_assertions), inline(always))]
                fn run(
                    self,
                    (): &mut (),
                    model: &Ur5<T>,
                ) -> ::pendulum_core::nalgebra::SVector<T, 6> {
                    let Self { t, x } = self;
                    let x = ::pendulum_core::IntoState::into_state(*x);
                    let [_, q_q2, q_q3, q_q4, q_q5, q_q6, qd_q1, qd_q2, qd_q3, qd_q4,
                    qd_q5, qd_q6] = x.data.0[0];
                    let t0 = qd_q2 + qd_q3 + qd_q4;
                    let t1 = T::from_f64(0.017136473145) * qd_q6;
                    let (sin_q6, cos_q6) = q_q6.sin_cos();
                    let t2 = T::from_f64(0.016685526855) * sin_q6;
                    let [(sin_q2, cos_q2), (sin_q3, cos_q3)] = q_q2.sin_cos_pair(q_q3);
                    let t3 = cos_q2.mul_add(sin_q3, sin_q2 * cos_q3);
                    let t4 = T::from_f64(0.07714261911625) * t3;
                    let t5 = T::from_f64(0.408499208875).mul_add(sin_q2, t4);
                    let t6 = sin_q2.mul_neg_add(sin_q3, cos_q3 * cos_q2);
                    let t7 = (T::from_f64(0.59155695167475) * t3)
                        .mul_neg_add(
                            t3,
                            (T::from_f64(1.75501953841) * sin_q2)
                                .mul_neg_add(
                                    sin_q2,
                                    (T::from_f64(1.35894538375) * cos_q2)
                                        .mul_add(t6, T::from_f64(3.0176683025275)),
                                ),
                        );
                    let [(sin_q4, cos_q4), (sin_q5, cos_q5)] = q_q4.sin_cos_pair(q_q5);
                    let t8 = sin_q3.mul_neg_add(sin_q4, cos_q3 * cos_q4);
                    let t9 = cos_q3.mul_add(sin_q4, sin_q3 * cos_q4);
                    let t10 = sin_q2.mul_neg_add(t9, cos_q2 * t8);
                    let t11 = cos_q2.mul_add(t9, sin_q2 * t8);
                    let t12 = qd_q1
                        * t11
                            .mul_neg_add(
                                T::from_f64(0.23149669062525)
                                    .mul_add(
                                        t11,
                                        T::from_f64(0.0139521246075)
                                            .mul_add(t6, T::from_f64(0.01511702475) * cos_q2),
                                    ),
                                t7,
                            );
                    let t13 = T::from_f64(0.253242)
                        .mul_neg_add(qd_q5, T::from_f64(0.00194120382525) * t0)
                        .mul_add(t10, t4.mul_add(qd_q3, qd_q2 * t5));
                    let t14 = t11 * sin_q6;
                    let t15 = t10 * cos_q6;
                    let t16 = t11 * qd_q1;
                    let t17 = sin_q5.mul_neg_add(t16, t0 * cos_q5);
                    let t18 = sin_q5
                        .mul_add(
                            t0.mul_neg_add(t15, t14 * t17),
                            qd_q5 * (t11 * cos_q6).mul_add(cos_q5, t10 * sin_q6),
                        );
                    let t19 = T::from_f64(0.016685526855)
                        .mul_add(
                            qd_q1.mul_neg_add(sin_q6, t18),
                            T::from_f64(0.03337105371) * cos_q5.mul_neg_add(t15, t14)
                                * t16,
                        );
                    let t20 = cos_q5.mul_add(t16, sin_q5 * t0);
                    let t21 = T::from_f64(0.00697606230375)
                        .mul_neg_add(sin_q4, T::from_f64(0.24116530937475));
                    let t22 = T::from_f64(0.007558512375) * t9;
                    let t23 = t21 - t22;
                    let t24 = T::from_f64(0.00194120382525) * t10;
                    let t25 = t10.mul_neg_add(qd_q1, qd_q5);
                    let t26 = (sin_q5 * cos_q6.mul_add(t25, sin_q6 * t20))
                        .mul_add(t2, t1 * cos_q5);
                    let t27 = T::from_f64(0.0139521246075) * sin_q4;
                    let t28 = T::from_f64(0.8368172610495) - t27;
                    let t29 = T::from_f64(0.679472691875).mul_add(cos_q3, t28) - t22;
                    let t30 = qd_q2
                        .mul_add(
                            T::from_f64(0.01511702475)
                                .mul_neg_add(
                                    t9,
                                    T::from_f64(1.35894538375)
                                        .mul_add(cos_q3, T::from_f64(2.6069441994595)) - t27,
                                ),
                            qd_q3.mul_add(t29, qd_q1.mul_add(t5 + t24, qd_q4 * t23)),
                        );
                    let t31 = qd_q2
                        .mul_add(
                            t29,
                            qd_q1.mul_add(t4 + t24, qd_q3.mul_add(t28, qd_q4 * t21)),
                        );
                    ::pendulum_core::nalgebra::SVector::from([
                        (sin_q5 * t1).mul_neg_add(t11, sin_q6.mul_add(t19, t13 + t12)),
                        t30 + t26,
                        t31 + t26,
                        qd_q2
                            .mul_add(
                                t23,
                                qd_q1
                                    .mul_add(
                                        t24,
                                        T::from_f64(0.24116530937475).mul_add(qd_q4, qd_q3 * t21),
                                    ),
                            ) + t26,
                        sin_q6
                            .mul_neg_add(t25, cos_q6 * t20)
                            .mul_add(t2, T::from_f64(0.253242) * t25),
                        T::from_f64(0.017136473145) * (qd_q6 + t17),
                    ])
                }
            }
            T::apart(__Code { t, x }, &mut (), self)
        }
        ///The generalised forces `A qdd + b - Q` that must act beside gravity and all forces of the declaration for the accelerations `qdd`: zero along a free motion. Inputs count as zero: where each coordinate has one, these are their values.
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        pub fn inverse_dynamics(
            &self,
            t: T,
            x: &(impl ::pendulum_core::IntoState<T, 12> + Copy),
            qdd: &(impl ::pendulum_core::IntoState<T, 6> + Copy),
        ) -> ::pendulum_core::nalgebra::SVector<T, 6> {
            struct __Code<'a, T, __X0, __X1> {
                t: T,
                x: &'a __X0,
                qdd: &'a __X1,
            }
            #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
            impl<
                T: ::pendulum_core::real::Real,
                __X0: ::pendulum_core::IntoState<T, 12> + ::core::marker::Copy,
                __X1: ::pendulum_core::IntoState<T, 6> + ::core::marker::Copy,
            > ::pendulum_core::real::lanes::Routine<(), Ur5<T>>
            for __Code<'_, T, __X0, __X1> {
                type Output = ::pendulum_core::nalgebra::SVector<T, 6>;
                #[cfg_attr(debug_assertions, inline)]
                #[cfg_attr(not(debug_assertions), inline(always))]
                fn run(
                    self,
                    (): &mut (),
                    model: &Ur5<T>,
                ) -> ::pendulum_core::nalgebra::SVector<T, 6> {
                    let Self { t, x, qdd } = self;
                    let x = ::pendulum_core::IntoState::into_state(*x);
                    let qdd = ::pendulum_core::IntoState::into_state(*qdd);
                    let [_, q_q2, q_q3, q_q4, q_q5, q_q6, qd_q1, qd_q2, qd_q3, qd_q4,
                    qd_q5, qd_q6] = x.data.0[0];
                    let [qdd_q1, qdd_q2, qdd_q3, qdd_q4, qdd_q5, qdd_q6] = qdd.data.0[0];
                    let t0 = q_q2 + q_q3;
                    let t1 = t0 + q_q4;
                    let (sin2, cos2) = t1.sin_cos();
                    let t3 = qd_q1 * qd_q2;
                    let t4 = qd_q1.mul_add(qd_q3, t3);
                    let t5 = T::from_f64(2.0) * t3;
                    let t6 = qd_q2 + qd_q3;
                    let t7 = qd_q1.mul_add(qd_q4, t4);
                    let t8 = t6 + qd_q4;
                    let t9 = qd_q1 * sin2;
                    let t10 = qdd_q2 + qdd_q3;
                    let t11 = qdd_q1.mul_add(sin2, cos2 * t7);
                    let t12 = t10 + qdd_q4;
                    let t13 = qd_q1.mul_neg_add(cos2, qd_q5);
                    let t14 = qdd_q1.mul_neg_add(cos2, sin2.mul_add(t7, qdd_q5));
                    let t15 = qd_q1 * qd_q1;
                    let t16 = t8 * t8;
                    let t17 = T::from_f64(0.10510116377025) * cos2;
                    let t18 = t15 + t16;
                    let t19 = T::from_f64(0.001653980355) * cos2;
                    let t20 = sin2 * t17;
                    let t21 = cos2 * t17;
                    let t22 = qd_q2 * qd_q2;
                    let t23 = T::from_f64(0.13585) * t15;
                    let t24 = T::from_f64(0.001653980355) * sin2;
                    let t25 = T::from_f64(0.017784735) * sin2;
                    let t26 = t6 * t6;
                    let t27 = qd_q1 * t6;
                    let t28 = qd_q1 * t8;
                    let t29 = T::from_f64(0.00460883622975) + t21;
                    let t30 = t15 + t22;
                    let t31 = T::from_f64(0.13585) * qdd_q1;
                    let t32 = T::from_f64(0.017784735) * cos2;
                    let t33 = t12.mul_neg_add(t32, t25 * t18);
                    let t34 = t15 + t26;
                    let t35 = t7 + t28;
                    let t36 = qdd_q1.mul_add(t25, t35 * t32);
                    let t37 = t4 + t27;
                    let t38 = t25.mul_add(t12, t16 * t32);
                    let [(sin39, cos39), (sin_q6, cos_q6)] = t0.sin_cos_pair(q_q6);
                    let t40 = T::from_f64(0.39225) * cos39;
                    let t41 = T::from_f64(0.39225) * sin39;
                    let t42 = T::from_f64(0.051322656825) * sin39;
                    let t43 = T::from_f64(1.598759275) * cos39;
                    let t44 = T::from_f64(1.598759275) * sin39;
                    let t45 = T::from_f64(0.59155695167475) * cos39;
                    let t46 = t10.mul_neg_add(t44, t34.mul_neg_add(t43, t33));
                    let t47 = T::from_f64(0.051322656825) * cos39;
                    let t48 = sin39 * t45;
                    let t49 = cos39 * t45;
                    let t50 = T::from_f64(0.0020475) + t49;
                    let [(sin_q2, cos_q2), (sin_q5, cos_q5)] = q_q2.sin_cos_pair(q_q5);
                    let t51 = sin_q5.mul_neg_add(t9, t8 * cos_q5);
                    let t52 = t8.mul_add(sin_q5, cos_q5 * t9);
                    let t53 = t12.mul_add(sin_q5, cos_q5.mul_add(t11, qd_q5 * t51));
                    let t54 = qd_q5
                        .mul_neg_add(t52, sin_q5.mul_neg_add(t11, t12 * cos_q5));
                    let t55 = sin_q6.mul_add(t52, cos_q6 * t13);
                    let t56 = t13.mul_neg_add(sin_q6, cos_q6 * t52);
                    let t57 = qd_q6 + (t51 + qd_q6);
                    let t58 = T::from_f64(0.016911)
                        * t56.mul_add(t57, sin_q6.mul_add(t53, cos_q6 * t14));
                    let t59 = T::from_f64(0.000225473145)
                        * cos_q6.mul_neg_add(t53, t55.mul_add(t57, sin_q6 * t14));
                    let t60 = t55 * t56;
                    let t61 = cos_q6
                        .mul_neg_add(
                            t59,
                            sin_q6
                                .mul_add(t58, T::from_f64(0.126621) * t13.mul_add(t51, t53)),
                        );
                    let t62 = t52 * t51;
                    let t63 = T::from_f64(0.126621)
                        .mul_neg_add(
                            t62 - t14,
                            sin_q6
                                .mul_add(
                                    t59,
                                    cos_q6.mul_add(t58, T::from_f64(0.10971) * (t14 + t62)),
                                ),
                        );
                    let t64 = qdd_q6 + t54;
                    let t65 = T::from_f64(0.016911)
                        .mul_neg_add(
                            t60 - t64,
                            T::from_f64(0.000225473145) * (t60 + t64),
                        );
                    let t66 = T::from_f64(0.10971)
                        .mul_neg_add(t13.mul_sub(t52, t54), t65);
                    let t67 = cos_q5
                        .mul_add(
                            t66,
                            sin_q5.mul_add(t61, qdd_q1.mul_add(t19, t20 * (t18 - t16))),
                        );
                    let t68 = T::from_f64(0.425) * cos_q2;
                    let t69 = T::from_f64(0.425) * sin_q2;
                    let t70 = t22.mul_neg_add(t69, qdd_q2 * t68) - T::from_f64(9.81);
                    let t71 = t25
                        .mul_neg_add(
                            t26.mul_neg_add(t41, t10.mul_add(t40, t70)),
                            t24
                                .mul_neg_add(
                                    t7 - t28,
                                    t12.mul_add(t29 + (T::from_f64(0.10971) - t21), t67),
                                ),
                        );
                    let t72 = qdd_q1
                        .mul_add(
                            t42,
                            t47.mul_add(t4 - t27, t48.mul_add(t34 - t26, t43 * t70)),
                        );
                    let t73 = t5
                        .mul_neg_add(
                            t69,
                            qdd_q1.mul_add(t68, T::from_f64(0.1197) * t15) - t23,
                        );
                    let t74 = t24
                        .mul_add(
                            t15 - t18,
                            t43
                                .mul_add(
                                    t73,
                                    t42
                                        .mul_add(
                                            t10,
                                            T::from_f64(0.19371331275) * cos_q2 * (t15 - t30),
                                        ),
                                ),
                        );
                    let t75 = t68
                        .mul_add(
                            t37.mul_neg_add(t44, qdd_q1.mul_sub(t43, t36)),
                            T::from_f64(0.1197).mul_add(t46, t19.mul_add(t12, t74)),
                        );
                    let t76 = qdd_q2
                        .mul_neg_add(
                            t69,
                            t30
                                .mul_neg_add(t68, T::from_f64(0.1197).mul_sub(qdd_q1, t31)),
                        );
                    let t77 = t32
                        .mul_neg_add(
                            t10.mul_neg_add(t41, t34.mul_neg_add(t40, t76)),
                            t71,
                        );
                    let t78 = t40
                        .mul_neg_add(
                            t38,
                            t44
                                .mul_neg_add(
                                    t76,
                                    t10
                                        .mul_add(
                                            t50 + (T::from_f64(0.59360445167475) - t49),
                                            t72 + t77,
                                        ),
                                ),
                        );
                    let t79 = t41.mul_neg_add(t33, t78);
                    let t80 = T::from_f64(1.75501953841) * cos_q2;
                    let t81 = cos_q2 * t80;
                    let t82 = sin_q2 * t80;
                    let t83 = T::from_f64(0.0075537) + t81;
                    let t84 = T::from_f64(4.4329225) * cos_q2;
                    let t85 = T::from_f64(0.19371331275) * sin_q2;
                    let t86 = qdd_q2
                        .mul_neg_add(
                            t85,
                            t84
                                .mul_neg_add(
                                    t23,
                                    qdd_q1
                                        .mul_add(
                                            T::from_f64(0.29853861244275) + t83 + t50 + t29,
                                            t75,
                                        ),
                                ),
                        );
                    let t87 = t25
                        .mul_neg_add(
                            t37.mul_neg_add(t41, qdd_q1.mul_add(t40, t73)),
                            t48
                                .mul_neg_add(
                                    t37,
                                    t47.mul_neg_add(t15 - t34, t5.mul_neg_add(t82, t86)),
                                ),
                        );
                    let t88 = cos2
                        .mul_neg_add(
                            t63,
                            sin2
                                .mul_neg_add(
                                    cos_q5.mul_neg_add(t61, sin_q5 * t66),
                                    t20.mul_neg_add(t35, t87),
                                ),
                        );
                    let t89 = T::from_f64(4.4329225) * sin_q2;
                    let t90 = t68
                        .mul_add(
                            t26.mul_neg_add(t44, t10.mul_sub(t43, t38)),
                            t82.mul_add(t30 - t22, t89 * t31) + t79,
                        );
                    let t91 = qdd_q1
                        .mul_neg_add(
                            t85,
                            T::from_f64(43.486969725)
                                .mul_neg_add(
                                    cos_q2,
                                    qdd_q2
                                        .mul_add(t83 + (T::from_f64(1.76257323841) - t81), t90),
                                ),
                        );
                    ::pendulum_core::nalgebra::SVector::from([
                        T::from_f64(0.13585)
                            .mul_neg_add(
                                qdd_q2.mul_neg_add(t89, t84.mul_neg_add(t30, t46)),
                                t40.mul_neg_add(t36, t88),
                            ),
                        t69.mul_neg_add(t46, t91),
                        t79,
                        t77,
                        t63,
                        t65,
                    ])
                }
            }
            T::apart(__Code { t, x, qdd }, &mut (), self)
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::taylor::TaylorSeries<T, 12>
    for Ur5<T> {
        type Workspace = ::pendulum_core::taylor::Products<T, 142>;
        #[inline]
        fn workspace(&self) -> Self::Workspace {
            ::pendulum_core::taylor::Products::new()
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn series(
            &self,
            t: T,
            x: &mut [::pendulum_core::nalgebra::SVector<T, 12>],
            work: &mut Self::Workspace,
        ) {
            if x.len() < 2 {
                return;
            }
            let (
                a0,
                a1,
                a2,
                a3,
                a4,
                a5,
                a6,
                a7,
                a8,
                a9,
                a10,
                a11,
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
                h18,
                h19,
                h20,
                h21,
                h22,
                h23,
                h24,
                h25,
                h26,
                h27,
                h28,
                h29,
                h30,
                h31,
                h32,
                h33,
                h34,
                h35,
                h36,
                h37,
                h38,
                h39,
                h40,
                h41,
                h42,
                h43,
                h44,
                h45,
                h46,
                h47,
                h48,
                h49,
                h50,
                h51,
                h52,
                h53,
                h54,
                h55,
                h56,
                h57,
                h58,
                h59,
                h60,
                h61,
                h62,
                h63,
                h64,
                h65,
                h66,
                h67,
                h68,
                h69,
                h70,
                h71,
                h72,
                h73,
                h74,
                h75,
                h76,
                h77,
                h78,
                h79,
                h80,
                h81,
                h82,
                h83,
                h84,
                h85,
                h86,
                h87,
                h88,
                h89,
                h90,
                h91,
                h92,
                h93,
                h94,
                h95,
                h96,
                h97,
                h98,
                h99,
                h100,
                h101,
                h102,
                h103,
                h104,
                h105,
                h106,
                h107,
                h108,
                h109,
                h110,
                h111,
                h112,
                h113,
                h114,
                h115,
                h116,
                h117,
                h118,
                h119,
                h120,
                h121,
                h122,
                h123,
                h124,
                h125,
                h126,
                h127,
                h128,
                h129,
                h130,
                h131,
                h132,
                h133,
                h134,
                h135,
                h136,
                h137,
                h138,
                h139,
                h140,
                h141,
                h142,
            ) = {
                let x = &x[0];
                {
                    let [_, q_q2, q_q3, q_q4, q_q5, q_q6, qd_q1, qd_q2, qd_q3, qd_q4,
                    qd_q5, qd_q6] = x.data.0[0];
                    let t0 = q_q2 + q_q3;
                    let t1 = t0 + q_q4;
                    let (sin2, cos2) = t1.sin_cos();
                    let t3 = T::from_f64(0.10510116377025) * sin2;
                    let t4 = T::from_f64(0.00697606230375) * sin2;
                    let t5 = T::from_f64(0.00697606230375) * cos2;
                    let t6 = T::from_f64(0.007558512375) * cos2;
                    let t7 = T::from_f64(0.007558512375) * sin2;
                    let t8 = qd_q1 * qd_q2;
                    let t9 = T::from_f64(0.85) * t8;
                    let t10 = qd_q1.mul_add(qd_q3, t8);
                    let t11 = T::from_f64(2.0) * t8;
                    let t12 = qd_q2 + qd_q3;
                    let t13 = qd_q4 + t12;
                    let t14 = sin2 * qd_q1;
                    let t15 = qd_q1.mul_add(qd_q4, t10);
                    let t16 = cos2.mul_neg_add(qd_q1, qd_q5);
                    let t17 = cos2 * t15;
                    let t18 = sin2 * t15;
                    let t19 = T::from_f64(0.10510116377025) * cos2;
                    let t20 = qd_q1 * qd_q1;
                    let t21 = T::from_f64(0.602212521625) * t20;
                    let t22 = qd_q2 * qd_q2;
                    let t23 = T::from_f64(0.425) * t22;
                    let t24 = t12 * t12;
                    let t25 = qd_q1 * t12;
                    let t26 = T::from_f64(0.39225) * t24;
                    let t27 = T::from_f64(1.598759275) * t24;
                    let t28 = t20 + t22;
                    let t29 = T::from_f64(4.4329225) * t28;
                    let t30 = T::from_f64(0.425) * t28;
                    let t31 = t13 * t13;
                    let t32 = T::from_f64(0.017784735) * t31;
                    let t33 = t20 + t24;
                    let t34 = T::from_f64(1.598759275) * t33;
                    let t35 = T::from_f64(0.39225) * t33;
                    let t36 = t20 + t31;
                    let t37 = T::from_f64(0.017784735) * t36;
                    let t38 = T::from_f64(0.017784735) * sin2;
                    let t39 = T::from_f64(0.017784735) * cos2;
                    let t40 = sin2 * t19;
                    let t41 = t36 - t31;
                    let t42 = t39 * t31;
                    let t43 = T::from_f64(0.39225) * t42;
                    let t44 = qd_q1 * t13;
                    let t45 = T::from_f64(0.001653980355) * sin2;
                    let t46 = t15 - t44;
                    let t47 = t15 + t44;
                    let t48 = T::from_f64(0.017784735) * t47;
                    let t49 = T::from_f64(0.001653980355) * t46;
                    let t50 = t33 - t24;
                    let t51 = t10 - t25;
                    let t52 = t10 + t25;
                    let t53 = T::from_f64(0.39225) * t52;
                    let t54 = T::from_f64(1.598759275) * t52;
                    let t55 = T::from_f64(0.051322656825) * t51;
                    let t56 = t38 * t36;
                    let t57 = t20 - t36;
                    let t58 = T::from_f64(0.001653980355) * t57;
                    let t59 = T::from_f64(0.39225) * t56;
                    let t60 = T::from_f64(0.13585) * t20;
                    let t61 = t28 - t22;
                    let t62 = t20 - t28;
                    let t63 = T::from_f64(0.19371331275) * t62;
                    let t64 = t39 * t47;
                    let t65 = T::from_f64(0.39225) * t64;
                    let t66 = t20 - t33;
                    let t67 = T::from_f64(0.051322656825) * t66;
                    let [(sin_q6, cos_q6), (sin68, cos68)] = q_q6.sin_cos_pair(t0);
                    let t69 = T::from_f64(0.59155695167475) * sin68;
                    let t70 = T::from_f64(0.016685526855) * sin_q6;
                    let t71 = T::from_f64(0.00697606230375) * cos68;
                    let t72 = T::from_f64(0.00697606230375) * sin68;
                    let t73 = T::from_f64(0.016911) * sin_q6;
                    let t74 = T::from_f64(0.000225473145) * cos_q6;
                    let t75 = T::from_f64(0.016911) * cos_q6;
                    let t76 = T::from_f64(0.000225473145) * sin_q6;
                    let t77 = T::from_f64(0.016685526855) * cos_q6;
                    let t78 = cos_q6 * t77;
                    let t79 = sin_q6 * t77;
                    let t80 = T::from_f64(0.109935473145) + t78;
                    let t81 = T::from_f64(0.016911) - t78;
                    let t82 = t80 - T::from_f64(0.126621);
                    let t83 = T::from_f64(0.126621) + t80;
                    let t84 = T::from_f64(-1.0) / t83;
                    let t85 = T::from_f64(0.39225) * cos68;
                    let t86 = T::from_f64(0.39225) * sin68;
                    let t87 = T::from_f64(0.59155695167475) * cos68;
                    let t88 = cos68 * t87;
                    let t89 = t87 * sin68;
                    let t90 = t38 * t85;
                    let t91 = t39 * t86;
                    let t92 = T::from_f64(1.598759275) * cos68;
                    let t93 = T::from_f64(1.598759275) * sin68;
                    let t94 = T::from_f64(0.051322656825) * cos68;
                    let t95 = t92 - t38;
                    let t96 = T::from_f64(0.425) * t95;
                    let t97 = t93 + t39;
                    let t98 = T::from_f64(0.425) * t97;
                    let t99 = t92.mul_neg_add(t33, t56);
                    let t100 = T::from_f64(0.425) * t99;
                    let t101 = t93.mul_add(t24, t42);
                    let t102 = T::from_f64(0.425) * t101;
                    let t103 = t93.mul_add(t52, t64);
                    let t104 = T::from_f64(0.425) * t103;
                    let [(sin_q5, cos_q5), (sin_q2, cos_q2)] = q_q5.sin_cos_pair(q_q2);
                    let t105 = cos_q5 * t82;
                    let t106 = T::from_f64(1.75501953841) * sin_q2;
                    let t107 = T::from_f64(0.007558512375) * cos_q2;
                    let t108 = T::from_f64(0.007558512375) * sin_q2;
                    let t109 = T::from_f64(0.602212521625) * cos_q2;
                    let t110 = T::from_f64(0.85) * sin_q2;
                    let t111 = cos_q5.mul_add(t14, sin_q5 * t13);
                    let t112 = sin_q5.mul_neg_add(t14, cos_q5 * t13);
                    let t113 = sin_q6.mul_add(t111, cos_q6 * t16);
                    let t114 = sin_q6.mul_neg_add(t16, cos_q6 * t111);
                    let t115 = qd_q5.mul_add(t112, cos_q5 * t17);
                    let t116 = qd_q5.mul_add(t111, sin_q5 * t17);
                    let t117 = qd_q6 + qd_q6 + t112;
                    let t118 = cos_q5 * t105;
                    let t119 = T::from_f64(0.016911)
                        * t117.mul_add(t114, sin_q6.mul_add(t115, cos_q6 * t18));
                    let t120 = T::from_f64(0.000225473145)
                        * cos_q6.mul_neg_add(t115, t113.mul_add(t117, sin_q6 * t18));
                    let t121 = t113 * t114;
                    let t122 = T::from_f64(0.016911)
                        .mul_neg_add(
                            t121 + t116,
                            T::from_f64(0.000225473145) * (t121 - t116),
                        );
                    let t123 = cos_q6
                        .mul_neg_add(
                            t120,
                            sin_q6
                                .mul_add(
                                    t119,
                                    T::from_f64(0.126621) * t16.mul_add(t112, t115),
                                ),
                        );
                    let t124 = T::from_f64(0.10971)
                        .mul_neg_add(t16.mul_add(t111, t116), t122);
                    let t125 = t111 * t112;
                    let t126 = T::from_f64(0.126621)
                        .mul_neg_add(
                            t125 - t18,
                            cos_q6
                                .mul_add(
                                    t119,
                                    T::from_f64(0.10971).mul_add(t18 + t125, sin_q6 * t120),
                                ),
                        );
                    let t127 = cos_q5 * t79;
                    let t128 = t127 * sin2;
                    let t129 = t79 * sin_q5;
                    let t130 = cos2.mul_neg_add(t83, t128);
                    let t131 = T::from_f64(0.126621) + t118;
                    let t132 = t131 - t81;
                    let t133 = T::from_f64(2.0).mul_neg_add(t128, cos2 * t132);
                    let t134 = cos2 * (t19 + t133);
                    let t135 = T::from_f64(0.00460883622975) + t81 + t134;
                    let t136 = T::from_f64(0.10971) + t131 - t134;
                    let t137 = T::from_f64(0.425) * sin_q2;
                    let t138 = t137.mul_neg_add(t22, T::from_f64(-9.81));
                    let t139 = t86.mul_neg_add(t24, t138);
                    let t140 = t137
                        .mul_neg_add(t11, T::from_f64(0.1197).mul_sub(t20, t60));
                    let t141 = T::from_f64(1.598759275) * t140;
                    let t142 = T::from_f64(1.598759275) * t138;
                    let t143 = T::from_f64(0.017784735) * t139;
                    let t144 = T::from_f64(0.425) * cos_q2;
                    let t145 = t144 * t95;
                    let t146 = t84 * t129;
                    let t147 = t144 * t28;
                    let t148 = t85.mul_add(t33, t147);
                    let t149 = t38
                        .mul_neg_add(
                            t139,
                            sin_q5
                                .mul_add(
                                    t123,
                                    t40.mul_add(t41, t39.mul_add(t148, cos_q5 * t124)),
                                ),
                        );
                    let t150 = t45.mul_neg_add(t46, t149);
                    let t151 = t94
                        .mul_add(
                            t51,
                            t93.mul_add(t147, t92.mul_add(t138, t89.mul_add(t50, t150))),
                        );
                    let t152 = cos_q5.mul_neg_add(t123, sin_q5 * t124);
                    let t153 = T::from_f64(1.598759275) * t147;
                    let t154 = T::from_f64(0.017784735) * t148;
                    let t155 = (T::from_f64(0.017136473145) * cos_q5)
                        .mul_neg_add(cos_q5, t129 * t146);
                    let t156 = t135 + t136;
                    let t157 = T::from_f64(2.0)
                        .mul_neg_add(t90, T::from_f64(0.0020475) + t88 + t135);
                    let t158 = T::from_f64(2.0)
                        .mul_add(t91, T::from_f64(0.59360445167475) + t136) - t88;
                    let t159 = t156 + t91 - t90 + t155;
                    let t160 = T::from_f64(-1.0) / (t156 + t155);
                    let t161 = t144.mul_neg_add(t38, t39.mul_add(t137, t159));
                    let t162 = t157 + t158 + t155;
                    let t163 = sin2 * sin_q5;
                    let t164 = t105
                        .mul_neg_add(t163, cos2 * (T::from_f64(0.001653980355) - t129));
                    let t165 = t160 * t159;
                    let t166 = T::from_f64(-1.0) / t159.mul_add(t165, t162);
                    let t167 = T::from_f64(0.017136473145) * t163;
                    let t168 = cos_q5.mul_add(t167, t130 * t146);
                    let t169 = T::from_f64(0.1197)
                        .mul_neg_add(
                            t97,
                            T::from_f64(0.051322656825).mul_add(sin68, t164),
                        ) + t168;
                    let t170 = T::from_f64(0.00028722347025).mul_add(cos2, t164) + t168;
                    let t171 = T::from_f64(1.75501953841) * cos_q2;
                    let t172 = t97 * t137;
                    let t173 = t165.mul_add(t161, t145 + t172) + t162;
                    let t174 = cos_q2 * t171;
                    let t175 = T::from_f64(2.0)
                        .mul_add(t145, T::from_f64(0.0075537) + t174) + t157;
                    let t176 = t171 * sin_q2;
                    let t177 = T::from_f64(2.0) * t176;
                    let t178 = t146.mul_neg_add(t126, cos_q5 * t122);
                    let t179 = t86.mul_neg_add(t56, t85.mul_neg_add(t42, t151)) - t178;
                    let t180 = t150 - t178;
                    let t181 = t86.mul_neg_add(t52, t140);
                    let t182 = T::from_f64(0.017784735) * t181;
                    let t183 = t160 * t161;
                    let t184 = t166 * t173;
                    let t185 = t173
                        .mul_add(
                            t184,
                            t161
                                .mul_add(
                                    t183,
                                    T::from_f64(2.0)
                                        .mul_add(t172, T::from_f64(1.76257323841) + t175 + t158),
                                ),
                        );
                    let t186 = T::from_f64(-1.0) / (t185 + t155 - t174);
                    let t187 = t170.mul_add(t165, T::from_f64(0.13585) * t97) + t169;
                    let t188 = t187
                        .mul_add(
                            t184,
                            t170
                                .mul_add(
                                    t183,
                                    T::from_f64(0.13585)
                                        * T::from_f64(4.4329225).mul_add(sin_q2, t97),
                                ),
                        ) + t169;
                    let t189 = T::from_f64(0.19371331275).mul_neg_add(sin_q2, t188);
                    let t190 = t165.mul_add(t180, t179);
                    let t191 = T::from_f64(43.486969725)
                        .mul_neg_add(
                            cos_q2,
                            t184.mul_add(t190, t183.mul_add(t180, t176 * t61)) + t179,
                        );
                    let t192 = t137.mul_neg_add(t99, t144.mul_neg_add(t101, t191));
                    let t193 = T::from_f64(0.19371331275) * cos_q2;
                    let t194 = t163
                        .mul_add(
                            t122,
                            t57
                                .mul_add(
                                    t45,
                                    t92
                                        .mul_add(t140, t193.mul_add(t62, T::from_f64(0.1197) * t99)),
                                ),
                        );
                    let t195 = t130 * t84;
                    let t196 = t170 * t160;
                    let t197 = t187 * t166;
                    let t198 = t187
                        .mul_add(
                            t197,
                            t170
                                .mul_add(
                                    t196,
                                    t130.mul_add(t195, T::from_f64(0.29853861244275) + t80)
                                        + t175,
                                ),
                        );
                    let t199 = t189 * t186;
                    let t200 = T::from_f64(-1.0)
                        / t163.mul_neg_add(t167, t189.mul_add(t199, t198) - t118);
                    let t201 = t126
                        .mul_add(
                            t195 - cos2,
                            t199
                                .mul_add(t192, t197.mul_add(t190, t196.mul_add(t180, t194))),
                        );
                    let t202 = T::from_f64(4.4329225) * cos_q2;
                    let t203 = t85
                        .mul_neg_add(
                            t64,
                            t144
                                .mul_neg_add(
                                    t103,
                                    T::from_f64(0.13585)
                                        .mul_neg_add(t202.mul_neg_add(t28, t99), t201),
                                ),
                        );
                    let t204 = t52
                        .mul_neg_add(
                            t89,
                            t94
                                .mul_neg_add(
                                    t66,
                                    t38.mul_neg_add(t181, t47.mul_neg_add(t40, t203)),
                                ),
                        );
                    let t205 = t200
                        * sin2
                            .mul_neg_add(
                                t152,
                                t11.mul_neg_add(t176, t202.mul_neg_add(t60, t204)),
                            );
                    let t206 = t199.mul_add(t205, t186 * t192);
                    let t207 = t184.mul_add(t206, t197.mul_add(t205, t166 * t190));
                    let t208 = t165
                        .mul_add(
                            t207,
                            t183.mul_add(t206, t196.mul_add(t205, t160 * t180)),
                        );
                    let t209 = T::from_f64(0.017136473145) * t206;
                    let t210 = t208 + (t206 + t207);
                    let t211 = cos_q5
                        .mul_neg_add(
                            t210,
                            T::from_f64(58.35506475215265).mul_neg_add(t122, t163 * t205),
                        );
                    let t212 = t146.mul_add(t210, t195.mul_add(t205, t84 * t126));
                    let t213 = T::from_f64(0.017136473145) * t211;
                    let t214 = T::from_f64(0.017136473145) * t207;
                    let t215 = T::from_f64(0.017136473145) * t208;
                    let t216 = T::from_f64(0.017136473145) * t205;
                    (
                        qd_q1,
                        qd_q2,
                        qd_q3,
                        qd_q4,
                        qd_q5,
                        qd_q6,
                        t205,
                        t206,
                        t207,
                        t208,
                        t212,
                        t211,
                        qd_q1,
                        qd_q2,
                        qd_q3,
                        qd_q4,
                        qd_q5,
                        t205,
                        t206,
                        t207,
                        t208,
                        t212,
                        sin_q2,
                        cos_q2,
                        sin68,
                        cos68,
                        t144,
                        t137,
                        t85,
                        t86,
                        sin_q5,
                        cos_q5,
                        sin_q6,
                        cos_q6,
                        t11,
                        t213,
                        t202,
                        t193,
                        t171,
                        t92,
                        t93,
                        t94,
                        t87,
                        t12,
                        t52,
                        t77,
                        t106,
                        t69,
                        t70,
                        t107,
                        t71,
                        t82,
                        t105,
                        cos2,
                        t19,
                        t132,
                        sin2,
                        t79,
                        t127,
                        t133,
                        t38,
                        t163,
                        t83,
                        t84,
                        t195,
                        t129,
                        t146,
                        t39,
                        t16,
                        t14,
                        t176,
                        t89,
                        t40,
                        t45,
                        t50,
                        t61,
                        t108,
                        t72,
                        t3,
                        t15,
                        t13,
                        t47,
                        t17,
                        t18,
                        t41,
                        t209,
                        t214,
                        t215,
                        t109,
                        t110,
                        t9,
                        t53,
                        t73,
                        t74,
                        t75,
                        t76,
                        t54,
                        t55,
                        t111,
                        t113,
                        t114,
                        t124,
                        t112,
                        t115,
                        t117,
                        t119,
                        t120,
                        t123,
                        t152,
                        t126,
                        t160,
                        t183,
                        t165,
                        t166,
                        t184,
                        t186,
                        t37,
                        t34,
                        t21,
                        t177,
                        t67,
                        t182,
                        t48,
                        t65,
                        t104,
                        t29,
                        t63,
                        t141,
                        t58,
                        t4,
                        t96,
                        t23,
                        t142,
                        t30,
                        t153,
                        t35,
                        t154,
                        t26,
                        t143,
                        t49,
                        t32,
                        t43,
                        t59,
                        t27,
                        t102,
                        t100,
                        t5,
                        t98,
                        t6,
                        t7,
                        t216,
                        t196,
                        t197,
                        t199,
                        t200,
                    )
                }
            };
            x[1] = ::pendulum_core::nalgebra::SVector::from([
                a0,
                a1,
                a2,
                a3,
                a4,
                a5,
                a6,
                a7,
                a8,
                a9,
                a10,
                a11,
            ]);
            let mut over_next = T::from_f64(1.0);
            let mut newest = ::pendulum_core::taylor::Newest::new();
            for k in 1..x.len() - 1 {
                let order = T::from_f64(k as f64);
                let over_order = over_next;
                over_next = T::from_f64(1.0 / (k + 1) as f64);
                let [s0, s1, s2, s3, s4, s5, s6, s7, s8, s9, s10, s11, s12, s13, s14,
                s15, s16, s17, s18, s19, s20, s21, s22, s23, s24, s25, s26, s27, s28,
                s29, s30, s31, s32, s33, s34, s35, s36, s37, s38, s39, s40, s41, s42,
                s43, s44, s45, s46, s47, s48, s49, s50, s51, s52, s53, s54, s55, s56,
                s57, s58, s59, s60, s61, s62, s63, s64, s65, s66, s67, s68, s69, s70,
                s71, s72, s73, s74, s75, s76, s77, s78, s79, s80, s81, s82, s83, s84,
                s85, s86, s87, s88, s89, s90, s91, s92, s93, s94, s95, s96, s97, s98,
                s99, s100, s101, s102, s103, s104, s105, s106, s107, s108, s109, s110,
                s111, s112, s113, s114, s115, s116, s117, s118, s119, s120, s121, s122,
                s123, s124, s125, s126, s127, s128, s129, s130, s131, s132, s133, s134,
                s135, s136, s137, s138, s139, s140, s141] = newest.add(work.sums(k));
                let [x0, x1, x2, x3, x4, x5, x6, x7, x8, x9, x10, x11] = x[k].data.0[0];
                let t0 = x6 * h0;
                let t1 = t0 + (s1 + t0);
                let t2 = x7 + x8;
                let t3 = x9 + t2;
                let t4 = t3 * h68;
                let t5 = t4 + (s2 + t4);
                let t6 = t1 + t5;
                let t7 = x1 + x2;
                let t8 = x3 + t7;
                let t9 = t8.mul_add(h41, s0.scaled(over_order));
                let t10 = h48
                    .mul_add(t6, h104.mul_add(t9, T::from_f64(0.017784735) * s3));
                let t11 = t2 * h31;
                let t12 = t11 + (s5 + t11);
                let t13 = t2.mul_add(h0, x6.mul_add(h31, s16));
                let t14 = t1 + t12;
                let t15 = t7.mul_add(h12, s4.scaled(over_order));
                let t16 = t10
                    - h27
                        .mul_add(
                            t14,
                            h105.mul_neg_add(t15, T::from_f64(1.598759275) * s6),
                        );
                let t17 = x1.mul_add(h10, s7.scaled(over_order));
                let t18 = x1.mul_add(h11, s10.scaled(over_order));
                let t19 = h26
                    .mul_add(
                        t18,
                        h34.mul_neg_add(t17, T::from_f64(1.75501953841) * s11),
                    );
                let t20 = x7.mul_add(h0, x6.mul_add(h1, s9));
                let t21 = h76
                    .mul_add(t1, h106.mul_neg_add(t17, T::from_f64(0.602212521625) * s8))
                    + h22.mul_add(t19, h107.mul_add(t20, T::from_f64(2.0) * s12));
                let t22 = t20 + x8.mul_add(h0, x6.mul_add(h2, s15));
                let t23 = T::from_f64(0.13585).mul_neg_add(t1, T::from_f64(0.1197) * t1)
                    - h77.mul_add(t20, h78.mul_add(t18, T::from_f64(0.85) * s19));
                let t24 = t22 + t13;
                let t25 = t22 - t13;
                let t26 = x9.mul_add(h0, x6.mul_add(h3, s24)) + t22;
                let t27 = t7.mul_add(h13, s13.scaled(over_order));
                let t28 = t7.scaled(order);
                let t29 = h30
                    .mul_add(
                        t27,
                        h35.mul_neg_add(t15, T::from_f64(0.59155695167475) * s14),
                    );
                let t30 = t1 - t14;
                let t31 = t21 + h59.mul_add(t24, h32.mul_add(t29, s17))
                    + h29
                        .mul_add(
                            t30,
                            h108.mul_neg_add(t15, T::from_f64(0.051322656825) * s18),
                        );
                let t32 = t23
                    - h17.mul_add(t24, h79.mul_add(t27, T::from_f64(0.39225) * s20));
                let t33 = t3.mul_add(h0, x6.mul_add(h68, s25));
                let t34 = t26 + t33;
                let t35 = t26 - t33;
                let t36 = t8.mul_add(h44, s22.scaled(over_order));
                let t37 = t8.scaled(order);
                let t38 = h42
                    .mul_add(
                        t9,
                        h66.mul_neg_add(t36, T::from_f64(0.10510116377025) * s23),
                    );
                let t39 = t31
                    + h48.mul_add(t32, h109.mul_add(t9, T::from_f64(0.017784735) * s21))
                    + h60.mul_add(t34, h69.mul_add(t38, s26));
                let t40 = h55
                    .mul_add(t34, h110.mul_neg_add(t36, T::from_f64(0.017784735) * s65));
                let t41 = h28
                    .mul_add(t24, h84.mul_add(t27, T::from_f64(1.598759275) * s20))
                    + t40;
                let t42 = x6.mul_add(h44, h0.mul_add(t9, s33));
                let t43 = x4.mul_add(h18, s32.scaled(over_order));
                let t44 = x4.mul_add(h19, s27.scaled(over_order));
                let t45 = h19.mul_add(t42, h57.mul_neg_add(t43, s34))
                    + t3.mul_add(h18, h68.mul_add(t44, s35));
                let t46 = t3.mul_add(h19, h68.mul_neg_add(t43, s46))
                    - h18.mul_add(t42, h57.mul_add(t44, s47));
                let t47 = x5.mul_add(h20, s28.scaled(over_order));
                let t48 = x10 - x6.mul_add(h41, h0.mul_neg_add(t36, s29));
                let t49 = x5.mul_add(h21, s31.scaled(over_order));
                let t50 = h21.mul_add(t45, h86.mul_neg_add(t47, s37))
                    - h20.mul_add(t48, h56.mul_add(t49, s38));
                let t51 = h21.mul_add(t48, h56.mul_neg_add(t47, s30))
                    + h20.mul_add(t45, h86.mul_add(t49, s36));
                let t52 = h87.mul_add(t50, h88.mul_add(t51, s39));
                let t53 = h41.mul_add(t26, h67.mul_neg_add(t36, s40));
                let t54 = h44.mul_add(t26, h67.mul_add(t9, s50));
                let t55 = h18.mul_add(t53, h70.mul_add(t44, s41))
                    + h4.mul_add(t45, x10.mul_add(h86, s42));
                let t56 = T::from_f64(0.016911)
                    .mul_neg_add(t52 + t55, T::from_f64(0.000225473145) * (t52 - t55));
                let t57 = T::from_f64(0.10971)
                    .mul_neg_add(t55 + h56.mul_add(t45, h86.mul_add(t48, s43)), t56);
                let t58 = h19.mul_add(t53, h70.mul_neg_add(t43, s45))
                    + h4.mul_add(t46, x10.mul_add(h90, s48));
                let t59 = h86.mul_add(t46, h90.mul_add(t45, s61));
                let t60 = h21.mul_add(t54, h71.mul_neg_add(t47, s51))
                    + h20.mul_add(t58, h91.mul_add(t49, s52));
                let t61 = x11 + (x11 + t46);
                let t62 = t60 + h88.mul_add(t61, h92.mul_add(t50, s53));
                let t63 = T::from_f64(0.126621)
                    .mul_add(
                        t58 + h56.mul_add(t46, h90.mul_add(t48, s49)),
                        h80.mul_add(t62, h93.mul_add(t49, T::from_f64(0.016911) * s54)),
                    );
                let t64 = h20.mul_add(t54, h71.mul_add(t49, s55))
                    + h87.mul_add(t61, h92.mul_add(t51, s56));
                let t65 = t64 - h21.mul_add(t58, h91.mul_neg_add(t47, s57));
                let t66 = t63
                    - h81
                        .mul_add(
                            t65,
                            h94.mul_neg_add(t47, T::from_f64(0.000225473145) * s58),
                        );
                let t67 = T::from_f64(0.10971)
                    .mul_add(
                        t54 + t59,
                        h82
                            .mul_add(
                                t62,
                                h93.mul_neg_add(t47, T::from_f64(0.016911) * s62),
                            ),
                    );
                let t68 = T::from_f64(0.126621)
                    .mul_neg_add(
                        t59 - t54,
                        t67
                            + h83
                                .mul_add(
                                    t65,
                                    h94.mul_add(t49, T::from_f64(0.000225473145) * s63),
                                ),
                    );
                let t69 = h33
                    .mul_add(
                        t49,
                        h36.mul_neg_add(t47, T::from_f64(0.016685526855) * s80),
                    );
                let t70 = h18.mul_add(t57, h89.mul_add(t44, s44))
                    - h19.mul_add(t66, h95.mul_neg_add(t43, s59));
                let t71 = t39 + h44.mul_add(t70, h96.mul_add(t9, s60))
                    + h41.mul_add(t68, h97.mul_neg_add(t36, s64));
                let t72 = t71
                    + h16.mul_add(t40, h111.mul_neg_add(t15, T::from_f64(0.39225) * s66))
                    + h14.mul_add(t41, h112.mul_neg_add(t17, T::from_f64(0.425) * s67));
                let t73 = x7 * h1;
                let t74 = t73 + (s68 + t73);
                let t75 = t1 + t74;
                let t76 = T::from_f64(0.13585)
                    .mul_add(
                        t16
                            - h24
                                .mul_add(
                                    t75,
                                    h113.mul_neg_add(t17, T::from_f64(4.4329225) * s69),
                                ),
                        t72,
                    );
                let t77 = t1 - t75;
                let t78 = t76
                    - h25
                        .mul_add(
                            t77,
                            h114.mul_neg_add(t17, T::from_f64(0.19371331275) * s70),
                        )
                    - h27
                        .mul_add(
                            t23,
                            h115.mul_neg_add(t15, T::from_f64(1.598759275) * s71),
                        );
                let t79 = t1 - t6;
                let t80 = T::from_f64(0.1197)
                    .mul_sub(
                        t16,
                        t78
                            - h61
                                .mul_add(
                                    t79,
                                    h116.mul_add(t9, T::from_f64(0.001653980355) * s72),
                                ),
                    );
                let t81 = t6 - t5;
                let t82 = h55
                    .mul_add(t5, h128.mul_neg_add(t36, T::from_f64(0.017784735) * s110));
                let t83 = h33 * t47;
                let t84 = -t47;
                let t85 = T::from_f64(0.016685526855).mul_sub(s73, t83);
                let t86 = t85 - t83;
                let t87 = t83 - t85;
                let t88 = h26 * t17;
                let t89 = T::from_f64(1.75501953841).mul_sub(s74, t88) - t88;
                let t90 = h30 * t15;
                let t91 = T::from_f64(0.59155695167475).mul_sub(s75, t90) - t90;
                let t92 = h42 * t36;
                let t93 = h19.mul_add(t86, h39.mul_neg_add(t43, s77));
                let t94 = h19.mul_add(t93, h40.mul_neg_add(t43, s78));
                let t95 = t94 - t87;
                let t96 = h19.mul_add(t69, h45.mul_neg_add(t43, s81));
                let t97 = h44.mul_add(t96, h46.mul_add(t9, s82));
                let t98 = T::from_f64(2.0)
                    .mul_neg_add(t97, h41.mul_add(t95, h43.mul_neg_add(t36, s79)));
                let t99 = T::from_f64(0.10510116377025).mul_sub(s76, t92) - t92
                    + h41.mul_add(t98, h47.mul_neg_add(t36, s83));
                let t100 = t87 + t99;
                let t101 = h45.mul_add(t44, h18.mul_add(t69, s89));
                let t102 = t97 - h41.mul_add(t86, h50.mul_neg_add(t36, s94));
                let t103 = t68 + h5.mul_add(t102, s133) + h6.mul_add(t101, s134)
                    + h7.mul_add(t101, s135);
                let t104 = t103 + h8.mul_add(t101, s136) + h9.mul_add(t86, s137);
                let t105 = t94 - t99;
                let t106 = h38
                    .mul_add(
                        t9,
                        h117.mul_neg_add(t15, T::from_f64(0.00697606230375) * s84),
                    );
                let t107 = T::from_f64(2.0).mul_neg_add(t106, t91 + t100);
                let t108 = t100 + t105;
                let t109 = T::from_f64(0.017784735)
                    .mul_add(t9, T::from_f64(1.598759275) * t15);
                let t110 = -t109;
                let t111 = h14
                    .mul_neg_add(t109, h118.mul_neg_add(t17, T::from_f64(0.425) * s85));
                let t112 = T::from_f64(2.0).mul_add(t111, t89 + t107);
                let t113 = t86 + t112 - t94;
                let t114 = T::from_f64(0.017784735)
                    .mul_neg_add(t36, T::from_f64(1.598759275) * t27);
                let t115 = h44.mul_add(t44, h18.mul_add(t9, s87));
                let t116 = h40.mul_add(t115, h49.mul_add(t93, s88))
                    + h41.mul_add(t101, h53.mul_neg_add(t36, s90));
                let t117 = T::from_f64(0.001653980355).mul_add(t36, t116);
                let t118 = t56 - h138.mul_add(t115, T::from_f64(0.017136473145) * s138)
                    + h73.mul_neg_add(t43, T::from_f64(0.017136473145) * s139);
                let t119 = t118
                    + h74.mul_neg_add(t43, T::from_f64(0.017136473145) * s140)
                    + h75.mul_neg_add(t43, T::from_f64(0.017136473145) * s141);
                let t120 = h9.mul_add(t101, s123);
                let t121 = T::from_f64(0.1197)
                    .mul_neg_add(t114, T::from_f64(0.051322656825).mul_sub(t27, t117));
                let t122 = T::from_f64(0.00028722347025).mul_add(t36, t117);
                let t123 = T::from_f64(0.19371331275)
                    .mul_neg_add(
                        t18,
                        T::from_f64(0.13585)
                            .mul_add(T::from_f64(4.4329225).mul_add(t18, t114), t121),
                    );
                let t124 = T::from_f64(0.13585).mul_add(t114, t121);
                let t125 = t80 + h5.mul_add(t113, s86) + h6.mul_add(t123, s91)
                    + h7.mul_add(t124, s92);
                let t126 = t125 + h8.mul_neg_add(t122, s93) + h9.mul_add(t102, s95)
                    - h23.mul_add(t115, T::from_f64(0.017136473145) * s96);
                let t127 = h135
                    .mul_add(t18, h15.mul_add(t114, T::from_f64(0.425) * s117));
                let t128 = h23.mul_neg_add(t43, T::from_f64(0.017136473145) * s124);
                let t129 = h14
                    .mul_add(t75, h121.mul_neg_add(t17, T::from_f64(0.425) * s69));
                let t130 = t75 - t74;
                let t131 = h15.mul_add(t74, h119.mul_add(t18, T::from_f64(0.425) * s98));
                let t132 = -t131;
                let t133 = h16
                    .mul_add(t14, h123.mul_neg_add(t15, T::from_f64(0.39225) * s6))
                    + t129;
                let t134 = h55
                    .mul_add(
                        t133,
                        h124.mul_neg_add(t36, T::from_f64(0.017784735) * s103),
                    ) + h60.mul_add(t81, h72.mul_add(t38, s104));
                let t135 = t134 + h18.mul_add(t66, h95.mul_add(t44, s105))
                    + h19.mul_add(t57, h89.mul_neg_add(t43, s106));
                let t136 = h27
                    .mul_neg_add(
                        t131,
                        h120.mul_neg_add(t15, T::from_f64(1.598759275) * s99),
                    )
                    + h28
                        .mul_add(
                            t129,
                            h122.mul_add(t27, T::from_f64(1.598759275) * s100),
                        );
                let t137 = t131
                    + h17.mul_add(t12, h125.mul_add(t27, T::from_f64(0.39225) * s107));
                let t138 = t135
                    - h48
                        .mul_neg_add(
                            t137,
                            h126.mul_add(t9, T::from_f64(0.017784735) * s108),
                        )
                    - h61
                        .mul_add(
                            t35,
                            h127.mul_add(t9, T::from_f64(0.001653980355) * s109),
                        );
                let t139 = -t137;
                let t140 = t14 - t12;
                let t141 = t136
                    + h29
                        .mul_add(
                            t25,
                            h85.mul_neg_add(t15, T::from_f64(0.051322656825) * s101),
                        ) + h59.mul_add(t140, h62.mul_add(t29, s102));
                let t142 = t141 + t138
                    - h16
                        .mul_add(t82, h129.mul_neg_add(t15, T::from_f64(0.39225) * s111))
                    - h17.mul_add(t10, h130.mul_add(t27, T::from_f64(0.39225) * s112));
                let t143 = t82
                    + h28
                        .mul_add(
                            t12,
                            h131.mul_add(t27, T::from_f64(1.598759275) * s107),
                        );
                let t144 = T::from_f64(43.486969725)
                    .mul_add(t17, h58.mul_add(t130, h63.mul_add(t19, s97)) + t142)
                    - h14
                        .mul_add(t143, h132.mul_neg_add(t17, T::from_f64(0.425) * s113));
                let t145 = t144
                    - h15.mul_add(t16, h133.mul_add(t18, T::from_f64(0.425) * s114))
                    + h5.mul_add(t123, s115);
                let t146 = h134
                    .mul_add(
                        t27,
                        h65.mul_neg_add(t36, T::from_f64(0.00697606230375) * s116),
                    );
                let t147 = T::from_f64(2.0).mul_add(t146, t105) - t91;
                let t148 = t146 + t108 - t106;
                let t149 = t148
                    + h136
                        .mul_add(
                            t18,
                            h64.mul_neg_add(t36, T::from_f64(0.007558512375) * s120),
                        )
                    - h137
                        .mul_neg_add(
                            t17,
                            h37.mul_add(t9, T::from_f64(0.007558512375) * s121),
                        );
                let t150 = T::from_f64(2.0).mul_add(t127, t112 + t147) - t89;
                let t151 = t107 + t147;
                let t152 = t111 + t127 + t151;
                let t153 = t142 + h5.mul_add(t124, s125) + h6.mul_add(t152, s126)
                    + h7.mul_add(t151, s127);
                let t154 = t145 + h6.mul_add(t150, s118) + h7.mul_add(t152, s119)
                    + h8.mul_add(t149, s122);
                let t155 = t138 + h5.mul_neg_add(t122, s129) + h6.mul_add(t149, s130)
                    + h7.mul_add(t148, s131);
                let t156 = -t15;
                let t157 = -t17;
                let t158 = -t36;
                let t159 = -t43;
                let t160 = -t122;
                let t161 = h19 * t119;
                let t162 = h54 * t104;
                let t163 = t128 + (t120 + (t155 + h8.mul_add(t108, s132))) - t161 + t162;
                let t164 = h100
                    .mul_add(
                        t163,
                        t128 + (t120 + (t153 + h8.mul_add(t148, s128))) - t161 + t162,
                    );
                let t165 = h102
                    .mul_add(t164, h99.mul_add(t163, t154 + t120 + t128 - t161 + t162));
                let t166 = h140
                    .mul_add(
                        t164,
                        h139.mul_add(t163, h52.mul_add(t104, h49.mul_add(t119, t126))),
                    );
                let t167 = h142 * h141.mul_add(t165, t166);
                let t168 = h141.mul_add(t167, h103 * t165);
                let t169 = h102.mul_add(t168, h140.mul_add(t167, h101 * t164));
                let t170 = h100
                    .mul_add(t169, h99.mul_add(t168, h139.mul_add(t167, h98 * t163)));
                let t171 = h54
                    .mul_add(
                        t170,
                        h54
                            .mul_add(
                                t169,
                                h54.mul_add(t168, h52.mul_add(t167, h51 * t104)),
                            ),
                    );
                let t172 = h19
                    .mul_neg_add(
                        t170,
                        h19
                            .mul_neg_add(
                                t169,
                                h19
                                    .mul_neg_add(
                                        t168,
                                        T::from_f64(58.35506475215265).mul_neg_add(t119, h49 * t167),
                                    ),
                            ),
                    );
                let t173 = x1.scaled(order);
                let t174 = x4.scaled(order);
                let t175 = x5.scaled(order);
                let (left, right) = (
                    [
                        t37,
                        x6,
                        t3,
                        t9,
                        t28,
                        t2,
                        t156,
                        t173,
                        t157,
                        x6,
                        t173,
                        t157,
                        t20,
                        t28,
                        t156,
                        x6,
                        x6,
                        t29,
                        t156,
                        t18,
                        t27,
                        t9,
                        t37,
                        t158,
                        x6,
                        x6,
                        t38,
                        t174,
                        t175,
                        t158,
                        t84,
                        t175,
                        t174,
                        t9,
                        t159,
                        t44,
                        t49,
                        t84,
                        t49,
                        t51,
                        t158,
                        t44,
                        x10,
                        t48,
                        t44,
                        t159,
                        t159,
                        t44,
                        x10,
                        t48,
                        t9,
                        t84,
                        t49,
                        t50,
                        t49,
                        t49,
                        t51,
                        t84,
                        t84,
                        t159,
                        t9,
                        t45,
                        t84,
                        t49,
                        t158,
                        t158,
                        t156,
                        t157,
                        x7,
                        t157,
                        t157,
                        t156,
                        t9,
                        t84,
                        t157,
                        t156,
                        t158,
                        t159,
                        t159,
                        t158,
                        t84,
                        t159,
                        t9,
                        t158,
                        t156,
                        t157,
                        t113,
                        t9,
                        t93,
                        t69,
                        t158,
                        t123,
                        t124,
                        t160,
                        t158,
                        t102,
                        t115,
                        t19,
                        t18,
                        t156,
                        t27,
                        t156,
                        t29,
                        t158,
                        t38,
                        t44,
                        t159,
                        t27,
                        t9,
                        t9,
                        t158,
                        t156,
                        t27,
                        t157,
                        t18,
                        t123,
                        t158,
                        t114,
                        t150,
                        t152,
                        t158,
                        t9,
                        t149,
                        t101,
                        t159,
                        t124,
                        t152,
                        t151,
                        t148,
                        t160,
                        t149,
                        t148,
                        t108,
                        t102,
                        t101,
                        t101,
                        t101,
                        t86,
                        t115,
                        t159,
                        t159,
                        t159,
                    ],
                    [
                        t158,
                        x6,
                        t3,
                        t6,
                        t27,
                        t2,
                        t14,
                        t18,
                        t1,
                        x7,
                        t157,
                        t18,
                        t19,
                        t156,
                        t27,
                        x8,
                        t2,
                        t24,
                        t30,
                        t20,
                        t24,
                        t32,
                        t9,
                        t9,
                        x9,
                        t3,
                        t34,
                        t159,
                        t49,
                        x6,
                        t48,
                        t84,
                        t44,
                        x6,
                        t42,
                        t3,
                        t45,
                        t45,
                        t48,
                        t50,
                        t26,
                        t53,
                        t45,
                        t45,
                        t57,
                        t53,
                        t3,
                        t42,
                        t46,
                        t46,
                        t26,
                        t54,
                        t58,
                        t61,
                        t62,
                        t54,
                        t61,
                        t58,
                        t65,
                        t66,
                        t70,
                        t46,
                        t62,
                        t65,
                        t68,
                        t34,
                        t40,
                        t41,
                        x7,
                        t75,
                        t77,
                        t23,
                        t79,
                        t84,
                        t157,
                        t156,
                        t158,
                        t86,
                        t93,
                        t95,
                        t49,
                        t69,
                        t96,
                        t98,
                        t9,
                        t110,
                        t167,
                        t44,
                        t115,
                        t44,
                        t101,
                        t168,
                        t169,
                        t170,
                        t86,
                        t171,
                        t172,
                        t130,
                        t74,
                        t132,
                        t129,
                        t25,
                        t140,
                        t133,
                        t81,
                        t66,
                        t57,
                        t12,
                        t139,
                        t35,
                        t5,
                        t82,
                        t10,
                        t143,
                        t16,
                        t167,
                        t27,
                        t18,
                        t168,
                        t169,
                        t18,
                        t157,
                        t170,
                        t171,
                        t172,
                        t167,
                        t168,
                        t169,
                        t170,
                        t167,
                        t168,
                        t169,
                        t170,
                        t167,
                        t168,
                        t169,
                        t170,
                        t171,
                        t167,
                        t168,
                        t169,
                        t170,
                    ],
                );
                newest.push(k, left, right);
                work.set(k, left, right);
                x[k + 1] = ::pendulum_core::nalgebra::SVector::from([
                    x6.scaled(over_next),
                    x7.scaled(over_next),
                    x8.scaled(over_next),
                    x9.scaled(over_next),
                    x10.scaled(over_next),
                    x11.scaled(over_next),
                    t167.scaled(over_next),
                    t168.scaled(over_next),
                    t169.scaled(over_next),
                    t170.scaled(over_next),
                    t171.scaled(over_next),
                    t172.scaled(over_next),
                ]);
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::taylor::CastTaylor<12> for Ur5 {
        type Workspace<T: ::pendulum_core::real::Real> = ::pendulum_core::taylor::Products<
            T,
            142,
        >;
        #[inline]
        fn with_series<T: ::pendulum_core::real::Real>(
            model: &Ur5<T>,
        ) -> &impl ::pendulum_core::taylor::TaylorSeries<
            T,
            12,
            Workspace = ::pendulum_core::taylor::Products<T, 142>,
        > {
            model
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::Parametric<12, 0> for Ur5 {
        fn parameters(&self) -> [f64; 0] {
            self.params.to_array()
        }
        fn parameter_names(&self) -> [&str; 0] {
            Ur5Params::NAMES
        }
        fn check_parameters(
            &self,
            parameters: &[f64; 0],
        ) -> ::core::result::Result<(), ::pendulum_core::ParameterError> {
            Self::new(Ur5Params::from_array(*parameters)).map(|_| ())
        }
        fn with_parameters<T: ::pendulum_core::real::Real>(
            &self,
            parameters: [T; 0],
        ) -> Ur5<T> {
            Ur5 {
                params: self.params,
                constants: constants(parameters),
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::CastJacobian<12> for Ur5 {
        #[inline]
        fn with_jacobian<T: ::pendulum_core::real::Real>(
            model: &Ur5<T>,
        ) -> &impl ::pendulum_core::Jacobian<T, 12> {
            model
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::Cast<12> for Ur5 {
        type In<T: ::pendulum_core::real::Real> = Ur5<T>;
        fn cast<T: ::pendulum_core::real::Real>(&self) -> Ur5<T> {
            Ur5::cast(self)
        }
        #[inline]
        fn gather<'m, T: ::pendulum_core::real::lanes::Lanes>(
            models: impl ::core::ops::Fn(usize) -> &'m Self,
        ) -> Ur5<T>
        where
            Self: 'm,
        {
            let scalar = <<T as ::pendulum_core::real::lanes::Lanes>::Scalar as ::pendulum_core::real::Real>::from_f64;
            Ur5 {
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
pub use __Ur5::{Ur5, Ur5Params};
