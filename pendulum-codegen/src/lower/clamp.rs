//! Clamped values, and the events of their saturation.

use super::Lower;
use super::expr::{Only, Place};
use super::measure::Quantity;
use super::written::written;
use crate::ast;
use crate::error::{Code, Reported};
use crate::expr::{Binary, Expr, Level, SymbolKind};
use crate::model::{Event, Requirement};
use crate::program;

impl<'g> Lower<'g> {
    /// `clamp(x, low, high)`
    pub(super) fn clamp(
        &mut self,
        expr: &ast::Expr,
        arguments: &[ast::Expr],
        place: &Place<'g>,
    ) -> Result<Quantity<'g>, Reported> {
        let [x, low, high] = arguments else {
            let fact = format_args!("`clamp` takes 3 arguments, not {}", arguments.len());
            return Err(self
                .errors
                .on(Code::Arguments, expr, fact, "write `clamp(x, low, high)`"));
        };
        let [value, from, to] = [x, low, high].map(|e| self.operation(e, place));
        let (value, from, to) = (value?, from?, to?);
        let mut measure = value.measure;
        for (e, limit) in [(low, from), (high, to)] {
            measure = self.require_alike([x, e], [measure, limit.measure], "compared");
        }
        let clamped = [value.value, from.value, to.value];
        self.require_order(expr, [low, high], clamped, &place.what)?;
        if place.only == Only::All {
            self.note_clamp(clamped);
        }
        let [x, low, high] = clamped;
        let value = x.combine(Binary::Max, low).combine(Binary::Min, high);
        Ok(Quantity { value, measure })
    }

    /// Requires that the lower limit is below the upper one.
    fn require_order(
        &mut self,
        expr: &ast::Expr,
        limits: [&ast::Expr; 2],
        [_, low, high]: [Expr<'g>; 3],
        what: &str,
    ) -> Result<(), Reported> {
        let [from, to] = limits.map(|e| written(e, None).to_string());
        let fact = if low == high {
            format!("the limits of `clamp` in {what} are equal: {from} and {to}")
        } else {
            format!("the limits of `clamp` in {what} are reversed: {from} and {to}")
        };
        let rule = format!("the limits of `clamp` in {what} must be in order: {from} below {to}");
        let help = "write `clamp(x, low, high)`, the lower limit first";
        let checked = (high - low, Requirement::Positive);
        self.obeys(Code::OutOfBounds, expr, checked, [&fact, help, &rule])
    }

    /// Records a clamped value for a saturation event, if it depends on the state but not on inputs.
    fn note_clamp(&mut self, clamp: [Expr<'g>; 3]) {
        let varies = clamp.iter().any(|x| x.level() == Level::State);
        let mut symbols = self.graph.symbols_of(&clamp);
        let takes_inputs = symbols.any(|symbol| matches!(symbol.kind, SymbolKind::Input(_)));
        if varies && !takes_inputs && !self.clamps.contains(&clamp) {
            self.clamps.push(clamp);
        }
    }

    /// Events of the values that saturate.
    pub(super) fn saturations(&self) -> impl Iterator<Item = Event<'g>> {
        self.clamps.iter().enumerate().map(|(n, &[x, low, high])| Event {
            name: program::saturation(n),
            docs: vec!["`(x - low)*(high - x)` of a `clamp(x, low, high)`: positive between the limits.".to_owned()],
            value: (x - low) * (high - x),
            is_kink: true,
        })
    }
}
