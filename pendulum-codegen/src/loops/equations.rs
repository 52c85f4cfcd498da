//! Loops that are not triangles: dependent coordinates are integrated from their rates, and the rates solved from
//! linear equations.
//!
//! The remaining closure equations `f(q) = 0` are differentiated: `J v = -K u`, where `v` are the dependent rates and
//! `u` the others. `J` is factored once into orthogonal columns, `J = Q R`, by the modified Gram-Schmidt method without
//! square roots, which does not break down for any order of the columns or choice of rows. There may be more equations
//! than unknowns; the redundant system is solved by least squares, which is exact if the equations are consistent. The
//! positions are components of the state, and Newton's method with the same factors corrects the drift due to rounding
//! and truncation.

use super::orthogonal::rank;
use super::plane::Loop;
use super::{Cause, Dependent, Open, Orthogonal, ROUNDING, Solver};
use crate::expr::{Derivative, Expr, Level, Normalizer, SymbolKind};
use crate::model::Gap;
use crate::model::{Combination, CoordinateId, Slopes, changes};

/// Maximum number of products of terms in the normal form of an equation.
const BUDGET: usize = 10_000;

/// A closure equation, zero if the loop is closed.
pub(super) struct Equation<'g> {
    /// Index of the loop.
    pub(super) number: usize,
    pub(super) value: Expr<'g>,
    pub(super) unit: &'static str,
}

/// Jacobian of all equations.
struct Jacobian<'g> {
    /// One column for each dependent coordinate.
    unknown: Vec<Vec<Expr<'g>>>,
    /// One column for each independent coordinate.
    others: Vec<Vec<Expr<'g>>>,
}

impl<'g> Solver<'g, '_> {
    /// Closes all remaining loops with the remaining coordinates.
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

    /// Returns the indices of the remaining coordinates. From now on their positions are components of the state.
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

    /// Sets the rates and accelerations of the unknowns.
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

    /// Closure equations of the loops, without those that vanish identically.
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

    /// Checks that constant equations vanish.
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

    /// Derivatives with respect to a coordinate, with the remaining coordinates fixed.
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

    /// Second time derivatives while no independent coordinate accelerates.
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

    /// Returns symbols for the solution `x` of `J x = b`, with their derivatives from `J dx = db - dJ x`.
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

    /// Variables that a solution may depend on, each with a name to use within other names.
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

    /// Assembles the loops by Newton's method from the guess.
    fn assemble(&mut self, unknown: &[usize], equations: &[Equation<'g>]) -> Result<(), Open> {
        /// Maximum number of Newton steps.
        const CORRECTIONS: usize = 100;
        /// Maximum change of a coordinate in one step, in rad or m.
        const LONGEST: f64 = 0.3;
        /// Change of the coordinates at convergence, in rad or m.
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
                    // no correction exists at a singularity
                    true => Cause::AtToggle,
                    false => Cause::NotAssembled { by, unit },
                };
                Err(Open { number, cause })
            }
            _ => Ok(()),
        }
    }

    /// Checks that the assembled frames are oriented as declared: some equations vanish after half a turn too.
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

    /// Checks that the assembled loops determine the dependent coordinates, and no others.
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
    /// Checks that each dependent coordinate moves a loop.
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

/// True if a value is zero in all states; a number may differ from zero by rounding.
fn vanishes(value: Expr<'_>) -> bool {
    value.constant().is_some_and(|x| x.abs() < ROUNDING)
        || Normalizer::new(value.graph(), BUDGET).is_zero(value) == Ok(true)
}
