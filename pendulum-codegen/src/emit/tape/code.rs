//! Blocks as lists of operations on registers.

use std::collections::{BTreeMap, BTreeSet, VecDeque};

use super::{line, list};
use crate::expr::{Binary, Unary};
use crate::program::dependence::Dependence;
use crate::program::{Block, Coefficient, Let, Local, Signs, SinCos, Term, Variable};

/// Number of registers up to which operations are in rows. Beyond it, registers leave the cache of the processor.
const MOST_IN_ROWS: usize = 1024;

/// Block as operations on registers. The first registers hold what the block reads. Others are reused as soon as their
/// values are no longer needed, except for those of numbers.
pub(super) struct Code {
    /// Lists of the values that the block reads, and their indices there.
    reads: Vec<(&'static str, usize)>,
    /// Number of values of another block that it reads.
    carried: usize,
    /// Numbers and their registers.
    numbers: Vec<(f64, usize)>,
    /// Operations, each with the registers of its results and of its operands.
    operations: Vec<(&'static str, Vec<usize>)>,
    results: Vec<usize>,
    /// Number of registers.
    registers: usize,
}

impl Code {
    pub(super) fn new(block: &Block) -> Self {
        Self::after(block, &[])
    }

    /// Code of a block that reads values of another one, given as results of that.
    pub(super) fn after(block: &Block, carried: &[Term]) -> Self {
        let flat = Flat::new(block, carried);
        let (mut registers, mut operations) = flat.in_order(order(&flat.operations));
        if registers.count > MOST_IN_ROWS {
            // rows take more registers than the order of the block
            (registers, operations) = flat.in_order((0..flat.operations.len()).collect());
        }
        Self {
            numbers: flat
                .numbers
                .iter()
                .map(|(&bits, value)| (f64::from_bits(bits), registers.of[value]))
                .collect(),
            results: flat.results.iter().map(|value| registers.of[value]).collect(),
            reads: flat.reads.into_keys().map(source).collect(),
            carried: flat.carried,
            operations,
            registers: registers.count,
        }
    }

    /// Lines of the code: number of registers, variables, numbers, operations, results.
    pub(super) fn lines(&self) -> String {
        let mut sources: Vec<(&str, Vec<usize>)> = Vec::new();
        let carried = (0..self.carried).map(|index| ("carried", index));
        for (name, index) in self.reads.iter().copied().chain(carried) {
            match sources.last_mut() {
                Some((last, indices)) if *last == name => indices.push(index),
                _ => sources.push((name, vec![index])),
            }
        }
        let reads = sources
            .iter()
            .map(|(name, indices)| line(&["read", name, &list(indices)]));
        let numbers = self.numbers.iter();
        let numbers = numbers.map(|(number, place)| line(&["number", &place.to_string(), &format!("{number:?}")]));
        let operations = self.operations.iter();
        let operations = operations.map(|(name, registers)| line(&[name, &list(registers)]));
        let lines = reads.chain(numbers).chain(operations).collect::<String>();
        line(&["registers", &self.registers.to_string()]) + &lines + &line(&["result", &list(&self.results)])
    }
}

/// Name of the list that holds a variable, and its index there.
fn source(variable: Variable) -> (&'static str, usize) {
    match variable {
        Variable::State(n) => ("state", n),
        Variable::Acceleration(n) => ("acceleration", n),
        Variable::Weight(n) => ("weight", n),
        Variable::Direction(n) => ("direction", n),
        Variable::Time => ("time", 0),
        Variable::Input(n) => ("input", n),
        Variable::Force(n) => ("force", n),
        Variable::Constant(n) => ("constant", n),
        Variable::Parameter(n) => ("parameter", n),
        Variable::Given(_) | Variable::Factor(_) | Variable::Solved(_) => unreachable!("loops are unrolled"),
        Variable::Series(coefficient) => match coefficient {
            Coefficient::Order => ("order", 0),
            Coefficient::OverOrder => ("over_order", 0),
            Coefficient::Time => ("time_coefficient", 0),
            Coefficient::State(n) => ("state_coefficient", n),
            Coefficient::Sum(n) => ("sum", n),
            Coefficient::Kept(n) => ("kept", n),
            Coefficient::Force(n) => ("force_coefficient", n),
            Coefficient::Side(n) => ("side", n),
        },
    }
}

/// Number of a value of a block: one that it reads, a number, or a result of an operation.
type Value = usize;

/// Operation on values.
struct Operation {
    name: &'static str,
    results: Vec<Value>,
    operands: Vec<Value>,
}

/// Block as operations, each on two or three values.
#[derive(Default)]
struct Flat {
    /// Variables, whose values are the first ones.
    reads: BTreeMap<Variable, Value>,
    /// Number of values of another block, which follow.
    carried: usize,
    /// Numbers, by their bits.
    numbers: BTreeMap<u64, Value>,
    locals: BTreeMap<Local, Value>,
    operations: Vec<Operation>,
    results: Vec<Value>,
    /// Number of values.
    values: usize,
}

impl Flat {
    fn new(block: &Block, carried: &[Term]) -> Self {
        let block = &*block.unrolled();
        let reads: BTreeMap<Variable, Value> = block.reads().into_iter().zip(0..).collect();
        let locals = carried
            .iter()
            .zip(reads.len()..)
            .filter_map(|(term, value)| match term {
                Term::Local(local) => Some((*local, value)),
                _ => None,
            });
        let mut flat = Self {
            values: reads.len() + carried.len(),
            locals: locals.collect(),
            carried: carried.len(),
            reads,
            ..Self::default()
        };
        block.lets.iter().for_each(|code| flat.statement(code));
        flat.results = block.results.iter().map(|term| flat.term(term)).collect();
        flat.join();
        flat
    }

    /// Joins pairs of operations, of which the second alone reads the result of the first, to one of a kind of its own,
    /// so that the result needs no register.
    fn join(&mut self) {
        let mut uses = vec![0; self.values];
        let operands = self.operations.iter().flat_map(|operation| &operation.operands);
        operands.chain(&self.results).for_each(|&value| uses[value] += 1);
        let mut makers: BTreeMap<Value, usize> = BTreeMap::new();
        let mut joined: Vec<Option<Operation>> = Vec::new();
        for operation in std::mem::take(&mut self.operations) {
            let first_of = |(place, value): (usize, &Value)| {
                let maker = *makers.get(value).filter(|_| uses[*value] == 1)?;
                let name = joint(joined[maker].as_ref()?.name, operation.name, place)?;
                Some((place, maker, name))
            };
            let found = operation.operands.iter().enumerate().find_map(first_of);
            let found = found.and_then(|(place, maker, name)| Some((place, joined[maker].take()?, name)));
            let operation = match found {
                None => operation,
                Some((place, first, name)) => {
                    let others = operation.operands.iter().enumerate();
                    let others = others.filter_map(|(n, &value)| (n != place).then_some(value));
                    Operation {
                        name,
                        operands: first.operands.iter().copied().chain(others).collect(),
                        results: operation.results,
                    }
                }
            };
            if let [value] = operation.results[..] {
                makers.insert(value, joined.len());
            }
            joined.push(Some(operation));
        }
        self.operations = joined.into_iter().flatten().collect();
    }

    /// Registers of the values after all operations, run in this order, and the operations on registers.
    fn in_order(&self, order: Vec<usize>) -> (Registers, Vec<(&'static str, Vec<usize>)>) {
        let mut registers = Registers::new(self);
        let operations = order.into_iter().map(|n| registers.operation(&self.operations[n]));
        let operations = operations.collect();
        (registers, operations)
    }

    fn statement(&mut self, code: &Let) {
        match code {
            Let::Value(of, term) => {
                let value = self.term(term);
                self.locals.insert(*of, value);
            }
            Let::SinCos(pairs) => match pairs.as_slice() {
                [_, _] => self.sines("sin_cos_pair", pairs),
                _ => pairs.chunks(1).for_each(|pair| self.sines("sin_cos", pair)),
            },
        }
    }

    fn sines(&mut self, name: &'static str, pairs: &[SinCos]) {
        let angles: Vec<&Term> = pairs.iter().map(|pair| &pair.angle).collect();
        let values = self.operation(name, &angles, 2 * pairs.len());
        let locals = pairs.iter().flat_map(|pair| [pair.sine, pair.cosine]);
        let named = locals.zip(values).filter_map(|(local, value)| Some((local?, value)));
        self.locals.extend(named);
    }

    /// Value of a term, after the operations that compute it.
    fn term(&mut self, term: &Term) -> Value {
        let (name, operands) = match (term.multiply_add(), term) {
            (Some(fused), _) => {
                let name = match fused.signs {
                    Signs::Add => "mul_add",
                    Signs::Subtract => "mul_sub",
                    Signs::SubtractProduct => "mul_neg_add",
                };
                let [a, b] = fused.factors;
                (name, vec![a, b, fused.other])
            }
            (_, Term::Number(value)) => return self.number(*value),
            (_, Term::Local(of)) => return self.locals[of],
            (_, Term::Read(variable)) => return self.reads[variable],
            (_, Term::Unary(op, a)) => (unary(*op), vec![&**a]),
            (_, Term::Binary(op, a, b)) => (binary(*op), vec![&**a, &**b]),
            (_, Term::Sqrt(a)) => ("sqrt", vec![&**a]),
            (_, Term::Power(a, exponent)) => {
                let exponent = Term::Number(*exponent);
                return self.operation("powf", &[a, &exponent], 1)[0];
            }
        };
        self.operation(name, &operands, 1)[0]
    }

    /// Value of a number. Zeros have no sign, as in the Rust code.
    fn number(&mut self, value: f64) -> Value {
        let next = self.values;
        let own = *self.numbers.entry((value + 0.0).to_bits()).or_insert(next);
        self.values += usize::from(own == next);
        own
    }

    fn operation(&mut self, name: &'static str, operands: &[&Term], results: usize) -> Vec<Value> {
        let operands = operands.iter().map(|operand| self.term(operand)).collect();
        let results: Vec<Value> = (self.values..self.values + results).collect();
        self.values += results.len();
        self.operations.push(Operation {
            name,
            results: results.clone(),
            operands,
        });
        results
    }
}

/// Kind of two operations in one: its operands are those of the first, then the others of the second, of which the
/// first is the operand at this place. `None` if there is no such kind.
fn joint(first: &str, second: &str, place: usize) -> Option<&'static str> {
    Some(match (first, second, place) {
        ("mul", "mul", 0) => "mul_mul",
        ("mul", "mul_add", 0) => "mul_mul_add",
        ("mul", "mul_neg_add", 0) => "mul_mul_neg_add",
        ("mul", "mul_add", 2) => "mul_then_mul_add",
        ("mul", "mul_neg_add", 2) => "mul_then_mul_neg_add",
        ("mul_add", "mul_add", 2) => "mul_add_then_mul_add",
        ("mul_add", "mul_neg_add", 2) => "mul_add_then_mul_neg_add",
        ("mul_neg_add", "mul_add", 2) => "mul_neg_add_then_mul_add",
        ("mul_neg_add", "mul_neg_add", 2) => "mul_neg_add_then_mul_neg_add",
        _ => return None,
    })
}

/// Order in which operations run: those of one kind in long rows, so that the interpreter seldom changes from kind to
/// kind, and an operation seldom waits for the one before it. The next kind is that of the operation that starts the
/// longest chain.
fn order(operations: &[Operation]) -> Vec<usize> {
    let mut makers: BTreeMap<Value, usize> = BTreeMap::new();
    for (n, operation) in operations.iter().enumerate() {
        makers.extend(operation.results.iter().map(|&value| (value, n)));
    }
    let needs = operations.iter().map(|operation| {
        let needs = operation.operands.iter().filter_map(|value| makers.get(value));
        needs.copied().collect()
    });
    let mut dependence = Dependence::new(&needs.collect::<Vec<BTreeSet<usize>>>());
    let chains = dependence.chains(|_| 1);
    let mut ready: BTreeMap<&str, VecDeque<usize>> = BTreeMap::new();
    for n in dependence.ready() {
        ready.entry(operations[n].name).or_default().push_back(n);
    }
    let mut order = Vec::with_capacity(operations.len());
    let longest = |row: &VecDeque<usize>| row.iter().map(|&n| chains[n]).max();
    while let Some(kind) = ready.iter().max_by_key(|(_, row)| longest(row)).map(|(kind, _)| *kind) {
        while let Some(next) = ready.get_mut(kind).and_then(VecDeque::pop_front) {
            order.push(next);
            for n in dependence.finish(next) {
                ready.entry(operations[n].name).or_default().push_back(n);
            }
        }
        ready.remove(kind);
    }
    order
}

/// Registers of values, while operations run.
struct Registers {
    of: BTreeMap<Value, usize>,
    /// Number of reads of each value that are left. Results of the block are never released.
    uses: Vec<usize>,
    free: Vec<usize>,
    count: usize,
}

impl Registers {
    fn new(flat: &Flat) -> Self {
        let mut uses = vec![0; flat.values];
        let operands = flat.operations.iter().flat_map(|operation| &operation.operands);
        // what is read keeps its registers, as do numbers
        let fixed: Vec<Value> = (0..flat.reads.len() + flat.carried)
            .chain(flat.numbers.values().copied())
            .collect();
        operands
            .chain(&flat.results)
            .chain(&fixed)
            .for_each(|&value| uses[value] += 1);
        Self {
            count: fixed.len(),
            of: fixed.into_iter().zip(0..).collect(),
            uses,
            free: Vec::new(),
        }
    }

    /// Operation on registers. It reads its operands before it writes its results.
    fn operation(&mut self, operation: &Operation) -> (&'static str, Vec<usize>) {
        let read: Vec<usize> = operation.operands.iter().map(|value| self.of[value]).collect();
        for (value, &register) in operation.operands.iter().zip(&read) {
            self.uses[*value] -= 1;
            if self.uses[*value] == 0 {
                self.free.push(register);
            }
        }
        let mut written = Vec::new();
        for &value in &operation.results {
            let register = self.free.pop().unwrap_or_else(|| {
                self.count += 1;
                self.count - 1
            });
            self.of.insert(value, register);
            written.push(register);
        }
        let unused = operation
            .results
            .iter()
            .zip(&written)
            .filter(|(value, _)| self.uses[**value] == 0);
        self.free.extend(unused.map(|(_, &register)| register));
        (operation.name, [written, read].concat())
    }
}

fn unary(op: Unary) -> &'static str {
    match op {
        Unary::Neg => "neg",
        op => op.spelling(),
    }
}

fn binary(op: Binary) -> &'static str {
    match op {
        Binary::Add => "add",
        Binary::Sub => "sub",
        Binary::Mul => "mul",
        Binary::Div => "div",
        Binary::Atan2 => "atan2",
        Binary::Max => "at_least",
        Binary::Min => "at_most",
    }
}
