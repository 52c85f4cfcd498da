//! The cases, one after another.

pub mod chaos;
pub mod coulomb;
pub mod edges;
pub mod energy;
pub mod events;
pub mod friction;
pub mod limits;
pub mod mass;
pub mod rounding;
pub mod row;
pub mod scenes;

use row::{Row, Size};

/// Passes all cases to a macro: a name and a function of each.
#[macro_export]
macro_rules! each_case {
    ($hand:ident) => {
        $hand! {
                limits_on_the_real_axis: $crate::where_methods_fail::limits::real_axis,
                limits_on_the_imaginary_axis: $crate::where_methods_fail::limits::imaginary_axis,
                steps_far_too_long: $crate::where_methods_fail::limits::infinity,
                friction_with_fixed_steps: $crate::where_methods_fail::friction::critical,
                friction_with_adaptive_steps: $crate::where_methods_fail::friction::steps,
                stiffness_that_is_noticed: $crate::where_methods_fail::friction::detection,
                lyapunov_exponents: $crate::where_methods_fail::chaos::exponents,
                horizon_of_prediction: $crate::where_methods_fail::chaos::horizons,
                nearly_no_mass: $crate::where_methods_fail::mass::light,
                no_mass: $crate::where_methods_fail::mass::none,
                energy_of_runge_kutta: $crate::where_methods_fail::energy::runge_kutta,
                energy_of_gauss: $crate::where_methods_fail::energy::gauss,
                rounding_errors_of_the_energy: $crate::where_methods_fail::rounding::random_walk,
                energy_over_many_swings: $crate::where_methods_fail::rounding::many_swings,
                coulomb_friction_as_a_sign: $crate::where_methods_fail::coulomb::sign,
                coulomb_friction_smoothed: $crate::where_methods_fail::coulomb::smooth,
                coulomb_friction_that_sticks: $crate::where_methods_fail::coulomb::events,
                coulomb_friction_smoothed_against_stuck: $crate::where_methods_fail::coulomb::smoothed_against_stuck,
                grazing_events: $crate::where_methods_fail::events::grazing,
                rebounds_that_accumulate: $crate::where_methods_fail::events::rebounds,
                upright: $crate::where_methods_fail::edges::upright,
                forth_and_back_in_time: $crate::where_methods_fail::edges::back_in_time,
                resolution_of_numbers: $crate::where_methods_fail::edges::resolution,
                right_hand_sides_that_are_not_finite: $crate::where_methods_fail::edges::not_finite,
        }
    };
}

macro_rules! functions {
    ($($name:ident: $case:path),* $(,)?) => {
        /// All cases.
        pub const ALL: &[fn(Size) -> Row] = &[$($case),*];
    };
}

each_case!(functions);
