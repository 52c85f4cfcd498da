//! The cases, one after the other.

pub(crate) mod chaos;
mod coulomb;
mod edges;
pub(crate) mod energy;
mod events;
pub(crate) mod friction;
mod limits;
mod mass;
mod rounding;
pub(crate) mod row;
pub(crate) mod scenes;

use row::{Row, Size};

/// Lists the rows, and tests each.
macro_rules! rows {
    ($($name:ident: $row:path),* $(,)?) => {
        /// All cases.
        pub(crate) const ALL: &[fn(Size) -> Row] = &[$($row),*];

        #[cfg(test)]
        mod holds {
            use super::*;

            $(#[test]
            fn $name() {
                let row = $row(Size::of_build());
                assert!(row.holds(), "{row:#?}");
            })*
        }
    };
}

rows! {
    limits_on_the_real_axis: limits::real_axis,
    limits_on_the_imaginary_axis: limits::imaginary_axis,
    steps_far_too_long: limits::infinity,
    friction_with_fixed_steps: friction::critical,
    friction_with_adaptive_steps: friction::steps,
    stiffness_that_is_noticed: friction::detection,
    lyapunov_exponents: chaos::exponents,
    horizon_of_prediction: chaos::horizons,
    nearly_no_mass: mass::light,
    no_mass: mass::none,
    energy_of_runge_kutta: energy::runge_kutta,
    energy_of_gauss: energy::gauss,
    rounding_errors_of_the_energy: rounding::random_walk,
    coulomb_friction_as_a_sign: coulomb::sign,
    coulomb_friction_smoothed: coulomb::smooth,
    coulomb_friction_with_events: coulomb::events,
    grazing_events: events::grazing,
    rebounds_that_accumulate: events::rebounds,
    upright: edges::upright,
    forth_and_back_in_time: edges::back_in_time,
    resolution_of_numbers: edges::resolution,
    right_hand_sides_that_are_not_finite: edges::not_finite,
}
