//! Code of a tape, every index of which is checked.

use super::Reader;
use crate::shapes::Outline;
use crate::tape::code::Code;
use crate::tape::error::TapeError;
use crate::tape::row::{MOST_REGISTERS, Register, Row};
use crate::tape::source::Source;
use crate::tape::{Routine, Series, Shape};

/// Lengths of the lists that code reads.
pub(super) type Lengths = [usize; Source::ALL.len()];

/// Lengths of these lists; others are empty.
pub(super) fn lengths(of: &[(Source, usize)]) -> Lengths {
    let mut lengths = [0; Source::ALL.len()];
    for &(source, length) in of {
        lengths[source as usize] = length;
    }
    lengths
}

impl Reader<'_> {
    /// All routines: each reads `given` and its own ones of the `arguments`, which have names and lengths.
    pub(super) fn routines(
        &mut self,
        given: &[(Source, usize)],
        arguments: &[(&str, Source, usize)],
    ) -> Result<Vec<Routine>, TapeError> {
        let mut routines: Vec<Routine> = Vec::new();
        while let Some(routine) = self.routine(given, arguments)? {
            if routines.iter().any(|known| known.name == routine.name) {
                return self.error(format!("there are two routines `{}`", routine.name));
            }
            routines.push(routine);
        }
        Ok(routines)
    }

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
            code: self.code(&lengths(&[given, &own].concat()), Some(results))?.chained(),
            arguments: own.into_iter().map(|(source, _)| source).collect(),
            shapes,
        }))
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

    pub(super) fn series(
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

    /// Code of the points and radii of the `outlines`, if there is any.
    pub(super) fn drawing(
        &mut self,
        given: &[(Source, usize)],
        outlines: &[Outline<'_>],
    ) -> Result<Option<Code>, TapeError> {
        let Some((_, "code\tdrawing")) = self.lines.peek() else {
            return Ok(None);
        };
        let numbers = |outline: &Outline<'_>| 3 * outline.points + usize::from(outline.radius);
        let numbers = outlines.iter().map(numbers).sum();
        self.named_code("drawing", &lengths(given), numbers).map(Some)
    }

    pub(super) fn named_code(&mut self, name: &str, lengths: &Lengths, results: usize) -> Result<Code, TapeError> {
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
        let mut given = code.given();
        code.numbers = self.all("number", |reader, [place, value]| {
            match reader.registers(place, registers)?[..] {
                [place] if given.insert(place) => Ok((place, reader.number(value)?)),
                [place] => reader.error(format!(
                    "register {place} has a value already: each number has one of its own, out of {MOST_REGISTERS} at \
                     most"
                )),
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
}
