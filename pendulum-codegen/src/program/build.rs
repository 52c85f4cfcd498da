//! From expressions to statements: one statement for each value used more than once.

use std::collections::BTreeMap;

use num_traits::{Signed, ToPrimitive};
use rustc_hash::{FxHashMap, FxHashSet};

use super::block::{Block, Let, Local, SinCos, Term, Variable};
use super::schedule::{Step, Time, schedule};
use crate::expr::{Binary, Expr, ExprId, Graph, Level, Node, Printer, Rational, Symbol, SymbolKind, Unary, ratio};

/// Number of operations at which an expression becomes a statement of its own.
const MOST_OPERATIONS: usize = 8;

/// Text of a constant whose value is not a finite number.
#[derive(Clone, Debug)]
pub(crate) struct NotFinite(pub(crate) String);

/// Generates code that computes `roots`, with the expressions in `known` as variables.
///
/// # Errors
///
/// Returns the first constant without a finite value.
pub(crate) fn block(
    graph: &Graph,
    roots: &[Expr<'_>],
    known: &FxHashMap<ExprId, Variable>,
) -> Result<Block, NotFinite> {
    let roots: &[ExprId] = &roots.iter().map(|root| root.id()).collect::<Vec<_>>();
    let mut builder = Builder::new(graph, roots, known);
    let results = builder.results(roots);
    if let Some(id) = builder.not_finite {
        return Err(NotFinite(text(graph, id)));
    }
    let order = schedule(&builder.steps(roots));
    Ok(builder.in_order(&order, results))
}

/// Term, and its number of operations.
#[derive(Clone, Debug)]
struct Piece {
    term: Term,
    operations: usize,
}

impl Piece {
    fn atom(term: Term) -> Self {
        Self { term, operations: 0 }
    }

    fn number(value: f64) -> Self {
        Self::atom(Term::Number(value))
    }

    fn unary(self, wrap: impl FnOnce(Box<Term>) -> Term) -> Self {
        Self {
            term: wrap(Box::new(self.term)),
            operations: self.operations + 1,
        }
    }

    fn binary(self, op: Binary, other: Self) -> Self {
        Self {
            operations: self.operations + other.operations + 1,
            term: Term::Binary(op, Box::new(self.term), Box::new(other.term)),
        }
    }
}

/// Statement, and the expression it computes.
#[derive(Debug)]
struct Statement {
    id: ExprId,
    code: Let,
}

#[derive(Debug)]
struct Builder<'g> {
    graph: &'g Graph,
    uses: FxHashMap<ExprId, usize>,
    /// Angles with used sines or cosines, with a flag for each.
    sines: BTreeMap<ExprId, [bool; 2]>,
    /// Angles in `sines` that need no other sine or cosine and are not computed yet.
    independent: Vec<ExprId>,
    known: FxHashMap<ExprId, Term>,
    statements: Vec<Statement>,
    /// For each local, the angle of which it is the sine or cosine.
    locals: Vec<Option<ExprId>>,
    not_finite: Option<ExprId>,
}

impl<'g> Builder<'g> {
    fn new(graph: &'g Graph, roots: &[ExprId], known: &FxHashMap<ExprId, Variable>) -> Self {
        let (mut uses, mut sines): (FxHashMap<ExprId, usize>, BTreeMap<_, [bool; 2]>) = Default::default();
        let mut seen = FxHashSet::default();
        let mut stack = roots.to_vec();
        while let Some(id) = stack.pop() {
            *uses.entry(id).or_default() += 1;
            if known.contains_key(&id) || !seen.insert(id) {
                continue;
            }
            if let Node::Unary(op @ (Unary::Sin | Unary::Cos), angle) = graph.node(id) {
                sines.entry(*angle).or_default()[usize::from(*op == Unary::Cos)] = true;
            }
            if graph.level(id) > Level::Constant {
                stack.extend(graph.operands(id));
            }
        }
        let mut independent: Vec<ExprId> = sines.keys().copied().collect();
        independent.retain(|&angle| !graph.reachable(&[angle]).iter().any(|&id| is_sine(graph, id)));
        Self {
            graph,
            uses,
            sines,
            independent,
            known: known
                .iter()
                .map(|(&id, &variable)| (id, Term::Read(variable)))
                .collect(),
            statements: Vec::new(),
            locals: Vec::new(),
            not_finite: None,
        }
    }

    /// Term of each root; the values it needs become statements.
    fn results(&mut self, roots: &[ExprId]) -> Vec<Term> {
        // a few results are written where they are returned; many would keep their operands alive until then
        let few = roots.len() <= MOST_OPERATIONS;
        let result = |&root: &ExprId| {
            let is_leaf = self.graph.operands(root).next().is_none() || self.graph.level(root) == Level::Constant;
            if is_leaf || is_sine(self.graph, root) || self.known.contains_key(&root) || self.uses[&root] > 1 {
                return self.piece(root).term;
            }
            let piece = self.operation(root);
            if few { piece.term } else { self.bind(root, piece).term }
        };
        roots.iter().map(result).collect()
    }

    /// Dependences among the statements.
    fn steps(&self, roots: &[ExprId]) -> Vec<Step> {
        let roots: FxHashSet<ExprId> = roots.iter().copied().collect();
        let mut origins: FxHashMap<Local, usize> = FxHashMap::default();
        for (n, statement) in self.statements.iter().enumerate() {
            origins.extend(statement.code.defines().map(|local| (local, n)));
        }
        let step = |Statement { id, code }: &Statement| Step {
            defines: code.defines().count(),
            needs: code.needs().iter().map(|local| origins[local]).collect(),
            is_result: self.uses[id] == 1 && roots.contains(id),
            time: Time::of(code),
        };
        self.statements.iter().map(step).collect()
    }

    /// Block of the statements in the given order, with names numbered in that order.
    fn in_order(self, order: &[usize], results: Vec<Term>) -> Block {
        let mut statements: Vec<Option<Let>> = self.statements.into_iter().map(|s| Some(s.code)).collect();
        let lets: Vec<Let> = order.iter().filter_map(|&n| statements[n].take()).collect();
        let mut names = vec![String::new(); self.locals.len()];
        let mut count = 0;
        let mut next = || {
            count += 1;
            count - 1
        };
        for code in &lets {
            match code {
                Let::Value(local, _) => names[local.0] = format!("t{}", next()),
                Let::SinCos(pairs) => {
                    for SinCos { sine, cosine, .. } in pairs {
                        let angle = sine.or(*cosine).and_then(|local| self.locals[local.0]);
                        let symbol = angle.and_then(|angle| self.graph.as_symbol(angle));
                        let suffix = match symbol.filter(|symbol| is_name(symbol)) {
                            Some(symbol) => format!("_{}", symbol.name),
                            None => next().to_string(),
                        };
                        for (function, local) in [("sin", sine), ("cos", cosine)] {
                            local
                                .iter()
                                .for_each(|local| names[local.0] = format!("{function}{suffix}"));
                        }
                    }
                }
            }
        }
        Block {
            names,
            lets,
            columns: None,
            results,
        }
    }

    fn local(&mut self, id: ExprId, angle: Option<ExprId>) -> Local {
        let local = Local(self.locals.len());
        self.locals.push(angle);
        self.known.insert(id, Term::Local(local));
        local
    }

    fn piece(&mut self, id: ExprId) -> Piece {
        if let Some(known) = self.known.get(&id) {
            return Piece::atom(known.clone());
        }
        if self.graph.level(id) == Level::Constant {
            return self.constant(id);
        }
        if let Node::Unary(Unary::Sin | Unary::Cos, angle) = *self.graph.node(id) {
            self.sines_and_cosines(id, angle);
            return Piece::atom(self.known[&id].clone());
        }
        let piece = self.operation(id);
        if self.uses[&id] > 1 || piece.operations >= MOST_OPERATIONS {
            return self.bind(id, piece);
        }
        piece
    }

    fn bind(&mut self, id: ExprId, piece: Piece) -> Piece {
        let local = self.local(id, None);
        let code = Let::Value(local, piece.term);
        self.statements.push(Statement { id, code });
        Piece::atom(Term::Local(local))
    }

    /// Value of a constant.
    fn constant(&mut self, id: ExprId) -> Piece {
        let value = self.graph.constant(id).filter(|value| value.is_finite());
        if value.is_none() {
            self.not_finite.get_or_insert(id);
        }
        Piece::number(value.unwrap_or_default())
    }

    /// Sine and cosine of an angle, paired with another angle that can be computed at the same time.
    fn sines_and_cosines(&mut self, id: ExprId, angle: ExprId) {
        let mut batch = vec![angle];
        if let Some(at) = self.independent.iter().position(|&other| other == angle) {
            self.independent.remove(at);
            batch.extend((!self.independent.is_empty()).then(|| self.independent.remove(0)));
        }
        let mut pairs = Vec::new();
        for angle in batch {
            let argument = self.piece(angle).term;
            let used = self.sines.get(&angle).copied().unwrap_or([true; 2]);
            let [sine, cosine] = [(Unary::Sin, used[0]), (Unary::Cos, used[1])].map(|(op, used)| {
                let value = self.graph.find(&Node::Unary(op, angle)).filter(|_| used)?;
                Some(self.local(value, Some(angle)))
            });
            pairs.push(SinCos {
                angle: argument,
                sine,
                cosine,
            });
        }
        let code = Let::SinCos(pairs);
        self.statements.push(Statement { id, code });
    }

    fn operation(&mut self, id: ExprId) -> Piece {
        match self.graph.node(id) {
            // every symbol is known, and numbers are constants
            Node::Number(_) | Node::Pi | Node::Symbol(_) => self.constant(id),
            &Node::Unary(op, a) => self.piece(a).unary(|a| Term::Unary(op, a)),
            &Node::Binary(op, a, b) => {
                let (a, b) = (self.piece(a), self.piece(b));
                a.binary(op, b)
            }
            Node::Power(a, n) => self.power(*a, n),
        }
    }

    /// Writes integer powers as products, then square roots, then general powers.
    fn power(&mut self, base: ExprId, exponent: &Rational) -> Piece {
        let count = exponent.abs().to_i64().filter(|_| exponent.is_integer());
        if let Some(count) = count {
            let mut factor = self.piece(base);
            if factor.operations > 0 {
                factor = self.bind(base, factor);
            }
            let product = (1..count).fold(factor.clone(), |product, _| product.binary(Binary::Mul, factor.clone()));
            return if exponent.is_negative() {
                Piece::number(1.0).binary(Binary::Div, product)
            } else {
                product
            };
        }
        let base = self.piece(base);
        if *exponent == ratio(1, 2) {
            return base.unary(Term::Sqrt);
        }
        if *exponent == ratio(-1, 2) {
            return Piece::number(1.0).binary(Binary::Div, base.unary(Term::Sqrt));
        }
        let exponent = exponent.to_f64().unwrap_or(f64::NAN);
        base.unary(|base| Term::Power(base, exponent))
    }
}

/// True if the name of a symbol is an identifier. Rates and components have none.
fn is_name(symbol: &Symbol) -> bool {
    !matches!(symbol.kind, SymbolKind::Rate(_)) && !symbol.name.contains('.')
}

/// True if an expression is a sine or a cosine.
fn is_sine(graph: &Graph, id: ExprId) -> bool {
    matches!(graph.node(id), Node::Unary(Unary::Sin | Unary::Cos, _))
}

/// Text of a constant, short enough for a message.
fn text(graph: &Graph, id: ExprId) -> String {
    /// Maximum length of the text, in characters.
    const MOST: usize = 60;
    let text = Printer::new(graph).print(id);
    match graph.as_number(id) {
        Some(number) if text.len() > MOST => {
            let whole = number.trunc().to_string();
            let digits = whole.trim_start_matches('-');
            let sign = if number.is_negative() { "-" } else { "" };
            format!("{sign}{}.{}e{}", &digits[..1], &digits[1..4], digits.len() - 1)
        }
        _ if text.chars().count() > MOST => text.chars().take(MOST).chain("..".chars()).collect(),
        _ => text,
    }
}
