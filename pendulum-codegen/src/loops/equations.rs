//! Loops that are no triangles: dependent coordinates known by their rates, and these by linear equations.
//!
//! The equations `f(q) = 0` of all that is left are derived: `J v = -K u`, where `v` are the dependent rates and `u`
//! the others. `J` is factored once into orthogonal columns, `J = Q R`, by the modified method of Gram and Schmidt
//! without roots, which no order of the columns and no choice of rows breaks down. There may be more equations than
//! unknowns, of which then some are redundant: they are solved in the sense of least squares, which is exact where they
//! agree. The positions are components of the state, and Newton's method with the same factors closes what rounding and
//! truncation open.

use super::orthogonal::rank;
use super::plane::Loop;
use super::{Cause, Dependent, Open, Orthogonal, ROUNDING, Solver};
use crate::expr::{Derivative, Expr, Level, Normalizer, SymbolKind};
use crate::model::Gap;
use crate::model::{Combination, CoordinateId, Slopes, changes};

/// How far normal forms of equations may grow.
const BUDGET: usize = 10_000;

/// What vanishes where a loop is closed.
pub(super) struct Equation<'g> {
    /// The number of the loop.
    pub(super) number: usize,
    pub(super) value: Expr<'g>,
    pub(super) unit: &'static str,
}

/// The derivatives of all equations.
struct Jacobian<'g> {
    /// A column for each coordinate that depends.
    unknown: Vec<Vec<Expr<'g>>>,
    /// A column for each of the others.
    others: Vec<Vec<Expr<'g>>>,
}

impl<'g> Solver<'g, '_> {
    /// Closes all loops that are left by the coordinates that are left.
    pub(super) fn solve_together(&mut self, loops: &[Option<Loop<'g>>], left: &[usize]) -> Result<(), Open> {
        let free = self.tree.independent();
        let equations = self.equations(loops, left);
        let rows: Vec<Expr<'g>> = equations.iter().map(|equation| equation.value).collect();
        let unknown = self.take_unknown();
        let jacobian = Jacobian {
            unknown: unknown.iter().map(|&n| self.column(&rows, free + n)).collect(),
            others: (0..free).map(|j| self.column(&rows, j)).collect(),
        };
        let values = self.tree.with_drives(&rows);
        self.check_equations(&equations)?;
        let of_first = |cause| Open { number: left[0], cause };
        jacobian.check_columns().map_err(of_first)?;
        let factored = Orthogonal::new(&jacobian.unknown);
        self.corrections = factored.solve(values.iter().map(|&value| -value).collect());
        self.closings = rows.clone();
        self.gaps = self.gaps_of(&equations, loops, left);
        let margin = factored.volume(&jacobian.unknown);
        left.iter().for_each(|&n| self.margins[n] = margin);
        self.assemble(&unknown, &equations)?;
        self.check_turned()?;
        self.check_rank(&jacobian).map_err(of_first)?;
        self.set_rates_together(&unknown, &rows, &jacobian, &factored);
        Ok(())
    }

    /// The places of the coordinates that are left. Their positions are in the state from now on.
    fn take_unknown(&mut self) -> Vec<usize> {
        let free = self.tree.independent();
        let unknown: Vec<usize> = (0..self.declared.len())
            .filter(|&n| self.dependents[n].is_none())
            .collect();
        for &n in &unknown {
            self.combinations[n] = Some(Combination::one(CoordinateId::new(free + n)));
            self.dependents[n] = Some(Dependent {
                coordinate: self.declared[n].coordinate.clone(),
                slopes: Slopes {
                    slopes: vec![self.graph.zero(); free],
                    drift: self.graph.zero(),
                    in_state: true,
                },
            });
        }
        unknown
    }

    /// Gives the unknowns their rates and second rates.
    fn set_rates_together(
        &mut self,
        unknown: &[usize],
        rows: &[Expr<'g>],
        jacobian: &Jacobian<'g>,
        factored: &Orthogonal<'g>,
    ) {
        let mut slopes: Vec<Vec<Expr<'g>>> = vec![Vec::new(); unknown.len()];
        for (j, column) in jacobian.others.iter().enumerate() {
            let names = unknown.iter().map(|&n| self.slope_name(n, j)).collect();
            let push = column.iter().map(|&x| -x).collect();
            let solved = self.solved(factored, &jacobian.unknown, names, push);
            slopes.iter_mut().zip(solved).for_each(|(row, slope)| row.push(slope));
        }
        for (&n, row) in unknown.iter().zip(slopes) {
            self.set_slopes(n, row, Vec::new());
        }
        let bend = self.bend(rows);
        let names = unknown.iter().map(|&n| self.drift_name(n)).collect();
        let push = bend.into_iter().map(|x| -x).collect();
        let drifts = self.solved(factored, &jacobian.unknown, names, push);
        for (&n, drift) in unknown.iter().zip(drifts) {
            self.set_drift(n, drift);
        }
    }

    /// What vanishes where the loops are closed. What does so anyway is left out.
    fn equations(&self, loops: &[Option<Loop<'g>>], left: &[usize]) -> Vec<Equation<'g>> {
        let mut all = Vec::new();
        for &number in left {
            let equation = |value, unit| Equation { number, value, unit };
            let rows: Vec<Equation<'g>> = match &loops[number] {
                Some(around) => {
                    let sum = around.0.iter().map(|piece| self.vector(piece)).reduce(|a, b| a + b);
                    let rows = sum.into_iter().flat_map(|sum| sum.0);
                    rows.map(|row| equation(row, "m")).collect()
                }
                None => {
                    let rows = self.tree.closures[number].equations(self.tree);
                    rows.into_iter().map(|row| equation(row.value, row.unit)).collect()
                }
            };
            for mut equation in rows {
                equation.value = self.shorter(equation.value);
                if !vanishes(equation.value) {
                    all.push(equation);
                }
            }
        }
        all
    }

    /// What does not change must vanish.
    fn check_equations(&self, equations: &[Equation<'g>]) -> Result<(), Open> {
        let constant = equations
            .iter()
            .filter(|equation| equation.value.level() < Level::State);
        let mut missing = constant.filter(|equation| self.is_known() || equation.value.constant().is_some());
        let Some(&Equation { number, value, unit }) = missing.next() else {
            return Ok(());
        };
        let by = self.number(value).abs();
        let cause = if by < ROUNDING {
            Cause::ClosedByChance
        } else {
            Cause::AlwaysOpen { by, unit }
        };
        Err(Open { number, cause })
    }

    /// The derivatives by a coordinate where those that are left stand still.
    fn column(&self, rows: &[Expr<'g>], k: usize) -> Vec<Expr<'g>> {
        let own = self.coordinate(CoordinateId::new(k)).changes.iter().copied();
        let solved = self
            .dependents
            .iter()
            .flatten()
            .filter(|dependent| !dependent.slopes.in_state);
        let dependents =
            solved.filter_map(|dependent| Some((dependent.coordinate.position, *dependent.slopes.slopes.get(k)?)));
        let mut along = Derivative::along(own.chain(dependents));
        let column: Vec<Expr<'g>> = rows.iter().map(|&row| along.of(row)).collect();
        self.tree.with_drives(&column)
    }

    /// The second derivatives by the time where nothing accelerates by itself.
    fn bend(&self, rows: &[Expr<'g>]) -> Vec<Expr<'g>> {
        let zero = self.graph.zero();
        let of_others = self
            .tree
            .coordinates
            .iter()
            .chain(self.tree.drives.iter().map(|drive| &drive.coordinate));
        let dependents: Vec<&Dependent<'g>> = self.dependents.iter().flatten().collect();
        let all = of_others
            .clone()
            .chain(dependents.iter().map(|dependent| &dependent.coordinate));
        let velocities = changes(all);
        let mut along = Derivative::along(velocities.clone());
        let rates: Vec<Expr<'g>> = rows.iter().map(|&row| along.of(row)).collect();
        let of_rates = of_others.map(|coordinate| (coordinate.rate, zero));
        let of_dependents = dependents
            .iter()
            .map(|dependent| (dependent.coordinate.rate, dependent.slopes.drift));
        let mut along = Derivative::along(velocities.into_iter().chain(of_rates).chain(of_dependents));
        let bends: Vec<Expr<'g>> = rates.iter().map(|&rate| along.of(rate)).collect();
        self.tree.with_drives(&bends)
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
                .is_some_and(|symbol| matches!(symbol.kind, SymbolKind::Dependent(_)))
            {
                self.graph.set_changes(symbol, changes, false);
            }
        }
        symbols
    }

    /// What a solution may depend on, each with a name that can be part of another.
    fn variables(&self) -> Vec<(String, Expr<'g>)> {
        let in_state = self
            .dependents
            .iter()
            .flatten()
            .filter(|dependent| dependent.slopes.in_state);
        let in_state = in_state.map(|dependent| dependent.coordinate.position);
        let positions = changes(self.tree.coordinates.iter()).into_iter().map(|(x, _)| x);
        let rates = self.tree.coordinates.iter().map(|c| c.rate);
        let symbols = positions.chain(rates).chain(in_state);
        let symbols = symbols.chain(self.parameters()).chain([self.tree.time]);
        let named = |symbol: Expr<'g>| {
            let name = symbol.as_symbol()?.name.replace(['.', '('], "_").replace(')', "");
            Some((name, symbol))
        };
        symbols.filter_map(named).collect()
    }

    /// Newton's method from the guess.
    fn assemble(&mut self, unknown: &[usize], equations: &[Equation<'g>]) -> Result<(), Open> {
        /// How often a correction is made.
        const CORRECTIONS: usize = 100;
        /// The longest correction.
        const LONGEST: f64 = 0.3;
        /// A correction that is rounding.
        const SHORTEST: f64 = 1e-12;
        if !self.is_known() {
            return Ok(());
        }
        let free = self.tree.independent();
        for _ in 0..CORRECTIONS {
            let corrections = self.numbers_of(&self.corrections);
            let size = corrections.iter().fold(0.0, |size: f64, x| size.max(x.abs()));
            let factor = (LONGEST / size).min(1.0);
            for (&n, correction) in unknown.iter().zip(corrections) {
                self.assembled[free + n] += factor * correction;
            }
            if size < SHORTEST {
                break;
            }
        }
        let rows: Vec<Expr<'g>> = equations.iter().map(|equation| equation.value).collect();
        let misses = self.numbers_of(&rows).into_iter().map(f64::abs);
        let worst = equations.iter().zip(misses).max_by(|(_, a), (_, b)| a.total_cmp(b));
        match worst {
            Some((&Equation { number, unit, .. }, by)) if by.is_nan() || by > ROUNDING => {
                let cause = match by.is_nan() {
                    // no correction exists where the loop is flat
                    true => Cause::AtToggle,
                    false => Cause::NotAssembled { by, unit },
                };
                Err(Open { number, cause })
            }
            _ => Ok(()),
        }
    }

    /// Where they are assembled, the frames must be as they are declared: some equations vanish after half a turn too.
    fn check_turned(&self) -> Result<(), Open> {
        let angle = |gap: &Gap<'g>| (gap.number, self.number(gap.angle));
        let mut turned = self.gaps.iter().map(angle).filter(|(_, by)| *by > ROUNDING);
        match turned.next().filter(|_| self.is_known()) {
            Some((number, by)) => Err(Open {
                number,
                cause: Cause::Turned { by },
            }),
            None => Ok(()),
        }
    }

    /// Where they are assembled the loops must determine those coordinates that depend, and no more.
    fn check_rank(&self, jacobian: &Jacobian<'g>) -> Result<(), Cause> {
        if !self.is_known() {
            return Ok(());
        }
        let numbers = |columns: &[Vec<Expr<'g>>]| columns.iter().map(|column| self.numbers_of(column)).collect();
        let own: Vec<Vec<f64>> = numbers(&jacobian.unknown);
        let others: Vec<Vec<f64>> = numbers(&jacobian.others);
        let all = rank([&own[..], &others].concat());
        if all != own.len() {
            return Err(Cause::Determines(all));
        }
        if rank(own) < all {
            return Err(Cause::DeterminesOthers);
        }
        Ok(())
    }
}

impl Jacobian<'_> {
    /// Each coordinate that depends must move a loop.
    fn check_columns(&self) -> Result<(), Cause> {
        if self
            .unknown
            .first()
            .is_none_or(|column| column.len() < self.unknown.len())
        {
            let rows = self.unknown.iter().chain(&self.others).map(Vec::len).max();
            return Err(Cause::Determines(rows.unwrap_or(0)));
        }
        let stands_still = |column: &Vec<Expr<'_>>| column.iter().all(|entry| entry.is_zero());
        if self.unknown.iter().any(stands_still) {
            return Err(Cause::DeterminesOthers);
        }
        Ok(())
    }
}

/// Whether a value is zero in all states, be it only up to rounding where it is one number.
fn vanishes(value: Expr<'_>) -> bool {
    value.constant().is_some_and(|x| x.abs() < ROUNDING)
        || Normalizer::new(value.graph(), BUDGET).is_zero(value) == Ok(true)
}
