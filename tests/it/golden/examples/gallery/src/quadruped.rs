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
A[p.z, knee1] = 0.015*t8*s_hip1_knee1 - 0.03*t6*c_hip1_knee1
A[p.z, hip2] = t8*t110 - 2*t6*t109
A[p.z, knee2] = 0.015*t8*s_hip2_knee2 - 0.03*t6*c_hip2_knee2
A[p.z, hip3] = t8*t106 - 2*t6*t105
A[p.z, knee3] = 0.015*t8*s_hip3_knee3 - 0.03*t6*c_hip3_knee3
A[p.z, hip4] = t8*t102 - 2*t6*t101
A[p.z, knee4] = 0.015*t8*s_hip4_knee4 - 0.03*t6*c_hip4_knee4
A[o.x, o.x] = t119 + t122 + t120 - t121 - t122
A[o.x, o.y] = 0.1*t114 + 0.1*t106 - 0.1*t102 - 0.1*t110
A[o.x, o.z] = -(0.01*s_hip4*c_hip4 + 0.002*s_hip4_knee4*c_hip4_knee4 + 0.003*c_hip4*s_hip4_knee4
    + 0.003*s_hip4*c_hip4_knee4 + 0.2*t101 + 0.01*s_hip3*c_hip3 + 0.002*s_hip3_knee3*c_hip3_knee3
    + 0.003*c_hip3*s_hip3_knee3 + 0.003*s_hip3*c_hip3_knee3 + 0.2*t105 + 0.01*s_hip2*c_hip2
    + 0.002*s_hip2_knee2*c_hip2_knee2 + 0.003*c_hip2*s_hip2_knee2 + 0.003*s_hip2*c_hip2_knee2 + 0.01*s_hip1*c_hip1
    + 0.002*s_hip1_knee1*c_hip1_knee1 + 0.003*c_hip1*s_hip1_knee1 + 0.003*s_hip1*c_hip1_knee1 - 0.2*t109 - 0.2*t113)
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
A[hip1, knee1] = A[knee1, knee1] + 0.003*c_hip1*c_hip1_knee1 + 0.003*s_hip1*s_hip1_knee1
A[knee1, knee1] = 0.002*c_hip1_knee1^2 + t13
A[hip2, hip2] = t111 + t112
A[hip2, knee2] = A[knee2, knee2] + 0.003*c_hip2*c_hip2_knee2 + 0.003*s_hip2*s_hip2_knee2
A[knee2, knee2] = 0.002*c_hip2_knee2^2 + t14
A[hip3, hip3] = t107 + t108
A[hip3, knee3] = A[knee3, knee3] + 0.003*c_hip3*c_hip3_knee3 + 0.003*s_hip3*s_hip3_knee3
A[knee3, knee3] = 0.002*c_hip3_knee3^2 + t15
A[hip4, hip4] = t103 + t104
A[hip4, knee4] = A[knee4, knee4] + 0.003*c_hip4*c_hip4_knee4 + 0.003*s_hip4*s_hip4_knee4
A[knee4, knee4] = 0.002*c_hip4_knee4^2 + t16
b[p.x] = t0*t98 + t2*t100 - t1*t99
b[p.y] = t3*t98 + t5*t100 - t4*t99
b[p.z] = 56.898 + 2*t6*t98 + t8*t100 - 2*t7*t99
b[o.x] = 46/1875*dot(o).y*dot(o).z + 0.06*c_hip4*t44 + 0.015*c_hip4_knee4*t68 + 0.06*c_hip3*t37 + 0.015*c_hip3_knee3*t62
    + 0.1*t89 + 0.06*c_hip2*t30 + 0.015*c_hip2_knee2*t56 + 0.06*c_hip1*t21 + 0.015*c_hip1_knee1*t50 + 0.1*t95
    - 4/1875*dot(o).y*dot(o).z - 0.01*c_hip4^2*t48 - 0.01*s_hip4*c_hip4*t49 - 0.002*c_hip4_knee4^2*t72
    - 0.002*s_hip4_knee4*c_hip4_knee4*t73 - 0.2*c_hip4*t85 - 0.1*t86 - 0.01*c_hip3^2*t41 - 0.01*s_hip3*c_hip3*t42
    - 0.002*c_hip3_knee3^2*t66 - 0.002*s_hip3_knee3*c_hip3_knee3*t67 - 0.2*c_hip3*t82 - 0.01*c_hip2^2*t34
    - 0.01*s_hip2*c_hip2*t35 - 0.002*c_hip2_knee2^2*t60 - 0.002*s_hip2_knee2*c_hip2_knee2*t61 - 0.2*c_hip2*t79 - 0.1*t92
    - 0.01*c_hip1^2*t25 - 0.01*s_hip1*c_hip1*t26 - 0.002*c_hip1_knee1^2*t54 - 0.002*s_hip1_knee1*c_hip1_knee1*t55
    - 0.2*c_hip1*t76
b[o.y] = 4/1875*dot(o).x*dot(o).z + b[hip4] + 0.2*t86 + b[hip3] + 0.2*t89 + b[hip2] + b[hip1]
    - 256/1875*dot(o).x*dot(o).z - 0.2*t92 - 0.2*t95
b[o.z] = 256/1875*dot(o).x*dot(o).y + t12*t49 + 0.01*s_hip4*c_hip4*t48 + t16*t73 + 0.002*s_hip4_knee4*c_hip4_knee4*t72
    + 0.2*s_hip4*t85 + 0.2*t88 + 0.1*t87 + t11*t42 + 0.01*s_hip3*c_hip3*t41 + t15*t67
    + 0.002*s_hip3_knee3*c_hip3_knee3*t66 + 0.2*s_hip3*t82 + 0.2*t91 + t10*t35 + 0.01*s_hip2*c_hip2*t34 + t14*t61
    + 0.002*s_hip2_knee2*c_hip2_knee2*t60 + 0.2*s_hip2*t79 + 0.1*t93 + t9*t26 + 0.01*s_hip1*c_hip1*t25 + t13*t55
    + 0.002*s_hip1_knee1*c_hip1_knee1*t54 + 0.2*s_hip1*t76 - 46/1875*dot(o).x*dot(o).y - 0.06*s_hip4*t44
    - 0.015*s_hip4_knee4*t68 - 0.06*s_hip3*t37 - 0.015*s_hip3_knee3*t62 - 0.1*t90 - 0.06*s_hip2*t30
    - 0.015*s_hip2_knee2*t56 - 0.2*t94 - 0.06*s_hip1*t21 - 0.015*s_hip1_knee1*t50 - 0.2*t97 - 0.1*t96
b[hip1] = 0.06*s_hip1*t22 + 0.01*s_hip1*c_hip1*(t23 - t24) + 0.01*dot(o).x*dot(o).z*c_hip1^2 + b[knee1] + 0.2*s_hip1*t74
    - 0.06*c_hip1*t20 - dot(o).x*dot(o).z*t9 - 0.2*c_hip1*t75
b[knee1] = 0.015*s_hip1_knee1*(t22 + 0.2*c_hip1*t23 - 0.2*dot(o).x*dot(o).z*s_hip1)
    + 0.002*s_hip1_knee1*c_hip1_knee1*(t52 - t53) + 0.002*dot(o).x*dot(o).z*c_hip1_knee1^2
    - 0.015*c_hip1_knee1*(t20 + 0.2*s_hip1*t24 - 0.2*dot(o).x*dot(o).z*c_hip1) - dot(o).x*dot(o).z*t13
b[hip2] = 0.06*s_hip2*t31 + 0.01*s_hip2*c_hip2*(t32 - t33) + 0.01*dot(o).x*dot(o).z*c_hip2^2 + b[knee2] + 0.2*s_hip2*t77
    - 0.06*c_hip2*t29 - dot(o).x*dot(o).z*t10 - 0.2*c_hip2*t78
b[knee2] = 0.015*s_hip2_knee2*(t31 + 0.2*c_hip2*t32 - 0.2*dot(o).x*dot(o).z*s_hip2)
    + 0.002*s_hip2_knee2*c_hip2_knee2*(t58 - t59) + 0.002*dot(o).x*dot(o).z*c_hip2_knee2^2
    - 0.015*c_hip2_knee2*(t29 + 0.2*s_hip2*t33 - 0.2*dot(o).x*dot(o).z*c_hip2) - dot(o).x*dot(o).z*t14
b[hip3] = 0.06*s_hip3*t38 + 0.01*s_hip3*c_hip3*(t39 - t40) + 0.01*dot(o).x*dot(o).z*c_hip3^2 + b[knee3] + 0.2*s_hip3*t80
    - 0.06*c_hip3*t36 - dot(o).x*dot(o).z*t11 - 0.2*c_hip3*t81
b[knee3] = 0.015*s_hip3_knee3*(t38 + 0.2*c_hip3*t39 - 0.2*dot(o).x*dot(o).z*s_hip3)
    + 0.002*s_hip3_knee3*c_hip3_knee3*(t64 - t65) + 0.002*dot(o).x*dot(o).z*c_hip3_knee3^2
    - 0.015*c_hip3_knee3*(t36 + 0.2*s_hip3*t40 - 0.2*dot(o).x*dot(o).z*c_hip3) - dot(o).x*dot(o).z*t15
b[hip4] = 0.06*s_hip4*t45 + 0.01*s_hip4*c_hip4*(t46 - t47) + 0.01*dot(o).x*dot(o).z*c_hip4^2 + b[knee4] + 0.2*s_hip4*t83
    - 0.06*c_hip4*t43 - dot(o).x*dot(o).z*t12 - 0.2*c_hip4*t84
b[knee4] = 0.015*s_hip4_knee4*(t45 + 0.2*c_hip4*t46 - 0.2*dot(o).x*dot(o).z*s_hip4)
    + 0.002*s_hip4_knee4*c_hip4_knee4*(t70 - t71) + 0.002*dot(o).x*dot(o).z*c_hip4_knee4^2
    - 0.015*c_hip4_knee4*(t43 + 0.2*s_hip4*t47 - 0.2*dot(o).x*dot(o).z*c_hip4) - dot(o).x*dot(o).z*t16
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
t103 = 0.01*c_hip4^2 + 0.002*c_hip4_knee4^2 + 0.006*c_hip4*c_hip4_knee4
t104 = t12 + t16 + 0.006*s_hip4*s_hip4_knee4
t105 = 0.015*c_hip3_knee3 + 0.06*c_hip3
t106 = 0.015*s_hip3_knee3 + 0.06*s_hip3
t107 = 0.01*c_hip3^2 + 0.002*c_hip3_knee3^2 + 0.006*c_hip3*c_hip3_knee3
t108 = t11 + t15 + 0.006*s_hip3*s_hip3_knee3
t109 = 0.015*c_hip2_knee2 + 0.06*c_hip2
t110 = 0.015*s_hip2_knee2 + 0.06*s_hip2
t111 = 0.01*c_hip2^2 + 0.002*c_hip2_knee2^2 + 0.006*c_hip2*c_hip2_knee2
t112 = t10 + t14 + 0.006*s_hip2*s_hip2_knee2
t113 = 0.015*c_hip1_knee1 + 0.06*c_hip1
t114 = 0.015*s_hip1_knee1 + 0.06*s_hip1
t115 = 0.01*c_hip1^2 + 0.002*c_hip1_knee1^2 + 0.006*c_hip1*c_hip1_knee1
t116 = t9 + t13 + 0.006*s_hip1*s_hip1_knee1
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
        /// The first parameter, or combination of parameters, that is not finite or that no rigid body can
        /// have.
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
        /// The same model in another number type, such as `f32`. Its constants are computed in double precision
        /// and then rounded.
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
                            ::pendulum_core::Operations::new(694, 743, 14, 9, 0, 145),
                        )
                        .with_others(
                            &[
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of the state first, L^T D L",
                                    ::pendulum_core::Operations::new(797, 944, 10, 9, 0, 116),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, factors of parameters first, L^T D L",
                                    ::pendulum_core::Operations::new(810, 958, 10, 9, 0, 116),
                                ),
                                ::pendulum_core::FunctionCost::new(
                                    "closed form, expanded, L^T D L",
                                    ::pendulum_core::Operations::new(894, 1052, 10, 9, 0, 170),
                                ),
                            ],
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
        pub const EQUATIONS: &'static str = "A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints\n\nA[p.x, p.x] = 5.8\nA[p.x, o.x] = t1*t118\nA[p.x, o.y] = t2*t117 - t0*t118\nA[p.x, o.z] = -t1*t117\nA[p.x, hip1] = t2*t114 - t0*t113\nA[p.x, knee1] = 0.015*t2*s_hip1_knee1 - 0.015*t0*c_hip1_knee1\nA[p.x, hip2] = t2*t110 - t0*t109\nA[p.x, knee2] = 0.015*t2*s_hip2_knee2 - 0.015*t0*c_hip2_knee2\nA[p.x, hip3] = t2*t106 - t0*t105\nA[p.x, knee3] = 0.015*t2*s_hip3_knee3 - 0.015*t0*c_hip3_knee3\nA[p.x, hip4] = t2*t102 - t0*t101\nA[p.x, knee4] = 0.015*t2*s_hip4_knee4 - 0.015*t0*c_hip4_knee4\nA[p.y, p.y] = 5.8\nA[p.y, o.x] = t4*t118\nA[p.y, o.y] = t5*t117 - t3*t118\nA[p.y, o.z] = -t4*t117\nA[p.y, hip1] = t5*t114 - t3*t113\nA[p.y, knee1] = 0.015*t5*s_hip1_knee1 - 0.015*t3*c_hip1_knee1\nA[p.y, hip2] = t5*t110 - t3*t109\nA[p.y, knee2] = 0.015*t5*s_hip2_knee2 - 0.015*t3*c_hip2_knee2\nA[p.y, hip3] = t5*t106 - t3*t105\nA[p.y, knee3] = 0.015*t5*s_hip3_knee3 - 0.015*t3*c_hip3_knee3\nA[p.y, hip4] = t5*t102 - t3*t101\nA[p.y, knee4] = 0.015*t5*s_hip4_knee4 - 0.015*t3*c_hip4_knee4\nA[p.z, p.z] = 5.8\nA[p.z, o.x] = 2*t7*t118\nA[p.z, o.y] = t8*t117 - 2*t6*t118\nA[p.z, o.z] = -2*t7*t117\nA[p.z, hip1] = t8*t114 - 2*t6*t113\nA[p.z, knee1] = 0.015*t8*s_hip1_knee1 - 0.03*t6*c_hip1_knee1\nA[p.z, hip2] = t8*t110 - 2*t6*t109\nA[p.z, knee2] = 0.015*t8*s_hip2_knee2 - 0.03*t6*c_hip2_knee2\nA[p.z, hip3] = t8*t106 - 2*t6*t105\nA[p.z, knee3] = 0.015*t8*s_hip3_knee3 - 0.03*t6*c_hip3_knee3\nA[p.z, hip4] = t8*t102 - 2*t6*t101\nA[p.z, knee4] = 0.015*t8*s_hip4_knee4 - 0.03*t6*c_hip4_knee4\nA[o.x, o.x] = t119 + t122 + t120 - t121 - t122\nA[o.x, o.y] = 0.1*t114 + 0.1*t106 - 0.1*t102 - 0.1*t110\nA[o.x, o.z] = -(0.01*s_hip4*c_hip4 + 0.002*s_hip4_knee4*c_hip4_knee4 + 0.003*c_hip4*s_hip4_knee4\n    + 0.003*s_hip4*c_hip4_knee4 + 0.2*t101 + 0.01*s_hip3*c_hip3 + 0.002*s_hip3_knee3*c_hip3_knee3\n    + 0.003*c_hip3*s_hip3_knee3 + 0.003*s_hip3*c_hip3_knee3 + 0.2*t105 + 0.01*s_hip2*c_hip2\n    + 0.002*s_hip2_knee2*c_hip2_knee2 + 0.003*c_hip2*s_hip2_knee2 + 0.003*s_hip2*c_hip2_knee2 + 0.01*s_hip1*c_hip1\n    + 0.002*s_hip1_knee1*c_hip1_knee1 + 0.003*c_hip1*s_hip1_knee1 + 0.003*s_hip1*c_hip1_knee1 - 0.2*t109 - 0.2*t113)\nA[o.x, hip1] = 0.1*t114\nA[o.x, knee1] = 0.0015*s_hip1_knee1\nA[o.x, hip2] = -0.1*t110\nA[o.x, knee2] = -0.0015*s_hip2_knee2\nA[o.x, hip3] = 0.1*t106\nA[o.x, knee3] = 0.0015*s_hip3_knee3\nA[o.x, hip4] = -0.1*t102\nA[o.x, knee4] = -0.0015*s_hip4_knee4\nA[o.y, o.y] = t120 + t122\nA[o.y, o.z] = 0.1*t113 + 0.1*t105 - 0.1*t101 - 0.1*t109\nA[o.y, hip1] = t115 + t116 - 0.2*t114\nA[o.y, knee1] = A[hip1, knee1] - 0.003*s_hip1_knee1\nA[o.y, hip2] = t111 + t112 - 0.2*t110\nA[o.y, knee2] = A[hip2, knee2] - 0.003*s_hip2_knee2\nA[o.y, hip3] = 0.2*t106 + t107 + t108\nA[o.y, knee3] = A[hip3, knee3] + 0.003*s_hip3_knee3\nA[o.y, hip4] = 0.2*t102 + t103 + t104\nA[o.y, knee4] = A[hip4, knee4] + 0.003*s_hip4_knee4\nA[o.z, o.z] = 46/1875 + t119\nA[o.z, hip1] = 0.1*t113\nA[o.z, knee1] = 0.0015*c_hip1_knee1\nA[o.z, hip2] = -0.1*t109\nA[o.z, knee2] = -0.0015*c_hip2_knee2\nA[o.z, hip3] = 0.1*t105\nA[o.z, knee3] = 0.0015*c_hip3_knee3\nA[o.z, hip4] = -0.1*t101\nA[o.z, knee4] = -0.0015*c_hip4_knee4\nA[hip1, hip1] = t115 + t116\nA[hip1, knee1] = A[knee1, knee1] + 0.003*c_hip1*c_hip1_knee1 + 0.003*s_hip1*s_hip1_knee1\nA[knee1, knee1] = 0.002*c_hip1_knee1^2 + t13\nA[hip2, hip2] = t111 + t112\nA[hip2, knee2] = A[knee2, knee2] + 0.003*c_hip2*c_hip2_knee2 + 0.003*s_hip2*s_hip2_knee2\nA[knee2, knee2] = 0.002*c_hip2_knee2^2 + t14\nA[hip3, hip3] = t107 + t108\nA[hip3, knee3] = A[knee3, knee3] + 0.003*c_hip3*c_hip3_knee3 + 0.003*s_hip3*s_hip3_knee3\nA[knee3, knee3] = 0.002*c_hip3_knee3^2 + t15\nA[hip4, hip4] = t103 + t104\nA[hip4, knee4] = A[knee4, knee4] + 0.003*c_hip4*c_hip4_knee4 + 0.003*s_hip4*s_hip4_knee4\nA[knee4, knee4] = 0.002*c_hip4_knee4^2 + t16\nb[p.x] = t0*t98 + t2*t100 - t1*t99\nb[p.y] = t3*t98 + t5*t100 - t4*t99\nb[p.z] = 56.898 + 2*t6*t98 + t8*t100 - 2*t7*t99\nb[o.x] = 46/1875*dot(o).y*dot(o).z + 0.06*c_hip4*t44 + 0.015*c_hip4_knee4*t68 + 0.06*c_hip3*t37 + 0.015*c_hip3_knee3*t62\n    + 0.1*t89 + 0.06*c_hip2*t30 + 0.015*c_hip2_knee2*t56 + 0.06*c_hip1*t21 + 0.015*c_hip1_knee1*t50 + 0.1*t95\n    - 4/1875*dot(o).y*dot(o).z - 0.01*c_hip4^2*t48 - 0.01*s_hip4*c_hip4*t49 - 0.002*c_hip4_knee4^2*t72\n    - 0.002*s_hip4_knee4*c_hip4_knee4*t73 - 0.2*c_hip4*t85 - 0.1*t86 - 0.01*c_hip3^2*t41 - 0.01*s_hip3*c_hip3*t42\n    - 0.002*c_hip3_knee3^2*t66 - 0.002*s_hip3_knee3*c_hip3_knee3*t67 - 0.2*c_hip3*t82 - 0.01*c_hip2^2*t34\n    - 0.01*s_hip2*c_hip2*t35 - 0.002*c_hip2_knee2^2*t60 - 0.002*s_hip2_knee2*c_hip2_knee2*t61 - 0.2*c_hip2*t79 - 0.1*t92\n    - 0.01*c_hip1^2*t25 - 0.01*s_hip1*c_hip1*t26 - 0.002*c_hip1_knee1^2*t54 - 0.002*s_hip1_knee1*c_hip1_knee1*t55\n    - 0.2*c_hip1*t76\nb[o.y] = 4/1875*dot(o).x*dot(o).z + b[hip4] + 0.2*t86 + b[hip3] + 0.2*t89 + b[hip2] + b[hip1]\n    - 256/1875*dot(o).x*dot(o).z - 0.2*t92 - 0.2*t95\nb[o.z] = 256/1875*dot(o).x*dot(o).y + t12*t49 + 0.01*s_hip4*c_hip4*t48 + t16*t73 + 0.002*s_hip4_knee4*c_hip4_knee4*t72\n    + 0.2*s_hip4*t85 + 0.2*t88 + 0.1*t87 + t11*t42 + 0.01*s_hip3*c_hip3*t41 + t15*t67\n    + 0.002*s_hip3_knee3*c_hip3_knee3*t66 + 0.2*s_hip3*t82 + 0.2*t91 + t10*t35 + 0.01*s_hip2*c_hip2*t34 + t14*t61\n    + 0.002*s_hip2_knee2*c_hip2_knee2*t60 + 0.2*s_hip2*t79 + 0.1*t93 + t9*t26 + 0.01*s_hip1*c_hip1*t25 + t13*t55\n    + 0.002*s_hip1_knee1*c_hip1_knee1*t54 + 0.2*s_hip1*t76 - 46/1875*dot(o).x*dot(o).y - 0.06*s_hip4*t44\n    - 0.015*s_hip4_knee4*t68 - 0.06*s_hip3*t37 - 0.015*s_hip3_knee3*t62 - 0.1*t90 - 0.06*s_hip2*t30\n    - 0.015*s_hip2_knee2*t56 - 0.2*t94 - 0.06*s_hip1*t21 - 0.015*s_hip1_knee1*t50 - 0.2*t97 - 0.1*t96\nb[hip1] = 0.06*s_hip1*t22 + 0.01*s_hip1*c_hip1*(t23 - t24) + 0.01*dot(o).x*dot(o).z*c_hip1^2 + b[knee1] + 0.2*s_hip1*t74\n    - 0.06*c_hip1*t20 - dot(o).x*dot(o).z*t9 - 0.2*c_hip1*t75\nb[knee1] = 0.015*s_hip1_knee1*(t22 + 0.2*c_hip1*t23 - 0.2*dot(o).x*dot(o).z*s_hip1)\n    + 0.002*s_hip1_knee1*c_hip1_knee1*(t52 - t53) + 0.002*dot(o).x*dot(o).z*c_hip1_knee1^2\n    - 0.015*c_hip1_knee1*(t20 + 0.2*s_hip1*t24 - 0.2*dot(o).x*dot(o).z*c_hip1) - dot(o).x*dot(o).z*t13\nb[hip2] = 0.06*s_hip2*t31 + 0.01*s_hip2*c_hip2*(t32 - t33) + 0.01*dot(o).x*dot(o).z*c_hip2^2 + b[knee2] + 0.2*s_hip2*t77\n    - 0.06*c_hip2*t29 - dot(o).x*dot(o).z*t10 - 0.2*c_hip2*t78\nb[knee2] = 0.015*s_hip2_knee2*(t31 + 0.2*c_hip2*t32 - 0.2*dot(o).x*dot(o).z*s_hip2)\n    + 0.002*s_hip2_knee2*c_hip2_knee2*(t58 - t59) + 0.002*dot(o).x*dot(o).z*c_hip2_knee2^2\n    - 0.015*c_hip2_knee2*(t29 + 0.2*s_hip2*t33 - 0.2*dot(o).x*dot(o).z*c_hip2) - dot(o).x*dot(o).z*t14\nb[hip3] = 0.06*s_hip3*t38 + 0.01*s_hip3*c_hip3*(t39 - t40) + 0.01*dot(o).x*dot(o).z*c_hip3^2 + b[knee3] + 0.2*s_hip3*t80\n    - 0.06*c_hip3*t36 - dot(o).x*dot(o).z*t11 - 0.2*c_hip3*t81\nb[knee3] = 0.015*s_hip3_knee3*(t38 + 0.2*c_hip3*t39 - 0.2*dot(o).x*dot(o).z*s_hip3)\n    + 0.002*s_hip3_knee3*c_hip3_knee3*(t64 - t65) + 0.002*dot(o).x*dot(o).z*c_hip3_knee3^2\n    - 0.015*c_hip3_knee3*(t36 + 0.2*s_hip3*t40 - 0.2*dot(o).x*dot(o).z*c_hip3) - dot(o).x*dot(o).z*t15\nb[hip4] = 0.06*s_hip4*t45 + 0.01*s_hip4*c_hip4*(t46 - t47) + 0.01*dot(o).x*dot(o).z*c_hip4^2 + b[knee4] + 0.2*s_hip4*t83\n    - 0.06*c_hip4*t43 - dot(o).x*dot(o).z*t12 - 0.2*c_hip4*t84\nb[knee4] = 0.015*s_hip4_knee4*(t45 + 0.2*c_hip4*t46 - 0.2*dot(o).x*dot(o).z*s_hip4)\n    + 0.002*s_hip4_knee4*c_hip4_knee4*(t70 - t71) + 0.002*dot(o).x*dot(o).z*c_hip4_knee4^2\n    - 0.015*c_hip4_knee4*(t43 + 0.2*s_hip4*t47 - 0.2*dot(o).x*dot(o).z*c_hip4) - dot(o).x*dot(o).z*t16\nQ[hip1] = 0.5*k - k*hip1 - c*dot(hip1) + beat\nQ[knee1] = -(c*dot(knee1) + k + k*knee1)\nQ[hip2] = 0.5*k - k*hip2 - c*dot(hip2) - beat\nQ[knee2] = -(c*dot(knee2) + k + k*knee2)\nQ[hip3] = 0.5*k - k*hip3 - c*dot(hip3) - beat\nQ[knee3] = -(c*dot(knee3) + k + k*knee3)\nQ[hip4] = 0.5*k - k*hip4 - c*dot(hip4) + beat\nQ[knee4] = -(c*dot(knee4) + k + k*knee4)\n\nwhere\nbeat = pull*sin(w*t)\ns_hip1 = sin(hip1)\nc_hip1 = cos(hip1)\ns_hip2 = sin(hip2)\nc_hip2 = cos(hip2)\ns_hip3 = sin(hip3)\nc_hip3 = cos(hip3)\ns_hip4 = sin(hip4)\nc_hip4 = cos(hip4)\ns_hip1_knee1 = sin(hip1 + knee1)\nc_hip1_knee1 = cos(hip1 + knee1)\ns_hip2_knee2 = sin(hip2 + knee2)\nc_hip2_knee2 = cos(hip2 + knee2)\ns_hip3_knee3 = sin(hip3 + knee3)\nc_hip3_knee3 = cos(hip3 + knee3)\ns_hip4_knee4 = sin(hip4 + knee4)\nc_hip4_knee4 = cos(hip4 + knee4)\nw_o.y_hip1 = dot(o).y + dot(hip1)\nw_o.y_hip2 = dot(o).y + dot(hip2)\nw_o.y_hip3 = dot(o).y + dot(hip3)\nw_o.y_hip4 = dot(o).y + dot(hip4)\nt0 = 1 - 2*(o.y^2 + o.z^2)\nt1 = 2*(o.x*o.y - o.z*o.w)\nt2 = 2*(o.x*o.z + o.y*o.w)\nt3 = 2*(o.x*o.y + o.z*o.w)\nt4 = 1 - 2*(o.x^2 + o.z^2)\nt5 = 2*(o.y*o.z - o.x*o.w)\nt6 = o.x*o.z - o.y*o.w\nt7 = o.y*o.z + o.x*o.w\nt8 = 1 - 2*(o.x^2 + o.y^2)\nt9 = 0.01 - 0.01*c_hip1^2\nt10 = 0.01 - 0.01*c_hip2^2\nt11 = 0.01 - 0.01*c_hip3^2\nt12 = 0.01 - 0.01*c_hip4^2\nt13 = 0.002 - 0.002*c_hip1_knee1^2\nt14 = 0.002 - 0.002*c_hip2_knee2^2\nt15 = 0.002 - 0.002*c_hip3_knee3^2\nt16 = 0.002 - 0.002*c_hip4_knee4^2\nt17 = 0.2*(dot(o).y^2 + dot(o).z^2)\nt18 = 0.1*(dot(o).z^2 + dot(o).x^2)\nt19 = 0.2*dot(o).x*dot(o).z + 0.1*dot(o).y*dot(o).z\nt20 = 19.62*t6 + 0.1*dot(o).x*dot(o).y - t17\nt21 = 19.62*t7 + 0.2*dot(o).x*dot(o).y - t18\nt22 = 9.81*t8 + t19\nt23 = dot(o).x^2 + w_o.y_hip1^2\nt24 = dot(o).z^2 + w_o.y_hip1^2\nt25 = dot(o).z*dot(hip1) + dot(o).z*w_o.y_hip1\nt26 = dot(o).x*dot(hip1) + dot(o).x*w_o.y_hip1\nt27 = t17 + 0.1*dot(o).x*dot(o).y\nt28 = 0.2*dot(o).x*dot(o).y + t18\nt29 = 19.62*t6 - t27\nt30 = 19.62*t7 + t28\nt31 = 9.81*t8 + 0.2*dot(o).x*dot(o).z - 0.1*dot(o).y*dot(o).z\nt32 = dot(o).x^2 + w_o.y_hip2^2\nt33 = dot(o).z^2 + w_o.y_hip2^2\nt34 = dot(o).z*dot(hip2) + dot(o).z*w_o.y_hip2\nt35 = dot(o).x*dot(hip2) + dot(o).x*w_o.y_hip2\nt36 = 19.62*t6 + t27\nt37 = 19.62*t7 - t28\nt38 = 9.81*t8 + 0.1*dot(o).y*dot(o).z - 0.2*dot(o).x*dot(o).z\nt39 = dot(o).x^2 + w_o.y_hip3^2\nt40 = dot(o).z^2 + w_o.y_hip3^2\nt41 = dot(o).z*dot(hip3) + dot(o).z*w_o.y_hip3\nt42 = dot(o).x*dot(hip3) + dot(o).x*w_o.y_hip3\nt43 = 19.62*t6 + t17 - 0.1*dot(o).x*dot(o).y\nt44 = 19.62*t7 + t18 - 0.2*dot(o).x*dot(o).y\nt45 = 9.81*t8 - t19\nt46 = dot(o).x^2 + w_o.y_hip4^2\nt47 = dot(o).z^2 + w_o.y_hip4^2\nt48 = dot(o).z*dot(hip4) + dot(o).z*w_o.y_hip4\nt49 = dot(o).x*dot(hip4) + dot(o).x*w_o.y_hip4\nt50 = t21 - 0.2*c_hip1*t25 - 0.2*s_hip1*t26\nt51 = (dot(knee1) + w_o.y_hip1)^2\nt52 = dot(o).x^2 + t51\nt53 = dot(o).z^2 + t51\nt54 = dot(o).z*dot(hip1) + dot(o).z*dot(knee1) + dot(o).z*(dot(knee1) + w_o.y_hip1)\nt55 = dot(o).x*dot(hip1) + dot(o).x*dot(knee1) + dot(o).x*(dot(knee1) + w_o.y_hip1)\nt56 = t30 - 0.2*c_hip2*t34 - 0.2*s_hip2*t35\nt57 = (dot(knee2) + w_o.y_hip2)^2\nt58 = dot(o).x^2 + t57\nt59 = dot(o).z^2 + t57\nt60 = dot(o).z*dot(hip2) + dot(o).z*dot(knee2) + dot(o).z*(dot(knee2) + w_o.y_hip2)\nt61 = dot(o).x*dot(hip2) + dot(o).x*dot(knee2) + dot(o).x*(dot(knee2) + w_o.y_hip2)\nt62 = t37 - 0.2*c_hip3*t41 - 0.2*s_hip3*t42\nt63 = (dot(knee3) + w_o.y_hip3)^2\nt64 = dot(o).x^2 + t63\nt65 = dot(o).z^2 + t63\nt66 = dot(o).z*dot(hip3) + dot(o).z*dot(knee3) + dot(o).z*(dot(knee3) + w_o.y_hip3)\nt67 = dot(o).x*dot(hip3) + dot(o).x*dot(knee3) + dot(o).x*(dot(knee3) + w_o.y_hip3)\nt68 = t44 - 0.2*c_hip4*t48 - 0.2*s_hip4*t49\nt69 = (dot(knee4) + w_o.y_hip4)^2\nt70 = dot(o).x^2 + t69\nt71 = dot(o).z^2 + t69\nt72 = dot(o).z*dot(hip4) + dot(o).z*dot(knee4) + dot(o).z*(dot(knee4) + w_o.y_hip4)\nt73 = dot(o).x*dot(hip4) + dot(o).x*dot(knee4) + dot(o).x*(dot(knee4) + w_o.y_hip4)\nt74 = 0.015*c_hip1_knee1*t52 - 0.015*dot(o).x*dot(o).z*s_hip1_knee1\nt75 = 0.015*s_hip1_knee1*t53 - 0.015*dot(o).x*dot(o).z*c_hip1_knee1\nt76 = 0.015*c_hip1_knee1*t54 + 0.015*s_hip1_knee1*t55\nt77 = 0.015*c_hip2_knee2*t58 - 0.015*dot(o).x*dot(o).z*s_hip2_knee2\nt78 = 0.015*s_hip2_knee2*t59 - 0.015*dot(o).x*dot(o).z*c_hip2_knee2\nt79 = 0.015*c_hip2_knee2*t60 + 0.015*s_hip2_knee2*t61\nt80 = 0.015*c_hip3_knee3*t64 - 0.015*dot(o).x*dot(o).z*s_hip3_knee3\nt81 = 0.015*s_hip3_knee3*t65 - 0.015*dot(o).x*dot(o).z*c_hip3_knee3\nt82 = 0.015*c_hip3_knee3*t66 + 0.015*s_hip3_knee3*t67\nt83 = 0.015*c_hip4_knee4*t70 - 0.015*dot(o).x*dot(o).z*s_hip4_knee4\nt84 = 0.015*s_hip4_knee4*t71 - 0.015*dot(o).x*dot(o).z*c_hip4_knee4\nt85 = 0.015*c_hip4_knee4*t72 + 0.015*s_hip4_knee4*t73\nt86 = 0.06*c_hip4*t46 + t83 - 0.06*dot(o).x*dot(o).z*s_hip4\nt87 = 0.06*s_hip4*t47 + t84 - 0.06*dot(o).x*dot(o).z*c_hip4\nt88 = 0.06*c_hip4*t48 + 0.06*s_hip4*t49 + t85\nt89 = 0.06*c_hip3*t39 + t80 - 0.06*dot(o).x*dot(o).z*s_hip3\nt90 = 0.06*s_hip3*t40 + t81 - 0.06*dot(o).x*dot(o).z*c_hip3\nt91 = 0.06*c_hip3*t41 + 0.06*s_hip3*t42 + t82\nt92 = 0.06*c_hip2*t32 + t77 - 0.06*dot(o).x*dot(o).z*s_hip2\nt93 = 0.06*s_hip2*t33 + t78 - 0.06*dot(o).x*dot(o).z*c_hip2\nt94 = 0.06*c_hip2*t34 + 0.06*s_hip2*t35 + t79\nt95 = 0.06*c_hip1*t23 + t74 - 0.06*dot(o).x*dot(o).z*s_hip1\nt96 = 0.06*s_hip1*t24 + t75 - 0.06*dot(o).x*dot(o).z*c_hip1\nt97 = 0.06*c_hip1*t25 + 0.06*s_hip1*t26 + t76\nt98 = t96 + t93 + t87 + t90\nt99 = t97 + t94 + t88 + t91\nt100 = t95 + t92 + t86 + t89\nt101 = 0.015*c_hip4_knee4 + 0.06*c_hip4\nt102 = 0.015*s_hip4_knee4 + 0.06*s_hip4\nt103 = 0.01*c_hip4^2 + 0.002*c_hip4_knee4^2 + 0.006*c_hip4*c_hip4_knee4\nt104 = t12 + t16 + 0.006*s_hip4*s_hip4_knee4\nt105 = 0.015*c_hip3_knee3 + 0.06*c_hip3\nt106 = 0.015*s_hip3_knee3 + 0.06*s_hip3\nt107 = 0.01*c_hip3^2 + 0.002*c_hip3_knee3^2 + 0.006*c_hip3*c_hip3_knee3\nt108 = t11 + t15 + 0.006*s_hip3*s_hip3_knee3\nt109 = 0.015*c_hip2_knee2 + 0.06*c_hip2\nt110 = 0.015*s_hip2_knee2 + 0.06*s_hip2\nt111 = 0.01*c_hip2^2 + 0.002*c_hip2_knee2^2 + 0.006*c_hip2*c_hip2_knee2\nt112 = t10 + t14 + 0.006*s_hip2*s_hip2_knee2\nt113 = 0.015*c_hip1_knee1 + 0.06*c_hip1\nt114 = 0.015*s_hip1_knee1 + 0.06*s_hip1\nt115 = 0.01*c_hip1^2 + 0.002*c_hip1_knee1^2 + 0.006*c_hip1*c_hip1_knee1\nt116 = t9 + t13 + 0.006*s_hip1*s_hip1_knee1\nt117 = t114 + t110 + t102 + t106\nt118 = t113 + t109 + t101 + t105\nt119 = 256/1875 + t104 + 0.4*t102 + t108 + 0.4*t106 + t112 + t116 - 0.4*t110 - 0.4*t114\nt120 = t115 + t111 + t107 + 4/1875 + t103\nt121 = t119 - 46/1875\nt122 = 46/1875 + t121\n";
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
                t14,
                t16,
                t20,
                t21,
                t25,
                t27,
                t31,
                t32,
                t37,
                t39,
                t40,
                t43,
                t45,
                t49,
                t50,
                t54,
                t56,
                t60,
                t61,
                t67,
                t69,
                t71,
                t72,
                t75,
                t76,
                t78,
                t83,
                t84,
                t85,
                t86,
                t87,
                t88,
                t89,
                t90,
                t91,
                t92,
                t93,
                t94,
                t95,
                t96,
                t97,
                t98,
                t99,
                sin100,
                t102,
                t104,
                t105,
                t106,
                t107,
                t108,
                t109,
                t110,
                t111,
                t113,
                t114,
                t115,
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
                t128,
                t129,
                t130,
                t131,
                t134,
                t135,
                sin136,
                t137,
                t139,
                t140,
                t141,
                t142,
                t143,
                t144,
                t145,
                t146,
                t147,
                t148,
                t150,
                t155,
                t156,
                t158,
                t159,
                t160,
                t161,
                t162,
                t164,
                t165,
                t166,
                t167,
                t168,
                t170,
                t171,
                t172,
                t173,
                t174,
                t175,
                t176,
                t177,
                t178,
                t180,
                t181,
                t182,
                t183,
                t184,
                t185,
                t186,
                t187,
                t189,
                t190,
                t191,
                t192,
                t193,
                t195,
                t197,
                t198,
                t199,
                t201,
                t202,
                t203,
                t204,
                t205,
                t207,
                t208,
                t211,
                t212,
                t214,
                t215,
                t216,
                t217,
                t218,
                t220,
                t221,
                t222,
                t223,
                t224,
                t226,
                t227,
                t228,
                t229,
                t230,
                t231,
                t232,
                t233,
                t234,
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
                t250,
                t252,
                t253,
                t254,
                t255,
                sin_hip4,
                cos_hip4,
                sin_hip2,
                cos_hip2,
            ) = {
                let t0 = T::from_f64(0.5) * qx_o;
                let t1 = T::from_f64(0.5) * qy_o;
                let t2 = T::from_f64(0.5) * qz_o;
                let t3 = -(qdx_o * t0 + qdy_o * t1 + qdz_o * t2);
                let t4 = T::from_f64(0.5) * qw_o;
                let t5 = qdx_o * t4 - qdy_o * t2 + qdz_o * t1;
                let t6 = qdx_o * t2 + qdy_o * t4 - qdz_o * t0;
                let t7 = qdy_o * t0 - qdx_o * t1 + qdz_o * t4;
                let t8 = q_hip4 + q_knee4;
                let t9 = q_hip3 + q_knee3;
                let t10 = q_hip2 + q_knee2;
                let t11 = q_hip1 + q_knee1;
                let t12 = qdx_o * qd_hip4;
                let t13 = qdy_o + qd_hip4;
                let t14 = t12 + qdx_o * t13;
                let t15 = qdz_o * qd_hip4;
                let t16 = t15 + qdz_o * t13;
                let t17 = t13 + qd_knee4;
                let t18 = t13 * t13;
                let t19 = qd_knee4 + t17;
                let t20 = t15 + qdz_o * t19;
                let t21 = t12 + qdx_o * t19;
                let t22 = t17 * t17;
                let t23 = qdx_o * qd_hip3;
                let t24 = qdy_o + qd_hip3;
                let t25 = t23 + qdx_o * t24;
                let t26 = qdz_o * qd_hip3;
                let t27 = t26 + qdz_o * t24;
                let t28 = t24 + qd_knee3;
                let t29 = t24 * t24;
                let t30 = qd_knee3 + t28;
                let t31 = t26 + qdz_o * t30;
                let t32 = t23 + qdx_o * t30;
                let t33 = t28 * t28;
                let t34 = qdx_o * qdx_o;
                let t35 = qdz_o * qdz_o;
                let t36 = T::from_f64(0.1) * (t34 + t35);
                let t37 = qdx_o * qdy_o;
                let t38 = T::from_f64(0.2) * t37;
                let t39 = t36 + t38;
                let t40 = t36 - t38;
                let t41 = qdx_o * qd_hip2;
                let t42 = qdy_o + qd_hip2;
                let t43 = t41 + qdx_o * t42;
                let t44 = qdz_o * qd_hip2;
                let t45 = t44 + qdz_o * t42;
                let t46 = t42 + qd_knee2;
                let t47 = t42 * t42;
                let t48 = qd_knee2 + t46;
                let t49 = t44 + qdz_o * t48;
                let t50 = t41 + qdx_o * t48;
                let t51 = t46 * t46;
                let t52 = qdx_o * qd_hip1;
                let t53 = qdy_o + qd_hip1;
                let t54 = t52 + qdx_o * t53;
                let t55 = qd_hip1 * qdz_o;
                let t56 = t55 + t53 * qdz_o;
                let t57 = t53 + qd_knee1;
                let t58 = t53 * t53;
                let t59 = qd_knee1 + t57;
                let t60 = t55 + qdz_o * t59;
                let t61 = t52 + qdx_o * t59;
                let t62 = t57 * t57;
                let t63 = t34 + t33;
                let t64 = t33 + t35;
                let t65 = t34 + t29;
                let t66 = t29 + t35;
                let t67 = qdx_o * qdz_o;
                let t68 = T::from_f64(0.2) * t67;
                let t69 = qdy_o * qdz_o;
                let t70 = T::from_f64(0.1) * t69;
                let t71 = t68 - t70;
                let t72 = t68 + t70;
                let t73 = T::from_f64(0.2) * (t35 + qdy_o * qdy_o);
                let t74 = T::from_f64(0.1) * t37;
                let t75 = t73 + t74;
                let t76 = t73 - t74;
                let (sin77, _) = (k3 * t).sin_cos();
                let t78 = k2 * sin77;
                let t79 = t34 + t62;
                let t80 = t62 + t35;
                let t81 = t34 + t58;
                let t82 = t58 + t35;
                let t83 = t22 + t35;
                let t84 = t34 + t22;
                let t85 = t18 + t35;
                let t86 = t34 + t18;
                let t87 = t51 + t35;
                let t88 = t47 + t35;
                let t89 = t34 + t51;
                let t90 = t34 + t47;
                let t91 = qy_o * qy_o;
                let t92 = qz_o * qz_o;
                let t93 = qx_o * qz_o;
                let t94 = qy_o * qw_o;
                let t95 = qx_o * qy_o;
                let t96 = qz_o * qw_o;
                let t97 = qx_o * qx_o;
                let t98 = qz_o * qy_o;
                let t99 = qx_o * qw_o;
                let [(sin100, cos100), (sin101, cos101)] = t10.sin_cos_pair(t11);
                let t102 = T::from_f64(0.015) * cos100;
                let t103 = T::from_f64(0.002) * cos100;
                let t104 = cos100 * t103;
                let t105 = sin100 * t103;
                let t106 = T::from_f64(0.002) - t104;
                let t107 = t104 + t106;
                let t108 = T::from_f64(-1.0) / t107;
                let t109 = t108 * t102;
                let t110 = T::from_f64(0.015) * sin100;
                let t111 = T::from_f64(0.015) * cos101;
                let t112 = T::from_f64(0.002) * cos101;
                let t113 = cos101 * t112;
                let t114 = sin101 * t112;
                let t115 = T::from_f64(0.002) - t113;
                let t116 = t113 + t115;
                let t117 = T::from_f64(-1.0) / t116;
                let t118 = t117 * t111;
                let t119 = T::from_f64(0.015) * sin101;
                let t120 = T::from_f64(0.0015) * cos100;
                let t121 = t108 * t120;
                let t122 = T::from_f64(0.0015) * cos101;
                let t123 = t117 * t122;
                let t124 = T::from_f64(0.0015) * sin100;
                let t125 = t108 * t124;
                let t126 = T::from_f64(0.0015) * sin101;
                let t127 = t117 * t126;
                let t128 = t110 * t108;
                let t129 = t119 * t117;
                let t130 = t102 * t49 + t110 * t50;
                let t131 = t111 * t60 + t119 * t61;
                let t132 = t111 * t79 - t119 * t67;
                let t133 = t119 * t80 - t111 * t67;
                let t134 = t110 * t87 - t102 * t67;
                let t135 = t102 * t89 - t110 * t67;
                let [(sin136, cos136), (sin_hip1, cos_hip1)] = t8.sin_cos_pair(q_hip1);
                let t137 = T::from_f64(0.015) * cos136;
                let t138 = T::from_f64(0.002) * cos136;
                let t139 = cos136 * t138;
                let t140 = sin136 * t138;
                let t141 = T::from_f64(0.002) - t139;
                let t142 = t139 + t141;
                let t143 = T::from_f64(-1.0) / t142;
                let t144 = t143 * t137;
                let t145 = T::from_f64(0.015) * sin136;
                let t146 = T::from_f64(0.06) * cos_hip1;
                let t147 = t111 + t146;
                let t148 = T::from_f64(0.2) * cos_hip1;
                let t149 = t148 * t111;
                let t150 = T::from_f64(0.2) * sin_hip1;
                let t151 = t114 * (t79 - t80) + t119 * (t72 + t148 * t81 - t150 * t67);
                let t152 = t151 + t67 * (t113 - t115)
                    - t111 * (t150 * t82 - t76 - t148 * t67);
                let t153 = t119 * t150;
                let t154 = t116 + t149 + t153;
                let t155 = t117 * t154;
                let t156 = t147 + t111 * t155;
                let t157 = T::from_f64(0.01) * cos_hip1;
                let t158 = cos_hip1 * t157;
                let t159 = t113 + t158 + T::from_f64(2.0) * t149;
                let t160 = sin_hip1 * t157;
                let t161 = T::from_f64(0.01) - t158;
                let t162 = t115 + t161 + T::from_f64(2.0) * t153;
                let t163 = t159 + t162;
                let t164 = T::from_f64(-1.0) / (t163 + t154 * t155);
                let t165 = t154 - T::from_f64(0.003) * sin101;
                let t166 = t164 * t156;
                let t167 = T::from_f64(0.0015) * cos136;
                let t168 = t143 * t167;
                let t169 = T::from_f64(0.1) * t147;
                let t170 = t169 + t155 * t122;
                let t171 = t164 * t170;
                let t172 = T::from_f64(0.06) * sin_hip1;
                let t173 = t119 + t172;
                let t174 = t163 + t155 * t165 - T::from_f64(0.2) * t173;
                let t175 = t117 * t165;
                let t176 = t164 * t174;
                let t177 = T::from_f64(0.0015) * sin136;
                let t178 = t143 * t177;
                let t179 = T::from_f64(0.1) * t173;
                let t180 = t179 + t155 * t126;
                let t181 = t164 * t180;
                let t182 = t173 + t119 * t155;
                let t183 = t145 * t143;
                let t184 = t182 * t164;
                let t185 = t137 * t20 + t145 * t21;
                let t186 = t40 + t148 * t56 + t150 * t54;
                let t187 = k1 * qd_knee1 + k0 * (T::from_f64(1.0) + q_knee1) + t152;
                let t188 = t152 + t160 * (t81 - t82) + t172 * t72 + t146 * t76
                    + t150 * t132;
                let t189 = t146 * t81 + t132 - t172 * t67;
                let t190 = t188 + t67 * (t158 - t161) - t148 * t133;
                let t191 = t190 + k1 * qd_hip1 + k0 * (q_hip1 - T::from_f64(0.5))
                    + t155 * t187 - t78;
                let t192 = t145 * t83 - t137 * t67;
                let t193 = t137 * t84 - t145 * t67;
                let [(sin194, cos194), (sin_hip3, cos_hip3)] = t9.sin_cos_pair(q_hip3);
                let t195 = T::from_f64(0.015) * cos194;
                let t196 = T::from_f64(0.002) * cos194;
                let t197 = cos194 * t196;
                let t198 = sin194 * t196;
                let t199 = T::from_f64(0.002) - t197;
                let t200 = t197 + t199;
                let t201 = T::from_f64(-1.0) / t200;
                let t202 = t201 * t195;
                let t203 = T::from_f64(0.06) * cos_hip3;
                let t204 = t195 + t203;
                let t205 = T::from_f64(0.2) * cos_hip3;
                let t206 = t205 * t195;
                let t207 = T::from_f64(0.015) * sin194;
                let t208 = T::from_f64(0.2) * sin_hip3;
                let t209 = t207 * t208;
                let t210 = t200 + t206 + t209;
                let t211 = t201 * t210;
                let t212 = t204 + t195 * t211;
                let t213 = T::from_f64(0.01) * cos_hip3;
                let t214 = cos_hip3 * t213;
                let t215 = t197 + t214 + T::from_f64(2.0) * t206;
                let t216 = sin_hip3 * t213;
                let t217 = T::from_f64(0.01) - t214;
                let t218 = t199 + t217 + T::from_f64(2.0) * t209;
                let t219 = t215 + t218;
                let t220 = T::from_f64(-1.0) / (t219 + t210 * t211);
                let t221 = t210 + T::from_f64(0.003) * sin194;
                let t222 = t220 * t212;
                let t223 = T::from_f64(0.0015) * cos194;
                let t224 = t201 * t223;
                let t225 = T::from_f64(0.1) * t204;
                let t226 = t225 + t211 * t223;
                let t227 = t220 * t226;
                let t228 = T::from_f64(0.06) * sin_hip3;
                let t229 = T::from_f64(0.0015) * sin194;
                let t230 = t207 + t228;
                let t231 = t219 + T::from_f64(0.2) * t230 + t211 * t221;
                let t232 = t225 + t169 + t224 * t221 + t227 * t231 + t123 * t165
                    + t171 * t174;
                let t233 = t201 * t221;
                let t234 = t220 * t231;
                let t235 = T::from_f64(0.1) * t230;
                let t236 = t235 + t211 * t229;
                let t237 = t235 + t179 + t233 * t229 + t234 * t236 + t175 * t126
                    + t176 * t180;
                let t238 = t201 * t229;
                let t239 = t220 * t236;
                let t240 = t230 + t207 * t211;
                let t241 = t207 * t224 + t240 * t227 + t119 * t123 + t182 * t171
                    - t145 * t168;
                let t242 = t207 * t201;
                let t243 = t240 * t220;
                let t244 = t195 * t31 + t207 * t32;
                let t245 = t39 + t205 * t27 + t208 * t25;
                let t246 = t198 * (t63 - t64) + t207 * (t205 * t65 - t71 - t208 * t67);
                let t247 = t246 + t67 * (t197 - t199)
                    - t195 * (t75 + t208 * t66 - t205 * t67);
                let t248 = t195 * t63 - t207 * t67;
                let t249 = t207 * t64 - t195 * t67;
                let t250 = t249 + t228 * t66 - t203 * t67
                    + (t133 + t172 * t82 - t146 * t67);
                let t251 = t247 + t216 * (t65 - t66) + t208 * t248 + t67 * (t214 - t217);
                let t252 = t251 - t228 * t71 - t203 * t75 - t205 * t249;
                let t253 = t203 * t65 + t248 - t228 * t67;
                let t254 = k1 * qd_knee3 + k0 * (T::from_f64(1.0) + q_knee3) + t247;
                let t255 = t78 + k1 * qd_hip3 + k0 * (q_hip3 - T::from_f64(0.5)) + t252
                    + t211 * t254;
                let [(sin_hip4, cos_hip4), (sin_hip2, cos_hip2)] = q_hip4
                    .sin_cos_pair(q_hip2);
                (
                    t3,
                    t5,
                    t6,
                    t7,
                    t14,
                    t16,
                    t20,
                    t21,
                    t25,
                    t27,
                    t31,
                    t32,
                    t37,
                    t39,
                    t40,
                    t43,
                    t45,
                    t49,
                    t50,
                    t54,
                    t56,
                    t60,
                    t61,
                    t67,
                    t69,
                    t71,
                    t72,
                    t75,
                    t76,
                    t78,
                    t83,
                    t84,
                    t85,
                    t86,
                    t87,
                    t88,
                    t89,
                    t90,
                    t91,
                    t92,
                    t93,
                    t94,
                    t95,
                    t96,
                    t97,
                    t98,
                    t99,
                    sin100,
                    t102,
                    t104,
                    t105,
                    t106,
                    t107,
                    t108,
                    t109,
                    t110,
                    t111,
                    t113,
                    t114,
                    t115,
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
                    t128,
                    t129,
                    t130,
                    t131,
                    t134,
                    t135,
                    sin136,
                    t137,
                    t139,
                    t140,
                    t141,
                    t142,
                    t143,
                    t144,
                    t145,
                    t146,
                    t147,
                    t148,
                    t150,
                    t155,
                    t156,
                    t158,
                    t159,
                    t160,
                    t161,
                    t162,
                    t164,
                    t165,
                    t166,
                    t167,
                    t168,
                    t170,
                    t171,
                    t172,
                    t173,
                    t174,
                    t175,
                    t176,
                    t177,
                    t178,
                    t180,
                    t181,
                    t182,
                    t183,
                    t184,
                    t185,
                    t186,
                    t187,
                    t189,
                    t190,
                    t191,
                    t192,
                    t193,
                    t195,
                    t197,
                    t198,
                    t199,
                    t201,
                    t202,
                    t203,
                    t204,
                    t205,
                    t207,
                    t208,
                    t211,
                    t212,
                    t214,
                    t215,
                    t216,
                    t217,
                    t218,
                    t220,
                    t221,
                    t222,
                    t223,
                    t224,
                    t226,
                    t227,
                    t228,
                    t229,
                    t230,
                    t231,
                    t232,
                    t233,
                    t234,
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
                    t250,
                    t252,
                    t253,
                    t254,
                    t255,
                    sin_hip4,
                    cos_hip4,
                    sin_hip2,
                    cos_hip2,
                )
            };
            let (
                t448,
                t449,
                t453,
                t458,
                t459,
                t460,
                t462,
                t463,
                t464,
                t465,
                t467,
                t468,
                t469,
                t471,
            ) = {
                let t256 = T::from_f64(0.06) * cos_hip4;
                let t257 = t137 + t256;
                let t258 = t257 + t204;
                let t259 = T::from_f64(0.2) * cos_hip4;
                let t260 = t259 * t137;
                let t261 = T::from_f64(0.2) * sin_hip4;
                let t262 = t140 * (t84 - t83) + t145 * (t259 * t86 - t261 * t67 - t72);
                let t263 = t262 + t67 * (t139 - t141)
                    - t137 * (t76 + t261 * t85 - t259 * t67);
                let t264 = t145 * t261;
                let t265 = t142 + t260 + t264;
                let t266 = t265 + T::from_f64(0.003) * sin136;
                let t267 = t143 * t265;
                let t268 = t257 + t137 * t267;
                let t269 = T::from_f64(0.1) * t257;
                let t270 = T::from_f64(0.01) * cos_hip4;
                let t271 = cos_hip4 * t270;
                let t272 = t139 + t271 + T::from_f64(2.0) * t260;
                let t273 = sin_hip4 * t270;
                let t274 = T::from_f64(0.01) - t271;
                let t275 = t141 + t274 + T::from_f64(2.0) * t264;
                let t276 = t274 * t14 + t273 * t16 + t261 * t185 + t141 * t21
                    + t140 * t20;
                let t277 = t276 + t217 * t25 + t216 * t27 + t208 * t244 + t199 * t32;
                let t278 = t263 + t273 * (t86 - t85) + t261 * t193 + t67 * (t271 - t274);
                let t279 = k1 * qd_knee4 + k0 * (T::from_f64(1.0) + q_knee4) + t263;
                let t280 = t272 + t275;
                let t281 = T::from_f64(-1.0) / (t280 + t265 * t267);
                let t282 = t281 * t268;
                let t283 = T::from_f64(5.8) + t137 * t144 + t268 * t282 + t195 * t202
                    + t212 * t222;
                let t284 = T::from_f64(0.06) * cos_hip2;
                let t285 = t102 + t284;
                let t286 = t285 + t147;
                let t287 = T::from_f64(0.2) * cos_hip2;
                let t288 = t287 * t102;
                let t289 = T::from_f64(0.2) * sin_hip2;
                let t290 = t105 * (t89 - t87) + t110 * (t71 + t287 * t90 - t289 * t67);
                let t291 = t290 + t67 * (t104 - t106)
                    - t102 * (t289 * t88 - t75 - t287 * t67);
                let t292 = t110 * t289;
                let t293 = t107 + t288 + t292;
                let t294 = t293 - T::from_f64(0.003) * sin100;
                let t295 = t108 * t293;
                let t296 = t285 + t102 * t295;
                let t297 = T::from_f64(0.1) * t285;
                let t298 = T::from_f64(0.01) * cos_hip2;
                let t299 = cos_hip2 * t298;
                let t300 = t104 + t299 + T::from_f64(2.0) * t288;
                let t301 = sin_hip2 * t298;
                let t302 = T::from_f64(0.01) - t299;
                let t303 = t106 + t302 + T::from_f64(2.0) * t292;
                let t304 = t277 + t198 * t31 + t207 * t245 + t302 * t43 + t301 * t45;
                let t305 = t304 + t289 * t130 + t106 * t50 + t105 * t49 + t161 * t54;
                let t306 = t305 + t160 * t56 + t172 * t40 + t150 * t131 + t115 * t61;
                let t307 = t306 + t114 * t60 + t119 * t186 + t224 * t254 + t227 * t255;
                let t308 = t300 + t303;
                let t309 = T::from_f64(-1.0) / (t308 + t293 * t295);
                let t310 = t309 * t296;
                let t311 = t283 + t102 * t109 + t296 * t310 + t111 * t118 + t156 * t166;
                let t312 = t269 + t267 * t167;
                let t313 = t281 * t312;
                let t314 = t297 + t295 * t120;
                let t315 = t309 * t314;
                let t316 = t137 * t168 + t313 * t268 + t102 * t121 + t315 * t296
                    - t195 * t224;
                let t317 = t316 - t227 * t212 - t111 * t123 - t171 * t156;
                let t318 = T::from_f64(0.06) * sin_hip4;
                let t319 = T::from_f64(0.06) * sin_hip2;
                let t320 = t278 - t256 * t76 - t318 * t72 - t259 * t192;
                let t321 = t192 + t318 * t85 - t256 * t67
                    + (t134 + t319 * t88 - t284 * t67);
                let t322 = t291 + t301 * (t90 - t88) + t284 * t75 + t319 * t71
                    + t289 * t135;
                let t323 = t322 + t67 * (t299 - t302) - t287 * t134;
                let t324 = t256 * t86 + t193 - t318 * t67;
                let t325 = t284 * t90 + t135 - t319 * t67;
                let t326 = t284 * t45 + t319 * t43 + t130
                    + (t131 + t146 * t56 + t172 * t54);
                let t327 = k1 * qd_knee2 + k0 * (T::from_f64(1.0) + q_knee2) + t291;
                let t328 = t145 + t318;
                let t329 = t328 + t230;
                let t330 = t280 + T::from_f64(0.2) * t328 + t267 * t266;
                let t331 = t232 - t269 - t297 - t168 * t266 - t313 * t330 - t121 * t294;
                let t332 = t110 + t319;
                let t333 = t332 + t173;
                let t334 = T::from_f64(0.13653333333333334) + t275 + t218 + t303 + t162
                    + T::from_f64(0.4) * (t329 - t333);
                let t335 = T::from_f64(0.024533333333333334) + t334 + t167 * t168
                    + t312 * t313 + t223 * t224 + t226 * t227;
                let t336 = t335 + t120 * t121 + t314 * t315 + t122 * t123 + t170 * t171;
                let t337 = t329 + t333;
                let t338 = T::from_f64(-1.0) / t336;
                let t339 = t308 + t295 * t294 - T::from_f64(0.2) * t332;
                let t340 = t331 - t315 * t339;
                let t341 = t338 * t317;
                let t342 = t338 * t340;
                let t343 = t258 + t286;
                let t344 = t143 * t266;
                let t345 = t281 * t330;
                let t346 = t342 * t317 - t343 - t137 * t344 - t345 * t268 - t195 * t233;
                let t347 = t108 * t294;
                let t348 = t266 * t344 + t330 * t345 + t221 * t233 + t231 * t234
                    + t294 * t347;
                let t349 = t309 * t339;
                let t350 = t348 + t339 * t349 + t165 * t175 + t174 * t176 + t340 * t342;
                let t351 = t346 - t234 * t212 - t102 * t347 - t349 * t296 - t111 * t175;
                let t352 = t351 - t176 * t156;
                let t353 = t334 - T::from_f64(0.024533333333333334);
                let t354 = T::from_f64(0.024533333333333334) + t353;
                let t355 = T::from_f64(0.0021333333333333334) + t272 + t215 + t300 + t159
                    + t354;
                let t356 = T::from_f64(-1.0) / (t350 + t355);
                let t357 = t356 * t352;
                let t358 = T::from_f64(0.1) * t328;
                let t359 = t328 + t145 * t267;
                let t360 = t358 + t267 * t177;
                let t361 = t281 * t360;
                let t362 = t334 + t177 * t178 + t360 * t361 + t229 * t238 + t236 * t239;
                let t363 = t168 * t177 + t313 * t360 + t224 * t229 + t227 * t236
                    + t121 * t124;
                let t364 = T::from_f64(0.1) * t332;
                let t365 = t332 + t110 * t295;
                let t366 = t241 - t359 * t313 - t110 * t121 - t365 * t315;
                let t367 = t364 + t295 * t124;
                let t368 = t363 + t315 * t367 + t123 * t126 + t171 * t180
                    + T::from_f64(0.2) * (t286 - t258);
                let t369 = t368 - t273 - t140 - t145 * t259 - t137 * t261 - t216 - t198;
                let t370 = t369 - t207 * t205 - t195 * t208 - t301 - t105 - t110 * t287;
                let t371 = t370 - t102 * t289 - t160 - t114 - t119 * t148 - t111 * t150;
                let t372 = t237 + t342 * t371 - t358 - t364 - t344 * t177 - t345 * t360;
                let t373 = t372 - t347 * t124 - t349 * t367;
                let t374 = t40 - t259 * t16 - t261 * t14;
                let t375 = t39 - t287 * t45 - t289 * t43;
                let t376 = t309 * t367;
                let t377 = t362 + t124 * t125 + t367 * t376 + t126 * t127 + t180 * t181;
                let t378 = t338 * t371;
                let t379 = t137 * t178 + t361 * t268 + t102 * t125 + t376 * t296
                    + t378 * t317;
                let t380 = t356 * t373;
                let t381 = T::from_f64(-1.0)
                    / (t377 + t371 * t378 + t373 * t380 + t355 - t353 - t354);
                let t382 = t379 + t380 * t352 - t195 * t238 - t239 * t212 - t111 * t127;
                let t383 = t382 - t181 * t156;
                let t384 = t381 * t383;
                let t385 = t366 * t338;
                let t386 = t337 + t145 * t344 + t359 * t345 + t207 * t233 + t240 * t234;
                let t387 = t386 + t110 * t347 + t365 * t349 + t119 * t175 + t182 * t176;
                let t388 = t387 + t366 * t342;
                let t389 = t388 * t356;
                let t390 = t207 * t238 + t240 * t239 + t119 * t127 + t182 * t181
                    + t366 * t378;
                let t391 = t390 + t388 * t380 - t145 * t178 - t359 * t361 - t110 * t125;
                let t392 = t391 - t365 * t376;
                let t393 = t392 * t381;
                let t394 = t359 * t281;
                let t395 = T::from_f64(5.8) + t145 * t183 + t359 * t394 + t207 * t242
                    + t240 * t243;
                let t396 = t385 * t317 + t389 * t352 + t393 * t383 - t183 * t137
                    - t394 * t268;
                let t397 = t256 * t40 + t137 * t374 + t102 * t375 + t238 * t254
                    + t239 * t255;
                let t398 = t256 * t16 + t318 * t14 + t185
                    + (t203 * t27 + t228 * t25 + t244);
                let t399 = t307 + t123 * t187 + t171 * t191
                    + T::from_f64(0.2) * (t398 - t326)
                    + T::from_f64(0.1) * (t321 - t250);
                let t400 = t399 + T::from_f64(0.112) * t37 + t39 * (t228 - t319)
                    - t318 * t40 - t145 * t374;
                let t401 = t365 * t309;
                let t402 = t396 - t242 * t195 - t243 * t212 - t128 * t102 - t401 * t296;
                let t403 = t395 + t110 * t128 + t365 * t401 + t119 * t129 + t182 * t184;
                let t404 = T::from_f64(-1.0)
                    / (t403 + t366 * t385 + t388 * t389 + t392 * t393);
                let t405 = t402 - t129 * t111 - t184 * t156;
                let t406 = t404 * t405;
                let t407 = t311 + t317 * t341 + t352 * t357 + t383 * t384 + t405 * t406;
                let t408 = t337 * t342;
                let t409 = t343 - t337 * t378 - t380 * t408;
                let t410 = t381 * t409;
                let t411 = t393 * t409 - t385 * t337 - t389 * t408;
                let t412 = t404 * t411;
                let t413 = t338 * t337;
                let t414 = t356 * t408;
                let t415 = t383 * t410 + t405 * t412 - t317 * t413 - t352 * t414;
                let t416 = T::from_f64(5.8) + t337 * t413 + t408 * t414 + t409 * t410
                    + t411 * t412;
                let t417 = T::from_f64(-1.0) / t416;
                let t418 = t415 * t417;
                let t419 = t320 + k1 * qd_hip4 + k0 * (q_hip4 - T::from_f64(0.5))
                    + t267 * t279 - t78;
                let t420 = t400 - t110 * t375 - t168 * t279 - t313 * t419 - t121 * t327;
                let t421 = t320 + t252 + t323 + t190 + t344 * t279 + t345 * t419
                    + t233 * t254;
                let t422 = t78 + k1 * qd_hip2 + k0 * (q_hip2 - T::from_f64(0.5)) + t323
                    + t295 * t327;
                let t423 = t420 - t315 * t422;
                let t424 = t421 + t234 * t255 + t347 * t327 + t349 * t422 + t175 * t187;
                let t425 = t324 + t253;
                let t426 = t189 + t325;
                let t427 = t424 + t176 * t191 + t342 * t423
                    + T::from_f64(0.2) * (t425 - t426) + T::from_f64(-0.1344) * t67;
                let t428 = t397 + t127 * t187 + t181 * t191 + t378 * t423 + t380 * t427;
                let t429 = t428 + T::from_f64(0.1) * (t189 + t253 - t325 - t324)
                    + T::from_f64(0.0224) * t69 + t39 * (t284 - t203);
                let t430 = t429 - t271 * t16 - t273 * t14 - t139 * t20 - t140 * t21;
                let t431 = t430 - t259 * t185 - t214 * t27 - t216 * t25 - t205 * t244;
                let t432 = t431 - t197 * t31 - t198 * t32 - t195 * t245 - t299 * t45;
                let t433 = t432 - t301 * t43 - t104 * t49 - t105 * t50 - t287 * t130;
                let t434 = t433 - t146 * t40 - t158 * t56 - t160 * t54 - t111 * t186;
                let t435 = t434 - t113 * t60 - t114 * t61 - t148 * t131 - t178 * t279;
                let t436 = t435 - t361 * t419 - t125 * t327 - t376 * t422;
                let t437 = t183 * t279 + t394 * t419 + t242 * t254 + t243 * t255
                    + t128 * t327;
                let t438 = t437 + t401 * t422 + t129 * t187 + t184 * t191 + t385 * t423;
                let t439 = t438 + t389 * t427 + t393 * t436 + t426 + t425;
                let t440 = t436 * t410 + t439 * t412 - t423 * t413 - t427 * t414 - t398;
                let t441 = t440 - t326;
                let t442 = t423 * t341 + t427 * t357 + t436 * t384 + t439 * t406
                    + t418 * t441;
                let t443 = t442 + t321 + t250 - t279 * t144 - t419 * t282 - t254 * t202;
                let t444 = t443 - t255 * t222 - t327 * t109 - t422 * t310 - t187 * t118;
                let t445 = T::from_f64(-1.0) / (t407 + t415 * t418)
                    * (t444 - t191 * t166);
                let t446 = t417 * t441 + t418 * t445;
                let t447 = t404 * t439 + t406 * t445 + t412 * t446;
                let t448 = t381 * t436 + t384 * t445 + t410 * t446 + t393 * t447;
                let t449 = t356 * t427 + t357 * t445 + t389 * t447 + t380 * t448
                    - t414 * t446;
                let t450 = t338 * t423 + t341 * t445 + t385 * t447 + t378 * t448
                    + t342 * t449;
                let t451 = t309 * t422 + t401 * t447 + t349 * t449 - t310 * t445
                    - t376 * t448;
                let t452 = t281 * t419 + t394 * t447 + t345 * t449 - t282 * t445
                    - t361 * t448;
                let t453 = t450 - t413 * t446;
                let t454 = t164 * t191 + t184 * t447 + t181 * t448 + t176 * t449
                    + t171 * t453;
                let t455 = t117 * t187 + t129 * t447 + t127 * t448 + t175 * t449
                    + t123 * t453;
                let t456 = t220 * t255 + t243 * t447 + t239 * t448 + t234 * t449
                    + t227 * t453;
                let t457 = t201 * t254 + t242 * t447 + t238 * t448 + t233 * t449
                    + t224 * t453;
                let t458 = t454 - t166 * t445;
                let t459 = t455 + t155 * t458 - t118 * t445;
                let t460 = t451 - t315 * t453;
                let t461 = t108 * t327 + t128 * t447 + t347 * t449 + t295 * t460
                    - t109 * t445;
                let t462 = t461 - t125 * t448 - t121 * t453;
                let t463 = t456 - t222 * t445;
                let t464 = t457 + t211 * t463 - t202 * t445;
                let t465 = t452 - t313 * t453;
                let t466 = t143 * t279 + t183 * t447 + t344 * t449 + t267 * t465
                    - t144 * t445;
                let t467 = t466 - t178 * t448 - t168 * t453;
                let t468 = t445 * (T::from_f64(1.0) - T::from_f64(2.0) * (t91 + t92))
                    + T::from_f64(2.0) * ((t93 + t94) * t447 + t446 * (t95 - t96));
                let t469 = t446 * (T::from_f64(1.0) - T::from_f64(2.0) * (t92 + t97))
                    + T::from_f64(2.0) * (t447 * (t98 - t99) + t445 * (t95 + t96));
                let t470 = t447 * (T::from_f64(1.0) - T::from_f64(2.0) * (t91 + t97))
                    + T::from_f64(2.0) * (t445 * (t93 - t94) + t446 * (t98 + t99));
                let t471 = t470 - T::from_f64(9.81);
                (
                    t448,
                    t449,
                    t453,
                    t458,
                    t459,
                    t460,
                    t462,
                    t463,
                    t464,
                    t465,
                    t467,
                    t468,
                    t469,
                    t471,
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
                t468,
                t469,
                t471,
                t448,
                t449,
                t453,
                t458,
                t459,
                t460,
                t462,
                t463,
                t464,
                t465,
                t467,
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
            let t1 = qx_o * qx_o;
            let t2 = qy_o * qy_o;
            let t3 = T::from_f64(1.0) - T::from_f64(2.0) * (t1 + t2);
            let t4 = qx_o * qz_o;
            let t5 = qy_o * qw_o;
            let t6 = T::from_f64(2.0) * (t4 + t5);
            let t7 = T::from_f64(2.0) * (t4 - t5);
            let t8 = qy_o * qz_o;
            let t9 = qx_o * qw_o;
            let t10 = T::from_f64(2.0) * (t8 - t9);
            let t11 = T::from_f64(2.0) * (t8 + t9);
            let t12 = qdz_p * t3 + qdx_p * t6 + qdy_p * t10;
            let t13 = T::from_f64(0.2) * qdy_o;
            let t14 = T::from_f64(0.1) * qdx_o;
            let t15 = t13 - t14;
            let t16 = t13 + t14;
            let t17 = t12 + t15;
            let t18 = t12 - t15;
            let t19 = qdy_o + qd_hip4;
            let t20 = qd_knee4 + t19;
            let t21 = qz_o * qz_o;
            let t22 = T::from_f64(1.0) - T::from_f64(2.0) * (t2 + t21);
            let t23 = T::from_f64(1.0) - T::from_f64(2.0) * (t1 + t21);
            let t24 = qx_o * qy_o;
            let t25 = qz_o * qw_o;
            let t26 = T::from_f64(2.0) * (t24 + t25);
            let t27 = T::from_f64(2.0) * (t24 - t25);
            let t28 = qdz_p * t7 + qdx_p * t22 + qdy_p * t26;
            let t29 = T::from_f64(0.1) * qdz_o;
            let t30 = t28 + t29;
            let t31 = t28 - t29;
            let t32 = q_hip3 + q_knee3;
            let t33 = t12 + t16;
            let t34 = t12 - t16;
            let t35 = qdy_o + qd_hip3;
            let t36 = qd_knee3 + t35;
            let t37 = q_hip2 + q_knee2;
            let t38 = q_hip1 + q_knee1;
            let t39 = qdy_o + qd_hip2;
            let t40 = qd_knee2 + t39;
            let t41 = qdy_o + qd_hip1;
            let t42 = qd_knee1 + t41;
            let t43 = qdz_p * t11 + qdx_p * t27 + qdy_p * t23;
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
            let t75 = t56 * (t18 + t73 * t41) + t42 * (t58 + t59)
                - t60 * (t31 - t41 * t74);
            let t76 = T::from_f64(0.06) * sin_hip1;
            let t77 = T::from_f64(0.01) * cos_hip1;
            let t78 = cos_hip1 * t77;
            let t79 = T::from_f64(0.01) - t78;
            let t80 = t75 + t18 * t76 + t74 * t61 + t73 * t62 + t41 * (t78 + t79);
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
            let t94 = t87 * (t33 + t88 * t35) + t36 * (t90 + t91)
                - t92 * (t31 - t35 * t93);
            let t95 = T::from_f64(0.06) * sin_hip3;
            let t96 = t92 * t36;
            let t97 = t87 * t36;
            let t98 = T::from_f64(0.01) * cos_hip3;
            let t99 = cos_hip3 * t98;
            let t100 = T::from_f64(0.01) - t99;
            let t101 = t94 + t33 * t95 + t93 * t96 + t88 * t97 + t35 * (t99 + t100);
            let t102 = t97 + t35 * t95;
            let t103 = T::from_f64(0.06) * cos_hip3;
            let t104 = t96 + t35 * t103 + (t61 + t41 * t82);
            let t105 = t101 - t31 * t103;
            let t106 = qdx_o * t92 - qdz_o * t87;
            let t107 = t45 + qdx_o * t93 - qdz_o * t88;
            let [(sin_hip4, cos_hip4), (sin_hip2, cos_hip2)] = q_hip4
                .sin_cos_pair(q_hip2);
            let t108 = T::from_f64(0.2) * sin_hip4;
            let t109 = T::from_f64(0.2) * cos_hip4;
            let t110 = t66 * (t17 + t108 * t19) + t20 * (t68 + t69)
                - t70 * (t30 - t19 * t109);
            let t111 = T::from_f64(0.06) * sin_hip4;
            let t112 = T::from_f64(0.01) * cos_hip4;
            let t113 = cos_hip4 * t112;
            let t114 = T::from_f64(0.01) - t113;
            let t115 = t110 + t17 * t111 + t109 * t71 + t108 * t72 + t19 * (t113 + t114);
            let t116 = t72 + t19 * t111;
            let t117 = T::from_f64(0.06) * cos_hip4;
            let t118 = t115 - t30 * t117;
            let t119 = T::from_f64(0.2) * sin_hip2;
            let t120 = T::from_f64(0.2) * cos_hip2;
            let t121 = t49 * (t34 + t119 * t39) + t40 * (t51 + t52)
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
            let t130 = t71 + t19 * t117 + (t54 + t39 * t129);
            let t131 = T::from_f64(0.01) - t127;
            let t132 = T::from_f64(0.16106666666666666) + t69 + t114 + t91 + t100 + t52
                + t131 + t59 + t79;
            let t133 = t121 + t34 * t123 + t120 * t54 + t119 * t55 + t39 * (t127 + t131);
            let t134 = t133 - t30 * t129;
            let t135 = t55 + t39 * t123;
            let t136 = t63 + qdx_o * t129 - qdz_o * t123
                + (t64 + qdx_o * t82 - qdz_o * t76);
            let t137 = t84 + qdx_o * t117 - qdz_o * t111
                + (t106 + qdx_o * t103 - qdz_o * t95);
            let t138 = t45 + qdx_o * t109 - t108 * qdz_o;
            let t139 = qdz_o * t132 + T::from_f64(0.2) * (t136 - t137)
                + T::from_f64(0.1) * (t104 - t130) - t66 * t138;
            let t140 = t137 + t136;
            let t141 = t130 + t104;
            let t142 = t46 + qdx_o * t120 - qdz_o * t119;
            let t143 = t70 * t138 + t109 * t84 + t92 * t107 + t93 * t106 + t53 * t142;
            let t144 = t139 - t108 * t84 - t87 * t107 - t88 * t106 - t49 * t142;
            let t145 = t143 + t120 * t63 + t60 * t85 + t74 * t64 + qdx_o * t128;
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
                * (T::from_f64(5.8) * qdz_p + t11 * t140 + t3 * t153 - t7 * t141);
            let t155 = qdx_p
                * (T::from_f64(5.8) * qdx_p + t27 * t140 + t6 * t153 - t22 * t141);
            let t156 = qdy_p
                * (T::from_f64(5.8) * qdy_p + t23 * t140 + t10 * t153 - t26 * t141);
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
