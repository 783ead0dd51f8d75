#[automatically_derived]
impl<T: ::ezy_core::scalar::Scalar> ::ezy_core::model::Equations<T>
for self::DrivenOnTarmac {
    fn constants(&self, parameters: &[T], c: &mut [T]) {
        let parameters = ::ezy_core::kernel::array::<11usize, T>(parameters);
        let c = ::ezy_core::kernel::array_mut::<41usize, T>(c);
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
        let parameter_k = parameters[10usize];
        let k14 = parameter_k * parameter_a;
        let k15 = k14 * parameter_a;
        let k16 = -(k14 + k14);
        let k17 = T::PI;
        let k18 = k1 / parameter_m1;
        let k19 = k1 / parameter_i1;
        let k20 = parameter_b * k19;
        let k21 = k1 / parameter_m2;
        let k22 = k1 / parameter_i2;
        let k23 = parameter_d * parameter_m0;
        let k24 = k23 * k22;
        let k25 = parameter_a * k19;
        let k26 = parameter_c * parameter_m0;
        let k27 = k26 * k22;
        let k28 = parameter_b * parameter_b;
        let k29 = k28 * k19;
        let k30 = parameter_d * parameter_d;
        let k31 = k30 * k22;
        let k32 = k18 + k29;
        let k33 = k32 + k21;
        let k34 = k33 + k31;
        let k35 = parameter_b * parameter_a;
        let k36 = k35 * k19;
        let k37 = k36 - k18;
        let k38 = parameter_d * parameter_c;
        let k39 = k38 * k22;
        let k40 = k21 - k39;
        let k41 = k18 + k21;
        let k42 = parameter_a * parameter_a;
        let k43 = k42 * k19;
        let k44 = k18 + k43;
        let k45 = parameter_c * parameter_c;
        let k46 = k45 * k22;
        let k47 = k21 + k46;
        let k48 = k1 / k44;
        let k49 = k37 * k48;
        let k50 = k49 * k37;
        let k51 = k34 - k50;
        let k52 = k50 - k29;
        let k53 = k1 / k47;
        let k54 = k40 * k53;
        let k55 = k54 * k40;
        let k56 = k51 - k55;
        let k57 = k55 - k31;
        let k58 = parameter_m0 * k22;
        let k59 = parameter_d * k22;
        let k60 = parameter_c * k22;
        let k61 = T::from_f64(0.0000000001f64);
        let k62 = k61 * k44;
        let k63 = k61 * k47;
        let k64 = k34 + k41;
        let k65 = k64 * k64;
        let k66 = k61 * k65;
        let k67 = T::from_f64(2f64);
        let k68 = parameter_b * k67;
        let k69 = parameter_d * k67;
        c[0usize] = parameter_k;
        c[1usize] = k14;
        c[2usize] = k15;
        c[3usize] = parameter_m0;
        c[4usize] = parameter_omega;
        c[5usize] = k18;
        c[6usize] = k25;
        c[7usize] = k27;
        c[8usize] = k52;
        c[9usize] = k57;
        c[10usize] = k56;
        c[11usize] = k41;
        c[12usize] = k20;
        c[13usize] = k49;
        c[14usize] = k24;
        c[15usize] = k54;
        c[16usize] = parameter_b;
        c[17usize] = parameter_d;
        c[18usize] = k53;
        c[19usize] = k48;
        c[20usize] = k19;
        c[21usize] = k21;
        c[22usize] = k59;
        c[23usize] = k58;
        c[24usize] = k60;
        c[25usize] = k44;
        c[26usize] = k62;
        c[27usize] = k47;
        c[28usize] = k63;
        c[29usize] = k66;
        c[30usize] = k22;
        c[31usize] = parameter_m1;
        c[32usize] = parameter_i1;
        c[33usize] = parameter_m2;
        c[34usize] = parameter_i2;
        c[35usize] = parameter_a;
        c[36usize] = parameter_c;
        c[37usize] = k16;
        c[38usize] = k17;
        c[39usize] = k68;
        c[40usize] = k69;
    }
    fn mass_matrix(&self, c: &[T], m: &mut [T]) {
        let c = ::ezy_core::kernel::array::<41usize, T>(c);
        let out = ::ezy_core::kernel::array_mut::<6usize, T>(m);
        out[0usize] = c[31usize];
        out[1usize] = c[31usize];
        out[2usize] = c[32usize];
        out[3usize] = c[33usize];
        out[4usize] = c[33usize];
        out[5usize] = c[34usize];
    }
    fn position_constraint(&self, c: &[T], t: T, q: &[T], out: &mut [T]) {
        let c = ::ezy_core::kernel::array::<41usize, T>(c);
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
        let c = ::ezy_core::kernel::array::<41usize, T>(c);
        let q = ::ezy_core::kernel::array::<6usize, T>(q);
        let v = ::ezy_core::kernel::array::<6usize, T>(v);
        let out = ::ezy_core::kernel::array_mut::<4usize, T>(out);
        let seat_vx = v[0usize];
        let seat_omega = v[2usize];
        let c16_seat_omega = c[16usize] * seat_omega;
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
        let difference_9 = T::fused(-c16_seat_omega, sin_seat_phi, seat_vx);
        let bar_vx = v[3usize];
        let difference_11 = difference_9 - bar_vx;
        let bar_omega = v[5usize];
        let c17_bar_omega = c[17usize] * bar_omega;
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
        let difference_18 = T::fused(-c17_bar_omega, sin_bar_phi, difference_11);
        let seat_vy = v[1usize];
        let bar_vy = v[4usize];
        let difference_21 = seat_vy - bar_vy;
        let sum_24 = T::fused(c16_seat_omega, cos_seat_phi, difference_21);
        let sum_27 = T::fused(c17_bar_omega, cos_bar_phi, sum_24);
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
        let c = ::ezy_core::kernel::array::<41usize, T>(c);
        let q = ::ezy_core::kernel::array::<6usize, T>(q);
        let out = ::ezy_core::kernel::array_mut::<14usize, T>(out);
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
        let c16_sin_seat_phi = c[16usize] * sin_seat_phi;
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
        let c17_sin_bar_phi = c[17usize] * sin_bar_phi;
        let c16_cos_seat_phi = c[16usize] * cos_seat_phi;
        let c17_cos_bar_phi = c[17usize] * cos_bar_phi;
        let value_15 = -c16_sin_seat_phi;
        let value_16 = -T::from_f64(1f64);
        let value_17 = -c17_sin_bar_phi;
        let value_18 = -sin_seat_phi;
        let value_19 = -c[35usize];
        let value_20 = -sin_bar_phi;
        out[0usize] = T::from_f64(1f64);
        out[1usize] = value_15;
        out[2usize] = value_16;
        out[3usize] = value_17;
        out[4usize] = T::from_f64(1f64);
        out[5usize] = c16_cos_seat_phi;
        out[6usize] = value_16;
        out[7usize] = c17_cos_bar_phi;
        out[8usize] = value_18;
        out[9usize] = cos_seat_phi;
        out[10usize] = value_19;
        out[11usize] = value_20;
        out[12usize] = cos_bar_phi;
        out[13usize] = c[36usize];
    }
    fn convective_term(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
        let c = ::ezy_core::kernel::array::<41usize, T>(c);
        let q = ::ezy_core::kernel::array::<6usize, T>(q);
        let v = ::ezy_core::kernel::array::<6usize, T>(v);
        let out = ::ezy_core::kernel::array_mut::<4usize, T>(out);
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
        let c = ::ezy_core::kernel::array::<41usize, T>(c);
        let q = ::ezy_core::kernel::array::<6usize, T>(q);
        let v = ::ezy_core::kernel::array::<6usize, T>(v);
        let out = ::ezy_core::kernel::array_mut::<6usize, T>(out);
        let seat_vx = v[0usize];
        let c0_seat_vx = c[0usize] * seat_vx;
        let seat_omega = v[2usize];
        let c1_seat_omega = c[1usize] * seat_omega;
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
        let sum_11 = T::fused(c1_seat_omega, sin_seat_phi, c0_seat_vx);
        let seat_vy = v[1usize];
        let product_15 = c1_seat_omega * cos_seat_phi;
        let difference_16 = T::fused(-c[0usize], seat_vy, product_15);
        let seat_vy_cos_seat_phi = seat_vy * cos_seat_phi;
        let difference_19 = T::fused(-seat_vx, sin_seat_phi, seat_vy_cos_seat_phi);
        let c1_difference_19 = c[1usize] * difference_19;
        let difference_23 = T::fused(-seat_omega, c[2usize], c1_difference_19);
        let c4_t = c[4usize] * t;
        let cos_27 = T::cos(c4_t);
        let c3_cos_27 = c[3usize] * cos_27;
        let sum_30 = difference_23 + c3_cos_27;
        let value_31 = -sum_11;
        let value_32 = -c3_cos_27;
        out[0usize] = value_31;
        out[1usize] = difference_16;
        out[2usize] = sum_30;
        out[3usize] = T::from_f64(0f64);
        out[4usize] = T::from_f64(0f64);
        out[5usize] = value_32;
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
        let c = ::ezy_core::kernel::array::<41usize, T>(c);
        let q = ::ezy_core::kernel::array::<6usize, T>(q);
        let v = ::ezy_core::kernel::array::<6usize, T>(v);
        let a = ::ezy_core::kernel::array_mut::<6usize, T>(a);
        let lambda = ::ezy_core::kernel::array_mut::<4usize, T>(lambda);
        let seat_vx = v[0usize];
        let c0_seat_vx = c[0usize] * seat_vx;
        let seat_omega = v[2usize];
        let c1_seat_omega = c[1usize] * seat_omega;
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
        let minus_force_seat_x = T::fused(c1_seat_omega, sin_seat_phi, c0_seat_vx);
        let seat_vy = v[1usize];
        let product_15 = c1_seat_omega * cos_seat_phi;
        let force_seat_y = T::fused(-c[0usize], seat_vy, product_15);
        let seat_vy_cos_seat_phi = seat_vy * cos_seat_phi;
        let difference_19 = T::fused(-seat_vx, sin_seat_phi, seat_vy_cos_seat_phi);
        let c1_difference_19 = c[1usize] * difference_19;
        let difference_23 = T::fused(-seat_omega, c[2usize], c1_difference_19);
        let c4_t = c[4usize] * t;
        let cos_27 = T::cos(c4_t);
        let force_seat_phi = T::fused(c[3usize], cos_27, difference_23);
        let product_31 = sin_seat_phi * minus_force_seat_x;
        let sum_33 = T::fused(cos_seat_phi, force_seat_y, product_31);
        let sum_33_c5 = sum_33 * c[5usize];
        let seat_vx_cos_seat_phi = seat_vx * cos_seat_phi;
        let sum_38 = T::fused(sin_seat_phi, seat_vy, seat_vx_cos_seat_phi);
        let difference_40 = T::fused(-seat_omega, sum_38, sum_33_c5);
        let right_side_rear = T::fused(-force_seat_phi, c[6usize], difference_40);
        let bar_vx = v[3usize];
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
        let bar_vx_cos_bar_phi = bar_vx * cos_bar_phi;
        let bar_vy = v[4usize];
        let sum_51 = T::fused(bar_vy, sin_bar_phi, bar_vx_cos_bar_phi);
        let bar_omega = v[5usize];
        let sum_51_bar_omega = sum_51 * bar_omega;
        let minus_right_side_front = T::fused(cos_27, c[7usize], sum_51_bar_omega);
        let cos_seat_phi_c8 = cos_seat_phi * c[8usize];
        let product_59 = cos_seat_phi * cos_seat_phi_c8;
        let cos_bar_phi_c9 = cos_bar_phi * c[9usize];
        let sum_63 = T::fused(cos_bar_phi, cos_bar_phi_c9, product_59);
        let sum_65 = sum_63 + c[10usize];
        let sin_seat_phi_c8 = sin_seat_phi * c[8usize];
        let product_67 = cos_seat_phi * sin_seat_phi_c8;
        let sin_bar_phi_c9 = sin_bar_phi * c[9usize];
        let sum_70 = T::fused(cos_bar_phi, sin_bar_phi_c9, product_67);
        let difference_72 = c[11usize] - sum_63;
        let force_seat_phi_c12 = force_seat_phi * c[12usize];
        let sum_77 = T::fused(right_side_rear, c[13usize], force_seat_phi_c12);
        let cos_27_c14 = cos_27 * c[14usize];
        let sum_83 = T::fused(minus_right_side_front, c[15usize], cos_27_c14);
        let sin_bar_phi_sum_83 = sin_bar_phi * sum_83;
        let difference_85 = T::fused(-sin_seat_phi, sum_77, sin_bar_phi_sum_83);
        let seat_omega_c16 = seat_omega * c[16usize];
        let product_88 = seat_omega * seat_omega_c16;
        let difference_90 = T::fused(-cos_seat_phi, product_88, difference_85);
        let bar_omega_c17 = bar_omega * c[17usize];
        let bar_omega_bar_omega_c17 = bar_omega * bar_omega_c17;
        let difference_95 = T::fused(
            -cos_bar_phi,
            bar_omega_bar_omega_c17,
            difference_90,
        );
        let difference_97 = T::fused(-minus_force_seat_x, c[5usize], difference_95);
        let cos_seat_phi_sum_77 = cos_seat_phi * sum_77;
        let difference_100 = T::fused(-cos_bar_phi, sum_83, cos_seat_phi_sum_77);
        let difference_102 = T::fused(-sin_seat_phi, product_88, difference_100);
        let difference_104 = T::fused(
            -sin_bar_phi,
            bar_omega_bar_omega_c17,
            difference_102,
        );
        let sum_106 = T::fused(force_seat_y, c[5usize], difference_104);
        let sum_65_difference_72 = sum_65 * difference_72;
        let difference_109 = T::fused(-sum_70, sum_70, sum_65_difference_72);
        let quotient_110 = T::from_f64(1f64) / difference_109;
        let product_111 = difference_72 * difference_97;
        let difference_113 = T::fused(-sum_70, sum_106, product_111);
        let lambda_B_x = quotient_110 * difference_113;
        let sum_65_sum_106 = sum_65 * sum_106;
        let difference_117 = T::fused(-sum_70, difference_97, sum_65_sum_106);
        let lambda_B_y = quotient_110 * difference_117;
        let cos_bar_phi_lambda_B_y = cos_bar_phi * lambda_B_y;
        let difference_121 = T::fused(-sin_bar_phi, lambda_B_x, cos_bar_phi_lambda_B_y);
        let c15_difference_121 = c[15usize] * difference_121;
        let lambda_front = T::fused(
            -minus_right_side_front,
            c[18usize],
            c15_difference_121,
        );
        let cos_seat_phi_lambda_B_y = cos_seat_phi * lambda_B_y;
        let difference_128 = T::fused(
            -sin_seat_phi,
            lambda_B_x,
            cos_seat_phi_lambda_B_y,
        );
        let c13_difference_128 = c[13usize] * difference_128;
        let lambda_rear = T::fused(right_side_rear, c[19usize], c13_difference_128);
        let sum_133 = minus_force_seat_x + lambda_B_x;
        let difference_135 = T::fused(sin_seat_phi, lambda_rear, -sum_133);
        let c5_difference_135 = c[5usize] * difference_135;
        let difference_137 = force_seat_y - lambda_B_y;
        let difference_139 = T::fused(-cos_seat_phi, lambda_rear, difference_137);
        let c5_difference_139 = c[5usize] * difference_139;
        let force_seat_phi_c20 = force_seat_phi * c[20usize];
        let difference_144 = T::fused(-c[12usize], difference_128, force_seat_phi_c20);
        let sum_146 = T::fused(c[6usize], lambda_rear, difference_144);
        let sum_148 = T::fused(sin_bar_phi, lambda_front, lambda_B_x);
        let sum_148_c21 = sum_148 * c[21usize];
        let difference_152 = T::fused(-cos_bar_phi, lambda_front, lambda_B_y);
        let c21_difference_152 = c[21usize] * difference_152;
        let difference_121_c22 = difference_121 * c[22usize];
        let sum_158 = T::fused(cos_27, c[23usize], difference_121_c22);
        let sum_161 = T::fused(lambda_front, c[24usize], sum_158);
        let value_167 = -sum_161;
        a[0usize] = c5_difference_135;
        a[1usize] = c5_difference_139;
        a[2usize] = sum_146;
        a[3usize] = sum_148_c21;
        a[4usize] = c21_difference_152;
        a[5usize] = value_167;
        lambda[0usize] = lambda_B_x;
        lambda[1usize] = lambda_B_y;
        lambda[2usize] = lambda_rear;
        lambda[3usize] = lambda_front;
        ::ezy_core::model::Pivots::new()
            .see(&[2usize], T::least_ratio(c[25usize], c[26usize]))
            .see(&[3usize], T::least_ratio(c[27usize], c[28usize]))
            .see(&[0usize, 1usize], T::least_ratio(difference_109, c[29usize]))
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
        let c = ::ezy_core::kernel::array::<41usize, T>(c);
        let q = ::ezy_core::kernel::array::<6usize, T>(q);
        let residual = ::ezy_core::kernel::array::<4usize, T>(residual);
        let delta = ::ezy_core::kernel::array_mut::<6usize, T>(delta);
        let right_side_rear = residual[2usize];
        let right_side_front = residual[3usize];
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
        let c8_cos_seat_phi = c[8usize] * cos_seat_phi;
        let product_8 = cos_seat_phi * c8_cos_seat_phi;
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
        let c9_cos_bar_phi = c[9usize] * cos_bar_phi;
        let sum_14 = T::fused(cos_bar_phi, c9_cos_bar_phi, product_8);
        let sum_16 = sum_14 + c[10usize];
        let c8_sin_seat_phi = c[8usize] * sin_seat_phi;
        let product_19 = cos_seat_phi * c8_sin_seat_phi;
        let c9_sin_bar_phi = c[9usize] * sin_bar_phi;
        let sum_23 = T::fused(cos_bar_phi, c9_sin_bar_phi, product_19);
        let difference_25 = c[11usize] - sum_14;
        let residual_0 = residual[0usize];
        let right_side_rear_c13 = right_side_rear * c[13usize];
        let difference_30 = T::fused(-sin_seat_phi, right_side_rear_c13, residual_0);
        let right_side_front_c15 = right_side_front * c[15usize];
        let difference_34 = T::fused(-sin_bar_phi, right_side_front_c15, difference_30);
        let residual_1 = residual[1usize];
        let sum_37 = T::fused(cos_seat_phi, right_side_rear_c13, residual_1);
        let sum_39 = T::fused(cos_bar_phi, right_side_front_c15, sum_37);
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
        let c15_difference_54 = c[15usize] * difference_54;
        let lambda_front = T::fused(right_side_front, c[18usize], c15_difference_54);
        let cos_seat_phi_lambda_B_y = cos_seat_phi * lambda_B_y;
        let difference_61 = T::fused(-sin_seat_phi, lambda_B_x, cos_seat_phi_lambda_B_y);
        let c13_difference_61 = c[13usize] * difference_61;
        let lambda_rear = T::fused(right_side_rear, c[19usize], c13_difference_61);
        let difference_67 = T::fused(sin_seat_phi, lambda_rear, -lambda_B_x);
        let difference_67_c5 = difference_67 * c[5usize];
        let sum_71 = T::fused(cos_seat_phi, lambda_rear, lambda_B_y);
        let c5_sum_71 = c[5usize] * sum_71;
        let lambda_rear_c6 = lambda_rear * c[6usize];
        let difference_77 = T::fused(-difference_61, c[12usize], lambda_rear_c6);
        let sum_79 = T::fused(sin_bar_phi, lambda_front, lambda_B_x);
        let sum_79_c21 = sum_79 * c[21usize];
        let difference_83 = T::fused(-cos_bar_phi, lambda_front, lambda_B_y);
        let c21_difference_83 = c[21usize] * difference_83;
        let difference_54_c22 = difference_54 * c[22usize];
        let sum_89 = T::fused(lambda_front, c[24usize], difference_54_c22);
        let value_95 = -c5_sum_71;
        let value_96 = -sum_89;
        delta[0usize] = difference_67_c5;
        delta[1usize] = value_95;
        delta[2usize] = difference_77;
        delta[3usize] = sum_79_c21;
        delta[4usize] = c21_difference_83;
        delta[5usize] = value_96;
        ::ezy_core::model::Pivots::new()
            .see(&[2usize], T::least_ratio(c[25usize], c[26usize]))
            .see(&[3usize], T::least_ratio(c[27usize], c[28usize]))
            .see(&[0usize, 1usize], T::least_ratio(difference_42, c[29usize]))
    }
}
