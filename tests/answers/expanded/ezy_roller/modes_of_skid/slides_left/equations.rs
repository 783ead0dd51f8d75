#[automatically_derived]
impl<T: ezy::Scalar> ezy::Equations<T> for self::SlidesLeft {
    fn constants(&self, parameters: &[T], c: &mut [T]) {
        let parameters = ezy::array::<11usize, T>(parameters);
        let c = ezy::array_mut::<35usize, T>(c);
        let k1 = T::from_f64(1f64);
        let parameter_m1 = parameters[4usize];
        let parameter_i1 = parameters[5usize];
        let parameter_m2 = parameters[6usize];
        let parameter_i2 = parameters[7usize];
        let parameter_b = parameters[1usize];
        let parameter_d = parameters[3usize];
        let parameter_c = parameters[2usize];
        let parameter_m0 = parameters[8usize];
        let parameter_omega = parameters[9usize];
        let parameter_hold = parameters[10usize];
        let parameter_a = parameters[0usize];
        let k14 = parameter_hold * parameter_a;
        let k15 = T::PI;
        let k16 = k1 / parameter_m1;
        let k17 = parameter_hold * k16;
        let k18 = k1 / parameter_i1;
        let k19 = parameter_b * k18;
        let k20 = k1 / parameter_m2;
        let k21 = k1 / parameter_i2;
        let k22 = parameter_d * parameter_m0;
        let k23 = k22 * k21;
        let k24 = parameter_c * parameter_m0;
        let k25 = k24 * k21;
        let k26 = parameter_b * parameter_b;
        let k27 = k26 * k18;
        let k28 = parameter_d * parameter_d;
        let k29 = k28 * k21;
        let k30 = k16 + k27;
        let k31 = k30 + k20;
        let k32 = k31 + k29;
        let k33 = parameter_d * parameter_c;
        let k34 = k33 * k21;
        let k35 = k20 - k34;
        let k36 = k16 + k20;
        let k37 = parameter_c * parameter_c;
        let k38 = k37 * k21;
        let k39 = k20 + k38;
        let k40 = k1 / k39;
        let k41 = k35 * k40;
        let k42 = k41 * k35;
        let k43 = k32 - k42;
        let k44 = k42 - k29;
        let k45 = parameter_m0 * k21;
        let k46 = parameter_d * k21;
        let k47 = parameter_c * k21;
        let k48 = T::from_f64(0.0000000001f64);
        let k49 = k48 * k39;
        let k50 = k32 + k36;
        let k51 = k50 * k50;
        let k52 = k48 * k51;
        let k53 = T::from_f64(2f64);
        let k54 = parameter_b * k53;
        let k55 = parameter_d * k53;
        c[0usize] = parameter_m0;
        c[1usize] = parameter_omega;
        c[2usize] = k14;
        c[3usize] = k25;
        c[4usize] = k27;
        c[5usize] = k44;
        c[6usize] = k43;
        c[7usize] = k36;
        c[8usize] = k17;
        c[9usize] = k19;
        c[10usize] = k23;
        c[11usize] = k41;
        c[12usize] = parameter_b;
        c[13usize] = parameter_d;
        c[14usize] = k40;
        c[15usize] = k16;
        c[16usize] = k18;
        c[17usize] = k20;
        c[18usize] = k46;
        c[19usize] = k45;
        c[20usize] = k47;
        c[21usize] = k39;
        c[22usize] = k49;
        c[23usize] = k52;
        c[24usize] = parameter_hold;
        c[25usize] = k21;
        c[26usize] = parameter_m1;
        c[27usize] = parameter_i1;
        c[28usize] = parameter_m2;
        c[29usize] = parameter_i2;
        c[30usize] = parameter_c;
        c[31usize] = parameter_a;
        c[32usize] = k15;
        c[33usize] = k54;
        c[34usize] = k55;
    }
    fn mass_matrix(&self, c: &[T], out: &mut [T]) {
        let c = ezy::array::<35usize, T>(c);
        let out = ezy::array_mut::<6usize, T>(out);
        out[0usize] = c[26usize];
        out[1usize] = c[26usize];
        out[2usize] = c[27usize];
        out[3usize] = c[28usize];
        out[4usize] = c[28usize];
        out[5usize] = c[29usize];
    }
    fn position_constraint(&self, c: &[T], t: T, q: &[T], out: &mut [T]) {
        let c = ezy::array::<35usize, T>(c);
        let q = ezy::array::<6usize, T>(q);
        let out = ezy::array_mut::<2usize, T>(out);
        let seat_x = q[0usize];
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
        let sum_7 = T::fused(c[12usize], cos_seat_phi, seat_x);
        let bar_x = q[3usize];
        let difference_9 = sum_7 - bar_x;
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
        let sum_14 = T::fused(c[13usize], cos_bar_phi, difference_9);
        let seat_y = q[1usize];
        let sum_18 = T::fused(c[12usize], sin_seat_phi, seat_y);
        let bar_y = q[4usize];
        let difference_20 = sum_18 - bar_y;
        let sum_23 = T::fused(c[13usize], sin_bar_phi, difference_20);
        out[0usize] = sum_14;
        out[1usize] = sum_23;
    }
    fn velocity_constraint(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
        let c = ezy::array::<35usize, T>(c);
        let q = ezy::array::<6usize, T>(q);
        let v = ezy::array::<6usize, T>(v);
        let out = ezy::array_mut::<3usize, T>(out);
        let seat_vx = v[0usize];
        let bar_vx = v[3usize];
        let difference_4 = seat_vx - bar_vx;
        let bar_omega = v[5usize];
        let product_7 = c[13usize] * bar_omega;
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
        let difference_11 = T::fused(-product_7, sin_bar_phi, difference_4);
        let seat_omega = v[2usize];
        let product_14 = c[12usize] * seat_omega;
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
        let difference_18 = T::fused(-product_14, sin_seat_phi, difference_11);
        let seat_vy = v[1usize];
        let bar_vy = v[4usize];
        let difference_21 = seat_vy - bar_vy;
        let sum_24 = T::fused(product_7, cos_bar_phi, difference_21);
        let sum_27 = T::fused(product_14, cos_seat_phi, sum_24);
        let product_29 = bar_omega * c[30usize];
        let difference_31 = T::fused(-bar_vx, sin_bar_phi, product_29);
        let sum_33 = T::fused(bar_vy, cos_bar_phi, difference_31);
        out[0usize] = difference_18;
        out[1usize] = sum_27;
        out[2usize] = sum_33;
    }
    fn velocity_jacobian(&self, c: &[T], t: T, q: &[T], out: &mut [T]) {
        let c = ezy::array::<35usize, T>(c);
        let q = ezy::array::<6usize, T>(q);
        let out = ezy::array_mut::<11usize, T>(out);
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
        let product_4 = c[12usize] * sin_seat_phi;
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
        let product_8 = c[13usize] * sin_bar_phi;
        let product_10 = c[12usize] * cos_seat_phi;
        let product_12 = c[13usize] * cos_bar_phi;
        let value_14 = -product_4;
        let value_15 = -T::from_f64(1f64);
        let value_16 = -product_8;
        let value_17 = -sin_bar_phi;
        out[0usize] = T::from_f64(1f64);
        out[1usize] = value_14;
        out[2usize] = value_15;
        out[3usize] = value_16;
        out[4usize] = T::from_f64(1f64);
        out[5usize] = product_10;
        out[6usize] = value_15;
        out[7usize] = product_12;
        out[8usize] = value_17;
        out[9usize] = cos_bar_phi;
        out[10usize] = c[30usize];
    }
    fn convective_term(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
        let c = ezy::array::<35usize, T>(c);
        let q = ezy::array::<6usize, T>(q);
        let v = ezy::array::<6usize, T>(v);
        let out = ezy::array_mut::<3usize, T>(out);
        let seat_omega = v[2usize];
        let product_3 = c[12usize] * seat_omega;
        let product_4 = seat_omega * product_3;
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
        let product_8 = product_4 * cos_seat_phi;
        let bar_omega = v[5usize];
        let product_11 = c[13usize] * bar_omega;
        let product_12 = bar_omega * product_11;
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
        let sum_16 = T::fused(product_12, cos_bar_phi, product_8);
        let product_18 = product_4 * sin_seat_phi;
        let sum_21 = T::fused(product_12, sin_bar_phi, product_18);
        let bar_vx = v[3usize];
        let product_23 = cos_bar_phi * bar_vx;
        let bar_vy = v[4usize];
        let sum_26 = T::fused(sin_bar_phi, bar_vy, product_23);
        let product_27 = bar_omega * sum_26;
        let value_28 = -sum_16;
        let value_29 = -sum_21;
        let value_30 = -product_27;
        out[0usize] = value_28;
        out[1usize] = value_29;
        out[2usize] = value_30;
    }
    fn applied_force(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
        let c = ezy::array::<35usize, T>(c);
        let q = ezy::array::<6usize, T>(q);
        let v = ezy::array::<6usize, T>(v);
        let out = ezy::array_mut::<6usize, T>(out);
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
        let product_4 = c[24usize] * sin_seat_phi;
        let product_6 = c[24usize] * cos_seat_phi;
        let product_11 = c[1usize] * t;
        let cos_11 = T::cos(product_11);
        let product_13 = c[0usize] * cos_11;
        let sum_15 = product_13 + c[2usize];
        let value_16 = -product_6;
        let value_17 = -product_13;
        out[0usize] = product_4;
        out[1usize] = value_16;
        out[2usize] = sum_15;
        out[3usize] = T::from_f64(0f64);
        out[4usize] = T::from_f64(0f64);
        out[5usize] = value_17;
    }
    #[inline]
    fn accelerations(
        &self,
        c: &[T],
        t: T,
        q: &[T],
        v: &[T],
        a: &mut [T],
        lambda: &mut [T],
    ) -> ezy::Pivots {
        let c = ezy::array::<35usize, T>(c);
        let q = ezy::array::<6usize, T>(q);
        let v = ezy::array::<6usize, T>(v);
        let a = ezy::array_mut::<6usize, T>(a);
        let lambda = ezy::array_mut::<3usize, T>(lambda);
        let product_4 = c[1usize] * t;
        let cos_4 = T::cos(product_4);
        let force_seat_phi = T::fused(c[0usize], cos_4, c[2usize]);
        let bar_vx = v[3usize];
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
        let product_13 = bar_vx * cos_bar_phi;
        let bar_vy = v[4usize];
        let sum_17 = T::fused(bar_vy, sin_bar_phi, product_13);
        let bar_omega = v[5usize];
        let product_19 = sum_17 * bar_omega;
        let minus_right_side_front = T::fused(cos_4, c[3usize], product_19);
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
        let product_26 = c[4usize] * cos_seat_phi;
        let product_29 = cos_bar_phi * c[5usize];
        let product_30 = cos_bar_phi * product_29;
        let difference_31 = T::fused(-cos_seat_phi, product_26, product_30);
        let sum_33 = difference_31 + c[6usize];
        let product_35 = c[4usize] * sin_seat_phi;
        let product_37 = sin_bar_phi * c[5usize];
        let product_38 = cos_bar_phi * product_37;
        let difference_39 = T::fused(-cos_seat_phi, product_35, product_38);
        let difference_41 = c[7usize] - difference_31;
        let difference_45 = T::fused(-force_seat_phi, c[9usize], c[8usize]);
        let product_46 = sin_seat_phi * difference_45;
        let product_48 = cos_4 * c[10usize];
        let sum_51 = T::fused(minus_right_side_front, c[11usize], product_48);
        let sum_53 = T::fused(sin_bar_phi, sum_51, product_46);
        let seat_omega = v[2usize];
        let product_56 = c[12usize] * seat_omega;
        let product_57 = seat_omega * product_56;
        let difference_59 = T::fused(-cos_seat_phi, product_57, sum_53);
        let product_61 = bar_omega * c[13usize];
        let product_62 = bar_omega * product_61;
        let difference_64 = T::fused(-cos_bar_phi, product_62, difference_59);
        let product_65 = cos_seat_phi * difference_45;
        let sum_67 = T::fused(cos_bar_phi, sum_51, product_65);
        let sum_69 = T::fused(sin_seat_phi, product_57, sum_67);
        let sum_71 = T::fused(sin_bar_phi, product_62, sum_69);
        let product_72 = sum_33 * difference_41;
        let difference_74 = T::fused(-difference_39, difference_39, product_72);
        let quotient_75 = T::from_f64(1f64) / difference_74;
        let product_76 = difference_41 * difference_64;
        let sum_78 = T::fused(difference_39, sum_71, product_76);
        let lambda_B_x = quotient_75 * sum_78;
        let product_80 = difference_39 * difference_64;
        let sum_82 = T::fused(sum_33, sum_71, product_80);
        let minus_lambda_B_y = quotient_75 * sum_82;
        let product_84 = sin_bar_phi * lambda_B_x;
        let sum_86 = T::fused(cos_bar_phi, minus_lambda_B_y, product_84);
        let product_87 = c[11usize] * sum_86;
        let minus_lambda_front = T::fused(
            minus_right_side_front,
            c[14usize],
            product_87,
        );
        let product_91 = sin_seat_phi * c[8usize];
        let difference_94 = T::fused(-lambda_B_x, c[15usize], product_91);
        let product_96 = minus_lambda_B_y * c[15usize];
        let difference_97 = T::fused(-cos_seat_phi, c[8usize], product_96);
        let product_98 = sin_seat_phi * lambda_B_x;
        let sum_100 = T::fused(cos_seat_phi, minus_lambda_B_y, product_98);
        let product_101 = c[9usize] * sum_100;
        let sum_104 = T::fused(force_seat_phi, c[16usize], product_101);
        let difference_106 = T::fused(-sin_bar_phi, minus_lambda_front, lambda_B_x);
        let product_108 = difference_106 * c[17usize];
        let difference_110 = T::fused(
            cos_bar_phi,
            minus_lambda_front,
            -minus_lambda_B_y,
        );
        let product_111 = c[17usize] * difference_110;
        let product_113 = sum_86 * c[18usize];
        let difference_116 = T::fused(-cos_4, c[19usize], product_113);
        let sum_119 = T::fused(minus_lambda_front, c[20usize], difference_116);
        let value_123 = -minus_lambda_B_y;
        let value_124 = -minus_lambda_front;
        a[0usize] = difference_94;
        a[1usize] = difference_97;
        a[2usize] = sum_104;
        a[3usize] = product_108;
        a[4usize] = product_111;
        a[5usize] = sum_119;
        lambda[0usize] = lambda_B_x;
        lambda[1usize] = value_123;
        lambda[2usize] = value_124;
        ezy::Pivots::new()
            .see(&[2usize], T::least_ratio(c[21usize], c[22usize]))
            .see(&[0usize, 1usize], T::least_ratio(difference_74, c[23usize]))
    }
    #[inline]
    fn correction(
        &self,
        c: &[T],
        t: T,
        q: &[T],
        residual: &[T],
        delta: &mut [T],
    ) -> ezy::Pivots {
        let c = ezy::array::<35usize, T>(c);
        let q = ezy::array::<6usize, T>(q);
        let residual = ezy::array::<3usize, T>(residual);
        let delta = ezy::array_mut::<6usize, T>(delta);
        let right_side_front = residual[2usize];
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
        let product_6 = c[4usize] * cos_seat_phi;
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
        let product_11 = c[5usize] * cos_bar_phi;
        let product_12 = cos_bar_phi * product_11;
        let difference_13 = T::fused(-cos_seat_phi, product_6, product_12);
        let sum_15 = difference_13 + c[6usize];
        let product_17 = c[4usize] * sin_seat_phi;
        let product_20 = c[5usize] * sin_bar_phi;
        let product_21 = cos_bar_phi * product_20;
        let difference_22 = T::fused(-cos_seat_phi, product_17, product_21);
        let difference_24 = c[7usize] - difference_13;
        let residual_0 = residual[0usize];
        let product_27 = right_side_front * c[11usize];
        let difference_29 = T::fused(-sin_bar_phi, product_27, residual_0);
        let residual_1 = residual[1usize];
        let sum_32 = T::fused(cos_bar_phi, product_27, residual_1);
        let product_33 = sum_15 * difference_24;
        let difference_35 = T::fused(-difference_22, difference_22, product_33);
        let quotient_36 = T::from_f64(1f64) / difference_35;
        let product_37 = difference_24 * difference_29;
        let difference_39 = T::fused(-difference_22, sum_32, product_37);
        let lambda_B_x = quotient_36 * difference_39;
        let product_42 = sum_15 * sum_32;
        let difference_43 = T::fused(-difference_22, difference_29, product_42);
        let lambda_B_y = quotient_36 * difference_43;
        let product_46 = cos_bar_phi * lambda_B_y;
        let difference_47 = T::fused(-sin_bar_phi, lambda_B_x, product_46);
        let product_48 = c[11usize] * difference_47;
        let lambda_front = T::fused(right_side_front, c[14usize], product_48);
        let product_53 = lambda_B_x * c[15usize];
        let product_54 = lambda_B_y * c[15usize];
        let product_55 = sin_seat_phi * lambda_B_x;
        let difference_57 = T::fused(-cos_seat_phi, lambda_B_y, product_55);
        let product_59 = difference_57 * c[9usize];
        let sum_61 = T::fused(sin_bar_phi, lambda_front, lambda_B_x);
        let product_63 = sum_61 * c[17usize];
        let difference_65 = T::fused(-cos_bar_phi, lambda_front, lambda_B_y);
        let product_66 = c[17usize] * difference_65;
        let product_68 = difference_47 * c[18usize];
        let sum_71 = T::fused(lambda_front, c[20usize], product_68);
        let value_75 = -product_53;
        let value_76 = -product_54;
        let value_77 = -sum_71;
        delta[0usize] = value_75;
        delta[1usize] = value_76;
        delta[2usize] = product_59;
        delta[3usize] = product_63;
        delta[4usize] = product_66;
        delta[5usize] = value_77;
        ezy::Pivots::new()
            .see(&[2usize], T::least_ratio(c[21usize], c[22usize]))
            .see(&[0usize, 1usize], T::least_ratio(difference_35, c[23usize]))
    }
}
