//! Checks and repairs the inertia of links that move together: fixed joints merge them into one body.
//!
//! The second moments of mass about the centre of mass, `S = integral r r^T dm`, have no negative eigenvalue for any
//! physical body (Traversaro et al. 2016). The inertia is `J = tr(S) 1 - S`, and `S = tr(J)/2 1 - J`.

use std::collections::BTreeMap;

use super::declare::Replaced;
use super::matrix::{Matrix, Vector, add, eigen, outer, product, rotation, scaled, sum, times, trace, transpose};
use super::names::identifier;
use super::number::value;
use super::read::Wrong;
use super::robot::{Inertial, Joint, Kind, Link, Origin, Robot};
use super::tree::carrier;
use crate::error::Code;

/// Tolerance of negative eigenvalues, relative to the sum of all magnitudes: files have six digits.
const ROUNDED: f64 = 1e-6;
/// Length in m for an absolute tolerance of negative eigenvalues: the mass times its square.
const LEAST_LENGTH: f64 = 1e-6;
/// Rounding error of a repair, relative to the second moments: smaller changes are ignored.
const DUST: f64 = 1e-13;

/// Mass, first and second moments of mass about the origin of a link, along its axes.
#[derive(Clone, Copy, Debug, Default)]
struct Moments {
    mass: f64,
    first: Vector,
    second: Matrix,
}

/// Link of a body, with its rotation in the frame of the first link.
struct Member<'r> {
    link: &'r Link,
    turn: Matrix,
    /// True if the scene gives its mass properties.
    given: bool,
}

/// Links that move as one body with the first of them.
struct Group<'r> {
    members: Vec<Member<'r>>,
    /// Moments of the links whose mass the file gives.
    moments: Moments,
    /// Moments of all links, with the values of the file even where the scene gives others.
    with_given: Moments,
}

/// Checks the inertias of all bodies formed by the links. With `repair`, replaces each impossible inertia by the
/// nearest possible one, and returns messages that name the link and the size of the change. The root and links fixed
/// to it do not move, and are not checked, unless the scene gives the root a joint.
pub(super) fn check(robot: &mut Robot, replaced: &[Replaced], repair: bool, wrong: &mut Vec<Wrong>) -> Vec<String> {
    let replaced: BTreeMap<&str, &Replaced> = replaced.iter().map(|own| (&*own.body, own)).collect();
    report_negative(robot, &replaced, wrong);
    let (mut repairs, mut messages) = (BTreeMap::new(), Vec::new());
    let carrier = carrier(robot);
    for group in groups(robot, &carrier, &replaced) {
        let Link { name: first, line, .. } = group.members[0].link;
        let (first, line) = (first.as_str(), Some(*line));
        let name = identifier(first);
        if group.moments.mass == 0.0 && group.moments.second.iter().flatten().any(|&x| x != 0.0) {
            wrong.extend(group.without_mass(&name, line));
            continue;
        }
        let (Some(excess), Some(_)) = (group.moments.excess(), group.with_given.excess()) else {
            continue;
        };
        let with = if group.members.len() > 1 {
            " and the links fixed to it"
        } else {
            ""
        };
        let share = percent(excess.missing / excess.total);
        let repaired = group.repaired(&excess);
        if let Some((link, inertial)) = repaired.as_ref().filter(|_| repair) {
            let shown = identifier(link);
            let shown = shown.trim_start_matches("r#");
            messages.push(format!(
                "inertia of `{shown}`, by {share} of its second moments of mass"
            ));
            repairs.insert((*link).to_owned(), inertial.clone());
            continue;
        }
        let parent = carrier
            .get(first)
            .map_or("ground".to_owned(), |joint| identifier(&joint.parent));
        let give = format!("give `body {name} on {parent} {{ mass: .., com: .., inertia: .. }}` in the scene");
        wrong.push(Wrong {
            code: Code::FileInertia,
            line,
            fact: format!(
                "no rigid body has the inertia of `{name}`{with}: its principal moments about the centre of mass \
                 violate the triangle inequality, by {share} of the second moments of mass"
            ),
            help: match repaired {
                Some(_) => format!("write `repair` after the path to use the nearest possible inertia, or {give}"),
                None => format!("{give}: no possible inertia is near"),
            },
        });
    }
    for link in &mut robot.links {
        if let Some(inertial) = repairs.remove(&link.name) {
            link.inertial = Some(inertial);
        }
    }
    messages
}

/// Reports negative masses, except where the scene gives another mass.
fn report_negative(robot: &Robot, replaced: &BTreeMap<&str, &Replaced>, wrong: &mut Vec<Wrong>) {
    for Link { name, line, inertial } in &robot.links {
        let name = identifier(name);
        let mass = inertial.as_ref().map_or(0.0, |inertial| value(&inertial.mass));
        if mass < 0.0 && !replaced.get(&*name).is_some_and(|own| own.weighs) {
            wrong.push(Wrong {
                code: Code::FileInertia,
                line: Some(*line),
                fact: format!("the mass of `{name}` is {mass}"),
                help: "it must be positive".to_owned(),
            });
        }
    }
}

fn percent(share: f64) -> String {
    let percent = 100.0 * share;
    if percent < 0.1 {
        format!("{percent:.1e} %")
    } else {
        format!("{percent:.1} %")
    }
}

/// Returns the groups of links that move.
fn groups<'r>(
    robot: &'r Robot,
    carrier: &BTreeMap<&str, &'r Joint>,
    replaced: &BTreeMap<&str, &Replaced>,
) -> Vec<Group<'r>> {
    let mut groups: Vec<Group<'r>> = Vec::new();
    let mut places: BTreeMap<&str, (Option<usize>, Matrix, Vector)> = BTreeMap::new();
    for link in in_order(robot, carrier) {
        let name = &*link.name;
        let own = replaced.get(&*identifier(name)).copied();
        let joint = carrier.get(name).copied();
        let moves = match (own.and_then(|own| own.moves), joint) {
            (_, Some(joint)) if joint.kind == Kind::Planar => true,
            (Some(moves), _) => moves,
            (None, joint) => joint.is_some_and(|joint| joint.kind != Kind::Fixed),
        };
        let (group, turn, shift) = match joint.map(|joint| (joint, places[&*joint.parent])) {
            // a link with another place in the scene is checked by itself
            Some((_, (Some(_), ..))) if own.is_some_and(|own| own.placed) => {
                (Some(groups.len()), rotation([0.0; 3]), [0.0; 3])
            }
            Some((joint, (group, turn, shift))) if !moves => {
                let (own, at) = place(&joint.origin);
                (group, product(&turn, &own), add(shift, times(&turn, at)))
            }
            // the fixed root, or the first link of a body
            _ => (moves.then_some(groups.len()), rotation([0.0; 3]), [0.0; 3]),
        };
        places.insert(name, (group, turn, shift));
        let Some(n) = group else { continue };
        if n == groups.len() {
            groups.push(Group {
                members: Vec::new(),
                moments: Moments::default(),
                with_given: Moments::default(),
            });
        }
        let given = own.is_some_and(|own| own.weighs);
        if let Some(inertial) = &link.inertial {
            let moments = Moments::of(inertial).placed(&turn, shift);
            groups[n].with_given.add(&moments);
            if !given {
                groups[n].moments.add(&moments);
            }
        }
        groups[n].members.push(Member { link, turn, given });
    }
    groups
}

/// Returns the links, each after the one that carries it.
fn in_order<'r>(robot: &'r Robot, carrier: &BTreeMap<&str, &Joint>) -> Vec<&'r Link> {
    let is_root = |link: &&Link| !carrier.contains_key(&*link.name);
    let mut order: Vec<&Link> = robot.links.iter().filter(is_root).collect();
    let mut children: BTreeMap<&str, Vec<&Link>> = BTreeMap::new();
    let links: BTreeMap<&str, &Link> = robot.links.iter().map(|link| (&*link.name, link)).collect();
    for joint in &robot.joints {
        children
            .entry(&joint.parent)
            .or_default()
            .extend(links.get(&*joint.child));
    }
    let mut n = 0;
    while n < order.len() {
        order.extend(children.get(&*order[n].name).into_iter().flatten());
        n += 1;
    }
    order
}

/// Returns the rotation of a frame and the position of its origin.
fn place(origin: &Origin) -> (Matrix, Vector) {
    let [rpy, xyz] = [&origin.rpy, &origin.xyz].map(|numbers| numbers.each_ref().map(|text| value(text)));
    (rotation(rpy), xyz)
}

/// Negative part of second moments of mass.
struct Excess {
    /// Moments about the centre of mass without the negative part.
    nearest: Matrix,
    /// Difference of `nearest` and the given moments.
    change: Matrix,
    /// Sum of the magnitudes of negative eigenvalues.
    missing: f64,
    /// Sum of the magnitudes of all eigenvalues.
    total: f64,
}

impl Group<'_> {
    /// Error of an inertia without mass, unless it may belong to a mass given by the scene.
    fn without_mass(&self, name: &str, line: Option<usize>) -> Option<Wrong> {
        self.members.iter().all(|member| !member.given).then(|| Wrong {
            code: Code::FileInertia,
            line,
            fact: format!("`{name}` has an inertia, but its mass is 0"),
            help: "give it its mass in kg".to_owned(),
        })
    }

    /// Returns the heaviest link whose mass the file gives, with its repaired inertia. Returns `None` if that link has
    /// no mass, since no possible inertia is near.
    fn repaired(&self, excess: &Excess) -> Option<(&str, Inertial)> {
        let mass = |member: &Member<'_>| {
            let inertial = member.link.inertial.as_ref();
            inertial.map_or(0.0, |inertial| value(&inertial.mass))
        };
        let own = self.members.iter().filter(|member| !member.given);
        let heaviest = own.max_by(|a, b| mass(a).total_cmp(&mass(b)))?;
        let inertial = heaviest.link.inertial.as_ref()?;
        if mass(heaviest) <= 0.0 || trace(&excess.nearest) <= 0.0 {
            return None;
        }
        // in the axes of its inertia
        let (own, _) = place(&inertial.origin);
        let turn = product(&heaviest.turn, &own);
        let change = turned_over(&product(&transpose(&turn), &product(&excess.change, &turn)), 1.0);
        let all = sum(&inertia(inertial), &change);
        // entries that change by rounding only keep their text
        let rounded = DUST * trace(&excess.nearest);
        let entries = ENTRIES.map(|(i, j)| (all[i][j], change[i][j]));
        let entries = entries.iter().zip(&inertial.inertia).map(|((all, change), given)| {
            if change.abs() <= rounded {
                given.clone()
            } else {
                format!("{all:?}")
            }
        });
        let entries: Vec<String> = entries.collect();
        Some((
            &heaviest.link.name,
            Inertial {
                inertia: entries.try_into().ok()?,
                ..inertial.clone()
            },
        ))
    }
}

impl Moments {
    /// Returns the negative part of the second moments about the centre of mass, if it exceeds rounding errors.
    fn excess(&self) -> Option<Excess> {
        let Self { mass, first, second } = *self;
        if mass <= 0.0 {
            return None;
        }
        let central = sum(&second, &scaled(&outer(first, first), -1.0 / mass));
        let (values, axes) = eigen(&central);
        let total: f64 = values.iter().map(|value| value.abs()).sum();
        let rounded = (ROUNDED * total).max(mass * LEAST_LENGTH * LEAST_LENGTH);
        if values.iter().all(|&value| value >= -rounded) {
            return None;
        }
        let missing = values.iter().map(|value| (-value).max(0.0)).sum();
        let nearest = (0..3).fold([[0.0; 3]; 3], |nearest, n| {
            sum(&nearest, &scaled(&outer(axes[n], axes[n]), values[n].max(0.0)))
        });
        Some(Excess {
            nearest,
            change: sum(&nearest, &scaled(&central, -1.0)),
            missing,
            total,
        })
    }

    /// Returns the moments of a link about its origin.
    fn of(inertial: &Inertial) -> Self {
        let (own, at) = place(&inertial.origin);
        let mass = value(&inertial.mass);
        let central = turned_over(&inertia(inertial), 0.5);
        let turned = product(&own, &product(&central, &transpose(&own)));
        Self {
            mass,
            first: at.map(|x| mass * x),
            second: sum(&turned, &scaled(&outer(at, at), mass)),
        }
    }

    /// Returns the moments in a frame where the link is rotated by `turn` and shifted by `shift`.
    fn placed(&self, turn: &Matrix, shift: Vector) -> Self {
        let Self { mass, second, .. } = *self;
        let first = times(turn, self.first);
        let second = product(turn, &product(&second, &transpose(turn)));
        let mixed = sum(&outer(first, shift), &outer(shift, first));
        Self {
            mass,
            first: add(first, shift.map(|x| mass * x)),
            second: sum(&sum(&second, &mixed), &scaled(&outer(shift, shift), mass)),
        }
    }

    fn add(&mut self, other: &Self) {
        self.mass += other.mass;
        self.first = add(self.first, other.first);
        self.second = sum(&self.second, &other.second);
    }
}

/// Row and column of each entry of an inertia in a file.
const ENTRIES: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];

fn inertia(inertial: &Inertial) -> Matrix {
    let [xx, yy, zz, xy, xz, yz] = inertial.inertia.each_ref().map(|text| value(text));
    [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]
}

/// Returns `part tr(M) 1 - M`: for `part = 1`, the inertia of second moments `M` of mass; for `part = 1/2`, the second
/// moments of an inertia `M`.
fn turned_over(matrix: &Matrix, part: f64) -> Matrix {
    let diagonal = part * trace(matrix);
    std::array::from_fn(|i| std::array::from_fn(|j| if i == j { diagonal - matrix[i][j] } else { -matrix[i][j] }))
}
