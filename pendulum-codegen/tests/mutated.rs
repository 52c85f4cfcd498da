//! Randomly changed declarations of the repository, to find mistakes that no other test covers.
//!
//! On any input, the generator neither panics nor exceeds its stack or time. It returns items that parse, always the
//! same for the same input, or errors, each with a code and a help text.
//!
//! `PENDULUM_MUTATED=200000 cargo test --release -p pendulum-codegen --test mutated -- --nocapture` tries more inputs,
//! and `PENDULUM_SEED=17 PENDULUM_MUTATED=1` a single one. A failure prints its seed. A stack overflow ends the
//! process, and leaves the seed in one of the files `mutated-*.seed` in `target/tmp`.

use std::collections::BTreeMap;
use std::fs;
use std::io::Write;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

use pendulum_codegen::{Code, expand, program};
use proc_macro2::{Delimiter, TokenStream, TokenTree};

use declarations::declarations;
use random::{Random, number};

#[path = "common/declarations.rs"]
mod declarations;
#[path = "../../testbed/src/random.rs"]
#[expect(
    dead_code,
    unreachable_pub,
    reason = "it is public elsewhere, and only whole numbers are drawn here"
)]
mod random;

/// Folders with declarations, relative to the root of the repository.
const FOLDERS: [&str; 11] = [
    "pendulum-codegen/tests/ui",
    "testbed/src",
    "tests/it",
    "tests/hybrid",
    "tests/loops",
    "tests/thorough",
    "tests/ui",
    "examples",
    "examples/gallery/src",
    "pendulum-draw/tests",
    "studies/tests/thorough",
];

/// Maximum length of a declaration, in characters: longer ones take too long if they are still right after a change.
const LONGEST: usize = 400;

/// Maximum time for the expansion of an input, without optimisation.
const TIME: Duration = Duration::from_secs(2);

/// Time after which an input counts as hanging, and the test is aborted.
const HANGS: Duration = Duration::from_secs(120);

/// Stack size of a test thread, in bytes; equal to that of a thread of the compiler.
const STACK: usize = 8 << 20;

/// Default number of inputs.
const INPUTS: u64 = 500;

#[test]
fn whatever_is_written_is_answered() {
    let (first, count) = (number("PENDULUM_SEED", 1), number("PENDULUM_MUTATED", INPUTS));
    let corpus = Corpus::read();
    let next = AtomicU64::new(first);
    let answers = Mutex::new(Answers::default());
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let working: Vec<Mutex<Option<(u64, Instant)>>> = (0..threads).map(|_| Mutex::new(None)).collect();
    std::thread::scope(|scope| {
        for (n, working) in working.iter().enumerate() {
            let note = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("mutated-{n}.seed"));
            let (corpus, next, answers) = (&corpus, &next, &answers);
            let work = move || {
                loop {
                    let seed = next.fetch_add(1, Ordering::Relaxed);
                    if seed >= first + count {
                        break;
                    }
                    fs::write(&note, seed.to_string()).expect("a file");
                    *working.lock().expect("a place") = Some((seed, Instant::now()));
                    let answer = Answer::to(seed, &corpus.mutated(seed));
                    *working.lock().expect("a place") = None;
                    answers.lock().expect("answers").add(answer);
                }
            };
            let thread = std::thread::Builder::new().stack_size(STACK);
            thread.spawn_scoped(scope, work).expect("a thread");
        }
        watch(&working, || next.load(Ordering::Relaxed) >= first + count);
    });
    let answers = answers.into_inner().expect("answers");
    println!("{answers}");
    assert!(answers.failures.is_empty(), "{}", answers.failures.join("\n\n"));
    let share = |part: u64| part * 40 >= answers.tokens();
    assert!(
        count < 1000 || (share(answers.accepted) && share(answers.refused)),
        "the changes are too gentle, or too rough: {answers}"
    );
}

/// Ends the process if an input hangs, since its thread cannot be ended.
fn watch(working: &[Mutex<Option<(u64, Instant)>>], all_are_given: impl Fn() -> bool) {
    loop {
        std::thread::sleep(Duration::from_millis(50));
        let now: Vec<_> = working
            .iter()
            .filter_map(|place| *place.lock().expect("a place"))
            .collect();
        if now.is_empty() && all_are_given() {
            return;
        }
        if let Some((seed, _)) = now.iter().find(|(_, start)| start.elapsed() > HANGS) {
            let _ = writeln!(std::io::stderr(), "seed {seed} hangs");
            std::process::exit(1);
        }
    }
}

/// Result of an input.
struct Answer {
    seed: u64,
    kind: Kind,
    time: Duration,
}

enum Kind {
    /// The text is not a sequence of tokens, so it cannot reach a macro.
    NoTokens,
    Accepted,
    Refused,
    Failure(String),
}

impl Answer {
    fn to(seed: u64, input: &str) -> Self {
        let start = processor_time();
        let Ok(kind) = catch_unwind(AssertUnwindSafe(|| kind(seed, input))) else {
            let kind = Kind::Failure("a panic".to_owned());
            let time = processor_time() - start;
            return Self { seed, kind, time }.with(input);
        };
        let time = processor_time() - start;
        Self { seed, kind, time }.with(input)
    }

    /// Adds the seed and the input to a failure.
    fn with(mut self, input: &str) -> Self {
        if let Kind::Failure(text) = &mut self.kind {
            let shown: String = input.chars().take(3000).collect();
            *text = format!("seed {}: {text}\n{shown}", self.seed);
        }
        self
    }
}

fn kind(seed: u64, input: &str) -> Kind {
    let Ok(tokens) = input.parse::<TokenStream>() else {
        return Kind::NoTokens;
    };
    let start = processor_time();
    let items = expand(tokens.clone());
    let time = processor_time() - start;
    if time > TIME {
        return Kind::Failure(format!("it takes {time:?}"));
    }
    let first = items.clone().into_iter().take(7).collect::<TokenStream>().to_string();
    let is_refused = first.starts_with(":: core :: compile_error");
    if is_refused {
        let Err(errors) = program(tokens.clone()) else {
            return Kind::Failure("errors in the items, but a program".to_owned());
        };
        let mut errors = errors.iter().peekable();
        if errors.peek().is_none() {
            return Kind::Failure("refused without an error".to_owned());
        }
        if let Some(error) = errors.find(|error| !is_complete(&error.to_string())) {
            return Kind::Failure(format!("no code, or no help: {error}"));
        }
    }
    if let Err(error) = syn::parse2::<syn::File>(items.clone()) {
        return Kind::Failure(format!("the items do not parse: {error}"));
    }
    // for some inputs only, to save time
    if seed.is_multiple_of(4) {
        let text = items.to_string();
        if let Err(error) = syn::parse_file(&text) {
            return Kind::Failure(format!("the items do not parse as text: {error}"));
        }
        if expand(tokens).to_string() != text {
            return Kind::Failure("the items differ from one time to the next".to_owned());
        }
    }
    if is_refused { Kind::Refused } else { Kind::Accepted }
}

/// True if a message has a code at the end of its first line, and then a line with help.
fn is_complete(message: &str) -> bool {
    let Some((fact, rest)) = message.split_once('\n') else {
        return false;
    };
    let code = fact.rsplit_once(" [").and_then(|(_, code)| code.strip_suffix(']'));
    code.is_some_and(|code| Code::ALL.iter().any(|known| known.text() == code)) && rest.starts_with("help: ")
}

/// Returns the CPU time of this thread, or the elapsed time if the system does not report it.
fn processor_time() -> Duration {
    static START: std::sync::LazyLock<Instant> = std::sync::LazyLock::new(Instant::now);
    let start = *START;
    let text = fs::read_to_string("/proc/thread-self/schedstat").ok();
    let nanoseconds = text.and_then(|text| text.split(' ').next()?.parse().ok());
    nanoseconds.map_or_else(|| start.elapsed(), Duration::from_nanos)
}

#[derive(Default)]
struct Answers {
    no_tokens: u64,
    accepted: u64,
    refused: u64,
    failures: Vec<String>,
    slowest: (Duration, u64),
}

impl Answers {
    fn add(&mut self, answer: Answer) {
        self.slowest = self.slowest.max((answer.time, answer.seed));
        match answer.kind {
            Kind::NoTokens => self.no_tokens += 1,
            Kind::Accepted => self.accepted += 1,
            Kind::Refused => self.refused += 1,
            Kind::Failure(text) => self.failures.push(text),
        }
    }

    /// Number of inputs that reached the generator.
    fn tokens(&self) -> u64 {
        self.accepted + self.refused + self.failures.len() as u64
    }
}

impl std::fmt::Display for Answers {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let (time, seed) = self.slowest;
        write!(
            f,
            "{} accepted, {} refused, {} no tokens, {} failures; the slowest, of seed {seed}, took {time:?}",
            self.accepted,
            self.refused,
            self.no_tokens,
            self.failures.len()
        )
    }
}

/// All declarations, as lists of tokens, in which brackets are tokens of their own.
struct Corpus {
    right: Vec<Vec<String>>,
    /// Declarations from the error cases.
    wrong: Vec<Vec<String>>,
    /// All tokens that occur.
    words: Vec<String>,
}

impl Corpus {
    fn read() -> Self {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        let [mut right, mut wrong] = [const { Vec::new() }; 2];
        for folder in FOLDERS {
            let declarations = if folder.ends_with("ui") { &mut wrong } else { &mut right };
            for file in sources(&root.join(folder)) {
                let text = fs::read_to_string(file).expect("a file");
                for declaration in self::declarations(text.parse().expect("tokens")) {
                    let mut flat = Vec::new();
                    flatten(declaration, &mut flat);
                    declarations.push(flat);
                }
            }
        }
        for declarations in [&mut right, &mut wrong] {
            declarations.retain(|tokens: &Vec<String>| {
                let length: usize = tokens.iter().map(|token| token.len() + 1).sum();
                (1..=LONGEST).contains(&length)
            });
            assert!(declarations.len() > 50, "{} declarations", declarations.len());
        }
        let mut counts: BTreeMap<&String, usize> = BTreeMap::new();
        for token in right.iter().chain(&wrong).flatten() {
            *counts.entry(token).or_default() += 1;
        }
        let words = counts.into_keys().cloned().collect();
        Self { right, wrong, words }
    }

    /// Returns a declaration: a right or a wrong one with equal probability.
    fn some(&self, random: &mut Random) -> &Vec<String> {
        let from = [&self.right, &self.wrong][random.below(2)];
        random.of(from)
    }

    /// Returns a declaration with some changes.
    fn mutated(&self, seed: u64) -> String {
        let mut random = Random::new(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15));
        let mut tokens = self.some(&mut random).clone();
        for _ in 0..[1, 1, 1, 1, 2, 2, 3, 5][random.below(8)] {
            self.change(&mut tokens, &mut random);
        }
        let mut text = String::new();
        for token in tokens {
            text += &token;
            // a tick must join the next token, as in a lifetime
            if !token.ends_with('\'') {
                text.push(' ');
            }
        }
        if random.below(10) == 0 {
            text = spoiled(&text, &mut random);
        }
        text
    }

    fn change(&self, tokens: &mut Vec<String>, random: &mut Random) {
        if tokens.len() < 2 {
            tokens.push(random.of(&self.words).clone());
            return;
        }
        // most changes to brackets leave no valid tokens
        let place = |random: &mut Random| {
            let at = random.below(tokens.len());
            let is_bracket = "()[]{}".contains(&tokens[at]);
            if is_bracket { random.below(tokens.len()) } else { at }
        };
        let (at, other) = (place(random), place(random));
        match random.below(20) {
            0 | 1 => _ = tokens.remove(at),
            2 => tokens.insert(at, tokens[at].clone()),
            3 => tokens.swap(at, other),
            4 | 5 => tokens[at].clone_from(random.of(&self.words)),
            6 => tokens.insert(at, random.of(&self.words).clone()),
            7 => tokens[at] = tokens[other].clone(),
            8..=10 => self.change_number(tokens, random),
            11 => {
                let end = (at + 1 + random.below(12)).min(tokens.len());
                tokens.drain(at..end);
            }
            12 => {
                let end = (at + 1 + random.below(12)).min(tokens.len());
                let copy = tokens[at..end].to_vec();
                tokens.splice(other..other, copy);
            }
            13 => {
                // a part of another declaration
                let from = self.some(random);
                let start = random.below(from.len());
                let end = (start + 1 + random.below(25)).min(from.len());
                tokens.splice(at..at, from[start..end].iter().cloned());
            }
            14 => {
                let (open, close) = [("(", ")"), ("[", "]"), ("{", "}")][random.below(3)];
                let depth = [1, 2, 30, 99, 101, 500][random.below(6)];
                tokens.insert(at + 1, close.repeat(depth));
                tokens.insert(at, open.repeat(depth));
            }
            15 => {
                // many repetitions
                let count = [10, 100, 700][random.below(3)];
                let end = (at + 1 + random.below(3)).min(tokens.len());
                let copy: Vec<String> = tokens[at..end]
                    .iter()
                    .cycle()
                    .take(count * (end - at))
                    .cloned()
                    .collect();
                tokens.splice(at..at, copy);
            }
            16 => {
                let length = [5, 100, 1000][random.below(3)];
                let term = ["+ 1", "- x", "* 2", "/ 3", "^ 2", ", 0", "- -"][random.below(7)];
                tokens.insert(at, format!(" {term}").repeat(length));
            }
            17 => {
                let name = [
                    "r#in", "r#T", "r#self", "é", "ß", "变", "_", "self", "Self", "crate", "__", "x1e9", "T",
                ];
                tokens[at] = (*random.of(&name)).to_owned();
            }
            18 => tokens[at] = "long_".repeat(1 + random.below(400)),
            _ => {
                let odd = [
                    "90 deg",
                    "1 mg^9 kg/",
                    "3 N m*",
                    "1e300 km",
                    "-----",
                    "'a",
                    "'x'",
                    "\"text\"",
                    "b\"b\"",
                    "#",
                    "$",
                    "1u8",
                    "0x1F",
                    "1_000",
                    "1e",
                    "=>",
                    "!",
                    "::",
                ];
                tokens.insert(at, (*random.of(&odd)).to_owned());
            }
        }
    }

    fn change_number(&self, tokens: &mut [String], random: &mut Random) {
        let is_number = |token: &String| token.starts_with(|first: char| first.is_ascii_digit());
        let places: Vec<usize> = (0..tokens.len()).filter(|&n| is_number(&tokens[n])).collect();
        if places.is_empty() {
            return;
        }
        let digits = |count: usize| "123456789".chars().cycle().take(count).collect::<String>();
        let at = *random.of(&places);
        tokens[at] = match random.below(14) {
            0 | 1 => "0".to_owned(),
            2 => "-1".to_owned(),
            3 => "1e300".to_owned(),
            4 => "1e-300".to_owned(),
            5 => format!("0.{}", digits(60)),
            6 => digits(400),
            7 => "0.0000000000000000001".to_owned(),
            8 => "1e17".to_owned(),
            9 => "-0.0".to_owned(),
            10 => "3/7".to_owned(),
            11 => "(1/0)".to_owned(),
            12 => "1e2147483647".to_owned(),
            _ => "2.5".to_owned(),
        };
    }
}

/// Removes, doubles, replaces or inserts some characters.
fn spoiled(text: &str, random: &mut Random) -> String {
    let mut characters: Vec<char> = text.chars().collect();
    for _ in 0..=random.below(3) {
        if characters.is_empty() {
            break;
        }
        let at = random.below(characters.len());
        let other = *random.of(&[
            ' ', ',', ':', '{', '}', '[', ']', '(', ')', '-', '.', '0', 'e', '^', '#', '\'', '"', '/', '\\', 'λ',
            '\u{0}', '\u{202e}', '_',
        ]);
        match random.below(4) {
            0 => _ = characters.remove(at),
            1 => characters.insert(at, characters[at]),
            2 => characters[at] = other,
            _ => characters.insert(at, other),
        }
    }
    characters.into_iter().collect()
}

/// Returns the source files in a folder and its subfolders, in order.
fn sources(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("a folder");
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.expect("an entry").path()).collect();
    paths.sort();
    let of = |path: PathBuf| if path.is_dir() { sources(&path) } else { vec![path] };
    let sources = paths.into_iter().flat_map(of);
    sources
        .filter(|path| path.extension().is_some_and(|e| e == "rs"))
        .collect()
}

fn flatten(tokens: TokenStream, flat: &mut Vec<String>) {
    for tree in tokens {
        match tree {
            TokenTree::Group(group) => {
                let (open, close) = match group.delimiter() {
                    Delimiter::Parenthesis => ("(", ")"),
                    Delimiter::Brace => ("{", "}"),
                    Delimiter::Bracket => ("[", "]"),
                    Delimiter::None => ("", ""),
                };
                flat.push(open.to_owned());
                flatten(group.stream(), flat);
                flat.push(close.to_owned());
            }
            other => flat.push(other.to_string()),
        }
    }
}
