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
        c[24usize] = parameter_c;
        c[25usize] = parameter_hold;
        c[26usize] = k21;
        c[27usize] = parameter_m1;
        c[28usize] = parameter_i1;
        c[29usize] = parameter_m2;
        c[30usize] = parameter_i2;
        c[31usize] = parameter_a;
        c[32usize] = k15;
        c[33usize] = k54;
        c[34usize] = k55;
    }
    fn mass_matrix(&self, c: &[T], out: &mut [T]) {
        let c = ezy::array::<35usize, T>(c);
        let out = ezy::array_mut::<6usize, T>(out);
        out[0usize] = c[27usize];
        out[1usize] = c[27usize];
        out[2usize] = c[28usize];
        out[3usize] = c[29usize];
        out[4usize] = c[29usize];
        out[5usize] = c[30usize];
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
        let c13_bar_omega = c[13usize] * bar_omega;
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
        let difference_11 = T::fused(-c13_bar_omega, sin_bar_phi, difference_4);
        let seat_omega = v[2usize];
        let c12_seat_omega = c[12usize] * seat_omega;
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
        let difference_18 = T::fused(-c12_seat_omega, sin_seat_phi, difference_11);
        let seat_vy = v[1usize];
        let bar_vy = v[4usize];
        let difference_21 = seat_vy - bar_vy;
        let sum_24 = T::fused(c13_bar_omega, cos_bar_phi, difference_21);
        let sum_27 = T::fused(c12_seat_omega, cos_seat_phi, sum_24);
        let bar_omega_c24 = bar_omega * c[24usize];
        let difference_31 = T::fused(-bar_vx, sin_bar_phi, bar_omega_c24);
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
        let c12_sin_seat_phi = c[12usize] * sin_seat_phi;
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
        let c13_sin_bar_phi = c[13usize] * sin_bar_phi;
        let c12_cos_seat_phi = c[12usize] * cos_seat_phi;
        let c13_cos_bar_phi = c[13usize] * cos_bar_phi;
        let value_14 = -c12_sin_seat_phi;
        let value_15 = -T::from_f64(1f64);
        let value_16 = -c13_sin_bar_phi;
        let value_17 = -sin_bar_phi;
        out[0usize] = T::from_f64(1f64);
        out[1usize] = value_14;
        out[2usize] = value_15;
        out[3usize] = value_16;
        out[4usize] = T::from_f64(1f64);
        out[5usize] = c12_cos_seat_phi;
        out[6usize] = value_15;
        out[7usize] = c13_cos_bar_phi;
        out[8usize] = value_17;
        out[9usize] = cos_bar_phi;
        out[10usize] = c[24usize];
    }
    fn convective_term(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
        let c = ezy::array::<35usize, T>(c);
        let q = ezy::array::<6usize, T>(q);
        let v = ezy::array::<6usize, T>(v);
        let out = ezy::array_mut::<3usize, T>(out);
        let seat_omega = v[2usize];
        let c12_seat_omega = c[12usize] * seat_omega;
        let product_4 = seat_omega * c12_seat_omega;
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
        let product_4_cos_seat_phi = product_4 * cos_seat_phi;
        let bar_omega = v[5usize];
        let c13_bar_omega = c[13usize] * bar_omega;
        let bar_omega_c13_bar_omega = bar_omega * c13_bar_omega;
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
        let sum_16 = T::fused(
            bar_omega_c13_bar_omega,
            cos_bar_phi,
            product_4_cos_seat_phi,
        );
        let product_4_sin_seat_phi = product_4 * sin_seat_phi;
        let sum_21 = T::fused(
            bar_omega_c13_bar_omega,
            sin_bar_phi,
            product_4_sin_seat_phi,
        );
        let bar_vx = v[3usize];
        let cos_bar_phi_bar_vx = cos_bar_phi * bar_vx;
        let bar_vy = v[4usize];
        let sum_26 = T::fused(sin_bar_phi, bar_vy, cos_bar_phi_bar_vx);
        let bar_omega_sum_26 = bar_omega * sum_26;
        let value_28 = -sum_16;
        let value_29 = -sum_21;
        let value_30 = -bar_omega_sum_26;
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
        let c25_sin_seat_phi = c[25usize] * sin_seat_phi;
        let c25_cos_seat_phi = c[25usize] * cos_seat_phi;
        let c1_t = c[1usize] * t;
        let cos_11 = T::cos(c1_t);
        let c0_cos_11 = c[0usize] * cos_11;
        let sum_15 = c0_cos_11 + c[2usize];
        let value_16 = -c25_cos_seat_phi;
        let value_17 = -c0_cos_11;
        out[0usize] = c25_sin_seat_phi;
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
        let c1_t = c[1usize] * t;
        let cos_4 = T::cos(c1_t);
        let force_seat_phi = T::fused(c[0usize], cos_4, c[2usize]);
        let bar_vx = v[3usize];
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
        let bar_vx_cos_bar_phi = bar_vx * cos_bar_phi;
        let bar_vy = v[4usize];
        let sum_17 = T::fused(bar_vy, sin_bar_phi, bar_vx_cos_bar_phi);
        let bar_omega = v[5usize];
        let sum_17_bar_omega = sum_17 * bar_omega;
        let minus_right_side_front = T::fused(cos_4, c[3usize], sum_17_bar_omega);
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
        let c4_cos_seat_phi = c[4usize] * cos_seat_phi;
        let cos_bar_phi_c5 = cos_bar_phi * c[5usize];
        let product_30 = cos_bar_phi * cos_bar_phi_c5;
        let difference_31 = T::fused(-cos_seat_phi, c4_cos_seat_phi, product_30);
        let sum_33 = difference_31 + c[6usize];
        let c4_sin_seat_phi = c[4usize] * sin_seat_phi;
        let sin_bar_phi_c5 = sin_bar_phi * c[5usize];
        let product_38 = cos_bar_phi * sin_bar_phi_c5;
        let difference_39 = T::fused(-cos_seat_phi, c4_sin_seat_phi, product_38);
        let difference_41 = c[7usize] - difference_31;
        let difference_45 = T::fused(-force_seat_phi, c[9usize], c[8usize]);
        let product_46 = sin_seat_phi * difference_45;
        let cos_4_c10 = cos_4 * c[10usize];
        let sum_51 = T::fused(minus_right_side_front, c[11usize], cos_4_c10);
        let sum_53 = T::fused(sin_bar_phi, sum_51, product_46);
        let seat_omega = v[2usize];
        let c12_seat_omega = c[12usize] * seat_omega;
        let product_57 = seat_omega * c12_seat_omega;
        let difference_59 = T::fused(-cos_seat_phi, product_57, sum_53);
        let bar_omega_c13 = bar_omega * c[13usize];
        let bar_omega_bar_omega_c13 = bar_omega * bar_omega_c13;
        let difference_64 = T::fused(
            -cos_bar_phi,
            bar_omega_bar_omega_c13,
            difference_59,
        );
        let product_65 = cos_seat_phi * difference_45;
        let sum_67 = T::fused(cos_bar_phi, sum_51, product_65);
        let sum_69 = T::fused(sin_seat_phi, product_57, sum_67);
        let sum_71 = T::fused(sin_bar_phi, bar_omega_bar_omega_c13, sum_69);
        let sum_33_difference_41 = sum_33 * difference_41;
        let difference_74 = T::fused(
            -difference_39,
            difference_39,
            sum_33_difference_41,
        );
        let quotient_75 = T::from_f64(1f64) / difference_74;
        let product_76 = difference_41 * difference_64;
        let sum_78 = T::fused(difference_39, sum_71, product_76);
        let lambda_B_x = quotient_75 * sum_78;
        let product_80 = difference_39 * difference_64;
        let sum_82 = T::fused(sum_33, sum_71, product_80);
        let minus_lambda_B_y = quotient_75 * sum_82;
        let sin_bar_phi_lambda_B_x = sin_bar_phi * lambda_B_x;
        let sum_86 = T::fused(cos_bar_phi, minus_lambda_B_y, sin_bar_phi_lambda_B_x);
        let c11_sum_86 = c[11usize] * sum_86;
        let minus_lambda_front = T::fused(
            minus_right_side_front,
            c[14usize],
            c11_sum_86,
        );
        let sin_seat_phi_c8 = sin_seat_phi * c[8usize];
        let difference_94 = T::fused(-lambda_B_x, c[15usize], sin_seat_phi_c8);
        let minus_lambda_B_y_c15 = minus_lambda_B_y * c[15usize];
        let difference_97 = T::fused(-cos_seat_phi, c[8usize], minus_lambda_B_y_c15);
        let sin_seat_phi_lambda_B_x = sin_seat_phi * lambda_B_x;
        let sum_100 = T::fused(cos_seat_phi, minus_lambda_B_y, sin_seat_phi_lambda_B_x);
        let c9_sum_100 = c[9usize] * sum_100;
        let sum_104 = T::fused(force_seat_phi, c[16usize], c9_sum_100);
        let difference_106 = T::fused(-sin_bar_phi, minus_lambda_front, lambda_B_x);
        let difference_106_c17 = difference_106 * c[17usize];
        let difference_110 = T::fused(
            cos_bar_phi,
            minus_lambda_front,
            -minus_lambda_B_y,
        );
        let c17_difference_110 = c[17usize] * difference_110;
        let sum_86_c18 = sum_86 * c[18usize];
        let difference_116 = T::fused(-cos_4, c[19usize], sum_86_c18);
        let sum_119 = T::fused(minus_lambda_front, c[20usize], difference_116);
        let value_123 = -minus_lambda_B_y;
        let value_124 = -minus_lambda_front;
        a[0usize] = difference_94;
        a[1usize] = difference_97;
        a[2usize] = sum_104;
        a[3usize] = difference_106_c17;
        a[4usize] = c17_difference_110;
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
        let c4_cos_seat_phi = c[4usize] * cos_seat_phi;
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
        let c5_cos_bar_phi = c[5usize] * cos_bar_phi;
        let product_12 = cos_bar_phi * c5_cos_bar_phi;
        let difference_13 = T::fused(-cos_seat_phi, c4_cos_seat_phi, product_12);
        let sum_15 = difference_13 + c[6usize];
        let c4_sin_seat_phi = c[4usize] * sin_seat_phi;
        let c5_sin_bar_phi = c[5usize] * sin_bar_phi;
        let product_21 = cos_bar_phi * c5_sin_bar_phi;
        let difference_22 = T::fused(-cos_seat_phi, c4_sin_seat_phi, product_21);
        let difference_24 = c[7usize] - difference_13;
        let residual_0 = residual[0usize];
        let right_side_front_c11 = right_side_front * c[11usize];
        let difference_29 = T::fused(-sin_bar_phi, right_side_front_c11, residual_0);
        let residual_1 = residual[1usize];
        let sum_32 = T::fused(cos_bar_phi, right_side_front_c11, residual_1);
        let sum_15_difference_24 = sum_15 * difference_24;
        let difference_35 = T::fused(
            -difference_22,
            difference_22,
            sum_15_difference_24,
        );
        let quotient_36 = T::from_f64(1f64) / difference_35;
        let product_37 = difference_24 * difference_29;
        let difference_39 = T::fused(-difference_22, sum_32, product_37);
        let lambda_B_x = quotient_36 * difference_39;
        let sum_15_sum_32 = sum_15 * sum_32;
        let difference_43 = T::fused(-difference_22, difference_29, sum_15_sum_32);
        let lambda_B_y = quotient_36 * difference_43;
        let cos_bar_phi_lambda_B_y = cos_bar_phi * lambda_B_y;
        let difference_47 = T::fused(-sin_bar_phi, lambda_B_x, cos_bar_phi_lambda_B_y);
        let c11_difference_47 = c[11usize] * difference_47;
        let lambda_front = T::fused(right_side_front, c[14usize], c11_difference_47);
        let lambda_B_x_c15 = lambda_B_x * c[15usize];
        let lambda_B_y_c15 = lambda_B_y * c[15usize];
        let sin_seat_phi_lambda_B_x = sin_seat_phi * lambda_B_x;
        let difference_57 = T::fused(-cos_seat_phi, lambda_B_y, sin_seat_phi_lambda_B_x);
        let difference_57_c9 = difference_57 * c[9usize];
        let sum_61 = T::fused(sin_bar_phi, lambda_front, lambda_B_x);
        let sum_61_c17 = sum_61 * c[17usize];
        let difference_65 = T::fused(-cos_bar_phi, lambda_front, lambda_B_y);
        let c17_difference_65 = c[17usize] * difference_65;
        let difference_47_c18 = difference_47 * c[18usize];
        let sum_71 = T::fused(lambda_front, c[20usize], difference_47_c18);
        let value_75 = -lambda_B_x_c15;
        let value_76 = -lambda_B_y_c15;
        let value_77 = -sum_71;
        delta[0usize] = value_75;
        delta[1usize] = value_76;
        delta[2usize] = difference_57_c9;
        delta[3usize] = sum_61_c17;
        delta[4usize] = c17_difference_65;
        delta[5usize] = value_77;
        ezy::Pivots::new()
            .see(&[2usize], T::least_ratio(c[21usize], c[22usize]))
            .see(&[0usize, 1usize], T::least_ratio(difference_35, c[23usize]))
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
        let c = ezy::array::<35usize, T>(c);
        let q = ezy::array::<6usize, T>(q);
        let v = ezy::array::<6usize, T>(v);
        let out = ezy::array_mut::<18usize, T>(out);
        let seat_vx = v[0usize];
        let bar_vx = v[3usize];
        let difference_4 = seat_vx - bar_vx;
        let bar_omega = v[5usize];
        let c13_bar_omega = c[13usize] * bar_omega;
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
        let difference_11 = T::fused(-c13_bar_omega, sin_bar_phi, difference_4);
        let seat_omega = v[2usize];
        let c12_seat_omega = c[12usize] * seat_omega;
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
        let difference_18 = T::fused(-c12_seat_omega, sin_seat_phi, difference_11);
        let seat_vy = v[1usize];
        let bar_vy = v[4usize];
        let difference_21 = seat_vy - bar_vy;
        let sum_24 = T::fused(c13_bar_omega, cos_bar_phi, difference_21);
        let sum_27 = T::fused(c12_seat_omega, cos_seat_phi, sum_24);
        let bar_omega_c24 = bar_omega * c[24usize];
        let difference_31 = T::fused(-bar_vx, sin_bar_phi, bar_omega_c24);
        let projection_right_side_front = T::fused(bar_vy, cos_bar_phi, difference_31);
        let cos_seat_phi_c4 = cos_seat_phi * c[4usize];
        let cos_bar_phi_c5 = cos_bar_phi * c[5usize];
        let product_39 = cos_bar_phi * cos_bar_phi_c5;
        let difference_40 = T::fused(-cos_seat_phi, cos_seat_phi_c4, product_39);
        let sum_42 = difference_40 + c[6usize];
        let sin_seat_phi_c4 = sin_seat_phi * c[4usize];
        let sin_bar_phi_c5 = sin_bar_phi * c[5usize];
        let product_46 = cos_bar_phi * sin_bar_phi_c5;
        let difference_47 = T::fused(-cos_seat_phi, sin_seat_phi_c4, product_46);
        let difference_49 = c[7usize] - difference_40;
        let product_51 = projection_right_side_front * c[11usize];
        let difference_53 = T::fused(-sin_bar_phi, product_51, difference_18);
        let sum_55 = T::fused(cos_bar_phi, product_51, sum_27);
        let sum_42_difference_49 = sum_42 * difference_49;
        let difference_58 = T::fused(
            -difference_47,
            difference_47,
            sum_42_difference_49,
        );
        let quotient_59 = T::from_f64(1f64) / difference_58;
        let product_60 = difference_49 * difference_53;
        let difference_62 = T::fused(-difference_47, sum_55, product_60);
        let projection_lambda_B_x = quotient_59 * difference_62;
        let sum_42_sum_55 = sum_42 * sum_55;
        let difference_66 = T::fused(-difference_47, difference_53, sum_42_sum_55);
        let projection_lambda_B_y = quotient_59 * difference_66;
        let product_69 = cos_bar_phi * projection_lambda_B_y;
        let difference_70 = T::fused(-sin_bar_phi, projection_lambda_B_x, product_69);
        let c11_difference_70 = c[11usize] * difference_70;
        let projection_lambda_front = T::fused(
            projection_right_side_front,
            c[14usize],
            c11_difference_70,
        );
        let product_78 = sin_seat_phi * projection_lambda_B_x;
        let difference_80 = T::fused(-cos_seat_phi, projection_lambda_B_y, product_78);
        let sum_84 = T::fused(
            sin_bar_phi,
            projection_lambda_front,
            projection_lambda_B_x,
        );
        let difference_88 = T::fused(
            -cos_bar_phi,
            projection_lambda_front,
            projection_lambda_B_y,
        );
        let difference_70_c18 = difference_70 * c[18usize];
        let sum_94 = T::fused(projection_lambda_front, c[20usize], difference_70_c18);
        let projected_seat_vx = T::fused(-projection_lambda_B_x, c[15usize], seat_vx);
        let projected_seat_vy = T::fused(-projection_lambda_B_y, c[15usize], seat_vy);
        let projected_seat_omega = T::fused(difference_80, c[9usize], seat_omega);
        let projected_bar_vx = T::fused(sum_84, c[17usize], bar_vx);
        let projected_bar_vy = T::fused(c[17usize], difference_88, bar_vy);
        let projected_bar_omega = bar_omega - sum_94;
        let c1_t = c[1usize] * t;
        let cos_107 = T::cos(c1_t);
        let force_seat_phi = T::fused(c[0usize], cos_107, c[2usize]);
        let product_112 = cos_bar_phi * projected_bar_vx;
        let sum_114 = T::fused(sin_bar_phi, projected_bar_vy, product_112);
        let product_115 = projected_bar_omega * sum_114;
        let minus_right_side_front = T::fused(cos_107, c[3usize], product_115);
        let difference_121 = T::fused(-c[9usize], force_seat_phi, c[8usize]);
        let product_122 = sin_seat_phi * difference_121;
        let cos_107_c10 = cos_107 * c[10usize];
        let sum_126 = T::fused(c[11usize], minus_right_side_front, cos_107_c10);
        let sum_128 = T::fused(sin_bar_phi, sum_126, product_122);
        let c12_projected_seat_omega = c[12usize] * projected_seat_omega;
        let product_130 = projected_seat_omega * c12_projected_seat_omega;
        let difference_132 = T::fused(-cos_seat_phi, product_130, sum_128);
        let c13_projected_bar_omega = c[13usize] * projected_bar_omega;
        let product_134 = projected_bar_omega * c13_projected_bar_omega;
        let difference_136 = T::fused(-cos_bar_phi, product_134, difference_132);
        let product_137 = cos_seat_phi * difference_121;
        let sum_139 = T::fused(cos_bar_phi, sum_126, product_137);
        let sum_141 = T::fused(sin_seat_phi, product_130, sum_139);
        let sum_143 = T::fused(sin_bar_phi, product_134, sum_141);
        let product_144 = difference_49 * difference_136;
        let sum_146 = T::fused(difference_47, sum_143, product_144);
        let lambda_B_x = quotient_59 * sum_146;
        let product_148 = difference_47 * difference_136;
        let sum_150 = T::fused(sum_42, sum_143, product_148);
        let minus_lambda_B_y = quotient_59 * sum_150;
        let sin_bar_phi_lambda_B_x = sin_bar_phi * lambda_B_x;
        let sum_154 = T::fused(cos_bar_phi, minus_lambda_B_y, sin_bar_phi_lambda_B_x);
        let c11_sum_154 = c[11usize] * sum_154;
        let minus_lambda_front = T::fused(
            c[14usize],
            minus_right_side_front,
            c11_sum_154,
        );
        let sin_seat_phi_c8 = sin_seat_phi * c[8usize];
        let difference_160 = T::fused(-c[15usize], lambda_B_x, sin_seat_phi_c8);
        let c15_minus_lambda_B_y = c[15usize] * minus_lambda_B_y;
        let difference_163 = T::fused(-cos_seat_phi, c[8usize], c15_minus_lambda_B_y);
        let sin_seat_phi_lambda_B_x = sin_seat_phi * lambda_B_x;
        let sum_166 = T::fused(cos_seat_phi, minus_lambda_B_y, sin_seat_phi_lambda_B_x);
        let c9_sum_166 = c[9usize] * sum_166;
        let sum_170 = T::fused(force_seat_phi, c[16usize], c9_sum_166);
        let difference_172 = T::fused(-sin_bar_phi, minus_lambda_front, lambda_B_x);
        let c17_difference_172 = c[17usize] * difference_172;
        let difference_175 = T::fused(
            cos_bar_phi,
            minus_lambda_front,
            -minus_lambda_B_y,
        );
        let c17_difference_175 = c[17usize] * difference_175;
        let c18_sum_154 = c[18usize] * sum_154;
        let difference_180 = T::fused(-cos_107, c[19usize], c18_sum_154);
        let sum_182 = T::fused(c[20usize], minus_lambda_front, difference_180);
        let value_183 = -minus_lambda_B_y;
        let value_184 = -minus_lambda_front;
        out[0usize] = difference_18;
        out[1usize] = sum_27;
        out[2usize] = projection_right_side_front;
        out[3usize] = projected_seat_vx;
        out[4usize] = projected_seat_vy;
        out[5usize] = projected_seat_omega;
        out[6usize] = projected_bar_vx;
        out[7usize] = projected_bar_vy;
        out[8usize] = projected_bar_omega;
        out[9usize] = difference_160;
        out[10usize] = difference_163;
        out[11usize] = sum_170;
        out[12usize] = c17_difference_172;
        out[13usize] = c17_difference_175;
        out[14usize] = sum_182;
        out[15usize] = lambda_B_x;
        out[16usize] = value_183;
        out[17usize] = value_184;
        ezy::Pivots::new()
            .see(&[2usize], T::least_ratio(c[21usize], c[22usize]))
            .see(&[0usize, 1usize], T::least_ratio(difference_58, c[23usize]))
    }
}
