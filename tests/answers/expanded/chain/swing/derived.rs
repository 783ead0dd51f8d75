#[automatically_derived]
impl ezy::Derived for Swing {
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
    fn jacobian_places(&self) -> ::core::option::Option<ezy::JacobianPlaces> {
        let first_link: i64 = 0;
        let n_q = ezy::Scene::info(self).n_coordinates();
        let mut places = ezy::JacobianPlaces::default();
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
        ::core::option::Option::Some(places)
    }
    fn jacobians(
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
        let mut place_q = 0;
        let mut place_v = 0;
        let mut place = 0;
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
            let link_0_omega_c6 = link_0_omega * c[6usize];
            let product_25 = cos_link_0_phi * link_0_omega_c6;
            let product_26 = sin_link_0_phi * link_0_omega_c6;
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
            let link_i_1_omega_c6 = link_i_1_omega * c[6usize];
            let product_43 = cos_link_i_1_phi * link_i_1_omega_c6;
            let link_i_omega_c6 = link_i_omega * c[6usize];
            let product_45 = cos_link_i_phi * link_i_omega_c6;
            let product_46 = sin_link_i_1_phi * link_i_1_omega_c6;
            let product_47 = sin_link_i_phi * link_i_omega_c6;
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
        }
    }
    fn series(&self) -> ::core::option::Option<&dyn ezy::Series<f64>> {
        ::core::option::Option::Some(self)
    }
    fn precise(&self) -> ::core::option::Option<&dyn ezy::PreciseScene> {
        ::core::option::Option::Some(self)
    }
}
