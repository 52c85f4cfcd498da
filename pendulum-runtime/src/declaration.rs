//! From text to a program, or to its errors.

use std::collections::BTreeMap;
use std::error;
use std::fmt;
use std::path::{Path, PathBuf};

use pendulum_codegen::program::Program;
use pendulum_codegen::{Sources, Unreadable, Wanted};
use proc_macro2::{Span, TokenStream, TokenTree};

use crate::worker;

/// Longest line that a message shows, in bytes.
const LONGEST: usize = 300;

/// Errors in a declaration, in the order of the text, as `mechanism!` reports them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DeclarationError {
    /// Errors; at least one.
    pub problems: Vec<Problem>,
}

/// An error in a declaration.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Problem {
    /// Line in the text, starting at 1.
    pub line: usize,
    /// Column in the line, in characters, starting at 1.
    pub column: usize,
    /// Number of characters at fault in this line, at least 1.
    pub width: usize,
    /// Text of the line.
    pub source: String,
    /// Code, such as `M002`, with a page in the documentation.
    pub code: String,
    /// The mistake.
    pub message: String,
    /// The remedy.
    pub help: String,
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let number = self.line.to_string();
        let margin = " ".repeat(number.len());
        writeln!(f, "error[{}]: {}", self.code, self.message)?;
        writeln!(f, "{margin}--> line {}, column {}", self.line, self.column)?;
        // not a text in a single line
        if self.source.len() <= LONGEST {
            writeln!(f, "{margin} |")?;
            writeln!(f, "{number} | {}", self.source)?;
            let before = " ".repeat(self.column.saturating_sub(1));
            writeln!(f, "{margin} | {before}{}", "^".repeat(self.width))?;
        }
        write!(f, "{margin} = help: {}", self.help)
    }
}

impl fmt::Display for DeclarationError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (n, problem) in self.problems.iter().enumerate() {
            if n > 0 {
                f.write_str("\n\n")?;
            }
            problem.fmt(f)?;
        }
        Ok(())
    }
}

impl error::Error for DeclarationError {}

/// The text of a declaration, with files and added words.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Declaration {
    text: String,
    folder: PathBuf,
    files: BTreeMap<String, String>,
    also: Vec<String>,
    only: bool,
}

impl Declaration {
    /// A declaration; files of robots are relative to the working directory.
    #[must_use]
    pub fn new(text: &str) -> Self {
        Self {
            text: text.to_owned(),
            ..Self::default()
        }
    }

    /// Sets the folder to which the paths of files are relative.
    #[must_use]
    pub fn folder(mut self, folder: impl AsRef<Path>) -> Self {
        self.folder = folder.as_ref().to_owned();
        self
    }

    /// Adds a file of a robot by its name and text, where there is no file system.
    #[must_use]
    pub fn file(mut self, name: &str, text: &str) -> Self {
        self.files.insert(name.to_owned(), text.to_owned());
        self
    }

    /// Adds words to the list `generate` of the declaration, except those that the mechanism cannot have, such as
    /// `canonical` with a ball joint. A word that no declaration can have is an error of the declaration.
    #[must_use]
    pub fn also<'w>(mut self, words: impl IntoIterator<Item = &'w str>) -> Self {
        self.also.extend(words.into_iter().map(str::to_owned));
        self
    }

    /// Leaves out what the declaration lists in `generate`, except `rhs`, and the equations as text: a model in about
    /// half the time, for its motion. Words that are [added](Self::also) are generated.
    #[must_use]
    pub fn only_motion(mut self) -> Self {
        self.only = true;
        self
    }

    /// Generated code in C99: the texts of `<name>.h` and `<name>.c`.
    ///
    /// # Errors
    /// If the declaration is wrong, as `mechanism!` reports.
    pub fn c(&self) -> Result<Sources, DeclarationError> {
        Ok(pendulum_codegen::c(&self.program()?))
    }

    /// Items that `mechanism!` generates, without the words that were [added](Self::also). prettyplease formats them
    /// for reading.
    ///
    /// # Errors
    /// If the declaration is wrong, as `mechanism!` reports.
    pub fn rust(&self) -> Result<String, DeclarationError> {
        self.program()?;
        Ok(worker::alone(|| {
            let tokens: TokenStream = self.text.parse().expect("the text was compiled");
            pendulum_codegen::expand_with(unwrapped(tokens), &|name| self.file_of(name)).to_string()
        }))
    }

    /// Text of the declaration.
    #[cfg(feature = "full")]
    pub(crate) fn text(&self) -> &str {
        &self.text
    }

    /// Bodies of the robot of a file, as text, unless the declaration changes its links.
    #[cfg(feature = "full")]
    pub(crate) fn robot_bodies(&self) -> Option<String> {
        worker::alone(|| {
            let tokens: TokenStream = self.text.parse().ok()?;
            pendulum_codegen::robot_bodies(unwrapped(tokens), &|name| self.file_of(name))
        })
    }

    /// Another text, with the files of this declaration.
    #[cfg(feature = "full")]
    pub(crate) fn with_text(&self, text: &str) -> Self {
        Self {
            text: text.to_owned(),
            ..self.clone()
        }
    }

    /// Compiles the declaration.
    pub(crate) fn program(&self) -> Result<Program, DeclarationError> {
        worker::alone(|| {
            let text = self.text.as_str();
            let tokens: TokenStream = text.parse().map_err(|error: proc_macro2::LexError| {
                let help = "close each bracket and quotation mark, and write no characters that Rust does not know";
                problem(
                    text,
                    error.span(),
                    "the text cannot be split into tokens from here on [M001]",
                    help,
                )
            })?;
            let also: Vec<&str> = self.also.iter().map(String::as_str).collect();
            let wanted = if self.only {
                Wanted::Only(&also)
            } else {
                Wanted::Also(&also)
            };
            let program = pendulum_codegen::program_with(unwrapped(tokens), wanted, &|name| self.file_of(name));
            program.map_err(|errors| DeclarationError {
                problems: errors
                    .iter()
                    .map(|error| {
                        let message = error.to_string();
                        let (fact, help) = message.split_once("\nhelp: ").unwrap_or((&message, ""));
                        problem(text, error.span(), fact, help)
                    })
                    .collect(),
            })
        })
    }

    /// Text of a file, or why it cannot be read and a help text.
    fn file_of(&self, name: &str) -> Result<String, Unreadable> {
        if let Some(text) = self.files.get(name) {
            return Ok(text.clone());
        }
        let path = self.folder.join(name);
        if path.is_dir() {
            return Err((format!("`{name}` is a folder"), "write the path of a URDF file in it"));
        }
        std::fs::read_to_string(&path).map_err(|error| {
            let help = "a relative path begins at the folder given with the declaration, or at the working directory";
            (format!("`{}` cannot be read: {error}", path.display()), help)
        })
    }
}

/// Declaration without `mechanism! { .. }` around it, as it stands in Rust.
pub(crate) fn unwrapped(tokens: TokenStream) -> TokenStream {
    let all: Vec<TokenTree> = tokens.clone().into_iter().collect();
    match &all[..] {
        [TokenTree::Ident(name), TokenTree::Punct(mark), TokenTree::Group(group)]
            if name == "mechanism" && mark.as_char() == '!' =>
        {
            group.stream()
        }
        _ => tokens,
    }
}

impl From<Problem> for DeclarationError {
    fn from(problem: Problem) -> Self {
        Self {
            problems: vec![problem],
        }
    }
}

/// An error at a span of the text; the fact ends with its code in brackets.
fn problem(text: &str, span: Span, fact: &str, help: &str) -> Problem {
    let (start, end) = (span.start(), span.end());
    let source = text.lines().nth(start.line.saturating_sub(1)).unwrap_or_default();
    let rest = source.chars().count().saturating_sub(start.column).max(1);
    let width = match end.line == start.line {
        true => end.column.saturating_sub(start.column).clamp(1, rest),
        false => rest,
    };
    let (message, code) = match fact.rsplit_once(" [") {
        Some((message, code)) => (message, code.trim_end_matches(']')),
        None => (fact, ""),
    };
    Problem {
        line: start.line,
        column: start.column + 1,
        width,
        source: source.to_owned(),
        code: code.to_owned(),
        message: message.to_owned(),
        help: help.to_owned(),
    }
}

/// A robot from a URDF file, with gravity and without further bodies; write a declaration for more.
#[derive(Clone, Debug, PartialEq)]
pub struct Robot {
    path: PathBuf,
    gravity: [f64; 3],
    limits: bool,
    repair: bool,
    generate: Vec<String>,
}

impl Robot {
    /// The robot of a file, with gravity of 9.81 m/s^2 against z, and without stops.
    pub fn new(path: impl AsRef<Path>) -> Self {
        Self {
            path: path.as_ref().to_owned(),
            gravity: [0.0, 0.0, -9.81],
            limits: false,
            repair: false,
            generate: ["rhs", "jacobian", "energy", "inverse_dynamics", "shapes"]
                .map(str::to_owned)
                .into(),
        }
    }

    /// Sets the gravity, in m/s^2.
    #[must_use]
    pub fn gravity(mut self, gravity: [f64; 3]) -> Self {
        self.gravity = gravity;
        self
    }

    /// Turns the limits of the joints into stops.
    #[must_use]
    pub fn limits(mut self, limits: bool) -> Self {
        self.limits = limits;
        self
    }

    /// Replaces inertias that no body can have by the nearest possible ones.
    #[must_use]
    pub fn repair(mut self, repair: bool) -> Self {
        self.repair = repair;
        self
    }

    /// Sets the functions to generate: the words of `generate` in a declaration. Default: `rhs`, `jacobian`, `energy`,
    /// `inverse_dynamics` and `shapes`.
    #[must_use]
    pub fn generate<'w>(mut self, words: impl IntoIterator<Item = &'w str>) -> Self {
        self.generate = words.into_iter().map(str::to_owned).collect();
        self
    }

    /// Declaration of the robot, to be extended or printed.
    #[must_use]
    pub fn declaration(&self) -> String {
        let words = [(self.limits, ", limits"), (self.repair, ", repair")];
        let words: String = words.iter().filter(|(has, _)| *has).map(|(_, word)| *word).collect();
        let [x, y, z] = self.gravity;
        format!(
            "pub Robot {{\n    robot: urdf({:?}{words}),\n    gravity: [{x:?}, {y:?}, {z:?}],\n    \
             generate: [{}],\n}}\n",
            self.path.display().to_string(),
            self.generate.join(", "),
        )
    }
}
