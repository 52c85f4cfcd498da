#[allow(non_snake_case)]
mod __PointMasses {
    ///Parameters of [`PointMasses`].
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct PointMassesParams {
        ///In kg.
        pub m1: f64,
        ///In kg.
        pub m2: f64,
        ///In m.
        pub l1: f64,
        ///In m.
        pub l2: f64,
        ///In m/s^2.
        pub g: f64,
    }
    impl ::core::default::Default for PointMassesParams {
        #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
        fn default() -> Self {
            Self {
                m1: 1f64,
                m2: 1f64,
                l1: 1f64,
                l2: 1f64,
                g: 9.81f64,
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl PointMassesParams {
        /// The names of the parameters, in the order of their declaration.
        pub const NAMES: [&'static str; 5] = ["m1", "m2", "l1", "l2", "g"];
        /// The values of the parameters, in the order of [`NAMES`](Self::NAMES).
        pub const fn to_array(self) -> [f64; 5] {
            [self.m1, self.m2, self.l1, self.l2, self.g]
        }
        /// The parameters with these values, in the order of [`NAMES`](Self::NAMES).
        pub const fn from_array(values: [f64; 5]) -> Self {
            let [v0, v1, v2, v3, v4] = values;
            Self {
                m1: v0,
                m2: v1,
                l1: v2,
                l2: v3,
                g: v4,
            }
        }
    }
    /// Two point masses on rods without mass.
    ///
    /**# Equations of motion

```text
A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints

A[theta1, theta1] = m1*l1^2 + m2*l1^2
A[theta1, theta2] = m2*l1*l2*cos(theta1 - theta2)
A[theta2, theta2] = m2*l2^2
b[theta1] = m2*l1*l2*dot(theta2)^2*sin(theta1 - theta2) + (m1*l1*g + m2*l1*g)*sin(theta1)
b[theta2] = m2*l2*g*sin(theta2) - m2*l1*l2*dot(theta1)^2*sin(theta1 - theta2)
```

# Constants, computed by `new`

```text
k0 = l1
k1 = l2
k2 = m2*l2^2
k3 = m2*l1*l2
k4 = m1*l1*g + m2*l1*g
k5 = m2*l2*g
k6 = m1*m2*l1^2*l2^2
k7 = m1*m2*l1*l2^2*g/(m2*l2^2)
k8 = m2^2*l1*l2^2*g/(m2*l2^2)
k9 = 0.5*(m1*l1^2 + m2*l1^2)
k10 = 0.5*m2*l2^2
k11 = -1/(m2*l2^2)
k12 = -l1/l2
```
*/
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct PointMasses<T = f64> {
        params: PointMassesParams,
        constants: [T; 13],
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl PointMasses {
        /// Builds the model: checks the parameters, and computes once whatever depends on them alone.
        ///
        /// # Errors
        ///
        /// The first parameter, or combination of parameters, that is not finite or that no rigid body can
        /// have.
        pub fn new(
            params: PointMassesParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            #[inline]
            fn rules<T: ::pendulum_core::real::Real>(given: [T; 5]) -> [T; 2] {
                let [p_m1, p_m2, p_l1, p_l2, p_g] = given;
                [p_m1, p_m2]
            }
            #[inline]
            fn constants<T: ::pendulum_core::real::Real>(given: [T; 5]) -> [T; 13] {
                let [p_m1, p_m2, p_l1, p_l2, p_g] = given;
                let t0 = p_g * (p_m2 * p_l2);
                let t1 = p_l2 * p_l2;
                let t2 = p_m2 * t1;
                let t3 = T::from_f64(0.5) * t2;
                let t4 = p_m2 * p_l1;
                let t5 = p_g * (p_m1 * p_l1) + p_g * t4;
                let t6 = p_l2 * t4;
                let t7 = p_l1 * p_l1;
                let t8 = T::from_f64(0.5) * (p_m1 * t7 + p_m2 * t7);
                let t9 = p_m1 * p_m2;
                let t10 = t1 * (t7 * t9);
                let t11 = T::from_f64(1.0) / t2;
                let t12 = p_g * (t1 * (p_l1 * t9)) * t11;
                let t13 = t11 * (p_g * (t1 * (p_l1 * (p_m2 * p_m2))));
                let t14 = T::from_f64(-1.0) / t2;
                let t15 = t6 * t14;
                [p_l1, p_l2, t2, t6, t5, t0, t10, t12, t13, t8, t3, t14, t15]
            }
            let given = params.to_array();
            for (name, value) in PointMassesParams::NAMES.into_iter().zip(given) {
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
            let [r0, r1] = rules(given);
            if !(r0 > 0.0) {
                return Err(
                    ::pendulum_core::ParameterError::new(
                        "m1",
                        r0,
                        "the mass of a point of `upper` must be positive",
                        &[],
                    ),
                );
            }
            if !(r1 > 0.0) {
                return Err(
                    ::pendulum_core::ParameterError::new(
                        "m2",
                        r1,
                        "the mass of a point of `lower` must be positive",
                        &[],
                    ),
                );
            }
            let constants = constants(given);
            let names: [&'static str; 13] = [
                "l1",
                "l2",
                "m2*l2^2",
                "m2*l1*l2",
                "m1*l1*g + m2*l1*g",
                "m2*l2*g",
                "m1*m2*l1^2*l2^2",
                "m1*m2*l1*l2^2*g/(m2*l2^2)",
                "m2^2*l1*l2^2*g/(m2*l2^2)",
                "0.5*(m1*l1^2 + m2*l1^2)",
                "0.5*m2*l2^2",
                "-1/(m2*l2^2)",
                "-l1/l2",
            ];
            for (name, value) in names.into_iter().zip(constants) {
                if !value.is_finite() {
                    let given: [_; 5] = ::core::array::from_fn(|n| (
                        PointMassesParams::NAMES[n],
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
        pub fn cast<T: ::pendulum_core::real::Real>(&self) -> PointMasses<T> {
            PointMasses {
                params: self.params,
                constants: self.constants.map(T::from_f64),
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> PointMasses<T> {
        /// The parameters that the model was built from.
        pub fn params(&self) -> &PointMassesParams {
            &self.params
        }
        /// The model with other parameters, in the same number type. Its constants are computed anew.
        ///
        /// # Errors
        ///
        /// Those of `new`.
        pub fn with_params(
            &self,
            params: PointMassesParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            Ok(<PointMasses>::new(params)?.cast())
        }
    }
    impl PointMasses {
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
                            ::pendulum_core::Operations::new(9, 19, 1, 2, 0, 32),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, L^T D L",
                                    ::pendulum_core::Operations::new(8, 17, 1, 2, 0, 32),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L",
                                    ::pendulum_core::Operations::new(8, 17, 1, 2, 0, 32),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, adjugate",
                                    ::pendulum_core::Operations::new(21, 28, 1, 2, 0, 37),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C, adjugate",
                                    ::pendulum_core::Operations::new(33, 40, 1, 2, 0, 37),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "articulated bodies",
                                    ::pendulum_core::Operations::new(24, 40, 2, 2, 0, 48),
                                ),
                            ],
                        ),
                ),
                (
                    "jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first, L^T D L, exact quotient, derived in the graph",
                            ::pendulum_core::Operations::new(23, 43, 1, 2, 0, 39),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, inverse, derived in the graph",
                                    ::pendulum_core::Operations::new(19, 43, 1, 2, 0, 38),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, inverse, derived and expanded",
                                    ::pendulum_core::Operations::new(19, 43, 1, 2, 0, 38),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, inverse, derived in the graph",
                                    ::pendulum_core::Operations::new(43, 59, 1, 2, 0, 49),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C, inverse, derived in the graph",
                                    ::pendulum_core::Operations::new(91, 95, 1, 2, 0, 44),
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
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(3, 6, 0, 1, 0, 26),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(3, 7, 0, 1, 0, 25),
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
                                    ::pendulum_core::Operations::new(2, 2, 0, 2, 0, 22),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(2, 2, 0, 2, 0, 22),
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
        pub const EQUATIONS: &'static str = "A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints\n\nA[theta1, theta1] = m1*l1^2 + m2*l1^2\nA[theta1, theta2] = m2*l1*l2*cos(theta1 - theta2)\nA[theta2, theta2] = m2*l2^2\nb[theta1] = m2*l1*l2*dot(theta2)^2*sin(theta1 - theta2) + (m1*l1*g + m2*l1*g)*sin(theta1)\nb[theta2] = m2*l2*g*sin(theta2) - m2*l1*l2*dot(theta1)^2*sin(theta1 - theta2)\n";
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::System<T, 4>
    for PointMasses<T> {
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn rhs(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 4> {
            let [q_theta1, q_theta2, qd_theta1, qd_theta2] = x.data.0[0];
            let k2 = self.constants[2];
            let k3 = self.constants[3];
            let k5 = self.constants[5];
            let k6 = self.constants[6];
            let k7 = self.constants[7];
            let k8 = self.constants[8];
            let k11 = self.constants[11];
            let k12 = self.constants[12];
            let [(sin_theta1, cos_theta1), (sin_theta2, cos_theta2)] = q_theta1
                .sin_cos_pair(q_theta2);
            let t0 = sin_theta1 * cos_theta2 - cos_theta1 * sin_theta2;
            let t1 = k3 * t0;
            let t2 = qd_theta1 * qd_theta1 * t1;
            let t3 = k12 * (cos_theta2 * cos_theta1 + sin_theta1 * sin_theta2);
            let t4 = k7 * sin_theta1 + k8 * cos_theta2 * t0 + qd_theta2 * qd_theta2 * t1
                - t2 * t3;
            let t5 = k2 / (k6 + t1 * t1) * t4;
            ::pendulum_core::nalgebra::SVector::from([
                qd_theta1,
                qd_theta2,
                -t5,
                k11 * (k5 * sin_theta2 - t2) - t3 * t5,
            ])
        }
        #[inline]
        fn layout(
            &self,
        ) -> ::core::option::Option<&'static ::pendulum_core::StateLayout> {
            Some(&<PointMasses>::LAYOUT)
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Jacobian<T, 4>
    for PointMasses<T> {
        #[inline]
        fn jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SMatrix<T, 4, 4> {
            self.rhs_and_jacobian(t, x).1
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn rhs_and_jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 4>,
            ::pendulum_core::nalgebra::SMatrix<T, 4, 4>,
        ) {
            let [q_theta1, q_theta2, qd_theta1, qd_theta2] = x.data.0[0];
            let k2 = self.constants[2];
            let k3 = self.constants[3];
            let k4 = self.constants[4];
            let k5 = self.constants[5];
            let k6 = self.constants[6];
            let k7 = self.constants[7];
            let k8 = self.constants[8];
            let k11 = self.constants[11];
            let k12 = self.constants[12];
            let t0 = k3 * qd_theta2;
            let t1 = qd_theta2 * t0;
            let t2 = k3 * qd_theta1;
            let t3 = qd_theta1 * t2;
            let [(sin_theta1, cos_theta1), (sin_theta2, cos_theta2)] = q_theta1
                .sin_cos_pair(q_theta2);
            let t4 = sin_theta1 * cos_theta2 - cos_theta1 * sin_theta2;
            let t5 = k3 * t4;
            let t6 = k2 / (k6 + t5 * t5);
            let t7 = t4 * t3;
            let t8 = cos_theta2 * cos_theta1 + sin_theta1 * sin_theta2;
            let t9 = k12 * t8;
            let t10 = t6 * (k7 * sin_theta1 + t4 * (t1 + k8 * cos_theta2) - t7 * t9);
            let t11 = -t10;
            let t12 = k11 * (k5 * sin_theta2 - t7) - t9 * t10;
            let t13 = t1 * t8 - t12 * t5;
            let t14 = t3 * t8 - t10 * t5;
            let t15 = T::from_f64(2.0) * t4;
            let t16 = t2 * t15;
            let t17 = t6 * t0 * t15;
            let t18 = -t17;
            let t19 = -(t9 * t17);
            let t20 = t6 * (k4 * cos_theta1 + t13 - t9 * t14);
            let t21 = t14 + k5 * cos_theta2;
            let t22 = -(k11 * t14 + t9 * t20);
            let t23 = -t20;
            let t24 = t6 * (t9 * t21 - t13);
            let t25 = k11 * t21 - t9 * t24;
            let t26 = -t24;
            let t27 = t6 * t9 * t16;
            let t28 = t9 * t27 - k11 * t16;
            (
                ::pendulum_core::nalgebra::SVector::from([
                    qd_theta1,
                    qd_theta2,
                    t11,
                    t12,
                ]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [T::from_f64(0.0), T::from_f64(0.0), t23, t22],
                    [T::from_f64(0.0), T::from_f64(0.0), t26, t25],
                    [T::from_f64(1.0), T::from_f64(0.0), t27, t28],
                    [T::from_f64(0.0), T::from_f64(1.0), t18, t19],
                ]),
            )
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
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
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Energy<T, 4>
    for PointMasses<T> {
        #[inline]
        fn kinetic(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 4>) -> T {
            let [q_theta1, q_theta2, qd_theta1, qd_theta2] = x.data.0[0];
            let k3 = self.constants[3];
            let k9 = self.constants[9];
            let k10 = self.constants[10];
            let (_, cos0) = (q_theta1 - q_theta2).sin_cos();
            qd_theta2 * (qd_theta2 * k10)
                + qd_theta1 * (cos0 * (qd_theta2 * k3) + qd_theta1 * k9)
        }
        #[inline]
        fn potential(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 4>) -> T {
            let [q_theta1, q_theta2, _, _] = x.data.0[0];
            let k4 = self.constants[4];
            let k5 = self.constants[5];
            let [(_, cos_theta1), (_, cos_theta2)] = q_theta1.sin_cos_pair(q_theta2);
            -(cos_theta1 * k4 + cos_theta2 * k5)
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::shapes::Shapes<4> for PointMasses {
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
                        kind: ::pendulum_core::shapes::ShapeKind::Mass,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "lower",
                        kind: ::pendulum_core::shapes::ShapeKind::Mass,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "upper",
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
                        name: "bob",
                        kind: ::pendulum_core::shapes::ShapeKind::Point,
                        points: 1,
                        radius: false,
                    },
                ],
                &{
                    let [q_theta1, q_theta2, _, _] = x.data.0[0];
                    let k0 = self.constants[0];
                    let k1 = self.constants[1];
                    let [(sin_theta1, cos_theta1), (sin_theta2, cos_theta2)] = q_theta1
                        .sin_cos_pair(q_theta2);
                    let t0 = k0 * sin_theta1;
                    let t1 = t0 + k1 * sin_theta2;
                    let t2 = k0 * cos_theta1;
                    let t3 = -(t2 + k1 * cos_theta2);
                    let t4 = -t2;
                    [
                        t0,
                        t4,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t1,
                        t3,
                        T::from_f64(0.0),
                        t0,
                        t4,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t0,
                        t4,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t0,
                        t4,
                        T::from_f64(0.0),
                        t1,
                        t3,
                        T::from_f64(0.0),
                    ]
                },
            )
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::CastJacobian<4> for PointMasses {
        #[inline]
        fn with_jacobian<T: ::pendulum_core::real::Real>(
            model: &PointMasses<T>,
        ) -> &impl ::pendulum_core::Jacobian<T, 4> {
            model
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::Cast<4> for PointMasses {
        type In<T: ::pendulum_core::real::Real> = PointMasses<T>;
        fn cast<T: ::pendulum_core::real::Real>(&self) -> PointMasses<T> {
            PointMasses::cast(self)
        }
        #[inline]
        fn gather<'m, T: ::pendulum_core::real::lanes::Lanes>(
            models: impl ::core::ops::Fn(usize) -> &'m Self,
        ) -> PointMasses<T>
        where
            Self: 'm,
        {
            let scalar = <<T as ::pendulum_core::real::lanes::Lanes>::Scalar as ::pendulum_core::real::Real>::from_f64;
            PointMasses {
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
pub use __PointMasses::{PointMasses, PointMassesParams};
