//! Tapes from their text.

mod declared;
mod program;

use std::iter::{Enumerate, Peekable};
use std::str::{FromStr, Lines};

use super::error::TapeError;
use super::source::Source;
use super::{Tape, intern};
use crate::layout::SlotKind;
use declared::State;
use program::lengths;

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
        let (parameters, inputs) = (
            self.all("parameter", Self::quantity)?,
            self.all("input", Self::quantity)?,
        );
        let State {
            slots,
            states,
            rates,
            length,
        } = self.state()?;
        let autonomous = self.next_if::<0>("autonomous")?.is_some();
        let text = |reader: &Self, [name]: [&str; 1]| Ok(reader.name(name));
        let loops = self.all("loop", |reader, names: [&str; 2]| {
            Ok(names.map(|name| reader.name(name)))
        })?;
        let [open] = self.next("open_loops")?;
        let open_loops = self.numbers_below(open, loops.len(), "loop")?;
        let (uncounted, outputs) = (self.all("uncounted", text)?, self.all("output", text)?);
        let events = self.all("event", Self::event)?;
        let (constraints, limits) = self.constraints(&rates)?;
        let rules = self.all("rule", |reader, fields| reader.rule(fields, &parameters))?;
        let constants_text = self.all("constant", text)?;
        let of_parameters = lengths(&[(Source::Parameter, parameters.len())]);
        let checked = rules.iter().flat_map(|rule| &rule.values).max();
        let checked = self.named_code("checked", &of_parameters, checked.map_or(0, |most| most + 1))?;
        let constants = self.named_code("constants", &of_parameters, constants_text.len())?;
        let of_constants = (Source::Constant, constants_text.len());
        let numbers = 4 * constraints.len() + limits.iter().flatten().filter(|is| **is).count();
        let laws = self.named_code("laws", &lengths(&[of_constants]), numbers)?;
        let given = [of_constants, (Source::State, length), (Source::Time, 1)];
        let arguments = [
            ("inputs", Source::Input, inputs.len()),
            ("forces", Source::Force, constraints.len()),
            ("accelerations", Source::Acceleration, rates.len()),
            ("weights", Source::Weight, length),
            ("direction", Source::Direction, length + inputs.len()),
        ];
        let routines = self.routines(&given, &arguments)?;
        let series = self.series(&given, length, constraints.len())?;
        let outlines = self.all("outline", Self::outline)?;
        let drawing = self.drawing(&given, &outlines)?;
        let oriented = slots.iter().filter(|slot| slot.kind == SlotKind::Quaternion);
        let orientations = oriented.map(|slot| [slot.positions.start, slot.rates.start]);
        Ok(Tape {
            name,
            parameters,
            inputs,
            orientations: orientations.collect(),
            slots,
            states,
            autonomous,
            loops,
            open_loops,
            uncounted,
            outputs,
            events,
            limits,
            constraints,
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
}
