#[automatically_derived]
impl<T: ezy::Scalar> ezy::Equations<T> for self::Swing {
    fn constants(&self, parameters: &[T], c: &mut [T]) {
        let parameters = ezy::array::<3usize, T>(parameters);
        let c = ezy::array_mut::<7usize, T>(c);
        let k1 = T::from_f64(1f64);
        let parameter_m = parameters[1usize];
        let parameter_l = parameters[0usize];
        let k4 = T::from_f64(2f64);
        let k5 = parameter_l * parameter_l;
        let k6 = parameter_m * k5;
        let k7 = T::from_f64(12f64);
        let k9 = k6 / k7;
        let parameter_g = parameters[2usize];
        let k11 = parameter_m * parameter_g;
        let k13 = parameter_l / k4;
        let k14 = T::from_f64(self.n as f64);
        let k15 = k14 * parameter_l;
        let k16 = k1 / k15;
        let k17 = k13 / k15;
        c[0usize] = parameter_m;
        c[1usize] = k9;
        c[2usize] = k13;
        c[3usize] = k11;
        c[4usize] = k16;
        c[5usize] = k17;
        c[6usize] = parameter_l;
    }
    fn mass_matrix(&self, c: &[T], out: &mut [T]) {
        let mut place = 0;
        for _ in 0..(self.n as i64) {
            out[place] = c[0usize];
            place += 1;
            out[place] = c[0usize];
            place += 1;
            out[place] = c[1usize];
            place += 1;
        }
    }
    fn position_constraint(&self, c: &[T], t: T, q: &[T], out: &mut [T]) {
        let first_link: i64 = 0;
        let mut place = 0;
        {
            let slots: [usize; 1] = [3 * (first_link + 0) as usize];
            let link_0_x = q[slots[0] + 0];
            let link_0_phi = q[slots[0] + 2];
            let (sin_link_0_phi, cos_link_0_phi) = T::sin_cos(link_0_phi);
            let difference_7 = T::fused(c[2usize], cos_link_0_phi, -link_0_x);
            let link_0_y = q[slots[0] + 1];
            let difference_11 = T::fused(c[2usize], sin_link_0_phi, -link_0_y);
            out[place] = difference_7;
            place += 1;
            out[place] = difference_11;
            place += 1;
        }
        for at_i in 1..(self.n as i64) {
            let slots: [usize; 2] = [
                3 * (first_link + (at_i - 1)) as usize,
                3 * (first_link + at_i) as usize,
            ];
            let link_i_1_phi = q[slots[0] + 2];
            let (sin_link_i_1_phi, cos_link_i_1_phi) = T::sin_cos(link_i_1_phi);
            let link_i_phi = q[slots[1] + 2];
            let (sin_link_i_phi, cos_link_i_phi) = T::sin_cos(link_i_phi);
            let sum_6 = cos_link_i_1_phi + cos_link_i_phi;
            let link_i_1_x = q[slots[0] + 0];
            let sum_10 = T::fused(sum_6, c[2usize], link_i_1_x);
            let link_i_x = q[slots[1] + 0];
            let difference_12 = sum_10 - link_i_x;
            let sum_15 = sin_link_i_1_phi + sin_link_i_phi;
            let link_i_1_y = q[slots[0] + 1];
            let sum_18 = T::fused(c[2usize], sum_15, link_i_1_y);
            let link_i_y = q[slots[1] + 1];
            let difference_20 = sum_18 - link_i_y;
            out[place] = difference_12;
            place += 1;
            out[place] = difference_20;
            place += 1;
        }
    }
    fn velocity_constraint(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
        let first_link: i64 = 0;
        let mut place = 0;
        {
            let slots: [usize; 1] = [3 * (first_link + 0) as usize];
            let link_0_vx = v[slots[0] + 0];
            let link_0_omega = v[slots[0] + 2];
            let c2_link_0_omega = c[2usize] * link_0_omega;
            let link_0_phi = q[slots[0] + 2];
            let (sin_link_0_phi, cos_link_0_phi) = T::sin_cos(link_0_phi);
            let sum_9 = T::fused(c2_link_0_omega, sin_link_0_phi, link_0_vx);
            let link_0_vy = v[slots[0] + 1];
            let difference_13 = T::fused(c2_link_0_omega, cos_link_0_phi, -link_0_vy);
            let value_14 = -sum_9;
            out[place] = value_14;
            place += 1;
            out[place] = difference_13;
            place += 1;
        }
        for at_i in 1..(self.n as i64) {
            let slots: [usize; 2] = [
                3 * (first_link + (at_i - 1)) as usize,
                3 * (first_link + at_i) as usize,
            ];
            let link_i_1_omega = v[slots[0] + 2];
            let link_i_1_phi = q[slots[0] + 2];
            let (sin_link_i_1_phi, cos_link_i_1_phi) = T::sin_cos(link_i_1_phi);
            let product_5 = link_i_1_omega * sin_link_i_1_phi;
            let link_i_omega = v[slots[1] + 2];
            let link_i_phi = q[slots[1] + 2];
            let (sin_link_i_phi, cos_link_i_phi) = T::sin_cos(link_i_phi);
            let sum_10 = T::fused(link_i_omega, sin_link_i_phi, product_5);
            let link_i_1_vx = v[slots[0] + 0];
            let difference_14 = T::fused(-sum_10, c[2usize], link_i_1_vx);
            let link_i_vx = v[slots[1] + 0];
            let difference_16 = difference_14 - link_i_vx;
            let product_18 = link_i_1_omega * cos_link_i_1_phi;
            let sum_21 = T::fused(link_i_omega, cos_link_i_phi, product_18);
            let link_i_1_vy = v[slots[0] + 1];
            let sum_24 = T::fused(c[2usize], sum_21, link_i_1_vy);
            let link_i_vy = v[slots[1] + 1];
            let difference_26 = sum_24 - link_i_vy;
            out[place] = difference_16;
            place += 1;
            out[place] = difference_26;
            place += 1;
        }
    }
    fn velocity_jacobian(&self, c: &[T], t: T, q: &[T], out: &mut [T]) {
        let first_link: i64 = 0;
        let mut place = 0;
        {
            let slots: [usize; 1] = [3 * (first_link + 0) as usize];
            let link_0_phi = q[slots[0] + 2];
            let (sin_link_0_phi, cos_link_0_phi) = T::sin_cos(link_0_phi);
            let c2_sin_link_0_phi = c[2usize] * sin_link_0_phi;
            let c2_cos_link_0_phi = c[2usize] * cos_link_0_phi;
            let value_7 = -T::from_f64(1f64);
            let value_8 = -c2_sin_link_0_phi;
            out[place] = value_7;
            place += 1;
            out[place] = value_8;
            place += 1;
            out[place] = value_7;
            place += 1;
            out[place] = c2_cos_link_0_phi;
            place += 1;
        }
        for at_i in 1..(self.n as i64) {
            let slots: [usize; 2] = [
                3 * (first_link + (at_i - 1)) as usize,
                3 * (first_link + at_i) as usize,
            ];
            let link_i_1_phi = q[slots[0] + 2];
            let (sin_link_i_1_phi, cos_link_i_1_phi) = T::sin_cos(link_i_1_phi);
            let c2_sin_link_i_1_phi = c[2usize] * sin_link_i_1_phi;
            let link_i_phi = q[slots[1] + 2];
            let (sin_link_i_phi, cos_link_i_phi) = T::sin_cos(link_i_phi);
            let c2_sin_link_i_phi = c[2usize] * sin_link_i_phi;
            let c2_cos_link_i_1_phi = c[2usize] * cos_link_i_1_phi;
            let c2_cos_link_i_phi = c[2usize] * cos_link_i_phi;
            let value_12 = -c2_sin_link_i_1_phi;
            let value_13 = -T::from_f64(1f64);
            let value_14 = -c2_sin_link_i_phi;
            out[place] = T::from_f64(1f64);
            place += 1;
            out[place] = value_12;
            place += 1;
            out[place] = value_13;
            place += 1;
            out[place] = value_14;
            place += 1;
            out[place] = T::from_f64(1f64);
            place += 1;
            out[place] = c2_cos_link_i_1_phi;
            place += 1;
            out[place] = value_13;
            place += 1;
            out[place] = c2_cos_link_i_phi;
            place += 1;
        }
    }
    fn convective_term(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
        let first_link: i64 = 0;
        let mut place = 0;
        {
            let slots: [usize; 1] = [3 * (first_link + 0) as usize];
            let link_0_omega = v[slots[0] + 2];
            let c2_link_0_omega = c[2usize] * link_0_omega;
            let product_3 = link_0_omega * c2_link_0_omega;
            let link_0_phi = q[slots[0] + 2];
            let (sin_link_0_phi, cos_link_0_phi) = T::sin_cos(link_0_phi);
            let product_3_cos_link_0_phi = product_3 * cos_link_0_phi;
            let product_3_sin_link_0_phi = product_3 * sin_link_0_phi;
            let value_10 = -product_3_cos_link_0_phi;
            let value_11 = -product_3_sin_link_0_phi;
            out[place] = value_10;
            place += 1;
            out[place] = value_11;
            place += 1;
        }
        for at_i in 1..(self.n as i64) {
            let slots: [usize; 2] = [
                3 * (first_link + (at_i - 1)) as usize,
                3 * (first_link + at_i) as usize,
            ];
            let link_i_1_omega = v[slots[0] + 2];
            let product_3 = link_i_1_omega * link_i_1_omega;
            let link_i_1_phi = q[slots[0] + 2];
            let (sin_link_i_1_phi, cos_link_i_1_phi) = T::sin_cos(link_i_1_phi);
            let product_6 = product_3 * cos_link_i_1_phi;
            let link_i_omega = v[slots[1] + 2];
            let product_8 = link_i_omega * link_i_omega;
            let link_i_phi = q[slots[1] + 2];
            let (sin_link_i_phi, cos_link_i_phi) = T::sin_cos(link_i_phi);
            let sum_12 = T::fused(product_8, cos_link_i_phi, product_6);
            let sum_12_c2 = sum_12 * c[2usize];
            let product_16 = product_3 * sin_link_i_1_phi;
            let sum_19 = T::fused(product_8, sin_link_i_phi, product_16);
            let c2_sum_19 = c[2usize] * sum_19;
            let value_21 = -sum_12_c2;
            let value_22 = -c2_sum_19;
            out[place] = value_21;
            place += 1;
            out[place] = value_22;
            place += 1;
        }
    }
    fn applied_force(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
        let first_link: i64 = 0;
        out.fill(T::from_f64(0.0));
        for at_i in 0..(self.n as i64) {
            let slots: [usize; 1] = [3 * (first_link + at_i) as usize];
            let value_1 = -c[3usize];
            out[slots[0] + 1] = out[slots[0] + 1] + value_1;
        }
    }
}
