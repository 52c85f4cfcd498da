//! Names, colons, brackets and lists, with messages for other tokens in their place.

use syn::ext::IdentExt;
use syn::parse::{ParseBuffer, ParseStream};
use syn::{Ident, Token, braced, bracketed, parenthesized, token};

use super::ITEMS;
use crate::error::{Code, Errors, at};

/// Names of the fields of bodies; each of these words begins a field.
pub(super) const FIELDS: [&str; 15] = [
    "mass",
    "com",
    "inertia",
    "solids",
    "joint",
    "coordinate",
    "orientation",
    "position",
    "motion",
    "friction",
    "spring",
    "torque",
    "dry_friction",
    "static_friction",
    "stop",
];

/// Parses a name. Messages call it `what`, and show the syntax `form`.
///
/// Each name has one spelling: only keywords keep the `r#` of a raw identifier.
pub(super) fn identifier(input: ParseStream, what: &str, form: &str) -> syn::Result<Ident> {
    if let Ok(ident) = input.parse::<Ident>() {
        let (text, plain) = (ident.to_string(), ident.unraw().to_string());
        return match (is_identifier(&text), is_identifier(&plain)) {
            (true, true) => Ok(Ident::new(&plain, ident.span())),
            (true, false) => Ok(ident),
            (false, _) => Err(is_keyword(&ident)),
        };
    }
    if let Ok(keyword) = input.call(Ident::parse_any) {
        return Err(is_keyword(&keyword));
    }
    Err(at(
        Code::Syntax,
        input.span(),
        format_args!("expected {what}"),
        format_args!("write `{form}`"),
    ))
}

/// True if a text is a valid identifier. `gen` is a keyword since edition 2024, but not in `syn`.
pub(crate) fn is_identifier(text: &str) -> bool {
    text != "gen" && syn::parse_str::<Ident>(text).is_ok()
}

/// Returns the error for a keyword in place of a name.
pub(super) fn is_keyword(word: &Ident) -> syn::Error {
    let raw = !["self", "Self", "super", "crate", "_"]
        .iter()
        .any(|never| word == never);
    let help = if raw {
        format!("choose another name, or write `r#{word}`")
    } else {
        "choose another name".to_owned()
    };
    let fact = format_args!("`{word}` is a keyword of Rust");
    at(Code::NameTaken, word.span(), fact, help)
}

/// Parses the colon after a word. Reports and accepts an equals sign in its place.
pub(super) fn colon(input: ParseStream, after: &Ident, errors: &mut Errors) -> syn::Result<()> {
    if input.parse::<Option<Token![:]>>()?.is_some() {
        return Ok(());
    }
    let error = at(
        Code::Syntax,
        input.span(),
        format_args!("expected a colon after `{after}`"),
        format_args!("write `{after}: ..`"),
    );
    if input.parse::<Option<Token![=]>>()?.is_none() {
        return Err(error);
    }
    errors.push(error);
    Ok(())
}

/// Parses braces, and returns their contents.
pub(super) fn braces<'a>(input: &ParseBuffer<'a>, what: &str, form: &str) -> syn::Result<ParseBuffer<'a>> {
    if !input.peek(token::Brace) {
        return Err(at(
            Code::Syntax,
            input.span(),
            format_args!("expected {what} in braces"),
            format_args!("write `{form}`"),
        ));
    }
    let inner;
    braced!(inner in input);
    Ok(inner)
}

/// Parses square brackets, and returns their contents.
pub(super) fn brackets<'a>(input: &ParseBuffer<'a>, what: &str, form: &str) -> syn::Result<ParseBuffer<'a>> {
    if !input.peek(token::Bracket) {
        let fact = format_args!("expected {what} in square brackets");
        return Err(at(Code::Syntax, input.span(), fact, format_args!("write `{form}`")));
    }
    let inner;
    bracketed!(inner in input);
    Ok(inner)
}

/// Parses parentheses, if there are any, and returns their contents.
pub(super) fn parentheses<'a>(input: &ParseBuffer<'a>) -> syn::Result<Option<ParseBuffer<'a>>> {
    if !input.peek(token::Paren) {
        return Ok(None);
    }
    let inner;
    parenthesized!(inner in input);
    Ok(Some(inner))
}

/// Parses `e, e, ..` up to the end of the input; messages show the syntax `form`.
pub(super) fn list<T>(
    input: ParseStream,
    form: &str,
    mut entry: impl FnMut(ParseStream) -> syn::Result<T>,
) -> syn::Result<Vec<T>> {
    let mut entries = Vec::new();
    while !input.is_empty() {
        if let Some(label) = label(input) {
            let fact = format_args!("`{label}:` is not allowed here: entries are positional");
            return Err(at(Code::Arguments, label.span(), fact, format_args!("write `{form}`")));
        }
        entries.push(entry(input)?);
        if !input.is_empty() && input.parse::<Option<Token![,]>>()?.is_none() {
            return Err(unexpected(input));
        }
    }
    Ok(entries)
}

/// Returns the next word if a colon follows it.
pub(super) fn label(input: ParseStream) -> Option<Ident> {
    let (word, rest) = input.cursor().ident()?;
    let (colon, _) = rest.punct()?;
    let is_path = input.peek2(Token![::]);
    (colon.as_char() == ':' && !is_path).then_some(word)
}

/// True if a known item or field begins here.
pub(super) fn starts_known(input: ParseStream) -> bool {
    let word = input.cursor().ident().map(|(word, _)| word);
    let is_item = word.is_some_and(|word| ITEMS.iter().any(|item| word == item))
        && (input.peek2(Ident) || input.peek2(Token![:]) || input.peek2(token::Brace));
    input.peek(Token![let]) || is_item || label(input).is_some_and(|word| is_field(&word.to_string()))
}

/// True if bodies have a field of this name.
pub(super) fn is_field(name: &str) -> bool {
    FIELDS.contains(&name)
}

/// True if an item, a field or a parameter begins here.
pub(crate) fn starts_item(input: ParseStream) -> bool {
    starts_known(input) || label(input).is_some()
}

/// Checks that nothing is left in the brackets.
pub(super) fn end_of(input: ParseStream) -> syn::Result<()> {
    if input.is_empty() {
        Ok(())
    } else {
        Err(unexpected(input))
    }
}

/// Returns the error for a token in place of a comma or an operator.
pub(super) fn unexpected(input: ParseStream) -> syn::Error {
    let mark = input.cursor().punct().map(|(punct, _)| punct.as_char());
    let (code, fact, help) = match mark {
        _ if starts_item(input) => (Code::Syntax, "expected a comma", "items and entries end in a comma"),
        _ if input.peek(Token![as]) => (
            Code::NotInLanguage,
            "`as` is not allowed: all numbers have one type",
            "remove `as`",
        ),
        Some(';') => (
            Code::Syntax,
            "expected a comma, not a semicolon",
            "items and entries end in a comma",
        ),
        Some(':') => (
            Code::Syntax,
            "a colon is not allowed here",
            "only parameters and inputs declare units",
        ),
        Some('=') if !input.peek(Token![==]) => (
            Code::Syntax,
            "`=` is not allowed here",
            "it sets the default of a parameter or the value of a `let`; the initial condition is an argument of \
             `solve`",
        ),
        Some('<' | '>' | '=' | '!') => (
            Code::NotInLanguage,
            "comparisons are not allowed here",
            "use a smooth law: `(1 + tanh(x/eps))/2` is a step at x = 0; an event is a zero, `event passes: x - 0.5`",
        ),
        Some('%' | '&' | '|' | '?' | '@' | '~' | '$') => {
            (Code::NotInLanguage, "unknown operator", "operators are + - * / ^")
        }
        _ => (
            Code::Syntax,
            "expected a comma or an operator",
            "items end in a comma; products need a `*`, functions parentheses",
        ),
    };
    at(code, input.span(), fact, help)
}
