#[automatically_derived]
impl<T: ezy::Scalar> ezy::Series<T> for Coast {
    fn series_size(&self) -> ezy::SeriesSize {
        ezy::SeriesSize {
            n_coordinates: 6usize,
            n_rows: 4usize,
            n_products: 16usize,
            n_base: 8usize,
            n_kept: 0usize,
        }
    }
    fn begin(&self, c: &[T], t: T, store: &mut ezy::SeriesStore<T>) -> ezy::Pivots {
        let c = ezy::array::<46usize, T>(c);
        let q = ezy::row::<6usize, T>(&store.q, 0);
        let v = ezy::row::<6usize, T>(&store.q, 1);
        let b = c[4usize];
        let seat_phi = q[2usize];
        let bar_phi = q[5usize];
        let [(sin_seat_phi, cos_seat_phi), (sin_bar_phi, cos_bar_phi)] = T::sin_cos_of([
            seat_phi,
            bar_phi,
        ]);
        let d = c[5usize];
        let seat_omega = v[2usize];
        let seat_omega_b_seat_omega = seat_omega * (b * seat_omega);
        let bar_omega = v[5usize];
        let bar_omega_d_bar_omega = bar_omega * (d * bar_omega);
        let sum_32 = T::fused(
            cos_bar_phi,
            bar_omega_d_bar_omega,
            cos_seat_phi * seat_omega_b_seat_omega,
        );
        let sum_35 = T::fused(
            sin_bar_phi,
            bar_omega_d_bar_omega,
            sin_seat_phi * seat_omega_b_seat_omega,
        );
        let seat_vx = v[0usize];
        let seat_vy = v[1usize];
        let product_41 = seat_omega
            * T::fused(sin_seat_phi, seat_vy, cos_seat_phi * seat_vx);
        let bar_vx = v[3usize];
        let bar_vy = v[4usize];
        let product_47 = bar_omega * T::fused(sin_bar_phi, bar_vy, cos_bar_phi * bar_vx);
        let k42 = c[0usize];
        let k47 = c[1usize];
        let sum_80 = T::fused(
            cos_bar_phi,
            cos_bar_phi * k47,
            cos_seat_phi * (cos_seat_phi * k42),
        );
        let k46 = c[2usize];
        let A_B_x_B_x = sum_80 + k46;
        let A_B_x_B_y = T::fused(
            cos_bar_phi,
            sin_bar_phi * k47,
            cos_seat_phi * (sin_seat_phi * k42),
        );
        let one_over_m1_plus_one_over_m2 = c[3usize];
        let A_B_y_B_y = one_over_m1_plus_one_over_m2 - sum_80;
        let pivot_B_x_B_y = T::fused(-A_B_x_B_y, A_B_x_B_y, A_B_x_B_x * A_B_y_B_y);
        let one_over_pivot_B_x_B_y = T::from_f64(1f64) / pivot_B_x_B_y;
        let k34 = c[16usize];
        let k53 = c[17usize];
        let k37 = c[18usize];
        let k54 = c[19usize];
        let k57 = c[20usize];
        let cos_seat_phi_seat_omega = cos_seat_phi * seat_omega;
        let sin_seat_phi_seat_omega = sin_seat_phi * seat_omega;
        let cos_bar_phi_bar_omega = cos_bar_phi * bar_omega;
        let sin_bar_phi_bar_omega = sin_bar_phi * bar_omega;
        let value_181 = -sin_seat_phi_seat_omega;
        let value_182 = -sin_bar_phi_bar_omega;
        let target = ezy::array_mut::<8usize, T>(&mut store.base);
        target[0usize] = cos_seat_phi;
        target[1usize] = sin_seat_phi;
        target[2usize] = cos_bar_phi;
        target[3usize] = sin_bar_phi;
        target[4usize] = one_over_pivot_B_x_B_y;
        target[5usize] = A_B_y_B_y;
        target[6usize] = A_B_x_B_y;
        target[7usize] = A_B_x_B_x;
        let target = ezy::array_mut::<6usize, T>(&mut store.force);
        target[0usize] = T::from_f64(0f64);
        target[1usize] = T::from_f64(0f64);
        target[2usize] = T::from_f64(0f64);
        target[3usize] = T::from_f64(0f64);
        target[4usize] = T::from_f64(0f64);
        target[5usize] = T::from_f64(0f64);
        let target = ezy::row_mut::<16usize, T>(&mut store.left, 1);
        target[0usize] = cos_seat_phi_seat_omega;
        target[1usize] = value_181;
        target[2usize] = cos_seat_phi_seat_omega;
        target[3usize] = value_181;
        target[4usize] = cos_bar_phi_bar_omega;
        target[5usize] = value_182;
        target[6usize] = cos_bar_phi_bar_omega;
        target[7usize] = value_182;
        target[8usize] = seat_omega;
        target[9usize] = bar_omega;
        target[10usize] = seat_omega;
        target[11usize] = bar_omega;
        target[12usize] = cos_seat_phi_seat_omega;
        target[13usize] = value_181;
        target[14usize] = cos_bar_phi_bar_omega;
        target[15usize] = value_182;
        let target = ezy::row_mut::<16usize, T>(&mut store.right, 1);
        target[0usize] = T::from_f64(0f64);
        target[1usize] = T::from_f64(0f64);
        target[2usize] = T::from_f64(0f64);
        target[3usize] = T::from_f64(0f64);
        target[4usize] = T::from_f64(0f64);
        target[5usize] = T::from_f64(0f64);
        target[6usize] = T::from_f64(0f64);
        target[7usize] = T::from_f64(0f64);
        target[8usize] = cos_seat_phi_seat_omega;
        target[9usize] = cos_bar_phi_bar_omega;
        target[10usize] = value_181;
        target[11usize] = value_182;
        target[12usize] = seat_vx;
        target[13usize] = seat_vy;
        target[14usize] = bar_vx;
        target[15usize] = bar_vy;
        let target = ezy::array_mut::<4usize, T>(&mut store.row);
        target[0usize] = sum_32;
        target[1usize] = sum_35;
        target[2usize] = product_41;
        target[3usize] = product_47;
        ezy::Pivots::new()
            .see(&[2usize], T::least_ratio(k34, k53))
            .see(&[3usize], T::least_ratio(k37, k54))
            .see(&[0usize, 1usize], T::least_ratio(pivot_B_x_B_y, k57))
    }
    #[inline(always)]
    fn right_side(&self, c: &[T], k: usize, store: &mut ezy::SeriesStore<T>) {
        let c = ezy::array::<46usize, T>(c);
        let sums = ezy::array::<16usize, T>(&store.sums);
        let convolved_0 = sums[0usize];
        let convolved_1 = sums[1usize];
        let b = c[4usize];
        let convolved_2 = sums[2usize];
        let convolved_3 = sums[3usize];
        let difference_9 = T::fused(-b, convolved_3, b * convolved_2);
        let convolved_4 = sums[4usize];
        let convolved_5 = sums[5usize];
        let d = c[5usize];
        let convolved_6 = sums[6usize];
        let convolved_7 = sums[7usize];
        let difference_17 = T::fused(-d, convolved_7, d * convolved_6);
        let convolved_8 = sums[8usize];
        let inverse_order_ahead = T::from_f64(1f64) / T::from_f64((k + 2) as f64);
        let convolved_9 = sums[9usize];
        let sum_25 = T::fused(
            d,
            inverse_order_ahead * convolved_9,
            b * (convolved_8 * inverse_order_ahead),
        );
        let order_next = T::from_f64((k + 1) as f64);
        let order_ahead = T::from_f64((k + 2) as f64);
        let order_next_order_ahead = order_next * order_ahead;
        let product_29 = sum_25 * order_next_order_ahead;
        let convolved_10 = sums[10usize];
        let convolved_11 = sums[11usize];
        let sum_36 = T::fused(
            d,
            inverse_order_ahead * convolved_11,
            b * (inverse_order_ahead * convolved_10),
        );
        let convolved_12 = sums[12usize];
        let convolved_13 = sums[13usize];
        let product_41 = order_next * (convolved_12 - convolved_13);
        let convolved_14 = sums[14usize];
        let convolved_15 = sums[15usize];
        let product_45 = order_next * (convolved_14 - convolved_15);
        let value_46 = -convolved_1;
        let value_47 = -convolved_5;
        let value_48 = -(order_next_order_ahead * sum_36);
        let target = ezy::array_mut::<6usize, T>(&mut store.force);
        target[0usize] = convolved_0;
        target[1usize] = value_46;
        target[2usize] = difference_9;
        target[3usize] = convolved_4;
        target[4usize] = value_47;
        target[5usize] = difference_17;
        let target = ezy::array_mut::<4usize, T>(&mut store.row);
        target[0usize] = product_29;
        target[1usize] = value_48;
        target[2usize] = product_41;
        target[3usize] = product_45;
    }
    #[inline(always)]
    fn solve(&self, c: &[T], k: usize, store: &mut ezy::SeriesStore<T>) {
        let c = ezy::array::<46usize, T>(c);
        let base = ezy::array::<8usize, T>(&store.base);
        let force = ezy::array::<6usize, T>(&store.force);
        let row = ezy::array::<4usize, T>(&store.row);
        let one_over_m1 = c[10usize];
        let force_0 = force[0usize];
        let base_4 = base[4usize];
        let base_5 = base[5usize];
        let base_1 = base[1usize];
        let force_2 = force[2usize];
        let b_over_i1 = c[11usize];
        let base_0 = base[0usize];
        let force_1 = force[1usize];
        let product_14 = one_over_m1 * T::fused(-force_0, base_1, base_0 * force_1);
        let a_over_i1 = c[12usize];
        let row_2 = row[2usize];
        let right_side_rear = T::fused(-force_2, a_over_i1, product_14) - row_2;
        let k39 = c[6usize];
        let sum_22 = T::fused(right_side_rear, k39, force_2 * b_over_i1);
        let base_3 = base[3usize];
        let force_5 = force[5usize];
        let d_over_i2 = c[14usize];
        let base_2 = base[2usize];
        let force_4 = force[4usize];
        let force_3 = force[3usize];
        let one_over_m2 = c[13usize];
        let product_35 = T::fused(-base_3, force_3, base_2 * force_4) * one_over_m2;
        let c_over_i2 = c[15usize];
        let row_3 = row[3usize];
        let right_side_front = T::fused(force_5, c_over_i2, product_35) - row_3;
        let k44 = c[7usize];
        let sum_43 = T::fused(right_side_front, k44, force_5 * d_over_i2);
        let difference_46 = T::fused(
            one_over_m1,
            force_0,
            -T::fused(base_3, sum_43, base_1 * sum_22),
        );
        let row_0 = row[0usize];
        let difference_50 = T::fused(-force_3, one_over_m2, difference_46) - row_0;
        let base_6 = base[6usize];
        let sum_57 = T::fused(
            one_over_m1,
            force_1,
            T::fused(base_2, sum_43, base_0 * sum_22),
        );
        let row_1 = row[1usize];
        let difference_61 = T::fused(-force_4, one_over_m2, sum_57) - row_1;
        let lambda_B_x = base_4
            * T::fused(-base_6, difference_61, base_5 * difference_50);
        let base_7 = base[7usize];
        let lambda_B_y = base_4
            * T::fused(-difference_50, base_6, difference_61 * base_7);
        let difference_73 = T::fused(-base_1, lambda_B_x, base_0 * lambda_B_y);
        let k38 = c[9usize];
        let lambda_rear = T::fused(right_side_rear, k38, k39 * difference_73);
        let product_80 = one_over_m1
            * T::fused(base_1, lambda_rear, force_0 - lambda_B_x);
        let product_84 = one_over_m1
            * T::fused(-base_0, lambda_rear, force_1 - lambda_B_y);
        let one_over_i1 = c[23usize];
        let sum_90 = T::fused(
            a_over_i1,
            lambda_rear,
            T::fused(-b_over_i1, difference_73, force_2 * one_over_i1),
        );
        let difference_94 = T::fused(-base_3, lambda_B_x, base_2 * lambda_B_y);
        let k43 = c[8usize];
        let lambda_front = T::fused(right_side_front, k43, k44 * difference_94);
        let product_101 = one_over_m2
            * T::fused(base_3, lambda_front, force_3 + lambda_B_x);
        let product_105 = one_over_m2
            * T::fused(-base_2, lambda_front, force_4 + lambda_B_y);
        let one_over_i2 = c[24usize];
        let difference_111 = T::fused(
            -c_over_i2,
            lambda_front,
            T::fused(-d_over_i2, difference_94, force_5 * one_over_i2),
        );
        let target = ezy::array_mut::<6usize, T>(&mut store.a);
        target[0usize] = product_80;
        target[1usize] = product_84;
        target[2usize] = sum_90;
        target[3usize] = product_101;
        target[4usize] = product_105;
        target[5usize] = difference_111;
        let target = ezy::row_mut::<4usize, T>(&mut store.lambda, k + 0);
        target[0usize] = lambda_B_x;
        target[1usize] = lambda_B_y;
        target[2usize] = lambda_rear;
        target[3usize] = lambda_front;
    }
    #[inline(always)]
    fn finish(&self, c: &[T], k: usize, store: &mut ezy::SeriesStore<T>) {
        let a = ezy::array::<6usize, T>(&store.a);
        let base = ezy::array::<8usize, T>(&store.base);
        let lambda_0 = ezy::row::<4usize, T>(&store.lambda, k + 0);
        let sums = ezy::array::<16usize, T>(&store.sums);
        let a_0 = a[0usize];
        let inverse_order_next = T::from_f64(1f64) / T::from_f64((k + 1) as f64);
        let inverse_order_ahead = T::from_f64(1f64) / T::from_f64((k + 2) as f64);
        let product_3 = inverse_order_next * inverse_order_ahead;
        let product_4 = a_0 * product_3;
        let a_1 = a[1usize];
        let product_6 = product_3 * a_1;
        let a_2 = a[2usize];
        let product_8 = product_3 * a_2;
        let a_3 = a[3usize];
        let product_10 = product_3 * a_3;
        let a_4 = a[4usize];
        let product_12 = product_3 * a_4;
        let a_5 = a[5usize];
        let product_14 = product_3 * a_5;
        let lambda_2 = lambda_0[2usize];
        let convolved_10 = sums[10usize];
        let base_0 = base[0usize];
        let sum_22 = T::fused(product_8, base_0, inverse_order_ahead * convolved_10);
        let convolved_8 = sums[8usize];
        let base_1 = base[1usize];
        let sum_27 = T::fused(product_8, base_1, inverse_order_ahead * convolved_8);
        let lambda_0 = lambda_0[0usize];
        let lambda_1 = lambda_0[1usize];
        let lambda_3 = lambda_0[3usize];
        let convolved_11 = sums[11usize];
        let base_2 = base[2usize];
        let sum_35 = T::fused(product_14, base_2, inverse_order_ahead * convolved_11);
        let convolved_9 = sums[9usize];
        let base_3 = base[3usize];
        let sum_40 = T::fused(product_14, base_3, inverse_order_ahead * convolved_9);
        let order_ahead = T::from_f64((k + 2) as f64);
        let product_42 = product_8 * order_ahead;
        let product_43 = product_14 * order_ahead;
        let product_44 = product_4 * order_ahead;
        let product_45 = product_6 * order_ahead;
        let product_46 = product_10 * order_ahead;
        let product_47 = product_12 * order_ahead;
        let value_48 = -sum_27;
        let value_49 = -sum_40;
        let target = ezy::row_mut::<16usize, T>(&mut store.left, k + 2);
        target[0usize] = sum_22;
        target[1usize] = value_48;
        target[2usize] = sum_22;
        target[3usize] = value_48;
        target[4usize] = sum_35;
        target[5usize] = value_49;
        target[6usize] = sum_35;
        target[7usize] = value_49;
        target[8usize] = product_42;
        target[9usize] = product_43;
        target[10usize] = product_42;
        target[11usize] = product_43;
        target[12usize] = sum_22;
        target[13usize] = value_48;
        target[14usize] = sum_35;
        target[15usize] = value_49;
        let target = ezy::row_mut::<6usize, T>(&mut store.q, k + 2);
        target[0usize] = product_4;
        target[1usize] = product_6;
        target[2usize] = product_8;
        target[3usize] = product_10;
        target[4usize] = product_12;
        target[5usize] = product_14;
        let target = ezy::row_mut::<16usize, T>(&mut store.right, k + 2);
        target[0usize] = lambda_2;
        target[1usize] = lambda_2;
        target[2usize] = lambda_0;
        target[3usize] = lambda_1;
        target[4usize] = lambda_3;
        target[5usize] = lambda_3;
        target[6usize] = lambda_0;
        target[7usize] = lambda_1;
        target[8usize] = sum_22;
        target[9usize] = sum_35;
        target[10usize] = value_48;
        target[11usize] = value_49;
        target[12usize] = product_44;
        target[13usize] = product_45;
        target[14usize] = product_46;
        target[15usize] = product_47;
    }
}
