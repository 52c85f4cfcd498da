//! One step of an explicit Runge-Kutta method, whatever its tableau.

use nalgebra::SVector;

use crate::real::Real;
use crate::system::System;
use crate::tableau::Tableau;

/// The most stages that [`attempt`] spells out.
const MAX_STAGES: usize = 20;

/// The right-hand side of a system with no more states than this, two bodies, takes few operations, and most of them wait for one
/// another.
pub(crate) const SHORT: usize = 4;

/// Evaluates the stages of a step from `(t, x)` to `t_new` and returns the state there.
///
/// `stages[0]` is the derivative at the start, given; the others are filled, the last with the derivative at the end.
///
/// The stages are spelled out up to `MAX_STAGES`, since compilers do not unroll a loop over calls of the right-hand side:
/// so each sees its row of the tableau as constants, and zero coefficients vanish.
#[inline(always)]
pub(crate) fn attempt<B, S, T, const STAGES: usize, const N: usize>(
    system: &S,
    (t, x): (T, &SVector<T, N>),
    t_new: T,
    stages: &mut [SVector<T, N>; STAGES],
) -> SVector<T, N>
where
    B: Tableau<STAGES>,
    S: System<T, N> + ?Sized,
    T: Real,
{
    const {
        assert!(STAGES >= 2 && STAGES <= MAX_STAGES);
        assert!(
            B::TABLEAU.ends_in_the_next_first_stage(),
            "add the derivative at the end of the step as a last stage of weight 0"
        );
    }
    let h = t_new - t;
    let mut x_new = *x;
    macro_rules! stages {
        ($($i:literal)*) => { $(
            if $i < STAGES {
                let row = const { &Row::of::<B>($i) };
                let change = weighted_sum::<T, STAGES, N>(h, &row.a, $i, stages);
                for (component, x_new) in x_new.data.0[0].iter_mut().enumerate() {
                    *x_new = x.data.0[0][component] + change.data.0[0][component];
                }
                // Not t + h, which may differ in the last bit.
                let time = if row.c == 1.0 { t_new } else { t + h * T::from_f64(row.c) };
                stages[$i] = system.rhs(time, &x_new);
            }
        )* };
    }
    stages!(1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19);
    x_new
}

/// `sum_(i < count) (h weights_i) stages_i`, passing over zero weights.
///
/// The products `h weights_i` are formed first: once, where the components would each want one, and off the path from a stage to
/// the next. The components are spelled out, since arithmetic of whole vectors is functions, which compilers need not inline: in lanes
/// they must.
#[inline(always)]
pub(super) fn weighted_sum<T: Real, const STAGES: usize, const N: usize>(
    h: T,
    weights: &[f64; STAGES],
    count: usize,
    stages: &[SVector<T, N>; STAGES],
) -> SVector<T, N> {
    let mut sums = [T::default(); N];
    let mut is_first = true;
    for i in 0..count {
        if weights[i] == 0.0 {
            continue;
        }
        let weight = h * T::from_f64(weights[i]);
        for (component, sum) in sums.iter_mut().enumerate() {
            let term = weight * stages[i].data.0[0][component];
            *sum = if is_first { term } else { *sum + term };
        }
        is_first = false;
    }
    SVector::from(sums)
}

/// One row of a tableau.
struct Row<const STAGES: usize> {
    a: [f64; STAGES],
    c: f64,
}

impl<const STAGES: usize> Row<STAGES> {
    /// Row `i`; a row of zeros beyond the last, where the compiler asks in code that is never reached.
    const fn of<B: Tableau<STAGES>>(i: usize) -> Self {
        if i < STAGES {
            Self {
                a: B::TABLEAU.a[i],
                c: B::TABLEAU.c[i],
            }
        } else {
            Self {
                a: [0.0; STAGES],
                c: 0.0,
            }
        }
    }
}
