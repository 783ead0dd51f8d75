#[automatically_derived]
#[allow(unused_assignments, unused_mut)]
impl<T: ezy::Scalar> ezy::Series<T> for Swing {
    fn series_size(&self) -> ezy::SeriesSize {
        let info = ezy::Scene::info(self);
        let mut size = ezy::SeriesSize {
            n_coordinates: info.n_coordinates(),
            n_rows: info.n_rows(),
            n_products: 0,
            n_base: 0,
            n_kept: 0,
        };
        {
            size.n_products += 4usize;
            size.n_base += 2usize;
        }
        for at_i in 1..(self.n as i64) {
            size.n_products += 8usize;
            size.n_base += 4usize;
        }
        size.n_products = size.n_products.next_multiple_of(ezy::PRODUCT_GROUP);
        size
    }
    fn begin(&self, c: &[T], t: T, store: &mut ezy::SeriesStore<T>) -> ezy::Pivots {
        let first_link: i64 = 0;
        let ezy::SeriesStore {
            q,
            lambda,
            left,
            right,
            sums,
            kept,
            base,
            force,
            row,
            a,
        } = store;
        let (n_q, n_c, n_products) = (force.len(), row.len(), sums.len());
        let n_kept = if n_q == 0 { 0 } else { kept.len() / (q.len() / n_q) };
        let (q, v) = q[..2 * n_q].split_at(n_q);
        force.fill(T::from_f64(0f64));
        let mut row_place = 0;
        let mut product_place = 0;
        let mut base_place = 0;
        {
            let slots: [usize; 1] = [3 * (first_link + 0) as usize];
            let l_over_two = c[2usize];
            let link_0_phi = q[slots[0] + 2];
            let (sin_link_0_phi, cos_link_0_phi) = T::sin_cos(link_0_phi);
            let link_0_omega = v[slots[0] + 2];
            let product_14 = link_0_omega * (l_over_two * link_0_omega);
            let product_15 = cos_link_0_phi * product_14;
            let product_16 = sin_link_0_phi * product_14;
            let cos_link_0_phi_link_0_omega = cos_link_0_phi * link_0_omega;
            let sin_link_0_phi_link_0_omega = sin_link_0_phi * link_0_omega;
            let value_19 = -sin_link_0_phi_link_0_omega;
            base[base_place + 0] = cos_link_0_phi;
            base[base_place + 1] = sin_link_0_phi;
            force[slots[0] + 0] = force[slots[0] + 0] + T::from_f64(0f64);
            force[slots[0] + 1] = force[slots[0] + 1] + T::from_f64(0f64);
            force[slots[0] + 2] = force[slots[0] + 2] + T::from_f64(0f64);
            row[row_place + 0] = product_15;
            row[row_place + 1] = product_16;
            left[1 * n_products + product_place + 0] = cos_link_0_phi_link_0_omega;
            right[1 * n_products + product_place + 0] = T::from_f64(0f64);
            left[1 * n_products + product_place + 1] = value_19;
            right[1 * n_products + product_place + 1] = T::from_f64(0f64);
            left[1 * n_products + product_place + 2] = link_0_omega;
            right[1 * n_products + product_place + 2] = cos_link_0_phi_link_0_omega;
            left[1 * n_products + product_place + 3] = link_0_omega;
            right[1 * n_products + product_place + 3] = value_19;
            row_place += 2usize;
            product_place += 4usize;
            base_place += 2usize;
        }
        for at_i in 1..(self.n as i64) {
            let slots: [usize; 2] = [
                3 * (first_link + (at_i - 1)) as usize,
                3 * (first_link + at_i) as usize,
            ];
            let link_i_1_phi = q[slots[0] + 2];
            let link_i_phi = q[slots[1] + 2];
            let [(sin_link_i_1_phi, cos_link_i_1_phi), (sin_link_i_phi, cos_link_i_phi),
            ] = T::sin_cos_of([link_i_1_phi, link_i_phi]);
            let l_over_two = c[2usize];
            let link_i_1_omega = v[slots[0] + 2];
            let link_i_1_omega_squared = link_i_1_omega * link_i_1_omega;
            let link_i_omega = v[slots[1] + 2];
            let link_i_omega_squared = link_i_omega * link_i_omega;
            let product_28 = l_over_two
                * T::fused(
                    cos_link_i_phi,
                    link_i_omega_squared,
                    cos_link_i_1_phi * link_i_1_omega_squared,
                );
            let product_32 = l_over_two
                * T::fused(
                    sin_link_i_phi,
                    link_i_omega_squared,
                    sin_link_i_1_phi * link_i_1_omega_squared,
                );
            let product_33 = cos_link_i_1_phi * link_i_1_omega;
            let product_34 = sin_link_i_1_phi * link_i_1_omega;
            let cos_link_i_phi_link_i_omega = cos_link_i_phi * link_i_omega;
            let sin_link_i_phi_link_i_omega = sin_link_i_phi * link_i_omega;
            let value_37 = -product_34;
            let value_38 = -sin_link_i_phi_link_i_omega;
            base[base_place + 0] = cos_link_i_1_phi;
            base[base_place + 1] = sin_link_i_1_phi;
            base[base_place + 2] = cos_link_i_phi;
            base[base_place + 3] = sin_link_i_phi;
            force[slots[0] + 0] = force[slots[0] + 0] + T::from_f64(0f64);
            force[slots[0] + 1] = force[slots[0] + 1] + T::from_f64(0f64);
            force[slots[0] + 2] = force[slots[0] + 2] + T::from_f64(0f64);
            force[slots[1] + 0] = force[slots[1] + 0] + T::from_f64(0f64);
            force[slots[1] + 1] = force[slots[1] + 1] + T::from_f64(0f64);
            force[slots[1] + 2] = force[slots[1] + 2] + T::from_f64(0f64);
            row[row_place + 0] = product_28;
            row[row_place + 1] = product_32;
            left[1 * n_products + product_place + 0] = product_33;
            right[1 * n_products + product_place + 0] = T::from_f64(0f64);
            left[1 * n_products + product_place + 1] = value_37;
            right[1 * n_products + product_place + 1] = T::from_f64(0f64);
            left[1 * n_products + product_place + 2] = cos_link_i_phi_link_i_omega;
            right[1 * n_products + product_place + 2] = T::from_f64(0f64);
            left[1 * n_products + product_place + 3] = value_38;
            right[1 * n_products + product_place + 3] = T::from_f64(0f64);
            left[1 * n_products + product_place + 4] = link_i_1_omega;
            right[1 * n_products + product_place + 4] = product_33;
            left[1 * n_products + product_place + 5] = link_i_omega;
            right[1 * n_products + product_place + 5] = cos_link_i_phi_link_i_omega;
            left[1 * n_products + product_place + 6] = link_i_1_omega;
            right[1 * n_products + product_place + 6] = value_37;
            left[1 * n_products + product_place + 7] = link_i_omega;
            right[1 * n_products + product_place + 7] = value_38;
            row_place += 2usize;
            product_place += 8usize;
            base_place += 4usize;
        }
        for at_i in 0..(self.n as i64) {
            let slots: [usize; 1] = [3 * (first_link + at_i) as usize];
            let m_g = c[3usize];
            let value_1 = -m_g;
            force[slots[0] + 1] = force[slots[0] + 1] + value_1;
        }
        ezy::Pivots::ALL_VANISHED
    }
    fn right_side(&self, c: &[T], k: usize, store: &mut ezy::SeriesStore<T>) {
        let first_link: i64 = 0;
        let ezy::SeriesStore {
            q,
            lambda,
            left,
            right,
            sums,
            kept,
            base,
            force,
            row,
            a,
        } = store;
        let (n_q, n_c, n_products) = (force.len(), row.len(), sums.len());
        let n_kept = if n_q == 0 { 0 } else { kept.len() / (q.len() / n_q) };
        force.fill(T::from_f64(0f64));
        let mut row_place = 0;
        let mut product_place = 0;
        let mut base_place = 0;
        {
            let slots: [usize; 1] = [3 * (first_link + 0) as usize];
            let l_over_two = c[2usize];
            let convolved_0 = sums[product_place + 0];
            let convolved_1 = sums[product_place + 1];
            let difference_6 = T::fused(
                -l_over_two,
                convolved_1,
                l_over_two * convolved_0,
            );
            let convolved_2 = sums[product_place + 2];
            let inverse_order_ahead = T::from_f64(1f64) / T::from_f64((k + 2) as f64);
            let order_next = T::from_f64((k + 1) as f64);
            let order_ahead = T::from_f64((k + 2) as f64);
            let order_next_order_ahead = order_next * order_ahead;
            let product_14 = l_over_two * (convolved_2 * inverse_order_ahead)
                * order_next_order_ahead;
            let convolved_3 = sums[product_place + 3];
            let product_18 = order_next_order_ahead
                * (l_over_two * (inverse_order_ahead * convolved_3));
            let value_19 = -product_18;
            force[slots[0] + 0] = force[slots[0] + 0] + T::from_f64(0f64);
            force[slots[0] + 1] = force[slots[0] + 1] + T::from_f64(0f64);
            force[slots[0] + 2] = force[slots[0] + 2] + difference_6;
            row[row_place + 0] = product_14;
            row[row_place + 1] = value_19;
            row_place += 2usize;
            product_place += 4usize;
            base_place += 2usize;
        }
        for at_i in 1..(self.n as i64) {
            let slots: [usize; 2] = [
                3 * (first_link + (at_i - 1)) as usize,
                3 * (first_link + at_i) as usize,
            ];
            let l_over_two = c[2usize];
            let convolved_0 = sums[product_place + 0];
            let convolved_1 = sums[product_place + 1];
            let difference_6 = T::fused(
                -l_over_two,
                convolved_1,
                l_over_two * convolved_0,
            );
            let convolved_2 = sums[product_place + 2];
            let convolved_3 = sums[product_place + 3];
            let difference_11 = T::fused(
                -l_over_two,
                convolved_3,
                l_over_two * convolved_2,
            );
            let convolved_4 = sums[product_place + 4];
            let inverse_order_ahead = T::from_f64(1f64) / T::from_f64((k + 2) as f64);
            let convolved_5 = sums[product_place + 5];
            let product_18 = l_over_two
                * T::fused(
                    inverse_order_ahead,
                    convolved_5,
                    convolved_4 * inverse_order_ahead,
                );
            let order_next = T::from_f64((k + 1) as f64);
            let order_ahead = T::from_f64((k + 2) as f64);
            let order_next_order_ahead = order_next * order_ahead;
            let product_22 = product_18 * order_next_order_ahead;
            let convolved_6 = sums[product_place + 6];
            let convolved_7 = sums[product_place + 7];
            let product_28 = l_over_two
                * T::fused(
                    inverse_order_ahead,
                    convolved_7,
                    inverse_order_ahead * convolved_6,
                );
            let value_30 = -(order_next_order_ahead * product_28);
            force[slots[0] + 0] = force[slots[0] + 0] + T::from_f64(0f64);
            force[slots[0] + 1] = force[slots[0] + 1] + T::from_f64(0f64);
            force[slots[0] + 2] = force[slots[0] + 2] + difference_6;
            force[slots[1] + 0] = force[slots[1] + 0] + T::from_f64(0f64);
            force[slots[1] + 1] = force[slots[1] + 1] + T::from_f64(0f64);
            force[slots[1] + 2] = force[slots[1] + 2] + difference_11;
            row[row_place + 0] = product_22;
            row[row_place + 1] = value_30;
            row_place += 2usize;
            product_place += 8usize;
            base_place += 4usize;
        }
        for at_i in 0..(self.n as i64) {
            let slots: [usize; 1] = [3 * (first_link + at_i) as usize];
            force[slots[0] + 1] = force[slots[0] + 1] + T::from_f64(0f64);
        }
    }
    fn solve(&self, c: &[T], k: usize, store: &mut ezy::SeriesStore<T>) {}
    fn finish(&self, c: &[T], k: usize, store: &mut ezy::SeriesStore<T>) {
        let first_link: i64 = 0;
        let ezy::SeriesStore {
            q,
            lambda,
            left,
            right,
            sums,
            kept,
            base,
            force,
            row,
            a,
        } = store;
        let (n_q, n_c, n_products) = (force.len(), row.len(), sums.len());
        let n_kept = if n_q == 0 { 0 } else { kept.len() / (q.len() / n_q) };
        let inverse = T::from_f64(1f64) / T::from_f64(((k + 1) * (k + 2)) as f64);
        q[(k + 2) * n_q..(k + 3) * n_q]
            .iter_mut()
            .zip(a.iter())
            .for_each(|(q, a)| *q = *a * inverse);
        let mut row_place = 0;
        let mut product_place = 0;
        let mut base_place = 0;
        {
            let slots: [usize; 1] = [3 * (first_link + 0) as usize];
            let lambda_0 = lambda[(k + 0) * n_c + row_place + 0];
            let convolved_3 = sums[product_place + 3];
            let inverse_order_ahead = T::from_f64(1f64) / T::from_f64((k + 2) as f64);
            let q_8_ahead = q[(k + 2) * n_q + slots[0] + 2];
            let base_0 = base[base_place + 0];
            let sum_9 = T::fused(q_8_ahead, base_0, convolved_3 * inverse_order_ahead);
            let lambda_1 = lambda[(k + 0) * n_c + row_place + 1];
            let convolved_2 = sums[product_place + 2];
            let base_1 = base[base_place + 1];
            let sum_15 = T::fused(q_8_ahead, base_1, inverse_order_ahead * convolved_2);
            let order_ahead = T::from_f64((k + 2) as f64);
            let q_8_ahead_order_ahead = q_8_ahead * order_ahead;
            let value_18 = -sum_15;
            left[(k + 2) * n_products + product_place + 0] = sum_9;
            right[(k + 2) * n_products + product_place + 0] = lambda_0;
            left[(k + 2) * n_products + product_place + 1] = value_18;
            right[(k + 2) * n_products + product_place + 1] = lambda_1;
            left[(k + 2) * n_products + product_place + 2] = q_8_ahead_order_ahead;
            right[(k + 2) * n_products + product_place + 2] = sum_9;
            left[(k + 2) * n_products + product_place + 3] = q_8_ahead_order_ahead;
            right[(k + 2) * n_products + product_place + 3] = value_18;
            row_place += 2usize;
            product_place += 4usize;
            base_place += 2usize;
        }
        for at_i in 1..(self.n as i64) {
            let slots: [usize; 2] = [
                3 * (first_link + (at_i - 1)) as usize,
                3 * (first_link + at_i) as usize,
            ];
            let lambda_0 = lambda[(k + 0) * n_c + row_place + 0];
            let convolved_6 = sums[product_place + 6];
            let inverse_order_ahead = T::from_f64(1f64) / T::from_f64((k + 2) as f64);
            let q_11_ahead = q[(k + 2) * n_q + slots[0] + 2];
            let base_0 = base[base_place + 0];
            let sum_9 = T::fused(q_11_ahead, base_0, convolved_6 * inverse_order_ahead);
            let lambda_1 = lambda[(k + 0) * n_c + row_place + 1];
            let convolved_4 = sums[product_place + 4];
            let base_1 = base[base_place + 1];
            let sum_15 = T::fused(q_11_ahead, base_1, inverse_order_ahead * convolved_4);
            let convolved_7 = sums[product_place + 7];
            let q_14_ahead = q[(k + 2) * n_q + slots[1] + 2];
            let base_2 = base[base_place + 2];
            let sum_21 = T::fused(q_14_ahead, base_2, inverse_order_ahead * convolved_7);
            let convolved_5 = sums[product_place + 5];
            let base_3 = base[base_place + 3];
            let sum_26 = T::fused(q_14_ahead, base_3, inverse_order_ahead * convolved_5);
            let order_ahead = T::from_f64((k + 2) as f64);
            let q_11_ahead_order_ahead = q_11_ahead * order_ahead;
            let q_14_ahead_order_ahead = q_14_ahead * order_ahead;
            let value_30 = -sum_15;
            let value_31 = -sum_26;
            left[(k + 2) * n_products + product_place + 0] = sum_9;
            right[(k + 2) * n_products + product_place + 0] = lambda_0;
            left[(k + 2) * n_products + product_place + 1] = value_30;
            right[(k + 2) * n_products + product_place + 1] = lambda_1;
            left[(k + 2) * n_products + product_place + 2] = sum_21;
            right[(k + 2) * n_products + product_place + 2] = lambda_0;
            left[(k + 2) * n_products + product_place + 3] = value_31;
            right[(k + 2) * n_products + product_place + 3] = lambda_1;
            left[(k + 2) * n_products + product_place + 4] = q_11_ahead_order_ahead;
            right[(k + 2) * n_products + product_place + 4] = sum_9;
            left[(k + 2) * n_products + product_place + 5] = q_14_ahead_order_ahead;
            right[(k + 2) * n_products + product_place + 5] = sum_21;
            left[(k + 2) * n_products + product_place + 6] = q_11_ahead_order_ahead;
            right[(k + 2) * n_products + product_place + 6] = value_30;
            left[(k + 2) * n_products + product_place + 7] = q_14_ahead_order_ahead;
            right[(k + 2) * n_products + product_place + 7] = value_31;
            row_place += 2usize;
            product_place += 8usize;
            base_place += 4usize;
        }
        for at_i in 0..(self.n as i64) {
            let slots: [usize; 1] = [3 * (first_link + at_i) as usize];
        }
    }
}
