#[allow(non_snake_case)]
mod __Triple {
    ///Parameters of [`Triple`].
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct TripleParams {}
    impl ::core::default::Default for TripleParams {
        #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
        fn default() -> Self {
            Self {}
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl TripleParams {
        /// The names of the parameters, in the order of their declaration.
        pub const NAMES: [&'static str; 0] = [];
        /// The values of the parameters, in the order of [`NAMES`](Self::NAMES).
        pub const fn to_array(self) -> [f64; 0] {
            []
        }
        /// The parameters with these values, in the order of [`NAMES`](Self::NAMES).
        pub const fn from_array(values: [f64; 0]) -> Self {
            let [] = values;
            Self {}
        }
    }
    /// A double rigid body and a rod.
    ///
    /**# Equations of motion

```text
A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints

A[theta1, theta1] = 1.53
A[theta1, theta2] = 0.68*cos(theta1 - theta2)
A[theta1, theta3] = 0.15*cos(theta1 - theta3)
A[theta2, theta2] = 0.482
A[theta2, theta3] = 0.12*cos(theta2 - theta3)
A[theta3, theta3] = 0.065
b[theta1] = 16.677*sin(theta1) + 0.68*dot(theta2)^2*sin(theta1 - theta2) + 0.15*dot(theta3)^2*sin(theta1 - theta3)
b[theta2] = 0.12*dot(theta3)^2*sin(theta2 - theta3) + 6.6708*sin(theta2) - 0.68*dot(theta1)^2*sin(theta1 - theta2)
b[theta3] = 1.4715*sin(theta3) - 0.15*dot(theta1)^2*sin(theta1 - theta3) - 0.12*dot(theta2)^2*sin(theta2 - theta3)
Q[theta1] = 0.01*dot(theta2) - 0.02*dot(theta1)
Q[theta2] = 0.01*dot(theta3) + 0.01*dot(theta1) - 0.02*dot(theta2)
Q[theta3] = 0.01*dot(theta2) - 0.01*dot(theta3)
```
*/
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Triple<T = f64> {
        params: TripleParams,
        constants: [T; 0],
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl Triple {
        /// Builds the model: checks the parameters, and computes once whatever depends on them alone.
        ///
        /// # Errors
        ///
        /// The first parameter, or combination of parameters, that is not finite or that no rigid body can
        /// have.
        pub fn new(
            params: TripleParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            #[inline]
            fn rules<T: ::pendulum_core::real::Real>(given: [T; 0]) -> [T; 0] {
                let [] = given;
                []
            }
            #[inline]
            fn constants<T: ::pendulum_core::real::Real>(given: [T; 0]) -> [T; 0] {
                let [] = given;
                []
            }
            let given = params.to_array();
            for (name, value) in TripleParams::NAMES.into_iter().zip(given) {
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
                        TripleParams::NAMES[n],
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
        pub fn cast<T: ::pendulum_core::real::Real>(&self) -> Triple<T> {
            Triple {
                params: self.params,
                constants: self.constants.map(T::from_f64),
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> Triple<T> {
        /// The parameters that the model was built from.
        pub fn params(&self) -> &TripleParams {
            &self.params
        }
        /// The model with other parameters, in the same number type. Its constants are computed anew.
        ///
        /// # Errors
        ///
        /// Those of `new`.
        pub fn with_params(
            &self,
            params: TripleParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            Ok(<Triple>::new(params)?.cast())
        }
    }
    impl Triple {
        ///The place of `theta1` in the state, where it stands in rad.
        pub const THETA1: usize = 0;
        ///The place of `dot(theta1)` in the state, where it stands in rad/s.
        pub const DOT_THETA1: usize = 3;
        ///The place of `theta2` in the state, where it stands in rad.
        pub const THETA2: usize = 1;
        ///The place of `dot(theta2)` in the state, where it stands in rad/s.
        pub const DOT_THETA2: usize = 4;
        ///The place of `theta3` in the state, where it stands in rad.
        pub const THETA3: usize = 2;
        ///The place of `dot(theta3)` in the state, where it stands in rad/s.
        pub const DOT_THETA3: usize = 5;
        /// The number of degrees of freedom; the state has twice as many components.
        pub const DOF: usize = 3;
        /// The names of the coordinates, in the order in which they, and then their rates, stand in the state.
        pub const COORDINATES: [&'static str; 3] = ["theta1", "theta2", "theta3"];
        /// Counted operations of each generated function, in the form that it has and in others.
        pub const COST: ::pendulum_core::Cost = ::pendulum_core::Cost::new(
            &[
                (
                    "rhs",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of parameters first, L^T D L",
                            ::pendulum_core::Operations::new(30, 51, 2, 3, 0, 42),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L",
                                    ::pendulum_core::Operations::new(30, 51, 2, 3, 0, 42),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first, L^T D L",
                                    ::pendulum_core::Operations::new(30, 52, 2, 3, 0, 42),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, L^T D L",
                                    ::pendulum_core::Operations::new(61, 59, 3, 3, 0, 53),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "articulated bodies",
                                    ::pendulum_core::Operations::new(64, 83, 3, 3, 0, 68),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C, L^T D L",
                                    ::pendulum_core::Operations::new(112, 109, 3, 3, 0, 52),
                                ),
                            ],
                        ),
                ),
                (
                    "kinetic",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(8, 14, 0, 2, 0, 28),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(8, 14, 0, 2, 0, 28),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(8, 14, 0, 2, 0, 28),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(31, 38, 0, 3, 0, 35),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C",
                                    ::pendulum_core::Operations::new(56, 47, 0, 3, 0, 40),
                                ),
                            ],
                        ),
                ),
                (
                    "potential",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(3, 3, 0, 3, 0, 23),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(3, 3, 0, 3, 0, 23),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(3, 3, 0, 3, 0, 23),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C",
                                    ::pendulum_core::Operations::new(6, 5, 0, 3, 0, 25),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(6, 5, 0, 3, 0, 25),
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
                            3..4,
                        )
                        .periodic(),
                    ::pendulum_core::Slot::new(
                            "theta2",
                            ::pendulum_core::SlotKind::Angle,
                            1..2,
                            4..5,
                        )
                        .periodic(),
                    ::pendulum_core::Slot::new(
                            "theta3",
                            ::pendulum_core::SlotKind::Angle,
                            2..3,
                            5..6,
                        )
                        .periodic(),
                ],
            )
            .autonomous();
        /// The equations of motion as text.
        pub const EQUATIONS: &'static str = "A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints\n\nA[theta1, theta1] = 1.53\nA[theta1, theta2] = 0.68*cos(theta1 - theta2)\nA[theta1, theta3] = 0.15*cos(theta1 - theta3)\nA[theta2, theta2] = 0.482\nA[theta2, theta3] = 0.12*cos(theta2 - theta3)\nA[theta3, theta3] = 0.065\nb[theta1] = 16.677*sin(theta1) + 0.68*dot(theta2)^2*sin(theta1 - theta2) + 0.15*dot(theta3)^2*sin(theta1 - theta3)\nb[theta2] = 0.12*dot(theta3)^2*sin(theta2 - theta3) + 6.6708*sin(theta2) - 0.68*dot(theta1)^2*sin(theta1 - theta2)\nb[theta3] = 1.4715*sin(theta3) - 0.15*dot(theta1)^2*sin(theta1 - theta3) - 0.12*dot(theta2)^2*sin(theta2 - theta3)\nQ[theta1] = 0.01*dot(theta2) - 0.02*dot(theta1)\nQ[theta2] = 0.01*dot(theta3) + 0.01*dot(theta1) - 0.02*dot(theta2)\nQ[theta3] = 0.01*dot(theta2) - 0.01*dot(theta3)\n";
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::System<T, 6> for Triple<T> {
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn rhs(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 6>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 6> {
            let [q_theta1, q_theta2, q_theta3, qd_theta1, qd_theta2, qd_theta3] = x
                .data
                .0[0];
            let t0 = qd_theta3 * qd_theta3;
            let t1 = qd_theta1 * qd_theta1;
            let (sin_theta3, cos_theta3) = q_theta3.sin_cos();
            let [(sin_theta1, cos_theta1), (sin_theta2, cos_theta2)] = q_theta1
                .sin_cos_pair(q_theta2);
            let t2 = cos_theta1 * cos_theta3 + sin_theta1 * sin_theta3;
            let t3 = T::from_f64(0.15) * t2;
            let t4 = T::from_f64(2.3076923076923075) * t2;
            let t5 = cos_theta3 * cos_theta2 + sin_theta3 * sin_theta2;
            let t6 = T::from_f64(1.8461538461538463) * t5;
            let t7 = T::from_f64(-1.0)
                / (T::from_f64(0.482) - T::from_f64(0.12) * t5 * t6);
            let t8 = T::from_f64(0.68)
                * (cos_theta1 * cos_theta2 + sin_theta1 * sin_theta2) - t3 * t6;
            let t9 = t8 * t7;
            let t10 = T::from_f64(0.15)
                * (cos_theta3 * sin_theta1 - cos_theta1 * sin_theta3);
            let t11 = T::from_f64(0.68)
                * (sin_theta1 * cos_theta2 - cos_theta1 * sin_theta2);
            let t12 = T::from_f64(16.677) * sin_theta1 + T::from_f64(0.02) * qd_theta1
                + t10 * t0 + qd_theta2 * (qd_theta2 * t11 - T::from_f64(0.01));
            let t13 = T::from_f64(0.12)
                * (cos_theta3 * sin_theta2 - sin_theta3 * cos_theta2);
            let t14 = T::from_f64(6.6708) * sin_theta2 + t13 * t0
                + T::from_f64(0.02) * qd_theta2 - t11 * t1
                - T::from_f64(0.01) * (qd_theta1 + qd_theta3);
            let t15 = T::from_f64(0.01) * (qd_theta3 - qd_theta2)
                + T::from_f64(1.4715) * sin_theta3 - t10 * t1
                - qd_theta2 * qd_theta2 * t13;
            let t16 = t14 - t6 * t15;
            let t17 = T::from_f64(-1.0) / (T::from_f64(1.53) + t8 * t9 - t3 * t4)
                * (t12 + t9 * t16 - t4 * t15);
            let t18 = t7 * t16 + t9 * t17;
            ::pendulum_core::nalgebra::SVector::from([
                qd_theta1,
                qd_theta2,
                qd_theta3,
                t17,
                t18,
                -(T::from_f64(15.384615384615385) * t15 + t4 * t17 + t6 * t18),
            ])
        }
        #[inline]
        fn layout(
            &self,
        ) -> ::core::option::Option<&'static ::pendulum_core::StateLayout> {
            Some(&<Triple>::LAYOUT)
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Energy<T, 6> for Triple<T> {
        #[inline]
        fn kinetic(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 6>) -> T {
            let [q_theta1, q_theta2, q_theta3, qd_theta1, qd_theta2, qd_theta3] = x
                .data
                .0[0];
            let t0 = q_theta1 - q_theta2;
            let t1 = q_theta1 - q_theta3;
            let [(sin2, cos2), (sin3, cos3)] = t0.sin_cos_pair(t1);
            let t4 = qd_theta1
                * (cos2 * (T::from_f64(0.68) * qd_theta2)
                    + cos3 * (T::from_f64(0.15) * qd_theta3)
                    + T::from_f64(0.765) * qd_theta1);
            let t5 = qd_theta2
                * (T::from_f64(0.241) * qd_theta2
                    + T::from_f64(0.12) * qd_theta3 * (cos2 * cos3 + sin2 * sin3));
            t4 + (qd_theta3 * (T::from_f64(0.0325) * qd_theta3) + t5)
        }
        #[inline]
        fn potential(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 6>) -> T {
            let [q_theta1, q_theta2, q_theta3, _, _, _] = x.data.0[0];
            let (_, cos_theta2) = q_theta2.sin_cos();
            let [(_, cos_theta3), (_, cos_theta1)] = q_theta3.sin_cos_pair(q_theta1);
            -(T::from_f64(1.4715) * cos_theta3
                + (T::from_f64(16.677) * cos_theta1 + T::from_f64(6.6708) * cos_theta2))
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::shapes::Shapes<6> for Triple {
        fn shapes(
            &self,
            t: f64,
            x: &::pendulum_core::nalgebra::SVector<f64, 6>,
        ) -> ::pendulum_core::shapes::Vec<::pendulum_core::shapes::Shape> {
            use ::pendulum_core::real::Real as _;
            type T = f64;
            ::pendulum_core::shapes::placed(
                &[
                    ::pendulum_core::shapes::Outline {
                        name: "first",
                        kind: ::pendulum_core::shapes::ShapeKind::Mass,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "second",
                        kind: ::pendulum_core::shapes::ShapeKind::Mass,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "rod",
                        kind: ::pendulum_core::shapes::ShapeKind::Mass,
                        points: 2,
                        radius: false,
                    },
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
                        name: "rod",
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
                    let [q_theta1, q_theta2, q_theta3, _, _, _] = x.data.0[0];
                    let (sin_theta3, cos_theta3) = q_theta3.sin_cos();
                    let [(sin_theta1, cos_theta1), (sin_theta2, cos_theta2)] = q_theta1
                        .sin_cos_pair(q_theta2);
                    let t0 = T::from_f64(0.5) * sin_theta1;
                    let t1 = T::from_f64(-0.5) * cos_theta1;
                    let t2 = sin_theta1 + T::from_f64(0.4) * sin_theta2;
                    let t3 = -(cos_theta1 + T::from_f64(0.4) * cos_theta2);
                    let t4 = -cos_theta1;
                    let t5 = sin_theta1 + T::from_f64(0.8) * sin_theta2;
                    let t6 = cos_theta1 + T::from_f64(0.8) * cos_theta2;
                    let t7 = t5 + T::from_f64(0.3) * sin_theta3;
                    let t8 = t5 + T::from_f64(0.6) * sin_theta3;
                    let t9 = -(t6 + T::from_f64(0.3) * cos_theta3);
                    let t10 = -(t6 + T::from_f64(0.6) * cos_theta3);
                    let t11 = -t6;
                    [
                        t0,
                        t1,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t2,
                        t3,
                        T::from_f64(0.0),
                        sin_theta1,
                        t4,
                        T::from_f64(0.0),
                        t7,
                        t9,
                        T::from_f64(0.0),
                        t5,
                        t11,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        sin_theta1,
                        t4,
                        T::from_f64(0.0),
                        sin_theta1,
                        t4,
                        T::from_f64(0.0),
                        t5,
                        t11,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        sin_theta1,
                        t4,
                        T::from_f64(0.0),
                        t5,
                        t11,
                        T::from_f64(0.0),
                        t8,
                        t10,
                        T::from_f64(0.0),
                    ]
                },
            )
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::Cast<6> for Triple {
        type In<T: ::pendulum_core::real::Real> = Triple<T>;
        fn cast<T: ::pendulum_core::real::Real>(&self) -> Triple<T> {
            Triple::cast(self)
        }
        #[inline]
        fn gather<'m, T: ::pendulum_core::real::lanes::Lanes>(
            models: impl ::core::ops::Fn(usize) -> &'m Self,
        ) -> Triple<T>
        where
            Self: 'm,
        {
            let scalar = <<T as ::pendulum_core::real::lanes::Lanes>::Scalar as ::pendulum_core::real::Real>::from_f64;
            Triple {
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
pub use __Triple::{Triple, TripleParams};
