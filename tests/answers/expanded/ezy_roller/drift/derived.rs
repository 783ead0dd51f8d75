#[automatically_derived]
impl ezy::Derived for Drift {
    fn slope_places(&self) -> ::core::option::Option<ezy::SlopePlaces> {
        ::core::option::Option::Some(ezy::SlopePlaces {
            by_q: ::std::vec![
                (0usize, 2usize), (1usize, 2usize), (2usize, 2usize), (3usize, 5usize),
                (4usize, 5usize), (5usize, 5usize), (6usize, 2usize), (6usize, 5usize),
                (7usize, 2usize), (7usize, 5usize), (8usize, 5usize)
            ],
            by_v: ::std::vec![
                (0usize, 0usize), (0usize, 1usize), (0usize, 2usize), (1usize, 0usize),
                (1usize, 1usize), (1usize, 2usize), (2usize, 0usize), (2usize, 1usize),
                (2usize, 2usize), (6usize, 2usize), (6usize, 5usize), (7usize, 2usize),
                (7usize, 5usize), (8usize, 3usize), (8usize, 4usize), (8usize, 5usize)
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
        let c = ezy::array::<40usize, f64>(c);
        let q = ezy::array::<6usize, f64>(q);
        let v = ezy::array::<6usize, f64>(v);
        let a = ezy::array::<6usize, f64>(a);
        let lambda = ezy::array::<3usize, f64>(lambda);
        let by_q = ezy::array_mut::<11usize, f64>(by_q);
        let by_v = ezy::array_mut::<16usize, f64>(by_v);
        let seat_vx = v[0usize];
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = f64::sin_cos(seat_phi);
        let product_5 = seat_vx * sin_seat_phi;
        let seat_vy = v[1usize];
        let product_8 = seat_vy * cos_seat_phi;
        let difference_9 = product_8 - product_5;
        let product_10 = cos_seat_phi * difference_9;
        let difference_11 = product_10 - seat_vy;
        let product_12 = seat_vx * cos_seat_phi;
        let product_13 = sin_seat_phi * seat_vy;
        let sum_14 = product_12 + product_13;
        let product_15 = sum_14 * sum_14;
        let sum_17 = product_15 + c[3usize];
        let value_18 = f64::sqrt(sum_17);
        let product_19 = difference_11 * value_18;
        let seat_omega = v[2usize];
        let product_22 = c[2usize] * seat_omega;
        let sum_23 = product_5 + product_22;
        let difference_24 = sum_23 - product_8;
        let quotient_25 = difference_9 / value_18;
        let product_26 = sum_14 * quotient_25;
        let product_27 = difference_24 * product_26;
        let product_28 = sin_seat_phi * product_27;
        let sum_29 = product_19 + product_28;
        let product_30 = difference_24 * difference_24;
        let product_31 = value_18 * value_18;
        let sum_32 = product_30 + product_31;
        let quotient_33 = sum_29 / sum_32;
        let value_34 = -difference_24;
        let value_35 = f64::atan2(value_34, value_18);
        let product_36 = cos_seat_phi * value_35;
        let sum_37 = quotient_33 + product_36;
        let product_39 = sum_37 * c[1usize];
        let product_41 = seat_omega * c[0usize];
        let product_42 = cos_seat_phi * product_41;
        let difference_43 = product_39 - product_42;
        let product_44 = sum_14 * value_18;
        let difference_45 = product_44 - product_27;
        let quotient_46 = difference_45 / sum_32;
        let product_47 = cos_seat_phi * quotient_46;
        let product_48 = sin_seat_phi * value_35;
        let sum_49 = product_47 + product_48;
        let product_50 = c[1usize] * sum_49;
        let product_51 = sin_seat_phi * product_41;
        let difference_52 = product_50 - product_51;
        let product_54 = quotient_46 * c[8usize];
        let multiplier_0 = lambda[0usize];
        let product_56 = cos_seat_phi * multiplier_0;
        let multiplier_1 = lambda[1usize];
        let product_58 = sin_seat_phi * multiplier_1;
        let sum_59 = product_56 + product_58;
        let product_61 = sum_59 * c[16usize];
        let difference_62 = product_61 - product_54;
        let product_63 = sum_14 * c[0usize];
        let difference_64 = difference_62 - product_63;
        let multiplier_2 = lambda[2usize];
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = f64::sin_cos(bar_phi);
        let product_68 = multiplier_2 * cos_bar_phi;
        let product_70 = multiplier_2 * sin_bar_phi;
        let product_71 = multiplier_0 * cos_bar_phi;
        let product_72 = multiplier_1 * sin_bar_phi;
        let sum_73 = product_71 + product_72;
        let product_75 = sum_73 * c[17usize];
        let product_76 = seat_omega * seat_omega;
        let product_77 = sin_seat_phi * product_76;
        let acceleration_2 = a[2usize];
        let product_79 = cos_seat_phi * acceleration_2;
        let difference_80 = product_79 - product_77;
        let product_81 = c[16usize] * difference_80;
        let bar_omega = v[5usize];
        let product_83 = bar_omega * bar_omega;
        let product_84 = sin_bar_phi * product_83;
        let acceleration_5 = a[5usize];
        let product_86 = cos_bar_phi * acceleration_5;
        let difference_87 = product_86 - product_84;
        let product_88 = c[17usize] * difference_87;
        let product_89 = cos_seat_phi * product_76;
        let product_90 = sin_seat_phi * acceleration_2;
        let sum_91 = product_89 + product_90;
        let product_92 = c[16usize] * sum_91;
        let product_93 = cos_bar_phi * product_83;
        let product_94 = sin_bar_phi * acceleration_5;
        let sum_95 = product_93 + product_94;
        let product_96 = c[17usize] * sum_95;
        let bar_vx = v[3usize];
        let product_98 = bar_omega * bar_vx;
        let acceleration_4 = a[4usize];
        let difference_100 = acceleration_4 - product_98;
        let product_101 = sin_bar_phi * difference_100;
        let bar_vy = v[4usize];
        let product_103 = bar_omega * bar_vy;
        let acceleration_3 = a[3usize];
        let sum_105 = product_103 + acceleration_3;
        let product_106 = cos_bar_phi * sum_105;
        let sum_107 = product_101 + product_106;
        let product_108 = cos_seat_phi * sum_14;
        let difference_109 = seat_vx - product_108;
        let product_110 = c[1usize] * difference_109;
        let product_111 = seat_omega * c[8usize];
        let product_112 = sin_seat_phi * product_111;
        let sum_113 = product_110 + product_112;
        let quotient_114 = sum_113 / value_18;
        let product_115 = sum_14 * quotient_114;
        let product_116 = value_18 * c[1usize];
        let product_117 = cos_seat_phi * product_116;
        let sum_118 = product_115 + product_117;
        let product_119 = cos_seat_phi * sum_118;
        let difference_120 = product_119 - product_116;
        let quotient_121 = difference_120 / sum_32;
        let difference_123 = quotient_121 - c[4usize];
        let product_124 = cos_seat_phi * difference_11;
        let sum_125 = product_5 + product_124;
        let product_126 = c[1usize] * sum_125;
        let product_127 = cos_seat_phi * cos_seat_phi;
        let difference_128 = 1f64 - product_127;
        let product_129 = seat_omega * difference_128;
        let product_130 = c[8usize] * product_129;
        let sum_131 = product_126 + product_130;
        let quotient_132 = sum_131 / value_18;
        let product_133 = sum_14 * quotient_132;
        let product_134 = sin_seat_phi * product_116;
        let product_135 = cos_seat_phi * product_134;
        let sum_136 = product_133 + product_135;
        let quotient_137 = sum_136 / sum_32;
        let product_138 = value_18 * c[8usize];
        let quotient_139 = product_138 / sum_32;
        let sum_140 = c[0usize] + quotient_139;
        let product_141 = sin_seat_phi * sum_140;
        let product_142 = difference_9 * c[1usize];
        let difference_143 = product_142 - product_111;
        let quotient_144 = difference_143 / value_18;
        let product_145 = sum_14 * quotient_144;
        let product_146 = cos_seat_phi * product_145;
        let sum_147 = product_134 + product_146;
        let quotient_148 = sum_147 / sum_32;
        let product_149 = cos_seat_phi * quotient_148;
        let quotient_150 = sum_118 / sum_32;
        let product_151 = cos_seat_phi * quotient_150;
        let sum_152 = c[4usize] + product_151;
        let product_153 = cos_seat_phi * sum_140;
        let product_154 = difference_9 * c[8usize];
        let product_156 = seat_omega * c[37usize];
        let difference_157 = product_156 - product_154;
        let quotient_158 = difference_157 / value_18;
        let product_159 = sum_14 * quotient_158;
        let product_160 = cos_seat_phi * product_159;
        let product_161 = sin_seat_phi * product_138;
        let difference_162 = product_160 - product_161;
        let quotient_163 = difference_162 / sum_32;
        let product_164 = sin_seat_phi * c[0usize];
        let difference_165 = quotient_163 - product_164;
        let product_166 = c[8usize] * difference_109;
        let product_167 = sin_seat_phi * product_156;
        let sum_168 = product_166 + product_167;
        let quotient_169 = sum_168 / value_18;
        let product_170 = sum_14 * quotient_169;
        let product_171 = cos_seat_phi * product_138;
        let sum_172 = product_170 + product_171;
        let quotient_173 = sum_172 / sum_32;
        let product_174 = cos_seat_phi * c[0usize];
        let sum_175 = quotient_173 + product_174;
        let product_176 = value_18 * c[37usize];
        let quotient_177 = product_176 / sum_32;
        let sum_179 = quotient_177 + c[5usize];
        let product_181 = seat_omega * c[38usize];
        let product_182 = cos_seat_phi * product_181;
        let product_184 = bar_omega * c[39usize];
        let product_185 = cos_bar_phi * product_184;
        let product_186 = sin_seat_phi * product_181;
        let product_187 = sin_bar_phi * product_184;
        let product_188 = cos_bar_phi * bar_omega;
        let product_189 = sin_bar_phi * bar_omega;
        let product_190 = cos_bar_phi * bar_vx;
        let product_191 = sin_bar_phi * bar_vy;
        let sum_192 = product_190 + product_191;
        let value_193 = -product_141;
        let value_194 = -sum_152;
        let value_195 = -sum_179;
        by_q[0usize] = difference_43;
        by_q[1usize] = difference_52;
        by_q[2usize] = difference_64;
        by_q[3usize] = product_68;
        by_q[4usize] = product_70;
        by_q[5usize] = product_75;
        by_q[6usize] = product_81;
        by_q[7usize] = product_88;
        by_q[8usize] = product_92;
        by_q[9usize] = product_96;
        by_q[10usize] = sum_107;
        by_v[0usize] = difference_123;
        by_v[1usize] = quotient_137;
        by_v[2usize] = value_193;
        by_v[3usize] = product_149;
        by_v[4usize] = value_194;
        by_v[5usize] = product_153;
        by_v[6usize] = difference_165;
        by_v[7usize] = sum_175;
        by_v[8usize] = value_195;
        by_v[9usize] = product_182;
        by_v[10usize] = product_185;
        by_v[11usize] = product_186;
        by_v[12usize] = product_187;
        by_v[13usize] = product_188;
        by_v[14usize] = product_189;
        by_v[15usize] = sum_192;
    }
    fn series(&self) -> ::core::option::Option<&dyn ezy::Series<f64>> {
        ::core::option::Option::Some(self)
    }
    fn precise(&self) -> ::core::option::Option<&dyn ezy::PreciseScene> {
        ::core::option::Option::Some(self)
    }
}
