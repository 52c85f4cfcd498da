//! Ten questions of users of other software, each answered by a declaration and a figure.
//!
//! `cargo run --release -p studies --example open_questions` prints all answers, and `-- creep energy` those with these
//! names. `-- --json` prints them as JSON, for the comparison with other software in `bench`. It takes some seconds.
//! The page of the book, `docs/src/open-questions.md`, has the questions.

mod questions;

use std::error::Error;

use questions::ALL;
use serde_json::json;

fn main() -> Result<(), Box<dyn Error>> {
    let (options, wanted): (Vec<String>, Vec<String>) = std::env::args().skip(1).partition(|word| word == "--json");
    if let Some(name) = wanted.iter().find(|name| ALL.iter().all(|(known, _)| known != name)) {
        let known: Vec<&str> = ALL.iter().map(|&(known, _)| known).collect();
        return Err(format!("no question named `{name}`; there is {}", known.join(", ")).into());
    }
    let asked = |name: &str| wanted.is_empty() || wanted.iter().any(|wanted| wanted == name);
    let mut answers = serde_json::Map::new();
    for (name, answer) in ALL.into_iter().filter(|(name, _)| asked(name)) {
        let answer = answer()?;
        if options.is_empty() {
            let time = answer
                .seconds
                .map_or(String::new(), |seconds| format!(", in {seconds:.3} s"));
            println!("{name}: {}{time}", answer.text);
        }
        let json = json!({ "figure": answer.figure, "text": answer.text, "seconds": answer.seconds });
        answers.insert(name.to_owned(), json);
    }
    if !options.is_empty() {
        println!("{}", serde_json::to_string_pretty(&answers)?);
    }
    Ok(())
}
