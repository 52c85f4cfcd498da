#[allow(non_snake_case)]
mod __Block {
    ///Parameters of [`Block`].
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct BlockParams {
        ///In kg.
        pub m: f64,
        ///In N.
        pub mu: f64,
        ///In N.
        pub at_rest: f64,
        ///In N.
        pub pull: f64,
    }
    impl ::core::default::Default for BlockParams {
        #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
        fn default() -> Self {
            Self {
                m: 2f64,
                mu: 0.5f64,
                at_rest: 0.75f64,
                pull: 0.25f64,
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl BlockParams {
        /// Names of the parameters, in the order of their declaration.
        pub const NAMES: [&'static str; 4] = ["m", "mu", "at_rest", "pull"];
        /// Returns the values of the parameters, in the order of [`NAMES`](Self::NAMES).
        pub const fn to_array(self) -> [f64; 4] {
            [self.m, self.mu, self.at_rest, self.pull]
        }
        /// Builds parameters from their values, in the order of [`NAMES`](Self::NAMES).
        pub const fn from_array(values: [f64; 4]) -> Self {
            let [v0, v1, v2, v3] = values;
            Self {
                m: v0,
                mu: v1,
                at_rest: v2,
                pull: v3,
            }
        }
    }
    /// A block on a plane that is slightly tilted.
    ///
    /**# Equations of motion

```text
A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints

A[s, s] = m
Q[s] = force(s) + pull

and along the constraints
force(s): dry friction of mu, at rest up to at_rest; stops at -10 and 1, restitution 0.5
```

# Constants, computed by `new`

```text
k0 = mu
k1 = at_rest
k2 = pull
k3 = 0.5*m
k4 = 1/m
```
*/
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Block<T = f64> {
        params: BlockParams,
        constants: [T; 5],
    }
    /// Constants of the model, from its parameters.
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    #[inline]
    fn constants<T: ::pendulum_core::real::Real>(given: [T; 4]) -> [T; 5] {
        let [p_m, p_mu, p_at_rest, p_pull] = given;
        [p_mu, p_at_rest, p_pull, T::from_f64(0.5) * p_m, -(T::from_f64(-1.0) / p_m)]
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl Block {
        /// Builds the model: checks the parameters, and computes all constants that depend on them alone.
        ///
        /// # Errors
        ///
        /// Returns the first parameter, or combination of parameters, that is not finite or is impossible for a
        /// rigid body.
        pub fn new(
            params: BlockParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            #[inline]
            fn rules<T: ::pendulum_core::real::Real>(given: [T; 4]) -> [T; 3] {
                let [p_m, p_mu, p_at_rest, p_pull] = given;
                [p_m, p_mu, p_at_rest - p_mu]
            }
            let given = params.to_array();
            for (name, value) in BlockParams::NAMES.into_iter().zip(given) {
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
            let [r0, r1, r2] = rules(given);
            if !(r0 > 0.0) {
                return Err(
                    ::pendulum_core::ParameterError::new(
                        "m",
                        r0,
                        "the mass of `block` must be positive",
                        &[],
                    ),
                );
            }
            if !(r1 >= 0.0) {
                return Err(
                    ::pendulum_core::ParameterError::new(
                        "mu",
                        r1,
                        "the dry friction of `block` must not be negative",
                        &[],
                    ),
                );
            }
            if !(r2 >= 0.0) {
                return Err(
                    ::pendulum_core::ParameterError::new(
                        "at_rest - mu",
                        r2,
                        "the static friction of `block` must not be below its dry friction",
                        &[("mu", params.mu), ("at_rest", params.at_rest)],
                    ),
                );
            }
            let constants = constants(given);
            let names: [&'static str; 5] = ["mu", "at_rest", "pull", "0.5*m", "1/m"];
            for (name, value) in names.into_iter().zip(constants) {
                if !value.is_finite() {
                    let given: [_; 4] = ::core::array::from_fn(|n| (
                        BlockParams::NAMES[n],
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
        pub fn cast<T: ::pendulum_core::real::Real>(&self) -> Block<T> {
            Block {
                params: self.params,
                constants: self.constants.map(T::from_f64),
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> Block<T> {
        /// Returns the parameters from which the model was built.
        pub fn params(&self) -> &BlockParams {
            &self.params
        }
        /// Returns a model with other parameters, in the same number type, and recomputes its constants.
        ///
        /// # Errors
        ///
        /// Returns the errors of `new`.
        pub fn with_params(
            &self,
            params: BlockParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            Ok(<Block>::new(params)?.cast())
        }
    }
    impl Block {
        ///Index of `s` in the state, in m.
        pub const S: usize = 0;
        ///Index of `dot(s)` in the state, in m/s.
        pub const DOT_S: usize = 1;
        /// Number of degrees of freedom. The state has twice as many components.
        pub const DOF: usize = 1;
        /// Names of the coordinates. The state holds their positions and then their rates in this order.
        pub const COORDINATES: [&'static str; 1] = ["s"];
        /// Operation counts of each generated function, in its own form and in others.
        pub const COST: ::pendulum_core::Cost = ::pendulum_core::Cost::new(
            &[
                (
                    "rhs",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factored, L^T D L",
                            ::pendulum_core::Operations::new(1, 1, 0, 0, 0, 2),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L",
                                    ::pendulum_core::Operations::new(1, 1, 0, 0, 0, 2),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, L^T D L",
                                    ::pendulum_core::Operations::new(1, 1, 0, 0, 0, 2),
                                ),
                            ],
                        ),
                ),
                (
                    "measures",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(0, 0, 0, 0, 0, 0),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factored",
                                    ::pendulum_core::Operations::new(0, 0, 0, 0, 0, 0),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(0, 0, 0, 0, 0, 0),
                                ),
                            ],
                        ),
                ),
                (
                    "response",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factored, L^T D L",
                            ::pendulum_core::Operations::new(1, 1, 0, 0, 0, 2),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L",
                                    ::pendulum_core::Operations::new(1, 1, 0, 0, 0, 2),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, L^T D L",
                                    ::pendulum_core::Operations::new(1, 1, 0, 0, 0, 2),
                                ),
                            ],
                        ),
                ),
                (
                    "jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factored, L^T D L, derived and expanded",
                            ::pendulum_core::Operations::new(1, 1, 0, 0, 0, 2),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L, derived and expanded",
                                    ::pendulum_core::Operations::new(1, 1, 0, 0, 0, 2),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, L^T D L, derived in the graph",
                                    ::pendulum_core::Operations::new(1, 1, 0, 0, 0, 2),
                                ),
                            ],
                        ),
                ),
                (
                    "response_derivative",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factored, L^T D L, derived and expanded",
                            ::pendulum_core::Operations::new(1, 1, 0, 0, 0, 2),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L, derived and expanded",
                                    ::pendulum_core::Operations::new(1, 1, 0, 0, 0, 2),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, L^T D L, derived in the graph",
                                    ::pendulum_core::Operations::new(1, 1, 0, 0, 0, 2),
                                ),
                            ],
                        ),
                ),
                (
                    "measure_derivatives",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(0, 0, 0, 0, 0, 0),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factored",
                                    ::pendulum_core::Operations::new(0, 0, 0, 0, 0, 0),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(0, 0, 0, 0, 0, 0),
                                ),
                            ],
                        ),
                ),
                (
                    "kinetic",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factored",
                            ::pendulum_core::Operations::new(0, 2, 0, 0, 0, 2),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(0, 2, 0, 0, 0, 2),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(0, 2, 0, 0, 0, 2),
                                ),
                            ],
                        ),
                ),
                (
                    "potential",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factored",
                            ::pendulum_core::Operations::new(0, 0, 0, 0, 0, 0),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(0, 0, 0, 0, 0, 0),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(0, 0, 0, 0, 0, 0),
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
                        "s",
                        ::pendulum_core::SlotKind::Length,
                        0..1,
                        1..2,
                    ),
                ],
            )
            .autonomous();
        /// Equations of motion as text.
        pub const EQUATIONS: &'static str = "A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints\n\nA[s, s] = m\nQ[s] = force(s) + pull\n\nand along the constraints\nforce(s): dry friction of mu, at rest up to at_rest; stops at -10 and 1, restitution 0.5\n";
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Plant<T, 2> for Block<T> {
        type Given = [T; ::pendulum_core::hybrid::MAX_CONSTRAINTS];
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn eval(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
            forces: &[T; ::pendulum_core::hybrid::MAX_CONSTRAINTS],
        ) -> ::pendulum_core::nalgebra::SVector<T, 2> {
            let [_, qd_s] = x.data.0[0];
            let f0 = forces[0];
            let k2 = self.constants[2];
            let k4 = self.constants[4];
            ::pendulum_core::nalgebra::SVector::from([qd_s, k4 * (k2 + f0)])
        }
        #[inline]
        fn constraints(&self) -> &[::pendulum_core::hybrid::Constraint<'_>] {
            const {
                &[
                    ::pendulum_core::hybrid::Constraint {
                        name: "s",
                        rate: &[(1, 1)],
                    },
                ]
            }
        }
        #[inline]
        fn laws(
            &self,
        ) -> [::pendulum_core::hybrid::Law<
            T,
        >; ::pendulum_core::hybrid::MAX_CONSTRAINTS] {
            let k0 = self.constants[0];
            let k1 = self.constants[1];
            let mut laws = [::pendulum_core::hybrid::Law::default(); ::pendulum_core::hybrid::MAX_CONSTRAINTS];
            laws[0] = ::pendulum_core::hybrid::Law {
                slipping: k0,
                sticking: k1,
                low: Some(T::from_f64(-10.0)),
                high: Some(T::from_f64(1.0)),
                restitution: T::from_f64(0.5),
                slow: T::from_f64(0.0),
            };
            laws
        }
        #[inline]
        fn measures(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
        ) -> [[T; 2]; ::pendulum_core::hybrid::MAX_CONSTRAINTS] {
            let [q_s, qd_s] = x.data.0[0];
            let mut measures = [[T::from_f64(
                0.0,
            ); 2]; ::pendulum_core::hybrid::MAX_CONSTRAINTS];
            measures[0] = [q_s, qd_s];
            measures
        }
        #[inline]
        fn response(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
            forces: &[T; ::pendulum_core::hybrid::MAX_CONSTRAINTS],
        ) -> ::pendulum_core::hybrid::Response<T, 2> {
            let [_, qd_s] = x.data.0[0];
            let f0 = forces[0];
            let k2 = self.constants[2];
            let k4 = self.constants[4];
            let t0 = k4 * (k2 + f0);
            let mut response = ::pendulum_core::hybrid::Response::new(
                ::pendulum_core::nalgebra::SVector::from([qd_s, t0]),
            );
            response.accelerations[0] = t0;
            response.columns[0] = ::pendulum_core::nalgebra::SVector::from([
                T::from_f64(0.0),
                k4,
            ]);
            response.matrix[0][0] = k4;
            response
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::PlantJacobian<T, 2>
    for Block<T> {
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn eval_with_jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
            forces: &[T; ::pendulum_core::hybrid::MAX_CONSTRAINTS],
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 2>,
            ::pendulum_core::nalgebra::SMatrix<T, 2, 2>,
        ) {
            let [_, qd_s] = x.data.0[0];
            let f0 = forces[0];
            let k2 = self.constants[2];
            let k4 = self.constants[4];
            (
                ::pendulum_core::nalgebra::SVector::from([qd_s, k4 * (k2 + f0)]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(1.0), T::from_f64(0.0)],
                ]),
            )
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn eval_time_derivative(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
            forces: &[T; ::pendulum_core::hybrid::MAX_CONSTRAINTS],
        ) -> ::pendulum_core::nalgebra::SVector<T, 2> {
            ::pendulum_core::nalgebra::SVector::from([
                T::from_f64(0.0),
                T::from_f64(0.0),
            ])
        }
        #[inline]
        fn response_derivative(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
            forces: &[T; ::pendulum_core::hybrid::MAX_CONSTRAINTS],
        ) -> ::pendulum_core::hybrid::ResponseDerivative<T, 2> {
            let [_, qd_s] = x.data.0[0];
            let f0 = forces[0];
            let k2 = self.constants[2];
            let k4 = self.constants[4];
            let t0 = k4 * (k2 + f0);
            let response = {
                let mut response = ::pendulum_core::hybrid::Response::new(
                    ::pendulum_core::nalgebra::SVector::from([qd_s, t0]),
                );
                response.accelerations[0] = t0;
                response.columns[0] = ::pendulum_core::nalgebra::SVector::from([
                    T::from_f64(0.0),
                    k4,
                ]);
                response.matrix[0][0] = k4;
                response
            };
            let zero = T::from_f64(0.0);
            let mut accelerations = [::pendulum_core::nalgebra::SVector::from(
                [zero; 2],
            ); ::pendulum_core::hybrid::MAX_CONSTRAINTS];
            accelerations[0] = ::pendulum_core::nalgebra::SVector::from([
                T::from_f64(0.0),
                T::from_f64(0.0),
            ]);
            let mut accelerations_by_time = [zero; ::pendulum_core::hybrid::MAX_CONSTRAINTS];
            accelerations_by_time[0] = T::from_f64(0.0);
            ::pendulum_core::hybrid::ResponseDerivative {
                response,
                rates: ::pendulum_core::nalgebra::SMatrix::from([
                    [T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(1.0), T::from_f64(0.0)],
                ]),
                accelerations,
                rates_by_time: ::pendulum_core::nalgebra::SVector::from([
                    T::from_f64(0.0),
                    T::from_f64(0.0),
                ]),
                accelerations_by_time,
            }
        }
        #[inline]
        fn measure_derivatives(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
        ) -> ::pendulum_core::hybrid::MeasureDerivatives<T, 2> {
            let [_, _] = x.data.0[0];
            let zero = T::from_f64(0.0);
            let mut derivatives = ::pendulum_core::hybrid::MeasureDerivatives {
                by_state: [[::pendulum_core::nalgebra::SVector::from(
                    [zero; 2],
                ); 2]; ::pendulum_core::hybrid::MAX_CONSTRAINTS],
                by_time: [[zero; 2]; ::pendulum_core::hybrid::MAX_CONSTRAINTS],
            };
            derivatives.by_state[0] = [
                ::pendulum_core::nalgebra::SVector::from([
                    T::from_f64(1.0),
                    T::from_f64(0.0),
                ]),
                ::pendulum_core::nalgebra::SVector::from([
                    T::from_f64(0.0),
                    T::from_f64(1.0),
                ]),
            ];
            derivatives.by_time[0] = [T::from_f64(0.0), T::from_f64(0.0)];
            derivatives
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::System<T, 2> for Block<T> {
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn rhs(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 2> {
            ::pendulum_core::Plant::eval(
                self,
                t,
                x,
                &::pendulum_core::hybrid::by_sign(self, t, x),
            )
        }
        #[inline]
        fn layout(&self) -> ::core::option::Option<::pendulum_core::StateLayout<'_>> {
            Some(<Block>::LAYOUT)
        }
        #[inline]
        fn hybrid(
            &self,
        ) -> ::core::option::Option<&dyn ::pendulum_core::hybrid::Hybrid<T, 2>> {
            Some(self)
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Jacobian<T, 2> for Block<T> {
        #[inline]
        fn jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
        ) -> ::pendulum_core::nalgebra::SMatrix<T, 2, 2> {
            self.rhs_and_jacobian(t, x).1
        }
        #[inline]
        fn rhs_and_jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 2>,
            ::pendulum_core::nalgebra::SMatrix<T, 2, 2>,
        ) {
            ::pendulum_core::PlantJacobian::eval_with_jacobian(
                self,
                t,
                x,
                &::pendulum_core::hybrid::by_sign(self, t, x),
            )
        }
        #[inline]
        fn time_derivative(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 2>
        where
            T: ::pendulum_core::real::lanes::Lanes,
        {
            ::pendulum_core::PlantJacobian::eval_time_derivative(
                self,
                t,
                x,
                &::pendulum_core::hybrid::by_sign(self, t, x),
            )
        }
        #[inline]
        fn hybrid_jacobian(
            &self,
        ) -> ::core::option::Option<&dyn ::pendulum_core::hybrid::HybridJacobian<T, 2>> {
            Some(self)
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Energy<T, 2> for Block<T> {
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn kinetic(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 2>) -> T {
            let [_, qd_s] = x.data.0[0];
            let k3 = self.constants[3];
            qd_s * (qd_s * k3)
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn potential(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 2>) -> T {
            let [_, _] = x.data.0[0];
            T::from_f64(0.0)
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::Parametric<2, 4> for Block {
        fn parameters(&self) -> [f64; 4] {
            self.params.to_array()
        }
        fn parameter_names(&self) -> [&str; 4] {
            BlockParams::NAMES
        }
        fn check_parameters(
            &self,
            parameters: &[f64; 4],
        ) -> ::core::result::Result<(), ::pendulum_core::ParameterError> {
            Self::new(BlockParams::from_array(*parameters)).map(|_| ())
        }
        fn with_parameters<T: ::pendulum_core::real::Real>(
            &self,
            parameters: [T; 4],
        ) -> Block<T> {
            Block {
                params: self.params,
                constants: constants(parameters),
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::CastJacobian<2> for Block {
        #[inline]
        fn with_jacobian<T: ::pendulum_core::real::Real>(
            model: &Block<T>,
        ) -> &impl ::pendulum_core::Jacobian<T, 2> {
            model
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::Cast<2> for Block {
        const HYBRID: bool = true;
        type In<T: ::pendulum_core::real::Real> = Block<T>;
        fn cast<T: ::pendulum_core::real::Real>(&self) -> Block<T> {
            Block::cast(self)
        }
        #[inline]
        fn gather<'m, T: ::pendulum_core::real::lanes::Lanes>(
            models: impl ::core::ops::Fn(usize) -> &'m Self,
        ) -> Block<T>
        where
            Self: 'm,
        {
            let scalar = <<T as ::pendulum_core::real::lanes::Lanes>::Scalar as ::pendulum_core::real::Real>::from_f64;
            Block {
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
pub use __Block::{Block, BlockParams};
