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
    pub const INFO: ezy::SceneInfo = ezy::SceneInfo {
        model: "EzyRoller",
        name: "coast",
        documentation: "No forces: the bar stands across, the seat moves at 1 m/s.",
        fingerprint: 4958805213051706263u64,
        bodies: ezy::List::Borrowed(
            &[ezy::Name::Borrowed("seat"), ezy::Name::Borrowed("bar")],
        ),
        kinds: ezy::List::Borrowed(&[]),
        coordinates: ezy::List::Borrowed(
            &[
                ezy::CoordinateInfo {
                    name: ezy::Name::Borrowed("seat.x"),
                    unit: "m",
                    symbol: ::core::option::Option::Some(ezy::Formula {
                        text: "seat.x",
                        latex: "x_{\\mathrm{seat}}",
                        mathml: "<mrow><msub><mi>x</mi><mtext>seat</mtext></msub></mrow>",
                    }),
                },
                ezy::CoordinateInfo {
                    name: ezy::Name::Borrowed("seat.y"),
                    unit: "m",
                    symbol: ::core::option::Option::Some(ezy::Formula {
                        text: "seat.y",
                        latex: "y_{\\mathrm{seat}}",
                        mathml: "<mrow><msub><mi>y</mi><mtext>seat</mtext></msub></mrow>",
                    }),
                },
                ezy::CoordinateInfo {
                    name: ezy::Name::Borrowed("seat.phi"),
                    unit: "rad",
                    symbol: ::core::option::Option::Some(ezy::Formula {
                        text: "seat.phi",
                        latex: "\\varphi_{\\mathrm{seat}}",
                        mathml: "<mrow><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow>",
                    }),
                },
                ezy::CoordinateInfo {
                    name: ezy::Name::Borrowed("bar.x"),
                    unit: "m",
                    symbol: ::core::option::Option::Some(ezy::Formula {
                        text: "bar.x",
                        latex: "x_{\\mathrm{bar}}",
                        mathml: "<mrow><msub><mi>x</mi><mtext>bar</mtext></msub></mrow>",
                    }),
                },
                ezy::CoordinateInfo {
                    name: ezy::Name::Borrowed("bar.y"),
                    unit: "m",
                    symbol: ::core::option::Option::Some(ezy::Formula {
                        text: "bar.y",
                        latex: "y_{\\mathrm{bar}}",
                        mathml: "<mrow><msub><mi>y</mi><mtext>bar</mtext></msub></mrow>",
                    }),
                },
                ezy::CoordinateInfo {
                    name: ezy::Name::Borrowed("bar.phi"),
                    unit: "rad",
                    symbol: ::core::option::Option::Some(ezy::Formula {
                        text: "bar.phi",
                        latex: "\\varphi_{\\mathrm{bar}}",
                        mathml: "<mrow><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow>",
                    }),
                },
            ],
        ),
        velocities: ezy::List::Borrowed(
            &[
                ezy::CoordinateInfo {
                    name: ezy::Name::Borrowed("seat.vx"),
                    unit: "m/s",
                    symbol: ::core::option::Option::Some(ezy::Formula {
                        text: "seat.vx",
                        latex: "\\dot{x}_{\\mathrm{seat}}",
                        mathml: "<mrow><msub><mover><mi>x</mi><mo>.</mo></mover><mtext>seat</mtext></msub></mrow>",
                    }),
                },
                ezy::CoordinateInfo {
                    name: ezy::Name::Borrowed("seat.vy"),
                    unit: "m/s",
                    symbol: ::core::option::Option::Some(ezy::Formula {
                        text: "seat.vy",
                        latex: "\\dot{y}_{\\mathrm{seat}}",
                        mathml: "<mrow><msub><mover><mi>y</mi><mo>.</mo></mover><mtext>seat</mtext></msub></mrow>",
                    }),
                },
                ezy::CoordinateInfo {
                    name: ezy::Name::Borrowed("seat.omega"),
                    unit: "rad/s",
                    symbol: ::core::option::Option::Some(ezy::Formula {
                        text: "seat.omega",
                        latex: "\\dot{\\varphi}_{\\mathrm{seat}}",
                        mathml: "<mrow><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext></msub></mrow>",
                    }),
                },
                ezy::CoordinateInfo {
                    name: ezy::Name::Borrowed("bar.vx"),
                    unit: "m/s",
                    symbol: ::core::option::Option::Some(ezy::Formula {
                        text: "bar.vx",
                        latex: "\\dot{x}_{\\mathrm{bar}}",
                        mathml: "<mrow><msub><mover><mi>x</mi><mo>.</mo></mover><mtext>bar</mtext></msub></mrow>",
                    }),
                },
                ezy::CoordinateInfo {
                    name: ezy::Name::Borrowed("bar.vy"),
                    unit: "m/s",
                    symbol: ::core::option::Option::Some(ezy::Formula {
                        text: "bar.vy",
                        latex: "\\dot{y}_{\\mathrm{bar}}",
                        mathml: "<mrow><msub><mover><mi>y</mi><mo>.</mo></mover><mtext>bar</mtext></msub></mrow>",
                    }),
                },
                ezy::CoordinateInfo {
                    name: ezy::Name::Borrowed("bar.omega"),
                    unit: "rad/s",
                    symbol: ::core::option::Option::Some(ezy::Formula {
                        text: "bar.omega",
                        latex: "\\dot{\\varphi}_{\\mathrm{bar}}",
                        mathml: "<mrow><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext></msub></mrow>",
                    }),
                },
            ],
        ),
        points: ezy::List::Borrowed(
            &[
                ezy::PointInfo {
                    name: ezy::Name::Borrowed("A"),
                    body: ::core::option::Option::Some(0usize),
                    position: ::core::option::Option::Some([
                        ezy::Formula {
                            text: "seat.x - a*cos(seat.phi)",
                            latex: "x_{\\mathrm{seat}} - a \\, \\cos{\\varphi_{\\mathrm{seat}}}",
                            mathml: "<mrow><msub><mi>x</mi><mtext>seat</mtext></msub><mo>−</mo><mi>a</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                        },
                        ezy::Formula {
                            text: "seat.y - a*sin(seat.phi)",
                            latex: "y_{\\mathrm{seat}} - a \\, \\sin{\\varphi_{\\mathrm{seat}}}",
                            mathml: "<mrow><msub><mi>y</mi><mtext>seat</mtext></msub><mo>−</mo><mi>a</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                        },
                    ]),
                },
                ezy::PointInfo {
                    name: ezy::Name::Borrowed("C"),
                    body: ::core::option::Option::Some(1usize),
                    position: ::core::option::Option::Some([
                        ezy::Formula {
                            text: "bar.x + c*cos(bar.phi)",
                            latex: "x_{\\mathrm{bar}} + c \\, \\cos{\\varphi_{\\mathrm{bar}}}",
                            mathml: "<mrow><msub><mi>x</mi><mtext>bar</mtext></msub><mo>+</mo><mi>c</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                        },
                        ezy::Formula {
                            text: "bar.y + c*sin(bar.phi)",
                            latex: "y_{\\mathrm{bar}} + c \\, \\sin{\\varphi_{\\mathrm{bar}}}",
                            mathml: "<mrow><msub><mi>y</mi><mtext>bar</mtext></msub><mo>+</mo><mi>c</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                        },
                    ]),
                },
                ezy::PointInfo {
                    name: ezy::Name::Borrowed("B"),
                    body: ::core::option::Option::Some(0usize),
                    position: ::core::option::Option::Some([
                        ezy::Formula {
                            text: "seat.x + b*cos(seat.phi)",
                            latex: "x_{\\mathrm{seat}} + b \\, \\cos{\\varphi_{\\mathrm{seat}}}",
                            mathml: "<mrow><msub><mi>x</mi><mtext>seat</mtext></msub><mo>+</mo><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                        },
                        ezy::Formula {
                            text: "seat.y + b*sin(seat.phi)",
                            latex: "y_{\\mathrm{seat}} + b \\, \\sin{\\varphi_{\\mathrm{seat}}}",
                            mathml: "<mrow><msub><mi>y</mi><mtext>seat</mtext></msub><mo>+</mo><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                        },
                    ]),
                },
            ],
        ),
        rows: ezy::List::Borrowed(
            &[
                ezy::RowInfo {
                    name: ezy::Name::Borrowed("B.x"),
                    kind: "hinge",
                    multiplier_unit: "N",
                    constraint: ezy::Formula {
                        text: "seat.x + b*cos(seat.phi) - bar.x + d*cos(bar.phi)",
                        latex: "x_{\\mathrm{seat}} + b \\, \\cos{\\varphi_{\\mathrm{seat}}} - x_{\\mathrm{bar}} + d \\, \\cos{\\varphi_{\\mathrm{bar}}}",
                        mathml: "<mrow><msub><mi>x</mi><mtext>seat</mtext></msub><mo>+</mo><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>−</mo><msub><mi>x</mi><mtext>bar</mtext></msub><mo>+</mo><mi>d</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                    },
                    convective_term: ezy::Formula {
                        text: "-b*seat.omega^2*cos(seat.phi) - d*bar.omega^2*cos(bar.phi)",
                        latex: "-b \\, \\dot{\\varphi}_{\\mathrm{seat}}^{2} \\, \\cos{\\varphi_{\\mathrm{seat}}} - d \\, \\dot{\\varphi}_{\\mathrm{bar}}^{2} \\, \\cos{\\varphi_{\\mathrm{bar}}}",
                        mathml: "<mrow><mo>−</mo><mi>b</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>−</mo><mi>d</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                    },
                },
                ezy::RowInfo {
                    name: ezy::Name::Borrowed("B.y"),
                    kind: "hinge",
                    multiplier_unit: "N",
                    constraint: ezy::Formula {
                        text: "seat.y + b*sin(seat.phi) - bar.y + d*sin(bar.phi)",
                        latex: "y_{\\mathrm{seat}} + b \\, \\sin{\\varphi_{\\mathrm{seat}}} - y_{\\mathrm{bar}} + d \\, \\sin{\\varphi_{\\mathrm{bar}}}",
                        mathml: "<mrow><msub><mi>y</mi><mtext>seat</mtext></msub><mo>+</mo><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>−</mo><msub><mi>y</mi><mtext>bar</mtext></msub><mo>+</mo><mi>d</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                    },
                    convective_term: ezy::Formula {
                        text: "-b*seat.omega^2*sin(seat.phi) - d*bar.omega^2*sin(bar.phi)",
                        latex: "-b \\, \\dot{\\varphi}_{\\mathrm{seat}}^{2} \\, \\sin{\\varphi_{\\mathrm{seat}}} - d \\, \\dot{\\varphi}_{\\mathrm{bar}}^{2} \\, \\sin{\\varphi_{\\mathrm{bar}}}",
                        mathml: "<mrow><mo>−</mo><mi>b</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>−</mo><mi>d</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                    },
                },
                ezy::RowInfo {
                    name: ezy::Name::Borrowed("rear"),
                    kind: "skate",
                    multiplier_unit: "N",
                    constraint: ezy::Formula {
                        text: "-a*seat.omega - seat.vx*sin(seat.phi) + seat.vy*cos(seat.phi)",
                        latex: "-a \\, \\dot{\\varphi}_{\\mathrm{seat}} - \\dot{x}_{\\mathrm{seat}} \\, \\sin{\\varphi_{\\mathrm{seat}}} + \\dot{y}_{\\mathrm{seat}} \\, \\cos{\\varphi_{\\mathrm{seat}}}",
                        mathml: "<mrow><mo>−</mo><mi>a</mi><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mo>−</mo><msub><mover><mi>x</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>+</mo><msub><mover><mi>y</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                    },
                    convective_term: ezy::Formula {
                        text: "-seat.vx*seat.omega*cos(seat.phi) - seat.vy*seat.omega*sin(seat.phi)",
                        latex: "-\\dot{x}_{\\mathrm{seat}} \\, \\dot{\\varphi}_{\\mathrm{seat}} \\, \\cos{\\varphi_{\\mathrm{seat}}} - \\dot{y}_{\\mathrm{seat}} \\, \\dot{\\varphi}_{\\mathrm{seat}} \\, \\sin{\\varphi_{\\mathrm{seat}}}",
                        mathml: "<mrow><mo>−</mo><msub><mover><mi>x</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>−</mo><msub><mover><mi>y</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                    },
                },
                ezy::RowInfo {
                    name: ezy::Name::Borrowed("front"),
                    kind: "skate",
                    multiplier_unit: "N",
                    constraint: ezy::Formula {
                        text: "c*bar.omega - bar.vx*sin(bar.phi) + bar.vy*cos(bar.phi)",
                        latex: "c \\, \\dot{\\varphi}_{\\mathrm{bar}} - \\dot{x}_{\\mathrm{bar}} \\, \\sin{\\varphi_{\\mathrm{bar}}} + \\dot{y}_{\\mathrm{bar}} \\, \\cos{\\varphi_{\\mathrm{bar}}}",
                        mathml: "<mrow><mi>c</mi><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mo>−</mo><msub><mover><mi>x</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow><mo>+</mo><msub><mover><mi>y</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                    },
                    convective_term: ezy::Formula {
                        text: "-bar.vx*bar.omega*cos(bar.phi) - bar.vy*bar.omega*sin(bar.phi)",
                        latex: "-\\dot{x}_{\\mathrm{bar}} \\, \\dot{\\varphi}_{\\mathrm{bar}} \\, \\cos{\\varphi_{\\mathrm{bar}}} - \\dot{y}_{\\mathrm{bar}} \\, \\dot{\\varphi}_{\\mathrm{bar}} \\, \\sin{\\varphi_{\\mathrm{bar}}}",
                        mathml: "<mrow><mo>−</mo><msub><mover><mi>x</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow><mo>−</mo><msub><mover><mi>y</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
                    },
                },
            ],
        ),
        n_position_rows: 2usize,
        parameters: &[
            ezy::ParameterInfo {
                name: "a",
                unit: "m",
                default: 0.2f64,
                default_text: "0.2",
                documentation: "rear wheel A, behind the seat's centre of mass",
                effect: ::core::option::Option::None,
                symbol: ezy::Formula {
                    text: "a",
                    latex: "a",
                    mathml: "<mrow><mi>a</mi></mrow>",
                },
            },
            ezy::ParameterInfo {
                name: "b",
                unit: "m",
                default: 0.6f64,
                default_text: "0.6",
                documentation: "hinge B, ahead of the seat's centre of mass",
                effect: ::core::option::Option::None,
                symbol: ezy::Formula {
                    text: "b",
                    latex: "b",
                    mathml: "<mrow><mi>b</mi></mrow>",
                },
            },
            ezy::ParameterInfo {
                name: "c",
                unit: "m",
                default: 0.1f64,
                default_text: "0.1",
                documentation: "front wheel C, beyond the bar's centre of mass",
                effect: ::core::option::Option::None,
                symbol: ezy::Formula {
                    text: "c",
                    latex: "c",
                    mathml: "<mrow><mi>c</mi></mrow>",
                },
            },
            ezy::ParameterInfo {
                name: "d",
                unit: "m",
                default: 0.1f64,
                default_text: "0.1",
                documentation: "bar's centre of mass, beyond the hinge",
                effect: ::core::option::Option::None,
                symbol: ezy::Formula {
                    text: "d",
                    latex: "d",
                    mathml: "<mrow><mi>d</mi></mrow>",
                },
            },
            ezy::ParameterInfo {
                name: "m1",
                unit: "kg",
                default: 46f64,
                default_text: "46.0",
                documentation: "mass of seat and rider",
                effect: ::core::option::Option::None,
                symbol: ezy::Formula {
                    text: "m1",
                    latex: "m_{1}",
                    mathml: "<mrow><msub><mi>m</mi><mtext>1</mtext></msub></mrow>",
                },
            },
            ezy::ParameterInfo {
                name: "i1",
                unit: "kg*m^2",
                default: 10f64,
                default_text: "10.0",
                documentation: "moment of inertia of seat and rider",
                effect: ::core::option::Option::None,
                symbol: ezy::Formula {
                    text: "i1",
                    latex: "i_{1}",
                    mathml: "<mrow><msub><mi>i</mi><mtext>1</mtext></msub></mrow>",
                },
            },
            ezy::ParameterInfo {
                name: "m2",
                unit: "kg",
                default: 1f64,
                default_text: "1.0",
                documentation: "mass of the bar",
                effect: ::core::option::Option::None,
                symbol: ezy::Formula {
                    text: "m2",
                    latex: "m_{2}",
                    mathml: "<mrow><msub><mi>m</mi><mtext>2</mtext></msub></mrow>",
                },
            },
            ezy::ParameterInfo {
                name: "i2",
                unit: "kg*m^2",
                default: 0.005f64,
                default_text: "0.005",
                documentation: "moment of inertia of the bar",
                effect: ::core::option::Option::None,
                symbol: ezy::Formula {
                    text: "i2",
                    latex: "i_{2}",
                    mathml: "<mrow><msub><mi>i</mi><mtext>2</mtext></msub></mrow>",
                },
            },
        ],
        inputs: &[],
        integrated_inputs: &[],
        states: &[],
        outputs: ezy::List::Borrowed(&[]),
        events: &[],
        limited_skates: &[],
        stop: ::core::option::Option::None,
        switches: &[],
        effects: &[],
        until_s: 1f64,
        n_constants: 46usize,
        jacobian: ezy::SparsityPattern::new(
            &[0u32, 4u32, 8u32, 11u32, 14u32],
            &[
                0u32, 2u32, 3u32, 5u32, 1u32, 2u32, 4u32, 5u32, 0u32, 1u32, 2u32, 3u32,
                4u32, 5u32,
            ],
        ),
        jacobian_entries: &[
            ezy::Formula {
                text: "1",
                latex: "1",
                mathml: "<mrow><mn>1</mn></mrow>",
            },
            ezy::Formula {
                text: "-b*sin(seat.phi)",
                latex: "-b \\, \\sin{\\varphi_{\\mathrm{seat}}}",
                mathml: "<mrow><mo>−</mo><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
            },
            ezy::Formula {
                text: "-1",
                latex: "-1",
                mathml: "<mrow><mo>−</mo><mn>1</mn></mrow>",
            },
            ezy::Formula {
                text: "-d*sin(bar.phi)",
                latex: "-d \\, \\sin{\\varphi_{\\mathrm{bar}}}",
                mathml: "<mrow><mo>−</mo><mi>d</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
            },
            ezy::Formula {
                text: "1",
                latex: "1",
                mathml: "<mrow><mn>1</mn></mrow>",
            },
            ezy::Formula {
                text: "b*cos(seat.phi)",
                latex: "b \\, \\cos{\\varphi_{\\mathrm{seat}}}",
                mathml: "<mrow><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
            },
            ezy::Formula {
                text: "-1",
                latex: "-1",
                mathml: "<mrow><mo>−</mo><mn>1</mn></mrow>",
            },
            ezy::Formula {
                text: "d*cos(bar.phi)",
                latex: "d \\, \\cos{\\varphi_{\\mathrm{bar}}}",
                mathml: "<mrow><mi>d</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
            },
            ezy::Formula {
                text: "-sin(seat.phi)",
                latex: "-\\sin{\\varphi_{\\mathrm{seat}}}",
                mathml: "<mrow><mo>−</mo><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
            },
            ezy::Formula {
                text: "cos(seat.phi)",
                latex: "\\cos{\\varphi_{\\mathrm{seat}}}",
                mathml: "<mrow><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
            },
            ezy::Formula {
                text: "-a",
                latex: "-a",
                mathml: "<mrow><mo>−</mo><mi>a</mi></mrow>",
            },
            ezy::Formula {
                text: "-sin(bar.phi)",
                latex: "-\\sin{\\varphi_{\\mathrm{bar}}}",
                mathml: "<mrow><mo>−</mo><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
            },
            ezy::Formula {
                text: "cos(bar.phi)",
                latex: "\\cos{\\varphi_{\\mathrm{bar}}}",
                mathml: "<mrow><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow>",
            },
            ezy::Formula {
                text: "c",
                latex: "c",
                mathml: "<mrow><mi>c</mi></mrow>",
            },
        ],
        mass_entries: &[
            ezy::Formula {
                text: "m1",
                latex: "m_{1}",
                mathml: "<mrow><msub><mi>m</mi><mtext>1</mtext></msub></mrow>",
            },
            ezy::Formula {
                text: "m1",
                latex: "m_{1}",
                mathml: "<mrow><msub><mi>m</mi><mtext>1</mtext></msub></mrow>",
            },
            ezy::Formula {
                text: "i1",
                latex: "i_{1}",
                mathml: "<mrow><msub><mi>i</mi><mtext>1</mtext></msub></mrow>",
            },
            ezy::Formula {
                text: "m2",
                latex: "m_{2}",
                mathml: "<mrow><msub><mi>m</mi><mtext>2</mtext></msub></mrow>",
            },
            ezy::Formula {
                text: "m2",
                latex: "m_{2}",
                mathml: "<mrow><msub><mi>m</mi><mtext>2</mtext></msub></mrow>",
            },
            ezy::Formula {
                text: "i2",
                latex: "i_{2}",
                mathml: "<mrow><msub><mi>i</mi><mtext>2</mtext></msub></mrow>",
            },
        ],
        force_entries: &[
            ezy::Formula {
                text: "0",
                latex: "0",
                mathml: "<mrow><mn>0</mn></mrow>",
            },
            ezy::Formula {
                text: "0",
                latex: "0",
                mathml: "<mrow><mn>0</mn></mrow>",
            },
            ezy::Formula {
                text: "0",
                latex: "0",
                mathml: "<mrow><mn>0</mn></mrow>",
            },
            ezy::Formula {
                text: "0",
                latex: "0",
                mathml: "<mrow><mn>0</mn></mrow>",
            },
            ezy::Formula {
                text: "0",
                latex: "0",
                mathml: "<mrow><mn>0</mn></mrow>",
            },
            ezy::Formula {
                text: "0",
                latex: "0",
                mathml: "<mrow><mn>0</mn></mrow>",
            },
        ],
        potential_energy: ezy::Formula {
            text: "0",
            latex: "0",
            mathml: "<mrow><mn>0</mn></mrow>",
        },
        abbreviations: &[],
        equations: &[
            ezy::Equation {
                name: "coordinates",
                text: "    [ seat.x   ]\n    [ seat.y   ]\nq = [ seat.phi ]\n    [ bar.x    ]\n    [ bar.y    ]\n    [ bar.phi  ]\n",
                latex: "q = \\begin{bmatrix} x_{\\mathrm{seat}} \\\\ y_{\\mathrm{seat}} \\\\ \\varphi_{\\mathrm{seat}} \\\\ x_{\\mathrm{bar}} \\\\ y_{\\mathrm{bar}} \\\\ \\varphi_{\\mathrm{bar}} \\end{bmatrix}",
                mathml: "<math display=\"block\"><mrow><mi>q</mi></mrow><mo>=</mo><mtable style=\"border: solid; border-width: 0 .09em; border-radius: .7em; padding: .1em .2em\"><mtr><mtd><mrow><msub><mi>x</mi><mtext>seat</mtext></msub></mrow></mtd></mtr><mtr><mtd><mrow><msub><mi>y</mi><mtext>seat</mtext></msub></mrow></mtd></mtr><mtr><mtd><mrow><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mtd></mtr><mtr><mtd><mrow><msub><mi>x</mi><mtext>bar</mtext></msub></mrow></mtd></mtr><mtr><mtd><mrow><msub><mi>y</mi><mtext>bar</mtext></msub></mrow></mtd></mtr><mtr><mtd><mrow><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mtd></mtr></mtable></math>",
            },
            ezy::Equation {
                name: "velocities",
                text: "    [ seat.vx    ]\n    [ seat.vy    ]\nv = [ seat.omega ]\n    [ bar.vx     ]\n    [ bar.vy     ]\n    [ bar.omega  ]\n",
                latex: "v = \\begin{bmatrix} \\dot{x}_{\\mathrm{seat}} \\\\ \\dot{y}_{\\mathrm{seat}} \\\\ \\dot{\\varphi}_{\\mathrm{seat}} \\\\ \\dot{x}_{\\mathrm{bar}} \\\\ \\dot{y}_{\\mathrm{bar}} \\\\ \\dot{\\varphi}_{\\mathrm{bar}} \\end{bmatrix}",
                mathml: "<math display=\"block\"><mrow><mi>v</mi></mrow><mo>=</mo><mtable style=\"border: solid; border-width: 0 .09em; border-radius: .7em; padding: .1em .2em\"><mtr><mtd><mrow><msub><mover><mi>x</mi><mo>.</mo></mover><mtext>seat</mtext></msub></mrow></mtd></mtr><mtr><mtd><mrow><msub><mover><mi>y</mi><mo>.</mo></mover><mtext>seat</mtext></msub></mrow></mtd></mtr><mtr><mtd><mrow><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext></msub></mrow></mtd></mtr><mtr><mtd><mrow><msub><mover><mi>x</mi><mo>.</mo></mover><mtext>bar</mtext></msub></mrow></mtd></mtr><mtr><mtd><mrow><msub><mover><mi>y</mi><mo>.</mo></mover><mtext>bar</mtext></msub></mrow></mtd></mtr><mtr><mtd><mrow><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext></msub></mrow></mtd></mtr></mtable></math>",
            },
            ezy::Equation {
                name: "points",
                text: "A = (seat.x - a*cos(seat.phi), seat.y - a*sin(seat.phi))\nC = (bar.x + c*cos(bar.phi), bar.y + c*sin(bar.phi))\nB = (seat.x + b*cos(seat.phi), seat.y + b*sin(seat.phi))\n",
                latex: "\\begin{aligned} A &= \\begin{bmatrix} x_{\\mathrm{seat}} - a \\, \\cos{\\varphi_{\\mathrm{seat}}} \\\\ y_{\\mathrm{seat}} - a \\, \\sin{\\varphi_{\\mathrm{seat}}} \\end{bmatrix} \\\\ C &= \\begin{bmatrix} x_{\\mathrm{bar}} + c \\, \\cos{\\varphi_{\\mathrm{bar}}} \\\\ y_{\\mathrm{bar}} + c \\, \\sin{\\varphi_{\\mathrm{bar}}} \\end{bmatrix} \\\\ B &= \\begin{bmatrix} x_{\\mathrm{seat}} + b \\, \\cos{\\varphi_{\\mathrm{seat}}} \\\\ y_{\\mathrm{seat}} + b \\, \\sin{\\varphi_{\\mathrm{seat}}} \\end{bmatrix} \\end{aligned}",
                mathml: "<math display=\"block\"><mtable><mtr><mtd><mi>A</mi></mtd><mtd><mo>=</mo></mtd><mtd><mrow><mtable style=\"border: solid; border-width: 0 .09em; border-radius: .7em; padding: .1em .2em\"><mtr><mtd><mrow><msub><mi>x</mi><mtext>seat</mtext></msub><mo>−</mo><mi>a</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow></mtd></mtr><mtr><mtd><mrow><msub><mi>y</mi><mtext>seat</mtext></msub><mo>−</mo><mi>a</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow></mtd></mtr></mtable></mrow></mtd></mtr><mtr><mtd><mi>C</mi></mtd><mtd><mo>=</mo></mtd><mtd><mrow><mtable style=\"border: solid; border-width: 0 .09em; border-radius: .7em; padding: .1em .2em\"><mtr><mtd><mrow><msub><mi>x</mi><mtext>bar</mtext></msub><mo>+</mo><mi>c</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow></mtd></mtr><mtr><mtd><mrow><msub><mi>y</mi><mtext>bar</mtext></msub><mo>+</mo><mi>c</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow></mtd></mtr></mtable></mrow></mtd></mtr><mtr><mtd><mi>B</mi></mtd><mtd><mo>=</mo></mtd><mtd><mrow><mtable style=\"border: solid; border-width: 0 .09em; border-radius: .7em; padding: .1em .2em\"><mtr><mtd><mrow><msub><mi>x</mi><mtext>seat</mtext></msub><mo>+</mo><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow></mtd></mtr><mtr><mtd><mrow><msub><mi>y</mi><mtext>seat</mtext></msub><mo>+</mo><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow></mtd></mtr></mtable></mrow></mtd></mtr></mtable></math>",
            },
            ezy::Equation {
                name: "position constraint",
                text: "0 = C = [ seat.x + b*cos(seat.phi) - bar.x + d*cos(bar.phi) ]   B.x\n        [ seat.y + b*sin(seat.phi) - bar.y + d*sin(bar.phi) ]   B.y\n",
                latex: "0 = C = \\begin{bmatrix} x_{\\mathrm{seat}} + b \\, \\cos{\\varphi_{\\mathrm{seat}}} - x_{\\mathrm{bar}} + d \\, \\cos{\\varphi_{\\mathrm{bar}}} \\\\ y_{\\mathrm{seat}} + b \\, \\sin{\\varphi_{\\mathrm{seat}}} - y_{\\mathrm{bar}} + d \\, \\sin{\\varphi_{\\mathrm{bar}}} \\end{bmatrix}",
                mathml: "<math display=\"block\"><mrow><mn>0</mn></mrow><mo>=</mo><mrow><mi>C</mi></mrow><mo>=</mo><mtable><mtr><mtd style=\"border: solid; border-width: 0 .09em; border-radius: .7em .7em 0 0\"><mrow><msub><mi>x</mi><mtext>seat</mtext></msub><mo>+</mo><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>−</mo><msub><mi>x</mi><mtext>bar</mtext></msub><mo>+</mo><mi>d</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow></mtd><mtd><mspace width=\"1em\"/><mtext>B.x</mtext></mtd></mtr><mtr><mtd style=\"border: solid; border-width: 0 .09em; border-radius: 0 0 .7em .7em\"><mrow><msub><mi>y</mi><mtext>seat</mtext></msub><mo>+</mo><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>−</mo><msub><mi>y</mi><mtext>bar</mtext></msub><mo>+</mo><mi>d</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow></mtd><mtd><mspace width=\"1em\"/><mtext>B.y</mtext></mtd></mtr></mtable></math>",
            },
            ezy::Equation {
                name: "Jacobian of the position constraint",
                text: "C_q = [ 1  0  -b*sin(seat.phi)  -1  0   -d*sin(bar.phi) ]   B.x\n      [ 0  1  b*cos(seat.phi)   0   -1  d*cos(bar.phi)  ]   B.y\n",
                latex: "C_q = \\begin{bmatrix} 1 & 0 & -b \\, \\sin{\\varphi_{\\mathrm{seat}}} & -1 & 0 & -d \\, \\sin{\\varphi_{\\mathrm{bar}}} \\\\ 0 & 1 & b \\, \\cos{\\varphi_{\\mathrm{seat}}} & 0 & -1 & d \\, \\cos{\\varphi_{\\mathrm{bar}}} \\end{bmatrix}",
                mathml: "<math display=\"block\"><mrow><msub><mi>C</mi><mi>q</mi></msub></mrow><mo>=</mo><mtable style=\"border: solid; border-width: 0 .09em; border-radius: .7em; padding: .1em .2em\"><mtr><mtd><mrow><mn>1</mn></mrow></mtd><mtd><mrow><mn>0</mn></mrow></mtd><mtd><mrow><mo>−</mo><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow></mtd><mtd><mrow><mo>−</mo><mn>1</mn></mrow></mtd><mtd><mrow><mn>0</mn></mrow></mtd><mtd><mrow><mo>−</mo><mi>d</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow></mtd></mtr><mtr><mtd><mrow><mn>0</mn></mrow></mtd><mtd><mrow><mn>1</mn></mrow></mtd><mtd><mrow><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow></mtd><mtd><mrow><mn>0</mn></mrow></mtd><mtd><mrow><mo>−</mo><mn>1</mn></mrow></mtd><mtd><mrow><mi>d</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow></mtd></mtr></mtable></math>",
            },
            ezy::Equation {
                name: "convective term of the position constraint",
                text: "h = [ -b*seat.omega^2*cos(seat.phi) - d*bar.omega^2*cos(bar.phi) ]   B.x\n    [ -b*seat.omega^2*sin(seat.phi) - d*bar.omega^2*sin(bar.phi) ]   B.y\n",
                latex: "h = \\begin{bmatrix} -b \\, \\dot{\\varphi}_{\\mathrm{seat}}^{2} \\, \\cos{\\varphi_{\\mathrm{seat}}} - d \\, \\dot{\\varphi}_{\\mathrm{bar}}^{2} \\, \\cos{\\varphi_{\\mathrm{bar}}} \\\\ -b \\, \\dot{\\varphi}_{\\mathrm{seat}}^{2} \\, \\sin{\\varphi_{\\mathrm{seat}}} - d \\, \\dot{\\varphi}_{\\mathrm{bar}}^{2} \\, \\sin{\\varphi_{\\mathrm{bar}}} \\end{bmatrix}",
                mathml: "<math display=\"block\"><mrow><mi>h</mi></mrow><mo>=</mo><mtable><mtr><mtd style=\"border: solid; border-width: 0 .09em; border-radius: .7em .7em 0 0\"><mrow><mo>−</mo><mi>b</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>−</mo><mi>d</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow></mtd><mtd><mspace width=\"1em\"/><mtext>B.x</mtext></mtd></mtr><mtr><mtd style=\"border: solid; border-width: 0 .09em; border-radius: 0 0 .7em .7em\"><mrow><mo>−</mo><mi>b</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>−</mo><mi>d</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow></mtd><mtd><mspace width=\"1em\"/><mtext>B.y</mtext></mtd></mtr></mtable></math>",
            },
            ezy::Equation {
                name: "velocity constraint",
                text: "0 = S v + s_t = [ -a*seat.omega - seat.vx*sin(seat.phi) + seat.vy*cos(seat.phi) ]   rear\n                [ c*bar.omega - bar.vx*sin(bar.phi) + bar.vy*cos(bar.phi)       ]   front\n",
                latex: "0 = S v + s_t = \\begin{bmatrix} -a \\, \\dot{\\varphi}_{\\mathrm{seat}} - \\dot{x}_{\\mathrm{seat}} \\, \\sin{\\varphi_{\\mathrm{seat}}} + \\dot{y}_{\\mathrm{seat}} \\, \\cos{\\varphi_{\\mathrm{seat}}} \\\\ c \\, \\dot{\\varphi}_{\\mathrm{bar}} - \\dot{x}_{\\mathrm{bar}} \\, \\sin{\\varphi_{\\mathrm{bar}}} + \\dot{y}_{\\mathrm{bar}} \\, \\cos{\\varphi_{\\mathrm{bar}}} \\end{bmatrix}",
                mathml: "<math display=\"block\"><mrow><mn>0</mn></mrow><mo>=</mo><mrow><mi>S</mi><mi>v</mi><mo>+</mo><msub><mi>s</mi><mi>t</mi></msub></mrow><mo>=</mo><mtable><mtr><mtd style=\"border: solid; border-width: 0 .09em; border-radius: .7em .7em 0 0\"><mrow><mo>−</mo><mi>a</mi><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mo>−</mo><msub><mover><mi>x</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>+</mo><msub><mover><mi>y</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow></mtd><mtd><mspace width=\"1em\"/><mtext>rear</mtext></mtd></mtr><mtr><mtd style=\"border: solid; border-width: 0 .09em; border-radius: 0 0 .7em .7em\"><mrow><mi>c</mi><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mo>−</mo><msub><mover><mi>x</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow><mo>+</mo><msub><mover><mi>y</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow></mtd><mtd><mspace width=\"1em\"/><mtext>front</mtext></mtd></mtr></mtable></math>",
            },
            ezy::Equation {
                name: "Jacobian of the velocity constraint",
                text: "S = [ -sin(seat.phi)  cos(seat.phi)  -a  0              0             0 ]   rear\n    [ 0               0              0   -sin(bar.phi)  cos(bar.phi)  c ]   front\n",
                latex: "S = \\begin{bmatrix} -\\sin{\\varphi_{\\mathrm{seat}}} & \\cos{\\varphi_{\\mathrm{seat}}} & -a & 0 & 0 & 0 \\\\ 0 & 0 & 0 & -\\sin{\\varphi_{\\mathrm{bar}}} & \\cos{\\varphi_{\\mathrm{bar}}} & c \\end{bmatrix}",
                mathml: "<math display=\"block\"><mrow><mi>S</mi></mrow><mo>=</mo><mtable style=\"border: solid; border-width: 0 .09em; border-radius: .7em; padding: .1em .2em\"><mtr><mtd><mrow><mo>−</mo><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow></mtd><mtd><mrow><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow></mtd><mtd><mrow><mo>−</mo><mi>a</mi></mrow></mtd><mtd><mrow><mn>0</mn></mrow></mtd><mtd><mrow><mn>0</mn></mrow></mtd><mtd><mrow><mn>0</mn></mrow></mtd></mtr><mtr><mtd><mrow><mn>0</mn></mrow></mtd><mtd><mrow><mn>0</mn></mrow></mtd><mtd><mrow><mn>0</mn></mrow></mtd><mtd><mrow><mo>−</mo><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow></mtd><mtd><mrow><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow></mtd><mtd><mrow><mi>c</mi></mrow></mtd></mtr></mtable></math>",
            },
            ezy::Equation {
                name: "convective term of the velocity constraint",
                text: "s = [ -seat.vx*seat.omega*cos(seat.phi) - seat.vy*seat.omega*sin(seat.phi) ]   rear\n    [ -bar.vx*bar.omega*cos(bar.phi) - bar.vy*bar.omega*sin(bar.phi)       ]   front\n",
                latex: "s = \\begin{bmatrix} -\\dot{x}_{\\mathrm{seat}} \\, \\dot{\\varphi}_{\\mathrm{seat}} \\, \\cos{\\varphi_{\\mathrm{seat}}} - \\dot{y}_{\\mathrm{seat}} \\, \\dot{\\varphi}_{\\mathrm{seat}} \\, \\sin{\\varphi_{\\mathrm{seat}}} \\\\ -\\dot{x}_{\\mathrm{bar}} \\, \\dot{\\varphi}_{\\mathrm{bar}} \\, \\cos{\\varphi_{\\mathrm{bar}}} - \\dot{y}_{\\mathrm{bar}} \\, \\dot{\\varphi}_{\\mathrm{bar}} \\, \\sin{\\varphi_{\\mathrm{bar}}} \\end{bmatrix}",
                mathml: "<math display=\"block\"><mrow><mi>s</mi></mrow><mo>=</mo><mtable><mtr><mtd style=\"border: solid; border-width: 0 .09em; border-radius: .7em .7em 0 0\"><mrow><mo>−</mo><msub><mover><mi>x</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>−</mo><msub><mover><mi>y</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow></mtd><mtd><mspace width=\"1em\"/><mtext>rear</mtext></mtd></mtr><mtr><mtd style=\"border: solid; border-width: 0 .09em; border-radius: 0 0 .7em .7em\"><mrow><mo>−</mo><msub><mover><mi>x</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow><mo>−</mo><msub><mover><mi>y</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow></mtd><mtd><mspace width=\"1em\"/><mtext>front</mtext></mtd></mtr></mtable></math>",
            },
            ezy::Equation {
                name: "mass matrix",
                text: "         [ m1 ]   seat.x\n         [ m1 ]   seat.y\ndiag M = [ i1 ]   seat.phi\n         [ m2 ]   bar.x\n         [ m2 ]   bar.y\n         [ i2 ]   bar.phi\n",
                latex: "\\mathrm{diag}\\,M = \\begin{bmatrix} m_{1} \\\\ m_{1} \\\\ i_{1} \\\\ m_{2} \\\\ m_{2} \\\\ i_{2} \\end{bmatrix}",
                mathml: "<math display=\"block\"><mrow><mtext>diag </mtext><mi>M</mi></mrow><mo>=</mo><mtable><mtr><mtd style=\"border: solid; border-width: 0 .09em; border-radius: .7em .7em 0 0\"><mrow><msub><mi>m</mi><mtext>1</mtext></msub></mrow></mtd><mtd><mspace width=\"1em\"/><mtext>seat.x</mtext></mtd></mtr><mtr><mtd style=\"border: solid; border-width: 0 .09em; border-radius: 0 0 0 0\"><mrow><msub><mi>m</mi><mtext>1</mtext></msub></mrow></mtd><mtd><mspace width=\"1em\"/><mtext>seat.y</mtext></mtd></mtr><mtr><mtd style=\"border: solid; border-width: 0 .09em; border-radius: 0 0 0 0\"><mrow><msub><mi>i</mi><mtext>1</mtext></msub></mrow></mtd><mtd><mspace width=\"1em\"/><mtext>seat.phi</mtext></mtd></mtr><mtr><mtd style=\"border: solid; border-width: 0 .09em; border-radius: 0 0 0 0\"><mrow><msub><mi>m</mi><mtext>2</mtext></msub></mrow></mtd><mtd><mspace width=\"1em\"/><mtext>bar.x</mtext></mtd></mtr><mtr><mtd style=\"border: solid; border-width: 0 .09em; border-radius: 0 0 0 0\"><mrow><msub><mi>m</mi><mtext>2</mtext></msub></mrow></mtd><mtd><mspace width=\"1em\"/><mtext>bar.y</mtext></mtd></mtr><mtr><mtd style=\"border: solid; border-width: 0 .09em; border-radius: 0 0 .7em .7em\"><mrow><msub><mi>i</mi><mtext>2</mtext></msub></mrow></mtd><mtd><mspace width=\"1em\"/><mtext>bar.phi</mtext></mtd></mtr></mtable></math>",
            },
            ezy::Equation {
                name: "applied force",
                text: "    [ 0 ]   seat.x\n    [ 0 ]   seat.y\nF = [ 0 ]   seat.phi\n    [ 0 ]   bar.x\n    [ 0 ]   bar.y\n    [ 0 ]   bar.phi\n",
                latex: "F = \\begin{bmatrix} 0 \\\\ 0 \\\\ 0 \\\\ 0 \\\\ 0 \\\\ 0 \\end{bmatrix}",
                mathml: "<math display=\"block\"><mrow><mi>F</mi></mrow><mo>=</mo><mtable><mtr><mtd style=\"border: solid; border-width: 0 .09em; border-radius: .7em .7em 0 0\"><mrow><mn>0</mn></mrow></mtd><mtd><mspace width=\"1em\"/><mtext>seat.x</mtext></mtd></mtr><mtr><mtd style=\"border: solid; border-width: 0 .09em; border-radius: 0 0 0 0\"><mrow><mn>0</mn></mrow></mtd><mtd><mspace width=\"1em\"/><mtext>seat.y</mtext></mtd></mtr><mtr><mtd style=\"border: solid; border-width: 0 .09em; border-radius: 0 0 0 0\"><mrow><mn>0</mn></mrow></mtd><mtd><mspace width=\"1em\"/><mtext>seat.phi</mtext></mtd></mtr><mtr><mtd style=\"border: solid; border-width: 0 .09em; border-radius: 0 0 0 0\"><mrow><mn>0</mn></mrow></mtd><mtd><mspace width=\"1em\"/><mtext>bar.x</mtext></mtd></mtr><mtr><mtd style=\"border: solid; border-width: 0 .09em; border-radius: 0 0 0 0\"><mrow><mn>0</mn></mrow></mtd><mtd><mspace width=\"1em\"/><mtext>bar.y</mtext></mtd></mtr><mtr><mtd style=\"border: solid; border-width: 0 .09em; border-radius: 0 0 .7em .7em\"><mrow><mn>0</mn></mrow></mtd><mtd><mspace width=\"1em\"/><mtext>bar.phi</mtext></mtd></mtr></mtable></math>",
            },
            ezy::Equation {
                name: "equations of motion",
                text: "[ M    C_q^T  S^T ] [ a        ]   [ F  ]\n[ C_q  0      0   ] [ lambda_C ] = [ -h ]\n[ S    0      0   ] [ lambda_S ]   [ -s ]\n",
                latex: "\\begin{bmatrix} M & C_q^T & S^T \\\\ C_q & 0 & 0 \\\\ S & 0 & 0 \\end{bmatrix}\\begin{bmatrix} a \\\\ \\lambda_C \\\\ \\lambda_S \\end{bmatrix} = \\begin{bmatrix} F \\\\ -h \\\\ -s \\end{bmatrix}",
                mathml: "<math display=\"block\"><mtable style=\"border: solid; border-width: 0 .09em; border-radius: .7em; padding: .1em .2em\"><mtr><mtd><mrow><mi>M</mi></mrow></mtd><mtd><mrow><msubsup><mi>C</mi><mi>q</mi><mi>T</mi></msubsup></mrow></mtd><mtd><mrow><msup><mi>S</mi><mi>T</mi></msup></mrow></mtd></mtr><mtr><mtd><mrow><msub><mi>C</mi><mi>q</mi></msub></mrow></mtd><mtd><mrow><mn>0</mn></mrow></mtd><mtd><mrow><mn>0</mn></mrow></mtd></mtr><mtr><mtd><mrow><mi>S</mi></mrow></mtd><mtd><mrow><mn>0</mn></mrow></mtd><mtd><mrow><mn>0</mn></mrow></mtd></mtr></mtable><mtable style=\"border: solid; border-width: 0 .09em; border-radius: .7em; padding: .1em .2em\"><mtr><mtd><mrow><mi>a</mi></mrow></mtd></mtr><mtr><mtd><mrow><msub><mi>λ</mi><mi>C</mi></msub></mrow></mtd></mtr><mtr><mtd><mrow><msub><mi>λ</mi><mi>S</mi></msub></mrow></mtd></mtr></mtable><mo>=</mo><mtable style=\"border: solid; border-width: 0 .09em; border-radius: .7em; padding: .1em .2em\"><mtr><mtd><mrow><mi>F</mi></mrow></mtd></mtr><mtr><mtd><mrow><mrow><mo>−</mo><mi>h</mi></mrow></mrow></mtd></mtr><mtr><mtd><mrow><mrow><mo>−</mo><mi>s</mi></mrow></mrow></mtd></mtr></mtable></math>",
            },
        ],
        elimination: &[
            ezy::EliminationStep {
                rows: &[2usize],
                constant_pivot: true,
            },
            ezy::EliminationStep {
                rows: &[3usize],
                constant_pivot: true,
            },
            ezy::EliminationStep {
                rows: &[0usize, 1usize],
                constant_pivot: false,
            },
        ],
        acceleration_operations: ezy::Operations {
            add: 29usize,
            mul: 56usize,
            div: 1usize,
            trig: 2usize,
            calls: 0usize,
        },
        correction_operations: ezy::Operations {
            add: 23usize,
            mul: 42usize,
            div: 1usize,
            trig: 2usize,
            calls: 0usize,
        },
        feedback: ::core::option::Option::Some(&[2usize, 5usize]),
        quasi_velocities: ::core::option::Option::Some(ezy::QuasiVelocitiesInfo {
            formulas: &[
                ezy::Formula {
                    text: "seat.vx*cos(seat.phi) + seat.vy*sin(seat.phi)",
                    latex: "\\dot{x}_{\\mathrm{seat}} \\, \\cos{\\varphi_{\\mathrm{seat}}} + \\dot{y}_{\\mathrm{seat}} \\, \\sin{\\varphi_{\\mathrm{seat}}}",
                    mathml: "<mrow><msub><mover><mi>x</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>+</mo><msub><mover><mi>y</mi><mo>.</mo></mover><mtext>seat</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                },
                ezy::Formula {
                    text: "seat.omega",
                    latex: "\\dot{\\varphi}_{\\mathrm{seat}}",
                    mathml: "<mrow><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext></msub></mrow>",
                },
            ],
            feedback: &[5usize],
            integrals: &[(2usize, 1usize)],
            integrated: &[2usize, 5usize, 0usize, 1usize],
            n_read: 2usize,
            has_free_body: false,
            n_of_time: 0usize,
            n_angles: 1usize,
            operations: ezy::Operations {
                add: 25usize,
                mul: 50usize,
                div: 2usize,
                trig: 1usize,
                calls: 0usize,
            },
        }),
        series: ezy::SeriesInfo::Analytic {
            n_products: 16usize,
            operations: ezy::Operations {
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
