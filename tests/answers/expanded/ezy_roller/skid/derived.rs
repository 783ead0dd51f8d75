#[automatically_derived]
impl ezy::Derived for Skid {
    fn stick_slip(&self, c: &[f64], t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
        let c = ezy::array::<41usize, f64>(c);
        let q = ezy::array::<6usize, f64>(q);
        let v = ezy::array::<6usize, f64>(v);
        let out = ezy::array_mut::<2usize, f64>(out);
        let seat_omega = v[2usize];
        let c29_seat_omega = c[29usize] * seat_omega;
        let seat_vx = v[0usize];
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = f64::sin_cos(seat_phi);
        let seat_vx_sin_seat_phi = seat_vx * sin_seat_phi;
        let sum_10 = c29_seat_omega + seat_vx_sin_seat_phi;
        let seat_vy = v[1usize];
        let seat_vy_cos_seat_phi = seat_vy * cos_seat_phi;
        let difference_14 = seat_vy_cos_seat_phi - sum_10;
        out[0usize] = c[40usize];
        out[1usize] = difference_14;
    }
    fn jacobian_places(&self) -> ::core::option::Option<ezy::JacobianPlaces> {
        ::core::option::Option::Some(ezy::JacobianPlaces {
            by_q: ::std::vec![
                (0usize, 2usize), (1usize, 2usize), (2usize, 2usize), (3usize, 5usize),
                (4usize, 5usize), (5usize, 5usize), (6usize, 2usize), (6usize, 5usize),
                (7usize, 2usize), (7usize, 5usize), (8usize, 5usize), (9usize, 2usize)
            ],
            by_v: ::std::vec![
                (6usize, 2usize), (6usize, 5usize), (7usize, 2usize), (7usize, 5usize),
                (8usize, 3usize), (8usize, 4usize), (8usize, 5usize), (9usize, 0usize),
                (9usize, 1usize), (9usize, 2usize)
            ],
        })
    }
    fn jacobians(
        &self,
        c: &[f64],
        t: f64,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        lambda: &[f64],
        by_q: &mut [f64],
        by_v: &mut [f64],
    ) {
        let c = ezy::array::<41usize, f64>(c);
        let q = ezy::array::<6usize, f64>(q);
        let v = ezy::array::<6usize, f64>(v);
        let a = ezy::array::<6usize, f64>(a);
        let lambda = ezy::array::<4usize, f64>(lambda);
        let by_q = ezy::array_mut::<12usize, f64>(by_q);
        let by_v = ezy::array_mut::<10usize, f64>(by_v);
        let multiplier_3 = lambda[3usize];
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = f64::sin_cos(seat_phi);
        let product_4 = multiplier_3 * cos_seat_phi;
        let product_6 = multiplier_3 * sin_seat_phi;
        let multiplier_0 = lambda[0usize];
        let product_9 = cos_seat_phi * multiplier_0;
        let multiplier_1 = lambda[1usize];
        let product_11 = sin_seat_phi * multiplier_1;
        let sum_12 = product_9 + product_11;
        let sum_12_c11 = sum_12 * c[11usize];
        let multiplier_2 = lambda[2usize];
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = f64::sin_cos(bar_phi);
        let multiplier_2_cos_bar_phi = multiplier_2 * cos_bar_phi;
        let multiplier_2_sin_bar_phi = multiplier_2 * sin_bar_phi;
        let multiplier_0_cos_bar_phi = multiplier_0 * cos_bar_phi;
        let multiplier_1_sin_bar_phi = multiplier_1 * sin_bar_phi;
        let sum_23 = multiplier_0_cos_bar_phi + multiplier_1_sin_bar_phi;
        let sum_23_c12 = sum_23 * c[12usize];
        let seat_omega = v[2usize];
        let seat_omega_seat_omega = seat_omega * seat_omega;
        let product_28 = sin_seat_phi * seat_omega_seat_omega;
        let acceleration_2 = a[2usize];
        let product_30 = cos_seat_phi * acceleration_2;
        let difference_31 = product_30 - product_28;
        let c11_difference_31 = c[11usize] * difference_31;
        let bar_omega = v[5usize];
        let bar_omega_bar_omega = bar_omega * bar_omega;
        let product_35 = sin_bar_phi * bar_omega_bar_omega;
        let acceleration_5 = a[5usize];
        let product_37 = cos_bar_phi * acceleration_5;
        let difference_38 = product_37 - product_35;
        let c12_difference_38 = c[12usize] * difference_38;
        let product_40 = cos_seat_phi * seat_omega_seat_omega;
        let product_41 = sin_seat_phi * acceleration_2;
        let sum_42 = product_40 + product_41;
        let c11_sum_42 = c[11usize] * sum_42;
        let product_44 = cos_bar_phi * bar_omega_bar_omega;
        let product_45 = sin_bar_phi * acceleration_5;
        let sum_46 = product_44 + product_45;
        let c12_sum_46 = c[12usize] * sum_46;
        let bar_vx = v[3usize];
        let bar_omega_bar_vx = bar_omega * bar_vx;
        let acceleration_4 = a[4usize];
        let difference_51 = acceleration_4 - bar_omega_bar_vx;
        let product_52 = sin_bar_phi * difference_51;
        let bar_vy = v[4usize];
        let bar_omega_bar_vy = bar_omega * bar_vy;
        let acceleration_3 = a[3usize];
        let sum_56 = bar_omega_bar_vy + acceleration_3;
        let cos_bar_phi_sum_56 = cos_bar_phi * sum_56;
        let sum_58 = product_52 + cos_bar_phi_sum_56;
        let seat_vx = v[0usize];
        let seat_omega_seat_vx = seat_omega * seat_vx;
        let acceleration_1 = a[1usize];
        let difference_62 = acceleration_1 - seat_omega_seat_vx;
        let product_63 = sin_seat_phi * difference_62;
        let seat_vy = v[1usize];
        let seat_omega_seat_vy = seat_omega * seat_vy;
        let acceleration_0 = a[0usize];
        let sum_67 = seat_omega_seat_vy + acceleration_0;
        let cos_seat_phi_sum_67 = cos_seat_phi * sum_67;
        let sum_69 = product_63 + cos_seat_phi_sum_67;
        let seat_omega_c38 = seat_omega * c[38usize];
        let product_72 = cos_seat_phi * seat_omega_c38;
        let bar_omega_c39 = bar_omega * c[39usize];
        let product_75 = cos_bar_phi * bar_omega_c39;
        let product_76 = sin_seat_phi * seat_omega_c38;
        let product_77 = sin_bar_phi * bar_omega_c39;
        let cos_bar_phi_bar_omega = cos_bar_phi * bar_omega;
        let sin_bar_phi_bar_omega = sin_bar_phi * bar_omega;
        let cos_bar_phi_bar_vx = cos_bar_phi * bar_vx;
        let sin_bar_phi_bar_vy = sin_bar_phi * bar_vy;
        let sum_82 = cos_bar_phi_bar_vx + sin_bar_phi_bar_vy;
        let cos_seat_phi_seat_omega = cos_seat_phi * seat_omega;
        let sin_seat_phi_seat_omega = sin_seat_phi * seat_omega;
        let cos_seat_phi_seat_vx = cos_seat_phi * seat_vx;
        let sin_seat_phi_seat_vy = sin_seat_phi * seat_vy;
        let sum_87 = cos_seat_phi_seat_vx + sin_seat_phi_seat_vy;
        by_q[0usize] = product_4;
        by_q[1usize] = product_6;
        by_q[2usize] = sum_12_c11;
        by_q[3usize] = multiplier_2_cos_bar_phi;
        by_q[4usize] = multiplier_2_sin_bar_phi;
        by_q[5usize] = sum_23_c12;
        by_q[6usize] = c11_difference_31;
        by_q[7usize] = c12_difference_38;
        by_q[8usize] = c11_sum_42;
        by_q[9usize] = c12_sum_46;
        by_q[10usize] = sum_58;
        by_q[11usize] = sum_69;
        by_v[0usize] = product_72;
        by_v[1usize] = product_75;
        by_v[2usize] = product_76;
        by_v[3usize] = product_77;
        by_v[4usize] = cos_bar_phi_bar_omega;
        by_v[5usize] = sin_bar_phi_bar_omega;
        by_v[6usize] = sum_82;
        by_v[7usize] = cos_seat_phi_seat_omega;
        by_v[8usize] = sin_seat_phi_seat_omega;
        by_v[9usize] = sum_87;
    }
    fn series(&self) -> ::core::option::Option<&dyn ezy::Series<f64>> {
        ::core::option::Option::Some(self)
    }
    fn precise(&self) -> ::core::option::Option<&dyn ezy::PreciseScene> {
        ::core::option::Option::Some(self)
    }
    fn modes(&self) -> ::std::vec::Vec<::std::boxed::Box<dyn ezy::Scene>> {
        ::std::vec![
            ::std::boxed::Box::new(* self),
            ::std::boxed::Box::new(modes_of_skid::SlidesLeft { a : self.a, b : self.b, c
            : self.c, d : self.d, m1 : self.m1, i1 : self.i1, m2 : self.m2, i2 : self.i2,
            m0 : self.m0, omega : self.omega, hold : self.hold }),
            ::std::boxed::Box::new(modes_of_skid::SlidesRight { a : self.a, b : self.b, c
            : self.c, d : self.d, m1 : self.m1, i1 : self.i1, m2 : self.m2, i2 : self.i2,
            m0 : self.m0, omega : self.omega, hold : self.hold })
        ]
    }
}
