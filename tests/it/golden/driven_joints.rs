#[allow(non_snake_case)]
mod __DrivenPivot {
    ///Parameters of [`DrivenPivot`].
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct DrivenPivotParams {
        ///In kg.
        pub m1: f64,
        ///In kg.
        pub m2: f64,
        ///In m.
        pub l1: f64,
        ///In m.
        pub l2: f64,
        ///In m.
        pub a: f64,
        ///In m.
        pub b: f64,
        ///In rad/s.
        pub w: f64,
        ///A plain number.
        pub nx: f64,
        ///A plain number.
        pub ny: f64,
        ///In N m s.
        pub gamma: f64,
    }
    impl ::core::default::Default for DrivenPivotParams {
        #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
        fn default() -> Self {
            Self {
                m1: 1f64,
                m2: 0.8f64,
                l1: 1f64,
                l2: 0.7f64,
                a: 0.25f64,
                b: 0.15f64,
                w: 1.5f64,
                nx: 3f64,
                ny: 2f64,
                gamma: 0.02f64,
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl DrivenPivotParams {
        /// Names of the parameters, in the order of their declaration.
        pub const NAMES: [&'static str; 10] = [
            "m1",
            "m2",
            "l1",
            "l2",
            "a",
            "b",
            "w",
            "nx",
            "ny",
            "gamma",
        ];
        /// Returns the values of the parameters, in the order of [`NAMES`](Self::NAMES).
        pub const fn to_array(self) -> [f64; 10] {
            [
                self.m1,
                self.m2,
                self.l1,
                self.l2,
                self.a,
                self.b,
                self.w,
                self.nx,
                self.ny,
                self.gamma,
            ]
        }
        /// Builds parameters from their values, in the order of [`NAMES`](Self::NAMES).
        pub const fn from_array(values: [f64; 10]) -> Self {
            let [v0, v1, v2, v3, v4, v5, v6, v7, v8, v9] = values;
            Self {
                m1: v0,
                m2: v1,
                l1: v2,
                l2: v3,
                a: v4,
                b: v5,
                w: v6,
                nx: v7,
                ny: v8,
                gamma: v9,
            }
        }
    }
    /// Two rods below a pivot that moves as (a cos(nx w t), b sin(ny w t)).
    ///
    /**# Equations of motion

```text
A qdd + b = Q, where A is symmetric, b holds velocity terms, gravity and the inertia forces of the drives,
    Q the forces of the joints

A[theta1, theta1] = 1/3*m1*l1^2 + m2*l1^2
A[theta1, theta2] = 0.5*m2*l1*l2*cos(theta1 - theta2)
A[theta2, theta2] = 1/3*m2*l2^2
b[theta1] = 0.5*m2*l1*l2*dot(theta2)^2*sin(theta1 - theta2) + 4.905*(m1*l1 + 2*m2*l1)*sin(theta1)
    - (0.5*m1*l1*b*w^2*ny^2 + m2*l1*b*w^2*ny^2)*sin(theta1)*sin(w*ny*t)
    - (0.5*m1*l1*a*w^2*nx^2 + m2*l1*a*w^2*nx^2)*cos(theta1)*cos(w*nx*t)
b[theta2] = 4.905*m2*l2*sin(theta2) - 0.5*m2*l1*l2*dot(theta1)^2*sin(theta1 - theta2)
    - 0.5*m2*l2*b*w^2*ny^2*sin(theta2)*sin(w*ny*t) - 0.5*m2*l2*a*w^2*nx^2*cos(theta2)*cos(w*nx*t)
Q[theta1] = gamma*dot(theta2) - 2*gamma*dot(theta1)
Q[theta2] = gamma*dot(theta1) - gamma*dot(theta2)
```

# Constants, computed by `new`

```text
k0 = l1
k1 = l2
k2 = a
k3 = b
k4 = w
k5 = nx
k6 = ny
k7 = gamma
k8 = w*nx
k9 = w*ny
k10 = 0.5*m2*l2
k11 = 9.81*(m1 + m2)
k12 = 0.5*m1*l1 + m2*l1
k13 = m2*l1*l2
k14 = 0.5*m1*l1*b*w^2*ny^2 + m2*l1*b*w^2*ny^2
k15 = 0.5*m1*l1*a*w^2*nx^2 + m2*l1*a*w^2*nx^2
k16 = 0.5*m1*l1*b*w*ny + m2*l1*b*w*ny
k17 = 0.5*m1*l1*a*w*nx + m2*l1*a*w*nx
k18 = 0.25*(m2*l1*l2)^2
k19 = 0.5*m2*l1*l2
k20 = 1/3*m2*l2^2
k21 = 4.905*(m1*l1 + 2*m2*l1)
k22 = 4.905*m2*l2
k23 = -gamma
k24 = 2*gamma
k25 = 1/6*(m1*l1^2 + 3*m2*l1^2)
k26 = 1/6*m2*l2^2
k27 = 9.81*(m1*b + m2*b)
k28 = 1/36*(4*m1*m2*l1^2*l2^2 + 3*m2^2*l1^2*l2^2)
k29 = -1/(1/3*m2*l2^2)
k30 = 0.5*m2*l2*b*w^2*ny^2
k31 = 0.5*m2*l2*a*w^2*nx^2
k32 = 0.5*m2*l2*b*w*ny
k33 = 0.5*m2*l2*a*w*nx
k34 = 0.5*(m1*a^2*w^2*nx^2 + m2*a^2*w^2*nx^2)
k35 = 0.5*(m1*b^2*w^2*ny^2 + m2*b^2*w^2*ny^2)
k36 = -0.5*l1/(1/3*l2)
k37 = -gamma/(1/3*m2*l2^2)
k38 = 0.5*m1*l1*b*w^3*ny^3 + m2*l1*b*w^3*ny^3
k39 = 0.5*m1*l1*a*w^3*nx^3 + m2*l1*a*w^3*nx^3
k40 = 0.5*m2*l2*b*w^3*ny^3
k41 = 0.5*m2*l2*a*w^3*nx^3
k42 = a*w^2*nx^2*(m1 + m2)
k43 = b*w^2*ny^2*(m1 + m2)
```
*/
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct DrivenPivot<T = f64> {
        params: DrivenPivotParams,
        constants: [T; 44],
    }
    /// Constants of the model, from its parameters.
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    #[inline]
    fn constants<T: ::pendulum_core::real::Real>(given: [T; 10]) -> [T; 44] {
        let [p_m1, p_m2, p_l1, p_l2, p_a, p_b, p_w, p_nx, p_ny, p_gamma] = given;
        let t0 = p_m2 * (T::from_f64(0.5) * p_l2);
        let t1 = T::from_f64(4.905) * p_l1.mul_add(T::from_f64(2.0) * p_m2, p_m1 * p_l1);
        let t2 = -p_gamma;
        let t3 = T::from_f64(2.0) * p_gamma;
        let t4 = T::from_f64(9.81) * p_m2.mul_add(p_b, p_m1 * p_b);
        let t5 = p_w * p_nx;
        let t6 = p_w * p_ny;
        let t7 = p_m1 + p_m2;
        let t8 = t7 * (t5 * (p_a * t5));
        let t9 = t6 * (t6 * (p_b * t7));
        let t10 = T::from_f64(9.81) * t7;
        let t11 = p_m2 * p_l1;
        let t12 = p_m1.mul_add(T::from_f64(0.5) * p_l1, t11);
        let t13 = p_l2 * t11;
        let t14 = T::from_f64(0.25) * (t13 * t13);
        let t15 = T::from_f64(0.5) * t13;
        let t16 = p_l1 * (T::from_f64(0.5) * p_m1);
        let t17 = p_b * t16;
        let t18 = p_a * t16;
        let t19 = p_w * p_w;
        let t20 = p_ny * p_ny;
        let t21 = p_b * t11;
        let t22 = t20.mul_add(t19 * t21, t17 * t19 * t20);
        let t23 = p_a * t11;
        let t24 = p_ny.mul_add(p_w * t21, p_ny * (p_w * t17));
        let t25 = p_nx.mul_add(p_w * t23, p_nx * (p_w * t18));
        let t26 = p_nx * p_nx;
        let t27 = t26.mul_add(t19 * t23, t19 * t18 * t26);
        let t28 = p_l2 * p_l2;
        let t29 = p_m2 * t28;
        let t30 = T::from_f64(0.16666666666666666) * t29;
        let t31 = T::from_f64(0.3333333333333333) * t29;
        let t32 = T::from_f64(-1.0) / t31;
        let t33 = t15 * t32;
        let t34 = p_gamma * t32;
        let t35 = p_m2 * p_l2;
        let t36 = T::from_f64(4.905) * t35;
        let t37 = p_l1 * p_l1;
        let t38 = T::from_f64(0.16666666666666666)
            * t37.mul_add(T::from_f64(3.0) * p_m2, p_m1 * t37);
        let t39 = t28
            .mul_add(
                t37 * (T::from_f64(3.0) * (p_m2 * p_m2)),
                t28 * (t37 * (p_m2 * (T::from_f64(4.0) * p_m1))),
            );
        let t40 = T::from_f64(0.027777777777777776) * t39;
        let t41 = p_b * t35;
        let t42 = T::from_f64(0.5) * (t20 * (t19 * t41));
        let t43 = p_a * t35;
        let t44 = T::from_f64(0.5) * (t26 * (t19 * t43));
        let t45 = T::from_f64(0.5) * (p_ny * (p_w * t41));
        let t46 = T::from_f64(0.5) * (p_nx * (p_w * t43));
        let t47 = p_a * p_a;
        let t48 = T::from_f64(0.5)
            * t26.mul_add(t19 * (p_m2 * t47), t26 * (t19 * (p_m1 * t47)));
        let t49 = p_b * p_b;
        let t50 = T::from_f64(0.5)
            * t20.mul_add(t19 * (p_m2 * t49), t20 * (t19 * (p_m1 * t49)));
        let t51 = p_w * p_w * p_w;
        let t52 = p_ny * p_ny * p_ny;
        let t53 = t52.mul_add(t21 * t51, t17 * t51 * t52);
        let t54 = T::from_f64(0.5) * (t52 * (t41 * t51));
        let t55 = p_nx * p_nx * p_nx;
        let t56 = t55.mul_add(t23 * t51, t18 * t51 * t55);
        let t57 = T::from_f64(0.5) * (t55 * (t43 * t51));
        [
            p_l1,
            p_l2,
            p_a,
            p_b,
            p_w,
            p_nx,
            p_ny,
            p_gamma,
            t5,
            t6,
            t0,
            t10,
            t12,
            t13,
            t22,
            t27,
            t24,
            t25,
            t14,
            t15,
            t31,
            t1,
            t36,
            t2,
            t3,
            t38,
            t30,
            t4,
            t40,
            t32,
            t42,
            t44,
            t45,
            t46,
            t48,
            t50,
            t33,
            t34,
            t53,
            t56,
            t54,
            t57,
            t8,
            t9,
        ]
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl DrivenPivot {
        /// Builds the model: checks the parameters, and computes all constants that depend on them alone.
        ///
        /// # Errors
        ///
        /// Returns the first parameter, or combination of parameters, that is not finite or is impossible for a
        /// rigid body.
        pub fn new(
            params: DrivenPivotParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            #[inline]
            fn rules<T: ::pendulum_core::real::Real>(given: [T; 10]) -> [T; 3] {
                let [p_m1, p_m2, p_l1, p_l2, p_a, p_b, p_w, p_nx, p_ny, p_gamma] = given;
                [p_m1, p_gamma, p_m2]
            }
            let given = params.to_array();
            for (name, value) in DrivenPivotParams::NAMES.into_iter().zip(given) {
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
                        "m1",
                        r0,
                        "the mass of a rod of `upper` must be positive",
                        &[],
                    ),
                );
            }
            if !(r1 >= 0.0) {
                return Err(
                    ::pendulum_core::ParameterError::new(
                        "gamma",
                        r1,
                        "the friction of `upper` must not be negative",
                        &[],
                    ),
                );
            }
            if !(r2 > 0.0) {
                return Err(
                    ::pendulum_core::ParameterError::new(
                        "m2",
                        r2,
                        "the mass of a rod of `lower` must be positive",
                        &[],
                    ),
                );
            }
            let constants = constants(given);
            let names: [&'static str; 44] = [
                "l1",
                "l2",
                "a",
                "b",
                "w",
                "nx",
                "ny",
                "gamma",
                "w*nx",
                "w*ny",
                "0.5*m2*l2",
                "9.81*(m1 + m2)",
                "0.5*m1*l1 + m2*l1",
                "m2*l1*l2",
                "0.5*m1*l1*b*w^2*ny^2 + m2*l1*b*w^2*ny^2",
                "0.5*m1*l1*a*w^2*nx^2 + m2*l1*a*w^2*nx^2",
                "0.5*m1*l1*b*w*ny + m2*l1*b*w*ny",
                "0.5*m1*l1*a*w*nx + m2*l1*a*w*nx",
                "0.25*(m2*l1*l2)^2",
                "0.5*m2*l1*l2",
                "1/3*m2*l2^2",
                "4.905*(m1*l1 + 2*m2*l1)",
                "4.905*m2*l2",
                "-gamma",
                "2*gamma",
                "1/6*(m1*l1^2 + 3*m2*l1^2)",
                "1/6*m2*l2^2",
                "9.81*(m1*b + m2*b)",
                "1/36*(4*m1*m2*l1^2*l2^2 + 3*m2^2*l1^2*l2^2)",
                "-1/(1/3*m2*l2^2)",
                "0.5*m2*l2*b*w^2*ny^2",
                "0.5*m2*l2*a*w^2*nx^2",
                "0.5*m2*l2*b*w*ny",
                "0.5*m2*l2*a*w*nx",
                "0.5*(m1*a^2*w^2*nx^2 + m2*a^2*w^2*nx^2)",
                "0.5*(m1*b^2*w^2*ny^2 + m2*b^2*w^2*ny^2)",
                "-0.5*l1/(1/3*l2)",
                "-gamma/(1/3*m2*l2^2)",
                "0.5*m1*l1*b*w^3*ny^3 + m2*l1*b*w^3*ny^3",
                "0.5*m1*l1*a*w^3*nx^3 + m2*l1*a*w^3*nx^3",
                "0.5*m2*l2*b*w^3*ny^3",
                "0.5*m2*l2*a*w^3*nx^3",
                "a*w^2*nx^2*(m1 + m2)",
                "b*w^2*ny^2*(m1 + m2)",
            ];
            for (name, value) in names.into_iter().zip(constants) {
                if !value.is_finite() {
                    let given: [_; 10] = ::core::array::from_fn(|n| (
                        DrivenPivotParams::NAMES[n],
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
        /// Converts the model to another number type, such as `f32`. Its constants are computed in double
        /// precision and then rounded.
        pub fn cast<T: ::pendulum_core::real::Real>(&self) -> DrivenPivot<T> {
            DrivenPivot {
                params: self.params,
                constants: self.constants.map(T::from_f64),
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> DrivenPivot<T> {
        /// Returns the parameters from which the model was built.
        pub fn params(&self) -> &DrivenPivotParams {
            &self.params
        }
        /// Returns a model with other parameters, in the same number type, and recomputes its constants.
        ///
        /// # Errors
        ///
        /// Returns the errors of `new`.
        pub fn with_params(
            &self,
            params: DrivenPivotParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            Ok(<DrivenPivot>::new(params)?.cast())
        }
    }
    impl DrivenPivot {
        ///Index of `theta1` in the state, in rad.
        pub const THETA1: usize = 0;
        ///Index of `dot(theta1)` in the state, in rad/s.
        pub const DOT_THETA1: usize = 2;
        ///Index of `theta2` in the state, in rad.
        pub const THETA2: usize = 1;
        ///Index of `dot(theta2)` in the state, in rad/s.
        pub const DOT_THETA2: usize = 3;
        /// Number of degrees of freedom. The state has twice as many components.
        pub const DOF: usize = 2;
        /// Names of the coordinates. The state holds their positions and then their rates in this order.
        pub const COORDINATES: [&'static str; 2] = ["theta1", "theta2"];
        /// Operation counts of each generated function, in its own form and in others.
        pub const COST: ::pendulum_core::Cost = ::pendulum_core::Cost::new(
            &[
                (
                    "rhs",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, expanded, exact quotient",
                            ::pendulum_core::Operations::new(16, 29, 1, 4, 0, 36),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factored, adjugate",
                                    ::pendulum_core::Operations::new(15, 32, 1, 4, 0, 31),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, adjugate",
                                    ::pendulum_core::Operations::new(26, 37, 1, 4, 0, 37),
                                ),
                            ],
                        ),
                ),
                (
                    "jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, expanded, L^T D L, exact quotient, derived and expanded",
                            ::pendulum_core::Operations::new(38, 58, 1, 4, 0, 44),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factored, inverse, derived and expanded",
                                    ::pendulum_core::Operations::new(35, 67, 1, 4, 0, 42),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, inverse, derived in the graph",
                                    ::pendulum_core::Operations::new(54, 74, 1, 4, 0, 49),
                                ),
                            ],
                        ),
                ),
                (
                    "time_derivative",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factored, L^T D L, exact quotient, derived and expanded",
                            ::pendulum_core::Operations::new(8, 22, 1, 4, 0, 32),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L, derived and expanded",
                                    ::pendulum_core::Operations::new(8, 22, 1, 4, 0, 32),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, adjugate, derived in the graph",
                                    ::pendulum_core::Operations::new(17, 28, 1, 4, 0, 37),
                                ),
                            ],
                        ),
                ),
                (
                    "kinetic",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, expanded",
                            ::pendulum_core::Operations::new(9, 23, 0, 4, 0, 30),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factored",
                                    ::pendulum_core::Operations::new(9, 25, 0, 4, 0, 29),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(22, 35, 0, 4, 0, 36),
                                ),
                            ],
                        ),
                ),
                (
                    "potential",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factored",
                            ::pendulum_core::Operations::new(2, 4, 0, 3, 0, 23),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(2, 4, 0, 3, 0, 24),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(4, 7, 0, 3, 0, 27),
                                ),
                            ],
                        ),
                ),
                (
                    "drive_forces",
                    ::pendulum_core::FunctionCost::new(
                        "recursion",
                        ::pendulum_core::Operations::new(28, 47, 1, 6, 0, 41),
                    ),
                ),
            ],
        );
        /// Layout of the state.
        pub const LAYOUT: ::pendulum_core::StateLayout<'static> = ::pendulum_core::StateLayout::new(
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
        );
        /// Equations of motion as text.
        pub const EQUATIONS: &'static str = "A qdd + b = Q, where A is symmetric, b holds velocity terms, gravity and the inertia forces of the drives,\n    Q the forces of the joints\n\nA[theta1, theta1] = 1/3*m1*l1^2 + m2*l1^2\nA[theta1, theta2] = 0.5*m2*l1*l2*cos(theta1 - theta2)\nA[theta2, theta2] = 1/3*m2*l2^2\nb[theta1] = 0.5*m2*l1*l2*dot(theta2)^2*sin(theta1 - theta2) + 4.905*(m1*l1 + 2*m2*l1)*sin(theta1)\n    - (0.5*m1*l1*b*w^2*ny^2 + m2*l1*b*w^2*ny^2)*sin(theta1)*sin(w*ny*t)\n    - (0.5*m1*l1*a*w^2*nx^2 + m2*l1*a*w^2*nx^2)*cos(theta1)*cos(w*nx*t)\nb[theta2] = 4.905*m2*l2*sin(theta2) - 0.5*m2*l1*l2*dot(theta1)^2*sin(theta1 - theta2)\n    - 0.5*m2*l2*b*w^2*ny^2*sin(theta2)*sin(w*ny*t) - 0.5*m2*l2*a*w^2*nx^2*cos(theta2)*cos(w*nx*t)\nQ[theta1] = gamma*dot(theta2) - 2*gamma*dot(theta1)\nQ[theta2] = gamma*dot(theta1) - gamma*dot(theta2)\n";
        ///Bodies whose joints are driven.
        pub const DRIVES: [&'static str; 2] = ["across", "pivot"];
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::System<T, 4>
    for DrivenPivot<T> {
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn rhs(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 4> {
            let [q_theta1, q_theta2, qd_theta1, qd_theta2] = x.data.0[0];
            let k4 = self.constants[4];
            let k5 = self.constants[5];
            let k6 = self.constants[6];
            let k7 = self.constants[7];
            let k14 = self.constants[14];
            let k15 = self.constants[15];
            let k18 = self.constants[18];
            let k19 = self.constants[19];
            let k20 = self.constants[20];
            let k21 = self.constants[21];
            let k22 = self.constants[22];
            let k23 = self.constants[23];
            let k24 = self.constants[24];
            let k28 = self.constants[28];
            let k29 = self.constants[29];
            let k30 = self.constants[30];
            let k31 = self.constants[31];
            let k36 = self.constants[36];
            let t0 = k4 * t;
            let [(sin1, _), (_, cos2)] = (k6 * t0).sin_cos_pair(k5 * t0);
            let t3 = k7 * qd_theta2;
            let [(sin_theta1, cos_theta1), (sin_theta2, cos_theta2)] = q_theta1
                .sin_cos_pair(q_theta2);
            let t4 = cos_theta1.mul_neg_add(sin_theta2, sin_theta1 * cos_theta2);
            let t5 = k19 * t4;
            let t6 = qd_theta1
                .mul_add(
                    qd_theta1.mul_neg_add(t5, k23),
                    sin_theta2.mul_add(k30.mul_neg_add(sin1, k22), t3),
                );
            let t7 = (k31 * cos_theta2).mul_neg_add(cos2, t6);
            let t8 = k36 * sin_theta1.mul_add(sin_theta2, cos_theta2 * cos_theta1);
            let t9 = sin_theta1
                .mul_add(
                    k14.mul_neg_add(sin1, k21),
                    t8.mul_add(t7, (qd_theta2 * qd_theta2).mul_add(t5, k24 * qd_theta1)),
                );
            let t10 = k20 / (k18 * t4).mul_add(t4, k28)
                * (k15 * cos_theta1).mul_neg_add(cos2, t9 - t3);
            ::pendulum_core::nalgebra::SVector::from([
                qd_theta1,
                qd_theta2,
                -t10,
                t8.mul_neg_add(t10, k29 * t7),
            ])
        }
        #[inline]
        fn layout(&self) -> ::core::option::Option<::pendulum_core::StateLayout<'_>> {
            Some(<DrivenPivot>::LAYOUT)
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Jacobian<T, 4>
    for DrivenPivot<T> {
        #[inline]
        fn jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SMatrix<T, 4, 4> {
            self.rhs_and_jacobian(t, x).1
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn rhs_and_jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 4>,
            ::pendulum_core::nalgebra::SMatrix<T, 4, 4>,
        ) {
            let [q_theta1, q_theta2, qd_theta1, qd_theta2] = x.data.0[0];
            let k4 = self.constants[4];
            let k5 = self.constants[5];
            let k6 = self.constants[6];
            let k7 = self.constants[7];
            let k13 = self.constants[13];
            let k14 = self.constants[14];
            let k15 = self.constants[15];
            let k18 = self.constants[18];
            let k19 = self.constants[19];
            let k20 = self.constants[20];
            let k21 = self.constants[21];
            let k22 = self.constants[22];
            let k24 = self.constants[24];
            let k28 = self.constants[28];
            let k29 = self.constants[29];
            let k30 = self.constants[30];
            let k31 = self.constants[31];
            let k36 = self.constants[36];
            let k37 = self.constants[37];
            let t0 = k4 * t;
            let [(sin1, _), (_, cos2)] = (k6 * t0).sin_cos_pair(k5 * t0);
            let t3 = k30.mul_neg_add(sin1, k22);
            let t4 = k19 * qd_theta1 * qd_theta1;
            let t5 = k7 * qd_theta2;
            let t6 = k31 * cos2;
            let t7 = k19 * qd_theta2 * qd_theta2;
            let t8 = k14.mul_neg_add(sin1, k21);
            let t9 = k15 * cos2;
            let [(sin_theta1, cos_theta1), (sin_theta2, cos_theta2)] = q_theta1
                .sin_cos_pair(q_theta2);
            let t10 = cos_theta1.mul_neg_add(sin_theta2, sin_theta1 * cos_theta2);
            let t11 = cos_theta2
                .mul_neg_add(
                    t6,
                    t10
                        .mul_neg_add(
                            t4,
                            k7.mul_neg_add(qd_theta1, sin_theta2.mul_add(t3, t5)),
                        ),
                );
            let t12 = sin_theta1.mul_add(sin_theta2, cos_theta2 * cos_theta1);
            let t13 = k20 / (k18 * t10).mul_add(t10, k28);
            let t14 = k36 * t12;
            let t15 = sin_theta1
                .mul_add(t8, t14.mul_add(t11, t10.mul_add(t7, k24 * qd_theta1))) - t5;
            let t16 = t13 * cos_theta1.mul_neg_add(t9, t15);
            let t17 = t14.mul_neg_add(t16, k29 * t11);
            let t18 = -t16;
            let t19 = k19 * t10;
            let t20 = t17.mul_neg_add(t19, t7 * t12);
            let t21 = t16.mul_neg_add(t19, t12 * t4);
            let t22 = t13
                * t14.mul_neg_add(t21, cos_theta1.mul_add(t8, sin_theta1 * t9) + t20);
            let t23 = cos_theta2.mul_add(t3, sin_theta2.mul_add(t6, t21));
            let t24 = -t14.mul_add(t22, k29 * t21);
            let t25 = -t22;
            let t26 = k13 * t10;
            let t27 = t13 * t14.mul_sub(t23, t20);
            let t28 = t14.mul_neg_add(t27, k29 * t23);
            let t29 = -t27;
            let t30 = qd_theta1.mul_add(t26, k7);
            let t31 = t13 * (k7.mul_add(t14, qd_theta2 * t26) - k7);
            let t32 = t13 * t14.mul_neg_add(t30, k24);
            let t33 = -t14.mul_add(t32, k29 * t30);
            let t34 = t14.mul_neg_add(t31, k37);
            let t35 = -t32;
            let t36 = -t31;
            (
                ::pendulum_core::nalgebra::SVector::from([
                    qd_theta1,
                    qd_theta2,
                    t18,
                    t17,
                ]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [T::from_f64(0.0), T::from_f64(0.0), t25, t24],
                    [T::from_f64(0.0), T::from_f64(0.0), t29, t28],
                    [T::from_f64(1.0), T::from_f64(0.0), t35, t33],
                    [T::from_f64(0.0), T::from_f64(1.0), t36, t34],
                ]),
            )
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn time_derivative(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 4> {
            let [q_theta1, q_theta2, _, _] = x.data.0[0];
            let k4 = self.constants[4];
            let k5 = self.constants[5];
            let k6 = self.constants[6];
            let k18 = self.constants[18];
            let k20 = self.constants[20];
            let k28 = self.constants[28];
            let k29 = self.constants[29];
            let k36 = self.constants[36];
            let k38 = self.constants[38];
            let k39 = self.constants[39];
            let k40 = self.constants[40];
            let k41 = self.constants[41];
            let t0 = k4 * t;
            let [(sin1, _), (_, cos2)] = (k5 * t0).sin_cos_pair(k6 * t0);
            let [(sin_theta1, cos_theta1), (sin_theta2, cos_theta2)] = q_theta1
                .sin_cos_pair(q_theta2);
            let t3 = cos_theta1.mul_neg_add(sin_theta2, sin_theta1 * cos_theta2);
            let t4 = k36 * sin_theta1.mul_add(sin_theta2, cos_theta2 * cos_theta1);
            let t5 = (k40 * sin_theta2).mul_neg_add(cos2, k41 * cos_theta2 * sin1);
            let t6 = k20 / (k18 * t3).mul_add(t3, k28)
                * (k38 * sin_theta1)
                    .mul_neg_add(cos2, t4.mul_add(t5, k39 * cos_theta1 * sin1));
            ::pendulum_core::nalgebra::SVector::from([
                T::from_f64(0.0),
                T::from_f64(0.0),
                -t6,
                t4.mul_neg_add(t6, k29 * t5),
            ])
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Energy<T, 4>
    for DrivenPivot<T> {
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn kinetic(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 4>) -> T {
            let [q_theta1, q_theta2, qd_theta1, qd_theta2] = x.data.0[0];
            let k4 = self.constants[4];
            let k5 = self.constants[5];
            let k6 = self.constants[6];
            let k16 = self.constants[16];
            let k17 = self.constants[17];
            let k19 = self.constants[19];
            let k25 = self.constants[25];
            let k26 = self.constants[26];
            let k32 = self.constants[32];
            let k33 = self.constants[33];
            let k34 = self.constants[34];
            let k35 = self.constants[35];
            let t0 = k4 * t;
            let [(_, cos1), (sin_theta1, cos_theta1)] = (k6 * t0).sin_cos_pair(q_theta1);
            let [(sin2, _), (sin_theta2, cos_theta2)] = (k5 * t0).sin_cos_pair(q_theta2);
            let t3 = sin_theta2
                .mul_add(sin_theta1, cos_theta1 * cos_theta2)
                .mul_add(
                    k19 * qd_theta1,
                    k32.mul_add(cos1 * sin_theta2, k26 * qd_theta2),
                );
            let t4 = qd_theta2
                .mul_add(
                    k33.mul_neg_add(sin2 * cos_theta2, t3),
                    (k34 * sin2).mul_add(sin2, k35 * cos1 * cos1),
                );
            let t5 = qd_theta1
                * k17
                    .mul_neg_add(
                        sin2 * cos_theta1,
                        k16.mul_add(cos1 * sin_theta1, k25 * qd_theta1),
                    );
            t4 + t5
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn potential(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 4>) -> T {
            let [q_theta1, q_theta2, _, _] = x.data.0[0];
            let k9 = self.constants[9];
            let k21 = self.constants[21];
            let k22 = self.constants[22];
            let k27 = self.constants[27];
            let (_, cos_theta2) = q_theta2.sin_cos();
            let [(sin0, _), (_, cos_theta1)] = (k9 * t).sin_cos_pair(q_theta1);
            k27.mul_sub(sin0, k22.mul_add(cos_theta2, k21 * cos_theta1))
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> DrivenPivot<T> {
        ///Forces supplied by the drives along their joints, in the order of the declaration: in N m where a joint turns, in N where it slides.
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        pub fn drive_forces(
            &self,
            t: T,
            x: &(impl ::pendulum_core::IntoState<T, 4> + Copy),
        ) -> ::pendulum_core::nalgebra::SVector<T, 2> {
            struct __Code<'a, T, __X0> {
                t: T,
                x: &'a __X0,
            }
            #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
            impl<
                T: ::pendulum_core::real::Real,
                __X0: ::pendulum_core::IntoState<T, 4> + ::core::marker::Copy,
            > ::pendulum_core::real::lanes::Routine<(), DrivenPivot<T>>
            for __Code<'_, T, __X0> {
                type Output = ::pendulum_core::nalgebra::SVector<T, 2>;
                #[cfg_attr(debug_assertions, inline)]
                #[cfg_attr(not(debug_assertions), inline(always))]
                fn run(
                    self,
                    (): &mut (),
                    model: &DrivenPivot<T>,
                ) -> ::pendulum_core::nalgebra::SVector<T, 2> {
                    let Self { t, x } = self;
                    let x = ::pendulum_core::IntoState::into_state(*x);
                    let [q_theta1, q_theta2, qd_theta1, qd_theta2] = x.data.0[0];
                    let k4 = model.constants[4];
                    let k5 = model.constants[5];
                    let k6 = model.constants[6];
                    let k7 = model.constants[7];
                    let k8 = model.constants[8];
                    let k9 = model.constants[9];
                    let k10 = model.constants[10];
                    let k11 = model.constants[11];
                    let k12 = model.constants[12];
                    let k14 = model.constants[14];
                    let k15 = model.constants[15];
                    let k18 = model.constants[18];
                    let k19 = model.constants[19];
                    let k20 = model.constants[20];
                    let k21 = model.constants[21];
                    let k22 = model.constants[22];
                    let k24 = model.constants[24];
                    let k28 = model.constants[28];
                    let k29 = model.constants[29];
                    let k30 = model.constants[30];
                    let k31 = model.constants[31];
                    let k36 = model.constants[36];
                    let k42 = model.constants[42];
                    let k43 = model.constants[43];
                    let t0 = k4 * t;
                    let [(sin1, _), (_, cos2)] = (k6 * t0).sin_cos_pair(k5 * t0);
                    let t3 = k7 * qd_theta2;
                    let t4 = qd_theta1 + qd_theta2 - qd_theta1;
                    let t5 = t4 * t4;
                    let t6 = qd_theta1 * qd_theta1;
                    let [(_, cos7), (sin8, _)] = (k8 * t).sin_cos_pair(k9 * t);
                    let [(sin_theta2, cos_theta2), (sin_theta1, cos_theta1)] = q_theta2
                        .sin_cos_pair(q_theta1);
                    let t9 = k10 * cos_theta2;
                    let t10 = cos_theta1
                        .mul_neg_add(sin_theta2, cos_theta2 * sin_theta1);
                    let t11 = k19 * t10;
                    let t12 = (t11 * qd_theta2)
                        .mul_add(
                            qd_theta2,
                            k24
                                .mul_add(qd_theta1, sin_theta1 * k14.mul_neg_add(sin1, k21)),
                        );
                    let t13 = qd_theta1
                        .mul_neg_add(
                            qd_theta1.mul_add(t11, k7),
                            sin_theta2.mul_add(k30.mul_neg_add(sin1, k22), t3),
                        );
                    let t14 = (k31 * cos_theta2).mul_neg_add(cos2, t13);
                    let t15 = k36
                        * sin_theta1.mul_add(sin_theta2, cos_theta2 * cos_theta1);
                    let t16 = k20 / (k18 * t10).mul_add(t10, k28)
                        * (k15 * cos_theta1)
                            .mul_neg_add(cos2, t14.mul_add(t15, t12) - t3);
                    let t17 = t15.mul_neg_add(t16, k29.mul_add(t14, t16) - t16);
                    let t18 = k10 * sin_theta2;
                    let t19 = k12 * sin_theta1;
                    let t20 = k12 * cos_theta1;
                    let t21 = t17
                        .mul_add(
                            t18,
                            t9.mul_add(t5, t20.mul_add(t6, k43.mul_neg_add(sin8, k11))),
                        );
                    ::pendulum_core::nalgebra::SVector::from([
                        k42
                            .mul_neg_add(
                                cos7,
                                t16
                                    .mul_neg_add(
                                        t20,
                                        t19.mul_neg_add(t6, t18.mul_neg_add(t5, t9 * t17)),
                                    ),
                            ),
                        t16.mul_neg_add(t19, t21),
                    ])
                }
            }
            T::apart(__Code { t, x }, &mut (), self)
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::shapes::Shapes<4> for DrivenPivot {
        fn shapes(
            &self,
            t: f64,
            x: &::pendulum_core::nalgebra::SVector<f64, 4>,
        ) -> ::pendulum_core::shapes::Vec<::pendulum_core::shapes::Shape<'_>> {
            trait Values<T> {
                fn values(
                    &self,
                    t: T,
                    x: &::pendulum_core::nalgebra::SVector<T, 4>,
                ) -> [T; 24];
            }
            #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
            impl<T: ::pendulum_core::real::Real> Values<T> for DrivenPivot<T> {
                fn values(
                    &self,
                    t: T,
                    x: &::pendulum_core::nalgebra::SVector<T, 4>,
                ) -> [T; 24] {
                    {
                        let [q_theta1, q_theta2, _, _] = x.data.0[0];
                        let k0 = self.constants[0];
                        let k1 = self.constants[1];
                        let k2 = self.constants[2];
                        let k3 = self.constants[3];
                        let k8 = self.constants[8];
                        let k9 = self.constants[9];
                        let [(_, cos0), (sin_theta1, cos_theta1)] = (t * k8)
                            .sin_cos_pair(q_theta1);
                        let t1 = k2 * cos0;
                        let t2 = k0.mul_add(sin_theta1, t1);
                        let [(sin3, _), (sin_theta2, cos_theta2)] = (t * k9)
                            .sin_cos_pair(q_theta2);
                        let t4 = k1.mul_add(sin_theta2, t2);
                        let t5 = k3 * sin3;
                        let t6 = k0.mul_neg_add(cos_theta1, t5);
                        let t7 = k1.mul_neg_add(cos_theta2, t6);
                        [
                            t1,
                            t5,
                            T::from_f64(0.0),
                            t2,
                            t6,
                            T::from_f64(0.0),
                            t2,
                            t6,
                            T::from_f64(0.0),
                            t4,
                            t7,
                            T::from_f64(0.0),
                            t1,
                            t5,
                            T::from_f64(0.0),
                            t2,
                            t6,
                            T::from_f64(0.0),
                            t1,
                            t5,
                            T::from_f64(0.0),
                            t4,
                            t7,
                            T::from_f64(0.0),
                        ]
                    }
                }
            }
            ::pendulum_core::shapes::placed(
                &[
                    ::pendulum_core::shapes::Outline {
                        name: "upper",
                        body: "upper",
                        kind: ::pendulum_core::shapes::ShapeKind::Rod,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "lower",
                        body: "lower",
                        kind: ::pendulum_core::shapes::ShapeKind::Rod,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "upper",
                        body: "upper",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "lower",
                        body: "lower",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "nail",
                        body: "pivot",
                        kind: ::pendulum_core::shapes::ShapeKind::Point,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "tip",
                        body: "lower",
                        kind: ::pendulum_core::shapes::ShapeKind::Point,
                        points: 1,
                        radius: false,
                    },
                ],
                &self.values(t, x),
            )
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::Parametric<4, 10> for DrivenPivot {
        fn parameters(&self) -> [f64; 10] {
            self.params.to_array()
        }
        fn parameter_names(&self) -> [&str; 10] {
            DrivenPivotParams::NAMES
        }
        fn check_parameters(
            &self,
            parameters: &[f64; 10],
        ) -> ::core::result::Result<(), ::pendulum_core::ParameterError> {
            Self::new(DrivenPivotParams::from_array(*parameters)).map(|_| ())
        }
        fn with_parameters<T: ::pendulum_core::real::Real>(
            &self,
            parameters: [T; 10],
        ) -> DrivenPivot<T> {
            DrivenPivot {
                params: self.params,
                constants: constants(parameters),
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::CastJacobian<4> for DrivenPivot {
        #[inline]
        fn with_jacobian<T: ::pendulum_core::real::Real>(
            model: &DrivenPivot<T>,
        ) -> &impl ::pendulum_core::Jacobian<T, 4> {
            model
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::Cast<4> for DrivenPivot {
        type In<T: ::pendulum_core::real::Real> = DrivenPivot<T>;
        fn cast<T: ::pendulum_core::real::Real>(&self) -> DrivenPivot<T> {
            DrivenPivot::cast(self)
        }
        #[inline]
        fn gather<'m, T: ::pendulum_core::real::lanes::Lanes>(
            models: impl ::core::ops::Fn(usize) -> &'m Self,
        ) -> DrivenPivot<T>
        where
            Self: 'm,
        {
            let scalar = <<T as ::pendulum_core::real::lanes::Lanes>::Scalar as ::pendulum_core::real::Real>::from_f64;
            DrivenPivot {
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
pub use __DrivenPivot::{DrivenPivot, DrivenPivotParams};
