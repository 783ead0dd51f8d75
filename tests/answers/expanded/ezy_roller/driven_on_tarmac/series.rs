#[automatically_derived]
impl<T: ::ezy_core::scalar::Scalar> ::ezy_core::model::Series<T> for DrivenOnTarmac {
    fn series_size(&self) -> ::ezy_core::model::SeriesSize {
        ::ezy_core::model::SeriesSize {
            n_coordinates: 6usize,
            n_rows: 4usize,
            n_products: 24usize,
            n_base: 11usize,
            n_kept: 5usize,
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
        let c16_seat_omega = c[16usize] * seat_omega;
        let product_26 = seat_omega * c16_seat_omega;
        let cos_seat_phi_product_26 = cos_seat_phi * product_26;
        let bar_omega = v[5usize];
        let c17_bar_omega = c[17usize] * bar_omega;
        let bar_omega_c17_bar_omega = bar_omega * c17_bar_omega;
        let sum_32 = T::fused(
            cos_bar_phi,
            bar_omega_c17_bar_omega,
            cos_seat_phi_product_26,
        );
        let sin_seat_phi_product_26 = sin_seat_phi * product_26;
        let sum_35 = T::fused(
            sin_bar_phi,
            bar_omega_c17_bar_omega,
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
        let seat_vx_c0 = seat_vx * c[0usize];
        let seat_omega_c1 = seat_omega * c[1usize];
        let sum_53 = T::fused(sin_seat_phi, seat_omega_c1, seat_vx_c0);
        let product_55 = cos_seat_phi * seat_omega_c1;
        let difference_56 = T::fused(-seat_vy, c[0usize], product_55);
        let cos_seat_phi_seat_vy = cos_seat_phi * seat_vy;
        let difference_59 = T::fused(-sin_seat_phi, seat_vx, cos_seat_phi_seat_vy);
        let c1_difference_59 = c[1usize] * difference_59;
        let difference_63 = T::fused(-seat_omega, c[2usize], c1_difference_59);
        let c4_t = c[4usize] * t;
        let (sin_67, cos_67) = T::sin_cos(c4_t);
        let c3_cos_67 = c[3usize] * cos_67;
        let sum_70 = difference_63 + c3_cos_67;
        let cos_seat_phi_c8 = cos_seat_phi * c[8usize];
        let product_99 = cos_seat_phi * cos_seat_phi_c8;
        let cos_bar_phi_c9 = cos_bar_phi * c[9usize];
        let sum_103 = T::fused(cos_bar_phi, cos_bar_phi_c9, product_99);
        let sum_105 = sum_103 + c[10usize];
        let sin_seat_phi_c8 = sin_seat_phi * c[8usize];
        let product_107 = cos_seat_phi * sin_seat_phi_c8;
        let sin_bar_phi_c9 = sin_bar_phi * c[9usize];
        let sum_110 = T::fused(cos_bar_phi, sin_bar_phi_c9, product_107);
        let difference_112 = c[11usize] - sum_103;
        let sum_105_difference_112 = sum_105 * difference_112;
        let difference_143 = T::fused(-sum_110, sum_110, sum_105_difference_112);
        let quotient_144 = T::from_f64(1f64) / difference_143;
        let cos_seat_phi_seat_omega = cos_seat_phi * seat_omega;
        let sin_seat_phi_seat_omega = sin_seat_phi * seat_omega;
        let cos_bar_phi_bar_omega = cos_bar_phi * bar_omega;
        let sin_bar_phi_bar_omega = sin_bar_phi * bar_omega;
        let c4_sin_67 = c[4usize] * sin_67;
        let c3_c4_sin_67 = c[3usize] * c4_sin_67;
        let c4_cos_67 = c[4usize] * cos_67;
        let value_208 = -sum_53;
        let value_209 = -c3_cos_67;
        let value_210 = -sin_seat_phi_seat_omega;
        let value_211 = -sin_bar_phi_bar_omega;
        let value_212 = -c3_c4_sin_67;
        let value_213 = -c4_sin_67;
        let target = ::ezy_core::kernel::array_mut::<11usize, T>(&mut store.base);
        target[0usize] = sin_seat_phi;
        target[1usize] = seat_omega_c1;
        target[2usize] = cos_seat_phi;
        target[3usize] = seat_vy;
        target[4usize] = seat_vx;
        target[5usize] = cos_bar_phi;
        target[6usize] = sin_bar_phi;
        target[7usize] = quotient_144;
        target[8usize] = difference_112;
        target[9usize] = sum_110;
        target[10usize] = sum_105;
        let target = ::ezy_core::kernel::array_mut::<6usize, T>(&mut store.force);
        target[0usize] = value_208;
        target[1usize] = difference_56;
        target[2usize] = sum_70;
        target[3usize] = T::from_f64(0f64);
        target[4usize] = T::from_f64(0f64);
        target[5usize] = value_209;
        let target = ::ezy_core::kernel::row_mut::<5usize, T>(&mut store.kept, 0usize);
        target[0usize] = sin_seat_phi;
        target[1usize] = cos_seat_phi;
        target[2usize] = c3_cos_67;
        target[3usize] = sin_67;
        target[4usize] = cos_67;
        let target = ::ezy_core::kernel::row_mut::<5usize, T>(&mut store.kept, 1usize);
        target[0usize] = cos_seat_phi_seat_omega;
        target[1usize] = value_210;
        target[2usize] = value_212;
        target[3usize] = c4_cos_67;
        target[4usize] = value_213;
        let target = ::ezy_core::kernel::row_mut::<24usize, T>(&mut store.left, 1usize);
        target[0usize] = T::from_f64(0f64);
        target[1usize] = cos_seat_phi_seat_omega;
        target[2usize] = T::from_f64(0f64);
        target[3usize] = value_210;
        target[4usize] = T::from_f64(0f64);
        target[5usize] = T::from_f64(0f64);
        target[6usize] = cos_seat_phi_seat_omega;
        target[7usize] = value_210;
        target[8usize] = cos_bar_phi_bar_omega;
        target[9usize] = value_211;
        target[10usize] = cos_bar_phi_bar_omega;
        target[11usize] = value_211;
        target[12usize] = seat_omega;
        target[13usize] = bar_omega;
        target[14usize] = seat_omega;
        target[15usize] = bar_omega;
        target[16usize] = cos_seat_phi_seat_omega;
        target[17usize] = value_210;
        target[18usize] = cos_bar_phi_bar_omega;
        target[19usize] = value_211;
        let target = ::ezy_core::kernel::row_mut::<24usize, T>(&mut store.right, 1usize);
        target[0usize] = T::from_f64(0f64);
        target[1usize] = T::from_f64(0f64);
        target[2usize] = T::from_f64(0f64);
        target[3usize] = T::from_f64(0f64);
        target[4usize] = T::from_f64(0f64);
        target[5usize] = T::from_f64(0f64);
        target[6usize] = T::from_f64(0f64);
        target[7usize] = T::from_f64(0f64);
        target[8usize] = T::from_f64(0f64);
        target[9usize] = T::from_f64(0f64);
        target[10usize] = T::from_f64(0f64);
        target[11usize] = T::from_f64(0f64);
        target[12usize] = cos_seat_phi_seat_omega;
        target[13usize] = cos_bar_phi_bar_omega;
        target[14usize] = value_210;
        target[15usize] = value_211;
        target[16usize] = seat_vx;
        target[17usize] = seat_vy;
        target[18usize] = bar_vx;
        target[19usize] = bar_vy;
        let target = ::ezy_core::kernel::row_mut::<24usize, T>(&mut store.right, 2usize);
        target[0usize] = seat_omega_c1;
        target[2usize] = seat_omega_c1;
        target[4usize] = seat_vy;
        target[5usize] = seat_vx;
        let target = ::ezy_core::kernel::array_mut::<4usize, T>(&mut store.row);
        target[0usize] = sum_32;
        target[1usize] = sum_35;
        target[2usize] = seat_omega_sum_40;
        target[3usize] = bar_omega_sum_46;
        ::ezy_core::model::Pivots::new()
            .see(&[2usize], T::least_ratio(c[25usize], c[26usize]))
            .see(&[3usize], T::least_ratio(c[27usize], c[28usize]))
            .see(&[0usize, 1usize], T::least_ratio(difference_143, c[29usize]))
    }
    #[inline(always)]
    fn right_side(
        &self,
        c: &[T],
        k: usize,
        store: &mut ::ezy_core::model::SeriesStore<T>,
    ) {
        let c = ::ezy_core::kernel::array::<41usize, T>(c);
        let base = ::ezy_core::kernel::array::<11usize, T>(&store.base);
        let kept_0 = ::ezy_core::kernel::row::<5usize, T>(&store.kept, k + 0usize);
        let q_1 = ::ezy_core::kernel::row::<6usize, T>(&store.q, k + 1usize);
        let sums = ::ezy_core::kernel::array::<24usize, T>(&store.sums);
        let order_next = T::from_f64((k + 1usize) as f64);
        let q_0_next = q_1[0usize];
        let order_next_q_0_next = order_next * q_0_next;
        let convolved_0 = sums[0usize];
        let q_2_next = q_1[2usize];
        let order_next_q_2_next = order_next * q_2_next;
        let c1_order_next_q_2_next = c[1usize] * order_next_q_2_next;
        let base_0 = base[0usize];
        let product_11 = c1_order_next_q_2_next * base_0;
        let kept_0 = kept_0[0usize];
        let base_1 = base[1usize];
        let sum_15 = T::fused(kept_0, base_1, product_11);
        let sum_16 = convolved_0 + sum_15;
        let sum_17 = T::fused(c[0usize], order_next_q_0_next, sum_16);
        let convolved_1 = sums[1usize];
        let difference_21 = convolved_1 - sum_17;
        let convolved_2 = sums[2usize];
        let base_2 = base[2usize];
        let product_24 = c1_order_next_q_2_next * base_2;
        let kept_1 = kept_0[1usize];
        let sum_27 = T::fused(base_1, kept_1, product_24);
        let sum_28 = convolved_2 + sum_27;
        let q_1_next = q_1[1usize];
        let order_next_q_1_next = order_next * q_1_next;
        let difference_32 = T::fused(-c[0usize], order_next_q_1_next, sum_28);
        let convolved_3 = sums[3usize];
        let difference_34 = difference_32 - convolved_3;
        let convolved_4 = sums[4usize];
        let product_36 = base_2 * order_next_q_1_next;
        let base_3 = base[3usize];
        let sum_39 = T::fused(kept_1, base_3, product_36);
        let sum_40 = convolved_4 + sum_39;
        let convolved_5 = sums[5usize];
        let product_42 = order_next_q_0_next * base_0;
        let base_4 = base[4usize];
        let sum_45 = T::fused(kept_0, base_4, product_42);
        let sum_46 = convolved_5 + sum_45;
        let difference_47 = sum_40 - sum_46;
        let c1_difference_47 = c[1usize] * difference_47;
        let difference_51 = T::fused(-order_next_q_2_next, c[2usize], c1_difference_47);
        let kept_2 = kept_0[2usize];
        let sum_53 = difference_51 + kept_2;
        let convolved_6 = sums[6usize];
        let convolved_7 = sums[7usize];
        let c16_convolved_7 = c[16usize] * convolved_7;
        let difference_59 = T::fused(-c[16usize], convolved_6, c16_convolved_7);
        let difference_60 = sum_53 - difference_59;
        let convolved_8 = sums[8usize];
        let convolved_9 = sums[9usize];
        let convolved_10 = sums[10usize];
        let convolved_11 = sums[11usize];
        let c17_convolved_11 = c[17usize] * convolved_11;
        let difference_68 = T::fused(-c[17usize], convolved_10, c17_convolved_11);
        let sum_69 = kept_2 + difference_68;
        let convolved_12 = sums[12usize];
        let inverse_order_ahead = T::from_f64(1f64) / T::from_f64((k + 2usize) as f64);
        let product_72 = convolved_12 * inverse_order_ahead;
        let c16_product_72 = c[16usize] * product_72;
        let convolved_13 = sums[13usize];
        let product_75 = inverse_order_ahead * convolved_13;
        let sum_77 = T::fused(c[17usize], product_75, c16_product_72);
        let order_ahead = T::from_f64((k + 2usize) as f64);
        let order_next_order_ahead = order_next * order_ahead;
        let product_80 = sum_77 * order_next_order_ahead;
        let convolved_14 = sums[14usize];
        let product_82 = inverse_order_ahead * convolved_14;
        let c16_product_82 = c[16usize] * product_82;
        let convolved_15 = sums[15usize];
        let product_85 = inverse_order_ahead * convolved_15;
        let sum_87 = T::fused(c[17usize], product_85, c16_product_82);
        let product_88 = order_next_order_ahead * sum_87;
        let convolved_16 = sums[16usize];
        let convolved_17 = sums[17usize];
        let difference_91 = convolved_16 - convolved_17;
        let order_next_difference_91 = order_next * difference_91;
        let convolved_18 = sums[18usize];
        let convolved_19 = sums[19usize];
        let difference_95 = convolved_18 - convolved_19;
        let order_next_difference_95 = order_next * difference_95;
        let value_97 = -convolved_9;
        let value_98 = -sum_69;
        let value_99 = -product_88;
        let target = ::ezy_core::kernel::array_mut::<6usize, T>(&mut store.force);
        target[0usize] = difference_21;
        target[1usize] = difference_34;
        target[2usize] = difference_60;
        target[3usize] = convolved_8;
        target[4usize] = value_97;
        target[5usize] = value_98;
        let target = ::ezy_core::kernel::row_mut::<
            24usize,
            T,
        >(&mut store.left, k + 0usize);
        target[0usize] = kept_0;
        target[2usize] = kept_1;
        target[4usize] = kept_1;
        target[5usize] = kept_0;
        let target = ::ezy_core::kernel::row_mut::<
            24usize,
            T,
        >(&mut store.left, k + 1usize);
        target[0usize] = T::from_f64(0f64);
        target[2usize] = T::from_f64(0f64);
        target[4usize] = T::from_f64(0f64);
        target[5usize] = T::from_f64(0f64);
        let target = ::ezy_core::kernel::row_mut::<
            24usize,
            T,
        >(&mut store.right, k + 2usize);
        target[0usize] = c1_order_next_q_2_next;
        target[2usize] = c1_order_next_q_2_next;
        target[4usize] = order_next_q_1_next;
        target[5usize] = order_next_q_0_next;
        let target = ::ezy_core::kernel::array_mut::<4usize, T>(&mut store.row);
        target[0usize] = product_80;
        target[1usize] = value_99;
        target[2usize] = order_next_difference_91;
        target[3usize] = order_next_difference_95;
    }
    #[inline(always)]
    fn solve(&self, c: &[T], k: usize, store: &mut ::ezy_core::model::SeriesStore<T>) {
        let c = ::ezy_core::kernel::array::<41usize, T>(c);
        let base = ::ezy_core::kernel::array::<11usize, T>(&store.base);
        let force = ::ezy_core::kernel::array::<6usize, T>(&store.force);
        let row = ::ezy_core::kernel::array::<4usize, T>(&store.row);
        let force_0 = force[0usize];
        let base_7 = base[7usize];
        let base_8 = base[8usize];
        let base_0 = base[0usize];
        let force_2 = force[2usize];
        let force_2_c12 = force_2 * c[12usize];
        let base_2 = base[2usize];
        let force_1 = force[1usize];
        let base_2_force_1 = base_2 * force_1;
        let difference_13 = T::fused(-force_0, base_0, base_2_force_1);
        let c5_difference_13 = c[5usize] * difference_13;
        let difference_17 = T::fused(-force_2, c[6usize], c5_difference_13);
        let row_2 = row[2usize];
        let right_side_rear = difference_17 - row_2;
        let sum_22 = T::fused(right_side_rear, c[13usize], force_2_c12);
        let base_0_sum_22 = base_0 * sum_22;
        let base_6 = base[6usize];
        let force_5 = force[5usize];
        let force_5_c22 = force_5 * c[22usize];
        let base_5 = base[5usize];
        let force_4 = force[4usize];
        let base_5_force_4 = base_5 * force_4;
        let force_3 = force[3usize];
        let difference_33 = T::fused(-base_6, force_3, base_5_force_4);
        let difference_33_c21 = difference_33 * c[21usize];
        let sum_38 = T::fused(force_5, c[24usize], difference_33_c21);
        let row_3 = row[3usize];
        let right_side_front = sum_38 - row_3;
        let sum_43 = T::fused(right_side_front, c[15usize], force_5_c22);
        let sum_45 = T::fused(base_6, sum_43, base_0_sum_22);
        let difference_46 = T::fused(c[5usize], force_0, -sum_45);
        let difference_48 = T::fused(-force_3, c[21usize], difference_46);
        let row_0 = row[0usize];
        let difference_50 = difference_48 - row_0;
        let base_8_difference_50 = base_8 * difference_50;
        let base_9 = base[9usize];
        let base_2_sum_22 = base_2 * sum_22;
        let sum_55 = T::fused(base_5, sum_43, base_2_sum_22);
        let sum_57 = T::fused(c[5usize], force_1, sum_55);
        let difference_59 = T::fused(-force_4, c[21usize], sum_57);
        let row_1 = row[1usize];
        let difference_61 = difference_59 - row_1;
        let difference_63 = T::fused(-base_9, difference_61, base_8_difference_50);
        let lambda_B_x = base_7 * difference_63;
        let difference_65 = force_0 - lambda_B_x;
        let base_10 = base[10usize];
        let difference_61_base_10 = difference_61 * base_10;
        let difference_69 = T::fused(-difference_50, base_9, difference_61_base_10);
        let lambda_B_y = base_7 * difference_69;
        let base_2_lambda_B_y = base_2 * lambda_B_y;
        let difference_73 = T::fused(-base_0, lambda_B_x, base_2_lambda_B_y);
        let c13_difference_73 = c[13usize] * difference_73;
        let lambda_rear = T::fused(right_side_rear, c[19usize], c13_difference_73);
        let sum_79 = T::fused(base_0, lambda_rear, difference_65);
        let c5_sum_79 = c[5usize] * sum_79;
        let difference_81 = force_1 - lambda_B_y;
        let difference_83 = T::fused(-base_2, lambda_rear, difference_81);
        let c5_difference_83 = c[5usize] * difference_83;
        let force_2_c20 = force_2 * c[20usize];
        let difference_88 = T::fused(-c[12usize], difference_73, force_2_c20);
        let sum_90 = T::fused(c[6usize], lambda_rear, difference_88);
        let sum_91 = force_3 + lambda_B_x;
        let base_5_lambda_B_y = base_5 * lambda_B_y;
        let difference_94 = T::fused(-base_6, lambda_B_x, base_5_lambda_B_y);
        let c15_difference_94 = c[15usize] * difference_94;
        let lambda_front = T::fused(right_side_front, c[18usize], c15_difference_94);
        let sum_100 = T::fused(base_6, lambda_front, sum_91);
        let c21_sum_100 = c[21usize] * sum_100;
        let sum_102 = force_4 + lambda_B_y;
        let difference_104 = T::fused(-base_5, lambda_front, sum_102);
        let c21_difference_104 = c[21usize] * difference_104;
        let force_5_c30 = force_5 * c[30usize];
        let difference_109 = T::fused(-c[22usize], difference_94, force_5_c30);
        let difference_111 = T::fused(-c[24usize], lambda_front, difference_109);
        let target = ::ezy_core::kernel::array_mut::<6usize, T>(&mut store.a);
        target[0usize] = c5_sum_79;
        target[1usize] = c5_difference_83;
        target[2usize] = sum_90;
        target[3usize] = c21_sum_100;
        target[4usize] = c21_difference_104;
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
        let c = ::ezy_core::kernel::array::<41usize, T>(c);
        let a = ::ezy_core::kernel::array::<6usize, T>(&store.a);
        let base = ::ezy_core::kernel::array::<11usize, T>(&store.base);
        let kept_1 = ::ezy_core::kernel::row::<5usize, T>(&store.kept, k + 1usize);
        let lambda_0 = ::ezy_core::kernel::row::<4usize, T>(&store.lambda, k + 0usize);
        let sums = ::ezy_core::kernel::array::<24usize, T>(&store.sums);
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
        let convolved_14 = sums[14usize];
        let product_19 = inverse_order_ahead * convolved_14;
        let base_2 = base[2usize];
        let sum_22 = T::fused(product_3_a_2, base_2, product_19);
        let convolved_12 = sums[12usize];
        let product_24 = inverse_order_ahead * convolved_12;
        let base_0 = base[0usize];
        let sum_27 = T::fused(product_3_a_2, base_0, product_24);
        let lambda_0 = lambda_0[0usize];
        let lambda_1 = lambda_0[1usize];
        let lambda_3 = lambda_0[3usize];
        let convolved_15 = sums[15usize];
        let product_32 = inverse_order_ahead * convolved_15;
        let base_5 = base[5usize];
        let sum_35 = T::fused(product_3_a_5, base_5, product_32);
        let convolved_13 = sums[13usize];
        let product_37 = inverse_order_ahead * convolved_13;
        let base_6 = base[6usize];
        let sum_40 = T::fused(product_3_a_5, base_6, product_37);
        let order_ahead = T::from_f64((k + 2usize) as f64);
        let product_42 = product_3_a_2 * order_ahead;
        let product_43 = product_3_a_5 * order_ahead;
        let product_44 = a_0_product_3 * order_ahead;
        let product_45 = product_3_a_1 * order_ahead;
        let product_46 = product_3_a_3 * order_ahead;
        let product_47 = product_3_a_4 * order_ahead;
        let kept_3_next = kept_1[3usize];
        let inverse_order_ahead_c4 = inverse_order_ahead * c[4usize];
        let product_52 = kept_3_next * inverse_order_ahead_c4;
        let c3_product_52 = c[3usize] * product_52;
        let kept_4_next = kept_1[4usize];
        let product_55 = inverse_order_ahead_c4 * kept_4_next;
        let value_56 = -sum_27;
        let value_57 = -sum_40;
        let value_58 = -c3_product_52;
        let value_59 = -product_52;
        let target = ::ezy_core::kernel::row_mut::<
            5usize,
            T,
        >(&mut store.kept, k + 2usize);
        target[0usize] = sum_22;
        target[1usize] = value_56;
        target[2usize] = value_58;
        target[3usize] = product_55;
        target[4usize] = value_59;
        let target = ::ezy_core::kernel::row_mut::<
            24usize,
            T,
        >(&mut store.left, k + 2usize);
        target[1usize] = sum_22;
        target[3usize] = value_56;
        target[6usize] = sum_22;
        target[7usize] = value_56;
        target[8usize] = sum_35;
        target[9usize] = value_57;
        target[10usize] = sum_35;
        target[11usize] = value_57;
        target[12usize] = product_42;
        target[13usize] = product_43;
        target[14usize] = product_42;
        target[15usize] = product_43;
        target[16usize] = sum_22;
        target[17usize] = value_56;
        target[18usize] = sum_35;
        target[19usize] = value_57;
        let target = ::ezy_core::kernel::row_mut::<6usize, T>(&mut store.q, k + 2usize);
        target[0usize] = a_0_product_3;
        target[1usize] = product_3_a_1;
        target[2usize] = product_3_a_2;
        target[3usize] = product_3_a_3;
        target[4usize] = product_3_a_4;
        target[5usize] = product_3_a_5;
        let target = ::ezy_core::kernel::row_mut::<
            24usize,
            T,
        >(&mut store.right, k + 2usize);
        target[1usize] = lambda_2;
        target[3usize] = lambda_2;
        target[6usize] = lambda_0;
        target[7usize] = lambda_1;
        target[8usize] = lambda_3;
        target[9usize] = lambda_3;
        target[10usize] = lambda_0;
        target[11usize] = lambda_1;
        target[12usize] = sum_22;
        target[13usize] = sum_35;
        target[14usize] = value_56;
        target[15usize] = value_57;
        target[16usize] = product_44;
        target[17usize] = product_45;
        target[18usize] = product_46;
        target[19usize] = product_47;
    }
}
