#[allow(non_snake_case)]
mod __Bennett {
    ///Parameters of [`Bennett`].
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct BennettParams {
        ///In rad.
        pub skew: f64,
        ///In rad.
        pub other: f64,
        ///In N m.
        pub drive: f64,
        ///In N m s.
        pub gamma: f64,
    }
    impl ::core::default::Default for BennettParams {
        #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
        fn default() -> Self {
            Self {
                skew: 0.4f64,
                other: 0.8928089789005025f64,
                drive: 0.4f64,
                gamma: 0.05f64,
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl BennettParams {
        /// The names of the parameters, in the order of their declaration.
        pub const NAMES: [&'static str; 4] = ["skew", "other", "drive", "gamma"];
        /// The values of the parameters, in the order of [`NAMES`](Self::NAMES).
        pub const fn to_array(self) -> [f64; 4] {
            [self.skew, self.other, self.drive, self.gamma]
        }
        /// The parameters with these values, in the order of [`NAMES`](Self::NAMES).
        pub const fn from_array(values: [f64; 4]) -> Self {
            let [v0, v1, v2, v3] = values;
            Self {
                skew: v0,
                other: v1,
                drive: v2,
                gamma: v3,
            }
        }
    }
    /// Three links and the frame, with a pin at each hinge; a motor turns the first against friction.
    ///
    /**# Equations of motion

```text
A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints

A[theta, theta] = 396827/1200000 + t39 + t43 + 0.8*t40 + t2^2*(4/9375 + 4/9375*t1^2) + t3*(t3*(t38 - t43) - t2*t42)
    + slope_phi_theta*t44 + slope_psi_theta*t46
    + slope_phi_theta*(t44 + slope_phi_theta*(t38 + t39) + slope_psi_theta*t45)
    + slope_psi_theta*(t46 + slope_phi_theta*t45 + 32027/1200000*slope_psi_theta) - t2*(t3*t42 - t0^2*t2*t37)
b[theta] = 8.4366*t0*cos(theta) + t2*(t4*(t8*(t2*dot(theta)*dot(phi)*t5 + t2*dot(theta)*t5*t13) + t7*t29 + t6*t30
    - 4/9375*t0*t1*((t2*dot(theta)*t4)^2 + t13^2 - (t2*dot(theta)*t4)^2 - (t2*dot(theta)*t5)^2))
    + t5*(t1*t35 - t0*t31 - 0.8*t34 - 0.96*t11 - 4/9375*t0*t1*t15 - 1587227/2400000*t17)) + t3*t36
    + 0.4*(t3*(t5*(0.96*t16 + t33) - t4*(0.96*t14 + t7*t28 + 0.1*t6*t26)) - t2*(0.96*t17 + t34)) + slope_phi_theta*t36
    + slope_psi_theta*t31
Q[theta] = drive - gamma*dot(theta)

where
dot(phi) = dot(theta)*slope_phi_theta
dot(psi) = dot(theta)*slope_psi_theta
t0 = sin(other)
t1 = cos(other)
t2 = sin(skew)
t3 = cos(skew)
t4 = sin(phi)
t5 = cos(phi)
t6 = sin(psi)
t7 = cos(psi)
t8 = 9/800000 + 4/9375*t0^2
t9 = 9.81*t0*sin(theta) - 0.4*dot(theta)^2
t10 = 9.81*t0*t3*cos(theta) + 9.81*t1*t2
t11 = 9.81*t1*t3 - 9.81*t0*t2*cos(theta)
t12 = t5*t10 - t4*t9
t13 = dot(phi) + t3*dot(theta)
t14 = (t2*dot(theta)*t5)^2 + t13^2
t15 = t2^2*dot(theta)^2*t4*t5 - drift_phi
t16 = drift_phi + t2^2*dot(theta)^2*t4*t5
t17 = t2*dot(theta)*dot(phi)*t4 + t2*dot(theta)*t4*t13
t18 = t12 + 0.8*t16
t19 = t11 + 0.8*t17
t20 = t1*t2*dot(theta)*t5 + t0*t13
t21 = t2*dot(theta)*t4*t7 + t6*t20
t22 = t7*t20 - t2*dot(theta)*t4*t6
t23 = t0*drift_phi - t1*t2*dot(theta)*dot(phi)*t4
t24 = drift_psi + t0*t2*dot(theta)*dot(phi)*t4 + t1*drift_phi
t25 = dot(psi) + t1*t13 - t0*t2*dot(theta)*t5
t26 = t24 + t21*t22
t27 = t21*t25 + t2*dot(theta)*dot(phi)*t5*t6 + dot(psi)*t21 - t7*t23
t28 = 0.1*(t22^2 + t25^2)
t29 = 9/800000*(t2*dot(theta)*dot(phi)*t5*t7 + t6*t23 + dot(psi)*t22 + t22*t25)
t30 = 0.1*(t1*t19 - t0*t18) + 64027/2400000*t27
t31 = 0.1*(t7*(t1*t18 + t0*t19) - t6*(t5*t9 + t4*t10 - 0.8*t14)) + 64027/2400000*t26 - 9/800000*(t21*t22 - t24)
t32 = 0.1*t7*t26 - t6*t28
t33 = t1*t32 - 0.1*t0*t27
t34 = t0*t32 + 0.1*t1*t27
t35 = t6*t29 - t7*t30
t36 = 0.96*t12 + 1587227/2400000*t16 + 4/9375*t0*t1*(t2*dot(theta)*t4*t13 - t2*dot(theta)*dot(phi)*t4) + t0*t35 + t1*t31
    + 0.8*t33 - t8*t15
t37 = 64027/2400000 - 2/75*t7^2
t38 = 793627/1200000 + 0.16*t7 + 2/75*t7^2
t39 = t8 + t1^2*t37
t40 = t5*(0.1*t7 + 0.96) - 0.1*t1*t4*t6
t41 = t4*(2/75*t0*t6*t7 + 0.08*t0*t6)
t42 = t41 + t5*(t0*t1*t37 - 4/9375*t0*t1)
t43 = t5*(t5*(t38 - t39) - 2*t4*(2/75*t1*t6*t7 + 0.08*t1*t6))
t44 = t2*(t5*(4/9375*t0*t1 - t0*t1*t37) - t41) + t3*(t38 + t39) + 0.4*t3*t40
t45 = 32027/1200000*t1 + 0.08*t1*t7
t46 = t3*t45 + 0.4*(t3*(0.1*t1*t5*t7 - 0.1*t4*t6) - 0.1*t0*t2*t7) - t2*t5*(32027/1200000*t0 + 0.08*t0*t7)

with slope_y_x, the derivative of y by x, and drift_y, the second rate of y where no x accelerates, from
0 = 0.4*cos(theta)*cos(phi)*cos(psi) + 0.8*cos(theta)*cos(phi) + 0.4*cos(theta) + 0.8
    + 0.4*sin(other)*sin(skew)*sin(theta)*sin(psi) - 0.8*cos(skew)*sin(theta)*sin(phi)
    - 0.4*cos(skew)*sin(theta)*sin(phi)*cos(psi) - 0.4*cos(other)*cos(skew)*sin(theta)*cos(phi)*sin(psi)
    - 0.4*cos(other)*cos(theta)*sin(phi)*sin(psi)
0 = 0.4*cos(other)*sin(theta)*cos(phi)*cos(psi) + 0.8*cos(other)*sin(theta)*cos(phi) + 0.4*cos(other)*sin(theta)
    + 0.8*cos(other)*cos(skew)*cos(theta)*sin(phi) + 0.4*cos(other)*cos(skew)*cos(theta)*sin(phi)*cos(psi)
    - 0.4*(1 - sin(other)^2)*sin(theta)*sin(phi)*sin(psi)
    - 0.4*(sin(other)^2*cos(skew) - cos(skew))*cos(theta)*cos(phi)*sin(psi)
    - 0.4*sin(other)*cos(other)*sin(skew)*cos(theta)*sin(psi) - 0.8*sin(other)*sin(skew)*sin(phi)
    - 0.4*sin(other)*sin(skew)*sin(phi)*cos(psi) - 0.4*sin(other)*cos(other)*sin(skew)*cos(phi)*sin(psi)
    - 0.4*sin(other)^2*cos(skew)*sin(psi)
0 = 0.4*sin(other)*sin(theta)*cos(phi)*cos(psi) + 0.8*sin(other)*sin(theta)*cos(phi) + 0.4*sin(other)*sin(theta)
    + 0.8*sin(other)*cos(skew)*cos(theta)*sin(phi) + 0.4*sin(other)*cos(skew)*cos(theta)*sin(phi)*cos(psi)
    + 0.4*sin(other)*cos(other)*cos(skew)*cos(theta)*cos(phi)*sin(psi) + 0.8*cos(other)*sin(skew)*sin(phi)
    + 0.4*cos(other)*sin(skew)*sin(phi)*cos(psi) + 0.4*sin(other)*cos(other)*cos(skew)*sin(psi)
    - 0.4*sin(other)*cos(other)*sin(theta)*sin(phi)*sin(psi) - 0.4*sin(other)^2*sin(skew)*cos(theta)*sin(psi)
    - 0.4*(sin(other)^2*sin(skew) - sin(skew))*cos(phi)*sin(psi)
0 = sin(other)*cos(other)*cos(skew)*sin(psi) + cos(other)*sin(skew)*sin(phi)*cos(psi)
    + sin(other)*cos(other)*cos(skew)*cos(theta)*cos(phi)*sin(psi) + sin(other)*cos(skew)*cos(theta)*sin(phi)*cos(psi)
    + sin(other)*sin(theta)*cos(phi)*cos(psi) - sin(other)*cos(other)*sin(theta)*sin(phi)*sin(psi)
    - sin(other)^2*sin(skew)*cos(theta)*sin(psi) - (sin(other)^2*sin(skew) - sin(skew))*cos(phi)*sin(psi)
0 = sin(other)^2*sin(skew)*sin(theta)*sin(phi) + sin(skew)*cos(skew)
    + (sin(other)*cos(other) - sin(other)*cos(other)*sin(skew)^2)*cos(theta)*cos(phi)*cos(psi)
    + (sin(other)*cos(other) - sin(other)*cos(other)*sin(skew)^2)*cos(psi) - sin(other)^2*sin(skew)*cos(skew)
    - sin(other)*cos(other)*cos(skew)*sin(theta)*sin(phi)*cos(psi) - sin(other)*cos(skew)*sin(theta)*cos(phi)*sin(psi)
    - sin(other)*cos(other)*sin(skew)^2*cos(theta) - (sin(other) - sin(other)*sin(skew)^2)*cos(theta)*sin(phi)*sin(psi)
    - sin(other)^2*sin(skew)*cos(skew)*cos(theta)*cos(phi) - sin(other)^2*sin(skew)*cos(skew)*cos(theta)*cos(psi)
    - cos(other)*sin(skew)*cos(skew)*sin(phi)*sin(psi) - sin(other)*cos(other)*sin(skew)^2*cos(phi)
    - (sin(other)^2*sin(skew)*cos(skew) - sin(skew)*cos(skew))*cos(phi)*cos(psi)
```

# Constants, computed by `new`

```text
k0 = drive
k1 = gamma
k2 = sin(other)
k3 = cos(other)
k4 = sin(other)*cos(other)
k5 = sin(other)^2
k6 = cos(other)^2
k7 = sin(skew)
k8 = cos(skew)
k9 = sin(other)*sin(skew)
k10 = cos(other)*sin(skew)
k11 = -cos(other)*sin(skew)
k12 = sin(other)*cos(skew)
k13 = 0.08*sin(skew)
k14 = 0.08*cos(skew)
k15 = sin(skew)^2
k16 = sin(skew)*cos(skew)
k17 = cos(skew)^2
k18 = 0.4*sin(other)
k19 = 0.4*sin(other)*sin(skew)
k20 = 0.4*cos(other)
k21 = 0.4*cos(other)*cos(skew)
k22 = 0.8*cos(skew)
k23 = -0.8*cos(skew)
k24 = 0.4*cos(skew)
k25 = 0.4*sin(other)*cos(other)
k26 = 0.4*sin(other)*cos(other)*sin(skew)
k27 = -0.4*sin(other)*cos(other)*sin(skew)
k28 = 0.8*sin(other)
k29 = 0.8*sin(other)*sin(skew)
k30 = 0.4*sin(other)^2
k31 = 0.4*sin(other)^2*cos(skew)
k32 = 0.8*cos(other)
k33 = 0.8*cos(other)*cos(skew)
k34 = 0.4*sin(other)*cos(other)*cos(skew)
k35 = 0.8*sin(other)*cos(skew)
k36 = 0.4*sin(other)*cos(skew)
k37 = 0.4*sin(other)^2*sin(skew)
k38 = 0.8*cos(other)*sin(skew)
k39 = 0.4*cos(other)*sin(skew)
k40 = 0.4*sin(skew)
k41 = sin(other)*cos(other)*cos(skew)
k42 = sin(other)^2*sin(skew)
k43 = sin(other)*cos(other)*sin(skew)^2
k44 = sin(other)*sin(skew)^2
k45 = sin(other)^2*sin(skew)*cos(skew)
k46 = cos(other)*sin(skew)*cos(skew)
k47 = 4/9375*sin(other)*cos(other)
k48 = 9/800000 + 4/9375*sin(other)^2
k49 = 9.81*sin(other)
k50 = 9.81*cos(other)*sin(skew)
k51 = 9.81*cos(other)*cos(skew)
k52 = 32027/1200000*sin(other)
k53 = 32027/1200000*cos(other)
k54 = sin(other)*cos(other)*sin(skew)
k55 = 2*sin(other)*sin(skew) - cos(other)*cos(skew)
k56 = sin(other)^2*cos(skew)
k57 = sin(other)*sin(skew) - 2*cos(other)*cos(skew)
k58 = sin(other)^2*sin(skew) - sin(skew)
k59 = 2/75*sin(other)*cos(other)*sin(skew)*cos(skew)
k60 = 0.08*sin(skew)^2
k61 = 0.16*cos(skew)
k62 = 0.04*(cos(other)*cos(skew) + 2*sin(other)*sin(skew))
k63 = 0.08*cos(other)
k64 = 0.04*cos(skew)
k65 = 0.08*cos(other)*sin(skew)^2
k66 = 2/75*cos(other)*sin(skew)^2
k67 = 1/2400000*(921600 + 997*sin(other)*cos(other)*sin(skew)*cos(skew))
k68 = 2/75*sin(other)*sin(skew)*cos(skew)
k69 = 1/2400000*(997*sin(other)*cos(other)*sin(skew) + 921600*cos(skew))
k70 = 32027/1200000*sin(other)*sin(skew)
k71 = 1/2400000*(997*sin(other)^2*cos(skew) + 1651308*cos(skew))
k72 = 8.4366*sin(other)
k73 = 32027/1200000*cos(other)*cos(skew)
k74 = 0.04*(cos(other) + 2*sin(other)*sin(skew)*cos(skew))
k75 = 1/75*(sin(other)^2*sin(skew)^2 - 2*sin(skew)^2)
k76 = 1/4800000*(997*sin(other)^2*sin(skew)^2 - 1651200*sin(skew)^2)
k77 = 1/4800000*(2444962 + 997*sin(other)^2 + 1994*sin(skew)^2 - 1994*sin(other)^2*sin(skew)^2)
k78 = 1/75*(sin(skew)^2 + sin(other)^2 - 2*sin(other)^2*sin(skew)^2)
k79 = 1/4800000*(997*sin(other)^2 + 1651308)
k80 = 1/75*sin(other)^2
k81 = sin(other)^2*sin(skew)*cos(skew) - sin(skew)*cos(skew)
k82 = 0.4*sin(other)^2*sin(skew) - 0.4*sin(skew)
k83 = -0.8*sin(other)*cos(skew)
k84 = sin(skew)*cos(skew) - sin(other)^2*sin(skew)*cos(skew)
k85 = 0.1*cos(other)
k86 = 0.1*sin(other)
k87 = sin(other)^2*sin(skew)^2
k88 = 793627/2400000 + 9/800000 + sin(skew)^2*(4/9375 + 4/9375*cos(other)^2)
k89 = 0.4*sin(skew) - 0.4*sin(other)^2*sin(skew)
k90 = 0.4*cos(skew) - 0.4*sin(other)^2*cos(skew)
k91 = 0.4*sin(other)^2 - 0.4
k92 = sin(skew) - sin(other)^2*sin(skew)
k93 = sin(other)*cos(other)*sin(skew)^2 - sin(other)*cos(other)
k94 = 2*(9/800000 + 4/9375*sin(other)^2)
k95 = 1587227/2400000 + 9/800000 + 4/9375*sin(other)^2
k96 = 0.08*sin(other)*cos(skew)
k97 = 0.08*cos(other)*cos(skew)
k98 = 0.08*cos(other)*sin(skew)
k99 = 0.08*sin(other)*sin(skew)
```
*/
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Bennett<T = f64> {
        params: BennettParams,
        constants: [T; 100],
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl Bennett {
        /// Builds the model: checks the parameters, and computes once whatever depends on them alone.
        ///
        /// # Errors
        ///
        /// The first parameter, or combination of parameters, that is not finite or that no rigid body can
        /// have.
        pub fn new(
            params: BennettParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            #[inline]
            fn rules<T: ::pendulum_core::real::Real>(given: [T; 4]) -> [T; 1] {
                let [p_skew, p_other, p_drive, p_gamma] = given;
                [p_gamma]
            }
            #[inline]
            fn constants<T: ::pendulum_core::real::Real>(given: [T; 4]) -> [T; 100] {
                let [p_skew, p_other, p_drive, p_gamma] = given;
                let [(sin_other, cos_other), (sin_skew, cos_skew)] = p_other
                    .sin_cos_pair(p_skew);
                let t0 = cos_other * cos_other;
                let t1 = sin_other * cos_skew;
                let t2 = cos_skew * cos_skew;
                let t3 = T::from_f64(9.81) * sin_other;
                let t4 = T::from_f64(0.026689166666666667) * sin_other;
                let t5 = T::from_f64(0.026689166666666667) * cos_other;
                let t6 = T::from_f64(0.16) * cos_skew;
                let t7 = T::from_f64(0.08) * cos_other;
                let t8 = T::from_f64(0.04) * cos_skew;
                let t9 = T::from_f64(8.4366) * sin_other;
                let t10 = T::from_f64(0.1) * cos_other;
                let t11 = T::from_f64(0.1) * sin_other;
                let t12 = T::from_f64(0.3306779166666667)
                    + (T::from_f64(1.125e-5)
                        + sin_skew
                            * (sin_skew
                                * (T::from_f64(0.00042666666666666667)
                                    + cos_other
                                        * (T::from_f64(0.00042666666666666667) * cos_other))));
                let t13 = sin_other * cos_other;
                let t14 = t13 * cos_skew;
                let t15 = sin_other * sin_other;
                let t16 = t15 * cos_skew;
                let t17 = T::from_f64(0.013333333333333334) * t15;
                let t18 = sin_other * sin_skew;
                let t19 = t18 - cos_skew * (T::from_f64(2.0) * cos_other);
                let t20 = T::from_f64(0.02666666666666667) * (cos_skew * t18);
                let t21 = T::from_f64(0.026689166666666667) * t18;
                let t22 = cos_other * sin_skew;
                let t23 = -t22;
                let t24 = cos_skew * t22;
                let t25 = T::from_f64(0.08) * sin_skew;
                let t26 = cos_other * t25;
                let t27 = sin_other * t25;
                let t28 = T::from_f64(0.08) * cos_skew;
                let t29 = sin_other * t28;
                let t30 = cos_other * t28;
                let t31 = sin_skew * sin_skew;
                let t32 = T::from_f64(0.08) * t31;
                let t33 = T::from_f64(0.013333333333333334)
                    * (t15 * t31 - T::from_f64(2.0) * t31);
                let t34 = T::from_f64(0.013333333333333334)
                    * (t31 + (t15 - t31 * (T::from_f64(2.0) * t15)));
                let t35 = sin_skew * cos_skew;
                let t36 = T::from_f64(0.4) * sin_other;
                let t37 = sin_skew * t36;
                let t38 = cos_skew * t36;
                let t39 = cos_other * t36;
                let t40 = cos_skew * t39;
                let t41 = sin_skew * t39;
                let t42 = -t41;
                let t43 = T::from_f64(0.4) * cos_other;
                let t44 = cos_skew * t43;
                let t45 = sin_skew * t43;
                let t46 = T::from_f64(0.8) * cos_skew;
                let t47 = -t46;
                let t48 = T::from_f64(0.4) * cos_skew;
                let t49 = T::from_f64(0.8) * sin_other;
                let t50 = sin_skew * t49;
                let t51 = cos_skew * t49;
                let t52 = -t51;
                let t53 = T::from_f64(0.4) * t15;
                let t54 = T::from_f64(-0.4) + t53;
                let t55 = cos_skew * t53;
                let t56 = t48 - t55;
                let t57 = sin_skew * t53;
                let t58 = T::from_f64(0.8) * cos_other;
                let t59 = cos_skew * t58;
                let t60 = sin_skew * t58;
                let t61 = T::from_f64(0.4) * sin_skew;
                let t62 = t57 - t61;
                let t63 = t61 - t57;
                let t64 = t15 * sin_skew;
                let t65 = t64 - sin_skew;
                let t66 = sin_skew - t64;
                let t67 = cos_skew * t64;
                let t68 = t67 - t35;
                let t69 = t35 - t67;
                let t70 = t13 * t31;
                let t71 = t70 - t13;
                let t72 = t13 * sin_skew;
                let t73 = T::from_f64(0.02666666666666667) * (cos_skew * t72);
                let t74 = sin_other * t31;
                let t75 = sin_other * t74;
                let t76 = T::from_f64(0.00042666666666666667) * sin_other;
                let t77 = cos_other * t76;
                let t78 = T::from_f64(1.125e-5) + sin_other * t76;
                let t79 = T::from_f64(2.0) * t78;
                let t80 = T::from_f64(0.6613445833333333) + t78;
                let t81 = T::from_f64(9.81) * cos_other;
                let t82 = sin_skew * t81;
                let t83 = cos_skew * t81;
                let t84 = sin_skew * (T::from_f64(2.0) * sin_other);
                let t85 = T::from_f64(0.04) * (cos_other + cos_skew * t84);
                let t86 = cos_other * cos_skew;
                let t87 = t84 - t86;
                let t88 = T::from_f64(0.04) * (t86 + t84);
                let t89 = T::from_f64(0.026689166666666667) * t86;
                let t90 = cos_other * t31;
                let t91 = T::from_f64(0.08) * t90;
                let t92 = T::from_f64(0.02666666666666667) * t90;
                let t93 = sin_skew * (cos_other * (T::from_f64(997.0) * sin_other));
                let t94 = T::from_f64(4.1666666666666667e-7)
                    * (T::from_f64(921600.0) + cos_skew * t93);
                let t95 = T::from_f64(4.1666666666666667e-7)
                    * (t93 + T::from_f64(921600.0) * cos_skew);
                let t96 = T::from_f64(997.0) * t15;
                let t97 = T::from_f64(4.1666666666666667e-7)
                    * (cos_skew * t96 + T::from_f64(1651308.0) * cos_skew);
                let t98 = T::from_f64(2.0833333333333333e-7)
                    * (T::from_f64(2444962.0) + t96 - t31 * (T::from_f64(1994.0) * t15)
                        + T::from_f64(1994.0) * t31);
                let t99 = T::from_f64(2.0833333333333333e-7)
                    * (t31 * t96 - T::from_f64(1651200.0) * t31);
                let t100 = T::from_f64(2.0833333333333333e-7)
                    * (t96 + T::from_f64(1651308.0));
                [
                    p_drive,
                    p_gamma,
                    sin_other,
                    cos_other,
                    t13,
                    t15,
                    t0,
                    sin_skew,
                    cos_skew,
                    t18,
                    t22,
                    t23,
                    t1,
                    t25,
                    t28,
                    t31,
                    t35,
                    t2,
                    t36,
                    t37,
                    t43,
                    t44,
                    t46,
                    t47,
                    t48,
                    t39,
                    t41,
                    t42,
                    t49,
                    t50,
                    t53,
                    t55,
                    t58,
                    t59,
                    t40,
                    t51,
                    t38,
                    t57,
                    t60,
                    t45,
                    t61,
                    t14,
                    t64,
                    t70,
                    t74,
                    t67,
                    t24,
                    t77,
                    t78,
                    t3,
                    t82,
                    t83,
                    t4,
                    t5,
                    t72,
                    t87,
                    t16,
                    t19,
                    t65,
                    t73,
                    t32,
                    t6,
                    t88,
                    t7,
                    t8,
                    t91,
                    t92,
                    t94,
                    t20,
                    t95,
                    t21,
                    t97,
                    t9,
                    t89,
                    t85,
                    t33,
                    t99,
                    t98,
                    t34,
                    t100,
                    t17,
                    t68,
                    t62,
                    t52,
                    t69,
                    t10,
                    t11,
                    t75,
                    t12,
                    t63,
                    t56,
                    t54,
                    t66,
                    t71,
                    t79,
                    t80,
                    t29,
                    t30,
                    t26,
                    t27,
                ]
            }
            let given = params.to_array();
            for (name, value) in BennettParams::NAMES.into_iter().zip(given) {
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
            let [r0] = rules(given);
            if !(r0 >= 0.0) {
                return Err(
                    ::pendulum_core::ParameterError::new(
                        "gamma",
                        r0,
                        "the friction of `first` must not be negative",
                        &[],
                    ),
                );
            }
            let constants = constants(given);
            let names: [&'static str; 100] = [
                "drive",
                "gamma",
                "sin(other)",
                "cos(other)",
                "sin(other)*cos(other)",
                "sin(other)^2",
                "cos(other)^2",
                "sin(skew)",
                "cos(skew)",
                "sin(other)*sin(skew)",
                "cos(other)*sin(skew)",
                "-cos(other)*sin(skew)",
                "sin(other)*cos(skew)",
                "0.08*sin(skew)",
                "0.08*cos(skew)",
                "sin(skew)^2",
                "sin(skew)*cos(skew)",
                "cos(skew)^2",
                "0.4*sin(other)",
                "0.4*sin(other)*sin(skew)",
                "0.4*cos(other)",
                "0.4*cos(other)*cos(skew)",
                "0.8*cos(skew)",
                "-0.8*cos(skew)",
                "0.4*cos(skew)",
                "0.4*sin(other)*cos(other)",
                "0.4*sin(other)*cos(other)*sin(skew)",
                "-0.4*sin(other)*cos(other)*sin(skew)",
                "0.8*sin(other)",
                "0.8*sin(other)*sin(skew)",
                "0.4*sin(other)^2",
                "0.4*sin(other)^2*cos(skew)",
                "0.8*cos(other)",
                "0.8*cos(other)*cos(skew)",
                "0.4*sin(other)*cos(other)*cos(skew)",
                "0.8*sin(other)*cos(skew)",
                "0.4*sin(other)*cos(skew)",
                "0.4*sin(other)^2*sin(skew)",
                "0.8*cos(other)*sin(skew)",
                "0.4*cos(other)*sin(skew)",
                "0.4*sin(skew)",
                "sin(other)*cos(other)*cos(skew)",
                "sin(other)^2*sin(skew)",
                "sin(other)*cos(other)*sin(skew)^2",
                "sin(other)*sin(skew)^2",
                "sin(other)^2*sin(skew)*cos(skew)",
                "cos(other)*sin(skew)*cos(skew)",
                "4/9375*sin(other)*cos(other)",
                "9/800000 + 4/9375*sin(other)^2",
                "9.81*sin(other)",
                "9.81*cos(other)*sin(skew)",
                "9.81*cos(other)*cos(skew)",
                "32027/1200000*sin(other)",
                "32027/1200000*cos(other)",
                "sin(other)*cos(other)*sin(skew)",
                "2*sin(other)*sin(skew) - cos(other)*cos(skew)",
                "sin(other)^2*cos(skew)",
                "sin(other)*sin(skew) - 2*cos(other)*cos(skew)",
                "sin(other)^2*sin(skew) - sin(skew)",
                "2/75*sin(other)*cos(other)*sin(skew)*cos(skew)",
                "0.08*sin(skew)^2",
                "0.16*cos(skew)",
                "0.04*(cos(other)*cos(skew) + 2*sin(other)*sin(skew))",
                "0.08*cos(other)",
                "0.04*cos(skew)",
                "0.08*cos(other)*sin(skew)^2",
                "2/75*cos(other)*sin(skew)^2",
                "1/2400000*(921600 + 997*sin(other)*cos(other)*sin(skew)*cos(skew))",
                "2/75*sin(other)*sin(skew)*cos(skew)",
                "1/2400000*(997*sin(other)*cos(other)*sin(skew) + 921600*cos(skew))",
                "32027/1200000*sin(other)*sin(skew)",
                "1/2400000*(997*sin(other)^2*cos(skew) + 1651308*cos(skew))",
                "8.4366*sin(other)",
                "32027/1200000*cos(other)*cos(skew)",
                "0.04*(cos(other) + 2*sin(other)*sin(skew)*cos(skew))",
                "1/75*(sin(other)^2*sin(skew)^2 - 2*sin(skew)^2)",
                "1/4800000*(997*sin(other)^2*sin(skew)^2 - 1651200*sin(skew)^2)",
                "1/4800000*(2444962 + 997*sin(other)^2 + 1994*sin(skew)^2 - 1994*sin(other)^2*sin(skew)^2)",
                "1/75*(sin(skew)^2 + sin(other)^2 - 2*sin(other)^2*sin(skew)^2)",
                "1/4800000*(997*sin(other)^2 + 1651308)",
                "1/75*sin(other)^2",
                "sin(other)^2*sin(skew)*cos(skew) - sin(skew)*cos(skew)",
                "0.4*sin(other)^2*sin(skew) - 0.4*sin(skew)",
                "-0.8*sin(other)*cos(skew)",
                "sin(skew)*cos(skew) - sin(other)^2*sin(skew)*cos(skew)",
                "0.1*cos(other)",
                "0.1*sin(other)",
                "sin(other)^2*sin(skew)^2",
                "793627/2400000 + 9/800000 + sin(skew)^2*(4/9375 + 4/9375*cos(other)^2)",
                "0.4*sin(skew) - 0.4*sin(other)^2*sin(skew)",
                "0.4*cos(skew) - 0.4*sin(other)^2*cos(skew)",
                "0.4*sin(other)^2 - 0.4",
                "sin(skew) - sin(other)^2*sin(skew)",
                "sin(other)*cos(other)*sin(skew)^2 - sin(other)*cos(other)",
                "2*(9/800000 + 4/9375*sin(other)^2)",
                "1587227/2400000 + 9/800000 + 4/9375*sin(other)^2",
                "0.08*sin(other)*cos(skew)",
                "0.08*cos(other)*cos(skew)",
                "0.08*cos(other)*sin(skew)",
                "0.08*sin(other)*sin(skew)",
            ];
            for (name, value) in names.into_iter().zip(constants) {
                if !value.is_finite() {
                    let given: [_; 4] = ::core::array::from_fn(|n| (
                        BennettParams::NAMES[n],
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
        pub fn cast<T: ::pendulum_core::real::Real>(&self) -> Bennett<T> {
            Bennett {
                params: self.params,
                constants: self.constants.map(T::from_f64),
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> Bennett<T> {
        /// The parameters that the model was built from.
        pub fn params(&self) -> &BennettParams {
            &self.params
        }
        /// The model with other parameters, in the same number type. Its constants are computed anew.
        ///
        /// # Errors
        ///
        /// Those of `new`.
        pub fn with_params(
            &self,
            params: BennettParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            Ok(<Bennett>::new(params)?.cast())
        }
    }
    impl Bennett {
        ///The place of `theta` in the state, where it stands in rad.
        pub const THETA: usize = 0;
        ///The place of `dot(theta)` in the state, where it stands in rad/s.
        pub const DOT_THETA: usize = 3;
        ///The place of `phi` in the state, where it stands in rad.
        pub const PHI: usize = 1;
        ///The place of `psi` in the state, where it stands in rad.
        pub const PSI: usize = 2;
        /// The number of degrees of freedom, and of rates. The state also holds the coordinates that follow from closed loops.
        pub const DOF: usize = 1;
        /// The names of the coordinates that do not follow from others, in the order in which their rates stand in the state.
        pub const COORDINATES: [&'static str; 1] = ["theta"];
        /// Counted operations of each generated function, in the form that it has and in others.
        pub const COST: ::pendulum_core::Cost = ::pendulum_core::Cost::new(
            &[
                (
                    "rhs",
                    ::pendulum_core::FunctionCost::new(
                            "recursion, L^T D L",
                            ::pendulum_core::Operations::new(471, 639, 3, 3, 0, 115),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, L^T D L",
                                    ::pendulum_core::Operations::new(507, 697, 3, 3, 0, 104),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first, L^T D L",
                                    ::pendulum_core::Operations::new(514, 692, 3, 3, 0, 105),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L",
                                    ::pendulum_core::Operations::new(512, 701, 3, 3, 0, 115),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C, L^T D L",
                                    ::pendulum_core::Operations::new(717, 975, 3, 3, 0, 102),
                                ),
                            ],
                        ),
                ),
                (
                    "loop_margins",
                    ::pendulum_core::FunctionCost::new(
                        "as declared",
                        ::pendulum_core::Operations::new(322, 479, 6, 3, 1, 93),
                    ),
                ),
                (
                    "loop_corrections",
                    ::pendulum_core::FunctionCost::new(
                        "as declared",
                        ::pendulum_core::Operations::new(127, 168, 2, 3, 0, 52),
                    ),
                ),
                (
                    "loop_gaps",
                    ::pendulum_core::FunctionCost::new(
                        "as declared",
                        ::pendulum_core::Operations::new(93, 141, 0, 3, 3, 49),
                    ),
                ),
                (
                    "jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "recursion, L^T D L, derived in the graph",
                            ::pendulum_core::Operations::new(2181, 2512, 3, 3, 0, 141),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first, L^T D L, derived in the graph",
                                    ::pendulum_core::Operations::new(2370, 2810, 3, 3, 0, 131),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, L^T D L, derived in the graph",
                                    ::pendulum_core::Operations::new(2368, 2840, 3, 3, 0, 130),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L, derived in the graph",
                                    ::pendulum_core::Operations::new(2532, 3067, 3, 3, 0, 124),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C, L^T D L, derived in the graph",
                                    ::pendulum_core::Operations::new(3029, 3595, 3, 3, 0, 128),
                                ),
                            ],
                        ),
                ),
                (
                    "kinetic",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(161, 225, 2, 3, 0, 59),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(161, 227, 2, 3, 0, 59),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(161, 226, 2, 3, 0, 63),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(168, 252, 2, 3, 0, 77),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C",
                                    ::pendulum_core::Operations::new(329, 456, 2, 3, 0, 61),
                                ),
                            ],
                        ),
                ),
                (
                    "potential",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(9, 14, 0, 3, 0, 29),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(9, 14, 0, 3, 0, 29),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(11, 13, 0, 3, 0, 29),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "A, B and C",
                                    ::pendulum_core::Operations::new(28, 44, 0, 3, 0, 34),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "recursion",
                                    ::pendulum_core::Operations::new(28, 44, 0, 3, 0, 34),
                                ),
                            ],
                        ),
                ),
                (
                    "gap",
                    ::pendulum_core::FunctionCost::new(
                        "as declared",
                        ::pendulum_core::Operations::new(60, 85, 0, 3, 0, 35),
                    ),
                ),
                (
                    "gap_rate",
                    ::pendulum_core::FunctionCost::new(
                        "as declared",
                        ::pendulum_core::Operations::new(264, 378, 2, 3, 0, 72),
                    ),
                ),
                (
                    "gap_and_jacobian",
                    ::pendulum_core::FunctionCost::new(
                        "as declared",
                        ::pendulum_core::Operations::new(144, 213, 0, 3, 0, 35),
                    ),
                ),
                (
                    "outputs",
                    ::pendulum_core::FunctionCost::new(
                        "as declared",
                        ::pendulum_core::Operations::new(60, 85, 0, 3, 0, 35),
                    ),
                ),
                (
                    "output_rates",
                    ::pendulum_core::FunctionCost::new(
                        "as declared",
                        ::pendulum_core::Operations::new(264, 378, 2, 3, 0, 72),
                    ),
                ),
                (
                    "outputs_and_jacobian",
                    ::pendulum_core::FunctionCost::new(
                        "as declared",
                        ::pendulum_core::Operations::new(144, 213, 0, 3, 0, 35),
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
                            3..4,
                        )
                        .periodic(),
                    ::pendulum_core::Slot::new(
                            "phi",
                            ::pendulum_core::SlotKind::Angle,
                            1..2,
                            4..4,
                        )
                        .periodic(),
                    ::pendulum_core::Slot::new(
                            "psi",
                            ::pendulum_core::SlotKind::Angle,
                            2..3,
                            4..4,
                        )
                        .periodic(),
                ],
            )
            .autonomous();
        /// The equations of motion as text.
        pub const EQUATIONS: &'static str = "A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints\n\nA[theta, theta] = 396827/1200000 + t39 + t43 + 0.8*t40 + t2^2*(4/9375 + 4/9375*t1^2) + t3*(t3*(t38 - t43) - t2*t42)\n    + slope_phi_theta*t44 + slope_psi_theta*t46\n    + slope_phi_theta*(t44 + slope_phi_theta*(t38 + t39) + slope_psi_theta*t45)\n    + slope_psi_theta*(t46 + slope_phi_theta*t45 + 32027/1200000*slope_psi_theta) - t2*(t3*t42 - t0^2*t2*t37)\nb[theta] = 8.4366*t0*cos(theta) + t2*(t4*(t8*(t2*dot(theta)*dot(phi)*t5 + t2*dot(theta)*t5*t13) + t7*t29 + t6*t30\n    - 4/9375*t0*t1*((t2*dot(theta)*t4)^2 + t13^2 - (t2*dot(theta)*t4)^2 - (t2*dot(theta)*t5)^2))\n    + t5*(t1*t35 - t0*t31 - 0.8*t34 - 0.96*t11 - 4/9375*t0*t1*t15 - 1587227/2400000*t17)) + t3*t36\n    + 0.4*(t3*(t5*(0.96*t16 + t33) - t4*(0.96*t14 + t7*t28 + 0.1*t6*t26)) - t2*(0.96*t17 + t34)) + slope_phi_theta*t36\n    + slope_psi_theta*t31\nQ[theta] = drive - gamma*dot(theta)\n\nwhere\ndot(phi) = dot(theta)*slope_phi_theta\ndot(psi) = dot(theta)*slope_psi_theta\nt0 = sin(other)\nt1 = cos(other)\nt2 = sin(skew)\nt3 = cos(skew)\nt4 = sin(phi)\nt5 = cos(phi)\nt6 = sin(psi)\nt7 = cos(psi)\nt8 = 9/800000 + 4/9375*t0^2\nt9 = 9.81*t0*sin(theta) - 0.4*dot(theta)^2\nt10 = 9.81*t0*t3*cos(theta) + 9.81*t1*t2\nt11 = 9.81*t1*t3 - 9.81*t0*t2*cos(theta)\nt12 = t5*t10 - t4*t9\nt13 = dot(phi) + t3*dot(theta)\nt14 = (t2*dot(theta)*t5)^2 + t13^2\nt15 = t2^2*dot(theta)^2*t4*t5 - drift_phi\nt16 = drift_phi + t2^2*dot(theta)^2*t4*t5\nt17 = t2*dot(theta)*dot(phi)*t4 + t2*dot(theta)*t4*t13\nt18 = t12 + 0.8*t16\nt19 = t11 + 0.8*t17\nt20 = t1*t2*dot(theta)*t5 + t0*t13\nt21 = t2*dot(theta)*t4*t7 + t6*t20\nt22 = t7*t20 - t2*dot(theta)*t4*t6\nt23 = t0*drift_phi - t1*t2*dot(theta)*dot(phi)*t4\nt24 = drift_psi + t0*t2*dot(theta)*dot(phi)*t4 + t1*drift_phi\nt25 = dot(psi) + t1*t13 - t0*t2*dot(theta)*t5\nt26 = t24 + t21*t22\nt27 = t21*t25 + t2*dot(theta)*dot(phi)*t5*t6 + dot(psi)*t21 - t7*t23\nt28 = 0.1*(t22^2 + t25^2)\nt29 = 9/800000*(t2*dot(theta)*dot(phi)*t5*t7 + t6*t23 + dot(psi)*t22 + t22*t25)\nt30 = 0.1*(t1*t19 - t0*t18) + 64027/2400000*t27\nt31 = 0.1*(t7*(t1*t18 + t0*t19) - t6*(t5*t9 + t4*t10 - 0.8*t14)) + 64027/2400000*t26 - 9/800000*(t21*t22 - t24)\nt32 = 0.1*t7*t26 - t6*t28\nt33 = t1*t32 - 0.1*t0*t27\nt34 = t0*t32 + 0.1*t1*t27\nt35 = t6*t29 - t7*t30\nt36 = 0.96*t12 + 1587227/2400000*t16 + 4/9375*t0*t1*(t2*dot(theta)*t4*t13 - t2*dot(theta)*dot(phi)*t4) + t0*t35 + t1*t31\n    + 0.8*t33 - t8*t15\nt37 = 64027/2400000 - 2/75*t7^2\nt38 = 793627/1200000 + 0.16*t7 + 2/75*t7^2\nt39 = t8 + t1^2*t37\nt40 = t5*(0.1*t7 + 0.96) - 0.1*t1*t4*t6\nt41 = t4*(2/75*t0*t6*t7 + 0.08*t0*t6)\nt42 = t41 + t5*(t0*t1*t37 - 4/9375*t0*t1)\nt43 = t5*(t5*(t38 - t39) - 2*t4*(2/75*t1*t6*t7 + 0.08*t1*t6))\nt44 = t2*(t5*(4/9375*t0*t1 - t0*t1*t37) - t41) + t3*(t38 + t39) + 0.4*t3*t40\nt45 = 32027/1200000*t1 + 0.08*t1*t7\nt46 = t3*t45 + 0.4*(t3*(0.1*t1*t5*t7 - 0.1*t4*t6) - 0.1*t0*t2*t7) - t2*t5*(32027/1200000*t0 + 0.08*t0*t7)\n\nwith slope_y_x, the derivative of y by x, and drift_y, the second rate of y where no x accelerates, from\n0 = 0.4*cos(theta)*cos(phi)*cos(psi) + 0.8*cos(theta)*cos(phi) + 0.4*cos(theta) + 0.8\n    + 0.4*sin(other)*sin(skew)*sin(theta)*sin(psi) - 0.8*cos(skew)*sin(theta)*sin(phi)\n    - 0.4*cos(skew)*sin(theta)*sin(phi)*cos(psi) - 0.4*cos(other)*cos(skew)*sin(theta)*cos(phi)*sin(psi)\n    - 0.4*cos(other)*cos(theta)*sin(phi)*sin(psi)\n0 = 0.4*cos(other)*sin(theta)*cos(phi)*cos(psi) + 0.8*cos(other)*sin(theta)*cos(phi) + 0.4*cos(other)*sin(theta)\n    + 0.8*cos(other)*cos(skew)*cos(theta)*sin(phi) + 0.4*cos(other)*cos(skew)*cos(theta)*sin(phi)*cos(psi)\n    - 0.4*(1 - sin(other)^2)*sin(theta)*sin(phi)*sin(psi)\n    - 0.4*(sin(other)^2*cos(skew) - cos(skew))*cos(theta)*cos(phi)*sin(psi)\n    - 0.4*sin(other)*cos(other)*sin(skew)*cos(theta)*sin(psi) - 0.8*sin(other)*sin(skew)*sin(phi)\n    - 0.4*sin(other)*sin(skew)*sin(phi)*cos(psi) - 0.4*sin(other)*cos(other)*sin(skew)*cos(phi)*sin(psi)\n    - 0.4*sin(other)^2*cos(skew)*sin(psi)\n0 = 0.4*sin(other)*sin(theta)*cos(phi)*cos(psi) + 0.8*sin(other)*sin(theta)*cos(phi) + 0.4*sin(other)*sin(theta)\n    + 0.8*sin(other)*cos(skew)*cos(theta)*sin(phi) + 0.4*sin(other)*cos(skew)*cos(theta)*sin(phi)*cos(psi)\n    + 0.4*sin(other)*cos(other)*cos(skew)*cos(theta)*cos(phi)*sin(psi) + 0.8*cos(other)*sin(skew)*sin(phi)\n    + 0.4*cos(other)*sin(skew)*sin(phi)*cos(psi) + 0.4*sin(other)*cos(other)*cos(skew)*sin(psi)\n    - 0.4*sin(other)*cos(other)*sin(theta)*sin(phi)*sin(psi) - 0.4*sin(other)^2*sin(skew)*cos(theta)*sin(psi)\n    - 0.4*(sin(other)^2*sin(skew) - sin(skew))*cos(phi)*sin(psi)\n0 = sin(other)*cos(other)*cos(skew)*sin(psi) + cos(other)*sin(skew)*sin(phi)*cos(psi)\n    + sin(other)*cos(other)*cos(skew)*cos(theta)*cos(phi)*sin(psi) + sin(other)*cos(skew)*cos(theta)*sin(phi)*cos(psi)\n    + sin(other)*sin(theta)*cos(phi)*cos(psi) - sin(other)*cos(other)*sin(theta)*sin(phi)*sin(psi)\n    - sin(other)^2*sin(skew)*cos(theta)*sin(psi) - (sin(other)^2*sin(skew) - sin(skew))*cos(phi)*sin(psi)\n0 = sin(other)^2*sin(skew)*sin(theta)*sin(phi) + sin(skew)*cos(skew)\n    + (sin(other)*cos(other) - sin(other)*cos(other)*sin(skew)^2)*cos(theta)*cos(phi)*cos(psi)\n    + (sin(other)*cos(other) - sin(other)*cos(other)*sin(skew)^2)*cos(psi) - sin(other)^2*sin(skew)*cos(skew)\n    - sin(other)*cos(other)*cos(skew)*sin(theta)*sin(phi)*cos(psi) - sin(other)*cos(skew)*sin(theta)*cos(phi)*sin(psi)\n    - sin(other)*cos(other)*sin(skew)^2*cos(theta) - (sin(other) - sin(other)*sin(skew)^2)*cos(theta)*sin(phi)*sin(psi)\n    - sin(other)^2*sin(skew)*cos(skew)*cos(theta)*cos(phi) - sin(other)^2*sin(skew)*cos(skew)*cos(theta)*cos(psi)\n    - cos(other)*sin(skew)*cos(skew)*sin(phi)*sin(psi) - sin(other)*cos(other)*sin(skew)^2*cos(phi)\n    - (sin(other)^2*sin(skew)*cos(skew) - sin(skew)*cos(skew))*cos(phi)*cos(psi)\n";
        ///The names of the components of all outputs.
        pub const OUTPUTS: [&'static str; 5] = [
            "gap[0]",
            "gap[1]",
            "gap[2]",
            "gap[3]",
            "gap[4]",
        ];
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::System<T, 4> for Bennett<T> {
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn rhs(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 4> {
            let [q_theta, q_phi, q_psi, qd_theta] = x.data.0[0];
            let k0 = self.constants[0];
            let k1 = self.constants[1];
            let k2 = self.constants[2];
            let k3 = self.constants[3];
            let k4 = self.constants[4];
            let k7 = self.constants[7];
            let k8 = self.constants[8];
            let k10 = self.constants[10];
            let k12 = self.constants[12];
            let k16 = self.constants[16];
            let k17 = self.constants[17];
            let k18 = self.constants[18];
            let k19 = self.constants[19];
            let k20 = self.constants[20];
            let k21 = self.constants[21];
            let k22 = self.constants[22];
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
            let k37 = self.constants[37];
            let k38 = self.constants[38];
            let k39 = self.constants[39];
            let k40 = self.constants[40];
            let k41 = self.constants[41];
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
            let k58 = self.constants[58];
            let k81 = self.constants[81];
            let k82 = self.constants[82];
            let k83 = self.constants[83];
            let k84 = self.constants[84];
            let k85 = self.constants[85];
            let k86 = self.constants[86];
            let k87 = self.constants[87];
            let k88 = self.constants[88];
            let (
                sin_psi,
                cos_psi,
                t4,
                t6,
                t7,
                t12,
                t14,
                sin_phi,
                cos_phi,
                sin_theta,
                t15,
                t17,
                t18,
                t20,
                t56,
                t68,
                t91,
                t107,
                t111,
                t112,
                t116,
                t117,
                t118,
                t119,
                t120,
                t121,
                t122,
                t123,
                t124,
                t125,
                t133,
                t229,
                t250,
                t252,
                t253,
            ) = {
                let t0 = k7 * qd_theta;
                let (sin_psi, cos_psi) = q_psi.sin_cos();
                let t1 = T::from_f64(0.02666666666666667) * cos_psi;
                let t2 = cos_psi * t1;
                let t3 = sin_psi * t1;
                let t4 = T::from_f64(0.026677916666666666) - t2;
                let t5 = k3 * t4;
                let t6 = T::from_f64(0.6613558333333334) + t2
                    + T::from_f64(0.16) * cos_psi;
                let t7 = k48 + k3 * t5;
                let t8 = T::from_f64(0.1) * sin_psi;
                let t9 = k3 * t8;
                let t10 = T::from_f64(0.1) * cos_psi;
                let t11 = k3 * t10;
                let t12 = k53 + T::from_f64(0.8) * t11;
                let t13 = k2 * t10;
                let t14 = t7 + t6;
                let [(sin_phi, cos_phi), (sin_theta, cos_theta)] = q_phi
                    .sin_cos_pair(q_theta);
                let t15 = cos_phi * (T::from_f64(0.96) + t10) - sin_phi * t9;
                let t16 = cos_phi * (t6 - t7)
                    - T::from_f64(2.0) * sin_phi * (k3 * t3 + T::from_f64(0.8) * t9);
                let t17 = cos_phi * t16;
                let t18 = sin_phi * (k2 * (t3 + T::from_f64(0.8) * t8));
                let t19 = k8 * t12 + (k24 * (cos_phi * t11 - sin_phi * t8) - k40 * t13);
                let t20 = cos_phi * (k47 - k2 * t5);
                let t21 = k42 * sin_theta;
                let t22 = k43 * cos_theta;
                let t23 = k43 + k45 * cos_theta;
                let t24 = k44 * cos_theta;
                let t25 = k12 * sin_theta;
                let t26 = k2 * cos_theta;
                let t27 = sin_phi * t25 - cos_phi * t26;
                let t28 = cos_phi * t21 + sin_phi * (cos_psi * (k81 + t22) + t23)
                    + sin_psi * (cos_phi * (t24 - k46) + t27);
                let t29 = k4 * cos_theta;
                let t30 = k41 * sin_theta;
                let t31 = sin_phi * t29 + cos_phi * t30;
                let t32 = t28 - cos_psi * t31;
                let t33 = sin_psi * (t21 - t31) - cos_psi * t27;
                let t34 = k41 * cos_theta;
                let t35 = k4 * sin_theta;
                let t36 = sin_phi * t34 + cos_phi * t35;
                let t37 = k12 * cos_theta;
                let t38 = k2 * sin_theta;
                let t39 = cos_phi * t37 - sin_phi * t38;
                let t40 = sin_psi * (k58 * sin_phi - t36)
                    + cos_psi * (k10 * cos_phi + t39);
                let t41 = k34 * cos_theta;
                let t42 = k28 * sin_theta;
                let t43 = k18 * sin_theta;
                let t44 = k38 + k35 * cos_theta;
                let t45 = k36 * cos_theta;
                let t46 = k25 * sin_theta;
                let t47 = sin_phi * (sin_psi * (k82 - t41) - t42 - cos_psi * t43)
                    + cos_phi * (t44 + cos_psi * (k39 + t45) - sin_psi * t46);
                let t48 = k21 * sin_theta;
                let t49 = k20 * cos_theta;
                let t50 = sin_phi * t48 - cos_phi * t49;
                let t51 = k22 * sin_theta;
                let t52 = T::from_f64(0.8) * cos_theta;
                let t53 = k24 * sin_theta;
                let t54 = T::from_f64(0.4) * cos_theta;
                let t55 = cos_phi * t53 + sin_phi * t54;
                let t56 = sin_psi * t50 - cos_phi * t51 - sin_phi * t52 - cos_psi * t55;
                let t57 = k30 * sin_theta;
                let t58 = k31 * cos_theta;
                let t59 = k24 * cos_theta;
                let t60 = T::from_f64(0.4) * sin_theta;
                let t61 = sin_phi * t59 + cos_phi * t60;
                let t62 = k21 * cos_theta;
                let t63 = k20 * sin_theta;
                let t64 = cos_phi * t62 - sin_phi * t63;
                let t65 = sin_psi * (cos_phi * t57 + sin_phi * (k26 + t58) - t61)
                    + cos_psi * t64;
                let t66 = k32 * sin_theta;
                let t67 = k29 - k33 * cos_theta;
                let t68 = t65 - sin_phi * t66 - cos_phi * (k19 * cos_psi + t67);
                let t69 = t32 * t32 + t40 * t40 + t47 * t47 + t56 * t56 + t68 * t68;
                let t70 = T::from_f64(1.0) / t69;
                let t71 = cos_theta * sin_phi;
                let t72 = t60 + k22 * t71 + T::from_f64(0.8) * (cos_phi * sin_theta)
                    + sin_psi * (t64 - k19 * cos_theta);
                let t73 = t72 + cos_psi * t61;
                let t74 = sin_phi * sin_theta;
                let t75 = k33 * t74
                    + sin_psi * (sin_theta * (k27 - k31 * cos_phi) + t55 - k30 * t71);
                let t76 = t75 + cos_psi * t50 - t49 - k32 * (cos_theta * cos_phi);
                let t77 = k18 * cos_theta;
                let t78 = sin_theta
                    * (sin_phi * (k83 - k36 * cos_psi)
                        + sin_psi * (k37 - k34 * cos_phi));
                let t79 = t77 + t77 * (cos_phi * cos_psi) + t78
                    + cos_theta * (k28 * cos_phi - k25 * (sin_phi * sin_psi));
                let t80 = k43 * sin_theta;
                let t81 = k45 * sin_theta;
                let t82 = k42 * cos_theta;
                let t83 = t80 + cos_phi * t81 + sin_phi * t82
                    + cos_psi * (t81 + cos_phi * t80 - t36);
                let t84 = t83 - sin_psi * (k44 * t74 + t39);
                let t85 = t56 * t73 + t68 * t76 - t47 * t79 - t40 * t33 - t32 * t84;
                let t86 = t70 * t85;
                let t87 = t23 - (k4 - cos_phi * t22)
                    + (sin_phi * t30 - cos_phi * t29 + (k45 * cos_phi - k16 * cos_phi));
                let t88 = sin_phi * t24 - cos_phi * t25 - sin_phi * t26 - k46 * sin_phi;
                let t89 = sin_psi * t87 + cos_psi * t88;
                let t90 = k7 * cos_phi;
                let t91 = t19 - t90 * (k52 + T::from_f64(0.8) * t13);
                let t92 = k41 + cos_phi * t34 + t90 - t82 - sin_phi * t35
                    - k42 * cos_phi;
                let t93 = k10 * sin_phi + (sin_phi * t37 + cos_phi * t38);
                let t94 = cos_psi * t92 - sin_psi * t93;
                let t95 = k34 + cos_phi * t41 + k40 * cos_phi - sin_phi * t46
                    - k37 * cos_theta;
                let t96 = t95 - k37 * cos_phi;
                let t97 = k39 * sin_phi + (sin_phi * t45 + cos_phi * t43);
                let t98 = cos_psi * t96 - sin_psi * t97;
                let t99 = k19 * sin_theta - cos_phi * t48 - sin_phi * t49;
                let t100 = sin_phi * t53 - cos_phi * t54;
                let t101 = cos_psi * t99 + sin_psi * t100;
                let t102 = sin_phi * t57 + cos_phi * t59 - k26 * cos_theta
                    - k26 * cos_phi - cos_phi * t58;
                let t103 = t102 - sin_phi * t60 - k31;
                let t104 = cos_phi * t63 - (k19 * sin_phi - sin_phi * t62);
                let t105 = cos_psi * t103 - sin_psi * t104;
                let t106 = t32 * t89 + t40 * t94 + t47 * t98 + t56 * t101 + t68 * t105;
                let t107 = t70 * t106;
                let t108 = t89 - t32 * t107;
                let t109 = t94 - t40 * t107;
                let t110 = t98 - t47 * t107;
                let t111 = t101 - t56 * t107;
                let t112 = t105 - t68 * t107;
                let t113 = t111 * (t73 - t56 * t86) + t112 * (t76 - t68 * t86)
                    - t110 * (t79 + t47 * t86);
                let t114 = t113 - t109 * (t33 + t40 * t86) - t108 * (t84 + t32 * t86);
                let t115 = t108 * t108 + t109 * t109 + t110 * t110 + t111 * t111
                    + t112 * t112;
                let t116 = T::from_f64(1.0) / t115;
                let t117 = t116 * t114;
                let t118 = t86 - t107 * t117;
                let t119 = qd_theta * t118;
                let t120 = qd_theta * t117;
                let t121 = k49 * cos_theta;
                let t122 = cos_phi * t0;
                let t123 = sin_phi * t0;
                let t124 = t119 * t122;
                let t125 = t119 + k8 * qd_theta;
                let t126 = sin_phi * t119;
                let t127 = t119 * t126;
                let t128 = qd_theta * sin_theta;
                let t129 = qd_theta * t128;
                let t130 = sin_phi * t129;
                let t131 = cos_phi * t119;
                let t132 = t119 * t131;
                let t133 = t119 * t123;
                let t134 = cos_theta * qd_theta;
                let t135 = qd_theta * t134;
                let t136 = cos_phi * t135;
                let t137 = k4 * t128;
                let t138 = t126 * t137;
                let t139 = k41 * t134;
                let t140 = t131 * t139;
                let t141 = t29 * t132 + k4 * t136 - t138 - t138
                    + (t140 + t140 - t30 * t127 - k41 * t130);
                let t142 = k43 * t135;
                let t143 = k43 * t128;
                let t144 = t126 * t143;
                let t145 = t141 + k84 * t132
                    - (t22 * t132 + cos_phi * t142 - t144 - t144);
                let t146 = k45 * t135;
                let t147 = k44 * t128;
                let t148 = t131 * t147;
                let t149 = sin_phi * t135;
                let t150 = cos_phi * t129;
                let t151 = k12 * t134;
                let t152 = t126 * t151;
                let t153 = t148 + t148 + t24 * t127 + k44 * t149
                    - (k12 * t150 + t152 + t152 + t25 * t132);
                let t154 = k2 * t128;
                let t155 = t131 * t154;
                let t156 = t153 - (t155 + t155 + t26 * t127 + k2 * t149) - k46 * t127;
                let t157 = t21 * t127 + k42 * t130 + cos_psi * (t145 - t146)
                    + sin_psi * t156;
                let t158 = sin_psi * t120;
                let t159 = t158 * (cos_phi * t137 + t29 * t126)
                    + t158 * (sin_phi * t139 + t30 * t131);
                let t160 = t120 * t158;
                let t161 = k45 * t128;
                let t162 = t158 * t126;
                let t163 = t131 * t134;
                let t164 = cos_psi * t120;
                let t165 = t158 * (cos_phi * t143 + t22 * t126)
                    + t164 * (cos_phi * t151 - t25 * t126);
                let t166 = k16 * t162 + t164 * (t24 * t131 - sin_phi * t147) + t159
                    - (t165 + (t164 * (t26 * t131 - sin_phi * t154) + t126 * t161));
                let t167 = t158 * t161 + k45 * t162 - (k42 * t163 - k46 * t164 * t131);
                let t168 = t167 - t166;
                let t169 = t120 * t164;
                let t170 = t157 + t160 * t88 + t168 + t168 - t142 - cos_phi * t146
                    - t169 * t87;
                let t171 = t170 - t132 * t23;
                let t172 = k41 * t128;
                let t173 = t126 * t172;
                let t174 = k4 * t134;
                let t175 = t164 * (cos_phi * t172 + t34 * t126)
                    + t164 * (sin_phi * t174 + t35 * t131);
                let t176 = t131 * t174;
                let t177 = t34 * t132 + k41 * t136 - t173 - t173
                    + (t176 + t176 - t35 * t127 - k4 * t130);
                let t178 = t132 + t135;
                let t179 = T::from_f64(0.4) * t135;
                let t180 = k12 * t128;
                let t181 = t131 * t180;
                let t182 = k2 * t134;
                let t183 = t158 * (t37 * t131 - sin_phi * t180)
                    + t158 * (cos_phi * t182 - t38 * t126);
                let t184 = t126 * t182;
                let t185 = t181 + t181 + t37 * t127 + k12 * t149
                    + (k2 * t150 + t184 + t184 + t38 * t132);
                let t186 = t160 * t92 + sin_psi * (t177 + k7 * t132 - k42 * t178)
                    + cos_psi * (t185 + k10 * t127);
                let t187 = t164 * t126;
                let t188 = t164 * t128;
                let t189 = t158 * t131;
                let t190 = k7 * t187 - k42 * t188 + t175
                    + (t183 - (k42 * t187 - k10 * t189));
                let t191 = t186 + t169 * t93 + t190 + t190;
                let t192 = k18 * t129;
                let t193 = t192 + k35 * t149 + k28 * t150 + t42 * t132 + t160 * t96;
                let t194 = k34 * t128;
                let t195 = t126 * t194;
                let t196 = k25 * t134;
                let t197 = t164 * (cos_phi * t194 + t41 * t126)
                    + t164 * (sin_phi * t196 + t46 * t131);
                let t198 = t131 * t196;
                let t199 = t41 * t132 + k34 * t136 - t195 - t195
                    + (t198 + t198 - t46 * t127 - k25 * t130);
                let t200 = k37 * t187 - k39 * t189 - (k40 * t187 - k37 * t188 + t197);
                let t201 = k36 * t128;
                let t202 = t131 * t201;
                let t203 = k18 * t134;
                let t204 = t126 * t203;
                let t205 = t202 + t202 + t45 * t127 + k36 * t149
                    + (cos_phi * t192 + t204 + t204 + t43 * t132);
                let t206 = t193 + sin_psi * (t199 + k40 * t132 - k37 * t178)
                    + cos_psi * (t205 + k39 * t127);
                let t207 = t131 * t128;
                let t208 = t126 * t134;
                let t209 = k35 * t207 + t158 * (t45 * t131 - sin_phi * t201)
                    + (k28 * t208 + t158 * (cos_phi * t203 - t43 * t126));
                let t210 = t209 - t200;
                let t211 = t206 + t169 * t97 + t127 * t44 + t210 + t210;
                let t212 = k21 * t134;
                let t213 = t126 * t212;
                let t214 = k20 * t128;
                let t215 = t164 * (cos_phi * t212 - t48 * t126)
                    + t164 * (t49 * t131 - sin_phi * t214);
                let t216 = t131 * t214;
                let t217 = k19 * t129 - (k21 * t150 + t213 + t213 + t48 * t132)
                    - (t216 + t216 + t49 * t127 + k20 * t149);
                let t218 = t179 + t52 * t132 + T::from_f64(0.8) * t136 + sin_psi * t217
                    + t160 * t99;
                let t219 = k20 * t129;
                let t220 = k33 * t149 + t219 + k32 * t150 + t66 * t132 + t160 * t103;
                let t221 = T::from_f64(0.4) * t128;
                let t222 = t126 * t221;
                let t223 = T::from_f64(0.8) * t126 * t128
                    + (t158 * (cos_phi * t221 + t54 * t126) + k19 * t164 * t134);
                let t224 = k24 * t134;
                let t225 = t223
                    - (t215 + (k22 * t163 - t158 * (sin_phi * t224 + t53 * t131)));
                let t226 = t131 * t224;
                let t227 = t54 * t132 + cos_phi * t179 - t222 - t222
                    + (t226 + t226 - t53 * t127 - k24 * t130);
                let t228 = t218 + cos_psi * t227 - t51 * t127 - k22 * t130 - t169 * t100;
                let t229 = t228 - t225 - t225;
                let t230 = T::from_f64(0.4) * t134;
                let t231 = t131 * t230;
                let t232 = k24 * t128;
                let t233 = t126 * t232;
                let t234 = t231 + t231 - t60 * t127 - T::from_f64(0.4) * t130
                    + (t59 * t132 + k24 * t136 - t233 - t233);
                let t235 = k30 * t134;
                let t236 = t164 * (sin_phi * t230 + t60 * t131)
                    - t164 * (sin_phi * t235 + t57 * t131);
                let t237 = t131 * t235;
                let t238 = k20 * t134;
                let t239 = k31 * t128;
                let t240 = k26 * t188 + k26 * t187
                    + (k19 * t189 + t164 * (cos_phi * t239 + t58 * t126));
                let t241 = t126 * t239;
                let t242 = t234 - (t237 + t237 - t57 * t127 - k30 * t130)
                    - (t58 * t132 + k31 * t136 - t241 - t241);
                let t243 = k21 * t128;
                let t244 = k33 * t207 + t158 * (t62 * t131 - sin_phi * t243)
                    + (k32 * t208 + t158 * (cos_phi * t238 - t63 * t126));
                let t245 = t244 + (t164 * (cos_phi * t232 + t59 * t126) + t236 - t240);
                let t246 = t131 * t243;
                let t247 = t126 * t238;
                let t248 = t246 + t246 + t62 * t127 + k21 * t149
                    + (cos_phi * t219 + t247 + t247 + t63 * t132);
                let t249 = t220 + sin_psi * (t242 - k26 * t178)
                    + cos_psi * (t248 - k19 * t127);
                let t250 = t249 + t169 * t104 + t245 + t245 - t127 * t67;
                let t251 = t32 * t171 + t40 * t191 + t47 * t211 + t56 * t229
                    + t68 * t250;
                let t252 = t70 * t251;
                let t253 = t108 * (t171 - t32 * t252) + t109 * (t191 - t40 * t252)
                    + t110 * (t211 - t47 * t252);
                (
                    sin_psi,
                    cos_psi,
                    t4,
                    t6,
                    t7,
                    t12,
                    t14,
                    sin_phi,
                    cos_phi,
                    sin_theta,
                    t15,
                    t17,
                    t18,
                    t20,
                    t56,
                    t68,
                    t91,
                    t107,
                    t111,
                    t112,
                    t116,
                    t117,
                    t118,
                    t119,
                    t120,
                    t121,
                    t122,
                    t123,
                    t124,
                    t125,
                    t133,
                    t229,
                    t250,
                    t252,
                    t253,
                )
            };
            let (t298, t299, t300, t303) = {
                let t254 = t253 + t111 * (t229 - t56 * t252)
                    + t112 * (t250 - t68 * t252);
                let t255 = t116 * t254;
                let t256 = t252 - t107 * t255;
                let t257 = t255 + k2 * t133 + k3 * t256;
                let t258 = k2 * t256 - k3 * t133;
                let t259 = k3 * t122 + k2 * t125;
                let t260 = cos_psi * t259 - sin_psi * t123;
                let t261 = cos_psi * t123 + sin_psi * t259;
                let t262 = t120 + k3 * t125 - k2 * t122;
                let t263 = t120 + t262;
                let t264 = T::from_f64(0.1) * (t260 * t260 + t262 * t262);
                let t265 = T::from_f64(1.125e-5)
                    * (cos_psi * t124 + sin_psi * t258 + t260 * t263);
                let t266 = sin_psi * t124 + t261 * t263 - cos_psi * t258;
                let t267 = t260 * t261;
                let t268 = k51 - k7 * t121;
                let t269 = t125 * t123;
                let t270 = t133 + t269;
                let t271 = t268 + T::from_f64(0.8) * t270;
                let t272 = k50 + k8 * t121;
                let t273 = k49 * sin_theta - T::from_f64(0.4) * qd_theta * qd_theta;
                let t274 = cos_phi * t272 - sin_phi * t273;
                let t275 = t122 * t123;
                let t276 = t123 * t123;
                let t277 = t256 + t275;
                let t278 = t275 - t256;
                let t279 = t274 + T::from_f64(0.8) * t277;
                let t280 = k85 * t271 - k86 * t279
                    + T::from_f64(0.026677916666666666) * t266;
                let t281 = T::from_f64(0.1) * t266;
                let t282 = t125 * t125;
                let t283 = t122 * t122;
                let t284 = k48 * (t124 + t122 * t125) + cos_psi * t265 + sin_psi * t280
                    - k47 * (t276 + t282 - t276 - t283);
                let t285 = sin_psi * t265 - cos_psi * t280;
                let t286 = T::from_f64(0.96) * t274
                    + T::from_f64(0.6613445833333333) * t277 + k47 * (t269 - t133)
                    + k2 * t285;
                let t287 = t282 + t283;
                let t288 = cos_psi * (k3 * t279 + k2 * t271)
                    - sin_psi
                        * (cos_phi * t273 + sin_phi * t272 - T::from_f64(0.8) * t287);
                let t289 = t257 + t267;
                let t290 = T::from_f64(0.1) * t288
                    + T::from_f64(0.026677916666666666) * t289
                    - T::from_f64(1.125e-5) * (t267 - t257);
                let t291 = T::from_f64(0.1) * t289;
                let t292 = cos_psi * t291 - sin_psi * t264;
                let t293 = k2 * t292 + k3 * t281;
                let t294 = k3 * t285 - k2 * t290 - T::from_f64(0.8) * t293
                    - T::from_f64(0.96) * t268 - k47 * t278;
                let t295 = T::from_f64(0.86) * t121
                    + k7
                        * (sin_phi * t284
                            + cos_phi * (t294 - T::from_f64(0.6613445833333333) * t270));
                let t296 = k3 * t292 - k2 * t281;
                let t297 = cos_phi * (t296 + T::from_f64(0.96) * t277)
                    - sin_phi
                        * (T::from_f64(0.96) * t287 + cos_psi * t264 + sin_psi * t291);
                let t298 = t295 + (k24 * t297 - k40 * (t293 + T::from_f64(0.96) * t270))
                    + t117 * t290;
                let t299 = (t286 + k3 * t290 + T::from_f64(0.8) * t296 - k48 * t278)
                    * (k8 + t118);
                let t300 = k16 * (t18 - t20);
                let t301 = k88 + t7 + t17 + T::from_f64(0.8) * t15
                    + (k17 * (t6 - t17) - t300);
                let t302 = k7 * (t20 - t18) + k8 * (t14 + T::from_f64(0.4) * t15);
                let t303 = t301
                    + t117
                        * (t91
                            + (t91 + T::from_f64(0.026689166666666667) * t117
                                + t118 * t12))
                    + t118 * (t302 + (t302 + t118 * t14 + t117 * t12));
                (t298, t299, t300, t303)
            };
            ::pendulum_core::nalgebra::SVector::from([
                qd_theta,
                t119,
                t120,
                (t298 + k1 * qd_theta + t299 - k0)
                    * (T::from_f64(-1.0) / (t303 - (t300 - k87 * t4))),
            ])
        }
        #[inline]
        fn layout(
            &self,
        ) -> ::core::option::Option<&'static ::pendulum_core::StateLayout> {
            Some(&<Bennett>::LAYOUT)
        }
        #[inline]
        fn project(&self, t: T, x: &mut ::pendulum_core::nalgebra::SVector<T, 4>) {
            for _ in 0..2 {
                let corrections = self.loop_corrections(t, x);
                x[1] += corrections[0];
                x[2] += corrections[1];
            }
            let corrections = self.loop_corrections(t, x);
            x[1] += corrections[0];
            x[2] += corrections[1];
            for correction in corrections.iter() {
                x[0]
                    += T::from_f64(0.0)
                        * (T::from_f64(1e-12) - *correction * *correction).sqrt();
            }
        }
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn margins(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
            tell: &mut dyn FnMut([&'static str; 2], [T; 2]),
        ) {
            let (margins, rates) = self.loop_margins(t, x);
            tell(["third", "frame"], [margins[0], rates[0]]);
        }
        #[inline]
        fn gaps(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
            tell: &mut dyn FnMut([&'static str; 2], [T; 3]),
        ) {
            let (distances, angles, sizes) = self.loop_gaps(t, x);
            tell(["third", "frame"], [distances[0], angles[0], sizes[0]]);
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Jacobian<T, 4> for Bennett<T> {
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
            let [q_theta, q_phi, q_psi, qd_theta] = x.data.0[0];
            let k0 = self.constants[0];
            let k1 = self.constants[1];
            let k2 = self.constants[2];
            let k3 = self.constants[3];
            let k4 = self.constants[4];
            let k7 = self.constants[7];
            let k8 = self.constants[8];
            let k10 = self.constants[10];
            let k12 = self.constants[12];
            let k16 = self.constants[16];
            let k17 = self.constants[17];
            let k18 = self.constants[18];
            let k19 = self.constants[19];
            let k20 = self.constants[20];
            let k21 = self.constants[21];
            let k22 = self.constants[22];
            let k24 = self.constants[24];
            let k25 = self.constants[25];
            let k26 = self.constants[26];
            let k28 = self.constants[28];
            let k29 = self.constants[29];
            let k30 = self.constants[30];
            let k31 = self.constants[31];
            let k32 = self.constants[32];
            let k33 = self.constants[33];
            let k34 = self.constants[34];
            let k35 = self.constants[35];
            let k36 = self.constants[36];
            let k37 = self.constants[37];
            let k38 = self.constants[38];
            let k39 = self.constants[39];
            let k40 = self.constants[40];
            let k41 = self.constants[41];
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
            let k84 = self.constants[84];
            let k85 = self.constants[85];
            let k86 = self.constants[86];
            let k87 = self.constants[87];
            let k88 = self.constants[88];
            let k89 = self.constants[89];
            let k92 = self.constants[92];
            let k93 = self.constants[93];
            let k94 = self.constants[94];
            let k95 = self.constants[95];
            let (
                t1,
                sin_psi,
                cos_psi,
                t5,
                t6,
                t8,
                t13,
                t15,
                sin_phi,
                cos_phi,
                sin_theta,
                cos_theta,
                t16,
                t18,
                t19,
                t21,
                t22,
                t23,
                t24,
                t25,
                t26,
                t27,
                t28,
                t29,
                t30,
                t31,
                t32,
                t33,
                t34,
                t35,
                t36,
                t38,
                t39,
                t40,
                t41,
                t42,
                t43,
                t44,
                t45,
                t46,
                t47,
                t48,
                t49,
                t51,
                t52,
                t53,
                t54,
                t55,
                t56,
                t57,
                t58,
                t59,
                t61,
                t62,
                t63,
                t64,
                t65,
                t66,
                t67,
                t69,
                t70,
                t71,
                t72,
                t73,
                t74,
                t76,
                t77,
                t78,
                t79,
                t81,
                t82,
                t83,
                t84,
                t85,
                t86,
                t87,
                t88,
                t89,
                t91,
                t92,
                t94,
                t96,
                t97,
                t98,
                t99,
                t100,
                t101,
                t102,
                t103,
                t104,
                t105,
                t106,
                t108,
                t109,
                t111,
                t112,
                t114,
                t115,
                t116,
                t117,
                t118,
                t119,
                t120,
                t121,
                t122,
                t123,
                t124,
                t125,
                t126,
                t127,
                t131,
                t132,
                t133,
                t134,
                t135,
                t136,
                t137,
                t138,
                t139,
                t140,
                t150,
                t156,
                t157,
                t158,
                t159,
                t162,
                t163,
                t169,
                t174,
                t175,
                t176,
                t178,
                t184,
                t185,
                t191,
                t193,
                t194,
                t195,
                t210,
                t211,
                t213,
                t214,
                t216,
                t217,
                t218,
                t219,
                t220,
                t222,
                t226,
                t228,
                t229,
                t230,
                t231,
                t232,
                t233,
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
                t249,
                t250,
                t251,
                t252,
                t253,
            ) = {
                let t0 = k7 * qd_theta;
                let t1 = T::from_f64(0.8) * qd_theta;
                let (sin_psi, cos_psi) = q_psi.sin_cos();
                let t2 = T::from_f64(0.02666666666666667) * cos_psi;
                let t3 = cos_psi * t2;
                let t4 = sin_psi * t2;
                let t5 = T::from_f64(0.026677916666666666) - t3;
                let t6 = T::from_f64(0.6613558333333334) + t3
                    + T::from_f64(0.16) * cos_psi;
                let t7 = k3 * t5;
                let t8 = k48 + k3 * t7;
                let t9 = T::from_f64(0.1) * sin_psi;
                let t10 = k3 * t9;
                let t11 = T::from_f64(0.1) * cos_psi;
                let t12 = k3 * t11;
                let t13 = k53 + T::from_f64(0.8) * t12;
                let t14 = k2 * t11;
                let t15 = t8 + t6;
                let [(sin_phi, cos_phi), (sin_theta, cos_theta)] = q_phi
                    .sin_cos_pair(q_theta);
                let t16 = cos_phi * (T::from_f64(0.96) + t11) - sin_phi * t10;
                let t17 = cos_phi * (t6 - t8)
                    - T::from_f64(2.0) * sin_phi * (k3 * t4 + T::from_f64(0.8) * t10);
                let t18 = cos_phi * t17;
                let t19 = sin_phi * (k2 * (t4 + T::from_f64(0.8) * t9));
                let t20 = k8 * t13 + (k24 * (cos_phi * t12 - sin_phi * t9) - k40 * t14);
                let t21 = cos_phi * (k47 - k2 * t7);
                let t22 = k42 * sin_theta;
                let t23 = k45 * cos_theta;
                let t24 = k43 + t23;
                let t25 = k44 * cos_theta;
                let t26 = cos_phi * t25 - k46 * cos_phi;
                let t27 = k43 * cos_theta;
                let t28 = k16 * sin_phi - (sin_phi * t27 + k45 * sin_phi);
                let t29 = k4 * cos_theta;
                let t30 = sin_phi * t29;
                let t31 = k41 * sin_theta;
                let t32 = cos_phi * t31;
                let t33 = k12 * sin_theta;
                let t34 = sin_phi * t33;
                let t35 = k2 * cos_theta;
                let t36 = cos_phi * t35;
                let t37 = cos_psi * t30 + cos_psi * t32
                    - (sin_psi * t34 - sin_psi * t36);
                let t38 = cos_phi * t22 + sin_phi * t24 + sin_psi * t26 - cos_psi * t28
                    - t37;
                let t39 = cos_psi * t22 - t37;
                let t40 = k42 * sin_phi;
                let t41 = k10 * cos_phi;
                let t42 = k12 * cos_theta;
                let t43 = cos_phi * t42;
                let t44 = k41 * cos_theta;
                let t45 = sin_phi * t44;
                let t46 = k4 * sin_theta;
                let t47 = cos_phi * t46;
                let t48 = k2 * sin_theta;
                let t49 = sin_phi * t48;
                let t50 = cos_psi * t43 - sin_psi * t45
                    - (sin_psi * t47 + cos_psi * t49);
                let t51 = k7 * sin_phi;
                let t52 = sin_psi * t51;
                let t53 = sin_psi * t40 + cos_psi * t41 + t50 - t52;
                let t54 = k34 * cos_theta;
                let t55 = k25 * sin_theta;
                let t56 = k37 * sin_phi - sin_phi * t54 - cos_phi * t55 - k40 * sin_phi;
                let t57 = k36 * cos_theta;
                let t58 = k18 * sin_theta;
                let t59 = k39 * cos_phi + (cos_phi * t57 - sin_phi * t58);
                let t60 = k35 * cos_theta;
                let t61 = k38 + t60;
                let t62 = k28 * sin_theta;
                let t63 = sin_psi * t56 + cos_psi * t59 + cos_phi * t61 - sin_phi * t62;
                let t64 = k22 * sin_theta;
                let t65 = T::from_f64(0.8) * cos_theta;
                let t66 = T::from_f64(0.4) * cos_theta;
                let t67 = sin_phi * t66;
                let t68 = cos_psi * t67;
                let t69 = k24 * sin_theta;
                let t70 = cos_phi * t69;
                let t71 = k21 * sin_theta;
                let t72 = sin_phi * t71;
                let t73 = k20 * cos_theta;
                let t74 = cos_phi * t73;
                let t75 = cos_psi * t70 - (sin_psi * t72 - sin_psi * t74);
                let t76 = cos_phi * t64 + sin_phi * t65 + t68 + t75;
                let t77 = k31 * cos_theta;
                let t78 = k30 * sin_theta;
                let t79 = sin_phi * t77 + (cos_phi * t78 + k26 * sin_phi);
                let t80 = k33 * cos_theta;
                let t81 = t80 - k29;
                let t82 = k21 * cos_theta;
                let t83 = cos_phi * t82;
                let t84 = k20 * sin_theta;
                let t85 = sin_phi * t84;
                let t86 = k24 * cos_theta;
                let t87 = sin_phi * t86;
                let t88 = T::from_f64(0.4) * sin_theta;
                let t89 = cos_phi * t88;
                let t90 = cos_psi * t83 - cos_psi * t85
                    - (sin_psi * t87 + sin_psi * t89);
                let t91 = k19 * cos_phi;
                let t92 = k32 * sin_theta;
                let t93 = sin_phi * t80 + cos_phi * t92;
                let t94 = sin_psi * t79 + cos_phi * t81 + t90 - cos_psi * t91
                    - sin_phi * t92;
                let t95 = t38 * t38 + t53 * t53 + t63 * t63 + t76 * t76 + t94 * t94;
                let t96 = T::from_f64(1.0) / t95;
                let t97 = k33 * sin_theta;
                let t98 = sin_psi * t67 + cos_psi * t72
                    - (cos_psi * t74 - sin_psi * t70);
                let t99 = k32 * cos_theta;
                let t100 = k31 * sin_theta;
                let t101 = cos_phi * t100;
                let t102 = k30 * cos_theta;
                let t103 = sin_phi * t102;
                let t104 = k26 * sin_theta;
                let t105 = t101 + (t103 + t104);
                let t106 = t68 - (cos_psi * t105 - t75);
                let t107 = sin_phi * t97 + t98 - t73 - cos_phi * t99 - sin_psi * t105;
                let t108 = k22 * cos_theta;
                let t109 = T::from_f64(0.8) * sin_theta;
                let t110 = cos_psi * t89 + sin_psi * t83
                    - (sin_psi * t85 - cos_psi * t87);
                let t111 = k19 * cos_theta;
                let t112 = cos_psi * t111 - t90;
                let t113 = t88 + sin_phi * t108 + cos_phi * t109 + t110 - sin_psi * t111;
                let t114 = sin_psi * t91 + cos_psi * t79 - t110;
                let t115 = k18 * cos_theta;
                let t116 = k28 * cos_theta;
                let t117 = k37 * sin_theta;
                let t118 = k34 * sin_theta;
                let t119 = cos_phi * t118;
                let t120 = k25 * cos_theta;
                let t121 = sin_phi * t120;
                let t122 = t117 - t119 - t121;
                let t123 = k35 * sin_theta;
                let t124 = k36 * sin_theta;
                let t125 = sin_phi * t124;
                let t126 = cos_phi * t115;
                let t127 = t125 - t126;
                let t128 = t115 + cos_phi * t116 + sin_psi * t122 - sin_phi * t123
                    - cos_psi * t127;
                let t129 = cos_psi * t36 - sin_psi * t32
                    - (sin_psi * t30 + cos_psi * t34);
                let t130 = sin_psi * t22 + t129;
                let t131 = sin_psi * t28 + cos_psi * t26 - t129;
                let t132 = k43 * sin_theta;
                let t133 = k45 * sin_theta;
                let t134 = k42 * cos_theta;
                let t135 = cos_phi * t132;
                let t136 = t135 + t133;
                let t137 = sin_psi * t49 - cos_psi * t47
                    - (cos_psi * t45 + sin_psi * t43);
                let t138 = k44 * sin_theta;
                let t139 = sin_phi * t138;
                let t140 = sin_psi * t135 + cos_psi * t139 + (sin_psi * t133 + t50);
                let t141 = t132 + cos_phi * t133 + sin_phi * t134 + cos_psi * t136 + t137
                    - sin_psi * t139;
                let t142 = t94 * t107 - t76 * t113 - t63 * t128 - t53 * t130
                    - t38 * t141;
                let t143 = t96 * t142;
                let t144 = k45 * cos_phi;
                let t145 = k16 * cos_phi;
                let t146 = cos_phi * t27;
                let t147 = t144 - t145 + (t24 - (k4 - t146));
                let t148 = sin_phi * t25;
                let t149 = k46 * sin_phi;
                let t150 = cos_psi * t145 - (sin_psi * t149 + cos_psi * t144);
                let t151 = t148 - t149;
                let t152 = sin_phi * t31;
                let t153 = cos_phi * t29;
                let t154 = cos_phi * t33;
                let t155 = sin_phi * t35;
                let t156 = cos_psi * t152 + sin_psi * t154
                    + (sin_psi * t155 - sin_psi * t148
                        - (cos_psi * t153 - cos_psi * t146));
                let t157 = sin_psi * t152 - sin_psi * t153
                    - (cos_psi * t154 + cos_psi * t155);
                let t158 = t153 - t152 - t147;
                let t159 = t151 - t154 - t155;
                let t160 = sin_psi * t147 + cos_psi * t151 + t157;
                let t161 = k42 * cos_phi;
                let t162 = k7 * cos_phi;
                let t163 = t20 - t162 * (k52 + T::from_f64(0.8) * t14);
                let t164 = k41 - t134 - (t161 - t162);
                let t165 = cos_phi * t44;
                let t166 = sin_phi * t46;
                let t167 = cos_psi * t165 - cos_psi * t166;
                let t168 = k10 * sin_phi;
                let t169 = sin_psi * t162 - (sin_psi * t161 - cos_psi * t168);
                let t170 = sin_phi * t42;
                let t171 = cos_phi * t48;
                let t172 = sin_psi * t170 + sin_psi * t171;
                let t173 = cos_psi * t164 + t167 - sin_psi * t168 - t172;
                let t174 = t165 + t164 - t166;
                let t175 = cos_psi * t171 + cos_psi * t170
                    + (sin_psi * t165 - sin_psi * t166);
                let t176 = t170 + t171 + t168;
                let t177 = t138 * (sin_psi * cos_phi) + t132 * (sin_phi * cos_psi) + t167
                    + sin_phi * t133;
                let t178 = t177 - (cos_phi * t134 + t172);
                let t179 = cos_phi * t54;
                let t180 = k40 * cos_phi;
                let t181 = sin_phi * t55;
                let t182 = k37 * cos_theta;
                let t183 = k37 * cos_phi;
                let t184 = k34 + t179 + t180 - t181 - t182 - t183;
                let t185 = sin_psi * t182;
                let t186 = k39 * sin_phi;
                let t187 = sin_psi * t180 - (sin_psi * t183 - cos_psi * t186);
                let t188 = sin_phi * t57;
                let t189 = sin_psi * t181 - (cos_psi * t188 + sin_psi * t179);
                let t190 = cos_phi * t58;
                let t191 = t186 + (t188 + t190);
                let t192 = cos_psi * t190;
                let t193 = sin_phi * t60 - t189 + (t192 + cos_phi * t62);
                let t194 = t185 + t189 - t192 - k34 * sin_psi - t187;
                let t195 = k38 * sin_phi + t193 + t187;
                let t196 = cos_psi * t184 - sin_psi * t191;
                let t197 = k19 * sin_phi;
                let t198 = k26 * cos_theta;
                let t199 = k26 * cos_phi;
                let t200 = cos_phi * t77;
                let t201 = sin_phi * t78;
                let t202 = t198 + t199 + (t200 + (k31 - t201));
                let t203 = cos_psi * t197 + sin_psi * t199;
                let t204 = sin_phi * t82;
                let t205 = cos_phi * t84;
                let t206 = cos_phi * t86;
                let t207 = sin_phi * t88;
                let t208 = cos_psi * t205 + sin_psi * t206
                    - (sin_psi * t207 + sin_psi * t200
                        - (sin_psi * t201 + cos_psi * t204));
                let t209 = sin_psi * t198 - t208;
                let t210 = k29 * sin_phi + t203 - t208 - t93;
                let t211 = k31 * sin_psi + t209 + t203;
                let t212 = sin_psi * t204 + sin_psi * t205
                    - (cos_psi * t206 - cos_psi * t207);
                let t213 = t206 - t207 - t202;
                let t214 = t204 + t205 - t197;
                let t215 = sin_psi * t197 - cos_psi * t202 - t212;
                let t216 = sin_phi * t109 + t212 - cos_phi * t108;
                let t217 = k19 * sin_theta;
                let t218 = sin_phi * t69;
                let t219 = cos_phi * t71;
                let t220 = sin_phi * t73;
                let t221 = sin_psi * t218 - (cos_psi * t219 + cos_psi * t220);
                let t222 = cos_phi * t66;
                let t223 = sin_psi * t222;
                let t224 = cos_psi * t217 + t221 - t223;
                let t225 = cos_phi * (sin_psi * t102 - t97) + t221
                    - sin_phi * (t99 + sin_psi * t100);
                let t226 = t223 - t225;
                let t227 = t38 * t160 + t53 * t173 + t63 * t196 + t94 * t215
                    - t76 * t224;
                let t228 = t96 * t227;
                let t229 = t160 - t38 * t228;
                let t230 = t173 - t53 * t228;
                let t231 = t196 - t63 * t228;
                let t232 = t224 + t76 * t228;
                let t233 = t215 - t94 * t228;
                let t234 = t232 * (t113 + t76 * t143) + t233 * (t107 - t94 * t143)
                    - t231 * (t128 + t63 * t143);
                let t235 = t234 - t230 * (t130 + t53 * t143)
                    - t229 * (t141 + t38 * t143);
                let t236 = t229 * t229 + t230 * t230 + t231 * t231 + t232 * t232
                    + t233 * t233;
                let t237 = T::from_f64(1.0) / t236;
                let t238 = t237 * t235;
                let t239 = t143 - t228 * t238;
                let t240 = t209 - t84 - t239 * t226 - t238 * t106 - t93;
                let t241 = qd_theta * t239;
                let t242 = qd_theta * t238;
                let t243 = k49 * cos_theta;
                let t244 = cos_phi * t0;
                let t245 = sin_phi * t0;
                let t246 = t241 * t244;
                let t247 = t241 + k8 * qd_theta;
                let t248 = t244 * t247;
                let t249 = sin_phi * t241;
                let t250 = t241 * t249;
                let t251 = qd_theta * sin_theta;
                let t252 = qd_theta * t251;
                let t253 = k42 * t252;
                (
                    t1,
                    sin_psi,
                    cos_psi,
                    t5,
                    t6,
                    t8,
                    t13,
                    t15,
                    sin_phi,
                    cos_phi,
                    sin_theta,
                    cos_theta,
                    t16,
                    t18,
                    t19,
                    t21,
                    t22,
                    t23,
                    t24,
                    t25,
                    t26,
                    t27,
                    t28,
                    t29,
                    t30,
                    t31,
                    t32,
                    t33,
                    t34,
                    t35,
                    t36,
                    t38,
                    t39,
                    t40,
                    t41,
                    t42,
                    t43,
                    t44,
                    t45,
                    t46,
                    t47,
                    t48,
                    t49,
                    t51,
                    t52,
                    t53,
                    t54,
                    t55,
                    t56,
                    t57,
                    t58,
                    t59,
                    t61,
                    t62,
                    t63,
                    t64,
                    t65,
                    t66,
                    t67,
                    t69,
                    t70,
                    t71,
                    t72,
                    t73,
                    t74,
                    t76,
                    t77,
                    t78,
                    t79,
                    t81,
                    t82,
                    t83,
                    t84,
                    t85,
                    t86,
                    t87,
                    t88,
                    t89,
                    t91,
                    t92,
                    t94,
                    t96,
                    t97,
                    t98,
                    t99,
                    t100,
                    t101,
                    t102,
                    t103,
                    t104,
                    t105,
                    t106,
                    t108,
                    t109,
                    t111,
                    t112,
                    t114,
                    t115,
                    t116,
                    t117,
                    t118,
                    t119,
                    t120,
                    t121,
                    t122,
                    t123,
                    t124,
                    t125,
                    t126,
                    t127,
                    t131,
                    t132,
                    t133,
                    t134,
                    t135,
                    t136,
                    t137,
                    t138,
                    t139,
                    t140,
                    t150,
                    t156,
                    t157,
                    t158,
                    t159,
                    t162,
                    t163,
                    t169,
                    t174,
                    t175,
                    t176,
                    t178,
                    t184,
                    t185,
                    t191,
                    t193,
                    t194,
                    t195,
                    t210,
                    t211,
                    t213,
                    t214,
                    t216,
                    t217,
                    t218,
                    t219,
                    t220,
                    t222,
                    t226,
                    t228,
                    t229,
                    t230,
                    t231,
                    t232,
                    t233,
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
                    t249,
                    t250,
                    t251,
                    t252,
                    t253,
                )
            };
            let (
                t254,
                t255,
                t256,
                t257,
                t259,
                t260,
                t261,
                t263,
                t265,
                t267,
                t268,
                t271,
                t272,
                t273,
                t274,
                t276,
                t277,
                t278,
                t279,
                t280,
                t281,
                t282,
                t283,
                t284,
                t285,
                t286,
                t287,
                t288,
                t289,
                t292,
                t293,
                t301,
                t303,
                t304,
                t306,
                t308,
                t312,
                t313,
                t314,
                t315,
                t316,
                t320,
                t323,
                t324,
                t325,
                t326,
                t327,
                t328,
                t329,
                t330,
                t331,
                t332,
                t333,
                t337,
                t338,
                t339,
                t341,
                t342,
                t344,
                t346,
                t348,
                t349,
                t351,
                t352,
                t355,
                t357,
                t358,
                t359,
                t360,
                t361,
                t362,
                t363,
                t364,
                t365,
                t366,
                t370,
                t372,
                t374,
                t376,
                t379,
                t380,
                t381,
                t382,
                t383,
                t384,
                t385,
                t386,
                t387,
                t388,
                t389,
                t390,
                t391,
                t392,
                t393,
                t394,
                t395,
                t396,
                t400,
                t405,
                t407,
                t409,
                t411,
                t414,
                t415,
                t416,
                t417,
                t419,
                t422,
                t423,
                t425,
                t426,
                t427,
                t428,
                t429,
                t430,
                t432,
                t434,
                t436,
                t438,
                t439,
                t440,
                t441,
                t442,
                t443,
                t444,
                t445,
                t452,
                t453,
                t454,
                t457,
                t458,
                t459,
                t460,
                t463,
                t467,
                t469,
                t470,
                t472,
                t475,
                t482,
                t483,
                t488,
                t491,
                t496,
                t497,
                t498,
                t506,
                t507,
                t508,
                t509,
            ) = {
                let t254 = cos_psi * t242;
                let t255 = t242 * t254;
                let t256 = cos_phi * t241;
                let t257 = k44 * t251;
                let t258 = t256 * t257;
                let t259 = cos_theta * qd_theta;
                let t260 = qd_theta * t259;
                let t261 = k44 * t260;
                let t262 = k12 * t252;
                let t263 = k12 * t259;
                let t264 = t249 * t263;
                let t265 = t241 * t256;
                let t266 = t258 + t258 + t25 * t250 + sin_phi * t261
                    - (cos_phi * t262 + t264 + t264 + t33 * t265);
                let t267 = sin_phi * t262;
                let t268 = k2 * t251;
                let t269 = t256 * t268;
                let t270 = k2 * t260;
                let t271 = t266
                    - (t269 + t269 + t35 * t250 + sin_phi * t270 + k46 * t250);
                let t272 = cos_phi * t270;
                let t273 = sin_psi * t242;
                let t274 = t242 * t273;
                let t275 = t22 * t250 + sin_phi * t253 + t255 * t158 + sin_psi * t271
                    + t274 * t159;
                let t276 = k45 * t251;
                let t277 = k45 * t249;
                let t278 = k42 * t259;
                let t279 = k46 * t256;
                let t280 = k16 * t249;
                let t281 = t25 * t256 - sin_phi * t257;
                let t282 = k4 * t251;
                let t283 = cos_phi * t282 + t29 * t249;
                let t284 = k41 * t259;
                let t285 = sin_phi * t284 + t31 * t256;
                let t286 = k43 * t251;
                let t287 = cos_phi * t286 + t27 * t249;
                let t288 = cos_phi * t263 - t33 * t249;
                let t289 = t35 * t256 - sin_phi * t268;
                let t290 = t273 * t280 + t254 * t281 + (t273 * t283 + t273 * t285)
                    - (t273 * t287 + t254 * t288 + (t254 * t289 + t249 * t276));
                let t291 = t273 * t276 + t273 * t277 - (t256 * t278 - t254 * t279)
                    - t290;
                let t292 = k43 * t260;
                let t293 = k45 * t260;
                let t294 = k4 * t260;
                let t295 = t249 * t282;
                let t296 = t256 * t284;
                let t297 = k41 * t252;
                let t298 = t249 * t286;
                let t299 = t296 + t296 - t31 * t250 - sin_phi * t297
                    - (t27 * t265 + cos_phi * t292 - t298 - t298);
                let t300 = k16 * t265 + (t29 * t265 + cos_phi * t294 - t295 - t295)
                    + t299;
                let t301 = t293 + k45 * t265 - t300;
                let t302 = t275 + t291 + t291 - t292 - cos_phi * t293 - cos_psi * t301
                    - t265 * t24;
                let t303 = cos_phi * t297;
                let t304 = sin_phi * t294;
                let t305 = k41 * t260;
                let t306 = k41 * t251;
                let t307 = t249 * t306;
                let t308 = k4 * t259;
                let t309 = t256 * t308;
                let t310 = k4 * t252;
                let t311 = t44 * t265 + cos_phi * t305 - t307 - t307
                    + (t309 + t309 - t46 * t250 - sin_phi * t310);
                let t312 = cos_phi * t310;
                let t313 = sin_phi * t305;
                let t314 = k42 * t260;
                let t315 = t311 - (k42 * t265 - (k7 * t265 - t314));
                let t316 = k12 * t251;
                let t317 = t256 * t316;
                let t318 = k12 * t260;
                let t319 = k2 * t252;
                let t320 = k2 * t259;
                let t321 = t249 * t320;
                let t322 = t317 + t317 + t42 * t250 + sin_phi * t318
                    + (cos_phi * t319 + t321 + t321 + t48 * t265);
                let t323 = k10 * t250 + t322;
                let t324 = cos_phi * t318;
                let t325 = sin_phi * t319;
                let t326 = k7 * t249;
                let t327 = k42 * t251;
                let t328 = cos_phi * t306 + t44 * t249;
                let t329 = sin_phi * t308 + t46 * t256;
                let t330 = t42 * t256 - sin_phi * t316;
                let t331 = cos_phi * t320 - t48 * t249;
                let t332 = k42 * t249;
                let t333 = k10 * t256;
                let t334 = t254 * t326 - t254 * t327 + (t254 * t328 + t254 * t329)
                    + (t273 * t330 + t273 * t331 - (t254 * t332 - t273 * t333));
                let t335 = t274 * t174 + sin_psi * t315 + cos_psi * t323 + t255 * t176
                    + t334;
                let t336 = t335 + t334;
                let t337 = k18 * t252;
                let t338 = k35 * t260;
                let t339 = k28 * t252;
                let t340 = t337 + sin_phi * t338 + cos_phi * t339 + t62 * t265
                    + t274 * t184;
                let t341 = k34 * t260;
                let t342 = k34 * t251;
                let t343 = t249 * t342;
                let t344 = k25 * t259;
                let t345 = t256 * t344;
                let t346 = k25 * t252;
                let t347 = t54 * t265 + cos_phi * t341 - t343 - t343
                    + (t345 + t345 - t55 * t250 - sin_phi * t346);
                let t348 = t347 - (k37 * t265 - (k40 * t265 - k37 * t260));
                let t349 = k36 * t251;
                let t350 = t256 * t349;
                let t351 = k36 * t260;
                let t352 = k18 * t259;
                let t353 = t249 * t352;
                let t354 = t350 + t350 + t57 * t250 + sin_phi * t351
                    + (cos_phi * t337 + t353 + t353 + t58 * t265);
                let t355 = k39 * t250 + t354;
                let t356 = t340 + sin_psi * t348 + cos_psi * t355 + t255 * t191
                    + t250 * t61;
                let t357 = k35 * t251;
                let t358 = t57 * t256 - sin_phi * t349;
                let t359 = k28 * t259;
                let t360 = cos_phi * t352 - t58 * t249;
                let t361 = k37 * t249;
                let t362 = k39 * t256;
                let t363 = k40 * t249;
                let t364 = k37 * t251;
                let t365 = cos_phi * t342 + t54 * t249;
                let t366 = sin_phi * t344 + t55 * t256;
                let t367 = t254 * t361 - t273 * t362
                    - (t254 * t363 - t254 * t364 + (t254 * t365 + t254 * t366));
                let t368 = t256 * t357 + t273 * t358 + (t249 * t359 + t273 * t360)
                    - t367;
                let t369 = t356 + t368 + t368;
                let t370 = k33 * t260;
                let t371 = k20 * t252;
                let t372 = k32 * t252;
                let t373 = sin_phi * t370 + t371 + cos_phi * t372 + t92 * t265
                    + t274 * t213;
                let t374 = k20 * t259;
                let t375 = t249 * t374;
                let t376 = k21 * t251;
                let t377 = t256 * t376;
                let t378 = k21 * t260;
                let t379 = cos_phi * t371 + t375 + t375 + t84 * t265
                    - (k19 * t250 - (t377 + t377 + t82 * t250 + sin_phi * t378));
                let t380 = cos_phi * t378;
                let t381 = sin_phi * t371;
                let t382 = k33 * t251;
                let t383 = t82 * t256 - sin_phi * t376;
                let t384 = k32 * t259;
                let t385 = cos_phi * t374 - t84 * t249;
                let t386 = k24 * t251;
                let t387 = cos_phi * t386 + t86 * t249;
                let t388 = T::from_f64(0.4) * t259;
                let t389 = sin_phi * t388 + t88 * t256;
                let t390 = k30 * t259;
                let t391 = sin_phi * t390 + t78 * t256;
                let t392 = k26 * t251;
                let t393 = k26 * t249;
                let t394 = k19 * t256;
                let t395 = k31 * t251;
                let t396 = cos_phi * t395 + t77 * t249;
                let t397 = t254 * t387 + (t254 * t389 - t254 * t391)
                    - (t254 * t392 + t254 * t393 + (t273 * t394 + t254 * t396));
                let t398 = t256 * t382 + t273 * t383 + (t249 * t384 + t273 * t385)
                    + t397;
                let t399 = t373 + cos_psi * t379 + t255 * t214 + t250 * t81 + t398
                    + t398;
                let t400 = k31 * t260;
                let t401 = t249 * t395;
                let t402 = k24 * t260;
                let t403 = t249 * t386;
                let t404 = t77 * t265 + cos_phi * t400 - t401 - t401
                    - (t86 * t265 + cos_phi * t402 - t403 - t403);
                let t405 = sin_phi * t402;
                let t406 = t256 * t388;
                let t407 = T::from_f64(0.4) * t252;
                let t408 = t256 * t390;
                let t409 = k30 * t252;
                let t410 = t406 + t406 - t88 * t250 - sin_phi * t407
                    - (t408 + t408 - t78 * t250 - sin_phi * t409);
                let t411 = t404 - (t410 - (k26 * t260 + k26 * t265));
                let t412 = t399 - sin_psi * t411;
                let t413 = T::from_f64(0.4) * t260;
                let t414 = T::from_f64(0.8) * t260;
                let t415 = t217 - t219 - t220;
                let t416 = sin_psi * t220 + sin_psi * t219;
                let t417 = T::from_f64(0.4) * t251;
                let t418 = t249 * t417;
                let t419 = k24 * t259;
                let t420 = t256 * t419;
                let t421 = k24 * t252;
                let t422 = t66 * t265 + cos_phi * t413 - t418 - t418
                    + (t420 + t420 - t69 * t250 - sin_phi * t421);
                let t423 = cos_phi * t421;
                let t424 = t413 + t65 * t265 + cos_phi * t414 + t274 * t415
                    + cos_psi * t422;
                let t425 = sin_phi * t413;
                let t426 = t222 - t218;
                let t427 = cos_psi * t222 - cos_psi * t218;
                let t428 = t416 - sin_psi * t217 - t427;
                let t429 = k22 * t252;
                let t430 = k20 * t251;
                let t431 = t256 * t430;
                let t432 = k20 * t260;
                let t433 = k21 * t252;
                let t434 = k21 * t259;
                let t435 = t249 * t434;
                let t436 = t431 + t431 + t73 * t250 + sin_phi * t432
                    - (k19 * t252 - (cos_phi * t433 + t435 + t435 + t71 * t265));
                let t437 = t424 + t255 * t426 - t64 * t250 - sin_phi * t429
                    - sin_psi * t436;
                let t438 = sin_phi * t433;
                let t439 = T::from_f64(0.8) * t251;
                let t440 = cos_phi * t417 + t66 * t249;
                let t441 = k19 * t259;
                let t442 = cos_phi * t434 - t71 * t249;
                let t443 = t73 * t256 - sin_phi * t430;
                let t444 = k22 * t259;
                let t445 = sin_phi * t419 + t69 * t256;
                let t446 = t249 * t439 + (t273 * t440 + t254 * t441)
                    - (t254 * t442 + t254 * t443 + (t256 * t444 - t273 * t445));
                let t447 = t437 - t446 - t446;
                let t448 = t38 * t302 + t53 * t336 + t63 * t369 + t94 * t412
                    - t76 * t447;
                let t449 = t96 * t448;
                let t450 = t229 * (t302 - t38 * t449) + t230 * (t336 - t53 * t449)
                    + t231 * (t369 - t63 * t449);
                let t451 = t450 + t232 * (t447 + t76 * t449)
                    + t233 * (t412 - t94 * t449);
                let t452 = t237 * t451;
                let t453 = t449 - t228 * t452;
                let t454 = t241 * t245;
                let t455 = k2 * t453 - k3 * t454;
                let t456 = k3 * t244 + k2 * t247;
                let t457 = cos_psi * t456 - sin_psi * t245;
                let t458 = cos_psi * t245 + sin_psi * t456;
                let t459 = t242 + k3 * t247 - k2 * t244;
                let t460 = t242 * t457 + t457 * t459;
                let t461 = T::from_f64(1.125e-5)
                    * (cos_psi * t246 + sin_psi * t455 + t460);
                let t462 = k51 - k7 * t243;
                let t463 = t247 * t245;
                let t464 = t454 + t463;
                let t465 = t462 + T::from_f64(0.8) * t464;
                let t466 = k50 + k8 * t243;
                let t467 = k49 * sin_theta;
                let t468 = t467 - T::from_f64(0.4) * qd_theta * qd_theta;
                let t469 = sin_phi * t468;
                let t470 = cos_phi * t468;
                let t471 = cos_phi * t466 - t469;
                let t472 = t244 * t245;
                let t473 = t453 + t472;
                let t474 = t471 + T::from_f64(0.8) * t473;
                let t475 = t459 * t458 + t242 * t458;
                let t476 = sin_psi * t246 + t475 - cos_psi * t455;
                let t477 = k85 * t465 - k86 * t474
                    + T::from_f64(0.026677916666666666) * t476;
                let t478 = T::from_f64(0.1) * t476;
                let t479 = t247 * t247;
                let t480 = t245 * t245;
                let t481 = t244 * t244;
                let t482 = t480 - t481;
                let t483 = k47 * (t479 + t482 - t480);
                let t484 = t479 + t481;
                let t485 = sin_phi
                    * (k48 * (t246 + t248) + cos_psi * t461 + sin_psi * t477 - t483);
                let t486 = sin_psi * t461 - cos_psi * t477;
                let t487 = T::from_f64(0.96) * t471
                    + T::from_f64(0.6613445833333333) * t473 + k47 * (t463 - t454)
                    + k2 * t486;
                let t488 = T::from_f64(0.8) * t484;
                let t489 = cos_psi * (k3 * t474 + k2 * t465)
                    - sin_psi * (t470 + sin_phi * t466 - t488);
                let t490 = t452 + k2 * t454 + k3 * t453;
                let t491 = t457 * t458;
                let t492 = t490 + t491;
                let t493 = T::from_f64(0.1) * t489
                    + T::from_f64(0.026677916666666666) * t492
                    - T::from_f64(1.125e-5) * (t491 - t490);
                let t494 = T::from_f64(0.1) * t492;
                let t495 = T::from_f64(0.1) * (t457 * t457 + t459 * t459);
                let t496 = sin_psi * t495;
                let t497 = cos_psi * t495;
                let t498 = T::from_f64(0.96) * t484 + t497;
                let t499 = cos_psi * t494 - t496;
                let t500 = k2 * t499 + k3 * t478;
                let t501 = k3 * t499 - k2 * t478;
                let t502 = k24
                    * (cos_phi * (t501 + T::from_f64(0.96) * t473)
                        - sin_phi * (sin_psi * t494 + t498));
                let t503 = t472 - t453;
                let t504 = k3 * t486 - k2 * t493 - T::from_f64(0.8) * t500
                    - T::from_f64(0.96) * t462 - k47 * t503;
                let t505 = T::from_f64(0.86) * t243
                    + k7
                        * (t485
                            + cos_phi * (t504 - T::from_f64(0.6613445833333333) * t464))
                    + (t502 - k40 * (t500 + T::from_f64(0.96) * t464));
                let t506 = k8 + t239;
                let t507 = t505 + t238 * t493 + k1 * qd_theta
                    + (t487 + k3 * t493 + T::from_f64(0.8) * t501 - k48 * t503) * t506;
                let t508 = k16 * (t19 - t21);
                let t509 = k88 + t8 + t18 + T::from_f64(0.8) * t16
                    + (k17 * (t6 - t18) - t508);
                (
                    t254,
                    t255,
                    t256,
                    t257,
                    t259,
                    t260,
                    t261,
                    t263,
                    t265,
                    t267,
                    t268,
                    t271,
                    t272,
                    t273,
                    t274,
                    t276,
                    t277,
                    t278,
                    t279,
                    t280,
                    t281,
                    t282,
                    t283,
                    t284,
                    t285,
                    t286,
                    t287,
                    t288,
                    t289,
                    t292,
                    t293,
                    t301,
                    t303,
                    t304,
                    t306,
                    t308,
                    t312,
                    t313,
                    t314,
                    t315,
                    t316,
                    t320,
                    t323,
                    t324,
                    t325,
                    t326,
                    t327,
                    t328,
                    t329,
                    t330,
                    t331,
                    t332,
                    t333,
                    t337,
                    t338,
                    t339,
                    t341,
                    t342,
                    t344,
                    t346,
                    t348,
                    t349,
                    t351,
                    t352,
                    t355,
                    t357,
                    t358,
                    t359,
                    t360,
                    t361,
                    t362,
                    t363,
                    t364,
                    t365,
                    t366,
                    t370,
                    t372,
                    t374,
                    t376,
                    t379,
                    t380,
                    t381,
                    t382,
                    t383,
                    t384,
                    t385,
                    t386,
                    t387,
                    t388,
                    t389,
                    t390,
                    t391,
                    t392,
                    t393,
                    t394,
                    t395,
                    t396,
                    t400,
                    t405,
                    t407,
                    t409,
                    t411,
                    t414,
                    t415,
                    t416,
                    t417,
                    t419,
                    t422,
                    t423,
                    t425,
                    t426,
                    t427,
                    t428,
                    t429,
                    t430,
                    t432,
                    t434,
                    t436,
                    t438,
                    t439,
                    t440,
                    t441,
                    t442,
                    t443,
                    t444,
                    t445,
                    t452,
                    t453,
                    t454,
                    t457,
                    t458,
                    t459,
                    t460,
                    t463,
                    t467,
                    t469,
                    t470,
                    t472,
                    t475,
                    t482,
                    t483,
                    t488,
                    t491,
                    t496,
                    t497,
                    t498,
                    t506,
                    t507,
                    t508,
                    t509,
                )
            };
            let (
                t512,
                t513,
                t516,
                t518,
                t521,
                t522,
                t523,
                t524,
                t527,
                t533,
                t534,
                t535,
                t536,
                t546,
                t547,
                t556,
                t562,
                t565,
                t570,
                t571,
                t573,
                t575,
                t576,
                t577,
                t578,
                t580,
                t581,
                t583,
                t584,
                t587,
                t596,
                t598,
                t599,
                t600,
                t601,
                t604,
                t605,
                t606,
                t607,
                t609,
                t613,
                t619,
                t620,
                t630,
                t631,
                t639,
                t640,
                t645,
                t658,
                t662,
                t663,
                t665,
                t670,
                t671,
                t673,
                t674,
                t676,
                t677,
                t678,
                t679,
                t681,
                t686,
                t692,
                t694,
                t700,
                t701,
                t702,
                t703,
                t704,
                t705,
                t707,
                t708,
                t709,
                t710,
                t712,
                t713,
                t717,
                t732,
                t733,
                t744,
                t751,
                t753,
                t759,
                t761,
                t763,
                t764,
                t765,
            ) = {
                let t510 = k7 * (t21 - t19) + k8 * (t15 + T::from_f64(0.4) * t16);
                let t511 = t509
                    + t238
                        * (t163
                            + (t163 + T::from_f64(0.026689166666666667) * t238
                                + t239 * t13))
                    + t239 * (t510 + (t510 + t239 * t15 + t238 * t13));
                let t512 = T::from_f64(-1.0) / (t511 - (t508 - k87 * t5));
                let t513 = (t507 - k0) * t512;
                let t514 = sin_phi * t22 - cos_phi * t23;
                let t515 = cos_psi * t23 + t156;
                let t516 = k43 * cos_phi + t156 - t514 - t150;
                let t517 = t239 * t178 + t238 * t140 + t514 - t27 - t515;
                let t518 = k93 * cos_psi + t515 - t150;
                let t519 = sin_psi * t134;
                let t520 = t175 - t519 - t239 * t157 - t238 * t39;
                let t521 = t519 - k41 * sin_psi - t169 - t175;
                let t522 = t175 + t169;
                let t523 = sin_phi * (t116 + cos_psi * t115 - sin_psi * t118)
                    + cos_phi * (t123 + sin_psi * t120 + cos_psi * t124);
                let t524 = cos_psi * t122 + sin_psi * t127;
                let t525 = t58 + t239 * t523 + t193 - t185 - t238 * t524;
                let t526 = sin_phi * t64 - cos_phi * t65;
                let t527 = t526 + t416 - t427;
                let t528 = t66 - t239 * t216 - t238 * t112 - t526 - t428;
                let t529 = t38 * t517 + t53 * t520 + t63 * t525 - t76 * t528
                    - t94 * t240;
                let t530 = t96 * t529;
                let t531 = t229 * (t517 - t38 * t530) + t230 * (t520 - t53 * t530)
                    + t231 * (t525 - t63 * t530);
                let t532 = t531 + t232 * (t528 + t76 * t530)
                    - t233 * (t240 + t94 * t530);
                let t533 = t237 * t532;
                let t534 = t530 - t228 * t533;
                let t535 = qd_theta * t534;
                let t536 = qd_theta * t533;
                let t537 = t244 * t535;
                let t538 = k43 * t252;
                let t539 = k45 * t252;
                let t540 = sin_phi * t535;
                let t541 = t249 * t535 + t241 * t540;
                let t542 = t538 + t133 * t265 + cos_phi * t539 + t134 * t250
                    + t22 * t541;
                let t543 = cos_psi * t536;
                let t544 = t254 * t536 + t242 * t543;
                let t545 = t542 + sin_phi * t314 + t453 * t178 + t452 * t140
                    + t544 * t158;
                let t546 = t239 * t516 + t238 * t131 - t178;
                let t547 = t140 - t239 * t131 - t238 * t518;
                let t548 = cos_phi * t535;
                let t549 = t256 * t535 + t241 * t548;
                let t550 = t282 * t540 + t249 * t308;
                let t551 = t284 * t548 - t256 * t306;
                let t552 = t29 * t549 - t46 * t265 - t550 - t550 - t312
                    + (t551 + t551 - t44 * t250 - t31 * t541 - t313);
                let t553 = k43 * t259;
                let t554 = t286 * t540 + t249 * t553;
                let t555 = t552 + t539 + k84 * t549
                    - (t27 * t549 - t132 * t265 - t554 - t554 - cos_phi * t538);
                let t556 = t132 * t249;
                let t557 = k44 * t259;
                let t558 = t257 * t548 + t256 * t557;
                let t559 = sin_phi * t252;
                let t560 = t263 * t540 - t249 * t316;
                let t561 = t558 + t558 + t25 * t541 - t138 * t250 - k44 * t559
                    - (t324 + t560 + t560 + t42 * t265 + t33 * t549);
                let t562 = t138 * t256;
                let t563 = t268 * t548 + t256 * t320;
                let t564 = t561 - (t563 + t563 + t35 * t541 - t48 * t250 - t325)
                    - k46 * t541;
                let t565 = t45 + t47;
                let t566 = sin_psi * t536;
                let t567 = t273 * t536 + t242 * t566;
                let t568 = t545 + cos_psi * t555 + sin_psi * t564 + t255 * (t136 - t565)
                    + t567 * t159;
                let t569 = k45 * t259;
                let t570 = k45 * t273;
                let t571 = k46 * t254;
                let t572 = t276 * t566 + t273 * t569 + (t277 * t566 + t540 * t570)
                    - (t278 * t548 - t256 * t327 - (t279 * t543 + t548 * t571));
                let t573 = k16 * t273;
                let t574 = t280 * t566 + t540 * t573
                    + (t281 * t543 + t254 * (t25 * t548 - t562 - sin_phi * t557));
                let t575 = cos_phi * t308;
                let t576 = t46 * t249;
                let t577 = t44 * t256;
                let t578 = sin_phi * t306;
                let t579 = t283 * t566 + t273 * (t575 + t29 * t540 - t576)
                    + (t285 * t566 + t273 * (t577 + t31 * t548 - t578));
                let t580 = cos_phi * t316;
                let t581 = t42 * t249;
                let t582 = t287 * t566 + t273 * (cos_phi * t553 + t27 * t540 - t556)
                    + (t288 * t543 - t254 * (t580 + t581 + t33 * t540));
                let t583 = t48 * t256;
                let t584 = sin_phi * t320;
                let t585 = t289 * t543 + t254 * (t35 * t548 - t583 - t584)
                    + (t276 * t540 + t249 * t569);
                let t586 = t572 - (t574 + t579 - (t582 + t585));
                let t587 = t43 - t49;
                let t588 = t568 + t586 + t586 - t274 * (t139 + t587) - t549 * t24;
                let t589 = t306 * t540 + t249 * t284;
                let t590 = t308 * t548 - t256 * t282;
                let t591 = t253 + (t44 * t549 - t31 * t265 - t589 - t589 - t303)
                    + (t590 + t590 - t29 * t250 - t46 * t541 - t304);
                let t592 = t316 * t548 + t256 * t263;
                let t593 = t320 * t540 - t249 * t268;
                let t594 = t592 + t592 + t42 * t541 - t33 * t250 - t267
                    + (t272 + t593 + t593 + t35 * t265 + t48 * t549);
                let t595 = t567 * t174 + sin_psi * (t591 + k92 * t549)
                    + cos_psi * (t594 + k10 * t541);
                let t596 = t30 + t32;
                let t597 = t254 * t540;
                let t598 = cos_phi * t284;
                let t599 = t31 * t249;
                let t600 = t29 * t256;
                let t601 = sin_phi * t282;
                let t602 = t328 * t543 + t254 * (t598 + t44 * t540 - t599)
                    + (t329 * t543 + t254 * (t600 + t46 * t548 - t601));
                let t603 = t326 * t543 + k7 * t597 - (t327 * t543 + t254 * t278) + t602;
                let t604 = t33 * t256;
                let t605 = sin_phi * t263;
                let t606 = cos_phi * t268;
                let t607 = t35 * t249;
                let t608 = t330 * t566 + t273 * (t42 * t548 - t604 - t605)
                    + (t331 * t566 - t273 * (t606 + t607 + t48 * t540));
                let t609 = k10 * t273;
                let t610 = t608
                    - (t332 * t543 + k42 * t597 - (t333 * t566 + t548 * t609));
                let t611 = t603 + t610;
                let t612 = t595 + t274 * (t22 - t596) + t544 * t176 + t611 + t611
                    - t453 * t157;
                let t613 = t34 - t36;
                let t614 = t612 - t452 * t39 - t255 * t613;
                let t615 = k18 * t260;
                let t616 = cos_phi * t260;
                let t617 = t615 + k28 * t616 + t116 * t265 + t62 * t549 + t453 * t523;
                let t618 = t432 + k32 * t616 + t99 * t265 + t92 * t549 + t453 * t226;
                let t619 = cos_phi * t432;
                let t620 = t226 - t239 * t210 - t238 * t114;
                let t621 = k34 * t259;
                let t622 = t342 * t540 + t249 * t621;
                let t623 = cos_phi * t252;
                let t624 = t252 - t549;
                let t625 = k25 * t251;
                let t626 = t344 * t548 - t256 * t625;
                let t627 = sin_phi * t260;
                let t628 = t54 * t549 - t118 * t265 - t622 - t622 - k34 * t623
                    + (t626 + t626 - t120 * t250 - t55 * t541 - k25 * t627);
                let t629 = t617 + t567 * t184
                    + sin_psi * (t628 + k40 * t549 + k37 * t624);
                let t630 = t118 * t249;
                let t631 = t120 * t256;
                let t632 = t365 * t543 + t254 * (cos_phi * t621 + t54 * t540 - t630)
                    + (t366 * t543 + t254 * (t631 + t55 * t548 - sin_phi * t625));
                let t633 = k36 * t259;
                let t634 = t349 * t548 + t256 * t633;
                let t635 = k18 * t251;
                let t636 = t352 * t540 - t249 * t635;
                let t637 = t634 + t634 + t57 * t541 - t124 * t250 - k36 * t559
                    + (cos_phi * t615 + t636 + t636 + t115 * t265 + t58 * t549);
                let t638 = t629 + cos_psi * (t637 + k39 * t541) + t274 * t122
                    + t544 * t191;
                let t639 = t124 * t256;
                let t640 = t115 * t249;
                let t641 = t256 * t259;
                let t642 = t357 * t548 + k35 * t641
                    + (t358 * t566 + t273 * (t57 * t548 - t639 - sin_phi * t633));
                let t643 = t249 * t251;
                let t644 = t359 * t540 - k28 * t643
                    + (t360 * t566 - t273 * (cos_phi * t635 + t640 + t58 * t540));
                let t645 = k39 * t273;
                let t646 = t254 * t259;
                let t647 = t363 * t543 + k40 * t597 - (t364 * t543 + k37 * t646) + t632;
                let t648 = t361 * t543 + k37 * t597 - (t362 * t566 + t548 * t645) - t647;
                let t649 = t642 + t644 - t648;
                let t650 = t638 + t541 * t61 + t649 + t649 - t123 * t250 - k35 * t559;
                let t651 = t650 - t452 * t524 - t255 * t127;
                let t652 = t388 * t548 - t256 * t417;
                let t653 = t386 * t540 + t249 * t419;
                let t654 = t652 + t652 - t66 * t250 - t88 * t541 - t425
                    + (t86 * t549 - t69 * t265 - t653 - t653 - t423);
                let t655 = k30 * t251;
                let t656 = t390 * t548 - t256 * t655;
                let t657 = t654 + k26 * t624
                    - (t656 + t656 - t102 * t250 - t78 * t541 - k30 * t627);
                let t658 = t102 * t256;
                let t659 = k31 * t259;
                let t660 = t395 * t540 + t249 * t659;
                let t661 = t657 - (t77 * t549 - t100 * t265 - t660 - t660 - k31 * t623);
                let t662 = t100 * t249;
                let t663 = t70 + t67;
                let t664 = t618 + t452 * t106 + t567 * t213 + sin_psi * t661
                    + t274 * (t105 - t663);
                let t665 = t106 - t239 * t114 - t238 * t211;
                let t666 = t376 * t548 + t256 * t434;
                let t667 = t374 * t540 - t249 * t430;
                let t668 = t666 + t666 + t82 * t541 - t71 * t250 - t438
                    + (t619 + t667 + t667 + t73 * t265 + t84 * t549);
                let t669 = t664 + cos_psi * (t668 - k19 * t541) + t544 * t214
                    + t541 * t81;
                let t670 = t71 * t256;
                let t671 = sin_phi * t434;
                let t672 = t382 * t548 + k33 * t641
                    + (t383 * t566 + t273 * (t82 * t548 - t670 - t671));
                let t673 = cos_phi * t430;
                let t674 = t73 * t249;
                let t675 = t384 * t540 - k32 * t643
                    + (t385 * t566 - t273 * (t673 + t674 + t84 * t540));
                let t676 = cos_phi * t419;
                let t677 = t69 * t249;
                let t678 = t66 * t256;
                let t679 = sin_phi * t417;
                let t680 = t389 * t543 + t254 * (t678 + t88 * t548 - t679)
                    - (t391 * t543 + t254 * (t658 + t78 * t548 - sin_phi * t655));
                let t681 = k19 * t273;
                let t682 = t394 * t566 + t548 * t681
                    + (t396 * t543 + t254 * (cos_phi * t659 + t77 * t540 - t662));
                let t683 = t392 * t543 + k26 * t646 + (t393 * t543 + k26 * t597) + t682;
                let t684 = t387 * t543 + t254 * (t676 + t86 * t540 - t677) + t680 - t683;
                let t685 = t672 + t675 + t684;
                let t686 = t72 - t74;
                let t687 = t669 + t685 + t685 - t97 * t250 - k33 * t559 - t255 * t686;
                let t688 = t434 * t540 - t249 * t376;
                let t689 = k19 * t260 - (t380 + t688 + t688 + t82 * t265 + t71 * t549);
                let t690 = t430 * t548 + t256 * t374;
                let t691 = sin_psi
                    * (t689 - (t690 + t690 + t73 * t541 - t84 * t250 - t381));
                let t692 = t83 - t85;
                let t693 = t249 * t388 + t417 * t540;
                let t694 = cos_phi * t407;
                let t695 = t419 * t548 - t256 * t386;
                let t696 = t66 * t549 - t88 * t265 - t693 - t693 - t694
                    + (t695 + t695 - t86 * t250 - t69 * t541 - t405);
                let t697 = t65 * t549 + t691 + t274 * (t111 - t692) + t567 * t415
                    + cos_psi * t696;
                let t698 = t697 + t544 * t426 - t407 - t108 * t250 - t64 * t541
                    - k22 * t627;
                let t699 = t698 - t109 * t265 - T::from_f64(0.8) * t623 - t453 * t216
                    - t452 * t112;
                let t700 = t216 + t239 * t527 + t238 * t98;
                let t701 = t112 + t239 * t98 + t238 * t428;
                let t702 = t87 + t89;
                let t703 = T::from_f64(0.8) * t259;
                let t704 = cos_phi * t388;
                let t705 = t88 * t249;
                let t706 = t440 * t566 + t273 * (t704 + t66 * t540 - t705)
                    + (t441 * t543 - k19 * t254 * t251);
                let t707 = cos_phi * t376;
                let t708 = t82 * t249;
                let t709 = t84 * t256;
                let t710 = sin_phi * t374;
                let t711 = t442 * t543 - t254 * (t707 + t708 + t71 * t540)
                    + (t443 * t543 + t254 * (t73 * t548 - t709 - t710));
                let t712 = t86 * t256;
                let t713 = sin_phi * t386;
                let t714 = t444 * t548 - k22 * t256 * t251
                    - (t445 * t566 + t273 * (t712 + t69 * t548 - t713));
                let t715 = t439 * t540 + t249 * t703 + t706 - (t711 + t714);
                let t716 = t699 - t255 * t702 - t715 - t715;
                let t717 = T::from_f64(2.0) * t251;
                let t718 = t38 * t588 + t53 * t614 + t63 * t651 + t94 * t687
                    - t76 * t716;
                let t719 = t96 * t718;
                let t720 = t229 * (t588 - t38 * t719) + t230 * (t614 - t53 * t719)
                    + t231 * (t651 - t63 * t719);
                let t721 = t720 + t232 * (t716 + t76 * t719)
                    + t233 * (t687 - t94 * t719);
                let t722 = t237 * t721;
                let t723 = t719 + t513 * t534 - t228 * t722;
                let t724 = t245 * t535;
                let t725 = t722 + t513 * t533 + k2 * t724 + k3 * t723;
                let t726 = k2 * t723 - k3 * t724;
                let t727 = t536 + k3 * t535;
                let t728 = t536 + t727;
                let t729 = k2 * t535;
                let t730 = cos_psi * t729;
                let t731 = sin_psi * t729;
                let t732 = t242 + t459;
                let t733 = T::from_f64(2.0) * t459;
                let t734 = T::from_f64(1.125e-5)
                    * (cos_psi * t537 + sin_psi * t726 + t457 * t728 + t730 * t732);
                let t735 = sin_psi * t537 + t458 * t728 + t731 * t732 - cos_psi * t726;
                let t736 = t457 * t731 + t458 * t730;
                let t737 = k7 * t467;
                let t738 = t737 + T::from_f64(1.6) * t724;
                let t739 = k8 * t467;
                let t740 = cos_phi * t739 + t243 * sin_phi;
                let t741 = T::from_f64(0.8) * t723 - t740;
                let t742 = k85 * t738 - k86 * t741
                    + T::from_f64(0.026677916666666666) * t735;
                let t743 = T::from_f64(0.1) * t735;
                let t744 = T::from_f64(2.0) * t247;
                let t745 = t535 * t744;
                let t746 = cos_psi * (k2 * t738 + k3 * t741)
                    - sin_psi
                        * (t243 * cos_phi - sin_phi * t739 - T::from_f64(0.8) * t745);
                let t747 = sin_phi
                    * (k94 * t537 + cos_psi * t734 + sin_psi * t742 - k47 * t745);
                let t748 = sin_psi * t734 - cos_psi * t742;
                let t749 = t243 + T::from_f64(0.4) * t513;
                let t750 = t736 + t725;
                let t751 = T::from_f64(0.1) * t746
                    + T::from_f64(0.026677916666666666) * t750
                    - T::from_f64(1.125e-5) * (t736 - t725);
                let t752 = T::from_f64(0.1) * t750;
                let t753 = T::from_f64(2.0) * t457;
                let t754 = T::from_f64(0.1) * (t730 * t753 + t727 * t733);
                let t755 = cos_psi * t752 - sin_psi * t754;
                let t756 = k2 * t755 + k3 * t743;
                let t757 = k3 * t755 - k2 * t743;
                let t758 = cos_phi * (t757 + T::from_f64(0.96) * t723)
                    - sin_phi
                        * (T::from_f64(0.96) * t745 + cos_psi * t754 + sin_psi * t752);
                let t759 = k2 * t748 + k3 * t751 + T::from_f64(0.8) * t757 + k95 * t723
                    - T::from_f64(0.96) * t740;
                let t760 = k3 * t748 + k47 * t723 - k2 * t751 - T::from_f64(0.8) * t756
                    - T::from_f64(0.96) * t737;
                let t761 = k7
                    * (t747 + cos_phi * (t760 - T::from_f64(1.3226891666666667) * t724))
                    + (k24 * t758 - k40 * (t756 + T::from_f64(1.92) * t724));
                let t762 = k50 + k8 * t749;
                let t763 = cos_phi * t762 - t469;
                let t764 = t470 + sin_phi * t762;
                let t765 = k51 - k7 * t749;
                (
                    t512,
                    t513,
                    t516,
                    t518,
                    t521,
                    t522,
                    t523,
                    t524,
                    t527,
                    t533,
                    t534,
                    t535,
                    t536,
                    t546,
                    t547,
                    t556,
                    t562,
                    t565,
                    t570,
                    t571,
                    t573,
                    t575,
                    t576,
                    t577,
                    t578,
                    t580,
                    t581,
                    t583,
                    t584,
                    t587,
                    t596,
                    t598,
                    t599,
                    t600,
                    t601,
                    t604,
                    t605,
                    t606,
                    t607,
                    t609,
                    t613,
                    t619,
                    t620,
                    t630,
                    t631,
                    t639,
                    t640,
                    t645,
                    t658,
                    t662,
                    t663,
                    t665,
                    t670,
                    t671,
                    t673,
                    t674,
                    t676,
                    t677,
                    t678,
                    t679,
                    t681,
                    t686,
                    t692,
                    t694,
                    t700,
                    t701,
                    t702,
                    t703,
                    t704,
                    t705,
                    t707,
                    t708,
                    t709,
                    t710,
                    t712,
                    t713,
                    t717,
                    t732,
                    t733,
                    t744,
                    t751,
                    t753,
                    t759,
                    t761,
                    t763,
                    t764,
                    t765,
                )
            };
            let (
                t766,
                t775,
                t777,
                t783,
                t785,
                t786,
                t789,
                t791,
                t794,
                t796,
                t797,
                t798,
                t811,
                t812,
                t932,
                t940,
                t953,
                t958,
                t959,
                t960,
                t961,
                t962,
                t963,
                t964,
                t965,
                t968,
                t976,
                t977,
                t979,
                t980,
                t981,
                t982,
                t984,
                t986,
                t990,
                t1001,
                t1014,
                t1017,
                t1021,
            ) = {
                let t766 = t764 - t488;
                let t767 = t453 + t513 * t506;
                let t768 = t472 + t767;
                let t769 = t472 - t767;
                let t770 = k7 * t513;
                let t771 = t454 - cos_phi * t770;
                let t772 = t246 + sin_phi * t770;
                let t773 = k2 * t767 - k3 * t771;
                let t774 = t452 + t238 * t513 + k3 * t767 + k2 * t771;
                let t775 = cos_psi * t772 + sin_psi * t773;
                let t776 = T::from_f64(1.125e-5) * (t460 + t775);
                let t777 = cos_psi * t773 - sin_psi * t772;
                let t778 = t475 - t777;
                let t779 = t463 + t771;
                let t780 = t765 + T::from_f64(0.8) * t779;
                let t781 = t763 + T::from_f64(0.8) * t768;
                let t782 = k85 * t780 - k86 * t781
                    + T::from_f64(0.026677916666666666) * t778;
                let t783 = k3 * t781 + k2 * t780;
                let t784 = T::from_f64(0.1) * t778;
                let t785 = sin_psi * t776 - cos_psi * t782;
                let t786 = cos_psi * t776 + sin_psi * t782;
                let t787 = T::from_f64(0.96) * t763
                    + T::from_f64(0.6613445833333333) * t768 + k47 * (t463 - t771)
                    + k2 * t785;
                let t788 = t491 + t774;
                let t789 = T::from_f64(0.1) * (cos_psi * t783 - sin_psi * t766)
                    + T::from_f64(0.026677916666666666) * t788
                    - T::from_f64(1.125e-5) * (t491 - t774);
                let t790 = T::from_f64(0.1) * t788;
                let t791 = t496 - cos_psi * t790;
                let t792 = k3 * t785 - k2 * t789 - (k32 * t784 - k28 * t791)
                    - T::from_f64(0.96) * t765;
                let t793 = k3 * t791 + k2 * t784;
                let t794 = t787 + k3 * t789 - k48 * t769 - T::from_f64(0.8) * t793;
                let t795 = t761 + t534 * t794 + t533 * t789 + t238 * t751 + t759 * t506;
                let t796 = t512 * (t795 - T::from_f64(0.86) * t467);
                let t797 = sin_psi * t790;
                let t798 = cos_psi * t51;
                let t799 = cos_psi * t40 + t137 - sin_psi * t41 - t798;
                let t800 = t239 * t522 - t157 - t238 * t799;
                let t801 = t239 * t799 + t238 * t521 + t39;
                let t802 = cos_psi * t56 - sin_psi * t59;
                let t803 = t523 + t239 * t195 - t238 * t802;
                let t804 = t524 + t239 * t802 + t238 * t194;
                let t805 = t53 * t800 + t63 * t803 + t94 * t620 + t76 * t700
                    - t38 * t546;
                let t806 = t96 * t805;
                let t807 = t230 * (t800 - t53 * t806) + t231 * (t803 - t63 * t806)
                    + t233 * (t620 - t94 * t806);
                let t808 = t807 - t232 * (t700 - t76 * t806)
                    - t229 * (t546 + t38 * t806);
                let t809 = t237 * t808;
                let t810 = t806 - t228 * t809;
                let t811 = qd_theta * t810;
                let t812 = qd_theta * t809;
                let t813 = t244 * t811;
                let t814 = t813 - t771;
                let t815 = t256 + sin_phi * t811;
                let t816 = t249 * t811 + t241 * t815;
                let t817 = cos_psi * t812;
                let t818 = t254 * t812 + t242 * t817;
                let t819 = cos_phi * t811 - t249;
                let t820 = t328 * t817 + t254 * (t44 * t815 - t578)
                    + (t329 * t817 + t254 * (t575 + t46 * t819));
                let t821 = t442 * t817 - t254 * (t671 + t71 * t815)
                    + (t443 * t817 + t254 * (t73 * t819 - t673));
                let t822 = t389 * t817 + t254 * (t704 + t88 * t819)
                    - (t391 * t817 + t254 * (cos_phi * t390 + t78 * t819));
                let t823 = t256 * t811 + t241 * t819;
                let t824 = t282 * t815;
                let t825 = t284 * t819;
                let t826 = t29 * t823 - t304 - t824 - t824
                    + (t825 + t825 - t303 - t31 * t816);
                let t827 = t286 * t815;
                let t828 = t826 + k84 * t823
                    - (t27 * t823 - t827 - t827 - sin_phi * t292);
                let t829 = sin_phi * t293 + t22 * t816 + cos_phi * t253 + t818 * t158
                    + cos_psi * t828;
                let t830 = t257 * t819;
                let t831 = t263 * t815;
                let t832 = t830 + t830 + t25 * t816 + cos_phi * t261
                    - (t831 + t831 + t33 * t823 - t267);
                let t833 = t268 * t819;
                let t834 = sin_psi
                    * (t832 - (t272 + t833 + t833 + t35 * t816) - k46 * t816);
                let t835 = sin_psi * t812;
                let t836 = t283 * t835 + t273 * (t29 * t815 - t601)
                    + (t285 * t835 + t273 * (t598 + t31 * t819));
                let t837 = t330 * t835 + t273 * (t42 * t819 - t580)
                    + (t331 * t835 - t273 * (t584 + t48 * t815));
                let t838 = t382 * t819 + (t383 * t835 + t273 * (t82 * t819 - t707))
                    + (t384 * t815 + (t385 * t835 - t273 * (t710 + t84 * t815)));
                let t839 = t821
                    + (t444 * t819 - (t445 * t835 + t273 * (t676 + t69 * t819)));
                let t840 = t287 * t835 + t273 * (t27 * t815 - sin_phi * t286)
                    + (t288 * t817 - t254 * (t605 + t33 * t815));
                let t841 = t840
                    + (t289 * t817 + t254 * (t35 * t819 - t606) + t276 * t815);
                let t842 = t439 * t815
                    + (t440 * t835 + t273 * (t66 * t815 - t679) + t441 * t817);
                let t843 = t842 - t839;
                let t844 = t273 * t812 + t242 * t835;
                let t845 = t276 * t835 + (t277 * t835 + t815 * t570)
                    - (t278 * t819 - (t279 * t817 + t819 * t571));
                let t846 = t280 * t835 + t815 * t573
                    + (t281 * t817 + t254 * (t25 * t819 - cos_phi * t257));
                let t847 = t845 - (t846 + t836 - t841);
                let t848 = t829 + t834 + t274 * (t26 + t613) + t844 * t159 + t847 + t847;
                let t849 = t848 - t453 * t516 - t452 * t131 - t255 * (t28 + t596)
                    - t823 * t24;
                let t850 = t306 * t815;
                let t851 = t308 * t819;
                let t852 = t44 * t823 - t313 - t850 - t850
                    + (t851 + t851 - t312 - t46 * t816);
                let t853 = t453 * t522 + t844 * t174 + sin_psi * (t852 + k92 * t823)
                    + t274 * (t40 - t51 - t565);
                let t854 = t316 * t819;
                let t855 = t320 * t815;
                let t856 = t324 + t854 + t854 + t42 * t816
                    + (t855 + t855 + t48 * t823 - t325);
                let t857 = t853 + cos_psi * (t856 + k10 * t816) + t255 * (t41 + t587)
                    + t818 * t176;
                let t858 = t254 * t815;
                let t859 = t837
                    - (t332 * t817 + k42 * t858 - (t333 * t835 + t819 * t609));
                let t860 = t326 * t817 + k7 * t858 - t327 * t817 + t820 + t859;
                let t861 = t857 + t860 + t860 - t452 * t799;
                let t862 = t342 * t815;
                let t863 = t344 * t819;
                let t864 = t54 * t823 - t862 - t862 - sin_phi * t341
                    + (t863 + t863 - t55 * t816 - cos_phi * t346);
                let t865 = cos_phi * t338 + t62 * t823 + t453 * t195 + t844 * t184
                    + sin_psi * (t864 + k89 * t823);
                let t866 = t349 * t819;
                let t867 = t352 * t815;
                let t868 = t866 + t866 + t57 * t816 + cos_phi * t351
                    + (t867 + t867 + t58 * t823 - sin_phi * t337);
                let t869 = t865 + t274 * t56 + cos_psi * (t868 + k39 * t816)
                    + t255 * t59;
                let t870 = t357 * t819
                    + (t358 * t835 + t273 * (t57 * t819 - cos_phi * t349));
                let t871 = t359 * t815
                    + (t360 * t835 - t273 * (sin_phi * t352 + t58 * t815));
                let t872 = t365 * t817 + t254 * (t54 * t815 - sin_phi * t342)
                    + (t366 * t817 + t254 * (cos_phi * t344 + t55 * t819));
                let t873 = t361 * t817 + k37 * t858 - (t362 * t835 + t819 * t645)
                    - (t363 * t817 + k40 * t858 - t364 * t817 + t872);
                let t874 = t870 + t871 - t873;
                let t875 = t869 + t818 * t191 + t816 * t61 + t874 + t874
                    - sin_phi * t339;
                let t876 = t875 - t452 * t802;
                let t877 = t394 * t835 + t819 * t681
                    + (t396 * t817 + t254 * (t77 * t815 - sin_phi * t395));
                let t878 = t387 * t817 + t254 * (t86 * t815 - t713) + t822
                    - (t392 * t817 + (t393 * t817 + k26 * t858) + t877);
                let t879 = t838 + t878;
                let t880 = t388 * t819;
                let t881 = t386 * t815;
                let t882 = t880 + t880 - t694 - t88 * t816
                    + (t86 * t823 - t405 - t881 - t881);
                let t883 = t390 * t819;
                let t884 = t395 * t815;
                let t885 = t882 - (t883 + t883 - t78 * t816 - cos_phi * t409)
                    - (t77 * t823 - t884 - t884 - sin_phi * t400);
                let t886 = cos_phi * t370 + t92 * t823 + t844 * t213
                    + sin_psi * (t885 - k26 * t823);
                let t887 = t376 * t819;
                let t888 = t374 * t815;
                let t889 = t380 + t887 + t887 + t82 * t816
                    + (t888 + t888 + t84 * t823 - t381);
                let t890 = t886 + t274 * (t79 - t702) + cos_psi * (t889 - k19 * t816)
                    + t255 * (t692 - t91);
                let t891 = t890 + t818 * t214 + t816 * t81 + t879 + t879
                    - sin_phi * t372;
                let t892 = t891 - t453 * t210 - t452 * t114;
                let t893 = t417 * t815;
                let t894 = t434 * t815;
                let t895 = t419 * t819;
                let t896 = t66 * t823 - t425 - t893 - t893
                    + (t895 + t895 - t423 - t69 * t816);
                let t897 = t65 * t823 + t844 * t415 + cos_psi * t896 + t274 * t686
                    + t818 * t426;
                let t898 = t897 - t64 * t816 - cos_phi * t429 - sin_phi * t414
                    - t453 * t527;
                let t899 = t430 * t819;
                let t900 = t894 + t894 + t71 * t823 - t438
                    + (t619 + t899 + t899 + t73 * t816);
                let t901 = t898 - t452 * t98 - sin_psi * t900 - t255 * t663 - t843
                    - t843;
                let t902 = t38 * t849 + t53 * t861 + t63 * t876 + t94 * t892
                    - t76 * t901;
                let t903 = t96 * t902;
                let t904 = t229 * (t849 - t38 * t903) + t230 * (t861 - t53 * t903)
                    + t231 * (t876 - t63 * t903);
                let t905 = t904 + t232 * (t901 + t76 * t903)
                    + t233 * (t892 - t94 * t903);
                let t906 = t237 * t905;
                let t907 = t903 + t513 * t810 - t228 * t906;
                let t908 = t245 * t811;
                let t909 = t772 + t908;
                let t910 = t248 + t908;
                let t911 = t906 + t513 * t809 + k3 * t907 + k2 * t909;
                let t912 = k2 * t907 - k3 * t909;
                let t913 = t812 + k2 * t245 + k3 * t811;
                let t914 = t812 + t913;
                let t915 = k2 * t811 - k3 * t245;
                let t916 = t744 * t811;
                let t917 = cos_psi * t915 - sin_psi * t244;
                let t918 = cos_psi * t244 + sin_psi * t915;
                let t919 = T::from_f64(0.1) * (t753 * t917 + t733 * t913);
                let t920 = T::from_f64(1.125e-5)
                    * (cos_psi * t814 + sin_psi * t912 + t457 * t914 + t917 * t732);
                let t921 = sin_psi * t814 + t458 * t914 + t918 * t732 - cos_psi * t912;
                let t922 = t457 * t918 + t458 * t917;
                let t923 = t909 + t910;
                let t924 = T::from_f64(0.8) * t923;
                let t925 = t907 - t482;
                let t926 = t907 + t482;
                let t927 = T::from_f64(0.8) * t925 - t764;
                let t928 = k85 * t924 - k86 * t927
                    + T::from_f64(0.026677916666666666) * t921;
                let t929 = T::from_f64(0.1) * t921;
                let t930 = T::from_f64(2.0) * t245;
                let t931 = t244 * t930;
                let t932 = t51 * t930;
                let t933 = T::from_f64(2.0) * t244;
                let t934 = t245 * t933;
                let t935 = k48 * (t813 + t814 - t463) + cos_psi * t920 + sin_psi * t928
                    - k47 * (t931 + t916 + t934 - t931);
                let t936 = sin_psi * t920 - cos_psi * t928;
                let t937 = t916 - t934;
                let t938 = cos_psi * (k3 * t927 + k2 * t924)
                    - sin_psi * (t763 - T::from_f64(0.8) * t937);
                let t939 = T::from_f64(0.6613445833333333) * t925 + k48 * t926
                    + k47 * (t910 - t909) + k2 * t936;
                let t940 = t162 * t933;
                let t941 = t922 + t911;
                let t942 = T::from_f64(0.1) * t938
                    + T::from_f64(0.026677916666666666) * t941
                    - T::from_f64(1.125e-5) * (t922 - t911);
                let t943 = T::from_f64(0.1) * t941;
                let t944 = T::from_f64(0.96) * t768 - t793
                    + (T::from_f64(0.96) * t937 + cos_psi * t919 + sin_psi * t943);
                let t945 = cos_psi * t943 - sin_psi * t919;
                let t946 = k2 * t945 + k3 * t929;
                let t947 = k3 * t936 + k47 * t926 - k2 * t942 - T::from_f64(0.8) * t946
                    - T::from_f64(0.6613445833333333) * t923;
                let t948 = sin_phi
                    * (t935
                        - (t792 - k47 * t769 - T::from_f64(0.6613445833333333) * t779))
                    + cos_phi * (k48 * (t248 + t772) + t786 - t483 + t947);
                let t949 = k3 * t945 - k2 * t929;
                let t950 = k24
                    * (cos_phi * (t949 + T::from_f64(0.96) * t925 - (t797 + t498))
                        - sin_phi * t944);
                let t951 = k7 * t948 + (t950 - k40 * (t946 + T::from_f64(0.96) * t923))
                    + t794 * t810;
                let t952 = t951 + t789 * t809 + t238 * t942
                    + (t939 + k3 * t942 + T::from_f64(0.8) * t949
                        - T::from_f64(0.96) * t764) * t506;
                let t953 = t512 * t952;
                let t954 = t38 * t547 + t94 * t665 + t76 * t701 - t53 * t801
                    - t63 * t804;
                let t955 = t96 * t954;
                let t956 = t229 * (t547 - t38 * t955) + t233 * (t665 - t94 * t955)
                    - t230 * (t801 + t53 * t955);
                let t957 = t956 - t232 * (t701 - t76 * t955)
                    - t231 * (t804 + t63 * t955);
                let t958 = t237 * t957;
                let t959 = t955 - t228 * t958;
                let t960 = qd_theta * t959;
                let t961 = qd_theta * t958;
                let t962 = t244 * t960;
                let t963 = sin_phi * t960;
                let t964 = t249 * t960 + t241 * t963;
                let t965 = cos_phi * t960;
                let t966 = t257 * t965;
                let t967 = t263 * t963;
                let t968 = t256 * t960 + t241 * t965;
                let t969 = t966 + t966 + t25 * t964 + t301 - (t967 + t967 + t33 * t968);
                let t970 = t268 * t965;
                let t971 = t22 * t964
                    + sin_psi * (t969 - (t970 + t970 + t35 * t964) - k46 * t964);
                let t972 = t282 * t963;
                let t973 = t284 * t965;
                let t974 = t29 * t968 - t972 - t972 + (t973 + t973 - t31 * t964)
                    + k84 * t968;
                let t975 = t286 * t963;
                let t976 = cos_psi * t961 - t273;
                let t977 = t254 * t961 + t242 * t976;
                let t978 = t971 + cos_psi * (t974 + t271 - (t27 * t968 - t975 - t975))
                    + t977 * t158;
                let t979 = t254 + sin_psi * t961;
                let t980 = t273 * t961 + t242 * t979;
                let t981 = t273 * t963;
                let t982 = t254 * t965;
                let t983 = t276 * t979 + (t277 * t979 + k45 * t981)
                    - (t278 * t965 - (t279 * t976 + k46 * t982));
                let t984 = t273 * t965;
                let t985 = t280 * t979 + k16 * t981 + (t281 * t976 + t25 * t982)
                    + (t283 * t979 + t29 * t981 + (t285 * t979 + t31 * t984));
                let t986 = t254 * t963;
                let t987 = t287 * t979 + t27 * t981 + (t288 * t976 - t33 * t986)
                    + (t289 * t976 + t35 * t982 + t276 * t963);
                let t988 = t983 - (t985 - t987);
                let t989 = t978 + t980 * t159 + t988 + t988 - t453 * t131 - t452 * t518;
                let t990 = t989 - t968 * t24;
                let t991 = t316 * t965;
                let t992 = t320 * t963;
                let t993 = t991 + t991 + t42 * t964 + (t992 + t992 + t48 * t968)
                    + k10 * t964;
                let t994 = t306 * t963;
                let t995 = t308 * t965;
                let t996 = t44 * t968 - t994 - t994 + (t995 + t995 - t46 * t964)
                    + k92 * t968;
                let t997 = cos_psi * (t993 + t315) + sin_psi * (t996 - t323)
                    + t980 * t174 + t977 * t176;
                let t998 = t326 * t976 + k7 * t986 - t327 * t976
                    + (t328 * t976 + t44 * t986 + (t329 * t976 + t46 * t982));
                let t999 = t330 * t979 + t42 * t984 + (t331 * t979 - t48 * t981)
                    - (t332 * t976 + k42 * t986 - (t333 * t979 + k10 * t984));
                let t1000 = t998 + t999;
                let t1001 = t997 + t1000 + t1000 - t453 * t799 - t452 * t521;
                let t1002 = t349 * t965;
                let t1003 = t352 * t963;
                let t1004 = t1002 + t1002 + t57 * t964 + (t1003 + t1003 + t58 * t968)
                    + k39 * t964;
                let t1005 = t342 * t963;
                let t1006 = t344 * t965;
                let t1007 = t54 * t968 - t1005 - t1005 + (t1006 + t1006 - t55 * t964)
                    + k89 * t968;
                let t1008 = t62 * t968 + cos_psi * (t1004 + t348)
                    + sin_psi * (t1007 - t355) + t980 * t184;
                let t1009 = t357 * t965 + (t358 * t979 + t57 * t984)
                    + (t359 * t963 + (t360 * t979 - t58 * t981));
                let t1010 = t363 * t976 + k40 * t986 - t364 * t976
                    + (t365 * t976 + t54 * t986 + (t366 * t976 + t55 * t982));
                let t1011 = t361 * t976 + k37 * t986 - (t362 * t979 + k39 * t984)
                    - t1010;
                let t1012 = t1009 - t1011;
                let t1013 = t1008 + t977 * t191 + t964 * t61 + t1012 + t1012
                    - t453 * t802;
                let t1014 = t1013 - t452 * t194;
                let t1015 = t376 * t965;
                let t1016 = t374 * t963;
                let t1017 = t1015 + t1015 + t82 * t964 + (t1016 + t1016 + t84 * t968)
                    - k19 * t964;
                let t1018 = t388 * t965;
                let t1019 = t386 * t963;
                let t1020 = t390 * t965;
                let t1021 = t1018 + t1018 - t88 * t964 + (t86 * t968 - t1019 - t1019)
                    - (t1020 + t1020 - t78 * t964);
                (
                    t766,
                    t775,
                    t777,
                    t783,
                    t785,
                    t786,
                    t789,
                    t791,
                    t794,
                    t796,
                    t797,
                    t798,
                    t811,
                    t812,
                    t932,
                    t940,
                    t953,
                    t958,
                    t959,
                    t960,
                    t961,
                    t962,
                    t963,
                    t964,
                    t965,
                    t968,
                    t976,
                    t977,
                    t979,
                    t980,
                    t981,
                    t982,
                    t984,
                    t986,
                    t990,
                    t1001,
                    t1014,
                    t1017,
                    t1021,
                )
            };
            let (t1078, t1221) = {
                let t1022 = t395 * t963;
                let t1023 = sin_psi
                    * (t1021 - (t77 * t968 - t1022 - t1022) - k26 * t968 - t379);
                let t1024 = t92 * t968 + cos_psi * (t1017 - t411) + t1023 + t980 * t213
                    + t977 * t214;
                let t1025 = t382 * t965 + (t383 * t979 + t82 * t984)
                    + (t384 * t963 + (t385 * t979 - t84 * t981));
                let t1026 = t387 * t976 + t86 * t986
                    + (t389 * t976 + t88 * t982 - (t391 * t976 + t78 * t982));
                let t1027 = t442 * t976 - t71 * t986 + (t443 * t976 + t73 * t982)
                    + (t444 * t965 - (t445 * t979 + t69 * t984));
                let t1028 = t392 * t976 + (t393 * t976 + k26 * t986)
                    + (t394 * t979 + k19 * t984 + (t396 * t976 + t77 * t986));
                let t1029 = t439 * t963 + (t440 * t979 + t66 * t981 + t441 * t976)
                    - t1027;
                let t1030 = t1025 + (t1026 - t1028);
                let t1031 = t1024 + t964 * t81 + t1030 + t1030 - t453 * t114
                    - t452 * t211;
                let t1032 = t417 * t963;
                let t1033 = t434 * t963;
                let t1034 = t419 * t965;
                let t1035 = t66 * t968 - t1032 - t1032 + (t1034 + t1034 - t69 * t964)
                    - t436;
                let t1036 = t65 * t968 + cos_psi * t1035 + t980 * t415 + t977 * t426
                    - t64 * t964;
                let t1037 = t430 * t965;
                let t1038 = t1033 + t1033 + t71 * t968 + (t1037 + t1037 + t73 * t964)
                    + t422;
                let t1039 = t1036 - t453 * t98 - t452 * t428 - sin_psi * t1038 - t1029
                    - t1029;
                let t1040 = t38 * t990 + t53 * t1001 + t63 * t1014 + t94 * t1031
                    - t76 * t1039;
                let t1041 = t96 * t1040;
                let t1042 = t229 * (t990 - t38 * t1041) + t230 * (t1001 - t53 * t1041)
                    + t231 * (t1014 - t63 * t1041);
                let t1043 = t1042 + t232 * (t1039 + t76 * t1041)
                    + t233 * (t1031 - t94 * t1041);
                let t1044 = t237 * t1043;
                let t1045 = t1041 + t513 * t959 - t228 * t1044;
                let t1046 = t245 * t960;
                let t1047 = t1044 + t513 * t958 + k2 * t1046 + k3 * t1045;
                let t1048 = k2 * t1045 - k3 * t1046;
                let t1049 = t961 + k3 * t960;
                let t1050 = t961 + t1049;
                let t1051 = k2 * t960;
                let t1052 = t744 * t960;
                let t1053 = t744 * t506;
                let t1054 = cos_psi * t1051 - t458;
                let t1055 = cos_psi * t962 + sin_psi * t1048 + t457 * t1050
                    + t1054 * t732 + t777;
                let t1056 = T::from_f64(1.125e-5) * t1055;
                let t1057 = t457 + sin_psi * t1051;
                let t1058 = sin_psi * t962 + t458 * t1050 + t1057 * t732 + t775
                    - cos_psi * t1048;
                let t1059 = t457 * t1057 + t458 * t1054;
                let t1060 = T::from_f64(0.1) * (t753 * t1054 + t733 * t1049);
                let t1061 = T::from_f64(1.6) * t1046;
                let t1062 = T::from_f64(0.8) * t1045;
                let t1063 = sin_psi * (T::from_f64(0.8) * t1052 - t783)
                    + cos_psi * (k2 * t1061 + k3 * t1062 - t766);
                let t1064 = k85 * t1061 - k86 * t1062
                    + T::from_f64(0.026677916666666666) * t1058;
                let t1065 = k94 * t962 + cos_psi * t1056 + sin_psi * t1064 - t785
                    - k47 * t1052;
                let t1066 = sin_psi * t1056 + t786 - cos_psi * t1064;
                let t1067 = T::from_f64(0.1) * t1058;
                let t1068 = t1059 + t1047;
                let t1069 = T::from_f64(0.1) * t1063
                    + T::from_f64(0.026677916666666666) * t1068
                    - T::from_f64(1.125e-5) * (t1059 - t1047);
                let t1070 = T::from_f64(0.1) * t1068;
                let t1071 = cos_psi * t1070 - t497 - t797 - sin_psi * t1060;
                let t1072 = k2 * t1071 + k3 * t1067;
                let t1073 = k3 * t1071 - k2 * t1067;
                let t1074 = cos_phi * (t1073 + T::from_f64(0.96) * t1045)
                    - sin_phi
                        * (T::from_f64(0.96) * t1052 + cos_psi * t1060 + sin_psi * t1070
                            - t791);
                let t1075 = (k2 * t1066 + k3 * t1069 + T::from_f64(0.8) * t1073
                    + k95 * t1045) * t506;
                let t1076 = k3 * t1066 + k47 * t1045 - k2 * t1069
                    - T::from_f64(0.8) * t1072 - T::from_f64(1.3226891666666667) * t1046;
                let t1077 = k7 * (sin_phi * t1065 + cos_phi * t1076)
                    + (k24 * t1074 - k40 * (t1072 + T::from_f64(1.92) * t1046));
                let t1078 = t512
                    * (t1077 + t794 * t959 + t789 * t958 + t238 * t1069 + t1075);
                let t1079 = t239 * t244 + t162 * t241;
                let t1080 = sin_phi * t239;
                let t1081 = t576 + t282 * t1080;
                let t1082 = t556 + t286 * t1080;
                let t1083 = t581 + t263 * t1080;
                let t1084 = t599 + t306 * t1080;
                let t1085 = t607 + t320 * t1080;
                let t1086 = t630 + t342 * t1080;
                let t1087 = t640 + t352 * t1080;
                let t1088 = t677 + t386 * t1080;
                let t1089 = t662 + t395 * t1080;
                let t1090 = t674 + t374 * t1080;
                let t1091 = t708 + t434 * t1080;
                let t1092 = t705 + t417 * t1080;
                let t1093 = t239 * t249 + t241 * t1080;
                let t1094 = sin_phi * t717;
                let t1095 = cos_psi * t238;
                let t1096 = t238 * t254 + t242 * t1095;
                let t1097 = cos_phi * t239;
                let t1098 = t328 * t1095 + t254 * (t32 + t44 * t1080)
                    + (t329 * t1095 + t254 * (t30 + t46 * t1097));
                let t1099 = t365 * t1095 + t254 * (t119 + t54 * t1080)
                    + (t366 * t1095 + t254 * (t121 + t55 * t1097));
                let t1100 = t389 * t1095 + t254 * (t67 + t88 * t1097)
                    - (t391 * t1095 + t254 * (t103 + t78 * t1097));
                let t1101 = t442 * t1095 + t254 * (t83 - t71 * t1080)
                    + (t443 * t1095 + t254 * (t73 * t1097 - t85));
                let t1102 = t577 + t284 * t1097;
                let t1103 = t562 + t257 * t1097;
                let t1104 = t583 + t268 * t1097;
                let t1105 = t289 * t1095 + t254 * (t35 * t1097 - t49)
                    + (t276 * t1080 + t133 * t249);
                let t1106 = t600 + t308 * t1097;
                let t1107 = t604 + t316 * t1097;
                let t1108 = t631 + t344 * t1097;
                let t1109 = t639 + t349 * t1097;
                let t1110 = t678 + t388 * t1097;
                let t1111 = t658 + t390 * t1097;
                let t1112 = t670 + t376 * t1097;
                let t1113 = t709 + t430 * t1097;
                let t1114 = t712 + t419 * t1097;
                let t1115 = t239 * t256 + t241 * t1097;
                let t1116 = t66 * t1115 + cos_phi * t703 - t1092 - t1092
                    + (t1114 + t1114 - t69 * t1093 - k24 * t1094);
                let t1117 = t239 * t245 + t51 * t241;
                let t1118 = T::from_f64(2.0) * t259;
                let t1119 = cos_phi * t1118;
                let t1120 = t44 * t1115 + k41 * t1119 - t1084 - t1084
                    + (t1106 + t1106 - t46 * t1093 - k4 * t1094);
                let t1121 = t54 * t1115 + k34 * t1119 - t1086 - t1086
                    + (t1108 + t1108 - t55 * t1093 - k25 * t1094);
                let t1122 = t1110 + t1110 - t88 * t1093 - sin_phi * t439
                    + (t86 * t1115 + k24 * t1119 - t1088 - t1088);
                let t1123 = t1122 - (t1111 + t1111 - t78 * t1093 - k30 * t1094)
                    - (t77 * t1115 + k31 * t1119 - t1089 - t1089);
                let t1124 = t29 * t1115 + k4 * t1119 - t1081 - t1081
                    + (t1102 + t1102 - t31 * t1093 - k41 * t1094);
                let t1125 = k43 * t1118;
                let t1126 = t1124 + k84 * t1115
                    - (t27 * t1115 + cos_phi * t1125 - t1082 - t1082);
                let t1127 = k45 * t1118;
                let t1128 = t22 * t1093 + k42 * t1094 + t1096 * t158
                    + cos_psi * (t1126 - t1127);
                let t1129 = sin_phi * t1118;
                let t1130 = t1115 + t1118;
                let t1131 = cos_phi * t717;
                let t1132 = k19 * t717 - (k21 * t1131 + t1091 + t1091 + t71 * t1115)
                    - (t1113 + t1113 + t73 * t1093 + k20 * t1129);
                let t1133 = t1103 + t1103 + t25 * t1093 + k44 * t1129
                    - (k12 * t1131 + t1083 + t1083 + t33 * t1115);
                let t1134 = t1133 - (t1104 + t1104 + t35 * t1093 + k2 * t1129)
                    - k46 * t1093;
                let t1135 = t1107 + t1107 + t42 * t1093 + k12 * t1129
                    + (k2 * t1131 + t1085 + t1085 + t48 * t1115);
                let t1136 = sin_psi * t238;
                let t1137 = t276 * t1136 + t133 * t273 + (t277 * t1136 + t1080 * t570)
                    - (t278 * t1097 + t134 * t256 - (t279 * t1095 + t1097 * t571));
                let t1138 = t283 * t1136 + t273 * (t47 + t29 * t1080)
                    + (t285 * t1136 + t273 * (t45 + t31 * t1097));
                let t1139 = t287 * t1136 + t273 * (t135 + t27 * t1080)
                    + (t288 * t1095 + t254 * (t43 - t33 * t1080));
                let t1140 = t330 * t1136 + t273 * (t42 * t1097 - t34)
                    + (t331 * t1136 + t273 * (t36 - t48 * t1080));
                let t1141 = t280 * t1136 + t1080 * t573
                    + (t281 * t1095 + t254 * (t25 * t1097 - t139));
                let t1142 = t1137 - (t1141 + t1138 - (t1139 + t1105));
                let t1143 = t394 * t1136 + t1097 * t681
                    + (t396 * t1095 + t254 * (t101 + t77 * t1080));
                let t1144 = t440 * t1136 + t273 * (t89 + t66 * t1080)
                    + (t441 * t1095 + t111 * t254);
                let t1145 = t444 * t1097 + t108 * t256
                    - (t445 * t1136 + t273 * (t87 + t69 * t1097));
                let t1146 = t439 * t1080 + t109 * t249 + t1144 - (t1101 + t1145);
                let t1147 = t357 * t1097 + t123 * t256
                    + (t358 * t1136 + t273 * (t57 * t1097 - t125));
                let t1148 = t382 * t1097 + t97 * t256
                    + (t383 * t1136 + t273 * (t82 * t1097 - t72));
                let t1149 = t359 * t1080 + t116 * t249
                    + (t360 * t1136 + t273 * (t126 - t58 * t1080));
                let t1150 = t384 * t1080 + t99 * t249
                    + (t385 * t1136 + t273 * (t74 - t84 * t1080));
                let t1151 = t238 * t273 + t242 * t1136;
                let t1152 = t1128 + sin_psi * t1134 + t1151 * t159 + t1142 + t1142
                    - t1125 - cos_phi * t1127;
                let t1153 = t703 + t65 * t1115 + T::from_f64(1.6) * cos_phi * t259
                    + sin_psi * t1132 + t1151 * t415;
                let t1154 = t1153 + cos_psi * t1116 + t1096 * t426 - t64 * t1093
                    - k22 * t1094;
                let t1155 = t1151 * t174 + sin_psi * (t1120 + k7 * t1115 - k42 * t1130)
                    + cos_psi * (t1135 + k10 * t1093);
                let t1156 = t1152 - t1115 * t24;
                let t1157 = t1154 - t1146 - t1146;
                let t1158 = t254 * t1080;
                let t1159 = t326 * t1095 + k7 * t1158 - (t327 * t1095 + t22 * t254)
                    + t1098;
                let t1160 = t1140
                    - (t332 * t1095 + k42 * t1158 - (t333 * t1136 + t1097 * t609));
                let t1161 = t363 * t1095 + k40 * t1158 - (t364 * t1095 + t117 * t254)
                    + t1099;
                let t1162 = t361 * t1095 + k37 * t1158 - (t362 * t1136 + t1097 * t645)
                    - t1161;
                let t1163 = t392 * t1095 + t104 * t254 + (t393 * t1095 + k26 * t1158)
                    + t1143;
                let t1164 = t1148 + t1150
                    + (t387 * t1095 + t254 * (t70 + t86 * t1080) + t1100 - t1163);
                let t1165 = t1147 + t1149 - t1162;
                let t1166 = t1159 + t1160;
                let t1167 = t1155 + t1096 * t176 + t1166 + t1166;
                let t1168 = k18 * t717;
                let t1169 = t1109 + t1109 + t57 * t1093 + k36 * t1129
                    + (cos_phi * t1168 + t1087 + t1087 + t58 * t1115);
                let t1170 = t1168 + k35 * t1129 + k28 * t1131 + t62 * t1115
                    + t1151 * t184;
                let t1171 = t1170 + sin_psi * (t1121 + k40 * t1115 - k37 * t1130)
                    + cos_psi * (t1169 + k39 * t1093);
                let t1172 = t1171 + t1096 * t191 + t1093 * t61 + t1165 + t1165;
                let t1173 = k20 * t717;
                let t1174 = k33 * t1129 + t1173 + k32 * t1131 + t92 * t1115
                    + t1151 * t213;
                let t1175 = t1112 + t1112 + t82 * t1093 + k21 * t1129
                    + (cos_phi * t1173 + t1090 + t1090 + t84 * t1115);
                let t1176 = t1174 + sin_psi * (t1123 - k26 * t1130)
                    + cos_psi * (t1175 - k19 * t1093);
                let t1177 = t1176 + t1096 * t214 + t1093 * t81 + t1164 + t1164;
                let t1178 = t38 * t1156 + t53 * t1167 + t63 * t1172 + t94 * t1177
                    - t76 * t1157;
                let t1179 = t96 * t1178;
                let t1180 = t229 * (t1156 - t38 * t1179) + t230 * (t1167 - t53 * t1179)
                    + t231 * (t1172 - t63 * t1179);
                let t1181 = t1180 + t232 * (t1157 + t76 * t1179)
                    + t233 * (t1177 - t94 * t1179);
                let t1182 = t237 * t1181;
                let t1183 = t1179 - t228 * t1182;
                let t1184 = t1182 + k3 * t1183 + k2 * t1117;
                let t1185 = k2 * t1183 - k3 * t1117;
                let t1186 = t238 + k3 * t506 - k2 * t162;
                let t1187 = t238 + t1186;
                let t1188 = k3 * t162 + k2 * t506;
                let t1189 = cos_psi * t1188 - t52;
                let t1190 = T::from_f64(0.1) * (t753 * t1189 + t733 * t1186);
                let t1191 = t798 + sin_psi * t1188;
                let t1192 = T::from_f64(1.125e-5)
                    * (cos_psi * t1079 + sin_psi * t1185 + t457 * t1187 + t1189 * t732);
                let t1193 = sin_psi * t1079 + t458 * t1187 + t1191 * t732
                    - cos_psi * t1185;
                let t1194 = t457 * t1191 + t458 * t1189;
                let t1195 = t51 * t247 + t245 * t506;
                let t1196 = t51 * t244 + t162 * t245;
                let t1197 = t1117 + t1195;
                let t1198 = T::from_f64(0.8) * t1197;
                let t1199 = sin_phi * t1;
                let t1200 = t1183 + t1196;
                let t1201 = t1196 - t1183;
                let t1202 = t1199 + T::from_f64(0.8) * t1200;
                let t1203 = k85 * t1198 - k86 * t1202
                    + T::from_f64(0.026677916666666666) * t1193;
                let t1204 = k48 * (t162 * t247 + t244 * t506 + t1079) + cos_psi * t1192
                    + sin_psi * t1203;
                let t1205 = sin_psi * t1192 - cos_psi * t1203;
                let t1206 = T::from_f64(0.96) * t1199
                    + T::from_f64(0.6613445833333333) * t1200 + k47 * (t1195 - t1117)
                    + k2 * t1205;
                let t1207 = T::from_f64(0.1) * t1193;
                let t1208 = t1053 + t940;
                let t1209 = cos_psi * (k3 * t1202 + k2 * t1198)
                    + sin_psi * (cos_phi * t1 + T::from_f64(0.8) * t1208);
                let t1210 = t1194 + t1184;
                let t1211 = T::from_f64(0.1) * t1209
                    + T::from_f64(0.026677916666666666) * t1210
                    - T::from_f64(1.125e-5) * (t1194 - t1184);
                let t1212 = T::from_f64(0.1) * t1210;
                let t1213 = cos_psi * t1212 - sin_psi * t1190;
                let t1214 = k2 * t1213 + k3 * t1207;
                let t1215 = k3 * t1213 - k2 * t1207;
                let t1216 = cos_phi * (t1215 + T::from_f64(0.96) * t1200)
                    - sin_phi
                        * (T::from_f64(0.96) * t1208 + cos_psi * t1190
                            + sin_psi * t1212);
                let t1217 = k3 * t1205 - k2 * t1211 - T::from_f64(0.8) * t1214
                    - k47 * t1201 - T::from_f64(0.6613445833333333) * t1197;
                let t1218 = sin_phi * (t1204 - k47 * (t932 + t1053 - t932 - t940))
                    + cos_phi * t1217;
                let t1219 = k1 + k7 * t1218
                    + (k24 * t1216 - k40 * (t1214 + T::from_f64(0.96) * t1197));
                let t1220 = t1219 + t238 * t1211
                    + t506
                        * (t1206 + k3 * t1211 + T::from_f64(0.8) * t1215 - k48 * t1201);
                let t1221 = t512 * t1220;
                (t1078, t1221)
            };
            (
                ::pendulum_core::nalgebra::SVector::from([qd_theta, t241, t242, t513]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [T::from_f64(0.0), t535, t536, t796],
                    [T::from_f64(0.0), t811, t812, t953],
                    [T::from_f64(0.0), t960, t961, t1078],
                    [T::from_f64(1.0), t239, t238, t1221],
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
            ::pendulum_core::nalgebra::SVector::from([
                T::from_f64(0.0),
                T::from_f64(0.0),
                T::from_f64(0.0),
                T::from_f64(0.0),
            ])
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Energy<T, 4> for Bennett<T> {
        #[inline]
        fn kinetic(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 4>) -> T {
            let [q_theta, q_phi, q_psi, qd_theta] = x.data.0[0];
            let k2 = self.constants[2];
            let k4 = self.constants[4];
            let k8 = self.constants[8];
            let k9 = self.constants[9];
            let k10 = self.constants[10];
            let k11 = self.constants[11];
            let k12 = self.constants[12];
            let k16 = self.constants[16];
            let k18 = self.constants[18];
            let k19 = self.constants[19];
            let k20 = self.constants[20];
            let k21 = self.constants[21];
            let k22 = self.constants[22];
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
            let k37 = self.constants[37];
            let k38 = self.constants[38];
            let k39 = self.constants[39];
            let k40 = self.constants[40];
            let k41 = self.constants[41];
            let k42 = self.constants[42];
            let k43 = self.constants[43];
            let k44 = self.constants[44];
            let k45 = self.constants[45];
            let k46 = self.constants[46];
            let k53 = self.constants[53];
            let k54 = self.constants[54];
            let k55 = self.constants[55];
            let k56 = self.constants[56];
            let k57 = self.constants[57];
            let k58 = self.constants[58];
            let k59 = self.constants[59];
            let k60 = self.constants[60];
            let k61 = self.constants[61];
            let k62 = self.constants[62];
            let k63 = self.constants[63];
            let k64 = self.constants[64];
            let k65 = self.constants[65];
            let k66 = self.constants[66];
            let k67 = self.constants[67];
            let k68 = self.constants[68];
            let k69 = self.constants[69];
            let k70 = self.constants[70];
            let k71 = self.constants[71];
            let k73 = self.constants[73];
            let k74 = self.constants[74];
            let k75 = self.constants[75];
            let k76 = self.constants[76];
            let k77 = self.constants[77];
            let k78 = self.constants[78];
            let k79 = self.constants[79];
            let k80 = self.constants[80];
            let k83 = self.constants[83];
            let k92 = self.constants[92];
            let (sin_phi, cos_phi) = q_phi.sin_cos();
            let [(sin_psi, cos_psi), (sin_theta, cos_theta)] = q_psi
                .sin_cos_pair(q_theta);
            let t0 = k41 * sin_theta;
            let t1 = k43 + k45 * cos_theta;
            let t2 = k4 * cos_theta;
            let t3 = k16 - (k45 + k43 * cos_theta);
            let t4 = k44 * cos_theta - k46;
            let t5 = k2 * cos_theta;
            let t6 = k12 * sin_theta;
            let t7 = sin_psi * (sin_phi * t0 + t1 - cos_phi * (t2 + t3) - k4)
                + cos_psi * (sin_phi * (t4 - t5) - cos_phi * t6);
            let t8 = sin_phi * t6 - cos_phi * t5;
            let t9 = sin_phi * t2 + cos_phi * t0;
            let t10 = k42 * sin_theta;
            let t11 = cos_phi * t10 + sin_phi * (t1 - cos_psi * t3)
                + sin_psi * (cos_phi * t4 + t8);
            let t12 = sin_psi * (t10 - t9) - cos_psi * t8;
            let t13 = t11 - cos_psi * t9;
            let t14 = k41 * cos_theta;
            let t15 = k4 * sin_theta;
            let t16 = sin_phi * t14 + cos_phi * t15;
            let t17 = k12 * cos_theta;
            let t18 = k2 * sin_theta;
            let t19 = cos_phi * t17 - sin_phi * t18;
            let t20 = sin_psi * (k58 * sin_phi - t16) + cos_psi * (k10 * cos_phi + t19);
            let t21 = k39 + k36 * cos_theta;
            let t22 = k25 * sin_theta;
            let t23 = k18 * sin_theta;
            let t24 = k40 + (k34 * cos_theta - k37);
            let t25 = cos_phi * (k38 + k35 * cos_theta + cos_psi * t21 - sin_psi * t22)
                - sin_phi * (k28 * sin_theta + cos_psi * t23 + sin_psi * t24);
            let t26 = cos_psi * (k34 + cos_phi * t24 - sin_phi * t22 - k37 * cos_theta)
                - sin_psi * (cos_phi * t23 + sin_phi * t21);
            let t27 = k21 * sin_theta;
            let t28 = k20 * cos_theta;
            let t29 = sin_phi * t27 - cos_phi * t28;
            let t30 = cos_phi * sin_theta;
            let t31 = cos_theta * sin_phi;
            let t32 = k24 * sin_theta;
            let t33 = T::from_f64(0.4) * cos_theta;
            let t34 = cos_psi * (k19 * sin_theta - cos_phi * t27 - sin_phi * t28)
                + sin_psi * (sin_phi * t32 - cos_phi * t33);
            let t35 = cos_phi * t32 + sin_phi * t33;
            let t36 = sin_psi * t29 - k22 * t30 - T::from_f64(0.8) * t31 - cos_psi * t35;
            let t37 = k30 * sin_theta;
            let t38 = k26 + k31 * cos_theta;
            let t39 = k24 * cos_theta;
            let t40 = T::from_f64(0.4) * sin_theta;
            let t41 = sin_phi * t39 + cos_phi * t40;
            let t42 = cos_phi * (t39 - t38) + sin_phi * (t37 - t40) - k26 * cos_theta
                - k31;
            let t43 = sin_psi * (cos_phi * t37 + sin_phi * t38 - t41)
                + cos_phi * (k33 * cos_theta - k19 * cos_psi - k29);
            let t44 = k21 * cos_theta;
            let t45 = k20 * sin_theta;
            let t46 = cos_psi * t42 + sin_psi * (sin_phi * (k19 - t44) - cos_phi * t45);
            let t47 = cos_phi * t44 - sin_phi * t45;
            let t48 = t40 + k22 * t31 + T::from_f64(0.8) * t30
                + sin_psi * (t47 - k19 * cos_theta);
            let t49 = t48 + cos_psi * t41;
            let t50 = sin_phi * sin_theta;
            let t51 = t43 + cos_psi * t47 - k32 * t50;
            let t52 = k33 * t50
                + sin_psi * (sin_theta * (k27 - k31 * cos_phi) + t35 - k30 * t31);
            let t53 = t52 + cos_psi * t29 - t28 - k32 * (cos_phi * cos_theta);
            let t54 = t13 * t13 + t20 * t20 + t25 * t25 + t36 * t36 + t51 * t51;
            let t55 = T::from_f64(1.0) / t54;
            let t56 = k42 * cos_theta;
            let t57 = cos_psi * (k41 + cos_phi * (k92 + t14) - t56 - sin_phi * t15)
                + sin_psi * (sin_phi * (k11 - t17) - cos_phi * t18);
            let t58 = t7 * t13 + t20 * t57 + t25 * t26 + t36 * t34 + t51 * t46;
            let t59 = t55 * t58;
            let t60 = t7 - t13 * t59;
            let t61 = t57 - t20 * t59;
            let t62 = t26 - t25 * t59;
            let t63 = t34 - t36 * t59;
            let t64 = t46 - t51 * t59;
            let t65 = t60 * t60 + t61 * t61 + t62 * t62 + t63 * t63 + t64 * t64;
            let t66 = k18 * cos_theta;
            let t67 = sin_theta
                * (sin_psi * (k37 - k34 * cos_phi) + sin_phi * (k83 - k36 * cos_psi));
            let t68 = sin_psi * sin_phi;
            let t69 = t66 + t67 + cos_phi * (k28 * cos_theta + cos_psi * t66)
                - k25 * (cos_theta * t68);
            let t70 = k43 * sin_theta;
            let t71 = k45 * sin_theta;
            let t72 = t70 + cos_phi * t71 + sin_phi * t56
                + cos_psi * (t71 + cos_phi * t70 - t16);
            let t73 = t72 - sin_psi * (k44 * t50 + t19);
            let t74 = t36 * t49 + t51 * t53 - t25 * t69 - t20 * t12 - t13 * t73;
            let t75 = t55 * t74;
            let t76 = t63 * (t49 - t36 * t75) + t64 * (t53 - t51 * t75)
                - t62 * (t69 + t25 * t75);
            let t77 = t76 - t61 * (t12 + t20 * t75) - t60 * (t73 + t13 * t75);
            let t78 = T::from_f64(1.0) / t65 * t77;
            let t79 = qd_theta * (t75 - t59 * t78);
            let t80 = qd_theta * t78;
            let t81 = T::from_f64(0.08) * cos_psi;
            let t82 = sin_psi * sin_psi;
            let t83 = t80 * (k53 + k63 * cos_psi) + t79 * (k79 + t81 - k80 * t82);
            let t84 = k74 + k68 * cos_psi + k75 * t68 + cos_phi * (k65 + k66 * cos_psi);
            let t85 = k77 + t81
                + cos_phi * (k67 + T::from_f64(0.04) * cos_psi - k59 * t82)
                + sin_phi * (sin_phi * (k76 - k60 * cos_psi) - sin_psi * t84);
            let t86 = k73 - k70 * cos_phi
                - T::from_f64(0.04) * (k8 * t68 + cos_psi * (k57 + k55 * cos_phi));
            let t87 = k62 * sin_phi
                + T::from_f64(0.02666666666666667)
                    * (k9 * (sin_phi * cos_psi) + sin_psi * (k56 + k54 * cos_phi));
            let t88 = k71 + k61 * cos_psi + cos_phi * (k69 + k64 * cos_psi)
                - sin_psi * t87;
            let t89 = qd_theta * (qd_theta * (t85 - k78 * t82) + t80 * t86 + t79 * t88);
            T::from_f64(0.013344583333333333) * t80 * t80 + t79 * t83 + t89
        }
        #[inline]
        fn potential(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 4>) -> T {
            let [q_theta, q_phi, q_psi, _] = x.data.0[0];
            let k2 = self.constants[2];
            let k4 = self.constants[4];
            let k10 = self.constants[10];
            let k12 = self.constants[12];
            let k41 = self.constants[41];
            let k42 = self.constants[42];
            let k58 = self.constants[58];
            let k72 = self.constants[72];
            let (sin_psi, cos_psi) = q_psi.sin_cos();
            let [(sin_theta, cos_theta), (sin_phi, cos_phi)] = q_theta
                .sin_cos_pair(q_phi);
            let t0 = k2 * sin_theta * cos_phi + sin_phi * (k10 + k12 * cos_theta);
            let t1 = k41 - (sin_phi * (k4 * sin_theta) + cos_phi * k58)
                + cos_theta * (cos_phi * k41 - k42);
            sin_theta * k72 + T::from_f64(9.4176) * t0
                + T::from_f64(0.981) * (cos_psi * t0 + sin_psi * t1)
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> Bennett<T> {
        ///How far each closed loop is from its toggle, in the order of the declaration: 0 there, and at most 1. And the rates of that.
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        pub fn loop_margins(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 1>,
            ::pendulum_core::nalgebra::SVector<T, 1>,
        ) {
            let [q_theta, q_phi, q_psi, qd_theta] = x.data.0[0];
            let k2 = self.constants[2];
            let k4 = self.constants[4];
            let k7 = self.constants[7];
            let k10 = self.constants[10];
            let k12 = self.constants[12];
            let k16 = self.constants[16];
            let k18 = self.constants[18];
            let k19 = self.constants[19];
            let k20 = self.constants[20];
            let k21 = self.constants[21];
            let k22 = self.constants[22];
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
            let k37 = self.constants[37];
            let k38 = self.constants[38];
            let k39 = self.constants[39];
            let k40 = self.constants[40];
            let k41 = self.constants[41];
            let k42 = self.constants[42];
            let k43 = self.constants[43];
            let k44 = self.constants[44];
            let k45 = self.constants[45];
            let k46 = self.constants[46];
            let k58 = self.constants[58];
            let k81 = self.constants[81];
            let k82 = self.constants[82];
            let k83 = self.constants[83];
            let k84 = self.constants[84];
            let (sin_psi, cos_psi) = q_psi.sin_cos();
            let [(sin_phi, cos_phi), (sin_theta, cos_theta)] = q_phi
                .sin_cos_pair(q_theta);
            let t0 = k42 * sin_theta;
            let t1 = k43 * cos_theta;
            let t2 = k4 * cos_theta;
            let t3 = k41 * sin_theta;
            let t4 = sin_phi * t2 + cos_phi * t3;
            let t5 = sin_phi * t1 + k45 * sin_phi - (k16 * sin_phi + t4);
            let t6 = k44 * cos_theta;
            let t7 = k12 * sin_theta;
            let t8 = k2 * cos_theta;
            let t9 = sin_phi * t7 - cos_phi * t8;
            let t10 = sin_psi * (t0 - t4) - cos_psi * t9;
            let t11 = cos_phi * t6 + t9 - k46 * cos_phi;
            let t12 = k43 + k45 * cos_theta;
            let t13 = cos_phi * t0 + cos_psi * t5 + sin_psi * t11 + sin_phi * t12;
            let t14 = k41 * cos_theta;
            let t15 = k4 * sin_theta;
            let t16 = sin_phi * t14 + cos_phi * t15;
            let t17 = k42 * sin_phi - k7 * sin_phi - t16;
            let t18 = k12 * cos_theta;
            let t19 = k2 * sin_theta;
            let t20 = cos_phi * t18 - sin_phi * t19;
            let t21 = k10 * cos_phi + t20;
            let t22 = sin_psi * t17 + cos_psi * t21;
            let t23 = k34 * cos_theta;
            let t24 = k25 * sin_theta;
            let t25 = k37 * sin_phi - sin_phi * t23 - cos_phi * t24 - k40 * sin_phi;
            let t26 = k36 * cos_theta;
            let t27 = k18 * sin_theta;
            let t28 = k39 * cos_phi + (cos_phi * t26 - sin_phi * t27);
            let t29 = k38 + k35 * cos_theta;
            let t30 = k28 * sin_theta;
            let t31 = sin_psi * t25 + cos_psi * t28 + cos_phi * t29 - sin_phi * t30;
            let t32 = k21 * sin_theta;
            let t33 = k20 * cos_theta;
            let t34 = sin_phi * t32 - cos_phi * t33;
            let t35 = k22 * sin_theta;
            let t36 = T::from_f64(0.8) * cos_theta;
            let t37 = k24 * sin_theta;
            let t38 = T::from_f64(0.4) * cos_theta;
            let t39 = cos_phi * t37 + sin_phi * t38;
            let t40 = sin_psi * t34 - cos_phi * t35 - sin_phi * t36 - cos_psi * t39;
            let t41 = k30 * sin_theta;
            let t42 = k31 * cos_theta;
            let t43 = k24 * cos_theta;
            let t44 = T::from_f64(0.4) * sin_theta;
            let t45 = sin_phi * t43 + cos_phi * t44;
            let t46 = cos_phi * t41 + k26 * sin_phi + sin_phi * t42 - t45;
            let t47 = k32 * sin_theta;
            let t48 = k21 * cos_theta;
            let t49 = k20 * sin_theta;
            let t50 = cos_phi * t48 - sin_phi * t49;
            let t51 = k19 * cos_phi - t50;
            let t52 = k29 - k33 * cos_theta;
            let t53 = sin_psi * t46 - sin_phi * t47 - cos_psi * t51 - cos_phi * t52;
            let t54 = t13 * t13 + t22 * t22 + t31 * t31 + t40 * t40 + t53 * t53;
            let t55 = T::from_f64(1.0) / t54;
            let t56 = t54 * t55;
            let t57 = cos_phi * t1 + sin_phi * t3 + k45 * cos_phi + t12 - cos_phi * t2;
            let t58 = t57 - k16 * cos_phi - k4;
            let t59 = t6 * sin_phi - cos_phi * t7 - (sin_phi * t8 + k46 * sin_phi);
            let t60 = sin_psi * t58 + cos_psi * t59;
            let t61 = sin_phi * t37 - cos_phi * t38;
            let t62 = sin_phi * t33 - (k19 * sin_theta - cos_phi * t32);
            let t63 = sin_psi * t61 - cos_psi * t62;
            let t64 = k19 * sin_phi - sin_phi * t48 - cos_phi * t49;
            let t65 = sin_phi * t44 + (k31 - sin_phi * t41)
                + (k26 * cos_theta + k26 * cos_phi + (cos_phi * t42 - cos_phi * t43));
            let t66 = sin_psi * t64 - cos_psi * t65;
            let t67 = k42 * cos_phi;
            let t68 = k42 * cos_theta;
            let t69 = t67 - k7 * cos_phi - (k41 + cos_phi * t14 - (sin_phi * t15 + t68));
            let t70 = sin_phi * t18 + cos_phi * t19 + k10 * sin_phi;
            let t71 = cos_psi * t69 + sin_psi * t70;
            let t72 = k37 * cos_phi - k40 * cos_phi
                - (k34 + cos_phi * t23 - (sin_phi * t24 + k37 * cos_theta));
            let t73 = sin_phi * t26 + cos_phi * t27 + k39 * sin_phi;
            let t74 = cos_psi * t72 + sin_psi * t73;
            let t75 = t13 * t60 + t40 * t63 + t53 * t66 - t22 * t71 - t31 * t74;
            let t76 = t55 * t75;
            let t77 = t60 - t13 * t76;
            let t78 = t71 + t22 * t76;
            let t79 = t74 + t31 * t76;
            let t80 = t63 - t40 * t76;
            let t81 = t66 - t53 * t76;
            let t82 = t77 * t77 + t78 * t78 + t79 * t79 + t80 * t80 + t81 * t81;
            let t83 = T::from_f64(1.0) / t82;
            let t84 = t60 * t60 + t71 * t71 + t74 * t74 + t63 * t63 + t66 * t66;
            let t85 = t83 * t84;
            let t86 = t56 * t85;
            let t87 = T::from_f64(1.0) / t86.sqrt();
            let t88 = cos_theta * qd_theta;
            let t89 = cos_theta * sin_phi;
            let t90 = t44 + k22 * t89 + T::from_f64(0.8) * cos_phi * sin_theta
                + sin_psi * (t50 - k19 * cos_theta);
            let t91 = t90 + cos_psi * t45;
            let t92 = sin_phi * sin_theta;
            let t93 = k33 * t92
                + sin_psi * (t39 + sin_theta * (k27 - k31 * cos_phi) - k30 * t89);
            let t94 = t93 + cos_psi * t34 - t33 - k32 * (cos_phi * cos_theta);
            let t95 = k18 * cos_theta;
            let t96 = sin_theta
                * (sin_psi * (k37 - k34 * cos_phi) + sin_phi * (k83 - k36 * cos_psi));
            let t97 = t95 + t96 + cos_phi * (k28 * cos_theta + cos_psi * t95)
                - k25 * (sin_psi * t89);
            let t98 = k43 * sin_theta;
            let t99 = k45 * sin_theta;
            let t100 = t98 + cos_phi * t99 + sin_phi * t68
                + cos_psi * (t99 + cos_phi * t98 - t16);
            let t101 = t100 - sin_psi * (k44 * t92 + t20);
            let t102 = t40 * t91 + t53 * t94 - t31 * t97 - t22 * t10 - t13 * t101;
            let t103 = t55 * t102;
            let t104 = t80 * (t91 - t40 * t103) + t81 * (t94 - t53 * t103)
                + t79 * (t97 + t31 * t103);
            let t105 = t104 + t78 * (t10 + t22 * t103) - t77 * (t101 + t13 * t103);
            let t106 = t83 * t105;
            let t107 = qd_theta * (t103 - t76 * t106);
            let t108 = qd_theta * t106;
            let t109 = cos_phi * t107;
            let t110 = sin_phi * t107;
            let t111 = sin_theta * qd_theta;
            let t112 = k43 * t111;
            let t113 = k4 * t111;
            let t114 = t1 * t109 - sin_phi * t112 + k81 * t109
                - (t2 * t109 - sin_phi * t113);
            let t115 = k41 * t88;
            let t116 = sin_phi * t115 + t3 * t109 + (cos_phi * t113 + t2 * t110)
                + k84 * t110;
            let t117 = k12 * t88;
            let t118 = k2 * t111;
            let t119 = sin_phi * t117 + t7 * t109 + (cos_phi * t118 + t8 * t110)
                + k46 * t110;
            let t120 = k44 * t111;
            let t121 = t67 * t88 + cos_psi * (t114 - (cos_phi * t115 - t3 * t110))
                + sin_psi * (t119 - (cos_phi * t120 + t6 * t110));
            let t122 = t6 * t109 - sin_phi * t120 - (cos_phi * t117 - t7 * t110)
                - (t8 * t109 - sin_phi * t118);
            let t123 = cos_psi * t108;
            let t124 = sin_psi * t108;
            let t125 = k45 * t111;
            let t126 = t121 + t123 * t11 + t109 * t12 - sin_phi * t125 - t0 * t110;
            let t127 = t123 * t58
                + sin_psi * (t116 - t125 - (cos_phi * t112 + t1 * t110));
            let t128 = t127 + cos_psi * (t122 - k46 * t109) - t124 * t59;
            let t129 = t126 - t124 * t5;
            let t130 = k41 * t111;
            let t131 = k4 * t88;
            let t132 = k58 * t109 - (t14 * t109 - sin_phi * t130)
                - (cos_phi * t131 - t15 * t110);
            let t133 = k12 * t111;
            let t134 = k2 * t88;
            let t135 = cos_phi * t133 + t18 * t110 + (sin_phi * t134 + t19 * t109)
                + k10 * t110;
            let t136 = sin_psi * t132 + t123 * t17 - cos_psi * t135 - t124 * t21;
            let t137 = t18 * t109 - sin_phi * t133 + (cos_phi * t134 - t19 * t110)
                + k10 * t109;
            let t138 = k34 * t111;
            let t139 = k25 * t88;
            let t140 = k82 * t109 - (t23 * t109 - sin_phi * t138)
                - (cos_phi * t139 - t24 * t110);
            let t141 = cos_phi * t111;
            let t142 = sin_phi * t88;
            let t143 = sin_psi * t140 + t123 * t25 - k35 * t141 - k28 * t142
                - t30 * t109;
            let t144 = k36 * t111;
            let t145 = k18 * t88;
            let t146 = cos_phi * t144 + t26 * t110 + (sin_phi * t145 + t27 * t109)
                + k39 * t110;
            let t147 = t143 - cos_psi * t146 - t124 * t28 - t110 * t29;
            let t148 = t26 * t109 - sin_phi * t144 + (cos_phi * t145 - t27 * t110)
                + k39 * t109;
            let t149 = k21 * t88;
            let t150 = k20 * t111;
            let t151 = sin_psi
                * (sin_phi * t149 + t32 * t109 + (cos_phi * t150 + t33 * t110));
            let t152 = t35 * t110 + T::from_f64(0.8) * sin_phi * t111 + t151 + t123 * t34
                + t124 * t39;
            let t153 = k19 * t88 - (cos_phi * t149 - t32 * t110)
                - (t33 * t109 - sin_phi * t150);
            let t154 = k24 * t88;
            let t155 = T::from_f64(0.4) * t111;
            let t156 = cos_psi
                * (cos_phi * t154 - t37 * t110 + (t38 * t109 - sin_phi * t155));
            let t157 = sin_psi
                * (sin_phi * t154 + t37 * t109 + (cos_phi * t155 + t38 * t110));
            let t158 = cos_psi * t153 + t124 * t62 + t157 + t123 * t61;
            let t159 = t152 - k22 * cos_phi * t88 - t36 * t109 - t156;
            let t160 = k30 * t88;
            let t161 = k31 * t111;
            let t162 = cos_phi * t160 - t41 * t110 + (t42 * t109 - sin_phi * t161)
                + k26 * t109;
            let t163 = k24 * t111;
            let t164 = T::from_f64(0.4) * t88;
            let t165 = t162 - (t43 * t109 - sin_phi * t163)
                - (cos_phi * t164 - t44 * t110);
            let t166 = k20 * t88;
            let t167 = k21 * t111;
            let t168 = t111 + t110;
            let t169 = sin_phi * t160 + t41 * t109 + (cos_phi * t161 + t42 * t110)
                + k26 * t168;
            let t170 = t169 - (cos_phi * t163 + t43 * t110)
                - (sin_phi * t164 + t44 * t109);
            let t171 = k42 * t168 - (cos_phi * t130 + t14 * t110)
                - (sin_phi * t131 + t15 * t109);
            let t172 = k37 * t168 - (cos_phi * t138 + t23 * t110)
                - (sin_phi * t139 + t24 * t109);
            let t173 = t124 * t69 + cos_psi * (t171 - k7 * t110) - sin_psi * t137
                - t123 * t70;
            let t174 = t124 * t72 + cos_psi * (t172 - k40 * t110) - sin_psi * t148
                - t123 * t73;
            let t175 = k19 * t110 - (cos_phi * t167 + t48 * t110)
                - (sin_phi * t166 + t49 * t109);
            let t176 = k19 * t109 - (t48 * t109 - sin_phi * t167)
                - (cos_phi * t166 - t49 * t110);
            let t177 = sin_psi * t165 + t123 * t46 + cos_psi * t175 + t124 * t51
                + t110 * t52;
            let t178 = t124 * t65 + cos_psi * t170 + sin_psi * t176 + t123 * t64;
            let t179 = t177 - k33 * t141 - k32 * t142 - t47 * t109;
            let t180 = t13 * t129 + t22 * t136 + t31 * t147 + t40 * t159 + t53 * t179;
            let t181 = T::from_f64(2.0) * t180;
            let t182 = t181 * (T::from_f64(1.0) / (t54 * t54));
            let t183 = t60 * t128 + t63 * t158 + t66 * t178 - t71 * t173 - t74 * t174;
            let t184 = t60 * t129 + t13 * t128 + t22 * t173 + t31 * t174 + t63 * t159;
            let t185 = t184 + t40 * t158 + t66 * t179 + t53 * t178 - t71 * t136;
            let t186 = t55 * (t185 - t74 * t147) - t75 * t182;
            let t187 = t77 * (t128 - t76 * t129 - t13 * t186)
                + t80 * (t158 - t76 * t159 - t40 * t186);
            let t188 = t187 + t81 * (t178 - t76 * t179 - t53 * t186)
                - t78 * (t173 - t76 * t136 - t22 * t186);
            let t189 = t84 * (T::from_f64(1.0) / (t82 * t82))
                * (T::from_f64(2.0) * (t188 - t79 * (t174 - t76 * t147 - t31 * t186)));
            let t190 = t85 * (t55 * t181 - t54 * t182)
                + t56 * (t83 * (T::from_f64(2.0) * t183) - t189);
            (
                ::pendulum_core::nalgebra::SVector::from([t87]),
                ::pendulum_core::nalgebra::SVector::from([
                    -(T::from_f64(0.5) * t87 * (T::from_f64(1.0) / t86) * t190),
                ]),
            )
        }
        ///What a step of Newton's method adds to the coordinates that follow and are in the state, to close their loops.
        #[inline]
        pub fn loop_corrections(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 2> {
            let [q_theta, q_phi, q_psi, _] = x.data.0[0];
            let k2 = self.constants[2];
            let k4 = self.constants[4];
            let k7 = self.constants[7];
            let k10 = self.constants[10];
            let k12 = self.constants[12];
            let k16 = self.constants[16];
            let k18 = self.constants[18];
            let k19 = self.constants[19];
            let k20 = self.constants[20];
            let k21 = self.constants[21];
            let k22 = self.constants[22];
            let k24 = self.constants[24];
            let k25 = self.constants[25];
            let k26 = self.constants[26];
            let k28 = self.constants[28];
            let k29 = self.constants[29];
            let k30 = self.constants[30];
            let k31 = self.constants[31];
            let k32 = self.constants[32];
            let k33 = self.constants[33];
            let k34 = self.constants[34];
            let k35 = self.constants[35];
            let k36 = self.constants[36];
            let k37 = self.constants[37];
            let k38 = self.constants[38];
            let k39 = self.constants[39];
            let k40 = self.constants[40];
            let k41 = self.constants[41];
            let k42 = self.constants[42];
            let k43 = self.constants[43];
            let k44 = self.constants[44];
            let k45 = self.constants[45];
            let k46 = self.constants[46];
            let k58 = self.constants[58];
            let k82 = self.constants[82];
            let (sin_psi, cos_psi) = q_psi.sin_cos();
            let [(sin_phi, cos_phi), (sin_theta, cos_theta)] = q_phi
                .sin_cos_pair(q_theta);
            let t0 = k12 * sin_theta;
            let t1 = k43 + k45 * cos_theta;
            let t2 = k4 * cos_theta;
            let t3 = k43 * cos_theta;
            let t4 = k16 - (k45 + t3);
            let t5 = k42 * sin_theta;
            let t6 = k44 * cos_theta;
            let t7 = k2 * cos_theta;
            let t8 = k41 * sin_theta;
            let t9 = t1 - (k4 + cos_phi * t2)
                + (cos_phi * t3 + sin_phi * t8 + (k45 * cos_phi - k16 * cos_phi));
            let t10 = sin_phi * (sin_psi * t0 + t1 - cos_psi * (t2 + t4))
                + cos_phi * (t5 + sin_psi * (t6 - t7 - k46) - cos_psi * t8);
            let t11 = t6 * sin_phi - cos_phi * t0 - sin_phi * t7 - k46 * sin_phi;
            let t12 = sin_phi * t5 + sin_psi * t11 + t4 - cos_psi * t9 - cos_phi * t1;
            let t13 = sin_psi * t9 + cos_psi * t11;
            let t14 = k41 * cos_theta;
            let t15 = k4 * sin_theta;
            let t16 = k12 * cos_theta;
            let t17 = k2 * sin_theta;
            let t18 = sin_psi * (sin_phi * (k58 - t14) - cos_phi * t15)
                + cos_psi * (cos_phi * (k10 + t16) - sin_phi * t17);
            let t19 = k41 + cos_phi * t14 + k7 * cos_phi - sin_phi * t15
                - k42 * cos_theta;
            let t20 = k10 * sin_phi + (sin_phi * t16 + cos_phi * t17);
            let t21 = t19 - k42 * cos_phi;
            let t22 = k38 + k35 * cos_theta;
            let t23 = k36 * cos_theta;
            let t24 = k25 * sin_theta;
            let t25 = k34 * cos_theta;
            let t26 = k28 * sin_theta;
            let t27 = k18 * sin_theta;
            let t28 = cos_phi * (t22 + cos_psi * (k39 + t23) - sin_psi * t24)
                + sin_phi * (sin_psi * (k82 - t25) - t26 - cos_psi * t27);
            let t29 = k34 + cos_phi * t25 + k40 * cos_phi - sin_phi * t24
                - k37 * cos_theta;
            let t30 = t29 - k37 * cos_phi;
            let t31 = k39 * sin_phi + (sin_phi * t23 + cos_phi * t27);
            let t32 = t27 + cos_phi * t26 + sin_psi * t30 + cos_psi * t31
                + sin_phi * t22;
            let t33 = cos_psi * t30 - sin_psi * t31;
            let t34 = k21 * sin_theta;
            let t35 = T::from_f64(0.8) * cos_theta;
            let t36 = T::from_f64(0.4) * cos_theta;
            let t37 = k22 * sin_theta;
            let t38 = k20 * cos_theta;
            let t39 = k24 * sin_theta;
            let t40 = sin_phi * (sin_psi * t34 - t35 - cos_psi * t36)
                - cos_phi * (t37 + sin_psi * t38 + cos_psi * t39);
            let t41 = k19 * sin_theta - cos_phi * t34 - sin_phi * t38;
            let t42 = sin_phi * t39 - cos_phi * t36;
            let t43 = T::from_f64(0.8) + t36 + cos_phi * t35 + sin_psi * t41
                - sin_phi * t37 - cos_psi * t42;
            let t44 = cos_psi * t41 + sin_psi * t42;
            let t45 = k30 * sin_theta;
            let t46 = T::from_f64(0.4) * sin_theta;
            let t47 = k21 * cos_theta;
            let t48 = k29 - k33 * cos_theta;
            let t49 = k31 * cos_theta;
            let t50 = k24 * cos_theta;
            let t51 = k32 * sin_theta;
            let t52 = k20 * sin_theta;
            let t53 = cos_phi * (sin_psi * (t45 - t46) + cos_psi * (t47 - k19) - t48)
                + sin_phi * (sin_psi * (k26 + t49 - t50) - t51 - cos_psi * t52);
            let t54 = cos_phi * t50 - (k31 + sin_phi * t46)
                + (sin_phi * t45 - k26 * cos_theta - (k26 * cos_phi + cos_phi * t49));
            let t55 = k19 * sin_phi - sin_phi * t47 - cos_phi * t52;
            let t56 = cos_psi * t55 + sin_phi * t48 - t52 - cos_phi * t51
                - sin_psi * t54;
            let t57 = cos_psi * t54 + sin_psi * t55;
            let t58 = t10 * t10 + t18 * t18 + t28 * t28 + t40 * t40 + t53 * t53;
            let t59 = T::from_f64(1.0) / t58;
            let t60 = sin_psi * t21 + cos_psi * t20;
            let t61 = cos_psi * t21 - sin_psi * t20;
            let t62 = t53 * t56 - t40 * t43 - t28 * t32 - t18 * t60 - t10 * t12;
            let t63 = t59 * t62;
            let t64 = t10 * t13 + t18 * t61 + t28 * t33 + t40 * t44 + t53 * t57;
            let t65 = t59 * t64;
            let t66 = t13 - t10 * t65;
            let t67 = t61 - t18 * t65;
            let t68 = t33 - t28 * t65;
            let t69 = t44 - t40 * t65;
            let t70 = t57 - t53 * t65;
            let t71 = t70 * (t56 - t53 * t63) - t69 * (t43 + t40 * t63)
                - t68 * (t32 + t28 * t63);
            let t72 = t71 - t67 * (t60 + t18 * t63) - t66 * (t12 + t10 * t63);
            let t73 = t66 * t66 + t67 * t67 + t68 * t68 + t69 * t69 + t70 * t70;
            let t74 = T::from_f64(1.0) / t73 * t72;
            ::pendulum_core::nalgebra::SVector::from([t63 - t65 * t74, t74])
        }
        ///How far the loops that have no closed form are from being closed, in the order of the declaration: the distances between their ends in m, the angles between their frames, or axes, in rad, and the sums of the lengths around them in m.
        #[inline]
        pub fn loop_gaps(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 1>,
            ::pendulum_core::nalgebra::SVector<T, 1>,
            ::pendulum_core::nalgebra::SVector<T, 1>,
        ) {
            let [q_theta, q_phi, q_psi, _] = x.data.0[0];
            let k2 = self.constants[2];
            let k3 = self.constants[3];
            let k4 = self.constants[4];
            let k5 = self.constants[5];
            let k6 = self.constants[6];
            let k7 = self.constants[7];
            let k8 = self.constants[8];
            let k15 = self.constants[15];
            let k16 = self.constants[16];
            let k17 = self.constants[17];
            let k18 = self.constants[18];
            let k19 = self.constants[19];
            let k20 = self.constants[20];
            let k21 = self.constants[21];
            let k23 = self.constants[23];
            let k24 = self.constants[24];
            let k25 = self.constants[25];
            let k26 = self.constants[26];
            let k28 = self.constants[28];
            let k29 = self.constants[29];
            let k31 = self.constants[31];
            let k32 = self.constants[32];
            let k33 = self.constants[33];
            let k34 = self.constants[34];
            let k35 = self.constants[35];
            let k36 = self.constants[36];
            let k37 = self.constants[37];
            let k38 = self.constants[38];
            let k39 = self.constants[39];
            let k89 = self.constants[89];
            let k90 = self.constants[90];
            let k91 = self.constants[91];
            let (sin_psi, cos_psi) = q_psi.sin_cos();
            let t0 = T::from_f64(1.0) - cos_psi;
            let t1 = k4 * t0;
            let t2 = k2 * t1;
            let t3 = k3 * t1;
            let t4 = cos_psi + k6 * t0;
            let t5 = cos_psi + k5 * t0;
            let t6 = t2 + k3 * t4;
            let t7 = k2 * t4 - t3;
            let t8 = k2 * t5 + t3;
            let t9 = k3 * t5 - t2;
            let t10 = k3 * sin_psi;
            let t11 = k2 * sin_psi;
            let t12 = k2 * t10 - k3 * t11;
            let t13 = k3 * t10 + k2 * t11;
            let [(sin_theta, cos_theta), (sin_phi, cos_phi)] = q_theta
                .sin_cos_pair(q_phi);
            let t14 = k18 * sin_theta;
            let t15 = k34 + cos_phi * (k89 + k34 * cos_theta)
                - k25 * (sin_phi * sin_theta) - k37 * cos_theta;
            let t16 = t14 + sin_psi * t15
                + sin_phi * (k38 + k39 * cos_psi + cos_theta * (k35 + k36 * cos_psi));
            let t17 = t16 + cos_phi * (k28 * sin_theta + cos_psi * t14);
            let t18 = T::from_f64(0.4) * cos_theta;
            let t19 = sin_theta
                * (sin_psi * (k19 - k21 * cos_phi) + sin_phi * (k23 - k24 * cos_psi));
            let t20 = T::from_f64(0.8) + t18 + t19
                + cos_phi * (T::from_f64(0.8) * cos_theta + cos_psi * t18)
                - k20 * sin_psi * (cos_theta * sin_phi);
            let t21 = k20 * sin_theta;
            let t22 = cos_phi * (k90 * cos_theta - k26) + sin_phi * (k91 * sin_theta)
                - k26 * cos_theta;
            let t23 = t21 + sin_psi * (t22 - k31)
                + sin_phi * (cos_theta * (k33 + k21 * cos_psi) - k19 * cos_psi - k29);
            let t24 = t23 + cos_phi * (k32 * sin_theta + cos_psi * t21);
            let t25 = k3 * sin_theta;
            let t26 = k8 * sin_phi;
            let t27 = k7 * sin_phi;
            let t28 = k7 * t26 - k8 * t27;
            let t29 = T::from_f64(1.0) - cos_theta;
            let t30 = cos_theta + k5 * t29;
            let t31 = k4 * t29;
            let t32 = cos_theta + k6 * t29;
            let t33 = k2 * t31;
            let t34 = k3 * t31;
            let t35 = k3 * t30 - t33;
            let t36 = k2 * t30 + t34;
            let t37 = t33 + k3 * t32;
            let t38 = k2 * t32 - t34;
            let t39 = T::from_f64(1.0) - cos_phi;
            let t40 = cos_phi + k15 * t39;
            let t41 = k16 * t39;
            let t42 = cos_phi + k17 * t39;
            let t43 = k8 * t41;
            let t44 = k7 * t41;
            let t45 = k7 * t40 + t43;
            let t46 = k8 * t40 - t44;
            let t47 = t44 + k8 * t42;
            let t48 = k7 * t42 - t43;
            let t49 = t25 * t28 - t35 * t45 - t36 * t47;
            let t50 = cos_phi * t25 + t26 * t35 - t27 * t36;
            let t51 = k8 * t26 + k7 * t27;
            let t52 = t35 * t46 - t25 * t51 - t36 * t48;
            let t53 = k8 * (t49 * t6 + t50 * t12 - t52 * t8)
                - k7 * (t49 * t7 + t52 * t9 - t50 * t13);
            let t54 = k2 * sin_theta;
            let t55 = k2 * t25 - k3 * t54;
            let t56 = k3 * t25 + k2 * t54;
            let t57 = t47 * t55 + cos_theta * t28 + t45 * t56;
            let t58 = t47 * t37 + t28 * t54 - t45 * t38;
            let t59 = t48 * t55 - cos_theta * t51 - t46 * t56;
            let t60 = t48 * t37 + t46 * t38 - t51 * t54;
            let t61 = t27 * t37 + cos_phi * t54 + t26 * t38;
            let t62 = t27 * t55 + cos_phi * cos_theta - t26 * t56;
            let t63 = k7 * (t7 * t57 + t9 * t59 - t13 * t62)
                - k8 * (t6 * t57 + t12 * t62 - t8 * t59);
            let t64 = k8 * (t6 * t58 + t12 * t61 - t8 * t60)
                - k7 * (t7 * t58 + t9 * t60 - t13 * t61);
            (
                ::pendulum_core::nalgebra::SVector::from([
                    (t17 * t17 + t20 * t20 + t24 * t24).sqrt(),
                ]),
                ::pendulum_core::nalgebra::SVector::from([
                    (t53 * t53 + t63 * t63).sqrt().atan2(t64),
                ]),
                ::pendulum_core::nalgebra::SVector::from([T::from_f64(2.4)]),
            )
        }
        ///Output `gap`.
        #[inline]
        pub fn gap(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 5> {
            let [q_theta, q_phi, q_psi, _] = x.data.0[0];
            let k2 = self.constants[2];
            let k3 = self.constants[3];
            let k4 = self.constants[4];
            let k5 = self.constants[5];
            let k6 = self.constants[6];
            let k7 = self.constants[7];
            let k8 = self.constants[8];
            let k13 = self.constants[13];
            let k14 = self.constants[14];
            let k15 = self.constants[15];
            let k16 = self.constants[16];
            let k17 = self.constants[17];
            let k96 = self.constants[96];
            let k97 = self.constants[97];
            let k98 = self.constants[98];
            let k99 = self.constants[99];
            let (sin_psi, cos_psi) = q_psi.sin_cos();
            let t0 = k2 * sin_psi;
            let t1 = T::from_f64(0.4) * t0;
            let t2 = T::from_f64(0.8) + T::from_f64(0.4) * cos_psi;
            let t3 = k3 * sin_psi;
            let t4 = t2 + (k96 * t3 - k97 * t0) + (k98 * t3 + k99 * t0);
            let t5 = T::from_f64(0.4) * t3;
            let t6 = T::from_f64(1.0) - cos_psi;
            let t7 = k4 * t6;
            let t8 = k2 * t7;
            let t9 = k3 * t7;
            let t10 = cos_psi + k6 * t6;
            let t11 = cos_psi + k5 * t6;
            let t12 = t1 + k14 * (t8 + k3 * t10) - k13 * (k2 * t10 - t9);
            let t13 = t5 - k13 * (k3 * t11 - t8) - k14 * (t9 + k2 * t11);
            let [(sin_theta, cos_theta), (sin_phi, cos_phi)] = q_theta
                .sin_cos_pair(q_phi);
            let t14 = k3 * sin_theta;
            let t15 = k2 * sin_theta;
            let t16 = k2 * t14 - k3 * t15;
            let t17 = k3 * t14 + k2 * t15;
            let t18 = T::from_f64(1.0) - cos_phi;
            let t19 = k16 * t18;
            let t20 = k7 * t19;
            let t21 = k8 * t19;
            let t22 = cos_phi + k17 * t18;
            let t23 = cos_phi + k15 * t18;
            let t24 = t20 + k8 * t22;
            let t25 = k7 * t22 - t21;
            let t26 = k8 * t23 - t20;
            let t27 = t21 + k7 * t23;
            let t28 = k7 * sin_phi;
            let t29 = t24 * t1 + t28 * t2 + t25 * t5;
            let t30 = t24 * t12 + t28 * t4 + t25 * t13;
            let t31 = k8 * sin_phi;
            let t32 = k7 * t31 - k8 * t28;
            let t33 = k8 * t31 + k7 * t28;
            let t34 = T::from_f64(0.4) + t1 * t32 + cos_phi * t2 - t5 * t33;
            let t35 = t2 * t31 + t5 * t26 - t1 * t27;
            let t36 = t31 * t4 + t26 * t13 - t27 * t12;
            let t37 = T::from_f64(0.4) + t32 * t12 + cos_phi * t4 - t33 * t13;
            let t38 = T::from_f64(1.0) - cos_theta;
            let t39 = cos_theta + k5 * t38;
            let t40 = cos_theta + k6 * t38;
            let t41 = k4 * t38;
            let t42 = k2 * t41;
            let t43 = k3 * t39 - t42;
            let t44 = k3 * t41;
            let t45 = k2 * t39 + t44;
            ::pendulum_core::nalgebra::SVector::from([
                T::from_f64(0.8) + t16 * t29 + cos_theta * t34 - t17 * t35,
                t14 * t34 + t35 * t43 - t29 * t45,
                t29 * (t42 + k3 * t40) + t15 * t34 + t35 * (k2 * t40 - t44),
                T::from_f64(0.8) + t16 * t30 + cos_theta * t37 - t17 * t36,
                t14 * t37 + t43 * t36 - t45 * t30,
            ])
        }
        ///The rate of `gap` along the motion.
        #[inline]
        pub fn gap_rate(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 5> {
            let [q_theta, q_phi, q_psi, qd_theta] = x.data.0[0];
            let k2 = self.constants[2];
            let k3 = self.constants[3];
            let k4 = self.constants[4];
            let k5 = self.constants[5];
            let k6 = self.constants[6];
            let k7 = self.constants[7];
            let k8 = self.constants[8];
            let k10 = self.constants[10];
            let k11 = self.constants[11];
            let k12 = self.constants[12];
            let k13 = self.constants[13];
            let k14 = self.constants[14];
            let k15 = self.constants[15];
            let k16 = self.constants[16];
            let k17 = self.constants[17];
            let k18 = self.constants[18];
            let k19 = self.constants[19];
            let k20 = self.constants[20];
            let k21 = self.constants[21];
            let k22 = self.constants[22];
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
            let k37 = self.constants[37];
            let k38 = self.constants[38];
            let k39 = self.constants[39];
            let k40 = self.constants[40];
            let k41 = self.constants[41];
            let k42 = self.constants[42];
            let k43 = self.constants[43];
            let k44 = self.constants[44];
            let k45 = self.constants[45];
            let k46 = self.constants[46];
            let k83 = self.constants[83];
            let k92 = self.constants[92];
            let k96 = self.constants[96];
            let k97 = self.constants[97];
            let k98 = self.constants[98];
            let k99 = self.constants[99];
            let (sin_psi, cos_psi) = q_psi.sin_cos();
            let t0 = k2 * sin_psi;
            let t1 = T::from_f64(0.4) * t0;
            let t2 = T::from_f64(0.8) + T::from_f64(0.4) * cos_psi;
            let t3 = k3 * sin_psi;
            let t4 = t2 + (k96 * t3 - k97 * t0) + (k98 * t3 + k99 * t0);
            let t5 = T::from_f64(0.4) * t3;
            let t6 = T::from_f64(1.0) - cos_psi;
            let t7 = k4 * t6;
            let t8 = k2 * t7;
            let t9 = k3 * t7;
            let t10 = cos_psi + k6 * t6;
            let t11 = t1 + k14 * (t8 + k3 * t10) - k13 * (k2 * t10 - t9);
            let t12 = cos_psi + k5 * t6;
            let t13 = t5 - k13 * (k3 * t12 - t8) - k14 * (t9 + k2 * t12);
            let [(sin_theta, cos_theta), (sin_phi, cos_phi)] = q_theta
                .sin_cos_pair(q_phi);
            let t14 = qd_theta * cos_theta;
            let t15 = k3 * t14;
            let t16 = k2 * t14;
            let t17 = k2 * t15 - k3 * t16;
            let t18 = T::from_f64(1.0) - cos_phi;
            let t19 = k16 * t18;
            let t20 = k7 * t19;
            let t21 = k8 * t19;
            let t22 = cos_phi + k17 * t18;
            let t23 = cos_phi + k15 * t18;
            let t24 = t20 + k8 * t22;
            let t25 = k7 * t22 - t21;
            let t26 = k8 * t23 - t20;
            let t27 = t21 + k7 * t23;
            let t28 = k7 * sin_phi;
            let t29 = t24 * t1 + t28 * t2 + t25 * t5;
            let t30 = k3 * sin_theta;
            let t31 = k2 * sin_theta;
            let t32 = k2 * t30 - k3 * t31;
            let t33 = k42 * sin_theta;
            let t34 = k45 - (k16 - k43 * cos_theta);
            let t35 = k43 + k45 * cos_theta;
            let t36 = k44 * cos_theta - k46;
            let t37 = k12 * sin_theta;
            let t38 = k2 * cos_theta;
            let t39 = sin_phi * t37 - cos_phi * t38;
            let t40 = cos_phi * t33 + sin_phi * (cos_psi * t34 + t35)
                + sin_psi * (cos_phi * t36 + t39);
            let t41 = k4 * cos_theta;
            let t42 = k41 * sin_theta;
            let t43 = sin_psi * (sin_phi * t42 + cos_phi * (t34 - t41) + t35 - k4)
                + cos_psi * (sin_phi * (t36 - t38) - cos_phi * t37);
            let t44 = sin_phi * t41 + cos_phi * t42;
            let t45 = sin_psi * (t33 - t44) - cos_psi * t39;
            let t46 = t40 - cos_psi * t44;
            let t47 = k41 * cos_theta;
            let t48 = k4 * sin_theta;
            let t49 = sin_phi * t47 + cos_phi * t48;
            let t50 = k12 * cos_theta;
            let t51 = cos_phi * t50 - sin_phi * t31;
            let t52 = sin_psi * (k42 * sin_phi - t28 - t49)
                + cos_psi * (k10 * cos_phi + t51);
            let t53 = k39 + k36 * cos_theta;
            let t54 = k25 * sin_theta;
            let t55 = k18 * sin_theta;
            let t56 = k40 + (k34 * cos_theta - k37);
            let t57 = cos_phi * (k38 + k35 * cos_theta + cos_psi * t53 - sin_psi * t54)
                - sin_phi * (k28 * sin_theta + cos_psi * t55 + sin_psi * t56);
            let t58 = cos_psi * (k34 + cos_phi * t56 - sin_phi * t54 - k37 * cos_theta)
                - sin_psi * (cos_phi * t55 + sin_phi * t53);
            let t59 = k21 * sin_theta;
            let t60 = k20 * cos_theta;
            let t61 = sin_phi * t59 - cos_phi * t60;
            let t62 = cos_phi * sin_theta;
            let t63 = cos_theta * sin_phi;
            let t64 = k24 * sin_theta;
            let t65 = T::from_f64(0.4) * cos_theta;
            let t66 = cos_psi * (k19 * sin_theta - cos_phi * t59 - sin_phi * t60)
                + sin_psi * (sin_phi * t64 - cos_phi * t65);
            let t67 = cos_phi * t64 + sin_phi * t65;
            let t68 = sin_psi * t61 - k22 * t62 - T::from_f64(0.8) * t63 - cos_psi * t67;
            let t69 = k30 * sin_theta;
            let t70 = k26 + k31 * cos_theta;
            let t71 = k24 * cos_theta;
            let t72 = T::from_f64(0.4) * sin_theta;
            let t73 = sin_phi * t71 + cos_phi * t72;
            let t74 = cos_phi * (t71 - t70) + sin_phi * (t69 - t72) - k26 * cos_theta
                - k31;
            let t75 = sin_psi * (cos_phi * t69 + sin_phi * t70 - t73)
                + cos_phi * (k33 * cos_theta - k19 * cos_psi - k29);
            let t76 = k21 * cos_theta;
            let t77 = k20 * sin_theta;
            let t78 = cos_psi * t74 + sin_psi * (sin_phi * (k19 - t76) - cos_phi * t77);
            let t79 = cos_phi * t76 - sin_phi * t77;
            let t80 = t72 + k22 * t63 + T::from_f64(0.8) * t62
                + sin_psi * (t79 - k19 * cos_theta);
            let t81 = t80 + cos_psi * t73;
            let t82 = sin_phi * sin_theta;
            let t83 = t75 + cos_psi * t79 - k32 * t82;
            let t84 = k33 * t82
                + sin_psi * (sin_theta * (k27 - k31 * cos_phi) + t67 - k30 * t63);
            let t85 = t84 + cos_psi * t61 - t60 - k32 * (cos_theta * cos_phi);
            let t86 = t46 * t46 + t52 * t52 + t57 * t57 + t68 * t68 + t83 * t83;
            let t87 = T::from_f64(1.0) / t86;
            let t88 = k18 * cos_theta;
            let t89 = sin_theta
                * (sin_psi * (k37 - k34 * cos_phi) + sin_phi * (k83 - k36 * cos_psi));
            let t90 = t88 + t88 * (cos_phi * cos_psi) + t89
                + cos_theta * (k28 * cos_phi - k25 * (sin_psi * sin_phi));
            let t91 = k43 * sin_theta;
            let t92 = k45 * sin_theta;
            let t93 = k42 * cos_theta;
            let t94 = t91 + cos_phi * t92 + sin_phi * t93
                + cos_psi * (t92 + cos_phi * t91 - t49);
            let t95 = cos_psi * (k41 + cos_phi * (k92 + t47) - t93 - sin_phi * t48)
                + sin_psi * (sin_phi * (k11 - t50) - cos_phi * t31);
            let t96 = t94 - sin_psi * (k44 * t82 + t51);
            let t97 = k3 * t30 + k2 * t31;
            let t98 = t68 * t81 + t83 * t85 - t57 * t90 - t52 * t45 - t46 * t96;
            let t99 = t87 * t98;
            let t100 = t46 * t43 + t52 * t95 + t57 * t58 + t68 * t66 + t83 * t78;
            let t101 = t87 * t100;
            let t102 = t43 - t46 * t101;
            let t103 = t95 - t52 * t101;
            let t104 = t58 - t57 * t101;
            let t105 = t66 - t68 * t101;
            let t106 = t78 - t83 * t101;
            let t107 = t105 * (t81 - t68 * t99) + t106 * (t85 - t83 * t99)
                - t104 * (t90 + t57 * t99);
            let t108 = t107 - t103 * (t45 + t52 * t99) - t102 * (t96 + t46 * t99);
            let t109 = t102 * t102 + t103 * t103 + t104 * t104 + t105 * t105
                + t106 * t106;
            let t110 = T::from_f64(1.0) / t109 * t108;
            let t111 = qd_theta * (t99 - t101 * t110);
            let t112 = qd_theta * t110;
            let t113 = sin_phi * t111;
            let t114 = cos_phi * t111;
            let t115 = k16 * t113;
            let t116 = k7 * t115;
            let t117 = k8 * t115;
            let t118 = k17 * t113 - t113;
            let t119 = t116 + k8 * t118;
            let t120 = k7 * t118 - t117;
            let t121 = cos_psi * t112;
            let t122 = sin_psi * t112;
            let t123 = k2 * t121;
            let t124 = k3 * t121;
            let t125 = T::from_f64(0.4) * t123;
            let t126 = k7 * t114;
            let t127 = k8 * t114;
            let t128 = T::from_f64(0.4) * t124;
            let t129 = t1 * t119 + t24 * t125 + t2 * t126 + t5 * t120 + t25 * t128;
            let t130 = T::from_f64(0.4) * t122;
            let t131 = k96 * t124 - k97 * t123 + (k98 * t124 + k99 * t123) - t130;
            let t132 = t129 - t28 * t130;
            let t133 = k7 * t127 - k8 * t126;
            let t134 = k8 * sin_phi;
            let t135 = k7 * t134 - k8 * t28;
            let t136 = k8 * t127 + k7 * t126;
            let t137 = t1 * t133 + t125 * t135 - t2 * t113 - cos_phi * t130 - t5 * t136;
            let t138 = k8 * t134 + k7 * t28;
            let t139 = t137 - t128 * t138;
            let t140 = qd_theta * sin_theta;
            let t141 = T::from_f64(0.4) + t1 * t135 + cos_phi * t2 - t5 * t138;
            let t142 = k3 * t15 + k2 * t16;
            let t143 = t2 * t134 + t5 * t26 - t1 * t27;
            let t144 = t17 * t29 + t32 * t132 + cos_theta * t139 - t140 * t141
                - t142 * t143;
            let t145 = k15 * t113 - t113;
            let t146 = k8 * t145 - t116;
            let t147 = t117 + k7 * t145;
            let t148 = t2 * t127 + t5 * t146 + t128 * t26 - t130 * t134 - t1 * t147;
            let t149 = t148 - t125 * t27;
            let t150 = k5 * t140 - t140;
            let t151 = k4 * t140;
            let t152 = k2 * t151;
            let t153 = k3 * t151;
            let t154 = k2 * t150 + t153;
            let t155 = k3 * t150 - t152;
            let t156 = T::from_f64(1.0) - cos_theta;
            let t157 = cos_theta + k5 * t156;
            let t158 = k4 * t156;
            let t159 = cos_theta + k6 * t156;
            let t160 = k2 * t158;
            let t161 = k3 * t158;
            let t162 = k2 * t157 + t161;
            let t163 = k3 * t157 - t160;
            let t164 = t15 * t141 + t30 * t139 + t143 * t155 + t149 * t163 - t29 * t154;
            let t165 = k6 * t140 - t140;
            let t166 = t29 * (t152 + k3 * t165) + t132 * (t160 + k3 * t159) + t16 * t141;
            let t167 = t24 * t11 + t28 * t4 + t25 * t13;
            let t168 = k4 * t122;
            let t169 = k2 * t168;
            let t170 = k3 * t168;
            let t171 = k6 * t122 - t122;
            let t172 = t125 + k14 * (t169 + k3 * t171) - k13 * (k2 * t171 - t170);
            let t173 = t119 * t11 + t24 * t172 + t126 * t4 + t28 * t131 + t120 * t13;
            let t174 = t133 * t11 + t135 * t172 + cos_phi * t131 - t113 * t4
                - t136 * t13;
            let t175 = k5 * t122 - t122;
            let t176 = t128 - k13 * (k3 * t175 - t169) - k14 * (t170 + k2 * t175);
            let t177 = t127 * t4 + t134 * t131 + t146 * t13 + t26 * t176 - t147 * t11;
            let t178 = t173 + t25 * t176;
            let t179 = t174 - t138 * t176;
            let t180 = T::from_f64(0.4) + t135 * t11 + cos_phi * t4 - t138 * t13;
            let t181 = t134 * t4 + t26 * t13 - t27 * t11;
            let t182 = t17 * t167 + t32 * t178 + cos_theta * t179 - t140 * t180
                - t142 * t181;
            let t183 = t177 - t27 * t172;
            let t184 = t15 * t180 + t30 * t179 + t155 * t181 + t163 * t183 - t154 * t167;
            ::pendulum_core::nalgebra::SVector::from([
                t144 - t97 * t149,
                t164 - t132 * t162,
                t166 + t31 * t139 + t143 * (k2 * t165 - t153)
                    + t149 * (k2 * t159 - t161),
                t182 - t97 * t183,
                t184 - t162 * t178,
            ])
        }
        ///The value of `gap`, and its derivatives by the state: a row for each component, column by column for a matrix.
        #[inline]
        pub fn gap_and_jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 5>,
            ::pendulum_core::nalgebra::SMatrix<T, 5, 4>,
        ) {
            let [q_theta, q_phi, q_psi, _] = x.data.0[0];
            let k2 = self.constants[2];
            let k3 = self.constants[3];
            let k4 = self.constants[4];
            let k5 = self.constants[5];
            let k6 = self.constants[6];
            let k7 = self.constants[7];
            let k8 = self.constants[8];
            let k13 = self.constants[13];
            let k14 = self.constants[14];
            let k15 = self.constants[15];
            let k16 = self.constants[16];
            let k17 = self.constants[17];
            let k96 = self.constants[96];
            let k97 = self.constants[97];
            let k98 = self.constants[98];
            let k99 = self.constants[99];
            let (sin_psi, cos_psi) = q_psi.sin_cos();
            let t0 = k2 * sin_psi;
            let t1 = T::from_f64(0.4) * t0;
            let t2 = T::from_f64(0.8) + T::from_f64(0.4) * cos_psi;
            let t3 = k3 * sin_psi;
            let t4 = T::from_f64(0.4) * t3;
            let t5 = T::from_f64(1.0) - cos_psi;
            let t6 = k4 * t5;
            let t7 = k2 * t6;
            let t8 = k3 * t6;
            let t9 = cos_psi + k6 * t5;
            let t10 = t1 + k14 * (t7 + k3 * t9) - k13 * (k2 * t9 - t8);
            let t11 = cos_psi + k5 * t5;
            let t12 = t4 - k13 * (k3 * t11 - t7) - k14 * (t8 + k2 * t11);
            let t13 = k3 * t3;
            let t14 = k2 * t0;
            let t15 = t2 + (k96 * t3 - k97 * t0) + k13 * (t13 + t14);
            let t16 = t13 - sin_psi;
            let t17 = t14 - sin_psi;
            let t18 = k2 * cos_psi;
            let t19 = T::from_f64(0.4) * t18;
            let t20 = k3 * cos_psi;
            let t21 = T::from_f64(0.4) * t20;
            let t22 = T::from_f64(0.4) * sin_psi;
            let t23 = k4 * sin_psi;
            let t24 = k96 * t20 - k97 * t18 + (k98 * t20 + k99 * t18) - t22;
            let t25 = k2 * t23;
            let t26 = k3 * t23;
            let t27 = t19 + k14 * (t25 + k3 * t16) - k13 * (k2 * t16 - t26);
            let t28 = t21 - k13 * (k3 * t17 - t25) - k14 * (t26 + k2 * t17);
            let [(sin_theta, cos_theta), (sin_phi, cos_phi)] = q_theta
                .sin_cos_pair(q_phi);
            let t29 = k3 * sin_theta;
            let t30 = k2 * sin_theta;
            let t31 = k2 * t29 - k3 * t30;
            let t32 = T::from_f64(1.0) - cos_phi;
            let t33 = k16 * t32;
            let t34 = k7 * t33;
            let t35 = k8 * t33;
            let t36 = cos_phi + k17 * t32;
            let t37 = cos_phi + k15 * t32;
            let t38 = t34 + k8 * t36;
            let t39 = k7 * t36 - t35;
            let t40 = k8 * t37 - t34;
            let t41 = t35 + k7 * t37;
            let t42 = k7 * sin_phi;
            let t43 = t38 * t1 + t42 * t2 + t39 * t4;
            let t44 = k8 * sin_phi;
            let t45 = k7 * t44 - k8 * t42;
            let t46 = k8 * t44;
            let t47 = k7 * t42;
            let t48 = t46 + t47;
            let t49 = t46 - sin_phi;
            let t50 = t47 - sin_phi;
            let t51 = T::from_f64(0.4) + t1 * t45 + cos_phi * t2 - t4 * t48;
            let t52 = k3 * t29;
            let t53 = k2 * t30;
            let t54 = t52 + t53;
            let t55 = t53 - sin_theta;
            let t56 = t52 - sin_theta;
            let t57 = t2 * t44 + t4 * t40 - t1 * t41;
            let t58 = T::from_f64(0.8) + t31 * t43 + cos_theta * t51 - t54 * t57;
            let t59 = T::from_f64(1.0) - cos_theta;
            let t60 = cos_theta + k5 * t59;
            let t61 = k4 * t59;
            let t62 = cos_theta + k6 * t59;
            let t63 = k2 * t61;
            let t64 = k3 * t61;
            let t65 = k3 * t60 - t63;
            let t66 = k2 * t60 + t64;
            let t67 = t29 * t51 + t57 * t65 - t43 * t66;
            let t68 = t63 + k3 * t62;
            let t69 = k2 * t62 - t64;
            let t70 = t43 * t68 + t30 * t51 + t57 * t69;
            let t71 = t38 * t10 + t42 * t15 + t39 * t12;
            let t72 = T::from_f64(0.4) + t45 * t10 + cos_phi * t15 - t48 * t12;
            let t73 = t44 * t15 + t40 * t12 - t41 * t10;
            let t74 = T::from_f64(0.8) + t31 * t71 + cos_theta * t72 - t54 * t73;
            let t75 = t29 * t72 + t65 * t73 - t66 * t71;
            let t76 = k3 * cos_theta;
            let t77 = k2 * cos_theta;
            let t78 = k2 * t76 - k3 * t77;
            let t79 = k3 * t76 + k2 * t77;
            let t80 = t43 * t78 - sin_theta * t51 - t57 * t79;
            let t81 = t71 * t78 - sin_theta * t72 - t73 * t79;
            let t82 = k4 * sin_theta;
            let t83 = k2 * t82;
            let t84 = k3 * t82;
            let t85 = t43 * (t83 + k3 * t56) + t51 * t77 + t57 * (k2 * t56 - t84);
            let t86 = k3 * t55 - t83;
            let t87 = k2 * t55 + t84;
            let t88 = t51 * t76 + t57 * t86 - t43 * t87;
            let t89 = t72 * t76 + t73 * t86 - t71 * t87;
            let t90 = k16 * sin_phi;
            let t91 = k7 * t90;
            let t92 = k8 * t90;
            let t93 = t91 + k8 * t49;
            let t94 = k7 * t49 - t92;
            let t95 = k8 * t50 - t91;
            let t96 = t92 + k7 * t50;
            let t97 = k7 * cos_phi;
            let t98 = t1 * t93 + t2 * t97 + t4 * t94;
            let t99 = t10 * t93 + t15 * t97 + t12 * t94;
            let t100 = k8 * cos_phi;
            let t101 = k7 * t100 - k8 * t97;
            let t102 = k8 * t100 + k7 * t97;
            let t103 = t1 * t101 - sin_phi * t2 - t4 * t102;
            let t104 = t2 * t100 + t4 * t95 - t1 * t96;
            let t105 = t15 * t100 + t12 * t95 - t10 * t96;
            let t106 = t10 * t101 - sin_phi * t15 - t12 * t102;
            let t107 = t31 * t98 + cos_theta * t103 - t54 * t104;
            let t108 = t29 * t103 + t65 * t104 - t66 * t98;
            let t109 = t68 * t98 + t30 * t103 + t69 * t104;
            let t110 = t31 * t99 + cos_theta * t106 - t54 * t105;
            let t111 = t29 * t106 + t65 * t105 - t66 * t99;
            let t112 = t38 * t19 + t39 * t21 - t42 * t22;
            let t113 = t38 * t27 + t42 * t24 + t39 * t28;
            let t114 = t45 * t19 - cos_phi * t22 - t48 * t21;
            let t115 = t40 * t21 - t44 * t22 - t41 * t19;
            let t116 = t68 * t112 + t30 * t114 + t69 * t115;
            let t117 = t44 * t24 + t40 * t28 - t41 * t27;
            let t118 = t45 * t27 + cos_phi * t24 - t48 * t28;
            let t119 = t31 * t112 + cos_theta * t114 - t54 * t115;
            let t120 = t31 * t113 + cos_theta * t118 - t54 * t117;
            let t121 = t29 * t114 + t65 * t115 - t66 * t112;
            let t122 = t29 * t118 + t65 * t117 - t66 * t113;
            (
                ::pendulum_core::nalgebra::SVector::from([t58, t67, t70, t74, t75]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [t80, t88, t85, t81, t89],
                    [t107, t108, t109, t110, t111],
                    [t119, t121, t116, t120, t122],
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                    ],
                ]),
            )
        }
        ///All outputs, in the order of `OUTPUTS`.
        #[inline]
        pub fn outputs(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 5> {
            let [q_theta, q_phi, q_psi, _] = x.data.0[0];
            let k2 = self.constants[2];
            let k3 = self.constants[3];
            let k4 = self.constants[4];
            let k5 = self.constants[5];
            let k6 = self.constants[6];
            let k7 = self.constants[7];
            let k8 = self.constants[8];
            let k13 = self.constants[13];
            let k14 = self.constants[14];
            let k15 = self.constants[15];
            let k16 = self.constants[16];
            let k17 = self.constants[17];
            let k96 = self.constants[96];
            let k97 = self.constants[97];
            let k98 = self.constants[98];
            let k99 = self.constants[99];
            let (sin_psi, cos_psi) = q_psi.sin_cos();
            let t0 = k2 * sin_psi;
            let t1 = T::from_f64(0.4) * t0;
            let t2 = T::from_f64(0.8) + T::from_f64(0.4) * cos_psi;
            let t3 = k3 * sin_psi;
            let t4 = t2 + (k96 * t3 - k97 * t0) + (k98 * t3 + k99 * t0);
            let t5 = T::from_f64(0.4) * t3;
            let t6 = T::from_f64(1.0) - cos_psi;
            let t7 = k4 * t6;
            let t8 = k2 * t7;
            let t9 = k3 * t7;
            let t10 = cos_psi + k6 * t6;
            let t11 = cos_psi + k5 * t6;
            let t12 = t1 + k14 * (t8 + k3 * t10) - k13 * (k2 * t10 - t9);
            let t13 = t5 - k13 * (k3 * t11 - t8) - k14 * (t9 + k2 * t11);
            let [(sin_theta, cos_theta), (sin_phi, cos_phi)] = q_theta
                .sin_cos_pair(q_phi);
            let t14 = k3 * sin_theta;
            let t15 = k2 * sin_theta;
            let t16 = k2 * t14 - k3 * t15;
            let t17 = k3 * t14 + k2 * t15;
            let t18 = T::from_f64(1.0) - cos_phi;
            let t19 = k16 * t18;
            let t20 = k7 * t19;
            let t21 = k8 * t19;
            let t22 = cos_phi + k17 * t18;
            let t23 = cos_phi + k15 * t18;
            let t24 = t20 + k8 * t22;
            let t25 = k7 * t22 - t21;
            let t26 = k8 * t23 - t20;
            let t27 = t21 + k7 * t23;
            let t28 = k7 * sin_phi;
            let t29 = t24 * t1 + t28 * t2 + t25 * t5;
            let t30 = t24 * t12 + t28 * t4 + t25 * t13;
            let t31 = k8 * sin_phi;
            let t32 = k7 * t31 - k8 * t28;
            let t33 = k8 * t31 + k7 * t28;
            let t34 = T::from_f64(0.4) + t1 * t32 + cos_phi * t2 - t5 * t33;
            let t35 = t2 * t31 + t5 * t26 - t1 * t27;
            let t36 = t31 * t4 + t26 * t13 - t27 * t12;
            let t37 = T::from_f64(0.4) + t32 * t12 + cos_phi * t4 - t33 * t13;
            let t38 = T::from_f64(1.0) - cos_theta;
            let t39 = cos_theta + k5 * t38;
            let t40 = cos_theta + k6 * t38;
            let t41 = k4 * t38;
            let t42 = k2 * t41;
            let t43 = k3 * t39 - t42;
            let t44 = k3 * t41;
            let t45 = k2 * t39 + t44;
            ::pendulum_core::nalgebra::SVector::from([
                T::from_f64(0.8) + t16 * t29 + cos_theta * t34 - t17 * t35,
                t14 * t34 + t35 * t43 - t29 * t45,
                t29 * (t42 + k3 * t40) + t15 * t34 + t35 * (k2 * t40 - t44),
                T::from_f64(0.8) + t16 * t30 + cos_theta * t37 - t17 * t36,
                t14 * t37 + t43 * t36 - t45 * t30,
            ])
        }
        ///The rate of all outputs along the motion.
        #[inline]
        pub fn output_rates(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 5> {
            let [q_theta, q_phi, q_psi, qd_theta] = x.data.0[0];
            let k2 = self.constants[2];
            let k3 = self.constants[3];
            let k4 = self.constants[4];
            let k5 = self.constants[5];
            let k6 = self.constants[6];
            let k7 = self.constants[7];
            let k8 = self.constants[8];
            let k10 = self.constants[10];
            let k11 = self.constants[11];
            let k12 = self.constants[12];
            let k13 = self.constants[13];
            let k14 = self.constants[14];
            let k15 = self.constants[15];
            let k16 = self.constants[16];
            let k17 = self.constants[17];
            let k18 = self.constants[18];
            let k19 = self.constants[19];
            let k20 = self.constants[20];
            let k21 = self.constants[21];
            let k22 = self.constants[22];
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
            let k37 = self.constants[37];
            let k38 = self.constants[38];
            let k39 = self.constants[39];
            let k40 = self.constants[40];
            let k41 = self.constants[41];
            let k42 = self.constants[42];
            let k43 = self.constants[43];
            let k44 = self.constants[44];
            let k45 = self.constants[45];
            let k46 = self.constants[46];
            let k83 = self.constants[83];
            let k92 = self.constants[92];
            let k96 = self.constants[96];
            let k97 = self.constants[97];
            let k98 = self.constants[98];
            let k99 = self.constants[99];
            let (sin_psi, cos_psi) = q_psi.sin_cos();
            let t0 = k2 * sin_psi;
            let t1 = T::from_f64(0.4) * t0;
            let t2 = T::from_f64(0.8) + T::from_f64(0.4) * cos_psi;
            let t3 = k3 * sin_psi;
            let t4 = t2 + (k96 * t3 - k97 * t0) + (k98 * t3 + k99 * t0);
            let t5 = T::from_f64(0.4) * t3;
            let t6 = T::from_f64(1.0) - cos_psi;
            let t7 = k4 * t6;
            let t8 = k2 * t7;
            let t9 = k3 * t7;
            let t10 = cos_psi + k6 * t6;
            let t11 = t1 + k14 * (t8 + k3 * t10) - k13 * (k2 * t10 - t9);
            let t12 = cos_psi + k5 * t6;
            let t13 = t5 - k13 * (k3 * t12 - t8) - k14 * (t9 + k2 * t12);
            let [(sin_theta, cos_theta), (sin_phi, cos_phi)] = q_theta
                .sin_cos_pair(q_phi);
            let t14 = qd_theta * cos_theta;
            let t15 = k3 * t14;
            let t16 = k2 * t14;
            let t17 = k2 * t15 - k3 * t16;
            let t18 = T::from_f64(1.0) - cos_phi;
            let t19 = k16 * t18;
            let t20 = k7 * t19;
            let t21 = k8 * t19;
            let t22 = cos_phi + k17 * t18;
            let t23 = cos_phi + k15 * t18;
            let t24 = t20 + k8 * t22;
            let t25 = k7 * t22 - t21;
            let t26 = k8 * t23 - t20;
            let t27 = t21 + k7 * t23;
            let t28 = k7 * sin_phi;
            let t29 = t24 * t1 + t28 * t2 + t25 * t5;
            let t30 = k3 * sin_theta;
            let t31 = k2 * sin_theta;
            let t32 = k2 * t30 - k3 * t31;
            let t33 = k42 * sin_theta;
            let t34 = k45 - (k16 - k43 * cos_theta);
            let t35 = k43 + k45 * cos_theta;
            let t36 = k44 * cos_theta - k46;
            let t37 = k12 * sin_theta;
            let t38 = k2 * cos_theta;
            let t39 = sin_phi * t37 - cos_phi * t38;
            let t40 = cos_phi * t33 + sin_phi * (cos_psi * t34 + t35)
                + sin_psi * (cos_phi * t36 + t39);
            let t41 = k4 * cos_theta;
            let t42 = k41 * sin_theta;
            let t43 = sin_psi * (sin_phi * t42 + cos_phi * (t34 - t41) + t35 - k4)
                + cos_psi * (sin_phi * (t36 - t38) - cos_phi * t37);
            let t44 = sin_phi * t41 + cos_phi * t42;
            let t45 = sin_psi * (t33 - t44) - cos_psi * t39;
            let t46 = t40 - cos_psi * t44;
            let t47 = k41 * cos_theta;
            let t48 = k4 * sin_theta;
            let t49 = sin_phi * t47 + cos_phi * t48;
            let t50 = k12 * cos_theta;
            let t51 = cos_phi * t50 - sin_phi * t31;
            let t52 = sin_psi * (k42 * sin_phi - t28 - t49)
                + cos_psi * (k10 * cos_phi + t51);
            let t53 = k39 + k36 * cos_theta;
            let t54 = k25 * sin_theta;
            let t55 = k18 * sin_theta;
            let t56 = k40 + (k34 * cos_theta - k37);
            let t57 = cos_phi * (k38 + k35 * cos_theta + cos_psi * t53 - sin_psi * t54)
                - sin_phi * (k28 * sin_theta + cos_psi * t55 + sin_psi * t56);
            let t58 = cos_psi * (k34 + cos_phi * t56 - sin_phi * t54 - k37 * cos_theta)
                - sin_psi * (cos_phi * t55 + sin_phi * t53);
            let t59 = k21 * sin_theta;
            let t60 = k20 * cos_theta;
            let t61 = sin_phi * t59 - cos_phi * t60;
            let t62 = cos_phi * sin_theta;
            let t63 = cos_theta * sin_phi;
            let t64 = k24 * sin_theta;
            let t65 = T::from_f64(0.4) * cos_theta;
            let t66 = cos_psi * (k19 * sin_theta - cos_phi * t59 - sin_phi * t60)
                + sin_psi * (sin_phi * t64 - cos_phi * t65);
            let t67 = cos_phi * t64 + sin_phi * t65;
            let t68 = sin_psi * t61 - k22 * t62 - T::from_f64(0.8) * t63 - cos_psi * t67;
            let t69 = k30 * sin_theta;
            let t70 = k26 + k31 * cos_theta;
            let t71 = k24 * cos_theta;
            let t72 = T::from_f64(0.4) * sin_theta;
            let t73 = sin_phi * t71 + cos_phi * t72;
            let t74 = cos_phi * (t71 - t70) + sin_phi * (t69 - t72) - k26 * cos_theta
                - k31;
            let t75 = sin_psi * (cos_phi * t69 + sin_phi * t70 - t73)
                + cos_phi * (k33 * cos_theta - k19 * cos_psi - k29);
            let t76 = k21 * cos_theta;
            let t77 = k20 * sin_theta;
            let t78 = cos_psi * t74 + sin_psi * (sin_phi * (k19 - t76) - cos_phi * t77);
            let t79 = cos_phi * t76 - sin_phi * t77;
            let t80 = t72 + k22 * t63 + T::from_f64(0.8) * t62
                + sin_psi * (t79 - k19 * cos_theta);
            let t81 = t80 + cos_psi * t73;
            let t82 = sin_phi * sin_theta;
            let t83 = t75 + cos_psi * t79 - k32 * t82;
            let t84 = k33 * t82
                + sin_psi * (sin_theta * (k27 - k31 * cos_phi) + t67 - k30 * t63);
            let t85 = t84 + cos_psi * t61 - t60 - k32 * (cos_theta * cos_phi);
            let t86 = t46 * t46 + t52 * t52 + t57 * t57 + t68 * t68 + t83 * t83;
            let t87 = T::from_f64(1.0) / t86;
            let t88 = k18 * cos_theta;
            let t89 = sin_theta
                * (sin_psi * (k37 - k34 * cos_phi) + sin_phi * (k83 - k36 * cos_psi));
            let t90 = t88 + t88 * (cos_phi * cos_psi) + t89
                + cos_theta * (k28 * cos_phi - k25 * (sin_psi * sin_phi));
            let t91 = k43 * sin_theta;
            let t92 = k45 * sin_theta;
            let t93 = k42 * cos_theta;
            let t94 = t91 + cos_phi * t92 + sin_phi * t93
                + cos_psi * (t92 + cos_phi * t91 - t49);
            let t95 = cos_psi * (k41 + cos_phi * (k92 + t47) - t93 - sin_phi * t48)
                + sin_psi * (sin_phi * (k11 - t50) - cos_phi * t31);
            let t96 = t94 - sin_psi * (k44 * t82 + t51);
            let t97 = k3 * t30 + k2 * t31;
            let t98 = t68 * t81 + t83 * t85 - t57 * t90 - t52 * t45 - t46 * t96;
            let t99 = t87 * t98;
            let t100 = t46 * t43 + t52 * t95 + t57 * t58 + t68 * t66 + t83 * t78;
            let t101 = t87 * t100;
            let t102 = t43 - t46 * t101;
            let t103 = t95 - t52 * t101;
            let t104 = t58 - t57 * t101;
            let t105 = t66 - t68 * t101;
            let t106 = t78 - t83 * t101;
            let t107 = t105 * (t81 - t68 * t99) + t106 * (t85 - t83 * t99)
                - t104 * (t90 + t57 * t99);
            let t108 = t107 - t103 * (t45 + t52 * t99) - t102 * (t96 + t46 * t99);
            let t109 = t102 * t102 + t103 * t103 + t104 * t104 + t105 * t105
                + t106 * t106;
            let t110 = T::from_f64(1.0) / t109 * t108;
            let t111 = qd_theta * (t99 - t101 * t110);
            let t112 = qd_theta * t110;
            let t113 = sin_phi * t111;
            let t114 = cos_phi * t111;
            let t115 = k16 * t113;
            let t116 = k7 * t115;
            let t117 = k8 * t115;
            let t118 = k17 * t113 - t113;
            let t119 = t116 + k8 * t118;
            let t120 = k7 * t118 - t117;
            let t121 = cos_psi * t112;
            let t122 = sin_psi * t112;
            let t123 = k2 * t121;
            let t124 = k3 * t121;
            let t125 = T::from_f64(0.4) * t123;
            let t126 = k7 * t114;
            let t127 = k8 * t114;
            let t128 = T::from_f64(0.4) * t124;
            let t129 = t1 * t119 + t24 * t125 + t2 * t126 + t5 * t120 + t25 * t128;
            let t130 = T::from_f64(0.4) * t122;
            let t131 = k96 * t124 - k97 * t123 + (k98 * t124 + k99 * t123) - t130;
            let t132 = t129 - t28 * t130;
            let t133 = k7 * t127 - k8 * t126;
            let t134 = k8 * sin_phi;
            let t135 = k7 * t134 - k8 * t28;
            let t136 = k8 * t127 + k7 * t126;
            let t137 = t1 * t133 + t125 * t135 - t2 * t113 - cos_phi * t130 - t5 * t136;
            let t138 = k8 * t134 + k7 * t28;
            let t139 = t137 - t128 * t138;
            let t140 = qd_theta * sin_theta;
            let t141 = T::from_f64(0.4) + t1 * t135 + cos_phi * t2 - t5 * t138;
            let t142 = k3 * t15 + k2 * t16;
            let t143 = t2 * t134 + t5 * t26 - t1 * t27;
            let t144 = t17 * t29 + t32 * t132 + cos_theta * t139 - t140 * t141
                - t142 * t143;
            let t145 = k15 * t113 - t113;
            let t146 = k8 * t145 - t116;
            let t147 = t117 + k7 * t145;
            let t148 = t2 * t127 + t5 * t146 + t128 * t26 - t130 * t134 - t1 * t147;
            let t149 = t148 - t125 * t27;
            let t150 = k5 * t140 - t140;
            let t151 = k4 * t140;
            let t152 = k2 * t151;
            let t153 = k3 * t151;
            let t154 = k2 * t150 + t153;
            let t155 = k3 * t150 - t152;
            let t156 = T::from_f64(1.0) - cos_theta;
            let t157 = cos_theta + k5 * t156;
            let t158 = k4 * t156;
            let t159 = cos_theta + k6 * t156;
            let t160 = k2 * t158;
            let t161 = k3 * t158;
            let t162 = k2 * t157 + t161;
            let t163 = k3 * t157 - t160;
            let t164 = t15 * t141 + t30 * t139 + t143 * t155 + t149 * t163 - t29 * t154;
            let t165 = k6 * t140 - t140;
            let t166 = t29 * (t152 + k3 * t165) + t132 * (t160 + k3 * t159) + t16 * t141;
            let t167 = t24 * t11 + t28 * t4 + t25 * t13;
            let t168 = k4 * t122;
            let t169 = k2 * t168;
            let t170 = k3 * t168;
            let t171 = k6 * t122 - t122;
            let t172 = t125 + k14 * (t169 + k3 * t171) - k13 * (k2 * t171 - t170);
            let t173 = t119 * t11 + t24 * t172 + t126 * t4 + t28 * t131 + t120 * t13;
            let t174 = t133 * t11 + t135 * t172 + cos_phi * t131 - t113 * t4
                - t136 * t13;
            let t175 = k5 * t122 - t122;
            let t176 = t128 - k13 * (k3 * t175 - t169) - k14 * (t170 + k2 * t175);
            let t177 = t127 * t4 + t134 * t131 + t146 * t13 + t26 * t176 - t147 * t11;
            let t178 = t173 + t25 * t176;
            let t179 = t174 - t138 * t176;
            let t180 = T::from_f64(0.4) + t135 * t11 + cos_phi * t4 - t138 * t13;
            let t181 = t134 * t4 + t26 * t13 - t27 * t11;
            let t182 = t17 * t167 + t32 * t178 + cos_theta * t179 - t140 * t180
                - t142 * t181;
            let t183 = t177 - t27 * t172;
            let t184 = t15 * t180 + t30 * t179 + t155 * t181 + t163 * t183 - t154 * t167;
            ::pendulum_core::nalgebra::SVector::from([
                t144 - t97 * t149,
                t164 - t132 * t162,
                t166 + t31 * t139 + t143 * (k2 * t165 - t153)
                    + t149 * (k2 * t159 - t161),
                t182 - t97 * t183,
                t184 - t162 * t178,
            ])
        }
        ///The value of all outputs, and its derivatives by the state: a row for each component, column by column for a matrix.
        #[inline]
        pub fn outputs_and_jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 4>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 5>,
            ::pendulum_core::nalgebra::SMatrix<T, 5, 4>,
        ) {
            let [q_theta, q_phi, q_psi, _] = x.data.0[0];
            let k2 = self.constants[2];
            let k3 = self.constants[3];
            let k4 = self.constants[4];
            let k5 = self.constants[5];
            let k6 = self.constants[6];
            let k7 = self.constants[7];
            let k8 = self.constants[8];
            let k13 = self.constants[13];
            let k14 = self.constants[14];
            let k15 = self.constants[15];
            let k16 = self.constants[16];
            let k17 = self.constants[17];
            let k96 = self.constants[96];
            let k97 = self.constants[97];
            let k98 = self.constants[98];
            let k99 = self.constants[99];
            let (sin_psi, cos_psi) = q_psi.sin_cos();
            let t0 = k2 * sin_psi;
            let t1 = T::from_f64(0.4) * t0;
            let t2 = T::from_f64(0.8) + T::from_f64(0.4) * cos_psi;
            let t3 = k3 * sin_psi;
            let t4 = T::from_f64(0.4) * t3;
            let t5 = T::from_f64(1.0) - cos_psi;
            let t6 = k4 * t5;
            let t7 = k2 * t6;
            let t8 = k3 * t6;
            let t9 = cos_psi + k6 * t5;
            let t10 = t1 + k14 * (t7 + k3 * t9) - k13 * (k2 * t9 - t8);
            let t11 = cos_psi + k5 * t5;
            let t12 = t4 - k13 * (k3 * t11 - t7) - k14 * (t8 + k2 * t11);
            let t13 = k3 * t3;
            let t14 = k2 * t0;
            let t15 = t2 + (k96 * t3 - k97 * t0) + k13 * (t13 + t14);
            let t16 = t13 - sin_psi;
            let t17 = t14 - sin_psi;
            let t18 = k2 * cos_psi;
            let t19 = T::from_f64(0.4) * t18;
            let t20 = k3 * cos_psi;
            let t21 = T::from_f64(0.4) * t20;
            let t22 = T::from_f64(0.4) * sin_psi;
            let t23 = k4 * sin_psi;
            let t24 = k96 * t20 - k97 * t18 + (k98 * t20 + k99 * t18) - t22;
            let t25 = k2 * t23;
            let t26 = k3 * t23;
            let t27 = t19 + k14 * (t25 + k3 * t16) - k13 * (k2 * t16 - t26);
            let t28 = t21 - k13 * (k3 * t17 - t25) - k14 * (t26 + k2 * t17);
            let [(sin_theta, cos_theta), (sin_phi, cos_phi)] = q_theta
                .sin_cos_pair(q_phi);
            let t29 = k3 * sin_theta;
            let t30 = k2 * sin_theta;
            let t31 = k2 * t29 - k3 * t30;
            let t32 = T::from_f64(1.0) - cos_phi;
            let t33 = k16 * t32;
            let t34 = k7 * t33;
            let t35 = k8 * t33;
            let t36 = cos_phi + k17 * t32;
            let t37 = cos_phi + k15 * t32;
            let t38 = t34 + k8 * t36;
            let t39 = k7 * t36 - t35;
            let t40 = k8 * t37 - t34;
            let t41 = t35 + k7 * t37;
            let t42 = k7 * sin_phi;
            let t43 = t38 * t1 + t42 * t2 + t39 * t4;
            let t44 = k8 * sin_phi;
            let t45 = k7 * t44 - k8 * t42;
            let t46 = k8 * t44;
            let t47 = k7 * t42;
            let t48 = t46 + t47;
            let t49 = t46 - sin_phi;
            let t50 = t47 - sin_phi;
            let t51 = T::from_f64(0.4) + t1 * t45 + cos_phi * t2 - t4 * t48;
            let t52 = k3 * t29;
            let t53 = k2 * t30;
            let t54 = t52 + t53;
            let t55 = t53 - sin_theta;
            let t56 = t52 - sin_theta;
            let t57 = t2 * t44 + t4 * t40 - t1 * t41;
            let t58 = T::from_f64(0.8) + t31 * t43 + cos_theta * t51 - t54 * t57;
            let t59 = T::from_f64(1.0) - cos_theta;
            let t60 = cos_theta + k5 * t59;
            let t61 = k4 * t59;
            let t62 = cos_theta + k6 * t59;
            let t63 = k2 * t61;
            let t64 = k3 * t61;
            let t65 = k3 * t60 - t63;
            let t66 = k2 * t60 + t64;
            let t67 = t29 * t51 + t57 * t65 - t43 * t66;
            let t68 = t63 + k3 * t62;
            let t69 = k2 * t62 - t64;
            let t70 = t43 * t68 + t30 * t51 + t57 * t69;
            let t71 = t38 * t10 + t42 * t15 + t39 * t12;
            let t72 = T::from_f64(0.4) + t45 * t10 + cos_phi * t15 - t48 * t12;
            let t73 = t44 * t15 + t40 * t12 - t41 * t10;
            let t74 = T::from_f64(0.8) + t31 * t71 + cos_theta * t72 - t54 * t73;
            let t75 = t29 * t72 + t65 * t73 - t66 * t71;
            let t76 = k3 * cos_theta;
            let t77 = k2 * cos_theta;
            let t78 = k2 * t76 - k3 * t77;
            let t79 = k3 * t76 + k2 * t77;
            let t80 = t43 * t78 - sin_theta * t51 - t57 * t79;
            let t81 = t71 * t78 - sin_theta * t72 - t73 * t79;
            let t82 = k4 * sin_theta;
            let t83 = k2 * t82;
            let t84 = k3 * t82;
            let t85 = t43 * (t83 + k3 * t56) + t51 * t77 + t57 * (k2 * t56 - t84);
            let t86 = k3 * t55 - t83;
            let t87 = k2 * t55 + t84;
            let t88 = t51 * t76 + t57 * t86 - t43 * t87;
            let t89 = t72 * t76 + t73 * t86 - t71 * t87;
            let t90 = k16 * sin_phi;
            let t91 = k7 * t90;
            let t92 = k8 * t90;
            let t93 = t91 + k8 * t49;
            let t94 = k7 * t49 - t92;
            let t95 = k8 * t50 - t91;
            let t96 = t92 + k7 * t50;
            let t97 = k7 * cos_phi;
            let t98 = t1 * t93 + t2 * t97 + t4 * t94;
            let t99 = t10 * t93 + t15 * t97 + t12 * t94;
            let t100 = k8 * cos_phi;
            let t101 = k7 * t100 - k8 * t97;
            let t102 = k8 * t100 + k7 * t97;
            let t103 = t1 * t101 - sin_phi * t2 - t4 * t102;
            let t104 = t2 * t100 + t4 * t95 - t1 * t96;
            let t105 = t15 * t100 + t12 * t95 - t10 * t96;
            let t106 = t10 * t101 - sin_phi * t15 - t12 * t102;
            let t107 = t31 * t98 + cos_theta * t103 - t54 * t104;
            let t108 = t29 * t103 + t65 * t104 - t66 * t98;
            let t109 = t68 * t98 + t30 * t103 + t69 * t104;
            let t110 = t31 * t99 + cos_theta * t106 - t54 * t105;
            let t111 = t29 * t106 + t65 * t105 - t66 * t99;
            let t112 = t38 * t19 + t39 * t21 - t42 * t22;
            let t113 = t38 * t27 + t42 * t24 + t39 * t28;
            let t114 = t45 * t19 - cos_phi * t22 - t48 * t21;
            let t115 = t40 * t21 - t44 * t22 - t41 * t19;
            let t116 = t68 * t112 + t30 * t114 + t69 * t115;
            let t117 = t44 * t24 + t40 * t28 - t41 * t27;
            let t118 = t45 * t27 + cos_phi * t24 - t48 * t28;
            let t119 = t31 * t112 + cos_theta * t114 - t54 * t115;
            let t120 = t31 * t113 + cos_theta * t118 - t54 * t117;
            let t121 = t29 * t114 + t65 * t115 - t66 * t112;
            let t122 = t29 * t118 + t65 * t117 - t66 * t113;
            (
                ::pendulum_core::nalgebra::SVector::from([t58, t67, t70, t74, t75]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [t80, t88, t85, t81, t89],
                    [t107, t108, t109, t110, t111],
                    [t119, t121, t116, t120, t122],
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                    ],
                ]),
            )
        }
        /// A state whose loops are closed, from one in which the coordinates that follow are guesses.
        ///
        /// # Errors
        /// If Newton's method finds no such state near the guess, with the loop that is open the furthest.
        pub fn assemble(
            &self,
            t: T,
            near: impl ::pendulum_core::IntoState<T, 4>,
        ) -> ::core::result::Result<
            ::pendulum_core::nalgebra::SVector<T, 4>,
            ::pendulum_core::NotAssembled,
        >
        where
            T: ::pendulum_core::Float,
        {
            ::pendulum_core::system::assemble(
                near.into_state(),
                &<Bennett>::LAYOUT,
                [1, 2],
                |x| self.loop_corrections(t, x),
                |x, tell| <Self as ::pendulum_core::System<T, 4>>::gaps(self, t, x, tell),
            )
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::shapes::Shapes<4> for Bennett {
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
                        name: "frame",
                        kind: ::pendulum_core::shapes::ShapeKind::Rod,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "frame",
                        kind: ::pendulum_core::shapes::ShapeKind::Cylinder,
                        points: 2,
                        radius: true,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "first",
                        kind: ::pendulum_core::shapes::ShapeKind::Rod,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "first",
                        kind: ::pendulum_core::shapes::ShapeKind::Cylinder,
                        points: 2,
                        radius: true,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "second",
                        kind: ::pendulum_core::shapes::ShapeKind::Rod,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "second",
                        kind: ::pendulum_core::shapes::ShapeKind::Cylinder,
                        points: 2,
                        radius: true,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "third",
                        kind: ::pendulum_core::shapes::ShapeKind::Rod,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "third",
                        kind: ::pendulum_core::shapes::ShapeKind::Cylinder,
                        points: 2,
                        radius: true,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "first",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "second",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "third",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "third",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "middle",
                        kind: ::pendulum_core::shapes::ShapeKind::Point,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "corner",
                        kind: ::pendulum_core::shapes::ShapeKind::Point,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "end",
                        kind: ::pendulum_core::shapes::ShapeKind::Point,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "pin",
                        kind: ::pendulum_core::shapes::ShapeKind::Point,
                        points: 1,
                        radius: false,
                    },
                ],
                &{
                    let [q_theta, q_phi, q_psi, _] = x.data.0[0];
                    let k2 = self.constants[2];
                    let k3 = self.constants[3];
                    let k4 = self.constants[4];
                    let k5 = self.constants[5];
                    let k6 = self.constants[6];
                    let k7 = self.constants[7];
                    let k8 = self.constants[8];
                    let k13 = self.constants[13];
                    let k14 = self.constants[14];
                    let k15 = self.constants[15];
                    let k16 = self.constants[16];
                    let k17 = self.constants[17];
                    let k98 = self.constants[98];
                    let k99 = self.constants[99];
                    let (sin_psi, cos_psi) = q_psi.sin_cos();
                    let t0 = k2 * sin_psi;
                    let t1 = T::from_f64(0.4) * t0;
                    let t2 = T::from_f64(0.8) + T::from_f64(0.4) * cos_psi;
                    let t3 = k3 * sin_psi;
                    let t4 = T::from_f64(0.4) * t3;
                    let t5 = k2 * t3 - k3 * t0;
                    let t6 = t2 + k14 * t5 + (k98 * t3 + k99 * t0);
                    let t7 = T::from_f64(0.08) * t5;
                    let t8 = T::from_f64(0.8) - t7;
                    let t9 = T::from_f64(0.8) + t7;
                    let t10 = T::from_f64(1.0) - cos_psi;
                    let t11 = cos_psi + k5 * t10;
                    let t12 = cos_psi + k6 * t10;
                    let t13 = k4 * t10;
                    let t14 = k3 * t13;
                    let t15 = k2 * t13;
                    let t16 = k2 * t11 + t14;
                    let t17 = t4 - k13 * (k3 * t11 - t15) - k14 * t16;
                    let t18 = T::from_f64(0.08) * t16;
                    let t19 = t15 + k3 * t12;
                    let t20 = t1 + k14 * t19 - k13 * (k2 * t12 - t14);
                    let t21 = T::from_f64(0.08) * t19;
                    let [(sin_theta, cos_theta), (sin_phi, cos_phi)] = q_theta
                        .sin_cos_pair(q_phi);
                    let t22 = T::from_f64(0.8) + T::from_f64(0.4) * cos_theta;
                    let t23 = k3 * sin_theta;
                    let t24 = T::from_f64(0.4) * t23;
                    let t25 = k2 * sin_theta;
                    let t26 = T::from_f64(0.4) * t25;
                    let t27 = k2 * t23 - k3 * t25;
                    let t28 = T::from_f64(0.08) * t27;
                    let t29 = T::from_f64(0.8) - t28;
                    let t30 = T::from_f64(0.8) + t28;
                    let t31 = T::from_f64(1.0) - cos_theta;
                    let t32 = cos_theta + k5 * t31;
                    let t33 = k4 * t31;
                    let t34 = cos_theta + k6 * t31;
                    let t35 = k3 * t33;
                    let t36 = k2 * t33;
                    let t37 = k2 * t32 + t35;
                    let t38 = T::from_f64(0.08) * t37;
                    let t39 = T::from_f64(-0.08) * t37;
                    let t40 = k3 * t32 - t36;
                    let t41 = t36 + k3 * t34;
                    let t42 = k2 * t34 - t35;
                    let t43 = T::from_f64(-0.08) * t41;
                    let t44 = T::from_f64(0.08) * t41;
                    let t45 = k7 * sin_phi;
                    let t46 = T::from_f64(0.8) * t45;
                    let t47 = T::from_f64(0.4) + T::from_f64(0.8) * cos_phi;
                    let t48 = k3 * t23 + k2 * t25;
                    let t49 = k8 * sin_phi;
                    let t50 = T::from_f64(0.8) * t49;
                    let t51 = T::from_f64(0.8) + t27 * t46 + cos_theta * t47 - t48 * t50;
                    let t52 = t23 * t47 + t50 * t40 - t37 * t46;
                    let t53 = t41 * t46 + t25 * t47 + t50 * t42;
                    let t54 = k7 * t49 - k8 * t45;
                    let t55 = T::from_f64(0.08) * t54;
                    let t56 = T::from_f64(0.4) - t55;
                    let t57 = T::from_f64(0.4) + t55;
                    let t58 = T::from_f64(1.0) - cos_phi;
                    let t59 = cos_phi + k15 * t58;
                    let t60 = k16 * t58;
                    let t61 = cos_phi + k17 * t58;
                    let t62 = k8 * t60;
                    let t63 = k7 * t60;
                    let t64 = k7 * t59 + t62;
                    let t65 = k7 * t61 - t62;
                    let t66 = t63 + k8 * t61;
                    let t67 = k8 * t59 - t63;
                    let t68 = T::from_f64(0.08) * t64;
                    let t69 = T::from_f64(0.08) * t66;
                    let t70 = t48 * t68 + t27 * t69;
                    let t71 = T::from_f64(0.8) + cos_theta * t56 - t70;
                    let t72 = T::from_f64(0.8) + cos_theta * t57 + t70;
                    let t73 = t37 * t69 + t40 * t68;
                    let t74 = t42 * t68 - t41 * t69;
                    let t75 = t23 * t56 + t73;
                    let t76 = t25 * t56 + t74;
                    let t77 = t23 * t57 - t73;
                    let t78 = t25 * t57 - t74;
                    let t79 = t66 * t1 + t45 * t2 + t65 * t4;
                    let t80 = k8 * t49 + k7 * t45;
                    let t81 = T::from_f64(0.4) + t54 * t1 + cos_phi * t2 - t4 * t80;
                    let t82 = t49 * t2 + t4 * t67 - t64 * t1;
                    let t83 = T::from_f64(0.8) + t27 * t79 + cos_theta * t81 - t48 * t82;
                    let t84 = t23 * t81 + t40 * t82 - t37 * t79;
                    let t85 = t41 * t79 + t25 * t81 + t42 * t82;
                    let t86 = t65 * t18 - t66 * t21;
                    let t87 = t66 * t20 + t45 * t6 + t65 * t17;
                    let t88 = t45 * t8 + t86;
                    let t89 = t45 * t9 - t86;
                    let t90 = T::from_f64(0.4) * t45;
                    let t91 = t80 * t18 + t54 * t21;
                    let t92 = t64 * t21 + t67 * t18;
                    let t93 = T::from_f64(0.4) + t54 * t20 + cos_phi * t6 - t80 * t17;
                    let t94 = t49 * t6 + t67 * t17 - t64 * t20;
                    let t95 = T::from_f64(0.8) + t27 * t87 + cos_theta * t93 - t48 * t94;
                    let t96 = t23 * t93 + t40 * t94 - t37 * t87;
                    let t97 = t41 * t87 + t25 * t93 + t42 * t94;
                    let t98 = T::from_f64(0.4) + cos_phi * t8 - t91;
                    let t99 = t49 * t8 + t92;
                    let t100 = T::from_f64(0.8) + t27 * t88 + cos_theta * t98
                        - t48 * t99;
                    let t101 = t23 * t98 + t40 * t99 - t37 * t88;
                    let t102 = t41 * t88 + t25 * t98 + t42 * t99;
                    let t103 = T::from_f64(0.4) + cos_phi * t9 + t91;
                    let t104 = t49 * t9 - t92;
                    let t105 = T::from_f64(0.8) + t27 * t89 + cos_theta * t103
                        - t48 * t104;
                    let t106 = t23 * t103 + t40 * t104 - t37 * t89;
                    let t107 = t41 * t89 + t25 * t103 + t42 * t104;
                    let t108 = T::from_f64(0.4) * t49;
                    let t109 = T::from_f64(0.4) + T::from_f64(0.4) * cos_phi;
                    let t110 = T::from_f64(0.8) + t27 * t90 + cos_theta * t109
                        - t48 * t108;
                    let t111 = t23 * t109 + t40 * t108 - t37 * t90;
                    let t112 = t41 * t90 + t25 * t109 + t42 * t108;
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.8),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(-0.08),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.08),
                        T::from_f64(0.015),
                        T::from_f64(0.8),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t22,
                        t24,
                        t26,
                        t29,
                        t38,
                        t43,
                        t30,
                        t39,
                        t44,
                        T::from_f64(0.015),
                        t22,
                        t24,
                        t26,
                        t51,
                        t52,
                        t53,
                        t71,
                        t75,
                        t76,
                        t72,
                        t77,
                        t78,
                        T::from_f64(0.015),
                        t51,
                        t52,
                        t53,
                        t83,
                        t84,
                        t85,
                        t100,
                        t101,
                        t102,
                        t105,
                        t106,
                        t107,
                        T::from_f64(0.015),
                        T::from_f64(0.8),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t22,
                        t24,
                        t26,
                        t51,
                        t52,
                        t53,
                        t83,
                        t84,
                        t85,
                        t110,
                        t111,
                        t112,
                        t22,
                        t24,
                        t26,
                        t83,
                        t84,
                        t85,
                        t95,
                        t96,
                        t97,
                    ]
                },
            )
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::CastJacobian<4> for Bennett {
        #[inline]
        fn with_jacobian<T: ::pendulum_core::real::Real>(
            model: &Bennett<T>,
        ) -> &impl ::pendulum_core::Jacobian<T, 4> {
            model
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::Cast<4> for Bennett {
        type In<T: ::pendulum_core::real::Real> = Bennett<T>;
        fn cast<T: ::pendulum_core::real::Real>(&self) -> Bennett<T> {
            Bennett::cast(self)
        }
        #[inline]
        fn gather<'m, T: ::pendulum_core::real::lanes::Lanes>(
            models: impl ::core::ops::Fn(usize) -> &'m Self,
        ) -> Bennett<T>
        where
            Self: 'm,
        {
            let scalar = <<T as ::pendulum_core::real::lanes::Lanes>::Scalar as ::pendulum_core::real::Real>::from_f64;
            Bennett {
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
pub use __Bennett::{Bennett, BennettParams};
