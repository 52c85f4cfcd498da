#[allow(non_snake_case)]
mod __Asymmetric {
    ///Parameters of [`Asymmetric`].
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct AsymmetricParams {
        ///In kg.
        pub m1: f64,
        ///In m.
        pub c1: f64,
        ///In kg m^2.
        pub i1: f64,
        ///In kg.
        pub m2: f64,
        ///In m.
        pub c2: f64,
        ///In kg m^2.
        pub i2: f64,
        ///In m.
        pub d: f64,
        ///In N m.
        pub k1: f64,
        ///In N m.
        pub k2: f64,
        ///In m/s^2.
        pub g: f64,
    }
    impl ::core::default::Default for AsymmetricParams {
        #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
        fn default() -> Self {
            Self {
                m1: 1.2f64,
                c1: 0.4f64,
                i1: 0.09f64,
                m2: 0.7f64,
                c2: 0.5f64,
                i2: 0.05f64,
                d: 0.9f64,
                k1: 4f64,
                k2: 2.5f64,
                g: 9.81f64,
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl AsymmetricParams {
        /// The names of the parameters, in the order of their declaration.
        pub const NAMES: [&'static str; 10] = [
            "m1",
            "c1",
            "i1",
            "m2",
            "c2",
            "i2",
            "d",
            "k1",
            "k2",
            "g",
        ];
        /// The values of the parameters, in the order of [`NAMES`](Self::NAMES).
        pub const fn to_array(self) -> [f64; 10] {
            [
                self.m1,
                self.c1,
                self.i1,
                self.m2,
                self.c2,
                self.i2,
                self.d,
                self.k1,
                self.k2,
                self.g,
            ]
        }
        /// The parameters with these values, in the order of [`NAMES`](Self::NAMES).
        pub const fn from_array(values: [f64; 10]) -> Self {
            let [v0, v1, v2, v3, v4, v5, v6, v7, v8, v9] = values;
            Self {
                m1: v0,
                c1: v1,
                i1: v2,
                m2: v3,
                c2: v4,
                i2: v5,
                d: v6,
                k1: v7,
                k2: v8,
                g: v9,
            }
        }
    }
    /// Two bodies on two axles with torsion springs.
    ///
    /**# Equations of motion

```text
A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints

A[theta1, theta1] = i1 + m1*c1^2 + m2*d^2
A[theta1, theta2] = m2*c2*d*cos(theta1 - theta2)
A[theta2, theta2] = i2 + m2*c2^2
b[theta1] = m2*c2*d*dot(theta2)^2*sin(theta1 - theta2) + (m1*c1*g + m2*d*g)*sin(theta1)
b[theta2] = m2*c2*g*sin(theta2) - m2*c2*d*dot(theta1)^2*sin(theta1 - theta2)
Q[theta1] = k2*theta2 - (k1 + k2)*theta1
Q[theta2] = k2*theta1 - k2*theta2
```

# Constants, computed by `new`

```text
k0 = c1
k1 = c2
k2 = d
k3 = k2
k4 = -c1
k5 = -d
k6 = i2 + m2*c2^2
k7 = 2*c2
k8 = m2*c2*d
k9 = m1*c1*g + m2*d*g
k10 = m2*c2*g
k11 = k1 + k2
k12 = m1*c1^2*m2*c2^2 + m1*c1^2*i2 + i1*m2*c2^2 + i1*i2 + m2*i2*d^2
k13 = m1*c1*m2*c2^2*g/(i2 + m2*c2^2) + m1*c1*i2*g/(i2 + m2*c2^2) + m2*i2*d*g/(i2 + m2*c2^2)
k14 = m2^2*c2^2*d*g/(i2 + m2*c2^2)
k15 = 0.5*(i1 + m1*c1^2 + m2*d^2)
k16 = 0.5*(i2 + m2*c2^2)
k17 = 0.5*(k1 + k2)
k18 = 0.5*k2
k19 = -1/(i2 + m2*c2^2)
k20 = -m2*c2*d/(i2 + m2*c2^2)
```
*/
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Asymmetric<T = f64> {
        params: AsymmetricParams,
        constants: [T; 21],
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl Asymmetric {
        /// Builds the model: checks the parameters, and computes once whatever depends on them alone.
        ///
        /// # Errors
        ///
        /// The first parameter, or combination of parameters, that is not finite or that no rigid body can
        /// have.
        pub fn new(
            params: AsymmetricParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            #[inline]
            fn rules<T: ::pendulum_core::real::Real>(given: [T; 10]) -> [T; 4] {
                let [p_m1, p_c1, p_i1, p_m2, p_c2, p_i2, p_d, p_k1, p_k2, p_g] = given;
                [p_m1, p_i1, p_m2, p_i2]
            }
            #[inline]
            fn constants<T: ::pendulum_core::real::Real>(given: [T; 10]) -> [T; 21] {
                let [p_m1, p_c1, p_i1, p_m2, p_c2, p_i2, p_d, p_k1, p_k2, p_g] = given;
                let t0 = -p_c1;
                let t1 = -p_d;
                let t2 = T::from_f64(2.0) * p_c2;
                let t3 = T::from_f64(0.5) * p_k2;
                let t4 = p_c2 * p_c2;
                let t5 = p_i2 + p_m2 * t4;
                let t6 = T::from_f64(0.5) * t5;
                let t7 = p_m2 * p_c2;
                let t8 = p_g * t7;
                let t9 = p_d * t7;
                let t10 = p_m1 * p_c1;
                let t11 = p_g * t10 + p_g * (p_m2 * p_d);
                let t12 = p_k1 + p_k2;
                let t13 = T::from_f64(0.5) * t12;
                let t14 = p_m1 * (p_c1 * p_c1);
                let t15 = t4 * (p_m2 * t14) + p_i2 * t14 + t4 * (p_i1 * p_m2)
                    + p_i1 * p_i2;
                let t16 = p_d * p_d;
                let t17 = T::from_f64(0.5) * (p_i1 + t14 + p_m2 * t16);
                let t18 = p_m2 * p_i2;
                let t19 = t15 + t16 * t18;
                let t20 = T::from_f64(1.0) / t5;
                let t21 = p_g * (t4 * (p_m2 * t10)) * t20 + t20 * (p_g * (p_i2 * t10));
                let t22 = t21 + t20 * (p_g * (p_d * t18));
                let t23 = t20 * (p_g * (p_d * (t4 * (p_m2 * p_m2))));
                let t24 = T::from_f64(-1.0) / t5;
                let t25 = t9 * t24;
                [
                    p_c1,
                    p_c2,
                    p_d,
                    p_k2,
                    t0,
                    t1,
                    t5,
                    t2,
                    t9,
                    t11,
                    t8,
                    t12,
                    t19,
                    t22,
                    t23,
                    t17,
                    t6,
                    t13,
                    t3,
                    t24,
                    t25,
                ]
            }
            let given = params.to_array();
            for (name, value) in AsymmetricParams::NAMES.into_iter().zip(given) {
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
            let [r0, r1, r2, r3] = rules(given);
            if !(r0 > 0.0) {
                return Err(
                    ::pendulum_core::ParameterError::new(
                        "m1",
                        r0,
                        "the mass of `upper` must be positive",
                        &[],
                    ),
                );
            }
            if !(r1 >= 0.0) {
                return Err(
                    ::pendulum_core::ParameterError::new(
                        "i1",
                        r1,
                        "the inertia of `upper` must not be negative",
                        &[],
                    ),
                );
            }
            if !(r2 > 0.0) {
                return Err(
                    ::pendulum_core::ParameterError::new(
                        "m2",
                        r2,
                        "the mass of `lower` must be positive",
                        &[],
                    ),
                );
            }
            if !(r3 >= 0.0) {
                return Err(
                    ::pendulum_core::ParameterError::new(
                        "i2",
                        r3,
                        "the inertia of `lower` must not be negative",
                        &[],
                    ),
                );
            }
            let constants = constants(given);
            let names: [&'static str; 21] = [
                "c1",
                "c2",
                "d",
                "k2",
                "-c1",
                "-d",
                "i2 + m2*c2^2",
                "2*c2",
                "m2*c2*d",
                "m1*c1*g + m2*d*g",
                "m2*c2*g",
                "k1 + k2",
                "m1*c1^2*m2*c2^2 + m1*c1^2*i2 + i1*m2*c2^2 + i1*i2 + m2*i2*d^2",
                "m1*c1*m2*c2^2*g/(i2 + m2*c2^2) + m1*c1*i2*g/(i2 + m2*c2^2) + m2*i2*d*g/(i2 + m2*c2^2)",
                "m2^2*c2^2*d*g/(i2 + m2*c2^2)",
                "0.5*(i1 + m1*c1^2 + m2*d^2)",
                "0.5*(i2 + m2*c2^2)",
                "0.5*(k1 + k2)",
                "0.5*k2",
                "-1/(i2 + m2*c2^2)",
                "-m2*c2*d/(i2 + m2*c2^2)",
            ];
            for (name, value) in names.into_iter().zip(constants) {
                if !value.is_finite() {
                    let given: [_; 10] = ::core::array::from_fn(|n| (
                        AsymmetricParams::NAMES[n],
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
        pub fn cast<T: ::pendulum_core::real::Real>(&self) -> Asymmetric<T> {
            Asymmetric {
                params: self.params,
                constants: self.constants.map(T::from_f64),
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> Asymmetric<T> {
        /// The parameters that the model was built from.
        pub fn params(&self) -> &AsymmetricParams {
            &self.params
        }
        /// The model with other parameters, in the same number type. Its constants are computed anew.
        ///
        /// # Errors
        ///
        /// Those of `new`.
        pub fn with_params(
            &self,
            params: AsymmetricParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            Ok(<Asymmetric>::new(params)?.cast())
        }
    }
    impl Asymmetric {
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
                            ::pendulum_core::Operations::new(13, 22, 1, 2, 0, 32),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, L^T D L",
                                    ::pendulum_core::Operations::new(12, 20, 1, 2, 0, 32),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L",
                                    ::pendulum_core::Operations::new(12, 20, 1, 2, 0, 32),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, adjugate",
                                    ::pendulum_core::Operations::new(25, 30, 1, 2, 0, 37),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C, adjugate",
                                    ::pendulum_core::Operations::new(33, 40, 1, 2, 0, 38),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "articulated bodies",
                                    ::pendulum_core::Operations::new(31, 46, 2, 2, 0, 48),
                                ),
                            ],
                        ),
                ),
                (
                    "jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first, L^T D L, exact quotient, derived in the graph",
                            ::pendulum_core::Operations::new(29, 46, 1, 2, 0, 39),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, inverse, derived in the graph",
                                    ::pendulum_core::Operations::new(25, 46, 1, 2, 0, 38),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, inverse, derived and expanded",
                                    ::pendulum_core::Operations::new(25, 46, 1, 2, 0, 38),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, inverse, derived in the graph",
                                    ::pendulum_core::Operations::new(50, 61, 1, 2, 0, 49),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C, inverse, derived in the graph",
                                    ::pendulum_core::Operations::new(99, 97, 1, 2, 0, 44),
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
                                    ::pendulum_core::Operations::new(15, 23, 0, 2, 0, 32),
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
                            ::pendulum_core::Operations::new(4, 7, 0, 2, 0, 24),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(4, 7, 0, 2, 0, 23),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C",
                                    ::pendulum_core::Operations::new(4, 7, 0, 2, 0, 23),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(4, 7, 0, 2, 0, 23),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(4, 8, 0, 2, 0, 24),
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
                    ),
                    ::pendulum_core::Slot::new(
                        "theta2",
                        ::pendulum_core::SlotKind::Angle,
                        1..2,
                        3..4,
                    ),
                ],
            )
            .autonomous();
        /// The equations of motion as text.
        pub const EQUATIONS: &'static str = "A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints\n\nA[theta1, theta1] = i1 + m1*c1^2 + m2*d^2\nA[theta1, theta2] = m2*c2*d*cos(theta1 - theta2)\nA[theta2, theta2] = i2 + m2*c2^2\nb[theta1] = m2*c2*d*dot(theta2)^2*sin(theta1 - theta2) + (m1*c1*g + m2*d*g)*sin(theta1)\nb[theta2] = m2*c2*g*sin(theta2) - m2*c2*d*dot(theta1)^2*sin(theta1 - theta2)\nQ[theta1] = k2*theta2 - (k1 + k2)*theta1\nQ[theta2] = k2*theta1 - k2*theta2\n";
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::System<T, 4>
    for Asymmetric<T> {
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn rhs(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 4> {
            let [q_theta1, q_theta2, qd_theta1, qd_theta2] = x.data.0[0];
            let k3 = self.constants[3];
            let k6 = self.constants[6];
            let k8 = self.constants[8];
            let k10 = self.constants[10];
            let k11 = self.constants[11];
            let k12 = self.constants[12];
            let k13 = self.constants[13];
            let k14 = self.constants[14];
            let k19 = self.constants[19];
            let k20 = self.constants[20];
            let [(sin_theta1, cos_theta1), (sin_theta2, cos_theta2)] = q_theta1
                .sin_cos_pair(q_theta2);
            let t0 = sin_theta1 * cos_theta2 - cos_theta1 * sin_theta2;
            let t1 = k8 * t0;
            let t2 = k13 * sin_theta1 + k14 * cos_theta2 * t0 + k11 * q_theta1
                + qd_theta2 * qd_theta2 * t1;
            let t3 = k20 * (cos_theta2 * cos_theta1 + sin_theta1 * sin_theta2);
            let t4 = k3 * (q_theta2 - q_theta1) - qd_theta1 * qd_theta1 * t1;
            let t5 = k6 / (k12 + t1 * t1) * (t2 + t3 * t4 - k3 * q_theta2);
            ::pendulum_core::nalgebra::SVector::from([
                qd_theta1,
                qd_theta2,
                -t5,
                k19 * (t4 + k10 * sin_theta2) - t3 * t5,
            ])
        }
        #[inline]
        fn layout(
            &self,
        ) -> ::core::option::Option<&'static ::pendulum_core::StateLayout> {
            Some(&<Asymmetric>::LAYOUT)
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Jacobian<T, 4>
    for Asymmetric<T> {
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
            let k3 = self.constants[3];
            let k6 = self.constants[6];
            let k8 = self.constants[8];
            let k9 = self.constants[9];
            let k10 = self.constants[10];
            let k11 = self.constants[11];
            let k12 = self.constants[12];
            let k13 = self.constants[13];
            let k14 = self.constants[14];
            let k19 = self.constants[19];
            let k20 = self.constants[20];
            let t0 = k8 * qd_theta1;
            let t1 = qd_theta1 * t0;
            let t2 = k8 * qd_theta2;
            let t3 = qd_theta2 * t2;
            let [(sin_theta1, cos_theta1), (sin_theta2, cos_theta2)] = q_theta1
                .sin_cos_pair(q_theta2);
            let t4 = sin_theta1 * cos_theta2 - cos_theta1 * sin_theta2;
            let t5 = k8 * t4;
            let t6 = k6 / (k12 + t5 * t5);
            let t7 = cos_theta2 * cos_theta1 + sin_theta1 * sin_theta2;
            let t8 = k20 * t7;
            let t9 = k3 * (q_theta2 - q_theta1) - t4 * t1;
            let t10 = k13 * sin_theta1 + k11 * q_theta1 + t8 * t9
                + t4 * (t3 + k14 * cos_theta2);
            let t11 = t6 * (t10 - k3 * q_theta2);
            let t12 = -t11;
            let t13 = k19 * (t9 + k10 * sin_theta2) - t8 * t11;
            let t14 = t11 * t5 - (k3 + t7 * t1);
            let t15 = t3 * t7 - t13 * t5;
            let t16 = T::from_f64(2.0) * t4;
            let t17 = t0 * t16;
            let t18 = t6 * t2 * t16;
            let t19 = -t18;
            let t20 = -(t8 * t18);
            let t21 = t6 * (k11 + k9 * cos_theta1 + t8 * t14 + t15);
            let t22 = k10 * cos_theta2 - t14;
            let t23 = k19 * t14 - t8 * t21;
            let t24 = -t21;
            let t25 = t6 * (t8 * t22 - t15 - k3);
            let t26 = k19 * t22 - t8 * t25;
            let t27 = -t25;
            let t28 = t6 * t8 * t17;
            let t29 = t8 * t28 - k19 * t17;
            (
                ::pendulum_core::nalgebra::SVector::from([
                    qd_theta1,
                    qd_theta2,
                    t12,
                    t13,
                ]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [T::from_f64(0.0), T::from_f64(0.0), t24, t23],
                    [T::from_f64(0.0), T::from_f64(0.0), t27, t26],
                    [T::from_f64(1.0), T::from_f64(0.0), t28, t29],
                    [T::from_f64(0.0), T::from_f64(1.0), t19, t20],
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
    for Asymmetric<T> {
        #[inline]
        fn kinetic(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 4>) -> T {
            let [q_theta1, q_theta2, qd_theta1, qd_theta2] = x.data.0[0];
            let k8 = self.constants[8];
            let k15 = self.constants[15];
            let k16 = self.constants[16];
            let (_, cos0) = (q_theta1 - q_theta2).sin_cos();
            qd_theta2 * (qd_theta2 * k16)
                + qd_theta1 * (cos0 * (qd_theta2 * k8) + qd_theta1 * k15)
        }
        #[inline]
        fn potential(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 4>) -> T {
            let [q_theta1, q_theta2, _, _] = x.data.0[0];
            let k3 = self.constants[3];
            let k9 = self.constants[9];
            let k10 = self.constants[10];
            let k17 = self.constants[17];
            let k18 = self.constants[18];
            let [(_, cos_theta1), (_, cos_theta2)] = q_theta1.sin_cos_pair(q_theta2);
            q_theta2 * (q_theta2 * k18) - cos_theta1 * k9 - cos_theta2 * k10
                + q_theta1 * (q_theta1 * k17 - k3 * q_theta2)
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::shapes::Shapes<4> for Asymmetric {
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
                        name: "tip",
                        kind: ::pendulum_core::shapes::ShapeKind::Point,
                        points: 1,
                        radius: false,
                    },
                ],
                &{
                    let [q_theta1, q_theta2, _, _] = x.data.0[0];
                    let k0 = self.constants[0];
                    let k1 = self.constants[1];
                    let k2 = self.constants[2];
                    let k4 = self.constants[4];
                    let k5 = self.constants[5];
                    let k7 = self.constants[7];
                    let [(sin_theta1, cos_theta1), (sin_theta2, cos_theta2)] = q_theta1
                        .sin_cos_pair(q_theta2);
                    let t0 = k0 * sin_theta1;
                    let t1 = k4 * cos_theta1;
                    let t2 = k2 * sin_theta1;
                    let t3 = t2 + k1 * sin_theta2;
                    let t4 = t2 + k7 * sin_theta2;
                    let t5 = k2 * cos_theta1;
                    let t6 = -(t5 + k1 * cos_theta2);
                    let t7 = -(t5 + k7 * cos_theta2);
                    let t8 = k5 * cos_theta1;
                    [
                        t0,
                        t1,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t3,
                        t6,
                        T::from_f64(0.0),
                        t2,
                        t8,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t2,
                        t8,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t2,
                        t8,
                        T::from_f64(0.0),
                        t4,
                        t7,
                        T::from_f64(0.0),
                    ]
                },
            )
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::CastJacobian<4> for Asymmetric {
        #[inline]
        fn with_jacobian<T: ::pendulum_core::real::Real>(
            model: &Asymmetric<T>,
        ) -> &impl ::pendulum_core::Jacobian<T, 4> {
            model
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::Cast<4> for Asymmetric {
        type In<T: ::pendulum_core::real::Real> = Asymmetric<T>;
        fn cast<T: ::pendulum_core::real::Real>(&self) -> Asymmetric<T> {
            Asymmetric::cast(self)
        }
        #[inline]
        fn gather<'m, T: ::pendulum_core::real::lanes::Lanes>(
            models: impl ::core::ops::Fn(usize) -> &'m Self,
        ) -> Asymmetric<T>
        where
            Self: 'm,
        {
            let scalar = <<T as ::pendulum_core::real::lanes::Lanes>::Scalar as ::pendulum_core::real::Real>::from_f64;
            Asymmetric {
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
pub use __Asymmetric::{Asymmetric, AsymmetricParams};
