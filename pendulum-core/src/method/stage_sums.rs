//! Sums over the stages of numbers with derivatives. Values and derivatives are summed alike, as one array of numbers
//! that fills the vector registers.

use nalgebra::SVector;

use crate::dual::Dual;
use crate::real::lanes::{Lanes, WideKernel};

/// Maximum number of registers with sums. AVX2 has 16; weights and numbers of a stage take others.
const MOST: usize = 12;

/// Computes `start + sum_i (h weights_i) stages_i`, skipping zero weights; without a `start`, the sum.
pub(crate) struct StageSums<'a, T, const N: usize, const M: usize> {
    /// Without derivatives.
    pub(crate) h: T,
    pub(crate) weights: &'a [f64],
    pub(crate) stages: &'a [SVector<Dual<T, N>, M>],
    pub(crate) start: Option<&'a SVector<Dual<T, N>, M>>,
    pub(crate) sums: &'a mut SVector<Dual<T, N>, M>,
}

impl<T: Lanes<Scalar = T>, const N: usize, const M: usize> StageSums<'_, T, N, M> {
    /// Computes the sums that fill whole registers `V`: of all numbers in the `FIRST` pass, else of those that
    /// registers `Wider` have left. Blocks have the same length, so the last one may overlap with the one before.
    #[inline(always)]
    fn pass<V: Lanes<Scalar = T>, Wider: Lanes, const FIRST: bool>(&mut self) {
        /// Number of the first sum, and number of registers.
        const fn place<V: Lanes, Wider: Lanes>(all: usize, is_first: bool) -> (usize, usize) {
            let rest = if is_first { all } else { all % Wider::LANES };
            (all - rest, rest / V::LANES)
        }
        const fn length_of_blocks(registers: usize) -> usize {
            let blocks = registers.div_ceil(MOST);
            if blocks == 0 { 0 } else { registers.div_ceil(blocks) }
        }
        let (start, registers) = const { place::<V, Wider>(M * (N + 1), FIRST) };
        macro_rules! in_blocks_of {
            ($($length:literal)*) => { $(
                if const { length_of_blocks(place::<V, Wider>(M * (N + 1), FIRST).1) == $length } {
                    let mut done = 0;
                    while done < registers {
                        let first = done.min(registers - $length);
                        self.block::<V, $length>(start + first * V::LANES);
                        done = first + $length;
                    }
                }
            )* };
        }
        in_blocks_of!(1 2 3 4 5 6 7 8 9 10 11 12);
    }

    /// Computes the sums that fill `R` registers from the number `at` on.
    #[inline(always)]
    fn block<V: Lanes<Scalar = T>, const R: usize>(&mut self, at: usize) {
        let load = |numbers: &SVector<Dual<T, N>, M>, r: usize| {
            let numbers = &Dual::flat(&numbers.data.0[0])[at + r * V::LANES..][..V::LANES];
            V::from_fn(|lane| numbers[lane])
        };
        let terms = self.weights.iter().zip(self.stages);
        let terms = terms.filter(|(weight, _)| **weight != 0.0);
        let mut terms = terms.map(|(&weight, stage)| (V::splat(T::from_f64(weight).scaled(self.h)), stage));
        let mut sums = [V::default(); R];
        if let Some((weight, stage)) = terms.next() {
            for (r, sum) in sums.iter_mut().enumerate() {
                *sum = load(stage, r).scaled(weight);
            }
        }
        for (weight, stage) in terms {
            for (r, sum) in sums.iter_mut().enumerate() {
                *sum = load(stage, r).scaled_onto(weight, *sum);
            }
        }
        if let Some(start) = self.start {
            for (r, sum) in sums.iter_mut().enumerate() {
                *sum = load(start, r) + *sum;
            }
        }
        let places = &mut Dual::flat_mut(&mut self.sums.data.0[0])[at..][..R * V::LANES];
        for (sum, places) in sums.iter().zip(places.chunks_exact_mut(V::LANES)) {
            places
                .iter_mut()
                .enumerate()
                .for_each(|(lane, place)| *place = sum.lane(lane));
        }
    }
}

impl<T, const N: usize, const M: usize> WideKernel<T> for StageSums<'_, T, N, M> {
    #[inline(always)]
    fn run<V, Narrow>(mut self)
    where
        T: Lanes<Scalar = T>,
        V: Lanes<Scalar = T>,
        Narrow: Lanes<Scalar = T>,
    {
        self.pass::<V, V, true>();
        self.pass::<Narrow, V, false>();
        self.pass::<T, Narrow, false>();
    }
}
