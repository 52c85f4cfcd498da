//! Operations in chains, for lanes: each passes its result on to the next one in vector registers.
//!
//! In lanes, a register of a tape is several vectors in memory, and loads and stores of operands take longer than the
//! operations. Scalars run [rows](super::code::Row) instead, as the choice of the next operation takes longest there.

use std::collections::BTreeSet;

use super::code::{Code, MOST_REGISTERS, Register, Row};
use crate::real::Real;

/// Operation in a chain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Link {
    kind: Kind,
    /// Register of the result, if one keeps it.
    to: Register,
    /// Registers of the operands, but for the one that the link before passes.
    from: [Register; 3],
}

/// Straight-line code in chains.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Chain {
    links: Vec<Link>,
    /// Operations outside of chains, one each, in order.
    alone: Vec<Row>,
    /// Number of registers; all others are below it.
    pub(super) registers: usize,
    pub(super) results: Vec<Register>,
}

/// Defines the kinds of links: names with a result that is only passed and with one that a register keeps as well, the
/// operation of a tape, the places among its operands of the passed one `x`, and the result as a function of `x` and
/// of the other operands.
macro_rules! links {
    (
        $T:ident $x:ident:
        $($passing:ident $keeping:ident $name:literal [$($place:literal)*] = $value:expr, $($operand:ident)*;)*
    ) => {
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        enum Kind {
            $($passing, $keeping,)*
            Alone,
        }

        impl Kind {
            /// Kind of an operation with the passed operand at this place; `None` if there is none.
            fn new(name: &str, place: Option<usize>, keeps: bool) -> Option<Self> {
                $(
                    let places: &[usize] = &[$($place),*];
                    if name == $name && place.map_or(places.is_empty(), |place| places.contains(&place)) {
                        return Some(if keeps { Self::$keeping } else { Self::$passing });
                    }
                )*
                None
            }
        }

        impl Chain {
            /// Runs the operations on registers. Inlining is not forced without optimisation, where it would take much
            /// of the stack.
            #[cfg_attr(not(debug_assertions), inline(always))]
            pub(super) fn run<$T: Real>(&self, registers: &mut [$T]) {
                let mut alone = self.alone.iter();
                let mut $x = $T::default();
                for link in &self.links {
                    match link.kind {
                        $(
                            Kind::$passing => {
                                let [$($operand,)* ..] = link.from;
                                $(let $operand = registers[usize::from($operand)];)*
                                $x = $value;
                            }
                            Kind::$keeping => {
                                let [$($operand,)* ..] = link.from;
                                $(let $operand = registers[usize::from($operand)];)*
                                $x = $value;
                                registers[usize::from(link.to)] = $x;
                            }
                        )*
                        // not by a closure, which would be compiled for the baseline
                        Kind::Alone => {
                            if let Some(row) = alone.next() {
                                row.run(registers);
                            }
                        }
                    }
                }
            }
        }
    };
}

links! { T x:
    Add AddTo "add" [] = a + b, a b;
    AddX AddXTo "add" [0 1] = x + a, a;
    Sub SubTo "sub" [] = a - b, a b;
    SubX SubXTo "sub" [0] = x - a, a;
    SubOfX SubOfXTo "sub" [1] = a - x, a;
    Mul MulTo "mul" [] = a * b, a b;
    MulX MulXTo "mul" [0 1] = x * a, a;
    Div DivTo "div" [] = a / b, a b;
    DivX DivXTo "div" [0] = x / a, a;
    DivByX DivByXTo "div" [1] = a / x, a;
    Neg NegTo "neg" [] = -a, a;
    NegX NegXTo "neg" [0] = -x,;
    MulAdd MulAddTo "mul_add" [] = T::mul_add(a, b, c), a b c;
    MulAddX MulAddXTo "mul_add" [0 1] = T::mul_add(x, a, b), a b;
    MulAddOnX MulAddOnXTo "mul_add" [2] = T::mul_add(a, b, x), a b;
    MulSub MulSubTo "mul_sub" [] = T::mul_sub(a, b, c), a b c;
    MulSubX MulSubXTo "mul_sub" [0 1] = T::mul_sub(x, a, b), a b;
    MulSubOnX MulSubOnXTo "mul_sub" [2] = T::mul_sub(a, b, x), a b;
    MulNegAdd MulNegAddTo "mul_neg_add" [] = T::mul_neg_add(a, b, c), a b c;
    MulNegAddX MulNegAddXTo "mul_neg_add" [0 1] = T::mul_neg_add(x, a, b), a b;
    MulNegAddOnX MulNegAddOnXTo "mul_neg_add" [2] = T::mul_neg_add(a, b, x), a b;
}

/// Number of a value: that of the register which holds it at first, or a later one for the result of an operation.
type Value = usize;

/// Operation on values.
struct Operation<'a> {
    name: &'a str,
    results: Vec<Value>,
    operands: Vec<Value>,
}

/// Operations of a code, each of which writes values of its own.
struct Flat<'a> {
    operations: Vec<Operation<'a>>,
    results: Vec<Value>,
    /// Operation that makes each value.
    makers: Vec<Option<usize>>,
    /// Number of reads of each value.
    uses: Vec<usize>,
}

impl<'a> Flat<'a> {
    fn new(code: &'a Code) -> Self {
        let mut flat = Self {
            operations: Vec::new(),
            results: Vec::new(),
            makers: vec![None; code.registers],
            uses: Vec::new(),
        };
        let mut held: Vec<Value> = (0..code.registers).collect();
        for row in &code.rows {
            for (results, operands) in row.registers() {
                let operands = operands.iter().map(|&operand| held[usize::from(operand)]).collect();
                let values = flat.split(row.name(), operands, results.len());
                for (&result, value) in results.iter().zip(values) {
                    held[usize::from(result)] = value;
                }
            }
        }
        flat.results = code.results.iter().map(|&result| held[usize::from(result)]).collect();
        flat.uses = vec![0; flat.makers.len()];
        let operands = flat.operations.iter().flat_map(|operation| &operation.operands);
        operands.chain(&flat.results).for_each(|&value| flat.uses[value] += 1);
        flat
    }

    /// Adds an operation, as two if it joins two. Returns the values of its results.
    fn split(&mut self, name: &'a str, mut operands: Vec<Value>, results: usize) -> Vec<Value> {
        let of_product = name.strip_prefix("mul_").filter(|second| second.starts_with("mul"));
        let two = name.split_once("_then_").map(|(first, second)| (first, second, 2));
        let Some((first, second, place)) = two.or(of_product.map(|second| ("mul", second, 0))) else {
            return self.push(name, operands, results);
        };
        let mut others = operands.split_off(if first == "mul" { 2 } else { 3 });
        others.splice(place..place, self.push(first, operands, 1));
        self.push(second, others, results)
    }

    fn push(&mut self, name: &'a str, operands: Vec<Value>, results: usize) -> Vec<Value> {
        let first = self.makers.len();
        self.makers.resize(first + results, Some(self.operations.len()));
        let results: Vec<Value> = (first..first + results).collect();
        self.operations.push(Operation {
            name,
            results: results.clone(),
            operands,
        });
        results
    }

    /// Order in which the operations run: each right after the operation of one of its operands, if possible of one
    /// that no other operation reads. Operations without use are left out.
    fn order(&self) -> Vec<usize> {
        let mut heights: Vec<usize> = Vec::with_capacity(self.operations.len());
        for operation in &self.operations {
            let below = operation.operands.iter().filter_map(|&value| self.makers[value]);
            heights.push(below.map(|n| heights[n] + 1).max().unwrap_or(0));
        }
        let mut order = Vec::with_capacity(self.operations.len());
        let mut is_done = vec![false; self.operations.len()];
        for result in &self.results {
            let mut waiting: Vec<usize> = self.makers[*result].into_iter().collect();
            while let Some(&n) = waiting.last() {
                let operands = self.operations[n].operands.iter();
                let open = operands.filter_map(|&value| Some((self.uses[value] == 1, self.makers[value]?)));
                let open = open.filter(|&(_, maker)| !is_done[n] && !is_done[maker]);
                match open.min_by_key(|&(is_single, maker)| (is_single, heights[maker])) {
                    Some((_, maker)) => waiting.push(maker),
                    None => {
                        waiting.pop();
                        if !std::mem::replace(&mut is_done[n], true) {
                            order.push(n);
                        }
                    }
                }
            }
        }
        order
    }

    /// Place among the operands of the operation `n` to which the operation `before`, right before it, passes its
    /// result.
    fn passed(&self, before: Option<&usize>, n: usize) -> Option<usize> {
        let (before, operation) = (&self.operations[*before?], &self.operations[n]);
        let &[value] = &before.results[..] else { return None };
        Kind::new(before.name, None, false)?;
        let place = operation.operands.iter().position(|&operand| operand == value)?;
        Kind::new(operation.name, Some(place), false).and(Some(place))
    }
}

impl Chain {
    /// Chains of a code, which keep the registers of all values that it reads; `None` if they take too many registers.
    pub(super) fn new(code: &Code) -> Option<Self> {
        let flat = Flat::new(code);
        let given = code.given();
        let mut registers = Registers::new(&flat, &given);
        let mut chain = Self::default();
        let order = flat.order();
        for (k, &n) in order.iter().enumerate() {
            let operation = &flat.operations[n];
            let place = flat.passed(k.checked_sub(1).map(|k| &order[k]), n);
            let is_passed = order
                .get(k + 1)
                .is_some_and(|&next| flat.passed(Some(&n), next).is_some());
            let loaded = operation.operands.iter().enumerate();
            let loaded = loaded.filter(|(k, _)| place != Some(*k));
            let loaded: Vec<Register> = loaded.map(|(_, &value)| registers.of[value]).collect::<Option<_>>()?;
            registers.release(&operation.operands);
            let keeps = operation
                .results
                .iter()
                .any(|&value| flat.uses[value] > usize::from(is_passed));
            let Some(kind) = Kind::new(operation.name, place, keeps) else {
                let results = registers.keep(&operation.results)?;
                chain.alone.push(Row::new(operation.name, &[results, loaded].concat())?);
                chain.push(Kind::Alone, 0, &[]);
                continue;
            };
            let to = match keeps {
                true => registers.keep(&operation.results)?[0],
                false => 0,
            };
            chain.push(kind, to, &loaded);
        }
        let results = flat.results.iter().map(|&value| registers.of[value]);
        chain.results = results.collect::<Option<_>>()?;
        let last_given = given.last().map_or(0, |&register| usize::from(register) + 1);
        chain.registers = registers.count.max(last_given);
        Some(chain)
    }

    fn push(&mut self, kind: Kind, to: Register, loaded: &[Register]) {
        let mut from = [0; 3];
        from[..loaded.len()].copy_from_slice(loaded);
        self.links.push(Link { kind, to, from });
    }
}

/// Registers of values, while operations run.
struct Registers<'a> {
    /// Register of each value that has one.
    of: Vec<Option<Register>>,
    /// Number of reads of each value that are left. Results of the code are never released.
    uses: Vec<usize>,
    /// Registers of the values that the code reads, which are never released, either.
    given: &'a BTreeSet<Register>,
    free: Vec<Register>,
    count: usize,
}

impl<'a> Registers<'a> {
    fn new(flat: &Flat<'_>, given: &'a BTreeSet<Register>) -> Self {
        let mut registers = Self {
            of: vec![None; flat.uses.len()],
            uses: flat.uses.clone(),
            given,
            free: Vec::new(),
            count: 0,
        };
        for &register in given {
            registers.of[usize::from(register)] = Some(register);
            registers.uses[usize::from(register)] += 1;
        }
        registers
    }

    fn release(&mut self, values: &[Value]) {
        for &value in values {
            self.uses[value] -= 1;
            self.release_unused(value);
        }
    }

    fn release_unused(&mut self, value: Value) {
        if self.uses[value] == 0 {
            self.free.extend(self.of[value]);
        }
    }

    /// Gives each value a register; `None` if there are too few.
    fn keep(&mut self, values: &[Value]) -> Option<Vec<Register>> {
        let mut registers = Vec::new();
        for &value in values {
            let register = self.free.pop().or_else(|| self.unused())?;
            self.of[value] = Some(register);
            registers.push(register);
        }
        values.iter().for_each(|&value| self.release_unused(value));
        Some(registers)
    }

    /// Next register that nothing is written to so far.
    fn unused(&mut self) -> Option<Register> {
        let mut others = (self.count..MOST_REGISTERS).map(|register| register as Register);
        let register = others.find(|register| !self.given.contains(register))?;
        self.count = usize::from(register) + 1;
        Some(register)
    }
}
