//! The questions: a declaration, and the computation of a figure, in a file each.

pub(crate) mod bits;
pub(crate) mod creep;
pub(crate) mod energy;
pub(crate) mod exponents;
pub(crate) mod generation;
pub(crate) mod gradient;
pub(crate) mod linkage;
pub(crate) mod printed;
pub(crate) mod rebounds;
pub(crate) mod sampling;

use std::error::Error;

/// Answer to a question. All but the time has the same bits on every machine: functions are those of `pendulum_core`,
/// not of the platform.
#[derive(Debug)]
pub(crate) struct Answer {
    pub(crate) figure: f64,
    /// The figure in words, as the page has it.
    pub(crate) text: String,
    /// Time in s, where the question asks for it.
    pub(crate) seconds: Option<f64>,
}

impl Answer {
    fn new(figure: f64, text: String) -> Self {
        Self {
            figure,
            text,
            seconds: None,
        }
    }
}

pub(crate) type Question = fn() -> Result<Answer, Box<dyn Error>>;

/// All questions, in the order of the page.
pub(crate) const ALL: [(&str, Question); 10] = [
    ("creep", creep::answer),
    ("linkage", linkage::answer),
    ("rebounds", rebounds::answer),
    ("gradient", gradient::answer),
    ("energy", energy::answer),
    ("exponents", exponents::answer),
    ("bits", bits::answer),
    ("sampling", sampling::answer),
    ("generation", generation::answer),
    ("printed", printed::answer),
];
