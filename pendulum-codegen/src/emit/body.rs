//! Expressions to statements: one `let` for each shared value.

use std::collections::{BTreeMap, HashMap, HashSet};

use proc_macro2::{Ident, Literal, Span, TokenStream, TokenTree};
use quote::{format_ident, quote};

use super::schedule::{Step, schedule};
use crate::expr::{Binary, Expr, ExprId, Graph, Level, Node, Rational, Unary, ratio};
use crate::model::Model;

/// Longer expressions are broken up by a `let`.
const MOST_OPERATIONS: usize = 8;

/// How tightly a piece of Rust holds together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Grip {
    Sum,
    Product,
    Unary,
    Atom,
}

/// A piece of Rust.
#[derive(Clone, Debug)]
struct Piece {
    tokens: TokenStream,
    grip: Grip,
    operations: usize,
}

impl Piece {
    fn atom(tokens: TokenStream) -> Self {
        Self {
            tokens,
            grip: Grip::Atom,
            operations: 0,
        }
    }

    fn within(self, least: Grip) -> TokenStream {
        let tokens = self.tokens;
        if self.grip < least { quote!((#tokens)) } else { tokens }
    }
}

/// More statements than this are put into blocks. Every `let` opens a scope inside the one before, and compilers that
/// walk scopes by recursion (as LLVM does for debug information) run out of stack when some thousand are nested.
const MOST_STATEMENTS: usize = 256;

/// A `let`, what it was made for, and the names that it brings.
#[derive(Debug)]
struct Statement {
    id: ExprId,
    names: Vec<Ident>,
    tokens: TokenStream,
}

/// All names in a piece of code.
fn names_in(tokens: &TokenStream) -> HashSet<String> {
    let mut names = HashSet::new();
    for token in tokens.clone() {
        match token {
            TokenTree::Ident(name) => _ = names.insert(name.to_string()),
            TokenTree::Group(group) => names.extend(names_in(&group.stream())),
            _ => {}
        }
    }
    names
}

/// Statements that compute some expressions.
#[derive(Debug)]
pub(super) struct Body<'m> {
    graph: &'m Graph,
    uses: HashMap<ExprId, usize>,
    /// The angles whose sine, or cosine, is used.
    sines: BTreeMap<ExprId, [bool; 2]>,
    /// Those of them that need no other sine or cosine and are not computed yet.
    independent: Vec<ExprId>,
    names: HashMap<ExprId, Piece>,
    statements: Vec<Statement>,
    temporaries: usize,
}

/// A name that no declaration can clash with. The mark of a raw identifier has no place behind a prefix.
pub(super) fn local(name: String) -> Ident {
    Ident::new(&name.replace("r#", ""), Span::mixed_site())
}

impl<'m> Body<'m> {
    /// Code that computes roots, in which the given expressions are known under names, and behind it the result that it is for.
    pub(super) fn code(
        graph: &'m Graph,
        roots: &[Expr<'_>],
        known: &HashMap<ExprId, Ident>,
        result: impl FnOnce(&[TokenStream]) -> TokenStream,
    ) -> TokenStream {
        // once to find the statements, and once to write them in the order in which they shall stand
        let roots: &[ExprId] = &roots.iter().map(|root| root.id()).collect::<Vec<_>>();
        let mut draft = Self::new(graph, roots, known);
        draft.values(roots);
        let order: Vec<ExprId> = schedule(&draft.steps(roots))
            .into_iter()
            .map(|n| draft.statements[n].id)
            .collect();
        let mut body = Self::new(graph, roots, known);
        for id in order {
            body.statement(id, roots.contains(&id));
        }
        let values = body.values(roots);
        body.finish(&result(&values))
    }

    fn new(graph: &'m Graph, roots: &[ExprId], known: &HashMap<ExprId, Ident>) -> Self {
        let names: HashMap<_, _> = known
            .iter()
            .map(|(&id, name)| (id, Piece::atom(quote!(#name))))
            .collect();
        let (mut uses, mut sines): (HashMap<ExprId, usize>, BTreeMap<_, [bool; 2]>) = Default::default();
        let mut seen = HashSet::new();
        let mut stack = roots.to_vec();
        while let Some(id) = stack.pop() {
            *uses.entry(id).or_default() += 1;
            if names.contains_key(&id) || !seen.insert(id) {
                continue;
            }
            if let Node::Unary(op @ (Unary::Sin | Unary::Cos), angle) = graph.node(id) {
                sines.entry(*angle).or_default()[usize::from(*op == Unary::Cos)] = true;
            }
            if graph.level(id) > Level::Constant {
                stack.extend(graph.operands(id));
            }
        }
        let independent = sines.keys().copied();
        let independent = independent.filter(|&angle| !graph.reachable(&[angle]).iter().any(|&id| is_sine(graph, id)));
        let independent = independent.collect();
        Self {
            graph,
            uses,
            sines,
            independent,
            names,
            statements: Vec::new(),
            temporaries: 0,
        }
    }

    /// The code of each root; what it needs becomes statements.
    fn values(&mut self, roots: &[ExprId]) -> Vec<TokenStream> {
        let few = roots.len() <= MOST_OPERATIONS;
        let value = |&root: &ExprId| {
            let is_leaf = self.graph.operands(root).next().is_none() || self.graph.level(root) == Level::Constant;
            if is_leaf || is_sine(self.graph, root) || self.names.contains_key(&root) || self.uses[&root] > 1 {
                return self.piece(root).tokens;
            }
            let piece = self.operation(root);
            // a few results stand where they are returned; of many, what they are made of would have to wait until then
            if few {
                piece.tokens
            } else {
                self.bind(root, &piece).tokens
            }
        };
        roots.iter().map(value).collect()
    }

    /// Makes a statement of an expression whose operands have theirs.
    fn statement(&mut self, id: ExprId, is_result: bool) {
        if is_result && !is_sine(self.graph, id) {
            let piece = self.operation(id);
            self.bind(id, &piece);
        } else {
            self.piece(id);
        }
    }

    /// What each statement needs of the others.
    fn steps(&self, roots: &[ExprId]) -> Vec<Step> {
        let mut origins: HashMap<String, usize> = HashMap::new();
        for (n, statement) in self.statements.iter().enumerate() {
            origins.extend(statement.names.iter().map(|name| (name.to_string(), n)));
        }
        let step = |(n, statement): (usize, &Statement)| {
            let names = names_in(&statement.tokens);
            let needs = names.iter().filter_map(|name| origins.get(name).copied());
            Step {
                defines: statement.names.len(),
                needs: needs.filter(|&need| need != n).collect(),
                is_result: self.uses[&statement.id] == 1 && roots.contains(&statement.id),
            }
        };
        self.statements.iter().enumerate().map(step).collect()
    }

    /// The statements, and behind them the result that they are for.
    fn finish(self, result: &TokenStream) -> TokenStream {
        let mut code = TokenStream::new();
        let mut needed = names_in(result);
        if self.statements.len() <= MOST_STATEMENTS {
            code.extend(self.statements.iter().map(|statement| &statement.tokens).cloned());
        } else {
            // from the last chunk to the first, since each hands out only what is needed behind it
            let mut chunks = Vec::new();
            for chunk in self.statements.chunks(MOST_STATEMENTS).rev() {
                let defined = chunk.iter().flat_map(|statement| &statement.names);
                let out: Vec<&Ident> = defined.filter(|name| needed.contains(&name.to_string())).collect();
                let inside = chunk.iter().map(|statement| &statement.tokens);
                chunks.push(quote!(let (#(#out,)*) = { #(#inside)* (#(#out,)*) };));
                needed.extend(chunk.iter().flat_map(|statement| names_in(&statement.tokens)));
            }
            code.extend(chunks.into_iter().rev());
        }
        quote!(#code #result)
    }

    fn piece(&mut self, id: ExprId) -> Piece {
        if let Some(known) = self.names.get(&id) {
            return known.clone();
        }
        if self.graph.level(id) == Level::Constant {
            return Piece::atom(literal(self.graph, id));
        }
        if let Node::Unary(Unary::Sin | Unary::Cos, angle) = *self.graph.node(id) {
            self.sines_and_cosines(id, angle);
            return self.names[&id].clone();
        }
        let piece = self.operation(id);
        if self.uses[&id] > 1 || piece.operations >= MOST_OPERATIONS {
            return self.bind(id, &piece);
        }
        piece
    }

    fn bind(&mut self, id: ExprId, piece: &Piece) -> Piece {
        let name = local(format!("t{}", self.temporaries));
        self.temporaries += 1;
        let tokens = &piece.tokens;
        let statement = quote!(let #name = #tokens;);
        self.statements.push(Statement {
            id,
            names: vec![name.clone()],
            tokens: statement,
        });
        let bound = Piece::atom(quote!(#name));
        self.names.insert(id, bound.clone());
        bound
    }

    /// Sine and cosine of an angle, and of another one that can be computed with it: two take hardly longer than one.
    fn sines_and_cosines(&mut self, id: ExprId, angle: ExprId) {
        let mut batch = vec![angle];
        if let Some(at) = self.independent.iter().position(|&other| other == angle) {
            self.independent.remove(at);
            batch.extend((!self.independent.is_empty()).then(|| self.independent.remove(0)));
        }
        let (mut arguments, mut patterns, mut names) = (Vec::new(), Vec::new(), Vec::new());
        for &angle in &batch {
            arguments.push(self.piece(angle));
            let suffix = match self.graph.as_symbol(angle) {
                Some(symbol) => format!("_{}", symbol.name),
                None => {
                    self.temporaries += 1;
                    (self.temporaries - 1).to_string()
                }
            };
            let used = self.sines.get(&angle).copied().unwrap_or([true; 2]);
            let pair = [("sin", Unary::Sin, used[0]), ("cos", Unary::Cos, used[1])].map(|(function, op, used)| {
                if !used {
                    return quote!(_);
                }
                let name = local(format!("{function}{suffix}"));
                if let Some(value) = self.graph.find(&Node::Unary(op, angle)) {
                    self.names.insert(value, Piece::atom(quote!(#name)));
                }
                names.push(name.clone());
                quote!(#name)
            });
            let [sine, cosine] = pair;
            patterns.push(quote!((#sine, #cosine)));
        }
        let mut arguments = arguments.into_iter();
        let receiver = arguments.next().map(|argument| argument.within(Grip::Atom));
        let tokens = match arguments.next() {
            None => quote!(let #(#patterns)* = #receiver.sin_cos();),
            Some(Piece { tokens: other, .. }) => quote!(let [#(#patterns),*] = #receiver.sin_cos_pair(#other);),
        };
        self.statements.push(Statement { id, names, tokens });
    }

    fn operation(&mut self, id: ExprId) -> Piece {
        match self.graph.node(id).clone() {
            // every symbol is known by name, and numbers are constants
            Node::Number(_) | Node::Pi | Node::Symbol(_) => Piece::atom(literal(self.graph, id)),
            Node::Unary(Unary::Neg, a) => {
                let a = self.piece(a);
                let operations = a.operations + 1;
                let a = a.within(Grip::Unary);
                Piece {
                    tokens: quote!(-#a),
                    grip: Grip::Unary,
                    operations,
                }
            }
            Node::Unary(op, a) => {
                let a = self.piece(a);
                let (operations, function) = (a.operations + 1, format_ident!("{}", op.spelling()));
                let a = a.within(Grip::Atom);
                Piece {
                    tokens: quote!(#a.#function()),
                    grip: Grip::Atom,
                    operations,
                }
            }
            Node::Binary(op, a, b) => {
                let (a, b) = (self.piece(a), self.piece(b));
                let operations = a.operations + b.operations + 1;
                let (tokens, grip) = match op {
                    Binary::Add => {
                        let (a, b) = (a.within(Grip::Sum), b.within(Grip::Product));
                        (quote!(#a + #b), Grip::Sum)
                    }
                    Binary::Sub => {
                        let (a, b) = (a.within(Grip::Sum), b.within(Grip::Product));
                        (quote!(#a - #b), Grip::Sum)
                    }
                    Binary::Mul => {
                        let (a, b) = (a.within(Grip::Product), b.within(Grip::Unary));
                        (quote!(#a * #b), Grip::Product)
                    }
                    Binary::Div => {
                        let (a, b) = (a.within(Grip::Product), b.within(Grip::Unary));
                        (quote!(#a / #b), Grip::Product)
                    }
                    Binary::Atan2 => {
                        let (a, b) = (a.within(Grip::Atom), b.within(Grip::Sum));
                        (quote!(#a.atan2(#b)), Grip::Atom)
                    }
                };
                Piece {
                    tokens,
                    grip,
                    operations,
                }
            }
            Node::Power(a, n) => self.power(a, &n),
        }
    }

    fn power(&mut self, base: ExprId, exponent: &Rational) -> Piece {
        use num_traits::{Signed, ToPrimitive};
        let count = exponent.abs().to_i64().filter(|_| exponent.is_integer());
        if let Some(count) = count {
            let mut factor = self.piece(base);
            if factor.operations > 0 {
                factor = self.bind(base, &factor);
            }
            let factor = factor.within(Grip::Unary);
            let product = (1..count).fold(factor.clone(), |product, _| quote!(#product * #factor));
            let operations = count as usize;
            return if exponent.is_negative() {
                let one = spelled(1.0);
                let product = if count > 1 { quote!((#product)) } else { product };
                Piece {
                    tokens: quote!(#one / #product),
                    grip: Grip::Product,
                    operations,
                }
            } else {
                Piece {
                    tokens: product,
                    grip: Grip::Product,
                    operations: operations - 1,
                }
            };
        }
        let a = self.piece(base);
        let operations = a.operations + 1;
        let a = a.within(Grip::Atom);
        if *exponent == ratio(1, 2) {
            return Piece {
                tokens: quote!(#a.sqrt()),
                grip: Grip::Atom,
                operations,
            };
        }
        if *exponent == ratio(-1, 2) {
            let one = spelled(1.0);
            return Piece {
                tokens: quote!(#one / #a.sqrt()),
                grip: Grip::Product,
                operations: operations + 1,
            };
        }
        let exponent = spelled(exponent.to_f64().unwrap_or(f64::NAN));
        Piece {
            tokens: quote!(#a.powf(#exponent)),
            grip: Grip::Atom,
            operations,
        }
    }
}

/// Whether an expression is a sine or a cosine.
fn is_sine(graph: &Graph, id: ExprId) -> bool {
    matches!(graph.node(id), Node::Unary(Unary::Sin | Unary::Cos, _))
}

/// A constant, folded.
fn literal(graph: &Graph, id: ExprId) -> TokenStream {
    spelled(graph.constant(id).unwrap_or(f64::NAN))
}

/// A number of the generic type, spelled so that it reads back exactly.
pub(super) fn spelled(value: f64) -> TokenStream {
    let text = format!("{:?}", value.abs());
    let literal: Literal = text.parse().unwrap_or_else(|_| Literal::f64_unsuffixed(0.0));
    if value.is_sign_negative() && value != 0.0 {
        quote!(T::from_f64(-#literal))
    } else {
        quote!(T::from_f64(#literal))
    }
}

/// Names of the state, the time and the inputs in generated functions, and the statement that takes the state apart.
pub(super) fn unpack(model: &Model<'_>, roots: &[Expr<'_>]) -> (HashMap<ExprId, Ident>, TokenStream) {
    let used: HashSet<ExprId> = model.graph.reachable(roots).into_iter().collect();
    let mut known = HashMap::new();
    let mut pattern = Vec::new();
    for (prefix, part) in [("q", 0), ("qd", 1)] {
        for coordinate in &model.coordinates {
            let id = if part == 0 {
                coordinate.position.id()
            } else {
                coordinate.rate.id()
            };
            let name = local(format!("{prefix}_{}", coordinate.name));
            pattern.push(if used.contains(&id) { quote!(#name) } else { quote!(_) });
            known.insert(id, name);
        }
    }
    let mut statements = quote!(let [#(#pattern),*] = x.data.0[0];);
    if model.coordinates.iter().any(|c| used.contains(&c.acceleration.id())) {
        let mut pattern = Vec::new();
        for coordinate in &model.coordinates {
            let name = local(format!("qdd_{}", coordinate.name));
            known.insert(coordinate.acceleration.id(), name.clone());
            pattern.push(name);
        }
        statements.extend(quote!(let [#(#pattern),*] = qdd.data.0[0];));
    }
    known.insert(model.time.id(), format_ident!("t"));
    for input in &model.inputs {
        let name = local(format!("u_{}", input.name));
        if used.contains(&input.symbol.id()) {
            let field = format_ident!("{}", input.name);
            statements.extend(quote!(let #name = u.#field;));
        }
        known.insert(input.symbol.id(), name);
    }
    (known, statements)
}
