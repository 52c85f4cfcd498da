//! Tests of the pages on error codes: each code has a page; its wrong declarations have only this error, and its
//! correct ones have none.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use pendulum_codegen::{Code, program_in};
use pulldown_cmark::{CodeBlockKind, Event, Parser, Tag, TagEnd};

/// Heading of a page, its code blocks, each with the words after its fence, and the messages that it quotes.
#[derive(Default)]
struct Page {
    heading: String,
    blocks: Vec<(String, String)>,
    quotes: Vec<String>,
}

impl Page {
    fn read(path: &Path) -> Self {
        let text = read(path);
        let mut page = Self {
            quotes: text.split("\n\n").filter_map(quote).collect(),
            ..Self::default()
        };
        let (mut in_heading, mut in_block) = (false, false);
        for event in Parser::new(&text) {
            match event {
                Event::Start(Tag::Heading { .. }) => in_heading = page.heading.is_empty(),
                Event::End(TagEnd::Heading(_)) => in_heading = false,
                Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(words))) => {
                    in_block = true;
                    page.blocks.push((words.into_string(), String::new()));
                }
                Event::End(TagEnd::CodeBlock) => in_block = false,
                Event::Text(text) | Event::Code(text) if in_heading => page.heading.push_str(&text),
                Event::Text(text) if in_block => {
                    if let Some((_, block)) = page.blocks.last_mut() {
                        block.push_str(&text);
                    }
                }
                _ => {}
            }
        }
        page
    }

    /// Lists faults of the declarations of the page; files that they read are written into a folder.
    fn faults(&self, code: Code, folder: &Path) -> Vec<String> {
        let mut faults = Vec::new();
        let (mut wrong, mut right, mut all) = (0, 0, String::new());
        for (words, block) in &self.blocks {
            match words.split_once(',').unwrap_or((words, "")) {
                ("xml", file) => fs::write(folder.join(file), block).expect("a file is written"),
                ("mechanism", "wrong") => {
                    wrong += 1;
                    let messages = messages(folder, block);
                    all += &messages.concat();
                    if messages.is_empty() {
                        faults.push(format!("this is accepted:\n{block}"));
                    }
                    faults.extend(messages.into_iter().filter(|message| !ends_in(message, code)));
                }
                ("mechanism", "") => {
                    right += 1;
                    faults.extend(messages(folder, block));
                }
                _ => faults.push(format!("a block of unknown kind: {words}")),
            }
        }
        let unheard = self.quotes.iter().filter(|quote| !all.contains(*quote));
        faults.extend(unheard.map(|quote| format!("no message says {quote}")));
        if wrong == 0 || right == 0 {
            faults.push(format!("{wrong} wrong and {right} right declarations"));
        }
        faults
    }
}

/// Message in quotation marks at the start of a paragraph, on one line.
fn quote(paragraph: &str) -> Option<String> {
    let text = paragraph.trim_start().strip_prefix('"')?;
    let (quote, _) = text.split_once('"')?;
    Some(quote.split_whitespace().collect::<Vec<_>>().join(" "))
}

/// Messages about a declaration; empty if it is accepted.
fn messages(folder: &Path, declaration: &str) -> Vec<String> {
    let tokens = declaration.parse().expect("a declaration is made of tokens");
    match program_in(folder, tokens) {
        Ok(_) => Vec::new(),
        Err(errors) => errors.iter().map(ToString::to_string).collect(),
    }
}

/// True if the first line of a message ends in a code.
fn ends_in(message: &str, code: Code) -> bool {
    let fact = message.lines().next().unwrap_or_default();
    fact.ends_with(&format!(" [{code}]"))
}

fn source() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("src")
}

fn page(code: Code) -> PathBuf {
    source().join(format!("errors/{code}.md"))
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

#[test]
fn pages_are_those_of_the_codes_and_listed() {
    let [index, summary] = ["errors/README.md", "SUMMARY.md"].map(|file| read(&source().join(file)));
    let mut expected = BTreeSet::from([source().join("errors/README.md")]);
    for &code in Code::ALL {
        let title = code.title();
        let row = format!("| [{code}]({code}.md) | {title} |\n");
        assert!(index.contains(&row), "the index lacks {row}");
        let item = format!("  - [{code}: {title}](errors/{code}.md)\n");
        assert!(summary.contains(&item), "SUMMARY.md lacks {item}");
        assert_eq!(Page::read(&page(code)).heading, format!("{code}: {title}"));
        expected.insert(page(code));
    }
    let files = fs::read_dir(source().join("errors")).expect("a folder");
    let files: BTreeSet<PathBuf> = files.map(|entry| entry.expect("an entry").path()).collect();
    let unknown: Vec<_> = files.difference(&expected).collect();
    assert!(unknown.is_empty(), "pages of no code: {unknown:?}");
}

#[test]
fn wrong_declarations_have_the_error_of_their_page_and_right_ones_none() {
    let mut faults = Vec::new();
    for &code in Code::ALL {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("errors/{code}"));
        fs::create_dir_all(&folder).expect("a folder is made");
        let found = Page::read(&page(code)).faults(code, &folder);
        faults.extend(found.into_iter().map(|fault| format!("{code}.md: {fault}")));
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}
