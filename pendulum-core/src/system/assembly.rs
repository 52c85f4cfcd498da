//! States of closed loops to start from.

use nalgebra::SVector;

use crate::error::NotAssembled;
use crate::real::Float;

/// How often a guess is corrected.
const MOST: usize = 100;

/// The longest correction, in rad or m: beyond, Newton's method would leave the assembly that is meant.
const LONGEST: f64 = 0.3;

/// The state near `x` from which nothing is left to be corrected at some `places`, by the corrections of Newton's method.
pub fn assemble<T: Float, const N: usize, const M: usize>(
    mut x: SVector<T, N>,
    places: [usize; M],
    corrections: impl Fn(&SVector<T, N>) -> SVector<T, M>,
) -> Result<SVector<T, N>, NotAssembled> {
    let longest = T::from_f64(LONGEST);
    // corrections are squared from one to the next, so the next one is rounding
    let least = T::EPSILON.sqrt();
    let mut size = T::default();
    for _ in 0..MOST {
        let correction = corrections(&x);
        size = correction.iter().fold(T::default(), |size, x| size.max(x.abs()));
        if !correction.iter().all(|x| x.is_finite()) {
            return Err(NotAssembled { left: f64::NAN });
        }
        let share = if size > longest {
            longest / size
        } else {
            T::from_f64(1.0)
        };
        for (&place, &correction) in places.iter().zip(correction.iter()) {
            x[place] += share * correction;
        }
        if size < least {
            return Ok(x);
        }
    }
    Err(NotAssembled { left: size.to_f64() })
}
