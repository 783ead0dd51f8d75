#[automatically_derived]
impl<T: ezy::Scalar> ezy::Equations<T> for self::SlidesLeft {
    fn constants(&self, parameters: &[T], c: &mut [T]) {
        let parameters = ezy::array::<11usize, T>(parameters);
        let c = ezy::array_mut::<35usize, T>(c);
        let m1 = parameters[4usize];
        let i1 = parameters[5usize];
        let m2 = parameters[6usize];
        let i2 = parameters[7usize];
        let b = parameters[1usize];
        let d = parameters[3usize];
        let parameter_c = parameters[2usize];
        let m0 = parameters[8usize];
        let omega = parameters[9usize];
        let hold = parameters[10usize];
        let parameter_a = parameters[0usize];
        let hold_a = hold * parameter_a;
        let one_over_m1 = T::from_f64(1f64) / m1;
        let hold_over_m1 = hold * one_over_m1;
        let one_over_i1 = T::from_f64(1f64) / i1;
        let b_over_i1 = b * one_over_i1;
        let one_over_m2 = T::from_f64(1f64) / m2;
        let one_over_i2 = T::from_f64(1f64) / i2;
        let d_m0 = d * m0;
        let d_m0_over_i2 = d_m0 * one_over_i2;
        let c_m0 = parameter_c * m0;
        let c_m0_over_i2 = c_m0 * one_over_i2;
        let b_squared = b * b;
        let b_squared_over_i1 = b_squared * one_over_i1;
        let d_squared = d * d;
        let d_squared_over_i2 = d_squared * one_over_i2;
        let k30 = one_over_m1 + b_squared_over_i1;
        let k31 = k30 + one_over_m2;
        let k32 = k31 + d_squared_over_i2;
        let d_c = d * parameter_c;
        let d_c_over_i2 = d_c * one_over_i2;
        let k35 = one_over_m2 - d_c_over_i2;
        let one_over_m1_plus_one_over_m2 = one_over_m1 + one_over_m2;
        let c_squared = parameter_c * parameter_c;
        let c_squared_over_i2 = c_squared * one_over_i2;
        let k39 = one_over_m2 + c_squared_over_i2;
        let k40 = T::from_f64(1f64) / k39;
        let k41 = k35 * k40;
        let k42 = k41 * k35;
        let k43 = k32 - k42;
        let k44 = k42 - d_squared_over_i2;
        let m0_over_i2 = m0 * one_over_i2;
        let d_over_i2 = d * one_over_i2;
        let c_over_i2 = parameter_c * one_over_i2;
        let k49 = T::from_f64(0.0000000001f64) * k39;
        let k50 = k32 + one_over_m1_plus_one_over_m2;
        let k51 = k50 * k50;
        let k52 = T::from_f64(0.0000000001f64) * k51;
        let b_two = b * T::from_f64(2f64);
        let d_two = d * T::from_f64(2f64);
        c[0usize] = m0;
        c[1usize] = omega;
        c[2usize] = hold_a;
        c[3usize] = c_m0_over_i2;
        c[4usize] = b_squared_over_i1;
        c[5usize] = k44;
        c[6usize] = k43;
        c[7usize] = one_over_m1_plus_one_over_m2;
        c[8usize] = hold_over_m1;
        c[9usize] = b_over_i1;
        c[10usize] = d_m0_over_i2;
        c[11usize] = k41;
        c[12usize] = b;
        c[13usize] = d;
        c[14usize] = k40;
        c[15usize] = one_over_m1;
        c[16usize] = one_over_i1;
        c[17usize] = one_over_m2;
        c[18usize] = d_over_i2;
        c[19usize] = m0_over_i2;
        c[20usize] = c_over_i2;
        c[21usize] = k39;
        c[22usize] = k49;
        c[23usize] = k52;
        c[24usize] = parameter_c;
        c[25usize] = hold;
        c[26usize] = one_over_i2;
        c[27usize] = m1;
        c[28usize] = i1;
        c[29usize] = m2;
        c[30usize] = i2;
        c[31usize] = parameter_a;
        c[32usize] = T::PI;
        c[33usize] = b_two;
        c[34usize] = d_two;
    }
    fn mass_matrix(&self, c: &[T], out: &mut [T]) {
        let c = ezy::array::<35usize, T>(c);
        let out = ezy::array_mut::<6usize, T>(out);
        let m1 = c[27usize];
        let i1 = c[28usize];
        let m2 = c[29usize];
        let i2 = c[30usize];
        out[0usize] = m1;
        out[1usize] = m1;
        out[2usize] = i1;
        out[3usize] = m2;
        out[4usize] = m2;
        out[5usize] = i2;
    }
    fn position_constraint(&self, c: &[T], t: T, q: &[T], out: &mut [T]) {
        let c = ezy::array::<35usize, T>(c);
        let q = ezy::array::<6usize, T>(q);
        let out = ezy::array_mut::<2usize, T>(out);
        let seat_x = q[0usize];
        let b = c[12usize];
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
        let bar_x = q[3usize];
        let d = c[13usize];
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
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
    fn velocity_constraint(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
        let c = ezy::array::<35usize, T>(c);
        let q = ezy::array::<6usize, T>(q);
        let v = ezy::array::<6usize, T>(v);
        let out = ezy::array_mut::<3usize, T>(out);
        let seat_vx = v[0usize];
        let bar_vx = v[3usize];
        let d = c[13usize];
        let bar_omega = v[5usize];
        let d_bar_omega = d * bar_omega;
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
        let b = c[12usize];
        let seat_omega = v[2usize];
        let b_seat_omega = b * seat_omega;
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
        let seat_vy = v[1usize];
        let bar_vy = v[4usize];
        let parameter_c = c[24usize];
        out[0usize] = T::fused(
            -b_seat_omega,
            sin_seat_phi,
            T::fused(-d_bar_omega, sin_bar_phi, seat_vx - bar_vx),
        );
        out[1usize] = T::fused(
            b_seat_omega,
            cos_seat_phi,
            T::fused(d_bar_omega, cos_bar_phi, seat_vy - bar_vy),
        );
        out[2usize] = T::fused(
            bar_vy,
            cos_bar_phi,
            T::fused(-bar_vx, sin_bar_phi, bar_omega * parameter_c),
        );
    }
    fn velocity_jacobian(&self, c: &[T], t: T, q: &[T], out: &mut [T]) {
        let c = ezy::array::<35usize, T>(c);
        let q = ezy::array::<6usize, T>(q);
        let out = ezy::array_mut::<11usize, T>(out);
        let b = c[12usize];
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
        let d = c[13usize];
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
        let parameter_c = c[24usize];
        out[0usize] = T::from_f64(1f64);
        out[1usize] = -(b * sin_seat_phi);
        out[2usize] = -T::from_f64(1f64);
        out[3usize] = -(d * sin_bar_phi);
        out[4usize] = T::from_f64(1f64);
        out[5usize] = b * cos_seat_phi;
        out[6usize] = -T::from_f64(1f64);
        out[7usize] = d * cos_bar_phi;
        out[8usize] = -sin_bar_phi;
        out[9usize] = cos_bar_phi;
        out[10usize] = parameter_c;
    }
    fn convective_term(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
        let c = ezy::array::<35usize, T>(c);
        let q = ezy::array::<6usize, T>(q);
        let v = ezy::array::<6usize, T>(v);
        let out = ezy::array_mut::<3usize, T>(out);
        let b = c[12usize];
        let seat_omega = v[2usize];
        let seat_omega_b_seat_omega = seat_omega * (b * seat_omega);
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
        let d = c[13usize];
        let bar_omega = v[5usize];
        let bar_omega_d_bar_omega = bar_omega * (d * bar_omega);
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
        let bar_vx = v[3usize];
        let bar_vy = v[4usize];
        let product_27 = bar_omega * T::fused(sin_bar_phi, bar_vy, cos_bar_phi * bar_vx);
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
    }
    fn applied_force(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
        let c = ezy::array::<35usize, T>(c);
        let q = ezy::array::<6usize, T>(q);
        let v = ezy::array::<6usize, T>(v);
        let out = ezy::array_mut::<6usize, T>(out);
        let hold = c[25usize];
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
        let m0 = c[0usize];
        let omega = c[1usize];
        let cos_omega_t = T::cos(omega * t);
        let m0_cos_omega_t = m0 * cos_omega_t;
        let hold_a = c[2usize];
        out[0usize] = hold * sin_seat_phi;
        out[1usize] = -(hold * cos_seat_phi);
        out[2usize] = m0_cos_omega_t + hold_a;
        out[3usize] = T::from_f64(0f64);
        out[4usize] = T::from_f64(0f64);
        out[5usize] = -m0_cos_omega_t;
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
        let m0 = c[0usize];
        let omega = c[1usize];
        let cos_omega_t = T::cos(omega * t);
        let hold_a = c[2usize];
        let force_seat_phi = T::fused(m0, cos_omega_t, hold_a);
        let bar_vx = v[3usize];
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
        let bar_vy = v[4usize];
        let bar_omega = v[5usize];
        let product_19 = T::fused(bar_vy, sin_bar_phi, bar_vx * cos_bar_phi) * bar_omega;
        let c_m0_over_i2 = c[3usize];
        let minus_right_side_front = T::fused(cos_omega_t, c_m0_over_i2, product_19);
        let b_squared_over_i1 = c[4usize];
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
        let k44 = c[5usize];
        let difference_31 = T::fused(
            -cos_seat_phi,
            b_squared_over_i1 * cos_seat_phi,
            cos_bar_phi * (cos_bar_phi * k44),
        );
        let k43 = c[6usize];
        let A_B_x_B_x = difference_31 + k43;
        let A_B_x_B_y = T::fused(
            -cos_seat_phi,
            b_squared_over_i1 * sin_seat_phi,
            cos_bar_phi * (sin_bar_phi * k44),
        );
        let one_over_m1_plus_one_over_m2 = c[7usize];
        let A_B_y_B_y = one_over_m1_plus_one_over_m2 - difference_31;
        let hold_over_m1 = c[8usize];
        let b_over_i1 = c[9usize];
        let difference_45 = T::fused(-force_seat_phi, b_over_i1, hold_over_m1);
        let d_m0_over_i2 = c[10usize];
        let k41 = c[11usize];
        let sum_51 = T::fused(minus_right_side_front, k41, cos_omega_t * d_m0_over_i2);
        let b = c[12usize];
        let seat_omega = v[2usize];
        let seat_omega_b_seat_omega = seat_omega * (b * seat_omega);
        let difference_59 = T::fused(
            -cos_seat_phi,
            seat_omega_b_seat_omega,
            T::fused(sin_bar_phi, sum_51, sin_seat_phi * difference_45),
        );
        let d = c[13usize];
        let bar_omega_bar_omega_d = bar_omega * (bar_omega * d);
        let right_side_B_x = T::fused(
            -cos_bar_phi,
            bar_omega_bar_omega_d,
            difference_59,
        );
        let sum_69 = T::fused(
            sin_seat_phi,
            seat_omega_b_seat_omega,
            T::fused(cos_bar_phi, sum_51, cos_seat_phi * difference_45),
        );
        let minus_right_side_B_y = T::fused(sin_bar_phi, bar_omega_bar_omega_d, sum_69);
        let pivot_B_x_B_y = T::fused(-A_B_x_B_y, A_B_x_B_y, A_B_x_B_x * A_B_y_B_y);
        let one_over_pivot_B_x_B_y = T::from_f64(1f64) / pivot_B_x_B_y;
        let lambda_B_x = one_over_pivot_B_x_B_y
            * T::fused(A_B_x_B_y, minus_right_side_B_y, A_B_y_B_y * right_side_B_x);
        let minus_lambda_B_y = one_over_pivot_B_x_B_y
            * T::fused(A_B_x_B_x, minus_right_side_B_y, A_B_x_B_y * right_side_B_x);
        let sum_86 = T::fused(cos_bar_phi, minus_lambda_B_y, sin_bar_phi * lambda_B_x);
        let k40 = c[14usize];
        let minus_lambda_front = T::fused(minus_right_side_front, k40, k41 * sum_86);
        let one_over_m1 = c[15usize];
        let product_101 = b_over_i1
            * T::fused(cos_seat_phi, minus_lambda_B_y, sin_seat_phi * lambda_B_x);
        let one_over_i1 = c[16usize];
        let one_over_m2 = c[17usize];
        let d_over_i2 = c[18usize];
        let m0_over_i2 = c[19usize];
        let c_over_i2 = c[20usize];
        let k39 = c[21usize];
        let k49 = c[22usize];
        let k52 = c[23usize];
        a[0usize] = T::fused(-lambda_B_x, one_over_m1, sin_seat_phi * hold_over_m1);
        a[1usize] = T::fused(
            -cos_seat_phi,
            hold_over_m1,
            minus_lambda_B_y * one_over_m1,
        );
        a[2usize] = T::fused(force_seat_phi, one_over_i1, product_101);
        a[3usize] = T::fused(-sin_bar_phi, minus_lambda_front, lambda_B_x) * one_over_m2;
        a[4usize] = one_over_m2
            * T::fused(cos_bar_phi, minus_lambda_front, -minus_lambda_B_y);
        a[5usize] = T::fused(
            minus_lambda_front,
            c_over_i2,
            T::fused(-cos_omega_t, m0_over_i2, sum_86 * d_over_i2),
        );
        lambda[0usize] = lambda_B_x;
        lambda[1usize] = -minus_lambda_B_y;
        lambda[2usize] = -minus_lambda_front;
        ezy::Pivots::new()
            .see(&[2usize], T::least_ratio(k39, k49))
            .see(&[0usize, 1usize], T::least_ratio(pivot_B_x_B_y, k52))
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
        let b_squared_over_i1 = c[4usize];
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
        let k44 = c[5usize];
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
        let difference_13 = T::fused(
            -cos_seat_phi,
            b_squared_over_i1 * cos_seat_phi,
            cos_bar_phi * (k44 * cos_bar_phi),
        );
        let k43 = c[6usize];
        let A_B_x_B_x = difference_13 + k43;
        let A_B_x_B_y = T::fused(
            -cos_seat_phi,
            b_squared_over_i1 * sin_seat_phi,
            cos_bar_phi * (k44 * sin_bar_phi),
        );
        let one_over_m1_plus_one_over_m2 = c[7usize];
        let A_B_y_B_y = one_over_m1_plus_one_over_m2 - difference_13;
        let residual_0 = residual[0usize];
        let k41 = c[11usize];
        let right_side_front_k41 = right_side_front * k41;
        let right_side_B_x = T::fused(-sin_bar_phi, right_side_front_k41, residual_0);
        let residual_1 = residual[1usize];
        let right_side_B_y = T::fused(cos_bar_phi, right_side_front_k41, residual_1);
        let pivot_B_x_B_y = T::fused(-A_B_x_B_y, A_B_x_B_y, A_B_x_B_x * A_B_y_B_y);
        let one_over_pivot_B_x_B_y = T::from_f64(1f64) / pivot_B_x_B_y;
        let lambda_B_x = one_over_pivot_B_x_B_y
            * T::fused(-A_B_x_B_y, right_side_B_y, A_B_y_B_y * right_side_B_x);
        let lambda_B_y = one_over_pivot_B_x_B_y
            * T::fused(-A_B_x_B_y, right_side_B_x, A_B_x_B_x * right_side_B_y);
        let difference_47 = T::fused(-sin_bar_phi, lambda_B_x, cos_bar_phi * lambda_B_y);
        let k40 = c[14usize];
        let lambda_front = T::fused(right_side_front, k40, k41 * difference_47);
        let one_over_m1 = c[15usize];
        let b_over_i1 = c[9usize];
        let one_over_m2 = c[17usize];
        let d_over_i2 = c[18usize];
        let c_over_i2 = c[20usize];
        let k39 = c[21usize];
        let k49 = c[22usize];
        let k52 = c[23usize];
        delta[0usize] = -(lambda_B_x * one_over_m1);
        delta[1usize] = -(lambda_B_y * one_over_m1);
        delta[2usize] = T::fused(-cos_seat_phi, lambda_B_y, sin_seat_phi * lambda_B_x)
            * b_over_i1;
        delta[3usize] = T::fused(sin_bar_phi, lambda_front, lambda_B_x) * one_over_m2;
        delta[4usize] = one_over_m2 * T::fused(-cos_bar_phi, lambda_front, lambda_B_y);
        delta[5usize] = -T::fused(lambda_front, c_over_i2, difference_47 * d_over_i2);
        ezy::Pivots::new()
            .see(&[2usize], T::least_ratio(k39, k49))
            .see(&[0usize, 1usize], T::least_ratio(pivot_B_x_B_y, k52))
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
        let d = c[13usize];
        let bar_omega = v[5usize];
        let d_bar_omega = d * bar_omega;
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = T::sin_cos(bar_phi);
        let b = c[12usize];
        let seat_omega = v[2usize];
        let b_seat_omega = b * seat_omega;
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
        let difference_18 = T::fused(
            -b_seat_omega,
            sin_seat_phi,
            T::fused(-d_bar_omega, sin_bar_phi, seat_vx - bar_vx),
        );
        let seat_vy = v[1usize];
        let bar_vy = v[4usize];
        let sum_27 = T::fused(
            b_seat_omega,
            cos_seat_phi,
            T::fused(d_bar_omega, cos_bar_phi, seat_vy - bar_vy),
        );
        let parameter_c = c[24usize];
        let projection_right_side_front = T::fused(
            bar_vy,
            cos_bar_phi,
            T::fused(-bar_vx, sin_bar_phi, bar_omega * parameter_c),
        );
        let b_squared_over_i1 = c[4usize];
        let k44 = c[5usize];
        let difference_40 = T::fused(
            -cos_seat_phi,
            cos_seat_phi * b_squared_over_i1,
            cos_bar_phi * (cos_bar_phi * k44),
        );
        let k43 = c[6usize];
        let A_B_x_B_x = difference_40 + k43;
        let A_B_x_B_y = T::fused(
            -cos_seat_phi,
            sin_seat_phi * b_squared_over_i1,
            cos_bar_phi * (sin_bar_phi * k44),
        );
        let one_over_m1_plus_one_over_m2 = c[7usize];
        let A_B_y_B_y = one_over_m1_plus_one_over_m2 - difference_40;
        let k41 = c[11usize];
        let product_51 = projection_right_side_front * k41;
        let right_side_B_x = T::fused(-sin_bar_phi, product_51, difference_18);
        let right_side_B_y = T::fused(cos_bar_phi, product_51, sum_27);
        let pivot_B_x_B_y = T::fused(-A_B_x_B_y, A_B_x_B_y, A_B_x_B_x * A_B_y_B_y);
        let one_over_pivot_B_x_B_y = T::from_f64(1f64) / pivot_B_x_B_y;
        let projection_lambda_B_x = one_over_pivot_B_x_B_y
            * T::fused(-A_B_x_B_y, right_side_B_y, A_B_y_B_y * right_side_B_x);
        let projection_lambda_B_y = one_over_pivot_B_x_B_y
            * T::fused(-A_B_x_B_y, right_side_B_x, A_B_x_B_x * right_side_B_y);
        let difference_70 = T::fused(
            -sin_bar_phi,
            projection_lambda_B_x,
            cos_bar_phi * projection_lambda_B_y,
        );
        let k40 = c[14usize];
        let projection_lambda_front = T::fused(
            projection_right_side_front,
            k40,
            k41 * difference_70,
        );
        let one_over_m1 = c[15usize];
        let b_over_i1 = c[9usize];
        let one_over_m2 = c[17usize];
        let d_over_i2 = c[18usize];
        let c_over_i2 = c[20usize];
        let k39 = c[21usize];
        let k49 = c[22usize];
        let k52 = c[23usize];
        let projected_seat_vx = T::fused(-projection_lambda_B_x, one_over_m1, seat_vx);
        let projected_seat_vy = T::fused(-projection_lambda_B_y, one_over_m1, seat_vy);
        let projected_seat_omega = T::fused(
            T::fused(
                -cos_seat_phi,
                projection_lambda_B_y,
                sin_seat_phi * projection_lambda_B_x,
            ),
            b_over_i1,
            seat_omega,
        );
        let projected_bar_vx = T::fused(
            T::fused(sin_bar_phi, projection_lambda_front, projection_lambda_B_x),
            one_over_m2,
            bar_vx,
        );
        let projected_bar_vy = T::fused(
            one_over_m2,
            T::fused(-cos_bar_phi, projection_lambda_front, projection_lambda_B_y),
            bar_vy,
        );
        let projected_bar_omega = bar_omega
            - T::fused(projection_lambda_front, c_over_i2, difference_70 * d_over_i2);
        let m0 = c[0usize];
        let omega = c[1usize];
        let cos_omega_t = T::cos(omega * t);
        let hold_a = c[2usize];
        let force_seat_phi = T::fused(m0, cos_omega_t, hold_a);
        let product_115 = projected_bar_omega
            * T::fused(sin_bar_phi, projected_bar_vy, cos_bar_phi * projected_bar_vx);
        let c_m0_over_i2 = c[3usize];
        let minus_right_side_front = T::fused(cos_omega_t, c_m0_over_i2, product_115);
        let hold_over_m1 = c[8usize];
        let difference_121 = T::fused(-b_over_i1, force_seat_phi, hold_over_m1);
        let d_m0_over_i2 = c[10usize];
        let sum_126 = T::fused(k41, minus_right_side_front, cos_omega_t * d_m0_over_i2);
        let product_130 = projected_seat_omega * (b * projected_seat_omega);
        let difference_132 = T::fused(
            -cos_seat_phi,
            product_130,
            T::fused(sin_bar_phi, sum_126, sin_seat_phi * difference_121),
        );
        let product_134 = projected_bar_omega * (d * projected_bar_omega);
        let right_side_B_x_ = T::fused(-cos_bar_phi, product_134, difference_132);
        let sum_141 = T::fused(
            sin_seat_phi,
            product_130,
            T::fused(cos_bar_phi, sum_126, cos_seat_phi * difference_121),
        );
        let minus_right_side_B_y = T::fused(sin_bar_phi, product_134, sum_141);
        let lambda_B_x = one_over_pivot_B_x_B_y
            * T::fused(A_B_x_B_y, minus_right_side_B_y, A_B_y_B_y * right_side_B_x_);
        let minus_lambda_B_y = one_over_pivot_B_x_B_y
            * T::fused(A_B_x_B_x, minus_right_side_B_y, A_B_x_B_y * right_side_B_x_);
        let sum_154 = T::fused(cos_bar_phi, minus_lambda_B_y, sin_bar_phi * lambda_B_x);
        let minus_lambda_front = T::fused(k40, minus_right_side_front, k41 * sum_154);
        let product_167 = b_over_i1
            * T::fused(cos_seat_phi, minus_lambda_B_y, sin_seat_phi * lambda_B_x);
        let one_over_i1 = c[16usize];
        let m0_over_i2 = c[19usize];
        out[0usize] = difference_18;
        out[1usize] = sum_27;
        out[2usize] = projection_right_side_front;
        out[3usize] = projected_seat_vx;
        out[4usize] = projected_seat_vy;
        out[5usize] = projected_seat_omega;
        out[6usize] = projected_bar_vx;
        out[7usize] = projected_bar_vy;
        out[8usize] = projected_bar_omega;
        out[9usize] = T::fused(-one_over_m1, lambda_B_x, sin_seat_phi * hold_over_m1);
        out[10usize] = T::fused(
            -cos_seat_phi,
            hold_over_m1,
            one_over_m1 * minus_lambda_B_y,
        );
        out[11usize] = T::fused(force_seat_phi, one_over_i1, product_167);
        out[12usize] = one_over_m2
            * T::fused(-sin_bar_phi, minus_lambda_front, lambda_B_x);
        out[13usize] = one_over_m2
            * T::fused(cos_bar_phi, minus_lambda_front, -minus_lambda_B_y);
        out[14usize] = T::fused(
            c_over_i2,
            minus_lambda_front,
            T::fused(-cos_omega_t, m0_over_i2, d_over_i2 * sum_154),
        );
        out[15usize] = lambda_B_x;
        out[16usize] = -minus_lambda_B_y;
        out[17usize] = -minus_lambda_front;
        ezy::Pivots::new()
            .see(&[2usize], T::least_ratio(k39, k49))
            .see(&[0usize, 1usize], T::least_ratio(pivot_B_x_B_y, k52))
    }
}
