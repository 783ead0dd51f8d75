///A seat on a rear wheel, steered and driven by swinging a front bar on its own wheel.
#[allow(non_snake_case, unused_variables, clippy::all, clippy::pedantic)]
pub mod ezy_roller {}
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
            name: "ice",
            documentation: "The rear wheel on ice: it holds sideways up to a force and slides beyond it, with that force as friction.",
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
            name: "skid",
            info: || &Skid::INFO,
            new: || ::std::boxed::Box::new(<Skid as ::core::default::Default>::default()),
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
#[doc(hidden)]
pub mod modes_of_skid {
    ///Driven, with a rear wheel on ice that holds and slides by turns.
    ///
    ///Cost of the accelerations and multipliers: 56 mul, 30 add, 1 div, 3 sin–cos.
    #[cfg_attr(
        doc,
        doc = "\nFreedom: 4 of positions, 3 of velocities.\n\n# Parameters\n\n|  | parameter | default | effect | what it is |\n| --- | --- | --- | --- | --- |\n| <math><mi>a</mi></math> | `a` | 0.2 m |  | rear wheel A, behind the seat's centre of mass |\n| <math><mi>b</mi></math> | `b` | 0.6 m |  | hinge B, ahead of the seat's centre of mass |\n| <math><mi>c</mi></math> | `c` | 0.1 m |  | front wheel C, beyond the bar's centre of mass |\n| <math><mi>d</mi></math> | `d` | 0.1 m |  | bar's centre of mass, beyond the hinge |\n| <math><msub><mi>m</mi><mtext>1</mtext></msub></math> | `m1` | 46.0 kg |  | mass of seat and rider |\n| <math><msub><mi>i</mi><mtext>1</mtext></msub></math> | `i1` | 10.0 kg·m² |  | moment of inertia of seat and rider |\n| <math><msub><mi>m</mi><mtext>2</mtext></msub></math> | `m2` | 1.0 kg |  | mass of the bar |\n| <math><msub><mi>i</mi><mtext>2</mtext></msub></math> | `i2` | 0.005 kg·m² |  | moment of inertia of the bar |\n| <math><msub><mi>m</mi><mtext>0</mtext></msub></math> | `m0` | 2.0 N·m | `pump` | largest torque |\n| <math><mi>ω</mi></math> | `omega` | pi rad/s | `pump` | angular frequency of the torque |\n| <math><mi>hold</mi></math> | `hold` | 4.0 N | `ice` | largest side force |\n\n# Rows\n\n| row | word | level | unit of its multiplier |\n| --- | --- | --- | --- |\n| `B.x` | hinge | position | N |\n| `B.y` | hinge | position | N |\n| `front` | skate | velocity | N |\n\n# Coordinates and velocities\n\n<div style=\"overflow-x: auto; padding: .3em 0\"><math display=\"block\"><mi>q</mi><mo>=</mo><mtable style=\"border: solid; border-width: 0 .09em; border-radius: .7em; padding: .1em .2em\"><mtr><mtd><msub><mi>x</mi><mtext>seat</mtext></msub></mtd></mtr><mtr><mtd><msub><mi>y</mi><mtext>seat</mtext></msub></mtd></mtr><mtr><mtd><msub><mi>φ</mi><mtext>seat</mtext></msub></mtd></mtr><mtr><mtd><msub><mi>x</mi><mtext>bar</mtext></msub></mtd></mtr><mtr><mtd><msub><mi>y</mi><mtext>bar</mtext></msub></mtd></mtr><mtr><mtd><msub><mi>φ</mi><mtext>bar</mtext></msub></mtd></mtr></mtable><mo>,</mo><mspace width=\"1em\"/><mi>v</mi><mo>=</mo><mtable style=\"border: solid; border-width: 0 .09em; border-radius: .7em; padding: .1em .2em\"><mtr><mtd><msub><mover><mi>x</mi><mo>.</mo></mover><mtext>seat</mtext></msub></mtd></mtr><mtr><mtd><msub><mover><mi>y</mi><mo>.</mo></mover><mtext>seat</mtext></msub></mtd></mtr><mtr><mtd><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext></msub></mtd></mtr><mtr><mtd><msub><mover><mi>x</mi><mo>.</mo></mover><mtext>bar</mtext></msub></mtd></mtr><mtr><mtd><msub><mover><mi>y</mi><mo>.</mo></mover><mtext>bar</mtext></msub></mtd></mtr><mtr><mtd><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext></msub></mtd></mtr></mtable></math></div>\n\n# Points\n\n<div style=\"overflow-x: auto; padding: .3em 0\"><math display=\"block\"><mtable><mtr><mtd><mi>A</mi><mo>=</mo><mtable style=\"border: solid; border-width: 0 .09em; border-radius: .7em; padding: .1em .2em\"><mtr><mtd><mrow><msub><mi>x</mi><mtext>seat</mtext></msub><mo>−</mo><mi>a</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow></mtd></mtr><mtr><mtd><mrow><msub><mi>y</mi><mtext>seat</mtext></msub><mo>−</mo><mi>a</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow></mtd></mtr></mtable></mtd></mtr><mtr><mtd><mi>C</mi><mo>=</mo><mtable style=\"border: solid; border-width: 0 .09em; border-radius: .7em; padding: .1em .2em\"><mtr><mtd><mrow><msub><mi>x</mi><mtext>bar</mtext></msub><mo>+</mo><mi>c</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow></mtd></mtr><mtr><mtd><mrow><msub><mi>y</mi><mtext>bar</mtext></msub><mo>+</mo><mi>c</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow></mtd></mtr></mtable></mtd></mtr><mtr><mtd><mi>B</mi><mo>=</mo><mtable style=\"border: solid; border-width: 0 .09em; border-radius: .7em; padding: .1em .2em\"><mtr><mtd><mrow><msub><mi>x</mi><mtext>seat</mtext></msub><mo>+</mo><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow></mtd></mtr><mtr><mtd><mrow><msub><mi>y</mi><mtext>seat</mtext></msub><mo>+</mo><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow></mtd></mtr></mtable></mtd></mtr></mtable></math></div>\n\n# Position constraint\n\n<div style=\"overflow-x: auto; padding: .3em 0\"><math display=\"block\"><mn>0</mn><mo>=</mo><mi>C</mi><mo>=</mo><mtable><mtr><mtd style=\"border: solid; border-width: 0 .09em; border-radius: .7em .7em 0 0\"><mrow><msub><mi>x</mi><mtext>seat</mtext></msub><mo>+</mo><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>−</mo><msub><mi>x</mi><mtext>bar</mtext></msub><mo>+</mo><mi>d</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow></mtd><mtd><mspace width=\"1em\"/><mtext>B.x</mtext></mtd></mtr><mtr><mtd style=\"border: solid; border-width: 0 .09em; border-radius: 0 0 .7em .7em\"><mrow><msub><mi>y</mi><mtext>seat</mtext></msub><mo>+</mo><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>−</mo><msub><mi>y</mi><mtext>bar</mtext></msub><mo>+</mo><mi>d</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow></mtd><mtd><mspace width=\"1em\"/><mtext>B.y</mtext></mtd></mtr></mtable></math></div>\n\n<div style=\"overflow-x: auto; padding: .3em 0\"><math display=\"block\"><msub><mi>C</mi><mi>q</mi></msub><mo>=</mo><mtable style=\"border: solid; border-width: 0 .09em; border-radius: .7em; padding: .1em .2em\"><mtr><mtd><mrow><mn>1</mn></mrow></mtd><mtd><mn>0</mn></mtd><mtd><mrow><mo>−</mo><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow></mtd><mtd><mrow><mo>−</mo><mn>1</mn></mrow></mtd><mtd><mn>0</mn></mtd><mtd><mrow><mo>−</mo><mi>d</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow></mtd></mtr><mtr><mtd><mn>0</mn></mtd><mtd><mrow><mn>1</mn></mrow></mtd><mtd><mrow><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow></mtd><mtd><mn>0</mn></mtd><mtd><mrow><mo>−</mo><mn>1</mn></mrow></mtd><mtd><mrow><mi>d</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow></mtd></mtr></mtable></math></div>\n\n<div style=\"overflow-x: auto; padding: .3em 0\"><math display=\"block\"><mi>h</mi><mo>=</mo><mtable style=\"border: solid; border-width: 0 .09em; border-radius: .7em; padding: .1em .2em\"><mtr><mtd><mrow><mo>−</mo><mi>b</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>−</mo><mi>d</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow></mtd></mtr><mtr><mtd><mrow><mo>−</mo><mi>b</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>−</mo><mi>d</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow></mtd></mtr></mtable></math></div>\n\n# Velocity constraint\n\n<div style=\"overflow-x: auto; padding: .3em 0\"><math display=\"block\"><mn>0</mn><mo>=</mo><mi>S</mi><mi>v</mi><mo>+</mo><msub><mi>s</mi><mi>t</mi></msub><mo>=</mo><mtable><mtr><mtd style=\"border: solid; border-width: 0 .09em; border-radius: .7em .7em .7em .7em\"><mrow><mi>c</mi><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mo>−</mo><msub><mover><mi>x</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow><mo>+</mo><msub><mover><mi>y</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow></mtd><mtd><mspace width=\"1em\"/><mtext>front</mtext></mtd></mtr></mtable></math></div>\n\n<div style=\"overflow-x: auto; padding: .3em 0\"><math display=\"block\"><mi>S</mi><mo>=</mo><mtable style=\"border: solid; border-width: 0 .09em; border-radius: .7em; padding: .1em .2em\"><mtr><mtd><mn>0</mn></mtd><mtd><mn>0</mn></mtd><mtd><mn>0</mn></mtd><mtd><mrow><mo>−</mo><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow></mtd><mtd><mrow><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow></mtd><mtd><mrow><mi>c</mi></mrow></mtd></mtr></mtable></math></div>\n\n<div style=\"overflow-x: auto; padding: .3em 0\"><math display=\"block\"><mi>s</mi><mo>=</mo><mtable style=\"border: solid; border-width: 0 .09em; border-radius: .7em; padding: .1em .2em\"><mtr><mtd><mrow><mo>−</mo><msub><mover><mi>x</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow><mo>−</mo><msub><mover><mi>y</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow></mtd></mtr></mtable></math></div>\n\n# Mass matrix\n\n<div style=\"overflow-x: auto; padding: .3em 0\"><math display=\"block\"><mi>M</mi><mo>=</mo><mi>diag</mi><mo>(</mo><mrow><msub><mi>m</mi><mtext>1</mtext></msub></mrow><mo>,</mo><mrow><msub><mi>m</mi><mtext>1</mtext></msub></mrow><mo>,</mo><mrow><msub><mi>i</mi><mtext>1</mtext></msub></mrow><mo>,</mo><mrow><msub><mi>m</mi><mtext>2</mtext></msub></mrow><mo>,</mo><mrow><msub><mi>m</mi><mtext>2</mtext></msub></mrow><mo>,</mo><mrow><msub><mi>i</mi><mtext>2</mtext></msub></mrow><mo>)</mo></math></div>\n\n# Applied force\n\n<div style=\"overflow-x: auto; padding: .3em 0\"><math display=\"block\"><mi>F</mi><mo>=</mo><mtable style=\"border: solid; border-width: 0 .09em; border-radius: .7em; padding: .1em .2em\"><mtr><mtd><mrow><mi>hold</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow></mtd></mtr><mtr><mtd><mrow><mo>−</mo><mi>hold</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow></mtd></mtr><mtr><mtd><mrow><mi>hold</mi><mspace width=\"0.17em\"/><mi>a</mi><mo>+</mo><msub><mi>m</mi><mtext>0</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mrow><mo>(</mo><mi>ω</mi><mspace width=\"0.17em\"/><mi>t</mi><mo>)</mo></mrow></mrow></mrow></mtd></mtr><mtr><mtd><mrow><mn>0</mn></mrow></mtd></mtr><mtr><mtd><mrow><mn>0</mn></mrow></mtd></mtr><mtr><mtd><mrow><mo>−</mo><msub><mi>m</mi><mtext>0</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mrow><mo>(</mo><mi>ω</mi><mspace width=\"0.17em\"/><mi>t</mi><mo>)</mo></mrow></mrow></mrow></mtd></mtr></mtable></math></div>\n\n# Equations of motion\n\n<div style=\"overflow-x: auto; padding: .3em 0\"><math display=\"block\"><mtable style=\"border: solid; border-width: 0 .09em; border-radius: .7em; padding: .1em .2em\"><mtr><mtd><mi>M</mi></mtd><mtd><msubsup><mi>C</mi><mi>q</mi><mi>T</mi></msubsup></mtd><mtd><msup><mi>S</mi><mi>T</mi></msup></mtd></mtr><mtr><mtd><msub><mi>C</mi><mi>q</mi></msub></mtd><mtd><mn>0</mn></mtd><mtd><mn>0</mn></mtd></mtr><mtr><mtd><mi>S</mi></mtd><mtd><mn>0</mn></mtd><mtd><mn>0</mn></mtd></mtr></mtable><mtable style=\"border: solid; border-width: 0 .09em; border-radius: .7em; padding: .1em .2em\"><mtr><mtd><mi>a</mi></mtd></mtr><mtr><mtd><msub><mi>λ</mi><mi>C</mi></msub></mtd></mtr><mtr><mtd><msub><mi>λ</mi><mi>S</mi></msub></mtd></mtr></mtable><mo>=</mo><mtable style=\"border: solid; border-width: 0 .09em; border-radius: .7em; padding: .1em .2em\"><mtr><mtd><mi>F</mi></mtd></mtr><mtr><mtd><mrow><mo>−</mo><mi>h</mi></mrow></mtd></mtr><mtr><mtd><mrow><mo>−</mo><mi>s</mi></mrow></mtd></mtr></mtable></math></div>\n\n# Sparsity of the Jacobian\n\nColumns: x, y and φ of each body.\n\n```text\n       seat  bar\nB.x    x.x   x.x\nB.y    .xx   .xx\nfront  ...   xxx\n```\n\n# Order of elimination\n\n1. `front`: pivot of parameters alone, computed once\n2. `B.x`, `B.y`: pivot of the state\n\n# Operations\n\n|  | multiplications | additions | divisions | sines and cosines | other functions |\n| --- | --- | --- | --- | --- | --- |\n| accelerations and multipliers | 56 | 30 | 1 | 3 | 0 |\n| projection | 34 | 18 | 1 | 2 | 0 |"
    )]
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct SlidesLeft {
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
        ///largest side force (N); default `4.0`.
        pub hold: f64,
    }
    impl ::core::default::Default for SlidesLeft {
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
                hold: 4f64,
            }
        }
    }
    impl SlidesLeft {
        /// What is known of the scene when it is compiled.
        pub const INFO: ::ezy_core::model::SceneInfo = ::ezy_core::model::SceneInfo {
            model: "EzyRoller",
            name: "skid",
            documentation: "Driven, with a rear wheel on ice that holds and slides by turns.",
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
                    name: "hold",
                    unit: "N",
                    default: 4f64,
                    default_text: "4.0",
                    documentation: "largest side force",
                    effect: ::core::option::Option::Some("ice"),
                    symbol: ::ezy_core::model::Formula {
                        text: "hold",
                        latex: "\\mathrm{hold}",
                        mathml: "<mi>hold</mi>",
                    },
                },
            ],
            inputs: &[],
            outputs: &[],
            events: &[],
            grip: ::core::option::Option::None,
            stop: ::core::option::Option::None,
            effects: &[
                ::ezy_core::model::EffectInfo {
                    name: "pump",
                    documentation: "The rider swings the bar: a torque between seat and bar.",
                },
                ::ezy_core::model::EffectInfo {
                    name: "ice",
                    documentation: "The rear wheel on ice: it holds sideways up to a force and slides beyond it, with that force as friction.",
                },
            ],
            until_s: 20f64,
            n_constants: 35usize,
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
                    text: "hold*sin(seat.phi)",
                    latex: "\\mathrm{hold} \\, \\sin{\\varphi_{\\mathrm{seat}}}",
                    mathml: "<mrow><mi>hold</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "-hold*cos(seat.phi)",
                    latex: "-\\mathrm{hold} \\, \\cos{\\varphi_{\\mathrm{seat}}}",
                    mathml: "<mrow><mo>−</mo><mi>hold</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "hold*a + m0*cos(omega*t)",
                    latex: "\\mathrm{hold} \\, a + m_{0} \\, \\cos\\left(\\omega \\, t\\right)",
                    mathml: "<mrow><mi>hold</mi><mspace width=\"0.17em\"/><mi>a</mi><mo>+</mo><msub><mi>m</mi><mtext>0</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mrow><mo>(</mo><mi>ω</mi><mspace width=\"0.17em\"/><mi>t</mi><mo>)</mo></mrow></mrow></mrow>",
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
                    rows: &[0usize, 1usize],
                    constant_pivot: false,
                },
            ],
            acceleration_operations: ::ezy_core::model::Operations {
                add: 30usize,
                mul: 56usize,
                div: 1usize,
                trig: 3usize,
                calls: 0usize,
            },
            correction_operations: ::ezy_core::model::Operations {
                add: 18usize,
                mul: 34usize,
                div: 1usize,
                trig: 2usize,
                calls: 0usize,
            },
            series: ::ezy_core::model::SeriesInfo::Analytic {
                n_products: 12usize,
                operations: ::ezy_core::model::Operations {
                    add: 46usize,
                    mul: 79usize,
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
    for self::SlidesLeft {
        fn constants(&self, parameters: &[T], c: &mut [T]) {
            let parameters = ::ezy_core::kernel::array::<11usize, T>(parameters);
            let c = ::ezy_core::kernel::array_mut::<35usize, T>(c);
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
            let parameter_hold = parameters[10usize];
            let parameter_a = parameters[0usize];
            let k14 = parameter_hold * parameter_a;
            let k15 = T::PI;
            let k16 = k1 / parameter_m1;
            let k17 = parameter_hold * k16;
            let k18 = k1 / parameter_i1;
            let k19 = parameter_b * k18;
            let k20 = k1 / parameter_m2;
            let k21 = k1 / parameter_i2;
            let k22 = parameter_d * parameter_m0;
            let k23 = k22 * k21;
            let k24 = parameter_c * parameter_m0;
            let k25 = k24 * k21;
            let k26 = parameter_b * parameter_b;
            let k27 = k26 * k18;
            let k28 = parameter_d * parameter_d;
            let k29 = k28 * k21;
            let k30 = k16 + k27;
            let k31 = k30 + k20;
            let k32 = k31 + k29;
            let k33 = parameter_d * parameter_c;
            let k34 = k33 * k21;
            let k35 = k20 - k34;
            let k36 = k16 + k20;
            let k37 = parameter_c * parameter_c;
            let k38 = k37 * k21;
            let k39 = k20 + k38;
            let k40 = k1 / k39;
            let k41 = k35 * k40;
            let k42 = k41 * k35;
            let k43 = k32 - k42;
            let k44 = k42 - k29;
            let k45 = parameter_m0 * k21;
            let k46 = parameter_d * k21;
            let k47 = parameter_c * k21;
            let k48 = T::from_f64(0.0000000001f64);
            let k49 = k48 * k39;
            let k50 = k32 + k36;
            let k51 = k50 * k50;
            let k52 = k48 * k51;
            let k53 = T::from_f64(2f64);
            let k54 = parameter_b * k53;
            let k55 = parameter_d * k53;
            c[0usize] = parameter_m0;
            c[1usize] = parameter_omega;
            c[2usize] = k14;
            c[3usize] = k25;
            c[4usize] = k27;
            c[5usize] = k44;
            c[6usize] = k43;
            c[7usize] = k36;
            c[8usize] = k17;
            c[9usize] = k19;
            c[10usize] = k23;
            c[11usize] = k41;
            c[12usize] = parameter_b;
            c[13usize] = parameter_d;
            c[14usize] = k40;
            c[15usize] = k16;
            c[16usize] = k18;
            c[17usize] = k20;
            c[18usize] = k46;
            c[19usize] = k45;
            c[20usize] = k47;
            c[21usize] = k39;
            c[22usize] = k49;
            c[23usize] = k52;
            c[24usize] = parameter_hold;
            c[25usize] = k21;
            c[26usize] = parameter_m1;
            c[27usize] = parameter_i1;
            c[28usize] = parameter_m2;
            c[29usize] = parameter_i2;
            c[30usize] = parameter_c;
            c[31usize] = parameter_a;
            c[32usize] = k15;
            c[33usize] = k54;
            c[34usize] = k55;
        }
        fn mass_matrix(&self, c: &[T], m: &mut [T]) {
            let c = ::ezy_core::kernel::array::<35usize, T>(c);
            let out = ::ezy_core::kernel::array_mut::<6usize, T>(m);
            out[0usize] = c[26usize];
            out[1usize] = c[26usize];
            out[2usize] = c[27usize];
            out[3usize] = c[28usize];
            out[4usize] = c[28usize];
            out[5usize] = c[29usize];
        }
        fn position_constraint(&self, c: &[T], t: T, q: &[T], out: &mut [T]) {
            let c = ::ezy_core::kernel::array::<35usize, T>(c);
            let q = ::ezy_core::kernel::array::<6usize, T>(q);
            let out = ::ezy_core::kernel::array_mut::<2usize, T>(out);
            let seat_x = q[0usize];
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let sum_7 = T::fused(c[12usize], cos_seat_phi, seat_x);
            let bar_x = q[3usize];
            let difference_9 = sum_7 - bar_x;
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
            let sum_14 = T::fused(c[13usize], cos_bar_phi, difference_9);
            let seat_y = q[1usize];
            let sum_18 = T::fused(c[12usize], sin_seat_phi, seat_y);
            let bar_y = q[4usize];
            let difference_20 = sum_18 - bar_y;
            let sum_23 = T::fused(c[13usize], sin_bar_phi, difference_20);
            out[0usize] = sum_14;
            out[1usize] = sum_23;
        }
        fn velocity_constraint(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
            let c = ::ezy_core::kernel::array::<35usize, T>(c);
            let q = ::ezy_core::kernel::array::<6usize, T>(q);
            let v = ::ezy_core::kernel::array::<6usize, T>(v);
            let out = ::ezy_core::kernel::array_mut::<3usize, T>(out);
            let seat_vx = v[0usize];
            let bar_vx = v[3usize];
            let difference_4 = seat_vx - bar_vx;
            let bar_omega = v[5usize];
            let c13_bar_omega = c[13usize] * bar_omega;
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
            let difference_11 = T::fused(-c13_bar_omega, sin_bar_phi, difference_4);
            let seat_omega = v[2usize];
            let c12_seat_omega = c[12usize] * seat_omega;
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let difference_18 = T::fused(-c12_seat_omega, sin_seat_phi, difference_11);
            let seat_vy = v[1usize];
            let bar_vy = v[4usize];
            let difference_21 = seat_vy - bar_vy;
            let sum_24 = T::fused(c13_bar_omega, cos_bar_phi, difference_21);
            let sum_27 = T::fused(c12_seat_omega, cos_seat_phi, sum_24);
            let bar_omega_c30 = bar_omega * c[30usize];
            let difference_31 = T::fused(-bar_vx, sin_bar_phi, bar_omega_c30);
            let sum_33 = T::fused(bar_vy, cos_bar_phi, difference_31);
            out[0usize] = difference_18;
            out[1usize] = sum_27;
            out[2usize] = sum_33;
        }
        fn velocity_jacobian(&self, c: &[T], t: T, q: &[T], out: &mut [T]) {
            let c = ::ezy_core::kernel::array::<35usize, T>(c);
            let q = ::ezy_core::kernel::array::<6usize, T>(q);
            let out = ::ezy_core::kernel::array_mut::<11usize, T>(out);
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let c12_sin_seat_phi = c[12usize] * sin_seat_phi;
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
            let c13_sin_bar_phi = c[13usize] * sin_bar_phi;
            let c12_cos_seat_phi = c[12usize] * cos_seat_phi;
            let c13_cos_bar_phi = c[13usize] * cos_bar_phi;
            let value_14 = -c12_sin_seat_phi;
            let value_15 = -T::from_f64(1f64);
            let value_16 = -c13_sin_bar_phi;
            let value_17 = -sin_bar_phi;
            out[0usize] = T::from_f64(1f64);
            out[1usize] = value_14;
            out[2usize] = value_15;
            out[3usize] = value_16;
            out[4usize] = T::from_f64(1f64);
            out[5usize] = c12_cos_seat_phi;
            out[6usize] = value_15;
            out[7usize] = c13_cos_bar_phi;
            out[8usize] = value_17;
            out[9usize] = cos_bar_phi;
            out[10usize] = c[30usize];
        }
        fn convective_term(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
            let c = ::ezy_core::kernel::array::<35usize, T>(c);
            let q = ::ezy_core::kernel::array::<6usize, T>(q);
            let v = ::ezy_core::kernel::array::<6usize, T>(v);
            let out = ::ezy_core::kernel::array_mut::<3usize, T>(out);
            let seat_omega = v[2usize];
            let c12_seat_omega = c[12usize] * seat_omega;
            let product_4 = seat_omega * c12_seat_omega;
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let product_4_cos_seat_phi = product_4 * cos_seat_phi;
            let bar_omega = v[5usize];
            let c13_bar_omega = c[13usize] * bar_omega;
            let bar_omega_c13_bar_omega = bar_omega * c13_bar_omega;
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
            let sum_16 = T::fused(
                bar_omega_c13_bar_omega,
                cos_bar_phi,
                product_4_cos_seat_phi,
            );
            let product_4_sin_seat_phi = product_4 * sin_seat_phi;
            let sum_21 = T::fused(
                bar_omega_c13_bar_omega,
                sin_bar_phi,
                product_4_sin_seat_phi,
            );
            let bar_vx = v[3usize];
            let cos_bar_phi_bar_vx = cos_bar_phi * bar_vx;
            let bar_vy = v[4usize];
            let sum_26 = T::fused(sin_bar_phi, bar_vy, cos_bar_phi_bar_vx);
            let bar_omega_sum_26 = bar_omega * sum_26;
            let value_28 = -sum_16;
            let value_29 = -sum_21;
            let value_30 = -bar_omega_sum_26;
            out[0usize] = value_28;
            out[1usize] = value_29;
            out[2usize] = value_30;
        }
        fn applied_force(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
            let c = ::ezy_core::kernel::array::<35usize, T>(c);
            let q = ::ezy_core::kernel::array::<6usize, T>(q);
            let v = ::ezy_core::kernel::array::<6usize, T>(v);
            let out = ::ezy_core::kernel::array_mut::<6usize, T>(out);
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let c24_sin_seat_phi = c[24usize] * sin_seat_phi;
            let c24_cos_seat_phi = c[24usize] * cos_seat_phi;
            let c1_t = c[1usize] * t;
            let cos_11 = T::cos(c1_t);
            let c0_cos_11 = c[0usize] * cos_11;
            let sum_15 = c0_cos_11 + c[2usize];
            let value_16 = -c24_cos_seat_phi;
            let value_17 = -c0_cos_11;
            out[0usize] = c24_sin_seat_phi;
            out[1usize] = value_16;
            out[2usize] = sum_15;
            out[3usize] = T::from_f64(0f64);
            out[4usize] = T::from_f64(0f64);
            out[5usize] = value_17;
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
        ) -> ::ezy_core::model::Pivots {
            let c = ::ezy_core::kernel::array::<35usize, T>(c);
            let q = ::ezy_core::kernel::array::<6usize, T>(q);
            let v = ::ezy_core::kernel::array::<6usize, T>(v);
            let a = ::ezy_core::kernel::array_mut::<6usize, T>(a);
            let lambda = ::ezy_core::kernel::array_mut::<3usize, T>(lambda);
            let c1_t = c[1usize] * t;
            let cos_4 = T::cos(c1_t);
            let force_seat_phi = T::fused(c[0usize], cos_4, c[2usize]);
            let bar_vx = v[3usize];
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
            let bar_vx_cos_bar_phi = bar_vx * cos_bar_phi;
            let bar_vy = v[4usize];
            let sum_17 = T::fused(bar_vy, sin_bar_phi, bar_vx_cos_bar_phi);
            let bar_omega = v[5usize];
            let sum_17_bar_omega = sum_17 * bar_omega;
            let minus_right_side_front = T::fused(cos_4, c[3usize], sum_17_bar_omega);
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let c4_cos_seat_phi = c[4usize] * cos_seat_phi;
            let cos_bar_phi_c5 = cos_bar_phi * c[5usize];
            let product_30 = cos_bar_phi * cos_bar_phi_c5;
            let difference_31 = T::fused(-cos_seat_phi, c4_cos_seat_phi, product_30);
            let sum_33 = difference_31 + c[6usize];
            let c4_sin_seat_phi = c[4usize] * sin_seat_phi;
            let sin_bar_phi_c5 = sin_bar_phi * c[5usize];
            let product_38 = cos_bar_phi * sin_bar_phi_c5;
            let difference_39 = T::fused(-cos_seat_phi, c4_sin_seat_phi, product_38);
            let difference_41 = c[7usize] - difference_31;
            let difference_45 = T::fused(-force_seat_phi, c[9usize], c[8usize]);
            let product_46 = sin_seat_phi * difference_45;
            let cos_4_c10 = cos_4 * c[10usize];
            let sum_51 = T::fused(minus_right_side_front, c[11usize], cos_4_c10);
            let sum_53 = T::fused(sin_bar_phi, sum_51, product_46);
            let seat_omega = v[2usize];
            let c12_seat_omega = c[12usize] * seat_omega;
            let product_57 = seat_omega * c12_seat_omega;
            let difference_59 = T::fused(-cos_seat_phi, product_57, sum_53);
            let bar_omega_c13 = bar_omega * c[13usize];
            let bar_omega_bar_omega_c13 = bar_omega * bar_omega_c13;
            let difference_64 = T::fused(
                -cos_bar_phi,
                bar_omega_bar_omega_c13,
                difference_59,
            );
            let product_65 = cos_seat_phi * difference_45;
            let sum_67 = T::fused(cos_bar_phi, sum_51, product_65);
            let sum_69 = T::fused(sin_seat_phi, product_57, sum_67);
            let sum_71 = T::fused(sin_bar_phi, bar_omega_bar_omega_c13, sum_69);
            let sum_33_difference_41 = sum_33 * difference_41;
            let difference_74 = T::fused(
                -difference_39,
                difference_39,
                sum_33_difference_41,
            );
            let quotient_75 = T::from_f64(1f64) / difference_74;
            let product_76 = difference_41 * difference_64;
            let sum_78 = T::fused(difference_39, sum_71, product_76);
            let lambda_B_x = quotient_75 * sum_78;
            let product_80 = difference_39 * difference_64;
            let sum_82 = T::fused(sum_33, sum_71, product_80);
            let minus_lambda_B_y = quotient_75 * sum_82;
            let sin_bar_phi_lambda_B_x = sin_bar_phi * lambda_B_x;
            let sum_86 = T::fused(cos_bar_phi, minus_lambda_B_y, sin_bar_phi_lambda_B_x);
            let c11_sum_86 = c[11usize] * sum_86;
            let minus_lambda_front = T::fused(
                minus_right_side_front,
                c[14usize],
                c11_sum_86,
            );
            let sin_seat_phi_c8 = sin_seat_phi * c[8usize];
            let difference_94 = T::fused(-lambda_B_x, c[15usize], sin_seat_phi_c8);
            let minus_lambda_B_y_c15 = minus_lambda_B_y * c[15usize];
            let difference_97 = T::fused(-cos_seat_phi, c[8usize], minus_lambda_B_y_c15);
            let sin_seat_phi_lambda_B_x = sin_seat_phi * lambda_B_x;
            let sum_100 = T::fused(
                cos_seat_phi,
                minus_lambda_B_y,
                sin_seat_phi_lambda_B_x,
            );
            let c9_sum_100 = c[9usize] * sum_100;
            let sum_104 = T::fused(force_seat_phi, c[16usize], c9_sum_100);
            let difference_106 = T::fused(-sin_bar_phi, minus_lambda_front, lambda_B_x);
            let difference_106_c17 = difference_106 * c[17usize];
            let difference_110 = T::fused(
                cos_bar_phi,
                minus_lambda_front,
                -minus_lambda_B_y,
            );
            let c17_difference_110 = c[17usize] * difference_110;
            let sum_86_c18 = sum_86 * c[18usize];
            let difference_116 = T::fused(-cos_4, c[19usize], sum_86_c18);
            let sum_119 = T::fused(minus_lambda_front, c[20usize], difference_116);
            let value_123 = -minus_lambda_B_y;
            let value_124 = -minus_lambda_front;
            a[0usize] = difference_94;
            a[1usize] = difference_97;
            a[2usize] = sum_104;
            a[3usize] = difference_106_c17;
            a[4usize] = c17_difference_110;
            a[5usize] = sum_119;
            lambda[0usize] = lambda_B_x;
            lambda[1usize] = value_123;
            lambda[2usize] = value_124;
            ::ezy_core::model::Pivots::new()
                .see(&[2usize], T::least_ratio(c[21usize], c[22usize]))
                .see(&[0usize, 1usize], T::least_ratio(difference_74, c[23usize]))
        }
        #[inline]
        fn correction(
            &self,
            c: &[T],
            t: T,
            q: &[T],
            residual: &[T],
            delta: &mut [T],
        ) -> ::ezy_core::model::Pivots {
            let c = ::ezy_core::kernel::array::<35usize, T>(c);
            let q = ::ezy_core::kernel::array::<6usize, T>(q);
            let residual = ::ezy_core::kernel::array::<3usize, T>(residual);
            let delta = ::ezy_core::kernel::array_mut::<6usize, T>(delta);
            let right_side_front = residual[2usize];
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let c4_cos_seat_phi = c[4usize] * cos_seat_phi;
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
            let c5_cos_bar_phi = c[5usize] * cos_bar_phi;
            let product_12 = cos_bar_phi * c5_cos_bar_phi;
            let difference_13 = T::fused(-cos_seat_phi, c4_cos_seat_phi, product_12);
            let sum_15 = difference_13 + c[6usize];
            let c4_sin_seat_phi = c[4usize] * sin_seat_phi;
            let c5_sin_bar_phi = c[5usize] * sin_bar_phi;
            let product_21 = cos_bar_phi * c5_sin_bar_phi;
            let difference_22 = T::fused(-cos_seat_phi, c4_sin_seat_phi, product_21);
            let difference_24 = c[7usize] - difference_13;
            let residual_0 = residual[0usize];
            let right_side_front_c11 = right_side_front * c[11usize];
            let difference_29 = T::fused(-sin_bar_phi, right_side_front_c11, residual_0);
            let residual_1 = residual[1usize];
            let sum_32 = T::fused(cos_bar_phi, right_side_front_c11, residual_1);
            let sum_15_difference_24 = sum_15 * difference_24;
            let difference_35 = T::fused(
                -difference_22,
                difference_22,
                sum_15_difference_24,
            );
            let quotient_36 = T::from_f64(1f64) / difference_35;
            let product_37 = difference_24 * difference_29;
            let difference_39 = T::fused(-difference_22, sum_32, product_37);
            let lambda_B_x = quotient_36 * difference_39;
            let sum_15_sum_32 = sum_15 * sum_32;
            let difference_43 = T::fused(-difference_22, difference_29, sum_15_sum_32);
            let lambda_B_y = quotient_36 * difference_43;
            let cos_bar_phi_lambda_B_y = cos_bar_phi * lambda_B_y;
            let difference_47 = T::fused(
                -sin_bar_phi,
                lambda_B_x,
                cos_bar_phi_lambda_B_y,
            );
            let c11_difference_47 = c[11usize] * difference_47;
            let lambda_front = T::fused(right_side_front, c[14usize], c11_difference_47);
            let lambda_B_x_c15 = lambda_B_x * c[15usize];
            let lambda_B_y_c15 = lambda_B_y * c[15usize];
            let sin_seat_phi_lambda_B_x = sin_seat_phi * lambda_B_x;
            let difference_57 = T::fused(
                -cos_seat_phi,
                lambda_B_y,
                sin_seat_phi_lambda_B_x,
            );
            let difference_57_c9 = difference_57 * c[9usize];
            let sum_61 = T::fused(sin_bar_phi, lambda_front, lambda_B_x);
            let sum_61_c17 = sum_61 * c[17usize];
            let difference_65 = T::fused(-cos_bar_phi, lambda_front, lambda_B_y);
            let c17_difference_65 = c[17usize] * difference_65;
            let difference_47_c18 = difference_47 * c[18usize];
            let sum_71 = T::fused(lambda_front, c[20usize], difference_47_c18);
            let value_75 = -lambda_B_x_c15;
            let value_76 = -lambda_B_y_c15;
            let value_77 = -sum_71;
            delta[0usize] = value_75;
            delta[1usize] = value_76;
            delta[2usize] = difference_57_c9;
            delta[3usize] = sum_61_c17;
            delta[4usize] = c17_difference_65;
            delta[5usize] = value_77;
            ::ezy_core::model::Pivots::new()
                .see(&[2usize], T::least_ratio(c[21usize], c[22usize]))
                .see(&[0usize, 1usize], T::least_ratio(difference_35, c[23usize]))
        }
    }
    #[automatically_derived]
    impl ::ezy_core::model::Scene for SlidesLeft {
        fn info(&self) -> &'static ::ezy_core::model::SceneInfo {
            static INFO: ::ezy_core::model::SceneInfo = SlidesLeft::INFO;
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
                10usize => self.hold,
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
                10usize => self.hold = value,
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
            let c = ::ezy_core::kernel::array::<35usize, f64>(c);
            let q = ::ezy_core::kernel::array::<6usize, f64>(q);
            let v = ::ezy_core::kernel::array::<6usize, f64>(v);
            let lambda = ::ezy_core::kernel::array::<3usize, f64>(lambda);
            let out = ::ezy_core::kernel::array_mut::<2usize, f64>(out);
            let seat_omega = v[2usize];
            let bar_omega = v[5usize];
            let difference_4 = seat_omega - bar_omega;
            let c1_t = c[1usize] * t;
            let cos_7 = f64::cos(c1_t);
            let difference_4_cos_7 = difference_4 * cos_7;
            let difference_4_cos_7_c0 = difference_4_cos_7 * c[0usize];
            let seat_vx = v[0usize];
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = f64::sin_cos(seat_phi);
            let seat_vx_sin_seat_phi = seat_vx * sin_seat_phi;
            let seat_vy = v[1usize];
            let seat_vy_cos_seat_phi = seat_vy * cos_seat_phi;
            let difference_19 = seat_vx_sin_seat_phi - seat_vy_cos_seat_phi;
            let difference_19_c24 = difference_19 * c[24usize];
            let seat_omega_c2 = seat_omega * c[2usize];
            let sum_24 = difference_19_c24 + seat_omega_c2;
            out[0usize] = difference_4_cos_7_c0;
            out[1usize] = sum_24;
        }
        fn points(&self, c: &[f64], t: f64, q: &[f64], out: &mut [f64]) {
            let c = ::ezy_core::kernel::array::<35usize, f64>(c);
            let q = ::ezy_core::kernel::array::<6usize, f64>(q);
            let out = ::ezy_core::kernel::array_mut::<6usize, f64>(out);
            let seat_x = q[0usize];
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = f64::sin_cos(seat_phi);
            let c31_cos_seat_phi = c[31usize] * cos_seat_phi;
            let difference_7 = seat_x - c31_cos_seat_phi;
            let seat_y = q[1usize];
            let c31_sin_seat_phi = c[31usize] * sin_seat_phi;
            let difference_11 = seat_y - c31_sin_seat_phi;
            let bar_x = q[3usize];
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = f64::sin_cos(bar_phi);
            let c30_cos_bar_phi = c[30usize] * cos_bar_phi;
            let sum_17 = bar_x + c30_cos_bar_phi;
            let bar_y = q[4usize];
            let c30_sin_bar_phi = c[30usize] * sin_bar_phi;
            let sum_21 = bar_y + c30_sin_bar_phi;
            let cos_seat_phi_c12 = cos_seat_phi * c[12usize];
            let sum_24 = seat_x + cos_seat_phi_c12;
            let sin_seat_phi_c12 = sin_seat_phi * c[12usize];
            let sum_26 = seat_y + sin_seat_phi_c12;
            out[0usize] = difference_7;
            out[1usize] = difference_11;
            out[2usize] = sum_17;
            out[3usize] = sum_21;
            out[4usize] = sum_24;
            out[5usize] = sum_26;
        }
        fn outputs(&self, c: &[f64], t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
            let c = ::ezy_core::kernel::array::<35usize, f64>(c);
            let q = ::ezy_core::kernel::array::<6usize, f64>(q);
            let v = ::ezy_core::kernel::array::<6usize, f64>(v);
            let out = ::ezy_core::kernel::array_mut::<0usize, f64>(out);
        }
        fn grip(&self, c: &[f64], t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
            let c = ::ezy_core::kernel::array::<35usize, f64>(c);
            let q = ::ezy_core::kernel::array::<6usize, f64>(q);
            let v = ::ezy_core::kernel::array::<6usize, f64>(v);
            let out = ::ezy_core::kernel::array_mut::<2usize, f64>(out);
            let seat_omega = v[2usize];
            let c31_seat_omega = c[31usize] * seat_omega;
            let seat_vx = v[0usize];
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = f64::sin_cos(seat_phi);
            let seat_vx_sin_seat_phi = seat_vx * sin_seat_phi;
            let sum_10 = c31_seat_omega + seat_vx_sin_seat_phi;
            let seat_vy = v[1usize];
            let seat_vy_cos_seat_phi = seat_vy * cos_seat_phi;
            let difference_14 = seat_vy_cos_seat_phi - sum_10;
            out[0usize] = c[24usize];
            out[1usize] = difference_14;
        }
        fn potential_energy(&self, c: &[f64], t: f64, q: &[f64]) -> f64 {
            0f64
        }
        fn start(&self, c: &[f64], start: &mut ::ezy_core::model::Start) {
            let c = ::ezy_core::kernel::array::<35usize, f64>(c);
            start.give_position(0usize, 0f64);
            start.give_position(1usize, 0f64);
            start.give_position(2usize, 0f64);
            start.give_position(5usize, c[32usize]);
        }
        fn slope_places(
            &self,
        ) -> ::core::option::Option<::ezy_core::model::SlopePlaces> {
            ::core::option::Option::Some(::ezy_core::model::SlopePlaces {
                by_q: ::std::vec![
                    (0usize, 2usize), (1usize, 2usize), (2usize, 2usize), (3usize,
                    5usize), (4usize, 5usize), (5usize, 5usize), (6usize, 2usize),
                    (6usize, 5usize), (7usize, 2usize), (7usize, 5usize), (8usize,
                    5usize)
                ],
                by_v: ::std::vec![
                    (6usize, 2usize), (6usize, 5usize), (7usize, 2usize), (7usize,
                    5usize), (8usize, 3usize), (8usize, 4usize), (8usize, 5usize)
                ],
            })
        }
        fn slopes(
            &self,
            c: &[f64],
            t: f64,
            q: &[f64],
            v: &[f64],
            a: &[f64],
            lambda: &[f64],
            by_q: &mut [f64],
            by_v: &mut [f64],
        ) {
            let c = ::ezy_core::kernel::array::<35usize, f64>(c);
            let q = ::ezy_core::kernel::array::<6usize, f64>(q);
            let v = ::ezy_core::kernel::array::<6usize, f64>(v);
            let a = ::ezy_core::kernel::array::<6usize, f64>(a);
            let lambda = ::ezy_core::kernel::array::<3usize, f64>(lambda);
            let by_q = ::ezy_core::kernel::array_mut::<11usize, f64>(by_q);
            let by_v = ::ezy_core::kernel::array_mut::<7usize, f64>(by_v);
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = f64::sin_cos(seat_phi);
            let c24_cos_seat_phi = c[24usize] * cos_seat_phi;
            let c24_sin_seat_phi = c[24usize] * sin_seat_phi;
            let multiplier_0 = lambda[0usize];
            let product_9 = cos_seat_phi * multiplier_0;
            let multiplier_1 = lambda[1usize];
            let product_11 = sin_seat_phi * multiplier_1;
            let sum_12 = product_9 + product_11;
            let sum_12_c12 = sum_12 * c[12usize];
            let multiplier_2 = lambda[2usize];
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = f64::sin_cos(bar_phi);
            let multiplier_2_cos_bar_phi = multiplier_2 * cos_bar_phi;
            let multiplier_2_sin_bar_phi = multiplier_2 * sin_bar_phi;
            let multiplier_0_cos_bar_phi = multiplier_0 * cos_bar_phi;
            let multiplier_1_sin_bar_phi = multiplier_1 * sin_bar_phi;
            let sum_23 = multiplier_0_cos_bar_phi + multiplier_1_sin_bar_phi;
            let sum_23_c13 = sum_23 * c[13usize];
            let seat_omega = v[2usize];
            let seat_omega_seat_omega = seat_omega * seat_omega;
            let product_28 = sin_seat_phi * seat_omega_seat_omega;
            let acceleration_2 = a[2usize];
            let product_30 = cos_seat_phi * acceleration_2;
            let difference_31 = product_30 - product_28;
            let c12_difference_31 = c[12usize] * difference_31;
            let bar_omega = v[5usize];
            let bar_omega_bar_omega = bar_omega * bar_omega;
            let product_35 = sin_bar_phi * bar_omega_bar_omega;
            let acceleration_5 = a[5usize];
            let product_37 = cos_bar_phi * acceleration_5;
            let difference_38 = product_37 - product_35;
            let c13_difference_38 = c[13usize] * difference_38;
            let product_40 = cos_seat_phi * seat_omega_seat_omega;
            let product_41 = sin_seat_phi * acceleration_2;
            let sum_42 = product_40 + product_41;
            let c12_sum_42 = c[12usize] * sum_42;
            let product_44 = cos_bar_phi * bar_omega_bar_omega;
            let product_45 = sin_bar_phi * acceleration_5;
            let sum_46 = product_44 + product_45;
            let c13_sum_46 = c[13usize] * sum_46;
            let bar_vx = v[3usize];
            let bar_omega_bar_vx = bar_omega * bar_vx;
            let acceleration_4 = a[4usize];
            let difference_51 = acceleration_4 - bar_omega_bar_vx;
            let product_52 = sin_bar_phi * difference_51;
            let bar_vy = v[4usize];
            let bar_omega_bar_vy = bar_omega * bar_vy;
            let acceleration_3 = a[3usize];
            let sum_56 = bar_omega_bar_vy + acceleration_3;
            let cos_bar_phi_sum_56 = cos_bar_phi * sum_56;
            let sum_58 = product_52 + cos_bar_phi_sum_56;
            let seat_omega_c33 = seat_omega * c[33usize];
            let product_61 = cos_seat_phi * seat_omega_c33;
            let bar_omega_c34 = bar_omega * c[34usize];
            let product_64 = cos_bar_phi * bar_omega_c34;
            let product_65 = sin_seat_phi * seat_omega_c33;
            let product_66 = sin_bar_phi * bar_omega_c34;
            let cos_bar_phi_bar_omega = cos_bar_phi * bar_omega;
            let sin_bar_phi_bar_omega = sin_bar_phi * bar_omega;
            let cos_bar_phi_bar_vx = cos_bar_phi * bar_vx;
            let sin_bar_phi_bar_vy = sin_bar_phi * bar_vy;
            let sum_71 = cos_bar_phi_bar_vx + sin_bar_phi_bar_vy;
            by_q[0usize] = c24_cos_seat_phi;
            by_q[1usize] = c24_sin_seat_phi;
            by_q[2usize] = sum_12_c12;
            by_q[3usize] = multiplier_2_cos_bar_phi;
            by_q[4usize] = multiplier_2_sin_bar_phi;
            by_q[5usize] = sum_23_c13;
            by_q[6usize] = c12_difference_31;
            by_q[7usize] = c13_difference_38;
            by_q[8usize] = c12_sum_42;
            by_q[9usize] = c13_sum_46;
            by_q[10usize] = sum_58;
            by_v[0usize] = product_61;
            by_v[1usize] = product_64;
            by_v[2usize] = product_65;
            by_v[3usize] = product_66;
            by_v[4usize] = cos_bar_phi_bar_omega;
            by_v[5usize] = sin_bar_phi_bar_omega;
            by_v[6usize] = sum_71;
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
    impl<T: ::ezy_core::scalar::Scalar> ::ezy_core::model::Series<T> for SlidesLeft {
        fn series_size(&self) -> ::ezy_core::model::SeriesSize {
            ::ezy_core::model::SeriesSize {
                n_coordinates: 6usize,
                n_rows: 3usize,
                n_products: 16usize,
                n_base: 8usize,
                n_kept: 6usize,
            }
        }
        fn begin(
            &self,
            c: &[T],
            t: T,
            store: &mut ::ezy_core::model::SeriesStore<T>,
        ) -> ::ezy_core::model::Pivots {
            let c = ::ezy_core::kernel::array::<35usize, T>(c);
            let q = ::ezy_core::kernel::row::<6usize, T>(&store.q, 0);
            let v = ::ezy_core::kernel::row::<6usize, T>(&store.q, 1);
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
            let seat_omega = v[2usize];
            let c12_seat_omega = c[12usize] * seat_omega;
            let product_26 = seat_omega * c12_seat_omega;
            let cos_seat_phi_product_26 = cos_seat_phi * product_26;
            let bar_omega = v[5usize];
            let c13_bar_omega = c[13usize] * bar_omega;
            let bar_omega_c13_bar_omega = bar_omega * c13_bar_omega;
            let sum_32 = T::fused(
                cos_bar_phi,
                bar_omega_c13_bar_omega,
                cos_seat_phi_product_26,
            );
            let sin_seat_phi_product_26 = sin_seat_phi * product_26;
            let sum_35 = T::fused(
                sin_bar_phi,
                bar_omega_c13_bar_omega,
                sin_seat_phi_product_26,
            );
            let bar_vx = v[3usize];
            let cos_bar_phi_bar_vx = cos_bar_phi * bar_vx;
            let bar_vy = v[4usize];
            let sum_40 = T::fused(sin_bar_phi, bar_vy, cos_bar_phi_bar_vx);
            let bar_omega_sum_40 = bar_omega * sum_40;
            let sin_seat_phi_c24 = sin_seat_phi * c[24usize];
            let cos_seat_phi_c24 = cos_seat_phi * c[24usize];
            let c1_t = c[1usize] * t;
            let (sin_48, cos_48) = T::sin_cos(c1_t);
            let c0_cos_48 = c[0usize] * cos_48;
            let sum_52 = c0_cos_48 + c[2usize];
            let cos_seat_phi_c4 = cos_seat_phi * c[4usize];
            let cos_bar_phi_c5 = cos_bar_phi * c[5usize];
            let product_71 = cos_bar_phi * cos_bar_phi_c5;
            let difference_72 = T::fused(-cos_seat_phi, cos_seat_phi_c4, product_71);
            let sum_74 = difference_72 + c[6usize];
            let sin_seat_phi_c4 = sin_seat_phi * c[4usize];
            let sin_bar_phi_c5 = sin_bar_phi * c[5usize];
            let product_78 = cos_bar_phi * sin_bar_phi_c5;
            let difference_79 = T::fused(-cos_seat_phi, sin_seat_phi_c4, product_78);
            let difference_81 = c[7usize] - difference_72;
            let sum_74_difference_81 = sum_74 * difference_81;
            let difference_113 = T::fused(
                -difference_79,
                difference_79,
                sum_74_difference_81,
            );
            let quotient_114 = T::from_f64(1f64) / difference_113;
            let cos_seat_phi_seat_omega = cos_seat_phi * seat_omega;
            let sin_seat_phi_seat_omega = sin_seat_phi * seat_omega;
            let cos_bar_phi_bar_omega = cos_bar_phi * bar_omega;
            let sin_bar_phi_bar_omega = sin_bar_phi * bar_omega;
            let product_163 = c[24usize] * cos_seat_phi_seat_omega;
            let product_164 = c[24usize] * sin_seat_phi_seat_omega;
            let c1_sin_48 = c[1usize] * sin_48;
            let c0_c1_sin_48 = c[0usize] * c1_sin_48;
            let c1_cos_48 = c[1usize] * cos_48;
            let value_168 = -cos_seat_phi_c24;
            let value_169 = -c0_cos_48;
            let value_170 = -sin_seat_phi_seat_omega;
            let value_171 = -sin_bar_phi_bar_omega;
            let value_172 = -product_164;
            let value_173 = -c0_c1_sin_48;
            let value_174 = -c1_sin_48;
            let target = ::ezy_core::kernel::array_mut::<8usize, T>(&mut store.base);
            target[0usize] = cos_seat_phi;
            target[1usize] = sin_seat_phi;
            target[2usize] = cos_bar_phi;
            target[3usize] = sin_bar_phi;
            target[4usize] = quotient_114;
            target[5usize] = difference_81;
            target[6usize] = difference_79;
            target[7usize] = sum_74;
            let target = ::ezy_core::kernel::array_mut::<6usize, T>(&mut store.force);
            target[0usize] = sin_seat_phi_c24;
            target[1usize] = value_168;
            target[2usize] = sum_52;
            target[3usize] = T::from_f64(0f64);
            target[4usize] = T::from_f64(0f64);
            target[5usize] = value_169;
            let target = ::ezy_core::kernel::row_mut::<
                6usize,
                T,
            >(&mut store.kept, 0usize);
            target[0usize] = sin_seat_phi_c24;
            target[1usize] = cos_seat_phi_c24;
            target[2usize] = sum_52;
            target[3usize] = c0_cos_48;
            target[4usize] = sin_48;
            target[5usize] = cos_48;
            let target = ::ezy_core::kernel::row_mut::<
                6usize,
                T,
            >(&mut store.kept, 1usize);
            target[0usize] = product_163;
            target[1usize] = value_172;
            target[2usize] = value_173;
            target[3usize] = value_173;
            target[4usize] = c1_cos_48;
            target[5usize] = value_174;
            let target = ::ezy_core::kernel::row_mut::<
                16usize,
                T,
            >(&mut store.left, 1usize);
            target[0usize] = cos_seat_phi_seat_omega;
            target[1usize] = value_170;
            target[2usize] = cos_bar_phi_bar_omega;
            target[3usize] = value_171;
            target[4usize] = cos_bar_phi_bar_omega;
            target[5usize] = value_171;
            target[6usize] = seat_omega;
            target[7usize] = bar_omega;
            target[8usize] = seat_omega;
            target[9usize] = bar_omega;
            target[10usize] = cos_bar_phi_bar_omega;
            target[11usize] = value_171;
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
            target[6usize] = cos_seat_phi_seat_omega;
            target[7usize] = cos_bar_phi_bar_omega;
            target[8usize] = value_170;
            target[9usize] = value_171;
            target[10usize] = bar_vx;
            target[11usize] = bar_vy;
            let target = ::ezy_core::kernel::array_mut::<3usize, T>(&mut store.row);
            target[0usize] = sum_32;
            target[1usize] = sum_35;
            target[2usize] = bar_omega_sum_40;
            ::ezy_core::model::Pivots::new()
                .see(&[2usize], T::least_ratio(c[21usize], c[22usize]))
                .see(&[0usize, 1usize], T::least_ratio(difference_113, c[23usize]))
        }
        #[inline(always)]
        fn right_side(
            &self,
            c: &[T],
            k: usize,
            store: &mut ::ezy_core::model::SeriesStore<T>,
        ) {
            let c = ::ezy_core::kernel::array::<35usize, T>(c);
            let kept_0 = ::ezy_core::kernel::row::<6usize, T>(&store.kept, k + 0usize);
            let sums = ::ezy_core::kernel::array::<16usize, T>(&store.sums);
            let kept_0 = kept_0[0usize];
            let kept_1 = kept_0[1usize];
            let kept_2 = kept_0[2usize];
            let convolved_0 = sums[0usize];
            let convolved_1 = sums[1usize];
            let c12_convolved_1 = c[12usize] * convolved_1;
            let difference_9 = T::fused(-c[12usize], convolved_0, c12_convolved_1);
            let difference_10 = kept_2 - difference_9;
            let convolved_2 = sums[2usize];
            let convolved_3 = sums[3usize];
            let kept_3 = kept_0[3usize];
            let convolved_4 = sums[4usize];
            let convolved_5 = sums[5usize];
            let c13_convolved_5 = c[13usize] * convolved_5;
            let difference_20 = T::fused(-c[13usize], convolved_4, c13_convolved_5);
            let sum_21 = kept_3 + difference_20;
            let convolved_6 = sums[6usize];
            let inverse_order_ahead = T::from_f64(1f64)
                / T::from_f64((k + 2usize) as f64);
            let product_24 = convolved_6 * inverse_order_ahead;
            let c12_product_24 = c[12usize] * product_24;
            let convolved_7 = sums[7usize];
            let product_27 = inverse_order_ahead * convolved_7;
            let sum_29 = T::fused(c[13usize], product_27, c12_product_24);
            let order_next = T::from_f64((k + 1usize) as f64);
            let order_ahead = T::from_f64((k + 2usize) as f64);
            let order_next_order_ahead = order_next * order_ahead;
            let product_33 = sum_29 * order_next_order_ahead;
            let convolved_8 = sums[8usize];
            let product_35 = inverse_order_ahead * convolved_8;
            let c12_product_35 = c[12usize] * product_35;
            let convolved_9 = sums[9usize];
            let product_38 = inverse_order_ahead * convolved_9;
            let sum_40 = T::fused(c[13usize], product_38, c12_product_35);
            let product_41 = order_next_order_ahead * sum_40;
            let convolved_10 = sums[10usize];
            let convolved_11 = sums[11usize];
            let difference_44 = convolved_10 - convolved_11;
            let order_next_difference_44 = order_next * difference_44;
            let value_46 = -kept_1;
            let value_47 = -convolved_3;
            let value_48 = -sum_21;
            let value_49 = -product_41;
            let target = ::ezy_core::kernel::array_mut::<6usize, T>(&mut store.force);
            target[0usize] = kept_0;
            target[1usize] = value_46;
            target[2usize] = difference_10;
            target[3usize] = convolved_2;
            target[4usize] = value_47;
            target[5usize] = value_48;
            let target = ::ezy_core::kernel::array_mut::<3usize, T>(&mut store.row);
            target[0usize] = product_33;
            target[1usize] = value_49;
            target[2usize] = order_next_difference_44;
        }
        #[inline(always)]
        fn solve(
            &self,
            c: &[T],
            k: usize,
            store: &mut ::ezy_core::model::SeriesStore<T>,
        ) {
            let c = ::ezy_core::kernel::array::<35usize, T>(c);
            let base = ::ezy_core::kernel::array::<8usize, T>(&store.base);
            let force = ::ezy_core::kernel::array::<6usize, T>(&store.force);
            let row = ::ezy_core::kernel::array::<3usize, T>(&store.row);
            let force_0 = force[0usize];
            let base_4 = base[4usize];
            let base_5 = base[5usize];
            let c15_force_0 = c[15usize] * force_0;
            let base_3 = base[3usize];
            let force_5 = force[5usize];
            let force_5_c18 = force_5 * c[18usize];
            let base_2 = base[2usize];
            let force_4 = force[4usize];
            let base_2_force_4 = base_2 * force_4;
            let force_3 = force[3usize];
            let difference_14 = T::fused(-base_3, force_3, base_2_force_4);
            let difference_14_c17 = difference_14 * c[17usize];
            let sum_19 = T::fused(force_5, c[20usize], difference_14_c17);
            let row_2 = row[2usize];
            let right_side_front = sum_19 - row_2;
            let sum_24 = T::fused(right_side_front, c[11usize], force_5_c18);
            let difference_26 = T::fused(-base_3, sum_24, c15_force_0);
            let difference_28 = T::fused(-force_3, c[17usize], difference_26);
            let row_0 = row[0usize];
            let difference_30 = difference_28 - row_0;
            let base_1 = base[1usize];
            let force_2 = force[2usize];
            let c9_force_2 = c[9usize] * force_2;
            let difference_36 = T::fused(-base_1, c9_force_2, difference_30);
            let base_5_difference_36 = base_5 * difference_36;
            let base_6 = base[6usize];
            let base_2_sum_24 = base_2 * sum_24;
            let force_1 = force[1usize];
            let sum_42 = T::fused(c[15usize], force_1, base_2_sum_24);
            let difference_44 = T::fused(-force_4, c[17usize], sum_42);
            let row_1 = row[1usize];
            let difference_46 = difference_44 - row_1;
            let base_0 = base[0usize];
            let sum_49 = T::fused(c9_force_2, base_0, difference_46);
            let difference_51 = T::fused(-base_6, sum_49, base_5_difference_36);
            let lambda_B_x = base_4 * difference_51;
            let difference_53 = force_0 - lambda_B_x;
            let c15_difference_53 = c[15usize] * difference_53;
            let base_7 = base[7usize];
            let sum_49_base_7 = sum_49 * base_7;
            let difference_58 = T::fused(-difference_36, base_6, sum_49_base_7);
            let lambda_B_y = base_4 * difference_58;
            let difference_60 = force_1 - lambda_B_y;
            let c15_difference_60 = c[15usize] * difference_60;
            let base_1_lambda_B_x = base_1 * lambda_B_x;
            let difference_64 = T::fused(-base_0, lambda_B_y, base_1_lambda_B_x);
            let c9_difference_64 = c[9usize] * difference_64;
            let sum_68 = T::fused(force_2, c[16usize], c9_difference_64);
            let sum_69 = force_3 + lambda_B_x;
            let base_2_lambda_B_y = base_2 * lambda_B_y;
            let difference_72 = T::fused(-base_3, lambda_B_x, base_2_lambda_B_y);
            let c11_difference_72 = c[11usize] * difference_72;
            let lambda_front = T::fused(right_side_front, c[14usize], c11_difference_72);
            let sum_78 = T::fused(base_3, lambda_front, sum_69);
            let c17_sum_78 = c[17usize] * sum_78;
            let sum_80 = force_4 + lambda_B_y;
            let difference_82 = T::fused(-base_2, lambda_front, sum_80);
            let c17_difference_82 = c[17usize] * difference_82;
            let force_5_c25 = force_5 * c[25usize];
            let difference_87 = T::fused(-c[18usize], difference_72, force_5_c25);
            let difference_89 = T::fused(-c[20usize], lambda_front, difference_87);
            let target = ::ezy_core::kernel::array_mut::<6usize, T>(&mut store.a);
            target[0usize] = c15_difference_53;
            target[1usize] = c15_difference_60;
            target[2usize] = sum_68;
            target[3usize] = c17_sum_78;
            target[4usize] = c17_difference_82;
            target[5usize] = difference_89;
            let target = ::ezy_core::kernel::row_mut::<
                3usize,
                T,
            >(&mut store.lambda, k + 0usize);
            target[0usize] = lambda_B_x;
            target[1usize] = lambda_B_y;
            target[2usize] = lambda_front;
        }
        #[inline(always)]
        fn finish(
            &self,
            c: &[T],
            k: usize,
            store: &mut ::ezy_core::model::SeriesStore<T>,
        ) {
            let c = ::ezy_core::kernel::array::<35usize, T>(c);
            let a = ::ezy_core::kernel::array::<6usize, T>(&store.a);
            let base = ::ezy_core::kernel::array::<8usize, T>(&store.base);
            let kept_1 = ::ezy_core::kernel::row::<6usize, T>(&store.kept, k + 1usize);
            let lambda_0 = ::ezy_core::kernel::row::<
                3usize,
                T,
            >(&store.lambda, k + 0usize);
            let sums = ::ezy_core::kernel::array::<16usize, T>(&store.sums);
            let a_0 = a[0usize];
            let inverse_order_next = T::from_f64(1f64)
                / T::from_f64((k + 1usize) as f64);
            let inverse_order_ahead = T::from_f64(1f64)
                / T::from_f64((k + 2usize) as f64);
            let product_3 = inverse_order_next * inverse_order_ahead;
            let a_0_product_3 = a_0 * product_3;
            let a_1 = a[1usize];
            let product_3_a_1 = product_3 * a_1;
            let a_2 = a[2usize];
            let product_3_a_2 = product_3 * a_2;
            let a_3 = a[3usize];
            let product_3_a_3 = product_3 * a_3;
            let a_4 = a[4usize];
            let product_3_a_4 = product_3 * a_4;
            let a_5 = a[5usize];
            let product_3_a_5 = product_3 * a_5;
            let lambda_0 = lambda_0[0usize];
            let convolved_8 = sums[8usize];
            let product_19 = inverse_order_ahead * convolved_8;
            let base_0 = base[0usize];
            let sum_22 = T::fused(product_3_a_2, base_0, product_19);
            let lambda_1 = lambda_0[1usize];
            let convolved_6 = sums[6usize];
            let product_25 = inverse_order_ahead * convolved_6;
            let base_1 = base[1usize];
            let sum_28 = T::fused(product_3_a_2, base_1, product_25);
            let lambda_2 = lambda_0[2usize];
            let convolved_9 = sums[9usize];
            let product_31 = inverse_order_ahead * convolved_9;
            let base_2 = base[2usize];
            let sum_34 = T::fused(product_3_a_5, base_2, product_31);
            let convolved_7 = sums[7usize];
            let product_36 = inverse_order_ahead * convolved_7;
            let base_3 = base[3usize];
            let sum_39 = T::fused(product_3_a_5, base_3, product_36);
            let order_ahead = T::from_f64((k + 2usize) as f64);
            let product_41 = product_3_a_2 * order_ahead;
            let product_42 = product_3_a_5 * order_ahead;
            let product_43 = product_3_a_3 * order_ahead;
            let product_44 = product_3_a_4 * order_ahead;
            let sum_22_c24 = sum_22 * c[24usize];
            let sum_28_c24 = sum_28 * c[24usize];
            let kept_4_next = kept_1[4usize];
            let inverse_order_ahead_c1 = inverse_order_ahead * c[1usize];
            let product_52 = kept_4_next * inverse_order_ahead_c1;
            let c0_product_52 = c[0usize] * product_52;
            let kept_5_next = kept_1[5usize];
            let product_55 = inverse_order_ahead_c1 * kept_5_next;
            let value_56 = -sum_28;
            let value_57 = -sum_39;
            let value_58 = -sum_28_c24;
            let value_59 = -c0_product_52;
            let value_60 = -product_52;
            let target = ::ezy_core::kernel::row_mut::<
                6usize,
                T,
            >(&mut store.kept, k + 2usize);
            target[0usize] = sum_22_c24;
            target[1usize] = value_58;
            target[2usize] = value_59;
            target[3usize] = value_59;
            target[4usize] = product_55;
            target[5usize] = value_60;
            let target = ::ezy_core::kernel::row_mut::<
                16usize,
                T,
            >(&mut store.left, k + 2usize);
            target[0usize] = sum_22;
            target[1usize] = value_56;
            target[2usize] = sum_34;
            target[3usize] = value_57;
            target[4usize] = sum_34;
            target[5usize] = value_57;
            target[6usize] = product_41;
            target[7usize] = product_42;
            target[8usize] = product_41;
            target[9usize] = product_42;
            target[10usize] = sum_34;
            target[11usize] = value_57;
            let target = ::ezy_core::kernel::row_mut::<
                6usize,
                T,
            >(&mut store.q, k + 2usize);
            target[0usize] = a_0_product_3;
            target[1usize] = product_3_a_1;
            target[2usize] = product_3_a_2;
            target[3usize] = product_3_a_3;
            target[4usize] = product_3_a_4;
            target[5usize] = product_3_a_5;
            let target = ::ezy_core::kernel::row_mut::<
                16usize,
                T,
            >(&mut store.right, k + 2usize);
            target[0usize] = lambda_0;
            target[1usize] = lambda_1;
            target[2usize] = lambda_2;
            target[3usize] = lambda_2;
            target[4usize] = lambda_0;
            target[5usize] = lambda_1;
            target[6usize] = sum_22;
            target[7usize] = sum_34;
            target[8usize] = value_56;
            target[9usize] = value_57;
            target[10usize] = product_43;
            target[11usize] = product_44;
        }
    }
    ///Driven, with a rear wheel on ice that holds and slides by turns.
    ///
    ///Cost of the accelerations and multipliers: 56 mul, 30 add, 1 div, 3 sin–cos.
    #[cfg_attr(
        doc,
        doc = "\nFreedom: 4 of positions, 3 of velocities.\n\n# Parameters\n\n|  | parameter | default | effect | what it is |\n| --- | --- | --- | --- | --- |\n| <math><mi>a</mi></math> | `a` | 0.2 m |  | rear wheel A, behind the seat's centre of mass |\n| <math><mi>b</mi></math> | `b` | 0.6 m |  | hinge B, ahead of the seat's centre of mass |\n| <math><mi>c</mi></math> | `c` | 0.1 m |  | front wheel C, beyond the bar's centre of mass |\n| <math><mi>d</mi></math> | `d` | 0.1 m |  | bar's centre of mass, beyond the hinge |\n| <math><msub><mi>m</mi><mtext>1</mtext></msub></math> | `m1` | 46.0 kg |  | mass of seat and rider |\n| <math><msub><mi>i</mi><mtext>1</mtext></msub></math> | `i1` | 10.0 kg·m² |  | moment of inertia of seat and rider |\n| <math><msub><mi>m</mi><mtext>2</mtext></msub></math> | `m2` | 1.0 kg |  | mass of the bar |\n| <math><msub><mi>i</mi><mtext>2</mtext></msub></math> | `i2` | 0.005 kg·m² |  | moment of inertia of the bar |\n| <math><msub><mi>m</mi><mtext>0</mtext></msub></math> | `m0` | 2.0 N·m | `pump` | largest torque |\n| <math><mi>ω</mi></math> | `omega` | pi rad/s | `pump` | angular frequency of the torque |\n| <math><mi>hold</mi></math> | `hold` | 4.0 N | `ice` | largest side force |\n\n# Rows\n\n| row | word | level | unit of its multiplier |\n| --- | --- | --- | --- |\n| `B.x` | hinge | position | N |\n| `B.y` | hinge | position | N |\n| `front` | skate | velocity | N |\n\n# Coordinates and velocities\n\n<div style=\"overflow-x: auto; padding: .3em 0\"><math display=\"block\"><mi>q</mi><mo>=</mo><mtable style=\"border: solid; border-width: 0 .09em; border-radius: .7em; padding: .1em .2em\"><mtr><mtd><msub><mi>x</mi><mtext>seat</mtext></msub></mtd></mtr><mtr><mtd><msub><mi>y</mi><mtext>seat</mtext></msub></mtd></mtr><mtr><mtd><msub><mi>φ</mi><mtext>seat</mtext></msub></mtd></mtr><mtr><mtd><msub><mi>x</mi><mtext>bar</mtext></msub></mtd></mtr><mtr><mtd><msub><mi>y</mi><mtext>bar</mtext></msub></mtd></mtr><mtr><mtd><msub><mi>φ</mi><mtext>bar</mtext></msub></mtd></mtr></mtable><mo>,</mo><mspace width=\"1em\"/><mi>v</mi><mo>=</mo><mtable style=\"border: solid; border-width: 0 .09em; border-radius: .7em; padding: .1em .2em\"><mtr><mtd><msub><mover><mi>x</mi><mo>.</mo></mover><mtext>seat</mtext></msub></mtd></mtr><mtr><mtd><msub><mover><mi>y</mi><mo>.</mo></mover><mtext>seat</mtext></msub></mtd></mtr><mtr><mtd><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext></msub></mtd></mtr><mtr><mtd><msub><mover><mi>x</mi><mo>.</mo></mover><mtext>bar</mtext></msub></mtd></mtr><mtr><mtd><msub><mover><mi>y</mi><mo>.</mo></mover><mtext>bar</mtext></msub></mtd></mtr><mtr><mtd><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext></msub></mtd></mtr></mtable></math></div>\n\n# Points\n\n<div style=\"overflow-x: auto; padding: .3em 0\"><math display=\"block\"><mtable><mtr><mtd><mi>A</mi><mo>=</mo><mtable style=\"border: solid; border-width: 0 .09em; border-radius: .7em; padding: .1em .2em\"><mtr><mtd><mrow><msub><mi>x</mi><mtext>seat</mtext></msub><mo>−</mo><mi>a</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow></mtd></mtr><mtr><mtd><mrow><msub><mi>y</mi><mtext>seat</mtext></msub><mo>−</mo><mi>a</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow></mtd></mtr></mtable></mtd></mtr><mtr><mtd><mi>C</mi><mo>=</mo><mtable style=\"border: solid; border-width: 0 .09em; border-radius: .7em; padding: .1em .2em\"><mtr><mtd><mrow><msub><mi>x</mi><mtext>bar</mtext></msub><mo>+</mo><mi>c</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow></mtd></mtr><mtr><mtd><mrow><msub><mi>y</mi><mtext>bar</mtext></msub><mo>+</mo><mi>c</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow></mtd></mtr></mtable></mtd></mtr><mtr><mtd><mi>B</mi><mo>=</mo><mtable style=\"border: solid; border-width: 0 .09em; border-radius: .7em; padding: .1em .2em\"><mtr><mtd><mrow><msub><mi>x</mi><mtext>seat</mtext></msub><mo>+</mo><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow></mtd></mtr><mtr><mtd><mrow><msub><mi>y</mi><mtext>seat</mtext></msub><mo>+</mo><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow></mtd></mtr></mtable></mtd></mtr></mtable></math></div>\n\n# Position constraint\n\n<div style=\"overflow-x: auto; padding: .3em 0\"><math display=\"block\"><mn>0</mn><mo>=</mo><mi>C</mi><mo>=</mo><mtable><mtr><mtd style=\"border: solid; border-width: 0 .09em; border-radius: .7em .7em 0 0\"><mrow><msub><mi>x</mi><mtext>seat</mtext></msub><mo>+</mo><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>−</mo><msub><mi>x</mi><mtext>bar</mtext></msub><mo>+</mo><mi>d</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow></mtd><mtd><mspace width=\"1em\"/><mtext>B.x</mtext></mtd></mtr><mtr><mtd style=\"border: solid; border-width: 0 .09em; border-radius: 0 0 .7em .7em\"><mrow><msub><mi>y</mi><mtext>seat</mtext></msub><mo>+</mo><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>−</mo><msub><mi>y</mi><mtext>bar</mtext></msub><mo>+</mo><mi>d</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow></mtd><mtd><mspace width=\"1em\"/><mtext>B.y</mtext></mtd></mtr></mtable></math></div>\n\n<div style=\"overflow-x: auto; padding: .3em 0\"><math display=\"block\"><msub><mi>C</mi><mi>q</mi></msub><mo>=</mo><mtable style=\"border: solid; border-width: 0 .09em; border-radius: .7em; padding: .1em .2em\"><mtr><mtd><mrow><mn>1</mn></mrow></mtd><mtd><mn>0</mn></mtd><mtd><mrow><mo>−</mo><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow></mtd><mtd><mrow><mo>−</mo><mn>1</mn></mrow></mtd><mtd><mn>0</mn></mtd><mtd><mrow><mo>−</mo><mi>d</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow></mtd></mtr><mtr><mtd><mn>0</mn></mtd><mtd><mrow><mn>1</mn></mrow></mtd><mtd><mrow><mi>b</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow></mtd><mtd><mn>0</mn></mtd><mtd><mrow><mo>−</mo><mn>1</mn></mrow></mtd><mtd><mrow><mi>d</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow></mtd></mtr></mtable></math></div>\n\n<div style=\"overflow-x: auto; padding: .3em 0\"><math display=\"block\"><mi>h</mi><mo>=</mo><mtable style=\"border: solid; border-width: 0 .09em; border-radius: .7em; padding: .1em .2em\"><mtr><mtd><mrow><mo>−</mo><mi>b</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>−</mo><mi>d</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow></mtd></mtr><mtr><mtd><mrow><mo>−</mo><mi>b</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>seat</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow><mo>−</mo><mi>d</mi><mspace width=\"0.17em\"/><msubsup><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext><mn>2</mn></msubsup><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow></mtd></mtr></mtable></math></div>\n\n# Velocity constraint\n\n<div style=\"overflow-x: auto; padding: .3em 0\"><math display=\"block\"><mn>0</mn><mo>=</mo><mi>S</mi><mi>v</mi><mo>+</mo><msub><mi>s</mi><mi>t</mi></msub><mo>=</mo><mtable><mtr><mtd style=\"border: solid; border-width: 0 .09em; border-radius: .7em .7em .7em .7em\"><mrow><mi>c</mi><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mo>−</mo><msub><mover><mi>x</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow><mo>+</mo><msub><mover><mi>y</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow></mtd><mtd><mspace width=\"1em\"/><mtext>front</mtext></mtd></mtr></mtable></math></div>\n\n<div style=\"overflow-x: auto; padding: .3em 0\"><math display=\"block\"><mi>S</mi><mo>=</mo><mtable style=\"border: solid; border-width: 0 .09em; border-radius: .7em; padding: .1em .2em\"><mtr><mtd><mn>0</mn></mtd><mtd><mn>0</mn></mtd><mtd><mn>0</mn></mtd><mtd><mrow><mo>−</mo><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow></mtd><mtd><mrow><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow></mtd><mtd><mrow><mi>c</mi></mrow></mtd></mtr></mtable></math></div>\n\n<div style=\"overflow-x: auto; padding: .3em 0\"><math display=\"block\"><mi>s</mi><mo>=</mo><mtable style=\"border: solid; border-width: 0 .09em; border-radius: .7em; padding: .1em .2em\"><mtr><mtd><mrow><mo>−</mo><msub><mover><mi>x</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow><mo>−</mo><msub><mover><mi>y</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>bar</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>bar</mtext></msub></mrow></mrow></mtd></mtr></mtable></math></div>\n\n# Mass matrix\n\n<div style=\"overflow-x: auto; padding: .3em 0\"><math display=\"block\"><mi>M</mi><mo>=</mo><mi>diag</mi><mo>(</mo><mrow><msub><mi>m</mi><mtext>1</mtext></msub></mrow><mo>,</mo><mrow><msub><mi>m</mi><mtext>1</mtext></msub></mrow><mo>,</mo><mrow><msub><mi>i</mi><mtext>1</mtext></msub></mrow><mo>,</mo><mrow><msub><mi>m</mi><mtext>2</mtext></msub></mrow><mo>,</mo><mrow><msub><mi>m</mi><mtext>2</mtext></msub></mrow><mo>,</mo><mrow><msub><mi>i</mi><mtext>2</mtext></msub></mrow><mo>)</mo></math></div>\n\n# Applied force\n\n<div style=\"overflow-x: auto; padding: .3em 0\"><math display=\"block\"><mi>F</mi><mo>=</mo><mtable style=\"border: solid; border-width: 0 .09em; border-radius: .7em; padding: .1em .2em\"><mtr><mtd><mrow><mo>−</mo><mi>hold</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow></mtd></mtr><mtr><mtd><mrow><mi>hold</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow></mtd></mtr><mtr><mtd><mrow><mo>−</mo><mi>hold</mi><mspace width=\"0.17em\"/><mi>a</mi><mo>+</mo><msub><mi>m</mi><mtext>0</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mrow><mo>(</mo><mi>ω</mi><mspace width=\"0.17em\"/><mi>t</mi><mo>)</mo></mrow></mrow></mrow></mtd></mtr><mtr><mtd><mrow><mn>0</mn></mrow></mtd></mtr><mtr><mtd><mrow><mn>0</mn></mrow></mtd></mtr><mtr><mtd><mrow><mo>−</mo><msub><mi>m</mi><mtext>0</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mrow><mo>(</mo><mi>ω</mi><mspace width=\"0.17em\"/><mi>t</mi><mo>)</mo></mrow></mrow></mrow></mtd></mtr></mtable></math></div>\n\n# Equations of motion\n\n<div style=\"overflow-x: auto; padding: .3em 0\"><math display=\"block\"><mtable style=\"border: solid; border-width: 0 .09em; border-radius: .7em; padding: .1em .2em\"><mtr><mtd><mi>M</mi></mtd><mtd><msubsup><mi>C</mi><mi>q</mi><mi>T</mi></msubsup></mtd><mtd><msup><mi>S</mi><mi>T</mi></msup></mtd></mtr><mtr><mtd><msub><mi>C</mi><mi>q</mi></msub></mtd><mtd><mn>0</mn></mtd><mtd><mn>0</mn></mtd></mtr><mtr><mtd><mi>S</mi></mtd><mtd><mn>0</mn></mtd><mtd><mn>0</mn></mtd></mtr></mtable><mtable style=\"border: solid; border-width: 0 .09em; border-radius: .7em; padding: .1em .2em\"><mtr><mtd><mi>a</mi></mtd></mtr><mtr><mtd><msub><mi>λ</mi><mi>C</mi></msub></mtd></mtr><mtr><mtd><msub><mi>λ</mi><mi>S</mi></msub></mtd></mtr></mtable><mo>=</mo><mtable style=\"border: solid; border-width: 0 .09em; border-radius: .7em; padding: .1em .2em\"><mtr><mtd><mi>F</mi></mtd></mtr><mtr><mtd><mrow><mo>−</mo><mi>h</mi></mrow></mtd></mtr><mtr><mtd><mrow><mo>−</mo><mi>s</mi></mrow></mtd></mtr></mtable></math></div>\n\n# Sparsity of the Jacobian\n\nColumns: x, y and φ of each body.\n\n```text\n       seat  bar\nB.x    x.x   x.x\nB.y    .xx   .xx\nfront  ...   xxx\n```\n\n# Order of elimination\n\n1. `front`: pivot of parameters alone, computed once\n2. `B.x`, `B.y`: pivot of the state\n\n# Operations\n\n|  | multiplications | additions | divisions | sines and cosines | other functions |\n| --- | --- | --- | --- | --- | --- |\n| accelerations and multipliers | 56 | 30 | 1 | 3 | 0 |\n| projection | 34 | 18 | 1 | 2 | 0 |"
    )]
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct SlidesRight {
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
        ///largest side force (N); default `4.0`.
        pub hold: f64,
    }
    impl ::core::default::Default for SlidesRight {
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
                hold: 4f64,
            }
        }
    }
    impl SlidesRight {
        /// What is known of the scene when it is compiled.
        pub const INFO: ::ezy_core::model::SceneInfo = ::ezy_core::model::SceneInfo {
            model: "EzyRoller",
            name: "skid",
            documentation: "Driven, with a rear wheel on ice that holds and slides by turns.",
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
                    name: "hold",
                    unit: "N",
                    default: 4f64,
                    default_text: "4.0",
                    documentation: "largest side force",
                    effect: ::core::option::Option::Some("ice"),
                    symbol: ::ezy_core::model::Formula {
                        text: "hold",
                        latex: "\\mathrm{hold}",
                        mathml: "<mi>hold</mi>",
                    },
                },
            ],
            inputs: &[],
            outputs: &[],
            events: &[],
            grip: ::core::option::Option::None,
            stop: ::core::option::Option::None,
            effects: &[
                ::ezy_core::model::EffectInfo {
                    name: "pump",
                    documentation: "The rider swings the bar: a torque between seat and bar.",
                },
                ::ezy_core::model::EffectInfo {
                    name: "ice",
                    documentation: "The rear wheel on ice: it holds sideways up to a force and slides beyond it, with that force as friction.",
                },
            ],
            until_s: 20f64,
            n_constants: 35usize,
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
                    text: "-hold*sin(seat.phi)",
                    latex: "-\\mathrm{hold} \\, \\sin{\\varphi_{\\mathrm{seat}}}",
                    mathml: "<mrow><mo>−</mo><mi>hold</mi><mspace width=\"0.17em\"/><mrow><mi>sin</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "hold*cos(seat.phi)",
                    latex: "\\mathrm{hold} \\, \\cos{\\varphi_{\\mathrm{seat}}}",
                    mathml: "<mrow><mi>hold</mi><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><msub><mi>φ</mi><mtext>seat</mtext></msub></mrow></mrow>",
                },
                ::ezy_core::model::Formula {
                    text: "-hold*a + m0*cos(omega*t)",
                    latex: "-\\mathrm{hold} \\, a + m_{0} \\, \\cos\\left(\\omega \\, t\\right)",
                    mathml: "<mrow><mo>−</mo><mi>hold</mi><mspace width=\"0.17em\"/><mi>a</mi><mo>+</mo><msub><mi>m</mi><mtext>0</mtext></msub><mspace width=\"0.17em\"/><mrow><mi>cos</mi><mo>&#x2061;</mo><mrow><mo>(</mo><mi>ω</mi><mspace width=\"0.17em\"/><mi>t</mi><mo>)</mo></mrow></mrow></mrow>",
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
                    rows: &[0usize, 1usize],
                    constant_pivot: false,
                },
            ],
            acceleration_operations: ::ezy_core::model::Operations {
                add: 30usize,
                mul: 56usize,
                div: 1usize,
                trig: 3usize,
                calls: 0usize,
            },
            correction_operations: ::ezy_core::model::Operations {
                add: 18usize,
                mul: 34usize,
                div: 1usize,
                trig: 2usize,
                calls: 0usize,
            },
            series: ::ezy_core::model::SeriesInfo::Analytic {
                n_products: 12usize,
                operations: ::ezy_core::model::Operations {
                    add: 46usize,
                    mul: 79usize,
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
    for self::SlidesRight {
        fn constants(&self, parameters: &[T], c: &mut [T]) {
            let parameters = ::ezy_core::kernel::array::<11usize, T>(parameters);
            let c = ::ezy_core::kernel::array_mut::<35usize, T>(c);
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
            let parameter_hold = parameters[10usize];
            let parameter_a = parameters[0usize];
            let k14 = parameter_hold * parameter_a;
            let k15 = T::PI;
            let k16 = k1 / parameter_m1;
            let k17 = parameter_hold * k16;
            let k18 = k1 / parameter_i1;
            let k19 = parameter_b * k18;
            let k20 = k1 / parameter_m2;
            let k21 = k1 / parameter_i2;
            let k22 = parameter_d * parameter_m0;
            let k23 = k22 * k21;
            let k24 = parameter_c * parameter_m0;
            let k25 = k24 * k21;
            let k26 = parameter_b * parameter_b;
            let k27 = k26 * k18;
            let k28 = parameter_d * parameter_d;
            let k29 = k28 * k21;
            let k30 = k16 + k27;
            let k31 = k30 + k20;
            let k32 = k31 + k29;
            let k33 = parameter_d * parameter_c;
            let k34 = k33 * k21;
            let k35 = k20 - k34;
            let k36 = k16 + k20;
            let k37 = parameter_c * parameter_c;
            let k38 = k37 * k21;
            let k39 = k20 + k38;
            let k40 = k1 / k39;
            let k41 = k35 * k40;
            let k42 = k41 * k35;
            let k43 = k32 - k42;
            let k44 = k42 - k29;
            let k45 = parameter_m0 * k21;
            let k46 = parameter_d * k21;
            let k47 = parameter_c * k21;
            let k48 = T::from_f64(0.0000000001f64);
            let k49 = k48 * k39;
            let k50 = k32 + k36;
            let k51 = k50 * k50;
            let k52 = k48 * k51;
            let k53 = T::from_f64(2f64);
            let k54 = parameter_b * k53;
            let k55 = parameter_d * k53;
            c[0usize] = parameter_m0;
            c[1usize] = parameter_omega;
            c[2usize] = k14;
            c[3usize] = k25;
            c[4usize] = k27;
            c[5usize] = k44;
            c[6usize] = k43;
            c[7usize] = k36;
            c[8usize] = k17;
            c[9usize] = k19;
            c[10usize] = k23;
            c[11usize] = k41;
            c[12usize] = parameter_b;
            c[13usize] = parameter_d;
            c[14usize] = k40;
            c[15usize] = k16;
            c[16usize] = k18;
            c[17usize] = k20;
            c[18usize] = k46;
            c[19usize] = k45;
            c[20usize] = k47;
            c[21usize] = k39;
            c[22usize] = k49;
            c[23usize] = k52;
            c[24usize] = parameter_hold;
            c[25usize] = k21;
            c[26usize] = parameter_m1;
            c[27usize] = parameter_i1;
            c[28usize] = parameter_m2;
            c[29usize] = parameter_i2;
            c[30usize] = parameter_c;
            c[31usize] = parameter_a;
            c[32usize] = k15;
            c[33usize] = k54;
            c[34usize] = k55;
        }
        fn mass_matrix(&self, c: &[T], m: &mut [T]) {
            let c = ::ezy_core::kernel::array::<35usize, T>(c);
            let out = ::ezy_core::kernel::array_mut::<6usize, T>(m);
            out[0usize] = c[26usize];
            out[1usize] = c[26usize];
            out[2usize] = c[27usize];
            out[3usize] = c[28usize];
            out[4usize] = c[28usize];
            out[5usize] = c[29usize];
        }
        fn position_constraint(&self, c: &[T], t: T, q: &[T], out: &mut [T]) {
            let c = ::ezy_core::kernel::array::<35usize, T>(c);
            let q = ::ezy_core::kernel::array::<6usize, T>(q);
            let out = ::ezy_core::kernel::array_mut::<2usize, T>(out);
            let seat_x = q[0usize];
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let sum_7 = T::fused(c[12usize], cos_seat_phi, seat_x);
            let bar_x = q[3usize];
            let difference_9 = sum_7 - bar_x;
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
            let sum_14 = T::fused(c[13usize], cos_bar_phi, difference_9);
            let seat_y = q[1usize];
            let sum_18 = T::fused(c[12usize], sin_seat_phi, seat_y);
            let bar_y = q[4usize];
            let difference_20 = sum_18 - bar_y;
            let sum_23 = T::fused(c[13usize], sin_bar_phi, difference_20);
            out[0usize] = sum_14;
            out[1usize] = sum_23;
        }
        fn velocity_constraint(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
            let c = ::ezy_core::kernel::array::<35usize, T>(c);
            let q = ::ezy_core::kernel::array::<6usize, T>(q);
            let v = ::ezy_core::kernel::array::<6usize, T>(v);
            let out = ::ezy_core::kernel::array_mut::<3usize, T>(out);
            let seat_vx = v[0usize];
            let bar_vx = v[3usize];
            let difference_4 = seat_vx - bar_vx;
            let bar_omega = v[5usize];
            let c13_bar_omega = c[13usize] * bar_omega;
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
            let difference_11 = T::fused(-c13_bar_omega, sin_bar_phi, difference_4);
            let seat_omega = v[2usize];
            let c12_seat_omega = c[12usize] * seat_omega;
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let difference_18 = T::fused(-c12_seat_omega, sin_seat_phi, difference_11);
            let seat_vy = v[1usize];
            let bar_vy = v[4usize];
            let difference_21 = seat_vy - bar_vy;
            let sum_24 = T::fused(c13_bar_omega, cos_bar_phi, difference_21);
            let sum_27 = T::fused(c12_seat_omega, cos_seat_phi, sum_24);
            let bar_omega_c30 = bar_omega * c[30usize];
            let difference_31 = T::fused(-bar_vx, sin_bar_phi, bar_omega_c30);
            let sum_33 = T::fused(bar_vy, cos_bar_phi, difference_31);
            out[0usize] = difference_18;
            out[1usize] = sum_27;
            out[2usize] = sum_33;
        }
        fn velocity_jacobian(&self, c: &[T], t: T, q: &[T], out: &mut [T]) {
            let c = ::ezy_core::kernel::array::<35usize, T>(c);
            let q = ::ezy_core::kernel::array::<6usize, T>(q);
            let out = ::ezy_core::kernel::array_mut::<11usize, T>(out);
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let c12_sin_seat_phi = c[12usize] * sin_seat_phi;
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
            let c13_sin_bar_phi = c[13usize] * sin_bar_phi;
            let c12_cos_seat_phi = c[12usize] * cos_seat_phi;
            let c13_cos_bar_phi = c[13usize] * cos_bar_phi;
            let value_14 = -c12_sin_seat_phi;
            let value_15 = -T::from_f64(1f64);
            let value_16 = -c13_sin_bar_phi;
            let value_17 = -sin_bar_phi;
            out[0usize] = T::from_f64(1f64);
            out[1usize] = value_14;
            out[2usize] = value_15;
            out[3usize] = value_16;
            out[4usize] = T::from_f64(1f64);
            out[5usize] = c12_cos_seat_phi;
            out[6usize] = value_15;
            out[7usize] = c13_cos_bar_phi;
            out[8usize] = value_17;
            out[9usize] = cos_bar_phi;
            out[10usize] = c[30usize];
        }
        fn convective_term(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
            let c = ::ezy_core::kernel::array::<35usize, T>(c);
            let q = ::ezy_core::kernel::array::<6usize, T>(q);
            let v = ::ezy_core::kernel::array::<6usize, T>(v);
            let out = ::ezy_core::kernel::array_mut::<3usize, T>(out);
            let seat_omega = v[2usize];
            let c12_seat_omega = c[12usize] * seat_omega;
            let product_4 = seat_omega * c12_seat_omega;
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let product_4_cos_seat_phi = product_4 * cos_seat_phi;
            let bar_omega = v[5usize];
            let c13_bar_omega = c[13usize] * bar_omega;
            let bar_omega_c13_bar_omega = bar_omega * c13_bar_omega;
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
            let sum_16 = T::fused(
                bar_omega_c13_bar_omega,
                cos_bar_phi,
                product_4_cos_seat_phi,
            );
            let product_4_sin_seat_phi = product_4 * sin_seat_phi;
            let sum_21 = T::fused(
                bar_omega_c13_bar_omega,
                sin_bar_phi,
                product_4_sin_seat_phi,
            );
            let bar_vx = v[3usize];
            let cos_bar_phi_bar_vx = cos_bar_phi * bar_vx;
            let bar_vy = v[4usize];
            let sum_26 = T::fused(sin_bar_phi, bar_vy, cos_bar_phi_bar_vx);
            let bar_omega_sum_26 = bar_omega * sum_26;
            let value_28 = -sum_16;
            let value_29 = -sum_21;
            let value_30 = -bar_omega_sum_26;
            out[0usize] = value_28;
            out[1usize] = value_29;
            out[2usize] = value_30;
        }
        fn applied_force(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
            let c = ::ezy_core::kernel::array::<35usize, T>(c);
            let q = ::ezy_core::kernel::array::<6usize, T>(q);
            let v = ::ezy_core::kernel::array::<6usize, T>(v);
            let out = ::ezy_core::kernel::array_mut::<6usize, T>(out);
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let c24_sin_seat_phi = c[24usize] * sin_seat_phi;
            let c24_cos_seat_phi = c[24usize] * cos_seat_phi;
            let c1_t = c[1usize] * t;
            let cos_11 = T::cos(c1_t);
            let c0_cos_11 = c[0usize] * cos_11;
            let difference_15 = c0_cos_11 - c[2usize];
            let value_16 = -c24_sin_seat_phi;
            let value_17 = -c0_cos_11;
            out[0usize] = value_16;
            out[1usize] = c24_cos_seat_phi;
            out[2usize] = difference_15;
            out[3usize] = T::from_f64(0f64);
            out[4usize] = T::from_f64(0f64);
            out[5usize] = value_17;
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
        ) -> ::ezy_core::model::Pivots {
            let c = ::ezy_core::kernel::array::<35usize, T>(c);
            let q = ::ezy_core::kernel::array::<6usize, T>(q);
            let v = ::ezy_core::kernel::array::<6usize, T>(v);
            let a = ::ezy_core::kernel::array_mut::<6usize, T>(a);
            let lambda = ::ezy_core::kernel::array_mut::<3usize, T>(lambda);
            let c1_t = c[1usize] * t;
            let cos_4 = T::cos(c1_t);
            let force_seat_phi = T::fused(c[0usize], cos_4, -c[2usize]);
            let bar_vx = v[3usize];
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
            let bar_vx_cos_bar_phi = bar_vx * cos_bar_phi;
            let bar_vy = v[4usize];
            let sum_17 = T::fused(bar_vy, sin_bar_phi, bar_vx_cos_bar_phi);
            let bar_omega = v[5usize];
            let sum_17_bar_omega = sum_17 * bar_omega;
            let minus_right_side_front = T::fused(cos_4, c[3usize], sum_17_bar_omega);
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let c4_cos_seat_phi = c[4usize] * cos_seat_phi;
            let cos_bar_phi_c5 = cos_bar_phi * c[5usize];
            let product_30 = cos_bar_phi * cos_bar_phi_c5;
            let difference_31 = T::fused(-cos_seat_phi, c4_cos_seat_phi, product_30);
            let sum_33 = difference_31 + c[6usize];
            let c4_sin_seat_phi = c[4usize] * sin_seat_phi;
            let sin_bar_phi_c5 = sin_bar_phi * c[5usize];
            let product_38 = cos_bar_phi * sin_bar_phi_c5;
            let difference_39 = T::fused(-cos_seat_phi, c4_sin_seat_phi, product_38);
            let difference_41 = c[7usize] - difference_31;
            let sum_45 = T::fused(force_seat_phi, c[9usize], c[8usize]);
            let cos_4_c10 = cos_4 * c[10usize];
            let sum_51 = T::fused(minus_right_side_front, c[11usize], cos_4_c10);
            let sin_bar_phi_sum_51 = sin_bar_phi * sum_51;
            let difference_53 = T::fused(-sin_seat_phi, sum_45, sin_bar_phi_sum_51);
            let seat_omega = v[2usize];
            let c12_seat_omega = c[12usize] * seat_omega;
            let product_57 = seat_omega * c12_seat_omega;
            let difference_59 = T::fused(-cos_seat_phi, product_57, difference_53);
            let bar_omega_c13 = bar_omega * c[13usize];
            let bar_omega_bar_omega_c13 = bar_omega * bar_omega_c13;
            let difference_64 = T::fused(
                -cos_bar_phi,
                bar_omega_bar_omega_c13,
                difference_59,
            );
            let cos_seat_phi_sum_45 = cos_seat_phi * sum_45;
            let difference_67 = T::fused(-cos_bar_phi, sum_51, cos_seat_phi_sum_45);
            let difference_69 = T::fused(-sin_seat_phi, product_57, difference_67);
            let difference_71 = T::fused(
                -sin_bar_phi,
                bar_omega_bar_omega_c13,
                difference_69,
            );
            let sum_33_difference_41 = sum_33 * difference_41;
            let difference_74 = T::fused(
                -difference_39,
                difference_39,
                sum_33_difference_41,
            );
            let quotient_75 = T::from_f64(1f64) / difference_74;
            let product_76 = difference_41 * difference_64;
            let difference_78 = T::fused(-difference_39, difference_71, product_76);
            let lambda_B_x = quotient_75 * difference_78;
            let sum_33_difference_71 = sum_33 * difference_71;
            let difference_82 = T::fused(
                -difference_39,
                difference_64,
                sum_33_difference_71,
            );
            let lambda_B_y = quotient_75 * difference_82;
            let cos_bar_phi_lambda_B_y = cos_bar_phi * lambda_B_y;
            let difference_86 = T::fused(
                -sin_bar_phi,
                lambda_B_x,
                cos_bar_phi_lambda_B_y,
            );
            let c11_difference_86 = c[11usize] * difference_86;
            let lambda_front = T::fused(
                -minus_right_side_front,
                c[14usize],
                c11_difference_86,
            );
            let sin_seat_phi_c8 = sin_seat_phi * c[8usize];
            let sum_94 = T::fused(lambda_B_x, c[15usize], sin_seat_phi_c8);
            let cos_seat_phi_c8 = cos_seat_phi * c[8usize];
            let difference_97 = T::fused(-lambda_B_y, c[15usize], cos_seat_phi_c8);
            let sin_seat_phi_lambda_B_x = sin_seat_phi * lambda_B_x;
            let difference_100 = T::fused(
                -cos_seat_phi,
                lambda_B_y,
                sin_seat_phi_lambda_B_x,
            );
            let c9_difference_100 = c[9usize] * difference_100;
            let sum_104 = T::fused(force_seat_phi, c[16usize], c9_difference_100);
            let sum_106 = T::fused(sin_bar_phi, lambda_front, lambda_B_x);
            let sum_106_c17 = sum_106 * c[17usize];
            let difference_110 = T::fused(-cos_bar_phi, lambda_front, lambda_B_y);
            let c17_difference_110 = c[17usize] * difference_110;
            let difference_86_c18 = difference_86 * c[18usize];
            let sum_116 = T::fused(cos_4, c[19usize], difference_86_c18);
            let sum_119 = T::fused(lambda_front, c[20usize], sum_116);
            let value_123 = -sum_94;
            let value_124 = -sum_119;
            a[0usize] = value_123;
            a[1usize] = difference_97;
            a[2usize] = sum_104;
            a[3usize] = sum_106_c17;
            a[4usize] = c17_difference_110;
            a[5usize] = value_124;
            lambda[0usize] = lambda_B_x;
            lambda[1usize] = lambda_B_y;
            lambda[2usize] = lambda_front;
            ::ezy_core::model::Pivots::new()
                .see(&[2usize], T::least_ratio(c[21usize], c[22usize]))
                .see(&[0usize, 1usize], T::least_ratio(difference_74, c[23usize]))
        }
        #[inline]
        fn correction(
            &self,
            c: &[T],
            t: T,
            q: &[T],
            residual: &[T],
            delta: &mut [T],
        ) -> ::ezy_core::model::Pivots {
            let c = ::ezy_core::kernel::array::<35usize, T>(c);
            let q = ::ezy_core::kernel::array::<6usize, T>(q);
            let residual = ::ezy_core::kernel::array::<3usize, T>(residual);
            let delta = ::ezy_core::kernel::array_mut::<6usize, T>(delta);
            let right_side_front = residual[2usize];
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let c4_cos_seat_phi = c[4usize] * cos_seat_phi;
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
            let c5_cos_bar_phi = c[5usize] * cos_bar_phi;
            let product_12 = cos_bar_phi * c5_cos_bar_phi;
            let difference_13 = T::fused(-cos_seat_phi, c4_cos_seat_phi, product_12);
            let sum_15 = difference_13 + c[6usize];
            let c4_sin_seat_phi = c[4usize] * sin_seat_phi;
            let c5_sin_bar_phi = c[5usize] * sin_bar_phi;
            let product_21 = cos_bar_phi * c5_sin_bar_phi;
            let difference_22 = T::fused(-cos_seat_phi, c4_sin_seat_phi, product_21);
            let difference_24 = c[7usize] - difference_13;
            let residual_0 = residual[0usize];
            let right_side_front_c11 = right_side_front * c[11usize];
            let difference_29 = T::fused(-sin_bar_phi, right_side_front_c11, residual_0);
            let residual_1 = residual[1usize];
            let sum_32 = T::fused(cos_bar_phi, right_side_front_c11, residual_1);
            let sum_15_difference_24 = sum_15 * difference_24;
            let difference_35 = T::fused(
                -difference_22,
                difference_22,
                sum_15_difference_24,
            );
            let quotient_36 = T::from_f64(1f64) / difference_35;
            let product_37 = difference_24 * difference_29;
            let difference_39 = T::fused(-difference_22, sum_32, product_37);
            let lambda_B_x = quotient_36 * difference_39;
            let sum_15_sum_32 = sum_15 * sum_32;
            let difference_43 = T::fused(-difference_22, difference_29, sum_15_sum_32);
            let lambda_B_y = quotient_36 * difference_43;
            let cos_bar_phi_lambda_B_y = cos_bar_phi * lambda_B_y;
            let difference_47 = T::fused(
                -sin_bar_phi,
                lambda_B_x,
                cos_bar_phi_lambda_B_y,
            );
            let c11_difference_47 = c[11usize] * difference_47;
            let lambda_front = T::fused(right_side_front, c[14usize], c11_difference_47);
            let lambda_B_x_c15 = lambda_B_x * c[15usize];
            let lambda_B_y_c15 = lambda_B_y * c[15usize];
            let sin_seat_phi_lambda_B_x = sin_seat_phi * lambda_B_x;
            let difference_57 = T::fused(
                -cos_seat_phi,
                lambda_B_y,
                sin_seat_phi_lambda_B_x,
            );
            let difference_57_c9 = difference_57 * c[9usize];
            let sum_61 = T::fused(sin_bar_phi, lambda_front, lambda_B_x);
            let sum_61_c17 = sum_61 * c[17usize];
            let difference_65 = T::fused(-cos_bar_phi, lambda_front, lambda_B_y);
            let c17_difference_65 = c[17usize] * difference_65;
            let difference_47_c18 = difference_47 * c[18usize];
            let sum_71 = T::fused(lambda_front, c[20usize], difference_47_c18);
            let value_75 = -lambda_B_x_c15;
            let value_76 = -lambda_B_y_c15;
            let value_77 = -sum_71;
            delta[0usize] = value_75;
            delta[1usize] = value_76;
            delta[2usize] = difference_57_c9;
            delta[3usize] = sum_61_c17;
            delta[4usize] = c17_difference_65;
            delta[5usize] = value_77;
            ::ezy_core::model::Pivots::new()
                .see(&[2usize], T::least_ratio(c[21usize], c[22usize]))
                .see(&[0usize, 1usize], T::least_ratio(difference_35, c[23usize]))
        }
    }
    #[automatically_derived]
    impl ::ezy_core::model::Scene for SlidesRight {
        fn info(&self) -> &'static ::ezy_core::model::SceneInfo {
            static INFO: ::ezy_core::model::SceneInfo = SlidesRight::INFO;
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
                10usize => self.hold,
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
                10usize => self.hold = value,
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
            let c = ::ezy_core::kernel::array::<35usize, f64>(c);
            let q = ::ezy_core::kernel::array::<6usize, f64>(q);
            let v = ::ezy_core::kernel::array::<6usize, f64>(v);
            let lambda = ::ezy_core::kernel::array::<3usize, f64>(lambda);
            let out = ::ezy_core::kernel::array_mut::<2usize, f64>(out);
            let seat_omega = v[2usize];
            let bar_omega = v[5usize];
            let difference_4 = seat_omega - bar_omega;
            let c1_t = c[1usize] * t;
            let cos_7 = f64::cos(c1_t);
            let difference_4_cos_7 = difference_4 * cos_7;
            let difference_4_cos_7_c0 = difference_4_cos_7 * c[0usize];
            let seat_vx = v[0usize];
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = f64::sin_cos(seat_phi);
            let seat_vx_sin_seat_phi = seat_vx * sin_seat_phi;
            let seat_vy = v[1usize];
            let seat_vy_cos_seat_phi = seat_vy * cos_seat_phi;
            let difference_19 = seat_vy_cos_seat_phi - seat_vx_sin_seat_phi;
            let difference_19_c24 = difference_19 * c[24usize];
            let seat_omega_c2 = seat_omega * c[2usize];
            let difference_24 = difference_19_c24 - seat_omega_c2;
            out[0usize] = difference_4_cos_7_c0;
            out[1usize] = difference_24;
        }
        fn points(&self, c: &[f64], t: f64, q: &[f64], out: &mut [f64]) {
            let c = ::ezy_core::kernel::array::<35usize, f64>(c);
            let q = ::ezy_core::kernel::array::<6usize, f64>(q);
            let out = ::ezy_core::kernel::array_mut::<6usize, f64>(out);
            let seat_x = q[0usize];
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = f64::sin_cos(seat_phi);
            let c31_cos_seat_phi = c[31usize] * cos_seat_phi;
            let difference_7 = seat_x - c31_cos_seat_phi;
            let seat_y = q[1usize];
            let c31_sin_seat_phi = c[31usize] * sin_seat_phi;
            let difference_11 = seat_y - c31_sin_seat_phi;
            let bar_x = q[3usize];
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = f64::sin_cos(bar_phi);
            let c30_cos_bar_phi = c[30usize] * cos_bar_phi;
            let sum_17 = bar_x + c30_cos_bar_phi;
            let bar_y = q[4usize];
            let c30_sin_bar_phi = c[30usize] * sin_bar_phi;
            let sum_21 = bar_y + c30_sin_bar_phi;
            let cos_seat_phi_c12 = cos_seat_phi * c[12usize];
            let sum_24 = seat_x + cos_seat_phi_c12;
            let sin_seat_phi_c12 = sin_seat_phi * c[12usize];
            let sum_26 = seat_y + sin_seat_phi_c12;
            out[0usize] = difference_7;
            out[1usize] = difference_11;
            out[2usize] = sum_17;
            out[3usize] = sum_21;
            out[4usize] = sum_24;
            out[5usize] = sum_26;
        }
        fn outputs(&self, c: &[f64], t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
            let c = ::ezy_core::kernel::array::<35usize, f64>(c);
            let q = ::ezy_core::kernel::array::<6usize, f64>(q);
            let v = ::ezy_core::kernel::array::<6usize, f64>(v);
            let out = ::ezy_core::kernel::array_mut::<0usize, f64>(out);
        }
        fn grip(&self, c: &[f64], t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
            let c = ::ezy_core::kernel::array::<35usize, f64>(c);
            let q = ::ezy_core::kernel::array::<6usize, f64>(q);
            let v = ::ezy_core::kernel::array::<6usize, f64>(v);
            let out = ::ezy_core::kernel::array_mut::<2usize, f64>(out);
            let seat_omega = v[2usize];
            let c31_seat_omega = c[31usize] * seat_omega;
            let seat_vx = v[0usize];
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = f64::sin_cos(seat_phi);
            let seat_vx_sin_seat_phi = seat_vx * sin_seat_phi;
            let sum_10 = c31_seat_omega + seat_vx_sin_seat_phi;
            let seat_vy = v[1usize];
            let seat_vy_cos_seat_phi = seat_vy * cos_seat_phi;
            let difference_14 = seat_vy_cos_seat_phi - sum_10;
            out[0usize] = c[24usize];
            out[1usize] = difference_14;
        }
        fn potential_energy(&self, c: &[f64], t: f64, q: &[f64]) -> f64 {
            0f64
        }
        fn start(&self, c: &[f64], start: &mut ::ezy_core::model::Start) {
            let c = ::ezy_core::kernel::array::<35usize, f64>(c);
            start.give_position(0usize, 0f64);
            start.give_position(1usize, 0f64);
            start.give_position(2usize, 0f64);
            start.give_position(5usize, c[32usize]);
        }
        fn slope_places(
            &self,
        ) -> ::core::option::Option<::ezy_core::model::SlopePlaces> {
            ::core::option::Option::Some(::ezy_core::model::SlopePlaces {
                by_q: ::std::vec![
                    (0usize, 2usize), (1usize, 2usize), (2usize, 2usize), (3usize,
                    5usize), (4usize, 5usize), (5usize, 5usize), (6usize, 2usize),
                    (6usize, 5usize), (7usize, 2usize), (7usize, 5usize), (8usize,
                    5usize)
                ],
                by_v: ::std::vec![
                    (6usize, 2usize), (6usize, 5usize), (7usize, 2usize), (7usize,
                    5usize), (8usize, 3usize), (8usize, 4usize), (8usize, 5usize)
                ],
            })
        }
        fn slopes(
            &self,
            c: &[f64],
            t: f64,
            q: &[f64],
            v: &[f64],
            a: &[f64],
            lambda: &[f64],
            by_q: &mut [f64],
            by_v: &mut [f64],
        ) {
            let c = ::ezy_core::kernel::array::<35usize, f64>(c);
            let q = ::ezy_core::kernel::array::<6usize, f64>(q);
            let v = ::ezy_core::kernel::array::<6usize, f64>(v);
            let a = ::ezy_core::kernel::array::<6usize, f64>(a);
            let lambda = ::ezy_core::kernel::array::<3usize, f64>(lambda);
            let by_q = ::ezy_core::kernel::array_mut::<11usize, f64>(by_q);
            let by_v = ::ezy_core::kernel::array_mut::<7usize, f64>(by_v);
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = f64::sin_cos(seat_phi);
            let c24_cos_seat_phi = c[24usize] * cos_seat_phi;
            let c24_sin_seat_phi = c[24usize] * sin_seat_phi;
            let multiplier_0 = lambda[0usize];
            let product_9 = cos_seat_phi * multiplier_0;
            let multiplier_1 = lambda[1usize];
            let product_11 = sin_seat_phi * multiplier_1;
            let sum_12 = product_9 + product_11;
            let sum_12_c12 = sum_12 * c[12usize];
            let multiplier_2 = lambda[2usize];
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = f64::sin_cos(bar_phi);
            let multiplier_2_cos_bar_phi = multiplier_2 * cos_bar_phi;
            let multiplier_2_sin_bar_phi = multiplier_2 * sin_bar_phi;
            let multiplier_0_cos_bar_phi = multiplier_0 * cos_bar_phi;
            let multiplier_1_sin_bar_phi = multiplier_1 * sin_bar_phi;
            let sum_23 = multiplier_0_cos_bar_phi + multiplier_1_sin_bar_phi;
            let sum_23_c13 = sum_23 * c[13usize];
            let seat_omega = v[2usize];
            let seat_omega_seat_omega = seat_omega * seat_omega;
            let product_28 = sin_seat_phi * seat_omega_seat_omega;
            let acceleration_2 = a[2usize];
            let product_30 = cos_seat_phi * acceleration_2;
            let difference_31 = product_30 - product_28;
            let c12_difference_31 = c[12usize] * difference_31;
            let bar_omega = v[5usize];
            let bar_omega_bar_omega = bar_omega * bar_omega;
            let product_35 = sin_bar_phi * bar_omega_bar_omega;
            let acceleration_5 = a[5usize];
            let product_37 = cos_bar_phi * acceleration_5;
            let difference_38 = product_37 - product_35;
            let c13_difference_38 = c[13usize] * difference_38;
            let product_40 = cos_seat_phi * seat_omega_seat_omega;
            let product_41 = sin_seat_phi * acceleration_2;
            let sum_42 = product_40 + product_41;
            let c12_sum_42 = c[12usize] * sum_42;
            let product_44 = cos_bar_phi * bar_omega_bar_omega;
            let product_45 = sin_bar_phi * acceleration_5;
            let sum_46 = product_44 + product_45;
            let c13_sum_46 = c[13usize] * sum_46;
            let bar_vx = v[3usize];
            let bar_omega_bar_vx = bar_omega * bar_vx;
            let acceleration_4 = a[4usize];
            let difference_51 = acceleration_4 - bar_omega_bar_vx;
            let product_52 = sin_bar_phi * difference_51;
            let bar_vy = v[4usize];
            let bar_omega_bar_vy = bar_omega * bar_vy;
            let acceleration_3 = a[3usize];
            let sum_56 = bar_omega_bar_vy + acceleration_3;
            let cos_bar_phi_sum_56 = cos_bar_phi * sum_56;
            let sum_58 = product_52 + cos_bar_phi_sum_56;
            let seat_omega_c33 = seat_omega * c[33usize];
            let product_61 = cos_seat_phi * seat_omega_c33;
            let bar_omega_c34 = bar_omega * c[34usize];
            let product_64 = cos_bar_phi * bar_omega_c34;
            let product_65 = sin_seat_phi * seat_omega_c33;
            let product_66 = sin_bar_phi * bar_omega_c34;
            let cos_bar_phi_bar_omega = cos_bar_phi * bar_omega;
            let sin_bar_phi_bar_omega = sin_bar_phi * bar_omega;
            let cos_bar_phi_bar_vx = cos_bar_phi * bar_vx;
            let sin_bar_phi_bar_vy = sin_bar_phi * bar_vy;
            let sum_71 = cos_bar_phi_bar_vx + sin_bar_phi_bar_vy;
            let value_72 = -c24_cos_seat_phi;
            let value_73 = -c24_sin_seat_phi;
            by_q[0usize] = value_72;
            by_q[1usize] = value_73;
            by_q[2usize] = sum_12_c12;
            by_q[3usize] = multiplier_2_cos_bar_phi;
            by_q[4usize] = multiplier_2_sin_bar_phi;
            by_q[5usize] = sum_23_c13;
            by_q[6usize] = c12_difference_31;
            by_q[7usize] = c13_difference_38;
            by_q[8usize] = c12_sum_42;
            by_q[9usize] = c13_sum_46;
            by_q[10usize] = sum_58;
            by_v[0usize] = product_61;
            by_v[1usize] = product_64;
            by_v[2usize] = product_65;
            by_v[3usize] = product_66;
            by_v[4usize] = cos_bar_phi_bar_omega;
            by_v[5usize] = sin_bar_phi_bar_omega;
            by_v[6usize] = sum_71;
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
    impl<T: ::ezy_core::scalar::Scalar> ::ezy_core::model::Series<T> for SlidesRight {
        fn series_size(&self) -> ::ezy_core::model::SeriesSize {
            ::ezy_core::model::SeriesSize {
                n_coordinates: 6usize,
                n_rows: 3usize,
                n_products: 16usize,
                n_base: 8usize,
                n_kept: 6usize,
            }
        }
        fn begin(
            &self,
            c: &[T],
            t: T,
            store: &mut ::ezy_core::model::SeriesStore<T>,
        ) -> ::ezy_core::model::Pivots {
            let c = ::ezy_core::kernel::array::<35usize, T>(c);
            let q = ::ezy_core::kernel::row::<6usize, T>(&store.q, 0);
            let v = ::ezy_core::kernel::row::<6usize, T>(&store.q, 1);
            let seat_phi = q[2usize];
            let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
            let bar_phi = q[5usize];
            let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
            let seat_omega = v[2usize];
            let c12_seat_omega = c[12usize] * seat_omega;
            let product_26 = seat_omega * c12_seat_omega;
            let cos_seat_phi_product_26 = cos_seat_phi * product_26;
            let bar_omega = v[5usize];
            let c13_bar_omega = c[13usize] * bar_omega;
            let bar_omega_c13_bar_omega = bar_omega * c13_bar_omega;
            let sum_32 = T::fused(
                cos_bar_phi,
                bar_omega_c13_bar_omega,
                cos_seat_phi_product_26,
            );
            let sin_seat_phi_product_26 = sin_seat_phi * product_26;
            let sum_35 = T::fused(
                sin_bar_phi,
                bar_omega_c13_bar_omega,
                sin_seat_phi_product_26,
            );
            let bar_vx = v[3usize];
            let cos_bar_phi_bar_vx = cos_bar_phi * bar_vx;
            let bar_vy = v[4usize];
            let sum_40 = T::fused(sin_bar_phi, bar_vy, cos_bar_phi_bar_vx);
            let bar_omega_sum_40 = bar_omega * sum_40;
            let sin_seat_phi_c24 = sin_seat_phi * c[24usize];
            let cos_seat_phi_c24 = cos_seat_phi * c[24usize];
            let c1_t = c[1usize] * t;
            let (sin_48, cos_48) = T::sin_cos(c1_t);
            let c0_cos_48 = c[0usize] * cos_48;
            let difference_52 = c0_cos_48 - c[2usize];
            let cos_seat_phi_c4 = cos_seat_phi * c[4usize];
            let cos_bar_phi_c5 = cos_bar_phi * c[5usize];
            let product_71 = cos_bar_phi * cos_bar_phi_c5;
            let difference_72 = T::fused(-cos_seat_phi, cos_seat_phi_c4, product_71);
            let sum_74 = difference_72 + c[6usize];
            let sin_seat_phi_c4 = sin_seat_phi * c[4usize];
            let sin_bar_phi_c5 = sin_bar_phi * c[5usize];
            let product_78 = cos_bar_phi * sin_bar_phi_c5;
            let difference_79 = T::fused(-cos_seat_phi, sin_seat_phi_c4, product_78);
            let difference_81 = c[7usize] - difference_72;
            let sum_74_difference_81 = sum_74 * difference_81;
            let difference_113 = T::fused(
                -difference_79,
                difference_79,
                sum_74_difference_81,
            );
            let quotient_114 = T::from_f64(1f64) / difference_113;
            let cos_seat_phi_seat_omega = cos_seat_phi * seat_omega;
            let sin_seat_phi_seat_omega = sin_seat_phi * seat_omega;
            let cos_bar_phi_bar_omega = cos_bar_phi * bar_omega;
            let sin_bar_phi_bar_omega = sin_bar_phi * bar_omega;
            let product_163 = c[24usize] * cos_seat_phi_seat_omega;
            let product_164 = c[24usize] * sin_seat_phi_seat_omega;
            let c1_sin_48 = c[1usize] * sin_48;
            let c0_c1_sin_48 = c[0usize] * c1_sin_48;
            let c1_cos_48 = c[1usize] * cos_48;
            let value_168 = -sin_seat_phi_c24;
            let value_169 = -c0_cos_48;
            let value_170 = -sin_seat_phi_seat_omega;
            let value_171 = -sin_bar_phi_bar_omega;
            let value_172 = -product_164;
            let value_173 = -c0_c1_sin_48;
            let value_174 = -c1_sin_48;
            let target = ::ezy_core::kernel::array_mut::<8usize, T>(&mut store.base);
            target[0usize] = cos_seat_phi;
            target[1usize] = sin_seat_phi;
            target[2usize] = cos_bar_phi;
            target[3usize] = sin_bar_phi;
            target[4usize] = quotient_114;
            target[5usize] = difference_81;
            target[6usize] = difference_79;
            target[7usize] = sum_74;
            let target = ::ezy_core::kernel::array_mut::<6usize, T>(&mut store.force);
            target[0usize] = value_168;
            target[1usize] = cos_seat_phi_c24;
            target[2usize] = difference_52;
            target[3usize] = T::from_f64(0f64);
            target[4usize] = T::from_f64(0f64);
            target[5usize] = value_169;
            let target = ::ezy_core::kernel::row_mut::<
                6usize,
                T,
            >(&mut store.kept, 0usize);
            target[0usize] = sin_seat_phi_c24;
            target[1usize] = cos_seat_phi_c24;
            target[2usize] = difference_52;
            target[3usize] = c0_cos_48;
            target[4usize] = sin_48;
            target[5usize] = cos_48;
            let target = ::ezy_core::kernel::row_mut::<
                6usize,
                T,
            >(&mut store.kept, 1usize);
            target[0usize] = product_163;
            target[1usize] = value_172;
            target[2usize] = value_173;
            target[3usize] = value_173;
            target[4usize] = c1_cos_48;
            target[5usize] = value_174;
            let target = ::ezy_core::kernel::row_mut::<
                16usize,
                T,
            >(&mut store.left, 1usize);
            target[0usize] = cos_seat_phi_seat_omega;
            target[1usize] = value_170;
            target[2usize] = cos_bar_phi_bar_omega;
            target[3usize] = value_171;
            target[4usize] = cos_bar_phi_bar_omega;
            target[5usize] = value_171;
            target[6usize] = seat_omega;
            target[7usize] = bar_omega;
            target[8usize] = seat_omega;
            target[9usize] = bar_omega;
            target[10usize] = cos_bar_phi_bar_omega;
            target[11usize] = value_171;
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
            target[6usize] = cos_seat_phi_seat_omega;
            target[7usize] = cos_bar_phi_bar_omega;
            target[8usize] = value_170;
            target[9usize] = value_171;
            target[10usize] = bar_vx;
            target[11usize] = bar_vy;
            let target = ::ezy_core::kernel::array_mut::<3usize, T>(&mut store.row);
            target[0usize] = sum_32;
            target[1usize] = sum_35;
            target[2usize] = bar_omega_sum_40;
            ::ezy_core::model::Pivots::new()
                .see(&[2usize], T::least_ratio(c[21usize], c[22usize]))
                .see(&[0usize, 1usize], T::least_ratio(difference_113, c[23usize]))
        }
        #[inline(always)]
        fn right_side(
            &self,
            c: &[T],
            k: usize,
            store: &mut ::ezy_core::model::SeriesStore<T>,
        ) {
            let c = ::ezy_core::kernel::array::<35usize, T>(c);
            let kept_0 = ::ezy_core::kernel::row::<6usize, T>(&store.kept, k + 0usize);
            let sums = ::ezy_core::kernel::array::<16usize, T>(&store.sums);
            let kept_0 = kept_0[0usize];
            let kept_1 = kept_0[1usize];
            let kept_2 = kept_0[2usize];
            let convolved_0 = sums[0usize];
            let convolved_1 = sums[1usize];
            let c12_convolved_1 = c[12usize] * convolved_1;
            let difference_9 = T::fused(-c[12usize], convolved_0, c12_convolved_1);
            let difference_10 = kept_2 - difference_9;
            let convolved_2 = sums[2usize];
            let convolved_3 = sums[3usize];
            let kept_3 = kept_0[3usize];
            let convolved_4 = sums[4usize];
            let convolved_5 = sums[5usize];
            let c13_convolved_5 = c[13usize] * convolved_5;
            let difference_20 = T::fused(-c[13usize], convolved_4, c13_convolved_5);
            let sum_21 = kept_3 + difference_20;
            let convolved_6 = sums[6usize];
            let inverse_order_ahead = T::from_f64(1f64)
                / T::from_f64((k + 2usize) as f64);
            let product_24 = convolved_6 * inverse_order_ahead;
            let c12_product_24 = c[12usize] * product_24;
            let convolved_7 = sums[7usize];
            let product_27 = inverse_order_ahead * convolved_7;
            let sum_29 = T::fused(c[13usize], product_27, c12_product_24);
            let order_next = T::from_f64((k + 1usize) as f64);
            let order_ahead = T::from_f64((k + 2usize) as f64);
            let order_next_order_ahead = order_next * order_ahead;
            let product_33 = sum_29 * order_next_order_ahead;
            let convolved_8 = sums[8usize];
            let product_35 = inverse_order_ahead * convolved_8;
            let c12_product_35 = c[12usize] * product_35;
            let convolved_9 = sums[9usize];
            let product_38 = inverse_order_ahead * convolved_9;
            let sum_40 = T::fused(c[13usize], product_38, c12_product_35);
            let product_41 = order_next_order_ahead * sum_40;
            let convolved_10 = sums[10usize];
            let convolved_11 = sums[11usize];
            let difference_44 = convolved_10 - convolved_11;
            let order_next_difference_44 = order_next * difference_44;
            let value_46 = -kept_0;
            let value_47 = -convolved_3;
            let value_48 = -sum_21;
            let value_49 = -product_41;
            let target = ::ezy_core::kernel::array_mut::<6usize, T>(&mut store.force);
            target[0usize] = value_46;
            target[1usize] = kept_1;
            target[2usize] = difference_10;
            target[3usize] = convolved_2;
            target[4usize] = value_47;
            target[5usize] = value_48;
            let target = ::ezy_core::kernel::array_mut::<3usize, T>(&mut store.row);
            target[0usize] = product_33;
            target[1usize] = value_49;
            target[2usize] = order_next_difference_44;
        }
        #[inline(always)]
        fn solve(
            &self,
            c: &[T],
            k: usize,
            store: &mut ::ezy_core::model::SeriesStore<T>,
        ) {
            let c = ::ezy_core::kernel::array::<35usize, T>(c);
            let base = ::ezy_core::kernel::array::<8usize, T>(&store.base);
            let force = ::ezy_core::kernel::array::<6usize, T>(&store.force);
            let row = ::ezy_core::kernel::array::<3usize, T>(&store.row);
            let force_0 = force[0usize];
            let base_4 = base[4usize];
            let base_5 = base[5usize];
            let c15_force_0 = c[15usize] * force_0;
            let base_3 = base[3usize];
            let force_5 = force[5usize];
            let force_5_c18 = force_5 * c[18usize];
            let base_2 = base[2usize];
            let force_4 = force[4usize];
            let base_2_force_4 = base_2 * force_4;
            let force_3 = force[3usize];
            let difference_14 = T::fused(-base_3, force_3, base_2_force_4);
            let difference_14_c17 = difference_14 * c[17usize];
            let sum_19 = T::fused(force_5, c[20usize], difference_14_c17);
            let row_2 = row[2usize];
            let right_side_front = sum_19 - row_2;
            let sum_24 = T::fused(right_side_front, c[11usize], force_5_c18);
            let difference_26 = T::fused(-base_3, sum_24, c15_force_0);
            let difference_28 = T::fused(-force_3, c[17usize], difference_26);
            let row_0 = row[0usize];
            let difference_30 = difference_28 - row_0;
            let base_1 = base[1usize];
            let force_2 = force[2usize];
            let c9_force_2 = c[9usize] * force_2;
            let difference_36 = T::fused(-base_1, c9_force_2, difference_30);
            let base_5_difference_36 = base_5 * difference_36;
            let base_6 = base[6usize];
            let base_2_sum_24 = base_2 * sum_24;
            let force_1 = force[1usize];
            let sum_42 = T::fused(c[15usize], force_1, base_2_sum_24);
            let difference_44 = T::fused(-force_4, c[17usize], sum_42);
            let row_1 = row[1usize];
            let difference_46 = difference_44 - row_1;
            let base_0 = base[0usize];
            let sum_49 = T::fused(c9_force_2, base_0, difference_46);
            let difference_51 = T::fused(-base_6, sum_49, base_5_difference_36);
            let lambda_B_x = base_4 * difference_51;
            let difference_53 = force_0 - lambda_B_x;
            let c15_difference_53 = c[15usize] * difference_53;
            let base_7 = base[7usize];
            let sum_49_base_7 = sum_49 * base_7;
            let difference_58 = T::fused(-difference_36, base_6, sum_49_base_7);
            let lambda_B_y = base_4 * difference_58;
            let difference_60 = force_1 - lambda_B_y;
            let c15_difference_60 = c[15usize] * difference_60;
            let base_1_lambda_B_x = base_1 * lambda_B_x;
            let difference_64 = T::fused(-base_0, lambda_B_y, base_1_lambda_B_x);
            let c9_difference_64 = c[9usize] * difference_64;
            let sum_68 = T::fused(force_2, c[16usize], c9_difference_64);
            let sum_69 = force_3 + lambda_B_x;
            let base_2_lambda_B_y = base_2 * lambda_B_y;
            let difference_72 = T::fused(-base_3, lambda_B_x, base_2_lambda_B_y);
            let c11_difference_72 = c[11usize] * difference_72;
            let lambda_front = T::fused(right_side_front, c[14usize], c11_difference_72);
            let sum_78 = T::fused(base_3, lambda_front, sum_69);
            let c17_sum_78 = c[17usize] * sum_78;
            let sum_80 = force_4 + lambda_B_y;
            let difference_82 = T::fused(-base_2, lambda_front, sum_80);
            let c17_difference_82 = c[17usize] * difference_82;
            let force_5_c25 = force_5 * c[25usize];
            let difference_87 = T::fused(-c[18usize], difference_72, force_5_c25);
            let difference_89 = T::fused(-c[20usize], lambda_front, difference_87);
            let target = ::ezy_core::kernel::array_mut::<6usize, T>(&mut store.a);
            target[0usize] = c15_difference_53;
            target[1usize] = c15_difference_60;
            target[2usize] = sum_68;
            target[3usize] = c17_sum_78;
            target[4usize] = c17_difference_82;
            target[5usize] = difference_89;
            let target = ::ezy_core::kernel::row_mut::<
                3usize,
                T,
            >(&mut store.lambda, k + 0usize);
            target[0usize] = lambda_B_x;
            target[1usize] = lambda_B_y;
            target[2usize] = lambda_front;
        }
        #[inline(always)]
        fn finish(
            &self,
            c: &[T],
            k: usize,
            store: &mut ::ezy_core::model::SeriesStore<T>,
        ) {
            let c = ::ezy_core::kernel::array::<35usize, T>(c);
            let a = ::ezy_core::kernel::array::<6usize, T>(&store.a);
            let base = ::ezy_core::kernel::array::<8usize, T>(&store.base);
            let kept_1 = ::ezy_core::kernel::row::<6usize, T>(&store.kept, k + 1usize);
            let lambda_0 = ::ezy_core::kernel::row::<
                3usize,
                T,
            >(&store.lambda, k + 0usize);
            let sums = ::ezy_core::kernel::array::<16usize, T>(&store.sums);
            let a_0 = a[0usize];
            let inverse_order_next = T::from_f64(1f64)
                / T::from_f64((k + 1usize) as f64);
            let inverse_order_ahead = T::from_f64(1f64)
                / T::from_f64((k + 2usize) as f64);
            let product_3 = inverse_order_next * inverse_order_ahead;
            let a_0_product_3 = a_0 * product_3;
            let a_1 = a[1usize];
            let product_3_a_1 = product_3 * a_1;
            let a_2 = a[2usize];
            let product_3_a_2 = product_3 * a_2;
            let a_3 = a[3usize];
            let product_3_a_3 = product_3 * a_3;
            let a_4 = a[4usize];
            let product_3_a_4 = product_3 * a_4;
            let a_5 = a[5usize];
            let product_3_a_5 = product_3 * a_5;
            let lambda_0 = lambda_0[0usize];
            let convolved_8 = sums[8usize];
            let product_19 = inverse_order_ahead * convolved_8;
            let base_0 = base[0usize];
            let sum_22 = T::fused(product_3_a_2, base_0, product_19);
            let lambda_1 = lambda_0[1usize];
            let convolved_6 = sums[6usize];
            let product_25 = inverse_order_ahead * convolved_6;
            let base_1 = base[1usize];
            let sum_28 = T::fused(product_3_a_2, base_1, product_25);
            let lambda_2 = lambda_0[2usize];
            let convolved_9 = sums[9usize];
            let product_31 = inverse_order_ahead * convolved_9;
            let base_2 = base[2usize];
            let sum_34 = T::fused(product_3_a_5, base_2, product_31);
            let convolved_7 = sums[7usize];
            let product_36 = inverse_order_ahead * convolved_7;
            let base_3 = base[3usize];
            let sum_39 = T::fused(product_3_a_5, base_3, product_36);
            let order_ahead = T::from_f64((k + 2usize) as f64);
            let product_41 = product_3_a_2 * order_ahead;
            let product_42 = product_3_a_5 * order_ahead;
            let product_43 = product_3_a_3 * order_ahead;
            let product_44 = product_3_a_4 * order_ahead;
            let sum_22_c24 = sum_22 * c[24usize];
            let sum_28_c24 = sum_28 * c[24usize];
            let kept_4_next = kept_1[4usize];
            let inverse_order_ahead_c1 = inverse_order_ahead * c[1usize];
            let product_52 = kept_4_next * inverse_order_ahead_c1;
            let c0_product_52 = c[0usize] * product_52;
            let kept_5_next = kept_1[5usize];
            let product_55 = inverse_order_ahead_c1 * kept_5_next;
            let value_56 = -sum_28;
            let value_57 = -sum_39;
            let value_58 = -sum_28_c24;
            let value_59 = -c0_product_52;
            let value_60 = -product_52;
            let target = ::ezy_core::kernel::row_mut::<
                6usize,
                T,
            >(&mut store.kept, k + 2usize);
            target[0usize] = sum_22_c24;
            target[1usize] = value_58;
            target[2usize] = value_59;
            target[3usize] = value_59;
            target[4usize] = product_55;
            target[5usize] = value_60;
            let target = ::ezy_core::kernel::row_mut::<
                16usize,
                T,
            >(&mut store.left, k + 2usize);
            target[0usize] = sum_22;
            target[1usize] = value_56;
            target[2usize] = sum_34;
            target[3usize] = value_57;
            target[4usize] = sum_34;
            target[5usize] = value_57;
            target[6usize] = product_41;
            target[7usize] = product_42;
            target[8usize] = product_41;
            target[9usize] = product_42;
            target[10usize] = sum_34;
            target[11usize] = value_57;
            let target = ::ezy_core::kernel::row_mut::<
                6usize,
                T,
            >(&mut store.q, k + 2usize);
            target[0usize] = a_0_product_3;
            target[1usize] = product_3_a_1;
            target[2usize] = product_3_a_2;
            target[3usize] = product_3_a_3;
            target[4usize] = product_3_a_4;
            target[5usize] = product_3_a_5;
            let target = ::ezy_core::kernel::row_mut::<
                16usize,
                T,
            >(&mut store.right, k + 2usize);
            target[0usize] = lambda_0;
            target[1usize] = lambda_1;
            target[2usize] = lambda_2;
            target[3usize] = lambda_2;
            target[4usize] = lambda_0;
            target[5usize] = lambda_1;
            target[6usize] = sum_22;
            target[7usize] = sum_34;
            target[8usize] = value_56;
            target[9usize] = value_57;
            target[10usize] = product_43;
            target[11usize] = product_44;
        }
    }
}
