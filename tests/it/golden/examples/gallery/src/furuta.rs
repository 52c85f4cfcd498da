#[allow(non_snake_case)]
mod __Furuta {
    ///Parameters of [`Furuta`].
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct FurutaParams {}
    impl ::core::default::Default for FurutaParams {
        #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
        fn default() -> Self {
            Self {}
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl FurutaParams {
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
    /// A pendulum on a rotary arm; y points upward.
    ///
    /**# Equations of motion

```text
A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints

A[phi, phi] = 0.06227 - 0.00642*sin(theta)*cos(theta) - 0.006075*sin(theta)^2
A[phi, theta] = 0.00167*cos(theta) - 0.001595*sin(theta)
A[theta, theta] = 0.033955
b[phi] = 0.01284*dot(phi)*dot(theta)*sin(theta)^2 - 0.00642*dot(phi)*dot(theta)
    - 0.01215*dot(phi)*dot(theta)*sin(theta)*cos(theta) - 0.00167*dot(theta)^2*sin(theta)
    - 0.001595*dot(theta)^2*cos(theta)
b[theta] = 0.20601*sin(theta) + 0.00321*dot(phi)^2 + 0.006075*dot(phi)^2*sin(theta)*cos(theta)
    - 0.00642*dot(phi)^2*sin(theta)^2 - 0.014715*cos(theta)
Q[phi] = -0.003*dot(phi)
Q[theta] = -0.001*dot(theta)
```
*/
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Furuta<T = f64> {
        params: FurutaParams,
        constants: [T; 0],
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl Furuta {
        /// Builds the model: checks the parameters, and computes once whatever depends on them alone.
        ///
        /// # Errors
        ///
        /// The first parameter, or combination of parameters, that is not finite or that no rigid body can
        /// have.
        pub fn new(
            params: FurutaParams,
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
            for (name, value) in FurutaParams::NAMES.into_iter().zip(given) {
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
                        FurutaParams::NAMES[n],
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
        pub fn cast<T: ::pendulum_core::real::Real>(&self) -> Furuta<T> {
            Furuta {
                params: self.params,
                constants: self.constants.map(T::from_f64),
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> Furuta<T> {
        /// The parameters that the model was built from.
        pub fn params(&self) -> &FurutaParams {
            &self.params
        }
        /// The model with other parameters, in the same number type. Its constants are computed anew.
        ///
        /// # Errors
        ///
        /// Those of `new`.
        pub fn with_params(
            &self,
            params: FurutaParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            Ok(<Furuta>::new(params)?.cast())
        }
    }
    impl Furuta {
        ///The place of `phi` in the state, where it stands in rad.
        pub const PHI: usize = 0;
        ///The place of `dot(phi)` in the state, where it stands in rad/s.
        pub const DOT_PHI: usize = 2;
        ///The place of `theta` in the state, where it stands in rad.
        pub const THETA: usize = 1;
        ///The place of `dot(theta)` in the state, where it stands in rad/s.
        pub const DOT_THETA: usize = 3;
        /// The number of degrees of freedom; the state has twice as many components.
        pub const DOF: usize = 2;
        /// The names of the coordinates, in the order in which they, and then their rates, stand in the state.
        pub const COORDINATES: [&'static str; 2] = ["phi", "theta"];
        /// Counted operations of each generated function, in the form that it has and in others.
        pub const COST: ::pendulum_core::Cost = ::pendulum_core::Cost::new(
            &[
                (
                    "rhs",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first, L^T D L",
                            ::pendulum_core::Operations::new(16, 26, 1, 1, 0, 33),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, L^T D L",
                                    ::pendulum_core::Operations::new(16, 26, 1, 1, 0, 33),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L",
                                    ::pendulum_core::Operations::new(16, 28, 1, 1, 0, 33),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C, L^T D L",
                                    ::pendulum_core::Operations::new(19, 31, 1, 1, 0, 34),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, L^T D L",
                                    ::pendulum_core::Operations::new(33, 47, 1, 1, 0, 36),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "articulated bodies",
                                    ::pendulum_core::Operations::new(64, 84, 1, 1, 0, 44),
                                ),
                            ],
                        ),
                ),
                (
                    "kinetic",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(5, 10, 0, 1, 0, 28),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(5, 10, 0, 1, 0, 28),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(5, 10, 0, 1, 0, 28),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C",
                                    ::pendulum_core::Operations::new(10, 17, 0, 1, 0, 30),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(15, 29, 0, 1, 0, 31),
                                ),
                            ],
                        ),
                ),
                (
                    "potential",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(2, 2, 0, 1, 0, 23),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(2, 2, 0, 1, 0, 23),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(2, 2, 0, 1, 0, 23),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C",
                                    ::pendulum_core::Operations::new(2, 2, 0, 1, 0, 23),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(2, 2, 0, 1, 0, 23),
                                ),
                            ],
                        ),
                ),
                (
                    "tip",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(3, 6, 0, 2, 0, 23),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(3, 6, 0, 2, 0, 23),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(3, 6, 0, 2, 0, 23),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(3, 6, 0, 2, 0, 23),
                                ),
                            ],
                        ),
                ),
                (
                    "tip_rate",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, expanded",
                            ::pendulum_core::Operations::new(4, 10, 0, 2, 0, 24),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "as declared",
                                    ::pendulum_core::Operations::new(5, 12, 0, 2, 0, 24),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(5, 12, 0, 2, 0, 25),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(5, 13, 0, 2, 0, 25),
                                ),
                            ],
                        ),
                ),
                (
                    "tip_and_jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(7, 8, 0, 2, 0, 23),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(6, 10, 0, 2, 0, 23),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(6, 10, 0, 2, 0, 23),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(6, 10, 0, 2, 0, 23),
                                ),
                            ],
                        ),
                ),
                (
                    "outputs",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(3, 6, 0, 2, 0, 23),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(3, 6, 0, 2, 0, 23),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(3, 6, 0, 2, 0, 23),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(3, 6, 0, 2, 0, 23),
                                ),
                            ],
                        ),
                ),
                (
                    "output_rates",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, expanded",
                            ::pendulum_core::Operations::new(4, 10, 0, 2, 0, 24),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "as declared",
                                    ::pendulum_core::Operations::new(5, 12, 0, 2, 0, 24),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(5, 12, 0, 2, 0, 25),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(5, 13, 0, 2, 0, 25),
                                ),
                            ],
                        ),
                ),
                (
                    "outputs_and_jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(7, 8, 0, 2, 0, 23),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(6, 10, 0, 2, 0, 23),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(6, 10, 0, 2, 0, 23),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(6, 10, 0, 2, 0, 23),
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
                            "phi",
                            ::pendulum_core::SlotKind::Angle,
                            0..1,
                            2..3,
                        )
                        .periodic()
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
        pub const EQUATIONS: &'static str = "A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints\n\nA[phi, phi] = 0.06227 - 0.00642*sin(theta)*cos(theta) - 0.006075*sin(theta)^2\nA[phi, theta] = 0.00167*cos(theta) - 0.001595*sin(theta)\nA[theta, theta] = 0.033955\nb[phi] = 0.01284*dot(phi)*dot(theta)*sin(theta)^2 - 0.00642*dot(phi)*dot(theta)\n    - 0.01215*dot(phi)*dot(theta)*sin(theta)*cos(theta) - 0.00167*dot(theta)^2*sin(theta)\n    - 0.001595*dot(theta)^2*cos(theta)\nb[theta] = 0.20601*sin(theta) + 0.00321*dot(phi)^2 + 0.006075*dot(phi)^2*sin(theta)*cos(theta)\n    - 0.00642*dot(phi)^2*sin(theta)^2 - 0.014715*cos(theta)\nQ[phi] = -0.003*dot(phi)\nQ[theta] = -0.001*dot(theta)\n";
        ///The names of the components of all outputs.
        pub const OUTPUTS: [&'static str; 3] = ["tip.x", "tip.y", "tip.z"];
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::System<T, 4> for Furuta<T> {
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn rhs(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 4> {
            let [_, q_theta, qd_phi, qd_theta] = x.data.0[0];
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            let t0 = qd_phi
                * (sin_theta
                    * (T::from_f64(0.01284) * sin_theta
                        - T::from_f64(0.01215) * cos_theta) - T::from_f64(0.00642))
                - qd_theta
                    * (T::from_f64(0.00167) * sin_theta
                        + T::from_f64(0.001595) * cos_theta);
            let t1 = qd_phi * qd_phi
                * (T::from_f64(0.00321)
                    + sin_theta
                        * (T::from_f64(0.006075) * cos_theta
                            - T::from_f64(0.00642) * sin_theta))
                + T::from_f64(0.001) * qd_theta;
            let t2 = t1 + T::from_f64(0.20601) * sin_theta
                - T::from_f64(0.014715) * cos_theta;
            let t3 = T::from_f64(0.04918274186423207) * cos_theta
                - T::from_f64(0.04697393609188632) * sin_theta;
            let t4 = T::from_f64(-0.033955)
                / (T::from_f64(0.00211158895)
                    - sin_theta
                        * (T::from_f64(0.0002126638) * cos_theta
                            + T::from_f64(0.00020603175) * sin_theta))
                * (T::from_f64(0.003) * qd_phi + qd_theta * t0 - t2 * t3);
            ::pendulum_core::nalgebra::SVector::from([
                qd_phi,
                qd_theta,
                t4,
                -(T::from_f64(29.45074363127669) * t2 + t3 * t4),
            ])
        }
        #[inline]
        fn layout(
            &self,
        ) -> ::core::option::Option<&'static ::pendulum_core::StateLayout> {
            Some(&<Furuta>::LAYOUT)
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Energy<T, 4> for Furuta<T> {
        #[inline]
        fn kinetic(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 4>) -> T {
            let [_, q_theta, qd_phi, qd_theta] = x.data.0[0];
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            let t0 = qd_theta
                * (T::from_f64(0.00167) * cos_theta - T::from_f64(0.001595) * sin_theta)
                + qd_phi
                    * (T::from_f64(0.031135)
                        - sin_theta
                            * (T::from_f64(0.00321) * cos_theta
                                + T::from_f64(0.0030375) * sin_theta));
            qd_theta * (T::from_f64(0.0169775) * qd_theta) + qd_phi * t0
        }
        #[inline]
        fn potential(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 4>) -> T {
            let [_, q_theta, _, _] = x.data.0[0];
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            T::from_f64(0.02943) - T::from_f64(0.014715) * sin_theta
                - T::from_f64(0.20601) * cos_theta
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> Furuta<T> {
        ///Output `tip`.
        #[inline]
        pub fn tip(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 3> {
            let [q_phi, q_theta, _, _] = x.data.0[0];
            let [(sin_phi, cos_phi), (sin_theta, cos_theta)] = q_phi
                .sin_cos_pair(q_theta);
            let t0 = T::from_f64(0.28) * sin_theta;
            ::pendulum_core::nalgebra::SVector::from([
                T::from_f64(0.25) * cos_phi - sin_phi * t0,
                T::from_f64(-0.28) * cos_theta,
                -(T::from_f64(0.25) * sin_phi + cos_phi * t0),
            ])
        }
        ///The rate of `tip` along the motion.
        #[inline]
        pub fn tip_rate(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 3> {
            let [q_phi, q_theta, qd_phi, qd_theta] = x.data.0[0];
            let t0 = T::from_f64(0.28) * qd_theta;
            let [(sin_phi, cos_phi), (sin_theta, cos_theta)] = q_phi
                .sin_cos_pair(q_theta);
            let t1 = T::from_f64(0.25) * qd_phi + cos_theta * t0;
            let t2 = sin_theta * (T::from_f64(0.28) * qd_phi);
            ::pendulum_core::nalgebra::SVector::from([
                -(cos_phi * t2 + sin_phi * t1),
                t0 * sin_theta,
                sin_phi * t2 - cos_phi * t1,
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
            let [q_phi, q_theta, _, _] = x.data.0[0];
            let [(sin_phi, cos_phi), (sin_theta, cos_theta)] = q_phi
                .sin_cos_pair(q_theta);
            let t0 = T::from_f64(0.25) * cos_phi;
            let t1 = T::from_f64(0.28) * sin_theta;
            let t2 = sin_phi * t1;
            let t3 = t0 - t2;
            let t4 = t2 - t0;
            let t5 = -(T::from_f64(0.25) * sin_phi + cos_phi * t1);
            let t6 = T::from_f64(0.28) * cos_theta;
            let t7 = -t6;
            let t8 = -(sin_phi * t6);
            let t9 = -(cos_phi * t6);
            (
                ::pendulum_core::nalgebra::SVector::from([t3, t7, t5]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [t5, T::from_f64(0.0), t4],
                    [t8, t1, t9],
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
            let [q_phi, q_theta, _, _] = x.data.0[0];
            let [(sin_phi, cos_phi), (sin_theta, cos_theta)] = q_phi
                .sin_cos_pair(q_theta);
            let t0 = T::from_f64(0.28) * sin_theta;
            ::pendulum_core::nalgebra::SVector::from([
                T::from_f64(0.25) * cos_phi - sin_phi * t0,
                T::from_f64(-0.28) * cos_theta,
                -(T::from_f64(0.25) * sin_phi + cos_phi * t0),
            ])
        }
        ///The rate of all outputs along the motion.
        #[inline]
        pub fn output_rates(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 3> {
            let [q_phi, q_theta, qd_phi, qd_theta] = x.data.0[0];
            let t0 = T::from_f64(0.28) * qd_theta;
            let [(sin_phi, cos_phi), (sin_theta, cos_theta)] = q_phi
                .sin_cos_pair(q_theta);
            let t1 = T::from_f64(0.25) * qd_phi + cos_theta * t0;
            let t2 = sin_theta * (T::from_f64(0.28) * qd_phi);
            ::pendulum_core::nalgebra::SVector::from([
                -(cos_phi * t2 + sin_phi * t1),
                t0 * sin_theta,
                sin_phi * t2 - cos_phi * t1,
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
            let [q_phi, q_theta, _, _] = x.data.0[0];
            let [(sin_phi, cos_phi), (sin_theta, cos_theta)] = q_phi
                .sin_cos_pair(q_theta);
            let t0 = T::from_f64(0.25) * cos_phi;
            let t1 = T::from_f64(0.28) * sin_theta;
            let t2 = sin_phi * t1;
            let t3 = t0 - t2;
            let t4 = t2 - t0;
            let t5 = -(T::from_f64(0.25) * sin_phi + cos_phi * t1);
            let t6 = T::from_f64(0.28) * cos_theta;
            let t7 = -t6;
            let t8 = -(sin_phi * t6);
            let t9 = -(cos_phi * t6);
            (
                ::pendulum_core::nalgebra::SVector::from([t3, t7, t5]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [t5, T::from_f64(0.0), t4],
                    [t8, t1, t9],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                ]),
            )
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::shapes::Shapes<4> for Furuta {
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
                        name: "arm",
                        kind: ::pendulum_core::shapes::ShapeKind::Mass,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "pendulum",
                        kind: ::pendulum_core::shapes::ShapeKind::Mass,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "arm",
                        kind: ::pendulum_core::shapes::ShapeKind::Rod,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "arm",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "pendulum",
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
                    let [q_phi, q_theta, _, _] = x.data.0[0];
                    let [(sin_phi, cos_phi), (sin_theta, cos_theta)] = q_phi
                        .sin_cos_pair(q_theta);
                    let t0 = T::from_f64(0.12) * cos_phi;
                    let t1 = T::from_f64(-0.12) * sin_phi;
                    let t2 = -(T::from_f64(0.14) * cos_theta
                        + T::from_f64(0.01) * sin_theta);
                    let t3 = T::from_f64(-0.28) * cos_theta;
                    let t4 = T::from_f64(0.01) * cos_theta
                        - T::from_f64(0.14) * sin_theta;
                    let t5 = T::from_f64(0.27) * cos_phi + sin_phi * t4;
                    let t6 = cos_phi * t4 - T::from_f64(0.27) * sin_phi;
                    let t7 = T::from_f64(0.25) * cos_phi;
                    let t8 = T::from_f64(-0.25) * sin_phi;
                    let t9 = T::from_f64(0.28) * sin_theta;
                    let t10 = t7 - sin_phi * t9;
                    let t11 = -(T::from_f64(0.25) * sin_phi + cos_phi * t9);
                    [
                        t0,
                        T::from_f64(0.01),
                        t1,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t5,
                        t2,
                        t6,
                        t7,
                        T::from_f64(0.0),
                        t8,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t7,
                        T::from_f64(0.0),
                        t8,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t7,
                        T::from_f64(0.0),
                        t8,
                        t10,
                        t3,
                        t11,
                    ]
                },
            )
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::Cast<4> for Furuta {
        type In<T: ::pendulum_core::real::Real> = Furuta<T>;
        fn cast<T: ::pendulum_core::real::Real>(&self) -> Furuta<T> {
            Furuta::cast(self)
        }
        #[inline]
        fn gather<'m, T: ::pendulum_core::real::lanes::Lanes>(
            models: impl ::core::ops::Fn(usize) -> &'m Self,
        ) -> Furuta<T>
        where
            Self: 'm,
        {
            let scalar = <<T as ::pendulum_core::real::lanes::Lanes>::Scalar as ::pendulum_core::real::Real>::from_f64;
            Furuta {
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
pub use __Furuta::{Furuta, FurutaParams};
