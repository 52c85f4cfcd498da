//! The methods, as tests that hold for all of them want them.

/// What a kind of method promises, and a step of the large swing that is long enough to show it.
#[derive(Clone, Copy, Debug)]
#[allow(
    dead_code,
    unreachable_pub,
    reason = "each test is a crate of its own and uses a part of this"
)]
pub struct Promise {
    pub name: &'static str,
    /// The power of the step with which errors fall at the points.
    pub order: f64,
    /// The same of the states between the points.
    pub dense: f64,
    /// The length of the step, in s.
    pub h: f64,
    /// That of a single step, for the states within it.
    pub one: f64,
}

/// Calls a function, generic in the family, for each that keeps a tolerance and has lanes.
macro_rules! each_in_lanes {
    ($check:ident) => {
        each!($check: Explicit<tableau::DormandPrince5, 7>, "Rk45", 5.0, 4.0, 0.02, 0.04);
        each!($check: Explicit<tableau::Tsitouras5, 7>, "Tsit5", 5.0, 4.0, 0.02, 0.04);
        each!($check: Explicit<tableau::Verner7, 11>, "Vern7", 7.0, 7.0, 0.05, 0.06);
        each!($check: Explicit<tableau::Verner9, 17>, "Vern9", 9.0, 9.0, 0.08, 0.2);
        each!($check: PowerSeries, "Taylor", 20.0, 20.0, 0.1, 0.4);
    };
}

/// The same for each that keeps a tolerance.
macro_rules! each_adaptive {
    ($check:ident) => {
        each_in_lanes!($check);
        each!($check: Rosenbrock<tableau::HairerWanner4, 6>, "Rodas4", 4.0, 3.0, 0.01, 0.02);
        each!($check: Rosenbrock<tableau::Steinebach5, 8>, "Rodas5P", 5.0, 4.0, 0.02, 0.03);
        each!($check: RadauIIA, "Radau5", 5.0, 3.0, 0.04, 0.06);
        each!($check: Switching, "Auto", 9.0, 9.0, 0.08, 0.2);
    };
}

/// The same for those that do not.
macro_rules! each_without_estimate {
    ($check:ident) => {
        each!($check: Explicit<tableau::Kutta4, 5>, "Rk4", 4.0, 3.0, 0.01, 0.02);
        each!($check: Gauss<2>, "Gauss4", 4.0, 3.0, 0.02, 0.04);
        each!($check: Gauss<3>, "Gauss6", 6.0, 5.0, 0.04, 0.1);
    };
}

macro_rules! each {
    ($check:ident: $family:ty, $name:literal, $order:literal, $dense:literal, $h:literal, $one:literal) => {
        $check::<$family>(&Promise {
            name: $name,
            order: $order,
            dense: $dense,
            h: $h,
            one: $one,
        });
    };
}
