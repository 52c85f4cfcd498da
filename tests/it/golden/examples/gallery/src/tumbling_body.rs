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
b[p.x] = 0.008*o.x*o.y*dot(o).x*dot(o).y + 0.008*o.x*o.z*dot(o).x*dot(o).z + 0.008*o.y*o.w*dot(o).x*dot(o).z
    + 0.008*o.y^2*dot(o).y^2 + 0.008*o.y^2*dot(o).z^2 + 0.008*o.z^2*dot(o).y^2 + 0.008*o.z^2*dot(o).z^2
    - 0.008*o.z*o.w*dot(o).x*dot(o).y - 0.004*dot(o).y^2 - 0.004*dot(o).z^2
b[p.y] = 0.004*dot(o).x*dot(o).y + 0.008*o.y*o.z*dot(o).x*dot(o).z - 0.008*o.x*o.y*dot(o).y^2 - 0.008*o.x*o.y*dot(o).z^2
    - 0.008*o.x*o.w*dot(o).x*dot(o).z - 0.008*o.x^2*dot(o).x*dot(o).y - 0.008*o.z*o.w*dot(o).y^2
    - 0.008*o.z*o.w*dot(o).z^2 - 0.008*o.z^2*dot(o).x*dot(o).y
b[p.z] = 0.004*dot(o).x*dot(o).z + 0.008*o.x*o.w*dot(o).x*dot(o).y + 0.008*o.y*o.z*dot(o).x*dot(o).y
    + 0.008*o.y*o.w*dot(o).y^2 + 0.008*o.y*o.w*dot(o).z^2 - 0.008*o.x*o.z*dot(o).y^2 - 0.008*o.x*o.z*dot(o).z^2
    - 0.008*o.x^2*dot(o).x*dot(o).z - 0.008*o.y^2*dot(o).x*dot(o).z
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
        /// The first parameter, or combination of parameters, that is not finite or that no rigid body can
        /// have.
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
        /// The same model in another number type, such as `f32`. Its constants are computed in double precision
        /// and then rounded.
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
                            "closed form, factors of the state first, L^T D L",
                            ::pendulum_core::Operations::new(29, 51, 0, 0, 0, 7),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, L^T D L",
                                    ::pendulum_core::Operations::new(29, 51, 0, 0, 0, 7),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L",
                                    ::pendulum_core::Operations::new(29, 51, 0, 0, 0, 7),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, L^T D L",
                                    ::pendulum_core::Operations::new(33, 59, 0, 0, 0, 9),
                                ),
                            ],
                        ),
                ),
                (
                    "jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first, L^T D L, derived and expanded",
                            ::pendulum_core::Operations::new(68, 110, 0, 0, 0, 7),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, L^T D L, derived and expanded",
                                    ::pendulum_core::Operations::new(68, 110, 0, 0, 0, 7),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L, derived and expanded",
                                    ::pendulum_core::Operations::new(68, 110, 0, 0, 0, 7),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, L^T D L, derived in the graph",
                                    ::pendulum_core::Operations::new(88, 140, 0, 0, 0, 8),
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
        pub const EQUATIONS: &'static str = "A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints\n\nA[p.x, p.x] = 0.4\nA[p.x, o.y] = -(0.008*o.x*o.z + 0.008*o.y*o.w)\nA[p.x, o.z] = 0.008*o.x*o.y - 0.008*o.z*o.w\nA[p.y, p.y] = 0.4\nA[p.y, o.y] = 0.008*o.x*o.w - 0.008*o.y*o.z\nA[p.y, o.z] = 0.004 - 0.008*o.x^2 - 0.008*o.z^2\nA[p.z, p.z] = 0.4\nA[p.z, o.y] = 0.008*o.x^2 + 0.008*o.y^2 - 0.004\nA[p.z, o.z] = 0.008*o.x*o.w + 0.008*o.y*o.z\nA[o.x, o.x] = 0.0010125\nA[o.y, o.y] = 277/1200000\nA[o.z, o.z] = 367/300000\nb[p.x] = 0.008*o.x*o.y*dot(o).x*dot(o).y + 0.008*o.x*o.z*dot(o).x*dot(o).z + 0.008*o.y*o.w*dot(o).x*dot(o).z\n    + 0.008*o.y^2*dot(o).y^2 + 0.008*o.y^2*dot(o).z^2 + 0.008*o.z^2*dot(o).y^2 + 0.008*o.z^2*dot(o).z^2\n    - 0.008*o.z*o.w*dot(o).x*dot(o).y - 0.004*dot(o).y^2 - 0.004*dot(o).z^2\nb[p.y] = 0.004*dot(o).x*dot(o).y + 0.008*o.y*o.z*dot(o).x*dot(o).z - 0.008*o.x*o.y*dot(o).y^2 - 0.008*o.x*o.y*dot(o).z^2\n    - 0.008*o.x*o.w*dot(o).x*dot(o).z - 0.008*o.x^2*dot(o).x*dot(o).y - 0.008*o.z*o.w*dot(o).y^2\n    - 0.008*o.z*o.w*dot(o).z^2 - 0.008*o.z^2*dot(o).x*dot(o).y\nb[p.z] = 0.004*dot(o).x*dot(o).z + 0.008*o.x*o.w*dot(o).x*dot(o).y + 0.008*o.y*o.z*dot(o).x*dot(o).y\n    + 0.008*o.y*o.w*dot(o).y^2 + 0.008*o.y*o.w*dot(o).z^2 - 0.008*o.x*o.z*dot(o).y^2 - 0.008*o.x*o.z*dot(o).z^2\n    - 0.008*o.x^2*dot(o).x*dot(o).z - 0.008*o.y^2*dot(o).x*dot(o).z\nb[o.x] = 0.0009925*dot(o).y*dot(o).z\nb[o.y] = -253/1200000*dot(o).x*dot(o).z\nb[o.z] = -469/600000*dot(o).x*dot(o).y\n";
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
            let t0 = -(T::from_f64(0.980246913580247) * qdy_o * qdz_o);
            let t1 = T::from_f64(0.5) * qx_o;
            let t2 = T::from_f64(0.5) * qy_o;
            let t3 = T::from_f64(0.5) * qz_o;
            let t4 = -(qdx_o * t1 + qdy_o * t2 + qdz_o * t3);
            let t5 = T::from_f64(0.5) * qw_o;
            let t6 = qdx_o * t5 - qdy_o * t3 + qdz_o * t2;
            let t7 = qdx_o * t3 + qdy_o * t5 - qdz_o * t1;
            let t8 = qdy_o * t1 - qdx_o * t2 + qdz_o * t5;
            let t9 = qy_o * qy_o;
            let t10 = qz_o * qz_o;
            let t11 = T::from_f64(0.01) * (qdy_o * qdy_o + qdz_o * qdz_o);
            let t12 = qy_o * qx_o;
            let t13 = qz_o * qw_o;
            let t14 = qdy_o * qdx_o;
            let t15 = T::from_f64(0.6943661971830986) * t14;
            let t16 = T::from_f64(0.016943661971830986) * t14;
            let t17 = T::from_f64(2.0) * t16;
            let t18 = qz_o * qx_o;
            let t19 = qy_o * qw_o;
            let t20 = qdz_o * qdx_o;
            let t21 = T::from_f64(0.8951965065502183) * t20;
            let t22 = T::from_f64(0.0010480349344978166) * t20;
            let t23 = T::from_f64(2.0) * t22;
            let t24 = (T::from_f64(1.0) - T::from_f64(2.0) * (t9 + t10)) * t11
                - (t12 - t13) * t17 - (t18 + t19) * t23;
            let t25 = T::from_f64(2.0) * t11;
            let t26 = qx_o * qx_o;
            let t27 = qy_o * qz_o;
            let t28 = qx_o * qw_o;
            let t29 = (t12 + t13) * t25
                - t16 * (T::from_f64(1.0) - T::from_f64(2.0) * (t10 + t26))
                - (t27 - t28) * t23;
            let t30 = (t18 - t19) * t25 - (t27 + t28) * t17
                - t22 * (T::from_f64(1.0) - T::from_f64(2.0) * (t9 + t26));
            ::pendulum_core::nalgebra::SVector::from([
                qdx_p,
                qdy_p,
                qdz_p,
                t4,
                t6,
                t7,
                t8,
                t24,
                t29,
                t30,
                t0,
                t21,
                t15,
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
            let t0 = -(qdz_o * (T::from_f64(0.980246913580247) * qdy_o));
            let t1 = T::from_f64(0.8951965065502183) * qdz_o;
            let t2 = T::from_f64(0.6943661971830986) * qdy_o;
            let t3 = T::from_f64(-0.980246913580247) * qdz_o;
            let t4 = T::from_f64(-0.980246913580247) * qdy_o;
            let t5 = T::from_f64(0.5) * qx_o;
            let t6 = T::from_f64(0.5) * qy_o;
            let t7 = T::from_f64(0.5) * qz_o;
            let t8 = -(qdx_o * t5 + qdy_o * t6 + qdz_o * t7);
            let t9 = T::from_f64(0.5) * qw_o;
            let t10 = qdx_o * t9 - qdy_o * t7 + qdz_o * t6;
            let t11 = qdx_o * t7 + qdy_o * t9 - qdz_o * t5;
            let t12 = qdy_o * t5 - qdx_o * t6 + qdz_o * t9;
            let t13 = -t5;
            let t14 = -t6;
            let t15 = -t7;
            let t16 = qy_o * qy_o;
            let t17 = qz_o * qz_o;
            let t18 = T::from_f64(1.0) - T::from_f64(2.0) * (t16 + t17);
            let t19 = T::from_f64(0.01) * (qdy_o * qdy_o + qdz_o * qdz_o);
            let t20 = qy_o * qx_o;
            let t21 = qz_o * qw_o;
            let t22 = T::from_f64(2.0) * (t20 - t21);
            let t23 = T::from_f64(2.0) * (t20 + t21);
            let t24 = T::from_f64(0.016943661971830986) * qdx_o;
            let t25 = qdy_o * t24;
            let t26 = qz_o * qx_o;
            let t27 = qy_o * qw_o;
            let t28 = T::from_f64(2.0) * (t26 + t27);
            let t29 = T::from_f64(2.0) * (t26 - t27);
            let t30 = T::from_f64(0.0010480349344978166) * qdx_o;
            let t31 = qdz_o * t30;
            let t32 = t18 * t19 - t22 * t25 - t28 * t31;
            let t33 = qx_o * qx_o;
            let t34 = T::from_f64(1.0) - T::from_f64(2.0) * (t17 + t33);
            let t35 = T::from_f64(1.0) - T::from_f64(2.0) * (t16 + t33);
            let t36 = qy_o * qz_o;
            let t37 = qx_o * qw_o;
            let t38 = T::from_f64(2.0) * (t36 - t37);
            let t39 = T::from_f64(2.0) * (t36 + t37);
            let t40 = t19 * t23 - t25 * t34 - t31 * t38;
            let t41 = t19 * t29 - t25 * t39 - t31 * t35;
            let t42 = T::from_f64(0.8951965065502183) * qdx_o;
            let t43 = qdz_o * t42;
            let t44 = T::from_f64(0.6943661971830986) * qdx_o;
            let t45 = qdy_o * t44;
            let t46 = T::from_f64(0.5) * qdx_o;
            let t47 = -t46;
            let t48 = T::from_f64(0.5) * qdy_o;
            let t49 = -t48;
            let t50 = T::from_f64(0.5) * qdz_o;
            let t51 = -t50;
            let t52 = T::from_f64(2.0) * qz_o;
            let t53 = t25 * t52;
            let t54 = T::from_f64(2.0) * qy_o;
            let t55 = t31 * t54;
            let t56 = t53 - t55;
            let t57 = t19 * t52;
            let t58 = t31 * t52;
            let t59 = T::from_f64(2.0) * qx_o;
            let t60 = t31 * t59;
            let t61 = t57 + t60;
            let t62 = t19 * t54;
            let t63 = t25 * t54;
            let t64 = -(t58 + t63);
            let t65 = t25 * t59;
            let t66 = -(t62 + t65);
            let t67 = t19 * t59;
            let t68 = t67 - t58;
            let t69 = t67 - t63;
            let t70 = T::from_f64(2.0) * qw_o;
            let t71 = t31 * t70;
            let t72 = T::from_f64(4.0) * qx_o;
            let t73 = t62 + t71 + t25 * t72;
            let t74 = t25 * t70;
            let t75 = t57 + t31 * t72 - t74;
            let t76 = t19 * t70;
            let t77 = T::from_f64(4.0) * qy_o;
            let t78 = -(t65 + t71 + t19 * t77);
            let t79 = t31 * t77 - t53 - t76;
            let t80 = T::from_f64(4.0) * qz_o;
            let t81 = t74 - (t60 + t19 * t80);
            let t82 = t76 + t25 * t80 - t55;
            let t83 = T::from_f64(0.016943661971830986) * qdy_o;
            let t84 = T::from_f64(0.0010480349344978166) * qdz_o;
            let t85 = -(t22 * t83 + t28 * t84);
            let t86 = -(t34 * t83 + t38 * t84);
            let t87 = -(t39 * t83 + t35 * t84);
            let t88 = T::from_f64(0.02) * qdy_o;
            let t89 = t18 * t88 - t22 * t24;
            let t90 = t23 * t88 - t24 * t34;
            let t91 = t29 * t88 - t24 * t39;
            let t92 = T::from_f64(0.02) * qdz_o;
            let t93 = t18 * t92 - t28 * t30;
            let t94 = t23 * t92 - t30 * t38;
            let t95 = t29 * t92 - t30 * t35;
            (
                ::pendulum_core::nalgebra::SVector::from([
                    qdx_p,
                    qdy_p,
                    qdz_p,
                    t8,
                    t10,
                    t11,
                    t12,
                    t32,
                    t40,
                    t41,
                    t0,
                    t43,
                    t45,
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
                        t46,
                        t48,
                        t50,
                        t56,
                        t61,
                        t66,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                    ],
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t47,
                        T::from_f64(0.0),
                        t51,
                        t48,
                        t64,
                        t73,
                        t75,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                    ],
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t49,
                        t50,
                        T::from_f64(0.0),
                        t47,
                        t78,
                        t68,
                        t79,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                    ],
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t51,
                        t49,
                        t46,
                        T::from_f64(0.0),
                        t81,
                        t82,
                        t69,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
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
                        t13,
                        t9,
                        t7,
                        t14,
                        t85,
                        t86,
                        t87,
                        T::from_f64(0.0),
                        t1,
                        t2,
                    ],
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t14,
                        t15,
                        t9,
                        t5,
                        t89,
                        t90,
                        t91,
                        t3,
                        T::from_f64(0.0),
                        t44,
                    ],
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t15,
                        t6,
                        t13,
                        t9,
                        t93,
                        t94,
                        t95,
                        t4,
                        t42,
                        T::from_f64(0.0),
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
