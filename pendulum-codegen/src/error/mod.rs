//! Errors in a declaration: collected and reported all at once, each at the token at fault.

use proc_macro2::{Ident, Span, TokenStream};
use quote::ToTokens;

use crate::words::{Advice, Synonyms, advice};

pub use code::Code;

mod code;

/// Errors in a declaration, in source order.
#[derive(Debug, Default)]
pub struct Errors {
    all: Vec<syn::Error>,
    /// Span and name of a file: errors at this span are errors in the file.
    file: Option<(Span, String)>,
}

/// Proof that an error has been recorded: code that gets it in place of a value need not report again.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Reported(());

impl Errors {
    /// Returns a collection with one error at a span.
    pub fn one(code: Code, span: Span, fact: impl std::fmt::Display, help: impl std::fmt::Display) -> Self {
        Self::from(at(code, span, fact, help))
    }

    /// Records an error on a whole syntax node: the fact and a help text.
    pub fn on(
        &mut self,
        code: Code,
        node: impl ToTokens,
        fact: impl std::fmt::Display,
        help: impl std::fmt::Display,
    ) -> Reported {
        self.push(on(code, node, fact, help))
    }

    /// Records an error at a span.
    pub fn at(
        &mut self,
        code: Code,
        span: Span,
        fact: impl std::fmt::Display,
        help: impl std::fmt::Display,
    ) -> Reported {
        self.push(at(code, span, fact, help))
    }

    /// Records an error about a word that is not among the `known` ones.
    pub(crate) fn unknown<'a>(
        &mut self,
        code: Code,
        word: &Ident,
        fact: impl std::fmt::Display,
        known: impl IntoIterator<Item = &'a str>,
        synonyms: &'static Synonyms,
    ) -> Reported {
        let Advice { help, .. } = advice(&word.to_string(), known, synonyms);
        self.at(code, word.span(), fact, help)
    }

    /// Records an error.
    pub fn push(&mut self, error: syn::Error) -> Reported {
        let place = |error: &syn::Error| {
            let start = error.span().start();
            (start.line, start.column)
        };
        let error = match &self.file {
            Some((span, name)) if self.is_in_file(error.span()) => {
                let (message, start) = (error.to_string(), format!("`{name}`"));
                // messages about the file itself already name it
                let known = message.contains(&start);
                if known {
                    error
                } else {
                    syn::Error::new(*span, format!("{start}: {message}"))
                }
            }
            _ => error,
        };
        // after earlier errors at the same place
        let at = self.all.partition_point(|other| place(other) <= place(&error));
        self.all.insert(at, error);
        Reported(())
    }

    /// Sets the file whose errors are reported at a span.
    pub(crate) fn read_from(&mut self, span: Span, name: &str) {
        self.file = Some((span, name.to_owned()));
    }

    /// Returns an empty collection for the same file.
    pub(crate) fn afresh(&self) -> Self {
        Self {
            all: Vec::new(),
            file: self.file.clone(),
        }
    }

    /// True if a token of a syntax node comes from the file.
    pub(crate) fn is_from_file(&self, node: impl ToTokens) -> bool {
        let mut tokens = node.into_token_stream().into_iter();
        tokens.any(|token| self.is_in_file(token.span()))
    }

    /// True if a span refers to the file.
    pub(crate) fn is_in_file(&self, span: Span) -> bool {
        let ends = |span: Span| {
            let [start, end] = [span.start(), span.end()];
            [start.line, start.column, end.line, end.column]
        };
        self.file.as_ref().is_some_and(|(file, _)| ends(*file) == ends(span))
    }

    /// Returns the value, or records the error.
    pub fn keep<T>(&mut self, result: syn::Result<T>) -> Result<T, Reported> {
        result.map_err(|error| self.push(error))
    }

    /// True if there are no errors.
    pub fn is_empty(&self) -> bool {
        self.all.is_empty()
    }

    /// Iterates over the errors in source order.
    pub fn iter(&self) -> impl Iterator<Item = &syn::Error> {
        self.all.iter()
    }

    /// Returns the proof of an error that was recorded before.
    pub(crate) fn noted(&self) -> Reported {
        debug_assert!(!self.all.is_empty(), "no error has been noted");
        Reported(())
    }

    /// Ends a phase: returns the value, or all errors.
    pub fn finish<T>(self, value: T) -> Result<T, Self> {
        if self.all.is_empty() { Ok(value) } else { Err(self) }
    }

    /// Converts the errors to `compile_error!` items.
    pub fn to_compile_errors(&self) -> TokenStream {
        self.iter().map(syn::Error::to_compile_error).collect()
    }
}

impl std::fmt::Display for Errors {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        for (n, error) in self.all.iter().enumerate() {
            let start = error.span().start();
            let end = if n + 1 < self.all.len() { "\n" } else { "" };
            write!(f, "{}:{}: {error}{end}", start.line, start.column + 1)?;
        }
        Ok(())
    }
}

impl std::error::Error for Errors {}

impl From<syn::Error> for Errors {
    fn from(error: syn::Error) -> Self {
        Self {
            all: vec![error],
            file: None,
        }
    }
}

/// Returns an error on a whole syntax node.
pub(crate) fn on(
    code: Code,
    node: impl ToTokens,
    fact: impl std::fmt::Display,
    help: impl std::fmt::Display,
) -> syn::Error {
    syn::Error::new_spanned(node, message(code, fact, help))
}

/// Returns an error at a span.
pub(crate) fn at(code: Code, span: Span, fact: impl std::fmt::Display, help: impl std::fmt::Display) -> syn::Error {
    syn::Error::new(span, message(code, fact, help))
}

fn message(code: Code, fact: impl std::fmt::Display, help: impl std::fmt::Display) -> String {
    format!("{fact} [{code}]\nhelp: {help}")
}
