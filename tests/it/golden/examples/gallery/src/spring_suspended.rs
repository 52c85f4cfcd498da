#[allow(non_snake_case)]
mod __SpringSuspended {
    ///Parameters of [`SpringSuspended`].
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct SpringSuspendedParams {
        ///In kg.
        pub m: f64,
        ///In m.
        pub a: f64,
        ///In m.
        pub b: f64,
        ///In m.
        pub rest: f64,
        ///In N/m.
        pub k: f64,
        ///In N s/m.
        pub c: f64,
        ///In N.
        pub f: f64,
        ///In rad/s.
        pub w: f64,
    }
    impl ::core::default::Default for SpringSuspendedParams {
        #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
        fn default() -> Self {
            Self {
                m: 1f64,
                a: 0.3f64,
                b: 0.2f64,
                rest: 0.6f64,
                k: 60f64,
                c: 0.8f64,
                f: 1.5f64,
                w: 7f64,
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl SpringSuspendedParams {
        /// The names of the parameters, in the order of their declaration.
        pub const NAMES: [&'static str; 8] = ["m", "a", "b", "rest", "k", "c", "f", "w"];
        /// The values of the parameters, in the order of [`NAMES`](Self::NAMES).
        pub const fn to_array(self) -> [f64; 8] {
            [self.m, self.a, self.b, self.rest, self.k, self.c, self.f, self.w]
        }
        /// The parameters with these values, in the order of [`NAMES`](Self::NAMES).
        pub const fn from_array(values: [f64; 8]) -> Self {
            let [v0, v1, v2, v3, v4, v5, v6, v7] = values;
            Self {
                m: v0,
                a: v1,
                b: v2,
                rest: v3,
                k: v4,
                c: v5,
                f: v6,
                w: v7,
            }
        }
    }
    /// A plate on a damped spring, free to move and to turn in the plane.
    ///
    /**# Equations of motion

```text
A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q all other forces

A[x, x] = m
A[x, phi] = 0.5*m*a*cos(phi)
A[y, y] = m
A[y, phi] = 0.5*m*a*sin(phi)
A[phi, phi] = 1/12*(4*m*a^2 + m*b^2)
b[x] = -0.5*m*a*dot(phi)^2*sin(phi)
b[y] = 9.81*m + 0.5*m*a*dot(phi)^2*cos(phi)
b[phi] = 4.905*m*a*sin(phi)
Q[x] = -(k*x*(1 - rest/sqrt(x^2 + y^2)) + c*x*(x*dot(x) + y*dot(y))/(x^2 + y^2))
Q[y] = f*cos(w*t) - k*y*(1 - rest/sqrt(x^2 + y^2)) - c*y*(x*dot(x) + y*dot(y))/(x^2 + y^2)
```

# Constants, computed by `new`

```text
k0 = m
k1 = a
k2 = rest
k3 = k
k4 = c
k5 = f
k6 = w
k7 = 0.5*b
k8 = 1/3*m*(0.5*a^2*b + 0.5*a^2*b + 2^2*0.5*a^2*b)/(0.5*a*b + 0.5*a*b + 2*0.5*a*b)
k9 = 9.81*m
k10 = 1*(1/3)^2*m^2*(0.5*a^2*b + 0.5*a^2*b + 2^2*0.5*a^2*b)^2/((0.5*a*b + 0.5*a*b + 2*0.5*a*b)^2*(0.5*(1/6*m*(0.5*a*b*((0.5*b)^2 + 0.5*b^2) + 0.5*a*b*((0.5*b)^2 + 0.5*b^2) + 2*0.5*a*b*(0.5*b)^2)/(0.5*a*b + 0.5*a*b + 2*0.5*a*b) + 1/6*m*(0.5*a*b*((0.5*b)^2 + 0.5*b^2) + 0.5*a*b*((0.5*b)^2 + 0.5*b^2) + 2*0.5*a*b*(0.5*b)^2)/(0.5*a*b + 0.5*a*b + 2*0.5*a*b) + 1/6*m*(0.5*a^3*b + 0.5*a^3*b + 2*0.5*a*b*(a^2 + 2*a^2))/(0.5*a*b + 0.5*a*b + 2*0.5*a*b) - 1/6*m*(0.5*a^3*b + 0.5*a^3*b + 2*0.5*a*b*(a^2 + 2*a^2))/(0.5*a*b + 0.5*a*b + 2*0.5*a*b)) + 0.5*(1/6*m*(0.5*a^3*b + 0.5*a^3*b + 2*0.5*a*b*(a^2 + 2*a^2))/(0.5*a*b + 0.5*a*b + 2*0.5*a*b) + 1/6*m*(0.5*a*b*((0.5*b)^2 + 0.5*b^2) + 0.5*a*b*((0.5*b)^2 + 0.5*b^2) + 2*0.5*a*b*(0.5*b)^2)/(0.5*a*b + 0.5*a*b + 2*0.5*a*b) + 1/6*m*(0.5*a^3*b + 0.5*a^3*b + 2*0.5*a*b*(a^2 + 2*a^2))/(0.5*a*b + 0.5*a*b + 2*0.5*a*b) - 1/6*m*(0.5*a*b*((0.5*b)^2 + 0.5*b^2) + 0.5*a*b*((0.5*b)^2 + 0.5*b^2) + 2*0.5*a*b*(0.5*b)^2)/(0.5*a*b + 0.5*a*b + 2*0.5*a*b))))
k11 = m*a
k12 = rest*k
k13 = 0.5*m*a
k14 = 4.905*m*a
k15 = 1/24*(4*m*a^2 + m*b^2)
k16 = 0.5*k
k17 = 0.5*m
k18 = -1/(1/12*(4*m*a^2 + m*b^2))
k19 = m - 1*(1/3)^2*m^2*(0.5*a^2*b + 0.5*a^2*b + 2^2*0.5*a^2*b)^2/((0.5*a*b + 0.5*a*b + 2*0.5*a*b)^2*(0.5*(1/6*m*(0.5*a*b*((0.5*b)^2 + 0.5*b^2) + 0.5*a*b*((0.5*b)^2 + 0.5*b^2) + 2*0.5*a*b*(0.5*b)^2)/(0.5*a*b + 0.5*a*b + 2*0.5*a*b) + 1/6*m*(0.5*a*b*((0.5*b)^2 + 0.5*b^2) + 0.5*a*b*((0.5*b)^2 + 0.5*b^2) + 2*0.5*a*b*(0.5*b)^2)/(0.5*a*b + 0.5*a*b + 2*0.5*a*b) + 1/6*m*(0.5*a^3*b + 0.5*a^3*b + 2*0.5*a*b*(a^2 + 2*a^2))/(0.5*a*b + 0.5*a*b + 2*0.5*a*b) - 1/6*m*(0.5*a^3*b + 0.5*a^3*b + 2*0.5*a*b*(a^2 + 2*a^2))/(0.5*a*b + 0.5*a*b + 2*0.5*a*b)) + 0.5*(1/6*m*(0.5*a^3*b + 0.5*a^3*b + 2*0.5*a*b*(a^2 + 2*a^2))/(0.5*a*b + 0.5*a*b + 2*0.5*a*b) + 1/6*m*(0.5*a*b*((0.5*b)^2 + 0.5*b^2) + 0.5*a*b*((0.5*b)^2 + 0.5*b^2) + 2*0.5*a*b*(0.5*b)^2)/(0.5*a*b + 0.5*a*b + 2*0.5*a*b) + 1/6*m*(0.5*a^3*b + 0.5*a^3*b + 2*0.5*a*b*(a^2 + 2*a^2))/(0.5*a*b + 0.5*a*b + 2*0.5*a*b) - 1/6*m*(0.5*a*b*((0.5*b)^2 + 0.5*b^2) + 0.5*a*b*((0.5*b)^2 + 0.5*b^2) + 2*0.5*a*b*(0.5*b)^2)/(0.5*a*b + 0.5*a*b + 2*0.5*a*b))))
k20 = -1*1/3*m*(0.5*a^2*b + 0.5*a^2*b + 2^2*0.5*a^2*b)/((0.5*a*b + 0.5*a*b + 2*0.5*a*b)*(0.5*(1/6*m*(0.5*a*b*((0.5*b)^2 + 0.5*b^2) + 0.5*a*b*((0.5*b)^2 + 0.5*b^2) + 2*0.5*a*b*(0.5*b)^2)/(0.5*a*b + 0.5*a*b + 2*0.5*a*b) + 1/6*m*(0.5*a*b*((0.5*b)^2 + 0.5*b^2) + 0.5*a*b*((0.5*b)^2 + 0.5*b^2) + 2*0.5*a*b*(0.5*b)^2)/(0.5*a*b + 0.5*a*b + 2*0.5*a*b) + 1/6*m*(0.5*a^3*b + 0.5*a^3*b + 2*0.5*a*b*(a^2 + 2*a^2))/(0.5*a*b + 0.5*a*b + 2*0.5*a*b) - 1/6*m*(0.5*a^3*b + 0.5*a^3*b + 2*0.5*a*b*(a^2 + 2*a^2))/(0.5*a*b + 0.5*a*b + 2*0.5*a*b)) + 0.5*(1/6*m*(0.5*a^3*b + 0.5*a^3*b + 2*0.5*a*b*(a^2 + 2*a^2))/(0.5*a*b + 0.5*a*b + 2*0.5*a*b) + 1/6*m*(0.5*a*b*((0.5*b)^2 + 0.5*b^2) + 0.5*a*b*((0.5*b)^2 + 0.5*b^2) + 2*0.5*a*b*(0.5*b)^2)/(0.5*a*b + 0.5*a*b + 2*0.5*a*b) + 1/6*m*(0.5*a^3*b + 0.5*a^3*b + 2*0.5*a*b*(a^2 + 2*a^2))/(0.5*a*b + 0.5*a*b + 2*0.5*a*b) - 1/6*m*(0.5*a*b*((0.5*b)^2 + 0.5*b^2) + 0.5*a*b*((0.5*b)^2 + 0.5*b^2) + 2*0.5*a*b*(0.5*b)^2)/(0.5*a*b + 0.5*a*b + 2*0.5*a*b))))
k21 = 2*c
k22 = f*w
k23 = 3.27*m*(0.5*a^2*b + 0.5*a^2*b + 2^2*0.5*a^2*b)/(0.5*a*b + 0.5*a*b + 2*0.5*a*b)
```
*/
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct SpringSuspended<T = f64> {
        params: SpringSuspendedParams,
        constants: [T; 24],
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl SpringSuspended {
        /// Builds the model: checks the parameters, and computes once whatever depends on them alone.
        ///
        /// # Errors
        ///
        /// The first parameter, or combination of parameters, that is not finite or that no rigid body can
        /// have.
        pub fn new(
            params: SpringSuspendedParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            #[inline]
            fn rules<T: ::pendulum_core::real::Real>(given: [T; 8]) -> [T; 3] {
                let [p_m, p_a, p_b, p_rest, p_k, p_c, p_f, p_w] = given;
                [p_m, p_rest, p_c]
            }
            #[inline]
            fn constants<T: ::pendulum_core::real::Real>(given: [T; 8]) -> [T; 24] {
                let [p_m, p_a, p_b, p_rest, p_k, p_c, p_f, p_w] = given;
                let t0 = T::from_f64(9.81) * p_m;
                let t1 = p_rest * p_k;
                let t2 = T::from_f64(0.5) * p_k;
                let t3 = T::from_f64(0.5) * p_m;
                let t4 = T::from_f64(2.0) * p_c;
                let t5 = p_f * p_w;
                let t6 = T::from_f64(0.5) * p_b;
                let t7 = p_a * t6;
                let t8 = p_a * t7;
                let t9 = T::from_f64(2.0) * t7;
                let t10 = T::from_f64(2.0) * p_a;
                let t11 = p_m / (t7 + (t7 + t9));
                let t12 = (t8 + (t8 + t9 * t10)) * t11;
                let t13 = T::from_f64(3.27) * t12;
                let t14 = T::from_f64(0.3333333333333333) * t12;
                let t15 = t6 * t6;
                let t16 = t7 * (t15 + p_b * t6);
                let t17 = T::from_f64(0.16666666666666666)
                    * ((t16 + (t16 + t15 * t9)) * t11);
                let t18 = p_a * p_a;
                let t19 = t7 * t18;
                let t20 = T::from_f64(0.16666666666666666)
                    * ((t19 + (t19 + t9 * (t18 + p_a * t10))) * t11);
                let t21 = t18 * (T::from_f64(4.0) * p_m) + p_m * (p_b * p_b);
                let t22 = T::from_f64(0.041666666666666664) * t21;
                let t23 = T::from_f64(-1.0) / (T::from_f64(0.08333333333333333) * t21);
                let t24 = t17 + t20;
                let t25 = T::from_f64(1.0)
                    / (T::from_f64(0.5) * (t17 + t24 - t20)
                        + T::from_f64(0.5) * (t20 + t24 - t17));
                let t26 = t14 * t25;
                let t27 = t14 * t26;
                let t28 = p_m - t27;
                let t29 = -t26;
                let t30 = p_m * p_a;
                let t31 = T::from_f64(0.5) * t30;
                let t32 = T::from_f64(4.905) * t30;
                [
                    p_m,
                    p_a,
                    p_rest,
                    p_k,
                    p_c,
                    p_f,
                    p_w,
                    t6,
                    t14,
                    t0,
                    t27,
                    t30,
                    t1,
                    t31,
                    t32,
                    t22,
                    t2,
                    t3,
                    t23,
                    t28,
                    t29,
                    t4,
                    t5,
                    t13,
                ]
            }
            let given = params.to_array();
            for (name, value) in SpringSuspendedParams::NAMES.into_iter().zip(given) {
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
                        "the mass of a plate of `block` must be positive",
                        &[],
                    ),
                );
            }
            if !(r1 >= 0.0) {
                return Err(
                    ::pendulum_core::ParameterError::new(
                        "rest",
                        r1,
                        "the length of the spring between `hook` and `eye` must not be negative",
                        &[],
                    ),
                );
            }
            if !(r2 >= 0.0) {
                return Err(
                    ::pendulum_core::ParameterError::new(
                        "c",
                        r2,
                        "the coefficient of the damper between `hook` and `eye` must not be negative",
                        &[],
                    ),
                );
            }
            let constants = constants(given);
            let names: [&'static str; 24] = [
                "m",
                "a",
                "rest",
                "k",
                "c",
                "f",
                "w",
                "0.5*b",
                "1/3*m*(0.5*a^2*b + 0.5*a^2*b + 2^2*0.5*a^2*b)/(0.5*a*b + 0.5*a*b + 2*0.5*a*b)",
                "9.81*m",
                "1*(1/3)^2*m^2*(0.5*a^2*b + 0.5*a^2*b + 2^2*0.5*a^2*b)^2/((0.5*a*b + 0.5*a*b + 2*0.5*a*b)^2*(0.5*(1/6*m*(0.5*a*b*((0.5*b)^2 + 0.5*b^2) + 0.5*a*b*((0.5*b)^2 + 0.5*b^2) + 2*0.5*a*b*(0.5*b)^2)/(0.5*a*b + 0.5*a*b + 2*0.5*a*b) + 1/6*m*(0.5*a*b*((0.5*b)^2 + 0.5*b^2) + 0.5*a*b*((0.5*b)^2 + 0.5*b^2) + 2*0.5*a*b*(0.5*b)^2)/(0.5*a*b + 0.5*a*b + 2*0.5*a*b) + 1/6*m*(0.5*a^3*b + 0.5*a^3*b + 2*0.5*a*b*(a^2 + 2*a^2))/(0.5*a*b + 0.5*a*b + 2*0.5*a*b) - 1/6*m*(0.5*a^3*b + 0.5*a^3*b + 2*0.5*a*b*(a^2 + 2*a^2))/(0.5*a*b + 0.5*a*b + 2*0.5*a*b)) + 0.5*(1/6*m*(0.5*a^3*b + 0.5*a^3*b + 2*0.5*a*b*(a^2 + 2*a^2))/(0.5*a*b + 0.5*a*b + 2*0.5*a*b) + 1/6*m*(0.5*a*b*((0.5*b)^2 + 0.5*b^2) + 0.5*a*b*((0.5*b)^2 + 0.5*b^2) + 2*0.5*a*b*(0.5*b)^2)/(0.5*a*b + 0.5*a*b + 2*0.5*a*b) + 1/6*m*(0.5*a^3*b + 0.5*a^3*b + 2*0.5*a*b*(a^2 + 2*a^2))/(0.5*a*b + 0.5*a*b + 2*0.5*a*b) - 1/6*m*(0.5*a*b*((0.5*b)^2 + 0.5*b^2) + 0.5*a*b*((0.5*b)^2 + 0.5*b^2) + 2*0.5*a*b*(0.5*b)^2)/(0.5*a*b + 0.5*a*b + 2*0.5*a*b))))",
                "m*a",
                "rest*k",
                "0.5*m*a",
                "4.905*m*a",
                "1/24*(4*m*a^2 + m*b^2)",
                "0.5*k",
                "0.5*m",
                "-1/(1/12*(4*m*a^2 + m*b^2))",
                "m - 1*(1/3)^2*m^2*(0.5*a^2*b + 0.5*a^2*b + 2^2*0.5*a^2*b)^2/((0.5*a*b + 0.5*a*b + 2*0.5*a*b)^2*(0.5*(1/6*m*(0.5*a*b*((0.5*b)^2 + 0.5*b^2) + 0.5*a*b*((0.5*b)^2 + 0.5*b^2) + 2*0.5*a*b*(0.5*b)^2)/(0.5*a*b + 0.5*a*b + 2*0.5*a*b) + 1/6*m*(0.5*a*b*((0.5*b)^2 + 0.5*b^2) + 0.5*a*b*((0.5*b)^2 + 0.5*b^2) + 2*0.5*a*b*(0.5*b)^2)/(0.5*a*b + 0.5*a*b + 2*0.5*a*b) + 1/6*m*(0.5*a^3*b + 0.5*a^3*b + 2*0.5*a*b*(a^2 + 2*a^2))/(0.5*a*b + 0.5*a*b + 2*0.5*a*b) - 1/6*m*(0.5*a^3*b + 0.5*a^3*b + 2*0.5*a*b*(a^2 + 2*a^2))/(0.5*a*b + 0.5*a*b + 2*0.5*a*b)) + 0.5*(1/6*m*(0.5*a^3*b + 0.5*a^3*b + 2*0.5*a*b*(a^2 + 2*a^2))/(0.5*a*b + 0.5*a*b + 2*0.5*a*b) + 1/6*m*(0.5*a*b*((0.5*b)^2 + 0.5*b^2) + 0.5*a*b*((0.5*b)^2 + 0.5*b^2) + 2*0.5*a*b*(0.5*b)^2)/(0.5*a*b + 0.5*a*b + 2*0.5*a*b) + 1/6*m*(0.5*a^3*b + 0.5*a^3*b + 2*0.5*a*b*(a^2 + 2*a^2))/(0.5*a*b + 0.5*a*b + 2*0.5*a*b) - 1/6*m*(0.5*a*b*((0.5*b)^2 + 0.5*b^2) + 0.5*a*b*((0.5*b)^2 + 0.5*b^2) + 2*0.5*a*b*(0.5*b)^2)/(0.5*a*b + 0.5*a*b + 2*0.5*a*b))))",
                "-1*1/3*m*(0.5*a^2*b + 0.5*a^2*b + 2^2*0.5*a^2*b)/((0.5*a*b + 0.5*a*b + 2*0.5*a*b)*(0.5*(1/6*m*(0.5*a*b*((0.5*b)^2 + 0.5*b^2) + 0.5*a*b*((0.5*b)^2 + 0.5*b^2) + 2*0.5*a*b*(0.5*b)^2)/(0.5*a*b + 0.5*a*b + 2*0.5*a*b) + 1/6*m*(0.5*a*b*((0.5*b)^2 + 0.5*b^2) + 0.5*a*b*((0.5*b)^2 + 0.5*b^2) + 2*0.5*a*b*(0.5*b)^2)/(0.5*a*b + 0.5*a*b + 2*0.5*a*b) + 1/6*m*(0.5*a^3*b + 0.5*a^3*b + 2*0.5*a*b*(a^2 + 2*a^2))/(0.5*a*b + 0.5*a*b + 2*0.5*a*b) - 1/6*m*(0.5*a^3*b + 0.5*a^3*b + 2*0.5*a*b*(a^2 + 2*a^2))/(0.5*a*b + 0.5*a*b + 2*0.5*a*b)) + 0.5*(1/6*m*(0.5*a^3*b + 0.5*a^3*b + 2*0.5*a*b*(a^2 + 2*a^2))/(0.5*a*b + 0.5*a*b + 2*0.5*a*b) + 1/6*m*(0.5*a*b*((0.5*b)^2 + 0.5*b^2) + 0.5*a*b*((0.5*b)^2 + 0.5*b^2) + 2*0.5*a*b*(0.5*b)^2)/(0.5*a*b + 0.5*a*b + 2*0.5*a*b) + 1/6*m*(0.5*a^3*b + 0.5*a^3*b + 2*0.5*a*b*(a^2 + 2*a^2))/(0.5*a*b + 0.5*a*b + 2*0.5*a*b) - 1/6*m*(0.5*a*b*((0.5*b)^2 + 0.5*b^2) + 0.5*a*b*((0.5*b)^2 + 0.5*b^2) + 2*0.5*a*b*(0.5*b)^2)/(0.5*a*b + 0.5*a*b + 2*0.5*a*b))))",
                "2*c",
                "f*w",
                "3.27*m*(0.5*a^2*b + 0.5*a^2*b + 2^2*0.5*a^2*b)/(0.5*a*b + 0.5*a*b + 2*0.5*a*b)",
            ];
            for (name, value) in names.into_iter().zip(constants) {
                if !value.is_finite() {
                    let given: [_; 8] = ::core::array::from_fn(|n| (
                        SpringSuspendedParams::NAMES[n],
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
        pub fn cast<T: ::pendulum_core::real::Real>(&self) -> SpringSuspended<T> {
            SpringSuspended {
                params: self.params,
                constants: self.constants.map(T::from_f64),
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> SpringSuspended<T> {
        /// The parameters that the model was built from.
        pub fn params(&self) -> &SpringSuspendedParams {
            &self.params
        }
        /// The model with other parameters, in the same number type. Its constants are computed anew.
        ///
        /// # Errors
        ///
        /// Those of `new`.
        pub fn with_params(
            &self,
            params: SpringSuspendedParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            Ok(<SpringSuspended>::new(params)?.cast())
        }
    }
    impl SpringSuspended {
        ///The place of `x` in the state, where it stands in m.
        pub const X: usize = 0;
        ///The place of `dot(x)` in the state, where it stands in m/s.
        pub const DOT_X: usize = 3;
        ///The place of `y` in the state, where it stands in m.
        pub const Y: usize = 1;
        ///The place of `dot(y)` in the state, where it stands in m/s.
        pub const DOT_Y: usize = 4;
        ///The place of `phi` in the state, where it stands in rad.
        pub const PHI: usize = 2;
        ///The place of `dot(phi)` in the state, where it stands in rad/s.
        pub const DOT_PHI: usize = 5;
        /// The number of degrees of freedom; the state has twice as many components.
        pub const DOF: usize = 3;
        /// The names of the coordinates, in the order in which they, and then their rates, stand in the state.
        pub const COORDINATES: [&'static str; 3] = ["x", "y", "phi"];
        /// Counted operations of each generated function, in the form that it has and in others.
        pub const COST: ::pendulum_core::Cost = ::pendulum_core::Cost::new(
            &[
                (
                    "rhs",
                    ::pendulum_core::FunctionCost::new(
                            "articulated bodies",
                            ::pendulum_core::Operations::new(15, 27, 4, 2, 1, 43),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first, L^T D L",
                                    ::pendulum_core::Operations::new(17, 34, 3, 2, 1, 40),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, L^T D L",
                                    ::pendulum_core::Operations::new(17, 34, 3, 2, 1, 40),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, L^T D L",
                                    ::pendulum_core::Operations::new(17, 33, 4, 2, 1, 40),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L",
                                    ::pendulum_core::Operations::new(20, 41, 3, 2, 1, 40),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C, L^T D L",
                                    ::pendulum_core::Operations::new(29, 41, 5, 2, 1, 51),
                                ),
                            ],
                        ),
                ),
                (
                    "jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first, L^T D L, derived and expanded",
                            ::pendulum_core::Operations::new(53, 110, 3, 2, 1, 53),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, L^T D L, derived in the graph",
                                    ::pendulum_core::Operations::new(48, 106, 5, 2, 1, 53),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, L^T D L, derived in the graph",
                                    ::pendulum_core::Operations::new(48, 106, 7, 2, 1, 54),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L, derived and expanded",
                                    ::pendulum_core::Operations::new(60, 125, 3, 2, 1, 53),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C, L^T D L, derived in the graph",
                                    ::pendulum_core::Operations::new(77, 130, 8, 2, 1, 63),
                                ),
                            ],
                        ),
                ),
                (
                    "time_derivative",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first, L^T D L, derived and expanded",
                            ::pendulum_core::Operations::new(5, 17, 2, 2, 0, 40),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, L^T D L, derived and expanded",
                                    ::pendulum_core::Operations::new(5, 17, 2, 2, 0, 40),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L, derived and expanded",
                                    ::pendulum_core::Operations::new(5, 17, 2, 2, 0, 40),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion, L^T D L, derived in the graph",
                                    ::pendulum_core::Operations::new(5, 17, 2, 2, 0, 41),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C, L^T D L, derived in the graph",
                                    ::pendulum_core::Operations::new(17, 30, 3, 2, 0, 50),
                                ),
                            ],
                        ),
                ),
                (
                    "kinetic",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, expanded",
                            ::pendulum_core::Operations::new(4, 8, 0, 1, 0, 26),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(4, 9, 0, 1, 0, 25),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(4, 10, 0, 1, 0, 26),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(6, 13, 0, 1, 0, 28),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C",
                                    ::pendulum_core::Operations::new(18, 25, 0, 1, 0, 32),
                                ),
                            ],
                        ),
                ),
                (
                    "potential",
                    ::pendulum_core::FunctionCost::new(
                            "A, B and C",
                            ::pendulum_core::Operations::new(4, 6, 0, 1, 1, 23),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(4, 6, 0, 1, 1, 23),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(5, 6, 0, 1, 1, 23),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(5, 6, 0, 1, 1, 23),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(6, 7, 0, 1, 1, 23),
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
                    "x",
                    ::pendulum_core::SlotKind::Length,
                    0..1,
                    3..4,
                ),
                ::pendulum_core::Slot::new(
                    "y",
                    ::pendulum_core::SlotKind::Length,
                    1..2,
                    4..5,
                ),
                ::pendulum_core::Slot::new(
                        "phi",
                        ::pendulum_core::SlotKind::Angle,
                        2..3,
                        5..6,
                    )
                    .periodic(),
            ],
        );
        /// The equations of motion as text.
        pub const EQUATIONS: &'static str = "A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q all other forces\n\nA[x, x] = m\nA[x, phi] = 0.5*m*a*cos(phi)\nA[y, y] = m\nA[y, phi] = 0.5*m*a*sin(phi)\nA[phi, phi] = 1/12*(4*m*a^2 + m*b^2)\nb[x] = -0.5*m*a*dot(phi)^2*sin(phi)\nb[y] = 9.81*m + 0.5*m*a*dot(phi)^2*cos(phi)\nb[phi] = 4.905*m*a*sin(phi)\nQ[x] = -(k*x*(1 - rest/sqrt(x^2 + y^2)) + c*x*(x*dot(x) + y*dot(y))/(x^2 + y^2))\nQ[y] = f*cos(w*t) - k*y*(1 - rest/sqrt(x^2 + y^2)) - c*y*(x*dot(x) + y*dot(y))/(x^2 + y^2)\n";
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::System<T, 6>
    for SpringSuspended<T> {
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn rhs(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 6>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 6> {
            let [q_x, q_y, q_phi, qd_x, qd_y, qd_phi] = x.data.0[0];
            let k0 = self.constants[0];
            let k2 = self.constants[2];
            let k3 = self.constants[3];
            let k4 = self.constants[4];
            let k5 = self.constants[5];
            let k6 = self.constants[6];
            let k8 = self.constants[8];
            let k10 = self.constants[10];
            let k19 = self.constants[19];
            let k20 = self.constants[20];
            let t0 = k8 * qd_phi * qd_phi;
            let t1 = q_x * q_x + q_y * q_y;
            let t2 = k3 * (T::from_f64(1.0) - k2 / t1.sqrt())
                + k4 * (q_x * qd_x + q_y * qd_y) / t1;
            let [(sin_phi, cos_phi), (_, cos3)] = q_phi.sin_cos_pair(k6 * t);
            let t4 = k10 * cos_phi;
            let t5 = cos_phi * t4;
            let t6 = t4 * sin_phi;
            let t7 = k19 + t5;
            let t8 = T::from_f64(1.0) / t7;
            let t9 = t6 * t8;
            let t10 = k5 * cos3 - cos_phi * t0 - q_y * t2;
            let t11 = T::from_f64(1.0) / (k0 - t5 - t6 * t9)
                * (sin_phi * t0 + t9 * t10 - q_x * t2);
            let t12 = t8 * (t10 + t6 * t11 - T::from_f64(9.81) * t7);
            ::pendulum_core::nalgebra::SVector::from([
                qd_x,
                qd_y,
                qd_phi,
                t11,
                t12,
                k20 * (cos_phi * t11 + sin_phi * (T::from_f64(9.81) + t12)),
            ])
        }
        #[inline]
        fn layout(
            &self,
        ) -> ::core::option::Option<&'static ::pendulum_core::StateLayout> {
            Some(&<SpringSuspended>::LAYOUT)
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Jacobian<T, 6>
    for SpringSuspended<T> {
        #[inline]
        fn jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 6>,
        ) -> ::pendulum_core::nalgebra::SMatrix<T, 6, 6> {
            self.rhs_and_jacobian(t, x).1
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn rhs_and_jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 6>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 6>,
            ::pendulum_core::nalgebra::SMatrix<T, 6, 6>,
        ) {
            let [q_x, q_y, q_phi, qd_x, qd_y, qd_phi] = x.data.0[0];
            let k0 = self.constants[0];
            let k3 = self.constants[3];
            let k4 = self.constants[4];
            let k5 = self.constants[5];
            let k6 = self.constants[6];
            let k9 = self.constants[9];
            let k11 = self.constants[11];
            let k12 = self.constants[12];
            let k13 = self.constants[13];
            let k14 = self.constants[14];
            let k18 = self.constants[18];
            let k21 = self.constants[21];
            let t0 = q_x * q_x + q_y * q_y;
            let t1 = T::from_f64(1.0) / t0;
            let t2 = k12 * t0.sqrt();
            let t3 = k4 * (q_x * qd_x + q_y * qd_y);
            let t4 = k3 + t1 * (t3 - t2);
            let t5 = t1 * (t2 - T::from_f64(2.0) * t3);
            let t6 = qd_phi * qd_phi;
            let t7 = k13 * t6;
            let t8 = k4 * q_y;
            let t9 = q_x * t5;
            let t10 = q_y * t5;
            let t11 = k3 + t1 * (qd_y * t8 + q_x * (k21 * qd_x + t9) - t2);
            let t12 = q_y * t1;
            let t13 = (t9 + k4 * qd_x) * t12;
            let t14 = t8 * t12;
            let t15 = q_x * t1;
            let t16 = k4 * q_x;
            let t17 = k3 + t1 * (qd_x * t16 + q_y * (t10 + k21 * qd_y) - t2);
            let t18 = t16 * t12;
            let t19 = k11 * qd_phi;
            let [(sin_phi, cos_phi), (_, cos20)] = q_phi.sin_cos_pair(k6 * t);
            let t21 = k13 * cos_phi;
            let t22 = k18 * t21;
            let t23 = k13 * sin_phi;
            let t24 = k18 * t23;
            let t25 = T::from_f64(-1.0) / (k0 + t23 * t24);
            let t26 = t21 * t24;
            let t27 = t26 * t25;
            let t28 = T::from_f64(-1.0) / (k0 + t21 * t22 + t26 * t27);
            let t29 = t28 * (t11 + t27 * t13);
            let t30 = t25 * t13 + t27 * t29;
            let t31 = t22 * t29 + t24 * t30;
            let t32 = t28 * ((k4 * qd_y + t10) * t15 + t27 * t17);
            let t33 = t28 * (t16 * t15 + t27 * t18);
            let t34 = t25 * t17 + t27 * t32;
            let t35 = t22 * t32 + t24 * t34;
            let t36 = k14 * sin_phi;
            let t37 = k9 + cos_phi * t7 + q_y * t4 + t24 * t36 - k5 * cos20;
            let t38 = t28 * (q_x * t4 + t22 * t36 + t27 * t37 - sin_phi * t7);
            let t39 = t25 * t37 + t27 * t38;
            let t40 = k18 * t36 + t22 * t38 + t24 * t39;
            let t41 = k11
                * (cos_phi * (T::from_f64(4.905) + T::from_f64(0.5) * t39)
                    - T::from_f64(0.5) * sin_phi * t38);
            let t42 = k13 * (cos_phi * t40 - sin_phi * t6) + t24 * t41;
            let t43 = t22 * t41 + t27 * t42 - k13 * (cos_phi * t6 + sin_phi * t40);
            let t44 = t28 * t43;
            let t45 = t25 * t42 + t27 * t44;
            let t46 = k18 * t41 + t22 * t44 + t24 * t45;
            let t47 = t25 * t18 + t27 * t33;
            let t48 = t22 * t33 + t24 * t47;
            let t49 = t28 * (t18 + t27 * t14);
            let t50 = t25 * t14 + t27 * t49;
            let t51 = t22 * t49 + t24 * t50;
            let t52 = cos_phi * t19;
            let t53 = t28 * (t27 * t52 - sin_phi * t19);
            let t54 = t25 * t52 + t27 * t53;
            let t55 = t22 * t53 + t24 * t54;
            (
                ::pendulum_core::nalgebra::SVector::from([
                    qd_x,
                    qd_y,
                    qd_phi,
                    t38,
                    t39,
                    t40,
                ]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t29,
                        t30,
                        t31,
                    ],
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t32,
                        t34,
                        t35,
                    ],
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t44,
                        t45,
                        t46,
                    ],
                    [
                        T::from_f64(1.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t33,
                        t47,
                        t48,
                    ],
                    [
                        T::from_f64(0.0),
                        T::from_f64(1.0),
                        T::from_f64(0.0),
                        t49,
                        t50,
                        t51,
                    ],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(1.0), t53, t54, t55],
                ]),
            )
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn time_derivative(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 6>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 6> {
            let [_, _, q_phi, _, _, _] = x.data.0[0];
            let k0 = self.constants[0];
            let k6 = self.constants[6];
            let k13 = self.constants[13];
            let k18 = self.constants[18];
            let k22 = self.constants[22];
            let [(sin_phi, cos_phi), (sin0, _)] = q_phi.sin_cos_pair(t * k6);
            let t1 = cos_phi * k13;
            let t2 = t1 * k18;
            let t3 = sin_phi * k13;
            let t4 = sin0 * k22;
            let t5 = t3 * k18;
            let t6 = T::from_f64(-1.0) / (k0 + t3 * t5);
            let t7 = t1 * t5;
            let t8 = t7 * t6;
            let t9 = T::from_f64(-1.0) / (k0 + t1 * t2 + t7 * t8) * (t8 * t4);
            let t10 = t6 * t4 + t8 * t9;
            ::pendulum_core::nalgebra::SVector::from([
                T::from_f64(0.0),
                T::from_f64(0.0),
                T::from_f64(0.0),
                t9,
                t10,
                t2 * t9 + t5 * t10,
            ])
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Energy<T, 6>
    for SpringSuspended<T> {
        #[inline]
        fn kinetic(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 6>) -> T {
            let [_, _, q_phi, qd_x, qd_y, qd_phi] = x.data.0[0];
            let k13 = self.constants[13];
            let k15 = self.constants[15];
            let k17 = self.constants[17];
            let (sin_phi, cos_phi) = q_phi.sin_cos();
            qd_phi * (k15 * qd_phi + k13 * (cos_phi * qd_x + sin_phi * qd_y))
                + k17 * (qd_x * qd_x + qd_y * qd_y)
        }
        #[inline]
        fn potential(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 6>) -> T {
            let [q_x, q_y, q_phi, _, _, _] = x.data.0[0];
            let k2 = self.constants[2];
            let k9 = self.constants[9];
            let k16 = self.constants[16];
            let k23 = self.constants[23];
            let t0 = (q_x * q_x + q_y * q_y).sqrt() - k2;
            let (_, cos_phi) = q_phi.sin_cos();
            k16 * t0 * t0 + (k9 * q_y - k23 * cos_phi)
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::shapes::Shapes<6> for SpringSuspended {
        fn shapes(
            &self,
            t: f64,
            x: &::pendulum_core::nalgebra::SVector<f64, 6>,
        ) -> ::pendulum_core::shapes::Vec<::pendulum_core::shapes::Shape> {
            use ::pendulum_core::real::Real as _;
            type T = f64;
            ::pendulum_core::shapes::placed(
                &[
                    ::pendulum_core::shapes::Outline {
                        name: "block",
                        kind: ::pendulum_core::shapes::ShapeKind::Plate,
                        points: 4,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "block",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "ground",
                        kind: ::pendulum_core::shapes::ShapeKind::Spring,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "ground",
                        kind: ::pendulum_core::shapes::ShapeKind::Damper,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "hook",
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
                    let [q_x, q_y, q_phi, _, _, _] = x.data.0[0];
                    let k1 = self.constants[1];
                    let k7 = self.constants[7];
                    let (sin_phi, cos_phi) = q_phi.sin_cos();
                    let t0 = k7 * cos_phi;
                    let t1 = q_x - t0;
                    let t2 = q_x + t0;
                    let t3 = k7 * sin_phi;
                    let t4 = q_y - t3;
                    let t5 = q_y + t3;
                    let t6 = k1 * sin_phi;
                    let t7 = t1 + t6;
                    let t8 = t6 + t2;
                    let t9 = k1 * cos_phi;
                    let t10 = t4 - t9;
                    let t11 = t5 - t9;
                    [
                        t1,
                        t4,
                        T::from_f64(0.0),
                        t7,
                        t10,
                        T::from_f64(0.0),
                        t8,
                        t11,
                        T::from_f64(0.0),
                        t2,
                        t5,
                        T::from_f64(0.0),
                        q_x,
                        q_y,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        q_x,
                        q_y,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        q_x,
                        q_y,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        q_x,
                        q_y,
                        T::from_f64(0.0),
                    ]
                },
            )
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::CastJacobian<6> for SpringSuspended {
        #[inline]
        fn with_jacobian<T: ::pendulum_core::real::Real>(
            model: &SpringSuspended<T>,
        ) -> &impl ::pendulum_core::Jacobian<T, 6> {
            model
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::Cast<6> for SpringSuspended {
        type In<T: ::pendulum_core::real::Real> = SpringSuspended<T>;
        fn cast<T: ::pendulum_core::real::Real>(&self) -> SpringSuspended<T> {
            SpringSuspended::cast(self)
        }
        #[inline]
        fn gather<'m, T: ::pendulum_core::real::lanes::Lanes>(
            models: impl ::core::ops::Fn(usize) -> &'m Self,
        ) -> SpringSuspended<T>
        where
            Self: 'm,
        {
            let scalar = <<T as ::pendulum_core::real::lanes::Lanes>::Scalar as ::pendulum_core::real::Real>::from_f64;
            SpringSuspended {
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
pub use __SpringSuspended::{SpringSuspended, SpringSuspendedParams};
