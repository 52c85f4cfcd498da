mechanism! {
    pub Numbers {
        params {
            m: kg = 25 cm, l: m = 250 g, k: N m = 3 N/m, a: rad = 90, b: rad = 450 deg,
            c: kg = 2*3 m, f: Hz = 3 rpm + 1 s
        }
        body arm on ground {
            mass: 2 m, com: [0, -2 l, 0], joint: revolute(z) rpy [0, 0, 90], coordinate: q1,
            spring: (k, 45), torque: k*sin(30) + 2 N/m*q + 5 Nm - f*0,
        }
        body leg on arm {
            mass: 1 kg*m, com: [0, 1 l, 0], joint: revolute(z), coordinate: m2, friction: 0.1 N m, torque: a*b
        }
        body toe on leg { mass: 3 bars, joint: revolute(z), motion: 10 + 1 m^x*t }
    }
}
