#[allow(non_snake_case)]
mod __DoublePendulum {
    ///Parameters of [`DoublePendulum`].
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct DoublePendulumParams {
        /// Mass of each plate.
        ///In kg.
        pub m: f64,
        /// Half the width of each plate.
        ///In m.
        pub w: f64,
        /// Height of a plate above its axle.
        ///In m.
        pub top: f64,
        /// Length of a plate below its axle.
        ///In m.
        pub l: f64,
        /// Distance between the axles.
        ///In m.
        pub d: f64,
        ///In N m s.
        pub gamma: f64,
    }
    impl ::core::default::Default for DoublePendulumParams {
        #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
        fn default() -> Self {
            Self {
                m: 1f64,
                w: 0.12f64,
                top: 0.1f64,
                l: 1.1f64,
                d: 1f64,
                gamma: 0.02f64,
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl DoublePendulumParams {
        /// The names of the parameters, in the order of their declaration.
        pub const NAMES: [&'static str; 6] = ["m", "w", "top", "l", "d", "gamma"];
        /// The values of the parameters, in the order of [`NAMES`](Self::NAMES).
        pub const fn to_array(self) -> [f64; 6] {
            [self.m, self.w, self.top, self.l, self.d, self.gamma]
        }
        /// The parameters with these values, in the order of [`NAMES`](Self::NAMES).
        pub const fn from_array(values: [f64; 6]) -> Self {
            let [v0, v1, v2, v3, v4, v5] = values;
            Self {
                m: v0,
                w: v1,
                top: v2,
                l: v3,
                d: v4,
                gamma: v5,
            }
        }
    }
    /// Two rectangular plates that hang below each other, with friction in both axles.
    ///
    /**# Equations of motion

```text
A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints

A[theta1, theta1] = 1/3*m*w*top^3/(w*l + w*top) + 1/3*m*w*l^3/(w*l + w*top) + 1/3*m*w^3*top/(w*l + w*top)
    + 1/3*m*w^3*l/(w*l + w*top) + m*d^2
A[theta1, theta2] = -0.5*(m*w*top^2*d/(w*l + w*top) - m*w*l^2*d/(w*l + w*top))*cos(theta1 - theta2)
A[theta2, theta2] = 1/3*(m*w*top^3/(w*l + w*top) + m*w*l^3/(w*l + w*top) + m*w^3*top/(w*l + w*top)
    + m*w^3*l/(w*l + w*top))
b[theta1] = -(0.5*(m*w*top^2*d/(w*l + w*top) - m*w*l^2*d/(w*l + w*top))*dot(theta2)^2*sin(theta1 - theta2)
    + 4.905*(m*w*top^2/(w*l + w*top) - m*w*l^2/(w*l + w*top) - 2*m*d)*sin(theta1))
b[theta2] = 0.5*(m*w*top^2*d/(w*l + w*top) - m*w*l^2*d/(w*l + w*top))*dot(theta1)^2*sin(theta1 - theta2)
    - 4.905*(m*w*top^2/(w*l + w*top) - m*w*l^2/(w*l + w*top))*sin(theta2)
Q[theta1] = gamma*dot(theta2) - 2*gamma*dot(theta1)
Q[theta2] = gamma*dot(theta1) - gamma*dot(theta2)
```

# Constants, computed by `new`

```text
k0 = w
k1 = top
k2 = l
k3 = d
k4 = gamma
k5 = -d
k6 = 0.25*(m*w*top^2*d/(w*l + w*top) - m*w*l^2*d/(w*l + w*top))^2
k7 = 0.5*(m*w*top^2*d/(w*l + w*top) - m*w*l^2*d/(w*l + w*top))
k8 = 1/3*(m*w*top^3/(w*l + w*top) + m*w*l^3/(w*l + w*top) + m*w^3*top/(w*l + w*top) + m*w^3*l/(w*l + w*top))
k9 = 4.905*(m*w*top^2/(w*l + w*top) - m*w*l^2/(w*l + w*top) - 2*m*d)
k10 = 4.905*(m*w*top^2/(w*l + w*top) - m*w*l^2/(w*l + w*top))
k11 = 2*gamma
k12 = 1/36*(12*m^2*w*top^3*d^2/(w*l + w*top) + 12*m^2*w*l^3*d^2/(w*l + w*top) + 18*m^2*w^2*top^2*l^2*d^2/(w*l + w*top)^2 + 8*m^2*w^2*top^3*l^3/(w*l + w*top)^2 + 4*m^2*w^2*top^6/(w*l + w*top)^2 + 4*m^2*w^2*l^6/(w*l + w*top)^2 + 12*m^2*w^3*top*d^2/(w*l + w*top) + 12*m^2*w^3*l*d^2/(w*l + w*top) + 8*m^2*w^4*top*l^3/(w*l + w*top)^2 + 8*m^2*w^4*top^3*l/(w*l + w*top)^2 + 8*m^2*w^4*top^4/(w*l + w*top)^2 + 8*m^2*w^4*l^4/(w*l + w*top)^2 + 8*m^2*w^6*top*l/(w*l + w*top)^2 + 4*m^2*w^6*top^2/(w*l + w*top)^2 + 4*m^2*w^6*l^2/(w*l + w*top)^2 - 9*m^2*w^2*top^4*d^2/(w*l + w*top)^2 - 9*m^2*w^2*l^4*d^2/(w*l + w*top)^2)
k13 = -1/(1/3*(m*w*top^3/(w*l + w*top) + m*w*l^3/(w*l + w*top) + m*w^3*top/(w*l + w*top) + m*w^3*l/(w*l + w*top)))
k14 = -0.5*(m*w*top^2*d/(w*l + w*top) - m*w*l^2*d/(w*l + w*top))/(1/3*(m*w*top^3/(w*l + w*top) + m*w*l^3/(w*l + w*top) + m*w^3*top/(w*l + w*top) + m*w^3*l/(w*l + w*top)))
```
*/
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct DoublePendulum<T = f64> {
        params: DoublePendulumParams,
        constants: [T; 15],
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl DoublePendulum {
        /// Builds the model: checks the parameters, and computes once whatever depends on them alone.
        ///
        /// # Errors
        ///
        /// The first parameter, or combination of parameters, that is not finite or that no rigid body can
        /// have.
        pub fn new(
            params: DoublePendulumParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            #[inline]
            fn rules<T: ::pendulum_core::real::Real>(given: [T; 6]) -> [T; 2] {
                let [p_m, p_w, p_top, p_l, p_d, p_gamma] = given;
                [p_m, p_gamma]
            }
            #[inline]
            fn constants<T: ::pendulum_core::real::Real>(given: [T; 6]) -> [T; 15] {
                let [p_m, p_w, p_top, p_l, p_d, p_gamma] = given;
                let t0 = -p_d;
                let t1 = T::from_f64(2.0) * p_gamma;
                let t2 = p_w * p_l + p_w * p_top;
                let t3 = T::from_f64(1.0) / t2;
                let t4 = T::from_f64(1.0) / (t2 * t2);
                let t5 = p_top * p_top;
                let t6 = p_m * p_w;
                let t7 = t5 * t6;
                let t8 = p_l * p_l;
                let t9 = t8 * t6;
                let t10 = t3 * (p_d * t7) - t3 * (p_d * t9);
                let t11 = t3 * t7 - t3 * t9;
                let t12 = T::from_f64(0.25) * (t10 * t10);
                let t13 = T::from_f64(0.5) * t10;
                let t14 = T::from_f64(4.905) * (t11 - p_d * (T::from_f64(2.0) * p_m));
                let t15 = T::from_f64(4.905) * t11;
                let t16 = p_top * p_top * p_top;
                let t17 = p_l * p_l * p_l;
                let t18 = p_w * p_w * p_w;
                let t19 = p_m * t18;
                let t20 = t3 * (t16 * t6) + t3 * (t17 * t6) + t3 * (p_top * t19);
                let t21 = T::from_f64(0.3333333333333333) * (t20 + t3 * (p_l * t19));
                let t22 = T::from_f64(-1.0) / t21;
                let t23 = t13 * t22;
                let t24 = p_d * p_d;
                let t25 = p_m * p_m;
                let t26 = T::from_f64(12.0) * t25;
                let t27 = t18 * t26;
                let t28 = p_w * t26;
                let t29 = p_w * p_w;
                let t30 = t3 * (t24 * (t16 * t28)) + t3 * (t24 * (t17 * t28))
                    + t24 * (t8 * (t5 * (t29 * (T::from_f64(18.0) * t25)))) * t4;
                let t31 = T::from_f64(8.0) * t25;
                let t32 = t29 * (T::from_f64(9.0) * t25);
                let t33 = T::from_f64(4.0) * t25;
                let t34 = p_top * p_top * p_top * p_top;
                let t35 = t30 + t4 * (t17 * (t16 * (t29 * t31)))
                    - t4 * (t24 * (t32 * t34));
                let t36 = t29 * t33;
                let t37 = t35
                    + t4 * (t36 * (p_top * p_top * p_top * p_top * p_top * p_top));
                let t38 = p_l * p_l * p_l * p_l;
                let t39 = t37 - t4 * (t24 * (t32 * t38))
                    + t4 * (t36 * (p_l * p_l * p_l * p_l * p_l * p_l));
                let t40 = t39 + t3 * (t24 * (p_top * t27)) + t3 * (t24 * (p_l * t27));
                let t41 = t31 * (p_w * p_w * p_w * p_w);
                let t42 = t40 + t4 * (t17 * (p_top * t41)) + t4 * (p_l * (t16 * t41));
                let t43 = p_w * p_w * p_w * p_w * p_w * p_w;
                let t44 = t42 + t4 * (t34 * t41) + t4 * (t38 * t41)
                    + t4 * (p_l * (p_top * (t31 * t43)));
                let t45 = t33 * t43;
                let t46 = T::from_f64(0.027777777777777776)
                    * (t44 + t4 * (t5 * t45) + t4 * (t8 * t45));
                [
                    p_w,
                    p_top,
                    p_l,
                    p_d,
                    p_gamma,
                    t0,
                    t12,
                    t13,
                    t21,
                    t14,
                    t15,
                    t1,
                    t46,
                    t22,
                    t23,
                ]
            }
            let given = params.to_array();
            for (name, value) in DoublePendulumParams::NAMES.into_iter().zip(given) {
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
                        "the mass of a plate of `slab` must be positive",
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
            let constants = constants(given);
            let names: [&'static str; 15] = [
                "w",
                "top",
                "l",
                "d",
                "gamma",
                "-d",
                "0.25*(m*w*top^2*d/(w*l + w*top) - m*w*l^2*d/(w*l + w*top))^2",
                "0.5*(m*w*top^2*d/(w*l + w*top) - m*w*l^2*d/(w*l + w*top))",
                "1/3*(m*w*top^3/(w*l + w*top) + m*w*l^3/(w*l + w*top) + m*w^3*top/(w*l + w*top) + m*w^3*l/(w*l + w*top))",
                "4.905*(m*w*top^2/(w*l + w*top) - m*w*l^2/(w*l + w*top) - 2*m*d)",
                "4.905*(m*w*top^2/(w*l + w*top) - m*w*l^2/(w*l + w*top))",
                "2*gamma",
                "1/36*(12*m^2*w*top^3*d^2/(w*l + w*top) + 12*m^2*w*l^3*d^2/(w*l + w*top) + 18*m^2*w^2*top^2*l^2*d^2/(w*l + w*top)^2 + 8*m^2*w^2*top^3*l^3/(w*l + w*top)^2 + 4*m^2*w^2*top^6/(w*l + w*top)^2 + 4*m^2*w^2*l^6/(w*l + w*top)^2 + 12*m^2*w^3*top*d^2/(w*l + w*top) + 12*m^2*w^3*l*d^2/(w*l + w*top) + 8*m^2*w^4*top*l^3/(w*l + w*top)^2 + 8*m^2*w^4*top^3*l/(w*l + w*top)^2 + 8*m^2*w^4*top^4/(w*l + w*top)^2 + 8*m^2*w^4*l^4/(w*l + w*top)^2 + 8*m^2*w^6*top*l/(w*l + w*top)^2 + 4*m^2*w^6*top^2/(w*l + w*top)^2 + 4*m^2*w^6*l^2/(w*l + w*top)^2 - 9*m^2*w^2*top^4*d^2/(w*l + w*top)^2 - 9*m^2*w^2*l^4*d^2/(w*l + w*top)^2)",
                "-1/(1/3*(m*w*top^3/(w*l + w*top) + m*w*l^3/(w*l + w*top) + m*w^3*top/(w*l + w*top) + m*w^3*l/(w*l + w*top)))",
                "-0.5*(m*w*top^2*d/(w*l + w*top) - m*w*l^2*d/(w*l + w*top))/(1/3*(m*w*top^3/(w*l + w*top) + m*w*l^3/(w*l + w*top) + m*w^3*top/(w*l + w*top) + m*w^3*l/(w*l + w*top)))",
            ];
            for (name, value) in names.into_iter().zip(constants) {
                if !value.is_finite() {
                    let given: [_; 6] = ::core::array::from_fn(|n| (
                        DoublePendulumParams::NAMES[n],
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
        pub fn cast<T: ::pendulum_core::real::Real>(&self) -> DoublePendulum<T> {
            DoublePendulum {
                params: self.params,
                constants: self.constants.map(T::from_f64),
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> DoublePendulum<T> {
        /// The parameters that the model was built from.
        pub fn params(&self) -> &DoublePendulumParams {
            &self.params
        }
        /// The model with other parameters, in the same number type. Its constants are computed anew.
        ///
        /// # Errors
        ///
        /// Those of `new`.
        pub fn with_params(
            &self,
            params: DoublePendulumParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            Ok(<DoublePendulum>::new(params)?.cast())
        }
    }
    impl DoublePendulum {
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
                            ::pendulum_core::Operations::new(12, 20, 1, 2, 0, 33),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L",
                                    ::pendulum_core::Operations::new(12, 20, 1, 2, 0, 33),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, L^T D L",
                                    ::pendulum_core::Operations::new(12, 21, 1, 2, 0, 32),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, adjugate",
                                    ::pendulum_core::Operations::new(26, 32, 1, 2, 0, 38),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C, adjugate",
                                    ::pendulum_core::Operations::new(31, 40, 1, 2, 0, 39),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "articulated bodies",
                                    ::pendulum_core::Operations::new(32, 48, 2, 2, 0, 50),
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
        pub const EQUATIONS: &'static str = "A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints\n\nA[theta1, theta1] = 1/3*m*w*top^3/(w*l + w*top) + 1/3*m*w*l^3/(w*l + w*top) + 1/3*m*w^3*top/(w*l + w*top)\n    + 1/3*m*w^3*l/(w*l + w*top) + m*d^2\nA[theta1, theta2] = -0.5*(m*w*top^2*d/(w*l + w*top) - m*w*l^2*d/(w*l + w*top))*cos(theta1 - theta2)\nA[theta2, theta2] = 1/3*(m*w*top^3/(w*l + w*top) + m*w*l^3/(w*l + w*top) + m*w^3*top/(w*l + w*top)\n    + m*w^3*l/(w*l + w*top))\nb[theta1] = -(0.5*(m*w*top^2*d/(w*l + w*top) - m*w*l^2*d/(w*l + w*top))*dot(theta2)^2*sin(theta1 - theta2)\n    + 4.905*(m*w*top^2/(w*l + w*top) - m*w*l^2/(w*l + w*top) - 2*m*d)*sin(theta1))\nb[theta2] = 0.5*(m*w*top^2*d/(w*l + w*top) - m*w*l^2*d/(w*l + w*top))*dot(theta1)^2*sin(theta1 - theta2)\n    - 4.905*(m*w*top^2/(w*l + w*top) - m*w*l^2/(w*l + w*top))*sin(theta2)\nQ[theta1] = gamma*dot(theta2) - 2*gamma*dot(theta1)\nQ[theta2] = gamma*dot(theta1) - gamma*dot(theta2)\n";
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::System<T, 4>
    for DoublePendulum<T> {
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn rhs(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 4> {
            let [q_theta1, q_theta2, qd_theta1, qd_theta2] = x.data.0[0];
            let k4 = self.constants[4];
            let k6 = self.constants[6];
            let k7 = self.constants[7];
            let k8 = self.constants[8];
            let k9 = self.constants[9];
            let k10 = self.constants[10];
            let k11 = self.constants[11];
            let k12 = self.constants[12];
            let k13 = self.constants[13];
            let k14 = self.constants[14];
            let [(sin_theta1, cos_theta1), (sin_theta2, cos_theta2)] = q_theta1
                .sin_cos_pair(q_theta2);
            let t0 = sin_theta1 * cos_theta2 - cos_theta1 * sin_theta2;
            let t1 = k7 * t0;
            let t2 = k4 * qd_theta2 + qd_theta1 * (qd_theta1 * t1 - k4)
                - k10 * sin_theta2;
            let t3 = k14 * (cos_theta2 * cos_theta1 + sin_theta1 * sin_theta2);
            let t4 = k11 * qd_theta1 - k9 * sin_theta1
                - qd_theta2 * (k4 + qd_theta2 * t1) - t2 * t3;
            let t5 = k8 / (k12 + k6 * t0 * t0) * t4;
            ::pendulum_core::nalgebra::SVector::from([
                qd_theta1,
                qd_theta2,
                -t5,
                k13 * t2 + t3 * t5,
            ])
        }
        #[inline]
        fn layout(
            &self,
        ) -> ::core::option::Option<&'static ::pendulum_core::StateLayout> {
            Some(&<DoublePendulum>::LAYOUT)
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::shapes::Shapes<4> for DoublePendulum {
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
                        name: "upper",
                        kind: ::pendulum_core::shapes::ShapeKind::Plate,
                        points: 4,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "lower",
                        kind: ::pendulum_core::shapes::ShapeKind::Plate,
                        points: 4,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "upper",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "lower",
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
                    let [q_theta1, q_theta2, _, _] = x.data.0[0];
                    let k0 = self.constants[0];
                    let k1 = self.constants[1];
                    let k2 = self.constants[2];
                    let k3 = self.constants[3];
                    let k5 = self.constants[5];
                    let [(sin_theta1, cos_theta1), (sin_theta2, cos_theta2)] = q_theta1
                        .sin_cos_pair(q_theta2);
                    let t0 = k5 * cos_theta1;
                    let t1 = k0 * cos_theta1;
                    let t2 = k1 * sin_theta1;
                    let t3 = -(t1 + t2);
                    let t4 = t1 - t2;
                    let t5 = k1 * cos_theta1;
                    let t6 = k0 * sin_theta1;
                    let t7 = t5 - t6;
                    let t8 = t5 + t6;
                    let t9 = k2 * sin_theta1;
                    let t10 = t9 - t1;
                    let t11 = t1 + t9;
                    let t12 = k2 * cos_theta1;
                    let t13 = -(t6 + t12);
                    let t14 = t6 - t12;
                    let t15 = k3 * sin_theta1;
                    let t16 = t15 - k1 * sin_theta2;
                    let t17 = t15 + k2 * sin_theta2;
                    let t18 = k0 * cos_theta2;
                    let t19 = t16 - t18;
                    let t20 = t18 + t16;
                    let t21 = t17 - t18;
                    let t22 = t18 + t17;
                    let t23 = k3 * cos_theta1;
                    let t24 = k1 * cos_theta2 - t23;
                    let t25 = t23 + k2 * cos_theta2;
                    let t26 = k0 * sin_theta2;
                    let t27 = t24 - t26;
                    let t28 = t26 + t24;
                    let t29 = -(t26 + t25);
                    let t30 = t26 - t25;
                    let t31 = -t25;
                    [
                        t3,
                        t7,
                        T::from_f64(0.0),
                        t10,
                        t13,
                        T::from_f64(0.0),
                        t11,
                        t14,
                        T::from_f64(0.0),
                        t4,
                        t8,
                        T::from_f64(0.0),
                        t19,
                        t27,
                        T::from_f64(0.0),
                        t21,
                        t29,
                        T::from_f64(0.0),
                        t22,
                        t30,
                        T::from_f64(0.0),
                        t20,
                        t28,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t15,
                        t0,
                        T::from_f64(0.0),
                        t17,
                        t31,
                        T::from_f64(0.0),
                    ]
                },
            )
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::Cast<4> for DoublePendulum {
        type In<T: ::pendulum_core::real::Real> = DoublePendulum<T>;
        fn cast<T: ::pendulum_core::real::Real>(&self) -> DoublePendulum<T> {
            DoublePendulum::cast(self)
        }
        #[inline]
        fn gather<'m, T: ::pendulum_core::real::lanes::Lanes>(
            models: impl ::core::ops::Fn(usize) -> &'m Self,
        ) -> DoublePendulum<T>
        where
            Self: 'm,
        {
            let scalar = <<T as ::pendulum_core::real::lanes::Lanes>::Scalar as ::pendulum_core::real::Real>::from_f64;
            DoublePendulum {
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
use __DoublePendulum::{DoublePendulum, DoublePendulumParams};
