//! Closed loops: assembly of initial states, and gaps.

use nalgebra::SVector;

use crate::error::{LoopGap, Name, NotAssembled};
use crate::layout::{SlotKind, StateLayout};
use crate::real::Float;
use crate::system::System;

/// Maximum number of Newton corrections.
const MOST: usize = 100;

/// Maximum correction, in rad or m. Longer ones could switch to another assembly mode.
const LONGEST: f64 = 0.3;

/// Largest gap of a closed loop, in rounding units of its size or of 1 rad: 9e-13 in `f64`, 5e-4 in `f32`.
const CLOSED: f64 = 4096.0;

/// Increase of the largest gap per radian of the largest angle, in rounding units, since the angle itself is rounded.
const TURNED: f64 = 4.0;

/// Maximum number of repeated projections of an initial state with open loops. The convergence is quadratic.
const AGAIN: usize = 2;

/// Receives the gaps of loops, as in [`System::gaps`].
type Tell<'a, T> = dyn FnMut([&str; 2], [T; 3]) + 'a;

/// Closes the loops of the state `x` by Newton's method. `corrections` are added to the components at `places`; `gaps`
/// reports the remaining gaps.
pub fn assemble<T: Float, const N: usize, const M: usize>(
    mut x: SVector<T, N>,
    layout: StateLayout<'_>,
    places: [usize; M],
    corrections: impl Fn(&SVector<T, N>) -> SVector<T, M>,
    gaps: impl Fn(&SVector<T, N>, &mut Tell<'_, T>),
) -> Result<SVector<T, N>, NotAssembled> {
    let longest = T::from_f64(LONGEST);
    // the convergence is quadratic, so the next correction is of the size of rounding errors
    let least = T::EPSILON.sqrt();
    let mut left = 0.0;
    let mut open = None;
    for _ in 0..MOST {
        let correction = corrections(&x);
        let size = correction.iter().fold(T::default(), |size, x| size.max(x.abs()));
        if !correction.iter().all(|x| x.is_finite()) {
            return Err(NotAssembled { left: f64::NAN, open });
        }
        let share = if size > longest {
            longest / size
        } else {
            T::from_f64(1.0)
        };
        for (&place, &correction) in places.iter().zip(correction.iter()) {
            x[place] += share * correction;
        }
        left = size.to_f64();
        open = worst(Some(layout), &x, |tell| gaps(&x, tell));
        // corrections also vanish at a minimum of the gap of a loop that cannot close
        if size < least && open.is_none() {
            return Ok(x);
        }
    }
    Err(NotAssembled { left, open })
}

/// Projects an initial state until its loops are closed, if possible.
pub(crate) fn close<S, T, const N: usize>(system: &S, t: T, x: &mut SVector<T, N>)
where
    S: System<T, N> + ?Sized,
    T: Float,
{
    system.project(t, x);
    for _ in 0..AGAIN {
        if open(system, t, x).is_some() {
            system.project(t, x);
        }
    }
}

/// Returns the open loop with the largest gap relative to its tolerance, if any loop is open.
pub(crate) fn open<S, T, const N: usize>(system: &S, t: T, x: &SVector<T, N>) -> Option<LoopGap>
where
    S: System<T, N> + ?Sized,
    T: Float,
{
    worst(system.layout(), x, |tell| system.gaps(t, x, tell))
}

fn worst<T: Float, const N: usize>(
    layout: Option<StateLayout<'_>>,
    x: &SVector<T, N>,
    gaps: impl FnOnce(&mut Tell<'_, T>),
) -> Option<LoopGap> {
    let rounding = || {
        let slots = layout.into_iter().flat_map(|layout| layout.slots);
        let angles = slots.filter(|slot| slot.kind == SlotKind::Angle);
        let sizes = angles
            .flat_map(|slot| slot.positions.clone())
            .map(|n| x[n].abs().to_f64());
        T::EPSILON.to_f64() * (CLOSED + TURNED * sizes.fold(0.0, f64::max))
    };
    let (mut found, mut most) = (None, 1.0);
    // most mechanisms have no loops
    gaps(&mut |bodies, gap| {
        let [distance, angle, size] = gap.map(T::to_f64);
        let rounding = rounding();
        // prefer the distance, which is easier to interpret than the angle
        let measures = [(distance, rounding * size, "m"), (angle, rounding, "rad")];
        let open = measures.into_iter().find(|(by, allowed, _)| by > allowed);
        if let Some((by, allowed, unit)) = open
            && by > most * allowed
        {
            (found, most) = (
                Some(LoopGap {
                    bodies: bodies.map(Name::from),
                    by,
                    unit,
                }),
                by / allowed,
            );
        }
    });
    found
}
