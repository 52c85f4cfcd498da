//! Requests and answers. The page knows them by these names.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

/// Requests of the page.
#[derive(Debug, Deserialize)]
#[serde(tag = "do", rename_all = "snake_case", deny_unknown_fields)]
pub enum Request {
    /// Compile a declaration, for integration by this method.
    Declare {
        /// Text of the declaration.
        text: String,
        /// Files of robots by their names.
        #[serde(default)]
        files: BTreeMap<String, String>,
        /// Name of the method.
        method: String,
    },
    /// Change the values of all parameters and inputs.
    Set {
        /// Values of the parameters.
        values: Vec<f64>,
        /// Values of the inputs.
        inputs: Vec<f64>,
    },
    /// Shapes, energy and state at a time.
    Look {
        /// Time in s.
        t: f64,
        /// State; close the loops near it.
        x: Vec<f64>,
    },
    /// Integrate.
    Move {
        /// Method and its settings.
        by: Settings,
        /// Start and end in s.
        span: [f64; 2],
        /// State at the start.
        x: Vec<f64>,
        /// Number of frames, equally spaced in time, the last at the end.
        frames: usize,
        /// Where the motion passes a section, if the page asks for that.
        #[serde(default)]
        section: Option<Section>,
    },
    /// A state near another: the first coordinate differs, or the orientation about its first axis.
    Near {
        /// Time in s.
        t: f64,
        /// State.
        x: Vec<f64>,
        /// Difference in rad or m.
        by: f64,
    },
    /// Start many motions beside each other.
    Gather {
        /// Time in s.
        t: f64,
        /// State in their middle.
        x: Vec<f64>,
        /// Number of states.
        count: usize,
        /// Difference between the first and the last, as in `near`.
        spread: f64,
    },
    /// Integrate these by `Rk4`, in steps that are short enough.
    MoveAll {
        /// Start and end in s.
        span: [f64; 2],
        /// Number of frames.
        frames: usize,
    },
    /// Move a point of a shape towards a place, as far as joints, loops and stops allow.
    Drag {
        /// Time in s.
        t: f64,
        /// State before.
        x: Vec<f64>,
        /// Number of the shape.
        shape: usize,
        /// Number of its point.
        point: usize,
        /// Place on the screen, in m.
        to: [f64; 2],
        /// Directions of the screen in space: to the right, and up.
        view: [[f64; 3]; 2],
    },
    /// Equations of the mechanism, and what its functions cost: all that its motion does not need.
    Describe,
    /// Print generated code.
    Code {
        /// `rust` or `c`.
        language: String,
    },
}

/// A Poincare section: a component of the state rises through a value; an angle, up to whole turns.
#[derive(Clone, Copy, Debug, Deserialize)]
pub struct Section {
    /// Index of the component.
    pub component: usize,
    /// Value.
    pub value: f64,
}

/// Method and its settings.
#[derive(Clone, Debug, Deserialize)]
pub struct Settings {
    /// Name of the method.
    pub method: String,
    /// Length of fixed steps in s.
    pub h: Option<f64>,
    /// Relative and absolute tolerance.
    pub tolerance: Option<f64>,
}

/// Answers to the page. Numbers, such as frames, accompany them.
#[derive(Debug, Serialize)]
#[serde(tag = "is", rename_all = "snake_case")]
pub enum Answer {
    /// A mechanism.
    Mechanism(Box<About>),
    /// Errors in the declaration.
    Problems {
        /// Errors, in the order of the text.
        problems: Vec<Place>,
    },
    /// Frames: see [`frames`](crate::frames).
    Frames(Moved),
    /// A state.
    State {
        /// State.
        x: Vec<f64>,
    },
    /// Equations of the mechanism, and its functions.
    Description {
        /// Equations of motion in LaTeX.
        latex: String,
        /// Functions and what they cost.
        functions: Vec<Function>,
    },
    /// Generated code.
    Code {
        /// Text.
        text: String,
    },
    /// The request was carried out.
    Done,
    /// The request could not be carried out.
    Refused {
        /// Why, and what to do.
        why: String,
    },
}

/// An error in the declaration.
#[derive(Debug, Serialize)]
pub struct Place {
    /// Line, starting at 1.
    pub line: usize,
    /// Column in characters, starting at 1.
    pub column: usize,
    /// Number of characters.
    pub width: usize,
    /// Code, such as `M002`.
    pub code: String,
    /// The mistake.
    pub message: String,
    /// The remedy.
    pub help: String,
}

/// A mechanism.
#[derive(Debug, Serialize)]
pub struct About {
    /// Name.
    pub name: String,
    /// Comment above the declaration.
    pub docs: String,
    /// Parameters.
    pub parameters: Vec<Quantity>,
    /// Inputs.
    pub inputs: Vec<Quantity>,
    /// Components of the state.
    pub components: Vec<Component>,
    /// Names of joints with dry friction or stops, and of walls.
    pub constraints: Vec<String>,
    /// Shapes to draw; a frame has the places of their points.
    pub shapes: Vec<Shape>,
    /// True if there is an energy.
    pub has_energy: bool,
    /// True if the method takes steps of a fixed length.
    pub has_fixed_steps: bool,
    /// State in which the page starts.
    pub start: Vec<f64>,
    /// Assumptions, and repairs of a robot.
    pub notes: Vec<String>,
}

/// A parameter or an input.
#[derive(Debug, Serialize)]
pub struct Quantity {
    /// Name.
    pub name: String,
    /// Unit.
    pub unit: String,
    /// Comment in the declaration.
    pub docs: String,
    /// Value.
    pub value: f64,
}

/// A component of the state.
#[derive(Debug, Serialize)]
pub struct Component {
    /// Name.
    pub name: String,
    /// Unit.
    pub unit: String,
    /// True if it is an angle with the period 2 pi.
    pub periodic: bool,
}

/// A function and what it costs.
#[derive(Debug, Serialize)]
pub struct Function {
    /// Name.
    pub name: String,
    /// Its result, in words.
    pub docs: String,
    /// Form of the code.
    pub form: String,
    /// Numbers of additions, multiplications, divisions, sines with cosines, and other functions.
    pub operations: [usize; 5],
}

/// A shape.
#[derive(Debug, Serialize)]
pub struct Shape {
    /// Kind.
    pub kind: String,
    /// Name of its body or point.
    pub name: String,
    /// Body to which it belongs.
    pub body: String,
    /// Number of its points.
    pub points: usize,
    /// True if a hand can move it, and its motion is drawn.
    pub moves: bool,
}

/// Facts about a motion, beside its frames.
#[derive(Debug, Default, Serialize)]
pub struct Moved {
    /// Number of numbers in a frame.
    pub width: usize,
    /// Last time and state.
    pub t: f64,
    /// Last state.
    pub x: Vec<f64>,
    /// Why it stopped early.
    pub stopped: Option<String>,
    /// Times at which constraints begin or end to hold, and which hold from then on.
    pub modes: Vec<(f64, String)>,
    /// Times and states on the section.
    pub passages: Vec<(f64, Vec<f64>)>,
    /// Reasons to doubt the motion.
    pub warnings: Vec<String>,
    /// Number of evaluations of the right-hand side.
    pub evaluations: usize,
    /// Number of accepted steps.
    pub steps: usize,
    /// Steps of many motions, and their error.
    pub accuracy: Option<Accuracy>,
}

/// Steps of many motions, and their error.
#[derive(Debug, Serialize)]
pub struct Accuracy {
    /// Length of the steps in s.
    pub h: f64,
    /// Largest error of a component over the span, relative where it is above 1, in three of the motions.
    pub error: f64,
}
