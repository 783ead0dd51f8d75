///A seat on a rear wheel, steered and driven by swinging a front bar on its own wheel.
#[allow(non_snake_case, unused_variables, clippy::all, clippy::pedantic)]
pub mod ezy_roller {
    /// The model and its scenes.
    pub static MODEL: ::ezy_core::model::ModelInfo = ::ezy_core::model::ModelInfo {
        name: "EzyRoller",
        documentation: "A seat on a rear wheel, steered and driven by swinging a front bar on its own wheel.",
        effects: &[
            ::ezy_core::model::EffectInfo {
                name: "pump",
                documentation: "The rider swings the bar: a torque between seat and bar.",
            },
            ::ezy_core::model::EffectInfo {
                name: "rolling_resistance",
                documentation: "Drag of the rear wheel, proportional to its speed.",
            },
            ::ezy_core::model::EffectInfo {
                name: "slip",
                documentation: "The rear wheel lets go: a side force against its slip replaces the skate.",
            },
            ::ezy_core::model::EffectInfo {
                name: "rider",
                documentation: "The rider's arms, moved by whoever runs the scene.",
            },
        ],
        scenes: &[
            ::ezy_core::model::SceneEntry {
                name: "coast",
                info: || &Coast::INFO,
                new: || ::std::boxed::Box::new(
                    <Coast as ::core::default::Default>::default(),
                ),
            },
            ::ezy_core::model::SceneEntry {
                name: "driven",
                info: || &Driven::INFO,
                new: || ::std::boxed::Box::new(
                    <Driven as ::core::default::Default>::default(),
                ),
            },
            ::ezy_core::model::SceneEntry {
                name: "driven_on_tarmac",
                info: || &DrivenOnTarmac::INFO,
                new: || ::std::boxed::Box::new(
                    <DrivenOnTarmac as ::core::default::Default>::default(),
                ),
            },
            ::ezy_core::model::SceneEntry {
                name: "drift",
                info: || &Drift::INFO,
                new: || ::std::boxed::Box::new(
                    <Drift as ::core::default::Default>::default(),
                ),
            },
            ::ezy_core::model::SceneEntry {
                name: "ridden",
                info: || &Ridden::INFO,
                new: || ::std::boxed::Box::new(
                    <Ridden as ::core::default::Default>::default(),
                ),
            },
        ],
    };
    ///No forces: the bar stands across, the seat moves at 1 m/s.
    ///
    ///Cost of the accelerations and multipliers: 56 mul, 29 add, 1 div, 2 sin–cos.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct Coast {
        ///rear wheel A, behind the seat's centre of mass (m); default `0.2`.
        pub a: f64,
        ///hinge B, ahead of the seat's centre of mass (m); default `0.6`.
        pub b: f64,
        ///front wheel C, beyond the bar's centre of mass (m); default `0.1`.
        pub c: f64,
        ///bar's centre of mass, beyond the hinge (m); default `0.1`.
        pub d: f64,
        ///mass of seat and rider (kg); default `46.0`.
        pub m1: f64,
        ///moment of inertia of seat and rider (kg*m^2); default `10.0`.
        pub i1: f64,
        ///mass of the bar (kg); default `1.0`.
        pub m2: f64,
        ///moment of inertia of the bar (kg*m^2); default `0.005`.
        pub i2: f64,
    }
    impl ::core::default::Default for Coast {
        fn default() -> Self {
            Self {
                a: 0.2f64,
                b: 0.6f64,
                c: 0.1f64,
                d: 0.1f64,
                m1: 46f64,
                i1: 10f64,
                m2: 1f64,
                i2: 0.005f64,
            }
        }
    }
    impl Coast {
        /// What is known of the scene when it is compiled.
        pub const INFO: ::ezy_core::model::SceneInfo = ::ezy_core::model::SceneInfo {
            model: "EzyRoller",
            name: "coast",
            documentation: "No forces: the bar stands across, the seat moves at 1 m/s.",
            bodies: &["seat", "bar"],
            coordinates: &[
                ::ezy_core::model::CoordinateInfo {
                    name: "seat.x",
                    velocity_name: "seat.vx",
                    unit: "m",
                    symbol: ::ezy_core::model::Formula {
                        text: "seat.x",
                        latex: "x_{\\mathrm{seat}}",
                        mathml: "<msub><mi>x</mi><mtext>seat</mtext></msub>",
                    },
                    velocity_symbol: ::ezy_core::model::Formula {
                        text: "seat.vx",
                        latex: "\\dot{x}_{\\mathrm{seat}}",
                        mathml: "<msub><mover><mi>x</mi><mo>.</mo></mover><mtext>seat</mtext></msub>",
                    },
                },
                ::ezy_core::model::CoordinateInfo {
                    name: "seat.y",
                    velocity_name: "seat.vy",
                    unit: "m",
                    symbol: ::ezy_core::model::Formula {
                        text: "seat.y",
                        latex: "y_{\\mathrm{seat}}",
                        mathml: "<msub><mi>y</mi><mtext>seat</mtext></msub>",
                    },
                    velocity_symbol: ::ezy_core::model::Formula {
                        text: "seat.vy",
                        latex: "\\dot{y}_{\\mathrm{seat}}",
                        mathml: "<msub><mover><mi>y</mi><mo>.</mo></mover><mtext>seat</mtext></msub>",
                    },
                },
                ::ezy_core::model::CoordinateInfo {
                    name: "seat.phi",
                    velocity_name: "seat.omega",
                    unit: "rad",
                    symbol: ::ezy_core::model::Formula {
                        text: "seat.phi",
                        latex: "\\varphi_{\\mathrm{seat}}",
                        mathml: "<msub><mi>φ</mi><mtext>seat</mtext></msub>",
                    },
                    velocity_symbol: ::ezy_core::model::Formula {
                        text: "seat.omega",
                        latex: "\\dot{\\varphi}_{\\mathrm{seat}}",
                        mathml: "<msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext></msub>",
                    },
                },
                ::ezy_core::model::CoordinateInfo {
                    name: "bar.x",
                    velocity_name: "bar.vx",
                    unit: "m",
                    symbol: ::ezy_core::model::Formula {
                        text: "bar.x",
                        latex: "x_{\\mathrm{bar}}",
                        mathml: "<msub><mi>x</mi><mtext>bar</mtext></msub>",
                    },
                    velocity_symbol: ::ezy_core::model::Formula {
                        text: "bar.vx",
                        latex: "\\dot{x}_{\\mathrm{bar}}",
                        mathml: "<msub><mover><mi>x</mi><mo>.</mo></mover><mtext>bar</mtext></msub>",
                    },
                },
                ::ezy_core::model::CoordinateInfo {
                    name: "bar.y",
                    velocity_name: "bar.vy",
                    unit: "m",
                    symbol: ::ezy_core::model::Formula {
                        text: "bar.y",
                        latex: "y_{\\mathrm{bar}}",
                        mathml: "<msub><mi>y</mi><mtext>bar</mtext></msub>",
                    },
                    velocity_symbol: ::ezy_core::model::Formula {
                        text: "bar.vy",
                        latex: "\\dot{y}_{\\mathrm{bar}}",
                        mathml: "<msub><mover><mi>y</mi><mo>.</mo></mover><mtext>bar</mtext></msub>",
                    },
                },
                ::ezy_core::model::CoordinateInfo {
                    name: "bar.phi",
                    velocity_name: "bar.omega",
                    unit: "rad",
                    symbol: ::ezy_core::model::Formula {
                        text: "bar.phi",
                        latex: "\\varphi_{\\mathrm{bar}}",
                        mathml: "<msub><mi>φ</mi><mtext>bar</mtext></msub>",
                    },
                    velocity_symbol: ::ezy_core::model::Formula {
                        text: "bar.omega",
                        latex: "\\dot{\\varphi}_{\\mathrm{bar}}",
                        mathml: "<msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext></msub>",
                    },
                },
            ],
            points: &[
                ::ezy_core::model::PointInfo {
                    name: "A",
                    body: ::core::option::Option::Some(0usize),
                    position: ::core::option::Option::Some([
                        ::ezy_core::model::Formula {
                            text: "seat.x - a*cos(seat.phi)",
                            latex: "x_{\\mathrm{seat}} - a \\, \\cos{\\varphi_{\\mathrm{seat}}}",
                            mathml: "<mrow><msub><mi>x</mi><mtext>seat</mtext></msub><mo>−</mo><mi>a</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                        },
                        ::ezy_core::model::Formula {
                            text: "seat.y - a*sin(seat.phi)",
                            latex: "y_{\\mathrm{seat}} - a \\, \\sin{\\varphi_{\\mathrm{seat}}}",
                            mathml: "<mrow><msub><mi>y</mi><mtext>seat</mtext></msub><mo>−</mo><mi>a</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                        },
                    ]),
                },
                ::ezy_core::model::PointInfo {
                    name: "C",
                    body: ::core::option::Option::Some(1usize),
                    position: ::core::option::Option::Some([
                        ::ezy_core::model::Formula {
                            text: "bar.x + c*cos(bar.phi)",
                            latex: "x_{\\mathrm{bar}} + c \\, \\cos{\\varphi_{\\mathrm{bar}}}",
                            mathml: "<mrow><msub><mi>x</mi><mtext>bar</mtext></msub><mo>+</mo><mi>c</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                        },
                        ::ezy_core::model::Formula {
                            text: "bar.y + c*sin(bar.phi)",
                            latex: "y_{\\mathrm{bar}} + c \\, \\sin{\\varphi_{\\mathrm{bar}}}",
                            mathml: "<mrow><msub><mi>y</mi><mtext>bar</mtext></msub><mo>+</mo><mi>c</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                        },
                    ]),
                },
                ::ezy_core::model::PointInfo {
                    name: "B",
                    body: ::core::option::Option::Some(0usize),
                    position: ::core::option::Option::Some([
                        ::ezy_core::model::Formula {
                            text: "seat.x + b*cos(seat.phi)",
                            latex: "x_{\\mathrm{seat}} + b \\, \\cos{\\varphi_{\\mathrm{seat}}}",
                            mathml: "<mrow><msub><mi>x</mi><mtext>seat</mtext></msub><mo>+</mo><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                        },
                        ::ezy_core::model::Formula {
                            text: "seat.y + b*sin(seat.phi)",
                            latex: "y_{\\mathrm{seat}} + b \\, \\sin{\\varphi_{\\mathrm{seat}}}",
                            mathml: "<mrow><msub><mi>y</mi><mtext>seat</mtext></msub><mo>+</mo><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                        },
                    ]),
                },
            ],
            rows: &[
                ::ezy_core::model::RowInfo {
                    name: "B.x",
                    kind: "hinge",
                    multiplier_unit: "N",
                    constraint: ::ezy_core::model::Formula {
                        text: "seat.x + b*cos(seat.phi) - bar.x + d*cos(bar.phi)",
                        latex: "x_{\\mathrm{seat}} + b \\, \\cos{\\varphi_{\\mathrm{seat}}} - x_{\\mathrm{bar}} + d \\, \\cos{\\varphi_{\\mathrm{bar}}}",
                        mathml: "<mrow><msub><mi>x</mi><mtext>seat</mtext></msub><mo>+</mo><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>−</mo><msub><mi>x</mi><mtext>bar</mtext></msub><mo>+</mo><mi>d</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                    },
                    convective_term: ::ezy_core::model::Formula {
                        text: "-b*seat.omega^2*cos(seat.phi) - d*bar.omega^2*cos(bar.phi)",
                        latex: "-b \\, \\dot{\\varphi}_{\\mathrm{seat}}^{2} \\, \\cos{\\varphi_{\\mathrm{seat}}} - d \\, \\dot{\\varphi}_{\\mathrm{bar}}^{2} \\, \\cos{\\varphi_{\\mathrm{bar}}}",
                        mathml: "<mrow><mo>−</mo><mi>b</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>−</mo><mi>d</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                    },
                },
                ::ezy_core::model::RowInfo {
                    name: "B.y",
                    kind: "hinge",
                    multiplier_unit: "N",
                    constraint: ::ezy_core::model::Formula {
                        text: "seat.y + b*sin(seat.phi) - bar.y + d*sin(bar.phi)",
                        latex: "y_{\\mathrm{seat}} + b \\, \\sin{\\varphi_{\\mathrm{seat}}} - y_{\\mathrm{bar}} + d \\, \\sin{\\varphi_{\\mathrm{bar}}}",
                        mathml: "<mrow><msub><mi>y</mi><mtext>seat</mtext></msub><mo>+</mo><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>−</mo><msub><mi>y</mi><mtext>bar</mtext></msub><mo>+</mo><mi>d</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                    },
                    convective_term: ::ezy_core::model::Formula {
                        text: "-b*seat.omega^2*sin(seat.phi) - d*bar.omega^2*sin(bar.phi)",
                        latex: "-b \\, \\dot{\\varphi}_{\\mathrm{seat}}^{2} \\, \\sin{\\varphi_{\\mathrm{seat}}} - d \\, \\dot{\\varphi}_{\\mathrm{bar}}^{2} \\, \\sin{\\varphi_{\\mathrm{bar}}}",
                        mathml: "<mrow><mo>−</mo><mi>b</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>−</mo><mi>d</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                    },
                },
                ::ezy_core::model::RowInfo {
                    name: "rear",
                    kind: "skate",
                    multiplier_unit: "N",
                    constraint: ::ezy_core::model::Formula {
                        text: "-a*seat.omega - seat.vx*sin(seat.phi) + seat.vy*cos(seat.phi)",
                        latex: "-a \\, \\dot{\\varphi}_{\\mathrm{seat}} - \\dot{x}_{\\mathrm{seat}} \\, \\sin{\\varphi_{\\mathrm{seat}}} + \\dot{y}_{\\mathrm{seat}} \\, \\cos{\\varphi_{\\mathrm{seat}}}",
                        mathml: "<mrow><mo>−</mo><mi>a</mi><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mo>−</mo><msub><mover><mi>x</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>+</mo><msub><mover><mi>y</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                    },
                    convective_term: ::ezy_core::model::Formula {
                        text: "-seat.vx*seat.omega*cos(seat.phi) - seat.vy*seat.omega*sin(seat.phi)",
                        latex: "-\\dot{x}_{\\mathrm{seat}} \\, \\dot{\\varphi}_{\\mathrm{seat}} \\, \\cos{\\varphi_{\\mathrm{seat}}} - \\dot{y}_{\\mathrm{seat}} \\, \\dot{\\varphi}_{\\mathrm{seat}} \\, \\sin{\\varphi_{\\mathrm{seat}}}",
                        mathml: "<mrow><mo>−</mo><msub><mover><mi>x</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>−</mo><msub><mover><mi>y</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                    },
                },
                ::ezy_core::model::RowInfo {
                    name: "front",
                    kind: "skate",
                    multiplier_unit: "N",
                    constraint: ::ezy_core::model::Formula {
                        text: "c*bar.omega - bar.vx*sin(bar.phi) + bar.vy*cos(bar.phi)",
                        latex: "c \\, \\dot{\\varphi}_{\\mathrm{bar}} - \\dot{x}_{\\mathrm{bar}} \\, \\sin{\\varphi_{\\mathrm{bar}}} + \\dot{y}_{\\mathrm{bar}} \\, \\cos{\\varphi_{\\mathrm{bar}}}",
                        mathml: "<mrow><mi>c</mi><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mo>−</mo><msub><mover><mi>x</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow><mo>+</mo><msub><mover><mi>y</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                    },
                    convective_term: ::ezy_core::model::Formula {
                        text: "-bar.vx*bar.omega*cos(bar.phi) - bar.vy*bar.omega*sin(bar.phi)",
                        latex: "-\\dot{x}_{\\mathrm{bar}} \\, \\dot{\\varphi}_{\\mathrm{bar}} \\, \\cos{\\varphi_{\\mathrm{bar}}} - \\dot{y}_{\\mathrm{bar}} \\, \\dot{\\varphi}_{\\mathrm{bar}} \\, \\sin{\\varphi_{\\mathrm{bar}}}",
                        mathml: "<mrow><mo>−</mo><msub><mover><mi>x</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow><mo>−</mo><msub><mover><mi>y</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                    },
                },
            ],
            n_position_rows: 2usize,
            parameters: &[
                ::ezy_core::model::ParameterInfo {
                    name: "a",
                    unit: "m",
                    default: 0.2f64,
                    default_text: "0.2",
                    documentation: "rear wheel A, behind the seat's centre of mass",
                    effect: ::core::option::Option::None,
                    symbol: ::ezy_core::model::Formula {
                        text: "a",
                        latex: "a",
                        mathml: "<mi>a</mi>",
                    },
                },
                ::ezy_core::model::ParameterInfo {
                    name: "b",
                    unit: "m",
                    default: 0.6f64,
                    default_text: "0.6",
                    documentation: "hinge B, ahead of the seat's centre of mass",
                    effect: ::core::option::Option::None,
                    symbol: ::ezy_core::model::Formula {
                        text: "b",
                        latex: "b",
                        mathml: "<mi>b</mi>",
                    },
                },
                ::ezy_core::model::ParameterInfo {
                    name: "c",
                    unit: "m",
                    default: 0.1f64,
                    default_text: "0.1",
                    documentation: "front wheel C, beyond the bar's centre of mass",
                    effect: ::core::option::Option::None,
                    symbol: ::ezy_core::model::Formula {
                        text: "c",
                        latex: "c",
                        mathml: "<mi>c</mi>",
                    },
                },
                ::ezy_core::model::ParameterInfo {
                    name: "d",
                    unit: "m",
                    default: 0.1f64,
                    default_text: "0.1",
                    documentation: "bar's centre of mass, beyond the hinge",
                    effect: ::core::option::Option::None,
                    symbol: ::ezy_core::model::Formula {
                        text: "d",
                        latex: "d",
                        mathml: "<mi>d</mi>",
                    },
                },
                ::ezy_core::model::ParameterInfo {
                    name: "m1",
                    unit: "kg",
                    default: 46f64,
                    default_text: "46.0",
                    documentation: "mass of seat and rider",
                    effect: ::core::option::Option::None,
                    symbol: ::ezy_core::model::Formula {
                        text: "m1",
                        latex: "m_{1}",
                        mathml: "<msub><mi>m</mi><mtext>1</mtext></msub>",
                    },
                },
                ::ezy_core::model::ParameterInfo {
                    name: "i1",
                    unit: "kg*m^2",
                    default: 10f64,
                    default_text: "10.0",
                    documentation: "moment of inertia of seat and rider",
                    effect: ::core::option::Option::None,
                    symbol: ::ezy_core::model::Formula {
                        text: "i1",
                        latex: "i_{1}",
                        mathml: "<msub><mi>i</mi><mtext>1</mtext></msub>",
                    },
                },
                ::ezy_core::model::ParameterInfo {
                    name: "m2",
                    unit: "kg",
                    default: 1f64,
                    default_text: "1.0",
                    documentation: "mass of the bar",
                    effect: ::core::option::Option::None,
                    symbol: ::ezy_core::model::Formula {
                        text: "m2",
                        latex: "m_{2}",
                        mathml: "<msub><mi>m</mi><mtext>2</mtext></msub>",
                    },
                },
                ::ezy_core::model::ParameterInfo {
                    name: "i2",
                    unit: "kg*m^2",
                    default: 0.005f64,
                    default_text: "0.005",
                    documentation: "moment of inertia of the bar",
                    effect: ::core::option::Option::None,
                    symbol: ::ezy_core::model::Formula {
                        text: "i2",
                        latex: "i_{2}",
                        mathml: "<msub><mi>i</mi><mtext>2</mtext></msub>",
                    },
                },
            ],
            inputs: &[],
            outputs: &[],
            effects: &[],
            until_s: 1f64,
            n_constants: 30usize,
            jacobian: ::ezy_core::model::SparsityPattern {
                starts: &[0usize, 4usize, 8usize, 11usize, 14usize],
                columns: &[
                    0usize, 2usize, 3usize, 5usize, 1usize, 2usize, 4usize, 5usize,
                    0usize, 1usize, 2usize, 3usize, 4usize, 5usize,
                ],
            },
            jacobian_entries: &[
                ::ezy_core::model::Formula {
                    text: "1",
                    latex: "1",
                    mathml: "<mrow><mn>1</mn></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "-b*sin(seat.phi)",
                    latex: "-b \\, \\sin{\\varphi_{\\mathrm{seat}}}",
                    mathml: "<mrow><mo>−</mo><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "-1",
                    latex: "-1",
                    mathml: "<mrow><mo>−</mo><mn>1</mn></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "-d*sin(bar.phi)",
                    latex: "-d \\, \\sin{\\varphi_{\\mathrm{bar}}}",
                    mathml: "<mrow><mo>−</mo><mi>d</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "1",
                    latex: "1",
                    mathml: "<mrow><mn>1</mn></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "b*cos(seat.phi)",
                    latex: "b \\, \\cos{\\varphi_{\\mathrm{seat}}}",
                    mathml: "<mrow><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "-1",
                    latex: "-1",
                    mathml: "<mrow><mo>−</mo><mn>1</mn></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "d*cos(bar.phi)",
                    latex: "d \\, \\cos{\\varphi_{\\mathrm{bar}}}",
                    mathml: "<mrow><mi>d</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "-sin(seat.phi)",
                    latex: "-\\sin{\\varphi_{\\mathrm{seat}}}",
                    mathml: "<mrow><mo>−</mo><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "cos(seat.phi)",
                    latex: "\\cos{\\varphi_{\\mathrm{seat}}}",
                    mathml: "<mrow><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "-a",
                    latex: "-a",
                    mathml: "<mrow><mo>−</mo><mi>a</mi></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "-sin(bar.phi)",
                    latex: "-\\sin{\\varphi_{\\mathrm{bar}}}",
                    mathml: "<mrow><mo>−</mo><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "cos(bar.phi)",
                    latex: "\\cos{\\varphi_{\\mathrm{bar}}}",
                    mathml: "<mrow><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "c",
                    latex: "c",
                    mathml: "<mrow><mi>c</mi></mrow>",
                },
            ],
            mass_entries: &[
                ::ezy_core::model::Formula {
                    text: "m1",
                    latex: "m_{1}",
                    mathml: "<mrow><msub><mi>m</mi><mtext>1</mtext></msub></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "m1",
                    latex: "m_{1}",
                    mathml: "<mrow><msub><mi>m</mi><mtext>1</mtext></msub></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "i1",
                    latex: "i_{1}",
                    mathml: "<mrow><msub><mi>i</mi><mtext>1</mtext></msub></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "m2",
                    latex: "m_{2}",
                    mathml: "<mrow><msub><mi>m</mi><mtext>2</mtext></msub></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "m2",
                    latex: "m_{2}",
                    mathml: "<mrow><msub><mi>m</mi><mtext>2</mtext></msub></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "i2",
                    latex: "i_{2}",
                    mathml: "<mrow><msub><mi>i</mi><mtext>2</mtext></msub></mrow>",
                },
            ],
            force_entries: &[
                ::ezy_core::model::Formula {
                    text: "0",
                    latex: "0",
                    mathml: "<mrow><mn>0</mn></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "0",
                    latex: "0",
                    mathml: "<mrow><mn>0</mn></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "0",
                    latex: "0",
                    mathml: "<mrow><mn>0</mn></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "0",
                    latex: "0",
                    mathml: "<mrow><mn>0</mn></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "0",
                    latex: "0",
                    mathml: "<mrow><mn>0</mn></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "0",
                    latex: "0",
                    mathml: "<mrow><mn>0</mn></mrow>",
                },
            ],
            potential_energy: ::ezy_core::model::Formula {
                text: "0",
                latex: "0",
                mathml: "<mrow><mn>0</mn></mrow>",
            },
            abbreviations: &[],
            elimination: &[
                ::ezy_core::model::EliminationStep {
                    rows: &[2usize],
                    constant_pivot: true,
                },
                ::ezy_core::model::EliminationStep {
                    rows: &[3usize],
                    constant_pivot: true,
                },
                ::ezy_core::model::EliminationStep {
                    rows: &[0usize, 1usize],
                    constant_pivot: false,
                },
            ],
            acceleration_operations: ::ezy_core::model::Operations {
                add: 29usize,
                mul: 56usize,
                div: 1usize,
                trig: 2usize,
                calls: 0usize,
            },
            correction_operations: ::ezy_core::model::Operations {
                add: 23usize,
                mul: 42usize,
                div: 1usize,
                trig: 2usize,
                calls: 0usize,
            },
            series: ::ezy_core::model::SeriesInfo::Analytic {
                n_products: 16usize,
                operations: ::ezy_core::model::Operations {
                    add: 49usize,
                    mul: 86usize,
                    div: 0usize,
                    trig: 0usize,
                    calls: 0usize,
                },
            },
            repeats: ::core::option::Option::None,
        };
    }
    #[automatically_derived]
    impl<T: ::ezy_core::scalar::Scalar> ::ezy_core::model::Equations<T> for self::Coast {
        fn constants(&self, parameters: &[T], c: &mut [T]) {
            let parameters = ::ezy_core::kernel::array::<8usize, T>(parameters);
            let c = ::ezy_core::kernel::array_mut::<30usize, T>(c);
            let k1 = T::from_f64(1f64);
            let parameter_m1 = parameters[4usize];
            let parameter_i1 = parameters[5usize];
            let parameter_m2 = parameters[6usize];
            let parameter_i2 = parameters[7usize];
            let parameter_b = parameters[1usize];
            let parameter_d = parameters[3usize];
            let parameter_a = parameters[0usize];
            let parameter_c = parameters[2usize];
            let k11 = T::PI;
            let k12 = T::from_f64(2f64);
            let k13 = k11 / k12;
            let k14 = k1 / parameter_m1;
            let k15 = k1 / parameter_i1;
            let k16 = k1 / parameter_m2;
            let k17 = k1 / parameter_i2;
            let k18 = parameter_b * parameter_b;
            let k19 = k18 * k15;
            let k20 = parameter_d * parameter_d;
            let k21 = k20 * k17;
            let k22 = k14 + k19;
            let k23 = k22 + k16;
            let k24 = k23 + k21;
            let k25 = parameter_b * parameter_a;
            let k26 = k25 * k15;
            let k27 = k26 - k14;
            let k28 = parameter_d * parameter_c;
            let k29 = k28 * k17;
            let k30 = k16 - k29;
            let k31 = k14 + k16;
            let k32 = parameter_a * parameter_a;
            let k33 = k32 * k15;
            let k34 = k14 + k33;
            let k35 = parameter_c * parameter_c;
            let k36 = k35 * k17;
            let k37 = k16 + k36;
            let k38 = k1 / k34;
            let k39 = k27 * k38;
            let k40 = k39 * k27;
            let k41 = k24 - k40;
            let k42 = k40 - k19;
            let k43 = k1 / k37;
            let k44 = k30 * k43;
            let k45 = k44 * k30;
            let k46 = k41 - k45;
            let k47 = k45 - k21;
            let k48 = parameter_b * k15;
            let k49 = parameter_a * k15;
            let k50 = parameter_d * k17;
            let k51 = parameter_c * k17;
            let k52 = T::from_f64(0.0000000001f64);
            let k53 = k52 * k34;
            let k54 = k52 * k37;
            let k55 = k24 + k31;
            let k56 = k55 * k55;
            let k57 = k52 * k56;
            c[0usize] = k42;
            c[1usize] = k47;
            c[2usize] = k46;
            c[3usize] = k31;
            c[4usize] = parameter_b;
            c[5usize] = parameter_d;
            c[6usize] = k39;
            c[7usize] = k44;
            c[8usize] = k43;
            c[9usize] = k38;
            c[10usize] = k14;
            c[11usize] = k48;
            c[12usize] = k49;
            c[13usize] = k16;
            c[14usize] = k50;
            c[15usize] = k51;
            c[16usize] = k34;
            c[17usize] = k53;
            c[18usize] = k37;
            c[19usize] = k54;
            c[20usize] = k57;
            c[21usize] = k15;
            c[22usize] = k17;
            c[23usize] = parameter_m1;
            c[24usize] = parameter_i1;
            c[25usize] = parameter_m2;
            c[26usize] = parameter_i2;
            c[27usize] = parameter_a;
            c[28usize] = parameter_c;
            c[29usize] = k13;
        }
        fn mass_matrix(&self, c: &[T], m: &mut [T]) {
            let c = ::ezy_core::kernel::array::<30usize, T>(c);
            let out = ::ezy_core::kernel::array_mut::<6usize, T>(m);
            out[0usize] = c[23usize];
            out[1usize] = c[23usize];
            out[2usize] = c[24usize];
            out[3usize] = c[25usize];
            out[4usize] = c[25usize];
            out[5usize] = c[26usize];
        }
        fn position_constraint(&self, c: &[T], t: T, q: &[T], out: &mut [T]) {
            let c = ::ezy_core::kernel::array::<30usize, T>(c);
            let q = ::ezy_core::kernel::array::<6usize, T>(q);
            let out = ::ezy_core::kernel::array_mut::<2usize, T>(out);
            let seat_x = q[0usize];
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let sum_7 = T::fused(c[4usize], cos_seat_phi, seat_x);
            let bar_x = q[3usize];
            let difference_9 = sum_7 - bar_x;
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
            let sum_14 = T::fused(c[5usize], cos_bar_phi, difference_9);
            let seat_y = q[1usize];
            let sum_18 = T::fused(c[4usize], sin_seat_phi, seat_y);
            let bar_y = q[4usize];
            let difference_20 = sum_18 - bar_y;
            let sum_23 = T::fused(c[5usize], sin_bar_phi, difference_20);
            out[0usize] = sum_14;
            out[1usize] = sum_23;
        }
        fn velocity_constraint(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
            let c = ::ezy_core::kernel::array::<30usize, T>(c);
            let q = ::ezy_core::kernel::array::<6usize, T>(q);
            let v = ::ezy_core::kernel::array::<6usize, T>(v);
            let out = ::ezy_core::kernel::array_mut::<4usize, T>(out);
            let seat_vx = v[0usize];
            let seat_omega = v[2usize];
            let product_5 = c[4usize] * seat_omega;
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let difference_9 = T::fused(-product_5, sin_seat_phi, seat_vx);
            let bar_vx = v[3usize];
            let difference_11 = difference_9 - bar_vx;
            let bar_omega = v[5usize];
            let product_14 = c[5usize] * bar_omega;
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
            let difference_18 = T::fused(-product_14, sin_bar_phi, difference_11);
            let seat_vy = v[1usize];
            let bar_vy = v[4usize];
            let difference_21 = seat_vy - bar_vy;
            let sum_24 = T::fused(product_5, cos_seat_phi, difference_21);
            let sum_27 = T::fused(product_14, cos_bar_phi, sum_24);
            let product_29 = seat_omega * c[27usize];
            let sum_31 = T::fused(seat_vx, sin_seat_phi, product_29);
            let difference_33 = T::fused(seat_vy, cos_seat_phi, -sum_31);
            let product_35 = bar_omega * c[28usize];
            let difference_37 = T::fused(-bar_vx, sin_bar_phi, product_35);
            let sum_39 = T::fused(bar_vy, cos_bar_phi, difference_37);
            out[0usize] = difference_18;
            out[1usize] = sum_27;
            out[2usize] = difference_33;
            out[3usize] = sum_39;
        }
        fn velocity_jacobian(&self, c: &[T], t: T, q: &[T], out: &mut [T]) {
            let c = ::ezy_core::kernel::array::<30usize, T>(c);
            let q = ::ezy_core::kernel::array::<6usize, T>(q);
            let out = ::ezy_core::kernel::array_mut::<14usize, T>(out);
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let product_4 = c[4usize] * sin_seat_phi;
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
            let product_8 = c[5usize] * sin_bar_phi;
            let product_10 = c[4usize] * cos_seat_phi;
            let product_12 = c[5usize] * cos_bar_phi;
            let value_15 = -product_4;
            let value_16 = -T::from_f64(1f64);
            let value_17 = -product_8;
            let value_18 = -sin_seat_phi;
            let value_19 = -c[27usize];
            let value_20 = -sin_bar_phi;
            out[0usize] = T::from_f64(1f64);
            out[1usize] = value_15;
            out[2usize] = value_16;
            out[3usize] = value_17;
            out[4usize] = T::from_f64(1f64);
            out[5usize] = product_10;
            out[6usize] = value_16;
            out[7usize] = product_12;
            out[8usize] = value_18;
            out[9usize] = cos_seat_phi;
            out[10usize] = value_19;
            out[11usize] = value_20;
            out[12usize] = cos_bar_phi;
            out[13usize] = c[28usize];
        }
        fn convective_term(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
            let c = ::ezy_core::kernel::array::<30usize, T>(c);
            let q = ::ezy_core::kernel::array::<6usize, T>(q);
            let v = ::ezy_core::kernel::array::<6usize, T>(v);
            let out = ::ezy_core::kernel::array_mut::<4usize, T>(out);
            let seat_omega = v[2usize];
            let product_3 = c[4usize] * seat_omega;
            let product_4 = seat_omega * product_3;
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let product_8 = product_4 * cos_seat_phi;
            let bar_omega = v[5usize];
            let product_11 = c[5usize] * bar_omega;
            let product_12 = bar_omega * product_11;
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
            let sum_16 = T::fused(product_12, cos_bar_phi, product_8);
            let product_18 = product_4 * sin_seat_phi;
            let sum_21 = T::fused(product_12, sin_bar_phi, product_18);
            let seat_vx = v[0usize];
            let product_23 = cos_seat_phi * seat_vx;
            let seat_vy = v[1usize];
            let sum_26 = T::fused(sin_seat_phi, seat_vy, product_23);
            let product_27 = seat_omega * sum_26;
            let bar_vx = v[3usize];
            let product_29 = cos_bar_phi * bar_vx;
            let bar_vy = v[4usize];
            let sum_32 = T::fused(sin_bar_phi, bar_vy, product_29);
            let product_33 = bar_omega * sum_32;
            let value_34 = -sum_16;
            let value_35 = -sum_21;
            let value_36 = -product_27;
            let value_37 = -product_33;
            out[0usize] = value_34;
            out[1usize] = value_35;
            out[2usize] = value_36;
            out[3usize] = value_37;
        }
        fn applied_force(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
            let c = ::ezy_core::kernel::array::<30usize, T>(c);
            let q = ::ezy_core::kernel::array::<6usize, T>(q);
            let v = ::ezy_core::kernel::array::<6usize, T>(v);
            let out = ::ezy_core::kernel::array_mut::<6usize, T>(out);
            out[0usize] = T::from_f64(0f64);
            out[1usize] = T::from_f64(0f64);
            out[2usize] = T::from_f64(0f64);
            out[3usize] = T::from_f64(0f64);
            out[4usize] = T::from_f64(0f64);
            out[5usize] = T::from_f64(0f64);
        }
        #[inline]
        fn accelerations(
            &self,
            c: &[T],
            t: T,
            q: &[T],
            v: &[T],
            a: &mut [T],
            lambda: &mut [T],
        ) -> ::ezy_core::model::DeficientRows {
            let c = ::ezy_core::kernel::array::<30usize, T>(c);
            let q = ::ezy_core::kernel::array::<6usize, T>(q);
            let v = ::ezy_core::kernel::array::<6usize, T>(v);
            let a = ::ezy_core::kernel::array_mut::<6usize, T>(a);
            let lambda = ::ezy_core::kernel::array_mut::<4usize, T>(lambda);
            let seat_vx = v[0usize];
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let product_5 = seat_vx * cos_seat_phi;
            let seat_vy = v[1usize];
            let sum_9 = T::fused(seat_vy, sin_seat_phi, product_5);
            let seat_omega = v[2usize];
            let minus_right_side_rear = sum_9 * seat_omega;
            let bar_vx = v[3usize];
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
            let product_15 = bar_vx * cos_bar_phi;
            let bar_vy = v[4usize];
            let sum_19 = T::fused(bar_vy, sin_bar_phi, product_15);
            let bar_omega = v[5usize];
            let minus_right_side_front = sum_19 * bar_omega;
            let product_23 = cos_seat_phi * c[0usize];
            let product_24 = cos_seat_phi * product_23;
            let product_26 = cos_bar_phi * c[1usize];
            let sum_28 = T::fused(cos_bar_phi, product_26, product_24);
            let sum_30 = sum_28 + c[2usize];
            let product_31 = sin_seat_phi * c[0usize];
            let product_32 = cos_seat_phi * product_31;
            let product_33 = sin_bar_phi * c[1usize];
            let sum_35 = T::fused(cos_bar_phi, product_33, product_32);
            let difference_37 = c[3usize] - sum_28;
            let product_39 = seat_omega * c[4usize];
            let product_40 = seat_omega * product_39;
            let product_41 = cos_seat_phi * product_40;
            let product_43 = bar_omega * c[5usize];
            let product_44 = bar_omega * product_43;
            let sum_46 = T::fused(cos_bar_phi, product_44, product_41);
            let product_48 = minus_right_side_rear * c[6usize];
            let difference_50 = T::fused(sin_seat_phi, product_48, -sum_46);
            let product_52 = minus_right_side_front * c[7usize];
            let sum_54 = T::fused(sin_bar_phi, product_52, difference_50);
            let product_55 = sin_seat_phi * product_40;
            let sum_57 = T::fused(sin_bar_phi, product_44, product_55);
            let sum_59 = T::fused(cos_seat_phi, product_48, sum_57);
            let sum_61 = T::fused(cos_bar_phi, product_52, sum_59);
            let product_62 = sum_30 * difference_37;
            let difference_64 = T::fused(-sum_35, sum_35, product_62);
            let quotient_65 = T::from_f64(1f64) / difference_64;
            let product_66 = difference_37 * sum_54;
            let sum_68 = T::fused(sum_35, sum_61, product_66);
            let lambda_B_x = quotient_65 * sum_68;
            let product_70 = sum_35 * sum_54;
            let sum_72 = T::fused(sum_30, sum_61, product_70);
            let minus_lambda_B_y = quotient_65 * sum_72;
            let product_74 = sin_bar_phi * lambda_B_x;
            let sum_76 = T::fused(cos_bar_phi, minus_lambda_B_y, product_74);
            let product_77 = c[7usize] * sum_76;
            let minus_lambda_front = T::fused(
                minus_right_side_front,
                c[8usize],
                product_77,
            );
            let product_81 = sin_seat_phi * lambda_B_x;
            let sum_83 = T::fused(cos_seat_phi, minus_lambda_B_y, product_81);
            let product_84 = c[6usize] * sum_83;
            let minus_lambda_rear = T::fused(
                minus_right_side_rear,
                c[9usize],
                product_84,
            );
            let sum_89 = T::fused(sin_seat_phi, minus_lambda_rear, lambda_B_x);
            let product_91 = sum_89 * c[10usize];
            let sum_93 = T::fused(cos_seat_phi, minus_lambda_rear, minus_lambda_B_y);
            let product_94 = c[10usize] * sum_93;
            let product_96 = sum_83 * c[11usize];
            let difference_99 = T::fused(-minus_lambda_rear, c[12usize], product_96);
            let difference_101 = T::fused(-sin_bar_phi, minus_lambda_front, lambda_B_x);
            let product_103 = difference_101 * c[13usize];
            let difference_105 = T::fused(
                cos_bar_phi,
                minus_lambda_front,
                -minus_lambda_B_y,
            );
            let product_106 = c[13usize] * difference_105;
            let product_108 = sum_76 * c[14usize];
            let sum_111 = T::fused(minus_lambda_front, c[15usize], product_108);
            let value_117 = -product_91;
            let value_118 = -minus_lambda_B_y;
            let value_119 = -minus_lambda_rear;
            let value_120 = -minus_lambda_front;
            a[0usize] = value_117;
            a[1usize] = product_94;
            a[2usize] = difference_99;
            a[3usize] = product_103;
            a[4usize] = product_106;
            a[5usize] = sum_111;
            lambda[0usize] = lambda_B_x;
            lambda[1usize] = value_118;
            lambda[2usize] = value_119;
            lambda[3usize] = value_120;
            ::ezy_core::model::DeficientRows(0)
                .mark(2usize, !T::is_above(c[16usize], c[17usize]))
                .mark(3usize, !T::is_above(c[18usize], c[19usize]))
                .mark(0usize, !T::is_above(difference_64, c[20usize]))
                .mark(1usize, !T::is_above(difference_64, c[20usize]))
        }
        #[inline]
        fn correction(
            &self,
            c: &[T],
            t: T,
            q: &[T],
            residual: &[T],
            delta: &mut [T],
        ) -> ::ezy_core::model::DeficientRows {
            let c = ::ezy_core::kernel::array::<30usize, T>(c);
            let q = ::ezy_core::kernel::array::<6usize, T>(q);
            let residual = ::ezy_core::kernel::array::<4usize, T>(residual);
            let delta = ::ezy_core::kernel::array_mut::<6usize, T>(delta);
            let right_side_rear = residual[2usize];
            let right_side_front = residual[3usize];
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let product_7 = c[0usize] * cos_seat_phi;
            let product_8 = cos_seat_phi * product_7;
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
            let product_12 = c[1usize] * cos_bar_phi;
            let sum_14 = T::fused(cos_bar_phi, product_12, product_8);
            let sum_16 = sum_14 + c[2usize];
            let product_18 = c[0usize] * sin_seat_phi;
            let product_19 = cos_seat_phi * product_18;
            let product_21 = c[1usize] * sin_bar_phi;
            let sum_23 = T::fused(cos_bar_phi, product_21, product_19);
            let difference_25 = c[3usize] - sum_14;
            let residual_0 = residual[0usize];
            let product_28 = right_side_rear * c[6usize];
            let difference_30 = T::fused(-sin_seat_phi, product_28, residual_0);
            let product_32 = right_side_front * c[7usize];
            let difference_34 = T::fused(-sin_bar_phi, product_32, difference_30);
            let residual_1 = residual[1usize];
            let sum_37 = T::fused(cos_seat_phi, product_28, residual_1);
            let sum_39 = T::fused(cos_bar_phi, product_32, sum_37);
            let product_40 = sum_16 * difference_25;
            let difference_42 = T::fused(-sum_23, sum_23, product_40);
            let quotient_43 = T::from_f64(1f64) / difference_42;
            let product_44 = difference_25 * difference_34;
            let difference_46 = T::fused(-sum_23, sum_39, product_44);
            let lambda_B_x = quotient_43 * difference_46;
            let product_49 = sum_16 * sum_39;
            let difference_50 = T::fused(-sum_23, difference_34, product_49);
            let lambda_B_y = quotient_43 * difference_50;
            let product_53 = cos_bar_phi * lambda_B_y;
            let difference_54 = T::fused(-sin_bar_phi, lambda_B_x, product_53);
            let product_55 = c[7usize] * difference_54;
            let lambda_front = T::fused(right_side_front, c[8usize], product_55);
            let product_60 = cos_seat_phi * lambda_B_y;
            let difference_61 = T::fused(-sin_seat_phi, lambda_B_x, product_60);
            let product_62 = c[6usize] * difference_61;
            let lambda_rear = T::fused(right_side_rear, c[9usize], product_62);
            let difference_67 = T::fused(sin_seat_phi, lambda_rear, -lambda_B_x);
            let product_69 = difference_67 * c[10usize];
            let sum_71 = T::fused(cos_seat_phi, lambda_rear, lambda_B_y);
            let product_72 = c[10usize] * sum_71;
            let product_76 = lambda_rear * c[12usize];
            let difference_77 = T::fused(-difference_61, c[11usize], product_76);
            let sum_79 = T::fused(sin_bar_phi, lambda_front, lambda_B_x);
            let product_81 = sum_79 * c[13usize];
            let difference_83 = T::fused(-cos_bar_phi, lambda_front, lambda_B_y);
            let product_84 = c[13usize] * difference_83;
            let product_86 = difference_54 * c[14usize];
            let sum_89 = T::fused(lambda_front, c[15usize], product_86);
            let value_95 = -product_72;
            let value_96 = -sum_89;
            delta[0usize] = product_69;
            delta[1usize] = value_95;
            delta[2usize] = difference_77;
            delta[3usize] = product_81;
            delta[4usize] = product_84;
            delta[5usize] = value_96;
            ::ezy_core::model::DeficientRows(0)
                .mark(2usize, !T::is_above(c[16usize], c[17usize]))
                .mark(3usize, !T::is_above(c[18usize], c[19usize]))
                .mark(0usize, !T::is_above(difference_42, c[20usize]))
                .mark(1usize, !T::is_above(difference_42, c[20usize]))
        }
    }
    #[automatically_derived]
    impl ::ezy_core::model::Scene for Coast {
        fn info(&self) -> &'static ::ezy_core::model::SceneInfo {
            static INFO: ::ezy_core::model::SceneInfo = Coast::INFO;
            &INFO
        }
        fn parameter(&self, index: usize) -> f64 {
            match index {
                0usize => self.a,
                1usize => self.b,
                2usize => self.c,
                3usize => self.d,
                4usize => self.m1,
                5usize => self.i1,
                6usize => self.m2,
                7usize => self.i2,
                _ => f64::NAN,
            }
        }
        fn set_parameter(&mut self, index: usize, value: f64) {
            match index {
                0usize => self.a = value,
                1usize => self.b = value,
                2usize => self.c = value,
                3usize => self.d = value,
                4usize => self.m1 = value,
                5usize => self.i1 = value,
                6usize => self.m2 = value,
                7usize => self.i2 = value,
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
            let c = ::ezy_core::kernel::array::<30usize, f64>(c);
            let q = ::ezy_core::kernel::array::<6usize, f64>(q);
            let v = ::ezy_core::kernel::array::<6usize, f64>(v);
            let lambda = ::ezy_core::kernel::array::<4usize, f64>(lambda);
            let out = ::ezy_core::kernel::array_mut::<0usize, f64>(out);
        }
        fn points(&self, c: &[f64], t: f64, q: &[f64], out: &mut [f64]) {
            let c = ::ezy_core::kernel::array::<30usize, f64>(c);
            let q = ::ezy_core::kernel::array::<6usize, f64>(q);
            let out = ::ezy_core::kernel::array_mut::<6usize, f64>(out);
            let seat_x = q[0usize];
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = f64::sin_cos(seat_phi);
            let product_6 = c[27usize] * cos_seat_phi;
            let difference_7 = seat_x - product_6;
            let seat_y = q[1usize];
            let product_10 = c[27usize] * sin_seat_phi;
            let difference_11 = seat_y - product_10;
            let bar_x = q[3usize];
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = f64::sin_cos(bar_phi);
            let product_16 = c[28usize] * cos_bar_phi;
            let sum_17 = bar_x + product_16;
            let bar_y = q[4usize];
            let product_20 = c[28usize] * sin_bar_phi;
            let sum_21 = bar_y + product_20;
            let product_23 = cos_seat_phi * c[4usize];
            let sum_24 = seat_x + product_23;
            let product_25 = sin_seat_phi * c[4usize];
            let sum_26 = seat_y + product_25;
            out[0usize] = difference_7;
            out[1usize] = difference_11;
            out[2usize] = sum_17;
            out[3usize] = sum_21;
            out[4usize] = sum_24;
            out[5usize] = sum_26;
        }
        fn outputs(&self, c: &[f64], t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
            let c = ::ezy_core::kernel::array::<30usize, f64>(c);
            let q = ::ezy_core::kernel::array::<6usize, f64>(q);
            let v = ::ezy_core::kernel::array::<6usize, f64>(v);
            let out = ::ezy_core::kernel::array_mut::<0usize, f64>(out);
        }
        fn potential_energy(&self, c: &[f64], t: f64, q: &[f64]) -> f64 {
            0f64
        }
        fn start(&self, c: &[f64], start: &mut ::ezy_core::model::Start) {
            let c = ::ezy_core::kernel::array::<30usize, f64>(c);
            start.give_position(0usize, c[27usize]);
            start.give_position(1usize, 0f64);
            start.give_position(2usize, 0f64);
            start.give_position(5usize, c[29usize]);
            start.give_velocity(0usize, 1f64);
            start.give_velocity(2usize, 0f64);
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
    impl<T: ::ezy_core::scalar::Scalar> ::ezy_core::model::Series<T> for Coast {
        fn series_size(&self) -> ::ezy_core::model::SeriesSize {
            ::ezy_core::model::SeriesSize {
                n_coordinates: 6usize,
                n_rows: 4usize,
                n_products: 16usize,
                n_base: 8usize,
                n_kept: 0usize,
            }
        }
        fn begin(
            &self,
            c: &[T],
            t: T,
            store: &mut ::ezy_core::model::SeriesStore<T>,
        ) -> ::ezy_core::model::DeficientRows {
            let c = ::ezy_core::kernel::array::<30usize, T>(c);
            let q = ::ezy_core::kernel::row::<6usize, T>(&store.q, 0);
            let v = ::ezy_core::kernel::row::<6usize, T>(&store.q, 1);
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
            let seat_omega = v[2usize];
            let product_25 = c[4usize] * seat_omega;
            let product_26 = seat_omega * product_25;
            let product_27 = cos_seat_phi * product_26;
            let bar_omega = v[5usize];
            let product_29 = c[5usize] * bar_omega;
            let product_30 = bar_omega * product_29;
            let sum_32 = T::fused(cos_bar_phi, product_30, product_27);
            let product_33 = sin_seat_phi * product_26;
            let sum_35 = T::fused(sin_bar_phi, product_30, product_33);
            let seat_vx = v[0usize];
            let product_37 = cos_seat_phi * seat_vx;
            let seat_vy = v[1usize];
            let sum_40 = T::fused(sin_seat_phi, seat_vy, product_37);
            let product_41 = seat_omega * sum_40;
            let bar_vx = v[3usize];
            let product_43 = cos_bar_phi * bar_vx;
            let bar_vy = v[4usize];
            let sum_46 = T::fused(sin_bar_phi, bar_vy, product_43);
            let product_47 = bar_omega * sum_46;
            let product_75 = cos_seat_phi * c[0usize];
            let product_76 = cos_seat_phi * product_75;
            let product_78 = cos_bar_phi * c[1usize];
            let sum_80 = T::fused(cos_bar_phi, product_78, product_76);
            let sum_82 = sum_80 + c[2usize];
            let product_83 = sin_seat_phi * c[0usize];
            let product_84 = cos_seat_phi * product_83;
            let product_85 = sin_bar_phi * c[1usize];
            let sum_87 = T::fused(cos_bar_phi, product_85, product_84);
            let difference_89 = c[3usize] - sum_80;
            let product_118 = sum_82 * difference_89;
            let difference_120 = T::fused(-sum_87, sum_87, product_118);
            let quotient_121 = T::from_f64(1f64) / difference_120;
            let product_177 = cos_seat_phi * seat_omega;
            let product_178 = sin_seat_phi * seat_omega;
            let product_179 = cos_bar_phi * bar_omega;
            let product_180 = sin_bar_phi * bar_omega;
            let value_181 = -product_178;
            let value_182 = -product_180;
            let target = ::ezy_core::kernel::array_mut::<8usize, T>(&mut store.base);
            target[0usize] = cos_seat_phi;
            target[1usize] = sin_seat_phi;
            target[2usize] = cos_bar_phi;
            target[3usize] = sin_bar_phi;
            target[4usize] = quotient_121;
            target[5usize] = difference_89;
            target[6usize] = sum_87;
            target[7usize] = sum_82;
            let target = ::ezy_core::kernel::array_mut::<6usize, T>(&mut store.force);
            target[0usize] = T::from_f64(0f64);
            target[1usize] = T::from_f64(0f64);
            target[2usize] = T::from_f64(0f64);
            target[3usize] = T::from_f64(0f64);
            target[4usize] = T::from_f64(0f64);
            target[5usize] = T::from_f64(0f64);
            let target = ::ezy_core::kernel::row_mut::<
                16usize,
                T,
            >(&mut store.left, 1usize);
            target[0usize] = product_177;
            target[1usize] = value_181;
            target[2usize] = product_177;
            target[3usize] = value_181;
            target[4usize] = product_179;
            target[5usize] = value_182;
            target[6usize] = product_179;
            target[7usize] = value_182;
            target[8usize] = seat_omega;
            target[9usize] = bar_omega;
            target[10usize] = seat_omega;
            target[11usize] = bar_omega;
            target[12usize] = product_177;
            target[13usize] = value_181;
            target[14usize] = product_179;
            target[15usize] = value_182;
            let target = ::ezy_core::kernel::row_mut::<
                16usize,
                T,
            >(&mut store.right, 1usize);
            target[0usize] = T::from_f64(0f64);
            target[1usize] = T::from_f64(0f64);
            target[2usize] = T::from_f64(0f64);
            target[3usize] = T::from_f64(0f64);
            target[4usize] = T::from_f64(0f64);
            target[5usize] = T::from_f64(0f64);
            target[6usize] = T::from_f64(0f64);
            target[7usize] = T::from_f64(0f64);
            target[8usize] = product_177;
            target[9usize] = product_179;
            target[10usize] = value_181;
            target[11usize] = value_182;
            target[12usize] = seat_vx;
            target[13usize] = seat_vy;
            target[14usize] = bar_vx;
            target[15usize] = bar_vy;
            let target = ::ezy_core::kernel::array_mut::<4usize, T>(&mut store.row);
            target[0usize] = sum_32;
            target[1usize] = sum_35;
            target[2usize] = product_41;
            target[3usize] = product_47;
            ::ezy_core::model::DeficientRows(0)
                .mark(2usize, !T::is_above(c[16usize], c[17usize]))
                .mark(3usize, !T::is_above(c[18usize], c[19usize]))
                .mark(0usize, !T::is_above(difference_120, c[20usize]))
                .mark(1usize, !T::is_above(difference_120, c[20usize]))
        }
        #[inline]
        fn right_side(
            &self,
            c: &[T],
            k: usize,
            store: &mut ::ezy_core::model::SeriesStore<T>,
        ) {
            let c = ::ezy_core::kernel::array::<30usize, T>(c);
            let sums = ::ezy_core::kernel::array::<16usize, T>(&store.sums);
            let convolved_0 = sums[0usize];
            let convolved_1 = sums[1usize];
            let convolved_2 = sums[2usize];
            let product_6 = c[4usize] * convolved_2;
            let convolved_3 = sums[3usize];
            let difference_9 = T::fused(-c[4usize], convolved_3, product_6);
            let convolved_4 = sums[4usize];
            let convolved_5 = sums[5usize];
            let convolved_6 = sums[6usize];
            let product_14 = c[5usize] * convolved_6;
            let convolved_7 = sums[7usize];
            let difference_17 = T::fused(-c[5usize], convolved_7, product_14);
            let convolved_8 = sums[8usize];
            let inverse_order_ahead = T::from_f64(1f64)
                / T::from_f64((k + 2usize) as f64);
            let product_20 = convolved_8 * inverse_order_ahead;
            let product_21 = c[4usize] * product_20;
            let convolved_9 = sums[9usize];
            let product_23 = inverse_order_ahead * convolved_9;
            let sum_25 = T::fused(c[5usize], product_23, product_21);
            let order_next = T::from_f64((k + 1usize) as f64);
            let order_ahead = T::from_f64((k + 2usize) as f64);
            let product_28 = order_next * order_ahead;
            let product_29 = sum_25 * product_28;
            let convolved_10 = sums[10usize];
            let product_31 = inverse_order_ahead * convolved_10;
            let product_32 = c[4usize] * product_31;
            let convolved_11 = sums[11usize];
            let product_34 = inverse_order_ahead * convolved_11;
            let sum_36 = T::fused(c[5usize], product_34, product_32);
            let product_37 = product_28 * sum_36;
            let convolved_12 = sums[12usize];
            let convolved_13 = sums[13usize];
            let difference_40 = convolved_12 - convolved_13;
            let product_41 = order_next * difference_40;
            let convolved_14 = sums[14usize];
            let convolved_15 = sums[15usize];
            let difference_44 = convolved_14 - convolved_15;
            let product_45 = order_next * difference_44;
            let value_46 = -convolved_1;
            let value_47 = -convolved_5;
            let value_48 = -product_37;
            let target = ::ezy_core::kernel::array_mut::<6usize, T>(&mut store.force);
            target[0usize] = convolved_0;
            target[1usize] = value_46;
            target[2usize] = difference_9;
            target[3usize] = convolved_4;
            target[4usize] = value_47;
            target[5usize] = difference_17;
            let target = ::ezy_core::kernel::array_mut::<4usize, T>(&mut store.row);
            target[0usize] = product_29;
            target[1usize] = value_48;
            target[2usize] = product_41;
            target[3usize] = product_45;
        }
        #[inline]
        fn solve(
            &self,
            c: &[T],
            k: usize,
            store: &mut ::ezy_core::model::SeriesStore<T>,
        ) {
            let c = ::ezy_core::kernel::array::<30usize, T>(c);
            let base = ::ezy_core::kernel::array::<8usize, T>(&store.base);
            let force = ::ezy_core::kernel::array::<6usize, T>(&store.force);
            let row = ::ezy_core::kernel::array::<4usize, T>(&store.row);
            let force_0 = force[0usize];
            let base_4 = base[4usize];
            let base_5 = base[5usize];
            let base_1 = base[1usize];
            let force_2 = force[2usize];
            let product_8 = force_2 * c[11usize];
            let base_0 = base[0usize];
            let force_1 = force[1usize];
            let product_11 = base_0 * force_1;
            let difference_13 = T::fused(-force_0, base_1, product_11);
            let product_14 = c[10usize] * difference_13;
            let difference_17 = T::fused(-force_2, c[12usize], product_14);
            let row_2 = row[2usize];
            let right_side_rear = difference_17 - row_2;
            let sum_22 = T::fused(right_side_rear, c[6usize], product_8);
            let product_23 = base_1 * sum_22;
            let base_3 = base[3usize];
            let force_5 = force[5usize];
            let product_27 = force_5 * c[14usize];
            let base_2 = base[2usize];
            let force_4 = force[4usize];
            let product_30 = base_2 * force_4;
            let force_3 = force[3usize];
            let difference_33 = T::fused(-base_3, force_3, product_30);
            let product_35 = difference_33 * c[13usize];
            let sum_38 = T::fused(force_5, c[15usize], product_35);
            let row_3 = row[3usize];
            let right_side_front = sum_38 - row_3;
            let sum_43 = T::fused(right_side_front, c[7usize], product_27);
            let sum_45 = T::fused(base_3, sum_43, product_23);
            let difference_46 = T::fused(c[10usize], force_0, -sum_45);
            let difference_48 = T::fused(-force_3, c[13usize], difference_46);
            let row_0 = row[0usize];
            let difference_50 = difference_48 - row_0;
            let product_51 = base_5 * difference_50;
            let base_6 = base[6usize];
            let product_53 = base_0 * sum_22;
            let sum_55 = T::fused(base_2, sum_43, product_53);
            let sum_57 = T::fused(c[10usize], force_1, sum_55);
            let difference_59 = T::fused(-force_4, c[13usize], sum_57);
            let row_1 = row[1usize];
            let difference_61 = difference_59 - row_1;
            let difference_63 = T::fused(-base_6, difference_61, product_51);
            let lambda_B_x = base_4 * difference_63;
            let difference_65 = force_0 - lambda_B_x;
            let base_7 = base[7usize];
            let product_67 = difference_61 * base_7;
            let difference_69 = T::fused(-difference_50, base_6, product_67);
            let lambda_B_y = base_4 * difference_69;
            let product_71 = base_0 * lambda_B_y;
            let difference_73 = T::fused(-base_1, lambda_B_x, product_71);
            let product_74 = c[6usize] * difference_73;
            let lambda_rear = T::fused(right_side_rear, c[9usize], product_74);
            let sum_79 = T::fused(base_1, lambda_rear, difference_65);
            let product_80 = c[10usize] * sum_79;
            let difference_81 = force_1 - lambda_B_y;
            let difference_83 = T::fused(-base_0, lambda_rear, difference_81);
            let product_84 = c[10usize] * difference_83;
            let product_86 = force_2 * c[21usize];
            let difference_88 = T::fused(-c[11usize], difference_73, product_86);
            let sum_90 = T::fused(c[12usize], lambda_rear, difference_88);
            let sum_91 = force_3 + lambda_B_x;
            let product_92 = base_2 * lambda_B_y;
            let difference_94 = T::fused(-base_3, lambda_B_x, product_92);
            let product_95 = c[7usize] * difference_94;
            let lambda_front = T::fused(right_side_front, c[8usize], product_95);
            let sum_100 = T::fused(base_3, lambda_front, sum_91);
            let product_101 = c[13usize] * sum_100;
            let sum_102 = force_4 + lambda_B_y;
            let difference_104 = T::fused(-base_2, lambda_front, sum_102);
            let product_105 = c[13usize] * difference_104;
            let product_107 = force_5 * c[22usize];
            let difference_109 = T::fused(-c[14usize], difference_94, product_107);
            let difference_111 = T::fused(-c[15usize], lambda_front, difference_109);
            let target = ::ezy_core::kernel::array_mut::<6usize, T>(&mut store.a);
            target[0usize] = product_80;
            target[1usize] = product_84;
            target[2usize] = sum_90;
            target[3usize] = product_101;
            target[4usize] = product_105;
            target[5usize] = difference_111;
            let target = ::ezy_core::kernel::row_mut::<
                4usize,
                T,
            >(&mut store.lambda, k + 0usize);
            target[0usize] = lambda_B_x;
            target[1usize] = lambda_B_y;
            target[2usize] = lambda_rear;
            target[3usize] = lambda_front;
        }
        #[inline]
        fn finish(
            &self,
            c: &[T],
            k: usize,
            store: &mut ::ezy_core::model::SeriesStore<T>,
        ) {
            let a = ::ezy_core::kernel::array::<6usize, T>(&store.a);
            let base = ::ezy_core::kernel::array::<8usize, T>(&store.base);
            let lambda_0 = ::ezy_core::kernel::row::<
                4usize,
                T,
            >(&store.lambda, k + 0usize);
            let sums = ::ezy_core::kernel::array::<16usize, T>(&store.sums);
            let a_0 = a[0usize];
            let inverse_order_next = T::from_f64(1f64)
                / T::from_f64((k + 1usize) as f64);
            let inverse_order_ahead = T::from_f64(1f64)
                / T::from_f64((k + 2usize) as f64);
            let product_3 = inverse_order_next * inverse_order_ahead;
            let product_4 = a_0 * product_3;
            let a_1 = a[1usize];
            let product_6 = product_3 * a_1;
            let a_2 = a[2usize];
            let product_8 = product_3 * a_2;
            let a_3 = a[3usize];
            let product_10 = product_3 * a_3;
            let a_4 = a[4usize];
            let product_12 = product_3 * a_4;
            let a_5 = a[5usize];
            let product_14 = product_3 * a_5;
            let lambda_2 = lambda_0[2usize];
            let convolved_10 = sums[10usize];
            let product_19 = inverse_order_ahead * convolved_10;
            let base_0 = base[0usize];
            let sum_22 = T::fused(product_8, base_0, product_19);
            let convolved_8 = sums[8usize];
            let product_24 = inverse_order_ahead * convolved_8;
            let base_1 = base[1usize];
            let sum_27 = T::fused(product_8, base_1, product_24);
            let lambda_0 = lambda_0[0usize];
            let lambda_1 = lambda_0[1usize];
            let lambda_3 = lambda_0[3usize];
            let convolved_11 = sums[11usize];
            let product_32 = inverse_order_ahead * convolved_11;
            let base_2 = base[2usize];
            let sum_35 = T::fused(product_14, base_2, product_32);
            let convolved_9 = sums[9usize];
            let product_37 = inverse_order_ahead * convolved_9;
            let base_3 = base[3usize];
            let sum_40 = T::fused(product_14, base_3, product_37);
            let order_ahead = T::from_f64((k + 2usize) as f64);
            let product_42 = product_8 * order_ahead;
            let product_43 = product_14 * order_ahead;
            let product_44 = product_4 * order_ahead;
            let product_45 = product_6 * order_ahead;
            let product_46 = product_10 * order_ahead;
            let product_47 = product_12 * order_ahead;
            let value_48 = -sum_27;
            let value_49 = -sum_40;
            let target = ::ezy_core::kernel::row_mut::<
                16usize,
                T,
            >(&mut store.left, k + 2usize);
            target[0usize] = sum_22;
            target[1usize] = value_48;
            target[2usize] = sum_22;
            target[3usize] = value_48;
            target[4usize] = sum_35;
            target[5usize] = value_49;
            target[6usize] = sum_35;
            target[7usize] = value_49;
            target[8usize] = product_42;
            target[9usize] = product_43;
            target[10usize] = product_42;
            target[11usize] = product_43;
            target[12usize] = sum_22;
            target[13usize] = value_48;
            target[14usize] = sum_35;
            target[15usize] = value_49;
            let target = ::ezy_core::kernel::row_mut::<
                6usize,
                T,
            >(&mut store.q, k + 2usize);
            target[0usize] = product_4;
            target[1usize] = product_6;
            target[2usize] = product_8;
            target[3usize] = product_10;
            target[4usize] = product_12;
            target[5usize] = product_14;
            let target = ::ezy_core::kernel::row_mut::<
                16usize,
                T,
            >(&mut store.right, k + 2usize);
            target[0usize] = lambda_2;
            target[1usize] = lambda_2;
            target[2usize] = lambda_0;
            target[3usize] = lambda_1;
            target[4usize] = lambda_3;
            target[5usize] = lambda_3;
            target[6usize] = lambda_0;
            target[7usize] = lambda_1;
            target[8usize] = sum_22;
            target[9usize] = sum_35;
            target[10usize] = value_48;
            target[11usize] = value_49;
            target[12usize] = product_44;
            target[13usize] = product_45;
            target[14usize] = product_46;
            target[15usize] = product_47;
        }
    }
    ///From rest, folded, driven by the rider's torque.
    ///
    ///Cost of the accelerations and multipliers: 63 mul, 35 add, 1 div, 3 sin–cos.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct Driven {
        ///rear wheel A, behind the seat's centre of mass (m); default `0.2`.
        pub a: f64,
        ///hinge B, ahead of the seat's centre of mass (m); default `0.6`.
        pub b: f64,
        ///front wheel C, beyond the bar's centre of mass (m); default `0.1`.
        pub c: f64,
        ///bar's centre of mass, beyond the hinge (m); default `0.1`.
        pub d: f64,
        ///mass of seat and rider (kg); default `46.0`.
        pub m1: f64,
        ///moment of inertia of seat and rider (kg*m^2); default `10.0`.
        pub i1: f64,
        ///mass of the bar (kg); default `1.0`.
        pub m2: f64,
        ///moment of inertia of the bar (kg*m^2); default `0.005`.
        pub i2: f64,
        ///largest torque (N*m); default `2.0`.
        pub m0: f64,
        ///angular frequency of the torque (rad/s); default `pi`.
        pub omega: f64,
    }
    impl ::core::default::Default for Driven {
        fn default() -> Self {
            Self {
                a: 0.2f64,
                b: 0.6f64,
                c: 0.1f64,
                d: 0.1f64,
                m1: 46f64,
                i1: 10f64,
                m2: 1f64,
                i2: 0.005f64,
                m0: 2f64,
                omega: 3.141592653589793f64,
            }
        }
    }
    impl Driven {
        /// What is known of the scene when it is compiled.
        pub const INFO: ::ezy_core::model::SceneInfo = ::ezy_core::model::SceneInfo {
            model: "EzyRoller",
            name: "driven",
            documentation: "From rest, folded, driven by the rider's torque.",
            bodies: &["seat", "bar"],
            coordinates: &[
                ::ezy_core::model::CoordinateInfo {
                    name: "seat.x",
                    velocity_name: "seat.vx",
                    unit: "m",
                    symbol: ::ezy_core::model::Formula {
                        text: "seat.x",
                        latex: "x_{\\mathrm{seat}}",
                        mathml: "<msub><mi>x</mi><mtext>seat</mtext></msub>",
                    },
                    velocity_symbol: ::ezy_core::model::Formula {
                        text: "seat.vx",
                        latex: "\\dot{x}_{\\mathrm{seat}}",
                        mathml: "<msub><mover><mi>x</mi><mo>.</mo></mover><mtext>seat</mtext></msub>",
                    },
                },
                ::ezy_core::model::CoordinateInfo {
                    name: "seat.y",
                    velocity_name: "seat.vy",
                    unit: "m",
                    symbol: ::ezy_core::model::Formula {
                        text: "seat.y",
                        latex: "y_{\\mathrm{seat}}",
                        mathml: "<msub><mi>y</mi><mtext>seat</mtext></msub>",
                    },
                    velocity_symbol: ::ezy_core::model::Formula {
                        text: "seat.vy",
                        latex: "\\dot{y}_{\\mathrm{seat}}",
                        mathml: "<msub><mover><mi>y</mi><mo>.</mo></mover><mtext>seat</mtext></msub>",
                    },
                },
                ::ezy_core::model::CoordinateInfo {
                    name: "seat.phi",
                    velocity_name: "seat.omega",
                    unit: "rad",
                    symbol: ::ezy_core::model::Formula {
                        text: "seat.phi",
                        latex: "\\varphi_{\\mathrm{seat}}",
                        mathml: "<msub><mi>φ</mi><mtext>seat</mtext></msub>",
                    },
                    velocity_symbol: ::ezy_core::model::Formula {
                        text: "seat.omega",
                        latex: "\\dot{\\varphi}_{\\mathrm{seat}}",
                        mathml: "<msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext></msub>",
                    },
                },
                ::ezy_core::model::CoordinateInfo {
                    name: "bar.x",
                    velocity_name: "bar.vx",
                    unit: "m",
                    symbol: ::ezy_core::model::Formula {
                        text: "bar.x",
                        latex: "x_{\\mathrm{bar}}",
                        mathml: "<msub><mi>x</mi><mtext>bar</mtext></msub>",
                    },
                    velocity_symbol: ::ezy_core::model::Formula {
                        text: "bar.vx",
                        latex: "\\dot{x}_{\\mathrm{bar}}",
                        mathml: "<msub><mover><mi>x</mi><mo>.</mo></mover><mtext>bar</mtext></msub>",
                    },
                },
                ::ezy_core::model::CoordinateInfo {
                    name: "bar.y",
                    velocity_name: "bar.vy",
                    unit: "m",
                    symbol: ::ezy_core::model::Formula {
                        text: "bar.y",
                        latex: "y_{\\mathrm{bar}}",
                        mathml: "<msub><mi>y</mi><mtext>bar</mtext></msub>",
                    },
                    velocity_symbol: ::ezy_core::model::Formula {
                        text: "bar.vy",
                        latex: "\\dot{y}_{\\mathrm{bar}}",
                        mathml: "<msub><mover><mi>y</mi><mo>.</mo></mover><mtext>bar</mtext></msub>",
                    },
                },
                ::ezy_core::model::CoordinateInfo {
                    name: "bar.phi",
                    velocity_name: "bar.omega",
                    unit: "rad",
                    symbol: ::ezy_core::model::Formula {
                        text: "bar.phi",
                        latex: "\\varphi_{\\mathrm{bar}}",
                        mathml: "<msub><mi>φ</mi><mtext>bar</mtext></msub>",
                    },
                    velocity_symbol: ::ezy_core::model::Formula {
                        text: "bar.omega",
                        latex: "\\dot{\\varphi}_{\\mathrm{bar}}",
                        mathml: "<msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext></msub>",
                    },
                },
            ],
            points: &[
                ::ezy_core::model::PointInfo {
                    name: "A",
                    body: ::core::option::Option::Some(0usize),
                    position: ::core::option::Option::Some([
                        ::ezy_core::model::Formula {
                            text: "seat.x - a*cos(seat.phi)",
                            latex: "x_{\\mathrm{seat}} - a \\, \\cos{\\varphi_{\\mathrm{seat}}}",
                            mathml: "<mrow><msub><mi>x</mi><mtext>seat</mtext></msub><mo>−</mo><mi>a</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                        },
                        ::ezy_core::model::Formula {
                            text: "seat.y - a*sin(seat.phi)",
                            latex: "y_{\\mathrm{seat}} - a \\, \\sin{\\varphi_{\\mathrm{seat}}}",
                            mathml: "<mrow><msub><mi>y</mi><mtext>seat</mtext></msub><mo>−</mo><mi>a</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                        },
                    ]),
                },
                ::ezy_core::model::PointInfo {
                    name: "C",
                    body: ::core::option::Option::Some(1usize),
                    position: ::core::option::Option::Some([
                        ::ezy_core::model::Formula {
                            text: "bar.x + c*cos(bar.phi)",
                            latex: "x_{\\mathrm{bar}} + c \\, \\cos{\\varphi_{\\mathrm{bar}}}",
                            mathml: "<mrow><msub><mi>x</mi><mtext>bar</mtext></msub><mo>+</mo><mi>c</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                        },
                        ::ezy_core::model::Formula {
                            text: "bar.y + c*sin(bar.phi)",
                            latex: "y_{\\mathrm{bar}} + c \\, \\sin{\\varphi_{\\mathrm{bar}}}",
                            mathml: "<mrow><msub><mi>y</mi><mtext>bar</mtext></msub><mo>+</mo><mi>c</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                        },
                    ]),
                },
                ::ezy_core::model::PointInfo {
                    name: "B",
                    body: ::core::option::Option::Some(0usize),
                    position: ::core::option::Option::Some([
                        ::ezy_core::model::Formula {
                            text: "seat.x + b*cos(seat.phi)",
                            latex: "x_{\\mathrm{seat}} + b \\, \\cos{\\varphi_{\\mathrm{seat}}}",
                            mathml: "<mrow><msub><mi>x</mi><mtext>seat</mtext></msub><mo>+</mo><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                        },
                        ::ezy_core::model::Formula {
                            text: "seat.y + b*sin(seat.phi)",
                            latex: "y_{\\mathrm{seat}} + b \\, \\sin{\\varphi_{\\mathrm{seat}}}",
                            mathml: "<mrow><msub><mi>y</mi><mtext>seat</mtext></msub><mo>+</mo><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                        },
                    ]),
                },
            ],
            rows: &[
                ::ezy_core::model::RowInfo {
                    name: "B.x",
                    kind: "hinge",
                    multiplier_unit: "N",
                    constraint: ::ezy_core::model::Formula {
                        text: "seat.x + b*cos(seat.phi) - bar.x + d*cos(bar.phi)",
                        latex: "x_{\\mathrm{seat}} + b \\, \\cos{\\varphi_{\\mathrm{seat}}} - x_{\\mathrm{bar}} + d \\, \\cos{\\varphi_{\\mathrm{bar}}}",
                        mathml: "<mrow><msub><mi>x</mi><mtext>seat</mtext></msub><mo>+</mo><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>−</mo><msub><mi>x</mi><mtext>bar</mtext></msub><mo>+</mo><mi>d</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                    },
                    convective_term: ::ezy_core::model::Formula {
                        text: "-b*seat.omega^2*cos(seat.phi) - d*bar.omega^2*cos(bar.phi)",
                        latex: "-b \\, \\dot{\\varphi}_{\\mathrm{seat}}^{2} \\, \\cos{\\varphi_{\\mathrm{seat}}} - d \\, \\dot{\\varphi}_{\\mathrm{bar}}^{2} \\, \\cos{\\varphi_{\\mathrm{bar}}}",
                        mathml: "<mrow><mo>−</mo><mi>b</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>−</mo><mi>d</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                    },
                },
                ::ezy_core::model::RowInfo {
                    name: "B.y",
                    kind: "hinge",
                    multiplier_unit: "N",
                    constraint: ::ezy_core::model::Formula {
                        text: "seat.y + b*sin(seat.phi) - bar.y + d*sin(bar.phi)",
                        latex: "y_{\\mathrm{seat}} + b \\, \\sin{\\varphi_{\\mathrm{seat}}} - y_{\\mathrm{bar}} + d \\, \\sin{\\varphi_{\\mathrm{bar}}}",
                        mathml: "<mrow><msub><mi>y</mi><mtext>seat</mtext></msub><mo>+</mo><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>−</mo><msub><mi>y</mi><mtext>bar</mtext></msub><mo>+</mo><mi>d</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                    },
                    convective_term: ::ezy_core::model::Formula {
                        text: "-b*seat.omega^2*sin(seat.phi) - d*bar.omega^2*sin(bar.phi)",
                        latex: "-b \\, \\dot{\\varphi}_{\\mathrm{seat}}^{2} \\, \\sin{\\varphi_{\\mathrm{seat}}} - d \\, \\dot{\\varphi}_{\\mathrm{bar}}^{2} \\, \\sin{\\varphi_{\\mathrm{bar}}}",
                        mathml: "<mrow><mo>−</mo><mi>b</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>−</mo><mi>d</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                    },
                },
                ::ezy_core::model::RowInfo {
                    name: "rear",
                    kind: "skate",
                    multiplier_unit: "N",
                    constraint: ::ezy_core::model::Formula {
                        text: "-a*seat.omega - seat.vx*sin(seat.phi) + seat.vy*cos(seat.phi)",
                        latex: "-a \\, \\dot{\\varphi}_{\\mathrm{seat}} - \\dot{x}_{\\mathrm{seat}} \\, \\sin{\\varphi_{\\mathrm{seat}}} + \\dot{y}_{\\mathrm{seat}} \\, \\cos{\\varphi_{\\mathrm{seat}}}",
                        mathml: "<mrow><mo>−</mo><mi>a</mi><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mo>−</mo><msub><mover><mi>x</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>+</mo><msub><mover><mi>y</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                    },
                    convective_term: ::ezy_core::model::Formula {
                        text: "-seat.vx*seat.omega*cos(seat.phi) - seat.vy*seat.omega*sin(seat.phi)",
                        latex: "-\\dot{x}_{\\mathrm{seat}} \\, \\dot{\\varphi}_{\\mathrm{seat}} \\, \\cos{\\varphi_{\\mathrm{seat}}} - \\dot{y}_{\\mathrm{seat}} \\, \\dot{\\varphi}_{\\mathrm{seat}} \\, \\sin{\\varphi_{\\mathrm{seat}}}",
                        mathml: "<mrow><mo>−</mo><msub><mover><mi>x</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>−</mo><msub><mover><mi>y</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                    },
                },
                ::ezy_core::model::RowInfo {
                    name: "front",
                    kind: "skate",
                    multiplier_unit: "N",
                    constraint: ::ezy_core::model::Formula {
                        text: "c*bar.omega - bar.vx*sin(bar.phi) + bar.vy*cos(bar.phi)",
                        latex: "c \\, \\dot{\\varphi}_{\\mathrm{bar}} - \\dot{x}_{\\mathrm{bar}} \\, \\sin{\\varphi_{\\mathrm{bar}}} + \\dot{y}_{\\mathrm{bar}} \\, \\cos{\\varphi_{\\mathrm{bar}}}",
                        mathml: "<mrow><mi>c</mi><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mo>−</mo><msub><mover><mi>x</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow><mo>+</mo><msub><mover><mi>y</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                    },
                    convective_term: ::ezy_core::model::Formula {
                        text: "-bar.vx*bar.omega*cos(bar.phi) - bar.vy*bar.omega*sin(bar.phi)",
                        latex: "-\\dot{x}_{\\mathrm{bar}} \\, \\dot{\\varphi}_{\\mathrm{bar}} \\, \\cos{\\varphi_{\\mathrm{bar}}} - \\dot{y}_{\\mathrm{bar}} \\, \\dot{\\varphi}_{\\mathrm{bar}} \\, \\sin{\\varphi_{\\mathrm{bar}}}",
                        mathml: "<mrow><mo>−</mo><msub><mover><mi>x</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow><mo>−</mo><msub><mover><mi>y</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                    },
                },
            ],
            n_position_rows: 2usize,
            parameters: &[
                ::ezy_core::model::ParameterInfo {
                    name: "a",
                    unit: "m",
                    default: 0.2f64,
                    default_text: "0.2",
                    documentation: "rear wheel A, behind the seat's centre of mass",
                    effect: ::core::option::Option::None,
                    symbol: ::ezy_core::model::Formula {
                        text: "a",
                        latex: "a",
                        mathml: "<mi>a</mi>",
                    },
                },
                ::ezy_core::model::ParameterInfo {
                    name: "b",
                    unit: "m",
                    default: 0.6f64,
                    default_text: "0.6",
                    documentation: "hinge B, ahead of the seat's centre of mass",
                    effect: ::core::option::Option::None,
                    symbol: ::ezy_core::model::Formula {
                        text: "b",
                        latex: "b",
                        mathml: "<mi>b</mi>",
                    },
                },
                ::ezy_core::model::ParameterInfo {
                    name: "c",
                    unit: "m",
                    default: 0.1f64,
                    default_text: "0.1",
                    documentation: "front wheel C, beyond the bar's centre of mass",
                    effect: ::core::option::Option::None,
                    symbol: ::ezy_core::model::Formula {
                        text: "c",
                        latex: "c",
                        mathml: "<mi>c</mi>",
                    },
                },
                ::ezy_core::model::ParameterInfo {
                    name: "d",
                    unit: "m",
                    default: 0.1f64,
                    default_text: "0.1",
                    documentation: "bar's centre of mass, beyond the hinge",
                    effect: ::core::option::Option::None,
                    symbol: ::ezy_core::model::Formula {
                        text: "d",
                        latex: "d",
                        mathml: "<mi>d</mi>",
                    },
                },
                ::ezy_core::model::ParameterInfo {
                    name: "m1",
                    unit: "kg",
                    default: 46f64,
                    default_text: "46.0",
                    documentation: "mass of seat and rider",
                    effect: ::core::option::Option::None,
                    symbol: ::ezy_core::model::Formula {
                        text: "m1",
                        latex: "m_{1}",
                        mathml: "<msub><mi>m</mi><mtext>1</mtext></msub>",
                    },
                },
                ::ezy_core::model::ParameterInfo {
                    name: "i1",
                    unit: "kg*m^2",
                    default: 10f64,
                    default_text: "10.0",
                    documentation: "moment of inertia of seat and rider",
                    effect: ::core::option::Option::None,
                    symbol: ::ezy_core::model::Formula {
                        text: "i1",
                        latex: "i_{1}",
                        mathml: "<msub><mi>i</mi><mtext>1</mtext></msub>",
                    },
                },
                ::ezy_core::model::ParameterInfo {
                    name: "m2",
                    unit: "kg",
                    default: 1f64,
                    default_text: "1.0",
                    documentation: "mass of the bar",
                    effect: ::core::option::Option::None,
                    symbol: ::ezy_core::model::Formula {
                        text: "m2",
                        latex: "m_{2}",
                        mathml: "<msub><mi>m</mi><mtext>2</mtext></msub>",
                    },
                },
                ::ezy_core::model::ParameterInfo {
                    name: "i2",
                    unit: "kg*m^2",
                    default: 0.005f64,
                    default_text: "0.005",
                    documentation: "moment of inertia of the bar",
                    effect: ::core::option::Option::None,
                    symbol: ::ezy_core::model::Formula {
                        text: "i2",
                        latex: "i_{2}",
                        mathml: "<msub><mi>i</mi><mtext>2</mtext></msub>",
                    },
                },
                ::ezy_core::model::ParameterInfo {
                    name: "m0",
                    unit: "N*m",
                    default: 2f64,
                    default_text: "2.0",
                    documentation: "largest torque",
                    effect: ::core::option::Option::Some("pump"),
                    symbol: ::ezy_core::model::Formula {
                        text: "m0",
                        latex: "m_{0}",
                        mathml: "<msub><mi>m</mi><mtext>0</mtext></msub>",
                    },
                },
                ::ezy_core::model::ParameterInfo {
                    name: "omega",
                    unit: "rad/s",
                    default: 3.141592653589793f64,
                    default_text: "pi",
                    documentation: "angular frequency of the torque",
                    effect: ::core::option::Option::Some("pump"),
                    symbol: ::ezy_core::model::Formula {
                        text: "omega",
                        latex: "\\omega",
                        mathml: "<mi>ω</mi>",
                    },
                },
            ],
            inputs: &[],
            outputs: &[],
            effects: &[
                ::ezy_core::model::EffectInfo {
                    name: "pump",
                    documentation: "The rider swings the bar: a torque between seat and bar.",
                },
            ],
            until_s: 60f64,
            n_constants: 38usize,
            jacobian: ::ezy_core::model::SparsityPattern {
                starts: &[0usize, 4usize, 8usize, 11usize, 14usize],
                columns: &[
                    0usize, 2usize, 3usize, 5usize, 1usize, 2usize, 4usize, 5usize,
                    0usize, 1usize, 2usize, 3usize, 4usize, 5usize,
                ],
            },
            jacobian_entries: &[
                ::ezy_core::model::Formula {
                    text: "1",
                    latex: "1",
                    mathml: "<mrow><mn>1</mn></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "-b*sin(seat.phi)",
                    latex: "-b \\, \\sin{\\varphi_{\\mathrm{seat}}}",
                    mathml: "<mrow><mo>−</mo><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "-1",
                    latex: "-1",
                    mathml: "<mrow><mo>−</mo><mn>1</mn></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "-d*sin(bar.phi)",
                    latex: "-d \\, \\sin{\\varphi_{\\mathrm{bar}}}",
                    mathml: "<mrow><mo>−</mo><mi>d</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "1",
                    latex: "1",
                    mathml: "<mrow><mn>1</mn></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "b*cos(seat.phi)",
                    latex: "b \\, \\cos{\\varphi_{\\mathrm{seat}}}",
                    mathml: "<mrow><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "-1",
                    latex: "-1",
                    mathml: "<mrow><mo>−</mo><mn>1</mn></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "d*cos(bar.phi)",
                    latex: "d \\, \\cos{\\varphi_{\\mathrm{bar}}}",
                    mathml: "<mrow><mi>d</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "-sin(seat.phi)",
                    latex: "-\\sin{\\varphi_{\\mathrm{seat}}}",
                    mathml: "<mrow><mo>−</mo><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "cos(seat.phi)",
                    latex: "\\cos{\\varphi_{\\mathrm{seat}}}",
                    mathml: "<mrow><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "-a",
                    latex: "-a",
                    mathml: "<mrow><mo>−</mo><mi>a</mi></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "-sin(bar.phi)",
                    latex: "-\\sin{\\varphi_{\\mathrm{bar}}}",
                    mathml: "<mrow><mo>−</mo><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "cos(bar.phi)",
                    latex: "\\cos{\\varphi_{\\mathrm{bar}}}",
                    mathml: "<mrow><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "c",
                    latex: "c",
                    mathml: "<mrow><mi>c</mi></mrow>",
                },
            ],
            mass_entries: &[
                ::ezy_core::model::Formula {
                    text: "m1",
                    latex: "m_{1}",
                    mathml: "<mrow><msub><mi>m</mi><mtext>1</mtext></msub></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "m1",
                    latex: "m_{1}",
                    mathml: "<mrow><msub><mi>m</mi><mtext>1</mtext></msub></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "i1",
                    latex: "i_{1}",
                    mathml: "<mrow><msub><mi>i</mi><mtext>1</mtext></msub></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "m2",
                    latex: "m_{2}",
                    mathml: "<mrow><msub><mi>m</mi><mtext>2</mtext></msub></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "m2",
                    latex: "m_{2}",
                    mathml: "<mrow><msub><mi>m</mi><mtext>2</mtext></msub></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "i2",
                    latex: "i_{2}",
                    mathml: "<mrow><msub><mi>i</mi><mtext>2</mtext></msub></mrow>",
                },
            ],
            force_entries: &[
                ::ezy_core::model::Formula {
                    text: "0",
                    latex: "0",
                    mathml: "<mrow><mn>0</mn></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "0",
                    latex: "0",
                    mathml: "<mrow><mn>0</mn></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "m0*cos(omega*t)",
                    latex: "m_{0} \\, \\cos\\left(\\omega \\, t\\right)",
                    mathml: "<mrow><msub><mi>m</mi><mtext>0</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mrow><mo>(</mo><mi>ω</mi><mspace width=\"0.17em\"/><mi>t</mi><mo>)</mo></mrow></mrow></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "0",
                    latex: "0",
                    mathml: "<mrow><mn>0</mn></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "0",
                    latex: "0",
                    mathml: "<mrow><mn>0</mn></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "-m0*cos(omega*t)",
                    latex: "-m_{0} \\, \\cos\\left(\\omega \\, t\\right)",
                    mathml: "<mrow><mo>−</mo><msub><mi>m</mi><mtext>0</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mrow><mo>(</mo><mi>ω</mi><mspace width=\"0.17em\"/><mi>t</mi><mo>)</mo></mrow></mrow></mrow>",
                },
            ],
            potential_energy: ::ezy_core::model::Formula {
                text: "0",
                latex: "0",
                mathml: "<mrow><mn>0</mn></mrow>",
            },
            abbreviations: &[],
            elimination: &[
                ::ezy_core::model::EliminationStep {
                    rows: &[2usize],
                    constant_pivot: true,
                },
                ::ezy_core::model::EliminationStep {
                    rows: &[3usize],
                    constant_pivot: true,
                },
                ::ezy_core::model::EliminationStep {
                    rows: &[0usize, 1usize],
                    constant_pivot: false,
                },
            ],
            acceleration_operations: ::ezy_core::model::Operations {
                add: 35usize,
                mul: 63usize,
                div: 1usize,
                trig: 3usize,
                calls: 0usize,
            },
            correction_operations: ::ezy_core::model::Operations {
                add: 23usize,
                mul: 42usize,
                div: 1usize,
                trig: 2usize,
                calls: 0usize,
            },
            series: ::ezy_core::model::SeriesInfo::Analytic {
                n_products: 16usize,
                operations: ::ezy_core::model::Operations {
                    add: 54usize,
                    mul: 90usize,
                    div: 0usize,
                    trig: 0usize,
                    calls: 0usize,
                },
            },
            repeats: ::core::option::Option::None,
        };
    }
    #[automatically_derived]
    impl<T: ::ezy_core::scalar::Scalar> ::ezy_core::model::Equations<T>
    for self::Driven {
        fn constants(&self, parameters: &[T], c: &mut [T]) {
            let parameters = ::ezy_core::kernel::array::<10usize, T>(parameters);
            let c = ::ezy_core::kernel::array_mut::<38usize, T>(c);
            let k1 = T::from_f64(1f64);
            let parameter_m1 = parameters[4usize];
            let parameter_i1 = parameters[5usize];
            let parameter_m2 = parameters[6usize];
            let parameter_i2 = parameters[7usize];
            let parameter_b = parameters[1usize];
            let parameter_d = parameters[3usize];
            let parameter_a = parameters[0usize];
            let parameter_c = parameters[2usize];
            let parameter_m0 = parameters[8usize];
            let parameter_omega = parameters[9usize];
            let k13 = T::PI;
            let k14 = k1 / parameter_m1;
            let k15 = k1 / parameter_i1;
            let k16 = parameter_b * parameter_m0;
            let k17 = k16 * k15;
            let k18 = k1 / parameter_m2;
            let k19 = k1 / parameter_i2;
            let k20 = parameter_d * parameter_m0;
            let k21 = k20 * k19;
            let k22 = parameter_a * parameter_m0;
            let k23 = k22 * k15;
            let k24 = parameter_c * parameter_m0;
            let k25 = k24 * k19;
            let k26 = parameter_b * parameter_b;
            let k27 = k26 * k15;
            let k28 = parameter_d * parameter_d;
            let k29 = k28 * k19;
            let k30 = k14 + k27;
            let k31 = k30 + k18;
            let k32 = k31 + k29;
            let k33 = parameter_b * parameter_a;
            let k34 = k33 * k15;
            let k35 = k34 - k14;
            let k36 = parameter_d * parameter_c;
            let k37 = k36 * k19;
            let k38 = k18 - k37;
            let k39 = k14 + k18;
            let k40 = parameter_a * parameter_a;
            let k41 = k40 * k15;
            let k42 = k14 + k41;
            let k43 = parameter_c * parameter_c;
            let k44 = k43 * k19;
            let k45 = k18 + k44;
            let k46 = k1 / k42;
            let k47 = k35 * k46;
            let k48 = k47 * k35;
            let k49 = k32 - k48;
            let k50 = k48 - k27;
            let k51 = k1 / k45;
            let k52 = k38 * k51;
            let k53 = k52 * k38;
            let k54 = k49 - k53;
            let k55 = k53 - k29;
            let k56 = parameter_m0 * k15;
            let k57 = parameter_b * k15;
            let k58 = parameter_a * k15;
            let k59 = parameter_m0 * k19;
            let k60 = parameter_d * k19;
            let k61 = parameter_c * k19;
            let k62 = T::from_f64(0.0000000001f64);
            let k63 = k62 * k42;
            let k64 = k62 * k45;
            let k65 = k32 + k39;
            let k66 = k65 * k65;
            let k67 = k62 * k66;
            c[0usize] = k23;
            c[1usize] = parameter_omega;
            c[2usize] = k25;
            c[3usize] = k50;
            c[4usize] = k55;
            c[5usize] = k54;
            c[6usize] = k39;
            c[7usize] = k17;
            c[8usize] = k47;
            c[9usize] = k21;
            c[10usize] = k52;
            c[11usize] = parameter_b;
            c[12usize] = parameter_d;
            c[13usize] = k51;
            c[14usize] = k46;
            c[15usize] = k14;
            c[16usize] = k57;
            c[17usize] = k56;
            c[18usize] = k58;
            c[19usize] = k18;
            c[20usize] = k60;
            c[21usize] = k59;
            c[22usize] = k61;
            c[23usize] = k42;
            c[24usize] = k63;
            c[25usize] = k45;
            c[26usize] = k64;
            c[27usize] = k67;
            c[28usize] = parameter_m0;
            c[29usize] = k15;
            c[30usize] = k19;
            c[31usize] = parameter_m1;
            c[32usize] = parameter_i1;
            c[33usize] = parameter_m2;
            c[34usize] = parameter_i2;
            c[35usize] = parameter_a;
            c[36usize] = parameter_c;
            c[37usize] = k13;
        }
        fn mass_matrix(&self, c: &[T], m: &mut [T]) {
            let c = ::ezy_core::kernel::array::<38usize, T>(c);
            let out = ::ezy_core::kernel::array_mut::<6usize, T>(m);
            out[0usize] = c[31usize];
            out[1usize] = c[31usize];
            out[2usize] = c[32usize];
            out[3usize] = c[33usize];
            out[4usize] = c[33usize];
            out[5usize] = c[34usize];
        }
        fn position_constraint(&self, c: &[T], t: T, q: &[T], out: &mut [T]) {
            let c = ::ezy_core::kernel::array::<38usize, T>(c);
            let q = ::ezy_core::kernel::array::<6usize, T>(q);
            let out = ::ezy_core::kernel::array_mut::<2usize, T>(out);
            let seat_x = q[0usize];
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let sum_7 = T::fused(c[11usize], cos_seat_phi, seat_x);
            let bar_x = q[3usize];
            let difference_9 = sum_7 - bar_x;
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
            let sum_14 = T::fused(c[12usize], cos_bar_phi, difference_9);
            let seat_y = q[1usize];
            let sum_18 = T::fused(c[11usize], sin_seat_phi, seat_y);
            let bar_y = q[4usize];
            let difference_20 = sum_18 - bar_y;
            let sum_23 = T::fused(c[12usize], sin_bar_phi, difference_20);
            out[0usize] = sum_14;
            out[1usize] = sum_23;
        }
        fn velocity_constraint(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
            let c = ::ezy_core::kernel::array::<38usize, T>(c);
            let q = ::ezy_core::kernel::array::<6usize, T>(q);
            let v = ::ezy_core::kernel::array::<6usize, T>(v);
            let out = ::ezy_core::kernel::array_mut::<4usize, T>(out);
            let seat_vx = v[0usize];
            let seat_omega = v[2usize];
            let product_5 = c[11usize] * seat_omega;
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let difference_9 = T::fused(-product_5, sin_seat_phi, seat_vx);
            let bar_vx = v[3usize];
            let difference_11 = difference_9 - bar_vx;
            let bar_omega = v[5usize];
            let product_14 = c[12usize] * bar_omega;
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
            let difference_18 = T::fused(-product_14, sin_bar_phi, difference_11);
            let seat_vy = v[1usize];
            let bar_vy = v[4usize];
            let difference_21 = seat_vy - bar_vy;
            let sum_24 = T::fused(product_5, cos_seat_phi, difference_21);
            let sum_27 = T::fused(product_14, cos_bar_phi, sum_24);
            let product_29 = seat_omega * c[35usize];
            let sum_31 = T::fused(seat_vx, sin_seat_phi, product_29);
            let difference_33 = T::fused(seat_vy, cos_seat_phi, -sum_31);
            let product_35 = bar_omega * c[36usize];
            let difference_37 = T::fused(-bar_vx, sin_bar_phi, product_35);
            let sum_39 = T::fused(bar_vy, cos_bar_phi, difference_37);
            out[0usize] = difference_18;
            out[1usize] = sum_27;
            out[2usize] = difference_33;
            out[3usize] = sum_39;
        }
        fn velocity_jacobian(&self, c: &[T], t: T, q: &[T], out: &mut [T]) {
            let c = ::ezy_core::kernel::array::<38usize, T>(c);
            let q = ::ezy_core::kernel::array::<6usize, T>(q);
            let out = ::ezy_core::kernel::array_mut::<14usize, T>(out);
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let product_4 = c[11usize] * sin_seat_phi;
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
            let product_8 = c[12usize] * sin_bar_phi;
            let product_10 = c[11usize] * cos_seat_phi;
            let product_12 = c[12usize] * cos_bar_phi;
            let value_15 = -product_4;
            let value_16 = -T::from_f64(1f64);
            let value_17 = -product_8;
            let value_18 = -sin_seat_phi;
            let value_19 = -c[35usize];
            let value_20 = -sin_bar_phi;
            out[0usize] = T::from_f64(1f64);
            out[1usize] = value_15;
            out[2usize] = value_16;
            out[3usize] = value_17;
            out[4usize] = T::from_f64(1f64);
            out[5usize] = product_10;
            out[6usize] = value_16;
            out[7usize] = product_12;
            out[8usize] = value_18;
            out[9usize] = cos_seat_phi;
            out[10usize] = value_19;
            out[11usize] = value_20;
            out[12usize] = cos_bar_phi;
            out[13usize] = c[36usize];
        }
        fn convective_term(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
            let c = ::ezy_core::kernel::array::<38usize, T>(c);
            let q = ::ezy_core::kernel::array::<6usize, T>(q);
            let v = ::ezy_core::kernel::array::<6usize, T>(v);
            let out = ::ezy_core::kernel::array_mut::<4usize, T>(out);
            let seat_omega = v[2usize];
            let product_3 = c[11usize] * seat_omega;
            let product_4 = seat_omega * product_3;
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let product_8 = product_4 * cos_seat_phi;
            let bar_omega = v[5usize];
            let product_11 = c[12usize] * bar_omega;
            let product_12 = bar_omega * product_11;
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
            let sum_16 = T::fused(product_12, cos_bar_phi, product_8);
            let product_18 = product_4 * sin_seat_phi;
            let sum_21 = T::fused(product_12, sin_bar_phi, product_18);
            let seat_vx = v[0usize];
            let product_23 = cos_seat_phi * seat_vx;
            let seat_vy = v[1usize];
            let sum_26 = T::fused(sin_seat_phi, seat_vy, product_23);
            let product_27 = seat_omega * sum_26;
            let bar_vx = v[3usize];
            let product_29 = cos_bar_phi * bar_vx;
            let bar_vy = v[4usize];
            let sum_32 = T::fused(sin_bar_phi, bar_vy, product_29);
            let product_33 = bar_omega * sum_32;
            let value_34 = -sum_16;
            let value_35 = -sum_21;
            let value_36 = -product_27;
            let value_37 = -product_33;
            out[0usize] = value_34;
            out[1usize] = value_35;
            out[2usize] = value_36;
            out[3usize] = value_37;
        }
        fn applied_force(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
            let c = ::ezy_core::kernel::array::<38usize, T>(c);
            let q = ::ezy_core::kernel::array::<6usize, T>(q);
            let v = ::ezy_core::kernel::array::<6usize, T>(v);
            let out = ::ezy_core::kernel::array_mut::<6usize, T>(out);
            let product_4 = c[1usize] * t;
            let cos_4 = T::cos(product_4);
            let product_6 = c[28usize] * cos_4;
            let value_7 = -product_6;
            out[0usize] = T::from_f64(0f64);
            out[1usize] = T::from_f64(0f64);
            out[2usize] = product_6;
            out[3usize] = T::from_f64(0f64);
            out[4usize] = T::from_f64(0f64);
            out[5usize] = value_7;
        }
        #[inline]
        fn accelerations(
            &self,
            c: &[T],
            t: T,
            q: &[T],
            v: &[T],
            a: &mut [T],
            lambda: &mut [T],
        ) -> ::ezy_core::model::DeficientRows {
            let c = ::ezy_core::kernel::array::<38usize, T>(c);
            let q = ::ezy_core::kernel::array::<6usize, T>(q);
            let v = ::ezy_core::kernel::array::<6usize, T>(v);
            let a = ::ezy_core::kernel::array_mut::<6usize, T>(a);
            let lambda = ::ezy_core::kernel::array_mut::<4usize, T>(lambda);
            let seat_vx = v[0usize];
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let product_5 = seat_vx * cos_seat_phi;
            let seat_vy = v[1usize];
            let sum_9 = T::fused(seat_vy, sin_seat_phi, product_5);
            let seat_omega = v[2usize];
            let product_11 = sum_9 * seat_omega;
            let product_15 = c[1usize] * t;
            let cos_15 = T::cos(product_15);
            let minus_right_side_rear = T::fused(c[0usize], cos_15, product_11);
            let bar_vx = v[3usize];
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
            let product_22 = bar_vx * cos_bar_phi;
            let bar_vy = v[4usize];
            let sum_26 = T::fused(bar_vy, sin_bar_phi, product_22);
            let bar_omega = v[5usize];
            let product_28 = sum_26 * bar_omega;
            let minus_right_side_front = T::fused(cos_15, c[2usize], product_28);
            let product_33 = cos_seat_phi * c[3usize];
            let product_34 = cos_seat_phi * product_33;
            let product_36 = cos_bar_phi * c[4usize];
            let sum_38 = T::fused(cos_bar_phi, product_36, product_34);
            let sum_40 = sum_38 + c[5usize];
            let product_41 = sin_seat_phi * c[3usize];
            let product_42 = cos_seat_phi * product_41;
            let product_43 = sin_bar_phi * c[4usize];
            let sum_45 = T::fused(cos_bar_phi, product_43, product_42);
            let difference_47 = c[6usize] - sum_38;
            let product_51 = minus_right_side_rear * c[8usize];
            let difference_52 = T::fused(-cos_15, c[7usize], product_51);
            let product_53 = sin_seat_phi * difference_52;
            let product_55 = cos_15 * c[9usize];
            let sum_58 = T::fused(minus_right_side_front, c[10usize], product_55);
            let sum_60 = T::fused(sin_bar_phi, sum_58, product_53);
            let product_62 = seat_omega * c[11usize];
            let product_63 = seat_omega * product_62;
            let difference_65 = T::fused(-cos_seat_phi, product_63, sum_60);
            let product_67 = bar_omega * c[12usize];
            let product_68 = bar_omega * product_67;
            let difference_70 = T::fused(-cos_bar_phi, product_68, difference_65);
            let product_71 = cos_seat_phi * difference_52;
            let sum_73 = T::fused(cos_bar_phi, sum_58, product_71);
            let sum_75 = T::fused(sin_seat_phi, product_63, sum_73);
            let sum_77 = T::fused(sin_bar_phi, product_68, sum_75);
            let product_78 = sum_40 * difference_47;
            let difference_80 = T::fused(-sum_45, sum_45, product_78);
            let quotient_81 = T::from_f64(1f64) / difference_80;
            let product_82 = difference_47 * difference_70;
            let sum_84 = T::fused(sum_45, sum_77, product_82);
            let lambda_B_x = quotient_81 * sum_84;
            let product_86 = sum_45 * difference_70;
            let sum_88 = T::fused(sum_40, sum_77, product_86);
            let minus_lambda_B_y = quotient_81 * sum_88;
            let product_90 = sin_bar_phi * lambda_B_x;
            let sum_92 = T::fused(cos_bar_phi, minus_lambda_B_y, product_90);
            let product_93 = c[10usize] * sum_92;
            let minus_lambda_front = T::fused(
                minus_right_side_front,
                c[13usize],
                product_93,
            );
            let product_97 = sin_seat_phi * lambda_B_x;
            let sum_99 = T::fused(cos_seat_phi, minus_lambda_B_y, product_97);
            let product_100 = c[8usize] * sum_99;
            let minus_lambda_rear = T::fused(
                minus_right_side_rear,
                c[14usize],
                product_100,
            );
            let sum_105 = T::fused(sin_seat_phi, minus_lambda_rear, lambda_B_x);
            let product_107 = sum_105 * c[15usize];
            let sum_109 = T::fused(cos_seat_phi, minus_lambda_rear, minus_lambda_B_y);
            let product_110 = c[15usize] * sum_109;
            let product_112 = sum_99 * c[16usize];
            let sum_115 = T::fused(cos_15, c[17usize], product_112);
            let difference_118 = T::fused(-minus_lambda_rear, c[18usize], sum_115);
            let difference_120 = T::fused(-sin_bar_phi, minus_lambda_front, lambda_B_x);
            let product_122 = difference_120 * c[19usize];
            let difference_124 = T::fused(
                cos_bar_phi,
                minus_lambda_front,
                -minus_lambda_B_y,
            );
            let product_125 = c[19usize] * difference_124;
            let product_127 = sum_92 * c[20usize];
            let difference_130 = T::fused(-cos_15, c[21usize], product_127);
            let sum_133 = T::fused(minus_lambda_front, c[22usize], difference_130);
            let value_139 = -product_107;
            let value_140 = -minus_lambda_B_y;
            let value_141 = -minus_lambda_rear;
            let value_142 = -minus_lambda_front;
            a[0usize] = value_139;
            a[1usize] = product_110;
            a[2usize] = difference_118;
            a[3usize] = product_122;
            a[4usize] = product_125;
            a[5usize] = sum_133;
            lambda[0usize] = lambda_B_x;
            lambda[1usize] = value_140;
            lambda[2usize] = value_141;
            lambda[3usize] = value_142;
            ::ezy_core::model::DeficientRows(0)
                .mark(2usize, !T::is_above(c[23usize], c[24usize]))
                .mark(3usize, !T::is_above(c[25usize], c[26usize]))
                .mark(0usize, !T::is_above(difference_80, c[27usize]))
                .mark(1usize, !T::is_above(difference_80, c[27usize]))
        }
        #[inline]
        fn correction(
            &self,
            c: &[T],
            t: T,
            q: &[T],
            residual: &[T],
            delta: &mut [T],
        ) -> ::ezy_core::model::DeficientRows {
            let c = ::ezy_core::kernel::array::<38usize, T>(c);
            let q = ::ezy_core::kernel::array::<6usize, T>(q);
            let residual = ::ezy_core::kernel::array::<4usize, T>(residual);
            let delta = ::ezy_core::kernel::array_mut::<6usize, T>(delta);
            let right_side_rear = residual[2usize];
            let right_side_front = residual[3usize];
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let product_7 = c[3usize] * cos_seat_phi;
            let product_8 = cos_seat_phi * product_7;
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
            let product_12 = c[4usize] * cos_bar_phi;
            let sum_14 = T::fused(cos_bar_phi, product_12, product_8);
            let sum_16 = sum_14 + c[5usize];
            let product_18 = c[3usize] * sin_seat_phi;
            let product_19 = cos_seat_phi * product_18;
            let product_21 = c[4usize] * sin_bar_phi;
            let sum_23 = T::fused(cos_bar_phi, product_21, product_19);
            let difference_25 = c[6usize] - sum_14;
            let residual_0 = residual[0usize];
            let product_28 = right_side_rear * c[8usize];
            let difference_30 = T::fused(-sin_seat_phi, product_28, residual_0);
            let product_32 = right_side_front * c[10usize];
            let difference_34 = T::fused(-sin_bar_phi, product_32, difference_30);
            let residual_1 = residual[1usize];
            let sum_37 = T::fused(cos_seat_phi, product_28, residual_1);
            let sum_39 = T::fused(cos_bar_phi, product_32, sum_37);
            let product_40 = sum_16 * difference_25;
            let difference_42 = T::fused(-sum_23, sum_23, product_40);
            let quotient_43 = T::from_f64(1f64) / difference_42;
            let product_44 = difference_25 * difference_34;
            let difference_46 = T::fused(-sum_23, sum_39, product_44);
            let lambda_B_x = quotient_43 * difference_46;
            let product_49 = sum_16 * sum_39;
            let difference_50 = T::fused(-sum_23, difference_34, product_49);
            let lambda_B_y = quotient_43 * difference_50;
            let product_53 = cos_bar_phi * lambda_B_y;
            let difference_54 = T::fused(-sin_bar_phi, lambda_B_x, product_53);
            let product_55 = c[10usize] * difference_54;
            let lambda_front = T::fused(right_side_front, c[13usize], product_55);
            let product_60 = cos_seat_phi * lambda_B_y;
            let difference_61 = T::fused(-sin_seat_phi, lambda_B_x, product_60);
            let product_62 = c[8usize] * difference_61;
            let lambda_rear = T::fused(right_side_rear, c[14usize], product_62);
            let difference_67 = T::fused(sin_seat_phi, lambda_rear, -lambda_B_x);
            let product_69 = difference_67 * c[15usize];
            let sum_71 = T::fused(cos_seat_phi, lambda_rear, lambda_B_y);
            let product_72 = c[15usize] * sum_71;
            let product_76 = lambda_rear * c[18usize];
            let difference_77 = T::fused(-difference_61, c[16usize], product_76);
            let sum_79 = T::fused(sin_bar_phi, lambda_front, lambda_B_x);
            let product_81 = sum_79 * c[19usize];
            let difference_83 = T::fused(-cos_bar_phi, lambda_front, lambda_B_y);
            let product_84 = c[19usize] * difference_83;
            let product_86 = difference_54 * c[20usize];
            let sum_89 = T::fused(lambda_front, c[22usize], product_86);
            let value_95 = -product_72;
            let value_96 = -sum_89;
            delta[0usize] = product_69;
            delta[1usize] = value_95;
            delta[2usize] = difference_77;
            delta[3usize] = product_81;
            delta[4usize] = product_84;
            delta[5usize] = value_96;
            ::ezy_core::model::DeficientRows(0)
                .mark(2usize, !T::is_above(c[23usize], c[24usize]))
                .mark(3usize, !T::is_above(c[25usize], c[26usize]))
                .mark(0usize, !T::is_above(difference_42, c[27usize]))
                .mark(1usize, !T::is_above(difference_42, c[27usize]))
        }
    }
    #[automatically_derived]
    impl ::ezy_core::model::Scene for Driven {
        fn info(&self) -> &'static ::ezy_core::model::SceneInfo {
            static INFO: ::ezy_core::model::SceneInfo = Driven::INFO;
            &INFO
        }
        fn parameter(&self, index: usize) -> f64 {
            match index {
                0usize => self.a,
                1usize => self.b,
                2usize => self.c,
                3usize => self.d,
                4usize => self.m1,
                5usize => self.i1,
                6usize => self.m2,
                7usize => self.i2,
                8usize => self.m0,
                9usize => self.omega,
                _ => f64::NAN,
            }
        }
        fn set_parameter(&mut self, index: usize, value: f64) {
            match index {
                0usize => self.a = value,
                1usize => self.b = value,
                2usize => self.c = value,
                3usize => self.d = value,
                4usize => self.m1 = value,
                5usize => self.i1 = value,
                6usize => self.m2 = value,
                7usize => self.i2 = value,
                8usize => self.m0 = value,
                9usize => self.omega = value,
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
            let c = ::ezy_core::kernel::array::<38usize, f64>(c);
            let q = ::ezy_core::kernel::array::<6usize, f64>(q);
            let v = ::ezy_core::kernel::array::<6usize, f64>(v);
            let lambda = ::ezy_core::kernel::array::<4usize, f64>(lambda);
            let out = ::ezy_core::kernel::array_mut::<1usize, f64>(out);
            let seat_omega = v[2usize];
            let bar_omega = v[5usize];
            let difference_4 = seat_omega - bar_omega;
            let product_7 = c[1usize] * t;
            let cos_7 = f64::cos(product_7);
            let product_9 = difference_4 * cos_7;
            let product_11 = product_9 * c[28usize];
            out[0usize] = product_11;
        }
        fn points(&self, c: &[f64], t: f64, q: &[f64], out: &mut [f64]) {
            let c = ::ezy_core::kernel::array::<38usize, f64>(c);
            let q = ::ezy_core::kernel::array::<6usize, f64>(q);
            let out = ::ezy_core::kernel::array_mut::<6usize, f64>(out);
            let seat_x = q[0usize];
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = f64::sin_cos(seat_phi);
            let product_6 = c[35usize] * cos_seat_phi;
            let difference_7 = seat_x - product_6;
            let seat_y = q[1usize];
            let product_10 = c[35usize] * sin_seat_phi;
            let difference_11 = seat_y - product_10;
            let bar_x = q[3usize];
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = f64::sin_cos(bar_phi);
            let product_16 = c[36usize] * cos_bar_phi;
            let sum_17 = bar_x + product_16;
            let bar_y = q[4usize];
            let product_20 = c[36usize] * sin_bar_phi;
            let sum_21 = bar_y + product_20;
            let product_23 = cos_seat_phi * c[11usize];
            let sum_24 = seat_x + product_23;
            let product_25 = sin_seat_phi * c[11usize];
            let sum_26 = seat_y + product_25;
            out[0usize] = difference_7;
            out[1usize] = difference_11;
            out[2usize] = sum_17;
            out[3usize] = sum_21;
            out[4usize] = sum_24;
            out[5usize] = sum_26;
        }
        fn outputs(&self, c: &[f64], t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
            let c = ::ezy_core::kernel::array::<38usize, f64>(c);
            let q = ::ezy_core::kernel::array::<6usize, f64>(q);
            let v = ::ezy_core::kernel::array::<6usize, f64>(v);
            let out = ::ezy_core::kernel::array_mut::<0usize, f64>(out);
        }
        fn potential_energy(&self, c: &[f64], t: f64, q: &[f64]) -> f64 {
            0f64
        }
        fn start(&self, c: &[f64], start: &mut ::ezy_core::model::Start) {
            let c = ::ezy_core::kernel::array::<38usize, f64>(c);
            start.give_position(0usize, 0f64);
            start.give_position(1usize, 0f64);
            start.give_position(2usize, 0f64);
            start.give_position(5usize, c[37usize]);
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
    impl<T: ::ezy_core::scalar::Scalar> ::ezy_core::model::Series<T> for Driven {
        fn series_size(&self) -> ::ezy_core::model::SeriesSize {
            ::ezy_core::model::SeriesSize {
                n_coordinates: 6usize,
                n_rows: 4usize,
                n_products: 16usize,
                n_base: 8usize,
                n_kept: 3usize,
            }
        }
        fn begin(
            &self,
            c: &[T],
            t: T,
            store: &mut ::ezy_core::model::SeriesStore<T>,
        ) -> ::ezy_core::model::DeficientRows {
            let c = ::ezy_core::kernel::array::<38usize, T>(c);
            let q = ::ezy_core::kernel::row::<6usize, T>(&store.q, 0);
            let v = ::ezy_core::kernel::row::<6usize, T>(&store.q, 1);
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
            let seat_omega = v[2usize];
            let product_25 = c[11usize] * seat_omega;
            let product_26 = seat_omega * product_25;
            let product_27 = cos_seat_phi * product_26;
            let bar_omega = v[5usize];
            let product_29 = c[12usize] * bar_omega;
            let product_30 = bar_omega * product_29;
            let sum_32 = T::fused(cos_bar_phi, product_30, product_27);
            let product_33 = sin_seat_phi * product_26;
            let sum_35 = T::fused(sin_bar_phi, product_30, product_33);
            let seat_vx = v[0usize];
            let product_37 = cos_seat_phi * seat_vx;
            let seat_vy = v[1usize];
            let sum_40 = T::fused(sin_seat_phi, seat_vy, product_37);
            let product_41 = seat_omega * sum_40;
            let bar_vx = v[3usize];
            let product_43 = cos_bar_phi * bar_vx;
            let bar_vy = v[4usize];
            let sum_46 = T::fused(sin_bar_phi, bar_vy, product_43);
            let product_47 = bar_omega * sum_46;
            let product_51 = c[1usize] * t;
            let (sin_51, cos_51) = T::sin_cos(product_51);
            let product_53 = c[28usize] * cos_51;
            let product_81 = cos_seat_phi * c[3usize];
            let product_82 = cos_seat_phi * product_81;
            let product_84 = cos_bar_phi * c[4usize];
            let sum_86 = T::fused(cos_bar_phi, product_84, product_82);
            let sum_88 = sum_86 + c[5usize];
            let product_89 = sin_seat_phi * c[3usize];
            let product_90 = cos_seat_phi * product_89;
            let product_91 = sin_bar_phi * c[4usize];
            let sum_93 = T::fused(cos_bar_phi, product_91, product_90);
            let difference_95 = c[6usize] - sum_86;
            let product_124 = sum_88 * difference_95;
            let difference_126 = T::fused(-sum_93, sum_93, product_124);
            let quotient_127 = T::from_f64(1f64) / difference_126;
            let product_184 = cos_seat_phi * seat_omega;
            let product_185 = sin_seat_phi * seat_omega;
            let product_186 = cos_bar_phi * bar_omega;
            let product_187 = sin_bar_phi * bar_omega;
            let product_188 = c[1usize] * sin_51;
            let product_189 = c[28usize] * product_188;
            let product_190 = c[1usize] * cos_51;
            let value_191 = -product_53;
            let value_192 = -product_185;
            let value_193 = -product_187;
            let value_194 = -product_189;
            let value_195 = -product_188;
            let target = ::ezy_core::kernel::array_mut::<8usize, T>(&mut store.base);
            target[0usize] = cos_seat_phi;
            target[1usize] = sin_seat_phi;
            target[2usize] = cos_bar_phi;
            target[3usize] = sin_bar_phi;
            target[4usize] = quotient_127;
            target[5usize] = difference_95;
            target[6usize] = sum_93;
            target[7usize] = sum_88;
            let target = ::ezy_core::kernel::array_mut::<6usize, T>(&mut store.force);
            target[0usize] = T::from_f64(0f64);
            target[1usize] = T::from_f64(0f64);
            target[2usize] = product_53;
            target[3usize] = T::from_f64(0f64);
            target[4usize] = T::from_f64(0f64);
            target[5usize] = value_191;
            let target = ::ezy_core::kernel::row_mut::<
                3usize,
                T,
            >(&mut store.kept, 0usize);
            target[0usize] = product_53;
            target[1usize] = sin_51;
            target[2usize] = cos_51;
            let target = ::ezy_core::kernel::row_mut::<
                3usize,
                T,
            >(&mut store.kept, 1usize);
            target[0usize] = value_194;
            target[1usize] = product_190;
            target[2usize] = value_195;
            let target = ::ezy_core::kernel::row_mut::<
                16usize,
                T,
            >(&mut store.left, 1usize);
            target[0usize] = product_184;
            target[1usize] = value_192;
            target[2usize] = product_184;
            target[3usize] = value_192;
            target[4usize] = product_186;
            target[5usize] = value_193;
            target[6usize] = product_186;
            target[7usize] = value_193;
            target[8usize] = seat_omega;
            target[9usize] = bar_omega;
            target[10usize] = seat_omega;
            target[11usize] = bar_omega;
            target[12usize] = product_184;
            target[13usize] = value_192;
            target[14usize] = product_186;
            target[15usize] = value_193;
            let target = ::ezy_core::kernel::row_mut::<
                16usize,
                T,
            >(&mut store.right, 1usize);
            target[0usize] = T::from_f64(0f64);
            target[1usize] = T::from_f64(0f64);
            target[2usize] = T::from_f64(0f64);
            target[3usize] = T::from_f64(0f64);
            target[4usize] = T::from_f64(0f64);
            target[5usize] = T::from_f64(0f64);
            target[6usize] = T::from_f64(0f64);
            target[7usize] = T::from_f64(0f64);
            target[8usize] = product_184;
            target[9usize] = product_186;
            target[10usize] = value_192;
            target[11usize] = value_193;
            target[12usize] = seat_vx;
            target[13usize] = seat_vy;
            target[14usize] = bar_vx;
            target[15usize] = bar_vy;
            let target = ::ezy_core::kernel::array_mut::<4usize, T>(&mut store.row);
            target[0usize] = sum_32;
            target[1usize] = sum_35;
            target[2usize] = product_41;
            target[3usize] = product_47;
            ::ezy_core::model::DeficientRows(0)
                .mark(2usize, !T::is_above(c[23usize], c[24usize]))
                .mark(3usize, !T::is_above(c[25usize], c[26usize]))
                .mark(0usize, !T::is_above(difference_126, c[27usize]))
                .mark(1usize, !T::is_above(difference_126, c[27usize]))
        }
        #[inline]
        fn right_side(
            &self,
            c: &[T],
            k: usize,
            store: &mut ::ezy_core::model::SeriesStore<T>,
        ) {
            let c = ::ezy_core::kernel::array::<38usize, T>(c);
            let kept_0 = ::ezy_core::kernel::row::<3usize, T>(&store.kept, k + 0usize);
            let sums = ::ezy_core::kernel::array::<16usize, T>(&store.sums);
            let convolved_0 = sums[0usize];
            let convolved_1 = sums[1usize];
            let kept_0 = kept_0[0usize];
            let convolved_2 = sums[2usize];
            let convolved_3 = sums[3usize];
            let product_9 = c[11usize] * convolved_3;
            let difference_10 = T::fused(-c[11usize], convolved_2, product_9);
            let difference_11 = kept_0 - difference_10;
            let convolved_4 = sums[4usize];
            let convolved_5 = sums[5usize];
            let convolved_6 = sums[6usize];
            let convolved_7 = sums[7usize];
            let product_18 = c[12usize] * convolved_7;
            let difference_19 = T::fused(-c[12usize], convolved_6, product_18);
            let sum_20 = kept_0 + difference_19;
            let convolved_8 = sums[8usize];
            let inverse_order_ahead = T::from_f64(1f64)
                / T::from_f64((k + 2usize) as f64);
            let product_23 = convolved_8 * inverse_order_ahead;
            let product_24 = c[11usize] * product_23;
            let convolved_9 = sums[9usize];
            let product_26 = inverse_order_ahead * convolved_9;
            let sum_28 = T::fused(c[12usize], product_26, product_24);
            let order_next = T::from_f64((k + 1usize) as f64);
            let order_ahead = T::from_f64((k + 2usize) as f64);
            let product_31 = order_next * order_ahead;
            let product_32 = sum_28 * product_31;
            let convolved_10 = sums[10usize];
            let product_34 = inverse_order_ahead * convolved_10;
            let product_35 = c[11usize] * product_34;
            let convolved_11 = sums[11usize];
            let product_37 = inverse_order_ahead * convolved_11;
            let sum_39 = T::fused(c[12usize], product_37, product_35);
            let product_40 = product_31 * sum_39;
            let convolved_12 = sums[12usize];
            let convolved_13 = sums[13usize];
            let difference_43 = convolved_12 - convolved_13;
            let product_44 = order_next * difference_43;
            let convolved_14 = sums[14usize];
            let convolved_15 = sums[15usize];
            let difference_47 = convolved_14 - convolved_15;
            let product_48 = order_next * difference_47;
            let value_49 = -convolved_1;
            let value_50 = -convolved_5;
            let value_51 = -sum_20;
            let value_52 = -product_40;
            let target = ::ezy_core::kernel::array_mut::<6usize, T>(&mut store.force);
            target[0usize] = convolved_0;
            target[1usize] = value_49;
            target[2usize] = difference_11;
            target[3usize] = convolved_4;
            target[4usize] = value_50;
            target[5usize] = value_51;
            let target = ::ezy_core::kernel::array_mut::<4usize, T>(&mut store.row);
            target[0usize] = product_32;
            target[1usize] = value_52;
            target[2usize] = product_44;
            target[3usize] = product_48;
        }
        #[inline]
        fn solve(
            &self,
            c: &[T],
            k: usize,
            store: &mut ::ezy_core::model::SeriesStore<T>,
        ) {
            let c = ::ezy_core::kernel::array::<38usize, T>(c);
            let base = ::ezy_core::kernel::array::<8usize, T>(&store.base);
            let force = ::ezy_core::kernel::array::<6usize, T>(&store.force);
            let row = ::ezy_core::kernel::array::<4usize, T>(&store.row);
            let force_0 = force[0usize];
            let base_4 = base[4usize];
            let base_5 = base[5usize];
            let base_1 = base[1usize];
            let force_2 = force[2usize];
            let product_8 = force_2 * c[16usize];
            let base_0 = base[0usize];
            let force_1 = force[1usize];
            let product_11 = base_0 * force_1;
            let difference_13 = T::fused(-force_0, base_1, product_11);
            let product_14 = c[15usize] * difference_13;
            let difference_17 = T::fused(-force_2, c[18usize], product_14);
            let row_2 = row[2usize];
            let right_side_rear = difference_17 - row_2;
            let sum_22 = T::fused(right_side_rear, c[8usize], product_8);
            let product_23 = base_1 * sum_22;
            let base_3 = base[3usize];
            let force_5 = force[5usize];
            let product_27 = force_5 * c[20usize];
            let base_2 = base[2usize];
            let force_4 = force[4usize];
            let product_30 = base_2 * force_4;
            let force_3 = force[3usize];
            let difference_33 = T::fused(-base_3, force_3, product_30);
            let product_35 = difference_33 * c[19usize];
            let sum_38 = T::fused(force_5, c[22usize], product_35);
            let row_3 = row[3usize];
            let right_side_front = sum_38 - row_3;
            let sum_43 = T::fused(right_side_front, c[10usize], product_27);
            let sum_45 = T::fused(base_3, sum_43, product_23);
            let difference_46 = T::fused(c[15usize], force_0, -sum_45);
            let difference_48 = T::fused(-force_3, c[19usize], difference_46);
            let row_0 = row[0usize];
            let difference_50 = difference_48 - row_0;
            let product_51 = base_5 * difference_50;
            let base_6 = base[6usize];
            let product_53 = base_0 * sum_22;
            let sum_55 = T::fused(base_2, sum_43, product_53);
            let sum_57 = T::fused(c[15usize], force_1, sum_55);
            let difference_59 = T::fused(-force_4, c[19usize], sum_57);
            let row_1 = row[1usize];
            let difference_61 = difference_59 - row_1;
            let difference_63 = T::fused(-base_6, difference_61, product_51);
            let lambda_B_x = base_4 * difference_63;
            let difference_65 = force_0 - lambda_B_x;
            let base_7 = base[7usize];
            let product_67 = difference_61 * base_7;
            let difference_69 = T::fused(-difference_50, base_6, product_67);
            let lambda_B_y = base_4 * difference_69;
            let product_71 = base_0 * lambda_B_y;
            let difference_73 = T::fused(-base_1, lambda_B_x, product_71);
            let product_74 = c[8usize] * difference_73;
            let lambda_rear = T::fused(right_side_rear, c[14usize], product_74);
            let sum_79 = T::fused(base_1, lambda_rear, difference_65);
            let product_80 = c[15usize] * sum_79;
            let difference_81 = force_1 - lambda_B_y;
            let difference_83 = T::fused(-base_0, lambda_rear, difference_81);
            let product_84 = c[15usize] * difference_83;
            let product_86 = force_2 * c[29usize];
            let difference_88 = T::fused(-c[16usize], difference_73, product_86);
            let sum_90 = T::fused(c[18usize], lambda_rear, difference_88);
            let sum_91 = force_3 + lambda_B_x;
            let product_92 = base_2 * lambda_B_y;
            let difference_94 = T::fused(-base_3, lambda_B_x, product_92);
            let product_95 = c[10usize] * difference_94;
            let lambda_front = T::fused(right_side_front, c[13usize], product_95);
            let sum_100 = T::fused(base_3, lambda_front, sum_91);
            let product_101 = c[19usize] * sum_100;
            let sum_102 = force_4 + lambda_B_y;
            let difference_104 = T::fused(-base_2, lambda_front, sum_102);
            let product_105 = c[19usize] * difference_104;
            let product_107 = force_5 * c[30usize];
            let difference_109 = T::fused(-c[20usize], difference_94, product_107);
            let difference_111 = T::fused(-c[22usize], lambda_front, difference_109);
            let target = ::ezy_core::kernel::array_mut::<6usize, T>(&mut store.a);
            target[0usize] = product_80;
            target[1usize] = product_84;
            target[2usize] = sum_90;
            target[3usize] = product_101;
            target[4usize] = product_105;
            target[5usize] = difference_111;
            let target = ::ezy_core::kernel::row_mut::<
                4usize,
                T,
            >(&mut store.lambda, k + 0usize);
            target[0usize] = lambda_B_x;
            target[1usize] = lambda_B_y;
            target[2usize] = lambda_rear;
            target[3usize] = lambda_front;
        }
        #[inline]
        fn finish(
            &self,
            c: &[T],
            k: usize,
            store: &mut ::ezy_core::model::SeriesStore<T>,
        ) {
            let c = ::ezy_core::kernel::array::<38usize, T>(c);
            let a = ::ezy_core::kernel::array::<6usize, T>(&store.a);
            let base = ::ezy_core::kernel::array::<8usize, T>(&store.base);
            let kept_1 = ::ezy_core::kernel::row::<3usize, T>(&store.kept, k + 1usize);
            let lambda_0 = ::ezy_core::kernel::row::<
                4usize,
                T,
            >(&store.lambda, k + 0usize);
            let sums = ::ezy_core::kernel::array::<16usize, T>(&store.sums);
            let a_0 = a[0usize];
            let inverse_order_next = T::from_f64(1f64)
                / T::from_f64((k + 1usize) as f64);
            let inverse_order_ahead = T::from_f64(1f64)
                / T::from_f64((k + 2usize) as f64);
            let product_3 = inverse_order_next * inverse_order_ahead;
            let product_4 = a_0 * product_3;
            let a_1 = a[1usize];
            let product_6 = product_3 * a_1;
            let a_2 = a[2usize];
            let product_8 = product_3 * a_2;
            let a_3 = a[3usize];
            let product_10 = product_3 * a_3;
            let a_4 = a[4usize];
            let product_12 = product_3 * a_4;
            let a_5 = a[5usize];
            let product_14 = product_3 * a_5;
            let lambda_2 = lambda_0[2usize];
            let convolved_10 = sums[10usize];
            let product_19 = inverse_order_ahead * convolved_10;
            let base_0 = base[0usize];
            let sum_22 = T::fused(product_8, base_0, product_19);
            let convolved_8 = sums[8usize];
            let product_24 = inverse_order_ahead * convolved_8;
            let base_1 = base[1usize];
            let sum_27 = T::fused(product_8, base_1, product_24);
            let lambda_0 = lambda_0[0usize];
            let lambda_1 = lambda_0[1usize];
            let lambda_3 = lambda_0[3usize];
            let convolved_11 = sums[11usize];
            let product_32 = inverse_order_ahead * convolved_11;
            let base_2 = base[2usize];
            let sum_35 = T::fused(product_14, base_2, product_32);
            let convolved_9 = sums[9usize];
            let product_37 = inverse_order_ahead * convolved_9;
            let base_3 = base[3usize];
            let sum_40 = T::fused(product_14, base_3, product_37);
            let order_ahead = T::from_f64((k + 2usize) as f64);
            let product_42 = product_8 * order_ahead;
            let product_43 = product_14 * order_ahead;
            let product_44 = product_4 * order_ahead;
            let product_45 = product_6 * order_ahead;
            let product_46 = product_10 * order_ahead;
            let product_47 = product_12 * order_ahead;
            let kept_1_next = kept_1[1usize];
            let product_51 = inverse_order_ahead * c[1usize];
            let product_52 = kept_1_next * product_51;
            let product_53 = c[28usize] * product_52;
            let kept_2_next = kept_1[2usize];
            let product_55 = product_51 * kept_2_next;
            let value_56 = -sum_27;
            let value_57 = -sum_40;
            let value_58 = -product_53;
            let value_59 = -product_52;
            let target = ::ezy_core::kernel::row_mut::<
                3usize,
                T,
            >(&mut store.kept, k + 2usize);
            target[0usize] = value_58;
            target[1usize] = product_55;
            target[2usize] = value_59;
            let target = ::ezy_core::kernel::row_mut::<
                16usize,
                T,
            >(&mut store.left, k + 2usize);
            target[0usize] = sum_22;
            target[1usize] = value_56;
            target[2usize] = sum_22;
            target[3usize] = value_56;
            target[4usize] = sum_35;
            target[5usize] = value_57;
            target[6usize] = sum_35;
            target[7usize] = value_57;
            target[8usize] = product_42;
            target[9usize] = product_43;
            target[10usize] = product_42;
            target[11usize] = product_43;
            target[12usize] = sum_22;
            target[13usize] = value_56;
            target[14usize] = sum_35;
            target[15usize] = value_57;
            let target = ::ezy_core::kernel::row_mut::<
                6usize,
                T,
            >(&mut store.q, k + 2usize);
            target[0usize] = product_4;
            target[1usize] = product_6;
            target[2usize] = product_8;
            target[3usize] = product_10;
            target[4usize] = product_12;
            target[5usize] = product_14;
            let target = ::ezy_core::kernel::row_mut::<
                16usize,
                T,
            >(&mut store.right, k + 2usize);
            target[0usize] = lambda_2;
            target[1usize] = lambda_2;
            target[2usize] = lambda_0;
            target[3usize] = lambda_1;
            target[4usize] = lambda_3;
            target[5usize] = lambda_3;
            target[6usize] = lambda_0;
            target[7usize] = lambda_1;
            target[8usize] = sum_22;
            target[9usize] = sum_35;
            target[10usize] = value_56;
            target[11usize] = value_57;
            target[12usize] = product_44;
            target[13usize] = product_45;
            target[14usize] = product_46;
            target[15usize] = product_47;
        }
    }
    ///Driven, with rolling resistance.
    ///
    ///Cost of the accelerations and multipliers: 78 mul, 43 add, 1 div, 3 sin–cos.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct DrivenOnTarmac {
        ///rear wheel A, behind the seat's centre of mass (m); default `0.2`.
        pub a: f64,
        ///hinge B, ahead of the seat's centre of mass (m); default `0.6`.
        pub b: f64,
        ///front wheel C, beyond the bar's centre of mass (m); default `0.1`.
        pub c: f64,
        ///bar's centre of mass, beyond the hinge (m); default `0.1`.
        pub d: f64,
        ///mass of seat and rider (kg); default `46.0`.
        pub m1: f64,
        ///moment of inertia of seat and rider (kg*m^2); default `10.0`.
        pub i1: f64,
        ///mass of the bar (kg); default `1.0`.
        pub m2: f64,
        ///moment of inertia of the bar (kg*m^2); default `0.005`.
        pub i2: f64,
        ///largest torque (N*m); default `2.0`.
        pub m0: f64,
        ///angular frequency of the torque (rad/s); default `pi`.
        pub omega: f64,
        ///drag per speed (N*s/m); default `0.5`.
        pub k: f64,
    }
    impl ::core::default::Default for DrivenOnTarmac {
        fn default() -> Self {
            Self {
                a: 0.2f64,
                b: 0.6f64,
                c: 0.1f64,
                d: 0.1f64,
                m1: 46f64,
                i1: 10f64,
                m2: 1f64,
                i2: 0.005f64,
                m0: 2f64,
                omega: 3.141592653589793f64,
                k: 0.5f64,
            }
        }
    }
    impl DrivenOnTarmac {
        /// What is known of the scene when it is compiled.
        pub const INFO: ::ezy_core::model::SceneInfo = ::ezy_core::model::SceneInfo {
            model: "EzyRoller",
            name: "driven_on_tarmac",
            documentation: "Driven, with rolling resistance.",
            bodies: &["seat", "bar"],
            coordinates: &[
                ::ezy_core::model::CoordinateInfo {
                    name: "seat.x",
                    velocity_name: "seat.vx",
                    unit: "m",
                    symbol: ::ezy_core::model::Formula {
                        text: "seat.x",
                        latex: "x_{\\mathrm{seat}}",
                        mathml: "<msub><mi>x</mi><mtext>seat</mtext></msub>",
                    },
                    velocity_symbol: ::ezy_core::model::Formula {
                        text: "seat.vx",
                        latex: "\\dot{x}_{\\mathrm{seat}}",
                        mathml: "<msub><mover><mi>x</mi><mo>.</mo></mover><mtext>seat</mtext></msub>",
                    },
                },
                ::ezy_core::model::CoordinateInfo {
                    name: "seat.y",
                    velocity_name: "seat.vy",
                    unit: "m",
                    symbol: ::ezy_core::model::Formula {
                        text: "seat.y",
                        latex: "y_{\\mathrm{seat}}",
                        mathml: "<msub><mi>y</mi><mtext>seat</mtext></msub>",
                    },
                    velocity_symbol: ::ezy_core::model::Formula {
                        text: "seat.vy",
                        latex: "\\dot{y}_{\\mathrm{seat}}",
                        mathml: "<msub><mover><mi>y</mi><mo>.</mo></mover><mtext>seat</mtext></msub>",
                    },
                },
                ::ezy_core::model::CoordinateInfo {
                    name: "seat.phi",
                    velocity_name: "seat.omega",
                    unit: "rad",
                    symbol: ::ezy_core::model::Formula {
                        text: "seat.phi",
                        latex: "\\varphi_{\\mathrm{seat}}",
                        mathml: "<msub><mi>φ</mi><mtext>seat</mtext></msub>",
                    },
                    velocity_symbol: ::ezy_core::model::Formula {
                        text: "seat.omega",
                        latex: "\\dot{\\varphi}_{\\mathrm{seat}}",
                        mathml: "<msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext></msub>",
                    },
                },
                ::ezy_core::model::CoordinateInfo {
                    name: "bar.x",
                    velocity_name: "bar.vx",
                    unit: "m",
                    symbol: ::ezy_core::model::Formula {
                        text: "bar.x",
                        latex: "x_{\\mathrm{bar}}",
                        mathml: "<msub><mi>x</mi><mtext>bar</mtext></msub>",
                    },
                    velocity_symbol: ::ezy_core::model::Formula {
                        text: "bar.vx",
                        latex: "\\dot{x}_{\\mathrm{bar}}",
                        mathml: "<msub><mover><mi>x</mi><mo>.</mo></mover><mtext>bar</mtext></msub>",
                    },
                },
                ::ezy_core::model::CoordinateInfo {
                    name: "bar.y",
                    velocity_name: "bar.vy",
                    unit: "m",
                    symbol: ::ezy_core::model::Formula {
                        text: "bar.y",
                        latex: "y_{\\mathrm{bar}}",
                        mathml: "<msub><mi>y</mi><mtext>bar</mtext></msub>",
                    },
                    velocity_symbol: ::ezy_core::model::Formula {
                        text: "bar.vy",
                        latex: "\\dot{y}_{\\mathrm{bar}}",
                        mathml: "<msub><mover><mi>y</mi><mo>.</mo></mover><mtext>bar</mtext></msub>",
                    },
                },
                ::ezy_core::model::CoordinateInfo {
                    name: "bar.phi",
                    velocity_name: "bar.omega",
                    unit: "rad",
                    symbol: ::ezy_core::model::Formula {
                        text: "bar.phi",
                        latex: "\\varphi_{\\mathrm{bar}}",
                        mathml: "<msub><mi>φ</mi><mtext>bar</mtext></msub>",
                    },
                    velocity_symbol: ::ezy_core::model::Formula {
                        text: "bar.omega",
                        latex: "\\dot{\\varphi}_{\\mathrm{bar}}",
                        mathml: "<msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext></msub>",
                    },
                },
            ],
            points: &[
                ::ezy_core::model::PointInfo {
                    name: "A",
                    body: ::core::option::Option::Some(0usize),
                    position: ::core::option::Option::Some([
                        ::ezy_core::model::Formula {
                            text: "seat.x - a*cos(seat.phi)",
                            latex: "x_{\\mathrm{seat}} - a \\, \\cos{\\varphi_{\\mathrm{seat}}}",
                            mathml: "<mrow><msub><mi>x</mi><mtext>seat</mtext></msub><mo>−</mo><mi>a</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                        },
                        ::ezy_core::model::Formula {
                            text: "seat.y - a*sin(seat.phi)",
                            latex: "y_{\\mathrm{seat}} - a \\, \\sin{\\varphi_{\\mathrm{seat}}}",
                            mathml: "<mrow><msub><mi>y</mi><mtext>seat</mtext></msub><mo>−</mo><mi>a</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                        },
                    ]),
                },
                ::ezy_core::model::PointInfo {
                    name: "C",
                    body: ::core::option::Option::Some(1usize),
                    position: ::core::option::Option::Some([
                        ::ezy_core::model::Formula {
                            text: "bar.x + c*cos(bar.phi)",
                            latex: "x_{\\mathrm{bar}} + c \\, \\cos{\\varphi_{\\mathrm{bar}}}",
                            mathml: "<mrow><msub><mi>x</mi><mtext>bar</mtext></msub><mo>+</mo><mi>c</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                        },
                        ::ezy_core::model::Formula {
                            text: "bar.y + c*sin(bar.phi)",
                            latex: "y_{\\mathrm{bar}} + c \\, \\sin{\\varphi_{\\mathrm{bar}}}",
                            mathml: "<mrow><msub><mi>y</mi><mtext>bar</mtext></msub><mo>+</mo><mi>c</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                        },
                    ]),
                },
                ::ezy_core::model::PointInfo {
                    name: "B",
                    body: ::core::option::Option::Some(0usize),
                    position: ::core::option::Option::Some([
                        ::ezy_core::model::Formula {
                            text: "seat.x + b*cos(seat.phi)",
                            latex: "x_{\\mathrm{seat}} + b \\, \\cos{\\varphi_{\\mathrm{seat}}}",
                            mathml: "<mrow><msub><mi>x</mi><mtext>seat</mtext></msub><mo>+</mo><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                        },
                        ::ezy_core::model::Formula {
                            text: "seat.y + b*sin(seat.phi)",
                            latex: "y_{\\mathrm{seat}} + b \\, \\sin{\\varphi_{\\mathrm{seat}}}",
                            mathml: "<mrow><msub><mi>y</mi><mtext>seat</mtext></msub><mo>+</mo><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                        },
                    ]),
                },
            ],
            rows: &[
                ::ezy_core::model::RowInfo {
                    name: "B.x",
                    kind: "hinge",
                    multiplier_unit: "N",
                    constraint: ::ezy_core::model::Formula {
                        text: "seat.x + b*cos(seat.phi) - bar.x + d*cos(bar.phi)",
                        latex: "x_{\\mathrm{seat}} + b \\, \\cos{\\varphi_{\\mathrm{seat}}} - x_{\\mathrm{bar}} + d \\, \\cos{\\varphi_{\\mathrm{bar}}}",
                        mathml: "<mrow><msub><mi>x</mi><mtext>seat</mtext></msub><mo>+</mo><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>−</mo><msub><mi>x</mi><mtext>bar</mtext></msub><mo>+</mo><mi>d</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                    },
                    convective_term: ::ezy_core::model::Formula {
                        text: "-b*seat.omega^2*cos(seat.phi) - d*bar.omega^2*cos(bar.phi)",
                        latex: "-b \\, \\dot{\\varphi}_{\\mathrm{seat}}^{2} \\, \\cos{\\varphi_{\\mathrm{seat}}} - d \\, \\dot{\\varphi}_{\\mathrm{bar}}^{2} \\, \\cos{\\varphi_{\\mathrm{bar}}}",
                        mathml: "<mrow><mo>−</mo><mi>b</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>−</mo><mi>d</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                    },
                },
                ::ezy_core::model::RowInfo {
                    name: "B.y",
                    kind: "hinge",
                    multiplier_unit: "N",
                    constraint: ::ezy_core::model::Formula {
                        text: "seat.y + b*sin(seat.phi) - bar.y + d*sin(bar.phi)",
                        latex: "y_{\\mathrm{seat}} + b \\, \\sin{\\varphi_{\\mathrm{seat}}} - y_{\\mathrm{bar}} + d \\, \\sin{\\varphi_{\\mathrm{bar}}}",
                        mathml: "<mrow><msub><mi>y</mi><mtext>seat</mtext></msub><mo>+</mo><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>−</mo><msub><mi>y</mi><mtext>bar</mtext></msub><mo>+</mo><mi>d</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                    },
                    convective_term: ::ezy_core::model::Formula {
                        text: "-b*seat.omega^2*sin(seat.phi) - d*bar.omega^2*sin(bar.phi)",
                        latex: "-b \\, \\dot{\\varphi}_{\\mathrm{seat}}^{2} \\, \\sin{\\varphi_{\\mathrm{seat}}} - d \\, \\dot{\\varphi}_{\\mathrm{bar}}^{2} \\, \\sin{\\varphi_{\\mathrm{bar}}}",
                        mathml: "<mrow><mo>−</mo><mi>b</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>−</mo><mi>d</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                    },
                },
                ::ezy_core::model::RowInfo {
                    name: "rear",
                    kind: "skate",
                    multiplier_unit: "N",
                    constraint: ::ezy_core::model::Formula {
                        text: "-a*seat.omega - seat.vx*sin(seat.phi) + seat.vy*cos(seat.phi)",
                        latex: "-a \\, \\dot{\\varphi}_{\\mathrm{seat}} - \\dot{x}_{\\mathrm{seat}} \\, \\sin{\\varphi_{\\mathrm{seat}}} + \\dot{y}_{\\mathrm{seat}} \\, \\cos{\\varphi_{\\mathrm{seat}}}",
                        mathml: "<mrow><mo>−</mo><mi>a</mi><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mo>−</mo><msub><mover><mi>x</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>+</mo><msub><mover><mi>y</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                    },
                    convective_term: ::ezy_core::model::Formula {
                        text: "-seat.vx*seat.omega*cos(seat.phi) - seat.vy*seat.omega*sin(seat.phi)",
                        latex: "-\\dot{x}_{\\mathrm{seat}} \\, \\dot{\\varphi}_{\\mathrm{seat}} \\, \\cos{\\varphi_{\\mathrm{seat}}} - \\dot{y}_{\\mathrm{seat}} \\, \\dot{\\varphi}_{\\mathrm{seat}} \\, \\sin{\\varphi_{\\mathrm{seat}}}",
                        mathml: "<mrow><mo>−</mo><msub><mover><mi>x</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>−</mo><msub><mover><mi>y</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                    },
                },
                ::ezy_core::model::RowInfo {
                    name: "front",
                    kind: "skate",
                    multiplier_unit: "N",
                    constraint: ::ezy_core::model::Formula {
                        text: "c*bar.omega - bar.vx*sin(bar.phi) + bar.vy*cos(bar.phi)",
                        latex: "c \\, \\dot{\\varphi}_{\\mathrm{bar}} - \\dot{x}_{\\mathrm{bar}} \\, \\sin{\\varphi_{\\mathrm{bar}}} + \\dot{y}_{\\mathrm{bar}} \\, \\cos{\\varphi_{\\mathrm{bar}}}",
                        mathml: "<mrow><mi>c</mi><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mo>−</mo><msub><mover><mi>x</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow><mo>+</mo><msub><mover><mi>y</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                    },
                    convective_term: ::ezy_core::model::Formula {
                        text: "-bar.vx*bar.omega*cos(bar.phi) - bar.vy*bar.omega*sin(bar.phi)",
                        latex: "-\\dot{x}_{\\mathrm{bar}} \\, \\dot{\\varphi}_{\\mathrm{bar}} \\, \\cos{\\varphi_{\\mathrm{bar}}} - \\dot{y}_{\\mathrm{bar}} \\, \\dot{\\varphi}_{\\mathrm{bar}} \\, \\sin{\\varphi_{\\mathrm{bar}}}",
                        mathml: "<mrow><mo>−</mo><msub><mover><mi>x</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow><mo>−</mo><msub><mover><mi>y</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                    },
                },
            ],
            n_position_rows: 2usize,
            parameters: &[
                ::ezy_core::model::ParameterInfo {
                    name: "a",
                    unit: "m",
                    default: 0.2f64,
                    default_text: "0.2",
                    documentation: "rear wheel A, behind the seat's centre of mass",
                    effect: ::core::option::Option::None,
                    symbol: ::ezy_core::model::Formula {
                        text: "a",
                        latex: "a",
                        mathml: "<mi>a</mi>",
                    },
                },
                ::ezy_core::model::ParameterInfo {
                    name: "b",
                    unit: "m",
                    default: 0.6f64,
                    default_text: "0.6",
                    documentation: "hinge B, ahead of the seat's centre of mass",
                    effect: ::core::option::Option::None,
                    symbol: ::ezy_core::model::Formula {
                        text: "b",
                        latex: "b",
                        mathml: "<mi>b</mi>",
                    },
                },
                ::ezy_core::model::ParameterInfo {
                    name: "c",
                    unit: "m",
                    default: 0.1f64,
                    default_text: "0.1",
                    documentation: "front wheel C, beyond the bar's centre of mass",
                    effect: ::core::option::Option::None,
                    symbol: ::ezy_core::model::Formula {
                        text: "c",
                        latex: "c",
                        mathml: "<mi>c</mi>",
                    },
                },
                ::ezy_core::model::ParameterInfo {
                    name: "d",
                    unit: "m",
                    default: 0.1f64,
                    default_text: "0.1",
                    documentation: "bar's centre of mass, beyond the hinge",
                    effect: ::core::option::Option::None,
                    symbol: ::ezy_core::model::Formula {
                        text: "d",
                        latex: "d",
                        mathml: "<mi>d</mi>",
                    },
                },
                ::ezy_core::model::ParameterInfo {
                    name: "m1",
                    unit: "kg",
                    default: 46f64,
                    default_text: "46.0",
                    documentation: "mass of seat and rider",
                    effect: ::core::option::Option::None,
                    symbol: ::ezy_core::model::Formula {
                        text: "m1",
                        latex: "m_{1}",
                        mathml: "<msub><mi>m</mi><mtext>1</mtext></msub>",
                    },
                },
                ::ezy_core::model::ParameterInfo {
                    name: "i1",
                    unit: "kg*m^2",
                    default: 10f64,
                    default_text: "10.0",
                    documentation: "moment of inertia of seat and rider",
                    effect: ::core::option::Option::None,
                    symbol: ::ezy_core::model::Formula {
                        text: "i1",
                        latex: "i_{1}",
                        mathml: "<msub><mi>i</mi><mtext>1</mtext></msub>",
                    },
                },
                ::ezy_core::model::ParameterInfo {
                    name: "m2",
                    unit: "kg",
                    default: 1f64,
                    default_text: "1.0",
                    documentation: "mass of the bar",
                    effect: ::core::option::Option::None,
                    symbol: ::ezy_core::model::Formula {
                        text: "m2",
                        latex: "m_{2}",
                        mathml: "<msub><mi>m</mi><mtext>2</mtext></msub>",
                    },
                },
                ::ezy_core::model::ParameterInfo {
                    name: "i2",
                    unit: "kg*m^2",
                    default: 0.005f64,
                    default_text: "0.005",
                    documentation: "moment of inertia of the bar",
                    effect: ::core::option::Option::None,
                    symbol: ::ezy_core::model::Formula {
                        text: "i2",
                        latex: "i_{2}",
                        mathml: "<msub><mi>i</mi><mtext>2</mtext></msub>",
                    },
                },
                ::ezy_core::model::ParameterInfo {
                    name: "m0",
                    unit: "N*m",
                    default: 2f64,
                    default_text: "2.0",
                    documentation: "largest torque",
                    effect: ::core::option::Option::Some("pump"),
                    symbol: ::ezy_core::model::Formula {
                        text: "m0",
                        latex: "m_{0}",
                        mathml: "<msub><mi>m</mi><mtext>0</mtext></msub>",
                    },
                },
                ::ezy_core::model::ParameterInfo {
                    name: "omega",
                    unit: "rad/s",
                    default: 3.141592653589793f64,
                    default_text: "pi",
                    documentation: "angular frequency of the torque",
                    effect: ::core::option::Option::Some("pump"),
                    symbol: ::ezy_core::model::Formula {
                        text: "omega",
                        latex: "\\omega",
                        mathml: "<mi>ω</mi>",
                    },
                },
                ::ezy_core::model::ParameterInfo {
                    name: "k",
                    unit: "N*s/m",
                    default: 0.5f64,
                    default_text: "0.5",
                    documentation: "drag per speed",
                    effect: ::core::option::Option::Some("rolling_resistance"),
                    symbol: ::ezy_core::model::Formula {
                        text: "k",
                        latex: "k",
                        mathml: "<mi>k</mi>",
                    },
                },
            ],
            inputs: &[],
            outputs: &[],
            effects: &[
                ::ezy_core::model::EffectInfo {
                    name: "pump",
                    documentation: "The rider swings the bar: a torque between seat and bar.",
                },
                ::ezy_core::model::EffectInfo {
                    name: "rolling_resistance",
                    documentation: "Drag of the rear wheel, proportional to its speed.",
                },
            ],
            until_s: 60f64,
            n_constants: 39usize,
            jacobian: ::ezy_core::model::SparsityPattern {
                starts: &[0usize, 4usize, 8usize, 11usize, 14usize],
                columns: &[
                    0usize, 2usize, 3usize, 5usize, 1usize, 2usize, 4usize, 5usize,
                    0usize, 1usize, 2usize, 3usize, 4usize, 5usize,
                ],
            },
            jacobian_entries: &[
                ::ezy_core::model::Formula {
                    text: "1",
                    latex: "1",
                    mathml: "<mrow><mn>1</mn></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "-b*sin(seat.phi)",
                    latex: "-b \\, \\sin{\\varphi_{\\mathrm{seat}}}",
                    mathml: "<mrow><mo>−</mo><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "-1",
                    latex: "-1",
                    mathml: "<mrow><mo>−</mo><mn>1</mn></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "-d*sin(bar.phi)",
                    latex: "-d \\, \\sin{\\varphi_{\\mathrm{bar}}}",
                    mathml: "<mrow><mo>−</mo><mi>d</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "1",
                    latex: "1",
                    mathml: "<mrow><mn>1</mn></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "b*cos(seat.phi)",
                    latex: "b \\, \\cos{\\varphi_{\\mathrm{seat}}}",
                    mathml: "<mrow><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "-1",
                    latex: "-1",
                    mathml: "<mrow><mo>−</mo><mn>1</mn></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "d*cos(bar.phi)",
                    latex: "d \\, \\cos{\\varphi_{\\mathrm{bar}}}",
                    mathml: "<mrow><mi>d</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "-sin(seat.phi)",
                    latex: "-\\sin{\\varphi_{\\mathrm{seat}}}",
                    mathml: "<mrow><mo>−</mo><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "cos(seat.phi)",
                    latex: "\\cos{\\varphi_{\\mathrm{seat}}}",
                    mathml: "<mrow><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "-a",
                    latex: "-a",
                    mathml: "<mrow><mo>−</mo><mi>a</mi></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "-sin(bar.phi)",
                    latex: "-\\sin{\\varphi_{\\mathrm{bar}}}",
                    mathml: "<mrow><mo>−</mo><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "cos(bar.phi)",
                    latex: "\\cos{\\varphi_{\\mathrm{bar}}}",
                    mathml: "<mrow><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "c",
                    latex: "c",
                    mathml: "<mrow><mi>c</mi></mrow>",
                },
            ],
            mass_entries: &[
                ::ezy_core::model::Formula {
                    text: "m1",
                    latex: "m_{1}",
                    mathml: "<mrow><msub><mi>m</mi><mtext>1</mtext></msub></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "m1",
                    latex: "m_{1}",
                    mathml: "<mrow><msub><mi>m</mi><mtext>1</mtext></msub></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "i1",
                    latex: "i_{1}",
                    mathml: "<mrow><msub><mi>i</mi><mtext>1</mtext></msub></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "m2",
                    latex: "m_{2}",
                    mathml: "<mrow><msub><mi>m</mi><mtext>2</mtext></msub></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "m2",
                    latex: "m_{2}",
                    mathml: "<mrow><msub><mi>m</mi><mtext>2</mtext></msub></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "i2",
                    latex: "i_{2}",
                    mathml: "<mrow><msub><mi>i</mi><mtext>2</mtext></msub></mrow>",
                },
            ],
            force_entries: &[
                ::ezy_core::model::Formula {
                    text: "-k*seat.vx - k*a*seat.omega*sin(seat.phi)",
                    latex: "-k \\, \\dot{x}_{\\mathrm{seat}} - k \\, a \\, \\dot{\\varphi}_{\\mathrm{seat}} \\, \\sin{\\varphi_{\\mathrm{seat}}}",
                    mathml: "<mrow><mo>−</mo><mi>k</mi><mspace width=\"0.17em\"/><msub><mover><mi>x</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mo>−</mo><mi>k</mi><mspace width=\"0.17em\"/><mi>a</mi><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "-k*seat.vy + k*a*seat.omega*cos(seat.phi)",
                    latex: "-k \\, \\dot{y}_{\\mathrm{seat}} + k \\, a \\, \\dot{\\varphi}_{\\mathrm{seat}} \\, \\cos{\\varphi_{\\mathrm{seat}}}",
                    mathml: "<mrow><mo>−</mo><mi>k</mi><mspace width=\"0.17em\"/><msub><mover><mi>y</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mo>+</mo><mi>k</mi><mspace width=\"0.17em\"/><mi>a</mi><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "-k*a^2*seat.omega - k*a*seat.vx*sin(seat.phi) + k*a*seat.vy*cos(seat.phi) + m0*cos(omega*t)",
                    latex: "-k \\, a^{2} \\, \\dot{\\varphi}_{\\mathrm{seat}} - k \\, a \\, \\dot{x}_{\\mathrm{seat}} \\, \\sin{\\varphi_{\\mathrm{seat}}} + k \\, a \\, \\dot{y}_{\\mathrm{seat}} \\, \\cos{\\varphi_{\\mathrm{seat}}} + m_{0} \\, \\cos\\left(\\omega \\, t\\right)",
                    mathml: "<mrow><mo>−</mo><mi>k</mi><mspace width=\"0.17em\"/><msup><mrow><mi>a</mi></mrow><mn>2</mn></msup><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mo>−</mo><mi>k</mi><mspace width=\"0.17em\"/><mi>a</mi><mspace width=\"0.17em\"/><msub><mover><mi>x</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>+</mo><mi>k</mi><mspace width=\"0.17em\"/><mi>a</mi><mspace width=\"0.17em\"/><msub><mover><mi>y</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>+</mo><msub><mi>m</mi><mtext>0</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mrow><mo>(</mo><mi>ω</mi><mspace width=\"0.17em\"/><mi>t</mi><mo>)</mo></mrow></mrow></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "0",
                    latex: "0",
                    mathml: "<mrow><mn>0</mn></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "0",
                    latex: "0",
                    mathml: "<mrow><mn>0</mn></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "-m0*cos(omega*t)",
                    latex: "-m_{0} \\, \\cos\\left(\\omega \\, t\\right)",
                    mathml: "<mrow><mo>−</mo><msub><mi>m</mi><mtext>0</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mrow><mo>(</mo><mi>ω</mi><mspace width=\"0.17em\"/><mi>t</mi><mo>)</mo></mrow></mrow></mrow>",
                },
            ],
            potential_energy: ::ezy_core::model::Formula {
                text: "0",
                latex: "0",
                mathml: "<mrow><mn>0</mn></mrow>",
            },
            abbreviations: &[],
            elimination: &[
                ::ezy_core::model::EliminationStep {
                    rows: &[2usize],
                    constant_pivot: true,
                },
                ::ezy_core::model::EliminationStep {
                    rows: &[3usize],
                    constant_pivot: true,
                },
                ::ezy_core::model::EliminationStep {
                    rows: &[0usize, 1usize],
                    constant_pivot: false,
                },
            ],
            acceleration_operations: ::ezy_core::model::Operations {
                add: 43usize,
                mul: 78usize,
                div: 1usize,
                trig: 3usize,
                calls: 0usize,
            },
            correction_operations: ::ezy_core::model::Operations {
                add: 23usize,
                mul: 42usize,
                div: 1usize,
                trig: 2usize,
                calls: 0usize,
            },
            series: ::ezy_core::model::SeriesInfo::Analytic {
                n_products: 20usize,
                operations: ::ezy_core::model::Operations {
                    add: 68usize,
                    mul: 106usize,
                    div: 0usize,
                    trig: 0usize,
                    calls: 0usize,
                },
            },
            repeats: ::core::option::Option::None,
        };
    }
    #[automatically_derived]
    impl<T: ::ezy_core::scalar::Scalar> ::ezy_core::model::Equations<T>
    for self::DrivenOnTarmac {
        fn constants(&self, parameters: &[T], c: &mut [T]) {
            let parameters = ::ezy_core::kernel::array::<11usize, T>(parameters);
            let c = ::ezy_core::kernel::array_mut::<39usize, T>(c);
            let k1 = T::from_f64(1f64);
            let parameter_m1 = parameters[4usize];
            let parameter_i1 = parameters[5usize];
            let parameter_m2 = parameters[6usize];
            let parameter_i2 = parameters[7usize];
            let parameter_b = parameters[1usize];
            let parameter_d = parameters[3usize];
            let parameter_a = parameters[0usize];
            let parameter_c = parameters[2usize];
            let parameter_m0 = parameters[8usize];
            let parameter_omega = parameters[9usize];
            let parameter_k = parameters[10usize];
            let k14 = parameter_k * parameter_a;
            let k15 = k14 * parameter_a;
            let k16 = -(k14 + k14);
            let k17 = T::PI;
            let k18 = k1 / parameter_m1;
            let k19 = k1 / parameter_i1;
            let k20 = parameter_b * k19;
            let k21 = k1 / parameter_m2;
            let k22 = k1 / parameter_i2;
            let k23 = parameter_d * parameter_m0;
            let k24 = k23 * k22;
            let k25 = parameter_a * k19;
            let k26 = parameter_c * parameter_m0;
            let k27 = k26 * k22;
            let k28 = parameter_b * parameter_b;
            let k29 = k28 * k19;
            let k30 = parameter_d * parameter_d;
            let k31 = k30 * k22;
            let k32 = k18 + k29;
            let k33 = k32 + k21;
            let k34 = k33 + k31;
            let k35 = parameter_b * parameter_a;
            let k36 = k35 * k19;
            let k37 = k36 - k18;
            let k38 = parameter_d * parameter_c;
            let k39 = k38 * k22;
            let k40 = k21 - k39;
            let k41 = k18 + k21;
            let k42 = parameter_a * parameter_a;
            let k43 = k42 * k19;
            let k44 = k18 + k43;
            let k45 = parameter_c * parameter_c;
            let k46 = k45 * k22;
            let k47 = k21 + k46;
            let k48 = k1 / k44;
            let k49 = k37 * k48;
            let k50 = k49 * k37;
            let k51 = k34 - k50;
            let k52 = k50 - k29;
            let k53 = k1 / k47;
            let k54 = k40 * k53;
            let k55 = k54 * k40;
            let k56 = k51 - k55;
            let k57 = k55 - k31;
            let k58 = parameter_m0 * k22;
            let k59 = parameter_d * k22;
            let k60 = parameter_c * k22;
            let k61 = T::from_f64(0.0000000001f64);
            let k62 = k61 * k44;
            let k63 = k61 * k47;
            let k64 = k34 + k41;
            let k65 = k64 * k64;
            let k66 = k61 * k65;
            c[0usize] = parameter_k;
            c[1usize] = k14;
            c[2usize] = k15;
            c[3usize] = parameter_m0;
            c[4usize] = parameter_omega;
            c[5usize] = k18;
            c[6usize] = k25;
            c[7usize] = k27;
            c[8usize] = k52;
            c[9usize] = k57;
            c[10usize] = k56;
            c[11usize] = k41;
            c[12usize] = k20;
            c[13usize] = k49;
            c[14usize] = k24;
            c[15usize] = k54;
            c[16usize] = parameter_b;
            c[17usize] = parameter_d;
            c[18usize] = k53;
            c[19usize] = k48;
            c[20usize] = k19;
            c[21usize] = k21;
            c[22usize] = k59;
            c[23usize] = k58;
            c[24usize] = k60;
            c[25usize] = k44;
            c[26usize] = k62;
            c[27usize] = k47;
            c[28usize] = k63;
            c[29usize] = k66;
            c[30usize] = k22;
            c[31usize] = parameter_m1;
            c[32usize] = parameter_i1;
            c[33usize] = parameter_m2;
            c[34usize] = parameter_i2;
            c[35usize] = parameter_a;
            c[36usize] = parameter_c;
            c[37usize] = k16;
            c[38usize] = k17;
        }
        fn mass_matrix(&self, c: &[T], m: &mut [T]) {
            let c = ::ezy_core::kernel::array::<39usize, T>(c);
            let out = ::ezy_core::kernel::array_mut::<6usize, T>(m);
            out[0usize] = c[31usize];
            out[1usize] = c[31usize];
            out[2usize] = c[32usize];
            out[3usize] = c[33usize];
            out[4usize] = c[33usize];
            out[5usize] = c[34usize];
        }
        fn position_constraint(&self, c: &[T], t: T, q: &[T], out: &mut [T]) {
            let c = ::ezy_core::kernel::array::<39usize, T>(c);
            let q = ::ezy_core::kernel::array::<6usize, T>(q);
            let out = ::ezy_core::kernel::array_mut::<2usize, T>(out);
            let seat_x = q[0usize];
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let sum_7 = T::fused(c[16usize], cos_seat_phi, seat_x);
            let bar_x = q[3usize];
            let difference_9 = sum_7 - bar_x;
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
            let sum_14 = T::fused(c[17usize], cos_bar_phi, difference_9);
            let seat_y = q[1usize];
            let sum_18 = T::fused(c[16usize], sin_seat_phi, seat_y);
            let bar_y = q[4usize];
            let difference_20 = sum_18 - bar_y;
            let sum_23 = T::fused(c[17usize], sin_bar_phi, difference_20);
            out[0usize] = sum_14;
            out[1usize] = sum_23;
        }
        fn velocity_constraint(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
            let c = ::ezy_core::kernel::array::<39usize, T>(c);
            let q = ::ezy_core::kernel::array::<6usize, T>(q);
            let v = ::ezy_core::kernel::array::<6usize, T>(v);
            let out = ::ezy_core::kernel::array_mut::<4usize, T>(out);
            let seat_vx = v[0usize];
            let seat_omega = v[2usize];
            let product_5 = c[16usize] * seat_omega;
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let difference_9 = T::fused(-product_5, sin_seat_phi, seat_vx);
            let bar_vx = v[3usize];
            let difference_11 = difference_9 - bar_vx;
            let bar_omega = v[5usize];
            let product_14 = c[17usize] * bar_omega;
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
            let difference_18 = T::fused(-product_14, sin_bar_phi, difference_11);
            let seat_vy = v[1usize];
            let bar_vy = v[4usize];
            let difference_21 = seat_vy - bar_vy;
            let sum_24 = T::fused(product_5, cos_seat_phi, difference_21);
            let sum_27 = T::fused(product_14, cos_bar_phi, sum_24);
            let product_29 = seat_omega * c[35usize];
            let sum_31 = T::fused(seat_vx, sin_seat_phi, product_29);
            let difference_33 = T::fused(seat_vy, cos_seat_phi, -sum_31);
            let product_35 = bar_omega * c[36usize];
            let difference_37 = T::fused(-bar_vx, sin_bar_phi, product_35);
            let sum_39 = T::fused(bar_vy, cos_bar_phi, difference_37);
            out[0usize] = difference_18;
            out[1usize] = sum_27;
            out[2usize] = difference_33;
            out[3usize] = sum_39;
        }
        fn velocity_jacobian(&self, c: &[T], t: T, q: &[T], out: &mut [T]) {
            let c = ::ezy_core::kernel::array::<39usize, T>(c);
            let q = ::ezy_core::kernel::array::<6usize, T>(q);
            let out = ::ezy_core::kernel::array_mut::<14usize, T>(out);
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let product_4 = c[16usize] * sin_seat_phi;
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
            let product_8 = c[17usize] * sin_bar_phi;
            let product_10 = c[16usize] * cos_seat_phi;
            let product_12 = c[17usize] * cos_bar_phi;
            let value_15 = -product_4;
            let value_16 = -T::from_f64(1f64);
            let value_17 = -product_8;
            let value_18 = -sin_seat_phi;
            let value_19 = -c[35usize];
            let value_20 = -sin_bar_phi;
            out[0usize] = T::from_f64(1f64);
            out[1usize] = value_15;
            out[2usize] = value_16;
            out[3usize] = value_17;
            out[4usize] = T::from_f64(1f64);
            out[5usize] = product_10;
            out[6usize] = value_16;
            out[7usize] = product_12;
            out[8usize] = value_18;
            out[9usize] = cos_seat_phi;
            out[10usize] = value_19;
            out[11usize] = value_20;
            out[12usize] = cos_bar_phi;
            out[13usize] = c[36usize];
        }
        fn convective_term(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
            let c = ::ezy_core::kernel::array::<39usize, T>(c);
            let q = ::ezy_core::kernel::array::<6usize, T>(q);
            let v = ::ezy_core::kernel::array::<6usize, T>(v);
            let out = ::ezy_core::kernel::array_mut::<4usize, T>(out);
            let seat_omega = v[2usize];
            let product_3 = c[16usize] * seat_omega;
            let product_4 = seat_omega * product_3;
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let product_8 = product_4 * cos_seat_phi;
            let bar_omega = v[5usize];
            let product_11 = c[17usize] * bar_omega;
            let product_12 = bar_omega * product_11;
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
            let sum_16 = T::fused(product_12, cos_bar_phi, product_8);
            let product_18 = product_4 * sin_seat_phi;
            let sum_21 = T::fused(product_12, sin_bar_phi, product_18);
            let seat_vx = v[0usize];
            let product_23 = cos_seat_phi * seat_vx;
            let seat_vy = v[1usize];
            let sum_26 = T::fused(sin_seat_phi, seat_vy, product_23);
            let product_27 = seat_omega * sum_26;
            let bar_vx = v[3usize];
            let product_29 = cos_bar_phi * bar_vx;
            let bar_vy = v[4usize];
            let sum_32 = T::fused(sin_bar_phi, bar_vy, product_29);
            let product_33 = bar_omega * sum_32;
            let value_34 = -sum_16;
            let value_35 = -sum_21;
            let value_36 = -product_27;
            let value_37 = -product_33;
            out[0usize] = value_34;
            out[1usize] = value_35;
            out[2usize] = value_36;
            out[3usize] = value_37;
        }
        fn applied_force(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
            let c = ::ezy_core::kernel::array::<39usize, T>(c);
            let q = ::ezy_core::kernel::array::<6usize, T>(q);
            let v = ::ezy_core::kernel::array::<6usize, T>(v);
            let out = ::ezy_core::kernel::array_mut::<6usize, T>(out);
            let seat_vx = v[0usize];
            let product_3 = c[0usize] * seat_vx;
            let seat_omega = v[2usize];
            let product_6 = c[1usize] * seat_omega;
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let sum_11 = T::fused(product_6, sin_seat_phi, product_3);
            let seat_vy = v[1usize];
            let product_15 = product_6 * cos_seat_phi;
            let difference_16 = T::fused(-c[0usize], seat_vy, product_15);
            let product_18 = seat_vy * cos_seat_phi;
            let difference_19 = T::fused(-seat_vx, sin_seat_phi, product_18);
            let product_20 = c[1usize] * difference_19;
            let difference_23 = T::fused(-seat_omega, c[2usize], product_20);
            let product_27 = c[4usize] * t;
            let cos_27 = T::cos(product_27);
            let product_29 = c[3usize] * cos_27;
            let sum_30 = difference_23 + product_29;
            let value_31 = -sum_11;
            let value_32 = -product_29;
            out[0usize] = value_31;
            out[1usize] = difference_16;
            out[2usize] = sum_30;
            out[3usize] = T::from_f64(0f64);
            out[4usize] = T::from_f64(0f64);
            out[5usize] = value_32;
        }
        #[inline]
        fn accelerations(
            &self,
            c: &[T],
            t: T,
            q: &[T],
            v: &[T],
            a: &mut [T],
            lambda: &mut [T],
        ) -> ::ezy_core::model::DeficientRows {
            let c = ::ezy_core::kernel::array::<39usize, T>(c);
            let q = ::ezy_core::kernel::array::<6usize, T>(q);
            let v = ::ezy_core::kernel::array::<6usize, T>(v);
            let a = ::ezy_core::kernel::array_mut::<6usize, T>(a);
            let lambda = ::ezy_core::kernel::array_mut::<4usize, T>(lambda);
            let seat_vx = v[0usize];
            let product_3 = c[0usize] * seat_vx;
            let seat_omega = v[2usize];
            let product_6 = c[1usize] * seat_omega;
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let minus_force_seat_x = T::fused(product_6, sin_seat_phi, product_3);
            let seat_vy = v[1usize];
            let product_15 = product_6 * cos_seat_phi;
            let force_seat_y = T::fused(-c[0usize], seat_vy, product_15);
            let product_18 = seat_vy * cos_seat_phi;
            let difference_19 = T::fused(-seat_vx, sin_seat_phi, product_18);
            let product_20 = c[1usize] * difference_19;
            let difference_23 = T::fused(-seat_omega, c[2usize], product_20);
            let product_27 = c[4usize] * t;
            let cos_27 = T::cos(product_27);
            let force_seat_phi = T::fused(c[3usize], cos_27, difference_23);
            let product_31 = sin_seat_phi * minus_force_seat_x;
            let sum_33 = T::fused(cos_seat_phi, force_seat_y, product_31);
            let product_35 = sum_33 * c[5usize];
            let product_36 = seat_vx * cos_seat_phi;
            let sum_38 = T::fused(sin_seat_phi, seat_vy, product_36);
            let difference_40 = T::fused(-seat_omega, sum_38, product_35);
            let right_side_rear = T::fused(-force_seat_phi, c[6usize], difference_40);
            let bar_vx = v[3usize];
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
            let product_47 = bar_vx * cos_bar_phi;
            let bar_vy = v[4usize];
            let sum_51 = T::fused(bar_vy, sin_bar_phi, product_47);
            let bar_omega = v[5usize];
            let product_53 = sum_51 * bar_omega;
            let minus_right_side_front = T::fused(cos_27, c[7usize], product_53);
            let product_58 = cos_seat_phi * c[8usize];
            let product_59 = cos_seat_phi * product_58;
            let product_61 = cos_bar_phi * c[9usize];
            let sum_63 = T::fused(cos_bar_phi, product_61, product_59);
            let sum_65 = sum_63 + c[10usize];
            let product_66 = sin_seat_phi * c[8usize];
            let product_67 = cos_seat_phi * product_66;
            let product_68 = sin_bar_phi * c[9usize];
            let sum_70 = T::fused(cos_bar_phi, product_68, product_67);
            let difference_72 = c[11usize] - sum_63;
            let product_74 = force_seat_phi * c[12usize];
            let sum_77 = T::fused(right_side_rear, c[13usize], product_74);
            let product_80 = cos_27 * c[14usize];
            let sum_83 = T::fused(minus_right_side_front, c[15usize], product_80);
            let product_84 = sin_bar_phi * sum_83;
            let difference_85 = T::fused(-sin_seat_phi, sum_77, product_84);
            let product_87 = seat_omega * c[16usize];
            let product_88 = seat_omega * product_87;
            let difference_90 = T::fused(-cos_seat_phi, product_88, difference_85);
            let product_92 = bar_omega * c[17usize];
            let product_93 = bar_omega * product_92;
            let difference_95 = T::fused(-cos_bar_phi, product_93, difference_90);
            let difference_97 = T::fused(-minus_force_seat_x, c[5usize], difference_95);
            let product_98 = cos_seat_phi * sum_77;
            let difference_100 = T::fused(-cos_bar_phi, sum_83, product_98);
            let difference_102 = T::fused(-sin_seat_phi, product_88, difference_100);
            let difference_104 = T::fused(-sin_bar_phi, product_93, difference_102);
            let sum_106 = T::fused(force_seat_y, c[5usize], difference_104);
            let product_107 = sum_65 * difference_72;
            let difference_109 = T::fused(-sum_70, sum_70, product_107);
            let quotient_110 = T::from_f64(1f64) / difference_109;
            let product_111 = difference_72 * difference_97;
            let difference_113 = T::fused(-sum_70, sum_106, product_111);
            let lambda_B_x = quotient_110 * difference_113;
            let product_116 = sum_65 * sum_106;
            let difference_117 = T::fused(-sum_70, difference_97, product_116);
            let lambda_B_y = quotient_110 * difference_117;
            let product_120 = cos_bar_phi * lambda_B_y;
            let difference_121 = T::fused(-sin_bar_phi, lambda_B_x, product_120);
            let product_122 = c[15usize] * difference_121;
            let lambda_front = T::fused(
                -minus_right_side_front,
                c[18usize],
                product_122,
            );
            let product_127 = cos_seat_phi * lambda_B_y;
            let difference_128 = T::fused(-sin_seat_phi, lambda_B_x, product_127);
            let product_129 = c[13usize] * difference_128;
            let lambda_rear = T::fused(right_side_rear, c[19usize], product_129);
            let sum_133 = minus_force_seat_x + lambda_B_x;
            let difference_135 = T::fused(sin_seat_phi, lambda_rear, -sum_133);
            let product_136 = c[5usize] * difference_135;
            let difference_137 = force_seat_y - lambda_B_y;
            let difference_139 = T::fused(-cos_seat_phi, lambda_rear, difference_137);
            let product_140 = c[5usize] * difference_139;
            let product_143 = force_seat_phi * c[20usize];
            let difference_144 = T::fused(-c[12usize], difference_128, product_143);
            let sum_146 = T::fused(c[6usize], lambda_rear, difference_144);
            let sum_148 = T::fused(sin_bar_phi, lambda_front, lambda_B_x);
            let product_150 = sum_148 * c[21usize];
            let difference_152 = T::fused(-cos_bar_phi, lambda_front, lambda_B_y);
            let product_153 = c[21usize] * difference_152;
            let product_155 = difference_121 * c[22usize];
            let sum_158 = T::fused(cos_27, c[23usize], product_155);
            let sum_161 = T::fused(lambda_front, c[24usize], sum_158);
            let value_167 = -sum_161;
            a[0usize] = product_136;
            a[1usize] = product_140;
            a[2usize] = sum_146;
            a[3usize] = product_150;
            a[4usize] = product_153;
            a[5usize] = value_167;
            lambda[0usize] = lambda_B_x;
            lambda[1usize] = lambda_B_y;
            lambda[2usize] = lambda_rear;
            lambda[3usize] = lambda_front;
            ::ezy_core::model::DeficientRows(0)
                .mark(2usize, !T::is_above(c[25usize], c[26usize]))
                .mark(3usize, !T::is_above(c[27usize], c[28usize]))
                .mark(0usize, !T::is_above(difference_109, c[29usize]))
                .mark(1usize, !T::is_above(difference_109, c[29usize]))
        }
        #[inline]
        fn correction(
            &self,
            c: &[T],
            t: T,
            q: &[T],
            residual: &[T],
            delta: &mut [T],
        ) -> ::ezy_core::model::DeficientRows {
            let c = ::ezy_core::kernel::array::<39usize, T>(c);
            let q = ::ezy_core::kernel::array::<6usize, T>(q);
            let residual = ::ezy_core::kernel::array::<4usize, T>(residual);
            let delta = ::ezy_core::kernel::array_mut::<6usize, T>(delta);
            let right_side_rear = residual[2usize];
            let right_side_front = residual[3usize];
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let product_7 = c[8usize] * cos_seat_phi;
            let product_8 = cos_seat_phi * product_7;
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
            let product_12 = c[9usize] * cos_bar_phi;
            let sum_14 = T::fused(cos_bar_phi, product_12, product_8);
            let sum_16 = sum_14 + c[10usize];
            let product_18 = c[8usize] * sin_seat_phi;
            let product_19 = cos_seat_phi * product_18;
            let product_21 = c[9usize] * sin_bar_phi;
            let sum_23 = T::fused(cos_bar_phi, product_21, product_19);
            let difference_25 = c[11usize] - sum_14;
            let residual_0 = residual[0usize];
            let product_28 = right_side_rear * c[13usize];
            let difference_30 = T::fused(-sin_seat_phi, product_28, residual_0);
            let product_32 = right_side_front * c[15usize];
            let difference_34 = T::fused(-sin_bar_phi, product_32, difference_30);
            let residual_1 = residual[1usize];
            let sum_37 = T::fused(cos_seat_phi, product_28, residual_1);
            let sum_39 = T::fused(cos_bar_phi, product_32, sum_37);
            let product_40 = sum_16 * difference_25;
            let difference_42 = T::fused(-sum_23, sum_23, product_40);
            let quotient_43 = T::from_f64(1f64) / difference_42;
            let product_44 = difference_25 * difference_34;
            let difference_46 = T::fused(-sum_23, sum_39, product_44);
            let lambda_B_x = quotient_43 * difference_46;
            let product_49 = sum_16 * sum_39;
            let difference_50 = T::fused(-sum_23, difference_34, product_49);
            let lambda_B_y = quotient_43 * difference_50;
            let product_53 = cos_bar_phi * lambda_B_y;
            let difference_54 = T::fused(-sin_bar_phi, lambda_B_x, product_53);
            let product_55 = c[15usize] * difference_54;
            let lambda_front = T::fused(right_side_front, c[18usize], product_55);
            let product_60 = cos_seat_phi * lambda_B_y;
            let difference_61 = T::fused(-sin_seat_phi, lambda_B_x, product_60);
            let product_62 = c[13usize] * difference_61;
            let lambda_rear = T::fused(right_side_rear, c[19usize], product_62);
            let difference_67 = T::fused(sin_seat_phi, lambda_rear, -lambda_B_x);
            let product_69 = difference_67 * c[5usize];
            let sum_71 = T::fused(cos_seat_phi, lambda_rear, lambda_B_y);
            let product_72 = c[5usize] * sum_71;
            let product_76 = lambda_rear * c[6usize];
            let difference_77 = T::fused(-difference_61, c[12usize], product_76);
            let sum_79 = T::fused(sin_bar_phi, lambda_front, lambda_B_x);
            let product_81 = sum_79 * c[21usize];
            let difference_83 = T::fused(-cos_bar_phi, lambda_front, lambda_B_y);
            let product_84 = c[21usize] * difference_83;
            let product_86 = difference_54 * c[22usize];
            let sum_89 = T::fused(lambda_front, c[24usize], product_86);
            let value_95 = -product_72;
            let value_96 = -sum_89;
            delta[0usize] = product_69;
            delta[1usize] = value_95;
            delta[2usize] = difference_77;
            delta[3usize] = product_81;
            delta[4usize] = product_84;
            delta[5usize] = value_96;
            ::ezy_core::model::DeficientRows(0)
                .mark(2usize, !T::is_above(c[25usize], c[26usize]))
                .mark(3usize, !T::is_above(c[27usize], c[28usize]))
                .mark(0usize, !T::is_above(difference_42, c[29usize]))
                .mark(1usize, !T::is_above(difference_42, c[29usize]))
        }
    }
    #[automatically_derived]
    impl ::ezy_core::model::Scene for DrivenOnTarmac {
        fn info(&self) -> &'static ::ezy_core::model::SceneInfo {
            static INFO: ::ezy_core::model::SceneInfo = DrivenOnTarmac::INFO;
            &INFO
        }
        fn parameter(&self, index: usize) -> f64 {
            match index {
                0usize => self.a,
                1usize => self.b,
                2usize => self.c,
                3usize => self.d,
                4usize => self.m1,
                5usize => self.i1,
                6usize => self.m2,
                7usize => self.i2,
                8usize => self.m0,
                9usize => self.omega,
                10usize => self.k,
                _ => f64::NAN,
            }
        }
        fn set_parameter(&mut self, index: usize, value: f64) {
            match index {
                0usize => self.a = value,
                1usize => self.b = value,
                2usize => self.c = value,
                3usize => self.d = value,
                4usize => self.m1 = value,
                5usize => self.i1 = value,
                6usize => self.m2 = value,
                7usize => self.i2 = value,
                8usize => self.m0 = value,
                9usize => self.omega = value,
                10usize => self.k = value,
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
            let c = ::ezy_core::kernel::array::<39usize, f64>(c);
            let q = ::ezy_core::kernel::array::<6usize, f64>(q);
            let v = ::ezy_core::kernel::array::<6usize, f64>(v);
            let lambda = ::ezy_core::kernel::array::<4usize, f64>(lambda);
            let out = ::ezy_core::kernel::array_mut::<2usize, f64>(out);
            let seat_omega = v[2usize];
            let bar_omega = v[5usize];
            let difference_4 = seat_omega - bar_omega;
            let product_7 = c[4usize] * t;
            let cos_7 = f64::cos(product_7);
            let product_9 = difference_4 * cos_7;
            let product_11 = product_9 * c[3usize];
            let seat_vx = v[0usize];
            let product_13 = seat_vx * seat_vx;
            let seat_vy = v[1usize];
            let product_15 = seat_vy * seat_vy;
            let sum_16 = product_13 + product_15;
            let product_18 = sum_16 * c[0usize];
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = f64::sin_cos(seat_phi);
            let product_21 = seat_vx * sin_seat_phi;
            let product_23 = seat_vy * cos_seat_phi;
            let difference_24 = product_21 - product_23;
            let product_26 = difference_24 * c[37usize];
            let product_28 = seat_omega * c[2usize];
            let difference_29 = product_26 - product_28;
            let product_30 = seat_omega * difference_29;
            let difference_31 = product_30 - product_18;
            out[0usize] = product_11;
            out[1usize] = difference_31;
        }
        fn points(&self, c: &[f64], t: f64, q: &[f64], out: &mut [f64]) {
            let c = ::ezy_core::kernel::array::<39usize, f64>(c);
            let q = ::ezy_core::kernel::array::<6usize, f64>(q);
            let out = ::ezy_core::kernel::array_mut::<6usize, f64>(out);
            let seat_x = q[0usize];
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = f64::sin_cos(seat_phi);
            let product_6 = c[35usize] * cos_seat_phi;
            let difference_7 = seat_x - product_6;
            let seat_y = q[1usize];
            let product_10 = c[35usize] * sin_seat_phi;
            let difference_11 = seat_y - product_10;
            let bar_x = q[3usize];
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = f64::sin_cos(bar_phi);
            let product_16 = c[36usize] * cos_bar_phi;
            let sum_17 = bar_x + product_16;
            let bar_y = q[4usize];
            let product_20 = c[36usize] * sin_bar_phi;
            let sum_21 = bar_y + product_20;
            let product_23 = cos_seat_phi * c[16usize];
            let sum_24 = seat_x + product_23;
            let product_25 = sin_seat_phi * c[16usize];
            let sum_26 = seat_y + product_25;
            out[0usize] = difference_7;
            out[1usize] = difference_11;
            out[2usize] = sum_17;
            out[3usize] = sum_21;
            out[4usize] = sum_24;
            out[5usize] = sum_26;
        }
        fn outputs(&self, c: &[f64], t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
            let c = ::ezy_core::kernel::array::<39usize, f64>(c);
            let q = ::ezy_core::kernel::array::<6usize, f64>(q);
            let v = ::ezy_core::kernel::array::<6usize, f64>(v);
            let out = ::ezy_core::kernel::array_mut::<0usize, f64>(out);
        }
        fn potential_energy(&self, c: &[f64], t: f64, q: &[f64]) -> f64 {
            0f64
        }
        fn start(&self, c: &[f64], start: &mut ::ezy_core::model::Start) {
            let c = ::ezy_core::kernel::array::<39usize, f64>(c);
            start.give_position(0usize, 0f64);
            start.give_position(1usize, 0f64);
            start.give_position(2usize, 0f64);
            start.give_position(5usize, c[38usize]);
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
    impl<T: ::ezy_core::scalar::Scalar> ::ezy_core::model::Series<T> for DrivenOnTarmac {
        fn series_size(&self) -> ::ezy_core::model::SeriesSize {
            ::ezy_core::model::SeriesSize {
                n_coordinates: 6usize,
                n_rows: 4usize,
                n_products: 24usize,
                n_base: 11usize,
                n_kept: 5usize,
            }
        }
        fn begin(
            &self,
            c: &[T],
            t: T,
            store: &mut ::ezy_core::model::SeriesStore<T>,
        ) -> ::ezy_core::model::DeficientRows {
            let c = ::ezy_core::kernel::array::<39usize, T>(c);
            let q = ::ezy_core::kernel::row::<6usize, T>(&store.q, 0);
            let v = ::ezy_core::kernel::row::<6usize, T>(&store.q, 1);
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
            let seat_omega = v[2usize];
            let product_25 = c[16usize] * seat_omega;
            let product_26 = seat_omega * product_25;
            let product_27 = cos_seat_phi * product_26;
            let bar_omega = v[5usize];
            let product_29 = c[17usize] * bar_omega;
            let product_30 = bar_omega * product_29;
            let sum_32 = T::fused(cos_bar_phi, product_30, product_27);
            let product_33 = sin_seat_phi * product_26;
            let sum_35 = T::fused(sin_bar_phi, product_30, product_33);
            let seat_vx = v[0usize];
            let product_37 = cos_seat_phi * seat_vx;
            let seat_vy = v[1usize];
            let sum_40 = T::fused(sin_seat_phi, seat_vy, product_37);
            let product_41 = seat_omega * sum_40;
            let bar_vx = v[3usize];
            let product_43 = cos_bar_phi * bar_vx;
            let bar_vy = v[4usize];
            let sum_46 = T::fused(sin_bar_phi, bar_vy, product_43);
            let product_47 = bar_omega * sum_46;
            let product_49 = seat_vx * c[0usize];
            let product_51 = seat_omega * c[1usize];
            let sum_53 = T::fused(sin_seat_phi, product_51, product_49);
            let product_55 = cos_seat_phi * product_51;
            let difference_56 = T::fused(-seat_vy, c[0usize], product_55);
            let product_58 = cos_seat_phi * seat_vy;
            let difference_59 = T::fused(-sin_seat_phi, seat_vx, product_58);
            let product_60 = c[1usize] * difference_59;
            let difference_63 = T::fused(-seat_omega, c[2usize], product_60);
            let product_67 = c[4usize] * t;
            let (sin_67, cos_67) = T::sin_cos(product_67);
            let product_69 = c[3usize] * cos_67;
            let sum_70 = difference_63 + product_69;
            let product_98 = cos_seat_phi * c[8usize];
            let product_99 = cos_seat_phi * product_98;
            let product_101 = cos_bar_phi * c[9usize];
            let sum_103 = T::fused(cos_bar_phi, product_101, product_99);
            let sum_105 = sum_103 + c[10usize];
            let product_106 = sin_seat_phi * c[8usize];
            let product_107 = cos_seat_phi * product_106;
            let product_108 = sin_bar_phi * c[9usize];
            let sum_110 = T::fused(cos_bar_phi, product_108, product_107);
            let difference_112 = c[11usize] - sum_103;
            let product_141 = sum_105 * difference_112;
            let difference_143 = T::fused(-sum_110, sum_110, product_141);
            let quotient_144 = T::from_f64(1f64) / difference_143;
            let product_201 = cos_seat_phi * seat_omega;
            let product_202 = sin_seat_phi * seat_omega;
            let product_203 = cos_bar_phi * bar_omega;
            let product_204 = sin_bar_phi * bar_omega;
            let product_205 = c[4usize] * sin_67;
            let product_206 = c[3usize] * product_205;
            let product_207 = c[4usize] * cos_67;
            let value_208 = -sum_53;
            let value_209 = -product_69;
            let value_210 = -product_202;
            let value_211 = -product_204;
            let value_212 = -product_206;
            let value_213 = -product_205;
            let target = ::ezy_core::kernel::array_mut::<11usize, T>(&mut store.base);
            target[0usize] = sin_seat_phi;
            target[1usize] = product_51;
            target[2usize] = cos_seat_phi;
            target[3usize] = seat_vy;
            target[4usize] = seat_vx;
            target[5usize] = cos_bar_phi;
            target[6usize] = sin_bar_phi;
            target[7usize] = quotient_144;
            target[8usize] = difference_112;
            target[9usize] = sum_110;
            target[10usize] = sum_105;
            let target = ::ezy_core::kernel::array_mut::<6usize, T>(&mut store.force);
            target[0usize] = value_208;
            target[1usize] = difference_56;
            target[2usize] = sum_70;
            target[3usize] = T::from_f64(0f64);
            target[4usize] = T::from_f64(0f64);
            target[5usize] = value_209;
            let target = ::ezy_core::kernel::row_mut::<
                5usize,
                T,
            >(&mut store.kept, 0usize);
            target[0usize] = sin_seat_phi;
            target[1usize] = cos_seat_phi;
            target[2usize] = product_69;
            target[3usize] = sin_67;
            target[4usize] = cos_67;
            let target = ::ezy_core::kernel::row_mut::<
                5usize,
                T,
            >(&mut store.kept, 1usize);
            target[0usize] = product_201;
            target[1usize] = value_210;
            target[2usize] = value_212;
            target[3usize] = product_207;
            target[4usize] = value_213;
            let target = ::ezy_core::kernel::row_mut::<
                24usize,
                T,
            >(&mut store.left, 1usize);
            target[0usize] = T::from_f64(0f64);
            target[1usize] = product_201;
            target[2usize] = T::from_f64(0f64);
            target[3usize] = value_210;
            target[4usize] = T::from_f64(0f64);
            target[5usize] = T::from_f64(0f64);
            target[6usize] = product_201;
            target[7usize] = value_210;
            target[8usize] = product_203;
            target[9usize] = value_211;
            target[10usize] = product_203;
            target[11usize] = value_211;
            target[12usize] = seat_omega;
            target[13usize] = bar_omega;
            target[14usize] = seat_omega;
            target[15usize] = bar_omega;
            target[16usize] = product_201;
            target[17usize] = value_210;
            target[18usize] = product_203;
            target[19usize] = value_211;
            let target = ::ezy_core::kernel::row_mut::<
                24usize,
                T,
            >(&mut store.right, 1usize);
            target[0usize] = T::from_f64(0f64);
            target[1usize] = T::from_f64(0f64);
            target[2usize] = T::from_f64(0f64);
            target[3usize] = T::from_f64(0f64);
            target[4usize] = T::from_f64(0f64);
            target[5usize] = T::from_f64(0f64);
            target[6usize] = T::from_f64(0f64);
            target[7usize] = T::from_f64(0f64);
            target[8usize] = T::from_f64(0f64);
            target[9usize] = T::from_f64(0f64);
            target[10usize] = T::from_f64(0f64);
            target[11usize] = T::from_f64(0f64);
            target[12usize] = product_201;
            target[13usize] = product_203;
            target[14usize] = value_210;
            target[15usize] = value_211;
            target[16usize] = seat_vx;
            target[17usize] = seat_vy;
            target[18usize] = bar_vx;
            target[19usize] = bar_vy;
            let target = ::ezy_core::kernel::row_mut::<
                24usize,
                T,
            >(&mut store.right, 2usize);
            target[0usize] = product_51;
            target[2usize] = product_51;
            target[4usize] = seat_vy;
            target[5usize] = seat_vx;
            let target = ::ezy_core::kernel::array_mut::<4usize, T>(&mut store.row);
            target[0usize] = sum_32;
            target[1usize] = sum_35;
            target[2usize] = product_41;
            target[3usize] = product_47;
            ::ezy_core::model::DeficientRows(0)
                .mark(2usize, !T::is_above(c[25usize], c[26usize]))
                .mark(3usize, !T::is_above(c[27usize], c[28usize]))
                .mark(0usize, !T::is_above(difference_143, c[29usize]))
                .mark(1usize, !T::is_above(difference_143, c[29usize]))
        }
        #[inline]
        fn right_side(
            &self,
            c: &[T],
            k: usize,
            store: &mut ::ezy_core::model::SeriesStore<T>,
        ) {
            let c = ::ezy_core::kernel::array::<39usize, T>(c);
            let base = ::ezy_core::kernel::array::<11usize, T>(&store.base);
            let kept_0 = ::ezy_core::kernel::row::<5usize, T>(&store.kept, k + 0usize);
            let q_1 = ::ezy_core::kernel::row::<6usize, T>(&store.q, k + 1usize);
            let sums = ::ezy_core::kernel::array::<24usize, T>(&store.sums);
            let order_next = T::from_f64((k + 1usize) as f64);
            let q_0_next = q_1[0usize];
            let product_3 = order_next * q_0_next;
            let convolved_0 = sums[0usize];
            let q_2_next = q_1[2usize];
            let product_8 = order_next * q_2_next;
            let product_9 = c[1usize] * product_8;
            let base_0 = base[0usize];
            let product_11 = product_9 * base_0;
            let kept_0 = kept_0[0usize];
            let base_1 = base[1usize];
            let sum_15 = T::fused(kept_0, base_1, product_11);
            let sum_16 = convolved_0 + sum_15;
            let sum_17 = T::fused(c[0usize], product_3, sum_16);
            let convolved_1 = sums[1usize];
            let difference_21 = convolved_1 - sum_17;
            let convolved_2 = sums[2usize];
            let base_2 = base[2usize];
            let product_24 = product_9 * base_2;
            let kept_1 = kept_0[1usize];
            let sum_27 = T::fused(base_1, kept_1, product_24);
            let sum_28 = convolved_2 + sum_27;
            let q_1_next = q_1[1usize];
            let product_30 = order_next * q_1_next;
            let difference_32 = T::fused(-c[0usize], product_30, sum_28);
            let convolved_3 = sums[3usize];
            let difference_34 = difference_32 - convolved_3;
            let convolved_4 = sums[4usize];
            let product_36 = base_2 * product_30;
            let base_3 = base[3usize];
            let sum_39 = T::fused(kept_1, base_3, product_36);
            let sum_40 = convolved_4 + sum_39;
            let convolved_5 = sums[5usize];
            let product_42 = product_3 * base_0;
            let base_4 = base[4usize];
            let sum_45 = T::fused(kept_0, base_4, product_42);
            let sum_46 = convolved_5 + sum_45;
            let difference_47 = sum_40 - sum_46;
            let product_48 = c[1usize] * difference_47;
            let difference_51 = T::fused(-product_8, c[2usize], product_48);
            let kept_2 = kept_0[2usize];
            let sum_53 = difference_51 + kept_2;
            let convolved_6 = sums[6usize];
            let convolved_7 = sums[7usize];
            let product_58 = c[16usize] * convolved_7;
            let difference_59 = T::fused(-c[16usize], convolved_6, product_58);
            let difference_60 = sum_53 - difference_59;
            let convolved_8 = sums[8usize];
            let convolved_9 = sums[9usize];
            let convolved_10 = sums[10usize];
            let convolved_11 = sums[11usize];
            let product_67 = c[17usize] * convolved_11;
            let difference_68 = T::fused(-c[17usize], convolved_10, product_67);
            let sum_69 = kept_2 + difference_68;
            let convolved_12 = sums[12usize];
            let inverse_order_ahead = T::from_f64(1f64)
                / T::from_f64((k + 2usize) as f64);
            let product_72 = convolved_12 * inverse_order_ahead;
            let product_73 = c[16usize] * product_72;
            let convolved_13 = sums[13usize];
            let product_75 = inverse_order_ahead * convolved_13;
            let sum_77 = T::fused(c[17usize], product_75, product_73);
            let order_ahead = T::from_f64((k + 2usize) as f64);
            let product_79 = order_next * order_ahead;
            let product_80 = sum_77 * product_79;
            let convolved_14 = sums[14usize];
            let product_82 = inverse_order_ahead * convolved_14;
            let product_83 = c[16usize] * product_82;
            let convolved_15 = sums[15usize];
            let product_85 = inverse_order_ahead * convolved_15;
            let sum_87 = T::fused(c[17usize], product_85, product_83);
            let product_88 = product_79 * sum_87;
            let convolved_16 = sums[16usize];
            let convolved_17 = sums[17usize];
            let difference_91 = convolved_16 - convolved_17;
            let product_92 = order_next * difference_91;
            let convolved_18 = sums[18usize];
            let convolved_19 = sums[19usize];
            let difference_95 = convolved_18 - convolved_19;
            let product_96 = order_next * difference_95;
            let value_97 = -convolved_9;
            let value_98 = -sum_69;
            let value_99 = -product_88;
            let target = ::ezy_core::kernel::array_mut::<6usize, T>(&mut store.force);
            target[0usize] = difference_21;
            target[1usize] = difference_34;
            target[2usize] = difference_60;
            target[3usize] = convolved_8;
            target[4usize] = value_97;
            target[5usize] = value_98;
            let target = ::ezy_core::kernel::row_mut::<
                24usize,
                T,
            >(&mut store.left, k + 0usize);
            target[0usize] = kept_0;
            target[2usize] = kept_1;
            target[4usize] = kept_1;
            target[5usize] = kept_0;
            let target = ::ezy_core::kernel::row_mut::<
                24usize,
                T,
            >(&mut store.left, k + 1usize);
            target[0usize] = T::from_f64(0f64);
            target[2usize] = T::from_f64(0f64);
            target[4usize] = T::from_f64(0f64);
            target[5usize] = T::from_f64(0f64);
            let target = ::ezy_core::kernel::row_mut::<
                24usize,
                T,
            >(&mut store.right, k + 2usize);
            target[0usize] = product_9;
            target[2usize] = product_9;
            target[4usize] = product_30;
            target[5usize] = product_3;
            let target = ::ezy_core::kernel::array_mut::<4usize, T>(&mut store.row);
            target[0usize] = product_80;
            target[1usize] = value_99;
            target[2usize] = product_92;
            target[3usize] = product_96;
        }
        #[inline]
        fn solve(
            &self,
            c: &[T],
            k: usize,
            store: &mut ::ezy_core::model::SeriesStore<T>,
        ) {
            let c = ::ezy_core::kernel::array::<39usize, T>(c);
            let base = ::ezy_core::kernel::array::<11usize, T>(&store.base);
            let force = ::ezy_core::kernel::array::<6usize, T>(&store.force);
            let row = ::ezy_core::kernel::array::<4usize, T>(&store.row);
            let force_0 = force[0usize];
            let base_7 = base[7usize];
            let base_8 = base[8usize];
            let base_0 = base[0usize];
            let force_2 = force[2usize];
            let product_8 = force_2 * c[12usize];
            let base_2 = base[2usize];
            let force_1 = force[1usize];
            let product_11 = base_2 * force_1;
            let difference_13 = T::fused(-force_0, base_0, product_11);
            let product_14 = c[5usize] * difference_13;
            let difference_17 = T::fused(-force_2, c[6usize], product_14);
            let row_2 = row[2usize];
            let right_side_rear = difference_17 - row_2;
            let sum_22 = T::fused(right_side_rear, c[13usize], product_8);
            let product_23 = base_0 * sum_22;
            let base_6 = base[6usize];
            let force_5 = force[5usize];
            let product_27 = force_5 * c[22usize];
            let base_5 = base[5usize];
            let force_4 = force[4usize];
            let product_30 = base_5 * force_4;
            let force_3 = force[3usize];
            let difference_33 = T::fused(-base_6, force_3, product_30);
            let product_35 = difference_33 * c[21usize];
            let sum_38 = T::fused(force_5, c[24usize], product_35);
            let row_3 = row[3usize];
            let right_side_front = sum_38 - row_3;
            let sum_43 = T::fused(right_side_front, c[15usize], product_27);
            let sum_45 = T::fused(base_6, sum_43, product_23);
            let difference_46 = T::fused(c[5usize], force_0, -sum_45);
            let difference_48 = T::fused(-force_3, c[21usize], difference_46);
            let row_0 = row[0usize];
            let difference_50 = difference_48 - row_0;
            let product_51 = base_8 * difference_50;
            let base_9 = base[9usize];
            let product_53 = base_2 * sum_22;
            let sum_55 = T::fused(base_5, sum_43, product_53);
            let sum_57 = T::fused(c[5usize], force_1, sum_55);
            let difference_59 = T::fused(-force_4, c[21usize], sum_57);
            let row_1 = row[1usize];
            let difference_61 = difference_59 - row_1;
            let difference_63 = T::fused(-base_9, difference_61, product_51);
            let lambda_B_x = base_7 * difference_63;
            let difference_65 = force_0 - lambda_B_x;
            let base_10 = base[10usize];
            let product_67 = difference_61 * base_10;
            let difference_69 = T::fused(-difference_50, base_9, product_67);
            let lambda_B_y = base_7 * difference_69;
            let product_71 = base_2 * lambda_B_y;
            let difference_73 = T::fused(-base_0, lambda_B_x, product_71);
            let product_74 = c[13usize] * difference_73;
            let lambda_rear = T::fused(right_side_rear, c[19usize], product_74);
            let sum_79 = T::fused(base_0, lambda_rear, difference_65);
            let product_80 = c[5usize] * sum_79;
            let difference_81 = force_1 - lambda_B_y;
            let difference_83 = T::fused(-base_2, lambda_rear, difference_81);
            let product_84 = c[5usize] * difference_83;
            let product_86 = force_2 * c[20usize];
            let difference_88 = T::fused(-c[12usize], difference_73, product_86);
            let sum_90 = T::fused(c[6usize], lambda_rear, difference_88);
            let sum_91 = force_3 + lambda_B_x;
            let product_92 = base_5 * lambda_B_y;
            let difference_94 = T::fused(-base_6, lambda_B_x, product_92);
            let product_95 = c[15usize] * difference_94;
            let lambda_front = T::fused(right_side_front, c[18usize], product_95);
            let sum_100 = T::fused(base_6, lambda_front, sum_91);
            let product_101 = c[21usize] * sum_100;
            let sum_102 = force_4 + lambda_B_y;
            let difference_104 = T::fused(-base_5, lambda_front, sum_102);
            let product_105 = c[21usize] * difference_104;
            let product_107 = force_5 * c[30usize];
            let difference_109 = T::fused(-c[22usize], difference_94, product_107);
            let difference_111 = T::fused(-c[24usize], lambda_front, difference_109);
            let target = ::ezy_core::kernel::array_mut::<6usize, T>(&mut store.a);
            target[0usize] = product_80;
            target[1usize] = product_84;
            target[2usize] = sum_90;
            target[3usize] = product_101;
            target[4usize] = product_105;
            target[5usize] = difference_111;
            let target = ::ezy_core::kernel::row_mut::<
                4usize,
                T,
            >(&mut store.lambda, k + 0usize);
            target[0usize] = lambda_B_x;
            target[1usize] = lambda_B_y;
            target[2usize] = lambda_rear;
            target[3usize] = lambda_front;
        }
        #[inline]
        fn finish(
            &self,
            c: &[T],
            k: usize,
            store: &mut ::ezy_core::model::SeriesStore<T>,
        ) {
            let c = ::ezy_core::kernel::array::<39usize, T>(c);
            let a = ::ezy_core::kernel::array::<6usize, T>(&store.a);
            let base = ::ezy_core::kernel::array::<11usize, T>(&store.base);
            let kept_1 = ::ezy_core::kernel::row::<5usize, T>(&store.kept, k + 1usize);
            let lambda_0 = ::ezy_core::kernel::row::<
                4usize,
                T,
            >(&store.lambda, k + 0usize);
            let sums = ::ezy_core::kernel::array::<24usize, T>(&store.sums);
            let a_0 = a[0usize];
            let inverse_order_next = T::from_f64(1f64)
                / T::from_f64((k + 1usize) as f64);
            let inverse_order_ahead = T::from_f64(1f64)
                / T::from_f64((k + 2usize) as f64);
            let product_3 = inverse_order_next * inverse_order_ahead;
            let product_4 = a_0 * product_3;
            let a_1 = a[1usize];
            let product_6 = product_3 * a_1;
            let a_2 = a[2usize];
            let product_8 = product_3 * a_2;
            let a_3 = a[3usize];
            let product_10 = product_3 * a_3;
            let a_4 = a[4usize];
            let product_12 = product_3 * a_4;
            let a_5 = a[5usize];
            let product_14 = product_3 * a_5;
            let lambda_2 = lambda_0[2usize];
            let convolved_14 = sums[14usize];
            let product_19 = inverse_order_ahead * convolved_14;
            let base_2 = base[2usize];
            let sum_22 = T::fused(product_8, base_2, product_19);
            let convolved_12 = sums[12usize];
            let product_24 = inverse_order_ahead * convolved_12;
            let base_0 = base[0usize];
            let sum_27 = T::fused(product_8, base_0, product_24);
            let lambda_0 = lambda_0[0usize];
            let lambda_1 = lambda_0[1usize];
            let lambda_3 = lambda_0[3usize];
            let convolved_15 = sums[15usize];
            let product_32 = inverse_order_ahead * convolved_15;
            let base_5 = base[5usize];
            let sum_35 = T::fused(product_14, base_5, product_32);
            let convolved_13 = sums[13usize];
            let product_37 = inverse_order_ahead * convolved_13;
            let base_6 = base[6usize];
            let sum_40 = T::fused(product_14, base_6, product_37);
            let order_ahead = T::from_f64((k + 2usize) as f64);
            let product_42 = product_8 * order_ahead;
            let product_43 = product_14 * order_ahead;
            let product_44 = product_4 * order_ahead;
            let product_45 = product_6 * order_ahead;
            let product_46 = product_10 * order_ahead;
            let product_47 = product_12 * order_ahead;
            let kept_3_next = kept_1[3usize];
            let product_51 = inverse_order_ahead * c[4usize];
            let product_52 = kept_3_next * product_51;
            let product_53 = c[3usize] * product_52;
            let kept_4_next = kept_1[4usize];
            let product_55 = product_51 * kept_4_next;
            let value_56 = -sum_27;
            let value_57 = -sum_40;
            let value_58 = -product_53;
            let value_59 = -product_52;
            let target = ::ezy_core::kernel::row_mut::<
                5usize,
                T,
            >(&mut store.kept, k + 2usize);
            target[0usize] = sum_22;
            target[1usize] = value_56;
            target[2usize] = value_58;
            target[3usize] = product_55;
            target[4usize] = value_59;
            let target = ::ezy_core::kernel::row_mut::<
                24usize,
                T,
            >(&mut store.left, k + 2usize);
            target[1usize] = sum_22;
            target[3usize] = value_56;
            target[6usize] = sum_22;
            target[7usize] = value_56;
            target[8usize] = sum_35;
            target[9usize] = value_57;
            target[10usize] = sum_35;
            target[11usize] = value_57;
            target[12usize] = product_42;
            target[13usize] = product_43;
            target[14usize] = product_42;
            target[15usize] = product_43;
            target[16usize] = sum_22;
            target[17usize] = value_56;
            target[18usize] = sum_35;
            target[19usize] = value_57;
            let target = ::ezy_core::kernel::row_mut::<
                6usize,
                T,
            >(&mut store.q, k + 2usize);
            target[0usize] = product_4;
            target[1usize] = product_6;
            target[2usize] = product_8;
            target[3usize] = product_10;
            target[4usize] = product_12;
            target[5usize] = product_14;
            let target = ::ezy_core::kernel::row_mut::<
                24usize,
                T,
            >(&mut store.right, k + 2usize);
            target[1usize] = lambda_2;
            target[3usize] = lambda_2;
            target[6usize] = lambda_0;
            target[7usize] = lambda_1;
            target[8usize] = lambda_3;
            target[9usize] = lambda_3;
            target[10usize] = lambda_0;
            target[11usize] = lambda_1;
            target[12usize] = sum_22;
            target[13usize] = sum_35;
            target[14usize] = value_56;
            target[15usize] = value_57;
            target[16usize] = product_44;
            target[17usize] = product_45;
            target[18usize] = product_46;
            target[19usize] = product_47;
        }
    }
    ///Driven, with a rear wheel that slips and rolls with resistance.
    ///
    ///Cost of the accelerations and multipliers: 71 mul, 41 add, 1 div, 3 sin–cos.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct Drift {
        ///rear wheel A, behind the seat's centre of mass (m); default `0.2`.
        pub a: f64,
        ///hinge B, ahead of the seat's centre of mass (m); default `0.6`.
        pub b: f64,
        ///front wheel C, beyond the bar's centre of mass (m); default `0.1`.
        pub c: f64,
        ///bar's centre of mass, beyond the hinge (m); default `0.1`.
        pub d: f64,
        ///mass of seat and rider (kg); default `46.0`.
        pub m1: f64,
        ///moment of inertia of seat and rider (kg*m^2); default `10.0`.
        pub i1: f64,
        ///mass of the bar (kg); default `1.0`.
        pub m2: f64,
        ///moment of inertia of the bar (kg*m^2); default `0.005`.
        pub i2: f64,
        ///largest torque (N*m); default `2.0`.
        pub m0: f64,
        ///angular frequency of the torque (rad/s); default `pi`.
        pub omega: f64,
        ///drag per speed (N*s/m); default `0.5`.
        pub k: f64,
        ///side force per slip angle (N/rad); default `400.0`.
        pub cornering: f64,
        ///speed below which the wheel creeps (m/s); default `0.1`.
        pub creep: f64,
    }
    impl ::core::default::Default for Drift {
        fn default() -> Self {
            Self {
                a: 0.2f64,
                b: 0.6f64,
                c: 0.1f64,
                d: 0.1f64,
                m1: 46f64,
                i1: 10f64,
                m2: 1f64,
                i2: 0.005f64,
                m0: 2f64,
                omega: 3.141592653589793f64,
                k: 0.5f64,
                cornering: 400f64,
                creep: 0.1f64,
            }
        }
    }
    impl Drift {
        /// What is known of the scene when it is compiled.
        pub const INFO: ::ezy_core::model::SceneInfo = ::ezy_core::model::SceneInfo {
            model: "EzyRoller",
            name: "drift",
            documentation: "Driven, with a rear wheel that slips and rolls with resistance.",
            bodies: &["seat", "bar"],
            coordinates: &[
                ::ezy_core::model::CoordinateInfo {
                    name: "seat.x",
                    velocity_name: "seat.vx",
                    unit: "m",
                    symbol: ::ezy_core::model::Formula {
                        text: "seat.x",
                        latex: "x_{\\mathrm{seat}}",
                        mathml: "<msub><mi>x</mi><mtext>seat</mtext></msub>",
                    },
                    velocity_symbol: ::ezy_core::model::Formula {
                        text: "seat.vx",
                        latex: "\\dot{x}_{\\mathrm{seat}}",
                        mathml: "<msub><mover><mi>x</mi><mo>.</mo></mover><mtext>seat</mtext></msub>",
                    },
                },
                ::ezy_core::model::CoordinateInfo {
                    name: "seat.y",
                    velocity_name: "seat.vy",
                    unit: "m",
                    symbol: ::ezy_core::model::Formula {
                        text: "seat.y",
                        latex: "y_{\\mathrm{seat}}",
                        mathml: "<msub><mi>y</mi><mtext>seat</mtext></msub>",
                    },
                    velocity_symbol: ::ezy_core::model::Formula {
                        text: "seat.vy",
                        latex: "\\dot{y}_{\\mathrm{seat}}",
                        mathml: "<msub><mover><mi>y</mi><mo>.</mo></mover><mtext>seat</mtext></msub>",
                    },
                },
                ::ezy_core::model::CoordinateInfo {
                    name: "seat.phi",
                    velocity_name: "seat.omega",
                    unit: "rad",
                    symbol: ::ezy_core::model::Formula {
                        text: "seat.phi",
                        latex: "\\varphi_{\\mathrm{seat}}",
                        mathml: "<msub><mi>φ</mi><mtext>seat</mtext></msub>",
                    },
                    velocity_symbol: ::ezy_core::model::Formula {
                        text: "seat.omega",
                        latex: "\\dot{\\varphi}_{\\mathrm{seat}}",
                        mathml: "<msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext></msub>",
                    },
                },
                ::ezy_core::model::CoordinateInfo {
                    name: "bar.x",
                    velocity_name: "bar.vx",
                    unit: "m",
                    symbol: ::ezy_core::model::Formula {
                        text: "bar.x",
                        latex: "x_{\\mathrm{bar}}",
                        mathml: "<msub><mi>x</mi><mtext>bar</mtext></msub>",
                    },
                    velocity_symbol: ::ezy_core::model::Formula {
                        text: "bar.vx",
                        latex: "\\dot{x}_{\\mathrm{bar}}",
                        mathml: "<msub><mover><mi>x</mi><mo>.</mo></mover><mtext>bar</mtext></msub>",
                    },
                },
                ::ezy_core::model::CoordinateInfo {
                    name: "bar.y",
                    velocity_name: "bar.vy",
                    unit: "m",
                    symbol: ::ezy_core::model::Formula {
                        text: "bar.y",
                        latex: "y_{\\mathrm{bar}}",
                        mathml: "<msub><mi>y</mi><mtext>bar</mtext></msub>",
                    },
                    velocity_symbol: ::ezy_core::model::Formula {
                        text: "bar.vy",
                        latex: "\\dot{y}_{\\mathrm{bar}}",
                        mathml: "<msub><mover><mi>y</mi><mo>.</mo></mover><mtext>bar</mtext></msub>",
                    },
                },
                ::ezy_core::model::CoordinateInfo {
                    name: "bar.phi",
                    velocity_name: "bar.omega",
                    unit: "rad",
                    symbol: ::ezy_core::model::Formula {
                        text: "bar.phi",
                        latex: "\\varphi_{\\mathrm{bar}}",
                        mathml: "<msub><mi>φ</mi><mtext>bar</mtext></msub>",
                    },
                    velocity_symbol: ::ezy_core::model::Formula {
                        text: "bar.omega",
                        latex: "\\dot{\\varphi}_{\\mathrm{bar}}",
                        mathml: "<msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext></msub>",
                    },
                },
            ],
            points: &[
                ::ezy_core::model::PointInfo {
                    name: "A",
                    body: ::core::option::Option::Some(0usize),
                    position: ::core::option::Option::Some([
                        ::ezy_core::model::Formula {
                            text: "seat.x - a*cos(seat.phi)",
                            latex: "x_{\\mathrm{seat}} - a \\, \\cos{\\varphi_{\\mathrm{seat}}}",
                            mathml: "<mrow><msub><mi>x</mi><mtext>seat</mtext></msub><mo>−</mo><mi>a</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                        },
                        ::ezy_core::model::Formula {
                            text: "seat.y - a*sin(seat.phi)",
                            latex: "y_{\\mathrm{seat}} - a \\, \\sin{\\varphi_{\\mathrm{seat}}}",
                            mathml: "<mrow><msub><mi>y</mi><mtext>seat</mtext></msub><mo>−</mo><mi>a</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                        },
                    ]),
                },
                ::ezy_core::model::PointInfo {
                    name: "C",
                    body: ::core::option::Option::Some(1usize),
                    position: ::core::option::Option::Some([
                        ::ezy_core::model::Formula {
                            text: "bar.x + c*cos(bar.phi)",
                            latex: "x_{\\mathrm{bar}} + c \\, \\cos{\\varphi_{\\mathrm{bar}}}",
                            mathml: "<mrow><msub><mi>x</mi><mtext>bar</mtext></msub><mo>+</mo><mi>c</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                        },
                        ::ezy_core::model::Formula {
                            text: "bar.y + c*sin(bar.phi)",
                            latex: "y_{\\mathrm{bar}} + c \\, \\sin{\\varphi_{\\mathrm{bar}}}",
                            mathml: "<mrow><msub><mi>y</mi><mtext>bar</mtext></msub><mo>+</mo><mi>c</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                        },
                    ]),
                },
                ::ezy_core::model::PointInfo {
                    name: "B",
                    body: ::core::option::Option::Some(0usize),
                    position: ::core::option::Option::Some([
                        ::ezy_core::model::Formula {
                            text: "seat.x + b*cos(seat.phi)",
                            latex: "x_{\\mathrm{seat}} + b \\, \\cos{\\varphi_{\\mathrm{seat}}}",
                            mathml: "<mrow><msub><mi>x</mi><mtext>seat</mtext></msub><mo>+</mo><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                        },
                        ::ezy_core::model::Formula {
                            text: "seat.y + b*sin(seat.phi)",
                            latex: "y_{\\mathrm{seat}} + b \\, \\sin{\\varphi_{\\mathrm{seat}}}",
                            mathml: "<mrow><msub><mi>y</mi><mtext>seat</mtext></msub><mo>+</mo><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                        },
                    ]),
                },
            ],
            rows: &[
                ::ezy_core::model::RowInfo {
                    name: "B.x",
                    kind: "hinge",
                    multiplier_unit: "N",
                    constraint: ::ezy_core::model::Formula {
                        text: "seat.x + b*cos(seat.phi) - bar.x + d*cos(bar.phi)",
                        latex: "x_{\\mathrm{seat}} + b \\, \\cos{\\varphi_{\\mathrm{seat}}} - x_{\\mathrm{bar}} + d \\, \\cos{\\varphi_{\\mathrm{bar}}}",
                        mathml: "<mrow><msub><mi>x</mi><mtext>seat</mtext></msub><mo>+</mo><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>−</mo><msub><mi>x</mi><mtext>bar</mtext></msub><mo>+</mo><mi>d</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                    },
                    convective_term: ::ezy_core::model::Formula {
                        text: "-b*seat.omega^2*cos(seat.phi) - d*bar.omega^2*cos(bar.phi)",
                        latex: "-b \\, \\dot{\\varphi}_{\\mathrm{seat}}^{2} \\, \\cos{\\varphi_{\\mathrm{seat}}} - d \\, \\dot{\\varphi}_{\\mathrm{bar}}^{2} \\, \\cos{\\varphi_{\\mathrm{bar}}}",
                        mathml: "<mrow><mo>−</mo><mi>b</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>−</mo><mi>d</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                    },
                },
                ::ezy_core::model::RowInfo {
                    name: "B.y",
                    kind: "hinge",
                    multiplier_unit: "N",
                    constraint: ::ezy_core::model::Formula {
                        text: "seat.y + b*sin(seat.phi) - bar.y + d*sin(bar.phi)",
                        latex: "y_{\\mathrm{seat}} + b \\, \\sin{\\varphi_{\\mathrm{seat}}} - y_{\\mathrm{bar}} + d \\, \\sin{\\varphi_{\\mathrm{bar}}}",
                        mathml: "<mrow><msub><mi>y</mi><mtext>seat</mtext></msub><mo>+</mo><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>−</mo><msub><mi>y</mi><mtext>bar</mtext></msub><mo>+</mo><mi>d</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                    },
                    convective_term: ::ezy_core::model::Formula {
                        text: "-b*seat.omega^2*sin(seat.phi) - d*bar.omega^2*sin(bar.phi)",
                        latex: "-b \\, \\dot{\\varphi}_{\\mathrm{seat}}^{2} \\, \\sin{\\varphi_{\\mathrm{seat}}} - d \\, \\dot{\\varphi}_{\\mathrm{bar}}^{2} \\, \\sin{\\varphi_{\\mathrm{bar}}}",
                        mathml: "<mrow><mo>−</mo><mi>b</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>−</mo><mi>d</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                    },
                },
                ::ezy_core::model::RowInfo {
                    name: "front",
                    kind: "skate",
                    multiplier_unit: "N",
                    constraint: ::ezy_core::model::Formula {
                        text: "c*bar.omega - bar.vx*sin(bar.phi) + bar.vy*cos(bar.phi)",
                        latex: "c \\, \\dot{\\varphi}_{\\mathrm{bar}} - \\dot{x}_{\\mathrm{bar}} \\, \\sin{\\varphi_{\\mathrm{bar}}} + \\dot{y}_{\\mathrm{bar}} \\, \\cos{\\varphi_{\\mathrm{bar}}}",
                        mathml: "<mrow><mi>c</mi><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mo>−</mo><msub><mover><mi>x</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow><mo>+</mo><msub><mover><mi>y</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                    },
                    convective_term: ::ezy_core::model::Formula {
                        text: "-bar.vx*bar.omega*cos(bar.phi) - bar.vy*bar.omega*sin(bar.phi)",
                        latex: "-\\dot{x}_{\\mathrm{bar}} \\, \\dot{\\varphi}_{\\mathrm{bar}} \\, \\cos{\\varphi_{\\mathrm{bar}}} - \\dot{y}_{\\mathrm{bar}} \\, \\dot{\\varphi}_{\\mathrm{bar}} \\, \\sin{\\varphi_{\\mathrm{bar}}}",
                        mathml: "<mrow><mo>−</mo><msub><mover><mi>x</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow><mo>−</mo><msub><mover><mi>y</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                    },
                },
            ],
            n_position_rows: 2usize,
            parameters: &[
                ::ezy_core::model::ParameterInfo {
                    name: "a",
                    unit: "m",
                    default: 0.2f64,
                    default_text: "0.2",
                    documentation: "rear wheel A, behind the seat's centre of mass",
                    effect: ::core::option::Option::None,
                    symbol: ::ezy_core::model::Formula {
                        text: "a",
                        latex: "a",
                        mathml: "<mi>a</mi>",
                    },
                },
                ::ezy_core::model::ParameterInfo {
                    name: "b",
                    unit: "m",
                    default: 0.6f64,
                    default_text: "0.6",
                    documentation: "hinge B, ahead of the seat's centre of mass",
                    effect: ::core::option::Option::None,
                    symbol: ::ezy_core::model::Formula {
                        text: "b",
                        latex: "b",
                        mathml: "<mi>b</mi>",
                    },
                },
                ::ezy_core::model::ParameterInfo {
                    name: "c",
                    unit: "m",
                    default: 0.1f64,
                    default_text: "0.1",
                    documentation: "front wheel C, beyond the bar's centre of mass",
                    effect: ::core::option::Option::None,
                    symbol: ::ezy_core::model::Formula {
                        text: "c",
                        latex: "c",
                        mathml: "<mi>c</mi>",
                    },
                },
                ::ezy_core::model::ParameterInfo {
                    name: "d",
                    unit: "m",
                    default: 0.1f64,
                    default_text: "0.1",
                    documentation: "bar's centre of mass, beyond the hinge",
                    effect: ::core::option::Option::None,
                    symbol: ::ezy_core::model::Formula {
                        text: "d",
                        latex: "d",
                        mathml: "<mi>d</mi>",
                    },
                },
                ::ezy_core::model::ParameterInfo {
                    name: "m1",
                    unit: "kg",
                    default: 46f64,
                    default_text: "46.0",
                    documentation: "mass of seat and rider",
                    effect: ::core::option::Option::None,
                    symbol: ::ezy_core::model::Formula {
                        text: "m1",
                        latex: "m_{1}",
                        mathml: "<msub><mi>m</mi><mtext>1</mtext></msub>",
                    },
                },
                ::ezy_core::model::ParameterInfo {
                    name: "i1",
                    unit: "kg*m^2",
                    default: 10f64,
                    default_text: "10.0",
                    documentation: "moment of inertia of seat and rider",
                    effect: ::core::option::Option::None,
                    symbol: ::ezy_core::model::Formula {
                        text: "i1",
                        latex: "i_{1}",
                        mathml: "<msub><mi>i</mi><mtext>1</mtext></msub>",
                    },
                },
                ::ezy_core::model::ParameterInfo {
                    name: "m2",
                    unit: "kg",
                    default: 1f64,
                    default_text: "1.0",
                    documentation: "mass of the bar",
                    effect: ::core::option::Option::None,
                    symbol: ::ezy_core::model::Formula {
                        text: "m2",
                        latex: "m_{2}",
                        mathml: "<msub><mi>m</mi><mtext>2</mtext></msub>",
                    },
                },
                ::ezy_core::model::ParameterInfo {
                    name: "i2",
                    unit: "kg*m^2",
                    default: 0.005f64,
                    default_text: "0.005",
                    documentation: "moment of inertia of the bar",
                    effect: ::core::option::Option::None,
                    symbol: ::ezy_core::model::Formula {
                        text: "i2",
                        latex: "i_{2}",
                        mathml: "<msub><mi>i</mi><mtext>2</mtext></msub>",
                    },
                },
                ::ezy_core::model::ParameterInfo {
                    name: "m0",
                    unit: "N*m",
                    default: 2f64,
                    default_text: "2.0",
                    documentation: "largest torque",
                    effect: ::core::option::Option::Some("pump"),
                    symbol: ::ezy_core::model::Formula {
                        text: "m0",
                        latex: "m_{0}",
                        mathml: "<msub><mi>m</mi><mtext>0</mtext></msub>",
                    },
                },
                ::ezy_core::model::ParameterInfo {
                    name: "omega",
                    unit: "rad/s",
                    default: 3.141592653589793f64,
                    default_text: "pi",
                    documentation: "angular frequency of the torque",
                    effect: ::core::option::Option::Some("pump"),
                    symbol: ::ezy_core::model::Formula {
                        text: "omega",
                        latex: "\\omega",
                        mathml: "<mi>ω</mi>",
                    },
                },
                ::ezy_core::model::ParameterInfo {
                    name: "k",
                    unit: "N*s/m",
                    default: 0.5f64,
                    default_text: "0.5",
                    documentation: "drag per speed",
                    effect: ::core::option::Option::Some("rolling_resistance"),
                    symbol: ::ezy_core::model::Formula {
                        text: "k",
                        latex: "k",
                        mathml: "<mi>k</mi>",
                    },
                },
                ::ezy_core::model::ParameterInfo {
                    name: "cornering",
                    unit: "N/rad",
                    default: 400f64,
                    default_text: "400.0",
                    documentation: "side force per slip angle",
                    effect: ::core::option::Option::Some("slip"),
                    symbol: ::ezy_core::model::Formula {
                        text: "cornering",
                        latex: "\\mathrm{cornering}",
                        mathml: "<mi>cornering</mi>",
                    },
                },
                ::ezy_core::model::ParameterInfo {
                    name: "creep",
                    unit: "m/s",
                    default: 0.1f64,
                    default_text: "0.1",
                    documentation: "speed below which the wheel creeps",
                    effect: ::core::option::Option::Some("slip"),
                    symbol: ::ezy_core::model::Formula {
                        text: "creep",
                        latex: "\\mathrm{creep}",
                        mathml: "<mi>creep</mi>",
                    },
                },
            ],
            inputs: &[],
            outputs: &[],
            effects: &[
                ::ezy_core::model::EffectInfo {
                    name: "pump",
                    documentation: "The rider swings the bar: a torque between seat and bar.",
                },
                ::ezy_core::model::EffectInfo {
                    name: "rolling_resistance",
                    documentation: "Drag of the rear wheel, proportional to its speed.",
                },
                ::ezy_core::model::EffectInfo {
                    name: "slip",
                    documentation: "The rear wheel lets go: a side force against its slip replaces the skate.",
                },
            ],
            until_s: 60f64,
            n_constants: 37usize,
            jacobian: ::ezy_core::model::SparsityPattern {
                starts: &[0usize, 4usize, 8usize, 11usize],
                columns: &[
                    0usize, 2usize, 3usize, 5usize, 1usize, 2usize, 4usize, 5usize,
                    3usize, 4usize, 5usize,
                ],
            },
            jacobian_entries: &[
                ::ezy_core::model::Formula {
                    text: "1",
                    latex: "1",
                    mathml: "<mrow><mn>1</mn></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "-b*sin(seat.phi)",
                    latex: "-b \\, \\sin{\\varphi_{\\mathrm{seat}}}",
                    mathml: "<mrow><mo>−</mo><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "-1",
                    latex: "-1",
                    mathml: "<mrow><mo>−</mo><mn>1</mn></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "-d*sin(bar.phi)",
                    latex: "-d \\, \\sin{\\varphi_{\\mathrm{bar}}}",
                    mathml: "<mrow><mo>−</mo><mi>d</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "1",
                    latex: "1",
                    mathml: "<mrow><mn>1</mn></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "b*cos(seat.phi)",
                    latex: "b \\, \\cos{\\varphi_{\\mathrm{seat}}}",
                    mathml: "<mrow><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "-1",
                    latex: "-1",
                    mathml: "<mrow><mo>−</mo><mn>1</mn></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "d*cos(bar.phi)",
                    latex: "d \\, \\cos{\\varphi_{\\mathrm{bar}}}",
                    mathml: "<mrow><mi>d</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "-sin(bar.phi)",
                    latex: "-\\sin{\\varphi_{\\mathrm{bar}}}",
                    mathml: "<mrow><mo>−</mo><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "cos(bar.phi)",
                    latex: "\\cos{\\varphi_{\\mathrm{bar}}}",
                    mathml: "<mrow><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "c",
                    latex: "c",
                    mathml: "<mrow><mi>c</mi></mrow>",
                },
            ],
            mass_entries: &[
                ::ezy_core::model::Formula {
                    text: "m1",
                    latex: "m_{1}",
                    mathml: "<mrow><msub><mi>m</mi><mtext>1</mtext></msub></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "m1",
                    latex: "m_{1}",
                    mathml: "<mrow><msub><mi>m</mi><mtext>1</mtext></msub></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "i1",
                    latex: "i_{1}",
                    mathml: "<mrow><msub><mi>i</mi><mtext>1</mtext></msub></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "m2",
                    latex: "m_{2}",
                    mathml: "<mrow><msub><mi>m</mi><mtext>2</mtext></msub></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "m2",
                    latex: "m_{2}",
                    mathml: "<mrow><msub><mi>m</mi><mtext>2</mtext></msub></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "i2",
                    latex: "i_{2}",
                    mathml: "<mrow><msub><mi>i</mi><mtext>2</mtext></msub></mrow>",
                },
            ],
            force_entries: &[
                ::ezy_core::model::Formula {
                    text: "-k*seat.vx - k*a*seat.omega*sin(seat.phi) + cornering*sin(seat.phi)*atan2(u1, sqrt(creep^2 + u2^2))",
                    latex: "-k \\, \\dot{x}_{\\mathrm{seat}} - k \\, a \\, \\dot{\\varphi}_{\\mathrm{seat}} \\, \\sin{\\varphi_{\\mathrm{seat}}} + \\mathrm{cornering} \\, \\sin{\\varphi_{\\mathrm{seat}}} \\, \\operatorname{atan2}\\left(u_{1}, \\sqrt{\\mathrm{creep}^{2} + u_{2}^{2}}\\right)",
                    mathml: "<mrow><mo>−</mo><mi>k</mi><mspace width=\"0.17em\"/><msub><mover><mi>x</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mo>−</mo><mi>k</mi><mspace width=\"0.17em\"/><mi>a</mi><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>+</mo><mi>cornering</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mspace width=\"0.17em\"/><mrow><mi>atan2</mi><mo>&#x2061;</mo><mrow><mo>(</mo><msub><mi>u</mi><mtext>1</mtext></msub><mo>,</mo><msqrt><mrow><msup><mrow><mi>creep</mi></mrow><mn>2</mn></msup><mo>+</mo><msubsup><mi>u</mi><mtext>2</mtext><mn>2</mn></msubsup></mrow></msqrt><mo>)</mo></mrow></mrow></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "-k*seat.vy + k*a*seat.omega*cos(seat.phi) - cornering*cos(seat.phi)*atan2(u1, sqrt(creep^2 + u2^2))",
                    latex: "-k \\, \\dot{y}_{\\mathrm{seat}} + k \\, a \\, \\dot{\\varphi}_{\\mathrm{seat}} \\, \\cos{\\varphi_{\\mathrm{seat}}} - \\mathrm{cornering} \\, \\cos{\\varphi_{\\mathrm{seat}}} \\, \\operatorname{atan2}\\left(u_{1}, \\sqrt{\\mathrm{creep}^{2} + u_{2}^{2}}\\right)",
                    mathml: "<mrow><mo>−</mo><mi>k</mi><mspace width=\"0.17em\"/><msub><mover><mi>y</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mo>+</mo><mi>k</mi><mspace width=\"0.17em\"/><mi>a</mi><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>−</mo><mi>cornering</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mspace width=\"0.17em\"/><mrow><mi>atan2</mi><mo>&#x2061;</mo><mrow><mo>(</mo><msub><mi>u</mi><mtext>1</mtext></msub><mo>,</mo><msqrt><mrow><msup><mrow><mi>creep</mi></mrow><mn>2</mn></msup><mo>+</mo><msubsup><mi>u</mi><mtext>2</mtext><mn>2</mn></msubsup></mrow></msqrt><mo>)</mo></mrow></mrow></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "-k*a^2*seat.omega + m0*cos(omega*t) - k*a*seat.vx*sin(seat.phi) + k*a*seat.vy*cos(seat.phi) + cornering*a*atan2(u1, sqrt(creep^2 + u2^2))",
                    latex: "-k \\, a^{2} \\, \\dot{\\varphi}_{\\mathrm{seat}} + m_{0} \\, \\cos\\left(\\omega \\, t\\right) - k \\, a \\, \\dot{x}_{\\mathrm{seat}} \\, \\sin{\\varphi_{\\mathrm{seat}}} + k \\, a \\, \\dot{y}_{\\mathrm{seat}} \\, \\cos{\\varphi_{\\mathrm{seat}}} + \\mathrm{cornering} \\, a \\, \\operatorname{atan2}\\left(u_{1}, \\sqrt{\\mathrm{creep}^{2} + u_{2}^{2}}\\right)",
                    mathml: "<mrow><mo>−</mo><mi>k</mi><mspace width=\"0.17em\"/><msup><mrow><mi>a</mi></mrow><mn>2</mn></msup><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mo>+</mo><msub><mi>m</mi><mtext>0</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mrow><mo>(</mo><mi>ω</mi><mspace width=\"0.17em\"/><mi>t</mi><mo>)</mo></mrow></mrow><mo>−</mo><mi>k</mi><mspace width=\"0.17em\"/><mi>a</mi><mspace width=\"0.17em\"/><msub><mover><mi>x</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>+</mo><mi>k</mi><mspace width=\"0.17em\"/><mi>a</mi><mspace width=\"0.17em\"/><msub><mover><mi>y</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>+</mo><mi>cornering</mi><mspace width=\"0.17em\"/><mi>a</mi><mspace width=\"0.17em\"/><mrow><mi>atan2</mi><mo>&#x2061;</mo><mrow><mo>(</mo><msub><mi>u</mi><mtext>1</mtext></msub><mo>,</mo><msqrt><mrow><msup><mrow><mi>creep</mi></mrow><mn>2</mn></msup><mo>+</mo><msubsup><mi>u</mi><mtext>2</mtext><mn>2</mn></msubsup></mrow></msqrt><mo>)</mo></mrow></mrow></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "0",
                    latex: "0",
                    mathml: "<mrow><mn>0</mn></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "0",
                    latex: "0",
                    mathml: "<mrow><mn>0</mn></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "-m0*cos(omega*t)",
                    latex: "-m_{0} \\, \\cos\\left(\\omega \\, t\\right)",
                    mathml: "<mrow><mo>−</mo><msub><mi>m</mi><mtext>0</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mrow><mo>(</mo><mi>ω</mi><mspace width=\"0.17em\"/><mi>t</mi><mo>)</mo></mrow></mrow></mrow>",
                },
            ],
            potential_energy: ::ezy_core::model::Formula {
                text: "0",
                latex: "0",
                mathml: "<mrow><mn>0</mn></mrow>",
            },
            abbreviations: &[
                ::ezy_core::model::Abbreviation {
                    symbol: ::ezy_core::model::Formula {
                        text: "u1",
                        latex: "u_{1}",
                        mathml: "<msub><mi>u</mi><mtext>1</mtext></msub>",
                    },
                    formula: ::ezy_core::model::Formula {
                        text: "-a*seat.omega - seat.vx*sin(seat.phi) + seat.vy*cos(seat.phi)",
                        latex: "-a \\, \\dot{\\varphi}_{\\mathrm{seat}} - \\dot{x}_{\\mathrm{seat}} \\, \\sin{\\varphi_{\\mathrm{seat}}} + \\dot{y}_{\\mathrm{seat}} \\, \\cos{\\varphi_{\\mathrm{seat}}}",
                        mathml: "<mrow><mo>−</mo><mi>a</mi><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mo>−</mo><msub><mover><mi>x</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>+</mo><msub><mover><mi>y</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                    },
                },
                ::ezy_core::model::Abbreviation {
                    symbol: ::ezy_core::model::Formula {
                        text: "u2",
                        latex: "u_{2}",
                        mathml: "<msub><mi>u</mi><mtext>2</mtext></msub>",
                    },
                    formula: ::ezy_core::model::Formula {
                        text: "seat.vx*cos(seat.phi) + seat.vy*sin(seat.phi)",
                        latex: "\\dot{x}_{\\mathrm{seat}} \\, \\cos{\\varphi_{\\mathrm{seat}}} + \\dot{y}_{\\mathrm{seat}} \\, \\sin{\\varphi_{\\mathrm{seat}}}",
                        mathml: "<mrow><msub><mover><mi>x</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>+</mo><msub><mover><mi>y</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                    },
                },
            ],
            elimination: &[
                ::ezy_core::model::EliminationStep {
                    rows: &[2usize],
                    constant_pivot: true,
                },
                ::ezy_core::model::EliminationStep {
                    rows: &[0usize, 1usize],
                    constant_pivot: false,
                },
            ],
            acceleration_operations: ::ezy_core::model::Operations {
                add: 41usize,
                mul: 71usize,
                div: 1usize,
                trig: 3usize,
                calls: 2usize,
            },
            correction_operations: ::ezy_core::model::Operations {
                add: 18usize,
                mul: 34usize,
                div: 1usize,
                trig: 2usize,
                calls: 0usize,
            },
            series: ::ezy_core::model::SeriesInfo::Analytic {
                n_products: 24usize,
                operations: ::ezy_core::model::Operations {
                    add: 79usize,
                    mul: 113usize,
                    div: 0usize,
                    trig: 0usize,
                    calls: 0usize,
                },
            },
            repeats: ::core::option::Option::None,
        };
    }
    #[automatically_derived]
    impl<T: ::ezy_core::scalar::Scalar> ::ezy_core::model::Equations<T> for self::Drift {
        fn constants(&self, parameters: &[T], c: &mut [T]) {
            let parameters = ::ezy_core::kernel::array::<13usize, T>(parameters);
            let c = ::ezy_core::kernel::array_mut::<37usize, T>(c);
            let k1 = T::from_f64(1f64);
            let parameter_m1 = parameters[4usize];
            let parameter_i1 = parameters[5usize];
            let parameter_m2 = parameters[6usize];
            let parameter_i2 = parameters[7usize];
            let parameter_b = parameters[1usize];
            let parameter_d = parameters[3usize];
            let parameter_c = parameters[2usize];
            let parameter_m0 = parameters[8usize];
            let parameter_omega = parameters[9usize];
            let parameter_k = parameters[10usize];
            let parameter_a = parameters[0usize];
            let k14 = parameter_k * parameter_a;
            let k15 = k14 * parameter_a;
            let k16 = -(k14 + k14);
            let parameter_creep = parameters[12usize];
            let k18 = parameter_creep * parameter_creep;
            let parameter_cornering = parameters[11usize];
            let k20 = parameter_cornering * parameter_a;
            let k21 = T::PI;
            let k22 = k1 / parameter_m1;
            let k23 = k1 / parameter_i1;
            let k24 = parameter_b * k23;
            let k25 = k1 / parameter_m2;
            let k26 = k1 / parameter_i2;
            let k27 = parameter_d * parameter_m0;
            let k28 = k27 * k26;
            let k29 = parameter_c * parameter_m0;
            let k30 = k29 * k26;
            let k31 = parameter_b * parameter_b;
            let k32 = k31 * k23;
            let k33 = parameter_d * parameter_d;
            let k34 = k33 * k26;
            let k35 = k22 + k32;
            let k36 = k35 + k25;
            let k37 = k36 + k34;
            let k38 = parameter_d * parameter_c;
            let k39 = k38 * k26;
            let k40 = k25 - k39;
            let k41 = k22 + k25;
            let k42 = parameter_c * parameter_c;
            let k43 = k42 * k26;
            let k44 = k25 + k43;
            let k45 = k1 / k44;
            let k46 = k40 * k45;
            let k47 = k46 * k40;
            let k48 = k37 - k47;
            let k49 = k47 - k34;
            let k50 = parameter_m0 * k26;
            let k51 = parameter_d * k26;
            let k52 = parameter_c * k26;
            let k53 = T::from_f64(0.0000000001f64);
            let k54 = k53 * k44;
            let k55 = k37 + k41;
            let k56 = k55 * k55;
            let k57 = k53 * k56;
            c[0usize] = k14;
            c[1usize] = parameter_cornering;
            c[2usize] = parameter_a;
            c[3usize] = k18;
            c[4usize] = parameter_k;
            c[5usize] = k15;
            c[6usize] = parameter_m0;
            c[7usize] = parameter_omega;
            c[8usize] = k20;
            c[9usize] = k30;
            c[10usize] = k32;
            c[11usize] = k49;
            c[12usize] = k48;
            c[13usize] = k41;
            c[14usize] = k28;
            c[15usize] = k46;
            c[16usize] = parameter_b;
            c[17usize] = parameter_d;
            c[18usize] = k22;
            c[19usize] = k24;
            c[20usize] = k45;
            c[21usize] = k23;
            c[22usize] = k25;
            c[23usize] = k51;
            c[24usize] = k50;
            c[25usize] = k52;
            c[26usize] = k44;
            c[27usize] = k54;
            c[28usize] = k57;
            c[29usize] = k26;
            c[30usize] = parameter_m1;
            c[31usize] = parameter_i1;
            c[32usize] = parameter_m2;
            c[33usize] = parameter_i2;
            c[34usize] = parameter_c;
            c[35usize] = k16;
            c[36usize] = k21;
        }
        fn mass_matrix(&self, c: &[T], m: &mut [T]) {
            let c = ::ezy_core::kernel::array::<37usize, T>(c);
            let out = ::ezy_core::kernel::array_mut::<6usize, T>(m);
            out[0usize] = c[30usize];
            out[1usize] = c[30usize];
            out[2usize] = c[31usize];
            out[3usize] = c[32usize];
            out[4usize] = c[32usize];
            out[5usize] = c[33usize];
        }
        fn position_constraint(&self, c: &[T], t: T, q: &[T], out: &mut [T]) {
            let c = ::ezy_core::kernel::array::<37usize, T>(c);
            let q = ::ezy_core::kernel::array::<6usize, T>(q);
            let out = ::ezy_core::kernel::array_mut::<2usize, T>(out);
            let seat_x = q[0usize];
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let sum_7 = T::fused(c[16usize], cos_seat_phi, seat_x);
            let bar_x = q[3usize];
            let difference_9 = sum_7 - bar_x;
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
            let sum_14 = T::fused(c[17usize], cos_bar_phi, difference_9);
            let seat_y = q[1usize];
            let sum_18 = T::fused(c[16usize], sin_seat_phi, seat_y);
            let bar_y = q[4usize];
            let difference_20 = sum_18 - bar_y;
            let sum_23 = T::fused(c[17usize], sin_bar_phi, difference_20);
            out[0usize] = sum_14;
            out[1usize] = sum_23;
        }
        fn velocity_constraint(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
            let c = ::ezy_core::kernel::array::<37usize, T>(c);
            let q = ::ezy_core::kernel::array::<6usize, T>(q);
            let v = ::ezy_core::kernel::array::<6usize, T>(v);
            let out = ::ezy_core::kernel::array_mut::<3usize, T>(out);
            let seat_vx = v[0usize];
            let bar_vx = v[3usize];
            let difference_4 = seat_vx - bar_vx;
            let bar_omega = v[5usize];
            let product_7 = c[17usize] * bar_omega;
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
            let difference_11 = T::fused(-product_7, sin_bar_phi, difference_4);
            let seat_omega = v[2usize];
            let product_14 = c[16usize] * seat_omega;
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let difference_18 = T::fused(-product_14, sin_seat_phi, difference_11);
            let seat_vy = v[1usize];
            let bar_vy = v[4usize];
            let difference_21 = seat_vy - bar_vy;
            let sum_24 = T::fused(product_7, cos_bar_phi, difference_21);
            let sum_27 = T::fused(product_14, cos_seat_phi, sum_24);
            let product_29 = bar_omega * c[34usize];
            let difference_31 = T::fused(-bar_vx, sin_bar_phi, product_29);
            let sum_33 = T::fused(bar_vy, cos_bar_phi, difference_31);
            out[0usize] = difference_18;
            out[1usize] = sum_27;
            out[2usize] = sum_33;
        }
        fn velocity_jacobian(&self, c: &[T], t: T, q: &[T], out: &mut [T]) {
            let c = ::ezy_core::kernel::array::<37usize, T>(c);
            let q = ::ezy_core::kernel::array::<6usize, T>(q);
            let out = ::ezy_core::kernel::array_mut::<11usize, T>(out);
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let product_4 = c[16usize] * sin_seat_phi;
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
            let product_8 = c[17usize] * sin_bar_phi;
            let product_10 = c[16usize] * cos_seat_phi;
            let product_12 = c[17usize] * cos_bar_phi;
            let value_14 = -product_4;
            let value_15 = -T::from_f64(1f64);
            let value_16 = -product_8;
            let value_17 = -sin_bar_phi;
            out[0usize] = T::from_f64(1f64);
            out[1usize] = value_14;
            out[2usize] = value_15;
            out[3usize] = value_16;
            out[4usize] = T::from_f64(1f64);
            out[5usize] = product_10;
            out[6usize] = value_15;
            out[7usize] = product_12;
            out[8usize] = value_17;
            out[9usize] = cos_bar_phi;
            out[10usize] = c[34usize];
        }
        fn convective_term(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
            let c = ::ezy_core::kernel::array::<37usize, T>(c);
            let q = ::ezy_core::kernel::array::<6usize, T>(q);
            let v = ::ezy_core::kernel::array::<6usize, T>(v);
            let out = ::ezy_core::kernel::array_mut::<3usize, T>(out);
            let seat_omega = v[2usize];
            let product_3 = c[16usize] * seat_omega;
            let product_4 = seat_omega * product_3;
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let product_8 = product_4 * cos_seat_phi;
            let bar_omega = v[5usize];
            let product_11 = c[17usize] * bar_omega;
            let product_12 = bar_omega * product_11;
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
            let sum_16 = T::fused(product_12, cos_bar_phi, product_8);
            let product_18 = product_4 * sin_seat_phi;
            let sum_21 = T::fused(product_12, sin_bar_phi, product_18);
            let bar_vx = v[3usize];
            let product_23 = cos_bar_phi * bar_vx;
            let bar_vy = v[4usize];
            let sum_26 = T::fused(sin_bar_phi, bar_vy, product_23);
            let product_27 = bar_omega * sum_26;
            let value_28 = -sum_16;
            let value_29 = -sum_21;
            let value_30 = -product_27;
            out[0usize] = value_28;
            out[1usize] = value_29;
            out[2usize] = value_30;
        }
        fn applied_force(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
            let c = ::ezy_core::kernel::array::<37usize, T>(c);
            let q = ::ezy_core::kernel::array::<6usize, T>(q);
            let v = ::ezy_core::kernel::array::<6usize, T>(v);
            let out = ::ezy_core::kernel::array_mut::<6usize, T>(out);
            let seat_omega = v[2usize];
            let seat_vx = v[0usize];
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let product_11 = seat_vx * sin_seat_phi;
            let sum_12 = T::fused(seat_omega, c[2usize], product_11);
            let seat_vy = v[1usize];
            let product_15 = seat_vy * cos_seat_phi;
            let difference_16 = product_15 - sum_12;
            let product_17 = seat_vx * cos_seat_phi;
            let sum_19 = T::fused(sin_seat_phi, seat_vy, product_17);
            let sum_22 = T::fused(sum_19, sum_19, c[3usize]);
            let value_23 = T::sqrt(sum_22);
            let value_24 = T::atan2(difference_16, value_23);
            let product_25 = c[1usize] * value_24;
            let difference_26 = T::fused(-c[0usize], seat_omega, product_25);
            let product_27 = sin_seat_phi * difference_26;
            let difference_30 = T::fused(-seat_vx, c[4usize], product_27);
            let product_31 = cos_seat_phi * difference_26;
            let sum_33 = T::fused(seat_vy, c[4usize], product_31);
            let difference_34 = product_15 - product_11;
            let product_35 = c[0usize] * difference_34;
            let difference_38 = T::fused(-seat_omega, c[5usize], product_35);
            let product_42 = c[7usize] * t;
            let cos_42 = T::cos(product_42);
            let product_44 = c[6usize] * cos_42;
            let sum_45 = difference_38 + product_44;
            let sum_48 = T::fused(value_24, c[8usize], sum_45);
            let value_49 = -sum_33;
            let value_50 = -product_44;
            out[0usize] = difference_30;
            out[1usize] = value_49;
            out[2usize] = sum_48;
            out[3usize] = T::from_f64(0f64);
            out[4usize] = T::from_f64(0f64);
            out[5usize] = value_50;
        }
        #[inline]
        fn accelerations(
            &self,
            c: &[T],
            t: T,
            q: &[T],
            v: &[T],
            a: &mut [T],
            lambda: &mut [T],
        ) -> ::ezy_core::model::DeficientRows {
            let c = ::ezy_core::kernel::array::<37usize, T>(c);
            let q = ::ezy_core::kernel::array::<6usize, T>(q);
            let v = ::ezy_core::kernel::array::<6usize, T>(v);
            let a = ::ezy_core::kernel::array_mut::<6usize, T>(a);
            let lambda = ::ezy_core::kernel::array_mut::<3usize, T>(lambda);
            let seat_omega = v[2usize];
            let seat_vx = v[0usize];
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let product_11 = seat_vx * sin_seat_phi;
            let sum_12 = T::fused(seat_omega, c[2usize], product_11);
            let seat_vy = v[1usize];
            let product_15 = seat_vy * cos_seat_phi;
            let difference_16 = product_15 - sum_12;
            let product_17 = seat_vx * cos_seat_phi;
            let sum_19 = T::fused(sin_seat_phi, seat_vy, product_17);
            let sum_22 = T::fused(sum_19, sum_19, c[3usize]);
            let value_23 = T::sqrt(sum_22);
            let value_24 = T::atan2(difference_16, value_23);
            let product_25 = c[1usize] * value_24;
            let difference_26 = T::fused(-c[0usize], seat_omega, product_25);
            let product_27 = sin_seat_phi * difference_26;
            let force_seat_x = T::fused(-seat_vx, c[4usize], product_27);
            let product_31 = cos_seat_phi * difference_26;
            let minus_force_seat_y = T::fused(seat_vy, c[4usize], product_31);
            let difference_34 = product_15 - product_11;
            let product_35 = c[0usize] * difference_34;
            let difference_38 = T::fused(-seat_omega, c[5usize], product_35);
            let product_42 = c[7usize] * t;
            let cos_42 = T::cos(product_42);
            let sum_45 = T::fused(c[6usize], cos_42, difference_38);
            let force_seat_phi = T::fused(value_24, c[8usize], sum_45);
            let bar_vx = v[3usize];
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
            let product_52 = bar_vx * cos_bar_phi;
            let bar_vy = v[4usize];
            let sum_56 = T::fused(bar_vy, sin_bar_phi, product_52);
            let bar_omega = v[5usize];
            let product_58 = sum_56 * bar_omega;
            let minus_right_side_front = T::fused(cos_42, c[9usize], product_58);
            let product_63 = cos_seat_phi * c[10usize];
            let product_66 = cos_bar_phi * c[11usize];
            let product_67 = cos_bar_phi * product_66;
            let difference_68 = T::fused(-cos_seat_phi, product_63, product_67);
            let sum_70 = difference_68 + c[12usize];
            let product_71 = sin_seat_phi * c[10usize];
            let product_73 = sin_bar_phi * c[11usize];
            let product_74 = cos_bar_phi * product_73;
            let difference_75 = T::fused(-cos_seat_phi, product_71, product_74);
            let difference_77 = c[13usize] - difference_68;
            let product_79 = cos_42 * c[14usize];
            let sum_82 = T::fused(minus_right_side_front, c[15usize], product_79);
            let product_83 = sin_bar_phi * sum_82;
            let product_85 = seat_omega * c[16usize];
            let product_86 = seat_omega * product_85;
            let difference_88 = T::fused(-cos_seat_phi, product_86, product_83);
            let product_90 = bar_omega * c[17usize];
            let product_91 = bar_omega * product_90;
            let difference_93 = T::fused(-cos_bar_phi, product_91, difference_88);
            let sum_96 = T::fused(force_seat_x, c[18usize], difference_93);
            let product_98 = force_seat_phi * c[19usize];
            let difference_100 = T::fused(-sin_seat_phi, product_98, sum_96);
            let product_101 = cos_bar_phi * sum_82;
            let sum_103 = T::fused(sin_seat_phi, product_86, product_101);
            let sum_105 = T::fused(sin_bar_phi, product_91, sum_103);
            let sum_107 = T::fused(minus_force_seat_y, c[18usize], sum_105);
            let difference_109 = T::fused(cos_seat_phi, product_98, -sum_107);
            let product_110 = sum_70 * difference_77;
            let difference_112 = T::fused(-difference_75, difference_75, product_110);
            let quotient_113 = T::from_f64(1f64) / difference_112;
            let product_114 = difference_77 * difference_100;
            let difference_116 = T::fused(-difference_75, difference_109, product_114);
            let lambda_B_x = quotient_113 * difference_116;
            let product_119 = sum_70 * difference_109;
            let difference_120 = T::fused(-difference_75, difference_100, product_119);
            let lambda_B_y = quotient_113 * difference_120;
            let product_123 = cos_bar_phi * lambda_B_y;
            let difference_124 = T::fused(-sin_bar_phi, lambda_B_x, product_123);
            let product_125 = c[15usize] * difference_124;
            let lambda_front = T::fused(
                -minus_right_side_front,
                c[20usize],
                product_125,
            );
            let difference_129 = force_seat_x - lambda_B_x;
            let product_130 = c[18usize] * difference_129;
            let sum_131 = minus_force_seat_y + lambda_B_y;
            let product_132 = c[18usize] * sum_131;
            let product_133 = sin_seat_phi * lambda_B_x;
            let difference_135 = T::fused(-cos_seat_phi, lambda_B_y, product_133);
            let product_136 = c[19usize] * difference_135;
            let sum_139 = T::fused(force_seat_phi, c[21usize], product_136);
            let sum_141 = T::fused(sin_bar_phi, lambda_front, lambda_B_x);
            let product_143 = sum_141 * c[22usize];
            let difference_145 = T::fused(-cos_bar_phi, lambda_front, lambda_B_y);
            let product_146 = c[22usize] * difference_145;
            let product_148 = difference_124 * c[23usize];
            let sum_151 = T::fused(cos_42, c[24usize], product_148);
            let sum_154 = T::fused(lambda_front, c[25usize], sum_151);
            let value_158 = -product_132;
            let value_159 = -sum_154;
            a[0usize] = product_130;
            a[1usize] = value_158;
            a[2usize] = sum_139;
            a[3usize] = product_143;
            a[4usize] = product_146;
            a[5usize] = value_159;
            lambda[0usize] = lambda_B_x;
            lambda[1usize] = lambda_B_y;
            lambda[2usize] = lambda_front;
            ::ezy_core::model::DeficientRows(0)
                .mark(2usize, !T::is_above(c[26usize], c[27usize]))
                .mark(0usize, !T::is_above(difference_112, c[28usize]))
                .mark(1usize, !T::is_above(difference_112, c[28usize]))
        }
        #[inline]
        fn correction(
            &self,
            c: &[T],
            t: T,
            q: &[T],
            residual: &[T],
            delta: &mut [T],
        ) -> ::ezy_core::model::DeficientRows {
            let c = ::ezy_core::kernel::array::<37usize, T>(c);
            let q = ::ezy_core::kernel::array::<6usize, T>(q);
            let residual = ::ezy_core::kernel::array::<3usize, T>(residual);
            let delta = ::ezy_core::kernel::array_mut::<6usize, T>(delta);
            let right_side_front = residual[2usize];
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let product_6 = c[10usize] * cos_seat_phi;
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
            let product_11 = c[11usize] * cos_bar_phi;
            let product_12 = cos_bar_phi * product_11;
            let difference_13 = T::fused(-cos_seat_phi, product_6, product_12);
            let sum_15 = difference_13 + c[12usize];
            let product_17 = c[10usize] * sin_seat_phi;
            let product_20 = c[11usize] * sin_bar_phi;
            let product_21 = cos_bar_phi * product_20;
            let difference_22 = T::fused(-cos_seat_phi, product_17, product_21);
            let difference_24 = c[13usize] - difference_13;
            let residual_0 = residual[0usize];
            let product_27 = right_side_front * c[15usize];
            let difference_29 = T::fused(-sin_bar_phi, product_27, residual_0);
            let residual_1 = residual[1usize];
            let sum_32 = T::fused(cos_bar_phi, product_27, residual_1);
            let product_33 = sum_15 * difference_24;
            let difference_35 = T::fused(-difference_22, difference_22, product_33);
            let quotient_36 = T::from_f64(1f64) / difference_35;
            let product_37 = difference_24 * difference_29;
            let difference_39 = T::fused(-difference_22, sum_32, product_37);
            let lambda_B_x = quotient_36 * difference_39;
            let product_42 = sum_15 * sum_32;
            let difference_43 = T::fused(-difference_22, difference_29, product_42);
            let lambda_B_y = quotient_36 * difference_43;
            let product_46 = cos_bar_phi * lambda_B_y;
            let difference_47 = T::fused(-sin_bar_phi, lambda_B_x, product_46);
            let product_48 = c[15usize] * difference_47;
            let lambda_front = T::fused(right_side_front, c[20usize], product_48);
            let product_53 = lambda_B_x * c[18usize];
            let product_54 = lambda_B_y * c[18usize];
            let product_55 = sin_seat_phi * lambda_B_x;
            let difference_57 = T::fused(-cos_seat_phi, lambda_B_y, product_55);
            let product_59 = difference_57 * c[19usize];
            let sum_61 = T::fused(sin_bar_phi, lambda_front, lambda_B_x);
            let product_63 = sum_61 * c[22usize];
            let difference_65 = T::fused(-cos_bar_phi, lambda_front, lambda_B_y);
            let product_66 = c[22usize] * difference_65;
            let product_68 = difference_47 * c[23usize];
            let sum_71 = T::fused(lambda_front, c[25usize], product_68);
            let value_75 = -product_53;
            let value_76 = -product_54;
            let value_77 = -sum_71;
            delta[0usize] = value_75;
            delta[1usize] = value_76;
            delta[2usize] = product_59;
            delta[3usize] = product_63;
            delta[4usize] = product_66;
            delta[5usize] = value_77;
            ::ezy_core::model::DeficientRows(0)
                .mark(2usize, !T::is_above(c[26usize], c[27usize]))
                .mark(0usize, !T::is_above(difference_35, c[28usize]))
                .mark(1usize, !T::is_above(difference_35, c[28usize]))
        }
    }
    #[automatically_derived]
    impl ::ezy_core::model::Scene for Drift {
        fn info(&self) -> &'static ::ezy_core::model::SceneInfo {
            static INFO: ::ezy_core::model::SceneInfo = Drift::INFO;
            &INFO
        }
        fn parameter(&self, index: usize) -> f64 {
            match index {
                0usize => self.a,
                1usize => self.b,
                2usize => self.c,
                3usize => self.d,
                4usize => self.m1,
                5usize => self.i1,
                6usize => self.m2,
                7usize => self.i2,
                8usize => self.m0,
                9usize => self.omega,
                10usize => self.k,
                11usize => self.cornering,
                12usize => self.creep,
                _ => f64::NAN,
            }
        }
        fn set_parameter(&mut self, index: usize, value: f64) {
            match index {
                0usize => self.a = value,
                1usize => self.b = value,
                2usize => self.c = value,
                3usize => self.d = value,
                4usize => self.m1 = value,
                5usize => self.i1 = value,
                6usize => self.m2 = value,
                7usize => self.i2 = value,
                8usize => self.m0 = value,
                9usize => self.omega = value,
                10usize => self.k = value,
                11usize => self.cornering = value,
                12usize => self.creep = value,
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
            let c = ::ezy_core::kernel::array::<37usize, f64>(c);
            let q = ::ezy_core::kernel::array::<6usize, f64>(q);
            let v = ::ezy_core::kernel::array::<6usize, f64>(v);
            let lambda = ::ezy_core::kernel::array::<3usize, f64>(lambda);
            let out = ::ezy_core::kernel::array_mut::<3usize, f64>(out);
            let seat_omega = v[2usize];
            let bar_omega = v[5usize];
            let difference_4 = seat_omega - bar_omega;
            let product_7 = c[7usize] * t;
            let cos_7 = f64::cos(product_7);
            let product_9 = difference_4 * cos_7;
            let product_11 = product_9 * c[6usize];
            let seat_vx = v[0usize];
            let product_13 = seat_vx * seat_vx;
            let seat_vy = v[1usize];
            let product_15 = seat_vy * seat_vy;
            let sum_16 = product_13 + product_15;
            let product_18 = sum_16 * c[4usize];
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = f64::sin_cos(seat_phi);
            let product_21 = seat_vx * sin_seat_phi;
            let product_23 = seat_vy * cos_seat_phi;
            let difference_24 = product_21 - product_23;
            let product_26 = difference_24 * c[35usize];
            let product_28 = seat_omega * c[5usize];
            let difference_29 = product_26 - product_28;
            let product_30 = seat_omega * difference_29;
            let difference_31 = product_30 - product_18;
            let product_33 = difference_24 * c[1usize];
            let product_35 = seat_omega * c[8usize];
            let sum_36 = product_33 + product_35;
            let product_38 = seat_omega * c[2usize];
            let sum_39 = product_21 + product_38;
            let difference_40 = product_23 - sum_39;
            let product_41 = seat_vx * cos_seat_phi;
            let product_42 = seat_vy * sin_seat_phi;
            let sum_43 = product_41 + product_42;
            let product_44 = sum_43 * sum_43;
            let sum_46 = product_44 + c[3usize];
            let value_47 = f64::sqrt(sum_46);
            let value_48 = f64::atan2(difference_40, value_47);
            let product_49 = sum_36 * value_48;
            out[0usize] = product_11;
            out[1usize] = difference_31;
            out[2usize] = product_49;
        }
        fn points(&self, c: &[f64], t: f64, q: &[f64], out: &mut [f64]) {
            let c = ::ezy_core::kernel::array::<37usize, f64>(c);
            let q = ::ezy_core::kernel::array::<6usize, f64>(q);
            let out = ::ezy_core::kernel::array_mut::<6usize, f64>(out);
            let seat_x = q[0usize];
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = f64::sin_cos(seat_phi);
            let product_6 = c[2usize] * cos_seat_phi;
            let difference_7 = seat_x - product_6;
            let seat_y = q[1usize];
            let product_10 = c[2usize] * sin_seat_phi;
            let difference_11 = seat_y - product_10;
            let bar_x = q[3usize];
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = f64::sin_cos(bar_phi);
            let product_16 = c[34usize] * cos_bar_phi;
            let sum_17 = bar_x + product_16;
            let bar_y = q[4usize];
            let product_20 = c[34usize] * sin_bar_phi;
            let sum_21 = bar_y + product_20;
            let product_23 = cos_seat_phi * c[16usize];
            let sum_24 = seat_x + product_23;
            let product_25 = sin_seat_phi * c[16usize];
            let sum_26 = seat_y + product_25;
            out[0usize] = difference_7;
            out[1usize] = difference_11;
            out[2usize] = sum_17;
            out[3usize] = sum_21;
            out[4usize] = sum_24;
            out[5usize] = sum_26;
        }
        fn outputs(&self, c: &[f64], t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
            let c = ::ezy_core::kernel::array::<37usize, f64>(c);
            let q = ::ezy_core::kernel::array::<6usize, f64>(q);
            let v = ::ezy_core::kernel::array::<6usize, f64>(v);
            let out = ::ezy_core::kernel::array_mut::<0usize, f64>(out);
        }
        fn potential_energy(&self, c: &[f64], t: f64, q: &[f64]) -> f64 {
            0f64
        }
        fn start(&self, c: &[f64], start: &mut ::ezy_core::model::Start) {
            let c = ::ezy_core::kernel::array::<37usize, f64>(c);
            start.give_position(0usize, 0f64);
            start.give_position(1usize, 0f64);
            start.give_position(2usize, 0f64);
            start.give_position(5usize, c[36usize]);
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
    impl<T: ::ezy_core::scalar::Scalar> ::ezy_core::model::Series<T> for Drift {
        fn series_size(&self) -> ::ezy_core::model::SeriesSize {
            ::ezy_core::model::SeriesSize {
                n_coordinates: 6usize,
                n_rows: 3usize,
                n_products: 24usize,
                n_base: 16usize,
                n_kept: 5usize,
            }
        }
        fn begin(
            &self,
            c: &[T],
            t: T,
            store: &mut ::ezy_core::model::SeriesStore<T>,
        ) -> ::ezy_core::model::DeficientRows {
            let c = ::ezy_core::kernel::array::<37usize, T>(c);
            let q = ::ezy_core::kernel::row::<6usize, T>(&store.q, 0);
            let v = ::ezy_core::kernel::row::<6usize, T>(&store.q, 1);
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
            let seat_omega = v[2usize];
            let product_25 = c[16usize] * seat_omega;
            let product_26 = seat_omega * product_25;
            let product_27 = cos_seat_phi * product_26;
            let bar_omega = v[5usize];
            let product_29 = c[17usize] * bar_omega;
            let product_30 = bar_omega * product_29;
            let sum_32 = T::fused(cos_bar_phi, product_30, product_27);
            let product_33 = sin_seat_phi * product_26;
            let sum_35 = T::fused(sin_bar_phi, product_30, product_33);
            let bar_vx = v[3usize];
            let product_37 = cos_bar_phi * bar_vx;
            let bar_vy = v[4usize];
            let sum_40 = T::fused(sin_bar_phi, bar_vy, product_37);
            let product_41 = bar_omega * sum_40;
            let seat_vx = v[0usize];
            let product_48 = sin_seat_phi * seat_vx;
            let sum_49 = T::fused(seat_omega, c[2usize], product_48);
            let seat_vy = v[1usize];
            let product_51 = cos_seat_phi * seat_vy;
            let difference_52 = product_51 - sum_49;
            let product_53 = cos_seat_phi * seat_vx;
            let sum_55 = T::fused(sin_seat_phi, seat_vy, product_53);
            let sum_58 = T::fused(sum_55, sum_55, c[3usize]);
            let value_59 = T::sqrt(sum_58);
            let value_60 = T::atan2(difference_52, value_59);
            let product_61 = c[1usize] * value_60;
            let difference_62 = T::fused(-seat_omega, c[0usize], product_61);
            let product_63 = sin_seat_phi * difference_62;
            let difference_66 = T::fused(-seat_vx, c[4usize], product_63);
            let product_67 = cos_seat_phi * difference_62;
            let sum_69 = T::fused(seat_vy, c[4usize], product_67);
            let difference_70 = product_51 - product_48;
            let product_71 = c[0usize] * difference_70;
            let difference_74 = T::fused(-seat_omega, c[5usize], product_71);
            let product_78 = c[7usize] * t;
            let (sin_78, cos_78) = T::sin_cos(product_78);
            let product_80 = c[6usize] * cos_78;
            let sum_81 = difference_74 + product_80;
            let sum_84 = T::fused(value_60, c[8usize], sum_81);
            let product_99 = cos_seat_phi * c[10usize];
            let product_102 = cos_bar_phi * c[11usize];
            let product_103 = cos_bar_phi * product_102;
            let difference_104 = T::fused(-cos_seat_phi, product_99, product_103);
            let sum_106 = difference_104 + c[12usize];
            let product_107 = sin_seat_phi * c[10usize];
            let product_109 = sin_bar_phi * c[11usize];
            let product_110 = cos_bar_phi * product_109;
            let difference_111 = T::fused(-cos_seat_phi, product_107, product_110);
            let difference_113 = c[13usize] - difference_104;
            let product_143 = sum_106 * difference_113;
            let difference_145 = T::fused(-difference_111, difference_111, product_143);
            let quotient_146 = T::from_f64(1f64) / difference_145;
            let product_191 = difference_52 * difference_52;
            let sum_193 = T::fused(value_59, value_59, product_191);
            let quotient_194 = T::from_f64(1f64) / sum_193;
            let sum_195 = value_59 + value_59;
            let quotient_196 = T::from_f64(1f64) / sum_195;
            let product_197 = cos_seat_phi * seat_omega;
            let product_198 = sin_seat_phi * seat_omega;
            let product_199 = cos_bar_phi * bar_omega;
            let product_200 = sin_bar_phi * bar_omega;
            let product_201 = c[7usize] * sin_78;
            let product_202 = c[6usize] * product_201;
            let product_203 = c[7usize] * cos_78;
            let value_204 = -sum_69;
            let value_205 = -product_80;
            let value_206 = -product_198;
            let value_207 = -product_200;
            let value_208 = -product_202;
            let value_209 = -product_201;
            let target = ::ezy_core::kernel::array_mut::<16usize, T>(&mut store.base);
            target[0usize] = cos_seat_phi;
            target[1usize] = seat_vy;
            target[2usize] = sin_seat_phi;
            target[3usize] = seat_vx;
            target[4usize] = value_59;
            target[5usize] = sum_55;
            target[6usize] = quotient_196;
            target[7usize] = difference_52;
            target[8usize] = quotient_194;
            target[9usize] = difference_62;
            target[10usize] = cos_bar_phi;
            target[11usize] = sin_bar_phi;
            target[12usize] = quotient_146;
            target[13usize] = difference_113;
            target[14usize] = difference_111;
            target[15usize] = sum_106;
            let target = ::ezy_core::kernel::array_mut::<6usize, T>(&mut store.force);
            target[0usize] = difference_66;
            target[1usize] = value_204;
            target[2usize] = sum_84;
            target[3usize] = T::from_f64(0f64);
            target[4usize] = T::from_f64(0f64);
            target[5usize] = value_205;
            let target = ::ezy_core::kernel::row_mut::<
                5usize,
                T,
            >(&mut store.kept, 0usize);
            target[0usize] = cos_seat_phi;
            target[1usize] = sin_seat_phi;
            target[2usize] = product_80;
            target[3usize] = sin_78;
            target[4usize] = cos_78;
            let target = ::ezy_core::kernel::row_mut::<
                5usize,
                T,
            >(&mut store.kept, 1usize);
            target[0usize] = value_206;
            target[1usize] = product_197;
            target[2usize] = value_208;
            target[3usize] = product_203;
            target[4usize] = value_209;
            let target = ::ezy_core::kernel::row_mut::<
                24usize,
                T,
            >(&mut store.left, 1usize);
            target[0usize] = T::from_f64(0f64);
            target[1usize] = T::from_f64(0f64);
            target[2usize] = T::from_f64(0f64);
            target[3usize] = T::from_f64(0f64);
            target[4usize] = T::from_f64(0f64);
            target[5usize] = T::from_f64(0f64);
            target[6usize] = T::from_f64(0f64);
            target[7usize] = T::from_f64(0f64);
            target[8usize] = T::from_f64(0f64);
            target[9usize] = T::from_f64(0f64);
            target[10usize] = T::from_f64(0f64);
            target[11usize] = product_197;
            target[12usize] = value_206;
            target[13usize] = product_199;
            target[14usize] = value_207;
            target[15usize] = product_199;
            target[16usize] = value_207;
            target[17usize] = seat_omega;
            target[18usize] = bar_omega;
            target[19usize] = seat_omega;
            target[20usize] = bar_omega;
            target[21usize] = product_199;
            target[22usize] = value_207;
            target[23usize] = T::from_f64(0f64);
            let target = ::ezy_core::kernel::row_mut::<
                24usize,
                T,
            >(&mut store.right, 1usize);
            target[0usize] = T::from_f64(0f64);
            target[1usize] = T::from_f64(0f64);
            target[2usize] = T::from_f64(0f64);
            target[3usize] = T::from_f64(0f64);
            target[4usize] = T::from_f64(0f64);
            target[5usize] = T::from_f64(0f64);
            target[6usize] = T::from_f64(0f64);
            target[7usize] = T::from_f64(0f64);
            target[8usize] = T::from_f64(0f64);
            target[9usize] = T::from_f64(0f64);
            target[10usize] = T::from_f64(0f64);
            target[11usize] = T::from_f64(0f64);
            target[12usize] = T::from_f64(0f64);
            target[13usize] = T::from_f64(0f64);
            target[14usize] = T::from_f64(0f64);
            target[15usize] = T::from_f64(0f64);
            target[16usize] = T::from_f64(0f64);
            target[17usize] = product_197;
            target[18usize] = product_199;
            target[19usize] = value_206;
            target[20usize] = value_207;
            target[21usize] = bar_vx;
            target[22usize] = bar_vy;
            target[23usize] = T::from_f64(0f64);
            let target = ::ezy_core::kernel::row_mut::<
                24usize,
                T,
            >(&mut store.right, 2usize);
            target[0usize] = difference_62;
            target[1usize] = value_59;
            target[2usize] = difference_52;
            target[3usize] = sum_193;
            target[4usize] = seat_vy;
            target[5usize] = seat_vx;
            target[6usize] = sum_55;
            target[7usize] = seat_vx;
            target[8usize] = seat_vy;
            target[9usize] = value_59;
            target[10usize] = difference_62;
            target[23usize] = difference_52;
            let target = ::ezy_core::kernel::array_mut::<3usize, T>(&mut store.row);
            target[0usize] = sum_32;
            target[1usize] = sum_35;
            target[2usize] = product_41;
            ::ezy_core::model::DeficientRows(0)
                .mark(2usize, !T::is_above(c[26usize], c[27usize]))
                .mark(0usize, !T::is_above(difference_145, c[28usize]))
                .mark(1usize, !T::is_above(difference_145, c[28usize]))
        }
        #[inline]
        fn right_side(
            &self,
            c: &[T],
            k: usize,
            store: &mut ::ezy_core::model::SeriesStore<T>,
        ) {
            let c = ::ezy_core::kernel::array::<37usize, T>(c);
            let base = ::ezy_core::kernel::array::<16usize, T>(&store.base);
            let kept_0 = ::ezy_core::kernel::row::<5usize, T>(&store.kept, k + 0usize);
            let q_1 = ::ezy_core::kernel::row::<6usize, T>(&store.q, k + 1usize);
            let sums = ::ezy_core::kernel::array::<24usize, T>(&store.sums);
            let convolved_0 = sums[0usize];
            let convolved_1 = sums[1usize];
            let inverse_order = T::from_f64(1f64) / T::from_f64((k + 0usize) as f64);
            let product_4 = convolved_1 * inverse_order;
            let convolved_2 = sums[2usize];
            let convolved_3 = sums[3usize];
            let convolved_4 = sums[4usize];
            let order_next = T::from_f64((k + 1usize) as f64);
            let q_1_next = q_1[1usize];
            let product_12 = order_next * q_1_next;
            let base_0 = base[0usize];
            let product_14 = product_12 * base_0;
            let kept_0 = kept_0[0usize];
            let base_1 = base[1usize];
            let sum_18 = T::fused(kept_0, base_1, product_14);
            let sum_19 = convolved_4 + sum_18;
            let q_2_next = q_1[2usize];
            let product_22 = order_next * q_2_next;
            let convolved_5 = sums[5usize];
            let q_0_next = q_1[0usize];
            let product_26 = order_next * q_0_next;
            let base_2 = base[2usize];
            let product_28 = product_26 * base_2;
            let kept_1 = kept_0[1usize];
            let base_3 = base[3usize];
            let sum_32 = T::fused(kept_1, base_3, product_28);
            let sum_33 = convolved_5 + sum_32;
            let sum_34 = T::fused(c[2usize], product_22, sum_33);
            let difference_35 = sum_19 - sum_34;
            let base_4 = base[4usize];
            let convolved_6 = sums[6usize];
            let convolved_7 = sums[7usize];
            let product_40 = base_0 * product_26;
            let sum_42 = T::fused(kept_0, base_3, product_40);
            let sum_43 = convolved_7 + sum_42;
            let convolved_8 = sums[8usize];
            let product_45 = product_12 * base_2;
            let sum_47 = T::fused(base_1, kept_1, product_45);
            let sum_48 = convolved_8 + sum_47;
            let sum_49 = sum_43 + sum_48;
            let base_5 = base[5usize];
            let product_51 = sum_49 * base_5;
            let sum_52 = product_51 + product_51;
            let sum_53 = convolved_6 + sum_52;
            let convolved_9 = sums[9usize];
            let difference_56 = sum_53 - convolved_9;
            let base_6 = base[6usize];
            let product_58 = difference_56 * base_6;
            let base_7 = base[7usize];
            let difference_61 = T::fused(-inverse_order, convolved_2, product_4);
            let difference_62 = T::fused(-inverse_order, convolved_3, difference_61);
            let sum_63 = T::fused(difference_35, base_4, difference_62);
            let difference_64 = T::fused(-product_58, base_7, sum_63);
            let base_8 = base[8usize];
            let product_66 = difference_64 * base_8;
            let product_67 = c[1usize] * product_66;
            let difference_70 = T::fused(-product_22, c[0usize], product_67);
            let product_71 = base_2 * difference_70;
            let base_9 = base[9usize];
            let sum_74 = T::fused(kept_1, base_9, product_71);
            let sum_75 = convolved_0 + sum_74;
            let difference_78 = T::fused(-product_26, c[4usize], sum_75);
            let convolved_10 = sums[10usize];
            let product_80 = base_0 * difference_70;
            let sum_82 = T::fused(kept_0, base_9, product_80);
            let sum_83 = convolved_10 + sum_82;
            let sum_85 = T::fused(product_12, c[4usize], sum_83);
            let difference_86 = sum_19 - sum_33;
            let product_87 = c[0usize] * difference_86;
            let difference_90 = T::fused(-product_22, c[5usize], product_87);
            let kept_2 = kept_0[2usize];
            let sum_92 = difference_90 + kept_2;
            let sum_95 = T::fused(product_66, c[8usize], sum_92);
            let convolved_11 = sums[11usize];
            let convolved_12 = sums[12usize];
            let product_100 = c[16usize] * convolved_12;
            let difference_101 = T::fused(-c[16usize], convolved_11, product_100);
            let difference_102 = sum_95 - difference_101;
            let convolved_13 = sums[13usize];
            let convolved_14 = sums[14usize];
            let convolved_15 = sums[15usize];
            let convolved_16 = sums[16usize];
            let product_110 = c[17usize] * convolved_16;
            let difference_111 = T::fused(-c[17usize], convolved_15, product_110);
            let sum_112 = kept_2 + difference_111;
            let convolved_17 = sums[17usize];
            let inverse_order_ahead = T::from_f64(1f64)
                / T::from_f64((k + 2usize) as f64);
            let product_115 = convolved_17 * inverse_order_ahead;
            let product_116 = c[16usize] * product_115;
            let convolved_18 = sums[18usize];
            let product_118 = inverse_order_ahead * convolved_18;
            let sum_120 = T::fused(c[17usize], product_118, product_116);
            let order_ahead = T::from_f64((k + 2usize) as f64);
            let product_122 = order_next * order_ahead;
            let product_123 = sum_120 * product_122;
            let convolved_19 = sums[19usize];
            let product_125 = inverse_order_ahead * convolved_19;
            let product_126 = c[16usize] * product_125;
            let convolved_20 = sums[20usize];
            let product_128 = inverse_order_ahead * convolved_20;
            let sum_130 = T::fused(c[17usize], product_128, product_126);
            let product_131 = product_122 * sum_130;
            let convolved_21 = sums[21usize];
            let convolved_22 = sums[22usize];
            let difference_134 = convolved_21 - convolved_22;
            let product_135 = order_next * difference_134;
            let order = T::from_f64((k + 0usize) as f64);
            let product_137 = difference_35 * order;
            let product_138 = product_58 * order;
            let product_139 = product_66 * order;
            let convolved_23 = sums[23usize];
            let product_141 = difference_35 * base_7;
            let sum_142 = product_141 + product_141;
            let sum_143 = convolved_23 + sum_142;
            let product_144 = base_4 * product_58;
            let sum_145 = product_144 + product_144;
            let sum_146 = convolved_9 + sum_145;
            let sum_147 = sum_143 + sum_146;
            let value_148 = -sum_85;
            let value_149 = -convolved_14;
            let value_150 = -sum_112;
            let value_151 = -product_131;
            let target = ::ezy_core::kernel::array_mut::<6usize, T>(&mut store.force);
            target[0usize] = difference_78;
            target[1usize] = value_148;
            target[2usize] = difference_102;
            target[3usize] = convolved_13;
            target[4usize] = value_149;
            target[5usize] = value_150;
            let target = ::ezy_core::kernel::row_mut::<
                24usize,
                T,
            >(&mut store.left, k + 0usize);
            target[0usize] = kept_1;
            target[1usize] = product_137;
            target[2usize] = product_138;
            target[3usize] = product_139;
            target[4usize] = kept_0;
            target[5usize] = kept_1;
            target[6usize] = sum_49;
            target[7usize] = kept_0;
            target[8usize] = kept_1;
            target[9usize] = product_58;
            target[10usize] = kept_0;
            target[23usize] = difference_35;
            let target = ::ezy_core::kernel::row_mut::<
                24usize,
                T,
            >(&mut store.left, k + 1usize);
            target[0usize] = T::from_f64(0f64);
            target[1usize] = T::from_f64(0f64);
            target[2usize] = T::from_f64(0f64);
            target[3usize] = T::from_f64(0f64);
            target[4usize] = T::from_f64(0f64);
            target[5usize] = T::from_f64(0f64);
            target[6usize] = T::from_f64(0f64);
            target[7usize] = T::from_f64(0f64);
            target[8usize] = T::from_f64(0f64);
            target[9usize] = T::from_f64(0f64);
            target[10usize] = T::from_f64(0f64);
            target[23usize] = T::from_f64(0f64);
            let target = ::ezy_core::kernel::row_mut::<
                24usize,
                T,
            >(&mut store.right, k + 2usize);
            target[0usize] = difference_70;
            target[1usize] = product_58;
            target[2usize] = difference_35;
            target[3usize] = sum_147;
            target[4usize] = product_12;
            target[5usize] = product_26;
            target[6usize] = sum_49;
            target[7usize] = product_26;
            target[8usize] = product_12;
            target[9usize] = product_58;
            target[10usize] = difference_70;
            target[23usize] = difference_35;
            let target = ::ezy_core::kernel::array_mut::<3usize, T>(&mut store.row);
            target[0usize] = product_123;
            target[1usize] = value_151;
            target[2usize] = product_135;
        }
        #[inline]
        fn solve(
            &self,
            c: &[T],
            k: usize,
            store: &mut ::ezy_core::model::SeriesStore<T>,
        ) {
            let c = ::ezy_core::kernel::array::<37usize, T>(c);
            let base = ::ezy_core::kernel::array::<16usize, T>(&store.base);
            let force = ::ezy_core::kernel::array::<6usize, T>(&store.force);
            let row = ::ezy_core::kernel::array::<3usize, T>(&store.row);
            let force_0 = force[0usize];
            let base_12 = base[12usize];
            let base_13 = base[13usize];
            let product_4 = c[18usize] * force_0;
            let base_11 = base[11usize];
            let force_5 = force[5usize];
            let product_8 = force_5 * c[23usize];
            let base_10 = base[10usize];
            let force_4 = force[4usize];
            let product_11 = base_10 * force_4;
            let force_3 = force[3usize];
            let difference_14 = T::fused(-base_11, force_3, product_11);
            let product_16 = difference_14 * c[22usize];
            let sum_19 = T::fused(force_5, c[25usize], product_16);
            let row_2 = row[2usize];
            let right_side_front = sum_19 - row_2;
            let sum_24 = T::fused(right_side_front, c[15usize], product_8);
            let difference_26 = T::fused(-base_11, sum_24, product_4);
            let difference_28 = T::fused(-force_3, c[22usize], difference_26);
            let row_0 = row[0usize];
            let difference_30 = difference_28 - row_0;
            let base_2 = base[2usize];
            let force_2 = force[2usize];
            let product_34 = c[19usize] * force_2;
            let difference_36 = T::fused(-base_2, product_34, difference_30);
            let product_37 = base_13 * difference_36;
            let base_14 = base[14usize];
            let product_39 = base_10 * sum_24;
            let force_1 = force[1usize];
            let sum_42 = T::fused(c[18usize], force_1, product_39);
            let difference_44 = T::fused(-force_4, c[22usize], sum_42);
            let row_1 = row[1usize];
            let difference_46 = difference_44 - row_1;
            let base_0 = base[0usize];
            let sum_49 = T::fused(product_34, base_0, difference_46);
            let difference_51 = T::fused(-base_14, sum_49, product_37);
            let lambda_B_x = base_12 * difference_51;
            let difference_53 = force_0 - lambda_B_x;
            let product_54 = c[18usize] * difference_53;
            let base_15 = base[15usize];
            let product_56 = sum_49 * base_15;
            let difference_58 = T::fused(-difference_36, base_14, product_56);
            let lambda_B_y = base_12 * difference_58;
            let difference_60 = force_1 - lambda_B_y;
            let product_61 = c[18usize] * difference_60;
            let product_62 = base_2 * lambda_B_x;
            let difference_64 = T::fused(-base_0, lambda_B_y, product_62);
            let product_65 = c[19usize] * difference_64;
            let sum_68 = T::fused(force_2, c[21usize], product_65);
            let sum_69 = force_3 + lambda_B_x;
            let product_70 = base_10 * lambda_B_y;
            let difference_72 = T::fused(-base_11, lambda_B_x, product_70);
            let product_73 = c[15usize] * difference_72;
            let lambda_front = T::fused(right_side_front, c[20usize], product_73);
            let sum_78 = T::fused(base_11, lambda_front, sum_69);
            let product_79 = c[22usize] * sum_78;
            let sum_80 = force_4 + lambda_B_y;
            let difference_82 = T::fused(-base_10, lambda_front, sum_80);
            let product_83 = c[22usize] * difference_82;
            let product_85 = force_5 * c[29usize];
            let difference_87 = T::fused(-c[23usize], difference_72, product_85);
            let difference_89 = T::fused(-c[25usize], lambda_front, difference_87);
            let target = ::ezy_core::kernel::array_mut::<6usize, T>(&mut store.a);
            target[0usize] = product_54;
            target[1usize] = product_61;
            target[2usize] = sum_68;
            target[3usize] = product_79;
            target[4usize] = product_83;
            target[5usize] = difference_89;
            let target = ::ezy_core::kernel::row_mut::<
                3usize,
                T,
            >(&mut store.lambda, k + 0usize);
            target[0usize] = lambda_B_x;
            target[1usize] = lambda_B_y;
            target[2usize] = lambda_front;
        }
        #[inline]
        fn finish(
            &self,
            c: &[T],
            k: usize,
            store: &mut ::ezy_core::model::SeriesStore<T>,
        ) {
            let c = ::ezy_core::kernel::array::<37usize, T>(c);
            let a = ::ezy_core::kernel::array::<6usize, T>(&store.a);
            let base = ::ezy_core::kernel::array::<16usize, T>(&store.base);
            let kept_1 = ::ezy_core::kernel::row::<5usize, T>(&store.kept, k + 1usize);
            let lambda_0 = ::ezy_core::kernel::row::<
                3usize,
                T,
            >(&store.lambda, k + 0usize);
            let sums = ::ezy_core::kernel::array::<24usize, T>(&store.sums);
            let a_0 = a[0usize];
            let inverse_order_next = T::from_f64(1f64)
                / T::from_f64((k + 1usize) as f64);
            let inverse_order_ahead = T::from_f64(1f64)
                / T::from_f64((k + 2usize) as f64);
            let product_3 = inverse_order_next * inverse_order_ahead;
            let product_4 = a_0 * product_3;
            let a_1 = a[1usize];
            let product_6 = product_3 * a_1;
            let a_2 = a[2usize];
            let product_8 = product_3 * a_2;
            let a_3 = a[3usize];
            let product_10 = product_3 * a_3;
            let a_4 = a[4usize];
            let product_12 = product_3 * a_4;
            let a_5 = a[5usize];
            let product_14 = product_3 * a_5;
            let lambda_0 = lambda_0[0usize];
            let convolved_19 = sums[19usize];
            let product_19 = inverse_order_ahead * convolved_19;
            let base_0 = base[0usize];
            let sum_22 = T::fused(product_8, base_0, product_19);
            let lambda_1 = lambda_0[1usize];
            let convolved_17 = sums[17usize];
            let product_25 = inverse_order_ahead * convolved_17;
            let base_2 = base[2usize];
            let sum_28 = T::fused(product_8, base_2, product_25);
            let lambda_2 = lambda_0[2usize];
            let convolved_20 = sums[20usize];
            let product_31 = inverse_order_ahead * convolved_20;
            let base_10 = base[10usize];
            let sum_34 = T::fused(product_14, base_10, product_31);
            let convolved_18 = sums[18usize];
            let product_36 = inverse_order_ahead * convolved_18;
            let base_11 = base[11usize];
            let sum_39 = T::fused(product_14, base_11, product_36);
            let order_ahead = T::from_f64((k + 2usize) as f64);
            let product_41 = product_8 * order_ahead;
            let product_42 = product_14 * order_ahead;
            let product_43 = product_10 * order_ahead;
            let product_44 = product_12 * order_ahead;
            let kept_3_next = kept_1[3usize];
            let product_48 = inverse_order_ahead * c[7usize];
            let product_49 = kept_3_next * product_48;
            let product_50 = c[6usize] * product_49;
            let kept_4_next = kept_1[4usize];
            let product_52 = product_48 * kept_4_next;
            let value_53 = -sum_28;
            let value_54 = -sum_39;
            let value_55 = -product_50;
            let value_56 = -product_49;
            let target = ::ezy_core::kernel::row_mut::<
                5usize,
                T,
            >(&mut store.kept, k + 2usize);
            target[0usize] = value_53;
            target[1usize] = sum_22;
            target[2usize] = value_55;
            target[3usize] = product_52;
            target[4usize] = value_56;
            let target = ::ezy_core::kernel::row_mut::<
                24usize,
                T,
            >(&mut store.left, k + 2usize);
            target[11usize] = sum_22;
            target[12usize] = value_53;
            target[13usize] = sum_34;
            target[14usize] = value_54;
            target[15usize] = sum_34;
            target[16usize] = value_54;
            target[17usize] = product_41;
            target[18usize] = product_42;
            target[19usize] = product_41;
            target[20usize] = product_42;
            target[21usize] = sum_34;
            target[22usize] = value_54;
            let target = ::ezy_core::kernel::row_mut::<
                6usize,
                T,
            >(&mut store.q, k + 2usize);
            target[0usize] = product_4;
            target[1usize] = product_6;
            target[2usize] = product_8;
            target[3usize] = product_10;
            target[4usize] = product_12;
            target[5usize] = product_14;
            let target = ::ezy_core::kernel::row_mut::<
                24usize,
                T,
            >(&mut store.right, k + 2usize);
            target[11usize] = lambda_0;
            target[12usize] = lambda_1;
            target[13usize] = lambda_2;
            target[14usize] = lambda_2;
            target[15usize] = lambda_0;
            target[16usize] = lambda_1;
            target[17usize] = sum_22;
            target[18usize] = sum_34;
            target[19usize] = value_53;
            target[20usize] = value_54;
            target[21usize] = product_43;
            target[22usize] = product_44;
        }
    }
    ///At 1 m/s with the bar across, in the hands of a rider: set `torque`.
    ///
    ///Cost of the accelerations and multipliers: 62 mul, 32 add, 1 div, 2 sin–cos.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct Ridden {
        ///rear wheel A, behind the seat's centre of mass (m); default `0.2`.
        pub a: f64,
        ///hinge B, ahead of the seat's centre of mass (m); default `0.6`.
        pub b: f64,
        ///front wheel C, beyond the bar's centre of mass (m); default `0.1`.
        pub c: f64,
        ///bar's centre of mass, beyond the hinge (m); default `0.1`.
        pub d: f64,
        ///mass of seat and rider (kg); default `46.0`.
        pub m1: f64,
        ///moment of inertia of seat and rider (kg*m^2); default `10.0`.
        pub i1: f64,
        ///mass of the bar (kg); default `1.0`.
        pub m2: f64,
        ///moment of inertia of the bar (kg*m^2); default `0.005`.
        pub i2: f64,
    }
    impl ::core::default::Default for Ridden {
        fn default() -> Self {
            Self {
                a: 0.2f64,
                b: 0.6f64,
                c: 0.1f64,
                d: 0.1f64,
                m1: 46f64,
                i1: 10f64,
                m2: 1f64,
                i2: 0.005f64,
            }
        }
    }
    impl Ridden {
        /// What is known of the scene when it is compiled.
        pub const INFO: ::ezy_core::model::SceneInfo = ::ezy_core::model::SceneInfo {
            model: "EzyRoller",
            name: "ridden",
            documentation: "At 1 m/s with the bar across, in the hands of a rider: set `torque`.",
            bodies: &["seat", "bar"],
            coordinates: &[
                ::ezy_core::model::CoordinateInfo {
                    name: "seat.x",
                    velocity_name: "seat.vx",
                    unit: "m",
                    symbol: ::ezy_core::model::Formula {
                        text: "seat.x",
                        latex: "x_{\\mathrm{seat}}",
                        mathml: "<msub><mi>x</mi><mtext>seat</mtext></msub>",
                    },
                    velocity_symbol: ::ezy_core::model::Formula {
                        text: "seat.vx",
                        latex: "\\dot{x}_{\\mathrm{seat}}",
                        mathml: "<msub><mover><mi>x</mi><mo>.</mo></mover><mtext>seat</mtext></msub>",
                    },
                },
                ::ezy_core::model::CoordinateInfo {
                    name: "seat.y",
                    velocity_name: "seat.vy",
                    unit: "m",
                    symbol: ::ezy_core::model::Formula {
                        text: "seat.y",
                        latex: "y_{\\mathrm{seat}}",
                        mathml: "<msub><mi>y</mi><mtext>seat</mtext></msub>",
                    },
                    velocity_symbol: ::ezy_core::model::Formula {
                        text: "seat.vy",
                        latex: "\\dot{y}_{\\mathrm{seat}}",
                        mathml: "<msub><mover><mi>y</mi><mo>.</mo></mover><mtext>seat</mtext></msub>",
                    },
                },
                ::ezy_core::model::CoordinateInfo {
                    name: "seat.phi",
                    velocity_name: "seat.omega",
                    unit: "rad",
                    symbol: ::ezy_core::model::Formula {
                        text: "seat.phi",
                        latex: "\\varphi_{\\mathrm{seat}}",
                        mathml: "<msub><mi>φ</mi><mtext>seat</mtext></msub>",
                    },
                    velocity_symbol: ::ezy_core::model::Formula {
                        text: "seat.omega",
                        latex: "\\dot{\\varphi}_{\\mathrm{seat}}",
                        mathml: "<msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext></msub>",
                    },
                },
                ::ezy_core::model::CoordinateInfo {
                    name: "bar.x",
                    velocity_name: "bar.vx",
                    unit: "m",
                    symbol: ::ezy_core::model::Formula {
                        text: "bar.x",
                        latex: "x_{\\mathrm{bar}}",
                        mathml: "<msub><mi>x</mi><mtext>bar</mtext></msub>",
                    },
                    velocity_symbol: ::ezy_core::model::Formula {
                        text: "bar.vx",
                        latex: "\\dot{x}_{\\mathrm{bar}}",
                        mathml: "<msub><mover><mi>x</mi><mo>.</mo></mover><mtext>bar</mtext></msub>",
                    },
                },
                ::ezy_core::model::CoordinateInfo {
                    name: "bar.y",
                    velocity_name: "bar.vy",
                    unit: "m",
                    symbol: ::ezy_core::model::Formula {
                        text: "bar.y",
                        latex: "y_{\\mathrm{bar}}",
                        mathml: "<msub><mi>y</mi><mtext>bar</mtext></msub>",
                    },
                    velocity_symbol: ::ezy_core::model::Formula {
                        text: "bar.vy",
                        latex: "\\dot{y}_{\\mathrm{bar}}",
                        mathml: "<msub><mover><mi>y</mi><mo>.</mo></mover><mtext>bar</mtext></msub>",
                    },
                },
                ::ezy_core::model::CoordinateInfo {
                    name: "bar.phi",
                    velocity_name: "bar.omega",
                    unit: "rad",
                    symbol: ::ezy_core::model::Formula {
                        text: "bar.phi",
                        latex: "\\varphi_{\\mathrm{bar}}",
                        mathml: "<msub><mi>φ</mi><mtext>bar</mtext></msub>",
                    },
                    velocity_symbol: ::ezy_core::model::Formula {
                        text: "bar.omega",
                        latex: "\\dot{\\varphi}_{\\mathrm{bar}}",
                        mathml: "<msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext></msub>",
                    },
                },
            ],
            points: &[
                ::ezy_core::model::PointInfo {
                    name: "A",
                    body: ::core::option::Option::Some(0usize),
                    position: ::core::option::Option::Some([
                        ::ezy_core::model::Formula {
                            text: "seat.x - a*cos(seat.phi)",
                            latex: "x_{\\mathrm{seat}} - a \\, \\cos{\\varphi_{\\mathrm{seat}}}",
                            mathml: "<mrow><msub><mi>x</mi><mtext>seat</mtext></msub><mo>−</mo><mi>a</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                        },
                        ::ezy_core::model::Formula {
                            text: "seat.y - a*sin(seat.phi)",
                            latex: "y_{\\mathrm{seat}} - a \\, \\sin{\\varphi_{\\mathrm{seat}}}",
                            mathml: "<mrow><msub><mi>y</mi><mtext>seat</mtext></msub><mo>−</mo><mi>a</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                        },
                    ]),
                },
                ::ezy_core::model::PointInfo {
                    name: "C",
                    body: ::core::option::Option::Some(1usize),
                    position: ::core::option::Option::Some([
                        ::ezy_core::model::Formula {
                            text: "bar.x + c*cos(bar.phi)",
                            latex: "x_{\\mathrm{bar}} + c \\, \\cos{\\varphi_{\\mathrm{bar}}}",
                            mathml: "<mrow><msub><mi>x</mi><mtext>bar</mtext></msub><mo>+</mo><mi>c</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                        },
                        ::ezy_core::model::Formula {
                            text: "bar.y + c*sin(bar.phi)",
                            latex: "y_{\\mathrm{bar}} + c \\, \\sin{\\varphi_{\\mathrm{bar}}}",
                            mathml: "<mrow><msub><mi>y</mi><mtext>bar</mtext></msub><mo>+</mo><mi>c</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                        },
                    ]),
                },
                ::ezy_core::model::PointInfo {
                    name: "B",
                    body: ::core::option::Option::Some(0usize),
                    position: ::core::option::Option::Some([
                        ::ezy_core::model::Formula {
                            text: "seat.x + b*cos(seat.phi)",
                            latex: "x_{\\mathrm{seat}} + b \\, \\cos{\\varphi_{\\mathrm{seat}}}",
                            mathml: "<mrow><msub><mi>x</mi><mtext>seat</mtext></msub><mo>+</mo><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                        },
                        ::ezy_core::model::Formula {
                            text: "seat.y + b*sin(seat.phi)",
                            latex: "y_{\\mathrm{seat}} + b \\, \\sin{\\varphi_{\\mathrm{seat}}}",
                            mathml: "<mrow><msub><mi>y</mi><mtext>seat</mtext></msub><mo>+</mo><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                        },
                    ]),
                },
            ],
            rows: &[
                ::ezy_core::model::RowInfo {
                    name: "B.x",
                    kind: "hinge",
                    multiplier_unit: "N",
                    constraint: ::ezy_core::model::Formula {
                        text: "seat.x + b*cos(seat.phi) - bar.x + d*cos(bar.phi)",
                        latex: "x_{\\mathrm{seat}} + b \\, \\cos{\\varphi_{\\mathrm{seat}}} - x_{\\mathrm{bar}} + d \\, \\cos{\\varphi_{\\mathrm{bar}}}",
                        mathml: "<mrow><msub><mi>x</mi><mtext>seat</mtext></msub><mo>+</mo><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>−</mo><msub><mi>x</mi><mtext>bar</mtext></msub><mo>+</mo><mi>d</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                    },
                    convective_term: ::ezy_core::model::Formula {
                        text: "-b*seat.omega^2*cos(seat.phi) - d*bar.omega^2*cos(bar.phi)",
                        latex: "-b \\, \\dot{\\varphi}_{\\mathrm{seat}}^{2} \\, \\cos{\\varphi_{\\mathrm{seat}}} - d \\, \\dot{\\varphi}_{\\mathrm{bar}}^{2} \\, \\cos{\\varphi_{\\mathrm{bar}}}",
                        mathml: "<mrow><mo>−</mo><mi>b</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>−</mo><mi>d</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                    },
                },
                ::ezy_core::model::RowInfo {
                    name: "B.y",
                    kind: "hinge",
                    multiplier_unit: "N",
                    constraint: ::ezy_core::model::Formula {
                        text: "seat.y + b*sin(seat.phi) - bar.y + d*sin(bar.phi)",
                        latex: "y_{\\mathrm{seat}} + b \\, \\sin{\\varphi_{\\mathrm{seat}}} - y_{\\mathrm{bar}} + d \\, \\sin{\\varphi_{\\mathrm{bar}}}",
                        mathml: "<mrow><msub><mi>y</mi><mtext>seat</mtext></msub><mo>+</mo><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>−</mo><msub><mi>y</mi><mtext>bar</mtext></msub><mo>+</mo><mi>d</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                    },
                    convective_term: ::ezy_core::model::Formula {
                        text: "-b*seat.omega^2*sin(seat.phi) - d*bar.omega^2*sin(bar.phi)",
                        latex: "-b \\, \\dot{\\varphi}_{\\mathrm{seat}}^{2} \\, \\sin{\\varphi_{\\mathrm{seat}}} - d \\, \\dot{\\varphi}_{\\mathrm{bar}}^{2} \\, \\sin{\\varphi_{\\mathrm{bar}}}",
                        mathml: "<mrow><mo>−</mo><mi>b</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>−</mo><mi>d</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                    },
                },
                ::ezy_core::model::RowInfo {
                    name: "rear",
                    kind: "skate",
                    multiplier_unit: "N",
                    constraint: ::ezy_core::model::Formula {
                        text: "-a*seat.omega - seat.vx*sin(seat.phi) + seat.vy*cos(seat.phi)",
                        latex: "-a \\, \\dot{\\varphi}_{\\mathrm{seat}} - \\dot{x}_{\\mathrm{seat}} \\, \\sin{\\varphi_{\\mathrm{seat}}} + \\dot{y}_{\\mathrm{seat}} \\, \\cos{\\varphi_{\\mathrm{seat}}}",
                        mathml: "<mrow><mo>−</mo><mi>a</mi><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mo>−</mo><msub><mover><mi>x</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>+</mo><msub><mover><mi>y</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                    },
                    convective_term: ::ezy_core::model::Formula {
                        text: "-seat.vx*seat.omega*cos(seat.phi) - seat.vy*seat.omega*sin(seat.phi)",
                        latex: "-\\dot{x}_{\\mathrm{seat}} \\, \\dot{\\varphi}_{\\mathrm{seat}} \\, \\cos{\\varphi_{\\mathrm{seat}}} - \\dot{y}_{\\mathrm{seat}} \\, \\dot{\\varphi}_{\\mathrm{seat}} \\, \\sin{\\varphi_{\\mathrm{seat}}}",
                        mathml: "<mrow><mo>−</mo><msub><mover><mi>x</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>−</mo><msub><mover><mi>y</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                    },
                },
                ::ezy_core::model::RowInfo {
                    name: "front",
                    kind: "skate",
                    multiplier_unit: "N",
                    constraint: ::ezy_core::model::Formula {
                        text: "c*bar.omega - bar.vx*sin(bar.phi) + bar.vy*cos(bar.phi)",
                        latex: "c \\, \\dot{\\varphi}_{\\mathrm{bar}} - \\dot{x}_{\\mathrm{bar}} \\, \\sin{\\varphi_{\\mathrm{bar}}} + \\dot{y}_{\\mathrm{bar}} \\, \\cos{\\varphi_{\\mathrm{bar}}}",
                        mathml: "<mrow><mi>c</mi><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mo>−</mo><msub><mover><mi>x</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow><mo>+</mo><msub><mover><mi>y</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                    },
                    convective_term: ::ezy_core::model::Formula {
                        text: "-bar.vx*bar.omega*cos(bar.phi) - bar.vy*bar.omega*sin(bar.phi)",
                        latex: "-\\dot{x}_{\\mathrm{bar}} \\, \\dot{\\varphi}_{\\mathrm{bar}} \\, \\cos{\\varphi_{\\mathrm{bar}}} - \\dot{y}_{\\mathrm{bar}} \\, \\dot{\\varphi}_{\\mathrm{bar}} \\, \\sin{\\varphi_{\\mathrm{bar}}}",
                        mathml: "<mrow><mo>−</mo><msub><mover><mi>x</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow><mo>−</mo><msub><mover><mi>y</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                    },
                },
            ],
            n_position_rows: 2usize,
            parameters: &[
                ::ezy_core::model::ParameterInfo {
                    name: "a",
                    unit: "m",
                    default: 0.2f64,
                    default_text: "0.2",
                    documentation: "rear wheel A, behind the seat's centre of mass",
                    effect: ::core::option::Option::None,
                    symbol: ::ezy_core::model::Formula {
                        text: "a",
                        latex: "a",
                        mathml: "<mi>a</mi>",
                    },
                },
                ::ezy_core::model::ParameterInfo {
                    name: "b",
                    unit: "m",
                    default: 0.6f64,
                    default_text: "0.6",
                    documentation: "hinge B, ahead of the seat's centre of mass",
                    effect: ::core::option::Option::None,
                    symbol: ::ezy_core::model::Formula {
                        text: "b",
                        latex: "b",
                        mathml: "<mi>b</mi>",
                    },
                },
                ::ezy_core::model::ParameterInfo {
                    name: "c",
                    unit: "m",
                    default: 0.1f64,
                    default_text: "0.1",
                    documentation: "front wheel C, beyond the bar's centre of mass",
                    effect: ::core::option::Option::None,
                    symbol: ::ezy_core::model::Formula {
                        text: "c",
                        latex: "c",
                        mathml: "<mi>c</mi>",
                    },
                },
                ::ezy_core::model::ParameterInfo {
                    name: "d",
                    unit: "m",
                    default: 0.1f64,
                    default_text: "0.1",
                    documentation: "bar's centre of mass, beyond the hinge",
                    effect: ::core::option::Option::None,
                    symbol: ::ezy_core::model::Formula {
                        text: "d",
                        latex: "d",
                        mathml: "<mi>d</mi>",
                    },
                },
                ::ezy_core::model::ParameterInfo {
                    name: "m1",
                    unit: "kg",
                    default: 46f64,
                    default_text: "46.0",
                    documentation: "mass of seat and rider",
                    effect: ::core::option::Option::None,
                    symbol: ::ezy_core::model::Formula {
                        text: "m1",
                        latex: "m_{1}",
                        mathml: "<msub><mi>m</mi><mtext>1</mtext></msub>",
                    },
                },
                ::ezy_core::model::ParameterInfo {
                    name: "i1",
                    unit: "kg*m^2",
                    default: 10f64,
                    default_text: "10.0",
                    documentation: "moment of inertia of seat and rider",
                    effect: ::core::option::Option::None,
                    symbol: ::ezy_core::model::Formula {
                        text: "i1",
                        latex: "i_{1}",
                        mathml: "<msub><mi>i</mi><mtext>1</mtext></msub>",
                    },
                },
                ::ezy_core::model::ParameterInfo {
                    name: "m2",
                    unit: "kg",
                    default: 1f64,
                    default_text: "1.0",
                    documentation: "mass of the bar",
                    effect: ::core::option::Option::None,
                    symbol: ::ezy_core::model::Formula {
                        text: "m2",
                        latex: "m_{2}",
                        mathml: "<msub><mi>m</mi><mtext>2</mtext></msub>",
                    },
                },
                ::ezy_core::model::ParameterInfo {
                    name: "i2",
                    unit: "kg*m^2",
                    default: 0.005f64,
                    default_text: "0.005",
                    documentation: "moment of inertia of the bar",
                    effect: ::core::option::Option::None,
                    symbol: ::ezy_core::model::Formula {
                        text: "i2",
                        latex: "i_{2}",
                        mathml: "<msub><mi>i</mi><mtext>2</mtext></msub>",
                    },
                },
            ],
            inputs: &[
                ::ezy_core::model::InputInfo {
                    name: "torque",
                    unit: "N*m",
                    default: 0f64,
                    default_text: "0.0",
                    documentation: "torque that opens the hinge",
                    effect: ::core::option::Option::Some("rider"),
                    symbol: ::ezy_core::model::Formula {
                        text: "torque",
                        latex: "\\mathrm{torque}",
                        mathml: "<mi>torque</mi>",
                    },
                },
            ],
            outputs: &[
                ::ezy_core::model::OutputInfo {
                    name: "steering",
                    unit: "deg",
                    documentation: "how far the bar is turned against the seat",
                    formula: ::ezy_core::model::Formula {
                        text: "-180*seat.phi/pi + 180*bar.phi/pi",
                        latex: "-\\frac{180 \\, \\varphi_{\\mathrm{seat}}}{\\pi} + \\frac{180 \\, \\varphi_{\\mathrm{bar}}}{\\pi}",
                        mathml: "<mrow><mo>−</mo><mfrac><mrow><mn>180</mn><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mrow><mi>π</mi></mrow></mfrac><mo>+</mo><mfrac><mrow><mn>180</mn><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow><mrow><mi>π</mi></mrow></mfrac></mrow>",
                    },
                },
                ::ezy_core::model::OutputInfo {
                    name: "speed",
                    unit: "m/s",
                    documentation: "",
                    formula: ::ezy_core::model::Formula {
                        text: "seat.vx*cos(seat.phi) + seat.vy*sin(seat.phi)",
                        latex: "\\dot{x}_{\\mathrm{seat}} \\, \\cos{\\varphi_{\\mathrm{seat}}} + \\dot{y}_{\\mathrm{seat}} \\, \\sin{\\varphi_{\\mathrm{seat}}}",
                        mathml: "<mrow><msub><mover><mi>x</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>+</mo><msub><mover><mi>y</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                    },
                },
            ],
            effects: &[
                ::ezy_core::model::EffectInfo {
                    name: "rider",
                    documentation: "The rider's arms, moved by whoever runs the scene.",
                },
            ],
            until_s: 10f64,
            n_constants: 31usize,
            jacobian: ::ezy_core::model::SparsityPattern {
                starts: &[0usize, 4usize, 8usize, 11usize, 14usize],
                columns: &[
                    0usize, 2usize, 3usize, 5usize, 1usize, 2usize, 4usize, 5usize,
                    0usize, 1usize, 2usize, 3usize, 4usize, 5usize,
                ],
            },
            jacobian_entries: &[
                ::ezy_core::model::Formula {
                    text: "1",
                    latex: "1",
                    mathml: "<mrow><mn>1</mn></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "-b*sin(seat.phi)",
                    latex: "-b \\, \\sin{\\varphi_{\\mathrm{seat}}}",
                    mathml: "<mrow><mo>−</mo><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "-1",
                    latex: "-1",
                    mathml: "<mrow><mo>−</mo><mn>1</mn></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "-d*sin(bar.phi)",
                    latex: "-d \\, \\sin{\\varphi_{\\mathrm{bar}}}",
                    mathml: "<mrow><mo>−</mo><mi>d</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "1",
                    latex: "1",
                    mathml: "<mrow><mn>1</mn></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "b*cos(seat.phi)",
                    latex: "b \\, \\cos{\\varphi_{\\mathrm{seat}}}",
                    mathml: "<mrow><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "-1",
                    latex: "-1",
                    mathml: "<mrow><mo>−</mo><mn>1</mn></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "d*cos(bar.phi)",
                    latex: "d \\, \\cos{\\varphi_{\\mathrm{bar}}}",
                    mathml: "<mrow><mi>d</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "-sin(seat.phi)",
                    latex: "-\\sin{\\varphi_{\\mathrm{seat}}}",
                    mathml: "<mrow><mo>−</mo><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "cos(seat.phi)",
                    latex: "\\cos{\\varphi_{\\mathrm{seat}}}",
                    mathml: "<mrow><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "-a",
                    latex: "-a",
                    mathml: "<mrow><mo>−</mo><mi>a</mi></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "-sin(bar.phi)",
                    latex: "-\\sin{\\varphi_{\\mathrm{bar}}}",
                    mathml: "<mrow><mo>−</mo><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "cos(bar.phi)",
                    latex: "\\cos{\\varphi_{\\mathrm{bar}}}",
                    mathml: "<mrow><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "c",
                    latex: "c",
                    mathml: "<mrow><mi>c</mi></mrow>",
                },
            ],
            mass_entries: &[
                ::ezy_core::model::Formula {
                    text: "m1",
                    latex: "m_{1}",
                    mathml: "<mrow><msub><mi>m</mi><mtext>1</mtext></msub></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "m1",
                    latex: "m_{1}",
                    mathml: "<mrow><msub><mi>m</mi><mtext>1</mtext></msub></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "i1",
                    latex: "i_{1}",
                    mathml: "<mrow><msub><mi>i</mi><mtext>1</mtext></msub></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "m2",
                    latex: "m_{2}",
                    mathml: "<mrow><msub><mi>m</mi><mtext>2</mtext></msub></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "m2",
                    latex: "m_{2}",
                    mathml: "<mrow><msub><mi>m</mi><mtext>2</mtext></msub></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "i2",
                    latex: "i_{2}",
                    mathml: "<mrow><msub><mi>i</mi><mtext>2</mtext></msub></mrow>",
                },
            ],
            force_entries: &[
                ::ezy_core::model::Formula {
                    text: "0",
                    latex: "0",
                    mathml: "<mrow><mn>0</mn></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "0",
                    latex: "0",
                    mathml: "<mrow><mn>0</mn></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "-torque",
                    latex: "-\\mathrm{torque}",
                    mathml: "<mrow><mo>−</mo><mi>torque</mi></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "0",
                    latex: "0",
                    mathml: "<mrow><mn>0</mn></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "0",
                    latex: "0",
                    mathml: "<mrow><mn>0</mn></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "torque",
                    latex: "\\mathrm{torque}",
                    mathml: "<mrow><mi>torque</mi></mrow>",
                },
            ],
            potential_energy: ::ezy_core::model::Formula {
                text: "0",
                latex: "0",
                mathml: "<mrow><mn>0</mn></mrow>",
            },
            abbreviations: &[],
            elimination: &[
                ::ezy_core::model::EliminationStep {
                    rows: &[2usize],
                    constant_pivot: true,
                },
                ::ezy_core::model::EliminationStep {
                    rows: &[3usize],
                    constant_pivot: true,
                },
                ::ezy_core::model::EliminationStep {
                    rows: &[0usize, 1usize],
                    constant_pivot: false,
                },
            ],
            acceleration_operations: ::ezy_core::model::Operations {
                add: 32usize,
                mul: 62usize,
                div: 1usize,
                trig: 2usize,
                calls: 0usize,
            },
            correction_operations: ::ezy_core::model::Operations {
                add: 23usize,
                mul: 42usize,
                div: 1usize,
                trig: 2usize,
                calls: 0usize,
            },
            series: ::ezy_core::model::SeriesInfo::Analytic {
                n_products: 16usize,
                operations: ::ezy_core::model::Operations {
                    add: 49usize,
                    mul: 86usize,
                    div: 0usize,
                    trig: 0usize,
                    calls: 0usize,
                },
            },
            repeats: ::core::option::Option::None,
        };
    }
    #[automatically_derived]
    impl<T: ::ezy_core::scalar::Scalar> ::ezy_core::model::Equations<T>
    for self::Ridden {
        fn constants(&self, parameters: &[T], c: &mut [T]) {
            let parameters = ::ezy_core::kernel::array::<8usize, T>(parameters);
            let c = ::ezy_core::kernel::array_mut::<32usize, T>(c);
            let k1 = T::from_f64(1f64);
            let parameter_m1 = parameters[4usize];
            let parameter_i1 = parameters[5usize];
            let parameter_m2 = parameters[6usize];
            let parameter_i2 = parameters[7usize];
            let parameter_b = parameters[1usize];
            let parameter_d = parameters[3usize];
            let parameter_a = parameters[0usize];
            let parameter_c = parameters[2usize];
            let k11 = T::PI;
            let k12 = T::from_f64(2f64);
            let k13 = k11 / k12;
            let k14 = T::from_f64(180f64);
            let k16 = k14 / k11;
            let k17 = k1 / parameter_m1;
            let k18 = k1 / parameter_i1;
            let k19 = parameter_b * k18;
            let k20 = k1 / parameter_m2;
            let k21 = k1 / parameter_i2;
            let k22 = parameter_d * k21;
            let k23 = parameter_a * k18;
            let k24 = parameter_c * k21;
            let k25 = parameter_b * parameter_b;
            let k26 = k25 * k18;
            let k27 = parameter_d * parameter_d;
            let k28 = k27 * k21;
            let k29 = k17 + k26;
            let k30 = k29 + k20;
            let k31 = k30 + k28;
            let k32 = parameter_b * parameter_a;
            let k33 = k32 * k18;
            let k34 = k33 - k17;
            let k35 = parameter_d * parameter_c;
            let k36 = k35 * k21;
            let k37 = k20 - k36;
            let k38 = k17 + k20;
            let k39 = parameter_a * parameter_a;
            let k40 = k39 * k18;
            let k41 = k17 + k40;
            let k42 = parameter_c * parameter_c;
            let k43 = k42 * k21;
            let k44 = k20 + k43;
            let k45 = k1 / k41;
            let k46 = k34 * k45;
            let k47 = k46 * k34;
            let k48 = k31 - k47;
            let k49 = k47 - k26;
            let k50 = k1 / k44;
            let k51 = k37 * k50;
            let k52 = k51 * k37;
            let k53 = k48 - k52;
            let k54 = k52 - k28;
            let k55 = T::from_f64(0.0000000001f64);
            let k56 = k55 * k41;
            let k57 = k55 * k44;
            let k58 = k31 + k38;
            let k59 = k58 * k58;
            let k60 = k55 * k59;
            c[1usize] = k23;
            c[2usize] = k24;
            c[3usize] = k49;
            c[4usize] = k54;
            c[5usize] = k53;
            c[6usize] = k38;
            c[7usize] = k19;
            c[8usize] = k46;
            c[9usize] = k22;
            c[10usize] = k51;
            c[11usize] = parameter_b;
            c[12usize] = parameter_d;
            c[13usize] = k50;
            c[14usize] = k45;
            c[15usize] = k17;
            c[16usize] = k18;
            c[17usize] = k20;
            c[18usize] = k21;
            c[19usize] = k41;
            c[20usize] = k56;
            c[21usize] = k44;
            c[22usize] = k57;
            c[23usize] = k60;
            c[24usize] = parameter_m1;
            c[25usize] = parameter_i1;
            c[26usize] = parameter_m2;
            c[27usize] = parameter_i2;
            c[28usize] = parameter_a;
            c[29usize] = parameter_c;
            c[30usize] = k16;
            c[31usize] = k13;
        }
        fn mass_matrix(&self, c: &[T], m: &mut [T]) {
            let c = ::ezy_core::kernel::array::<32usize, T>(c);
            let out = ::ezy_core::kernel::array_mut::<6usize, T>(m);
            out[0usize] = c[24usize];
            out[1usize] = c[24usize];
            out[2usize] = c[25usize];
            out[3usize] = c[26usize];
            out[4usize] = c[26usize];
            out[5usize] = c[27usize];
        }
        fn position_constraint(&self, c: &[T], t: T, q: &[T], out: &mut [T]) {
            let c = ::ezy_core::kernel::array::<32usize, T>(c);
            let q = ::ezy_core::kernel::array::<6usize, T>(q);
            let out = ::ezy_core::kernel::array_mut::<2usize, T>(out);
            let seat_x = q[0usize];
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let sum_7 = T::fused(c[11usize], cos_seat_phi, seat_x);
            let bar_x = q[3usize];
            let difference_9 = sum_7 - bar_x;
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
            let sum_14 = T::fused(c[12usize], cos_bar_phi, difference_9);
            let seat_y = q[1usize];
            let sum_18 = T::fused(c[11usize], sin_seat_phi, seat_y);
            let bar_y = q[4usize];
            let difference_20 = sum_18 - bar_y;
            let sum_23 = T::fused(c[12usize], sin_bar_phi, difference_20);
            out[0usize] = sum_14;
            out[1usize] = sum_23;
        }
        fn velocity_constraint(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
            let c = ::ezy_core::kernel::array::<32usize, T>(c);
            let q = ::ezy_core::kernel::array::<6usize, T>(q);
            let v = ::ezy_core::kernel::array::<6usize, T>(v);
            let out = ::ezy_core::kernel::array_mut::<4usize, T>(out);
            let seat_vx = v[0usize];
            let seat_omega = v[2usize];
            let product_5 = c[11usize] * seat_omega;
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let difference_9 = T::fused(-product_5, sin_seat_phi, seat_vx);
            let bar_vx = v[3usize];
            let difference_11 = difference_9 - bar_vx;
            let bar_omega = v[5usize];
            let product_14 = c[12usize] * bar_omega;
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
            let difference_18 = T::fused(-product_14, sin_bar_phi, difference_11);
            let seat_vy = v[1usize];
            let bar_vy = v[4usize];
            let difference_21 = seat_vy - bar_vy;
            let sum_24 = T::fused(product_5, cos_seat_phi, difference_21);
            let sum_27 = T::fused(product_14, cos_bar_phi, sum_24);
            let product_29 = seat_omega * c[28usize];
            let sum_31 = T::fused(seat_vx, sin_seat_phi, product_29);
            let difference_33 = T::fused(seat_vy, cos_seat_phi, -sum_31);
            let product_35 = bar_omega * c[29usize];
            let difference_37 = T::fused(-bar_vx, sin_bar_phi, product_35);
            let sum_39 = T::fused(bar_vy, cos_bar_phi, difference_37);
            out[0usize] = difference_18;
            out[1usize] = sum_27;
            out[2usize] = difference_33;
            out[3usize] = sum_39;
        }
        fn velocity_jacobian(&self, c: &[T], t: T, q: &[T], out: &mut [T]) {
            let c = ::ezy_core::kernel::array::<32usize, T>(c);
            let q = ::ezy_core::kernel::array::<6usize, T>(q);
            let out = ::ezy_core::kernel::array_mut::<14usize, T>(out);
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let product_4 = c[11usize] * sin_seat_phi;
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
            let product_8 = c[12usize] * sin_bar_phi;
            let product_10 = c[11usize] * cos_seat_phi;
            let product_12 = c[12usize] * cos_bar_phi;
            let value_15 = -product_4;
            let value_16 = -T::from_f64(1f64);
            let value_17 = -product_8;
            let value_18 = -sin_seat_phi;
            let value_19 = -c[28usize];
            let value_20 = -sin_bar_phi;
            out[0usize] = T::from_f64(1f64);
            out[1usize] = value_15;
            out[2usize] = value_16;
            out[3usize] = value_17;
            out[4usize] = T::from_f64(1f64);
            out[5usize] = product_10;
            out[6usize] = value_16;
            out[7usize] = product_12;
            out[8usize] = value_18;
            out[9usize] = cos_seat_phi;
            out[10usize] = value_19;
            out[11usize] = value_20;
            out[12usize] = cos_bar_phi;
            out[13usize] = c[29usize];
        }
        fn convective_term(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
            let c = ::ezy_core::kernel::array::<32usize, T>(c);
            let q = ::ezy_core::kernel::array::<6usize, T>(q);
            let v = ::ezy_core::kernel::array::<6usize, T>(v);
            let out = ::ezy_core::kernel::array_mut::<4usize, T>(out);
            let seat_omega = v[2usize];
            let product_3 = c[11usize] * seat_omega;
            let product_4 = seat_omega * product_3;
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let product_8 = product_4 * cos_seat_phi;
            let bar_omega = v[5usize];
            let product_11 = c[12usize] * bar_omega;
            let product_12 = bar_omega * product_11;
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
            let sum_16 = T::fused(product_12, cos_bar_phi, product_8);
            let product_18 = product_4 * sin_seat_phi;
            let sum_21 = T::fused(product_12, sin_bar_phi, product_18);
            let seat_vx = v[0usize];
            let product_23 = cos_seat_phi * seat_vx;
            let seat_vy = v[1usize];
            let sum_26 = T::fused(sin_seat_phi, seat_vy, product_23);
            let product_27 = seat_omega * sum_26;
            let bar_vx = v[3usize];
            let product_29 = cos_bar_phi * bar_vx;
            let bar_vy = v[4usize];
            let sum_32 = T::fused(sin_bar_phi, bar_vy, product_29);
            let product_33 = bar_omega * sum_32;
            let value_34 = -sum_16;
            let value_35 = -sum_21;
            let value_36 = -product_27;
            let value_37 = -product_33;
            out[0usize] = value_34;
            out[1usize] = value_35;
            out[2usize] = value_36;
            out[3usize] = value_37;
        }
        fn applied_force(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
            let c = ::ezy_core::kernel::array::<32usize, T>(c);
            let q = ::ezy_core::kernel::array::<6usize, T>(q);
            let v = ::ezy_core::kernel::array::<6usize, T>(v);
            let out = ::ezy_core::kernel::array_mut::<6usize, T>(out);
            let torque = c[0usize];
            let value_3 = -torque;
            out[0usize] = T::from_f64(0f64);
            out[1usize] = T::from_f64(0f64);
            out[2usize] = value_3;
            out[3usize] = T::from_f64(0f64);
            out[4usize] = T::from_f64(0f64);
            out[5usize] = torque;
        }
        #[inline]
        fn accelerations(
            &self,
            c: &[T],
            t: T,
            q: &[T],
            v: &[T],
            a: &mut [T],
            lambda: &mut [T],
        ) -> ::ezy_core::model::DeficientRows {
            let c = ::ezy_core::kernel::array::<32usize, T>(c);
            let q = ::ezy_core::kernel::array::<6usize, T>(q);
            let v = ::ezy_core::kernel::array::<6usize, T>(v);
            let a = ::ezy_core::kernel::array_mut::<6usize, T>(a);
            let lambda = ::ezy_core::kernel::array_mut::<4usize, T>(lambda);
            let seat_vx = v[0usize];
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let product_5 = seat_vx * cos_seat_phi;
            let seat_vy = v[1usize];
            let sum_9 = T::fused(seat_vy, sin_seat_phi, product_5);
            let seat_omega = v[2usize];
            let torque = c[0usize];
            let product_14 = c[1usize] * torque;
            let right_side_rear = T::fused(-sum_9, seat_omega, product_14);
            let bar_vx = v[3usize];
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
            let product_19 = bar_vx * cos_bar_phi;
            let bar_vy = v[4usize];
            let sum_23 = T::fused(bar_vy, sin_bar_phi, product_19);
            let bar_omega = v[5usize];
            let product_27 = torque * c[2usize];
            let right_side_front = T::fused(-sum_23, bar_omega, product_27);
            let product_30 = cos_seat_phi * c[3usize];
            let product_31 = cos_seat_phi * product_30;
            let product_33 = cos_bar_phi * c[4usize];
            let sum_35 = T::fused(cos_bar_phi, product_33, product_31);
            let sum_37 = sum_35 + c[5usize];
            let product_38 = sin_seat_phi * c[3usize];
            let product_39 = cos_seat_phi * product_38;
            let product_40 = sin_bar_phi * c[4usize];
            let sum_42 = T::fused(cos_bar_phi, product_40, product_39);
            let difference_44 = c[6usize] - sum_35;
            let product_46 = torque * c[7usize];
            let difference_49 = T::fused(-right_side_rear, c[8usize], product_46);
            let product_50 = sin_seat_phi * difference_49;
            let product_52 = torque * c[9usize];
            let sum_55 = T::fused(right_side_front, c[10usize], product_52);
            let difference_57 = T::fused(-sin_bar_phi, sum_55, product_50);
            let product_59 = seat_omega * c[11usize];
            let product_60 = seat_omega * product_59;
            let difference_62 = T::fused(-cos_seat_phi, product_60, difference_57);
            let product_64 = bar_omega * c[12usize];
            let product_65 = bar_omega * product_64;
            let difference_67 = T::fused(-cos_bar_phi, product_65, difference_62);
            let product_69 = cos_bar_phi * sum_55;
            let difference_70 = T::fused(-cos_seat_phi, difference_49, product_69);
            let difference_72 = T::fused(-sin_seat_phi, product_60, difference_70);
            let difference_74 = T::fused(-sin_bar_phi, product_65, difference_72);
            let product_75 = sum_37 * difference_44;
            let difference_77 = T::fused(-sum_42, sum_42, product_75);
            let quotient_78 = T::from_f64(1f64) / difference_77;
            let product_79 = difference_44 * difference_67;
            let difference_81 = T::fused(-sum_42, difference_74, product_79);
            let lambda_B_x = quotient_78 * difference_81;
            let product_84 = sum_37 * difference_74;
            let difference_85 = T::fused(-sum_42, difference_67, product_84);
            let lambda_B_y = quotient_78 * difference_85;
            let product_88 = cos_bar_phi * lambda_B_y;
            let difference_89 = T::fused(-sin_bar_phi, lambda_B_x, product_88);
            let product_90 = c[10usize] * difference_89;
            let lambda_front = T::fused(right_side_front, c[13usize], product_90);
            let product_95 = cos_seat_phi * lambda_B_y;
            let difference_96 = T::fused(-sin_seat_phi, lambda_B_x, product_95);
            let product_97 = c[8usize] * difference_96;
            let lambda_rear = T::fused(right_side_rear, c[14usize], product_97);
            let difference_102 = T::fused(sin_seat_phi, lambda_rear, -lambda_B_x);
            let product_104 = difference_102 * c[15usize];
            let sum_106 = T::fused(cos_seat_phi, lambda_rear, lambda_B_y);
            let product_107 = c[15usize] * sum_106;
            let product_108 = c[7usize] * difference_96;
            let sum_111 = T::fused(torque, c[16usize], product_108);
            let difference_113 = T::fused(c[1usize], lambda_rear, -sum_111);
            let sum_115 = T::fused(sin_bar_phi, lambda_front, lambda_B_x);
            let product_117 = sum_115 * c[17usize];
            let difference_119 = T::fused(-cos_bar_phi, lambda_front, lambda_B_y);
            let product_120 = c[17usize] * difference_119;
            let product_123 = torque * c[18usize];
            let difference_124 = T::fused(-c[9usize], difference_89, product_123);
            let difference_126 = T::fused(-c[2usize], lambda_front, difference_124);
            let value_132 = -product_107;
            a[0usize] = product_104;
            a[1usize] = value_132;
            a[2usize] = difference_113;
            a[3usize] = product_117;
            a[4usize] = product_120;
            a[5usize] = difference_126;
            lambda[0usize] = lambda_B_x;
            lambda[1usize] = lambda_B_y;
            lambda[2usize] = lambda_rear;
            lambda[3usize] = lambda_front;
            ::ezy_core::model::DeficientRows(0)
                .mark(2usize, !T::is_above(c[19usize], c[20usize]))
                .mark(3usize, !T::is_above(c[21usize], c[22usize]))
                .mark(0usize, !T::is_above(difference_77, c[23usize]))
                .mark(1usize, !T::is_above(difference_77, c[23usize]))
        }
        #[inline]
        fn correction(
            &self,
            c: &[T],
            t: T,
            q: &[T],
            residual: &[T],
            delta: &mut [T],
        ) -> ::ezy_core::model::DeficientRows {
            let c = ::ezy_core::kernel::array::<32usize, T>(c);
            let q = ::ezy_core::kernel::array::<6usize, T>(q);
            let residual = ::ezy_core::kernel::array::<4usize, T>(residual);
            let delta = ::ezy_core::kernel::array_mut::<6usize, T>(delta);
            let right_side_rear = residual[2usize];
            let right_side_front = residual[3usize];
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let product_7 = c[3usize] * cos_seat_phi;
            let product_8 = cos_seat_phi * product_7;
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
            let product_12 = c[4usize] * cos_bar_phi;
            let sum_14 = T::fused(cos_bar_phi, product_12, product_8);
            let sum_16 = sum_14 + c[5usize];
            let product_18 = c[3usize] * sin_seat_phi;
            let product_19 = cos_seat_phi * product_18;
            let product_21 = c[4usize] * sin_bar_phi;
            let sum_23 = T::fused(cos_bar_phi, product_21, product_19);
            let difference_25 = c[6usize] - sum_14;
            let residual_0 = residual[0usize];
            let product_28 = right_side_rear * c[8usize];
            let difference_30 = T::fused(-sin_seat_phi, product_28, residual_0);
            let product_32 = right_side_front * c[10usize];
            let difference_34 = T::fused(-sin_bar_phi, product_32, difference_30);
            let residual_1 = residual[1usize];
            let sum_37 = T::fused(cos_seat_phi, product_28, residual_1);
            let sum_39 = T::fused(cos_bar_phi, product_32, sum_37);
            let product_40 = sum_16 * difference_25;
            let difference_42 = T::fused(-sum_23, sum_23, product_40);
            let quotient_43 = T::from_f64(1f64) / difference_42;
            let product_44 = difference_25 * difference_34;
            let difference_46 = T::fused(-sum_23, sum_39, product_44);
            let lambda_B_x = quotient_43 * difference_46;
            let product_49 = sum_16 * sum_39;
            let difference_50 = T::fused(-sum_23, difference_34, product_49);
            let lambda_B_y = quotient_43 * difference_50;
            let product_53 = cos_bar_phi * lambda_B_y;
            let difference_54 = T::fused(-sin_bar_phi, lambda_B_x, product_53);
            let product_55 = c[10usize] * difference_54;
            let lambda_front = T::fused(right_side_front, c[13usize], product_55);
            let product_60 = cos_seat_phi * lambda_B_y;
            let difference_61 = T::fused(-sin_seat_phi, lambda_B_x, product_60);
            let product_62 = c[8usize] * difference_61;
            let lambda_rear = T::fused(right_side_rear, c[14usize], product_62);
            let difference_67 = T::fused(sin_seat_phi, lambda_rear, -lambda_B_x);
            let product_69 = difference_67 * c[15usize];
            let sum_71 = T::fused(cos_seat_phi, lambda_rear, lambda_B_y);
            let product_72 = c[15usize] * sum_71;
            let product_76 = lambda_rear * c[1usize];
            let difference_77 = T::fused(-difference_61, c[7usize], product_76);
            let sum_79 = T::fused(sin_bar_phi, lambda_front, lambda_B_x);
            let product_81 = sum_79 * c[17usize];
            let difference_83 = T::fused(-cos_bar_phi, lambda_front, lambda_B_y);
            let product_84 = c[17usize] * difference_83;
            let product_86 = difference_54 * c[9usize];
            let sum_89 = T::fused(lambda_front, c[2usize], product_86);
            let value_95 = -product_72;
            let value_96 = -sum_89;
            delta[0usize] = product_69;
            delta[1usize] = value_95;
            delta[2usize] = difference_77;
            delta[3usize] = product_81;
            delta[4usize] = product_84;
            delta[5usize] = value_96;
            ::ezy_core::model::DeficientRows(0)
                .mark(2usize, !T::is_above(c[19usize], c[20usize]))
                .mark(3usize, !T::is_above(c[21usize], c[22usize]))
                .mark(0usize, !T::is_above(difference_42, c[23usize]))
                .mark(1usize, !T::is_above(difference_42, c[23usize]))
        }
    }
    #[automatically_derived]
    impl ::ezy_core::model::Scene for Ridden {
        fn info(&self) -> &'static ::ezy_core::model::SceneInfo {
            static INFO: ::ezy_core::model::SceneInfo = Ridden::INFO;
            &INFO
        }
        fn parameter(&self, index: usize) -> f64 {
            match index {
                0usize => self.a,
                1usize => self.b,
                2usize => self.c,
                3usize => self.d,
                4usize => self.m1,
                5usize => self.i1,
                6usize => self.m2,
                7usize => self.i2,
                _ => f64::NAN,
            }
        }
        fn set_parameter(&mut self, index: usize, value: f64) {
            match index {
                0usize => self.a = value,
                1usize => self.b = value,
                2usize => self.c = value,
                3usize => self.d = value,
                4usize => self.m1 = value,
                5usize => self.i1 = value,
                6usize => self.m2 = value,
                7usize => self.i2 = value,
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
            let c = ::ezy_core::kernel::array::<32usize, f64>(c);
            let q = ::ezy_core::kernel::array::<6usize, f64>(q);
            let v = ::ezy_core::kernel::array::<6usize, f64>(v);
            let lambda = ::ezy_core::kernel::array::<4usize, f64>(lambda);
            let out = ::ezy_core::kernel::array_mut::<1usize, f64>(out);
            let seat_omega = v[2usize];
            let bar_omega = v[5usize];
            let difference_4 = bar_omega - seat_omega;
            let torque = c[0usize];
            let product_6 = difference_4 * torque;
            out[0usize] = product_6;
        }
        fn points(&self, c: &[f64], t: f64, q: &[f64], out: &mut [f64]) {
            let c = ::ezy_core::kernel::array::<32usize, f64>(c);
            let q = ::ezy_core::kernel::array::<6usize, f64>(q);
            let out = ::ezy_core::kernel::array_mut::<6usize, f64>(out);
            let seat_x = q[0usize];
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = f64::sin_cos(seat_phi);
            let product_6 = c[28usize] * cos_seat_phi;
            let difference_7 = seat_x - product_6;
            let seat_y = q[1usize];
            let product_10 = c[28usize] * sin_seat_phi;
            let difference_11 = seat_y - product_10;
            let bar_x = q[3usize];
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = f64::sin_cos(bar_phi);
            let product_16 = c[29usize] * cos_bar_phi;
            let sum_17 = bar_x + product_16;
            let bar_y = q[4usize];
            let product_20 = c[29usize] * sin_bar_phi;
            let sum_21 = bar_y + product_20;
            let product_23 = cos_seat_phi * c[11usize];
            let sum_24 = seat_x + product_23;
            let product_25 = sin_seat_phi * c[11usize];
            let sum_26 = seat_y + product_25;
            out[0usize] = difference_7;
            out[1usize] = difference_11;
            out[2usize] = sum_17;
            out[3usize] = sum_21;
            out[4usize] = sum_24;
            out[5usize] = sum_26;
        }
        fn outputs(&self, c: &[f64], t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
            let c = ::ezy_core::kernel::array::<32usize, f64>(c);
            let q = ::ezy_core::kernel::array::<6usize, f64>(q);
            let v = ::ezy_core::kernel::array::<6usize, f64>(v);
            let out = ::ezy_core::kernel::array_mut::<2usize, f64>(out);
            let seat_phi = q[2usize];
            let bar_phi = q[5usize];
            let difference_4 = bar_phi - seat_phi;
            let product_6 = difference_4 * c[30usize];
            let seat_vx = v[0usize];
            let (sin_seat_phi, cos_seat_phi) = f64::sin_cos(seat_phi);
            let product_9 = seat_vx * cos_seat_phi;
            let seat_vy = v[1usize];
            let product_12 = seat_vy * sin_seat_phi;
            let sum_13 = product_9 + product_12;
            out[0usize] = product_6;
            out[1usize] = sum_13;
        }
        fn potential_energy(&self, c: &[f64], t: f64, q: &[f64]) -> f64 {
            0f64
        }
        fn start(&self, c: &[f64], start: &mut ::ezy_core::model::Start) {
            let c = ::ezy_core::kernel::array::<32usize, f64>(c);
            start.give_position(0usize, c[28usize]);
            start.give_position(1usize, 0f64);
            start.give_position(2usize, 0f64);
            start.give_position(5usize, c[31usize]);
            start.give_velocity(0usize, 1f64);
            start.give_velocity(2usize, 0f64);
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
    impl<T: ::ezy_core::scalar::Scalar> ::ezy_core::model::Series<T> for Ridden {
        fn series_size(&self) -> ::ezy_core::model::SeriesSize {
            ::ezy_core::model::SeriesSize {
                n_coordinates: 6usize,
                n_rows: 4usize,
                n_products: 16usize,
                n_base: 8usize,
                n_kept: 0usize,
            }
        }
        fn begin(
            &self,
            c: &[T],
            t: T,
            store: &mut ::ezy_core::model::SeriesStore<T>,
        ) -> ::ezy_core::model::DeficientRows {
            let c = ::ezy_core::kernel::array::<32usize, T>(c);
            let q = ::ezy_core::kernel::row::<6usize, T>(&store.q, 0);
            let v = ::ezy_core::kernel::row::<6usize, T>(&store.q, 1);
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
            let seat_omega = v[2usize];
            let product_25 = c[11usize] * seat_omega;
            let product_26 = seat_omega * product_25;
            let product_27 = cos_seat_phi * product_26;
            let bar_omega = v[5usize];
            let product_29 = c[12usize] * bar_omega;
            let product_30 = bar_omega * product_29;
            let sum_32 = T::fused(cos_bar_phi, product_30, product_27);
            let product_33 = sin_seat_phi * product_26;
            let sum_35 = T::fused(sin_bar_phi, product_30, product_33);
            let seat_vx = v[0usize];
            let product_37 = cos_seat_phi * seat_vx;
            let seat_vy = v[1usize];
            let sum_40 = T::fused(sin_seat_phi, seat_vy, product_37);
            let product_41 = seat_omega * sum_40;
            let bar_vx = v[3usize];
            let product_43 = cos_bar_phi * bar_vx;
            let bar_vy = v[4usize];
            let sum_46 = T::fused(sin_bar_phi, bar_vy, product_43);
            let product_47 = bar_omega * sum_46;
            let torque = c[0usize];
            let product_76 = cos_seat_phi * c[3usize];
            let product_77 = cos_seat_phi * product_76;
            let product_79 = cos_bar_phi * c[4usize];
            let sum_81 = T::fused(cos_bar_phi, product_79, product_77);
            let sum_83 = sum_81 + c[5usize];
            let product_84 = sin_seat_phi * c[3usize];
            let product_85 = cos_seat_phi * product_84;
            let product_86 = sin_bar_phi * c[4usize];
            let sum_88 = T::fused(cos_bar_phi, product_86, product_85);
            let difference_90 = c[6usize] - sum_81;
            let product_119 = sum_83 * difference_90;
            let difference_121 = T::fused(-sum_88, sum_88, product_119);
            let quotient_122 = T::from_f64(1f64) / difference_121;
            let product_178 = cos_seat_phi * seat_omega;
            let product_179 = sin_seat_phi * seat_omega;
            let product_180 = cos_bar_phi * bar_omega;
            let product_181 = sin_bar_phi * bar_omega;
            let value_182 = -torque;
            let value_183 = -product_179;
            let value_184 = -product_181;
            let target = ::ezy_core::kernel::array_mut::<8usize, T>(&mut store.base);
            target[0usize] = cos_seat_phi;
            target[1usize] = sin_seat_phi;
            target[2usize] = cos_bar_phi;
            target[3usize] = sin_bar_phi;
            target[4usize] = quotient_122;
            target[5usize] = difference_90;
            target[6usize] = sum_88;
            target[7usize] = sum_83;
            let target = ::ezy_core::kernel::array_mut::<6usize, T>(&mut store.force);
            target[0usize] = T::from_f64(0f64);
            target[1usize] = T::from_f64(0f64);
            target[2usize] = value_182;
            target[3usize] = T::from_f64(0f64);
            target[4usize] = T::from_f64(0f64);
            target[5usize] = torque;
            let target = ::ezy_core::kernel::row_mut::<
                16usize,
                T,
            >(&mut store.left, 1usize);
            target[0usize] = product_178;
            target[1usize] = value_183;
            target[2usize] = product_178;
            target[3usize] = value_183;
            target[4usize] = product_180;
            target[5usize] = value_184;
            target[6usize] = product_180;
            target[7usize] = value_184;
            target[8usize] = seat_omega;
            target[9usize] = bar_omega;
            target[10usize] = seat_omega;
            target[11usize] = bar_omega;
            target[12usize] = product_178;
            target[13usize] = value_183;
            target[14usize] = product_180;
            target[15usize] = value_184;
            let target = ::ezy_core::kernel::row_mut::<
                16usize,
                T,
            >(&mut store.right, 1usize);
            target[0usize] = T::from_f64(0f64);
            target[1usize] = T::from_f64(0f64);
            target[2usize] = T::from_f64(0f64);
            target[3usize] = T::from_f64(0f64);
            target[4usize] = T::from_f64(0f64);
            target[5usize] = T::from_f64(0f64);
            target[6usize] = T::from_f64(0f64);
            target[7usize] = T::from_f64(0f64);
            target[8usize] = product_178;
            target[9usize] = product_180;
            target[10usize] = value_183;
            target[11usize] = value_184;
            target[12usize] = seat_vx;
            target[13usize] = seat_vy;
            target[14usize] = bar_vx;
            target[15usize] = bar_vy;
            let target = ::ezy_core::kernel::array_mut::<4usize, T>(&mut store.row);
            target[0usize] = sum_32;
            target[1usize] = sum_35;
            target[2usize] = product_41;
            target[3usize] = product_47;
            ::ezy_core::model::DeficientRows(0)
                .mark(2usize, !T::is_above(c[19usize], c[20usize]))
                .mark(3usize, !T::is_above(c[21usize], c[22usize]))
                .mark(0usize, !T::is_above(difference_121, c[23usize]))
                .mark(1usize, !T::is_above(difference_121, c[23usize]))
        }
        #[inline]
        fn right_side(
            &self,
            c: &[T],
            k: usize,
            store: &mut ::ezy_core::model::SeriesStore<T>,
        ) {
            let c = ::ezy_core::kernel::array::<32usize, T>(c);
            let sums = ::ezy_core::kernel::array::<16usize, T>(&store.sums);
            let convolved_0 = sums[0usize];
            let convolved_1 = sums[1usize];
            let convolved_2 = sums[2usize];
            let product_6 = c[11usize] * convolved_2;
            let convolved_3 = sums[3usize];
            let difference_9 = T::fused(-c[11usize], convolved_3, product_6);
            let convolved_4 = sums[4usize];
            let convolved_5 = sums[5usize];
            let convolved_6 = sums[6usize];
            let product_14 = c[12usize] * convolved_6;
            let convolved_7 = sums[7usize];
            let difference_17 = T::fused(-c[12usize], convolved_7, product_14);
            let convolved_8 = sums[8usize];
            let inverse_order_ahead = T::from_f64(1f64)
                / T::from_f64((k + 2usize) as f64);
            let product_20 = convolved_8 * inverse_order_ahead;
            let product_21 = c[11usize] * product_20;
            let convolved_9 = sums[9usize];
            let product_23 = inverse_order_ahead * convolved_9;
            let sum_25 = T::fused(c[12usize], product_23, product_21);
            let order_next = T::from_f64((k + 1usize) as f64);
            let order_ahead = T::from_f64((k + 2usize) as f64);
            let product_28 = order_next * order_ahead;
            let product_29 = sum_25 * product_28;
            let convolved_10 = sums[10usize];
            let product_31 = inverse_order_ahead * convolved_10;
            let product_32 = c[11usize] * product_31;
            let convolved_11 = sums[11usize];
            let product_34 = inverse_order_ahead * convolved_11;
            let sum_36 = T::fused(c[12usize], product_34, product_32);
            let product_37 = product_28 * sum_36;
            let convolved_12 = sums[12usize];
            let convolved_13 = sums[13usize];
            let difference_40 = convolved_12 - convolved_13;
            let product_41 = order_next * difference_40;
            let convolved_14 = sums[14usize];
            let convolved_15 = sums[15usize];
            let difference_44 = convolved_14 - convolved_15;
            let product_45 = order_next * difference_44;
            let value_46 = -convolved_1;
            let value_47 = -convolved_5;
            let value_48 = -product_37;
            let target = ::ezy_core::kernel::array_mut::<6usize, T>(&mut store.force);
            target[0usize] = convolved_0;
            target[1usize] = value_46;
            target[2usize] = difference_9;
            target[3usize] = convolved_4;
            target[4usize] = value_47;
            target[5usize] = difference_17;
            let target = ::ezy_core::kernel::array_mut::<4usize, T>(&mut store.row);
            target[0usize] = product_29;
            target[1usize] = value_48;
            target[2usize] = product_41;
            target[3usize] = product_45;
        }
        #[inline]
        fn solve(
            &self,
            c: &[T],
            k: usize,
            store: &mut ::ezy_core::model::SeriesStore<T>,
        ) {
            let c = ::ezy_core::kernel::array::<32usize, T>(c);
            let base = ::ezy_core::kernel::array::<8usize, T>(&store.base);
            let force = ::ezy_core::kernel::array::<6usize, T>(&store.force);
            let row = ::ezy_core::kernel::array::<4usize, T>(&store.row);
            let force_0 = force[0usize];
            let base_4 = base[4usize];
            let base_5 = base[5usize];
            let base_1 = base[1usize];
            let force_2 = force[2usize];
            let product_8 = force_2 * c[7usize];
            let base_0 = base[0usize];
            let force_1 = force[1usize];
            let product_11 = base_0 * force_1;
            let difference_13 = T::fused(-force_0, base_1, product_11);
            let product_14 = c[15usize] * difference_13;
            let difference_17 = T::fused(-force_2, c[1usize], product_14);
            let row_2 = row[2usize];
            let right_side_rear = difference_17 - row_2;
            let sum_22 = T::fused(right_side_rear, c[8usize], product_8);
            let product_23 = base_1 * sum_22;
            let base_3 = base[3usize];
            let force_5 = force[5usize];
            let product_27 = force_5 * c[9usize];
            let base_2 = base[2usize];
            let force_4 = force[4usize];
            let product_30 = base_2 * force_4;
            let force_3 = force[3usize];
            let difference_33 = T::fused(-base_3, force_3, product_30);
            let product_35 = difference_33 * c[17usize];
            let sum_38 = T::fused(force_5, c[2usize], product_35);
            let row_3 = row[3usize];
            let right_side_front = sum_38 - row_3;
            let sum_43 = T::fused(right_side_front, c[10usize], product_27);
            let sum_45 = T::fused(base_3, sum_43, product_23);
            let difference_46 = T::fused(c[15usize], force_0, -sum_45);
            let difference_48 = T::fused(-force_3, c[17usize], difference_46);
            let row_0 = row[0usize];
            let difference_50 = difference_48 - row_0;
            let product_51 = base_5 * difference_50;
            let base_6 = base[6usize];
            let product_53 = base_0 * sum_22;
            let sum_55 = T::fused(base_2, sum_43, product_53);
            let sum_57 = T::fused(c[15usize], force_1, sum_55);
            let difference_59 = T::fused(-force_4, c[17usize], sum_57);
            let row_1 = row[1usize];
            let difference_61 = difference_59 - row_1;
            let difference_63 = T::fused(-base_6, difference_61, product_51);
            let lambda_B_x = base_4 * difference_63;
            let difference_65 = force_0 - lambda_B_x;
            let base_7 = base[7usize];
            let product_67 = difference_61 * base_7;
            let difference_69 = T::fused(-difference_50, base_6, product_67);
            let lambda_B_y = base_4 * difference_69;
            let product_71 = base_0 * lambda_B_y;
            let difference_73 = T::fused(-base_1, lambda_B_x, product_71);
            let product_74 = c[8usize] * difference_73;
            let lambda_rear = T::fused(right_side_rear, c[14usize], product_74);
            let sum_79 = T::fused(base_1, lambda_rear, difference_65);
            let product_80 = c[15usize] * sum_79;
            let difference_81 = force_1 - lambda_B_y;
            let difference_83 = T::fused(-base_0, lambda_rear, difference_81);
            let product_84 = c[15usize] * difference_83;
            let product_86 = force_2 * c[16usize];
            let difference_88 = T::fused(-c[7usize], difference_73, product_86);
            let sum_90 = T::fused(c[1usize], lambda_rear, difference_88);
            let sum_91 = force_3 + lambda_B_x;
            let product_92 = base_2 * lambda_B_y;
            let difference_94 = T::fused(-base_3, lambda_B_x, product_92);
            let product_95 = c[10usize] * difference_94;
            let lambda_front = T::fused(right_side_front, c[13usize], product_95);
            let sum_100 = T::fused(base_3, lambda_front, sum_91);
            let product_101 = c[17usize] * sum_100;
            let sum_102 = force_4 + lambda_B_y;
            let difference_104 = T::fused(-base_2, lambda_front, sum_102);
            let product_105 = c[17usize] * difference_104;
            let product_107 = force_5 * c[18usize];
            let difference_109 = T::fused(-c[9usize], difference_94, product_107);
            let difference_111 = T::fused(-c[2usize], lambda_front, difference_109);
            let target = ::ezy_core::kernel::array_mut::<6usize, T>(&mut store.a);
            target[0usize] = product_80;
            target[1usize] = product_84;
            target[2usize] = sum_90;
            target[3usize] = product_101;
            target[4usize] = product_105;
            target[5usize] = difference_111;
            let target = ::ezy_core::kernel::row_mut::<
                4usize,
                T,
            >(&mut store.lambda, k + 0usize);
            target[0usize] = lambda_B_x;
            target[1usize] = lambda_B_y;
            target[2usize] = lambda_rear;
            target[3usize] = lambda_front;
        }
        #[inline]
        fn finish(
            &self,
            c: &[T],
            k: usize,
            store: &mut ::ezy_core::model::SeriesStore<T>,
        ) {
            let a = ::ezy_core::kernel::array::<6usize, T>(&store.a);
            let base = ::ezy_core::kernel::array::<8usize, T>(&store.base);
            let lambda_0 = ::ezy_core::kernel::row::<
                4usize,
                T,
            >(&store.lambda, k + 0usize);
            let sums = ::ezy_core::kernel::array::<16usize, T>(&store.sums);
            let a_0 = a[0usize];
            let inverse_order_next = T::from_f64(1f64)
                / T::from_f64((k + 1usize) as f64);
            let inverse_order_ahead = T::from_f64(1f64)
                / T::from_f64((k + 2usize) as f64);
            let product_3 = inverse_order_next * inverse_order_ahead;
            let product_4 = a_0 * product_3;
            let a_1 = a[1usize];
            let product_6 = product_3 * a_1;
            let a_2 = a[2usize];
            let product_8 = product_3 * a_2;
            let a_3 = a[3usize];
            let product_10 = product_3 * a_3;
            let a_4 = a[4usize];
            let product_12 = product_3 * a_4;
            let a_5 = a[5usize];
            let product_14 = product_3 * a_5;
            let lambda_2 = lambda_0[2usize];
            let convolved_10 = sums[10usize];
            let product_19 = inverse_order_ahead * convolved_10;
            let base_0 = base[0usize];
            let sum_22 = T::fused(product_8, base_0, product_19);
            let convolved_8 = sums[8usize];
            let product_24 = inverse_order_ahead * convolved_8;
            let base_1 = base[1usize];
            let sum_27 = T::fused(product_8, base_1, product_24);
            let lambda_0 = lambda_0[0usize];
            let lambda_1 = lambda_0[1usize];
            let lambda_3 = lambda_0[3usize];
            let convolved_11 = sums[11usize];
            let product_32 = inverse_order_ahead * convolved_11;
            let base_2 = base[2usize];
            let sum_35 = T::fused(product_14, base_2, product_32);
            let convolved_9 = sums[9usize];
            let product_37 = inverse_order_ahead * convolved_9;
            let base_3 = base[3usize];
            let sum_40 = T::fused(product_14, base_3, product_37);
            let order_ahead = T::from_f64((k + 2usize) as f64);
            let product_42 = product_8 * order_ahead;
            let product_43 = product_14 * order_ahead;
            let product_44 = product_4 * order_ahead;
            let product_45 = product_6 * order_ahead;
            let product_46 = product_10 * order_ahead;
            let product_47 = product_12 * order_ahead;
            let value_48 = -sum_27;
            let value_49 = -sum_40;
            let target = ::ezy_core::kernel::row_mut::<
                16usize,
                T,
            >(&mut store.left, k + 2usize);
            target[0usize] = sum_22;
            target[1usize] = value_48;
            target[2usize] = sum_22;
            target[3usize] = value_48;
            target[4usize] = sum_35;
            target[5usize] = value_49;
            target[6usize] = sum_35;
            target[7usize] = value_49;
            target[8usize] = product_42;
            target[9usize] = product_43;
            target[10usize] = product_42;
            target[11usize] = product_43;
            target[12usize] = sum_22;
            target[13usize] = value_48;
            target[14usize] = sum_35;
            target[15usize] = value_49;
            let target = ::ezy_core::kernel::row_mut::<
                6usize,
                T,
            >(&mut store.q, k + 2usize);
            target[0usize] = product_4;
            target[1usize] = product_6;
            target[2usize] = product_8;
            target[3usize] = product_10;
            target[4usize] = product_12;
            target[5usize] = product_14;
            let target = ::ezy_core::kernel::row_mut::<
                16usize,
                T,
            >(&mut store.right, k + 2usize);
            target[0usize] = lambda_2;
            target[1usize] = lambda_2;
            target[2usize] = lambda_0;
            target[3usize] = lambda_1;
            target[4usize] = lambda_3;
            target[5usize] = lambda_3;
            target[6usize] = lambda_0;
            target[7usize] = lambda_1;
            target[8usize] = sum_22;
            target[9usize] = sum_35;
            target[10usize] = value_48;
            target[11usize] = value_49;
            target[12usize] = product_44;
            target[13usize] = product_45;
            target[14usize] = product_46;
            target[15usize] = product_47;
        }
    }
}
