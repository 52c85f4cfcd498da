//! Test of the page of open questions: its declarations are those of the program, in the same order.

use std::fs;
use std::path::Path;

use pulldown_cmark::{CodeBlockKind, Event, Parser, Tag, TagEnd};

/// Contents of the Rust blocks of a page.
fn declarations(page: &str) -> Vec<String> {
    let mut blocks = Vec::new();
    let mut block = None;
    for event in Parser::new(page) {
        match event {
            Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(words))) => {
                block = (&*words == "rust").then(String::new);
            }
            Event::Text(text) => block.iter_mut().for_each(|block| block.push_str(&text)),
            Event::End(TagEnd::CodeBlock) => blocks.extend(block.take()),
            _ => {}
        }
    }
    blocks
}

/// Names of the questions, by the lines of the page that quote the program.
fn names(page: &str) -> Vec<&str> {
    let quoted = page.split("```text\n").skip(1);
    quoted.filter_map(|answer| Some(answer.split_once(": ")?.0)).collect()
}

#[test]
fn declarations_are_those_of_the_program() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let read = |path: &Path| fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let page = read(&root.join("src/open-questions.md"));
    let (shown, names) = (declarations(&page), names(&page));
    assert_eq!((shown.len(), names.len()), (10, 10));
    for (shown, name) in shown.iter().zip(names) {
        let program = read(&root.join(format!("../studies/examples/open_questions/questions/{name}.rs")));
        assert!(program.contains(shown), "the declaration of {name} is not\n{shown}");
    }
}
