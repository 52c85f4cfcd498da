//! Suggestions for unknown words: misspelt words of the language, and words of other tools.

mod expressions;
mod scene;

pub(crate) use expressions::{FUNCTIONS, SYMBOLS};
pub(crate) use scene::{AFTER_JOINT, FIELDS, ITEMS, JOINTS, ROUTINES, SOLIDS, STATE, WALL};

/// Synonyms, in lower case and without underscores, with the word of the language for them, or a help text if there is
/// none.
pub(crate) type Synonyms = [(&'static [&'static str], &'static str)];

/// Advice on an unknown word.
#[derive(Debug)]
pub(crate) struct Advice<'a> {
    /// The known word that is probably meant.
    pub meant: Option<&'a str>,
    /// Help text.
    pub help: String,
}

/// Returns advice on an unknown word in a place where the `known` ones are allowed.
pub(crate) fn advice<'a>(
    word: &str,
    known: impl IntoIterator<Item = &'a str>,
    synonyms: &'static Synonyms,
) -> Advice<'a> {
    let known: Vec<&str> = known.into_iter().collect();
    let synonym = synonym(word, synonyms);
    let named = synonym.and_then(|meaning| known.iter().copied().find(|known| *known == meaning));
    if let (Some(instead), None) = (synonym, named) {
        let help = instead.to_owned();
        return Advice { meant: None, help };
    }
    let meant = named.or_else(|| nearest(&plain(word), &known));
    let list = known.join(", ");
    let help = match meant {
        Some(meant) if known.len() == 1 => format!("did you mean `{meant}`?"),
        Some(meant) => format!("did you mean `{meant}`? known here: {list}"),
        None if known.is_empty() => "nothing suitable is declared".to_owned(),
        None => format!("known here: {list}"),
    };
    Advice { meant, help }
}

/// Looks up a word in a table. Returns a word of the language, or a sentence.
pub(crate) fn synonym(word: &str, synonyms: &'static Synonyms) -> Option<&'static str> {
    let plain = plain(word);
    let row = synonyms.iter().find(|(words, _)| words.contains(&plain.as_str()));
    row.map(|(_, meaning)| *meaning)
}

fn nearest<'a>(word: &str, known: &[&'a str]) -> Option<&'a str> {
    let distances = known.iter().map(|candidate| {
        let candidate_plain = plain(candidate);
        let close = (candidate_plain.len().min(word.len()) + 1) / 3;
        (strsim::damerau_levenshtein(word, &candidate_plain), close, *candidate)
    });
    let near = distances.filter(|(distance, close, _)| distance <= close);
    near.map(|(distance, _, candidate)| (distance, candidate))
        .min()
        .map(|(_, candidate)| candidate)
}

/// Removes differences in style: `Center_Of_Mass` becomes `centerofmass`.
fn plain(word: &str) -> String {
    word.to_lowercase().replace('_', "")
}
