#[allow(non_snake_case)]
mod __RodsAndWall {
    ///Parameters of [`RodsAndWall`].
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct RodsAndWallParams {
        ///In kg.
        pub m: f64,
        ///In m.
        pub l: f64,
        ///A plain number.
        pub e: f64,
    }
    impl ::core::default::Default for RodsAndWallParams {
        #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
        fn default() -> Self {
            Self {
                m: 1f64,
                l: 1f64,
                e: 0.1f64,
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl RodsAndWallParams {
        /// The names of the parameters, in the order of their declaration.
        pub const NAMES: [&'static str; 3] = ["m", "l", "e"];
        /// The values of the parameters, in the order of [`NAMES`](Self::NAMES).
        pub const fn to_array(self) -> [f64; 3] {
            [self.m, self.l, self.e]
        }
        /// The parameters with these values, in the order of [`NAMES`](Self::NAMES).
        pub const fn from_array(values: [f64; 3]) -> Self {
            let [v0, v1, v2] = values;
            Self { m: v0, l: v1, e: v2 }
        }
    }
    /// Two equal rods, and a wall to the left of both.
    ///
    /**# Equations of motion

```text
A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q all other forces

A[theta1, theta1] = 4/3*m*l^2
A[theta1, theta2] = 0.5*m*l^2*cos(theta1 - theta2)
A[theta2, theta2] = 1/3*m*l^2
b[theta1] = 0.5*m*l^2*dot(theta2)^2*sin(theta1 - theta2) + 14.715*m*l*sin(theta1)
b[theta2] = 4.905*m*l*sin(theta2) - 0.5*m*l^2*dot(theta1)^2*sin(theta1 - theta2)
Q[theta1] = l*cos(theta1)*force(beside_tip) + l*cos(theta1)*force(beside_elbow)
Q[theta2] = l*cos(theta2)*force(beside_tip)

and along what hinders the motion
force(beside_tip): a wall at the zero of l*sin(theta2) + 0.1 + l*sin(theta1), restitution e
force(beside_elbow): a wall at the zero of 0.1 + l*sin(theta1), restitution e
```

# Constants, computed by `new`

```text
k0 = l
k1 = e
k2 = -l
k3 = 0.5*m*l^2
k4 = 1/3*m*l^2
k5 = 14.715*m*l
k6 = 4.905*m*l
k7 = 7/36*(m*l^2)^2
k8 = 0.25*(m*l^2)^2
k9 = -1/(1/3*m*l^2)
k10 = 2/3*m*l^2
k11 = 1/6*m*l^2
k12 = -0.5/(1/3)
```
*/
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct RodsAndWall<T = f64> {
        params: RodsAndWallParams,
        constants: [T; 13],
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl RodsAndWall {
        /// Builds the model: checks the parameters, and computes once whatever depends on them alone.
        ///
        /// # Errors
        ///
        /// The first parameter, or combination of parameters, that is not finite or that no rigid body can
        /// have.
        pub fn new(
            params: RodsAndWallParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            #[inline]
            fn rules<T: ::pendulum_core::real::Real>(given: [T; 3]) -> [T; 3] {
                let [p_m, p_l, p_e] = given;
                [p_m, p_e, T::from_f64(1.0) - p_e]
            }
            #[inline]
            fn constants<T: ::pendulum_core::real::Real>(given: [T; 3]) -> [T; 13] {
                let [p_m, p_l, p_e] = given;
                let t0 = -p_l;
                let t1 = p_m * (p_l * p_l);
                let t2 = T::from_f64(0.6666666666666666) * t1;
                let t3 = T::from_f64(0.16666666666666666) * t1;
                let t4 = T::from_f64(0.5) * t1;
                let t5 = T::from_f64(0.3333333333333333) * t1;
                let t6 = t1 * t1;
                let t7 = T::from_f64(0.19444444444444445) * t6;
                let t8 = T::from_f64(0.25) * t6;
                let t9 = T::from_f64(-1.0) / t5;
                let t10 = t4 * t9;
                let t11 = p_m * p_l;
                let t12 = T::from_f64(14.715) * t11;
                let t13 = T::from_f64(4.905) * t11;
                [p_l, p_e, t0, t4, t5, t12, t13, t7, t8, t9, t2, t3, t10]
            }
            let given = params.to_array();
            for (name, value) in RodsAndWallParams::NAMES.into_iter().zip(given) {
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
                        "the mass of a rod of `arm` must be positive",
                        &[],
                    ),
                );
            }
            if !(r1 >= 0.0) {
                return Err(
                    ::pendulum_core::ParameterError::new(
                        "e",
                        r1,
                        "the restitution of wall `beside_tip` must lie between 0 and 1",
                        &[],
                    ),
                );
            }
            if !(r2 >= 0.0) {
                return Err(
                    ::pendulum_core::ParameterError::new(
                        "1 - e",
                        r2,
                        "the restitution of wall `beside_tip` must lie between 0 and 1",
                        &[("e", params.e)],
                    ),
                );
            }
            let constants = constants(given);
            let names: [&'static str; 13] = [
                "l",
                "e",
                "-l",
                "0.5*m*l^2",
                "1/3*m*l^2",
                "14.715*m*l",
                "4.905*m*l",
                "7/36*(m*l^2)^2",
                "0.25*(m*l^2)^2",
                "-1/(1/3*m*l^2)",
                "2/3*m*l^2",
                "1/6*m*l^2",
                "-0.5/(1/3)",
            ];
            for (name, value) in names.into_iter().zip(constants) {
                if !value.is_finite() {
                    let given: [_; 3] = ::core::array::from_fn(|n| (
                        RodsAndWallParams::NAMES[n],
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
        pub fn cast<T: ::pendulum_core::real::Real>(&self) -> RodsAndWall<T> {
            RodsAndWall {
                params: self.params,
                constants: self.constants.map(T::from_f64),
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> RodsAndWall<T> {
        /// The parameters that the model was built from.
        pub fn params(&self) -> &RodsAndWallParams {
            &self.params
        }
        /// The model with other parameters, in the same number type. Its constants are computed anew.
        ///
        /// # Errors
        ///
        /// Those of `new`.
        pub fn with_params(
            &self,
            params: RodsAndWallParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            Ok(<RodsAndWall>::new(params)?.cast())
        }
    }
    impl RodsAndWall {
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
                            ::pendulum_core::Operations::new(11, 22, 1, 2, 0, 32),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, L^T D L",
                                    ::pendulum_core::Operations::new(11, 22, 1, 2, 0, 33),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L",
                                    ::pendulum_core::Operations::new(11, 22, 1, 2, 0, 33),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, adjugate",
                                    ::pendulum_core::Operations::new(24, 31, 1, 2, 0, 37),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C, adjugate",
                                    ::pendulum_core::Operations::new(33, 42, 1, 2, 0, 38),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "articulated bodies",
                                    ::pendulum_core::Operations::new(30, 46, 2, 2, 0, 48),
                                ),
                            ],
                        ),
                ),
                (
                    "measures",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(3, 6, 0, 2, 0, 23),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(3, 6, 0, 2, 0, 23),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(4, 6, 0, 2, 0, 23),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(4, 6, 0, 2, 0, 23),
                                ),
                            ],
                        ),
                ),
                (
                    "response",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, expanded, L^T D L, exact quotient",
                            ::pendulum_core::Operations::new(19, 38, 1, 2, 0, 36),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first, L^T D L",
                                    ::pendulum_core::Operations::new(20, 38, 1, 2, 0, 35),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, L^T D L",
                                    ::pendulum_core::Operations::new(20, 38, 1, 2, 0, 36),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, inverse",
                                    ::pendulum_core::Operations::new(38, 46, 1, 2, 0, 43),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C, inverse",
                                    ::pendulum_core::Operations::new(42, 57, 1, 2, 0, 44),
                                ),
                            ],
                        ),
                ),
                (
                    "kinetic",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, expanded",
                            ::pendulum_core::Operations::new(3, 6, 0, 1, 0, 26),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(3, 7, 0, 1, 0, 26),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(3, 7, 0, 1, 0, 26),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(13, 23, 0, 2, 0, 32),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C",
                                    ::pendulum_core::Operations::new(22, 23, 0, 2, 0, 35),
                                ),
                            ],
                        ),
                ),
                (
                    "potential",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(2, 2, 0, 2, 0, 23),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(2, 2, 0, 2, 0, 23),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(2, 2, 0, 2, 0, 23),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C",
                                    ::pendulum_core::Operations::new(3, 2, 0, 2, 0, 23),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(3, 2, 0, 2, 0, 23),
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
        pub const EQUATIONS: &'static str = "A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q all other forces\n\nA[theta1, theta1] = 4/3*m*l^2\nA[theta1, theta2] = 0.5*m*l^2*cos(theta1 - theta2)\nA[theta2, theta2] = 1/3*m*l^2\nb[theta1] = 0.5*m*l^2*dot(theta2)^2*sin(theta1 - theta2) + 14.715*m*l*sin(theta1)\nb[theta2] = 4.905*m*l*sin(theta2) - 0.5*m*l^2*dot(theta1)^2*sin(theta1 - theta2)\nQ[theta1] = l*cos(theta1)*force(beside_tip) + l*cos(theta1)*force(beside_elbow)\nQ[theta2] = l*cos(theta2)*force(beside_tip)\n\nand along what hinders the motion\nforce(beside_tip): a wall at the zero of l*sin(theta2) + 0.1 + l*sin(theta1), restitution e\nforce(beside_elbow): a wall at the zero of 0.1 + l*sin(theta1), restitution e\n";
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::System<T, 4>
    for RodsAndWall<T> {
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
            Some(&<RodsAndWall>::LAYOUT)
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
            let k0 = self.constants[0];
            let k3 = self.constants[3];
            let k4 = self.constants[4];
            let k5 = self.constants[5];
            let k6 = self.constants[6];
            let k7 = self.constants[7];
            let k8 = self.constants[8];
            let k9 = self.constants[9];
            let k12 = self.constants[12];
            let [(sin_theta1, cos_theta1), (sin_theta2, cos_theta2)] = q_theta1
                .sin_cos_pair(q_theta2);
            let t0 = sin_theta1 * cos_theta2 - cos_theta1 * sin_theta2;
            let t1 = k3 * t0;
            let t2 = k6 * sin_theta2 - qd_theta1 * qd_theta1 * t1 - k0 * cos_theta2 * f0;
            let t3 = k12 * (cos_theta2 * cos_theta1 + sin_theta1 * sin_theta2);
            let t4 = k5 * sin_theta1 + qd_theta2 * qd_theta2 * t1 + t2 * t3
                - k0 * cos_theta1 * (f0 + f1);
            let t5 = t4 * (k4 / (k7 + k8 * t0 * t0));
            ::pendulum_core::nalgebra::SVector::from([
                qd_theta1,
                qd_theta2,
                -t5,
                k9 * t2 - t3 * t5,
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
    for RodsAndWall<T> {
        #[inline]
        fn constraints(&self) -> &'static [::pendulum_core::hybrid::Constraint] {
            const {
                &[
                    ::pendulum_core::hybrid::Constraint {
                        name: "beside_tip",
                        rate: &[],
                    },
                    ::pendulum_core::hybrid::Constraint {
                        name: "beside_elbow",
                        rate: &[],
                    },
                ]
            }
        }
        #[inline]
        fn laws(
            &self,
        ) -> [::pendulum_core::hybrid::Law<T>; ::pendulum_core::hybrid::MOST] {
            let k1 = self.constants[1];
            let mut laws = [::pendulum_core::hybrid::Law::default(); ::pendulum_core::hybrid::MOST];
            laws[0] = ::pendulum_core::hybrid::Law {
                slipping: T::from_f64(0.0),
                sticking: T::from_f64(0.0),
                low: Some(T::from_f64(0.0)),
                high: None,
                restitution: k1,
                slow: T::from_f64(0.0),
            };
            laws[1] = ::pendulum_core::hybrid::Law {
                slipping: T::from_f64(0.0),
                sticking: T::from_f64(0.0),
                low: Some(T::from_f64(0.0)),
                high: None,
                restitution: k1,
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
            let k0 = self.constants[0];
            let [(sin_theta2, cos_theta2), (sin_theta1, cos_theta1)] = q_theta2
                .sin_cos_pair(q_theta1);
            let t0 = T::from_f64(0.1) + k0 * sin_theta1;
            let t1 = k0 * qd_theta1 * cos_theta1;
            let mut measures = [[T::from_f64(0.0); 2]; ::pendulum_core::hybrid::MOST];
            measures[0] = [k0 * sin_theta2 + t0, t1 + k0 * qd_theta2 * cos_theta2];
            measures[1] = [t0, t1];
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
            let k0 = self.constants[0];
            let k3 = self.constants[3];
            let k4 = self.constants[4];
            let k5 = self.constants[5];
            let k6 = self.constants[6];
            let k7 = self.constants[7];
            let k8 = self.constants[8];
            let k9 = self.constants[9];
            let k12 = self.constants[12];
            let t0 = qd_theta1 * qd_theta1;
            let t1 = qd_theta2 * qd_theta2;
            let [(sin_theta1, cos_theta1), (sin_theta2, cos_theta2)] = q_theta1
                .sin_cos_pair(q_theta2);
            let t2 = sin_theta1 * cos_theta2 - cos_theta1 * sin_theta2;
            let t3 = k4 / (k7 + k8 * t2 * t2);
            let t4 = k3 * t2;
            let t5 = k0 * cos_theta2;
            let t6 = k6 * sin_theta2 - t0 * t4 - f0 * t5;
            let t7 = k12 * (cos_theta2 * cos_theta1 + sin_theta1 * sin_theta2);
            let t8 = k0 * cos_theta1;
            let t9 = t6 * t7 + k5 * sin_theta1 + t1 * t4 - t8 * (f0 + f1);
            let t10 = t3 * t9;
            let t11 = -t10;
            let t12 = k9 * t6 - t7 * t10;
            let t13 = t8 * t10 + k0 * sin_theta1 * t0;
            let t14 = t5 * t12 - k0 * sin_theta2 * t1 - t13;
            let t15 = -t13;
            let t16 = t3 * (t8 + t5 * t7);
            let t17 = t3 * t8;
            let t18 = t7 * t16 - k9 * t5;
            let t19 = t8 * t16 + t5 * t18;
            let t20 = t7 * t17;
            let t21 = t8 * t17;
            let t22 = t21 + t5 * t20;
            let mut response = ::pendulum_core::hybrid::Response::new(
                ::pendulum_core::nalgebra::SVector::from([
                    qd_theta1,
                    qd_theta2,
                    t11,
                    t12,
                ]),
            );
            response.accelerations[0] = t14;
            response.accelerations[1] = t15;
            response.columns[0] = ::pendulum_core::nalgebra::SVector::from([
                T::from_f64(0.0),
                T::from_f64(0.0),
                t16,
                t18,
            ]);
            response.columns[1] = ::pendulum_core::nalgebra::SVector::from([
                T::from_f64(0.0),
                T::from_f64(0.0),
                t17,
                t20,
            ]);
            response.matrix[0][0] = t19;
            response.matrix[0][1] = t22;
            response.matrix[1][0] = response.matrix[0][1];
            response.matrix[1][1] = t21;
            response
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Energy<T, 4>
    for RodsAndWall<T> {
        #[inline]
        fn kinetic(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 4>) -> T {
            let [q_theta1, q_theta2, qd_theta1, qd_theta2] = x.data.0[0];
            let k3 = self.constants[3];
            let k10 = self.constants[10];
            let k11 = self.constants[11];
            let (_, cos0) = (q_theta1 - q_theta2).sin_cos();
            k10 * qd_theta1 * qd_theta1
                + qd_theta2 * (k3 * (cos0 * qd_theta1) + k11 * qd_theta2)
        }
        #[inline]
        fn potential(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 4>) -> T {
            let [q_theta1, q_theta2, _, _] = x.data.0[0];
            let k5 = self.constants[5];
            let k6 = self.constants[6];
            let [(_, cos_theta1), (_, cos_theta2)] = q_theta1.sin_cos_pair(q_theta2);
            T::from_f64(-10.3005) - (k5 * cos_theta1 + k6 * cos_theta2)
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::shapes::Shapes<4> for RodsAndWall {
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
                        kind: ::pendulum_core::shapes::ShapeKind::Rod,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "drawn",
                        kind: ::pendulum_core::shapes::ShapeKind::Plate,
                        points: 4,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "lower",
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
                    ::pendulum_core::shapes::Outline {
                        name: "elbow",
                        kind: ::pendulum_core::shapes::ShapeKind::Point,
                        points: 1,
                        radius: false,
                    },
                ],
                &{
                    let [q_theta1, q_theta2, _, _] = x.data.0[0];
                    let k0 = self.constants[0];
                    let k2 = self.constants[2];
                    let [(sin_theta1, cos_theta1), (sin_theta2, cos_theta2)] = q_theta1
                        .sin_cos_pair(q_theta2);
                    let t0 = k0 * sin_theta1;
                    let t1 = k2 * cos_theta1;
                    let t2 = k0 * (sin_theta1 + sin_theta2);
                    let t3 = k2 * (cos_theta1 + cos_theta2);
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t0,
                        t1,
                        T::from_f64(0.0),
                        T::from_f64(-0.15),
                        T::from_f64(-2.1),
                        T::from_f64(0.0),
                        T::from_f64(-0.1),
                        T::from_f64(-2.1),
                        T::from_f64(0.0),
                        T::from_f64(-0.1),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(-0.15),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t0,
                        t1,
                        T::from_f64(0.0),
                        t2,
                        t3,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t0,
                        t1,
                        T::from_f64(0.0),
                        t2,
                        t3,
                        T::from_f64(0.0),
                        t0,
                        t1,
                        T::from_f64(0.0),
                    ]
                },
            )
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::Cast<4> for RodsAndWall {
        const HYBRID: bool = true;
        type In<T: ::pendulum_core::real::Real> = RodsAndWall<T>;
        fn cast<T: ::pendulum_core::real::Real>(&self) -> RodsAndWall<T> {
            RodsAndWall::cast(self)
        }
        #[inline]
        fn gather<'m, T: ::pendulum_core::real::lanes::Lanes>(
            models: impl ::core::ops::Fn(usize) -> &'m Self,
        ) -> RodsAndWall<T>
        where
            Self: 'm,
        {
            let scalar = <<T as ::pendulum_core::real::lanes::Lanes>::Scalar as ::pendulum_core::real::Real>::from_f64;
            RodsAndWall {
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
pub use __RodsAndWall::{RodsAndWall, RodsAndWallParams};
