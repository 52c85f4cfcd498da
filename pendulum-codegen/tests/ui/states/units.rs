// Rates whose unit is not the unit of the state per second.
mechanism! {
    pub Wrong {
        params { u: V = 2, r: ohm = 1, l: V s/A = 0.1, tau: s = 1 }
        state i { unit: A, rate: u - r*i }
        state v { unit: m/s, rate: -v }
        state angle { unit: deg, rate: -angle/tau }
        state x { unit: foo, rate: -x/tau }
        output sum: i + v,
        output power: l*i^2/tau,
    }
}
mechanism! {
    pub Filter {
        state x { unit: 1, rate: -x/s }
        output y: x*m,
    }
}
