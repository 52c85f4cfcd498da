#[allow(non_snake_case)]
mod __Coupled {
    ///Parameters of [`Coupled`].
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct CoupledParams {
        ///In kg.
        pub m: f64,
        ///In m.
        pub l: f64,
        ///In m.
        pub apart: f64,
        ///In N/m.
        pub k: f64,
        ///In N m s.
        pub gamma: f64,
        ///In N m.
        pub moment: f64,
        ///In rad/s.
        pub w: f64,
    }
    impl ::core::default::Default for CoupledParams {
        #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
        fn default() -> Self {
            Self {
                m: 0.5f64,
                l: 0.8f64,
                apart: 0.4f64,
                k: 6f64,
                gamma: 0.01f64,
                moment: 0.4f64,
                w: 3f64,
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl CoupledParams {
        /// The names of the parameters, in the order of their declaration.
        pub const NAMES: [&'static str; 7] = [
            "m",
            "l",
            "apart",
            "k",
            "gamma",
            "moment",
            "w",
        ];
        /// The values of the parameters, in the order of [`NAMES`](Self::NAMES).
        pub const fn to_array(self) -> [f64; 7] {
            [self.m, self.l, self.apart, self.k, self.gamma, self.moment, self.w]
        }
        /// The parameters with these values, in the order of [`NAMES`](Self::NAMES).
        pub const fn from_array(values: [f64; 7]) -> Self {
            let [v0, v1, v2, v3, v4, v5, v6] = values;
            Self {
                m: v0,
                l: v1,
                apart: v2,
                k: v3,
                gamma: v4,
                moment: v5,
                w: v6,
            }
        }
    }
    /// Two equal rods side by side, with a spring between them and magnets at their ends.
    ///
    /**# Equations of motion

```text
A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q all other forces

A[theta1, theta1] = 1/3*m*l^2
A[theta2, theta2] = 1/3*m*l^2
b[theta1] = 4.905*m*l*sin(theta1)
b[theta2] = 4.905*m*l*sin(theta2)
Q[theta1] = moment*sin(w*t)*cos(theta1) + k*(1
    - apart/sqrt((apart + 0.5*l*sin(theta2) - 0.5*l*sin(theta1))^2
    + (0.5*l*cos(theta1) - 0.5*l*cos(theta2))^2))*(0.5*l*cos(theta1)*(apart + 0.5*l*sin(theta2) - 0.5*l*sin(theta1))
    + 0.5*l*sin(theta1)*(0.5*l*cos(theta1) - 0.5*l*cos(theta2))) - gamma*dot(theta1)
Q[theta2] = -(gamma*dot(theta2) + moment*sin(w*t)*cos(theta2)
    + k*(1 - apart/sqrt((apart + 0.5*l*sin(theta2) - 0.5*l*sin(theta1))^2
    + (0.5*l*cos(theta1) - 0.5*l*cos(theta2))^2))*(0.5*l*cos(theta2)*(apart + 0.5*l*sin(theta2) - 0.5*l*sin(theta1))
    + 0.5*l*sin(theta2)*(0.5*l*cos(theta1) - 0.5*l*cos(theta2))))
```

# Constants, computed by `new`

```text
k0 = l
k1 = apart
k2 = k
k3 = gamma
k4 = moment
k5 = w
k6 = -l
k7 = 0.5*l
k8 = -0.5*l
k9 = apart^2
k10 = l*apart
k11 = 0.5*l^2
k12 = 4.905*m*l
k13 = 0.5*l*apart*k
k14 = 0.5*l*apart^2*k
k15 = 0.25*l^2*apart*k
k16 = 0.25*l^2*k
k17 = 1/6*m*l^2
k18 = -1/(1/3*m*l^2)
k19 = 1/3*m*l^2/(1/9*(m*l^2)^2)
k20 = -1/3*m*l^2/(1/9*(m*l^2)^2)
k21 = -1/(1/12*m*l^2 + m*(0.5*l)^2)
k22 = 0.5*9.81*m*l
k23 = 0.125*l^4*apart*k
k24 = 0.25*l^3*apart^2*k
k25 = 0.0625*l^4*apart*k
k26 = 0.25*l^2*apart^3*k
k27 = -1/3*m*l^2*gamma/(1/9*(m*l^2)^2)
k28 = -gamma/(1/3*m*l^2)
k29 = 0.125*l^3*apart^2*k
k30 = moment*w
k31 = 0.5*k
```
*/
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Coupled<T = f64> {
        params: CoupledParams,
        constants: [T; 32],
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl Coupled {
        /// Builds the model: checks the parameters, and computes once whatever depends on them alone.
        ///
        /// # Errors
        ///
        /// The first parameter, or combination of parameters, that is not finite or that no rigid body can
        /// have.
        pub fn new(
            params: CoupledParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            #[inline]
            fn rules<T: ::pendulum_core::real::Real>(given: [T; 7]) -> [T; 3] {
                let [p_m, p_l, p_apart, p_k, p_gamma, p_moment, p_w] = given;
                [p_m, p_gamma, p_apart]
            }
            #[inline]
            fn constants<T: ::pendulum_core::real::Real>(given: [T; 7]) -> [T; 32] {
                let [p_m, p_l, p_apart, p_k, p_gamma, p_moment, p_w] = given;
                let t0 = -p_l;
                let t1 = T::from_f64(4.905) * (p_m * p_l);
                let t2 = p_moment * p_w;
                let t3 = T::from_f64(0.5) * p_k;
                let t4 = T::from_f64(0.5) * p_l;
                let t5 = -t4;
                let t6 = T::from_f64(9.81) * (p_m * t4);
                let t7 = p_apart * p_apart;
                let t8 = T::from_f64(0.5) * (p_k * (p_l * t7));
                let t9 = p_k * (t7 * (p_l * p_l * p_l));
                let t10 = T::from_f64(0.25) * t9;
                let t11 = T::from_f64(0.125) * t9;
                let t12 = p_l * p_apart;
                let t13 = T::from_f64(0.5) * (p_k * t12);
                let t14 = p_l * p_l;
                let t15 = T::from_f64(-1.0)
                    / (T::from_f64(0.08333333333333333) * p_m * t14 + p_m * (t4 * t4));
                let t16 = T::from_f64(0.5) * t14;
                let t17 = T::from_f64(0.25) * (p_k * (p_apart * t14));
                let t18 = T::from_f64(0.25) * (p_k * t14);
                let t19 = T::from_f64(0.25)
                    * (p_k * (t14 * (p_apart * p_apart * p_apart)));
                let t20 = p_m * t14;
                let t21 = T::from_f64(0.16666666666666666) * t20;
                let t22 = T::from_f64(0.3333333333333333) * t20;
                let t23 = t22 / (T::from_f64(0.1111111111111111) * (t20 * t20));
                let t24 = T::from_f64(-1.0) / t22;
                let t25 = p_gamma * t24;
                let t26 = -t23;
                let t27 = -(p_gamma * t23);
                let t28 = p_k * (p_apart * (p_l * p_l * p_l * p_l));
                let t29 = T::from_f64(0.125) * t28;
                let t30 = T::from_f64(0.0625) * t28;
                [
                    p_l,
                    p_apart,
                    p_k,
                    p_gamma,
                    p_moment,
                    p_w,
                    t0,
                    t4,
                    t5,
                    t7,
                    t12,
                    t16,
                    t1,
                    t13,
                    t8,
                    t17,
                    t18,
                    t21,
                    t24,
                    t23,
                    t26,
                    t15,
                    t6,
                    t29,
                    t10,
                    t30,
                    t19,
                    t27,
                    t25,
                    t11,
                    t2,
                    t3,
                ]
            }
            let given = params.to_array();
            for (name, value) in CoupledParams::NAMES.into_iter().zip(given) {
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
                        "gamma",
                        r1,
                        "the friction of `left` must not be negative",
                        &[],
                    ),
                );
            }
            if !(r2 >= 0.0) {
                return Err(
                    ::pendulum_core::ParameterError::new(
                        "apart",
                        r2,
                        "the length of the spring between `a` and `b` must not be negative",
                        &[],
                    ),
                );
            }
            let constants = constants(given);
            let names: [&'static str; 32] = [
                "l",
                "apart",
                "k",
                "gamma",
                "moment",
                "w",
                "-l",
                "0.5*l",
                "-0.5*l",
                "apart^2",
                "l*apart",
                "0.5*l^2",
                "4.905*m*l",
                "0.5*l*apart*k",
                "0.5*l*apart^2*k",
                "0.25*l^2*apart*k",
                "0.25*l^2*k",
                "1/6*m*l^2",
                "-1/(1/3*m*l^2)",
                "1/3*m*l^2/(1/9*(m*l^2)^2)",
                "-1/3*m*l^2/(1/9*(m*l^2)^2)",
                "-1/(1/12*m*l^2 + m*(0.5*l)^2)",
                "0.5*9.81*m*l",
                "0.125*l^4*apart*k",
                "0.25*l^3*apart^2*k",
                "0.0625*l^4*apart*k",
                "0.25*l^2*apart^3*k",
                "-1/3*m*l^2*gamma/(1/9*(m*l^2)^2)",
                "-gamma/(1/3*m*l^2)",
                "0.125*l^3*apart^2*k",
                "moment*w",
                "0.5*k",
            ];
            for (name, value) in names.into_iter().zip(constants) {
                if !value.is_finite() {
                    let given: [_; 7] = ::core::array::from_fn(|n| (
                        CoupledParams::NAMES[n],
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
        pub fn cast<T: ::pendulum_core::real::Real>(&self) -> Coupled<T> {
            Coupled {
                params: self.params,
                constants: self.constants.map(T::from_f64),
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> Coupled<T> {
        /// The parameters that the model was built from.
        pub fn params(&self) -> &CoupledParams {
            &self.params
        }
        /// The model with other parameters, in the same number type. Its constants are computed anew.
        ///
        /// # Errors
        ///
        /// Those of `new`.
        pub fn with_params(
            &self,
            params: CoupledParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            Ok(<Coupled>::new(params)?.cast())
        }
    }
    impl Coupled {
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
                            "recursion, L^T D L",
                            ::pendulum_core::Operations::new(13, 23, 1, 3, 1, 39),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "articulated bodies",
                                    ::pendulum_core::Operations::new(13, 23, 1, 3, 1, 40),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first, L^T D L",
                                    ::pendulum_core::Operations::new(16, 22, 1, 3, 1, 37),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, L^T D L",
                                    ::pendulum_core::Operations::new(16, 23, 1, 3, 1, 37),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L",
                                    ::pendulum_core::Operations::new(16, 23, 1, 3, 1, 36),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C, L^T D L",
                                    ::pendulum_core::Operations::new(19, 26, 2, 3, 1, 39),
                                ),
                            ],
                        ),
                ),
                (
                    "jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, expanded, L^T D L, derived and expanded",
                            ::pendulum_core::Operations::new(35, 55, 1, 3, 1, 40),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, L^T D L, derived in the graph",
                                    ::pendulum_core::Operations::new(30, 56, 3, 3, 1, 42),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, L^T D L, derived and expanded",
                                    ::pendulum_core::Operations::new(42, 61, 1, 3, 1, 37),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first, L^T D L, derived in the graph",
                                    ::pendulum_core::Operations::new(35, 58, 3, 3, 1, 42),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C, L^T D L, derived in the graph",
                                    ::pendulum_core::Operations::new(40, 64, 4, 3, 1, 43),
                                ),
                            ],
                        ),
                ),
                (
                    "time_derivative",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first, L^T D L, derived and expanded",
                            ::pendulum_core::Operations::new(0, 6, 0, 3, 0, 23),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, L^T D L, derived and expanded",
                                    ::pendulum_core::Operations::new(0, 6, 0, 3, 0, 23),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L, derived and expanded",
                                    ::pendulum_core::Operations::new(0, 6, 0, 3, 0, 23),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, L^T D L, derived in the graph",
                                    ::pendulum_core::Operations::new(1, 5, 0, 3, 0, 24),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C, L^T D L, derived in the graph",
                                    ::pendulum_core::Operations::new(6, 12, 1, 3, 0, 31),
                                ),
                            ],
                        ),
                ),
                (
                    "kinetic",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(1, 3, 0, 0, 0, 3),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(1, 3, 0, 0, 0, 3),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(1, 3, 0, 0, 0, 3),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(1, 3, 0, 0, 0, 3),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C",
                                    ::pendulum_core::Operations::new(6, 10, 0, 1, 0, 30),
                                ),
                            ],
                        ),
                ),
                (
                    "potential",
                    ::pendulum_core::FunctionCost::new(
                            "A, B and C",
                            ::pendulum_core::Operations::new(8, 10, 0, 3, 1, 34),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(8, 10, 0, 3, 1, 34),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(12, 12, 0, 3, 1, 34),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(12, 12, 0, 3, 1, 34),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(12, 12, 0, 3, 1, 33),
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
        );
        /// The equations of motion as text.
        pub const EQUATIONS: &'static str = "A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q all other forces\n\nA[theta1, theta1] = 1/3*m*l^2\nA[theta2, theta2] = 1/3*m*l^2\nb[theta1] = 4.905*m*l*sin(theta1)\nb[theta2] = 4.905*m*l*sin(theta2)\nQ[theta1] = moment*sin(w*t)*cos(theta1) + k*(1\n    - apart/sqrt((apart + 0.5*l*sin(theta2) - 0.5*l*sin(theta1))^2\n    + (0.5*l*cos(theta1) - 0.5*l*cos(theta2))^2))*(0.5*l*cos(theta1)*(apart + 0.5*l*sin(theta2) - 0.5*l*sin(theta1))\n    + 0.5*l*sin(theta1)*(0.5*l*cos(theta1) - 0.5*l*cos(theta2))) - gamma*dot(theta1)\nQ[theta2] = -(gamma*dot(theta2) + moment*sin(w*t)*cos(theta2)\n    + k*(1 - apart/sqrt((apart + 0.5*l*sin(theta2) - 0.5*l*sin(theta1))^2\n    + (0.5*l*cos(theta1) - 0.5*l*cos(theta2))^2))*(0.5*l*cos(theta2)*(apart + 0.5*l*sin(theta2) - 0.5*l*sin(theta1))\n    + 0.5*l*sin(theta2)*(0.5*l*cos(theta1) - 0.5*l*cos(theta2))))\n";
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::System<T, 4> for Coupled<T> {
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn rhs(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 4> {
            let [q_theta1, q_theta2, qd_theta1, qd_theta2] = x.data.0[0];
            let k1 = self.constants[1];
            let k2 = self.constants[2];
            let k3 = self.constants[3];
            let k4 = self.constants[4];
            let k5 = self.constants[5];
            let k7 = self.constants[7];
            let k21 = self.constants[21];
            let k22 = self.constants[22];
            let (sin0, _) = (k5 * t).sin_cos();
            let t1 = k4 * sin0;
            let [(sin_theta1, cos_theta1), (sin_theta2, cos_theta2)] = q_theta1
                .sin_cos_pair(q_theta2);
            let t2 = k7 * sin_theta2;
            let t3 = k7 * sin_theta1;
            let t4 = k1 + t2 - t3;
            let t5 = k7 * cos_theta1;
            let t6 = k7 * cos_theta2;
            let t7 = t5 - t6;
            let t8 = k2 * (T::from_f64(1.0) - k1 / (t4 * t4 + t7 * t7).sqrt());
            let t9 = k22 * sin_theta1 + k3 * qd_theta1 - t1 * cos_theta1
                - t8 * (t4 * t5 + t3 * t7);
            let t10 = k3 * qd_theta2 + t1 * cos_theta2 + t8 * (t4 * t6 + t2 * t7);
            ::pendulum_core::nalgebra::SVector::from([
                qd_theta1,
                qd_theta2,
                k21 * t9,
                k21 * (t10 + k22 * sin_theta2),
            ])
        }
        #[inline]
        fn layout(
            &self,
        ) -> ::core::option::Option<&'static ::pendulum_core::StateLayout> {
            Some(&<Coupled>::LAYOUT)
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Jacobian<T, 4> for Coupled<T> {
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
            let k4 = self.constants[4];
            let k5 = self.constants[5];
            let k9 = self.constants[9];
            let k10 = self.constants[10];
            let k11 = self.constants[11];
            let k12 = self.constants[12];
            let k13 = self.constants[13];
            let k14 = self.constants[14];
            let k15 = self.constants[15];
            let k16 = self.constants[16];
            let k18 = self.constants[18];
            let k20 = self.constants[20];
            let k23 = self.constants[23];
            let k24 = self.constants[24];
            let k25 = self.constants[25];
            let k26 = self.constants[26];
            let k27 = self.constants[27];
            let k28 = self.constants[28];
            let k29 = self.constants[29];
            let (sin0, _) = (k5 * t).sin_cos();
            let [(sin_theta1, cos_theta1), (sin_theta2, cos_theta2)] = q_theta1
                .sin_cos_pair(q_theta2);
            let t1 = sin_theta1 * cos_theta2 - sin_theta2 * cos_theta1;
            let t2 = cos_theta2 * cos_theta1;
            let t3 = sin_theta1 * sin_theta2;
            let t4 = k9 + k10 * sin_theta2
                + (k11 - k11 * t2 - (k11 * t3 + k10 * sin_theta1));
            let t5 = t2 + t3;
            let t6 = T::from_f64(1.0) / -t4;
            let t7 = t6 * t4.sqrt();
            let t8 = k14 * t7 + (k13 + k4 * sin0);
            let t9 = t6 * t7;
            let t10 = k15 * t7;
            let t11 = k16 * t1 + t1 * t10;
            let t12 = k20 * (k12 * sin_theta1 + k3 * qd_theta1 + t11 - cos_theta1 * t8);
            let t13 = k18 * (k3 * qd_theta2 + k12 * sin_theta2 + cos_theta2 * t8 - t11);
            let t14 = sin_theta2 * t9;
            let t15 = k24 * t14;
            let t16 = k26 * cos_theta1;
            let t17 = sin_theta1 * t9;
            let t18 = k25 * sin_theta2 * t14 + k25 * sin_theta1 * t17
                - (k23 * sin_theta2 * t5 * t17 - (k16 * t5 + t10 * t5));
            let t19 = k29 * t17 - k29 * t14;
            let t20 = k24 * t17;
            let t21 = t15 + sin_theta1 * t8 + cos_theta1 * (k12 + t16 * t9) + t18
                - t5 * t20;
            let t22 = k20 * t21;
            let t23 = cos_theta2 * t9;
            let t24 = t5 * t15 + cos_theta2 * (k12 + k26 * t23) + t18 - t20
                - sin_theta2 * t8;
            let t25 = t19 + t5 * t19 - t16 * t23 - t18;
            let t26 = k18 * t24;
            let t27 = k18 * t25;
            let t28 = k20 * t25;
            (
                ::pendulum_core::nalgebra::SVector::from([
                    qd_theta1,
                    qd_theta2,
                    t12,
                    t13,
                ]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [T::from_f64(0.0), T::from_f64(0.0), t22, t27],
                    [T::from_f64(0.0), T::from_f64(0.0), t28, t26],
                    [T::from_f64(1.0), T::from_f64(0.0), k27, T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(1.0), T::from_f64(0.0), k28],
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
            let [q_theta1, q_theta2, _, _] = x.data.0[0];
            let k5 = self.constants[5];
            let k18 = self.constants[18];
            let k19 = self.constants[19];
            let k30 = self.constants[30];
            let (_, cos0) = (k5 * t).sin_cos();
            let t1 = k30 * cos0;
            let [(_, cos_theta1), (_, cos_theta2)] = q_theta1.sin_cos_pair(q_theta2);
            ::pendulum_core::nalgebra::SVector::from([
                T::from_f64(0.0),
                T::from_f64(0.0),
                k19 * cos_theta1 * t1,
                k18 * cos_theta2 * t1,
            ])
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Energy<T, 4> for Coupled<T> {
        #[inline]
        fn kinetic(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 4>) -> T {
            let [_, _, qd_theta1, qd_theta2] = x.data.0[0];
            let k17 = self.constants[17];
            k17 * (qd_theta1 * qd_theta1 + qd_theta2 * qd_theta2)
        }
        #[inline]
        fn potential(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 4>) -> T {
            let [q_theta1, q_theta2, _, _] = x.data.0[0];
            let k1 = self.constants[1];
            let k4 = self.constants[4];
            let k5 = self.constants[5];
            let k7 = self.constants[7];
            let k22 = self.constants[22];
            let k31 = self.constants[31];
            let (sin0, _) = (k5 * t).sin_cos();
            let [(sin_theta2, cos_theta2), (sin_theta1, cos_theta1)] = q_theta2
                .sin_cos_pair(q_theta1);
            let t1 = sin_theta2 - sin_theta1;
            let t2 = k7 * (cos_theta1 - cos_theta2);
            let t3 = k1 + k7 * t1;
            let t4 = (t3 * t3 + t2 * t2).sqrt() - k1;
            k31 * t4 * t4 + k4 * sin0 * t1 - k22 * (cos_theta1 + cos_theta2)
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::shapes::Shapes<4> for Coupled {
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
                        name: "left",
                        kind: ::pendulum_core::shapes::ShapeKind::Rod,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "right",
                        kind: ::pendulum_core::shapes::ShapeKind::Rod,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "left",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "right",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "left",
                        kind: ::pendulum_core::shapes::ShapeKind::Spring,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "a",
                        kind: ::pendulum_core::shapes::ShapeKind::Point,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "b",
                        kind: ::pendulum_core::shapes::ShapeKind::Point,
                        points: 1,
                        radius: false,
                    },
                ],
                &{
                    let [q_theta1, q_theta2, _, _] = x.data.0[0];
                    let k0 = self.constants[0];
                    let k1 = self.constants[1];
                    let k6 = self.constants[6];
                    let k7 = self.constants[7];
                    let k8 = self.constants[8];
                    let [(sin_theta1, cos_theta1), (sin_theta2, cos_theta2)] = q_theta1
                        .sin_cos_pair(q_theta2);
                    let t0 = k0 * sin_theta1;
                    let t1 = k6 * cos_theta1;
                    let t2 = k1 + k0 * sin_theta2;
                    let t3 = k6 * cos_theta2;
                    let t4 = k7 * sin_theta1;
                    let t5 = k8 * cos_theta1;
                    let t6 = k1 + k7 * sin_theta2;
                    let t7 = k8 * cos_theta2;
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t0,
                        t1,
                        T::from_f64(0.0),
                        k1,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t2,
                        t3,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        k1,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t4,
                        t5,
                        T::from_f64(0.0),
                        t6,
                        t7,
                        T::from_f64(0.0),
                        t4,
                        t5,
                        T::from_f64(0.0),
                        t6,
                        t7,
                        T::from_f64(0.0),
                    ]
                },
            )
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::CastJacobian<4> for Coupled {
        #[inline]
        fn with_jacobian<T: ::pendulum_core::real::Real>(
            model: &Coupled<T>,
        ) -> &impl ::pendulum_core::Jacobian<T, 4> {
            model
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::Cast<4> for Coupled {
        type In<T: ::pendulum_core::real::Real> = Coupled<T>;
        fn cast<T: ::pendulum_core::real::Real>(&self) -> Coupled<T> {
            Coupled::cast(self)
        }
        #[inline]
        fn gather<'m, T: ::pendulum_core::real::lanes::Lanes>(
            models: impl ::core::ops::Fn(usize) -> &'m Self,
        ) -> Coupled<T>
        where
            Self: 'm,
        {
            let scalar = <<T as ::pendulum_core::real::lanes::Lanes>::Scalar as ::pendulum_core::real::Real>::from_f64;
            Coupled {
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
pub use __Coupled::{Coupled, CoupledParams};
