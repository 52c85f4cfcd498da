// The rate of a state has no name of its own.
mechanism! {
    pub Rate {
        params { r: ohm = 1, l: V s/A = 0.1, u: V = 2 }
        state i { unit: A, rate: (u - r*i)/l }
        output voltage: l*dot(i),
        output change: dot(i^2),
    }
}
