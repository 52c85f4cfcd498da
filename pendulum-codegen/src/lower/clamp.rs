//! Clamped values, and the events of their saturation.

use super::Lower;
use super::expr::{Only, Place};
use super::measure::Quantity;
use super::written::written;
use crate::ast;
use crate::error::{Code, Reported};
use crate::expr::{Binary, Expr, Level, SymbolKind, Unary, ratio};
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
        let given = [x, low, high].map(|e| self.operation(e, place));
        let [value, from, to] = given;
        let (value, from, to) = (value?, from?, to?);
        let mut measure = value.measure;
        for (e, limit) in [(low, from), (high, to)] {
            measure = self.require_alike([x, e], [measure, limit.measure], "compared");
        }
        let (from, to) = (from.value, to.value);
        let [low, high] = [low, high].map(|e| written(e, None).to_string());
        let fact = format!(
            "`clamp` in {} has its limits the wrong way round: from {low} to {high}",
            place.what
        );
        let rule = format!(
            "the limits of `clamp` in {} must be in order: {low} below {high}",
            place.what
        );
        let checked = (to - from, Requirement::Positive);
        self.obeys(
            Code::OutOfBounds,
            expr,
            checked,
            [&fact, "write `clamp(x, low, high)`, the lower limit first", &rule],
        )?;
        if place.only == Only::All {
            self.note_clamp([value.value, from, to]);
        }
        let value = value.value.combine(Binary::Max, from).combine(Binary::Min, to);
        Ok(Quantity { value, measure })
    }

    /// Records a clamped value for a saturation event, if it depends on the state but not on inputs.
    fn note_clamp(&mut self, clamp: [Expr<'g>; 3]) {
        let is_input = |kind| matches!(kind, SymbolKind::Input(_));
        let mut symbols = self.graph.symbols_of(&clamp);
        if clamp[0].level() == Level::State
            && !symbols.any(|symbol| is_input(symbol.kind))
            && !self.clamps.contains(&clamp)
        {
            self.clamps.push(clamp);
        }
    }

    /// Events of the values that saturate.
    pub(super) fn saturations(&self) -> impl Iterator<Item = Event<'g>> {
        let half = || ratio(1, 2);
        self.clamps.iter().enumerate().map(move |(n, &[x, low, high])| {
            let (middle, reach) = (half() * (low + high), half() * (high - low));
            Event {
                name: program::saturation(n),
                docs: vec![
                    "The distance of the argument of a `clamp` from its nearer limit, positive between them."
                        .to_owned(),
                ],
                value: reach - (x - middle).apply(Unary::Abs),
                is_kink: true,
            }
        })
    }
}
