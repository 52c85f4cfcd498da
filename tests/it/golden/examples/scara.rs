#[allow(non_snake_case)]
mod __Scara {
    ///Parameters of [`Scara`].
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct ScaraParams {
        ///In kg.
        pub m1: f64,
        ///In kg.
        pub m2: f64,
        ///In kg.
        pub m3: f64,
        ///In m.
        pub l1: f64,
        ///In m.
        pub l2: f64,
        ///In m/s^2.
        pub g: f64,
    }
    impl ::core::default::Default for ScaraParams {
        #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
        fn default() -> Self {
            Self {
                m1: 4f64,
                m2: 3f64,
                m3: 1f64,
                l1: 0.35f64,
                l2: 0.3f64,
                g: 9.81f64,
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ScaraParams {
        /// The names of the parameters, in the order of their declaration.
        pub const NAMES: [&'static str; 6] = ["m1", "m2", "m3", "l1", "l2", "g"];
        /// The values of the parameters, in the order of [`NAMES`](Self::NAMES).
        pub const fn to_array(self) -> [f64; 6] {
            [self.m1, self.m2, self.m3, self.l1, self.l2, self.g]
        }
        /// The parameters with these values, in the order of [`NAMES`](Self::NAMES).
        pub const fn from_array(values: [f64; 6]) -> Self {
            let [v0, v1, v2, v3, v4, v5] = values;
            Self {
                m1: v0,
                m2: v1,
                m3: v2,
                l1: v3,
                l2: v4,
                g: v5,
            }
        }
    }
    ///Inputs of [`Scara`], given at each evaluation.
    #[derive(Clone, Copy, Debug, Default, PartialEq)]
    pub struct ScaraInputs<T = f64> {
        ///In N m.
        pub tau1: T,
        ///In N m.
        pub tau2: T,
        ///In N.
        pub lift: T,
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T> ::core::convert::From<[T; 3]> for ScaraInputs<T> {
        #[inline]
        fn from(values: [T; 3]) -> Self {
            let [v0, v1, v2] = values;
            Self {
                tau1: v0,
                tau2: v1,
                lift: v2,
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T> ::core::convert::From<ScaraInputs<T>> for [T; 3] {
        #[inline]
        fn from(inputs: ScaraInputs<T>) -> Self {
            [inputs.tau1, inputs.tau2, inputs.lift]
        }
    }
    /// Two links that turn about vertical axes, and a quill that slides down.
    ///
    /**# Equations of motion

```text
A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints

A[a, a] = 1/3*m1*l1^2 + m2*l1^2 + 1/3*m2*l2^2 + m3*l1^2 + m3*l2^2 + (m2*l1*l2 + 2*m3*l1*l2)*cos(b)
A[a, b] = 1/3*m2*l2^2 + m3*l2^2 + (0.5*m2*l1*l2 + m3*l1*l2)*cos(b)
A[b, b] = 1/3*m2*l2^2 + m3*l2^2
A[z, z] = m3
b[a] = -((0.5*m2*l1*l2 + m3*l1*l2)*dot(b)^2*sin(b) + (m2*l1*l2 + 2*m3*l1*l2)*dot(a)*dot(b)*sin(b))
b[b] = (0.5*m2*l1*l2 + m3*l1*l2)*dot(a)^2*sin(b)
b[z] = m3*g
Q[a] = tau1 - 0.5*dot(a)
Q[b] = tau2 - 0.3*dot(b)
Q[z] = lift
```

# Constants, computed by `new`

```text
k0 = m3
k1 = m3*g
k2 = 1/3*m1*l1^2 + m2*l1^2 + 1/3*m2*l2^2 + m3*l1^2 + m3*l2^2
k3 = m2*l1*l2 + 2*m3*l1*l2
k4 = 1/3*m2*l2^2 + m3*l2^2
k5 = 0.5*m2*l1*l2 + m3*l1*l2
k6 = -1/m3
k7 = -1/(1/3*m2*l2^2 + m3*l2^2)
k8 = -0.3/(1/3*m2*l2^2 + m3*l2^2)
k9 = 1/m3
```
*/
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Scara<T = f64> {
        params: ScaraParams,
        constants: [T; 10],
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl Scara {
        /// Builds the model: checks the parameters, and computes once whatever depends on them alone.
        ///
        /// # Errors
        ///
        /// The first parameter, or combination of parameters, that is not finite or that no rigid body can
        /// have.
        pub fn new(
            params: ScaraParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            #[inline]
            fn rules<T: ::pendulum_core::real::Real>(given: [T; 6]) -> [T; 3] {
                let [p_m1, p_m2, p_m3, p_l1, p_l2, p_g] = given;
                [p_m1, p_m2, p_m3]
            }
            #[inline]
            fn constants<T: ::pendulum_core::real::Real>(given: [T; 6]) -> [T; 10] {
                let [p_m1, p_m2, p_m3, p_l1, p_l2, p_g] = given;
                let t0 = p_m3 * p_g;
                let t1 = p_l2 * (p_m2 * p_l1)
                    + p_l2 * (p_l1 * (T::from_f64(2.0) * p_m3));
                let t2 = p_l2 * (p_l1 * (T::from_f64(0.5) * p_m2))
                    + p_l2 * (p_m3 * p_l1);
                let t3 = p_l1 * p_l1;
                let t4 = p_l2 * p_l2;
                let t5 = t4 * (T::from_f64(0.3333333333333333) * p_m2);
                let t6 = p_m3 * t4;
                let t7 = t3 * (T::from_f64(0.3333333333333333) * p_m1) + p_m2 * t3 + t5
                    + p_m3 * t3 + t6;
                let t8 = t5 + t6;
                let t9 = T::from_f64(-1.0) / t8;
                let t10 = T::from_f64(0.3) * t9;
                let t11 = T::from_f64(-1.0) / p_m3;
                let t12 = -t11;
                [p_m3, t0, t7, t1, t8, t2, t11, t9, t10, t12]
            }
            let given = params.to_array();
            for (name, value) in ScaraParams::NAMES.into_iter().zip(given) {
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
                        "m1",
                        r0,
                        "the mass of a rod of `shoulder` must be positive",
                        &[],
                    ),
                );
            }
            if !(r1 > 0.0) {
                return Err(
                    ::pendulum_core::ParameterError::new(
                        "m2",
                        r1,
                        "the mass of a rod of `elbow` must be positive",
                        &[],
                    ),
                );
            }
            if !(r2 > 0.0) {
                return Err(
                    ::pendulum_core::ParameterError::new(
                        "m3",
                        r2,
                        "the mass of `quill` must be positive",
                        &[],
                    ),
                );
            }
            let constants = constants(given);
            let names: [&'static str; 10] = [
                "m3",
                "m3*g",
                "1/3*m1*l1^2 + m2*l1^2 + 1/3*m2*l2^2 + m3*l1^2 + m3*l2^2",
                "m2*l1*l2 + 2*m3*l1*l2",
                "1/3*m2*l2^2 + m3*l2^2",
                "0.5*m2*l1*l2 + m3*l1*l2",
                "-1/m3",
                "-1/(1/3*m2*l2^2 + m3*l2^2)",
                "-0.3/(1/3*m2*l2^2 + m3*l2^2)",
                "1/m3",
            ];
            for (name, value) in names.into_iter().zip(constants) {
                if !value.is_finite() {
                    let given: [_; 6] = ::core::array::from_fn(|n| (
                        ScaraParams::NAMES[n],
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
        pub fn cast<T: ::pendulum_core::real::Real>(&self) -> Scara<T> {
            Scara {
                params: self.params,
                constants: self.constants.map(T::from_f64),
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> Scara<T> {
        /// The parameters that the model was built from.
        pub fn params(&self) -> &ScaraParams {
            &self.params
        }
        /// The model with other parameters, in the same number type. Its constants are computed anew.
        ///
        /// # Errors
        ///
        /// Those of `new`.
        pub fn with_params(
            &self,
            params: ScaraParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            Ok(<Scara>::new(params)?.cast())
        }
    }
    impl Scara {
        ///The place of `a` in the state, where it stands in rad.
        pub const A: usize = 0;
        ///The place of `dot(a)` in the state, where it stands in rad/s.
        pub const DOT_A: usize = 3;
        ///The place of `b` in the state, where it stands in rad.
        pub const B: usize = 1;
        ///The place of `dot(b)` in the state, where it stands in rad/s.
        pub const DOT_B: usize = 4;
        ///The place of `z` in the state, where it stands in m.
        pub const Z: usize = 2;
        ///The place of `dot(z)` in the state, where it stands in m/s.
        pub const DOT_Z: usize = 5;
        /// The number of degrees of freedom; the state has twice as many components.
        pub const DOF: usize = 3;
        /// The names of the coordinates, in the order in which they, and then their rates, stand in the state.
        pub const COORDINATES: [&'static str; 3] = ["a", "b", "z"];
        /// Counted operations of each generated function, in the form that it has and in others.
        pub const COST: ::pendulum_core::Cost = ::pendulum_core::Cost::new(
            &[
                (
                    "rhs",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first, L^T D L",
                            ::pendulum_core::Operations::new(11, 18, 1, 1, 0, 32),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, L^T D L",
                                    ::pendulum_core::Operations::new(11, 18, 1, 1, 0, 32),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L",
                                    ::pendulum_core::Operations::new(11, 18, 1, 1, 0, 32),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C, L^T D L",
                                    ::pendulum_core::Operations::new(35, 48, 2, 2, 0, 45),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, L^T D L",
                                    ::pendulum_core::Operations::new(41, 53, 2, 2, 0, 40),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "articulated bodies",
                                    ::pendulum_core::Operations::new(42, 65, 2, 2, 0, 50),
                                ),
                            ],
                        ),
                ),
                (
                    "jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of parameters first, L^T D L, derived and expanded",
                            ::pendulum_core::Operations::new(22, 40, 1, 1, 0, 40),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L, derived and expanded",
                                    ::pendulum_core::Operations::new(22, 40, 1, 1, 0, 39),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first, L^T D L, derived and expanded",
                                    ::pendulum_core::Operations::new(22, 41, 1, 1, 0, 39),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C, L^T D L, derived in the graph",
                                    ::pendulum_core::Operations::new(74, 105, 2, 2, 0, 52),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, L^T D L, derived by recursion",
                                    ::pendulum_core::Operations::new(87, 114, 2, 2, 0, 58),
                                ),
                            ],
                        ),
                ),
                (
                    "input_jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first, L^T D L, derived and expanded",
                            ::pendulum_core::Operations::new(7, 6, 1, 1, 0, 32),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, L^T D L, derived and expanded",
                                    ::pendulum_core::Operations::new(7, 6, 1, 1, 0, 32),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L, derived and expanded",
                                    ::pendulum_core::Operations::new(7, 6, 1, 1, 0, 32),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, L^T D L, derived in the graph",
                                    ::pendulum_core::Operations::new(24, 24, 2, 2, 0, 40),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C, L^T D L, derived in the graph",
                                    ::pendulum_core::Operations::new(27, 31, 2, 2, 0, 45),
                                ),
                            ],
                        ),
                ),
                (
                    "inverse_dynamics",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(10, 16, 0, 1, 0, 26),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(10, 16, 0, 1, 0, 26),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(10, 16, 0, 1, 0, 26),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(31, 47, 0, 2, 0, 36),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C",
                                    ::pendulum_core::Operations::new(34, 46, 0, 2, 0, 34),
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
                    "a",
                    ::pendulum_core::SlotKind::Angle,
                    0..1,
                    3..4,
                ),
                ::pendulum_core::Slot::new(
                    "b",
                    ::pendulum_core::SlotKind::Angle,
                    1..2,
                    4..5,
                ),
                ::pendulum_core::Slot::new(
                    "z",
                    ::pendulum_core::SlotKind::Length,
                    2..3,
                    5..6,
                ),
            ],
        );
        /// The equations of motion as text.
        pub const EQUATIONS: &'static str = "A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints\n\nA[a, a] = 1/3*m1*l1^2 + m2*l1^2 + 1/3*m2*l2^2 + m3*l1^2 + m3*l2^2 + (m2*l1*l2 + 2*m3*l1*l2)*cos(b)\nA[a, b] = 1/3*m2*l2^2 + m3*l2^2 + (0.5*m2*l1*l2 + m3*l1*l2)*cos(b)\nA[b, b] = 1/3*m2*l2^2 + m3*l2^2\nA[z, z] = m3\nb[a] = -((0.5*m2*l1*l2 + m3*l1*l2)*dot(b)^2*sin(b) + (m2*l1*l2 + 2*m3*l1*l2)*dot(a)*dot(b)*sin(b))\nb[b] = (0.5*m2*l1*l2 + m3*l1*l2)*dot(a)^2*sin(b)\nb[z] = m3*g\nQ[a] = tau1 - 0.5*dot(a)\nQ[b] = tau2 - 0.3*dot(b)\nQ[z] = lift\n";
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Controlled<T, 6, 3>
    for Scara<T> {
        type Inputs = ScaraInputs<T>;
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn rhs_with(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 6>,
            u: &ScaraInputs<T>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 6> {
            let [_, q_b, _, qd_a, qd_b, qd_z] = x.data.0[0];
            let u_tau1 = u.tau1;
            let u_tau2 = u.tau2;
            let u_lift = u.lift;
            let k1 = self.constants[1];
            let k2 = self.constants[2];
            let k3 = self.constants[3];
            let k4 = self.constants[4];
            let k5 = self.constants[5];
            let k6 = self.constants[6];
            let k7 = self.constants[7];
            let (sin_b, cos_b) = q_b.sin_cos();
            let t0 = k4 + k5 * cos_b;
            let t1 = k7 * t0;
            let t2 = k5 * sin_b;
            let t3 = T::from_f64(0.3) * qd_b + qd_a * qd_a * t2 - u_tau2;
            let t4 = qd_a * (T::from_f64(0.5) - k3 * sin_b * qd_b) + t1 * t3 - u_tau1
                - qd_b * qd_b * t2;
            let t5 = T::from_f64(-1.0) / (k2 + k3 * cos_b + t0 * t1) * t4;
            ::pendulum_core::nalgebra::SVector::from([
                qd_a,
                qd_b,
                qd_z,
                t5,
                k7 * t3 + t1 * t5,
                k6 * (k1 - u_lift),
            ])
        }
        #[inline]
        fn layout(
            &self,
        ) -> ::core::option::Option<&'static ::pendulum_core::StateLayout> {
            Some(&<Scara>::LAYOUT)
        }
        #[inline]
        fn jacobian_with(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 6>,
            u: &ScaraInputs<T>,
        ) -> ::pendulum_core::nalgebra::SMatrix<T, 6, 6> {
            self.rhs_and_jacobian_with(t, x, u).1
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn rhs_and_jacobian_with(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 6>,
            u: &ScaraInputs<T>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 6>,
            ::pendulum_core::nalgebra::SMatrix<T, 6, 6>,
        ) {
            let [_, q_b, _, qd_a, qd_b, qd_z] = x.data.0[0];
            let u_tau1 = u.tau1;
            let u_tau2 = u.tau2;
            let u_lift = u.lift;
            let k1 = self.constants[1];
            let k2 = self.constants[2];
            let k3 = self.constants[3];
            let k4 = self.constants[4];
            let k5 = self.constants[5];
            let k6 = self.constants[6];
            let k7 = self.constants[7];
            let k8 = self.constants[8];
            let t0 = k6 * (k1 - u_lift);
            let t1 = qd_b * qd_b;
            let (sin_b, cos_b) = q_b.sin_cos();
            let t2 = k4 + k5 * cos_b;
            let t3 = k7 * t2;
            let t4 = T::from_f64(-1.0) / (k2 + k3 * cos_b + t2 * t3);
            let t5 = k3 * sin_b;
            let t6 = T::from_f64(0.5) - qd_b * t5;
            let t7 = k5 * sin_b;
            let t8 = T::from_f64(0.3) * qd_b + qd_a * qd_a * t7 - u_tau2;
            let t9 = t4 * (qd_a * t6 + t3 * t8 - u_tau1 - t7 * t1);
            let t10 = k7 * t8 + t3 * t9;
            let t11 = sin_b * t9;
            let t12 = cos_b * qd_a;
            let t13 = k5 * (qd_a * t12 - t11);
            let t14 = t3 * t13 - k5 * (cos_b * t1 + sin_b * t10)
                - k3 * (t11 + qd_b * t12);
            let t15 = t4 * t14;
            let t16 = k7 * t13 + t3 * t15;
            let t17 = qd_a * t5;
            let t18 = t4 * (t6 + t3 * t17);
            let t19 = k7 * t17 + t3 * t18;
            let t20 = t4 * (T::from_f64(0.3) * t3 - (qd_a + qd_b) * t5);
            let t21 = k8 + t3 * t20;
            (
                ::pendulum_core::nalgebra::SVector::from([
                    qd_a,
                    qd_b,
                    qd_z,
                    t9,
                    t10,
                    t0,
                ]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [
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
                        t15,
                        t16,
                        T::from_f64(0.0),
                    ],
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                    ],
                    [
                        T::from_f64(1.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t18,
                        t19,
                        T::from_f64(0.0),
                    ],
                    [
                        T::from_f64(0.0),
                        T::from_f64(1.0),
                        T::from_f64(0.0),
                        t20,
                        t21,
                        T::from_f64(0.0),
                    ],
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(1.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                    ],
                ]),
            )
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn input_jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 6>,
            u: &ScaraInputs<T>,
        ) -> ::pendulum_core::nalgebra::SMatrix<T, 6, 3> {
            let [_, q_b, _, _, _, _] = x.data.0[0];
            let k2 = self.constants[2];
            let k3 = self.constants[3];
            let k4 = self.constants[4];
            let k5 = self.constants[5];
            let k7 = self.constants[7];
            let k9 = self.constants[9];
            let (_, cos_b) = q_b.sin_cos();
            let t0 = k4 + cos_b * k5;
            let t1 = t0 * k7;
            let t2 = T::from_f64(-1.0) / (k2 + cos_b * k3 + t0 * t1);
            let t3 = -t2;
            let t4 = t1 * t2;
            let t5 = -(k7 + t1 * t4);
            let t6 = -t4;
            ::pendulum_core::nalgebra::SMatrix::from([
                [
                    T::from_f64(0.0),
                    T::from_f64(0.0),
                    T::from_f64(0.0),
                    t3,
                    t6,
                    T::from_f64(0.0),
                ],
                [
                    T::from_f64(0.0),
                    T::from_f64(0.0),
                    T::from_f64(0.0),
                    t6,
                    t5,
                    T::from_f64(0.0),
                ],
                [
                    T::from_f64(0.0),
                    T::from_f64(0.0),
                    T::from_f64(0.0),
                    T::from_f64(0.0),
                    T::from_f64(0.0),
                    k9,
                ],
            ])
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn time_derivative_with(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 6>,
            u: &ScaraInputs<T>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 6> {
            ::pendulum_core::nalgebra::SVector::from([
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
    impl<T: ::pendulum_core::real::Real> Scara<T> {
        /// The model with a law for its inputs: a `System`.
        ///
        /// Its Jacobian requires the derivative of the law: see `WithInputs`.
        pub fn with_inputs<F>(
            &self,
            inputs: F,
        ) -> ::pendulum_core::WithInputs<Self, F, 3>
        where
            F: ::core::ops::Fn(
                T,
                &::pendulum_core::nalgebra::SVector<T, 6>,
            ) -> ScaraInputs<T>,
        {
            ::pendulum_core::WithInputs::new(*self, inputs)
        }
        /// The model with a law for its inputs that is generic over the number type: a `System` with a `Jacobian`.
        pub fn with_law<L>(
            &self,
            law: L,
        ) -> ::pendulum_core::WithInputs<Self, ::pendulum_core::inputs::Generic<L>, 3>
        where
            L: ::pendulum_core::InputLaw<6, 3>,
        {
            ::pendulum_core::WithInputs::with_law(*self, law)
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> Scara<T> {
        ///The generalised forces `A qdd + b - Q` that must act beside gravity and all forces of the declaration for the accelerations `qdd`: zero along a free motion. Inputs count as zero: where each coordinate has one, these are their values.
        #[inline]
        pub fn inverse_dynamics(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 6>,
            qdd: &::pendulum_core::nalgebra::SVector<T, 3>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 3> {
            let [_, q_b, _, qd_a, qd_b, _] = x.data.0[0];
            let [qdd_a, qdd_b, qdd_z] = qdd.data.0[0];
            let k0 = self.constants[0];
            let k1 = self.constants[1];
            let k2 = self.constants[2];
            let k3 = self.constants[3];
            let k4 = self.constants[4];
            let k5 = self.constants[5];
            let (sin_b, cos_b) = q_b.sin_cos();
            let t0 = k4 + k5 * cos_b;
            let t1 = qdd_b * t0 + qdd_a * (k2 + k3 * cos_b)
                + qd_a * (T::from_f64(0.5) - k3 * sin_b * qd_b);
            let t2 = k5 * sin_b;
            ::pendulum_core::nalgebra::SVector::from([
                t1 - qd_b * qd_b * t2,
                k4 * qdd_b + t0 * qdd_a + T::from_f64(0.3) * qd_b + qd_a * qd_a * t2,
                k1 + k0 * qdd_z,
            ])
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::CastControlled<6, 3> for Scara {
        type In<T: ::pendulum_core::real::Real> = Scara<T>;
        fn cast<T: ::pendulum_core::real::Real>(&self) -> Scara<T> {
            Scara::cast(self)
        }
        #[inline]
        fn gather<'m, T: ::pendulum_core::real::lanes::Lanes>(
            models: impl ::core::ops::Fn(usize) -> &'m Self,
        ) -> Scara<T>
        where
            Self: 'm,
        {
            let scalar = <<T as ::pendulum_core::real::lanes::Lanes>::Scalar as ::pendulum_core::real::Real>::from_f64;
            Scara {
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
use __Scara::{Scara, ScaraParams, ScaraInputs};
