//! Programs that call exported functions, one for each language.

use ezy_core::export::Language;
use ezy_core::model::SceneInfo;
use std::path::Path;
use std::process::Command;

/// A language with what runs it. A driver reads a line `t q v z u` for each state from `states.txt` and prints a line with all results.
pub struct Driver {
    pub language: Language,
    /// What must be there, in words.
    pub needs: &'static str,
    /// A command that succeeds where it is.
    probe: fn() -> Command,
    run: fn(&Path, &SceneInfo, &str) -> Vec<Command>,
}

/// A program with arguments.
fn command(program: &str, arguments: &[&str]) -> Command {
    let mut command = Command::new(program);
    command.args(arguments);
    command
}

pub fn python(arguments: &[&str]) -> Command {
    command(&std::env::var("EZY_PYTHON").unwrap_or_else(|_| "python3".to_owned()), arguments)
}

pub const TOOLS: [Driver; 6] = [
    Driver { language: Language::C, needs: "C compiler `cc`", probe: || command("cc", &["--version"]), run: c },
    Driver {
        language: Language::Numpy,
        needs: "Python with NumPy",
        probe: || python(&["-c", "import numpy"]),
        run: numpy,
    },
    Driver {
        language: Language::Sympy,
        needs: "Python with SymPy",
        probe: || python(&["-c", "import sympy"]),
        run: sympy,
    },
    Driver {
        language: Language::Casadi,
        needs: "Python with CasADi",
        probe: || python(&["-c", "import casadi"]),
        run: casadi,
    },
    Driver {
        language: Language::Matlab,
        needs: "GNU Octave",
        probe: || command("octave-cli", &["--version"]),
        run: octave,
    },
    Driver { language: Language::Julia, needs: "Julia", probe: || command("julia", &["--version"]), run: julia },
];

impl Driver {
    pub fn is_at_hand(&self) -> bool {
        (self.probe)().output().is_ok_and(|done| done.status.success())
    }

    /// What the program prints with the exported `text`.
    pub fn run(&self, folder: &Path, info: &SceneInfo, text: &str) -> String {
        let mut printed = String::new();
        for mut command in (self.run)(folder, info, text) {
            let done = command.current_dir(folder).output().expect("the tool starts");
            let told = String::from_utf8_lossy(&done.stderr);
            assert!(done.status.success() && !told.contains("warning"), "{command:?}: {told}");
            printed = String::from_utf8_lossy(&done.stdout).into_owned();
        }
        printed
    }
}

/// Functions of the motion that a scene has, in the order of `results`, with their sizes: for a matrix those of rows and columns.
fn functions(info: &SceneInfo) -> Vec<(&'static str, usize)> {
    let (n_v, n_c) = (info.n_velocities(), info.n_rows());
    let all = [
        ("position_constraint", info.n_position_rows),
        ("velocity_constraint", n_c),
        ("velocity_jacobian", n_c * n_v),
        ("convective_term", n_c),
        ("applied_force", n_v),
        ("state_rates", info.n_states()),
        ("outputs", info.n_outputs()),
    ];
    all.into_iter().filter(|&(_, n)| n > 0).collect()
}

/// Where t, q, v, z and u stand in a line.
fn places(info: &SceneInfo) -> [usize; 5] {
    let sizes = [1, info.n_coordinates(), info.n_velocities(), info.n_states(), info.n_inputs()];
    let mut end = 0;
    sizes.map(|n| {
        end += n;
        end
    })
}

/// Arguments of a function of the motion.
fn arguments(info: &SceneInfo) -> String {
    let is_there = [true, true, true, info.n_states() > 0, info.n_inputs() > 0, true];
    let names = ["t", "q", "v", "z", "u", "c"].into_iter().zip(is_there).filter(|&(_, is_there)| is_there);
    names.map(|(name, _)| name).collect::<Vec<_>>().join(", ")
}

fn write(folder: &Path, name: &str, text: &str) {
    std::fs::write(folder.join(name), text).expect("a file");
}

fn c(folder: &Path, info: &SceneInfo, text: &str) -> Vec<Command> {
    write(folder, "scene.c", text);
    let prefix = format!("{}_{}", info.model.to_lowercase(), info.name);
    let [_, q, v, z, n] = places(info);
    let n_parameters = info.parameters.len() + info.switches.len();
    let (n_v, n_c, n_constants) = (info.n_velocities(), info.n_rows(), info.n_constants);
    let arguments = arguments(info);
    let mut body = format!(
        "{prefix}_constants(p, c); print(c, {n_constants});\n{prefix}_mass_matrix(c, out); print(out, {n_v});\n"
    );
    for (name, size) in functions(info) {
        body += &format!("{prefix}_{name}({arguments}, out); print(out, {size});\n");
    }
    let largest = functions(info).iter().map(|&(_, size)| size).max().unwrap_or(0).max(n_v);
    let driver = format!(
        "#include \"scene.c\"\n#include <stdio.h>\n\
         static void print(const double *x, int n) {{ for (int i = 0; i < n; i++) printf(\"%.17g \", x[i]); }}\n\
         int main(void) {{\n    double p[{n_parameters} + 1] = {{0}}, c[{n_constants} + 1] = {{0}}, out[{largest}], a[{n_v}], l[{n_c} + 1] = {{0}}, state[{n}];\n\
         {values}\
         FILE *file = fopen(\"states.txt\", \"r\");\n    for (;;) {{\n\
         for (int i = 0; i < {n}; i++) if (fscanf(file, \"%lf\", &state[i]) != 1) return 0;\n\
         const double t = state[0], *q = state + 1, *v = state + {q}, *z = state + {v}, *u = state + {z};\n    (void)z; (void)u;\n\
         {body}{prefix}_accelerations({arguments}, a, l); print(a, {n_v}); print(l, {n_c}); printf(\"\\n\");\n    }}\n}}\n",
        values = match n_parameters {
            0 => String::new(),
            _ => format!("for (int i = 0; i < {n_parameters}; i++) p[i] = {prefix}_list_of_parameters[i].value;\n"),
        },
    );
    write(folder, "driver.c", &driver);
    let flags = ["-std=c99", "-Wall", "-Wextra", "-O1", "driver.c", "-lm", "-o", "driver"];
    vec![command("cc", &flags), Command::new(folder.join("driver"))]
}

/// Beginning of the drivers in Python: `t, q, v, z, u` of a line.
fn python_states(info: &SceneInfo) -> String {
    let [_, q, v, z, n] = places(info);
    format!(
        "import scene\n\
         with open('states.txt') as file:\n\x20   states = [[float(x) for x in line.split()] for line in file]\n\
         parts = [(x[0], x[1:{q}], x[{q}:{v}], x[{v}:{z}], x[{z}:{n}]) for x in states]\n"
    )
}

fn parameters(info: &SceneInfo) -> &'static str {
    if info.parameters.is_empty() && info.switches.is_empty() { "[]" } else { "scene.PARAMETERS" }
}

fn numpy(folder: &Path, info: &SceneInfo, text: &str) -> Vec<Command> {
    write(folder, "scene.py", text);
    let arguments = arguments(info);
    let calls: String =
        functions(info).iter().map(|(name, _)| format!("        scene.{name}({arguments}),\n")).collect();
    // functions of NumPy differ in the last bits with the number of states
    let columns = match !text.contains("solved(mass") {
        true => format!(
            "t, q, v, z, u = (np.array([part[i] for part in parts]).T for i in range(5))\n\
             together = np.concatenate(scene.accelerations({arguments}))\n\
             apart = np.array(apart).T\n\
             assert np.all(abs(together - apart) <= 1e-13 * abs(apart).max(axis=0))\n"
        ),
        false => String::new(),
    };
    let driver = format!(
        "import numpy as np\n{states}c = scene.constants(scene.values({parameters}))\napart = []\nfor part in parts:\n    t, q, v, z, u = map(np.array, part)\n\
         \x20   a, multipliers = scene.accelerations({arguments})\n    apart.append(np.concatenate([a, multipliers]))\n    all = [c, scene.mass_matrix(c),\n{calls}        a, multipliers]\n\
         \x20   print(*(repr(float(x)) for of in all for x in np.ravel(of)))\n{columns}",
        states = python_states(info),
        parameters = parameters(info),
    );
    write(folder, "driver.py", &driver);
    vec![python(&["-W", "error", "driver.py"])]
}

fn sympy(folder: &Path, info: &SceneInfo, text: &str) -> Vec<Command> {
    write(folder, "scene.py", text);
    let arguments = arguments(info);
    let calls: String = functions(info).iter().map(|(name, _)| format!("    scene.{name}({arguments}),\n")).collect();
    // the solution of a general matrix has no expression of a sensible size
    let solved = match !text.contains("solved(mass") {
        true => format!("all += scene.accelerations({arguments})\n"),
        false => String::new(),
    };
    let one_by_one = match !text.contains("solved(mass") {
        true => String::new(),
        false => format!(
            "    t, q, v, z, u = part\n    q, v = sp.Matrix(q), sp.Matrix(v)\n\
             \x20   found += [float(x) for of in scene.accelerations({arguments}) for x in of]\n"
        ),
    };
    let symbols = |list: &str, n: usize| match n {
        0 => "[]".to_owned(),
        _ => format!("scene.symbols(scene.{list})"),
    };
    let driver = format!(
        "import sympy as sp\n{states}c = [sp.Float(x) if isinstance(x, float) else sp.sympify(x) for x in scene.constants(scene.values({parameters}))]\n\
         t = sp.Symbol('t', real=True)\nq, v = scene.symbols(scene.COORDINATES), scene.symbols(scene.VELOCITIES)\nz, u = {z}, {u}\n\
         all = [c, scene.mass_matrix(c),\n{calls}]\n{solved}\
         compute = sp.lambdify([t, q, v, z, u], [x for of in all for x in of], 'math', cse=True)\n\
         for part in parts:\n    found = [float(x) for x in compute(*part)]\n{one_by_one}    print(*map(repr, found))\n",
        states = python_states(info),
        parameters = parameters(info),
        z = symbols("STATES", info.n_states()),
        u = symbols("INPUTS", info.n_inputs()),
    );
    write(folder, "driver.py", &driver);
    vec![python(&["driver.py"])]
}

fn casadi(folder: &Path, info: &SceneInfo, text: &str) -> Vec<Command> {
    write(folder, "scene.py", text);
    let arguments = arguments(info);
    let calls: String = functions(info).iter().map(|(name, _)| format!("scene.{name}({arguments}), ")).collect();
    let symbols = |letter: &str, list: &str, n: usize| match n {
        0 => format!("ca.SX.sym('{letter}', 0)"),
        _ => format!("scene.symbols('{letter}', scene.{list})"),
    };
    let driver = format!(
        "import casadi as ca\n{states}c = scene.constants(scene.values({parameters}))\nt = ca.SX.sym('t')\n\
         q, v = {q}, {v}\nz, u = {z}, {u}\n\
         all = [c, scene.mass_matrix(c), {calls}*scene.accelerations({arguments})]\n\
         compute = ca.Function('compute', [t, q, v, z, u], [ca.vertcat(*(ca.vec(of.T) for of in all))])\n\
         for part in parts:\n    print(*(repr(float(x)) for x in compute(*part).elements()))\n",
        states = python_states(info),
        parameters = parameters(info),
        q = symbols("q", "COORDINATES", info.n_coordinates()),
        v = symbols("v", "VELOCITIES", info.n_velocities()),
        z = symbols("z", "STATES", info.n_states()),
        u = symbols("u", "INPUTS", info.n_inputs()),
    );
    write(folder, "driver.py", &driver);
    vec![python(&["driver.py"])]
}

fn octave(folder: &Path, info: &SceneInfo, text: &str) -> Vec<Command> {
    let name = format!("{}_{}", info.model.to_lowercase(), info.name);
    write(folder, &format!("{name}.m"), text);
    let [_, q, v, z, n] = places(info);
    let arguments = arguments(info);
    let calls: String = functions(info)
        .iter()
        .map(|(name, _)| format!("    all = [all; reshape(scene.{name}({arguments})', [], 1)];\n"))
        .collect();
    let parameters = match info.parameters.is_empty() && info.switches.is_empty() {
        true => "[]",
        false => "scene.values(scene.list.parameters)",
    };
    let driver = format!(
        "scene = {name}();\nc = scene.constants({parameters});\nstates = load('states.txt');\nfor i = 1:rows(states)\n    x = states(i, :)';\n\
         \x20   t = x(1); q = x(2:{q}); v = x({q}+1:{v}); z = x({v}+1:{z}); u = x({z}+1:{n});\n    all = [c; scene.mass_matrix(c)];\n{calls}\
         \x20   [a, multipliers] = scene.accelerations({arguments});\n    printf('%.17g ', [all; a; multipliers]);\n    printf('\\n');\nend\n"
    );
    write(folder, "driver.m", &driver);
    vec![command("octave-cli", &["--norc", "driver.m"])]
}

fn julia(folder: &Path, info: &SceneInfo, text: &str) -> Vec<Command> {
    write(folder, "scene.jl", text);
    let [_, q, v, z, n] = places(info);
    let arguments = arguments(info);
    let model = info.model.to_lowercase();
    let module = format!("{}{}_{}", model[..1].to_uppercase(), &model[1..], info.name);
    let calls: String = functions(info)
        .iter()
        .map(|(name, _)| format!("    append!(all, vec(permutedims(scene.{name}({arguments}))))\n"))
        .collect();
    let parameters = match info.parameters.is_empty() && info.switches.is_empty() {
        true => "Float64[]",
        false => "scene.values(scene.PARAMETERS)",
    };
    let driver = format!(
        "include(\"scene.jl\")\nconst scene = {module}\nc = scene.constants({parameters})\nfor line in eachline(\"states.txt\")\n    x = parse.(Float64, split(line))\n\
         \x20   t, q, v, z, u = x[1], x[2:{q}], x[{q}+1:{v}], x[{v}+1:{z}], x[{z}+1:{n}]\n    all = [c; scene.mass_matrix(c)]\n{calls}\
         \x20   foreach(of -> append!(all, of), scene.accelerations({arguments}))\n    println(join(all, ' '))\nend\n"
    );
    write(folder, "driver.jl", &driver);
    vec![command("julia", &["driver.jl"])]
}
