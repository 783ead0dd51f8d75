#[automatically_derived]
impl<T: ezy::Scalar> ezy::Equations<T> for self::Coast {
    fn constants(&self, parameters: &[T], c: &mut [T]) {
        let parameters = ezy::array::<8usize, T>(parameters);
        let c = ezy::array_mut::<46usize, T>(c);
        let m1 = parameters[4usize];
        let i1 = parameters[5usize];
        let m2 = parameters[6usize];
        let i2 = parameters[7usize];
        let b = parameters[1usize];
        let d = parameters[3usize];
        let parameter_a = parameters[0usize];
        let parameter_c = parameters[2usize];
        let pi_over_two = T::PI / T::from_f64(2f64);
        let one_over_m1 = T::from_f64(1f64) / m1;
        let one_over_i1 = T::from_f64(1f64) / i1;
        let one_over_m2 = T::from_f64(1f64) / m2;
        let one_over_i2 = T::from_f64(1f64) / i2;
        let b_squared = b * b;
        let b_squared_over_i1 = b_squared * one_over_i1;
        let d_squared = d * d;
        let d_squared_over_i2 = d_squared * one_over_i2;
        let k22 = one_over_m1 + b_squared_over_i1;
        let k23 = k22 + one_over_m2;
        let k24 = k23 + d_squared_over_i2;
        let b_a = b * parameter_a;
        let b_a_over_i1 = b_a * one_over_i1;
        let k27 = b_a_over_i1 - one_over_m1;
        let d_c = d * parameter_c;
        let d_c_over_i2 = d_c * one_over_i2;
        let k30 = one_over_m2 - d_c_over_i2;
        let one_over_m1_plus_one_over_m2 = one_over_m1 + one_over_m2;
        let a_squared = parameter_a * parameter_a;
        let a_squared_over_i1 = a_squared * one_over_i1;
        let k34 = one_over_m1 + a_squared_over_i1;
        let c_squared = parameter_c * parameter_c;
        let c_squared_over_i2 = c_squared * one_over_i2;
        let k37 = one_over_m2 + c_squared_over_i2;
        let k38 = T::from_f64(1f64) / k34;
        let k39 = k27 * k38;
        let k40 = k39 * k27;
        let k41 = k24 - k40;
        let k42 = k40 - b_squared_over_i1;
        let k43 = T::from_f64(1f64) / k37;
        let k44 = k30 * k43;
        let k45 = k44 * k30;
        let k46 = k41 - k45;
        let k47 = k45 - d_squared_over_i2;
        let b_over_i1 = b * one_over_i1;
        let a_over_i1 = parameter_a * one_over_i1;
        let d_over_i2 = d * one_over_i2;
        let c_over_i2 = parameter_c * one_over_i2;
        let k53 = T::from_f64(0.0000000001f64) * k34;
        let k54 = T::from_f64(0.0000000001f64) * k37;
        let k55 = k24 + one_over_m1_plus_one_over_m2;
        let k56 = k55 * k55;
        let k57 = T::from_f64(0.0000000001f64) * k56;
        let b_two = b * T::from_f64(2f64);
        let d_two = d * T::from_f64(2f64);
        let c_plus_d = parameter_c + d;
        let k61 = T::from_f64(1f64) / c_plus_d;
        let k62 = b * k61;
        let k63 = d * k61;
        let k64 = T::from_f64(1f64) - k63;
        let k65 = d * k62;
        let k66 = k65 - b;
        let a_plus_b = parameter_a + b;
        let k68 = k64 * parameter_a;
        let k69 = k68 - k66;
        let k70 = k61 * parameter_a;
        let k71 = -(k70 + k62);
        let k72 = k64 * k64;
        let k73 = k72 * m2;
        let k74 = k61 * k61;
        let k75 = k74 * i2;
        let k76 = m1 + k73;
        let k77 = k76 + k75;
        let k78 = m2 - k73;
        let k79 = k78 - k75;
        let k80 = k61 * i2;
        let k81 = a_plus_b * m2;
        let k82 = k69 * k64;
        let k83 = k82 * m2;
        let k84 = k71 * k61;
        let k85 = k84 * i2;
        let k86 = k81 - k83;
        let k87 = k86 + k85;
        let a_squared_m1 = a_squared * m1;
        let k89 = a_plus_b * a_plus_b;
        let k90 = k89 * m2;
        let k91 = k69 * k69;
        let k92 = k91 * m2;
        let k93 = k71 * k71;
        let k94 = k93 * i2;
        let a_squared_m1_plus_i1 = a_squared_m1 + i1;
        let k96 = a_squared_m1_plus_i1 + k90;
        let k97 = k92 - k90;
        let k98 = k97 + k94;
        let a_m1 = parameter_a * m1;
        let k100 = k71 * i2;
        c[0usize] = k42;
        c[1usize] = k47;
        c[2usize] = k46;
        c[3usize] = one_over_m1_plus_one_over_m2;
        c[4usize] = b;
        c[5usize] = d;
        c[6usize] = k39;
        c[7usize] = k44;
        c[8usize] = k43;
        c[9usize] = k38;
        c[10usize] = one_over_m1;
        c[11usize] = b_over_i1;
        c[12usize] = a_over_i1;
        c[13usize] = one_over_m2;
        c[14usize] = d_over_i2;
        c[15usize] = c_over_i2;
        c[16usize] = k34;
        c[17usize] = k53;
        c[18usize] = k37;
        c[19usize] = k54;
        c[20usize] = k57;
        c[21usize] = parameter_a;
        c[22usize] = parameter_c;
        c[23usize] = one_over_i1;
        c[24usize] = one_over_i2;
        c[25usize] = m1;
        c[26usize] = i1;
        c[27usize] = m2;
        c[28usize] = i2;
        c[29usize] = pi_over_two;
        c[30usize] = b_two;
        c[31usize] = d_two;
        c[32usize] = k64;
        c[33usize] = k66;
        c[34usize] = k61;
        c[35usize] = k62;
        c[36usize] = k79;
        c[37usize] = k77;
        c[38usize] = k87;
        c[39usize] = k98;
        c[40usize] = k96;
        c[41usize] = k80;
        c[42usize] = k69;
        c[43usize] = k100;
        c[44usize] = a_m1;
        c[45usize] = a_plus_b;
    }
    fn mass_matrix(&self, c: &[T], out: &mut [T]) {
        let c = ezy::array::<46usize, T>(c);
        let out = ezy::array_mut::<6usize, T>(out);
        let m1 = c[25usize];
        let i1 = c[26usize];
        let m2 = c[27usize];
        let i2 = c[28usize];
        out[0usize] = m1;
        out[1usize] = m1;
        out[2usize] = i1;
        out[3usize] = m2;
        out[4usize] = m2;
        out[5usize] = i2;
    }
    #[inline(always)]
    fn position_constraint(&self, c: &[T], t: T, q: &[T], out: &mut [T]) {
        let c = ezy::array::<46usize, T>(c);
        let q = ezy::array::<6usize, T>(q);
        let out = ezy::array_mut::<2usize, T>(out);
        let seat_x = q[0usize];
        let b = c[4usize];
        let seat_phi = q[2usize];
        let bar_phi = q[5usize];
        let [(sin_seat_phi, cos_seat_phi), (sin_bar_phi, cos_bar_phi)] = T::sin_cos_of([
            seat_phi,
            bar_phi,
        ]);
        let bar_x = q[3usize];
        let d = c[5usize];
        let seat_y = q[1usize];
        let bar_y = q[4usize];
        out[0usize] = T::fused(
            d,
            cos_bar_phi,
            T::fused(b, cos_seat_phi, seat_x) - bar_x,
        );
        out[1usize] = T::fused(
            d,
            sin_bar_phi,
            T::fused(b, sin_seat_phi, seat_y) - bar_y,
        );
    }
    #[inline(always)]
    fn velocity_constraint(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
        let c = ezy::array::<46usize, T>(c);
        let q = ezy::array::<6usize, T>(q);
        let v = ezy::array::<6usize, T>(v);
        let out = ezy::array_mut::<4usize, T>(out);
        let seat_vx = v[0usize];
        let b = c[4usize];
        let seat_omega = v[2usize];
        let b_seat_omega = b * seat_omega;
        let seat_phi = q[2usize];
        let bar_phi = q[5usize];
        let [(sin_seat_phi, cos_seat_phi), (sin_bar_phi, cos_bar_phi)] = T::sin_cos_of([
            seat_phi,
            bar_phi,
        ]);
        let bar_vx = v[3usize];
        let d = c[5usize];
        let bar_omega = v[5usize];
        let d_bar_omega = d * bar_omega;
        let seat_vy = v[1usize];
        let bar_vy = v[4usize];
        let parameter_a = c[21usize];
        let parameter_c = c[22usize];
        out[0usize] = T::fused(
            -d_bar_omega,
            sin_bar_phi,
            T::fused(-b_seat_omega, sin_seat_phi, seat_vx) - bar_vx,
        );
        out[1usize] = T::fused(
            d_bar_omega,
            cos_bar_phi,
            T::fused(b_seat_omega, cos_seat_phi, seat_vy - bar_vy),
        );
        out[2usize] = T::fused(
            seat_vy,
            cos_seat_phi,
            -T::fused(seat_vx, sin_seat_phi, seat_omega * parameter_a),
        );
        out[3usize] = T::fused(
            bar_vy,
            cos_bar_phi,
            T::fused(-bar_vx, sin_bar_phi, bar_omega * parameter_c),
        );
    }
    fn velocity_jacobian(&self, c: &[T], t: T, q: &[T], out: &mut [T]) {
        let c = ezy::array::<46usize, T>(c);
        let q = ezy::array::<6usize, T>(q);
        let out = ezy::array_mut::<14usize, T>(out);
        let b = c[4usize];
        let seat_phi = q[2usize];
        let bar_phi = q[5usize];
        let [(sin_seat_phi, cos_seat_phi), (sin_bar_phi, cos_bar_phi)] = T::sin_cos_of([
            seat_phi,
            bar_phi,
        ]);
        let d = c[5usize];
        let parameter_a = c[21usize];
        let parameter_c = c[22usize];
        out[0usize] = T::from_f64(1f64);
        out[1usize] = -(b * sin_seat_phi);
        out[2usize] = -T::from_f64(1f64);
        out[3usize] = -(d * sin_bar_phi);
        out[4usize] = T::from_f64(1f64);
        out[5usize] = b * cos_seat_phi;
        out[6usize] = -T::from_f64(1f64);
        out[7usize] = d * cos_bar_phi;
        out[8usize] = -sin_seat_phi;
        out[9usize] = cos_seat_phi;
        out[10usize] = -parameter_a;
        out[11usize] = -sin_bar_phi;
        out[12usize] = cos_bar_phi;
        out[13usize] = parameter_c;
    }
    fn convective_term(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
        let c = ezy::array::<46usize, T>(c);
        let q = ezy::array::<6usize, T>(q);
        let v = ezy::array::<6usize, T>(v);
        let out = ezy::array_mut::<4usize, T>(out);
        let b = c[4usize];
        let seat_omega = v[2usize];
        let seat_omega_b_seat_omega = seat_omega * (b * seat_omega);
        let seat_phi = q[2usize];
        let bar_phi = q[5usize];
        let [(sin_seat_phi, cos_seat_phi), (sin_bar_phi, cos_bar_phi)] = T::sin_cos_of([
            seat_phi,
            bar_phi,
        ]);
        let d = c[5usize];
        let bar_omega = v[5usize];
        let bar_omega_d_bar_omega = bar_omega * (d * bar_omega);
        let seat_vx = v[0usize];
        let seat_vy = v[1usize];
        let product_27 = seat_omega
            * T::fused(sin_seat_phi, seat_vy, cos_seat_phi * seat_vx);
        let bar_vx = v[3usize];
        let bar_vy = v[4usize];
        let product_33 = bar_omega * T::fused(sin_bar_phi, bar_vy, cos_bar_phi * bar_vx);
        out[0usize] = -T::fused(
            bar_omega_d_bar_omega,
            cos_bar_phi,
            seat_omega_b_seat_omega * cos_seat_phi,
        );
        out[1usize] = -T::fused(
            bar_omega_d_bar_omega,
            sin_bar_phi,
            seat_omega_b_seat_omega * sin_seat_phi,
        );
        out[2usize] = -product_27;
        out[3usize] = -product_33;
    }
    fn applied_force(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
        let c = ezy::array::<46usize, T>(c);
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
    fn outputs(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
        let c = ezy::array::<46usize, T>(c);
        let q = ezy::array::<6usize, T>(q);
        let v = ezy::array::<6usize, T>(v);
        let out = ezy::array_mut::<0usize, T>(out);
    }
    #[inline(always)]
    fn accelerations(
        &self,
        c: &[T],
        t: T,
        q: &[T],
        v: &[T],
        a: &mut [T],
        lambda: &mut [T],
    ) -> ezy::Pivots {
        let c = ezy::array::<46usize, T>(c);
        let q = ezy::array::<6usize, T>(q);
        let v = ezy::array::<6usize, T>(v);
        let a = ezy::array_mut::<6usize, T>(a);
        let lambda = ezy::array_mut::<4usize, T>(lambda);
        let seat_vx = v[0usize];
        let seat_phi = q[2usize];
        let bar_phi = q[5usize];
        let [(sin_seat_phi, cos_seat_phi), (sin_bar_phi, cos_bar_phi)] = T::sin_cos_of([
            seat_phi,
            bar_phi,
        ]);
        let seat_vy = v[1usize];
        let seat_omega = v[2usize];
        let minus_right_side_rear = T::fused(
            seat_vy,
            sin_seat_phi,
            seat_vx * cos_seat_phi,
        ) * seat_omega;
        let bar_vx = v[3usize];
        let bar_vy = v[4usize];
        let bar_omega = v[5usize];
        let minus_right_side_front = T::fused(bar_vy, sin_bar_phi, bar_vx * cos_bar_phi)
            * bar_omega;
        let k42 = c[0usize];
        let k47 = c[1usize];
        let sum_28 = T::fused(
            cos_bar_phi,
            cos_bar_phi * k47,
            cos_seat_phi * (cos_seat_phi * k42),
        );
        let k46 = c[2usize];
        let A_B_x_B_x = sum_28 + k46;
        let A_B_x_B_y = T::fused(
            cos_bar_phi,
            sin_bar_phi * k47,
            cos_seat_phi * (sin_seat_phi * k42),
        );
        let one_over_m1_plus_one_over_m2 = c[3usize];
        let A_B_y_B_y = one_over_m1_plus_one_over_m2 - sum_28;
        let b = c[4usize];
        let seat_omega_seat_omega_b = seat_omega * (seat_omega * b);
        let d = c[5usize];
        let bar_omega_bar_omega_d = bar_omega * (bar_omega * d);
        let k39 = c[6usize];
        let minus_right_side_rear_k39 = minus_right_side_rear * k39;
        let difference_50 = T::fused(
            sin_seat_phi,
            minus_right_side_rear_k39,
            -T::fused(
                cos_bar_phi,
                bar_omega_bar_omega_d,
                cos_seat_phi * seat_omega_seat_omega_b,
            ),
        );
        let k44 = c[7usize];
        let minus_right_side_front_k44 = minus_right_side_front * k44;
        let right_side_B_x = T::fused(
            sin_bar_phi,
            minus_right_side_front_k44,
            difference_50,
        );
        let sum_59 = T::fused(
            cos_seat_phi,
            minus_right_side_rear_k39,
            T::fused(
                sin_bar_phi,
                bar_omega_bar_omega_d,
                sin_seat_phi * seat_omega_seat_omega_b,
            ),
        );
        let minus_right_side_B_y = T::fused(
            cos_bar_phi,
            minus_right_side_front_k44,
            sum_59,
        );
        let pivot_B_x_B_y = T::fused(-A_B_x_B_y, A_B_x_B_y, A_B_x_B_x * A_B_y_B_y);
        let one_over_pivot_B_x_B_y = T::from_f64(1f64) / pivot_B_x_B_y;
        let lambda_B_x = one_over_pivot_B_x_B_y
            * T::fused(A_B_x_B_y, minus_right_side_B_y, A_B_y_B_y * right_side_B_x);
        let minus_lambda_B_y = one_over_pivot_B_x_B_y
            * T::fused(A_B_x_B_x, minus_right_side_B_y, A_B_x_B_y * right_side_B_x);
        let sum_76 = T::fused(cos_bar_phi, minus_lambda_B_y, sin_bar_phi * lambda_B_x);
        let k43 = c[8usize];
        let minus_lambda_front = T::fused(minus_right_side_front, k43, k44 * sum_76);
        let sum_83 = T::fused(cos_seat_phi, minus_lambda_B_y, sin_seat_phi * lambda_B_x);
        let k38 = c[9usize];
        let minus_lambda_rear = T::fused(minus_right_side_rear, k38, k39 * sum_83);
        let one_over_m1 = c[10usize];
        let b_over_i1 = c[11usize];
        let a_over_i1 = c[12usize];
        let one_over_m2 = c[13usize];
        let d_over_i2 = c[14usize];
        let c_over_i2 = c[15usize];
        let k34 = c[16usize];
        let k53 = c[17usize];
        let k37 = c[18usize];
        let k54 = c[19usize];
        let k57 = c[20usize];
        a[0usize] = -(T::fused(sin_seat_phi, minus_lambda_rear, lambda_B_x)
            * one_over_m1);
        a[1usize] = one_over_m1
            * T::fused(cos_seat_phi, minus_lambda_rear, minus_lambda_B_y);
        a[2usize] = T::fused(-minus_lambda_rear, a_over_i1, sum_83 * b_over_i1);
        a[3usize] = T::fused(-sin_bar_phi, minus_lambda_front, lambda_B_x) * one_over_m2;
        a[4usize] = one_over_m2
            * T::fused(cos_bar_phi, minus_lambda_front, -minus_lambda_B_y);
        a[5usize] = T::fused(minus_lambda_front, c_over_i2, sum_76 * d_over_i2);
        lambda[0usize] = lambda_B_x;
        lambda[1usize] = -minus_lambda_B_y;
        lambda[2usize] = -minus_lambda_rear;
        lambda[3usize] = -minus_lambda_front;
        ezy::Pivots::new()
            .see(&[2usize], T::least_ratio(k34, k53))
            .see(&[3usize], T::least_ratio(k37, k54))
            .see(&[0usize, 1usize], T::least_ratio(pivot_B_x_B_y, k57))
    }
    #[inline(always)]
    fn correction(
        &self,
        c: &[T],
        t: T,
        q: &[T],
        residual: &[T],
        delta: &mut [T],
    ) -> ezy::Pivots {
        let c = ezy::array::<46usize, T>(c);
        let q = ezy::array::<6usize, T>(q);
        let residual = ezy::array::<4usize, T>(residual);
        let delta = ezy::array_mut::<6usize, T>(delta);
        let right_side_rear = residual[2usize];
        let right_side_front = residual[3usize];
        let k42 = c[0usize];
        let seat_phi = q[2usize];
        let bar_phi = q[5usize];
        let [(sin_seat_phi, cos_seat_phi), (sin_bar_phi, cos_bar_phi)] = T::sin_cos_of([
            seat_phi,
            bar_phi,
        ]);
        let k47 = c[1usize];
        let sum_14 = T::fused(
            cos_bar_phi,
            k47 * cos_bar_phi,
            cos_seat_phi * (k42 * cos_seat_phi),
        );
        let k46 = c[2usize];
        let A_B_x_B_x = sum_14 + k46;
        let A_B_x_B_y = T::fused(
            cos_bar_phi,
            k47 * sin_bar_phi,
            cos_seat_phi * (k42 * sin_seat_phi),
        );
        let one_over_m1_plus_one_over_m2 = c[3usize];
        let A_B_y_B_y = one_over_m1_plus_one_over_m2 - sum_14;
        let residual_0 = residual[0usize];
        let k39 = c[6usize];
        let right_side_rear_k39 = right_side_rear * k39;
        let k44 = c[7usize];
        let right_side_front_k44 = right_side_front * k44;
        let right_side_B_x = T::fused(
            -sin_bar_phi,
            right_side_front_k44,
            T::fused(-sin_seat_phi, right_side_rear_k39, residual_0),
        );
        let residual_1 = residual[1usize];
        let right_side_B_y = T::fused(
            cos_bar_phi,
            right_side_front_k44,
            T::fused(cos_seat_phi, right_side_rear_k39, residual_1),
        );
        let pivot_B_x_B_y = T::fused(-A_B_x_B_y, A_B_x_B_y, A_B_x_B_x * A_B_y_B_y);
        let one_over_pivot_B_x_B_y = T::from_f64(1f64) / pivot_B_x_B_y;
        let lambda_B_x = one_over_pivot_B_x_B_y
            * T::fused(-A_B_x_B_y, right_side_B_y, A_B_y_B_y * right_side_B_x);
        let lambda_B_y = one_over_pivot_B_x_B_y
            * T::fused(-A_B_x_B_y, right_side_B_x, A_B_x_B_x * right_side_B_y);
        let difference_54 = T::fused(-sin_bar_phi, lambda_B_x, cos_bar_phi * lambda_B_y);
        let k43 = c[8usize];
        let lambda_front = T::fused(right_side_front, k43, k44 * difference_54);
        let difference_61 = T::fused(
            -sin_seat_phi,
            lambda_B_x,
            cos_seat_phi * lambda_B_y,
        );
        let k38 = c[9usize];
        let lambda_rear = T::fused(right_side_rear, k38, k39 * difference_61);
        let one_over_m1 = c[10usize];
        let b_over_i1 = c[11usize];
        let a_over_i1 = c[12usize];
        let one_over_m2 = c[13usize];
        let d_over_i2 = c[14usize];
        let c_over_i2 = c[15usize];
        let k34 = c[16usize];
        let k53 = c[17usize];
        let k37 = c[18usize];
        let k54 = c[19usize];
        let k57 = c[20usize];
        delta[0usize] = T::fused(sin_seat_phi, lambda_rear, -lambda_B_x) * one_over_m1;
        delta[1usize] = -(one_over_m1 * T::fused(cos_seat_phi, lambda_rear, lambda_B_y));
        delta[2usize] = T::fused(-difference_61, b_over_i1, lambda_rear * a_over_i1);
        delta[3usize] = T::fused(sin_bar_phi, lambda_front, lambda_B_x) * one_over_m2;
        delta[4usize] = one_over_m2 * T::fused(-cos_bar_phi, lambda_front, lambda_B_y);
        delta[5usize] = -T::fused(lambda_front, c_over_i2, difference_54 * d_over_i2);
        ezy::Pivots::new()
            .see(&[2usize], T::least_ratio(k34, k53))
            .see(&[3usize], T::least_ratio(k37, k54))
            .see(&[0usize, 1usize], T::least_ratio(pivot_B_x_B_y, k57))
    }
}
