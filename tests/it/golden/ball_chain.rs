#[allow(non_snake_case)]
mod __BallPendulum {
    ///Parameters of [`BallPendulum`].
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct BallPendulumParams {}
    impl ::core::default::Default for BallPendulumParams {
        #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
        fn default() -> Self {
            Self {}
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl BallPendulumParams {
        /// Names of the parameters, in the order of their declaration.
        pub const NAMES: [&'static str; 0] = [];
        /// Returns the values of the parameters, in the order of [`NAMES`](Self::NAMES).
        pub const fn to_array(self) -> [f64; 0] {
            []
        }
        /// Builds parameters from their values, in the order of [`NAMES`](Self::NAMES).
        pub const fn from_array(values: [f64; 0]) -> Self {
            let [] = values;
            Self {}
        }
    }
    /// Two bodies on ball joints; z points upward.
    ///
    /**# Equations of motion

```text
A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints

A[a.x, a.x] = t26 + t27 + t29 + t28 - t26 - t29
A[a.x, a.y] = -(1/25000*t2*t5 + 0.00196*t3*t6 + 0.12192*t4*t7)
A[a.x, a.z] = -(0.12*t4 + 1/25000*t2*t8 + 0.00392*t3*t9 + 0.06096*t4*t10)
A[a.x, b.x] = 0.03146*t2 + 0.06*t6
A[a.x, b.y] = 0.061*t3 - 0.12*t5
A[a.x, b.z] = 0.002*t4
A[a.y, a.y] = t28 + t29
A[a.y, a.z] = -(0.12*t7 + 1/12500*t5*t8 + 0.00196*t6*t9 + 0.06096*t7*t10)
A[a.y, b.x] = 0.06292*t5 - 0.12*t3
A[a.y, b.y] = 0.0305*t6 + 0.06*t2
A[a.y, b.z] = 0.002*t7
A[a.z, a.z] = t26 + t27
A[a.z, b.x] = 0.06292*t8
A[a.z, b.y] = 0.061*t9
A[a.z, b.z] = 0.001*t10
A[b.x, b.x] = 0.03146
A[b.y, b.y] = 0.0305
A[b.z, b.z] = 0.001
b[a.x] = 9.81*t1 + 1/12500*dot(a).y*dot(a).z + t2*b[b.x] + 2*t3*b[b.y] + 2*t4*b[b.z]
    + 0.5*(2*t7*t25 - 0.12*t6*t23 - 0.24*t5*t24) - 13/60*dot(a).y*dot(a).z
b[a.y] = 13/60*dot(a).x*dot(a).z + 2*t5*b[b.x] + t6*b[b.y] + 2*t7*b[b.z] - 1/12500*dot(a).x*dot(a).z - 9.81*t0
    - 0.5*(2*t4*t25 - 0.24*t3*t23 - 0.12*t2*t24)
b[a.z] = 2*t8*b[b.x] + 2*t9*b[b.y] + t10*b[b.z]
b[b.x] = 0.12*(2*t9*t13 + 2*t3*t11 + t6*t12) + 0.00098*(t19 + t20*t21) - 0.03048*t23
b[b.y] = 0.03048*t24 - 1/50000*(t21*t22 - t17) - 0.12*(2*t8*t13 + t2*t11 + 2*t5*t12)
b[b.z] = 1/50000*(t18 + t20*t22) - 0.00098*(t20*t22 - t18)

where
t0 = a.x*a.z - a.y*a.w
t1 = a.y*a.z + a.x*a.w
t2 = 1 - 2*(b.y^2 + b.z^2)
t3 = b.x*b.y - b.z*b.w
t4 = b.x*b.z + b.y*b.w
t5 = b.x*b.y + b.z*b.w
t6 = 1 - 2*(b.x^2 + b.z^2)
t7 = b.y*b.z - b.x*b.w
t8 = b.x*b.z - b.y*b.w
t9 = b.y*b.z + b.x*b.w
t10 = 1 - 2*(b.x^2 + b.y^2)
t11 = 19.62*t0 - 0.5*dot(a).x*dot(a).z
t12 = 19.62*t1 - 0.5*dot(a).y*dot(a).z
t13 = 9.81*(1 - 2*(a.x^2 + a.y^2)) + 0.5*(dot(a).y^2 + dot(a).x^2)
t14 = 2*dot(a).z*t9 + 2*dot(a).x*t3 + dot(a).y*t6
t15 = dot(a).z*t10 + 2*dot(a).x*t4 + 2*dot(a).y*t7
t16 = 2*dot(a).z*t8 + dot(a).x*t2 + 2*dot(a).y*t5
t17 = dot(b).x*t15 - dot(b).z*t16
t18 = dot(b).y*t16 - dot(b).x*t14
t19 = dot(b).z*t14 - dot(b).y*t15
t20 = dot(b).y + t14
t21 = dot(b).z + t15
t22 = dot(b).x + t16
t23 = t20*t21 - t19
t24 = t17 + t21*t22
t25 = 0.12*(t20^2 + t22^2)
t26 = 1/12500 + 1/50000*t2^2 + 0.00392*t3^2 + 0.12192*t4^2
t27 = 1/12500 + 1/12500*t5^2 + 0.00098*t6^2 + 0.12192*t7^2
t28 = 13/60 + 0.12*t10 + 1/12500*t8^2 + 0.00392*t9^2 + 0.03048*t10^2
t29 = t27 + t26 - t27
```
*/
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct BallPendulum<T = f64> {
        params: BallPendulumParams,
        constants: [T; 0],
    }
    /// Constants of the model, from its parameters.
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    #[inline]
    fn constants<T: ::pendulum_core::real::Real>(given: [T; 0]) -> [T; 0] {
        let [] = given;
        []
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl BallPendulum {
        /// Builds the model: checks the parameters, and computes all constants that depend on them alone.
        ///
        /// # Errors
        ///
        /// Returns the first parameter, or combination of parameters, that is not finite or is impossible for a
        /// rigid body.
        pub fn new(
            params: BallPendulumParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            #[inline]
            fn rules<T: ::pendulum_core::real::Real>(given: [T; 0]) -> [T; 0] {
                let [] = given;
                []
            }
            let given = params.to_array();
            for (name, value) in BallPendulumParams::NAMES.into_iter().zip(given) {
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
                        BallPendulumParams::NAMES[n],
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
        pub fn cast<T: ::pendulum_core::real::Real>(&self) -> BallPendulum<T> {
            BallPendulum {
                params: self.params,
                constants: self.constants.map(T::from_f64),
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> BallPendulum<T> {
        /// Returns the parameters from which the model was built.
        pub fn params(&self) -> &BallPendulumParams {
            &self.params
        }
        /// Returns a model with other parameters, in the same number type, and recomputes its constants.
        ///
        /// # Errors
        ///
        /// Returns the errors of `new`.
        pub fn with_params(
            &self,
            params: BallPendulumParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            Ok(<BallPendulum>::new(params)?.cast())
        }
    }
    impl BallPendulum {
        ///First index of `a` in the state. Its components are in 1.
        pub const A: usize = 0;
        ///First index of `dot(a)` in the state. Its components are in rad/s.
        pub const DOT_A: usize = 8;
        ///First index of `b` in the state. Its components are in 1.
        pub const B: usize = 4;
        ///First index of `dot(b)` in the state. Its components are in rad/s.
        pub const DOT_B: usize = 11;
        /// Number of degrees of freedom, and of rates. A quaternion has one more component than its rates.
        pub const DOF: usize = 6;
        /// Names of the coordinates, in the order of their rates in the state. An orientation is listed as the axes of its angular velocity.
        pub const COORDINATES: [&'static str; 6] = [
            "a.x",
            "a.y",
            "a.z",
            "b.x",
            "b.y",
            "b.z",
        ];
        /// Operation counts of each generated function, in its own form and in others.
        pub const COST: ::pendulum_core::Cost = ::pendulum_core::Cost::new(
            &[
                (
                    "rhs",
                    ::pendulum_core::FunctionCost::new(
                        "articulated bodies",
                        ::pendulum_core::Operations::new(123, 188, 2, 0, 0, 44),
                    ),
                ),
                (
                    "jacobian",
                    ::pendulum_core::FunctionCost::new(
                        "articulated bodies, derived in the graph",
                        ::pendulum_core::Operations::new(863, 1187, 2, 0, 0, 80),
                    ),
                ),
                (
                    "kinetic",
                    ::pendulum_core::FunctionCost::new(
                        "recursion",
                        ::pendulum_core::Operations::new(43, 65, 0, 0, 0, 18),
                    ),
                ),
                (
                    "potential",
                    ::pendulum_core::FunctionCost::new(
                        "recursion",
                        ::pendulum_core::Operations::new(12, 19, 0, 0, 0, 9),
                    ),
                ),
                (
                    "momentum",
                    ::pendulum_core::FunctionCost::new(
                        "recursion",
                        ::pendulum_core::Operations::new(38, 58, 0, 0, 0, 14),
                    ),
                ),
            ],
        );
        /// Layout of the state.
        pub const LAYOUT: ::pendulum_core::StateLayout<'static> = ::pendulum_core::StateLayout::new(
                &[
                    ::pendulum_core::Slot::new(
                        "a",
                        ::pendulum_core::SlotKind::Quaternion,
                        0..4,
                        8..11,
                    ),
                    ::pendulum_core::Slot::new(
                        "b",
                        ::pendulum_core::SlotKind::Quaternion,
                        4..8,
                        11..14,
                    ),
                ],
            )
            .autonomous();
        /// Equations of motion as text.
        pub const EQUATIONS: &'static str = "A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints\n\nA[a.x, a.x] = t26 + t27 + t29 + t28 - t26 - t29\nA[a.x, a.y] = -(1/25000*t2*t5 + 0.00196*t3*t6 + 0.12192*t4*t7)\nA[a.x, a.z] = -(0.12*t4 + 1/25000*t2*t8 + 0.00392*t3*t9 + 0.06096*t4*t10)\nA[a.x, b.x] = 0.03146*t2 + 0.06*t6\nA[a.x, b.y] = 0.061*t3 - 0.12*t5\nA[a.x, b.z] = 0.002*t4\nA[a.y, a.y] = t28 + t29\nA[a.y, a.z] = -(0.12*t7 + 1/12500*t5*t8 + 0.00196*t6*t9 + 0.06096*t7*t10)\nA[a.y, b.x] = 0.06292*t5 - 0.12*t3\nA[a.y, b.y] = 0.0305*t6 + 0.06*t2\nA[a.y, b.z] = 0.002*t7\nA[a.z, a.z] = t26 + t27\nA[a.z, b.x] = 0.06292*t8\nA[a.z, b.y] = 0.061*t9\nA[a.z, b.z] = 0.001*t10\nA[b.x, b.x] = 0.03146\nA[b.y, b.y] = 0.0305\nA[b.z, b.z] = 0.001\nb[a.x] = 9.81*t1 + 1/12500*dot(a).y*dot(a).z + t2*b[b.x] + 2*t3*b[b.y] + 2*t4*b[b.z]\n    + 0.5*(2*t7*t25 - 0.12*t6*t23 - 0.24*t5*t24) - 13/60*dot(a).y*dot(a).z\nb[a.y] = 13/60*dot(a).x*dot(a).z + 2*t5*b[b.x] + t6*b[b.y] + 2*t7*b[b.z] - 1/12500*dot(a).x*dot(a).z - 9.81*t0\n    - 0.5*(2*t4*t25 - 0.24*t3*t23 - 0.12*t2*t24)\nb[a.z] = 2*t8*b[b.x] + 2*t9*b[b.y] + t10*b[b.z]\nb[b.x] = 0.12*(2*t9*t13 + 2*t3*t11 + t6*t12) + 0.00098*(t19 + t20*t21) - 0.03048*t23\nb[b.y] = 0.03048*t24 - 1/50000*(t21*t22 - t17) - 0.12*(2*t8*t13 + t2*t11 + 2*t5*t12)\nb[b.z] = 1/50000*(t18 + t20*t22) - 0.00098*(t20*t22 - t18)\n\nwhere\nt0 = a.x*a.z - a.y*a.w\nt1 = a.y*a.z + a.x*a.w\nt2 = 1 - 2*(b.y^2 + b.z^2)\nt3 = b.x*b.y - b.z*b.w\nt4 = b.x*b.z + b.y*b.w\nt5 = b.x*b.y + b.z*b.w\nt6 = 1 - 2*(b.x^2 + b.z^2)\nt7 = b.y*b.z - b.x*b.w\nt8 = b.x*b.z - b.y*b.w\nt9 = b.y*b.z + b.x*b.w\nt10 = 1 - 2*(b.x^2 + b.y^2)\nt11 = 19.62*t0 - 0.5*dot(a).x*dot(a).z\nt12 = 19.62*t1 - 0.5*dot(a).y*dot(a).z\nt13 = 9.81*(1 - 2*(a.x^2 + a.y^2)) + 0.5*(dot(a).y^2 + dot(a).x^2)\nt14 = 2*dot(a).z*t9 + 2*dot(a).x*t3 + dot(a).y*t6\nt15 = dot(a).z*t10 + 2*dot(a).x*t4 + 2*dot(a).y*t7\nt16 = 2*dot(a).z*t8 + dot(a).x*t2 + 2*dot(a).y*t5\nt17 = dot(b).x*t15 - dot(b).z*t16\nt18 = dot(b).y*t16 - dot(b).x*t14\nt19 = dot(b).z*t14 - dot(b).y*t15\nt20 = dot(b).y + t14\nt21 = dot(b).z + t15\nt22 = dot(b).x + t16\nt23 = t20*t21 - t19\nt24 = t17 + t21*t22\nt25 = 0.12*(t20^2 + t22^2)\nt26 = 1/12500 + 1/50000*t2^2 + 0.00392*t3^2 + 0.12192*t4^2\nt27 = 1/12500 + 1/12500*t5^2 + 0.00098*t6^2 + 0.12192*t7^2\nt28 = 13/60 + 0.12*t10 + 1/12500*t8^2 + 0.00392*t9^2 + 0.03048*t10^2\nt29 = t27 + t26 - t27\n";
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::System<T, 14>
    for BallPendulum<T> {
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn rhs(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 14>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 14> {
            let [qw_a, qx_a, qy_a, qz_a, qw_b, qx_b, qy_b, qz_b, qdx_a, qdy_a, qdz_a,
            qdx_b, qdy_b, qdz_b] = x.data.0[0];
            let t0 = qy_b * qy_b;
            let t1 = qz_b * qz_b;
            let t2 = qx_b * qx_b;
            let t3 = qx_b * qy_b;
            let t4 = qz_b * qw_b;
            let t5 = T::from_f64(2.0).mul_neg_add(t0 + t1, T::from_f64(1.0));
            let t6 = T::from_f64(2.0).mul_neg_add(t1 + t2, T::from_f64(1.0));
            let t7 = T::from_f64(2.0).mul_neg_add(t0 + t2, T::from_f64(1.0));
            let t8 = qy_b * qz_b;
            let t9 = qx_b * qw_b;
            let t10 = qx_b * qz_b;
            let t11 = qy_b * qw_b;
            let t12 = t3 - t4;
            let t13 = t3 + t4;
            let t14 = T::from_f64(2.0) * (t8 + t9);
            let t15 = T::from_f64(2.0) * (t8 - t9);
            let t16 = T::from_f64(2.0) * (t10 + t11);
            let t17 = T::from_f64(2.0) * (t10 - t11);
            let t18 = T::from_f64(2.0) * t12;
            let t19 = T::from_f64(0.9154481881754609) * t12;
            let t20 = T::from_f64(2.0) * t13;
            let t21 = T::from_f64(0.9442622950819672) * t13;
            let t22 = t6.mul_add(qdy_a, t18.mul_add(qdx_a, qdz_a.mul_add(t14, qdy_b)));
            let t23 = qdy_a.mul_add(t15, qdx_a.mul_add(t16, qdz_a.mul_add(t7, qdz_b)));
            let t24 = t20.mul_add(qdy_a, t5.mul_add(qdx_a, qdz_a.mul_add(t17, qdx_b)));
            let t25 = T::from_f64(0.5) * qdx_a.mul_add(qdx_a, qdy_a * qdy_a);
            let t26 = qdx_a * qdz_a;
            let t27 = qdz_a * qdy_a;
            let t28 = T::from_f64(0.4721311475409836) * t5;
            let t29 = T::from_f64(0.45772409408773046) * t6;
            let t30 = T::from_f64(0.5) * t26;
            let t31 = T::from_f64(0.5) * t27;
            let t32 = t5.mul_add(t28, t18 * t19);
            let t33 = t20.mul_add(t21, t6 * t29);
            let t34 = t22 * t23;
            let t35 = t23 * t24;
            let t36 = t6.mul_neg_add(t31, t18.mul_neg_add(t30, t14 * t25));
            let t37 = t20.mul_neg_add(t31, t5.mul_neg_add(t30, t17 * t25));
            let t38 = T::from_f64(0.03048).mul_neg_add(t34, T::from_f64(0.00098) * t34);
            let t39 = T::from_f64(0.45772409408773046)
                .mul_add(
                    t36,
                    T::from_f64(0.12).mul_add(t34, T::from_f64(3.814367450731087) * t38),
                );
            let t40 = T::from_f64(2e-5).mul_neg_add(t35, T::from_f64(0.03048) * t35);
            let t41 = T::from_f64(3.9344262295081966)
                .mul_neg_add(
                    t40,
                    T::from_f64(0.4721311475409836).mul_add(t37, T::from_f64(0.12) * t35),
                );
            let t42 = T::from_f64(0.25)
                .mul_neg_add(t32, T::from_f64(0.21674666666666667));
            let t43 = T::from_f64(0.5).mul_sub(t32, T::from_f64(0.5));
            let t44 = T::from_f64(0.25)
                .mul_neg_add(t33, T::from_f64(0.21674666666666667));
            let t45 = t22 * t24;
            let t46 = T::from_f64(0.00098).mul_neg_add(t45, T::from_f64(2e-5) * t45);
            let t47 = T::from_f64(0.12) * t24.mul_add(t24, t22 * t22);
            let t48 = t44 - t42;
            let t49 = T::from_f64(1.0) / (t44 - t48);
            let t50 = t38 - t38;
            let t51 = t40 - t40;
            let t52 = t46 - t46;
            let t53 = T::from_f64(0.5)
                .mul_neg_add(
                    t5.mul_neg_add(t41, t18.mul_neg_add(t39, t16 * t47)),
                    T::from_f64(0.21658666666666668)
                        .mul_add(t26, t15.mul_add(t52, t6.mul_add(t51, t20 * t50))),
                );
            let t54 = t28.mul_add(t20, t19 * t6);
            let t55 = T::from_f64(0.5) * t28.mul_add(t17, t19 * t14);
            let t56 = T::from_f64(19.62)
                .mul_neg_add(qy_a.mul_add(qy_a, qx_a * qx_a), T::from_f64(9.81));
            let t57 = T::from_f64(0.25) * t54;
            let t58 = T::from_f64(0.5) * t54;
            let t59 = t57 * t49;
            let t60 = t56
                .mul_add(
                    t59.mul_add(t55, T::from_f64(0.5) * t21.mul_add(t17, t29 * t14)),
                    t59 * t53,
                );
            let t61 = T::from_f64(19.62) * qy_a.mul_neg_add(qw_a, qz_a * qx_a);
            let t62 = t5
                .mul_neg_add(
                    t50,
                    T::from_f64(0.21658666666666668)
                        .mul_add(t27, t61.mul_add(t59.mul_add(t43, t58), t60)),
                );
            let t63 = T::from_f64(0.5)
                .mul_neg_add(
                    t20.mul_neg_add(t41, t6.mul_neg_add(t39, t15 * t47)),
                    t16.mul_neg_add(t52, t18.mul_neg_add(t51, t62)),
                );
            let t64 = t7.mul_add(t52, t14.mul_add(t51, t50 * t17));
            let t65 = T::from_f64(-6250.0) * t64;
            let t66 = T::from_f64(6250.0) * t64;
            let t67 = T::from_f64(19.62) * qx_a.mul_add(qw_a, qy_a * qz_a);
            let t68 = T::from_f64(1.0) / t57.mul_neg_add(t59, t42 + t48)
                * t67
                    .mul_neg_add(
                        t59
                            .mul_neg_add(
                                t58,
                                T::from_f64(0.5).mul_neg_add(t33, T::from_f64(0.5)),
                            ),
                        t63,
                    );
            let t69 = t61
                .mul_add(t43, t56.mul_add(t55, t67.mul_add(t58, t57.mul_add(t68, t53))));
            let t70 = t49 * t69;
            let t71 = t7
                .mul_neg_add(
                    t66,
                    t15
                        .mul_neg_add(
                            t70,
                            t22.mul_neg_add(qdx_b, t16.mul_add(t68, qdy_b * t24)),
                        ),
                );
            let t72 = T::from_f64(-1000.0) * T::from_f64(0.001).mul_add(t71, t46);
            let t73 = t17
                .mul_neg_add(
                    t66,
                    t20
                        .mul_neg_add(
                            t70,
                            qdy_b.mul_neg_add(t23, t5.mul_add(t68, t22 * qdz_b)),
                        ),
                );
            let t74 = t14
                .mul_neg_add(
                    t66,
                    t6
                        .mul_neg_add(
                            t70,
                            qdz_b.mul_neg_add(t24, t18.mul_add(t68, t23 * qdx_b)),
                        ),
                );
            let t75 = T::from_f64(0.5).mul_add(t68, t67);
            let t76 = T::from_f64(0.5).mul_add(t70, t61);
            let t77 = T::from_f64(0.12)
                .mul_add(
                    t6.mul_add(t75, t18.mul_add(t76, t14.mul_add(t56, t36))),
                    T::from_f64(0.03146).mul_add(t73, t38),
                );
            let t78 = T::from_f64(0.12)
                .mul_sub(t20.mul_add(t75, t5.mul_add(t76, t17.mul_add(t56, t37))), t40);
            let t79 = T::from_f64(32.78688524590164)
                * T::from_f64(0.0305).mul_neg_add(t74, t78);
            let t80 = -t70;
            let t81 = T::from_f64(-31.78639542275906) * t77;
            let t82 = T::from_f64(0.5) * qx_a;
            let t83 = T::from_f64(0.5) * qy_a;
            let t84 = T::from_f64(0.5) * qz_a;
            let t85 = -qdz_a.mul_add(t84, qdy_a.mul_add(t83, qdx_a * t82));
            let t86 = T::from_f64(0.5) * qx_b;
            let t87 = T::from_f64(0.5) * qy_b;
            let t88 = T::from_f64(0.5) * qz_b;
            let t89 = -qdz_b.mul_add(t88, qdy_b.mul_add(t87, qdx_b * t86));
            let t90 = T::from_f64(0.5) * qw_a;
            let t91 = qdz_a.mul_add(t83, qdy_a.mul_neg_add(t84, qdx_a * t90));
            let t92 = qdz_a.mul_neg_add(t82, qdy_a.mul_add(t90, qdx_a * t84));
            let t93 = qdz_a.mul_add(t90, qdx_a.mul_neg_add(t83, qdy_a * t82));
            let t94 = T::from_f64(0.5) * qw_b;
            let t95 = qdz_b.mul_add(t87, qdy_b.mul_neg_add(t88, qdx_b * t94));
            let t96 = qdz_b.mul_neg_add(t86, qdy_b.mul_add(t94, qdx_b * t88));
            let t97 = qdz_b.mul_add(t94, qdx_b.mul_neg_add(t87, qdy_b * t86));
            ::pendulum_core::nalgebra::SVector::from([
                t85,
                t91,
                t92,
                t93,
                t89,
                t95,
                t96,
                t97,
                t68,
                t80,
                t65,
                t81,
                t79,
                t72,
            ])
        }
        #[inline]
        fn layout(&self) -> ::core::option::Option<::pendulum_core::StateLayout<'_>> {
            Some(<BallPendulum>::LAYOUT)
        }
        #[inline]
        fn project(&self, t: T, x: &mut ::pendulum_core::nalgebra::SVector<T, 14>) {
            let norm = (x[0] * x[0] + x[1] * x[1] + x[2] * x[2] + x[3] * x[3]).sqrt();
            x[0] /= norm;
            x[1] /= norm;
            x[2] /= norm;
            x[3] /= norm;
            let norm = (x[4] * x[4] + x[5] * x[5] + x[6] * x[6] + x[7] * x[7]).sqrt();
            x[4] /= norm;
            x[5] /= norm;
            x[6] /= norm;
            x[7] /= norm;
        }
    }
    struct __Code<'a, T> {
        t: T,
        x: &'a ::pendulum_core::nalgebra::SVector<T, 14>,
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<
        T: ::pendulum_core::real::Real,
    > ::pendulum_core::real::lanes::Routine<(), BallPendulum<T>> for __Code<'_, T> {
        type Output = (
            ::pendulum_core::nalgebra::SVector<T, 14>,
            ::pendulum_core::nalgebra::SMatrix<T, 14, 14>,
        );
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn run(
            self,
            (): &mut (),
            model: &BallPendulum<T>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 14>,
            ::pendulum_core::nalgebra::SMatrix<T, 14, 14>,
        ) {
            let Self { t, x } = self;
            let [qw_a, qx_a, qy_a, qz_a, qw_b, qx_b, qy_b, qz_b, qdx_a, qdy_a, qdz_a,
            qdx_b, qdy_b, qdz_b] = x.data.0[0];
            let (
                t0,
                t1,
                t2,
                t3,
                t4,
                t5,
                t6,
                t7,
                t8,
                t9,
                t10,
                t11,
                t12,
                t13,
                t14,
                t15,
                t16,
                t17,
                t18,
                t19,
                t20,
                t21,
                t26,
                t30,
                t36,
                t37,
                t39,
                t44,
                t46,
                t48,
                t49,
                t52,
                t53,
                t54,
                t55,
                t58,
                t59,
                t61,
                t62,
                t66,
                t67,
                t68,
                t75,
                t87,
                t92,
                t93,
                t95,
                t97,
                t98,
                t99,
                t101,
                t106,
                t109,
                t110,
                t113,
                t115,
                t116,
                t117,
                t118,
                t134,
                t135,
                t136,
                t141,
                t142,
                t143,
                t144,
                t161,
                t162,
                t163,
                t168,
                t169,
                t170,
                t183,
                t184,
                t185,
                t190,
                t191,
                t203,
                t204,
                t205,
                t210,
                t211,
                t212,
                t213,
                t214,
                t215,
                t216,
                t217,
                t218,
                t219,
                t220,
                t221,
                t222,
                t223,
                t224,
                t225,
                t226,
                t229,
                t230,
                t233,
                t234,
                t235,
                t236,
                t237,
                t238,
                t239,
                t240,
                t241,
                t242,
                t243,
                t244,
                t245,
                t248,
                t249,
                t250,
                t251,
                t252,
                t253,
                t254,
                t255,
            ) = {
                let t0 = T::from_f64(0.5) * qx_a;
                let t1 = T::from_f64(0.5) * qy_a;
                let t2 = T::from_f64(0.5) * qz_a;
                let t3 = -qdz_a.mul_add(t2, qdy_a.mul_add(t1, qdx_a * t0));
                let t4 = T::from_f64(0.5) * qw_a;
                let t5 = qdz_a.mul_add(t1, qdy_a.mul_neg_add(t2, qdx_a * t4));
                let t6 = qdz_a.mul_neg_add(t0, qdy_a.mul_add(t4, qdx_a * t2));
                let t7 = qdz_a.mul_add(t4, qdx_a.mul_neg_add(t1, qdy_a * t0));
                let t8 = -t0;
                let t9 = -t1;
                let t10 = -t2;
                let t11 = T::from_f64(0.5) * qx_b;
                let t12 = T::from_f64(0.5) * qy_b;
                let t13 = T::from_f64(0.5) * qz_b;
                let t14 = -qdz_b.mul_add(t13, qdy_b.mul_add(t12, qdx_b * t11));
                let t15 = T::from_f64(0.5) * qw_b;
                let t16 = qdz_b.mul_add(t12, qdy_b.mul_neg_add(t13, qdx_b * t15));
                let t17 = qdz_b.mul_neg_add(t11, qdy_b.mul_add(t15, qdx_b * t13));
                let t18 = qdz_b.mul_add(t15, qdx_b.mul_neg_add(t12, qdy_b * t11));
                let t19 = -t11;
                let t20 = -t12;
                let t21 = -t13;
                let t22 = qx_b * qy_b;
                let t23 = qz_b * qw_b;
                let t24 = t22 - t23;
                let t25 = t22 + t23;
                let t26 = T::from_f64(2.0) * t24;
                let t27 = T::from_f64(0.9154481881754609) * t24;
                let t28 = qy_b * qy_b;
                let t29 = qz_b * qz_b;
                let t30 = T::from_f64(2.0).mul_neg_add(t28 + t29, T::from_f64(1.0));
                let t31 = T::from_f64(0.4721311475409836) * t30;
                let t32 = t30.mul_add(t31, t26 * t27);
                let t33 = T::from_f64(0.25)
                    .mul_neg_add(t32, T::from_f64(0.21674666666666667));
                let t34 = T::from_f64(0.5).mul_sub(t32, T::from_f64(0.5));
                let t35 = qx_b * qx_b;
                let t36 = T::from_f64(2.0).mul_neg_add(t29 + t35, T::from_f64(1.0));
                let t37 = T::from_f64(2.0).mul_neg_add(t28 + t35, T::from_f64(1.0));
                let t38 = T::from_f64(0.45772409408773046) * t36;
                let t39 = T::from_f64(2.0) * t25;
                let t40 = T::from_f64(0.9442622950819672) * t25;
                let t41 = t39.mul_add(t40, t36 * t38);
                let t42 = T::from_f64(0.25)
                    .mul_neg_add(t41, T::from_f64(0.21674666666666667));
                let t43 = t42 - t33;
                let t44 = T::from_f64(1.0) / (t42 - t43);
                let t45 = t31.mul_add(t39, t27 * t36);
                let t46 = T::from_f64(0.25) * t45;
                let t47 = T::from_f64(0.5) * t45;
                let t48 = t46 * t44;
                let t49 = T::from_f64(1.0) / t46.mul_neg_add(t48, t33 + t43);
                let t50 = qy_b * qz_b;
                let t51 = qx_b * qw_b;
                let t52 = T::from_f64(2.0) * (t50 + t51);
                let t53 = T::from_f64(2.0) * (t50 - t51);
                let t54 = t36.mul_add(qdy_a, t26.mul_add(qdx_a, qdz_a * t52));
                let t55 = qdy_b + t54;
                let t56 = qx_b * qz_b;
                let t57 = qy_b * qw_b;
                let t58 = T::from_f64(2.0) * (t56 + t57);
                let t59 = T::from_f64(2.0) * (t56 - t57);
                let t60 = T::from_f64(0.5) * t31.mul_add(t59, t27 * t52);
                let t61 = qdy_a.mul_add(t53, qdx_a.mul_add(t58, qdz_a * t37));
                let t62 = qdz_b + t61;
                let t63 = t55 * t62;
                let t64 = T::from_f64(0.03048)
                    .mul_neg_add(t63, T::from_f64(0.00098) * t63);
                let t65 = t64 - t64;
                let t66 = t39.mul_add(qdy_a, t30.mul_add(qdx_a, qdz_a * t59));
                let t67 = qdx_b + t66;
                let t68 = t62 * t67;
                let t69 = T::from_f64(2e-5).mul_neg_add(t68, T::from_f64(0.03048) * t68);
                let t70 = t69 - t69;
                let t71 = t55 * t67;
                let t72 = T::from_f64(0.00098).mul_neg_add(t71, T::from_f64(2e-5) * t71);
                let t73 = t72 - t72;
                let t74 = qdx_a * qdz_a;
                let t75 = T::from_f64(0.12) * t67.mul_add(t67, t55 * t55);
                let t76 = T::from_f64(0.5) * qdx_a.mul_add(qdx_a, qdy_a * qdy_a);
                let t77 = T::from_f64(0.5) * t74;
                let t78 = qdz_a * qdy_a;
                let t79 = T::from_f64(0.5) * t78;
                let t80 = t36.mul_neg_add(t79, t26.mul_neg_add(t77, t52 * t76));
                let t81 = t39.mul_neg_add(t79, t30.mul_neg_add(t77, t59 * t76));
                let t82 = T::from_f64(0.45772409408773046)
                    .mul_add(
                        t80,
                        T::from_f64(0.12)
                            .mul_add(t63, T::from_f64(3.814367450731087) * t64),
                    );
                let t83 = T::from_f64(3.9344262295081966)
                    .mul_neg_add(
                        t69,
                        T::from_f64(0.4721311475409836)
                            .mul_add(t81, T::from_f64(0.12) * t68),
                    );
                let t84 = T::from_f64(0.5)
                    .mul_neg_add(
                        t30.mul_neg_add(t83, t26.mul_neg_add(t82, t58 * t75)),
                        T::from_f64(0.21658666666666668)
                            .mul_add(t74, t53.mul_add(t73, t36.mul_add(t70, t39 * t65))),
                    );
                let t85 = T::from_f64(19.62)
                    .mul_neg_add(qy_a.mul_add(qy_a, qx_a * qx_a), T::from_f64(9.81));
                let t86 = t85
                    .mul_add(
                        t48.mul_add(t60, T::from_f64(0.5) * t40.mul_add(t59, t38 * t52)),
                        t48 * t84,
                    );
                let t87 = t76 + t85;
                let t88 = T::from_f64(19.62) * qy_a.mul_neg_add(qw_a, qz_a * qx_a);
                let t89 = t30
                    .mul_neg_add(
                        t65,
                        T::from_f64(0.21658666666666668)
                            .mul_add(t78, t88.mul_add(t48.mul_add(t34, t47), t86)),
                    );
                let t90 = T::from_f64(0.5)
                    .mul_neg_add(
                        t39.mul_neg_add(t83, t36.mul_neg_add(t82, t53 * t75)),
                        t58.mul_neg_add(t73, t26.mul_neg_add(t70, t89)),
                    );
                let t91 = t37.mul_add(t73, t52.mul_add(t70, t65 * t59));
                let t92 = T::from_f64(-6250.0) * t91;
                let t93 = T::from_f64(6250.0) * t91;
                let t94 = T::from_f64(19.62) * qx_a.mul_add(qw_a, qy_a * qz_a);
                let t95 = t49
                    * t94
                        .mul_neg_add(
                            t48
                                .mul_neg_add(
                                    t47,
                                    T::from_f64(0.5).mul_neg_add(t41, T::from_f64(0.5)),
                                ),
                            t90,
                        );
                let t96 = t88
                    .mul_add(
                        t34,
                        t85.mul_add(t60, t94.mul_add(t47, t46.mul_add(t95, t84))),
                    );
                let t97 = t44 * t96;
                let t98 = -t97;
                let t99 = T::from_f64(0.5).mul_neg_add(t74 - t97, t88);
                let t100 = T::from_f64(0.5).mul_add(t97, t88);
                let t101 = T::from_f64(0.5).mul_neg_add(t78 - t95, t94);
                let t102 = T::from_f64(0.5).mul_add(t95, t94);
                let t103 = T::from_f64(0.12)
                    .mul_sub(
                        t39.mul_add(t102, t30.mul_add(t100, t59.mul_add(t85, t81))),
                        t69,
                    );
                let t104 = t59.mul_neg_add(t93, t39.mul_neg_add(t97, t30 * t95));
                let t105 = T::from_f64(0.12)
                    .mul_add(
                        t36.mul_add(t102, t26.mul_add(t100, t52.mul_add(t85, t80))),
                        T::from_f64(0.03146)
                            .mul_add(
                                qdy_b.mul_neg_add(t62, t55.mul_add(qdz_b, t104)),
                                t64,
                            ),
                    );
                let t106 = T::from_f64(-31.78639542275906) * t105;
                let t107 = qdy_b
                    .mul_neg_add(
                        t61,
                        T::from_f64(31.78639542275906)
                            .mul_neg_add(t105, t54.mul_add(qdz_b, t104)),
                    );
                let t108 = t52.mul_neg_add(t93, t36.mul_neg_add(t97, t26 * t95));
                let t109 = T::from_f64(32.78688524590164)
                    * T::from_f64(0.0305)
                        .mul_neg_add(
                            qdz_b.mul_neg_add(t67, t62.mul_add(qdx_b, t108)),
                            t103,
                        );
                let t110 = qdz_b.mul_neg_add(t66, t61.mul_add(qdx_b, t108 + t109));
                let t111 = t37.mul_neg_add(t93, t53.mul_neg_add(t97, t58 * t95));
                let t112 = T::from_f64(0.001)
                    .mul_add(t55.mul_neg_add(qdx_b, qdy_b.mul_add(t67, t111)), t72);
                let t113 = T::from_f64(-1000.0) * t112;
                let t114 = t54
                    .mul_neg_add(
                        qdx_b,
                        T::from_f64(1000.0).mul_neg_add(t112, qdy_b.mul_add(t66, t111)),
                    );
                let t115 = T::from_f64(0.00098)
                    .mul_neg_add(t71 - t114, T::from_f64(2e-5) * (t71 + t114));
                let t116 = T::from_f64(0.5) * qdx_a;
                let t117 = T::from_f64(0.5) * qdy_a;
                let t118 = T::from_f64(0.5) * qdz_a;
                let t119 = T::from_f64(9.81) * qx_a;
                let t120 = T::from_f64(19.62) * qx_a;
                let t121 = T::from_f64(19.62) * qy_a;
                let t122 = t26.mul_neg_add(t121, t36 * t120);
                let t123 = T::from_f64(0.12) * t122;
                let t124 = T::from_f64(0.45772409408773046) * t122;
                let t125 = t30.mul_neg_add(t121, t39 * t120);
                let t126 = T::from_f64(0.12) * t125;
                let t127 = T::from_f64(0.4721311475409836) * t125;
                let t128 = t26.mul_add(t126, t30 * t123);
                let t129 = T::from_f64(9.81) * qy_a;
                let t130 = t36.mul_add(t126, t39 * t123);
                let t131 = T::from_f64(0.5).mul_add(t30.mul_add(t127, t26 * t124), t129)
                    + t130 - t130;
                let t132 = t48
                    .mul_neg_add(
                        t131,
                        T::from_f64(0.5)
                            .mul_neg_add(t39.mul_add(t127, t36 * t124), t119 + t128),
                    );
                let t133 = t49 * (t132 - t128);
                let t134 = -t133;
                let t135 = t44 * t46.mul_sub(t133, t131);
                let t136 = t53.mul_neg_add(t135, t58 * t133);
                let t137 = T::from_f64(0.5) * t135;
                let t138 = T::from_f64(0.5) * t133;
                let t139 = T::from_f64(0.12)
                    .mul_neg_add(
                        t36.mul_add(t138, t26 * t137),
                        T::from_f64(0.03146)
                            .mul_add(t30.mul_neg_add(t133, t39 * t135), t123),
                    );
                let t140 = T::from_f64(0.12)
                    .mul_neg_add(
                        t39.mul_add(t138, t30 * t137),
                        T::from_f64(0.0305)
                            .mul_neg_add(t26.mul_neg_add(t133, t36 * t135), t126),
                    );
                let t141 = T::from_f64(-31.78639542275906) * t139;
                let t142 = T::from_f64(32.78688524590164) * t140;
                let t143 = -t116;
                let t144 = -t118;
                let t145 = T::from_f64(9.81) * qw_a;
                let t146 = T::from_f64(9.81) * qz_a;
                let t147 = T::from_f64(19.62) * qz_a;
                let t148 = T::from_f64(19.62) * qw_a;
                let t149 = T::from_f64(39.24) * qx_a;
                let t150 = t52.mul_neg_add(t149, t36.mul_add(t148, t26 * t147));
                let t151 = t59.mul_neg_add(t149, t39.mul_add(t148, t30 * t147));
                let t152 = T::from_f64(0.12) * t150;
                let t153 = T::from_f64(0.45772409408773046) * t150;
                let t154 = T::from_f64(0.12) * t151;
                let t155 = T::from_f64(0.4721311475409836) * t151;
                let t156 = t36.mul_add(t154, t39 * t152);
                let t157 = T::from_f64(0.5)
                    .mul_neg_add(t30.mul_add(t155, t26 * t153), t146 + t156) - t156;
                let t158 = t26.mul_add(t154, t30 * t152);
                let t159 = T::from_f64(0.5)
                    .mul_neg_add(
                        t39.mul_add(t155, t36 * t153),
                        t48.mul_add(t157, t145) + t158,
                    );
                let t160 = t49 * (t159 - t158);
                let t161 = -t160;
                let t162 = t44 * t46.mul_add(t160, t157);
                let t163 = t53.mul_neg_add(t162, t58 * t160);
                let t164 = T::from_f64(0.5) * t162;
                let t165 = T::from_f64(0.5) * t160;
                let t166 = T::from_f64(0.12)
                    .mul_neg_add(
                        t36.mul_add(t165, t26 * t164),
                        T::from_f64(0.03146)
                            .mul_add(t30.mul_neg_add(t160, t39 * t162), t152),
                    );
                let t167 = T::from_f64(0.12)
                    .mul_neg_add(
                        t39.mul_add(t165, t30 * t164),
                        T::from_f64(0.0305)
                            .mul_neg_add(t26.mul_neg_add(t160, t36 * t162), t154),
                    );
                let t168 = T::from_f64(-31.78639542275906) * t166;
                let t169 = T::from_f64(32.78688524590164) * t167;
                let t170 = -t117;
                let t171 = T::from_f64(39.24) * qy_a;
                let t172 = t52.mul_neg_add(t171, t26.mul_neg_add(t148, t36 * t147));
                let t173 = t59.mul_neg_add(t171, t30.mul_neg_add(t148, t39 * t147));
                let t174 = T::from_f64(0.12) * t172;
                let t175 = T::from_f64(0.45772409408773046) * t172;
                let t176 = T::from_f64(0.12) * t173;
                let t177 = T::from_f64(0.4721311475409836) * t173;
                let t178 = t26.mul_add(t176, t30 * t174);
                let t179 = t36.mul_add(t176, t39 * t174);
                let t180 = T::from_f64(0.5).mul_add(t30.mul_add(t177, t26 * t175), t145)
                    + t179 - t179;
                let t181 = t48
                    .mul_neg_add(
                        t180,
                        T::from_f64(0.5)
                            .mul_neg_add(t39.mul_add(t177, t36 * t175), t146 + t178),
                    );
                let t182 = t49 * (t181 - t178);
                let t183 = -t182;
                let t184 = t44 * t46.mul_sub(t182, t180);
                let t185 = t53.mul_neg_add(t184, t58 * t182);
                let t186 = T::from_f64(0.5) * t184;
                let t187 = T::from_f64(0.5) * t182;
                let t188 = T::from_f64(0.12)
                    .mul_neg_add(
                        t36.mul_add(t187, t26 * t186),
                        T::from_f64(0.03146)
                            .mul_add(t30.mul_neg_add(t182, t39 * t184), t174),
                    );
                let t189 = T::from_f64(0.12)
                    .mul_neg_add(
                        t39.mul_add(t187, t30 * t186),
                        T::from_f64(0.0305)
                            .mul_neg_add(t26.mul_neg_add(t182, t36 * t184), t176),
                    );
                let t190 = T::from_f64(-31.78639542275906) * t188;
                let t191 = T::from_f64(32.78688524590164) * t189;
                let t192 = t36.mul_add(t121, t26 * t120);
                let t193 = t39.mul_add(t121, t30 * t120);
                let t194 = T::from_f64(0.12) * t192;
                let t195 = T::from_f64(0.45772409408773046) * t192;
                let t196 = T::from_f64(0.12) * t193;
                let t197 = T::from_f64(0.4721311475409836) * t193;
                let t198 = t36.mul_add(t196, t39 * t194);
                let t199 = T::from_f64(0.5)
                    .mul_neg_add(t30.mul_add(t197, t26 * t195), t119 + t198) - t198;
                let t200 = t26.mul_add(t196, t30 * t194);
                let t201 = T::from_f64(0.5)
                    .mul_neg_add(
                        t39.mul_add(t197, t36 * t195),
                        t48.mul_add(t199, t129) + t200,
                    );
                let t202 = t49 * (t201 - t200);
                let t203 = -t202;
                let t204 = t44 * t46.mul_add(t202, t199);
                let t205 = t53.mul_neg_add(t204, t58 * t202);
                let t206 = T::from_f64(0.5) * t204;
                let t207 = T::from_f64(0.5) * t202;
                let t208 = T::from_f64(0.12)
                    .mul_neg_add(
                        t36.mul_add(t207, t26 * t206),
                        T::from_f64(0.03146)
                            .mul_add(t30.mul_neg_add(t202, t39 * t204), t194),
                    );
                let t209 = T::from_f64(0.12)
                    .mul_neg_add(
                        t39.mul_add(t207, t30 * t206),
                        T::from_f64(0.0305)
                            .mul_neg_add(t26.mul_neg_add(t202, t36 * t204), t196),
                    );
                let t210 = T::from_f64(-31.78639542275906) * t208;
                let t211 = T::from_f64(32.78688524590164) * t209;
                let t212 = T::from_f64(0.5) * qdx_b;
                let t213 = -t212;
                let t214 = T::from_f64(0.5) * qdy_b;
                let t215 = -t214;
                let t216 = T::from_f64(0.5) * qdz_b;
                let t217 = -t216;
                let t218 = T::from_f64(2.0) * qx_b;
                let t219 = t218 * t87;
                let t220 = T::from_f64(2.0) * qz_b;
                let t221 = qdz_a * t218;
                let t222 = qdx_a * t220;
                let t223 = t221 - t222;
                let t224 = T::from_f64(2.0) * qy_b;
                let t225 = qdx_a * t224;
                let t226 = qdy_a * t218;
                let t227 = t225 - t226;
                let t228 = t55.mul_add(t227, t62 * t223);
                let t229 = t93 * t224;
                let t230 = t97 * t220;
                let t231 = qdy_b.mul_neg_add(t227, qdz_b.mul_add(t223, t229)) - t230;
                let t232 = t228 - t231;
                let t233 = T::from_f64(0.03048)
                    .mul_neg_add(
                        t232,
                        T::from_f64(0.00098)
                            .mul_add(
                                t228 + t231,
                                T::from_f64(0.12) * t220.mul_neg_add(t99, t219),
                            ),
                    );
                let t234 = T::from_f64(0.12) * t232;
                let t235 = t30 * t233;
                let t236 = t224 * t115;
                let t237 = t39 * t233;
                let t238 = t218 * t115;
                let t239 = t75 * t224;
                let t240 = T::from_f64(2.0) * t55;
                let t241 = qdy_a * t220;
                let t242 = qdz_a * t224;
                let t243 = t241 - t242;
                let t244 = T::from_f64(2.0) * t67;
                let t245 = T::from_f64(0.12) * t243.mul_add(t244, t223 * t240);
                let t246 = t63 - t107;
                let t247 = T::from_f64(0.00098)
                    .mul_add(
                        t63 + t107,
                        T::from_f64(0.12)
                            * t36.mul_add(t101, t26.mul_add(t99, t52 * t87)),
                    );
                let t248 = T::from_f64(0.03048).mul_neg_add(t246, t247);
                let t249 = T::from_f64(0.12) * t246;
                let t250 = t62.mul_add(t243, t67 * t227);
                let t251 = t93 * t218;
                let t252 = t95 * t220;
                let t253 = qdz_b.mul_neg_add(t243, qdx_b * t227) - t251 - t252;
                let t254 = t250 + t253;
                let t255 = T::from_f64(0.12) * t254;
                (
                    t0,
                    t1,
                    t2,
                    t3,
                    t4,
                    t5,
                    t6,
                    t7,
                    t8,
                    t9,
                    t10,
                    t11,
                    t12,
                    t13,
                    t14,
                    t15,
                    t16,
                    t17,
                    t18,
                    t19,
                    t20,
                    t21,
                    t26,
                    t30,
                    t36,
                    t37,
                    t39,
                    t44,
                    t46,
                    t48,
                    t49,
                    t52,
                    t53,
                    t54,
                    t55,
                    t58,
                    t59,
                    t61,
                    t62,
                    t66,
                    t67,
                    t68,
                    t75,
                    t87,
                    t92,
                    t93,
                    t95,
                    t97,
                    t98,
                    t99,
                    t101,
                    t106,
                    t109,
                    t110,
                    t113,
                    t115,
                    t116,
                    t117,
                    t118,
                    t134,
                    t135,
                    t136,
                    t141,
                    t142,
                    t143,
                    t144,
                    t161,
                    t162,
                    t163,
                    t168,
                    t169,
                    t170,
                    t183,
                    t184,
                    t185,
                    t190,
                    t191,
                    t203,
                    t204,
                    t205,
                    t210,
                    t211,
                    t212,
                    t213,
                    t214,
                    t215,
                    t216,
                    t217,
                    t218,
                    t219,
                    t220,
                    t221,
                    t222,
                    t223,
                    t224,
                    t225,
                    t226,
                    t229,
                    t230,
                    t233,
                    t234,
                    t235,
                    t236,
                    t237,
                    t238,
                    t239,
                    t240,
                    t241,
                    t242,
                    t243,
                    t244,
                    t245,
                    t248,
                    t249,
                    t250,
                    t251,
                    t252,
                    t253,
                    t254,
                    t255,
                )
            };
            let (
                t279,
                t280,
                t285,
                t287,
                t292,
                t293,
                t342,
                t343,
                t347,
                t349,
                t354,
                t355,
                t393,
                t394,
                t398,
                t400,
                t405,
                t406,
                t437,
                t438,
                t441,
                t443,
                t448,
                t449,
                t472,
                t476,
                t477,
                t480,
                t482,
                t487,
                t488,
                t492,
                t494,
                t495,
                t497,
                t501,
                t505,
                t506,
                t507,
                t510,
                t511,
            ) = {
                let t256 = t30
                    .mul_neg_add(
                        t255,
                        t26
                            .mul_neg_add(
                                t234,
                                t220.mul_add(t249, t58.mul_add(t245, t239)),
                            ),
                    );
                let t257 = T::from_f64(3.814367450731087) * t233;
                let t258 = t87 * t224;
                let t259 = T::from_f64(0.12)
                    .mul_neg_add(
                        t220.mul_sub(t101, t258),
                        T::from_f64(2e-5)
                            .mul_neg_add(t250 - t253, T::from_f64(0.03048) * t254),
                    );
                let t260 = T::from_f64(3.9344262295081966) * t259;
                let t261 = t220 * t248;
                let t262 = T::from_f64(0.5)
                    .mul_add(t256 - t30.mul_neg_add(t260, t26 * t257), t237 + t238)
                    - t261;
                let t263 = t259 - t259;
                let t264 = t55.mul_add(t243, t67 * t223);
                let t265 = t95 * t224;
                let t266 = t97 * t218;
                let t267 = qdx_b.mul_neg_add(t223, qdy_b.mul_add(t243, t265) + t266);
                let t268 = T::from_f64(0.00098)
                    .mul_neg_add(t264 - t267, T::from_f64(2e-5) * (t264 + t267));
                let t269 = t268 - t268;
                let t270 = t53.mul_neg_add(t269, t36.mul_neg_add(t263, t262 - t237));
                let t271 = t75 * t218;
                let t272 = t68 + t110;
                let t273 = T::from_f64(0.12)
                    .mul_neg_add(
                        t39.mul_add(t101, t30.mul_add(t99, t59 * t87)),
                        T::from_f64(2e-5)
                            .mul_neg_add(t68 - t110, T::from_f64(0.03048) * t272),
                    );
                let t274 = T::from_f64(0.12) * t272;
                let t275 = t39
                    .mul_neg_add(
                        t255,
                        t220
                            .mul_neg_add(
                                t274,
                                t36.mul_neg_add(t234, t53.mul_sub(t245, t271)),
                            ),
                    );
                let t276 = T::from_f64(0.5)
                    .mul_add(
                        t275 - t39.mul_neg_add(t260, t36 * t257),
                        t58
                            .mul_add(
                                t269,
                                t26.mul_add(t263, t48.mul_add(t270, t235 + t236)),
                            ),
                    );
                let t277 = t220 * t273;
                let t278 = t49 * (t276 - t235 - t277);
                let t279 = -t278;
                let t280 = t44 * t46.mul_add(t278, t270);
                let t281 = t59 * t233;
                let t282 = t218 * t273;
                let t283 = t224 * t248;
                let t284 = t37.mul_add(t269, t52.mul_add(t263, t281 + t282)) - t281
                    - t283;
                let t285 = T::from_f64(-6250.0) * t284;
                let t286 = T::from_f64(6250.0) * t284;
                let t287 = T::from_f64(-1000.0)
                    * T::from_f64(0.001)
                        .mul_add(
                            t37.mul_neg_add(t286, t58.mul_neg_add(t278, t53 * t280)),
                            t268,
                        );
                let t288 = T::from_f64(0.5) * t280;
                let t289 = T::from_f64(0.5) * t278;
                let t290 = T::from_f64(0.12)
                    .mul_neg_add(
                        t36.mul_add(t289, t26 * t288),
                        T::from_f64(0.03146)
                            .mul_add(
                                t59.mul_neg_add(t286, t30.mul_neg_add(t278, t39 * t280)),
                                t233,
                            ),
                    );
                let t291 = T::from_f64(0.12)
                    .mul_add(
                        t39.mul_add(t289, t30 * t288),
                        T::from_f64(0.0305)
                            .mul_add(
                                t52.mul_neg_add(t286, t26.mul_neg_add(t278, t36 * t280)),
                                t259,
                            ),
                    );
                let t292 = T::from_f64(-31.78639542275906) * t290;
                let t293 = T::from_f64(-32.78688524590164) * t291;
                let t294 = T::from_f64(2.0) * qw_b;
                let t295 = t87 * t294;
                let t296 = t87 * t220;
                let t297 = T::from_f64(4.0) * qx_b;
                let t298 = qdz_a * t294;
                let t299 = qdy_a.mul_neg_add(t297, t225 + t298);
                let t300 = qdy_a * t294;
                let t301 = qdz_a.mul_neg_add(t297, t222 - t300);
                let t302 = t55.mul_add(t301, t62 * t299);
                let t303 = t93 * t220;
                let t304 = t97 * t224;
                let t305 = qdy_b.mul_neg_add(t301, qdz_b * t299) - t303 - t304;
                let t306 = T::from_f64(0.00098)
                    .mul_add(
                        t302 + t305,
                        T::from_f64(0.12)
                            * t101.mul_neg_add(t297, t99.mul_add(t224, t295)),
                    );
                let t307 = t302 - t305;
                let t308 = T::from_f64(0.03048).mul_neg_add(t307, t306);
                let t309 = T::from_f64(0.12) * t307;
                let t310 = t30 * t308;
                let t311 = t224 * t273;
                let t312 = t220 * t115;
                let t313 = t39 * t308;
                let t314 = t115 * t294;
                let t315 = t75 * t220;
                let t316 = qdz_a * t220;
                let t317 = t75 * t294;
                let t318 = qdy_a * t224;
                let t319 = t316 + t318;
                let t320 = T::from_f64(0.12) * t244.mul_add(t319, t240 * t299);
                let t321 = t62.mul_add(t319, t67 * t301);
                let t322 = t93 * t294;
                let t323 = qdz_b
                    .mul_neg_add(t319, t97.mul_add(t297, qdx_b.mul_add(t301, t265)))
                    - t322;
                let t324 = t321 + t323;
                let t325 = T::from_f64(0.12)
                    .mul_neg_add(
                        t224.mul_add(t101, t296),
                        T::from_f64(2e-5)
                            .mul_neg_add(t321 - t323, T::from_f64(0.03048) * t324),
                    );
                let t326 = T::from_f64(0.12) * t324;
                let t327 = t30
                    .mul_neg_add(
                        t326,
                        t26
                            .mul_neg_add(
                                t309,
                                t224.mul_neg_add(t249, t58.mul_add(t320, t315)),
                            ),
                    );
                let t328 = t224
                    .mul_neg_add(
                        t274,
                        t36.mul_neg_add(t309, t249.mul_add(t297, t53 * t320) - t317),
                    );
                let t329 = T::from_f64(3.814367450731087) * t308;
                let t330 = T::from_f64(3.9344262295081966) * t325;
                let t331 = T::from_f64(0.5)
                    .mul_add(
                        t327 - t30.mul_neg_add(t330, t26 * t329),
                        t273.mul_add(t297, t313) + t314,
                    );
                let t332 = t325 - t325;
                let t333 = t55.mul_add(t319, t67 * t299);
                let t334 = t97 * t294;
                let t335 = qdx_b
                    .mul_neg_add(
                        t299,
                        t93.mul_add(t297, qdy_b.mul_add(t319, t252)) + t334,
                    );
                let t336 = T::from_f64(0.00098)
                    .mul_neg_add(t333 - t335, T::from_f64(2e-5) * (t333 + t335));
                let t337 = t336 - t336;
                let t338 = t53
                    .mul_neg_add(t337, t36.mul_neg_add(t332, t331 - t283 - t313));
                let t339 = t58
                    .mul_add(
                        t337,
                        t26.mul_add(t332, t48.mul_add(t338, t310 + t311 + t312)),
                    );
                let t340 = T::from_f64(0.5)
                    .mul_add(
                        t39.mul_neg_add(t326, t328) - t39.mul_neg_add(t330, t36 * t329),
                        t339,
                    );
                let t341 = t49 * (t340 - t310);
                let t342 = -t341;
                let t343 = t44 * t46.mul_add(t341, t338);
                let t344 = t59 * t308;
                let t345 = t273 * t294;
                let t346 = t115
                    .mul_neg_add(
                        t297,
                        t37.mul_add(t337, t52.mul_add(t332, t261 + t344 + t345)) - t344,
                    );
                let t347 = T::from_f64(-6250.0) * t346;
                let t348 = T::from_f64(6250.0) * t346;
                let t349 = T::from_f64(-1000.0)
                    * T::from_f64(0.001)
                        .mul_add(
                            t37.mul_neg_add(t348, t58.mul_neg_add(t341, t53 * t343)),
                            t336,
                        );
                let t350 = T::from_f64(0.5) * t343;
                let t351 = T::from_f64(0.5) * t341;
                let t352 = T::from_f64(0.12)
                    .mul_neg_add(
                        t36.mul_add(t351, t26 * t350),
                        T::from_f64(0.03146)
                            .mul_add(
                                t59.mul_neg_add(t348, t30.mul_neg_add(t341, t39 * t343)),
                                t308,
                            ),
                    );
                let t353 = T::from_f64(0.12)
                    .mul_add(
                        t39.mul_add(t351, t30 * t350),
                        T::from_f64(0.0305)
                            .mul_add(
                                t52.mul_neg_add(t348, t26.mul_neg_add(t341, t36 * t343)),
                                t325,
                            ),
                    );
                let t354 = T::from_f64(-31.78639542275906) * t352;
                let t355 = T::from_f64(-32.78688524590164) * t353;
                let t356 = qdx_a * t218;
                let t357 = t316 + t356;
                let t358 = t318 + t356;
                let t359 = qdx_a * t294;
                let t360 = T::from_f64(4.0) * qy_b;
                let t361 = qdx_a.mul_neg_add(t360, t226 - t298);
                let t362 = qdz_a.mul_neg_add(t360, t241 + t359);
                let t363 = t95
                    .mul_neg_add(
                        t360,
                        qdy_b.mul_neg_add(t362, qdz_b.mul_add(t357, t322) - t266),
                    );
                let t364 = t55.mul_add(t362, t62 * t357);
                let t365 = t364 - t363;
                let t366 = T::from_f64(0.03048)
                    .mul_neg_add(
                        t365,
                        T::from_f64(0.00098)
                            .mul_add(
                                t364 + t363,
                                T::from_f64(0.12) * t218.mul_add(t99, t296),
                            ),
                    );
                let t367 = T::from_f64(0.12) * t365;
                let t368 = t30 * t366;
                let t369 = t39 * t366;
                let t370 = T::from_f64(0.12) * t244.mul_add(t361, t240 * t357);
                let t371 = t26
                    .mul_neg_add(
                        t367,
                        t218
                            .mul_neg_add(
                                t249,
                                t274.mul_add(t360, t58.mul_add(t370, t317)),
                            ),
                    );
                let t372 = t62.mul_add(t361, t67 * t362);
                let t373 = t95 * t218;
                let t374 = qdz_b.mul_neg_add(t361, qdx_b.mul_add(t362, t373) - t303);
                let t375 = t372 + t374;
                let t376 = T::from_f64(0.12)
                    .mul_neg_add(
                        t99.mul_neg_add(t360, t218.mul_sub(t101, t295)),
                        T::from_f64(2e-5)
                            .mul_neg_add(t372 - t374, T::from_f64(0.03048) * t375),
                    );
                let t377 = T::from_f64(0.12) * t375;
                let t378 = t39
                    .mul_neg_add(
                        t377,
                        t218
                            .mul_neg_add(
                                t274,
                                t36.mul_neg_add(t367, t53.mul_add(t370, t315)),
                            ),
                    );
                let t379 = t218 * t248;
                let t380 = T::from_f64(3.814367450731087) * t366;
                let t381 = T::from_f64(3.9344262295081966) * t376;
                let t382 = T::from_f64(0.5)
                    .mul_add(
                        t30.mul_neg_add(t377, t371) - t30.mul_neg_add(t381, t26 * t380),
                        t369,
                    );
                let t383 = t376 - t376;
                let t384 = t55.mul_add(t361, t67 * t357);
                let t385 = t95 * t294;
                let t386 = qdx_b
                    .mul_neg_add(t357, t93.mul_add(t360, qdy_b * t361) + t385 - t230);
                let t387 = T::from_f64(0.00098)
                    .mul_neg_add(t384 - t386, T::from_f64(2e-5) * (t384 + t386));
                let t388 = t387 - t387;
                let t389 = t53
                    .mul_neg_add(t388, t36.mul_neg_add(t383, t382 - t312 - t379 - t369));
                let t390 = t58
                    .mul_add(
                        t388,
                        t26.mul_add(t383, t48.mul_add(t389, t282 + t314 + t368)),
                    );
                let t391 = t248
                    .mul_neg_add(
                        t360,
                        T::from_f64(0.5)
                            .mul_add(t378 - t39.mul_neg_add(t381, t36 * t380), t390)
                            - t368,
                    );
                let t392 = t49 * t391;
                let t393 = -t392;
                let t394 = t44 * t46.mul_add(t392, t389);
                let t395 = t59 * t366;
                let t396 = t248 * t294;
                let t397 = t115
                    .mul_neg_add(
                        t360,
                        t37.mul_add(t388, t52.mul_add(t383, t277 + t395)) - t395 - t396,
                    );
                let t398 = T::from_f64(-6250.0) * t397;
                let t399 = T::from_f64(6250.0) * t397;
                let t400 = T::from_f64(-1000.0)
                    * T::from_f64(0.001)
                        .mul_add(
                            t37.mul_neg_add(t399, t58.mul_neg_add(t392, t53 * t394)),
                            t387,
                        );
                let t401 = T::from_f64(0.5) * t394;
                let t402 = T::from_f64(0.5) * t392;
                let t403 = T::from_f64(0.12)
                    .mul_neg_add(
                        t36.mul_add(t402, t26 * t401),
                        T::from_f64(0.03146)
                            .mul_add(
                                t59.mul_neg_add(t399, t30.mul_neg_add(t392, t39 * t394)),
                                t366,
                            ),
                    );
                let t404 = T::from_f64(0.12)
                    .mul_add(
                        t39.mul_add(t402, t30 * t401),
                        T::from_f64(0.0305)
                            .mul_add(
                                t52.mul_neg_add(t399, t26.mul_neg_add(t392, t36 * t394)),
                                t376,
                            ),
                    );
                let t405 = T::from_f64(-31.78639542275906) * t403;
                let t406 = T::from_f64(-32.78688524590164) * t404;
                let t407 = T::from_f64(4.0) * qz_b;
                let t408 = qdy_a.mul_neg_add(t407, t242 - t359);
                let t409 = t95
                    .mul_neg_add(
                        t407,
                        qdy_b.mul_neg_add(t358, qdz_b.mul_sub(t408, t251) - t334),
                    );
                let t410 = qdx_a.mul_neg_add(t407, t221 + t300);
                let t411 = qdz_b
                    .mul_neg_add(t410, t97.mul_add(t407, qdx_b * t358) - t229 - t385);
                let t412 = qdx_b.mul_neg_add(t408, qdy_b.mul_add(t410, t373) - t304);
                let t413 = t55.mul_add(t358, t62 * t408);
                let t414 = T::from_f64(0.00098)
                    .mul_add(
                        t413 + t409,
                        T::from_f64(0.12)
                            * t101.mul_neg_add(t407, t99.mul_neg_add(t294, t258)),
                    );
                let t415 = t413 - t409;
                let t416 = T::from_f64(0.03048).mul_neg_add(t415, t414);
                let t417 = T::from_f64(0.12) * t415;
                let t418 = t62.mul_add(t410, t67 * t358);
                let t419 = t30 * t416;
                let t420 = t39 * t416;
                let t421 = T::from_f64(0.12) * t244.mul_add(t410, t240 * t408);
                let t422 = t55.mul_add(t410, t67 * t408);
                let t423 = T::from_f64(0.00098)
                    .mul_neg_add(t422 - t412, T::from_f64(2e-5) * (t422 + t412));
                let t424 = t26
                    .mul_neg_add(
                        t417,
                        t274.mul_add(t407, t249.mul_add(t294, t58.mul_add(t421, t271))),
                    );
                let t425 = t274
                    .mul_neg_add(
                        t294,
                        t36
                            .mul_neg_add(
                                t417,
                                t249.mul_add(t407, t53.mul_add(t421, t239)),
                            ),
                    );
                let t426 = t418 + t411;
                let t427 = T::from_f64(0.12)
                    .mul_neg_add(
                        t99.mul_neg_add(t407, t101.mul_add(t294, t219)),
                        T::from_f64(2e-5)
                            .mul_neg_add(t418 - t411, T::from_f64(0.03048) * t426),
                    );
                let t428 = T::from_f64(0.12) * t426;
                let t429 = T::from_f64(3.814367450731087) * t416;
                let t430 = T::from_f64(3.9344262295081966) * t427;
                let t431 = T::from_f64(0.5)
                    .mul_add(
                        t30.mul_neg_add(t428, t424) - t30.mul_neg_add(t430, t26 * t429),
                        t273.mul_add(t407, t420),
                    );
                let t432 = t427 - t427;
                let t433 = t423 - t423;
                let t434 = t53
                    .mul_neg_add(t433, t36.mul_neg_add(t432, t431 - t236 - t396 - t420));
                let t435 = T::from_f64(0.5)
                    .mul_add(
                        t39.mul_neg_add(t428, t425) - t39.mul_neg_add(t430, t36 * t429),
                        t58
                            .mul_add(
                                t433,
                                t26.mul_add(t432, t48.mul_add(t434, t238 + t419)),
                            ),
                    );
                let t436 = t49 * t248.mul_neg_add(t407, t435 - t345 - t419);
                let t437 = -t436;
                let t438 = t44 * t46.mul_add(t436, t434);
                let t439 = t59 * t416;
                let t440 = t37.mul_add(t433, t52.mul_add(t432, t311 + t379 + t439))
                    - t439;
                let t441 = T::from_f64(-6250.0) * t440;
                let t442 = T::from_f64(6250.0) * t440;
                let t443 = T::from_f64(-1000.0)
                    * T::from_f64(0.001)
                        .mul_add(
                            t37.mul_neg_add(t442, t58.mul_neg_add(t436, t53 * t438)),
                            t423,
                        );
                let t444 = T::from_f64(0.5) * t438;
                let t445 = T::from_f64(0.5) * t436;
                let t446 = T::from_f64(0.12)
                    .mul_neg_add(
                        t36.mul_add(t445, t26 * t444),
                        T::from_f64(0.03146)
                            .mul_add(
                                t59.mul_neg_add(t442, t30.mul_neg_add(t436, t39 * t438)),
                                t416,
                            ),
                    );
                let t447 = T::from_f64(0.12)
                    .mul_add(
                        t39.mul_add(t445, t30 * t444),
                        T::from_f64(0.0305)
                            .mul_add(
                                t52.mul_neg_add(t442, t26.mul_neg_add(t436, t36 * t438)),
                                t427,
                            ),
                    );
                let t448 = T::from_f64(-31.78639542275906) * t446;
                let t449 = T::from_f64(-32.78688524590164) * t447;
                let t450 = t55.mul_add(t58, t26 * t62);
                let t451 = qdy_b.mul_neg_add(t58, t26 * qdz_b);
                let t452 = t450 - t451;
                let t453 = T::from_f64(0.03048)
                    .mul_neg_add(
                        t452,
                        T::from_f64(0.00098)
                            .mul_add(
                                t450 + t451,
                                T::from_f64(0.12) * t26.mul_neg_add(t118, qdx_a * t52),
                            ),
                    );
                let t454 = T::from_f64(0.12) * t452;
                let t455 = t30 * t453;
                let t456 = t30.mul_add(t62, t58 * t67);
                let t457 = t30.mul_neg_add(qdz_b, t58 * qdx_b);
                let t458 = t456 + t457;
                let t459 = T::from_f64(0.12)
                    .mul_neg_add(
                        t30.mul_neg_add(t118, qdx_a * t59),
                        T::from_f64(2e-5)
                            .mul_neg_add(t456 - t457, T::from_f64(0.03048) * t458),
                    );
                let t460 = T::from_f64(0.12) * t458;
                let t461 = t459 - t459;
                let t462 = t30.mul_add(t55, t26 * t67);
                let t463 = t26.mul_neg_add(qdx_b, t30 * qdy_b);
                let t464 = T::from_f64(0.00098)
                    .mul_neg_add(t462 - t463, T::from_f64(2e-5) * (t462 + t463));
                let t465 = t464 - t464;
                let t466 = T::from_f64(0.12) * t30.mul_add(t244, t26 * t240);
                let t467 = T::from_f64(3.814367450731087) * t453;
                let t468 = T::from_f64(3.9344262295081966) * t459;
                let t469 = t39.mul_neg_add(t460, t36.mul_neg_add(t454, t53 * t466))
                    - t39.mul_neg_add(t468, t36 * t467);
                let t470 = t30.mul_neg_add(t468, t26 * t467)
                    - t30.mul_neg_add(t460, t26.mul_neg_add(t454, t58 * t466));
                let t471 = t39 * t453;
                let t472 = T::from_f64(8e-5)
                    .mul_neg_add(qdz_a, T::from_f64(0.21666666666666667) * qdz_a);
                let t473 = T::from_f64(0.5)
                    .mul_add(t470, t53.mul_add(t465, t36.mul_add(t461, t471))) + t472
                    - t471;
                let t474 = t48
                    .mul_neg_add(
                        t473,
                        T::from_f64(0.5)
                            .mul_add(t469, t58.mul_add(t465, t26.mul_add(t461, t455)))
                            - t455,
                    );
                let t475 = t49 * t474;
                let t476 = -t475;
                let t477 = t44 * t46.mul_sub(t475, t473);
                let t478 = t59 * t453;
                let t479 = t37.mul_add(t465, t52.mul_add(t461, t478)) - t478;
                let t480 = T::from_f64(-6250.0) * t479;
                let t481 = T::from_f64(6250.0) * t479;
                let t482 = T::from_f64(-1000.0)
                    * T::from_f64(0.001)
                        .mul_add(
                            t37.mul_neg_add(t481, t58.mul_neg_add(t475, t53 * t477)),
                            t464,
                        );
                let t483 = T::from_f64(0.5) * t477;
                let t484 = T::from_f64(0.5) * t475;
                let t485 = T::from_f64(0.12)
                    .mul_neg_add(
                        t36.mul_add(t484, t26 * t483),
                        T::from_f64(0.03146)
                            .mul_add(
                                t59.mul_neg_add(t481, t30.mul_neg_add(t475, t39 * t477)),
                                t453,
                            ),
                    );
                let t486 = T::from_f64(0.12)
                    .mul_add(
                        t39.mul_add(t484, t30 * t483),
                        T::from_f64(0.0305)
                            .mul_add(
                                t52.mul_neg_add(t481, t26.mul_neg_add(t475, t36 * t477)),
                                t459,
                            ),
                    );
                let t487 = T::from_f64(-31.78639542275906) * t485;
                let t488 = T::from_f64(-32.78688524590164) * t486;
                let t489 = t55.mul_add(t53, t36 * t62);
                let t490 = qdy_b.mul_neg_add(t53, t36 * qdz_b);
                let t491 = t489 - t490;
                let t492 = T::from_f64(0.03048)
                    .mul_neg_add(
                        t491,
                        T::from_f64(0.00098)
                            .mul_add(
                                t489 + t490,
                                T::from_f64(0.12) * t36.mul_neg_add(t118, t52 * qdy_a),
                            ),
                    );
                let t493 = T::from_f64(0.12) * t491;
                let t494 = t30 * t492;
                let t495 = t39 * t492;
                let t496 = T::from_f64(0.12) * t39.mul_add(t244, t36 * t240);
                let t497 = T::from_f64(0.12) * t59.mul_add(t244, t52 * t240);
                let t498 = t39.mul_add(t62, t53 * t67);
                let t499 = t39.mul_neg_add(qdz_b, t53 * qdx_b);
                let t500 = t498 + t499;
                let t501 = T::from_f64(0.12)
                    .mul_neg_add(
                        t39.mul_neg_add(t118, qdy_a * t59),
                        T::from_f64(2e-5)
                            .mul_neg_add(t498 - t499, T::from_f64(0.03048) * t500),
                    );
                let t502 = T::from_f64(0.12) * t500;
                let t503 = T::from_f64(3.814367450731087) * t492;
                let t504 = T::from_f64(3.9344262295081966) * t501;
                let t505 = t30.mul_neg_add(t502, t26.mul_neg_add(t493, t58 * t496))
                    - t30.mul_neg_add(t504, t26 * t503);
                let t506 = t39.mul_neg_add(t502, t36.mul_neg_add(t493, t53 * t496))
                    - t39.mul_neg_add(t504, t36 * t503);
                let t507 = t501 - t501;
                let t508 = t39.mul_add(t55, t36 * t67);
                let t509 = t36.mul_neg_add(qdx_b, t39 * qdy_b);
                let t510 = T::from_f64(0.00098)
                    .mul_neg_add(t508 - t509, T::from_f64(2e-5) * (t508 + t509));
                let t511 = t510 - t510;
                (
                    t279,
                    t280,
                    t285,
                    t287,
                    t292,
                    t293,
                    t342,
                    t343,
                    t347,
                    t349,
                    t354,
                    t355,
                    t393,
                    t394,
                    t398,
                    t400,
                    t405,
                    t406,
                    t437,
                    t438,
                    t441,
                    t443,
                    t448,
                    t449,
                    t472,
                    t476,
                    t477,
                    t480,
                    t482,
                    t487,
                    t488,
                    t492,
                    t494,
                    t495,
                    t497,
                    t501,
                    t505,
                    t506,
                    t507,
                    t510,
                    t511,
                )
            };
            let (
                t515,
                t516,
                t519,
                t521,
                t526,
                t527,
                t552,
                t553,
                t556,
                t558,
                t563,
                t564,
                t586,
                t587,
                t588,
                t590,
                t593,
                t595,
                t609,
                t610,
                t611,
                t613,
                t618,
                t619,
                t627,
                t630,
                t631,
                t633,
                t638,
                t639,
            ) = {
                let t512 = t53
                    .mul_neg_add(
                        t511,
                        t36
                            .mul_neg_add(
                                t507,
                                T::from_f64(0.5).mul_add(t505, t495) - t495,
                            ),
                    );
                let t513 = T::from_f64(0.5)
                    .mul_add(
                        t506,
                        t58.mul_add(t511, t26.mul_add(t507, t48.mul_add(t512, t494))),
                    );
                let t514 = t49 * (t513 - t494 - t472);
                let t515 = -t514;
                let t516 = t44 * t46.mul_add(t514, t512);
                let t517 = t59 * t492;
                let t518 = t37.mul_add(t511, t52.mul_add(t507, t517)) - t517;
                let t519 = T::from_f64(-6250.0) * t518;
                let t520 = T::from_f64(6250.0) * t518;
                let t521 = T::from_f64(-1000.0)
                    * T::from_f64(0.001)
                        .mul_add(
                            t37.mul_neg_add(t520, t58.mul_neg_add(t514, t53 * t516)),
                            t510,
                        );
                let t522 = T::from_f64(0.5) * t516;
                let t523 = T::from_f64(0.5) * t514;
                let t524 = T::from_f64(0.12)
                    .mul_neg_add(
                        t36.mul_add(t523, t26 * t522),
                        T::from_f64(0.03146)
                            .mul_add(
                                t59.mul_neg_add(t520, t30.mul_neg_add(t514, t39 * t516)),
                                t492,
                            ),
                    );
                let t525 = T::from_f64(0.12)
                    .mul_add(
                        t39.mul_add(t523, t30 * t522),
                        T::from_f64(0.0305)
                            .mul_add(
                                t52.mul_neg_add(t520, t26.mul_neg_add(t514, t36 * t516)),
                                t501,
                            ),
                    );
                let t526 = T::from_f64(-31.78639542275906) * t524;
                let t527 = T::from_f64(-32.78688524590164) * t525;
                let t528 = t62.mul_add(t59, t37 * t67);
                let t529 = qdz_b.mul_neg_add(t59, t37 * qdx_b);
                let t530 = t528 + t529;
                let t531 = T::from_f64(2e-5)
                    .mul_neg_add(
                        t528 - t529,
                        T::from_f64(0.12)
                            .mul_add(
                                t39.mul_add(t117, t30 * t116),
                                T::from_f64(0.03048) * t530,
                            ),
                    );
                let t532 = T::from_f64(0.12) * t530;
                let t533 = t26 * t531;
                let t534 = t55.mul_add(t37, t52 * t62);
                let t535 = qdy_b.mul_neg_add(t37, t52 * qdz_b);
                let t536 = t534 - t535;
                let t537 = T::from_f64(0.12)
                    .mul_neg_add(
                        t36.mul_add(t117, t26 * t116),
                        T::from_f64(0.03048)
                            .mul_neg_add(t536, T::from_f64(0.00098) * (t534 + t535)),
                    );
                let t538 = T::from_f64(0.12) * t536;
                let t539 = t537 - t537;
                let t540 = t55.mul_add(t59, t52 * t67);
                let t541 = t52.mul_neg_add(qdx_b, qdy_b * t59);
                let t542 = T::from_f64(0.00098)
                    .mul_neg_add(t540 - t541, T::from_f64(2e-5) * (t540 + t541));
                let t543 = t542 - t542;
                let t544 = T::from_f64(3.9344262295081966) * t531;
                let t545 = T::from_f64(3.814367450731087) * t537;
                let t546 = t39.mul_neg_add(t532, t36.mul_neg_add(t538, t53 * t497))
                    + t36.mul_neg_add(t545, t39 * t544);
                let t547 = t30.mul_neg_add(t532, t26.mul_neg_add(t538, t58 * t497))
                    + t26.mul_neg_add(t545, t30 * t544);
                let t548 = T::from_f64(0.5)
                    .mul_add(
                        t546,
                        t58
                            .mul_add(
                                t543,
                                T::from_f64(-0.21658666666666668)
                                    .mul_add(qdy_a, t30.mul_add(t539, t533)),
                            ),
                    );
                let t549 = t36 * t531;
                let t550 = T::from_f64(0.5)
                    .mul_neg_add(
                        t547,
                        t53
                            .mul_add(
                                t543,
                                T::from_f64(0.21658666666666668)
                                    .mul_add(qdx_a, t39.mul_add(t539, t549)),
                            ) - t549,
                    );
                let t551 = t49 * t48.mul_neg_add(t550, t548 - t533);
                let t552 = -t551;
                let t553 = t44 * t46.mul_sub(t551, t550);
                let t554 = t52 * t531;
                let t555 = t59.mul_add(t539, t37.mul_add(t543, t554)) - t554;
                let t556 = T::from_f64(-6250.0) * t555;
                let t557 = T::from_f64(6250.0) * t555;
                let t558 = T::from_f64(-1000.0)
                    * T::from_f64(0.001)
                        .mul_add(
                            t37.mul_neg_add(t557, t58.mul_neg_add(t551, t53 * t553)),
                            t542,
                        );
                let t559 = T::from_f64(0.5) * t553;
                let t560 = T::from_f64(0.5) * t551;
                let t561 = T::from_f64(0.03146)
                    .mul_neg_add(
                        t59.mul_neg_add(t557, t30.mul_neg_add(t551, t39 * t553)),
                        T::from_f64(0.12).mul_sub(t36.mul_add(t560, t26 * t559), t537),
                    );
                let t562 = T::from_f64(0.12)
                    .mul_add(
                        t39.mul_add(t560, t30 * t559),
                        T::from_f64(0.0305)
                            .mul_add(
                                t52.mul_neg_add(t557, t26.mul_neg_add(t551, t36 * t553)),
                                t531,
                            ),
                    );
                let t563 = T::from_f64(31.78639542275906) * t561;
                let t564 = T::from_f64(-32.78688524590164) * t562;
                let t565 = T::from_f64(0.24) * t67;
                let t566 = t61 + t62;
                let t567 = t62 - t61;
                let t568 = T::from_f64(0.12) * t566;
                let t569 = T::from_f64(0.03048) * t566;
                let t570 = T::from_f64(2e-5).mul_neg_add(t567, t569);
                let t571 = T::from_f64(0.00098).mul_neg_add(t567, t569);
                let t572 = T::from_f64(3.9344262295081966) * t570;
                let t573 = t570 - t570;
                let t574 = t36
                    .mul_neg_add(
                        t573,
                        T::from_f64(0.5)
                            * t30.mul_add(t572, t30.mul_neg_add(t568, t58 * t565)),
                    );
                let t575 = t55 - t54;
                let t576 = T::from_f64(0.00098) * (t54 + t55);
                let t577 = T::from_f64(0.24) * t55;
                let t578 = T::from_f64(2e-5).mul_sub(t575, t576);
                let t579 = T::from_f64(0.03048).mul_neg_add(t575, t576);
                let t580 = T::from_f64(0.12) * t575;
                let t581 = t578 - t578;
                let t582 = t53.mul_neg_add(t581, t574);
                let t583 = T::from_f64(0.5)
                    .mul_add(
                        t39.mul_add(t572, t39.mul_neg_add(t568, t53 * t565)),
                        t58.mul_add(t581, t26.mul_add(t573, t48 * t582)),
                    );
                let t584 = t37.mul_add(t581, t52 * t573);
                let t585 = t49 * t583;
                let t586 = -t585;
                let t587 = t44 * t46.mul_add(t585, t582);
                let t588 = T::from_f64(-6250.0) * t584;
                let t589 = T::from_f64(6250.0) * t584;
                let t590 = T::from_f64(-1000.0)
                    * T::from_f64(0.001)
                        .mul_add(
                            t37.mul_neg_add(t589, t58.mul_neg_add(t585, t53 * t587)),
                            t578,
                        );
                let t591 = T::from_f64(0.5) * t587;
                let t592 = T::from_f64(0.5) * t585;
                let t593 = T::from_f64(3.814367450731087)
                    .mul_sub(
                        t36.mul_add(t592, t26 * t591),
                        t59.mul_neg_add(t589, t30.mul_neg_add(t585, t39 * t587)),
                    );
                let t594 = T::from_f64(0.12)
                    .mul_add(
                        t39.mul_add(t592, t30 * t591),
                        T::from_f64(0.0305)
                            .mul_add(
                                t52.mul_neg_add(t589, t26.mul_neg_add(t585, t36 * t587)),
                                t570,
                            ),
                    );
                let t595 = T::from_f64(-32.78688524590164) * t594;
                let t596 = T::from_f64(3.814367450731087) * t571;
                let t597 = t571 - t571;
                let t598 = t39
                    .mul_neg_add(
                        t597,
                        T::from_f64(0.5)
                            * t26.mul_add(t596, t26.mul_neg_add(t568, t58 * t577)),
                    );
                let t599 = T::from_f64(2e-5) * (t66 + t67);
                let t600 = t67 - t66;
                let t601 = T::from_f64(0.00098).mul_neg_add(t600, t599);
                let t602 = T::from_f64(0.03048).mul_neg_add(t600, t599);
                let t603 = T::from_f64(0.12) * t600;
                let t604 = t601 - t601;
                let t605 = t53.mul_neg_add(t604, t598);
                let t606 = T::from_f64(0.5)
                    .mul_add(
                        t36.mul_add(t596, t36.mul_neg_add(t568, t53 * t577)),
                        t58.mul_add(t604, t30.mul_add(t597, t48 * t605)),
                    );
                let t607 = t59.mul_add(t597, t37 * t604);
                let t608 = t49 * t606;
                let t609 = -t608;
                let t610 = t44 * t46.mul_add(t608, t605);
                let t611 = T::from_f64(-6250.0) * t607;
                let t612 = T::from_f64(6250.0) * t607;
                let t613 = T::from_f64(-1000.0)
                    * T::from_f64(0.001)
                        .mul_add(
                            t37.mul_neg_add(t612, t58.mul_neg_add(t608, t53 * t610)),
                            t601,
                        );
                let t614 = T::from_f64(0.5) * t610;
                let t615 = T::from_f64(0.5) * t608;
                let t616 = T::from_f64(0.03146)
                    .mul_neg_add(
                        t59.mul_neg_add(t612, t30.mul_neg_add(t608, t39 * t610)),
                        T::from_f64(0.12).mul_add(t36.mul_add(t615, t26 * t614), t571),
                    );
                let t617 = T::from_f64(3.9344262295081966)
                    .mul_add(
                        t39.mul_add(t615, t30 * t614),
                        t52.mul_neg_add(t612, t26.mul_neg_add(t608, t36 * t610)),
                    );
                let t618 = T::from_f64(31.78639542275906) * t616;
                let t619 = -t617;
                let t620 = t602 - t602;
                let t621 = t579 - t579;
                let t622 = T::from_f64(3.814367450731087) * t579;
                let t623 = T::from_f64(3.9344262295081966) * t602;
                let t624 = T::from_f64(0.5)
                    * (t30.mul_add(t603, t26 * t580) + t30.mul_add(t623, t26 * t622));
                let t625 = T::from_f64(0.5)
                    * (t39.mul_add(t603, t36 * t580) + t39.mul_add(t623, t36 * t622));
                let t626 = t39.mul_add(t621, t36 * t620) + t624;
                let t627 = t49
                    * t30
                        .mul_neg_add(
                            t621,
                            t26.mul_neg_add(t620, t48.mul_add(t626, t625)),
                        );
                let t628 = t44 * t46.mul_add(t627, t626);
                let t629 = t59.mul_add(t621, t52 * t620);
                let t630 = -t628;
                let t631 = T::from_f64(-6250.0) * t629;
                let t632 = T::from_f64(6250.0) * t629;
                let t633 = t58.mul_neg_add(t627, t53.mul_add(t628, t37 * t632));
                let t634 = T::from_f64(0.5) * t628;
                let t635 = T::from_f64(0.5) * t627;
                let t636 = T::from_f64(0.12)
                    .mul_add(
                        t36.mul_add(t635, t26 * t634),
                        T::from_f64(0.03146)
                            .mul_add(
                                t59.mul_neg_add(t632, t39.mul_neg_add(t628, t30 * t627)),
                                t579,
                            ),
                    );
                let t637 = T::from_f64(0.0305)
                    .mul_neg_add(
                        t52.mul_neg_add(t632, t36.mul_neg_add(t628, t26 * t627)),
                        T::from_f64(0.12).mul_add(t39.mul_add(t635, t30 * t634), t602),
                    );
                let t638 = T::from_f64(-31.78639542275906) * t636;
                let t639 = T::from_f64(32.78688524590164) * t637;
                (
                    t515,
                    t516,
                    t519,
                    t521,
                    t526,
                    t527,
                    t552,
                    t553,
                    t556,
                    t558,
                    t563,
                    t564,
                    t586,
                    t587,
                    t588,
                    t590,
                    t593,
                    t595,
                    t609,
                    t610,
                    t611,
                    t613,
                    t618,
                    t619,
                    t627,
                    t630,
                    t631,
                    t633,
                    t638,
                    t639,
                )
            };
            (
                ::pendulum_core::nalgebra::SVector::from([
                    t3,
                    t5,
                    t6,
                    t7,
                    t14,
                    t16,
                    t17,
                    t18,
                    t95,
                    t98,
                    t92,
                    t106,
                    t109,
                    t113,
                ]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [
                        T::from_f64(0.0),
                        t116,
                        t117,
                        t118,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t134,
                        t135,
                        T::from_f64(0.0),
                        t141,
                        t142,
                        t136,
                    ],
                    [
                        t143,
                        T::from_f64(0.0),
                        t144,
                        t117,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t161,
                        t162,
                        T::from_f64(0.0),
                        t168,
                        t169,
                        t163,
                    ],
                    [
                        t170,
                        t118,
                        T::from_f64(0.0),
                        t143,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t183,
                        t184,
                        T::from_f64(0.0),
                        t190,
                        t191,
                        t185,
                    ],
                    [
                        t144,
                        t170,
                        t116,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t203,
                        t204,
                        T::from_f64(0.0),
                        t210,
                        t211,
                        t205,
                    ],
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t212,
                        t214,
                        t216,
                        t279,
                        t280,
                        t285,
                        t292,
                        t293,
                        t287,
                    ],
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t213,
                        T::from_f64(0.0),
                        t217,
                        t214,
                        t342,
                        t343,
                        t347,
                        t354,
                        t355,
                        t349,
                    ],
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t215,
                        t216,
                        T::from_f64(0.0),
                        t213,
                        t393,
                        t394,
                        t398,
                        t405,
                        t406,
                        t400,
                    ],
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t217,
                        t215,
                        t212,
                        T::from_f64(0.0),
                        t437,
                        t438,
                        t441,
                        t448,
                        t449,
                        t443,
                    ],
                    [
                        t8,
                        t4,
                        t2,
                        t9,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t476,
                        t477,
                        t480,
                        t487,
                        t488,
                        t482,
                    ],
                    [
                        t9,
                        t10,
                        t4,
                        t0,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t515,
                        t516,
                        t519,
                        t526,
                        t527,
                        t521,
                    ],
                    [
                        t10,
                        t1,
                        t8,
                        t4,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t552,
                        t553,
                        t556,
                        t563,
                        t564,
                        t558,
                    ],
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t19,
                        t15,
                        t13,
                        t20,
                        t586,
                        t587,
                        t588,
                        t593,
                        t595,
                        t590,
                    ],
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t20,
                        t21,
                        t15,
                        t11,
                        t609,
                        t610,
                        t611,
                        t618,
                        t619,
                        t613,
                    ],
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t21,
                        t12,
                        t19,
                        t15,
                        t627,
                        t630,
                        t631,
                        t638,
                        t639,
                        t633,
                    ],
                ]),
            )
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Jacobian<T, 14>
    for BallPendulum<T> {
        #[inline]
        fn jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 14>,
        ) -> ::pendulum_core::nalgebra::SMatrix<T, 14, 14> {
            T::apart(
                ::pendulum_core::real::lanes::Second(__Code { t, x }),
                &mut (),
                self,
            )
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn rhs_and_jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 14>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 14>,
            ::pendulum_core::nalgebra::SMatrix<T, 14, 14>,
        ) {
            T::apart(__Code { t, x }, &mut (), self)
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn time_derivative(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 14>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 14> {
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
                T::from_f64(0.0),
            ])
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Energy<T, 14>
    for BallPendulum<T> {
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn kinetic(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 14>) -> T {
            let [_, _, _, _, qw_b, qx_b, qy_b, qz_b, qdx_a, qdy_a, qdz_a, qdx_b, qdy_b,
            qdz_b] = x.data.0[0];
            let t0 = qx_b * qx_b;
            let t1 = qy_b * qy_b;
            let t2 = T::from_f64(2.0).mul_neg_add(t0 + t1, T::from_f64(1.0));
            let t3 = qx_b * qz_b;
            let t4 = qy_b * qw_b;
            let t5 = T::from_f64(2.0) * (t3 + t4);
            let t6 = T::from_f64(2.0) * (t3 - t4);
            let t7 = qy_b * qz_b;
            let t8 = qx_b * qw_b;
            let t9 = T::from_f64(2.0) * (t7 - t8);
            let t10 = T::from_f64(2.0) * (t7 + t8);
            let t11 = T::from_f64(0.001)
                * qdy_a.mul_add(t9, qdx_a.mul_add(t5, qdz_a.mul_add(t2, qdz_b)));
            let t12 = qx_b * qy_b;
            let t13 = qz_b * qw_b;
            let t14 = T::from_f64(2.0) * (t12 - t13);
            let t15 = T::from_f64(2.0) * (t12 + t13);
            let t16 = qz_b * qz_b;
            let t17 = T::from_f64(2.0).mul_neg_add(t0 + t16, T::from_f64(1.0));
            let t18 = T::from_f64(2.0).mul_neg_add(t1 + t16, T::from_f64(1.0));
            let t19 = qdy_a.mul_add(t17, qdx_a.mul_add(t14, qdz_a.mul_add(t10, qdy_b)));
            let t20 = T::from_f64(0.5) * qdx_a;
            let t21 = T::from_f64(0.5) * qdy_a;
            let t22 = T::from_f64(0.12)
                .mul_neg_add(t18.mul_neg_add(t21, t15 * t20), T::from_f64(0.0305) * t19);
            let t23 = T::from_f64(0.12) * t19;
            let t24 = qdy_a.mul_add(t15, qdx_a.mul_add(t18, qdz_a.mul_add(t6, qdx_b)));
            let t25 = T::from_f64(0.03146)
                .mul_add(t24, T::from_f64(0.12) * t14.mul_neg_add(t21, t17 * t20));
            let t26 = qdz_a
                * t2
                    .mul_add(
                        t11,
                        t10.mul_add(t22, t6.mul_add(t25, T::from_f64(0.00016) * qdz_a)),
                    );
            let t27 = T::from_f64(0.12) * t24;
            let t28 = T::from_f64(0.5)
                .mul_add(
                    t15.mul_neg_add(t23, t17 * t27),
                    t5.mul_add(t11, t14.mul_add(t22, t18 * t25)),
                );
            let t29 = T::from_f64(0.5)
                .mul_neg_add(
                    t18.mul_neg_add(t23, t14 * t27),
                    T::from_f64(0.21674666666666667)
                        .mul_add(qdy_a, t9.mul_add(t11, t17.mul_add(t22, t15 * t25))),
                );
            let t30 = qdx_a
                .mul_add(
                    T::from_f64(0.21674666666666667).mul_add(qdx_a, t28),
                    qdx_b.mul_add(t25, qdy_b.mul_add(t22, qdz_b * t11)) + t26,
                );
            T::from_f64(0.5) * qdy_a.mul_add(t29, t30)
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn potential(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 14>) -> T {
            let [qw_a, qx_a, qy_a, qz_a, qw_b, qx_b, qy_b, qz_b, _, _, _, _, _, _] = x
                .data
                .0[0];
            let t0 = T::from_f64(2.0)
                .mul_neg_add(qy_a.mul_add(qy_a, qx_a * qx_a), T::from_f64(1.0))
                * (T::from_f64(-0.3)
                    - T::from_f64(0.24)
                        .mul_neg_add(qy_b.mul_add(qy_b, qx_b * qx_b), T::from_f64(0.12))
                    - T::from_f64(0.2));
            let t1 = qx_a
                .mul_add(qw_a, qy_a * qz_a)
                .mul_add(
                    qx_b.mul_neg_add(qw_b, qy_b * qz_b),
                    qy_a.mul_neg_add(qw_a, qx_a * qz_a) * qy_b.mul_add(qw_b, qx_b * qz_b),
                );
            T::from_f64(9.81) * T::from_f64(0.48).mul_neg_add(t1, t0)
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> BallPendulum<T> {
        ///The momenta of the coordinates: the mass matrix times their rates.
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        pub fn momentum(
            &self,
            t: T,
            x: &(impl ::pendulum_core::IntoState<T, 14> + Copy),
        ) -> ::pendulum_core::nalgebra::SVector<T, 6> {
            let x = ::pendulum_core::IntoState::into_state(*x);
            let [_, _, _, _, qw_b, qx_b, qy_b, qz_b, qdx_a, qdy_a, qdz_a, qdx_b, qdy_b,
            qdz_b] = x.data.0[0];
            let t0 = qy_b * qy_b;
            let t1 = qz_b * qz_b;
            let t2 = T::from_f64(2.0).mul_neg_add(t0 + t1, T::from_f64(1.0));
            let t3 = qx_b * qx_b;
            let t4 = T::from_f64(2.0).mul_neg_add(t1 + t3, T::from_f64(1.0));
            let t5 = T::from_f64(2.0).mul_neg_add(t0 + t3, T::from_f64(1.0));
            let t6 = T::from_f64(0.5) * qdx_a;
            let t7 = qy_b * qx_b;
            let t8 = qz_b * qw_b;
            let t9 = T::from_f64(2.0) * (t7 - t8);
            let t10 = T::from_f64(2.0) * (t7 + t8);
            let t11 = T::from_f64(0.5) * qdy_a;
            let t12 = qz_b * qx_b;
            let t13 = qy_b * qw_b;
            let t14 = T::from_f64(2.0) * (t12 - t13);
            let t15 = T::from_f64(2.0) * (t12 + t13);
            let t16 = qdy_a.mul_add(t10, qdx_a.mul_add(t2, qdz_a.mul_add(t14, qdx_b)));
            let t17 = T::from_f64(0.03146)
                .mul_add(t16, T::from_f64(0.12) * t9.mul_neg_add(t11, t4 * t6));
            let t18 = T::from_f64(0.12) * t16;
            let t19 = qy_b * qz_b;
            let t20 = qx_b * qw_b;
            let t21 = T::from_f64(2.0) * (t19 + t20);
            let t22 = T::from_f64(2.0) * (t19 - t20);
            let t23 = T::from_f64(0.001)
                * qdy_a.mul_add(t22, qdx_a.mul_add(t15, qdz_a.mul_add(t5, qdz_b)));
            let t24 = t4.mul_add(qdy_a, qdx_a.mul_add(t9, qdz_a.mul_add(t21, qdy_b)));
            let t25 = T::from_f64(0.12)
                .mul_neg_add(t2.mul_neg_add(t11, t6 * t10), T::from_f64(0.0305) * t24);
            let t26 = T::from_f64(0.12) * t24;
            let t27 = T::from_f64(0.5)
                .mul_add(
                    t10.mul_neg_add(t26, t4 * t18),
                    t15.mul_add(t23, t9.mul_add(t25, t2 * t17)),
                );
            ::pendulum_core::nalgebra::SVector::from([
                T::from_f64(0.21674666666666667).mul_add(qdx_a, t27),
                T::from_f64(0.5)
                    .mul_neg_add(
                        t2.mul_neg_add(t26, t9 * t18),
                        T::from_f64(0.21674666666666667)
                            .mul_add(qdy_a, t22.mul_add(t23, t4.mul_add(t25, t10 * t17))),
                    ),
                t5
                    .mul_add(
                        t23,
                        t21.mul_add(t25, t14.mul_add(t17, T::from_f64(0.00016) * qdz_a)),
                    ),
                t17,
                t25,
                t23,
            ])
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::shapes::Shapes<14> for BallPendulum {
        fn shapes(
            &self,
            t: f64,
            x: &::pendulum_core::nalgebra::SVector<f64, 14>,
        ) -> ::pendulum_core::shapes::Vec<::pendulum_core::shapes::Shape<'_>> {
            trait Values<T> {
                fn values(
                    &self,
                    t: T,
                    x: &::pendulum_core::nalgebra::SVector<T, 14>,
                ) -> [T; 40];
            }
            #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
            impl<T: ::pendulum_core::real::Real> Values<T> for BallPendulum<T> {
                fn values(
                    &self,
                    t: T,
                    x: &::pendulum_core::nalgebra::SVector<T, 14>,
                ) -> [T; 40] {
                    {
                        let [qw_a, qx_a, qy_a, qz_a, qw_b, qx_b, qy_b, qz_b, _, _, _, _,
                        _, _] = x.data.0[0];
                        let t0 = qx_a * qz_a;
                        let t1 = qy_a * qw_a;
                        let t2 = t0 + t1;
                        let t3 = T::from_f64(2.0) * (t0 - t1);
                        let t4 = -t2;
                        let t5 = T::from_f64(2.0) * t2;
                        let t6 = qx_a * qw_a;
                        let t7 = qz_a * qy_a;
                        let t8 = t6 - t7;
                        let t9 = T::from_f64(2.0) * (t6 + t7);
                        let t10 = T::from_f64(2.0) * t8;
                        let t11 = qx_a * qx_a;
                        let t12 = qy_a * qy_a;
                        let t13 = T::from_f64(2.0)
                            .mul_neg_add(t11 + t12, T::from_f64(1.0));
                        let t14 = T::from_f64(-0.5) * t13;
                        let t15 = qx_b * qz_b;
                        let t16 = qy_b * qw_b;
                        let t17 = T::from_f64(0.02) * (t15 - t16);
                        let t18 = t15 + t16;
                        let t19 = qz_b * qy_b;
                        let t20 = qx_b * qw_b;
                        let t21 = T::from_f64(0.14) * (t19 + t20);
                        let t22 = t19 - t20;
                        let t23 = t17 + t21;
                        let t24 = t17 - t21;
                        let t25 = qx_b * qx_b;
                        let t26 = qy_b * qy_b;
                        let t27 = T::from_f64(2.0)
                            .mul_neg_add(t25 + t26, T::from_f64(1.0));
                        let t28 = T::from_f64(0.02).mul_add(t27, T::from_f64(0.5));
                        let t29 = T::from_f64(0.38).mul_add(t27, T::from_f64(0.5));
                        let t30 = t23 - t28;
                        let t31 = qz_a * qz_a;
                        let t32 = T::from_f64(2.0)
                            .mul_neg_add(t12 + t31, T::from_f64(1.0));
                        let t33 = T::from_f64(2.0)
                            .mul_neg_add(t11 + t31, T::from_f64(1.0));
                        let t34 = qz_b * qz_b;
                        let t35 = T::from_f64(0.02)
                            .mul_neg_add(t26 + t34, T::from_f64(0.01));
                        let t36 = T::from_f64(0.14)
                            .mul_neg_add(t25 + t34, T::from_f64(0.07));
                        let t37 = qx_b * qy_b;
                        let t38 = qz_b * qw_b;
                        let t39 = T::from_f64(0.14) * (t37 - t38);
                        let t40 = T::from_f64(0.02) * (t37 + t38);
                        let t41 = t35 + t39;
                        let t42 = t35 - t39;
                        let t43 = T::from_f64(0.04) * t18;
                        let t44 = T::from_f64(0.76) * t18;
                        let t45 = t41 - t43;
                        let t46 = qx_a * qy_a;
                        let t47 = qz_a * qw_a;
                        let t48 = T::from_f64(2.0) * (t46 - t47);
                        let t49 = T::from_f64(2.0) * (t46 + t47);
                        let t50 = t40 + t36;
                        let t51 = t40 - t36;
                        let t52 = T::from_f64(0.04) * t22;
                        let t53 = T::from_f64(0.76) * t22;
                        let t54 = -t48.mul_add(t53, t32.mul_add(t44, t5 * t29));
                        let t55 = t33.mul_neg_add(t53, t49.mul_neg_add(t44, t10 * t29));
                        let t56 = -t9.mul_add(t53, t3.mul_add(t44, t13 * t29));
                        let t57 = t50 - t52;
                        let t58 = t48.mul_add(t57, t32.mul_add(t45, t5 * t30));
                        let t59 = t30.mul_neg_add(t10, t57.mul_add(t33, t45 * t49));
                        let t60 = t57.mul_add(t9, t45.mul_add(t3, t13 * t30));
                        let t61 = t24 + t28;
                        let t62 = t43 + t42;
                        let t63 = t52 + t51;
                        let t64 = -t48.mul_add(t63, t32.mul_add(t62, t5 * t61));
                        let t65 = t33.mul_neg_add(t63, t49.mul_neg_add(t62, t10 * t61));
                        let t66 = -t9.mul_add(t63, t3.mul_add(t62, t13 * t61));
                        let t67 = t24 - t28;
                        let t68 = t23 + t28;
                        let t69 = t42 - t43;
                        let t70 = t41 + t43;
                        let t71 = t51 - t52;
                        let t72 = t48.mul_add(t71, t32.mul_add(t69, t5 * t67));
                        let t73 = t10.mul_neg_add(t67, t33.mul_add(t71, t49 * t69));
                        let t74 = t9.mul_add(t71, t3.mul_add(t69, t13 * t67));
                        let t75 = t50 + t52;
                        let t76 = -t48.mul_add(t75, t32.mul_add(t70, t5 * t68));
                        let t77 = t33.mul_neg_add(t75, t49.mul_neg_add(t70, t10 * t68));
                        let t78 = -t9.mul_add(t75, t3.mul_add(t70, t13 * t68));
                        let t79 = t23 - t29;
                        let t80 = t23 + t29;
                        let t81 = t41 - t44;
                        let t82 = t41 + t44;
                        let t83 = t50 - t53;
                        let t84 = t48.mul_add(t83, t32.mul_add(t81, t5 * t79));
                        let t85 = t10.mul_neg_add(t79, t33.mul_add(t83, t49 * t81));
                        let t86 = t9.mul_add(t83, t3.mul_add(t81, t13 * t79));
                        let t87 = t50 + t53;
                        let t88 = -t48.mul_add(t87, t32.mul_add(t82, t5 * t80));
                        let t89 = t33.mul_neg_add(t87, t49.mul_neg_add(t82, t10 * t80));
                        let t90 = -t9.mul_add(t87, t3.mul_add(t82, t13 * t80));
                        let t91 = t24 + t29;
                        let t92 = t24 - t29;
                        let t93 = t42 + t44;
                        let t94 = t42 - t44;
                        let t95 = t51 + t53;
                        let t96 = t51 - t53;
                        let t97 = -t48.mul_add(t95, t32.mul_add(t93, t5 * t91));
                        let t98 = t48.mul_add(t96, t32.mul_add(t94, t5 * t92));
                        let t99 = t33.mul_neg_add(t95, t49.mul_neg_add(t93, t10 * t91));
                        let t100 = -t9.mul_add(t95, t3.mul_add(t93, t13 * t91));
                        let t101 = t10.mul_neg_add(t92, t33.mul_add(t96, t49 * t94));
                        let t102 = t9.mul_add(t96, t3.mul_add(t94, t13 * t92));
                        [
                            T::from_f64(0.0),
                            T::from_f64(0.0),
                            T::from_f64(0.0),
                            t4,
                            t8,
                            t14,
                            T::from_f64(0.02),
                            t58,
                            t59,
                            t60,
                            t64,
                            t65,
                            t66,
                            t72,
                            t73,
                            t74,
                            t76,
                            t77,
                            t78,
                            t84,
                            t85,
                            t86,
                            t97,
                            t99,
                            t100,
                            t98,
                            t101,
                            t102,
                            t88,
                            t89,
                            t90,
                            T::from_f64(0.0),
                            T::from_f64(0.0),
                            T::from_f64(0.0),
                            t4,
                            t8,
                            t14,
                            t54,
                            t55,
                            t56,
                        ]
                    }
                }
            }
            ::pendulum_core::shapes::placed(
                &[
                    ::pendulum_core::shapes::Outline {
                        name: "rod",
                        body: "rod",
                        kind: ::pendulum_core::shapes::ShapeKind::Cylinder,
                        points: 2,
                        radius: true,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "board",
                        body: "board",
                        kind: ::pendulum_core::shapes::ShapeKind::Cuboid,
                        points: 8,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "rod",
                        body: "rod",
                        kind: ::pendulum_core::shapes::ShapeKind::Support,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "board",
                        body: "board",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "tip",
                        body: "board",
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
    impl ::pendulum_core::Parametric<14, 0> for BallPendulum {
        fn parameters(&self) -> [f64; 0] {
            self.params.to_array()
        }
        fn parameter_names(&self) -> [&str; 0] {
            BallPendulumParams::NAMES
        }
        fn check_parameters(
            &self,
            parameters: &[f64; 0],
        ) -> ::core::result::Result<(), ::pendulum_core::ParameterError> {
            Self::new(BallPendulumParams::from_array(*parameters)).map(|_| ())
        }
        fn with_parameters<T: ::pendulum_core::real::Real>(
            &self,
            parameters: [T; 0],
        ) -> BallPendulum<T> {
            BallPendulum {
                params: self.params,
                constants: constants(parameters),
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::CastJacobian<14> for BallPendulum {
        #[inline]
        fn with_jacobian<T: ::pendulum_core::real::Real>(
            model: &BallPendulum<T>,
        ) -> &impl ::pendulum_core::Jacobian<T, 14> {
            model
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::Cast<14> for BallPendulum {
        type In<T: ::pendulum_core::real::Real> = BallPendulum<T>;
        fn cast<T: ::pendulum_core::real::Real>(&self) -> BallPendulum<T> {
            BallPendulum::cast(self)
        }
        #[inline]
        fn gather<'m, T: ::pendulum_core::real::lanes::Lanes>(
            models: impl ::core::ops::Fn(usize) -> &'m Self,
        ) -> BallPendulum<T>
        where
            Self: 'm,
        {
            let scalar = <<T as ::pendulum_core::real::lanes::Lanes>::Scalar as ::pendulum_core::real::Real>::from_f64;
            BallPendulum {
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
pub use __BallPendulum::{BallPendulum, BallPendulumParams};
