#[allow(non_snake_case)]
mod __TumblingBody {
    ///Parameters of [`TumblingBody`].
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct TumblingBodyParams {}
    impl ::core::default::Default for TumblingBodyParams {
        #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
        fn default() -> Self {
            Self {}
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl TumblingBodyParams {
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
    /// A stem on the middle of a bar, without gravity.
    ///
    /**# Equations of motion

```text
A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints

A[p.x, p.x] = 0.4
A[p.x, o.y] = -(0.008*o.x*o.z + 0.008*o.y*o.w)
A[p.x, o.z] = 0.008*o.x*o.y - 0.008*o.z*o.w
A[p.y, p.y] = 0.4
A[p.y, o.y] = 0.008*o.x*o.w - 0.008*o.y*o.z
A[p.y, o.z] = 0.004 - 0.008*o.x^2 - 0.008*o.z^2
A[p.z, p.z] = 0.4
A[p.z, o.y] = 0.008*o.x^2 + 0.008*o.y^2 - 0.004
A[p.z, o.z] = 0.008*o.x*o.w + 0.008*o.y*o.z
A[o.x, o.x] = 0.0010125
A[o.y, o.y] = 277/1200000
A[o.z, o.z] = 367/300000
b[p.x] = 0.008*o.x*o.y*dot(o).x*dot(o).y + 0.008*o.x*o.z*dot(o).x*dot(o).z + 0.008*o.y*o.w*dot(o).x*dot(o).z + 0.008*o.y^2*dot(o).y^2 + 0.008*o.y^2*dot(o).z^2 + 0.008*o.z^2*dot(o).y^2 + 0.008*o.z^2*dot(o).z^2 - 0.008*o.z*o.w*dot(o).x*dot(o).y - 0.004*dot(o).y^2 - 0.004*dot(o).z^2
b[p.y] = 0.004*dot(o).x*dot(o).y + 0.008*o.y*o.z*dot(o).x*dot(o).z - 0.008*o.x*o.y*dot(o).y^2 - 0.008*o.x*o.y*dot(o).z^2 - 0.008*o.x*o.w*dot(o).x*dot(o).z - 0.008*o.x^2*dot(o).x*dot(o).y - 0.008*o.z*o.w*dot(o).y^2 - 0.008*o.z*o.w*dot(o).z^2 - 0.008*o.z^2*dot(o).x*dot(o).y
b[p.z] = 0.004*dot(o).x*dot(o).z + 0.008*o.x*o.w*dot(o).x*dot(o).y + 0.008*o.y*o.z*dot(o).x*dot(o).y + 0.008*o.y*o.w*dot(o).y^2 + 0.008*o.y*o.w*dot(o).z^2 - 0.008*o.x*o.z*dot(o).y^2 - 0.008*o.x*o.z*dot(o).z^2 - 0.008*o.x^2*dot(o).x*dot(o).z - 0.008*o.y^2*dot(o).x*dot(o).z
b[o.x] = 0.0009925*dot(o).y*dot(o).z
b[o.y] = -253/1200000*dot(o).x*dot(o).z
b[o.z] = -469/600000*dot(o).x*dot(o).y
```
*/
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct TumblingBody<T = f64> {
        params: TumblingBodyParams,
        constants: [T; 0],
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl TumblingBody {
        /// Builds the model: checks the parameters, and computes once whatever depends on them alone.
        ///
        /// # Errors
        ///
        /// The first parameter, or combination of parameters, that is not finite or that no rigid body can have.
        pub fn new(
            params: TumblingBodyParams,
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
            for (name, value) in TumblingBodyParams::NAMES.into_iter().zip(given) {
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
                        TumblingBodyParams::NAMES[n],
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
        /// The same model in another number type, such as `f32`. Its constants are computed in double precision and
        /// then rounded.
        pub fn cast<T: ::pendulum_core::real::Real>(&self) -> TumblingBody<T> {
            TumblingBody {
                params: self.params,
                constants: self.constants.map(T::from_f64),
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> TumblingBody<T> {
        /// The parameters that the model was built from.
        pub fn params(&self) -> &TumblingBodyParams {
            &self.params
        }
        /// The model with other parameters, in the same number type. Its constants are computed anew.
        ///
        /// # Errors
        ///
        /// Those of `new`.
        pub fn with_params(
            &self,
            params: TumblingBodyParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            Ok(<TumblingBody>::new(params)?.cast())
        }
    }
    impl TumblingBody {
        ///The place of `p.x` in the state, where it stands in m.
        pub const P_X: usize = 0;
        ///The place of `dot(p.x)` in the state, where it stands in m/s.
        pub const DOT_P_X: usize = 7;
        ///The place of `p.y` in the state, where it stands in m.
        pub const P_Y: usize = 1;
        ///The place of `dot(p.y)` in the state, where it stands in m/s.
        pub const DOT_P_Y: usize = 8;
        ///The place of `p.z` in the state, where it stands in m.
        pub const P_Z: usize = 2;
        ///The place of `dot(p.z)` in the state, where it stands in m/s.
        pub const DOT_P_Z: usize = 9;
        ///The first place of `o` in the state, whose components stand in 1.
        pub const O: usize = 3;
        ///The first place of `dot(o)` in the state, whose components stand in rad/s.
        pub const DOT_O: usize = 10;
        /// The number of degrees of freedom, and of rates; a quaternion has one component more.
        pub const DOF: usize = 6;
        /// The names of the coordinates, in the order in which their rates stand in the state; of an orientation the axes of its angular velocity.
        pub const COORDINATES: [&'static str; 6] = [
            "p.x",
            "p.y",
            "p.z",
            "o.x",
            "o.y",
            "o.z",
        ];
        /// Counted operations of each generated function, in the form that it has and in others.
        pub const COST: ::pendulum_core::Cost = ::pendulum_core::Cost::new(
            &[
                (
                    "rhs",
                    ::pendulum_core::FunctionCost::new(
                            "recursion, L^T D L",
                            ::pendulum_core::Operations::new(60, 105, 3, 0, 0, 37),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L",
                                    ::pendulum_core::Operations::new(66, 102, 3, 0, 0, 36),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first, L^T D L",
                                    ::pendulum_core::Operations::new(63, 112, 3, 0, 0, 36),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, L^T D L",
                                    ::pendulum_core::Operations::new(63, 112, 3, 0, 0, 36),
                                ),
                            ],
                        ),
                ),
                (
                    "jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of parameters first, L^T D L, derived and expanded",
                            ::pendulum_core::Operations::new(241, 357, 3, 0, 0, 57),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, L^T D L, derived in the graph",
                                    ::pendulum_core::Operations::new(248, 358, 3, 0, 0, 59),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L, derived in the graph",
                                    ::pendulum_core::Operations::new(264, 344, 3, 0, 0, 59),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first, L^T D L, derived and expanded",
                                    ::pendulum_core::Operations::new(244, 368, 3, 0, 0, 59),
                                ),
                            ],
                        ),
                ),
                (
                    "kinetic",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, expanded",
                            ::pendulum_core::Operations::new(18, 28, 0, 0, 0, 11),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(18, 30, 0, 0, 0, 10),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(18, 31, 0, 0, 0, 14),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(25, 44, 0, 0, 0, 16),
                                ),
                            ],
                        ),
                ),
                (
                    "potential",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(0, 0, 0, 0, 0, 0),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(0, 0, 0, 0, 0, 0),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(0, 0, 0, 0, 0, 0),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(0, 0, 0, 0, 0, 0),
                                ),
                            ],
                        ),
                ),
                (
                    "tip",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(7, 9, 0, 0, 0, 5),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(7, 9, 0, 0, 0, 4),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(7, 9, 0, 0, 0, 4),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(7, 9, 0, 0, 0, 4),
                                ),
                            ],
                        ),
                ),
                (
                    "tip_rate",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(14, 21, 0, 0, 0, 6),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(14, 21, 0, 0, 0, 6),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(14, 23, 0, 0, 0, 7),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "as declared",
                                    ::pendulum_core::Operations::new(18, 29, 0, 0, 0, 10),
                                ),
                            ],
                        ),
                ),
                (
                    "tip_and_jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, expanded",
                            ::pendulum_core::Operations::new(7, 14, 0, 0, 0, 4),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "as declared",
                                    ::pendulum_core::Operations::new(7, 17, 0, 0, 0, 5),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(7, 17, 0, 0, 0, 4),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(7, 17, 0, 0, 0, 4),
                                ),
                            ],
                        ),
                ),
                (
                    "outputs",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(7, 9, 0, 0, 0, 5),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(7, 9, 0, 0, 0, 4),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(7, 9, 0, 0, 0, 4),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(7, 9, 0, 0, 0, 4),
                                ),
                            ],
                        ),
                ),
                (
                    "output_rates",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(14, 21, 0, 0, 0, 6),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(14, 21, 0, 0, 0, 6),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(14, 23, 0, 0, 0, 7),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "as declared",
                                    ::pendulum_core::Operations::new(18, 29, 0, 0, 0, 10),
                                ),
                            ],
                        ),
                ),
                (
                    "outputs_and_jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, expanded",
                            ::pendulum_core::Operations::new(7, 14, 0, 0, 0, 4),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "as declared",
                                    ::pendulum_core::Operations::new(7, 17, 0, 0, 0, 5),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(7, 17, 0, 0, 0, 4),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(7, 17, 0, 0, 0, 4),
                                ),
                            ],
                        ),
                ),
                (
                    "turns",
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
            ],
        );
        /// What each part of the state is.
        pub const LAYOUT: ::pendulum_core::StateLayout = ::pendulum_core::StateLayout::new(
                &[
                    ::pendulum_core::Slot::new(
                            "p.x",
                            ::pendulum_core::SlotKind::Length,
                            0..1,
                            7..8,
                        )
                        .cyclic(),
                    ::pendulum_core::Slot::new(
                            "p.y",
                            ::pendulum_core::SlotKind::Length,
                            1..2,
                            8..9,
                        )
                        .cyclic(),
                    ::pendulum_core::Slot::new(
                            "p.z",
                            ::pendulum_core::SlotKind::Length,
                            2..3,
                            9..10,
                        )
                        .cyclic(),
                    ::pendulum_core::Slot::new(
                        "o",
                        ::pendulum_core::SlotKind::Quaternion,
                        3..7,
                        10..13,
                    ),
                ],
            )
            .autonomous();
        /// The equations of motion as text.
        pub const EQUATIONS: &'static str = "A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints\n\nA[p.x, p.x] = 0.4\nA[p.x, o.y] = -(0.008*o.x*o.z + 0.008*o.y*o.w)\nA[p.x, o.z] = 0.008*o.x*o.y - 0.008*o.z*o.w\nA[p.y, p.y] = 0.4\nA[p.y, o.y] = 0.008*o.x*o.w - 0.008*o.y*o.z\nA[p.y, o.z] = 0.004 - 0.008*o.x^2 - 0.008*o.z^2\nA[p.z, p.z] = 0.4\nA[p.z, o.y] = 0.008*o.x^2 + 0.008*o.y^2 - 0.004\nA[p.z, o.z] = 0.008*o.x*o.w + 0.008*o.y*o.z\nA[o.x, o.x] = 0.0010125\nA[o.y, o.y] = 277/1200000\nA[o.z, o.z] = 367/300000\nb[p.x] = 0.008*o.x*o.y*dot(o).x*dot(o).y + 0.008*o.x*o.z*dot(o).x*dot(o).z + 0.008*o.y*o.w*dot(o).x*dot(o).z + 0.008*o.y^2*dot(o).y^2 + 0.008*o.y^2*dot(o).z^2 + 0.008*o.z^2*dot(o).y^2 + 0.008*o.z^2*dot(o).z^2 - 0.008*o.z*o.w*dot(o).x*dot(o).y - 0.004*dot(o).y^2 - 0.004*dot(o).z^2\nb[p.y] = 0.004*dot(o).x*dot(o).y + 0.008*o.y*o.z*dot(o).x*dot(o).z - 0.008*o.x*o.y*dot(o).y^2 - 0.008*o.x*o.y*dot(o).z^2 - 0.008*o.x*o.w*dot(o).x*dot(o).z - 0.008*o.x^2*dot(o).x*dot(o).y - 0.008*o.z*o.w*dot(o).y^2 - 0.008*o.z*o.w*dot(o).z^2 - 0.008*o.z^2*dot(o).x*dot(o).y\nb[p.z] = 0.004*dot(o).x*dot(o).z + 0.008*o.x*o.w*dot(o).x*dot(o).y + 0.008*o.y*o.z*dot(o).x*dot(o).y + 0.008*o.y*o.w*dot(o).y^2 + 0.008*o.y*o.w*dot(o).z^2 - 0.008*o.x*o.z*dot(o).y^2 - 0.008*o.x*o.z*dot(o).z^2 - 0.008*o.x^2*dot(o).x*dot(o).z - 0.008*o.y^2*dot(o).x*dot(o).z\nb[o.x] = 0.0009925*dot(o).y*dot(o).z\nb[o.y] = -253/1200000*dot(o).x*dot(o).z\nb[o.z] = -469/600000*dot(o).x*dot(o).y\n";
        ///The names of the components of all outputs.
        pub const OUTPUTS: [&'static str; 3] = ["tip.x", "tip.y", "tip.z"];
        ///The names of the events.
        pub const EVENTS: [&'static str; 1] = ["turns"];
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::System<T, 13>
    for TumblingBody<T> {
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn rhs(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 13>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 13> {
            let [_, _, _, qw_o, qx_o, qy_o, qz_o, qdx_p, qdy_p, qdz_p, qdx_o, qdy_o,
            qdz_o] = x.data.0[0];
            let t0 = T::from_f64(-0.980246913580247) * (qdy_o * qdz_o);
            let t1 = T::from_f64(0.5) * qx_o;
            let t2 = T::from_f64(0.5) * qy_o;
            let t3 = T::from_f64(0.5) * qz_o;
            let t4 = -(qdx_o * t1 + qdy_o * t2 + qdz_o * t3);
            let t5 = T::from_f64(0.5) * qw_o;
            let t6 = qdx_o * t5 - qdy_o * t3 + qdz_o * t2;
            let t7 = qdx_o * t3 + qdy_o * t5 - qdz_o * t1;
            let t8 = qdy_o * t1 - qdx_o * t2 + qdz_o * t5;
            let t9 = qx_o * qy_o;
            let t10 = qz_o * qw_o;
            let t11 = t9 - t10;
            let t12 = T::from_f64(0.008) * t11;
            let t13 = qy_o * qz_o;
            let t14 = qx_o * qw_o;
            let t15 = t13 + t14;
            let t16 = t13 - t14;
            let t17 = T::from_f64(6.539509536784741) * t15;
            let t18 = qx_o * qz_o;
            let t19 = qy_o * qw_o;
            let t20 = t18 + t19;
            let t21 = T::from_f64(0.008) * t20;
            let t22 = qx_o * qx_o;
            let t23 = qy_o * qy_o;
            let t24 = T::from_f64(1.0) - T::from_f64(2.0) * (t22 + t23);
            let t25 = T::from_f64(17.32851985559567) * t24;
            let t26 = t12 * t17 + t21 * t25;
            let t27 = T::from_f64(-1.0)
                / (T::from_f64(0.4) - T::from_f64(0.008) * t15 * t17
                    - T::from_f64(0.004) * t24 * t25);
            let t28 = t26 * t27;
            let t29 = qz_o * qz_o;
            let t30 = T::from_f64(1.0) - T::from_f64(2.0) * (t22 + t29);
            let t31 = T::from_f64(0.004) * t30;
            let t32 = T::from_f64(0.008) * t16;
            let t33 = t17 * t31 + t25 * t32;
            let t34 = t27 * t33;
            let t35 = T::from_f64(3.2697547683923704) * t30;
            let t36 = T::from_f64(34.65703971119134) * t16;
            let t37 = T::from_f64(-1.0)
                / (T::from_f64(0.4) + t33 * t34 - t31 * t35 - t32 * t36);
            let t38 = t26 * t34 - t12 * t35 - t21 * t36;
            let t39 = t38 * t37;
            let t40 = T::from_f64(6.539509536784741) * t11;
            let t41 = T::from_f64(34.65703971119134) * t20;
            let t42 = T::from_f64(0.4) + t26 * t28 + t38 * t39 - t12 * t40 - t21 * t41;
            let t43 = qdx_o * qdz_o;
            let t44 = T::from_f64(-0.00021083333333333333) * t43;
            let t45 = T::from_f64(0.004) * t43;
            let t46 = qdx_o * qdy_o;
            let t47 = T::from_f64(0.004) * t46;
            let t48 = T::from_f64(-0.0007816666666666666) * t46;
            let t49 = T::from_f64(0.004) * (qdy_o * qdy_o + qdz_o * qdz_o);
            let t50 = t30 * t47 + t36 * t44
                + T::from_f64(2.0) * (t16 * t45 - t49 * (t9 + t10));
            let t51 = t24 * t45 + t25 * t44
                + T::from_f64(2.0) * (t15 * t47 - t49 * (t18 - t19));
            let t52 = t51 - t17 * t48;
            let t53 = t50 - t35 * t48 - t34 * t52;
            let t54 = t41 * t44 + t39 * t53 + T::from_f64(2.0) * (t11 * t47 + t20 * t45);
            let t55 = t54 - (T::from_f64(1.0) - T::from_f64(2.0) * (t23 + t29)) * t49
                - t40 * t48 - t28 * t52;
            let t56 = T::from_f64(-1.0) / t42 * t55;
            let t57 = t37 * t53 + t39 * t56;
            let t58 = t27 * t52 - t28 * t56 - t34 * t57;
            let t59 = t41 * t56 + t36 * t57 + t25 * t58
                - T::from_f64(4332.129963898917) * t44;
            let t60 = -(T::from_f64(817.4386920980926) * t48 + t40 * t56 + t35 * t57
                + t17 * t58);
            ::pendulum_core::nalgebra::SVector::from([
                qdx_p,
                qdy_p,
                qdz_p,
                t4,
                t6,
                t7,
                t8,
                t56,
                t57,
                t58,
                t0,
                t59,
                t60,
            ])
        }
        #[inline]
        fn layout(
            &self,
        ) -> ::core::option::Option<&'static ::pendulum_core::StateLayout> {
            Some(&<TumblingBody>::LAYOUT)
        }
        #[inline]
        fn project(&self, t: T, x: &mut ::pendulum_core::nalgebra::SVector<T, 13>) {
            let norm = (x[3] * x[3] + x[4] * x[4] + x[5] * x[5] + x[6] * x[6]).sqrt();
            x[3] /= norm;
            x[4] /= norm;
            x[5] /= norm;
            x[6] /= norm;
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Jacobian<T, 13>
    for TumblingBody<T> {
        #[inline]
        fn jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 13>,
        ) -> ::pendulum_core::nalgebra::SMatrix<T, 13, 13> {
            self.rhs_and_jacobian(t, x).1
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn rhs_and_jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 13>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 13>,
            ::pendulum_core::nalgebra::SMatrix<T, 13, 13>,
        ) {
            let [_, _, _, qw_o, qx_o, qy_o, qz_o, qdx_p, qdy_p, qdz_p, qdx_o, qdy_o,
            qdz_o] = x.data.0[0];
            let t0 = -(T::from_f64(0.980246913580247) * qdz_o * qdy_o);
            let t1 = T::from_f64(-0.980246913580247) * qdz_o;
            let t2 = T::from_f64(-0.980246913580247) * qdy_o;
            let t3 = T::from_f64(0.5) * qx_o;
            let t4 = T::from_f64(0.5) * qy_o;
            let t5 = T::from_f64(0.5) * qz_o;
            let t6 = -(qdx_o * t3 + qdy_o * t4 + qdz_o * t5);
            let t7 = T::from_f64(0.5) * qw_o;
            let t8 = qdx_o * t7 - qdy_o * t5 + qdz_o * t4;
            let t9 = qdx_o * t5 + qdy_o * t7 - qdz_o * t3;
            let t10 = qdy_o * t3 - qdx_o * t4 + qdz_o * t7;
            let t11 = -t3;
            let t12 = -t4;
            let t13 = -t5;
            let t14 = qx_o * qz_o;
            let t15 = qy_o * qw_o;
            let t16 = t14 + t15;
            let t17 = t15 - t14;
            let t18 = T::from_f64(0.008) * t16;
            let t19 = qx_o * qx_o;
            let t20 = qy_o * qy_o;
            let t21 = T::from_f64(0.004) - T::from_f64(0.008) * (t19 + t20);
            let t22 = T::from_f64(4332.129963898917) * t21;
            let t23 = qx_o * qy_o;
            let t24 = qz_o * qw_o;
            let t25 = t23 - t24;
            let t26 = t23 + t24;
            let t27 = T::from_f64(0.008) * t25;
            let t28 = qy_o * qz_o;
            let t29 = qx_o * qw_o;
            let t30 = t28 + t29;
            let t31 = t28 - t29;
            let t32 = T::from_f64(6.539509536784741) * t30;
            let t33 = T::from_f64(0.008) * t30;
            let t34 = t18 * t22 + t27 * t32;
            let t35 = T::from_f64(-1.0) / (T::from_f64(0.4) - t32 * t33 - t21 * t22);
            let t36 = t34 * t35;
            let t37 = qz_o * qz_o;
            let t38 = T::from_f64(0.004) - T::from_f64(0.008) * (t19 + t37);
            let t39 = t20 + t37;
            let t40 = T::from_f64(0.008) * t31;
            let t41 = t32 * t38 + t22 * t40;
            let t42 = t35 * t41;
            let t43 = T::from_f64(34.65703971119134) * t31;
            let t44 = T::from_f64(817.4386920980926) * t38;
            let t45 = T::from_f64(-1.0)
                / (T::from_f64(0.4) + t41 * t42 - t38 * t44 - t43 * t40);
            let t46 = t34 * t42 - t18 * t43 - t27 * t44;
            let t47 = t46 * t45;
            let t48 = T::from_f64(6.539509536784741) * t25;
            let t49 = T::from_f64(34.65703971119134) * t16;
            let t50 = T::from_f64(0.4) + t34 * t36 + t46 * t47 - t27 * t48 - t18 * t49;
            let t51 = T::from_f64(-1.0) / t50;
            let t52 = qx_o * qdz_o - qw_o * qdy_o;
            let t53 = qdx_o * t52;
            let t54 = qdy_o * qdy_o + qdz_o * qdz_o;
            let t55 = qz_o * t54;
            let t56 = qx_o * qdy_o + qw_o * qdz_o;
            let t57 = qy_o * t54;
            let t58 = qdx_o * t56 + t57;
            let t59 = T::from_f64(0.0007816666666666666) * qdx_o;
            let t60 = qdy_o * t59;
            let t61 = T::from_f64(0.004) * qdx_o;
            let t62 = qw_o * t54;
            let t63 = qz_o * qdy_o - qy_o * qdz_o;
            let t64 = t62 + qdx_o * t63;
            let t65 = qdy_o * t61 + t44 * t60
                - T::from_f64(0.008) * (qz_o * t64 + qx_o * t58);
            let t66 = qdz_o * t61
                + T::from_f64(0.008) * (qy_o * t64 - qx_o * (t55 + t53)) + t32 * t60;
            let t67 = T::from_f64(0.00021083333333333333) * qdx_o;
            let t68 = qdz_o * t67;
            let t69 = t66 - t22 * t68;
            let t70 = t65 - t43 * t68 - t42 * t69;
            let t71 = T::from_f64(0.008) * (qz_o * (t53 + t55) + qy_o * t58) + t48 * t60
                + t47 * t70;
            let t72 = t51 * (t71 - T::from_f64(0.004) * t54 - t49 * t68 - t36 * t69);
            let t73 = t45 * t70 + t47 * t72;
            let t74 = t35 * t69 - t36 * t72 - t42 * t73;
            let t75 = T::from_f64(4332.129963898917) * t68 + t49 * t72 + t43 * t73
                + t22 * t74;
            let t76 = T::from_f64(817.4386920980926) * t60 - t48 * t72 - t44 * t73
                - t32 * t74;
            let t77 = t75 - qdx_o * qdz_o;
            let t78 = t76 + qdx_o * qdy_o;
            let t79 = qx_o * t54;
            let t80 = T::from_f64(0.5) * qdx_o;
            let t81 = -t80;
            let t82 = T::from_f64(0.5) * qdy_o;
            let t83 = -t82;
            let t84 = T::from_f64(0.5) * qdz_o;
            let t85 = -t84;
            let t86 = qy_o * t72;
            let t87 = qx_o * t73 - t86;
            let t88 = T::from_f64(0.008) * t87;
            let t89 = qx_o * t77;
            let t90 = qz_o * t72;
            let t91 = qx_o * t74 - t90;
            let t92 = T::from_f64(0.008) * t91;
            let t93 = qx_o * t78;
            let t94 = T::from_f64(0.008) * (t57 + t93) + t22 * t88 - t32 * t92;
            let t95 = T::from_f64(0.008) * (t89 - t55) + t43 * t88 - t44 * t92
                - t42 * t94;
            let t96 = qy_o * t77;
            let t97 = qz_o * t78;
            let t98 = t49 * t88 + t47 * t95 - T::from_f64(0.008) * (t96 + t97)
                - t48 * t92;
            let t99 = t51 * (t98 - t36 * t94);
            let t100 = t45 * t95 + t47 * t99;
            let t101 = t35 * t94 - t36 * t99 - t42 * t100;
            let t102 = t49 * t99 + t43 * t100 + t22 * t101
                - T::from_f64(34.65703971119134) * t87;
            let t103 = -(T::from_f64(6.539509536784741) * t91 + t48 * t99 + t44 * t100
                + t32 * t101);
            let t104 = qy_o * t78;
            let t105 = qw_o * t78;
            let t106 = qz_o * t77;
            let t107 = T::from_f64(0.016) * qx_o;
            let t108 = t74 * t107 + T::from_f64(0.008) * (qw_o * t73 - t90);
            let t109 = T::from_f64(0.008) * (t86 + qw_o * t74) - t73 * t107;
            let t110 = qw_o * t77;
            let t111 = T::from_f64(0.008) * (t110 - t57) + t43 * t108
                - T::from_f64(0.016) * t93 - t44 * t109;
            let t112 = T::from_f64(0.008) * (t105 - t55) + T::from_f64(0.016) * t89
                + t22 * t108 - t32 * t109;
            let t113 = t111 - t42 * t112;
            let t114 = T::from_f64(0.008) * (t104 - t106) + t49 * t108 + t47 * t113
                - t48 * t109;
            let t115 = t51 * (t114 - t36 * t112);
            let t116 = t45 * t113 + t47 * t115;
            let t117 = t35 * t112 - t36 * t115 - t42 * t116;
            let t118 = t49 * t115 + t43 * t116 + t22 * t117
                - T::from_f64(4332.129963898917) * t108;
            let t119 = -(T::from_f64(817.4386920980926) * t109 + t48 * t115 + t44 * t116
                + t32 * t117);
            let t120 = qy_o * t74;
            let t121 = qz_o * t73;
            let t122 = qw_o * t72;
            let t123 = qx_o * t72;
            let t124 = t123 + qz_o * t74;
            let t125 = t123 + qy_o * t73;
            let t126 = T::from_f64(0.016) * t120 - T::from_f64(0.008) * (t121 + t122);
            let t127 = T::from_f64(0.008) * (t120 - t122) - T::from_f64(0.016) * t121;
            let t128 = T::from_f64(0.008) * t124;
            let t129 = T::from_f64(0.008) * (t62 + t97) + T::from_f64(0.016) * qy_o * t77
                + t22 * t126 - t32 * t128;
            let t130 = t43 * t126 - T::from_f64(0.008) * (t106 + t79) - t44 * t128
                - t42 * t129;
            let t131 = t49 * t126 + T::from_f64(0.008) * (t93 - t110)
                + T::from_f64(0.016) * t57 + t47 * t130;
            let t132 = t51 * (t131 - t48 * t128 - t36 * t129);
            let t133 = t45 * t130 + t47 * t132;
            let t134 = t35 * t129 - t36 * t132 - t42 * t133;
            let t135 = t49 * t132 + t43 * t133 + t22 * t134
                - T::from_f64(4332.129963898917) * t126;
            let t136 = -(T::from_f64(6.539509536784741) * t124 + t48 * t132 + t44 * t133
                + t32 * t134);
            let t137 = T::from_f64(0.008) * t125;
            let t138 = t43 * t137 + T::from_f64(0.008) * (t62 + t96)
                + T::from_f64(0.016) * t97 + t44 * t127;
            let t139 = T::from_f64(0.008) * (t104 - t79) - t32 * t127 - t22 * t137;
            let t140 = T::from_f64(0.016) * t55 - t36 * t139
                - T::from_f64(0.008) * (t105 + t89) - t48 * t127;
            let t141 = t138 + t42 * t139;
            let t142 = t51 * (t140 - t49 * t137 - t47 * t141);
            let t143 = t47 * t142 - t45 * t141;
            let t144 = t35 * t139 - t36 * t142 - t42 * t143;
            let t145 = T::from_f64(34.65703971119134) * t125 + t49 * t142 + t43 * t143
                + t22 * t144;
            let t146 = -(T::from_f64(817.4386920980926) * t127 + t48 * t142 + t44 * t143
                + t32 * t144);
            let t147 = T::from_f64(0.0007816666666666666) * qdy_o;
            let t148 = T::from_f64(0.004) * qdy_o + t44 * t147
                - T::from_f64(0.008) * (qz_o * t63 + qx_o * t56);
            let t149 = T::from_f64(0.004) * qdz_o
                + T::from_f64(0.008) * (qy_o * t63 - qx_o * t52) + t32 * t147;
            let t150 = T::from_f64(0.008)
                * (qx_o * (qy_o * qdy_o + qz_o * qdz_o) - qw_o * t63) + t48 * t147;
            let t151 = T::from_f64(0.00021083333333333333) * qdz_o;
            let t152 = t149 - t22 * t151;
            let t153 = t148 - t43 * t151 - t42 * t152;
            let t154 = t51 * (t150 + t47 * t153 - t49 * t151 - t36 * t152);
            let t155 = t45 * t153 + t47 * t154;
            let t156 = t35 * t152 - t36 * t154 - t42 * t155;
            let t157 = T::from_f64(0.9133574007220217) * qdz_o + t49 * t154 + t43 * t155
                + t22 * t156;
            let t158 = T::from_f64(0.6389645776566758) * qdy_o - t48 * t154 - t44 * t155
                - t32 * t156;
            let t159 = T::from_f64(0.016) * qdy_o;
            let t160 = t32 * t59 + t17 * t159 + qdx_o * t33;
            let t161 = t44 * t59 + t38 * qdx_o - t26 * t159 - t42 * t160;
            let t162 = t48 * t59 + t39 * t159
                + T::from_f64(0.008) * (t25 * qdx_o - qdy_o) + t47 * t161;
            let t163 = t51 * (t162 - t36 * t160);
            let t164 = t45 * t161 + t47 * t163;
            let t165 = t35 * t160 - t36 * t163 - t42 * t164;
            let t166 = t49 * t163 + t43 * t164 + t22 * t165;
            let t167 = T::from_f64(0.6389645776566758) * qdx_o - t48 * t163 - t44 * t164
                - t32 * t165;
            let t168 = T::from_f64(0.016) * qdz_o;
            let t169 = qdx_o * t21 + t17 * t168 - t22 * t67;
            let t170 = T::from_f64(0.008) * qdx_o * t31 - t43 * t67 - t26 * t168
                - t42 * t169;
            let t171 = t39 * t168 + T::from_f64(0.008) * (t16 * qdx_o - qdz_o)
                + t47 * t170 - t49 * t67;
            let t172 = t51 * (t171 - t36 * t169);
            let t173 = t45 * t170 + t47 * t172;
            let t174 = t35 * t169 - t36 * t172 - t42 * t173;
            let t175 = T::from_f64(0.9133574007220217) * qdx_o + t49 * t172 + t43 * t173
                + t22 * t174;
            let t176 = -(t48 * t172 + t44 * t173 + t32 * t174);
            (
                ::pendulum_core::nalgebra::SVector::from([
                    qdx_p,
                    qdy_p,
                    qdz_p,
                    t6,
                    t8,
                    t9,
                    t10,
                    t72,
                    t73,
                    t74,
                    t0,
                    t75,
                    t76,
                ]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
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
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
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
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
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
                        T::from_f64(0.0),
                        t80,
                        t82,
                        t84,
                        t99,
                        t100,
                        t101,
                        T::from_f64(0.0),
                        t102,
                        t103,
                    ],
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t81,
                        T::from_f64(0.0),
                        t85,
                        t82,
                        t115,
                        t116,
                        t117,
                        T::from_f64(0.0),
                        t118,
                        t119,
                    ],
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t83,
                        t84,
                        T::from_f64(0.0),
                        t81,
                        t132,
                        t133,
                        t134,
                        T::from_f64(0.0),
                        t135,
                        t136,
                    ],
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t85,
                        t83,
                        t80,
                        T::from_f64(0.0),
                        t142,
                        t143,
                        t144,
                        T::from_f64(0.0),
                        t145,
                        t146,
                    ],
                    [
                        T::from_f64(1.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                    ],
                    [
                        T::from_f64(0.0),
                        T::from_f64(1.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
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
                        T::from_f64(1.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
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
                        t11,
                        t7,
                        t5,
                        t12,
                        t154,
                        t155,
                        t156,
                        T::from_f64(0.0),
                        t157,
                        t158,
                    ],
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t12,
                        t13,
                        t7,
                        t3,
                        t163,
                        t164,
                        t165,
                        t1,
                        t166,
                        t167,
                    ],
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t13,
                        t4,
                        t11,
                        t7,
                        t172,
                        t173,
                        t174,
                        t2,
                        t175,
                        t176,
                    ],
                ]),
            )
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn time_derivative(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 13>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 13> {
            ::pendulum_core::nalgebra::SVector::from([
                T::from_f64(0.0),
                T::from_f64(0.0),
                T::from_f64(0.0),
                T::from_f64(0.0),
                T::from_f64(0.0),
                T::from_f64(0.0),
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
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Energy<T, 13>
    for TumblingBody<T> {
        #[inline]
        fn kinetic(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 13>) -> T {
            let [_, _, _, qw_o, qx_o, qy_o, qz_o, qdx_p, qdy_p, qdz_p, qdx_o, qdy_o,
            qdz_o] = x.data.0[0];
            let t0 = T::from_f64(0.008) * qx_o;
            let t1 = T::from_f64(0.008) * qz_o;
            let t2 = t0 * qw_o;
            let t3 = T::from_f64(0.008) * qy_o;
            let t4 = qz_o * t3;
            let t5 = T::from_f64(0.0006116666666666667) * qdz_o
                + qdx_p * (qy_o * t0 - qw_o * t1) + qdz_p * (t2 + t4);
            let t6 = qx_o * t0 - T::from_f64(0.004);
            let t7 = T::from_f64(0.00011541666666666666) * qdy_o
                + qdz_p * (qy_o * t3 + t6) + qdy_p * (t2 - t4);
            let t8 = T::from_f64(0.00050625) * qdx_o * qdx_o
                + qdz_o * (t5 - qdy_p * (qz_o * t1 + t6));
            t8 + qdy_o * (t7 - qdx_p * (t0 * qz_o + qw_o * t3))
                + T::from_f64(0.2) * (qdx_p * qdx_p + qdy_p * qdy_p + qdz_p * qdz_p)
        }
        #[inline]
        fn potential(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 13>) -> T {
            let [_, _, _, _, _, _, _, _, _, _, _, _, _] = x.data.0[0];
            T::from_f64(0.0)
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> TumblingBody<T> {
        ///Output `tip`.
        #[inline]
        pub fn tip(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 13>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 3> {
            let [qx_p, qy_p, qz_p, qw_o, qx_o, qy_o, qz_o, _, _, _, _, _, _] = x
                .data
                .0[0];
            ::pendulum_core::nalgebra::SVector::from([
                qx_p
                    + (T::from_f64(0.08)
                        - T::from_f64(0.16) * (qy_o * qy_o + qz_o * qz_o)),
                qy_p + T::from_f64(0.16) * (qy_o * qx_o + qz_o * qw_o),
                qz_p + T::from_f64(0.16) * (qz_o * qx_o - qy_o * qw_o),
            ])
        }
        ///The rate of `tip` along the motion.
        #[inline]
        pub fn tip_rate(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 13>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 3> {
            let [_, _, _, qw_o, qx_o, qy_o, qz_o, qdx_p, qdy_p, qdz_p, _, qdy_o, qdz_o,
            ] = x.data.0[0];
            let t0 = qx_o * (qy_o * qdz_o - qz_o * qdy_o)
                - qw_o * (qy_o * qdy_o + qdz_o * qz_o);
            let t1 = qx_o * qw_o;
            let t2 = qy_o * qz_o;
            let t3 = qy_o * qy_o - qz_o * qz_o;
            let t4 = qx_o * qx_o - qw_o * qw_o;
            ::pendulum_core::nalgebra::SVector::from([
                qdx_p + T::from_f64(0.16) * t0,
                qdy_p + T::from_f64(0.16) * qdy_o * (t1 - t2)
                    + T::from_f64(0.08) * qdz_o * (t3 - t4),
                qdz_p + T::from_f64(0.16) * qdz_o * (t1 + t2)
                    + T::from_f64(0.08) * qdy_o * (t3 + t4),
            ])
        }
        ///The value of `tip`, and its derivatives by the state: a row for each component, column by column for a matrix.
        #[inline]
        pub fn tip_and_jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 13>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 3>,
            ::pendulum_core::nalgebra::SMatrix<T, 3, 13>,
        ) {
            let [qx_p, qy_p, qz_p, qw_o, qx_o, qy_o, qz_o, _, _, _, _, _, _] = x
                .data
                .0[0];
            let t0 = T::from_f64(-0.16) * qy_o;
            let t1 = T::from_f64(-0.32) * qy_o;
            let t2 = T::from_f64(-0.16) * qw_o;
            let t3 = T::from_f64(-0.32) * qz_o;
            let t4 = T::from_f64(0.16) * qw_o;
            let t5 = T::from_f64(0.16) * qy_o;
            let t6 = T::from_f64(0.16) * qz_o;
            let t7 = T::from_f64(0.08) + qx_p - qy_o * t5 - qz_o * t6;
            let t8 = T::from_f64(0.16) * qx_o;
            let t9 = qy_p + qy_o * t8 + t6 * qw_o;
            let t10 = qz_p + qz_o * t8 - t5 * qw_o;
            (
                ::pendulum_core::nalgebra::SVector::from([t7, t9, t10]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [T::from_f64(1.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(1.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(1.0)],
                    [T::from_f64(0.0), t6, t0],
                    [T::from_f64(0.0), t5, t6],
                    [t1, t8, t2],
                    [t3, t4, t8],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
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
            x: &::pendulum_core::nalgebra::SVector<T, 13>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 3> {
            let [qx_p, qy_p, qz_p, qw_o, qx_o, qy_o, qz_o, _, _, _, _, _, _] = x
                .data
                .0[0];
            ::pendulum_core::nalgebra::SVector::from([
                qx_p
                    + (T::from_f64(0.08)
                        - T::from_f64(0.16) * (qy_o * qy_o + qz_o * qz_o)),
                qy_p + T::from_f64(0.16) * (qy_o * qx_o + qz_o * qw_o),
                qz_p + T::from_f64(0.16) * (qz_o * qx_o - qy_o * qw_o),
            ])
        }
        ///The rate of all outputs along the motion.
        #[inline]
        pub fn output_rates(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 13>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 3> {
            let [_, _, _, qw_o, qx_o, qy_o, qz_o, qdx_p, qdy_p, qdz_p, _, qdy_o, qdz_o,
            ] = x.data.0[0];
            let t0 = qx_o * (qy_o * qdz_o - qz_o * qdy_o)
                - qw_o * (qy_o * qdy_o + qdz_o * qz_o);
            let t1 = qx_o * qw_o;
            let t2 = qy_o * qz_o;
            let t3 = qy_o * qy_o - qz_o * qz_o;
            let t4 = qx_o * qx_o - qw_o * qw_o;
            ::pendulum_core::nalgebra::SVector::from([
                qdx_p + T::from_f64(0.16) * t0,
                qdy_p + T::from_f64(0.16) * qdy_o * (t1 - t2)
                    + T::from_f64(0.08) * qdz_o * (t3 - t4),
                qdz_p + T::from_f64(0.16) * qdz_o * (t1 + t2)
                    + T::from_f64(0.08) * qdy_o * (t3 + t4),
            ])
        }
        ///The value of all outputs, and its derivatives by the state: a row for each component, column by column for a matrix.
        #[inline]
        pub fn outputs_and_jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 13>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 3>,
            ::pendulum_core::nalgebra::SMatrix<T, 3, 13>,
        ) {
            let [qx_p, qy_p, qz_p, qw_o, qx_o, qy_o, qz_o, _, _, _, _, _, _] = x
                .data
                .0[0];
            let t0 = T::from_f64(-0.16) * qy_o;
            let t1 = T::from_f64(-0.32) * qy_o;
            let t2 = T::from_f64(-0.16) * qw_o;
            let t3 = T::from_f64(-0.32) * qz_o;
            let t4 = T::from_f64(0.16) * qw_o;
            let t5 = T::from_f64(0.16) * qy_o;
            let t6 = T::from_f64(0.16) * qz_o;
            let t7 = T::from_f64(0.08) + qx_p - qy_o * t5 - qz_o * t6;
            let t8 = T::from_f64(0.16) * qx_o;
            let t9 = qy_p + qy_o * t8 + t6 * qw_o;
            let t10 = qz_p + qz_o * t8 - t5 * qw_o;
            (
                ::pendulum_core::nalgebra::SVector::from([t7, t9, t10]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [T::from_f64(1.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(1.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(1.0)],
                    [T::from_f64(0.0), t6, t0],
                    [T::from_f64(0.0), t5, t6],
                    [t1, t8, t2],
                    [t3, t4, t8],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                ]),
            )
        }
        ///What passes zero at event `turns`.
        #[inline]
        pub fn turns(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 13>) -> T {
            let [_, _, _, _, _, _, _, _, _, _, qdx_o, _, _] = x.data.0[0];
            qdx_o
        }
        ///Event `turns`: each zero of the function [`turns`](Self::turns), in both directions.
        pub fn turns_event(&self) -> ::pendulum_core::Event<'_, T, 13> {
            ::pendulum_core::Event::new(|t, x| self.turns(t, x))
        }
        /// All events, in the order of `EVENTS`.
        pub fn events(&self) -> [::pendulum_core::Event<'_, T, 13>; 1] {
            [self.turns_event()]
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::shapes::Shapes<13> for TumblingBody {
        fn shapes(
            &self,
            t: f64,
            x: &::pendulum_core::nalgebra::SVector<f64, 13>,
        ) -> ::pendulum_core::shapes::Vec<::pendulum_core::shapes::Shape> {
            use ::pendulum_core::real::Real as _;
            type T = f64;
            ::pendulum_core::shapes::placed(
                &[
                    ::pendulum_core::shapes::Outline {
                        name: "handle",
                        kind: ::pendulum_core::shapes::ShapeKind::Cylinder,
                        points: 2,
                        radius: true,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "handle",
                        kind: ::pendulum_core::shapes::ShapeKind::Cylinder,
                        points: 2,
                        radius: true,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "tip",
                        kind: ::pendulum_core::shapes::ShapeKind::Point,
                        points: 1,
                        radius: false,
                    },
                ],
                &{
                    let [qx_p, qy_p, qz_p, qw_o, qx_o, qy_o, qz_o, _, _, _, _, _, _] = x
                        .data
                        .0[0];
                    let t0 = qz_o * qz_o;
                    let t1 = qx_p
                        + (T::from_f64(0.08) - T::from_f64(0.16) * (qy_o * qy_o + t0));
                    let t2 = T::from_f64(0.1) - T::from_f64(0.2) * (t0 + qx_o * qx_o);
                    let t3 = qy_p - t2;
                    let t4 = qy_p + t2;
                    let t5 = qy_o * qx_o;
                    let t6 = qz_o * qw_o;
                    let t7 = qy_p + T::from_f64(0.16) * (t5 + t6);
                    let t8 = T::from_f64(0.2) * (t5 - t6);
                    let t9 = qx_p - t8;
                    let t10 = qx_p + t8;
                    let t11 = qz_p + T::from_f64(0.16) * (qz_o * qx_o - qy_o * qw_o);
                    let t12 = T::from_f64(0.2) * (qy_o * qz_o + qx_o * qw_o);
                    let t13 = qz_p - t12;
                    let t14 = qz_p + t12;
                    [
                        qx_p,
                        qy_p,
                        qz_p,
                        t1,
                        t7,
                        t11,
                        T::from_f64(0.01),
                        t9,
                        t3,
                        t13,
                        t10,
                        t4,
                        t14,
                        T::from_f64(0.01),
                        t1,
                        t7,
                        t11,
                    ]
                },
            )
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::CastJacobian<13> for TumblingBody {
        #[inline]
        fn with_jacobian<T: ::pendulum_core::real::Real>(
            model: &TumblingBody<T>,
        ) -> &impl ::pendulum_core::Jacobian<T, 13> {
            model
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::Cast<13> for TumblingBody {
        type In<T: ::pendulum_core::real::Real> = TumblingBody<T>;
        fn cast<T: ::pendulum_core::real::Real>(&self) -> TumblingBody<T> {
            TumblingBody::cast(self)
        }
        #[inline]
        fn gather<'m, T: ::pendulum_core::real::lanes::Lanes>(
            models: impl ::core::ops::Fn(usize) -> &'m Self,
        ) -> TumblingBody<T>
        where
            Self: 'm,
        {
            let scalar = <<T as ::pendulum_core::real::lanes::Lanes>::Scalar as ::pendulum_core::real::Real>::from_f64;
            TumblingBody {
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
pub use __TumblingBody::{TumblingBody, TumblingBodyParams};
