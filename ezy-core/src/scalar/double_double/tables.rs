//! Constants to their last bit.

use super::DoubleDouble;
use std::f64::consts;

/// π/2, in parts of 53 bits.
pub(super) const HALF_PI: [f64; 3] = [consts::FRAC_PI_2, 6.123233995736766e-17, -1.4973849048591698e-33];

/// ln 2, in parts of 53 bits.
pub(super) const LN_2: [f64; 3] = [consts::LN_2, 2.3190468138462996e-17, 5.707708438416212e-34];

/// π
pub(super) const PI: DoubleDouble = DoubleDouble { high: consts::PI, low: 1.2246467991473532e-16 };

/// 1/n! of n = 2, 3, … 30.
pub(super) const INVERSE_FACTORIALS: [DoubleDouble; 29] = [
    DoubleDouble { high: 0.5, low: 0.0 },
    DoubleDouble { high: 0.16666666666666666, low: 9.25185853854297e-18 },
    DoubleDouble { high: 0.041666666666666664, low: 2.3129646346357427e-18 },
    DoubleDouble { high: 0.008333333333333333, low: 1.1564823173178714e-19 },
    DoubleDouble { high: 0.001388888888888889, low: -5.300543954373577e-20 },
    DoubleDouble { high: 0.0001984126984126984, low: 1.7209558293420705e-22 },
    DoubleDouble { high: 2.48015873015873e-05, low: 2.1511947866775882e-23 },
    DoubleDouble { high: 2.7557319223985893e-06, low: -1.858393274046472e-22 },
    DoubleDouble { high: 2.755731922398589e-07, low: 2.3767714622250297e-23 },
    DoubleDouble { high: 2.505210838544172e-08, low: -1.448814070935912e-24 },
    DoubleDouble { high: 2.08767569878681e-09, low: -1.20734505911326e-25 },
    DoubleDouble { high: 1.6059043836821613e-10, low: 1.2585294588752098e-26 },
    DoubleDouble { high: 1.1470745597729725e-11, low: 2.0655512752830745e-28 },
    DoubleDouble { high: 7.647163731819816e-13, low: 7.03872877733453e-30 },
    DoubleDouble { high: 4.779477332387385e-14, low: 4.399205485834081e-31 },
    DoubleDouble { high: 2.8114572543455206e-15, low: 1.6508842730861433e-31 },
    DoubleDouble { high: 1.5619206968586225e-16, low: 1.1910679660273754e-32 },
    DoubleDouble { high: 8.22063524662433e-18, low: 2.2141894119604265e-34 },
    DoubleDouble { high: 4.110317623312165e-19, low: 1.4412973378659527e-36 },
    DoubleDouble { high: 1.9572941063391263e-20, low: -1.3643503830087908e-36 },
    DoubleDouble { high: 8.896791392450574e-22, low: -7.911402614872376e-38 },
    DoubleDouble { high: 3.868170170630684e-23, low: -8.843177655482344e-40 },
    DoubleDouble { high: 1.6117375710961184e-24, low: -3.6846573564509766e-41 },
    DoubleDouble { high: 6.446950284384474e-26, low: -1.9330404233703465e-42 },
    DoubleDouble { high: 2.4795962632247976e-27, low: -1.2953730964765229e-43 },
    DoubleDouble { high: 9.183689863795546e-29, low: 1.4303150396787322e-45 },
    DoubleDouble { high: 3.279889237069838e-30, low: 1.5117542744029879e-46 },
    DoubleDouble { high: 1.1309962886447716e-31, low: 1.0498015412959506e-47 },
    DoubleDouble { high: 3.7699876288159054e-33, low: 2.5870347832750324e-49 },
];
