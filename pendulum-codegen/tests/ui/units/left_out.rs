mechanism! {
    pub Rest {
        units: none,
        params { epsilon rubbish = 1, mass 2 }
        input push N,
        state x { rate: push*mass - x/epsilon }
    }
}
mechanism! {
    pub WithUnits {
        params { epsilon = 1 s }
        input push,
        state x { rate: push - x/epsilon }
    }
}
