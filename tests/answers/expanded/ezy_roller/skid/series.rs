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
        let product_25 = c[11usize] * seat_omega;
        let product_26 = seat_omega * product_25;
        let product_27 = cos_seat_phi * product_26;
        let bar_omega = v[5usize];
        let product_29 = c[12usize] * bar_omega;
        let product_30 = bar_omega * product_29;
        let sum_32 = T::fused(cos_bar_phi, product_30, product_27);
        let product_33 = sin_seat_phi * product_26;
        let sum_35 = T::fused(sin_bar_phi, product_30, product_33);
        let bar_vx = v[3usize];
        let product_37 = cos_bar_phi * bar_vx;
        let bar_vy = v[4usize];
        let sum_40 = T::fused(sin_bar_phi, bar_vy, product_37);
        let product_41 = bar_omega * sum_40;
        let seat_vx = v[0usize];
        let product_43 = cos_seat_phi * seat_vx;
        let seat_vy = v[1usize];
        let sum_46 = T::fused(sin_seat_phi, seat_vy, product_43);
        let product_47 = seat_omega * sum_46;
        let product_51 = c[1usize] * t;
        let (sin_51, cos_51) = T::sin_cos(product_51);
        let product_53 = c[28usize] * cos_51;
        let product_81 = cos_seat_phi * c[3usize];
        let product_82 = cos_seat_phi * product_81;
        let product_84 = cos_bar_phi * c[4usize];
        let sum_86 = T::fused(cos_bar_phi, product_84, product_82);
        let sum_88 = sum_86 + c[5usize];
        let product_89 = sin_seat_phi * c[3usize];
        let product_90 = cos_seat_phi * product_89;
        let product_91 = sin_bar_phi * c[4usize];
        let sum_93 = T::fused(cos_bar_phi, product_91, product_90);
        let difference_95 = c[6usize] - sum_86;
        let product_124 = sum_88 * difference_95;
        let difference_126 = T::fused(-sum_93, sum_93, product_124);
        let quotient_127 = T::from_f64(1f64) / difference_126;
        let product_184 = cos_seat_phi * seat_omega;
        let product_185 = sin_seat_phi * seat_omega;
        let product_186 = cos_bar_phi * bar_omega;
        let product_187 = sin_bar_phi * bar_omega;
        let product_188 = c[1usize] * sin_51;
        let product_189 = c[28usize] * product_188;
        let product_190 = c[1usize] * cos_51;
        let value_191 = -product_53;
        let value_192 = -product_185;
        let value_193 = -product_187;
        let value_194 = -product_189;
        let value_195 = -product_188;
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
        target[2usize] = product_53;
        target[3usize] = T::from_f64(0f64);
        target[4usize] = T::from_f64(0f64);
        target[5usize] = value_191;
        let target = ::ezy_core::kernel::row_mut::<3usize, T>(&mut store.kept, 0usize);
        target[0usize] = product_53;
        target[1usize] = sin_51;
        target[2usize] = cos_51;
        let target = ::ezy_core::kernel::row_mut::<3usize, T>(&mut store.kept, 1usize);
        target[0usize] = value_194;
        target[1usize] = product_190;
        target[2usize] = value_195;
        let target = ::ezy_core::kernel::row_mut::<16usize, T>(&mut store.left, 1usize);
        target[0usize] = product_184;
        target[1usize] = value_192;
        target[2usize] = product_184;
        target[3usize] = value_192;
        target[4usize] = product_186;
        target[5usize] = value_193;
        target[6usize] = product_186;
        target[7usize] = value_193;
        target[8usize] = seat_omega;
        target[9usize] = bar_omega;
        target[10usize] = seat_omega;
        target[11usize] = bar_omega;
        target[12usize] = product_186;
        target[13usize] = value_193;
        target[14usize] = product_184;
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
        target[8usize] = product_184;
        target[9usize] = product_186;
        target[10usize] = value_192;
        target[11usize] = value_193;
        target[12usize] = bar_vx;
        target[13usize] = bar_vy;
        target[14usize] = seat_vx;
        target[15usize] = seat_vy;
        let target = ::ezy_core::kernel::array_mut::<4usize, T>(&mut store.row);
        target[0usize] = sum_32;
        target[1usize] = sum_35;
        target[2usize] = product_41;
        target[3usize] = product_47;
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
        let product_9 = c[11usize] * convolved_3;
        let difference_10 = T::fused(-c[11usize], convolved_2, product_9);
        let difference_11 = kept_0 - difference_10;
        let convolved_4 = sums[4usize];
        let convolved_5 = sums[5usize];
        let convolved_6 = sums[6usize];
        let convolved_7 = sums[7usize];
        let product_18 = c[12usize] * convolved_7;
        let difference_19 = T::fused(-c[12usize], convolved_6, product_18);
        let sum_20 = kept_0 + difference_19;
        let convolved_8 = sums[8usize];
        let inverse_order_ahead = T::from_f64(1f64) / T::from_f64((k + 2usize) as f64);
        let product_23 = convolved_8 * inverse_order_ahead;
        let product_24 = c[11usize] * product_23;
        let convolved_9 = sums[9usize];
        let product_26 = inverse_order_ahead * convolved_9;
        let sum_28 = T::fused(c[12usize], product_26, product_24);
        let order_next = T::from_f64((k + 1usize) as f64);
        let order_ahead = T::from_f64((k + 2usize) as f64);
        let product_31 = order_next * order_ahead;
        let product_32 = sum_28 * product_31;
        let convolved_10 = sums[10usize];
        let product_34 = inverse_order_ahead * convolved_10;
        let product_35 = c[11usize] * product_34;
        let convolved_11 = sums[11usize];
        let product_37 = inverse_order_ahead * convolved_11;
        let sum_39 = T::fused(c[12usize], product_37, product_35);
        let product_40 = product_31 * sum_39;
        let convolved_12 = sums[12usize];
        let convolved_13 = sums[13usize];
        let difference_43 = convolved_12 - convolved_13;
        let product_44 = order_next * difference_43;
        let convolved_14 = sums[14usize];
        let convolved_15 = sums[15usize];
        let difference_47 = convolved_14 - convolved_15;
        let product_48 = order_next * difference_47;
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
        target[2usize] = product_44;
        target[3usize] = product_48;
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
        let product_8 = force_2 * c[16usize];
        let base_0 = base[0usize];
        let force_1 = force[1usize];
        let product_11 = base_0 * force_1;
        let difference_13 = T::fused(-force_0, base_1, product_11);
        let product_14 = c[15usize] * difference_13;
        let difference_17 = T::fused(-force_2, c[18usize], product_14);
        let row_3 = row[3usize];
        let right_side_rear_on_ice = difference_17 - row_3;
        let sum_22 = T::fused(right_side_rear_on_ice, c[8usize], product_8);
        let product_23 = base_1 * sum_22;
        let base_3 = base[3usize];
        let force_5 = force[5usize];
        let product_27 = force_5 * c[20usize];
        let base_2 = base[2usize];
        let force_4 = force[4usize];
        let product_30 = base_2 * force_4;
        let force_3 = force[3usize];
        let difference_33 = T::fused(-base_3, force_3, product_30);
        let product_35 = difference_33 * c[19usize];
        let sum_38 = T::fused(force_5, c[22usize], product_35);
        let row_2 = row[2usize];
        let right_side_front = sum_38 - row_2;
        let sum_43 = T::fused(right_side_front, c[10usize], product_27);
        let sum_45 = T::fused(base_3, sum_43, product_23);
        let difference_46 = T::fused(c[15usize], force_0, -sum_45);
        let difference_48 = T::fused(-force_3, c[19usize], difference_46);
        let row_0 = row[0usize];
        let difference_50 = difference_48 - row_0;
        let product_51 = base_5 * difference_50;
        let base_6 = base[6usize];
        let product_53 = base_0 * sum_22;
        let sum_55 = T::fused(base_2, sum_43, product_53);
        let sum_57 = T::fused(c[15usize], force_1, sum_55);
        let difference_59 = T::fused(-force_4, c[19usize], sum_57);
        let row_1 = row[1usize];
        let difference_61 = difference_59 - row_1;
        let difference_63 = T::fused(-base_6, difference_61, product_51);
        let lambda_B_x = base_4 * difference_63;
        let difference_65 = force_0 - lambda_B_x;
        let base_7 = base[7usize];
        let product_67 = difference_61 * base_7;
        let difference_69 = T::fused(-difference_50, base_6, product_67);
        let lambda_B_y = base_4 * difference_69;
        let product_71 = base_0 * lambda_B_y;
        let difference_73 = T::fused(-base_1, lambda_B_x, product_71);
        let product_74 = c[8usize] * difference_73;
        let lambda_rear_on_ice = T::fused(
            right_side_rear_on_ice,
            c[13usize],
            product_74,
        );
        let sum_79 = T::fused(base_1, lambda_rear_on_ice, difference_65);
        let product_80 = c[15usize] * sum_79;
        let difference_81 = force_1 - lambda_B_y;
        let difference_83 = T::fused(-base_0, lambda_rear_on_ice, difference_81);
        let product_84 = c[15usize] * difference_83;
        let product_86 = force_2 * c[29usize];
        let difference_88 = T::fused(-c[16usize], difference_73, product_86);
        let sum_90 = T::fused(c[18usize], lambda_rear_on_ice, difference_88);
        let sum_91 = force_3 + lambda_B_x;
        let product_92 = base_2 * lambda_B_y;
        let difference_94 = T::fused(-base_3, lambda_B_x, product_92);
        let product_95 = c[10usize] * difference_94;
        let lambda_front = T::fused(right_side_front, c[14usize], product_95);
        let sum_100 = T::fused(base_3, lambda_front, sum_91);
        let product_101 = c[19usize] * sum_100;
        let sum_102 = force_4 + lambda_B_y;
        let difference_104 = T::fused(-base_2, lambda_front, sum_102);
        let product_105 = c[19usize] * difference_104;
        let product_107 = force_5 * c[30usize];
        let difference_109 = T::fused(-c[20usize], difference_94, product_107);
        let difference_111 = T::fused(-c[22usize], lambda_front, difference_109);
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
        let lambda_3 = lambda_0[3usize];
        let convolved_10 = sums[10usize];
        let product_19 = inverse_order_ahead * convolved_10;
        let base_0 = base[0usize];
        let sum_22 = T::fused(product_8, base_0, product_19);
        let convolved_8 = sums[8usize];
        let product_24 = inverse_order_ahead * convolved_8;
        let base_1 = base[1usize];
        let sum_27 = T::fused(product_8, base_1, product_24);
        let lambda_0 = lambda_0[0usize];
        let lambda_1 = lambda_0[1usize];
        let lambda_2 = lambda_0[2usize];
        let convolved_11 = sums[11usize];
        let product_32 = inverse_order_ahead * convolved_11;
        let base_2 = base[2usize];
        let sum_35 = T::fused(product_14, base_2, product_32);
        let convolved_9 = sums[9usize];
        let product_37 = inverse_order_ahead * convolved_9;
        let base_3 = base[3usize];
        let sum_40 = T::fused(product_14, base_3, product_37);
        let order_ahead = T::from_f64((k + 2usize) as f64);
        let product_42 = product_8 * order_ahead;
        let product_43 = product_14 * order_ahead;
        let product_44 = product_10 * order_ahead;
        let product_45 = product_12 * order_ahead;
        let product_46 = product_4 * order_ahead;
        let product_47 = product_6 * order_ahead;
        let kept_1_next = kept_1[1usize];
        let product_51 = inverse_order_ahead * c[1usize];
        let product_52 = kept_1_next * product_51;
        let product_53 = c[28usize] * product_52;
        let kept_2_next = kept_1[2usize];
        let product_55 = product_51 * kept_2_next;
        let value_56 = -sum_27;
        let value_57 = -sum_40;
        let value_58 = -product_53;
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
        target[0usize] = product_4;
        target[1usize] = product_6;
        target[2usize] = product_8;
        target[3usize] = product_10;
        target[4usize] = product_12;
        target[5usize] = product_14;
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
