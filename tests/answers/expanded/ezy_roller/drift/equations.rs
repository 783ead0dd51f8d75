#[automatically_derived]
impl<T: ::ezy_core::scalar::Scalar> ::ezy_core::model::Equations<T> for self::Drift {
    fn constants(&self, parameters: &[T], c: &mut [T]) {
        let parameters = ::ezy_core::kernel::array::<13usize, T>(parameters);
        let c = ::ezy_core::kernel::array_mut::<40usize, T>(c);
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
        let parameter_k = parameters[10usize];
        let parameter_a = parameters[0usize];
        let k14 = parameter_k * parameter_a;
        let k15 = k14 * parameter_a;
        let k16 = -(k14 + k14);
        let parameter_creep = parameters[12usize];
        let k18 = parameter_creep * parameter_creep;
        let parameter_cornering = parameters[11usize];
        let k20 = parameter_cornering * parameter_a;
        let k21 = T::PI;
        let k22 = k1 / parameter_m1;
        let k23 = k1 / parameter_i1;
        let k24 = parameter_b * k23;
        let k25 = k1 / parameter_m2;
        let k26 = k1 / parameter_i2;
        let k27 = parameter_d * parameter_m0;
        let k28 = k27 * k26;
        let k29 = parameter_c * parameter_m0;
        let k30 = k29 * k26;
        let k31 = parameter_b * parameter_b;
        let k32 = k31 * k23;
        let k33 = parameter_d * parameter_d;
        let k34 = k33 * k26;
        let k35 = k22 + k32;
        let k36 = k35 + k25;
        let k37 = k36 + k34;
        let k38 = parameter_d * parameter_c;
        let k39 = k38 * k26;
        let k40 = k25 - k39;
        let k41 = k22 + k25;
        let k42 = parameter_c * parameter_c;
        let k43 = k42 * k26;
        let k44 = k25 + k43;
        let k45 = k1 / k44;
        let k46 = k40 * k45;
        let k47 = k46 * k40;
        let k48 = k37 - k47;
        let k49 = k47 - k34;
        let k50 = parameter_m0 * k26;
        let k51 = parameter_d * k26;
        let k52 = parameter_c * k26;
        let k53 = T::from_f64(0.0000000001f64);
        let k54 = k53 * k44;
        let k55 = k37 + k41;
        let k56 = k55 * k55;
        let k57 = k53 * k56;
        let k58 = T::from_f64(2f64);
        let k59 = k20 * parameter_a;
        let k60 = parameter_b * k58;
        let k61 = parameter_d * k58;
        c[0usize] = k14;
        c[1usize] = parameter_cornering;
        c[2usize] = parameter_a;
        c[3usize] = k18;
        c[4usize] = parameter_k;
        c[5usize] = k15;
        c[6usize] = parameter_m0;
        c[7usize] = parameter_omega;
        c[8usize] = k20;
        c[9usize] = k30;
        c[10usize] = k32;
        c[11usize] = k49;
        c[12usize] = k48;
        c[13usize] = k41;
        c[14usize] = k28;
        c[15usize] = k46;
        c[16usize] = parameter_b;
        c[17usize] = parameter_d;
        c[18usize] = k22;
        c[19usize] = k24;
        c[20usize] = k45;
        c[21usize] = k23;
        c[22usize] = k25;
        c[23usize] = k51;
        c[24usize] = k50;
        c[25usize] = k52;
        c[26usize] = k44;
        c[27usize] = k54;
        c[28usize] = k57;
        c[29usize] = k26;
        c[30usize] = parameter_m1;
        c[31usize] = parameter_i1;
        c[32usize] = parameter_m2;
        c[33usize] = parameter_i2;
        c[34usize] = parameter_c;
        c[35usize] = k16;
        c[36usize] = k21;
        c[37usize] = k59;
        c[38usize] = k60;
        c[39usize] = k61;
    }
    fn mass_matrix(&self, c: &[T], m: &mut [T]) {
        let c = ::ezy_core::kernel::array::<40usize, T>(c);
        let out = ::ezy_core::kernel::array_mut::<6usize, T>(m);
        out[0usize] = c[30usize];
        out[1usize] = c[30usize];
        out[2usize] = c[31usize];
        out[3usize] = c[32usize];
        out[4usize] = c[32usize];
        out[5usize] = c[33usize];
    }
    fn position_constraint(&self, c: &[T], t: T, q: &[T], out: &mut [T]) {
        let c = ::ezy_core::kernel::array::<40usize, T>(c);
        let q = ::ezy_core::kernel::array::<6usize, T>(q);
        let out = ::ezy_core::kernel::array_mut::<2usize, T>(out);
        let seat_x = q[0usize];
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
        let sum_7 = T::fused(c[16usize], cos_seat_phi, seat_x);
        let bar_x = q[3usize];
        let difference_9 = sum_7 - bar_x;
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
        let sum_14 = T::fused(c[17usize], cos_bar_phi, difference_9);
        let seat_y = q[1usize];
        let sum_18 = T::fused(c[16usize], sin_seat_phi, seat_y);
        let bar_y = q[4usize];
        let difference_20 = sum_18 - bar_y;
        let sum_23 = T::fused(c[17usize], sin_bar_phi, difference_20);
        out[0usize] = sum_14;
        out[1usize] = sum_23;
    }
    fn velocity_constraint(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
        let c = ::ezy_core::kernel::array::<40usize, T>(c);
        let q = ::ezy_core::kernel::array::<6usize, T>(q);
        let v = ::ezy_core::kernel::array::<6usize, T>(v);
        let out = ::ezy_core::kernel::array_mut::<3usize, T>(out);
        let seat_vx = v[0usize];
        let bar_vx = v[3usize];
        let difference_4 = seat_vx - bar_vx;
        let bar_omega = v[5usize];
        let c17_bar_omega = c[17usize] * bar_omega;
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
        let difference_11 = T::fused(-c17_bar_omega, sin_bar_phi, difference_4);
        let seat_omega = v[2usize];
        let c16_seat_omega = c[16usize] * seat_omega;
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
        let difference_18 = T::fused(-c16_seat_omega, sin_seat_phi, difference_11);
        let seat_vy = v[1usize];
        let bar_vy = v[4usize];
        let difference_21 = seat_vy - bar_vy;
        let sum_24 = T::fused(c17_bar_omega, cos_bar_phi, difference_21);
        let sum_27 = T::fused(c16_seat_omega, cos_seat_phi, sum_24);
        let bar_omega_c34 = bar_omega * c[34usize];
        let difference_31 = T::fused(-bar_vx, sin_bar_phi, bar_omega_c34);
        let sum_33 = T::fused(bar_vy, cos_bar_phi, difference_31);
        out[0usize] = difference_18;
        out[1usize] = sum_27;
        out[2usize] = sum_33;
    }
    fn velocity_jacobian(&self, c: &[T], t: T, q: &[T], out: &mut [T]) {
        let c = ::ezy_core::kernel::array::<40usize, T>(c);
        let q = ::ezy_core::kernel::array::<6usize, T>(q);
        let out = ::ezy_core::kernel::array_mut::<11usize, T>(out);
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
        let c16_sin_seat_phi = c[16usize] * sin_seat_phi;
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
        let c17_sin_bar_phi = c[17usize] * sin_bar_phi;
        let c16_cos_seat_phi = c[16usize] * cos_seat_phi;
        let c17_cos_bar_phi = c[17usize] * cos_bar_phi;
        let value_14 = -c16_sin_seat_phi;
        let value_15 = -T::from_f64(1f64);
        let value_16 = -c17_sin_bar_phi;
        let value_17 = -sin_bar_phi;
        out[0usize] = T::from_f64(1f64);
        out[1usize] = value_14;
        out[2usize] = value_15;
        out[3usize] = value_16;
        out[4usize] = T::from_f64(1f64);
        out[5usize] = c16_cos_seat_phi;
        out[6usize] = value_15;
        out[7usize] = c17_cos_bar_phi;
        out[8usize] = value_17;
        out[9usize] = cos_bar_phi;
        out[10usize] = c[34usize];
    }
    fn convective_term(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
        let c = ::ezy_core::kernel::array::<40usize, T>(c);
        let q = ::ezy_core::kernel::array::<6usize, T>(q);
        let v = ::ezy_core::kernel::array::<6usize, T>(v);
        let out = ::ezy_core::kernel::array_mut::<3usize, T>(out);
        let seat_omega = v[2usize];
        let c16_seat_omega = c[16usize] * seat_omega;
        let product_4 = seat_omega * c16_seat_omega;
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
        let product_4_cos_seat_phi = product_4 * cos_seat_phi;
        let bar_omega = v[5usize];
        let c17_bar_omega = c[17usize] * bar_omega;
        let bar_omega_c17_bar_omega = bar_omega * c17_bar_omega;
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
        let sum_16 = T::fused(
            bar_omega_c17_bar_omega,
            cos_bar_phi,
            product_4_cos_seat_phi,
        );
        let product_4_sin_seat_phi = product_4 * sin_seat_phi;
        let sum_21 = T::fused(
            bar_omega_c17_bar_omega,
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
        let c = ::ezy_core::kernel::array::<40usize, T>(c);
        let q = ::ezy_core::kernel::array::<6usize, T>(q);
        let v = ::ezy_core::kernel::array::<6usize, T>(v);
        let out = ::ezy_core::kernel::array_mut::<6usize, T>(out);
        let seat_omega = v[2usize];
        let seat_vx = v[0usize];
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
        let seat_vx_sin_seat_phi = seat_vx * sin_seat_phi;
        let sum_12 = T::fused(seat_omega, c[2usize], seat_vx_sin_seat_phi);
        let seat_vy = v[1usize];
        let seat_vy_cos_seat_phi = seat_vy * cos_seat_phi;
        let difference_16 = seat_vy_cos_seat_phi - sum_12;
        let seat_vx_cos_seat_phi = seat_vx * cos_seat_phi;
        let sum_19 = T::fused(sin_seat_phi, seat_vy, seat_vx_cos_seat_phi);
        let sum_22 = T::fused(sum_19, sum_19, c[3usize]);
        let value_23 = T::sqrt(sum_22);
        let value_24 = T::atan2(difference_16, value_23);
        let c1_value_24 = c[1usize] * value_24;
        let difference_26 = T::fused(-c[0usize], seat_omega, c1_value_24);
        let product_27 = sin_seat_phi * difference_26;
        let difference_30 = T::fused(-seat_vx, c[4usize], product_27);
        let product_31 = cos_seat_phi * difference_26;
        let sum_33 = T::fused(seat_vy, c[4usize], product_31);
        let difference_34 = seat_vy_cos_seat_phi - seat_vx_sin_seat_phi;
        let c0_difference_34 = c[0usize] * difference_34;
        let difference_38 = T::fused(-seat_omega, c[5usize], c0_difference_34);
        let c7_t = c[7usize] * t;
        let cos_42 = T::cos(c7_t);
        let c6_cos_42 = c[6usize] * cos_42;
        let sum_45 = difference_38 + c6_cos_42;
        let sum_48 = T::fused(value_24, c[8usize], sum_45);
        let value_49 = -sum_33;
        let value_50 = -c6_cos_42;
        out[0usize] = difference_30;
        out[1usize] = value_49;
        out[2usize] = sum_48;
        out[3usize] = T::from_f64(0f64);
        out[4usize] = T::from_f64(0f64);
        out[5usize] = value_50;
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
        let lambda = ::ezy_core::kernel::array_mut::<3usize, T>(lambda);
        let seat_omega = v[2usize];
        let seat_vx = v[0usize];
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
        let seat_vx_sin_seat_phi = seat_vx * sin_seat_phi;
        let sum_12 = T::fused(seat_omega, c[2usize], seat_vx_sin_seat_phi);
        let seat_vy = v[1usize];
        let seat_vy_cos_seat_phi = seat_vy * cos_seat_phi;
        let difference_16 = seat_vy_cos_seat_phi - sum_12;
        let seat_vx_cos_seat_phi = seat_vx * cos_seat_phi;
        let sum_19 = T::fused(sin_seat_phi, seat_vy, seat_vx_cos_seat_phi);
        let sum_22 = T::fused(sum_19, sum_19, c[3usize]);
        let value_23 = T::sqrt(sum_22);
        let value_24 = T::atan2(difference_16, value_23);
        let c1_value_24 = c[1usize] * value_24;
        let difference_26 = T::fused(-c[0usize], seat_omega, c1_value_24);
        let product_27 = sin_seat_phi * difference_26;
        let force_seat_x = T::fused(-seat_vx, c[4usize], product_27);
        let product_31 = cos_seat_phi * difference_26;
        let minus_force_seat_y = T::fused(seat_vy, c[4usize], product_31);
        let difference_34 = seat_vy_cos_seat_phi - seat_vx_sin_seat_phi;
        let c0_difference_34 = c[0usize] * difference_34;
        let difference_38 = T::fused(-seat_omega, c[5usize], c0_difference_34);
        let c7_t = c[7usize] * t;
        let cos_42 = T::cos(c7_t);
        let sum_45 = T::fused(c[6usize], cos_42, difference_38);
        let force_seat_phi = T::fused(value_24, c[8usize], sum_45);
        let bar_vx = v[3usize];
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
        let bar_vx_cos_bar_phi = bar_vx * cos_bar_phi;
        let bar_vy = v[4usize];
        let sum_56 = T::fused(bar_vy, sin_bar_phi, bar_vx_cos_bar_phi);
        let bar_omega = v[5usize];
        let sum_56_bar_omega = sum_56 * bar_omega;
        let minus_right_side_front = T::fused(cos_42, c[9usize], sum_56_bar_omega);
        let cos_seat_phi_c10 = cos_seat_phi * c[10usize];
        let cos_bar_phi_c11 = cos_bar_phi * c[11usize];
        let product_67 = cos_bar_phi * cos_bar_phi_c11;
        let difference_68 = T::fused(-cos_seat_phi, cos_seat_phi_c10, product_67);
        let sum_70 = difference_68 + c[12usize];
        let sin_seat_phi_c10 = sin_seat_phi * c[10usize];
        let sin_bar_phi_c11 = sin_bar_phi * c[11usize];
        let product_74 = cos_bar_phi * sin_bar_phi_c11;
        let difference_75 = T::fused(-cos_seat_phi, sin_seat_phi_c10, product_74);
        let difference_77 = c[13usize] - difference_68;
        let cos_42_c14 = cos_42 * c[14usize];
        let sum_82 = T::fused(minus_right_side_front, c[15usize], cos_42_c14);
        let sin_bar_phi_sum_82 = sin_bar_phi * sum_82;
        let seat_omega_c16 = seat_omega * c[16usize];
        let product_86 = seat_omega * seat_omega_c16;
        let difference_88 = T::fused(-cos_seat_phi, product_86, sin_bar_phi_sum_82);
        let bar_omega_c17 = bar_omega * c[17usize];
        let bar_omega_bar_omega_c17 = bar_omega * bar_omega_c17;
        let difference_93 = T::fused(
            -cos_bar_phi,
            bar_omega_bar_omega_c17,
            difference_88,
        );
        let sum_96 = T::fused(force_seat_x, c[18usize], difference_93);
        let force_seat_phi_c19 = force_seat_phi * c[19usize];
        let difference_100 = T::fused(-sin_seat_phi, force_seat_phi_c19, sum_96);
        let cos_bar_phi_sum_82 = cos_bar_phi * sum_82;
        let sum_103 = T::fused(sin_seat_phi, product_86, cos_bar_phi_sum_82);
        let sum_105 = T::fused(sin_bar_phi, bar_omega_bar_omega_c17, sum_103);
        let sum_107 = T::fused(minus_force_seat_y, c[18usize], sum_105);
        let difference_109 = T::fused(cos_seat_phi, force_seat_phi_c19, -sum_107);
        let sum_70_difference_77 = sum_70 * difference_77;
        let difference_112 = T::fused(
            -difference_75,
            difference_75,
            sum_70_difference_77,
        );
        let quotient_113 = T::from_f64(1f64) / difference_112;
        let product_114 = difference_77 * difference_100;
        let difference_116 = T::fused(-difference_75, difference_109, product_114);
        let lambda_B_x = quotient_113 * difference_116;
        let sum_70_difference_109 = sum_70 * difference_109;
        let difference_120 = T::fused(
            -difference_75,
            difference_100,
            sum_70_difference_109,
        );
        let lambda_B_y = quotient_113 * difference_120;
        let cos_bar_phi_lambda_B_y = cos_bar_phi * lambda_B_y;
        let difference_124 = T::fused(-sin_bar_phi, lambda_B_x, cos_bar_phi_lambda_B_y);
        let c15_difference_124 = c[15usize] * difference_124;
        let lambda_front = T::fused(
            -minus_right_side_front,
            c[20usize],
            c15_difference_124,
        );
        let difference_129 = force_seat_x - lambda_B_x;
        let c18_difference_129 = c[18usize] * difference_129;
        let sum_131 = minus_force_seat_y + lambda_B_y;
        let c18_sum_131 = c[18usize] * sum_131;
        let sin_seat_phi_lambda_B_x = sin_seat_phi * lambda_B_x;
        let difference_135 = T::fused(
            -cos_seat_phi,
            lambda_B_y,
            sin_seat_phi_lambda_B_x,
        );
        let c19_difference_135 = c[19usize] * difference_135;
        let sum_139 = T::fused(force_seat_phi, c[21usize], c19_difference_135);
        let sum_141 = T::fused(sin_bar_phi, lambda_front, lambda_B_x);
        let sum_141_c22 = sum_141 * c[22usize];
        let difference_145 = T::fused(-cos_bar_phi, lambda_front, lambda_B_y);
        let c22_difference_145 = c[22usize] * difference_145;
        let difference_124_c23 = difference_124 * c[23usize];
        let sum_151 = T::fused(cos_42, c[24usize], difference_124_c23);
        let sum_154 = T::fused(lambda_front, c[25usize], sum_151);
        let value_158 = -c18_sum_131;
        let value_159 = -sum_154;
        a[0usize] = c18_difference_129;
        a[1usize] = value_158;
        a[2usize] = sum_139;
        a[3usize] = sum_141_c22;
        a[4usize] = c22_difference_145;
        a[5usize] = value_159;
        lambda[0usize] = lambda_B_x;
        lambda[1usize] = lambda_B_y;
        lambda[2usize] = lambda_front;
        ::ezy_core::model::Pivots::new()
            .see(&[2usize], T::least_ratio(c[26usize], c[27usize]))
            .see(&[0usize, 1usize], T::least_ratio(difference_112, c[28usize]))
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
        let residual = ::ezy_core::kernel::array::<3usize, T>(residual);
        let delta = ::ezy_core::kernel::array_mut::<6usize, T>(delta);
        let right_side_front = residual[2usize];
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
        let c10_cos_seat_phi = c[10usize] * cos_seat_phi;
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
        let c11_cos_bar_phi = c[11usize] * cos_bar_phi;
        let product_12 = cos_bar_phi * c11_cos_bar_phi;
        let difference_13 = T::fused(-cos_seat_phi, c10_cos_seat_phi, product_12);
        let sum_15 = difference_13 + c[12usize];
        let c10_sin_seat_phi = c[10usize] * sin_seat_phi;
        let c11_sin_bar_phi = c[11usize] * sin_bar_phi;
        let product_21 = cos_bar_phi * c11_sin_bar_phi;
        let difference_22 = T::fused(-cos_seat_phi, c10_sin_seat_phi, product_21);
        let difference_24 = c[13usize] - difference_13;
        let residual_0 = residual[0usize];
        let right_side_front_c15 = right_side_front * c[15usize];
        let difference_29 = T::fused(-sin_bar_phi, right_side_front_c15, residual_0);
        let residual_1 = residual[1usize];
        let sum_32 = T::fused(cos_bar_phi, right_side_front_c15, residual_1);
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
        let c15_difference_47 = c[15usize] * difference_47;
        let lambda_front = T::fused(right_side_front, c[20usize], c15_difference_47);
        let lambda_B_x_c18 = lambda_B_x * c[18usize];
        let lambda_B_y_c18 = lambda_B_y * c[18usize];
        let sin_seat_phi_lambda_B_x = sin_seat_phi * lambda_B_x;
        let difference_57 = T::fused(-cos_seat_phi, lambda_B_y, sin_seat_phi_lambda_B_x);
        let difference_57_c19 = difference_57 * c[19usize];
        let sum_61 = T::fused(sin_bar_phi, lambda_front, lambda_B_x);
        let sum_61_c22 = sum_61 * c[22usize];
        let difference_65 = T::fused(-cos_bar_phi, lambda_front, lambda_B_y);
        let c22_difference_65 = c[22usize] * difference_65;
        let difference_47_c23 = difference_47 * c[23usize];
        let sum_71 = T::fused(lambda_front, c[25usize], difference_47_c23);
        let value_75 = -lambda_B_x_c18;
        let value_76 = -lambda_B_y_c18;
        let value_77 = -sum_71;
        delta[0usize] = value_75;
        delta[1usize] = value_76;
        delta[2usize] = difference_57_c19;
        delta[3usize] = sum_61_c22;
        delta[4usize] = c22_difference_65;
        delta[5usize] = value_77;
        ::ezy_core::model::Pivots::new()
            .see(&[2usize], T::least_ratio(c[26usize], c[27usize]))
            .see(&[0usize, 1usize], T::least_ratio(difference_35, c[28usize]))
    }
}
