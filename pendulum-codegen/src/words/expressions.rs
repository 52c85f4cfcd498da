//! Words of expressions.

use super::Synonyms;

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
