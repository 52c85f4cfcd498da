//! Declarations of a tape: quantities, the state, constraints, rules.

use std::ops::Range;

use super::Reader;
use crate::constraint::{Constraint, MAX_CONSTRAINTS};
use crate::layout::{Slot, SlotKind, StateVariable};
use crate::shapes::{Outline, ShapeKind};
use crate::tape::error::TapeError;
use crate::tape::row::MOST_REGISTERS;
use crate::tape::{Condition, Quantity, Rule, intern};

/// Coordinates and first-order states.
pub(super) struct State {
    pub(super) slots: Vec<Slot<'static>>,
    pub(super) states: Vec<StateVariable<'static>>,
    /// Places of the rates.
    pub(super) rates: Range<usize>,
    /// Number of components.
    pub(super) length: usize,
}

impl Reader<'_> {
    pub(super) fn quantity(&self, [name, unit, default]: [&str; 3]) -> Result<Quantity, TapeError> {
        let default = (!default.is_empty()).then(|| self.number(default)).transpose()?;
        Ok(Quantity {
            name: self.name(name),
            unit: unit.to_owned(),
            default,
        })
    }

    pub(super) fn state(&mut self) -> Result<State, TapeError> {
        let slots = self.all("slot", Self::slot)?;
        let [positions, rates] = self.places(&slots)?;
        let rates = positions..positions + rates;
        let mut length = rates.end;
        let states = self.all("state", |reader, [name, unit]| {
            length += 1;
            Ok(StateVariable::new(reader.name(name), reader.name(unit), length - 1))
        })?;
        Ok(State {
            slots,
            states,
            rates,
            length,
        })
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

    /// Name of an event, and if it is a kink.
    pub(super) fn event(&self, [name, kind]: [&str; 2]) -> Result<(&'static str, bool), TapeError> {
        match kind {
            "kink" | "smooth" => Ok((self.name(name), kind == "kink")),
            _ => self.error(format!("`{kind}` is no kind of an event")),
        }
    }

    /// Constraints on the components `rates` of the state, and the limits that each has.
    #[allow(clippy::type_complexity, reason = "two lists")]
    pub(super) fn constraints(
        &mut self,
        rates: &Range<usize>,
    ) -> Result<(Vec<Constraint<'static>>, Vec<[bool; 2]>), TapeError> {
        let constraints = self.all("constraint", |reader, fields| reader.constraint(fields, rates))?;
        if constraints.len() > MAX_CONSTRAINTS {
            return self.error(format!("a model has at most {MAX_CONSTRAINTS} constraints"));
        }
        Ok(constraints.into_iter().unzip())
    }

    fn constraint(
        &self,
        [name, rate, limits]: [&str; 3],
        rates: &Range<usize>,
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

    pub(super) fn rule(
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

    pub(super) fn outline(&self, [name, body, kind, points, radius]: [&str; 5]) -> Result<Outline<'static>, TapeError> {
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
}
