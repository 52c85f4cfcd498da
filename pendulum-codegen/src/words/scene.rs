//! Words of declarations.

use super::Synonyms;

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
