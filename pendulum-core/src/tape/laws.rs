//! Inputs that follow samples.

use std::sync::Arc;

use super::code::Code;
use super::source::Source;
use crate::dual::Dual;
use crate::inputs::TimeTable;
use crate::real::Real;
use crate::real::lanes::Routine;

/// Laws of some inputs of a model.
#[derive(Debug)]
pub(super) struct Laws {
    /// Inputs, in ascending order.
    pub(super) inputs: Vec<usize>,
    /// Samples of each: of one lane after the other, or of all lanes at once.
    tables: Vec<TimeTable<1>>,
}

impl Laws {
    /// Laws of the inputs of these indices; `None` without any.
    pub(super) fn new(mut laws: Vec<(usize, TimeTable<1>)>) -> Option<Arc<Self>> {
        laws.sort_by_key(|&(input, _)| input);
        let (inputs, tables) = laws.into_iter().unzip();
        Some(Self { inputs, tables })
            .filter(|laws| !laws.inputs.is_empty())
            .map(Arc::new)
    }

    /// Combines the laws of one model per lane, which are of the same inputs.
    pub(super) fn gather<'m>(lanes: usize, of: impl Fn(usize) -> Option<&'m Arc<Self>>) -> Option<Arc<Self>> {
        let first = of(0)?;
        if (1..lanes).all(|lane| of(lane).is_some_and(|own| Arc::ptr_eq(own, first))) {
            return Some(first.clone());
        }
        Some(Arc::new(Self {
            inputs: first.inputs.clone(),
            tables: (0..lanes)
                .filter_map(of)
                .flat_map(|own| own.tables.iter().cloned())
                .collect(),
        }))
    }

    /// Each input with its samples, in a single lane.
    pub(super) fn each(&self) -> impl ExactSizeIterator<Item = (usize, &TimeTable<1>)> {
        self.inputs.iter().copied().zip(&self.tables)
    }

    /// Value of the `n`th input that has a law.
    #[inline(always)]
    fn value<T: Real>(&self, n: usize, t: T) -> T {
        let count = self.inputs.len();
        TimeTable::by_lane(t, |lane| self.tables.get(n + lane * count).unwrap_or(&self.tables[n]))
    }

    /// Rates of the inputs that have laws.
    pub(super) fn rates<T: Real>(&self, t: T) -> impl Iterator<Item = (usize, T)> {
        let rate = move |n| self.value(n, Dual::<T, 1>::variable(t, 0)).slopes[0];
        self.inputs.iter().enumerate().map(move |(n, &input)| (input, rate(n)))
    }
}

/// Laws at a time.
pub(super) struct At<'a, T> {
    pub(super) laws: &'a Laws,
    pub(super) t: T,
}

/// Sets the registers into which a code reads the inputs.
impl<T: Real> Routine<[T], Code> for At<'_, T> {
    type Output = ();

    #[inline(always)]
    fn run(self, registers: &mut [T], code: &Code) {
        for read in code.reads.iter().filter(|read| read.source == Source::Input) {
            for (n, &input) in self.laws.inputs.iter().enumerate() {
                let place = input.checked_sub(read.first);
                if let Some(register) = place.and_then(|place| registers[read.registers.clone()].get_mut(place)) {
                    *register = self.laws.value(n, self.t);
                }
            }
        }
    }
}
