//! Random mechanisms: what is generated for them against equations of motion that share nothing with the generator.
//!
//! `PENDULUM_MECHANISMS=5000 cargo test --release -p tests --test it random_mechanisms -- --nocapture` tries more of
//! them, and shows the worst errors; `PENDULUM_SEED` is the first seed. What fails is printed with its seed. Every
//! eighth is also printed as C, compiled and run; with `PENDULUM_C=1` every one is.

mod compare;
mod declared;
pub(crate) mod evaluate;
mod in_c;
mod observe;

use std::panic::{AssertUnwindSafe, catch_unwind};

use compare::{Worst, condition, places};
use evaluate::Place;
use pendulum_codegen::program;
use pendulum_codegen::program::Program;
use testbed::random::{Random, each_seed, number};
use testbed::trees::{Kind, Name, Tree};

/// The condition of a mass matrix, its coordinates scaled alike, beyond which a scene is left out: digits are lost
/// whoever computes.
const WORST_CONDITION: f64 = 1e6;
/// Beyond this it counts as singular.
const SINGULAR: f64 = 1e12;

/// How many mechanisms of a kind are tried where no other number is given.
const DEFAULT: u64 = 10;

/// Of how many one is also compared in C, where no other number is given.
const ONE_IN_C: u64 = 8;

/// What came of one draw.
enum Tried {
    /// It agrees, maybe in C too.
    Agrees { errors: Worst, in_c: bool },
    /// Its mass matrix is singular, and it was refused for that.
    Refused,
    /// Its mass matrix is close to singular.
    LeftOut,
}

#[test]
fn even_masses_move_as_newton_and_euler_say() {
    agree(Kind::Even, 1e-12);
}

#[test]
fn uneven_masses_move_as_newton_and_euler_say() {
    agree(Kind::Uneven, 1e-10);
}

/// What came of many draws.
#[derive(Default)]
struct Tally {
    agree: u64,
    in_c: u64,
    refused: u64,
    left_out: u64,
    worst: Worst,
    failures: Vec<String>,
}

fn agree(kind: Kind, tolerance: f64) {
    let (first, count) = (number("PENDULUM_SEED", 1), number("PENDULUM_MECHANISMS", DEFAULT));
    let mut tally = Tally::default();
    each_seed(
        first..first + count,
        |seed| tried(seed, kind, tolerance),
        |seed, tried| tally.add(seed, tried),
    );
    println!(
        "{kind:?}: {} agree, {} of them in C, {} are refused as singular, {} are left out; worst {}",
        tally.agree,
        tally.in_c,
        tally.refused,
        tally.left_out,
        shown(&tally.worst)
    );
    assert!(tally.failures.is_empty(), "{}", tally.failures.join("\n"));
    assert!(tally.agree * 10 >= count * 9, "too few are compared");
}

impl Tally {
    fn add(&mut self, seed: u64, tried: Result<Tried, String>) {
        match tried {
            Ok(Tried::Agrees { errors, in_c }) => {
                self.agree += 1;
                self.in_c += u64::from(in_c);
                for (what, error) in errors {
                    let worst = self.worst.entry(what).or_default();
                    *worst = worst.max(error);
                }
            }
            Ok(Tried::Refused) => self.refused += 1,
            Ok(Tried::LeftOut) => self.left_out += 1,
            Err(failure) => self.failures.push(format!("seed {seed}: {failure}")),
        }
    }
}

fn tried(seed: u64, kind: Kind, tolerance: f64) -> Result<Tried, String> {
    let mut random = Random::new(seed ^ 0xABCD);
    // small ones are as likely to show a mistake, and quick
    let most = match random.between(0.0, 1.0) {
        0.0..0.75 => 2,
        0.75..0.97 => 3,
        _ => 6,
    };
    let mut tree = Tree::draw(seed, kind, most);
    let mut places = places(&tree, &mut random);
    let conditions = places.iter().map(|place| condition(&tree, place));
    let conditions: Vec<f64> = conditions.collect();
    let [best, worst] = [f64::min, f64::max].map(|pick| conditions.iter().copied().reduce(pick).expect("a place"));
    if worst > WORST_CONDITION && best < SINGULAR {
        return Ok(Tried::LeftOut);
    }
    let singular = best >= SINGULAR;
    let words = words(&tree, &mut random);
    let in_c = seed.is_multiple_of(number("PENDULUM_C", ONE_IN_C));
    loop {
        let words: Vec<&str> = words
            .iter()
            .copied()
            .filter(|word| match *word {
                "parameter_jacobian" => !tree.parameters.is_empty(),
                // of motions whose forces are known
                "canonical" | "taylor" => tree.inputs.is_empty(),
                _ => true,
            })
            .collect();
        let declaration = tree.declaration("Random", &words);
        let failed = |what: &dyn std::fmt::Display| Err(format!("{what}\n{declaration}"));
        let made = catch_unwind(AssertUnwindSafe(|| program(declaration.parse().expect("tokens"))));
        let Ok(made) = made else {
            return failed(&"the generator panics");
        };
        let program = match made {
            Ok(program) => program,
            Err(errors) => {
                let text = errors.to_string();
                if let Some(less) = without_useless(&tree, &text) {
                    tree = less;
                    for place in &mut places {
                        place.inputs.truncate(tree.inputs.len());
                    }
                    continue;
                }
                if singular && text.contains("has no inertia") {
                    return Ok(Tried::Refused);
                }
                return failed(&text);
            }
        };
        if singular {
            return failed(&"the mass matrix is singular");
        }
        let agrees = compared(&format!("{kind:?}{seed}"), &tree, &program, &places, tolerance, in_c);
        return agrees.or_else(|what| failed(&format!("{what}, condition {worst:.1e}")));
    }
}

/// What came of a program; what is wrong with it, if anything is.
fn compared(
    name: &str,
    tree: &Tree,
    program: &Program,
    places: &[Place],
    tolerance: f64,
    in_c: bool,
) -> Result<Tried, String> {
    let errors = catch_unwind(AssertUnwindSafe(|| compare::errors(tree, program, places)));
    let errors = errors.map_err(|_| "the evaluation panics")?;
    if errors.values().any(|error| error.is_nan() || *error > tolerance) {
        return Err(format!("errors {}", shown(&errors)));
    }
    let mut same = Ok(false);
    if in_c {
        let run = || in_c::same(name, program, &tree.parameters, places);
        same = catch_unwind(AssertUnwindSafe(run)).map_err(|_| "the C code fails")?;
    }
    same.map(|in_c| Tried::Agrees { errors, in_c })
}

fn shown(errors: &Worst) -> String {
    let errors = errors.iter().map(|(what, error)| format!("{what} {error:.1e}"));
    errors.collect::<Vec<_>>().join(", ")
}

/// The tree without what an error calls useless: a number of a mass on the axis that it turns about, an input that
/// pushes where nothing can move, an event where nothing does.
fn without_useless(tree: &Tree, errors: &str) -> Option<Tree> {
    let quoted = |end: &str| errors.split_once(end)?.0.rsplit('`').next();
    if let Some(name) = quoted("` changes nothing") {
        let (kind, n) = name.split_at_checked(1)?;
        let n = n.parse().ok()?;
        return match kind {
            "p" => Some(tree.without(Name::Parameter(n))),
            "u" => Some(tree.without(Name::Input(n))),
            _ => None,
        };
    }
    let event = quoted("` never occurs")?.strip_prefix('e')?;
    Some(tree.without_event(event.parse().ok()?))
}

/// What is generated: all of it for small trees, something of it for others.
fn words(tree: &Tree, random: &mut Random) -> Vec<&'static str> {
    let mut words = vec!["rhs", "mass_matrix", "bias", "momentum", "inverse_dynamics", "energy"];
    let part = if tree.dof() < 3 { 0.7 } else { 0.25 };
    let further = ["jacobian", "parameter_jacobian", "canonical", "taylor"];
    words.extend(further.into_iter().filter(|_| random.between(0.0, 1.0) < part));
    if tree.drives() > 0 {
        words.push("drive_forces");
    }
    words
}
