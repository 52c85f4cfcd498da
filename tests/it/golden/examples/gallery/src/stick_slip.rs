#[allow(non_snake_case)]
mod __StickSlip {
    ///Parameters of [`StickSlip`].
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct StickSlipParams {
        ///In kg.
        pub m: f64,
        ///In N/m.
        pub k: f64,
        ///In m/s.
        pub v: f64,
        ///In N.
        pub slipping: f64,
        ///In N.
        pub sticking: f64,
    }
    impl ::core::default::Default for StickSlipParams {
        #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
        fn default() -> Self {
            Self {
                m: 1f64,
                k: 40f64,
                v: 0.2f64,
                slipping: 3f64,
                sticking: 5f64,
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl StickSlipParams {
        /// The names of the parameters, in the order of their declaration.
        pub const NAMES: [&'static str; 5] = ["m", "k", "v", "slipping", "sticking"];
        /// The values of the parameters, in the order of [`NAMES`](Self::NAMES).
        pub const fn to_array(self) -> [f64; 5] {
            [self.m, self.k, self.v, self.slipping, self.sticking]
        }
        /// The parameters with these values, in the order of [`NAMES`](Self::NAMES).
        pub const fn from_array(values: [f64; 5]) -> Self {
            let [v0, v1, v2, v3, v4] = values;
            Self {
                m: v0,
                k: v1,
                v: v2,
                slipping: v3,
                sticking: v4,
            }
        }
    }
    /// A block on a belt that runs at the speed `v`, tied to the ground by a spring.
    ///
    /**# Equations of motion

```text
A qdd + b = Q, where A is symmetric, b holds velocity terms, gravity and the inertia forces of the drives,
    Q all other forces

A[s, s] = m
Q[s] = force(s) - k*(0.24 + s + v*t)*(1 - 0.24/sqrt((0.24 + s + v*t)^2))

and along what hinders the motion
force(s): dry friction of slipping, at rest up to sticking
```

# Constants, computed by `new`

```text
k0 = k
k1 = v
k2 = slipping
k3 = sticking
k4 = m*v
k5 = 0.5*m
k6 = 0.5*m*v^2
k7 = 0.5*k
k8 = -1/m
k9 = 1/m
k10 = -slipping
k11 = -k
```
*/
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct StickSlip<T = f64> {
        params: StickSlipParams,
        constants: [T; 12],
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl StickSlip {
        /// Builds the model: checks the parameters, and computes once whatever depends on them alone.
        ///
        /// # Errors
        ///
        /// The first parameter, or combination of parameters, that is not finite or that no rigid body can
        /// have.
        pub fn new(
            params: StickSlipParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            #[inline]
            fn rules<T: ::pendulum_core::real::Real>(given: [T; 5]) -> [T; 3] {
                let [p_m, p_k, p_v, p_slipping, p_sticking] = given;
                [p_m, p_slipping, p_sticking - p_slipping]
            }
            #[inline]
            fn constants<T: ::pendulum_core::real::Real>(given: [T; 5]) -> [T; 12] {
                let [p_m, p_k, p_v, p_slipping, p_sticking] = given;
                let t0 = p_m * p_v;
                let t1 = T::from_f64(0.5) * p_m;
                let t2 = T::from_f64(0.5) * (p_m * (p_v * p_v));
                let t3 = T::from_f64(0.5) * p_k;
                let t4 = T::from_f64(-1.0) / p_m;
                let t5 = -t4;
                let t6 = p_m * t4;
                let t7 = p_slipping * t6;
                let t8 = p_k * t6;
                [p_k, p_v, p_slipping, p_sticking, t0, t1, t2, t3, t4, t5, t7, t8]
            }
            let given = params.to_array();
            for (name, value) in StickSlipParams::NAMES.into_iter().zip(given) {
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
                        "the mass of a cuboid of `block` must be positive",
                        &[],
                    ),
                );
            }
            if !(r1 >= 0.0) {
                return Err(
                    ::pendulum_core::ParameterError::new(
                        "slipping",
                        r1,
                        "the dry friction of `block` must not be negative",
                        &[],
                    ),
                );
            }
            if !(r2 >= 0.0) {
                return Err(
                    ::pendulum_core::ParameterError::new(
                        "sticking - slipping",
                        r2,
                        "the static friction of `block` must not be below its dry friction",
                        &[("slipping", params.slipping), ("sticking", params.sticking)],
                    ),
                );
            }
            let constants = constants(given);
            let names: [&'static str; 12] = [
                "k",
                "v",
                "slipping",
                "sticking",
                "m*v",
                "0.5*m",
                "0.5*m*v^2",
                "0.5*k",
                "-1/m",
                "1/m",
                "-slipping",
                "-k",
            ];
            for (name, value) in names.into_iter().zip(constants) {
                if !value.is_finite() {
                    let given: [_; 5] = ::core::array::from_fn(|n| (
                        StickSlipParams::NAMES[n],
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
        pub fn cast<T: ::pendulum_core::real::Real>(&self) -> StickSlip<T> {
            StickSlip {
                params: self.params,
                constants: self.constants.map(T::from_f64),
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> StickSlip<T> {
        /// The parameters that the model was built from.
        pub fn params(&self) -> &StickSlipParams {
            &self.params
        }
        /// The model with other parameters, in the same number type. Its constants are computed anew.
        ///
        /// # Errors
        ///
        /// Those of `new`.
        pub fn with_params(
            &self,
            params: StickSlipParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            Ok(<StickSlip>::new(params)?.cast())
        }
    }
    impl StickSlip {
        ///The place of `s` in the state, where it stands in m.
        pub const S: usize = 0;
        ///The place of `dot(s)` in the state, where it stands in m/s.
        pub const DOT_S: usize = 1;
        /// The number of degrees of freedom; the state has twice as many components.
        pub const DOF: usize = 1;
        /// The names of the coordinates, in the order in which they, and then their rates, stand in the state.
        pub const COORDINATES: [&'static str; 1] = ["s"];
        /// Counted operations of each generated function, in the form that it has and in others.
        pub const COST: ::pendulum_core::Cost = ::pendulum_core::Cost::new(
            &[
                (
                    "rhs",
                    ::pendulum_core::FunctionCost::new(
                            "A, B and C, L^T D L",
                            ::pendulum_core::Operations::new(4, 5, 1, 0, 1, 15),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, L^T D L",
                                    ::pendulum_core::Operations::new(4, 5, 1, 0, 1, 15),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "articulated bodies",
                                    ::pendulum_core::Operations::new(4, 5, 1, 0, 1, 15),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first, L^T D L",
                                    ::pendulum_core::Operations::new(16, 24, 1, 0, 1, 14),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, L^T D L",
                                    ::pendulum_core::Operations::new(15, 26, 1, 0, 1, 19),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L",
                                    ::pendulum_core::Operations::new(16, 29, 1, 0, 1, 19),
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
                            "A, B and C, L^T D L",
                            ::pendulum_core::Operations::new(4, 5, 1, 0, 1, 15),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, L^T D L",
                                    ::pendulum_core::Operations::new(4, 5, 1, 0, 1, 15),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first, L^T D L",
                                    ::pendulum_core::Operations::new(16, 24, 1, 0, 1, 14),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, L^T D L",
                                    ::pendulum_core::Operations::new(15, 26, 1, 0, 1, 19),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L",
                                    ::pendulum_core::Operations::new(16, 29, 1, 0, 1, 19),
                                ),
                            ],
                        ),
                ),
                (
                    "kinetic",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(2, 2, 0, 0, 0, 4),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(2, 2, 0, 0, 0, 4),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(2, 2, 0, 0, 0, 4),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(1, 3, 0, 0, 0, 4),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C",
                                    ::pendulum_core::Operations::new(2, 3, 0, 0, 0, 4),
                                ),
                            ],
                        ),
                ),
                (
                    "potential",
                    ::pendulum_core::FunctionCost::new(
                            "A, B and C",
                            ::pendulum_core::Operations::new(3, 4, 0, 0, 1, 10),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(3, 4, 0, 0, 1, 10),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(11, 16, 0, 0, 1, 16),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(11, 16, 0, 0, 1, 16),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(11, 18, 0, 0, 1, 13),
                                ),
                            ],
                        ),
                ),
                (
                    "drive_forces",
                    ::pendulum_core::FunctionCost::new(
                            "A, B and C",
                            ::pendulum_core::Operations::new(5, 7, 1, 0, 2, 16),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(5, 7, 1, 0, 2, 16),
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
                    "s",
                    ::pendulum_core::SlotKind::Length,
                    0..1,
                    1..2,
                ),
            ],
        );
        /// The equations of motion as text.
        pub const EQUATIONS: &'static str = "A qdd + b = Q, where A is symmetric, b holds velocity terms, gravity and the inertia forces of the drives,\n    Q all other forces\n\nA[s, s] = m\nQ[s] = force(s) - k*(0.24 + s + v*t)*(1 - 0.24/sqrt((0.24 + s + v*t)^2))\n\nand along what hinders the motion\nforce(s): dry friction of slipping, at rest up to sticking\n";
        ///The bodies whose joints are driven.
        pub const DRIVES: [&'static str; 1] = ["belt"];
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::System<T, 2> for StickSlip<T> {
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn rhs(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 2> {
            let (laws, measures) = (
                ::pendulum_core::hybrid::Hybrid::<T, 2>::laws(self),
                ::pendulum_core::hybrid::Hybrid::<T, 2>::measures(self, t, x),
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
            Some(&<StickSlip>::LAYOUT)
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn rhs_under(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
            forces: &[T; ::pendulum_core::hybrid::MOST],
        ) -> ::pendulum_core::nalgebra::SVector<T, 2> {
            let [q_s, qd_s] = x.data.0[0];
            let f0 = forces[0];
            let k0 = self.constants[0];
            let k1 = self.constants[1];
            let k8 = self.constants[8];
            let t0 = T::from_f64(0.24) + q_s + k1 * t;
            ::pendulum_core::nalgebra::SVector::from([
                qd_s,
                k8
                    * (k0 * t0
                        * (T::from_f64(1.0) - T::from_f64(0.24) / (t0 * t0).sqrt()) - f0),
            ])
        }
        #[inline]
        fn hybrid(
            &self,
        ) -> ::core::option::Option<&dyn ::pendulum_core::hybrid::Hybrid<T, 2>> {
            Some(self)
        }
        #[inline]
        fn rhs_in(
            &self,
            hold: &::pendulum_core::hybrid::Hold<T>,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 2> {
            ::pendulum_core::hybrid::rhs(self, hold, t, x)
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::hybrid::Hybrid<T, 2>
    for StickSlip<T> {
        #[inline]
        fn constraints(&self) -> &'static [::pendulum_core::hybrid::Constraint] {
            const {
                &[
                    ::pendulum_core::hybrid::Constraint {
                        name: "s",
                        rate: &[(1, 1)],
                    },
                ]
            }
        }
        #[inline]
        fn laws(
            &self,
        ) -> [::pendulum_core::hybrid::Law<T>; ::pendulum_core::hybrid::MOST] {
            let k2 = self.constants[2];
            let k3 = self.constants[3];
            let mut laws = [::pendulum_core::hybrid::Law::default(); ::pendulum_core::hybrid::MOST];
            laws[0] = ::pendulum_core::hybrid::Law {
                slipping: k2,
                sticking: k3,
                low: None,
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
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
        ) -> [[T; 2]; ::pendulum_core::hybrid::MOST] {
            let [q_s, qd_s] = x.data.0[0];
            let mut measures = [[T::from_f64(0.0); 2]; ::pendulum_core::hybrid::MOST];
            measures[0] = [q_s, qd_s];
            measures
        }
        #[inline]
        fn response(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
            forces: &[T; ::pendulum_core::hybrid::MOST],
        ) -> ::pendulum_core::hybrid::Response<T, 2> {
            let [q_s, qd_s] = x.data.0[0];
            let f0 = forces[0];
            let k0 = self.constants[0];
            let k1 = self.constants[1];
            let k8 = self.constants[8];
            let k9 = self.constants[9];
            let t0 = T::from_f64(0.24) + q_s + k1 * t;
            let t1 = k8
                * (k0 * t0 * (T::from_f64(1.0) - T::from_f64(0.24) / (t0 * t0).sqrt())
                    - f0);
            let mut response = ::pendulum_core::hybrid::Response::new(
                ::pendulum_core::nalgebra::SVector::from([qd_s, t1]),
            );
            response.accelerations[0] = t1;
            response.columns[0] = ::pendulum_core::nalgebra::SVector::from([
                T::from_f64(0.0),
                k9,
            ]);
            response.matrix[0][0] = k9;
            response
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Energy<T, 2> for StickSlip<T> {
        #[inline]
        fn kinetic(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 2>) -> T {
            let [_, qd_s] = x.data.0[0];
            let k4 = self.constants[4];
            let k5 = self.constants[5];
            let k6 = self.constants[6];
            k6 + qd_s * (k4 + qd_s * k5)
        }
        #[inline]
        fn potential(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 2>) -> T {
            let [q_s, _] = x.data.0[0];
            let k1 = self.constants[1];
            let k7 = self.constants[7];
            let t0 = T::from_f64(0.24) + q_s + k1 * t;
            let t1 = (t0 * t0).sqrt() - T::from_f64(0.24);
            k7 * t1 * t1
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> StickSlip<T> {
        ///The forces that the drives supply along their joints, in the order of the declaration: N m where a joint turns, N where it slides.
        #[inline]
        pub fn drive_forces(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 1> {
            let [q_s, qd_s] = x.data.0[0];
            let k0 = self.constants[0];
            let k1 = self.constants[1];
            let k10 = self.constants[10];
            let k11 = self.constants[11];
            let t0 = T::from_f64(0.24) + (q_s + k1 * t);
            let t1 = T::from_f64(1.0) - T::from_f64(0.24) / (t0 * t0).sqrt();
            ::pendulum_core::nalgebra::SVector::from([
                k0 * t0 * t1 + (k10 * qd_s.signum() + k11 * t0 * t1),
            ])
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::shapes::Shapes<2> for StickSlip {
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
                        name: "board",
                        kind: ::pendulum_core::shapes::ShapeKind::Plate,
                        points: 4,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "block",
                        kind: ::pendulum_core::shapes::ShapeKind::Cuboid,
                        points: 8,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "ground",
                        kind: ::pendulum_core::shapes::ShapeKind::Spring,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "nail",
                        kind: ::pendulum_core::shapes::ShapeKind::Anchor,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "eye",
                        kind: ::pendulum_core::shapes::ShapeKind::Point,
                        points: 1,
                        radius: false,
                    },
                ],
                &{
                    let [q_s, _] = x.data.0[0];
                    let k1 = self.constants[1];
                    let t0 = q_s + t * k1;
                    let t1 = T::from_f64(0.06) + t0;
                    let t2 = T::from_f64(-0.06) + t0;
                    [
                        T::from_f64(-0.1),
                        T::from_f64(-0.05),
                        T::from_f64(0.0),
                        T::from_f64(0.2),
                        T::from_f64(-0.05),
                        T::from_f64(0.0),
                        T::from_f64(0.2),
                        T::from_f64(-0.04),
                        T::from_f64(0.0),
                        T::from_f64(-0.1),
                        T::from_f64(-0.04),
                        T::from_f64(0.0),
                        t1,
                        T::from_f64(0.04),
                        T::from_f64(0.04),
                        t2,
                        T::from_f64(0.04),
                        T::from_f64(0.04),
                        t1,
                        T::from_f64(-0.04),
                        T::from_f64(0.04),
                        t2,
                        T::from_f64(-0.04),
                        T::from_f64(0.04),
                        t1,
                        T::from_f64(0.04),
                        T::from_f64(-0.04),
                        t2,
                        T::from_f64(0.04),
                        T::from_f64(-0.04),
                        t1,
                        T::from_f64(-0.04),
                        T::from_f64(-0.04),
                        t2,
                        T::from_f64(-0.04),
                        T::from_f64(-0.04),
                        T::from_f64(-0.3),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t2,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(-0.3),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t2,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                    ]
                },
            )
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::Cast<2> for StickSlip {
        const HYBRID: bool = true;
        type In<T: ::pendulum_core::real::Real> = StickSlip<T>;
        fn cast<T: ::pendulum_core::real::Real>(&self) -> StickSlip<T> {
            StickSlip::cast(self)
        }
        #[inline]
        fn gather<'m, T: ::pendulum_core::real::lanes::Lanes>(
            models: impl ::core::ops::Fn(usize) -> &'m Self,
        ) -> StickSlip<T>
        where
            Self: 'm,
        {
            let scalar = <<T as ::pendulum_core::real::lanes::Lanes>::Scalar as ::pendulum_core::real::Real>::from_f64;
            StickSlip {
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
pub use __StickSlip::{StickSlip, StickSlipParams};
