//! Operations on registers, and the loop that runs them.

use super::source::{Lists, Source};
use crate::real::Real;
use crate::real::lanes::Routine;

/// Maximum number of registers of a code: those that a [`Register`] can number.
pub(super) const MOST_REGISTERS: usize = 1 << 16;
/// Maximum number of bytes of registers on the stack.
const MOST_ON_STACK: usize = 1 << 17;

/// Number of a register.
pub(super) type Register = u16;

macro_rules! rows {
    ($($kind:ident $name:literal $registers:literal,)*) => {
        /// Operations of one kind, one after the other: for each, the registers of its results, then those of its
        /// operands.
        #[derive(Clone, Debug, PartialEq, Eq)]
        pub(super) enum Row {
            $($kind(Vec<[Register; $registers]>),)*
        }

        impl Row {
            /// Row of a single operation with this name and these registers; `None` if there is none.
            pub(super) fn new(name: &str, registers: &[Register]) -> Option<Self> {
                match name {
                    $($name => Some(Self::$kind(vec![registers.try_into().ok()?])),)*
                    _ => None,
                }
            }

            /// Adds the operations of another row, if it is of the same kind.
            pub(super) fn append(&mut self, other: Self) -> Result<(), Self> {
                match (self, other) {
                    $((Self::$kind(own), Self::$kind(others)) => own.extend(others),)*
                    (_, other) => return Err(other),
                }
                Ok(())
            }

            /// Number of operations.
            pub(super) fn len(&self) -> usize {
                match self {
                    $(Self::$kind(row) => row.len(),)*
                }
            }
        }
    };
}

rows! {
    Add "add" 3,
    Sub "sub" 3,
    Mul "mul" 3,
    Div "div" 3,
    Neg "neg" 2,
    MulAdd "mul_add" 4,
    MulSub "mul_sub" 4,
    MulNegAdd "mul_neg_add" 4,
    SinCos "sin_cos" 3,
    SinCosPair "sin_cos_pair" 6,
    Tan "tan" 2,
    Exp "exp" 2,
    Ln "ln" 2,
    Sqrt "sqrt" 2,
    Tanh "tanh" 2,
    Abs "abs" 2,
    Signum "signum" 2,
    AtLeast "at_least" 3,
    AtMost "at_most" 3,
    Atan2 "atan2" 3,
    Powf "powf" 3,
}

/// Straight-line code: reads variables into registers, runs operations, returns registers.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Code {
    /// Number of registers; all others are below it.
    pub(super) registers: usize,
    /// Constants of the model and their registers.
    pub(super) constants: Vec<(Register, usize)>,
    /// Variables: their register, their list, and their index in it.
    pub(super) reads: Vec<(Register, Source, usize)>,
    /// Numbers and their registers.
    pub(super) numbers: Vec<(Register, f64)>,
    pub(super) rows: Vec<Row>,
    pub(super) results: Vec<Register>,
}

impl Code {
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

    /// Runs the code on the constants of the model and the values of variables. `results` may be fewer than there are.
    #[inline(always)]
    pub(super) fn run<T: Real>(&self, constants: &[T], lists: &Lists<'_, T>, results: &mut [T]) {
        self.on_registers(constants, lists, results);
    }

    /// Like [`run`](Self::run), but passes each result on, with its number.
    #[inline(always)]
    pub(super) fn each<T: Real>(&self, constants: &[T], lists: &Lists<'_, T>, pass: &mut dyn FnMut(usize, T)) {
        self.on_registers(constants, lists, pass);
    }

    /// Runs the code on as few registers as suffice: on the stack, or on the heap if they are too many for it.
    #[inline(always)]
    fn on_registers<T: Real, A: ?Sized>(&self, constants: &[T], lists: &Lists<'_, T>, into: &mut A)
    where
        for<'r> Run<'r, T>: Routine<A, Self>,
    {
        if self.registers > 1024 || self.registers * size_of::<T>() > MOST_ON_STACK {
            let registers = &mut vec![T::default(); self.registers];
            let run = Run {
                registers,
                constants,
                lists,
            };
            T::call(run, into, self);
            return;
        }
        let on = match self.registers {
            0..=16 => on::<T, A, 16>,
            17..=24 => on::<T, A, 24>,
            25..=32 => on::<T, A, 32>,
            33..=48 => on::<T, A, 48>,
            49..=64 => on::<T, A, 64>,
            65..=96 => on::<T, A, 96>,
            97..=128 => on::<T, A, 128>,
            129..=192 => on::<T, A, 192>,
            193..=256 => on::<T, A, 256>,
            257..=512 => on::<T, A, 512>,
            _ => on::<T, A, 1024>,
        };
        on(self, constants, lists, into);
    }
}

/// Runs a code on `R` registers, in memory of their own: a single function for all lengths would touch the memory of
/// the longest at each call.
#[inline(never)]
fn on<T: Real, A: ?Sized, const R: usize>(code: &Code, constants: &[T], lists: &Lists<'_, T>, into: &mut A)
where
    for<'r> Run<'r, T>: Routine<A, Code>,
{
    let registers = &mut [T::default(); R];
    let run = Run {
        registers,
        constants,
        lists,
    };
    T::call(run, into, code);
}

/// What a code runs on.
struct Run<'a, T> {
    registers: &'a mut [T],
    constants: &'a [T],
    lists: &'a Lists<'a, T>,
}

impl<T: Real> Routine<[T], Code> for Run<'_, T> {
    type Output = ();

    #[inline(always)]
    fn run(self, results: &mut [T], code: &Code) {
        let registers = self.run(code);
        for (result, &place) in results.iter_mut().zip(&code.results) {
            *result = registers[usize::from(place)];
        }
    }
}

impl<'p, T: Real> Routine<dyn FnMut(usize, T) + 'p, Code> for Run<'_, T> {
    type Output = ();

    #[inline(always)]
    fn run(self, pass: &mut (dyn FnMut(usize, T) + 'p), code: &Code) {
        let registers = self.run(code);
        for (n, &place) in code.results.iter().enumerate() {
            pass(n, registers[usize::from(place)]);
        }
    }
}

impl<'a, T: Real> Run<'a, T> {
    /// Sets the registers, runs the operations on them, and returns them.
    #[inline(always)]
    fn run(self, code: &Code) -> &'a [T] {
        let registers = &mut self.registers[..code.registers];
        for &(register, number) in &code.numbers {
            registers[usize::from(register)] = T::from_f64(number);
        }
        for &(register, index) in &code.constants {
            registers[usize::from(register)] = self.constants[index];
        }
        for &(register, source, index) in &code.reads {
            registers[usize::from(register)] = self.lists.of(source)[index];
        }
        run(&code.rows, registers);
        registers
    }
}

/// Runs operations, one after the other.
#[inline(always)]
fn run<T: Real>(rows: &[Row], registers: &mut [T]) {
    macro_rules! at {
        ($register:expr) => {
            registers[usize::from($register)]
        };
    }
    for row in rows {
        match row {
            Row::Add(row) => {
                for &[to, a, b] in row {
                    at!(to) = at!(a) + at!(b)
                }
            }
            Row::Sub(row) => {
                for &[to, a, b] in row {
                    at!(to) = at!(a) - at!(b)
                }
            }
            Row::Mul(row) => {
                for &[to, a, b] in row {
                    at!(to) = at!(a) * at!(b)
                }
            }
            Row::Div(row) => {
                for &[to, a, b] in row {
                    at!(to) = at!(a) / at!(b)
                }
            }
            Row::Neg(row) => {
                for &[to, a] in row {
                    at!(to) = -at!(a)
                }
            }
            Row::MulAdd(row) => {
                for &[to, a, b, c] in row {
                    at!(to) = T::mul_add(at!(a), at!(b), at!(c))
                }
            }
            Row::MulSub(row) => {
                for &[to, a, b, c] in row {
                    at!(to) = T::mul_sub(at!(a), at!(b), at!(c))
                }
            }
            Row::MulNegAdd(row) => {
                for &[to, a, b, c] in row {
                    at!(to) = T::mul_neg_add(at!(a), at!(b), at!(c))
                }
            }
            Row::SinCos(row) => {
                for &[sine, cosine, angle] in row {
                    (at!(sine), at!(cosine)) = T::sin_cos(at!(angle))
                }
            }
            Row::SinCosPair(row) => {
                for &[sine, cosine, other_sine, other_cosine, angle, other] in row {
                    [(at!(sine), at!(cosine)), (at!(other_sine), at!(other_cosine))] =
                        T::sin_cos_pair(at!(angle), at!(other));
                }
            }
            Row::Tan(row) => {
                for &[to, a] in row {
                    at!(to) = T::tan(at!(a))
                }
            }
            Row::Exp(row) => {
                for &[to, a] in row {
                    at!(to) = T::exp(at!(a))
                }
            }
            Row::Ln(row) => {
                for &[to, a] in row {
                    at!(to) = T::ln(at!(a))
                }
            }
            Row::Sqrt(row) => {
                for &[to, a] in row {
                    at!(to) = T::sqrt(at!(a))
                }
            }
            Row::Tanh(row) => {
                for &[to, a] in row {
                    at!(to) = T::tanh(at!(a))
                }
            }
            Row::Abs(row) => {
                for &[to, a] in row {
                    at!(to) = T::abs(at!(a))
                }
            }
            Row::Signum(row) => {
                for &[to, a] in row {
                    at!(to) = T::signum(at!(a))
                }
            }
            Row::AtLeast(row) => {
                for &[to, a, b] in row {
                    at!(to) = T::at_least(at!(a), at!(b))
                }
            }
            Row::AtMost(row) => {
                for &[to, a, b] in row {
                    at!(to) = T::at_most(at!(a), at!(b))
                }
            }
            Row::Atan2(row) => {
                for &[to, a, b] in row {
                    at!(to) = T::atan2(at!(a), at!(b))
                }
            }
            Row::Powf(row) => {
                for &[to, a, b] in row {
                    at!(to) = T::powf(at!(a), at!(b))
                }
            }
        }
    }
}
