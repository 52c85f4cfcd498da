//! Parents before children.

use std::collections::BTreeMap;

use super::Lower;
use crate::ast;
use crate::error::suggestion;

impl Lower<'_> {
    /// The bodies, each behind its parent. Bodies that hang on nothing, or on each other, are reported and left out.
    pub(super) fn order(&mut self, bodies: &[ast::Body]) -> Vec<usize> {
        let mut index = BTreeMap::new();
        for (n, body) in bodies.iter().enumerate() {
            let name = body.name.to_string();
            if name == "ground" {
                self.errors
                    .at(body.name.span(), "`ground` is there already", "choose another name");
            } else if index.insert(name, n).is_some() {
                self.errors.at(
                    body.name.span(),
                    format_args!("body `{}` is declared twice", body.name),
                    "rename one of the two",
                );
            }
        }
        let mut order: Vec<usize> = Vec::new();
        let mut waiting: Vec<usize> = (0..bodies.len()).collect();
        loop {
            let ready = |n: &usize| {
                let parent = bodies[*n].parent.to_string();
                parent == "ground" || index.get(&parent).is_some_and(|p| order.contains(p))
            };
            let (now, later): (Vec<usize>, Vec<usize>) = waiting.iter().partition(|n| ready(n));
            if now.is_empty() {
                break;
            }
            order.extend(now);
            waiting = later;
        }
        for n in waiting {
            let parent = &bodies[n].parent;
            let text = parent.to_string();
            if !index.contains_key(&text) {
                let known = bodies
                    .iter()
                    .map(|b| b.name.to_string())
                    .filter(|name| bodies[n].name != name)
                    .chain(["ground".to_owned()])
                    .collect::<Vec<_>>();
                self.errors.at(
                    parent.span(),
                    format_args!("no body named `{parent}`"),
                    suggestion(&text, known.iter().map(String::as_str)),
                );
            } else if self.hangs_on_itself(bodies, &index, n) {
                self.errors.at(
                    parent.span(),
                    format_args!("`{}` hangs on itself", bodies[n].name),
                    "follow the parents: each chain must end on `ground`",
                );
            }
        }
        order
    }

    fn hangs_on_itself(&self, bodies: &[ast::Body], index: &BTreeMap<String, usize>, start: usize) -> bool {
        let parent = |n: usize| index.get(&bodies[n].parent.to_string()).copied();
        let mut at = parent(start);
        for _ in 0..bodies.len() {
            if at == Some(start) {
                return true;
            }
            at = at.and_then(parent);
        }
        false
    }
}
