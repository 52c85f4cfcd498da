#[allow(non_snake_case)]
mod __Arm {
    ///Parameters of [`Arm`].
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct ArmParams {
        ///In N.
        pub push: f64,
    }
    impl ::core::default::Default for ArmParams {
        #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
        fn default() -> Self {
            Self { push: 3f64 }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ArmParams {
        /// The names of the parameters, in the order of their declaration.
        pub const NAMES: [&'static str; 1] = ["push"];
        /// The values of the parameters, in the order of [`NAMES`](Self::NAMES).
        pub const fn to_array(self) -> [f64; 1] {
            [self.push]
        }
        /// The parameters with these values, in the order of [`NAMES`](Self::NAMES).
        pub const fn from_array(values: [f64; 1]) -> Self {
            let [v0] = values;
            Self { push: v0 }
        }
    }
    /// An arm with shoulder, elbow and hand; z points upward.
    ///
    /**# Equations of motion

```text
A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q all other forces

A[q1, q1] = 0.343925 + 0.14*cos(q2)*cos(q2 + q3) - 997/3750*sin(q2)^2 - 4873/120000*sin(q2 + q3)^2
A[q1, q2] = 0.0175*sin(q2 + q3) + 0.08*sin(q2)
A[q1, q3] = 0.0175*sin(q2 + q3)
A[q2, q2] = 0.308525 + 0.14*cos(q3)
A[q2, q3] = 4927/120000 + 0.07*cos(q3)
A[q3, q3] = 4927/120000
b[q1] = 0.08*dot(q2)^2*cos(q2) + 0.035*dot(q2)*dot(q3)*cos(q2 + q3) + 0.0175*dot(q2)^2*cos(q2 + q3)
    + 0.0175*dot(q3)^2*cos(q2 + q3) - 997/1875*dot(q1)*dot(q2)*sin(q2)*cos(q2)
    - 4873/60000*dot(q1)*dot(q2)*sin(q2 + q3)*cos(q2 + q3) - 0.14*dot(q1)*dot(q2)*sin(q3 + 2*q2)
    - 0.14*dot(q1)*dot(q3)*cos(q2)*sin(q2 + q3) - 4873/60000*dot(q1)*dot(q3)*sin(q2 + q3)*cos(q2 + q3)
b[q2] = 997/3750*dot(q1)^2*sin(q2)*cos(q2) + 4873/120000*dot(q1)^2*sin(q2 + q3)*cos(q2 + q3)
    + 0.07*dot(q1)^2*sin(q3 + 2*q2) - 0.14*dot(q2)*dot(q3)*sin(q3) - 0.07*dot(q3)^2*sin(q3) - 7.848*cos(q2)
    - 1.71675*cos(q2 + q3)
b[q3] = 0.07*dot(q2)^2*sin(q3) + 4873/120000*dot(q1)^2*sin(q2 + q3)*cos(q2 + q3) + 0.07*dot(q1)^2*cos(q2)*sin(q2 + q3)
    - 1.71675*cos(q2 + q3)
Q[q1] = -(0.4*dot(q1) + push*(sin(q1)*(0.4*cos(q2) + 0.35*cos(q2 + q3)) + 0.1*cos(q1)))
Q[q2] = -(0.4*dot(q2) + push*cos(q1)*(0.4*sin(q2) + 0.35*sin(q2 + q3)))
Q[q3] = -(0.2*dot(q3) + 0.35*push*cos(q1)*sin(q2 + q3))
```

# Constants, computed by `new`

```text
k0 = 0.35*push
k1 = 0.4*push
k2 = 0.1*push
```
*/
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Arm<T = f64> {
        params: ArmParams,
        constants: [T; 3],
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl Arm {
        /// Builds the model: checks the parameters, and computes once whatever depends on them alone.
        ///
        /// # Errors
        ///
        /// The first parameter, or combination of parameters, that is not finite or that no rigid body can
        /// have.
        pub fn new(
            params: ArmParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            #[inline]
            fn rules<T: ::pendulum_core::real::Real>(given: [T; 1]) -> [T; 0] {
                let [p_push] = given;
                []
            }
            #[inline]
            fn constants<T: ::pendulum_core::real::Real>(given: [T; 1]) -> [T; 3] {
                let [p_push] = given;
                [
                    T::from_f64(0.35) * p_push,
                    T::from_f64(0.4) * p_push,
                    T::from_f64(0.1) * p_push,
                ]
            }
            let given = params.to_array();
            for (name, value) in ArmParams::NAMES.into_iter().zip(given) {
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
            let names: [&'static str; 3] = ["0.35*push", "0.4*push", "0.1*push"];
            for (name, value) in names.into_iter().zip(constants) {
                if !value.is_finite() {
                    let given: [_; 1] = ::core::array::from_fn(|n| (
                        ArmParams::NAMES[n],
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
        pub fn cast<T: ::pendulum_core::real::Real>(&self) -> Arm<T> {
            Arm {
                params: self.params,
                constants: self.constants.map(T::from_f64),
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> Arm<T> {
        /// The parameters that the model was built from.
        pub fn params(&self) -> &ArmParams {
            &self.params
        }
        /// The model with other parameters, in the same number type. Its constants are computed anew.
        ///
        /// # Errors
        ///
        /// Those of `new`.
        pub fn with_params(
            &self,
            params: ArmParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            Ok(<Arm>::new(params)?.cast())
        }
    }
    impl Arm {
        ///The place of `q1` in the state, where it stands in rad.
        pub const Q1: usize = 0;
        ///The place of `dot(q1)` in the state, where it stands in rad/s.
        pub const DOT_Q1: usize = 3;
        ///The place of `q2` in the state, where it stands in rad.
        pub const Q2: usize = 1;
        ///The place of `dot(q2)` in the state, where it stands in rad/s.
        pub const DOT_Q2: usize = 4;
        ///The place of `q3` in the state, where it stands in rad.
        pub const Q3: usize = 2;
        ///The place of `dot(q3)` in the state, where it stands in rad/s.
        pub const DOT_Q3: usize = 5;
        /// The number of degrees of freedom; the state has twice as many components.
        pub const DOF: usize = 3;
        /// The names of the coordinates, in the order in which they, and then their rates, stand in the state.
        pub const COORDINATES: [&'static str; 3] = ["q1", "q2", "q3"];
        /// Counted operations of each generated function, in the form that it has and in others.
        pub const COST: ::pendulum_core::Cost = ::pendulum_core::Cost::new(
            &[
                (
                    "rhs",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, expanded, L^T D L",
                            ::pendulum_core::Operations::new(44, 77, 2, 3, 0, 44),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first, L^T D L",
                                    ::pendulum_core::Operations::new(46, 76, 2, 3, 0, 44),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, L^T D L",
                                    ::pendulum_core::Operations::new(46, 76, 2, 3, 0, 44),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion with wrenches on links, L^T D L",
                                    ::pendulum_core::Operations::new(53, 69, 3, 3, 0, 49),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "articulated bodies with wrenches on links",
                                    ::pendulum_core::Operations::new(65, 83, 3, 3, 0, 63),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C, L^T D L",
                                    ::pendulum_core::Operations::new(93, 101, 3, 3, 0, 58),
                                ),
                            ],
                        ),
                ),
                (
                    "kinetic",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(13, 22, 0, 2, 0, 30),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(12, 23, 0, 2, 0, 29),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(12, 23, 0, 2, 0, 30),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(23, 28, 0, 2, 0, 34),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C",
                                    ::pendulum_core::Operations::new(48, 43, 0, 2, 0, 37),
                                ),
                            ],
                        ),
                ),
                (
                    "potential",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(3, 2, 0, 2, 0, 23),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(3, 2, 0, 2, 0, 23),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(3, 2, 0, 2, 0, 23),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C",
                                    ::pendulum_core::Operations::new(4, 3, 0, 2, 0, 25),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(4, 3, 0, 2, 0, 25),
                                ),
                            ],
                        ),
                ),
                (
                    "mass_matrix",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(8, 14, 0, 2, 0, 25),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(8, 14, 0, 2, 0, 25),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(8, 14, 0, 2, 0, 25),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(15, 14, 0, 2, 0, 29),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C",
                                    ::pendulum_core::Operations::new(40, 30, 0, 2, 0, 30),
                                ),
                            ],
                        ),
                ),
                (
                    "bias",
                    ::pendulum_core::FunctionCost::new(
                            "recursion",
                            ::pendulum_core::Operations::new(22, 33, 0, 2, 0, 30),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(19, 40, 0, 2, 0, 29),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(20, 42, 0, 2, 0, 30),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(20, 42, 0, 2, 0, 30),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C",
                                    ::pendulum_core::Operations::new(46, 52, 0, 2, 0, 34),
                                ),
                            ],
                        ),
                ),
                (
                    "hand",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(6, 8, 0, 3, 0, 25),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(6, 8, 0, 3, 0, 25),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(6, 8, 0, 3, 0, 25),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(6, 8, 0, 3, 0, 25),
                                ),
                            ],
                        ),
                ),
                (
                    "hand_rate",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of parameters first",
                            ::pendulum_core::Operations::new(10, 14, 0, 3, 0, 27),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(10, 15, 0, 3, 0, 27),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(10, 16, 0, 3, 0, 25),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "as declared",
                                    ::pendulum_core::Operations::new(11, 16, 0, 3, 0, 27),
                                ),
                            ],
                        ),
                ),
                (
                    "hand_and_jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(12, 13, 0, 3, 0, 25),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(12, 13, 0, 3, 0, 25),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(12, 13, 0, 3, 0, 25),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(17, 18, 0, 3, 0, 24),
                                ),
                            ],
                        ),
                ),
                (
                    "wrist",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(3, 4, 0, 2, 0, 22),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(3, 4, 0, 2, 0, 22),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(3, 4, 0, 2, 0, 22),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(3, 4, 0, 2, 0, 22),
                                ),
                            ],
                        ),
                ),
                (
                    "wrist_rate",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(11, 12, 0, 2, 0, 24),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(11, 12, 0, 2, 0, 24),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(11, 12, 0, 2, 0, 24),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(13, 16, 0, 2, 0, 24),
                                ),
                            ],
                        ),
                ),
                (
                    "wrist_and_jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(8, 4, 0, 2, 0, 22),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(8, 4, 0, 2, 0, 22),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(8, 4, 0, 2, 0, 22),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(8, 4, 0, 2, 0, 22),
                                ),
                            ],
                        ),
                ),
                (
                    "outputs",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(8, 12, 0, 3, 0, 25),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(8, 12, 0, 3, 0, 25),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(8, 12, 0, 3, 0, 25),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(8, 12, 0, 3, 0, 25),
                                ),
                            ],
                        ),
                ),
                (
                    "output_rates",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of parameters first",
                            ::pendulum_core::Operations::new(19, 24, 0, 3, 0, 27),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "as declared",
                                    ::pendulum_core::Operations::new(20, 25, 0, 3, 0, 27),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(20, 26, 0, 3, 0, 27),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(22, 32, 0, 3, 0, 25),
                                ),
                            ],
                        ),
                ),
                (
                    "outputs_and_jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(19, 17, 0, 3, 0, 25),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(19, 17, 0, 3, 0, 25),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(19, 17, 0, 3, 0, 25),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(24, 22, 0, 3, 0, 24),
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
                            "q1",
                            ::pendulum_core::SlotKind::Angle,
                            0..1,
                            3..4,
                        )
                        .periodic(),
                    ::pendulum_core::Slot::new(
                            "q2",
                            ::pendulum_core::SlotKind::Angle,
                            1..2,
                            4..5,
                        )
                        .periodic(),
                    ::pendulum_core::Slot::new(
                            "q3",
                            ::pendulum_core::SlotKind::Angle,
                            2..3,
                            5..6,
                        )
                        .periodic(),
                ],
            )
            .autonomous();
        /// The equations of motion as text.
        pub const EQUATIONS: &'static str = "A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q all other forces\n\nA[q1, q1] = 0.343925 + 0.14*cos(q2)*cos(q2 + q3) - 997/3750*sin(q2)^2 - 4873/120000*sin(q2 + q3)^2\nA[q1, q2] = 0.0175*sin(q2 + q3) + 0.08*sin(q2)\nA[q1, q3] = 0.0175*sin(q2 + q3)\nA[q2, q2] = 0.308525 + 0.14*cos(q3)\nA[q2, q3] = 4927/120000 + 0.07*cos(q3)\nA[q3, q3] = 4927/120000\nb[q1] = 0.08*dot(q2)^2*cos(q2) + 0.035*dot(q2)*dot(q3)*cos(q2 + q3) + 0.0175*dot(q2)^2*cos(q2 + q3)\n    + 0.0175*dot(q3)^2*cos(q2 + q3) - 997/1875*dot(q1)*dot(q2)*sin(q2)*cos(q2)\n    - 4873/60000*dot(q1)*dot(q2)*sin(q2 + q3)*cos(q2 + q3) - 0.14*dot(q1)*dot(q2)*sin(q3 + 2*q2)\n    - 0.14*dot(q1)*dot(q3)*cos(q2)*sin(q2 + q3) - 4873/60000*dot(q1)*dot(q3)*sin(q2 + q3)*cos(q2 + q3)\nb[q2] = 997/3750*dot(q1)^2*sin(q2)*cos(q2) + 4873/120000*dot(q1)^2*sin(q2 + q3)*cos(q2 + q3)\n    + 0.07*dot(q1)^2*sin(q3 + 2*q2) - 0.14*dot(q2)*dot(q3)*sin(q3) - 0.07*dot(q3)^2*sin(q3) - 7.848*cos(q2)\n    - 1.71675*cos(q2 + q3)\nb[q3] = 0.07*dot(q2)^2*sin(q3) + 4873/120000*dot(q1)^2*sin(q2 + q3)*cos(q2 + q3) + 0.07*dot(q1)^2*cos(q2)*sin(q2 + q3)\n    - 1.71675*cos(q2 + q3)\nQ[q1] = -(0.4*dot(q1) + push*(sin(q1)*(0.4*cos(q2) + 0.35*cos(q2 + q3)) + 0.1*cos(q1)))\nQ[q2] = -(0.4*dot(q2) + push*cos(q1)*(0.4*sin(q2) + 0.35*sin(q2 + q3)))\nQ[q3] = -(0.2*dot(q3) + 0.35*push*cos(q1)*sin(q2 + q3))\n";
        ///The names of the components of all outputs.
        pub const OUTPUTS: [&'static str; 12] = [
            "hand.x",
            "hand.y",
            "hand.z",
            "wrist[0, 0]",
            "wrist[1, 0]",
            "wrist[2, 0]",
            "wrist[0, 1]",
            "wrist[1, 1]",
            "wrist[2, 1]",
            "wrist[0, 2]",
            "wrist[1, 2]",
            "wrist[2, 2]",
        ];
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::System<T, 6> for Arm<T> {
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn rhs(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 6>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 6> {
            let [q_q1, q_q2, q_q3, qd_q1, qd_q2, qd_q3] = x.data.0[0];
            let k0 = self.constants[0];
            let k1 = self.constants[1];
            let k2 = self.constants[2];
            let t0 = qd_q1 * qd_q1;
            let t1 = T::from_f64(0.07) * t0;
            let t2 = T::from_f64(0.14) * qd_q1;
            let (sin_q3, cos_q3) = q_q3.sin_cos();
            let t3 = T::from_f64(0.041058333333333336) + T::from_f64(0.07) * cos_q3;
            let t4 = T::from_f64(24.355591637913538) * t3;
            let t5 = T::from_f64(-1.0)
                / (T::from_f64(0.308525) + T::from_f64(0.14) * cos_q3 - t3 * t4);
            let [(sin_q2, cos_q2), (sin_q1, cos_q1)] = q_q2.sin_cos_pair(q_q1);
            let t6 = cos_q2 * cos_q3 - sin_q2 * sin_q3;
            let t7 = sin_q2 * cos_q3 + cos_q2 * sin_q3;
            let t8 = T::from_f64(0.0175) * t7;
            let t9 = t8 + T::from_f64(0.08) * sin_q2 - t8 * t4;
            let t10 = t9 * t5;
            let t11 = T::from_f64(0.343925) + T::from_f64(0.14) * cos_q2 * t6 + t9 * t10
                - T::from_f64(0.26586666666666664) * sin_q2 * sin_q2;
            let t12 = T::from_f64(0.04060833333333334) * t7;
            let t13 = T::from_f64(0.4262228536634869) * t7;
            let t14 = cos_q2 * t7;
            let t15 = sin_q2 * t6 + t14;
            let t16 = T::from_f64(0.4) * qd_q2 + t15 * t1
                + sin_q2
                    * (k1 * cos_q1 + t0 * (T::from_f64(0.26586666666666664) * cos_q2));
            let t17 = T::from_f64(1.71675) * t6 - (k0 * t7 * cos_q1 + t6 * t0 * t12);
            let t18 = T::from_f64(0.2) * qd_q3
                + qd_q2 * qd_q2 * (T::from_f64(0.07) * sin_q3) + t14 * t1 - t17;
            let t19 = t16 - T::from_f64(7.848) * cos_q2 - t4 * t18
                - sin_q3
                    * (qd_q3 * (T::from_f64(0.14) * qd_q2 + T::from_f64(0.07) * qd_q3));
            let t20 = t19 - t17;
            let t21 = t7 * (T::from_f64(0.08121666666666667) * qd_q1);
            let t22 = k0 * sin_q1
                + qd_q3
                    * (T::from_f64(0.0175) * qd_q3 + T::from_f64(0.035) * qd_q2 - t21)
                + qd_q2 * (T::from_f64(0.0175) * qd_q2 - t21);
            let t23 = k1 * sin_q1
                + qd_q2
                    * (T::from_f64(0.08) * qd_q2
                        - T::from_f64(0.5317333333333333) * (sin_q2 * qd_q1))
                - t7 * (qd_q3 * t2);
            let t24 = k2 * cos_q1 + T::from_f64(0.4) * qd_q1 + t10 * t20 + t6 * t22
                + cos_q2 * t23;
            let t25 = T::from_f64(-1.0) / (t11 - t7 * t12 - t8 * t13)
                * (t24 - qd_q2 * t2 * t15 - t13 * t18);
            let t26 = t5 * t20 + t10 * t25;
            ::pendulum_core::nalgebra::SVector::from([
                qd_q1,
                qd_q2,
                qd_q3,
                t25,
                t26,
                -(T::from_f64(24.355591637913538) * t18 + t13 * t25 + t4 * t26),
            ])
        }
        #[inline]
        fn layout(
            &self,
        ) -> ::core::option::Option<&'static ::pendulum_core::StateLayout> {
            Some(&<Arm>::LAYOUT)
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Energy<T, 6> for Arm<T> {
        #[inline]
        fn kinetic(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 6>) -> T {
            let [_, q_q2, q_q3, qd_q1, qd_q2, qd_q3] = x.data.0[0];
            let [(sin_q3, cos_q3), (sin_q2, cos_q2)] = q_q3.sin_cos_pair(q_q2);
            let t0 = T::from_f64(0.07) * cos_q3;
            let t1 = T::from_f64(0.020529166666666668) * qd_q3 * qd_q3
                + qd_q2
                    * (qd_q3 * (T::from_f64(0.041058333333333336) + t0)
                        + qd_q2 * (T::from_f64(0.1542625) + t0));
            let t2 = cos_q3 * sin_q2 + cos_q2 * sin_q3;
            let t3 = T::from_f64(0.0175) * t2;
            let t4 = T::from_f64(0.1719625)
                + T::from_f64(0.07) * cos_q2 * (cos_q3 * cos_q2 - sin_q2 * sin_q3)
                - T::from_f64(0.13293333333333332) * sin_q2 * sin_q2;
            let t5 = qd_q3 * t3 + qd_q2 * (T::from_f64(0.08) * sin_q2 + t3)
                + qd_q1 * (t4 - T::from_f64(0.02030416666666667) * t2 * t2);
            t1 + qd_q1 * t5
        }
        #[inline]
        fn potential(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 6>) -> T {
            let [_, q_q2, q_q3, _, _, _] = x.data.0[0];
            let [(sin_q2, _), (sin0, _)] = q_q2.sin_cos_pair(q_q2 + q_q3);
            T::from_f64(13.2435) - T::from_f64(7.848) * sin_q2
                - T::from_f64(1.71675) * sin0
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> Arm<T> {
        ///The mass matrix.
        #[inline]
        pub fn mass_matrix(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 6>,
        ) -> ::pendulum_core::nalgebra::SMatrix<T, 3, 3> {
            let [_, q_q2, q_q3, _, _, _] = x.data.0[0];
            let [(sin_q2, cos_q2), (sin_q3, cos_q3)] = q_q2.sin_cos_pair(q_q3);
            let t0 = T::from_f64(0.343925)
                - sin_q2 * (T::from_f64(0.26586666666666664) * sin_q2)
                + T::from_f64(0.14) * cos_q2 * (cos_q2 * cos_q3 - sin_q2 * sin_q3);
            let t1 = sin_q2 * cos_q3 + cos_q2 * sin_q3;
            let t2 = T::from_f64(0.0175) * t1;
            let a0 = t0 - t1 * (T::from_f64(0.04060833333333334) * t1);
            let a1 = T::from_f64(0.08) * sin_q2 + t2;
            let a2 = t2;
            let a3 = T::from_f64(0.308525) + T::from_f64(0.14) * cos_q3;
            let a4 = T::from_f64(0.041058333333333336) + T::from_f64(0.07) * cos_q3;
            let a5 = T::from_f64(0.041058333333333336);
            ::pendulum_core::nalgebra::SMatrix::from([
                [a0, a1, a2],
                [a1, a3, a4],
                [a2, a4, a5],
            ])
        }
        ///The bias: velocity terms, gravity and the inertia forces of the drives, as generalised forces.
        #[inline]
        pub fn bias(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 6>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 3> {
            let [_, q_q2, q_q3, qd_q1, qd_q2, qd_q3] = x.data.0[0];
            let t0 = q_q2 + q_q3;
            let t1 = qd_q1 * qd_q1;
            let t2 = qd_q2 * qd_q2;
            let t3 = t1 + t2;
            let t4 = qd_q2 + qd_q3;
            let t5 = t4 * t4;
            let t6 = t1 + t5;
            let t7 = T::from_f64(0.1) * t1;
            let t8 = qd_q1 * qd_q2;
            let t9 = T::from_f64(2.0) * t8;
            let [(sin_q2, cos_q2), (sin10, cos10)] = q_q2.sin_cos_pair(t0);
            let t11 = T::from_f64(0.8) * cos_q2;
            let t12 = T::from_f64(0.175) * cos10;
            let t13 = t12 * t6;
            let t14 = T::from_f64(0.26586666666666664) * cos_q2 * sin_q2;
            let t15 = T::from_f64(0.4) * sin_q2;
            let t16 = T::from_f64(0.1) * (t11 * t3 + t13) - t11 * t7 - t9 * t14
                - t12 * (t7 + t9 * t15);
            let t17 = T::from_f64(0.04060833333333334) * cos10 * sin10;
            let t18 = T::from_f64(0.4) * cos_q2 * (T::from_f64(0.175) * sin10);
            let t19 = t3 * t18 - t12 * (T::from_f64(9.81) + t2 * t15) - t17 * (t5 - t6);
            ::pendulum_core::nalgebra::SVector::from([
                t16 - (t8 + qd_q1 * (qd_q3 + t4)) * (t17 + t18),
                t19 + t13 * t15 - t5 * t18 - T::from_f64(7.848) * cos_q2
                    - t14 * (t2 - t3),
                t19,
            ])
        }
        ///Output `hand`.
        #[inline]
        pub fn hand(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 6>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 3> {
            let [q_q1, q_q2, q_q3, _, _, _] = x.data.0[0];
            let t0 = q_q2 + q_q3;
            let (sin1, cos1) = t0.sin_cos();
            let [(sin_q1, cos_q1), (sin_q2, cos_q2)] = q_q1.sin_cos_pair(q_q2);
            let t2 = T::from_f64(0.4) * cos_q2 + T::from_f64(0.35) * cos1;
            ::pendulum_core::nalgebra::SVector::from([
                cos_q1 * t2 - T::from_f64(0.1) * sin_q1,
                sin_q1 * t2 + T::from_f64(0.1) * cos_q1,
                T::from_f64(0.3) - T::from_f64(0.4) * sin_q2 - T::from_f64(0.35) * sin1,
            ])
        }
        ///The rate of `hand` along the motion.
        #[inline]
        pub fn hand_rate(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 6>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 3> {
            let [q_q1, q_q2, q_q3, qd_q1, qd_q2, qd_q3] = x.data.0[0];
            let t0 = q_q2 + q_q3;
            let (sin1, cos1) = t0.sin_cos();
            let t2 = T::from_f64(0.35) * cos1;
            let t3 = qd_q2 + qd_q3;
            let t4 = T::from_f64(0.4) * qd_q2;
            let [(sin_q1, cos_q1), (sin_q2, cos_q2)] = q_q1.sin_cos_pair(q_q2);
            let t5 = T::from_f64(0.35) * sin1 * t3 + T::from_f64(0.1) * qd_q1
                + t4 * sin_q2;
            let t6 = qd_q1 * (T::from_f64(0.4) * cos_q2 + t2);
            ::pendulum_core::nalgebra::SVector::from([
                -(sin_q1 * t6 + cos_q1 * t5),
                cos_q1 * t6 - sin_q1 * t5,
                -(t2 * t3 + cos_q2 * t4),
            ])
        }
        ///The value of `hand`, and its derivatives by the state: a row for each component, column by column for a matrix.
        #[inline]
        pub fn hand_and_jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 6>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 3>,
            ::pendulum_core::nalgebra::SMatrix<T, 3, 6>,
        ) {
            let [q_q1, q_q2, q_q3, _, _, _] = x.data.0[0];
            let t0 = q_q2 + q_q3;
            let (sin1, cos1) = t0.sin_cos();
            let t2 = T::from_f64(-0.35) * cos1;
            let t3 = T::from_f64(0.35) * sin1;
            let [(sin_q1, cos_q1), (sin_q2, cos_q2)] = q_q1.sin_cos_pair(q_q2);
            let t4 = T::from_f64(0.4) * cos_q2 + T::from_f64(0.35) * cos1;
            let t5 = -t4;
            let t6 = -(cos_q1 * t3);
            let t7 = -(sin_q1 * t3);
            let t8 = T::from_f64(0.4) * sin_q2 + t3;
            let t9 = T::from_f64(0.3) - t8;
            let t10 = -(cos_q1 * t8);
            let t11 = -(sin_q1 * t8);
            let t12 = cos_q1 * t4 - T::from_f64(0.1) * sin_q1;
            let t13 = t4 * sin_q1 + T::from_f64(0.1) * cos_q1;
            let t14 = -t13;
            (
                ::pendulum_core::nalgebra::SVector::from([t12, t13, t9]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [t14, t12, T::from_f64(0.0)],
                    [t10, t11, t5],
                    [t6, t7, t2],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                ]),
            )
        }
        ///Output `wrist`.
        #[inline]
        pub fn wrist(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 6>,
        ) -> ::pendulum_core::nalgebra::SMatrix<T, 3, 3> {
            let [q_q1, q_q2, q_q3, _, _, _] = x.data.0[0];
            let t0 = q_q2 + q_q3;
            let [(sin_q1, cos_q1), (sin1, cos1)] = q_q1.sin_cos_pair(t0);
            let t2 = cos_q1 * cos1;
            let t3 = sin_q1 * cos1;
            let t4 = -sin1;
            let t5 = -sin_q1;
            let t6 = cos_q1 * sin1;
            let t7 = sin_q1 * sin1;
            ::pendulum_core::nalgebra::SMatrix::from([
                [t2, t3, t4],
                [t5, cos_q1, T::from_f64(0.0)],
                [t6, t7, cos1],
            ])
        }
        ///The rate of `wrist` along the motion.
        #[inline]
        pub fn wrist_rate(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 6>,
        ) -> ::pendulum_core::nalgebra::SMatrix<T, 3, 3> {
            let [q_q1, q_q2, q_q3, qd_q1, qd_q2, qd_q3] = x.data.0[0];
            let t0 = q_q2 + q_q3;
            let t1 = qd_q2 + qd_q3;
            let [(sin2, cos2), (sin_q1, cos_q1)] = t0.sin_cos_pair(q_q1);
            let t3 = qd_q1 * sin_q1;
            let t4 = -t3;
            let t5 = sin2 * t1;
            let t6 = -(cos2 * t3 + cos_q1 * t5);
            let t7 = cos2 * t1;
            let t8 = cos_q1 * t7 - sin2 * t3;
            let t9 = -t7;
            let t10 = -t5;
            let t11 = qd_q1 * cos_q1;
            let t12 = cos2 * t11 - sin_q1 * t5;
            let t13 = sin2 * t11 + sin_q1 * t7;
            let t14 = -t11;
            ::pendulum_core::nalgebra::SMatrix::from([
                [t6, t12, t9],
                [t14, t4, T::from_f64(0.0)],
                [t8, t13, t10],
            ])
        }
        ///The value of `wrist`, and its derivatives by the state: a row for each component, column by column for a matrix.
        #[inline]
        pub fn wrist_and_jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 6>,
        ) -> (
            ::pendulum_core::nalgebra::SMatrix<T, 3, 3>,
            ::pendulum_core::nalgebra::SMatrix<T, 9, 6>,
        ) {
            let [q_q1, q_q2, q_q3, _, _, _] = x.data.0[0];
            let t0 = q_q2 + q_q3;
            let [(sin_q1, cos_q1), (sin1, cos1)] = q_q1.sin_cos_pair(t0);
            let t2 = -cos_q1;
            let t3 = cos_q1 * cos1;
            let t4 = sin_q1 * cos1;
            let t5 = -t4;
            let t6 = -sin1;
            let t7 = -sin_q1;
            let t8 = cos_q1 * sin1;
            let t9 = -t8;
            let t10 = sin_q1 * sin1;
            let t11 = -cos1;
            let t12 = -t10;
            (
                ::pendulum_core::nalgebra::SMatrix::from([
                    [t3, t4, t6],
                    [t7, cos_q1, T::from_f64(0.0)],
                    [t8, t10, cos1],
                ]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [
                        t5,
                        t3,
                        T::from_f64(0.0),
                        t2,
                        t7,
                        T::from_f64(0.0),
                        t12,
                        t8,
                        T::from_f64(0.0),
                    ],
                    [
                        t9,
                        t12,
                        t11,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t3,
                        t4,
                        t6,
                    ],
                    [
                        t9,
                        t12,
                        t11,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t3,
                        t4,
                        t6,
                    ],
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
                    ],
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
                    ],
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
                    ],
                ]),
            )
        }
        ///All outputs, in the order of `OUTPUTS`.
        #[inline]
        pub fn outputs(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 6>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 12> {
            let [q_q1, q_q2, q_q3, _, _, _] = x.data.0[0];
            let t0 = q_q2 + q_q3;
            let (sin1, cos1) = t0.sin_cos();
            let t2 = -sin1;
            let [(sin_q1, cos_q1), (sin_q2, cos_q2)] = q_q1.sin_cos_pair(q_q2);
            let t3 = T::from_f64(0.3) - T::from_f64(0.4) * sin_q2
                - T::from_f64(0.35) * sin1;
            let t4 = cos_q1 * cos1;
            let t5 = sin_q1 * cos1;
            let t6 = -sin_q1;
            let t7 = cos_q1 * sin1;
            let t8 = sin_q1 * sin1;
            let t9 = T::from_f64(0.4) * cos_q2 + T::from_f64(0.35) * cos1;
            let t10 = cos_q1 * t9 - T::from_f64(0.1) * sin_q1;
            let t11 = sin_q1 * t9 + T::from_f64(0.1) * cos_q1;
            ::pendulum_core::nalgebra::SVector::from([
                t10,
                t11,
                t3,
                t4,
                t5,
                t2,
                t6,
                cos_q1,
                T::from_f64(0.0),
                t7,
                t8,
                cos1,
            ])
        }
        ///The rate of all outputs along the motion.
        #[inline]
        pub fn output_rates(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 6>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 12> {
            let [q_q1, q_q2, q_q3, qd_q1, qd_q2, qd_q3] = x.data.0[0];
            let t0 = q_q2 + q_q3;
            let (sin1, cos1) = t0.sin_cos();
            let t2 = qd_q2 + qd_q3;
            let t3 = sin1 * t2;
            let t4 = cos1 * t2;
            let t5 = -t4;
            let t6 = -t3;
            let t7 = T::from_f64(0.4) * qd_q2;
            let [(sin_q2, cos_q2), (sin_q1, cos_q1)] = q_q2.sin_cos_pair(q_q1);
            let t8 = -(T::from_f64(0.35) * t4 + cos_q2 * t7);
            let t9 = T::from_f64(0.35) * t3 + T::from_f64(0.1) * qd_q1 + t7 * sin_q2;
            let t10 = T::from_f64(0.4) * cos_q2 + T::from_f64(0.35) * cos1;
            let t11 = qd_q1 * sin_q1;
            let t12 = -(t10 * t11 + cos_q1 * t9);
            let t13 = -(cos1 * t11 + cos_q1 * t3);
            let t14 = -t11;
            let t15 = cos_q1 * t4 - sin1 * t11;
            let t16 = qd_q1 * cos_q1;
            let t17 = t10 * t16 - sin_q1 * t9;
            let t18 = cos1 * t16 - sin_q1 * t3;
            let t19 = sin1 * t16 + sin_q1 * t4;
            let t20 = -t16;
            ::pendulum_core::nalgebra::SVector::from([
                t12,
                t17,
                t8,
                t13,
                t18,
                t5,
                t20,
                t14,
                T::from_f64(0.0),
                t15,
                t19,
                t6,
            ])
        }
        ///The value of all outputs, and its derivatives by the state: a row for each component, column by column for a matrix.
        #[inline]
        pub fn outputs_and_jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 6>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 12>,
            ::pendulum_core::nalgebra::SMatrix<T, 12, 6>,
        ) {
            let [q_q1, q_q2, q_q3, _, _, _] = x.data.0[0];
            let t0 = q_q2 + q_q3;
            let (sin1, cos1) = t0.sin_cos();
            let t2 = T::from_f64(-0.35) * cos1;
            let t3 = T::from_f64(0.35) * sin1;
            let t4 = -sin1;
            let t5 = -cos1;
            let [(sin_q1, cos_q1), (sin_q2, cos_q2)] = q_q1.sin_cos_pair(q_q2);
            let t6 = -cos_q1;
            let t7 = -(cos_q1 * t3);
            let t8 = -(sin_q1 * t3);
            let t9 = T::from_f64(0.4) * sin_q2 + t3;
            let t10 = T::from_f64(0.3) - t9;
            let t11 = -(cos_q1 * t9);
            let t12 = -(sin_q1 * t9);
            let t13 = T::from_f64(0.4) * cos_q2 + T::from_f64(0.35) * cos1;
            let t14 = -t13;
            let t15 = cos_q1 * t13 - T::from_f64(0.1) * sin_q1;
            let t16 = t13 * sin_q1 + T::from_f64(0.1) * cos_q1;
            let t17 = -t16;
            let t18 = cos_q1 * cos1;
            let t19 = cos1 * sin_q1;
            let t20 = -t19;
            let t21 = -sin_q1;
            let t22 = cos_q1 * sin1;
            let t23 = sin_q1 * sin1;
            let t24 = -t23;
            let t25 = -t22;
            (
                ::pendulum_core::nalgebra::SVector::from([
                    t15,
                    t16,
                    t10,
                    t18,
                    t19,
                    t4,
                    t21,
                    cos_q1,
                    T::from_f64(0.0),
                    t22,
                    t23,
                    cos1,
                ]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [
                        t17,
                        t15,
                        T::from_f64(0.0),
                        t20,
                        t18,
                        T::from_f64(0.0),
                        t6,
                        t21,
                        T::from_f64(0.0),
                        t24,
                        t22,
                        T::from_f64(0.0),
                    ],
                    [
                        t11,
                        t12,
                        t14,
                        t25,
                        t24,
                        t5,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t18,
                        t19,
                        t4,
                    ],
                    [
                        t7,
                        t8,
                        t2,
                        t25,
                        t24,
                        t5,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t18,
                        t19,
                        t4,
                    ],
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
    impl ::pendulum_core::shapes::Shapes<6> for Arm {
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
                        name: "base",
                        kind: ::pendulum_core::shapes::ShapeKind::Cylinder,
                        points: 2,
                        radius: true,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "boom",
                        kind: ::pendulum_core::shapes::ShapeKind::Cylinder,
                        points: 2,
                        radius: true,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "forearm",
                        kind: ::pendulum_core::shapes::ShapeKind::Cylinder,
                        points: 2,
                        radius: true,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "base",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "boom",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "forearm",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "hand",
                        kind: ::pendulum_core::shapes::ShapeKind::Point,
                        points: 1,
                        radius: false,
                    },
                ],
                &{
                    let [q_q1, q_q2, q_q3, _, _, _] = x.data.0[0];
                    let t0 = q_q2 + q_q3;
                    let (sin1, cos1) = t0.sin_cos();
                    let t2 = T::from_f64(0.35) * cos1;
                    let [(sin_q1, cos_q1), (sin_q2, cos_q2)] = q_q1.sin_cos_pair(q_q2);
                    let t3 = T::from_f64(-0.1) * sin_q1;
                    let t4 = T::from_f64(0.1) * cos_q1;
                    let t5 = T::from_f64(0.4) * cos_q2;
                    let t6 = t4 + sin_q1 * t5;
                    let t7 = cos_q1 * t5 - T::from_f64(0.1) * sin_q1;
                    let t8 = t7 + cos_q1 * t2;
                    let t9 = t6 + sin_q1 * t2;
                    let t10 = T::from_f64(0.3) - T::from_f64(0.4) * sin_q2;
                    let t11 = t10 - T::from_f64(0.35) * sin1;
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.3),
                        T::from_f64(0.06),
                        t3,
                        t4,
                        T::from_f64(0.3),
                        t7,
                        t6,
                        t10,
                        T::from_f64(0.04),
                        t7,
                        t6,
                        t10,
                        t8,
                        t9,
                        t11,
                        T::from_f64(0.03),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t3,
                        t4,
                        T::from_f64(0.3),
                        t7,
                        t6,
                        t10,
                        t8,
                        t9,
                        t11,
                    ]
                },
            )
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::Cast<6> for Arm {
        type In<T: ::pendulum_core::real::Real> = Arm<T>;
        fn cast<T: ::pendulum_core::real::Real>(&self) -> Arm<T> {
            Arm::cast(self)
        }
        #[inline]
        fn gather<'m, T: ::pendulum_core::real::lanes::Lanes>(
            models: impl ::core::ops::Fn(usize) -> &'m Self,
        ) -> Arm<T>
        where
            Self: 'm,
        {
            let scalar = <<T as ::pendulum_core::real::lanes::Lanes>::Scalar as ::pendulum_core::real::Real>::from_f64;
            Arm {
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
pub use __Arm::{Arm, ArmParams};
