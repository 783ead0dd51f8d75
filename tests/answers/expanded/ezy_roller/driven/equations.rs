#[automatically_derived]
impl<T: ::ezy_core::scalar::Scalar> ::ezy_core::model::Equations<T> for self::Driven {
    fn constants(&self, parameters: &[T], c: &mut [T]) {
        let parameters = ::ezy_core::kernel::array::<10usize, T>(parameters);
        let c = ::ezy_core::kernel::array_mut::<40usize, T>(c);
        let k1 = T::from_f64(1f64);
        let parameter_m1 = parameters[4usize];
        let parameter_i1 = parameters[5usize];
        let parameter_m2 = parameters[6usize];
        let parameter_i2 = parameters[7usize];
        let parameter_b = parameters[1usize];
        let parameter_d = parameters[3usize];
        let parameter_a = parameters[0usize];
        let parameter_c = parameters[2usize];
        let parameter_m0 = parameters[8usize];
        let parameter_omega = parameters[9usize];
        let k13 = T::PI;
        let k14 = k1 / parameter_m1;
        let k15 = k1 / parameter_i1;
        let k16 = parameter_b * parameter_m0;
        let k17 = k16 * k15;
        let k18 = k1 / parameter_m2;
        let k19 = k1 / parameter_i2;
        let k20 = parameter_d * parameter_m0;
        let k21 = k20 * k19;
        let k22 = parameter_a * parameter_m0;
        let k23 = k22 * k15;
        let k24 = parameter_c * parameter_m0;
        let k25 = k24 * k19;
        let k26 = parameter_b * parameter_b;
        let k27 = k26 * k15;
        let k28 = parameter_d * parameter_d;
        let k29 = k28 * k19;
        let k30 = k14 + k27;
        let k31 = k30 + k18;
        let k32 = k31 + k29;
        let k33 = parameter_b * parameter_a;
        let k34 = k33 * k15;
        let k35 = k34 - k14;
        let k36 = parameter_d * parameter_c;
        let k37 = k36 * k19;
        let k38 = k18 - k37;
        let k39 = k14 + k18;
        let k40 = parameter_a * parameter_a;
        let k41 = k40 * k15;
        let k42 = k14 + k41;
        let k43 = parameter_c * parameter_c;
        let k44 = k43 * k19;
        let k45 = k18 + k44;
        let k46 = k1 / k42;
        let k47 = k35 * k46;
        let k48 = k47 * k35;
        let k49 = k32 - k48;
        let k50 = k48 - k27;
        let k51 = k1 / k45;
        let k52 = k38 * k51;
        let k53 = k52 * k38;
        let k54 = k49 - k53;
        let k55 = k53 - k29;
        let k56 = parameter_m0 * k15;
        let k57 = parameter_b * k15;
        let k58 = parameter_a * k15;
        let k59 = parameter_m0 * k19;
        let k60 = parameter_d * k19;
        let k61 = parameter_c * k19;
        let k62 = T::from_f64(0.0000000001f64);
        let k63 = k62 * k42;
        let k64 = k62 * k45;
        let k65 = k32 + k39;
        let k66 = k65 * k65;
        let k67 = k62 * k66;
        let k68 = T::from_f64(2f64);
        let k69 = parameter_b * k68;
        let k70 = parameter_d * k68;
        c[0usize] = k23;
        c[1usize] = parameter_omega;
        c[2usize] = k25;
        c[3usize] = k50;
        c[4usize] = k55;
        c[5usize] = k54;
        c[6usize] = k39;
        c[7usize] = k17;
        c[8usize] = k47;
        c[9usize] = k21;
        c[10usize] = k52;
        c[11usize] = parameter_b;
        c[12usize] = parameter_d;
        c[13usize] = k51;
        c[14usize] = k46;
        c[15usize] = k14;
        c[16usize] = k57;
        c[17usize] = k56;
        c[18usize] = k58;
        c[19usize] = k18;
        c[20usize] = k60;
        c[21usize] = k59;
        c[22usize] = k61;
        c[23usize] = k42;
        c[24usize] = k63;
        c[25usize] = k45;
        c[26usize] = k64;
        c[27usize] = k67;
        c[28usize] = parameter_m0;
        c[29usize] = k15;
        c[30usize] = k19;
        c[31usize] = parameter_m1;
        c[32usize] = parameter_i1;
        c[33usize] = parameter_m2;
        c[34usize] = parameter_i2;
        c[35usize] = parameter_a;
        c[36usize] = parameter_c;
        c[37usize] = k13;
        c[38usize] = k69;
        c[39usize] = k70;
    }
    fn mass_matrix(&self, c: &[T], m: &mut [T]) {
        let c = ::ezy_core::kernel::array::<40usize, T>(c);
        let out = ::ezy_core::kernel::array_mut::<6usize, T>(m);
        out[0usize] = c[31usize];
        out[1usize] = c[31usize];
        out[2usize] = c[32usize];
        out[3usize] = c[33usize];
        out[4usize] = c[33usize];
        out[5usize] = c[34usize];
    }
    fn position_constraint(&self, c: &[T], t: T, q: &[T], out: &mut [T]) {
        let c = ::ezy_core::kernel::array::<40usize, T>(c);
        let q = ::ezy_core::kernel::array::<6usize, T>(q);
        let out = ::ezy_core::kernel::array_mut::<2usize, T>(out);
        let seat_x = q[0usize];
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
        let sum_7 = T::fused(c[11usize], cos_seat_phi, seat_x);
        let bar_x = q[3usize];
        let difference_9 = sum_7 - bar_x;
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
        let sum_14 = T::fused(c[12usize], cos_bar_phi, difference_9);
        let seat_y = q[1usize];
        let sum_18 = T::fused(c[11usize], sin_seat_phi, seat_y);
        let bar_y = q[4usize];
        let difference_20 = sum_18 - bar_y;
        let sum_23 = T::fused(c[12usize], sin_bar_phi, difference_20);
        out[0usize] = sum_14;
        out[1usize] = sum_23;
    }
    fn velocity_constraint(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
        let c = ::ezy_core::kernel::array::<40usize, T>(c);
        let q = ::ezy_core::kernel::array::<6usize, T>(q);
        let v = ::ezy_core::kernel::array::<6usize, T>(v);
        let out = ::ezy_core::kernel::array_mut::<4usize, T>(out);
        let seat_vx = v[0usize];
        let seat_omega = v[2usize];
        let c11_seat_omega = c[11usize] * seat_omega;
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
        let difference_9 = T::fused(-c11_seat_omega, sin_seat_phi, seat_vx);
        let bar_vx = v[3usize];
        let difference_11 = difference_9 - bar_vx;
        let bar_omega = v[5usize];
        let c12_bar_omega = c[12usize] * bar_omega;
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
        let difference_18 = T::fused(-c12_bar_omega, sin_bar_phi, difference_11);
        let seat_vy = v[1usize];
        let bar_vy = v[4usize];
        let difference_21 = seat_vy - bar_vy;
        let sum_24 = T::fused(c11_seat_omega, cos_seat_phi, difference_21);
        let sum_27 = T::fused(c12_bar_omega, cos_bar_phi, sum_24);
        let seat_omega_c35 = seat_omega * c[35usize];
        let sum_31 = T::fused(seat_vx, sin_seat_phi, seat_omega_c35);
        let difference_33 = T::fused(seat_vy, cos_seat_phi, -sum_31);
        let bar_omega_c36 = bar_omega * c[36usize];
        let difference_37 = T::fused(-bar_vx, sin_bar_phi, bar_omega_c36);
        let sum_39 = T::fused(bar_vy, cos_bar_phi, difference_37);
        out[0usize] = difference_18;
        out[1usize] = sum_27;
        out[2usize] = difference_33;
        out[3usize] = sum_39;
    }
    fn velocity_jacobian(&self, c: &[T], t: T, q: &[T], out: &mut [T]) {
        let c = ::ezy_core::kernel::array::<40usize, T>(c);
        let q = ::ezy_core::kernel::array::<6usize, T>(q);
        let out = ::ezy_core::kernel::array_mut::<14usize, T>(out);
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
        let c11_sin_seat_phi = c[11usize] * sin_seat_phi;
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
        let c12_sin_bar_phi = c[12usize] * sin_bar_phi;
        let c11_cos_seat_phi = c[11usize] * cos_seat_phi;
        let c12_cos_bar_phi = c[12usize] * cos_bar_phi;
        let value_15 = -c11_sin_seat_phi;
        let value_16 = -T::from_f64(1f64);
        let value_17 = -c12_sin_bar_phi;
        let value_18 = -sin_seat_phi;
        let value_19 = -c[35usize];
        let value_20 = -sin_bar_phi;
        out[0usize] = T::from_f64(1f64);
        out[1usize] = value_15;
        out[2usize] = value_16;
        out[3usize] = value_17;
        out[4usize] = T::from_f64(1f64);
        out[5usize] = c11_cos_seat_phi;
        out[6usize] = value_16;
        out[7usize] = c12_cos_bar_phi;
        out[8usize] = value_18;
        out[9usize] = cos_seat_phi;
        out[10usize] = value_19;
        out[11usize] = value_20;
        out[12usize] = cos_bar_phi;
        out[13usize] = c[36usize];
    }
    fn convective_term(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
        let c = ::ezy_core::kernel::array::<40usize, T>(c);
        let q = ::ezy_core::kernel::array::<6usize, T>(q);
        let v = ::ezy_core::kernel::array::<6usize, T>(v);
        let out = ::ezy_core::kernel::array_mut::<4usize, T>(out);
        let seat_omega = v[2usize];
        let c11_seat_omega = c[11usize] * seat_omega;
        let product_4 = seat_omega * c11_seat_omega;
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
        let product_4_cos_seat_phi = product_4 * cos_seat_phi;
        let bar_omega = v[5usize];
        let c12_bar_omega = c[12usize] * bar_omega;
        let bar_omega_c12_bar_omega = bar_omega * c12_bar_omega;
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
        let sum_16 = T::fused(
            bar_omega_c12_bar_omega,
            cos_bar_phi,
            product_4_cos_seat_phi,
        );
        let product_4_sin_seat_phi = product_4 * sin_seat_phi;
        let sum_21 = T::fused(
            bar_omega_c12_bar_omega,
            sin_bar_phi,
            product_4_sin_seat_phi,
        );
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
        let c = ::ezy_core::kernel::array::<40usize, T>(c);
        let q = ::ezy_core::kernel::array::<6usize, T>(q);
        let v = ::ezy_core::kernel::array::<6usize, T>(v);
        let out = ::ezy_core::kernel::array_mut::<6usize, T>(out);
        let c1_t = c[1usize] * t;
        let cos_4 = T::cos(c1_t);
        let c28_cos_4 = c[28usize] * cos_4;
        let value_7 = -c28_cos_4;
        out[0usize] = T::from_f64(0f64);
        out[1usize] = T::from_f64(0f64);
        out[2usize] = c28_cos_4;
        out[3usize] = T::from_f64(0f64);
        out[4usize] = T::from_f64(0f64);
        out[5usize] = value_7;
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
    ) -> ::ezy_core::model::Pivots {
        let c = ::ezy_core::kernel::array::<40usize, T>(c);
        let q = ::ezy_core::kernel::array::<6usize, T>(q);
        let v = ::ezy_core::kernel::array::<6usize, T>(v);
        let a = ::ezy_core::kernel::array_mut::<6usize, T>(a);
        let lambda = ::ezy_core::kernel::array_mut::<4usize, T>(lambda);
        let seat_vx = v[0usize];
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
        let seat_vx_cos_seat_phi = seat_vx * cos_seat_phi;
        let seat_vy = v[1usize];
        let sum_9 = T::fused(seat_vy, sin_seat_phi, seat_vx_cos_seat_phi);
        let seat_omega = v[2usize];
        let sum_9_seat_omega = sum_9 * seat_omega;
        let c1_t = c[1usize] * t;
        let cos_15 = T::cos(c1_t);
        let minus_right_side_rear = T::fused(c[0usize], cos_15, sum_9_seat_omega);
        let bar_vx = v[3usize];
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
        let bar_vx_cos_bar_phi = bar_vx * cos_bar_phi;
        let bar_vy = v[4usize];
        let sum_26 = T::fused(bar_vy, sin_bar_phi, bar_vx_cos_bar_phi);
        let bar_omega = v[5usize];
        let sum_26_bar_omega = sum_26 * bar_omega;
        let minus_right_side_front = T::fused(cos_15, c[2usize], sum_26_bar_omega);
        let cos_seat_phi_c3 = cos_seat_phi * c[3usize];
        let product_34 = cos_seat_phi * cos_seat_phi_c3;
        let cos_bar_phi_c4 = cos_bar_phi * c[4usize];
        let sum_38 = T::fused(cos_bar_phi, cos_bar_phi_c4, product_34);
        let sum_40 = sum_38 + c[5usize];
        let sin_seat_phi_c3 = sin_seat_phi * c[3usize];
        let product_42 = cos_seat_phi * sin_seat_phi_c3;
        let sin_bar_phi_c4 = sin_bar_phi * c[4usize];
        let sum_45 = T::fused(cos_bar_phi, sin_bar_phi_c4, product_42);
        let difference_47 = c[6usize] - sum_38;
        let minus_right_side_rear_c8 = minus_right_side_rear * c[8usize];
        let difference_52 = T::fused(-cos_15, c[7usize], minus_right_side_rear_c8);
        let product_53 = sin_seat_phi * difference_52;
        let cos_15_c9 = cos_15 * c[9usize];
        let sum_58 = T::fused(minus_right_side_front, c[10usize], cos_15_c9);
        let sum_60 = T::fused(sin_bar_phi, sum_58, product_53);
        let seat_omega_c11 = seat_omega * c[11usize];
        let product_63 = seat_omega * seat_omega_c11;
        let difference_65 = T::fused(-cos_seat_phi, product_63, sum_60);
        let bar_omega_c12 = bar_omega * c[12usize];
        let bar_omega_bar_omega_c12 = bar_omega * bar_omega_c12;
        let difference_70 = T::fused(
            -cos_bar_phi,
            bar_omega_bar_omega_c12,
            difference_65,
        );
        let product_71 = cos_seat_phi * difference_52;
        let sum_73 = T::fused(cos_bar_phi, sum_58, product_71);
        let sum_75 = T::fused(sin_seat_phi, product_63, sum_73);
        let sum_77 = T::fused(sin_bar_phi, bar_omega_bar_omega_c12, sum_75);
        let sum_40_difference_47 = sum_40 * difference_47;
        let difference_80 = T::fused(-sum_45, sum_45, sum_40_difference_47);
        let quotient_81 = T::from_f64(1f64) / difference_80;
        let product_82 = difference_47 * difference_70;
        let sum_84 = T::fused(sum_45, sum_77, product_82);
        let lambda_B_x = quotient_81 * sum_84;
        let sum_45_difference_70 = sum_45 * difference_70;
        let sum_88 = T::fused(sum_40, sum_77, sum_45_difference_70);
        let minus_lambda_B_y = quotient_81 * sum_88;
        let sin_bar_phi_lambda_B_x = sin_bar_phi * lambda_B_x;
        let sum_92 = T::fused(cos_bar_phi, minus_lambda_B_y, sin_bar_phi_lambda_B_x);
        let c10_sum_92 = c[10usize] * sum_92;
        let minus_lambda_front = T::fused(
            minus_right_side_front,
            c[13usize],
            c10_sum_92,
        );
        let sin_seat_phi_lambda_B_x = sin_seat_phi * lambda_B_x;
        let sum_99 = T::fused(cos_seat_phi, minus_lambda_B_y, sin_seat_phi_lambda_B_x);
        let c8_sum_99 = c[8usize] * sum_99;
        let minus_lambda_rear = T::fused(minus_right_side_rear, c[14usize], c8_sum_99);
        let sum_105 = T::fused(sin_seat_phi, minus_lambda_rear, lambda_B_x);
        let sum_105_c15 = sum_105 * c[15usize];
        let sum_109 = T::fused(cos_seat_phi, minus_lambda_rear, minus_lambda_B_y);
        let c15_sum_109 = c[15usize] * sum_109;
        let sum_99_c16 = sum_99 * c[16usize];
        let sum_115 = T::fused(cos_15, c[17usize], sum_99_c16);
        let difference_118 = T::fused(-minus_lambda_rear, c[18usize], sum_115);
        let difference_120 = T::fused(-sin_bar_phi, minus_lambda_front, lambda_B_x);
        let difference_120_c19 = difference_120 * c[19usize];
        let difference_124 = T::fused(
            cos_bar_phi,
            minus_lambda_front,
            -minus_lambda_B_y,
        );
        let c19_difference_124 = c[19usize] * difference_124;
        let sum_92_c20 = sum_92 * c[20usize];
        let difference_130 = T::fused(-cos_15, c[21usize], sum_92_c20);
        let sum_133 = T::fused(minus_lambda_front, c[22usize], difference_130);
        let value_139 = -sum_105_c15;
        let value_140 = -minus_lambda_B_y;
        let value_141 = -minus_lambda_rear;
        let value_142 = -minus_lambda_front;
        a[0usize] = value_139;
        a[1usize] = c15_sum_109;
        a[2usize] = difference_118;
        a[3usize] = difference_120_c19;
        a[4usize] = c19_difference_124;
        a[5usize] = sum_133;
        lambda[0usize] = lambda_B_x;
        lambda[1usize] = value_140;
        lambda[2usize] = value_141;
        lambda[3usize] = value_142;
        ::ezy_core::model::Pivots::new()
            .see(&[2usize], T::least_ratio(c[23usize], c[24usize]))
            .see(&[3usize], T::least_ratio(c[25usize], c[26usize]))
            .see(&[0usize, 1usize], T::least_ratio(difference_80, c[27usize]))
    }
    #[inline]
    fn correction(
        &self,
        c: &[T],
        t: T,
        q: &[T],
        residual: &[T],
        delta: &mut [T],
    ) -> ::ezy_core::model::Pivots {
        let c = ::ezy_core::kernel::array::<40usize, T>(c);
        let q = ::ezy_core::kernel::array::<6usize, T>(q);
        let residual = ::ezy_core::kernel::array::<4usize, T>(residual);
        let delta = ::ezy_core::kernel::array_mut::<6usize, T>(delta);
        let right_side_rear = residual[2usize];
        let right_side_front = residual[3usize];
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
        let c3_cos_seat_phi = c[3usize] * cos_seat_phi;
        let product_8 = cos_seat_phi * c3_cos_seat_phi;
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
        let c4_cos_bar_phi = c[4usize] * cos_bar_phi;
        let sum_14 = T::fused(cos_bar_phi, c4_cos_bar_phi, product_8);
        let sum_16 = sum_14 + c[5usize];
        let c3_sin_seat_phi = c[3usize] * sin_seat_phi;
        let product_19 = cos_seat_phi * c3_sin_seat_phi;
        let c4_sin_bar_phi = c[4usize] * sin_bar_phi;
        let sum_23 = T::fused(cos_bar_phi, c4_sin_bar_phi, product_19);
        let difference_25 = c[6usize] - sum_14;
        let residual_0 = residual[0usize];
        let right_side_rear_c8 = right_side_rear * c[8usize];
        let difference_30 = T::fused(-sin_seat_phi, right_side_rear_c8, residual_0);
        let right_side_front_c10 = right_side_front * c[10usize];
        let difference_34 = T::fused(-sin_bar_phi, right_side_front_c10, difference_30);
        let residual_1 = residual[1usize];
        let sum_37 = T::fused(cos_seat_phi, right_side_rear_c8, residual_1);
        let sum_39 = T::fused(cos_bar_phi, right_side_front_c10, sum_37);
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
        let c10_difference_54 = c[10usize] * difference_54;
        let lambda_front = T::fused(right_side_front, c[13usize], c10_difference_54);
        let cos_seat_phi_lambda_B_y = cos_seat_phi * lambda_B_y;
        let difference_61 = T::fused(-sin_seat_phi, lambda_B_x, cos_seat_phi_lambda_B_y);
        let c8_difference_61 = c[8usize] * difference_61;
        let lambda_rear = T::fused(right_side_rear, c[14usize], c8_difference_61);
        let difference_67 = T::fused(sin_seat_phi, lambda_rear, -lambda_B_x);
        let difference_67_c15 = difference_67 * c[15usize];
        let sum_71 = T::fused(cos_seat_phi, lambda_rear, lambda_B_y);
        let c15_sum_71 = c[15usize] * sum_71;
        let lambda_rear_c18 = lambda_rear * c[18usize];
        let difference_77 = T::fused(-difference_61, c[16usize], lambda_rear_c18);
        let sum_79 = T::fused(sin_bar_phi, lambda_front, lambda_B_x);
        let sum_79_c19 = sum_79 * c[19usize];
        let difference_83 = T::fused(-cos_bar_phi, lambda_front, lambda_B_y);
        let c19_difference_83 = c[19usize] * difference_83;
        let difference_54_c20 = difference_54 * c[20usize];
        let sum_89 = T::fused(lambda_front, c[22usize], difference_54_c20);
        let value_95 = -c15_sum_71;
        let value_96 = -sum_89;
        delta[0usize] = difference_67_c15;
        delta[1usize] = value_95;
        delta[2usize] = difference_77;
        delta[3usize] = sum_79_c19;
        delta[4usize] = c19_difference_83;
        delta[5usize] = value_96;
        ::ezy_core::model::Pivots::new()
            .see(&[2usize], T::least_ratio(c[23usize], c[24usize]))
            .see(&[3usize], T::least_ratio(c[25usize], c[26usize]))
            .see(&[0usize, 1usize], T::least_ratio(difference_42, c[27usize]))
    }
}
