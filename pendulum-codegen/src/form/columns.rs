//! Columns of long Jacobians, solved in a loop.
//!
//! The columns of a Jacobian solve linear systems with one mass matrix, by the same operations. Past some thousand
//! operations a processor waits for instructions rather than for numbers, so that code with a loop is faster than
//! without: it is shorter, and the compiler computes several columns at a time.

use super::chosen::Columns;
use super::{Candidate, Chosen, Derivatives, Form};
use crate::dynamics::{Factored, Inverse};
use crate::expr::{Expr, Graph, SymbolKind};
use crate::pass::Operations;

/// Minimum number of operations of a function whose columns are solved in a loop.
const LONG: usize = 2048;

/// Inverse of the minimum share of the operations of a function that a loop takes over: one part in `LEAST_SHARE`.
const LEAST_SHARE: usize = 8;

/// Inverse of the extra operations allowed to code with a loop, which shares nothing among the columns: one part in
/// `WORTH_OF_LOOPS`.
const WORTH_OF_LOOPS: usize = 16;

/// One way to derive accelerations, before the linear systems for their derivatives are solved.
pub(super) struct Unsolved<'g> {
    /// Form of the accelerations alone, without their derivatives.
    pub(super) form: Form,
    pub(super) derivatives: Derivatives,
    pub(super) factored: Factored<'g>,
    /// Accelerations in this form.
    pub(super) accelerations: Vec<Expr<'g>>,
    /// Right-hand sides, column by column.
    pub(super) columns: Vec<Vec<Expr<'g>>>,
}

impl<'g> Unsolved<'g> {
    /// Linear systems, and symbols of their solutions. Columns of zeros are left out.
    pub(super) fn systems(&self, g: &'g Graph) -> (Columns<'g>, Vec<Vec<Expr<'g>>>) {
        let symbol = |name: &str, n: usize, kind: fn(usize) -> SymbolKind| g.symbol(&format!("{name}[{n}]"), kind(n));
        let mut factors = Vec::new();
        let symbolic = self.factored.with_entries(|entry| {
            factors.push(entry);
            symbol("factor", factors.len() - 1, SymbolKind::Factor)
        });
        let rows = self.accelerations.len();
        let column: Vec<Expr<'g>> = (0..rows).map(|row| symbol("given", row, SymbolKind::Given)).collect();
        let (mut count, mut given) = (0, Vec::new());
        let solved = self.columns.iter().map(|column| {
            if column.iter().all(|entry| entry.is_zero()) {
                return column.clone();
            }
            given.extend(column);
            count += 1;
            let first = rows * (count - 1);
            (first..first + rows)
                .map(|n| symbol("solved", n, SymbolKind::Solved))
                .collect()
        });
        let solved = solved.collect();
        let columns = Columns {
            count,
            given: [given, factors].concat(),
            solution: symbolic.solve_negated(&column),
        };
        (columns, solved)
    }
}

/// True if a function is long enough for a loop.
pub(super) fn is_long(chosen: &Chosen<'_>) -> bool {
    chosen.operations.arithmetic() > LONG
}

/// Code with a loop, from the same code without it: `choose` shortens the expressions of the loop together with the
/// other `roots`. Returns `chosen` if the loop takes over few operations, or adds many.
pub(super) fn in_loop<'g>(
    g: &'g Graph,
    chosen: Chosen<'g>,
    columns: Columns<'g>,
    roots: Vec<Expr<'g>>,
    choose: impl FnOnce(Vec<Candidate<'g>>) -> Chosen<'g>,
) -> Chosen<'g> {
    let solution = Operations::of(g, &columns.solution);
    if LEAST_SHARE * columns.count * solution.arithmetic() < chosen.operations.arithmetic() {
        return chosen;
    }
    let all = [&columns.given[..], &roots].concat();
    let Chosen {
        roots: mut given,
        operations,
        ..
    } = choose(vec![(chosen.form, all)]);
    let operations = operations.followed_by(columns.count, solution);
    let [own, least] = [&operations, &chosen.operations].map(Operations::arithmetic);
    if own > least + least / WORTH_OF_LOOPS {
        return chosen;
    }
    let roots = given.split_off(columns.given.len());
    Chosen {
        roots,
        columns: Some(Columns { given, ..columns }),
        operations,
        ..chosen
    }
}
