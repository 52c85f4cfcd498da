#[allow(non_snake_case)]
mod __Magnets {
    ///Parameters of [`Magnets`].
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct MagnetsParams {
        ///In kg.
        pub m: f64,
        ///In m.
        pub l: f64,
        ///In N m^4.
        pub k: f64,
        ///In N m s.
        pub gamma: f64,
    }
    impl ::core::default::Default for MagnetsParams {
        #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
        fn default() -> Self {
            Self {
                m: 0.2f64,
                l: 0.3f64,
                k: 0.0002f64,
                gamma: 0.0002f64,
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl MagnetsParams {
        /// Names of the parameters, in the order of their declaration.
        pub const NAMES: [&'static str; 4] = ["m", "l", "k", "gamma"];
        /// Returns the values of the parameters, in the order of [`NAMES`](Self::NAMES).
        pub const fn to_array(self) -> [f64; 4] {
            [self.m, self.l, self.k, self.gamma]
        }
        /// Builds parameters from their values, in the order of [`NAMES`](Self::NAMES).
        pub const fn from_array(values: [f64; 4]) -> Self {
            let [v0, v1, v2, v3] = values;
            Self {
                m: v0,
                l: v1,
                k: v2,
                gamma: v3,
            }
        }
    }
    /// Two rods with magnets at their ends, above two magnets.
    ///
    /**# Equations of motion

```text
A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q all other forces

A[theta1, theta1] = 5/3*m*l^2 + m*l^2*c2
A[theta1, theta2] = 1/3*m*l^2 + 0.5*m*l^2*c2
A[theta2, theta2] = 1/3*m*l^2
b[theta1] = 4.905*m*l*s12 + 14.715*m*l*s1 - 0.5*m*l^2*dot(theta2)^2*s2 - m*l^2*dot(theta1)*dot(theta2)*s2
b[theta2] = 0.5*m*l^2*dot(theta1)^2*s2 + 4.905*m*l*s12
Q[theta1] = -(gamma*dot(theta1) + k*(1.5*(2*l*cos(theta1)*t7 + 2*l*s1*t8)*sqrt(t9)/t9^3
    + 1.5*(2*l*s1*t8 + 2*l*cos(theta1)*t10)*sqrt(t11)/t11^3 - 1.5*(2*t1*t2 + 2*t0*t3)*sqrt(t4)/t4^3
    - 1.5*(2*t0*t3 + 2*t1*t5)*sqrt(t6)/t6^3))
Q[theta2] = k*(1.5*sqrt(t4)*(2*l*cos(theta1 + theta2)*t2 + 2*l*s12*t3)/t4^3
    + 1.5*sqrt(t6)*(2*l*s12*t3 + 2*l*cos(theta1 + theta2)*t5)/t6^3) - gamma*dot(theta2)

where
s1 = sin(theta1)
c2 = cos(theta2)
s2 = sin(theta2)
s12 = sin(theta1 + theta2)
t0 = l*s1 + l*s12
t1 = l*cos(theta1) + l*cos(theta1 + theta2)
t2 = -0.15 - t0
t3 = t1 - 0.66
t4 = t2^2 + t3^2
t5 = 0.2 - t0
t6 = t3^2 + t5^2
t7 = -0.15 - l*s1
t8 = l*cos(theta1) - 0.66
t9 = t7^2 + t8^2
t10 = 0.2 - l*s1
t11 = t8^2 + t10^2
```

# Constants, computed by `new`

```text
k0 = m
k1 = l
k2 = k
k3 = gamma
k4 = -l
k5 = l^2
k6 = 0.5*m*l
k7 = 1/12*m*l^2 + m*(0.5*l)^2
k8 = 1/12*m*l^2 + m*(0.5*l)^2 + m*l^2
k9 = m*l^2
k10 = 0.3*l
k11 = 1.32*l
k12 = 1000/1527*l
k13 = 4400/1527*l
k14 = 10000/4581*l^2
k15 = 0.4*l
k16 = 1000/1189*l
k17 = 3300/1189*l
k18 = 2500/1189*l^2
k19 = 2*l^2
k20 = 20000/4581*l^2
k21 = 5000/1189*l^2
k22 = l*k
k23 = l^2*k
k24 = 1/3*m*l^2
k25 = 0.5*m*l^2
k26 = 4.905*m*l
k27 = 7/36*(m*l^2)^2
k28 = 0.25*(m*l^2)^2
k29 = 14.715*m*l
k30 = 220000000000/10681650549*l*k
k31 = 30937500000/1680914269*l*k
k32 = 50000000000/10681650549*l*k
k33 = 9375000000/1680914269*l*k
k34 = 1000000000000/32044951647*l^2*k
k35 = 46875000000/1680914269*l^2*k
k36 = -1/(1/3*m*l^2)
k37 = -1
k38 = -0.5/(1/3)
k39 = 9.81*(0.5*m*l + m*l)
k40 = l^3*k
k41 = 100000000000000000/146797923494907*l^4*k
k42 = 5000000000000000/48932641164969*l^3*k
k43 = 1100000000000000/16310880388323*l^2*k
k44 = 22000000000000000/48932641164969*l^3*k
k45 = 5000000000000/146797923494907*(4131*l^2*k + 10000*l^4*k)
k46 = 1171875000000000/1998607065841*l^4*k
k47 = 234375000000000/1998607065841*l^3*k
k48 = 154687500000000/1998607065841*l^2*k
k49 = 773437500000000/1998607065841*l^3*k
k50 = 234375000000/1998607065841*(989*l^2*k + 2500*l^4*k)
k51 = 50000000000000000/146797923494907*l^4*k
k52 = 125000000000000/16310880388323*l^2*k
k53 = 585937500000000/1998607065841*l^4*k
k54 = 23437500000000/1998607065841*l^2*k
k55 = -gamma/(1/3*m*l^2)
k56 = 550000000000000/16310880388323*l^2*k
k57 = 77343750000000/1998607065841*l^2*k
```
*/
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Magnets<T = f64> {
        params: MagnetsParams,
        constants: [T; 58],
    }
    /// Constants of the model, from its parameters.
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    #[inline]
    fn constants<T: ::pendulum_core::real::Real>(given: [T; 4]) -> [T; 58] {
        let [p_m, p_l, p_k, p_gamma] = given;
        let t0 = -p_l;
        let t1 = T::from_f64(0.3) * p_l;
        let t2 = T::from_f64(1.32) * p_l;
        let t3 = T::from_f64(0.6548788474132285) * p_l;
        let t4 = T::from_f64(2.8814669286182055) * p_l;
        let t5 = T::from_f64(0.4) * p_l;
        let t6 = T::from_f64(0.8410428931875525) * p_l;
        let t7 = T::from_f64(2.7754415475189234) * p_l;
        let t8 = p_l * p_l;
        let t9 = T::from_f64(2.1829294913774286) * t8;
        let t10 = T::from_f64(2.1026072329688814) * t8;
        let t11 = T::from_f64(2.0) * t8;
        let t12 = T::from_f64(4.365858982754857) * t8;
        let t13 = T::from_f64(4.205214465937763) * t8;
        let t14 = T::from_f64(0.5) * p_l;
        let t15 = p_m * t14;
        let t16 = p_m.mul_add(t14 * t14, T::from_f64(0.08333333333333333) * p_m * t8);
        let t17 = p_m * p_l;
        let t18 = p_l.mul_add(t17, t16);
        let t19 = T::from_f64(9.81) * (t15 + t17);
        let t20 = T::from_f64(4.905) * t17;
        let t21 = T::from_f64(14.715) * t17;
        let t22 = p_m * t8;
        let t23 = p_l * p_k;
        let t24 = T::from_f64(20.596067900816703) * t23;
        let t25 = T::from_f64(18.40516233966243) * t23;
        let t26 = T::from_f64(4.680924522912886) * t23;
        let t27 = T::from_f64(5.577321921109827) * t23;
        let t28 = p_k * t8;
        let t29 = T::from_f64(31.206163486085913) * t28;
        let t30 = T::from_f64(27.886609605549133) * t28;
        let t31 = T::from_f64(67.43964604065718) * t28;
        let t32 = T::from_f64(77.39765491868137) * t28;
        let t33 = T::from_f64(7.6635961409837705) * t28;
        let t34 = T::from_f64(11.726917411921418) * t28;
        let t35 = T::from_f64(33.71982302032859) * t28;
        let t36 = T::from_f64(38.698827459340684) * t28;
        let t37 = T::from_f64(0.3333333333333333) * t22;
        let t38 = T::from_f64(0.5) * t22;
        let t39 = t22 * t22;
        let t40 = T::from_f64(0.19444444444444445) * t39;
        let t41 = T::from_f64(0.25) * t39;
        let t42 = T::from_f64(-1.0) / t37;
        let t43 = t37 * t42;
        let t44 = t38 * t42;
        let t45 = p_gamma * t42;
        let t46 = p_k * (p_l * p_l * p_l);
        let t47 = T::from_f64(102.1812818797836) * t46;
        let t48 = T::from_f64(449.59764027104785) * t46;
        let t49 = T::from_f64(117.26917411921418) * t46;
        let t50 = T::from_f64(386.9882745934068) * t46;
        let t51 = p_l * p_l * p_l * p_l;
        let t52 = T::from_f64(0.0340604272932612)
            * p_k.mul_add(T::from_f64(10000.0) * t51, p_k * (T::from_f64(4131.0) * t8));
        let t53 = T::from_f64(0.11726917411921418)
            * p_k.mul_add(T::from_f64(2500.0) * t51, p_k * (T::from_f64(989.0) * t8));
        let t54 = p_k * t51;
        let t55 = T::from_f64(681.208545865224) * t54;
        let t56 = T::from_f64(586.3458705960709) * t54;
        let t57 = T::from_f64(340.604272932612) * t54;
        let t58 = T::from_f64(293.17293529803544) * t54;
        [
            p_m,
            p_l,
            p_k,
            p_gamma,
            t0,
            t8,
            t15,
            t16,
            t18,
            t22,
            t1,
            t2,
            t3,
            t4,
            t9,
            t5,
            t6,
            t7,
            t10,
            t11,
            t12,
            t13,
            t23,
            t28,
            t37,
            t38,
            t20,
            t40,
            t41,
            t21,
            t24,
            t25,
            t26,
            t27,
            t29,
            t30,
            t42,
            t43,
            t44,
            t19,
            t46,
            t55,
            t47,
            t31,
            t48,
            t52,
            t56,
            t49,
            t32,
            t50,
            t53,
            t57,
            t33,
            t58,
            t34,
            t45,
            t35,
            t36,
        ]
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl Magnets {
        /// Builds the model: checks the parameters, and computes all constants that depend on them alone.
        ///
        /// # Errors
        ///
        /// Returns the first parameter, or combination of parameters, that is not finite or is impossible for a
        /// rigid body.
        pub fn new(
            params: MagnetsParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            #[inline]
            fn rules<T: ::pendulum_core::real::Real>(given: [T; 4]) -> [T; 2] {
                let [p_m, p_l, p_k, p_gamma] = given;
                [p_m, p_gamma]
            }
            let given = params.to_array();
            for (name, value) in MagnetsParams::NAMES.into_iter().zip(given) {
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
                        "the mass of a rod of `arm` must be positive",
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
            let names: [&'static str; 58] = [
                "m",
                "l",
                "k",
                "gamma",
                "-l",
                "l^2",
                "0.5*m*l",
                "1/12*m*l^2 + m*(0.5*l)^2",
                "1/12*m*l^2 + m*(0.5*l)^2 + m*l^2",
                "m*l^2",
                "0.3*l",
                "1.32*l",
                "1000/1527*l",
                "4400/1527*l",
                "10000/4581*l^2",
                "0.4*l",
                "1000/1189*l",
                "3300/1189*l",
                "2500/1189*l^2",
                "2*l^2",
                "20000/4581*l^2",
                "5000/1189*l^2",
                "l*k",
                "l^2*k",
                "1/3*m*l^2",
                "0.5*m*l^2",
                "4.905*m*l",
                "7/36*(m*l^2)^2",
                "0.25*(m*l^2)^2",
                "14.715*m*l",
                "220000000000/10681650549*l*k",
                "30937500000/1680914269*l*k",
                "50000000000/10681650549*l*k",
                "9375000000/1680914269*l*k",
                "1000000000000/32044951647*l^2*k",
                "46875000000/1680914269*l^2*k",
                "-1/(1/3*m*l^2)",
                "-1",
                "-0.5/(1/3)",
                "9.81*(0.5*m*l + m*l)",
                "l^3*k",
                "100000000000000000/146797923494907*l^4*k",
                "5000000000000000/48932641164969*l^3*k",
                "1100000000000000/16310880388323*l^2*k",
                "22000000000000000/48932641164969*l^3*k",
                "5000000000000/146797923494907*(4131*l^2*k + 10000*l^4*k)",
                "1171875000000000/1998607065841*l^4*k",
                "234375000000000/1998607065841*l^3*k",
                "154687500000000/1998607065841*l^2*k",
                "773437500000000/1998607065841*l^3*k",
                "234375000000/1998607065841*(989*l^2*k + 2500*l^4*k)",
                "50000000000000000/146797923494907*l^4*k",
                "125000000000000/16310880388323*l^2*k",
                "585937500000000/1998607065841*l^4*k",
                "23437500000000/1998607065841*l^2*k",
                "-gamma/(1/3*m*l^2)",
                "550000000000000/16310880388323*l^2*k",
                "77343750000000/1998607065841*l^2*k",
            ];
            for (name, value) in names.into_iter().zip(constants) {
                if !value.is_finite() {
                    let given: [_; 4] = ::core::array::from_fn(|n| (
                        MagnetsParams::NAMES[n],
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
        pub fn cast<T: ::pendulum_core::real::Real>(&self) -> Magnets<T> {
            Magnets {
                params: self.params,
                constants: self.constants.map(T::from_f64),
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> Magnets<T> {
        /// Returns the parameters from which the model was built.
        pub fn params(&self) -> &MagnetsParams {
            &self.params
        }
        /// Returns a model with other parameters, in the same number type, and recomputes its constants.
        ///
        /// # Errors
        ///
        /// Returns the errors of `new`.
        pub fn with_params(
            &self,
            params: MagnetsParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            Ok(<Magnets>::new(params)?.cast())
        }
    }
    impl Magnets {
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
                            "recursion, adjugate",
                            ::pendulum_core::Operations::new(44, 75, 5, 2, 4, 44),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factored, L^T D L",
                                    ::pendulum_core::Operations::new(55, 72, 5, 2, 4, 47),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L",
                                    ::pendulum_core::Operations::new(54, 79, 5, 2, 4, 51),
                                ),
                            ],
                        ),
                ),
                (
                    "jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factored, L^T D L, derived and expanded",
                            ::pendulum_core::Operations::new(146, 194, 5, 2, 4, 57),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L, derived and expanded",
                                    ::pendulum_core::Operations::new(138, 212, 5, 2, 4, 62),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, inverse, derived in the graph",
                                    ::pendulum_core::Operations::new(118, 208, 13, 2, 4, 53),
                                ),
                            ],
                        ),
                ),
                (
                    "kinetic",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factored",
                            ::pendulum_core::Operations::new(4, 7, 0, 1, 0, 27),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(4, 7, 0, 1, 0, 25),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(12, 23, 0, 2, 0, 32),
                                ),
                            ],
                        ),
                ),
                (
                    "potential",
                    ::pendulum_core::FunctionCost::new(
                            "recursion",
                            ::pendulum_core::Operations::new(19, 15, 4, 2, 4, 38),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factored",
                                    ::pendulum_core::Operations::new(35, 28, 4, 2, 4, 40),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(35, 28, 4, 2, 4, 41),
                                ),
                            ],
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
            )
            .autonomous();
        /// Equations of motion as text.
        pub const EQUATIONS: &'static str = "A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q all other forces\n\nA[theta1, theta1] = 5/3*m*l^2 + m*l^2*c2\nA[theta1, theta2] = 1/3*m*l^2 + 0.5*m*l^2*c2\nA[theta2, theta2] = 1/3*m*l^2\nb[theta1] = 4.905*m*l*s12 + 14.715*m*l*s1 - 0.5*m*l^2*dot(theta2)^2*s2 - m*l^2*dot(theta1)*dot(theta2)*s2\nb[theta2] = 0.5*m*l^2*dot(theta1)^2*s2 + 4.905*m*l*s12\nQ[theta1] = -(gamma*dot(theta1) + k*(1.5*(2*l*cos(theta1)*t7 + 2*l*s1*t8)*sqrt(t9)/t9^3\n    + 1.5*(2*l*s1*t8 + 2*l*cos(theta1)*t10)*sqrt(t11)/t11^3 - 1.5*(2*t1*t2 + 2*t0*t3)*sqrt(t4)/t4^3\n    - 1.5*(2*t0*t3 + 2*t1*t5)*sqrt(t6)/t6^3))\nQ[theta2] = k*(1.5*sqrt(t4)*(2*l*cos(theta1 + theta2)*t2 + 2*l*s12*t3)/t4^3\n    + 1.5*sqrt(t6)*(2*l*s12*t3 + 2*l*cos(theta1 + theta2)*t5)/t6^3) - gamma*dot(theta2)\n\nwhere\ns1 = sin(theta1)\nc2 = cos(theta2)\ns2 = sin(theta2)\ns12 = sin(theta1 + theta2)\nt0 = l*s1 + l*s12\nt1 = l*cos(theta1) + l*cos(theta1 + theta2)\nt2 = -0.15 - t0\nt3 = t1 - 0.66\nt4 = t2^2 + t3^2\nt5 = 0.2 - t0\nt6 = t3^2 + t5^2\nt7 = -0.15 - l*s1\nt8 = l*cos(theta1) - 0.66\nt9 = t7^2 + t8^2\nt10 = 0.2 - l*s1\nt11 = t8^2 + t10^2\n";
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::System<T, 4> for Magnets<T> {
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn rhs(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 4> {
            let [q_theta1, q_theta2, qd_theta1, qd_theta2] = x.data.0[0];
            let k1 = self.constants[1];
            let k2 = self.constants[2];
            let k3 = self.constants[3];
            let k6 = self.constants[6];
            let k7 = self.constants[7];
            let k8 = self.constants[8];
            let k39 = self.constants[39];
            let t0 = q_theta1 + q_theta2;
            let t1 = qd_theta1 * qd_theta1;
            let t2 = qd_theta1 + qd_theta2;
            let [(sin_theta1, cos_theta1), (sin3, cos3)] = q_theta1.sin_cos_pair(t0);
            let t4 = k1 * cos_theta1;
            let t5 = k1 * cos3;
            let t6 = k1 * sin_theta1;
            let t7 = t4 + t5;
            let t8 = k1 * sin3;
            let t9 = t4 - T::from_f64(0.66);
            let t10 = t6 + t8;
            let t11 = t7 - T::from_f64(0.66);
            let t12 = T::from_f64(-0.15) - t6;
            let t13 = t9 * t9;
            let t14 = T::from_f64(2.0) * t6 * t9;
            let t15 = T::from_f64(0.2) - t6;
            let t16 = T::from_f64(-0.15) - t10;
            let t17 = t11 * t11;
            let t18 = T::from_f64(2.0) * t11;
            let t19 = t8 * t18;
            let t20 = t10 * t18;
            let t21 = T::from_f64(0.2) - t10;
            let t22 = t12.mul_add(t12, t13);
            let t23 = t15.mul_add(t15, t13);
            let t24 = t16.mul_add(t16, t17);
            let t25 = t21.mul_add(t21, t17);
            let t26 = T::from_f64(1.5) * t24.sqrt()
                * (T::from_f64(1.0) / (t24 * t24 * t24));
            let t27 = T::from_f64(1.5) * t25.sqrt()
                * (T::from_f64(1.0) / (t25 * t25 * t25));
            let t28 = T::from_f64(2.0) * t16;
            let t29 = T::from_f64(2.0) * t21;
            let t30 = k2 * t5.mul_add(t29, t19).mul_add(t27, t5.mul_add(t28, t19) * t26);
            let t31 = T::from_f64(2.0) * t4;
            let t32 = T::from_f64(1.0) / (t22 * t22 * t22)
                * (t12.mul_add(t31, t14) * t22.sqrt());
            let t33 = T::from_f64(1.0) / (t23 * t23 * t23)
                * (t15.mul_add(t31, t14) * t23.sqrt());
            let t34 = t7
                .mul_add(t29, t20)
                .mul_neg_add(
                    t27,
                    t7.mul_add(t28, t20).mul_neg_add(t26, T::from_f64(1.5) * (t32 + t33)),
                );
            let t35 = k7 * cos3 * cos3;
            let t36 = t35 + (k7 - t35);
            let t37 = k6 * sin3;
            let t38 = k6 * cos3;
            let t39 = k8 * cos_theta1 * cos_theta1;
            let t40 = t4.mul_add(t38, t6 * t37);
            let t41 = t6 * t38;
            let t42 = T::from_f64(2.0).mul_add(t40, k8 + t39 + t36) - t39;
            let t43 = t41.mul_neg_add(t1, t37 * t4.mul_add(t1, T::from_f64(9.81)));
            let t44 = t2
                .mul_add(
                    t2 * t37.mul_neg_add(t4, t41),
                    k39.mul_add(sin_theta1, k2.mul_add(t34, k3 * qd_theta1)) + t43,
                );
            let t45 = k3.mul_add(qd_theta2, t43) - t30;
            let t46 = t36 + t40;
            let t47 = T::from_f64(-1.0) / t46.mul_neg_add(t46, t42 * t36);
            ::pendulum_core::nalgebra::SVector::from([
                qd_theta1,
                qd_theta2,
                t47 * t46.mul_neg_add(t45, t36 * t44),
                t47 * t46.mul_neg_add(t44, t42 * t45),
            ])
        }
        #[inline]
        fn layout(&self) -> ::core::option::Option<::pendulum_core::StateLayout<'_>> {
            Some(<Magnets>::LAYOUT)
        }
    }
    struct __Code<'a, T> {
        t: T,
        x: &'a ::pendulum_core::nalgebra::SVector<T, 4>,
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<
        T: ::pendulum_core::real::Real,
    > ::pendulum_core::real::lanes::Routine<(), Magnets<T>> for __Code<'_, T> {
        type Output = (
            ::pendulum_core::nalgebra::SVector<T, 4>,
            ::pendulum_core::nalgebra::SMatrix<T, 4, 4>,
        );
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn run(
            self,
            (): &mut (),
            model: &Magnets<T>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 4>,
            ::pendulum_core::nalgebra::SMatrix<T, 4, 4>,
        ) {
            let Self { t, x } = self;
            let [q_theta1, q_theta2, qd_theta1, qd_theta2] = x.data.0[0];
            let k3 = model.constants[3];
            let k5 = model.constants[5];
            let k9 = model.constants[9];
            let k10 = model.constants[10];
            let k11 = model.constants[11];
            let k12 = model.constants[12];
            let k13 = model.constants[13];
            let k14 = model.constants[14];
            let k15 = model.constants[15];
            let k16 = model.constants[16];
            let k17 = model.constants[17];
            let k18 = model.constants[18];
            let k19 = model.constants[19];
            let k20 = model.constants[20];
            let k21 = model.constants[21];
            let k22 = model.constants[22];
            let k23 = model.constants[23];
            let k24 = model.constants[24];
            let k25 = model.constants[25];
            let k26 = model.constants[26];
            let k27 = model.constants[27];
            let k28 = model.constants[28];
            let k29 = model.constants[29];
            let k30 = model.constants[30];
            let k31 = model.constants[31];
            let k32 = model.constants[32];
            let k33 = model.constants[33];
            let k34 = model.constants[34];
            let k35 = model.constants[35];
            let k36 = model.constants[36];
            let k37 = model.constants[37];
            let k38 = model.constants[38];
            let k40 = model.constants[40];
            let k41 = model.constants[41];
            let k42 = model.constants[42];
            let k43 = model.constants[43];
            let k44 = model.constants[44];
            let k45 = model.constants[45];
            let k46 = model.constants[46];
            let k47 = model.constants[47];
            let k48 = model.constants[48];
            let k49 = model.constants[49];
            let k50 = model.constants[50];
            let k51 = model.constants[51];
            let k52 = model.constants[52];
            let k53 = model.constants[53];
            let k54 = model.constants[54];
            let k55 = model.constants[55];
            let k56 = model.constants[56];
            let k57 = model.constants[57];
            let t0 = qd_theta1 * qd_theta1;
            let [(sin_theta2, cos_theta2), (sin_theta1, cos_theta1)] = q_theta2
                .sin_cos_pair(q_theta1);
            let t1 = sin_theta2.mul_add(cos_theta1, sin_theta1 * cos_theta2);
            let t2 = k13
                .mul_neg_add(cos_theta1, k12.mul_add(sin_theta1, T::from_f64(1.0)));
            let t3 = sin_theta2.mul_neg_add(sin_theta1, cos_theta2 * cos_theta1);
            let t4 = k17
                .mul_neg_add(cos_theta1, k16.mul_neg_add(sin_theta1, T::from_f64(1.0)));
            let t5 = sin_theta1 * t1;
            let t6 = cos_theta1 * t3;
            let t7 = k13
                .mul_neg_add(
                    t3,
                    k20.mul_add(t6, k20.mul_add(t5, k12.mul_add(t1, k20 + t2))),
                );
            let t8 = T::from_f64(1.0) / t7;
            let t9 = T::from_f64(1.0) / (k14 + t2);
            let t10 = k17
                .mul_neg_add(
                    t3,
                    k16.mul_neg_add(t1, k21.mul_add(t6, k21.mul_add(t5, k21 + t4))),
                );
            let t11 = T::from_f64(1.0) / t10;
            let t12 = k11.mul_neg_add(t3, k19) + k19.mul_add(t6, k19 * t5);
            let t13 = T::from_f64(1.0) / (k18 + t4);
            let t14 = k11 * cos_theta1;
            let t15 = k10.mul_add(sin_theta1, T::from_f64(0.4581)) - t14;
            let t16 = k15.mul_neg_add(sin_theta1, T::from_f64(0.4756) - t14);
            let t17 = t8 * t8;
            let t18 = (k10.mul_add(t1, t15) + t12).sqrt() * t17;
            let t19 = t17 * t18;
            let t20 = t8 * t18;
            let t21 = t11 * t11;
            let t22 = k15.mul_neg_add(t1, t16 + t12).sqrt() * t21;
            let t23 = t21 * t22;
            let t24 = t11 * t22;
            let t25 = t13 * t13;
            let t26 = (k5 + t16).sqrt() * t25;
            let t27 = t9 * t9;
            let t28 = (k5 + t15).sqrt() * t27;
            let t29 = T::from_f64(18.40516233966243)
                .mul_add(t24, T::from_f64(20.596067900816703) * t20);
            let t30 = T::from_f64(5.577321921109827)
                .mul_neg_add(t24, T::from_f64(4.680924522912886) * t20);
            let t31 = t13 * t26;
            let t32 = t13.mul_neg_add(t31, t11 * t24);
            let t33 = t31 - t24;
            let t34 = t9 * t28;
            let t35 = t8.mul_neg_add(t20, t9 * t34);
            let t36 = sin_theta1
                .mul_add(
                    T::from_f64(115.97921320390283)
                        .mul_neg_add(t32, T::from_f64(140.703625148462) * t35),
                    cos_theta1
                        * T::from_f64(67.43964604065718)
                            .mul_add(t35, T::from_f64(77.39765491868137) * t32),
                );
            let t37 = t20 - t34;
            let t38 = k9 * sin_theta2;
            let t39 = k26 * t1;
            let t40 = k24 / (k28 * sin_theta2).mul_add(sin_theta2, k27);
            let t41 = qd_theta2.mul_neg_add(t38, k3);
            let t42 = t3.mul_add(t30, t1 * t29);
            let t43 = T::from_f64(4.680924522912886)
                .mul_add(t37, T::from_f64(5.577321921109827) * t33);
            let t44 = T::from_f64(18.40516233966243)
                .mul_neg_add(t33, T::from_f64(20.596067900816703) * t37);
            let t45 = k22
                * sin_theta1
                    .mul_neg_add(
                        t43,
                        t1.mul_neg_add(t30, t3.mul_add(t29, cos_theta1 * t44)),
                    );
            let t46 = k22
                .mul_add(
                    sin_theta1.mul_add(t44, cos_theta1.mul_add(t43, t42)),
                    qd_theta1.mul_add(t41, k29.mul_add(sin_theta1, t39)),
                );
            let t47 = sin_theta2
                .mul_add(
                    k25.mul_sub(t0, k35.mul_add(t24, k34 * t20)),
                    k3.mul_add(qd_theta2, t39),
                );
            let t48 = k22.mul_add(t42, t47);
            let t49 = cos_theta1.mul_add(t1, sin_theta1 * t3);
            let t50 = T::from_f64(115.97921320390283)
                .mul_neg_add(t1, T::from_f64(77.39765491868137) * t3);
            let t51 = (T::from_f64(23.453834823842836)
                .mul_neg_add(t6, t1.mul_add(t50, T::from_f64(77.39765491868137) * t49))
                - T::from_f64(23.453834823842836))
                .mul_add(
                    t23,
                    (T::from_f64(11.726917411921418) * t25)
                        .mul_add(t26, T::from_f64(7.6635961409837705) * t27 * t28),
                );
            let t52 = T::from_f64(140.703625148462)
                .mul_add(t1, T::from_f64(67.43964604065718) * t3);
            let t53 = t1
                .mul_add(
                    t52,
                    T::from_f64(67.43964604065718)
                        .mul_add(
                            t49,
                            T::from_f64(15.327192281967541)
                                .mul_add(t6, T::from_f64(15.327192281967541)),
                        ),
                )
                .mul_neg_add(
                    t19,
                    sin_theta1
                        .mul_add(
                            t1
                                .mul_neg_add(
                                    T::from_f64(255.4122612316485)
                                        .mul_add(t23, T::from_f64(296.73444257889156) * t19),
                                    t36,
                                ),
                            t51,
                        ),
                );
            let t54 = T::from_f64(58.63458705960709)
                .mul_add(cos_theta2, T::from_f64(58.63458705960709));
            let t55 = T::from_f64(51.0906409398918)
                .mul_add(cos_theta2, T::from_f64(51.0906409398918));
            let t56 = k50
                .mul_neg_add(
                    t1,
                    k48
                        .mul_add(
                            t3,
                            k49
                                .mul_add(
                                    sin_theta2,
                                    cos_theta2 * k46.mul_sub(sin_theta1, k47),
                                ),
                        ),
                );
            let t57 = k45
                .mul_neg_add(
                    t1,
                    k43
                        .mul_neg_add(
                            t3,
                            k44
                                .mul_add(
                                    sin_theta2,
                                    cos_theta2 * k41.mul_add(sin_theta1, k42),
                                ),
                        ),
                );
            let t58 = t1
                * t8.mul_sub(t57, k32).mul_add(t20, t11.mul_add(t56, k33) * t24);
            let t59 = T::from_f64(193.4941372967034) * sin_theta2;
            let t60 = t11
                .mul_add(
                    k23
                        .mul_add(
                            T::from_f64(127.70613061582425).mul_neg_add(sin_theta1, t50),
                            k40 * (t59 - t54),
                        ),
                    k33,
                );
            let t61 = T::from_f64(224.79882013552393) * sin_theta2;
            let t62 = t8
                .mul_sub(
                    k23
                        .mul_neg_add(
                            T::from_f64(148.36722128944578).mul_add(sin_theta1, t52),
                            k40 * (t61 + t55),
                        ),
                    k32,
                );
            let t63 = k38.mul_add(cos_theta2, k37);
            let t64 = t40
                * (k25 * sin_theta2 * qd_theta2)
                    .mul_neg_add(qd_theta2, t63.mul_add(t48, t46));
            let t65 = t63.mul_neg_add(t64, k36 * t48);
            let t66 = sin_theta2
                .mul_add(
                    T::from_f64(0.5).mul_sub(t65, t64),
                    qd_theta2 * cos_theta2
                        * T::from_f64(0.5).mul_add(qd_theta2, qd_theta1),
                );
            let t67 = -t64;
            let t68 = k40 * sin_theta1;
            let t69 = t11
                * (t59 + t54).mul_add(t68, k54.mul_neg_add(t6, k57 * t49) - k54);
            let t70 = t8
                * (t61 - t55).mul_sub(t68, k56.mul_add(t49, k52.mul_add(t6, k52)));
            let t71 = k31 * t3;
            let t72 = k35
                .mul_neg_add(
                    cos_theta2,
                    t11
                        .mul_add(
                            sin_theta1.mul_sub(k53.mul_neg_add(sin_theta1, k47), k54),
                            t71,
                        ),
                );
            let t73 = k30 * t3;
            let t74 = t8
                .mul_neg_add(
                    sin_theta1.mul_add(k51.mul_add(sin_theta1, k42), k52),
                    k34.mul_neg_add(cos_theta2, t73),
                );
            let t75 = k26 * t3;
            let t76 = (t71 + t69).mul_add(t24, t75)
                + t1.mul_add(t62.mul_add(t20, t60 * t24), (t73 + t70) * t20);
            let t77 = k25
                .mul_add(
                    sin_theta2.mul_add(t64, cos_theta2 * t0),
                    t72.mul_add(t24, t74.mul_add(t20, t75 + t58)),
                );
            let t78 = t40
                * t63.mul_add(t76, k23.mul_add(t53, k29.mul_add(cos_theta1, t75) + t45));
            let t79 = t40 * k9.mul_neg_add(t66, t63.mul_add(t77, t76));
            let t80 = t63.mul_neg_add(t78, k36 * t76);
            let t81 = t63.mul_neg_add(t79, k36 * t77);
            let t82 = -t78;
            let t83 = -t79;
            let t84 = qd_theta1 * t38;
            let t85 = t40 * (qd_theta1 + qd_theta2).mul_neg_add(t38, k3 * t63);
            let t86 = t40 * t63.mul_add(t84, t41);
            let t87 = t63.mul_neg_add(t86, k36 * t84);
            let t88 = t63.mul_neg_add(t85, k55);
            let t89 = -t86;
            let t90 = -t85;
            (
                ::pendulum_core::nalgebra::SVector::from([
                    qd_theta1,
                    qd_theta2,
                    t67,
                    t65,
                ]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [T::from_f64(0.0), T::from_f64(0.0), t82, t80],
                    [T::from_f64(0.0), T::from_f64(0.0), t83, t81],
                    [T::from_f64(1.0), T::from_f64(0.0), t89, t87],
                    [T::from_f64(0.0), T::from_f64(1.0), t90, t88],
                ]),
            )
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Jacobian<T, 4> for Magnets<T> {
        #[inline]
        fn jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SMatrix<T, 4, 4> {
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
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 4>,
            ::pendulum_core::nalgebra::SMatrix<T, 4, 4>,
        ) {
            T::apart(__Code { t, x }, &mut (), self)
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn time_derivative(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 4> {
            ::pendulum_core::nalgebra::SVector::from([
                T::from_f64(0.0),
                T::from_f64(0.0),
                T::from_f64(0.0),
                T::from_f64(0.0),
            ])
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Energy<T, 4> for Magnets<T> {
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn kinetic(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 4>) -> T {
            let [_, q_theta2, qd_theta1, qd_theta2] = x.data.0[0];
            let k9 = self.constants[9];
            let (_, cos_theta2) = q_theta2.sin_cos();
            let t0 = T::from_f64(0.5) * cos_theta2;
            let t1 = qd_theta1
                .mul_add(
                    qd_theta1
                        .mul_add(
                            T::from_f64(0.8333333333333334) + t0,
                            qd_theta2 * (T::from_f64(0.3333333333333333) + t0),
                        ),
                    qd_theta2 * (T::from_f64(0.16666666666666666) * qd_theta2),
                );
            k9 * t1
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn potential(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 4>) -> T {
            let [q_theta1, q_theta2, _, _] = x.data.0[0];
            let k0 = self.constants[0];
            let k1 = self.constants[1];
            let k2 = self.constants[2];
            let k6 = self.constants[6];
            let t0 = q_theta1 + q_theta2;
            let [(sin_theta1, cos_theta1), (sin1, cos1)] = q_theta1.sin_cos_pair(t0);
            let t2 = k1 * cos_theta1;
            let t3 = k1 * sin_theta1;
            let t4 = T::from_f64(-0.66) + k1.mul_add(cos1, t2);
            let t5 = k1.mul_add(sin1, t3);
            let t6 = T::from_f64(-0.66) + t2;
            let t7 = t6 * t6;
            let t8 = t4 * t4;
            let t9 = T::from_f64(-0.15) - t3;
            let t10 = T::from_f64(0.2) - t3;
            let t11 = T::from_f64(1.0) / t9.mul_add(t9, t7).powf(T::from_f64(1.5))
                + T::from_f64(1.0) / t10.mul_add(t10, t7).powf(T::from_f64(1.5));
            let t12 = T::from_f64(-0.15) - t5;
            let t13 = T::from_f64(0.2) - t5;
            let t14 = T::from_f64(1.0) / t12.mul_add(t12, t8).powf(T::from_f64(1.5))
                + T::from_f64(1.0) / t13.mul_add(t13, t8).powf(T::from_f64(1.5));
            T::from_f64(9.81)
                .mul_neg_add(
                    k6.mul_add(cos_theta1, k0.mul_add(t2, k6 * cos1)),
                    k2 * (t11 - t14),
                )
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::shapes::Shapes<4> for Magnets {
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
                ) -> [T; 30];
            }
            #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
            impl<T: ::pendulum_core::real::Real> Values<T> for Magnets<T> {
                fn values(
                    &self,
                    t: T,
                    x: &::pendulum_core::nalgebra::SVector<T, 4>,
                ) -> [T; 30] {
                    {
                        let [q_theta1, q_theta2, _, _] = x.data.0[0];
                        let k1 = self.constants[1];
                        let k4 = self.constants[4];
                        let t0 = q_theta1 + q_theta2;
                        let [(sin_theta1, cos_theta1), (sin1, cos1)] = q_theta1
                            .sin_cos_pair(t0);
                        let t2 = k1 * sin_theta1;
                        let t3 = k4 * cos_theta1;
                        let t4 = k1 * (sin_theta1 + sin1);
                        let t5 = k4 * (cos_theta1 + cos1);
                        [
                            T::from_f64(0.0),
                            T::from_f64(0.0),
                            T::from_f64(0.0),
                            t2,
                            t3,
                            T::from_f64(0.0),
                            t2,
                            t3,
                            T::from_f64(0.0),
                            t4,
                            t5,
                            T::from_f64(0.0),
                            T::from_f64(0.0),
                            T::from_f64(0.0),
                            T::from_f64(0.0),
                            t2,
                            t3,
                            T::from_f64(0.0),
                            t2,
                            t3,
                            T::from_f64(0.0),
                            t4,
                            t5,
                            T::from_f64(0.0),
                            T::from_f64(-0.15),
                            T::from_f64(-0.66),
                            T::from_f64(0.0),
                            T::from_f64(0.2),
                            T::from_f64(-0.66),
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
                        kind: ::pendulum_core::shapes::ShapeKind::Support,
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
                        name: "first",
                        body: "upper",
                        kind: ::pendulum_core::shapes::ShapeKind::Point,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "second",
                        body: "lower",
                        kind: ::pendulum_core::shapes::ShapeKind::Point,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "left",
                        body: "ground",
                        kind: ::pendulum_core::shapes::ShapeKind::Anchor,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "right",
                        body: "ground",
                        kind: ::pendulum_core::shapes::ShapeKind::Anchor,
                        points: 1,
                        radius: false,
                    },
                ],
                &self.values(t, x),
            )
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::Parametric<4, 4> for Magnets {
        fn parameters(&self) -> [f64; 4] {
            self.params.to_array()
        }
        fn parameter_names(&self) -> [&str; 4] {
            MagnetsParams::NAMES
        }
        fn check_parameters(
            &self,
            parameters: &[f64; 4],
        ) -> ::core::result::Result<(), ::pendulum_core::ParameterError> {
            Self::new(MagnetsParams::from_array(*parameters)).map(|_| ())
        }
        fn with_parameters<T: ::pendulum_core::real::Real>(
            &self,
            parameters: [T; 4],
        ) -> Magnets<T> {
            Magnets {
                params: self.params,
                constants: constants(parameters),
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::CastJacobian<4> for Magnets {
        #[inline]
        fn with_jacobian<T: ::pendulum_core::real::Real>(
            model: &Magnets<T>,
        ) -> &impl ::pendulum_core::Jacobian<T, 4> {
            model
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::Cast<4> for Magnets {
        type In<T: ::pendulum_core::real::Real> = Magnets<T>;
        fn cast<T: ::pendulum_core::real::Real>(&self) -> Magnets<T> {
            Magnets::cast(self)
        }
        #[inline]
        fn gather<'m, T: ::pendulum_core::real::lanes::Lanes>(
            models: impl ::core::ops::Fn(usize) -> &'m Self,
        ) -> Magnets<T>
        where
            Self: 'm,
        {
            let scalar = <<T as ::pendulum_core::real::lanes::Lanes>::Scalar as ::pendulum_core::real::Real>::from_f64;
            Magnets {
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
pub use __Magnets::{Magnets, MagnetsParams};
