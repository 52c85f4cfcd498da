//! Random mechanisms: generated code against equations of motion that are independent of the generator.
//!
//! `PENDULUM_MECHANISMS=5000 cargo test --release -p tests --test it random_mechanisms -- --nocapture` tries more
//! mechanisms and prints the largest errors; `PENDULUM_SEED` is the first seed. Failures are printed with their seed.
//! Every eighth mechanism is also printed as C, compiled and run; with `PENDULUM_C=1` every one is.

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

/// Maximum condition number of a mass matrix scaled to unit diagonal. Worse scenes are skipped: they lose digits in any
/// computation.
const WORST_CONDITION: f64 = 1e6;
/// Condition number beyond which the mass matrix counts as singular.
const SINGULAR: f64 = 1e12;

/// Default number of random mechanisms of each kind.
const DEFAULT: u64 = 10;

/// Default interval of mechanisms that are also compared in C.
const ONE_IN_C: u64 = 8;

/// Outcome of one random mechanism.
enum Tried {
    /// Agrees with the oracle, and in C if compared there.
    Agrees { errors: Worst, in_c: bool },
    /// Rejected for its singular mass matrix.
    Refused,
    /// Skipped for its nearly singular mass matrix.
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

/// Outcomes of many random mechanisms.
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
    // small mechanisms are as likely to reveal an error, and fast
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
                // only for motions without inputs
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

/// Outcome for a program.
///
/// # Errors
/// Returns a description of the differences.
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

/// Returns the tree without an item that an error reports as useless: a parameter of a mass on its own axis, an input
/// whose force moves nothing, an event of a constant.
fn without_useless(tree: &Tree, errors: &str) -> Option<Tree> {
    let quoted = |end: &str| errors.split_once(end)?.0.rsplit('`').next();
    if let Some(name) = quoted("` has no effect") {
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

/// Words of `generate`: many for small trees, some for others.
fn words(tree: &Tree, random: &mut Random) -> Vec<&'static str> {
    let mut words = vec!["rhs", "mass_matrix", "bias", "momentum", "inverse_dynamics", "energy"];
    let part = if tree.dof() < 3 { 0.7 } else { 0.25 };
    let further = [
        "jacobian",
        "parameter_jacobian",
        "canonical",
        "taylor",
        "adjoint",
        "hessian_product",
    ];
    words.extend(further.into_iter().filter(|_| random.between(0.0, 1.0) < part));
    if tree.drives() > 0 {
        words.push("drive_forces");
    }
    words
}
