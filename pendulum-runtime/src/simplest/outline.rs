//! The text of a declaration in parts that can be changed: its items, and the fields of those in braces.

use std::ops::Range;

use proc_macro2::{Delimiter, TokenStream, TokenTree};

use crate::declaration::unwrapped;
use crate::worker;

/// Fields of a body that act along its joint, which a fixed joint cannot have.
pub(super) const ALONG: [&str; 6] = [
    "friction",
    "spring",
    "torque",
    "dry_friction",
    "static_friction",
    "stop",
];

/// Items that may lose their effect when others change.
const IDLE: [&str; 9] = [
    "let",
    "input",
    "shape",
    "point",
    "force",
    "spring",
    "damper",
    "dissipation",
    "event",
];

/// Items whose braces end them; the others end in a comma.
const BRACED: [&str; 5] = ["params", "state", "shape", "body", "wall"];

/// New text for a place.
pub(super) type Edit = (Range<usize>, String);

/// Part of the text: an item of the scene, or a field in its braces.
#[derive(Clone, Debug)]
pub(super) struct Part {
    /// First word.
    pub(super) word: String,
    /// Further words before a colon or braces, with their places: `upper`, `on`, `ground` of a body.
    pub(super) head: Vec<(String, Range<usize>)>,
    /// Place in the text, with the comma after it.
    pub(super) place: Range<usize>,
    /// Place without comments and the comma.
    pub(super) own: Range<usize>,
    /// Tokens after the colon, with their places; brackets are one.
    pub(super) value: Vec<(String, Range<usize>)>,
    /// Place of the inside of braces.
    pub(super) inside: Range<usize>,
    /// Fields in the braces, or expressions in the parentheses after the colon.
    pub(super) fields: Vec<Part>,
}

/// The text of a declaration with its parts.
#[derive(Clone, Debug)]
pub(super) struct Outline {
    pub(super) text: String,
    pub(super) items: Vec<Part>,
    /// Place of the first item.
    pub(super) begin: usize,
    /// All names.
    names: Vec<(String, Range<usize>)>,
    /// Places of `dot(name)`, by name.
    rates: Vec<(String, Range<usize>)>,
}

impl Outline {
    /// Reads a text, on a thread of its own, which forgets the places of its tokens.
    pub(super) fn new(text: String) -> Result<Self, String> {
        worker::alone(|| {
            let tokens: TokenStream = text
                .parse()
                .map_err(|_| "the changed text cannot be split into tokens")?;
            let tokens: Vec<TokenTree> = unwrapped(tokens).into_iter().collect();
            let Some(TokenTree::Group(scene)) = tokens.last() else {
                return Err("the changed text has no items".to_owned());
            };
            let inside: Vec<TokenTree> = scene.stream().into_iter().collect();
            let mut outline = Self {
                text,
                items: parts(&inside, true),
                begin: scene.span_open().byte_range().end,
                names: Vec::new(),
                rates: Vec::new(),
            };
            outline.note(&inside);
            Ok(outline)
        })
    }

    /// Notes names and rates.
    fn note(&mut self, tokens: &[TokenTree]) {
        for (n, token) in tokens.iter().enumerate() {
            match (token, tokens.get(n + 1)) {
                (TokenTree::Ident(name), Some(TokenTree::Group(group))) if name == "dot" => {
                    let place = name.span().byte_range().start..group.span_close().byte_range().end;
                    self.rates.push((group.stream().to_string(), place));
                    self.note(&group.stream().into_iter().collect::<Vec<_>>());
                }
                (TokenTree::Ident(name), _) => self.names.push((name.to_string(), name.span().byte_range())),
                (TokenTree::Group(group), _) => self.note(&group.stream().into_iter().collect::<Vec<_>>()),
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

    /// Text of what follows the colon of a part.
    pub(super) fn value(&self, part: &Part) -> &str {
        match &part.value[..] {
            [] => "",
            [first, .., last] => &self.text[first.1.start..last.1.end],
            [only] => &self.text[only.1.clone()],
        }
    }

    /// Places of a name outside of a part.
    pub(super) fn uses<'o>(&'o self, name: &'o str, outside: &'o Part) -> impl Iterator<Item = Range<usize>> + 'o {
        let of_name = self.names.iter().filter(move |(own, _)| own == name);
        let places = of_name.map(|(_, place)| place.clone());
        places.filter(|place| !outside.place.contains(&place.start))
    }

    /// True if a part uses a name.
    pub(super) fn is_used_in(&self, name: &str, part: &Part) -> bool {
        self.names
            .iter()
            .any(|(own, place)| own == name && part.place.contains(&place.start))
    }

    /// A name that nothing has, which begins like this.
    pub(super) fn fresh(&self, name: String) -> String {
        let is_taken = |name: &String| self.names.iter().any(|(own, _)| own == name);
        std::iter::successors(Some(name), |name| Some(format!("{name}_")))
            .find(|name| !is_taken(name))
            .expect("there are more names than tokens")
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

    /// Part that can be left out at a line and a column of the text, which start at 1: a parameter, a force along a
    /// joint, or an item that others may use.
    pub(super) fn idle(&self, line: usize, column: usize) -> Option<&Part> {
        let begin: usize = self.text.split_inclusive('\n').take(line - 1).map(str::len).sum();
        let within = self.text[begin..].char_indices().nth(column - 1);
        let place = begin + within.map_or(0, |(n, _)| n);
        let item = self.items.iter().find(|item| item.place.contains(&place))?;
        let field = || item.fields.iter().find(|field| field.place.contains(&place));
        match item.word.as_str() {
            "params" => field(),
            "body" => field().filter(|field| ALONG.contains(&field.word.as_str())),
            word => IDLE.contains(&word).then_some(item),
        }
    }

    /// Place of the default of a parameter. Without units, it is all that follows the name.
    pub(super) fn default_of(&self, parameter: &Part) -> Option<Range<usize>> {
        let value = &parameter.value;
        let begin = match value.iter().position(|(token, _)| token == "=") {
            Some(n) => value[n].1.end,
            None if self.is_without_units() => value.first()?.1.start,
            None => return None,
        };
        Some(begin..parameter.own.end)
    }

    /// Place of the unit of a parameter, if it has one.
    pub(super) fn unit_of(&self, parameter: &Part) -> Option<Range<usize>> {
        let value = &parameter.value;
        let end = value.iter().position(|(token, _)| token == "=")?;
        let unit = &value[..end];
        Some(unit.first()?.1.start..unit.last()?.1.end)
    }

    /// True if there is a parameter of this name.
    pub(super) fn has_parameter(&self, name: &str) -> bool {
        self.of("params").any(|params| params.field(name).is_some())
    }

    /// True if there is an input of this name.
    pub(super) fn has_input(&self, name: &str) -> bool {
        self.of("input").any(|input| input.name() == name)
    }

    /// Text with some places replaced.
    pub(super) fn with(&self, mut edits: Vec<Edit>) -> String {
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
    pub(super) fn without(&self, part: &Part) -> Edit {
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
        self.head.first().map_or("", |(name, _)| name)
    }

    /// All further words.
    pub(super) fn rest(&self) -> String {
        let words: Vec<&str> = self.head.iter().map(|(word, _)| word.as_str()).collect();
        words.join(" ")
    }

    /// True if a word stands after the colon.
    pub(super) fn has(&self, word: &str) -> bool {
        self.value.iter().any(|(own, _)| own == word)
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
    let words = |tokens: &[TokenTree]| -> Vec<(String, Range<usize>)> {
        tokens
            .iter()
            .map(|token| (token.to_string(), token.span().byte_range()))
            .collect()
    };
    let head = tokens.iter().position(is_end).unwrap_or(tokens.len());
    let after = &tokens[(head + 1).min(tokens.len())..];
    let (group, value) = match tokens.get(head) {
        Some(TokenTree::Group(braces)) => (Some(braces), Vec::new()),
        _ => match after.first() {
            Some(TokenTree::Group(first)) if first.delimiter() == Delimiter::Parenthesis => (Some(first), words(after)),
            _ => (None, words(after)),
        },
    };
    let inside = group.map(|group| group.span_open().byte_range().end..group.span_close().byte_range().start);
    let fields = group.map(|group| self::parts(&group.stream().into_iter().collect::<Vec<_>>(), false));
    let own = match tokens {
        [first, .., last] => first.span().byte_range().start..last.span().byte_range().end,
        [only] => only.span().byte_range(),
        [] => place.clone(),
    };
    Part {
        word,
        own,
        head: words(&tokens[head.min(1)..head]),
        inside: inside.unwrap_or(place.end..place.end),
        place,
        value,
        fields: fields.unwrap_or_default(),
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
