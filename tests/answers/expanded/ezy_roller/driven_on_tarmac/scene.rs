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
        let c = ::ezy_core::kernel::array::<41usize, f64>(c);
        let q = ::ezy_core::kernel::array::<6usize, f64>(q);
        let v = ::ezy_core::kernel::array::<6usize, f64>(v);
        let lambda = ::ezy_core::kernel::array::<4usize, f64>(lambda);
        let out = ::ezy_core::kernel::array_mut::<2usize, f64>(out);
        let seat_omega = v[2usize];
        let bar_omega = v[5usize];
        let difference_4 = seat_omega - bar_omega;
        let c4_t = c[4usize] * t;
        let cos_7 = f64::cos(c4_t);
        let difference_4_cos_7 = difference_4 * cos_7;
        let difference_4_cos_7_c3 = difference_4_cos_7 * c[3usize];
        let seat_vx = v[0usize];
        let seat_vx_seat_vx = seat_vx * seat_vx;
        let seat_vy = v[1usize];
        let seat_vy_seat_vy = seat_vy * seat_vy;
        let sum_16 = seat_vx_seat_vx + seat_vy_seat_vy;
        let sum_16_c0 = sum_16 * c[0usize];
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = f64::sin_cos(seat_phi);
        let seat_vx_sin_seat_phi = seat_vx * sin_seat_phi;
        let seat_vy_cos_seat_phi = seat_vy * cos_seat_phi;
        let difference_24 = seat_vx_sin_seat_phi - seat_vy_cos_seat_phi;
        let difference_24_c37 = difference_24 * c[37usize];
        let seat_omega_c2 = seat_omega * c[2usize];
        let difference_29 = difference_24_c37 - seat_omega_c2;
        let seat_omega_difference_29 = seat_omega * difference_29;
        let difference_31 = seat_omega_difference_29 - sum_16_c0;
        out[0usize] = difference_4_cos_7_c3;
        out[1usize] = difference_31;
    }
    fn points(&self, c: &[f64], t: f64, q: &[f64], out: &mut [f64]) {
        let c = ::ezy_core::kernel::array::<41usize, f64>(c);
        let q = ::ezy_core::kernel::array::<6usize, f64>(q);
        let out = ::ezy_core::kernel::array_mut::<6usize, f64>(out);
        let seat_x = q[0usize];
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = f64::sin_cos(seat_phi);
        let c35_cos_seat_phi = c[35usize] * cos_seat_phi;
        let difference_7 = seat_x - c35_cos_seat_phi;
        let seat_y = q[1usize];
        let c35_sin_seat_phi = c[35usize] * sin_seat_phi;
        let difference_11 = seat_y - c35_sin_seat_phi;
        let bar_x = q[3usize];
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = f64::sin_cos(bar_phi);
        let c36_cos_bar_phi = c[36usize] * cos_bar_phi;
        let sum_17 = bar_x + c36_cos_bar_phi;
        let bar_y = q[4usize];
        let c36_sin_bar_phi = c[36usize] * sin_bar_phi;
        let sum_21 = bar_y + c36_sin_bar_phi;
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
        let c = ::ezy_core::kernel::array::<41usize, f64>(c);
        let q = ::ezy_core::kernel::array::<6usize, f64>(q);
        let v = ::ezy_core::kernel::array::<6usize, f64>(v);
        let out = ::ezy_core::kernel::array_mut::<0usize, f64>(out);
    }
    fn potential_energy(&self, c: &[f64], t: f64, q: &[f64]) -> f64 {
        0f64
    }
    fn start(&self, c: &[f64], start: &mut ::ezy_core::model::Start) {
        let c = ::ezy_core::kernel::array::<41usize, f64>(c);
        start.give_position(0usize, 0f64);
        start.give_position(1usize, 0f64);
        start.give_position(2usize, 0f64);
        start.give_position(5usize, c[38usize]);
    }
    fn slope_places(&self) -> ::core::option::Option<::ezy_core::model::SlopePlaces> {
        ::core::option::Option::Some(::ezy_core::model::SlopePlaces {
            by_q: ::std::vec![
                (0usize, 2usize), (1usize, 2usize), (2usize, 2usize), (3usize, 5usize),
                (4usize, 5usize), (5usize, 5usize), (6usize, 2usize), (6usize, 5usize),
                (7usize, 2usize), (7usize, 5usize), (8usize, 2usize), (9usize, 5usize)
            ],
            by_v: ::std::vec![
                (0usize, 0usize), (0usize, 2usize), (1usize, 1usize), (1usize, 2usize),
                (2usize, 0usize), (2usize, 1usize), (2usize, 2usize), (6usize, 2usize),
                (6usize, 5usize), (7usize, 2usize), (7usize, 5usize), (8usize, 0usize),
                (8usize, 1usize), (8usize, 2usize), (9usize, 3usize), (9usize, 4usize),
                (9usize, 5usize)
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
        let c = ::ezy_core::kernel::array::<41usize, f64>(c);
        let q = ::ezy_core::kernel::array::<6usize, f64>(q);
        let v = ::ezy_core::kernel::array::<6usize, f64>(v);
        let a = ::ezy_core::kernel::array::<6usize, f64>(a);
        let lambda = ::ezy_core::kernel::array::<4usize, f64>(lambda);
        let by_q = ::ezy_core::kernel::array_mut::<12usize, f64>(by_q);
        let by_v = ::ezy_core::kernel::array_mut::<17usize, f64>(by_v);
        let seat_omega = v[2usize];
        let c1_seat_omega = c[1usize] * seat_omega;
        let multiplier_2 = lambda[2usize];
        let difference_6 = multiplier_2 - c1_seat_omega;
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = f64::sin_cos(seat_phi);
        let product_9 = difference_6 * cos_seat_phi;
        let product_11 = difference_6 * sin_seat_phi;
        let multiplier_0 = lambda[0usize];
        let product_13 = cos_seat_phi * multiplier_0;
        let multiplier_1 = lambda[1usize];
        let product_15 = sin_seat_phi * multiplier_1;
        let sum_16 = product_13 + product_15;
        let sum_16_c16 = sum_16 * c[16usize];
        let seat_vx = v[0usize];
        let cos_seat_phi_seat_vx = cos_seat_phi * seat_vx;
        let seat_vy = v[1usize];
        let sin_seat_phi_seat_vy = sin_seat_phi * seat_vy;
        let sum_23 = cos_seat_phi_seat_vx + sin_seat_phi_seat_vy;
        let c1_sum_23 = c[1usize] * sum_23;
        let difference_25 = sum_16_c16 - c1_sum_23;
        let multiplier_3 = lambda[3usize];
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = f64::sin_cos(bar_phi);
        let multiplier_3_cos_bar_phi = multiplier_3 * cos_bar_phi;
        let multiplier_3_sin_bar_phi = multiplier_3 * sin_bar_phi;
        let multiplier_0_cos_bar_phi = multiplier_0 * cos_bar_phi;
        let multiplier_1_sin_bar_phi = multiplier_1 * sin_bar_phi;
        let sum_34 = multiplier_0_cos_bar_phi + multiplier_1_sin_bar_phi;
        let sum_34_c17 = sum_34 * c[17usize];
        let seat_omega_seat_omega = seat_omega * seat_omega;
        let product_38 = sin_seat_phi * seat_omega_seat_omega;
        let acceleration_2 = a[2usize];
        let product_40 = cos_seat_phi * acceleration_2;
        let difference_41 = product_40 - product_38;
        let c16_difference_41 = c[16usize] * difference_41;
        let bar_omega = v[5usize];
        let bar_omega_bar_omega = bar_omega * bar_omega;
        let product_45 = sin_bar_phi * bar_omega_bar_omega;
        let acceleration_5 = a[5usize];
        let product_47 = cos_bar_phi * acceleration_5;
        let difference_48 = product_47 - product_45;
        let c17_difference_48 = c[17usize] * difference_48;
        let product_50 = cos_seat_phi * seat_omega_seat_omega;
        let product_51 = sin_seat_phi * acceleration_2;
        let sum_52 = product_50 + product_51;
        let c16_sum_52 = c[16usize] * sum_52;
        let product_54 = cos_bar_phi * bar_omega_bar_omega;
        let product_55 = sin_bar_phi * acceleration_5;
        let sum_56 = product_54 + product_55;
        let c17_sum_56 = c[17usize] * sum_56;
        let seat_omega_seat_vx = seat_omega * seat_vx;
        let acceleration_1 = a[1usize];
        let difference_60 = acceleration_1 - seat_omega_seat_vx;
        let product_61 = sin_seat_phi * difference_60;
        let seat_omega_seat_vy = seat_omega * seat_vy;
        let acceleration_0 = a[0usize];
        let sum_64 = seat_omega_seat_vy + acceleration_0;
        let cos_seat_phi_sum_64 = cos_seat_phi * sum_64;
        let sum_66 = product_61 + cos_seat_phi_sum_64;
        let bar_vx = v[3usize];
        let bar_omega_bar_vx = bar_omega * bar_vx;
        let acceleration_4 = a[4usize];
        let difference_70 = acceleration_4 - bar_omega_bar_vx;
        let product_71 = sin_bar_phi * difference_70;
        let bar_vy = v[4usize];
        let bar_omega_bar_vy = bar_omega * bar_vy;
        let acceleration_3 = a[3usize];
        let sum_75 = bar_omega_bar_vy + acceleration_3;
        let cos_bar_phi_sum_75 = cos_bar_phi * sum_75;
        let sum_77 = product_71 + cos_bar_phi_sum_75;
        let c1_sin_seat_phi = c[1usize] * sin_seat_phi;
        let c1_cos_seat_phi = c[1usize] * cos_seat_phi;
        let seat_omega_c39 = seat_omega * c[39usize];
        let product_84 = cos_seat_phi * seat_omega_c39;
        let bar_omega_c40 = bar_omega * c[40usize];
        let product_87 = cos_bar_phi * bar_omega_c40;
        let product_88 = sin_seat_phi * seat_omega_c39;
        let product_89 = sin_bar_phi * bar_omega_c40;
        let seat_omega_cos_seat_phi = seat_omega * cos_seat_phi;
        let seat_omega_sin_seat_phi = seat_omega * sin_seat_phi;
        let cos_bar_phi_bar_omega = cos_bar_phi * bar_omega;
        let sin_bar_phi_bar_omega = sin_bar_phi * bar_omega;
        let cos_bar_phi_bar_vx = cos_bar_phi * bar_vx;
        let sin_bar_phi_bar_vy = sin_bar_phi * bar_vy;
        let sum_96 = cos_bar_phi_bar_vx + sin_bar_phi_bar_vy;
        let value_97 = -c[0usize];
        let value_98 = -c1_sin_seat_phi;
        let value_99 = -c[2usize];
        by_q[0usize] = product_9;
        by_q[1usize] = product_11;
        by_q[2usize] = difference_25;
        by_q[3usize] = multiplier_3_cos_bar_phi;
        by_q[4usize] = multiplier_3_sin_bar_phi;
        by_q[5usize] = sum_34_c17;
        by_q[6usize] = c16_difference_41;
        by_q[7usize] = c17_difference_48;
        by_q[8usize] = c16_sum_52;
        by_q[9usize] = c17_sum_56;
        by_q[10usize] = sum_66;
        by_q[11usize] = sum_77;
        by_v[0usize] = value_97;
        by_v[1usize] = value_98;
        by_v[2usize] = value_97;
        by_v[3usize] = c1_cos_seat_phi;
        by_v[4usize] = value_98;
        by_v[5usize] = c1_cos_seat_phi;
        by_v[6usize] = value_99;
        by_v[7usize] = product_84;
        by_v[8usize] = product_87;
        by_v[9usize] = product_88;
        by_v[10usize] = product_89;
        by_v[11usize] = seat_omega_cos_seat_phi;
        by_v[12usize] = seat_omega_sin_seat_phi;
        by_v[13usize] = sum_23;
        by_v[14usize] = cos_bar_phi_bar_omega;
        by_v[15usize] = sin_bar_phi_bar_omega;
        by_v[16usize] = sum_96;
    }
    fn series(&self) -> ::core::option::Option<&dyn ::ezy_core::model::Series<f64>> {
        ::core::option::Option::Some(self)
    }
    fn precise(&self) -> ::core::option::Option<&dyn ::ezy_core::model::PreciseScene> {
        ::core::option::Option::Some(self)
    }
}
