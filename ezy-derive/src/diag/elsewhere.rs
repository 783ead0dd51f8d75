//! Words, signs and functions of other languages and books, and what to write in place of them.
//!
//! What a word means elsewhere goes before what it is spelled like: `contact` is a stop, and no misspelled constraint.

/// Words with one meaning: in lower case, without `_`; and the help, an edit.
pub type Meaning = (&'static [&'static str], &'static str);

const STATES: &str = "write `state current: A = 0 rate (u - R*current)/L;` for a number with a rate of its own; the integral of a value is \
    `state way: m = 0 rate seat.vx;`";
/// What stands in place of `if`.
pub const CHOICES: &str = "write `smooth_step(x, from, to)`, `min`, `max` or `sign`, such as `max(x, 0)` for a force on one side; scenes choose \
    between laws by their effects, and `event` tells when a condition comes true";
const REACTIONS: &str = "reactions of constraints are results: runs record them, as `lambda.B.x`, and no law can read them; where a law needs \
    the force, write `spring P ~ Q: stiffness k, length l, damping c;` in place of the constraint, and its law again";
const ACCELERATIONS: &str = "accelerations are results: runs record them, as `seat.ax`, and no law can read them; what grows with an acceleration is \
    a mass or an inertia of a body, and `input u: m = 0 by acceleration;` is given by one";
const REMAINDER: &str = "write `T/2 + T*atan2(-sin(2*pi*x/T), -cos(2*pi*x/T))/(2*pi)` for the remainder of x by T, or a law of `sin(2*pi*x/T)`, \
    which does not jump";
const OF_A_RUN: &str = "a run has its method and steps, a model has none: `ezy run --method dop853 --rtol 1e-9`, `.method(Method::dop853(1e-9))`";
const NO_TEMPERATURES: &str =
    "units are made of m, kg, s, A and rad: write a temperature as a plain number, `param temperature = 293;`";
const ENERGIES: &str = "runs record energies, as `kinetic` and `potential`, and no law can read them; write the sum that is meant, such as \
    `m * norm(a.v)^2 / 2`";
const TABLES: &str = "tables belong to runs: declare `input height: m = 0;`, use `height` here, and give its values by `ezy run --inputs FILE.csv --method rk4 --step 1e-3`";
const ONE_SIDED: &str = "write `rod r: p ~ q length l;` for one that stays taut, `stop r: norm(Q.r) to l;` for one that may go slack, or \
    `spring p ~ q: stiffness k, length l, damping c;` for an elastic one";
const DISTANCES: &str = "write `rod r: p ~ q length l;` for two points at a distance";
const WHEELS: &str = "write `skate w: at P along a(1, 0);` for one that does not slip sideways, `roll w: at P along a(1, 0) = r * wheel.omega;` \
    for one that turns (a body that a hinge holds at its hub), `tyre at P along a(1, 0): stiffness c;` for one that slips";
const BELTS: &str = "write `gear g: a ~ b ratio 2;`: a.phi turns twice as much as b.phi, the other way with `ratio -2`";
const CONTACTS: &str =
    "write `stop c: seat.y from 0;`: the quantity does not go below 0; `restitution 0.5` lets it bounce";
const CURVES: &str = "write `constraint c: a.y = 0.1 * sin(a.x / (1 m));` for a point on a curve";
const PARTS: &str =
    "there are no parts to be used again; `for i in 0..n { … }` repeats items, and a model is one machine";

/// In place of items of models and effects.
pub const ITEMS: &[Meaning] = &[
    (&["der", "differential", "ode", "integrator"], STATES),
    (&["contact", "collision", "collide", "obstacle", "limit", "impact", "bumper", "unilateral"], CONTACTS),
    (&["wheel", "tire", "caster", "castor", "rolling"], WHEELS),
    (
        &["noslip", "knifeedge", "nonholonomic", "blade"],
        "write `skate w: at P along a(1, 0);`: P does not move across the x axis of `a`",
    ),
    (&["rope", "cable", "string", "wire", "chain", "tether", "cord"], ONE_SIDED),
    (&["distance", "strut", "pendulum"], DISTANCES),
    (&["belt", "pulley", "transmission", "gearbox", "gears", "ratio"], BELTS),
    (&["cam", "curve", "path", "track", "guide"], CURVES),
    (
        &["joint", "revolute", "pin", "pivot", "rotational", "bearing", "axle", "axis", "ball"],
        "write `hinge B: a(0, 0) ~ b(0, 0);`: both points coincide, and the bodies turn",
    ),
    (
        &["prismatic", "translational", "translation", "rail", "cylindrical", "piston"],
        "write `slider s: a(0, 0) ~ b(0, 0) along a(1, 0);`: b moves along the x axis of `a` and does not turn against it",
    ),
    (
        &["pinslot", "groove"],
        "write `slot s: a(0, 0) ~ b(0, 0) along a(1, 0);`: the point of b moves along the x axis of `a`, and b turns",
    ),
    (
        &["fix", "fixed", "rigid", "anchor", "clamp", "lock", "glue", "attach", "mount"],
        "write `weld w: ground(0, 0) ~ a(0, 0);` for a body that cannot move at all; a wheel that shall turn is held by a hinge at its hub: \
         `hinge hub: a(0, 0) ~ wheel(0, 0);`",
    ),
    (
        &["motor", "actuator", "servo", "engine"],
        "write `torque a ~ b: u;` for a motor whose torque is known, `drive m: B.angle = omega * t;` for one whose motion is known",
    ),
    (
        &["controller", "control", "feedback", "pid"],
        "write the law: `torque a ~ b: -k * B.angle - c * B.rate;`, or `input u: N*m = 0;` and a program that sets it",
    ),
    (&["moment", "couple"], "write `torque a ~ b: u;`, or `torque a: u;` for one from outside"),
    (&["load", "thrust", "push"], "write `force at P: (fx, fy);`, or `force at P along a(1, 0): f;`"),
    (&["dashpot", "shock", "absorber"], "write `damper P ~ Q: damping c;`"),
    (&["bushing", "elastic", "muscle", "band"], "write `spring P ~ Q: stiffness k, length l, damping c;`"),
    (&["rotaryspring", "torsionspring", "torsionalspring"], "write `torsion a ~ b: stiffness k, angle 0, damping c;`"),
    (&["table", "lookup", "data", "signal", "source", "file", "import"], TABLES),
    (&["const", "constant", "parameter", "parameters", "real", "float", "double"], "write `param a: m = 0.2;`"),
    (
        &["var", "variable", "def", "define", "set", "function", "fn", "expression", "auto"],
        "write `let v = norm(a.v);` for a value that is used again",
    ),
    (&["link", "solid", "frame", "particle", "pointmass", "mass", "inertia"], "write `body a { mass: 1, inertia: 1 }`"),
    (&["marker", "connector", "port", "site"], "write `point P = a(0.1, 0);`"),
    (&["if", "when", "while", "switch", "case", "elseif", "piecewise"], CHOICES),
    (
        &["equation", "equations", "eq", "algebraic", "require", "assert"],
        "write `constraint c: a.y = 0;` for positions, `velocity constraint c: a.vx = b.vx;` for velocities",
    ),
    (&["initial", "init", "initially", "ic", "state0"], "write `start begin { a at (0, 0) angle 0; at rest; }`"),
    (
        &["until", "end", "duration", "simulate", "run", "simulation", "time"],
        "write `scene run { start begin; until 10 s; }`",
    ),
    (&["solver", "method", "integrate", "step", "timestep", "dt", "tolerance", "option", "options"], OF_A_RUN),
    (&["part", "component", "class", "subsystem", "use", "include", "instance", "assembly"], PARTS),
    (&["probe", "sensor", "measure", "print", "plot", "log", "record"], "write `output speed: m/s = norm(a.v);`"),
];

/// In place of the fields of a body.
pub const BODY: &[Meaning] = &[
    (&["m"], "write `mass: 1`"),
    (
        &["i", "j", "moment", "momentofinertia", "izz", "gyration"],
        "write `inertia: 0.1`, in kg·m² about the centre of mass",
    ),
    (
        &["radius", "r", "length", "l", "width", "height", "shape", "size", "density"],
        "a body has no shape: write its mass and inertia, such as `mass: m, inertia: m * r^2 / 2` for a disc with `param r: m = 0.3;`",
    ),
    (
        &["x", "y", "phi", "angle", "position", "pos", "at", "v", "velocity", "omega"],
        "where a body begins is said by a start: `start begin { a at (0, 0) angle 0; at rest; }`",
    ),
    (
        &["com", "center", "centre", "cog"],
        "the origin of a body is its centre of mass; other points are written from there, as `point P = a(0.1, 0);`",
    ),
];

/// In place of values.
pub const VALUES: &[Meaning] = &[
    (&["time"], "the time is `t`"),
    (&["π", "pi"], "write `pi`"),
    (&["e", "euler"], "write `exp(x)` for a power of e"),
    (&["lambda", "reaction", "reactions", "multiplier"], REACTIONS),
    (&["energy", "kinetic", "potential", "kineticenergy", "potentialenergy"], ENERGIES),
    (&["s2"], "write `s^2`, as in `9.81 m/s^2`"),
    (
        &["x", "y", "phi", "vx", "vy", "omega"],
        "coordinates and velocities belong to bodies: write `body.x` with the name of a body",
    ),
];

/// In place of units.
pub const UNITS: &[Meaning] = &[
    (&["k", "kelvin", "celsius", "fahrenheit"], NO_TEMPERATURES),
    (&["c"], "a charge is in `A*s`; write a temperature as a plain number"),
    (&["v"], "write `V`"),
    (&["a"], "write `A`"),
    (&["ω"], "write `ohm`"),
    (&["coulomb", "coulombs"], "write `A*s`"),
    (&["f", "farad", "farads"], "write `A*s/V`"),
    (&["wb", "weber", "vs"], "write `V*s`"),
    (&["tesla"], "write `N/(A*m)`"),
    (
        &["percent", "none", "dimensionless", "unitless", "real", "float", "number", "one", "scalar"],
        "leave `:` and the unit out for a plain number: `param mu = 0.3;`",
    ),
    (&["bar", "bars"], "write the value in `kN/m^2`: 1 bar is 100 kN/m^2"),
    (&["l", "liter", "liters", "litre", "litres"], "write `m^3`: 1 litre is 0.001 m^3"),
];

/// In place of members of bodies, points and hinges.
pub const MEMBERS: &[Meaning] = &[
    (
        &["ax", "ay", "a", "alpha", "acc", "acceleration", "accel", "xddot", "yddot", "phiddot", "ddx", "ddy", "ddphi"],
        ACCELERATIONS,
    ),
    (&["speed", "absv"], "write `norm(A.v)` for the speed of `A`"),
    (&["mass", "m", "inertia", "i"], "declare `param m: kg = 1;`, write `mass: m` in the body, and `m` here"),
];

/// In place of members of constraints, among them hinges.
pub const OF_CONSTRAINTS: &[Meaning] = &[(
    &[
        "force",
        "f",
        "fx",
        "fy",
        "torque",
        "moment",
        "lambda",
        "reaction",
        "tension",
        "load",
        "n",
        "normal",
        "multiplier",
    ],
    REACTIONS,
)];

/// In place of functions.
pub const FUNCTIONS: &[Meaning] = &[
    (&["atan", "arctan", "arctan2"], "write `atan2(y, x)`"),
    (&["arcsin"], "write `asin(x)`"),
    (&["arccos"], "write `acos(x)`"),
    (&["cot"], "write `1/tan(x)`"),
    (&["sinh"], "write `(exp(x) - exp(-x))/2`"),
    (&["cosh"], "write `(exp(x) + exp(-x))/2`"),
    (&["asinh"], "write `ln(x + sqrt(x^2 + 1))`"),
    (&["acosh"], "write `ln(x + sqrt(x^2 - 1))`"),
    (&["atanh"], "write `ln((1 + x)/(1 - x))/2`"),
    (&["log"], "write `ln(x)`"),
    (&["log2"], "write `ln(x)/ln(2)`"),
    (&["log10"], "write `ln(x)/ln(10)`"),
    (&["pow", "power"], "write `x^y`"),
    (&["sqr", "square"], "write `x^2`"),
    (&["cbrt"], "write `x^(1/3)`"),
    (&["hypot"], "write `norm((x, y))`"),
    (&["length", "magnitude", "mag"], "write `norm(A.v)`"),
    (&["fabs"], "write `abs(x)`"),
    (&["sgn", "signum"], "write `sign(x)`"),
    (&["step", "heaviside", "ramp", "smoothstep", "sigmoid"], "write `smooth_step(x, from, to)`"),
    (&["pulse", "rect", "window"], "write `smooth_step(t, 1, 1.1) - smooth_step(t, 2, 2.1)`"),
    (&["clamp", "limit", "saturate", "sat", "saturation"], "write `min(max(x, low), high)`"),
    (&["radians", "deg2rad", "torad"], "write `30 deg`, or `x*pi/180`"),
    (&["degrees", "rad2deg", "todeg"], "write `x*180/pi`"),
    (&["mod", "fmod", "rem", "modulo", "remainder", "wrap", "sawtooth"], REMAINDER),
    (&["floor", "trunc", "int"], "write `x - 1/2 - atan2(-sin(2*pi*x), -cos(2*pi*x))/(2*pi)`"),
    (&["round"], "write `x - atan2(sin(2*pi*x), cos(2*pi*x))/(2*pi)`"),
    (
        &["der", "derivative", "diff", "ddt", "dt", "d", "deriv", "derivate", "dot2", "rate", "velocity"],
        "velocities are members: `seat.vx` of `seat.x`, `seat.omega` of `seat.phi`, `P.v` of `P.r`, `B.rate` of `B.angle`; of these there is no \
         further derivative",
    ),
    (&["integral", "integrate", "int", "cumsum"], STATES),
    (&["reaction", "force", "tension", "lambda", "normal"], REACTIONS),
    (&["acceleration", "acc"], ACCELERATIONS),
    (&["interp", "interpolate", "lookup", "table", "spline"], TABLES),
    (&["ifelse", "iff", "where", "piecewise", "select", "if", "match"], CHOICES),
    (
        &["rand", "random", "randn", "noise"],
        "a run has no chance: declare `input noise: N = 0;`, and set it by a program or a table of inputs",
    ),
    (
        &["delay", "transport", "pre"],
        "there are no delays: declare `input late: m = 0;`, and set it by a program that keeps old values",
    ),
    (&["pid", "pd", "pi", "controller"], "write the law: `-kp * B.angle - kd * B.rate`"),
];

/// In place of words of a scene.
pub const SCENE: &[Meaning] = &[
    (&["for", "time", "duration", "end", "tend", "tmax", "t", "stop", "length"], "write `until 3 s;`"),
    (&["initial", "init", "from", "begin", "at"], "write `start begin;` with the name of a start"),
    (&["method", "step", "dt", "solver", "tolerance", "rtol", "atol", "every", "integrator"], OF_A_RUN),
    (
        &["gravity", "force", "torque", "spring", "damper", "drag", "friction", "effect", "use", "add"],
        "forces stand in the model, or in an `effect name { … }` of it, which this scene calls for by `with name;`",
    ),
    (&["param", "set", "input"], "values of parameters are set by the model and by runs: `ezy run --set a=0.3`"),
];

/// In place of words of a start.
pub const START: &[Meaning] = &[
    (&["theta", "orientation", "rotation", "psi"], "write `angle 30 deg`"),
    (&["position", "pos", "r"], "write `at (0, 0)`"),
    (&["v", "vel", "speed"], "write `velocity (0, 0)`"),
    (&["omega", "spin", "angularvelocity", "w"], "write `rate 0`"),
    (&["phi"], "write `angle 0`"),
];

/// Behind constraints and forces that have no such settings.
pub const BEHIND: &[Meaning] = &[
    (
        &["friction", "damping", "stiffness", "damper", "spring", "torque", "motor", "preload", "backlash"],
        "a force is a statement of its own: `friction a ~ b: torque 0.1, rate 1e-3;`, `torsion a ~ b: stiffness k, damping c;`, `torque a ~ b: u;`",
    ),
    (&["limits", "from", "to", "min", "max", "range", "lower", "upper"], "write `stop s: B.angle from -1 to 1;`"),
    (
        &["at", "angle", "start"],
        "where bodies begin is said by a start: `start begin { a at (0, 0) angle 0; at rest; }`",
    ),
];

/// Signs, as messages quote them, and what was expected in their place.
const SIGNS: &[(&str, Meaning)] = &[
    ("`;`", (&["`?`", "`>`", "`<`", "`&`", "`|`", "`!`"], CHOICES)),
    ("`)`", (&["`?`", "`>`", "`<`", "`&`", "`|`", "`!`"], CHOICES)),
    ("`;`", (&["`%`"], REMAINDER)),
    ("`)`", (&["`%`"], REMAINDER)),
    ("a value", (&["`|`"], "write `abs(x)`, or `norm(A.v)` for the length of a vector")),
    ("a value", (&["`[`", "`{`"], "write `(x, y)` for a vector")),
    ("a value", (&["`+`"], "leave this `+` out")),
    ("a value", (&["`!`"], CHOICES)),
    (
        "a quantity",
        (
            &["`.`", "`:`", "`=`"],
            "write `seat at (0, 0) angle 0;`, or `seat x 1 vx 2;`, without signs between word and value; the angle of a hinge follows from those of \
             its bodies",
        ),
    ),
];

/// One word for another, the first of which is known where it stands.
const SYNONYMS: &[(&[&str], &[&str])] = &[
    (&["earth", "floor", "wall", "world", "base", "inertial"], &["ground"]),
    (&["theta", "psi", "yaw", "rotation", "heading", "angle", "phi"], &["phi", "angle"]),
    (&["angularvelocity", "phidot", "thetadot", "yawrate", "rate", "omega", "w", "dphi", "spin"], &["omega", "rate"]),
    (&["xdot", "dx", "xd", "u"], &["vx"]),
    (&["ydot", "dy", "yd"], &["vy"]),
    (&["position", "pos", "p"], &["r"]),
    (&["velocity", "vel"], &["v"]),
    (&["dashpot"], &["damper", "damping"]),
    (&["k", "rigidity"], &["stiffness"]),
    (&["c", "b", "d", "damper", "viscosity"], &["damping", "linear"]),
    (&["l", "l0", "rest", "restlength", "freelength", "natural", "distance"], &["length"]),
    (&["e", "bounce", "elasticity"], &["restitution"]),
    (&["moment"], &["torque"]),
    (&["tire"], &["tyre"]),
    (&["constant", "const"], &["param"]),
];

fn bare(name: &str) -> String {
    name.to_lowercase().replace('_', "")
}

/// What to write for a word that has a meaning elsewhere.
pub fn meaning(table: &[Meaning], name: &str) -> Option<&'static str> {
    let name = bare(name);
    table.iter().find(|(words, _)| words.contains(&name.as_str())).map(|(_, help)| *help)
}

/// The candidate that `name` means elsewhere.
pub fn synonym<'a>(name: &str, candidates: &[&'a str]) -> Option<&'a str> {
    let name = bare(name);
    let mut means = SYNONYMS.iter().filter(|(others, _)| others.contains(&name.as_str())).flat_map(|(_, means)| *means);
    means.find_map(|word| candidates.iter().copied().find(|candidate| candidate == word))
}

/// What to write for a sign, `found`, in place of what was expected.
pub fn sign(expected: &str, found: &str) -> Option<&'static str> {
    let meant = SIGNS.iter().find(|(place, (signs, _))| expected.contains(place) && signs.contains(&found));
    meant.map(|(_, (_, help))| *help)
}
