//! heyoka and SciPy, in a Python that answers requests.

use std::cell::RefCell;
use std::error::Error;
use std::path::Path;
use std::rc::Rc;

use serde::Deserialize;
use serde_json::{Value, json};
use twelve::{End, Flops, Problem, Request};

use super::emitted::Emitted;
use super::entrant::{Entrant, Run};
use crate::python::Server;

/// First line of the output of `peers.py`.
#[derive(Deserialize)]
struct Head {
    versions: Vec<(String, String)>,
    missing: Vec<String>,
    /// Libraries and methods of each problem.
    entrants: Vec<Vec<(String, String)>>,
}

/// Answer to a request.
#[derive(Default, Deserialize)]
struct Answer {
    error: Option<String>,
    #[serde(default)]
    t: f64,
    #[serde(default)]
    x: Vec<f64>,
    evaluations: Option<usize>,
    #[serde(default)]
    jacobians: usize,
    /// Of heyoka, which has expressions of its own.
    operations: Option<f64>,
    #[serde(default)]
    along: Vec<Vec<f64>>,
    #[serde(default)]
    nanoseconds: f64,
}

/// Libraries in Python.
const LIBRARIES: [&str; 2] = ["heyoka", "SciPy"];

/// Adds the methods of the installed libraries to the entrants of each problem.
pub(crate) fn enter(
    root: &Path,
    problems: &[Problem],
    emitted: &[Emitted],
    entrants: &mut [Vec<Entrant>],
    [header, notes]: [&mut Vec<String>; 2],
) -> Result<(), Box<dyn Error>> {
    let tasks: Vec<Value> = problems
        .iter()
        .zip(emitted)
        .map(|(problem, emitted)| {
            let parameters: serde_json::Map<String, Value> = emitted
                .parameters
                .iter()
                .map(|&(name, value)| (name.to_owned(), value.into()))
                .collect();
            json!({
                "name": problem.name, "is_stiff": problem.is_stiff, "x0": problem.x0, "t1": problem.t1,
                "absolute": problem.absolute,
                "tape": emitted.tape, "library": emitted.library, "parameters": parameters,
            })
        })
        .collect();
    let started = Server::start(root, "twelve/peers/peers.py").and_then(|mut server| {
        let head: Head = serde_json::from_str(&server.ask(&Value::from(tasks))?)?;
        Ok((server, head))
    });
    let (server, head) = match started {
        Ok(started) => started,
        Err(why) => {
            notes.push(format!("{}: {why}; {HOW}", LIBRARIES.join(" and ")));
            return Ok(());
        }
    };
    header.extend(head.versions.iter().map(|(name, version)| format!("{name} {version}")));
    notes.extend(head.missing.iter().map(|why| format!("{why}; {HOW}")));
    let server = Rc::new(RefCell::new(server));
    for (problem, (names, entrants)) in head.entrants.into_iter().zip(entrants).enumerate() {
        for (entrant, (by, method)) in names.into_iter().enumerate() {
            let server = Rc::clone(&server);
            let by = LIBRARIES
                .into_iter()
                .find(|library| *library == by)
                .ok_or("an unknown library")?;
            let flops = (by == "SciPy").then_some(problems[problem].flops);
            let run = move |request| server.borrow_mut().run([problem, entrant], request, flops);
            entrants.push(Entrant {
                by,
                // kept to the end of the program
                method: method.leak(),
                run: Box::new(run),
            });
        }
    }
    Ok(())
}

const HOW: &str = "`.venv/bin/pip install heyoka scipy numba`, or set PYTHON";

impl Server {
    /// `flops` are those of the emitted C, if it is called.
    fn run(&mut self, [problem, entrant]: [usize; 2], request: Request, flops: Option<Flops>) -> Run {
        let Request {
            tolerance,
            times,
            outputs,
        } = request;
        let answer = self.ask(&json!([problem, entrant, tolerance, times, outputs]));
        let answer = answer.and_then(|answer| Ok(serde_json::from_str(&answer)?));
        let answer = answer.unwrap_or_else(|why| Answer {
            error: Some(why.to_string()),
            ..Answer::default()
        });
        let Answer {
            t,
            x,
            evaluations,
            jacobians,
            operations,
            along,
            ..
        } = answer;
        let calls = || flops.map(|flops| flops.of(evaluations.unwrap_or(0), jacobians));
        Run {
            end: match answer.error {
                Some(why) => Err(why),
                None => Ok(End {
                    t,
                    x,
                    evaluations,
                    operations: operations.or_else(calls),
                    along,
                }),
            },
            nanoseconds: answer.nanoseconds,
        }
    }
}
