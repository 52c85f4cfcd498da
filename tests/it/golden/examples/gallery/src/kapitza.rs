#[allow(non_snake_case)]
mod __Kapitza {
    ///Parameters of [`Kapitza`].
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct KapitzaParams {
        ///In kg.
        pub m: f64,
        ///In m.
        pub l: f64,
        ///In m.
        pub a: f64,
        ///In rad/s.
        pub w: f64,
        ///In N m s.
        pub gamma: f64,
    }
    impl ::core::default::Default for KapitzaParams {
        #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
        fn default() -> Self {
            Self {
                m: 0.3f64,
                l: 0.5f64,
                a: 0.01f64,
                w: 400f64,
                gamma: 0.01f64,
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl KapitzaParams {
        /// The names of the parameters, in the order of their declaration.
        pub const NAMES: [&'static str; 5] = ["m", "l", "a", "w", "gamma"];
        /// The values of the parameters, in the order of [`NAMES`](Self::NAMES).
        pub const fn to_array(self) -> [f64; 5] {
            [self.m, self.l, self.a, self.w, self.gamma]
        }
        /// The parameters with these values, in the order of [`NAMES`](Self::NAMES).
        pub const fn from_array(values: [f64; 5]) -> Self {
            let [v0, v1, v2, v3, v4] = values;
            Self {
                m: v0,
                l: v1,
                a: v2,
                w: v3,
                gamma: v4,
            }
        }
    }
    /// A point mass on a rod without mass, below a pivot that is shaken.
    ///
    /**# Equations of motion

```text
A qdd + b = Q, where A is symmetric, b holds velocity terms, gravity and the inertia forces of the drives,
    Q the forces of the joints

A[theta, theta] = m*l^2
b[theta] = 9.81*m*l*sin(theta) - m*l*a*w^2*cos(w*t)*sin(theta)
Q[theta] = -gamma*dot(theta)
```

# Constants, computed by `new`

```text
k0 = l
k1 = a
k2 = w
k3 = gamma
k4 = m*l
k5 = 9.81*m
k6 = m*l*a*w^2
k7 = m*l*a*w
k8 = 9.81*m*l
k9 = 0.5*m*l^2
k10 = 0.5*m*a^2*w^2
k11 = 9.81*m*a
k12 = -1/(m*l^2)
k13 = -gamma/(m*l^2)
k14 = -1/l
k15 = -a*w^3/l
k16 = m*a*w^2
```
*/
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Kapitza<T = f64> {
        params: KapitzaParams,
        constants: [T; 17],
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl Kapitza {
        /// Builds the model: checks the parameters, and computes once whatever depends on them alone.
        ///
        /// # Errors
        ///
        /// The first parameter, or combination of parameters, that is not finite or that no rigid body can
        /// have.
        pub fn new(
            params: KapitzaParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            #[inline]
            fn rules<T: ::pendulum_core::real::Real>(given: [T; 5]) -> [T; 2] {
                let [p_m, p_l, p_a, p_w, p_gamma] = given;
                [p_m, p_gamma]
            }
            #[inline]
            fn constants<T: ::pendulum_core::real::Real>(given: [T; 5]) -> [T; 17] {
                let [p_m, p_l, p_a, p_w, p_gamma] = given;
                let t0 = T::from_f64(9.81) * p_m;
                let t1 = p_m * p_l;
                let t2 = T::from_f64(9.81) * t1;
                let t3 = p_a * t1;
                let t4 = p_w * t3;
                let t5 = p_w * p_w;
                let t6 = t3 * t5;
                let t7 = T::from_f64(0.5) * (t5 * (p_m * (p_a * p_a)));
                let t8 = p_m * (p_l * p_l);
                let t9 = T::from_f64(0.5) * t8;
                let t10 = T::from_f64(-1.0) / t8;
                let t11 = t1 * t10;
                let t12 = t10 * (t3 * (p_w * p_w * p_w));
                let t13 = p_gamma * t10;
                let t14 = p_m * p_a;
                let t15 = T::from_f64(9.81) * t14;
                let t16 = p_w * (p_w * t14);
                [
                    p_l,
                    p_a,
                    p_w,
                    p_gamma,
                    t1,
                    t0,
                    t6,
                    t4,
                    t2,
                    t9,
                    t7,
                    t15,
                    t10,
                    t13,
                    t11,
                    t12,
                    t16,
                ]
            }
            let given = params.to_array();
            for (name, value) in KapitzaParams::NAMES.into_iter().zip(given) {
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
                        "the mass of a point of `rod` must be positive",
                        &[],
                    ),
                );
            }
            if !(r1 >= 0.0) {
                return Err(
                    ::pendulum_core::ParameterError::new(
                        "gamma",
                        r1,
                        "the friction of `rod` must not be negative",
                        &[],
                    ),
                );
            }
            let constants = constants(given);
            let names: [&'static str; 17] = [
                "l",
                "a",
                "w",
                "gamma",
                "m*l",
                "9.81*m",
                "m*l*a*w^2",
                "m*l*a*w",
                "9.81*m*l",
                "0.5*m*l^2",
                "0.5*m*a^2*w^2",
                "9.81*m*a",
                "-1/(m*l^2)",
                "-gamma/(m*l^2)",
                "-1/l",
                "-a*w^3/l",
                "m*a*w^2",
            ];
            for (name, value) in names.into_iter().zip(constants) {
                if !value.is_finite() {
                    let given: [_; 5] = ::core::array::from_fn(|n| (
                        KapitzaParams::NAMES[n],
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
        pub fn cast<T: ::pendulum_core::real::Real>(&self) -> Kapitza<T> {
            Kapitza {
                params: self.params,
                constants: self.constants.map(T::from_f64),
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> Kapitza<T> {
        /// The parameters that the model was built from.
        pub fn params(&self) -> &KapitzaParams {
            &self.params
        }
        /// The model with other parameters, in the same number type. Its constants are computed anew.
        ///
        /// # Errors
        ///
        /// Those of `new`.
        pub fn with_params(
            &self,
            params: KapitzaParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            Ok(<Kapitza>::new(params)?.cast())
        }
    }
    impl Kapitza {
        ///The place of `theta` in the state, where it stands in rad.
        pub const THETA: usize = 0;
        ///The place of `dot(theta)` in the state, where it stands in rad/s.
        pub const DOT_THETA: usize = 1;
        /// The number of degrees of freedom; the state has twice as many components.
        pub const DOF: usize = 1;
        /// The names of the coordinates, in the order in which they, and then their rates, stand in the state.
        pub const COORDINATES: [&'static str; 1] = ["theta"];
        /// Counted operations of each generated function, in the form that it has and in others.
        pub const COST: ::pendulum_core::Cost = ::pendulum_core::Cost::new(
            &[
                (
                    "rhs",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first, L^T D L",
                            ::pendulum_core::Operations::new(2, 5, 0, 2, 0, 26),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, L^T D L",
                                    ::pendulum_core::Operations::new(2, 5, 0, 2, 0, 26),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L",
                                    ::pendulum_core::Operations::new(2, 5, 0, 2, 0, 23),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, L^T D L",
                                    ::pendulum_core::Operations::new(2, 5, 0, 2, 0, 25),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "articulated bodies",
                                    ::pendulum_core::Operations::new(3, 5, 0, 2, 0, 25),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C, L^T D L",
                                    ::pendulum_core::Operations::new(8, 18, 1, 2, 0, 33),
                                ),
                            ],
                        ),
                ),
                (
                    "jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first, L^T D L, derived and expanded",
                            ::pendulum_core::Operations::new(2, 7, 0, 2, 0, 26),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, L^T D L, derived and expanded",
                                    ::pendulum_core::Operations::new(2, 7, 0, 2, 0, 26),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L, derived and expanded",
                                    ::pendulum_core::Operations::new(2, 7, 0, 2, 0, 26),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, L^T D L, derived in the graph",
                                    ::pendulum_core::Operations::new(2, 7, 0, 2, 0, 26),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C, L^T D L, derived in the graph",
                                    ::pendulum_core::Operations::new(12, 25, 1, 2, 0, 36),
                                ),
                            ],
                        ),
                ),
                (
                    "time_derivative",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first, L^T D L, derived and expanded",
                            ::pendulum_core::Operations::new(0, 3, 0, 2, 0, 22),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, L^T D L, derived and expanded",
                                    ::pendulum_core::Operations::new(0, 3, 0, 2, 0, 22),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L, derived and expanded",
                                    ::pendulum_core::Operations::new(0, 3, 0, 2, 0, 22),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, L^T D L, derived in the graph",
                                    ::pendulum_core::Operations::new(0, 3, 0, 2, 0, 22),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C, L^T D L, derived in the graph",
                                    ::pendulum_core::Operations::new(13, 35, 1, 2, 0, 36),
                                ),
                            ],
                        ),
                ),
                (
                    "kinetic",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(2, 7, 0, 2, 0, 26),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(2, 7, 0, 2, 0, 25),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(2, 8, 0, 2, 0, 25),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(3, 10, 0, 2, 0, 27),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C",
                                    ::pendulum_core::Operations::new(9, 20, 0, 2, 0, 33),
                                ),
                            ],
                        ),
                ),
                (
                    "potential",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(1, 3, 0, 2, 0, 23),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(1, 3, 0, 2, 0, 23),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(1, 3, 0, 2, 0, 23),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C",
                                    ::pendulum_core::Operations::new(1, 3, 0, 2, 0, 23),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(1, 3, 0, 2, 0, 23),
                                ),
                            ],
                        ),
                ),
                (
                    "drive_forces",
                    ::pendulum_core::FunctionCost::new(
                            "recursion",
                            ::pendulum_core::Operations::new(5, 10, 0, 2, 0, 27),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C",
                                    ::pendulum_core::Operations::new(7, 12, 0, 2, 0, 29),
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
                        "theta",
                        ::pendulum_core::SlotKind::Angle,
                        0..1,
                        1..2,
                    )
                    .periodic(),
            ],
        );
        /// The equations of motion as text.
        pub const EQUATIONS: &'static str = "A qdd + b = Q, where A is symmetric, b holds velocity terms, gravity and the inertia forces of the drives,\n    Q the forces of the joints\n\nA[theta, theta] = m*l^2\nb[theta] = 9.81*m*l*sin(theta) - m*l*a*w^2*cos(w*t)*sin(theta)\nQ[theta] = -gamma*dot(theta)\n";
        ///The bodies whose joints are driven.
        pub const DRIVES: [&'static str; 1] = ["pivot"];
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::System<T, 2> for Kapitza<T> {
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn rhs(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 2> {
            let [q_theta, qd_theta] = x.data.0[0];
            let k2 = self.constants[2];
            let k3 = self.constants[3];
            let k6 = self.constants[6];
            let k8 = self.constants[8];
            let k12 = self.constants[12];
            let [(sin_theta, _), (_, cos0)] = q_theta.sin_cos_pair(t * k2);
            ::pendulum_core::nalgebra::SVector::from([
                qd_theta,
                (k3 * qd_theta + sin_theta * (k8 - cos0 * k6)) * k12,
            ])
        }
        #[inline]
        fn layout(
            &self,
        ) -> ::core::option::Option<&'static ::pendulum_core::StateLayout> {
            Some(&<Kapitza>::LAYOUT)
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Jacobian<T, 2> for Kapitza<T> {
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
            let [q_theta, qd_theta] = x.data.0[0];
            let k2 = self.constants[2];
            let k3 = self.constants[3];
            let k6 = self.constants[6];
            let k8 = self.constants[8];
            let k12 = self.constants[12];
            let k13 = self.constants[13];
            let [(sin_theta, cos_theta), (_, cos0)] = q_theta.sin_cos_pair(t * k2);
            let t1 = k8 - cos0 * k6;
            (
                ::pendulum_core::nalgebra::SVector::from([
                    qd_theta,
                    (k3 * qd_theta + sin_theta * t1) * k12,
                ]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [T::from_f64(0.0), k12 * (cos_theta * t1)],
                    [T::from_f64(1.0), k13],
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
            let [q_theta, _] = x.data.0[0];
            let k2 = self.constants[2];
            let k15 = self.constants[15];
            let [(sin_theta, _), (sin0, _)] = q_theta.sin_cos_pair(k2 * t);
            ::pendulum_core::nalgebra::SVector::from([
                T::from_f64(0.0),
                k15 * sin_theta * sin0,
            ])
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Energy<T, 2> for Kapitza<T> {
        #[inline]
        fn kinetic(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 2>) -> T {
            let [q_theta, qd_theta] = x.data.0[0];
            let k2 = self.constants[2];
            let k7 = self.constants[7];
            let k9 = self.constants[9];
            let k10 = self.constants[10];
            let [(sin0, _), (sin_theta, _)] = (t * k2).sin_cos_pair(q_theta);
            sin0 * (sin0 * k10) + qd_theta * (qd_theta * k9 - sin_theta * (sin0 * k7))
        }
        #[inline]
        fn potential(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 2>) -> T {
            let [q_theta, _] = x.data.0[0];
            let k2 = self.constants[2];
            let k8 = self.constants[8];
            let k11 = self.constants[11];
            let [(_, cos0), (_, cos_theta)] = (k2 * t).sin_cos_pair(q_theta);
            k11 * cos0 - k8 * cos_theta
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> Kapitza<T> {
        ///The forces that the drives supply along their joints, in the order of the declaration: N m where a joint turns, N where it slides.
        #[inline]
        pub fn drive_forces(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 1> {
            let [q_theta, qd_theta] = x.data.0[0];
            let k2 = self.constants[2];
            let k3 = self.constants[3];
            let k4 = self.constants[4];
            let k5 = self.constants[5];
            let k6 = self.constants[6];
            let k8 = self.constants[8];
            let k14 = self.constants[14];
            let k16 = self.constants[16];
            let [(_, cos0), (sin_theta, cos_theta)] = (k2 * t).sin_cos_pair(q_theta);
            ::pendulum_core::nalgebra::SVector::from([
                k5 - k16 * cos0 + k4 * cos_theta * qd_theta * qd_theta
                    + k14 * sin_theta * (k3 * qd_theta + sin_theta * (k8 - k6 * cos0)),
            ])
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::shapes::Shapes<2> for Kapitza {
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
                        name: "rod",
                        kind: ::pendulum_core::shapes::ShapeKind::Mass,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "rod",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "bob",
                        kind: ::pendulum_core::shapes::ShapeKind::Point,
                        points: 1,
                        radius: false,
                    },
                ],
                &{
                    let [q_theta, _] = x.data.0[0];
                    let k0 = self.constants[0];
                    let k1 = self.constants[1];
                    let k2 = self.constants[2];
                    let [(sin_theta, cos_theta), (_, cos0)] = q_theta
                        .sin_cos_pair(t * k2);
                    let t1 = k0 * sin_theta;
                    let t2 = k1 * cos0;
                    let t3 = t2 - k0 * cos_theta;
                    [
                        t1,
                        t3,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t2,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t2,
                        T::from_f64(0.0),
                        t1,
                        t3,
                        T::from_f64(0.0),
                    ]
                },
            )
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::CastJacobian<2> for Kapitza {
        #[inline]
        fn with_jacobian<T: ::pendulum_core::real::Real>(
            model: &Kapitza<T>,
        ) -> &impl ::pendulum_core::Jacobian<T, 2> {
            model
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::Cast<2> for Kapitza {
        type In<T: ::pendulum_core::real::Real> = Kapitza<T>;
        fn cast<T: ::pendulum_core::real::Real>(&self) -> Kapitza<T> {
            Kapitza::cast(self)
        }
        #[inline]
        fn gather<'m, T: ::pendulum_core::real::lanes::Lanes>(
            models: impl ::core::ops::Fn(usize) -> &'m Self,
        ) -> Kapitza<T>
        where
            Self: 'm,
        {
            let scalar = <<T as ::pendulum_core::real::lanes::Lanes>::Scalar as ::pendulum_core::real::Real>::from_f64;
            Kapitza {
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
pub use __Kapitza::{Kapitza, KapitzaParams};
