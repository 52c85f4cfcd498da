//! Formulas in LaTeX, for documents that load `amsmath`.

use num_traits::{One, Signed};

use super::text::number;
use super::{Definition, Formula, Precedence, Term};

/// The width of a line, in letters.
const LINE: usize = 68;

/// Functions that LaTeX knows by their names.
const FUNCTIONS: [&str; 6] = ["sin", "cos", "tan", "exp", "ln", "tanh"];

/// Names of letters.
const GREEK: [&str; 33] = [
    "alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "iota", "kappa", "lambda", "mu", "nu", "xi",
    "pi", "rho", "sigma", "tau", "upsilon", "phi", "chi", "psi", "omega", "Gamma", "Delta", "Theta", "Lambda", "Xi",
    "Pi", "Sigma", "Phi", "Psi", "Omega",
];

impl Formula {
    /// A displayed equation with `left` on its left side, on as many lines as it takes.
    pub fn latex_equation(&self, left: &Formula) -> String {
        let left_side = left.latex();
        let mut lines = vec![String::new()];
        let mut room = LINE.saturating_sub(left.width() + 2);
        for piece in pieces(self, LINE / 2) {
            let line = lines.last_mut().filter(|line| piece.width <= room || line.is_empty());
            match line {
                Some(line) => {
                    line.push_str(&piece.latex);
                    room = room.saturating_sub(piece.width);
                }
                None => {
                    room = LINE.saturating_sub(piece.width + 4);
                    lines.push(piece.latex);
                }
            }
        }
        if lines.len() == 1 {
            return format!("\\[ {left_side} = {} \\]\n", lines[0]);
        }
        format!(
            "\\[ \\begin{{aligned}}\n{left_side} &= {}\n\\end{{aligned}} \\]\n",
            lines.join(" \\\\\n&\\quad{}")
        )
    }

    /// The formula on one line.
    pub fn latex(&self) -> String {
        match self {
            Self::Number(n) if !n.denom().is_one() && self.precedence() < Precedence::Atom && !n.is_negative() => {
                format!("\\frac{{{}}}{{{}}}", n.numer(), n.denom())
            }
            Self::Number(n) if n.is_negative() => format!("-{}", Self::Number(-n).latex()),
            Self::Number(n) => number(n),
            Self::Name(name) => latex_name(name),
            Self::Entry(name, indices) => {
                let indices: Vec<String> = indices.iter().map(|index| latex_name(index)).collect();
                format!("{name}_{{{}}}", indices.join(",\\,"))
            }
            Self::Call(function, arguments) => call(function, "", arguments, false),
            Self::Neg(a) => format!("-{}", within(a, Precedence::Product)),
            Self::Sum(terms) => sum(terms),
            Self::Product(factors) => product(factors),
            Self::Quotient(above, below) => format!("\\frac{{{}}}{{{}}}", above.latex(), below.latex()),
            Self::Power(base, exponent) => power(base, exponent, false),
        }
    }

    /// How many letters wide the formula is in print, about.
    fn width(&self) -> usize {
        match self {
            Self::Number(n) if self.precedence() == Precedence::Atom => number(n).len(),
            Self::Number(n) => n.numer().to_string().len().max(n.denom().to_string().len()) + 1,
            Self::Name(name) => {
                let (stem, rest) = parts_of_name(name);
                let stem = if GREEK.contains(&stem) { 1 } else { stem.chars().count() };
                stem + rest.iter().map(|part| part.chars().count()).sum::<usize>().div_ceil(2)
            }
            Self::Entry(_, indices) => 1 + indices.iter().map(|index| Self::name(index).width()).sum::<usize>(),
            Self::Call(function, arguments) if function == "dot" => arguments.iter().map(Self::width).sum(),
            Self::Call(function, arguments) => function.len() + 1 + arguments.iter().map(Self::width).sum::<usize>(),
            Self::Neg(a) => 1 + a.width(),
            Self::Sum(terms) => terms.iter().map(|term| 3 + term.formula.width()).sum::<usize>() + 1,
            Self::Product(factors) => factors.iter().map(Self::width).sum::<usize>() + factors.len() / 3,
            Self::Quotient(a, b) => a.width().max(b.width()) + 1,
            Self::Power(base, exponent) => base.width() + exponent.width().div_ceil(2),
        }
    }
}

/// Definitions as displayed equations, short ones side by side.
pub(crate) fn latex_definitions(definitions: &[Definition]) -> String {
    let (mut text, mut line, mut room) = (String::new(), Vec::new(), LINE);
    for Definition { name, formula } in definitions {
        let left = Formula::name(name);
        let width = left.width() + formula.width() + 8;
        if width > room && !line.is_empty() {
            text.push_str(&side_by_side(&line));
            (line, room) = (Vec::new(), LINE);
        }
        if width > room {
            text.push_str(&formula.latex_equation(&left));
        } else {
            line.push(format!("{} = {}", left.latex(), formula.latex()));
            room -= width;
        }
    }
    text.push_str(&side_by_side(&line));
    text
}

fn side_by_side(line: &[String]) -> String {
    if line.is_empty() {
        String::new()
    } else {
        format!("\\[ {} \\]\n", line.join(", \\qquad "))
    }
}

/// A part of a formula that stays on its line.
struct Piece {
    latex: String,
    width: usize,
}

/// The formula in pieces between which a line may end: before the signs of sums, in brackets too where what they hold is wide.
fn pieces(formula: &Formula, wide: usize) -> Vec<Piece> {
    let whole = || {
        vec![Piece {
            latex: formula.latex(),
            width: formula.width(),
        }]
    };
    match formula {
        Formula::Sum(terms) => {
            let mut all = Vec::new();
            for (n, Term { negative, formula }) in terms.iter().enumerate() {
                let mut own = if formula.precedence() < Precedence::Product {
                    bracketed(formula, wide)
                } else {
                    pieces(formula, wide)
                };
                if let Some(first) = own.first_mut() {
                    let sign = match (n, negative) {
                        (0, false) => "",
                        (0, true) => "-",
                        (_, false) => " + ",
                        (_, true) => " - ",
                    };
                    first.latex.insert_str(0, sign);
                    first.width += sign.len();
                }
                all.extend(own);
            }
            all
        }
        Formula::Neg(a) if formula.width() > wide => {
            let mut own = if a.precedence() < Precedence::Product {
                bracketed(a, wide)
            } else {
                pieces(a, wide)
            };
            if let Some(first) = own.first_mut() {
                first.latex.insert(0, '-');
            }
            own
        }
        Formula::Product(factors) => match factors.split_last() {
            Some((sum @ Formula::Sum(_), before)) if sum.width() > wide => {
                let mut own = bracketed(sum, wide);
                if let Some(first) = own.first_mut() {
                    let before = Formula::Product(before.to_vec());
                    first.latex.insert_str(0, &format!("{}\\,", before.latex()));
                    first.width += before.width();
                }
                own
            }
            _ => whole(),
        },
        _ => whole(),
    }
}

/// A sum in brackets that may stand on two lines.
fn bracketed(formula: &Formula, wide: usize) -> Vec<Piece> {
    if formula.width() <= wide {
        return vec![Piece {
            latex: brackets(formula),
            width: formula.width() + 2,
        }];
    }
    let mut inside = pieces(formula, wide);
    if let Some(first) = inside.first_mut() {
        first.latex.insert_str(0, "\\bigl(");
    }
    if let Some(last) = inside.last_mut() {
        last.latex.push_str("\\bigr)");
    }
    inside
}

fn sum(terms: &[Term]) -> String {
    let mut text = String::new();
    for (n, Term { negative, formula }) in terms.iter().enumerate() {
        text.push_str(match (n, negative) {
            (0, false) => "",
            (0, true) => "-",
            (_, false) => " + ",
            (_, true) => " - ",
        });
        text.push_str(&within(formula, Precedence::Product));
    }
    text
}

/// Factors with thin spaces between them. What stands after a function is no part of its argument, so that goes into brackets.
fn product(factors: &[Formula]) -> String {
    let mut text = String::new();
    for (n, factor) in factors.iter().enumerate() {
        let next_is_function = factors.get(n + 1).is_none_or(is_function);
        let latex = match factor {
            Formula::Call(function, arguments) => call(function, "", arguments, !next_is_function),
            Formula::Power(base, exponent) => power(base, exponent, !next_is_function),
            _ => within(factor, Precedence::Product),
        };
        if n > 0 {
            text.push_str(match latex.as_str() {
                latex if latex.starts_with(|c: char| c.is_ascii_digit()) => " \\cdot ",
                latex if latex.starts_with("\\left") => "",
                _ => "\\,",
            });
        }
        text.push_str(&latex);
    }
    text
}

fn is_function(formula: &Formula) -> bool {
    match formula {
        Formula::Call(function, _) => FUNCTIONS.contains(&function.as_str()),
        Formula::Power(base, exponent) => is_function(base) && matches!(**exponent, Formula::Number(_)),
        _ => false,
    }
}

fn power(base: &Formula, exponent: &Formula, closed: bool) -> String {
    // fractions lie on one line here
    let exponent_text = if is_tall(exponent) {
        exponent.to_string()
    } else {
        exponent.latex()
    };
    let whole = matches!(exponent, Formula::Number(n) if n.denom().is_one() && n.is_positive());
    match base {
        Formula::Call(function, arguments) if whole && FUNCTIONS.contains(&function.as_str()) && function != "exp" => {
            call(function, &format!("^{{{exponent_text}}}"), arguments, closed)
        }
        // a power beside a root or another power is easily taken for a part of it
        Formula::Call(function, _) if function != "dot" && function != "abs" => {
            format!("{}^{{{exponent_text}}}", brackets(base))
        }
        Formula::Number(n) if !n.denom().is_one() => format!("{}^{{{exponent_text}}}", brackets(base)),
        _ => format!("{}^{{{exponent_text}}}", within(base, Precedence::Atom)),
    }
}

/// A function and its argument, in brackets where `closed` says so or where it is more than a name.
fn call(function: &str, raised: &str, arguments: &[Formula], closed: bool) -> String {
    let inside: Vec<String> = arguments.iter().map(Formula::latex).collect();
    let inside = inside.join(",\\,");
    match (function, arguments) {
        ("dot", [Formula::Name(name)]) => accented("\\dot", name),
        ("ddot", [Formula::Name(name)]) => accented("\\ddot", name),
        ("sqrt", _) => format!("\\sqrt{{{inside}}}"),
        ("abs", _) => format!("\\left|{inside}\\right|"),
        (_, [argument]) => {
            let name = function_name(function);
            let plain = !closed && matches!(argument, Formula::Name(_));
            if plain {
                format!("{name}{raised} {inside}")
            } else {
                format!("{name}{raised}{}", brackets(argument))
            }
        }
        _ => format!("{}{raised}\\left({inside}\\right)", function_name(function)),
    }
}

fn function_name(function: &str) -> String {
    if FUNCTIONS.contains(&function) {
        return format!("\\{function}");
    }
    format!("\\operatorname{{{function}}}")
}

fn within(formula: &Formula, least: Precedence) -> String {
    if formula.precedence() < least {
        brackets(formula)
    } else {
        formula.latex()
    }
}

fn brackets(formula: &Formula) -> String {
    if is_tall(formula) {
        format!("\\left({}\\right)", formula.latex())
    } else {
        format!("({})", formula.latex())
    }
}

/// Whether the formula is higher than a line of text.
fn is_tall(formula: &Formula) -> bool {
    match formula {
        Formula::Quotient(..) => true,
        Formula::Number(_) => formula.precedence() == Precedence::Product,
        Formula::Call(function, _) if function == "sqrt" => true,
        _ => formula.parts().into_iter().any(is_tall),
    }
}

/// `theta1` as `\theta_1`, `inertia` upright, `r_max` with an index.
fn latex_name(name: &str) -> String {
    let (stem, rest) = parts_of_name(name);
    indexed(letter(stem), &rest)
}

/// The name with an accent on its letter.
fn accented(accent: &str, name: &str) -> String {
    let (stem, rest) = parts_of_name(name);
    indexed(format!("{accent}{{{}}}", letter(stem)), &rest)
}

fn indexed(stem: String, rest: &[&str]) -> String {
    if rest.is_empty() {
        return stem;
    }
    let rest: Vec<String> = rest.iter().map(|part| letter(part)).collect();
    format!("{stem}_{{{}}}", rest.join(","))
}

/// A letter or a number as it is, a Greek letter by its name, anything else upright.
fn letter(part: &str) -> String {
    if GREEK.contains(&part) {
        format!("\\{part}")
    } else if part.chars().count() == 1 || part.chars().all(|c| c.is_ascii_digit()) {
        part.to_owned()
    } else {
        format!("\\mathrm{{{part}}}")
    }
}

/// A name without its indices, and the indices: a number at the end, and what follows underscores.
fn parts_of_name(name: &str) -> (&str, Vec<&str>) {
    let mut parts = name.split('_').filter(|part| !part.is_empty());
    let first = parts.next().unwrap_or("");
    let stem = first.trim_end_matches(|c: char| c.is_ascii_digit());
    let (stem, number) = if stem.is_empty() {
        (first, "")
    } else {
        first.split_at(stem.len())
    };
    let rest = std::iter::once(number).filter(|number| !number.is_empty()).chain(parts);
    (stem, rest.collect())
}
