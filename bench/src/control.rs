//! A pass of iterative LQR over the motion of a robot arm, within the limits of its torques, compared with Crocoddyl.

use std::cell::RefCell;
use std::error::Error;
use std::hint::black_box;
use std::path::Path;
use std::time::Instant;

use nalgebra::{SMatrix, SVector};
use pendulum_core::control::{CostDerivatives, Ilqr, IlqrError, Objective, Quadratic};
use pendulum_core::inputs::Controlled;
use pendulum_core::prelude::*;
use pendulum_core::system::{Plant, PlantJacobian};
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

use crate::machine;
use crate::python::Server;
use crate::report::{list, number, table, write};
use crate::timing::Times;

mechanism! {
    /// Without the friction of its joints, which Crocoddyl's dynamics leave out.
    pub Panda {
        robot: urdf("../testbed/data/urdf/panda_with_hand.urdf"),
        gravity: [0, 0, -9.81],
        input u1: N m, input u2: N m, input u3: N m, input u4: N m, input u5: N m, input u6: N m, input u7: N m,
        body panda_link1 on panda_link0 { torque: u1, friction: 0 }
        body panda_link2 on panda_link1 { torque: u2, friction: 0 }
        body panda_link3 on panda_link2 { torque: u3, friction: 0 }
        body panda_link4 on panda_link3 { torque: u4, friction: 0 }
        body panda_link5 on panda_link4 { torque: u5, friction: 0 }
        body panda_link6 on panda_link5 { torque: u6, friction: 0 }
        body panda_link7 on panda_link6 { torque: u7, friction: 0 }
        body panda_leftfinger on panda_hand { joint: fixed }
        body panda_rightfinger on panda_hand { joint: fixed }
        generate: [rhs, jacobian, inverse_dynamics],
    }
}

const JOINTS: usize = 7;
const STATES: usize = 2 * JOINTS;
const NODES: usize = 30;
/// Length of a step in s.
const STEP: f64 = 0.02;
/// Angles of the joints at the start; those of the goal are 0.8 times as large.
const START: [f64; JOINTS] = [0.3, -0.8, 0.2, -2.0, 0.1, 1.6, 0.8];
/// Change of each component of the state before the timed pass.
const MOVED: f64 = 1e-3;
/// Weights of the angles and of the rates, along the motion and at its end.
const WEIGHTS: [f64; 2] = [100.0, 0.1];
/// Weight of the deviation from the torques that hold the start.
const OF_INPUTS: f64 = 1e-4;
/// Largest difference of costs that should be equal, relative to the cost.
const AGREE: f64 = 1e-6;
/// Number of rounds, and of timed passes of each entrant in a round.
const ROUNDS: usize = 60;
const PASSES: usize = 20;

type State = SVector<f64, STATES>;
type Torques = [f64; JOINTS];

/// Motion from `start` to `goal`.
struct Task {
    model: Panda,
    start: State,
    moved: State,
    goal: State,
    hold: Torques,
    weights: State,
}

/// First answer of `crocoddyl_peer.py`.
#[derive(Deserialize)]
struct Head {
    versions: Vec<String>,
    entrants: Vec<Searched>,
}

/// Search of an entrant, and its pass from the state that has moved.
#[derive(Deserialize, Serialize)]
struct Searched {
    name: String,
    /// Cost of the motion that was found, and number of iterations.
    solved: f64,
    iterations: usize,
    /// Costs of the motion before and after the pass.
    before: f64,
    after: f64,
    /// Share of the change of the inputs that was taken.
    share: f64,
}

/// Takes passes; returns the nanoseconds of each.
type Passes<'a> = Box<dyn Fn(usize) -> Result<Vec<f64>, Box<dyn Error>> + 'a>;

pub(crate) fn measure() -> Result<(), Box<dyn Error>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let task = Task::new()?;
    let server = RefCell::new(Server::start(root, "control/crocoddyl_peer.py")?);
    let answer = server.borrow_mut().ask(&task.described(root));
    let install = "`.venv/bin/pip install crocoddyl==3.2.1 pin==4.0.0`, or set PYTHON";
    let answer = answer.map_err(|why| format!("{why}; {install}"))?;
    let head: Head = serde_json::from_str(&answer)?;

    let mut entrants = vec![
        task.enter("ours", task.cost())?,
        task.enter("ours, cost at the middle of steps", AtMidpoint(&task))?,
    ];
    agree(&entrants[1].0, &head.entrants)?;
    for (n, searched) in head.entrants.into_iter().enumerate() {
        let server = &server;
        let run: Passes = Box::new(move |passes| {
            let answer = server.borrow_mut().ask(&json!([n, passes]))?;
            Ok(serde_json::from_str(&answer)?)
        });
        entrants.push((searched, run));
    }
    let times = time(&entrants)?;

    let mut header = machine::describe();
    header.extend(head.versions);
    let text = format!("{}\n{}", list(&header), rows(&entrants, &times));
    let raw = json!({
        "header": header,
        "entrants": entrants.iter().map(|(searched, _)| searched).collect::<Vec<_>>(),
        "nanoseconds": times,
    });
    println!("{text}");
    let out = root.join("out/control");
    println!("{}", write(out.join("control.md"), &text)?.display());
    println!("{}", write(out.join("control.json"), &raw.to_string())?.display());
    Ok(())
}

/// Checks that the peers which integrate the cost at the middle of the steps find the same motions.
fn agree(ours: &Searched, peers: &[Searched]) -> Result<(), String> {
    let costs = |searched: &Searched| [searched.solved, searched.after];
    for peer in peers.iter().filter(|peer| peer.name.contains("midpoint")) {
        for (own, other) in costs(ours).into_iter().zip(costs(peer)) {
            let agree = (own - other).abs() <= AGREE * own;
            if !agree {
                return Err(format!("{}: a cost of {other:e} instead of {own:e}", peer.name));
            }
        }
    }
    Ok(())
}

/// Times passes of all entrants in turns.
fn time(entrants: &[(Searched, Passes)]) -> Result<Vec<Times>, Box<dyn Error>> {
    let mut times = vec![Vec::new(); entrants.len()];
    for round in 0..ROUNDS {
        for n in 0..entrants.len() {
            let n = (n + round) % entrants.len();
            let (_, run) = &entrants[n];
            // the first pass fills the caches
            times[n].extend(run(1 + PASSES)?.split_off(1));
        }
    }
    Ok(times.into_iter().map(Times::from).collect())
}

fn rows(entrants: &[(Searched, Passes)], times: &[Times]) -> String {
    let row = |((searched, _), own): (&(Searched, Passes), &Times)| {
        vec![
            searched.name.clone(),
            number(Some(1e-6 * own.least())),
            number(Some(1e-6 * own.median())),
            number(Some(own.over_in_least(&times[0]))),
            format!("{:.9}", searched.solved),
            searched.iterations.to_string(),
            format!("{:.9}", searched.before),
            format!("{:.9}", searched.after),
        ]
    };
    let head = [
        "a pass",
        "least ms",
        "median ms",
        "over ours",
        "least cost",
        "iterations",
        "cost before",
        "cost after",
    ];
    table(&head, 1, &entrants.iter().zip(times).map(row).collect::<Vec<_>>())
}

impl Task {
    fn new() -> Result<Self, Box<dyn Error>> {
        let model = Panda::new(PandaParams {})?;
        let start = State::from_fn(|n, _| START.get(n).copied().unwrap_or_default());
        let hold = model.inverse_dynamics(0.0, &start, &SVector::zeros());
        Ok(Self {
            model,
            start,
            moved: start.add_scalar(MOVED),
            goal: 0.8 * start,
            hold: hold.into(),
            weights: State::from_fn(|n, _| WEIGHTS[n / JOINTS]),
        })
    }

    /// Arguments of `crocoddyl_peer.py`.
    fn described(&self, root: &Path) -> Value {
        json!({
            "urdf": root.join("../testbed/data/urdf/panda_with_hand.urdf"), "step": STEP, "nodes": NODES,
            "start": self.start.as_slice(), "moved": self.moved.as_slice(), "goal": self.goal.as_slice(),
            "hold": self.hold, "weights": self.weights.as_slice(), "of_inputs": OF_INPUTS,
        })
    }

    fn cost(&self) -> Quadratic<f64, STATES, JOINTS> {
        Quadratic::diagonal(self.weights.into(), [OF_INPUTS; JOINTS])
            .end(SMatrix::from_diagonal(&self.weights))
            .goal(self.goal, self.hold)
    }

    /// Searches for the motion of least cost, and takes a pass from the state that has moved.
    fn enter<'a, C>(&'a self, name: &str, cost: C) -> Result<(Searched, Passes<'a>), IlqrError>
    where
        C: Objective<f64, STATES, JOINTS> + Copy + 'a,
    {
        let limits = Panda::EFFORT_LIMITS;
        let mut ilqr = Ilqr::<_, _, STATES, JOINTS, NODES>::new(STEP, cost)
            .limits(limits.map(|limit| -limit), limits)
            .start(self.hold)
            .tolerance(1e-13);
        let solved = ilqr.solve(&self.model, 0.0, self.start)?;
        let pass = { ilqr }.pass(&self.model, 0.0, self.moved)?;
        let searched = Searched {
            name: name.to_owned(),
            solved: solved.cost,
            iterations: solved.iterations,
            before: pass.cost_before,
            after: pass.cost,
            share: pass.share,
        };
        let run = move |passes| {
            let one = |_| {
                let mut ilqr = black_box(ilqr);
                let since = Instant::now();
                ilqr.pass(&self.model, 0.0, self.moved)?;
                Ok(1e9 * since.elapsed().as_secs_f64())
            };
            (0..passes).map(one).collect()
        };
        Ok((searched, Box::new(run)))
    }
}

/// The cost in the middle of each step, as Crocoddyl's midpoint rule integrates it, with the second derivatives of
/// Gauss and Newton. It evaluates the model once more than a pass needs.
#[derive(Clone, Copy)]
struct AtMidpoint<'a>(&'a Task);

impl Objective<f64, STATES, JOINTS> for AtMidpoint<'_> {
    fn running(&self, t: f64, x: &State, u: &Torques) -> f64 {
        let middle = x + 0.5 * STEP * self.0.model.eval(t, x, &(*u).into());
        self.0.cost().running(t, &middle, u)
    }

    fn running_derivatives(&self, t: f64, x: &State, u: &Torques) -> CostDerivatives<f64, STATES, JOINTS> {
        let (model, inputs) = (&self.0.model, (*u).into());
        let (rates, by_state) = model.eval_with_jacobian(t, x, &inputs);
        let middle = x + 0.5 * STEP * rates;
        let to_state = SMatrix::<f64, STATES, STATES>::identity() + 0.5 * STEP * by_state;
        let to_inputs = 0.5 * STEP * model.input_jacobian(t, x, &inputs);
        let there = self.0.cost().running_derivatives(t, &middle, u);
        CostDerivatives {
            x: to_state.tr_mul(&there.x),
            u: there.u + to_inputs.tr_mul(&there.x),
            xx: to_state.tr_mul(&(there.xx * to_state)),
            xu: to_state.tr_mul(&(there.xx * to_inputs)),
            uu: there.uu + to_inputs.tr_mul(&(there.xx * to_inputs)),
        }
    }

    fn end(&self, t: f64, x: &State) -> f64 {
        Objective::end(&self.0.cost(), t, x)
    }

    fn end_derivatives(&self, t: f64, x: &State) -> (State, SMatrix<f64, STATES, STATES>) {
        self.0.cost().end_derivatives(t, x)
    }
}
