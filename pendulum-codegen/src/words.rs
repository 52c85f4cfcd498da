//! Suggestions for unknown words: misspelt words of the language, and words of other tools.

/// Synonyms, in lower case and without underscores, with the word of the language for them, or a help text if there is
/// none.
pub(crate) type Synonyms = [(&'static [&'static str], &'static str)];

/// Advice on an unknown word.
#[derive(Debug)]
pub(crate) struct Advice<'a> {
    /// The known word that is probably meant.
    pub meant: Option<&'a str>,
    /// Help text.
    pub help: String,
}

/// Returns advice on an unknown word in a place where the `known` ones are allowed.
pub(crate) fn advice<'a>(
    word: &str,
    known: impl IntoIterator<Item = &'a str>,
    synonyms: &'static Synonyms,
) -> Advice<'a> {
    let known: Vec<&str> = known.into_iter().collect();
    let synonym = synonym(word, synonyms);
    let named = synonym.and_then(|meaning| known.iter().copied().find(|known| *known == meaning));
    if let (Some(instead), None) = (synonym, named) {
        let help = instead.to_owned();
        return Advice { meant: None, help };
    }
    let meant = named.or_else(|| nearest(&plain(word), &known));
    let list = known.join(", ");
    let help = match meant {
        Some(meant) if known.len() == 1 => format!("did you mean `{meant}`?"),
        Some(meant) => format!("did you mean `{meant}`? known here: {list}"),
        None if known.is_empty() => "nothing suitable is declared".to_owned(),
        None => format!("known here: {list}"),
    };
    Advice { meant, help }
}

/// Looks up a word in a table. Returns a word of the language, or a sentence.
pub(crate) fn synonym(word: &str, synonyms: &'static Synonyms) -> Option<&'static str> {
    let plain = plain(word);
    let row = synonyms.iter().find(|(words, _)| words.contains(&plain.as_str()));
    row.map(|(_, meaning)| *meaning)
}

fn nearest<'a>(word: &str, known: &[&'a str]) -> Option<&'a str> {
    let distances = known.iter().map(|candidate| {
        let candidate_plain = plain(candidate);
        let close = (candidate_plain.len().min(word.len()) + 1) / 3;
        (strsim::damerau_levenshtein(word, &candidate_plain), close, *candidate)
    });
    let near = distances.filter(|(distance, close, _)| distance <= close);
    near.map(|(distance, _, candidate)| (distance, candidate))
        .min()
        .map(|(_, candidate)| candidate)
}

/// Removes differences in style: `Center_Of_Mass` becomes `centerofmass`.
fn plain(word: &str) -> String {
    word.to_lowercase().replace('_', "")
}

/// Items of a scene.
pub(crate) const ITEMS: &Synonyms = &[
    (
        &["param", "parameters", "parameter", "constants", "constant", "consts"],
        "params",
    ),
    (&["link", "links", "rigidbody", "bodies", "part", "segment"], "body"),
    (&["control", "controls", "actuator", "inputs"], "input"),
    (&["mesh", "geometry", "solid", "shapes"], "shape"),
    (
        &["options", "emit", "functions", "routines"],
        "list the routines to generate: `generate: [rhs, jacobian, energy],`",
    ),
    (
        &[
            "outputs",
            "observable",
            "sensor",
            "sensors",
            "measure",
            "measurement",
            "observe",
            "y",
        ],
        "output",
    ),
    (&["events", "zero", "crossing", "trigger", "guard"], "event"),
    (&["points", "site", "marker", "frame", "anchor", "location"], "point"),
    (&["forces", "push", "load", "thrust", "wrench"], "force"),
    (&["springs", "elastic"], "spring"),
    (&["dampers", "dashpot"], "damper"),
    (
        &["walls", "floor", "contact", "obstacle", "barrier", "collision"],
        "wall",
    ),
    (&["potentials", "potentialenergy", "energy"], "potential"),
    (
        &[
            "loop",
            "closure",
            "loopclosure",
            "closes",
            "constraint",
            "connect",
            "connection",
            "tie",
            "weld",
        ],
        "close",
    ),
    (&["rayleigh", "loss", "losses"], "dissipation"),
    (
        &["torque", "moment"],
        "write `torque: e` in the braces of a body, or `force theta: e` for a force along a coordinate; \
         a moment `m` about the x axis of a body with the orientation `o` is `dissipation: -m*dot(o).x,`",
    ),
    (
        &["drive", "driver", "prescribed", "motor"],
        "drive a joint by `motion: e(t)` in the braces of its body, instead of a coordinate",
    ),
    (
        &["urdf", "file", "import", "include"],
        "write `robot: urdf(\"robot.urdf\"),`",
    ),
    (&["g"], "gravity"),
    (
        &["def", "define", "var", "const", "set"],
        "name an expression by `let name = expression,`",
    ),
    (&["initial", "initialstate", "x0", "start"], START),
    (
        &["states", "ode", "equation", "variable", "integral", "filter"],
        "state",
    ),
    (
        &["solver", "method", "integrator", "time", "tspan"],
        "a scene declares the mechanism only; the method and the time span are arguments of `solve`",
    ),
];

const START: &str = "the initial condition is an argument of `solve`, not a part of the scene: `solve(&model, t0, \
                     t1, x0)`";

/// Fields of bodies and shapes.
pub(crate) const FIELDS: &Synonyms = &[
    (&["damping", "damper", "viscous", "viscosity", "drag"], "friction"),
    (
        &[
            "force", "forces", "effort", "motor", "actuator", "moment", "drive", "control", "tau", "load",
        ],
        "torque",
    ),
    (&["stiffness", "elasticity", "k"], "write `spring: (stiffness, rest)`"),
    (
        &[
            "angle",
            "dof",
            "variable",
            "generalized",
            "generalizedcoordinate",
            "coord",
            "q",
            "state",
            "coordinates",
        ],
        "coordinate",
    ),
    (
        &[
            "centerofmass",
            "centreofmass",
            "cog",
            "cm",
            "centre",
            "center",
            "centroid",
            "barycenter",
        ],
        "com",
    ),
    (
        &[
            "moi",
            "momentofinertia",
            "moments",
            "i",
            "j",
            "rotationalinertia",
            "tensor",
        ],
        "inertia",
    ),
    (&["weight", "m"], "mass"),
    (&["solid", "geometry", "parts", "volumes", "collision"], "solids"),
    (&["hinge", "pivot", "connection"], "joint"),
    (&["quaternion", "attitude", "quat"], "orientation"),
    (&["prescribed", "driven", "trajectory", "law", "path"], "motion"),
    (
        &["axis", "direction"],
        "the axis belongs to the joint: write `joint: revolute(z)`",
    ),
    (
        &[
            "at",
            "position",
            "origin",
            "offset",
            "location",
            "anchor",
            "translation",
            "xyz",
        ],
        "the position belongs to the joint: write `joint: revolute(z) at [x, y, z]`",
    ),
    (
        &["rpy", "orientation", "rotation"],
        "the angles belong to the joint: write `joint: revolute(z) rpy [roll, pitch, yaw]`, in rad",
    ),
    (
        &["parent", "on", "base"],
        "the parent comes before the braces: write `body name on parent { .. }`",
    ),
    (
        &["shape"],
        "the shape comes before the braces: write `body name on parent: shape { .. }`",
    ),
    (
        &["length", "size", "radius", "width", "height"],
        "a body has mass, com and inertia, or solids: write `solids: [rod(m, [0, 0, 0], [0, -l, 0])]`",
    ),
    (
        &["coulomb", "coulombfriction", "frictionloss", "slidingfriction"],
        "dry_friction",
    ),
    (&["stiction", "breakaway", "staticfriction"], "static_friction"),
    (&["limits", "limit", "stops", "range", "bounds", "endstop"], "stop"),
    (&["min", "max"], "write both limits: `stop: [low, high]`"),
    (
        &["restitution", "bounce"],
        "it comes after the limits: write `stop: [low, high] restitution(0.5)`",
    ),
    (&["initial", "initialangle", "x0", "theta0", "velocity"], START),
    (&["density"], "give the mass of each solid; its density is uniform"),
    (
        &["name"],
        "the name comes before the braces: write `body name on parent { .. }`",
    ),
    (
        &["visual", "color", "mesh"],
        "leave it out: a body has mass properties and a joint, not an appearance",
    ),
];

/// Fields of first-order states.
pub(crate) const STATE: &Synonyms = &[
    (&["units", "dimension"], "unit"),
    (&["derivative", "dot", "der", "equation", "rhs", "ode"], "rate"),
    (&["init", "initial", "start", "x0", "value", "default"], START),
];

/// Fields of walls.
pub(crate) const WALL: &Synonyms = &[
    (&["distance", "height", "value", "function", "e"], "gap"),
    (&["bounce", "elasticity", "cor", "coefficient"], "restitution"),
    (&["threshold", "rest", "minrate"], "slow"),
    (
        &["friction", "dryfriction", "mu"],
        "walls have no friction: they push only along their gap",
    ),
];

/// Joints.
pub(crate) const JOINTS: &Synonyms = &[
    (
        &[
            "hinge",
            "pin",
            "rotary",
            "rotational",
            "rotation",
            "rev",
            "continuous",
            "pivot",
            "r",
        ],
        "revolute",
    ),
    (
        &[
            "slider",
            "slide",
            "sliding",
            "linear",
            "translation",
            "translational",
            "p",
        ],
        "prismatic",
    ),
    (&["weld", "welded", "rigid", "none", "static"], "fixed"),
    (&["helix"], "helical"),
    (
        &["planar"],
        "write a chain: a massless body with `joint: prismatic(x)`, on it another with `joint: prismatic(y)`, and \
         on that the body itself with `joint: revolute(z)`",
    ),
    (
        &["cylindrical", "cylinder"],
        "write a chain: a massless body with `joint: prismatic(z)`, and on it the body itself with `joint: \
         revolute(z)`",
    ),
    (
        &["universal", "cardan", "hooke", "u"],
        "write a chain: a massless body with `joint: revolute(x)`, and on it the body itself with `joint: \
         revolute(y)`",
    ),
    (
        &["gimbal", "euler"],
        "write a chain: a massless body with `joint: revolute(x)`, on it another with `joint: revolute(y)`, and on \
         that the body itself with `joint: revolute(z)`; or use `ball`, which turns about all axes",
    ),
    (
        &["gear", "gears", "rack", "rackandpinion", "pulley", "belt", "mimic"],
        "couple the joint to another by its motion: `joint: revolute(z), motion: 0.5*theta`",
    ),
    (
        &["distance", "rope", "cable", "link", "tether"],
        "a rod is a body with a hinge or ball joint at each end; a cable between two points is `spring between a \
         and b: (k, l)`",
    ),
    (
        &["spherical", "balljoint", "socket", "ballandsocket", "quaternion", "s"],
        "ball",
    ),
    (
        &["floating", "float", "freeflyer", "freejoint", "sixdof", "6dof"],
        "free",
    ),
];

/// Words after a joint.
pub(crate) const AFTER_JOINT: &Synonyms = &[
    (&["on", "position", "origin", "offset", "xyz", "from"], "at"),
    (&["rotation", "orientation", "angles", "turned", "rotated"], "rpy"),
];

/// Solids.
pub(crate) const SOLIDS: &Synonyms = &[
    (&["particle", "bob", "pointmass", "mass", "bead"], "point"),
    (&["bar", "stick", "beam", "line", "segment", "link"], "rod"),
    (&["disc", "wheel", "circle"], "disk"),
    (&["box", "cube", "block", "brick", "rectangle"], "cuboid"),
    (&["ball", "globe"], "sphere"),
    (&["polygon", "triangle", "sheet"], "plate"),
    (&["capsule", "tube", "pipe"], "cylinder"),
    (&["ring", "hoop", "shell"], "give its `mass`, `com` and `inertia`"),
];

/// Names in expressions.
pub(crate) const SYMBOLS: &Synonyms = &[
    (&["time"], "t"),
    (&["π", "pi"], "pi"),
    (&["tau", "twopi"], "write `2*pi`"),
    (&["fracpi2", "halfpi"], "write `pi/2`"),
    (&["fracpi3"], "write `pi/3`"),
    (&["fracpi4"], "write `pi/4`"),
    (&["fracpi6"], "write `pi/6`"),
    (&["euler"], "write `exp(1)`"),
    (
        &["inf", "infinity"],
        "numbers are finite: write a one-sided stop as a wall, `wall name { gap: s - low }`, and a one-sided \
         `clamp` with a limit that is never reached, such as 1e9",
    ),
    (
        &["q"],
        "`q` is a joint's own coordinate in its `torque`; elsewhere write its name",
    ),
    (
        &["qd"],
        "`qd` is a joint's own rate in its `torque`; elsewhere write `dot(..)` of its coordinate",
    ),
    (&["dot"], "write `dot(theta)` for the rate of `theta`"),
    (&["ground"], "`ground` is a body, not a number"),
];

/// Functions.
pub(crate) const FUNCTIONS: &Synonyms = &[
    (
        &["sign", "signum", "sgn"],
        "it is discontinuous at 0: for dry friction of a joint write `dry_friction: mu`; elsewhere write \
         `tanh(x/eps)`, which is smooth, with a small width eps",
    ),
    (
        &["step", "heaviside", "theta"],
        "it is discontinuous at 0: write `(1 + tanh(x/eps))/2`, which is smooth",
    ),
    (&["sinh"], "write `(exp(x) - exp(-x))/2`"),
    (&["cosh"], "write `(exp(x) + exp(-x))/2`"),
    (&["asin", "arcsin"], "write `atan2(x, sqrt(1 - x^2))`"),
    (&["acos", "arccos"], "write `atan2(sqrt(1 - x^2), x)`"),
    (&["atan", "arctan"], "write `atan2(x, 1)`"),
    (&["arctan2"], "atan2"),
    (&["cot"], "write `1/tan(x)`"),
    (&["sec"], "write `1/cos(x)`"),
    (&["csc"], "write `1/sin(x)`"),
    (&["log", "loge"], "write `ln(x)` for the natural logarithm"),
    (&["log10"], "write `ln(x)/ln(10)`"),
    (&["log2"], "write `ln(x)/ln(2)`"),
    (&["pow", "powi", "powf", "power"], "write `x^n`"),
    (&["sq", "sqr", "square"], "write `x^2`"),
    (&["cbrt"], "write `x^(1/3)`"),
    (&["recip"], "write `1/x`"),
    (&["hypot", "norm", "length"], "write `sqrt(x^2 + y^2)`"),
    (&["fabs"], "abs"),
    (&["max"], "write `(a + b + abs(a - b))/2`"),
    (&["min"], "write `(a + b - abs(a - b))/2`"),
    (&["saturate", "saturation", "sat", "limit", "limiter", "bound"], "clamp"),
    (
        &["floor", "ceil", "round", "mod", "rem", "fract"],
        "it is discontinuous, and only continuous functions are supported",
    ),
    (
        &["rad", "radians", "toradians", "deg2rad", "deg", "degrees"],
        "angles are in rad: write `x*pi/180` for x in degrees",
    ),
    (&["der", "diff", "ddt", "d", "derivative", "rate"], "dot"),
    (&["dist", "range", "separation"], "distance"),
    (
        &["rotation", "orientation", "attitude"],
        "a rotation is a matrix: write it alone, as in `output r: rotation(arm),`",
    ),
    (
        &["ddot"],
        "accelerations cannot be used: they follow from the equations of motion",
    ),
    (
        &["if", "ifelse", "where", "piecewise", "select"],
        "use a smooth law: `(1 + tanh(x/eps))/2` is a step at x = 0",
    ),
];

/// Words of `generate`.
pub(crate) const ROUTINES: &Synonyms = &[
    (
        &["dynamics", "forwarddynamics", "ode", "f", "derivative", "equations"],
        "rhs",
    ),
    (&["kinetic", "potential"], "energy"),
    (&["mass", "m", "inertia"], "mass_matrix"),
    (&["coriolis", "gravity", "nonlinear"], "bias"),
    (&["hamiltonian", "hamilton"], "canonical"),
    (&["linear", "linearize", "linearization", "df"], "jacobian"),
    (&["rnea", "inversedynamic", "computedtorque"], "inverse_dynamics"),
    (&["sensitivity", "sensitivities"], "parameter_jacobian"),
    (
        &["gradient", "vjp", "reverse", "backward", "pullback", "costate"],
        "adjoint",
    ),
    (
        &["hessian", "hvp", "second", "secondderivative", "secondderivatives"],
        "hessian_product",
    ),
    (&["series"], "taylor"),
    (&["draw", "drawing", "picture", "shape", "geometry", "visual"], "shapes"),
    (
        &["outputs", "output", "points"],
        "outputs are always generated: write `output name: e,`",
    ),
    (
        &["events", "event"],
        "events are always generated: write `event name: e,`",
    ),
    (&["motor", "drive", "drives", "driveforce"], "drive_forces"),
    (
        &[
            "loopforces",
            "loopforce",
            "reaction",
            "reactions",
            "constraintforces",
            "multipliers",
            "wrenches",
        ],
        "loop_wrenches",
    ),
];
