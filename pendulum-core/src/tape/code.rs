//! Straight-line code, and the loop that runs it.

use std::collections::BTreeSet;
use std::ops::Range;
use std::sync::{Mutex, MutexGuard};

use super::chain::{Chain, Operations};
use super::laws::At;
use super::row::{Register, Row};
use super::source::{Lists, Source};
use crate::real::Real;
use crate::real::lanes::Routine;

/// Maximum number of bytes of registers on the stack.
const MOST_ON_STACK: usize = 1 << 17;

/// Variables that follow one another in a list, and are read into registers that do so, too.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Read {
    pub(super) registers: Range<usize>,
    pub(super) source: Source,
    /// Index of the first one in its list.
    pub(super) first: usize,
}

/// Straight-line code: reads variables into registers, runs operations, returns registers.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Code {
    /// Number of registers; all others are below it.
    pub(super) registers: usize,
    /// Constants of the model and their registers.
    pub(super) constants: Vec<(Register, usize)>,
    pub(super) reads: Vec<Read>,
    /// Numbers and their registers.
    pub(super) numbers: Vec<(Register, f64)>,
    pub(super) rows: Vec<Row>,
    pub(super) results: Vec<Register>,
    /// The operations as lanes run them, if not in rows.
    pub(super) chain: Option<Chain>,
}

impl Code {
    /// Code whose operations lanes run in chains.
    pub(super) fn chained(mut self) -> Self {
        self.chain = Chain::new(&Operations {
            registers: self.registers,
            rows: &self.rows,
            numbers: &self.numbers,
            results: &self.results,
            given: self.given(),
        });
        self
    }

    /// Adds a variable that is read.
    pub(super) fn read(&mut self, register: usize, source: Source, index: usize) {
        match self.reads.last_mut() {
            Some(last)
                if last.source == source
                    && last.registers.end == register
                    && last.first + last.registers.len() == index =>
            {
                last.registers.end += 1;
            }
            _ => self.reads.push(Read {
                registers: register..register + 1,
                source,
                first: index,
            }),
        }
    }

    /// Adds operations at the end.
    pub(super) fn push(&mut self, row: Row) {
        let rest = match self.rows.last_mut() {
            Some(last) => last.append(row).err(),
            None => Some(row),
        };
        self.rows.extend(rest);
    }

    /// Number of operations.
    pub(super) fn len(&self) -> usize {
        self.rows.iter().map(Row::len).sum()
    }

    /// Checks that a second run on the same registers has the results of the first.
    ///
    /// # Errors
    /// If it may have others: the reason.
    pub(super) fn check(&self) -> Result<(), &'static str> {
        let kept: BTreeSet<Register> = self.kept().collect();
        let mut set = self.given();
        for (results, operands) in self.rows.iter().flat_map(Row::registers) {
            if operands.iter().any(|operand| !set.contains(operand)) {
                return Err("an operation reads a register before anything is written to it");
            }
            if results.iter().any(|result| kept.contains(result)) {
                return Err("an operation writes to the register of a constant or of a number");
            }
            set.extend(results);
        }
        match self.results.iter().all(|result| set.contains(result)) {
            true => Ok(()),
            false => Err("a result is a register that nothing is written to"),
        }
    }

    /// Registers of numbers and constants.
    fn kept(&self) -> impl Iterator<Item = Register> {
        let numbers = self.numbers.iter().map(|&(register, _)| register);
        numbers.chain(self.constants.iter().map(|&(register, _)| register))
    }

    /// Registers of numbers, constants and variables, which are set before the operations run.
    pub(super) fn given(&self) -> BTreeSet<Register> {
        let reads = self.reads.iter().flat_map(|read| read.registers.clone());
        self.kept().chain(reads.map(|register| register as Register)).collect()
    }

    /// The operations in chains, for numbers that run them so.
    #[inline(always)]
    fn chain<T: Real>(&self) -> Option<&Chain> {
        if const { T::LANES > 1 } {
            self.chain.as_ref()
        } else {
            None
        }
    }

    /// Number of registers that a run of the code takes.
    #[inline(always)]
    fn room<T: Real>(&self) -> usize {
        self.chain::<T>().map_or(self.registers, |chain| chain.registers)
    }

    /// Registers of the results.
    #[inline(always)]
    fn places<T: Real>(&self) -> &[Register] {
        self.chain::<T>().map_or(&self.results, |chain| &chain.results)
    }

    /// Runs the code on the constants of the model and the values of variables, and fills one slice after the other
    /// with its results; there may be room for fewer.
    #[inline(always)]
    pub(super) fn run<T: Real>(&self, constants: &[T], lists: &Lists<'_, T>, results: &mut [&mut [T]]) {
        self.on_registers(|registers| self.interpret(registers, Some(constants), lists, results));
    }

    /// Like [`run`](Self::run), but passes each result on, with its number.
    #[inline(always)]
    pub(super) fn each<T: Real>(&self, constants: &[T], lists: &Lists<'_, T>, pass: &mut dyn FnMut(usize, T)) {
        self.on_registers(|registers| {
            self.interpret(registers, Some(constants), lists, &mut []);
            self.pass(registers, pass);
        });
    }

    /// Like [`run`](Self::run), on registers that earlier runs on the same constants have set, or that are empty.
    #[inline(always)]
    pub(super) fn run_again<T: Real>(
        &self,
        registers: &mut Vec<T>,
        constants: &[T],
        lists: &Lists<'_, T>,
        results: &mut [&mut [T]],
    ) {
        let mut unset = None;
        if registers.is_empty() {
            registers.resize(self.room::<T>(), T::default());
            unset = Some(constants);
        }
        self.interpret(registers, unset, lists, results);
    }

    /// Passes each result in the registers on, with its number.
    pub(super) fn pass<T: Real>(&self, registers: &[T], pass: &mut dyn FnMut(usize, T)) {
        for (n, &place) in self.places::<T>().iter().enumerate() {
            pass(n, registers[usize::from(place)]);
        }
    }

    /// Lends registers to a function: on the stack, or on the heap if they are too many for it.
    #[inline(always)]
    fn on_registers<T: Real>(&self, function: impl FnOnce(&mut [T])) {
        let registers = self.room::<T>();
        if registers > 1024 || registers * size_of::<T>() > MOST_ON_STACK {
            return function(&mut vec![T::default(); registers]);
        }
        let on = match registers {
            0..=16 => on::<T, _, 16>,
            17..=24 => on::<T, _, 24>,
            25..=32 => on::<T, _, 32>,
            33..=48 => on::<T, _, 48>,
            49..=64 => on::<T, _, 64>,
            65..=96 => on::<T, _, 96>,
            97..=128 => on::<T, _, 128>,
            129..=192 => on::<T, _, 192>,
            193..=256 => on::<T, _, 256>,
            257..=512 => on::<T, _, 512>,
            _ => on::<T, _, 1024>,
        };
        on(registers, function);
    }

    /// Runs the code on these registers, after the constants are set, if any.
    #[inline(always)]
    fn interpret<T: Real>(
        &self,
        registers: &mut [T],
        constants: Option<&[T]>,
        lists: &Lists<'_, T>,
        results: &mut [&mut [T]],
    ) {
        let run = Run {
            registers,
            constants,
            lists,
        };
        T::call(run, results, self);
    }
}

/// Lends the first ones of `R` registers, in memory of their own: a single function for all lengths would touch the
/// memory of the longest at each call.
#[inline(never)]
fn on<T: Real, F: FnOnce(&mut [T]), const R: usize>(count: usize, function: F) {
    function(&mut [T::default(); R][..count]);
}

/// Registers of the routines of a model in lanes, which keep constants and numbers: to set them takes as long as the
/// operations. Each thread has models in lanes of its own, so the locks are free, but for a function that receives
/// results and evaluates the same routine again: that run has registers of its own.
#[derive(Debug)]
pub(super) struct Kept<T>(Box<[Mutex<Vec<T>>]>);

impl<T> Kept<T> {
    pub(super) fn of(routines: usize) -> Self {
        Self((0..routines).map(|_| Mutex::default()).collect())
    }

    /// Registers of a routine, unless a run of it has them.
    #[inline(always)]
    pub(super) fn registers(&self, routine: usize) -> Option<MutexGuard<'_, Vec<T>>> {
        self.0.get(routine)?.try_lock().ok()
    }
}

impl<T> Clone for Kept<T> {
    fn clone(&self) -> Self {
        Self::of(self.0.len())
    }
}

/// Registers and values of variables on which a code runs.
struct Run<'a, T> {
    registers: &'a mut [T],
    /// Constants of the model, unless they are in the registers.
    constants: Option<&'a [T]>,
    lists: &'a Lists<'a, T>,
}

impl<'s, T: Real> Routine<[&'s mut [T]], Code> for Run<'_, T> {
    type Output = ();

    #[inline(always)]
    fn run(self, results: &mut [&'s mut [T]], code: &Code) {
        let registers = self.run(code);
        let mut places = code.places::<T>().iter();
        for results in results {
            for (result, &place) in results.iter_mut().zip(&mut places) {
                *result = registers[usize::from(place)];
            }
        }
    }
}

impl<'a, T: Real> Run<'a, T> {
    /// Sets the registers, runs the operations on them, and returns them.
    #[inline(always)]
    fn run(self, code: &Code) -> &'a [T] {
        let registers = self.registers;
        if let Some(constants) = self.constants {
            let numbers = code.chain::<T>().map_or(&code.numbers, |chain| &chain.in_registers);
            for &(register, number) in numbers {
                registers[usize::from(register)] = T::from_f64(number);
            }
            for &(register, index) in &code.constants {
                registers[usize::from(register)] = constants[index];
            }
        }
        for read in &code.reads {
            let to = &mut registers[read.registers.clone()];
            let from = &self.lists.of(read.source)[read.first..][..to.len()];
            to.copy_from_slice(from);
        }
        if let Some((laws, &t)) = self.lists.laws() {
            T::call(At { laws, t }, registers, code);
        }
        match code.chain::<T>() {
            Some(chain) => chain.run(registers),
            None => {
                for row in &code.rows {
                    row.run(registers);
                }
            }
        }
        registers
    }
}
