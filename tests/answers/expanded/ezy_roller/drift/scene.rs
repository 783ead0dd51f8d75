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
        let c = ::ezy_core::kernel::array::<40usize, f64>(c);
        let q = ::ezy_core::kernel::array::<6usize, f64>(q);
        let v = ::ezy_core::kernel::array::<6usize, f64>(v);
        let lambda = ::ezy_core::kernel::array::<3usize, f64>(lambda);
        let out = ::ezy_core::kernel::array_mut::<3usize, f64>(out);
        let seat_omega = v[2usize];
        let bar_omega = v[5usize];
        let difference_4 = seat_omega - bar_omega;
        let c7_t = c[7usize] * t;
        let cos_7 = f64::cos(c7_t);
        let difference_4_cos_7 = difference_4 * cos_7;
        let difference_4_cos_7_c6 = difference_4_cos_7 * c[6usize];
        let seat_vx = v[0usize];
        let seat_vx_seat_vx = seat_vx * seat_vx;
        let seat_vy = v[1usize];
        let seat_vy_seat_vy = seat_vy * seat_vy;
        let sum_16 = seat_vx_seat_vx + seat_vy_seat_vy;
        let sum_16_c4 = sum_16 * c[4usize];
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = f64::sin_cos(seat_phi);
        let seat_vx_sin_seat_phi = seat_vx * sin_seat_phi;
        let seat_vy_cos_seat_phi = seat_vy * cos_seat_phi;
        let difference_24 = seat_vx_sin_seat_phi - seat_vy_cos_seat_phi;
        let difference_24_c35 = difference_24 * c[35usize];
        let seat_omega_c5 = seat_omega * c[5usize];
        let difference_29 = difference_24_c35 - seat_omega_c5;
        let seat_omega_difference_29 = seat_omega * difference_29;
        let difference_31 = seat_omega_difference_29 - sum_16_c4;
        let difference_24_c1 = difference_24 * c[1usize];
        let seat_omega_c8 = seat_omega * c[8usize];
        let sum_36 = difference_24_c1 + seat_omega_c8;
        let seat_omega_c2 = seat_omega * c[2usize];
        let sum_39 = seat_vx_sin_seat_phi + seat_omega_c2;
        let difference_40 = seat_vy_cos_seat_phi - sum_39;
        let seat_vx_cos_seat_phi = seat_vx * cos_seat_phi;
        let seat_vy_sin_seat_phi = seat_vy * sin_seat_phi;
        let sum_43 = seat_vx_cos_seat_phi + seat_vy_sin_seat_phi;
        let sum_43_sum_43 = sum_43 * sum_43;
        let sum_46 = sum_43_sum_43 + c[3usize];
        let value_47 = f64::sqrt(sum_46);
        let value_48 = f64::atan2(difference_40, value_47);
        let sum_36_value_48 = sum_36 * value_48;
        out[0usize] = difference_4_cos_7_c6;
        out[1usize] = difference_31;
        out[2usize] = sum_36_value_48;
    }
    fn points(&self, c: &[f64], t: f64, q: &[f64], out: &mut [f64]) {
        let c = ::ezy_core::kernel::array::<40usize, f64>(c);
        let q = ::ezy_core::kernel::array::<6usize, f64>(q);
        let out = ::ezy_core::kernel::array_mut::<6usize, f64>(out);
        let seat_x = q[0usize];
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = f64::sin_cos(seat_phi);
        let c2_cos_seat_phi = c[2usize] * cos_seat_phi;
        let difference_7 = seat_x - c2_cos_seat_phi;
        let seat_y = q[1usize];
        let c2_sin_seat_phi = c[2usize] * sin_seat_phi;
        let difference_11 = seat_y - c2_sin_seat_phi;
        let bar_x = q[3usize];
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = f64::sin_cos(bar_phi);
        let c34_cos_bar_phi = c[34usize] * cos_bar_phi;
        let sum_17 = bar_x + c34_cos_bar_phi;
        let bar_y = q[4usize];
        let c34_sin_bar_phi = c[34usize] * sin_bar_phi;
        let sum_21 = bar_y + c34_sin_bar_phi;
        let cos_seat_phi_c16 = cos_seat_phi * c[16usize];
        let sum_24 = seat_x + cos_seat_phi_c16;
        let sin_seat_phi_c16 = sin_seat_phi * c[16usize];
        let sum_26 = seat_y + sin_seat_phi_c16;
        out[0usize] = difference_7;
        out[1usize] = difference_11;
        out[2usize] = sum_17;
        out[3usize] = sum_21;
        out[4usize] = sum_24;
        out[5usize] = sum_26;
    }
    fn outputs(&self, c: &[f64], t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
        let c = ::ezy_core::kernel::array::<40usize, f64>(c);
        let q = ::ezy_core::kernel::array::<6usize, f64>(q);
        let v = ::ezy_core::kernel::array::<6usize, f64>(v);
        let out = ::ezy_core::kernel::array_mut::<0usize, f64>(out);
    }
    fn potential_energy(&self, c: &[f64], t: f64, q: &[f64]) -> f64 {
        0f64
    }
    fn start(&self, c: &[f64], start: &mut ::ezy_core::model::Start) {
        let c = ::ezy_core::kernel::array::<40usize, f64>(c);
        start.give_position(0usize, 0f64);
        start.give_position(1usize, 0f64);
        start.give_position(2usize, 0f64);
        start.give_position(5usize, c[36usize]);
    }
    fn slope_places(&self) -> ::core::option::Option<::ezy_core::model::SlopePlaces> {
        ::core::option::Option::Some(::ezy_core::model::SlopePlaces {
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
        let c = ::ezy_core::kernel::array::<40usize, f64>(c);
        let q = ::ezy_core::kernel::array::<6usize, f64>(q);
        let v = ::ezy_core::kernel::array::<6usize, f64>(v);
        let a = ::ezy_core::kernel::array::<6usize, f64>(a);
        let lambda = ::ezy_core::kernel::array::<3usize, f64>(lambda);
        let by_q = ::ezy_core::kernel::array_mut::<11usize, f64>(by_q);
        let by_v = ::ezy_core::kernel::array_mut::<16usize, f64>(by_v);
        let seat_vx = v[0usize];
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = f64::sin_cos(seat_phi);
        let seat_vx_sin_seat_phi = seat_vx * sin_seat_phi;
        let seat_vy = v[1usize];
        let seat_vy_cos_seat_phi = seat_vy * cos_seat_phi;
        let difference_9 = seat_vy_cos_seat_phi - seat_vx_sin_seat_phi;
        let product_10 = cos_seat_phi * difference_9;
        let difference_11 = product_10 - seat_vy;
        let seat_vx_cos_seat_phi = seat_vx * cos_seat_phi;
        let sin_seat_phi_seat_vy = sin_seat_phi * seat_vy;
        let sum_14 = seat_vx_cos_seat_phi + sin_seat_phi_seat_vy;
        let sum_14_sum_14 = sum_14 * sum_14;
        let sum_17 = sum_14_sum_14 + c[3usize];
        let value_18 = f64::sqrt(sum_17);
        let difference_11_value_18 = difference_11 * value_18;
        let seat_omega = v[2usize];
        let c2_seat_omega = c[2usize] * seat_omega;
        let sum_23 = seat_vx_sin_seat_phi + c2_seat_omega;
        let difference_24 = sum_23 - seat_vy_cos_seat_phi;
        let quotient_25 = difference_9 / value_18;
        let sum_14_quotient_25 = sum_14 * quotient_25;
        let product_27 = difference_24 * sum_14_quotient_25;
        let sin_seat_phi_product_27 = sin_seat_phi * product_27;
        let sum_29 = difference_11_value_18 + sin_seat_phi_product_27;
        let product_30 = difference_24 * difference_24;
        let value_18_value_18 = value_18 * value_18;
        let sum_32 = product_30 + value_18_value_18;
        let quotient_33 = sum_29 / sum_32;
        let value_34 = -difference_24;
        let value_35 = f64::atan2(value_34, value_18);
        let cos_seat_phi_value_35 = cos_seat_phi * value_35;
        let sum_37 = quotient_33 + cos_seat_phi_value_35;
        let sum_37_c1 = sum_37 * c[1usize];
        let seat_omega_c0 = seat_omega * c[0usize];
        let product_42 = cos_seat_phi * seat_omega_c0;
        let difference_43 = sum_37_c1 - product_42;
        let sum_14_value_18 = sum_14 * value_18;
        let difference_45 = sum_14_value_18 - product_27;
        let quotient_46 = difference_45 / sum_32;
        let cos_seat_phi_quotient_46 = cos_seat_phi * quotient_46;
        let sin_seat_phi_value_35 = sin_seat_phi * value_35;
        let sum_49 = cos_seat_phi_quotient_46 + sin_seat_phi_value_35;
        let c1_sum_49 = c[1usize] * sum_49;
        let product_51 = sin_seat_phi * seat_omega_c0;
        let difference_52 = c1_sum_49 - product_51;
        let quotient_46_c8 = quotient_46 * c[8usize];
        let multiplier_0 = lambda[0usize];
        let product_56 = cos_seat_phi * multiplier_0;
        let multiplier_1 = lambda[1usize];
        let product_58 = sin_seat_phi * multiplier_1;
        let sum_59 = product_56 + product_58;
        let sum_59_c16 = sum_59 * c[16usize];
        let difference_62 = sum_59_c16 - quotient_46_c8;
        let sum_14_c0 = sum_14 * c[0usize];
        let difference_64 = difference_62 - sum_14_c0;
        let multiplier_2 = lambda[2usize];
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = f64::sin_cos(bar_phi);
        let multiplier_2_cos_bar_phi = multiplier_2 * cos_bar_phi;
        let multiplier_2_sin_bar_phi = multiplier_2 * sin_bar_phi;
        let multiplier_0_cos_bar_phi = multiplier_0 * cos_bar_phi;
        let multiplier_1_sin_bar_phi = multiplier_1 * sin_bar_phi;
        let sum_73 = multiplier_0_cos_bar_phi + multiplier_1_sin_bar_phi;
        let sum_73_c17 = sum_73 * c[17usize];
        let seat_omega_seat_omega = seat_omega * seat_omega;
        let product_77 = sin_seat_phi * seat_omega_seat_omega;
        let acceleration_2 = a[2usize];
        let product_79 = cos_seat_phi * acceleration_2;
        let difference_80 = product_79 - product_77;
        let c16_difference_80 = c[16usize] * difference_80;
        let bar_omega = v[5usize];
        let bar_omega_bar_omega = bar_omega * bar_omega;
        let product_84 = sin_bar_phi * bar_omega_bar_omega;
        let acceleration_5 = a[5usize];
        let product_86 = cos_bar_phi * acceleration_5;
        let difference_87 = product_86 - product_84;
        let c17_difference_87 = c[17usize] * difference_87;
        let product_89 = cos_seat_phi * seat_omega_seat_omega;
        let product_90 = sin_seat_phi * acceleration_2;
        let sum_91 = product_89 + product_90;
        let c16_sum_91 = c[16usize] * sum_91;
        let product_93 = cos_bar_phi * bar_omega_bar_omega;
        let product_94 = sin_bar_phi * acceleration_5;
        let sum_95 = product_93 + product_94;
        let c17_sum_95 = c[17usize] * sum_95;
        let bar_vx = v[3usize];
        let bar_omega_bar_vx = bar_omega * bar_vx;
        let acceleration_4 = a[4usize];
        let difference_100 = acceleration_4 - bar_omega_bar_vx;
        let product_101 = sin_bar_phi * difference_100;
        let bar_vy = v[4usize];
        let bar_omega_bar_vy = bar_omega * bar_vy;
        let acceleration_3 = a[3usize];
        let sum_105 = bar_omega_bar_vy + acceleration_3;
        let cos_bar_phi_sum_105 = cos_bar_phi * sum_105;
        let sum_107 = product_101 + cos_bar_phi_sum_105;
        let cos_seat_phi_sum_14 = cos_seat_phi * sum_14;
        let difference_109 = seat_vx - cos_seat_phi_sum_14;
        let c1_difference_109 = c[1usize] * difference_109;
        let seat_omega_c8 = seat_omega * c[8usize];
        let product_112 = sin_seat_phi * seat_omega_c8;
        let sum_113 = c1_difference_109 + product_112;
        let quotient_114 = sum_113 / value_18;
        let sum_14_quotient_114 = sum_14 * quotient_114;
        let value_18_c1 = value_18 * c[1usize];
        let cos_seat_phi_value_18_c1 = cos_seat_phi * value_18_c1;
        let sum_118 = sum_14_quotient_114 + cos_seat_phi_value_18_c1;
        let cos_seat_phi_sum_118 = cos_seat_phi * sum_118;
        let difference_120 = cos_seat_phi_sum_118 - value_18_c1;
        let quotient_121 = difference_120 / sum_32;
        let difference_123 = quotient_121 - c[4usize];
        let product_124 = cos_seat_phi * difference_11;
        let sum_125 = seat_vx_sin_seat_phi + product_124;
        let c1_sum_125 = c[1usize] * sum_125;
        let product_127 = cos_seat_phi * cos_seat_phi;
        let difference_128 = 1f64 - product_127;
        let product_129 = seat_omega * difference_128;
        let c8_product_129 = c[8usize] * product_129;
        let sum_131 = c1_sum_125 + c8_product_129;
        let quotient_132 = sum_131 / value_18;
        let sum_14_quotient_132 = sum_14 * quotient_132;
        let sin_seat_phi_value_18_c1 = sin_seat_phi * value_18_c1;
        let product_135 = cos_seat_phi * sin_seat_phi_value_18_c1;
        let sum_136 = sum_14_quotient_132 + product_135;
        let quotient_137 = sum_136 / sum_32;
        let value_18_c8 = value_18 * c[8usize];
        let quotient_139 = value_18_c8 / sum_32;
        let sum_140 = c[0usize] + quotient_139;
        let sin_seat_phi_sum_140 = sin_seat_phi * sum_140;
        let difference_9_c1 = difference_9 * c[1usize];
        let difference_143 = difference_9_c1 - seat_omega_c8;
        let quotient_144 = difference_143 / value_18;
        let sum_14_quotient_144 = sum_14 * quotient_144;
        let product_146 = cos_seat_phi * sum_14_quotient_144;
        let sum_147 = sin_seat_phi_value_18_c1 + product_146;
        let quotient_148 = sum_147 / sum_32;
        let product_149 = cos_seat_phi * quotient_148;
        let quotient_150 = sum_118 / sum_32;
        let product_151 = cos_seat_phi * quotient_150;
        let sum_152 = c[4usize] + product_151;
        let cos_seat_phi_sum_140 = cos_seat_phi * sum_140;
        let difference_9_c8 = difference_9 * c[8usize];
        let seat_omega_c37 = seat_omega * c[37usize];
        let difference_157 = seat_omega_c37 - difference_9_c8;
        let quotient_158 = difference_157 / value_18;
        let sum_14_quotient_158 = sum_14 * quotient_158;
        let product_160 = cos_seat_phi * sum_14_quotient_158;
        let sin_seat_phi_value_18_c8 = sin_seat_phi * value_18_c8;
        let difference_162 = product_160 - sin_seat_phi_value_18_c8;
        let quotient_163 = difference_162 / sum_32;
        let sin_seat_phi_c0 = sin_seat_phi * c[0usize];
        let difference_165 = quotient_163 - sin_seat_phi_c0;
        let c8_difference_109 = c[8usize] * difference_109;
        let product_167 = sin_seat_phi * seat_omega_c37;
        let sum_168 = c8_difference_109 + product_167;
        let quotient_169 = sum_168 / value_18;
        let sum_14_quotient_169 = sum_14 * quotient_169;
        let cos_seat_phi_value_18_c8 = cos_seat_phi * value_18_c8;
        let sum_172 = sum_14_quotient_169 + cos_seat_phi_value_18_c8;
        let quotient_173 = sum_172 / sum_32;
        let cos_seat_phi_c0 = cos_seat_phi * c[0usize];
        let sum_175 = quotient_173 + cos_seat_phi_c0;
        let value_18_c37 = value_18 * c[37usize];
        let quotient_177 = value_18_c37 / sum_32;
        let sum_179 = quotient_177 + c[5usize];
        let seat_omega_c38 = seat_omega * c[38usize];
        let product_182 = cos_seat_phi * seat_omega_c38;
        let bar_omega_c39 = bar_omega * c[39usize];
        let product_185 = cos_bar_phi * bar_omega_c39;
        let product_186 = sin_seat_phi * seat_omega_c38;
        let product_187 = sin_bar_phi * bar_omega_c39;
        let cos_bar_phi_bar_omega = cos_bar_phi * bar_omega;
        let sin_bar_phi_bar_omega = sin_bar_phi * bar_omega;
        let cos_bar_phi_bar_vx = cos_bar_phi * bar_vx;
        let sin_bar_phi_bar_vy = sin_bar_phi * bar_vy;
        let sum_192 = cos_bar_phi_bar_vx + sin_bar_phi_bar_vy;
        let value_193 = -sin_seat_phi_sum_140;
        let value_194 = -sum_152;
        let value_195 = -sum_179;
        by_q[0usize] = difference_43;
        by_q[1usize] = difference_52;
        by_q[2usize] = difference_64;
        by_q[3usize] = multiplier_2_cos_bar_phi;
        by_q[4usize] = multiplier_2_sin_bar_phi;
        by_q[5usize] = sum_73_c17;
        by_q[6usize] = c16_difference_80;
        by_q[7usize] = c17_difference_87;
        by_q[8usize] = c16_sum_91;
        by_q[9usize] = c17_sum_95;
        by_q[10usize] = sum_107;
        by_v[0usize] = difference_123;
        by_v[1usize] = quotient_137;
        by_v[2usize] = value_193;
        by_v[3usize] = product_149;
        by_v[4usize] = value_194;
        by_v[5usize] = cos_seat_phi_sum_140;
        by_v[6usize] = difference_165;
        by_v[7usize] = sum_175;
        by_v[8usize] = value_195;
        by_v[9usize] = product_182;
        by_v[10usize] = product_185;
        by_v[11usize] = product_186;
        by_v[12usize] = product_187;
        by_v[13usize] = cos_bar_phi_bar_omega;
        by_v[14usize] = sin_bar_phi_bar_omega;
        by_v[15usize] = sum_192;
    }
    fn series(&self) -> ::core::option::Option<&dyn ::ezy_core::model::Series<f64>> {
        ::core::option::Option::Some(self)
    }
    fn precise(&self) -> ::core::option::Option<&dyn ::ezy_core::model::PreciseScene> {
        ::core::option::Option::Some(self)
    }
}
