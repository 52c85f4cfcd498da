//! Reads the links and joints of a URDF file, with their numbers as text of the language.

use std::collections::{BTreeMap, BTreeSet};

use roxmltree::{Document, Error, Node};

use super::number::{ZERO, angle, are_zero, length};
use super::robot::{Inertial, Joint, Kind, Link, Mimic, Origin, Robot};
use crate::error::Code;
use crate::words;

/// Error in a file, with a help text.
#[derive(Debug)]
pub(super) struct Wrong {
    pub(super) code: Code,
    /// Line in the file, if the error has a single place.
    pub(super) line: Option<usize>,
    pub(super) fact: String,
    pub(super) help: String,
}

impl Wrong {
    /// The fact, behind the name of the file and the line.
    pub(super) fn fact_in(&self, file: &str) -> String {
        let line = self.line.map_or(String::new(), |line| format!(":{line}"));
        format!("`{file}{line}`: {}", self.fact)
    }
}

/// Elements without influence on the motion.
const ELSEWHERE: [&str; 18] = [
    "visual",
    "collision",
    "transmission",
    "gazebo",
    "material",
    "sensor",
    "contact",
    "mujoco",
    "ros2_control",
    "safety_controller",
    "calibration",
    "self_collision_checking",
    "collision_checking",
    "self_filter",
    "kinematic",
    "gravity",
    "surface",
    "verbose",
];

/// Attributes of the elements that describe the mechanism.
const ATTRIBUTES: [(&str, &[&str]); 7] = [
    ("origin", &["xyz", "rpy"]),
    ("mass", &["value"]),
    ("inertia", &["ixx", "ixy", "ixz", "iyy", "iyz", "izz"]),
    ("parent", &["link"]),
    ("child", &["link"]),
    ("axis", &["xyz"]),
    ("mimic", &["joint", "multiplier", "offset"]),
];

/// Attributes that are read from elements with further attributes for other programs.
const AMONG_OTHERS: [(&str, &[&str]); 2] = [
    ("dynamics", &["damping", "friction"]),
    ("limit", &["lower", "upper", "effort", "velocity"]),
];

const ROBOT: &str = "a URDF file is `<robot name=\"..\"> .. </robot>`";

const XACRO: &str = "this is a xacro file, not a URDF file";

/// Help for a file that is yet to be expanded.
pub(super) const EXPAND: &str = "expand it first: `xacro robot.urdf.xacro > robot.urdf`";

/// Default multiplier, also used for unreadable numbers, since it causes no further errors.
pub(super) const ONE: &str = "1.0";

/// Reads a file. Returns whatever can be read, and all errors; with `strict`, unknown elements are errors.
pub(super) fn read(text: &str, strict: bool) -> (Robot, Vec<Wrong>) {
    let breaks = text.match_indices('\n').map(|(at, _)| at).collect();
    let mut reader = Reader {
        strict,
        breaks,
        ..Reader::default()
    };
    let (fact, help) = match Document::parse(text) {
        Ok(document) => {
            reader.robot(document.root_element());
            return (reader.robot, reader.wrong);
        }
        Err(Error::DtdDetected) => (
            "`<!DOCTYPE ..>` is not supported".to_owned(),
            "remove it, and expand the entities that it declares",
        ),
        Err(Error::NoRootNode) => ("the file has no element".to_owned(), ROBOT),
        Err(Error::UnclosedRootNode | Error::UnexpectedEndOfStream) => (
            "unclosed element at the end of the file".to_owned(),
            "end it with `</robot>`",
        ),
        Err(Error::UnknownNamespace(prefix, _)) if prefix == "xacro" => (XACRO.to_owned(), EXPAND),
        Err(error) => (format!("invalid XML: {error}"), "correct it at this line and column"),
    };
    reader.wrong(Code::NotUrdf, fact, help);
    (reader.robot, reader.wrong)
}

#[derive(Debug, Default)]
pub(super) struct Reader {
    strict: bool,
    /// Positions of the line breaks.
    breaks: Vec<usize>,
    /// Line of the current element.
    line: Option<usize>,
    robot: Robot,
    wrong: Vec<Wrong>,
}

impl Reader {
    pub(super) fn wrong(&mut self, code: Code, fact: impl Into<String>, help: impl Into<String>) {
        let (fact, help, line) = (fact.into(), help.into(), self.line);
        self.wrong.push(Wrong { code, line, fact, help });
    }

    /// Moves to an element: from here on, errors are reported on its line, which is returned.
    pub(super) fn go_to(&mut self, node: Node<'_, '_>) -> usize {
        let line = 1 + self.breaks.partition_point(|&end| end < node.range().start);
        self.line = Some(line);
        line
    }

    fn robot(&mut self, root: Node<'_, '_>) {
        let is_xacro = |node: &Node<'_, '_>| node.tag_name().namespace().is_some_and(|space| space.contains("xacro"));
        if root.descendants().any(|node| is_xacro(&node)) {
            return self.wrong(Code::NotUrdf, XACRO, EXPAND);
        }
        if !root.has_tag_name("robot") {
            let fact = format!("the root element is `{}`, not `robot`", root.tag_name().name());
            return self.wrong(Code::NotUrdf, fact, ROBOT);
        }
        for node in self.children(root, "the robot", &["link", "joint"]) {
            self.go_to(node);
            match node.tag_name().name() {
                "link" => self.link(node),
                _ => self.joint(node),
            }
        }
        self.repeated("link", |robot| {
            let links = robot.links.iter();
            links.map(|link| (link.line, link.name.clone())).collect()
        });
        self.repeated("joint", |robot| {
            let joints = robot.joints.iter();
            joints.map(|joint| (joint.line, joint.name.clone())).collect()
        });
    }

    fn repeated(&mut self, what: &str, names: fn(&Robot) -> Vec<(usize, String)>) {
        let mut seen = BTreeSet::new();
        for (line, name) in names(&self.robot) {
            self.line = Some(line);
            if !seen.insert(name.clone()) {
                self.wrong(
                    Code::FileNames,
                    format!("{what} `{name}` is declared twice"),
                    "rename one of the two",
                );
            }
        }
    }

    fn link(&mut self, node: Node<'_, '_>) {
        let Some(name) = self.text(node, "name", "a link") else {
            return;
        };
        let (owner, line) = (format!("link `{name}`"), self.go_to(node));
        let parts = self.by_name(node, &owner, &["inertial"]);
        let inertial = parts.get("inertial").and_then(|&part| self.inertial(part, &owner));
        self.robot.links.push(Link { name, line, inertial });
    }

    fn inertial(&mut self, node: Node<'_, '_>, owner: &str) -> Option<Inertial> {
        self.go_to(node);
        let parts = self.by_name(node, owner, &["origin", "mass", "inertia"]);
        let origin = self.origin(parts.get("origin").copied(), owner);
        let (Some(&mass), Some(&inertia)) = (parts.get("mass"), parts.get("inertia")) else {
            self.go_to(node);
            let missing = if parts.contains_key("mass") { "inertia" } else { "mass" };
            self.wrong(
                Code::FileNumber,
                format!("`inertial` of {owner} has no `{missing}`"),
                "complete it, or remove `inertial` for a link without mass",
            );
            return None;
        };
        let mass = self.number(mass, "value", owner, None);
        let inertia = ["ixx", "iyy", "izz", "ixy", "ixz", "iyz"].map(|entry| self.number(inertia, entry, owner, None));
        let is_empty = mass == ZERO && are_zero(&inertia);
        (!is_empty).then_some(Inertial { origin, mass, inertia })
    }

    fn joint(&mut self, node: Node<'_, '_>) {
        let Some(name) = self.text(node, "name", "a joint") else {
            return;
        };
        let (owner, line) = (format!("joint `{name}`"), self.go_to(node));
        let known = ["origin", "parent", "child", "axis", "limit", "dynamics", "mimic"];
        let parts = self.by_name(node, &owner, &known);
        self.go_to(node);
        let word = self.text(node, "type", &owner);
        let kind = word.and_then(|word| self.kind(&word, &owner));
        let [parent, child] = ["parent", "child"].map(|end| self.end(node, &parts, end, &owner));
        let origin = self.origin(parts.get("origin").copied(), &owner);
        let axis = parts
            .get("axis")
            .and_then(|&part| self.triple(part, "xyz", &owner, length));
        let limits = parts
            .get("limit")
            .filter(|limit| limit.has_attribute("lower") || limit.has_attribute("upper"));
        let limits = limits.map(|&limit| {
            self.go_to(limit);
            let as_place = if kind == Some(Kind::Turns) { angle } else { length };
            ["lower", "upper"].map(|end| {
                let text = limit.attribute(end).unwrap_or(ZERO);
                self.parsed(text, end, &owner, as_place)
            })
        });
        let most = ["effort", "velocity"].map(|what| {
            let part = parts.get("limit").filter(|part| part.has_attribute(what));
            part.map_or(f64::INFINITY, |&part| self.largest(part, what, &owner))
        });
        let [damping, friction] = ["damping", "friction"].map(|what| {
            let part = parts.get("dynamics").filter(|part| part.has_attribute(what));
            let number = part.map(|&part| self.number(part, what, &owner, None));
            number.filter(|number| number != ZERO)
        });
        let mimic = parts.get("mimic").and_then(|&part| self.mimic(part, &owner));
        let (Some(kind), Some(parent), Some(child)) = (kind, parent, child) else {
            return;
        };
        self.robot.joints.push(Joint {
            name,
            line,
            kind,
            origin,
            parent,
            child,
            // the default of the specification
            axis: axis.unwrap_or_else(|| ["1", ZERO, ZERO].map(str::to_owned)),
            most,
            limits: limits.filter(|_| node.attribute("type") != Some("continuous")),
            damping,
            friction,
            mimic,
        });
    }

    /// Name of the link at an end of a joint.
    fn end(
        &mut self,
        joint: Node<'_, '_>,
        parts: &BTreeMap<&str, Node<'_, '_>>,
        end: &str,
        owner: &str,
    ) -> Option<String> {
        if let Some(&part) = parts.get(end) {
            return self.text(part, "link", &format!("the {end} of {owner}"));
        }
        self.go_to(joint);
        let (fact, help) = (format!("{owner} has no {end}"), format!("add `<{end} link=\"..\"/>`"));
        self.wrong(Code::FileNumber, fact, help);
        None
    }

    fn mimic(&mut self, node: Node<'_, '_>, owner: &str) -> Option<Mimic> {
        Some(Mimic {
            joint: self.text(node, "joint", &format!("the mimic of {owner}"))?,
            multiplier: self.number(node, "multiplier", owner, Some(ONE)),
            offset: self.number(node, "offset", owner, Some(ZERO)),
        })
    }

    fn kind(&mut self, word: &str, owner: &str) -> Option<Kind> {
        Some(match word {
            "fixed" => Kind::Fixed,
            "revolute" | "continuous" => Kind::Turns,
            "prismatic" => Kind::Slides,
            "floating" => Kind::Floats,
            "planar" => Kind::Planar,
            _ => {
                let known = "supported types: fixed, revolute, continuous, prismatic, floating, planar";
                self.wrong(
                    Code::FileJoint,
                    format!("{owner} has the unsupported type `{word}`"),
                    known,
                );
                return None;
            }
        })
    }

    fn origin(&mut self, node: Option<Node<'_, '_>>, owner: &str) -> Origin {
        let mut of = |attribute: &str, read: fn(&str) -> Option<String>| {
            let given = node.filter(|node| node.has_attribute(attribute));
            let given = given.and_then(|node| self.triple(node, attribute, owner, read));
            given.unwrap_or_else(|| [ZERO; 3].map(str::to_owned))
        };
        Origin {
            xyz: of("xyz", length),
            rpy: of("rpy", angle),
        }
    }

    /// Returns the child elements of known names. Elements for other programs or in a namespace are left out.
    fn children<'a, 'i>(&mut self, node: Node<'a, 'i>, owner: &str, known: &[&str]) -> Vec<Node<'a, 'i>> {
        let mut found = Vec::new();
        // the default namespace, if there is one
        let own = node.document().root_element().tag_name().namespace();
        for child in node.children().filter(Node::is_element) {
            let name = child.tag_name();
            let is_own = name.namespace() == own;
            if is_own && known.contains(&name.name()) {
                found.push(child);
            } else if !is_own || name.name().contains(':') || ELSEWHERE.contains(&name.name()) {
                self.robot.left_out.insert(name.name().to_owned());
            } else {
                self.unknown_element(child, owner, known);
            }
        }
        found
    }

    /// Leaves out an unknown element; reports it if it seems misspelt, or if all elements must be known.
    fn unknown_element(&mut self, node: Node<'_, '_>, owner: &str, known: &[&str]) {
        let name = node.tag_name().name();
        let meant = words::advice(name, known.iter().copied(), &[]).meant;
        if !self.strict && meant.is_none() {
            self.robot.left_out.insert(name.to_owned());
            return;
        }
        self.go_to(node);
        let fact = format!("unknown element `{name}` in {owner}");
        let help = match meant {
            Some(meant) => format!("did you mean `{meant}`? otherwise remove it"),
            None => format!("remove it, or leave out `strict`; known here: {}", known.join(", ")),
        };
        self.wrong(Code::FileElement, fact, help);
    }

    /// Returns the child elements by name; reports repeated names.
    fn by_name<'a, 'i>(&mut self, node: Node<'a, 'i>, owner: &str, known: &[&str]) -> BTreeMap<&'a str, Node<'a, 'i>> {
        let mut parts = BTreeMap::new();
        for part in self.children(node, owner, known) {
            let name = part.tag_name().name();
            self.go_to(part);
            if parts.insert(name, part).is_some() {
                self.wrong(
                    Code::FileElement,
                    format!("{owner} has two `{name}` elements"),
                    "keep one of the two",
                );
            }
            self.check_attributes(part, owner);
        }
        parts
    }

    /// Reports misspelt attributes, which would otherwise pass for missing ones.
    fn check_attributes(&mut self, part: Node<'_, '_>, owner: &str) {
        let element = part.tag_name().name();
        let of = |(name, _): &&(&str, _)| *name == element;
        if let Some((_, known)) = ATTRIBUTES.iter().find(of) {
            for attribute in part.attributes().map(|attribute| attribute.name()) {
                if !known.contains(&attribute) {
                    let help = words::advice(attribute, known.iter().copied(), &[]).help;
                    self.unknown_attribute(attribute, element, owner, help);
                }
            }
        } else if let Some((_, known)) = AMONG_OTHERS.iter().find(of) {
            // an attribute that is present has not been misspelt
            let absent = || known.iter().copied().filter(|known| !part.has_attribute(*known));
            let own = part.attributes().filter(|attribute| attribute.namespace().is_none());
            for attribute in own.map(|attribute| attribute.name()) {
                let meant = words::advice(attribute, absent(), &[]).meant;
                if let (Some(meant), false) = (meant, known.contains(&attribute)) {
                    let help = format!("did you mean `{meant}`? otherwise remove it");
                    self.unknown_attribute(attribute, element, owner, help);
                }
            }
        }
    }

    fn unknown_attribute(&mut self, attribute: &str, element: &str, owner: &str, help: String) {
        let fact = format!("`{element}` of {owner} has an unknown attribute `{attribute}`");
        self.wrong(Code::FileElement, fact, help);
    }
}
