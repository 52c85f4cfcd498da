#[allow(non_snake_case)]
mod __RockingBlock {
    ///Parameters of [`RockingBlock`].
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct RockingBlockParams {
        ///In m.
        pub b: f64,
        ///In m.
        pub h: f64,
    }
    impl ::core::default::Default for RockingBlockParams {
        #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
        fn default() -> Self {
            Self { b: 0.08f64, h: 0.25f64 }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl RockingBlockParams {
        /// The names of the parameters, in the order of their declaration.
        pub const NAMES: [&'static str; 2] = ["b", "h"];
        /// The values of the parameters, in the order of [`NAMES`](Self::NAMES).
        pub const fn to_array(self) -> [f64; 2] {
            [self.b, self.h]
        }
        /// The parameters with these values, in the order of [`NAMES`](Self::NAMES).
        pub const fn from_array(values: [f64; 2]) -> Self {
            let [v0, v1] = values;
            Self { b: v0, h: v1 }
        }
    }
    /// A block of the half width `b` and the half height `h` on smooth ground.
    ///
    /**# Equations of motion

```text
A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q all other forces

A[x, x] = 2
A[y, y] = 2
A[phi, phi] = 2/3*(b^2 + h^2)
b[y] = 19.62
Q[y] = force(under_left) + force(under_right)
Q[phi] = force(under_left)*(h*sin(phi) - b*cos(phi)) + force(under_right)*(b*cos(phi) + h*sin(phi))

and along what hinders the motion
force(under_left): a wall at the zero of y - b*sin(phi) - h*cos(phi), restitution 0
force(under_right): a wall at the zero of y + b*sin(phi) - h*cos(phi), restitution 0
```

# Constants, computed by `new`

```text
k0 = b
k1 = h
k2 = 1/3*(b^2 + h^2)
k3 = -1/(2/3*(b^2 + h^2))
k4 = -b/(2/3*(b^2 + h^2))
k5 = -h/(2/3*(b^2 + h^2))
k6 = 1/(2/3*(b^2 + h^2))
```
*/
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct RockingBlock<T = f64> {
        params: RockingBlockParams,
        constants: [T; 7],
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl RockingBlock {
        /// Builds the model: checks the parameters, and computes once whatever depends on them alone.
        ///
        /// # Errors
        ///
        /// The first parameter, or combination of parameters, that is not finite or that no rigid body can
        /// have.
        pub fn new(
            params: RockingBlockParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            #[inline]
            fn rules<T: ::pendulum_core::real::Real>(given: [T; 2]) -> [T; 0] {
                let [p_b, p_h] = given;
                []
            }
            #[inline]
            fn constants<T: ::pendulum_core::real::Real>(given: [T; 2]) -> [T; 7] {
                let [p_b, p_h] = given;
                let t0 = p_b * p_b + p_h * p_h;
                let t1 = T::from_f64(-1.0) / (T::from_f64(0.6666666666666666) * t0);
                [
                    p_b,
                    p_h,
                    T::from_f64(0.3333333333333333) * t0,
                    t1,
                    p_b * t1,
                    p_h * t1,
                    -t1,
                ]
            }
            let given = params.to_array();
            for (name, value) in RockingBlockParams::NAMES.into_iter().zip(given) {
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
            let names: [&'static str; 7] = [
                "b",
                "h",
                "1/3*(b^2 + h^2)",
                "-1/(2/3*(b^2 + h^2))",
                "-b/(2/3*(b^2 + h^2))",
                "-h/(2/3*(b^2 + h^2))",
                "1/(2/3*(b^2 + h^2))",
            ];
            for (name, value) in names.into_iter().zip(constants) {
                if !value.is_finite() {
                    let given: [_; 2] = ::core::array::from_fn(|n| (
                        RockingBlockParams::NAMES[n],
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
        pub fn cast<T: ::pendulum_core::real::Real>(&self) -> RockingBlock<T> {
            RockingBlock {
                params: self.params,
                constants: self.constants.map(T::from_f64),
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> RockingBlock<T> {
        /// The parameters that the model was built from.
        pub fn params(&self) -> &RockingBlockParams {
            &self.params
        }
        /// The model with other parameters, in the same number type. Its constants are computed anew.
        ///
        /// # Errors
        ///
        /// Those of `new`.
        pub fn with_params(
            &self,
            params: RockingBlockParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            Ok(<RockingBlock>::new(params)?.cast())
        }
    }
    impl RockingBlock {
        ///The place of `x` in the state, where it stands in m.
        pub const X: usize = 0;
        ///The place of `dot(x)` in the state, where it stands in m/s.
        pub const DOT_X: usize = 3;
        ///The place of `y` in the state, where it stands in m.
        pub const Y: usize = 1;
        ///The place of `dot(y)` in the state, where it stands in m/s.
        pub const DOT_Y: usize = 4;
        ///The place of `phi` in the state, where it stands in rad.
        pub const PHI: usize = 2;
        ///The place of `dot(phi)` in the state, where it stands in rad/s.
        pub const DOT_PHI: usize = 5;
        /// The number of degrees of freedom; the state has twice as many components.
        pub const DOF: usize = 3;
        /// The names of the coordinates, in the order in which they, and then their rates, stand in the state.
        pub const COORDINATES: [&'static str; 3] = ["x", "y", "phi"];
        /// Counted operations of each generated function, in the form that it has and in others.
        pub const COST: ::pendulum_core::Cost = ::pendulum_core::Cost::new(
            &[
                (
                    "rhs",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first, L^T D L",
                            ::pendulum_core::Operations::new(4, 5, 0, 1, 0, 23),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, L^T D L",
                                    ::pendulum_core::Operations::new(4, 5, 0, 1, 0, 23),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L",
                                    ::pendulum_core::Operations::new(5, 6, 0, 1, 0, 25),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, L^T D L",
                                    ::pendulum_core::Operations::new(5, 6, 0, 1, 0, 25),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "articulated bodies",
                                    ::pendulum_core::Operations::new(5, 6, 0, 1, 0, 25),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C, L^T D L",
                                    ::pendulum_core::Operations::new(11, 13, 1, 1, 0, 25),
                                ),
                            ],
                        ),
                ),
                (
                    "measures",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(6, 6, 0, 1, 0, 24),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(6, 6, 0, 1, 0, 24),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(7, 6, 0, 1, 0, 24),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(7, 6, 0, 1, 0, 24),
                                ),
                            ],
                        ),
                ),
                (
                    "response",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, expanded, L^T D L",
                            ::pendulum_core::Operations::new(13, 20, 0, 1, 0, 28),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first, L^T D L",
                                    ::pendulum_core::Operations::new(15, 21, 0, 1, 0, 27),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, L^T D L",
                                    ::pendulum_core::Operations::new(15, 21, 0, 1, 0, 27),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, L^T D L",
                                    ::pendulum_core::Operations::new(14, 22, 0, 1, 0, 28),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C, L^T D L",
                                    ::pendulum_core::Operations::new(20, 22, 1, 1, 0, 28),
                                ),
                            ],
                        ),
                ),
                (
                    "kinetic",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(2, 4, 0, 0, 0, 3),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(2, 4, 0, 0, 0, 3),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(2, 4, 0, 0, 0, 3),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(2, 6, 0, 0, 0, 5),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C",
                                    ::pendulum_core::Operations::new(6, 14, 0, 0, 0, 9),
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
                                    ::pendulum_core::Operations::new(1, 1, 0, 0, 0, 2),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(1, 1, 0, 0, 0, 2),
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
                            3..4,
                        )
                        .cyclic(),
                    ::pendulum_core::Slot::new(
                        "y",
                        ::pendulum_core::SlotKind::Length,
                        1..2,
                        4..5,
                    ),
                    ::pendulum_core::Slot::new(
                            "phi",
                            ::pendulum_core::SlotKind::Angle,
                            2..3,
                            5..6,
                        )
                        .periodic(),
                ],
            )
            .autonomous();
        /// The equations of motion as text.
        pub const EQUATIONS: &'static str = "A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q all other forces\n\nA[x, x] = 2\nA[y, y] = 2\nA[phi, phi] = 2/3*(b^2 + h^2)\nb[y] = 19.62\nQ[y] = force(under_left) + force(under_right)\nQ[phi] = force(under_left)*(h*sin(phi) - b*cos(phi)) + force(under_right)*(b*cos(phi) + h*sin(phi))\n\nand along what hinders the motion\nforce(under_left): a wall at the zero of y - b*sin(phi) - h*cos(phi), restitution 0\nforce(under_right): a wall at the zero of y + b*sin(phi) - h*cos(phi), restitution 0\n";
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::System<T, 6>
    for RockingBlock<T> {
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn rhs(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 6>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 6> {
            let (laws, measures) = (
                ::pendulum_core::hybrid::Hybrid::<T, 6>::laws(self),
                ::pendulum_core::hybrid::Hybrid::<T, 6>::measures(self, t, x),
            );
            let mut forces = [T::from_f64(0.0); ::pendulum_core::hybrid::MOST];
            for n in 0..2 {
                forces[n] = -laws[n].slipping * measures[n][1].signum();
            }
            ::pendulum_core::System::rhs_under(self, t, x, &forces)
        }
        #[inline]
        fn layout(
            &self,
        ) -> ::core::option::Option<&'static ::pendulum_core::StateLayout> {
            Some(&<RockingBlock>::LAYOUT)
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn rhs_under(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 6>,
            forces: &[T; ::pendulum_core::hybrid::MOST],
        ) -> ::pendulum_core::nalgebra::SVector<T, 6> {
            let [_, _, q_phi, qd_x, qd_y, qd_phi] = x.data.0[0];
            let f0 = forces[0];
            let f1 = forces[1];
            let k4 = self.constants[4];
            let k5 = self.constants[5];
            let t0 = f0 + f1;
            let (sin_phi, cos_phi) = q_phi.sin_cos();
            ::pendulum_core::nalgebra::SVector::from([
                qd_x,
                qd_y,
                qd_phi,
                T::from_f64(0.0),
                T::from_f64(-0.5) * (T::from_f64(19.62) - t0),
                k4 * cos_phi * (f0 - f1) - k5 * sin_phi * t0,
            ])
        }
        #[inline]
        fn hybrid(
            &self,
        ) -> ::core::option::Option<&dyn ::pendulum_core::hybrid::Hybrid<T, 6>> {
            Some(self)
        }
        #[inline]
        fn rhs_in(
            &self,
            hold: &::pendulum_core::hybrid::Hold<T>,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 6>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 6> {
            ::pendulum_core::hybrid::rhs(self, hold, t, x)
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::hybrid::Hybrid<T, 6>
    for RockingBlock<T> {
        #[inline]
        fn constraints(&self) -> &'static [::pendulum_core::hybrid::Constraint] {
            const {
                &[
                    ::pendulum_core::hybrid::Constraint {
                        name: "under_left",
                        rate: &[],
                    },
                    ::pendulum_core::hybrid::Constraint {
                        name: "under_right",
                        rate: &[],
                    },
                ]
            }
        }
        #[inline]
        fn laws(
            &self,
        ) -> [::pendulum_core::hybrid::Law<T>; ::pendulum_core::hybrid::MOST] {
            let mut laws = [::pendulum_core::hybrid::Law::default(); ::pendulum_core::hybrid::MOST];
            laws[0] = ::pendulum_core::hybrid::Law {
                slipping: T::from_f64(0.0),
                sticking: T::from_f64(0.0),
                low: Some(T::from_f64(0.0)),
                high: None,
                restitution: T::from_f64(0.0),
                slow: T::from_f64(0.0),
            };
            laws[1] = ::pendulum_core::hybrid::Law {
                slipping: T::from_f64(0.0),
                sticking: T::from_f64(0.0),
                low: Some(T::from_f64(0.0)),
                high: None,
                restitution: T::from_f64(0.0),
                slow: T::from_f64(0.0),
            };
            laws
        }
        #[inline]
        fn measures(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 6>,
        ) -> [[T; 2]; ::pendulum_core::hybrid::MOST] {
            let [_, q_y, q_phi, _, qd_y, qd_phi] = x.data.0[0];
            let k0 = self.constants[0];
            let k1 = self.constants[1];
            let (sin_phi, cos_phi) = q_phi.sin_cos();
            let t0 = q_y - k1 * cos_phi;
            let t1 = k0 * sin_phi;
            let t2 = qd_y + k1 * sin_phi * qd_phi;
            let t3 = k0 * cos_phi * qd_phi;
            let mut measures = [[T::from_f64(0.0); 2]; ::pendulum_core::hybrid::MOST];
            measures[0] = [t0 - t1, t2 - t3];
            measures[1] = [t1 + t0, t3 + t2];
            measures
        }
        #[inline]
        fn response(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 6>,
            forces: &[T; ::pendulum_core::hybrid::MOST],
        ) -> ::pendulum_core::hybrid::Response<T, 6> {
            let [_, _, q_phi, qd_x, qd_y, qd_phi] = x.data.0[0];
            let f0 = forces[0];
            let f1 = forces[1];
            let k0 = self.constants[0];
            let k1 = self.constants[1];
            let k3 = self.constants[3];
            let k6 = self.constants[6];
            let t0 = T::from_f64(19.62) - f0 - f1;
            let t1 = T::from_f64(-0.5) * t0;
            let t2 = qd_phi * qd_phi;
            let (sin_phi, cos_phi) = q_phi.sin_cos();
            let t3 = T::from_f64(0.5) * t0 - k1 * cos_phi * t2;
            let t4 = k0 * sin_phi * t2;
            let t5 = k0 * cos_phi;
            let t6 = k1 * sin_phi;
            let t7 = t5 - t6;
            let t8 = t5 + t6;
            let t9 = k6 * t8;
            let t10 = k3 * (f0 * t7 - f1 * t8);
            let t11 = t4 - t10 * t7 - t3;
            let t12 = t10 * t8 - t4 - t3;
            let t13 = k3 * t7;
            let t14 = T::from_f64(0.5) - t7 * t13;
            let t15 = k3 * t8;
            let t16 = T::from_f64(0.5) + t7 * t15;
            let t17 = T::from_f64(0.5) - t8 * t15;
            let mut response = ::pendulum_core::hybrid::Response::new(
                ::pendulum_core::nalgebra::SVector::from([
                    qd_x,
                    qd_y,
                    qd_phi,
                    T::from_f64(0.0),
                    t1,
                    t10,
                ]),
            );
            response.accelerations[0] = t11;
            response.accelerations[1] = t12;
            response.columns[0] = ::pendulum_core::nalgebra::SVector::from([
                T::from_f64(0.0),
                T::from_f64(0.0),
                T::from_f64(0.0),
                T::from_f64(0.0),
                T::from_f64(0.5),
                t13,
            ]);
            response.columns[1] = ::pendulum_core::nalgebra::SVector::from([
                T::from_f64(0.0),
                T::from_f64(0.0),
                T::from_f64(0.0),
                T::from_f64(0.0),
                T::from_f64(0.5),
                t9,
            ]);
            response.matrix[0][0] = t14;
            response.matrix[0][1] = t16;
            response.matrix[1][0] = response.matrix[0][1];
            response.matrix[1][1] = t17;
            response
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Energy<T, 6>
    for RockingBlock<T> {
        #[inline]
        fn kinetic(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 6>) -> T {
            let [_, _, _, qd_x, qd_y, qd_phi] = x.data.0[0];
            let k2 = self.constants[2];
            qd_x * qd_x + qd_y * qd_y + qd_phi * (qd_phi * k2)
        }
        #[inline]
        fn potential(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 6>) -> T {
            let [_, q_y, _, _, _, _] = x.data.0[0];
            T::from_f64(-0.0981) + T::from_f64(19.62) * q_y
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::shapes::Shapes<6> for RockingBlock {
        fn shapes(
            &self,
            t: f64,
            x: &::pendulum_core::nalgebra::SVector<f64, 6>,
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
                        name: "block",
                        kind: ::pendulum_core::shapes::ShapeKind::Plate,
                        points: 4,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "block",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "left",
                        kind: ::pendulum_core::shapes::ShapeKind::Point,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "right",
                        kind: ::pendulum_core::shapes::ShapeKind::Point,
                        points: 1,
                        radius: false,
                    },
                ],
                &{
                    let [q_x, q_y, q_phi, _, _, _] = x.data.0[0];
                    let k0 = self.constants[0];
                    let k1 = self.constants[1];
                    let (sin_phi, cos_phi) = q_phi.sin_cos();
                    let t0 = k1 * sin_phi;
                    let t1 = k0 * cos_phi;
                    let t2 = t0 - t1;
                    let t3 = t0 + t1;
                    let t4 = q_x - t2;
                    let t5 = q_x + t2;
                    let t6 = q_x - t3;
                    let t7 = q_x + t3;
                    let t8 = k0 * sin_phi;
                    let t9 = k1 * cos_phi;
                    let t10 = t8 + t9;
                    let t11 = t8 - t9;
                    let t12 = q_y + t10;
                    let t13 = q_y - t10;
                    let t14 = q_y - t11;
                    let t15 = q_y + t11;
                    [
                        T::from_f64(-0.3),
                        T::from_f64(-0.02),
                        T::from_f64(0.0),
                        T::from_f64(0.9),
                        T::from_f64(-0.02),
                        T::from_f64(0.0),
                        T::from_f64(0.9),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(-0.3),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t5,
                        t13,
                        T::from_f64(0.0),
                        t7,
                        t15,
                        T::from_f64(0.0),
                        t4,
                        t12,
                        T::from_f64(0.0),
                        t6,
                        t14,
                        T::from_f64(0.0),
                        q_x,
                        q_y,
                        T::from_f64(0.0),
                        t5,
                        t13,
                        T::from_f64(0.0),
                        t7,
                        t15,
                        T::from_f64(0.0),
                    ]
                },
            )
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::Cast<6> for RockingBlock {
        const HYBRID: bool = true;
        type In<T: ::pendulum_core::real::Real> = RockingBlock<T>;
        fn cast<T: ::pendulum_core::real::Real>(&self) -> RockingBlock<T> {
            RockingBlock::cast(self)
        }
        #[inline]
        fn gather<'m, T: ::pendulum_core::real::lanes::Lanes>(
            models: impl ::core::ops::Fn(usize) -> &'m Self,
        ) -> RockingBlock<T>
        where
            Self: 'm,
        {
            let scalar = <<T as ::pendulum_core::real::lanes::Lanes>::Scalar as ::pendulum_core::real::Real>::from_f64;
            RockingBlock {
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
pub use __RockingBlock::{RockingBlock, RockingBlockParams};
