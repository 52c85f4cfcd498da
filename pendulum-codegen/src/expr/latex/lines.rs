//! Displayed equations, broken into lines.

use super::{GREEK, brackets, parts_of_name};
use crate::expr::text::number;
use crate::expr::{Definition, Formula, Precedence, Summand};

/// Width of a line, in letters.
const LINE: usize = 68;

impl Formula {
    /// Displayed equation with `left` on its left side, broken into lines as needed.
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

    /// Approximate width of the printed formula, in letters.
    fn width(&self) -> usize {
        match self {
            Self::Number(n) if self.precedence() == Precedence::Atom => number(n).len(),
            Self::Number(n) => n.numer().to_string().len().max(n.denom().to_string().len()) + 1,
            Self::Measured(number, unit) => number.len() + unit.len(),
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
    for definition in definitions {
        let (left, formula) = (definition.left(), &definition.formula);
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

/// A part of a formula without a line break.
struct Piece {
    latex: String,
    width: usize,
}

/// Splits the formula where a line may end: before the signs of sums, and inside brackets with wide contents.
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
            for (n, Summand { negative, formula }) in terms.iter().enumerate() {
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

/// A sum in brackets, which may be split over lines.
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
