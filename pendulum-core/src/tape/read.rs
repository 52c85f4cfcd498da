//! Tapes from their text.

use std::iter::{Enumerate, Peekable};
use std::ops::Range;
use std::str::{FromStr, Lines};

use super::code::{Code, MOST_REGISTERS, Register, Row};
use super::error::TapeError;
use super::source::Source;
use super::{Condition, Quantity, Routine, Rule, Series, Shape, Tape, intern};
use crate::constraint::{Constraint, MAX_CONSTRAINTS};
use crate::layout::{Slot, SlotKind, StateVariable};
use crate::shapes::{Outline, ShapeKind};

/// Versions of the format; the second one has more operations.
const VERSIONS: [&str; 2] = ["1", "2"];

/// Lines of a tape, and the place of the last one.
struct Reader<'t> {
    lines: Peekable<Enumerate<Lines<'t>>>,
    line: usize,
    /// True if names are not stored: the text may still be wrong.
    is_draft: bool,
}

impl<'t> Reader<'t> {
    fn error<T>(&self, fact: impl Into<String>) -> Result<T, TapeError> {
        Err(TapeError {
            line: self.line,
            fact: fact.into(),
        })
    }

    /// Next line, if it has this keyword and this number of fields.
    fn next_if<const K: usize>(&mut self, keyword: &str) -> Result<Option<[&'t str; K]>, TapeError> {
        let is_next = |(_, line): &(usize, &str)| line.split('\t').next() == Some(keyword);
        let Some((n, line)) = self.lines.next_if(is_next) else {
            return Ok(None);
        };
        self.line = n + 1;
        let fields: Vec<&str> = line.split('\t').skip(1).collect();
        match fields.try_into() {
            Ok(fields) => Ok(Some(fields)),
            Err(fields) => self.error(format!("`{keyword}` has {K} fields, not {}", fields.len())),
        }
    }

    /// Next line, which must have this keyword.
    fn next<const K: usize>(&mut self, keyword: &str) -> Result<[&'t str; K], TapeError> {
        match self.next_if(keyword)? {
            Some(fields) => Ok(fields),
            None => {
                self.line += 1;
                self.error(format!("`{keyword}` is expected here"))
            }
        }
    }

    /// All next lines with this keyword.
    fn all<T, const K: usize>(
        &mut self,
        keyword: &str,
        mut read: impl FnMut(&Self, [&'t str; K]) -> Result<T, TapeError>,
    ) -> Result<Vec<T>, TapeError> {
        let mut all = Vec::new();
        while let Some(fields) = self.next_if(keyword)? {
            all.push(read(self, fields)?);
        }
        Ok(all)
    }

    fn number<T: FromStr>(&self, text: &str) -> Result<T, TapeError> {
        match text.parse() {
            Ok(number) => Ok(number),
            Err(_) => self.error(format!("`{text}` is not a number that can stand here")),
        }
    }

    fn numbers<T: FromStr>(&self, text: &str) -> Result<Vec<T>, TapeError> {
        text.split_whitespace().map(|number| self.number(number)).collect()
    }

    /// Numbers below a limit.
    fn numbers_below(&self, text: &str, limit: usize, what: &str) -> Result<Vec<usize>, TapeError> {
        let numbers = self.numbers(text)?;
        match numbers.iter().find(|number| **number >= limit) {
            None => Ok(numbers),
            Some(number) => self.error(format!("there is no {what} {number}: the tape has {limit}")),
        }
    }
}

/// Lengths of the lists that code reads.
type Lengths = [usize; Source::ALL.len()];

/// Lengths of these lists; others are empty.
fn lengths(of: &[(Source, usize)]) -> Lengths {
    let mut lengths = [0; Source::ALL.len()];
    for &(source, length) in of {
        lengths[source as usize] = length;
    }
    lengths
}

impl FromStr for Tape {
    type Err = TapeError;

    fn from_str(text: &str) -> Result<Self, TapeError> {
        read(text, true)?;
        read(text, false)
    }
}

/// Tape with this text; a draft has no names.
fn read(text: &str, is_draft: bool) -> Result<Tape, TapeError> {
    let mut reader = Reader {
        lines: text.lines().enumerate().peekable(),
        line: 0,
        is_draft,
    };
    let [version] = reader.next("pendulum tape")?;
    if !VERSIONS.contains(&version) {
        let known = VERSIONS.join(" and ");
        return reader.error(format!("the version is `{version}`, and this program reads {known}"));
    }
    let tape = reader.tape()?;
    match reader.lines.next() {
        None => Ok(tape),
        Some((n, line)) => {
            reader.line = n + 1;
            let keyword = line.split('\t').next().unwrap_or_default();
            reader.error(format!("`{keyword}` is not expected here"))
        }
    }
}

impl Reader<'_> {
    /// Stored copy of a name.
    fn name(&self, name: &str) -> &'static str {
        if self.is_draft { "" } else { intern::name(name) }
    }

    fn tape(&mut self) -> Result<Tape, TapeError> {
        let [name] = self.next("name")?;
        let name = name.to_owned();
        let quantity = |reader: &Self, [name, unit, default]: [&str; 3]| {
            let default = (!default.is_empty()).then(|| reader.number(default)).transpose()?;
            Ok(Quantity {
                name: reader.name(name),
                unit: unit.to_owned(),
                default,
            })
        };
        let (parameters, inputs) = (self.all("parameter", quantity)?, self.all("input", quantity)?);
        let slots = self.all("slot", Self::slot)?;
        let [positions, rates] = self.places(&slots)?;
        let mut next = positions + rates;
        let states = self.all("state", |reader, [name, unit]| {
            next += 1;
            Ok(StateVariable::new(reader.name(name), reader.name(unit), next - 1))
        })?;
        let length = positions + rates + states.len();
        let autonomous = self.next_if::<0>("autonomous")?.is_some();
        let text = |reader: &Self, [name]: [&str; 1]| Ok(reader.name(name));
        let loops = self.all("loop", |reader, names: [&str; 2]| {
            Ok(names.map(|name| reader.name(name)))
        })?;
        let [open] = self.next("open_loops")?;
        let open_loops = self.numbers_below(open, loops.len(), "loop")?;
        let (uncounted, outputs) = (self.all("uncounted", text)?, self.all("output", text)?);
        let events = self.all("event", |reader, [name, kind]| match kind {
            "kink" | "smooth" => Ok((reader.name(name), kind == "kink")),
            _ => reader.error(format!("`{kind}` is no kind of an event")),
        })?;
        let constraints = self.all("constraint", |reader, fields| {
            reader.constraint(fields, positions..positions + rates)
        })?;
        if constraints.len() > MAX_CONSTRAINTS {
            return self.error(format!("a model has at most {MAX_CONSTRAINTS} constraints"));
        }
        let limits: usize = constraints
            .iter()
            .map(|(_, limits)| limits.iter().filter(|is| **is).count())
            .sum();
        let rules = self.all("rule", |reader, fields| reader.rule(fields, &parameters))?;
        let constants_text = self.all("constant", text)?;
        let of_parameters = lengths(&[(Source::Parameter, parameters.len())]);
        let checked = rules
            .iter()
            .flat_map(|rule| &rule.values)
            .max()
            .map_or(0, |most| most + 1);
        let checked = self.named_code("checked", &of_parameters, checked)?;
        let constants = self.named_code("constants", &of_parameters, constants_text.len())?;
        let given = [(Source::Constant, constants_text.len())];
        let laws = self.named_code("laws", &lengths(&given), 4 * constraints.len() + limits)?;
        let state = [(Source::State, length), (Source::Time, 1)];
        let arguments = [
            ("inputs", Source::Input, inputs.len()),
            ("forces", Source::Force, constraints.len()),
            ("accelerations", Source::Acceleration, rates),
            ("weights", Source::Weight, length),
            ("direction", Source::Direction, length + inputs.len()),
        ];
        let of_routines = [&given[..], &state].concat();
        let mut routines: Vec<Routine> = Vec::new();
        while let Some(routine) = self.routine(&of_routines, &arguments)? {
            if routines.iter().any(|known| known.name == routine.name) {
                return self.error(format!("there are two routines `{}`", routine.name));
            }
            routines.push(routine);
        }
        let series = self.series(&of_routines, length, constraints.len())?;
        let outlines = self.all("outline", Self::outline)?;
        let numbers = outlines
            .iter()
            .map(|outline| 3 * outline.points + usize::from(outline.radius));
        let numbers = numbers.sum();
        let drawing = match self.lines.peek() {
            Some((_, "code\tdrawing")) => Some(self.named_code("drawing", &lengths(&of_routines), numbers)?),
            _ => None,
        };
        Ok(Tape {
            name,
            parameters,
            inputs,
            slots,
            states,
            autonomous,
            loops,
            open_loops,
            uncounted,
            outputs,
            events,
            limits: constraints.iter().map(|&(_, limits)| limits).collect(),
            constraints: constraints.into_iter().map(|(constraint, _)| constraint).collect(),
            rules,
            constants_text,
            checked,
            constants,
            laws,
            routines,
            series,
            outlines,
            drawing,
        })
    }

    fn outline(&self, [name, body, kind, points, radius]: [&str; 5]) -> Result<Outline<'static>, TapeError> {
        let Some(kind) = ShapeKind::ALL.into_iter().find(|own| format!("{own:?}") == kind) else {
            return self.error(format!("`{kind}` is no kind of a shape"));
        };
        Ok(Outline {
            name: self.name(name),
            body: self.name(body),
            kind,
            points: usize::from(self.number::<u8>(points)?),
            radius: radius == "radius",
        })
    }

    /// Routine that reads `given` and its own ones of the `arguments`, which have names and lengths.
    fn routine(
        &mut self,
        given: &[(Source, usize)],
        arguments: &[(&str, Source, usize)],
    ) -> Result<Option<Routine>, TapeError> {
        let Some([name, own, shapes]) = self.next_if("routine")? else {
            return Ok(None);
        };
        let own = own.split_whitespace().map(|name| {
            let known = arguments.iter().find(|(known, ..)| *known == name);
            match known {
                Some(&(_, source, length)) => Ok((source, length)),
                None => self.error(format!("`{name}` is no argument of a routine")),
            }
        });
        let own: Vec<(Source, usize)> = own.collect::<Result<_, _>>()?;
        let shapes = shapes.split(", ").filter(|shape| !shape.is_empty());
        let shapes: Vec<Shape> = shapes.map(|shape| self.shape(shape)).collect::<Result<_, _>>()?;
        let results = shapes
            .iter()
            .try_fold(0_usize, |sum, shape| sum.checked_add(shape.len()?));
        let Some(results) = results else {
            return self.error("the results are too many");
        };
        Ok(Some(Routine {
            name: name.to_owned(),
            code: self.code(&lengths(&[given, &own].concat()), Some(results))?,
            arguments: own.into_iter().map(|(source, _)| source).collect(),
            shapes,
        }))
    }

    fn slot(&self, [name, kind, positions, rates, symmetries]: [&str; 5]) -> Result<Slot<'static>, TapeError> {
        let kind = match kind {
            "angle" => SlotKind::Angle,
            "length" => SlotKind::Length,
            "quaternion" => SlotKind::Quaternion,
            _ => return self.error(format!("`{kind}` is no kind of a coordinate")),
        };
        let (positions, rates) = (self.numbers::<usize>(positions)?, self.numbers::<usize>(rates)?);
        let (&[first, end], &[first_rate, end_rate]) = (&positions[..], &rates[..]) else {
            return self.error("a range has a start and an end");
        };
        let (positions, rates) = (first..end, first_rate..end_rate);
        let counts = match kind {
            SlotKind::Quaternion => [4, 3],
            _ => [1, rates.len().min(1)],
        };
        if [positions.len(), rates.len()] != counts {
            return self.error(format!("`{name}` has other numbers of positions and rates"));
        }
        let mut slot = Slot::new(self.name(name), kind, positions, rates);
        for symmetry in symmetries.split_whitespace() {
            slot = match symmetry {
                "periodic" => slot.periodic(),
                "cyclic" => slot.cyclic(),
                _ => return self.error(format!("`{symmetry}` is no symmetry of a coordinate")),
            };
        }
        Ok(slot)
    }

    /// Numbers of positions and rates, which follow one another in the state.
    fn places(&self, slots: &[Slot<'_>]) -> Result<[usize; 2], TapeError> {
        let positions: usize = slots.iter().map(|slot| slot.positions.len()).sum();
        let mut next = [0, positions];
        for slot in slots {
            for (range, next) in [&slot.positions, &slot.rates].into_iter().zip(&mut next) {
                if !range.is_empty() && range.start != *next {
                    return self.error("the places of the coordinates in the state do not fit");
                }
                *next += range.len();
            }
        }
        Ok([positions, next[1] - positions])
    }

    fn constraint(
        &self,
        [name, rate, limits]: [&str; 3],
        rates: Range<usize>,
    ) -> Result<(Constraint<'static>, [bool; 2]), TapeError> {
        let numbers: Vec<i64> = self.numbers(rate)?;
        let mut components = Vec::new();
        for pair in numbers.chunks(2) {
            match (pair, usize::try_from(pair[0])) {
                (&[_, sign @ (1 | -1)], Ok(component)) if rates.contains(&component) => {
                    components.push((component, if sign > 0 { 1 } else { -1 }));
                }
                _ => return self.error(format!("`{rate}` are not rates in the state with signs")),
            }
        }
        let has = |limit| limits.split_whitespace().any(|name| name == limit);
        let constraint = Constraint {
            name: self.name(name),
            rate: if self.is_draft { &[] } else { intern::rate(&components) },
        };
        Ok((constraint, [has("low"), has("high")]))
    }

    fn rule(
        &self,
        [condition, values, name, text, given]: [&str; 5],
        parameters: &[Quantity],
    ) -> Result<Rule, TapeError> {
        let values: Vec<usize> = self.numbers(values)?;
        if values.iter().any(|&value| value > MOST_REGISTERS) {
            return self.error("the checked values are too many");
        }
        let condition = match (condition, values.len()) {
            ("positive", 1) => Condition::Positive,
            ("non_negative", 1) => Condition::NonNegative,
            ("non_negative_within", 2) => Condition::NonNegativeWithin,
            _ => return self.error(format!("`{condition}` is no condition on a value")),
        };
        Ok(Rule {
            condition,
            values,
            name: self.name(name),
            text: self.name(text),
            parameters: self.numbers_below(given, parameters.len(), "parameter")?,
        })
    }

    fn shape(&self, text: &str) -> Result<Shape, TapeError> {
        let (kind, lengths) = text.split_once(' ').unwrap_or((text, ""));
        match (kind, &self.numbers(lengths)?[..]) {
            ("scalar", []) => Ok(Shape::Scalar),
            ("vector", &[n]) => Ok(Shape::Vector(n)),
            ("matrix", &[n, m]) => Ok(Shape::Matrix(n, m)),
            ("symmetric", &[n]) => Ok(Shape::Symmetric(n)),
            _ => self.error(format!("`{text}` is no shape of a result")),
        }
    }

    fn named_code(&mut self, name: &str, lengths: &Lengths, results: usize) -> Result<Code, TapeError> {
        match self.next("code")? {
            [given] if given == name => self.code(lengths, Some(results)),
            _ => self.error(format!("the code `{name}` is expected here")),
        }
    }

    /// Code that reads lists of these lengths and has this many results, or any number of them.
    fn code(&mut self, lengths: &Lengths, results: Option<usize>) -> Result<Code, TapeError> {
        let [registers] = self.next("registers")?;
        let registers: usize = self.number(registers)?;
        if registers > MOST_REGISTERS {
            return self.error(format!(
                "{registers} registers are too many: there are {MOST_REGISTERS}"
            ));
        }
        let mut code = Code {
            registers,
            ..Code::default()
        };
        let mut places = 0..registers;
        while let Some([name, indices]) = self.next_if("read")? {
            let Some(&(_, source)) = Source::ALL.iter().find(|(known, _)| *known == name) else {
                return self.error(format!("`{name}` is nothing that code reads"));
            };
            for index in self.numbers_below(indices, lengths[source as usize], name)? {
                let Some(place) = places.next() else {
                    return self.error("there are fewer registers than values that are read");
                };
                match source {
                    Source::Constant => code.constants.push((place as Register, index)),
                    _ => code.read(place, source, index),
                }
            }
        }
        code.numbers = self.all("number", |reader, [place, value]| {
            match reader.registers(place, registers)?[..] {
                [place] => Ok((place, reader.number(value)?)),
                _ => reader.error("a number has one register"),
            }
        })?;
        loop {
            let Some((n, line)) = self.lines.next() else {
                self.line += 1;
                return self.error("the code does not end in `result`");
            };
            self.line = n + 1;
            let (name, operands) = line.split_once('\t').unwrap_or((line, ""));
            let operands = self.registers(operands, registers)?;
            match Row::new(name, &operands) {
                Some(row) => code.push(row),
                None if name == "result" => match results.filter(|&results| results != operands.len()) {
                    None => {
                        code.results = operands;
                        return code.check().or_else(|reason| self.error(reason)).map(|()| code);
                    }
                    Some(results) => {
                        return self.error(format!("{results} results are expected, not {}", operands.len()));
                    }
                },
                None => return self.error(format!("`{name}` is no operation on {} registers", operands.len())),
            }
        }
    }

    fn registers(&self, text: &str, count: usize) -> Result<Vec<Register>, TapeError> {
        let registers = self.numbers_below(text, count, "register")?;
        // no count is above the number of registers that can be numbered
        Ok(registers.into_iter().map(|register| register as Register).collect())
    }

    fn series(
        &mut self,
        given: &[(Source, usize)],
        length: usize,
        constraints: usize,
    ) -> Result<Option<Series>, TapeError> {
        let Some([products, kept]) = self.next_if("series")? else {
            return Ok(None);
        };
        let (products, kept): (usize, usize) = (self.number(products)?, self.number(kept)?);
        let Some(results) = products.checked_mul(2).and_then(|sides| sides.checked_add(length)) else {
            return self.error("the products are too many");
        };
        let forces = (Source::Force, constraints);
        let start = self.code(
            &lengths(&[given, &[forces]].concat()),
            Some(length.saturating_add(kept)),
        )?;
        let of_order = [
            (Source::Order, 1),
            (Source::OverOrder, 1),
            (Source::TimeCoefficient, 1),
            (Source::StateCoefficient, length),
            (Source::Sum, products),
            (Source::Kept, kept),
        ];
        let of_order = [given, &[forces], &of_order].concat();
        let before = self.code(&lengths(&of_order), None)?;
        let Some(carried) = before.results.len().checked_sub(constraints) else {
            return self.error(format!("{constraints} results are expected at least"));
        };
        let late = [(Source::ForceCoefficient, constraints), (Source::Carried, carried)];
        let order = self.code(&lengths(&[&of_order[..], &late].concat()), Some(results))?;
        Ok(Some(Series {
            products,
            kept,
            start,
            before,
            order,
        }))
    }
}
