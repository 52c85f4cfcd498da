#[allow(non_snake_case)]
mod __CartPole {
    ///Parameters of [`CartPole`].
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct CartPoleParams {}
    impl ::core::default::Default for CartPoleParams {
        #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
        fn default() -> Self {
            Self {}
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl CartPoleParams {
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
    /// A pole on a cart.
    ///
    /**# Equations of motion

```text
A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints

A[s, s] = 2.4
A[s, theta] = 0.24*cos(theta)
A[theta, theta] = 0.194
b[s] = -0.24*dot(theta)^2*sin(theta)
b[theta] = 2.3544*sin(theta)
Q[s] = -0.2*dot(s)
Q[theta] = -0.01*dot(theta)
```
*/
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct CartPole<T = f64> {
        params: CartPoleParams,
        constants: [T; 0],
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl CartPole {
        /// Builds the model: checks the parameters, and computes once whatever depends on them alone.
        ///
        /// # Errors
        ///
        /// The first parameter, or combination of parameters, that is not finite or that no rigid body can
        /// have.
        pub fn new(
            params: CartPoleParams,
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
            for (name, value) in CartPoleParams::NAMES.into_iter().zip(given) {
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
                        CartPoleParams::NAMES[n],
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
        pub fn cast<T: ::pendulum_core::real::Real>(&self) -> CartPole<T> {
            CartPole {
                params: self.params,
                constants: self.constants.map(T::from_f64),
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> CartPole<T> {
        /// The parameters that the model was built from.
        pub fn params(&self) -> &CartPoleParams {
            &self.params
        }
        /// The model with other parameters, in the same number type. Its constants are computed anew.
        ///
        /// # Errors
        ///
        /// Those of `new`.
        pub fn with_params(
            &self,
            params: CartPoleParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            Ok(<CartPole>::new(params)?.cast())
        }
    }
    impl CartPole {
        ///The place of `s` in the state, where it stands in m.
        pub const S: usize = 0;
        ///The place of `dot(s)` in the state, where it stands in m/s.
        pub const DOT_S: usize = 2;
        ///The place of `theta` in the state, where it stands in rad.
        pub const THETA: usize = 1;
        ///The place of `dot(theta)` in the state, where it stands in rad/s.
        pub const DOT_THETA: usize = 3;
        /// The number of degrees of freedom; the state has twice as many components.
        pub const DOF: usize = 2;
        /// The names of the coordinates, in the order in which they, and then their rates, stand in the state.
        pub const COORDINATES: [&'static str; 2] = ["s", "theta"];
        /// Counted operations of each generated function, in the form that it has and in others.
        pub const COST: ::pendulum_core::Cost = ::pendulum_core::Cost::new(
            &[
                (
                    "rhs",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first, L^T D L",
                            ::pendulum_core::Operations::new(6, 13, 1, 1, 0, 30),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, L^T D L",
                                    ::pendulum_core::Operations::new(6, 13, 1, 1, 0, 30),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L",
                                    ::pendulum_core::Operations::new(6, 13, 1, 1, 0, 30),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, adjugate",
                                    ::pendulum_core::Operations::new(5, 14, 1, 1, 0, 28),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "articulated bodies",
                                    ::pendulum_core::Operations::new(7, 14, 1, 1, 0, 32),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C, adjugate",
                                    ::pendulum_core::Operations::new(11, 19, 1, 1, 0, 34),
                                ),
                            ],
                        ),
                ),
                (
                    "kinetic",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(2, 6, 0, 1, 0, 24),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(2, 6, 0, 1, 0, 24),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(2, 6, 0, 1, 0, 25),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(3, 8, 0, 1, 0, 26),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C",
                                    ::pendulum_core::Operations::new(9, 16, 0, 1, 0, 31),
                                ),
                            ],
                        ),
                ),
                (
                    "potential",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(0, 1, 0, 1, 0, 21),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(0, 1, 0, 1, 0, 21),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(0, 1, 0, 1, 0, 21),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C",
                                    ::pendulum_core::Operations::new(0, 1, 0, 1, 0, 21),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(0, 1, 0, 1, 0, 21),
                                ),
                            ],
                        ),
                ),
                (
                    "mass_matrix",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(0, 1, 0, 1, 0, 21),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(0, 1, 0, 1, 0, 21),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(0, 1, 0, 1, 0, 21),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(0, 1, 0, 1, 0, 21),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C",
                                    ::pendulum_core::Operations::new(6, 9, 0, 1, 0, 26),
                                ),
                            ],
                        ),
                ),
                (
                    "tip",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(1, 2, 0, 1, 0, 22),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(1, 2, 0, 1, 0, 22),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(1, 2, 0, 1, 0, 22),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(1, 2, 0, 1, 0, 22),
                                ),
                            ],
                        ),
                ),
                (
                    "tip_rate",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(1, 3, 0, 1, 0, 22),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(1, 3, 0, 1, 0, 22),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(1, 3, 0, 1, 0, 22),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(1, 3, 0, 1, 0, 22),
                                ),
                            ],
                        ),
                ),
                (
                    "tip_and_jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(2, 2, 0, 1, 0, 22),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(2, 2, 0, 1, 0, 22),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(2, 2, 0, 1, 0, 22),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(2, 2, 0, 1, 0, 22),
                                ),
                            ],
                        ),
                ),
                (
                    "outputs",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(1, 2, 0, 1, 0, 22),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(1, 2, 0, 1, 0, 22),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(1, 2, 0, 1, 0, 22),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(1, 2, 0, 1, 0, 22),
                                ),
                            ],
                        ),
                ),
                (
                    "output_rates",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(1, 3, 0, 1, 0, 22),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(1, 3, 0, 1, 0, 22),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(1, 3, 0, 1, 0, 22),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(1, 3, 0, 1, 0, 22),
                                ),
                            ],
                        ),
                ),
                (
                    "outputs_and_jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(2, 2, 0, 1, 0, 22),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(2, 2, 0, 1, 0, 22),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(2, 2, 0, 1, 0, 22),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(2, 2, 0, 1, 0, 22),
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
                            "s",
                            ::pendulum_core::SlotKind::Length,
                            0..1,
                            2..3,
                        )
                        .cyclic(),
                    ::pendulum_core::Slot::new(
                            "theta",
                            ::pendulum_core::SlotKind::Angle,
                            1..2,
                            3..4,
                        )
                        .periodic(),
                ],
            )
            .autonomous();
        /// The equations of motion as text.
        pub const EQUATIONS: &'static str = "A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints\n\nA[s, s] = 2.4\nA[s, theta] = 0.24*cos(theta)\nA[theta, theta] = 0.194\nb[s] = -0.24*dot(theta)^2*sin(theta)\nb[theta] = 2.3544*sin(theta)\nQ[s] = -0.2*dot(s)\nQ[theta] = -0.01*dot(theta)\n";
        ///The names of the components of all outputs.
        pub const OUTPUTS: [&'static str; 3] = ["tip.x", "tip.y", "tip.z"];
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::System<T, 4> for CartPole<T> {
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn rhs(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 4> {
            let [_, q_theta, qd_s, qd_theta] = x.data.0[0];
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            let t0 = T::from_f64(0.01) * qd_theta + T::from_f64(2.3544) * sin_theta;
            let t1 = T::from_f64(1.2371134020618557) * cos_theta;
            let t2 = T::from_f64(-0.194)
                / (T::from_f64(0.408) + sin_theta * (T::from_f64(0.0576) * sin_theta))
                * (T::from_f64(0.2) * qd_s
                    - sin_theta * (qd_theta * (T::from_f64(0.24) * qd_theta)) - t0 * t1);
            ::pendulum_core::nalgebra::SVector::from([
                qd_s,
                qd_theta,
                t2,
                -(T::from_f64(5.154639175257732) * t0 + t1 * t2),
            ])
        }
        #[inline]
        fn layout(
            &self,
        ) -> ::core::option::Option<&'static ::pendulum_core::StateLayout> {
            Some(&<CartPole>::LAYOUT)
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Energy<T, 4> for CartPole<T> {
        #[inline]
        fn kinetic(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 4>) -> T {
            let [_, q_theta, qd_s, qd_theta] = x.data.0[0];
            let (_, cos_theta) = q_theta.sin_cos();
            qd_theta * (T::from_f64(0.097) * qd_theta)
                + qd_s
                    * (cos_theta * (T::from_f64(0.24) * qd_theta)
                        + T::from_f64(1.2) * qd_s)
        }
        #[inline]
        fn potential(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 4>) -> T {
            let [_, q_theta, _, _] = x.data.0[0];
            let (_, cos_theta) = q_theta.sin_cos();
            T::from_f64(-2.3544) * cos_theta
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> CartPole<T> {
        ///The mass matrix.
        #[inline]
        pub fn mass_matrix(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SMatrix<T, 2, 2> {
            let [_, q_theta, _, _] = x.data.0[0];
            let (_, cos_theta) = q_theta.sin_cos();
            let a0 = T::from_f64(2.4);
            let a1 = T::from_f64(0.24) * cos_theta;
            let a2 = T::from_f64(0.194);
            ::pendulum_core::nalgebra::SMatrix::from([[a0, a1], [a1, a2]])
        }
        ///Output `tip`.
        #[inline]
        pub fn tip(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 3> {
            let [q_s, q_theta, _, _] = x.data.0[0];
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            ::pendulum_core::nalgebra::SVector::from([
                q_s + T::from_f64(1.2) * sin_theta,
                T::from_f64(-1.2) * cos_theta,
                T::from_f64(0.0),
            ])
        }
        ///The rate of `tip` along the motion.
        #[inline]
        pub fn tip_rate(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 3> {
            let [_, q_theta, qd_s, qd_theta] = x.data.0[0];
            let t0 = T::from_f64(1.2) * qd_theta;
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            ::pendulum_core::nalgebra::SVector::from([
                qd_s + cos_theta * t0,
                sin_theta * t0,
                T::from_f64(0.0),
            ])
        }
        ///The value of `tip`, and its derivatives by the state: a row for each component, column by column for a matrix.
        #[inline]
        pub fn tip_and_jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 3>,
            ::pendulum_core::nalgebra::SMatrix<T, 3, 4>,
        ) {
            let [q_s, q_theta, _, _] = x.data.0[0];
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            let t0 = T::from_f64(1.2) * sin_theta;
            let t1 = q_s + t0;
            let t2 = T::from_f64(1.2) * cos_theta;
            let t3 = -t2;
            (
                ::pendulum_core::nalgebra::SVector::from([t1, t3, T::from_f64(0.0)]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [T::from_f64(1.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [t2, t0, T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                ]),
            )
        }
        ///All outputs, in the order of `OUTPUTS`.
        #[inline]
        pub fn outputs(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 3> {
            let [q_s, q_theta, _, _] = x.data.0[0];
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            ::pendulum_core::nalgebra::SVector::from([
                q_s + T::from_f64(1.2) * sin_theta,
                T::from_f64(-1.2) * cos_theta,
                T::from_f64(0.0),
            ])
        }
        ///The rate of all outputs along the motion.
        #[inline]
        pub fn output_rates(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 3> {
            let [_, q_theta, qd_s, qd_theta] = x.data.0[0];
            let t0 = T::from_f64(1.2) * qd_theta;
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            ::pendulum_core::nalgebra::SVector::from([
                qd_s + cos_theta * t0,
                sin_theta * t0,
                T::from_f64(0.0),
            ])
        }
        ///The value of all outputs, and its derivatives by the state: a row for each component, column by column for a matrix.
        #[inline]
        pub fn outputs_and_jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 3>,
            ::pendulum_core::nalgebra::SMatrix<T, 3, 4>,
        ) {
            let [q_s, q_theta, _, _] = x.data.0[0];
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            let t0 = T::from_f64(1.2) * sin_theta;
            let t1 = q_s + t0;
            let t2 = T::from_f64(1.2) * cos_theta;
            let t3 = -t2;
            (
                ::pendulum_core::nalgebra::SVector::from([t1, t3, T::from_f64(0.0)]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [T::from_f64(1.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [t2, t0, T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                ]),
            )
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::shapes::Shapes<4> for CartPole {
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
                        name: "cart",
                        kind: ::pendulum_core::shapes::ShapeKind::Cuboid,
                        points: 8,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "pole",
                        kind: ::pendulum_core::shapes::ShapeKind::Mass,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "pole",
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
                    let [q_s, q_theta, _, _] = x.data.0[0];
                    let t0 = T::from_f64(0.25) + q_s;
                    let t1 = q_s - T::from_f64(0.25);
                    let (sin_theta, cos_theta) = q_theta.sin_cos();
                    let t2 = q_s + T::from_f64(0.6) * sin_theta;
                    let t3 = T::from_f64(-0.6) * cos_theta;
                    let t4 = q_s + T::from_f64(1.2) * sin_theta;
                    let t5 = T::from_f64(-1.2) * cos_theta;
                    [
                        t0,
                        T::from_f64(0.1),
                        T::from_f64(0.1),
                        t1,
                        T::from_f64(0.1),
                        T::from_f64(0.1),
                        t0,
                        T::from_f64(-0.1),
                        T::from_f64(0.1),
                        t1,
                        T::from_f64(-0.1),
                        T::from_f64(0.1),
                        t0,
                        T::from_f64(0.1),
                        T::from_f64(-0.1),
                        t1,
                        T::from_f64(0.1),
                        T::from_f64(-0.1),
                        t0,
                        T::from_f64(-0.1),
                        T::from_f64(-0.1),
                        t1,
                        T::from_f64(-0.1),
                        T::from_f64(-0.1),
                        t2,
                        t3,
                        T::from_f64(0.0),
                        q_s,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        q_s,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t4,
                        t5,
                        T::from_f64(0.0),
                    ]
                },
            )
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::Cast<4> for CartPole {
        type In<T: ::pendulum_core::real::Real> = CartPole<T>;
        fn cast<T: ::pendulum_core::real::Real>(&self) -> CartPole<T> {
            CartPole::cast(self)
        }
        #[inline]
        fn gather<'m, T: ::pendulum_core::real::lanes::Lanes>(
            models: impl ::core::ops::Fn(usize) -> &'m Self,
        ) -> CartPole<T>
        where
            Self: 'm,
        {
            let scalar = <<T as ::pendulum_core::real::lanes::Lanes>::Scalar as ::pendulum_core::real::Real>::from_f64;
            CartPole {
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
pub use __CartPole::{CartPole, CartPoleParams};
