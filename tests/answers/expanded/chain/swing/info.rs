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
            effect: ::core::option::Option::None,
            rows: &[],
            forces: &[],
            masses: &[
                (
                    ezy::SlotCoordinate {
                        slot: 0,
                        component: 0usize,
                        symbol: ezy::Formula {
                            text: "link[i].x",
                            latex: "x_{\\mathrm{link[i]}}",
                            mathml: "<msub><mi>x</mi><mtext>link[i]</mtext></msub>",
                        },
                    },
                    ezy::Formula {
                        text: "m",
                        latex: "m",
                        mathml: "<mrow><mi>m</mi></mrow>",
                    },
                ),
                (
                    ezy::SlotCoordinate {
                        slot: 0,
                        component: 1usize,
                        symbol: ezy::Formula {
                            text: "link[i].y",
                            latex: "y_{\\mathrm{link[i]}}",
                            mathml: "<msub><mi>y</mi><mtext>link[i]</mtext></msub>",
                        },
                    },
                    ezy::Formula {
                        text: "m",
                        latex: "m",
                        mathml: "<mrow><mi>m</mi></mrow>",
                    },
                ),
                (
                    ezy::SlotCoordinate {
                        slot: 0,
                        component: 2usize,
                        symbol: ezy::Formula {
                            text: "link[i].phi",
                            latex: "\\varphi_{\\mathrm{link[i]}}",
                            mathml: "<msub><mi>φ</mi><mtext>link[i]</mtext></msub>",
                        },
                    },
                    ezy::Formula {
                        text: "m*l^2/12",
                        latex: "\\frac{m \\, l^{2}}{12}",
                        mathml: "<mrow><mfrac><mrow><mi>m</mi><mspace width=\"0.17em\"/><msup><mrow><mi>l</mi></mrow><mn>2</mn></msup></mrow><mrow><mn>12</mn></mrow></mfrac></mrow>",
                    },
                ),
            ],
        },
        ezy::TemplateInfo {
            name: "top",
            word: "hinge",
            ranges: &[],
            effect: ::core::option::Option::None,
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
                        (
                            ezy::SlotCoordinate {
                                slot: 0usize,
                                component: 0usize,
                                symbol: ezy::Formula {
                                    text: "link[0].x",
                                    latex: "x_{\\mathrm{link[0]}}",
                                    mathml: "<msub><mi>x</mi><mtext>link[0]</mtext></msub>",
                                },
                            },
                            ezy::Formula {
                                text: "-1",
                                latex: "-1",
                                mathml: "<mrow><mo>−</mo><mn>1</mn></mrow>",
                            },
                        ),
                        (
                            ezy::SlotCoordinate {
                                slot: 0usize,
                                component: 2usize,
                                symbol: ezy::Formula {
                                    text: "link[0].phi",
                                    latex: "\\varphi_{\\mathrm{link[0]}}",
                                    mathml: "<msub><mi>φ</mi><mtext>link[0]</mtext></msub>",
                                },
                            },
                            ezy::Formula {
                                text: "-l*sin(link[0].phi)/2",
                                latex: "-\\frac{l \\, \\sin{\\varphi_{\\mathrm{link[0]}}}}{2}",
                                mathml: "<mrow><mo>−</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[0]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow>",
                            },
                        ),
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
                        (
                            ezy::SlotCoordinate {
                                slot: 0usize,
                                component: 1usize,
                                symbol: ezy::Formula {
                                    text: "link[0].y",
                                    latex: "y_{\\mathrm{link[0]}}",
                                    mathml: "<msub><mi>y</mi><mtext>link[0]</mtext></msub>",
                                },
                            },
                            ezy::Formula {
                                text: "-1",
                                latex: "-1",
                                mathml: "<mrow><mo>−</mo><mn>1</mn></mrow>",
                            },
                        ),
                        (
                            ezy::SlotCoordinate {
                                slot: 0usize,
                                component: 2usize,
                                symbol: ezy::Formula {
                                    text: "link[0].phi",
                                    latex: "\\varphi_{\\mathrm{link[0]}}",
                                    mathml: "<msub><mi>φ</mi><mtext>link[0]</mtext></msub>",
                                },
                            },
                            ezy::Formula {
                                text: "l*cos(link[0].phi)/2",
                                latex: "\\frac{l \\, \\cos{\\varphi_{\\mathrm{link[0]}}}}{2}",
                                mathml: "<mrow><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[0]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow>",
                            },
                        ),
                    ],
                },
            ],
            forces: &[],
            masses: &[],
        },
        ezy::TemplateInfo {
            name: "pin",
            word: "hinge",
            ranges: &["i in 1..n"],
            effect: ::core::option::Option::None,
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
                        (
                            ezy::SlotCoordinate {
                                slot: 0usize,
                                component: 0usize,
                                symbol: ezy::Formula {
                                    text: "link[i-1].x",
                                    latex: "x_{\\mathrm{link[i-1]}}",
                                    mathml: "<msub><mi>x</mi><mtext>link[i-1]</mtext></msub>",
                                },
                            },
                            ezy::Formula {
                                text: "1",
                                latex: "1",
                                mathml: "<mrow><mn>1</mn></mrow>",
                            },
                        ),
                        (
                            ezy::SlotCoordinate {
                                slot: 0usize,
                                component: 2usize,
                                symbol: ezy::Formula {
                                    text: "link[i-1].phi",
                                    latex: "\\varphi_{\\mathrm{link[i-1]}}",
                                    mathml: "<msub><mi>φ</mi><mtext>link[i-1]</mtext></msub>",
                                },
                            },
                            ezy::Formula {
                                text: "-l*sin(link[i-1].phi)/2",
                                latex: "-\\frac{l \\, \\sin{\\varphi_{\\mathrm{link[i-1]}}}}{2}",
                                mathml: "<mrow><mo>−</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[i-1]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow>",
                            },
                        ),
                        (
                            ezy::SlotCoordinate {
                                slot: 1usize,
                                component: 0usize,
                                symbol: ezy::Formula {
                                    text: "link[i].x",
                                    latex: "x_{\\mathrm{link[i]}}",
                                    mathml: "<msub><mi>x</mi><mtext>link[i]</mtext></msub>",
                                },
                            },
                            ezy::Formula {
                                text: "-1",
                                latex: "-1",
                                mathml: "<mrow><mo>−</mo><mn>1</mn></mrow>",
                            },
                        ),
                        (
                            ezy::SlotCoordinate {
                                slot: 1usize,
                                component: 2usize,
                                symbol: ezy::Formula {
                                    text: "link[i].phi",
                                    latex: "\\varphi_{\\mathrm{link[i]}}",
                                    mathml: "<msub><mi>φ</mi><mtext>link[i]</mtext></msub>",
                                },
                            },
                            ezy::Formula {
                                text: "-l*sin(link[i].phi)/2",
                                latex: "-\\frac{l \\, \\sin{\\varphi_{\\mathrm{link[i]}}}}{2}",
                                mathml: "<mrow><mo>−</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[i]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow>",
                            },
                        ),
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
                        (
                            ezy::SlotCoordinate {
                                slot: 0usize,
                                component: 1usize,
                                symbol: ezy::Formula {
                                    text: "link[i-1].y",
                                    latex: "y_{\\mathrm{link[i-1]}}",
                                    mathml: "<msub><mi>y</mi><mtext>link[i-1]</mtext></msub>",
                                },
                            },
                            ezy::Formula {
                                text: "1",
                                latex: "1",
                                mathml: "<mrow><mn>1</mn></mrow>",
                            },
                        ),
                        (
                            ezy::SlotCoordinate {
                                slot: 0usize,
                                component: 2usize,
                                symbol: ezy::Formula {
                                    text: "link[i-1].phi",
                                    latex: "\\varphi_{\\mathrm{link[i-1]}}",
                                    mathml: "<msub><mi>φ</mi><mtext>link[i-1]</mtext></msub>",
                                },
                            },
                            ezy::Formula {
                                text: "l*cos(link[i-1].phi)/2",
                                latex: "\\frac{l \\, \\cos{\\varphi_{\\mathrm{link[i-1]}}}}{2}",
                                mathml: "<mrow><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[i-1]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow>",
                            },
                        ),
                        (
                            ezy::SlotCoordinate {
                                slot: 1usize,
                                component: 1usize,
                                symbol: ezy::Formula {
                                    text: "link[i].y",
                                    latex: "y_{\\mathrm{link[i]}}",
                                    mathml: "<msub><mi>y</mi><mtext>link[i]</mtext></msub>",
                                },
                            },
                            ezy::Formula {
                                text: "-1",
                                latex: "-1",
                                mathml: "<mrow><mo>−</mo><mn>1</mn></mrow>",
                            },
                        ),
                        (
                            ezy::SlotCoordinate {
                                slot: 1usize,
                                component: 2usize,
                                symbol: ezy::Formula {
                                    text: "link[i].phi",
                                    latex: "\\varphi_{\\mathrm{link[i]}}",
                                    mathml: "<msub><mi>φ</mi><mtext>link[i]</mtext></msub>",
                                },
                            },
                            ezy::Formula {
                                text: "l*cos(link[i].phi)/2",
                                latex: "\\frac{l \\, \\cos{\\varphi_{\\mathrm{link[i]}}}}{2}",
                                mathml: "<mrow><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[i]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow>",
                            },
                        ),
                    ],
                },
            ],
            forces: &[],
            masses: &[],
        },
        ezy::TemplateInfo {
            name: "",
            word: "gravity",
            ranges: &["i in 0..n"],
            effect: ::core::option::Option::None,
            rows: &[],
            forces: &[
                (
                    ezy::SlotCoordinate {
                        slot: 0usize,
                        component: 1usize,
                        symbol: ezy::Formula {
                            text: "link[i].y",
                            latex: "y_{\\mathrm{link[i]}}",
                            mathml: "<msub><mi>y</mi><mtext>link[i]</mtext></msub>",
                        },
                    },
                    ezy::Formula {
                        text: "-m*g",
                        latex: "-m \\, g",
                        mathml: "<mrow><mo>−</mo><mi>m</mi><mspace width=\"0.17em\"/><mi>g</mi></mrow>",
                    },
                ),
            ],
            masses: &[],
        },
        ezy::TemplateInfo {
            name: "top",
            word: "point",
            ranges: &[],
            effect: ::core::option::Option::None,
            rows: &[],
            forces: &[],
            masses: &[],
        },
        ezy::TemplateInfo {
            name: "tip",
            word: "point",
            ranges: &[],
            effect: ::core::option::Option::None,
            rows: &[],
            forces: &[],
            masses: &[],
        },
        ezy::TemplateInfo {
            name: "pin",
            word: "point",
            ranges: &["i in 1..n"],
            effect: ::core::option::Option::None,
            rows: &[],
            forces: &[],
            masses: &[],
        },
        ezy::TemplateInfo {
            name: "sag",
            word: "output",
            ranges: &[],
            effect: ::core::option::Option::None,
            rows: &[],
            forces: &[],
            masses: &[],
        },
        ezy::TemplateInfo {
            name: "",
            word: "start",
            ranges: &["i in 0..n"],
            effect: ::core::option::Option::None,
            rows: &[],
            forces: &[],
            masses: &[],
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
