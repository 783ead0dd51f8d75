///Released level and straight.
///
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Swing {
    ///number of rods; default 10.
    pub n: usize,
    ///length of a rod (m); default `1.0`.
    pub l: f64,
    ///mass of a rod (kg); default `1.0`.
    pub m: f64,
    ///gravity, downwards (m/s^2); default `9.81`.
    pub g: f64,
}
impl ::core::default::Default for Swing {
    fn default() -> Self {
        Self {
            n: 10,
            l: 1f64,
            m: 1f64,
            g: 9.81f64,
        }
    }
}
impl Swing {
    /// What is known of the scene when it is compiled: everything but its sizes.
    const FIXED: ezy::SceneInfo = ezy::SceneInfo {
        model: "Chain",
        name: "swing",
        documentation: "Released level and straight.",
        bodies: &[],
        coordinates: &[],
        points: &[],
        rows: &[],
        n_position_rows: 0,
        parameters: &[
            ezy::ParameterInfo {
                name: "l",
                unit: "m",
                default: 1f64,
                default_text: "1.0",
                documentation: "length of a rod",
                effect: ::core::option::Option::None,
                symbol: ezy::Formula {
                    text: "l",
                    latex: "l",
                    mathml: "<mi>l</mi>",
                },
            },
            ezy::ParameterInfo {
                name: "m",
                unit: "kg",
                default: 1f64,
                default_text: "1.0",
                documentation: "mass of a rod",
                effect: ::core::option::Option::None,
                symbol: ezy::Formula {
                    text: "m",
                    latex: "m",
                    mathml: "<mi>m</mi>",
                },
            },
            ezy::ParameterInfo {
                name: "g",
                unit: "m/s^2",
                default: 9.81f64,
                default_text: "9.81",
                documentation: "gravity, downwards",
                effect: ::core::option::Option::None,
                symbol: ezy::Formula {
                    text: "g",
                    latex: "g",
                    mathml: "<mi>g</mi>",
                },
            },
        ],
        inputs: &[],
        outputs: &[],
        events: &[],
        stick_slip: ::core::option::Option::None,
        stop: ::core::option::Option::None,
        effects: &[],
        until_s: 1f64,
        n_constants: 7usize,
        jacobian: ezy::SparsityPattern {
            starts: &[0],
            columns: &[],
        },
        jacobian_entries: &[],
        mass_entries: &[],
        force_entries: &[],
        potential_energy: ezy::Formula {
            text: "0",
            latex: "0",
            mathml: "<mn>0</mn>",
        },
        abbreviations: &[],
        equations: &[
            ezy::Equation {
                name: "equations of motion",
                text: "[ M    C_q^T ] [ a        ] = [ F  ]\n[ C_q  0     ] [ lambda_C ]   [ -h ]\n",
                latex: "\\begin{bmatrix} M & C_q^T \\\\ C_q & 0 \\end{bmatrix}\\begin{bmatrix} a \\\\ \\lambda_C \\end{bmatrix} = \\begin{bmatrix} F \\\\ -h \\end{bmatrix}",
                mathml: "<math display=\"block\"><mtable style=\"border: solid; border-width: 0 .09em; border-radius: .7em; padding: .1em .2em\"><mtr><mtd><mi>M</mi></mtd><mtd><msubsup><mi>C</mi><mi>q</mi><mi>T</mi></msubsup></mtd></mtr><mtr><mtd><msub><mi>C</mi><mi>q</mi></msub></mtd><mtd><mn>0</mn></mtd></mtr></mtable><mtable style=\"border: solid; border-width: 0 .09em; border-radius: .7em; padding: .1em .2em\"><mtr><mtd><mi>a</mi></mtd></mtr><mtr><mtd><msub><mi>λ</mi><mi>C</mi></msub></mtd></mtr></mtable><mo>=</mo><mtable style=\"border: solid; border-width: 0 .09em; border-radius: .7em; padding: .1em .2em\"><mtr><mtd><mi>F</mi></mtd></mtr><mtr><mtd><mrow><mo>−</mo><mi>h</mi></mrow></mtd></mtr></mtable></math>",
            },
        ],
        elimination: &[],
        acceleration_operations: ezy::Operations {
            add: 0,
            mul: 0,
            div: 0,
            trig: 0,
            calls: 0,
        },
        correction_operations: ezy::Operations {
            add: 0,
            mul: 0,
            div: 0,
            trig: 0,
            calls: 0,
        },
        series: ezy::SeriesInfo::Analytic {
            n_products: 12usize,
            operations: ezy::Operations {
                add: 16usize,
                mul: 37usize,
                div: 0usize,
                trig: 0usize,
                calls: 0usize,
            },
        },
        repeats: ::core::option::Option::Some(ezy::Repeats {
            counts: &[
                ezy::CountInfo {
                    name: "n",
                    default: 10usize,
                    documentation: "number of rods",
                },
            ],
            values: &[10usize],
            templates: Self::TEMPLATES,
            fault: ::core::option::Option::None,
        }),
    };
    const TEMPLATES: &'static [ezy::TemplateInfo] = &[
        ezy::TemplateInfo {
            name: "link",
            word: "body",
            ranges: &["i in 0..n"],
            title: "body link, i in 0..n",
            rows: &[],
            equations: &[
                ezy::Equation {
                    name: "mass matrix",
                    text: "         [ m        ]   link[i].x\ndiag M = [ m        ]   link[i].y\n         [ m*l^2/12 ]   link[i].phi\n",
                    latex: "\\mathrm{diag}\\,M = \\begin{bmatrix} m \\\\ m \\\\ \\frac{m \\, l^{2}}{12} \\end{bmatrix}",
                    mathml: "<math display=\"block\"><mtext>diag </mtext><mi>M</mi><mo>=</mo><mtable><mtr><mtd style=\"border: solid; border-width: 0 .09em; border-radius: .7em .7em 0 0\"><mrow><mi>m</mi></mrow></mtd><mtd><mspace width=\"1em\"/><mtext>link[i].x</mtext></mtd></mtr><mtr><mtd style=\"border: solid; border-width: 0 .09em; border-radius: 0 0 0 0\"><mrow><mi>m</mi></mrow></mtd><mtd><mspace width=\"1em\"/><mtext>link[i].y</mtext></mtd></mtr><mtr><mtd style=\"border: solid; border-width: 0 .09em; border-radius: 0 0 .7em .7em\"><mrow><mfrac><mrow><mi>m</mi><mspace width=\"0.17em\"/><msup><mrow><mi>l</mi></mrow><mn>2</mn></msup></mrow><mrow><mn>12</mn></mrow></mfrac></mrow></mtd><mtd><mspace width=\"1em\"/><mtext>link[i].phi</mtext></mtd></mtr></mtable></math>",
                },
            ],
        },
        ezy::TemplateInfo {
            name: "top",
            word: "hinge",
            ranges: &[],
            title: "hinge top",
            rows: &[
                ezy::RowTemplate {
                    suffix: ".x",
                    row: ezy::RowInfo {
                        name: "top.x",
                        kind: "hinge",
                        multiplier_unit: "N",
                        constraint: ezy::Formula {
                            text: "-link[0].x + l*cos(link[0].phi)/2",
                            latex: "-x_{\\mathrm{link[0]}} + \\frac{l \\, \\cos{\\varphi_{\\mathrm{link[0]}}}}{2}",
                            mathml: "<mrow><mo>−</mo><msub><mi>x</mi><mtext>link[0]</mtext></msub><mo>+</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[0]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow>",
                        },
                        convective_term: ezy::Formula {
                            text: "-l*link[0].omega^2*cos(link[0].phi)/2",
                            latex: "-\\frac{l \\, \\dot{\\varphi}_{\\mathrm{link[0]}}^{2} \\, \\cos{\\varphi_{\\mathrm{link[0]}}}}{2}",
                            mathml: "<mrow><mo>−</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>link[0]</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[0]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow>",
                        },
                    },
                    position: true,
                    entries: &[
                        ezy::SlotCoordinate {
                            slot: 0usize,
                            component: 0usize,
                        },
                        ezy::SlotCoordinate {
                            slot: 0usize,
                            component: 2usize,
                        },
                    ],
                },
                ezy::RowTemplate {
                    suffix: ".y",
                    row: ezy::RowInfo {
                        name: "top.y",
                        kind: "hinge",
                        multiplier_unit: "N",
                        constraint: ezy::Formula {
                            text: "-link[0].y + l*sin(link[0].phi)/2",
                            latex: "-y_{\\mathrm{link[0]}} + \\frac{l \\, \\sin{\\varphi_{\\mathrm{link[0]}}}}{2}",
                            mathml: "<mrow><mo>−</mo><msub><mi>y</mi><mtext>link[0]</mtext></msub><mo>+</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[0]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow>",
                        },
                        convective_term: ezy::Formula {
                            text: "-l*link[0].omega^2*sin(link[0].phi)/2",
                            latex: "-\\frac{l \\, \\dot{\\varphi}_{\\mathrm{link[0]}}^{2} \\, \\sin{\\varphi_{\\mathrm{link[0]}}}}{2}",
                            mathml: "<mrow><mo>−</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>link[0]</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[0]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow>",
                        },
                    },
                    position: true,
                    entries: &[
                        ezy::SlotCoordinate {
                            slot: 0usize,
                            component: 1usize,
                        },
                        ezy::SlotCoordinate {
                            slot: 0usize,
                            component: 2usize,
                        },
                    ],
                },
            ],
            equations: &[
                ezy::Equation {
                    name: "position constraint",
                    text: "0 = C = [ -link[0].x + l*cos(link[0].phi)/2 ]   top.x\n        [ -link[0].y + l*sin(link[0].phi)/2 ]   top.y\n",
                    latex: "0 = C = \\begin{bmatrix} -x_{\\mathrm{link[0]}} + \\frac{l \\, \\cos{\\varphi_{\\mathrm{link[0]}}}}{2} \\\\ -y_{\\mathrm{link[0]}} + \\frac{l \\, \\sin{\\varphi_{\\mathrm{link[0]}}}}{2} \\end{bmatrix}",
                    mathml: "<math display=\"block\"><mn>0</mn><mo>=</mo><mi>C</mi><mo>=</mo><mtable><mtr><mtd style=\"border: solid; border-width: 0 .09em; border-radius: .7em .7em 0 0\"><mrow><mo>−</mo><msub><mi>x</mi><mtext>link[0]</mtext></msub><mo>+</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[0]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow></mtd><mtd><mspace width=\"1em\"/><mtext>top.x</mtext></mtd></mtr><mtr><mtd style=\"border: solid; border-width: 0 .09em; border-radius: 0 0 .7em .7em\"><mrow><mo>−</mo><msub><mi>y</mi><mtext>link[0]</mtext></msub><mo>+</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[0]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow></mtd><mtd><mspace width=\"1em\"/><mtext>top.y</mtext></mtd></mtr></mtable></math>",
                },
                ezy::Equation {
                    name: "its Jacobian",
                    text: "G = top.x  link[0].x: -1, link[0].phi: -l*sin(link[0].phi)/2\n    top.y  link[0].y: -1, link[0].phi: l*cos(link[0].phi)/2\n",
                    latex: "G = \\begin{array}{ll} \\text{top.x} & x_{\\mathrm{link[0]}}\\colon -1,\\; \\varphi_{\\mathrm{link[0]}}\\colon -\\frac{l \\, \\sin{\\varphi_{\\mathrm{link[0]}}}}{2} \\\\ \\text{top.y} & y_{\\mathrm{link[0]}}\\colon -1,\\; \\varphi_{\\mathrm{link[0]}}\\colon \\frac{l \\, \\cos{\\varphi_{\\mathrm{link[0]}}}}{2} \\end{array}",
                    mathml: "<math display=\"block\"><mi>G</mi><mo>=</mo><mtable><mtr><mtd><mtext>top.x</mtext></mtd><mtd><msub><mi>x</mi><mtext>link[0]</mtext></msub><mo>:</mo><mrow><mo>−</mo><mn>1</mn></mrow><mo>,</mo><mspace width=\"0.8em\"/><msub><mi>φ</mi><mtext>link[0]</mtext></msub><mo>:</mo><mrow><mo>−</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[0]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow></mtd></mtr><mtr><mtd><mtext>top.y</mtext></mtd><mtd><msub><mi>y</mi><mtext>link[0]</mtext></msub><mo>:</mo><mrow><mo>−</mo><mn>1</mn></mrow><mo>,</mo><mspace width=\"0.8em\"/><msub><mi>φ</mi><mtext>link[0]</mtext></msub><mo>:</mo><mrow><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[0]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow></mtd></mtr></mtable></math>",
                },
                ezy::Equation {
                    name: "its convective term",
                    text: "h = [ -l*link[0].omega^2*cos(link[0].phi)/2 ]   top.x\n    [ -l*link[0].omega^2*sin(link[0].phi)/2 ]   top.y\n",
                    latex: "h = \\begin{bmatrix} -\\frac{l \\, \\dot{\\varphi}_{\\mathrm{link[0]}}^{2} \\, \\cos{\\varphi_{\\mathrm{link[0]}}}}{2} \\\\ -\\frac{l \\, \\dot{\\varphi}_{\\mathrm{link[0]}}^{2} \\, \\sin{\\varphi_{\\mathrm{link[0]}}}}{2} \\end{bmatrix}",
                    mathml: "<math display=\"block\"><mi>h</mi><mo>=</mo><mtable><mtr><mtd style=\"border: solid; border-width: 0 .09em; border-radius: .7em .7em 0 0\"><mrow><mo>−</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>link[0]</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[0]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow></mtd><mtd><mspace width=\"1em\"/><mtext>top.x</mtext></mtd></mtr><mtr><mtd style=\"border: solid; border-width: 0 .09em; border-radius: 0 0 .7em .7em\"><mrow><mo>−</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>link[0]</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[0]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow></mtd><mtd><mspace width=\"1em\"/><mtext>top.y</mtext></mtd></mtr></mtable></math>",
                },
            ],
        },
        ezy::TemplateInfo {
            name: "pin",
            word: "hinge",
            ranges: &["i in 1..n"],
            title: "hinge pin, i in 1..n",
            rows: &[
                ezy::RowTemplate {
                    suffix: ".x",
                    row: ezy::RowInfo {
                        name: "pin[i].x",
                        kind: "hinge",
                        multiplier_unit: "N",
                        constraint: ezy::Formula {
                            text: "link[i-1].x + l*cos(link[i-1].phi)/2 - link[i].x + l*cos(link[i].phi)/2",
                            latex: "x_{\\mathrm{link[i-1]}} + \\frac{l \\, \\cos{\\varphi_{\\mathrm{link[i-1]}}}}{2} - x_{\\mathrm{link[i]}} + \\frac{l \\, \\cos{\\varphi_{\\mathrm{link[i]}}}}{2}",
                            mathml: "<mrow><msub><mi>x</mi><mtext>link[i-1]</mtext></msub><mo>+</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[i-1]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac><mo>−</mo><msub><mi>x</mi><mtext>link[i]</mtext></msub><mo>+</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[i]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow>",
                        },
                        convective_term: ezy::Formula {
                            text: "-l*link[i-1].omega^2*cos(link[i-1].phi)/2 - l*link[i].omega^2*cos(link[i].phi)/2",
                            latex: "-\\frac{l \\, \\dot{\\varphi}_{\\mathrm{link[i-1]}}^{2} \\, \\cos{\\varphi_{\\mathrm{link[i-1]}}}}{2} - \\frac{l \\, \\dot{\\varphi}_{\\mathrm{link[i]}}^{2} \\, \\cos{\\varphi_{\\mathrm{link[i]}}}}{2}",
                            mathml: "<mrow><mo>−</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>link[i-1]</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[i-1]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac><mo>−</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>link[i]</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[i]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow>",
                        },
                    },
                    position: true,
                    entries: &[
                        ezy::SlotCoordinate {
                            slot: 0usize,
                            component: 0usize,
                        },
                        ezy::SlotCoordinate {
                            slot: 0usize,
                            component: 2usize,
                        },
                        ezy::SlotCoordinate {
                            slot: 1usize,
                            component: 0usize,
                        },
                        ezy::SlotCoordinate {
                            slot: 1usize,
                            component: 2usize,
                        },
                    ],
                },
                ezy::RowTemplate {
                    suffix: ".y",
                    row: ezy::RowInfo {
                        name: "pin[i].y",
                        kind: "hinge",
                        multiplier_unit: "N",
                        constraint: ezy::Formula {
                            text: "link[i-1].y + l*sin(link[i-1].phi)/2 - link[i].y + l*sin(link[i].phi)/2",
                            latex: "y_{\\mathrm{link[i-1]}} + \\frac{l \\, \\sin{\\varphi_{\\mathrm{link[i-1]}}}}{2} - y_{\\mathrm{link[i]}} + \\frac{l \\, \\sin{\\varphi_{\\mathrm{link[i]}}}}{2}",
                            mathml: "<mrow><msub><mi>y</mi><mtext>link[i-1]</mtext></msub><mo>+</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[i-1]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac><mo>−</mo><msub><mi>y</mi><mtext>link[i]</mtext></msub><mo>+</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[i]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow>",
                        },
                        convective_term: ezy::Formula {
                            text: "-l*link[i-1].omega^2*sin(link[i-1].phi)/2 - l*link[i].omega^2*sin(link[i].phi)/2",
                            latex: "-\\frac{l \\, \\dot{\\varphi}_{\\mathrm{link[i-1]}}^{2} \\, \\sin{\\varphi_{\\mathrm{link[i-1]}}}}{2} - \\frac{l \\, \\dot{\\varphi}_{\\mathrm{link[i]}}^{2} \\, \\sin{\\varphi_{\\mathrm{link[i]}}}}{2}",
                            mathml: "<mrow><mo>−</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>link[i-1]</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[i-1]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac><mo>−</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>link[i]</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[i]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow>",
                        },
                    },
                    position: true,
                    entries: &[
                        ezy::SlotCoordinate {
                            slot: 0usize,
                            component: 1usize,
                        },
                        ezy::SlotCoordinate {
                            slot: 0usize,
                            component: 2usize,
                        },
                        ezy::SlotCoordinate {
                            slot: 1usize,
                            component: 1usize,
                        },
                        ezy::SlotCoordinate {
                            slot: 1usize,
                            component: 2usize,
                        },
                    ],
                },
            ],
            equations: &[
                ezy::Equation {
                    name: "position constraint",
                    text: "0 = C = [ link[i-1].x + l*cos(link[i-1].phi)/2 - link[i].x + l*cos(link[i].phi)/2 ]   pin[i].x\n        [ link[i-1].y + l*sin(link[i-1].phi)/2 - link[i].y + l*sin(link[i].phi)/2 ]   pin[i].y\n",
                    latex: "0 = C = \\begin{bmatrix} x_{\\mathrm{link[i-1]}} + \\frac{l \\, \\cos{\\varphi_{\\mathrm{link[i-1]}}}}{2} - x_{\\mathrm{link[i]}} + \\frac{l \\, \\cos{\\varphi_{\\mathrm{link[i]}}}}{2} \\\\ y_{\\mathrm{link[i-1]}} + \\frac{l \\, \\sin{\\varphi_{\\mathrm{link[i-1]}}}}{2} - y_{\\mathrm{link[i]}} + \\frac{l \\, \\sin{\\varphi_{\\mathrm{link[i]}}}}{2} \\end{bmatrix}",
                    mathml: "<math display=\"block\"><mn>0</mn><mo>=</mo><mi>C</mi><mo>=</mo><mtable><mtr><mtd style=\"border: solid; border-width: 0 .09em; border-radius: .7em .7em 0 0\"><mrow><msub><mi>x</mi><mtext>link[i-1]</mtext></msub><mo>+</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[i-1]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac><mo>−</mo><msub><mi>x</mi><mtext>link[i]</mtext></msub><mo>+</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[i]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow></mtd><mtd><mspace width=\"1em\"/><mtext>pin[i].x</mtext></mtd></mtr><mtr><mtd style=\"border: solid; border-width: 0 .09em; border-radius: 0 0 .7em .7em\"><mrow><msub><mi>y</mi><mtext>link[i-1]</mtext></msub><mo>+</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[i-1]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac><mo>−</mo><msub><mi>y</mi><mtext>link[i]</mtext></msub><mo>+</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[i]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow></mtd><mtd><mspace width=\"1em\"/><mtext>pin[i].y</mtext></mtd></mtr></mtable></math>",
                },
                ezy::Equation {
                    name: "its Jacobian",
                    text: "G = pin[i].x  link[i-1].x: 1, link[i-1].phi: -l*sin(link[i-1].phi)/2, link[i].x: -1, link[i].phi: -l*sin(link[i].phi)/2\n    pin[i].y  link[i-1].y: 1, link[i-1].phi: l*cos(link[i-1].phi)/2, link[i].y: -1, link[i].phi: l*cos(link[i].phi)/2\n",
                    latex: "G = \\begin{array}{ll} \\text{pin[i].x} & x_{\\mathrm{link[i-1]}}\\colon 1,\\; \\varphi_{\\mathrm{link[i-1]}}\\colon -\\frac{l \\, \\sin{\\varphi_{\\mathrm{link[i-1]}}}}{2},\\; x_{\\mathrm{link[i]}}\\colon -1,\\; \\varphi_{\\mathrm{link[i]}}\\colon -\\frac{l \\, \\sin{\\varphi_{\\mathrm{link[i]}}}}{2} \\\\ \\text{pin[i].y} & y_{\\mathrm{link[i-1]}}\\colon 1,\\; \\varphi_{\\mathrm{link[i-1]}}\\colon \\frac{l \\, \\cos{\\varphi_{\\mathrm{link[i-1]}}}}{2},\\; y_{\\mathrm{link[i]}}\\colon -1,\\; \\varphi_{\\mathrm{link[i]}}\\colon \\frac{l \\, \\cos{\\varphi_{\\mathrm{link[i]}}}}{2} \\end{array}",
                    mathml: "<math display=\"block\"><mi>G</mi><mo>=</mo><mtable><mtr><mtd><mtext>pin[i].x</mtext></mtd><mtd><msub><mi>x</mi><mtext>link[i-1]</mtext></msub><mo>:</mo><mrow><mn>1</mn></mrow><mo>,</mo><mspace width=\"0.8em\"/><msub><mi>φ</mi><mtext>link[i-1]</mtext></msub><mo>:</mo><mrow><mo>−</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[i-1]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow><mo>,</mo><mspace width=\"0.8em\"/><msub><mi>x</mi><mtext>link[i]</mtext></msub><mo>:</mo><mrow><mo>−</mo><mn>1</mn></mrow><mo>,</mo><mspace width=\"0.8em\"/><msub><mi>φ</mi><mtext>link[i]</mtext></msub><mo>:</mo><mrow><mo>−</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[i]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow></mtd></mtr><mtr><mtd><mtext>pin[i].y</mtext></mtd><mtd><msub><mi>y</mi><mtext>link[i-1]</mtext></msub><mo>:</mo><mrow><mn>1</mn></mrow><mo>,</mo><mspace width=\"0.8em\"/><msub><mi>φ</mi><mtext>link[i-1]</mtext></msub><mo>:</mo><mrow><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[i-1]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow><mo>,</mo><mspace width=\"0.8em\"/><msub><mi>y</mi><mtext>link[i]</mtext></msub><mo>:</mo><mrow><mo>−</mo><mn>1</mn></mrow><mo>,</mo><mspace width=\"0.8em\"/><msub><mi>φ</mi><mtext>link[i]</mtext></msub><mo>:</mo><mrow><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[i]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow></mtd></mtr></mtable></math>",
                },
                ezy::Equation {
                    name: "its convective term",
                    text: "h = [ -l*link[i-1].omega^2*cos(link[i-1].phi)/2 - l*link[i].omega^2*cos(link[i].phi)/2 ]   pin[i].x\n    [ -l*link[i-1].omega^2*sin(link[i-1].phi)/2 - l*link[i].omega^2*sin(link[i].phi)/2 ]   pin[i].y\n",
                    latex: "h = \\begin{bmatrix} -\\frac{l \\, \\dot{\\varphi}_{\\mathrm{link[i-1]}}^{2} \\, \\cos{\\varphi_{\\mathrm{link[i-1]}}}}{2} - \\frac{l \\, \\dot{\\varphi}_{\\mathrm{link[i]}}^{2} \\, \\cos{\\varphi_{\\mathrm{link[i]}}}}{2} \\\\ -\\frac{l \\, \\dot{\\varphi}_{\\mathrm{link[i-1]}}^{2} \\, \\sin{\\varphi_{\\mathrm{link[i-1]}}}}{2} - \\frac{l \\, \\dot{\\varphi}_{\\mathrm{link[i]}}^{2} \\, \\sin{\\varphi_{\\mathrm{link[i]}}}}{2} \\end{bmatrix}",
                    mathml: "<math display=\"block\"><mi>h</mi><mo>=</mo><mtable><mtr><mtd style=\"border: solid; border-width: 0 .09em; border-radius: .7em .7em 0 0\"><mrow><mo>−</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>link[i-1]</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[i-1]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac><mo>−</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>link[i]</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[i]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow></mtd><mtd><mspace width=\"1em\"/><mtext>pin[i].x</mtext></mtd></mtr><mtr><mtd style=\"border: solid; border-width: 0 .09em; border-radius: 0 0 .7em .7em\"><mrow><mo>−</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>link[i-1]</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[i-1]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac><mo>−</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>link[i]</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[i]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow></mtd><mtd><mspace width=\"1em\"/><mtext>pin[i].y</mtext></mtd></mtr></mtable></math>",
                },
            ],
        },
        ezy::TemplateInfo {
            name: "",
            word: "gravity",
            ranges: &["i in 0..n"],
            title: "gravity, i in 0..n",
            rows: &[],
            equations: &[
                ezy::Equation {
                    name: "applied force",
                    text: "F = [ -m*g ]   link[i].y\n",
                    latex: "F = \\begin{bmatrix} -m \\, g \\end{bmatrix}",
                    mathml: "<math display=\"block\"><mi>F</mi><mo>=</mo><mtable><mtr><mtd style=\"border: solid; border-width: 0 .09em; border-radius: .7em .7em .7em .7em\"><mrow><mo>−</mo><mi>m</mi><mspace width=\"0.17em\"/><mi>g</mi></mrow></mtd><mtd><mspace width=\"1em\"/><mtext>link[i].y</mtext></mtd></mtr></mtable></math>",
                },
                ezy::Equation {
                    name: "potential energy",
                    text: "V = m*g*link[i].y\n",
                    latex: "V = m \\, g \\, y_{\\mathrm{link[i]}}",
                    mathml: "<math display=\"block\"><mi>V</mi><mo>=</mo><mrow><mi>m</mi><mspace width=\"0.17em\"/><mi>g</mi><mspace width=\"0.17em\"/><msub><mi>y</mi><mtext>link[i]</mtext></msub></mrow></math>",
                },
            ],
        },
        ezy::TemplateInfo {
            name: "top",
            word: "point",
            ranges: &[],
            title: "point top",
            rows: &[],
            equations: &[
                ezy::Equation {
                    name: "position",
                    text: "top = [ 0 ]\n      [ 0 ]\n",
                    latex: "\\mathrm{top} = \\begin{bmatrix} 0 \\\\ 0 \\end{bmatrix}",
                    mathml: "<math display=\"block\"><mtext>top</mtext><mo>=</mo><mtable style=\"border: solid; border-width: 0 .09em; border-radius: .7em; padding: .1em .2em\"><mtr><mtd><mrow><mn>0</mn></mrow></mtd></mtr><mtr><mtd><mrow><mn>0</mn></mrow></mtd></mtr></mtable></math>",
                },
            ],
        },
        ezy::TemplateInfo {
            name: "tip",
            word: "point",
            ranges: &[],
            title: "point tip",
            rows: &[],
            equations: &[
                ezy::Equation {
                    name: "position",
                    text: "tip = [ link[n-1].x + l*cos(link[n-1].phi)/2 ]\n      [ link[n-1].y + l*sin(link[n-1].phi)/2 ]\n",
                    latex: "\\mathrm{tip} = \\begin{bmatrix} x_{\\mathrm{link[n-1]}} + \\frac{l \\, \\cos{\\varphi_{\\mathrm{link[n-1]}}}}{2} \\\\ y_{\\mathrm{link[n-1]}} + \\frac{l \\, \\sin{\\varphi_{\\mathrm{link[n-1]}}}}{2} \\end{bmatrix}",
                    mathml: "<math display=\"block\"><mtext>tip</mtext><mo>=</mo><mtable style=\"border: solid; border-width: 0 .09em; border-radius: .7em; padding: .1em .2em\"><mtr><mtd><mrow><msub><mi>x</mi><mtext>link[n-1]</mtext></msub><mo>+</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[n-1]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow></mtd></mtr><mtr><mtd><mrow><msub><mi>y</mi><mtext>link[n-1]</mtext></msub><mo>+</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[n-1]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow></mtd></mtr></mtable></math>",
                },
            ],
        },
        ezy::TemplateInfo {
            name: "pin",
            word: "point",
            ranges: &["i in 1..n"],
            title: "point pin, i in 1..n",
            rows: &[],
            equations: &[
                ezy::Equation {
                    name: "position",
                    text: "pin = [ link[i-1].x + l*cos(link[i-1].phi)/2 ]\n      [ link[i-1].y + l*sin(link[i-1].phi)/2 ]\n",
                    latex: "\\mathrm{pin} = \\begin{bmatrix} x_{\\mathrm{link[i-1]}} + \\frac{l \\, \\cos{\\varphi_{\\mathrm{link[i-1]}}}}{2} \\\\ y_{\\mathrm{link[i-1]}} + \\frac{l \\, \\sin{\\varphi_{\\mathrm{link[i-1]}}}}{2} \\end{bmatrix}",
                    mathml: "<math display=\"block\"><mtext>pin</mtext><mo>=</mo><mtable style=\"border: solid; border-width: 0 .09em; border-radius: .7em; padding: .1em .2em\"><mtr><mtd><mrow><msub><mi>x</mi><mtext>link[i-1]</mtext></msub><mo>+</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[i-1]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow></mtd></mtr><mtr><mtd><mrow><msub><mi>y</mi><mtext>link[i-1]</mtext></msub><mo>+</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[i-1]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow></mtd></mtr></mtable></math>",
                },
            ],
        },
        ezy::TemplateInfo {
            name: "sag",
            word: "output",
            ranges: &[],
            title: "output sag",
            rows: &[],
            equations: &[
                ezy::Equation {
                    name: "value",
                    text: "sag = -link[n-1].y/(n*l) - l*sin(link[n-1].phi)/(2*n*l)\n",
                    latex: "\\mathrm{sag} = -\\frac{y_{\\mathrm{link[n-1]}}}{n \\, l} - \\frac{l \\, \\sin{\\varphi_{\\mathrm{link[n-1]}}}}{2 \\, n \\, l}",
                    mathml: "<math display=\"block\"><mtext>sag</mtext><mo>=</mo><mrow><mo>−</mo><mfrac><mrow><msub><mi>y</mi><mtext>link[n-1]</mtext></msub></mrow><mrow><mi>n</mi><mspace width=\"0.17em\"/><mi>l</mi></mrow></mfrac><mo>−</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[n-1]</mtext></msub></mrow></mrow><mrow><mn>2</mn><mspace width=\"0.17em\"/><mi>n</mi><mspace width=\"0.17em\"/><mi>l</mi></mrow></mfrac></mrow></math>",
                },
            ],
        },
        ezy::TemplateInfo {
            name: "",
            word: "start",
            ranges: &["i in 0..n"],
            title: "start, i in 0..n",
            rows: &[],
            equations: &[],
        },
    ];
    fn describe(&self, layout: &mut ezy::Layout) {
        let lengths_link: &[usize] = &[usize::try_from((self.n as i64)).unwrap_or(0)];
        let bodies_link = layout.bodies("link", lengths_link);
        {
            let at: &[i64] = &[];
            let slots: [usize; 1] = [
                layout.member(&Self::TEMPLATES[1usize], at, bodies_link, &[0]),
            ];
            layout.rows(&Self::TEMPLATES[1usize], at, &slots);
        }
        for at_i in layout.range(1, (self.n as i64)) {
            let at: &[i64] = &[at_i];
            let slots: [usize; 2] = [
                layout.member(&Self::TEMPLATES[2usize], at, bodies_link, &[(at_i - 1)]),
                layout.member(&Self::TEMPLATES[2usize], at, bodies_link, &[at_i]),
            ];
            layout.rows(&Self::TEMPLATES[2usize], at, &slots);
        }
        for at_i in layout.range(0, (self.n as i64)) {
            let at: &[i64] = &[at_i];
            let slots: [usize; 1] = [
                layout.member(&Self::TEMPLATES[3usize], at, bodies_link, &[at_i]),
            ];
        }
        {
            let at: &[i64] = &[];
            let slots: [usize; 0] = [];
            layout.point("top", at, ::core::option::Option::None);
        }
        {
            let at: &[i64] = &[];
            let slots: [usize; 1] = [
                layout
                    .member(
                        &Self::TEMPLATES[5usize],
                        at,
                        bodies_link,
                        &[((self.n as i64) - 1)],
                    ),
            ];
            layout.point("tip", at, ::core::option::Option::Some(slots[0usize]));
        }
        for at_i in layout.range(1, (self.n as i64)) {
            let at: &[i64] = &[at_i];
            let slots: [usize; 1] = [
                layout.member(&Self::TEMPLATES[6usize], at, bodies_link, &[(at_i - 1)]),
            ];
            layout.point("pin", at, ::core::option::Option::Some(slots[0usize]));
        }
        {
            let at: &[i64] = &[];
            let slots: [usize; 1] = [
                layout
                    .member(
                        &Self::TEMPLATES[7usize],
                        at,
                        bodies_link,
                        &[((self.n as i64) - 1)],
                    ),
            ];
            const OUTPUT: ezy::OutputInfo = ezy::OutputInfo {
                name: "sag",
                unit: "1",
                documentation: "How low the tip is, as part of the whole length.",
                formula: ezy::Formula {
                    text: "-link[n-1].y/(n*l) - l*sin(link[n-1].phi)/(2*n*l)",
                    latex: "-\\frac{y_{\\mathrm{link[n-1]}}}{n \\, l} - \\frac{l \\, \\sin{\\varphi_{\\mathrm{link[n-1]}}}}{2 \\, n \\, l}",
                    mathml: "<mrow><mo>−</mo><mfrac><mrow><msub><mi>y</mi><mtext>link[n-1]</mtext></msub></mrow><mrow><mi>n</mi><mspace width=\"0.17em\"/><mi>l</mi></mrow></mfrac><mo>−</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[n-1]</mtext></msub></mrow></mrow><mrow><mn>2</mn><mspace width=\"0.17em\"/><mi>n</mi><mspace width=\"0.17em\"/><mi>l</mi></mrow></mfrac></mrow>",
                },
            };
            layout.output(&OUTPUT, at, "");
        }
        for at_i in layout.range(0, (self.n as i64)) {
            let at: &[i64] = &[at_i];
            let slots: [usize; 1] = [
                layout.member(&Self::TEMPLATES[8usize], at, bodies_link, &[at_i]),
            ];
        }
    }
}
