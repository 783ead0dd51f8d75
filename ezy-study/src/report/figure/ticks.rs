//! Where an axis has ticks, and what stands at them.

use crate::report::typeset::power_of_ten;

/// The ticks of an axis.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Ticks {
    /// Values with a label, ascending.
    pub major: Vec<(f64, String)>,
    /// Values with a short tick alone.
    pub minor: Vec<f64>,
    /// What the labels are to be multiplied by, or what is to be added to them: stands at the end of the axis.
    pub scale: Option<String>,
}

/// Labels with a power of ten outside of these bounds have it at the end of the axis.
const PLAIN_EXPONENTS: std::ops::RangeInclusive<i32> = -3..=4;

/// Digits of a label; a narrower range shows what exceeds its beginning.
const LABEL_DIGITS: i32 = 6;

/// Ticks of a linear axis from `low` to `high`: at 1, 2 or 5 times a power of ten, `n` of them at most.
pub(super) fn linear([low, high]: [f64; 2], n: usize) -> Ticks {
    let step = round_step((high - low) / n.max(2) as f64);
    let [first, last] = [(low / step - EDGE).ceil() as i64, (high / step + EDGE).floor() as i64];
    let values: Vec<f64> = (first..=last).map(|k| k as f64 * step).collect();
    let largest = low.abs().max(high.abs());
    let is_narrow = exponent(largest) - exponent(step) >= LABEL_DIGITS;
    // a multiple of the power of ten above the range, so that the offset is short
    let unit = 10f64.powi(exponent(high - low) + 1);
    let offset = if is_narrow { (low / unit).floor() * unit } else { 0.0 };
    let shown = |value: f64| value - offset;
    let power = exponent(values.iter().fold(step, |most, value| most.max(shown(*value).abs())));
    let power = if PLAIN_EXPONENTS.contains(&power) { 0 } else { power };
    let decimals = (power - exponent(step)).max(0) as usize;
    let label = |value: f64| decimal(shown(value) / 10f64.powi(power), decimals);
    let factor = (power != 0).then(|| format!("×{}", power_of_ten(power)));
    let added = (offset != 0.0).then(|| {
        let decimals = (-exponent(unit)).max(0) as usize;
        format!("{}{}", if offset > 0.0 { "+" } else { "" }, decimal(offset, decimals))
    });
    let scale = [factor, added].into_iter().flatten().collect::<Vec<_>>().join("  ");
    Ticks {
        major: values.into_iter().map(|value| (value, label(value))).collect(),
        minor: Vec::new(),
        scale: (!scale.is_empty()).then_some(scale),
    }
}

/// Part of a step by which a limit may miss its tick for rounding.
const EDGE: f64 = 1e-6;

/// The least of 1, 2 and 5 times a power of ten that is not below `step`.
pub(super) fn round_step(step: f64) -> f64 {
    let power = 10f64.powi(exponent(step));
    let factor = [1.0, 2.0, 5.0, 10.0].into_iter().find(|factor| factor * power >= step * (1.0 - EDGE)).unwrap_or(10.0);
    factor * power
}

/// Ticks of a logarithmic axis between limits that [`log_limits`] made: at powers of ten, not more than `n`, and at both ends.
pub(super) fn logarithmic([low, high]: [f64; 2], n: usize) -> Ticks {
    let [first, last] = [(low.log10() - EDGE).ceil() as i32, (high.log10() + EDGE).floor() as i32];
    let every = ((last - first) as usize).div_ceil(n.max(2)).max(1);
    let is_plain = low >= LEAST_PLAIN && high <= MOST_PLAIN;
    let decades = (first..=last).step_by(every).map(|power| 10f64.powi(power));
    let mut labelled: Vec<f64> = decades.collect();
    // far enough from its neighbours for two labels side by side
    let least = FREE_PART * (high / low).log10() / n.max(2) as f64;
    for end in [low, high] {
        let is_free = labelled.iter().all(|known| (end / known).log10().abs() > least);
        if is_free {
            labelled.push(end);
        }
    }
    labelled.sort_by(f64::total_cmp);
    let minor = (first - 1..=last).flat_map(|power| (1..10).map(move |k| f64::from(k) * 10f64.powi(power)));
    let is_minor = |value: &f64| {
        let is_within = *value >= low * (1.0 - EDGE) && *value <= high * (1.0 + EDGE);
        let is_decade = value.log10().fract().abs() < EDGE;
        // every decade, and between decades where they are wide
        is_within && (is_decade || every == 1) && labelled.iter().all(|known| (known / value - 1.0).abs() > EDGE)
    };
    Ticks {
        minor: minor.filter(is_minor).collect(),
        major: labelled.iter().map(|value| (*value, log_label(*value, is_plain))).collect(),
        scale: None,
    }
}

/// Part of the least distance of two labels that an end has from its neighbour to have one, too.
const FREE_PART: f64 = 0.7;

/// Between these limits labels of a logarithmic axis are written without powers.
const LEAST_PLAIN: f64 = 0.001;
const MOST_PLAIN: f64 = 10_000.0;

/// The next of 1, 2 and 5 times a power of ten below `low` and above `high`.
pub(super) fn log_limits([low, high]: [f64; 2]) -> [f64; 2] {
    let above = round_step(high);
    let below = 1.0 / round_step(1.0 / low);
    // of 1/(2·10ⁿ) and 1/(5·10ⁿ) rounding is taken away
    let below = 10f64.powi(exponent(below)) * (below / 10f64.powi(exponent(below))).round();
    if above > below { [below, above] } else { [below / 10.0, above * 10.0] }
}

fn log_label(value: f64, is_plain: bool) -> String {
    let power = exponent(value);
    let factor = (value / 10f64.powi(power)).round() as i64;
    match (is_plain, factor) {
        (true, _) => decimal(value, (-power).max(0) as usize),
        (false, 1) => power_of_ten(power),
        (false, _) => format!("{factor}·{}", power_of_ten(power)),
    }
}

/// The power of ten of the first digit.
fn exponent(value: f64) -> i32 {
    (value.abs().log10() + 1e-9).floor() as i32
}

/// A number with a proper minus sign; what rounds to zero has none.
fn decimal(value: f64, decimals: usize) -> String {
    crate::report::table::fixed(value, decimals).replace('-', "−")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(ticks: &Ticks) -> Vec<&str> {
        ticks.major.iter().map(|(_, label)| label.as_str()).collect()
    }

    #[test]
    fn analytic_labels_of_a_linear_axis_have_the_decimals_of_its_step() {
        assert_eq!(labels(&linear([0.0, 1.0], 5)), ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"]);
        assert_eq!(labels(&linear([-2.1, 2.1], 5)), ["−2", "−1", "0", "1", "2"]);
        assert_eq!(labels(&linear([0.0, 60.0], 6)), ["0", "10", "20", "30", "40", "50", "60"]);
        assert_eq!(labels(&linear([-0.3, 0.1], 4)), ["−0.3", "−0.2", "−0.1", "0.0", "0.1"]);
    }

    #[test]
    fn analytic_small_numbers_have_their_power_at_the_end_of_the_axis() {
        let ticks = linear([-3e-7, 2e-7], 5);
        assert_eq!((labels(&ticks), ticks.scale.as_deref()), (vec!["−3", "−2", "−1", "0", "1", "2"], Some("×10⁻⁷")));
    }

    #[test]
    fn analytic_narrow_range_shows_what_exceeds_its_beginning() {
        let ticks = linear([12.9651773, 12.9651778], 5);
        assert_eq!(ticks.scale.as_deref(), Some("×10⁻⁷  +12.965177"));
        assert_eq!(labels(&ticks), ["3", "4", "5", "6", "7", "8"]);
    }

    #[test]
    fn analytic_logarithmic_axis_has_labels_at_both_ends() {
        let limits = log_limits([3.1e-9, 4.4e-2]);
        assert_eq!(
            labels(&logarithmic(limits, 10)),
            ["2·10⁻⁹", "10⁻⁸", "10⁻⁷", "10⁻⁶", "10⁻⁵", "10⁻⁴", "10⁻³", "10⁻²", "5·10⁻²"]
        );
        assert_eq!(labels(&logarithmic(log_limits([0.013, 0.4]), 10)), ["0.01", "0.1", "0.5"]);
        let ends = |low, high| log_limits([low, high]).map(|x| format!("{x:.0e}"));
        assert_eq!(ends(1.0, 1000.0), ["1e0", "1e3"]);
        assert_eq!(ends(1e-15, 3e-15), ["1e-15", "5e-15"]);
    }

    #[test]
    fn invariant_ticks_of_random_ranges_are_few_ascending_within_and_told_apart() {
        let mut seed = 1_u64;
        let mut random = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 11) as f64 / (1_u64 << 53) as f64
        };
        for _ in 0..2000 {
            let span = 10f64.powf(40.0 * random() - 20.0);
            let low = (random() - 0.5) * span * 10f64.powf(5.0 * random());
            let ticks = linear([low, low + span], 6);
            let n = ticks.major.len();
            assert!((2..=7).contains(&n), "{n} ticks from {low} over {span}");
            for pair in ticks.major.windows(2) {
                assert!(pair[0].0 < pair[1].0 && pair[0].1 != pair[1].1, "{pair:?} from {low} over {span}");
            }
            assert!(ticks.major.iter().all(|(value, _)| *value >= low - 1e-5 * span && *value <= low + 1.00001 * span));
        }
    }
}
