#[automatically_derived]
impl<T: ezy::Scalar> ezy::Equations<T> for self::Coast {
    fn constants(&self, parameters: &[T], c: &mut [T]) {
        let parameters = ezy::array::<8usize, T>(parameters);
        let c = ezy::array_mut::<32usize, T>(c);
        let k1 = T::from_f64(1f64);
        let parameter_m1 = parameters[4usize];
        let parameter_i1 = parameters[5usize];
        let parameter_m2 = parameters[6usize];
        let parameter_i2 = parameters[7usize];
        let parameter_b = parameters[1usize];
        let parameter_d = parameters[3usize];
        let parameter_a = parameters[0usize];
        let parameter_c = parameters[2usize];
        let k11 = T::PI;
        let k12 = T::from_f64(2f64);
        let k13 = k11 / k12;
        let k14 = k1 / parameter_m1;
        let k15 = k1 / parameter_i1;
        let k16 = k1 / parameter_m2;
        let k17 = k1 / parameter_i2;
        let k18 = parameter_b * parameter_b;
        let k19 = k18 * k15;
        let k20 = parameter_d * parameter_d;
        let k21 = k20 * k17;
        let k22 = k14 + k19;
        let k23 = k22 + k16;
        let k24 = k23 + k21;
        let k25 = parameter_b * parameter_a;
        let k26 = k25 * k15;
        let k27 = k26 - k14;
        let k28 = parameter_d * parameter_c;
        let k29 = k28 * k17;
        let k30 = k16 - k29;
        let k31 = k14 + k16;
        let k32 = parameter_a * parameter_a;
        let k33 = k32 * k15;
        let k34 = k14 + k33;
        let k35 = parameter_c * parameter_c;
        let k36 = k35 * k17;
        let k37 = k16 + k36;
        let k38 = k1 / k34;
        let k39 = k27 * k38;
        let k40 = k39 * k27;
        let k41 = k24 - k40;
        let k42 = k40 - k19;
        let k43 = k1 / k37;
        let k44 = k30 * k43;
        let k45 = k44 * k30;
        let k46 = k41 - k45;
        let k47 = k45 - k21;
        let k48 = parameter_b * k15;
        let k49 = parameter_a * k15;
        let k50 = parameter_d * k17;
        let k51 = parameter_c * k17;
        let k52 = T::from_f64(0.0000000001f64);
        let k53 = k52 * k34;
        let k54 = k52 * k37;
        let k55 = k24 + k31;
        let k56 = k55 * k55;
        let k57 = k52 * k56;
        let k58 = parameter_b * k12;
        let k59 = parameter_d * k12;
        c[0usize] = k42;
        c[1usize] = k47;
        c[2usize] = k46;
        c[3usize] = k31;
        c[4usize] = parameter_b;
        c[5usize] = parameter_d;
        c[6usize] = k39;
        c[7usize] = k44;
        c[8usize] = k43;
        c[9usize] = k38;
        c[10usize] = k14;
        c[11usize] = k48;
        c[12usize] = k49;
        c[13usize] = k16;
        c[14usize] = k50;
        c[15usize] = k51;
        c[16usize] = k34;
        c[17usize] = k53;
        c[18usize] = k37;
        c[19usize] = k54;
        c[20usize] = k57;
        c[21usize] = parameter_a;
        c[22usize] = parameter_c;
        c[23usize] = k15;
        c[24usize] = k17;
        c[25usize] = parameter_m1;
        c[26usize] = parameter_i1;
        c[27usize] = parameter_m2;
        c[28usize] = parameter_i2;
        c[29usize] = k13;
        c[30usize] = k58;
        c[31usize] = k59;
    }
    fn mass_matrix(&self, c: &[T], out: &mut [T]) {
        let c = ezy::array::<32usize, T>(c);
        let out = ezy::array_mut::<6usize, T>(out);
        out[0usize] = c[25usize];
        out[1usize] = c[25usize];
        out[2usize] = c[26usize];
        out[3usize] = c[27usize];
        out[4usize] = c[27usize];
        out[5usize] = c[28usize];
    }
    fn position_constraint(&self, c: &[T], t: T, q: &[T], out: &mut [T]) {
        let c = ezy::array::<32usize, T>(c);
        let q = ezy::array::<6usize, T>(q);
        let out = ezy::array_mut::<2usize, T>(out);
        let seat_x = q[0usize];
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
        let sum_7 = T::fused(c[4usize], cos_seat_phi, seat_x);
        let bar_x = q[3usize];
        let difference_9 = sum_7 - bar_x;
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
        let sum_14 = T::fused(c[5usize], cos_bar_phi, difference_9);
        let seat_y = q[1usize];
        let sum_18 = T::fused(c[4usize], sin_seat_phi, seat_y);
        let bar_y = q[4usize];
        let difference_20 = sum_18 - bar_y;
        let sum_23 = T::fused(c[5usize], sin_bar_phi, difference_20);
        out[0usize] = sum_14;
        out[1usize] = sum_23;
    }
    fn velocity_constraint(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
        let c = ezy::array::<32usize, T>(c);
        let q = ezy::array::<6usize, T>(q);
        let v = ezy::array::<6usize, T>(v);
        let out = ezy::array_mut::<4usize, T>(out);
        let seat_vx = v[0usize];
        let seat_omega = v[2usize];
        let c4_seat_omega = c[4usize] * seat_omega;
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
        let difference_9 = T::fused(-c4_seat_omega, sin_seat_phi, seat_vx);
        let bar_vx = v[3usize];
        let difference_11 = difference_9 - bar_vx;
        let bar_omega = v[5usize];
        let c5_bar_omega = c[5usize] * bar_omega;
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
        let difference_18 = T::fused(-c5_bar_omega, sin_bar_phi, difference_11);
        let seat_vy = v[1usize];
        let bar_vy = v[4usize];
        let difference_21 = seat_vy - bar_vy;
        let sum_24 = T::fused(c4_seat_omega, cos_seat_phi, difference_21);
        let sum_27 = T::fused(c5_bar_omega, cos_bar_phi, sum_24);
        let seat_omega_c21 = seat_omega * c[21usize];
        let sum_31 = T::fused(seat_vx, sin_seat_phi, seat_omega_c21);
        let difference_33 = T::fused(seat_vy, cos_seat_phi, -sum_31);
        let bar_omega_c22 = bar_omega * c[22usize];
        let difference_37 = T::fused(-bar_vx, sin_bar_phi, bar_omega_c22);
        let sum_39 = T::fused(bar_vy, cos_bar_phi, difference_37);
        out[0usize] = difference_18;
        out[1usize] = sum_27;
        out[2usize] = difference_33;
        out[3usize] = sum_39;
    }
    fn velocity_jacobian(&self, c: &[T], t: T, q: &[T], out: &mut [T]) {
        let c = ezy::array::<32usize, T>(c);
        let q = ezy::array::<6usize, T>(q);
        let out = ezy::array_mut::<14usize, T>(out);
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
        let c4_sin_seat_phi = c[4usize] * sin_seat_phi;
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
        let c5_sin_bar_phi = c[5usize] * sin_bar_phi;
        let c4_cos_seat_phi = c[4usize] * cos_seat_phi;
        let c5_cos_bar_phi = c[5usize] * cos_bar_phi;
        let value_15 = -c4_sin_seat_phi;
        let value_16 = -T::from_f64(1f64);
        let value_17 = -c5_sin_bar_phi;
        let value_18 = -sin_seat_phi;
        let value_19 = -c[21usize];
        let value_20 = -sin_bar_phi;
        out[0usize] = T::from_f64(1f64);
        out[1usize] = value_15;
        out[2usize] = value_16;
        out[3usize] = value_17;
        out[4usize] = T::from_f64(1f64);
        out[5usize] = c4_cos_seat_phi;
        out[6usize] = value_16;
        out[7usize] = c5_cos_bar_phi;
        out[8usize] = value_18;
        out[9usize] = cos_seat_phi;
        out[10usize] = value_19;
        out[11usize] = value_20;
        out[12usize] = cos_bar_phi;
        out[13usize] = c[22usize];
    }
    fn convective_term(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
        let c = ezy::array::<32usize, T>(c);
        let q = ezy::array::<6usize, T>(q);
        let v = ezy::array::<6usize, T>(v);
        let out = ezy::array_mut::<4usize, T>(out);
        let seat_omega = v[2usize];
        let c4_seat_omega = c[4usize] * seat_omega;
        let seat_omega_c4_seat_omega = seat_omega * c4_seat_omega;
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
        let product_8 = seat_omega_c4_seat_omega * cos_seat_phi;
        let bar_omega = v[5usize];
        let c5_bar_omega = c[5usize] * bar_omega;
        let bar_omega_c5_bar_omega = bar_omega * c5_bar_omega;
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
        let sum_16 = T::fused(bar_omega_c5_bar_omega, cos_bar_phi, product_8);
        let product_18 = seat_omega_c4_seat_omega * sin_seat_phi;
        let sum_21 = T::fused(bar_omega_c5_bar_omega, sin_bar_phi, product_18);
        let seat_vx = v[0usize];
        let cos_seat_phi_seat_vx = cos_seat_phi * seat_vx;
        let seat_vy = v[1usize];
        let sum_26 = T::fused(sin_seat_phi, seat_vy, cos_seat_phi_seat_vx);
        let seat_omega_sum_26 = seat_omega * sum_26;
        let bar_vx = v[3usize];
        let cos_bar_phi_bar_vx = cos_bar_phi * bar_vx;
        let bar_vy = v[4usize];
        let sum_32 = T::fused(sin_bar_phi, bar_vy, cos_bar_phi_bar_vx);
        let bar_omega_sum_32 = bar_omega * sum_32;
        let value_34 = -sum_16;
        let value_35 = -sum_21;
        let value_36 = -seat_omega_sum_26;
        let value_37 = -bar_omega_sum_32;
        out[0usize] = value_34;
        out[1usize] = value_35;
        out[2usize] = value_36;
        out[3usize] = value_37;
    }
    fn applied_force(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
        let c = ezy::array::<32usize, T>(c);
        let q = ezy::array::<6usize, T>(q);
        let v = ezy::array::<6usize, T>(v);
        let out = ezy::array_mut::<6usize, T>(out);
        out[0usize] = T::from_f64(0f64);
        out[1usize] = T::from_f64(0f64);
        out[2usize] = T::from_f64(0f64);
        out[3usize] = T::from_f64(0f64);
        out[4usize] = T::from_f64(0f64);
        out[5usize] = T::from_f64(0f64);
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
        let c = ezy::array::<32usize, T>(c);
        let q = ezy::array::<6usize, T>(q);
        let v = ezy::array::<6usize, T>(v);
        let a = ezy::array_mut::<6usize, T>(a);
        let lambda = ezy::array_mut::<4usize, T>(lambda);
        let seat_vx = v[0usize];
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
        let seat_vx_cos_seat_phi = seat_vx * cos_seat_phi;
        let seat_vy = v[1usize];
        let sum_9 = T::fused(seat_vy, sin_seat_phi, seat_vx_cos_seat_phi);
        let seat_omega = v[2usize];
        let minus_right_side_rear = sum_9 * seat_omega;
        let bar_vx = v[3usize];
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
        let bar_vx_cos_bar_phi = bar_vx * cos_bar_phi;
        let bar_vy = v[4usize];
        let sum_19 = T::fused(bar_vy, sin_bar_phi, bar_vx_cos_bar_phi);
        let bar_omega = v[5usize];
        let minus_right_side_front = sum_19 * bar_omega;
        let cos_seat_phi_c0 = cos_seat_phi * c[0usize];
        let product_24 = cos_seat_phi * cos_seat_phi_c0;
        let cos_bar_phi_c1 = cos_bar_phi * c[1usize];
        let sum_28 = T::fused(cos_bar_phi, cos_bar_phi_c1, product_24);
        let sum_30 = sum_28 + c[2usize];
        let sin_seat_phi_c0 = sin_seat_phi * c[0usize];
        let product_32 = cos_seat_phi * sin_seat_phi_c0;
        let sin_bar_phi_c1 = sin_bar_phi * c[1usize];
        let sum_35 = T::fused(cos_bar_phi, sin_bar_phi_c1, product_32);
        let difference_37 = c[3usize] - sum_28;
        let seat_omega_c4 = seat_omega * c[4usize];
        let seat_omega_seat_omega_c4 = seat_omega * seat_omega_c4;
        let product_41 = cos_seat_phi * seat_omega_seat_omega_c4;
        let bar_omega_c5 = bar_omega * c[5usize];
        let bar_omega_bar_omega_c5 = bar_omega * bar_omega_c5;
        let sum_46 = T::fused(cos_bar_phi, bar_omega_bar_omega_c5, product_41);
        let minus_right_side_rear_c6 = minus_right_side_rear * c[6usize];
        let difference_50 = T::fused(sin_seat_phi, minus_right_side_rear_c6, -sum_46);
        let product_52 = minus_right_side_front * c[7usize];
        let sum_54 = T::fused(sin_bar_phi, product_52, difference_50);
        let product_55 = sin_seat_phi * seat_omega_seat_omega_c4;
        let sum_57 = T::fused(sin_bar_phi, bar_omega_bar_omega_c5, product_55);
        let sum_59 = T::fused(cos_seat_phi, minus_right_side_rear_c6, sum_57);
        let sum_61 = T::fused(cos_bar_phi, product_52, sum_59);
        let sum_30_difference_37 = sum_30 * difference_37;
        let difference_64 = T::fused(-sum_35, sum_35, sum_30_difference_37);
        let quotient_65 = T::from_f64(1f64) / difference_64;
        let difference_37_sum_54 = difference_37 * sum_54;
        let sum_68 = T::fused(sum_35, sum_61, difference_37_sum_54);
        let lambda_B_x = quotient_65 * sum_68;
        let sum_35_sum_54 = sum_35 * sum_54;
        let sum_72 = T::fused(sum_30, sum_61, sum_35_sum_54);
        let minus_lambda_B_y = quotient_65 * sum_72;
        let sin_bar_phi_lambda_B_x = sin_bar_phi * lambda_B_x;
        let sum_76 = T::fused(cos_bar_phi, minus_lambda_B_y, sin_bar_phi_lambda_B_x);
        let c7_sum_76 = c[7usize] * sum_76;
        let minus_lambda_front = T::fused(minus_right_side_front, c[8usize], c7_sum_76);
        let sin_seat_phi_lambda_B_x = sin_seat_phi * lambda_B_x;
        let sum_83 = T::fused(cos_seat_phi, minus_lambda_B_y, sin_seat_phi_lambda_B_x);
        let c6_sum_83 = c[6usize] * sum_83;
        let minus_lambda_rear = T::fused(minus_right_side_rear, c[9usize], c6_sum_83);
        let sum_89 = T::fused(sin_seat_phi, minus_lambda_rear, lambda_B_x);
        let sum_89_c10 = sum_89 * c[10usize];
        let sum_93 = T::fused(cos_seat_phi, minus_lambda_rear, minus_lambda_B_y);
        let c10_sum_93 = c[10usize] * sum_93;
        let sum_83_c11 = sum_83 * c[11usize];
        let difference_99 = T::fused(-minus_lambda_rear, c[12usize], sum_83_c11);
        let difference_101 = T::fused(-sin_bar_phi, minus_lambda_front, lambda_B_x);
        let difference_101_c13 = difference_101 * c[13usize];
        let difference_105 = T::fused(
            cos_bar_phi,
            minus_lambda_front,
            -minus_lambda_B_y,
        );
        let c13_difference_105 = c[13usize] * difference_105;
        let sum_76_c14 = sum_76 * c[14usize];
        let sum_111 = T::fused(minus_lambda_front, c[15usize], sum_76_c14);
        let value_117 = -sum_89_c10;
        let value_118 = -minus_lambda_B_y;
        let value_119 = -minus_lambda_rear;
        let value_120 = -minus_lambda_front;
        a[0usize] = value_117;
        a[1usize] = c10_sum_93;
        a[2usize] = difference_99;
        a[3usize] = difference_101_c13;
        a[4usize] = c13_difference_105;
        a[5usize] = sum_111;
        lambda[0usize] = lambda_B_x;
        lambda[1usize] = value_118;
        lambda[2usize] = value_119;
        lambda[3usize] = value_120;
        ezy::Pivots::new()
            .see(&[2usize], T::least_ratio(c[16usize], c[17usize]))
            .see(&[3usize], T::least_ratio(c[18usize], c[19usize]))
            .see(&[0usize, 1usize], T::least_ratio(difference_64, c[20usize]))
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
        let c = ezy::array::<32usize, T>(c);
        let q = ezy::array::<6usize, T>(q);
        let residual = ezy::array::<4usize, T>(residual);
        let delta = ezy::array_mut::<6usize, T>(delta);
        let right_side_rear = residual[2usize];
        let right_side_front = residual[3usize];
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
        let c0_cos_seat_phi = c[0usize] * cos_seat_phi;
        let product_8 = cos_seat_phi * c0_cos_seat_phi;
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
        let c1_cos_bar_phi = c[1usize] * cos_bar_phi;
        let sum_14 = T::fused(cos_bar_phi, c1_cos_bar_phi, product_8);
        let sum_16 = sum_14 + c[2usize];
        let c0_sin_seat_phi = c[0usize] * sin_seat_phi;
        let product_19 = cos_seat_phi * c0_sin_seat_phi;
        let c1_sin_bar_phi = c[1usize] * sin_bar_phi;
        let sum_23 = T::fused(cos_bar_phi, c1_sin_bar_phi, product_19);
        let difference_25 = c[3usize] - sum_14;
        let residual_0 = residual[0usize];
        let right_side_rear_c6 = right_side_rear * c[6usize];
        let difference_30 = T::fused(-sin_seat_phi, right_side_rear_c6, residual_0);
        let right_side_front_c7 = right_side_front * c[7usize];
        let difference_34 = T::fused(-sin_bar_phi, right_side_front_c7, difference_30);
        let residual_1 = residual[1usize];
        let sum_37 = T::fused(cos_seat_phi, right_side_rear_c6, residual_1);
        let sum_39 = T::fused(cos_bar_phi, right_side_front_c7, sum_37);
        let sum_16_difference_25 = sum_16 * difference_25;
        let difference_42 = T::fused(-sum_23, sum_23, sum_16_difference_25);
        let quotient_43 = T::from_f64(1f64) / difference_42;
        let product_44 = difference_25 * difference_34;
        let difference_46 = T::fused(-sum_23, sum_39, product_44);
        let lambda_B_x = quotient_43 * difference_46;
        let sum_16_sum_39 = sum_16 * sum_39;
        let difference_50 = T::fused(-sum_23, difference_34, sum_16_sum_39);
        let lambda_B_y = quotient_43 * difference_50;
        let cos_bar_phi_lambda_B_y = cos_bar_phi * lambda_B_y;
        let difference_54 = T::fused(-sin_bar_phi, lambda_B_x, cos_bar_phi_lambda_B_y);
        let c7_difference_54 = c[7usize] * difference_54;
        let lambda_front = T::fused(right_side_front, c[8usize], c7_difference_54);
        let cos_seat_phi_lambda_B_y = cos_seat_phi * lambda_B_y;
        let difference_61 = T::fused(-sin_seat_phi, lambda_B_x, cos_seat_phi_lambda_B_y);
        let c6_difference_61 = c[6usize] * difference_61;
        let lambda_rear = T::fused(right_side_rear, c[9usize], c6_difference_61);
        let difference_67 = T::fused(sin_seat_phi, lambda_rear, -lambda_B_x);
        let difference_67_c10 = difference_67 * c[10usize];
        let sum_71 = T::fused(cos_seat_phi, lambda_rear, lambda_B_y);
        let c10_sum_71 = c[10usize] * sum_71;
        let lambda_rear_c12 = lambda_rear * c[12usize];
        let difference_77 = T::fused(-difference_61, c[11usize], lambda_rear_c12);
        let sum_79 = T::fused(sin_bar_phi, lambda_front, lambda_B_x);
        let sum_79_c13 = sum_79 * c[13usize];
        let difference_83 = T::fused(-cos_bar_phi, lambda_front, lambda_B_y);
        let c13_difference_83 = c[13usize] * difference_83;
        let difference_54_c14 = difference_54 * c[14usize];
        let sum_89 = T::fused(lambda_front, c[15usize], difference_54_c14);
        let value_95 = -c10_sum_71;
        let value_96 = -sum_89;
        delta[0usize] = difference_67_c10;
        delta[1usize] = value_95;
        delta[2usize] = difference_77;
        delta[3usize] = sum_79_c13;
        delta[4usize] = c13_difference_83;
        delta[5usize] = value_96;
        ezy::Pivots::new()
            .see(&[2usize], T::least_ratio(c[16usize], c[17usize]))
            .see(&[3usize], T::least_ratio(c[18usize], c[19usize]))
            .see(&[0usize, 1usize], T::least_ratio(difference_42, c[20usize]))
    }
    #[inline]
    fn projected_accelerations(
        &self,
        c: &[T],
        t: T,
        q: &[T],
        v: &[T],
        out: &mut [T],
    ) -> ezy::Pivots {
        let c = ezy::array::<32usize, T>(c);
        let q = ezy::array::<6usize, T>(q);
        let v = ezy::array::<6usize, T>(v);
        let out = ezy::array_mut::<20usize, T>(out);
        let seat_vx = v[0usize];
        let seat_omega = v[2usize];
        let c4_seat_omega = c[4usize] * seat_omega;
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
        let difference_9 = T::fused(-c4_seat_omega, sin_seat_phi, seat_vx);
        let bar_vx = v[3usize];
        let difference_11 = difference_9 - bar_vx;
        let bar_omega = v[5usize];
        let c5_bar_omega = c[5usize] * bar_omega;
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
        let difference_18 = T::fused(-c5_bar_omega, sin_bar_phi, difference_11);
        let seat_vy = v[1usize];
        let bar_vy = v[4usize];
        let difference_21 = seat_vy - bar_vy;
        let sum_24 = T::fused(c4_seat_omega, cos_seat_phi, difference_21);
        let sum_27 = T::fused(c5_bar_omega, cos_bar_phi, sum_24);
        let seat_omega_c21 = seat_omega * c[21usize];
        let sum_31 = T::fused(seat_vx, sin_seat_phi, seat_omega_c21);
        let projection_right_side_rear = T::fused(seat_vy, cos_seat_phi, -sum_31);
        let bar_omega_c22 = bar_omega * c[22usize];
        let difference_37 = T::fused(-bar_vx, sin_bar_phi, bar_omega_c22);
        let projection_right_side_front = T::fused(bar_vy, cos_bar_phi, difference_37);
        let cos_seat_phi_c0 = cos_seat_phi * c[0usize];
        let product_42 = cos_seat_phi * cos_seat_phi_c0;
        let cos_bar_phi_c1 = cos_bar_phi * c[1usize];
        let sum_46 = T::fused(cos_bar_phi, cos_bar_phi_c1, product_42);
        let sum_48 = sum_46 + c[2usize];
        let sin_seat_phi_c0 = sin_seat_phi * c[0usize];
        let product_50 = cos_seat_phi * sin_seat_phi_c0;
        let sin_bar_phi_c1 = sin_bar_phi * c[1usize];
        let sum_53 = T::fused(cos_bar_phi, sin_bar_phi_c1, product_50);
        let difference_55 = c[3usize] - sum_46;
        let product_57 = projection_right_side_rear * c[6usize];
        let difference_59 = T::fused(-sin_seat_phi, product_57, difference_18);
        let product_61 = projection_right_side_front * c[7usize];
        let difference_63 = T::fused(-sin_bar_phi, product_61, difference_59);
        let sum_65 = T::fused(cos_seat_phi, product_57, sum_27);
        let sum_67 = T::fused(cos_bar_phi, product_61, sum_65);
        let sum_48_difference_55 = sum_48 * difference_55;
        let difference_70 = T::fused(-sum_53, sum_53, sum_48_difference_55);
        let quotient_71 = T::from_f64(1f64) / difference_70;
        let product_72 = difference_55 * difference_63;
        let difference_74 = T::fused(-sum_53, sum_67, product_72);
        let projection_lambda_B_x = quotient_71 * difference_74;
        let sum_48_sum_67 = sum_48 * sum_67;
        let difference_78 = T::fused(-sum_53, difference_63, sum_48_sum_67);
        let projection_lambda_B_y = quotient_71 * difference_78;
        let product_81 = cos_bar_phi * projection_lambda_B_y;
        let difference_82 = T::fused(-sin_bar_phi, projection_lambda_B_x, product_81);
        let c7_difference_82 = c[7usize] * difference_82;
        let projection_lambda_front = T::fused(
            projection_right_side_front,
            c[8usize],
            c7_difference_82,
        );
        let product_88 = cos_seat_phi * projection_lambda_B_y;
        let difference_89 = T::fused(-sin_seat_phi, projection_lambda_B_x, product_88);
        let c6_difference_89 = c[6usize] * difference_89;
        let projection_lambda_rear = T::fused(
            projection_right_side_rear,
            c[9usize],
            c6_difference_89,
        );
        let difference_95 = T::fused(
            sin_seat_phi,
            projection_lambda_rear,
            -projection_lambda_B_x,
        );
        let sum_99 = T::fused(
            cos_seat_phi,
            projection_lambda_rear,
            projection_lambda_B_y,
        );
        let product_104 = projection_lambda_rear * c[12usize];
        let difference_105 = T::fused(-difference_89, c[11usize], product_104);
        let sum_107 = T::fused(
            sin_bar_phi,
            projection_lambda_front,
            projection_lambda_B_x,
        );
        let difference_111 = T::fused(
            -cos_bar_phi,
            projection_lambda_front,
            projection_lambda_B_y,
        );
        let difference_82_c14 = difference_82 * c[14usize];
        let sum_117 = T::fused(projection_lambda_front, c[15usize], difference_82_c14);
        let projected_seat_vx = T::fused(difference_95, c[10usize], seat_vx);
        let projected_seat_vy = T::fused(-c[10usize], sum_99, seat_vy);
        let projected_seat_omega = seat_omega + difference_105;
        let projected_bar_vx = T::fused(sum_107, c[13usize], bar_vx);
        let projected_bar_vy = T::fused(c[13usize], difference_111, bar_vy);
        let projected_bar_omega = bar_omega - sum_117;
        let product_129 = cos_seat_phi * projected_seat_vx;
        let sum_131 = T::fused(sin_seat_phi, projected_seat_vy, product_129);
        let minus_right_side_rear = projected_seat_omega * sum_131;
        let product_133 = cos_bar_phi * projected_bar_vx;
        let sum_135 = T::fused(sin_bar_phi, projected_bar_vy, product_133);
        let minus_right_side_front = projected_bar_omega * sum_135;
        let c4_projected_seat_omega = c[4usize] * projected_seat_omega;
        let product_138 = projected_seat_omega * c4_projected_seat_omega;
        let cos_seat_phi_product_138 = cos_seat_phi * product_138;
        let c5_projected_bar_omega = c[5usize] * projected_bar_omega;
        let product_141 = projected_bar_omega * c5_projected_bar_omega;
        let sum_143 = T::fused(cos_bar_phi, product_141, cos_seat_phi_product_138);
        let c6_minus_right_side_rear = c[6usize] * minus_right_side_rear;
        let difference_146 = T::fused(sin_seat_phi, c6_minus_right_side_rear, -sum_143);
        let product_147 = c[7usize] * minus_right_side_front;
        let sum_149 = T::fused(sin_bar_phi, product_147, difference_146);
        let sin_seat_phi_product_138 = sin_seat_phi * product_138;
        let sum_152 = T::fused(sin_bar_phi, product_141, sin_seat_phi_product_138);
        let sum_154 = T::fused(cos_seat_phi, c6_minus_right_side_rear, sum_152);
        let sum_156 = T::fused(cos_bar_phi, product_147, sum_154);
        let difference_55_sum_149 = difference_55 * sum_149;
        let sum_159 = T::fused(sum_53, sum_156, difference_55_sum_149);
        let lambda_B_x = quotient_71 * sum_159;
        let sum_53_sum_149 = sum_53 * sum_149;
        let sum_163 = T::fused(sum_48, sum_156, sum_53_sum_149);
        let minus_lambda_B_y = quotient_71 * sum_163;
        let sin_bar_phi_lambda_B_x = sin_bar_phi * lambda_B_x;
        let sum_167 = T::fused(cos_bar_phi, minus_lambda_B_y, sin_bar_phi_lambda_B_x);
        let c7_sum_167 = c[7usize] * sum_167;
        let minus_lambda_front = T::fused(c[8usize], minus_right_side_front, c7_sum_167);
        let sin_seat_phi_lambda_B_x = sin_seat_phi * lambda_B_x;
        let sum_173 = T::fused(cos_seat_phi, minus_lambda_B_y, sin_seat_phi_lambda_B_x);
        let c6_sum_173 = c[6usize] * sum_173;
        let minus_lambda_rear = T::fused(c[9usize], minus_right_side_rear, c6_sum_173);
        let sum_178 = T::fused(sin_seat_phi, minus_lambda_rear, lambda_B_x);
        let c10_sum_178 = c[10usize] * sum_178;
        let sum_181 = T::fused(cos_seat_phi, minus_lambda_rear, minus_lambda_B_y);
        let c10_sum_181 = c[10usize] * sum_181;
        let c11_sum_173 = c[11usize] * sum_173;
        let difference_185 = T::fused(-c[12usize], minus_lambda_rear, c11_sum_173);
        let difference_187 = T::fused(-sin_bar_phi, minus_lambda_front, lambda_B_x);
        let c13_difference_187 = c[13usize] * difference_187;
        let difference_190 = T::fused(
            cos_bar_phi,
            minus_lambda_front,
            -minus_lambda_B_y,
        );
        let c13_difference_190 = c[13usize] * difference_190;
        let c14_sum_167 = c[14usize] * sum_167;
        let sum_194 = T::fused(c[15usize], minus_lambda_front, c14_sum_167);
        let value_195 = -c10_sum_178;
        let value_196 = -minus_lambda_B_y;
        let value_197 = -minus_lambda_rear;
        let value_198 = -minus_lambda_front;
        out[0usize] = difference_18;
        out[1usize] = sum_27;
        out[2usize] = projection_right_side_rear;
        out[3usize] = projection_right_side_front;
        out[4usize] = projected_seat_vx;
        out[5usize] = projected_seat_vy;
        out[6usize] = projected_seat_omega;
        out[7usize] = projected_bar_vx;
        out[8usize] = projected_bar_vy;
        out[9usize] = projected_bar_omega;
        out[10usize] = value_195;
        out[11usize] = c10_sum_181;
        out[12usize] = difference_185;
        out[13usize] = c13_difference_187;
        out[14usize] = c13_difference_190;
        out[15usize] = sum_194;
        out[16usize] = lambda_B_x;
        out[17usize] = value_196;
        out[18usize] = value_197;
        out[19usize] = value_198;
        ezy::Pivots::new()
            .see(&[2usize], T::least_ratio(c[16usize], c[17usize]))
            .see(&[3usize], T::least_ratio(c[18usize], c[19usize]))
            .see(&[0usize, 1usize], T::least_ratio(difference_70, c[20usize]))
    }
}
