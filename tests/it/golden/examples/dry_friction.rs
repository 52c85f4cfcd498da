#[allow(non_snake_case)]
mod __Rods {
    ///Parameters of [`Rods`].
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct RodsParams {
        ///In N m.
        pub mu1: f64,
        ///In N m.
        pub mu2: f64,
        ///In N m s.
        pub gamma: f64,
    }
    impl ::core::default::Default for RodsParams {
        #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
        fn default() -> Self {
            Self {
                mu1: 1.5f64,
                mu2: 0.6f64,
                gamma: 0.02f64,
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl RodsParams {
        /// The names of the parameters, in the order of their declaration.
        pub const NAMES: [&'static str; 3] = ["mu1", "mu2", "gamma"];
        /// The values of the parameters, in the order of [`NAMES`](Self::NAMES).
        pub const fn to_array(self) -> [f64; 3] {
            [self.mu1, self.mu2, self.gamma]
        }
        /// The parameters with these values, in the order of [`NAMES`](Self::NAMES).
        pub const fn from_array(values: [f64; 3]) -> Self {
            let [v0, v1, v2] = values;
            Self {
                mu1: v0,
                mu2: v1,
                gamma: v2,
            }
        }
    }
    /// Two equal rods of 1 kg and 1 m with friction in both axles; both angles are from hanging.
    ///
    /**# Equations of motion

```text
A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints

A[theta1, theta1] = 4/3
A[theta1, theta2] = 0.5*cos(theta1 - theta2)
A[theta2, theta2] = 1/3
b[theta1] = 14.715*sin(theta1) + 0.5*dot(theta2)^2*sin(theta1 - theta2)
b[theta2] = 4.905*sin(theta2) - 0.5*dot(theta1)^2*sin(theta1 - theta2)
Q[theta1] = force(theta1) + gamma*dot(theta2) - 2*gamma*dot(theta1) - force(theta2)
Q[theta2] = force(theta2) + gamma*dot(theta1) - gamma*dot(theta2)

and along what hinders the motion
force(theta1): dry friction of mu1
force(theta2): dry friction of mu2
```

# Constants, computed by `new`

```text
k0 = mu1
k1 = mu2
k2 = gamma
k3 = -gamma
k4 = 2*gamma
k5 = 3*gamma
```
*/
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Rods<T = f64> {
        params: RodsParams,
        constants: [T; 6],
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl Rods {
        /// Builds the model: checks the parameters, and computes once whatever depends on them alone.
        ///
        /// # Errors
        ///
        /// The first parameter, or combination of parameters, that is not finite or that no rigid body can
        /// have.
        pub fn new(
            params: RodsParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            #[inline]
            fn rules<T: ::pendulum_core::real::Real>(given: [T; 3]) -> [T; 3] {
                let [p_mu1, p_mu2, p_gamma] = given;
                [p_gamma, p_mu1, p_mu2]
            }
            #[inline]
            fn constants<T: ::pendulum_core::real::Real>(given: [T; 3]) -> [T; 6] {
                let [p_mu1, p_mu2, p_gamma] = given;
                [
                    p_mu1,
                    p_mu2,
                    p_gamma,
                    -p_gamma,
                    T::from_f64(2.0) * p_gamma,
                    T::from_f64(3.0) * p_gamma,
                ]
            }
            let given = params.to_array();
            for (name, value) in RodsParams::NAMES.into_iter().zip(given) {
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
            if !(r0 >= 0.0) {
                return Err(
                    ::pendulum_core::ParameterError::new(
                        "gamma",
                        r0,
                        "the friction of `upper` must not be negative",
                        &[],
                    ),
                );
            }
            if !(r1 >= 0.0) {
                return Err(
                    ::pendulum_core::ParameterError::new(
                        "mu1",
                        r1,
                        "the dry friction of `upper` must not be negative",
                        &[],
                    ),
                );
            }
            if !(r2 >= 0.0) {
                return Err(
                    ::pendulum_core::ParameterError::new(
                        "mu2",
                        r2,
                        "the dry friction of `lower` must not be negative",
                        &[],
                    ),
                );
            }
            let constants = constants(given);
            let names: [&'static str; 6] = [
                "mu1",
                "mu2",
                "gamma",
                "-gamma",
                "2*gamma",
                "3*gamma",
            ];
            for (name, value) in names.into_iter().zip(constants) {
                if !value.is_finite() {
                    let given: [_; 3] = ::core::array::from_fn(|n| (
                        RodsParams::NAMES[n],
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
        pub fn cast<T: ::pendulum_core::real::Real>(&self) -> Rods<T> {
            Rods {
                params: self.params,
                constants: self.constants.map(T::from_f64),
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> Rods<T> {
        /// The parameters that the model was built from.
        pub fn params(&self) -> &RodsParams {
            &self.params
        }
        /// The model with other parameters, in the same number type. Its constants are computed anew.
        ///
        /// # Errors
        ///
        /// Those of `new`.
        pub fn with_params(
            &self,
            params: RodsParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            Ok(<Rods>::new(params)?.cast())
        }
    }
    impl Rods {
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
                            "closed form, expanded, L^T D L",
                            ::pendulum_core::Operations::new(14, 20, 1, 2, 0, 33),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first, L^T D L",
                                    ::pendulum_core::Operations::new(15, 20, 1, 2, 0, 32),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, L^T D L",
                                    ::pendulum_core::Operations::new(15, 21, 1, 2, 0, 32),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, adjugate",
                                    ::pendulum_core::Operations::new(25, 29, 1, 2, 0, 37),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C, adjugate",
                                    ::pendulum_core::Operations::new(34, 35, 1, 2, 0, 39),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "articulated bodies",
                                    ::pendulum_core::Operations::new(30, 44, 2, 2, 0, 47),
                                ),
                            ],
                        ),
                ),
                (
                    "measures",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(2, 0, 0, 0, 0, 1),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(2, 0, 0, 0, 0, 1),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(2, 0, 0, 0, 0, 1),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(2, 0, 0, 0, 0, 1),
                                ),
                            ],
                        ),
                ),
                (
                    "response",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, expanded, adjugate",
                            ::pendulum_core::Operations::new(17, 26, 1, 2, 0, 32),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first, adjugate",
                                    ::pendulum_core::Operations::new(18, 26, 1, 2, 0, 32),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, adjugate",
                                    ::pendulum_core::Operations::new(18, 27, 1, 2, 0, 31),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, inverse",
                                    ::pendulum_core::Operations::new(31, 30, 1, 2, 0, 40),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C, inverse",
                                    ::pendulum_core::Operations::new(42, 36, 1, 2, 0, 42),
                                ),
                            ],
                        ),
                ),
                (
                    "jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, expanded, L^T D L, derived and expanded",
                            ::pendulum_core::Operations::new(30, 46, 1, 2, 0, 39),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, L^T D L, derived in the graph",
                                    ::pendulum_core::Operations::new(31, 46, 1, 2, 0, 38),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first, L^T D L, derived and expanded",
                                    ::pendulum_core::Operations::new(31, 46, 1, 2, 0, 40),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, inverse, derived in the graph",
                                    ::pendulum_core::Operations::new(51, 62, 1, 2, 0, 49),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C, inverse, derived in the graph",
                                    ::pendulum_core::Operations::new(99, 88, 1, 2, 0, 43),
                                ),
                            ],
                        ),
                ),
                (
                    "response_derivative",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of parameters first, L^T D L, derived in the graph",
                            ::pendulum_core::Operations::new(44, 49, 1, 2, 0, 39),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, inverse, derived and expanded",
                                    ::pendulum_core::Operations::new(42, 51, 1, 2, 0, 39),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first, L^T D L, derived and expanded",
                                    ::pendulum_core::Operations::new(42, 51, 1, 2, 0, 41),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, inverse, derived in the graph",
                                    ::pendulum_core::Operations::new(60, 62, 1, 2, 0, 50),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C, inverse, derived in the graph",
                                    ::pendulum_core::Operations::new(98, 81, 1, 2, 0, 49),
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
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(0, 0, 0, 0, 0, 0),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
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
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(3, 6, 0, 1, 0, 25),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(3, 6, 0, 1, 0, 25),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(3, 6, 0, 1, 0, 26),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(13, 21, 0, 2, 0, 32),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C",
                                    ::pendulum_core::Operations::new(22, 18, 0, 2, 0, 34),
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
                                    ::pendulum_core::Operations::new(2, 2, 0, 2, 0, 24),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(2, 2, 0, 2, 0, 24),
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
        pub const EQUATIONS: &'static str = "A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints\n\nA[theta1, theta1] = 4/3\nA[theta1, theta2] = 0.5*cos(theta1 - theta2)\nA[theta2, theta2] = 1/3\nb[theta1] = 14.715*sin(theta1) + 0.5*dot(theta2)^2*sin(theta1 - theta2)\nb[theta2] = 4.905*sin(theta2) - 0.5*dot(theta1)^2*sin(theta1 - theta2)\nQ[theta1] = force(theta1) + gamma*dot(theta2) - 2*gamma*dot(theta1) - force(theta2)\nQ[theta2] = force(theta2) + gamma*dot(theta1) - gamma*dot(theta2)\n\nand along what hinders the motion\nforce(theta1): dry friction of mu1\nforce(theta2): dry friction of mu2\n";
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::System<T, 4> for Rods<T> {
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn rhs(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 4> {
            let (laws, measures) = (
                ::pendulum_core::hybrid::Hybrid::<T, 4>::laws(self),
                ::pendulum_core::hybrid::Hybrid::<T, 4>::measures(self, t, x),
            );
            let mut forces = [T::from_f64(0.0); ::pendulum_core::hybrid::MOST];
            for n in 0..2 {
                forces[n] = -laws[n].slipping * measures[n][1].signum();
            }
            ::pendulum_core::System::rhs_under(self, t, x, &forces)
        }
        #[inline]
        fn layout(
            &self,
        ) -> ::core::option::Option<&'static ::pendulum_core::StateLayout> {
            Some(&<Rods>::LAYOUT)
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn rhs_under(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
            forces: &[T; ::pendulum_core::hybrid::MOST],
        ) -> ::pendulum_core::nalgebra::SVector<T, 4> {
            let [q_theta1, q_theta2, qd_theta1, qd_theta2] = x.data.0[0];
            let f0 = forces[0];
            let f1 = forces[1];
            let k2 = self.constants[2];
            let k3 = self.constants[3];
            let k4 = self.constants[4];
            let t0 = f1 - k2 * qd_theta2;
            let [(sin_theta1, cos_theta1), (sin_theta2, cos_theta2)] = q_theta1
                .sin_cos_pair(q_theta2);
            let t1 = sin_theta1 * cos_theta2 - cos_theta1 * sin_theta2;
            let t2 = T::from_f64(0.5) * t1;
            let t3 = T::from_f64(14.715) * sin_theta1 + k4 * qd_theta1
                + qd_theta2 * qd_theta2 * t2 + t0 - f0;
            let t4 = T::from_f64(4.905) * sin_theta2 + qd_theta1 * (k3 - qd_theta1 * t2)
                - t0;
            let t5 = T::from_f64(1.5)
                * (cos_theta2 * cos_theta1 + sin_theta1 * sin_theta2);
            let t6 = T::from_f64(-0.3333333333333333)
                / (T::from_f64(0.19444444444444445) + T::from_f64(0.25) * t1 * t1)
                * (t3 - t5 * t4);
            ::pendulum_core::nalgebra::SVector::from([
                qd_theta1,
                qd_theta2,
                t6,
                -(T::from_f64(3.0) * t4 + t5 * t6),
            ])
        }
        #[inline]
        fn hybrid(
            &self,
        ) -> ::core::option::Option<&dyn ::pendulum_core::hybrid::Hybrid<T, 4>> {
            Some(self)
        }
        #[inline]
        fn rhs_in(
            &self,
            hold: &::pendulum_core::hybrid::Hold<T>,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 4> {
            ::pendulum_core::hybrid::rhs(self, hold, t, x)
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::hybrid::Hybrid<T, 4>
    for Rods<T> {
        #[inline]
        fn constraints(&self) -> &'static [::pendulum_core::hybrid::Constraint] {
            const {
                &[
                    ::pendulum_core::hybrid::Constraint {
                        name: "theta1",
                        rate: &[(2, 1)],
                    },
                    ::pendulum_core::hybrid::Constraint {
                        name: "theta2",
                        rate: &[(2, -1), (3, 1)],
                    },
                ]
            }
        }
        #[inline]
        fn laws(
            &self,
        ) -> [::pendulum_core::hybrid::Law<T>; ::pendulum_core::hybrid::MOST] {
            let k0 = self.constants[0];
            let k1 = self.constants[1];
            let mut laws = [::pendulum_core::hybrid::Law::default(); ::pendulum_core::hybrid::MOST];
            laws[0] = ::pendulum_core::hybrid::Law {
                slipping: k0,
                sticking: k0,
                low: None,
                high: None,
                restitution: T::from_f64(0.0),
                slow: T::from_f64(0.0),
            };
            laws[1] = ::pendulum_core::hybrid::Law {
                slipping: k1,
                sticking: k1,
                low: None,
                high: None,
                restitution: T::from_f64(0.0),
                slow: T::from_f64(0.0),
            };
            laws
        }
        #[inline]
        fn measures(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> [[T; 2]; ::pendulum_core::hybrid::MOST] {
            let [q_theta1, q_theta2, qd_theta1, qd_theta2] = x.data.0[0];
            let mut measures = [[T::from_f64(0.0); 2]; ::pendulum_core::hybrid::MOST];
            measures[0] = [q_theta1, qd_theta1];
            measures[1] = [q_theta2 - q_theta1, qd_theta2 - qd_theta1];
            measures
        }
        #[inline]
        fn response(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
            forces: &[T; ::pendulum_core::hybrid::MOST],
        ) -> ::pendulum_core::hybrid::Response<T, 4> {
            let [q_theta1, q_theta2, qd_theta1, qd_theta2] = x.data.0[0];
            let f0 = forces[0];
            let f1 = forces[1];
            let k2 = self.constants[2];
            let k3 = self.constants[3];
            let k4 = self.constants[4];
            let t0 = f1 - k2 * qd_theta2;
            let [(sin_theta1, cos_theta1), (sin_theta2, cos_theta2)] = q_theta1
                .sin_cos_pair(q_theta2);
            let t1 = sin_theta1 * cos_theta2 - cos_theta1 * sin_theta2;
            let t2 = T::from_f64(-1.0)
                / (T::from_f64(0.19444444444444445) + T::from_f64(0.25) * t1 * t1);
            let t3 = T::from_f64(0.5) * t1;
            let t4 = T::from_f64(14.715) * sin_theta1 + k4 * qd_theta1
                + qd_theta2 * qd_theta2 * t3 + t0 - f0;
            let t5 = T::from_f64(4.905) * sin_theta2 + qd_theta1 * (k3 - qd_theta1 * t3)
                - t0;
            let t6 = T::from_f64(0.5)
                * (cos_theta2 * cos_theta1 + sin_theta1 * sin_theta2);
            let t7 = t2 * t6;
            let t8 = t2 * (T::from_f64(0.3333333333333333) * t4 - t6 * t5);
            let t9 = t2 * (T::from_f64(1.3333333333333333) * t5 - t4 * t6);
            let t10 = t9 - t8;
            let t11 = T::from_f64(-0.3333333333333333) * t2;
            let t12 = t2 * (T::from_f64(0.3333333333333333) + t6);
            let t13 = t2 * (T::from_f64(-1.3333333333333333) - t6);
            let t14 = t13 - t12;
            let mut response = ::pendulum_core::hybrid::Response::new(
                ::pendulum_core::nalgebra::SVector::from([qd_theta1, qd_theta2, t8, t9]),
            );
            response.accelerations[0] = t8;
            response.accelerations[1] = t10;
            response.columns[0] = ::pendulum_core::nalgebra::SVector::from([
                T::from_f64(0.0),
                T::from_f64(0.0),
                t11,
                t7,
            ]);
            response.columns[1] = ::pendulum_core::nalgebra::SVector::from([
                T::from_f64(0.0),
                T::from_f64(0.0),
                t12,
                t13,
            ]);
            response.matrix[0][0] = t11;
            response.matrix[0][1] = t12;
            response.matrix[1][0] = response.matrix[0][1];
            response.matrix[1][1] = t14;
            response
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Jacobian<T, 4> for Rods<T> {
        #[inline]
        fn jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SMatrix<T, 4, 4> {
            self.rhs_and_jacobian(t, x).1
        }
        #[inline]
        fn rhs_and_jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 4>,
            ::pendulum_core::nalgebra::SMatrix<T, 4, 4>,
        ) {
            let (laws, measures) = (
                ::pendulum_core::hybrid::Hybrid::<T, 4>::laws(self),
                ::pendulum_core::hybrid::Hybrid::<T, 4>::measures(self, t, x),
            );
            let mut forces = [T::from_f64(0.0); ::pendulum_core::hybrid::MOST];
            for n in 0..2 {
                forces[n] = -laws[n].slipping * measures[n][1].signum();
            }
            ::pendulum_core::hybrid::HybridJacobian::rhs_and_jacobian_under(
                self,
                t,
                x,
                &forces,
            )
        }
        #[inline]
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
        #[inline]
        fn hybrid_jacobian(
            &self,
        ) -> ::core::option::Option<&dyn ::pendulum_core::hybrid::HybridJacobian<T, 4>> {
            Some(self)
        }
        #[inline]
        fn jacobian_in(
            &self,
            hold: &::pendulum_core::hybrid::Hold<T>,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SMatrix<T, 4, 4>
        where
            T: ::pendulum_core::real::lanes::Lanes,
        {
            ::pendulum_core::hybrid::jacobian(self, hold, t, x)
        }
        #[inline]
        fn rhs_and_jacobian_in(
            &self,
            hold: &::pendulum_core::hybrid::Hold<T>,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 4>,
            ::pendulum_core::nalgebra::SMatrix<T, 4, 4>,
        )
        where
            T: ::pendulum_core::real::lanes::Lanes,
        {
            ::pendulum_core::hybrid::rhs_and_jacobian(self, hold, t, x)
        }
        #[inline]
        fn time_derivative_in(
            &self,
            hold: &::pendulum_core::hybrid::Hold<T>,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 4>
        where
            T: ::pendulum_core::real::lanes::Lanes,
        {
            ::pendulum_core::hybrid::time_derivative(self, hold, t, x)
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::hybrid::HybridJacobian<T, 4>
    for Rods<T> {
        #[inline]
        fn rhs_and_jacobian_under(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
            forces: &[T; ::pendulum_core::hybrid::MOST],
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 4>,
            ::pendulum_core::nalgebra::SMatrix<T, 4, 4>,
        ) {
            let [q_theta1, q_theta2, qd_theta1, qd_theta2] = x.data.0[0];
            let f0 = forces[0];
            let f1 = forces[1];
            let k2 = self.constants[2];
            let k4 = self.constants[4];
            let k5 = self.constants[5];
            let t0 = T::from_f64(0.5) * qd_theta2 * qd_theta2;
            let t1 = f1 - k2 * qd_theta2;
            let t2 = T::from_f64(0.5) * qd_theta1 * qd_theta1;
            let [(sin_theta1, cos_theta1), (sin_theta2, cos_theta2)] = q_theta1
                .sin_cos_pair(q_theta2);
            let t3 = sin_theta1 * cos_theta2 - cos_theta1 * sin_theta2;
            let t4 = T::from_f64(-0.3333333333333333)
                / (T::from_f64(0.19444444444444445) + T::from_f64(0.25) * t3 * t3);
            let t5 = cos_theta2 * cos_theta1 + sin_theta1 * sin_theta2;
            let t6 = T::from_f64(1.5) * t5;
            let t7 = T::from_f64(4.905) * sin_theta2 - k2 * qd_theta1 - t3 * t2 - t1;
            let t8 = T::from_f64(14.715) * sin_theta1 + k4 * qd_theta1 + t3 * t0 + t1
                - f0 - t6 * t7;
            let t9 = t4 * t8;
            let t10 = T::from_f64(3.0) * t7 + t6 * t9;
            let t11 = -t10;
            let t12 = T::from_f64(0.5) * t3;
            let t13 = t0 * t5 + t10 * t12;
            let t14 = t5 * t2 + t9 * t12;
            let t15 = t4 * (T::from_f64(14.715) * cos_theta1 + t13 + t6 * t14);
            let t16 = t14 + T::from_f64(4.905) * cos_theta2;
            let t17 = T::from_f64(3.0) * t14 - t6 * t15;
            let t18 = t4 * (t13 + t6 * t16);
            let t19 = t6 * t18 - T::from_f64(3.0) * t16;
            let t20 = -t18;
            let t21 = k2 + t3 * qd_theta1;
            let t22 = t4 * (t3 * qd_theta2 - k2 * t6 - k2);
            let t23 = -(k5 + t6 * t22);
            let t24 = t4 * (k4 + t6 * t21);
            let t25 = T::from_f64(3.0) * t21 - t6 * t24;
            (
                ::pendulum_core::nalgebra::SVector::from([
                    qd_theta1,
                    qd_theta2,
                    t9,
                    t11,
                ]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [T::from_f64(0.0), T::from_f64(0.0), t15, t17],
                    [T::from_f64(0.0), T::from_f64(0.0), t20, t19],
                    [T::from_f64(1.0), T::from_f64(0.0), t24, t25],
                    [T::from_f64(0.0), T::from_f64(1.0), t22, t23],
                ]),
            )
        }
        #[inline]
        fn response_derivative(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
            forces: &[T; ::pendulum_core::hybrid::MOST],
        ) -> ::pendulum_core::hybrid::ResponseDerivative<T, 4> {
            let [q_theta1, q_theta2, qd_theta1, qd_theta2] = x.data.0[0];
            let f0 = forces[0];
            let f1 = forces[1];
            let k2 = self.constants[2];
            let k4 = self.constants[4];
            let k5 = self.constants[5];
            let t0 = qd_theta2 * (T::from_f64(0.5) * qd_theta2);
            let t1 = qd_theta1 * (T::from_f64(0.5) * qd_theta1);
            let [(sin_theta1, cos_theta1), (sin_theta2, cos_theta2)] = q_theta1
                .sin_cos_pair(q_theta2);
            let t2 = sin_theta1 * cos_theta2 - cos_theta1 * sin_theta2;
            let t3 = T::from_f64(-0.3333333333333333)
                / (T::from_f64(0.19444444444444445) + t2 * (T::from_f64(0.25) * t2));
            let t4 = k2 * (T::from_f64(2.0) * qd_theta1 - qd_theta2)
                + (f1 + (T::from_f64(14.715) * sin_theta1 + t0 * t2 - f0));
            let t5 = cos_theta1 * cos_theta2 + sin_theta1 * sin_theta2;
            let t6 = t0 * t5;
            let t7 = T::from_f64(1.5) * t5;
            let t8 = t7 * t3;
            let t9 = t1 * t5;
            let t10 = k2 * (qd_theta2 - qd_theta1)
                + (T::from_f64(4.905) * sin_theta2 - t1 * t2 - f1);
            let t11 = t3 * (t4 - t7 * t10);
            let t12 = T::from_f64(3.0) * t10 + t7 * t11;
            let t13 = -t12;
            let t14 = -(t11 + t12);
            let t15 = -t3;
            let t16 = t3 * (T::from_f64(1.0) + t7);
            let t17 = T::from_f64(3.0) - t7 * t16;
            let t18 = t17 - t16;
            let t19 = T::from_f64(0.5) * t2;
            let t20 = t12 * t19;
            let t21 = t11 * t19;
            let t22 = t9 + t21;
            let t23 = T::from_f64(4.905) * cos_theta2 + t9 + t21;
            let t24 = t3 * (T::from_f64(14.715) * cos_theta1 + t6 + t20 + t7 * t22);
            let t25 = t3 * (t6 + t20 + t7 * t23);
            let t26 = T::from_f64(3.0) * t22 - t7 * t24;
            let t27 = t26 - t24;
            let t28 = t7 * t25 - T::from_f64(3.0) * t23;
            let t29 = t25 + t28;
            let t30 = -t25;
            let t31 = k2 + qd_theta1 * t2;
            let t32 = t3 * (qd_theta2 * t2 - k2 - k2 * t7);
            let t33 = t3 * (k4 + t7 * t31);
            let t34 = T::from_f64(3.0) * t31 - t7 * t33;
            let t35 = t34 - t33;
            let t36 = k5 + t7 * t32;
            let t37 = -(t32 + t36);
            let t38 = -t36;
            let response = {
                let mut response = ::pendulum_core::hybrid::Response::new(
                    ::pendulum_core::nalgebra::SVector::from([
                        qd_theta1,
                        qd_theta2,
                        t11,
                        t13,
                    ]),
                );
                response.accelerations[0] = t11;
                response.accelerations[1] = t14;
                response.columns[0] = ::pendulum_core::nalgebra::SVector::from([
                    T::from_f64(0.0),
                    T::from_f64(0.0),
                    t15,
                    t8,
                ]);
                response.columns[1] = ::pendulum_core::nalgebra::SVector::from([
                    T::from_f64(0.0),
                    T::from_f64(0.0),
                    t16,
                    t17,
                ]);
                response.matrix[0][0] = t15;
                response.matrix[0][1] = t16;
                response.matrix[1][0] = response.matrix[0][1];
                response.matrix[1][1] = t18;
                response
            };
            let zero = T::from_f64(0.0);
            let mut accelerations = [::pendulum_core::nalgebra::SVector::from(
                [zero; 4],
            ); ::pendulum_core::hybrid::MOST];
            accelerations[0] = ::pendulum_core::nalgebra::SVector::from([
                t24,
                t30,
                t33,
                t32,
            ]);
            accelerations[1] = ::pendulum_core::nalgebra::SVector::from([
                t27,
                t29,
                t35,
                t37,
            ]);
            let mut accelerations_by_time = [zero; ::pendulum_core::hybrid::MOST];
            accelerations_by_time[0] = T::from_f64(0.0);
            accelerations_by_time[1] = T::from_f64(0.0);
            ::pendulum_core::hybrid::ResponseDerivative {
                response,
                rates: ::pendulum_core::nalgebra::SMatrix::from([
                    [T::from_f64(0.0), T::from_f64(0.0), t24, t26],
                    [T::from_f64(0.0), T::from_f64(0.0), t30, t28],
                    [T::from_f64(1.0), T::from_f64(0.0), t33, t34],
                    [T::from_f64(0.0), T::from_f64(1.0), t32, t38],
                ]),
                accelerations,
                rates_by_time: ::pendulum_core::nalgebra::SVector::from([
                    T::from_f64(0.0),
                    T::from_f64(0.0),
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
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::hybrid::MeasureDerivatives<T, 4> {
            let [_, _, _, _] = x.data.0[0];
            let zero = T::from_f64(0.0);
            let mut derivatives = ::pendulum_core::hybrid::MeasureDerivatives {
                by_state: [[::pendulum_core::nalgebra::SVector::from(
                    [zero; 4],
                ); 2]; ::pendulum_core::hybrid::MOST],
                by_time: [[zero; 2]; ::pendulum_core::hybrid::MOST],
            };
            derivatives.by_state[0] = [
                ::pendulum_core::nalgebra::SVector::from([
                    T::from_f64(1.0),
                    T::from_f64(0.0),
                    T::from_f64(0.0),
                    T::from_f64(0.0),
                ]),
                ::pendulum_core::nalgebra::SVector::from([
                    T::from_f64(0.0),
                    T::from_f64(0.0),
                    T::from_f64(1.0),
                    T::from_f64(0.0),
                ]),
            ];
            derivatives.by_time[0] = [T::from_f64(0.0), T::from_f64(0.0)];
            derivatives.by_state[1] = [
                ::pendulum_core::nalgebra::SVector::from([
                    T::from_f64(-1.0),
                    T::from_f64(1.0),
                    T::from_f64(0.0),
                    T::from_f64(0.0),
                ]),
                ::pendulum_core::nalgebra::SVector::from([
                    T::from_f64(0.0),
                    T::from_f64(0.0),
                    T::from_f64(-1.0),
                    T::from_f64(1.0),
                ]),
            ];
            derivatives.by_time[1] = [T::from_f64(0.0), T::from_f64(0.0)];
            derivatives
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Energy<T, 4> for Rods<T> {
        #[inline]
        fn kinetic(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 4>) -> T {
            let [q_theta1, q_theta2, qd_theta1, qd_theta2] = x.data.0[0];
            let (_, cos0) = (q_theta1 - q_theta2).sin_cos();
            qd_theta2 * (T::from_f64(0.16666666666666666) * qd_theta2)
                + qd_theta1
                    * (cos0 * (T::from_f64(0.5) * qd_theta2)
                        + T::from_f64(0.6666666666666666) * qd_theta1)
        }
        #[inline]
        fn potential(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 4>) -> T {
            let [q_theta1, q_theta2, _, _] = x.data.0[0];
            let [(_, cos_theta2), (_, cos_theta1)] = q_theta2.sin_cos_pair(q_theta1);
            -(T::from_f64(4.905) * cos_theta2 + T::from_f64(14.715) * cos_theta1)
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::CastJacobian<4> for Rods {
        #[inline]
        fn with_jacobian<T: ::pendulum_core::real::Real>(
            model: &Rods<T>,
        ) -> &impl ::pendulum_core::Jacobian<T, 4> {
            model
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::Cast<4> for Rods {
        const HYBRID: bool = true;
        type In<T: ::pendulum_core::real::Real> = Rods<T>;
        fn cast<T: ::pendulum_core::real::Real>(&self) -> Rods<T> {
            Rods::cast(self)
        }
        #[inline]
        fn gather<'m, T: ::pendulum_core::real::lanes::Lanes>(
            models: impl ::core::ops::Fn(usize) -> &'m Self,
        ) -> Rods<T>
        where
            Self: 'm,
        {
            let scalar = <<T as ::pendulum_core::real::lanes::Lanes>::Scalar as ::pendulum_core::real::Real>::from_f64;
            Rods {
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
use __Rods::{Rods, RodsParams};
