//! The driven roller averaged over one period of the torque.

use ezy_core::model::Scene;
use ezy_core::record::find_name;

use super::error::StudyError;
use super::parts::geometric;
use crate::ezy_roller::Driven;

/// The mean power of M0 cos(ωt) at speed v, by linearisation about the folded, straight configuration: with
/// L = a + b, l = c + d, J1 = I1 + m1 a², J2 = I2 + m2 c²,
///
/// P(v) = (M0²/2) ((L − l)²/l) B v ω² / ((D v² − A ω²)² + B² v² ω²)
#[derive(Debug, Clone, Copy)]
pub struct Averaged {
    /// J1 l + J2 L²/l, kg m³.
    a: f64,
    /// J1 + m1 a l + (L/l)(J2 + m2 c L), kg m².
    b: f64,
    /// m1 a + m2 c L/l, kg m.
    d: f64,
    /// (M0²/2) (L − l)²/l, N² m³.
    strength: f64,
    omega: f64,
    /// m1 + m2, kg.
    pub mass: f64,
}

/// Steps of the averaged equation in ln t, and where it ends, s.
const AVERAGED_STEP: f64 = 0.05;
const AVERAGED_END_S: f64 = 1e10;

impl Averaged {
    /// For the parameters of `scene`.
    pub fn of(scene: &Driven) -> Result<Self, StudyError> {
        let value = |name: &str| -> Result<f64, StudyError> {
            let names = scene.info().parameters.iter().map(|p| p.name);
            Ok(scene.parameter(find_name("parameter", name, names)?))
        };
        let (a, b, c, d) = (value("a")?, value("b")?, value("c")?, value("d")?);
        let (m1, i1, m2, i2) = (value("m1")?, value("i1")?, value("m2")?, value("i2")?);
        let (long, short) = (a + b, c + d);
        let (j1, j2) = (i1 + m1 * a * a, i2 + m2 * c * c);
        Ok(Self {
            a: j1 * short + j2 * long * long / short,
            b: j1 + m1 * a * short + long / short * (j2 + m2 * c * long),
            d: m1 * a + m2 * c * long / short,
            strength: 0.5 * value("m0")?.powi(2) * (long - short).powi(2) / short,
            omega: value("omega")?,
            mass: m1 + m2,
        })
    }

    /// P(v), W.
    pub fn mean_power(&self, v: f64) -> f64 {
        let Self { a, b, d, strength, omega, .. } = *self;
        let w2 = omega * omega;
        strength * b * v * w2 / ((d * v * v - a * w2).powi(2) + b * b * v * v * w2)
    }

    /// 5 K/(m1 + m2) with K = lim v³ P(v).
    pub fn limit(&self) -> f64 {
        5.0 * self.strength * self.b * (self.omega / self.d).powi(2) / self.mass
    }

    /// (m1 + m2) v dv/dt = P(v) from `t`, `v` on: times and speeds.
    pub fn integrate(&self, t: f64, v: f64) -> (Vec<f64>, Vec<f64>) {
        let slope = |ln_t: f64, v: f64| ln_t.exp() * self.mean_power(v) / (self.mass * v);
        let n = ((AVERAGED_END_S / t).ln() / AVERAGED_STEP).ceil() as usize;
        let times = geometric(t, (AVERAGED_END_S / t).powf(1.0 / n as f64), n + 1);
        let mut speeds = vec![v];
        for pair in times.windows(2) {
            let (u, h) = (pair[0].ln(), (pair[1] / pair[0]).ln());
            let v = speeds[speeds.len() - 1];
            let k1 = slope(u, v);
            let k2 = slope(u + 0.5 * h, v + 0.5 * h * k1);
            let k3 = slope(u + 0.5 * h, v + 0.5 * h * k2);
            let k4 = slope(u + h, v + h * k3);
            speeds.push(v + h / 6.0 * (k1 + 2.0 * (k2 + k3) + k4));
        }
        (times, speeds)
    }
}

/// The formula of [`Averaged`].
pub const MEAN_POWER: &str = "<math display=\"block\"><mi>P</mi><mo>(</mo><mi>v</mi><mo>)</mo><mo>=</mo><mfrac><msubsup><mi>M</mi><mn>0</mn><mn>2</mn></msubsup><mn>2</mn></mfrac>\
<mfrac><msup><mrow><mo>(</mo><mi>L</mi><mo>−</mo><mi>l</mi><mo>)</mo></mrow><mn>2</mn></msup><mi>l</mi></mfrac>\
<mfrac><mrow><mi>B</mi><mi>v</mi><msup><mi>ω</mi><mn>2</mn></msup></mrow><mrow><msup><mrow><mo>(</mo><mi>D</mi><msup><mi>v</mi><mn>2</mn></msup><mo>−</mo><mi>A</mi><msup><mi>ω</mi><mn>2</mn></msup><mo>)</mo></mrow><mn>2</mn></msup>\
<mo>+</mo><msup><mi>B</mi><mn>2</mn></msup><msup><mi>v</mi><mn>2</mn></msup><msup><mi>ω</mi><mn>2</mn></msup></mrow></mfrac><mo>,</mo><mspace width=\"1em\"/><mi>L</mi><mo>=</mo><mi>a</mi><mo>+</mo><mi>b</mi><mo>,</mo><mspace width=\"0.5em\"/><mi>l</mi><mo>=</mo><mi>c</mi><mo>+</mo><mi>d</mi></math>";
