#[allow(non_snake_case)]
mod __FiveBar {
    ///Parameters of [`FiveBar`].
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct FiveBarParams {
        ///In m.
        pub a: f64,
        ///In m.
        pub b: f64,
        ///In m.
        pub d: f64,
        ///In N m.
        pub k: f64,
        ///In N m s.
        pub c: f64,
        ///In rad/s.
        pub w: f64,
    }
    impl ::core::default::Default for FiveBarParams {
        #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
        fn default() -> Self {
            Self {
                a: 0.25f64,
                b: 0.4f64,
                d: 0.3f64,
                k: 40f64,
                c: 1.5f64,
                w: 4f64,
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl FiveBarParams {
        /// The names of the parameters, in the order of their declaration.
        pub const NAMES: [&'static str; 6] = ["a", "b", "d", "k", "c", "w"];
        /// The values of the parameters, in the order of [`NAMES`](Self::NAMES).
        pub const fn to_array(self) -> [f64; 6] {
            [self.a, self.b, self.d, self.k, self.c, self.w]
        }
        /// The parameters with these values, in the order of [`NAMES`](Self::NAMES).
        pub const fn from_array(values: [f64; 6]) -> Self {
            let [v0, v1, v2, v3, v4, v5] = values;
            Self {
                a: v0,
                b: v1,
                d: v2,
                k: v3,
                c: v4,
                w: v5,
            }
        }
    }
    /// Cranks of length `a` and bars of length `b`, on motors a distance `d` apart.
    ///
    /**# Equations of motion

```text
A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints

A[q1, q1] = 0.1*b^2*slope_angle_right_bar_q1^2 + 13/30*a^2 + 0.3*a*b*slope_angle_left_bar_q1*t13
    + 0.1*b^2*slope_angle_left_bar_q1^2
A[q1, q2] = 0.1*b^2*slope_angle_left_bar_q1*slope_angle_left_bar_q2 + 0.15*a*b*slope_angle_left_bar_q2*t13
    + 0.1*b^2*slope_angle_right_bar_q1*slope_angle_right_bar_q2 + 0.15*a*b*slope_angle_right_bar_q1*t15
A[q2, q2] = 13/30*a^2 + 0.1*b^2*slope_angle_left_bar_q2^2 + 0.3*a*b*slope_angle_right_bar_q2*t15
    + 0.1*b^2*slope_angle_right_bar_q2^2
b[q1] = 4.905*a*c1 + 0.15*a*b*dot(angle_left_bar)^2*t14 + 0.1*b^2*slope_angle_left_bar_q1*drift_angle_left_bar
    + 1.4715*b*slope_angle_left_bar_q1*t11 + 0.1*b^2*slope_angle_right_bar_q1*drift_angle_right_bar
    + 1.4715*b*slope_angle_right_bar_q1*t12 + 0.15*a*b*drift_angle_left_bar*t13
    - 0.15*a*b*dot(q1)^2*slope_angle_left_bar_q1*t14 - 0.15*a*b*dot(q2)^2*slope_angle_right_bar_q1*t16
b[q2] = 4.905*a*c2 + 0.15*a*b*dot(angle_right_bar)^2*t16 + 0.1*b^2*slope_angle_left_bar_q2*drift_angle_left_bar
    + 1.4715*b*slope_angle_left_bar_q2*t11 + 0.1*b^2*slope_angle_right_bar_q2*drift_angle_right_bar
    + 1.4715*b*slope_angle_right_bar_q2*t12 + 0.15*a*b*drift_angle_right_bar*t15
    - 0.15*a*b*dot(q1)^2*slope_angle_left_bar_q2*t14 - 0.15*a*b*dot(q2)^2*slope_angle_right_bar_q2*t16
Q[q1] = k*(first - q1) - c*dot(q1)
Q[q2] = k*(second - q2) - c*dot(q2)

where
first = 2.2 + 0.35*sin(w*t)
second = 0.9 + 0.35*cos(2*w*t)
c1 = cos(q1)
c2 = cos(q2)
t0 = d + a*c2 - a*c1
t1 = a*sin(q2) - a*sin(q1)
t2 = t0^2 + t1^2
t3 = sqrt(b^2/t2 - 0.25)
t4 = 0.5*t0 + (a*sin(q1) - a*sin(q2))*t3
t5 = 0.5*t1 + t0*t3
angle_left_bar = atan2(t5/b, t4/b)
t6 = t0 - t4
t7 = t1 - t5
angle_right_bar = atan2(-t7/b, -t6/b)
t8 = t5 - t1
slope_angle_left_bar_q1 = -(a*sin(q1)*t6 + a*c1*t8)/(t2*t3)
slope_angle_left_bar_q2 = (a*sin(q2)*t6 + a*c2*t8)/(t2*t3)
dot(angle_left_bar) = dot(q1)*slope_angle_left_bar_q1 + dot(q2)*slope_angle_left_bar_q2
slope_angle_right_bar_q1 = -(a*c1*t5 - a*sin(q1)*t4)/(t2*t3)
slope_angle_right_bar_q2 = -(a*sin(q2)*t4 - a*c2*t5)/(t2*t3)
dot(angle_right_bar) = dot(q1)*slope_angle_right_bar_q1 + dot(q2)*slope_angle_right_bar_q2
t9 = a*dot(q2)^2*c2 - a*dot(q1)^2*c1 - t4*dot(angle_left_bar)^2 - t6*dot(angle_right_bar)^2
t10 = a*dot(q2)^2*sin(q2) - a*dot(q1)^2*sin(q1) - t5*dot(angle_left_bar)^2 - t7*dot(angle_right_bar)^2
drift_angle_left_bar = (t6*t9 - t8*t10)/(t2*t3)
drift_angle_right_bar = -(t4*t9 + t5*t10)/(t2*t3)
t11 = cos(angle_left_bar)
t12 = cos(angle_right_bar)
t13 = cos(q1 - angle_left_bar)
t14 = sin(q1 - angle_left_bar)
t15 = cos(q2 - angle_right_bar)
t16 = sin(q2 - angle_right_bar)
```

# Constants, computed by `new`

```text
k0 = a
k1 = b
k2 = d
k3 = k
k4 = c
k5 = w
k6 = 2*w
k7 = b^2
k8 = 0.15*b
k9 = 0.025*b^2 + 0.3*(0.5*b)^2
k10 = sqrt(b^4)
k11 = 1/30*a^2 + 0.4*(0.5*a)^2 + 0.3*a^2
k12 = 0.0225*(a*b)^2
k13 = 13/30*a^2
k14 = 0.1*b^2
k15 = 0.3*a*b
k16 = 0.15*a*b
k17 = 1.4715*b
k18 = 4.905*a
k19 = 13/60*a^2
k20 = 0.03*a*b^3
k21 = 0.01*b^4
k22 = 0.09*(a*b)^2
k23 = 0.02*b^4
k24 = 0.13*a^3*b
k25 = 13/300*a^2*b^2
k26 = 1/48*a^2*b^2
k27 = 0.045*(a*b)^2
k28 = 169/900*a^4
k29 = 0.05*b^2
k30 = 1/b
k31 = 1*0.15
k32 = 1/sqrt(b^4)
k33 = 0.5*b^2
k34 = 0.35*k*w
k35 = 0.35*2*k*w
k36 = 1*1.4715
k37 = 1
```
*/
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct FiveBar<T = f64> {
        params: FiveBarParams,
        constants: [T; 38],
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl FiveBar {
        /// Builds the model: checks the parameters, and computes once whatever depends on them alone.
        ///
        /// # Errors
        ///
        /// The first parameter, or combination of parameters, that is not finite or that no rigid body can
        /// have.
        pub fn new(
            params: FiveBarParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            #[inline]
            fn rules<T: ::pendulum_core::real::Real>(given: [T; 6]) -> [T; 0] {
                let [p_a, p_b, p_d, p_k, p_c, p_w] = given;
                []
            }
            #[inline]
            fn constants<T: ::pendulum_core::real::Real>(given: [T; 6]) -> [T; 38] {
                let [p_a, p_b, p_d, p_k, p_c, p_w] = given;
                let t0 = T::from_f64(4.905) * p_a;
                let t1 = T::from_f64(0.18777777777777777) * (p_a * p_a * p_a * p_a);
                let t2 = T::from_f64(2.0) * p_w;
                let t3 = p_b * p_b;
                let t4 = T::from_f64(0.1) * t3;
                let t5 = T::from_f64(0.05) * t3;
                let t6 = T::from_f64(0.5) * t3;
                let t7 = T::from_f64(0.15) * p_b;
                let t8 = T::from_f64(0.5) * p_b;
                let t9 = T::from_f64(0.025) * t3 + T::from_f64(0.3) * (t8 * t8);
                let t10 = p_b * p_b * p_b * p_b;
                let t11 = t10.sqrt();
                let t12 = T::from_f64(0.01) * t10;
                let t13 = T::from_f64(0.02) * t10;
                let t14 = T::from_f64(1.0) / t10.sqrt();
                let t15 = p_a * p_a;
                let t16 = T::from_f64(0.43333333333333335) * t15;
                let t17 = T::from_f64(0.21666666666666667) * t15;
                let t18 = T::from_f64(0.5) * p_a;
                let t19 = T::from_f64(0.03333333333333333) * t15
                    + T::from_f64(0.4) * (t18 * t18) + p_a * (T::from_f64(0.3) * p_a);
                let t20 = p_a * p_b;
                let t21 = T::from_f64(0.3) * t20;
                let t22 = T::from_f64(0.15) * t20;
                let t23 = T::from_f64(0.03) * (t3 * t20);
                let t24 = T::from_f64(0.13) * (t15 * t20);
                let t25 = t15 * t3;
                let t26 = t20 * t20;
                let t27 = T::from_f64(0.0225) * t26;
                let t28 = T::from_f64(0.09) * t26;
                let t29 = T::from_f64(0.045) * t26;
                let t30 = T::from_f64(0.043333333333333335) * t25;
                let t31 = T::from_f64(0.020833333333333332) * t25;
                let t32 = T::from_f64(1.4715) * p_b;
                let t33 = T::from_f64(1.0) / p_b;
                let t34 = t7 * t33;
                let t35 = t32 * t33;
                let t36 = p_b * t33;
                let t37 = T::from_f64(0.35) * p_k;
                let t38 = t2 * t37;
                let t39 = p_w * t37;
                [
                    p_a,
                    p_b,
                    p_d,
                    p_k,
                    p_c,
                    p_w,
                    t2,
                    t3,
                    t7,
                    t9,
                    t11,
                    t19,
                    t27,
                    t16,
                    t4,
                    t21,
                    t22,
                    t32,
                    t0,
                    t17,
                    t23,
                    t12,
                    t28,
                    t13,
                    t24,
                    t30,
                    t31,
                    t29,
                    t1,
                    t5,
                    t33,
                    t34,
                    t14,
                    t6,
                    t39,
                    t38,
                    t35,
                    t36,
                ]
            }
            let given = params.to_array();
            for (name, value) in FiveBarParams::NAMES.into_iter().zip(given) {
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
            let names: [&'static str; 38] = [
                "a",
                "b",
                "d",
                "k",
                "c",
                "w",
                "2*w",
                "b^2",
                "0.15*b",
                "0.025*b^2 + 0.3*(0.5*b)^2",
                "sqrt(b^4)",
                "1/30*a^2 + 0.4*(0.5*a)^2 + 0.3*a^2",
                "0.0225*(a*b)^2",
                "13/30*a^2",
                "0.1*b^2",
                "0.3*a*b",
                "0.15*a*b",
                "1.4715*b",
                "4.905*a",
                "13/60*a^2",
                "0.03*a*b^3",
                "0.01*b^4",
                "0.09*(a*b)^2",
                "0.02*b^4",
                "0.13*a^3*b",
                "13/300*a^2*b^2",
                "1/48*a^2*b^2",
                "0.045*(a*b)^2",
                "169/900*a^4",
                "0.05*b^2",
                "1/b",
                "1*0.15",
                "1/sqrt(b^4)",
                "0.5*b^2",
                "0.35*k*w",
                "0.35*2*k*w",
                "1*1.4715",
                "1",
            ];
            for (name, value) in names.into_iter().zip(constants) {
                if !value.is_finite() {
                    let given: [_; 6] = ::core::array::from_fn(|n| (
                        FiveBarParams::NAMES[n],
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
        pub fn cast<T: ::pendulum_core::real::Real>(&self) -> FiveBar<T> {
            FiveBar {
                params: self.params,
                constants: self.constants.map(T::from_f64),
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> FiveBar<T> {
        /// The parameters that the model was built from.
        pub fn params(&self) -> &FiveBarParams {
            &self.params
        }
        /// The model with other parameters, in the same number type. Its constants are computed anew.
        ///
        /// # Errors
        ///
        /// Those of `new`.
        pub fn with_params(
            &self,
            params: FiveBarParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            Ok(<FiveBar>::new(params)?.cast())
        }
    }
    impl FiveBar {
        ///The place of `q1` in the state, where it stands in rad.
        pub const Q1: usize = 0;
        ///The place of `dot(q1)` in the state, where it stands in rad/s.
        pub const DOT_Q1: usize = 2;
        ///The place of `q2` in the state, where it stands in rad.
        pub const Q2: usize = 1;
        ///The place of `dot(q2)` in the state, where it stands in rad/s.
        pub const DOT_Q2: usize = 3;
        /// The number of degrees of freedom; the state has twice as many components.
        pub const DOF: usize = 2;
        /// The names of the coordinates, in the order in which they, and then their rates, stand in the state.
        pub const COORDINATES: [&'static str; 2] = ["q1", "q2"];
        /// Counted operations of each generated function, in the form that it has and in others.
        pub const COST: ::pendulum_core::Cost = ::pendulum_core::Cost::new(
            &[
                (
                    "rhs",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first, adjugate",
                            ::pendulum_core::Operations::new(77, 135, 3, 4, 1, 62),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, adjugate",
                                    ::pendulum_core::Operations::new(90, 119, 3, 4, 1, 65),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, adjugate",
                                    ::pendulum_core::Operations::new(76, 138, 3, 4, 1, 64),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, adjugate",
                                    ::pendulum_core::Operations::new(79, 144, 3, 4, 1, 62),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C, adjugate",
                                    ::pendulum_core::Operations::new(116, 140, 3, 4, 1, 66),
                                ),
                            ],
                        ),
                ),
                (
                    "loop_margins",
                    ::pendulum_core::FunctionCost::new(
                        "as declared",
                        ::pendulum_core::Operations::new(9, 23, 4, 2, 1, 42),
                    ),
                ),
                (
                    "jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first, inverse, derived in the graph",
                            ::pendulum_core::Operations::new(273, 439, 6, 4, 1, 82),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, inverse, derived in the graph",
                                    ::pendulum_core::Operations::new(289, 485, 6, 4, 1, 81),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, inverse, derived in the graph",
                                    ::pendulum_core::Operations::new(293, 481, 6, 4, 1, 83),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, inverse, derived in the graph",
                                    ::pendulum_core::Operations::new(332, 454, 6, 4, 1, 84),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C, inverse, derived in the graph",
                                    ::pendulum_core::Operations::new(435, 523, 6, 4, 1, 82),
                                ),
                            ],
                        ),
                ),
                (
                    "time_derivative",
                    ::pendulum_core::FunctionCost::new(
                            "recursion, adjugate, derived in the graph",
                            ::pendulum_core::Operations::new(47, 67, 3, 4, 1, 60),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first, adjugate, derived in the graph",
                                    ::pendulum_core::Operations::new(46, 87, 3, 4, 1, 55),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, adjugate, derived in the graph",
                                    ::pendulum_core::Operations::new(46, 90, 3, 4, 1, 59),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, L^T D L, derived in the graph",
                                    ::pendulum_core::Operations::new(43, 87, 4, 4, 1, 60),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C, adjugate, derived in the graph",
                                    ::pendulum_core::Operations::new(68, 79, 3, 4, 1, 60),
                                ),
                            ],
                        ),
                ),
                (
                    "kinetic",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(22, 43, 2, 2, 1, 48),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(22, 43, 2, 2, 1, 48),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(22, 42, 2, 2, 1, 49),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(38, 57, 2, 2, 1, 54),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C",
                                    ::pendulum_core::Operations::new(57, 71, 2, 2, 1, 53),
                                ),
                            ],
                        ),
                ),
                (
                    "potential",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(10, 9, 1, 2, 1, 41),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(10, 9, 1, 2, 1, 41),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(10, 9, 1, 2, 1, 41),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C",
                                    ::pendulum_core::Operations::new(12, 11, 1, 2, 1, 41),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(12, 11, 1, 2, 1, 41),
                                ),
                            ],
                        ),
                ),
                (
                    "hand",
                    ::pendulum_core::FunctionCost::new(
                        "as declared",
                        ::pendulum_core::Operations::new(9, 13, 1, 2, 1, 39),
                    ),
                ),
                (
                    "hand_rate",
                    ::pendulum_core::FunctionCost::new(
                        "as declared",
                        ::pendulum_core::Operations::new(15, 26, 2, 2, 1, 47),
                    ),
                ),
                (
                    "hand_and_jacobian",
                    ::pendulum_core::FunctionCost::new(
                        "as declared",
                        ::pendulum_core::Operations::new(16, 26, 2, 2, 1, 43),
                    ),
                ),
                (
                    "gap",
                    ::pendulum_core::FunctionCost::new(
                        "as declared",
                        ::pendulum_core::Operations::new(13, 13, 1, 2, 1, 41),
                    ),
                ),
                (
                    "gap_rate",
                    ::pendulum_core::FunctionCost::new(
                        "as declared",
                        ::pendulum_core::Operations::new(21, 38, 2, 2, 1, 47),
                    ),
                ),
                (
                    "gap_and_jacobian",
                    ::pendulum_core::FunctionCost::new(
                        "as declared",
                        ::pendulum_core::Operations::new(25, 40, 2, 2, 1, 44),
                    ),
                ),
                (
                    "outputs",
                    ::pendulum_core::FunctionCost::new(
                        "as declared",
                        ::pendulum_core::Operations::new(15, 15, 1, 2, 1, 41),
                    ),
                ),
                (
                    "output_rates",
                    ::pendulum_core::FunctionCost::new(
                        "as declared",
                        ::pendulum_core::Operations::new(22, 39, 2, 2, 1, 49),
                    ),
                ),
                (
                    "outputs_and_jacobian",
                    ::pendulum_core::FunctionCost::new(
                        "as declared",
                        ::pendulum_core::Operations::new(30, 40, 2, 2, 1, 44),
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
                    2..3,
                ),
                ::pendulum_core::Slot::new(
                    "q2",
                    ::pendulum_core::SlotKind::Angle,
                    1..2,
                    3..4,
                ),
            ],
        );
        /// The equations of motion as text.
        pub const EQUATIONS: &'static str = "A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints\n\nA[q1, q1] = 0.1*b^2*slope_angle_right_bar_q1^2 + 13/30*a^2 + 0.3*a*b*slope_angle_left_bar_q1*t13\n    + 0.1*b^2*slope_angle_left_bar_q1^2\nA[q1, q2] = 0.1*b^2*slope_angle_left_bar_q1*slope_angle_left_bar_q2 + 0.15*a*b*slope_angle_left_bar_q2*t13\n    + 0.1*b^2*slope_angle_right_bar_q1*slope_angle_right_bar_q2 + 0.15*a*b*slope_angle_right_bar_q1*t15\nA[q2, q2] = 13/30*a^2 + 0.1*b^2*slope_angle_left_bar_q2^2 + 0.3*a*b*slope_angle_right_bar_q2*t15\n    + 0.1*b^2*slope_angle_right_bar_q2^2\nb[q1] = 4.905*a*c1 + 0.15*a*b*dot(angle_left_bar)^2*t14 + 0.1*b^2*slope_angle_left_bar_q1*drift_angle_left_bar\n    + 1.4715*b*slope_angle_left_bar_q1*t11 + 0.1*b^2*slope_angle_right_bar_q1*drift_angle_right_bar\n    + 1.4715*b*slope_angle_right_bar_q1*t12 + 0.15*a*b*drift_angle_left_bar*t13\n    - 0.15*a*b*dot(q1)^2*slope_angle_left_bar_q1*t14 - 0.15*a*b*dot(q2)^2*slope_angle_right_bar_q1*t16\nb[q2] = 4.905*a*c2 + 0.15*a*b*dot(angle_right_bar)^2*t16 + 0.1*b^2*slope_angle_left_bar_q2*drift_angle_left_bar\n    + 1.4715*b*slope_angle_left_bar_q2*t11 + 0.1*b^2*slope_angle_right_bar_q2*drift_angle_right_bar\n    + 1.4715*b*slope_angle_right_bar_q2*t12 + 0.15*a*b*drift_angle_right_bar*t15\n    - 0.15*a*b*dot(q1)^2*slope_angle_left_bar_q2*t14 - 0.15*a*b*dot(q2)^2*slope_angle_right_bar_q2*t16\nQ[q1] = k*(first - q1) - c*dot(q1)\nQ[q2] = k*(second - q2) - c*dot(q2)\n\nwhere\nfirst = 2.2 + 0.35*sin(w*t)\nsecond = 0.9 + 0.35*cos(2*w*t)\nc1 = cos(q1)\nc2 = cos(q2)\nt0 = d + a*c2 - a*c1\nt1 = a*sin(q2) - a*sin(q1)\nt2 = t0^2 + t1^2\nt3 = sqrt(b^2/t2 - 0.25)\nt4 = 0.5*t0 + (a*sin(q1) - a*sin(q2))*t3\nt5 = 0.5*t1 + t0*t3\nangle_left_bar = atan2(t5/b, t4/b)\nt6 = t0 - t4\nt7 = t1 - t5\nangle_right_bar = atan2(-t7/b, -t6/b)\nt8 = t5 - t1\nslope_angle_left_bar_q1 = -(a*sin(q1)*t6 + a*c1*t8)/(t2*t3)\nslope_angle_left_bar_q2 = (a*sin(q2)*t6 + a*c2*t8)/(t2*t3)\ndot(angle_left_bar) = dot(q1)*slope_angle_left_bar_q1 + dot(q2)*slope_angle_left_bar_q2\nslope_angle_right_bar_q1 = -(a*c1*t5 - a*sin(q1)*t4)/(t2*t3)\nslope_angle_right_bar_q2 = -(a*sin(q2)*t4 - a*c2*t5)/(t2*t3)\ndot(angle_right_bar) = dot(q1)*slope_angle_right_bar_q1 + dot(q2)*slope_angle_right_bar_q2\nt9 = a*dot(q2)^2*c2 - a*dot(q1)^2*c1 - t4*dot(angle_left_bar)^2 - t6*dot(angle_right_bar)^2\nt10 = a*dot(q2)^2*sin(q2) - a*dot(q1)^2*sin(q1) - t5*dot(angle_left_bar)^2 - t7*dot(angle_right_bar)^2\ndrift_angle_left_bar = (t6*t9 - t8*t10)/(t2*t3)\ndrift_angle_right_bar = -(t4*t9 + t5*t10)/(t2*t3)\nt11 = cos(angle_left_bar)\nt12 = cos(angle_right_bar)\nt13 = cos(q1 - angle_left_bar)\nt14 = sin(q1 - angle_left_bar)\nt15 = cos(q2 - angle_right_bar)\nt16 = sin(q2 - angle_right_bar)\n";
        ///The names of the components of all outputs.
        pub const OUTPUTS: [&'static str; 4] = [
            "hand[0]",
            "hand[1]",
            "gap[0]",
            "gap[1]",
        ];
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::System<T, 4> for FiveBar<T> {
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn rhs(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 4> {
            let [q_q1, q_q2, qd_q1, qd_q2] = x.data.0[0];
            let k0 = self.constants[0];
            let k2 = self.constants[2];
            let k3 = self.constants[3];
            let k4 = self.constants[4];
            let k5 = self.constants[5];
            let k7 = self.constants[7];
            let k12 = self.constants[12];
            let k13 = self.constants[13];
            let k14 = self.constants[14];
            let k15 = self.constants[15];
            let k16 = self.constants[16];
            let k17 = self.constants[17];
            let k18 = self.constants[18];
            let k20 = self.constants[20];
            let k21 = self.constants[21];
            let k22 = self.constants[22];
            let k23 = self.constants[23];
            let k24 = self.constants[24];
            let k25 = self.constants[25];
            let k26 = self.constants[26];
            let k27 = self.constants[27];
            let k28 = self.constants[28];
            let k30 = self.constants[30];
            let t0 = qd_q2 * qd_q2;
            let t1 = qd_q1 * qd_q1;
            let t2 = k5 * t;
            let [(sin3, _), (_, cos4)] = t2.sin_cos_pair(T::from_f64(2.0) * t2);
            let [(sin_q2, cos_q2), (sin_q1, cos_q1)] = q_q2.sin_cos_pair(q_q1);
            let t5 = k0 * cos_q2;
            let t6 = k0 * cos_q1;
            let t7 = k2 + t5 - t6;
            let t8 = k0 * sin_q2;
            let t9 = k0 * sin_q1;
            let t10 = t8 - t9;
            let t11 = t7 * t7 + t10 * t10;
            let t12 = (k7 * (T::from_f64(1.0) / t11) - T::from_f64(0.25)).sqrt();
            let t13 = T::from_f64(1.0) / (t11 * t12);
            let t14 = T::from_f64(0.5) * t7 - t12 * t10;
            let t15 = T::from_f64(0.5) * t10 + t7 * t12;
            let t16 = t7 - t14;
            let t17 = t10 - t15;
            let t18 = t13 * (t8 * t14 - t5 * t15);
            let t19 = k30 * t16;
            let t20 = k30 * t17;
            let t21 = cos_q2 * t19 + sin_q2 * t20;
            let t22 = cos_q2 * t20 - sin_q2 * t19;
            let t23 = t13 * (t6 * t15 - t9 * t14);
            let t24 = t23 * t23;
            let t25 = k28 + t18 * (k24 * t21 + k25 * t18)
                + (k26 + k12 * t22 * t22) * t24;
            let t26 = t13 * (t8 * t16 - t5 * t17);
            let t27 = k30 * t14;
            let t28 = k30 * t15;
            let t29 = sin_q1 * t27 - cos_q1 * t28;
            let t30 = cos_q1 * t27 + sin_q1 * t28;
            let t31 = k20 * t18;
            let t32 = t26 * (k26 + k21 * t24 + k12 * t29 * t29)
                - t23 * t30 * (t31 + k27 * t21);
            let t33 = t13 * (t9 * t16 - t6 * t17);
            let t34 = k20 * t21;
            let t35 = t23 * t26;
            let t36 = k23 * t35 + t33 * (t34 + k21 * t18) - t30 * (t31 + k22 * t21);
            let t37 = t33 * (k24 * t30 - t34 * t35 - k25 * t33 - t18 * t36);
            let t38 = T::from_f64(-1.0) / (t25 + t26 * t32 - t37);
            let t39 = k14 * t18;
            let t40 = t26 * qd_q2 - t33 * qd_q1;
            let t41 = t40 * t40;
            let t42 = t23 * qd_q1 + t18 * qd_q2;
            let t43 = t42 * t42;
            let t44 = t5 * t0 - t6 * t1 - t14 * t41 - t16 * t43;
            let t45 = t8 * t0 - t9 * t1 - t15 * t41 - t17 * t43;
            let t46 = t13 * (t16 * t44 + t17 * t45);
            let t47 = t13 * (t14 * t44 + t15 * t45);
            let t48 = t23 * t22 * t0 + t30 * t46 + t29 * (t41 + t33 * t1);
            let t49 = t21 * t47 + t22 * (t43 + t18 * t0) - t26 * t29 * t1;
            let t50 = k14 * t47 + k17 * t19;
            let t51 = k14 * t46 + k17 * t27;
            let t52 = k16 * t48 + k4 * qd_q1 + k18 * cos_q1
                + k3 * (q_q1 - T::from_f64(0.35) * sin3 - T::from_f64(2.2));
            let t53 = k16 * t49 + t26 * t51 + k4 * qd_q2 + k18 * cos_q2
                + k3 * (q_q2 - T::from_f64(0.35) * cos4 - T::from_f64(0.9));
            let t54 = t52 + t23 * t50 - t33 * t51;
            let t55 = t53 + t18 * t50;
            let t56 = (k13 + k14 * t26 * t26 + t18 * (t39 + k15 * t21)) * t54;
            let t57 = k14 * t33;
            let t58 = t23 * (t39 + k16 * t21) + t26 * (k16 * t30 - t57);
            let t59 = t55 * (k13 + k14 * t24 - t33 * (k15 * t30 - t57)) - t54 * t58;
            ::pendulum_core::nalgebra::SVector::from([
                qd_q1,
                qd_q2,
                t38 * (t56 - t58 * t55),
                t38 * t59,
            ])
        }
        #[inline]
        fn layout(
            &self,
        ) -> ::core::option::Option<&'static ::pendulum_core::StateLayout> {
            Some(&<FiveBar>::LAYOUT)
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn margins(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
            tell: &mut dyn FnMut([&'static str; 2], [T; 2]),
        ) {
            let (margins, rates) = self.loop_margins(t, x);
            tell(["left_bar", "right_bar"], [margins[0], rates[0]]);
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Jacobian<T, 4> for FiveBar<T> {
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
            let [q_q1, q_q2, qd_q1, qd_q2] = x.data.0[0];
            let k0 = self.constants[0];
            let k1 = self.constants[1];
            let k2 = self.constants[2];
            let k3 = self.constants[3];
            let k4 = self.constants[4];
            let k5 = self.constants[5];
            let k7 = self.constants[7];
            let k12 = self.constants[12];
            let k13 = self.constants[13];
            let k14 = self.constants[14];
            let k15 = self.constants[15];
            let k16 = self.constants[16];
            let k17 = self.constants[17];
            let k18 = self.constants[18];
            let k20 = self.constants[20];
            let k21 = self.constants[21];
            let k22 = self.constants[22];
            let k23 = self.constants[23];
            let k24 = self.constants[24];
            let k25 = self.constants[25];
            let k26 = self.constants[26];
            let k27 = self.constants[27];
            let k28 = self.constants[28];
            let k30 = self.constants[30];
            let t0 = qd_q2 * qd_q2;
            let t1 = qd_q1 * qd_q1;
            let t2 = k5 * t;
            let [(sin3, _), (_, cos4)] = t2.sin_cos_pair(T::from_f64(2.0) * t2);
            let t5 = T::from_f64(2.0) * qd_q1;
            let t6 = T::from_f64(2.0) * qd_q2;
            let [(sin_q2, cos_q2), (sin_q1, cos_q1)] = q_q2.sin_cos_pair(q_q1);
            let t7 = k0 * sin_q2;
            let t8 = k0 * sin_q1;
            let t9 = t7 - t8;
            let t10 = k0 * cos_q2;
            let t11 = k0 * cos_q1;
            let t12 = k2 + t10 - t11;
            let t13 = t12 * t12 + t9 * t9;
            let t14 = (k7 * (T::from_f64(1.0) / t13) - T::from_f64(0.25)).sqrt();
            let t15 = T::from_f64(0.5) * t9 + t12 * t14;
            let t16 = t9 - t15;
            let t17 = k30 * t16;
            let t18 = T::from_f64(0.5) * t12 - t14 * t9;
            let t19 = t12 - t18;
            let t20 = k30 * t19;
            let t21 = cos_q2 * t17 - sin_q2 * t20;
            let t22 = t13 * t14;
            let t23 = T::from_f64(1.0) / t22;
            let t24 = T::from_f64(1.0) / (t22 * t22);
            let t25 = t11 * t15 - t8 * t18;
            let t26 = t23 * t25;
            let t27 = t26 * t0;
            let t28 = t10 * t0;
            let t29 = t11 * t1;
            let t30 = t7 * t19 - t10 * t16;
            let t31 = t23 * t30;
            let t32 = t8 * t19 - t11 * t16;
            let t33 = t23 * t32;
            let t34 = qd_q2 * t31 - qd_q1 * t33;
            let t35 = t34 * t34;
            let t36 = T::from_f64(2.0) * t34;
            let t37 = t7 * t18 - t10 * t15;
            let t38 = t23 * t37;
            let t39 = t26 * qd_q1 + qd_q2 * t38;
            let t40 = t39 * t39;
            let t41 = T::from_f64(2.0) * t39;
            let t42 = t28 - t29 - t18 * t35 - t19 * t40;
            let t43 = t7 * t0;
            let t44 = t8 * t1;
            let t45 = t43 - t44 - t15 * t35 - t16 * t40;
            let t46 = t19 * t42 + t16 * t45;
            let t47 = t23 * t46;
            let t48 = k30 * t18;
            let t49 = k30 * t15;
            let t50 = cos_q1 * t48 + sin_q1 * t49;
            let t51 = sin_q1 * t48 - cos_q1 * t49;
            let t52 = k14 * t47 + k17 * t48;
            let t53 = k17 * t49;
            let t54 = t35 + t33 * t1;
            let t55 = k16 * (t21 * t27 + t47 * t50 + t51 * t54) + k4 * qd_q1;
            let t56 = t18 * t42 + t15 * t45;
            let t57 = t23 * t56;
            let t58 = k14 * t57 + k17 * t20;
            let t59 = t55 + k18 * cos_q1
                + k3 * (q_q1 - T::from_f64(0.35) * sin3 - T::from_f64(2.2)) + t26 * t58;
            let t60 = t59 - t33 * t52;
            let t61 = cos_q2 * t20 + sin_q2 * t17;
            let t62 = k17 * t17;
            let t63 = k14 * t31;
            let t64 = k14 * t38;
            let t65 = t64 + k15 * t61;
            let t66 = t64 + k16 * t61;
            let t67 = t26 * t26;
            let t68 = k28 + t38 * (k24 * t61 + k25 * t38)
                + (k26 + k12 * t21 * t21) * t67;
            let t69 = k20 * t38;
            let t70 = t31 * (k26 + k21 * t67 + k12 * t51 * t51)
                - t26 * t50 * (t69 + k27 * t61);
            let t71 = k20 * t61;
            let t72 = t26 * t31;
            let t73 = k23 * t72 + t33 * (t71 + k21 * t38) - t50 * (t69 + k22 * t61);
            let t74 = t33 * (k24 * t50 - t71 * t72 - k25 * t33 - t38 * t73);
            let t75 = T::from_f64(-1.0) / (t68 + t31 * t70 - t74);
            let t76 = (k13 + t31 * t63 + t38 * t65) * t75;
            let t77 = t63 + t63;
            let t78 = t40 + t38 * t0;
            let t79 = t31 * t1;
            let t80 = k16 * (t57 * t61 + t21 * t78 - t51 * t79) + t31 * t52;
            let t81 = t80 + k4 * qd_q2 + k18 * cos_q2
                + k3 * (q_q2 - T::from_f64(0.35) * cos4 - T::from_f64(0.9));
            let t82 = t81 + t38 * t58;
            let t83 = k14 * t33;
            let t84 = k16 * t50 - t83;
            let t85 = k15 * t50 - t83;
            let t86 = t75 * (t26 * t66 + t31 * t84);
            let t87 = t60 * t76 - t82 * t86;
            let t88 = k14 * t26;
            let t89 = t75 * (k13 + t26 * t88 - t33 * t85);
            let t90 = t82 * t89 - t60 * t86;
            let t91 = t88 + t88;
            let t92 = T::from_f64(2.0) * t12;
            let t93 = T::from_f64(2.0) * t9;
            let t94 = t8 * t92 - t11 * t93;
            let t95 = t10 * t93 - t7 * t92;
            let t96 = k1 * (T::from_f64(0.5) * (T::from_f64(1.0) / t14))
                * (k1 * (T::from_f64(1.0) / (t13 * t13)));
            let t97 = t94 * t96;
            let t98 = (t14 * t94 - t13 * t97) * t24;
            let t99 = t95 * t96;
            let t100 = t24 * (t14 * t95 - t13 * t99);
            let t101 = T::from_f64(0.5) * t8 + t11 * t14 + t9 * t97;
            let t102 = t8 * t14 - t12 * t97 - T::from_f64(0.5) * t11;
            let t103 = T::from_f64(0.5) * t7 + t10 * t14 - t9 * t99;
            let t104 = T::from_f64(0.5) * t10 - t7 * t14 - t12 * t99;
            let t105 = t8 - t101;
            let t106 = t25 * t98 - t23 * (t11 * (t102 - t18) - t8 * (t15 + t101));
            let t107 = t25 * t100 - t23 * (t11 * t104 + t8 * t103);
            let t108 = t37 * t98 - t23 * (t7 * t101 - t10 * t102);
            let t109 = t37 * t100 - t23 * (t7 * (t15 - t103) + t10 * (t18 - t104));
            let t110 = (qd_q1 * t106 + qd_q2 * t108) * t41;
            let t111 = t11 + t102;
            let t112 = t32 * t98 - t23 * (t8 * (t16 + t105) + t11 * (t19 + t111));
            let t113 = t23 * (t7 * t105 + t10 * t111) - t30 * t98;
            let t114 = (qd_q1 * t112 + qd_q2 * t113) * t36;
            let t115 = t44 + t19 * t110 - t35 * t101 - t18 * t114 - t40 * t105;
            let t116 = t29 + t35 * t102 + t15 * t114 - t40 * t111 - t16 * t110;
            let t117 = t23 * (t42 * t105 + t19 * t115 - t45 * t111 - t16 * t116);
            let t118 = t23 * (t42 * t101 + t18 * t115 + t45 * t102 - t15 * t116);
            let t119 = t117 - t46 * t98;
            let t120 = t56 * t98 - t118;
            let t121 = T::from_f64(1.0) + t33;
            let t122 = t50 * t121;
            let t123 = t51 * t121;
            let t124 = t50 * t119 + t54 * t122 + t51 * (t114 - t112 * t1) - t47 * t123;
            let t125 = k14 * t119 + t33 * t53;
            let t126 = t26 * t61;
            let t127 = t21 * t0;
            let t128 = k3 + k16 * (t124 - t27 * t126 - t106 * t127) + t52 * t112;
            let t129 = k14 * t112;
            let t130 = t87 * (t85 * t112 - t33 * (t129 - k15 * t123) - t106 * t91);
            let t131 = k14 * t108;
            let t132 = t21 * t26;
            let t133 = t84 * t113 + t31 * (t129 - k16 * t123) - t66 * t106
                - t26 * (t131 - k16 * t132);
            let t134 = t128 + t130 + t90 * t133 - t33 * t125 - k18 * sin_q1 - t58 * t106;
            let t135 = t90 * (t113 * t77 - t65 * t108 - t38 * (t131 - k15 * t132));
            let t136 = k14 * t120 - t26 * t62;
            let t137 = t134 - t26 * t136;
            let t138 = t51 * t1;
            let t139 = t57 * t132 - t61 * t120 - t79 * t122 - t113 * t138 - t78 * t126;
            let t140 = k16 * (t139 - t21 * (t110 + t108 * t0)) + t52 * t113 + t31 * t125;
            let t141 = t140 + t87 * t133 + t135 - t58 * t108 - t38 * t136;
            let t142 = t76 * t137 - t86 * t141;
            let t143 = t89 * t141 - t86 * t137;
            let t144 = t103 - t7;
            let t145 = t10 - t104;
            let t146 = t32 * t100 - t23 * (t8 * t144 - t11 * t145);
            let t147 = t23 * (t7 * (t16 + t144) + t10 * (t19 - t145)) - t30 * t100;
            let t148 = t41 * (qd_q1 * t107 + qd_q2 * t109);
            let t149 = t36 * (qd_q1 * t146 + qd_q2 * t147);
            let t150 = t28 + t16 * t148 - t35 * t104 - t15 * t149 - t40 * t145;
            let t151 = t43 + t18 * t149 + t40 * t144 - t35 * t103 - t19 * t148;
            let t152 = t23 * (t42 * t144 + t45 * t145 + t16 * t150 - t19 * t151);
            let t153 = t23 * (t45 * t104 + t15 * t150 - t42 * t103 - t18 * t151);
            let t154 = t152 - t46 * t100;
            let t155 = t56 * t100 - t153;
            let t156 = k14 * t154 - t31 * t53;
            let t157 = k14 * t155 - t38 * t62;
            let t158 = t31 * t51;
            let t159 = T::from_f64(1.0) + t38;
            let t160 = t61 * t159;
            let t161 = t50 * t154 + t47 * t158 + t51 * (t149 - t146 * t1) - t27 * t160;
            let t162 = t21 * t159;
            let t163 = t31 * t50;
            let t164 = t57 * t162 + t79 * t163 - t61 * t155 - t147 * t138 - t78 * t160;
            let t165 = k3 + k16 * (t164 - t21 * (t148 + t109 * t0)) + t52 * t147;
            let t166 = k14 * t146;
            let t167 = t87 * (t85 * t146 - t33 * (t166 + k15 * t158) - t107 * t91);
            let t168 = k16 * (t161 - t107 * t127 - t54 * t163) + t52 * t146 + t167;
            let t169 = k14 * t109;
            let t170 = t84 * t147 + t31 * (t166 + k16 * t158) - t66 * t107
                - t26 * (t169 - k16 * t162);
            let t171 = t90 * (t147 * t77 - t65 * t109 - t38 * (t169 - k15 * t162));
            let t172 = t165 + t31 * t156 + t87 * t170 + t171 - k18 * sin_q2 - t58 * t109;
            let t173 = t168 + t90 * t170 - t33 * t156 - t58 * t107 - t26 * t157;
            let t174 = t172 - t38 * t157;
            let t175 = t76 * t173 - t86 * t174;
            let t176 = t89 * t174 - t86 * t173;
            let t177 = t33 * t36;
            let t178 = t31 * t36;
            let t179 = t26 * t41;
            let t180 = t8 * t5 + t16 * t179 - t15 * t177;
            let t181 = t11 * t5 + t19 * t179 - t18 * t177;
            let t182 = t38 * t41;
            let t183 = t10 * t6 - t18 * t178 - t19 * t182;
            let t184 = t7 * t6 - t15 * t178 - t16 * t182;
            let t185 = t23 * (t16 * t180 + t19 * t181);
            let t186 = t23 * (t18 * t181 + t15 * t180);
            let t187 = t23 * (t19 * t183 + t16 * t184);
            let t188 = t23 * (t18 * t183 + t15 * t184);
            let t189 = k14 * t185;
            let t190 = k4 + k16 * (t51 * (t33 * t5 - t177) - t50 * t185) + t33 * t189;
            let t191 = k16 * (t21 * t179 - t61 * t186 - t158 * t5) - t31 * t189;
            let t192 = k14 * t186;
            let t193 = t190 - t26 * t192;
            let t194 = t191 - t38 * t192;
            let t195 = t76 * t193 - t86 * t194;
            let t196 = t89 * t194 - t86 * t193;
            let t197 = k14 * t188;
            let t198 = k16 * (t50 * t187 + t132 * t6 + t51 * t178) + t26 * t197;
            let t199 = k14 * t187;
            let t200 = k4 + k16 * (t61 * t188 + t21 * (t182 + t38 * t6)) + t31 * t199;
            let t201 = t198 - t33 * t199;
            let t202 = t200 + t38 * t197;
            let t203 = t76 * t201 - t86 * t202;
            let t204 = t89 * t202 - t86 * t201;
            (
                ::pendulum_core::nalgebra::SVector::from([qd_q1, qd_q2, t87, t90]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [T::from_f64(0.0), T::from_f64(0.0), t142, t143],
                    [T::from_f64(0.0), T::from_f64(0.0), t175, t176],
                    [T::from_f64(1.0), T::from_f64(0.0), t195, t196],
                    [T::from_f64(0.0), T::from_f64(1.0), t203, t204],
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
            let [q_q1, q_q2, _, _] = x.data.0[0];
            let k0 = self.constants[0];
            let k2 = self.constants[2];
            let k5 = self.constants[5];
            let k6 = self.constants[6];
            let k7 = self.constants[7];
            let k8 = self.constants[8];
            let k9 = self.constants[9];
            let k11 = self.constants[11];
            let k30 = self.constants[30];
            let k31 = self.constants[31];
            let k34 = self.constants[34];
            let k35 = self.constants[35];
            let [(_, cos0), (sin1, _)] = (k5 * t).sin_cos_pair(k6 * t);
            let t2 = k34 * cos0;
            let t3 = k35 * sin1;
            let [(sin_q1, cos_q1), (sin_q2, cos_q2)] = q_q1.sin_cos_pair(q_q2);
            let t4 = k11 * cos_q1 * cos_q1;
            let t5 = k0 * cos_q2;
            let t6 = k0 * cos_q1;
            let t7 = k2 + t5 - t6;
            let t8 = k0 * sin_q1;
            let t9 = k0 * sin_q2;
            let t10 = k11 * cos_q2 * cos_q2;
            let t11 = t8 - t9;
            let t12 = t7 * t7 + t11 * t11;
            let t13 = (k7 * (T::from_f64(1.0) / t12) - T::from_f64(0.25)).sqrt();
            let t14 = T::from_f64(1.0) / (t12 * t13);
            let t15 = t7 * t13 - T::from_f64(0.5) * t11;
            let t16 = T::from_f64(0.5) * t7 + t11 * t13;
            let t17 = t7 - t16;
            let t18 = t11 + t15;
            let t19 = t14 * (t6 * t15 - t8 * t16);
            let t20 = k30 * t17;
            let t21 = k9 * t20 * t20;
            let t22 = t21 + (k9 - t21);
            let t23 = k8 * t5 * t20 - k31 * t9 * t18;
            let t24 = t19 * t22;
            let t25 = k30 * t16;
            let t26 = t14 * (t9 * t16 - t5 * t15);
            let t27 = t14 * (t9 * t17 + t5 * t18);
            let t28 = t14 * (t8 * t17 + t6 * t18);
            let t29 = k8 * t6 * t25 + k31 * t8 * t15;
            let t30 = k9 * t25 * t25;
            let t31 = t30 + (k9 - t30);
            let t32 = t31 - (t31 + t29);
            let t33 = t32 + t31 * t28;
            let t34 = k11 + t4 + t19 * t24 + T::from_f64(2.0) * t29 + t28 * (t32 + t33);
            let t35 = t34 + t32 + t32 - t4;
            let t36 = t22 - (t22 - t23);
            let t37 = t19 * t36 + t24 * t26 - t33 * t27;
            let t38 = k11 + t10 + t31 * t27 * t27 + t26 * (t36 + (t36 + t22 * t26));
            let t39 = t38 + t36 + t36 - t10 - T::from_f64(2.0) * t23;
            let t40 = T::from_f64(-1.0) / (t35 * t39 - t37 * t37);
            ::pendulum_core::nalgebra::SVector::from([
                T::from_f64(0.0),
                T::from_f64(0.0),
                -(t40 * (t39 * t2 + t37 * t3)),
                t40 * (t37 * t2 + t35 * t3),
            ])
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Energy<T, 4> for FiveBar<T> {
        #[inline]
        fn kinetic(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 4>) -> T {
            let [q_q1, q_q2, qd_q1, qd_q2] = x.data.0[0];
            let k0 = self.constants[0];
            let k2 = self.constants[2];
            let k7 = self.constants[7];
            let k16 = self.constants[16];
            let k19 = self.constants[19];
            let k29 = self.constants[29];
            let k30 = self.constants[30];
            let [(sin_q2, cos_q2), (sin_q1, cos_q1)] = q_q2.sin_cos_pair(q_q1);
            let t0 = k0 * cos_q2;
            let t1 = k0 * cos_q1;
            let t2 = k2 + t0 - t1;
            let t3 = k0 * sin_q2;
            let t4 = k0 * sin_q1;
            let t5 = t3 - t4;
            let t6 = t2 * t2 + t5 * t5;
            let t7 = (k7 * (T::from_f64(1.0) / t6) - T::from_f64(0.25)).sqrt();
            let t8 = T::from_f64(1.0) / (t6 * t7);
            let t9 = T::from_f64(0.5) * t2 - t7 * t5;
            let t10 = T::from_f64(0.5) * t5 + t2 * t7;
            let t11 = t2 - t9;
            let t12 = t5 - t10;
            let t13 = qd_q2 * (t3 * t11 - t0 * t12) - qd_q1 * (t4 * t11 - t1 * t12);
            let t14 = qd_q1 * (t1 * t10 - t4 * t9) + qd_q2 * (t3 * t9 - t0 * t10);
            let t15 = t8 * t13;
            let t16 = k19 * qd_q1 + k16 * t15 * (k30 * (cos_q1 * t9 + sin_q1 * t10));
            let t17 = t8 * t14;
            let t18 = k19 * qd_q2 + k16 * t17 * (k30 * (cos_q2 * t11 + sin_q2 * t12));
            k29 * (t15 * t15 + t17 * t17) + qd_q2 * t18 + qd_q1 * t16
        }
        #[inline]
        fn potential(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 4>) -> T {
            let [q_q1, q_q2, _, _] = x.data.0[0];
            let k0 = self.constants[0];
            let k2 = self.constants[2];
            let k7 = self.constants[7];
            let k18 = self.constants[18];
            let k36 = self.constants[36];
            let [(sin_q1, cos_q1), (sin_q2, cos_q2)] = q_q1.sin_cos_pair(q_q2);
            let t0 = k0 * (sin_q2 - sin_q1);
            let t1 = k2 + k0 * (cos_q2 - cos_q1);
            let t2 = t1
                * (k7 * (T::from_f64(1.0) / (t1 * t1 + t0 * t0)) - T::from_f64(0.25))
                    .sqrt();
            let t3 = T::from_f64(0.5) * t0 + t2;
            k18 * (sin_q1 + sin_q2) + k36 * (t3 - (t0 - t3))
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> FiveBar<T> {
        ///How far each closed loop is from its toggle, in the order of the declaration: 0 there, and at most 1. And the rates of that.
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        pub fn loop_margins(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 1>,
            ::pendulum_core::nalgebra::SVector<T, 1>,
        ) {
            let [q_q1, q_q2, qd_q1, qd_q2] = x.data.0[0];
            let k0 = self.constants[0];
            let k2 = self.constants[2];
            let k7 = self.constants[7];
            let k10 = self.constants[10];
            let k32 = self.constants[32];
            let k33 = self.constants[33];
            let [(sin_q2, cos_q2), (sin_q1, cos_q1)] = q_q2.sin_cos_pair(q_q1);
            let t0 = k0 * cos_q2;
            let t1 = k0 * cos_q1;
            let t2 = k2 + t0 - t1;
            let t3 = k0 * sin_q2;
            let t4 = k0 * sin_q1;
            let t5 = t3 - t4;
            let t6 = T::from_f64(2.0) * t2 * (t4 * qd_q1 - t3 * qd_q2)
                + T::from_f64(2.0) * t5 * (t0 * qd_q2 - t1 * qd_q1);
            let t7 = t2 * t2 + t5 * t5;
            let t8 = (k7 * (T::from_f64(1.0) / t7) - T::from_f64(0.25)).sqrt();
            let t9 = t8 * t6
                - k33 * t7 * t6 * (T::from_f64(1.0) / (t7 * t7))
                    * (T::from_f64(1.0) / t8);
            (
                ::pendulum_core::nalgebra::SVector::from([t7 * t8 / k10]),
                ::pendulum_core::nalgebra::SVector::from([k32 * t9]),
            )
        }
        ///Output `hand`.
        #[inline]
        pub fn hand(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 2> {
            let [q_q1, q_q2, _, _] = x.data.0[0];
            let k0 = self.constants[0];
            let k2 = self.constants[2];
            let k7 = self.constants[7];
            let k37 = self.constants[37];
            let [(sin_q1, cos_q1), (sin_q2, cos_q2)] = q_q1.sin_cos_pair(q_q2);
            let t0 = k0 * cos_q1;
            let t1 = k2 + k0 * cos_q2 - t0;
            let t2 = k0 * sin_q1;
            let t3 = t2 - k0 * sin_q2;
            let t4 = (k7 * (T::from_f64(1.0) / (t1 * t1 + t3 * t3)) - T::from_f64(0.25))
                .sqrt();
            ::pendulum_core::nalgebra::SVector::from([
                t0 + k37 * (T::from_f64(0.5) * t1 + t3 * t4),
                t2 + k37 * (t1 * t4 - T::from_f64(0.5) * t3),
            ])
        }
        ///The rate of `hand` along the motion.
        #[inline]
        pub fn hand_rate(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 2> {
            let [q_q1, q_q2, qd_q1, qd_q2] = x.data.0[0];
            let k0 = self.constants[0];
            let k1 = self.constants[1];
            let k2 = self.constants[2];
            let k7 = self.constants[7];
            let k30 = self.constants[30];
            let t0 = k0 * qd_q1;
            let [(sin_q1, cos_q1), (sin_q2, cos_q2)] = q_q1.sin_cos_pair(q_q2);
            let t1 = k0 * sin_q2;
            let t2 = k0 * sin_q1;
            let t3 = t1 - t2;
            let t4 = k0 * cos_q2;
            let t5 = k0 * cos_q1;
            let t6 = k2 + t4 - t5;
            let t7 = t6 * t6 + t3 * t3;
            let t8 = (k7 * (T::from_f64(1.0) / t7) - T::from_f64(0.25)).sqrt();
            let t9 = T::from_f64(0.5) * t3 + t6 * t8;
            let t10 = t9 - t3;
            let t11 = T::from_f64(0.5) * t6 - t8 * t3;
            let t12 = t6 - t11;
            let t13 = qd_q2 * (t1 * t12 + t4 * t10) - qd_q1 * (t2 * t12 + t5 * t10);
            let t14 = k30 * (k1 * (T::from_f64(1.0) / (t7 * t8) * t13));
            ::pendulum_core::nalgebra::SVector::from([
                -(sin_q1 * t0 + t9 * t14),
                cos_q1 * t0 + t11 * t14,
            ])
        }
        ///The value of `hand`, and its derivatives by the state: a row for each component, column by column for a matrix.
        #[inline]
        pub fn hand_and_jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 2>,
            ::pendulum_core::nalgebra::SMatrix<T, 2, 4>,
        ) {
            let [q_q1, q_q2, _, _] = x.data.0[0];
            let k0 = self.constants[0];
            let k1 = self.constants[1];
            let k2 = self.constants[2];
            let k7 = self.constants[7];
            let k30 = self.constants[30];
            let [(sin_q1, cos_q1), (sin_q2, cos_q2)] = q_q1.sin_cos_pair(q_q2);
            let t0 = k0 * cos_q1;
            let t1 = k0 * cos_q2;
            let t2 = k2 + t1 - t0;
            let t3 = k0 * sin_q1;
            let t4 = k0 * sin_q2;
            let t5 = t3 - t4;
            let t6 = t2 * t2 + t5 * t5;
            let t7 = (k7 * (T::from_f64(1.0) / t6) - T::from_f64(0.25)).sqrt();
            let t8 = T::from_f64(1.0) / (t6 * t7);
            let t9 = T::from_f64(0.5) * t2 + t5 * t7;
            let t10 = t2 * t7 - T::from_f64(0.5) * t5;
            let t11 = t2 - t9;
            let t12 = k1 * (k30 * t9);
            let t13 = t0 + t12;
            let t14 = t5 + t10;
            let t15 = t8 * (t4 * t11 + t1 * t14);
            let t16 = t8 * (t3 * t11 + t0 * t14);
            let t17 = t0 - t12 * t16;
            let t18 = t12 * t15;
            let t19 = k1 * (k30 * t10);
            let t20 = t19 * t16 - t3;
            let t21 = t3 + t19;
            let t22 = -(t19 * t15);
            (
                ::pendulum_core::nalgebra::SVector::from([t13, t21]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [t20, t17],
                    [t22, t18],
                    [T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0)],
                ]),
            )
        }
        ///Output `gap`.
        #[inline]
        pub fn gap(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 2> {
            let [q_q1, q_q2, _, _] = x.data.0[0];
            let k0 = self.constants[0];
            let k2 = self.constants[2];
            let k7 = self.constants[7];
            let k37 = self.constants[37];
            let [(sin_q2, cos_q2), (sin_q1, cos_q1)] = q_q2.sin_cos_pair(q_q1);
            let t0 = k0 * cos_q2 - (k0 * cos_q1 - k2);
            let t1 = k0 * sin_q1 - k0 * sin_q2;
            let t2 = (k7 * (T::from_f64(1.0) / (t0 * t0 + t1 * t1)) - T::from_f64(0.25))
                .sqrt();
            let t3 = T::from_f64(0.5) * t0 + t1 * t2;
            let t4 = t0 * t2 - T::from_f64(0.5) * t1;
            ::pendulum_core::nalgebra::SVector::from([
                k37 * (t3 + (t0 - t3)) - t0,
                t1 + k37 * (t4 - (t1 + t4)),
            ])
        }
        ///The rate of `gap` along the motion.
        #[inline]
        pub fn gap_rate(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 2> {
            let [q_q1, q_q2, qd_q1, qd_q2] = x.data.0[0];
            let k0 = self.constants[0];
            let k2 = self.constants[2];
            let k7 = self.constants[7];
            let k37 = self.constants[37];
            let [(sin_q2, cos_q2), (sin_q1, cos_q1)] = q_q2.sin_cos_pair(q_q1);
            let t0 = k0 * sin_q2;
            let t1 = k0 * sin_q1;
            let t2 = t0 - t1;
            let t3 = k0 * cos_q2;
            let t4 = k0 * cos_q1;
            let t5 = k2 + t3 - t4;
            let t6 = t5 * t5 + t2 * t2;
            let t7 = (k7 * (T::from_f64(1.0) / t6) - T::from_f64(0.25)).sqrt();
            let t8 = T::from_f64(1.0) / (t6 * t7);
            let t9 = T::from_f64(0.5) * t2 + t5 * t7;
            let t10 = T::from_f64(0.5) * t5 - t7 * t2;
            let t11 = t2 - t9;
            let t12 = qd_q1 * (t4 * t9 - t1 * t10) + qd_q2 * (t0 * t10 - t3 * t9);
            let t13 = t5 - t10;
            let t14 = qd_q2 * (t0 * t13 - t3 * t11) - qd_q1 * (t1 * t13 - t4 * t11);
            let t15 = t8 * t12;
            let t16 = t8 * t14;
            ::pendulum_core::nalgebra::SVector::from([
                k0 * (qd_q2 * sin_q2 - sin_q1 * qd_q1) + k37 * (t11 * t15 - t9 * t16),
                k0 * (cos_q1 * qd_q1 - qd_q2 * cos_q2) + k37 * (t10 * t16 - t15 * t13),
            ])
        }
        ///The value of `gap`, and its derivatives by the state: a row for each component, column by column for a matrix.
        #[inline]
        pub fn gap_and_jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 2>,
            ::pendulum_core::nalgebra::SMatrix<T, 2, 4>,
        ) {
            let [q_q1, q_q2, _, _] = x.data.0[0];
            let k0 = self.constants[0];
            let k1 = self.constants[1];
            let k2 = self.constants[2];
            let k7 = self.constants[7];
            let k30 = self.constants[30];
            let [(sin_q2, cos_q2), (sin_q1, cos_q1)] = q_q2.sin_cos_pair(q_q1);
            let t0 = k0 * cos_q2;
            let t1 = k0 * cos_q1;
            let t2 = t0 - (t1 - k2);
            let t3 = k0 * sin_q1;
            let t4 = k0 * sin_q2;
            let t5 = t3 - t4;
            let t6 = t2 * t2 + t5 * t5;
            let t7 = (k7 * (T::from_f64(1.0) / t6) - T::from_f64(0.25)).sqrt();
            let t8 = T::from_f64(1.0) / (t6 * t7);
            let t9 = T::from_f64(0.5) * t2 + t5 * t7;
            let t10 = t2 * t7 - T::from_f64(0.5) * t5;
            let t11 = k1 * (k30 * t9);
            let t12 = t2 - t9;
            let t13 = k1 * (k30 * t12);
            let t14 = t11 + t13 - t2;
            let t15 = k1 * (k30 * t10);
            let t16 = t5 + t10;
            let t17 = k1 * (k30 * t16);
            let t18 = t5 + t15 - t17;
            let t19 = t8 * (t3 * t12 + t1 * t16);
            let t20 = t8 * (t4 * t12 + t0 * t16);
            let t21 = t8 * (t1 * t10 - t3 * t9);
            let t22 = t8 * (t4 * t9 - t0 * t10);
            let t23 = t15 * t19 - t3 - t17 * t21;
            let t24 = t1 - t11 * t19 - t13 * t21;
            let t25 = t4 - t17 * t22 - t15 * t20;
            let t26 = t11 * t20 - t0 - t13 * t22;
            (
                ::pendulum_core::nalgebra::SVector::from([t14, t18]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [t23, t24],
                    [t25, t26],
                    [T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0)],
                ]),
            )
        }
        ///All outputs, in the order of `OUTPUTS`.
        #[inline]
        pub fn outputs(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 4> {
            let [q_q1, q_q2, _, _] = x.data.0[0];
            let k0 = self.constants[0];
            let k2 = self.constants[2];
            let k7 = self.constants[7];
            let k37 = self.constants[37];
            let [(sin_q1, cos_q1), (sin_q2, cos_q2)] = q_q1.sin_cos_pair(q_q2);
            let t0 = k0 * cos_q1;
            let t1 = k2 + k0 * cos_q2;
            let t2 = t1 - t0;
            let t3 = k0 * sin_q1;
            let t4 = k0 * sin_q2;
            let t5 = t3 - t4;
            let t6 = (k7 * (T::from_f64(1.0) / (t2 * t2 + t5 * t5)) - T::from_f64(0.25))
                .sqrt();
            let t7 = T::from_f64(0.5) * t2 + t5 * t6;
            let t8 = t2 * t6 - T::from_f64(0.5) * t5;
            let t9 = t0 + k37 * t7;
            let t10 = t3 + k37 * t8;
            ::pendulum_core::nalgebra::SVector::from([
                t9,
                t10,
                t9 + k37 * (t2 - t7) - t1,
                t10 - t4 - k37 * (t5 + t8),
            ])
        }
        ///The rate of all outputs along the motion.
        #[inline]
        pub fn output_rates(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 4> {
            let [q_q1, q_q2, qd_q1, qd_q2] = x.data.0[0];
            let k0 = self.constants[0];
            let k1 = self.constants[1];
            let k2 = self.constants[2];
            let k7 = self.constants[7];
            let k30 = self.constants[30];
            let t0 = k0 * qd_q1;
            let [(sin_q1, cos_q1), (sin_q2, cos_q2)] = q_q1.sin_cos_pair(q_q2);
            let t1 = k0 * sin_q2;
            let t2 = k0 * sin_q1;
            let t3 = t1 - t2;
            let t4 = k0 * cos_q2;
            let t5 = k0 * cos_q1;
            let t6 = k2 + t4 - t5;
            let t7 = t6 * t6 + t3 * t3;
            let t8 = (k7 * (T::from_f64(1.0) / t7) - T::from_f64(0.25)).sqrt();
            let t9 = T::from_f64(1.0) / (t7 * t8);
            let t10 = T::from_f64(0.5) * t3 + t6 * t8;
            let t11 = T::from_f64(0.5) * t6 - t8 * t3;
            let t12 = t6 - t11;
            let t13 = t3 - t10;
            let t14 = qd_q2 * t9;
            let t15 = qd_q1 * t9;
            let t16 = (t1 * t12 - t4 * t13) * t14 - (t2 * t12 - t5 * t13) * t15;
            let t17 = (t5 * t10 - t2 * t11) * t15 + (t1 * t11 - t4 * t10) * t14;
            let t18 = k30 * (k1 * t16);
            let t19 = sin_q1 * t0 + t10 * t18;
            let t20 = cos_q1 * t0 + t11 * t18;
            let t21 = k30 * (k1 * t17);
            ::pendulum_core::nalgebra::SVector::from([
                -t19,
                t20,
                t1 * qd_q2 + t13 * t21 - t19,
                t20 - t4 * qd_q2 - t12 * t21,
            ])
        }
        ///The value of all outputs, and its derivatives by the state: a row for each component, column by column for a matrix.
        #[inline]
        pub fn outputs_and_jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 4>,
            ::pendulum_core::nalgebra::SMatrix<T, 4, 4>,
        ) {
            let [q_q1, q_q2, _, _] = x.data.0[0];
            let k0 = self.constants[0];
            let k1 = self.constants[1];
            let k2 = self.constants[2];
            let k7 = self.constants[7];
            let k30 = self.constants[30];
            let [(sin_q1, cos_q1), (sin_q2, cos_q2)] = q_q1.sin_cos_pair(q_q2);
            let t0 = k0 * cos_q1;
            let t1 = k0 * cos_q2;
            let t2 = k2 + t1;
            let t3 = t2 - t0;
            let t4 = k0 * sin_q1;
            let t5 = k0 * sin_q2;
            let t6 = t4 - t5;
            let t7 = t3 * t3 + t6 * t6;
            let t8 = (k7 * (T::from_f64(1.0) / t7) - T::from_f64(0.25)).sqrt();
            let t9 = T::from_f64(1.0) / (t7 * t8);
            let t10 = T::from_f64(0.5) * t3 + t6 * t8;
            let t11 = t3 * t8 - T::from_f64(0.5) * t6;
            let t12 = t3 - t10;
            let t13 = t6 + t11;
            let t14 = k1 * (k30 * t10);
            let t15 = t0 + t14;
            let t16 = k1 * (k30 * t11);
            let t17 = t4 + t16;
            let t18 = k1 * (k30 * t12);
            let t19 = t15 + t18 - t2;
            let t20 = k1 * (k30 * t13);
            let t21 = t17 - t5 - t20;
            let t22 = t9 * (t4 * t12 + t0 * t13);
            let t23 = t9 * (t5 * t12 + t1 * t13);
            let t24 = t16 * t22;
            let t25 = t24 - t4;
            let t26 = t0 - t14 * t22;
            let t27 = t9 * (t0 * t11 - t4 * t10);
            let t28 = -(t20 * t27 + (t4 - t24));
            let t29 = t26 - t18 * t27;
            let t30 = t9 * (t5 * t10 - t1 * t11);
            let t31 = t16 * t23;
            let t32 = t5 - t31 - t20 * t30;
            let t33 = -t31;
            let t34 = t14 * t23;
            let t35 = t34 - t1 - t18 * t30;
            (
                ::pendulum_core::nalgebra::SVector::from([t15, t17, t19, t21]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [t25, t26, t28, t29],
                    [t33, t34, t32, t35],
                    [
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
                    ],
                ]),
            )
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::shapes::Shapes<4> for FiveBar {
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
                        name: "left_crank",
                        kind: ::pendulum_core::shapes::ShapeKind::Rod,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "right_crank",
                        kind: ::pendulum_core::shapes::ShapeKind::Rod,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "left_bar",
                        kind: ::pendulum_core::shapes::ShapeKind::Rod,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "right_bar",
                        kind: ::pendulum_core::shapes::ShapeKind::Rod,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "left_crank",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "right_crank",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "left_bar",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "right_bar",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "left_bar",
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
                    ::pendulum_core::shapes::Outline {
                        name: "other",
                        kind: ::pendulum_core::shapes::ShapeKind::Point,
                        points: 1,
                        radius: false,
                    },
                ],
                &{
                    let [q_q1, q_q2, _, _] = x.data.0[0];
                    let k0 = self.constants[0];
                    let k2 = self.constants[2];
                    let k7 = self.constants[7];
                    let k37 = self.constants[37];
                    let [(sin_q1, cos_q1), (sin_q2, cos_q2)] = q_q1.sin_cos_pair(q_q2);
                    let t0 = k0 * cos_q1;
                    let t1 = k0 * sin_q1;
                    let t2 = k2 + k0 * cos_q2;
                    let t3 = k0 * sin_q2;
                    let t4 = t2 - t0;
                    let t5 = t1 - t3;
                    let t6 = (k7 * (T::from_f64(1.0) / (t4 * t4 + t5 * t5))
                        - T::from_f64(0.25))
                        .sqrt();
                    let t7 = T::from_f64(0.5) * t4 + t5 * t6;
                    let t8 = t0 + k37 * t7;
                    let t9 = t2 - k37 * (t4 - t7);
                    let t10 = t4 * t6 - T::from_f64(0.5) * t5;
                    let t11 = t3 + k37 * (t5 + t10);
                    let t12 = t1 + k37 * t10;
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t0,
                        t1,
                        T::from_f64(0.0),
                        k2,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t2,
                        t3,
                        T::from_f64(0.0),
                        t0,
                        t1,
                        T::from_f64(0.0),
                        t8,
                        t12,
                        T::from_f64(0.0),
                        t2,
                        t3,
                        T::from_f64(0.0),
                        t9,
                        t11,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        k2,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t0,
                        t1,
                        T::from_f64(0.0),
                        t2,
                        t3,
                        T::from_f64(0.0),
                        t8,
                        t12,
                        T::from_f64(0.0),
                        t8,
                        t12,
                        T::from_f64(0.0),
                        t9,
                        t11,
                        T::from_f64(0.0),
                    ]
                },
            )
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::CastJacobian<4> for FiveBar {
        #[inline]
        fn with_jacobian<T: ::pendulum_core::real::Real>(
            model: &FiveBar<T>,
        ) -> &impl ::pendulum_core::Jacobian<T, 4> {
            model
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::Cast<4> for FiveBar {
        type In<T: ::pendulum_core::real::Real> = FiveBar<T>;
        fn cast<T: ::pendulum_core::real::Real>(&self) -> FiveBar<T> {
            FiveBar::cast(self)
        }
        #[inline]
        fn gather<'m, T: ::pendulum_core::real::lanes::Lanes>(
            models: impl ::core::ops::Fn(usize) -> &'m Self,
        ) -> FiveBar<T>
        where
            Self: 'm,
        {
            let scalar = <<T as ::pendulum_core::real::lanes::Lanes>::Scalar as ::pendulum_core::real::Real>::from_f64;
            FiveBar {
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
pub use __FiveBar::{FiveBar, FiveBarParams};
