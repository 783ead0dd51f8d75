#[automatically_derived]
impl ezy::Derived for Coast {
    fn jacobian_places(&self) -> ::core::option::Option<ezy::JacobianPlaces> {
        ::core::option::Option::Some(ezy::JacobianPlaces {
            by_q: ::std::vec![
                (0usize, 2usize), (1usize, 2usize), (2usize, 2usize), (3usize, 5usize),
                (4usize, 5usize), (5usize, 5usize), (6usize, 2usize), (6usize, 5usize),
                (7usize, 2usize), (7usize, 5usize), (8usize, 2usize), (9usize, 5usize)
            ],
            by_v: ::std::vec![
                (6usize, 2usize), (6usize, 5usize), (7usize, 2usize), (7usize, 5usize),
                (8usize, 0usize), (8usize, 1usize), (8usize, 2usize), (9usize, 3usize),
                (9usize, 4usize), (9usize, 5usize)
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
        let c = ezy::array::<32usize, f64>(c);
        let q = ezy::array::<6usize, f64>(q);
        let v = ezy::array::<6usize, f64>(v);
        let a = ezy::array::<6usize, f64>(a);
        let lambda = ezy::array::<4usize, f64>(lambda);
        let by_q = ezy::array_mut::<12usize, f64>(by_q);
        let by_v = ezy::array_mut::<10usize, f64>(by_v);
        let multiplier_2 = lambda[2usize];
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = f64::sin_cos(seat_phi);
        let multiplier_0 = lambda[0usize];
        let multiplier_1 = lambda[1usize];
        let sum_12 = cos_seat_phi * multiplier_0 + sin_seat_phi * multiplier_1;
        let b = c[4usize];
        let multiplier_3 = lambda[3usize];
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = f64::sin_cos(bar_phi);
        let sum_23 = multiplier_0 * cos_bar_phi + multiplier_1 * sin_bar_phi;
        let d = c[5usize];
        let seat_omega = v[2usize];
        let seat_omega_squared = seat_omega * seat_omega;
        let acceleration_2 = a[2usize];
        let difference_31 = cos_seat_phi * acceleration_2
            - sin_seat_phi * seat_omega_squared;
        let bar_omega = v[5usize];
        let bar_omega_squared = bar_omega * bar_omega;
        let acceleration_5 = a[5usize];
        let difference_38 = cos_bar_phi * acceleration_5
            - sin_bar_phi * bar_omega_squared;
        let sum_42 = cos_seat_phi * seat_omega_squared + sin_seat_phi * acceleration_2;
        let sum_46 = cos_bar_phi * bar_omega_squared + sin_bar_phi * acceleration_5;
        let seat_vx = v[0usize];
        let acceleration_1 = a[1usize];
        let product_52 = sin_seat_phi * (acceleration_1 - seat_omega * seat_vx);
        let seat_vy = v[1usize];
        let acceleration_0 = a[0usize];
        let product_57 = cos_seat_phi * (seat_omega * seat_vy + acceleration_0);
        let bar_vx = v[3usize];
        let acceleration_4 = a[4usize];
        let product_63 = sin_bar_phi * (acceleration_4 - bar_omega * bar_vx);
        let bar_vy = v[4usize];
        let acceleration_3 = a[3usize];
        let product_68 = cos_bar_phi * (bar_omega * bar_vy + acceleration_3);
        let b_two = c[30usize];
        let seat_omega_b_two = seat_omega * b_two;
        let d_two = c[31usize];
        let bar_omega_d_two = bar_omega * d_two;
        by_q[0usize] = multiplier_2 * cos_seat_phi;
        by_q[1usize] = multiplier_2 * sin_seat_phi;
        by_q[2usize] = sum_12 * b;
        by_q[3usize] = multiplier_3 * cos_bar_phi;
        by_q[4usize] = multiplier_3 * sin_bar_phi;
        by_q[5usize] = sum_23 * d;
        by_q[6usize] = b * difference_31;
        by_q[7usize] = d * difference_38;
        by_q[8usize] = b * sum_42;
        by_q[9usize] = d * sum_46;
        by_q[10usize] = product_52 + product_57;
        by_q[11usize] = product_63 + product_68;
        by_v[0usize] = cos_seat_phi * seat_omega_b_two;
        by_v[1usize] = cos_bar_phi * bar_omega_d_two;
        by_v[2usize] = sin_seat_phi * seat_omega_b_two;
        by_v[3usize] = sin_bar_phi * bar_omega_d_two;
        by_v[4usize] = cos_seat_phi * seat_omega;
        by_v[5usize] = sin_seat_phi * seat_omega;
        by_v[6usize] = cos_seat_phi * seat_vx + sin_seat_phi * seat_vy;
        by_v[7usize] = cos_bar_phi * bar_omega;
        by_v[8usize] = sin_bar_phi * bar_omega;
        by_v[9usize] = cos_bar_phi * bar_vx + sin_bar_phi * bar_vy;
    }
    fn element_values(&self, c: &[f64], t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
        let c = ezy::array::<32usize, f64>(c);
        let q = ezy::array::<6usize, f64>(q);
        let v = ezy::array::<6usize, f64>(v);
        let out = ezy::array_mut::<16usize, f64>(out);
        let parameter_a = c[21usize];
        let parameter_c = c[22usize];
        let b = c[4usize];
        let d = c[5usize];
        out[0usize] = -parameter_a;
        out[1usize] = 0f64;
        out[2usize] = parameter_c;
        out[3usize] = 0f64;
        out[4usize] = b;
        out[5usize] = 0f64;
        out[6usize] = -d;
        out[7usize] = 0f64;
        out[8usize] = -parameter_a;
        out[9usize] = 0f64;
        out[10usize] = 1f64;
        out[11usize] = 0f64;
        out[12usize] = parameter_c;
        out[13usize] = 0f64;
        out[14usize] = 1f64;
        out[15usize] = 0f64;
    }
    fn elements(&self) -> ezy::List<ezy::ElementInfo> {
        const ELEMENTS: &[ezy::ElementInfo] = &[
            ezy::ElementInfo {
                kind: "point",
                name: ezy::Name::Borrowed("A"),
                points: ezy::List::Borrowed(
                    &[
                        ezy::LocalVector {
                            body: ::core::option::Option::Some(0usize),
                            text: ["-a", "0"],
                        },
                    ],
                ),
                directions: ezy::List::Borrowed(&[]),
                bodies: ezy::List::Borrowed(&[]),
                settings: &[],
                load: ::core::option::Option::None,
            },
            ezy::ElementInfo {
                kind: "point",
                name: ezy::Name::Borrowed("C"),
                points: ezy::List::Borrowed(
                    &[
                        ezy::LocalVector {
                            body: ::core::option::Option::Some(1usize),
                            text: ["c", "0"],
                        },
                    ],
                ),
                directions: ezy::List::Borrowed(&[]),
                bodies: ezy::List::Borrowed(&[]),
                settings: &[],
                load: ::core::option::Option::None,
            },
            ezy::ElementInfo {
                kind: "hinge",
                name: ezy::Name::Borrowed("B"),
                points: ezy::List::Borrowed(
                    &[
                        ezy::LocalVector {
                            body: ::core::option::Option::Some(0usize),
                            text: ["b", "0"],
                        },
                        ezy::LocalVector {
                            body: ::core::option::Option::Some(1usize),
                            text: ["-d", "0"],
                        },
                    ],
                ),
                directions: ezy::List::Borrowed(&[]),
                bodies: ezy::List::Borrowed(&[]),
                settings: &[],
                load: ::core::option::Option::None,
            },
            ezy::ElementInfo {
                kind: "skate",
                name: ezy::Name::Borrowed("rear"),
                points: ezy::List::Borrowed(
                    &[
                        ezy::LocalVector {
                            body: ::core::option::Option::Some(0usize),
                            text: ["-a", "0"],
                        },
                    ],
                ),
                directions: ezy::List::Borrowed(
                    &[
                        ezy::LocalVector {
                            body: ::core::option::Option::Some(0usize),
                            text: ["1", "0"],
                        },
                    ],
                ),
                bodies: ezy::List::Borrowed(&[]),
                settings: &[],
                load: ::core::option::Option::None,
            },
            ezy::ElementInfo {
                kind: "skate",
                name: ezy::Name::Borrowed("front"),
                points: ezy::List::Borrowed(
                    &[
                        ezy::LocalVector {
                            body: ::core::option::Option::Some(1usize),
                            text: ["c", "0"],
                        },
                    ],
                ),
                directions: ezy::List::Borrowed(
                    &[
                        ezy::LocalVector {
                            body: ::core::option::Option::Some(1usize),
                            text: ["1", "0"],
                        },
                    ],
                ),
                bodies: ezy::List::Borrowed(&[]),
                settings: &[],
                load: ::core::option::Option::None,
            },
        ];
        ezy::List::Borrowed(ELEMENTS)
    }
    fn in_lanes(&self) -> ::core::option::Option<&dyn ezy::EquationsInLanes> {
        ::core::option::Option::Some(self)
    }
    ezy::access_to_numbers! {}
    fn series(&self) -> ::core::option::Option<&dyn ezy::Series<f64>> {
        ::core::option::Option::Some(self)
    }
    fn precise(&self) -> ::core::option::Option<&dyn ezy::PreciseScene> {
        ::core::option::Option::Some(self)
    }
}
