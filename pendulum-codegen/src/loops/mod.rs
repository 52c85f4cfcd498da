//! Solution of closed loops for the coordinates declared to depend on others.
//!
//! Loops are solved one after the other as long as one is a [triangle]; the rest is solved together, [by linear
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

/// A dependent coordinate as declared.
#[derive(Clone, Debug)]
pub(crate) struct Declared<'g> {
    /// Name and symbols.
    pub coordinate: Coordinate<'g>,
    /// Guess of its value in the assembled configuration.
    pub near: Expr<'g>,
}

/// Error if loops cannot be closed.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Open {
    /// Index of a loop that cannot be closed.
    pub number: usize,
    pub cause: Cause,
}

/// Reason why a loop stays open in the assembled configuration.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Cause {
    /// The sides of its triangle are too short to meet by this length, or one of them is too long.
    TooShort { by: f64 },
    /// It is at its singularity (toggle).
    AtToggle,
    /// Its guess is equally near to both assemblies.
    Undecided,
    /// Its ends are this far apart in all states.
    AlwaysOpen { by: f64, unit: &'static str },
    /// It would be open in all states for other parameters.
    ClosedByChance,
    /// Its ends stay this far apart near the guess.
    NotAssembled { by: f64, unit: &'static str },
    /// Its equations are satisfied, but its frames or axes are turned against each other by this angle.
    Turned { by: f64 },
    /// It and others determine this number of coordinates.
    Determines(usize),
    /// It and others do not determine the dependent coordinates.
    DeterminesOthers,
}

/// Maximum gap of a closed loop due to rounding, in m or rad.
const ROUNDING: f64 = 1e-9;

/// Solved loops.
#[derive(Clone, Debug)]
pub(crate) struct Closed<'g> {
    /// Coordinates that the loops determine: absolute angles of sides, and lengths.
    pub dependents: Vec<Coordinate<'g>>,
    /// Slopes of these coordinates, and the margins, corrections and gaps of the loops.
    pub loops: Loops<'g>,
    /// Each declared coordinate as a combination of coordinates of the state, of the drives, and of `dependents`.
    pub combinations: Vec<Combination>,
    /// Guess of each declared coordinate, and its value in the assembled configuration; empty if parameters have no
    /// defaults.
    pub assembled: Vec<[f64; 2]>,
}

/// A coordinate determined by the loops.
#[derive(Clone, Debug)]
struct Dependent<'g> {
    /// Its symbol, the symbol of its rate, and its acceleration in terms of the accelerations of others.
    coordinate: Coordinate<'g>,
    /// Dependence of its rate on the rates of the independent coordinates.
    slopes: Slopes<'g>,
}

/// State of the solution of loops.
struct Solver<'g, 'm> {
    graph: &'g Graph,
    tree: &'m Tree<'g>,
    declared: &'m [Declared<'g>],
    dependents: Vec<Option<Dependent<'g>>>,
    combinations: Vec<Option<Combination>>,
    /// Angles of unknowns, counted with their whole turns.
    counted: Vec<Option<Counted<'g>>>,
    dependence: Dependence<'g>,
    margins: Vec<Expr<'g>>,
    closings: Vec<Expr<'g>>,
    corrections: Vec<Expr<'g>>,
    gaps: Vec<Gap<'g>>,
    uncounted: Vec<Uncounted<'g>>,
    /// All coordinates in the assembled configuration.
    assembled: Vec<f64>,
    /// Components of orientations and positions that have a guess, in the assembled configuration.
    free: FxHashMap<ExprId, f64>,
}

/// Closes the loops, each given by its vectors if it lies in a plane. They are assembled near `near`: the coordinates
/// of the state, and the components of orientations and positions that have a guess.
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
    let start = solver.components().collect();
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
            assembled: start,
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

    /// Index of a coordinate among the declared ones, if it is one of them.
    fn declared_as(&self, k: CoordinateId) -> Option<usize> {
        usize::from(k).checked_sub(self.tree.independent())
    }

    fn is_unknown(&self, k: CoordinateId) -> bool {
        self.declared_as(k).is_some_and(|n| self.dependents[n].is_none())
    }

    /// A sum of declared coordinates, with solved coordinates replaced by their solutions.
    fn rebased(&self, sum: &Combination) -> Combination {
        sum.terms().fold(Combination::default(), |sum, (k, factor)| {
            let own = self.declared_as(k).and_then(|n| self.combinations[n].clone());
            sum.plus_multiple(factor, &own.unwrap_or(Combination::one(k)))
        })
    }

    fn unknown_part(&self, sum: &Combination) -> Combination {
        sum.filtered(|k| self.is_unknown(k))
    }

    /// Defines the value of a symbol.
    fn define(&mut self, symbol: Expr<'g>, value: Expr<'g>) {
        let value = self.tree.with_drives(&[value])[0];
        self.graph.set_changes(symbol, &[(value, self.graph.one())], false);
        self.dependence.set(symbol, value);
    }

    /// Returns a symbol for a value, or the value itself if it is a constant or already a symbol.
    fn named(&mut self, name: &str, value: Expr<'g>) -> Expr<'g> {
        if value.level() < Level::State || value.as_symbol().is_some() {
            return value;
        }
        let symbol = self.graph.symbol(name, SymbolKind::Dependent(0));
        self.define(symbol, value);
        symbol
    }

    /// Name of an unknown.
    fn name(&self, n: usize) -> &str {
        self.dependents[n].as_ref().map_or("", |d| &d.coordinate.name)
    }

    /// Name of the derivative of an unknown with respect to coordinate `j`.
    fn slope_name(&self, n: usize, j: usize) -> String {
        format!(
            "slope_{}_{}",
            self.name(n),
            self.tree.coordinate(CoordinateId::new(j)).name
        )
    }

    /// Name of the derivative of an unknown with respect to a parameter.
    fn slope_name_of(&self, n: usize, parameter: Expr<'g>) -> String {
        let by = parameter.as_symbol().map_or("", |symbol| &symbol.name);
        format!("slope_{}_{by}", self.name(n))
    }

    /// Parameters, if derivatives with respect to them are generated.
    fn parameters(&self) -> Vec<Expr<'g>> {
        let derived = ["parameter_jacobian", "adjoint"]
            .iter()
            .any(|word| self.tree.generate.contains(word));
        let parameters = self.tree.parameters.iter().filter(|_| derived);
        parameters.map(|parameter| parameter.symbol).collect()
    }

    /// Sets the slopes of an unknown, which are symbols or constants, and the rate that follows from them. Slopes with
    /// respect to parameters belong to its position.
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

    /// Name of the drift of an unknown: its acceleration while no independent coordinate accelerates.
    fn drift_name(&self, n: usize) -> String {
        format!("drift_{}", self.name(n))
    }

    /// Sets the drift of an unknown, which is a symbol or a constant.
    fn set_drift(&mut self, n: usize, named: Expr<'g>) {
        if let Some(dependent) = &mut self.dependents[n] {
            dependent.slopes.drift = named;
            dependent.coordinate.acceleration += named;
        }
    }

    /// Defines a declared coordinate in terms of the solved unknowns.
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

    /// A coordinate of the state, of a drive, or a solved unknown.
    fn coordinate(&self, k: CoordinateId) -> &Coordinate<'g> {
        let own = self.declared_as(k);
        let found = own.and_then(|n| self.dependents[n].as_ref().map(|dependent| &dependent.coordinate));
        match (own, found) {
            (_, Some(found)) => found,
            (Some(n), None) => &self.declared[n].coordinate,
            (None, None) => self.tree.coordinate(k),
        }
    }

    /// Derivative of a coordinate with respect to coordinate `j`; zero for an unknown being solved.
    fn slope(&self, k: CoordinateId, j: usize) -> Expr<'g> {
        match self.declared_as(k).and_then(|n| self.dependents[n].as_ref()) {
            Some(dependent) => dependent.slopes.slopes[j],
            None => self.graph.integer(i64::from(usize::from(k) == j)),
        }
    }

    /// Drift of a coordinate: its acceleration while no independent coordinate accelerates.
    fn drift(&self, k: CoordinateId) -> Expr<'g> {
        let dependent = self.declared_as(k).and_then(|n| self.dependents[n].as_ref());
        dependent.map_or(self.graph.zero(), |dependent| dependent.slopes.drift)
    }

    /// Returns the expression, or its normal form if that is shorter.
    fn shorter(&self, x: Expr<'g>) -> Expr<'g> {
        /// Maximum number of products of terms in the normal form.
        const BUDGET: usize = 10_000;
        let mut normalizer = Normalizer::with_angles(self.graph, BUDGET, self.tree.base_angles());
        let normal = normalizer.normal(x).map(|normal| normalizer.to_expr(&normal));
        normal.ok().filter(|normal| normal.length() < x.length()).unwrap_or(x)
    }
}
