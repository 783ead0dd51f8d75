#[automatically_derived]
impl<T: ezy::Scalar> ezy::QuasiVelocities<T> for Coast {
    #[inline(always)]
    fn quasi_velocities(&self, c: &[T], q: &[T], v: &[T], quasi: &mut [T]) {
        let c = ezy::array::<46usize, T>(c);
        let q = ezy::array::<6usize, T>(q);
        let v = ezy::array::<6usize, T>(v);
        let quasi = ezy::array_mut::<2usize, T>(quasi);
        let seat_vx = v[0usize];
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = T::sin_cos(seat_phi);
        let seat_vy = v[1usize];
        let seat_omega = v[2usize];
        quasi[0usize] = T::fused(seat_vy, sin_seat_phi, seat_vx * cos_seat_phi);
        quasi[1usize] = seat_omega;
    }
    #[inline(always)]
    fn velocities(&self, c: &[T], t: T, q: &[T], quasi: &[T], v: &mut [T]) {
        let c = ezy::array::<46usize, T>(c);
        let q = ezy::array::<6usize, T>(q);
        let quasi = ezy::array::<2usize, T>(quasi);
        let v = ezy::array_mut::<6usize, T>(v);
        let seat_phi = q[2usize];
        let bar_phi = q[5usize];
        let [(sin_seat_phi, cos_seat_phi), (sin_bar_phi, cos_bar_phi)] = T::sin_cos_of([
            seat_phi,
            bar_phi,
        ]);
        let difference_10 = T::fused(
            -sin_seat_phi,
            cos_bar_phi,
            cos_seat_phi * sin_bar_phi,
        );
        let sum_11 = T::fused(sin_seat_phi, sin_bar_phi, cos_seat_phi * cos_bar_phi);
        let parameter_a = c[21usize];
        let seat_omega = quasi[1usize];
        let seat_across = parameter_a * seat_omega;
        let b = c[4usize];
        let seat_along = quasi[0usize];
        let bar_along = T::fused(
            sum_11,
            seat_along,
            difference_10 * T::fused(seat_omega, b, seat_across),
        );
        let difference_27 = T::fused(-difference_10, seat_along, sum_11 * seat_across);
        let k64 = c[32usize];
        let k66 = c[33usize];
        let bar_across = T::fused(-sum_11, seat_omega * k66, difference_27 * k64);
        let k61 = c[34usize];
        let k62 = c[35usize];
        let minus_bar_omega = T::fused(sum_11, seat_omega * k62, difference_27 * k61);
        v[0usize] = T::fused(-sin_seat_phi, seat_across, cos_seat_phi * seat_along);
        v[1usize] = T::fused(sin_seat_phi, seat_along, cos_seat_phi * seat_across);
        v[2usize] = seat_omega;
        v[3usize] = T::fused(-sin_bar_phi, bar_across, cos_bar_phi * bar_along);
        v[4usize] = T::fused(sin_bar_phi, bar_along, cos_bar_phi * bar_across);
        v[5usize] = -minus_bar_omega;
    }
    #[inline(always)]
    fn values_of_time(&self, c: &[T], t: T, of_time: &mut [T]) {
        let c = ezy::array::<46usize, T>(c);
        let of_time = ezy::array_mut::<0usize, T>(of_time);
    }
    #[inline(always)]
    fn quasi_accelerations(
        &self,
        c: &[T],
        t: T,
        q: &[T],
        quasi: &[T],
        of_time: &[T],
        a: &mut [T],
        q_rate: &mut [T],
        sines: &mut [T],
    ) {
        let c = ezy::array::<46usize, T>(c);
        let q = ezy::array::<6usize, T>(q);
        let quasi = ezy::array::<2usize, T>(quasi);
        let of_time = ezy::array::<0usize, T>(of_time);
        let a = ezy::array_mut::<2usize, T>(a);
        let q_rate = ezy::array_mut::<1usize, T>(q_rate);
        let sines = ezy::array_mut::<2usize, T>(sines);
        let seat_phi = q[2usize];
        let bar_phi = q[5usize];
        let relative_bar_phi = bar_phi - seat_phi;
        let parameter_a = c[21usize];
        let seat_omega = quasi[1usize];
        let seat_across = parameter_a * seat_omega;
        let b = c[4usize];
        let sum_9 = T::fused(seat_omega, b, seat_across);
        let (sin_relative_bar_phi, cos_relative_bar_phi) = T::sin_cos(relative_bar_phi);
        let seat_along = quasi[0usize];
        let product_14 = seat_along * cos_relative_bar_phi;
        let bar_along = T::fused(sum_9, sin_relative_bar_phi, product_14);
        let product_16 = sin_relative_bar_phi * seat_along;
        let difference_18 = T::fused(seat_across, cos_relative_bar_phi, -product_16);
        let k64 = c[32usize];
        let k66 = c[33usize];
        let seat_omega_k66 = seat_omega * k66;
        let bar_across = T::fused(
            -cos_relative_bar_phi,
            seat_omega_k66,
            difference_18 * k64,
        );
        let k61 = c[34usize];
        let k62 = c[35usize];
        let seat_omega_k62 = seat_omega * k62;
        let minus_bar_omega = T::fused(
            cos_relative_bar_phi,
            seat_omega_k62,
            difference_18 * k61,
        );
        let minus_rate_of_relative_bar_phi = seat_omega + minus_bar_omega;
        let minus_drift_bar_along = minus_rate_of_relative_bar_phi
            * T::fused(sum_9, cos_relative_bar_phi, -product_16);
        let sum_36 = T::fused(seat_across, sin_relative_bar_phi, product_14);
        let minus_drift_bar_across = minus_rate_of_relative_bar_phi
            * T::fused(-k64, sum_36, sin_relative_bar_phi * seat_omega_k66);
        let minus_drift_bar_omega = minus_rate_of_relative_bar_phi
            * T::fused(sin_relative_bar_phi, seat_omega_k62, k61 * sum_36);
        let m2 = c[27usize];
        let force_bar_along = T::fused(
            -bar_across,
            minus_bar_omega,
            minus_drift_bar_along,
        ) * m2;
        let force_bar_across = m2
            * T::fused(bar_along, minus_bar_omega, minus_drift_bar_across);
        let k79 = c[36usize];
        let k77 = c[37usize];
        let k87 = c[38usize];
        let product_59 = cos_relative_bar_phi * (sin_relative_bar_phi * k87);
        let k98 = c[39usize];
        let k96 = c[40usize];
        let k80 = c[41usize];
        let product_69 = sin_relative_bar_phi
            * T::fused(-k64, force_bar_across, minus_drift_bar_omega * k80);
        let m1 = c[25usize];
        let sum_75 = T::fused(
            cos_relative_bar_phi,
            force_bar_along,
            T::fused(seat_omega, seat_across * m1, product_69),
        );
        let k69 = c[42usize];
        let k100 = c[43usize];
        let product_81 = cos_relative_bar_phi
            * T::fused(minus_drift_bar_omega, k100, force_bar_across * k69);
        let a_m1 = c[44usize];
        let a_plus_b = c[45usize];
        let sum_89 = T::fused(
            sin_relative_bar_phi,
            force_bar_along * a_plus_b,
            T::fused(-seat_omega, seat_along * a_m1, product_81),
        );
        let quotient_90 = T::from_f64(1f64)
            / T::fused(cos_relative_bar_phi, cos_relative_bar_phi * k79, k77);
        let product_92 = product_59 * quotient_90;
        let difference_96 = T::fused(
            -product_59,
            product_92,
            T::fused(cos_relative_bar_phi, cos_relative_bar_phi * k98, k96),
        );
        let product_98 = T::fused(-sum_75, product_92, sum_89)
            * (T::from_f64(1f64) / difference_96);
        a[0usize] = T::fused(-product_92, product_98, sum_75 * quotient_90);
        a[1usize] = product_98;
        q_rate[0usize] = -minus_bar_omega;
        sines[0usize] = sin_relative_bar_phi;
        sines[1usize] = cos_relative_bar_phi;
    }
    #[inline(always)]
    fn rates(
        &self,
        c: &[T],
        t: T,
        q: &[T],
        quasi: &[T],
        of_time: &[T],
        sines: &[T],
        q_rate: &mut [T],
    ) {
        let c = ezy::array::<46usize, T>(c);
        let q = ezy::array::<6usize, T>(q);
        let quasi = ezy::array::<2usize, T>(quasi);
        let of_time = ezy::array::<0usize, T>(of_time);
        let sines = ezy::array::<2usize, T>(sines);
        let q_rate = ezy::array_mut::<1usize, T>(q_rate);
        let parameter_a = c[21usize];
        let seat_omega = quasi[1usize];
        let seat_across = parameter_a * seat_omega;
        let sine_1 = sines[0usize];
        let seat_along = quasi[0usize];
        let cosine_1 = sines[1usize];
        let k61 = c[34usize];
        let product_26 = T::fused(-sine_1, seat_along, seat_across * cosine_1) * k61;
        let k62 = c[35usize];
        let minus_bar_omega = T::fused(cosine_1, seat_omega * k62, product_26);
        q_rate[0usize] = -minus_bar_omega;
    }
    #[inline(always)]
    fn angles(&self, c: &[T], t: T, q: &[T], of_time: &[T], out: &mut [T]) {
        let c = ezy::array::<46usize, T>(c);
        let q = ezy::array::<6usize, T>(q);
        let of_time = ezy::array::<0usize, T>(of_time);
        let out = ezy::array_mut::<1usize, T>(out);
        let seat_phi = q[2usize];
        let bar_phi = q[5usize];
        let relative_bar_phi = bar_phi - seat_phi;
        out[0usize] = relative_bar_phi;
    }
    #[inline(always)]
    fn motion(
        &self,
        c: &[T],
        t: T,
        q: &[T],
        quasi: &[T],
        a: &mut [T],
        q_rate: &mut [T],
    ) {
        let c = ezy::array::<46usize, T>(c);
        let q = ezy::array::<6usize, T>(q);
        let quasi = ezy::array::<2usize, T>(quasi);
        let a = ezy::array_mut::<2usize, T>(a);
        let q_rate = ezy::array_mut::<4usize, T>(q_rate);
        let seat_phi = q[2usize];
        let bar_phi = q[5usize];
        let relative_bar_phi = bar_phi - seat_phi;
        let parameter_a = c[21usize];
        let seat_omega = quasi[1usize];
        let seat_across = parameter_a * seat_omega;
        let b = c[4usize];
        let sum_10 = T::fused(seat_omega, b, seat_across);
        let [(sin_relative_bar_phi, cos_relative_bar_phi), (sin_seat_phi, cos_seat_phi),
        ] = T::sin_cos_of([relative_bar_phi, seat_phi]);
        let seat_along = quasi[0usize];
        let product_15 = seat_along * cos_relative_bar_phi;
        let bar_along = T::fused(sum_10, sin_relative_bar_phi, product_15);
        let product_17 = sin_relative_bar_phi * seat_along;
        let difference_19 = T::fused(seat_across, cos_relative_bar_phi, -product_17);
        let k64 = c[32usize];
        let k66 = c[33usize];
        let seat_omega_k66 = seat_omega * k66;
        let bar_across = T::fused(
            -cos_relative_bar_phi,
            seat_omega_k66,
            difference_19 * k64,
        );
        let k61 = c[34usize];
        let k62 = c[35usize];
        let seat_omega_k62 = seat_omega * k62;
        let minus_bar_omega = T::fused(
            cos_relative_bar_phi,
            seat_omega_k62,
            difference_19 * k61,
        );
        let minus_rate_of_relative_bar_phi = seat_omega + minus_bar_omega;
        let minus_drift_bar_along = minus_rate_of_relative_bar_phi
            * T::fused(sum_10, cos_relative_bar_phi, -product_17);
        let sum_37 = T::fused(seat_across, sin_relative_bar_phi, product_15);
        let minus_drift_bar_across = minus_rate_of_relative_bar_phi
            * T::fused(-k64, sum_37, sin_relative_bar_phi * seat_omega_k66);
        let minus_drift_bar_omega = minus_rate_of_relative_bar_phi
            * T::fused(sin_relative_bar_phi, seat_omega_k62, k61 * sum_37);
        let m2 = c[27usize];
        let force_bar_along = T::fused(
            -bar_across,
            minus_bar_omega,
            minus_drift_bar_along,
        ) * m2;
        let force_bar_across = m2
            * T::fused(bar_along, minus_bar_omega, minus_drift_bar_across);
        let k79 = c[36usize];
        let k77 = c[37usize];
        let k87 = c[38usize];
        let product_60 = cos_relative_bar_phi * (sin_relative_bar_phi * k87);
        let k98 = c[39usize];
        let k96 = c[40usize];
        let k80 = c[41usize];
        let product_70 = sin_relative_bar_phi
            * T::fused(-k64, force_bar_across, minus_drift_bar_omega * k80);
        let m1 = c[25usize];
        let sum_76 = T::fused(
            cos_relative_bar_phi,
            force_bar_along,
            T::fused(seat_omega, seat_across * m1, product_70),
        );
        let k69 = c[42usize];
        let k100 = c[43usize];
        let product_82 = cos_relative_bar_phi
            * T::fused(minus_drift_bar_omega, k100, force_bar_across * k69);
        let a_m1 = c[44usize];
        let a_plus_b = c[45usize];
        let sum_90 = T::fused(
            sin_relative_bar_phi,
            force_bar_along * a_plus_b,
            T::fused(-seat_omega, seat_along * a_m1, product_82),
        );
        let quotient_91 = T::from_f64(1f64)
            / T::fused(cos_relative_bar_phi, cos_relative_bar_phi * k79, k77);
        let product_93 = product_60 * quotient_91;
        let difference_97 = T::fused(
            -product_60,
            product_93,
            T::fused(cos_relative_bar_phi, cos_relative_bar_phi * k98, k96),
        );
        let product_99 = T::fused(-sum_76, product_93, sum_90)
            * (T::from_f64(1f64) / difference_97);
        a[0usize] = T::fused(-product_93, product_99, sum_76 * quotient_91);
        a[1usize] = product_99;
        q_rate[0usize] = seat_omega;
        q_rate[1usize] = -minus_bar_omega;
        q_rate[2usize] = T::fused(-seat_across, sin_seat_phi, seat_along * cos_seat_phi);
        q_rate[3usize] = T::fused(seat_along, sin_seat_phi, seat_across * cos_seat_phi);
    }
    #[inline(always)]
    fn whole_state(
        &self,
        c: &[T],
        t: T,
        q: &[T],
        quasi: &[T],
        out: &mut [T],
        v: &mut [T],
    ) {
        let c = ezy::array::<46usize, T>(c);
        let q = ezy::array::<6usize, T>(q);
        let quasi = ezy::array::<2usize, T>(quasi);
        let out = ezy::array_mut::<6usize, T>(out);
        let v = ezy::array_mut::<6usize, T>(v);
        let seat_y = q[1usize];
        let b = c[4usize];
        let seat_phi = q[2usize];
        let bar_phi = q[5usize];
        let [(sin_seat_phi, cos_seat_phi), (sin_bar_phi, cos_bar_phi)] = T::sin_cos_of([
            seat_phi,
            bar_phi,
        ]);
        let d = c[5usize];
        let seat_x = q[0usize];
        let difference_24 = T::fused(
            -sin_seat_phi,
            cos_bar_phi,
            sin_bar_phi * cos_seat_phi,
        );
        let sum_25 = T::fused(sin_seat_phi, sin_bar_phi, cos_seat_phi * cos_bar_phi);
        let parameter_a = c[21usize];
        let seat_omega = quasi[1usize];
        let seat_across = parameter_a * seat_omega;
        let seat_along = quasi[0usize];
        let bar_along = T::fused(
            sum_25,
            seat_along,
            difference_24 * T::fused(b, seat_omega, seat_across),
        );
        let difference_38 = T::fused(-difference_24, seat_along, sum_25 * seat_across);
        let k64 = c[32usize];
        let k66 = c[33usize];
        let bar_across = T::fused(-sum_25, seat_omega * k66, difference_38 * k64);
        let k61 = c[34usize];
        let k62 = c[35usize];
        let minus_bar_omega = T::fused(sum_25, seat_omega * k62, difference_38 * k61);
        out[0usize] = seat_x;
        out[1usize] = seat_y;
        out[2usize] = seat_phi;
        out[3usize] = T::fused(d, cos_bar_phi, T::fused(b, cos_seat_phi, seat_x));
        out[4usize] = T::fused(d, sin_bar_phi, T::fused(b, sin_seat_phi, seat_y));
        out[5usize] = bar_phi;
        v[0usize] = T::fused(-sin_seat_phi, seat_across, cos_seat_phi * seat_along);
        v[1usize] = T::fused(sin_seat_phi, seat_along, cos_seat_phi * seat_across);
        v[2usize] = seat_omega;
        v[3usize] = T::fused(-sin_bar_phi, bar_across, cos_bar_phi * bar_along);
        v[4usize] = T::fused(sin_bar_phi, bar_along, cos_bar_phi * bar_across);
        v[5usize] = -minus_bar_omega;
    }
}
