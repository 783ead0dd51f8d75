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
        let product_25 = c[16usize] * seat_omega;
        let product_26 = seat_omega * product_25;
        let product_27 = cos_seat_phi * product_26;
        let bar_omega = v[5usize];
        let product_29 = c[17usize] * bar_omega;
        let product_30 = bar_omega * product_29;
        let sum_32 = T::fused(cos_bar_phi, product_30, product_27);
        let product_33 = sin_seat_phi * product_26;
        let sum_35 = T::fused(sin_bar_phi, product_30, product_33);
        let seat_vx = v[0usize];
        let product_37 = cos_seat_phi * seat_vx;
        let seat_vy = v[1usize];
        let sum_40 = T::fused(sin_seat_phi, seat_vy, product_37);
        let product_41 = seat_omega * sum_40;
        let bar_vx = v[3usize];
        let product_43 = cos_bar_phi * bar_vx;
        let bar_vy = v[4usize];
        let sum_46 = T::fused(sin_bar_phi, bar_vy, product_43);
        let product_47 = bar_omega * sum_46;
        let product_49 = seat_vx * c[0usize];
        let product_51 = seat_omega * c[1usize];
        let sum_53 = T::fused(sin_seat_phi, product_51, product_49);
        let product_55 = cos_seat_phi * product_51;
        let difference_56 = T::fused(-seat_vy, c[0usize], product_55);
        let product_58 = cos_seat_phi * seat_vy;
        let difference_59 = T::fused(-sin_seat_phi, seat_vx, product_58);
        let product_60 = c[1usize] * difference_59;
        let difference_63 = T::fused(-seat_omega, c[2usize], product_60);
        let product_67 = c[4usize] * t;
        let (sin_67, cos_67) = T::sin_cos(product_67);
        let product_69 = c[3usize] * cos_67;
        let sum_70 = difference_63 + product_69;
        let product_98 = cos_seat_phi * c[8usize];
        let product_99 = cos_seat_phi * product_98;
        let product_101 = cos_bar_phi * c[9usize];
        let sum_103 = T::fused(cos_bar_phi, product_101, product_99);
        let sum_105 = sum_103 + c[10usize];
        let product_106 = sin_seat_phi * c[8usize];
        let product_107 = cos_seat_phi * product_106;
        let product_108 = sin_bar_phi * c[9usize];
        let sum_110 = T::fused(cos_bar_phi, product_108, product_107);
        let difference_112 = c[11usize] - sum_103;
        let product_141 = sum_105 * difference_112;
        let difference_143 = T::fused(-sum_110, sum_110, product_141);
        let quotient_144 = T::from_f64(1f64) / difference_143;
        let product_201 = cos_seat_phi * seat_omega;
        let product_202 = sin_seat_phi * seat_omega;
        let product_203 = cos_bar_phi * bar_omega;
        let product_204 = sin_bar_phi * bar_omega;
        let product_205 = c[4usize] * sin_67;
        let product_206 = c[3usize] * product_205;
        let product_207 = c[4usize] * cos_67;
        let value_208 = -sum_53;
        let value_209 = -product_69;
        let value_210 = -product_202;
        let value_211 = -product_204;
        let value_212 = -product_206;
        let value_213 = -product_205;
        let target = ::ezy_core::kernel::array_mut::<11usize, T>(&mut store.base);
        target[0usize] = sin_seat_phi;
        target[1usize] = product_51;
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
        target[2usize] = product_69;
        target[3usize] = sin_67;
        target[4usize] = cos_67;
        let target = ::ezy_core::kernel::row_mut::<5usize, T>(&mut store.kept, 1usize);
        target[0usize] = product_201;
        target[1usize] = value_210;
        target[2usize] = value_212;
        target[3usize] = product_207;
        target[4usize] = value_213;
        let target = ::ezy_core::kernel::row_mut::<24usize, T>(&mut store.left, 1usize);
        target[0usize] = T::from_f64(0f64);
        target[1usize] = product_201;
        target[2usize] = T::from_f64(0f64);
        target[3usize] = value_210;
        target[4usize] = T::from_f64(0f64);
        target[5usize] = T::from_f64(0f64);
        target[6usize] = product_201;
        target[7usize] = value_210;
        target[8usize] = product_203;
        target[9usize] = value_211;
        target[10usize] = product_203;
        target[11usize] = value_211;
        target[12usize] = seat_omega;
        target[13usize] = bar_omega;
        target[14usize] = seat_omega;
        target[15usize] = bar_omega;
        target[16usize] = product_201;
        target[17usize] = value_210;
        target[18usize] = product_203;
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
        target[12usize] = product_201;
        target[13usize] = product_203;
        target[14usize] = value_210;
        target[15usize] = value_211;
        target[16usize] = seat_vx;
        target[17usize] = seat_vy;
        target[18usize] = bar_vx;
        target[19usize] = bar_vy;
        let target = ::ezy_core::kernel::row_mut::<24usize, T>(&mut store.right, 2usize);
        target[0usize] = product_51;
        target[2usize] = product_51;
        target[4usize] = seat_vy;
        target[5usize] = seat_vx;
        let target = ::ezy_core::kernel::array_mut::<4usize, T>(&mut store.row);
        target[0usize] = sum_32;
        target[1usize] = sum_35;
        target[2usize] = product_41;
        target[3usize] = product_47;
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
        let product_3 = order_next * q_0_next;
        let convolved_0 = sums[0usize];
        let q_2_next = q_1[2usize];
        let product_8 = order_next * q_2_next;
        let product_9 = c[1usize] * product_8;
        let base_0 = base[0usize];
        let product_11 = product_9 * base_0;
        let kept_0 = kept_0[0usize];
        let base_1 = base[1usize];
        let sum_15 = T::fused(kept_0, base_1, product_11);
        let sum_16 = convolved_0 + sum_15;
        let sum_17 = T::fused(c[0usize], product_3, sum_16);
        let convolved_1 = sums[1usize];
        let difference_21 = convolved_1 - sum_17;
        let convolved_2 = sums[2usize];
        let base_2 = base[2usize];
        let product_24 = product_9 * base_2;
        let kept_1 = kept_0[1usize];
        let sum_27 = T::fused(base_1, kept_1, product_24);
        let sum_28 = convolved_2 + sum_27;
        let q_1_next = q_1[1usize];
        let product_30 = order_next * q_1_next;
        let difference_32 = T::fused(-c[0usize], product_30, sum_28);
        let convolved_3 = sums[3usize];
        let difference_34 = difference_32 - convolved_3;
        let convolved_4 = sums[4usize];
        let product_36 = base_2 * product_30;
        let base_3 = base[3usize];
        let sum_39 = T::fused(kept_1, base_3, product_36);
        let sum_40 = convolved_4 + sum_39;
        let convolved_5 = sums[5usize];
        let product_42 = product_3 * base_0;
        let base_4 = base[4usize];
        let sum_45 = T::fused(kept_0, base_4, product_42);
        let sum_46 = convolved_5 + sum_45;
        let difference_47 = sum_40 - sum_46;
        let product_48 = c[1usize] * difference_47;
        let difference_51 = T::fused(-product_8, c[2usize], product_48);
        let kept_2 = kept_0[2usize];
        let sum_53 = difference_51 + kept_2;
        let convolved_6 = sums[6usize];
        let convolved_7 = sums[7usize];
        let product_58 = c[16usize] * convolved_7;
        let difference_59 = T::fused(-c[16usize], convolved_6, product_58);
        let difference_60 = sum_53 - difference_59;
        let convolved_8 = sums[8usize];
        let convolved_9 = sums[9usize];
        let convolved_10 = sums[10usize];
        let convolved_11 = sums[11usize];
        let product_67 = c[17usize] * convolved_11;
        let difference_68 = T::fused(-c[17usize], convolved_10, product_67);
        let sum_69 = kept_2 + difference_68;
        let convolved_12 = sums[12usize];
        let inverse_order_ahead = T::from_f64(1f64) / T::from_f64((k + 2usize) as f64);
        let product_72 = convolved_12 * inverse_order_ahead;
        let product_73 = c[16usize] * product_72;
        let convolved_13 = sums[13usize];
        let product_75 = inverse_order_ahead * convolved_13;
        let sum_77 = T::fused(c[17usize], product_75, product_73);
        let order_ahead = T::from_f64((k + 2usize) as f64);
        let product_79 = order_next * order_ahead;
        let product_80 = sum_77 * product_79;
        let convolved_14 = sums[14usize];
        let product_82 = inverse_order_ahead * convolved_14;
        let product_83 = c[16usize] * product_82;
        let convolved_15 = sums[15usize];
        let product_85 = inverse_order_ahead * convolved_15;
        let sum_87 = T::fused(c[17usize], product_85, product_83);
        let product_88 = product_79 * sum_87;
        let convolved_16 = sums[16usize];
        let convolved_17 = sums[17usize];
        let difference_91 = convolved_16 - convolved_17;
        let product_92 = order_next * difference_91;
        let convolved_18 = sums[18usize];
        let convolved_19 = sums[19usize];
        let difference_95 = convolved_18 - convolved_19;
        let product_96 = order_next * difference_95;
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
        target[0usize] = product_9;
        target[2usize] = product_9;
        target[4usize] = product_30;
        target[5usize] = product_3;
        let target = ::ezy_core::kernel::array_mut::<4usize, T>(&mut store.row);
        target[0usize] = product_80;
        target[1usize] = value_99;
        target[2usize] = product_92;
        target[3usize] = product_96;
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
        let product_8 = force_2 * c[12usize];
        let base_2 = base[2usize];
        let force_1 = force[1usize];
        let product_11 = base_2 * force_1;
        let difference_13 = T::fused(-force_0, base_0, product_11);
        let product_14 = c[5usize] * difference_13;
        let difference_17 = T::fused(-force_2, c[6usize], product_14);
        let row_2 = row[2usize];
        let right_side_rear = difference_17 - row_2;
        let sum_22 = T::fused(right_side_rear, c[13usize], product_8);
        let product_23 = base_0 * sum_22;
        let base_6 = base[6usize];
        let force_5 = force[5usize];
        let product_27 = force_5 * c[22usize];
        let base_5 = base[5usize];
        let force_4 = force[4usize];
        let product_30 = base_5 * force_4;
        let force_3 = force[3usize];
        let difference_33 = T::fused(-base_6, force_3, product_30);
        let product_35 = difference_33 * c[21usize];
        let sum_38 = T::fused(force_5, c[24usize], product_35);
        let row_3 = row[3usize];
        let right_side_front = sum_38 - row_3;
        let sum_43 = T::fused(right_side_front, c[15usize], product_27);
        let sum_45 = T::fused(base_6, sum_43, product_23);
        let difference_46 = T::fused(c[5usize], force_0, -sum_45);
        let difference_48 = T::fused(-force_3, c[21usize], difference_46);
        let row_0 = row[0usize];
        let difference_50 = difference_48 - row_0;
        let product_51 = base_8 * difference_50;
        let base_9 = base[9usize];
        let product_53 = base_2 * sum_22;
        let sum_55 = T::fused(base_5, sum_43, product_53);
        let sum_57 = T::fused(c[5usize], force_1, sum_55);
        let difference_59 = T::fused(-force_4, c[21usize], sum_57);
        let row_1 = row[1usize];
        let difference_61 = difference_59 - row_1;
        let difference_63 = T::fused(-base_9, difference_61, product_51);
        let lambda_B_x = base_7 * difference_63;
        let difference_65 = force_0 - lambda_B_x;
        let base_10 = base[10usize];
        let product_67 = difference_61 * base_10;
        let difference_69 = T::fused(-difference_50, base_9, product_67);
        let lambda_B_y = base_7 * difference_69;
        let product_71 = base_2 * lambda_B_y;
        let difference_73 = T::fused(-base_0, lambda_B_x, product_71);
        let product_74 = c[13usize] * difference_73;
        let lambda_rear = T::fused(right_side_rear, c[19usize], product_74);
        let sum_79 = T::fused(base_0, lambda_rear, difference_65);
        let product_80 = c[5usize] * sum_79;
        let difference_81 = force_1 - lambda_B_y;
        let difference_83 = T::fused(-base_2, lambda_rear, difference_81);
        let product_84 = c[5usize] * difference_83;
        let product_86 = force_2 * c[20usize];
        let difference_88 = T::fused(-c[12usize], difference_73, product_86);
        let sum_90 = T::fused(c[6usize], lambda_rear, difference_88);
        let sum_91 = force_3 + lambda_B_x;
        let product_92 = base_5 * lambda_B_y;
        let difference_94 = T::fused(-base_6, lambda_B_x, product_92);
        let product_95 = c[15usize] * difference_94;
        let lambda_front = T::fused(right_side_front, c[18usize], product_95);
        let sum_100 = T::fused(base_6, lambda_front, sum_91);
        let product_101 = c[21usize] * sum_100;
        let sum_102 = force_4 + lambda_B_y;
        let difference_104 = T::fused(-base_5, lambda_front, sum_102);
        let product_105 = c[21usize] * difference_104;
        let product_107 = force_5 * c[30usize];
        let difference_109 = T::fused(-c[22usize], difference_94, product_107);
        let difference_111 = T::fused(-c[24usize], lambda_front, difference_109);
        let target = ::ezy_core::kernel::array_mut::<6usize, T>(&mut store.a);
        target[0usize] = product_80;
        target[1usize] = product_84;
        target[2usize] = sum_90;
        target[3usize] = product_101;
        target[4usize] = product_105;
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
        let convolved_14 = sums[14usize];
        let product_19 = inverse_order_ahead * convolved_14;
        let base_2 = base[2usize];
        let sum_22 = T::fused(product_8, base_2, product_19);
        let convolved_12 = sums[12usize];
        let product_24 = inverse_order_ahead * convolved_12;
        let base_0 = base[0usize];
        let sum_27 = T::fused(product_8, base_0, product_24);
        let lambda_0 = lambda_0[0usize];
        let lambda_1 = lambda_0[1usize];
        let lambda_3 = lambda_0[3usize];
        let convolved_15 = sums[15usize];
        let product_32 = inverse_order_ahead * convolved_15;
        let base_5 = base[5usize];
        let sum_35 = T::fused(product_14, base_5, product_32);
        let convolved_13 = sums[13usize];
        let product_37 = inverse_order_ahead * convolved_13;
        let base_6 = base[6usize];
        let sum_40 = T::fused(product_14, base_6, product_37);
        let order_ahead = T::from_f64((k + 2usize) as f64);
        let product_42 = product_8 * order_ahead;
        let product_43 = product_14 * order_ahead;
        let product_44 = product_4 * order_ahead;
        let product_45 = product_6 * order_ahead;
        let product_46 = product_10 * order_ahead;
        let product_47 = product_12 * order_ahead;
        let kept_3_next = kept_1[3usize];
        let product_51 = inverse_order_ahead * c[4usize];
        let product_52 = kept_3_next * product_51;
        let product_53 = c[3usize] * product_52;
        let kept_4_next = kept_1[4usize];
        let product_55 = product_51 * kept_4_next;
        let value_56 = -sum_27;
        let value_57 = -sum_40;
        let value_58 = -product_53;
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
        target[0usize] = product_4;
        target[1usize] = product_6;
        target[2usize] = product_8;
        target[3usize] = product_10;
        target[4usize] = product_12;
        target[5usize] = product_14;
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
