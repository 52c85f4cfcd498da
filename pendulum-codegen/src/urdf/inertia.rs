//! Inertia of links that move together: fixed joints make one body of them.
//!
//! What a body weighs is its second moments of mass, `S = integral r r^T dm` about its centre of mass, which have no
//! negative eigenvalue (Traversaro et al. 2016). `J = tr(S) 1 - S` is its inertia, and `S = tr(J)/2 1 - J`.

use std::collections::BTreeMap;

use super::declare::Replaced;
use super::matrix::{Matrix, Vector, add, eigen, outer, product, rotation, scaled, times, trace, transpose};
use super::names::identifier;
use super::number::value;
use super::read::Wrong;
use super::robot::{Inertial, Joint, Kind, Link, Origin, Robot};

/// Below zero by less than this part of their sum, eigenvalues are rounded: files have six digits.
const ROUNDED: f64 = 1e-6;
/// And by less than the mass times the square of this length, in m.
const LEAST_LENGTH: f64 = 1e-6;

/// Mass, first and second moments of mass about the origin of a link, along its axes.
#[derive(Clone, Copy, Debug)]
struct Moments {
    mass: f64,
    first: Vector,
    second: Matrix,
}

/// Links that move as one with the first of them; each with how it is turned in the frame of that, and whether the scene
/// gives its mass.
struct Group<'r> {
    links: Vec<(&'r Link, Matrix, bool)>,
    moments: Moments,
}

/// Checks the inertias of all bodies that links make together. Where `repair`, each that no body can have becomes the
/// nearest that one can: the messages say which, and by how much. The root of the links does not move unless the scene
/// gives it a joint, nor do those that are fixed to it.
pub(super) fn check(robot: &mut Robot, replaced: &[Replaced], repair: bool, wrong: &mut Vec<Wrong>) -> Vec<String> {
    for Link { name, inertial } in &robot.links {
        let mass = inertial.as_ref().map_or(0.0, |inertial| value(&inertial.mass));
        if mass < 0.0 {
            wrong.push(Wrong {
                fact: format!("the mass of `{}` is {mass}", identifier(name)),
                help: "it must be positive".to_owned(),
            });
        }
    }
    let mut changes: Vec<(String, Inertial)> = Vec::new();
    let mut repaired = Vec::new();
    for group in groups(robot, replaced) {
        let (first, ..) = group.links[0];
        let name = identifier(&first.name);
        if group.moments.mass == 0.0 && trace(&group.moments.second) != 0.0 {
            wrong.push(Wrong {
                fact: format!("`{name}` has an inertia, but its mass is 0"),
                help: "give it its mass in kg".to_owned(),
            });
            continue;
        }
        let Some(excess) = group.excess() else { continue };
        let with = if group.links.len() > 1 {
            " with what is fixed to it"
        } else {
            ""
        };
        let share = percent(excess.missing / excess.total);
        match group.repaired(&excess) {
            Some((link, inertial)) if repair => {
                let link = identifier(link);
                repaired.push(format!("inertia of `{link}`, by {share} of its second moments of mass"));
                changes.push((link, inertial));
            }
            _ => wrong.push(Wrong {
                fact: format!(
                    "no rigid body has the inertia of `{name}`{with}: its principal moments about the centre of mass \
                     break the triangle inequality, by {share} of the second moments of mass"
                ),
                help: format!(
                    "write `repair` behind the path for the nearest that a body can have, or give `body {name} on {} \
                     {{ mass: .., com: .., inertia: .. }}` in the scene",
                    parent(robot, &first.name)
                ),
            }),
        }
    }
    for (name, inertial) in changes {
        let link = robot.links.iter_mut().find(|link| identifier(&link.name) == name);
        if let Some(link) = link {
            link.inertial = Some(inertial);
        }
    }
    repaired
}

fn percent(share: f64) -> String {
    let percent = 100.0 * share;
    if percent < 0.1 {
        format!("{percent:.1e} %")
    } else {
        format!("{percent:.1} %")
    }
}

fn parent(robot: &Robot, link: &str) -> String {
    let joint = robot.joints.iter().find(|joint| joint.child == link);
    joint.map_or("ground".to_owned(), |joint| identifier(&joint.parent))
}

/// The groups of links that move.
fn groups<'r>(robot: &'r Robot, replaced: &[Replaced]) -> Vec<Group<'r>> {
    let find = |link: &str| replaced.iter().find(|own| own.body == identifier(link));
    let carrier: BTreeMap<&str, &Joint> = robot.joints.iter().map(|joint| (&*joint.child, joint)).collect();
    let moves = |link: &str| match (find(link).and_then(|own| own.moves), carrier.get(link)) {
        (Some(moves), _) => moves,
        (None, joint) => joint.is_some_and(|joint| joint.kind != Kind::Fixed),
    };
    let mut groups: Vec<Group<'r>> = Vec::new();
    let mut places: BTreeMap<&str, (Option<usize>, Matrix, Vector)> = BTreeMap::new();
    for link in in_order(robot) {
        let name = &*link.name;
        let (group, turn, shift) = match carrier.get(name).map(|joint| (joint, places[&*joint.parent])) {
            Some((joint, (group, turn, shift))) if !moves(name) => {
                let (own, at) = place(&joint.origin);
                (group, product(&turn, &own), add(shift, times(&turn, at)))
            }
            // the root, which stands still, or what begins a body
            _ => (moves(name).then_some(groups.len()), rotation([0.0; 3]), [0.0; 3]),
        };
        places.insert(name, (group, turn, shift));
        let Some(n) = group else { continue };
        if n == groups.len() {
            groups.push(Group {
                links: Vec::new(),
                moments: Moments {
                    mass: 0.0,
                    first: [0.0; 3],
                    second: [[0.0; 3]; 3],
                },
            });
        }
        // what the scene gives is judged there
        let given = find(name).is_some_and(|own| own.weighs);
        if let Some(inertial) = link.inertial.as_ref().filter(|_| !given) {
            groups[n].moments.add(&Moments::of(inertial).placed(&turn, shift));
        }
        groups[n].links.push((link, turn, given));
    }
    groups
}

/// The links, each behind the one that carries it.
fn in_order(robot: &Robot) -> Vec<&Link> {
    let mut order: Vec<&Link> = Vec::new();
    let is_root = |link: &&Link| robot.joints.iter().all(|joint| joint.child != link.name);
    order.extend(robot.links.iter().filter(is_root));
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

/// Where a frame is turned, and where its origin is.
fn place(origin: &Origin) -> (Matrix, Vector) {
    let [rpy, xyz] = [&origin.rpy, &origin.xyz].map(|numbers| numbers.each_ref().map(|text| value(text)));
    (rotation(rpy), xyz)
}

/// By how much second moments of mass are below zero.
struct Excess {
    /// The moments about the centre of mass with nothing below zero.
    nearest: Matrix,
    /// What they have more than they had.
    change: Matrix,
    missing: f64,
    total: f64,
}

impl Group<'_> {
    /// Negative second moments about the centre of mass, if there are any beyond rounding.
    fn excess(&self) -> Option<Excess> {
        let Moments { mass, first, second } = self.moments;
        if mass <= 0.0 {
            return None;
        }
        let central = sum(&second, &scaled(&outer(first, first), -1.0 / mass));
        let (values, axes) = eigen(&central);
        let total: f64 = values.iter().map(|value| value.abs()).sum();
        let rounded = (ROUNDED * total).max(mass * LEAST_LENGTH * LEAST_LENGTH);
        let missing = -values.iter().fold(0.0, |least: f64, &value| least.min(value));
        if missing <= rounded {
            return None;
        }
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

    /// The heaviest link with what is missing; none without mass, for which nothing is near.
    fn repaired(&self, excess: &Excess) -> Option<(&str, Inertial)> {
        let mass = |link: &Link| link.inertial.as_ref().map_or(0.0, |inertial| value(&inertial.mass));
        let own = self.links.iter().filter(|(.., given)| !given);
        let (link, turn, _) = own.max_by(|(a, ..), (b, ..)| mass(a).total_cmp(&mass(b)))?;
        let inertial = link
            .inertial
            .as_ref()
            .filter(|_| mass(link) > 0.0 && trace(&excess.nearest) > 0.0)?;
        let (own, _) = place(&inertial.origin);
        // along the axes of the link
        let change = product(&transpose(turn), &product(&excess.change, turn));
        let given = inertia(inertial);
        let given = product(&own, &product(&given, &transpose(&own)));
        let all = sum(&given, &turned_over(&change));
        let entries = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)].map(|(i, j)| format!("{:?}", all[i][j]));
        let Origin { xyz, .. } = &inertial.origin;
        Some((
            &link.name,
            Inertial {
                origin: Origin {
                    xyz: xyz.clone(),
                    rpy: ["0"; 3].map(str::to_owned),
                },
                mass: inertial.mass.clone(),
                inertia: entries,
            },
        ))
    }
}

impl Moments {
    /// Those of a link about its origin.
    fn of(inertial: &Inertial) -> Self {
        let (own, at) = place(&inertial.origin);
        let mass = value(&inertial.mass);
        let inertia = inertia(inertial);
        let half = 0.5 * trace(&inertia);
        let central: Matrix = std::array::from_fn(|i| {
            std::array::from_fn(|j| if i == j { half - inertia[i][j] } else { -inertia[i][j] })
        });
        let turned = product(&own, &product(&central, &transpose(&own)));
        Self {
            mass,
            first: at.map(|x| mass * x),
            second: sum(&turned, &scaled(&outer(at, at), mass)),
        }
    }

    /// The same in a frame in which the link is turned and shifted.
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

fn inertia(inertial: &Inertial) -> Matrix {
    let [xx, yy, zz, xy, xz, yz] = inertial.inertia.each_ref().map(|text| value(text));
    [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]
}

/// The inertia of second moments of mass.
fn turned_over(second: &Matrix) -> Matrix {
    let whole = trace(second);
    std::array::from_fn(|i| std::array::from_fn(|j| if i == j { whole - second[i][j] } else { -second[i][j] }))
}

fn sum(a: &Matrix, b: &Matrix) -> Matrix {
    std::array::from_fn(|i| add(a[i], b[i]))
}
