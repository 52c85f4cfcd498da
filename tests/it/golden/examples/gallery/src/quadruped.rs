#[allow(non_snake_case)]
mod __Quadruped {
    ///Parameters of [`Quadruped`].
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct QuadrupedParams {
        ///In N m.
        pub k: f64,
        ///In N m s.
        pub c: f64,
        ///In N m.
        pub pull: f64,
        ///In rad/s.
        pub w: f64,
    }
    impl ::core::default::Default for QuadrupedParams {
        #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
        fn default() -> Self {
            Self {
                k: 4f64,
                c: 0.05f64,
                pull: 2.5f64,
                w: 20f64,
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl QuadrupedParams {
        /// The names of the parameters, in the order of their declaration.
        pub const NAMES: [&'static str; 4] = ["k", "c", "pull", "w"];
        /// The values of the parameters, in the order of [`NAMES`](Self::NAMES).
        pub const fn to_array(self) -> [f64; 4] {
            [self.k, self.c, self.pull, self.w]
        }
        /// The parameters with these values, in the order of [`NAMES`](Self::NAMES).
        pub const fn from_array(values: [f64; 4]) -> Self {
            let [v0, v1, v2, v3] = values;
            Self {
                k: v0,
                c: v1,
                pull: v2,
                w: v3,
            }
        }
    }
    /// x points ahead, y to the left, z upward.
    ///
    /**# Equations of motion

```text
A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints

A[p.x, p.x] = 5.8
A[p.x, o.x] = t1*t118
A[p.x, o.y] = t2*t117 - t0*t118
A[p.x, o.z] = -t1*t117
A[p.x, hip1] = t2*t114 - t0*t113
A[p.x, knee1] = 0.015*t2*s_hip1_knee1 - 0.015*t0*c_hip1_knee1
A[p.x, hip2] = t2*t110 - t0*t109
A[p.x, knee2] = 0.015*t2*s_hip2_knee2 - 0.015*t0*c_hip2_knee2
A[p.x, hip3] = t2*t106 - t0*t105
A[p.x, knee3] = 0.015*t2*s_hip3_knee3 - 0.015*t0*c_hip3_knee3
A[p.x, hip4] = t2*t102 - t0*t101
A[p.x, knee4] = 0.015*t2*s_hip4_knee4 - 0.015*t0*c_hip4_knee4
A[p.y, p.y] = 5.8
A[p.y, o.x] = t4*t118
A[p.y, o.y] = t5*t117 - t3*t118
A[p.y, o.z] = -t4*t117
A[p.y, hip1] = t5*t114 - t3*t113
A[p.y, knee1] = 0.015*t5*s_hip1_knee1 - 0.015*t3*c_hip1_knee1
A[p.y, hip2] = t5*t110 - t3*t109
A[p.y, knee2] = 0.015*t5*s_hip2_knee2 - 0.015*t3*c_hip2_knee2
A[p.y, hip3] = t5*t106 - t3*t105
A[p.y, knee3] = 0.015*t5*s_hip3_knee3 - 0.015*t3*c_hip3_knee3
A[p.y, hip4] = t5*t102 - t3*t101
A[p.y, knee4] = 0.015*t5*s_hip4_knee4 - 0.015*t3*c_hip4_knee4
A[p.z, p.z] = 5.8
A[p.z, o.x] = 2*t7*t118
A[p.z, o.y] = t8*t117 - 2*t6*t118
A[p.z, o.z] = -2*t7*t117
A[p.z, hip1] = t8*t114 - 2*t6*t113
A[p.z, knee1] = 0.015*t8*s_hip1_knee1 - 2*0.015*t6*c_hip1_knee1
A[p.z, hip2] = t8*t110 - 2*t6*t109
A[p.z, knee2] = 0.015*t8*s_hip2_knee2 - 2*0.015*t6*c_hip2_knee2
A[p.z, hip3] = t8*t106 - 2*t6*t105
A[p.z, knee3] = 0.015*t8*s_hip3_knee3 - 2*0.015*t6*c_hip3_knee3
A[p.z, hip4] = t8*t102 - 2*t6*t101
A[p.z, knee4] = 0.015*t8*s_hip4_knee4 - 2*0.015*t6*c_hip4_knee4
A[o.x, o.x] = t119 + t122 + t120 - t121 - t122
A[o.x, o.y] = 0.1*t114 + 0.1*t106 - 0.1*t102 - 0.1*t110
A[o.x, o.z] = -(0.01*s_hip4*c_hip4 + 0.002*s_hip4_knee4*c_hip4_knee4 + 0.2*0.015*c_hip4*s_hip4_knee4 + 0.2*0.015*s_hip4*c_hip4_knee4 + 0.2*t101 + 0.01*s_hip3*c_hip3 + 0.002*s_hip3_knee3*c_hip3_knee3 + 0.2*0.015*c_hip3*s_hip3_knee3 + 0.2*0.015*s_hip3*c_hip3_knee3 + 0.2*t105 + 0.01*s_hip2*c_hip2 + 0.002*s_hip2_knee2*c_hip2_knee2 + 0.2*0.015*c_hip2*s_hip2_knee2 + 0.2*0.015*s_hip2*c_hip2_knee2 + 0.01*s_hip1*c_hip1 + 0.002*s_hip1_knee1*c_hip1_knee1 + 0.2*0.015*c_hip1*s_hip1_knee1 + 0.2*0.015*s_hip1*c_hip1_knee1 - 0.2*t109 - 0.2*t113)
A[o.x, hip1] = 0.1*t114
A[o.x, knee1] = 0.0015*s_hip1_knee1
A[o.x, hip2] = -0.1*t110
A[o.x, knee2] = -0.0015*s_hip2_knee2
A[o.x, hip3] = 0.1*t106
A[o.x, knee3] = 0.0015*s_hip3_knee3
A[o.x, hip4] = -0.1*t102
A[o.x, knee4] = -0.0015*s_hip4_knee4
A[o.y, o.y] = t120 + t122
A[o.y, o.z] = 0.1*t113 + 0.1*t105 - 0.1*t101 - 0.1*t109
A[o.y, hip1] = t115 + t116 - 0.2*t114
A[o.y, knee1] = A[hip1, knee1] - 0.003*s_hip1_knee1
A[o.y, hip2] = t111 + t112 - 0.2*t110
A[o.y, knee2] = A[hip2, knee2] - 0.003*s_hip2_knee2
A[o.y, hip3] = 0.2*t106 + t107 + t108
A[o.y, knee3] = A[hip3, knee3] + 0.003*s_hip3_knee3
A[o.y, hip4] = 0.2*t102 + t103 + t104
A[o.y, knee4] = A[hip4, knee4] + 0.003*s_hip4_knee4
A[o.z, o.z] = 46/1875 + t119
A[o.z, hip1] = 0.1*t113
A[o.z, knee1] = 0.0015*c_hip1_knee1
A[o.z, hip2] = -0.1*t109
A[o.z, knee2] = -0.0015*c_hip2_knee2
A[o.z, hip3] = 0.1*t105
A[o.z, knee3] = 0.0015*c_hip3_knee3
A[o.z, hip4] = -0.1*t101
A[o.z, knee4] = -0.0015*c_hip4_knee4
A[hip1, hip1] = t115 + t116
A[hip1, knee1] = A[knee1, knee1] + 0.2*0.015*c_hip1*c_hip1_knee1 + 0.2*0.015*s_hip1*s_hip1_knee1
A[knee1, knee1] = 0.002*c_hip1_knee1^2 + t13
A[hip2, hip2] = t111 + t112
A[hip2, knee2] = A[knee2, knee2] + 0.2*0.015*c_hip2*c_hip2_knee2 + 0.2*0.015*s_hip2*s_hip2_knee2
A[knee2, knee2] = 0.002*c_hip2_knee2^2 + t14
A[hip3, hip3] = t107 + t108
A[hip3, knee3] = A[knee3, knee3] + 0.2*0.015*c_hip3*c_hip3_knee3 + 0.2*0.015*s_hip3*s_hip3_knee3
A[knee3, knee3] = 0.002*c_hip3_knee3^2 + t15
A[hip4, hip4] = t103 + t104
A[hip4, knee4] = A[knee4, knee4] + 0.2*0.015*c_hip4*c_hip4_knee4 + 0.2*0.015*s_hip4*s_hip4_knee4
A[knee4, knee4] = 0.002*c_hip4_knee4^2 + t16
b[p.x] = t0*t98 + t2*t100 - t1*t99
b[p.y] = t3*t98 + t5*t100 - t4*t99
b[p.z] = 56.898 + 2*t6*t98 + t8*t100 - 2*t7*t99
b[o.x] = 46/1875*dot(o).y*dot(o).z + 0.06*c_hip4*t44 + 0.015*c_hip4_knee4*t68 + 0.06*c_hip3*t37 + 0.015*c_hip3_knee3*t62 + 0.1*t89 + 0.06*c_hip2*t30 + 0.015*c_hip2_knee2*t56 + 0.06*c_hip1*t21 + 0.015*c_hip1_knee1*t50 + 0.1*t95 - 4/1875*dot(o).y*dot(o).z - 0.01*c_hip4^2*t48 - 0.01*s_hip4*c_hip4*t49 - 0.002*c_hip4_knee4^2*t72 - 0.002*s_hip4_knee4*c_hip4_knee4*t73 - 0.2*c_hip4*t85 - 0.1*t86 - 0.01*c_hip3^2*t41 - 0.01*s_hip3*c_hip3*t42 - 0.002*c_hip3_knee3^2*t66 - 0.002*s_hip3_knee3*c_hip3_knee3*t67 - 0.2*c_hip3*t82 - 0.01*c_hip2^2*t34 - 0.01*s_hip2*c_hip2*t35 - 0.002*c_hip2_knee2^2*t60 - 0.002*s_hip2_knee2*c_hip2_knee2*t61 - 0.2*c_hip2*t79 - 0.1*t92 - 0.01*c_hip1^2*t25 - 0.01*s_hip1*c_hip1*t26 - 0.002*c_hip1_knee1^2*t54 - 0.002*s_hip1_knee1*c_hip1_knee1*t55 - 0.2*c_hip1*t76
b[o.y] = 4/1875*dot(o).x*dot(o).z + b[hip4] + 0.2*t86 + b[hip3] + 0.2*t89 + b[hip2] + b[hip1] - 256/1875*dot(o).x*dot(o).z - 0.2*t92 - 0.2*t95
b[o.z] = 256/1875*dot(o).x*dot(o).y + t12*t49 + 0.01*s_hip4*c_hip4*t48 + t16*t73 + 0.002*s_hip4_knee4*c_hip4_knee4*t72 + 0.2*s_hip4*t85 + 0.2*t88 + 0.1*t87 + t11*t42 + 0.01*s_hip3*c_hip3*t41 + t15*t67 + 0.002*s_hip3_knee3*c_hip3_knee3*t66 + 0.2*s_hip3*t82 + 0.2*t91 + t10*t35 + 0.01*s_hip2*c_hip2*t34 + t14*t61 + 0.002*s_hip2_knee2*c_hip2_knee2*t60 + 0.2*s_hip2*t79 + 0.1*t93 + t9*t26 + 0.01*s_hip1*c_hip1*t25 + t13*t55 + 0.002*s_hip1_knee1*c_hip1_knee1*t54 + 0.2*s_hip1*t76 - 46/1875*dot(o).x*dot(o).y - 0.06*s_hip4*t44 - 0.015*s_hip4_knee4*t68 - 0.06*s_hip3*t37 - 0.015*s_hip3_knee3*t62 - 0.1*t90 - 0.06*s_hip2*t30 - 0.015*s_hip2_knee2*t56 - 0.2*t94 - 0.06*s_hip1*t21 - 0.015*s_hip1_knee1*t50 - 0.2*t97 - 0.1*t96
b[hip1] = 0.06*s_hip1*t22 + 0.01*s_hip1*c_hip1*(t23 - t24) + 0.01*dot(o).x*dot(o).z*c_hip1^2 + b[knee1] + 0.2*s_hip1*t74 - 0.06*c_hip1*t20 - dot(o).x*dot(o).z*t9 - 0.2*c_hip1*t75
b[knee1] = 0.015*s_hip1_knee1*(t22 + 0.2*c_hip1*t23 - 0.2*dot(o).x*dot(o).z*s_hip1) + 0.002*s_hip1_knee1*c_hip1_knee1*(t52 - t53) + 0.002*dot(o).x*dot(o).z*c_hip1_knee1^2 - 0.015*c_hip1_knee1*(t20 + 0.2*s_hip1*t24 - 0.2*dot(o).x*dot(o).z*c_hip1) - dot(o).x*dot(o).z*t13
b[hip2] = 0.06*s_hip2*t31 + 0.01*s_hip2*c_hip2*(t32 - t33) + 0.01*dot(o).x*dot(o).z*c_hip2^2 + b[knee2] + 0.2*s_hip2*t77 - 0.06*c_hip2*t29 - dot(o).x*dot(o).z*t10 - 0.2*c_hip2*t78
b[knee2] = 0.015*s_hip2_knee2*(t31 + 0.2*c_hip2*t32 - 0.2*dot(o).x*dot(o).z*s_hip2) + 0.002*s_hip2_knee2*c_hip2_knee2*(t58 - t59) + 0.002*dot(o).x*dot(o).z*c_hip2_knee2^2 - 0.015*c_hip2_knee2*(t29 + 0.2*s_hip2*t33 - 0.2*dot(o).x*dot(o).z*c_hip2) - dot(o).x*dot(o).z*t14
b[hip3] = 0.06*s_hip3*t38 + 0.01*s_hip3*c_hip3*(t39 - t40) + 0.01*dot(o).x*dot(o).z*c_hip3^2 + b[knee3] + 0.2*s_hip3*t80 - 0.06*c_hip3*t36 - dot(o).x*dot(o).z*t11 - 0.2*c_hip3*t81
b[knee3] = 0.015*s_hip3_knee3*(t38 + 0.2*c_hip3*t39 - 0.2*dot(o).x*dot(o).z*s_hip3) + 0.002*s_hip3_knee3*c_hip3_knee3*(t64 - t65) + 0.002*dot(o).x*dot(o).z*c_hip3_knee3^2 - 0.015*c_hip3_knee3*(t36 + 0.2*s_hip3*t40 - 0.2*dot(o).x*dot(o).z*c_hip3) - dot(o).x*dot(o).z*t15
b[hip4] = 0.06*s_hip4*t45 + 0.01*s_hip4*c_hip4*(t46 - t47) + 0.01*dot(o).x*dot(o).z*c_hip4^2 + b[knee4] + 0.2*s_hip4*t83 - 0.06*c_hip4*t43 - dot(o).x*dot(o).z*t12 - 0.2*c_hip4*t84
b[knee4] = 0.015*s_hip4_knee4*(t45 + 0.2*c_hip4*t46 - 0.2*dot(o).x*dot(o).z*s_hip4) + 0.002*s_hip4_knee4*c_hip4_knee4*(t70 - t71) + 0.002*dot(o).x*dot(o).z*c_hip4_knee4^2 - 0.015*c_hip4_knee4*(t43 + 0.2*s_hip4*t47 - 0.2*dot(o).x*dot(o).z*c_hip4) - dot(o).x*dot(o).z*t16
Q[hip1] = 0.5*k - k*hip1 - c*dot(hip1) + beat
Q[knee1] = -(c*dot(knee1) + k + k*knee1)
Q[hip2] = 0.5*k - k*hip2 - c*dot(hip2) - beat
Q[knee2] = -(c*dot(knee2) + k + k*knee2)
Q[hip3] = 0.5*k - k*hip3 - c*dot(hip3) - beat
Q[knee3] = -(c*dot(knee3) + k + k*knee3)
Q[hip4] = 0.5*k - k*hip4 - c*dot(hip4) + beat
Q[knee4] = -(c*dot(knee4) + k + k*knee4)

where
beat = pull*sin(w*t)
s_hip1 = sin(hip1)
c_hip1 = cos(hip1)
s_hip2 = sin(hip2)
c_hip2 = cos(hip2)
s_hip3 = sin(hip3)
c_hip3 = cos(hip3)
s_hip4 = sin(hip4)
c_hip4 = cos(hip4)
s_hip1_knee1 = sin(hip1 + knee1)
c_hip1_knee1 = cos(hip1 + knee1)
s_hip2_knee2 = sin(hip2 + knee2)
c_hip2_knee2 = cos(hip2 + knee2)
s_hip3_knee3 = sin(hip3 + knee3)
c_hip3_knee3 = cos(hip3 + knee3)
s_hip4_knee4 = sin(hip4 + knee4)
c_hip4_knee4 = cos(hip4 + knee4)
w_o.y_hip1 = dot(o).y + dot(hip1)
w_o.y_hip2 = dot(o).y + dot(hip2)
w_o.y_hip3 = dot(o).y + dot(hip3)
w_o.y_hip4 = dot(o).y + dot(hip4)
t0 = 1 - 2*(o.y^2 + o.z^2)
t1 = 2*(o.x*o.y - o.z*o.w)
t2 = 2*(o.x*o.z + o.y*o.w)
t3 = 2*(o.x*o.y + o.z*o.w)
t4 = 1 - 2*(o.x^2 + o.z^2)
t5 = 2*(o.y*o.z - o.x*o.w)
t6 = o.x*o.z - o.y*o.w
t7 = o.y*o.z + o.x*o.w
t8 = 1 - 2*(o.x^2 + o.y^2)
t9 = 0.01 - 0.01*c_hip1^2
t10 = 0.01 - 0.01*c_hip2^2
t11 = 0.01 - 0.01*c_hip3^2
t12 = 0.01 - 0.01*c_hip4^2
t13 = 0.002 - 0.002*c_hip1_knee1^2
t14 = 0.002 - 0.002*c_hip2_knee2^2
t15 = 0.002 - 0.002*c_hip3_knee3^2
t16 = 0.002 - 0.002*c_hip4_knee4^2
t17 = 0.2*(dot(o).y^2 + dot(o).z^2)
t18 = 0.1*(dot(o).z^2 + dot(o).x^2)
t19 = 0.2*dot(o).x*dot(o).z + 0.1*dot(o).y*dot(o).z
t20 = 19.62*t6 + 0.1*dot(o).x*dot(o).y - t17
t21 = 19.62*t7 + 0.2*dot(o).x*dot(o).y - t18
t22 = 9.81*t8 + t19
t23 = dot(o).x^2 + w_o.y_hip1^2
t24 = dot(o).z^2 + w_o.y_hip1^2
t25 = dot(o).z*dot(hip1) + dot(o).z*w_o.y_hip1
t26 = dot(o).x*dot(hip1) + dot(o).x*w_o.y_hip1
t27 = t17 + 0.1*dot(o).x*dot(o).y
t28 = 0.2*dot(o).x*dot(o).y + t18
t29 = 19.62*t6 - t27
t30 = 19.62*t7 + t28
t31 = 9.81*t8 + 0.2*dot(o).x*dot(o).z - 0.1*dot(o).y*dot(o).z
t32 = dot(o).x^2 + w_o.y_hip2^2
t33 = dot(o).z^2 + w_o.y_hip2^2
t34 = dot(o).z*dot(hip2) + dot(o).z*w_o.y_hip2
t35 = dot(o).x*dot(hip2) + dot(o).x*w_o.y_hip2
t36 = 19.62*t6 + t27
t37 = 19.62*t7 - t28
t38 = 9.81*t8 + 0.1*dot(o).y*dot(o).z - 0.2*dot(o).x*dot(o).z
t39 = dot(o).x^2 + w_o.y_hip3^2
t40 = dot(o).z^2 + w_o.y_hip3^2
t41 = dot(o).z*dot(hip3) + dot(o).z*w_o.y_hip3
t42 = dot(o).x*dot(hip3) + dot(o).x*w_o.y_hip3
t43 = 19.62*t6 + t17 - 0.1*dot(o).x*dot(o).y
t44 = 19.62*t7 + t18 - 0.2*dot(o).x*dot(o).y
t45 = 9.81*t8 - t19
t46 = dot(o).x^2 + w_o.y_hip4^2
t47 = dot(o).z^2 + w_o.y_hip4^2
t48 = dot(o).z*dot(hip4) + dot(o).z*w_o.y_hip4
t49 = dot(o).x*dot(hip4) + dot(o).x*w_o.y_hip4
t50 = t21 - 0.2*c_hip1*t25 - 0.2*s_hip1*t26
t51 = (dot(knee1) + w_o.y_hip1)^2
t52 = dot(o).x^2 + t51
t53 = dot(o).z^2 + t51
t54 = dot(o).z*dot(hip1) + dot(o).z*dot(knee1) + dot(o).z*(dot(knee1) + w_o.y_hip1)
t55 = dot(o).x*dot(hip1) + dot(o).x*dot(knee1) + dot(o).x*(dot(knee1) + w_o.y_hip1)
t56 = t30 - 0.2*c_hip2*t34 - 0.2*s_hip2*t35
t57 = (dot(knee2) + w_o.y_hip2)^2
t58 = dot(o).x^2 + t57
t59 = dot(o).z^2 + t57
t60 = dot(o).z*dot(hip2) + dot(o).z*dot(knee2) + dot(o).z*(dot(knee2) + w_o.y_hip2)
t61 = dot(o).x*dot(hip2) + dot(o).x*dot(knee2) + dot(o).x*(dot(knee2) + w_o.y_hip2)
t62 = t37 - 0.2*c_hip3*t41 - 0.2*s_hip3*t42
t63 = (dot(knee3) + w_o.y_hip3)^2
t64 = dot(o).x^2 + t63
t65 = dot(o).z^2 + t63
t66 = dot(o).z*dot(hip3) + dot(o).z*dot(knee3) + dot(o).z*(dot(knee3) + w_o.y_hip3)
t67 = dot(o).x*dot(hip3) + dot(o).x*dot(knee3) + dot(o).x*(dot(knee3) + w_o.y_hip3)
t68 = t44 - 0.2*c_hip4*t48 - 0.2*s_hip4*t49
t69 = (dot(knee4) + w_o.y_hip4)^2
t70 = dot(o).x^2 + t69
t71 = dot(o).z^2 + t69
t72 = dot(o).z*dot(hip4) + dot(o).z*dot(knee4) + dot(o).z*(dot(knee4) + w_o.y_hip4)
t73 = dot(o).x*dot(hip4) + dot(o).x*dot(knee4) + dot(o).x*(dot(knee4) + w_o.y_hip4)
t74 = 0.015*c_hip1_knee1*t52 - 0.015*dot(o).x*dot(o).z*s_hip1_knee1
t75 = 0.015*s_hip1_knee1*t53 - 0.015*dot(o).x*dot(o).z*c_hip1_knee1
t76 = 0.015*c_hip1_knee1*t54 + 0.015*s_hip1_knee1*t55
t77 = 0.015*c_hip2_knee2*t58 - 0.015*dot(o).x*dot(o).z*s_hip2_knee2
t78 = 0.015*s_hip2_knee2*t59 - 0.015*dot(o).x*dot(o).z*c_hip2_knee2
t79 = 0.015*c_hip2_knee2*t60 + 0.015*s_hip2_knee2*t61
t80 = 0.015*c_hip3_knee3*t64 - 0.015*dot(o).x*dot(o).z*s_hip3_knee3
t81 = 0.015*s_hip3_knee3*t65 - 0.015*dot(o).x*dot(o).z*c_hip3_knee3
t82 = 0.015*c_hip3_knee3*t66 + 0.015*s_hip3_knee3*t67
t83 = 0.015*c_hip4_knee4*t70 - 0.015*dot(o).x*dot(o).z*s_hip4_knee4
t84 = 0.015*s_hip4_knee4*t71 - 0.015*dot(o).x*dot(o).z*c_hip4_knee4
t85 = 0.015*c_hip4_knee4*t72 + 0.015*s_hip4_knee4*t73
t86 = 0.06*c_hip4*t46 + t83 - 0.06*dot(o).x*dot(o).z*s_hip4
t87 = 0.06*s_hip4*t47 + t84 - 0.06*dot(o).x*dot(o).z*c_hip4
t88 = 0.06*c_hip4*t48 + 0.06*s_hip4*t49 + t85
t89 = 0.06*c_hip3*t39 + t80 - 0.06*dot(o).x*dot(o).z*s_hip3
t90 = 0.06*s_hip3*t40 + t81 - 0.06*dot(o).x*dot(o).z*c_hip3
t91 = 0.06*c_hip3*t41 + 0.06*s_hip3*t42 + t82
t92 = 0.06*c_hip2*t32 + t77 - 0.06*dot(o).x*dot(o).z*s_hip2
t93 = 0.06*s_hip2*t33 + t78 - 0.06*dot(o).x*dot(o).z*c_hip2
t94 = 0.06*c_hip2*t34 + 0.06*s_hip2*t35 + t79
t95 = 0.06*c_hip1*t23 + t74 - 0.06*dot(o).x*dot(o).z*s_hip1
t96 = 0.06*s_hip1*t24 + t75 - 0.06*dot(o).x*dot(o).z*c_hip1
t97 = 0.06*c_hip1*t25 + 0.06*s_hip1*t26 + t76
t98 = t96 + t93 + t87 + t90
t99 = t97 + t94 + t88 + t91
t100 = t95 + t92 + t86 + t89
t101 = 0.015*c_hip4_knee4 + 0.06*c_hip4
t102 = 0.015*s_hip4_knee4 + 0.06*s_hip4
t103 = 0.01*c_hip4^2 + 0.002*c_hip4_knee4^2 + 0.2*2*0.015*c_hip4*c_hip4_knee4
t104 = t12 + t16 + 0.2*2*0.015*s_hip4*s_hip4_knee4
t105 = 0.015*c_hip3_knee3 + 0.06*c_hip3
t106 = 0.015*s_hip3_knee3 + 0.06*s_hip3
t107 = 0.01*c_hip3^2 + 0.002*c_hip3_knee3^2 + 0.2*2*0.015*c_hip3*c_hip3_knee3
t108 = t11 + t15 + 0.2*2*0.015*s_hip3*s_hip3_knee3
t109 = 0.015*c_hip2_knee2 + 0.06*c_hip2
t110 = 0.015*s_hip2_knee2 + 0.06*s_hip2
t111 = 0.01*c_hip2^2 + 0.002*c_hip2_knee2^2 + 0.2*2*0.015*c_hip2*c_hip2_knee2
t112 = t10 + t14 + 0.2*2*0.015*s_hip2*s_hip2_knee2
t113 = 0.015*c_hip1_knee1 + 0.06*c_hip1
t114 = 0.015*s_hip1_knee1 + 0.06*s_hip1
t115 = 0.01*c_hip1^2 + 0.002*c_hip1_knee1^2 + 0.2*2*0.015*c_hip1*c_hip1_knee1
t116 = t9 + t13 + 0.2*2*0.015*s_hip1*s_hip1_knee1
t117 = t114 + t110 + t102 + t106
t118 = t113 + t109 + t101 + t105
t119 = 256/1875 + t104 + 0.4*t102 + t108 + 0.4*t106 + t112 + t116 - 0.4*t110 - 0.4*t114
t120 = t115 + t111 + t107 + 4/1875 + t103
t121 = t119 - 46/1875
t122 = 46/1875 + t121
```

# Constants, computed by `new`

```text
k0 = k
k1 = c
k2 = pull
k3 = w
k4 = 0.5*k
```
*/
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Quadruped<T = f64> {
        params: QuadrupedParams,
        constants: [T; 5],
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl Quadruped {
        /// Builds the model: checks the parameters, and computes once whatever depends on them alone.
        ///
        /// # Errors
        ///
        /// The first parameter, or combination of parameters, that is not finite or that no rigid body can have.
        pub fn new(
            params: QuadrupedParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            #[inline]
            fn rules<T: ::pendulum_core::real::Real>(given: [T; 4]) -> [T; 1] {
                let [p_k, p_c, p_pull, p_w] = given;
                [p_c]
            }
            #[inline]
            fn constants<T: ::pendulum_core::real::Real>(given: [T; 4]) -> [T; 5] {
                let [p_k, p_c, p_pull, p_w] = given;
                [p_k, p_c, p_pull, p_w, T::from_f64(0.5) * p_k]
            }
            let given = params.to_array();
            for (name, value) in QuadrupedParams::NAMES.into_iter().zip(given) {
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
                        "c",
                        r0,
                        "the friction of `thigh1` must not be negative",
                        &[],
                    ),
                );
            }
            let constants = constants(given);
            let names: [&'static str; 5] = ["k", "c", "pull", "w", "0.5*k"];
            for (name, value) in names.into_iter().zip(constants) {
                if !value.is_finite() {
                    let given: [_; 4] = ::core::array::from_fn(|n| (
                        QuadrupedParams::NAMES[n],
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
        pub fn cast<T: ::pendulum_core::real::Real>(&self) -> Quadruped<T> {
            Quadruped {
                params: self.params,
                constants: self.constants.map(T::from_f64),
            }
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> Quadruped<T> {
        /// The parameters that the model was built from.
        pub fn params(&self) -> &QuadrupedParams {
            &self.params
        }
        /// The model with other parameters, in the same number type. Its constants are computed anew.
        ///
        /// # Errors
        ///
        /// Those of `new`.
        pub fn with_params(
            &self,
            params: QuadrupedParams,
        ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
            Ok(<Quadruped>::new(params)?.cast())
        }
    }
    impl Quadruped {
        ///The place of `p.x` in the state, where it stands in m.
        pub const P_X: usize = 0;
        ///The place of `dot(p.x)` in the state, where it stands in m/s.
        pub const DOT_P_X: usize = 15;
        ///The place of `p.y` in the state, where it stands in m.
        pub const P_Y: usize = 1;
        ///The place of `dot(p.y)` in the state, where it stands in m/s.
        pub const DOT_P_Y: usize = 16;
        ///The place of `p.z` in the state, where it stands in m.
        pub const P_Z: usize = 2;
        ///The place of `dot(p.z)` in the state, where it stands in m/s.
        pub const DOT_P_Z: usize = 17;
        ///The first place of `o` in the state, whose components stand in 1.
        pub const O: usize = 3;
        ///The first place of `dot(o)` in the state, whose components stand in rad/s.
        pub const DOT_O: usize = 18;
        ///The place of `hip1` in the state, where it stands in rad.
        pub const HIP1: usize = 7;
        ///The place of `dot(hip1)` in the state, where it stands in rad/s.
        pub const DOT_HIP1: usize = 21;
        ///The place of `knee1` in the state, where it stands in rad.
        pub const KNEE1: usize = 8;
        ///The place of `dot(knee1)` in the state, where it stands in rad/s.
        pub const DOT_KNEE1: usize = 22;
        ///The place of `hip2` in the state, where it stands in rad.
        pub const HIP2: usize = 9;
        ///The place of `dot(hip2)` in the state, where it stands in rad/s.
        pub const DOT_HIP2: usize = 23;
        ///The place of `knee2` in the state, where it stands in rad.
        pub const KNEE2: usize = 10;
        ///The place of `dot(knee2)` in the state, where it stands in rad/s.
        pub const DOT_KNEE2: usize = 24;
        ///The place of `hip3` in the state, where it stands in rad.
        pub const HIP3: usize = 11;
        ///The place of `dot(hip3)` in the state, where it stands in rad/s.
        pub const DOT_HIP3: usize = 25;
        ///The place of `knee3` in the state, where it stands in rad.
        pub const KNEE3: usize = 12;
        ///The place of `dot(knee3)` in the state, where it stands in rad/s.
        pub const DOT_KNEE3: usize = 26;
        ///The place of `hip4` in the state, where it stands in rad.
        pub const HIP4: usize = 13;
        ///The place of `dot(hip4)` in the state, where it stands in rad/s.
        pub const DOT_HIP4: usize = 27;
        ///The place of `knee4` in the state, where it stands in rad.
        pub const KNEE4: usize = 14;
        ///The place of `dot(knee4)` in the state, where it stands in rad/s.
        pub const DOT_KNEE4: usize = 28;
        /// The number of degrees of freedom, and of rates; a quaternion has one component more.
        pub const DOF: usize = 14;
        /// The names of the coordinates, in the order in which their rates stand in the state; of an orientation the axes of its angular velocity.
        pub const COORDINATES: [&'static str; 14] = [
            "p.x",
            "p.y",
            "p.z",
            "o.x",
            "o.y",
            "o.z",
            "hip1",
            "knee1",
            "hip2",
            "knee2",
            "hip3",
            "knee3",
            "hip4",
            "knee4",
        ];
        /// Counted operations of each generated function, in the form that it has and in others.
        pub const COST: ::pendulum_core::Cost = ::pendulum_core::Cost::new(
            &[
                (
                    "rhs",
                    ::pendulum_core::FunctionCost::new(
                        "recursion, L^T D L",
                        ::pendulum_core::Operations::new(806, 887, 14, 9, 0, 125),
                    ),
                ),
                (
                    "kinetic",
                    ::pendulum_core::FunctionCost::new(
                        "recursion",
                        ::pendulum_core::Operations::new(214, 215, 0, 8, 0, 54),
                    ),
                ),
                (
                    "potential",
                    ::pendulum_core::FunctionCost::new(
                        "recursion",
                        ::pendulum_core::Operations::new(60, 38, 0, 8, 0, 35),
                    ),
                ),
                (
                    "foot1",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(25, 24, 0, 2, 0, 29),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(25, 24, 0, 2, 0, 29),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "as declared",
                                    ::pendulum_core::Operations::new(25, 25, 0, 2, 0, 29),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(28, 28, 0, 2, 0, 29),
                                ),
                            ],
                        ),
                ),
                (
                    "foot1_rate",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(56, 62, 0, 2, 0, 33),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(56, 63, 0, 2, 0, 34),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "as declared",
                                    ::pendulum_core::Operations::new(53, 71, 0, 2, 0, 31),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(139, 202, 0, 2, 0, 69),
                                ),
                            ],
                        ),
                ),
                (
                    "foot1_and_jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(51, 65, 0, 2, 0, 28),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(58, 77, 0, 2, 0, 30),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(58, 81, 0, 2, 0, 30),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(86, 73, 0, 2, 0, 29),
                                ),
                            ],
                        ),
                ),
                (
                    "foot2",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(25, 24, 0, 2, 0, 29),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(25, 24, 0, 2, 0, 29),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "as declared",
                                    ::pendulum_core::Operations::new(25, 25, 0, 2, 0, 29),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(28, 28, 0, 2, 0, 29),
                                ),
                            ],
                        ),
                ),
                (
                    "foot2_rate",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(57, 62, 0, 2, 0, 33),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(56, 63, 0, 2, 0, 34),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "as declared",
                                    ::pendulum_core::Operations::new(53, 71, 0, 2, 0, 31),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(139, 202, 0, 2, 0, 69),
                                ),
                            ],
                        ),
                ),
                (
                    "foot2_and_jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(52, 65, 0, 2, 0, 28),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(59, 77, 0, 2, 0, 30),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(59, 81, 0, 2, 0, 30),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(85, 73, 0, 2, 0, 31),
                                ),
                            ],
                        ),
                ),
                (
                    "foot3",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(25, 24, 0, 2, 0, 29),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(25, 24, 0, 2, 0, 29),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "as declared",
                                    ::pendulum_core::Operations::new(25, 25, 0, 2, 0, 28),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(28, 28, 0, 2, 0, 29),
                                ),
                            ],
                        ),
                ),
                (
                    "foot3_rate",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(55, 61, 0, 2, 0, 32),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(56, 63, 0, 2, 0, 34),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "as declared",
                                    ::pendulum_core::Operations::new(53, 71, 0, 2, 0, 31),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(139, 202, 0, 2, 0, 69),
                                ),
                            ],
                        ),
                ),
                (
                    "foot3_and_jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(51, 65, 0, 2, 0, 27),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(57, 77, 0, 2, 0, 30),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(57, 81, 0, 2, 0, 30),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(87, 73, 0, 2, 0, 29),
                                ),
                            ],
                        ),
                ),
                (
                    "foot4",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(25, 24, 0, 2, 0, 29),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(25, 24, 0, 2, 0, 29),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "as declared",
                                    ::pendulum_core::Operations::new(25, 25, 0, 2, 0, 29),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(28, 28, 0, 2, 0, 29),
                                ),
                            ],
                        ),
                ),
                (
                    "foot4_rate",
                    ::pendulum_core::FunctionCost::new(
                            "closed form, factors of the state first",
                            ::pendulum_core::Operations::new(56, 61, 0, 2, 0, 33),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(57, 63, 0, 2, 0, 34),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "as declared",
                                    ::pendulum_core::Operations::new(53, 71, 0, 2, 0, 31),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(139, 202, 0, 2, 0, 69),
                                ),
                            ],
                        ),
                ),
                (
                    "foot4_and_jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(52, 65, 0, 2, 0, 28),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(58, 77, 0, 2, 0, 30),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(58, 81, 0, 2, 0, 30),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(87, 73, 0, 2, 0, 31),
                                ),
                            ],
                        ),
                ),
                (
                    "outputs",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(58, 50, 0, 8, 0, 27),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(86, 75, 0, 8, 0, 29),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(86, 75, 0, 8, 0, 29),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(166, 133, 0, 8, 0, 34),
                                ),
                            ],
                        ),
                ),
                (
                    "output_rates",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(113, 138, 0, 8, 0, 29),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(185, 204, 0, 8, 0, 32),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(185, 205, 0, 8, 0, 33),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(556, 580, 0, 8, 0, 69),
                                ),
                            ],
                        ),
                ),
                (
                    "outputs_and_jacobian",
                    ::pendulum_core::FunctionCost::new(
                            "as declared",
                            ::pendulum_core::Operations::new(164, 167, 0, 8, 0, 27),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first",
                                    ::pendulum_core::Operations::new(218, 275, 0, 8, 0, 30),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first",
                                    ::pendulum_core::Operations::new(218, 291, 0, 8, 0, 30),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded",
                                    ::pendulum_core::Operations::new(491, 282, 0, 8, 0, 34),
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
                        "p.x",
                        ::pendulum_core::SlotKind::Length,
                        0..1,
                        15..16,
                    )
                    .cyclic(),
                ::pendulum_core::Slot::new(
                        "p.y",
                        ::pendulum_core::SlotKind::Length,
                        1..2,
                        16..17,
                    )
                    .cyclic(),
                ::pendulum_core::Slot::new(
                        "p.z",
                        ::pendulum_core::SlotKind::Length,
                        2..3,
                        17..18,
                    )
                    .cyclic(),
                ::pendulum_core::Slot::new(
                    "o",
                    ::pendulum_core::SlotKind::Quaternion,
                    3..7,
                    18..21,
                ),
                ::pendulum_core::Slot::new(
                    "hip1",
                    ::pendulum_core::SlotKind::Angle,
                    7..8,
                    21..22,
                ),
                ::pendulum_core::Slot::new(
                    "knee1",
                    ::pendulum_core::SlotKind::Angle,
                    8..9,
                    22..23,
                ),
                ::pendulum_core::Slot::new(
                    "hip2",
                    ::pendulum_core::SlotKind::Angle,
                    9..10,
                    23..24,
                ),
                ::pendulum_core::Slot::new(
                    "knee2",
                    ::pendulum_core::SlotKind::Angle,
                    10..11,
                    24..25,
                ),
                ::pendulum_core::Slot::new(
                    "hip3",
                    ::pendulum_core::SlotKind::Angle,
                    11..12,
                    25..26,
                ),
                ::pendulum_core::Slot::new(
                    "knee3",
                    ::pendulum_core::SlotKind::Angle,
                    12..13,
                    26..27,
                ),
                ::pendulum_core::Slot::new(
                    "hip4",
                    ::pendulum_core::SlotKind::Angle,
                    13..14,
                    27..28,
                ),
                ::pendulum_core::Slot::new(
                    "knee4",
                    ::pendulum_core::SlotKind::Angle,
                    14..15,
                    28..29,
                ),
            ],
        );
        /// The equations of motion as text.
        pub const EQUATIONS: &'static str = "A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints\n\nA[p.x, p.x] = 5.8\nA[p.x, o.x] = t1*t118\nA[p.x, o.y] = t2*t117 - t0*t118\nA[p.x, o.z] = -t1*t117\nA[p.x, hip1] = t2*t114 - t0*t113\nA[p.x, knee1] = 0.015*t2*s_hip1_knee1 - 0.015*t0*c_hip1_knee1\nA[p.x, hip2] = t2*t110 - t0*t109\nA[p.x, knee2] = 0.015*t2*s_hip2_knee2 - 0.015*t0*c_hip2_knee2\nA[p.x, hip3] = t2*t106 - t0*t105\nA[p.x, knee3] = 0.015*t2*s_hip3_knee3 - 0.015*t0*c_hip3_knee3\nA[p.x, hip4] = t2*t102 - t0*t101\nA[p.x, knee4] = 0.015*t2*s_hip4_knee4 - 0.015*t0*c_hip4_knee4\nA[p.y, p.y] = 5.8\nA[p.y, o.x] = t4*t118\nA[p.y, o.y] = t5*t117 - t3*t118\nA[p.y, o.z] = -t4*t117\nA[p.y, hip1] = t5*t114 - t3*t113\nA[p.y, knee1] = 0.015*t5*s_hip1_knee1 - 0.015*t3*c_hip1_knee1\nA[p.y, hip2] = t5*t110 - t3*t109\nA[p.y, knee2] = 0.015*t5*s_hip2_knee2 - 0.015*t3*c_hip2_knee2\nA[p.y, hip3] = t5*t106 - t3*t105\nA[p.y, knee3] = 0.015*t5*s_hip3_knee3 - 0.015*t3*c_hip3_knee3\nA[p.y, hip4] = t5*t102 - t3*t101\nA[p.y, knee4] = 0.015*t5*s_hip4_knee4 - 0.015*t3*c_hip4_knee4\nA[p.z, p.z] = 5.8\nA[p.z, o.x] = 2*t7*t118\nA[p.z, o.y] = t8*t117 - 2*t6*t118\nA[p.z, o.z] = -2*t7*t117\nA[p.z, hip1] = t8*t114 - 2*t6*t113\nA[p.z, knee1] = 0.015*t8*s_hip1_knee1 - 2*0.015*t6*c_hip1_knee1\nA[p.z, hip2] = t8*t110 - 2*t6*t109\nA[p.z, knee2] = 0.015*t8*s_hip2_knee2 - 2*0.015*t6*c_hip2_knee2\nA[p.z, hip3] = t8*t106 - 2*t6*t105\nA[p.z, knee3] = 0.015*t8*s_hip3_knee3 - 2*0.015*t6*c_hip3_knee3\nA[p.z, hip4] = t8*t102 - 2*t6*t101\nA[p.z, knee4] = 0.015*t8*s_hip4_knee4 - 2*0.015*t6*c_hip4_knee4\nA[o.x, o.x] = t119 + t122 + t120 - t121 - t122\nA[o.x, o.y] = 0.1*t114 + 0.1*t106 - 0.1*t102 - 0.1*t110\nA[o.x, o.z] = -(0.01*s_hip4*c_hip4 + 0.002*s_hip4_knee4*c_hip4_knee4 + 0.2*0.015*c_hip4*s_hip4_knee4 + 0.2*0.015*s_hip4*c_hip4_knee4 + 0.2*t101 + 0.01*s_hip3*c_hip3 + 0.002*s_hip3_knee3*c_hip3_knee3 + 0.2*0.015*c_hip3*s_hip3_knee3 + 0.2*0.015*s_hip3*c_hip3_knee3 + 0.2*t105 + 0.01*s_hip2*c_hip2 + 0.002*s_hip2_knee2*c_hip2_knee2 + 0.2*0.015*c_hip2*s_hip2_knee2 + 0.2*0.015*s_hip2*c_hip2_knee2 + 0.01*s_hip1*c_hip1 + 0.002*s_hip1_knee1*c_hip1_knee1 + 0.2*0.015*c_hip1*s_hip1_knee1 + 0.2*0.015*s_hip1*c_hip1_knee1 - 0.2*t109 - 0.2*t113)\nA[o.x, hip1] = 0.1*t114\nA[o.x, knee1] = 0.0015*s_hip1_knee1\nA[o.x, hip2] = -0.1*t110\nA[o.x, knee2] = -0.0015*s_hip2_knee2\nA[o.x, hip3] = 0.1*t106\nA[o.x, knee3] = 0.0015*s_hip3_knee3\nA[o.x, hip4] = -0.1*t102\nA[o.x, knee4] = -0.0015*s_hip4_knee4\nA[o.y, o.y] = t120 + t122\nA[o.y, o.z] = 0.1*t113 + 0.1*t105 - 0.1*t101 - 0.1*t109\nA[o.y, hip1] = t115 + t116 - 0.2*t114\nA[o.y, knee1] = A[hip1, knee1] - 0.003*s_hip1_knee1\nA[o.y, hip2] = t111 + t112 - 0.2*t110\nA[o.y, knee2] = A[hip2, knee2] - 0.003*s_hip2_knee2\nA[o.y, hip3] = 0.2*t106 + t107 + t108\nA[o.y, knee3] = A[hip3, knee3] + 0.003*s_hip3_knee3\nA[o.y, hip4] = 0.2*t102 + t103 + t104\nA[o.y, knee4] = A[hip4, knee4] + 0.003*s_hip4_knee4\nA[o.z, o.z] = 46/1875 + t119\nA[o.z, hip1] = 0.1*t113\nA[o.z, knee1] = 0.0015*c_hip1_knee1\nA[o.z, hip2] = -0.1*t109\nA[o.z, knee2] = -0.0015*c_hip2_knee2\nA[o.z, hip3] = 0.1*t105\nA[o.z, knee3] = 0.0015*c_hip3_knee3\nA[o.z, hip4] = -0.1*t101\nA[o.z, knee4] = -0.0015*c_hip4_knee4\nA[hip1, hip1] = t115 + t116\nA[hip1, knee1] = A[knee1, knee1] + 0.2*0.015*c_hip1*c_hip1_knee1 + 0.2*0.015*s_hip1*s_hip1_knee1\nA[knee1, knee1] = 0.002*c_hip1_knee1^2 + t13\nA[hip2, hip2] = t111 + t112\nA[hip2, knee2] = A[knee2, knee2] + 0.2*0.015*c_hip2*c_hip2_knee2 + 0.2*0.015*s_hip2*s_hip2_knee2\nA[knee2, knee2] = 0.002*c_hip2_knee2^2 + t14\nA[hip3, hip3] = t107 + t108\nA[hip3, knee3] = A[knee3, knee3] + 0.2*0.015*c_hip3*c_hip3_knee3 + 0.2*0.015*s_hip3*s_hip3_knee3\nA[knee3, knee3] = 0.002*c_hip3_knee3^2 + t15\nA[hip4, hip4] = t103 + t104\nA[hip4, knee4] = A[knee4, knee4] + 0.2*0.015*c_hip4*c_hip4_knee4 + 0.2*0.015*s_hip4*s_hip4_knee4\nA[knee4, knee4] = 0.002*c_hip4_knee4^2 + t16\nb[p.x] = t0*t98 + t2*t100 - t1*t99\nb[p.y] = t3*t98 + t5*t100 - t4*t99\nb[p.z] = 56.898 + 2*t6*t98 + t8*t100 - 2*t7*t99\nb[o.x] = 46/1875*dot(o).y*dot(o).z + 0.06*c_hip4*t44 + 0.015*c_hip4_knee4*t68 + 0.06*c_hip3*t37 + 0.015*c_hip3_knee3*t62 + 0.1*t89 + 0.06*c_hip2*t30 + 0.015*c_hip2_knee2*t56 + 0.06*c_hip1*t21 + 0.015*c_hip1_knee1*t50 + 0.1*t95 - 4/1875*dot(o).y*dot(o).z - 0.01*c_hip4^2*t48 - 0.01*s_hip4*c_hip4*t49 - 0.002*c_hip4_knee4^2*t72 - 0.002*s_hip4_knee4*c_hip4_knee4*t73 - 0.2*c_hip4*t85 - 0.1*t86 - 0.01*c_hip3^2*t41 - 0.01*s_hip3*c_hip3*t42 - 0.002*c_hip3_knee3^2*t66 - 0.002*s_hip3_knee3*c_hip3_knee3*t67 - 0.2*c_hip3*t82 - 0.01*c_hip2^2*t34 - 0.01*s_hip2*c_hip2*t35 - 0.002*c_hip2_knee2^2*t60 - 0.002*s_hip2_knee2*c_hip2_knee2*t61 - 0.2*c_hip2*t79 - 0.1*t92 - 0.01*c_hip1^2*t25 - 0.01*s_hip1*c_hip1*t26 - 0.002*c_hip1_knee1^2*t54 - 0.002*s_hip1_knee1*c_hip1_knee1*t55 - 0.2*c_hip1*t76\nb[o.y] = 4/1875*dot(o).x*dot(o).z + b[hip4] + 0.2*t86 + b[hip3] + 0.2*t89 + b[hip2] + b[hip1] - 256/1875*dot(o).x*dot(o).z - 0.2*t92 - 0.2*t95\nb[o.z] = 256/1875*dot(o).x*dot(o).y + t12*t49 + 0.01*s_hip4*c_hip4*t48 + t16*t73 + 0.002*s_hip4_knee4*c_hip4_knee4*t72 + 0.2*s_hip4*t85 + 0.2*t88 + 0.1*t87 + t11*t42 + 0.01*s_hip3*c_hip3*t41 + t15*t67 + 0.002*s_hip3_knee3*c_hip3_knee3*t66 + 0.2*s_hip3*t82 + 0.2*t91 + t10*t35 + 0.01*s_hip2*c_hip2*t34 + t14*t61 + 0.002*s_hip2_knee2*c_hip2_knee2*t60 + 0.2*s_hip2*t79 + 0.1*t93 + t9*t26 + 0.01*s_hip1*c_hip1*t25 + t13*t55 + 0.002*s_hip1_knee1*c_hip1_knee1*t54 + 0.2*s_hip1*t76 - 46/1875*dot(o).x*dot(o).y - 0.06*s_hip4*t44 - 0.015*s_hip4_knee4*t68 - 0.06*s_hip3*t37 - 0.015*s_hip3_knee3*t62 - 0.1*t90 - 0.06*s_hip2*t30 - 0.015*s_hip2_knee2*t56 - 0.2*t94 - 0.06*s_hip1*t21 - 0.015*s_hip1_knee1*t50 - 0.2*t97 - 0.1*t96\nb[hip1] = 0.06*s_hip1*t22 + 0.01*s_hip1*c_hip1*(t23 - t24) + 0.01*dot(o).x*dot(o).z*c_hip1^2 + b[knee1] + 0.2*s_hip1*t74 - 0.06*c_hip1*t20 - dot(o).x*dot(o).z*t9 - 0.2*c_hip1*t75\nb[knee1] = 0.015*s_hip1_knee1*(t22 + 0.2*c_hip1*t23 - 0.2*dot(o).x*dot(o).z*s_hip1) + 0.002*s_hip1_knee1*c_hip1_knee1*(t52 - t53) + 0.002*dot(o).x*dot(o).z*c_hip1_knee1^2 - 0.015*c_hip1_knee1*(t20 + 0.2*s_hip1*t24 - 0.2*dot(o).x*dot(o).z*c_hip1) - dot(o).x*dot(o).z*t13\nb[hip2] = 0.06*s_hip2*t31 + 0.01*s_hip2*c_hip2*(t32 - t33) + 0.01*dot(o).x*dot(o).z*c_hip2^2 + b[knee2] + 0.2*s_hip2*t77 - 0.06*c_hip2*t29 - dot(o).x*dot(o).z*t10 - 0.2*c_hip2*t78\nb[knee2] = 0.015*s_hip2_knee2*(t31 + 0.2*c_hip2*t32 - 0.2*dot(o).x*dot(o).z*s_hip2) + 0.002*s_hip2_knee2*c_hip2_knee2*(t58 - t59) + 0.002*dot(o).x*dot(o).z*c_hip2_knee2^2 - 0.015*c_hip2_knee2*(t29 + 0.2*s_hip2*t33 - 0.2*dot(o).x*dot(o).z*c_hip2) - dot(o).x*dot(o).z*t14\nb[hip3] = 0.06*s_hip3*t38 + 0.01*s_hip3*c_hip3*(t39 - t40) + 0.01*dot(o).x*dot(o).z*c_hip3^2 + b[knee3] + 0.2*s_hip3*t80 - 0.06*c_hip3*t36 - dot(o).x*dot(o).z*t11 - 0.2*c_hip3*t81\nb[knee3] = 0.015*s_hip3_knee3*(t38 + 0.2*c_hip3*t39 - 0.2*dot(o).x*dot(o).z*s_hip3) + 0.002*s_hip3_knee3*c_hip3_knee3*(t64 - t65) + 0.002*dot(o).x*dot(o).z*c_hip3_knee3^2 - 0.015*c_hip3_knee3*(t36 + 0.2*s_hip3*t40 - 0.2*dot(o).x*dot(o).z*c_hip3) - dot(o).x*dot(o).z*t15\nb[hip4] = 0.06*s_hip4*t45 + 0.01*s_hip4*c_hip4*(t46 - t47) + 0.01*dot(o).x*dot(o).z*c_hip4^2 + b[knee4] + 0.2*s_hip4*t83 - 0.06*c_hip4*t43 - dot(o).x*dot(o).z*t12 - 0.2*c_hip4*t84\nb[knee4] = 0.015*s_hip4_knee4*(t45 + 0.2*c_hip4*t46 - 0.2*dot(o).x*dot(o).z*s_hip4) + 0.002*s_hip4_knee4*c_hip4_knee4*(t70 - t71) + 0.002*dot(o).x*dot(o).z*c_hip4_knee4^2 - 0.015*c_hip4_knee4*(t43 + 0.2*s_hip4*t47 - 0.2*dot(o).x*dot(o).z*c_hip4) - dot(o).x*dot(o).z*t16\nQ[hip1] = 0.5*k - k*hip1 - c*dot(hip1) + beat\nQ[knee1] = -(c*dot(knee1) + k + k*knee1)\nQ[hip2] = 0.5*k - k*hip2 - c*dot(hip2) - beat\nQ[knee2] = -(c*dot(knee2) + k + k*knee2)\nQ[hip3] = 0.5*k - k*hip3 - c*dot(hip3) - beat\nQ[knee3] = -(c*dot(knee3) + k + k*knee3)\nQ[hip4] = 0.5*k - k*hip4 - c*dot(hip4) + beat\nQ[knee4] = -(c*dot(knee4) + k + k*knee4)\n\nwhere\nbeat = pull*sin(w*t)\ns_hip1 = sin(hip1)\nc_hip1 = cos(hip1)\ns_hip2 = sin(hip2)\nc_hip2 = cos(hip2)\ns_hip3 = sin(hip3)\nc_hip3 = cos(hip3)\ns_hip4 = sin(hip4)\nc_hip4 = cos(hip4)\ns_hip1_knee1 = sin(hip1 + knee1)\nc_hip1_knee1 = cos(hip1 + knee1)\ns_hip2_knee2 = sin(hip2 + knee2)\nc_hip2_knee2 = cos(hip2 + knee2)\ns_hip3_knee3 = sin(hip3 + knee3)\nc_hip3_knee3 = cos(hip3 + knee3)\ns_hip4_knee4 = sin(hip4 + knee4)\nc_hip4_knee4 = cos(hip4 + knee4)\nw_o.y_hip1 = dot(o).y + dot(hip1)\nw_o.y_hip2 = dot(o).y + dot(hip2)\nw_o.y_hip3 = dot(o).y + dot(hip3)\nw_o.y_hip4 = dot(o).y + dot(hip4)\nt0 = 1 - 2*(o.y^2 + o.z^2)\nt1 = 2*(o.x*o.y - o.z*o.w)\nt2 = 2*(o.x*o.z + o.y*o.w)\nt3 = 2*(o.x*o.y + o.z*o.w)\nt4 = 1 - 2*(o.x^2 + o.z^2)\nt5 = 2*(o.y*o.z - o.x*o.w)\nt6 = o.x*o.z - o.y*o.w\nt7 = o.y*o.z + o.x*o.w\nt8 = 1 - 2*(o.x^2 + o.y^2)\nt9 = 0.01 - 0.01*c_hip1^2\nt10 = 0.01 - 0.01*c_hip2^2\nt11 = 0.01 - 0.01*c_hip3^2\nt12 = 0.01 - 0.01*c_hip4^2\nt13 = 0.002 - 0.002*c_hip1_knee1^2\nt14 = 0.002 - 0.002*c_hip2_knee2^2\nt15 = 0.002 - 0.002*c_hip3_knee3^2\nt16 = 0.002 - 0.002*c_hip4_knee4^2\nt17 = 0.2*(dot(o).y^2 + dot(o).z^2)\nt18 = 0.1*(dot(o).z^2 + dot(o).x^2)\nt19 = 0.2*dot(o).x*dot(o).z + 0.1*dot(o).y*dot(o).z\nt20 = 19.62*t6 + 0.1*dot(o).x*dot(o).y - t17\nt21 = 19.62*t7 + 0.2*dot(o).x*dot(o).y - t18\nt22 = 9.81*t8 + t19\nt23 = dot(o).x^2 + w_o.y_hip1^2\nt24 = dot(o).z^2 + w_o.y_hip1^2\nt25 = dot(o).z*dot(hip1) + dot(o).z*w_o.y_hip1\nt26 = dot(o).x*dot(hip1) + dot(o).x*w_o.y_hip1\nt27 = t17 + 0.1*dot(o).x*dot(o).y\nt28 = 0.2*dot(o).x*dot(o).y + t18\nt29 = 19.62*t6 - t27\nt30 = 19.62*t7 + t28\nt31 = 9.81*t8 + 0.2*dot(o).x*dot(o).z - 0.1*dot(o).y*dot(o).z\nt32 = dot(o).x^2 + w_o.y_hip2^2\nt33 = dot(o).z^2 + w_o.y_hip2^2\nt34 = dot(o).z*dot(hip2) + dot(o).z*w_o.y_hip2\nt35 = dot(o).x*dot(hip2) + dot(o).x*w_o.y_hip2\nt36 = 19.62*t6 + t27\nt37 = 19.62*t7 - t28\nt38 = 9.81*t8 + 0.1*dot(o).y*dot(o).z - 0.2*dot(o).x*dot(o).z\nt39 = dot(o).x^2 + w_o.y_hip3^2\nt40 = dot(o).z^2 + w_o.y_hip3^2\nt41 = dot(o).z*dot(hip3) + dot(o).z*w_o.y_hip3\nt42 = dot(o).x*dot(hip3) + dot(o).x*w_o.y_hip3\nt43 = 19.62*t6 + t17 - 0.1*dot(o).x*dot(o).y\nt44 = 19.62*t7 + t18 - 0.2*dot(o).x*dot(o).y\nt45 = 9.81*t8 - t19\nt46 = dot(o).x^2 + w_o.y_hip4^2\nt47 = dot(o).z^2 + w_o.y_hip4^2\nt48 = dot(o).z*dot(hip4) + dot(o).z*w_o.y_hip4\nt49 = dot(o).x*dot(hip4) + dot(o).x*w_o.y_hip4\nt50 = t21 - 0.2*c_hip1*t25 - 0.2*s_hip1*t26\nt51 = (dot(knee1) + w_o.y_hip1)^2\nt52 = dot(o).x^2 + t51\nt53 = dot(o).z^2 + t51\nt54 = dot(o).z*dot(hip1) + dot(o).z*dot(knee1) + dot(o).z*(dot(knee1) + w_o.y_hip1)\nt55 = dot(o).x*dot(hip1) + dot(o).x*dot(knee1) + dot(o).x*(dot(knee1) + w_o.y_hip1)\nt56 = t30 - 0.2*c_hip2*t34 - 0.2*s_hip2*t35\nt57 = (dot(knee2) + w_o.y_hip2)^2\nt58 = dot(o).x^2 + t57\nt59 = dot(o).z^2 + t57\nt60 = dot(o).z*dot(hip2) + dot(o).z*dot(knee2) + dot(o).z*(dot(knee2) + w_o.y_hip2)\nt61 = dot(o).x*dot(hip2) + dot(o).x*dot(knee2) + dot(o).x*(dot(knee2) + w_o.y_hip2)\nt62 = t37 - 0.2*c_hip3*t41 - 0.2*s_hip3*t42\nt63 = (dot(knee3) + w_o.y_hip3)^2\nt64 = dot(o).x^2 + t63\nt65 = dot(o).z^2 + t63\nt66 = dot(o).z*dot(hip3) + dot(o).z*dot(knee3) + dot(o).z*(dot(knee3) + w_o.y_hip3)\nt67 = dot(o).x*dot(hip3) + dot(o).x*dot(knee3) + dot(o).x*(dot(knee3) + w_o.y_hip3)\nt68 = t44 - 0.2*c_hip4*t48 - 0.2*s_hip4*t49\nt69 = (dot(knee4) + w_o.y_hip4)^2\nt70 = dot(o).x^2 + t69\nt71 = dot(o).z^2 + t69\nt72 = dot(o).z*dot(hip4) + dot(o).z*dot(knee4) + dot(o).z*(dot(knee4) + w_o.y_hip4)\nt73 = dot(o).x*dot(hip4) + dot(o).x*dot(knee4) + dot(o).x*(dot(knee4) + w_o.y_hip4)\nt74 = 0.015*c_hip1_knee1*t52 - 0.015*dot(o).x*dot(o).z*s_hip1_knee1\nt75 = 0.015*s_hip1_knee1*t53 - 0.015*dot(o).x*dot(o).z*c_hip1_knee1\nt76 = 0.015*c_hip1_knee1*t54 + 0.015*s_hip1_knee1*t55\nt77 = 0.015*c_hip2_knee2*t58 - 0.015*dot(o).x*dot(o).z*s_hip2_knee2\nt78 = 0.015*s_hip2_knee2*t59 - 0.015*dot(o).x*dot(o).z*c_hip2_knee2\nt79 = 0.015*c_hip2_knee2*t60 + 0.015*s_hip2_knee2*t61\nt80 = 0.015*c_hip3_knee3*t64 - 0.015*dot(o).x*dot(o).z*s_hip3_knee3\nt81 = 0.015*s_hip3_knee3*t65 - 0.015*dot(o).x*dot(o).z*c_hip3_knee3\nt82 = 0.015*c_hip3_knee3*t66 + 0.015*s_hip3_knee3*t67\nt83 = 0.015*c_hip4_knee4*t70 - 0.015*dot(o).x*dot(o).z*s_hip4_knee4\nt84 = 0.015*s_hip4_knee4*t71 - 0.015*dot(o).x*dot(o).z*c_hip4_knee4\nt85 = 0.015*c_hip4_knee4*t72 + 0.015*s_hip4_knee4*t73\nt86 = 0.06*c_hip4*t46 + t83 - 0.06*dot(o).x*dot(o).z*s_hip4\nt87 = 0.06*s_hip4*t47 + t84 - 0.06*dot(o).x*dot(o).z*c_hip4\nt88 = 0.06*c_hip4*t48 + 0.06*s_hip4*t49 + t85\nt89 = 0.06*c_hip3*t39 + t80 - 0.06*dot(o).x*dot(o).z*s_hip3\nt90 = 0.06*s_hip3*t40 + t81 - 0.06*dot(o).x*dot(o).z*c_hip3\nt91 = 0.06*c_hip3*t41 + 0.06*s_hip3*t42 + t82\nt92 = 0.06*c_hip2*t32 + t77 - 0.06*dot(o).x*dot(o).z*s_hip2\nt93 = 0.06*s_hip2*t33 + t78 - 0.06*dot(o).x*dot(o).z*c_hip2\nt94 = 0.06*c_hip2*t34 + 0.06*s_hip2*t35 + t79\nt95 = 0.06*c_hip1*t23 + t74 - 0.06*dot(o).x*dot(o).z*s_hip1\nt96 = 0.06*s_hip1*t24 + t75 - 0.06*dot(o).x*dot(o).z*c_hip1\nt97 = 0.06*c_hip1*t25 + 0.06*s_hip1*t26 + t76\nt98 = t96 + t93 + t87 + t90\nt99 = t97 + t94 + t88 + t91\nt100 = t95 + t92 + t86 + t89\nt101 = 0.015*c_hip4_knee4 + 0.06*c_hip4\nt102 = 0.015*s_hip4_knee4 + 0.06*s_hip4\nt103 = 0.01*c_hip4^2 + 0.002*c_hip4_knee4^2 + 0.2*2*0.015*c_hip4*c_hip4_knee4\nt104 = t12 + t16 + 0.2*2*0.015*s_hip4*s_hip4_knee4\nt105 = 0.015*c_hip3_knee3 + 0.06*c_hip3\nt106 = 0.015*s_hip3_knee3 + 0.06*s_hip3\nt107 = 0.01*c_hip3^2 + 0.002*c_hip3_knee3^2 + 0.2*2*0.015*c_hip3*c_hip3_knee3\nt108 = t11 + t15 + 0.2*2*0.015*s_hip3*s_hip3_knee3\nt109 = 0.015*c_hip2_knee2 + 0.06*c_hip2\nt110 = 0.015*s_hip2_knee2 + 0.06*s_hip2\nt111 = 0.01*c_hip2^2 + 0.002*c_hip2_knee2^2 + 0.2*2*0.015*c_hip2*c_hip2_knee2\nt112 = t10 + t14 + 0.2*2*0.015*s_hip2*s_hip2_knee2\nt113 = 0.015*c_hip1_knee1 + 0.06*c_hip1\nt114 = 0.015*s_hip1_knee1 + 0.06*s_hip1\nt115 = 0.01*c_hip1^2 + 0.002*c_hip1_knee1^2 + 0.2*2*0.015*c_hip1*c_hip1_knee1\nt116 = t9 + t13 + 0.2*2*0.015*s_hip1*s_hip1_knee1\nt117 = t114 + t110 + t102 + t106\nt118 = t113 + t109 + t101 + t105\nt119 = 256/1875 + t104 + 0.4*t102 + t108 + 0.4*t106 + t112 + t116 - 0.4*t110 - 0.4*t114\nt120 = t115 + t111 + t107 + 4/1875 + t103\nt121 = t119 - 46/1875\nt122 = 46/1875 + t121\n";
        ///The names of the components of all outputs.
        pub const OUTPUTS: [&'static str; 12] = [
            "foot1.x",
            "foot1.y",
            "foot1.z",
            "foot2.x",
            "foot2.y",
            "foot2.z",
            "foot3.x",
            "foot3.y",
            "foot3.z",
            "foot4.x",
            "foot4.y",
            "foot4.z",
        ];
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::System<T, 29>
    for Quadruped<T> {
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn rhs(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 29>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 29> {
            let [_, _, _, qw_o, qx_o, qy_o, qz_o, q_hip1, q_knee1, q_hip2, q_knee2,
            q_hip3, q_knee3, q_hip4, q_knee4, qdx_p, qdy_p, qdz_p, qdx_o, qdy_o, qdz_o,
            qd_hip1, qd_knee1, qd_hip2, qd_knee2, qd_hip3, qd_knee3, qd_hip4, qd_knee4,
            ] = x.data.0[0];
            let k0 = self.constants[0];
            let k1 = self.constants[1];
            let k2 = self.constants[2];
            let k3 = self.constants[3];
            let (
                t3,
                t5,
                t6,
                t7,
                t10,
                t15,
                t21,
                t22,
                t24,
                t25,
                t26,
                t31,
                t32,
                t37,
                t42,
                t45,
                t49,
                t52,
                t56,
                t59,
                t63,
                t67,
                t68,
                t69,
                t70,
                t71,
                t72,
                t77,
                t81,
                t83,
                t87,
                t90,
                t91,
                t92,
                t93,
                t94,
                t96,
                t97,
                t99,
                t100,
                t102,
                t103,
                t105,
                t106,
                t108,
                t109,
                t111,
                t112,
                t114,
                t115,
                t117,
                t118,
                t122,
                t123,
                t124,
                t125,
                sin126,
                t128,
                t129,
                t130,
                t132,
                t133,
                t134,
                t135,
                t136,
                t137,
                t138,
                t139,
                t140,
                t142,
                t143,
                t144,
                t146,
                t147,
                t148,
                t149,
                t150,
                t151,
                t152,
                t153,
                t154,
                t155,
                t156,
                t157,
                t158,
                t159,
                t160,
                t161,
                t162,
                t163,
                t164,
                t165,
                t167,
                t168,
                t169,
                sin170,
                t171,
                t172,
                t173,
                t175,
                t176,
                t177,
                t178,
                t179,
                t180,
                t181,
                t182,
                t183,
                t185,
                t190,
                t191,
                t192,
                t193,
                t195,
                t196,
                t197,
                t198,
                t199,
                t201,
                t202,
                t203,
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
                t223,
                t224,
                t225,
                t226,
                t227,
                t228,
                t229,
                t230,
                t231,
                t232,
                t233,
                sin234,
                cos234,
                sin_hip3,
                cos_hip3,
                t235,
                t236,
                t237,
                t239,
                t240,
                t241,
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
                t254,
                t255,
                t256,
            ) = {
                let t0 = T::from_f64(0.5) * qx_o;
                let t1 = T::from_f64(0.5) * qy_o;
                let t2 = T::from_f64(0.5) * qz_o;
                let t3 = -(qdx_o * t0 + qdy_o * t1 + qdz_o * t2);
                let t4 = T::from_f64(0.5) * qw_o;
                let t5 = qdx_o * t4 - qdy_o * t2 + qdz_o * t1;
                let t6 = qdx_o * t2 + qdy_o * t4 - qdz_o * t0;
                let t7 = qdy_o * t0 - qdx_o * t1 + qdz_o * t4;
                let t8 = qx_o * qz_o;
                let t9 = qy_o * qw_o;
                let t10 = T::from_f64(2.0) * (t8 + t9);
                let t11 = t8 - t9;
                let t12 = q_hip4 + q_knee4;
                let t13 = qy_o * qy_o;
                let t14 = qz_o * qz_o;
                let t15 = T::from_f64(1.0) - T::from_f64(2.0) * (t13 + t14);
                let t16 = q_hip3 + q_knee3;
                let t17 = q_hip2 + q_knee2;
                let t18 = q_hip1 + q_knee1;
                let t19 = qx_o * qy_o;
                let t20 = qz_o * qw_o;
                let t21 = T::from_f64(2.0) * (t19 - t20);
                let t22 = T::from_f64(2.0) * (t19 + t20);
                let t23 = qx_o * qx_o;
                let t24 = T::from_f64(1.0) - T::from_f64(2.0) * (t13 + t23);
                let t25 = T::from_f64(1.0) - T::from_f64(2.0) * (t14 + t23);
                let t26 = T::from_f64(2.0) * t11;
                let t27 = T::from_f64(19.62) * t11;
                let t28 = qz_o * qy_o;
                let t29 = qx_o * qw_o;
                let t30 = t28 + t29;
                let t31 = T::from_f64(2.0) * (t28 - t29);
                let t32 = T::from_f64(2.0) * t30;
                let t33 = T::from_f64(19.62) * t30;
                let t34 = qdz_o * qdz_o;
                let t35 = qdy_o + qd_hip1;
                let t36 = t35 * t35;
                let t37 = t34 + t36;
                let t38 = t35 + qd_knee1;
                let t39 = t38 * t38;
                let t40 = qd_knee1 + t38;
                let t41 = t34 + t39;
                let t42 = qdz_o * qdx_o;
                let t43 = qdy_o + qd_hip3;
                let t44 = t43 * t43;
                let t45 = t34 + t44;
                let t46 = t43 + qd_knee3;
                let t47 = t46 * t46;
                let t48 = qd_knee3 + t46;
                let t49 = t34 + t47;
                let t50 = qdy_o + qd_hip2;
                let t51 = t50 * t50;
                let t52 = t34 + t51;
                let t53 = t50 + qd_knee2;
                let t54 = t53 * t53;
                let t55 = qd_knee2 + t53;
                let t56 = t34 + t54;
                let t57 = qdy_o + qd_hip4;
                let t58 = t57 * t57;
                let t59 = t34 + t58;
                let t60 = t57 + qd_knee4;
                let t61 = t60 * t60;
                let t62 = qd_knee4 + t60;
                let t63 = t34 + t61;
                let t64 = qdx_o * qdx_o;
                let t65 = t36 + t64;
                let t66 = t39 + t64;
                let t67 = t51 + t64;
                let t68 = t54 + t64;
                let t69 = t58 + t64;
                let t70 = t61 + t64;
                let t71 = t44 + t64;
                let t72 = t47 + t64;
                let t73 = T::from_f64(0.1) * (t34 + t64);
                let t74 = T::from_f64(0.2) * (t34 + qdy_o * qdy_o);
                let t75 = T::from_f64(9.81) * t24;
                let t76 = T::from_f64(0.2) * t42;
                let t77 = qdz_o * qdy_o;
                let t78 = T::from_f64(0.1) * t77;
                let t79 = t76 + t78;
                let t80 = t76 - t78;
                let t81 = t75 - t79;
                let t82 = t75 + t79;
                let t83 = qdy_o * qdx_o;
                let t84 = T::from_f64(0.1) * t83;
                let t85 = t74 - t84;
                let t86 = t74 + t84;
                let t87 = t27 + t85;
                let t88 = t27 - t85;
                let (sin89, _) = (k3 * t).sin_cos();
                let t90 = k2 * sin89;
                let t91 = t75 - t80;
                let t92 = t75 + t80;
                let t93 = t27 + t86;
                let t94 = t27 - t86;
                let t95 = qdx_o * qd_hip4;
                let t96 = t95 + qdx_o * t57;
                let t97 = t95 + qdx_o * t62;
                let t98 = qdz_o * qd_hip4;
                let t99 = t98 + qdz_o * t57;
                let t100 = t98 + qdz_o * t62;
                let t101 = qdx_o * qd_hip3;
                let t102 = t101 + qdx_o * t43;
                let t103 = t101 + qdx_o * t48;
                let t104 = qdz_o * qd_hip3;
                let t105 = t104 + qdz_o * t43;
                let t106 = t104 + qdz_o * t48;
                let t107 = qdx_o * qd_hip2;
                let t108 = t107 + qdx_o * t50;
                let t109 = t107 + qdx_o * t55;
                let t110 = qdz_o * qd_hip2;
                let t111 = t110 + qdz_o * t50;
                let t112 = t110 + qdz_o * t55;
                let t113 = qd_hip1 * qdx_o;
                let t114 = t113 + t35 * qdx_o;
                let t115 = t113 + qdx_o * t40;
                let t116 = qdz_o * qd_hip1;
                let t117 = t116 + qdz_o * t35;
                let t118 = t116 + qdz_o * t40;
                let t119 = T::from_f64(0.2) * t83;
                let t120 = t73 - t119;
                let t121 = t73 + t119;
                let t122 = t33 + t120;
                let t123 = t33 - t120;
                let t124 = t33 - t121;
                let t125 = t33 + t121;
                let [(sin126, cos126), (sin127, cos127)] = t17.sin_cos_pair(t18);
                let t128 = T::from_f64(0.015) * sin126;
                let t129 = T::from_f64(0.015) * cos126;
                let t130 = t10 * t128 - t15 * t129;
                let t131 = T::from_f64(0.002) * cos126;
                let t132 = cos126 * t131;
                let t133 = sin126 * t131;
                let t134 = T::from_f64(0.002) - t132;
                let t135 = t132 + t134;
                let t136 = T::from_f64(-1.0) / t135;
                let t137 = t130 * t136;
                let t138 = T::from_f64(0.015) * sin127;
                let t139 = T::from_f64(0.015) * cos127;
                let t140 = t10 * t138 - t15 * t139;
                let t141 = T::from_f64(0.002) * cos127;
                let t142 = cos127 * t141;
                let t143 = sin127 * t141;
                let t144 = T::from_f64(0.002) - t142;
                let t145 = t142 + t144;
                let t146 = T::from_f64(-1.0) / t145;
                let t147 = t140 * t146;
                let t148 = T::from_f64(0.0015) * cos127;
                let t149 = t146 * t148;
                let t150 = T::from_f64(0.0015) * cos126;
                let t151 = t136 * t150;
                let t152 = T::from_f64(0.0015) * sin127;
                let t153 = t146 * t152;
                let t154 = T::from_f64(0.0015) * sin126;
                let t155 = t136 * t154;
                let t156 = t128 * t24 - t129 * t26;
                let t157 = t136 * t156;
                let t158 = t138 * t24 - t139 * t26;
                let t159 = t146 * t158;
                let t160 = t128 * t31 - t129 * t22;
                let t161 = t136 * t160;
                let t162 = t138 * t31 - t139 * t22;
                let t163 = t146 * t162;
                let t164 = t138 * t41 - t139 * t42;
                let t165 = t128 * t56 - t129 * t42;
                let t166 = t139 * t66 - t138 * t42;
                let t167 = t129 * t68 - t128 * t42;
                let t168 = t129 * t112 + t128 * t109;
                let t169 = t139 * t118 + t138 * t115;
                let [(sin170, cos170), (sin_hip1, cos_hip1)] = t12.sin_cos_pair(q_hip1);
                let t171 = T::from_f64(0.015) * sin170;
                let t172 = T::from_f64(0.015) * cos170;
                let t173 = t10 * t171 - t15 * t172;
                let t174 = T::from_f64(0.002) * cos170;
                let t175 = cos170 * t174;
                let t176 = sin170 * t174;
                let t177 = T::from_f64(0.002) - t175;
                let t178 = t175 + t177;
                let t179 = T::from_f64(-1.0) / t178;
                let t180 = t173 * t179;
                let t181 = T::from_f64(0.06) * sin_hip1;
                let t182 = t138 + t181;
                let t183 = T::from_f64(0.2) * cos_hip1;
                let t184 = t139 * t183;
                let t185 = T::from_f64(0.2) * sin_hip1;
                let t186 = t138 * (t82 + t183 * t65 - t185 * t42) + t143 * (t66 - t41);
                let t187 = t186 + t42 * (t142 - t144)
                    - t139 * (t88 + t185 * t37 - t183 * t42);
                let t188 = t138 * t185;
                let t189 = t145 + t184 + t188;
                let t190 = t146 * t189;
                let t191 = T::from_f64(0.06) * cos_hip1;
                let t192 = t139 + t191;
                let t193 = t10 * t182 + t140 * t190 - t15 * t192;
                let t194 = T::from_f64(0.01) * cos_hip1;
                let t195 = cos_hip1 * t194;
                let t196 = t142 + t195 + T::from_f64(2.0) * t184;
                let t197 = sin_hip1 * t194;
                let t198 = T::from_f64(0.01) - t195;
                let t199 = t144 + t198 + T::from_f64(2.0) * t188;
                let t200 = t187 + t181 * t82 + t197 * (t65 - t37) + t185 * t166
                    + t42 * (t195 - t198);
                let t201 = t191 * t65 + t166 - t181 * t42;
                let t202 = t200 - t191 * t88 - t183 * t164;
                let t203 = k1 * qd_knee1 + k0 * (T::from_f64(1.0) + q_knee1) + t187;
                let t204 = t196 + t199;
                let t205 = T::from_f64(-1.0) / (t204 + t189 * t190);
                let t206 = t189 - T::from_f64(0.003) * sin127;
                let t207 = t204 + t190 * t206 - T::from_f64(0.2) * t182;
                let t208 = t193 * t205;
                let t209 = T::from_f64(0.1) * t192;
                let t210 = t209 + t190 * t148;
                let t211 = t205 * t210;
                let t212 = T::from_f64(0.0015) * cos170;
                let t213 = t179 * t212;
                let t214 = t146 * t206;
                let t215 = t205 * t207;
                let t216 = T::from_f64(0.1) * t182;
                let t217 = t216 + t190 * t152;
                let t218 = t205 * t217;
                let t219 = T::from_f64(0.0015) * sin170;
                let t220 = t179 * t219;
                let t221 = t171 * t24 - t172 * t26;
                let t222 = t179 * t221;
                let t223 = t182 * t24 + t190 * t158 - t192 * t26;
                let t224 = t205 * t223;
                let t225 = t171 * t31 - t172 * t22;
                let t226 = t179 * t225;
                let t227 = t182 * t31 + t190 * t162 - t192 * t22;
                let t228 = t205 * t227;
                let t229 = t171 * t63 - t172 * t42;
                let t230 = t172 * t70 - t171 * t42;
                let t231 = t202 + k1 * qd_hip1 + k0 * (q_hip1 - T::from_f64(0.5))
                    + t190 * t203 - t90;
                let t232 = t172 * t100 + t171 * t97;
                let t233 = t123 - t183 * t117 - t185 * t114;
                let [(sin234, cos234), (sin_hip3, cos_hip3)] = t16.sin_cos_pair(q_hip3);
                let t235 = T::from_f64(0.015) * sin234;
                let t236 = T::from_f64(0.015) * cos234;
                let t237 = t10 * t235 - t15 * t236;
                let t238 = T::from_f64(0.002) * cos234;
                let t239 = cos234 * t238;
                let t240 = sin234 * t238;
                let t241 = T::from_f64(0.002) - t239;
                let t242 = t239 + t241;
                let t243 = T::from_f64(-1.0) / t242;
                let t244 = t237 * t243;
                let t245 = T::from_f64(0.06) * sin_hip3;
                let t246 = t235 + t245;
                let t247 = T::from_f64(0.2) * cos_hip3;
                let t248 = t236 * t247;
                let t249 = T::from_f64(0.2) * sin_hip3;
                let t250 = t235 * t249;
                let t251 = t242 + t248 + t250;
                let t252 = t243 * t251;
                let t253 = T::from_f64(0.06) * cos_hip3;
                let t254 = t236 + t253;
                let t255 = t10 * t246 + t237 * t252 - t15 * t254;
                let t256 = T::from_f64(0.01) * cos_hip3;
                (
                    t3,
                    t5,
                    t6,
                    t7,
                    t10,
                    t15,
                    t21,
                    t22,
                    t24,
                    t25,
                    t26,
                    t31,
                    t32,
                    t37,
                    t42,
                    t45,
                    t49,
                    t52,
                    t56,
                    t59,
                    t63,
                    t67,
                    t68,
                    t69,
                    t70,
                    t71,
                    t72,
                    t77,
                    t81,
                    t83,
                    t87,
                    t90,
                    t91,
                    t92,
                    t93,
                    t94,
                    t96,
                    t97,
                    t99,
                    t100,
                    t102,
                    t103,
                    t105,
                    t106,
                    t108,
                    t109,
                    t111,
                    t112,
                    t114,
                    t115,
                    t117,
                    t118,
                    t122,
                    t123,
                    t124,
                    t125,
                    sin126,
                    t128,
                    t129,
                    t130,
                    t132,
                    t133,
                    t134,
                    t135,
                    t136,
                    t137,
                    t138,
                    t139,
                    t140,
                    t142,
                    t143,
                    t144,
                    t146,
                    t147,
                    t148,
                    t149,
                    t150,
                    t151,
                    t152,
                    t153,
                    t154,
                    t155,
                    t156,
                    t157,
                    t158,
                    t159,
                    t160,
                    t161,
                    t162,
                    t163,
                    t164,
                    t165,
                    t167,
                    t168,
                    t169,
                    sin170,
                    t171,
                    t172,
                    t173,
                    t175,
                    t176,
                    t177,
                    t178,
                    t179,
                    t180,
                    t181,
                    t182,
                    t183,
                    t185,
                    t190,
                    t191,
                    t192,
                    t193,
                    t195,
                    t196,
                    t197,
                    t198,
                    t199,
                    t201,
                    t202,
                    t203,
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
                    t223,
                    t224,
                    t225,
                    t226,
                    t227,
                    t228,
                    t229,
                    t230,
                    t231,
                    t232,
                    t233,
                    sin234,
                    cos234,
                    sin_hip3,
                    cos_hip3,
                    t235,
                    t236,
                    t237,
                    t239,
                    t240,
                    t241,
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
                    t254,
                    t255,
                    t256,
                )
            };
            let (
                t263,
                t266,
                t269,
                t272,
                t274,
                t275,
                t276,
                t280,
                t282,
                t284,
                t286,
                t288,
                t297,
                t298,
                t312,
                t328,
                t330,
                t332,
                t345,
                t366,
                t368,
                t369,
                t374,
                t379,
                t382,
                t384,
                t385,
                t386,
                t388,
                t390,
                t392,
                t399,
                t400,
                t420,
                t424,
                t425,
                t426,
                t429,
                t431,
                t433,
                t436,
                t440,
                t443,
                t448,
                t454,
                t455,
                t457,
                t458,
                t459,
                t461,
                t470,
                t472,
                t473,
                t479,
                t481,
                t482,
                t483,
                t487,
                t491,
                t495,
                t497,
                t505,
                t506,
                t509,
                t511,
            ) = {
                let t257 = cos_hip3 * t256;
                let t258 = t239 + t257 + T::from_f64(2.0) * t248;
                let t259 = sin_hip3 * t256;
                let t260 = T::from_f64(0.01) - t257;
                let t261 = t241 + t260 + T::from_f64(2.0) * t250;
                let t262 = t258 + t261;
                let t263 = T::from_f64(-1.0) / (t262 + t251 * t252);
                let t264 = t251 + T::from_f64(0.003) * sin234;
                let t265 = t262 + T::from_f64(0.2) * t246 + t252 * t264;
                let t266 = t255 * t263;
                let t267 = T::from_f64(0.0015) * cos234;
                let t268 = T::from_f64(0.0015) * sin234;
                let t269 = t243 * t267;
                let t270 = T::from_f64(0.1) * t254;
                let t271 = t270 + t252 * t267;
                let t272 = t263 * t271;
                let t273 = t270 + t209 + t269 * t264 + t272 * t265 + t149 * t206
                    + t211 * t207;
                let t274 = t243 * t264;
                let t275 = t263 * t265;
                let t276 = t243 * t268;
                let t277 = T::from_f64(0.1) * t246;
                let t278 = t277 + t252 * t268;
                let t279 = t277 + t216 + t274 * t268 + t275 * t278 + t214 * t152
                    + t215 * t217;
                let t280 = t263 * t278;
                let t281 = t235 * t24 - t236 * t26;
                let t282 = t243 * t281;
                let t283 = t246 * t24 + t252 * t281 - t254 * t26;
                let t284 = t263 * t283;
                let t285 = t235 * t31 - t236 * t22;
                let t286 = t243 * t285;
                let t287 = t246 * t31 + t252 * t285 - t254 * t22;
                let t288 = t263 * t287;
                let t289 = t235 * t49 - t236 * t42;
                let t290 = t181 * t37 + t164 - t191 * t42
                    + (t245 * t45 + t289 - t253 * t42);
                let t291 = t235 * (t91 + t247 * t71 - t249 * t42) + t240 * (t72 - t49);
                let t292 = t236 * t72 - t235 * t42;
                let t293 = t291 + t42 * (t239 - t241)
                    - t236 * (t93 + t249 * t45 - t247 * t42);
                let t294 = t293 + t245 * t91 + t259 * (t71 - t45) + t249 * t292
                    + t42 * (t257 - t260);
                let t295 = t294 - t253 * t93 - t247 * t289;
                let t296 = t253 * t71 + t292 - t245 * t42;
                let t297 = k1 * qd_knee3 + k0 * (T::from_f64(1.0) + q_knee3) + t293;
                let t298 = t90 + k1 * qd_hip3 + k0 * (q_hip3 - T::from_f64(0.5)) + t295
                    + t252 * t297;
                let t299 = t236 * t106 + t235 * t103;
                let t300 = t124 - t247 * t105 - t249 * t102;
                let [(sin_hip4, cos_hip4), (sin_hip2, cos_hip2)] = q_hip4
                    .sin_cos_pair(q_hip2);
                let t301 = T::from_f64(0.06) * sin_hip4;
                let t302 = t171 + t301;
                let t303 = t302 + t246;
                let t304 = T::from_f64(0.2) * cos_hip4;
                let t305 = t172 * t304;
                let t306 = T::from_f64(0.2) * sin_hip4;
                let t307 = t171 * (t81 + t304 * t69 - t306 * t42) + t176 * (t70 - t63);
                let t308 = t307 + t42 * (t175 - t177)
                    - t172 * (t87 + t306 * t59 - t304 * t42);
                let t309 = t171 * t306;
                let t310 = t178 + t305 + t309;
                let t311 = t310 + T::from_f64(0.003) * sin170;
                let t312 = t179 * t310;
                let t313 = T::from_f64(0.06) * cos_hip4;
                let t314 = t172 + t313;
                let t315 = t314 + t254;
                let t316 = t10 * t302 + t173 * t312 - t15 * t314;
                let t317 = T::from_f64(0.01) * cos_hip4;
                let t318 = cos_hip4 * t317;
                let t319 = t175 + t318 + T::from_f64(2.0) * t305;
                let t320 = sin_hip4 * t317;
                let t321 = T::from_f64(0.01) - t318;
                let t322 = t177 + t321 + T::from_f64(2.0) * t309;
                let t323 = t308 + t301 * t81 + t320 * (t69 - t59) + t306 * t230
                    + t42 * (t318 - t321);
                let t324 = t313 * t69 + t230 - t301 * t42;
                let t325 = t323 - t313 * t87 - t304 * t229;
                let t326 = t321 * t96 + t320 * t99 + t177 * t97 + t176 * t100
                    + t306 * t232;
                let t327 = t326 + t260 * t102 + t259 * t105 + t241 * t103 + t240 * t106;
                let t328 = k1 * qd_knee4 + k0 * (T::from_f64(1.0) + q_knee4) + t308;
                let t329 = t319 + t322;
                let t330 = T::from_f64(-1.0) / (t329 + t310 * t312);
                let t331 = t329 + T::from_f64(0.2) * t302 + t312 * t311;
                let t332 = t316 * t330;
                let t333 = T::from_f64(5.8) + t173 * t180 + t316 * t332 + t237 * t244
                    + t255 * t266;
                let t334 = T::from_f64(0.06) * sin_hip2;
                let t335 = t128 + t334;
                let t336 = t335 + t182;
                let t337 = T::from_f64(0.2) * cos_hip2;
                let t338 = t129 * t337;
                let t339 = T::from_f64(0.2) * sin_hip2;
                let t340 = t128 * (t92 + t337 * t67 - t339 * t42) + t133 * (t68 - t56);
                let t341 = t340 + t42 * (t132 - t134)
                    - t129 * (t94 + t339 * t52 - t337 * t42);
                let t342 = t128 * t339;
                let t343 = t135 + t338 + t342;
                let t344 = t343 - T::from_f64(0.003) * sin126;
                let t345 = t136 * t343;
                let t346 = T::from_f64(0.06) * cos_hip2;
                let t347 = t334 * t52 + t165 - t346 * t42
                    + (t301 * t59 + t229 - t313 * t42);
                let t348 = t129 + t346;
                let t349 = t348 + t192;
                let t350 = t10 * t335 + t130 * t345 - t15 * t348;
                let t351 = T::from_f64(0.01) * cos_hip2;
                let t352 = cos_hip2 * t351;
                let t353 = sin_hip2 * t351;
                let t354 = t132 + t352 + T::from_f64(2.0) * t338;
                let t355 = T::from_f64(0.01) - t352;
                let t356 = t341 + t334 * t92 + t353 * (t67 - t52) + t339 * t167
                    + t42 * (t352 - t355);
                let t357 = t356 - t346 * t94 - t337 * t165;
                let t358 = t346 * t67 + t167 - t334 * t42;
                let t359 = t134 + t355 + T::from_f64(2.0) * t342;
                let t360 = T::from_f64(0.13653333333333334) + t322 + t261 + t359 + t199
                    + T::from_f64(0.4) * (t303 - t336);
                let t361 = t327 + t249 * t299 + t355 * t108 + t353 * t111 + t134 * t109;
                let t362 = t303 + t336;
                let t363 = t361 + t133 * t112 + t339 * t168 + t198 * t114 + t197 * t117;
                let t364 = t363 + t144 * t115 + t143 * t118 + t185 * t169 + t269 * t297;
                let t365 = t354 + t359;
                let t366 = T::from_f64(-1.0) / (t365 + t343 * t345);
                let t367 = t365 + t345 * t344 - T::from_f64(0.2) * t335;
                let t368 = k1 * qd_knee2 + k0 * (T::from_f64(1.0) + q_knee2) + t341;
                let t369 = t350 * t366;
                let t370 = t333 + t130 * t137 + t350 * t369 + t140 * t147 + t193 * t208;
                let t371 = t237 * t269 + t255 * t272 + t140 * t149 + t193 * t211
                    - t21 * t362;
                let t372 = T::from_f64(0.1) * t314;
                let t373 = t372 + t312 * t212;
                let t374 = t330 * t373;
                let t375 = T::from_f64(0.024533333333333334) + t360 + t212 * t213
                    + t373 * t374 + t267 * t269 + t271 * t272;
                let t376 = T::from_f64(0.1) * t348;
                let t377 = t273 - t372 - t376 - t213 * t311 - t374 * t331 - t151 * t344;
                let t378 = t376 + t345 * t150;
                let t379 = t366 * t378;
                let t380 = t375 + t150 * t151 + t378 * t379 + t148 * t149 + t210 * t211;
                let t381 = t371 - t173 * t213 - t316 * t374 - t130 * t151 - t350 * t379;
                let t382 = T::from_f64(-1.0) / t380;
                let t383 = t377 - t379 * t367;
                let t384 = t381 * t382;
                let t385 = t179 * t311;
                let t386 = t330 * t331;
                let t387 = t10 * t362 + t173 * t385 + t316 * t386 + t237 * t274
                    + t255 * t275;
                let t388 = t136 * t344;
                let t389 = t311 * t385 + t331 * t386 + t264 * t274 + t265 * t275
                    + t344 * t388;
                let t390 = t366 * t367;
                let t391 = t387 + t130 * t388 + t350 * t390 + t140 * t214 + t193 * t215;
                let t392 = t382 * t383;
                let t393 = t389 + t367 * t390 + t206 * t214 + t207 * t215 + t383 * t392;
                let t394 = t315 + t349;
                let t395 = t391 + t381 * t392 - t15 * t394;
                let t396 = t360 - T::from_f64(0.024533333333333334);
                let t397 = T::from_f64(0.024533333333333334) + t396;
                let t398 = T::from_f64(0.0021333333333333334) + t319 + t258 + t354 + t196
                    + t397;
                let t399 = T::from_f64(-1.0) / (t393 + t398);
                let t400 = t395 * t399;
                let t401 = t21 * t394 + t237 * t276 + t255 * t280 + t140 * t153
                    + t193 * t218;
                let t402 = T::from_f64(0.1) * t302;
                let t403 = t402 + t312 * t219;
                let t404 = t213 * t219 + t374 * t403 + t269 * t268 + t272 * t278
                    + t151 * t154;
                let t405 = T::from_f64(0.1) * t335;
                let t406 = t405 + t345 * t154;
                let t407 = t404 + t379 * t406 + t149 * t152 + t211 * t217
                    + T::from_f64(0.2) * (t349 - t315);
                let t408 = t407 - t320 - t176 - t171 * t304 - t172 * t306 - t259 - t240;
                let t409 = t408 - t235 * t247 - t236 * t249 - t353 - t133 - t128 * t337;
                let t410 = t409 - t129 * t339 - t197 - t143 - t138 * t183 - t139 * t185;
                let t411 = t279 + t392 * t410 - t402 - t405 - t385 * t219 - t386 * t403;
                let t412 = t411 - t388 * t154 - t390 * t406;
                let t413 = t122 - t304 * t99 - t306 * t96;
                let t414 = t313 * t122 + t172 * t413 + t253 * t124 + t236 * t300
                    + t346 * t125;
                let t415 = t313 * t99 + t301 * t96 + t232
                    + (t253 * t105 + t245 * t102 + t299);
                let t416 = t191 * t117 + t181 * t114 + t169
                    + (t346 * t111 + t334 * t108 + t168);
                let t417 = t364 + t272 * t298 + t149 * t203 + t211 * t231
                    + T::from_f64(0.2) * (t415 - t416);
                let t418 = t417 + T::from_f64(0.1) * (t347 - t290)
                    + T::from_f64(0.112) * t83 - t301 * t122 - t171 * t413;
                let t419 = t290 + t347;
                let t420 = t416 + t415;
                let t421 = t125 - t337 * t111 - t339 * t108;
                let t422 = t418 - t245 * t124 - t235 * t300 - t334 * t125 - t128 * t421;
                let t423 = t414 + t129 * t421 + t191 * t123 + t139 * t233 + t276 * t297;
                let t424 = t382 * t410;
                let t425 = t399 * t412;
                let t426 = t330 * t403;
                let t427 = t360 + t219 * t220 + t403 * t426 + t268 * t276 + t278 * t280;
                let t428 = t401 + t381 * t424 + t395 * t425 - t173 * t220 - t316 * t426;
                let t429 = t366 * t406;
                let t430 = t427 + t154 * t155 + t406 * t429 + t152 * t153 + t217 * t218;
                let t431 = T::from_f64(-1.0)
                    / (t430 + t410 * t424 + t412 * t425 + t398 - t396 - t397);
                let t432 = t428 - t130 * t155 - t350 * t429;
                let t433 = t432 * t431;
                let t434 = t302 * t24 + t312 * t221 - t314 * t26;
                let t435 = t302 * t31 + t312 * t225 - t314 * t22;
                let t436 = t330 * t434;
                let t437 = t173 * t222 + t316 * t436 + t237 * t282 + t255 * t284
                    + t130 * t157;
                let t438 = t335 * t24 + t345 * t156 - t348 * t26;
                let t439 = t335 * t31 + t345 * t160 - t348 * t22;
                let t440 = t366 * t438;
                let t441 = t269 * t281 + t272 * t283 + t149 * t158 + t211 * t223
                    - t362 * t32;
                let t442 = t441 - t213 * t221 - t374 * t434 - t151 * t156 - t379 * t438;
                let t443 = t382 * t442;
                let t444 = t437 + t350 * t440 + t140 * t159 + t193 * t224 + t381 * t443;
                let t445 = t362 * t24 + t385 * t221 + t386 * t434 + t274 * t281
                    + t275 * t283;
                let t446 = t445 + t388 * t156 + t390 * t438 + t214 * t158 + t215 * t223;
                let t447 = t446 + t392 * t442 - t394 * t26;
                let t448 = t399 * t447;
                let t449 = t394 * t32 + t276 * t281 + t280 * t283 + t153 * t158
                    + t218 * t223;
                let t450 = T::from_f64(5.8) + t221 * t222 + t434 * t436 + t281 * t282
                    + t283 * t284;
                let t451 = t449 + t424 * t442 + t425 * t447 - t220 * t221 - t426 * t434;
                let t452 = t450 + t156 * t157 + t438 * t440 + t158 * t159 + t223 * t224;
                let t453 = t451 - t155 * t156 - t429 * t438;
                let t454 = t431 * t453;
                let t455 = T::from_f64(-1.0)
                    / (t452 + t442 * t443 + t447 * t448 + t453 * t454);
                let t456 = t444 + t395 * t448 + t432 * t454;
                let t457 = t456 * t455;
                let t458 = t370 + t381 * t384 + t395 * t400 + t432 * t433 + t456 * t457;
                let t459 = t330 * t435;
                let t460 = t173 * t226 + t316 * t459 + t237 * t286 + t255 * t288
                    + t130 * t161;
                let t461 = t366 * t439;
                let t462 = t269 * t285 + t272 * t287 + t149 * t162 + t211 * t227
                    - t362 * t25;
                let t463 = t462 - t213 * t225 - t374 * t435 - t151 * t160 - t379 * t439;
                let t464 = t362 * t31 + t385 * t225 + t386 * t435 + t274 * t285
                    + t275 * t287;
                let t465 = t464 + t388 * t160 + t390 * t439 + t214 * t162 + t215 * t227;
                let t466 = t465 + t392 * t463 - t394 * t22;
                let t467 = t394 * t25 + t276 * t285 + t280 * t287 + t153 * t162
                    + t218 * t227;
                let t468 = t467 + t424 * t463 + t425 * t466 - t220 * t225 - t426 * t435;
                let t469 = t468 - t155 * t160 - t429 * t439;
                let t470 = t382 * t463;
                let t471 = t460 + t350 * t461 + t140 * t163 + t193 * t228 + t381 * t470;
                let t472 = t399 * t466;
                let t473 = t431 * t469;
                let t474 = t222 * t225 + t436 * t435 + t282 * t285 + t284 * t287
                    + t157 * t160;
                let t475 = T::from_f64(5.8) + t225 * t226 + t435 * t459 + t285 * t286
                    + t287 * t288;
                let t476 = t475 + t160 * t161 + t439 * t461 + t162 * t163 + t227 * t228;
                let t477 = t474 + t440 * t439 + t159 * t162 + t224 * t227 + t443 * t463;
                let t478 = t477 + t448 * t466 + t454 * t469;
                let t479 = t455 * t478;
                let t480 = t476 + t463 * t470 + t466 * t472 + t469 * t473 + t478 * t479;
                let t481 = t471 + t395 * t472 + t432 * t473 + t456 * t479;
                let t482 = T::from_f64(-1.0) / t480;
                let t483 = t481 * t482;
                let t484 = t201 + t358;
                let t485 = t324 + t296;
                let t486 = t484 + t485;
                let t487 = t325 + k1 * qd_hip4 + k0 * (q_hip4 - T::from_f64(0.5))
                    + t312 * t328 - t90;
                let t488 = t422 - t181 * t123 - t138 * t233 - t213 * t328 - t374 * t487;
                let t489 = t325 + t295 + t357 + t202 + t385 * t328 + t386 * t487
                    + t274 * t297;
                let t490 = t15 * t419 + t10 * t486 + t180 * t328 + t332 * t487
                    + t244 * t297;
                let t491 = t90 + k1 * qd_hip2 + k0 * (q_hip2 - T::from_f64(0.5)) + t357
                    + t345 * t368;
                let t492 = T::from_f64(56.898) + t26 * t419 + t24 * t486 + t222 * t328
                    + t436 * t487;
                let t493 = t22 * t419 + t31 * t486 + t226 * t328 + t459 * t487
                    + t286 * t297;
                let t494 = t490 + t266 * t298 + t137 * t368 + t369 * t491 + t147 * t203;
                let t495 = t488 - t151 * t368 - t379 * t491;
                let t496 = t489 + t275 * t298 + t388 * t368 + t390 * t491 + t214 * t203;
                let t497 = t496 + t215 * t231 + t392 * t495
                    + T::from_f64(0.2) * (t485 - t484) + T::from_f64(-0.1344) * t42;
                let t498 = t423 + t280 * t298 + t153 * t203 + t218 * t231 + t424 * t495;
                let t499 = t498 + t425 * t497
                    + T::from_f64(0.1) * (t201 + t296 - t358 - t324)
                    + T::from_f64(0.0224) * t77;
                let t500 = t499 - t318 * t99 - t320 * t96 - t175 * t100 - t176 * t97;
                let t501 = t500 - t304 * t232 - t257 * t105 - t259 * t102 - t239 * t106;
                let t502 = t501 - t240 * t103 - t247 * t299 - t352 * t111 - t353 * t108;
                let t503 = t502 - t132 * t112 - t133 * t109 - t337 * t168 - t195 * t117;
                let t504 = t503 - t197 * t114 - t142 * t118 - t143 * t115 - t183 * t169;
                let t505 = t504 - t220 * t328 - t426 * t487 - t155 * t368 - t429 * t491;
                let t506 = t494 + t208 * t231 + t384 * t495 + t400 * t497 + t433 * t505;
                let t507 = t492 + t282 * t297 + t284 * t298 + t157 * t368 + t440 * t491;
                let t508 = t507 + t159 * t203 + t224 * t231 + t443 * t495 + t448 * t497;
                let t509 = t508 + t454 * t505 - t32 * t420;
                let t510 = t493 + t288 * t298 + t161 * t368 + t461 * t491 + t163 * t203;
                let t511 = t510 + t228 * t231 + t470 * t495 + t472 * t497 + t473 * t505;
                (
                    t263,
                    t266,
                    t269,
                    t272,
                    t274,
                    t275,
                    t276,
                    t280,
                    t282,
                    t284,
                    t286,
                    t288,
                    t297,
                    t298,
                    t312,
                    t328,
                    t330,
                    t332,
                    t345,
                    t366,
                    t368,
                    t369,
                    t374,
                    t379,
                    t382,
                    t384,
                    t385,
                    t386,
                    t388,
                    t390,
                    t392,
                    t399,
                    t400,
                    t420,
                    t424,
                    t425,
                    t426,
                    t429,
                    t431,
                    t433,
                    t436,
                    t440,
                    t443,
                    t448,
                    t454,
                    t455,
                    t457,
                    t458,
                    t459,
                    t461,
                    t470,
                    t472,
                    t473,
                    t479,
                    t481,
                    t482,
                    t483,
                    t487,
                    t491,
                    t495,
                    t497,
                    t505,
                    t506,
                    t509,
                    t511,
                )
            };
            let (
                t513,
                t514,
                t515,
                t516,
                t517,
                t527,
                t528,
                t529,
                t530,
                t531,
                t532,
                t533,
                t534,
                t535,
            ) = {
                let t512 = t511 + t479 * t509 - t25 * t420;
                let t513 = T::from_f64(-1.0) / (t458 + t481 * t483)
                    * (t506 + t457 * t509 + t483 * t512 - t21 * t420);
                let t514 = t482 * t512 + t483 * t513;
                let t515 = t455 * t509 + t457 * t513 + t479 * t514;
                let t516 = t431 * t505 + t433 * t513 + t473 * t514 + t454 * t515;
                let t517 = t399 * t497 + t400 * t513 + t472 * t514 + t448 * t515
                    + t425 * t516;
                let t518 = t382 * t495 + t384 * t513 + t470 * t514 + t443 * t515
                    + t424 * t516;
                let t519 = t205 * t231 + t208 * t513 + t228 * t514 + t224 * t515
                    + t218 * t516;
                let t520 = t146 * t203 + t147 * t513 + t163 * t514 + t159 * t515
                    + t153 * t516;
                let t521 = t366 * t491 + t369 * t513 + t461 * t514 + t440 * t515
                    + t390 * t517;
                let t522 = t136 * t368 + t137 * t513 + t161 * t514 + t157 * t515
                    + t388 * t517;
                let t523 = t263 * t298 + t266 * t513 + t288 * t514 + t284 * t515
                    + t280 * t516;
                let t524 = t243 * t297 + t244 * t513 + t286 * t514 + t282 * t515
                    + t276 * t516;
                let t525 = t330 * t487 + t332 * t513 + t459 * t514 + t436 * t515
                    + t386 * t517;
                let t526 = t179 * t328 + t180 * t513 + t226 * t514 + t222 * t515
                    + t385 * t517;
                let t527 = t518 + t392 * t517;
                let t528 = t519 + t215 * t517 + t211 * t527;
                let t529 = t520 + t214 * t517 + t149 * t527 + t190 * t528;
                let t530 = t521 - t429 * t516 - t379 * t527;
                let t531 = t522 + t345 * t530 - t155 * t516 - t151 * t527;
                let t532 = t523 + t275 * t517 + t272 * t527;
                let t533 = t524 + t274 * t517 + t269 * t527 + t252 * t532;
                let t534 = t525 - t426 * t516 - t374 * t527;
                let t535 = t526 + t312 * t534 - t220 * t516 - t213 * t527;
                (
                    t513,
                    t514,
                    t515,
                    t516,
                    t517,
                    t527,
                    t528,
                    t529,
                    t530,
                    t531,
                    t532,
                    t533,
                    t534,
                    t535,
                )
            };
            ::pendulum_core::nalgebra::SVector::from([
                qdx_p,
                qdy_p,
                qdz_p,
                t3,
                t5,
                t6,
                t7,
                qd_hip1,
                qd_knee1,
                qd_hip2,
                qd_knee2,
                qd_hip3,
                qd_knee3,
                qd_hip4,
                qd_knee4,
                t513,
                t514,
                t515,
                t516,
                t517,
                t527,
                t528,
                t529,
                t530,
                t531,
                t532,
                t533,
                t534,
                t535,
            ])
        }
        #[inline]
        fn layout(
            &self,
        ) -> ::core::option::Option<&'static ::pendulum_core::StateLayout> {
            Some(&<Quadruped>::LAYOUT)
        }
        #[inline]
        fn project(&self, t: T, x: &mut ::pendulum_core::nalgebra::SVector<T, 29>) {
            let norm = (x[3] * x[3] + x[4] * x[4] + x[5] * x[5] + x[6] * x[6]).sqrt();
            x[3] /= norm;
            x[4] /= norm;
            x[5] /= norm;
            x[6] /= norm;
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> ::pendulum_core::Energy<T, 29>
    for Quadruped<T> {
        #[inline]
        fn kinetic(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 29>) -> T {
            let [_, _, _, qw_o, qx_o, qy_o, qz_o, q_hip1, q_knee1, q_hip2, q_knee2,
            q_hip3, q_knee3, q_hip4, q_knee4, qdx_p, qdy_p, qdz_p, qdx_o, qdy_o, qdz_o,
            qd_hip1, qd_knee1, qd_hip2, qd_knee2, qd_hip3, qd_knee3, qd_hip4, qd_knee4,
            ] = x.data.0[0];
            let t0 = q_hip4 + q_knee4;
            let t1 = qdy_o + qd_hip4;
            let t2 = qx_o * qx_o;
            let t3 = qy_o * qy_o;
            let t4 = T::from_f64(1.0) - T::from_f64(2.0) * (t2 + t3);
            let t5 = qx_o * qz_o;
            let t6 = qy_o * qw_o;
            let t7 = T::from_f64(2.0) * (t5 + t6);
            let t8 = T::from_f64(2.0) * (t5 - t6);
            let t9 = qy_o * qz_o;
            let t10 = qx_o * qw_o;
            let t11 = T::from_f64(2.0) * (t9 - t10);
            let t12 = T::from_f64(2.0) * (t9 + t10);
            let t13 = qdz_p * t4 + qdx_p * t7 + qdy_p * t11;
            let t14 = T::from_f64(0.2) * qdy_o;
            let t15 = T::from_f64(0.1) * qdx_o;
            let t16 = t14 - t15;
            let t17 = t14 + t15;
            let t18 = t13 + t16;
            let t19 = t13 - t16;
            let t20 = qd_knee4 + t1;
            let t21 = T::from_f64(0.1) * qdz_o;
            let t22 = qz_o * qz_o;
            let t23 = T::from_f64(1.0) - T::from_f64(2.0) * (t3 + t22);
            let t24 = T::from_f64(1.0) - T::from_f64(2.0) * (t2 + t22);
            let t25 = qx_o * qy_o;
            let t26 = qz_o * qw_o;
            let t27 = T::from_f64(2.0) * (t25 + t26);
            let t28 = T::from_f64(2.0) * (t25 - t26);
            let t29 = qdz_p * t8 + qdx_p * t23 + qdy_p * t27;
            let t30 = t21 + t29;
            let t31 = t29 - t21;
            let t32 = q_hip3 + q_knee3;
            let t33 = qdy_o + qd_hip3;
            let t34 = t13 + t17;
            let t35 = t13 - t17;
            let t36 = qd_knee3 + t33;
            let t37 = q_hip2 + q_knee2;
            let t38 = q_hip1 + q_knee1;
            let t39 = qdy_o + qd_hip2;
            let t40 = qd_knee2 + t39;
            let t41 = qdy_o + qd_hip1;
            let t42 = qd_knee1 + t41;
            let t43 = qdz_p * t12 + qdx_p * t28 + qdy_p * t24;
            let t44 = T::from_f64(0.2) * qdz_o;
            let t45 = t43 - t44;
            let t46 = t43 + t44;
            let [(sin47, cos47), (sin48, cos48)] = t37.sin_cos_pair(t38);
            let t49 = T::from_f64(0.015) * sin47;
            let t50 = T::from_f64(0.002) * cos47;
            let t51 = cos47 * t50;
            let t52 = T::from_f64(0.002) - t51;
            let t53 = T::from_f64(0.015) * cos47;
            let t54 = t53 * t40;
            let t55 = t49 * t40;
            let t56 = T::from_f64(0.015) * sin48;
            let t57 = T::from_f64(0.002) * cos48;
            let t58 = cos48 * t57;
            let t59 = T::from_f64(0.002) - t58;
            let t60 = T::from_f64(0.015) * cos48;
            let t61 = t60 * t42;
            let t62 = t56 * t42;
            let t63 = qdx_o * t53 - qdz_o * t49;
            let t64 = qdx_o * t60 - qdz_o * t56;
            let [(sin65, cos65), (sin_hip1, cos_hip1)] = t0.sin_cos_pair(q_hip1);
            let t66 = T::from_f64(0.015) * sin65;
            let t67 = T::from_f64(0.002) * cos65;
            let t68 = cos65 * t67;
            let t69 = T::from_f64(0.002) - t68;
            let t70 = T::from_f64(0.015) * cos65;
            let t71 = t70 * t20;
            let t72 = t66 * t20;
            let t73 = T::from_f64(0.2) * sin_hip1;
            let t74 = T::from_f64(0.2) * cos_hip1;
            let t75 = t56 * (t73 * t41 + t19) + t42 * (t58 + t59)
                - t60 * (t31 - t41 * t74);
            let t76 = T::from_f64(0.06) * sin_hip1;
            let t77 = T::from_f64(0.01) * cos_hip1;
            let t78 = cos_hip1 * t77;
            let t79 = T::from_f64(0.01) - t78;
            let t80 = t75 + t19 * t76 + t74 * t61 + t73 * t62 + t41 * (t78 + t79);
            let t81 = t62 + t41 * t76;
            let t82 = T::from_f64(0.06) * cos_hip1;
            let t83 = t80 - t31 * t82;
            let t84 = qdx_o * t70 - t66 * qdz_o;
            let t85 = t46 + qdx_o * t74 - qdz_o * t73;
            let [(sin86, cos86), (sin_hip3, cos_hip3)] = t32.sin_cos_pair(q_hip3);
            let t87 = T::from_f64(0.015) * sin86;
            let t88 = T::from_f64(0.2) * sin_hip3;
            let t89 = T::from_f64(0.002) * cos86;
            let t90 = cos86 * t89;
            let t91 = T::from_f64(0.002) - t90;
            let t92 = T::from_f64(0.015) * cos86;
            let t93 = T::from_f64(0.2) * cos_hip3;
            let t94 = t87 * (t88 * t33 + t34) + t36 * (t90 + t91)
                - t92 * (t31 - t33 * t93);
            let t95 = T::from_f64(0.06) * sin_hip3;
            let t96 = t92 * t36;
            let t97 = t87 * t36;
            let t98 = T::from_f64(0.01) * cos_hip3;
            let t99 = cos_hip3 * t98;
            let t100 = T::from_f64(0.01) - t99;
            let t101 = t94 + t34 * t95 + t93 * t96 + t88 * t97 + t33 * (t99 + t100);
            let t102 = t97 + t33 * t95;
            let t103 = T::from_f64(0.06) * cos_hip3;
            let t104 = t96 + t33 * t103 + (t61 + t41 * t82);
            let t105 = t101 - t31 * t103;
            let t106 = qdx_o * t92 - qdz_o * t87;
            let t107 = t45 + qdx_o * t93 - qdz_o * t88;
            let [(sin_hip4, cos_hip4), (sin_hip2, cos_hip2)] = q_hip4
                .sin_cos_pair(q_hip2);
            let t108 = T::from_f64(0.2) * sin_hip4;
            let t109 = T::from_f64(0.2) * cos_hip4;
            let t110 = t66 * (t108 * t1 + t18) + t20 * (t68 + t69)
                - t70 * (t30 - t1 * t109);
            let t111 = T::from_f64(0.06) * sin_hip4;
            let t112 = T::from_f64(0.01) * cos_hip4;
            let t113 = cos_hip4 * t112;
            let t114 = T::from_f64(0.01) - t113;
            let t115 = t110 + t18 * t111 + t109 * t71 + t108 * t72 + t1 * (t113 + t114);
            let t116 = t72 + t1 * t111;
            let t117 = T::from_f64(0.06) * cos_hip4;
            let t118 = t115 - t30 * t117;
            let t119 = T::from_f64(0.2) * sin_hip2;
            let t120 = T::from_f64(0.2) * cos_hip2;
            let t121 = t49 * (t119 * t39 + t35) + t40 * (t51 + t52)
                - t53 * (t30 - t39 * t120);
            let t122 = qd_knee4 * t110 + qd_hip4 * t118 + qd_knee3 * t94 + qd_hip3 * t105
                + qd_knee2 * t121;
            let t123 = T::from_f64(0.06) * sin_hip2;
            let t124 = T::from_f64(0.01) * cos_hip2;
            let t125 = sin_hip4 * t112 + sin65 * t67 + sin_hip3 * t98 + sin86 * t89
                + sin_hip2 * t124;
            let t126 = t125 + sin47 * t50 + sin_hip1 * t77 + sin48 * t57;
            let t127 = cos_hip2 * t124;
            let t128 = T::from_f64(0.02666666666666667) + t68 + t113 + t90 + t99 + t51
                + t127 + t58 + t78;
            let t129 = T::from_f64(0.06) * cos_hip2;
            let t130 = t71 + t1 * t117 + (t54 + t39 * t129);
            let t131 = T::from_f64(0.01) - t127;
            let t132 = T::from_f64(0.16106666666666666) + t69 + t114 + t91 + t100 + t52
                + t131 + t59 + t79;
            let t133 = t121 + t35 * t123 + t120 * t54 + t119 * t55 + t39 * (t127 + t131);
            let t134 = t133 - t30 * t129;
            let t135 = t55 + t39 * t123;
            let t136 = t63 + qdx_o * t129 - qdz_o * t123
                + (t64 + qdx_o * t82 - qdz_o * t76);
            let t137 = t84 + qdx_o * t117 - qdz_o * t111
                + (t106 + qdx_o * t103 - qdz_o * t95);
            let t138 = t45 + qdx_o * t109 - t108 * qdz_o;
            let t139 = t109 * t84 + t70 * t138 + t93 * t106 + t92 * t107 + t120 * t63;
            let t140 = qdz_o * t132 + T::from_f64(0.2) * (t136 - t137)
                + T::from_f64(0.1) * (t104 - t130) - t66 * t138;
            let t141 = t137 + t136;
            let t142 = t130 + t104;
            let t143 = t46 + qdx_o * t120 - qdz_o * t119;
            let t144 = t140 - t108 * t84 - t87 * t107 - t88 * t106 - t49 * t143;
            let t145 = t139 + t53 * t143 + t74 * t64 + t60 * t85 + qdx_o * t128;
            let t146 = t144 - t119 * t63 - t56 * t85 - t73 * t64 - qdx_o * t126;
            let t147 = t122 + qd_hip2 * t134 + qd_knee1 * t75 + qd_hip1 * t83
                + qdz_o * (t146 - t45 * (t111 + t95) - t46 * (t123 + t76));
            let t148 = t145 + T::from_f64(0.1) * (t102 + t81 - t116 - t135)
                + t45 * (t117 + t103);
            let t149 = t116 + t102;
            let t150 = t135 + t81;
            let t151 = t118 + t105 + t134 + t83 + T::from_f64(0.2) * (t149 - t150)
                + T::from_f64(0.13866666666666666) * qdy_o;
            let t152 = t147 + qdy_o * t151
                + qdx_o * (t148 + t46 * (t129 + t82) - qdz_o * t126);
            let t153 = t149 + t150;
            let t154 = qdz_p
                * (t12 * t141 + t4 * t153 + T::from_f64(5.8) * qdz_p - t8 * t142);
            let t155 = qdx_p
                * (t28 * t141 + t7 * t153 + T::from_f64(5.8) * qdx_p - t23 * t142);
            let t156 = qdy_p
                * (t24 * t141 + t11 * t153 + T::from_f64(5.8) * qdy_p - t27 * t142);
            T::from_f64(0.5) * (t152 + t154 + t155 + t156)
        }
        #[inline]
        fn potential(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, 29>) -> T {
            let [_, _, qz_p, qw_o, qx_o, qy_o, qz_o, q_hip1, q_knee1, q_hip2, q_knee2,
            q_hip3, q_knee3, q_hip4, q_knee4, _, _, _, _, _, _, _, _, _, _, _, _, _, _,
            ] = x.data.0[0];
            let k4 = self.constants[4];
            let t0 = T::from_f64(0.09) * (qz_o * qy_o + qx_o * qw_o);
            let t1 = q_hip4 + q_knee4;
            let t2 = q_hip1 + q_knee1;
            let t3 = q_hip3 + q_knee3;
            let t4 = q_hip2 + q_knee2;
            let t5 = T::from_f64(1.0) + q_knee4;
            let t6 = T::from_f64(1.0) + q_knee3;
            let t7 = T::from_f64(1.0) + q_knee2;
            let t8 = T::from_f64(1.0) + q_knee1;
            let t9 = q_hip4 - T::from_f64(0.5);
            let t10 = t5 * t5 + t6 * t6 + t7 * t7 + t8 * t8 + t9 * t9;
            let t11 = q_hip3 - T::from_f64(0.5);
            let t12 = q_hip1 - T::from_f64(0.5);
            let t13 = q_hip2 - T::from_f64(0.5);
            let [(sin14, cos14), (sin15, cos15)] = t3.sin_cos_pair(t4);
            let [(sin16, cos16), (sin_hip2, cos_hip2)] = t1.sin_cos_pair(q_hip2);
            let t17 = T::from_f64(0.03) * sin_hip2;
            let t18 = T::from_f64(0.03) * cos_hip2;
            let [(sin_hip3, cos_hip3), (sin19, cos19)] = q_hip3.sin_cos_pair(t2);
            let t20 = T::from_f64(0.03) * sin_hip3;
            let t21 = T::from_f64(0.03) * cos_hip3;
            let [(sin_hip4, cos_hip4), (sin_hip1, cos_hip1)] = q_hip4
                .sin_cos_pair(q_hip1);
            let t22 = T::from_f64(0.03) * sin_hip4;
            let t23 = T::from_f64(-0.03) - t22 - t22 - T::from_f64(0.015) * sin16
                - T::from_f64(0.06)
                + (T::from_f64(-0.03) - t20 - t20 - T::from_f64(0.015) * sin14
                    - T::from_f64(0.06));
            let t24 = T::from_f64(0.03) * sin_hip1;
            let t25 = t23
                + (T::from_f64(0.06) + (T::from_f64(0.03) - t17) - t17
                    - T::from_f64(0.015) * sin15)
                + (T::from_f64(0.06) + (T::from_f64(0.03) - t24) - t24
                    - T::from_f64(0.015) * sin19);
            let t26 = t0 + t0 + T::from_f64(5.8) * qz_p
                + T::from_f64(2.0) * (qx_o * qz_o - qy_o * qw_o) * t25;
            let t27 = T::from_f64(0.03) * cos_hip4;
            let t28 = t27 + t27 + T::from_f64(0.015) * cos16
                + (t21 + t21 + T::from_f64(0.015) * cos14)
                + (t18 + t18 + T::from_f64(0.015) * cos15);
            let t29 = T::from_f64(0.03) * cos_hip1;
            let t30 = (T::from_f64(1.0) - T::from_f64(2.0) * (qx_o * qx_o + qy_o * qy_o))
                * (t28 + (t29 + t29 + T::from_f64(0.015) * cos19));
            T::from_f64(9.81) * (t26 - t0 - t0 - t30)
                + k4 * (t10 + t11 * t11 + t12 * t12 + t13 * t13)
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl<T: ::pendulum_core::real::Real> Quadruped<T> {
        ///Output `foot1`.
        #[inline]
        pub fn foot1(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 29>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 3> {
            let [qx_p, qy_p, qz_p, qw_o, qx_o, qy_o, qz_o, q_hip1, q_knee1, _, _, _, _,
            _, _, _, _, _, _, _, _, _, _, _, _, _, _, _, _] = x.data.0[0];
            let t0 = q_hip1 + q_knee1;
            let [(sin1, cos1), (sin_hip1, cos_hip1)] = t0.sin_cos_pair(q_hip1);
            let t2 = sin1 - (T::from_f64(1.0) - sin_hip1);
            let t3 = cos_hip1 + cos1;
            let t4 = qz_o * t2;
            let t5 = qx_o * t3;
            let t6 = qy_o * t2;
            let t7 = qw_o * t2;
            let t8 = qw_o * t3;
            let t9 = qy_o * t3;
            let t10 = T::from_f64(0.1) + qy_p
                + T::from_f64(0.4) * (qx_o * (t8 - t6) - qz_o * (t7 + t9));
            ::pendulum_core::nalgebra::SVector::from([
                qx_p + T::from_f64(0.2) * (qx_o * qy_o - qz_o * qw_o - t2)
                    + T::from_f64(0.4) * (qz_o * (t4 - t5) + qy_o * (t6 - t8)),
                t10 - T::from_f64(0.2) * (qx_o * qx_o + qz_o * qz_o),
                qz_p + T::from_f64(0.2) * (qy_o * qz_o + qx_o * qw_o - t3)
                    + T::from_f64(0.4) * (qy_o * (t9 + t7) + qx_o * (t5 - t4)),
            ])
        }
        ///The rate of `foot1` along the motion.
        #[inline]
        pub fn foot1_rate(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 29>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 3> {
            let [_, _, _, qw_o, qx_o, qy_o, qz_o, q_hip1, q_knee1, _, _, _, _, _, _,
            qdx_p, qdy_p, qdz_p, qdx_o, qdy_o, qdz_o, qd_hip1, qd_knee1, _, _, _, _, _, _,
            ] = x.data.0[0];
            let t0 = qy_o * qy_o;
            let t1 = qx_o * qx_o;
            let t2 = t0 - t1;
            let t3 = qz_o * qz_o;
            let t4 = qw_o * qw_o;
            let t5 = t0 + t1 - (t3 + t4);
            let t6 = t3 - t4;
            let t7 = t2 + t6;
            let t8 = qz_o * qx_o;
            let t9 = qy_o * qw_o;
            let t10 = q_hip1 + q_knee1;
            let t11 = qd_hip1 + qdy_o;
            let [(sin12, cos12), (sin_hip1, cos_hip1)] = t10.sin_cos_pair(q_hip1);
            let t13 = cos_hip1 * t11 + cos12 * (qd_knee1 + t11);
            let t14 = cos12 + cos_hip1;
            let t15 = qd_knee1 * cos12 + qd_hip1 * t14;
            let t16 = qdx_p + T::from_f64(0.1) * qdz_o * t7
                + T::from_f64(0.2) * (qdx_o * (t8 + t9) + qdy_o * (t7 * t14) - t15);
            let t17 = sin12 + sin_hip1;
            let t18 = qd_knee1 * sin12 + qd_hip1 * t17;
            let t19 = T::from_f64(0.2)
                * (t18 + qdz_o * (t9 - t8) + qdy_o * (t5 - t17 * t5));
            let t20 = T::from_f64(1.0) - t17;
            let t21 = t20 * (t0 + t4) - qz_o * (qw_o + qz_o * t20)
                - qx_o * (qy_o + qx_o * t20);
            let t22 = qdx_o * (qz_o * qy_o + t14 * (t2 - t6) - qx_o * qw_o)
                + qdz_o * t21;
            let t23 = qdx_o * t14;
            let t24 = qdy_o * t20;
            let t25 = qdz_o * t20;
            let t26 = t18 - t24;
            let t27 = t23 + t25;
            let t28 = qz_o * (qz_o * t15 + qx_o * t26 - qw_o * (t25 + t23))
                + qy_o * (qy_o * t15 + qx_o * t27 + qw_o * t26);
            let t29 = qw_o * t13;
            let t30 = qz_o * (qy_o * t26 - t29)
                + qx_o * (qw_o * (t24 - t18) - qy_o * t13);
            let t31 = qy_o * (t29 + qz_o * t27 - qy_o * t18)
                + qx_o * (qw_o * t27 - qx_o * t18 - qz_o * t13);
            ::pendulum_core::nalgebra::SVector::from([
                t16 + T::from_f64(0.4) * t28,
                qdy_p + T::from_f64(0.4) * t30 + T::from_f64(0.2) * t22,
                qdz_p + t19 + T::from_f64(0.4) * t31 - T::from_f64(0.1) * qdx_o * t5,
            ])
        }
        ///The value of `foot1`, and its derivatives by the state: a row for each component, column by column for a matrix.
        #[inline]
        pub fn foot1_and_jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 29>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 3>,
            ::pendulum_core::nalgebra::SMatrix<T, 3, 29>,
        ) {
            let [qx_p, qy_p, qz_p, qw_o, qx_o, qy_o, qz_o, q_hip1, q_knee1, _, _, _, _,
            _, _, _, _, _, _, _, _, _, _, _, _, _, _, _, _] = x.data.0[0];
            let t0 = qy_o * qy_o;
            let t1 = qz_o * qz_o;
            let t2 = T::from_f64(1.0) - T::from_f64(2.0) * (t0 + t1);
            let t3 = q_hip1 + q_knee1;
            let t4 = qy_o * qx_o;
            let t5 = qz_o * qw_o;
            let t6 = qz_o * qx_o;
            let t7 = qy_o * qw_o;
            let t8 = T::from_f64(2.0) * (t6 + t7);
            let t9 = T::from_f64(2.0) * (t6 - t7);
            let t10 = T::from_f64(2.0) * (t4 + t5);
            let t11 = qx_o * qx_o;
            let t12 = T::from_f64(1.0) - T::from_f64(2.0) * (t0 + t11);
            let t13 = qy_o * qz_o;
            let t14 = qx_o * qw_o;
            let t15 = T::from_f64(2.0) * (t13 - t14);
            let t16 = T::from_f64(0.2) * qz_o;
            let t17 = T::from_f64(2.0) * qy_o;
            let t18 = T::from_f64(2.0) * qz_o;
            let t19 = T::from_f64(2.0) * qx_o;
            let t20 = T::from_f64(0.2) * qx_o;
            let t21 = T::from_f64(0.2) * qy_o;
            let t22 = T::from_f64(2.0) * qw_o;
            let t23 = T::from_f64(0.2) * qw_o;
            let t24 = T::from_f64(4.0) * qy_o;
            let [(sin_hip1, cos_hip1), (sin25, cos25)] = q_hip1.sin_cos_pair(t3);
            let t26 = T::from_f64(0.2) * sin25;
            let t27 = T::from_f64(0.2) * sin_hip1 + t26;
            let t28 = T::from_f64(0.2) - t27;
            let t29 = T::from_f64(0.2) * cos25;
            let t30 = T::from_f64(0.2) * cos_hip1 + t29;
            let t31 = qx_p + t2 * t28 + T::from_f64(0.2) * (t4 - t5) - t8 * t30;
            let t32 = qy_p + t28 * t10
                + (T::from_f64(0.1) - T::from_f64(0.2) * (t1 + t11)) - t30 * t15;
            let t33 = qz_p + t28 * t9 + T::from_f64(0.2) * (t13 + t14) - t30 * t12;
            let t34 = t8 * t27 - t2 * t30;
            let t35 = t26 * t8 - t2 * t29;
            let t36 = t15 * t27 - t30 * t10;
            let t37 = t26 * t15 - t29 * t10;
            let t38 = t26 * t12 - t29 * t9;
            let t39 = t12 * t27 - t30 * t9;
            let t40 = t30 * t17;
            let t41 = -(t16 + t40);
            let t42 = t28 * t17;
            let t43 = t20 - t42;
            let t44 = t28 * t18;
            let t45 = t30 * t18;
            let t46 = t21 - t45;
            let t47 = t44 + t23 + T::from_f64(4.0) * qx_o * t30;
            let t48 = t30 * t19;
            let t49 = t44 + t48;
            let t50 = -(t48 + t23 + T::from_f64(4.0) * qz_o * t28);
            let t51 = t28 * t19;
            let t52 = t51 - t45;
            let t53 = t21 + t51;
            let t54 = t30 * t22;
            let t55 = t42 + t54 - T::from_f64(0.4) * qx_o;
            let t56 = t20 - t54 - t28 * t24;
            let t57 = t28 * t22;
            let t58 = t16 + t30 * t24 - t57;
            let t59 = t57 - t40 - T::from_f64(0.4) * qz_o;
            (
                ::pendulum_core::nalgebra::SVector::from([t31, t32, t33]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [T::from_f64(1.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(1.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(1.0)],
                    [t41, t49, t43],
                    [t46, t55, t47],
                    [t56, t52, t58],
                    [t50, t59, t53],
                    [t34, t36, t39],
                    [t35, t37, t38],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                ]),
            )
        }
        ///Output `foot2`.
        #[inline]
        pub fn foot2(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 29>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 3> {
            let [qx_p, qy_p, qz_p, qw_o, qx_o, qy_o, qz_o, _, _, q_hip2, q_knee2, _, _,
            _, _, _, _, _, _, _, _, _, _, _, _, _, _, _, _] = x.data.0[0];
            let t0 = q_hip2 + q_knee2;
            let [(sin1, cos1), (sin_hip2, cos_hip2)] = t0.sin_cos_pair(q_hip2);
            let t2 = sin1 - (T::from_f64(1.0) - sin_hip2);
            let t3 = cos_hip2 + cos1;
            let t4 = qz_o * t2;
            let t5 = qx_o * t3;
            let t6 = qy_o * t2;
            let t7 = qw_o * t2;
            let t8 = qw_o * t3;
            let t9 = qy_o * t3;
            let t10 = T::from_f64(0.2) * (qx_o * qx_o + qz_o * qz_o) + qy_p
                + T::from_f64(0.4) * (qx_o * (t8 - t6) - qz_o * (t7 + t9));
            ::pendulum_core::nalgebra::SVector::from([
                qx_p + T::from_f64(0.2) * (qz_o * qw_o - qx_o * qy_o - t2)
                    + T::from_f64(0.4) * (qz_o * (t4 - t5) + qy_o * (t6 - t8)),
                t10 - T::from_f64(0.1),
                qz_p + T::from_f64(0.4) * (qy_o * (t9 + t7) + qx_o * (t5 - t4))
                    - T::from_f64(0.2) * (t3 + qz_o * qy_o + qw_o * qx_o),
            ])
        }
        ///The rate of `foot2` along the motion.
        #[inline]
        pub fn foot2_rate(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 29>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 3> {
            let [_, _, _, qw_o, qx_o, qy_o, qz_o, _, _, q_hip2, q_knee2, _, _, _, _,
            qdx_p, qdy_p, qdz_p, qdx_o, qdy_o, qdz_o, _, _, qd_hip2, qd_knee2, _, _, _, _,
            ] = x.data.0[0];
            let t0 = qw_o * qw_o;
            let t1 = qz_o * qz_o;
            let t2 = t0 - t1;
            let t3 = qx_o * qx_o;
            let t4 = qy_o * qy_o;
            let t5 = t3 + t4 - (t0 + t1);
            let t6 = t3 - t4;
            let t7 = q_hip2 + q_knee2;
            let t8 = qx_o * qz_o;
            let t9 = qw_o * qy_o;
            let t10 = qdy_o + qd_hip2;
            let [(sin11, cos11), (sin_hip2, cos_hip2)] = t7.sin_cos_pair(q_hip2);
            let t12 = cos_hip2 * t10 + cos11 * (qd_knee2 + t10);
            let t13 = cos11 + cos_hip2;
            let t14 = cos11 * qd_knee2 + qd_hip2 * t13;
            let t15 = sin11 + sin_hip2;
            let t16 = qd_knee2 * sin11 + qd_hip2 * t15;
            let t17 = T::from_f64(0.2)
                * (t16 + qdz_o * (t8 - t9) + qdy_o * (t5 - t15 * t5));
            let t18 = T::from_f64(0.2)
                * (qdy_o * ((t6 + t2) * t13) + qdx_o * (t8 + t9) + t14);
            let t19 = T::from_f64(1.0) - t15;
            let t20 = qz_o * (qw_o - qz_o * t19) + qx_o * (qy_o - qx_o * t19)
                + t19 * (t0 + t4);
            let t21 = qdx_o * (qw_o * qx_o + t13 * (t2 - t6) - qy_o * qz_o)
                + qdz_o * t20;
            let t22 = qdx_o * t13;
            let t23 = qdy_o * t19;
            let t24 = qdz_o * t19;
            let t25 = t16 - t23;
            let t26 = t22 + t24;
            let t27 = qz_o * (qz_o * t14 + qx_o * t25 - qw_o * (t24 + t22))
                + qy_o * (qy_o * t14 + qx_o * t26 + qw_o * t25);
            let t28 = qw_o * t12;
            let t29 = qz_o * (qy_o * t25 - t28)
                + qx_o * (qw_o * (t23 - t16) - qy_o * t12);
            let t30 = qy_o * (t28 + qz_o * t26 - qy_o * t16)
                + qx_o * (qw_o * t26 - qx_o * t16 - qz_o * t12);
            ::pendulum_core::nalgebra::SVector::from([
                qdx_p + T::from_f64(0.1) * qdz_o * (t2 + t6) + T::from_f64(0.4) * t27
                    - t18,
                qdy_p + T::from_f64(0.4) * t29 + T::from_f64(0.2) * t21,
                qdz_p + T::from_f64(0.1) * qdx_o * t5 + t17 + T::from_f64(0.4) * t30,
            ])
        }
        ///The value of `foot2`, and its derivatives by the state: a row for each component, column by column for a matrix.
        #[inline]
        pub fn foot2_and_jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 29>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 3>,
            ::pendulum_core::nalgebra::SMatrix<T, 3, 29>,
        ) {
            let [qx_p, qy_p, qz_p, qw_o, qx_o, qy_o, qz_o, _, _, q_hip2, q_knee2, _, _,
            _, _, _, _, _, _, _, _, _, _, _, _, _, _, _, _] = x.data.0[0];
            let t0 = qy_o * qy_o;
            let t1 = qz_o * qz_o;
            let t2 = T::from_f64(1.0) - T::from_f64(2.0) * (t0 + t1);
            let t3 = q_hip2 + q_knee2;
            let t4 = qy_o * qx_o;
            let t5 = qz_o * qw_o;
            let t6 = qz_o * qx_o;
            let t7 = qy_o * qw_o;
            let t8 = T::from_f64(2.0) * (t6 + t7);
            let t9 = T::from_f64(2.0) * (t6 - t7);
            let t10 = T::from_f64(2.0) * (t4 + t5);
            let t11 = qx_o * qx_o;
            let t12 = T::from_f64(1.0) - T::from_f64(2.0) * (t0 + t11);
            let t13 = qy_o * qz_o;
            let t14 = qx_o * qw_o;
            let t15 = T::from_f64(2.0) * (t13 - t14);
            let t16 = T::from_f64(0.2) * qz_o;
            let t17 = T::from_f64(2.0) * qy_o;
            let t18 = T::from_f64(2.0) * qz_o;
            let t19 = T::from_f64(2.0) * qx_o;
            let t20 = T::from_f64(0.2) * qx_o;
            let t21 = T::from_f64(0.2) * qy_o;
            let t22 = T::from_f64(2.0) * qw_o;
            let t23 = T::from_f64(0.2) * qw_o;
            let t24 = T::from_f64(4.0) * qy_o;
            let [(sin_hip2, cos_hip2), (sin25, cos25)] = q_hip2.sin_cos_pair(t3);
            let t26 = T::from_f64(0.2) * sin25;
            let t27 = T::from_f64(0.2) * sin_hip2 + t26;
            let t28 = T::from_f64(0.2) - t27;
            let t29 = T::from_f64(0.2) * cos25;
            let t30 = T::from_f64(0.2) * cos_hip2 + t29;
            let t31 = qx_p + t2 * t28 - T::from_f64(0.2) * (t4 - t5) - t8 * t30;
            let t32 = qy_p + t28 * t10
                - (T::from_f64(0.1) - T::from_f64(0.2) * (t1 + t11)) - t30 * t15;
            let t33 = qz_p + t28 * t9 - T::from_f64(0.2) * (t13 + t14) - t30 * t12;
            let t34 = t8 * t27 - t2 * t30;
            let t35 = t26 * t8 - t2 * t29;
            let t36 = t15 * t27 - t30 * t10;
            let t37 = t26 * t15 - t29 * t10;
            let t38 = t26 * t12 - t29 * t9;
            let t39 = t12 * t27 - t30 * t9;
            let t40 = t30 * t17;
            let t41 = t16 - t40;
            let t42 = t28 * t17;
            let t43 = -(t20 + t42);
            let t44 = t28 * t18;
            let t45 = t30 * t18;
            let t46 = -(t21 + t45);
            let t47 = t44 + T::from_f64(4.0) * qx_o * t30 - t23;
            let t48 = t30 * t19;
            let t49 = t44 + t48;
            let t50 = t23 - t48 - T::from_f64(4.0) * qz_o * t28;
            let t51 = t28 * t19;
            let t52 = t51 - t45;
            let t53 = t51 - t21;
            let t54 = t30 * t22;
            let t55 = t42 + T::from_f64(0.4) * qx_o + t54;
            let t56 = -(t20 + t54 + t28 * t24);
            let t57 = t28 * t22;
            let t58 = t30 * t24 - t16 - t57;
            let t59 = t57 + T::from_f64(0.4) * qz_o - t40;
            (
                ::pendulum_core::nalgebra::SVector::from([t31, t32, t33]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [T::from_f64(1.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(1.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(1.0)],
                    [t41, t49, t43],
                    [t46, t55, t47],
                    [t56, t52, t58],
                    [t50, t59, t53],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [t34, t36, t39],
                    [t35, t37, t38],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                ]),
            )
        }
        ///Output `foot3`.
        #[inline]
        pub fn foot3(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 29>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 3> {
            let [qx_p, qy_p, qz_p, qw_o, qx_o, qy_o, qz_o, _, _, _, _, q_hip3, q_knee3,
            _, _, _, _, _, _, _, _, _, _, _, _, _, _, _, _] = x.data.0[0];
            let t0 = q_hip3 + q_knee3;
            let [(sin1, cos1), (sin_hip3, cos_hip3)] = t0.sin_cos_pair(q_hip3);
            let t2 = sin1 + (T::from_f64(1.0) + sin_hip3);
            let t3 = cos_hip3 + cos1;
            let t4 = qz_o * t2;
            let t5 = qx_o * t3;
            let t6 = qy_o * t2;
            let t7 = qw_o * t2;
            let t8 = qw_o * t3;
            let t9 = qy_o * t3;
            let t10 = T::from_f64(0.1) + qy_p
                + T::from_f64(0.4) * (qx_o * (t8 - t6) - qz_o * (t7 + t9));
            ::pendulum_core::nalgebra::SVector::from([
                qx_p + T::from_f64(0.2) * (qx_o * qy_o - qz_o * qw_o - t2)
                    + T::from_f64(0.4) * (qz_o * (t4 - t5) + qy_o * (t6 - t8)),
                t10 - T::from_f64(0.2) * (qx_o * qx_o + qz_o * qz_o),
                qz_p + T::from_f64(0.2) * (qy_o * qz_o + qx_o * qw_o - t3)
                    + T::from_f64(0.4) * (qy_o * (t9 + t7) + qx_o * (t5 - t4)),
            ])
        }
        ///The rate of `foot3` along the motion.
        #[inline]
        pub fn foot3_rate(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 29>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 3> {
            let [_, _, _, qw_o, qx_o, qy_o, qz_o, _, _, _, _, q_hip3, q_knee3, _, _,
            qdx_p, qdy_p, qdz_p, qdx_o, qdy_o, qdz_o, _, _, _, _, qd_hip3, qd_knee3, _, _,
            ] = x.data.0[0];
            let t0 = qy_o * qy_o;
            let t1 = qx_o * qx_o;
            let t2 = t0 - t1;
            let t3 = qz_o * qz_o;
            let t4 = qw_o * qw_o;
            let t5 = t3 + t4 - t0 - t1;
            let t6 = t3 - t4;
            let t7 = t2 + t6;
            let t8 = qz_o * qx_o;
            let t9 = qy_o * qw_o;
            let t10 = q_hip3 + q_knee3;
            let t11 = qd_hip3 + qdy_o;
            let [(sin12, cos12), (sin_hip3, cos_hip3)] = t10.sin_cos_pair(q_hip3);
            let t13 = cos_hip3 * t11 + cos12 * (qd_knee3 + t11);
            let t14 = cos12 + cos_hip3;
            let t15 = qd_knee3 * cos12 + qd_hip3 * t14;
            let t16 = qdx_p + T::from_f64(0.1) * qdz_o * t7
                + T::from_f64(0.2) * (qdx_o * (t8 + t9) + qdy_o * (t7 * t14) - t15);
            let t17 = sin12 + sin_hip3;
            let t18 = qd_knee3 * sin12 + qd_hip3 * t17;
            let t19 = T::from_f64(0.2)
                * (t18 + qdz_o * (t9 - t8) + qdy_o * (t5 + t17 * t5));
            let t20 = T::from_f64(1.0) + t17;
            let t21 = qz_o * (qz_o * t20 - qw_o) + qx_o * (qx_o * t20 - qy_o)
                - t20 * (t0 + t4);
            let t22 = qdx_o * (qz_o * qy_o + t14 * (t2 - t6) - qx_o * qw_o)
                + qdz_o * t21;
            let t23 = qdx_o * t14;
            let t24 = qdz_o * t20;
            let t25 = t18 + qdy_o * t20;
            let t26 = t23 - t24;
            let t27 = qw_o * t25;
            let t28 = qz_o * (qz_o * t15 + qw_o * (t24 - t23) + qx_o * t25)
                + qy_o * (qy_o * t15 + qx_o * t26 + t27);
            let t29 = qw_o * t13;
            let t30 = T::from_f64(0.4)
                * (qz_o * (qy_o * t25 - t29) - qx_o * (t27 + qy_o * t13));
            let t31 = qy_o * (t29 + qz_o * t26 - qy_o * t18)
                + qx_o * (qw_o * t26 - qx_o * t18 - qz_o * t13);
            ::pendulum_core::nalgebra::SVector::from([
                t16 + T::from_f64(0.4) * t28,
                qdy_p + t30 + T::from_f64(0.2) * t22,
                qdz_p + T::from_f64(0.1) * qdx_o * t5 + t19 + T::from_f64(0.4) * t31,
            ])
        }
        ///The value of `foot3`, and its derivatives by the state: a row for each component, column by column for a matrix.
        #[inline]
        pub fn foot3_and_jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 29>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 3>,
            ::pendulum_core::nalgebra::SMatrix<T, 3, 29>,
        ) {
            let [qx_p, qy_p, qz_p, qw_o, qx_o, qy_o, qz_o, _, _, _, _, q_hip3, q_knee3,
            _, _, _, _, _, _, _, _, _, _, _, _, _, _, _, _] = x.data.0[0];
            let t0 = qx_o * qy_o;
            let t1 = qz_o * qw_o;
            let t2 = qy_o * qy_o;
            let t3 = qz_o * qz_o;
            let t4 = T::from_f64(1.0) - T::from_f64(2.0) * (t2 + t3);
            let t5 = q_hip3 + q_knee3;
            let t6 = qx_o * qz_o;
            let t7 = qy_o * qw_o;
            let t8 = T::from_f64(2.0) * (t6 + t7);
            let t9 = T::from_f64(2.0) * (t6 - t7);
            let t10 = qx_o * qx_o;
            let t11 = T::from_f64(1.0) - T::from_f64(2.0) * (t2 + t10);
            let t12 = T::from_f64(2.0) * (t0 + t1);
            let t13 = qy_o * qz_o;
            let t14 = qx_o * qw_o;
            let t15 = T::from_f64(2.0) * (t13 - t14);
            let t16 = T::from_f64(0.2) * qz_o;
            let t17 = T::from_f64(2.0) * qy_o;
            let t18 = T::from_f64(2.0) * qz_o;
            let t19 = T::from_f64(2.0) * qx_o;
            let t20 = T::from_f64(0.2) * qx_o;
            let t21 = T::from_f64(0.2) * qy_o;
            let t22 = T::from_f64(2.0) * qw_o;
            let t23 = T::from_f64(0.2) * qw_o;
            let t24 = T::from_f64(4.0) * qy_o;
            let [(sin_hip3, cos_hip3), (sin25, cos25)] = q_hip3.sin_cos_pair(t5);
            let t26 = T::from_f64(0.2) * sin25;
            let t27 = T::from_f64(0.2) * sin_hip3 + t26;
            let t28 = T::from_f64(-0.2) - t27;
            let t29 = T::from_f64(0.2) * cos25;
            let t30 = T::from_f64(0.2) * cos_hip3 + t29;
            let t31 = qx_p + T::from_f64(0.2) * (t0 - t1) + t4 * t28 - t8 * t30;
            let t32 = qy_p + (T::from_f64(0.1) - T::from_f64(0.2) * (t3 + t10))
                + t28 * t12 - t30 * t15;
            let t33 = qz_p + T::from_f64(0.2) * (t13 + t14) + t28 * t9 - t30 * t11;
            let t34 = t8 * t27 - t4 * t30;
            let t35 = t26 * t8 - t4 * t29;
            let t36 = t15 * t27 - t30 * t12;
            let t37 = t26 * t15 - t29 * t12;
            let t38 = t26 * t11 - t29 * t9;
            let t39 = t11 * t27 - t30 * t9;
            let t40 = t30 * t17;
            let t41 = -(t16 + t40);
            let t42 = t28 * t17;
            let t43 = t20 - t42;
            let t44 = t28 * t18;
            let t45 = t30 * t18;
            let t46 = t21 - t45;
            let t47 = t44 + t23 + T::from_f64(4.0) * qx_o * t30;
            let t48 = t30 * t19;
            let t49 = t44 + t48;
            let t50 = -(t48 + t23 + T::from_f64(4.0) * qz_o * t28);
            let t51 = t28 * t19;
            let t52 = t51 - t45;
            let t53 = t21 + t51;
            let t54 = t30 * t22;
            let t55 = t42 + t54 - T::from_f64(0.4) * qx_o;
            let t56 = t20 - t54 - t28 * t24;
            let t57 = t28 * t22;
            let t58 = t16 + t30 * t24 - t57;
            let t59 = t57 - t40 - T::from_f64(0.4) * qz_o;
            (
                ::pendulum_core::nalgebra::SVector::from([t31, t32, t33]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [T::from_f64(1.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(1.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(1.0)],
                    [t41, t49, t43],
                    [t46, t55, t47],
                    [t56, t52, t58],
                    [t50, t59, t53],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [t34, t36, t39],
                    [t35, t37, t38],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                ]),
            )
        }
        ///Output `foot4`.
        #[inline]
        pub fn foot4(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 29>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 3> {
            let [qx_p, qy_p, qz_p, qw_o, qx_o, qy_o, qz_o, _, _, _, _, _, _, q_hip4,
            q_knee4, _, _, _, _, _, _, _, _, _, _, _, _, _, _] = x.data.0[0];
            let t0 = q_hip4 + q_knee4;
            let [(sin1, cos1), (sin_hip4, cos_hip4)] = t0.sin_cos_pair(q_hip4);
            let t2 = sin1 + (T::from_f64(1.0) + sin_hip4);
            let t3 = cos_hip4 + cos1;
            let t4 = qz_o * t2;
            let t5 = qx_o * t3;
            let t6 = qy_o * t2;
            let t7 = qw_o * t2;
            let t8 = qw_o * t3;
            let t9 = qy_o * t3;
            let t10 = T::from_f64(0.2) * (qx_o * qx_o + qz_o * qz_o) + qy_p
                + T::from_f64(0.4) * (qx_o * (t8 - t6) - qz_o * (t7 + t9));
            ::pendulum_core::nalgebra::SVector::from([
                qx_p + T::from_f64(0.2) * (qz_o * qw_o - qx_o * qy_o - t2)
                    + T::from_f64(0.4) * (qz_o * (t4 - t5) + qy_o * (t6 - t8)),
                t10 - T::from_f64(0.1),
                qz_p + T::from_f64(0.4) * (qy_o * (t9 + t7) + qx_o * (t5 - t4))
                    - T::from_f64(0.2) * (t3 + qz_o * qy_o + qw_o * qx_o),
            ])
        }
        ///The rate of `foot4` along the motion.
        #[inline]
        pub fn foot4_rate(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 29>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 3> {
            let [_, _, _, qw_o, qx_o, qy_o, qz_o, _, _, _, _, _, _, q_hip4, q_knee4,
            qdx_p, qdy_p, qdz_p, qdx_o, qdy_o, qdz_o, _, _, _, _, _, _, qd_hip4, qd_knee4,
            ] = x.data.0[0];
            let t0 = qw_o * qw_o;
            let t1 = qz_o * qz_o;
            let t2 = t0 - t1;
            let t3 = qx_o * qx_o;
            let t4 = qy_o * qy_o;
            let t5 = t3 + t4 - (t0 + t1);
            let t6 = t3 - t4;
            let t7 = q_hip4 + q_knee4;
            let t8 = qx_o * qz_o;
            let t9 = qw_o * qy_o;
            let t10 = qdy_o + qd_hip4;
            let [(sin11, cos11), (sin_hip4, cos_hip4)] = t7.sin_cos_pair(q_hip4);
            let t12 = cos_hip4 * t10 + cos11 * (qd_knee4 + t10);
            let t13 = cos11 + cos_hip4;
            let t14 = cos11 * qd_knee4 + qd_hip4 * t13;
            let t15 = sin11 + sin_hip4;
            let t16 = qd_knee4 * sin11 + qd_hip4 * t15;
            let t17 = T::from_f64(0.2)
                * (t16 + qdz_o * (t8 - t9) - qdy_o * (t5 + t15 * t5));
            let t18 = T::from_f64(0.2)
                * (qdy_o * ((t6 + t2) * t13) + qdx_o * (t8 + t9) + t14);
            let t19 = T::from_f64(1.0) + t15;
            let t20 = qz_o * (qw_o + qz_o * t19) + qx_o * (qy_o + qx_o * t19)
                - t19 * (t0 + t4);
            let t21 = qdx_o * (qw_o * qx_o + t13 * (t2 - t6) - qy_o * qz_o)
                + qdz_o * t20;
            let t22 = qdx_o * t13;
            let t23 = qdz_o * t19;
            let t24 = t16 + qdy_o * t19;
            let t25 = t22 - t23;
            let t26 = qw_o * t24;
            let t27 = qz_o * (qz_o * t14 + qw_o * (t23 - t22) + qx_o * t24)
                + qy_o * (qy_o * t14 + qx_o * t25 + t26);
            let t28 = qw_o * t12;
            let t29 = T::from_f64(0.4)
                * (qz_o * (qy_o * t24 - t28) - qx_o * (t26 + qy_o * t12));
            let t30 = qy_o * (t28 + qz_o * t25 - qy_o * t16)
                + qx_o * (qw_o * t25 - qx_o * t16 - qz_o * t12);
            ::pendulum_core::nalgebra::SVector::from([
                qdx_p + T::from_f64(0.1) * qdz_o * (t2 + t6) + T::from_f64(0.4) * t27
                    - t18,
                qdy_p + t29 + T::from_f64(0.2) * t21,
                qdz_p + T::from_f64(0.1) * qdx_o * t5 + t17 + T::from_f64(0.4) * t30,
            ])
        }
        ///The value of `foot4`, and its derivatives by the state: a row for each component, column by column for a matrix.
        #[inline]
        pub fn foot4_and_jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 29>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 3>,
            ::pendulum_core::nalgebra::SMatrix<T, 3, 29>,
        ) {
            let [qx_p, qy_p, qz_p, qw_o, qx_o, qy_o, qz_o, _, _, _, _, _, _, q_hip4,
            q_knee4, _, _, _, _, _, _, _, _, _, _, _, _, _, _] = x.data.0[0];
            let t0 = qy_o * qy_o;
            let t1 = qz_o * qz_o;
            let t2 = T::from_f64(1.0) - T::from_f64(2.0) * (t0 + t1);
            let t3 = q_hip4 + q_knee4;
            let t4 = qy_o * qx_o;
            let t5 = qz_o * qw_o;
            let t6 = qz_o * qx_o;
            let t7 = qy_o * qw_o;
            let t8 = T::from_f64(2.0) * (t6 + t7);
            let t9 = T::from_f64(2.0) * (t6 - t7);
            let t10 = T::from_f64(2.0) * (t4 + t5);
            let t11 = qx_o * qx_o;
            let t12 = T::from_f64(1.0) - T::from_f64(2.0) * (t0 + t11);
            let t13 = qy_o * qz_o;
            let t14 = qx_o * qw_o;
            let t15 = T::from_f64(2.0) * (t13 - t14);
            let t16 = T::from_f64(0.2) * qz_o;
            let t17 = T::from_f64(2.0) * qy_o;
            let t18 = T::from_f64(2.0) * qz_o;
            let t19 = T::from_f64(2.0) * qx_o;
            let t20 = T::from_f64(0.2) * qx_o;
            let t21 = T::from_f64(0.2) * qy_o;
            let t22 = T::from_f64(2.0) * qw_o;
            let t23 = T::from_f64(0.2) * qw_o;
            let t24 = T::from_f64(4.0) * qy_o;
            let [(sin_hip4, cos_hip4), (sin25, cos25)] = q_hip4.sin_cos_pair(t3);
            let t26 = T::from_f64(0.2) * sin25;
            let t27 = T::from_f64(0.2) * sin_hip4 + t26;
            let t28 = T::from_f64(-0.2) - t27;
            let t29 = T::from_f64(0.2) * cos25;
            let t30 = T::from_f64(0.2) * cos_hip4 + t29;
            let t31 = qx_p + t2 * t28 - T::from_f64(0.2) * (t4 - t5) - t8 * t30;
            let t32 = qy_p + t28 * t10
                - (T::from_f64(0.1) - T::from_f64(0.2) * (t1 + t11)) - t30 * t15;
            let t33 = qz_p + t28 * t9 - T::from_f64(0.2) * (t13 + t14) - t30 * t12;
            let t34 = t8 * t27 - t2 * t30;
            let t35 = t26 * t8 - t2 * t29;
            let t36 = t15 * t27 - t30 * t10;
            let t37 = t26 * t15 - t29 * t10;
            let t38 = t26 * t12 - t29 * t9;
            let t39 = t12 * t27 - t30 * t9;
            let t40 = t30 * t17;
            let t41 = t16 - t40;
            let t42 = t28 * t17;
            let t43 = -(t20 + t42);
            let t44 = t28 * t18;
            let t45 = t30 * t18;
            let t46 = -(t21 + t45);
            let t47 = t44 + T::from_f64(4.0) * qx_o * t30 - t23;
            let t48 = t30 * t19;
            let t49 = t44 + t48;
            let t50 = t23 - t48 - T::from_f64(4.0) * qz_o * t28;
            let t51 = t28 * t19;
            let t52 = t51 - t45;
            let t53 = t51 - t21;
            let t54 = t30 * t22;
            let t55 = t42 + T::from_f64(0.4) * qx_o + t54;
            let t56 = -(t20 + t54 + t28 * t24);
            let t57 = t28 * t22;
            let t58 = t30 * t24 - t16 - t57;
            let t59 = t57 + T::from_f64(0.4) * qz_o - t40;
            (
                ::pendulum_core::nalgebra::SVector::from([t31, t32, t33]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [T::from_f64(1.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(1.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(1.0)],
                    [t41, t49, t43],
                    [t46, t55, t47],
                    [t56, t52, t58],
                    [t50, t59, t53],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [t34, t36, t39],
                    [t35, t37, t38],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                    [T::from_f64(0.0), T::from_f64(0.0), T::from_f64(0.0)],
                ]),
            )
        }
        ///All outputs, in the order of `OUTPUTS`.
        #[inline]
        pub fn outputs(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 29>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 12> {
            let [qx_p, qy_p, qz_p, qw_o, qx_o, qy_o, qz_o, q_hip1, q_knee1, q_hip2,
            q_knee2, q_hip3, q_knee3, q_hip4, q_knee4, _, _, _, _, _, _, _, _, _, _, _,
            _, _, _] = x.data.0[0];
            let t0 = qy_o * qy_o;
            let t1 = qz_o * qz_o;
            let t2 = T::from_f64(1.0) - T::from_f64(2.0) * (t0 + t1);
            let t3 = q_hip1 + q_knee1;
            let t4 = qy_o * qx_o;
            let t5 = qz_o * qw_o;
            let t6 = T::from_f64(0.2) * (t4 - t5);
            let t7 = T::from_f64(2.0) * (t4 + t5);
            let t8 = qx_p + t6;
            let t9 = qx_p - t6;
            let t10 = qz_o * qx_o;
            let t11 = qy_o * qw_o;
            let t12 = T::from_f64(2.0) * (t10 + t11);
            let t13 = T::from_f64(2.0) * (t10 - t11);
            let t14 = qx_o * qx_o;
            let t15 = T::from_f64(0.1) - T::from_f64(0.2) * (t1 + t14);
            let t16 = T::from_f64(1.0) - T::from_f64(2.0) * (t0 + t14);
            let t17 = qy_p + t15;
            let t18 = qy_p - t15;
            let t19 = qy_o * qz_o;
            let t20 = qx_o * qw_o;
            let t21 = T::from_f64(2.0) * (t19 - t20);
            let t22 = T::from_f64(0.2) * (t19 + t20);
            let t23 = qz_p + t22;
            let t24 = qz_p - t22;
            let t25 = q_hip2 + q_knee2;
            let t26 = q_hip3 + q_knee3;
            let t27 = q_hip4 + q_knee4;
            let [(sin28, cos28), (sin29, cos29)] = t26.sin_cos_pair(t27);
            let [(sin30, cos30), (sin_hip3, cos_hip3)] = t3.sin_cos_pair(q_hip3);
            let t31 = T::from_f64(-0.2) - T::from_f64(0.2) * (sin_hip3 + sin28);
            let t32 = T::from_f64(0.2) * (cos_hip3 + cos28);
            let t33 = t2 * t31 + t8 - t12 * t32;
            let t34 = t7 * t31 + t17 - t21 * t32;
            let t35 = t13 * t31 + t23 - t16 * t32;
            let [(sin36, cos36), (sin_hip4, cos_hip4)] = t25.sin_cos_pair(q_hip4);
            let t37 = T::from_f64(-0.2) - T::from_f64(0.2) * (sin_hip4 + sin29);
            let t38 = T::from_f64(0.2) * (cos_hip4 + cos29);
            let t39 = t2 * t37 + t9 - t12 * t38;
            let t40 = t7 * t37 + t18 - t21 * t38;
            let t41 = t13 * t37 + t24 - t16 * t38;
            let [(sin_hip1, cos_hip1), (sin_hip2, cos_hip2)] = q_hip1
                .sin_cos_pair(q_hip2);
            let t42 = T::from_f64(0.2) - T::from_f64(0.2) * (sin_hip1 + sin30);
            let t43 = T::from_f64(0.2) * (cos_hip1 + cos30);
            let t44 = t2 * t42 + t8 - t12 * t43;
            let t45 = t42 * t7 + t17 - t43 * t21;
            let t46 = t42 * t13 + t23 - t43 * t16;
            let t47 = T::from_f64(0.2) - T::from_f64(0.2) * (sin_hip2 + sin36);
            let t48 = T::from_f64(0.2) * (cos_hip2 + cos36);
            let t49 = t2 * t47 + t9 - t12 * t48;
            let t50 = t7 * t47 + t18 - t21 * t48;
            let t51 = t13 * t47 + t24 - t16 * t48;
            ::pendulum_core::nalgebra::SVector::from([
                t44,
                t45,
                t46,
                t49,
                t50,
                t51,
                t33,
                t34,
                t35,
                t39,
                t40,
                t41,
            ])
        }
        ///The rate of all outputs along the motion.
        #[inline]
        pub fn output_rates(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 29>,
        ) -> ::pendulum_core::nalgebra::SVector<T, 12> {
            let [_, _, _, qw_o, qx_o, qy_o, qz_o, q_hip1, q_knee1, q_hip2, q_knee2,
            q_hip3, q_knee3, q_hip4, q_knee4, qdx_p, qdy_p, qdz_p, qdx_o, qdy_o, qdz_o,
            qd_hip1, qd_knee1, qd_hip2, qd_knee2, qd_hip3, qd_knee3, qd_hip4, qd_knee4,
            ] = x.data.0[0];
            let t0 = qz_o * qx_o;
            let t1 = qy_o * qw_o;
            let t2 = T::from_f64(2.0) * (t0 + t1);
            let t3 = T::from_f64(2.0) * (t0 - t1);
            let t4 = q_hip1 + q_knee1;
            let t5 = qd_hip1 + qd_knee1;
            let t6 = T::from_f64(0.5) * qw_o;
            let t7 = T::from_f64(0.5) * qy_o;
            let t8 = T::from_f64(0.5) * qz_o;
            let t9 = qdx_o * t6 + qdz_o * t7 - qdy_o * t8;
            let t10 = T::from_f64(0.5) * qx_o;
            let t11 = qdx_o * t8 + t6 * qdy_o - qdz_o * t10;
            let t12 = qdy_o * t10 + t6 * qdz_o - qdx_o * t7;
            let t13 = qdx_o * t10 + qdy_o * t7 + t8 * qdz_o;
            let t14 = qy_o * t9 + qx_o * t11;
            let t15 = qw_o * t12 - qz_o * t13;
            let t16 = T::from_f64(0.2) * (t14 - t15);
            let t17 = T::from_f64(2.0) * (t14 + t15);
            let t18 = qdx_p + t16;
            let t19 = qdx_p - t16;
            let t20 = T::from_f64(2.0) * qy_o * t11;
            let t21 = T::from_f64(2.0) * qz_o * t12;
            let t22 = T::from_f64(2.0) * (t20 + t21);
            let t23 = qy_o * qy_o;
            let t24 = T::from_f64(1.0) - T::from_f64(2.0) * (t23 + qz_o * qz_o);
            let t25 = T::from_f64(1.0) - T::from_f64(2.0) * (t23 + qx_o * qx_o);
            let t26 = qz_o * t9 + qx_o * t12;
            let t27 = qz_o * t11 + qy_o * t12;
            let t28 = qw_o * t11 - qy_o * t13;
            let t29 = qw_o * t9 - qx_o * t13;
            let t30 = T::from_f64(2.0) * t9 * qx_o;
            let t31 = T::from_f64(0.2) * (t21 + t30);
            let t32 = T::from_f64(2.0) * (t20 + t30);
            let t33 = T::from_f64(2.0) * (t26 + t28);
            let t34 = T::from_f64(2.0) * (t26 - t28);
            let t35 = T::from_f64(2.0) * (qy_o * qz_o - qw_o * qx_o);
            let t36 = qdy_p - t31;
            let t37 = qdy_p + t31;
            let t38 = T::from_f64(2.0) * (qy_o * qx_o + qw_o * qz_o);
            let t39 = T::from_f64(2.0) * (t27 - t29);
            let t40 = T::from_f64(0.2) * (t27 + t29);
            let t41 = qdz_p + t40;
            let t42 = qdz_p - t40;
            let t43 = q_hip2 + q_knee2;
            let t44 = qd_hip2 + qd_knee2;
            let t45 = q_hip3 + q_knee3;
            let t46 = q_hip4 + q_knee4;
            let t47 = qd_hip3 + qd_knee3;
            let t48 = qd_hip4 + qd_knee4;
            let [(sin49, cos49), (sin50, cos50)] = t45.sin_cos_pair(t46);
            let t51 = T::from_f64(0.2) * sin49;
            let t52 = T::from_f64(0.2) * cos49;
            let t53 = T::from_f64(0.2) * sin50;
            let t54 = T::from_f64(0.2) * cos50;
            let [(sin55, cos55), (sin_hip3, cos_hip3)] = t4.sin_cos_pair(q_hip3);
            let t56 = T::from_f64(0.2) * sin55;
            let t57 = T::from_f64(0.2) * cos55;
            let t58 = T::from_f64(0.2) * sin_hip3;
            let t59 = T::from_f64(0.2) * cos_hip3;
            let t60 = t58 * qd_hip3 + t51 * t47;
            let t61 = T::from_f64(-0.2) - t58 - t51;
            let t62 = qd_hip3 * t59 + t47 * t52;
            let t63 = t59 + t52;
            let t64 = t2 * t60 + t18 - t22 * t61 - t24 * t62 - t33 * t63;
            let t65 = t17 * t61 + t35 * t60 + t36 - t38 * t62 - t39 * t63;
            let t66 = t34 * t61 + t32 * t63 + t25 * t60 + t41 - t3 * t62;
            let [(sin67, cos67), (sin_hip4, cos_hip4)] = t43.sin_cos_pair(q_hip4);
            let t68 = T::from_f64(0.2) * sin67;
            let t69 = T::from_f64(0.2) * cos67;
            let t70 = T::from_f64(0.2) * sin_hip4;
            let t71 = T::from_f64(0.2) * cos_hip4;
            let t72 = t70 * qd_hip4 + t53 * t48;
            let t73 = T::from_f64(-0.2) - t70 - t53;
            let t74 = qd_hip4 * t71 + t48 * t54;
            let t75 = t71 + t54;
            let t76 = t2 * t72 + t19 - t22 * t73 - t24 * t74 - t33 * t75;
            let t77 = t17 * t73 + t35 * t72 + t37 - t38 * t74 - t39 * t75;
            let t78 = t34 * t73 + t32 * t75 + t25 * t72 + t42 - t3 * t74;
            let [(sin_hip1, cos_hip1), (sin_hip2, cos_hip2)] = q_hip1
                .sin_cos_pair(q_hip2);
            let t79 = T::from_f64(0.2) * sin_hip1;
            let t80 = t79 * qd_hip1 + t56 * t5;
            let t81 = T::from_f64(0.2) - t79 - t56;
            let t82 = T::from_f64(0.2) * cos_hip1;
            let t83 = qd_hip1 * t82 + t5 * t57;
            let t84 = t82 + t57;
            let t85 = t2 * t80 + t18 - t81 * t22 - t24 * t83 - t84 * t33;
            let t86 = t81 * t17 + t80 * t35 + t36 - t83 * t38 - t84 * t39;
            let t87 = t81 * t34 + t84 * t32 + t80 * t25 + t41 - t83 * t3;
            let t88 = T::from_f64(0.2) * sin_hip2;
            let t89 = T::from_f64(0.2) * cos_hip2;
            let t90 = t88 * qd_hip2 + t68 * t44;
            let t91 = T::from_f64(0.2) - t88 - t68;
            let t92 = qd_hip2 * t89 + t44 * t69;
            let t93 = t89 + t69;
            let t94 = t2 * t90 + t19 - t22 * t91 - t24 * t92 - t33 * t93;
            let t95 = t17 * t91 + t35 * t90 + t37 - t38 * t92 - t39 * t93;
            let t96 = t34 * t91 + t32 * t93 + t25 * t90 + t42 - t3 * t92;
            ::pendulum_core::nalgebra::SVector::from([
                t85,
                t86,
                t87,
                t94,
                t95,
                t96,
                t64,
                t65,
                t66,
                t76,
                t77,
                t78,
            ])
        }
        ///The value of all outputs, and its derivatives by the state: a row for each component, column by column for a matrix.
        #[inline]
        pub fn outputs_and_jacobian(
            &self,
            t: T,
            x: &::pendulum_core::nalgebra::SVector<T, 29>,
        ) -> (
            ::pendulum_core::nalgebra::SVector<T, 12>,
            ::pendulum_core::nalgebra::SMatrix<T, 12, 29>,
        ) {
            let [qx_p, qy_p, qz_p, qw_o, qx_o, qy_o, qz_o, q_hip1, q_knee1, q_hip2,
            q_knee2, q_hip3, q_knee3, q_hip4, q_knee4, _, _, _, _, _, _, _, _, _, _, _,
            _, _, _] = x.data.0[0];
            let t0 = qy_o * qy_o;
            let t1 = qz_o * qz_o;
            let t2 = T::from_f64(1.0) - T::from_f64(2.0) * (t0 + t1);
            let t3 = q_hip1 + q_knee1;
            let t4 = qy_o * qx_o;
            let t5 = qz_o * qw_o;
            let t6 = T::from_f64(0.2) * (t4 - t5);
            let t7 = T::from_f64(2.0) * (t4 + t5);
            let t8 = qx_p + t6;
            let t9 = qx_p - t6;
            let t10 = qz_o * qx_o;
            let t11 = qy_o * qw_o;
            let t12 = T::from_f64(2.0) * (t10 + t11);
            let t13 = T::from_f64(2.0) * (t10 - t11);
            let t14 = qx_o * qx_o;
            let t15 = T::from_f64(0.1) - T::from_f64(0.2) * (t1 + t14);
            let t16 = T::from_f64(1.0) - T::from_f64(2.0) * (t0 + t14);
            let t17 = qy_p + t15;
            let t18 = qy_p - t15;
            let t19 = qy_o * qz_o;
            let t20 = qx_o * qw_o;
            let t21 = T::from_f64(2.0) * (t19 - t20);
            let t22 = T::from_f64(0.2) * (t19 + t20);
            let t23 = qz_p + t22;
            let t24 = qz_p - t22;
            let t25 = q_hip2 + q_knee2;
            let t26 = q_hip3 + q_knee3;
            let t27 = q_hip4 + q_knee4;
            let t28 = T::from_f64(0.2) * qz_o;
            let t29 = T::from_f64(2.0) * qy_o;
            let t30 = T::from_f64(2.0) * qz_o;
            let t31 = T::from_f64(2.0) * qx_o;
            let t32 = T::from_f64(0.2) * qx_o;
            let t33 = T::from_f64(0.2) * qy_o;
            let t34 = T::from_f64(2.0) * qw_o;
            let t35 = T::from_f64(0.4) * qx_o;
            let t36 = T::from_f64(0.2) * qw_o;
            let t37 = T::from_f64(4.0) * qx_o;
            let t38 = T::from_f64(4.0) * qy_o;
            let t39 = T::from_f64(4.0) * qz_o;
            let t40 = T::from_f64(0.4) * qz_o;
            let [(sin41, cos41), (sin42, cos42)] = t26.sin_cos_pair(t27);
            let t43 = T::from_f64(0.2) * sin41;
            let t44 = T::from_f64(0.2) * cos41;
            let t45 = t12 * t43 - t2 * t44;
            let t46 = t21 * t43 - t7 * t44;
            let t47 = t16 * t43 - t13 * t44;
            let t48 = T::from_f64(0.2) * sin42;
            let t49 = T::from_f64(0.2) * cos42;
            let t50 = t12 * t48 - t2 * t49;
            let t51 = t21 * t48 - t7 * t49;
            let t52 = t16 * t48 - t13 * t49;
            let [(sin53, cos53), (sin_hip3, cos_hip3)] = t3.sin_cos_pair(q_hip3);
            let t54 = T::from_f64(0.2) * sin_hip3 + t43;
            let t55 = T::from_f64(0.2) * cos_hip3 + t44;
            let t56 = t12 * t54 - t2 * t55;
            let t57 = t21 * t54 - t7 * t55;
            let t58 = t16 * t54 - t13 * t55;
            let t59 = T::from_f64(-0.2) - t54;
            let t60 = t2 * t59 + t8 - t12 * t55;
            let t61 = t7 * t59 + t17 - t21 * t55;
            let t62 = t13 * t59 + t23 - t16 * t55;
            let t63 = T::from_f64(0.2) * sin53;
            let t64 = T::from_f64(0.2) * cos53;
            let t65 = t63 * t12 - t2 * t64;
            let t66 = t63 * t21 - t64 * t7;
            let t67 = t63 * t16 - t64 * t13;
            let t68 = t55 * t29;
            let t69 = -(t28 + t68);
            let t70 = t59 * t30;
            let t71 = t70 + t36 + t55 * t37;
            let t72 = t55 * t31;
            let t73 = t70 + t72;
            let t74 = -(t72 + t36 + t59 * t39);
            let t75 = t59 * t29;
            let t76 = t32 - t75;
            let t77 = t55 * t30;
            let t78 = t33 - t77;
            let t79 = t55 * t34;
            let t80 = t75 + t79 - t35;
            let t81 = t32 - t79 - t59 * t38;
            let t82 = t59 * t31;
            let t83 = t82 - t77;
            let t84 = t33 + t82;
            let t85 = t59 * t34;
            let t86 = t28 + t55 * t38 - t85;
            let t87 = t85 - t68 - t40;
            let [(sin88, cos88), (sin_hip4, cos_hip4)] = t25.sin_cos_pair(q_hip4);
            let t89 = T::from_f64(0.2) * sin_hip4 + t48;
            let t90 = T::from_f64(0.2) * cos_hip4 + t49;
            let t91 = t12 * t89 - t2 * t90;
            let t92 = t21 * t89 - t7 * t90;
            let t93 = t16 * t89 - t13 * t90;
            let t94 = T::from_f64(-0.2) - t89;
            let t95 = t2 * t94 + t9 - t12 * t90;
            let t96 = t7 * t94 + t18 - t21 * t90;
            let t97 = t13 * t94 + t24 - t16 * t90;
            let t98 = T::from_f64(0.2) * sin88;
            let t99 = T::from_f64(0.2) * cos88;
            let t100 = t12 * t98 - t2 * t99;
            let t101 = t21 * t98 - t7 * t99;
            let t102 = t16 * t98 - t13 * t99;
            let t103 = t90 * t29;
            let t104 = t28 - t103;
            let t105 = t94 * t30;
            let t106 = t105 + t90 * t37 - t36;
            let t107 = t90 * t31;
            let t108 = t105 + t107;
            let t109 = t36 - t107 - t94 * t39;
            let t110 = t94 * t29;
            let t111 = -(t32 + t110);
            let t112 = t90 * t30;
            let t113 = -(t33 + t112);
            let t114 = t90 * t34;
            let t115 = t110 + t35 + t114;
            let t116 = -(t32 + t114 + t94 * t38);
            let t117 = t94 * t31;
            let t118 = t117 - t112;
            let t119 = t117 - t33;
            let t120 = t94 * t34;
            let t121 = t90 * t38 - t28 - t120;
            let t122 = t120 + t40 - t103;
            let [(sin_hip1, cos_hip1), (sin_hip2, cos_hip2)] = q_hip1
                .sin_cos_pair(q_hip2);
            let t123 = T::from_f64(0.2) * sin_hip1 + t63;
            let t124 = T::from_f64(0.2) * cos_hip1 + t64;
            let t125 = T::from_f64(0.2) * sin_hip2 + t98;
            let t126 = T::from_f64(0.2) * cos_hip2 + t99;
            let t127 = t12 * t123 - t2 * t124;
            let t128 = t21 * t123 - t124 * t7;
            let t129 = t16 * t123 - t124 * t13;
            let t130 = T::from_f64(0.2) - t123;
            let t131 = t2 * t130 + t8 - t12 * t124;
            let t132 = t130 * t7 + t17 - t124 * t21;
            let t133 = t130 * t13 + t23 - t124 * t16;
            let t134 = t12 * t125 - t2 * t126;
            let t135 = t21 * t125 - t7 * t126;
            let t136 = t16 * t125 - t13 * t126;
            let t137 = T::from_f64(0.2) - t125;
            let t138 = t2 * t137 + t9 - t12 * t126;
            let t139 = t7 * t137 + t18 - t21 * t126;
            let t140 = t13 * t137 + t24 - t16 * t126;
            let t141 = t124 * t29;
            let t142 = -(t28 + t141);
            let t143 = t130 * t30;
            let t144 = t143 + t36 + t124 * t37;
            let t145 = t124 * t31;
            let t146 = t143 + t145;
            let t147 = -(t145 + t36 + t130 * t39);
            let t148 = t130 * t29;
            let t149 = t32 - t148;
            let t150 = t126 * t29;
            let t151 = t28 - t150;
            let t152 = t137 * t29;
            let t153 = -(t32 + t152);
            let t154 = t137 * t30;
            let t155 = t154 + t126 * t37 - t36;
            let t156 = t126 * t31;
            let t157 = t36 - t156 - t137 * t39;
            let t158 = t154 + t156;
            let t159 = t124 * t30;
            let t160 = t33 - t159;
            let t161 = t126 * t30;
            let t162 = -(t33 + t161);
            let t163 = t124 * t34;
            let t164 = t148 + t163 - t35;
            let t165 = t32 - t163 - t130 * t38;
            let t166 = t126 * t34;
            let t167 = t152 + t35 + t166;
            let t168 = -(t32 + t166 + t137 * t38);
            let t169 = t130 * t31;
            let t170 = t169 - t159;
            let t171 = t33 + t169;
            let t172 = t130 * t34;
            let t173 = t28 + t124 * t38 - t172;
            let t174 = t172 - t141 - t40;
            let t175 = t137 * t31;
            let t176 = t175 - t161;
            let t177 = t175 - t33;
            let t178 = t137 * t34;
            let t179 = t126 * t38 - t28 - t178;
            let t180 = t178 + t40 - t150;
            (
                ::pendulum_core::nalgebra::SVector::from([
                    t131,
                    t132,
                    t133,
                    t138,
                    t139,
                    t140,
                    t60,
                    t61,
                    t62,
                    t95,
                    t96,
                    t97,
                ]),
                ::pendulum_core::nalgebra::SMatrix::from([
                    [
                        T::from_f64(1.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(1.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(1.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(1.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                    ],
                    [
                        T::from_f64(0.0),
                        T::from_f64(1.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(1.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(1.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(1.0),
                        T::from_f64(0.0),
                    ],
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(1.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(1.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(1.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(1.0),
                    ],
                    [
                        t142,
                        t146,
                        t149,
                        t151,
                        t158,
                        t153,
                        t69,
                        t73,
                        t76,
                        t104,
                        t108,
                        t111,
                    ],
                    [
                        t160,
                        t164,
                        t144,
                        t162,
                        t167,
                        t155,
                        t78,
                        t80,
                        t71,
                        t113,
                        t115,
                        t106,
                    ],
                    [
                        t165,
                        t170,
                        t173,
                        t168,
                        t176,
                        t179,
                        t81,
                        t83,
                        t86,
                        t116,
                        t118,
                        t121,
                    ],
                    [
                        t147,
                        t174,
                        t171,
                        t157,
                        t180,
                        t177,
                        t74,
                        t87,
                        t84,
                        t109,
                        t122,
                        t119,
                    ],
                    [
                        t127,
                        t128,
                        t129,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                    ],
                    [
                        t65,
                        t66,
                        t67,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                    ],
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t134,
                        t135,
                        t136,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                    ],
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t100,
                        t101,
                        t102,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                    ],
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t56,
                        t57,
                        t58,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                    ],
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t45,
                        t46,
                        t47,
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                    ],
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t91,
                        t92,
                        t93,
                    ],
                    [
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        T::from_f64(0.0),
                        t50,
                        t51,
                        t52,
                    ],
                    [
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
                    ],
                    [
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
                    ],
                    [
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
                    ],
                    [
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
                    ],
                    [
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
                    ],
                    [
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
                    ],
                    [
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
                    ],
                    [
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
                    ],
                    [
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
                    ],
                    [
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
                    ],
                    [
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
                    ],
                    [
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
                    ],
                    [
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
                    ],
                    [
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
                    ],
                ]),
            )
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::shapes::Shapes<29> for Quadruped {
        fn shapes(
            &self,
            t: f64,
            x: &::pendulum_core::nalgebra::SVector<f64, 29>,
        ) -> ::pendulum_core::shapes::Vec<::pendulum_core::shapes::Shape> {
            use ::pendulum_core::real::Real as _;
            type T = f64;
            ::pendulum_core::shapes::placed(
                &[
                    ::pendulum_core::shapes::Outline {
                        name: "trunk",
                        kind: ::pendulum_core::shapes::ShapeKind::Cuboid,
                        points: 8,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "thigh1",
                        kind: ::pendulum_core::shapes::ShapeKind::Rod,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "thigh2",
                        kind: ::pendulum_core::shapes::ShapeKind::Rod,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "thigh3",
                        kind: ::pendulum_core::shapes::ShapeKind::Rod,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "thigh4",
                        kind: ::pendulum_core::shapes::ShapeKind::Rod,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "shin1",
                        kind: ::pendulum_core::shapes::ShapeKind::Rod,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "shin2",
                        kind: ::pendulum_core::shapes::ShapeKind::Rod,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "shin3",
                        kind: ::pendulum_core::shapes::ShapeKind::Rod,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "shin4",
                        kind: ::pendulum_core::shapes::ShapeKind::Rod,
                        points: 2,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "thigh1",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "thigh2",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "thigh3",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "thigh4",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "shin1",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "shin2",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "shin3",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "shin4",
                        kind: ::pendulum_core::shapes::ShapeKind::Pivot,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "foot1",
                        kind: ::pendulum_core::shapes::ShapeKind::Point,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "foot2",
                        kind: ::pendulum_core::shapes::ShapeKind::Point,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "foot3",
                        kind: ::pendulum_core::shapes::ShapeKind::Point,
                        points: 1,
                        radius: false,
                    },
                    ::pendulum_core::shapes::Outline {
                        name: "foot4",
                        kind: ::pendulum_core::shapes::ShapeKind::Point,
                        points: 1,
                        radius: false,
                    },
                ],
                &{
                    let [qx_p, qy_p, qz_p, qw_o, qx_o, qy_o, qz_o, q_hip1, q_knee1,
                    q_hip2, q_knee2, q_hip3, q_knee3, q_hip4, q_knee4, _, _, _, _, _, _,
                    _, _, _, _, _, _, _, _] = x.data.0[0];
                    let t0 = qx_o * qz_o;
                    let t1 = qy_o * qw_o;
                    let t2 = t0 + t1;
                    let t3 = t0 - t1;
                    let t4 = T::from_f64(0.08) * t2;
                    let t5 = T::from_f64(2.0) * t2;
                    let t6 = qy_o * qy_o;
                    let t7 = qz_o * qz_o;
                    let t8 = T::from_f64(1.0) - T::from_f64(2.0) * (t6 + t7);
                    let t9 = T::from_f64(0.22) * t8;
                    let t10 = qx_o * qy_o;
                    let t11 = qz_o * qw_o;
                    let t12 = t10 - t11;
                    let t13 = t10 + t11;
                    let t14 = T::from_f64(0.14) * t12;
                    let t15 = T::from_f64(0.2) * t12;
                    let t16 = t9 + t14;
                    let t17 = t9 - t14;
                    let t18 = t4 + t16;
                    let t19 = qx_p + t18;
                    let t20 = qx_p - t18;
                    let t21 = qz_o * qy_o;
                    let t22 = qx_o * qw_o;
                    let t23 = t21 - t22;
                    let t24 = t21 + t22;
                    let t25 = T::from_f64(0.08) * t23;
                    let t26 = T::from_f64(2.0) * t23;
                    let t27 = T::from_f64(0.44) * t13;
                    let t28 = qx_o * qx_o;
                    let t29 = T::from_f64(1.0) - T::from_f64(2.0) * (t7 + t28);
                    let t30 = T::from_f64(1.0) - T::from_f64(2.0) * (t6 + t28);
                    let t31 = T::from_f64(0.07) * t29;
                    let t32 = T::from_f64(0.1) * t29;
                    let t33 = t27 + t31;
                    let t34 = t27 - t31;
                    let t35 = t25 + t33;
                    let t36 = qy_p + t35;
                    let t37 = qy_p - t35;
                    let t38 = T::from_f64(0.04) * t30;
                    let t39 = T::from_f64(0.44) * t3;
                    let t40 = T::from_f64(0.14) * t24;
                    let t41 = T::from_f64(0.2) * t24;
                    let t42 = t39 + t40;
                    let t43 = t39 - t40;
                    let t44 = t38 + t42;
                    let t45 = qz_p + t44;
                    let t46 = qz_p - t44;
                    let t47 = qx_p + t4;
                    let t48 = t47 - t17;
                    let t49 = t17 + t47;
                    let t50 = t47 - t16;
                    let t51 = qx_p - t4;
                    let t52 = t16 + t51;
                    let t53 = t51 - t17;
                    let t54 = t17 + t51;
                    let t55 = qy_p + t25;
                    let t56 = t55 - t34;
                    let t57 = t34 + t55;
                    let t58 = t55 - t33;
                    let t59 = qy_p - t25;
                    let t60 = t33 + t59;
                    let t61 = t59 - t34;
                    let t62 = t34 + t59;
                    let t63 = qz_p + t38;
                    let t64 = t63 - t43;
                    let t65 = t43 + t63;
                    let t66 = t63 - t42;
                    let t67 = qz_p - t38;
                    let t68 = t42 + t67;
                    let t69 = t67 - t43;
                    let t70 = t43 + t67;
                    let t71 = T::from_f64(0.2) * t8;
                    let t72 = t15 + t71;
                    let t73 = qx_p + t72;
                    let t74 = qx_p - t72;
                    let t75 = T::from_f64(0.4) * t13;
                    let t76 = T::from_f64(2.0) * t13;
                    let t77 = t32 + t75;
                    let t78 = qy_p + t77;
                    let t79 = qy_p - t77;
                    let t80 = T::from_f64(0.4) * t3;
                    let t81 = T::from_f64(2.0) * t3;
                    let t82 = t41 + t80;
                    let t83 = qz_p + t82;
                    let t84 = qz_p - t82;
                    let t85 = qx_p + t15;
                    let t86 = qx_p - t15;
                    let t87 = qy_p + t32;
                    let t88 = qy_p - t32;
                    let t89 = qz_p + t41;
                    let t90 = qz_p - t41;
                    let t91 = t71 + t86;
                    let t92 = t85 - t71;
                    let t93 = t75 + t88;
                    let t94 = t87 - t75;
                    let t95 = t80 + t90;
                    let t96 = t89 - t80;
                    let t97 = q_hip1 + q_knee1;
                    let t98 = q_hip2 + q_knee2;
                    let t99 = q_hip3 + q_knee3;
                    let t100 = q_hip4 + q_knee4;
                    let [(sin101, cos101), (sin102, cos102)] = t97.sin_cos_pair(t98);
                    let [(sin103, cos103), (sin104, cos104)] = t99.sin_cos_pair(t100);
                    let [(sin_hip1, cos_hip1), (sin_hip2, cos_hip2)] = q_hip1
                        .sin_cos_pair(q_hip2);
                    let t105 = T::from_f64(0.2) - T::from_f64(0.2) * sin_hip1;
                    let t106 = T::from_f64(0.2) * cos_hip1;
                    let t107 = t8 * t105 + t85 - t5 * t106;
                    let t108 = t105 * t76 + t87 - t106 * t26;
                    let t109 = t105 * t81 + t89 - t30 * t106;
                    let t110 = t105 - T::from_f64(0.2) * sin101;
                    let t111 = t106 + T::from_f64(0.2) * cos101;
                    let t112 = T::from_f64(0.2) - T::from_f64(0.2) * sin_hip2;
                    let t113 = T::from_f64(0.2) * cos_hip2;
                    let t114 = t8 * t112 + t86 - t5 * t113;
                    let t115 = t76 * t112 + t88 - t26 * t113;
                    let t116 = t81 * t112 + t90 - t30 * t113;
                    let t117 = t112 - T::from_f64(0.2) * sin102;
                    let t118 = t113 + T::from_f64(0.2) * cos102;
                    let t119 = t8 * t110 + t85 - t5 * t111;
                    let t120 = t76 * t110 + t87 - t26 * t111;
                    let t121 = t81 * t110 + t89 - t30 * t111;
                    let t122 = t8 * t117 + t86 - t5 * t118;
                    let t123 = t76 * t117 + t88 - t26 * t118;
                    let t124 = t81 * t117 + t90 - t30 * t118;
                    let [(sin_hip3, cos_hip3), (sin_hip4, cos_hip4)] = q_hip3
                        .sin_cos_pair(q_hip4);
                    let t125 = T::from_f64(-0.2) - T::from_f64(0.2) * sin_hip3;
                    let t126 = T::from_f64(0.2) * cos_hip3;
                    let t127 = t8 * t125 + t85 - t5 * t126;
                    let t128 = t76 * t125 + t87 - t26 * t126;
                    let t129 = t81 * t125 + t89 - t30 * t126;
                    let t130 = t125 - T::from_f64(0.2) * sin103;
                    let t131 = t126 + T::from_f64(0.2) * cos103;
                    let t132 = t8 * t130 + t85 - t5 * t131;
                    let t133 = t76 * t130 + t87 - t26 * t131;
                    let t134 = t81 * t130 + t89 - t30 * t131;
                    let t135 = T::from_f64(-0.2) - T::from_f64(0.2) * sin_hip4;
                    let t136 = T::from_f64(0.2) * cos_hip4;
                    let t137 = t8 * t135 + t86 - t5 * t136;
                    let t138 = t76 * t135 + t88 - t26 * t136;
                    let t139 = t81 * t135 + t90 - t30 * t136;
                    let t140 = t135 - T::from_f64(0.2) * sin104;
                    let t141 = t136 + T::from_f64(0.2) * cos104;
                    let t142 = t8 * t140 + t86 - t5 * t141;
                    let t143 = t76 * t140 + t88 - t26 * t141;
                    let t144 = t81 * t140 + t90 - t30 * t141;
                    [
                        t19,
                        t36,
                        t45,
                        t48,
                        t56,
                        t64,
                        t49,
                        t57,
                        t65,
                        t50,
                        t58,
                        t66,
                        t52,
                        t60,
                        t68,
                        t53,
                        t61,
                        t69,
                        t54,
                        t62,
                        t70,
                        t20,
                        t37,
                        t46,
                        t73,
                        t78,
                        t83,
                        t107,
                        t108,
                        t109,
                        t91,
                        t93,
                        t95,
                        t114,
                        t115,
                        t116,
                        t92,
                        t94,
                        t96,
                        t127,
                        t128,
                        t129,
                        t74,
                        t79,
                        t84,
                        t137,
                        t138,
                        t139,
                        t107,
                        t108,
                        t109,
                        t119,
                        t120,
                        t121,
                        t114,
                        t115,
                        t116,
                        t122,
                        t123,
                        t124,
                        t127,
                        t128,
                        t129,
                        t132,
                        t133,
                        t134,
                        t137,
                        t138,
                        t139,
                        t142,
                        t143,
                        t144,
                        t73,
                        t78,
                        t83,
                        t91,
                        t93,
                        t95,
                        t92,
                        t94,
                        t96,
                        t74,
                        t79,
                        t84,
                        t107,
                        t108,
                        t109,
                        t114,
                        t115,
                        t116,
                        t127,
                        t128,
                        t129,
                        t137,
                        t138,
                        t139,
                        t119,
                        t120,
                        t121,
                        t122,
                        t123,
                        t124,
                        t132,
                        t133,
                        t134,
                        t142,
                        t143,
                        t144,
                    ]
                },
            )
        }
    }
    #[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)]
    impl ::pendulum_core::Cast<29> for Quadruped {
        type In<T: ::pendulum_core::real::Real> = Quadruped<T>;
        fn cast<T: ::pendulum_core::real::Real>(&self) -> Quadruped<T> {
            Quadruped::cast(self)
        }
        #[inline]
        fn gather<'m, T: ::pendulum_core::real::lanes::Lanes>(
            models: impl ::core::ops::Fn(usize) -> &'m Self,
        ) -> Quadruped<T>
        where
            Self: 'm,
        {
            let scalar = <<T as ::pendulum_core::real::lanes::Lanes>::Scalar as ::pendulum_core::real::Real>::from_f64;
            Quadruped {
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
pub use __Quadruped::{Quadruped, QuadrupedParams};
