//! What closed loops make of the coordinates that are declared to depend on others.
//!
//! Loops are solved one after the other as long as one is a [triangle]; what is left is solved together, [by linear
//! equations].
//!
//! [triangle]: triangle
//! [by linear equations]: equations

mod assembled;
mod equations;
mod gap;
mod meeting;
mod orthogonal;
mod plane;
mod triangle;
mod turns;

pub(crate) use orthogonal::Orthogonal;
pub(crate) use plane::{Loop, NoPlane, parallel};
use turns::Counted;

use rustc_hash::FxHashMap;

use crate::expr::{Expr, ExprId, Graph, Level, Normalizer, Rational, SymbolKind};
use crate::model::{Combination, Coordinate, CoordinateId, Dependence, Gap, Loops, Slopes, Tree, Uncounted};

/// A dependent coordinate as it is declared.
#[derive(Clone, Debug)]
pub(crate) struct Declared<'g> {
    /// Its name and symbols.
    pub coordinate: Coordinate<'g>,
    /// Its value where the loops are assembled.
    pub near: Expr<'g>,
}

/// Why loops cannot be closed.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Open {
    /// The number of a loop that cannot.
    pub number: usize,
    pub cause: Cause,
}

/// What keeps a loop open where it is assembled.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Cause {
    /// The sides of its triangle are by this length too short to meet, or one of them too long.
    TooShort { by: f64 },
    /// It is at its toggle.
    AtToggle,
    /// Its guess is as near to one assembly as to the other.
    Undecided,
    /// Its ends are so far apart in all states.
    AlwaysOpen { by: f64, unit: &'static str },
    /// It would be open in all states for other parameters.
    ClosedByChance,
    /// Its ends stay so far apart near the guess.
    NotAssembled { by: f64, unit: &'static str },
    /// Its equations are satisfied there, but by frames, or axes, that are turned so far against each other.
    Turned { by: f64 },
    /// It and others determine so many coordinates.
    Determines(usize),
    /// It and others do not determine the coordinates that depend.
    DeterminesOthers,
}

/// A loop that misses by no more than this is closed, up to rounding.
const ROUNDING: f64 = 1e-9;

/// Loops that were solved.
#[derive(Clone, Debug)]
pub(crate) struct Closed<'g> {
    /// What they determine: absolute angles of sides, and lengths.
    pub dependents: Vec<Coordinate<'g>>,
    /// What they make of these.
    pub loops: Loops<'g>,
    /// Each declared coordinate in those of the state, of the drives, and those.
    pub combinations: Vec<Combination>,
    /// The guess of each declared coordinate, and what it is where the loops are assembled; nothing where parameters have
    /// no defaults.
    pub assembled: Vec<[f64; 2]>,
}

/// A coordinate that the loops determine.
#[derive(Clone, Debug)]
struct Dependent<'g> {
    /// Its symbol, that of its rate, and its second rate in those of the others.
    coordinate: Coordinate<'g>,
    /// How it changes.
    slopes: Slopes<'g>,
}

/// Loops while they are solved.
struct Solver<'g, 'm> {
    graph: &'g Graph,
    tree: &'m Tree<'g>,
    declared: &'m [Declared<'g>],
    dependents: Vec<Option<Dependent<'g>>>,
    combinations: Vec<Option<Combination>>,
    /// The angles of unknowns with their whole turns.
    counted: Vec<Option<Counted<'g>>>,
    dependence: Dependence<'g>,
    margins: Vec<Expr<'g>>,
    closings: Vec<Expr<'g>>,
    corrections: Vec<Expr<'g>>,
    gaps: Vec<Gap<'g>>,
    uncounted: Vec<Uncounted<'g>>,
    /// All coordinates where the loops are assembled.
    assembled: Vec<f64>,
    /// The components of orientations and positions there that have a guess.
    free: FxHashMap<ExprId, f64>,
}

/// Closes the loops, each with its vectors if it lies in a plane. Near `near` the coordinates of the state assemble
/// them, and those components of orientations and positions that have a guess.
pub(crate) fn close<'g>(
    tree: &Tree<'g>,
    loops: &[Option<Loop<'g>>],
    declared: &[Declared<'g>],
    near: (&[Expr<'g>], &[(Expr<'g>, Expr<'g>)]),
) -> Result<Closed<'g>, Open> {
    let mut solver = Solver::new(tree, loops.len(), declared, near);
    let mut left: Vec<usize> = (0..loops.len()).collect();
    while let Some((at, triangle)) = solver.next(loops, &left) {
        solver.solve(left[at], &triangle)?;
        left.remove(at);
    }
    if !left.is_empty() {
        solver.solve_together(loops, &left)?;
    }
    let numbers = |declared: &Declared<'g>| solver.numbers([declared.near, declared.coordinate.position]);
    let assembled = declared.iter().filter(|_| solver.is_known()).map(numbers).collect();
    let dependents = solver.dependents.into_iter().flatten();
    let (dependents, slopes) = dependents.map(|own| (own.coordinate, own.slopes)).unzip();
    Ok(Closed {
        assembled,
        dependents,
        combinations: solver.combinations.into_iter().flatten().collect(),
        loops: Loops {
            dependents: slopes,
            dependence: solver.dependence,
            margins: solver.margins,
            closings: solver.closings,
            corrections: solver.corrections,
            gaps: solver.gaps,
            uncounted: solver.uncounted,
        },
    })
}

impl<'g, 'm> Solver<'g, 'm> {
    fn new(
        tree: &'m Tree<'g>,
        loops: usize,
        declared: &'m [Declared<'g>],
        (near, free): (&[Expr<'g>], &[(Expr<'g>, Expr<'g>)]),
    ) -> Self {
        let mut solver = Self {
            graph: tree.graph,
            tree,
            declared,
            dependents: vec![None; declared.len()],
            combinations: vec![None; declared.len()],
            counted: vec![None; declared.len()],
            dependence: Dependence::default(),
            margins: vec![tree.graph.one(); loops],
            closings: Vec::new(),
            corrections: Vec::new(),
            gaps: Vec::new(),
            uncounted: Vec::new(),
            assembled: Vec::new(),
            free: FxHashMap::default(),
        };
        for drive in &tree.drives {
            let change = (tree.time, drive.law[1]);
            tree.graph.set_changes(drive.coordinate.position, &[change], false);
        }
        let laws = tree.drives.iter().map(|drive| drive.law[0]);
        let guesses = declared.iter().map(|declared| declared.near);
        for value in near.iter().copied().chain(laws).chain(guesses) {
            let value = solver.number(value);
            solver.assembled.push(value);
        }
        solver.free = free
            .iter()
            .map(|&(component, value)| (component.id(), solver.number(value)))
            .collect();
        solver
    }

    /// The place among the declared coordinates, of one of them.
    fn declared_as(&self, k: CoordinateId) -> Option<usize> {
        usize::from(k).checked_sub(self.tree.independent())
    }

    fn is_unknown(&self, k: CoordinateId) -> bool {
        self.declared_as(k).is_some_and(|n| self.dependents[n].is_none())
    }

    /// A sum of declared coordinates, with what is solved in the place of them.
    fn rebased(&self, sum: &Combination) -> Combination {
        sum.terms().fold(Combination::default(), |sum, (k, factor)| {
            let own = self.declared_as(k).and_then(|n| self.combinations[n].clone());
            sum.plus_multiple(factor, &own.unwrap_or(Combination::one(k)))
        })
    }

    fn unknown_part(&self, sum: &Combination) -> Combination {
        sum.filtered(|k| self.is_unknown(k))
    }

    /// Gives a symbol its value.
    fn define(&mut self, symbol: Expr<'g>, value: Expr<'g>) {
        let value = self.tree.with_drives(&[value])[0];
        self.graph.set_changes(symbol, &[(value, self.graph.one())], false);
        self.dependence.set(symbol, value);
    }

    /// A symbol for a value, unless that is a constant, or a symbol already.
    fn named(&mut self, name: &str, value: Expr<'g>) -> Expr<'g> {
        if value.level() < Level::State || value.as_symbol().is_some() {
            return value;
        }
        let symbol = self.graph.symbol(name, SymbolKind::Dependent(0));
        self.define(symbol, value);
        symbol
    }

    /// The name of an unknown.
    fn name(&self, n: usize) -> &str {
        self.dependents[n].as_ref().map_or("", |d| &d.coordinate.name)
    }

    /// What the derivative of an unknown by the coordinate of number `j` is called.
    fn slope_name(&self, n: usize, j: usize) -> String {
        format!(
            "slope_{}_{}",
            self.name(n),
            self.tree.coordinate(CoordinateId::new(j)).name
        )
    }

    /// The same by a parameter.
    fn slope_name_of(&self, n: usize, parameter: Expr<'g>) -> String {
        let by = parameter.as_symbol().map_or("", |symbol| &symbol.name);
        format!("slope_{}_{by}", self.name(n))
    }

    /// The parameters, where anything is derived by them.
    fn parameters(&self) -> Vec<Expr<'g>> {
        let derived = self.tree.generate.contains("parameter_jacobian");
        let parameters = self.tree.parameters.iter().filter(|_| derived);
        parameters.map(|parameter| parameter.symbol).collect()
    }

    /// The slopes of an unknown, which are symbols or constants, give it its rate; those by parameters belong to its
    /// position.
    fn set_slopes(&mut self, n: usize, named: Vec<Expr<'g>>, of_parameters: Vec<(Expr<'g>, Expr<'g>)>) {
        let Some(Dependent { coordinate, slopes }) = self.dependents[n].clone() else {
            return;
        };
        let (dof, drives) = (self.tree.dof(), &self.tree.drives);
        let of_state = self.tree.coordinates.iter().zip(&named);
        let of_drives = named[dof..]
            .iter()
            .zip(drives)
            .map(|(&slope, drive)| slope * drive.law[1]);
        let of_time = self.graph.sum(of_drives.collect::<Vec<_>>());
        let rate = of_state.clone().fold(of_time, |sum, (c, &slope)| sum + slope * c.rate);
        let acceleration = of_state.clone().map(|(c, &slope)| slope * c.acceleration);
        let driven = named[dof..]
            .iter()
            .zip(drives)
            .map(|(&slope, drive)| slope * drive.coordinate.acceleration);
        let acceleration = self.graph.sum(acceleration.chain(driven).collect::<Vec<_>>());
        if !slopes.in_state {
            let changes = of_state
                .map(|(c, &slope)| (c.position, slope))
                .chain([(self.tree.time, of_time)])
                .chain(of_parameters);
            self.graph
                .set_changes(coordinate.position, &changes.collect::<Vec<_>>(), false);
        }
        self.define(coordinate.rate, rate);
        let coordinate = Coordinate {
            acceleration,
            ..coordinate
        };
        let slopes = Slopes {
            slopes: named,
            drift: self.graph.zero(),
            ..slopes
        };
        self.dependents[n] = Some(Dependent { coordinate, slopes });
    }

    /// What the second rate of an unknown is called where no coordinate accelerates.
    fn drift_name(&self, n: usize) -> String {
        format!("drift_{}", self.name(n))
    }

    /// Sets that second rate, which is a symbol or a constant.
    fn set_drift(&mut self, n: usize, named: Expr<'g>) {
        if let Some(dependent) = &mut self.dependents[n] {
            dependent.slopes.drift = named;
            dependent.coordinate.acceleration += named;
        }
    }

    /// Says what a declared coordinate is, now that the unknowns are known.
    fn set_declared(&mut self, n: usize) {
        let Declared { coordinate, near } = self.declared[n].clone();
        let Some(sum) = self.combinations[n].clone() else {
            return;
        };
        let list = |part: fn(&Coordinate<'g>) -> Expr<'g>| -> Vec<(Expr<'g>, Rational)> {
            sum.terms()
                .map(|(k, factor)| (part(self.coordinate(k)), factor.clone()))
                .collect()
        };
        let (positions, rates) = (list(|c| c.position), list(|c| c.rate));
        if positions.iter().any(|(position, _)| *position == coordinate.position) {
            return;
        }
        let factors = |list: &[(Expr<'g>, Rational)]| -> Vec<(Expr<'g>, Expr<'g>)> {
            list.iter().map(|(x, n)| (*x, self.graph.number(n.clone()))).collect()
        };
        self.graph.set_changes(coordinate.position, &factors(&positions), true);
        self.graph.set_changes(coordinate.rate, &factors(&rates), true);
        let rate = self.graph.sum(rates.iter().map(|(x, n)| n * *x).collect::<Vec<_>>());
        let in_time = |(x, n): &(Expr<'g>, Rational)| (self.tree.with_drives(&[*x])[0], n.clone());
        self.dependence
            .set_sum(coordinate.position, positions.iter().map(in_time).collect());
        self.dependence.set(coordinate.rate, self.tree.with_drives(&[rate])[0]);
        let value = self.value(&coordinate, near, &sum);
        self.dependence
            .set(coordinate.position, self.tree.with_drives(&[value])[0]);
    }

    /// A coordinate of the state, of a drive, or an unknown that was found.
    fn coordinate(&self, k: CoordinateId) -> &Coordinate<'g> {
        let own = self.declared_as(k);
        let found = own.and_then(|n| self.dependents[n].as_ref().map(|dependent| &dependent.coordinate));
        match (own, found) {
            (_, Some(found)) => found,
            (Some(n), None) => &self.declared[n].coordinate,
            (None, None) => self.tree.coordinate(k),
        }
    }

    /// The derivative of a coordinate by that of number `j`; zero for what is just being solved.
    fn slope(&self, k: CoordinateId, j: usize) -> Expr<'g> {
        match self.declared_as(k).and_then(|n| self.dependents[n].as_ref()) {
            Some(dependent) => dependent.slopes.slopes[j],
            None => self.graph.integer(i64::from(usize::from(k) == j)),
        }
    }

    /// The second rate of a coordinate where nothing accelerates by itself.
    fn drift(&self, k: CoordinateId) -> Expr<'g> {
        let dependent = self.declared_as(k).and_then(|n| self.dependents[n].as_ref());
        dependent.map_or(self.graph.zero(), |dependent| dependent.slopes.drift)
    }

    /// The expression, or its normal form where that is shorter.
    fn shorter(&self, x: Expr<'g>) -> Expr<'g> {
        /// How far the normal form may grow.
        const BUDGET: usize = 10_000;
        let mut normalizer = Normalizer::with_angles(self.graph, BUDGET, self.tree.base_angles());
        let normal = normalizer.normal(x).map(|normal| normalizer.to_expr(&normal));
        normal.ok().filter(|normal| normal.length() < x.length()).unwrap_or(x)
    }
}
