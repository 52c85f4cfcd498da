// Fields of a state that are missing, wrong or given twice.
mechanism! {
    pub Missing {
        state a { unit: 1 }
        state b { rate: -b }
        state c {}
        state d { unit: 1, value: 3, rate: -d }
        state e { unit: 1, derivative: -e }
        state f { unit: 1, unit: m, rate: -f*1 s^-1 }
    }
}

mechanism! {
    pub NoBraces {
        state a: 1,
        body b on ground { mass: 1, joint: prismatic(x), coordinate: x }
    }
}
