#[automatically_derived]
impl<T: ::ezy_core::scalar::Scalar> ::ezy_core::model::Series<T> for Drift {
    fn series_size(&self) -> ::ezy_core::model::SeriesSize {
        ::ezy_core::model::SeriesSize {
            n_coordinates: 6usize,
            n_rows: 3usize,
            n_products: 24usize,
            n_base: 16usize,
            n_kept: 5usize,
        }
    }
    fn begin(
        &self,
        c: &[T],
        t: T,
        store: &mut ::ezy_core::model::SeriesStore<T>,
    ) -> ::ezy_core::model::Pivots {
        let c = ::ezy_core::kernel::array::<40usize, T>(c);
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
        let bar_vx = v[3usize];
        let cos_bar_phi_bar_vx = cos_bar_phi * bar_vx;
        let bar_vy = v[4usize];
        let sum_40 = T::fused(sin_bar_phi, bar_vy, cos_bar_phi_bar_vx);
        let bar_omega_sum_40 = bar_omega * sum_40;
        let seat_vx = v[0usize];
        let sin_seat_phi_seat_vx = sin_seat_phi * seat_vx;
        let sum_49 = T::fused(seat_omega, c[2usize], sin_seat_phi_seat_vx);
        let seat_vy = v[1usize];
        let cos_seat_phi_seat_vy = cos_seat_phi * seat_vy;
        let difference_52 = cos_seat_phi_seat_vy - sum_49;
        let cos_seat_phi_seat_vx = cos_seat_phi * seat_vx;
        let sum_55 = T::fused(sin_seat_phi, seat_vy, cos_seat_phi_seat_vx);
        let sum_58 = T::fused(sum_55, sum_55, c[3usize]);
        let value_59 = T::sqrt(sum_58);
        let value_60 = T::atan2(difference_52, value_59);
        let c1_value_60 = c[1usize] * value_60;
        let difference_62 = T::fused(-seat_omega, c[0usize], c1_value_60);
        let product_63 = sin_seat_phi * difference_62;
        let difference_66 = T::fused(-seat_vx, c[4usize], product_63);
        let product_67 = cos_seat_phi * difference_62;
        let sum_69 = T::fused(seat_vy, c[4usize], product_67);
        let difference_70 = cos_seat_phi_seat_vy - sin_seat_phi_seat_vx;
        let c0_difference_70 = c[0usize] * difference_70;
        let difference_74 = T::fused(-seat_omega, c[5usize], c0_difference_70);
        let c7_t = c[7usize] * t;
        let (sin_78, cos_78) = T::sin_cos(c7_t);
        let c6_cos_78 = c[6usize] * cos_78;
        let sum_81 = difference_74 + c6_cos_78;
        let sum_84 = T::fused(value_60, c[8usize], sum_81);
        let cos_seat_phi_c10 = cos_seat_phi * c[10usize];
        let cos_bar_phi_c11 = cos_bar_phi * c[11usize];
        let product_103 = cos_bar_phi * cos_bar_phi_c11;
        let difference_104 = T::fused(-cos_seat_phi, cos_seat_phi_c10, product_103);
        let sum_106 = difference_104 + c[12usize];
        let sin_seat_phi_c10 = sin_seat_phi * c[10usize];
        let sin_bar_phi_c11 = sin_bar_phi * c[11usize];
        let product_110 = cos_bar_phi * sin_bar_phi_c11;
        let difference_111 = T::fused(-cos_seat_phi, sin_seat_phi_c10, product_110);
        let difference_113 = c[13usize] - difference_104;
        let sum_106_difference_113 = sum_106 * difference_113;
        let difference_145 = T::fused(
            -difference_111,
            difference_111,
            sum_106_difference_113,
        );
        let quotient_146 = T::from_f64(1f64) / difference_145;
        let product_191 = difference_52 * difference_52;
        let sum_193 = T::fused(value_59, value_59, product_191);
        let quotient_194 = T::from_f64(1f64) / sum_193;
        let sum_195 = value_59 + value_59;
        let quotient_196 = T::from_f64(1f64) / sum_195;
        let cos_seat_phi_seat_omega = cos_seat_phi * seat_omega;
        let sin_seat_phi_seat_omega = sin_seat_phi * seat_omega;
        let cos_bar_phi_bar_omega = cos_bar_phi * bar_omega;
        let sin_bar_phi_bar_omega = sin_bar_phi * bar_omega;
        let c7_sin_78 = c[7usize] * sin_78;
        let c6_c7_sin_78 = c[6usize] * c7_sin_78;
        let c7_cos_78 = c[7usize] * cos_78;
        let value_204 = -sum_69;
        let value_205 = -c6_cos_78;
        let value_206 = -sin_seat_phi_seat_omega;
        let value_207 = -sin_bar_phi_bar_omega;
        let value_208 = -c6_c7_sin_78;
        let value_209 = -c7_sin_78;
        let target = ::ezy_core::kernel::array_mut::<16usize, T>(&mut store.base);
        target[0usize] = cos_seat_phi;
        target[1usize] = seat_vy;
        target[2usize] = sin_seat_phi;
        target[3usize] = seat_vx;
        target[4usize] = value_59;
        target[5usize] = sum_55;
        target[6usize] = quotient_196;
        target[7usize] = difference_52;
        target[8usize] = quotient_194;
        target[9usize] = difference_62;
        target[10usize] = cos_bar_phi;
        target[11usize] = sin_bar_phi;
        target[12usize] = quotient_146;
        target[13usize] = difference_113;
        target[14usize] = difference_111;
        target[15usize] = sum_106;
        let target = ::ezy_core::kernel::array_mut::<6usize, T>(&mut store.force);
        target[0usize] = difference_66;
        target[1usize] = value_204;
        target[2usize] = sum_84;
        target[3usize] = T::from_f64(0f64);
        target[4usize] = T::from_f64(0f64);
        target[5usize] = value_205;
        let target = ::ezy_core::kernel::row_mut::<5usize, T>(&mut store.kept, 0usize);
        target[0usize] = cos_seat_phi;
        target[1usize] = sin_seat_phi;
        target[2usize] = c6_cos_78;
        target[3usize] = sin_78;
        target[4usize] = cos_78;
        let target = ::ezy_core::kernel::row_mut::<5usize, T>(&mut store.kept, 1usize);
        target[0usize] = value_206;
        target[1usize] = cos_seat_phi_seat_omega;
        target[2usize] = value_208;
        target[3usize] = c7_cos_78;
        target[4usize] = value_209;
        let target = ::ezy_core::kernel::row_mut::<24usize, T>(&mut store.left, 1usize);
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
        target[11usize] = cos_seat_phi_seat_omega;
        target[12usize] = value_206;
        target[13usize] = cos_bar_phi_bar_omega;
        target[14usize] = value_207;
        target[15usize] = cos_bar_phi_bar_omega;
        target[16usize] = value_207;
        target[17usize] = seat_omega;
        target[18usize] = bar_omega;
        target[19usize] = seat_omega;
        target[20usize] = bar_omega;
        target[21usize] = cos_bar_phi_bar_omega;
        target[22usize] = value_207;
        target[23usize] = T::from_f64(0f64);
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
        target[12usize] = T::from_f64(0f64);
        target[13usize] = T::from_f64(0f64);
        target[14usize] = T::from_f64(0f64);
        target[15usize] = T::from_f64(0f64);
        target[16usize] = T::from_f64(0f64);
        target[17usize] = cos_seat_phi_seat_omega;
        target[18usize] = cos_bar_phi_bar_omega;
        target[19usize] = value_206;
        target[20usize] = value_207;
        target[21usize] = bar_vx;
        target[22usize] = bar_vy;
        target[23usize] = T::from_f64(0f64);
        let target = ::ezy_core::kernel::row_mut::<24usize, T>(&mut store.right, 2usize);
        target[0usize] = difference_62;
        target[1usize] = value_59;
        target[2usize] = difference_52;
        target[3usize] = sum_193;
        target[4usize] = seat_vy;
        target[5usize] = seat_vx;
        target[6usize] = sum_55;
        target[7usize] = seat_vx;
        target[8usize] = seat_vy;
        target[9usize] = value_59;
        target[10usize] = difference_62;
        target[23usize] = difference_52;
        let target = ::ezy_core::kernel::array_mut::<3usize, T>(&mut store.row);
        target[0usize] = sum_32;
        target[1usize] = sum_35;
        target[2usize] = bar_omega_sum_40;
        ::ezy_core::model::Pivots::new()
            .see(&[2usize], T::least_ratio(c[26usize], c[27usize]))
            .see(&[0usize, 1usize], T::least_ratio(difference_145, c[28usize]))
    }
    #[inline(always)]
    fn right_side(
        &self,
        c: &[T],
        k: usize,
        store: &mut ::ezy_core::model::SeriesStore<T>,
    ) {
        let c = ::ezy_core::kernel::array::<40usize, T>(c);
        let base = ::ezy_core::kernel::array::<16usize, T>(&store.base);
        let kept_0 = ::ezy_core::kernel::row::<5usize, T>(&store.kept, k + 0usize);
        let q_1 = ::ezy_core::kernel::row::<6usize, T>(&store.q, k + 1usize);
        let sums = ::ezy_core::kernel::array::<24usize, T>(&store.sums);
        let convolved_0 = sums[0usize];
        let convolved_1 = sums[1usize];
        let inverse_order = T::from_f64(1f64) / T::from_f64((k + 0usize) as f64);
        let product_4 = convolved_1 * inverse_order;
        let convolved_2 = sums[2usize];
        let convolved_3 = sums[3usize];
        let convolved_4 = sums[4usize];
        let order_next = T::from_f64((k + 1usize) as f64);
        let q_1_next = q_1[1usize];
        let order_next_q_1_next = order_next * q_1_next;
        let base_0 = base[0usize];
        let product_14 = order_next_q_1_next * base_0;
        let kept_0 = kept_0[0usize];
        let base_1 = base[1usize];
        let sum_18 = T::fused(kept_0, base_1, product_14);
        let sum_19 = convolved_4 + sum_18;
        let q_2_next = q_1[2usize];
        let order_next_q_2_next = order_next * q_2_next;
        let convolved_5 = sums[5usize];
        let q_0_next = q_1[0usize];
        let order_next_q_0_next = order_next * q_0_next;
        let base_2 = base[2usize];
        let product_28 = order_next_q_0_next * base_2;
        let kept_1 = kept_0[1usize];
        let base_3 = base[3usize];
        let sum_32 = T::fused(kept_1, base_3, product_28);
        let sum_33 = convolved_5 + sum_32;
        let sum_34 = T::fused(c[2usize], order_next_q_2_next, sum_33);
        let difference_35 = sum_19 - sum_34;
        let base_4 = base[4usize];
        let convolved_6 = sums[6usize];
        let convolved_7 = sums[7usize];
        let product_40 = base_0 * order_next_q_0_next;
        let sum_42 = T::fused(kept_0, base_3, product_40);
        let sum_43 = convolved_7 + sum_42;
        let convolved_8 = sums[8usize];
        let product_45 = order_next_q_1_next * base_2;
        let sum_47 = T::fused(base_1, kept_1, product_45);
        let sum_48 = convolved_8 + sum_47;
        let sum_49 = sum_43 + sum_48;
        let base_5 = base[5usize];
        let sum_49_base_5 = sum_49 * base_5;
        let sum_52 = sum_49_base_5 + sum_49_base_5;
        let sum_53 = convolved_6 + sum_52;
        let convolved_9 = sums[9usize];
        let difference_56 = sum_53 - convolved_9;
        let base_6 = base[6usize];
        let difference_56_base_6 = difference_56 * base_6;
        let base_7 = base[7usize];
        let difference_61 = T::fused(-inverse_order, convolved_2, product_4);
        let difference_62 = T::fused(-inverse_order, convolved_3, difference_61);
        let sum_63 = T::fused(difference_35, base_4, difference_62);
        let difference_64 = T::fused(-difference_56_base_6, base_7, sum_63);
        let base_8 = base[8usize];
        let difference_64_base_8 = difference_64 * base_8;
        let c1_difference_64_base_8 = c[1usize] * difference_64_base_8;
        let difference_70 = T::fused(
            -order_next_q_2_next,
            c[0usize],
            c1_difference_64_base_8,
        );
        let base_2_difference_70 = base_2 * difference_70;
        let base_9 = base[9usize];
        let sum_74 = T::fused(kept_1, base_9, base_2_difference_70);
        let sum_75 = convolved_0 + sum_74;
        let difference_78 = T::fused(-order_next_q_0_next, c[4usize], sum_75);
        let convolved_10 = sums[10usize];
        let base_0_difference_70 = base_0 * difference_70;
        let sum_82 = T::fused(kept_0, base_9, base_0_difference_70);
        let sum_83 = convolved_10 + sum_82;
        let sum_85 = T::fused(order_next_q_1_next, c[4usize], sum_83);
        let difference_86 = sum_19 - sum_33;
        let c0_difference_86 = c[0usize] * difference_86;
        let difference_90 = T::fused(-order_next_q_2_next, c[5usize], c0_difference_86);
        let kept_2 = kept_0[2usize];
        let sum_92 = difference_90 + kept_2;
        let sum_95 = T::fused(difference_64_base_8, c[8usize], sum_92);
        let convolved_11 = sums[11usize];
        let convolved_12 = sums[12usize];
        let c16_convolved_12 = c[16usize] * convolved_12;
        let difference_101 = T::fused(-c[16usize], convolved_11, c16_convolved_12);
        let difference_102 = sum_95 - difference_101;
        let convolved_13 = sums[13usize];
        let convolved_14 = sums[14usize];
        let convolved_15 = sums[15usize];
        let convolved_16 = sums[16usize];
        let c17_convolved_16 = c[17usize] * convolved_16;
        let difference_111 = T::fused(-c[17usize], convolved_15, c17_convolved_16);
        let sum_112 = kept_2 + difference_111;
        let convolved_17 = sums[17usize];
        let inverse_order_ahead = T::from_f64(1f64) / T::from_f64((k + 2usize) as f64);
        let product_115 = convolved_17 * inverse_order_ahead;
        let c16_product_115 = c[16usize] * product_115;
        let convolved_18 = sums[18usize];
        let product_118 = inverse_order_ahead * convolved_18;
        let sum_120 = T::fused(c[17usize], product_118, c16_product_115);
        let order_ahead = T::from_f64((k + 2usize) as f64);
        let order_next_order_ahead = order_next * order_ahead;
        let product_123 = sum_120 * order_next_order_ahead;
        let convolved_19 = sums[19usize];
        let product_125 = inverse_order_ahead * convolved_19;
        let c16_product_125 = c[16usize] * product_125;
        let convolved_20 = sums[20usize];
        let product_128 = inverse_order_ahead * convolved_20;
        let sum_130 = T::fused(c[17usize], product_128, c16_product_125);
        let product_131 = order_next_order_ahead * sum_130;
        let convolved_21 = sums[21usize];
        let convolved_22 = sums[22usize];
        let difference_134 = convolved_21 - convolved_22;
        let product_135 = order_next * difference_134;
        let order = T::from_f64((k + 0usize) as f64);
        let difference_35_order = difference_35 * order;
        let product_138 = difference_56_base_6 * order;
        let product_139 = difference_64_base_8 * order;
        let convolved_23 = sums[23usize];
        let difference_35_base_7 = difference_35 * base_7;
        let sum_142 = difference_35_base_7 + difference_35_base_7;
        let sum_143 = convolved_23 + sum_142;
        let product_144 = base_4 * difference_56_base_6;
        let sum_145 = product_144 + product_144;
        let sum_146 = convolved_9 + sum_145;
        let sum_147 = sum_143 + sum_146;
        let value_148 = -sum_85;
        let value_149 = -convolved_14;
        let value_150 = -sum_112;
        let value_151 = -product_131;
        let target = ::ezy_core::kernel::array_mut::<6usize, T>(&mut store.force);
        target[0usize] = difference_78;
        target[1usize] = value_148;
        target[2usize] = difference_102;
        target[3usize] = convolved_13;
        target[4usize] = value_149;
        target[5usize] = value_150;
        let target = ::ezy_core::kernel::row_mut::<
            24usize,
            T,
        >(&mut store.left, k + 0usize);
        target[0usize] = kept_1;
        target[1usize] = difference_35_order;
        target[2usize] = product_138;
        target[3usize] = product_139;
        target[4usize] = kept_0;
        target[5usize] = kept_1;
        target[6usize] = sum_49;
        target[7usize] = kept_0;
        target[8usize] = kept_1;
        target[9usize] = difference_56_base_6;
        target[10usize] = kept_0;
        target[23usize] = difference_35;
        let target = ::ezy_core::kernel::row_mut::<
            24usize,
            T,
        >(&mut store.left, k + 1usize);
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
        target[23usize] = T::from_f64(0f64);
        let target = ::ezy_core::kernel::row_mut::<
            24usize,
            T,
        >(&mut store.right, k + 2usize);
        target[0usize] = difference_70;
        target[1usize] = difference_56_base_6;
        target[2usize] = difference_35;
        target[3usize] = sum_147;
        target[4usize] = order_next_q_1_next;
        target[5usize] = order_next_q_0_next;
        target[6usize] = sum_49;
        target[7usize] = order_next_q_0_next;
        target[8usize] = order_next_q_1_next;
        target[9usize] = difference_56_base_6;
        target[10usize] = difference_70;
        target[23usize] = difference_35;
        let target = ::ezy_core::kernel::array_mut::<3usize, T>(&mut store.row);
        target[0usize] = product_123;
        target[1usize] = value_151;
        target[2usize] = product_135;
    }
    #[inline(always)]
    fn solve(&self, c: &[T], k: usize, store: &mut ::ezy_core::model::SeriesStore<T>) {
        let c = ::ezy_core::kernel::array::<40usize, T>(c);
        let base = ::ezy_core::kernel::array::<16usize, T>(&store.base);
        let force = ::ezy_core::kernel::array::<6usize, T>(&store.force);
        let row = ::ezy_core::kernel::array::<3usize, T>(&store.row);
        let force_0 = force[0usize];
        let base_12 = base[12usize];
        let base_13 = base[13usize];
        let c18_force_0 = c[18usize] * force_0;
        let base_11 = base[11usize];
        let force_5 = force[5usize];
        let force_5_c23 = force_5 * c[23usize];
        let base_10 = base[10usize];
        let force_4 = force[4usize];
        let base_10_force_4 = base_10 * force_4;
        let force_3 = force[3usize];
        let difference_14 = T::fused(-base_11, force_3, base_10_force_4);
        let difference_14_c22 = difference_14 * c[22usize];
        let sum_19 = T::fused(force_5, c[25usize], difference_14_c22);
        let row_2 = row[2usize];
        let right_side_front = sum_19 - row_2;
        let sum_24 = T::fused(right_side_front, c[15usize], force_5_c23);
        let difference_26 = T::fused(-base_11, sum_24, c18_force_0);
        let difference_28 = T::fused(-force_3, c[22usize], difference_26);
        let row_0 = row[0usize];
        let difference_30 = difference_28 - row_0;
        let base_2 = base[2usize];
        let force_2 = force[2usize];
        let c19_force_2 = c[19usize] * force_2;
        let difference_36 = T::fused(-base_2, c19_force_2, difference_30);
        let base_13_difference_36 = base_13 * difference_36;
        let base_14 = base[14usize];
        let base_10_sum_24 = base_10 * sum_24;
        let force_1 = force[1usize];
        let sum_42 = T::fused(c[18usize], force_1, base_10_sum_24);
        let difference_44 = T::fused(-force_4, c[22usize], sum_42);
        let row_1 = row[1usize];
        let difference_46 = difference_44 - row_1;
        let base_0 = base[0usize];
        let sum_49 = T::fused(c19_force_2, base_0, difference_46);
        let difference_51 = T::fused(-base_14, sum_49, base_13_difference_36);
        let lambda_B_x = base_12 * difference_51;
        let difference_53 = force_0 - lambda_B_x;
        let c18_difference_53 = c[18usize] * difference_53;
        let base_15 = base[15usize];
        let sum_49_base_15 = sum_49 * base_15;
        let difference_58 = T::fused(-difference_36, base_14, sum_49_base_15);
        let lambda_B_y = base_12 * difference_58;
        let difference_60 = force_1 - lambda_B_y;
        let c18_difference_60 = c[18usize] * difference_60;
        let base_2_lambda_B_x = base_2 * lambda_B_x;
        let difference_64 = T::fused(-base_0, lambda_B_y, base_2_lambda_B_x);
        let c19_difference_64 = c[19usize] * difference_64;
        let sum_68 = T::fused(force_2, c[21usize], c19_difference_64);
        let sum_69 = force_3 + lambda_B_x;
        let base_10_lambda_B_y = base_10 * lambda_B_y;
        let difference_72 = T::fused(-base_11, lambda_B_x, base_10_lambda_B_y);
        let c15_difference_72 = c[15usize] * difference_72;
        let lambda_front = T::fused(right_side_front, c[20usize], c15_difference_72);
        let sum_78 = T::fused(base_11, lambda_front, sum_69);
        let c22_sum_78 = c[22usize] * sum_78;
        let sum_80 = force_4 + lambda_B_y;
        let difference_82 = T::fused(-base_10, lambda_front, sum_80);
        let c22_difference_82 = c[22usize] * difference_82;
        let force_5_c29 = force_5 * c[29usize];
        let difference_87 = T::fused(-c[23usize], difference_72, force_5_c29);
        let difference_89 = T::fused(-c[25usize], lambda_front, difference_87);
        let target = ::ezy_core::kernel::array_mut::<6usize, T>(&mut store.a);
        target[0usize] = c18_difference_53;
        target[1usize] = c18_difference_60;
        target[2usize] = sum_68;
        target[3usize] = c22_sum_78;
        target[4usize] = c22_difference_82;
        target[5usize] = difference_89;
        let target = ::ezy_core::kernel::row_mut::<
            3usize,
            T,
        >(&mut store.lambda, k + 0usize);
        target[0usize] = lambda_B_x;
        target[1usize] = lambda_B_y;
        target[2usize] = lambda_front;
    }
    #[inline(always)]
    fn finish(&self, c: &[T], k: usize, store: &mut ::ezy_core::model::SeriesStore<T>) {
        let c = ::ezy_core::kernel::array::<40usize, T>(c);
        let a = ::ezy_core::kernel::array::<6usize, T>(&store.a);
        let base = ::ezy_core::kernel::array::<16usize, T>(&store.base);
        let kept_1 = ::ezy_core::kernel::row::<5usize, T>(&store.kept, k + 1usize);
        let lambda_0 = ::ezy_core::kernel::row::<3usize, T>(&store.lambda, k + 0usize);
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
        let lambda_0 = lambda_0[0usize];
        let convolved_19 = sums[19usize];
        let product_19 = inverse_order_ahead * convolved_19;
        let base_0 = base[0usize];
        let sum_22 = T::fused(product_3_a_2, base_0, product_19);
        let lambda_1 = lambda_0[1usize];
        let convolved_17 = sums[17usize];
        let product_25 = inverse_order_ahead * convolved_17;
        let base_2 = base[2usize];
        let sum_28 = T::fused(product_3_a_2, base_2, product_25);
        let lambda_2 = lambda_0[2usize];
        let convolved_20 = sums[20usize];
        let product_31 = inverse_order_ahead * convolved_20;
        let base_10 = base[10usize];
        let sum_34 = T::fused(product_3_a_5, base_10, product_31);
        let convolved_18 = sums[18usize];
        let product_36 = inverse_order_ahead * convolved_18;
        let base_11 = base[11usize];
        let sum_39 = T::fused(product_3_a_5, base_11, product_36);
        let order_ahead = T::from_f64((k + 2usize) as f64);
        let product_41 = product_3_a_2 * order_ahead;
        let product_42 = product_3_a_5 * order_ahead;
        let product_43 = product_3_a_3 * order_ahead;
        let product_44 = product_3_a_4 * order_ahead;
        let kept_3_next = kept_1[3usize];
        let inverse_order_ahead_c7 = inverse_order_ahead * c[7usize];
        let product_49 = kept_3_next * inverse_order_ahead_c7;
        let c6_product_49 = c[6usize] * product_49;
        let kept_4_next = kept_1[4usize];
        let product_52 = inverse_order_ahead_c7 * kept_4_next;
        let value_53 = -sum_28;
        let value_54 = -sum_39;
        let value_55 = -c6_product_49;
        let value_56 = -product_49;
        let target = ::ezy_core::kernel::row_mut::<
            5usize,
            T,
        >(&mut store.kept, k + 2usize);
        target[0usize] = value_53;
        target[1usize] = sum_22;
        target[2usize] = value_55;
        target[3usize] = product_52;
        target[4usize] = value_56;
        let target = ::ezy_core::kernel::row_mut::<
            24usize,
            T,
        >(&mut store.left, k + 2usize);
        target[11usize] = sum_22;
        target[12usize] = value_53;
        target[13usize] = sum_34;
        target[14usize] = value_54;
        target[15usize] = sum_34;
        target[16usize] = value_54;
        target[17usize] = product_41;
        target[18usize] = product_42;
        target[19usize] = product_41;
        target[20usize] = product_42;
        target[21usize] = sum_34;
        target[22usize] = value_54;
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
        target[11usize] = lambda_0;
        target[12usize] = lambda_1;
        target[13usize] = lambda_2;
        target[14usize] = lambda_2;
        target[15usize] = lambda_0;
        target[16usize] = lambda_1;
        target[17usize] = sum_22;
        target[18usize] = sum_34;
        target[19usize] = value_53;
        target[20usize] = value_54;
        target[21usize] = product_43;
        target[22usize] = product_44;
    }
}
