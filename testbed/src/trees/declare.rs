//! Declarations of random trees.

use std::fmt::{self, Display, Formatter};

use super::{Action, Body, Event, Form, Joint, Law, Matter, Moves, Name, Number, Output, Solid, Torque, Tree, Triple};

/// Names of the axes.
const AXES: [&str; 3] = ["x", "y", "z"];

impl Tree {
    /// Returns the declaration of the tree: the contents of its `mechanism! { .. }`.
    pub fn declaration(&self, name: &str, generate: &[&str]) -> String {
        let mut text = format!("pub {name} {{\n    units: none,\n");
        if !self.parameters.is_empty() {
            let list = self.parameters.iter().enumerate();
            let list: Vec<String> = list.map(|(n, value)| format!("p{n}: 1 = {value}")).collect();
            text += &format!("    params {{ {} }}\n", list.join(", "));
        }
        for n in 0..self.inputs.len() {
            text += &format!("    input u{n}: 1,\n");
        }
        text += &format!("    gravity: {},\n", vector(&self.gravity));
        text += &format!("    generate: [{}],\n", generate.join(", "));
        for (n, point) in self.points.iter().enumerate() {
            text += &format!(
                "    point a{n} on {} at {},\n",
                body_name(point.body),
                vector(&point.at)
            );
        }
        for action in &self.actions {
            text += &format!("    {action},\n");
        }
        for (n, output) in self.outputs.iter().enumerate() {
            text += &format!("    output o{n}: {output},\n");
        }
        for (n, event) in self.events.iter().enumerate() {
            text += &format!("    event e{n}: {event},\n");
        }
        for (n, body) in self.bodies.iter().enumerate() {
            text += &format!("    body b{n} on {} {{ {body} }}\n", body_name(body.parent));
        }
        text + "}\n"
    }
}

fn body_name(body: Option<usize>) -> String {
    body.map_or("ground".to_owned(), |n| format!("b{n}"))
}

fn vector(components: &[Number]) -> String {
    let components: Vec<String> = components.iter().map(Number::to_string).collect();
    format!("[{}]", components.join(", "))
}

impl Display for Number {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self.name {
            Some(Name::Parameter(n)) => write!(f, "p{n}"),
            Some(Name::Input(n)) => write!(f, "u{n}"),
            None => write!(f, "{}", self.value),
        }
    }
}

impl Display for Body {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        if let Some(matter) = &self.matter {
            write!(f, "{matter}, ")?;
        }
        write!(f, "joint: {}", self.joint)?;
        if let Some(at) = &self.at {
            write!(f, " at {}", vector(at))?;
        }
        if let Some(rpy) = &self.rpy {
            write!(f, " rpy {}", vector(rpy))?;
        }
        match self.moves {
            Moves::Never => {}
            Moves::Freely(k) => write!(f, ", coordinate: q{k}")?,
            Moves::Absolutely(k) => write!(f, ", coordinate: q{k} absolute")?,
            Moves::ByLaw(law) => write!(f, ", motion: {law}")?,
        }
        if let Some(friction) = self.friction {
            write!(f, ", friction: {friction}")?;
        }
        if let Some([stiffness, rest]) = self.spring {
            write!(f, ", spring: ({stiffness}, {rest})")?;
        }
        match self.torque {
            None => Ok(()),
            Some(Torque::Constant(c)) => write!(f, ", torque: {c}"),
            Some(Torque::Sine(c)) => write!(f, ", torque: -{c}*sin(q)"),
            Some(Torque::Cubic(c)) => write!(f, ", torque: -{c}*qd^3"),
            Some(Torque::Pumped(c)) => write!(f, ", torque: {c}*q*cos(2*t)"),
            Some(Torque::Cosine(c)) => write!(f, ", torque: {c}*cos(q)"),
        }
    }
}

impl Display for Matter {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Lump { mass, com, inertia } => {
                write!(f, "mass: {mass}")?;
                if let Some(com) = com {
                    write!(f, ", com: {}", vector(com))?;
                }
                if let Some(inertia) = inertia {
                    let diagonal = inertia[3..].iter().all(|product| product.value == 0.0);
                    write!(f, ", inertia: {}", vector(&inertia[..if diagonal { 3 } else { 6 }]))?;
                }
                Ok(())
            }
            Self::Solids(solids) => {
                let solids: Vec<String> = solids.iter().map(Solid::to_string).collect();
                write!(f, "solids: [{}]", solids.join(", "))
            }
        }
    }
}

impl Display for Solid {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let mass = self.mass;
        match &self.form {
            Form::Point(at) => write!(f, "point({mass}, {})", vector(at)),
            Form::Rod([from, to]) => write!(f, "rod({mass}, {}, {})", vector(from), vector(to)),
            Form::Disk(radius, at) => write!(f, "disk({mass}, {radius}, {})", vector(at)),
            Form::Plate(corners) => {
                let corners: Vec<String> = corners.iter().map(|corner| vector(corner)).collect();
                write!(f, "plate({mass}, [{}])", corners.join(", "))
            }
            Form::Cuboid(sides, at) => write!(f, "cuboid({mass}, {}, {})", vector(sides), vector(at)),
            Form::Cylinder(radius, [from, to]) => {
                write!(f, "cylinder({mass}, {radius}, {}, {})", vector(from), vector(to))
            }
            Form::Sphere(radius, at) => write!(f, "sphere({mass}, {radius}, {})", vector(at)),
        }
    }
}

impl Display for Joint {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Fixed => write!(f, "fixed"),
            Self::Revolute(a) => write!(f, "revolute({})", axis(a)),
            Self::Prismatic(a) => write!(f, "prismatic({})", axis(a)),
            Self::Helical(a, pitch) => write!(f, "helical({}, {pitch})", axis(a)),
            Self::Screw(angular, linear) => write!(f, "screw({})", vector(&[*angular, *linear].concat())),
        }
    }
}

/// Name of a coordinate axis, with its sign.
fn axis(a: &Triple) -> String {
    let letter = AXES.into_iter().enumerate().find_map(|(n, letter)| {
        let others = (0..3).all(|m| m == n || a[m].value == 0.0);
        let sign = match a[n].value {
            1.0 => "",
            -1.0 => "-",
            _ => return None,
        };
        others.then(|| format!("{sign}{letter}"))
    });
    letter.unwrap_or_else(|| vector(a))
}

impl Display for Law {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Still => "3/8",
            Self::Swings => "sin(3*t/2)/2",
            Self::Drifts => "t^2/4 - t/8",
        })
    }
}

impl Display for Action {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Force { point, force, within } => {
                write!(f, "force on a{point}: {}", vector(force))?;
                within.map_or(Ok(()), |body| write!(f, " in b{body}"))
            }
            Self::Spring {
                between: [a, b],
                stiffness,
                length,
            } => write!(f, "spring between a{a} and a{b}: ({stiffness}, {length})"),
            Self::Damper {
                between: [a, b],
                coefficient,
            } => write!(f, "damper between a{a} and a{b}: {coefficient}"),
            Self::Along { a, b, c } => write!(f, "force q{a}: -{c}*dot(q{b})^3"),
            Self::Potential { a, b, c } => write!(f, "potential: {c}*cos(q{a})*q{b}"),
            Self::Dissipation { a, b, c } => write!(f, "dissipation: {c}/2*(dot(q{a}) + dot(q{b}))^2"),
        }
    }
}

impl Display for Output {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Position(point) => write!(f, "a{point}"),
            Self::Rotation(body) => write!(f, "rotation(b{body})"),
            Self::Velocity(point) => write!(f, "[dot(a{point}.x), dot(a{point}.y), dot(a{point}.z)]"),
            Self::Mixed { point, axes, c } => {
                let [k, l, m] = axes.map(|axis| AXES[axis]);
                write!(f, "{c}*a{point}.{k} + a{point}.{l}*dot(a{point}.{m})")
            }
        }
    }
}

impl Display for Event {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "a{}.{} - {}", self.point, AXES[self.axis], self.level)
    }
}
