#[automatically_derived]
impl<T: ::ezy_core::scalar::Scalar> ::ezy_core::model::Equations<T> for self::Ridden {
    fn constants(&self, parameters: &[T], c: &mut [T]) {
        let parameters = ::ezy_core::kernel::array::<8usize, T>(parameters);
        let c = ::ezy_core::kernel::array_mut::<34usize, T>(c);
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
        let k14 = T::from_f64(180f64);
        let k16 = k14 / k11;
        let k17 = k1 / parameter_m1;
        let k18 = k1 / parameter_i1;
        let k19 = parameter_b * k18;
        let k20 = k1 / parameter_m2;
        let k21 = k1 / parameter_i2;
        let k22 = parameter_d * k21;
        let k23 = parameter_a * k18;
        let k24 = parameter_c * k21;
        let k25 = parameter_b * parameter_b;
        let k26 = k25 * k18;
        let k27 = parameter_d * parameter_d;
        let k28 = k27 * k21;
        let k29 = k17 + k26;
        let k30 = k29 + k20;
        let k31 = k30 + k28;
        let k32 = parameter_b * parameter_a;
        let k33 = k32 * k18;
        let k34 = k33 - k17;
        let k35 = parameter_d * parameter_c;
        let k36 = k35 * k21;
        let k37 = k20 - k36;
        let k38 = k17 + k20;
        let k39 = parameter_a * parameter_a;
        let k40 = k39 * k18;
        let k41 = k17 + k40;
        let k42 = parameter_c * parameter_c;
        let k43 = k42 * k21;
        let k44 = k20 + k43;
        let k45 = k1 / k41;
        let k46 = k34 * k45;
        let k47 = k46 * k34;
        let k48 = k31 - k47;
        let k49 = k47 - k26;
        let k50 = k1 / k44;
        let k51 = k37 * k50;
        let k52 = k51 * k37;
        let k53 = k48 - k52;
        let k54 = k52 - k28;
        let k55 = T::from_f64(0.0000000001f64);
        let k56 = k55 * k41;
        let k57 = k55 * k44;
        let k58 = k31 + k38;
        let k59 = k58 * k58;
        let k60 = k55 * k59;
        let k61 = parameter_b * k12;
        let k62 = parameter_d * k12;
        c[1usize] = k23;
        c[2usize] = k24;
        c[3usize] = k49;
        c[4usize] = k54;
        c[5usize] = k53;
        c[6usize] = k38;
        c[7usize] = k19;
        c[8usize] = k46;
        c[9usize] = k22;
        c[10usize] = k51;
        c[11usize] = parameter_b;
        c[12usize] = parameter_d;
        c[13usize] = k50;
        c[14usize] = k45;
        c[15usize] = k17;
        c[16usize] = k18;
        c[17usize] = k20;
        c[18usize] = k21;
        c[19usize] = k41;
        c[20usize] = k56;
        c[21usize] = k44;
        c[22usize] = k57;
        c[23usize] = k60;
        c[24usize] = parameter_m1;
        c[25usize] = parameter_i1;
        c[26usize] = parameter_m2;
        c[27usize] = parameter_i2;
        c[28usize] = parameter_a;
        c[29usize] = parameter_c;
        c[30usize] = k16;
        c[31usize] = k13;
        c[32usize] = k61;
        c[33usize] = k62;
    }
    fn mass_matrix(&self, c: &[T], m: &mut [T]) {
        let c = ::ezy_core::kernel::array::<34usize, T>(c);
        let out = ::ezy_core::kernel::array_mut::<6usize, T>(m);
        out[0usize] = c[24usize];
        out[1usize] = c[24usize];
        out[2usize] = c[25usize];
        out[3usize] = c[26usize];
        out[4usize] = c[26usize];
        out[5usize] = c[27usize];
    }
    fn position_constraint(&self, c: &[T], t: T, q: &[T], out: &mut [T]) {
        let c = ::ezy_core::kernel::array::<34usize, T>(c);
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
        let c = ::ezy_core::kernel::array::<34usize, T>(c);
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
        let seat_omega_c28 = seat_omega * c[28usize];
        let sum_31 = T::fused(seat_vx, sin_seat_phi, seat_omega_c28);
        let difference_33 = T::fused(seat_vy, cos_seat_phi, -sum_31);
        let bar_omega_c29 = bar_omega * c[29usize];
        let difference_37 = T::fused(-bar_vx, sin_bar_phi, bar_omega_c29);
        let sum_39 = T::fused(bar_vy, cos_bar_phi, difference_37);
        out[0usize] = difference_18;
        out[1usize] = sum_27;
        out[2usize] = difference_33;
        out[3usize] = sum_39;
    }
    fn velocity_jacobian(&self, c: &[T], t: T, q: &[T], out: &mut [T]) {
        let c = ::ezy_core::kernel::array::<34usize, T>(c);
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
        let value_19 = -c[28usize];
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
        out[13usize] = c[29usize];
    }
    fn convective_term(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
        let c = ::ezy_core::kernel::array::<34usize, T>(c);
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
        let c = ::ezy_core::kernel::array::<34usize, T>(c);
        let q = ::ezy_core::kernel::array::<6usize, T>(q);
        let v = ::ezy_core::kernel::array::<6usize, T>(v);
        let out = ::ezy_core::kernel::array_mut::<6usize, T>(out);
        let torque = c[0usize];
        let value_3 = -torque;
        out[0usize] = T::from_f64(0f64);
        out[1usize] = T::from_f64(0f64);
        out[2usize] = value_3;
        out[3usize] = T::from_f64(0f64);
        out[4usize] = T::from_f64(0f64);
        out[5usize] = torque;
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
        let c = ::ezy_core::kernel::array::<34usize, T>(c);
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
        let torque = c[0usize];
        let c1_torque = c[1usize] * torque;
        let right_side_rear = T::fused(-sum_9, seat_omega, c1_torque);
        let bar_vx = v[3usize];
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
        let bar_vx_cos_bar_phi = bar_vx * cos_bar_phi;
        let bar_vy = v[4usize];
        let sum_23 = T::fused(bar_vy, sin_bar_phi, bar_vx_cos_bar_phi);
        let bar_omega = v[5usize];
        let torque_c2 = torque * c[2usize];
        let right_side_front = T::fused(-sum_23, bar_omega, torque_c2);
        let cos_seat_phi_c3 = cos_seat_phi * c[3usize];
        let product_31 = cos_seat_phi * cos_seat_phi_c3;
        let cos_bar_phi_c4 = cos_bar_phi * c[4usize];
        let sum_35 = T::fused(cos_bar_phi, cos_bar_phi_c4, product_31);
        let sum_37 = sum_35 + c[5usize];
        let sin_seat_phi_c3 = sin_seat_phi * c[3usize];
        let product_39 = cos_seat_phi * sin_seat_phi_c3;
        let sin_bar_phi_c4 = sin_bar_phi * c[4usize];
        let sum_42 = T::fused(cos_bar_phi, sin_bar_phi_c4, product_39);
        let difference_44 = c[6usize] - sum_35;
        let torque_c7 = torque * c[7usize];
        let difference_49 = T::fused(-right_side_rear, c[8usize], torque_c7);
        let product_50 = sin_seat_phi * difference_49;
        let torque_c9 = torque * c[9usize];
        let sum_55 = T::fused(right_side_front, c[10usize], torque_c9);
        let difference_57 = T::fused(-sin_bar_phi, sum_55, product_50);
        let seat_omega_c11 = seat_omega * c[11usize];
        let product_60 = seat_omega * seat_omega_c11;
        let difference_62 = T::fused(-cos_seat_phi, product_60, difference_57);
        let bar_omega_c12 = bar_omega * c[12usize];
        let bar_omega_bar_omega_c12 = bar_omega * bar_omega_c12;
        let difference_67 = T::fused(
            -cos_bar_phi,
            bar_omega_bar_omega_c12,
            difference_62,
        );
        let cos_bar_phi_sum_55 = cos_bar_phi * sum_55;
        let difference_70 = T::fused(-cos_seat_phi, difference_49, cos_bar_phi_sum_55);
        let difference_72 = T::fused(-sin_seat_phi, product_60, difference_70);
        let difference_74 = T::fused(
            -sin_bar_phi,
            bar_omega_bar_omega_c12,
            difference_72,
        );
        let sum_37_difference_44 = sum_37 * difference_44;
        let difference_77 = T::fused(-sum_42, sum_42, sum_37_difference_44);
        let quotient_78 = T::from_f64(1f64) / difference_77;
        let product_79 = difference_44 * difference_67;
        let difference_81 = T::fused(-sum_42, difference_74, product_79);
        let lambda_B_x = quotient_78 * difference_81;
        let sum_37_difference_74 = sum_37 * difference_74;
        let difference_85 = T::fused(-sum_42, difference_67, sum_37_difference_74);
        let lambda_B_y = quotient_78 * difference_85;
        let cos_bar_phi_lambda_B_y = cos_bar_phi * lambda_B_y;
        let difference_89 = T::fused(-sin_bar_phi, lambda_B_x, cos_bar_phi_lambda_B_y);
        let c10_difference_89 = c[10usize] * difference_89;
        let lambda_front = T::fused(right_side_front, c[13usize], c10_difference_89);
        let cos_seat_phi_lambda_B_y = cos_seat_phi * lambda_B_y;
        let difference_96 = T::fused(-sin_seat_phi, lambda_B_x, cos_seat_phi_lambda_B_y);
        let c8_difference_96 = c[8usize] * difference_96;
        let lambda_rear = T::fused(right_side_rear, c[14usize], c8_difference_96);
        let difference_102 = T::fused(sin_seat_phi, lambda_rear, -lambda_B_x);
        let difference_102_c15 = difference_102 * c[15usize];
        let sum_106 = T::fused(cos_seat_phi, lambda_rear, lambda_B_y);
        let c15_sum_106 = c[15usize] * sum_106;
        let c7_difference_96 = c[7usize] * difference_96;
        let sum_111 = T::fused(torque, c[16usize], c7_difference_96);
        let difference_113 = T::fused(c[1usize], lambda_rear, -sum_111);
        let sum_115 = T::fused(sin_bar_phi, lambda_front, lambda_B_x);
        let sum_115_c17 = sum_115 * c[17usize];
        let difference_119 = T::fused(-cos_bar_phi, lambda_front, lambda_B_y);
        let c17_difference_119 = c[17usize] * difference_119;
        let torque_c18 = torque * c[18usize];
        let difference_124 = T::fused(-c[9usize], difference_89, torque_c18);
        let difference_126 = T::fused(-c[2usize], lambda_front, difference_124);
        let value_132 = -c15_sum_106;
        a[0usize] = difference_102_c15;
        a[1usize] = value_132;
        a[2usize] = difference_113;
        a[3usize] = sum_115_c17;
        a[4usize] = c17_difference_119;
        a[5usize] = difference_126;
        lambda[0usize] = lambda_B_x;
        lambda[1usize] = lambda_B_y;
        lambda[2usize] = lambda_rear;
        lambda[3usize] = lambda_front;
        ::ezy_core::model::Pivots::new()
            .see(&[2usize], T::least_ratio(c[19usize], c[20usize]))
            .see(&[3usize], T::least_ratio(c[21usize], c[22usize]))
            .see(&[0usize, 1usize], T::least_ratio(difference_77, c[23usize]))
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
        let c = ::ezy_core::kernel::array::<34usize, T>(c);
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
        let lambda_rear_c1 = lambda_rear * c[1usize];
        let difference_77 = T::fused(-difference_61, c[7usize], lambda_rear_c1);
        let sum_79 = T::fused(sin_bar_phi, lambda_front, lambda_B_x);
        let sum_79_c17 = sum_79 * c[17usize];
        let difference_83 = T::fused(-cos_bar_phi, lambda_front, lambda_B_y);
        let c17_difference_83 = c[17usize] * difference_83;
        let difference_54_c9 = difference_54 * c[9usize];
        let sum_89 = T::fused(lambda_front, c[2usize], difference_54_c9);
        let value_95 = -c15_sum_71;
        let value_96 = -sum_89;
        delta[0usize] = difference_67_c15;
        delta[1usize] = value_95;
        delta[2usize] = difference_77;
        delta[3usize] = sum_79_c17;
        delta[4usize] = c17_difference_83;
        delta[5usize] = value_96;
        ::ezy_core::model::Pivots::new()
            .see(&[2usize], T::least_ratio(c[19usize], c[20usize]))
            .see(&[3usize], T::least_ratio(c[21usize], c[22usize]))
            .see(&[0usize, 1usize], T::least_ratio(difference_42, c[23usize]))
    }
}
