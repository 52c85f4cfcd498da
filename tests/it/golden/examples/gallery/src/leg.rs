#[allow(non_snake_case)]
mod __Leg {
    ///Parameters of [`Leg`].
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct LegParams {
        ///In kg.
        pub m1: f64,
        ///In kg.
        pub m2: f64,
        ///In m.
        pub d: f64,
        ///In N m s.
        pub gamma: f64,
        ///In N m.
        pub knee: f64,
        ///In m/s.
        pub v: f64,
        ///In m.
        pub rise: f64,
        ///In rad/s.
        pub w: f64,
    }
    impl ::core::default::Default for LegParams {
        #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
        fn default() -> Self {
            Self {
                m1: 3f64,
                m2: 2f64,
                d: 0.42f64,
                gamma: 0.08f64,
                knee: 9f64,
                v: 0.6f64,
                rise: 0.02f64,
                w: 6f64,
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl LegParams {
        /// The names of the parameters, in the order of their declaration.
        pub const NAMES: [&'static str; 8] = [
            "m1",
            "m2",
            "d",
            "gamma",
            "knee",
            "v",
            "rise",
            "w",
        ];
        /// The values of the parameters, in the order of [`NAMES`](Self::NAMES).
        pub const fn to_array(self) -> [f64; 8] {
            [self.m1, self.m2, self.d, self.gamma, self.knee, self.v, self.rise, self.w]
        }
        /// The parameters with these values, in the order of [`NAMES`](Self::NAMES).
        pub const fn from_array(values: [f64; 8]) -> Self {
            let [v0, v1, v2, v3, v4, v5, v6, v7] = values;
            Self {
                m1: v0,
                m2: v1,
                d: v2,
                gamma: v3,
                knee: v4,
                v: v5,
                rise: v6,
                w: v7,
            }
        }
    }
    /// Thigh and shank, two plates of one density, with friction in hip and knee. The hip moves at the speed `v`, and up and down.
    ///
    /**# Equations of motion

```text
A qdd + b = Q, where A is symmetric, b holds velocity terms, gravity and the inertia forces of the drives,
    Q the forces of the joints

A[theta1, theta1] = 223237/4386000*m1 + m2*d^2
A[theta1, theta2] = 17/12050*m2*d*sin(theta1 - theta2) + 3334/18075*m2*d*cos(theta1 - theta2)
A[theta2, theta2] = 258847/4820000*m2
b[theta1] = 578463/7310000*m1*cos(theta1) + 327/14620000*(75001*m1 + 438600*m2*d)*sin(theta1)
    + 3334/18075*m2*d*dot(theta2)^2*sin(theta1 - theta2) - 17/12050*m2*d*dot(theta2)^2*cos(theta1 - theta2)
    - (75001/438600*m1*rise*w^2 + m2*d*rise*w^2)*sin(w*t)*sin(theta1) - 1769/219300*m1*rise*w^2*sin(w*t)*cos(theta1)
b[theta2] = 17/12050*m2*d*dot(theta1)^2*cos(theta1 - theta2) + 545109/301250*m2*sin(theta2)
    + 16677/1205000*m2*cos(theta2) - 3334/18075*m2*d*dot(theta1)^2*sin(theta1 - theta2)
    - 3334/18075*m2*rise*w^2*sin(w*t)*sin(theta2) - 17/12050*m2*rise*w^2*sin(w*t)*cos(theta2)
Q[theta1] = gamma*dot(theta2) + 0.3*knee + knee*theta2 - knee*theta1 - 2*gamma*dot(theta1) - force(theta2)
Q[theta2] = force(theta2) + gamma*dot(theta1) + knee*theta1 - 0.3*knee - knee*theta2 - gamma*dot(theta2)

and along what hinders the motion
force(theta2): stops at -2.4 and -0.02, restitution 0.2
```

# Constants, computed by `new`

```text
k0 = d
k1 = gamma
k2 = knee
k3 = v
k4 = rise
k5 = w
k6 = 1769/219300*m1
k7 = 17/12050*m2
k8 = 3334/18075*m2
k9 = 9.81*(m1 + m2)
k10 = 9.81*m2
k11 = 75001/438600*m1 + m2*d
k12 = 75001/438600*m1*rise*w + m2*d*rise*w
k13 = 75001/438600*m1*v + m2*d*v
k14 = 258847/4820000*m2
k15 = 578463/7310000*m1
k16 = 2*gamma
k17 = 1769/219300*m1*rise*w
k18 = 1769/219300*m1*v
k19 = 1/8772000*(223237*m1 + 4386000*m2*d^2)
k20 = 258847/9640000*m2
k21 = 0.5*(m1*v^2 + m2*v^2)
k22 = 0.5*(m1*rise^2*w^2 + m2*rise^2*w^2)
k23 = 1/15284595960000000*(41777996655297*m1*m2 + 300793855162000*m2^2*d^2)
k24 = 258847/2114052000000*(75001*m1*m2*rise*w^2/(258847/4820000*m2) + 438600*m2^2*d*rise*w^2/(258847/4820000*m2))
k25 = 457900343/1057026000000*m1*m2*rise*w^2/(258847/4820000*m2)
k26 = 776541/48200000*m2*knee/(258847/4820000*m2)
k27 = 84642969/70468400000000*(75001*m1*m2/(258847/4820000*m2) + 438600*m2^2*d/(258847/4820000*m2))
k28 = 149733412161/35234200000000*m1*m2/(258847/4820000*m2)
k29 = 0.3*knee
k30 = -1/(258847/4820000*m2)
k31 = 17/12050*m2*d
k32 = 3334/18075*m2*d
k33 = 3334/18075*m2*rise*w^2
k34 = 17/12050*m2*rise*w^2
k35 = 545109/301250*m2
k36 = 16677/1205000*m2
k37 = 3334/18075*m2*rise*w
k38 = 17/12050*m2*rise*w
k39 = 17/12050*m2*v
k40 = 3334/18075*m2*v
k41 = 0.5*knee
k42 = 56678/108901875*(m2*d)^2
k43 = 44459623/1306822500*(m2*d)^2
k44 = 11115556/326705625*m2^2*d*rise*w^2/(258847/4820000*m2)
k45 = 289/145202500*m2^2*d*rise*w^2/(258847/4820000*m2)
k46 = 28339/108901875*m2^2*d*rise*w^2/(258847/4820000*m2)
k47 = 302898901/907515625*m2^2*d/(258847/4820000*m2)
k48 = 283509/14520250000*m2^2*d/(258847/4820000*m2)
k49 = 51/120500*m2*d*knee/(258847/4820000*m2)
k50 = 1667/30125*m2*d*knee/(258847/4820000*m2)
k51 = 9266853/3630062500*m2^2*d/(258847/4820000*m2)
k52 = -17/12050*d/(258847/4820000)
k53 = -3334/18075*d/(258847/4820000)
k54 = -1667/30125*m2*d*knee/(258847/4820000*m2)
k55 = 24525327/14620000*m1
k56 = 9.81*m1
k57 = rise*w^2*(m1 + m2)
```
*/
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Leg<T = f64> {
        params: LegParams,
        constants: [T; 58],
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl Leg {
        /// Builds the model: checks the parameters, and computes once whatever depends on them alone.
        ///
        /// # Errors
        ///
        /// The first parameter, or combination of parameters, that is not finite or that no rigid body can
        /// have.
        pub fn new(
            params: LegParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            #[inline]
            fn rules<T: ::pendulum_core::real::Real>(given: [T; 8]) -> [T; 3] {
                let [p_m1, p_m2, p_d, p_gamma, p_knee, p_v, p_rise, p_w] = given;
                [p_m1, p_gamma, p_m2]
            }
            #[inline]
            fn constants<T: ::pendulum_core::real::Real>(given: [T; 8]) -> [T; 58] {
                let [p_m1, p_m2, p_d, p_gamma, p_knee, p_v, p_rise, p_w] = given;
                let t0 = T::from_f64(0.00806657546739626) * p_m1;
                let t1 = T::from_f64(0.0014107883817427386) * p_m2;
                let t2 = T::from_f64(0.1844536652835408) * p_m2;
                let t3 = T::from_f64(9.81) * p_m2;
                let t4 = T::from_f64(0.07913310533515731) * p_m1;
                let t5 = T::from_f64(2.0) * p_gamma;
                let t6 = T::from_f64(0.00806657546739626) * (p_w * (p_m1 * p_rise));
                let t7 = T::from_f64(0.00806657546739626) * (p_m1 * p_v);
                let t8 = T::from_f64(0.026851348547717844) * p_m2;
                let t9 = T::from_f64(0.3) * p_knee;
                let t10 = T::from_f64(1.8094904564315353) * p_m2;
                let t11 = T::from_f64(0.013839834024896266) * p_m2;
                let t12 = T::from_f64(0.5) * p_knee;
                let t13 = T::from_f64(1.6775189466484268) * p_m1;
                let t14 = T::from_f64(9.81) * p_m1;
                let t15 = p_m1 + p_m2;
                let t16 = T::from_f64(9.81) * t15;
                let t17 = p_rise * (p_w * (p_w * t15));
                let t18 = T::from_f64(0.17100091199270406) * p_m1;
                let t19 = p_m2 * p_d;
                let t20 = t18 + t19;
                let t21 = p_w * (p_rise * t18) + p_w * (p_rise * t19);
                let t22 = p_v * t18 + p_v * t19;
                let t23 = T::from_f64(0.05370269709543569) * p_m2;
                let t24 = p_d * p_d;
                let t25 = T::from_f64(1.1399908800729595e-7)
                    * (T::from_f64(223237.0) * p_m1
                        + t24 * (T::from_f64(4386000.0) * p_m2));
                let t26 = p_v * p_v;
                let t27 = T::from_f64(0.5) * (p_m1 * t26 + p_m2 * t26);
                let t28 = p_w * p_w;
                let t29 = p_rise * p_rise;
                let t30 = T::from_f64(0.5) * (t28 * (p_m1 * t29) + t28 * (p_m2 * t29));
                let t31 = p_m2 * p_m2;
                let t32 = T::from_f64(6.542534736390899e-17)
                    * (p_m2 * (T::from_f64(41777996655297.0) * p_m1)
                        + t24 * (T::from_f64(300793855162000.0) * t31));
                let t33 = T::from_f64(1.0) / t23;
                let t34 = T::from_f64(0.016110809128630707) * (p_m2 * p_knee * t33);
                let t35 = T::from_f64(-1.0) / t23;
                let t36 = p_m2 * (T::from_f64(75001.0) * p_m1);
                let t37 = p_d * (T::from_f64(438600.0) * t31);
                let t38 = T::from_f64(1.2244116984823458e-7)
                    * (t33 * (t28 * (p_rise * t36)) + t33 * (t28 * (p_rise * t37)));
                let t39 = T::from_f64(1.2011478762111813e-6) * (t33 * t36 + t33 * t37);
                let t40 = p_d * t31;
                let t41 = p_m1 * p_m2;
                let t42 = T::from_f64(0.00043319685892305394)
                    * (t33 * (t28 * (p_rise * t41)));
                let t43 = T::from_f64(0.004249661186035159) * (t33 * t41);
                let t44 = T::from_f64(0.0014107883817427386) * t19;
                let t45 = t35 * t44;
                let t46 = T::from_f64(0.1844536652835408) * t19;
                let t47 = t35 * t46;
                let t48 = p_m2 * p_rise;
                let t49 = t28 * t48;
                let t50 = T::from_f64(0.1844536652835408) * t49;
                let t51 = T::from_f64(0.0014107883817427386) * t49;
                let t52 = p_w * t48;
                let t53 = T::from_f64(0.1844536652835408) * t52;
                let t54 = T::from_f64(0.0014107883817427386) * t52;
                let t55 = t33 * (t28 * (p_rise * t40));
                let t56 = T::from_f64(0.03402315463653251) * t55;
                let t57 = T::from_f64(1.990323858060295e-6) * t55;
                let t58 = T::from_f64(0.0002602250879518833) * t55;
                let t59 = t33 * t40;
                let t60 = T::from_f64(0.33376714698438387) * t59;
                let t61 = T::from_f64(1.9525077047571496e-5) * t59;
                let t62 = T::from_f64(0.002552808112807975) * t59;
                let t63 = t33 * (p_knee * t19);
                let t64 = t19 * t19;
                let t65 = T::from_f64(0.0005204501759037666) * t64;
                let t66 = T::from_f64(0.03402116431267445) * t64;
                let t67 = T::from_f64(0.00042323651452282155) * t63;
                let t68 = T::from_f64(0.05533609958506224) * t63;
                let t69 = -t68;
                let t70 = p_m2 * p_v;
                let t71 = T::from_f64(0.0014107883817427386) * t70;
                let t72 = T::from_f64(0.1844536652835408) * t70;
                [
                    p_d,
                    p_gamma,
                    p_knee,
                    p_v,
                    p_rise,
                    p_w,
                    t0,
                    t1,
                    t2,
                    t16,
                    t3,
                    t20,
                    t21,
                    t22,
                    t23,
                    t4,
                    t5,
                    t6,
                    t7,
                    t25,
                    t8,
                    t27,
                    t30,
                    t32,
                    t38,
                    t42,
                    t34,
                    t39,
                    t43,
                    t9,
                    t35,
                    t44,
                    t46,
                    t50,
                    t51,
                    t10,
                    t11,
                    t53,
                    t54,
                    t71,
                    t72,
                    t12,
                    t65,
                    t66,
                    t56,
                    t57,
                    t58,
                    t60,
                    t61,
                    t67,
                    t68,
                    t62,
                    t45,
                    t47,
                    t69,
                    t13,
                    t14,
                    t17,
                ]
            }
            let given = params.to_array();
            for (name, value) in LegParams::NAMES.into_iter().zip(given) {
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
                        "the mass of a plate of `thigh` must be positive",
                        &[],
                    ),
                );
            }
            if !(r1 >= 0.0) {
                return Err(
                    ::pendulum_core::ParameterError::new(
                        "gamma",
                        r1,
                        "the friction of `thigh` must not be negative",
                        &[],
                    ),
                );
            }
            if !(r2 > 0.0) {
                return Err(
                    ::pendulum_core::ParameterError::new(
                        "m2",
                        r2,
                        "the mass of a plate of `shank` must be positive",
                        &[],
                    ),
                );
            }
            let constants = constants(given);
            let names: [&'static str; 58] = [
                "d",
                "gamma",
                "knee",
                "v",
                "rise",
                "w",
                "1769/219300*m1",
                "17/12050*m2",
                "3334/18075*m2",
                "9.81*(m1 + m2)",
                "9.81*m2",
                "75001/438600*m1 + m2*d",
                "75001/438600*m1*rise*w + m2*d*rise*w",
                "75001/438600*m1*v + m2*d*v",
                "258847/4820000*m2",
                "578463/7310000*m1",
                "2*gamma",
                "1769/219300*m1*rise*w",
                "1769/219300*m1*v",
                "1/8772000*(223237*m1 + 4386000*m2*d^2)",
                "258847/9640000*m2",
                "0.5*(m1*v^2 + m2*v^2)",
                "0.5*(m1*rise^2*w^2 + m2*rise^2*w^2)",
                "1/15284595960000000*(41777996655297*m1*m2 + 300793855162000*m2^2*d^2)",
                "258847/2114052000000*(75001*m1*m2*rise*w^2/(258847/4820000*m2) + 438600*m2^2*d*rise*w^2/(258847/4820000*m2))",
                "457900343/1057026000000*m1*m2*rise*w^2/(258847/4820000*m2)",
                "776541/48200000*m2*knee/(258847/4820000*m2)",
                "84642969/70468400000000*(75001*m1*m2/(258847/4820000*m2) + 438600*m2^2*d/(258847/4820000*m2))",
                "149733412161/35234200000000*m1*m2/(258847/4820000*m2)",
                "0.3*knee",
                "-1/(258847/4820000*m2)",
                "17/12050*m2*d",
                "3334/18075*m2*d",
                "3334/18075*m2*rise*w^2",
                "17/12050*m2*rise*w^2",
                "545109/301250*m2",
                "16677/1205000*m2",
                "3334/18075*m2*rise*w",
                "17/12050*m2*rise*w",
                "17/12050*m2*v",
                "3334/18075*m2*v",
                "0.5*knee",
                "56678/108901875*(m2*d)^2",
                "44459623/1306822500*(m2*d)^2",
                "11115556/326705625*m2^2*d*rise*w^2/(258847/4820000*m2)",
                "289/145202500*m2^2*d*rise*w^2/(258847/4820000*m2)",
                "28339/108901875*m2^2*d*rise*w^2/(258847/4820000*m2)",
                "302898901/907515625*m2^2*d/(258847/4820000*m2)",
                "283509/14520250000*m2^2*d/(258847/4820000*m2)",
                "51/120500*m2*d*knee/(258847/4820000*m2)",
                "1667/30125*m2*d*knee/(258847/4820000*m2)",
                "9266853/3630062500*m2^2*d/(258847/4820000*m2)",
                "-17/12050*d/(258847/4820000)",
                "-3334/18075*d/(258847/4820000)",
                "-1667/30125*m2*d*knee/(258847/4820000*m2)",
                "24525327/14620000*m1",
                "9.81*m1",
                "rise*w^2*(m1 + m2)",
            ];
            for (name, value) in names.into_iter().zip(constants) {
                if !value.is_finite() {
                    let given: [_; 8] = ::core::array::from_fn(|n| (
                        LegParams::NAMES[n],
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
        pub fn cast<T: ::pendulum_core::real::Real>(&self) -> Leg<T> {
            Leg {
                params: self.params,
                constants: self.constants.map(T::from_f64),
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> Leg<T> {
        /// The parameters that the model was built from.
        pub fn params(&self) -> &LegParams {
            &self.params
        }
        /// The model with other parameters, in the same number type. Its constants are computed anew.
        ///
        /// # Errors
        ///
        /// Those of `new`.
        pub fn with_params(
            &self,
            params: LegParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            Ok(<Leg>::new(params)?.cast())
        }
    }
    impl Leg {
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
                            "closed form, expanded, exact quotient",
                            ::pendulum_core::Operations::new(36, 46, 1, 3, 0, 39),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first, L^T D L",
                                    ::pendulum_core::Operations::new(27, 37, 1, 3, 0, 37),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, L^T D L",
                                    ::pendulum_core::Operations::new(27, 37, 1, 3, 0, 37),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, adjugate",
                                    ::pendulum_core::Operations::new(35, 39, 1, 3, 0, 39),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "articulated bodies",
                                    ::pendulum_core::Operations::new(39, 54, 2, 3, 0, 49),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C, adjugate",
                                    ::pendulum_core::Operations::new(96, 113, 1, 3, 0, 41),
                                ),
                            ],
                        ),
                ),
                (
                    "measures",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(2, 0, 0, 0, 0, 1),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(2, 0, 0, 0, 0, 1),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(2, 0, 0, 0, 0, 1),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(2, 0, 0, 0, 0, 1),
                                ),
                            ],
                        ),
                ),
                (
                    "response",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, expanded, L^T D L, exact quotient",
                            ::pendulum_core::Operations::new(42, 48, 1, 3, 0, 40),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first, L^T D L",
                                    ::pendulum_core::Operations::new(33, 39, 1, 3, 0, 38),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, L^T D L",
                                    ::pendulum_core::Operations::new(33, 39, 1, 3, 0, 38),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, inverse",
                                    ::pendulum_core::Operations::new(39, 40, 1, 3, 0, 42),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C, adjugate",
                                    ::pendulum_core::Operations::new(100, 115, 1, 3, 0, 42),
                                ),
                            ],
                        ),
                ),
                (
                    "kinetic",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, expanded",
                            ::pendulum_core::Operations::new(15, 24, 0, 3, 0, 30),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(15, 26, 0, 3, 0, 29),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(15, 28, 0, 3, 0, 30),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(30, 38, 0, 3, 0, 38),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C",
                                    ::pendulum_core::Operations::new(49, 61, 0, 3, 0, 38),
                                ),
                            ],
                        ),
                ),
                (
                    "potential",
                    ::pendulum_core::FunctionCost::new(
                            "A, B and C",
                            ::pendulum_core::Operations::new(9, 11, 0, 3, 0, 29),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(9, 11, 0, 3, 0, 29),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(10, 11, 0, 3, 0, 26),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(10, 11, 0, 3, 0, 26),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(10, 11, 0, 3, 0, 28),
                                ),
                            ],
                        ),
                ),
                (
                    "drive_forces",
                    ::pendulum_core::FunctionCost::new(
                            "recursion",
                            ::pendulum_core::Operations::new(50, 64, 1, 3, 0, 47),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C",
                                    ::pendulum_core::Operations::new(72, 84, 1, 3, 0, 44),
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
                ),
                ::pendulum_core::Slot::new(
                    "theta2",
                    ::pendulum_core::SlotKind::Angle,
                    1..2,
                    3..4,
                ),
            ],
        );
        /// The equations of motion as text.
        pub const EQUATIONS: &'static str = "A qdd + b = Q, where A is symmetric, b holds velocity terms, gravity and the inertia forces of the drives,\n    Q the forces of the joints\n\nA[theta1, theta1] = 223237/4386000*m1 + m2*d^2\nA[theta1, theta2] = 17/12050*m2*d*sin(theta1 - theta2) + 3334/18075*m2*d*cos(theta1 - theta2)\nA[theta2, theta2] = 258847/4820000*m2\nb[theta1] = 578463/7310000*m1*cos(theta1) + 327/14620000*(75001*m1 + 438600*m2*d)*sin(theta1)\n    + 3334/18075*m2*d*dot(theta2)^2*sin(theta1 - theta2) - 17/12050*m2*d*dot(theta2)^2*cos(theta1 - theta2)\n    - (75001/438600*m1*rise*w^2 + m2*d*rise*w^2)*sin(w*t)*sin(theta1) - 1769/219300*m1*rise*w^2*sin(w*t)*cos(theta1)\nb[theta2] = 17/12050*m2*d*dot(theta1)^2*cos(theta1 - theta2) + 545109/301250*m2*sin(theta2)\n    + 16677/1205000*m2*cos(theta2) - 3334/18075*m2*d*dot(theta1)^2*sin(theta1 - theta2)\n    - 3334/18075*m2*rise*w^2*sin(w*t)*sin(theta2) - 17/12050*m2*rise*w^2*sin(w*t)*cos(theta2)\nQ[theta1] = gamma*dot(theta2) + 0.3*knee + knee*theta2 - knee*theta1 - 2*gamma*dot(theta1) - force(theta2)\nQ[theta2] = force(theta2) + gamma*dot(theta1) + knee*theta1 - 0.3*knee - knee*theta2 - gamma*dot(theta2)\n\nand along what hinders the motion\nforce(theta2): stops at -2.4 and -0.02, restitution 0.2\n";
        ///The bodies whose joints are driven.
        pub const DRIVES: [&'static str; 2] = ["carried", "hip"];
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::System<T, 4> for Leg<T> {
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
            Some(&<Leg>::LAYOUT)
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn rhs_under(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
            forces: &[T; ::pendulum_core::hybrid::MOST],
        ) -> ::pendulum_core::nalgebra::SVector<T, 4> {
            let [q_theta1, q_theta2, qd_theta1, qd_theta2] = x.data.0[0];
            let f0 = forces[0];
            let k1 = self.constants[1];
            let k2 = self.constants[2];
            let k5 = self.constants[5];
            let k14 = self.constants[14];
            let k16 = self.constants[16];
            let k23 = self.constants[23];
            let k24 = self.constants[24];
            let k25 = self.constants[25];
            let k26 = self.constants[26];
            let k27 = self.constants[27];
            let k28 = self.constants[28];
            let k29 = self.constants[29];
            let k30 = self.constants[30];
            let k31 = self.constants[31];
            let k32 = self.constants[32];
            let k33 = self.constants[33];
            let k34 = self.constants[34];
            let k35 = self.constants[35];
            let k36 = self.constants[36];
            let k42 = self.constants[42];
            let k43 = self.constants[43];
            let k44 = self.constants[44];
            let k45 = self.constants[45];
            let k46 = self.constants[46];
            let k47 = self.constants[47];
            let k48 = self.constants[48];
            let k49 = self.constants[49];
            let k51 = self.constants[51];
            let k52 = self.constants[52];
            let k53 = self.constants[53];
            let k54 = self.constants[54];
            let t0 = f0 + k2 * q_theta1 - (k2 * q_theta2 + k1 * qd_theta2);
            let (sin1, _) = (k5 * t).sin_cos();
            let t2 = qd_theta2 * qd_theta2;
            let [(sin_theta2, cos_theta2), (sin_theta1, cos_theta1)] = q_theta2
                .sin_cos_pair(q_theta1);
            let t3 = cos_theta2 * sin_theta1 - cos_theta1 * sin_theta2;
            let t4 = cos_theta1 * cos_theta2 + sin_theta1 * sin_theta2;
            let t5 = k52 * t3 + k53 * t4;
            let t6 = qd_theta1 * (qd_theta1 * (k31 * t4 - k32 * t3) - k1) - t0;
            let t7 = cos_theta2 * t4 + sin_theta2 * t3;
            let t8 = k44 * (sin_theta2 * t4) + k45 * (cos_theta2 * t3) + k46 * t7
                - k24 * sin_theta1;
            let t9 = k28 * cos_theta1 + k27 * sin_theta1 + k16 * qd_theta1 + t5 * t6
                + sin1 * (t8 - k25 * cos_theta1);
            let t10 = t9 + t4 * (k54 - k47 * sin_theta2 - k31 * t2)
                + t3 * (k32 * t2 - k48 * cos_theta2 - k49);
            let t11 = k29 + t6 + cos_theta2 * (k36 - k34 * sin1)
                + sin_theta2 * (k35 - k33 * sin1);
            let t12 = k14 / (k23 + t3 * (k43 * t3 - k42 * t4))
                * (t10 + t0 - k51 * t7 - k26);
            ::pendulum_core::nalgebra::SVector::from([
                qd_theta1,
                qd_theta2,
                -t12,
                k30 * t11 - t5 * t12,
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
    for Leg<T> {
        #[inline]
        fn constraints(&self) -> &'static [::pendulum_core::hybrid::Constraint] {
            const {
                &[
                    ::pendulum_core::hybrid::Constraint {
                        name: "theta2",
                        rate: &[(2, -1), (3, 1)],
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
                low: Some(T::from_f64(-2.4)),
                high: Some(T::from_f64(-0.02)),
                restitution: T::from_f64(0.2),
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
            let [q_theta1, q_theta2, qd_theta1, qd_theta2] = x.data.0[0];
            let mut measures = [[T::from_f64(0.0); 2]; ::pendulum_core::hybrid::MOST];
            measures[0] = [q_theta2 - q_theta1, qd_theta2 - qd_theta1];
            measures
        }
        #[inline]
        fn response(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
            forces: &[T; ::pendulum_core::hybrid::MOST],
        ) -> ::pendulum_core::hybrid::Response<T, 4> {
            let [q_theta1, q_theta2, qd_theta1, qd_theta2] = x.data.0[0];
            let f0 = forces[0];
            let k1 = self.constants[1];
            let k2 = self.constants[2];
            let k5 = self.constants[5];
            let k14 = self.constants[14];
            let k16 = self.constants[16];
            let k23 = self.constants[23];
            let k24 = self.constants[24];
            let k25 = self.constants[25];
            let k26 = self.constants[26];
            let k27 = self.constants[27];
            let k28 = self.constants[28];
            let k29 = self.constants[29];
            let k30 = self.constants[30];
            let k31 = self.constants[31];
            let k32 = self.constants[32];
            let k33 = self.constants[33];
            let k34 = self.constants[34];
            let k35 = self.constants[35];
            let k36 = self.constants[36];
            let k42 = self.constants[42];
            let k43 = self.constants[43];
            let k44 = self.constants[44];
            let k45 = self.constants[45];
            let k46 = self.constants[46];
            let k47 = self.constants[47];
            let k48 = self.constants[48];
            let k49 = self.constants[49];
            let k51 = self.constants[51];
            let k52 = self.constants[52];
            let k53 = self.constants[53];
            let k54 = self.constants[54];
            let t0 = f0 + k2 * q_theta1 - (k2 * q_theta2 + k1 * qd_theta2);
            let (sin1, _) = (k5 * t).sin_cos();
            let t2 = qd_theta2 * qd_theta2;
            let [(sin_theta2, cos_theta2), (sin_theta1, cos_theta1)] = q_theta2
                .sin_cos_pair(q_theta1);
            let t3 = cos_theta2 * sin_theta1 - cos_theta1 * sin_theta2;
            let t4 = cos_theta1 * cos_theta2 + sin_theta1 * sin_theta2;
            let t5 = k14 / (k23 + t3 * (k43 * t3 - k42 * t4));
            let t6 = k52 * t3 + k53 * t4;
            let t7 = qd_theta1 * (qd_theta1 * (k31 * t4 - k32 * t3) - k1) - t0;
            let t8 = cos_theta2 * t4 + sin_theta2 * t3;
            let t9 = k44 * (sin_theta2 * t4) + k45 * (cos_theta2 * t3) + k46 * t8
                - k24 * sin_theta1;
            let t10 = k28 * cos_theta1 + k27 * sin_theta1 + k16 * qd_theta1 + t6 * t7
                + sin1 * (t9 - k25 * cos_theta1);
            let t11 = t10 + t4 * (k54 - k47 * sin_theta2 - k31 * t2)
                + t3 * (k32 * t2 - k48 * cos_theta2 - k49);
            let t12 = k29 + t7 + cos_theta2 * (k36 - k34 * sin1)
                + sin_theta2 * (k35 - k33 * sin1);
            let t13 = t5 * (t11 + t0 - k51 * t8 - k26);
            let t14 = -t13;
            let t15 = k30 * t12 - t6 * t13;
            let t16 = t13 + t15;
            let t17 = t5 * (T::from_f64(1.0) - t6);
            let t18 = -t17;
            let t19 = k30 + t6 * t17;
            let t20 = t17 - t19;
            let t21 = -t19;
            let mut response = ::pendulum_core::hybrid::Response::new(
                ::pendulum_core::nalgebra::SVector::from([
                    qd_theta1,
                    qd_theta2,
                    t14,
                    t15,
                ]),
            );
            response.accelerations[0] = t16;
            response.columns[0] = ::pendulum_core::nalgebra::SVector::from([
                T::from_f64(0.0),
                T::from_f64(0.0),
                t18,
                t21,
            ]);
            response.matrix[0][0] = t20;
            response
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Energy<T, 4> for Leg<T> {
        #[inline]
        fn kinetic(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 4>) -> T {
            let [q_theta1, q_theta2, qd_theta1, qd_theta2] = x.data.0[0];
            let k5 = self.constants[5];
            let k12 = self.constants[12];
            let k13 = self.constants[13];
            let k17 = self.constants[17];
            let k18 = self.constants[18];
            let k19 = self.constants[19];
            let k20 = self.constants[20];
            let k21 = self.constants[21];
            let k22 = self.constants[22];
            let k31 = self.constants[31];
            let k32 = self.constants[32];
            let k37 = self.constants[37];
            let k38 = self.constants[38];
            let k39 = self.constants[39];
            let k40 = self.constants[40];
            let (sin_theta2, cos_theta2) = q_theta2.sin_cos();
            let [(_, cos0), (sin_theta1, cos_theta1)] = (k5 * t).sin_cos_pair(q_theta1);
            let t1 = k20 * qd_theta2 + k40 * cos_theta2
                + cos0 * (k38 * cos_theta2 + k37 * sin_theta2);
            let t2 = k31 * (cos_theta2 * sin_theta1 - sin_theta2 * cos_theta1)
                + k32 * (cos_theta2 * cos_theta1 + sin_theta2 * sin_theta1);
            let t3 = k21 + k22 * cos0 * cos0
                + qd_theta2 * (t1 + qd_theta1 * t2 - k39 * sin_theta2);
            let t4 = k19 * qd_theta1 + k13 * cos_theta1
                + cos0 * (k17 * cos_theta1 + k12 * sin_theta1);
            t3 + qd_theta1 * (t4 - k18 * sin_theta1)
        }
        #[inline]
        fn potential(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 4>) -> T {
            let [q_theta1, q_theta2, _, _] = x.data.0[0];
            let k0 = self.constants[0];
            let k4 = self.constants[4];
            let k5 = self.constants[5];
            let k10 = self.constants[10];
            let k15 = self.constants[15];
            let k35 = self.constants[35];
            let k36 = self.constants[36];
            let k41 = self.constants[41];
            let k55 = self.constants[55];
            let k56 = self.constants[56];
            let t0 = T::from_f64(0.3) + q_theta2 - q_theta1;
            let (sin1, _) = (k5 * t).sin_cos();
            let t2 = k4 * sin1;
            let [(sin_theta1, cos_theta1), (sin_theta2, cos_theta2)] = q_theta1
                .sin_cos_pair(q_theta2);
            let t3 = k15 * sin_theta1 + k56 * t2 + k36 * sin_theta2
                + k10 * (t2 - k0 * cos_theta1);
            k41 * t0 * t0 + (t3 - k55 * cos_theta1 - k35 * cos_theta2)
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> Leg<T> {
        ///The forces that the drives supply along their joints, in the order of the declaration: N m where a joint turns, N where it slides.
        #[inline]
        pub fn drive_forces(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 2> {
            let [q_theta1, q_theta2, qd_theta1, qd_theta2] = x.data.0[0];
            let k1 = self.constants[1];
            let k2 = self.constants[2];
            let k5 = self.constants[5];
            let k6 = self.constants[6];
            let k7 = self.constants[7];
            let k8 = self.constants[8];
            let k9 = self.constants[9];
            let k11 = self.constants[11];
            let k14 = self.constants[14];
            let k16 = self.constants[16];
            let k23 = self.constants[23];
            let k24 = self.constants[24];
            let k25 = self.constants[25];
            let k26 = self.constants[26];
            let k27 = self.constants[27];
            let k28 = self.constants[28];
            let k29 = self.constants[29];
            let k30 = self.constants[30];
            let k31 = self.constants[31];
            let k32 = self.constants[32];
            let k33 = self.constants[33];
            let k34 = self.constants[34];
            let k35 = self.constants[35];
            let k36 = self.constants[36];
            let k42 = self.constants[42];
            let k43 = self.constants[43];
            let k44 = self.constants[44];
            let k45 = self.constants[45];
            let k46 = self.constants[46];
            let k47 = self.constants[47];
            let k48 = self.constants[48];
            let k49 = self.constants[49];
            let k50 = self.constants[50];
            let k51 = self.constants[51];
            let k52 = self.constants[52];
            let k53 = self.constants[53];
            let k57 = self.constants[57];
            let t0 = k2 * (q_theta1 - q_theta2) - k1 * qd_theta2;
            let t1 = qd_theta2 * qd_theta2;
            let (sin2, _) = (k5 * t).sin_cos();
            let t3 = qd_theta1 * qd_theta1;
            let t4 = qd_theta1 + qd_theta2 - qd_theta1;
            let t5 = t4 * t4;
            let [(sin_theta1, cos_theta1), (sin_theta2, cos_theta2)] = q_theta1
                .sin_cos_pair(q_theta2);
            let t6 = k6 * sin_theta1 - k11 * cos_theta1;
            let t7 = sin_theta1 * cos_theta2 - cos_theta1 * sin_theta2;
            let t8 = cos_theta1 * cos_theta2 + sin_theta1 * sin_theta2;
            let t9 = cos_theta2 * t8 + sin_theta2 * t7;
            let t10 = k46 * t9 + k45 * cos_theta2 * t7 + k44 * sin_theta2 * t8
                - k24 * sin_theta1;
            let t11 = t0 + t7 * (k32 * t1 - k48 * cos_theta2 - k49)
                + sin2 * (t10 - k25 * cos_theta1);
            let t12 = qd_theta1 * (qd_theta1 * (k31 * t8 - k32 * t7) - k1) - t0;
            let t13 = k52 * t7 + k53 * t8;
            let t14 = t11 + t13 * t12 + k16 * qd_theta1 + k27 * sin_theta1
                + k28 * cos_theta1;
            let t15 = t14 - t8 * (k50 + k31 * t1 + k47 * sin_theta2) - k51 * t9;
            let t16 = k14 / (k23 + t7 * (k43 * t7 - k42 * t8)) * (t15 - k26);
            let t17 = k29 + t12 + sin_theta2 * (k35 - k33 * sin2)
                + cos_theta2 * (k36 - k34 * sin2);
            let t18 = t16 + k30 * t17 - t16 - t13 * t16;
            let t19 = k6 * cos_theta1 + k11 * sin_theta1;
            let t20 = k7 * cos_theta2 + k8 * sin_theta2;
            let t21 = k7 * sin_theta2 - k8 * cos_theta2;
            let t22 = k9 - k57 * sin2 + t20 * t18 - t21 * t5 - t6 * t3;
            ::pendulum_core::nalgebra::SVector::from([
                t6 * t16 - (t19 * t3 + t20 * t5 + t21 * t18),
                t22 - t19 * t16,
            ])
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::shapes::Shapes<4> for Leg {
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
                        name: "thigh",
                        kind: ::pendulum_core::shapes::ShapeKind::Plate,
                        points: 6,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "shank",
                        kind: ::pendulum_core::shapes::ShapeKind::Plate,
                        points: 6,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "thigh",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "shank",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "toe",
                        kind: ::pendulum_core::shapes::ShapeKind::Point,
                        points: 1,
                        radius: false,
                    },
                ],
                &{
                    let [q_theta1, q_theta2, _, _] = x.data.0[0];
                    let k0 = self.constants[0];
                    let k3 = self.constants[3];
                    let k4 = self.constants[4];
                    let k5 = self.constants[5];
                    let t0 = t * k3;
                    let (sin1, _) = (t * k5).sin_cos();
                    let t2 = k4 * sin1;
                    let [(sin_theta1, cos_theta1), (sin_theta2, cos_theta2)] = q_theta1
                        .sin_cos_pair(q_theta2);
                    let t3 = t0
                        + (T::from_f64(0.46) * sin_theta1
                            - T::from_f64(0.03) * cos_theta1);
                    let t4 = t2
                        - (T::from_f64(0.03) * sin_theta1
                            + T::from_f64(0.46) * cos_theta1);
                    let t5 = t0
                        + (T::from_f64(0.05) * cos_theta1
                            + T::from_f64(0.44) * sin_theta1);
                    let t6 = t2
                        + (T::from_f64(0.05) * sin_theta1
                            - T::from_f64(0.44) * cos_theta1);
                    let t7 = t0
                        + (T::from_f64(0.1) * cos_theta1
                            + T::from_f64(0.15) * sin_theta1);
                    let t8 = t2
                        + (T::from_f64(0.1) * sin_theta1
                            - T::from_f64(0.15) * cos_theta1);
                    let t9 = T::from_f64(0.06) * sin_theta1;
                    let t10 = t0 - (T::from_f64(0.08) * cos_theta1 + t9);
                    let t11 = t2 - (t9 + T::from_f64(0.3) * cos_theta1);
                    let t12 = T::from_f64(0.06) * cos_theta1;
                    let t13 = t2 + (t12 - T::from_f64(0.08) * sin_theta1);
                    let t14 = t0 + (T::from_f64(0.3) * sin_theta1 - t12);
                    let t15 = T::from_f64(0.07) * cos_theta1;
                    let t16 = T::from_f64(0.07) * sin_theta1;
                    let t17 = t0 + (t15 - t16);
                    let t18 = t2 + (t15 + t16);
                    let t19 = t0 + k0 * sin_theta1;
                    let t20 = t2 - k0 * cos_theta1;
                    let t21 = t19
                        + (T::from_f64(0.12) * sin_theta2
                            - T::from_f64(0.07) * cos_theta2);
                    let t22 = t20
                        - (T::from_f64(0.07) * sin_theta2
                            + T::from_f64(0.12) * cos_theta2);
                    let t23 = t19
                        + (T::from_f64(0.4) * sin_theta2
                            - T::from_f64(0.03) * cos_theta2);
                    let t24 = t20
                        - (T::from_f64(0.03) * sin_theta2
                            + T::from_f64(0.4) * cos_theta2);
                    let t25 = T::from_f64(0.05) * cos_theta2;
                    let t26 = T::from_f64(0.05) * sin_theta2;
                    let t27 = t19 - (t25 + t26);
                    let t28 = t20 + (t25 - t26);
                    let t29 = T::from_f64(0.14) * cos_theta2
                        + T::from_f64(0.43) * sin_theta2 + t19;
                    let t30 = T::from_f64(0.14) * sin_theta2
                        - T::from_f64(0.43) * cos_theta2 + t20;
                    let t31 = T::from_f64(0.04) * cos_theta2;
                    let t32 = t20 + (t26 + t31);
                    let t33 = t19 + (t31 + T::from_f64(0.33) * sin_theta2);
                    let t34 = T::from_f64(0.04) * sin_theta2;
                    let t35 = t20 + (t34 - T::from_f64(0.33) * cos_theta2);
                    let t36 = t19 + (t25 - t34);
                    [
                        t10,
                        t13,
                        T::from_f64(0.0),
                        t14,
                        t11,
                        T::from_f64(0.0),
                        t3,
                        t4,
                        T::from_f64(0.0),
                        t5,
                        t6,
                        T::from_f64(0.0),
                        t7,
                        t8,
                        T::from_f64(0.0),
                        t17,
                        t18,
                        T::from_f64(0.0),
                        t27,
                        t28,
                        T::from_f64(0.0),
                        t21,
                        t22,
                        T::from_f64(0.0),
                        t23,
                        t24,
                        T::from_f64(0.0),
                        t29,
                        t30,
                        T::from_f64(0.0),
                        t33,
                        t35,
                        T::from_f64(0.0),
                        t36,
                        t32,
                        T::from_f64(0.0),
                        t0,
                        t2,
                        T::from_f64(0.0),
                        t19,
                        t20,
                        T::from_f64(0.0),
                        t29,
                        t30,
                        T::from_f64(0.0),
                    ]
                },
            )
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::Cast<4> for Leg {
        const HYBRID: bool = true;
        type In<T: ::pendulum_core::real::Real> = Leg<T>;
        fn cast<T: ::pendulum_core::real::Real>(&self) -> Leg<T> {
            Leg::cast(self)
        }
        #[inline]
        fn gather<'m, T: ::pendulum_core::real::lanes::Lanes>(
            models: impl ::core::ops::Fn(usize) -> &'m Self,
        ) -> Leg<T>
        where
            Self: 'm,
        {
            let scalar = <<T as ::pendulum_core::real::lanes::Lanes>::Scalar as ::pendulum_core::real::Real>::from_f64;
            Leg {
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
pub use __Leg::{Leg, LegParams};
