//! Sine and cosine without branches, so that lanes go through them together.
//!
//! # Source
//! Reduction by π/2 in three parts: Cody, Waite, Software Manual for the Elementary Functions (1980). Polynomials: fdlibm,
//! `k_sin.c` and `k_cos.c` (Sun Microsystems, 1993); summed in pairs: Estrin, Organization of computer systems (1960).

use crate::scalar::Scalar;
use std::f64::consts::FRAC_2_PI;

/// Larger arguments go to the system's functions: multiples of π/2 up to here have no rounding in the first two parts.
const LARGEST: f64 = 1e6;

/// π/2 in parts of 33 bits, the last one whole.
const HALF_PI: [f64; 3] = [1.570_796_326_734_125_6, 6.077_100_506_303_966e-11, 2.022_266_248_795_950_6e-21];

/// Added to a number below 2⁵¹ it leaves the nearest whole number in the last bits.
const ROUNDING: f64 = 6_755_399_441_055_744.0; // 1.5 · 2⁵²

const SIN: [f64; 6] = [
    -1.666_666_666_666_663_2e-1,
    8.333_333_333_322_49e-3,
    -1.984_126_982_985_795e-4,
    2.755_731_370_707_006_8e-6,
    -2.505_076_025_340_686_3e-8,
    1.589_690_995_211_55e-10,
];

const COS: [f64; 6] = [
    4.166_666_666_666_66e-2,
    -1.388_888_888_887_411e-3,
    2.480_158_728_947_673e-5,
    -2.755_731_435_139_066_3e-7,
    2.087_572_321_298_175e-9,
    -1.135_964_755_778_819_5e-11,
];

#[inline(always)]
pub(super) fn sin_cos<const L: usize>(x: &[f64; L]) -> ([f64; L], [f64; L]) {
    let small = x.iter().fold(true, |all, x| all & (x.abs() <= LARGEST));
    let (mut sin, mut cos) = ([0.0; L], [0.0; L]);
    for i in 0..L {
        (sin[i], cos[i]) = one(x[i]);
    }
    if !small {
        let (mut of_sin, mut of_cos) = ([0.0; L], [0.0; L]);
        by_library(x, &mut of_sin, &mut of_cos);
        for i in 0..L {
            (sin[i], cos[i]) = (of_sin[i], of_cos[i]);
        }
    }
    (sin, cos)
}

/// The system's functions, apart from numbers in registers, which their calls would bring to memory.
#[cold]
#[inline(never)]
fn by_library<const L: usize>(x: &[f64; L], sin: &mut [f64; L], cos: &mut [f64; L]) {
    for i in 0..L {
        (sin[i], cos[i]) = x[i].sin_cos();
    }
}

#[inline(always)]
fn one(x: f64) -> (f64, f64) {
    let shifted = x.fused(FRAC_2_PI, ROUNDING);
    let quarters = shifted.to_bits();
    let n = shifted - ROUNDING;
    // the angle that is left is y + tail
    let first = x - n * HALF_PI[0];
    let second = n * HALF_PI[1];
    let third = first - second;
    let left = (first - third) - second;
    let last = n * HALF_PI[2];
    let y = third - last;
    let tail = ((third - y) - last) + left;
    let z = y * y;
    let (square, cube) = (z * z, z * y);
    // terms in pairs, and what does not wait for their sum before it: whoever asks waits for the last of these operations
    let of_sin = SIN[2].fused(z, SIN[1]) + square * SIN[5].fused(square, SIN[4].fused(z, SIN[3]));
    let sin = y - (((z * (0.5 * tail) - tail) - cube * SIN[0]) - (z * cube) * of_sin);
    let of_cos = COS[1].fused(z, COS[0]) + square * COS[5].fused(z, COS[4]).fused(square, COS[3].fused(z, COS[2]));
    let half = 0.5 * z;
    let whole = 1.0 - half;
    let cos = whole + ((((1.0 - whole) - half) - y * tail) + square * of_cos);
    // an odd number of quarter turns swaps them; the sign changes after two, of the cosine one earlier
    let swap = 0_u64.wrapping_sub(quarters & 1);
    let (sin, cos) = (sin.to_bits(), cos.to_bits());
    let swapped = (sin ^ cos) & swap;
    let sign = |quarters: u64| (quarters & 2) << 62;
    (f64::from_bits((sin ^ swapped) ^ sign(quarters)), f64::from_bits((cos ^ swapped) ^ sign(quarters.wrapping_add(1))))
}
