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
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl BallPendulum {
        /// Builds the model: checks the parameters, and computes once whatever depends on them alone.
        ///
        /// # Errors
        ///
        /// The first parameter, or combination of parameters, that is not finite or that no rigid body can have.
        pub fn new(
            params: BallPendulumParams,
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
        /// The same model in another number type, such as `f32`. Its constants are computed in double precision and
        /// then rounded.
        pub fn cast<T: ::pendulum_core::real::Real>(&self) -> BallPendulum<T> {
            BallPendulum {
                params: self.params,
                constants: self.constants.map(T::from_f64),
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> BallPendulum<T> {
        /// The parameters that the model was built from.
        pub fn params(&self) -> &BallPendulumParams {
            &self.params
        }
        /// The model with other parameters, in the same number type. Its constants are computed anew.
        ///
        /// # Errors
        ///
        /// Those of `new`.
        pub fn with_params(
            &self,
            params: BallPendulumParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            Ok(<BallPendulum>::new(params)?.cast())
        }
    }
    impl BallPendulum {
        ///The first place of `a` in the state, whose components stand in 1.
        pub const A: usize = 0;
        ///The first place of `dot(a)` in the state, whose components stand in rad/s.
        pub const DOT_A: usize = 8;
        ///The first place of `b` in the state, whose components stand in 1.
        pub const B: usize = 4;
        ///The first place of `dot(b)` in the state, whose components stand in rad/s.
        pub const DOT_B: usize = 11;
        /// The number of degrees of freedom, and of rates; a quaternion has one component more.
        pub const DOF: usize = 6;
        /// The names of the coordinates, in the order in which their rates stand in the state; of an orientation the axes of its angular velocity.
        pub const COORDINATES: [&'static str; 6] = [
            "a.x",
            "a.y",
            "a.z",
            "b.x",
            "b.y",
            "b.z",
        ];
        /// Counted operations of each generated function, in the form that it has and in others.
        pub const COST: ::pendulum_core::Cost = ::pendulum_core::Cost::new(
            &[
                (
                    "rhs",
                    ::pendulum_core::FunctionCost::new(
                        "recursion, L^T D L",
                        ::pendulum_core::Operations::new(159, 209, 3, 0, 0, 49),
                    ),
                ),
                (
                    "jacobian",
                    ::pendulum_core::FunctionCost::new(
                        "recursion, L^T D L, derived in the graph",
                        ::pendulum_core::Operations::new(1065, 1249, 3, 0, 0, 81),
                    ),
                ),
                (
                    "kinetic",
                    ::pendulum_core::FunctionCost::new(
                        "recursion",
                        ::pendulum_core::Operations::new(43, 65, 0, 0, 0, 19),
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
                        ::pendulum_core::Operations::new(38, 58, 0, 0, 0, 15),
                    ),
                ),
            ],
        );
        /// What each part of the state is.
        pub const LAYOUT: ::pendulum_core::StateLayout = ::pendulum_core::StateLayout::new(
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
        /// The equations of motion as text.
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
            let t0 = T::from_f64(0.5) * qx_a;
            let t1 = T::from_f64(0.5) * qy_a;
            let t2 = T::from_f64(0.5) * qz_a;
            let t3 = -(qdx_a * t0 + qdy_a * t1 + qdz_a * t2);
            let t4 = T::from_f64(0.5) * qw_a;
            let t5 = qdx_a * t4 - qdy_a * t2 + qdz_a * t1;
            let t6 = qdx_a * t2 + qdy_a * t4 - qdz_a * t0;
            let t7 = qdy_a * t0 - qdx_a * t1 + qdz_a * t4;
            let t8 = T::from_f64(0.5) * qx_b;
            let t9 = T::from_f64(0.5) * qy_b;
            let t10 = T::from_f64(0.5) * qz_b;
            let t11 = -(qdx_b * t8 + qdy_b * t9 + qdz_b * t10);
            let t12 = T::from_f64(0.5) * qw_b;
            let t13 = qdx_b * t12 - qdy_b * t10 + qdz_b * t9;
            let t14 = qdx_b * t10 + qdy_b * t12 - qdz_b * t8;
            let t15 = qdy_b * t8 - qdx_b * t9 + qdz_b * t12;
            let t16 = qy_b * qy_b;
            let t17 = qz_b * qz_b;
            let t18 = T::from_f64(1.0) - T::from_f64(2.0) * (t16 + t17);
            let t19 = T::from_f64(2e-5) * t18;
            let t20 = qy_b * qx_b;
            let t21 = qz_b * qw_b;
            let t22 = t20 - t21;
            let t23 = t20 + t21;
            let t24 = T::from_f64(2.0) * t22;
            let t25 = T::from_f64(0.00196) * t22;
            let t26 = qz_b * qx_b;
            let t27 = qy_b * qw_b;
            let t28 = t26 + t27;
            let t29 = t26 - t27;
            let t30 = T::from_f64(2.0) * t28;
            let t31 = T::from_f64(0.06096) * t28;
            let t32 = T::from_f64(8e-5) + t18 * t19 + t24 * t25 + t30 * t31;
            let t33 = T::from_f64(0.002) * t28;
            let t34 = qx_b * qx_b;
            let t35 = T::from_f64(1.0) - T::from_f64(2.0) * (t16 + t34);
            let t36 = T::from_f64(1.0) - T::from_f64(2.0) * (t17 + t34);
            let t37 = T::from_f64(2.0) * t29;
            let t38 = t29 * t37;
            let t39 = T::from_f64(0.03146) * t18 + T::from_f64(0.06) * t36;
            let t40 = t33 * t35 + T::from_f64(0.12) * t28 + t31 * t35
                + t37 * (t19 + t39);
            let t41 = qy_b * qz_b;
            let t42 = qx_b * qw_b;
            let t43 = t41 + t42;
            let t44 = t41 - t42;
            let t45 = T::from_f64(2.0) * t43;
            let t46 = t43 * t45;
            let t47 = T::from_f64(0.061) * t22 - T::from_f64(0.12) * t23;
            let t48 = t40 + t45 * (t25 + t47);
            let t49 = T::from_f64(0.06292) * t23 - T::from_f64(0.12) * t22;
            let t50 = T::from_f64(2.0) * t23;
            let t51 = T::from_f64(4e-5) * t23;
            let t52 = T::from_f64(0.00098) * t36;
            let t53 = T::from_f64(2.0) * t44;
            let t54 = T::from_f64(0.06096) * t44;
            let t55 = T::from_f64(8e-5) + t50 * t51 + t36 * t52 + t53 * t54;
            let t56 = t32 + t55 - T::from_f64(0.001) * t35 * t35
                - T::from_f64(0.061) * t46 - T::from_f64(0.06292) * t38;
            let t57 = T::from_f64(0.21666666666666667) + T::from_f64(4e-5) * t38
                + T::from_f64(0.00196) * t46
                + t35 * (T::from_f64(0.12) + T::from_f64(0.03048) * t35);
            let t58 = T::from_f64(-1.0) / t56;
            let t59 = t48 * t58;
            let t60 = T::from_f64(0.002) * t44;
            let t61 = t35 * t60 + T::from_f64(0.12) * t44 + t54 * t35
                + t37 * (t51 + t49);
            let t62 = T::from_f64(0.0305) * t36 + T::from_f64(0.06) * t18;
            let t63 = t61 + t45 * (t52 + t62);
            let t64 = t58 * t63;
            let t65 = T::from_f64(32.78688524590164) * t62;
            let t66 = T::from_f64(31.78639542275906) * t49;
            let t67 = t48 * t64 - t19 * t50 - t25 * t36 - t47 * t65 - t39 * t66;
            let t68 = t67 - t53 * (t31 + t33);
            let t69 = t32 - t55;
            let t70 = t55 + t69;
            let t71 = t70 + t57;
            let t72 = t63 * t64 + t71 - t53 * t60 - t62 * t65 - t49 * t66;
            let t73 = T::from_f64(-1.0) / t72;
            let t74 = t68 * t73;
            let t75 = t32 + t48 * t59 + t68 * t74 + t71 - t69 - t70 - t30 * t33;
            let t76 = T::from_f64(32.78688524590164) * t47;
            let t77 = T::from_f64(31.78639542275906) * t39;
            let t78 = qy_a * qz_a + qx_a * qw_a;
            let t79 = t37 * qdz_a + t18 * qdx_a + t50 * qdy_a;
            let t80 = t45 * qdz_a + t24 * qdx_a + t36 * qdy_a;
            let t81 = qdy_b * t79 - t80 * qdx_b;
            let t82 = t80 + qdy_b;
            let t83 = qdx_b + t79;
            let t84 = t82 * t83;
            let t85 = T::from_f64(2e-5) * (t81 + t84)
                - T::from_f64(0.00098) * (t84 - t81);
            let t86 = t30 * t85;
            let t87 = T::from_f64(0.12) * (t82 * t82 + t83 * t83);
            let t88 = t35 * qdz_a + t30 * qdx_a + t53 * qdy_a;
            let t89 = qdz_b * t80 - qdy_b * t88;
            let t90 = t88 * qdx_b - qdz_b * t79;
            let t91 = qdz_b + t88;
            let t92 = t82 * t91;
            let t93 = t91 * t83;
            let t94 = t92 - t89;
            let t95 = T::from_f64(0.12) * t94;
            let t96 = t90 + t93;
            let t97 = T::from_f64(0.12) * t96;
            let t98 = T::from_f64(9.81) * t78 + t86
                + T::from_f64(0.5) * (t53 * t87 - t36 * t95 - t50 * t97);
            let t99 = t53 * t85;
            let t100 = qdz_a * qdx_a;
            let t101 = T::from_f64(9.81)
                - T::from_f64(19.62) * (qx_a * qx_a + qy_a * qy_a)
                + T::from_f64(0.5) * (qdy_a * qdy_a + qdx_a * qdx_a);
            let t102 = qz_a * qx_a - qy_a * qw_a;
            let t103 = T::from_f64(19.62) * t102 - T::from_f64(0.5) * t100;
            let t104 = qdy_a * qdz_a;
            let t105 = T::from_f64(19.62) * t78 - T::from_f64(0.5) * t104;
            let t106 = T::from_f64(0.03048) * t96 - T::from_f64(2e-5) * (t93 - t90)
                - T::from_f64(0.12) * (t37 * t101 + t18 * t103 + t50 * t105);
            let t107 = T::from_f64(0.12) * (t45 * t101 + t24 * t103 + t36 * t105)
                + T::from_f64(0.00098) * (t89 + t92);
            let t108 = t107 - T::from_f64(0.03048) * t94;
            let t109 = t99 + T::from_f64(0.21658666666666668) * t100 + t108 * (t50 - t66)
                + t106 * (t36 - t65);
            let t110 = t109 - T::from_f64(9.81) * t102 - t99
                - T::from_f64(0.5) * (t30 * t87 - t24 * t95 - t18 * t97);
            let t111 = t37 * t108 + t45 * t106;
            let t112 = t85 * (t35 - t35) + t111 - t111;
            let t113 = t110 - t64 * t112;
            let t114 = t98 + t74 * t113 + T::from_f64(-0.21658666666666668) * t104
                + t108 * (t18 - t77) + t106 * (t24 - t76);
            let t115 = T::from_f64(-1.0) / (t75 - t47 * t76 - t39 * t77)
                * (t114 - t86 - t59 * t112);
            let t116 = t73 * t113 + t74 * t115;
            let t117 = t58 * t112 - t59 * t115 - t64 * t116;
            let t118 = -(T::from_f64(31.78639542275906) * t108 + t77 * t115 + t66 * t116
                + t37 * t117);
            let t119 = -(T::from_f64(32.78688524590164) * t106 + t76 * t115 + t65 * t116
                + t45 * t117);
            let t120 = -(t35 * t117 + T::from_f64(1000.0) * t85 + t30 * t115
                + t53 * t116);
            ::pendulum_core::nalgebra::SVector::from([
                t3,
                t5,
                t6,
                t7,
                t11,
                t13,
                t14,
                t15,
                t115,
                t116,
                t117,
                t118,
                t119,
                t120,
            ])
        }
        #[inline]
        fn layout(
            &self,
        ) -> ::core::option::Option<&'static ::pendulum_core::StateLayout> {
            Some(&<BallPendulum>::LAYOUT)
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
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Jacobian<T, 14>
    for BallPendulum<T> {
        #[inline]
        fn jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 14>,
        ) -> ::pendulum_core::nalgebra::SMatrix<T, 14, 14> {
            self.rhs_and_jacobian(t, x).1
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
                t24,
                t25,
                t30,
                t31,
                t36,
                t37,
                t41,
                t42,
                t43,
                t50,
                t54,
                t55,
                t56,
                t57,
                t58,
                t61,
                t62,
                t63,
                t64,
                t69,
                t70,
                t71,
                t76,
                t79,
                t80,
                t82,
                t83,
                t84,
                t86,
                t87,
                t89,
                t90,
                t92,
                t94,
                t95,
                t96,
                t100,
                t104,
                t108,
                t110,
                t112,
                t113,
                t115,
                t116,
                t117,
                t120,
                t124,
                t125,
                t127,
                t128,
                t129,
                t130,
                t131,
                t132,
                t133,
                t134,
                t135,
                t136,
                t137,
                t138,
                t151,
                t152,
                t153,
                t154,
                t155,
                t156,
                t157,
                t158,
                t172,
                t173,
                t174,
                t175,
                t176,
                t177,
                t178,
                t188,
                t189,
                t190,
                t191,
                t192,
                t193,
                t202,
                t203,
                t204,
                t205,
                t206,
                t207,
                t208,
                t209,
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
                t227,
                t228,
                t229,
                t230,
                t231,
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
                t246,
                t247,
                t248,
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
                let t3 = -(qdx_a * t0 + qdy_a * t1 + qdz_a * t2);
                let t4 = T::from_f64(0.5) * qw_a;
                let t5 = qdx_a * t4 - qdy_a * t2 + qdz_a * t1;
                let t6 = qdx_a * t2 + qdy_a * t4 - qdz_a * t0;
                let t7 = qdy_a * t0 - qdx_a * t1 + qdz_a * t4;
                let t8 = -t0;
                let t9 = -t1;
                let t10 = -t2;
                let t11 = T::from_f64(0.5) * qx_b;
                let t12 = T::from_f64(0.5) * qy_b;
                let t13 = T::from_f64(0.5) * qz_b;
                let t14 = -(qdx_b * t11 + qdy_b * t12 + qdz_b * t13);
                let t15 = T::from_f64(0.5) * qw_b;
                let t16 = qdx_b * t15 - qdy_b * t13 + qdz_b * t12;
                let t17 = qdx_b * t13 + qdy_b * t15 - qdz_b * t11;
                let t18 = qdy_b * t11 - qdx_b * t12 + qdz_b * t15;
                let t19 = -t11;
                let t20 = -t12;
                let t21 = -t13;
                let t22 = qy_b * qy_b;
                let t23 = qz_b * qz_b;
                let t24 = T::from_f64(1.0) - T::from_f64(2.0) * (t22 + t23);
                let t25 = T::from_f64(2e-5) * t24;
                let t26 = qy_b * qx_b;
                let t27 = qz_b * qw_b;
                let t28 = t26 - t27;
                let t29 = t26 + t27;
                let t30 = T::from_f64(2.0) * t28;
                let t31 = T::from_f64(0.00196) * t28;
                let t32 = qz_b * qx_b;
                let t33 = qy_b * qw_b;
                let t34 = t32 + t33;
                let t35 = t32 - t33;
                let t36 = T::from_f64(2.0) * t34;
                let t37 = T::from_f64(0.06096) * t34;
                let t38 = T::from_f64(8e-5) + t24 * t25 + t30 * t31 + t36 * t37;
                let t39 = T::from_f64(0.002) * t34;
                let t40 = qx_b * qx_b;
                let t41 = T::from_f64(1.0) - T::from_f64(2.0) * (t22 + t40);
                let t42 = T::from_f64(1.0) - T::from_f64(2.0) * (t23 + t40);
                let t43 = T::from_f64(2.0) * t35;
                let t44 = T::from_f64(0.03146) * t24 + T::from_f64(0.06) * t42;
                let t45 = t39 * t41 + T::from_f64(0.12) * t34 + t37 * t41
                    + t43 * (t25 + t44);
                let t46 = qy_b * qz_b;
                let t47 = qx_b * qw_b;
                let t48 = t46 + t47;
                let t49 = t46 - t47;
                let t50 = T::from_f64(2.0) * t48;
                let t51 = T::from_f64(0.061) * t28 - T::from_f64(0.12) * t29;
                let t52 = t45 + t50 * (t31 + t51);
                let t53 = T::from_f64(0.06292) * t29 - T::from_f64(0.12) * t28;
                let t54 = T::from_f64(2.0) * t29;
                let t55 = T::from_f64(4e-5) * t29;
                let t56 = T::from_f64(0.00098) * t42;
                let t57 = T::from_f64(2.0) * t49;
                let t58 = T::from_f64(0.06096) * t49;
                let t59 = T::from_f64(8e-5) + t54 * t55 + t42 * t56 + t57 * t58;
                let t60 = t38 + t59 - T::from_f64(0.001) * t41 * t41
                    - T::from_f64(0.061) * t48 * t50 - T::from_f64(0.06292) * t35 * t43;
                let t61 = T::from_f64(-1.0) / t60;
                let t62 = T::from_f64(4e-5) * t35;
                let t63 = T::from_f64(0.00196) * t48;
                let t64 = t52 * t61;
                let t65 = T::from_f64(0.002) * t49;
                let t66 = t41 * t65 + T::from_f64(0.12) * t49 + t58 * t41
                    + t43 * (t55 + t53);
                let t67 = T::from_f64(0.0305) * t42 + T::from_f64(0.06) * t24;
                let t68 = t66 + t50 * (t56 + t67);
                let t69 = t61 * t68;
                let t70 = T::from_f64(32.78688524590164) * t67;
                let t71 = T::from_f64(31.78639542275906) * t53;
                let t72 = t52 * t69 - t25 * t54 - t31 * t42 - t51 * t70 - t44 * t71;
                let t73 = t72 - t57 * (t37 + t39);
                let t74 = t38 - t59;
                let t75 = t59 + t74;
                let t76 = T::from_f64(0.03048) * t41;
                let t77 = t75
                    + (T::from_f64(0.21666666666666667) + t43 * t62 + t50 * t63
                        + t41 * (T::from_f64(0.12) + t76));
                let t78 = t68 * t69 + t77 - t57 * t65 - t67 * t70 - t53 * t71;
                let t79 = T::from_f64(-1.0) / t78;
                let t80 = t73 * t79;
                let t81 = t38 + t52 * t64 + t73 * t80 + t77 - t74 - t75 - t36 * t39;
                let t82 = T::from_f64(32.78688524590164) * t51;
                let t83 = T::from_f64(31.78639542275906) * t44;
                let t84 = T::from_f64(-1.0) / (t81 - t51 * t82 - t44 * t83);
                let t85 = qy_a * qz_a + qx_a * qw_a;
                let t86 = t43 * qdz_a + t24 * qdx_a + t54 * qdy_a;
                let t87 = t50 * qdz_a + t30 * qdx_a + t42 * qdy_a;
                let t88 = qdy_b * t86 - t87 * qdx_b;
                let t89 = t87 + qdy_b;
                let t90 = qdx_b + t86;
                let t91 = t89 * t90;
                let t92 = T::from_f64(2e-5) * (t88 + t91)
                    - T::from_f64(0.00098) * (t91 - t88);
                let t93 = t36 * t92;
                let t94 = T::from_f64(0.12) * (t89 * t89 + t90 * t90);
                let t95 = t41 * qdz_a + t36 * qdx_a + t57 * qdy_a;
                let t96 = qdz_b + t95;
                let t97 = t89 * t96;
                let t98 = qdz_b * t87 - qdy_b * t95;
                let t99 = t97 - t98;
                let t100 = T::from_f64(0.12) * t99;
                let t101 = t95 * qdx_b - qdz_b * t86;
                let t102 = t96 * t90;
                let t103 = t101 + t102;
                let t104 = T::from_f64(0.12) * t103;
                let t105 = T::from_f64(9.81) * t85 + t93
                    + T::from_f64(0.5) * (t57 * t94 - t42 * t100 - t54 * t104);
                let t106 = t57 * t92;
                let t107 = qdz_a * qdx_a;
                let t108 = T::from_f64(9.81)
                    - T::from_f64(19.62) * (qx_a * qx_a + qy_a * qy_a)
                    + T::from_f64(0.5) * (qdy_a * qdy_a + qdx_a * qdx_a);
                let t109 = qz_a * qx_a - qy_a * qw_a;
                let t110 = T::from_f64(19.62) * t109 - T::from_f64(0.5) * t107;
                let t111 = qdy_a * qdz_a;
                let t112 = T::from_f64(19.62) * t85 - T::from_f64(0.5) * t111;
                let t113 = T::from_f64(0.03048) * t103
                    - T::from_f64(2e-5) * (t102 - t101)
                    - T::from_f64(0.12) * (t43 * t108 + t24 * t110 + t54 * t112);
                let t114 = T::from_f64(0.12) * (t50 * t108 + t30 * t110 + t42 * t112)
                    + T::from_f64(0.00098) * (t98 + t97);
                let t115 = t114 - T::from_f64(0.03048) * t99;
                let t116 = t54 - t71;
                let t117 = t42 - t70;
                let t118 = t106 + T::from_f64(0.21658666666666668) * t107 + t115 * t116
                    + t113 * t117 - T::from_f64(9.81) * t109;
                let t119 = t118 - t106
                    - T::from_f64(0.5) * (t36 * t94 - t30 * t100 - t24 * t104);
                let t120 = t41 - t41;
                let t121 = t43 * t115 + t50 * t113;
                let t122 = t92 * t120 + t121 - t121;
                let t123 = t119 - t69 * t122;
                let t124 = t24 - t83;
                let t125 = t30 - t82;
                let t126 = t105 + t80 * t123 + T::from_f64(-0.21658666666666668) * t111
                    + t115 * t124 + t113 * t125;
                let t127 = t84 * (t126 - t93 - t64 * t122);
                let t128 = t79 * t123 + t80 * t127;
                let t129 = t61 * t122 - t64 * t127 - t69 * t128;
                let t130 = T::from_f64(31.78639542275906) * t115 + t83 * t127
                    + t71 * t128 + t43 * t129;
                let t131 = -t130;
                let t132 = T::from_f64(32.78688524590164) * t113 + t82 * t127
                    + t70 * t128 + t50 * t129;
                let t133 = -t132;
                let t134 = t41 * t129 + T::from_f64(1000.0) * t92 + t36 * t127
                    + t57 * t128;
                let t135 = -t134;
                let t136 = T::from_f64(0.5) * qdx_a;
                let t137 = T::from_f64(0.5) * qdy_a;
                let t138 = T::from_f64(0.5) * qdz_a;
                let t139 = T::from_f64(9.81) * qx_a;
                let t140 = T::from_f64(9.81) * qy_a;
                let t141 = T::from_f64(19.62) * qx_a;
                let t142 = T::from_f64(19.62) * qy_a;
                let t143 = t42 * t141 - t30 * t142;
                let t144 = T::from_f64(0.12) * t143;
                let t145 = t54 * t141 - t24 * t142;
                let t146 = T::from_f64(0.12) * t145;
                let t147 = t50 * t146 + t43 * t144;
                let t148 = t147 - t147;
                let t149 = t140 + t144 * t116 - t69 * t148 - t146 * t117;
                let t150 = t139 + t80 * t149 + t144 * t124 - t64 * t148 - t146 * t125;
                let t151 = t84 * t150;
                let t152 = t79 * t149 + t80 * t151;
                let t153 = t61 * t148 - t64 * t151 - t69 * t152;
                let t154 = -(T::from_f64(3.814367450731087) * t143 + t83 * t151
                    + t71 * t152 + t43 * t153);
                let t155 = T::from_f64(3.9344262295081966) * t145 - t82 * t151
                    - t70 * t152 - t50 * t153;
                let t156 = -(t41 * t153 + t36 * t151 + t57 * t152);
                let t157 = -t136;
                let t158 = -t138;
                let t159 = T::from_f64(9.81) * qw_a;
                let t160 = T::from_f64(19.62) * qz_a;
                let t161 = T::from_f64(19.62) * qw_a;
                let t162 = T::from_f64(39.24) * qx_a;
                let t163 = t30 * t160 + t42 * t161 - t50 * t162;
                let t164 = t24 * t160 + t54 * t161 - t43 * t162;
                let t165 = T::from_f64(0.12) * t163;
                let t166 = T::from_f64(9.81) * qz_a;
                let t167 = T::from_f64(0.12) * t164;
                let t168 = t50 * t167 + t43 * t165;
                let t169 = t168 - t168;
                let t170 = t165 * t116 - t166 - t69 * t169 - t167 * t117;
                let t171 = t159 + t80 * t170 + t165 * t124 - t64 * t169 - t167 * t125;
                let t172 = t84 * t171;
                let t173 = t79 * t170 + t80 * t172;
                let t174 = t61 * t169 - t64 * t172 - t69 * t173;
                let t175 = -(T::from_f64(3.814367450731087) * t163 + t83 * t172
                    + t71 * t173 + t43 * t174);
                let t176 = T::from_f64(3.9344262295081966) * t164 - t82 * t172
                    - t70 * t173 - t50 * t174;
                let t177 = -(t41 * t174 + t36 * t172 + t57 * t173);
                let t178 = -t137;
                let t179 = T::from_f64(39.24) * qy_a;
                let t180 = t42 * t160 - t30 * t161 - t50 * t179;
                let t181 = t54 * t160 - t24 * t161 - t43 * t179;
                let t182 = T::from_f64(0.12) * t180;
                let t183 = T::from_f64(0.12) * t181;
                let t184 = t50 * t183 + t43 * t182;
                let t185 = t184 - t184;
                let t186 = t159 + t182 * t116 - t69 * t185 - t183 * t117;
                let t187 = t166 + t80 * t186 + t182 * t124 - t64 * t185 - t183 * t125;
                let t188 = t84 * t187;
                let t189 = t79 * t186 + t80 * t188;
                let t190 = t61 * t185 - t64 * t188 - t69 * t189;
                let t191 = -(T::from_f64(3.814367450731087) * t180 + t83 * t188
                    + t71 * t189 + t43 * t190);
                let t192 = T::from_f64(3.9344262295081966) * t181 - t82 * t188
                    - t70 * t189 - t50 * t190;
                let t193 = -(t41 * t190 + t36 * t188 + t57 * t189);
                let t194 = t30 * t141 + t42 * t142;
                let t195 = t24 * t141 + t54 * t142;
                let t196 = T::from_f64(0.12) * t194;
                let t197 = T::from_f64(0.12) * t195;
                let t198 = t50 * t197 + t43 * t196;
                let t199 = t198 - t198;
                let t200 = t196 * t116 - t139 - t69 * t199 - t197 * t117;
                let t201 = t140 + t80 * t200 + t196 * t124 - t64 * t199 - t197 * t125;
                let t202 = t84 * t201;
                let t203 = t79 * t200 + t80 * t202;
                let t204 = t61 * t199 - t64 * t202 - t69 * t203;
                let t205 = -(T::from_f64(3.814367450731087) * t194 + t83 * t202
                    + t71 * t203 + t43 * t204);
                let t206 = T::from_f64(3.9344262295081966) * t195 - t82 * t202
                    - t70 * t203 - t50 * t204;
                let t207 = -(t41 * t204 + t36 * t202 + t57 * t203);
                let t208 = T::from_f64(0.5) * qdx_b;
                let t209 = -t208;
                let t210 = T::from_f64(0.5) * qdy_b;
                let t211 = -t210;
                let t212 = T::from_f64(0.5) * qdz_b;
                let t213 = -t212;
                let t214 = T::from_f64(2.0) * qx_b;
                let t215 = t108 * t214;
                let t216 = T::from_f64(2.0) * qz_b;
                let t217 = qdz_a * t214;
                let t218 = qdx_a * t216;
                let t219 = t217 - t218;
                let t220 = T::from_f64(2.0) * qy_b;
                let t221 = qdx_a * t220;
                let t222 = qdy_a * t214;
                let t223 = t221 - t222;
                let t224 = qdz_b * t219 - qdy_b * t223;
                let t225 = t96 * t219 + t89 * t223;
                let t226 = t225 - t224;
                let t227 = T::from_f64(0.12) * (t215 - t110 * t216)
                    + T::from_f64(0.00098) * (t224 + t225) - T::from_f64(0.03048) * t226;
                let t228 = T::from_f64(0.12) * t226;
                let t229 = qdy_a * t216;
                let t230 = qdz_a * t220;
                let t231 = t229 - t230;
                let t232 = qdx_b * t223 - qdz_b * t231;
                let t233 = t90 * t223 + t96 * t231;
                let t234 = t232 + t233;
                let t235 = t108 * t220;
                let t236 = T::from_f64(0.03048) * t234
                    - T::from_f64(2e-5) * (t233 - t232)
                    - T::from_f64(0.12) * (t112 * t216 - t235);
                let t237 = T::from_f64(0.12) * t234;
                let t238 = T::from_f64(2.0) * t89;
                let t239 = T::from_f64(2.0) * t90;
                let t240 = T::from_f64(0.12) * (t219 * t238 + t231 * t239);
                let t241 = t94 * t214;
                let t242 = t57 * t240 - t241 - t42 * t228 - t104 * t216 - t54 * t237;
                let t243 = t37 * t220;
                let t244 = T::from_f64(0.06096) * qy_b;
                let t245 = t31 * t216;
                let t246 = T::from_f64(0.00196) * qz_b;
                let t247 = t243 + t36 * t244 - t245 - t30 * t246;
                let t248 = t55 * t216;
                let t249 = T::from_f64(4e-5) * qz_b;
                let t250 = T::from_f64(0.06096) * qx_b;
                let t251 = t57 * t250;
                let t252 = t248 + t54 * t249 - t58 * t214 - t251;
                let t253 = t43 * t249;
                let t254 = t247 - t252;
                let t255 = t252 + t254;
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
                    t24,
                    t25,
                    t30,
                    t31,
                    t36,
                    t37,
                    t41,
                    t42,
                    t43,
                    t50,
                    t54,
                    t55,
                    t56,
                    t57,
                    t58,
                    t61,
                    t62,
                    t63,
                    t64,
                    t69,
                    t70,
                    t71,
                    t76,
                    t79,
                    t80,
                    t82,
                    t83,
                    t84,
                    t86,
                    t87,
                    t89,
                    t90,
                    t92,
                    t94,
                    t95,
                    t96,
                    t100,
                    t104,
                    t108,
                    t110,
                    t112,
                    t113,
                    t115,
                    t116,
                    t117,
                    t120,
                    t124,
                    t125,
                    t127,
                    t128,
                    t129,
                    t130,
                    t131,
                    t132,
                    t133,
                    t134,
                    t135,
                    t136,
                    t137,
                    t138,
                    t151,
                    t152,
                    t153,
                    t154,
                    t155,
                    t156,
                    t157,
                    t158,
                    t172,
                    t173,
                    t174,
                    t175,
                    t176,
                    t177,
                    t178,
                    t188,
                    t189,
                    t190,
                    t191,
                    t192,
                    t193,
                    t202,
                    t203,
                    t204,
                    t205,
                    t206,
                    t207,
                    t208,
                    t209,
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
                    t227,
                    t228,
                    t229,
                    t230,
                    t231,
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
                    t246,
                    t247,
                    t248,
                    t250,
                    t251,
                    t252,
                    t253,
                    t254,
                    t255,
                )
            };
            let (
                t269,
                t270,
                t304,
                t306,
                t310,
                t311,
                t312,
                t313,
                t314,
                t315,
                t330,
                t382,
                t388,
                t395,
                t401,
                t402,
                t403,
                t404,
                t405,
                t406,
                t443,
                t456,
                t460,
                t471,
                t472,
                t473,
                t474,
                t475,
                t476,
                t477,
                t484,
                t489,
                t490,
                t493,
                t495,
                t496,
                t497,
                t499,
                t500,
                t504,
                t506,
                t508,
                t509,
                t510,
                t511,
            ) = {
                let t256 = T::from_f64(0.00196) * qx_b;
                let t257 = t50 * t256;
                let t258 = T::from_f64(4e-5) * qy_b;
                let t259 = t43 * t258;
                let t260 = t255 + (t63 * t214 + t257 - t62 * t220 - t259);
                let t261 = t24 * t227 + t30 * t236 + T::from_f64(0.5) * t242
                    + t127 * (t247 + t260 - t254 - t255);
                let t262 = T::from_f64(0.061) * qz_b;
                let t263 = T::from_f64(0.12) * qz_b;
                let t264 = t262 + t263;
                let t265 = t115 * t216;
                let t266 = qdy_b * t231 - qdx_b * t219;
                let t267 = t90 * t219 + t89 * t231;
                let t268 = T::from_f64(2e-5) * (t266 + t267)
                    - T::from_f64(0.00098) * (t267 - t266);
                let t269 = T::from_f64(0.002) * qy_b;
                let t270 = T::from_f64(0.002) * qx_b;
                let t271 = t268 + t127 * t269 - t128 * t270;
                let t272 = t268 - t271;
                let t273 = t265 + t54 * t227 + t42 * t236 + t128 * t260 + t57 * t272;
                let t274 = t94 * t220;
                let t275 = t274 + t36 * t240 + t100 * t216 - t30 * t228 - t24 * t237;
                let t276 = t25 * t216;
                let t277 = t57 * t244;
                let t278 = t37 * t214;
                let t279 = t276 + t277 - t278 - t42 * t246;
                let t280 = t50 * t246;
                let t281 = t55 * t220;
                let t282 = T::from_f64(0.12) * qx_b;
                let t283 = t41 * t250 + t282;
                let t284 = t253 + t56 * t214 - t281 - t283;
                let t285 = T::from_f64(0.06292) * qz_b;
                let t286 = t263 + t285;
                let t287 = t273 - T::from_f64(0.5) * t275 - t127 * t279 - t129 * t284
                    - t130 * t286;
                let t288 = T::from_f64(0.061) * qx_b;
                let t289 = t236 + t129 * t288 - t127 * t264;
                let t290 = T::from_f64(0.06292) * qy_b;
                let t291 = t227 + t128 * t286 - t129 * t290;
                let t292 = t113 * t214;
                let t293 = t292 + t41 * t268 + t129 * (t247 + t252) + t130 * t290
                    + t43 * (t227 - t291);
                let t294 = t115 * t220;
                let t295 = t31 * t214;
                let t296 = T::from_f64(0.12) * qy_b;
                let t297 = t296 + t41 * t244;
                let t298 = t290 - t296;
                let t299 = t25 * t220;
                let t300 = t295 + t297 - t280 - t299;
                let t301 = t293 + t50 * (t236 - t289) - t294 - t127 * t300 - t128 * t284;
                let t302 = t301 - t132 * t288 - t41 * t271;
                let t303 = t288 - t282;
                let t304 = t92 * t214 - t134 * t270;
                let t305 = t287 - t70 * t289 - t71 * t291 - t69 * t302 - t304;
                let t306 = t92 * t220 - t134 * t269;
                let t307 = t113 * t216;
                let t308 = t261 + t132 * t264 + t80 * t305 + t36 * t272 + t306 - t307;
                let t309 = t308 - t128 * t279 - t129 * t300 - t82 * t289 - t83 * t291;
                let t310 = t84 * (t309 - t64 * t302);
                let t311 = t79 * t305 + t80 * t310;
                let t312 = t61 * t302 - t64 * t310 - t69 * t311;
                let t313 = -(T::from_f64(31.78639542275906) * t291 + t83 * t310
                    + t71 * t311 + t43 * t312);
                let t314 = -(T::from_f64(32.78688524590164) * t289 + t82 * t310
                    + t70 * t311 + t50 * t312);
                let t315 = -(t41 * t312 + T::from_f64(1000.0) * t271 + t36 * t310
                    + t57 * t311);
                let t316 = T::from_f64(2.0) * qw_b;
                let t317 = t108 * t316;
                let t318 = t108 * t216;
                let t319 = T::from_f64(4.0) * qx_b;
                let t320 = qdz_a * t316;
                let t321 = t221 + t320 - qdy_a * t319;
                let t322 = qdy_a * t316;
                let t323 = t218 - t322 - qdz_a * t319;
                let t324 = qdz_b * t321 - qdy_b * t323;
                let t325 = t96 * t321 + t89 * t323;
                let t326 = T::from_f64(0.12) * (t317 + t110 * t220 - t112 * t319)
                    + T::from_f64(0.00098) * (t324 + t325);
                let t327 = t325 - t324;
                let t328 = t326 - T::from_f64(0.03048) * t327;
                let t329 = T::from_f64(0.12) * t327;
                let t330 = t113 * t220;
                let t331 = qdz_a * t216;
                let t332 = qdy_a * t220;
                let t333 = t331 + t332;
                let t334 = qdx_b * t323 - qdz_b * t333;
                let t335 = t90 * t323 + t96 * t333;
                let t336 = t334 + t335;
                let t337 = T::from_f64(0.03048) * t336
                    - T::from_f64(2e-5) * (t335 - t334)
                    - T::from_f64(0.12) * (t318 + t112 * t220);
                let t338 = T::from_f64(0.12) * t336;
                let t339 = T::from_f64(0.12) * (t238 * t321 + t239 * t333);
                let t340 = t94 * t316;
                let t341 = t94 * t216;
                let t342 = t57 * t339 + t100 * t319 - t340 - t42 * t329 - t104 * t220;
                let t343 = t341 + t36 * t339 - t100 * t220 - t30 * t329 - t24 * t338;
                let t344 = t24 * t328 + t330 + t30 * t337
                    + T::from_f64(0.5) * (t342 - t54 * t338);
                let t345 = t31 * t220;
                let t346 = T::from_f64(0.00196) * qy_b;
                let t347 = t37 * t216;
                let t348 = T::from_f64(0.06096) * qz_b;
                let t349 = t263 + t41 * t348;
                let t350 = t345 + t30 * t346 + t347 + t36 * t348;
                let t351 = t57 * t348;
                let t352 = T::from_f64(0.00392) * qx_b;
                let t353 = t281 + t54 * t258 - t56 * t319 - t42 * t352 - t58 * t316;
                let t354 = T::from_f64(0.06096) * qw_b;
                let t355 = t57 * t354;
                let t356 = t353 - t355;
                let t357 = t350 - t356;
                let t358 = t356 + t357;
                let t359 = T::from_f64(0.00196) * qw_b;
                let t360 = t50 * t359;
                let t361 = T::from_f64(-0.48) - T::from_f64(0.12192) * t41;
                let t362 = t253 + t62 * t216 + t63 * t316 + t360 + qx_b * t361
                    - t76 * t319;
                let t363 = t358 + t362;
                let t364 = T::from_f64(0.24) * qx_b;
                let t365 = T::from_f64(0.122) * qx_b;
                let t366 = t294 + t54 * t328 + t42 * t337 + t128 * t363 + t132 * t365;
                let t367 = qdy_b * t333 - qdx_b * t321;
                let t368 = t90 * t321 + t89 * t333;
                let t369 = T::from_f64(2e-5) * (t367 + t368)
                    - T::from_f64(0.00098) * (t368 - t367);
                let t370 = T::from_f64(0.002) * qz_b;
                let t371 = T::from_f64(0.002) * qw_b;
                let t372 = T::from_f64(0.004) * qx_b;
                let t373 = t369 + t127 * t370 - t128 * t371 - t129 * t372;
                let t374 = t369 - t373;
                let t375 = t37 * t316;
                let t376 = t299 + t42 * t346 + t351 - t31 * t319 - t375;
                let t377 = t366 + t57 * t374 - t113 * t319 - T::from_f64(0.5) * t343
                    - t127 * t376;
                let t378 = t50 * t346;
                let t379 = T::from_f64(0.12) * qw_b;
                let t380 = t41 * t354 + t379;
                let t381 = t248 + t259 + t56 * t316 - t50 * t352 - t58 * t319 - t380;
                let t382 = T::from_f64(0.061) * qy_b;
                let t383 = t382 - t296;
                let t384 = T::from_f64(0.061) * qw_b;
                let t385 = t337 + t127 * t383 + t129 * t384 - t128 * t365;
                let t386 = t328 + t128 * t298 + t129 * t285 - t127 * t364;
                let t387 = t377 - t129 * t381 - t130 * t298 - t70 * t385 - t71 * t386;
                let t388 = t113 * t316;
                let t389 = t265 + t388 + t41 * t369 + t129 * (t350 + t356) + t134 * t372;
                let t390 = t389 + t43 * (t328 - t386) + t50 * (t337 - t385) - t92 * t319;
                let t391 = t31 * t316;
                let t392 = t276 + t391 + t378 + t349 - t37 * t319;
                let t393 = t390 - t127 * t392 - t128 * t381 - t130 * t285 - t132 * t384;
                let t394 = t393 - t41 * t373;
                let t395 = t384 + t379;
                let t396 = t92 * t316 - t134 * t371;
                let t397 = t387 - t69 * t394 - t396;
                let t398 = t344 + t127 * (t350 + t363 - t357 - t358) + t130 * t364
                    + t80 * t397;
                let t399 = t92 * t216 - t134 * t370;
                let t400 = t398 + t36 * t374 + t399 - t128 * t376 - t129 * t392
                    - t132 * t383;
                let t401 = t84 * (t400 - t82 * t385 - t83 * t386 - t64 * t394);
                let t402 = t79 * t397 + t80 * t401;
                let t403 = t61 * t394 - t64 * t401 - t69 * t402;
                let t404 = -(T::from_f64(31.78639542275906) * t386 + t83 * t401
                    + t71 * t402 + t43 * t403);
                let t405 = -(T::from_f64(32.78688524590164) * t385 + t82 * t401
                    + t70 * t402 + t50 * t403);
                let t406 = -(t41 * t403 + T::from_f64(1000.0) * t373 + t36 * t401
                    + t57 * t402);
                let t407 = qdx_a * t214;
                let t408 = t331 + t407;
                let t409 = t332 + t407;
                let t410 = qdx_a * t316;
                let t411 = T::from_f64(4.0) * qy_b;
                let t412 = t280 + t63 * t216 + qy_b * t361 - t76 * t411 - t62 * t316;
                let t413 = t222 - t320 - qdx_a * t411;
                let t414 = t229 + t410 - qdz_a * t411;
                let t415 = qdz_b * t408 - qdy_b * t414;
                let t416 = t96 * t408 + t89 * t414;
                let t417 = t416 - t415;
                let t418 = T::from_f64(0.12) * (t318 + t110 * t214)
                    + T::from_f64(0.00098) * (t415 + t416) - T::from_f64(0.03048) * t417;
                let t419 = T::from_f64(0.12) * t417;
                let t420 = qdx_b * t414 - qdz_b * t413;
                let t421 = t90 * t414 + t96 * t413;
                let t422 = t420 + t421;
                let t423 = T::from_f64(0.03048) * t422
                    - T::from_f64(2e-5) * (t421 - t420)
                    - T::from_f64(0.12) * (t112 * t214 - t317 - t110 * t411);
                let t424 = T::from_f64(0.12) * t422;
                let t425 = T::from_f64(0.12) * (t238 * t408 + t239 * t413);
                let t426 = t341 + t57 * t425 - t42 * t419 - t104 * t214 - t54 * t424;
                let t427 = t340 + t36 * t425 + t104 * t411 - t100 * t214 - t30 * t419;
                let t428 = T::from_f64(8e-5) * qy_b;
                let t429 = t295 + t375 + t30 * t256 + t36 * t354 - t25 * t411
                    - t24 * t428;
                let t430 = t55 * t214;
                let t431 = t55 * t316;
                let t432 = T::from_f64(4e-5) * qx_b;
                let t433 = t351 + t430 + t54 * t432 + t58 * t216;
                let t434 = t43 * t432;
                let t435 = t434 + t56 * t216 + t349 - t431 - t58 * t411;
                let t436 = t429 - t433;
                let t437 = t433 + t436;
                let t438 = T::from_f64(4e-5) * qw_b;
                let t439 = t43 * t438;
                let t440 = t437 + (t412 - t439);
                let t441 = t292 + t24 * t418 + t30 * t423 + T::from_f64(0.5) * t426
                    + t127 * (t429 + t440 - t436 - t437);
                let t442 = T::from_f64(0.12584) * qy_b;
                let t443 = t115 * t214;
                let t444 = T::from_f64(0.24) * qy_b;
                let t445 = t443 + t54 * t418 + t42 * t423 + t128 * t440 + t132 * t444;
                let t446 = t423 + t127 * t303 + t129 * t262 - t128 * t444;
                let t447 = qdy_b * t413 - qdx_b * t408;
                let t448 = t90 * t408 + t89 * t413;
                let t449 = T::from_f64(2e-5) * (t447 + t448)
                    - T::from_f64(0.00098) * (t448 - t447);
                let t450 = T::from_f64(0.004) * qy_b;
                let t451 = t449 + t127 * t371 + t128 * t370 - t129 * t450;
                let t452 = t449 - t451;
                let t453 = t25 * t214;
                let t454 = t347 + t355 + t453 + t42 * t256 - t54 * t428;
                let t455 = t445 + t57 * t452 + t399
                    - T::from_f64(0.5) * (t427 - t24 * t424) - t127 * t454;
                let t456 = T::from_f64(0.06292) * qx_b;
                let t457 = t456 - t282;
                let t458 = T::from_f64(0.06292) * qw_b;
                let t459 = t307 + t41 * t449 + t129 * (t429 + t433) + t130 * t458
                    + t134 * t450;
                let t460 = t379 + t458;
                let t461 = t418 + t128 * t457 - t127 * t442 - t129 * t458;
                let t462 = t455 - t129 * t435 - t130 * t457 - t70 * t446 - t71 * t461;
                let t463 = t115 * t316;
                let t464 = t459 + t43 * (t418 - t461) + t50 * (t423 - t446) - t463
                    - t92 * t411;
                let t465 = t25 * t316;
                let t466 = t245 + t257 + t380 - t37 * t411 - t465 - t43 * t428;
                let t467 = t464 - t127 * t466 - t128 * t435 - t132 * t262 - t41 * t451;
                let t468 = t462 - t69 * t467;
                let t469 = t441 + t130 * t442 + t80 * t468 + t36 * t452 + t396
                    - t115 * t411;
                let t470 = t469 - t128 * t454 - t129 * t466 - t132 * t303 - t82 * t446;
                let t471 = t84 * (t470 - t83 * t461 - t64 * t467);
                let t472 = t79 * t468 + t80 * t471;
                let t473 = t61 * t467 - t64 * t471 - t69 * t472;
                let t474 = -(T::from_f64(31.78639542275906) * t461 + t83 * t471
                    + t71 * t472 + t43 * t473);
                let t475 = -(T::from_f64(32.78688524590164) * t446 + t82 * t471
                    + t70 * t472 + t50 * t473);
                let t476 = -(t41 * t473 + T::from_f64(1000.0) * t451 + t36 * t471
                    + t57 * t472);
                let t477 = T::from_f64(4.0) * qz_b;
                let t478 = t230 - t410 - qdy_a * t477;
                let t479 = t217 + t322 - qdx_a * t477;
                let t480 = qdz_b * t478 - qdy_b * t409;
                let t481 = t96 * t478 + t89 * t409;
                let t482 = T::from_f64(0.12) * (t235 - t110 * t316 - t112 * t477)
                    + T::from_f64(0.00098) * (t480 + t481);
                let t483 = t481 - t480;
                let t484 = t482 - T::from_f64(0.03048) * t483;
                let t485 = T::from_f64(0.12) * t483;
                let t486 = qdx_b * t409 - qdz_b * t479;
                let t487 = t90 * t409 + t96 * t479;
                let t488 = t486 + t487;
                let t489 = T::from_f64(0.03048) * t488
                    - T::from_f64(2e-5) * (t487 - t486)
                    - T::from_f64(0.12) * (t215 + t112 * t316 - t110 * t477);
                let t490 = T::from_f64(0.12) * t488;
                let t491 = T::from_f64(0.12) * (t238 * t478 + t239 * t479);
                let t492 = t274 + t57 * t491 + t100 * t477 - t42 * t485 - t104 * t316;
                let t493 = t241 + t36 * t491 + t100 * t316 + t104 * t477 - t30 * t485;
                let t494 = T::from_f64(8e-5) * qz_b;
                let t495 = t278 + t36 * t250 - t391 - t30 * t359 - t25 * t477
                    - t24 * t494;
                let t496 = t243 + t251 + t465 - t54 * t494 - t31 * t477 - t42 * t359;
                let t497 = t345 + t453 + t283 - t360 - t43 * t494;
                let t498 = T::from_f64(0.00392) * qz_b;
                let t499 = t277 + t431 + t54 * t438 + t58 * t220 - t56 * t477
                    - t42 * t498;
                let t500 = t430 + t439 + t56 * t220 + t297 - t50 * t498;
                let t501 = t495 - t499;
                let t502 = t499 + t501;
                let t503 = t502 + (t378 + t434 + t62 * t214 + t63 * t220);
                let t504 = t24 * t484 + t30 * t489
                    + T::from_f64(0.5) * (t492 - t54 * t490)
                    + t127 * (t495 + t503 - t501 - t502);
                let t505 = T::from_f64(0.24) * qz_b;
                let t506 = T::from_f64(0.12584) * qz_b + t505;
                let t507 = t505 + T::from_f64(0.122) * qz_b;
                let t508 = t463 + t54 * t484 + t42 * t489 + t128 * t503 + t132 * t507;
                let t509 = t489 + t129 * t382 - t127 * t395 - t128 * t507;
                let t510 = qdy_b * t479 - qdx_b * t478;
                let t511 = t90 * t478 + t89 * t479;
                (
                    t269,
                    t270,
                    t304,
                    t306,
                    t310,
                    t311,
                    t312,
                    t313,
                    t314,
                    t315,
                    t330,
                    t382,
                    t388,
                    t395,
                    t401,
                    t402,
                    t403,
                    t404,
                    t405,
                    t406,
                    t443,
                    t456,
                    t460,
                    t471,
                    t472,
                    t473,
                    t474,
                    t475,
                    t476,
                    t477,
                    t484,
                    t489,
                    t490,
                    t493,
                    t495,
                    t496,
                    t497,
                    t499,
                    t500,
                    t504,
                    t506,
                    t508,
                    t509,
                    t510,
                    t511,
                )
            };
            let (
                t524,
                t525,
                t526,
                t527,
                t528,
                t529,
                t552,
                t553,
                t554,
                t555,
                t556,
                t557,
                t581,
                t582,
                t583,
                t584,
                t585,
                t586,
                t608,
                t609,
                t610,
                t611,
                t612,
                t613,
                t634,
                t635,
                t636,
                t637,
                t638,
                t639,
                t653,
                t654,
                t655,
                t656,
                t657,
                t658,
                t663,
                t664,
                t665,
                t666,
                t667,
                t668,
            ) = {
                let t512 = T::from_f64(2e-5) * (t510 + t511)
                    - T::from_f64(0.00098) * (t511 - t510);
                let t513 = t512 + t127 * t270 + t128 * t269;
                let t514 = t512 - t513;
                let t515 = t508 + t57 * t514 + t306 - t113 * t477
                    - T::from_f64(0.5) * (t493 - t24 * t490);
                let t516 = t515 - t127 * t496 - t129 * t500 - t130 * t460 - t70 * t509;
                let t517 = t484 + t128 * t460 + t129 * t456 - t127 * t506;
                let t518 = t330 + t443 + t41 * t512 + t129 * (t495 + t499)
                    + t43 * (t484 - t517);
                let t519 = t518 + t50 * (t489 - t509) - t127 * t497 - t128 * t500
                    - t130 * t456;
                let t520 = t519 - t132 * t382 - t41 * t513;
                let t521 = t516 - t71 * t517 - t69 * t520;
                let t522 = t504 + t130 * t506 + t132 * t395 + t80 * t521 + t36 * t514;
                let t523 = t522 + t304 - t388 - t115 * t477 - t128 * t496 - t129 * t497;
                let t524 = t84 * (t523 - t82 * t509 - t83 * t517 - t64 * t520);
                let t525 = t79 * t521 + t80 * t524;
                let t526 = t61 * t520 - t64 * t524 - t69 * t525;
                let t527 = -(T::from_f64(31.78639542275906) * t517 + t83 * t524
                    + t71 * t525 + t43 * t526);
                let t528 = -(T::from_f64(32.78688524590164) * t509 + t82 * t524
                    + t70 * t525 + t50 * t526);
                let t529 = -(t41 * t526 + T::from_f64(1000.0) * t513 + t36 * t524
                    + t57 * t525);
                let t530 = t24 * qdy_b - t30 * qdx_b;
                let t531 = t30 * t90 + t24 * t89;
                let t532 = T::from_f64(2e-5) * (t530 + t531)
                    - T::from_f64(0.00098) * (t531 - t530);
                let t533 = t36 * t532;
                let t534 = T::from_f64(0.12) * (t30 * t238 + t24 * t239);
                let t535 = t30 * t96 + t36 * t89;
                let t536 = t30 * qdz_b - t36 * qdy_b;
                let t537 = t535 - t536;
                let t538 = T::from_f64(0.12) * (t50 * qdx_a - t30 * t138)
                    + T::from_f64(0.00098) * (t536 + t535) - T::from_f64(0.03048) * t537;
                let t539 = T::from_f64(0.12) * t537;
                let t540 = t36 * qdx_b - t24 * qdz_b;
                let t541 = t36 * t90 + t24 * t96;
                let t542 = t540 + t541;
                let t543 = T::from_f64(0.03048) * t542
                    - T::from_f64(2e-5) * (t541 - t540)
                    - T::from_f64(0.12) * (t43 * qdx_a - t24 * t138);
                let t544 = T::from_f64(0.12) * t542;
                let t545 = t57 * t532;
                let t546 = T::from_f64(0.21666666666666667) * qdz_a
                    - T::from_f64(8e-5) * qdz_a;
                let t547 = t545 + t538 * t116 + t543 * t117 + t546 - t545
                    - T::from_f64(0.5) * (t36 * t534 - t30 * t539 - t24 * t544);
                let t548 = t43 * t538 + t50 * t543;
                let t549 = t532 * t120 + t548 - t548;
                let t550 = t547 - t69 * t549;
                let t551 = t533
                    + T::from_f64(0.5) * (t57 * t534 - t42 * t539 - t54 * t544)
                    + t80 * t550;
                let t552 = t84 * (t551 + t538 * t124 + t543 * t125 - t533 - t64 * t549);
                let t553 = t79 * t550 + t80 * t552;
                let t554 = t61 * t549 - t64 * t552 - t69 * t553;
                let t555 = -(T::from_f64(31.78639542275906) * t538 + t83 * t552
                    + t71 * t553 + t43 * t554);
                let t556 = -(T::from_f64(32.78688524590164) * t543 + t82 * t552
                    + t70 * t553 + t50 * t554);
                let t557 = -(t41 * t554 + T::from_f64(1000.0) * t532 + t36 * t552
                    + t57 * t553);
                let t558 = t54 * qdy_b - t42 * qdx_b;
                let t559 = t42 * t90 + t54 * t89;
                let t560 = T::from_f64(2e-5) * (t558 + t559)
                    - T::from_f64(0.00098) * (t559 - t558);
                let t561 = t36 * t560;
                let t562 = T::from_f64(0.12) * (t42 * t238 + t54 * t239);
                let t563 = T::from_f64(0.12) * (t50 * t238 + t43 * t239);
                let t564 = t42 * t96 + t57 * t89;
                let t565 = t42 * qdz_b - t57 * qdy_b;
                let t566 = t564 - t565;
                let t567 = T::from_f64(0.12) * (t50 * qdy_a - t42 * t138)
                    + T::from_f64(0.00098) * (t565 + t564) - T::from_f64(0.03048) * t566;
                let t568 = T::from_f64(0.12) * t566;
                let t569 = t57 * qdx_b - t54 * qdz_b;
                let t570 = t57 * t90 + t54 * t96;
                let t571 = t569 + t570;
                let t572 = T::from_f64(0.03048) * t571
                    - T::from_f64(2e-5) * (t570 - t569)
                    - T::from_f64(0.12) * (t43 * qdy_a - t54 * t138);
                let t573 = T::from_f64(0.12) * t571;
                let t574 = t57 * t560;
                let t575 = t574 + t567 * t116 + t572 * t117 - t574
                    - T::from_f64(0.5) * (t36 * t562 - t30 * t568 - t24 * t573);
                let t576 = t43 * t567 + t50 * t572;
                let t577 = t560 * t120 + t576 - t576;
                let t578 = t575 - t69 * t577;
                let t579 = t561
                    + T::from_f64(0.5) * (t57 * t562 - t42 * t568 - t54 * t573)
                    + t80 * t578;
                let t580 = t579 + t567 * t124 + t572 * t125 - t561 - t64 * t577 - t546;
                let t581 = t84 * t580;
                let t582 = t79 * t578 + t80 * t581;
                let t583 = t61 * t577 - t64 * t581 - t69 * t582;
                let t584 = -(T::from_f64(31.78639542275906) * t567 + t83 * t581
                    + t71 * t582 + t43 * t583);
                let t585 = -(T::from_f64(32.78688524590164) * t572 + t82 * t581
                    + t70 * t582 + t50 * t583);
                let t586 = -(t41 * t583 + T::from_f64(1000.0) * t560 + t36 * t581
                    + t57 * t582);
                let t587 = t43 * qdy_b - t50 * qdx_b;
                let t588 = t50 * t90 + t43 * t89;
                let t589 = T::from_f64(2e-5) * (t587 + t588)
                    - T::from_f64(0.00098) * (t588 - t587);
                let t590 = t36 * t589;
                let t591 = t50 * t96 + t41 * t89;
                let t592 = t50 * qdz_b - t41 * qdy_b;
                let t593 = t591 - t592;
                let t594 = T::from_f64(0.00098) * (t592 + t591)
                    - T::from_f64(0.03048) * t593
                    - T::from_f64(0.12) * (t30 * t136 + t42 * t137);
                let t595 = T::from_f64(0.12) * t593;
                let t596 = t41 * qdx_b - t43 * qdz_b;
                let t597 = t41 * t90 + t43 * t96;
                let t598 = t596 + t597;
                let t599 = T::from_f64(0.03048) * t598
                    + T::from_f64(0.12) * (t24 * t136 + t54 * t137)
                    - T::from_f64(2e-5) * (t597 - t596);
                let t600 = T::from_f64(0.12) * t598;
                let t601 = t57 * t589;
                let t602 = t601 + T::from_f64(0.21658666666666668) * qdx_a + t594 * t116
                    + t599 * t117 - t601
                    - T::from_f64(0.5) * (t36 * t563 - t30 * t595 - t24 * t600);
                let t603 = t43 * t594 + t50 * t599;
                let t604 = t589 * t120 + t603 - t603;
                let t605 = t602 - t69 * t604;
                let t606 = t590
                    + T::from_f64(0.5) * (t57 * t563 - t42 * t595 - t54 * t600)
                    + t80 * t605;
                let t607 = t606 + T::from_f64(-0.21658666666666668) * qdy_a + t594 * t124
                    + t599 * t125 - t590 - t64 * t604;
                let t608 = t84 * t607;
                let t609 = t79 * t605 + t80 * t608;
                let t610 = t61 * t604 - t64 * t608 - t69 * t609;
                let t611 = -(T::from_f64(31.78639542275906) * t594 + t83 * t608
                    + t71 * t609 + t43 * t610);
                let t612 = -(T::from_f64(32.78688524590164) * t599 + t82 * t608
                    + t70 * t609 + t50 * t610);
                let t613 = -(t41 * t610 + T::from_f64(1000.0) * t589 + t36 * t608
                    + t57 * t609);
                let t614 = t89 - t87;
                let t615 = T::from_f64(0.00098) * (t87 + t89);
                let t616 = T::from_f64(0.24) * t89;
                let t617 = T::from_f64(2e-5) * t614 - t615;
                let t618 = t615 - T::from_f64(0.03048) * t614;
                let t619 = T::from_f64(0.12) * t614;
                let t620 = t36 * t617;
                let t621 = T::from_f64(0.24) * t90;
                let t622 = t95 + t96;
                let t623 = t96 - t95;
                let t624 = T::from_f64(0.12) * t622;
                let t625 = T::from_f64(0.03048) * t622;
                let t626 = t57 * t617;
                let t627 = t625 - T::from_f64(2e-5) * t623;
                let t628 = T::from_f64(0.00098) * t623 - t625;
                let t629 = t626 + t627 * t117 - t626
                    - T::from_f64(0.5) * (t36 * t621 - t24 * t624);
                let t630 = t50 * t627;
                let t631 = t630 + t617 * t120 - t630;
                let t632 = t629 - t69 * t631;
                let t633 = t620 + T::from_f64(0.5) * (t57 * t621 - t54 * t624)
                    + t80 * t632 + t627 * t125;
                let t634 = t84 * (t633 - t620 - t64 * t631);
                let t635 = t79 * t632 + t80 * t634;
                let t636 = t61 * t631 - t64 * t634 - t69 * t635;
                let t637 = -(T::from_f64(32.78688524590164) * t627 + t82 * t634
                    + t70 * t635 + t50 * t636);
                let t638 = -(t41 * t636 + T::from_f64(1000.0) * t617 + t36 * t634
                    + t57 * t635);
                let t639 = -(t83 * t634 + t71 * t635 + t43 * t636);
                let t640 = T::from_f64(2e-5) * (t86 + t90);
                let t641 = t90 - t86;
                let t642 = t640 - T::from_f64(0.00098) * t641;
                let t643 = T::from_f64(0.03048) * t641 - t640;
                let t644 = T::from_f64(0.12) * t641;
                let t645 = T::from_f64(0.5) * (t30 * t619 + t24 * t644) + t618 * t116
                    + t643 * t117;
                let t646 = t36 * t642;
                let t647 = t57 * t642;
                let t648 = t647 + t628 * t116 - t647
                    - T::from_f64(0.5) * (t36 * t616 - t30 * t624);
                let t649 = t43 * t628;
                let t650 = t649 + t642 * t120 - t649;
                let t651 = t648 - t69 * t650;
                let t652 = t646 + T::from_f64(0.5) * (t57 * t616 - t42 * t624)
                    + t80 * t651 + t628 * t124;
                let t653 = t84 * (t652 - t646 - t64 * t650);
                let t654 = t79 * t651 + t80 * t653;
                let t655 = t61 * t650 - t64 * t653 - t69 * t654;
                let t656 = -(T::from_f64(31.78639542275906) * t628 + t83 * t653
                    + t71 * t654 + t43 * t655);
                let t657 = -(t41 * t655 + T::from_f64(1000.0) * t642 + t36 * t653
                    + t57 * t654);
                let t658 = -(t82 * t653 + t70 * t654 + t50 * t655);
                let t659 = t43 * t618 + t50 * t643;
                let t660 = t659 - t659;
                let t661 = t645 - t69 * t660;
                let t662 = t80 * t661 + t618 * t124 + t643 * t125
                    - T::from_f64(0.5) * (t42 * t619 + t54 * t644);
                let t663 = t84 * (t662 - t64 * t660);
                let t664 = t79 * t661 + t80 * t663;
                let t665 = t61 * t660 - t64 * t663 - t69 * t664;
                let t666 = -(T::from_f64(31.78639542275906) * t618 + t83 * t663
                    + t71 * t664 + t43 * t665);
                let t667 = -(T::from_f64(32.78688524590164) * t643 + t82 * t663
                    + t70 * t664 + t50 * t665);
                let t668 = -(t41 * t665 + t36 * t663 + t57 * t664);
                (
                    t524,
                    t525,
                    t526,
                    t527,
                    t528,
                    t529,
                    t552,
                    t553,
                    t554,
                    t555,
                    t556,
                    t557,
                    t581,
                    t582,
                    t583,
                    t584,
                    t585,
                    t586,
                    t608,
                    t609,
                    t610,
                    t611,
                    t612,
                    t613,
                    t634,
                    t635,
                    t636,
                    t637,
                    t638,
                    t639,
                    t653,
                    t654,
                    t655,
                    t656,
                    t657,
                    t658,
                    t663,
                    t664,
                    t665,
                    t666,
                    t667,
                    t668,
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
                    t127,
                    t128,
                    t129,
                    t131,
                    t133,
                    t135,
                ]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [
                        T::from_f64(0.0),
                        t136,
                        t137,
                        t138,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t151,
                        t152,
                        t153,
                        t154,
                        t155,
                        t156,
                    ],
                    [
                        t157,
                        T::from_f64(0.0),
                        t158,
                        t137,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t172,
                        t173,
                        t174,
                        t175,
                        t176,
                        t177,
                    ],
                    [
                        t178,
                        t138,
                        T::from_f64(0.0),
                        t157,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t188,
                        t189,
                        t190,
                        t191,
                        t192,
                        t193,
                    ],
                    [
                        t158,
                        t178,
                        t136,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t202,
                        t203,
                        t204,
                        t205,
                        t206,
                        t207,
                    ],
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t208,
                        t210,
                        t212,
                        t310,
                        t311,
                        t312,
                        t313,
                        t314,
                        t315,
                    ],
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t209,
                        T::from_f64(0.0),
                        t213,
                        t210,
                        t401,
                        t402,
                        t403,
                        t404,
                        t405,
                        t406,
                    ],
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t211,
                        t212,
                        T::from_f64(0.0),
                        t209,
                        t471,
                        t472,
                        t473,
                        t474,
                        t475,
                        t476,
                    ],
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t213,
                        t211,
                        t208,
                        T::from_f64(0.0),
                        t524,
                        t525,
                        t526,
                        t527,
                        t528,
                        t529,
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
                        t552,
                        t553,
                        t554,
                        t555,
                        t556,
                        t557,
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
                        t581,
                        t582,
                        t583,
                        t584,
                        t585,
                        t586,
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
                        t608,
                        t609,
                        t610,
                        t611,
                        t612,
                        t613,
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
                        t634,
                        t635,
                        t636,
                        t639,
                        t637,
                        t638,
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
                        t653,
                        t654,
                        t655,
                        t656,
                        t658,
                        t657,
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
                        t663,
                        t664,
                        t665,
                        t666,
                        t667,
                        t668,
                    ],
                ]),
            )
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
        #[inline]
        fn kinetic(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 14>) -> T {
            let [_, _, _, _, qw_b, qx_b, qy_b, qz_b, qdx_a, qdy_a, qdz_a, qdx_b, qdy_b,
            qdz_b] = x.data.0[0];
            let t0 = qx_b * qx_b;
            let t1 = qy_b * qy_b;
            let t2 = T::from_f64(1.0) - T::from_f64(2.0) * (t0 + t1);
            let t3 = qx_b * qz_b;
            let t4 = qy_b * qw_b;
            let t5 = T::from_f64(2.0) * (t3 + t4);
            let t6 = T::from_f64(2.0) * (t3 - t4);
            let t7 = qy_b * qz_b;
            let t8 = qx_b * qw_b;
            let t9 = T::from_f64(2.0) * (t7 - t8);
            let t10 = T::from_f64(2.0) * (t7 + t8);
            let t11 = T::from_f64(0.001)
                * (qdz_b + qdz_a * t2 + qdx_a * t5 + qdy_a * t9);
            let t12 = qx_b * qy_b;
            let t13 = qz_b * qw_b;
            let t14 = T::from_f64(2.0) * (t12 - t13);
            let t15 = T::from_f64(2.0) * (t12 + t13);
            let t16 = qz_b * qz_b;
            let t17 = T::from_f64(1.0) - T::from_f64(2.0) * (t0 + t16);
            let t18 = T::from_f64(1.0) - T::from_f64(2.0) * (t1 + t16);
            let t19 = qdy_b + qdz_a * t10 + qdx_a * t14 + qdy_a * t17;
            let t20 = T::from_f64(0.5) * qdx_a;
            let t21 = T::from_f64(0.5) * qdy_a;
            let t22 = T::from_f64(0.0305) * t19
                - T::from_f64(0.12) * (t15 * t20 - t18 * t21);
            let t23 = T::from_f64(0.12) * t19;
            let t24 = qdx_b + qdz_a * t6 + qdx_a * t18 + qdy_a * t15;
            let t25 = T::from_f64(0.12) * (t17 * t20 - t14 * t21)
                + T::from_f64(0.03146) * t24;
            let t26 = qdz_a
                * (T::from_f64(0.00016) * qdz_a + t6 * t25 + t10 * t22 + t2 * t11);
            let t27 = T::from_f64(0.12) * t24;
            let t28 = t15 * t25 + t17 * t22 + t9 * t11
                + T::from_f64(0.21674666666666667) * qdy_a
                - T::from_f64(0.5) * (t14 * t27 - t18 * t23);
            let t29 = T::from_f64(0.5) * (t17 * t27 - t15 * t23) + t18 * t25 + t14 * t22;
            let t30 = qdz_b * t11 + qdy_b * t22 + qdx_b * t25 + t26
                + qdx_a * (t29 + t5 * t11 + T::from_f64(0.21674666666666667) * qdx_a);
            T::from_f64(0.5) * (t30 + qdy_a * t28)
        }
        #[inline]
        fn potential(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 14>) -> T {
            let [qw_a, qx_a, qy_a, qz_a, qw_b, qx_b, qy_b, qz_b, _, _, _, _, _, _] = x
                .data
                .0[0];
            let t0 = (T::from_f64(1.0) - T::from_f64(2.0) * (qx_a * qx_a + qy_a * qy_a))
                * (T::from_f64(-0.3)
                    - (T::from_f64(0.12)
                        - T::from_f64(0.24) * (qx_b * qx_b + qy_b * qy_b))
                    - T::from_f64(0.2));
            let t1 = (qx_a * qz_a - qy_a * qw_a) * (qx_b * qz_b + qy_b * qw_b)
                + (qy_a * qz_a + qx_a * qw_a) * (qy_b * qz_b - qx_b * qw_b);
            T::from_f64(9.81) * (t0 - T::from_f64(0.48) * t1)
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> BallPendulum<T> {
        ///The momenta of the coordinates: the mass matrix times their rates.
        #[inline]
        pub fn momentum(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 14>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 6> {
            let [_, _, _, _, qw_b, qx_b, qy_b, qz_b, qdx_a, qdy_a, qdz_a, qdx_b, qdy_b,
            qdz_b] = x.data.0[0];
            let t0 = qx_b * qx_b;
            let t1 = qz_b * qz_b;
            let t2 = T::from_f64(1.0) - T::from_f64(2.0) * (t0 + t1);
            let t3 = qx_b * qz_b;
            let t4 = qy_b * qw_b;
            let t5 = T::from_f64(2.0) * (t3 - t4);
            let t6 = T::from_f64(2.0) * (t3 + t4);
            let t7 = qy_b * qy_b;
            let t8 = T::from_f64(1.0) - T::from_f64(2.0) * (t1 + t7);
            let t9 = T::from_f64(1.0) - T::from_f64(2.0) * (t0 + t7);
            let t10 = qx_b * qy_b;
            let t11 = qz_b * qw_b;
            let t12 = T::from_f64(2.0) * (t10 + t11);
            let t13 = T::from_f64(2.0) * (t10 - t11);
            let t14 = qdx_b + qdz_a * t5 + qdx_a * t8 + qdy_a * t12;
            let t15 = T::from_f64(0.12) * t14;
            let t16 = qz_b * qy_b;
            let t17 = qx_b * qw_b;
            let t18 = T::from_f64(2.0) * (t16 + t17);
            let t19 = T::from_f64(2.0) * (t16 - t17);
            let t20 = T::from_f64(0.001)
                * (qdz_b + qdz_a * t9 + qdx_a * t6 + qdy_a * t19);
            let t21 = qdy_b + qdz_a * t18 + qdx_a * t13 + t2 * qdy_a;
            let t22 = T::from_f64(0.12) * t21;
            let t23 = T::from_f64(0.5) * qdx_a;
            let t24 = T::from_f64(0.5) * qdy_a;
            let t25 = T::from_f64(0.12) * (t2 * t23 - t13 * t24)
                + T::from_f64(0.03146) * t14;
            let t26 = T::from_f64(0.0305) * t21
                - T::from_f64(0.12) * (t12 * t23 - t8 * t24);
            let t27 = T::from_f64(0.5) * (t2 * t15 - t12 * t22) + t8 * t25 + t13 * t26;
            ::pendulum_core::nalgebra::SVector::from([
                t27 + t6 * t20 + T::from_f64(0.21674666666666667) * qdx_a,
                t12 * t25 + t2 * t26 + t19 * t20
                    + T::from_f64(0.21674666666666667) * qdy_a
                    - T::from_f64(0.5) * (t15 * t13 - t8 * t22),
                T::from_f64(0.00016) * qdz_a + t5 * t25 + t18 * t26 + t9 * t20,
                t25,
                t26,
                t20,
            ])
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::shapes::Shapes<14> for BallPendulum {
        fn shapes(
            &self,
            t: f64,
            x: &::pendulum_core::nalgebra::SVector<f64, 14>,
        ) -> ::pendulum_core::shapes::Vec<::pendulum_core::shapes::Shape> {
            use ::pendulum_core::real::Real as _;
            type T = f64;
            ::pendulum_core::shapes::placed(
                &[
                    ::pendulum_core::shapes::Outline {
                        name: "rod",
                        kind: ::pendulum_core::shapes::ShapeKind::Cylinder,
                        points: 2,
                        radius: true,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "board",
                        kind: ::pendulum_core::shapes::ShapeKind::Cuboid,
                        points: 8,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "rod",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "board",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "tip",
                        kind: ::pendulum_core::shapes::ShapeKind::Point,
                        points: 1,
                        radius: false,
                    },
                ],
                &{
                    let [qw_a, qx_a, qy_a, qz_a, qw_b, qx_b, qy_b, qz_b, _, _, _, _, _, _,
                    ] = x.data.0[0];
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
                    let t13 = T::from_f64(1.0) - T::from_f64(2.0) * (t11 + t12);
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
                    let t27 = T::from_f64(1.0) - T::from_f64(2.0) * (t25 + t26);
                    let t28 = T::from_f64(0.5) + T::from_f64(0.02) * t27;
                    let t29 = T::from_f64(0.5) + T::from_f64(0.38) * t27;
                    let t30 = t23 - t28;
                    let t31 = qz_a * qz_a;
                    let t32 = T::from_f64(1.0) - T::from_f64(2.0) * (t12 + t31);
                    let t33 = T::from_f64(1.0) - T::from_f64(2.0) * (t11 + t31);
                    let t34 = qz_b * qz_b;
                    let t35 = T::from_f64(0.01) - T::from_f64(0.02) * (t26 + t34);
                    let t36 = T::from_f64(0.07) - T::from_f64(0.14) * (t25 + t34);
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
                    let t54 = -(t5 * t29 + t32 * t44 + t48 * t53);
                    let t55 = t10 * t29 - t49 * t44 - t33 * t53;
                    let t56 = -(t13 * t29 + t3 * t44 + t9 * t53);
                    let t57 = t50 - t52;
                    let t58 = t5 * t30 + t32 * t45 + t48 * t57;
                    let t59 = t45 * t49 + t57 * t33 - t30 * t10;
                    let t60 = t13 * t30 + t45 * t3 + t57 * t9;
                    let t61 = t24 + t28;
                    let t62 = t43 + t42;
                    let t63 = t52 + t51;
                    let t64 = -(t5 * t61 + t32 * t62 + t48 * t63);
                    let t65 = t10 * t61 - t49 * t62 - t33 * t63;
                    let t66 = -(t13 * t61 + t3 * t62 + t9 * t63);
                    let t67 = t24 - t28;
                    let t68 = t23 + t28;
                    let t69 = t42 - t43;
                    let t70 = t41 + t43;
                    let t71 = t51 - t52;
                    let t72 = t5 * t67 + t32 * t69 + t48 * t71;
                    let t73 = t49 * t69 + t33 * t71 - t10 * t67;
                    let t74 = t13 * t67 + t3 * t69 + t9 * t71;
                    let t75 = t50 + t52;
                    let t76 = -(t5 * t68 + t32 * t70 + t48 * t75);
                    let t77 = t10 * t68 - t49 * t70 - t33 * t75;
                    let t78 = -(t13 * t68 + t3 * t70 + t9 * t75);
                    let t79 = t23 - t29;
                    let t80 = t23 + t29;
                    let t81 = t41 - t44;
                    let t82 = t41 + t44;
                    let t83 = t50 - t53;
                    let t84 = t5 * t79 + t32 * t81 + t48 * t83;
                    let t85 = t49 * t81 + t33 * t83 - t10 * t79;
                    let t86 = t13 * t79 + t3 * t81 + t9 * t83;
                    let t87 = t50 + t53;
                    let t88 = -(t5 * t80 + t32 * t82 + t48 * t87);
                    let t89 = t10 * t80 - t49 * t82 - t33 * t87;
                    let t90 = -(t13 * t80 + t3 * t82 + t9 * t87);
                    let t91 = t24 + t29;
                    let t92 = t24 - t29;
                    let t93 = t42 + t44;
                    let t94 = t42 - t44;
                    let t95 = t51 + t53;
                    let t96 = t51 - t53;
                    let t97 = -(t5 * t91 + t32 * t93 + t48 * t95);
                    let t98 = t5 * t92 + t32 * t94 + t48 * t96;
                    let t99 = t10 * t91 - t49 * t93 - t33 * t95;
                    let t100 = -(t13 * t91 + t3 * t93 + t9 * t95);
                    let t101 = t49 * t94 + t33 * t96 - t10 * t92;
                    let t102 = t13 * t92 + t3 * t94 + t9 * t96;
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
                },
            )
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
