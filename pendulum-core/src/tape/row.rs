//! Operations on registers, in rows of one kind.

use crate::real::Real;

/// Maximum number of registers of a code, as a [`Register`] can number.
pub(super) const MOST_REGISTERS: usize = 1 << 16;
/// Number of a register.
pub(super) type Register = u16;

/// Defines all kinds of operations: name in a tape, registers of the results and of the operands, and the results as a
/// function of the operands in the number type `T`.
macro_rules! operations {
    ($T:ident: $($kind:ident $name:literal $($result:ident)+ = $value:expr, $($operand:ident)+;)*) => {
        /// Operations of one kind, one after the other: for each, the registers of its results, then those of its
        /// operands.
        #[derive(Clone, Debug, PartialEq, Eq)]
        pub(super) enum Row {
            $($kind(Vec<[Register; [$(stringify!($result),)+ $(stringify!($operand)),+].len()]>),)*
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

            /// Name of the operations.
            pub(super) fn name(&self) -> &'static str {
                match self {
                    $(Self::$kind(_) => $name,)*
                }
            }

            /// Registers that each operation writes to and reads.
            pub(super) fn registers(&self) -> Vec<(&[Register], &[Register])> {
                match self {
                    $(Self::$kind(row) => {
                        let results = [$(stringify!($result)),+].len();
                        row.iter().map(|registers| registers.split_at(results)).collect()
                    })*
                }
            }

            /// Runs the operations.
            #[cfg_attr(not(debug_assertions), inline(always))]
            pub(super) fn run<$T: Real>(&self, registers: &mut [$T]) {
                match self {
                    $(Self::$kind(row) => {
                        for &[$($result,)+ $($operand),+] in row {
                            $(let $operand = registers[usize::from($operand)];)+
                            [$(registers[usize::from($result)]),+] = $value;
                        }
                    })*
                }
            }
        }
    };
}

operations! { T:
    Add "add" to = [a + b], a b;
    Sub "sub" to = [a - b], a b;
    Mul "mul" to = [a * b], a b;
    Div "div" to = [a / b], a b;
    Neg "neg" to = [-a], a;
    MulAdd "mul_add" to = [T::mul_add(a, b, c)], a b c;
    MulSub "mul_sub" to = [T::mul_sub(a, b, c)], a b c;
    MulNegAdd "mul_neg_add" to = [T::mul_neg_add(a, b, c)], a b c;
    MulMul "mul_mul" to = [a * b * c], a b c;
    MulMulAdd "mul_mul_add" to = [T::mul_add(a * b, c, d)], a b c d;
    MulMulNegAdd "mul_mul_neg_add" to = [T::mul_neg_add(a * b, c, d)], a b c d;
    MulThenMulAdd "mul_then_mul_add" to = [T::mul_add(c, d, a * b)], a b c d;
    MulThenMulNegAdd "mul_then_mul_neg_add" to = [T::mul_neg_add(c, d, a * b)], a b c d;
    MulAddThenMulAdd "mul_add_then_mul_add" to = [T::mul_add(d, e, T::mul_add(a, b, c))], a b c d e;
    MulAddThenMulNegAdd "mul_add_then_mul_neg_add" to = [T::mul_neg_add(d, e, T::mul_add(a, b, c))], a b c d e;
    MulNegAddThenMulAdd "mul_neg_add_then_mul_add" to = [T::mul_add(d, e, T::mul_neg_add(a, b, c))], a b c d e;
    MulNegAddThenMulNegAdd "mul_neg_add_then_mul_neg_add" to = [
        T::mul_neg_add(d, e, T::mul_neg_add(a, b, c))
    ], a b c d e;
    SinCos "sin_cos" sine cosine = <[T; 2]>::from(T::sin_cos(angle)), angle;
    SinCosPair "sin_cos_pair" sine cosine other_sine other_cosine = {
        let [(sine, cosine), (other_sine, other_cosine)] = T::sin_cos_pair(angle, other);
        [sine, cosine, other_sine, other_cosine]
    }, angle other;
    Tan "tan" to = [T::tan(a)], a;
    Exp "exp" to = [T::exp(a)], a;
    Ln "ln" to = [T::ln(a)], a;
    Sqrt "sqrt" to = [T::sqrt(a)], a;
    Tanh "tanh" to = [T::tanh(a)], a;
    Abs "abs" to = [T::abs(a)], a;
    Signum "signum" to = [T::signum(a)], a;
    AtLeast "at_least" to = [T::at_least(a, b)], a b;
    AtMost "at_most" to = [T::at_most(a, b)], a b;
    Atan2 "atan2" to = [T::atan2(a, b)], a b;
    Powf "powf" to = [T::powf(a, b)], a b;
}
