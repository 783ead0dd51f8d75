#[automatically_derived]
impl<T: ::ezy_core::scalar::Scalar> ::ezy_core::model::Series<T> for Skid {
    fn series_size(&self) -> ::ezy_core::model::SeriesSize {
        ::ezy_core::model::SeriesSize {
            n_coordinates: 6usize,
            n_rows: 4usize,
            n_products: 16usize,
            n_base: 8usize,
            n_kept: 3usize,
        }
    }
    fn begin(
        &self,
        c: &[T],
        t: T,
        store: &mut ::ezy_core::model::SeriesStore<T>,
    ) -> ::ezy_core::model::Pivots {
        let c = ::ezy_core::kernel::array::<41usize, T>(c);
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
        let bar_vx = v[3usize];
        let cos_bar_phi_bar_vx = cos_bar_phi * bar_vx;
        let bar_vy = v[4usize];
        let sum_40 = T::fused(sin_bar_phi, bar_vy, cos_bar_phi_bar_vx);
        let bar_omega_sum_40 = bar_omega * sum_40;
        let seat_vx = v[0usize];
        let cos_seat_phi_seat_vx = cos_seat_phi * seat_vx;
        let seat_vy = v[1usize];
        let sum_46 = T::fused(sin_seat_phi, seat_vy, cos_seat_phi_seat_vx);
        let seat_omega_sum_46 = seat_omega * sum_46;
        let c1_t = c[1usize] * t;
        let (sin_51, cos_51) = T::sin_cos(c1_t);
        let c28_cos_51 = c[28usize] * cos_51;
        let cos_seat_phi_c3 = cos_seat_phi * c[3usize];
        let product_82 = cos_seat_phi * cos_seat_phi_c3;
        let cos_bar_phi_c4 = cos_bar_phi * c[4usize];
        let sum_86 = T::fused(cos_bar_phi, cos_bar_phi_c4, product_82);
        let sum_88 = sum_86 + c[5usize];
        let sin_seat_phi_c3 = sin_seat_phi * c[3usize];
        let product_90 = cos_seat_phi * sin_seat_phi_c3;
        let sin_bar_phi_c4 = sin_bar_phi * c[4usize];
        let sum_93 = T::fused(cos_bar_phi, sin_bar_phi_c4, product_90);
        let difference_95 = c[6usize] - sum_86;
        let sum_88_difference_95 = sum_88 * difference_95;
        let difference_126 = T::fused(-sum_93, sum_93, sum_88_difference_95);
        let quotient_127 = T::from_f64(1f64) / difference_126;
        let cos_seat_phi_seat_omega = cos_seat_phi * seat_omega;
        let sin_seat_phi_seat_omega = sin_seat_phi * seat_omega;
        let cos_bar_phi_bar_omega = cos_bar_phi * bar_omega;
        let sin_bar_phi_bar_omega = sin_bar_phi * bar_omega;
        let c1_sin_51 = c[1usize] * sin_51;
        let c28_c1_sin_51 = c[28usize] * c1_sin_51;
        let c1_cos_51 = c[1usize] * cos_51;
        let value_191 = -c28_cos_51;
        let value_192 = -sin_seat_phi_seat_omega;
        let value_193 = -sin_bar_phi_bar_omega;
        let value_194 = -c28_c1_sin_51;
        let value_195 = -c1_sin_51;
        let target = ::ezy_core::kernel::array_mut::<8usize, T>(&mut store.base);
        target[0usize] = cos_seat_phi;
        target[1usize] = sin_seat_phi;
        target[2usize] = cos_bar_phi;
        target[3usize] = sin_bar_phi;
        target[4usize] = quotient_127;
        target[5usize] = difference_95;
        target[6usize] = sum_93;
        target[7usize] = sum_88;
        let target = ::ezy_core::kernel::array_mut::<6usize, T>(&mut store.force);
        target[0usize] = T::from_f64(0f64);
        target[1usize] = T::from_f64(0f64);
        target[2usize] = c28_cos_51;
        target[3usize] = T::from_f64(0f64);
        target[4usize] = T::from_f64(0f64);
        target[5usize] = value_191;
        let target = ::ezy_core::kernel::row_mut::<3usize, T>(&mut store.kept, 0usize);
        target[0usize] = c28_cos_51;
        target[1usize] = sin_51;
        target[2usize] = cos_51;
        let target = ::ezy_core::kernel::row_mut::<3usize, T>(&mut store.kept, 1usize);
        target[0usize] = value_194;
        target[1usize] = c1_cos_51;
        target[2usize] = value_195;
        let target = ::ezy_core::kernel::row_mut::<16usize, T>(&mut store.left, 1usize);
        target[0usize] = cos_seat_phi_seat_omega;
        target[1usize] = value_192;
        target[2usize] = cos_seat_phi_seat_omega;
        target[3usize] = value_192;
        target[4usize] = cos_bar_phi_bar_omega;
        target[5usize] = value_193;
        target[6usize] = cos_bar_phi_bar_omega;
        target[7usize] = value_193;
        target[8usize] = seat_omega;
        target[9usize] = bar_omega;
        target[10usize] = seat_omega;
        target[11usize] = bar_omega;
        target[12usize] = cos_bar_phi_bar_omega;
        target[13usize] = value_193;
        target[14usize] = cos_seat_phi_seat_omega;
        target[15usize] = value_192;
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
        target[10usize] = value_192;
        target[11usize] = value_193;
        target[12usize] = bar_vx;
        target[13usize] = bar_vy;
        target[14usize] = seat_vx;
        target[15usize] = seat_vy;
        let target = ::ezy_core::kernel::array_mut::<4usize, T>(&mut store.row);
        target[0usize] = sum_32;
        target[1usize] = sum_35;
        target[2usize] = bar_omega_sum_40;
        target[3usize] = seat_omega_sum_46;
        ::ezy_core::model::Pivots::new()
            .see(&[2usize], T::least_ratio(c[23usize], c[24usize]))
            .see(&[3usize], T::least_ratio(c[25usize], c[26usize]))
            .see(&[0usize, 1usize], T::least_ratio(difference_126, c[27usize]))
    }
    #[inline(always)]
    fn right_side(
        &self,
        c: &[T],
        k: usize,
        store: &mut ::ezy_core::model::SeriesStore<T>,
    ) {
        let c = ::ezy_core::kernel::array::<41usize, T>(c);
        let kept_0 = ::ezy_core::kernel::row::<3usize, T>(&store.kept, k + 0usize);
        let sums = ::ezy_core::kernel::array::<16usize, T>(&store.sums);
        let convolved_0 = sums[0usize];
        let convolved_1 = sums[1usize];
        let kept_0 = kept_0[0usize];
        let convolved_2 = sums[2usize];
        let convolved_3 = sums[3usize];
        let c11_convolved_3 = c[11usize] * convolved_3;
        let difference_10 = T::fused(-c[11usize], convolved_2, c11_convolved_3);
        let difference_11 = kept_0 - difference_10;
        let convolved_4 = sums[4usize];
        let convolved_5 = sums[5usize];
        let convolved_6 = sums[6usize];
        let convolved_7 = sums[7usize];
        let c12_convolved_7 = c[12usize] * convolved_7;
        let difference_19 = T::fused(-c[12usize], convolved_6, c12_convolved_7);
        let sum_20 = kept_0 + difference_19;
        let convolved_8 = sums[8usize];
        let inverse_order_ahead = T::from_f64(1f64) / T::from_f64((k + 2usize) as f64);
        let product_23 = convolved_8 * inverse_order_ahead;
        let c11_product_23 = c[11usize] * product_23;
        let convolved_9 = sums[9usize];
        let product_26 = inverse_order_ahead * convolved_9;
        let sum_28 = T::fused(c[12usize], product_26, c11_product_23);
        let order_next = T::from_f64((k + 1usize) as f64);
        let order_ahead = T::from_f64((k + 2usize) as f64);
        let order_next_order_ahead = order_next * order_ahead;
        let product_32 = sum_28 * order_next_order_ahead;
        let convolved_10 = sums[10usize];
        let product_34 = inverse_order_ahead * convolved_10;
        let c11_product_34 = c[11usize] * product_34;
        let convolved_11 = sums[11usize];
        let product_37 = inverse_order_ahead * convolved_11;
        let sum_39 = T::fused(c[12usize], product_37, c11_product_34);
        let product_40 = order_next_order_ahead * sum_39;
        let convolved_12 = sums[12usize];
        let convolved_13 = sums[13usize];
        let difference_43 = convolved_12 - convolved_13;
        let order_next_difference_43 = order_next * difference_43;
        let convolved_14 = sums[14usize];
        let convolved_15 = sums[15usize];
        let difference_47 = convolved_14 - convolved_15;
        let order_next_difference_47 = order_next * difference_47;
        let value_49 = -convolved_1;
        let value_50 = -convolved_5;
        let value_51 = -sum_20;
        let value_52 = -product_40;
        let target = ::ezy_core::kernel::array_mut::<6usize, T>(&mut store.force);
        target[0usize] = convolved_0;
        target[1usize] = value_49;
        target[2usize] = difference_11;
        target[3usize] = convolved_4;
        target[4usize] = value_50;
        target[5usize] = value_51;
        let target = ::ezy_core::kernel::array_mut::<4usize, T>(&mut store.row);
        target[0usize] = product_32;
        target[1usize] = value_52;
        target[2usize] = order_next_difference_43;
        target[3usize] = order_next_difference_47;
    }
    #[inline(always)]
    fn solve(&self, c: &[T], k: usize, store: &mut ::ezy_core::model::SeriesStore<T>) {
        let c = ::ezy_core::kernel::array::<41usize, T>(c);
        let base = ::ezy_core::kernel::array::<8usize, T>(&store.base);
        let force = ::ezy_core::kernel::array::<6usize, T>(&store.force);
        let row = ::ezy_core::kernel::array::<4usize, T>(&store.row);
        let force_0 = force[0usize];
        let base_4 = base[4usize];
        let base_5 = base[5usize];
        let base_1 = base[1usize];
        let force_2 = force[2usize];
        let force_2_c16 = force_2 * c[16usize];
        let base_0 = base[0usize];
        let force_1 = force[1usize];
        let base_0_force_1 = base_0 * force_1;
        let difference_13 = T::fused(-force_0, base_1, base_0_force_1);
        let c15_difference_13 = c[15usize] * difference_13;
        let difference_17 = T::fused(-force_2, c[18usize], c15_difference_13);
        let row_3 = row[3usize];
        let right_side_rear_on_ice = difference_17 - row_3;
        let sum_22 = T::fused(right_side_rear_on_ice, c[8usize], force_2_c16);
        let base_1_sum_22 = base_1 * sum_22;
        let base_3 = base[3usize];
        let force_5 = force[5usize];
        let force_5_c20 = force_5 * c[20usize];
        let base_2 = base[2usize];
        let force_4 = force[4usize];
        let base_2_force_4 = base_2 * force_4;
        let force_3 = force[3usize];
        let difference_33 = T::fused(-base_3, force_3, base_2_force_4);
        let difference_33_c19 = difference_33 * c[19usize];
        let sum_38 = T::fused(force_5, c[22usize], difference_33_c19);
        let row_2 = row[2usize];
        let right_side_front = sum_38 - row_2;
        let sum_43 = T::fused(right_side_front, c[10usize], force_5_c20);
        let sum_45 = T::fused(base_3, sum_43, base_1_sum_22);
        let difference_46 = T::fused(c[15usize], force_0, -sum_45);
        let difference_48 = T::fused(-force_3, c[19usize], difference_46);
        let row_0 = row[0usize];
        let difference_50 = difference_48 - row_0;
        let base_5_difference_50 = base_5 * difference_50;
        let base_6 = base[6usize];
        let base_0_sum_22 = base_0 * sum_22;
        let sum_55 = T::fused(base_2, sum_43, base_0_sum_22);
        let sum_57 = T::fused(c[15usize], force_1, sum_55);
        let difference_59 = T::fused(-force_4, c[19usize], sum_57);
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
        let lambda_rear_on_ice = T::fused(
            right_side_rear_on_ice,
            c[13usize],
            c8_difference_73,
        );
        let sum_79 = T::fused(base_1, lambda_rear_on_ice, difference_65);
        let c15_sum_79 = c[15usize] * sum_79;
        let difference_81 = force_1 - lambda_B_y;
        let difference_83 = T::fused(-base_0, lambda_rear_on_ice, difference_81);
        let c15_difference_83 = c[15usize] * difference_83;
        let force_2_c29 = force_2 * c[29usize];
        let difference_88 = T::fused(-c[16usize], difference_73, force_2_c29);
        let sum_90 = T::fused(c[18usize], lambda_rear_on_ice, difference_88);
        let sum_91 = force_3 + lambda_B_x;
        let base_2_lambda_B_y = base_2 * lambda_B_y;
        let difference_94 = T::fused(-base_3, lambda_B_x, base_2_lambda_B_y);
        let c10_difference_94 = c[10usize] * difference_94;
        let lambda_front = T::fused(right_side_front, c[14usize], c10_difference_94);
        let sum_100 = T::fused(base_3, lambda_front, sum_91);
        let c19_sum_100 = c[19usize] * sum_100;
        let sum_102 = force_4 + lambda_B_y;
        let difference_104 = T::fused(-base_2, lambda_front, sum_102);
        let c19_difference_104 = c[19usize] * difference_104;
        let force_5_c30 = force_5 * c[30usize];
        let difference_109 = T::fused(-c[20usize], difference_94, force_5_c30);
        let difference_111 = T::fused(-c[22usize], lambda_front, difference_109);
        let target = ::ezy_core::kernel::array_mut::<6usize, T>(&mut store.a);
        target[0usize] = c15_sum_79;
        target[1usize] = c15_difference_83;
        target[2usize] = sum_90;
        target[3usize] = c19_sum_100;
        target[4usize] = c19_difference_104;
        target[5usize] = difference_111;
        let target = ::ezy_core::kernel::row_mut::<
            4usize,
            T,
        >(&mut store.lambda, k + 0usize);
        target[0usize] = lambda_B_x;
        target[1usize] = lambda_B_y;
        target[2usize] = lambda_front;
        target[3usize] = lambda_rear_on_ice;
    }
    #[inline(always)]
    fn finish(&self, c: &[T], k: usize, store: &mut ::ezy_core::model::SeriesStore<T>) {
        let c = ::ezy_core::kernel::array::<41usize, T>(c);
        let a = ::ezy_core::kernel::array::<6usize, T>(&store.a);
        let base = ::ezy_core::kernel::array::<8usize, T>(&store.base);
        let kept_1 = ::ezy_core::kernel::row::<3usize, T>(&store.kept, k + 1usize);
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
        let lambda_3 = lambda_0[3usize];
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
        let lambda_2 = lambda_0[2usize];
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
        let product_44 = product_3_a_3 * order_ahead;
        let product_45 = product_3_a_4 * order_ahead;
        let product_46 = a_0_product_3 * order_ahead;
        let product_47 = product_3_a_1 * order_ahead;
        let kept_1_next = kept_1[1usize];
        let inverse_order_ahead_c1 = inverse_order_ahead * c[1usize];
        let product_52 = kept_1_next * inverse_order_ahead_c1;
        let c28_product_52 = c[28usize] * product_52;
        let kept_2_next = kept_1[2usize];
        let product_55 = inverse_order_ahead_c1 * kept_2_next;
        let value_56 = -sum_27;
        let value_57 = -sum_40;
        let value_58 = -c28_product_52;
        let value_59 = -product_52;
        let target = ::ezy_core::kernel::row_mut::<
            3usize,
            T,
        >(&mut store.kept, k + 2usize);
        target[0usize] = value_58;
        target[1usize] = product_55;
        target[2usize] = value_59;
        let target = ::ezy_core::kernel::row_mut::<
            16usize,
            T,
        >(&mut store.left, k + 2usize);
        target[0usize] = sum_22;
        target[1usize] = value_56;
        target[2usize] = sum_22;
        target[3usize] = value_56;
        target[4usize] = sum_35;
        target[5usize] = value_57;
        target[6usize] = sum_35;
        target[7usize] = value_57;
        target[8usize] = product_42;
        target[9usize] = product_43;
        target[10usize] = product_42;
        target[11usize] = product_43;
        target[12usize] = sum_35;
        target[13usize] = value_57;
        target[14usize] = sum_22;
        target[15usize] = value_56;
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
        target[0usize] = lambda_3;
        target[1usize] = lambda_3;
        target[2usize] = lambda_0;
        target[3usize] = lambda_1;
        target[4usize] = lambda_2;
        target[5usize] = lambda_2;
        target[6usize] = lambda_0;
        target[7usize] = lambda_1;
        target[8usize] = sum_22;
        target[9usize] = sum_35;
        target[10usize] = value_56;
        target[11usize] = value_57;
        target[12usize] = product_44;
        target[13usize] = product_45;
        target[14usize] = product_46;
        target[15usize] = product_47;
    }
}
