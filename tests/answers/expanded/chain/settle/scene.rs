#[automatically_derived]
impl ::ezy_core::model::Scene for Settle {
    fn info(&self) -> &'static ::ezy_core::model::SceneInfo {
        static KNOWN: ::ezy_core::layout::Known = ::ezy_core::layout::Known::new();
        KNOWN.info(&Self::FIXED, &[self.n], |layout| self.describe(layout))
    }
    fn count(&self, index: usize) -> usize {
        match index {
            0usize => self.n,
            _ => 0,
        }
    }
    fn set_count(&mut self, index: usize, value: usize) {
        match index {
            0usize => self.n = value,
            _ => {}
        }
    }
    fn parameter(&self, index: usize) -> f64 {
        match index {
            0usize => self.l,
            1usize => self.m,
            2usize => self.g,
            3usize => self.d,
            _ => f64::NAN,
        }
    }
    fn set_parameter(&mut self, index: usize, value: f64) {
        match index {
            0usize => self.l = value,
            1usize => self.m = value,
            2usize => self.g = value,
            3usize => self.d = value,
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
        let first_link: i64 = 0;
        out.fill(0.0);
        {
            let slots: [usize; 1] = [3 * (first_link + 0) as usize];
            let link_0_omega = v[slots[0] + 2];
            let c4_link_0_omega = c[4usize] * link_0_omega;
            let product_3 = link_0_omega * c4_link_0_omega;
            let value_4 = -product_3;
            out[0usize] += value_4;
        }
        for at_i in 1..(self.n as i64) {
            let slots: [usize; 2] = [
                3 * (first_link + at_i) as usize,
                3 * (first_link + (at_i - 1)) as usize,
            ];
            let link_i_omega = v[slots[0] + 2];
            let product_3 = link_i_omega * link_i_omega;
            let link_i_1_omega = v[slots[1] + 2];
            let product_5 = link_i_1_omega * link_i_1_omega;
            let sum_6 = product_3 + product_5;
            let sum_6_c4 = sum_6 * c[4usize];
            let link_i_omega_c7 = link_i_omega * c[7usize];
            let product_11 = link_i_1_omega * link_i_omega_c7;
            let difference_12 = product_11 - sum_6_c4;
            out[0usize] += difference_12;
        }
        let mut place = 0;
    }
    fn potential_energy(&self, c: &[f64], t: f64, q: &[f64]) -> f64 {
        let first_link: i64 = 0;
        let mut total = 0.0;
        for at_i in 0..(self.n as i64) {
            let slots: [usize; 1] = [3 * (first_link + at_i) as usize];
            let link_i_y = q[slots[0] + 1];
            let c3_link_i_y = c[3usize] * link_i_y;
            total += c3_link_i_y;
        }
        total
    }
    fn points(&self, c: &[f64], t: f64, q: &[f64], out: &mut [f64]) {
        let first_link: i64 = 0;
        let mut place = 0;
        {
            let slots: [usize; 0] = [];
            out[place] = 0f64;
            place += 1;
            out[place] = 0f64;
            place += 1;
        }
        {
            let slots: [usize; 1] = [3 * (first_link + ((self.n as i64) - 1)) as usize];
            let link_n_1_x = q[slots[0] + 0];
            let link_n_1_phi = q[slots[0] + 2];
            let (sin_link_n_1_phi, cos_link_n_1_phi) = f64::sin_cos(link_n_1_phi);
            let c2_cos_link_n_1_phi = c[2usize] * cos_link_n_1_phi;
            let sum_7 = link_n_1_x + c2_cos_link_n_1_phi;
            let link_n_1_y = q[slots[0] + 1];
            let c2_sin_link_n_1_phi = c[2usize] * sin_link_n_1_phi;
            let sum_11 = link_n_1_y + c2_sin_link_n_1_phi;
            out[place] = sum_7;
            place += 1;
            out[place] = sum_11;
            place += 1;
        }
        for at_i in 1..(self.n as i64) {
            let slots: [usize; 1] = [3 * (first_link + (at_i - 1)) as usize];
            let link_i_1_x = q[slots[0] + 0];
            let link_i_1_phi = q[slots[0] + 2];
            let (sin_link_i_1_phi, cos_link_i_1_phi) = f64::sin_cos(link_i_1_phi);
            let c2_cos_link_i_1_phi = c[2usize] * cos_link_i_1_phi;
            let sum_7 = link_i_1_x + c2_cos_link_i_1_phi;
            let link_i_1_y = q[slots[0] + 1];
            let c2_sin_link_i_1_phi = c[2usize] * sin_link_i_1_phi;
            let sum_11 = link_i_1_y + c2_sin_link_i_1_phi;
            out[place] = sum_7;
            place += 1;
            out[place] = sum_11;
            place += 1;
        }
    }
    fn outputs(&self, c: &[f64], t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
        let first_link: i64 = 0;
        let mut place = 0;
        {
            let slots: [usize; 1] = [3 * (first_link + ((self.n as i64) - 1)) as usize];
            let link_n_1_y = q[slots[0] + 1];
            let c5_link_n_1_y = c[5usize] * link_n_1_y;
            let link_n_1_phi = q[slots[0] + 2];
            let sin_link_n_1_phi = f64::sin(link_n_1_phi);
            let c6_sin_link_n_1_phi = c[6usize] * sin_link_n_1_phi;
            let sum_9 = c5_link_n_1_y + c6_sin_link_n_1_phi;
            let value_10 = -sum_9;
            out[place] = value_10;
            place += 1;
        }
    }
    fn start(&self, c: &[f64], start: &mut ::ezy_core::model::Start) {
        let first_link: i64 = 0;
        for at_i in 0..(self.n as i64) {
            let slots: [usize; 1] = [3 * (first_link + at_i) as usize];
            start.give_position(slots[0] + 2, 0f64);
        }
    }
    fn slope_places(&self) -> ::core::option::Option<::ezy_core::model::SlopePlaces> {
        let first_link: i64 = 0;
        let n_q = ::ezy_core::model::Scene::info(self).n_coordinates();
        let mut places = ::ezy_core::model::SlopePlaces::default();
        let mut place = 0;
        {
            let slots: [usize; 1] = [3 * (first_link + 0) as usize];
            places
                .by_q
                .extend_from_slice(
                    &[
                        (slots[0] + 2, slots[0] + 2),
                        (n_q + place + 0usize, slots[0] + 2),
                        (n_q + place + 1usize, slots[0] + 2),
                    ],
                );
            places
                .by_v
                .extend_from_slice(
                    &[
                        (n_q + place + 0usize, slots[0] + 2),
                        (n_q + place + 1usize, slots[0] + 2),
                    ],
                );
            place += 2usize;
        }
        for at_i in 1..(self.n as i64) {
            let slots: [usize; 2] = [
                3 * (first_link + (at_i - 1)) as usize,
                3 * (first_link + at_i) as usize,
            ];
            places
                .by_q
                .extend_from_slice(
                    &[
                        (slots[0] + 2, slots[0] + 2),
                        (slots[1] + 2, slots[1] + 2),
                        (n_q + place + 0usize, slots[0] + 2),
                        (n_q + place + 0usize, slots[1] + 2),
                        (n_q + place + 1usize, slots[0] + 2),
                        (n_q + place + 1usize, slots[1] + 2),
                    ],
                );
            places
                .by_v
                .extend_from_slice(
                    &[
                        (n_q + place + 0usize, slots[0] + 2),
                        (n_q + place + 0usize, slots[1] + 2),
                        (n_q + place + 1usize, slots[0] + 2),
                        (n_q + place + 1usize, slots[1] + 2),
                    ],
                );
            place += 2usize;
        }
        for at_i in 0..(self.n as i64) {
            let slots: [usize; 1] = [3 * (first_link + at_i) as usize];
            places.by_q.extend_from_slice(&[]);
            places.by_v.extend_from_slice(&[]);
            place += 0usize;
        }
        {
            let slots: [usize; 1] = [3 * (first_link + 0) as usize];
            places.by_q.extend_from_slice(&[]);
            places.by_v.extend_from_slice(&[(slots[0] + 2, slots[0] + 2)]);
            place += 0usize;
        }
        for at_i in 1..(self.n as i64) {
            let slots: [usize; 2] = [
                3 * (first_link + at_i) as usize,
                3 * (first_link + (at_i - 1)) as usize,
            ];
            places.by_q.extend_from_slice(&[]);
            places
                .by_v
                .extend_from_slice(
                    &[
                        (slots[0] + 2, slots[0] + 2),
                        (slots[0] + 2, slots[1] + 2),
                        (slots[1] + 2, slots[0] + 2),
                        (slots[1] + 2, slots[1] + 2),
                    ],
                );
            place += 0usize;
        }
        ::core::option::Option::Some(places)
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
        let first_link: i64 = 0;
        let (mut place, mut place_q, mut place_v) = (0, 0, 0);
        {
            let slots: [usize; 1] = [3 * (first_link + 0) as usize];
            let multiplier_0 = lambda[place + 0usize];
            let link_0_phi = q[slots[0] + 2];
            let (sin_link_0_phi, cos_link_0_phi) = f64::sin_cos(link_0_phi);
            let product_5 = multiplier_0 * cos_link_0_phi;
            let multiplier_1 = lambda[place + 1usize];
            let product_8 = multiplier_1 * sin_link_0_phi;
            let sum_9 = product_5 + product_8;
            let sum_9_c2 = sum_9 * c[2usize];
            let link_0_omega = v[slots[0] + 2];
            let product_13 = link_0_omega * link_0_omega;
            let product_14 = sin_link_0_phi * product_13;
            let acceleration_8 = a[slots[0] + 2];
            let product_16 = cos_link_0_phi * acceleration_8;
            let difference_17 = product_16 - product_14;
            let c2_difference_17 = c[2usize] * difference_17;
            let product_19 = cos_link_0_phi * product_13;
            let product_20 = sin_link_0_phi * acceleration_8;
            let sum_21 = product_19 + product_20;
            let c2_sum_21 = c[2usize] * sum_21;
            let link_0_omega_c8 = link_0_omega * c[8usize];
            let product_25 = cos_link_0_phi * link_0_omega_c8;
            let product_26 = sin_link_0_phi * link_0_omega_c8;
            by_q[place_q] = sum_9_c2;
            place_q += 1;
            by_q[place_q] = c2_difference_17;
            place_q += 1;
            by_q[place_q] = c2_sum_21;
            place_q += 1;
            by_v[place_v] = product_25;
            place_v += 1;
            by_v[place_v] = product_26;
            place_v += 1;
            place += 2usize;
        }
        for at_i in 1..(self.n as i64) {
            let slots: [usize; 2] = [
                3 * (first_link + (at_i - 1)) as usize,
                3 * (first_link + at_i) as usize,
            ];
            let multiplier_0 = lambda[place + 0usize];
            let link_i_1_phi = q[slots[0] + 2];
            let (sin_link_i_1_phi, cos_link_i_1_phi) = f64::sin_cos(link_i_1_phi);
            let product_5 = multiplier_0 * cos_link_i_1_phi;
            let multiplier_1 = lambda[place + 1usize];
            let product_8 = multiplier_1 * sin_link_i_1_phi;
            let sum_9 = product_5 + product_8;
            let sum_9_c2 = sum_9 * c[2usize];
            let link_i_phi = q[slots[1] + 2];
            let (sin_link_i_phi, cos_link_i_phi) = f64::sin_cos(link_i_phi);
            let product_14 = multiplier_0 * cos_link_i_phi;
            let product_16 = multiplier_1 * sin_link_i_phi;
            let sum_17 = product_14 + product_16;
            let c2_sum_17 = c[2usize] * sum_17;
            let link_i_1_omega = v[slots[0] + 2];
            let product_20 = link_i_1_omega * link_i_1_omega;
            let product_21 = sin_link_i_1_phi * product_20;
            let acceleration_11 = a[slots[0] + 2];
            let product_23 = cos_link_i_1_phi * acceleration_11;
            let difference_24 = product_23 - product_21;
            let c2_difference_24 = c[2usize] * difference_24;
            let link_i_omega = v[slots[1] + 2];
            let product_27 = link_i_omega * link_i_omega;
            let product_28 = sin_link_i_phi * product_27;
            let acceleration_14 = a[slots[1] + 2];
            let product_30 = cos_link_i_phi * acceleration_14;
            let difference_31 = product_30 - product_28;
            let c2_difference_31 = c[2usize] * difference_31;
            let product_33 = cos_link_i_1_phi * product_20;
            let product_34 = sin_link_i_1_phi * acceleration_11;
            let sum_35 = product_33 + product_34;
            let c2_sum_35 = c[2usize] * sum_35;
            let product_37 = cos_link_i_phi * product_27;
            let product_38 = sin_link_i_phi * acceleration_14;
            let sum_39 = product_37 + product_38;
            let c2_sum_39 = c[2usize] * sum_39;
            let link_i_1_omega_c8 = link_i_1_omega * c[8usize];
            let product_43 = cos_link_i_1_phi * link_i_1_omega_c8;
            let link_i_omega_c8 = link_i_omega * c[8usize];
            let product_45 = cos_link_i_phi * link_i_omega_c8;
            let product_46 = sin_link_i_1_phi * link_i_1_omega_c8;
            let product_47 = sin_link_i_phi * link_i_omega_c8;
            by_q[place_q] = sum_9_c2;
            place_q += 1;
            by_q[place_q] = c2_sum_17;
            place_q += 1;
            by_q[place_q] = c2_difference_24;
            place_q += 1;
            by_q[place_q] = c2_difference_31;
            place_q += 1;
            by_q[place_q] = c2_sum_35;
            place_q += 1;
            by_q[place_q] = c2_sum_39;
            place_q += 1;
            by_v[place_v] = product_43;
            place_v += 1;
            by_v[place_v] = product_45;
            place_v += 1;
            by_v[place_v] = product_46;
            place_v += 1;
            by_v[place_v] = product_47;
            place_v += 1;
            place += 2usize;
        }
        for at_i in 0..(self.n as i64) {
            let slots: [usize; 1] = [3 * (first_link + at_i) as usize];
            place += 0usize;
        }
        {
            let slots: [usize; 1] = [3 * (first_link + 0) as usize];
            let value_1 = -c[4usize];
            by_v[place_v] = value_1;
            place_v += 1;
            place += 0usize;
        }
        for at_i in 1..(self.n as i64) {
            let slots: [usize; 2] = [
                3 * (first_link + at_i) as usize,
                3 * (first_link + (at_i - 1)) as usize,
            ];
            let value_1 = -c[4usize];
            by_v[place_v] = value_1;
            place_v += 1;
            by_v[place_v] = c[4usize];
            place_v += 1;
            by_v[place_v] = c[4usize];
            place_v += 1;
            by_v[place_v] = value_1;
            place_v += 1;
            place += 0usize;
        }
    }
    fn series(&self) -> ::core::option::Option<&dyn ::ezy_core::model::Series<f64>> {
        ::core::option::Option::Some(self)
    }
    fn precise(&self) -> ::core::option::Option<&dyn ::ezy_core::model::PreciseScene> {
        ::core::option::Option::Some(self)
    }
}
