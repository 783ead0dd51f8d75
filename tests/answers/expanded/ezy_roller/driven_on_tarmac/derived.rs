#[automatically_derived]
impl ezy::Derived for DrivenOnTarmac {
    fn slope_places(&self) -> ::core::option::Option<ezy::SlopePlaces> {
        ::core::option::Option::Some(ezy::SlopePlaces {
            by_q: ::std::vec![
                (0usize, 2usize), (1usize, 2usize), (2usize, 2usize), (3usize, 5usize),
                (4usize, 5usize), (5usize, 5usize), (6usize, 2usize), (6usize, 5usize),
                (7usize, 2usize), (7usize, 5usize), (8usize, 2usize), (9usize, 5usize)
            ],
            by_v: ::std::vec![
                (0usize, 0usize), (0usize, 2usize), (1usize, 1usize), (1usize, 2usize),
                (2usize, 0usize), (2usize, 1usize), (2usize, 2usize), (6usize, 2usize),
                (6usize, 5usize), (7usize, 2usize), (7usize, 5usize), (8usize, 0usize),
                (8usize, 1usize), (8usize, 2usize), (9usize, 3usize), (9usize, 4usize),
                (9usize, 5usize)
            ],
        })
    }
    fn slopes(
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
        let by_v = ezy::array_mut::<17usize, f64>(by_v);
        let seat_omega = v[2usize];
        let product_3 = c[1usize] * seat_omega;
        let multiplier_2 = lambda[2usize];
        let difference_6 = multiplier_2 - product_3;
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = f64::sin_cos(seat_phi);
        let product_9 = difference_6 * cos_seat_phi;
        let product_11 = difference_6 * sin_seat_phi;
        let multiplier_0 = lambda[0usize];
        let product_13 = cos_seat_phi * multiplier_0;
        let multiplier_1 = lambda[1usize];
        let product_15 = sin_seat_phi * multiplier_1;
        let sum_16 = product_13 + product_15;
        let product_18 = sum_16 * c[16usize];
        let seat_vx = v[0usize];
        let product_20 = cos_seat_phi * seat_vx;
        let seat_vy = v[1usize];
        let product_22 = sin_seat_phi * seat_vy;
        let sum_23 = product_20 + product_22;
        let product_24 = c[1usize] * sum_23;
        let difference_25 = product_18 - product_24;
        let multiplier_3 = lambda[3usize];
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = f64::sin_cos(bar_phi);
        let product_29 = multiplier_3 * cos_bar_phi;
        let product_31 = multiplier_3 * sin_bar_phi;
        let product_32 = multiplier_0 * cos_bar_phi;
        let product_33 = multiplier_1 * sin_bar_phi;
        let sum_34 = product_32 + product_33;
        let product_36 = sum_34 * c[17usize];
        let product_37 = seat_omega * seat_omega;
        let product_38 = sin_seat_phi * product_37;
        let acceleration_2 = a[2usize];
        let product_40 = cos_seat_phi * acceleration_2;
        let difference_41 = product_40 - product_38;
        let product_42 = c[16usize] * difference_41;
        let bar_omega = v[5usize];
        let product_44 = bar_omega * bar_omega;
        let product_45 = sin_bar_phi * product_44;
        let acceleration_5 = a[5usize];
        let product_47 = cos_bar_phi * acceleration_5;
        let difference_48 = product_47 - product_45;
        let product_49 = c[17usize] * difference_48;
        let product_50 = cos_seat_phi * product_37;
        let product_51 = sin_seat_phi * acceleration_2;
        let sum_52 = product_50 + product_51;
        let product_53 = c[16usize] * sum_52;
        let product_54 = cos_bar_phi * product_44;
        let product_55 = sin_bar_phi * acceleration_5;
        let sum_56 = product_54 + product_55;
        let product_57 = c[17usize] * sum_56;
        let product_58 = seat_omega * seat_vx;
        let acceleration_1 = a[1usize];
        let difference_60 = acceleration_1 - product_58;
        let product_61 = sin_seat_phi * difference_60;
        let product_62 = seat_omega * seat_vy;
        let acceleration_0 = a[0usize];
        let sum_64 = product_62 + acceleration_0;
        let product_65 = cos_seat_phi * sum_64;
        let sum_66 = product_61 + product_65;
        let bar_vx = v[3usize];
        let product_68 = bar_omega * bar_vx;
        let acceleration_4 = a[4usize];
        let difference_70 = acceleration_4 - product_68;
        let product_71 = sin_bar_phi * difference_70;
        let bar_vy = v[4usize];
        let product_73 = bar_omega * bar_vy;
        let acceleration_3 = a[3usize];
        let sum_75 = product_73 + acceleration_3;
        let product_76 = cos_bar_phi * sum_75;
        let sum_77 = product_71 + product_76;
        let product_79 = c[1usize] * sin_seat_phi;
        let product_80 = c[1usize] * cos_seat_phi;
        let product_83 = seat_omega * c[39usize];
        let product_84 = cos_seat_phi * product_83;
        let product_86 = bar_omega * c[40usize];
        let product_87 = cos_bar_phi * product_86;
        let product_88 = sin_seat_phi * product_83;
        let product_89 = sin_bar_phi * product_86;
        let product_90 = seat_omega * cos_seat_phi;
        let product_91 = seat_omega * sin_seat_phi;
        let product_92 = cos_bar_phi * bar_omega;
        let product_93 = sin_bar_phi * bar_omega;
        let product_94 = cos_bar_phi * bar_vx;
        let product_95 = sin_bar_phi * bar_vy;
        let sum_96 = product_94 + product_95;
        let value_97 = -c[0usize];
        let value_98 = -product_79;
        let value_99 = -c[2usize];
        by_q[0usize] = product_9;
        by_q[1usize] = product_11;
        by_q[2usize] = difference_25;
        by_q[3usize] = product_29;
        by_q[4usize] = product_31;
        by_q[5usize] = product_36;
        by_q[6usize] = product_42;
        by_q[7usize] = product_49;
        by_q[8usize] = product_53;
        by_q[9usize] = product_57;
        by_q[10usize] = sum_66;
        by_q[11usize] = sum_77;
        by_v[0usize] = value_97;
        by_v[1usize] = value_98;
        by_v[2usize] = value_97;
        by_v[3usize] = product_80;
        by_v[4usize] = value_98;
        by_v[5usize] = product_80;
        by_v[6usize] = value_99;
        by_v[7usize] = product_84;
        by_v[8usize] = product_87;
        by_v[9usize] = product_88;
        by_v[10usize] = product_89;
        by_v[11usize] = product_90;
        by_v[12usize] = product_91;
        by_v[13usize] = sum_23;
        by_v[14usize] = product_92;
        by_v[15usize] = product_93;
        by_v[16usize] = sum_96;
    }
    fn series(&self) -> ::core::option::Option<&dyn ezy::Series<f64>> {
        ::core::option::Option::Some(self)
    }
    fn precise(&self) -> ::core::option::Option<&dyn ezy::PreciseScene> {
        ::core::option::Option::Some(self)
    }
}
