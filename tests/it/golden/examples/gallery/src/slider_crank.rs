#[allow(non_snake_case)]
mod __SliderCrank {
    ///Parameters of [`SliderCrank`].
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct SliderCrankParams {
        ///In m.
        pub r: f64,
        ///In m.
        pub l: f64,
        ///In kg.
        pub m1: f64,
        ///In kg.
        pub m2: f64,
        ///In kg.
        pub m3: f64,
        ///In N s/m.
        pub gamma: f64,
    }
    impl ::core::default::Default for SliderCrankParams {
        #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
        fn default() -> Self {
            Self {
                r: 0.15f64,
                l: 0.4f64,
                m1: 0.8f64,
                m2: 0.3f64,
                m3: 0.4f64,
                gamma: 0.6f64,
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl SliderCrankParams {
        /// The names of the parameters, in the order of their declaration.
        pub const NAMES: [&'static str; 6] = ["r", "l", "m1", "m2", "m3", "gamma"];
        /// The values of the parameters, in the order of [`NAMES`](Self::NAMES).
        pub const fn to_array(self) -> [f64; 6] {
            [self.r, self.l, self.m1, self.m2, self.m3, self.gamma]
        }
        /// The parameters with these values, in the order of [`NAMES`](Self::NAMES).
        pub const fn from_array(values: [f64; 6]) -> Self {
            let [v0, v1, v2, v3, v4, v5] = values;
            Self {
                r: v0,
                l: v1,
                m1: v2,
                m2: v3,
                m3: v4,
                gamma: v5,
            }
        }
    }
    /// A crank of radius `r`, a rod of length `l`, and a piston.
    ///
    /**# Equations of motion

```text
A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints

A[theta, theta] = 0.005*m1 + 1/30*r^2 + r^2*m2 + r*l*m2*slope_angle_rod_theta*t3 + m3*slope_s_theta^2
    + 1/3*l^2*m2*slope_angle_rod_theta^2
b[theta] = m3*slope_s_theta*drift_s + r*(0.4905 + 9.81*m2)*cos(theta) + 0.5*r*l*m2*dot(angle_rod)^2*t4
    + 1/3*l^2*m2*slope_angle_rod_theta*drift_angle_rod + 4.905*l*m2*slope_angle_rod_theta*cos(angle_rod)
    + 0.5*r*l*m2*drift_angle_rod*t3 - 0.5*r*l*m2*dot(theta)^2*slope_angle_rod_theta*t4
Q[theta] = -gamma*dot(s)*slope_s_theta

where
t0 = sqrt(l^2 - (r*sin(theta))^2)
t1 = r*cos(theta) + t0 - r*cos(theta)
angle_rod = atan2(-r*sin(theta)/l, t1/l)
slope_s_theta = -(r*sin(theta)*t1 + r^2*cos(theta)*sin(theta))/t0
dot(s) = dot(theta)*slope_s_theta
slope_angle_rod_theta = -r*cos(theta)/t0
dot(angle_rod) = dot(theta)*slope_angle_rod_theta
t2 = r*sin(theta)*dot(angle_rod)^2 - r*dot(theta)^2*sin(theta)
drift_s = -(t1*(r*dot(theta)^2*cos(theta) + t1*dot(angle_rod)^2) + r*sin(theta)*t2)/t0
drift_angle_rod = -t2/t0
t3 = cos(theta - angle_rod)
t4 = sin(theta - angle_rod)
```

# Constants, computed by `new`

```text
k0 = r
k1 = l
k2 = m3
k3 = gamma
k4 = l^2
k5 = sqrt(l^2)
k6 = 0.005*m1 + 1/30*r^2 + r^2*m2
k7 = r*l*m2
k8 = 1/3*l^2*m2
k9 = 0.5*r*l*m2
k10 = 4.905*l*m2
k11 = 0.4905*(r + 20*r*m2)
k12 = 1/1200*(20*r^2 + 600*r^2*m2 + 3*m1)
k13 = 0.5*m3
k14 = 1/6*l^2*m2
k15 = 1/l
k16 = r/sqrt(l^2)
k17 = 1
```
*/
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct SliderCrank<T = f64> {
        params: SliderCrankParams,
        constants: [T; 18],
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl SliderCrank {
        /// Builds the model: checks the parameters, and computes once whatever depends on them alone.
        ///
        /// # Errors
        ///
        /// The first parameter, or combination of parameters, that is not finite or that no rigid body can
        /// have.
        pub fn new(
            params: SliderCrankParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            #[inline]
            fn rules<T: ::pendulum_core::real::Real>(given: [T; 6]) -> [T; 4] {
                let [p_r, p_l, p_m1, p_m2, p_m3, p_gamma] = given;
                [p_m1, p_m3, p_gamma, p_m2]
            }
            #[inline]
            fn constants<T: ::pendulum_core::real::Real>(given: [T; 6]) -> [T; 18] {
                let [p_r, p_l, p_m1, p_m2, p_m3, p_gamma] = given;
                let t0 = T::from_f64(4.905) * (p_l * p_m2);
                let t1 = T::from_f64(0.4905) * (p_r + p_m2 * (T::from_f64(20.0) * p_r));
                let t2 = T::from_f64(0.5) * p_m3;
                let t3 = p_l * p_l;
                let t4 = t3.sqrt();
                let t5 = p_r * (T::from_f64(1.0) / t3.sqrt());
                let t6 = p_m2 * t3;
                let t7 = T::from_f64(0.3333333333333333) * t6;
                let t8 = T::from_f64(0.16666666666666666) * t6;
                let t9 = p_r * p_r;
                let t10 = T::from_f64(0.005) * p_m1
                    + (T::from_f64(0.03333333333333333) * t9 + p_m2 * t9);
                let t11 = T::from_f64(0.0008333333333333334)
                    * (T::from_f64(20.0) * t9 + p_m2 * (T::from_f64(600.0) * t9)
                        + T::from_f64(3.0) * p_m1);
                let t12 = p_m2 * (p_r * p_l);
                let t13 = T::from_f64(0.5) * t12;
                let t14 = T::from_f64(1.0) / p_l;
                let t15 = p_l * t14;
                [
                    p_r,
                    p_l,
                    p_m3,
                    p_gamma,
                    t3,
                    t4,
                    t10,
                    t12,
                    t7,
                    t13,
                    t0,
                    t1,
                    t11,
                    t2,
                    t8,
                    t14,
                    t5,
                    t15,
                ]
            }
            let given = params.to_array();
            for (name, value) in SliderCrankParams::NAMES.into_iter().zip(given) {
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
            let [r0, r1, r2, r3] = rules(given);
            if !(r0 > 0.0) {
                return Err(
                    ::pendulum_core::ParameterError::new(
                        "m1",
                        r0,
                        "the mass of a disk of `crank` must be positive",
                        &[],
                    ),
                );
            }
            if !(r1 > 0.0) {
                return Err(
                    ::pendulum_core::ParameterError::new(
                        "m3",
                        r1,
                        "the mass of a cuboid of `piston` must be positive",
                        &[],
                    ),
                );
            }
            if !(r2 >= 0.0) {
                return Err(
                    ::pendulum_core::ParameterError::new(
                        "gamma",
                        r2,
                        "the friction of `piston` must not be negative",
                        &[],
                    ),
                );
            }
            if !(r3 > 0.0) {
                return Err(
                    ::pendulum_core::ParameterError::new(
                        "m2",
                        r3,
                        "the mass of a rod of `rod` must be positive",
                        &[],
                    ),
                );
            }
            let constants = constants(given);
            let names: [&'static str; 18] = [
                "r",
                "l",
                "m3",
                "gamma",
                "l^2",
                "sqrt(l^2)",
                "0.005*m1 + 1/30*r^2 + r^2*m2",
                "r*l*m2",
                "1/3*l^2*m2",
                "0.5*r*l*m2",
                "4.905*l*m2",
                "0.4905*(r + 20*r*m2)",
                "1/1200*(20*r^2 + 600*r^2*m2 + 3*m1)",
                "0.5*m3",
                "1/6*l^2*m2",
                "1/l",
                "r/sqrt(l^2)",
                "1",
            ];
            for (name, value) in names.into_iter().zip(constants) {
                if !value.is_finite() {
                    let given: [_; 6] = ::core::array::from_fn(|n| (
                        SliderCrankParams::NAMES[n],
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
        pub fn cast<T: ::pendulum_core::real::Real>(&self) -> SliderCrank<T> {
            SliderCrank {
                params: self.params,
                constants: self.constants.map(T::from_f64),
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> SliderCrank<T> {
        /// The parameters that the model was built from.
        pub fn params(&self) -> &SliderCrankParams {
            &self.params
        }
        /// The model with other parameters, in the same number type. Its constants are computed anew.
        ///
        /// # Errors
        ///
        /// Those of `new`.
        pub fn with_params(
            &self,
            params: SliderCrankParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            Ok(<SliderCrank>::new(params)?.cast())
        }
    }
    impl SliderCrank {
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
                            "closed form, factors of parameters first, L^T D L",
                            ::pendulum_core::Operations::new(19, 40, 2, 1, 1, 45),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first, L^T D L",
                                    ::pendulum_core::Operations::new(19, 41, 2, 1, 1, 44),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L",
                                    ::pendulum_core::Operations::new(19, 40, 2, 1, 1, 46),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, L^T D L",
                                    ::pendulum_core::Operations::new(35, 48, 2, 1, 1, 49),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C, L^T D L",
                                    ::pendulum_core::Operations::new(43, 55, 2, 1, 1, 47),
                                ),
                            ],
                        ),
                ),
                (
                    "loop_margins",
                    ::pendulum_core::FunctionCost::new(
                        "as declared",
                        ::pendulum_core::Operations::new(2, 6, 2, 1, 1, 32),
                    ),
                ),
                (
                    "jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of parameters first, L^T D L, derived in the graph",
                            ::pendulum_core::Operations::new(59, 105, 3, 1, 1, 55),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first, L^T D L, derived in the graph",
                                    ::pendulum_core::Operations::new(59, 111, 3, 1, 1, 52),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L, derived in the graph",
                                    ::pendulum_core::Operations::new(62, 114, 3, 1, 1, 58),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, L^T D L, derived in the graph",
                                    ::pendulum_core::Operations::new(101, 135, 3, 1, 1, 67),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C, L^T D L, derived in the graph",
                                    ::pendulum_core::Operations::new(121, 144, 3, 1, 1, 59),
                                ),
                            ],
                        ),
                ),
                (
                    "kinetic",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(8, 18, 1, 1, 1, 38),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(8, 19, 1, 1, 1, 37),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(8, 18, 1, 1, 1, 38),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(17, 25, 1, 1, 1, 43),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C",
                                    ::pendulum_core::Operations::new(22, 29, 1, 1, 1, 43),
                                ),
                            ],
                        ),
                ),
                (
                    "potential",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(1, 3, 1, 1, 0, 27),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(1, 3, 1, 1, 0, 27),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(1, 3, 1, 1, 0, 27),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C",
                                    ::pendulum_core::Operations::new(2, 4, 1, 1, 0, 27),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(2, 4, 1, 1, 0, 27),
                                ),
                            ],
                        ),
                ),
                (
                    "stroke",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(2, 3, 0, 1, 1, 28),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(2, 3, 0, 1, 1, 28),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(2, 3, 0, 1, 1, 28),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(2, 3, 0, 1, 1, 28),
                                ),
                            ],
                        ),
                ),
                (
                    "stroke_rate",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(5, 6, 1, 1, 1, 33),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(5, 6, 1, 1, 1, 33),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(5, 6, 1, 1, 1, 33),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(5, 6, 1, 1, 1, 33),
                                ),
                            ],
                        ),
                ),
                (
                    "stroke_and_jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(5, 5, 1, 1, 1, 32),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(5, 5, 1, 1, 1, 32),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(5, 5, 1, 1, 1, 32),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(5, 5, 1, 1, 1, 32),
                                ),
                            ],
                        ),
                ),
                (
                    "speed",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(5, 6, 1, 1, 1, 33),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(5, 6, 1, 1, 1, 33),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(5, 6, 1, 1, 1, 33),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(5, 6, 1, 1, 1, 33),
                                ),
                            ],
                        ),
                ),
                (
                    "speed_rate",
                    ::pendulum_core::FunctionCost::new(
                        "as declared",
                        ::pendulum_core::Operations::new(21, 42, 2, 1, 1, 46),
                    ),
                ),
                (
                    "speed_and_jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(12, 14, 2, 1, 1, 39),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(11, 16, 2, 1, 1, 35),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(11, 18, 2, 1, 1, 36),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(11, 20, 2, 1, 1, 34),
                                ),
                            ],
                        ),
                ),
                (
                    "outputs",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(5, 6, 1, 1, 1, 33),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(5, 6, 1, 1, 1, 33),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(5, 6, 1, 1, 1, 33),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(5, 6, 1, 1, 1, 33),
                                ),
                            ],
                        ),
                ),
                (
                    "output_rates",
                    ::pendulum_core::FunctionCost::new(
                        "as declared",
                        ::pendulum_core::Operations::new(22, 43, 2, 1, 1, 45),
                    ),
                ),
                (
                    "outputs_and_jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(12, 14, 2, 1, 1, 39),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(11, 16, 2, 1, 1, 35),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(11, 18, 2, 1, 1, 36),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(11, 20, 2, 1, 1, 34),
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
            )
            .autonomous();
        /// The equations of motion as text.
        pub const EQUATIONS: &'static str = "A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints\n\nA[theta, theta] = 0.005*m1 + 1/30*r^2 + r^2*m2 + r*l*m2*slope_angle_rod_theta*t3 + m3*slope_s_theta^2\n    + 1/3*l^2*m2*slope_angle_rod_theta^2\nb[theta] = m3*slope_s_theta*drift_s + r*(0.4905 + 9.81*m2)*cos(theta) + 0.5*r*l*m2*dot(angle_rod)^2*t4\n    + 1/3*l^2*m2*slope_angle_rod_theta*drift_angle_rod + 4.905*l*m2*slope_angle_rod_theta*cos(angle_rod)\n    + 0.5*r*l*m2*drift_angle_rod*t3 - 0.5*r*l*m2*dot(theta)^2*slope_angle_rod_theta*t4\nQ[theta] = -gamma*dot(s)*slope_s_theta\n\nwhere\nt0 = sqrt(l^2 - (r*sin(theta))^2)\nt1 = r*cos(theta) + t0 - r*cos(theta)\nangle_rod = atan2(-r*sin(theta)/l, t1/l)\nslope_s_theta = -(r*sin(theta)*t1 + r^2*cos(theta)*sin(theta))/t0\ndot(s) = dot(theta)*slope_s_theta\nslope_angle_rod_theta = -r*cos(theta)/t0\ndot(angle_rod) = dot(theta)*slope_angle_rod_theta\nt2 = r*sin(theta)*dot(angle_rod)^2 - r*dot(theta)^2*sin(theta)\ndrift_s = -(t1*(r*dot(theta)^2*cos(theta) + t1*dot(angle_rod)^2) + r*sin(theta)*t2)/t0\ndrift_angle_rod = -t2/t0\nt3 = cos(theta - angle_rod)\nt4 = sin(theta - angle_rod)\n";
        ///The names of the components of all outputs.
        pub const OUTPUTS: [&'static str; 2] = ["stroke", "speed"];
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::System<T, 2>
    for SliderCrank<T> {
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn rhs(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 2> {
            let [q_theta, qd_theta] = x.data.0[0];
            let k0 = self.constants[0];
            let k2 = self.constants[2];
            let k3 = self.constants[3];
            let k4 = self.constants[4];
            let k6 = self.constants[6];
            let k7 = self.constants[7];
            let k8 = self.constants[8];
            let k9 = self.constants[9];
            let k10 = self.constants[10];
            let k11 = self.constants[11];
            let k15 = self.constants[15];
            let t0 = qd_theta * qd_theta;
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            let t1 = k0 * sin_theta;
            let t2 = (k4 - t1 * t1).sqrt();
            let t3 = T::from_f64(1.0) / t2;
            let t4 = k0 * cos_theta;
            let t5 = t2 + t4 - t4;
            let t6 = t3 * (t1 * (t4 + t5));
            let t7 = t3 * t4;
            let t8 = k15 * t5;
            let t9 = k15 * t1;
            let t10 = cos_theta * t8 - sin_theta * t9;
            let t11 = k6 + k2 * t6 * t6 - t7 * (k7 * t10 - k8 * t7);
            let t12 = t7 * qd_theta;
            let t13 = t12 * t12;
            let t14 = t1 * (t13 - t0);
            let t15 = k2 * t3 * (t5 * (t4 * t0 + t5 * t13) + t1 * t14);
            let t16 = t3 * t14;
            let t17 = (sin_theta * t8 + cos_theta * t9) * (t13 + t7 * t0) - t10 * t16;
            let t18 = k9 * t17 + t6 * (k3 * t6 * qd_theta + t15) + k11 * cos_theta;
            ::pendulum_core::nalgebra::SVector::from([
                qd_theta,
                T::from_f64(-1.0) / t11 * (t18 - t7 * (k10 * t8 - k8 * t16)),
            ])
        }
        #[inline]
        fn layout(
            &self,
        ) -> ::core::option::Option<&'static ::pendulum_core::StateLayout> {
            Some(&<SliderCrank>::LAYOUT)
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn margins(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
            tell: &mut dyn FnMut([&'static str; 2], [T; 2]),
        ) {
            let (margins, rates) = self.loop_margins(t, x);
            tell(["rod", "piston"], [margins[0], rates[0]]);
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Jacobian<T, 2>
    for SliderCrank<T> {
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
            let k0 = self.constants[0];
            let k2 = self.constants[2];
            let k3 = self.constants[3];
            let k4 = self.constants[4];
            let k6 = self.constants[6];
            let k7 = self.constants[7];
            let k8 = self.constants[8];
            let k9 = self.constants[9];
            let k10 = self.constants[10];
            let k11 = self.constants[11];
            let k15 = self.constants[15];
            let t0 = qd_theta * qd_theta;
            let t1 = T::from_f64(2.0) * qd_theta;
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            let t2 = k0 * sin_theta;
            let t3 = t2 * t2;
            let t4 = k4 - t3;
            let t5 = t4.sqrt();
            let t6 = T::from_f64(1.0) / t5;
            let t7 = k0 * cos_theta;
            let t8 = t5 + t7 - t7;
            let t9 = t7 + t8;
            let t10 = t2 * t9;
            let t11 = t6 * t10;
            let t12 = k2 * t11;
            let t13 = t6 * t7;
            let t14 = k15 * t8;
            let t15 = k15 * t2;
            let t16 = cos_theta * t14 - sin_theta * t15;
            let t17 = k8 * t13;
            let t18 = k7 * t16 - t17;
            let t19 = T::from_f64(-1.0) / (k6 + t11 * t12 - t13 * t18);
            let t20 = sin_theta * t14 + cos_theta * t15;
            let t21 = t13 * qd_theta;
            let t22 = t21 * t21;
            let t23 = T::from_f64(2.0) * t21;
            let t24 = t22 + t13 * t0;
            let t25 = t2 * t0;
            let t26 = t2 * t22 - t25;
            let t27 = t6 * t26;
            let t28 = k10 * t14 - k8 * t27;
            let t29 = k3 * t11;
            let t30 = t7 * t0;
            let t31 = t30 + t8 * t22;
            let t32 = t8 * t31 + t2 * t26;
            let t33 = k2 * t6;
            let t34 = qd_theta * t29 + t32 * t33;
            let t35 = k9 * (t20 * t24 - t16 * t27) + t11 * t34 + k11 * cos_theta;
            let t36 = t19 * (t35 - t13 * t28);
            let t37 = T::from_f64(1.0) + t13;
            let t38 = t20 * t37;
            let t39 = t2 * t6;
            let t40 = t7 * t39;
            let t41 = t40 * (T::from_f64(1.0) / t4);
            let t42 = t39 - t7 * t41;
            let t43 = t2 - t2 - t40;
            let t44 = t10 * t41 + t6 * (t2 * t43 + t7 * t9 - t3);
            let t45 = t18 * t42 + t44 * (t12 + t12) - t13 * (k8 * t42 - k7 * t38);
            let t46 = qd_theta * t42 * t23;
            let t47 = t31 * t43 + t8 * (t22 * t43 - t25 - t8 * t46) + t7 * t26;
            let t48 = t7 * t22 - t30 - t2 * t46;
            let t49 = k3 * qd_theta * t44 + k2 * (t32 * t41 + t6 * (t47 + t2 * t48));
            let t50 = t26 * t41 + t6 * t48;
            let t51 = t27 * t38 + t16 * (t24 * t37 - t50) - t20 * (t42 * t0 + t46);
            let t52 = k9 * t51 + t34 * t44 + t11 * t49 + t28 * t42
                + t13 * (k8 * t50 + k10 * t13 * t15);
            let t53 = t13 * t23;
            let t54 = t2 * (t53 - t1);
            let t55 = t29 + (t8 * (t7 * t1 + t8 * t53) + t2 * t54) * t33;
            let t56 = t6 * t54;
            let t57 = k9 * (t20 * (t53 + t13 * t1) - t16 * t56) + t11 * t55;
            (
                ::pendulum_core::nalgebra::SVector::from([qd_theta, t36]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [T::from_f64(0.0), t19 * (t52 + t36 * t45 - k11 * sin_theta)],
                    [T::from_f64(1.0), t19 * (t57 + t17 * t56)],
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
            ::pendulum_core::nalgebra::SVector::from([
                T::from_f64(0.0),
                T::from_f64(0.0),
            ])
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Energy<T, 2>
    for SliderCrank<T> {
        #[inline]
        fn kinetic(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 2>) -> T {
            let [q_theta, qd_theta] = x.data.0[0];
            let k0 = self.constants[0];
            let k4 = self.constants[4];
            let k9 = self.constants[9];
            let k12 = self.constants[12];
            let k13 = self.constants[13];
            let k14 = self.constants[14];
            let k15 = self.constants[15];
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            let t0 = k0 * sin_theta;
            let t1 = k0 * cos_theta;
            let t2 = (k4 - t0 * t0).sqrt();
            let t3 = t2 + t1 - t1;
            let t4 = qd_theta * (T::from_f64(1.0) / t2);
            let t5 = t0 * (t1 + t3) * t4;
            let t6 = t1 * t4;
            let t7 = k12 * qd_theta
                - k9 * t6 * (k15 * (cos_theta * t3 - sin_theta * t0));
            k13 * t5 * t5 + k14 * t6 * t6 + qd_theta * t7
        }
        #[inline]
        fn potential(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 2>) -> T {
            let [q_theta, _] = x.data.0[0];
            let k0 = self.constants[0];
            let k1 = self.constants[1];
            let k10 = self.constants[10];
            let k11 = self.constants[11];
            let (sin_theta, _) = q_theta.sin_cos();
            sin_theta * k11 - k0 * sin_theta / k1 * k10
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> SliderCrank<T> {
        ///How far each closed loop is from its toggle, in the order of the declaration: 0 there, and at most 1. And the rates of that.
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        pub fn loop_margins(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 1>,
            ::pendulum_core::nalgebra::SVector<T, 1>,
        ) {
            let [q_theta, qd_theta] = x.data.0[0];
            let k0 = self.constants[0];
            let k4 = self.constants[4];
            let k5 = self.constants[5];
            let k16 = self.constants[16];
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            let t0 = k0 * sin_theta;
            let t1 = (k4 - t0 * t0).sqrt();
            (
                ::pendulum_core::nalgebra::SVector::from([t1 / k5]),
                ::pendulum_core::nalgebra::SVector::from([
                    -(k16 * t0 * qd_theta * cos_theta * (T::from_f64(1.0) / t1)),
                ]),
            )
        }
        ///Output `stroke`.
        #[inline]
        pub fn stroke(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 2>) -> T {
            let [q_theta, _] = x.data.0[0];
            let k0 = self.constants[0];
            let k4 = self.constants[4];
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            let t0 = k0 * sin_theta;
            k0 * cos_theta + (k4 - t0 * t0).sqrt()
        }
        ///The rate of `stroke` along the motion.
        #[inline]
        pub fn stroke_rate(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
        ) -> T {
            let [q_theta, qd_theta] = x.data.0[0];
            let k0 = self.constants[0];
            let k4 = self.constants[4];
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            let t0 = k0 * sin_theta;
            let t1 = k0 * cos_theta;
            let t2 = (k4 - t0 * t0).sqrt();
            -(qd_theta * (T::from_f64(1.0) / t2) * (t0 * (t1 + (t2 + t1 - t1))))
        }
        ///The value of `stroke`, and its derivatives by the state: a row for each component, column by column for a matrix.
        #[inline]
        pub fn stroke_and_jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
        ) -> (T, ::pendulum_core::nalgebra::SMatrix<T, 1, 2>) {
            let [q_theta, _] = x.data.0[0];
            let k0 = self.constants[0];
            let k4 = self.constants[4];
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            let t0 = k0 * cos_theta;
            let t1 = k0 * sin_theta;
            let t2 = (k4 - t1 * t1).sqrt();
            let t3 = t0 + t2;
            (
                t3,
                ::pendulum_core::nalgebra::SMatrix::from([
                    [-(T::from_f64(1.0) / t2 * (t1 * (t0 + (t3 - t0))))],
                    [T::from_f64(0.0)],
                ]),
            )
        }
        ///Output `speed`.
        #[inline]
        pub fn speed(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 2>) -> T {
            let [q_theta, qd_theta] = x.data.0[0];
            let k0 = self.constants[0];
            let k4 = self.constants[4];
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            let t0 = k0 * sin_theta;
            let t1 = k0 * cos_theta;
            let t2 = (k4 - t0 * t0).sqrt();
            -(qd_theta * (T::from_f64(1.0) / t2) * (t0 * (t1 + (t2 + t1 - t1))))
        }
        ///The rate of `speed` along the motion.
        #[inline]
        pub fn speed_rate(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
        ) -> T {
            let [q_theta, qd_theta] = x.data.0[0];
            let k0 = self.constants[0];
            let k2 = self.constants[2];
            let k3 = self.constants[3];
            let k4 = self.constants[4];
            let k6 = self.constants[6];
            let k7 = self.constants[7];
            let k8 = self.constants[8];
            let k9 = self.constants[9];
            let k10 = self.constants[10];
            let k11 = self.constants[11];
            let k15 = self.constants[15];
            let t0 = qd_theta * qd_theta;
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            let t1 = k0 * sin_theta;
            let t2 = (k4 - t1 * t1).sqrt();
            let t3 = T::from_f64(1.0) / t2;
            let t4 = k0 * cos_theta;
            let t5 = t2 + t4 - t4;
            let t6 = t3 * t4;
            let t7 = qd_theta * t6;
            let t8 = t7 * t7;
            let t9 = t1 * (t8 - t0);
            let t10 = t5 * (t4 * t0 + t5 * t8) + t1 * t9;
            let t11 = t3 * t9;
            let t12 = t1 * (t4 + t5);
            let t13 = k15 * t1;
            let t14 = k15 * t5;
            let t15 = cos_theta * t14 - sin_theta * t13;
            let t16 = (t8 + t6 * t0) * (cos_theta * t13 + sin_theta * t14) - t15 * t11;
            let t17 = t3 * t12;
            let t18 = k11 * cos_theta + k9 * t16
                + t17 * (k3 * qd_theta * t17 + k2 * t3 * t10);
            let t19 = k6 + k2 * t17 * t17 - t6 * (k7 * t15 - k8 * t6);
            let t20 = (t18 - t6 * (k10 * t14 - k8 * t11))
                * (t12 * (T::from_f64(-1.0) / t19));
            -(t3 * (t10 + t20))
        }
        ///The value of `speed`, and its derivatives by the state: a row for each component, column by column for a matrix.
        #[inline]
        pub fn speed_and_jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
        ) -> (T, ::pendulum_core::nalgebra::SMatrix<T, 1, 2>) {
            let [q_theta, qd_theta] = x.data.0[0];
            let k0 = self.constants[0];
            let k4 = self.constants[4];
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            let t0 = k0 * sin_theta;
            let t1 = k0 * cos_theta;
            let t2 = t0 * t0;
            let t3 = k4 - t2;
            let t4 = t3.sqrt();
            let t5 = T::from_f64(1.0) / t4;
            let t6 = t1 + (t4 + t1 - t1);
            let t7 = t0 * t6;
            let t8 = t5 * t7;
            let t9 = t5 * (t0 * t1);
            let t10 = t7 * t9 * (T::from_f64(1.0) / t3)
                + t5 * (t0 * (t0 - t0 - t9) + t1 * t6 - t2);
            (
                -(qd_theta * t8),
                ::pendulum_core::nalgebra::SMatrix::from([[-(qd_theta * t10)], [-t8]]),
            )
        }
        ///All outputs, in the order of `OUTPUTS`.
        #[inline]
        pub fn outputs(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 2> {
            let [q_theta, qd_theta] = x.data.0[0];
            let k0 = self.constants[0];
            let k4 = self.constants[4];
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            let t0 = k0 * cos_theta;
            let t1 = k0 * sin_theta;
            let t2 = (k4 - t1 * t1).sqrt();
            let t3 = t0 + t2;
            ::pendulum_core::nalgebra::SVector::from([
                t3,
                -(qd_theta * (T::from_f64(1.0) / t2) * (t1 * (t0 + (t3 - t0)))),
            ])
        }
        ///The rate of all outputs along the motion.
        #[inline]
        pub fn output_rates(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 2> {
            let [q_theta, qd_theta] = x.data.0[0];
            let k0 = self.constants[0];
            let k2 = self.constants[2];
            let k3 = self.constants[3];
            let k4 = self.constants[4];
            let k6 = self.constants[6];
            let k7 = self.constants[7];
            let k8 = self.constants[8];
            let k9 = self.constants[9];
            let k10 = self.constants[10];
            let k11 = self.constants[11];
            let k15 = self.constants[15];
            let t0 = qd_theta * qd_theta;
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            let t1 = k0 * sin_theta;
            let t2 = (k4 - t1 * t1).sqrt();
            let t3 = T::from_f64(1.0) / t2;
            let t4 = k0 * cos_theta;
            let t5 = t2 + t4 - t4;
            let t6 = t3 * (t1 * (t4 + t5));
            let t7 = t3 * t4;
            let t8 = qd_theta * t7;
            let t9 = t8 * t8;
            let t10 = t1 * (t9 - t0);
            let t11 = t5 * (t4 * t0 + t5 * t9) + t1 * t10;
            let t12 = k15 * t5;
            let t13 = k15 * t1;
            let t14 = t3 * t10;
            let t15 = cos_theta * t12 - sin_theta * t13;
            let t16 = (t9 + t7 * t0) * (cos_theta * t13 + sin_theta * t12) - t15 * t14;
            let t17 = k11 * cos_theta + k9 * t16
                + t6 * (k3 * qd_theta * t6 + k2 * t3 * t11);
            let t18 = k6 + k2 * t6 * t6 - t7 * (k7 * t15 - k8 * t7);
            let t19 = t6 * (T::from_f64(-1.0) / t18)
                * (t17 - t7 * (k10 * t12 - k8 * t14));
            ::pendulum_core::nalgebra::SVector::from([
                -(qd_theta * t6),
                -(t3 * t11 + t19),
            ])
        }
        ///The value of all outputs, and its derivatives by the state: a row for each component, column by column for a matrix.
        #[inline]
        pub fn outputs_and_jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 2>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 2>,
            ::pendulum_core::nalgebra::SMatrix<T, 2, 2>,
        ) {
            let [q_theta, qd_theta] = x.data.0[0];
            let k0 = self.constants[0];
            let k4 = self.constants[4];
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            let t0 = k0 * cos_theta;
            let t1 = k0 * sin_theta;
            let t2 = t1 * t1;
            let t3 = k4 - t2;
            let t4 = t3.sqrt();
            let t5 = t0 + t4;
            let t6 = T::from_f64(1.0) / t4;
            let t7 = t0 + (t5 - t0);
            let t8 = t1 * t7;
            let t9 = t6 * t8;
            let t10 = -t9;
            let t11 = t6 * (t0 * t1);
            let t12 = t8 * t11 * (T::from_f64(1.0) / t3)
                + t6 * (t1 * (t1 - t1 - t11) + t0 * t7 - t2);
            (
                ::pendulum_core::nalgebra::SVector::from([t5, -(qd_theta * t9)]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [t10, -(qd_theta * t12)],
                    [T::from_f64(0.0), t10],
                ]),
            )
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::shapes::Shapes<2> for SliderCrank {
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
                        name: "crank",
                        kind: ::pendulum_core::shapes::ShapeKind::Disk,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "crank",
                        kind: ::pendulum_core::shapes::ShapeKind::Rod,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "piston",
                        kind: ::pendulum_core::shapes::ShapeKind::Cuboid,
                        points: 8,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "rod",
                        kind: ::pendulum_core::shapes::ShapeKind::Rod,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "crank",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "rod",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "rod",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                ],
                &{
                    let [q_theta, _] = x.data.0[0];
                    let k0 = self.constants[0];
                    let k4 = self.constants[4];
                    let k17 = self.constants[17];
                    let (sin_theta, cos_theta) = q_theta.sin_cos();
                    let t0 = T::from_f64(0.1) * cos_theta;
                    let t1 = T::from_f64(0.1) * sin_theta;
                    let t2 = k0 * cos_theta;
                    let t3 = k0 * sin_theta;
                    let t4 = t2 + (k4 - t3 * t3).sqrt();
                    let t5 = t2 + k17 * (t4 - t2);
                    let t6 = t3 - k17 * t3;
                    let t7 = T::from_f64(0.08) + t4;
                    let t8 = t4 - T::from_f64(0.02);
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t0,
                        t1,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t2,
                        t3,
                        T::from_f64(0.0),
                        t7,
                        T::from_f64(0.07),
                        T::from_f64(0.05),
                        t8,
                        T::from_f64(0.07),
                        T::from_f64(0.05),
                        t7,
                        T::from_f64(-0.07),
                        T::from_f64(0.05),
                        t8,
                        T::from_f64(-0.07),
                        T::from_f64(0.05),
                        t7,
                        T::from_f64(0.07),
                        T::from_f64(-0.05),
                        t8,
                        T::from_f64(0.07),
                        T::from_f64(-0.05),
                        t7,
                        T::from_f64(-0.07),
                        T::from_f64(-0.05),
                        t8,
                        T::from_f64(-0.07),
                        T::from_f64(-0.05),
                        t2,
                        t3,
                        T::from_f64(0.0),
                        t5,
                        t6,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t2,
                        t3,
                        T::from_f64(0.0),
                        t5,
                        t6,
                        T::from_f64(0.0),
                    ]
                },
            )
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::CastJacobian<2> for SliderCrank {
        #[inline]
        fn with_jacobian<T: ::pendulum_core::real::Real>(
            model: &SliderCrank<T>,
        ) -> &impl ::pendulum_core::Jacobian<T, 2> {
            model
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::Cast<2> for SliderCrank {
        type In<T: ::pendulum_core::real::Real> = SliderCrank<T>;
        fn cast<T: ::pendulum_core::real::Real>(&self) -> SliderCrank<T> {
            SliderCrank::cast(self)
        }
        #[inline]
        fn gather<'m, T: ::pendulum_core::real::lanes::Lanes>(
            models: impl ::core::ops::Fn(usize) -> &'m Self,
        ) -> SliderCrank<T>
        where
            Self: 'm,
        {
            let scalar = <<T as ::pendulum_core::real::lanes::Lanes>::Scalar as ::pendulum_core::real::Real>::from_f64;
            SliderCrank {
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
pub use __SliderCrank::{SliderCrank, SliderCrankParams};
