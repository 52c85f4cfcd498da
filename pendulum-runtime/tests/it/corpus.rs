//! Declarations of the repository, and random changes of them: a model, or an error, but no panic.

use std::fs;
use std::path::Path;

use pendulum_runtime::{Declaration, Error, Method, Model, Options, Stopped};

use declarations::declarations;
use random::{Random, number};

#[path = "../../../pendulum-codegen/tests/common/declarations.rs"]
mod declarations;
#[path = "../../../testbed/src/random.rs"]
#[expect(dead_code, unreachable_pub, reason = "it is public elsewhere")]
pub(crate) mod random;

/// Folders with declarations, relative to the root of the repository.
const FOLDERS: [&str; 5] = [
    "testbed/src",
    "tests/hybrid",
    "tests/loops",
    "examples/gallery/src",
    "pendulum-codegen/tests/ui",
];
/// Longest declaration, in characters: longer ones take too long without optimisation.
const LONGEST: usize = 1500;

fn corpus() -> Vec<String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut texts = Vec::new();
    for folder in FOLDERS {
        let mut files: Vec<_> = fs::read_dir(root.join(folder)).expect(folder).flatten().collect();
        files.sort_by_key(fs::DirEntry::path);
        for file in files
            .iter()
            .filter(|file| file.path().extension().is_some_and(|end| end == "rs"))
        {
            let source = fs::read_to_string(file.path()).expect("text");
            let found = declarations(source.parse().expect("Rust"));
            let short = found
                .iter()
                .map(ToString::to_string)
                .filter(|text| text.len() < LONGEST);
            texts.extend(short);
        }
    }
    texts
}

/// Uses a text as a caller would. Returns true if it is a mechanism.
fn is_used(text: &str) -> bool {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../testbed");
    let declaration = Declaration::new(text).folder(folder);
    let model = match Model::declared(&declaration, &[]) {
        Err(Error::NoValue { parameters }) => {
            let values: Vec<(&str, f64)> = parameters.iter().map(|name| (name.as_str(), 1.0)).collect();
            Model::declared(&declaration, &values)
        }
        model => model,
    };
    let Ok(model) = model else { return false };
    let x = model.state(&[]).expect("no names");
    if x.is_empty() {
        return true;
    }
    for function in model.functions() {
        let lists = vec![vec![0.1; 2 * x.len()]; function.arguments.len()];
        let lists: Vec<&[f64]> = lists.iter().map(Vec::as_slice).collect();
        // lists of the wrong length are refused
        let _ = model.evaluate(&function.name, 0.3, &x, &lists);
    }
    let method = Method::new("Vern9").expect("known").max_steps(20);
    let options = Options {
        times: Some(vec![0.0, 0.005, 0.01]),
        ..Options::default()
    };
    match model.solve_with(&method, [0.0, 0.01], &x, &options) {
        Ok(motion) => assert_eq!(motion.t().len(), 3),
        Err(Stopped { error, .. }) => assert!(!error.to_string().is_empty()),
    }
    true
}

#[test]
fn declarations_of_the_repository_are_models() {
    let texts = corpus();
    let used = texts.iter().filter(|text| is_used(text)).count();
    assert!(used * 2 > texts.len() && texts.len() > 100, "{used} of {}", texts.len());
}

#[test]
fn changed_declarations_do_not_panic() {
    let texts = corpus();
    let mut random = Random::new(number("PENDULUM_SEED", 3));
    let mut used = 0;
    let count = number("PENDULUM_MUTATED", 100);
    for _ in 0..count {
        let mut words: Vec<&str> = random.of(&texts).split(' ').collect();
        let (from, to) = (random.below(words.len()), random.below(words.len()));
        match random.below(4) {
            0 => drop(words.remove(from)),
            1 => words.insert(to, words[from]),
            2 => words.swap(from, to),
            _ => words[from] = "0",
        }
        used += usize::from(is_used(&words.join(" ")));
    }
    assert!(used > 0 || count < 100);
}
