//! Loops that are no triangles: positions that follow by their rates, and rates by linear equations.
//!
//! The equations `f(q) = 0` of all that is left are derived: `J v = -K u`, where `v` are the rates that follow and `u` the others. `J` is
//! factored once into orthogonal columns, `J = Q R`, by the modified method of Gram and Schmidt without roots, which no order of the
//! columns and no choice of rows breaks down. There may be more equations than unknowns, of which then some are redundant: they are
//! solved in the sense of least squares, which is exact where they agree. The positions are components of the state, and Newton's method
//! with the same factors closes what rounding and truncation open.

use super::{Open, Orthogonal, Solver};
use crate::expr::{Derivative, Expr, Level, Normalizer, SymbolKind};
use crate::model::closure::{Loop, Row};
use crate::model::{Combination, CoordinateId, Dependent, changes};

/// How far normal forms of equations may grow.
const BUDGET: usize = 10_000;

/// What vanishes where a loop is closed.
struct Equation<'g> {
    /// The number of the loop.
    number: usize,
    value: Expr<'g>,
    unit: &'static str,
}

impl Equation<'_> {
    fn miss(&self, by: f64) -> Open {
        Open::TooShort(self.number, by.abs(), self.unit)
    }
}

impl<'g> Solver<'g, '_> {
    /// Closes all loops that are left by the coordinates that are left.
    pub(super) fn solve_together(&mut self, loops: &[Option<Loop<'g>>], left: &[usize]) -> Result<(), Open> {
        let free = self.model.independent();
        let equations = self.equations(loops, left);
        let rows: Vec<Expr<'g>> = equations.iter().map(|equation| equation.value).collect();
        let unknown: Vec<usize> = (0..self.declared.len())
            .filter(|&n| self.dependents[n].is_none())
            .collect();
        for &n in &unknown {
            let coordinate = self.declared[n].coordinate.clone();
            self.combinations[n] = Some(Combination::one(CoordinateId::new(free + n)));
            self.dependents[n] = Some(Dependent {
                coordinate,
                slopes: vec![self.graph.zero(); free],
                drift: self.graph.zero(),
                in_state: true,
            });
        }
        let of_unknown: Vec<Vec<Expr<'g>>> = unknown.iter().map(|&n| self.column(&rows, free + n)).collect();
        let of_others: Vec<Vec<Expr<'g>>> = (0..free).map(|j| self.column(&rows, j)).collect();
        let values = self.model.with_drives(&rows);
        self.check_equations(&equations)?;
        self.check_columns(left[0], [&of_unknown, &of_others])?;
        let factored = Orthogonal::new(&of_unknown);
        self.corrections = factored.solve(values.iter().map(|&value| -value).collect());
        self.closings = rows.clone();
        let margin = factored.volume(&of_unknown);
        left.iter().for_each(|&n| self.margins[n] = margin);
        self.assemble(&unknown, &equations)?;
        self.check_rank(left[0], [&of_unknown, &of_others])?;

        let mut slopes: Vec<Vec<Expr<'g>>> = vec![Vec::new(); unknown.len()];
        for (j, column) in of_others.iter().enumerate() {
            let names = unknown.iter().map(|&n| self.slope_name(n, j)).collect();
            let push = column.iter().map(|&x| -x).collect();
            let solved = self.solved(&factored, &of_unknown, names, push);
            slopes.iter_mut().zip(solved).for_each(|(row, slope)| row.push(slope));
        }
        for (&n, row) in unknown.iter().zip(slopes) {
            self.set_slopes(n, row, Vec::new());
        }
        let bend = self.bend(&rows);
        let names = unknown.iter().map(|&n| self.drift_name(n)).collect();
        let push = bend.into_iter().map(|x| -x).collect();
        let drifts = self.solved(&factored, &of_unknown, names, push);
        for (&n, drift) in unknown.iter().zip(drifts) {
            self.set_drift(n, drift);
        }
        Ok(())
    }

    /// What vanishes where the loops are closed, each with the number of its loop. What does so anyway is left out.
    fn equations(&self, loops: &[Option<Loop<'g>>], left: &[usize]) -> Vec<Equation<'g>> {
        let mut all = Vec::new();
        for &number in left {
            let rows: Vec<(Expr<'g>, &str)> = match &loops[number] {
                Some(around) => {
                    let pieces = around.0.iter().map(|piece| self.vector(piece));
                    let sum = pieces.reduce(|sum, piece| sum + piece);
                    sum.into_iter().flat_map(|sum| sum.0).map(|row| (row, "m")).collect()
                }
                None => {
                    let rows = self.model.closures[number].equations(self.model);
                    rows.into_iter().map(|Row { value, unit, .. }| (value, unit)).collect()
                }
            };
            let always = |row: Expr<'g>| Normalizer::new(self.graph, BUDGET).is_zero(row) == Ok(true);
            let equation = |(row, unit)| {
                let value = self.shorter(row);
                (!always(value)).then_some(Equation { number, value, unit })
            };
            all.extend(rows.into_iter().filter_map(equation));
        }
        all
    }

    /// What does not change must vanish.
    fn check_equations(&self, equations: &[Equation<'g>]) -> Result<(), Open> {
        let constant = equations
            .iter()
            .filter(|equation| equation.value.level() < Level::State);
        let missing = constant.filter(|equation| self.is_known() || equation.value.constant().is_some());
        match missing
            .map(|equation| equation.miss(self.number(equation.value)))
            .next()
        {
            Some(open) => Err(open),
            None => Ok(()),
        }
    }

    /// The derivatives by a coordinate where those that are left stand still.
    fn column(&self, rows: &[Expr<'g>], k: usize) -> Vec<Expr<'g>> {
        let own = self.coordinate(CoordinateId::new(k)).changes.iter().copied();
        let solved = self.dependents.iter().flatten().filter(|dependent| !dependent.in_state);
        let following = solved.filter_map(|dependent| Some((dependent.coordinate.position, *dependent.slopes.get(k)?)));
        let mut along = Derivative::along(own.chain(following));
        let column: Vec<Expr<'g>> = rows.iter().map(|&row| along.of(row)).collect();
        self.model.with_drives(&column)
    }

    /// The second derivatives by the time where nothing accelerates by itself.
    fn bend(&self, rows: &[Expr<'g>]) -> Vec<Expr<'g>> {
        let zero = self.graph.zero();
        let of_others = self
            .model
            .coordinates
            .iter()
            .chain(self.model.drives.iter().map(|drive| &drive.coordinate));
        let following: Vec<&Dependent<'g>> = self.dependents.iter().flatten().collect();
        let all = of_others
            .clone()
            .chain(following.iter().map(|dependent| &dependent.coordinate));
        let velocities = changes(all);
        let mut along = Derivative::along(velocities.clone());
        let rates: Vec<Expr<'g>> = rows.iter().map(|&row| along.of(row)).collect();
        let of_rates = of_others.map(|coordinate| (coordinate.rate, zero));
        let of_following = following
            .iter()
            .map(|dependent| (dependent.coordinate.rate, dependent.drift));
        let mut along = Derivative::along(velocities.into_iter().chain(of_rates).chain(of_following));
        let bends: Vec<Expr<'g>> = rates.iter().map(|&rate| along.of(rate)).collect();
        self.model.with_drives(&bends)
    }

    /// Symbols for the solution `x` of `J x = b`, which know their derivatives: `J dx = db - dJ x`.
    fn solved(
        &mut self,
        factored: &Orthogonal<'g>,
        matrix: &[Vec<Expr<'g>>],
        names: Vec<String>,
        b: Vec<Expr<'g>>,
    ) -> Vec<Expr<'g>> {
        let solution = factored.solve(b.clone());
        let symbols: Vec<Expr<'g>> = names
            .iter()
            .zip(solution)
            .map(|(name, x)| self.named(name, x))
            .collect();
        let mut changes: Vec<Vec<(Expr<'g>, Expr<'g>)>> = vec![Vec::new(); symbols.len()];
        for (by, variable) in self.variables() {
            let mut derivative = Derivative::by(variable);
            let mut push: Vec<Expr<'g>> = b.iter().map(|&b| derivative.of(b)).collect();
            for (column, &x) in matrix.iter().zip(&symbols) {
                for (push, &entry) in push.iter_mut().zip(column) {
                    *push -= derivative.of(entry) * x;
                }
            }
            if push.iter().all(|push| push.is_zero()) {
                continue;
            }
            for (n, change) in factored.solve(push).into_iter().enumerate() {
                let change = self.named(&format!("{}_by_{by}", names[n]), change);
                changes[n].push((variable, change));
            }
        }
        for (&symbol, changes) in symbols.iter().zip(&changes) {
            if symbol
                .as_symbol()
                .is_some_and(|symbol| matches!(symbol.kind, SymbolKind::Following(_)))
            {
                self.graph.set_changes(symbol, changes, false);
            }
        }
        symbols
    }

    /// What a solution may depend on, each with a name that can be part of another.
    fn variables(&self) -> Vec<(String, Expr<'g>)> {
        let in_state = self.dependents.iter().flatten().filter(|dependent| dependent.in_state);
        let in_state = in_state.map(|dependent| dependent.coordinate.position);
        let symbols = self.model.state().into_iter().chain(in_state);
        let symbols = symbols.chain(self.parameters()).chain([self.model.time]);
        let named = |symbol: Expr<'g>| {
            let name = symbol.as_symbol()?.name.replace(['.', '('], "_").replace(')', "");
            Some((name, symbol))
        };
        symbols.filter_map(named).collect()
    }

    /// Each coordinate that depends must move a loop.
    fn check_columns(&self, at: usize, [of_unknown, of_others]: [&[Vec<Expr<'g>>]; 2]) -> Result<(), Open> {
        let moves = |column: &&Vec<Expr<'g>>| !column.iter().all(|entry| entry.is_zero());
        let moving = of_unknown.iter().filter(moves).count();
        if of_unknown.first().is_none_or(|column| column.len() < of_unknown.len()) {
            let rows = of_unknown.iter().chain(of_others).map(Vec::len).max();
            return Err(Open::Determine(at, rows.unwrap_or(0)));
        }
        if moving < of_unknown.len() {
            return Err(Open::Others(at));
        }
        Ok(())
    }

    /// Newton's method from the guess.
    fn assemble(&mut self, unknown: &[usize], equations: &[Equation<'g>]) -> Result<(), Open> {
        /// How often a correction is made, and the longest of them.
        const MOST: (usize, f64) = (100, 0.3);
        /// The corrections that are rounding, and how far the loops may then be open.
        const LEAST: (f64, f64) = (1e-12, 1e-9);
        if !self.is_known() {
            return Ok(());
        }
        let free = self.model.independent();
        for _ in 0..MOST.0 {
            let corrections = self.numbers_of(&self.corrections);
            let size = corrections.iter().fold(0.0, |size: f64, x| size.max(x.abs()));
            let factor = (MOST.1 / size).min(1.0);
            for (&n, correction) in unknown.iter().zip(corrections) {
                self.assembled[free + n] += factor * correction;
            }
            if size < LEAST.0 {
                break;
            }
        }
        let rows: Vec<Expr<'g>> = equations.iter().map(|equation| equation.value).collect();
        let misses = equations.iter().zip(self.numbers_of(&rows));
        let worst = misses.max_by(|(_, a), (_, b)| a.abs().total_cmp(&b.abs()));
        match worst.filter(|(_, by)| by.is_nan() || by.abs() > LEAST.1) {
            Some((equation, by)) => Err(equation.miss(by)),
            None => Ok(()),
        }
    }

    /// Where they are assembled the loops must determine those coordinates that depend, and no more.
    fn check_rank(&self, at: usize, [of_unknown, of_others]: [&[Vec<Expr<'g>>]; 2]) -> Result<(), Open> {
        if !self.is_known() {
            return Ok(());
        }
        let numbers = |columns: &[Vec<Expr<'g>>]| columns.iter().map(|column| self.numbers_of(column)).collect();
        let own: Vec<Vec<f64>> = numbers(of_unknown);
        let others: Vec<Vec<f64>> = numbers(of_others);
        let all = rank([&own[..], &others].concat());
        if all != own.len() {
            return Err(Open::Determine(at, all));
        }
        if rank(own) < of_unknown.len() {
            return Err(Open::Others(at));
        }
        Ok(())
    }
}

/// How many of the columns are no sums of others, up to rounding.
fn rank(mut columns: Vec<Vec<f64>>) -> usize {
    const ROUNDING: f64 = 1e-9;
    let square = |column: &[f64]| column.iter().map(|x| x * x).sum::<f64>();
    let largest = columns.iter().map(|column| square(column)).fold(0.0, f64::max);
    let mut rank = 0;
    while let Some(at) = (0..columns.len()).max_by(|&a, &b| square(&columns[a]).total_cmp(&square(&columns[b]))) {
        let own = columns.swap_remove(at);
        let size = square(&own);
        if size <= ROUNDING * ROUNDING * largest || size == 0.0 {
            break;
        }
        rank += 1;
        for column in &mut columns {
            let share = own.iter().zip(&*column).map(|(a, b)| a * b).sum::<f64>() / size;
            column.iter_mut().zip(&own).for_each(|(x, y)| *x -= share * y);
        }
    }
    rank
}
