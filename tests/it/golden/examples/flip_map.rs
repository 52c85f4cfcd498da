#[allow(non_snake_case)]
mod __Rods {
    ///Parameters of [`Rods`].
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct RodsParams {}
    impl ::core::default::Default for RodsParams {
        #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
        fn default() -> Self {
            Self {}
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl RodsParams {
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
    /// Two equal rods of 1 m without friction; both angles are from hanging.
    ///
    /**# Equations of motion

```text
A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints

A[theta1, theta1] = 4/3
A[theta1, theta2] = 0.5*cos(theta1 - theta2)
A[theta2, theta2] = 1/3
b[theta1] = 14.715*sin(theta1) + 0.5*dot(theta2)^2*sin(theta1 - theta2)
b[theta2] = 4.905*sin(theta2) - 0.5*dot(theta1)^2*sin(theta1 - theta2)
```
*/
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Rods<T = f64> {
        params: RodsParams,
        constants: [T; 0],
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl Rods {
        /// Builds the model: checks the parameters, and computes once whatever depends on them alone.
        ///
        /// # Errors
        ///
        /// The first parameter, or combination of parameters, that is not finite or that no rigid body can
        /// have.
        pub fn new(
            params: RodsParams,
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
            for (name, value) in RodsParams::NAMES.into_iter().zip(given) {
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
                        RodsParams::NAMES[n],
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
        pub fn cast<T: ::pendulum_core::real::Real>(&self) -> Rods<T> {
            Rods {
                params: self.params,
                constants: self.constants.map(T::from_f64),
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> Rods<T> {
        /// The parameters that the model was built from.
        pub fn params(&self) -> &RodsParams {
            &self.params
        }
        /// The model with other parameters, in the same number type. Its constants are computed anew.
        ///
        /// # Errors
        ///
        /// Those of `new`.
        pub fn with_params(
            &self,
            params: RodsParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            Ok(<Rods>::new(params)?.cast())
        }
    }
    impl Rods {
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
                            "closed form, factors of the state first, L^T D L",
                            ::pendulum_core::Operations::new(8, 18, 1, 2, 0, 32),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, L^T D L",
                                    ::pendulum_core::Operations::new(8, 18, 1, 2, 0, 32),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L",
                                    ::pendulum_core::Operations::new(8, 18, 1, 2, 0, 32),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, adjugate",
                                    ::pendulum_core::Operations::new(21, 27, 1, 2, 0, 37),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C, adjugate",
                                    ::pendulum_core::Operations::new(29, 33, 1, 2, 0, 39),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "articulated bodies",
                                    ::pendulum_core::Operations::new(24, 38, 2, 2, 0, 48),
                                ),
                            ],
                        ),
                ),
                (
                    "taylor",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first, inverse",
                            ::pendulum_core::Operations::new(26, 33, 0, 0, 0, 10),
                        )
                        .with_products(12)
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                        "closed form, factors of parameters first, inverse",
                                        ::pendulum_core::Operations::new(26, 33, 0, 0, 0, 10),
                                    )
                                    .with_products(12),
                                ::pendulum_core::FunctionCost::new(
                                        "closed form, expanded, inverse",
                                        ::pendulum_core::Operations::new(26, 33, 0, 0, 0, 10),
                                    )
                                    .with_products(12),
                                ::pendulum_core::FunctionCost::new(
                                        "recursion, inverse",
                                        ::pendulum_core::Operations::new(66, 53, 0, 0, 0, 18),
                                    )
                                    .with_products(22),
                                ::pendulum_core::FunctionCost::new(
                                        "A, B and C, inverse",
                                        ::pendulum_core::Operations::new(81, 59, 0, 0, 0, 18),
                                    )
                                    .with_products(26),
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
        pub const EQUATIONS: &'static str = "A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints\n\nA[theta1, theta1] = 4/3\nA[theta1, theta2] = 0.5*cos(theta1 - theta2)\nA[theta2, theta2] = 1/3\nb[theta1] = 14.715*sin(theta1) + 0.5*dot(theta2)^2*sin(theta1 - theta2)\nb[theta2] = 4.905*sin(theta2) - 0.5*dot(theta1)^2*sin(theta1 - theta2)\n";
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::System<T, 4> for Rods<T> {
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn rhs(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 4> {
            let [q_theta1, q_theta2, qd_theta1, qd_theta2] = x.data.0[0];
            let [(sin_theta1, cos_theta1), (sin_theta2, cos_theta2)] = q_theta1
                .sin_cos_pair(q_theta2);
            let t0 = sin_theta1 * cos_theta2 - cos_theta1 * sin_theta2;
            let t1 = T::from_f64(0.5) * t0;
            let t2 = T::from_f64(4.905) * sin_theta2 - qd_theta1 * qd_theta1 * t1;
            let t3 = T::from_f64(1.5)
                * (cos_theta2 * cos_theta1 + sin_theta1 * sin_theta2);
            let t4 = T::from_f64(-0.3333333333333333)
                / (T::from_f64(0.19444444444444445) + T::from_f64(0.25) * t0 * t0)
                * (T::from_f64(14.715) * sin_theta1 + qd_theta2 * qd_theta2 * t1
                    - t2 * t3);
            ::pendulum_core::nalgebra::SVector::from([
                qd_theta1,
                qd_theta2,
                t4,
                -(T::from_f64(3.0) * t2 + t3 * t4),
            ])
        }
        #[inline]
        fn layout(
            &self,
        ) -> ::core::option::Option<&'static ::pendulum_core::StateLayout> {
            Some(&<Rods>::LAYOUT)
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::taylor::TaylorSeries<T, 4>
    for Rods<T> {
        type Workspace = ::pendulum_core::taylor::Products<T, 12>;
        #[inline]
        fn workspace(&self) -> Self::Workspace {
            ::pendulum_core::taylor::Products::new()
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn series(
            &self,
            t: T,
            x: &mut [::pendulum_core::nalgebra::SVector<T, 4>],
            work: &mut Self::Workspace,
        ) {
            if x.len() < 2 {
                return;
            }
            let (
                a0,
                a1,
                a2,
                a3,
                h0,
                h1,
                h2,
                h3,
                h4,
                h5,
                h6,
                h7,
                h8,
                h9,
                h10,
                h11,
                h12,
                h13,
                h14,
            ) = {
                let x = &x[0];
                {
                    let [q_theta1, q_theta2, qd_theta1, qd_theta2] = x.data.0[0];
                    let t0 = T::from_f64(0.5) * qd_theta2;
                    let t1 = qd_theta2 * t0;
                    let t2 = T::from_f64(0.5) * qd_theta1;
                    let t3 = qd_theta1 * t2;
                    let [(sin_theta1, cos_theta1), (sin_theta2, cos_theta2)] = q_theta1
                        .sin_cos_pair(q_theta2);
                    let t4 = sin_theta1 * cos_theta2 - cos_theta1 * sin_theta2;
                    let t5 = T::from_f64(14.715) * sin_theta1 + t1 * t4;
                    let t6 = T::from_f64(4.905) * sin_theta2 - t3 * t4;
                    let t7 = cos_theta1 * cos_theta2 + sin_theta1 * sin_theta2;
                    let t8 = T::from_f64(-1.0)
                        / (T::from_f64(0.19444444444444445)
                            + t4 * (T::from_f64(0.25) * t4));
                    let t9 = T::from_f64(0.5) * t7 * t8;
                    let t10 = T::from_f64(0.3333333333333333) * t8;
                    let t11 = t5 * t10 - t6 * t9;
                    let t12 = T::from_f64(0.5) * t11;
                    let t13 = T::from_f64(1.3333333333333333) * t8;
                    let t14 = t6 * t13 - t5 * t9;
                    let t15 = T::from_f64(0.5) * t14;
                    (
                        qd_theta1,
                        qd_theta2,
                        t11,
                        t14,
                        sin_theta1,
                        cos_theta1,
                        sin_theta2,
                        cos_theta2,
                        t7,
                        t4,
                        t0,
                        t1,
                        t2,
                        t3,
                        t10,
                        t9,
                        t13,
                        t15,
                        t12,
                    )
                }
            };
            x[1] = ::pendulum_core::nalgebra::SVector::from([a0, a1, a2, a3]);
            let mut over_next = T::from_f64(1.0);
            let mut newest = ::pendulum_core::taylor::Newest::new();
            for k in 1..x.len() - 1 {
                let order = T::from_f64(k as f64);
                let over_order = over_next;
                over_next = T::from_f64(1.0) / T::from_f64((k + 1) as f64);
                let [s0, s1, s2, s3, s4, s5, s6, s7, s8, s9, s10, s11] = newest
                    .add(work.sums(k));
                let [x0, x1, x2, x3] = x[k].data.0[0];
                let t0 = -(over_order * s10 + x0 * h0);
                let t1 = -(over_order * s11 + x1 * h2);
                let t2 = over_order * s0 + x0 * h1;
                let t3 = x3 * h6;
                let t4 = t3 + (T::from_f64(0.5) * s2 + t3);
                let t5 = x0 - x1;
                let t6 = over_order * s1 + t5 * h4;
                let t7 = over_order * s4 + t5 * h5;
                let t8 = T::from_f64(14.715) * t2 + (h5 * t4 + (s3 + h7 * t6))
                    + (T::from_f64(0.5) * s5 - h13 * t7);
                let t9 = order * t5;
                let t10 = over_order * s6 + x1 * h3;
                let t11 = x2 * h8;
                let t12 = t11 + (T::from_f64(0.5) * s7 + t11);
                let t13 = T::from_f64(4.905) * t10 - (h5 * t12 + (s8 + h9 * t6))
                    + (T::from_f64(0.5) * s9 - h14 * t7);
                let t14 = -t7;
                let t15 = h10 * t8 - h11 * t13;
                let t16 = h12 * t13 - h11 * t8;
                let t17 = order * x0;
                let t18 = order * x1;
                let (left, right) = (
                    [t17, t9, x3, t6, t9, t14, t18, x2, t6, t14, t17, t18],
                    [t0, t14, x3, t4, t6, t16, t1, x2, t12, t15, t2, t10],
                );
                newest.push(k, left, right);
                work.set(k, left, right);
                x[k + 1] = ::pendulum_core::nalgebra::SVector::from([
                    x2 * over_next,
                    x3 * over_next,
                    t15 * over_next,
                    t16 * over_next,
                ]);
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::taylor::CastTaylor<4> for Rods {
        type Workspace<T: ::pendulum_core::real::Real> = ::pendulum_core::taylor::Products<
            T,
            12,
        >;
        #[inline]
        fn workspace<T: ::pendulum_core::real::Real>() -> ::pendulum_core::taylor::Products<
            T,
            12,
        > {
            ::pendulum_core::taylor::Products::new()
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn series<T: ::pendulum_core::real::Real>(
            system: &Rods<T>,
            t: T,
            x: &mut [::pendulum_core::nalgebra::SVector<T, 4>],
            work: &mut ::pendulum_core::taylor::Products<T, 12>,
        ) {
            ::pendulum_core::taylor::TaylorSeries::series(system, t, x, work);
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::Cast<4> for Rods {
        type In<T: ::pendulum_core::real::Real> = Rods<T>;
        fn cast<T: ::pendulum_core::real::Real>(&self) -> Rods<T> {
            Rods::cast(self)
        }
        #[inline]
        fn gather<'m, T: ::pendulum_core::real::lanes::Lanes>(
            models: impl ::core::ops::Fn(usize) -> &'m Self,
        ) -> Rods<T>
        where
            Self: 'm,
        {
            let scalar = <<T as ::pendulum_core::real::lanes::Lanes>::Scalar as ::pendulum_core::real::Real>::from_f64;
            Rods {
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
use __Rods::{Rods, RodsParams};
