#[automatically_derived]
impl ::ezy_core::model::Scene for Coast {
    fn info(&self) -> &'static ::ezy_core::model::SceneInfo {
        static INFO: ::ezy_core::model::SceneInfo = Coast::INFO;
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
        let c = ::ezy_core::kernel::array::<32usize, f64>(c);
        let q = ::ezy_core::kernel::array::<6usize, f64>(q);
        let v = ::ezy_core::kernel::array::<6usize, f64>(v);
        let lambda = ::ezy_core::kernel::array::<4usize, f64>(lambda);
        let out = ::ezy_core::kernel::array_mut::<0usize, f64>(out);
    }
    fn points(&self, c: &[f64], t: f64, q: &[f64], out: &mut [f64]) {
        let c = ::ezy_core::kernel::array::<32usize, f64>(c);
        let q = ::ezy_core::kernel::array::<6usize, f64>(q);
        let out = ::ezy_core::kernel::array_mut::<6usize, f64>(out);
        let seat_x = q[0usize];
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = f64::sin_cos(seat_phi);
        let c27_cos_seat_phi = c[27usize] * cos_seat_phi;
        let difference_7 = seat_x - c27_cos_seat_phi;
        let seat_y = q[1usize];
        let c27_sin_seat_phi = c[27usize] * sin_seat_phi;
        let difference_11 = seat_y - c27_sin_seat_phi;
        let bar_x = q[3usize];
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = f64::sin_cos(bar_phi);
        let c28_cos_bar_phi = c[28usize] * cos_bar_phi;
        let sum_17 = bar_x + c28_cos_bar_phi;
        let bar_y = q[4usize];
        let c28_sin_bar_phi = c[28usize] * sin_bar_phi;
        let sum_21 = bar_y + c28_sin_bar_phi;
        let cos_seat_phi_c4 = cos_seat_phi * c[4usize];
        let sum_24 = seat_x + cos_seat_phi_c4;
        let sin_seat_phi_c4 = sin_seat_phi * c[4usize];
        let sum_26 = seat_y + sin_seat_phi_c4;
        out[0usize] = difference_7;
        out[1usize] = difference_11;
        out[2usize] = sum_17;
        out[3usize] = sum_21;
        out[4usize] = sum_24;
        out[5usize] = sum_26;
    }
    fn outputs(&self, c: &[f64], t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
        let c = ::ezy_core::kernel::array::<32usize, f64>(c);
        let q = ::ezy_core::kernel::array::<6usize, f64>(q);
        let v = ::ezy_core::kernel::array::<6usize, f64>(v);
        let out = ::ezy_core::kernel::array_mut::<0usize, f64>(out);
    }
    fn potential_energy(&self, c: &[f64], t: f64, q: &[f64]) -> f64 {
        0f64
    }
    fn start(&self, c: &[f64], start: &mut ::ezy_core::model::Start) {
        let c = ::ezy_core::kernel::array::<32usize, f64>(c);
        start.give_position(0usize, c[27usize]);
        start.give_position(1usize, 0f64);
        start.give_position(2usize, 0f64);
        start.give_position(5usize, c[29usize]);
        start.give_velocity(0usize, 1f64);
        start.give_velocity(2usize, 0f64);
    }
    fn slope_places(&self) -> ::core::option::Option<::ezy_core::model::SlopePlaces> {
        ::core::option::Option::Some(::ezy_core::model::SlopePlaces {
            by_q: ::std::vec![
                (0usize, 2usize), (1usize, 2usize), (2usize, 2usize), (3usize, 5usize),
                (4usize, 5usize), (5usize, 5usize), (6usize, 2usize), (6usize, 5usize),
                (7usize, 2usize), (7usize, 5usize), (8usize, 2usize), (9usize, 5usize)
            ],
            by_v: ::std::vec![
                (6usize, 2usize), (6usize, 5usize), (7usize, 2usize), (7usize, 5usize),
                (8usize, 0usize), (8usize, 1usize), (8usize, 2usize), (9usize, 3usize),
                (9usize, 4usize), (9usize, 5usize)
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
        let c = ::ezy_core::kernel::array::<32usize, f64>(c);
        let q = ::ezy_core::kernel::array::<6usize, f64>(q);
        let v = ::ezy_core::kernel::array::<6usize, f64>(v);
        let a = ::ezy_core::kernel::array::<6usize, f64>(a);
        let lambda = ::ezy_core::kernel::array::<4usize, f64>(lambda);
        let by_q = ::ezy_core::kernel::array_mut::<12usize, f64>(by_q);
        let by_v = ::ezy_core::kernel::array_mut::<10usize, f64>(by_v);
        let multiplier_2 = lambda[2usize];
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = f64::sin_cos(seat_phi);
        let product_4 = multiplier_2 * cos_seat_phi;
        let product_6 = multiplier_2 * sin_seat_phi;
        let multiplier_0 = lambda[0usize];
        let product_9 = cos_seat_phi * multiplier_0;
        let multiplier_1 = lambda[1usize];
        let product_11 = sin_seat_phi * multiplier_1;
        let sum_12 = product_9 + product_11;
        let sum_12_c4 = sum_12 * c[4usize];
        let multiplier_3 = lambda[3usize];
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = f64::sin_cos(bar_phi);
        let multiplier_3_cos_bar_phi = multiplier_3 * cos_bar_phi;
        let multiplier_3_sin_bar_phi = multiplier_3 * sin_bar_phi;
        let multiplier_0_cos_bar_phi = multiplier_0 * cos_bar_phi;
        let multiplier_1_sin_bar_phi = multiplier_1 * sin_bar_phi;
        let sum_23 = multiplier_0_cos_bar_phi + multiplier_1_sin_bar_phi;
        let sum_23_c5 = sum_23 * c[5usize];
        let seat_omega = v[2usize];
        let seat_omega_seat_omega = seat_omega * seat_omega;
        let product_28 = sin_seat_phi * seat_omega_seat_omega;
        let acceleration_2 = a[2usize];
        let product_30 = cos_seat_phi * acceleration_2;
        let difference_31 = product_30 - product_28;
        let c4_difference_31 = c[4usize] * difference_31;
        let bar_omega = v[5usize];
        let bar_omega_bar_omega = bar_omega * bar_omega;
        let product_35 = sin_bar_phi * bar_omega_bar_omega;
        let acceleration_5 = a[5usize];
        let product_37 = cos_bar_phi * acceleration_5;
        let difference_38 = product_37 - product_35;
        let c5_difference_38 = c[5usize] * difference_38;
        let product_40 = cos_seat_phi * seat_omega_seat_omega;
        let product_41 = sin_seat_phi * acceleration_2;
        let sum_42 = product_40 + product_41;
        let c4_sum_42 = c[4usize] * sum_42;
        let product_44 = cos_bar_phi * bar_omega_bar_omega;
        let product_45 = sin_bar_phi * acceleration_5;
        let sum_46 = product_44 + product_45;
        let c5_sum_46 = c[5usize] * sum_46;
        let seat_vx = v[0usize];
        let seat_omega_seat_vx = seat_omega * seat_vx;
        let acceleration_1 = a[1usize];
        let difference_51 = acceleration_1 - seat_omega_seat_vx;
        let product_52 = sin_seat_phi * difference_51;
        let seat_vy = v[1usize];
        let seat_omega_seat_vy = seat_omega * seat_vy;
        let acceleration_0 = a[0usize];
        let sum_56 = seat_omega_seat_vy + acceleration_0;
        let cos_seat_phi_sum_56 = cos_seat_phi * sum_56;
        let sum_58 = product_52 + cos_seat_phi_sum_56;
        let bar_vx = v[3usize];
        let bar_omega_bar_vx = bar_omega * bar_vx;
        let acceleration_4 = a[4usize];
        let difference_62 = acceleration_4 - bar_omega_bar_vx;
        let product_63 = sin_bar_phi * difference_62;
        let bar_vy = v[4usize];
        let bar_omega_bar_vy = bar_omega * bar_vy;
        let acceleration_3 = a[3usize];
        let sum_67 = bar_omega_bar_vy + acceleration_3;
        let cos_bar_phi_sum_67 = cos_bar_phi * sum_67;
        let sum_69 = product_63 + cos_bar_phi_sum_67;
        let seat_omega_c30 = seat_omega * c[30usize];
        let product_72 = cos_seat_phi * seat_omega_c30;
        let bar_omega_c31 = bar_omega * c[31usize];
        let product_75 = cos_bar_phi * bar_omega_c31;
        let product_76 = sin_seat_phi * seat_omega_c30;
        let product_77 = sin_bar_phi * bar_omega_c31;
        let cos_seat_phi_seat_omega = cos_seat_phi * seat_omega;
        let sin_seat_phi_seat_omega = sin_seat_phi * seat_omega;
        let cos_seat_phi_seat_vx = cos_seat_phi * seat_vx;
        let sin_seat_phi_seat_vy = sin_seat_phi * seat_vy;
        let sum_82 = cos_seat_phi_seat_vx + sin_seat_phi_seat_vy;
        let cos_bar_phi_bar_omega = cos_bar_phi * bar_omega;
        let sin_bar_phi_bar_omega = sin_bar_phi * bar_omega;
        let cos_bar_phi_bar_vx = cos_bar_phi * bar_vx;
        let sin_bar_phi_bar_vy = sin_bar_phi * bar_vy;
        let sum_87 = cos_bar_phi_bar_vx + sin_bar_phi_bar_vy;
        by_q[0usize] = product_4;
        by_q[1usize] = product_6;
        by_q[2usize] = sum_12_c4;
        by_q[3usize] = multiplier_3_cos_bar_phi;
        by_q[4usize] = multiplier_3_sin_bar_phi;
        by_q[5usize] = sum_23_c5;
        by_q[6usize] = c4_difference_31;
        by_q[7usize] = c5_difference_38;
        by_q[8usize] = c4_sum_42;
        by_q[9usize] = c5_sum_46;
        by_q[10usize] = sum_58;
        by_q[11usize] = sum_69;
        by_v[0usize] = product_72;
        by_v[1usize] = product_75;
        by_v[2usize] = product_76;
        by_v[3usize] = product_77;
        by_v[4usize] = cos_seat_phi_seat_omega;
        by_v[5usize] = sin_seat_phi_seat_omega;
        by_v[6usize] = sum_82;
        by_v[7usize] = cos_bar_phi_bar_omega;
        by_v[8usize] = sin_bar_phi_bar_omega;
        by_v[9usize] = sum_87;
    }
    fn series(&self) -> ::core::option::Option<&dyn ::ezy_core::model::Series<f64>> {
        ::core::option::Option::Some(self)
    }
    fn precise(&self) -> ::core::option::Option<&dyn ::ezy_core::model::PreciseScene> {
        ::core::option::Option::Some(self)
    }
}
