#[allow(non_snake_case)]
mod __BouncingBall {
    ///Parameters of [`BouncingBall`].
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct BouncingBallParams {
        ///A plain number.
        pub e: f64,
    }
    impl ::core::default::Default for BouncingBallParams {
        #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
        fn default() -> Self {
            Self { e: 0.8f64 }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl BouncingBallParams {
        /// The names of the parameters, in the order of their declaration.
        pub const NAMES: [&'static str; 1] = ["e"];
        /// The values of the parameters, in the order of [`NAMES`](Self::NAMES).
        pub const fn to_array(self) -> [f64; 1] {
            [self.e]
        }
        /// The parameters with these values, in the order of [`NAMES`](Self::NAMES).
        pub const fn from_array(values: [f64; 1]) -> Self {
            let [v0] = values;
            Self { e: v0 }
        }
    }
    /// A ball above the ground, from which it rebounds with `e` times its speed.
    ///
    /**# Equations of motion

```text
A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q all other forces

A[x, x] = 0.06
A[y, y] = 0.06
b[y] = 0.5886
Q[y] = force(ground)

and along what hinders the motion
force(ground): a wall at the zero of y, restitution e
```

# Constants, computed by `new`

```text
k0 = e
```
*/
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct BouncingBall<T = f64> {
        params: BouncingBallParams,
        constants: [T; 1],
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl BouncingBall {
        /// Builds the model: checks the parameters, and computes once whatever depends on them alone.
        ///
        /// # Errors
        ///
        /// The first parameter, or combination of parameters, that is not finite or that no rigid body can
        /// have.
        pub fn new(
            params: BouncingBallParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            #[inline]
            fn rules<T: ::pendulum_core::real::Real>(given: [T; 1]) -> [T; 2] {
                let [p_e] = given;
                [p_e, T::from_f64(1.0) - p_e]
            }
            #[inline]
            fn constants<T: ::pendulum_core::real::Real>(given: [T; 1]) -> [T; 1] {
                let [p_e] = given;
                [p_e]
            }
            let given = params.to_array();
            for (name, value) in BouncingBallParams::NAMES.into_iter().zip(given) {
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
            if !(r0 >= 0.0) {
                return Err(
                    ::pendulum_core::ParameterError::new(
                        "e",
                        r0,
                        "the restitution of wall `ground` must lie between 0 and 1",
                        &[],
                    ),
                );
            }
            if !(r1 >= 0.0) {
                return Err(
                    ::pendulum_core::ParameterError::new(
                        "1 - e",
                        r1,
                        "the restitution of wall `ground` must lie between 0 and 1",
                        &[("e", params.e)],
                    ),
                );
            }
            let constants = constants(given);
            let names: [&'static str; 1] = ["e"];
            for (name, value) in names.into_iter().zip(constants) {
                if !value.is_finite() {
                    let given: [_; 1] = ::core::array::from_fn(|n| (
                        BouncingBallParams::NAMES[n],
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
        pub fn cast<T: ::pendulum_core::real::Real>(&self) -> BouncingBall<T> {
            BouncingBall {
                params: self.params,
                constants: self.constants.map(T::from_f64),
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> BouncingBall<T> {
        /// The parameters that the model was built from.
        pub fn params(&self) -> &BouncingBallParams {
            &self.params
        }
        /// The model with other parameters, in the same number type. Its constants are computed anew.
        ///
        /// # Errors
        ///
        /// Those of `new`.
        pub fn with_params(
            &self,
            params: BouncingBallParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            Ok(<BouncingBall>::new(params)?.cast())
        }
    }
    impl BouncingBall {
        ///The place of `x` in the state, where it stands in m.
        pub const X: usize = 0;
        ///The place of `dot(x)` in the state, where it stands in m/s.
        pub const DOT_X: usize = 2;
        ///The place of `y` in the state, where it stands in m.
        pub const Y: usize = 1;
        ///The place of `dot(y)` in the state, where it stands in m/s.
        pub const DOT_Y: usize = 3;
        /// The number of degrees of freedom; the state has twice as many components.
        pub const DOF: usize = 2;
        /// The names of the coordinates, in the order in which they, and then their rates, stand in the state.
        pub const COORDINATES: [&'static str; 2] = ["x", "y"];
        /// Counted operations of each generated function, in the form that it has and in others.
        pub const COST: ::pendulum_core::Cost = ::pendulum_core::Cost::new(
            &[
                (
                    "rhs",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first, L^T D L",
                            ::pendulum_core::Operations::new(1, 1, 0, 0, 0, 2),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, L^T D L",
                                    ::pendulum_core::Operations::new(1, 1, 0, 0, 0, 2),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L",
                                    ::pendulum_core::Operations::new(1, 1, 0, 0, 0, 2),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C, L^T D L",
                                    ::pendulum_core::Operations::new(1, 1, 0, 0, 0, 2),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, L^T D L",
                                    ::pendulum_core::Operations::new(1, 1, 0, 0, 0, 2),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "articulated bodies",
                                    ::pendulum_core::Operations::new(1, 1, 0, 0, 0, 2),
                                ),
                            ],
                        ),
                ),
                (
                    "measures",
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
                (
                    "response",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first, L^T D L",
                            ::pendulum_core::Operations::new(1, 1, 0, 0, 0, 2),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, L^T D L",
                                    ::pendulum_core::Operations::new(1, 1, 0, 0, 0, 2),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L",
                                    ::pendulum_core::Operations::new(1, 1, 0, 0, 0, 2),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C, L^T D L",
                                    ::pendulum_core::Operations::new(1, 1, 0, 0, 0, 2),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, L^T D L",
                                    ::pendulum_core::Operations::new(1, 1, 0, 0, 0, 2),
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
                                    "A, B and C",
                                    ::pendulum_core::Operations::new(1, 3, 0, 0, 0, 3),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(1, 3, 0, 0, 0, 3),
                                ),
                            ],
                        ),
                ),
                (
                    "potential",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(1, 1, 0, 0, 0, 2),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(1, 1, 0, 0, 0, 2),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(1, 1, 0, 0, 0, 2),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C",
                                    ::pendulum_core::Operations::new(2, 1, 0, 0, 0, 3),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(2, 1, 0, 0, 0, 3),
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
                            "x",
                            ::pendulum_core::SlotKind::Length,
                            0..1,
                            2..3,
                        )
                        .cyclic(),
                    ::pendulum_core::Slot::new(
                        "y",
                        ::pendulum_core::SlotKind::Length,
                        1..2,
                        3..4,
                    ),
                ],
            )
            .autonomous();
        /// The equations of motion as text.
        pub const EQUATIONS: &'static str = "A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q all other forces\n\nA[x, x] = 0.06\nA[y, y] = 0.06\nb[y] = 0.5886\nQ[y] = force(ground)\n\nand along what hinders the motion\nforce(ground): a wall at the zero of y, restitution e\n";
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::System<T, 4>
    for BouncingBall<T> {
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn rhs(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 4> {
            let (laws, measures) = (
                ::pendulum_core::hybrid::Hybrid::<T, 4>::laws(self),
                ::pendulum_core::hybrid::Hybrid::<T, 4>::measures(self, t, x),
            );
            let mut forces = [T::from_f64(0.0); ::pendulum_core::hybrid::MOST];
            for n in 0..1 {
                forces[n] = -laws[n].slipping * measures[n][1].signum();
            }
            ::pendulum_core::System::rhs_under(self, t, x, &forces)
        }
        #[inline]
        fn layout(
            &self,
        ) -> ::core::option::Option<&'static ::pendulum_core::StateLayout> {
            Some(&<BouncingBall>::LAYOUT)
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn rhs_under(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
            forces: &[T; ::pendulum_core::hybrid::MOST],
        ) -> ::pendulum_core::nalgebra::SVector<T, 4> {
            let [_, _, qd_x, qd_y] = x.data.0[0];
            let f0 = forces[0];
            ::pendulum_core::nalgebra::SVector::from([
                qd_x,
                qd_y,
                T::from_f64(0.0),
                T::from_f64(-16.666666666666668) * (T::from_f64(0.5886) - f0),
            ])
        }
        #[inline]
        fn hybrid(
            &self,
        ) -> ::core::option::Option<&dyn ::pendulum_core::hybrid::Hybrid<T, 4>> {
            Some(self)
        }
        #[inline]
        fn rhs_in(
            &self,
            hold: &::pendulum_core::hybrid::Hold<T>,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 4> {
            ::pendulum_core::hybrid::rhs(self, hold, t, x)
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::hybrid::Hybrid<T, 4>
    for BouncingBall<T> {
        #[inline]
        fn constraints(&self) -> &'static [::pendulum_core::hybrid::Constraint] {
            const {
                &[
                    ::pendulum_core::hybrid::Constraint {
                        name: "ground",
                        rate: &[],
                    },
                ]
            }
        }
        #[inline]
        fn laws(
            &self,
        ) -> [::pendulum_core::hybrid::Law<T>; ::pendulum_core::hybrid::MOST] {
            let k0 = self.constants[0];
            let mut laws = [::pendulum_core::hybrid::Law::default(); ::pendulum_core::hybrid::MOST];
            laws[0] = ::pendulum_core::hybrid::Law {
                slipping: T::from_f64(0.0),
                sticking: T::from_f64(0.0),
                low: Some(T::from_f64(0.0)),
                high: None,
                restitution: k0,
                slow: T::from_f64(0.0),
            };
            laws
        }
        #[inline]
        fn measures(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> [[T; 2]; ::pendulum_core::hybrid::MOST] {
            let [_, q_y, _, qd_y] = x.data.0[0];
            let mut measures = [[T::from_f64(0.0); 2]; ::pendulum_core::hybrid::MOST];
            measures[0] = [q_y, qd_y];
            measures
        }
        #[inline]
        fn response(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
            forces: &[T; ::pendulum_core::hybrid::MOST],
        ) -> ::pendulum_core::hybrid::Response<T, 4> {
            let [_, _, qd_x, qd_y] = x.data.0[0];
            let f0 = forces[0];
            let t0 = T::from_f64(-16.666666666666668) * (T::from_f64(0.5886) - f0);
            let mut response = ::pendulum_core::hybrid::Response::new(
                ::pendulum_core::nalgebra::SVector::from([
                    qd_x,
                    qd_y,
                    T::from_f64(0.0),
                    t0,
                ]),
            );
            response.accelerations[0] = t0;
            response.columns[0] = ::pendulum_core::nalgebra::SVector::from([
                T::from_f64(0.0),
                T::from_f64(0.0),
                T::from_f64(0.0),
                T::from_f64(16.666666666666668),
            ]);
            response.matrix[0][0] = T::from_f64(16.666666666666668);
            response
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Energy<T, 4>
    for BouncingBall<T> {
        #[inline]
        fn kinetic(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 4>) -> T {
            let [_, _, qd_x, qd_y] = x.data.0[0];
            T::from_f64(0.03) * (qd_x * qd_x + qd_y * qd_y)
        }
        #[inline]
        fn potential(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 4>) -> T {
            let [_, q_y, _, _] = x.data.0[0];
            T::from_f64(-0.11772) + T::from_f64(0.5886) * q_y
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::shapes::Shapes<4> for BouncingBall {
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
                        name: "floor",
                        kind: ::pendulum_core::shapes::ShapeKind::Plate,
                        points: 4,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "ball",
                        kind: ::pendulum_core::shapes::ShapeKind::Sphere,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "centre",
                        kind: ::pendulum_core::shapes::ShapeKind::Point,
                        points: 1,
                        radius: false,
                    },
                ],
                &{
                    let [q_x, q_y, _, _] = x.data.0[0];
                    let t0 = q_x + T::from_f64(0.05);
                    let t1 = q_y + T::from_f64(0.05);
                    [
                        T::from_f64(-0.1),
                        T::from_f64(-0.03),
                        T::from_f64(0.0),
                        T::from_f64(2.5),
                        T::from_f64(-0.03),
                        T::from_f64(0.0),
                        T::from_f64(2.5),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(-0.1),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        q_x,
                        t1,
                        T::from_f64(0.0),
                        t0,
                        t1,
                        T::from_f64(0.0),
                        q_x,
                        t1,
                        T::from_f64(0.0),
                    ]
                },
            )
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::Cast<4> for BouncingBall {
        const HYBRID: bool = true;
        type In<T: ::pendulum_core::real::Real> = BouncingBall<T>;
        fn cast<T: ::pendulum_core::real::Real>(&self) -> BouncingBall<T> {
            BouncingBall::cast(self)
        }
        #[inline]
        fn gather<'m, T: ::pendulum_core::real::lanes::Lanes>(
            models: impl ::core::ops::Fn(usize) -> &'m Self,
        ) -> BouncingBall<T>
        where
            Self: 'm,
        {
            let scalar = <<T as ::pendulum_core::real::lanes::Lanes>::Scalar as ::pendulum_core::real::Real>::from_f64;
            BouncingBall {
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
pub use __BouncingBall::{BouncingBall, BouncingBallParams};
