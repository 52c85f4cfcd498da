#[allow(non_snake_case)]
mod __CartPole {
    ///Parameters of [`CartPole`].
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct CartPoleParams {
        ///In kg.
        pub cart: f64,
        ///In kg.
        pub pole: f64,
        ///In m.
        pub l: f64,
        ///In m/s^2.
        pub g: f64,
    }
    impl ::core::default::Default for CartPoleParams {
        #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
        fn default() -> Self {
            Self {
                cart: 1f64,
                pole: 0.2f64,
                l: 0.6f64,
                g: 9.81f64,
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl CartPoleParams {
        /// Names of the parameters, in the order of their declaration.
        pub const NAMES: [&'static str; 4] = ["cart", "pole", "l", "g"];
        /// Returns the values of the parameters, in the order of [`NAMES`](Self::NAMES).
        pub const fn to_array(self) -> [f64; 4] {
            [self.cart, self.pole, self.l, self.g]
        }
        /// Builds parameters from their values, in the order of [`NAMES`](Self::NAMES).
        pub const fn from_array(values: [f64; 4]) -> Self {
            let [v0, v1, v2, v3] = values;
            Self {
                cart: v0,
                pole: v1,
                l: v2,
                g: v3,
            }
        }
    }
    ///Inputs of [`CartPole`], given at each evaluation.
    #[derive(Clone, Copy, Debug, Default, PartialEq)]
    pub struct CartPoleInputs<T = f64> {
        ///In N.
        pub push: T,
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T> ::core::convert::From<[T; 1]> for CartPoleInputs<T> {
        #[inline]
        fn from(values: [T; 1]) -> Self {
            let [v0] = values;
            Self { push: v0 }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T> ::core::convert::From<CartPoleInputs<T>> for [T; 1] {
        #[inline]
        fn from(inputs: CartPoleInputs<T>) -> Self {
            [inputs.push]
        }
    }
    /// A pole hinged to a cart; the angle is 0 upright.
    ///
    /**# Equations of motion

```text
A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints

A[s, s] = cart + pole
A[s, theta] = -0.5*pole*l*cos(theta)
A[theta, theta] = 1/3*pole*l^2
b[s] = 0.5*pole*l*dot(theta)^2*sin(theta)
b[theta] = -0.5*pole*l*g*sin(theta)
Q[s] = push
```

# Constants, computed by `new`

```text
k0 = 0.25*(pole*l)^2
k1 = 0.5*pole*l
k2 = 1/3*pole*l^2
k3 = 0.5*pole*l*g
k4 = 1/6*pole*l^2
k5 = 1/12*(4*cart*pole*l^2 + pole^2*l^2)
k6 = -1/(1/3*pole*l^2)
k7 = 0.5*(cart + pole)
k8 = -0.5/(1/3*l)
```
*/
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct CartPole<T = f64> {
        params: CartPoleParams,
        constants: [T; 9],
    }
    /// Constants of the model, from its parameters.
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    #[inline]
    fn constants<T: ::pendulum_core::real::Real>(given: [T; 4]) -> [T; 9] {
        let [p_cart, p_pole, p_l, p_g] = given;
        let t0 = T::from_f64(0.5) * (p_cart + p_pole);
        let t1 = p_pole * p_l;
        let t2 = T::from_f64(0.25) * (t1 * t1);
        let t3 = T::from_f64(0.5) * (p_g * t1);
        let t4 = T::from_f64(0.5) * t1;
        let t5 = p_l * p_l;
        let t6 = T::from_f64(0.08333333333333333)
            * t5.mul_add(p_pole * p_pole, t5 * (p_pole * (T::from_f64(4.0) * p_cart)));
        let t7 = p_pole * t5;
        let t8 = T::from_f64(0.16666666666666666) * t7;
        let t9 = T::from_f64(0.3333333333333333) * t7;
        let t10 = T::from_f64(-1.0) / t9;
        let t11 = t4 * t10;
        [t2, t4, t9, t3, t8, t6, t10, t0, t11]
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl CartPole {
        /// Builds the model: checks the parameters, and computes all constants that depend on them alone.
        ///
        /// # Errors
        ///
        /// Returns the first parameter, or combination of parameters, that is not finite or is impossible for a
        /// rigid body.
        pub fn new(
            params: CartPoleParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            #[inline]
            fn rules<T: ::pendulum_core::real::Real>(given: [T; 4]) -> [T; 2] {
                let [p_cart, p_pole, p_l, p_g] = given;
                [p_cart, p_pole]
            }
            let given = params.to_array();
            for (name, value) in CartPoleParams::NAMES.into_iter().zip(given) {
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
                        "cart",
                        r0,
                        "the mass of `slider` must be positive",
                        &[],
                    ),
                );
            }
            if !(r1 > 0.0) {
                return Err(
                    ::pendulum_core::ParameterError::new(
                        "pole",
                        r1,
                        "the mass of a rod of `rod` must be positive",
                        &[],
                    ),
                );
            }
            let constants = constants(given);
            let names: [&'static str; 9] = [
                "0.25*(pole*l)^2",
                "0.5*pole*l",
                "1/3*pole*l^2",
                "0.5*pole*l*g",
                "1/6*pole*l^2",
                "1/12*(4*cart*pole*l^2 + pole^2*l^2)",
                "-1/(1/3*pole*l^2)",
                "0.5*(cart + pole)",
                "-0.5/(1/3*l)",
            ];
            for (name, value) in names.into_iter().zip(constants) {
                if !value.is_finite() {
                    let given: [_; 4] = ::core::array::from_fn(|n| (
                        CartPoleParams::NAMES[n],
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
        pub fn cast<T: ::pendulum_core::real::Real>(&self) -> CartPole<T> {
            CartPole {
                params: self.params,
                constants: self.constants.map(T::from_f64),
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> CartPole<T> {
        /// Returns the parameters from which the model was built.
        pub fn params(&self) -> &CartPoleParams {
            &self.params
        }
        /// Returns a model with other parameters, in the same number type, and recomputes its constants.
        ///
        /// # Errors
        ///
        /// Returns the errors of `new`.
        pub fn with_params(
            &self,
            params: CartPoleParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            Ok(<CartPole>::new(params)?.cast())
        }
    }
    impl CartPole {
        ///Index of `s` in the state, in m.
        pub const S: usize = 0;
        ///Index of `dot(s)` in the state, in m/s.
        pub const DOT_S: usize = 2;
        ///Index of `theta` in the state, in rad.
        pub const THETA: usize = 1;
        ///Index of `dot(theta)` in the state, in rad/s.
        pub const DOT_THETA: usize = 3;
        /// Number of degrees of freedom. The state has twice as many components.
        pub const DOF: usize = 2;
        /// Names of the coordinates. The state holds their positions and then their rates in this order.
        pub const COORDINATES: [&'static str; 2] = ["s", "theta"];
        /// Operation counts of each generated function, in its own form and in others.
        pub const COST: ::pendulum_core::Cost = ::pendulum_core::Cost::new(
            &[
                (
                    "rhs",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factored, exact quotient",
                            ::pendulum_core::Operations::new(5, 11, 1, 1, 0, 30),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L",
                                    ::pendulum_core::Operations::new(5, 11, 1, 1, 0, 30),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, adjugate",
                                    ::pendulum_core::Operations::new(4, 12, 1, 1, 0, 28),
                                ),
                            ],
                        ),
                ),
                (
                    "jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factored, L^T D L, exact quotient, derived in the graph",
                            ::pendulum_core::Operations::new(11, 24, 1, 1, 0, 36),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, inverse, derived and expanded",
                                    ::pendulum_core::Operations::new(8, 27, 1, 1, 0, 35),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, inverse, derived in the graph",
                                    ::pendulum_core::Operations::new(8, 27, 1, 1, 0, 35),
                                ),
                            ],
                        ),
                ),
                (
                    "input_jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factored, L^T D L, exact quotient, derived and expanded",
                            ::pendulum_core::Operations::new(2, 4, 1, 1, 0, 29),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L, derived and expanded",
                                    ::pendulum_core::Operations::new(2, 4, 1, 1, 0, 29),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, adjugate, derived in the graph",
                                    ::pendulum_core::Operations::new(2, 4, 1, 1, 0, 28),
                                ),
                            ],
                        ),
                ),
                (
                    "kinetic",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, expanded",
                            ::pendulum_core::Operations::new(2, 6, 0, 1, 0, 25),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factored",
                                    ::pendulum_core::Operations::new(2, 7, 0, 1, 0, 25),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(3, 8, 0, 1, 0, 26),
                                ),
                            ],
                        ),
                ),
                (
                    "potential",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factored",
                            ::pendulum_core::Operations::new(0, 1, 0, 1, 0, 21),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(0, 1, 0, 1, 0, 21),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(0, 1, 0, 1, 0, 21),
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
                    "s",
                    ::pendulum_core::SlotKind::Length,
                    0..1,
                    2..3,
                ),
                ::pendulum_core::Slot::new(
                    "theta",
                    ::pendulum_core::SlotKind::Angle,
                    1..2,
                    3..4,
                ),
            ],
        );
        /// Equations of motion as text.
        pub const EQUATIONS: &'static str = "A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints\n\nA[s, s] = cart + pole\nA[s, theta] = -0.5*pole*l*cos(theta)\nA[theta, theta] = 1/3*pole*l^2\nb[s] = 0.5*pole*l*dot(theta)^2*sin(theta)\nb[theta] = -0.5*pole*l*g*sin(theta)\nQ[s] = push\n";
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Plant<T, 4> for CartPole<T> {
        type Given = CartPoleInputs<T>;
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn eval(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
            u: &CartPoleInputs<T>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 4> {
            let [_, q_theta, qd_s, qd_theta] = x.data.0[0];
            let u_push = u.push;
            let k0 = self.constants[0];
            let k1 = self.constants[1];
            let k2 = self.constants[2];
            let k3 = self.constants[3];
            let k5 = self.constants[5];
            let k6 = self.constants[6];
            let k8 = self.constants[8];
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            let t0 = k3 * sin_theta;
            let t1 = k8 * cos_theta;
            let t2 = (t0.mul_add(t1, k1 * sin_theta * qd_theta * qd_theta) - u_push)
                * (k2 / (k0 * sin_theta).mul_add(sin_theta, k5));
            ::pendulum_core::nalgebra::SVector::from([
                qd_s,
                qd_theta,
                -t2,
                k6.mul_neg_add(t0, t1 * t2),
            ])
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::PlantJacobian<T, 4>
    for CartPole<T> {
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn eval_with_jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
            u: &CartPoleInputs<T>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 4>,
            ::pendulum_core::nalgebra::SMatrix<T, 4, 4>,
        ) {
            let [_, q_theta, qd_s, qd_theta] = x.data.0[0];
            let u_push = u.push;
            let k0 = self.constants[0];
            let k1 = self.constants[1];
            let k2 = self.constants[2];
            let k3 = self.constants[3];
            let k5 = self.constants[5];
            let k6 = self.constants[6];
            let k8 = self.constants[8];
            let t0 = k1 * qd_theta;
            let t1 = qd_theta * t0;
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            let t2 = k3 * sin_theta;
            let t3 = k8 * cos_theta;
            let t4 = k2 / (k0 * sin_theta).mul_add(sin_theta, k5);
            let t5 = T::from_f64(2.0) * sin_theta * t0 * t4;
            let t6 = -t5;
            let t7 = t3 * t5;
            let t8 = (t2.mul_add(t3, sin_theta * t1) - u_push) * t4;
            let t9 = -t8;
            let t10 = k6.mul_neg_add(t2, t3 * t8);
            let t11 = k1 * sin_theta;
            let t12 = t8.mul_add(t11, k3 * cos_theta);
            let t13 = t4 * t3.mul_add(t12, t10.mul_add(t11, t1 * cos_theta));
            let t14 = k6.mul_neg_add(t12, t3 * t13);
            let t15 = -t13;
            (
                ::pendulum_core::nalgebra::SVector::from([qd_s, qd_theta, t9, t10]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                    ],
                    [T::from_f64(0.0), T::from_f64(0.0), t15, t14],
                    [
                        T::from_f64(1.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                    ],
                    [T::from_f64(0.0), T::from_f64(1.0), t6, t7],
                ]),
            )
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn eval_time_derivative(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
            u: &CartPoleInputs<T>,
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
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Controlled<T, 4, 1>
    for CartPole<T> {
        type Inputs = CartPoleInputs<T>;
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn input_jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
            u: &CartPoleInputs<T>,
        ) -> ::pendulum_core::nalgebra::SMatrix<T, 4, 1> {
            let [_, q_theta, _, _] = x.data.0[0];
            let k0 = self.constants[0];
            let k2 = self.constants[2];
            let k5 = self.constants[5];
            let k8 = self.constants[8];
            let (sin_theta, cos_theta) = q_theta.sin_cos();
            let t0 = k2 / (k0 * sin_theta).mul_add(sin_theta, k5);
            ::pendulum_core::nalgebra::SMatrix::from([
                [T::from_f64(0.0), T::from_f64(0.0), t0, -(k8 * t0 * cos_theta)],
            ])
        }
        #[inline]
        fn layout(&self) -> ::core::option::Option<::pendulum_core::StateLayout<'_>> {
            Some(<CartPole>::LAYOUT)
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Energy<T, 4> for CartPole<T> {
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn kinetic(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 4>) -> T {
            let [_, q_theta, qd_s, qd_theta] = x.data.0[0];
            let k1 = self.constants[1];
            let k4 = self.constants[4];
            let k7 = self.constants[7];
            let (_, cos_theta) = q_theta.sin_cos();
            qd_theta
                .mul_add(
                    k1.mul_neg_add(qd_s * cos_theta, k4 * qd_theta),
                    k7 * qd_s * qd_s,
                )
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn potential(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 4>) -> T {
            let [_, q_theta, _, _] = x.data.0[0];
            let k3 = self.constants[3];
            let (_, cos_theta) = q_theta.sin_cos();
            cos_theta * k3
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::ParametricControlled<4, 1, 4> for CartPole {
        fn parameters(&self) -> [f64; 4] {
            self.params.to_array()
        }
        fn parameter_names(&self) -> [&str; 4] {
            CartPoleParams::NAMES
        }
        fn check_parameters(
            &self,
            parameters: &[f64; 4],
        ) -> ::core::result::Result<(), ::pendulum_core::ParameterError> {
            Self::new(CartPoleParams::from_array(*parameters)).map(|_| ())
        }
        fn with_parameters<T: ::pendulum_core::real::Real>(
            &self,
            parameters: [T; 4],
        ) -> CartPole<T> {
            CartPole {
                params: self.params,
                constants: constants(parameters),
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::CastControlled<4, 1> for CartPole {
        type In<T: ::pendulum_core::real::Real> = CartPole<T>;
        fn cast<T: ::pendulum_core::real::Real>(&self) -> CartPole<T> {
            CartPole::cast(self)
        }
        #[inline]
        fn gather<'m, T: ::pendulum_core::real::lanes::Lanes>(
            models: impl ::core::ops::Fn(usize) -> &'m Self,
        ) -> CartPole<T>
        where
            Self: 'm,
        {
            let scalar = <<T as ::pendulum_core::real::lanes::Lanes>::Scalar as ::pendulum_core::real::Real>::from_f64;
            CartPole {
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
use __CartPole::{CartPole, CartPoleParams, CartPoleInputs};
