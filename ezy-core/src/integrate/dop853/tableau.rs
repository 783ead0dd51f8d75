//! Coefficients of DOP853.
//!
//! Source: the program DOP853 of E. Hairer and G. Wanner, 1993 to 2009; Hairer, Nørsett, Wanner, Solving Ordinary
//! Differential Equations I (1993), II.5 and II.6.

/// Stages of a step.
pub(super) const N_STAGES: usize = 12;
/// Stages of a step with dense output: the slope at its end and three more.
pub(super) const N_STAGES_OF_DENSE_OUTPUT: usize = 16;

/// Nodes c of the stages.
pub(super) const NODES: [f64; N_STAGES_OF_DENSE_OUTPUT] = [
    0.0,
    0.05260015195876773,
    0.0789002279381516,
    0.1183503419072274,
    0.2816496580927726,
    0.3333333333333333,
    0.25,
    0.3076923076923077,
    0.6512820512820513,
    0.6,
    0.8571428571428571,
    1.0,
    1.0,
    0.1,
    0.2,
    0.7777777777777778,
];

/// Weights of sums over stages, as (stage, weight), zeros left out.
macro_rules! weights {
    ($($(#[$documentation:meta])* $name:ident: $weights:expr;)*) => {
        $($(#[$documentation])*
        pub(super) const $name: [(usize, f64); $weights.len()] = $weights;)*
    };
}
weights! {
    STAGE_2: [(0, 0.05260015195876773)];
    STAGE_3: [(0, 0.0197250569845379), (1, 0.0591751709536137)];
    STAGE_4: [(0, 0.02958758547680685), (2, 0.08876275643042054)];
    STAGE_5: [(0, 0.2413651341592667), (2, -0.8845494793282861), (3, 0.924834003261792)];
    STAGE_6: [(0, 0.037037037037037035), (3, 0.17082860872947386), (4, 0.12546768756682242)];
    STAGE_7: [(0, 0.037109375), (3, 0.17025221101954405), (4, 0.06021653898045596), (5, -0.017578125)];
    STAGE_8: [
        (0, 0.03709200011850479), (3, 0.17038392571223998), (4, 0.10726203044637328), (5, -0.015319437748624402),
        (6, 0.008273789163814023),
    ];
    STAGE_9: [
        (0, 0.6241109587160757), (3, -3.3608926294469414), (4, -0.868219346841726), (5, 27.59209969944671),
        (6, 20.154067550477894), (7, -43.48988418106996),
    ];
    STAGE_10: [
        (0, 0.47766253643826434), (3, -2.4881146199716677), (4, -0.590290826836843), (5, 21.230051448181193),
        (6, 15.279233632882423), (7, -33.28821096898486), (8, -0.020331201708508627),
    ];
    STAGE_11: [
        (0, -0.9371424300859873), (3, 5.186372428844064), (4, 1.0914373489967295), (5, -8.149787010746927),
        (6, -18.52006565999696), (7, 22.739487099350505), (8, 2.4936055526796523), (9, -3.0467644718982196),
    ];
    STAGE_12: [
        (0, 2.273310147516538), (3, -10.53449546673725), (4, -2.0008720582248625), (5, -17.9589318631188),
        (6, 27.94888452941996), (7, -2.8589982771350235), (8, -8.87285693353063), (9, 12.360567175794303),
        (10, 0.6433927460157636),
    ];
    /// The step itself.
    STEP: [
        (0, 0.054293734116568765), (5, 4.450312892752409), (6, 1.8915178993145003), (7, -5.801203960010585),
        (8, 0.3111643669578199), (9, -0.1521609496625161), (10, 0.20136540080403034), (11, 0.04471061572777259),
    ];
    DENSE_14: [
        (0, 0.056167502283047954), (6, 0.25350021021662483), (7, -0.2462390374708025), (8, -0.12419142326381637),
        (9, 0.15329179827876568), (10, 0.00820105229563469), (11, 0.007567897660545699), (12, -0.008298),
    ];
    DENSE_15: [
        (0, 0.03183464816350214), (5, 0.028300909672366776), (6, 0.053541988307438566), (7, -0.05492374857139099),
        (10, -0.00010834732869724932), (11, 0.0003825710908356584), (12, -0.00034046500868740456),
        (13, 0.1413124436746325),
    ];
    DENSE_16: [
        (0, -0.42889630158379194), (5, -4.697621415361164), (6, 7.683421196062599), (7, 4.06898981839711),
        (8, 0.3567271874552811), (12, -0.0013990241651590145), (13, 2.9475147891527724), (14, -9.15095847217987),
    ];
    /// The step less its embedded solution of order 3.
    ERROR_3: [
        (0, -0.18980075407240762), (5, 4.450312892752409), (6, 1.8915178993145003), (7, -5.801203960010585),
        (8, -0.42268232132379197), (9, -0.1521609496625161), (10, 0.20136540080403034), (11, 0.022651792198360825),
    ];
    /// The step less its embedded solution of order 5.
    ERROR_5: [
        (0, 0.01312004499419488), (5, -1.2251564463762044), (6, -0.4957589496572502), (7, 1.6643771824549864),
        (8, -0.35032884874997366), (9, 0.3341791187130175), (10, 0.08192320648511571), (11, -0.022355307863886294),
    ];
    /// Ten times the sixth divided difference of the slopes at the nodes 0, 1/4, 4/13, 1/3, 3/5, 127/195 and 6/7, with weights whose squares add up to
    /// one: of order 6 where the error of order 5 is of order 5, so that it is smaller wherever the motion is resolved. Where a step is as long as a period of a
    /// force, the other may vanish by chance (of cos ωt at ωh = 6.09 it is 1/500 of the error of the step), and this one does not.
    DIFFERENCE_6: [
        (0, 0.022358123565388573), (5, -6.070328897520148), (6, -1.873522755721526), (7, 7.644785856545327),
        (8, -0.6370729189530163), (9, 0.889561933835949), (10, 0.024218658248025673),
    ];
}

/// Weights a of the stages of a step.
pub(super) const STAGES: [&[(usize, f64)]; N_STAGES] = [
    &[],
    &STAGE_2,
    &STAGE_3,
    &STAGE_4,
    &STAGE_5,
    &STAGE_6,
    &STAGE_7,
    &STAGE_8,
    &STAGE_9,
    &STAGE_10,
    &STAGE_11,
    &STAGE_12,
];

/// Sums at the end of a step: itself, its errors of orders 5 and 3, and the sixth difference.
pub(super) const N_SUMS: usize = 4;

/// Their weights, of each stage that one of them reads.
pub(super) const AT_END: [(usize, [f64; N_SUMS]); 8] = {
    let mut all = [(0, [0.0; N_SUMS]); 8];
    let mut i = 0;
    while i < all.len() {
        let stage = STEP[i].0;
        let (five, three, six) = (of_stage(&ERROR_5, stage), of_stage(&ERROR_3, stage), of_stage(&DIFFERENCE_6, stage));
        all[i] = (stage, [STEP[i].1, five, three, six]);
        i += 1;
    }
    all
};

/// The weight of a stage, zero where it is left out.
const fn of_stage<const N: usize>(weights: &[(usize, f64); N], stage: usize) -> f64 {
    let mut i = 0;
    while i < N {
        if weights[i].0 == stage {
            return weights[i].1;
        }
        i += 1;
    }
    0.0
}

/// Weights of the four highest coefficients of the dense output.
pub(super) const DENSE: [&[(usize, f64)]; 4] = [
    &[
        (0, -8.428938276109013),
        (5, 0.5667149535193777),
        (6, -3.0689499459498917),
        (7, 2.38466765651207),
        (8, 2.117034582445028),
        (9, -0.871391583777973),
        (10, 2.2404374302607883),
        (11, 0.6315787787694688),
        (12, -0.08899033645133331),
        (13, 18.148505520854727),
        (14, -9.194632392478356),
        (15, -4.436036387594894),
    ],
    &[
        (0, 10.427508642579134),
        (5, 242.28349177525817),
        (6, 165.20045171727028),
        (7, -374.5467547226902),
        (8, -22.113666853125306),
        (9, 7.733432668472264),
        (10, -30.674084731089398),
        (11, -9.332130526430229),
        (12, 15.697238121770845),
        (13, -31.139403219565178),
        (14, -9.35292435884448),
        (15, 35.81684148639408),
    ],
    &[
        (0, 19.985053242002433),
        (5, -387.0373087493518),
        (6, -189.17813819516758),
        (7, 527.8081592054236),
        (8, -11.57390253995963),
        (9, 6.8812326946963),
        (10, -1.0006050966910838),
        (11, 0.7777137798053443),
        (12, -2.778205752353508),
        (13, -60.19669523126412),
        (14, 84.32040550667716),
        (15, 11.99229113618279),
    ],
    &[
        (0, -25.69393346270375),
        (5, -154.18974869023643),
        (6, -231.5293791760455),
        (7, 357.6391179106141),
        (8, 93.40532418362432),
        (9, -37.45832313645163),
        (10, 104.0996495089623),
        (11, 29.8402934266605),
        (12, -43.53345659001114),
        (13, 96.32455395918828),
        (14, -39.17726167561544),
        (15, -149.72683625798564),
    ],
];

/// Whether the slope of a stage counts at the end of a step, or between both ends.
pub(super) const COUNTS: [bool; N_STAGES_OF_DENSE_OUTPUT] = {
    let mut counts = [false; N_STAGES_OF_DENSE_OUTPUT];
    let mut i = 0;
    while i < AT_END.len() {
        counts[AT_END[i].0] = true;
        i += 1;
    }
    let mut stage = N_STAGES;
    while stage < counts.len() {
        counts[stage] = true;
        stage += 1;
    }
    counts
};

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cross_stages_that_count_are_those_with_weights() {
        let sums = [&STEP[..], &ERROR_5, &ERROR_3, &DIFFERENCE_6].into_iter().chain(DENSE);
        let has_weight = sums.flatten().fold([false; N_STAGES_OF_DENSE_OUTPUT], |mut all, (stage, _)| {
            all[*stage] = true;
            all
        });
        assert_eq!(COUNTS, has_weight);
    }

    #[test]
    fn analytic_difference_vanishes_for_powers_up_to_five() {
        let of_power = |k: i32| DIFFERENCE_6.iter().map(|&(stage, weight)| weight * NODES[stage].powi(k)).sum::<f64>();
        // weights of up to 8 with terms of one: rounding
        (0..6).for_each(|k| assert!(of_power(k).abs() < 1e-14, "{k}: {:e}", of_power(k)));
        // the sixth difference of c⁶ is 1, over the root of the sum of squares of its weights
        let nodes = [0.0, 1.0 / 4.0, 4.0 / 13.0, 1.0 / 3.0, 3.0 / 5.0, 127.0 / 195.0, 6.0 / 7.0];
        let weight = |i: usize| nodes.iter().filter(|c| **c != nodes[i]).map(|c| 1.0 / (nodes[i] - c)).product::<f64>();
        let norm = (0..nodes.len()).map(|i| weight(i).powi(2)).sum::<f64>().sqrt();
        assert!((of_power(6) * norm / 10.0 - 1.0).abs() < 1e-9, "{:e}", of_power(6) * norm);
    }
}
