#[allow(non_snake_case)]
mod __Squeezer {
    ///Parameters of [`Squeezer`].
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct SqueezerParams {}
    impl ::core::default::Default for SqueezerParams {
        #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
        fn default() -> Self {
            Self {}
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl SqueezerParams {
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
    /// As published: the names of the angles are those of the test set.
    ///
    /**# Equations of motion

```text
A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q all other forces

A[beta, beta] = 3011821/1250000000000 + 401690073/500000000000000*slope_angle_k5_beta^2
    + 401690073/500000000000000*slope_angle_k7_beta^2 + 204387/62500000000*slope_angle_k5_beta*slope_angle_k4_beta*t37
    + 646805897/40000000000000*slope_angle_k3_beta^2 + 8306967/125000000000*slope_angle_k4_beta^2
    + 3981529833/100000000000000*slope_angle_k6_beta^2 + 73897/80000000000*slope_angle_k2_beta^2
    - 204387/62500000000*slope_angle_k7_beta*slope_angle_k6_beta*t39 - 11753/20000000000*slope_angle_k2_beta*t35
b[beta] = 401690073/500000000000000*slope_angle_k5_beta*drift_angle_k5
    + 401690073/500000000000000*slope_angle_k7_beta*drift_angle_k7
    + 73897/80000000000*slope_angle_k2_beta*drift_angle_k2 + 646805897/40000000000000*slope_angle_k3_beta*drift_angle_k3
    + 8306967/125000000000*slope_angle_k4_beta*drift_angle_k4
    + 3981529833/100000000000000*slope_angle_k6_beta*drift_angle_k6
    + 11753/40000000000*dot(beta)^2*slope_angle_k2_beta*t36
    + 204387/125000000000*dot(angle_k5)^2*slope_angle_k4_beta*t38
    + 204387/125000000000*slope_angle_k5_beta*drift_angle_k4*t37
    + 204387/125000000000*slope_angle_k4_beta*drift_angle_k5*t37
    + 204387/125000000000*dot(angle_k6)^2*slope_angle_k7_beta*t40 - 11753/40000000000*drift_angle_k2*t35
    - 11753/40000000000*dot(angle_k2)^2*t36 - 204387/125000000000*dot(angle_k4)^2*slope_angle_k5_beta*t38
    - 204387/125000000000*dot(angle_k7)^2*slope_angle_k6_beta*t40
    - 204387/125000000000*slope_angle_k7_beta*drift_angle_k6*t39
    - 204387/125000000000*slope_angle_k6_beta*drift_angle_k7*t39
Q[beta] = 7.663401*slope_angle_k3_beta*t34 + 10584752247/480125540*slope_angle_k3_beta*t33*t41*t42
    - 1.3596342*slope_angle_k3_beta*t33 - 11931915357/96025108*slope_angle_k3_beta*t34*t41*t42 + 0.033

where
c_beta = cos(beta)
t0 = 0.03635 + 0.007*c_beta
s_beta = sin(beta)
t1 = 0.007*s_beta - 0.03273
t2 = 0.0024415754 + 0.0005089*c_beta - 0.00045822*s_beta
t3 = 0.5 - 0.0002205/t2
t4 = sqrt(0.000784/t2 - t3^2)
t5 = t1*t4 - t0*t3
t6 = t1*t3 + t0*t4
angle_k2 = atan2(250/7*t6, -250/7*t5)
t7 = t0*t3 - t1*t4
t9 = t6 - t1
angle_k3 = atan2(200/7*(t0 - t7), 200/7*t9)
t8 = t7 - t0
slope_angle_k2_beta = -(0.007*s_beta*t8 + 0.007*c_beta*(t1 - t6))/(t2*t4)
dot(angle_k2) = dot(beta)*slope_angle_k2_beta
slope_angle_k3_beta = (0.007*s_beta*t5 + 0.007*c_beta*t6)/(t2*t4)
dot(angle_k3) = dot(beta)*slope_angle_k3_beta
t10 = 0.007*dot(beta)^2*c_beta + t5*dot(angle_k2)^2 + t8*dot(angle_k3)^2
t11 = t6*dot(angle_k2)^2 - 0.007*dot(beta)^2*s_beta - t9*dot(angle_k3)^2
drift_angle_k2 = -(t8*t10 + (t1 - t6)*t11)/(t2*t4)
drift_angle_k3 = (t5*t10 + t6*t11)/(t2*t4)
t12 = 0.06934 + 0.007*c_beta - 0.028*cos(angle_k2)
t13 = 0.00227 + 0.007*s_beta - 0.028*sin(angle_k2)
t14 = t12^2 + t13^2
t15 = 0.5 - 0.0006/t14
t16 = sqrt(0.0004/t14 - t15^2)
t17 = t12*t15 + t13*t16
t18 = t12*t16 - t13*t15
angle_k5 = atan2(50*t17, 50*t18)
t19 = t13*t15 - t12*t16
t20 = t17 - t12
angle_k4 = atan2(-25*(t19 - t13), -25*t20)
t21 = 0.028*slope_angle_k2_beta*sin(angle_k2) - 0.007*s_beta
t22 = 0.007*c_beta - 0.028*slope_angle_k2_beta*cos(angle_k2)
slope_angle_k5_beta = -(t20*t21 - (t13 - t19)*t22)/(t14*t16)
dot(angle_k5) = dot(beta)*slope_angle_k5_beta
slope_angle_k4_beta = -(t17*t21 + t19*t22)/(t14*t16)
dot(angle_k4) = dot(beta)*slope_angle_k4_beta
t23 = 0.028*drift_angle_k2*sin(angle_k2) + 0.028*dot(angle_k2)^2*cos(angle_k2) - 0.007*dot(beta)^2*c_beta
t25 = t23 + t17*dot(angle_k5)^2 - t20*dot(angle_k4)^2
t24 = 0.028*dot(angle_k2)^2*sin(angle_k2) - 0.028*drift_angle_k2*cos(angle_k2) - 0.007*dot(beta)^2*s_beta
t26 = t24 - t18*dot(angle_k5)^2 - (t19 - t13)*dot(angle_k4)^2
drift_angle_k5 = -(t20*t25 - (t13 - t19)*t26)/(t14*t16)
drift_angle_k4 = -(t17*t25 + t19*t26)/(t14*t16)
t27 = t13*t16 - t12*t15
t28 = t13*t15 + t12*t16
angle_k7 = atan2(50*t28, -50*t27)
t29 = t12*t15 - t13*t16
angle_k6 = atan2(25*(t12 - t29), 25*(t28 - t13))
t30 = t29 - t12
slope_angle_k7_beta = (t21*t30 - t22*(t13 - t28))/(t14*t16)
dot(angle_k7) = dot(beta)*slope_angle_k7_beta
slope_angle_k6_beta = -(t21*t27 - t22*t28)/(t14*t16)
dot(angle_k6) = dot(beta)*slope_angle_k6_beta
t31 = t23 - t27*dot(angle_k7)^2 - t30*dot(angle_k6)^2
t32 = t24 + t28*dot(angle_k7)^2 - (t28 - t13)*dot(angle_k6)^2
drift_angle_k7 = (t30*t31 - (t13 - t28)*t32)/(t14*t16)
drift_angle_k6 = -(t27*t31 - t28*t32)/(t14*t16)
t33 = sin(angle_k3)
t34 = cos(angle_k3)
t35 = cos(beta - angle_k2)
t36 = sin(beta - angle_k2)
t37 = sin(angle_k5 - angle_k4)
t38 = cos(angle_k5 - angle_k4)
t39 = sin(angle_k7 - angle_k6)
t40 = cos(angle_k7 - angle_k6)
t41 = sqrt(0.0048012554 - 0.0033834*t33 - 0.00060028*t34)
t42 = 1/(1 - 16917000/24006277*t33 - 3001400/24006277*t34)
```
*/
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Squeezer<T = f64> {
        params: SqueezerParams,
        constants: [T; 0],
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl Squeezer {
        /// Builds the model: checks the parameters, and computes once whatever depends on them alone.
        ///
        /// # Errors
        ///
        /// The first parameter, or combination of parameters, that is not finite or that no rigid body can
        /// have.
        pub fn new(
            params: SqueezerParams,
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
            for (name, value) in SqueezerParams::NAMES.into_iter().zip(given) {
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
                        SqueezerParams::NAMES[n],
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
        pub fn cast<T: ::pendulum_core::real::Real>(&self) -> Squeezer<T> {
            Squeezer {
                params: self.params,
                constants: self.constants.map(T::from_f64),
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> Squeezer<T> {
        /// The parameters that the model was built from.
        pub fn params(&self) -> &SqueezerParams {
            &self.params
        }
        /// The model with other parameters, in the same number type. Its constants are computed anew.
        ///
        /// # Errors
        ///
        /// Those of `new`.
        pub fn with_params(
            &self,
            params: SqueezerParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            Ok(<Squeezer>::new(params)?.cast())
        }
    }
    impl Squeezer {
        ///The place of `beta` in the state, where it stands in rad.
        pub const BETA: usize = 0;
        ///The place of `dot(beta)` in the state, where it stands in rad/s.
        pub const DOT_BETA: usize = 1;
        /// The number of degrees of freedom; the state has twice as many components.
        pub const DOF: usize = 1;
        /// The names of the coordinates, in the order in which they, and then their rates, stand in the state.
        pub const COORDINATES: [&'static str; 1] = ["beta"];
        /// Counted operations of each generated function, in the form that it has and in others.
        pub const COST: ::pendulum_core::Cost = ::pendulum_core::Cost::new(
            &[
                (
                    "rhs",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, expanded, L^T D L",
                            ::pendulum_core::Operations::new(94, 165, 6, 1, 3, 79),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first, L^T D L",
                                    ::pendulum_core::Operations::new(103, 167, 6, 1, 3, 76),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, L^T D L",
                                    ::pendulum_core::Operations::new(103, 167, 6, 1, 3, 76),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, L^T D L",
                                    ::pendulum_core::Operations::new(154, 190, 6, 1, 3, 83),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C, L^T D L",
                                    ::pendulum_core::Operations::new(225, 243, 6, 1, 3, 82),
                                ),
                            ],
                        ),
                ),
                (
                    "loop_margins",
                    ::pendulum_core::FunctionCost::new(
                        "as declared",
                        ::pendulum_core::Operations::new(26, 57, 7, 1, 2, 59),
                    ),
                ),
                (
                    "jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first, L^T D L, derived in the graph",
                            ::pendulum_core::Operations::new(306, 494, 14, 1, 3, 103),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, L^T D L, derived in the graph",
                                    ::pendulum_core::Operations::new(306, 494, 14, 1, 3, 103),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L, derived in the graph",
                                    ::pendulum_core::Operations::new(322, 540, 14, 1, 3, 109),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, L^T D L, derived in the graph",
                                    ::pendulum_core::Operations::new(474, 627, 14, 1, 3, 116),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C, L^T D L, derived in the graph",
                                    ::pendulum_core::Operations::new(597, 729, 14, 1, 3, 106),
                                ),
                            ],
                        ),
                ),
                (
                    "kinetic",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, expanded",
                            ::pendulum_core::Operations::new(45, 71, 4, 1, 2, 65),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(45, 74, 4, 1, 2, 66),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(45, 74, 4, 1, 2, 66),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(77, 94, 4, 1, 2, 73),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C",
                                    ::pendulum_core::Operations::new(135, 136, 4, 1, 2, 76),
                                ),
                            ],
                        ),
                ),
                (
                    "potential",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(15, 16, 1, 1, 2, 47),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(15, 16, 1, 1, 2, 47),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(15, 16, 1, 1, 2, 47),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C",
                                    ::pendulum_core::Operations::new(16, 19, 1, 1, 2, 50),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(16, 19, 1, 1, 2, 50),
                                ),
                            ],
                        ),
                ),
                (
                    "gap",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(21, 20, 2, 1, 2, 57),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(23, 20, 2, 1, 2, 57),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(23, 20, 2, 1, 2, 57),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(23, 20, 2, 1, 2, 57),
                                ),
                            ],
                        ),
                ),
                (
                    "gap_rate",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(32, 50, 4, 1, 2, 63),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(32, 50, 4, 1, 2, 63),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(32, 50, 4, 1, 2, 63),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "as declared",
                                    ::pendulum_core::Operations::new(32, 50, 4, 1, 2, 64),
                                ),
                            ],
                        ),
                ),
                (
                    "gap_and_jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(33, 42, 4, 1, 2, 64),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(36, 45, 4, 1, 2, 63),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(36, 45, 4, 1, 2, 63),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(36, 45, 4, 1, 2, 63),
                                ),
                            ],
                        ),
                ),
                (
                    "follow",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(32, 24, 2, 1, 7, 66),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(32, 24, 2, 1, 7, 66),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(32, 24, 2, 1, 7, 66),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(32, 24, 2, 1, 7, 66),
                                ),
                            ],
                        ),
                ),
                (
                    "follow_rate",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(29, 38, 4, 1, 2, 60),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(29, 38, 4, 1, 2, 60),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(29, 38, 4, 1, 2, 60),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(29, 38, 4, 1, 2, 60),
                                ),
                            ],
                        ),
                ),
                (
                    "follow_and_jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(46, 44, 4, 1, 7, 66),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(46, 44, 4, 1, 7, 66),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(46, 44, 4, 1, 7, 66),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(46, 44, 4, 1, 7, 66),
                                ),
                            ],
                        ),
                ),
                (
                    "outputs",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(37, 28, 2, 1, 7, 67),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(40, 28, 2, 1, 7, 66),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(40, 28, 2, 1, 7, 66),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(40, 28, 2, 1, 7, 66),
                                ),
                            ],
                        ),
                ),
                (
                    "output_rates",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(41, 60, 4, 1, 2, 63),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(41, 60, 4, 1, 2, 63),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(41, 60, 4, 1, 2, 63),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "as declared",
                                    ::pendulum_core::Operations::new(41, 60, 4, 1, 2, 64),
                                ),
                            ],
                        ),
                ),
                (
                    "outputs_and_jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(58, 59, 4, 1, 7, 67),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(62, 62, 4, 1, 7, 66),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(62, 62, 4, 1, 7, 66),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(62, 62, 4, 1, 7, 66),
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
                            "beta",
                            ::pendulum_core::SlotKind::Angle,
                            0..1,
                            1..2,
                        )
                        .periodic(),
                ],
            )
            .autonomous();
        /// The equations of motion as text.
        pub const EQUATIONS: &'static str = "A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q all other forces\n\nA[beta, beta] = 3011821/1250000000000 + 401690073/500000000000000*slope_angle_k5_beta^2\n    + 401690073/500000000000000*slope_angle_k7_beta^2 + 204387/62500000000*slope_angle_k5_beta*slope_angle_k4_beta*t37\n    + 646805897/40000000000000*slope_angle_k3_beta^2 + 8306967/125000000000*slope_angle_k4_beta^2\n    + 3981529833/100000000000000*slope_angle_k6_beta^2 + 73897/80000000000*slope_angle_k2_beta^2\n    - 204387/62500000000*slope_angle_k7_beta*slope_angle_k6_beta*t39 - 11753/20000000000*slope_angle_k2_beta*t35\nb[beta] = 401690073/500000000000000*slope_angle_k5_beta*drift_angle_k5\n    + 401690073/500000000000000*slope_angle_k7_beta*drift_angle_k7\n    + 73897/80000000000*slope_angle_k2_beta*drift_angle_k2 + 646805897/40000000000000*slope_angle_k3_beta*drift_angle_k3\n    + 8306967/125000000000*slope_angle_k4_beta*drift_angle_k4\n    + 3981529833/100000000000000*slope_angle_k6_beta*drift_angle_k6\n    + 11753/40000000000*dot(beta)^2*slope_angle_k2_beta*t36\n    + 204387/125000000000*dot(angle_k5)^2*slope_angle_k4_beta*t38\n    + 204387/125000000000*slope_angle_k5_beta*drift_angle_k4*t37\n    + 204387/125000000000*slope_angle_k4_beta*drift_angle_k5*t37\n    + 204387/125000000000*dot(angle_k6)^2*slope_angle_k7_beta*t40 - 11753/40000000000*drift_angle_k2*t35\n    - 11753/40000000000*dot(angle_k2)^2*t36 - 204387/125000000000*dot(angle_k4)^2*slope_angle_k5_beta*t38\n    - 204387/125000000000*dot(angle_k7)^2*slope_angle_k6_beta*t40\n    - 204387/125000000000*slope_angle_k7_beta*drift_angle_k6*t39\n    - 204387/125000000000*slope_angle_k6_beta*drift_angle_k7*t39\nQ[beta] = 7.663401*slope_angle_k3_beta*t34 + 10584752247/480125540*slope_angle_k3_beta*t33*t41*t42\n    - 1.3596342*slope_angle_k3_beta*t33 - 11931915357/96025108*slope_angle_k3_beta*t34*t41*t42 + 0.033\n\nwhere\nc_beta = cos(beta)\nt0 = 0.03635 + 0.007*c_beta\ns_beta = sin(beta)\nt1 = 0.007*s_beta - 0.03273\nt2 = 0.0024415754 + 0.0005089*c_beta - 0.00045822*s_beta\nt3 = 0.5 - 0.0002205/t2\nt4 = sqrt(0.000784/t2 - t3^2)\nt5 = t1*t4 - t0*t3\nt6 = t1*t3 + t0*t4\nangle_k2 = atan2(250/7*t6, -250/7*t5)\nt7 = t0*t3 - t1*t4\nt9 = t6 - t1\nangle_k3 = atan2(200/7*(t0 - t7), 200/7*t9)\nt8 = t7 - t0\nslope_angle_k2_beta = -(0.007*s_beta*t8 + 0.007*c_beta*(t1 - t6))/(t2*t4)\ndot(angle_k2) = dot(beta)*slope_angle_k2_beta\nslope_angle_k3_beta = (0.007*s_beta*t5 + 0.007*c_beta*t6)/(t2*t4)\ndot(angle_k3) = dot(beta)*slope_angle_k3_beta\nt10 = 0.007*dot(beta)^2*c_beta + t5*dot(angle_k2)^2 + t8*dot(angle_k3)^2\nt11 = t6*dot(angle_k2)^2 - 0.007*dot(beta)^2*s_beta - t9*dot(angle_k3)^2\ndrift_angle_k2 = -(t8*t10 + (t1 - t6)*t11)/(t2*t4)\ndrift_angle_k3 = (t5*t10 + t6*t11)/(t2*t4)\nt12 = 0.06934 + 0.007*c_beta - 0.028*cos(angle_k2)\nt13 = 0.00227 + 0.007*s_beta - 0.028*sin(angle_k2)\nt14 = t12^2 + t13^2\nt15 = 0.5 - 0.0006/t14\nt16 = sqrt(0.0004/t14 - t15^2)\nt17 = t12*t15 + t13*t16\nt18 = t12*t16 - t13*t15\nangle_k5 = atan2(50*t17, 50*t18)\nt19 = t13*t15 - t12*t16\nt20 = t17 - t12\nangle_k4 = atan2(-25*(t19 - t13), -25*t20)\nt21 = 0.028*slope_angle_k2_beta*sin(angle_k2) - 0.007*s_beta\nt22 = 0.007*c_beta - 0.028*slope_angle_k2_beta*cos(angle_k2)\nslope_angle_k5_beta = -(t20*t21 - (t13 - t19)*t22)/(t14*t16)\ndot(angle_k5) = dot(beta)*slope_angle_k5_beta\nslope_angle_k4_beta = -(t17*t21 + t19*t22)/(t14*t16)\ndot(angle_k4) = dot(beta)*slope_angle_k4_beta\nt23 = 0.028*drift_angle_k2*sin(angle_k2) + 0.028*dot(angle_k2)^2*cos(angle_k2) - 0.007*dot(beta)^2*c_beta\nt25 = t23 + t17*dot(angle_k5)^2 - t20*dot(angle_k4)^2\nt24 = 0.028*dot(angle_k2)^2*sin(angle_k2) - 0.028*drift_angle_k2*cos(angle_k2) - 0.007*dot(beta)^2*s_beta\nt26 = t24 - t18*dot(angle_k5)^2 - (t19 - t13)*dot(angle_k4)^2\ndrift_angle_k5 = -(t20*t25 - (t13 - t19)*t26)/(t14*t16)\ndrift_angle_k4 = -(t17*t25 + t19*t26)/(t14*t16)\nt27 = t13*t16 - t12*t15\nt28 = t13*t15 + t12*t16\nangle_k7 = atan2(50*t28, -50*t27)\nt29 = t12*t15 - t13*t16\nangle_k6 = atan2(25*(t12 - t29), 25*(t28 - t13))\nt30 = t29 - t12\nslope_angle_k7_beta = (t21*t30 - t22*(t13 - t28))/(t14*t16)\ndot(angle_k7) = dot(beta)*slope_angle_k7_beta\nslope_angle_k6_beta = -(t21*t27 - t22*t28)/(t14*t16)\ndot(angle_k6) = dot(beta)*slope_angle_k6_beta\nt31 = t23 - t27*dot(angle_k7)^2 - t30*dot(angle_k6)^2\nt32 = t24 + t28*dot(angle_k7)^2 - (t28 - t13)*dot(angle_k6)^2\ndrift_angle_k7 = (t30*t31 - (t13 - t28)*t32)/(t14*t16)\ndrift_angle_k6 = -(t27*t31 - t28*t32)/(t14*t16)\nt33 = sin(angle_k3)\nt34 = cos(angle_k3)\nt35 = cos(beta - angle_k2)\nt36 = sin(beta - angle_k2)\nt37 = sin(angle_k5 - angle_k4)\nt38 = cos(angle_k5 - angle_k4)\nt39 = sin(angle_k7 - angle_k6)\nt40 = cos(angle_k7 - angle_k6)\nt41 = sqrt(0.0048012554 - 0.0033834*t33 - 0.00060028*t34)\nt42 = 1/(1 - 16917000/24006277*t33 - 3001400/24006277*t34)\n";
        ///The names of the components of all outputs.
        pub const OUTPUTS: [&'static str; 5] = [
            "gap[0]",
            "gap[1]",
            "follow[0]",
            "follow[1]",
            "follow[2]",
        ];
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::System<T, 2> for Squeezer<T> {
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn rhs(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 2> {
            let [q_beta, qd_beta] = x.data.0[0];
            let t0 = qd_beta * qd_beta;
            let (sin_beta, cos_beta) = q_beta.sin_cos();
            let t1 = T::from_f64(0.007) * cos_beta;
            let t2 = T::from_f64(0.03635) + t1;
            let t3 = T::from_f64(0.0024415754) + T::from_f64(0.0005089) * cos_beta
                - T::from_f64(0.00045822) * sin_beta;
            let t4 = T::from_f64(1.0) / t3;
            let t5 = T::from_f64(0.5) - T::from_f64(0.0002205) * t4;
            let t6 = (T::from_f64(0.000784) * t4 - t5 * t5).sqrt();
            let t7 = T::from_f64(1.0) / (t3 * t6);
            let t8 = T::from_f64(0.007) * sin_beta;
            let t9 = t8 - T::from_f64(0.03273);
            let t10 = t2 * t5 - t9 * t6;
            let t11 = t5 * t9 + t2 * t6;
            let t12 = t9 - t11;
            let t13 = t2 - t10;
            let t14 = T::from_f64(0.06934) + t1 - t10;
            let t15 = T::from_f64(0.00227) + t8 - t11;
            let t16 = t14 * t14 + t15 * t15;
            let t17 = T::from_f64(1.0) / t16;
            let t18 = T::from_f64(0.5) - T::from_f64(0.0006) * t17;
            let t19 = (T::from_f64(0.0004) * t17 - t18 * t18).sqrt();
            let t20 = T::from_f64(1.0) / (t16 * t19);
            let t21 = t14 * t18;
            let t22 = t15 * t18;
            let t23 = t15 * t19;
            let t24 = t14 * t19;
            let t25 = t21 + t23;
            let t26 = t21 - t23;
            let t27 = t7 * (t1 * t12 - t8 * t13);
            let t28 = qd_beta * t27;
            let t29 = t28 * t28;
            let t30 = t10 * t29;
            let t31 = t1 * t0;
            let t32 = t7 * (t1 * t11 - t8 * t10);
            let t33 = t1 + t10 * t27;
            let t34 = qd_beta * t32;
            let t35 = t34 * t34;
            let t36 = t11 * t29 - t8 * t0;
            let t37 = t8 + t11 * t27;
            let t38 = t12 * t35 + t36;
            let t39 = t31 - t30 - t13 * t35;
            let t40 = t7 * (t12 * t38 - t13 * t39);
            let t41 = t30 - t31 - t11 * t40;
            let t42 = t10 * t40 + t36;
            let t43 = t25 - t14;
            let t44 = t14 - t26;
            let t45 = t22 - t24;
            let t46 = t22 + t24;
            let t47 = t15 - t45;
            let t48 = t15 - t46;
            let t49 = t20 * (t43 * t37 + t47 * t33);
            let t50 = qd_beta * t49;
            let t51 = t50 * t50;
            let t52 = t20 * (t45 * t33 - t25 * t37);
            let t53 = qd_beta * t52;
            let t54 = t53 * t53;
            let t55 = t41 + t25 * t51 - t43 * t54;
            let t56 = t42 + t45 * t51 + t47 * t54;
            let t57 = t20 * (t25 * t55 + t45 * t56);
            let t58 = t20 * (t43 * t55 - t47 * t56);
            let t59 = T::from_f64(50.0) * t45;
            let t60 = T::from_f64(25.0) * t47;
            let t61 = T::from_f64(50.0) * t25;
            let t62 = T::from_f64(25.0) * t43;
            let t63 = T::from_f64(6.6455736e-5) * t52;
            let t64 = T::from_f64(1.6170147425e-5) * t32;
            let t65 = T::from_f64(9.237125e-7) * t27;
            let t66 = t57 * t63 + t7 * (t11 * t38 - t10 * t39) * t64 + t40 * t65;
            let t67 = T::from_f64(35.714285714285715) * t11;
            let t68 = T::from_f64(35.714285714285715) * t10;
            let t69 = t20 * (t33 * t48 - t37 * t44);
            let t70 = t20 * (t33 * t46 - t37 * t26);
            let t71 = qd_beta * t69;
            let t72 = t71 * t71;
            let t73 = qd_beta * t70;
            let t74 = t73 * t73;
            let t75 = t41 + t26 * t72 + t44 * t74;
            let t76 = t42 + t46 * t72 + t48 * t74;
            let t77 = t20 * (t44 * t75 + t48 * t76);
            let t78 = t20 * (t26 * t75 + t46 * t76);
            let t79 = T::from_f64(50.0) * t46;
            let t80 = T::from_f64(25.0) * t44;
            let t81 = T::from_f64(50.0) * t26;
            let t82 = T::from_f64(25.0) * t48;
            let t83 = T::from_f64(8.03380146e-7) * t69;
            let t84 = T::from_f64(3.981529833e-5) * t70;
            let t85 = t59 * t60 - t61 * t62;
            let t86 = t59 * t62 + t60 * t61;
            let t87 = t52 * (t85 * t58 - t86 * t51) - t49 * (t86 * t54 + t57 * t85);
            let t88 = t87 - (t79 * t80 - t81 * t82) * (t70 * t72 + t69 * t74);
            let t89 = t79 * t82 + t80 * t81;
            let t90 = t66 + t77 * t83 + t78 * t84
                + T::from_f64(1.635096e-6) * (t88 - t89 * (t69 * t78 + t70 * t77));
            let t91 = T::from_f64(28.571428571428573) * t13;
            let t92 = T::from_f64(28.571428571428573) * t12;
            let t93 = (T::from_f64(0.0048012554) + T::from_f64(0.01715085714285714) * t12
                - T::from_f64(0.09666857142857142) * t13)
                .sqrt()
                * (T::from_f64(124.25828624946718) * t92
                    + T::from_f64(22.045801285638753) * t91);
            let t94 = T::from_f64(1.3596342) * t91 + T::from_f64(7.663401) * t92
                - T::from_f64(1.0)
                    / (T::from_f64(1.0) + T::from_f64(3.5721609691617617) * t12
                        - T::from_f64(20.13401982918289) * t13) * t93;
            let t95 = sin_beta * t67 + cos_beta * t68;
            let t96 = t40 * t95 + (cos_beta * t67 - sin_beta * t68) * (t29 + t27 * t0);
            let t97 = T::from_f64(2.4094568e-6) + t52 * t63 + t32 * t64 + t69 * t83
                + t27 * (t65 + T::from_f64(5.8765e-7) * t95);
            let t98 = T::from_f64(8.03380146e-7) * t49;
            let t99 = t97 + t49 * (t98 - T::from_f64(3.270192e-6) * (t52 * t85))
                + t70 * (t84 - T::from_f64(3.270192e-6) * (t69 * t89));
            ::pendulum_core::nalgebra::SVector::from([
                qd_beta,
                (t90 + t32 * t94 + T::from_f64(2.93825e-7) * t96 - t58 * t98
                    - T::from_f64(0.033)) * (T::from_f64(-1.0) / t99),
            ])
        }
        #[inline]
        fn layout(
            &self,
        ) -> ::core::option::Option<&'static ::pendulum_core::StateLayout> {
            Some(&<Squeezer>::LAYOUT)
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn margins(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
            tell: &mut dyn FnMut([&'static str; 2], [T; 2]),
        ) {
            let (margins, rates) = self.loop_margins(t, x);
            tell(["k2", "k3"], [margins[0], rates[0]]);
            tell(["k2", "k5"], [margins[1], rates[1]]);
            tell(["k2", "k7"], [margins[2], rates[2]]);
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Jacobian<T, 2>
    for Squeezer<T> {
        #[inline]
        fn jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
        ) -> ::pendulum_core::nalgebra::SMatrix<T, 2, 2> {
            self.rhs_and_jacobian(t, x).1
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn rhs_and_jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 2>,
            ::pendulum_core::nalgebra::SMatrix<T, 2, 2>,
        ) {
            let [q_beta, qd_beta] = x.data.0[0];
            let (
                t1,
                t10,
                t12,
                t19,
                t22,
                t23,
                t25,
                t29,
                t33,
                t34,
                t37,
                t38,
                t57,
                t59,
                t74,
                t75,
                t78,
                t80,
                t83,
                t85,
                t86,
                t88,
                t109,
                t110,
                t113,
                t114,
                t116,
                t129,
                t136,
                t137,
                t181,
                t196,
                t198,
                t212,
                t221,
                t245,
                t247,
                t248,
                t249,
                t251,
                t252,
                t253,
                t254,
            ) = {
                let t0 = qd_beta * qd_beta;
                let t1 = T::from_f64(2.0) * qd_beta;
                let (sin_beta, cos_beta) = q_beta.sin_cos();
                let t2 = T::from_f64(0.007) * cos_beta;
                let t3 = T::from_f64(0.03635) + t2;
                let t4 = T::from_f64(0.0024415754) + T::from_f64(0.0005089) * cos_beta
                    - T::from_f64(0.00045822) * sin_beta;
                let t5 = T::from_f64(1.0) / t4;
                let t6 = T::from_f64(0.5) - T::from_f64(0.0002205) * t5;
                let t7 = (T::from_f64(0.000784) * t5 - t6 * t6).sqrt();
                let t8 = T::from_f64(0.007) * sin_beta;
                let t9 = t8 - T::from_f64(0.03273);
                let t10 = t3 * t6 - t9 * t7;
                let t11 = T::from_f64(0.06934) + t2 - t10;
                let t12 = t6 * t9 + t3 * t7;
                let t13 = T::from_f64(0.00227) + t8 - t12;
                let t14 = t11 * t11 + t13 * t13;
                let t15 = T::from_f64(1.0) / t14;
                let t16 = T::from_f64(0.5) - T::from_f64(0.0006) * t15;
                let t17 = (T::from_f64(0.0004) * t15 - t16 * t16).sqrt();
                let t18 = t14 * t17;
                let t19 = T::from_f64(1.0) / t18;
                let t20 = t13 * t16;
                let t21 = t11 * t17;
                let t22 = t20 - t21;
                let t23 = t20 + t21;
                let t24 = t4 * t7;
                let t25 = T::from_f64(1.0) / t24;
                let t26 = t9 - t12;
                let t27 = t3 - t10;
                let t28 = t2 * t26 - t8 * t27;
                let t29 = t25 * t28;
                let t30 = t2 + t10 * t29;
                let t31 = t11 * t16;
                let t32 = t13 * t17;
                let t33 = t31 + t32;
                let t34 = t31 - t32;
                let t35 = t8 + t12 * t29;
                let t36 = t22 * t30 - t33 * t35;
                let t37 = t19 * t36;
                let t38 = t33 - t11;
                let t39 = t29 * qd_beta;
                let t40 = t39 * t39;
                let t41 = T::from_f64(2.0) * t39;
                let t42 = t10 * t40;
                let t43 = t2 * t0;
                let t44 = t2 * t12 - t8 * t10;
                let t45 = t25 * t44;
                let t46 = qd_beta * t45;
                let t47 = t46 * t46;
                let t48 = T::from_f64(2.0) * t46;
                let t49 = t8 * t0;
                let t50 = t12 * t40 - t49;
                let t51 = t26 * t47 + t50;
                let t52 = t43 - t42 - t27 * t47;
                let t53 = t26 * t51 - t27 * t52;
                let t54 = t25 * t53;
                let t55 = t42 - t43 - t12 * t54;
                let t56 = t10 * t54 + t50;
                let t57 = t13 - t22;
                let t58 = t35 * t38 + t30 * t57;
                let t59 = t19 * t58;
                let t60 = qd_beta * t59;
                let t61 = t60 * t60;
                let t62 = T::from_f64(2.0) * t60;
                let t63 = t37 * qd_beta;
                let t64 = t63 * t63;
                let t65 = T::from_f64(2.0) * t63;
                let t66 = t55 + t33 * t61 - t38 * t64;
                let t67 = t56 + t22 * t61 + t57 * t64;
                let t68 = t38 * t66 - t57 * t67;
                let t69 = t19 * t68;
                let t70 = T::from_f64(50.0) * t22;
                let t71 = T::from_f64(25.0) * t57;
                let t72 = T::from_f64(25.0) * t38;
                let t73 = T::from_f64(50.0) * t33;
                let t74 = t70 * t71 - t72 * t73;
                let t75 = t70 * t72 + t73 * t71;
                let t76 = t69 * t74 - t75 * t61;
                let t77 = t30 * t23 - t35 * t34;
                let t78 = t19 * t77;
                let t79 = T::from_f64(50.0) * t23;
                let t80 = t11 - t34;
                let t81 = T::from_f64(25.0) * t80;
                let t82 = T::from_f64(50.0) * t34;
                let t83 = t13 - t23;
                let t84 = T::from_f64(25.0) * t83;
                let t85 = t79 * t81 - t82 * t84;
                let t86 = t79 * t84 + t81 * t82;
                let t87 = t30 * t83 - t35 * t80;
                let t88 = t19 * t87;
                let t89 = qd_beta * t88;
                let t90 = t89 * t89;
                let t91 = T::from_f64(2.0) * t89;
                let t92 = qd_beta * t78;
                let t93 = t92 * t92;
                let t94 = t55 + t34 * t90 + t80 * t93;
                let t95 = t56 + t23 * t90 + t83 * t93;
                let t96 = T::from_f64(2.0) * t92;
                let t97 = t80 * t94 + t83 * t95;
                let t98 = t19 * t97;
                let t99 = t85 * t90 + t98 * t86;
                let t100 = t34 * t94 + t23 * t95;
                let t101 = t19 * t100;
                let t102 = t85 * t93 + t86 * t101;
                let t103 = t33 * t66 + t22 * t67;
                let t104 = t19 * t103;
                let t105 = t75 * t64 + t74 * t104;
                let t106 = T::from_f64(1.635096e-6)
                    * (t37 * t76 - t78 * t99 - t88 * t102 - t59 * t105);
                let t107 = T::from_f64(35.714285714285715) * t12;
                let t108 = T::from_f64(35.714285714285715) * t10;
                let t109 = sin_beta * t107 + cos_beta * t108;
                let t110 = cos_beta * t107 - sin_beta * t108;
                let t111 = T::from_f64(0.0005089) * sin_beta
                    + T::from_f64(0.00045822) * cos_beta;
                let t112 = t40 + t29 * t0;
                let t113 = T::from_f64(6.6455736e-5) * t37;
                let t114 = T::from_f64(9.237125e-7) * t29;
                let t115 = t106 + T::from_f64(2.93825e-7) * (t54 * t109 + t110 * t112)
                    + t104 * t113 + t54 * t114;
                let t116 = T::from_f64(3.981529833e-5) * t78;
                let t117 = t12 * t51 - t10 * t52;
                let t118 = T::from_f64(28.571428571428573) * t27;
                let t119 = T::from_f64(1.0) + T::from_f64(3.5721609691617617) * t26
                    - T::from_f64(20.13401982918289) * t27;
                let t120 = T::from_f64(1.0) / t119;
                let t121 = (T::from_f64(0.0048012554)
                    + T::from_f64(0.01715085714285714) * t26
                    - T::from_f64(0.09666857142857142) * t27)
                    .sqrt();
                let t122 = T::from_f64(22.045801285638753) * t121;
                let t123 = T::from_f64(1.3596342) - t120 * t122;
                let t124 = T::from_f64(28.571428571428573) * t26;
                let t125 = T::from_f64(124.25828624946718) * t121;
                let t126 = t120 * t125 - T::from_f64(7.663401);
                let t127 = T::from_f64(1.6170147425e-5) * t25 * t117 + t118 * t123
                    - t124 * t126;
                let t128 = t115 + t101 * t116 + t45 * t127
                    - T::from_f64(8.03380146e-7) * (t59 * t69 - t88 * t98);
                let t129 = T::from_f64(1.6170147425e-5) * t45;
                let t130 = T::from_f64(3.270192e-6) * t78;
                let t131 = T::from_f64(8.03380146e-7) * t88 - t86 * t130;
                let t132 = T::from_f64(2.4094568e-6) + t45 * t129 + t37 * t113
                    + t78 * t116 + t88 * t131;
                let t133 = T::from_f64(3.270192e-6) * t37;
                let t134 = T::from_f64(8.03380146e-7) * t59 - t74 * t133;
                let t135 = t114 + T::from_f64(5.8765e-7) * t109;
                let t136 = T::from_f64(-1.0) / (t132 + t59 * t134 + t29 * t135);
                let t137 = (t128 - T::from_f64(0.033)) * t136;
                let t138 = T::from_f64(0.028) * t29;
                let t139 = t108 * t138;
                let t140 = t107 * t138;
                let t141 = t2 + t139;
                let t142 = t8 + t140;
                let t143 = T::from_f64(2.0) * (t13 * t141 - t11 * t142);
                let t144 = t143 * (T::from_f64(1.0) / (t14 * t14));
                let t145 = T::from_f64(0.0006) * t144;
                let t146 = T::from_f64(0.5) * (T::from_f64(1.0) / t17)
                    * (T::from_f64(0.0004) * t144 + T::from_f64(2.0) * t16 * t145);
                let t147 = (t17 * t143 - t14 * t146) * (T::from_f64(1.0) / (t18 * t18));
                let t148 = T::from_f64(1.0) / (t4 * t4) * t111;
                let t149 = T::from_f64(0.0002205) * t148;
                let t150 = T::from_f64(0.5) * (T::from_f64(1.0) / t7)
                    * (T::from_f64(0.000784) * t148 + T::from_f64(2.0) * t6 * t149);
                let t151 = (t4 * t150 - t7 * t111) * (T::from_f64(1.0) / (t24 * t24));
                let t152 = t2 * t6 + t3 * t150 - t9 * t149 - t8 * t7;
                let t153 = t6 * t8 + t3 * t149 + t2 * t7 + t9 * t150;
                let t154 = t25 * (t2 * (t152 - t10) + t8 * (t153 - t12)) - t44 * t151;
                let t155 = t2 - t152;
                let t156 = t8 - t153;
                let t157 = t28 * t151 - t25 * (t2 * (t155 - t27) + t8 * (t156 - t26));
                let t158 = t8 + t10 * t157 - t29 * t140;
                let t159 = t12 * t157 + t29 * t139 - t2;
                let t160 = t2 * t1;
                let t161 = t11 * t145 - t16 * t142;
                let t162 = t16 * t141 + t13 * t145;
                let t163 = t17 * t141 - t13 * t146;
                let t164 = t17 * t142 + t11 * t146;
                let t165 = t161 - t163;
                let t166 = t161 + t163;
                let t167 = t142 + t165;
                let t168 = t142 + t166;
                let t169 = t162 - t164;
                let t170 = t162 + t164;
                let t171 = t141 - t169;
                let t172 = t141 - t170;
                let t173 = t19 * (t83 * t158 - t80 * t159 - t35 * t167 - t30 * t171);
                let t174 = t87 * t147 + t173;
                let t175 = t19 * (t35 * t165 + t23 * t158 - t34 * t159 - t30 * t169);
                let t176 = t77 * t147 + t175;
                let t177 = qd_beta * t154 * t48;
                let t178 = t45 * t48;
                let t179 = qd_beta * t157 * t41;
                let t180 = t43 + t12 * t179;
                let t181 = t29 * t41;
                let t182 = t12 * t181 - t8 * t1;
                let t183 = t40 * t152 + t155 * t47 + t26 * t177 - t180;
                let t184 = t10 * t179;
                let t185 = t40 * t153 + t184 + t156 * t47 - t49 - t27 * t177;
                let t186 = t25 * (t52 * t156 + t51 * t155 + t26 * t183 - t27 * t185);
                let t187 = t25 * (t52 * t153 + t51 * t152 + t12 * t183 - t10 * t185);
                let t188 = t53 * t151 - t186;
                let t189 = t49 + t12 * t188 + t54 * t139 + t40 * t140 - t184;
                let t190 = t54 * t140 - t40 * t139 - t10 * t188 - t180;
                let t191 = t19 * (t33 * t159 + t30 * t170 - t35 * t166 - t22 * t158);
                let t192 = t19 * (t38 * t159 + t57 * t158 - t35 * t168 - t30 * t172);
                let t193 = t36 * t147 - t191;
                let t194 = t58 * t147 + t192;
                let t195 = qd_beta * t193 * t65;
                let t196 = t37 * t65;
                let t197 = qd_beta * t194 * t62;
                let t198 = t59 * t62;
                let t199 = t189 + t166 * t61 + t38 * t195 - t33 * t197 - t168 * t64;
                let t200 = t190 + t170 * t61 + t172 * t64 - t22 * t197 - t57 * t195;
                let t201 = t19 * (t66 * t166 + t33 * t199 + t67 * t170 + t22 * t200);
                let t202 = t19 * (t66 * t168 + t38 * t199 - t67 * t172 - t57 * t200);
                let t203 = t103 * t147 - t201;
                let t204 = t68 * t147 - t202;
                let t205 = t37 + t59;
                let t206 = t74 * t205;
                let t207 = t75 * t205;
                let t208 = t59 * (t74 * t203 + t75 * t195 + t206 * t64 - t104 * t207);
                let t209 = t37 * (t74 * t204 - t75 * t197 - t206 * t61 - t69 * t207);
                let t210 = t59
                    * (T::from_f64(3.270192e-6) * t74 * t193 - t133 * t207
                        - T::from_f64(8.03380146e-7) * t194) + t154 * (t129 + t129);
                let t211 = qd_beta * t174 * t91;
                let t212 = t88 * t91;
                let t213 = qd_beta * t176 * t96;
                let t214 = t189 + t165 * t90 - t34 * t211 - t167 * t93 - t80 * t213;
                let t215 = t190 + t169 * t90 + t171 * t93 - t23 * t211 - t83 * t213;
                let t216 = t19 * (t94 * t165 + t34 * t214 + t95 * t169 + t23 * t215);
                let t217 = t19 * (t94 * t167 - t80 * t214 - t95 * t171 - t83 * t215);
                let t218 = t216 - t100 * t147;
                let t219 = t217 + t97 * t147;
                let t220 = T::from_f64(8.03380146e-7)
                    * (t69 * t194 + t59 * t204 - t98 * t174 - t88 * t219);
                let t221 = t78 * t96;
                let t222 = t78 + t88;
                let t223 = t85 * t222;
                let t224 = t86 * t222;
                let t225 = t78 * (t98 * t223 - t224 * t90 - t85 * t211 - t86 * t219);
                let t226 = t88 * (t86 * t218 + t101 * t223 - t224 * t93 - t85 * t213);
                let t227 = t102 * t174 + t99 * t176 + t208 + t105 * t194 - t226 - t225;
                let t228 = T::from_f64(1.635096e-6) * (t227 - t76 * t193 - t209) + t220
                    + t116 * t218 + t127 * t154;
                let t229 = t45 * t118;
                let t230 = t45 * t124;
                let t231 = t120
                    * (T::from_f64(0.5)
                        * (T::from_f64(0.00060028) * t229
                            + T::from_f64(0.0033834) * t230)
                        * (T::from_f64(1.0) / t121));
                let t232 = (T::from_f64(0.12502563392066166) * t229
                    + T::from_f64(0.7046906940214012) * t230)
                    * (T::from_f64(1.0) / (t119 * t119));
                let t233 = T::from_f64(1.6170147425e-5) * (t187 - t117 * t151)
                    + t118 * (t122 * t232 - T::from_f64(22.045801285638753) * t231);
                let t234 = t233
                    - t124 * (T::from_f64(124.25828624946718) * t231 - t125 * t232)
                    - t126 * t229 - t123 * t230;
                let t235 = T::from_f64(6.6455736e-5) * t193;
                let t236 = T::from_f64(3.981529833e-5) * t176;
                let t237 = t210 - t113 * t193 - t37 * t235 - t116 * t176 - t78 * t236;
                let t238 = t237 - t131 * t174
                    - t88
                        * (T::from_f64(8.03380146e-7) * t174 + t130 * t223
                            - T::from_f64(3.270192e-6) * t86 * t176);
                let t239 = T::from_f64(9.237125e-7) * t157;
                let t240 = T::from_f64(1.0) + t29;
                let t241 = t110 * t240;
                let t242 = t238 - t134 * t194 - t135 * t157
                    - t29 * (t239 - T::from_f64(5.8765e-7) * t241);
                let t243 = t228 + t45 * t234 + t137 * t242 - t101 * t236 - t113 * t203;
                let t244 = t110 * (t179 + t157 * t0) + t109 * (t188 + t112 * t240)
                    - t54 * t241;
                let t245 = t243 - t104 * t235 - t114 * t188 - t54 * t239
                    - T::from_f64(2.93825e-7) * t244;
                let t246 = t10 * t181;
                let t247 = t26 * t178 + t182;
                let t248 = t160 - t246 - t27 * t178;
                let t249 = t25 * (t26 * t247 - t27 * t248);
                let t250 = t246 - t160 - t12 * t249;
                let t251 = t10 * t249 + t182;
                let t252 = t250 + t33 * t198 - t38 * t196;
                let t253 = t250 + t34 * t212 + t80 * t221;
                let t254 = t251 + t22 * t198 + t57 * t196;
                (
                    t1,
                    t10,
                    t12,
                    t19,
                    t22,
                    t23,
                    t25,
                    t29,
                    t33,
                    t34,
                    t37,
                    t38,
                    t57,
                    t59,
                    t74,
                    t75,
                    t78,
                    t80,
                    t83,
                    t85,
                    t86,
                    t88,
                    t109,
                    t110,
                    t113,
                    t114,
                    t116,
                    t129,
                    t136,
                    t137,
                    t181,
                    t196,
                    t198,
                    t212,
                    t221,
                    t245,
                    t247,
                    t248,
                    t249,
                    t251,
                    t252,
                    t253,
                    t254,
                )
            };
            let (t255, t260, t263) = {
                let t255 = t19 * (t38 * t252 - t57 * t254);
                let t256 = t19 * (t33 * t252 + t22 * t254);
                let t257 = t251 + t23 * t212 + t83 * t221;
                let t258 = t19 * (t34 * t253 + t23 * t257);
                let t259 = t37 * (t74 * t255 - t75 * t198)
                    - t88 * (t85 * t221 + t86 * t258);
                let t260 = t19 * (t80 * t253 + t83 * t257);
                let t261 = t259 - t78 * (t85 * t212 + t86 * t260)
                    - t59 * (t74 * t256 + t75 * t196);
                let t262 = T::from_f64(1.635096e-6) * t261
                    + T::from_f64(2.93825e-7) * (t110 * (t181 + t29 * t1) + t109 * t249);
                let t263 = t262 + t116 * t258 + t113 * t256 + t114 * t249
                    + t25 * t129 * (t12 * t247 - t10 * t248);
                (t255, t260, t263)
            };
            (
                ::pendulum_core::nalgebra::SVector::from([qd_beta, t137]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [T::from_f64(0.0), t136 * t245],
                    [
                        T::from_f64(1.0),
                        t136
                            * (t263
                                - T::from_f64(8.03380146e-7) * (t59 * t255 - t88 * t260)),
                    ],
                ]),
            )
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn time_derivative(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 2> {
            ::pendulum_core::nalgebra::SVector::from([
                T::from_f64(0.0),
                T::from_f64(0.0),
            ])
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Energy<T, 2> for Squeezer<T> {
        #[inline]
        fn kinetic(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 2>) -> T {
            let [q_beta, qd_beta] = x.data.0[0];
            let (sin_beta, cos_beta) = q_beta.sin_cos();
            let t0 = T::from_f64(0.0024415754) + T::from_f64(0.0005089) * cos_beta
                - T::from_f64(0.00045822) * sin_beta;
            let t1 = T::from_f64(1.0) / t0;
            let t2 = T::from_f64(0.5) - T::from_f64(0.0002205) * t1;
            let t3 = (T::from_f64(0.000784) * t1 - t2 * t2).sqrt();
            let t4 = T::from_f64(1.0) / (t0 * t3);
            let t5 = T::from_f64(0.007) * cos_beta;
            let t6 = T::from_f64(0.007) * sin_beta;
            let t7 = t6 - T::from_f64(0.03273);
            let t8 = T::from_f64(0.03635) + t5;
            let t9 = t2 * t7 + t8 * t3;
            let t10 = t8 * t2 - t7 * t3;
            let t11 = t4 * (t6 * (t10 - t8) + t5 * (t7 - t9));
            let t12 = qd_beta * t4 * (t5 * t9 - t6 * t10);
            let t13 = qd_beta * t11;
            let t14 = T::from_f64(1.2047284e-6) * qd_beta
                + T::from_f64(2.93825e-7)
                    * (t13
                        * (T::from_f64(35.714285714285715)
                            * (sin_beta * t9 + cos_beta * t10)));
            let t15 = t6 + t9 * t11;
            let t16 = T::from_f64(0.00227) + t6 - t9;
            let t17 = t5 + t10 * t11;
            let t18 = T::from_f64(0.06934) + t5 - t10;
            let t19 = t18 * t18 + t16 * t16;
            let t20 = T::from_f64(1.0) / t19;
            let t21 = T::from_f64(0.5) - T::from_f64(0.0006) * t20;
            let t22 = (T::from_f64(0.0004) * t20 - t21 * t21).sqrt();
            let t23 = qd_beta * (T::from_f64(1.0) / (t19 * t22));
            let t24 = t16 * t22;
            let t25 = t18 * t22;
            let t26 = t18 * t21;
            let t27 = t16 * t21;
            let t28 = t24 - t26;
            let t29 = t24 + t26;
            let t30 = t27 + t25;
            let t31 = t27 - t25;
            let t32 = (t15 * t28 + t17 * t30) * t23;
            let t33 = t16 - t30;
            let t34 = t16 - t31;
            let t35 = t18 + t28;
            let t36 = t29 - t18;
            let t37 = (t17 * t33 - t15 * t35) * t23;
            let t38 = t32
                * (T::from_f64(1.9907649165e-5) * t32
                    + t37 * (T::from_f64(0.00204387) * (t28 * t35 - t30 * t33)));
            let t39 = T::from_f64(8.0850737125e-6) * t12 * t12
                + T::from_f64(4.6185625e-7) * t13 * t13 + qd_beta * t14 + t38;
            let t40 = (t17 * t31 - t15 * t29) * t23;
            let t41 = (t15 * t36 + t17 * t34) * t23;
            let t42 = t40
                * (T::from_f64(3.3227868e-5) * t40
                    - t41 * (T::from_f64(0.00204387) * (t31 * t34 - t29 * t36)));
            t39 + t42 + T::from_f64(4.01690073e-7) * (t41 * t41 + t37 * t37)
        }
        #[inline]
        fn potential(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 2>) -> T {
            let [q_beta, _] = x.data.0[0];
            let (sin_beta, cos_beta) = q_beta.sin_cos();
            let t0 = T::from_f64(0.03635) + T::from_f64(0.007) * cos_beta;
            let t1 = T::from_f64(1.0)
                / (T::from_f64(0.0024415754) + T::from_f64(0.0005089) * cos_beta
                    - T::from_f64(0.00045822) * sin_beta);
            let t2 = T::from_f64(-0.03273) + T::from_f64(0.007) * sin_beta;
            let t3 = T::from_f64(0.5) - T::from_f64(0.0002205) * t1;
            let t4 = (T::from_f64(0.000784) * t1 - t3 * t3).sqrt();
            let t5 = t0 - (t0 * t3 - t2 * t4);
            let t6 = t2 * t3 + t0 * t4 - t2;
            T::from_f64(24.6021534435) - T::from_f64(218.95431428571428) * t5
                - T::from_f64(38.846691428571425) * t6
                - T::from_f64(352.6605)
                    * (T::from_f64(0.0048012554) - T::from_f64(0.09666857142857142) * t5
                        - T::from_f64(0.01715085714285714) * t6)
                        .sqrt()
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> Squeezer<T> {
        ///How far each closed loop is from its toggle, in the order of the declaration: 0 there, and at most 1. And the rates of that.
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        pub fn loop_margins(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 3>,
            ::pendulum_core::nalgebra::SVector<T, 3>,
        ) {
            let [q_beta, qd_beta] = x.data.0[0];
            let (sin_beta, cos_beta) = q_beta.sin_cos();
            let t0 = T::from_f64(0.0024415754) + T::from_f64(0.0005089) * cos_beta
                - T::from_f64(0.00045822) * sin_beta;
            let t1 = T::from_f64(1.0) / t0;
            let t2 = T::from_f64(0.5) - T::from_f64(0.0002205) * t1;
            let t3 = (T::from_f64(0.000784) * t1 - t2 * t2).sqrt();
            let t4 = t0 * t3;
            let t5 = T::from_f64(0.007) * cos_beta;
            let t6 = T::from_f64(0.03635) + t5;
            let t7 = T::from_f64(0.007) * sin_beta;
            let t8 = t7 - T::from_f64(0.03273);
            let t9 = t2 * t6 - t3 * t8;
            let t10 = t2 * t8 + t3 * t6;
            let t11 = qd_beta * (T::from_f64(1.0) / t4)
                * (t7 * (t9 - t6) + t5 * (t8 - t10));
            let t12 = T::from_f64(0.06934) + t5 - t9;
            let t13 = T::from_f64(0.00227) + t7 - t10;
            let t14 = T::from_f64(35.714285714285715) * (T::from_f64(0.028) * t11);
            let t15 = t12 * t12 + t13 * t13;
            let t16 = T::from_f64(1.0) / t15;
            let t17 = T::from_f64(0.5) - T::from_f64(0.0006) * t16;
            let t18 = (T::from_f64(0.0004) * t16 - t17 * t17).sqrt();
            let t19 = T::from_f64(1250.0) * t15 * t18;
            let t20 = sin_beta * qd_beta;
            let t21 = cos_beta * qd_beta;
            let t22 = t13 * (T::from_f64(0.007) * t21 + t9 * t14)
                - t12 * (T::from_f64(0.007) * t20 + t10 * t14);
            let t23 = T::from_f64(0.0005089) * t20 + T::from_f64(0.00045822) * t21;
            let t24 = T::from_f64(0.5) * t0
                * (t23 * (T::from_f64(1.0) / (t0 * t0))
                    * (T::from_f64(0.000784)
                        + T::from_f64(2.0) * (T::from_f64(0.0002205) * t2)));
            let t25 = T::from_f64(2.0) * t22;
            let t26 = T::from_f64(0.5) * t15
                * (t25 * (T::from_f64(1.0) / (t15 * t15))
                    * (T::from_f64(0.0004)
                        + T::from_f64(2.0) * (T::from_f64(0.0006) * t17)));
            let t27 = T::from_f64(1250.0) * (t18 * t25 - t26 * (T::from_f64(1.0) / t18));
            (
                ::pendulum_core::nalgebra::SVector::from([
                    T::from_f64(1020.4081632653061) * t4,
                    t19,
                    t19,
                ]),
                ::pendulum_core::nalgebra::SVector::from([
                    T::from_f64(1020.4081632653061)
                        * (t24 * (T::from_f64(1.0) / t3) - t3 * t23),
                    t27,
                    t27,
                ]),
            )
        }
        ///Output `gap`.
        #[inline]
        pub fn gap(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 2> {
            let [q_beta, _] = x.data.0[0];
            let (sin_beta, cos_beta) = q_beta.sin_cos();
            let t0 = T::from_f64(0.007) * cos_beta;
            let t1 = T::from_f64(0.007) * sin_beta;
            let t2 = T::from_f64(1.0)
                / (T::from_f64(0.0024415754) + T::from_f64(0.0005089) * cos_beta
                    - T::from_f64(0.00045822) * sin_beta);
            let t3 = t1 - T::from_f64(0.03273);
            let t4 = T::from_f64(0.5) - T::from_f64(0.0002205) * t2;
            let t5 = (T::from_f64(0.000784) * t2 - t4 * t4).sqrt();
            let t6 = T::from_f64(0.03635) + t0;
            let t7 = T::from_f64(0.06934) + (t0 + t3 * t5 - t6 * t4);
            let t8 = T::from_f64(0.00227) + (t1 - t4 * t3 - t6 * t5);
            let t9 = T::from_f64(1.0) / (t7 * t7 + t8 * t8);
            let t10 = T::from_f64(0.5) - T::from_f64(0.0006) * t9;
            let t11 = (T::from_f64(0.0004) * t9 - t10 * t10).sqrt();
            let t12 = t7 + (t7 * t10 - t8 * t11);
            let t13 = t8 + (t8 * t10 + t7 * t11);
            ::pendulum_core::nalgebra::SVector::from([t12 - t12, t13 - t13])
        }
        ///The rate of `gap` along the motion.
        #[inline]
        pub fn gap_rate(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 2> {
            let [q_beta, qd_beta] = x.data.0[0];
            let t0 = T::from_f64(0.007) * qd_beta;
            let (sin_beta, cos_beta) = q_beta.sin_cos();
            let t1 = T::from_f64(0.007) * sin_beta;
            let t2 = t1 - T::from_f64(0.03273);
            let t3 = T::from_f64(0.0024415754) + T::from_f64(0.0005089) * cos_beta
                - T::from_f64(0.00045822) * sin_beta;
            let t4 = T::from_f64(0.007) * cos_beta;
            let t5 = T::from_f64(1.0) / t3;
            let t6 = T::from_f64(0.5) - T::from_f64(0.0002205) * t5;
            let t7 = (T::from_f64(0.000784) * t5 - t6 * t6).sqrt();
            let t8 = T::from_f64(0.03635) + t4;
            let t9 = t2 * t6 + t8 * t7;
            let t10 = t6 * t8 - t2 * t7;
            let t11 = T::from_f64(1.0) / (t3 * t7) * (t1 * (t10 - t8) + t4 * (t2 - t9));
            let t12 = T::from_f64(0.00227) + t1 - t9;
            let t13 = t1 + t9 * t11;
            let t14 = T::from_f64(0.06934) + t4 - t10;
            let t15 = t4 + t10 * t11;
            let t16 = T::from_f64(35.714285714285715)
                * (T::from_f64(0.028) * qd_beta * t11);
            let t17 = t14 * t14 + t12 * t12;
            let t18 = T::from_f64(1.0) / t17;
            let t19 = T::from_f64(0.5) - T::from_f64(0.0006) * t18;
            let t20 = (T::from_f64(0.0004) * t18 - t19 * t19).sqrt();
            let t21 = qd_beta * (T::from_f64(1.0) / (t17 * t20));
            let t22 = t12 * t19 + t14 * t20;
            let t23 = t14 * t19 - t12 * t20;
            let t24 = t12 - t22;
            let t25 = T::from_f64(25.0)
                * (T::from_f64(0.04) * (t22 * t15 - t13 * t23) * t21);
            let t26 = t14 - t23;
            let t27 = T::from_f64(50.0)
                * (T::from_f64(0.02) * (t15 * t24 - t13 * t26) * t21);
            ::pendulum_core::nalgebra::SVector::from([
                t24 * t25 - (sin_beta * t0 + t9 * t16 + t22 * t27),
                t0 * cos_beta + t10 * t16 + t23 * t27 - t26 * t25,
            ])
        }
        ///The value of `gap`, and its derivatives by the state: a row for each component, column by column for a matrix.
        #[inline]
        pub fn gap_and_jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 2>,
            ::pendulum_core::nalgebra::SMatrix<T, 2, 2>,
        ) {
            let [q_beta, _] = x.data.0[0];
            let (sin_beta, cos_beta) = q_beta.sin_cos();
            let t0 = T::from_f64(0.007) * cos_beta;
            let t1 = T::from_f64(0.03635) + t0;
            let t2 = T::from_f64(0.0024415754) + T::from_f64(0.0005089) * cos_beta
                - T::from_f64(0.00045822) * sin_beta;
            let t3 = T::from_f64(0.007) * sin_beta;
            let t4 = T::from_f64(1.0) / t2;
            let t5 = T::from_f64(0.5) - T::from_f64(0.0002205) * t4;
            let t6 = (T::from_f64(0.000784) * t4 - t5 * t5).sqrt();
            let t7 = t3 - T::from_f64(0.03273);
            let t8 = t1 * t5 - t7 * t6;
            let t9 = t5 * t7 + t1 * t6;
            let t10 = T::from_f64(1.0) / (t2 * t6) * (t3 * (t8 - t1) + t0 * (t7 - t9));
            let t11 = T::from_f64(0.06934) + (t0 - t8);
            let t12 = t0 + t8 * t10;
            let t13 = t3 + t9 * t10;
            let t14 = T::from_f64(0.00227) + (t3 - t9);
            let t15 = t11 * t11 + t14 * t14;
            let t16 = T::from_f64(1.0) / t15;
            let t17 = T::from_f64(0.5) - T::from_f64(0.0006) * t16;
            let t18 = (T::from_f64(0.0004) * t16 - t17 * t17).sqrt();
            let t19 = T::from_f64(1.0) / (t15 * t18);
            let t20 = t11 * t17 - t14 * t18;
            let t21 = t14 * t17 + t11 * t18;
            let t22 = t11 - t20;
            let t23 = t14 - t21;
            let t24 = T::from_f64(25.0)
                * (T::from_f64(0.04) * (t19 * (t21 * t12 - t13 * t20)));
            let t25 = T::from_f64(50.0)
                * (T::from_f64(0.02) * (t19 * (t12 * t23 - t13 * t22)));
            (
                ::pendulum_core::nalgebra::SVector::from([t22 - t22, t23 - t23]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [
                        t23 * t24 - (t13 + t21 * t25),
                        t0 + t10 * t8 + t20 * t25 - t22 * t24,
                    ],
                    [T::from_f64(0.0), T::from_f64(0.0)],
                ]),
            )
        }
        ///Output `follow`.
        #[inline]
        pub fn follow(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 3> {
            let [q_beta, _] = x.data.0[0];
            let (sin_beta, cos_beta) = q_beta.sin_cos();
            let t0 = T::from_f64(0.007) * cos_beta;
            let t1 = T::from_f64(0.03635) + t0;
            let t2 = T::from_f64(0.007) * sin_beta;
            let t3 = T::from_f64(1.0)
                / (T::from_f64(0.0024415754) + T::from_f64(0.0005089) * cos_beta
                    - T::from_f64(0.00045822) * sin_beta);
            let t4 = T::from_f64(0.03273) - t2;
            let t5 = T::from_f64(0.8377532857353609)
                + (T::from_f64(0.03273) * t1 - T::from_f64(0.03635) * t4)
                    .atan2(T::from_f64(0.03273) * t4 + T::from_f64(0.03635) * t1);
            let t6 = T::from_f64(0.5) - T::from_f64(0.0002205) * t3;
            let t7 = (T::from_f64(0.000784) * t3 - t6 * t6).sqrt();
            let t8 = t6 * t1 + t7 * t4 - (T::from_f64(0.06934) + t0);
            let t9 = t7 * t1 - t6 * t4 - (T::from_f64(0.00227) + t2);
            let t10 = (T::from_f64(0.00227) * t8 - T::from_f64(0.06934) * t9)
                .atan2(-(T::from_f64(0.06934) * t8 + T::from_f64(0.00227) * t9));
            let t11 = T::from_f64(1.0) / (t8 * t8 + t9 * t9);
            let t12 = T::from_f64(3.174318202785279) + t10;
            let t13 = T::from_f64(0.5) - T::from_f64(0.0006) * t11;
            let t14 = (T::from_f64(0.0004) * t11 - t13 * t13).sqrt();
            let t15 = t12 + t14.atan2(T::from_f64(1.0) - t13)
                - T::from_f64(3.141592653589793);
            ::pendulum_core::nalgebra::SVector::from([
                t5 + (-t7).atan2(T::from_f64(1.0) - t6),
                t15,
                t12 + (-t14).atan2(t13) - t15 - T::from_f64(1.5707963267948966),
            ])
        }
        ///The rate of `follow` along the motion.
        #[inline]
        pub fn follow_rate(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 3> {
            let [q_beta, qd_beta] = x.data.0[0];
            let (sin_beta, cos_beta) = q_beta.sin_cos();
            let t0 = T::from_f64(0.0024415754) + T::from_f64(0.0005089) * cos_beta
                - T::from_f64(0.00045822) * sin_beta;
            let t1 = T::from_f64(1.0) / t0;
            let t2 = T::from_f64(0.5) - T::from_f64(0.0002205) * t1;
            let t3 = (T::from_f64(0.000784) * t1 - t2 * t2).sqrt();
            let t4 = T::from_f64(1.0) / (t0 * t3);
            let t5 = T::from_f64(0.007) * sin_beta;
            let t6 = T::from_f64(0.007) * cos_beta;
            let t7 = t5 - T::from_f64(0.03273);
            let t8 = T::from_f64(0.03635) + t6;
            let t9 = t3 * t7 - t2 * t8;
            let t10 = t2 * t7 + t3 * t8;
            let t11 = t4 * (t6 * (t7 - t10) - t5 * (t8 + t9));
            let t12 = T::from_f64(0.00227) + t5 - t10;
            let t13 = t5 + t10 * t11;
            let t14 = t6 - t9 * t11;
            let t15 = T::from_f64(0.06934) + t6 + t9;
            let t16 = t15 * t15 + t12 * t12;
            let t17 = T::from_f64(1.0) / t16;
            let t18 = T::from_f64(0.5) - T::from_f64(0.0006) * t17;
            let t19 = (T::from_f64(0.0004) * t17 - t18 * t18).sqrt();
            let t20 = qd_beta * (T::from_f64(1.0) / (t16 * t19));
            let t21 = t12 * t18 - t15 * t19;
            let t22 = t15 * t18 + t12 * t19;
            let t23 = (t21 * t14 - t22 * t13) * t20;
            ::pendulum_core::nalgebra::SVector::from([
                qd_beta * t4 * (t5 * t9 + t6 * t10),
                -t23,
                t23 + (t13 * (t22 - t15) + t14 * (t12 - t21)) * t20,
            ])
        }
        ///The value of `follow`, and its derivatives by the state: a row for each component, column by column for a matrix.
        #[inline]
        pub fn follow_and_jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 3>,
            ::pendulum_core::nalgebra::SMatrix<T, 3, 2>,
        ) {
            let [q_beta, _] = x.data.0[0];
            let (sin_beta, cos_beta) = q_beta.sin_cos();
            let t0 = T::from_f64(0.007) * cos_beta;
            let t1 = T::from_f64(0.03635) + t0;
            let t2 = T::from_f64(0.007) * sin_beta;
            let t3 = T::from_f64(0.0024415754) + T::from_f64(0.0005089) * cos_beta
                - T::from_f64(0.00045822) * sin_beta;
            let t4 = T::from_f64(0.03273) - t2;
            let t5 = T::from_f64(0.8377532857353609)
                + (T::from_f64(0.03273) * t1 - T::from_f64(0.03635) * t4)
                    .atan2(T::from_f64(0.03273) * t4 + T::from_f64(0.03635) * t1);
            let t6 = T::from_f64(1.0) / t3;
            let t7 = T::from_f64(0.5) - T::from_f64(0.0002205) * t6;
            let t8 = (T::from_f64(0.000784) * t6 - t7 * t7).sqrt();
            let t9 = t5 + (-t8).atan2(T::from_f64(1.0) - t7);
            let t10 = T::from_f64(1.0) / (t3 * t8);
            let t11 = t7 * t1 + t8 * t4;
            let t12 = t8 * t1 - t7 * t4;
            let t13 = t10 * (t2 * (t11 - t1) - t0 * (t4 + t12));
            let t14 = t10 * (t0 * t12 - t2 * t11);
            let t15 = t11 - (T::from_f64(0.06934) + t0);
            let t16 = t0 + t11 * t13;
            let t17 = t2 + t12 * t13;
            let t18 = t12 - (T::from_f64(0.00227) + t2);
            let t19 = (T::from_f64(0.00227) * t15 - T::from_f64(0.06934) * t18)
                .atan2(-(T::from_f64(0.06934) * t15 + T::from_f64(0.00227) * t18));
            let t20 = T::from_f64(3.174318202785279) + t19;
            let t21 = t15 * t15 + t18 * t18;
            let t22 = T::from_f64(1.0) / t21;
            let t23 = T::from_f64(0.5) - T::from_f64(0.0006) * t22;
            let t24 = (T::from_f64(0.0004) * t22 - t23 * t23).sqrt();
            let t25 = T::from_f64(1.0) / (t21 * t24);
            let t26 = t20 + t24.atan2(T::from_f64(1.0) - t23)
                - T::from_f64(3.141592653589793);
            let t27 = t20 + (-t24).atan2(t23) - t26 - T::from_f64(1.5707963267948966);
            let t28 = t15 * t24 - t18 * t23;
            let t29 = t15 * t23 + t18 * t24;
            let t30 = t25 * (t28 * t16 + t29 * t17);
            let t31 = t30 + t25 * (t17 * (t15 - t29) - t16 * (t18 + t28));
            let t32 = -t30;
            (
                ::pendulum_core::nalgebra::SVector::from([t9, t26, t27]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [t14, t32, t31],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                ]),
            )
        }
        ///All outputs, in the order of `OUTPUTS`.
        #[inline]
        pub fn outputs(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 5> {
            let [q_beta, _] = x.data.0[0];
            let (sin_beta, cos_beta) = q_beta.sin_cos();
            let t0 = T::from_f64(0.007) * cos_beta;
            let t1 = T::from_f64(0.03635) + t0;
            let t2 = T::from_f64(1.0)
                / (T::from_f64(0.0024415754) + T::from_f64(0.0005089) * cos_beta
                    - T::from_f64(0.00045822) * sin_beta);
            let t3 = T::from_f64(0.007) * sin_beta;
            let t4 = T::from_f64(0.5) - T::from_f64(0.0002205) * t2;
            let t5 = (T::from_f64(0.000784) * t2 - t4 * t4).sqrt();
            let t6 = T::from_f64(0.03273) - t3;
            let t7 = T::from_f64(0.06934) + (t0 - (t1 * t4 + t6 * t5));
            let t8 = T::from_f64(0.00227) + (t3 - (t1 * t5 - t4 * t6));
            let t9 = T::from_f64(0.8377532857353609)
                + (T::from_f64(0.03273) * t1 - T::from_f64(0.03635) * t6)
                    .atan2(T::from_f64(0.03273) * t6 + T::from_f64(0.03635) * t1);
            let t10 = T::from_f64(1.0) / (t7 * t7 + t8 * t8);
            let t11 = T::from_f64(0.5) - T::from_f64(0.0006) * t10;
            let t12 = (T::from_f64(0.0004) * t10 - t11 * t11).sqrt();
            let t13 = t7 + (t7 * t11 - t8 * t12);
            let t14 = t8 + (t8 * t11 + t7 * t12);
            let t15 = T::from_f64(3.174318202785279)
                + (T::from_f64(0.06934) * t8 - T::from_f64(0.00227) * t7)
                    .atan2(T::from_f64(0.06934) * t7 + T::from_f64(0.00227) * t8);
            let t16 = t15 + t12.atan2(T::from_f64(1.0) - t11)
                - T::from_f64(3.141592653589793);
            ::pendulum_core::nalgebra::SVector::from([
                t13 - t13,
                t14 - t14,
                t9 + (-t5).atan2(T::from_f64(1.0) - t4),
                t16,
                t15 + (-t12).atan2(t11) - t16 - T::from_f64(1.5707963267948966),
            ])
        }
        ///The rate of all outputs along the motion.
        #[inline]
        pub fn output_rates(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 5> {
            let [q_beta, qd_beta] = x.data.0[0];
            let t0 = T::from_f64(0.007) * qd_beta;
            let (sin_beta, cos_beta) = q_beta.sin_cos();
            let t1 = T::from_f64(0.007) * sin_beta;
            let t2 = t1 - T::from_f64(0.03273);
            let t3 = T::from_f64(0.0024415754) + T::from_f64(0.0005089) * cos_beta
                - T::from_f64(0.00045822) * sin_beta;
            let t4 = T::from_f64(0.007) * cos_beta;
            let t5 = T::from_f64(1.0) / t3;
            let t6 = T::from_f64(0.5) - T::from_f64(0.0002205) * t5;
            let t7 = (T::from_f64(0.000784) * t5 - t6 * t6).sqrt();
            let t8 = T::from_f64(1.0) / (t3 * t7);
            let t9 = T::from_f64(0.03635) + t4;
            let t10 = t2 * t6 + t9 * t7;
            let t11 = t6 * t9 - t2 * t7;
            let t12 = t8 * (t1 * (t11 - t9) + t4 * (t2 - t10));
            let t13 = T::from_f64(0.00227) + t1 - t10;
            let t14 = t1 + t10 * t12;
            let t15 = T::from_f64(0.06934) + t4 - t11;
            let t16 = t4 + t11 * t12;
            let t17 = T::from_f64(35.714285714285715)
                * (T::from_f64(0.028) * qd_beta * t12);
            let t18 = t15 * t15 + t13 * t13;
            let t19 = T::from_f64(1.0) / t18;
            let t20 = T::from_f64(0.5) - T::from_f64(0.0006) * t19;
            let t21 = (T::from_f64(0.0004) * t19 - t20 * t20).sqrt();
            let t22 = qd_beta * (T::from_f64(1.0) / (t18 * t21));
            let t23 = t13 * t20;
            let t24 = t15 * t20;
            let t25 = t15 * t21;
            let t26 = t13 * t21;
            let t27 = t23 + t25;
            let t28 = t23 - t25;
            let t29 = t13 - t27;
            let t30 = t24 - t26;
            let t31 = t24 + t26;
            let t32 = (t16 * t28 - t14 * t31) * t22;
            let t33 = T::from_f64(25.0)
                * (T::from_f64(0.04) * (t27 * t16 - t14 * t30) * t22);
            let t34 = t15 - t30;
            let t35 = T::from_f64(50.0)
                * (T::from_f64(0.02) * (t16 * t29 - t14 * t34) * t22);
            ::pendulum_core::nalgebra::SVector::from([
                t29 * t33 - (sin_beta * t0 + t10 * t17 + t27 * t35),
                t0 * cos_beta + t11 * t17 + t30 * t35 - t34 * t33,
                qd_beta * t8 * (t4 * t10 - t1 * t11),
                -t32,
                t32 + (t14 * (t31 - t15) + t16 * (t13 - t28)) * t22,
            ])
        }
        ///The value of all outputs, and its derivatives by the state: a row for each component, column by column for a matrix.
        #[inline]
        pub fn outputs_and_jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 5>,
            ::pendulum_core::nalgebra::SMatrix<T, 5, 2>,
        ) {
            let [q_beta, _] = x.data.0[0];
            let (sin_beta, cos_beta) = q_beta.sin_cos();
            let t0 = T::from_f64(0.007) * cos_beta;
            let t1 = T::from_f64(0.03635) + t0;
            let t2 = T::from_f64(0.0024415754) + T::from_f64(0.0005089) * cos_beta
                - T::from_f64(0.00045822) * sin_beta;
            let t3 = T::from_f64(0.007) * sin_beta;
            let t4 = T::from_f64(1.0) / t2;
            let t5 = T::from_f64(0.5) - T::from_f64(0.0002205) * t4;
            let t6 = (T::from_f64(0.000784) * t4 - t5 * t5).sqrt();
            let t7 = T::from_f64(1.0) / (t2 * t6);
            let t8 = T::from_f64(0.03273) - t3;
            let t9 = t1 * t5 + t8 * t6;
            let t10 = T::from_f64(0.06934) + (t0 - t9);
            let t11 = t1 * t6 - t5 * t8;
            let t12 = t7 * (t0 * t11 - t3 * t9);
            let t13 = t7 * (t3 * (t9 - t1) - t0 * (t8 + t11));
            let t14 = T::from_f64(0.8377532857353609)
                + (T::from_f64(0.03273) * t1 - T::from_f64(0.03635) * t8)
                    .atan2(T::from_f64(0.03273) * t8 + T::from_f64(0.03635) * t1);
            let t15 = t14 + (-t6).atan2(T::from_f64(1.0) - t5);
            let t16 = T::from_f64(0.00227) + (t3 - t11);
            let t17 = t3 + t11 * t13;
            let t18 = t10 * t10 + t16 * t16;
            let t19 = T::from_f64(1.0) / t18;
            let t20 = T::from_f64(0.5) - T::from_f64(0.0006) * t19;
            let t21 = (T::from_f64(0.0004) * t19 - t20 * t20).sqrt();
            let t22 = T::from_f64(1.0) / (t18 * t21);
            let t23 = t10 * t20;
            let t24 = t16 * t21;
            let t25 = t23 - t24;
            let t26 = t23 + t24;
            let t27 = t10 - t25;
            let t28 = t27 - t27;
            let t29 = t16 * t20;
            let t30 = t10 * t21;
            let t31 = t29 + t30;
            let t32 = t29 - t30;
            let t33 = t16 - t31;
            let t34 = t33 - t33;
            let t35 = T::from_f64(3.174318202785279)
                + (T::from_f64(0.06934) * t16 - T::from_f64(0.00227) * t10)
                    .atan2(T::from_f64(0.06934) * t10 + T::from_f64(0.00227) * t16);
            let t36 = t35 + t21.atan2(T::from_f64(1.0) - t20)
                - T::from_f64(3.141592653589793);
            let t37 = t35 + (-t21).atan2(t20) - t36 - T::from_f64(1.5707963267948966);
            let t38 = t0 + t9 * t13;
            let t39 = T::from_f64(25.0)
                * (T::from_f64(0.04) * (t22 * (t31 * t38 - t17 * t25)));
            let t40 = T::from_f64(50.0)
                * (T::from_f64(0.02) * (t22 * (t38 * t33 - t17 * t27)));
            let t41 = t0 + t13 * t9 + t25 * t40 - t27 * t39;
            let t42 = t33 * t39 - (t17 + t31 * t40);
            let t43 = t22 * (t38 * t32 - t17 * t26);
            let t44 = t43 + t22 * (t17 * (t26 - t10) + t38 * (t16 - t32));
            let t45 = -t43;
            (
                ::pendulum_core::nalgebra::SVector::from([t28, t34, t15, t36, t37]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [t42, t41, t12, t45, t44],
                    [
                        T::from_f64(0.0),
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
    impl ::pendulum_core::shapes::Shapes<2> for Squeezer {
        fn shapes(
            &self,
            t: f64,
            x: &::pendulum_core::nalgebra::SVector<f64, 2>,
        ) -> ::pendulum_core::shapes::Vec<::pendulum_core::shapes::Shape> {
            use ::pendulum_core::real::Real as _;
            type T = f64;
            ::pendulum_core::shapes::placed(
                &[
                    ::pendulum_core::shapes::Outline {
                        name: "k1",
                        kind: ::pendulum_core::shapes::ShapeKind::Mass,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "k3",
                        kind: ::pendulum_core::shapes::ShapeKind::Mass,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "k4",
                        kind: ::pendulum_core::shapes::ShapeKind::Mass,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "k6",
                        kind: ::pendulum_core::shapes::ShapeKind::Mass,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "k2",
                        kind: ::pendulum_core::shapes::ShapeKind::Mass,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "k5",
                        kind: ::pendulum_core::shapes::ShapeKind::Mass,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "k7",
                        kind: ::pendulum_core::shapes::ShapeKind::Mass,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "k1",
                        kind: ::pendulum_core::shapes::ShapeKind::Rod,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "k4",
                        kind: ::pendulum_core::shapes::ShapeKind::Rod,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "k6",
                        kind: ::pendulum_core::shapes::ShapeKind::Rod,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "k2",
                        kind: ::pendulum_core::shapes::ShapeKind::Rod,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "k3",
                        kind: ::pendulum_core::shapes::ShapeKind::Rod,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "k2",
                        kind: ::pendulum_core::shapes::ShapeKind::Rod,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "k5",
                        kind: ::pendulum_core::shapes::ShapeKind::Rod,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "k2",
                        kind: ::pendulum_core::shapes::ShapeKind::Rod,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "k7",
                        kind: ::pendulum_core::shapes::ShapeKind::Rod,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "k1",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "k3",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "k4",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "k6",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "k2",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "k5",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "k7",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "k2",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "k2",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "k2",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "k3",
                        kind: ::pendulum_core::shapes::ShapeKind::Spring,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "c",
                        kind: ::pendulum_core::shapes::ShapeKind::Anchor,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "d",
                        kind: ::pendulum_core::shapes::ShapeKind::Point,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "e",
                        kind: ::pendulum_core::shapes::ShapeKind::Point,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "f",
                        kind: ::pendulum_core::shapes::ShapeKind::Point,
                        points: 1,
                        radius: false,
                    },
                ],
                &{
                    let [q_beta, _] = x.data.0[0];
                    let (sin_beta, cos_beta) = q_beta.sin_cos();
                    let t0 = T::from_f64(0.00092) * cos_beta;
                    let t1 = T::from_f64(0.00092) * sin_beta;
                    let t2 = T::from_f64(0.007) * sin_beta;
                    let t3 = t2 - T::from_f64(0.03273);
                    let t4 = T::from_f64(1.0)
                        / (T::from_f64(0.0024415754) + T::from_f64(0.0005089) * cos_beta
                            - T::from_f64(0.00045822) * sin_beta);
                    let t5 = T::from_f64(0.007) * cos_beta;
                    let t6 = T::from_f64(0.5) - T::from_f64(0.0002205) * t4;
                    let t7 = (T::from_f64(0.000784) * t4 - t6 * t6).sqrt();
                    let t8 = T::from_f64(0.03635) + t5;
                    let t9 = t3 * t6 + t8 * t7;
                    let t10 = t6 * t8 - t3 * t7;
                    let t11 = t9 - t3;
                    let t12 = t8 - t10;
                    let t13 = T::from_f64(0.298) * t11
                        + T::from_f64(0.5354285714285715) * t12 - T::from_f64(0.03635);
                    let t14 = T::from_f64(0.03273) + T::from_f64(0.298) * t12
                        - T::from_f64(0.5354285714285715) * t11;
                    let t15 = t5 - T::from_f64(0.4107142857142857) * t10;
                    let t16 = t5 - t10;
                    let t17 = T::from_f64(0.06934) + t16;
                    let t18 = t2 - T::from_f64(0.4107142857142857) * t9;
                    let t19 = t2 - t9;
                    let t20 = T::from_f64(0.00227) + t19;
                    let t21 = t12 - T::from_f64(0.03635);
                    let t22 = T::from_f64(0.03273) - t11;
                    let t23 = T::from_f64(1.0) / (t17 * t17 + t20 * t20);
                    let t24 = T::from_f64(0.5) - T::from_f64(0.0006) * t23;
                    let t25 = (T::from_f64(0.0004) * t23 - t24 * t24).sqrt();
                    let t26 = t17 * t24;
                    let t27 = t20 * t24;
                    let t28 = t20 * t25;
                    let t29 = t17 * t25;
                    let t30 = t26 + t28;
                    let t31 = t26 - t28;
                    let t32 = t17 - t30;
                    let t33 = t17 - t31;
                    let t34 = t27 - t29;
                    let t35 = t27 + t29;
                    let t36 = t20 - t34;
                    let t37 = T::from_f64(0.577) * t32 - T::from_f64(0.229) * t36
                        - T::from_f64(0.06934);
                    let t38 = T::from_f64(0.577) * t36 + T::from_f64(0.229) * t32
                        - T::from_f64(0.00227);
                    let t39 = t35 - t20;
                    let t40 = T::from_f64(0.307) * t39 + T::from_f64(0.11225) * t33
                        - T::from_f64(0.06934);
                    let t41 = T::from_f64(0.307) * t33 - T::from_f64(0.11225) * t39
                        - T::from_f64(0.00227);
                    let t42 = t32 - T::from_f64(0.06934);
                    let t43 = t42 + T::from_f64(0.2895) * t30;
                    let t44 = t30 + t42;
                    let t45 = t36 - T::from_f64(0.00227);
                    let t46 = t45 + T::from_f64(0.2895) * t34;
                    let t47 = t45 + t34;
                    let t48 = t33 - T::from_f64(0.06934);
                    let t49 = t48 + T::from_f64(0.2895) * t31;
                    let t50 = t31 + t48;
                    let t51 = T::from_f64(-0.00227) - t39;
                    let t52 = t51 + T::from_f64(0.2895) * t35;
                    let t53 = t35 + t51;
                    let t54 = T::from_f64(0.5714285714285714) * t11
                        + T::from_f64(0.5142857142857142) * t12 - T::from_f64(0.03635);
                    let t55 = T::from_f64(0.03273)
                        + T::from_f64(0.5714285714285714) * t12
                        - T::from_f64(0.5142857142857142) * t11;
                    [
                        t0,
                        t1,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t13,
                        t14,
                        T::from_f64(0.0),
                        T::from_f64(-0.03635),
                        T::from_f64(0.03273),
                        T::from_f64(0.0),
                        t37,
                        t38,
                        T::from_f64(0.0),
                        T::from_f64(-0.06934),
                        T::from_f64(-0.00227),
                        T::from_f64(0.0),
                        t40,
                        t41,
                        T::from_f64(0.0),
                        T::from_f64(-0.06934),
                        T::from_f64(-0.00227),
                        T::from_f64(0.0),
                        t15,
                        t18,
                        T::from_f64(0.0),
                        t5,
                        t2,
                        T::from_f64(0.0),
                        t43,
                        t46,
                        T::from_f64(0.0),
                        t42,
                        t45,
                        T::from_f64(0.0),
                        t49,
                        t52,
                        T::from_f64(0.0),
                        t48,
                        t51,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t5,
                        t2,
                        T::from_f64(0.0),
                        T::from_f64(-0.06934),
                        T::from_f64(-0.00227),
                        T::from_f64(0.0),
                        t42,
                        t45,
                        T::from_f64(0.0),
                        T::from_f64(-0.06934),
                        T::from_f64(-0.00227),
                        T::from_f64(0.0),
                        t48,
                        t51,
                        T::from_f64(0.0),
                        t5,
                        t2,
                        T::from_f64(0.0),
                        t16,
                        t19,
                        T::from_f64(0.0),
                        T::from_f64(-0.03635),
                        T::from_f64(0.03273),
                        T::from_f64(0.0),
                        t21,
                        t22,
                        T::from_f64(0.0),
                        t5,
                        t2,
                        T::from_f64(0.0),
                        t16,
                        t19,
                        T::from_f64(0.0),
                        t42,
                        t45,
                        T::from_f64(0.0),
                        t44,
                        t47,
                        T::from_f64(0.0),
                        t5,
                        t2,
                        T::from_f64(0.0),
                        t16,
                        t19,
                        T::from_f64(0.0),
                        t48,
                        t51,
                        T::from_f64(0.0),
                        t50,
                        t53,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(-0.03635),
                        T::from_f64(0.03273),
                        T::from_f64(0.0),
                        T::from_f64(-0.06934),
                        T::from_f64(-0.00227),
                        T::from_f64(0.0),
                        T::from_f64(-0.06934),
                        T::from_f64(-0.00227),
                        T::from_f64(0.0),
                        t5,
                        t2,
                        T::from_f64(0.0),
                        t42,
                        t45,
                        T::from_f64(0.0),
                        t48,
                        t51,
                        T::from_f64(0.0),
                        t16,
                        t19,
                        T::from_f64(0.0),
                        t16,
                        t19,
                        T::from_f64(0.0),
                        t16,
                        t19,
                        T::from_f64(0.0),
                        t54,
                        t55,
                        T::from_f64(0.0),
                        T::from_f64(0.014),
                        T::from_f64(0.072),
                        T::from_f64(0.0),
                        T::from_f64(0.014),
                        T::from_f64(0.072),
                        T::from_f64(0.0),
                        t54,
                        t55,
                        T::from_f64(0.0),
                        t16,
                        t19,
                        T::from_f64(0.0),
                        t50,
                        t53,
                        T::from_f64(0.0),
                    ]
                },
            )
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::CastJacobian<2> for Squeezer {
        #[inline]
        fn with_jacobian<T: ::pendulum_core::real::Real>(
            model: &Squeezer<T>,
        ) -> &impl ::pendulum_core::Jacobian<T, 2> {
            model
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::Cast<2> for Squeezer {
        type In<T: ::pendulum_core::real::Real> = Squeezer<T>;
        fn cast<T: ::pendulum_core::real::Real>(&self) -> Squeezer<T> {
            Squeezer::cast(self)
        }
        #[inline]
        fn gather<'m, T: ::pendulum_core::real::lanes::Lanes>(
            models: impl ::core::ops::Fn(usize) -> &'m Self,
        ) -> Squeezer<T>
        where
            Self: 'm,
        {
            let scalar = <<T as ::pendulum_core::real::lanes::Lanes>::Scalar as ::pendulum_core::real::Real>::from_f64;
            Squeezer {
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
pub use __Squeezer::{Squeezer, SqueezerParams};
