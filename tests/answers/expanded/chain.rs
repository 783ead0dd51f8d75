///Rods in a row, hung from one end.
#[allow(non_snake_case, unused_variables, clippy::all, clippy::pedantic)]
pub mod chain {
    /// The model and its scenes.
    pub static MODEL: ::ezy_core::model::ModelInfo = ::ezy_core::model::ModelInfo {
        name: "Chain",
        documentation: "Rods in a row, hung from one end.",
        effects: &[
            ::ezy_core::model::EffectInfo {
                name: "friction_in_hinges",
                documentation: "Every hinge resists its rate.",
            },
        ],
        scenes: &[
            ::ezy_core::model::SceneEntry {
                name: "swing",
                info: || ::ezy_core::model::Scene::info(
                    &<Swing as ::core::default::Default>::default(),
                ),
                new: || ::std::boxed::Box::new(
                    <Swing as ::core::default::Default>::default(),
                ),
            },
            ::ezy_core::model::SceneEntry {
                name: "settle",
                info: || ::ezy_core::model::Scene::info(
                    &<Settle as ::core::default::Default>::default(),
                ),
                new: || ::std::boxed::Box::new(
                    <Settle as ::core::default::Default>::default(),
                ),
            },
        ],
    };
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
        const FIXED: ::ezy_core::model::SceneInfo = ::ezy_core::model::SceneInfo {
            model: "Chain",
            name: "swing",
            documentation: "Released level and straight.",
            bodies: &[],
            coordinates: &[],
            points: &[],
            rows: &[],
            n_position_rows: 0,
            parameters: &[
                ::ezy_core::model::ParameterInfo {
                    name: "l",
                    unit: "m",
                    default: 1f64,
                    default_text: "1.0",
                    documentation: "length of a rod",
                    effect: ::core::option::Option::None,
                    symbol: ::ezy_core::model::Formula {
                        text: "l",
                        latex: "l",
                        mathml: "<mi>l</mi>",
                    },
                },
                ::ezy_core::model::ParameterInfo {
                    name: "m",
                    unit: "kg",
                    default: 1f64,
                    default_text: "1.0",
                    documentation: "mass of a rod",
                    effect: ::core::option::Option::None,
                    symbol: ::ezy_core::model::Formula {
                        text: "m",
                        latex: "m",
                        mathml: "<mi>m</mi>",
                    },
                },
                ::ezy_core::model::ParameterInfo {
                    name: "g",
                    unit: "m/s^2",
                    default: 9.81f64,
                    default_text: "9.81",
                    documentation: "gravity, downwards",
                    effect: ::core::option::Option::None,
                    symbol: ::ezy_core::model::Formula {
                        text: "g",
                        latex: "g",
                        mathml: "<mi>g</mi>",
                    },
                },
            ],
            inputs: &[],
            outputs: &[],
            effects: &[],
            until_s: 1f64,
            n_constants: 6usize,
            jacobian: ::ezy_core::model::SparsityPattern {
                starts: &[0],
                columns: &[],
            },
            jacobian_entries: &[],
            mass_entries: &[],
            force_entries: &[],
            potential_energy: ::ezy_core::model::Formula {
                text: "0",
                latex: "0",
                mathml: "<mn>0</mn>",
            },
            abbreviations: &[],
            elimination: &[],
            acceleration_operations: ::ezy_core::model::Operations {
                add: 0,
                mul: 0,
                div: 0,
                trig: 0,
                calls: 0,
            },
            correction_operations: ::ezy_core::model::Operations {
                add: 0,
                mul: 0,
                div: 0,
                trig: 0,
                calls: 0,
            },
            series: ::ezy_core::model::SeriesInfo::Analytic {
                n_products: 12usize,
                operations: ::ezy_core::model::Operations {
                    add: 16usize,
                    mul: 37usize,
                    div: 0usize,
                    trig: 0usize,
                    calls: 0usize,
                },
            },
            repeats: ::core::option::Option::Some(::ezy_core::model::Repeats {
                counts: &[
                    ::ezy_core::model::CountInfo {
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
        const TEMPLATES: &'static [::ezy_core::model::TemplateInfo] = &[
            ::ezy_core::model::TemplateInfo {
                name: "link",
                word: "body",
                ranges: &["i in 0..n"],
                effect: ::core::option::Option::None,
                rows: &[],
                forces: &[],
                masses: &[
                    (
                        ::ezy_core::model::SlotCoordinate {
                            slot: 0,
                            component: 0usize,
                            symbol: ::ezy_core::model::Formula {
                                text: "link[i].x",
                                latex: "x_{\\mathrm{link[i]}}",
                                mathml: "<msub><mi>x</mi><mtext>link[i]</mtext></msub>",
                            },
                        },
                        ::ezy_core::model::Formula {
                            text: "m",
                            latex: "m",
                            mathml: "<mrow><mi>m</mi></mrow>",
                        },
                    ),
                    (
                        ::ezy_core::model::SlotCoordinate {
                            slot: 0,
                            component: 1usize,
                            symbol: ::ezy_core::model::Formula {
                                text: "link[i].y",
                                latex: "y_{\\mathrm{link[i]}}",
                                mathml: "<msub><mi>y</mi><mtext>link[i]</mtext></msub>",
                            },
                        },
                        ::ezy_core::model::Formula {
                            text: "m",
                            latex: "m",
                            mathml: "<mrow><mi>m</mi></mrow>",
                        },
                    ),
                    (
                        ::ezy_core::model::SlotCoordinate {
                            slot: 0,
                            component: 2usize,
                            symbol: ::ezy_core::model::Formula {
                                text: "link[i].phi",
                                latex: "\\varphi_{\\mathrm{link[i]}}",
                                mathml: "<msub><mi>φ</mi><mtext>link[i]</mtext></msub>",
                            },
                        },
                        ::ezy_core::model::Formula {
                            text: "m*l^2/12",
                            latex: "\\frac{m \\, l^{2}}{12}",
                            mathml: "<mrow><mfrac><mrow><mi>m</mi><mspace width=\"0.17em\"/><msup><mrow><mi>l</mi></mrow><mn>2</mn></msup></mrow><mrow><mn>12</mn></mrow></mfrac></mrow>",
                        },
                    ),
                ],
            },
            ::ezy_core::model::TemplateInfo {
                name: "top",
                word: "hinge",
                ranges: &[],
                effect: ::core::option::Option::None,
                rows: &[
                    ::ezy_core::model::RowTemplate {
                        suffix: ".x",
                        row: ::ezy_core::model::RowInfo {
                            name: "top.x",
                            kind: "hinge",
                            multiplier_unit: "N",
                            constraint: ::ezy_core::model::Formula {
                                text: "-link[0].x + l*cos(link[0].phi)/2",
                                latex: "-x_{\\mathrm{link[0]}} + \\frac{l \\, \\cos{\\varphi_{\\mathrm{link[0]}}}}{2}",
                                mathml: "<mrow><mo>−</mo><msub><mi>x</mi><mtext>link[0]</mtext></msub><mo>+</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[0]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow>",
                            },
                            convective_term: ::ezy_core::model::Formula {
                                text: "-l*link[0].omega^2*cos(link[0].phi)/2",
                                latex: "-\\frac{l \\, \\dot{\\varphi}_{\\mathrm{link[0]}}^{2} \\, \\cos{\\varphi_{\\mathrm{link[0]}}}}{2}",
                                mathml: "<mrow><mo>−</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>link[0]</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[0]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow>",
                            },
                        },
                        position: true,
                        entries: &[
                            (
                                ::ezy_core::model::SlotCoordinate {
                                    slot: 0usize,
                                    component: 0usize,
                                    symbol: ::ezy_core::model::Formula {
                                        text: "link[0].x",
                                        latex: "x_{\\mathrm{link[0]}}",
                                        mathml: "<msub><mi>x</mi><mtext>link[0]</mtext></msub>",
                                    },
                                },
                                ::ezy_core::model::Formula {
                                    text: "-1",
                                    latex: "-1",
                                    mathml: "<mrow><mo>−</mo><mn>1</mn></mrow>",
                                },
                            ),
                            (
                                ::ezy_core::model::SlotCoordinate {
                                    slot: 0usize,
                                    component: 2usize,
                                    symbol: ::ezy_core::model::Formula {
                                        text: "link[0].phi",
                                        latex: "\\varphi_{\\mathrm{link[0]}}",
                                        mathml: "<msub><mi>φ</mi><mtext>link[0]</mtext></msub>",
                                    },
                                },
                                ::ezy_core::model::Formula {
                                    text: "-l*sin(link[0].phi)/2",
                                    latex: "-\\frac{l \\, \\sin{\\varphi_{\\mathrm{link[0]}}}}{2}",
                                    mathml: "<mrow><mo>−</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[0]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow>",
                                },
                            ),
                        ],
                    },
                    ::ezy_core::model::RowTemplate {
                        suffix: ".y",
                        row: ::ezy_core::model::RowInfo {
                            name: "top.y",
                            kind: "hinge",
                            multiplier_unit: "N",
                            constraint: ::ezy_core::model::Formula {
                                text: "-link[0].y + l*sin(link[0].phi)/2",
                                latex: "-y_{\\mathrm{link[0]}} + \\frac{l \\, \\sin{\\varphi_{\\mathrm{link[0]}}}}{2}",
                                mathml: "<mrow><mo>−</mo><msub><mi>y</mi><mtext>link[0]</mtext></msub><mo>+</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[0]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow>",
                            },
                            convective_term: ::ezy_core::model::Formula {
                                text: "-l*link[0].omega^2*sin(link[0].phi)/2",
                                latex: "-\\frac{l \\, \\dot{\\varphi}_{\\mathrm{link[0]}}^{2} \\, \\sin{\\varphi_{\\mathrm{link[0]}}}}{2}",
                                mathml: "<mrow><mo>−</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>link[0]</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[0]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow>",
                            },
                        },
                        position: true,
                        entries: &[
                            (
                                ::ezy_core::model::SlotCoordinate {
                                    slot: 0usize,
                                    component: 1usize,
                                    symbol: ::ezy_core::model::Formula {
                                        text: "link[0].y",
                                        latex: "y_{\\mathrm{link[0]}}",
                                        mathml: "<msub><mi>y</mi><mtext>link[0]</mtext></msub>",
                                    },
                                },
                                ::ezy_core::model::Formula {
                                    text: "-1",
                                    latex: "-1",
                                    mathml: "<mrow><mo>−</mo><mn>1</mn></mrow>",
                                },
                            ),
                            (
                                ::ezy_core::model::SlotCoordinate {
                                    slot: 0usize,
                                    component: 2usize,
                                    symbol: ::ezy_core::model::Formula {
                                        text: "link[0].phi",
                                        latex: "\\varphi_{\\mathrm{link[0]}}",
                                        mathml: "<msub><mi>φ</mi><mtext>link[0]</mtext></msub>",
                                    },
                                },
                                ::ezy_core::model::Formula {
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
            ::ezy_core::model::TemplateInfo {
                name: "pin",
                word: "hinge",
                ranges: &["i in 1..n"],
                effect: ::core::option::Option::None,
                rows: &[
                    ::ezy_core::model::RowTemplate {
                        suffix: ".x",
                        row: ::ezy_core::model::RowInfo {
                            name: "pin[i].x",
                            kind: "hinge",
                            multiplier_unit: "N",
                            constraint: ::ezy_core::model::Formula {
                                text: "link[i-1].x + l*cos(link[i-1].phi)/2 - link[i].x + l*cos(link[i].phi)/2",
                                latex: "x_{\\mathrm{link[i-1]}} + \\frac{l \\, \\cos{\\varphi_{\\mathrm{link[i-1]}}}}{2} - x_{\\mathrm{link[i]}} + \\frac{l \\, \\cos{\\varphi_{\\mathrm{link[i]}}}}{2}",
                                mathml: "<mrow><msub><mi>x</mi><mtext>link[i-1]</mtext></msub><mo>+</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[i-1]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac><mo>−</mo><msub><mi>x</mi><mtext>link[i]</mtext></msub><mo>+</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[i]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow>",
                            },
                            convective_term: ::ezy_core::model::Formula {
                                text: "-l*link[i-1].omega^2*cos(link[i-1].phi)/2 - l*link[i].omega^2*cos(link[i].phi)/2",
                                latex: "-\\frac{l \\, \\dot{\\varphi}_{\\mathrm{link[i-1]}}^{2} \\, \\cos{\\varphi_{\\mathrm{link[i-1]}}}}{2} - \\frac{l \\, \\dot{\\varphi}_{\\mathrm{link[i]}}^{2} \\, \\cos{\\varphi_{\\mathrm{link[i]}}}}{2}",
                                mathml: "<mrow><mo>−</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>link[i-1]</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[i-1]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac><mo>−</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>link[i]</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[i]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow>",
                            },
                        },
                        position: true,
                        entries: &[
                            (
                                ::ezy_core::model::SlotCoordinate {
                                    slot: 0usize,
                                    component: 0usize,
                                    symbol: ::ezy_core::model::Formula {
                                        text: "link[i-1].x",
                                        latex: "x_{\\mathrm{link[i-1]}}",
                                        mathml: "<msub><mi>x</mi><mtext>link[i-1]</mtext></msub>",
                                    },
                                },
                                ::ezy_core::model::Formula {
                                    text: "1",
                                    latex: "1",
                                    mathml: "<mrow><mn>1</mn></mrow>",
                                },
                            ),
                            (
                                ::ezy_core::model::SlotCoordinate {
                                    slot: 0usize,
                                    component: 2usize,
                                    symbol: ::ezy_core::model::Formula {
                                        text: "link[i-1].phi",
                                        latex: "\\varphi_{\\mathrm{link[i-1]}}",
                                        mathml: "<msub><mi>φ</mi><mtext>link[i-1]</mtext></msub>",
                                    },
                                },
                                ::ezy_core::model::Formula {
                                    text: "-l*sin(link[i-1].phi)/2",
                                    latex: "-\\frac{l \\, \\sin{\\varphi_{\\mathrm{link[i-1]}}}}{2}",
                                    mathml: "<mrow><mo>−</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[i-1]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow>",
                                },
                            ),
                            (
                                ::ezy_core::model::SlotCoordinate {
                                    slot: 1usize,
                                    component: 0usize,
                                    symbol: ::ezy_core::model::Formula {
                                        text: "link[i].x",
                                        latex: "x_{\\mathrm{link[i]}}",
                                        mathml: "<msub><mi>x</mi><mtext>link[i]</mtext></msub>",
                                    },
                                },
                                ::ezy_core::model::Formula {
                                    text: "-1",
                                    latex: "-1",
                                    mathml: "<mrow><mo>−</mo><mn>1</mn></mrow>",
                                },
                            ),
                            (
                                ::ezy_core::model::SlotCoordinate {
                                    slot: 1usize,
                                    component: 2usize,
                                    symbol: ::ezy_core::model::Formula {
                                        text: "link[i].phi",
                                        latex: "\\varphi_{\\mathrm{link[i]}}",
                                        mathml: "<msub><mi>φ</mi><mtext>link[i]</mtext></msub>",
                                    },
                                },
                                ::ezy_core::model::Formula {
                                    text: "-l*sin(link[i].phi)/2",
                                    latex: "-\\frac{l \\, \\sin{\\varphi_{\\mathrm{link[i]}}}}{2}",
                                    mathml: "<mrow><mo>−</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[i]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow>",
                                },
                            ),
                        ],
                    },
                    ::ezy_core::model::RowTemplate {
                        suffix: ".y",
                        row: ::ezy_core::model::RowInfo {
                            name: "pin[i].y",
                            kind: "hinge",
                            multiplier_unit: "N",
                            constraint: ::ezy_core::model::Formula {
                                text: "link[i-1].y + l*sin(link[i-1].phi)/2 - link[i].y + l*sin(link[i].phi)/2",
                                latex: "y_{\\mathrm{link[i-1]}} + \\frac{l \\, \\sin{\\varphi_{\\mathrm{link[i-1]}}}}{2} - y_{\\mathrm{link[i]}} + \\frac{l \\, \\sin{\\varphi_{\\mathrm{link[i]}}}}{2}",
                                mathml: "<mrow><msub><mi>y</mi><mtext>link[i-1]</mtext></msub><mo>+</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[i-1]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac><mo>−</mo><msub><mi>y</mi><mtext>link[i]</mtext></msub><mo>+</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[i]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow>",
                            },
                            convective_term: ::ezy_core::model::Formula {
                                text: "-l*link[i-1].omega^2*sin(link[i-1].phi)/2 - l*link[i].omega^2*sin(link[i].phi)/2",
                                latex: "-\\frac{l \\, \\dot{\\varphi}_{\\mathrm{link[i-1]}}^{2} \\, \\sin{\\varphi_{\\mathrm{link[i-1]}}}}{2} - \\frac{l \\, \\dot{\\varphi}_{\\mathrm{link[i]}}^{2} \\, \\sin{\\varphi_{\\mathrm{link[i]}}}}{2}",
                                mathml: "<mrow><mo>−</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>link[i-1]</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[i-1]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac><mo>−</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>link[i]</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[i]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow>",
                            },
                        },
                        position: true,
                        entries: &[
                            (
                                ::ezy_core::model::SlotCoordinate {
                                    slot: 0usize,
                                    component: 1usize,
                                    symbol: ::ezy_core::model::Formula {
                                        text: "link[i-1].y",
                                        latex: "y_{\\mathrm{link[i-1]}}",
                                        mathml: "<msub><mi>y</mi><mtext>link[i-1]</mtext></msub>",
                                    },
                                },
                                ::ezy_core::model::Formula {
                                    text: "1",
                                    latex: "1",
                                    mathml: "<mrow><mn>1</mn></mrow>",
                                },
                            ),
                            (
                                ::ezy_core::model::SlotCoordinate {
                                    slot: 0usize,
                                    component: 2usize,
                                    symbol: ::ezy_core::model::Formula {
                                        text: "link[i-1].phi",
                                        latex: "\\varphi_{\\mathrm{link[i-1]}}",
                                        mathml: "<msub><mi>φ</mi><mtext>link[i-1]</mtext></msub>",
                                    },
                                },
                                ::ezy_core::model::Formula {
                                    text: "l*cos(link[i-1].phi)/2",
                                    latex: "\\frac{l \\, \\cos{\\varphi_{\\mathrm{link[i-1]}}}}{2}",
                                    mathml: "<mrow><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[i-1]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow>",
                                },
                            ),
                            (
                                ::ezy_core::model::SlotCoordinate {
                                    slot: 1usize,
                                    component: 1usize,
                                    symbol: ::ezy_core::model::Formula {
                                        text: "link[i].y",
                                        latex: "y_{\\mathrm{link[i]}}",
                                        mathml: "<msub><mi>y</mi><mtext>link[i]</mtext></msub>",
                                    },
                                },
                                ::ezy_core::model::Formula {
                                    text: "-1",
                                    latex: "-1",
                                    mathml: "<mrow><mo>−</mo><mn>1</mn></mrow>",
                                },
                            ),
                            (
                                ::ezy_core::model::SlotCoordinate {
                                    slot: 1usize,
                                    component: 2usize,
                                    symbol: ::ezy_core::model::Formula {
                                        text: "link[i].phi",
                                        latex: "\\varphi_{\\mathrm{link[i]}}",
                                        mathml: "<msub><mi>φ</mi><mtext>link[i]</mtext></msub>",
                                    },
                                },
                                ::ezy_core::model::Formula {
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
            ::ezy_core::model::TemplateInfo {
                name: "",
                word: "gravity",
                ranges: &["i in 0..n"],
                effect: ::core::option::Option::None,
                rows: &[],
                forces: &[
                    (
                        ::ezy_core::model::SlotCoordinate {
                            slot: 0usize,
                            component: 1usize,
                            symbol: ::ezy_core::model::Formula {
                                text: "link[i].y",
                                latex: "y_{\\mathrm{link[i]}}",
                                mathml: "<msub><mi>y</mi><mtext>link[i]</mtext></msub>",
                            },
                        },
                        ::ezy_core::model::Formula {
                            text: "-m*g",
                            latex: "-m \\, g",
                            mathml: "<mrow><mo>−</mo><mi>m</mi><mspace width=\"0.17em\"/><mi>g</mi></mrow>",
                        },
                    ),
                ],
                masses: &[],
            },
            ::ezy_core::model::TemplateInfo {
                name: "top",
                word: "point",
                ranges: &[],
                effect: ::core::option::Option::None,
                rows: &[],
                forces: &[],
                masses: &[],
            },
            ::ezy_core::model::TemplateInfo {
                name: "tip",
                word: "point",
                ranges: &[],
                effect: ::core::option::Option::None,
                rows: &[],
                forces: &[],
                masses: &[],
            },
            ::ezy_core::model::TemplateInfo {
                name: "pin",
                word: "point",
                ranges: &["i in 1..n"],
                effect: ::core::option::Option::None,
                rows: &[],
                forces: &[],
                masses: &[],
            },
            ::ezy_core::model::TemplateInfo {
                name: "sag",
                word: "output",
                ranges: &[],
                effect: ::core::option::Option::None,
                rows: &[],
                forces: &[],
                masses: &[],
            },
            ::ezy_core::model::TemplateInfo {
                name: "",
                word: "start",
                ranges: &["i in 0..n"],
                effect: ::core::option::Option::None,
                rows: &[],
                forces: &[],
                masses: &[],
            },
        ];
        fn describe(&self, layout: &mut ::ezy_core::layout::Layout) {
            let lengths_link: &[usize] = &[
                usize::try_from((self.n as i64)).unwrap_or(0),
            ];
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
                    layout
                        .member(
                            &Self::TEMPLATES[2usize],
                            at,
                            bodies_link,
                            &[(at_i - 1)],
                        ),
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
                    layout
                        .member(&Self::TEMPLATES[6usize], at, bodies_link, &[(at_i - 1)]),
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
                const OUTPUT: ::ezy_core::model::OutputInfo = ::ezy_core::model::OutputInfo {
                    name: "sag",
                    unit: "1",
                    documentation: "How low the tip is, as part of the whole length.",
                    formula: ::ezy_core::model::Formula {
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
    #[automatically_derived]
    impl<T: ::ezy_core::scalar::Scalar> ::ezy_core::model::Equations<T> for self::Swing {
        fn constants(&self, parameters: &[T], c: &mut [T]) {
            let parameters = ::ezy_core::kernel::array::<3usize, T>(parameters);
            let c = ::ezy_core::kernel::array_mut::<6usize, T>(c);
            let k1 = T::from_f64(1f64);
            let parameter_m = parameters[1usize];
            let parameter_l = parameters[0usize];
            let k4 = T::from_f64(2f64);
            let k5 = parameter_l * parameter_l;
            let k6 = parameter_m * k5;
            let k7 = T::from_f64(12f64);
            let k9 = k6 / k7;
            let parameter_g = parameters[2usize];
            let k11 = parameter_m * parameter_g;
            let k13 = parameter_l / k4;
            let k14 = T::from_f64(self.n as f64);
            let k15 = k14 * parameter_l;
            let k16 = k1 / k15;
            let k17 = k13 / k15;
            c[0usize] = parameter_m;
            c[1usize] = k9;
            c[2usize] = k13;
            c[3usize] = k11;
            c[4usize] = k16;
            c[5usize] = k17;
        }
        fn mass_matrix(&self, c: &[T], m: &mut [T]) {
            let mut place = 0;
            for _ in 0..(self.n as i64) {
                m[place] = c[0usize];
                place += 1;
                m[place] = c[0usize];
                place += 1;
                m[place] = c[1usize];
                place += 1;
            }
        }
        fn position_constraint(&self, c: &[T], t: T, q: &[T], out: &mut [T]) {
            let first_link: i64 = 0;
            let mut place = 0;
            {
                let slots: [usize; 1] = [3 * (first_link + 0) as usize];
                let link_0_x = q[slots[0] + 0];
                let link_0_phi = q[slots[0] + 2];
                let (sin_link_0_phi, cos_link_0_phi) = T::sin_cos(link_0_phi);
                let difference_7 = T::fused(c[2usize], cos_link_0_phi, -link_0_x);
                let link_0_y = q[slots[0] + 1];
                let difference_11 = T::fused(c[2usize], sin_link_0_phi, -link_0_y);
                out[place] = difference_7;
                place += 1;
                out[place] = difference_11;
                place += 1;
            }
            for at_i in 1..(self.n as i64) {
                let slots: [usize; 2] = [
                    3 * (first_link + (at_i - 1)) as usize,
                    3 * (first_link + at_i) as usize,
                ];
                let link_i_1_phi = q[slots[0] + 2];
                let (sin_link_i_1_phi, cos_link_i_1_phi) = T::sin_cos(link_i_1_phi);
                let link_i_phi = q[slots[1] + 2];
                let (sin_link_i_phi, cos_link_i_phi) = T::sin_cos(link_i_phi);
                let sum_6 = cos_link_i_1_phi + cos_link_i_phi;
                let link_i_1_x = q[slots[0] + 0];
                let sum_10 = T::fused(sum_6, c[2usize], link_i_1_x);
                let link_i_x = q[slots[1] + 0];
                let difference_12 = sum_10 - link_i_x;
                let sum_15 = sin_link_i_1_phi + sin_link_i_phi;
                let link_i_1_y = q[slots[0] + 1];
                let sum_18 = T::fused(c[2usize], sum_15, link_i_1_y);
                let link_i_y = q[slots[1] + 1];
                let difference_20 = sum_18 - link_i_y;
                out[place] = difference_12;
                place += 1;
                out[place] = difference_20;
                place += 1;
            }
        }
        fn velocity_constraint(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
            let first_link: i64 = 0;
            let mut place = 0;
            {
                let slots: [usize; 1] = [3 * (first_link + 0) as usize];
                let link_0_vx = v[slots[0] + 0];
                let link_0_omega = v[slots[0] + 2];
                let product_5 = c[2usize] * link_0_omega;
                let link_0_phi = q[slots[0] + 2];
                let (sin_link_0_phi, cos_link_0_phi) = T::sin_cos(link_0_phi);
                let sum_9 = T::fused(product_5, sin_link_0_phi, link_0_vx);
                let link_0_vy = v[slots[0] + 1];
                let difference_13 = T::fused(product_5, cos_link_0_phi, -link_0_vy);
                let value_14 = -sum_9;
                out[place] = value_14;
                place += 1;
                out[place] = difference_13;
                place += 1;
            }
            for at_i in 1..(self.n as i64) {
                let slots: [usize; 2] = [
                    3 * (first_link + (at_i - 1)) as usize,
                    3 * (first_link + at_i) as usize,
                ];
                let link_i_1_omega = v[slots[0] + 2];
                let link_i_1_phi = q[slots[0] + 2];
                let (sin_link_i_1_phi, cos_link_i_1_phi) = T::sin_cos(link_i_1_phi);
                let product_5 = link_i_1_omega * sin_link_i_1_phi;
                let link_i_omega = v[slots[1] + 2];
                let link_i_phi = q[slots[1] + 2];
                let (sin_link_i_phi, cos_link_i_phi) = T::sin_cos(link_i_phi);
                let sum_10 = T::fused(link_i_omega, sin_link_i_phi, product_5);
                let link_i_1_vx = v[slots[0] + 0];
                let difference_14 = T::fused(-sum_10, c[2usize], link_i_1_vx);
                let link_i_vx = v[slots[1] + 0];
                let difference_16 = difference_14 - link_i_vx;
                let product_18 = link_i_1_omega * cos_link_i_1_phi;
                let sum_21 = T::fused(link_i_omega, cos_link_i_phi, product_18);
                let link_i_1_vy = v[slots[0] + 1];
                let sum_24 = T::fused(c[2usize], sum_21, link_i_1_vy);
                let link_i_vy = v[slots[1] + 1];
                let difference_26 = sum_24 - link_i_vy;
                out[place] = difference_16;
                place += 1;
                out[place] = difference_26;
                place += 1;
            }
        }
        fn velocity_jacobian(&self, c: &[T], t: T, q: &[T], out: &mut [T]) {
            let first_link: i64 = 0;
            let mut place = 0;
            {
                let slots: [usize; 1] = [3 * (first_link + 0) as usize];
                let link_0_phi = q[slots[0] + 2];
                let (sin_link_0_phi, cos_link_0_phi) = T::sin_cos(link_0_phi);
                let product_4 = c[2usize] * sin_link_0_phi;
                let product_6 = c[2usize] * cos_link_0_phi;
                let value_7 = -T::from_f64(1f64);
                let value_8 = -product_4;
                out[place] = value_7;
                place += 1;
                out[place] = value_8;
                place += 1;
                out[place] = value_7;
                place += 1;
                out[place] = product_6;
                place += 1;
            }
            for at_i in 1..(self.n as i64) {
                let slots: [usize; 2] = [
                    3 * (first_link + (at_i - 1)) as usize,
                    3 * (first_link + at_i) as usize,
                ];
                let link_i_1_phi = q[slots[0] + 2];
                let (sin_link_i_1_phi, cos_link_i_1_phi) = T::sin_cos(link_i_1_phi);
                let product_4 = c[2usize] * sin_link_i_1_phi;
                let link_i_phi = q[slots[1] + 2];
                let (sin_link_i_phi, cos_link_i_phi) = T::sin_cos(link_i_phi);
                let product_7 = c[2usize] * sin_link_i_phi;
                let product_9 = c[2usize] * cos_link_i_1_phi;
                let product_11 = c[2usize] * cos_link_i_phi;
                let value_12 = -product_4;
                let value_13 = -T::from_f64(1f64);
                let value_14 = -product_7;
                out[place] = T::from_f64(1f64);
                place += 1;
                out[place] = value_12;
                place += 1;
                out[place] = value_13;
                place += 1;
                out[place] = value_14;
                place += 1;
                out[place] = T::from_f64(1f64);
                place += 1;
                out[place] = product_9;
                place += 1;
                out[place] = value_13;
                place += 1;
                out[place] = product_11;
                place += 1;
            }
        }
        fn convective_term(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
            let first_link: i64 = 0;
            let mut place = 0;
            {
                let slots: [usize; 1] = [3 * (first_link + 0) as usize];
                let link_0_omega = v[slots[0] + 2];
                let product_2 = c[2usize] * link_0_omega;
                let product_3 = link_0_omega * product_2;
                let link_0_phi = q[slots[0] + 2];
                let (sin_link_0_phi, cos_link_0_phi) = T::sin_cos(link_0_phi);
                let product_7 = product_3 * cos_link_0_phi;
                let product_9 = product_3 * sin_link_0_phi;
                let value_10 = -product_7;
                let value_11 = -product_9;
                out[place] = value_10;
                place += 1;
                out[place] = value_11;
                place += 1;
            }
            for at_i in 1..(self.n as i64) {
                let slots: [usize; 2] = [
                    3 * (first_link + (at_i - 1)) as usize,
                    3 * (first_link + at_i) as usize,
                ];
                let link_i_1_omega = v[slots[0] + 2];
                let product_3 = link_i_1_omega * link_i_1_omega;
                let link_i_1_phi = q[slots[0] + 2];
                let (sin_link_i_1_phi, cos_link_i_1_phi) = T::sin_cos(link_i_1_phi);
                let product_6 = product_3 * cos_link_i_1_phi;
                let link_i_omega = v[slots[1] + 2];
                let product_8 = link_i_omega * link_i_omega;
                let link_i_phi = q[slots[1] + 2];
                let (sin_link_i_phi, cos_link_i_phi) = T::sin_cos(link_i_phi);
                let sum_12 = T::fused(product_8, cos_link_i_phi, product_6);
                let product_14 = sum_12 * c[2usize];
                let product_16 = product_3 * sin_link_i_1_phi;
                let sum_19 = T::fused(product_8, sin_link_i_phi, product_16);
                let product_20 = c[2usize] * sum_19;
                let value_21 = -product_14;
                let value_22 = -product_20;
                out[place] = value_21;
                place += 1;
                out[place] = value_22;
                place += 1;
            }
        }
        fn applied_force(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
            let first_link: i64 = 0;
            let mut place = 0;
            out.fill(T::from_f64(0.0));
            for at_i in 0..(self.n as i64) {
                let slots: [usize; 1] = [3 * (first_link + at_i) as usize];
                let value_1 = -c[3usize];
                out[slots[0] + 1] = out[slots[0] + 1] + value_1;
            }
        }
    }
    #[automatically_derived]
    impl ::ezy_core::model::Scene for Swing {
        fn info(&self) -> &'static ::ezy_core::model::SceneInfo {
            static KNOWN: ::ezy_core::layout::Known = ::ezy_core::layout::Known::new();
            KNOWN.info(&Self::FIXED, &[self.n], |layout| self.describe(layout))
        }
        fn count(&self, index: usize) -> usize {
            match index {
                0usize => self.n,
                _ => 0,
            }
        }
        fn set_count(&mut self, index: usize, value: usize) {
            match index {
                0usize => self.n = value,
                _ => {}
            }
        }
        fn parameter(&self, index: usize) -> f64 {
            match index {
                0usize => self.l,
                1usize => self.m,
                2usize => self.g,
                _ => f64::NAN,
            }
        }
        fn set_parameter(&mut self, index: usize, value: f64) {
            match index {
                0usize => self.l = value,
                1usize => self.m = value,
                2usize => self.g = value,
                _ => {}
            }
        }
        fn power(
            &self,
            c: &[f64],
            t: f64,
            q: &[f64],
            v: &[f64],
            lambda: &[f64],
            out: &mut [f64],
        ) {
            let first_link: i64 = 0;
            out.fill(0.0);
            let mut place = 0;
        }
        fn potential_energy(&self, c: &[f64], t: f64, q: &[f64]) -> f64 {
            let first_link: i64 = 0;
            let mut total = 0.0;
            for at_i in 0..(self.n as i64) {
                let slots: [usize; 1] = [3 * (first_link + at_i) as usize];
                let link_i_y = q[slots[0] + 1];
                let product_2 = c[3usize] * link_i_y;
                total += product_2;
            }
            total
        }
        fn points(&self, c: &[f64], t: f64, q: &[f64], out: &mut [f64]) {
            let first_link: i64 = 0;
            let mut place = 0;
            {
                let slots: [usize; 0] = [];
                out[place] = 0f64;
                place += 1;
                out[place] = 0f64;
                place += 1;
            }
            {
                let slots: [usize; 1] = [
                    3 * (first_link + ((self.n as i64) - 1)) as usize,
                ];
                let link_n_1_x = q[slots[0] + 0];
                let link_n_1_phi = q[slots[0] + 2];
                let (sin_link_n_1_phi, cos_link_n_1_phi) = f64::sin_cos(link_n_1_phi);
                let product_6 = c[2usize] * cos_link_n_1_phi;
                let sum_7 = link_n_1_x + product_6;
                let link_n_1_y = q[slots[0] + 1];
                let product_10 = c[2usize] * sin_link_n_1_phi;
                let sum_11 = link_n_1_y + product_10;
                out[place] = sum_7;
                place += 1;
                out[place] = sum_11;
                place += 1;
            }
            for at_i in 1..(self.n as i64) {
                let slots: [usize; 1] = [3 * (first_link + (at_i - 1)) as usize];
                let link_i_1_x = q[slots[0] + 0];
                let link_i_1_phi = q[slots[0] + 2];
                let (sin_link_i_1_phi, cos_link_i_1_phi) = f64::sin_cos(link_i_1_phi);
                let product_6 = c[2usize] * cos_link_i_1_phi;
                let sum_7 = link_i_1_x + product_6;
                let link_i_1_y = q[slots[0] + 1];
                let product_10 = c[2usize] * sin_link_i_1_phi;
                let sum_11 = link_i_1_y + product_10;
                out[place] = sum_7;
                place += 1;
                out[place] = sum_11;
                place += 1;
            }
        }
        fn outputs(&self, c: &[f64], t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
            let first_link: i64 = 0;
            let mut place = 0;
            {
                let slots: [usize; 1] = [
                    3 * (first_link + ((self.n as i64) - 1)) as usize,
                ];
                let link_n_1_y = q[slots[0] + 1];
                let product_3 = c[4usize] * link_n_1_y;
                let link_n_1_phi = q[slots[0] + 2];
                let sin_link_n_1_phi = f64::sin(link_n_1_phi);
                let product_8 = c[5usize] * sin_link_n_1_phi;
                let sum_9 = product_3 + product_8;
                let value_10 = -sum_9;
                out[place] = value_10;
                place += 1;
            }
        }
        fn start(&self, c: &[f64], start: &mut ::ezy_core::model::Start) {
            let first_link: i64 = 0;
            for at_i in 0..(self.n as i64) {
                let slots: [usize; 1] = [3 * (first_link + at_i) as usize];
                start.give_position(slots[0] + 2, 0f64);
            }
        }
        fn series(&self) -> ::core::option::Option<&dyn ::ezy_core::model::Series<f64>> {
            ::core::option::Option::Some(self)
        }
        fn precise(
            &self,
        ) -> ::core::option::Option<&dyn ::ezy_core::model::PreciseScene> {
            ::core::option::Option::Some(self)
        }
    }
    #[automatically_derived]
    #[allow(unused_assignments, unused_mut)]
    impl<T: ::ezy_core::scalar::Scalar> ::ezy_core::model::Series<T> for Swing {
        fn series_size(&self) -> ::ezy_core::model::SeriesSize {
            let info = ::ezy_core::model::Scene::info(self);
            let mut size = ::ezy_core::model::SeriesSize {
                n_coordinates: info.n_coordinates(),
                n_rows: info.n_rows(),
                n_products: 0,
                n_base: 0,
                n_kept: 0,
            };
            {
                size.n_products += 4usize;
                size.n_base += 2usize;
                size.n_kept += 0usize;
            }
            for at_i in 1..(self.n as i64) {
                size.n_products += 8usize;
                size.n_base += 4usize;
                size.n_kept += 0usize;
            }
            for at_i in 0..(self.n as i64) {
                size.n_products += 0usize;
                size.n_base += 0usize;
                size.n_kept += 0usize;
            }
            size.n_products = size
                .n_products
                .next_multiple_of(::ezy_core::model::PRODUCT_GROUP);
            size
        }
        fn begin(
            &self,
            c: &[T],
            t: T,
            store: &mut ::ezy_core::model::SeriesStore<T>,
        ) -> ::ezy_core::model::DeficientRows {
            let first_link: i64 = 0;
            let ::ezy_core::model::SeriesStore {
                q,
                lambda,
                left,
                right,
                sums,
                kept,
                base,
                force,
                row,
                a,
            } = store;
            let (n_q, n_c, n_products) = (force.len(), row.len(), sums.len());
            let n_kept = if n_q == 0 { 0 } else { kept.len() / (q.len() / n_q) };
            let (mut row_place, mut product_place, mut base_place, mut kept_place) = (
                0,
                0,
                0,
                0,
            );
            let (q, v) = q[..2 * n_q].split_at(n_q);
            force.fill(T::from_f64(0f64));
            {
                let slots: [usize; 1] = [3 * (first_link + 0) as usize];
                let link_0_phi = q[slots[0] + 2];
                let (sin_link_0_phi, cos_link_0_phi) = T::sin_cos(link_0_phi);
                let link_0_omega = v[slots[0] + 2];
                let product_13 = c[2usize] * link_0_omega;
                let product_14 = link_0_omega * product_13;
                let product_15 = cos_link_0_phi * product_14;
                let product_16 = sin_link_0_phi * product_14;
                let product_17 = cos_link_0_phi * link_0_omega;
                let product_18 = sin_link_0_phi * link_0_omega;
                let value_19 = -product_18;
                base[base_place + 0] = cos_link_0_phi;
                base[base_place + 1] = sin_link_0_phi;
                force[slots[0] + 0] = force[slots[0] + 0] + T::from_f64(0f64);
                force[slots[0] + 1] = force[slots[0] + 1] + T::from_f64(0f64);
                force[slots[0] + 2] = force[slots[0] + 2] + T::from_f64(0f64);
                row[row_place + 0] = product_15;
                row[row_place + 1] = product_16;
                left[1 * n_products + product_place + 0] = product_17;
                right[1 * n_products + product_place + 0] = T::from_f64(0f64);
                left[1 * n_products + product_place + 1] = value_19;
                right[1 * n_products + product_place + 1] = T::from_f64(0f64);
                left[1 * n_products + product_place + 2] = link_0_omega;
                right[1 * n_products + product_place + 2] = product_17;
                left[1 * n_products + product_place + 3] = link_0_omega;
                right[1 * n_products + product_place + 3] = value_19;
                row_place += 2usize;
                product_place += 4usize;
                base_place += 2usize;
                kept_place += 0usize;
            }
            for at_i in 1..(self.n as i64) {
                let slots: [usize; 2] = [
                    3 * (first_link + (at_i - 1)) as usize,
                    3 * (first_link + at_i) as usize,
                ];
                let link_i_1_phi = q[slots[0] + 2];
                let (sin_link_i_1_phi, cos_link_i_1_phi) = T::sin_cos(link_i_1_phi);
                let link_i_phi = q[slots[1] + 2];
                let (sin_link_i_phi, cos_link_i_phi) = T::sin_cos(link_i_phi);
                let link_i_1_omega = v[slots[0] + 2];
                let product_22 = link_i_1_omega * link_i_1_omega;
                let product_23 = cos_link_i_1_phi * product_22;
                let link_i_omega = v[slots[1] + 2];
                let product_25 = link_i_omega * link_i_omega;
                let sum_27 = T::fused(cos_link_i_phi, product_25, product_23);
                let product_28 = c[2usize] * sum_27;
                let product_29 = sin_link_i_1_phi * product_22;
                let sum_31 = T::fused(sin_link_i_phi, product_25, product_29);
                let product_32 = c[2usize] * sum_31;
                let product_33 = cos_link_i_1_phi * link_i_1_omega;
                let product_34 = sin_link_i_1_phi * link_i_1_omega;
                let product_35 = cos_link_i_phi * link_i_omega;
                let product_36 = sin_link_i_phi * link_i_omega;
                let value_37 = -product_34;
                let value_38 = -product_36;
                base[base_place + 0] = cos_link_i_1_phi;
                base[base_place + 1] = sin_link_i_1_phi;
                base[base_place + 2] = cos_link_i_phi;
                base[base_place + 3] = sin_link_i_phi;
                force[slots[0] + 0] = force[slots[0] + 0] + T::from_f64(0f64);
                force[slots[0] + 1] = force[slots[0] + 1] + T::from_f64(0f64);
                force[slots[0] + 2] = force[slots[0] + 2] + T::from_f64(0f64);
                force[slots[1] + 0] = force[slots[1] + 0] + T::from_f64(0f64);
                force[slots[1] + 1] = force[slots[1] + 1] + T::from_f64(0f64);
                force[slots[1] + 2] = force[slots[1] + 2] + T::from_f64(0f64);
                row[row_place + 0] = product_28;
                row[row_place + 1] = product_32;
                left[1 * n_products + product_place + 0] = product_33;
                right[1 * n_products + product_place + 0] = T::from_f64(0f64);
                left[1 * n_products + product_place + 1] = value_37;
                right[1 * n_products + product_place + 1] = T::from_f64(0f64);
                left[1 * n_products + product_place + 2] = product_35;
                right[1 * n_products + product_place + 2] = T::from_f64(0f64);
                left[1 * n_products + product_place + 3] = value_38;
                right[1 * n_products + product_place + 3] = T::from_f64(0f64);
                left[1 * n_products + product_place + 4] = link_i_1_omega;
                right[1 * n_products + product_place + 4] = product_33;
                left[1 * n_products + product_place + 5] = link_i_omega;
                right[1 * n_products + product_place + 5] = product_35;
                left[1 * n_products + product_place + 6] = link_i_1_omega;
                right[1 * n_products + product_place + 6] = value_37;
                left[1 * n_products + product_place + 7] = link_i_omega;
                right[1 * n_products + product_place + 7] = value_38;
                row_place += 2usize;
                product_place += 8usize;
                base_place += 4usize;
                kept_place += 0usize;
            }
            for at_i in 0..(self.n as i64) {
                let slots: [usize; 1] = [3 * (first_link + at_i) as usize];
                let value_1 = -c[3usize];
                force[slots[0] + 1] = force[slots[0] + 1] + value_1;
                row_place += 0usize;
                product_place += 0usize;
                base_place += 0usize;
                kept_place += 0usize;
            }
            ::ezy_core::model::DeficientRows::ALL
        }
        fn right_side(
            &self,
            c: &[T],
            k: usize,
            store: &mut ::ezy_core::model::SeriesStore<T>,
        ) {
            let first_link: i64 = 0;
            let ::ezy_core::model::SeriesStore {
                q,
                lambda,
                left,
                right,
                sums,
                kept,
                base,
                force,
                row,
                a,
            } = store;
            let (n_q, n_c, n_products) = (force.len(), row.len(), sums.len());
            let n_kept = if n_q == 0 { 0 } else { kept.len() / (q.len() / n_q) };
            let (mut row_place, mut product_place, mut base_place, mut kept_place) = (
                0,
                0,
                0,
                0,
            );
            force.fill(T::from_f64(0f64));
            {
                let slots: [usize; 1] = [3 * (first_link + 0) as usize];
                let convolved_0 = sums[product_place + 0];
                let product_3 = c[2usize] * convolved_0;
                let convolved_1 = sums[product_place + 1];
                let difference_6 = T::fused(-c[2usize], convolved_1, product_3);
                let convolved_2 = sums[product_place + 2];
                let inverse_order_ahead = T::from_f64(1f64)
                    / T::from_f64((k + 2) as f64);
                let product_9 = convolved_2 * inverse_order_ahead;
                let product_10 = c[2usize] * product_9;
                let order_next = T::from_f64((k + 1) as f64);
                let order_ahead = T::from_f64((k + 2) as f64);
                let product_13 = order_next * order_ahead;
                let product_14 = product_10 * product_13;
                let convolved_3 = sums[product_place + 3];
                let product_16 = inverse_order_ahead * convolved_3;
                let product_17 = c[2usize] * product_16;
                let product_18 = product_13 * product_17;
                let value_19 = -product_18;
                force[slots[0] + 0] = force[slots[0] + 0] + T::from_f64(0f64);
                force[slots[0] + 1] = force[slots[0] + 1] + T::from_f64(0f64);
                force[slots[0] + 2] = force[slots[0] + 2] + difference_6;
                row[row_place + 0] = product_14;
                row[row_place + 1] = value_19;
                row_place += 2usize;
                product_place += 4usize;
                base_place += 2usize;
                kept_place += 0usize;
            }
            for at_i in 1..(self.n as i64) {
                let slots: [usize; 2] = [
                    3 * (first_link + (at_i - 1)) as usize,
                    3 * (first_link + at_i) as usize,
                ];
                let convolved_0 = sums[product_place + 0];
                let product_3 = c[2usize] * convolved_0;
                let convolved_1 = sums[product_place + 1];
                let difference_6 = T::fused(-c[2usize], convolved_1, product_3);
                let convolved_2 = sums[product_place + 2];
                let product_8 = c[2usize] * convolved_2;
                let convolved_3 = sums[product_place + 3];
                let difference_11 = T::fused(-c[2usize], convolved_3, product_8);
                let convolved_4 = sums[product_place + 4];
                let inverse_order_ahead = T::from_f64(1f64)
                    / T::from_f64((k + 2) as f64);
                let product_14 = convolved_4 * inverse_order_ahead;
                let convolved_5 = sums[product_place + 5];
                let sum_17 = T::fused(inverse_order_ahead, convolved_5, product_14);
                let product_18 = c[2usize] * sum_17;
                let order_next = T::from_f64((k + 1) as f64);
                let order_ahead = T::from_f64((k + 2) as f64);
                let product_21 = order_next * order_ahead;
                let product_22 = product_18 * product_21;
                let convolved_6 = sums[product_place + 6];
                let product_24 = inverse_order_ahead * convolved_6;
                let convolved_7 = sums[product_place + 7];
                let sum_27 = T::fused(inverse_order_ahead, convolved_7, product_24);
                let product_28 = c[2usize] * sum_27;
                let product_29 = product_21 * product_28;
                let value_30 = -product_29;
                force[slots[0] + 0] = force[slots[0] + 0] + T::from_f64(0f64);
                force[slots[0] + 1] = force[slots[0] + 1] + T::from_f64(0f64);
                force[slots[0] + 2] = force[slots[0] + 2] + difference_6;
                force[slots[1] + 0] = force[slots[1] + 0] + T::from_f64(0f64);
                force[slots[1] + 1] = force[slots[1] + 1] + T::from_f64(0f64);
                force[slots[1] + 2] = force[slots[1] + 2] + difference_11;
                row[row_place + 0] = product_22;
                row[row_place + 1] = value_30;
                row_place += 2usize;
                product_place += 8usize;
                base_place += 4usize;
                kept_place += 0usize;
            }
            for at_i in 0..(self.n as i64) {
                let slots: [usize; 1] = [3 * (first_link + at_i) as usize];
                force[slots[0] + 1] = force[slots[0] + 1] + T::from_f64(0f64);
                row_place += 0usize;
                product_place += 0usize;
                base_place += 0usize;
                kept_place += 0usize;
            }
        }
        fn solve(
            &self,
            c: &[T],
            k: usize,
            store: &mut ::ezy_core::model::SeriesStore<T>,
        ) {}
        fn finish(
            &self,
            c: &[T],
            k: usize,
            store: &mut ::ezy_core::model::SeriesStore<T>,
        ) {
            let first_link: i64 = 0;
            let ::ezy_core::model::SeriesStore {
                q,
                lambda,
                left,
                right,
                sums,
                kept,
                base,
                force,
                row,
                a,
            } = store;
            let (n_q, n_c, n_products) = (force.len(), row.len(), sums.len());
            let n_kept = if n_q == 0 { 0 } else { kept.len() / (q.len() / n_q) };
            let (mut row_place, mut product_place, mut base_place, mut kept_place) = (
                0,
                0,
                0,
                0,
            );
            let inverse = T::from_f64(1f64) / T::from_f64(((k + 1) * (k + 2)) as f64);
            q[(k + 2) * n_q..(k + 3) * n_q]
                .iter_mut()
                .zip(a.iter())
                .for_each(|(q, a)| *q = *a * inverse);
            {
                let slots: [usize; 1] = [3 * (first_link + 0) as usize];
                let lambda_0 = lambda[(k + 0) * n_c + row_place + 0];
                let convolved_3 = sums[product_place + 3];
                let inverse_order_ahead = T::from_f64(1f64)
                    / T::from_f64((k + 2) as f64);
                let product_5 = convolved_3 * inverse_order_ahead;
                let q_8_ahead = q[(k + 2) * n_q + slots[0] + 2];
                let base_0 = base[base_place + 0];
                let sum_9 = T::fused(q_8_ahead, base_0, product_5);
                let lambda_1 = lambda[(k + 0) * n_c + row_place + 1];
                let convolved_2 = sums[product_place + 2];
                let product_12 = inverse_order_ahead * convolved_2;
                let base_1 = base[base_place + 1];
                let sum_15 = T::fused(q_8_ahead, base_1, product_12);
                let order_ahead = T::from_f64((k + 2) as f64);
                let product_17 = q_8_ahead * order_ahead;
                let value_18 = -sum_15;
                left[(k + 2) * n_products + product_place + 0] = sum_9;
                right[(k + 2) * n_products + product_place + 0] = lambda_0;
                left[(k + 2) * n_products + product_place + 1] = value_18;
                right[(k + 2) * n_products + product_place + 1] = lambda_1;
                left[(k + 2) * n_products + product_place + 2] = product_17;
                right[(k + 2) * n_products + product_place + 2] = sum_9;
                left[(k + 2) * n_products + product_place + 3] = product_17;
                right[(k + 2) * n_products + product_place + 3] = value_18;
                row_place += 2usize;
                product_place += 4usize;
                base_place += 2usize;
                kept_place += 0usize;
            }
            for at_i in 1..(self.n as i64) {
                let slots: [usize; 2] = [
                    3 * (first_link + (at_i - 1)) as usize,
                    3 * (first_link + at_i) as usize,
                ];
                let lambda_0 = lambda[(k + 0) * n_c + row_place + 0];
                let convolved_6 = sums[product_place + 6];
                let inverse_order_ahead = T::from_f64(1f64)
                    / T::from_f64((k + 2) as f64);
                let product_5 = convolved_6 * inverse_order_ahead;
                let q_11_ahead = q[(k + 2) * n_q + slots[0] + 2];
                let base_0 = base[base_place + 0];
                let sum_9 = T::fused(q_11_ahead, base_0, product_5);
                let lambda_1 = lambda[(k + 0) * n_c + row_place + 1];
                let convolved_4 = sums[product_place + 4];
                let product_12 = inverse_order_ahead * convolved_4;
                let base_1 = base[base_place + 1];
                let sum_15 = T::fused(q_11_ahead, base_1, product_12);
                let convolved_7 = sums[product_place + 7];
                let product_17 = inverse_order_ahead * convolved_7;
                let q_14_ahead = q[(k + 2) * n_q + slots[1] + 2];
                let base_2 = base[base_place + 2];
                let sum_21 = T::fused(q_14_ahead, base_2, product_17);
                let convolved_5 = sums[product_place + 5];
                let product_23 = inverse_order_ahead * convolved_5;
                let base_3 = base[base_place + 3];
                let sum_26 = T::fused(q_14_ahead, base_3, product_23);
                let order_ahead = T::from_f64((k + 2) as f64);
                let product_28 = q_11_ahead * order_ahead;
                let product_29 = q_14_ahead * order_ahead;
                let value_30 = -sum_15;
                let value_31 = -sum_26;
                left[(k + 2) * n_products + product_place + 0] = sum_9;
                right[(k + 2) * n_products + product_place + 0] = lambda_0;
                left[(k + 2) * n_products + product_place + 1] = value_30;
                right[(k + 2) * n_products + product_place + 1] = lambda_1;
                left[(k + 2) * n_products + product_place + 2] = sum_21;
                right[(k + 2) * n_products + product_place + 2] = lambda_0;
                left[(k + 2) * n_products + product_place + 3] = value_31;
                right[(k + 2) * n_products + product_place + 3] = lambda_1;
                left[(k + 2) * n_products + product_place + 4] = product_28;
                right[(k + 2) * n_products + product_place + 4] = sum_9;
                left[(k + 2) * n_products + product_place + 5] = product_29;
                right[(k + 2) * n_products + product_place + 5] = sum_21;
                left[(k + 2) * n_products + product_place + 6] = product_28;
                right[(k + 2) * n_products + product_place + 6] = value_30;
                left[(k + 2) * n_products + product_place + 7] = product_29;
                right[(k + 2) * n_products + product_place + 7] = value_31;
                row_place += 2usize;
                product_place += 8usize;
                base_place += 4usize;
                kept_place += 0usize;
            }
            for at_i in 0..(self.n as i64) {
                let slots: [usize; 1] = [3 * (first_link + at_i) as usize];
                row_place += 0usize;
                product_place += 0usize;
                base_place += 0usize;
                kept_place += 0usize;
            }
        }
    }
    ///Released level and straight, with friction.
    ///
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct Settle {
        ///number of rods; default 10.
        pub n: usize,
        ///length of a rod (m); default `1.0`.
        pub l: f64,
        ///mass of a rod (kg); default `1.0`.
        pub m: f64,
        ///gravity, downwards (m/s^2); default `9.81`.
        pub g: f64,
        ///torque at a rate of one (N*m*s); default `0.1`.
        pub d: f64,
    }
    impl ::core::default::Default for Settle {
        fn default() -> Self {
            Self {
                n: 10,
                l: 1f64,
                m: 1f64,
                g: 9.81f64,
                d: 0.1f64,
            }
        }
    }
    impl Settle {
        /// What is known of the scene when it is compiled: everything but its sizes.
        const FIXED: ::ezy_core::model::SceneInfo = ::ezy_core::model::SceneInfo {
            model: "Chain",
            name: "settle",
            documentation: "Released level and straight, with friction.",
            bodies: &[],
            coordinates: &[],
            points: &[],
            rows: &[],
            n_position_rows: 0,
            parameters: &[
                ::ezy_core::model::ParameterInfo {
                    name: "l",
                    unit: "m",
                    default: 1f64,
                    default_text: "1.0",
                    documentation: "length of a rod",
                    effect: ::core::option::Option::None,
                    symbol: ::ezy_core::model::Formula {
                        text: "l",
                        latex: "l",
                        mathml: "<mi>l</mi>",
                    },
                },
                ::ezy_core::model::ParameterInfo {
                    name: "m",
                    unit: "kg",
                    default: 1f64,
                    default_text: "1.0",
                    documentation: "mass of a rod",
                    effect: ::core::option::Option::None,
                    symbol: ::ezy_core::model::Formula {
                        text: "m",
                        latex: "m",
                        mathml: "<mi>m</mi>",
                    },
                },
                ::ezy_core::model::ParameterInfo {
                    name: "g",
                    unit: "m/s^2",
                    default: 9.81f64,
                    default_text: "9.81",
                    documentation: "gravity, downwards",
                    effect: ::core::option::Option::None,
                    symbol: ::ezy_core::model::Formula {
                        text: "g",
                        latex: "g",
                        mathml: "<mi>g</mi>",
                    },
                },
                ::ezy_core::model::ParameterInfo {
                    name: "d",
                    unit: "N*m*s",
                    default: 0.1f64,
                    default_text: "0.1",
                    documentation: "torque at a rate of one",
                    effect: ::core::option::Option::Some("friction_in_hinges"),
                    symbol: ::ezy_core::model::Formula {
                        text: "d",
                        latex: "d",
                        mathml: "<mi>d</mi>",
                    },
                },
            ],
            inputs: &[],
            outputs: &[],
            effects: &[
                ::ezy_core::model::EffectInfo {
                    name: "friction_in_hinges",
                    documentation: "Every hinge resists its rate.",
                },
            ],
            until_s: 1f64,
            n_constants: 8usize,
            jacobian: ::ezy_core::model::SparsityPattern {
                starts: &[0],
                columns: &[],
            },
            jacobian_entries: &[],
            mass_entries: &[],
            force_entries: &[],
            potential_energy: ::ezy_core::model::Formula {
                text: "0",
                latex: "0",
                mathml: "<mn>0</mn>",
            },
            abbreviations: &[],
            elimination: &[],
            acceleration_operations: ::ezy_core::model::Operations {
                add: 0,
                mul: 0,
                div: 0,
                trig: 0,
                calls: 0,
            },
            correction_operations: ::ezy_core::model::Operations {
                add: 0,
                mul: 0,
                div: 0,
                trig: 0,
                calls: 0,
            },
            series: ::ezy_core::model::SeriesInfo::Analytic {
                n_products: 12usize,
                operations: ::ezy_core::model::Operations {
                    add: 19usize,
                    mul: 42usize,
                    div: 0usize,
                    trig: 0usize,
                    calls: 0usize,
                },
            },
            repeats: ::core::option::Option::Some(::ezy_core::model::Repeats {
                counts: &[
                    ::ezy_core::model::CountInfo {
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
        const TEMPLATES: &'static [::ezy_core::model::TemplateInfo] = &[
            ::ezy_core::model::TemplateInfo {
                name: "link",
                word: "body",
                ranges: &["i in 0..n"],
                effect: ::core::option::Option::None,
                rows: &[],
                forces: &[],
                masses: &[
                    (
                        ::ezy_core::model::SlotCoordinate {
                            slot: 0,
                            component: 0usize,
                            symbol: ::ezy_core::model::Formula {
                                text: "link[i].x",
                                latex: "x_{\\mathrm{link[i]}}",
                                mathml: "<msub><mi>x</mi><mtext>link[i]</mtext></msub>",
                            },
                        },
                        ::ezy_core::model::Formula {
                            text: "m",
                            latex: "m",
                            mathml: "<mrow><mi>m</mi></mrow>",
                        },
                    ),
                    (
                        ::ezy_core::model::SlotCoordinate {
                            slot: 0,
                            component: 1usize,
                            symbol: ::ezy_core::model::Formula {
                                text: "link[i].y",
                                latex: "y_{\\mathrm{link[i]}}",
                                mathml: "<msub><mi>y</mi><mtext>link[i]</mtext></msub>",
                            },
                        },
                        ::ezy_core::model::Formula {
                            text: "m",
                            latex: "m",
                            mathml: "<mrow><mi>m</mi></mrow>",
                        },
                    ),
                    (
                        ::ezy_core::model::SlotCoordinate {
                            slot: 0,
                            component: 2usize,
                            symbol: ::ezy_core::model::Formula {
                                text: "link[i].phi",
                                latex: "\\varphi_{\\mathrm{link[i]}}",
                                mathml: "<msub><mi>φ</mi><mtext>link[i]</mtext></msub>",
                            },
                        },
                        ::ezy_core::model::Formula {
                            text: "m*l^2/12",
                            latex: "\\frac{m \\, l^{2}}{12}",
                            mathml: "<mrow><mfrac><mrow><mi>m</mi><mspace width=\"0.17em\"/><msup><mrow><mi>l</mi></mrow><mn>2</mn></msup></mrow><mrow><mn>12</mn></mrow></mfrac></mrow>",
                        },
                    ),
                ],
            },
            ::ezy_core::model::TemplateInfo {
                name: "top",
                word: "hinge",
                ranges: &[],
                effect: ::core::option::Option::None,
                rows: &[
                    ::ezy_core::model::RowTemplate {
                        suffix: ".x",
                        row: ::ezy_core::model::RowInfo {
                            name: "top.x",
                            kind: "hinge",
                            multiplier_unit: "N",
                            constraint: ::ezy_core::model::Formula {
                                text: "-link[0].x + l*cos(link[0].phi)/2",
                                latex: "-x_{\\mathrm{link[0]}} + \\frac{l \\, \\cos{\\varphi_{\\mathrm{link[0]}}}}{2}",
                                mathml: "<mrow><mo>−</mo><msub><mi>x</mi><mtext>link[0]</mtext></msub><mo>+</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[0]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow>",
                            },
                            convective_term: ::ezy_core::model::Formula {
                                text: "-l*link[0].omega^2*cos(link[0].phi)/2",
                                latex: "-\\frac{l \\, \\dot{\\varphi}_{\\mathrm{link[0]}}^{2} \\, \\cos{\\varphi_{\\mathrm{link[0]}}}}{2}",
                                mathml: "<mrow><mo>−</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>link[0]</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[0]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow>",
                            },
                        },
                        position: true,
                        entries: &[
                            (
                                ::ezy_core::model::SlotCoordinate {
                                    slot: 0usize,
                                    component: 0usize,
                                    symbol: ::ezy_core::model::Formula {
                                        text: "link[0].x",
                                        latex: "x_{\\mathrm{link[0]}}",
                                        mathml: "<msub><mi>x</mi><mtext>link[0]</mtext></msub>",
                                    },
                                },
                                ::ezy_core::model::Formula {
                                    text: "-1",
                                    latex: "-1",
                                    mathml: "<mrow><mo>−</mo><mn>1</mn></mrow>",
                                },
                            ),
                            (
                                ::ezy_core::model::SlotCoordinate {
                                    slot: 0usize,
                                    component: 2usize,
                                    symbol: ::ezy_core::model::Formula {
                                        text: "link[0].phi",
                                        latex: "\\varphi_{\\mathrm{link[0]}}",
                                        mathml: "<msub><mi>φ</mi><mtext>link[0]</mtext></msub>",
                                    },
                                },
                                ::ezy_core::model::Formula {
                                    text: "-l*sin(link[0].phi)/2",
                                    latex: "-\\frac{l \\, \\sin{\\varphi_{\\mathrm{link[0]}}}}{2}",
                                    mathml: "<mrow><mo>−</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[0]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow>",
                                },
                            ),
                        ],
                    },
                    ::ezy_core::model::RowTemplate {
                        suffix: ".y",
                        row: ::ezy_core::model::RowInfo {
                            name: "top.y",
                            kind: "hinge",
                            multiplier_unit: "N",
                            constraint: ::ezy_core::model::Formula {
                                text: "-link[0].y + l*sin(link[0].phi)/2",
                                latex: "-y_{\\mathrm{link[0]}} + \\frac{l \\, \\sin{\\varphi_{\\mathrm{link[0]}}}}{2}",
                                mathml: "<mrow><mo>−</mo><msub><mi>y</mi><mtext>link[0]</mtext></msub><mo>+</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[0]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow>",
                            },
                            convective_term: ::ezy_core::model::Formula {
                                text: "-l*link[0].omega^2*sin(link[0].phi)/2",
                                latex: "-\\frac{l \\, \\dot{\\varphi}_{\\mathrm{link[0]}}^{2} \\, \\sin{\\varphi_{\\mathrm{link[0]}}}}{2}",
                                mathml: "<mrow><mo>−</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>link[0]</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[0]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow>",
                            },
                        },
                        position: true,
                        entries: &[
                            (
                                ::ezy_core::model::SlotCoordinate {
                                    slot: 0usize,
                                    component: 1usize,
                                    symbol: ::ezy_core::model::Formula {
                                        text: "link[0].y",
                                        latex: "y_{\\mathrm{link[0]}}",
                                        mathml: "<msub><mi>y</mi><mtext>link[0]</mtext></msub>",
                                    },
                                },
                                ::ezy_core::model::Formula {
                                    text: "-1",
                                    latex: "-1",
                                    mathml: "<mrow><mo>−</mo><mn>1</mn></mrow>",
                                },
                            ),
                            (
                                ::ezy_core::model::SlotCoordinate {
                                    slot: 0usize,
                                    component: 2usize,
                                    symbol: ::ezy_core::model::Formula {
                                        text: "link[0].phi",
                                        latex: "\\varphi_{\\mathrm{link[0]}}",
                                        mathml: "<msub><mi>φ</mi><mtext>link[0]</mtext></msub>",
                                    },
                                },
                                ::ezy_core::model::Formula {
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
            ::ezy_core::model::TemplateInfo {
                name: "pin",
                word: "hinge",
                ranges: &["i in 1..n"],
                effect: ::core::option::Option::None,
                rows: &[
                    ::ezy_core::model::RowTemplate {
                        suffix: ".x",
                        row: ::ezy_core::model::RowInfo {
                            name: "pin[i].x",
                            kind: "hinge",
                            multiplier_unit: "N",
                            constraint: ::ezy_core::model::Formula {
                                text: "link[i-1].x + l*cos(link[i-1].phi)/2 - link[i].x + l*cos(link[i].phi)/2",
                                latex: "x_{\\mathrm{link[i-1]}} + \\frac{l \\, \\cos{\\varphi_{\\mathrm{link[i-1]}}}}{2} - x_{\\mathrm{link[i]}} + \\frac{l \\, \\cos{\\varphi_{\\mathrm{link[i]}}}}{2}",
                                mathml: "<mrow><msub><mi>x</mi><mtext>link[i-1]</mtext></msub><mo>+</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[i-1]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac><mo>−</mo><msub><mi>x</mi><mtext>link[i]</mtext></msub><mo>+</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[i]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow>",
                            },
                            convective_term: ::ezy_core::model::Formula {
                                text: "-l*link[i-1].omega^2*cos(link[i-1].phi)/2 - l*link[i].omega^2*cos(link[i].phi)/2",
                                latex: "-\\frac{l \\, \\dot{\\varphi}_{\\mathrm{link[i-1]}}^{2} \\, \\cos{\\varphi_{\\mathrm{link[i-1]}}}}{2} - \\frac{l \\, \\dot{\\varphi}_{\\mathrm{link[i]}}^{2} \\, \\cos{\\varphi_{\\mathrm{link[i]}}}}{2}",
                                mathml: "<mrow><mo>−</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>link[i-1]</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[i-1]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac><mo>−</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>link[i]</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[i]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow>",
                            },
                        },
                        position: true,
                        entries: &[
                            (
                                ::ezy_core::model::SlotCoordinate {
                                    slot: 0usize,
                                    component: 0usize,
                                    symbol: ::ezy_core::model::Formula {
                                        text: "link[i-1].x",
                                        latex: "x_{\\mathrm{link[i-1]}}",
                                        mathml: "<msub><mi>x</mi><mtext>link[i-1]</mtext></msub>",
                                    },
                                },
                                ::ezy_core::model::Formula {
                                    text: "1",
                                    latex: "1",
                                    mathml: "<mrow><mn>1</mn></mrow>",
                                },
                            ),
                            (
                                ::ezy_core::model::SlotCoordinate {
                                    slot: 0usize,
                                    component: 2usize,
                                    symbol: ::ezy_core::model::Formula {
                                        text: "link[i-1].phi",
                                        latex: "\\varphi_{\\mathrm{link[i-1]}}",
                                        mathml: "<msub><mi>φ</mi><mtext>link[i-1]</mtext></msub>",
                                    },
                                },
                                ::ezy_core::model::Formula {
                                    text: "-l*sin(link[i-1].phi)/2",
                                    latex: "-\\frac{l \\, \\sin{\\varphi_{\\mathrm{link[i-1]}}}}{2}",
                                    mathml: "<mrow><mo>−</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[i-1]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow>",
                                },
                            ),
                            (
                                ::ezy_core::model::SlotCoordinate {
                                    slot: 1usize,
                                    component: 0usize,
                                    symbol: ::ezy_core::model::Formula {
                                        text: "link[i].x",
                                        latex: "x_{\\mathrm{link[i]}}",
                                        mathml: "<msub><mi>x</mi><mtext>link[i]</mtext></msub>",
                                    },
                                },
                                ::ezy_core::model::Formula {
                                    text: "-1",
                                    latex: "-1",
                                    mathml: "<mrow><mo>−</mo><mn>1</mn></mrow>",
                                },
                            ),
                            (
                                ::ezy_core::model::SlotCoordinate {
                                    slot: 1usize,
                                    component: 2usize,
                                    symbol: ::ezy_core::model::Formula {
                                        text: "link[i].phi",
                                        latex: "\\varphi_{\\mathrm{link[i]}}",
                                        mathml: "<msub><mi>φ</mi><mtext>link[i]</mtext></msub>",
                                    },
                                },
                                ::ezy_core::model::Formula {
                                    text: "-l*sin(link[i].phi)/2",
                                    latex: "-\\frac{l \\, \\sin{\\varphi_{\\mathrm{link[i]}}}}{2}",
                                    mathml: "<mrow><mo>−</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[i]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow>",
                                },
                            ),
                        ],
                    },
                    ::ezy_core::model::RowTemplate {
                        suffix: ".y",
                        row: ::ezy_core::model::RowInfo {
                            name: "pin[i].y",
                            kind: "hinge",
                            multiplier_unit: "N",
                            constraint: ::ezy_core::model::Formula {
                                text: "link[i-1].y + l*sin(link[i-1].phi)/2 - link[i].y + l*sin(link[i].phi)/2",
                                latex: "y_{\\mathrm{link[i-1]}} + \\frac{l \\, \\sin{\\varphi_{\\mathrm{link[i-1]}}}}{2} - y_{\\mathrm{link[i]}} + \\frac{l \\, \\sin{\\varphi_{\\mathrm{link[i]}}}}{2}",
                                mathml: "<mrow><msub><mi>y</mi><mtext>link[i-1]</mtext></msub><mo>+</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[i-1]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac><mo>−</mo><msub><mi>y</mi><mtext>link[i]</mtext></msub><mo>+</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[i]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow>",
                            },
                            convective_term: ::ezy_core::model::Formula {
                                text: "-l*link[i-1].omega^2*sin(link[i-1].phi)/2 - l*link[i].omega^2*sin(link[i].phi)/2",
                                latex: "-\\frac{l \\, \\dot{\\varphi}_{\\mathrm{link[i-1]}}^{2} \\, \\sin{\\varphi_{\\mathrm{link[i-1]}}}}{2} - \\frac{l \\, \\dot{\\varphi}_{\\mathrm{link[i]}}^{2} \\, \\sin{\\varphi_{\\mathrm{link[i]}}}}{2}",
                                mathml: "<mrow><mo>−</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>link[i-1]</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[i-1]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac><mo>−</mo><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>link[i]</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[i]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow>",
                            },
                        },
                        position: true,
                        entries: &[
                            (
                                ::ezy_core::model::SlotCoordinate {
                                    slot: 0usize,
                                    component: 1usize,
                                    symbol: ::ezy_core::model::Formula {
                                        text: "link[i-1].y",
                                        latex: "y_{\\mathrm{link[i-1]}}",
                                        mathml: "<msub><mi>y</mi><mtext>link[i-1]</mtext></msub>",
                                    },
                                },
                                ::ezy_core::model::Formula {
                                    text: "1",
                                    latex: "1",
                                    mathml: "<mrow><mn>1</mn></mrow>",
                                },
                            ),
                            (
                                ::ezy_core::model::SlotCoordinate {
                                    slot: 0usize,
                                    component: 2usize,
                                    symbol: ::ezy_core::model::Formula {
                                        text: "link[i-1].phi",
                                        latex: "\\varphi_{\\mathrm{link[i-1]}}",
                                        mathml: "<msub><mi>φ</mi><mtext>link[i-1]</mtext></msub>",
                                    },
                                },
                                ::ezy_core::model::Formula {
                                    text: "l*cos(link[i-1].phi)/2",
                                    latex: "\\frac{l \\, \\cos{\\varphi_{\\mathrm{link[i-1]}}}}{2}",
                                    mathml: "<mrow><mfrac><mrow><mi>l</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>link[i-1]</mtext></msub></mrow></mrow><mrow><mn>2</mn></mrow></mfrac></mrow>",
                                },
                            ),
                            (
                                ::ezy_core::model::SlotCoordinate {
                                    slot: 1usize,
                                    component: 1usize,
                                    symbol: ::ezy_core::model::Formula {
                                        text: "link[i].y",
                                        latex: "y_{\\mathrm{link[i]}}",
                                        mathml: "<msub><mi>y</mi><mtext>link[i]</mtext></msub>",
                                    },
                                },
                                ::ezy_core::model::Formula {
                                    text: "-1",
                                    latex: "-1",
                                    mathml: "<mrow><mo>−</mo><mn>1</mn></mrow>",
                                },
                            ),
                            (
                                ::ezy_core::model::SlotCoordinate {
                                    slot: 1usize,
                                    component: 2usize,
                                    symbol: ::ezy_core::model::Formula {
                                        text: "link[i].phi",
                                        latex: "\\varphi_{\\mathrm{link[i]}}",
                                        mathml: "<msub><mi>φ</mi><mtext>link[i]</mtext></msub>",
                                    },
                                },
                                ::ezy_core::model::Formula {
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
            ::ezy_core::model::TemplateInfo {
                name: "",
                word: "gravity",
                ranges: &["i in 0..n"],
                effect: ::core::option::Option::None,
                rows: &[],
                forces: &[
                    (
                        ::ezy_core::model::SlotCoordinate {
                            slot: 0usize,
                            component: 1usize,
                            symbol: ::ezy_core::model::Formula {
                                text: "link[i].y",
                                latex: "y_{\\mathrm{link[i]}}",
                                mathml: "<msub><mi>y</mi><mtext>link[i]</mtext></msub>",
                            },
                        },
                        ::ezy_core::model::Formula {
                            text: "-m*g",
                            latex: "-m \\, g",
                            mathml: "<mrow><mo>−</mo><mi>m</mi><mspace width=\"0.17em\"/><mi>g</mi></mrow>",
                        },
                    ),
                ],
                masses: &[],
            },
            ::ezy_core::model::TemplateInfo {
                name: "",
                word: "torque",
                ranges: &[],
                effect: ::core::option::Option::Some("friction_in_hinges"),
                rows: &[],
                forces: &[
                    (
                        ::ezy_core::model::SlotCoordinate {
                            slot: 0usize,
                            component: 2usize,
                            symbol: ::ezy_core::model::Formula {
                                text: "link[0].phi",
                                latex: "\\varphi_{\\mathrm{link[0]}}",
                                mathml: "<msub><mi>φ</mi><mtext>link[0]</mtext></msub>",
                            },
                        },
                        ::ezy_core::model::Formula {
                            text: "-d*link[0].omega",
                            latex: "-d \\, \\dot{\\varphi}_{\\mathrm{link[0]}}",
                            mathml: "<mrow><mo>−</mo><mi>d</mi><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>link[0]</mtext></msub></mrow>",
                        },
                    ),
                ],
                masses: &[],
            },
            ::ezy_core::model::TemplateInfo {
                name: "",
                word: "torque",
                ranges: &["i in 1..n"],
                effect: ::core::option::Option::Some("friction_in_hinges"),
                rows: &[],
                forces: &[
                    (
                        ::ezy_core::model::SlotCoordinate {
                            slot: 0usize,
                            component: 2usize,
                            symbol: ::ezy_core::model::Formula {
                                text: "link[i].phi",
                                latex: "\\varphi_{\\mathrm{link[i]}}",
                                mathml: "<msub><mi>φ</mi><mtext>link[i]</mtext></msub>",
                            },
                        },
                        ::ezy_core::model::Formula {
                            text: "-d*link[i].omega + d*link[i-1].omega",
                            latex: "-d \\, \\dot{\\varphi}_{\\mathrm{link[i]}} + d \\, \\dot{\\varphi}_{\\mathrm{link[i-1]}}",
                            mathml: "<mrow><mo>−</mo><mi>d</mi><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>link[i]</mtext></msub><mo>+</mo><mi>d</mi><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>link[i-1]</mtext></msub></mrow>",
                        },
                    ),
                    (
                        ::ezy_core::model::SlotCoordinate {
                            slot: 1usize,
                            component: 2usize,
                            symbol: ::ezy_core::model::Formula {
                                text: "link[i-1].phi",
                                latex: "\\varphi_{\\mathrm{link[i-1]}}",
                                mathml: "<msub><mi>φ</mi><mtext>link[i-1]</mtext></msub>",
                            },
                        },
                        ::ezy_core::model::Formula {
                            text: "d*link[i].omega - d*link[i-1].omega",
                            latex: "d \\, \\dot{\\varphi}_{\\mathrm{link[i]}} - d \\, \\dot{\\varphi}_{\\mathrm{link[i-1]}}",
                            mathml: "<mrow><mi>d</mi><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>link[i]</mtext></msub><mo>−</mo><mi>d</mi><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>link[i-1]</mtext></msub></mrow>",
                        },
                    ),
                ],
                masses: &[],
            },
            ::ezy_core::model::TemplateInfo {
                name: "top",
                word: "point",
                ranges: &[],
                effect: ::core::option::Option::None,
                rows: &[],
                forces: &[],
                masses: &[],
            },
            ::ezy_core::model::TemplateInfo {
                name: "tip",
                word: "point",
                ranges: &[],
                effect: ::core::option::Option::None,
                rows: &[],
                forces: &[],
                masses: &[],
            },
            ::ezy_core::model::TemplateInfo {
                name: "pin",
                word: "point",
                ranges: &["i in 1..n"],
                effect: ::core::option::Option::None,
                rows: &[],
                forces: &[],
                masses: &[],
            },
            ::ezy_core::model::TemplateInfo {
                name: "sag",
                word: "output",
                ranges: &[],
                effect: ::core::option::Option::None,
                rows: &[],
                forces: &[],
                masses: &[],
            },
            ::ezy_core::model::TemplateInfo {
                name: "",
                word: "start",
                ranges: &["i in 0..n"],
                effect: ::core::option::Option::None,
                rows: &[],
                forces: &[],
                masses: &[],
            },
        ];
        fn describe(&self, layout: &mut ::ezy_core::layout::Layout) {
            let lengths_link: &[usize] = &[
                usize::try_from((self.n as i64)).unwrap_or(0),
            ];
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
                    layout
                        .member(
                            &Self::TEMPLATES[2usize],
                            at,
                            bodies_link,
                            &[(at_i - 1)],
                        ),
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
                let slots: [usize; 1] = [
                    layout.member(&Self::TEMPLATES[4usize], at, bodies_link, &[0]),
                ];
            }
            for at_i in layout.range(1, (self.n as i64)) {
                let at: &[i64] = &[at_i];
                let slots: [usize; 2] = [
                    layout.member(&Self::TEMPLATES[5usize], at, bodies_link, &[at_i]),
                    layout
                        .member(&Self::TEMPLATES[5usize], at, bodies_link, &[(at_i - 1)]),
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
                            &Self::TEMPLATES[7usize],
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
                    layout
                        .member(&Self::TEMPLATES[8usize], at, bodies_link, &[(at_i - 1)]),
                ];
                layout.point("pin", at, ::core::option::Option::Some(slots[0usize]));
            }
            {
                let at: &[i64] = &[];
                let slots: [usize; 1] = [
                    layout
                        .member(
                            &Self::TEMPLATES[9usize],
                            at,
                            bodies_link,
                            &[((self.n as i64) - 1)],
                        ),
                ];
                const OUTPUT: ::ezy_core::model::OutputInfo = ::ezy_core::model::OutputInfo {
                    name: "sag",
                    unit: "1",
                    documentation: "How low the tip is, as part of the whole length.",
                    formula: ::ezy_core::model::Formula {
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
                    layout.member(&Self::TEMPLATES[10usize], at, bodies_link, &[at_i]),
                ];
            }
        }
    }
    #[automatically_derived]
    impl<T: ::ezy_core::scalar::Scalar> ::ezy_core::model::Equations<T>
    for self::Settle {
        fn constants(&self, parameters: &[T], c: &mut [T]) {
            let parameters = ::ezy_core::kernel::array::<4usize, T>(parameters);
            let c = ::ezy_core::kernel::array_mut::<8usize, T>(c);
            let k1 = T::from_f64(1f64);
            let parameter_m = parameters[1usize];
            let parameter_l = parameters[0usize];
            let k4 = T::from_f64(2f64);
            let k5 = parameter_l * parameter_l;
            let k6 = parameter_m * k5;
            let k7 = T::from_f64(12f64);
            let k9 = k6 / k7;
            let parameter_g = parameters[2usize];
            let k11 = parameter_m * parameter_g;
            let parameter_d = parameters[3usize];
            let k13 = parameter_d + parameter_d;
            let k15 = parameter_l / k4;
            let k16 = T::from_f64(self.n as f64);
            let k17 = k16 * parameter_l;
            let k18 = k1 / k17;
            let k19 = k15 / k17;
            c[0usize] = parameter_m;
            c[1usize] = k9;
            c[2usize] = k15;
            c[3usize] = k11;
            c[4usize] = parameter_d;
            c[5usize] = k18;
            c[6usize] = k19;
            c[7usize] = k13;
        }
        fn mass_matrix(&self, c: &[T], m: &mut [T]) {
            let mut place = 0;
            for _ in 0..(self.n as i64) {
                m[place] = c[0usize];
                place += 1;
                m[place] = c[0usize];
                place += 1;
                m[place] = c[1usize];
                place += 1;
            }
        }
        fn position_constraint(&self, c: &[T], t: T, q: &[T], out: &mut [T]) {
            let first_link: i64 = 0;
            let mut place = 0;
            {
                let slots: [usize; 1] = [3 * (first_link + 0) as usize];
                let link_0_x = q[slots[0] + 0];
                let link_0_phi = q[slots[0] + 2];
                let (sin_link_0_phi, cos_link_0_phi) = T::sin_cos(link_0_phi);
                let difference_7 = T::fused(c[2usize], cos_link_0_phi, -link_0_x);
                let link_0_y = q[slots[0] + 1];
                let difference_11 = T::fused(c[2usize], sin_link_0_phi, -link_0_y);
                out[place] = difference_7;
                place += 1;
                out[place] = difference_11;
                place += 1;
            }
            for at_i in 1..(self.n as i64) {
                let slots: [usize; 2] = [
                    3 * (first_link + (at_i - 1)) as usize,
                    3 * (first_link + at_i) as usize,
                ];
                let link_i_1_phi = q[slots[0] + 2];
                let (sin_link_i_1_phi, cos_link_i_1_phi) = T::sin_cos(link_i_1_phi);
                let link_i_phi = q[slots[1] + 2];
                let (sin_link_i_phi, cos_link_i_phi) = T::sin_cos(link_i_phi);
                let sum_6 = cos_link_i_1_phi + cos_link_i_phi;
                let link_i_1_x = q[slots[0] + 0];
                let sum_10 = T::fused(sum_6, c[2usize], link_i_1_x);
                let link_i_x = q[slots[1] + 0];
                let difference_12 = sum_10 - link_i_x;
                let sum_15 = sin_link_i_1_phi + sin_link_i_phi;
                let link_i_1_y = q[slots[0] + 1];
                let sum_18 = T::fused(c[2usize], sum_15, link_i_1_y);
                let link_i_y = q[slots[1] + 1];
                let difference_20 = sum_18 - link_i_y;
                out[place] = difference_12;
                place += 1;
                out[place] = difference_20;
                place += 1;
            }
        }
        fn velocity_constraint(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
            let first_link: i64 = 0;
            let mut place = 0;
            {
                let slots: [usize; 1] = [3 * (first_link + 0) as usize];
                let link_0_vx = v[slots[0] + 0];
                let link_0_omega = v[slots[0] + 2];
                let product_5 = c[2usize] * link_0_omega;
                let link_0_phi = q[slots[0] + 2];
                let (sin_link_0_phi, cos_link_0_phi) = T::sin_cos(link_0_phi);
                let sum_9 = T::fused(product_5, sin_link_0_phi, link_0_vx);
                let link_0_vy = v[slots[0] + 1];
                let difference_13 = T::fused(product_5, cos_link_0_phi, -link_0_vy);
                let value_14 = -sum_9;
                out[place] = value_14;
                place += 1;
                out[place] = difference_13;
                place += 1;
            }
            for at_i in 1..(self.n as i64) {
                let slots: [usize; 2] = [
                    3 * (first_link + (at_i - 1)) as usize,
                    3 * (first_link + at_i) as usize,
                ];
                let link_i_1_omega = v[slots[0] + 2];
                let link_i_1_phi = q[slots[0] + 2];
                let (sin_link_i_1_phi, cos_link_i_1_phi) = T::sin_cos(link_i_1_phi);
                let product_5 = link_i_1_omega * sin_link_i_1_phi;
                let link_i_omega = v[slots[1] + 2];
                let link_i_phi = q[slots[1] + 2];
                let (sin_link_i_phi, cos_link_i_phi) = T::sin_cos(link_i_phi);
                let sum_10 = T::fused(link_i_omega, sin_link_i_phi, product_5);
                let link_i_1_vx = v[slots[0] + 0];
                let difference_14 = T::fused(-sum_10, c[2usize], link_i_1_vx);
                let link_i_vx = v[slots[1] + 0];
                let difference_16 = difference_14 - link_i_vx;
                let product_18 = link_i_1_omega * cos_link_i_1_phi;
                let sum_21 = T::fused(link_i_omega, cos_link_i_phi, product_18);
                let link_i_1_vy = v[slots[0] + 1];
                let sum_24 = T::fused(c[2usize], sum_21, link_i_1_vy);
                let link_i_vy = v[slots[1] + 1];
                let difference_26 = sum_24 - link_i_vy;
                out[place] = difference_16;
                place += 1;
                out[place] = difference_26;
                place += 1;
            }
        }
        fn velocity_jacobian(&self, c: &[T], t: T, q: &[T], out: &mut [T]) {
            let first_link: i64 = 0;
            let mut place = 0;
            {
                let slots: [usize; 1] = [3 * (first_link + 0) as usize];
                let link_0_phi = q[slots[0] + 2];
                let (sin_link_0_phi, cos_link_0_phi) = T::sin_cos(link_0_phi);
                let product_4 = c[2usize] * sin_link_0_phi;
                let product_6 = c[2usize] * cos_link_0_phi;
                let value_7 = -T::from_f64(1f64);
                let value_8 = -product_4;
                out[place] = value_7;
                place += 1;
                out[place] = value_8;
                place += 1;
                out[place] = value_7;
                place += 1;
                out[place] = product_6;
                place += 1;
            }
            for at_i in 1..(self.n as i64) {
                let slots: [usize; 2] = [
                    3 * (first_link + (at_i - 1)) as usize,
                    3 * (first_link + at_i) as usize,
                ];
                let link_i_1_phi = q[slots[0] + 2];
                let (sin_link_i_1_phi, cos_link_i_1_phi) = T::sin_cos(link_i_1_phi);
                let product_4 = c[2usize] * sin_link_i_1_phi;
                let link_i_phi = q[slots[1] + 2];
                let (sin_link_i_phi, cos_link_i_phi) = T::sin_cos(link_i_phi);
                let product_7 = c[2usize] * sin_link_i_phi;
                let product_9 = c[2usize] * cos_link_i_1_phi;
                let product_11 = c[2usize] * cos_link_i_phi;
                let value_12 = -product_4;
                let value_13 = -T::from_f64(1f64);
                let value_14 = -product_7;
                out[place] = T::from_f64(1f64);
                place += 1;
                out[place] = value_12;
                place += 1;
                out[place] = value_13;
                place += 1;
                out[place] = value_14;
                place += 1;
                out[place] = T::from_f64(1f64);
                place += 1;
                out[place] = product_9;
                place += 1;
                out[place] = value_13;
                place += 1;
                out[place] = product_11;
                place += 1;
            }
        }
        fn convective_term(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
            let first_link: i64 = 0;
            let mut place = 0;
            {
                let slots: [usize; 1] = [3 * (first_link + 0) as usize];
                let link_0_omega = v[slots[0] + 2];
                let product_2 = c[2usize] * link_0_omega;
                let product_3 = link_0_omega * product_2;
                let link_0_phi = q[slots[0] + 2];
                let (sin_link_0_phi, cos_link_0_phi) = T::sin_cos(link_0_phi);
                let product_7 = product_3 * cos_link_0_phi;
                let product_9 = product_3 * sin_link_0_phi;
                let value_10 = -product_7;
                let value_11 = -product_9;
                out[place] = value_10;
                place += 1;
                out[place] = value_11;
                place += 1;
            }
            for at_i in 1..(self.n as i64) {
                let slots: [usize; 2] = [
                    3 * (first_link + (at_i - 1)) as usize,
                    3 * (first_link + at_i) as usize,
                ];
                let link_i_1_omega = v[slots[0] + 2];
                let product_3 = link_i_1_omega * link_i_1_omega;
                let link_i_1_phi = q[slots[0] + 2];
                let (sin_link_i_1_phi, cos_link_i_1_phi) = T::sin_cos(link_i_1_phi);
                let product_6 = product_3 * cos_link_i_1_phi;
                let link_i_omega = v[slots[1] + 2];
                let product_8 = link_i_omega * link_i_omega;
                let link_i_phi = q[slots[1] + 2];
                let (sin_link_i_phi, cos_link_i_phi) = T::sin_cos(link_i_phi);
                let sum_12 = T::fused(product_8, cos_link_i_phi, product_6);
                let product_14 = sum_12 * c[2usize];
                let product_16 = product_3 * sin_link_i_1_phi;
                let sum_19 = T::fused(product_8, sin_link_i_phi, product_16);
                let product_20 = c[2usize] * sum_19;
                let value_21 = -product_14;
                let value_22 = -product_20;
                out[place] = value_21;
                place += 1;
                out[place] = value_22;
                place += 1;
            }
        }
        fn applied_force(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
            let first_link: i64 = 0;
            let mut place = 0;
            out.fill(T::from_f64(0.0));
            for at_i in 0..(self.n as i64) {
                let slots: [usize; 1] = [3 * (first_link + at_i) as usize];
                let value_1 = -c[3usize];
                out[slots[0] + 1] = out[slots[0] + 1] + value_1;
            }
            {
                let slots: [usize; 1] = [3 * (first_link + 0) as usize];
                let link_0_omega = v[slots[0] + 2];
                let product_2 = c[4usize] * link_0_omega;
                let value_3 = -product_2;
                out[slots[0] + 2] = out[slots[0] + 2] + value_3;
            }
            for at_i in 1..(self.n as i64) {
                let slots: [usize; 2] = [
                    3 * (first_link + at_i) as usize,
                    3 * (first_link + (at_i - 1)) as usize,
                ];
                let link_i_omega = v[slots[0] + 2];
                let link_i_1_omega = v[slots[1] + 2];
                let difference_4 = link_i_1_omega - link_i_omega;
                let product_6 = difference_4 * c[4usize];
                let value_7 = -product_6;
                out[slots[0] + 2] = out[slots[0] + 2] + product_6;
                out[slots[1] + 2] = out[slots[1] + 2] + value_7;
            }
        }
    }
    #[automatically_derived]
    impl ::ezy_core::model::Scene for Settle {
        fn info(&self) -> &'static ::ezy_core::model::SceneInfo {
            static KNOWN: ::ezy_core::layout::Known = ::ezy_core::layout::Known::new();
            KNOWN.info(&Self::FIXED, &[self.n], |layout| self.describe(layout))
        }
        fn count(&self, index: usize) -> usize {
            match index {
                0usize => self.n,
                _ => 0,
            }
        }
        fn set_count(&mut self, index: usize, value: usize) {
            match index {
                0usize => self.n = value,
                _ => {}
            }
        }
        fn parameter(&self, index: usize) -> f64 {
            match index {
                0usize => self.l,
                1usize => self.m,
                2usize => self.g,
                3usize => self.d,
                _ => f64::NAN,
            }
        }
        fn set_parameter(&mut self, index: usize, value: f64) {
            match index {
                0usize => self.l = value,
                1usize => self.m = value,
                2usize => self.g = value,
                3usize => self.d = value,
                _ => {}
            }
        }
        fn power(
            &self,
            c: &[f64],
            t: f64,
            q: &[f64],
            v: &[f64],
            lambda: &[f64],
            out: &mut [f64],
        ) {
            let first_link: i64 = 0;
            out.fill(0.0);
            {
                let slots: [usize; 1] = [3 * (first_link + 0) as usize];
                let link_0_omega = v[slots[0] + 2];
                let product_2 = c[4usize] * link_0_omega;
                let product_3 = link_0_omega * product_2;
                let value_4 = -product_3;
                out[0usize] += value_4;
            }
            for at_i in 1..(self.n as i64) {
                let slots: [usize; 2] = [
                    3 * (first_link + at_i) as usize,
                    3 * (first_link + (at_i - 1)) as usize,
                ];
                let link_i_omega = v[slots[0] + 2];
                let product_3 = link_i_omega * link_i_omega;
                let link_i_1_omega = v[slots[1] + 2];
                let product_5 = link_i_1_omega * link_i_1_omega;
                let sum_6 = product_3 + product_5;
                let product_8 = sum_6 * c[4usize];
                let product_10 = link_i_omega * c[7usize];
                let product_11 = link_i_1_omega * product_10;
                let difference_12 = product_11 - product_8;
                out[0usize] += difference_12;
            }
            let mut place = 0;
        }
        fn potential_energy(&self, c: &[f64], t: f64, q: &[f64]) -> f64 {
            let first_link: i64 = 0;
            let mut total = 0.0;
            for at_i in 0..(self.n as i64) {
                let slots: [usize; 1] = [3 * (first_link + at_i) as usize];
                let link_i_y = q[slots[0] + 1];
                let product_2 = c[3usize] * link_i_y;
                total += product_2;
            }
            total
        }
        fn points(&self, c: &[f64], t: f64, q: &[f64], out: &mut [f64]) {
            let first_link: i64 = 0;
            let mut place = 0;
            {
                let slots: [usize; 0] = [];
                out[place] = 0f64;
                place += 1;
                out[place] = 0f64;
                place += 1;
            }
            {
                let slots: [usize; 1] = [
                    3 * (first_link + ((self.n as i64) - 1)) as usize,
                ];
                let link_n_1_x = q[slots[0] + 0];
                let link_n_1_phi = q[slots[0] + 2];
                let (sin_link_n_1_phi, cos_link_n_1_phi) = f64::sin_cos(link_n_1_phi);
                let product_6 = c[2usize] * cos_link_n_1_phi;
                let sum_7 = link_n_1_x + product_6;
                let link_n_1_y = q[slots[0] + 1];
                let product_10 = c[2usize] * sin_link_n_1_phi;
                let sum_11 = link_n_1_y + product_10;
                out[place] = sum_7;
                place += 1;
                out[place] = sum_11;
                place += 1;
            }
            for at_i in 1..(self.n as i64) {
                let slots: [usize; 1] = [3 * (first_link + (at_i - 1)) as usize];
                let link_i_1_x = q[slots[0] + 0];
                let link_i_1_phi = q[slots[0] + 2];
                let (sin_link_i_1_phi, cos_link_i_1_phi) = f64::sin_cos(link_i_1_phi);
                let product_6 = c[2usize] * cos_link_i_1_phi;
                let sum_7 = link_i_1_x + product_6;
                let link_i_1_y = q[slots[0] + 1];
                let product_10 = c[2usize] * sin_link_i_1_phi;
                let sum_11 = link_i_1_y + product_10;
                out[place] = sum_7;
                place += 1;
                out[place] = sum_11;
                place += 1;
            }
        }
        fn outputs(&self, c: &[f64], t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
            let first_link: i64 = 0;
            let mut place = 0;
            {
                let slots: [usize; 1] = [
                    3 * (first_link + ((self.n as i64) - 1)) as usize,
                ];
                let link_n_1_y = q[slots[0] + 1];
                let product_3 = c[5usize] * link_n_1_y;
                let link_n_1_phi = q[slots[0] + 2];
                let sin_link_n_1_phi = f64::sin(link_n_1_phi);
                let product_8 = c[6usize] * sin_link_n_1_phi;
                let sum_9 = product_3 + product_8;
                let value_10 = -sum_9;
                out[place] = value_10;
                place += 1;
            }
        }
        fn start(&self, c: &[f64], start: &mut ::ezy_core::model::Start) {
            let first_link: i64 = 0;
            for at_i in 0..(self.n as i64) {
                let slots: [usize; 1] = [3 * (first_link + at_i) as usize];
                start.give_position(slots[0] + 2, 0f64);
            }
        }
        fn series(&self) -> ::core::option::Option<&dyn ::ezy_core::model::Series<f64>> {
            ::core::option::Option::Some(self)
        }
        fn precise(
            &self,
        ) -> ::core::option::Option<&dyn ::ezy_core::model::PreciseScene> {
            ::core::option::Option::Some(self)
        }
    }
    #[automatically_derived]
    #[allow(unused_assignments, unused_mut)]
    impl<T: ::ezy_core::scalar::Scalar> ::ezy_core::model::Series<T> for Settle {
        fn series_size(&self) -> ::ezy_core::model::SeriesSize {
            let info = ::ezy_core::model::Scene::info(self);
            let mut size = ::ezy_core::model::SeriesSize {
                n_coordinates: info.n_coordinates(),
                n_rows: info.n_rows(),
                n_products: 0,
                n_base: 0,
                n_kept: 0,
            };
            {
                size.n_products += 4usize;
                size.n_base += 2usize;
                size.n_kept += 0usize;
            }
            for at_i in 1..(self.n as i64) {
                size.n_products += 8usize;
                size.n_base += 4usize;
                size.n_kept += 0usize;
            }
            for at_i in 0..(self.n as i64) {
                size.n_products += 0usize;
                size.n_base += 0usize;
                size.n_kept += 0usize;
            }
            {
                size.n_products += 0usize;
                size.n_base += 0usize;
                size.n_kept += 0usize;
            }
            for at_i in 1..(self.n as i64) {
                size.n_products += 0usize;
                size.n_base += 0usize;
                size.n_kept += 0usize;
            }
            size.n_products = size
                .n_products
                .next_multiple_of(::ezy_core::model::PRODUCT_GROUP);
            size
        }
        fn begin(
            &self,
            c: &[T],
            t: T,
            store: &mut ::ezy_core::model::SeriesStore<T>,
        ) -> ::ezy_core::model::DeficientRows {
            let first_link: i64 = 0;
            let ::ezy_core::model::SeriesStore {
                q,
                lambda,
                left,
                right,
                sums,
                kept,
                base,
                force,
                row,
                a,
            } = store;
            let (n_q, n_c, n_products) = (force.len(), row.len(), sums.len());
            let n_kept = if n_q == 0 { 0 } else { kept.len() / (q.len() / n_q) };
            let (mut row_place, mut product_place, mut base_place, mut kept_place) = (
                0,
                0,
                0,
                0,
            );
            let (q, v) = q[..2 * n_q].split_at(n_q);
            force.fill(T::from_f64(0f64));
            {
                let slots: [usize; 1] = [3 * (first_link + 0) as usize];
                let link_0_phi = q[slots[0] + 2];
                let (sin_link_0_phi, cos_link_0_phi) = T::sin_cos(link_0_phi);
                let link_0_omega = v[slots[0] + 2];
                let product_13 = c[2usize] * link_0_omega;
                let product_14 = link_0_omega * product_13;
                let product_15 = cos_link_0_phi * product_14;
                let product_16 = sin_link_0_phi * product_14;
                let product_17 = cos_link_0_phi * link_0_omega;
                let product_18 = sin_link_0_phi * link_0_omega;
                let value_19 = -product_18;
                base[base_place + 0] = cos_link_0_phi;
                base[base_place + 1] = sin_link_0_phi;
                force[slots[0] + 0] = force[slots[0] + 0] + T::from_f64(0f64);
                force[slots[0] + 1] = force[slots[0] + 1] + T::from_f64(0f64);
                force[slots[0] + 2] = force[slots[0] + 2] + T::from_f64(0f64);
                row[row_place + 0] = product_15;
                row[row_place + 1] = product_16;
                left[1 * n_products + product_place + 0] = product_17;
                right[1 * n_products + product_place + 0] = T::from_f64(0f64);
                left[1 * n_products + product_place + 1] = value_19;
                right[1 * n_products + product_place + 1] = T::from_f64(0f64);
                left[1 * n_products + product_place + 2] = link_0_omega;
                right[1 * n_products + product_place + 2] = product_17;
                left[1 * n_products + product_place + 3] = link_0_omega;
                right[1 * n_products + product_place + 3] = value_19;
                row_place += 2usize;
                product_place += 4usize;
                base_place += 2usize;
                kept_place += 0usize;
            }
            for at_i in 1..(self.n as i64) {
                let slots: [usize; 2] = [
                    3 * (first_link + (at_i - 1)) as usize,
                    3 * (first_link + at_i) as usize,
                ];
                let link_i_1_phi = q[slots[0] + 2];
                let (sin_link_i_1_phi, cos_link_i_1_phi) = T::sin_cos(link_i_1_phi);
                let link_i_phi = q[slots[1] + 2];
                let (sin_link_i_phi, cos_link_i_phi) = T::sin_cos(link_i_phi);
                let link_i_1_omega = v[slots[0] + 2];
                let product_22 = link_i_1_omega * link_i_1_omega;
                let product_23 = cos_link_i_1_phi * product_22;
                let link_i_omega = v[slots[1] + 2];
                let product_25 = link_i_omega * link_i_omega;
                let sum_27 = T::fused(cos_link_i_phi, product_25, product_23);
                let product_28 = c[2usize] * sum_27;
                let product_29 = sin_link_i_1_phi * product_22;
                let sum_31 = T::fused(sin_link_i_phi, product_25, product_29);
                let product_32 = c[2usize] * sum_31;
                let product_33 = cos_link_i_1_phi * link_i_1_omega;
                let product_34 = sin_link_i_1_phi * link_i_1_omega;
                let product_35 = cos_link_i_phi * link_i_omega;
                let product_36 = sin_link_i_phi * link_i_omega;
                let value_37 = -product_34;
                let value_38 = -product_36;
                base[base_place + 0] = cos_link_i_1_phi;
                base[base_place + 1] = sin_link_i_1_phi;
                base[base_place + 2] = cos_link_i_phi;
                base[base_place + 3] = sin_link_i_phi;
                force[slots[0] + 0] = force[slots[0] + 0] + T::from_f64(0f64);
                force[slots[0] + 1] = force[slots[0] + 1] + T::from_f64(0f64);
                force[slots[0] + 2] = force[slots[0] + 2] + T::from_f64(0f64);
                force[slots[1] + 0] = force[slots[1] + 0] + T::from_f64(0f64);
                force[slots[1] + 1] = force[slots[1] + 1] + T::from_f64(0f64);
                force[slots[1] + 2] = force[slots[1] + 2] + T::from_f64(0f64);
                row[row_place + 0] = product_28;
                row[row_place + 1] = product_32;
                left[1 * n_products + product_place + 0] = product_33;
                right[1 * n_products + product_place + 0] = T::from_f64(0f64);
                left[1 * n_products + product_place + 1] = value_37;
                right[1 * n_products + product_place + 1] = T::from_f64(0f64);
                left[1 * n_products + product_place + 2] = product_35;
                right[1 * n_products + product_place + 2] = T::from_f64(0f64);
                left[1 * n_products + product_place + 3] = value_38;
                right[1 * n_products + product_place + 3] = T::from_f64(0f64);
                left[1 * n_products + product_place + 4] = link_i_1_omega;
                right[1 * n_products + product_place + 4] = product_33;
                left[1 * n_products + product_place + 5] = link_i_omega;
                right[1 * n_products + product_place + 5] = product_35;
                left[1 * n_products + product_place + 6] = link_i_1_omega;
                right[1 * n_products + product_place + 6] = value_37;
                left[1 * n_products + product_place + 7] = link_i_omega;
                right[1 * n_products + product_place + 7] = value_38;
                row_place += 2usize;
                product_place += 8usize;
                base_place += 4usize;
                kept_place += 0usize;
            }
            for at_i in 0..(self.n as i64) {
                let slots: [usize; 1] = [3 * (first_link + at_i) as usize];
                let value_1 = -c[3usize];
                force[slots[0] + 1] = force[slots[0] + 1] + value_1;
                row_place += 0usize;
                product_place += 0usize;
                base_place += 0usize;
                kept_place += 0usize;
            }
            {
                let slots: [usize; 1] = [3 * (first_link + 0) as usize];
                let link_0_omega = v[slots[0] + 2];
                let product_2 = c[4usize] * link_0_omega;
                let value_3 = -product_2;
                force[slots[0] + 2] = force[slots[0] + 2] + value_3;
                row_place += 0usize;
                product_place += 0usize;
                base_place += 0usize;
                kept_place += 0usize;
            }
            for at_i in 1..(self.n as i64) {
                let slots: [usize; 2] = [
                    3 * (first_link + at_i) as usize,
                    3 * (first_link + (at_i - 1)) as usize,
                ];
                let link_i_omega = v[slots[0] + 2];
                let link_i_1_omega = v[slots[1] + 2];
                let difference_4 = link_i_1_omega - link_i_omega;
                let product_6 = difference_4 * c[4usize];
                let value_7 = -product_6;
                force[slots[0] + 2] = force[slots[0] + 2] + product_6;
                force[slots[1] + 2] = force[slots[1] + 2] + value_7;
                row_place += 0usize;
                product_place += 0usize;
                base_place += 0usize;
                kept_place += 0usize;
            }
            ::ezy_core::model::DeficientRows::ALL
        }
        fn right_side(
            &self,
            c: &[T],
            k: usize,
            store: &mut ::ezy_core::model::SeriesStore<T>,
        ) {
            let first_link: i64 = 0;
            let ::ezy_core::model::SeriesStore {
                q,
                lambda,
                left,
                right,
                sums,
                kept,
                base,
                force,
                row,
                a,
            } = store;
            let (n_q, n_c, n_products) = (force.len(), row.len(), sums.len());
            let n_kept = if n_q == 0 { 0 } else { kept.len() / (q.len() / n_q) };
            let (mut row_place, mut product_place, mut base_place, mut kept_place) = (
                0,
                0,
                0,
                0,
            );
            force.fill(T::from_f64(0f64));
            {
                let slots: [usize; 1] = [3 * (first_link + 0) as usize];
                let convolved_0 = sums[product_place + 0];
                let product_3 = c[2usize] * convolved_0;
                let convolved_1 = sums[product_place + 1];
                let difference_6 = T::fused(-c[2usize], convolved_1, product_3);
                let convolved_2 = sums[product_place + 2];
                let inverse_order_ahead = T::from_f64(1f64)
                    / T::from_f64((k + 2) as f64);
                let product_9 = convolved_2 * inverse_order_ahead;
                let product_10 = c[2usize] * product_9;
                let order_next = T::from_f64((k + 1) as f64);
                let order_ahead = T::from_f64((k + 2) as f64);
                let product_13 = order_next * order_ahead;
                let product_14 = product_10 * product_13;
                let convolved_3 = sums[product_place + 3];
                let product_16 = inverse_order_ahead * convolved_3;
                let product_17 = c[2usize] * product_16;
                let product_18 = product_13 * product_17;
                let value_19 = -product_18;
                force[slots[0] + 0] = force[slots[0] + 0] + T::from_f64(0f64);
                force[slots[0] + 1] = force[slots[0] + 1] + T::from_f64(0f64);
                force[slots[0] + 2] = force[slots[0] + 2] + difference_6;
                row[row_place + 0] = product_14;
                row[row_place + 1] = value_19;
                row_place += 2usize;
                product_place += 4usize;
                base_place += 2usize;
                kept_place += 0usize;
            }
            for at_i in 1..(self.n as i64) {
                let slots: [usize; 2] = [
                    3 * (first_link + (at_i - 1)) as usize,
                    3 * (first_link + at_i) as usize,
                ];
                let convolved_0 = sums[product_place + 0];
                let product_3 = c[2usize] * convolved_0;
                let convolved_1 = sums[product_place + 1];
                let difference_6 = T::fused(-c[2usize], convolved_1, product_3);
                let convolved_2 = sums[product_place + 2];
                let product_8 = c[2usize] * convolved_2;
                let convolved_3 = sums[product_place + 3];
                let difference_11 = T::fused(-c[2usize], convolved_3, product_8);
                let convolved_4 = sums[product_place + 4];
                let inverse_order_ahead = T::from_f64(1f64)
                    / T::from_f64((k + 2) as f64);
                let product_14 = convolved_4 * inverse_order_ahead;
                let convolved_5 = sums[product_place + 5];
                let sum_17 = T::fused(inverse_order_ahead, convolved_5, product_14);
                let product_18 = c[2usize] * sum_17;
                let order_next = T::from_f64((k + 1) as f64);
                let order_ahead = T::from_f64((k + 2) as f64);
                let product_21 = order_next * order_ahead;
                let product_22 = product_18 * product_21;
                let convolved_6 = sums[product_place + 6];
                let product_24 = inverse_order_ahead * convolved_6;
                let convolved_7 = sums[product_place + 7];
                let sum_27 = T::fused(inverse_order_ahead, convolved_7, product_24);
                let product_28 = c[2usize] * sum_27;
                let product_29 = product_21 * product_28;
                let value_30 = -product_29;
                force[slots[0] + 0] = force[slots[0] + 0] + T::from_f64(0f64);
                force[slots[0] + 1] = force[slots[0] + 1] + T::from_f64(0f64);
                force[slots[0] + 2] = force[slots[0] + 2] + difference_6;
                force[slots[1] + 0] = force[slots[1] + 0] + T::from_f64(0f64);
                force[slots[1] + 1] = force[slots[1] + 1] + T::from_f64(0f64);
                force[slots[1] + 2] = force[slots[1] + 2] + difference_11;
                row[row_place + 0] = product_22;
                row[row_place + 1] = value_30;
                row_place += 2usize;
                product_place += 8usize;
                base_place += 4usize;
                kept_place += 0usize;
            }
            for at_i in 0..(self.n as i64) {
                let slots: [usize; 1] = [3 * (first_link + at_i) as usize];
                force[slots[0] + 1] = force[slots[0] + 1] + T::from_f64(0f64);
                row_place += 0usize;
                product_place += 0usize;
                base_place += 0usize;
                kept_place += 0usize;
            }
            {
                let slots: [usize; 1] = [3 * (first_link + 0) as usize];
                let order_next = T::from_f64((k + 1) as f64);
                let q_8_next = q[(k + 1) * n_q + slots[0] + 2];
                let product_3 = order_next * q_8_next;
                let product_4 = c[4usize] * product_3;
                let value_6 = -product_4;
                force[slots[0] + 2] = force[slots[0] + 2] + value_6;
                row_place += 0usize;
                product_place += 0usize;
                base_place += 0usize;
                kept_place += 0usize;
            }
            for at_i in 1..(self.n as i64) {
                let slots: [usize; 2] = [
                    3 * (first_link + at_i) as usize,
                    3 * (first_link + (at_i - 1)) as usize,
                ];
                let order_next = T::from_f64((k + 1) as f64);
                let q_23_next = q[(k + 1) * n_q + slots[1] + 2];
                let product_3 = order_next * q_23_next;
                let q_20_next = q[(k + 1) * n_q + slots[0] + 2];
                let difference_6 = T::fused(-order_next, q_20_next, product_3);
                let product_7 = c[4usize] * difference_6;
                let value_9 = -product_7;
                force[slots[0] + 2] = force[slots[0] + 2] + product_7;
                force[slots[1] + 2] = force[slots[1] + 2] + value_9;
                row_place += 0usize;
                product_place += 0usize;
                base_place += 0usize;
                kept_place += 0usize;
            }
        }
        fn solve(
            &self,
            c: &[T],
            k: usize,
            store: &mut ::ezy_core::model::SeriesStore<T>,
        ) {}
        fn finish(
            &self,
            c: &[T],
            k: usize,
            store: &mut ::ezy_core::model::SeriesStore<T>,
        ) {
            let first_link: i64 = 0;
            let ::ezy_core::model::SeriesStore {
                q,
                lambda,
                left,
                right,
                sums,
                kept,
                base,
                force,
                row,
                a,
            } = store;
            let (n_q, n_c, n_products) = (force.len(), row.len(), sums.len());
            let n_kept = if n_q == 0 { 0 } else { kept.len() / (q.len() / n_q) };
            let (mut row_place, mut product_place, mut base_place, mut kept_place) = (
                0,
                0,
                0,
                0,
            );
            let inverse = T::from_f64(1f64) / T::from_f64(((k + 1) * (k + 2)) as f64);
            q[(k + 2) * n_q..(k + 3) * n_q]
                .iter_mut()
                .zip(a.iter())
                .for_each(|(q, a)| *q = *a * inverse);
            {
                let slots: [usize; 1] = [3 * (first_link + 0) as usize];
                let lambda_0 = lambda[(k + 0) * n_c + row_place + 0];
                let convolved_3 = sums[product_place + 3];
                let inverse_order_ahead = T::from_f64(1f64)
                    / T::from_f64((k + 2) as f64);
                let product_5 = convolved_3 * inverse_order_ahead;
                let q_8_ahead = q[(k + 2) * n_q + slots[0] + 2];
                let base_0 = base[base_place + 0];
                let sum_9 = T::fused(q_8_ahead, base_0, product_5);
                let lambda_1 = lambda[(k + 0) * n_c + row_place + 1];
                let convolved_2 = sums[product_place + 2];
                let product_12 = inverse_order_ahead * convolved_2;
                let base_1 = base[base_place + 1];
                let sum_15 = T::fused(q_8_ahead, base_1, product_12);
                let order_ahead = T::from_f64((k + 2) as f64);
                let product_17 = q_8_ahead * order_ahead;
                let value_18 = -sum_15;
                left[(k + 2) * n_products + product_place + 0] = sum_9;
                right[(k + 2) * n_products + product_place + 0] = lambda_0;
                left[(k + 2) * n_products + product_place + 1] = value_18;
                right[(k + 2) * n_products + product_place + 1] = lambda_1;
                left[(k + 2) * n_products + product_place + 2] = product_17;
                right[(k + 2) * n_products + product_place + 2] = sum_9;
                left[(k + 2) * n_products + product_place + 3] = product_17;
                right[(k + 2) * n_products + product_place + 3] = value_18;
                row_place += 2usize;
                product_place += 4usize;
                base_place += 2usize;
                kept_place += 0usize;
            }
            for at_i in 1..(self.n as i64) {
                let slots: [usize; 2] = [
                    3 * (first_link + (at_i - 1)) as usize,
                    3 * (first_link + at_i) as usize,
                ];
                let lambda_0 = lambda[(k + 0) * n_c + row_place + 0];
                let convolved_6 = sums[product_place + 6];
                let inverse_order_ahead = T::from_f64(1f64)
                    / T::from_f64((k + 2) as f64);
                let product_5 = convolved_6 * inverse_order_ahead;
                let q_11_ahead = q[(k + 2) * n_q + slots[0] + 2];
                let base_0 = base[base_place + 0];
                let sum_9 = T::fused(q_11_ahead, base_0, product_5);
                let lambda_1 = lambda[(k + 0) * n_c + row_place + 1];
                let convolved_4 = sums[product_place + 4];
                let product_12 = inverse_order_ahead * convolved_4;
                let base_1 = base[base_place + 1];
                let sum_15 = T::fused(q_11_ahead, base_1, product_12);
                let convolved_7 = sums[product_place + 7];
                let product_17 = inverse_order_ahead * convolved_7;
                let q_14_ahead = q[(k + 2) * n_q + slots[1] + 2];
                let base_2 = base[base_place + 2];
                let sum_21 = T::fused(q_14_ahead, base_2, product_17);
                let convolved_5 = sums[product_place + 5];
                let product_23 = inverse_order_ahead * convolved_5;
                let base_3 = base[base_place + 3];
                let sum_26 = T::fused(q_14_ahead, base_3, product_23);
                let order_ahead = T::from_f64((k + 2) as f64);
                let product_28 = q_11_ahead * order_ahead;
                let product_29 = q_14_ahead * order_ahead;
                let value_30 = -sum_15;
                let value_31 = -sum_26;
                left[(k + 2) * n_products + product_place + 0] = sum_9;
                right[(k + 2) * n_products + product_place + 0] = lambda_0;
                left[(k + 2) * n_products + product_place + 1] = value_30;
                right[(k + 2) * n_products + product_place + 1] = lambda_1;
                left[(k + 2) * n_products + product_place + 2] = sum_21;
                right[(k + 2) * n_products + product_place + 2] = lambda_0;
                left[(k + 2) * n_products + product_place + 3] = value_31;
                right[(k + 2) * n_products + product_place + 3] = lambda_1;
                left[(k + 2) * n_products + product_place + 4] = product_28;
                right[(k + 2) * n_products + product_place + 4] = sum_9;
                left[(k + 2) * n_products + product_place + 5] = product_29;
                right[(k + 2) * n_products + product_place + 5] = sum_21;
                left[(k + 2) * n_products + product_place + 6] = product_28;
                right[(k + 2) * n_products + product_place + 6] = value_30;
                left[(k + 2) * n_products + product_place + 7] = product_29;
                right[(k + 2) * n_products + product_place + 7] = value_31;
                row_place += 2usize;
                product_place += 8usize;
                base_place += 4usize;
                kept_place += 0usize;
            }
            for at_i in 0..(self.n as i64) {
                let slots: [usize; 1] = [3 * (first_link + at_i) as usize];
                row_place += 0usize;
                product_place += 0usize;
                base_place += 0usize;
                kept_place += 0usize;
            }
            {
                let slots: [usize; 1] = [3 * (first_link + 0) as usize];
                row_place += 0usize;
                product_place += 0usize;
                base_place += 0usize;
                kept_place += 0usize;
            }
            for at_i in 1..(self.n as i64) {
                let slots: [usize; 2] = [
                    3 * (first_link + at_i) as usize,
                    3 * (first_link + (at_i - 1)) as usize,
                ];
                row_place += 0usize;
                product_place += 0usize;
                base_place += 0usize;
                kept_place += 0usize;
            }
        }
    }
}
