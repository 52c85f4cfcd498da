//! The text of a declaration in parts that can be changed: its items, and the fields of those in braces.

use std::ops::Range;

use proc_macro2::{Delimiter, TokenStream, TokenTree};

use crate::declaration::unwrapped;

/// Items whose braces end them; the others end in a comma.
const BRACED: [&str; 5] = ["params", "state", "shape", "body", "wall"];

/// Part of the text: an item of the scene, or a field in its braces.
#[derive(Clone, Debug)]
pub(super) struct Part {
    /// First word.
    pub(super) word: String,
    /// Further words before a colon or braces: `upper on ground` of a body.
    pub(super) rest: String,
    /// Place in the text, with the comma after it.
    pub(super) place: Range<usize>,
    /// Place of what follows the colon, without the comma; of an item in braces, that of their inside.
    pub(super) value: Range<usize>,
    /// Fields in the braces.
    pub(super) fields: Vec<Part>,
}

/// The text of a declaration with its parts. It must be one that compiles.
#[derive(Clone, Debug)]
pub(super) struct Outline {
    pub(super) text: String,
    pub(super) items: Vec<Part>,
    /// Place of the first item.
    pub(super) begin: usize,
    /// Places of `dot(name)`, by name.
    rates: Vec<(String, Range<usize>)>,
}

impl Outline {
    pub(super) fn new(text: String) -> Self {
        let tokens: TokenStream = text.parse().expect("the text was compiled");
        let tokens: Vec<TokenTree> = unwrapped(tokens).into_iter().collect();
        let mut outline = Self {
            text,
            items: Vec::new(),
            begin: 0,
            rates: Vec::new(),
        };
        if let Some(TokenTree::Group(scene)) = tokens.last() {
            outline.begin = scene.span_open().byte_range().end;
            let inside: Vec<TokenTree> = scene.stream().into_iter().collect();
            outline.items = parts(&inside, true);
            outline.note_rates(&inside);
        }
        outline
    }

    fn note_rates(&mut self, tokens: &[TokenTree]) {
        for (n, token) in tokens.iter().enumerate() {
            match (token, tokens.get(n + 1)) {
                (TokenTree::Ident(name), Some(TokenTree::Group(group))) if name == "dot" => {
                    let place = name.span().byte_range().start..group.span_close().byte_range().end;
                    self.rates.push((group.stream().to_string(), place));
                }
                (TokenTree::Group(group), _) => self.note_rates(&group.stream().into_iter().collect::<Vec<_>>()),
                _ => {}
            }
        }
    }

    /// Items that begin with a word.
    pub(super) fn of(&self, word: &str) -> impl Iterator<Item = &Part> {
        self.items.iter().filter(move |item| item.word == word)
    }

    /// The body of this name.
    pub(super) fn body(&self, name: &str) -> Option<&Part> {
        self.of("body").find(|body| body.name() == name)
    }

    /// Text of a place.
    pub(super) fn at(&self, place: &Range<usize>) -> &str {
        &self.text[place.clone()]
    }

    /// Places of the rate of a coordinate.
    pub(super) fn rates_of(&self, name: &str) -> impl Iterator<Item = Range<usize>> {
        self.rates
            .iter()
            .filter(move |(own, _)| own == name)
            .map(|(_, place)| place.clone())
    }

    /// True if the scene has no units.
    pub(super) fn is_without_units(&self) -> bool {
        self.of("units").next().is_some()
    }

    /// Parameter, or other item, at a line and a column of the text, which start at 1.
    pub(super) fn around(&self, line: usize, column: usize) -> Option<&Part> {
        let begin: usize = self.text.split_inclusive('\n').take(line - 1).map(str::len).sum();
        let within = self.text[begin..].char_indices().nth(column - 1);
        let place = begin + within.map_or(0, |(n, _)| n);
        let item = self.items.iter().find(|item| item.place.contains(&place))?;
        match item.word.as_str() {
            "params" => item.fields.iter().find(|field| field.place.contains(&place)),
            _ => Some(item),
        }
    }

    /// True if there is a parameter or an input of this name.
    pub(super) fn gives(&self, name: &str) -> bool {
        let mut parameters = self.of("params").flat_map(|params| &params.fields);
        parameters.any(|own| own.word == name) || self.of("input").any(|input| input.name() == name)
    }

    /// Text with some places replaced.
    pub(super) fn with(&self, mut edits: Vec<(Range<usize>, String)>) -> String {
        edits.sort_by_key(|(place, _)| place.start);
        let mut text = String::new();
        let mut from = 0;
        for (place, new) in edits {
            // an edit in a part that is left out
            if place.start < from {
                continue;
            }
            text.push_str(&self.text[from..place.start]);
            text.push_str(&new);
            from = place.end;
        }
        text.push_str(&self.text[from..]);
        text
    }

    /// Edit that leaves out a part, and its line if nothing else is on it.
    pub(super) fn without(&self, part: &Part) -> (Range<usize>, String) {
        let Range { start, end } = part.place;
        let is_blank = |c: char| c == ' ' || c == '\t';
        let before = self.text[..start].trim_end_matches(is_blank);
        let after = self.text[end..].trim_start_matches(is_blank);
        let ends_line = after.starts_with('\n') || after.starts_with("//");
        let place = match before.ends_with('\n') && ends_line {
            true => before.len()..self.text.len() - after.find('\n').map_or(0, |n| after.len() - n - 1),
            false => before.len()..end,
        };
        (place, String::new())
    }
}

impl Part {
    /// First of the further words, such as the name of a body.
    pub(super) fn name(&self) -> &str {
        self.rest.split(' ').next().unwrap_or_default()
    }

    /// Field of this name.
    pub(super) fn field(&self, word: &str) -> Option<&Part> {
        self.fields.iter().find(|field| field.word == word)
    }
}

/// Splits tokens at their commas, and after braces that end an item.
fn parts(tokens: &[TokenTree], are_items: bool) -> Vec<Part> {
    let mut parts = Vec::new();
    let mut rest = tokens;
    while let Some(first) = rest.first() {
        let docs = rest.iter().take_while(|token| is_doc(token)).count();
        let word = rest.get(docs).map(ToString::to_string).unwrap_or_default();
        let is_braced = are_items && BRACED.contains(&word.as_str());
        let ends = |token: &TokenTree| match token {
            TokenTree::Punct(comma) => comma.as_char() == ',',
            TokenTree::Group(braces) => is_braced && braces.delimiter() == Delimiter::Brace,
            _ => false,
        };
        let end = rest.iter().position(ends).unwrap_or(rest.len() - 1);
        let is_comma =
            |token: Option<&TokenTree>| matches!(token, Some(TokenTree::Punct(comma)) if comma.as_char() == ',');
        let last = end + usize::from(is_braced && is_comma(rest.get(end + 1)));
        let part = &rest[docs..=end];
        let place = first.span().byte_range().start..rest[last].span().byte_range().end;
        let part = match (is_comma(part.last()), part) {
            (true, [inner @ .., _]) => inner,
            _ => part,
        };
        parts.push(read(word, part, place, is_braced));
        rest = &rest[last + 1..];
    }
    parts
}

/// A part from its tokens, without comments and the comma.
fn read(word: String, tokens: &[TokenTree], place: Range<usize>, is_braced: bool) -> Part {
    let is_end = |token: &TokenTree| match token {
        TokenTree::Punct(mark) => !is_braced && (mark.as_char() == ':' || mark.as_char() == '='),
        TokenTree::Group(braces) => is_braced && braces.delimiter() == Delimiter::Brace,
        _ => false,
    };
    let head = tokens.iter().position(is_end).unwrap_or(tokens.len());
    let rest: Vec<String> = tokens[..head].iter().skip(1).map(ToString::to_string).collect();
    let (value, fields) = match tokens.get(head) {
        Some(TokenTree::Group(braces)) => (
            braces.span_open().byte_range().end..braces.span_close().byte_range().start,
            self::parts(&braces.stream().into_iter().collect::<Vec<_>>(), false),
        ),
        _ => match &tokens[(head + 1).min(tokens.len())..] {
            [first, .., last] => (
                first.span().byte_range().start..last.span().byte_range().end,
                Vec::new(),
            ),
            [only] => (only.span().byte_range(), Vec::new()),
            [] => (place.end..place.end, Vec::new()),
        },
    };
    Part {
        word,
        rest: rest.join(" "),
        place,
        value,
        fields,
    }
}

/// True for the tokens of a comment that documents: `#` and brackets.
fn is_doc(token: &TokenTree) -> bool {
    match token {
        TokenTree::Punct(mark) => mark.as_char() == '#',
        TokenTree::Group(group) => group.delimiter() == Delimiter::Bracket,
        _ => false,
    }
}
