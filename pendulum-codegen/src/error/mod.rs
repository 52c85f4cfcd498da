//! Errors in a declaration: collected, so that all are reported at once, each on the token at fault.

use proc_macro2::{Ident, Span, TokenStream};
use quote::ToTokens;

use crate::words::{Advice, Synonyms, advice};

pub use code::Code;

mod code;

/// The errors found so far, in the order of their places in the source.
#[derive(Debug, Default)]
pub struct Errors {
    all: Vec<syn::Error>,
    /// A file, and the place on which errors are errors in it.
    file: Option<(Span, String)>,
}

/// Proof that an error has been noted: whoever gets one in place of a value need not report again.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Reported(());

impl Errors {
    /// One error on one place.
    pub fn one(code: Code, span: Span, fact: impl std::fmt::Display, help: impl std::fmt::Display) -> Self {
        Self::from(at(code, span, fact, help))
    }

    /// Notes an error on a whole syntax node: what is wrong, and what to do about it.
    pub fn on(
        &mut self,
        code: Code,
        node: impl ToTokens,
        fact: impl std::fmt::Display,
        help: impl std::fmt::Display,
    ) -> Reported {
        self.push(on(code, node, fact, help))
    }

    /// Notes an error on one place.
    pub fn at(
        &mut self,
        code: Code,
        span: Span,
        fact: impl std::fmt::Display,
        help: impl std::fmt::Display,
    ) -> Reported {
        self.push(at(code, span, fact, help))
    }

    /// Notes an error on a word that is not among the `known` ones.
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

    /// Notes an error.
    pub fn push(&mut self, error: syn::Error) -> Reported {
        let place = |error: &syn::Error| {
            let start = error.span().start();
            (start.line, start.column)
        };
        let error = match &self.file {
            Some((span, name)) if self.is_in_file(error.span()) => {
                let (message, start) = (error.to_string(), format!("`{name}`"));
                // what is wrong with the file itself says so
                let known = message.contains(&start);
                if known {
                    error
                } else {
                    syn::Error::new(*span, format!("{start}: {message}"))
                }
            }
            _ => error,
        };
        // after those that were found on the same place
        let at = self.all.partition_point(|other| place(other) <= place(&error));
        self.all.insert(at, error);
        Reported(())
    }

    /// Says that what stands on a place comes from a file.
    pub(crate) fn read_from(&mut self, span: Span, name: &str) {
        self.file = Some((span, name.to_owned()));
    }

    /// No errors yet, with the same file.
    pub(crate) fn afresh(&self) -> Self {
        Self {
            all: Vec::new(),
            file: self.file.clone(),
        }
    }

    /// Whether a syntax node comes from a file.
    pub(crate) fn is_from_file(&self, node: impl ToTokens) -> bool {
        let mut tokens = node.into_token_stream().into_iter();
        tokens.any(|token| self.is_in_file(token.span()))
    }

    /// Whether what stands on a place comes from a file.
    pub(crate) fn is_in_file(&self, span: Span) -> bool {
        let ends = |span: Span| {
            let [start, end] = [span.start(), span.end()];
            [start.line, start.column, end.line, end.column]
        };
        self.file.as_ref().is_some_and(|(file, _)| ends(*file) == ends(span))
    }

    /// Keeps the value, or notes the error.
    pub fn keep<T>(&mut self, result: syn::Result<T>) -> Result<T, Reported> {
        result.map_err(|error| self.push(error))
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.all.is_empty()
    }

    /// The errors, in the order of their places in the source.
    pub fn iter(&self) -> impl Iterator<Item = &syn::Error> {
        self.all.iter()
    }

    /// That an error has been noted, where one must have been.
    pub(crate) fn noted(&self) -> Reported {
        debug_assert!(!self.all.is_empty(), "no error has been noted");
        Reported(())
    }

    /// Ends a phase: the value, or all errors.
    pub fn finish<T>(self, value: T) -> Result<T, Self> {
        if self.all.is_empty() { Ok(value) } else { Err(self) }
    }

    /// The errors as `compile_error!` items.
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

/// An error on a whole syntax node.
pub(crate) fn on(
    code: Code,
    node: impl ToTokens,
    fact: impl std::fmt::Display,
    help: impl std::fmt::Display,
) -> syn::Error {
    syn::Error::new_spanned(node, message(code, fact, help))
}

/// An error on one place.
pub(crate) fn at(code: Code, span: Span, fact: impl std::fmt::Display, help: impl std::fmt::Display) -> syn::Error {
    syn::Error::new(span, message(code, fact, help))
}

fn message(code: Code, fact: impl std::fmt::Display, help: impl std::fmt::Display) -> String {
    format!("{fact} [{code}]\nhelp: {help}")
}
