//! Comparison of the declarations of two sweeps.

use serde_json::{Map, Value};

/// Lists the places at which another declaration differs from this one, with both values.
pub(crate) fn differences(own: &str, other: &str) -> Vec<String> {
    let read = |text: &str| serde_json::from_str(text).unwrap_or(Value::Null);
    let mut differs = Vec::new();
    add("", (&read(own), &read(other)), &mut differs);
    differs
}

/// Adds the differences below a place, such as `task.span[1]`.
fn add(place: &str, (own, other): (&Value, &Value), differs: &mut Vec<String>) {
    match (own, other) {
        (Value::Object(own), Value::Object(other)) => {
            let added = other.keys().filter(|key| !own.contains_key(*key));
            for key in own.keys().chain(added) {
                let of = |object: &Map<String, Value>| object.get(key).cloned().unwrap_or_default();
                let place = if place.is_empty() {
                    key
                } else {
                    &format!("{place}.{key}")
                };
                add(place, (&of(own), &of(other)), differs);
            }
        }
        (Value::Array(own), Value::Array(other)) if own.len() == other.len() => {
            for (n, pair) in own.iter().zip(other).enumerate() {
                add(&format!("{place}[{n}]"), pair, differs);
            }
        }
        _ if own == other => {}
        _ => {
            let place = if place.is_empty() { "declaration" } else { place };
            let [own, other] = [own, other].map(|value| {
                if value.is_null() {
                    "nothing".to_owned()
                } else {
                    value.to_string()
                }
            });
            let same = own
                .chars()
                .zip(other.chars())
                .take_while(|(own, other)| own == other)
                .count();
            differs.push(format!(
                "{place}: {} in place of {}",
                excerpt(&other, same),
                excerpt(&own, same)
            ));
        }
    }
}

/// Returns the part of a text that begins shortly before a place.
fn excerpt(text: &str, place: usize) -> String {
    const BEFORE: usize = 20;
    const MOST: usize = 120;
    let length = text.chars().count();
    let from = if length > MOST { place.saturating_sub(BEFORE) } else { 0 };
    let part: String = text.chars().skip(from).take(MOST).collect();
    let dots = |is_cut| if is_cut { ".." } else { "" };
    format!("{}{part}{}", dots(from > 0), dots(length > from + MOST))
}
