//! First-order states.

use syn::Ident;
use syn::ext::IdentExt;
use syn::parse::ParseStream;

use super::token::{braces, colon, identifier};
use super::{End, docs, each, once, read};
use crate::ast::State;
use crate::error::{Code, Errors, at};
use crate::words::{self, Advice, advice};

const FORM: &str = "state i { unit: A, rate: (u - r*i)/l }";
const FIELDS: [&str; 2] = ["unit", "rate"];

/// `name { unit: unit, rate: e }`, after the word `state`
pub(super) fn state(input: ParseStream, docs: Vec<String>, errors: &mut Errors) -> syn::Result<State> {
    let name = identifier(input, "the name of a state", FORM)?;
    let inner = braces(input, &format!("the unit and the rate of state `{name}`"), FORM)?;
    let mut state = State {
        docs,
        name,
        unit: None,
        rate: None,
        unread: None,
    };
    state.unread = each(&inner, errors, |input, errors| field(input, &mut state, errors));
    Ok(state)
}

fn field(input: ParseStream, state: &mut State, errors: &mut Errors) -> syn::Result<End> {
    docs(input)?;
    let help = format!("known here: {}", FIELDS.join(", "));
    let mut key = input
        .call(Ident::parse_any)
        .map_err(|e| at(Code::Syntax, e.span(), "expected a field", &help))?;
    if !FIELDS.iter().any(|known| key == known) {
        let Advice { meant, help } = advice(&key.to_string(), FIELDS, words::STATE);
        let fact = format_args!("unknown field `{key}`");
        let error = at(Code::UnknownWord, key.span(), fact, help);
        let meant = meant.ok_or_else(|| error.clone())?;
        errors.push(error);
        key = Ident::new(meant, key.span());
    }
    colon(input, &key, errors)?;
    if key == "unit" {
        once(&mut state.unit, read(input, |_| false), &key)?;
    } else {
        once(&mut state.rate, read(input, |_| false), &key)?;
    }
    Ok(End::Comma)
}
