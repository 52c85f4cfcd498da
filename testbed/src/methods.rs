//! Integration methods with their expected properties, for tests that cover all of them.

/// Expected properties of a method, and step sizes of the large swing at which they show.
#[derive(Clone, Copy, Debug)]
pub struct Promise {
    pub name: &'static str,
    /// Order of convergence at the steps.
    pub order: f64,
    /// Order of convergence of the dense output between the steps.
    pub dense: f64,
    /// Step size, in s.
    pub h: f64,
    /// Step size for a test of the dense output in a single step, in s.
    pub one: f64,
}

/// Calls a function, generic in the family, for each adaptive method that has lanes.
#[macro_export]
macro_rules! each_in_lanes {
    ($check:ident) => {
        $crate::each!(
            $check: pendulum_core::method::Explicit<pendulum_core::tableau::DormandPrince5, 7>,
            "Rk45", 5.0, 4.0, 0.02, 0.04
        );
        $crate::each!(
            $check: pendulum_core::method::Explicit<pendulum_core::tableau::Tsitouras5, 7>,
            "Tsit5", 5.0, 4.0, 0.02, 0.04
        );
        $crate::each!(
            $check: pendulum_core::method::Explicit<pendulum_core::tableau::Verner7, 11>,
            "Vern7", 7.0, 7.0, 0.05, 0.06
        );
        $crate::each!(
            $check: pendulum_core::method::Explicit<pendulum_core::tableau::Verner9, 17>,
            "Vern9", 9.0, 9.0, 0.08, 0.2
        );
        $crate::each!($check: pendulum_core::method::PowerSeries, "Taylor", 20.0, 20.0, 0.1, 0.4);
    };
}

/// Like `each_in_lanes`, but for each adaptive method.
#[macro_export]
macro_rules! each_adaptive {
    ($check:ident) => {
        $crate::each_in_lanes!($check);
        $crate::each!(
            $check: pendulum_core::method::Rosenbrock<pendulum_core::tableau::HairerWanner4, 6>,
            "Rodas4", 4.0, 3.0, 0.01, 0.02
        );
        $crate::each!(
            $check: pendulum_core::method::Rosenbrock<pendulum_core::tableau::Steinebach5, 8>,
            "Rodas5P", 5.0, 4.0, 0.02, 0.03
        );
        $crate::each!($check: pendulum_core::method::RadauIIA, "Radau5", 5.0, 3.0, 0.04, 0.06);
        $crate::each!($check: pendulum_core::method::RadauIIA<5, 2>, "Radau9", 9.0, 5.0, 0.06, 0.2);
        $crate::each!($check: pendulum_core::method::RadauIIA<7, 3>, "Radau13", 13.0, 7.0, 0.12, 0.4);
        $crate::each!($check: pendulum_core::method::Switching, "Auto", 9.0, 9.0, 0.08, 0.2);
    };
}

/// Like `each_in_lanes`, but for each method without an error estimate.
#[macro_export]
macro_rules! each_without_estimate {
    ($check:ident) => {
        $crate::each!(
            $check: pendulum_core::method::Explicit<pendulum_core::tableau::Kutta4, 5>,
            "Rk4", 4.0, 3.0, 0.01, 0.02
        );
        $crate::each!($check: pendulum_core::method::Gauss<2>, "Gauss4", 4.0, 3.0, 0.02, 0.04);
        $crate::each!($check: pendulum_core::method::Gauss<3>, "Gauss6", 6.0, 5.0, 0.04, 0.1);
        $crate::each!($check: pendulum_core::method::Gauss<8, 4>, "Gauss16", 16.0, 8.0, 0.25, 0.4);
    };
}

#[macro_export]
macro_rules! each {
    ($check:ident: $family:ty, $name:literal, $order:literal, $dense:literal, $h:literal, $one:literal) => {
        $check::<$family>(&$crate::methods::Promise {
            name: $name,
            order: $order,
            dense: $dense,
            h: $h,
            one: $one,
        });
    };
}
