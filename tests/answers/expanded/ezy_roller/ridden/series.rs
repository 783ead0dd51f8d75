#[automatically_derived]
impl<T: ::ezy_core::scalar::Scalar> ::ezy_core::model::Series<T> for Ridden {
    fn series_size(&self) -> ::ezy_core::model::SeriesSize {
        ::ezy_core::model::SeriesSize {
            n_coordinates: 6usize,
            n_rows: 4usize,
            n_products: 16usize,
            n_base: 8usize,
            n_kept: 0usize,
        }
    }
    fn begin(
        &self,
        c: &[T],
        t: T,
        store: &mut ::ezy_core::model::SeriesStore<T>,
    ) -> ::ezy_core::model::Pivots {
        let c = ::ezy_core::kernel::array::<34usize, T>(c);
        let q = ::ezy_core::kernel::row::<6usize, T>(&store.q, 0);
        let v = ::ezy_core::kernel::row::<6usize, T>(&store.q, 1);
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
        let seat_omega = v[2usize];
        let c11_seat_omega = c[11usize] * seat_omega;
        let product_26 = seat_omega * c11_seat_omega;
        let cos_seat_phi_product_26 = cos_seat_phi * product_26;
        let bar_omega = v[5usize];
        let c12_bar_omega = c[12usize] * bar_omega;
        let bar_omega_c12_bar_omega = bar_omega * c12_bar_omega;
        let sum_32 = T::fused(
            cos_bar_phi,
            bar_omega_c12_bar_omega,
            cos_seat_phi_product_26,
        );
        let sin_seat_phi_product_26 = sin_seat_phi * product_26;
        let sum_35 = T::fused(
            sin_bar_phi,
            bar_omega_c12_bar_omega,
            sin_seat_phi_product_26,
        );
        let seat_vx = v[0usize];
        let cos_seat_phi_seat_vx = cos_seat_phi * seat_vx;
        let seat_vy = v[1usize];
        let sum_40 = T::fused(sin_seat_phi, seat_vy, cos_seat_phi_seat_vx);
        let seat_omega_sum_40 = seat_omega * sum_40;
        let bar_vx = v[3usize];
        let cos_bar_phi_bar_vx = cos_bar_phi * bar_vx;
        let bar_vy = v[4usize];
        let sum_46 = T::fused(sin_bar_phi, bar_vy, cos_bar_phi_bar_vx);
        let bar_omega_sum_46 = bar_omega * sum_46;
        let torque = c[0usize];
        let cos_seat_phi_c3 = cos_seat_phi * c[3usize];
        let product_77 = cos_seat_phi * cos_seat_phi_c3;
        let cos_bar_phi_c4 = cos_bar_phi * c[4usize];
        let sum_81 = T::fused(cos_bar_phi, cos_bar_phi_c4, product_77);
        let sum_83 = sum_81 + c[5usize];
        let sin_seat_phi_c3 = sin_seat_phi * c[3usize];
        let product_85 = cos_seat_phi * sin_seat_phi_c3;
        let sin_bar_phi_c4 = sin_bar_phi * c[4usize];
        let sum_88 = T::fused(cos_bar_phi, sin_bar_phi_c4, product_85);
        let difference_90 = c[6usize] - sum_81;
        let sum_83_difference_90 = sum_83 * difference_90;
        let difference_121 = T::fused(-sum_88, sum_88, sum_83_difference_90);
        let quotient_122 = T::from_f64(1f64) / difference_121;
        let cos_seat_phi_seat_omega = cos_seat_phi * seat_omega;
        let sin_seat_phi_seat_omega = sin_seat_phi * seat_omega;
        let cos_bar_phi_bar_omega = cos_bar_phi * bar_omega;
        let sin_bar_phi_bar_omega = sin_bar_phi * bar_omega;
        let value_182 = -torque;
        let value_183 = -sin_seat_phi_seat_omega;
        let value_184 = -sin_bar_phi_bar_omega;
        let target = ::ezy_core::kernel::array_mut::<8usize, T>(&mut store.base);
        target[0usize] = cos_seat_phi;
        target[1usize] = sin_seat_phi;
        target[2usize] = cos_bar_phi;
        target[3usize] = sin_bar_phi;
        target[4usize] = quotient_122;
        target[5usize] = difference_90;
        target[6usize] = sum_88;
        target[7usize] = sum_83;
        let target = ::ezy_core::kernel::array_mut::<6usize, T>(&mut store.force);
        target[0usize] = T::from_f64(0f64);
        target[1usize] = T::from_f64(0f64);
        target[2usize] = value_182;
        target[3usize] = T::from_f64(0f64);
        target[4usize] = T::from_f64(0f64);
        target[5usize] = torque;
        let target = ::ezy_core::kernel::row_mut::<16usize, T>(&mut store.left, 1usize);
        target[0usize] = cos_seat_phi_seat_omega;
        target[1usize] = value_183;
        target[2usize] = cos_seat_phi_seat_omega;
        target[3usize] = value_183;
        target[4usize] = cos_bar_phi_bar_omega;
        target[5usize] = value_184;
        target[6usize] = cos_bar_phi_bar_omega;
        target[7usize] = value_184;
        target[8usize] = seat_omega;
        target[9usize] = bar_omega;
        target[10usize] = seat_omega;
        target[11usize] = bar_omega;
        target[12usize] = cos_seat_phi_seat_omega;
        target[13usize] = value_183;
        target[14usize] = cos_bar_phi_bar_omega;
        target[15usize] = value_184;
        let target = ::ezy_core::kernel::row_mut::<16usize, T>(&mut store.right, 1usize);
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
        target[10usize] = value_183;
        target[11usize] = value_184;
        target[12usize] = seat_vx;
        target[13usize] = seat_vy;
        target[14usize] = bar_vx;
        target[15usize] = bar_vy;
        let target = ::ezy_core::kernel::array_mut::<4usize, T>(&mut store.row);
        target[0usize] = sum_32;
        target[1usize] = sum_35;
        target[2usize] = seat_omega_sum_40;
        target[3usize] = bar_omega_sum_46;
        ::ezy_core::model::Pivots::new()
            .see(&[2usize], T::least_ratio(c[19usize], c[20usize]))
            .see(&[3usize], T::least_ratio(c[21usize], c[22usize]))
            .see(&[0usize, 1usize], T::least_ratio(difference_121, c[23usize]))
    }
    #[inline(always)]
    fn right_side(
        &self,
        c: &[T],
        k: usize,
        store: &mut ::ezy_core::model::SeriesStore<T>,
    ) {
        let c = ::ezy_core::kernel::array::<34usize, T>(c);
        let sums = ::ezy_core::kernel::array::<16usize, T>(&store.sums);
        let convolved_0 = sums[0usize];
        let convolved_1 = sums[1usize];
        let convolved_2 = sums[2usize];
        let c11_convolved_2 = c[11usize] * convolved_2;
        let convolved_3 = sums[3usize];
        let difference_9 = T::fused(-c[11usize], convolved_3, c11_convolved_2);
        let convolved_4 = sums[4usize];
        let convolved_5 = sums[5usize];
        let convolved_6 = sums[6usize];
        let c12_convolved_6 = c[12usize] * convolved_6;
        let convolved_7 = sums[7usize];
        let difference_17 = T::fused(-c[12usize], convolved_7, c12_convolved_6);
        let convolved_8 = sums[8usize];
        let inverse_order_ahead = T::from_f64(1f64) / T::from_f64((k + 2usize) as f64);
        let product_20 = convolved_8 * inverse_order_ahead;
        let c11_product_20 = c[11usize] * product_20;
        let convolved_9 = sums[9usize];
        let product_23 = inverse_order_ahead * convolved_9;
        let sum_25 = T::fused(c[12usize], product_23, c11_product_20);
        let order_next = T::from_f64((k + 1usize) as f64);
        let order_ahead = T::from_f64((k + 2usize) as f64);
        let order_next_order_ahead = order_next * order_ahead;
        let product_29 = sum_25 * order_next_order_ahead;
        let convolved_10 = sums[10usize];
        let product_31 = inverse_order_ahead * convolved_10;
        let c11_product_31 = c[11usize] * product_31;
        let convolved_11 = sums[11usize];
        let product_34 = inverse_order_ahead * convolved_11;
        let sum_36 = T::fused(c[12usize], product_34, c11_product_31);
        let product_37 = order_next_order_ahead * sum_36;
        let convolved_12 = sums[12usize];
        let convolved_13 = sums[13usize];
        let difference_40 = convolved_12 - convolved_13;
        let order_next_difference_40 = order_next * difference_40;
        let convolved_14 = sums[14usize];
        let convolved_15 = sums[15usize];
        let difference_44 = convolved_14 - convolved_15;
        let order_next_difference_44 = order_next * difference_44;
        let value_46 = -convolved_1;
        let value_47 = -convolved_5;
        let value_48 = -product_37;
        let target = ::ezy_core::kernel::array_mut::<6usize, T>(&mut store.force);
        target[0usize] = convolved_0;
        target[1usize] = value_46;
        target[2usize] = difference_9;
        target[3usize] = convolved_4;
        target[4usize] = value_47;
        target[5usize] = difference_17;
        let target = ::ezy_core::kernel::array_mut::<4usize, T>(&mut store.row);
        target[0usize] = product_29;
        target[1usize] = value_48;
        target[2usize] = order_next_difference_40;
        target[3usize] = order_next_difference_44;
    }
    #[inline(always)]
    fn solve(&self, c: &[T], k: usize, store: &mut ::ezy_core::model::SeriesStore<T>) {
        let c = ::ezy_core::kernel::array::<34usize, T>(c);
        let base = ::ezy_core::kernel::array::<8usize, T>(&store.base);
        let force = ::ezy_core::kernel::array::<6usize, T>(&store.force);
        let row = ::ezy_core::kernel::array::<4usize, T>(&store.row);
        let force_0 = force[0usize];
        let base_4 = base[4usize];
        let base_5 = base[5usize];
        let base_1 = base[1usize];
        let force_2 = force[2usize];
        let force_2_c7 = force_2 * c[7usize];
        let base_0 = base[0usize];
        let force_1 = force[1usize];
        let base_0_force_1 = base_0 * force_1;
        let difference_13 = T::fused(-force_0, base_1, base_0_force_1);
        let c15_difference_13 = c[15usize] * difference_13;
        let difference_17 = T::fused(-force_2, c[1usize], c15_difference_13);
        let row_2 = row[2usize];
        let right_side_rear = difference_17 - row_2;
        let sum_22 = T::fused(right_side_rear, c[8usize], force_2_c7);
        let base_1_sum_22 = base_1 * sum_22;
        let base_3 = base[3usize];
        let force_5 = force[5usize];
        let force_5_c9 = force_5 * c[9usize];
        let base_2 = base[2usize];
        let force_4 = force[4usize];
        let base_2_force_4 = base_2 * force_4;
        let force_3 = force[3usize];
        let difference_33 = T::fused(-base_3, force_3, base_2_force_4);
        let difference_33_c17 = difference_33 * c[17usize];
        let sum_38 = T::fused(force_5, c[2usize], difference_33_c17);
        let row_3 = row[3usize];
        let right_side_front = sum_38 - row_3;
        let sum_43 = T::fused(right_side_front, c[10usize], force_5_c9);
        let sum_45 = T::fused(base_3, sum_43, base_1_sum_22);
        let difference_46 = T::fused(c[15usize], force_0, -sum_45);
        let difference_48 = T::fused(-force_3, c[17usize], difference_46);
        let row_0 = row[0usize];
        let difference_50 = difference_48 - row_0;
        let base_5_difference_50 = base_5 * difference_50;
        let base_6 = base[6usize];
        let base_0_sum_22 = base_0 * sum_22;
        let sum_55 = T::fused(base_2, sum_43, base_0_sum_22);
        let sum_57 = T::fused(c[15usize], force_1, sum_55);
        let difference_59 = T::fused(-force_4, c[17usize], sum_57);
        let row_1 = row[1usize];
        let difference_61 = difference_59 - row_1;
        let difference_63 = T::fused(-base_6, difference_61, base_5_difference_50);
        let lambda_B_x = base_4 * difference_63;
        let difference_65 = force_0 - lambda_B_x;
        let base_7 = base[7usize];
        let difference_61_base_7 = difference_61 * base_7;
        let difference_69 = T::fused(-difference_50, base_6, difference_61_base_7);
        let lambda_B_y = base_4 * difference_69;
        let base_0_lambda_B_y = base_0 * lambda_B_y;
        let difference_73 = T::fused(-base_1, lambda_B_x, base_0_lambda_B_y);
        let c8_difference_73 = c[8usize] * difference_73;
        let lambda_rear = T::fused(right_side_rear, c[14usize], c8_difference_73);
        let sum_79 = T::fused(base_1, lambda_rear, difference_65);
        let c15_sum_79 = c[15usize] * sum_79;
        let difference_81 = force_1 - lambda_B_y;
        let difference_83 = T::fused(-base_0, lambda_rear, difference_81);
        let c15_difference_83 = c[15usize] * difference_83;
        let force_2_c16 = force_2 * c[16usize];
        let difference_88 = T::fused(-c[7usize], difference_73, force_2_c16);
        let sum_90 = T::fused(c[1usize], lambda_rear, difference_88);
        let sum_91 = force_3 + lambda_B_x;
        let base_2_lambda_B_y = base_2 * lambda_B_y;
        let difference_94 = T::fused(-base_3, lambda_B_x, base_2_lambda_B_y);
        let c10_difference_94 = c[10usize] * difference_94;
        let lambda_front = T::fused(right_side_front, c[13usize], c10_difference_94);
        let sum_100 = T::fused(base_3, lambda_front, sum_91);
        let c17_sum_100 = c[17usize] * sum_100;
        let sum_102 = force_4 + lambda_B_y;
        let difference_104 = T::fused(-base_2, lambda_front, sum_102);
        let c17_difference_104 = c[17usize] * difference_104;
        let force_5_c18 = force_5 * c[18usize];
        let difference_109 = T::fused(-c[9usize], difference_94, force_5_c18);
        let difference_111 = T::fused(-c[2usize], lambda_front, difference_109);
        let target = ::ezy_core::kernel::array_mut::<6usize, T>(&mut store.a);
        target[0usize] = c15_sum_79;
        target[1usize] = c15_difference_83;
        target[2usize] = sum_90;
        target[3usize] = c17_sum_100;
        target[4usize] = c17_difference_104;
        target[5usize] = difference_111;
        let target = ::ezy_core::kernel::row_mut::<
            4usize,
            T,
        >(&mut store.lambda, k + 0usize);
        target[0usize] = lambda_B_x;
        target[1usize] = lambda_B_y;
        target[2usize] = lambda_rear;
        target[3usize] = lambda_front;
    }
    #[inline(always)]
    fn finish(&self, c: &[T], k: usize, store: &mut ::ezy_core::model::SeriesStore<T>) {
        let a = ::ezy_core::kernel::array::<6usize, T>(&store.a);
        let base = ::ezy_core::kernel::array::<8usize, T>(&store.base);
        let lambda_0 = ::ezy_core::kernel::row::<4usize, T>(&store.lambda, k + 0usize);
        let sums = ::ezy_core::kernel::array::<16usize, T>(&store.sums);
        let a_0 = a[0usize];
        let inverse_order_next = T::from_f64(1f64) / T::from_f64((k + 1usize) as f64);
        let inverse_order_ahead = T::from_f64(1f64) / T::from_f64((k + 2usize) as f64);
        let product_3 = inverse_order_next * inverse_order_ahead;
        let a_0_product_3 = a_0 * product_3;
        let a_1 = a[1usize];
        let product_3_a_1 = product_3 * a_1;
        let a_2 = a[2usize];
        let product_3_a_2 = product_3 * a_2;
        let a_3 = a[3usize];
        let product_3_a_3 = product_3 * a_3;
        let a_4 = a[4usize];
        let product_3_a_4 = product_3 * a_4;
        let a_5 = a[5usize];
        let product_3_a_5 = product_3 * a_5;
        let lambda_2 = lambda_0[2usize];
        let convolved_10 = sums[10usize];
        let product_19 = inverse_order_ahead * convolved_10;
        let base_0 = base[0usize];
        let sum_22 = T::fused(product_3_a_2, base_0, product_19);
        let convolved_8 = sums[8usize];
        let product_24 = inverse_order_ahead * convolved_8;
        let base_1 = base[1usize];
        let sum_27 = T::fused(product_3_a_2, base_1, product_24);
        let lambda_0 = lambda_0[0usize];
        let lambda_1 = lambda_0[1usize];
        let lambda_3 = lambda_0[3usize];
        let convolved_11 = sums[11usize];
        let product_32 = inverse_order_ahead * convolved_11;
        let base_2 = base[2usize];
        let sum_35 = T::fused(product_3_a_5, base_2, product_32);
        let convolved_9 = sums[9usize];
        let product_37 = inverse_order_ahead * convolved_9;
        let base_3 = base[3usize];
        let sum_40 = T::fused(product_3_a_5, base_3, product_37);
        let order_ahead = T::from_f64((k + 2usize) as f64);
        let product_42 = product_3_a_2 * order_ahead;
        let product_43 = product_3_a_5 * order_ahead;
        let product_44 = a_0_product_3 * order_ahead;
        let product_45 = product_3_a_1 * order_ahead;
        let product_46 = product_3_a_3 * order_ahead;
        let product_47 = product_3_a_4 * order_ahead;
        let value_48 = -sum_27;
        let value_49 = -sum_40;
        let target = ::ezy_core::kernel::row_mut::<
            16usize,
            T,
        >(&mut store.left, k + 2usize);
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
        let target = ::ezy_core::kernel::row_mut::<6usize, T>(&mut store.q, k + 2usize);
        target[0usize] = a_0_product_3;
        target[1usize] = product_3_a_1;
        target[2usize] = product_3_a_2;
        target[3usize] = product_3_a_3;
        target[4usize] = product_3_a_4;
        target[5usize] = product_3_a_5;
        let target = ::ezy_core::kernel::row_mut::<
            16usize,
            T,
        >(&mut store.right, k + 2usize);
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
