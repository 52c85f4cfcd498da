//! Order of the bodies: parents before children.

use std::collections::BTreeMap;

use super::Lower;
use crate::ast;
use crate::error::{Code, Reported};

/// Index of a declared body, and of its parent; none for ground.
pub(super) type Hung = (usize, Result<Option<usize>, Reported>);

impl Lower<'_> {
    /// Sorts the bodies so that each comes after its parent. Reports unknown parents and circles.
    pub(super) fn order(&mut self, bodies: &[ast::Body]) -> Vec<Hung> {
        let index = self.body_names(bodies);
        let parents: Vec<_> = bodies.iter().map(|body| self.parent(body, bodies, &index)).collect();
        let mut order: Vec<Hung> = Vec::new();
        let mut known = vec![false; bodies.len()];
        let mut waiting: Vec<usize> = (0..bodies.len()).collect();
        loop {
            let ready = |n: &usize| match parents[*n] {
                Ok(Some(parent)) => known[parent],
                Ok(None) | Err(_) => true,
            };
            let (now, later): (Vec<usize>, Vec<usize>) = waiting.iter().partition(|n| ready(n));
            if now.is_empty() {
                break;
            }
            now.iter().for_each(|&n| known[n] = true);
            order.extend(now.into_iter().map(|n| (n, parents[n])));
            waiting = later;
        }
        let mut circle = None;
        for &n in &waiting {
            if let (true, Ok(parent)) = (hangs_on_itself(&parents, n), &bodies[n].parent) {
                let fact = format_args!("the parents of `{}` form a cycle", bodies[n].name);
                let help = "each chain of parents must end at `ground`";
                circle = Some(self.errors.at(Code::Circle, parent.span(), fact, help));
            }
        }
        order.extend(
            circle
                .into_iter()
                .flat_map(|reported| waiting.iter().map(move |&n| (n, Err(reported)))),
        );
        order
    }

    fn body_names(&mut self, bodies: &[ast::Body]) -> BTreeMap<String, usize> {
        let mut index = BTreeMap::new();
        for (n, body) in bodies.iter().enumerate() {
            let (name, span) = (body.name.to_string(), body.name.span());
            if name == "ground" {
                let fact = "`ground` is reserved for the body that does not move";
                self.errors.at(Code::NameTaken, span, fact, "choose another name");
            } else if index.insert(name, n).is_some() {
                let fact = format_args!("body `{}` is declared twice", body.name);
                self.errors.at(Code::NameTaken, span, fact, "rename one of the two");
            }
        }
        index
    }

    fn parent(
        &mut self,
        body: &ast::Body,
        bodies: &[ast::Body],
        index: &BTreeMap<String, usize>,
    ) -> Result<Option<usize>, Reported> {
        let parent = self.read(&body.parent)?;
        if parent == "ground" {
            return Ok(None);
        }
        if let Some(&n) = index.get(&parent.to_string()) {
            return Ok(Some(n));
        }
        let others = bodies
            .iter()
            .map(|b| b.name.to_string())
            .filter(|name| body.name != name);
        let mut known: Vec<String> = Vec::new();
        for name in others.chain(["ground".to_owned()]) {
            // a body declared twice is listed once
            if !known.contains(&name) {
                known.push(name);
            }
        }
        let fact = format_args!("no body named `{parent}`");
        Err(self
            .errors
            .unknown(Code::UnknownName, parent, fact, known.iter().map(String::as_str), &[]))
    }
}

fn hangs_on_itself(parents: &[Result<Option<usize>, Reported>], start: usize) -> bool {
    let parent = |n: usize| parents[n].ok().flatten();
    let mut at = parent(start);
    for _ in 0..parents.len() {
        if at == Some(start) {
            return true;
        }
        at = at.and_then(parent);
    }
    false
}
