mechanism! {
    pub Cart {
        params { g: kg = 1, s: s = 1, k: N/m = 2 }
        body cart on ground { mass: 250 g, joint: prismatic(x), coordinate: m, torque: 3 N/m*q - k*m/(1 m/s)*s/s }
    }
}
