#[allow(non_snake_case)]
mod __Cubic {
    ///Parameters of [`Cubic`].
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct CubicParams {
        ///In kg.
        pub m1: f64,
        ///In kg.
        pub m2: f64,
        ///In N/m.
        pub k: f64,
        ///In N/m^3.
        pub k3: f64,
        ///In N s^3/m^3.
        pub c3: f64,
    }
    impl ::core::default::Default for CubicParams {
        #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
        fn default() -> Self {
            Self {
                m1: 1f64,
                m2: 0.6f64,
                k: 4f64,
                k3: 30f64,
                c3: 0.2f64,
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl CubicParams {
        /// The names of the parameters, in the order of their declaration.
        pub const NAMES: [&'static str; 5] = ["m1", "m2", "k", "k3", "c3"];
        /// The values of the parameters, in the order of [`NAMES`](Self::NAMES).
        pub const fn to_array(self) -> [f64; 5] {
            [self.m1, self.m2, self.k, self.k3, self.c3]
        }
        /// The parameters with these values, in the order of [`NAMES`](Self::NAMES).
        pub const fn from_array(values: [f64; 5]) -> Self {
            let [v0, v1, v2, v3, v4] = values;
            Self {
                m1: v0,
                m2: v1,
                k: v2,
                k3: v3,
                c3: v4,
            }
        }
    }
    /// Two sliders on cubic springs and dampers.
    ///
    /**# Equations of motion

```text
A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q all other forces

A[x1, x1] = m1
A[x2, x2] = m2
Q[x1] = -(0.5*k*(2*x1 - 2*(x2 - x1)) + 0.25*k3*(4*x1^3 - 4*(x2 - x1)^3)
    + 0.25*c3*(4*dot(x1)^3 - 4*(dot(x2) - dot(x1))^3))
Q[x2] = -(k*(x2 - x1) + k3*(x2 - x1)^3 + c3*(dot(x2) - dot(x1))^3)
```

# Constants, computed by `new`

```text
k0 = 0.5*k
k1 = 0.25*k3
k2 = 0.5*m1
k3 = 0.5*m2
k4 = -0.5*k/m1
k5 = -0.25*k3/m1
k6 = -0.25*c3/m1
k7 = -0.5*k/m2
k8 = -0.25*k3/m2
k9 = -0.25*c3/m2
```
*/
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Cubic<T = f64> {
        params: CubicParams,
        constants: [T; 10],
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl Cubic {
        /// Builds the model: checks the parameters, and computes once whatever depends on them alone.
        ///
        /// # Errors
        ///
        /// The first parameter, or combination of parameters, that is not finite or that no rigid body can
        /// have.
        pub fn new(
            params: CubicParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            #[inline]
            fn rules<T: ::pendulum_core::real::Real>(given: [T; 5]) -> [T; 2] {
                let [p_m1, p_m2, p_k, p_k3, p_c3] = given;
                [p_m1, p_m2]
            }
            #[inline]
            fn constants<T: ::pendulum_core::real::Real>(given: [T; 5]) -> [T; 10] {
                let [p_m1, p_m2, p_k, p_k3, p_c3] = given;
                let t0 = T::from_f64(0.5) * p_m1;
                let t1 = T::from_f64(0.5) * p_m2;
                let t2 = T::from_f64(0.5) * p_k;
                let t3 = T::from_f64(0.25) * p_k3;
                let t4 = T::from_f64(-1.0) / p_m1;
                let t5 = t2 * t4;
                let t6 = t3 * t4;
                let t7 = T::from_f64(0.25) * p_c3;
                let t8 = t7 * t4;
                let t9 = T::from_f64(-1.0) / p_m2;
                let t10 = t2 * t9;
                let t11 = t3 * t9;
                let t12 = t7 * t9;
                [t2, t3, t0, t1, t5, t6, t8, t10, t11, t12]
            }
            let given = params.to_array();
            for (name, value) in CubicParams::NAMES.into_iter().zip(given) {
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
                        "the mass of a cuboid of `left` must be positive",
                        &[],
                    ),
                );
            }
            if !(r1 > 0.0) {
                return Err(
                    ::pendulum_core::ParameterError::new(
                        "m2",
                        r1,
                        "the mass of a cuboid of `right` must be positive",
                        &[],
                    ),
                );
            }
            let constants = constants(given);
            let names: [&'static str; 10] = [
                "0.5*k",
                "0.25*k3",
                "0.5*m1",
                "0.5*m2",
                "-0.5*k/m1",
                "-0.25*k3/m1",
                "-0.25*c3/m1",
                "-0.5*k/m2",
                "-0.25*k3/m2",
                "-0.25*c3/m2",
            ];
            for (name, value) in names.into_iter().zip(constants) {
                if !value.is_finite() {
                    let given: [_; 5] = ::core::array::from_fn(|n| (
                        CubicParams::NAMES[n],
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
        pub fn cast<T: ::pendulum_core::real::Real>(&self) -> Cubic<T> {
            Cubic {
                params: self.params,
                constants: self.constants.map(T::from_f64),
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> Cubic<T> {
        /// The parameters that the model was built from.
        pub fn params(&self) -> &CubicParams {
            &self.params
        }
        /// The model with other parameters, in the same number type. Its constants are computed anew.
        ///
        /// # Errors
        ///
        /// Those of `new`.
        pub fn with_params(
            &self,
            params: CubicParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            Ok(<Cubic>::new(params)?.cast())
        }
    }
    impl Cubic {
        ///The place of `x1` in the state, where it stands in m.
        pub const X1: usize = 0;
        ///The place of `dot(x1)` in the state, where it stands in m/s.
        pub const DOT_X1: usize = 2;
        ///The place of `x2` in the state, where it stands in m.
        pub const X2: usize = 1;
        ///The place of `dot(x2)` in the state, where it stands in m/s.
        pub const DOT_X2: usize = 3;
        /// The number of degrees of freedom; the state has twice as many components.
        pub const DOF: usize = 2;
        /// The names of the coordinates, in the order in which they, and then their rates, stand in the state.
        pub const COORDINATES: [&'static str; 2] = ["x1", "x2"];
        /// Counted operations of each generated function, in the form that it has and in others.
        pub const COST: ::pendulum_core::Cost = ::pendulum_core::Cost::new(
            &[
                (
                    "rhs",
                    ::pendulum_core::FunctionCost::new(
                            "A, B and C, L^T D L",
                            ::pendulum_core::Operations::new(9, 20, 0, 0, 0, 8),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, L^T D L",
                                    ::pendulum_core::Operations::new(9, 20, 0, 0, 0, 8),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "articulated bodies",
                                    ::pendulum_core::Operations::new(11, 20, 0, 0, 0, 8),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L",
                                    ::pendulum_core::Operations::new(12, 26, 0, 0, 0, 8),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, L^T D L",
                                    ::pendulum_core::Operations::new(16, 23, 0, 0, 0, 8),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first, L^T D L",
                                    ::pendulum_core::Operations::new(17, 25, 0, 0, 0, 10),
                                ),
                            ],
                        ),
                ),
                (
                    "kinetic",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(1, 4, 0, 0, 0, 3),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(1, 4, 0, 0, 0, 3),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(1, 4, 0, 0, 0, 3),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C",
                                    ::pendulum_core::Operations::new(1, 4, 0, 0, 0, 3),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(1, 4, 0, 0, 0, 3),
                                ),
                            ],
                        ),
                ),
                (
                    "potential",
                    ::pendulum_core::FunctionCost::new(
                            "A, B and C",
                            ::pendulum_core::Operations::new(4, 6, 0, 0, 0, 6),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(4, 6, 0, 0, 0, 6),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(7, 11, 0, 0, 0, 10),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(7, 11, 0, 0, 0, 10),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(7, 12, 0, 0, 0, 9),
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
                        "x1",
                        ::pendulum_core::SlotKind::Length,
                        0..1,
                        2..3,
                    ),
                    ::pendulum_core::Slot::new(
                        "x2",
                        ::pendulum_core::SlotKind::Length,
                        1..2,
                        3..4,
                    ),
                ],
            )
            .autonomous();
        /// The equations of motion as text.
        pub const EQUATIONS: &'static str = "A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q all other forces\n\nA[x1, x1] = m1\nA[x2, x2] = m2\nQ[x1] = -(0.5*k*(2*x1 - 2*(x2 - x1)) + 0.25*k3*(4*x1^3 - 4*(x2 - x1)^3)\n    + 0.25*c3*(4*dot(x1)^3 - 4*(dot(x2) - dot(x1))^3))\nQ[x2] = -(k*(x2 - x1) + k3*(x2 - x1)^3 + c3*(dot(x2) - dot(x1))^3)\n";
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::System<T, 4> for Cubic<T> {
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn rhs(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 4> {
            let [q_x1, q_x2, qd_x1, qd_x2] = x.data.0[0];
            let k4 = self.constants[4];
            let k5 = self.constants[5];
            let k6 = self.constants[6];
            let k7 = self.constants[7];
            let k8 = self.constants[8];
            let k9 = self.constants[9];
            let t0 = q_x2 - q_x1;
            let t1 = T::from_f64(2.0) * t0;
            let t2 = T::from_f64(4.0) * t0 * t0 * t0;
            let t3 = k4 * (T::from_f64(2.0) * q_x1 - t1)
                + k5 * (T::from_f64(4.0) * q_x1 * q_x1 * q_x1 - t2);
            let t4 = qd_x2 - qd_x1;
            let t5 = T::from_f64(4.0) * t4 * t4 * t4;
            ::pendulum_core::nalgebra::SVector::from([
                qd_x1,
                qd_x2,
                t3 + k6 * (T::from_f64(4.0) * qd_x1 * qd_x1 * qd_x1 - t5),
                k7 * t1 + k8 * t2 + k9 * t5,
            ])
        }
        #[inline]
        fn layout(
            &self,
        ) -> ::core::option::Option<&'static ::pendulum_core::StateLayout> {
            Some(&<Cubic>::LAYOUT)
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Energy<T, 4> for Cubic<T> {
        #[inline]
        fn kinetic(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 4>) -> T {
            let [_, _, qd_x1, qd_x2] = x.data.0[0];
            let k2 = self.constants[2];
            let k3 = self.constants[3];
            k2 * qd_x1 * qd_x1 + k3 * qd_x2 * qd_x2
        }
        #[inline]
        fn potential(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 4>) -> T {
            let [q_x1, q_x2, _, _] = x.data.0[0];
            let k0 = self.constants[0];
            let k1 = self.constants[1];
            let t0 = q_x1 * q_x1;
            let t1 = q_x2 - q_x1;
            let t2 = t1 * t1;
            k0 * (t0 + t2) + k1 * (t0 * t0 + t2 * t2)
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::shapes::Shapes<4> for Cubic {
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
                        kind: ::pendulum_core::shapes::ShapeKind::Cuboid,
                        points: 8,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "right",
                        kind: ::pendulum_core::shapes::ShapeKind::Cuboid,
                        points: 8,
                        radius: false,
                    },
                ],
                &{
                    let [q_x1, q_x2, _, _] = x.data.0[0];
                    let t0 = q_x1 + T::from_f64(0.15);
                    let t1 = q_x1 + T::from_f64(-0.15);
                    let t2 = q_x2 + T::from_f64(0.9);
                    let t3 = q_x2 + T::from_f64(0.7);
                    [
                        t0,
                        T::from_f64(0.1),
                        T::from_f64(0.1),
                        t1,
                        T::from_f64(0.1),
                        T::from_f64(0.1),
                        t0,
                        T::from_f64(-0.1),
                        T::from_f64(0.1),
                        t1,
                        T::from_f64(-0.1),
                        T::from_f64(0.1),
                        t0,
                        T::from_f64(0.1),
                        T::from_f64(-0.1),
                        t1,
                        T::from_f64(0.1),
                        T::from_f64(-0.1),
                        t0,
                        T::from_f64(-0.1),
                        T::from_f64(-0.1),
                        t1,
                        T::from_f64(-0.1),
                        T::from_f64(-0.1),
                        t2,
                        T::from_f64(0.1),
                        T::from_f64(0.1),
                        t3,
                        T::from_f64(0.1),
                        T::from_f64(0.1),
                        t2,
                        T::from_f64(-0.1),
                        T::from_f64(0.1),
                        t3,
                        T::from_f64(-0.1),
                        T::from_f64(0.1),
                        t2,
                        T::from_f64(0.1),
                        T::from_f64(-0.1),
                        t3,
                        T::from_f64(0.1),
                        T::from_f64(-0.1),
                        t2,
                        T::from_f64(-0.1),
                        T::from_f64(-0.1),
                        t3,
                        T::from_f64(-0.1),
                        T::from_f64(-0.1),
                    ]
                },
            )
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::Cast<4> for Cubic {
        type In<T: ::pendulum_core::real::Real> = Cubic<T>;
        fn cast<T: ::pendulum_core::real::Real>(&self) -> Cubic<T> {
            Cubic::cast(self)
        }
        #[inline]
        fn gather<'m, T: ::pendulum_core::real::lanes::Lanes>(
            models: impl ::core::ops::Fn(usize) -> &'m Self,
        ) -> Cubic<T>
        where
            Self: 'm,
        {
            let scalar = <<T as ::pendulum_core::real::lanes::Lanes>::Scalar as ::pendulum_core::real::Real>::from_f64;
            Cubic {
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
pub use __Cubic::{Cubic, CubicParams};
