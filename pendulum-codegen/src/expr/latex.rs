//! Formulas in LaTeX, for documents that load `amsmath`.

mod lines;

pub(crate) use lines::latex_definitions;

use num_traits::{One, Signed};

use super::text::number;
use super::{Formula, Precedence, Summand};

/// Functions with a LaTeX command of the same name.
const FUNCTIONS: [&str; 6] = ["sin", "cos", "tan", "exp", "ln", "tanh"];

/// Names of Greek letters, each also a LaTeX command.
const GREEK: [&str; 34] = [
    "alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "iota", "kappa", "lambda", "mu", "nu", "xi",
    "pi", "rho", "sigma", "tau", "upsilon", "phi", "chi", "psi", "omega", "Gamma", "Delta", "Theta", "Lambda", "Xi",
    "Pi", "Sigma", "Upsilon", "Phi", "Psi", "Omega",
];

impl Formula {
    /// The formula on one line.
    pub fn latex(&self) -> String {
        match self {
            Self::Number(n) if !n.denom().is_one() && self.precedence() < Precedence::Atom && !n.is_negative() => {
                format!("\\frac{{{}}}{{{}}}", n.numer(), n.denom())
            }
            Self::Number(n) if n.is_negative() => format!("-{}", Self::Number(-n).latex()),
            Self::Number(n) => number(n),
            Self::Measured(number, unit) => format!("{number}\\,\\mathrm{{{}}}", unit.replace(' ', "\\,")),
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
}

fn sum(terms: &[Summand]) -> String {
    let mut text = String::new();
    for (n, Summand { negative, formula }) in terms.iter().enumerate() {
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

/// Factors separated by thin spaces. The argument of a function is put into brackets if the next factor could be read
/// as a part of it.
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
    // fractions are written on one line here
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
        // an exponent beside a root or another exponent is easily misread as a part of it
        Formula::Call(function, _) if function != "dot" && function != "abs" => {
            format!("{}^{{{exponent_text}}}", brackets(base))
        }
        Formula::Number(n) if !n.denom().is_one() => format!("{}^{{{exponent_text}}}", brackets(base)),
        _ => format!("{}^{{{exponent_text}}}", within(base, Precedence::Atom)),
    }
}

/// A function and its argument; brackets surround it if `closed` is set or if it is more than a name.
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
    if FUNCTIONS.contains(&function) || ["max", "min"].contains(&function) {
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

/// True if the formula is taller than a line of text.
fn is_tall(formula: &Formula) -> bool {
    match formula {
        Formula::Quotient(..) => true,
        Formula::Number(_) => formula.precedence() == Precedence::Product,
        Formula::Call(function, _) if function == "sqrt" => true,
        _ => formula.parts().into_iter().any(is_tall),
    }
}

/// LaTeX of a name: `theta1` becomes `\theta_1`, `inertia` is upright, `r_max` has an index.
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

/// A letter or a number unchanged, a Greek letter by its command, anything else upright.
fn letter(part: &str) -> String {
    if GREEK.contains(&part) {
        format!("\\{part}")
    } else if part.chars().count() == 1 || part.chars().all(|c| c.is_ascii_digit()) {
        part.to_owned()
    } else {
        format!("\\mathrm{{{part}}}")
    }
}

/// Splits a name into its stem and its indices: a number at the end, and the parts after underscores.
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
