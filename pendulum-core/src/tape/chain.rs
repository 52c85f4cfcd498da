//! Operations in chains, for lanes: each passes its result on to the next one in vector registers.
//!
//! In lanes, a register of a tape is several vectors in memory, and loads and stores of operands take longer than the
//! operations. Scalars run [rows](Row) instead, as the choice of the next operation takes longest there.

use std::collections::{BTreeMap, BTreeSet};

use super::row::{MOST_REGISTERS, Register, Row};
use crate::real::Real;

/// Operation in a chain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Link<W> {
    kind: Kind,
    /// Registers of the operands, but for the one that the link before passes and for a number; index of the number at
    /// `NUMBER`; register of the result at `RESULT`, if one keeps it.
    places: W,
}

/// Place of the index of a number in a link.
const NUMBER: usize = 2;
/// Place of the register of the result in a link.
const RESULT: usize = 3;

/// Four places in one word, since each load takes as long as one of a vector.
trait Word: Copy {
    fn new(places: [Register; 4]) -> Self;

    fn split(self) -> [usize; 4];
}

impl Word for u32 {
    fn new(places: [Register; 4]) -> Self {
        Self::from_le_bytes(places.map(|place| place as u8))
    }

    #[inline(always)]
    fn split(self) -> [usize; 4] {
        self.to_le_bytes().map(usize::from)
    }
}

impl Word for u64 {
    fn new(places: [Register; 4]) -> Self {
        places
            .iter()
            .rev()
            .fold(0, |word, &place| word << 16 | Self::from(place))
    }

    #[inline(always)]
    fn split(self) -> [usize; 4] {
        [0, 16, 32, 48].map(|bits| usize::from((self >> bits) as Register))
    }
}

/// Links, in short words if registers and numbers are at most [`MANY`].
#[derive(Clone, Debug, PartialEq)]
enum Links {
    Short(Vec<Link<u32>>),
    Long(Vec<Link<u64>>),
}

/// Numbers of registers, and of numbers, with which no place in a link need be compared. The lower one is for small
/// codes, since registers take time even if unused.
const FEW: usize = 32;
const MANY: usize = 256;

fn in_words<W: Word>(links: &[(Kind, [Register; 4])]) -> Vec<Link<W>> {
    let places = |&(kind, places)| Link {
        kind,
        places: W::new(places),
    };
    links.iter().map(places).collect()
}

/// Operations in order, on registers that are set before.
pub(super) struct Operations<'a> {
    /// Number of registers; all others are below it.
    pub(super) registers: usize,
    pub(super) rows: &'a [Row],
    /// Numbers and their registers.
    pub(super) numbers: &'a [(Register, f64)],
    pub(super) results: &'a [Register],
    /// Registers of numbers, constants and variables.
    pub(super) given: BTreeSet<Register>,
}

/// Straight-line code in chains.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Chain {
    links: Links,
    /// Operations outside of chains, one each, in order.
    alone: Vec<Row>,
    /// Numbers of the code, which most links read from here: a vector of each would take memory.
    numbers: Vec<f64>,
    /// Numbers that other links read from registers.
    pub(super) in_registers: Vec<(Register, f64)>,
    /// Number of registers: [`FEW`] or [`MANY`] with short links, else as many as needed.
    pub(super) registers: usize,
    pub(super) results: Vec<Register>,
}

/// Defines the kinds of links: names with a result that is only passed and with one that a register keeps as well, the
/// operation of a tape, the places among its operands of the passed one `x` and of a number `n`, and the result as a
/// function of `x`, `n` and of the other operands.
macro_rules! links {
    (
        $T:ident $x:ident:
        $($passing:ident $keeping:ident $name:literal [$($place:literal)*] $($n:ident [$($of_number:literal)*])? =
        $value:expr, $($operand:ident)*;)*
    ) => {
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        enum Kind {
            $($passing, $keeping,)*
            Alone,
        }

        impl Kind {
            /// Kind of an operation with the passed operand and a number at these places; `None` if there is none.
            fn new(name: &str, place: Option<usize>, number: Option<usize>, keeps: bool) -> Option<Self> {
                let fits = |place: Option<usize>, places: &[usize]| {
                    place.map_or(places.is_empty(), |place| places.contains(&place))
                };
                $(
                    if name == $name && fits(place, &[$($place),*]) && fits(number, &[$($($of_number),*)?]) {
                        return Some(if keeps { Self::$keeping } else { Self::$passing });
                    }
                )*
                None
            }
        }

        impl Chain {
            /// Runs links on registers, of which there are at least `R` if they name only these. Inlining is not forced
            /// without optimisation, where it would take much of the stack.
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn run_on<$T: Real, W: Word, const R: usize>(&self, links: &[Link<W>], registers: &mut [$T]) {
                assert!(registers.len() >= R && self.numbers.len() >= R);
                // as the compiler sees, below `R`
                let within = |place: usize| if R > 0 { place % R } else { place };
                let mut alone = self.alone.iter();
                let mut $x = $T::default();
                for link in links {
                    // loaded at once, but split by each kind, as most take fewer than four
                    let places = link.places;
                    match link.kind {
                        $(
                            Kind::$passing => {
                                let places = places.split();
                                let [$($operand,)* ..] = places;
                                $(let $operand = registers[within($operand)];)*
                                $(let $n = $T::from_f64(self.numbers[within(places[NUMBER])]);)?
                                $x = $value;
                            }
                            Kind::$keeping => {
                                let places = places.split();
                                let [$($operand,)* ..] = places;
                                $(let $operand = registers[within($operand)];)*
                                $(let $n = $T::from_f64(self.numbers[within(places[NUMBER])]);)?
                                $x = $value;
                                registers[within(places[RESULT])] = $x;
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
    AddN AddNTo "add" [] n [0 1] = a + n, a;
    AddXN AddXNTo "add" [0 1] n [0 1] = x + n,;
    Sub SubTo "sub" [] = a - b, a b;
    SubX SubXTo "sub" [0] = x - a, a;
    SubOfX SubOfXTo "sub" [1] = a - x, a;
    SubXN SubXNTo "sub" [0] n [1] = x - n,;
    SubOfXN SubOfXNTo "sub" [1] n [0] = n - x,;
    Mul MulTo "mul" [] = a * b, a b;
    MulX MulXTo "mul" [0 1] = x * a, a;
    MulN MulNTo "mul" [] n [0 1] = a * n, a;
    MulXN MulXNTo "mul" [0 1] n [0 1] = x * n,;
    Div DivTo "div" [] = a / b, a b;
    DivX DivXTo "div" [0] = x / a, a;
    DivByX DivByXTo "div" [1] = a / x, a;
    DivByXN DivByXNTo "div" [1] n [0] = n / x,;
    Neg NegTo "neg" [] = -a, a;
    NegX NegXTo "neg" [0] = -x,;
    MulAdd MulAddTo "mul_add" [] = T::mul_add(a, b, c), a b c;
    MulAddX MulAddXTo "mul_add" [0 1] = T::mul_add(x, a, b), a b;
    MulAddXN MulAddXNTo "mul_add" [0 1] n [0 1] = T::mul_add(x, n, a), a;
    MulAddOnX MulAddOnXTo "mul_add" [2] = T::mul_add(a, b, x), a b;
    MulAddOnXN MulAddOnXNTo "mul_add" [2] n [0 1] = T::mul_add(a, n, x), a;
    MulSub MulSubTo "mul_sub" [] = T::mul_sub(a, b, c), a b c;
    MulSubX MulSubXTo "mul_sub" [0 1] = T::mul_sub(x, a, b), a b;
    MulSubOnX MulSubOnXTo "mul_sub" [2] = T::mul_sub(a, b, x), a b;
    MulNegAdd MulNegAddTo "mul_neg_add" [] = T::mul_neg_add(a, b, c), a b c;
    MulNegAddX MulNegAddXTo "mul_neg_add" [0 1] = T::mul_neg_add(x, a, b), a b;
    MulNegAddOnX MulNegAddOnXTo "mul_neg_add" [2] = T::mul_neg_add(a, b, x), a b;
    MulNegAddOnXN MulNegAddOnXNTo "mul_neg_add" [2] n [0 1] = T::mul_neg_add(a, n, x), a;
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
    fn new(code: &Operations<'a>) -> Self {
        let mut flat = Self {
            operations: Vec::new(),
            results: Vec::new(),
            makers: vec![None; code.registers],
            uses: Vec::new(),
        };
        let mut held: Vec<Value> = (0..code.registers).collect();
        for row in code.rows {
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
        Kind::new(before.name, None, None, false)?;
        let place = operation.operands.iter().position(|&operand| operand == value)?;
        Kind::new(operation.name, Some(place), None, false).and(Some(place))
    }
}

/// Operation of a link, before its values have registers.
struct Planned<'a> {
    operation: &'a Operation<'a>,
    /// Places among the operands of the passed one, and of a number that is not in a register.
    passed: Option<usize>,
    number: Option<usize>,
}

impl<'a> Planned<'a> {
    /// Operations in order.
    fn all(flat: &'a Flat<'a>, numbers: &BTreeMap<Value, usize>) -> Vec<Self> {
        let order = flat.order();
        let planned = order.iter().enumerate().map(|(k, &n)| {
            let operation = &flat.operations[n];
            let passed = flat.passed(k.checked_sub(1).map(|k| &order[k]), n);
            let can_be_number = |&place: &usize| {
                passed != Some(place)
                    && numbers.contains_key(&operation.operands[place])
                    && Kind::new(operation.name, passed, Some(place), false).is_some()
            };
            Self {
                operation,
                passed,
                number: (0..operation.operands.len()).find(can_be_number),
            }
        });
        planned.collect()
    }

    /// Operands that are loaded from registers.
    fn loaded(&self) -> impl Iterator<Item = Value> {
        let operands = self.operation.operands.iter().enumerate();
        let loaded = operands.filter(|&(k, _)| self.passed != Some(k) && self.number != Some(k));
        loaded.map(|(_, &value)| value)
    }
}

impl Chain {
    /// Chains of a code, which keep the registers of all values that it reads, but for numbers; `None` if they take too
    /// many registers.
    pub(super) fn new(code: &Operations<'_>) -> Option<Self> {
        let flat = Flat::new(code);
        let numbers = code.numbers.iter().enumerate();
        let numbers: BTreeMap<Value, usize> = numbers.map(|(k, &(value, _))| (usize::from(value), k)).collect();
        let planned = Planned::all(&flat, &numbers);
        let loaded: BTreeSet<Value> = planned
            .iter()
            .flat_map(Planned::loaded)
            .chain(flat.results.clone())
            .collect();
        let is_loaded = |register: &Register| loaded.contains(&usize::from(*register));
        let mut given = code.given.clone();
        given.retain(|register| is_loaded(register) || !numbers.contains_key(&usize::from(*register)));
        let mut registers = Registers::new(&flat, &given);
        let in_registers = code.numbers.iter().copied();
        let mut alone = Vec::new();
        let mut links = Vec::new();
        for (k, link) in planned.iter().enumerate() {
            let is_passed = planned.get(k + 1).is_some_and(|next| next.passed.is_some());
            let number = link.number.map(|place| numbers[&link.operation.operands[place]]);
            links.push(registers.link(&flat, link, (number, is_passed), &mut alone)?);
        }
        let results = flat.results.iter().map(|&value| registers.of[value]);
        let results = results.collect::<Option<_>>()?;
        let last_given = given.last().map_or(0, |&register| usize::from(register) + 1);
        let count = registers.count.max(last_given);
        let mut numbers: Vec<f64> = code.numbers.iter().map(|&(_, number)| number).collect();
        let room = [FEW, MANY].into_iter().find(|&room| count.max(numbers.len()) <= room);
        if let Some(room) = room {
            numbers.resize(room, 0.0);
        }
        Some(Self {
            links: match room {
                Some(_) => Links::Short(in_words(&links)),
                None => Links::Long(in_words(&links)),
            },
            alone,
            numbers,
            in_registers: in_registers.filter(|(register, _)| is_loaded(register)).collect(),
            registers: room.unwrap_or(count),
            results,
        })
    }

    /// Runs the operations on registers.
    #[inline(always)]
    pub(super) fn run<T: Real>(&self, registers: &mut [T]) {
        match &self.links {
            Links::Short(links) if self.registers == FEW => self.run_on::<T, _, FEW>(links, registers),
            Links::Short(links) => self.run_on::<T, _, MANY>(links, registers),
            Links::Long(links) => self.run_on::<T, _, 0>(links, registers),
        }
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

    /// Link of an operation with this number, which passes its result on or not; adds those outside of chains to
    /// `alone`.
    fn link(
        &mut self,
        flat: &Flat<'_>,
        link: &Planned<'_>,
        (number, is_passed): (Option<usize>, bool),
        alone: &mut Vec<Row>,
    ) -> Option<(Kind, [Register; 4])> {
        let Operation {
            name,
            results,
            operands,
        } = link.operation;
        let loaded: Vec<Register> = link.loaded().map(|value| self.of[value]).collect::<Option<_>>()?;
        self.release(operands);
        let keeps = results.iter().any(|&value| flat.uses[value] > usize::from(is_passed));
        let mut places = [0; 4];
        let Some(kind) = Kind::new(name, link.passed, link.number, keeps) else {
            let results = self.keep(results)?;
            alone.push(Row::new(name, &[results, loaded].concat())?);
            return Some((Kind::Alone, places));
        };
        places[..loaded.len()].copy_from_slice(&loaded);
        if let Some(number) = number {
            places[NUMBER] = number as Register;
        }
        if keeps {
            places[RESULT] = self.keep(results)?[0];
        }
        Some((kind, places))
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
