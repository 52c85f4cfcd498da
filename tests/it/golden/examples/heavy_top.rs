#[allow(non_snake_case)]
mod __HeavyTop {
    ///Parameters of [`HeavyTop`].
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct HeavyTopParams {
        ///In kg.
        pub m: f64,
        ///In m.
        pub l: f64,
        ///In m.
        pub r: f64,
        ///In m/s^2.
        pub g: f64,
    }
    impl ::core::default::Default for HeavyTopParams {
        #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
        fn default() -> Self {
            Self {
                m: 0.5f64,
                l: 0.1f64,
                r: 0.05f64,
                g: 9.81f64,
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl HeavyTopParams {
        /// The names of the parameters, in the order of their declaration.
        pub const NAMES: [&'static str; 4] = ["m", "l", "r", "g"];
        /// The values of the parameters, in the order of [`NAMES`](Self::NAMES).
        pub const fn to_array(self) -> [f64; 4] {
            [self.m, self.l, self.r, self.g]
        }
        /// The parameters with these values, in the order of [`NAMES`](Self::NAMES).
        pub const fn from_array(values: [f64; 4]) -> Self {
            let [v0, v1, v2, v3] = values;
            Self { m: v0, l: v1, r: v2, g: v3 }
        }
    }
    /// A disk on a rod without mass, which turns about its lower end.
    ///
    /**# Equations of motion

```text
A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints

A[o.x, o.x] = m*l^2 + 0.25*m*r^2
A[o.y, o.y] = m*l^2 + 0.25*m*r^2
A[o.z, o.z] = 0.5*m*r^2
b[o.x] = -((m*l^2 - 0.25*m*r^2)*dot(o).y*dot(o).z + 2*m*l*g*o.x*o.w + 2*m*l*g*o.y*o.z)
b[o.y] = (m*l^2 - 0.25*m*r^2)*dot(o).x*dot(o).z + 2*m*l*g*o.x*o.z - 2*m*l*g*o.y*o.w
```

# Constants, computed by `new`

```text
k0 = l
k1 = 0.25*m*r^2
k2 = 0.5*m*r^2
k3 = m*l^2 + 0.25*m*r^2
k4 = m*l*g
k5 = m*l^2 - 0.25*m*r^2
k6 = 2*m*l*g
k7 = 0.125*(m*r^2 + 4*m*l^2)
k8 = -1/(m*l^2 + 0.25*m*r^2)
k9 = 1/(m*l^2 + 0.25*m*r^2)
k10 = -2*m*l*g/(0.5*(0.5*m*r^2 + 0.25*m*r^2 + m*l^2 - 0.25*m*r^2 - m*l^2) + 0.5*(0.5*m*r^2 + 0.25*m*r^2 + m*l^2 - 0.25*m*r^2 - m*l^2) + 0.5*(2*(0.25*m*r^2 + m*l^2) - 0.5*m*r^2) - 0.5*(0.5*m*r^2 + 0.25*m*r^2 + m*l^2 - 0.25*m*r^2 - m*l^2))
k11 = -2*m*l*g/(0.5*(0.5*m*r^2 + 0.25*m*r^2 + m*l^2 - 0.25*m*r^2 - m*l^2) + 0.5*(2*(0.25*m*r^2 + m*l^2) - 0.5*m*r^2))
k12 = -(0.5*(0.5*m*r^2 + 0.25*m*r^2 + m*l^2 - 0.25*m*r^2 - m*l^2) - 0.5*(2*(0.25*m*r^2 + m*l^2) - 0.5*m*r^2))/(0.5*(0.5*m*r^2 + 0.25*m*r^2 + m*l^2 - 0.25*m*r^2 - m*l^2) + 0.5*(0.5*m*r^2 + 0.25*m*r^2 + m*l^2 - 0.25*m*r^2 - m*l^2) + 0.5*(2*(0.25*m*r^2 + m*l^2) - 0.5*m*r^2) - 0.5*(0.5*m*r^2 + 0.25*m*r^2 + m*l^2 - 0.25*m*r^2 - m*l^2))
k13 = -(0.5*(2*(0.25*m*r^2 + m*l^2) - 0.5*m*r^2) - 0.5*(0.5*m*r^2 + 0.25*m*r^2 + m*l^2 - 0.25*m*r^2 - m*l^2))/(0.5*(0.5*m*r^2 + 0.25*m*r^2 + m*l^2 - 0.25*m*r^2 - m*l^2) + 0.5*(2*(0.25*m*r^2 + m*l^2) - 0.5*m*r^2))
k14 = -2*m*l*g/(m*l^2 + 0.25*m*r^2)
k15 = 2*m*l*g/(m*l^2 + 0.25*m*r^2)
k16 = -(m*l^2 - 0.25*m*r^2)/(m*l^2 + 0.25*m*r^2)
k17 = (m*l^2 - 0.25*m*r^2)/(m*l^2 + 0.25*m*r^2)
k18 = 2*l
k19 = -4*l
k20 = -2*l
```
*/
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct HeavyTop<T = f64> {
        params: HeavyTopParams,
        constants: [T; 21],
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl HeavyTop {
        /// Builds the model: checks the parameters, and computes once whatever depends on them alone.
        ///
        /// # Errors
        ///
        /// The first parameter, or combination of parameters, that is not finite or that no rigid body can
        /// have.
        pub fn new(
            params: HeavyTopParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            #[inline]
            fn rules<T: ::pendulum_core::real::Real>(given: [T; 4]) -> [T; 2] {
                let [p_m, p_l, p_r, p_g] = given;
                [p_m, p_r]
            }
            #[inline]
            fn constants<T: ::pendulum_core::real::Real>(given: [T; 4]) -> [T; 21] {
                let [p_m, p_l, p_r, p_g] = given;
                let t0 = -(T::from_f64(4.0) * p_l);
                let t1 = p_r * p_r;
                let t2 = p_m * t1;
                let t3 = t1 * (T::from_f64(0.25) * p_m);
                let t4 = T::from_f64(0.25) * t2;
                let t5 = T::from_f64(0.5) * t2;
                let t6 = p_l * p_l;
                let t7 = T::from_f64(0.125) * (t2 + t6 * (T::from_f64(4.0) * p_m));
                let t8 = p_m * t6;
                let t9 = t4 + t8;
                let t10 = t8 + t3;
                let t11 = t8 - t3;
                let t12 = T::from_f64(-1.0) / t10;
                let t13 = -t12;
                let t14 = t11 * t12;
                let t15 = -t14;
                let t16 = p_m * p_l;
                let t17 = p_g * t16;
                let t18 = T::from_f64(2.0) * t17;
                let t19 = t18 * t12;
                let t20 = -t19;
                let t21 = T::from_f64(0.5) * (t5 + t9 - t9);
                let t22 = T::from_f64(0.5) * (T::from_f64(2.0) * t9 - t5);
                let t23 = t22 - t21;
                let t24 = T::from_f64(-1.0) / (t21 + (t21 + t23));
                let t25 = T::from_f64(2.0) * (p_g * (t16 * t24));
                let t26 = t24 * (t21 - t22);
                let t27 = T::from_f64(-1.0) / (t21 + t22);
                let t28 = T::from_f64(2.0) * (p_g * (t16 * t27));
                let t29 = t23 * t27;
                let t30 = T::from_f64(2.0) * p_l;
                let t31 = -t30;
                [
                    p_l,
                    t4,
                    t5,
                    t10,
                    t17,
                    t11,
                    t18,
                    t7,
                    t12,
                    t13,
                    t25,
                    t28,
                    t26,
                    t29,
                    t19,
                    t20,
                    t14,
                    t15,
                    t30,
                    t0,
                    t31,
                ]
            }
            let given = params.to_array();
            for (name, value) in HeavyTopParams::NAMES.into_iter().zip(given) {
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
                        "m",
                        r0,
                        "the mass of a disk of `top` must be positive",
                        &[],
                    ),
                );
            }
            if !(r1 >= 0.0) {
                return Err(
                    ::pendulum_core::ParameterError::new(
                        "r",
                        r1,
                        "the radius of a disk of `top` must not be negative",
                        &[],
                    ),
                );
            }
            let constants = constants(given);
            let names: [&'static str; 21] = [
                "l",
                "0.25*m*r^2",
                "0.5*m*r^2",
                "m*l^2 + 0.25*m*r^2",
                "m*l*g",
                "m*l^2 - 0.25*m*r^2",
                "2*m*l*g",
                "0.125*(m*r^2 + 4*m*l^2)",
                "-1/(m*l^2 + 0.25*m*r^2)",
                "1/(m*l^2 + 0.25*m*r^2)",
                "-2*m*l*g/(0.5*(0.5*m*r^2 + 0.25*m*r^2 + m*l^2 - 0.25*m*r^2 - m*l^2) + 0.5*(0.5*m*r^2 + 0.25*m*r^2 + m*l^2 - 0.25*m*r^2 - m*l^2) + 0.5*(2*(0.25*m*r^2 + m*l^2) - 0.5*m*r^2) - 0.5*(0.5*m*r^2 + 0.25*m*r^2 + m*l^2 - 0.25*m*r^2 - m*l^2))",
                "-2*m*l*g/(0.5*(0.5*m*r^2 + 0.25*m*r^2 + m*l^2 - 0.25*m*r^2 - m*l^2) + 0.5*(2*(0.25*m*r^2 + m*l^2) - 0.5*m*r^2))",
                "-(0.5*(0.5*m*r^2 + 0.25*m*r^2 + m*l^2 - 0.25*m*r^2 - m*l^2) - 0.5*(2*(0.25*m*r^2 + m*l^2) - 0.5*m*r^2))/(0.5*(0.5*m*r^2 + 0.25*m*r^2 + m*l^2 - 0.25*m*r^2 - m*l^2) + 0.5*(0.5*m*r^2 + 0.25*m*r^2 + m*l^2 - 0.25*m*r^2 - m*l^2) + 0.5*(2*(0.25*m*r^2 + m*l^2) - 0.5*m*r^2) - 0.5*(0.5*m*r^2 + 0.25*m*r^2 + m*l^2 - 0.25*m*r^2 - m*l^2))",
                "-(0.5*(2*(0.25*m*r^2 + m*l^2) - 0.5*m*r^2) - 0.5*(0.5*m*r^2 + 0.25*m*r^2 + m*l^2 - 0.25*m*r^2 - m*l^2))/(0.5*(0.5*m*r^2 + 0.25*m*r^2 + m*l^2 - 0.25*m*r^2 - m*l^2) + 0.5*(2*(0.25*m*r^2 + m*l^2) - 0.5*m*r^2))",
                "-2*m*l*g/(m*l^2 + 0.25*m*r^2)",
                "2*m*l*g/(m*l^2 + 0.25*m*r^2)",
                "-(m*l^2 - 0.25*m*r^2)/(m*l^2 + 0.25*m*r^2)",
                "(m*l^2 - 0.25*m*r^2)/(m*l^2 + 0.25*m*r^2)",
                "2*l",
                "-4*l",
                "-2*l",
            ];
            for (name, value) in names.into_iter().zip(constants) {
                if !value.is_finite() {
                    let given: [_; 4] = ::core::array::from_fn(|n| (
                        HeavyTopParams::NAMES[n],
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
        pub fn cast<T: ::pendulum_core::real::Real>(&self) -> HeavyTop<T> {
            HeavyTop {
                params: self.params,
                constants: self.constants.map(T::from_f64),
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> HeavyTop<T> {
        /// The parameters that the model was built from.
        pub fn params(&self) -> &HeavyTopParams {
            &self.params
        }
        /// The model with other parameters, in the same number type. Its constants are computed anew.
        ///
        /// # Errors
        ///
        /// Those of `new`.
        pub fn with_params(
            &self,
            params: HeavyTopParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            Ok(<HeavyTop>::new(params)?.cast())
        }
    }
    impl HeavyTop {
        ///The first place of `o` in the state, whose components stand in 1.
        pub const O: usize = 0;
        ///The first place of `dot(o)` in the state, whose components stand in rad/s.
        pub const DOT_O: usize = 4;
        /// The number of degrees of freedom, and of rates; a quaternion has one component more.
        pub const DOF: usize = 3;
        /// The names of the coordinates, in the order in which their rates stand in the state; of an orientation the axes of its angular velocity.
        pub const COORDINATES: [&'static str; 3] = ["o.x", "o.y", "o.z"];
        /// Counted operations of each generated function, in the form that it has and in others.
        pub const COST: ::pendulum_core::Cost = ::pendulum_core::Cost::new(
            &[
                (
                    "rhs",
                    ::pendulum_core::FunctionCost::new(
                            "recursion, L^T D L",
                            ::pendulum_core::Operations::new(13, 26, 0, 0, 0, 4),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first, L^T D L",
                                    ::pendulum_core::Operations::new(13, 27, 0, 0, 0, 5),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, L^T D L",
                                    ::pendulum_core::Operations::new(13, 27, 0, 0, 0, 5),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L",
                                    ::pendulum_core::Operations::new(13, 27, 0, 0, 0, 5),
                                ),
                            ],
                        ),
                ),
                (
                    "jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first, L^T D L, derived and expanded",
                            ::pendulum_core::Operations::new(19, 41, 0, 0, 0, 5),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, L^T D L, derived and expanded",
                                    ::pendulum_core::Operations::new(19, 41, 0, 0, 0, 5),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L, derived and expanded",
                                    ::pendulum_core::Operations::new(19, 41, 0, 0, 0, 5),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, L^T D L, derived in the graph",
                                    ::pendulum_core::Operations::new(20, 47, 0, 0, 0, 4),
                                ),
                            ],
                        ),
                ),
                (
                    "kinetic",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(2, 5, 0, 0, 0, 4),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(2, 5, 0, 0, 0, 4),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(2, 5, 0, 0, 0, 4),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(2, 7, 0, 0, 0, 5),
                                ),
                            ],
                        ),
                ),
                (
                    "potential",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(2, 3, 0, 0, 0, 4),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(2, 3, 0, 0, 0, 4),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(2, 3, 0, 0, 0, 4),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(2, 3, 0, 0, 0, 4),
                                ),
                            ],
                        ),
                ),
                (
                    "momentum",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(0, 3, 0, 0, 0, 1),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(0, 3, 0, 0, 0, 1),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(0, 3, 0, 0, 0, 1),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(2, 6, 0, 0, 0, 2),
                                ),
                            ],
                        ),
                ),
                (
                    "middle",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, expanded",
                            ::pendulum_core::Operations::new(4, 8, 0, 0, 0, 4),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "as declared",
                                    ::pendulum_core::Operations::new(4, 9, 0, 0, 0, 4),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(4, 9, 0, 0, 0, 4),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(4, 9, 0, 0, 0, 4),
                                ),
                            ],
                        ),
                ),
                (
                    "middle_rate",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(11, 21, 0, 0, 0, 6),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(11, 21, 0, 0, 0, 6),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(11, 23, 0, 0, 0, 6),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "as declared",
                                    ::pendulum_core::Operations::new(15, 29, 0, 0, 0, 9),
                                ),
                            ],
                        ),
                ),
                (
                    "middle_and_jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, expanded",
                            ::pendulum_core::Operations::new(4, 14, 0, 0, 0, 4),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(4, 17, 0, 0, 0, 4),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(4, 17, 0, 0, 0, 4),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "as declared",
                                    ::pendulum_core::Operations::new(4, 19, 0, 0, 0, 4),
                                ),
                            ],
                        ),
                ),
                (
                    "outputs",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, expanded",
                            ::pendulum_core::Operations::new(4, 8, 0, 0, 0, 4),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "as declared",
                                    ::pendulum_core::Operations::new(4, 9, 0, 0, 0, 4),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(4, 9, 0, 0, 0, 4),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(4, 9, 0, 0, 0, 4),
                                ),
                            ],
                        ),
                ),
                (
                    "output_rates",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(11, 21, 0, 0, 0, 6),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(11, 21, 0, 0, 0, 6),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(11, 23, 0, 0, 0, 6),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "as declared",
                                    ::pendulum_core::Operations::new(15, 29, 0, 0, 0, 9),
                                ),
                            ],
                        ),
                ),
                (
                    "outputs_and_jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, expanded",
                            ::pendulum_core::Operations::new(4, 14, 0, 0, 0, 4),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(4, 17, 0, 0, 0, 4),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(4, 17, 0, 0, 0, 4),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "as declared",
                                    ::pendulum_core::Operations::new(4, 19, 0, 0, 0, 4),
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
                        "o",
                        ::pendulum_core::SlotKind::Quaternion,
                        0..4,
                        4..7,
                    ),
                ],
            )
            .autonomous();
        /// The equations of motion as text.
        pub const EQUATIONS: &'static str = "A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints\n\nA[o.x, o.x] = m*l^2 + 0.25*m*r^2\nA[o.y, o.y] = m*l^2 + 0.25*m*r^2\nA[o.z, o.z] = 0.5*m*r^2\nb[o.x] = -((m*l^2 - 0.25*m*r^2)*dot(o).y*dot(o).z + 2*m*l*g*o.x*o.w + 2*m*l*g*o.y*o.z)\nb[o.y] = (m*l^2 - 0.25*m*r^2)*dot(o).x*dot(o).z + 2*m*l*g*o.x*o.z - 2*m*l*g*o.y*o.w\n";
        ///The names of the components of all outputs.
        pub const OUTPUTS: [&'static str; 3] = ["middle.x", "middle.y", "middle.z"];
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::System<T, 7> for HeavyTop<T> {
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn rhs(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 7>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 7> {
            let [qw_o, qx_o, qy_o, qz_o, qdx_o, qdy_o, qdz_o] = x.data.0[0];
            let k10 = self.constants[10];
            let k11 = self.constants[11];
            let k12 = self.constants[12];
            let k13 = self.constants[13];
            let t0 = T::from_f64(0.5) * qx_o;
            let t1 = T::from_f64(0.5) * qy_o;
            let t2 = T::from_f64(0.5) * qz_o;
            let t3 = T::from_f64(0.5) * qw_o;
            ::pendulum_core::nalgebra::SVector::from([
                -(qdx_o * t0 + qdy_o * t1 + qdz_o * t2),
                qdx_o * t3 - qdy_o * t2 + qdz_o * t1,
                qdx_o * t2 + qdy_o * t3 - qdz_o * t0,
                qdy_o * t0 - qdx_o * t1 + qdz_o * t3,
                k12 * (qdy_o * qdz_o) - k10 * (qy_o * qz_o + qx_o * qw_o),
                k11 * (qz_o * qx_o - qy_o * qw_o) + k13 * (qdz_o * qdx_o),
                T::from_f64(0.0),
            ])
        }
        #[inline]
        fn layout(
            &self,
        ) -> ::core::option::Option<&'static ::pendulum_core::StateLayout> {
            Some(&<HeavyTop>::LAYOUT)
        }
        #[inline]
        fn project(&self, t: T, x: &mut ::pendulum_core::nalgebra::SVector<T, 7>) {
            let norm = (x[0] * x[0] + x[1] * x[1] + x[2] * x[2] + x[3] * x[3]).sqrt();
            x[0] /= norm;
            x[1] /= norm;
            x[2] /= norm;
            x[3] /= norm;
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Jacobian<T, 7>
    for HeavyTop<T> {
        #[inline]
        fn jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 7>,
        ) -> ::pendulum_core::nalgebra::SMatrix<T, 7, 7> {
            self.rhs_and_jacobian(t, x).1
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn rhs_and_jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 7>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 7>,
            ::pendulum_core::nalgebra::SMatrix<T, 7, 7>,
        ) {
            let [qw_o, qx_o, qy_o, qz_o, qdx_o, qdy_o, qdz_o] = x.data.0[0];
            let k5 = self.constants[5];
            let k6 = self.constants[6];
            let k8 = self.constants[8];
            let k9 = self.constants[9];
            let k14 = self.constants[14];
            let k15 = self.constants[15];
            let k16 = self.constants[16];
            let k17 = self.constants[17];
            let t0 = k15 * qx_o;
            let t1 = k14 * qz_o;
            let t2 = k15 * qz_o;
            let t3 = k14 * qx_o;
            let t4 = k16 * qdz_o;
            let t5 = k17 * qdz_o;
            let t6 = T::from_f64(0.5) * qx_o;
            let t7 = T::from_f64(0.5) * qy_o;
            let t8 = T::from_f64(0.5) * qz_o;
            let t9 = -(qdx_o * t6 + qdy_o * t7 + qdz_o * t8);
            let t10 = T::from_f64(0.5) * qw_o;
            let t11 = qdx_o * t10 - qdy_o * t8 + qdz_o * t7;
            let t12 = qdx_o * t8 + qdy_o * t10 - qdz_o * t6;
            let t13 = qdy_o * t6 - qdx_o * t7 + qdz_o * t10;
            let t14 = -t6;
            let t15 = -t7;
            let t16 = -t8;
            let t17 = k5 * qdy_o;
            let t18 = k9 * (qdz_o * t17 + k6 * (qy_o * qz_o + qx_o * qw_o));
            let t19 = k9 * t17;
            let t20 = k5 * qdx_o;
            let t21 = k8 * (qdz_o * t20 + k6 * (qz_o * qx_o - qy_o * qw_o));
            let t22 = k8 * t20;
            let t23 = T::from_f64(0.5) * qdx_o;
            let t24 = -t23;
            let t25 = T::from_f64(0.5) * qdy_o;
            let t26 = -t25;
            let t27 = T::from_f64(0.5) * qdz_o;
            let t28 = -t27;
            let t29 = k15 * qy_o;
            let t30 = k15 * qw_o;
            (
                ::pendulum_core::nalgebra::SVector::from([
                    t9,
                    t11,
                    t12,
                    t13,
                    t18,
                    t21,
                    T::from_f64(0.0),
                ]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [T::from_f64(0.0), t23, t25, t27, t0, t29, T::from_f64(0.0)],
                    [t24, T::from_f64(0.0), t28, t25, t30, t1, T::from_f64(0.0)],
                    [t26, t27, T::from_f64(0.0), t24, t2, t30, T::from_f64(0.0)],
                    [t28, t26, t23, T::from_f64(0.0), t29, t3, T::from_f64(0.0)],
                    [t14, t10, t8, t15, T::from_f64(0.0), t4, T::from_f64(0.0)],
                    [t15, t16, t10, t6, t5, T::from_f64(0.0), T::from_f64(0.0)],
                    [t16, t7, t14, t10, t19, t22, T::from_f64(0.0)],
                ]),
            )
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn time_derivative(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 7>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 7> {
            ::pendulum_core::nalgebra::SVector::from([
                T::from_f64(0.0),
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
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Energy<T, 7> for HeavyTop<T> {
        #[inline]
        fn kinetic(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 7>) -> T {
            let [_, _, _, _, qdx_o, qdy_o, qdz_o] = x.data.0[0];
            let k1 = self.constants[1];
            let k7 = self.constants[7];
            k1 * qdz_o * qdz_o + k7 * (qdy_o * qdy_o + qdx_o * qdx_o)
        }
        #[inline]
        fn potential(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 7>) -> T {
            let [_, qx_o, qy_o, _, _, _, _] = x.data.0[0];
            let k4 = self.constants[4];
            let k6 = self.constants[6];
            k4 - k6 * (qx_o * qx_o + qy_o * qy_o)
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> HeavyTop<T> {
        ///The momenta of the coordinates: the mass matrix times their rates.
        #[inline]
        pub fn momentum(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 7>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 3> {
            let [_, _, _, _, qdx_o, qdy_o, qdz_o] = x.data.0[0];
            let k2 = self.constants[2];
            let k3 = self.constants[3];
            ::pendulum_core::nalgebra::SVector::from([
                qdx_o * k3,
                qdy_o * k3,
                qdz_o * k2,
            ])
        }
        ///Output `middle`.
        #[inline]
        pub fn middle(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 7>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 3> {
            let [qw_o, qx_o, qy_o, qz_o, _, _, _] = x.data.0[0];
            let k0 = self.constants[0];
            let k18 = self.constants[18];
            let t0 = qx_o * k18;
            let t1 = qy_o * k18;
            ::pendulum_core::nalgebra::SVector::from([
                qz_o * t0 + qw_o * t1,
                qz_o * t1 - qw_o * t0,
                k0 - qx_o * t0 - qy_o * t1,
            ])
        }
        ///The rate of `middle` along the motion.
        #[inline]
        pub fn middle_rate(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 7>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 3> {
            let [qw_o, qx_o, qy_o, qz_o, qdx_o, qdy_o, _] = x.data.0[0];
            let k0 = self.constants[0];
            let k18 = self.constants[18];
            let t0 = qz_o * qw_o;
            let t1 = qx_o * qy_o;
            let t2 = qx_o * qx_o - qy_o * qy_o;
            let t3 = qz_o * qz_o - qw_o * qw_o;
            let t4 = qx_o * (qz_o * qdy_o - qdx_o * qw_o)
                - qy_o * (qdx_o * qz_o + qw_o * qdy_o);
            ::pendulum_core::nalgebra::SVector::from([
                k0 * (T::from_f64(2.0) * qdx_o * (t0 - t1) + qdy_o * (t2 - t3)),
                k0 * (T::from_f64(2.0) * qdy_o * (t0 + t1) + qdx_o * (t2 + t3)),
                k18 * t4,
            ])
        }
        ///The value of `middle`, and its derivatives by the state: a row for each component, column by column for a matrix.
        #[inline]
        pub fn middle_and_jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 7>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 3>,
            ::pendulum_core::nalgebra::SMatrix<T, 3, 7>,
        ) {
            let [qw_o, qx_o, qy_o, qz_o, _, _, _] = x.data.0[0];
            let k0 = self.constants[0];
            let k18 = self.constants[18];
            let k19 = self.constants[19];
            let k20 = self.constants[20];
            let t0 = k20 * qx_o;
            let t1 = k20 * qw_o;
            let t2 = k19 * qx_o;
            let t3 = k18 * qw_o;
            let t4 = k19 * qy_o;
            let t5 = k18 * qx_o;
            let t6 = k18 * qy_o;
            let t7 = qz_o * t5 + qw_o * t6;
            let t8 = qz_o * t6 - t5 * qw_o;
            let t9 = k0 - qx_o * t5 - qy_o * t6;
            let t10 = k18 * qz_o;
            (
                ::pendulum_core::nalgebra::SVector::from([t7, t8, t9]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [t6, t0, T::from_f64(0.0)],
                    [t10, t1, t2],
                    [t3, t10, t4],
                    [t5, t6, T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
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
            x: &::pendulum_core::nalgebra::SVector<T, 7>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 3> {
            let [qw_o, qx_o, qy_o, qz_o, _, _, _] = x.data.0[0];
            let k0 = self.constants[0];
            let k18 = self.constants[18];
            let t0 = qx_o * k18;
            let t1 = qy_o * k18;
            ::pendulum_core::nalgebra::SVector::from([
                qz_o * t0 + qw_o * t1,
                qz_o * t1 - qw_o * t0,
                k0 - qx_o * t0 - qy_o * t1,
            ])
        }
        ///The rate of all outputs along the motion.
        #[inline]
        pub fn output_rates(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 7>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 3> {
            let [qw_o, qx_o, qy_o, qz_o, qdx_o, qdy_o, _] = x.data.0[0];
            let k0 = self.constants[0];
            let k18 = self.constants[18];
            let t0 = qz_o * qw_o;
            let t1 = qx_o * qy_o;
            let t2 = qx_o * qx_o - qy_o * qy_o;
            let t3 = qz_o * qz_o - qw_o * qw_o;
            let t4 = qx_o * (qz_o * qdy_o - qdx_o * qw_o)
                - qy_o * (qdx_o * qz_o + qw_o * qdy_o);
            ::pendulum_core::nalgebra::SVector::from([
                k0 * (T::from_f64(2.0) * qdx_o * (t0 - t1) + qdy_o * (t2 - t3)),
                k0 * (T::from_f64(2.0) * qdy_o * (t0 + t1) + qdx_o * (t2 + t3)),
                k18 * t4,
            ])
        }
        ///The value of all outputs, and its derivatives by the state: a row for each component, column by column for a matrix.
        #[inline]
        pub fn outputs_and_jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 7>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 3>,
            ::pendulum_core::nalgebra::SMatrix<T, 3, 7>,
        ) {
            let [qw_o, qx_o, qy_o, qz_o, _, _, _] = x.data.0[0];
            let k0 = self.constants[0];
            let k18 = self.constants[18];
            let k19 = self.constants[19];
            let k20 = self.constants[20];
            let t0 = k20 * qx_o;
            let t1 = k20 * qw_o;
            let t2 = k19 * qx_o;
            let t3 = k18 * qw_o;
            let t4 = k19 * qy_o;
            let t5 = k18 * qx_o;
            let t6 = k18 * qy_o;
            let t7 = qz_o * t5 + qw_o * t6;
            let t8 = qz_o * t6 - t5 * qw_o;
            let t9 = k0 - qx_o * t5 - qy_o * t6;
            let t10 = k18 * qz_o;
            (
                ::pendulum_core::nalgebra::SVector::from([t7, t8, t9]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [t6, t0, T::from_f64(0.0)],
                    [t10, t1, t2],
                    [t3, t10, t4],
                    [t5, t6, T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                ]),
            )
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::CastJacobian<7> for HeavyTop {
        #[inline]
        fn with_jacobian<T: ::pendulum_core::real::Real>(
            model: &HeavyTop<T>,
        ) -> &impl ::pendulum_core::Jacobian<T, 7> {
            model
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::Cast<7> for HeavyTop {
        type In<T: ::pendulum_core::real::Real> = HeavyTop<T>;
        fn cast<T: ::pendulum_core::real::Real>(&self) -> HeavyTop<T> {
            HeavyTop::cast(self)
        }
        #[inline]
        fn gather<'m, T: ::pendulum_core::real::lanes::Lanes>(
            models: impl ::core::ops::Fn(usize) -> &'m Self,
        ) -> HeavyTop<T>
        where
            Self: 'm,
        {
            let scalar = <<T as ::pendulum_core::real::lanes::Lanes>::Scalar as ::pendulum_core::real::Real>::from_f64;
            HeavyTop {
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
use __HeavyTop::{HeavyTop, HeavyTopParams};
