#[automatically_derived]
impl ezy::Derived for Skid {
    #[inline]
    fn projected_accelerations(
        &self,
        c: &[f64],
        t: f64,
        q: &[f64],
        v: &[f64],
        out: &mut [f64],
    ) -> ezy::Pivots {
        use ezy::Scalar as _;
        type T = f64;
        let c = ezy::array::<45usize, T>(c);
        let q = ezy::array::<6usize, T>(q);
        let v = ezy::array::<6usize, T>(v);
        let out = ezy::array_mut::<20usize, T>(out);
        let seat_vx = v[0usize];
        let bar_vx = v[3usize];
        let d = c[17usize];
        let bar_omega = v[5usize];
        let d_bar_omega = d * bar_omega;
        let bar_phi = q[5usize];
        let seat_phi = q[2usize];
        let omega = c[1usize];
        let [(sin_bar_phi, cos_bar_phi), (sin_seat_phi, cos_seat_phi), (_, cos_omega_t),
        ] = T::sin_cos_of([bar_phi, seat_phi, omega * t]);
        let b = c[16usize];
        let seat_omega = v[2usize];
        let b_seat_omega = b * seat_omega;
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
        let parameter_c = c[32usize];
        let projection_right_side_front = T::fused(
            bar_vy,
            cos_bar_phi,
            T::fused(-bar_vx, sin_bar_phi, bar_omega * parameter_c),
        );
        let rear_on_ice_holds = c[4usize];
        let product_38 = T::fused(-seat_vx, sin_seat_phi, seat_vy * cos_seat_phi)
            * rear_on_ice_holds;
        let a_rear_on_ice_holds = c[33usize];
        let projection_right_side_rear_on_ice = T::fused(
            -seat_omega,
            a_rear_on_ice_holds,
            product_38,
        );
        let k67 = c[7usize];
        let k62 = c[8usize];
        let sum_48 = T::fused(
            cos_bar_phi,
            cos_bar_phi * k62,
            cos_seat_phi * (cos_seat_phi * k67),
        );
        let k66 = c[9usize];
        let A_B_x_B_x = sum_48 + k66;
        let A_B_x_B_y = T::fused(
            cos_bar_phi,
            sin_bar_phi * k62,
            cos_seat_phi * (sin_seat_phi * k67),
        );
        let one_over_m1_plus_one_over_m2 = c[10usize];
        let A_B_y_B_y = one_over_m1_plus_one_over_m2 - sum_48;
        let k59 = c[15usize];
        let product_59 = projection_right_side_front * k59;
        let k64 = c[13usize];
        let product_63 = projection_right_side_rear_on_ice * k64;
        let right_side_B_x = T::fused(
            -sin_seat_phi,
            product_63,
            T::fused(-sin_bar_phi, product_59, difference_18),
        );
        let right_side_B_y = T::fused(
            cos_seat_phi,
            product_63,
            T::fused(cos_bar_phi, product_59, sum_27),
        );
        let pivot_B_x_B_y = T::fused(-A_B_x_B_y, A_B_x_B_y, A_B_x_B_x * A_B_y_B_y);
        let one_over_pivot_B_x_B_y = T::from_f64(1f64) / pivot_B_x_B_y;
        let projection_lambda_B_x = one_over_pivot_B_x_B_y
            * T::fused(-A_B_x_B_y, right_side_B_y, A_B_y_B_y * right_side_B_x);
        let projection_lambda_B_y = one_over_pivot_B_x_B_y
            * T::fused(-A_B_x_B_y, right_side_B_x, A_B_x_B_x * right_side_B_y);
        let difference_84 = T::fused(
            -sin_seat_phi,
            projection_lambda_B_x,
            cos_seat_phi * projection_lambda_B_y,
        );
        let k63 = c[18usize];
        let projection_lambda_rear_on_ice = T::fused(
            projection_right_side_rear_on_ice,
            k63,
            k64 * difference_84,
        );
        let difference_91 = T::fused(
            -sin_bar_phi,
            projection_lambda_B_x,
            cos_bar_phi * projection_lambda_B_y,
        );
        let k58 = c[19usize];
        let projection_lambda_front = T::fused(
            projection_right_side_front,
            k58,
            k59 * difference_91,
        );
        let one_over_m1 = c[21usize];
        let rear_on_ice_holds_over_m1 = c[20usize];
        let product_99 = projection_lambda_rear_on_ice * rear_on_ice_holds_over_m1;
        let b_over_i1 = c[12usize];
        let a_rear_on_ice_holds_over_i1 = c[5usize];
        let one_over_m2 = c[23usize];
        let d_over_i2 = c[24usize];
        let c_over_i2 = c[26usize];
        let k50 = c[27usize];
        let k72 = c[28usize];
        let k57 = c[29usize];
        let k73 = c[30usize];
        let k76 = c[31usize];
        let projected_seat_vx = seat_vx
            + T::fused(-projection_lambda_B_x, one_over_m1, sin_seat_phi * product_99);
        let projected_seat_vy = seat_vy
            - T::fused(cos_seat_phi, product_99, projection_lambda_B_y * one_over_m1);
        let projected_seat_omega = seat_omega
            + T::fused(
                -difference_84,
                b_over_i1,
                projection_lambda_rear_on_ice * a_rear_on_ice_holds_over_i1,
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
            - T::fused(projection_lambda_front, c_over_i2, difference_91 * d_over_i2);
        let m0 = c[0usize];
        let hold_rear_on_ice_side_a = c[2usize];
        let force_seat_phi = T::fused(m0, cos_omega_t, hold_rear_on_ice_side_a);
        let product_144 = projected_bar_omega
            * T::fused(sin_bar_phi, projected_bar_vy, cos_bar_phi * projected_bar_vx);
        let c_m0_over_i2 = c[3usize];
        let minus_right_side_front = T::fused(cos_omega_t, c_m0_over_i2, product_144);
        let product_151 = projected_seat_omega
            * T::fused(
                sin_seat_phi,
                projected_seat_vy,
                cos_seat_phi * projected_seat_vx,
            );
        let k31 = c[6usize];
        let minus_right_side_rear_on_ice = T::fused(
            a_rear_on_ice_holds_over_i1,
            force_seat_phi,
            rear_on_ice_holds * product_151,
        ) + k31;
        let k21 = c[11usize];
        let sum_161 = T::fused(
            k64,
            minus_right_side_rear_on_ice,
            T::fused(-b_over_i1, force_seat_phi, k21),
        );
        let d_m0_over_i2 = c[14usize];
        let sum_166 = T::fused(k59, minus_right_side_front, cos_omega_t * d_m0_over_i2);
        let product_170 = projected_seat_omega * (b * projected_seat_omega);
        let difference_172 = T::fused(
            -cos_seat_phi,
            product_170,
            T::fused(sin_bar_phi, sum_166, sin_seat_phi * sum_161),
        );
        let product_174 = projected_bar_omega * (d * projected_bar_omega);
        let right_side_B_x_ = T::fused(-cos_bar_phi, product_174, difference_172);
        let sum_181 = T::fused(
            sin_seat_phi,
            product_170,
            T::fused(cos_bar_phi, sum_166, cos_seat_phi * sum_161),
        );
        let minus_right_side_B_y = T::fused(sin_bar_phi, product_174, sum_181);
        let lambda_B_x = one_over_pivot_B_x_B_y
            * T::fused(A_B_x_B_y, minus_right_side_B_y, A_B_y_B_y * right_side_B_x_);
        let minus_lambda_B_y = one_over_pivot_B_x_B_y
            * T::fused(A_B_x_B_x, minus_right_side_B_y, A_B_x_B_y * right_side_B_x_);
        let sum_194 = T::fused(
            cos_seat_phi,
            minus_lambda_B_y,
            sin_seat_phi * lambda_B_x,
        );
        let minus_lambda_rear_on_ice = T::fused(
            k63,
            minus_right_side_rear_on_ice,
            k64 * sum_194,
        );
        let sum_200 = T::fused(cos_bar_phi, minus_lambda_B_y, sin_bar_phi * lambda_B_x);
        let minus_lambda_front = T::fused(k58, minus_right_side_front, k59 * sum_200);
        let difference_205 = T::fused(
            -rear_on_ice_holds_over_m1,
            minus_lambda_rear_on_ice,
            k21,
        );
        let one_over_i1 = c[22usize];
        let m0_over_i2 = c[25usize];
        out[0usize] = difference_18;
        out[1usize] = sum_27;
        out[2usize] = projection_right_side_front;
        out[3usize] = projection_right_side_rear_on_ice;
        out[4usize] = projected_seat_vx;
        out[5usize] = projected_seat_vy;
        out[6usize] = projected_seat_omega;
        out[7usize] = projected_bar_vx;
        out[8usize] = projected_bar_vy;
        out[9usize] = projected_bar_omega;
        out[10usize] = T::fused(-one_over_m1, lambda_B_x, sin_seat_phi * difference_205);
        out[11usize] = T::fused(
            -cos_seat_phi,
            difference_205,
            one_over_m1 * minus_lambda_B_y,
        );
        out[12usize] = T::fused(
            -a_rear_on_ice_holds_over_i1,
            minus_lambda_rear_on_ice,
            T::fused(force_seat_phi, one_over_i1, b_over_i1 * sum_194),
        );
        out[13usize] = one_over_m2
            * T::fused(-sin_bar_phi, minus_lambda_front, lambda_B_x);
        out[14usize] = one_over_m2
            * T::fused(cos_bar_phi, minus_lambda_front, -minus_lambda_B_y);
        out[15usize] = T::fused(
            c_over_i2,
            minus_lambda_front,
            T::fused(-cos_omega_t, m0_over_i2, d_over_i2 * sum_200),
        );
        out[16usize] = lambda_B_x;
        out[17usize] = -minus_lambda_B_y;
        out[18usize] = -minus_lambda_front;
        out[19usize] = -minus_lambda_rear_on_ice;
        ezy::Pivots::new()
            .see(&[2usize], T::least_ratio(k50, k72))
            .see(&[3usize], T::least_ratio(k57, k73))
            .see(&[0usize, 1usize], T::least_ratio(pivot_B_x_B_y, k76))
    }
    fn limited_skates(&self, c: &[f64], t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
        let c = ezy::array::<45usize, f64>(c);
        let q = ezy::array::<6usize, f64>(q);
        let v = ezy::array::<6usize, f64>(v);
        let out = ezy::array_mut::<2usize, f64>(out);
        let hold = c[44usize];
        let parameter_a = c[40usize];
        let seat_omega = v[2usize];
        let seat_vx = v[0usize];
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = f64::sin_cos(seat_phi);
        let sum_10 = parameter_a * seat_omega + seat_vx * sin_seat_phi;
        let seat_vy = v[1usize];
        out[0usize] = hold;
        out[1usize] = seat_vy * cos_seat_phi - sum_10;
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
        let c = ezy::array::<45usize, f64>(c);
        let q = ezy::array::<6usize, f64>(q);
        let v = ezy::array::<6usize, f64>(v);
        let a = ezy::array::<6usize, f64>(a);
        let lambda = ezy::array::<4usize, f64>(lambda);
        let by_q = ezy::array_mut::<12usize, f64>(by_q);
        let by_v = ezy::array_mut::<10usize, f64>(by_v);
        let hold_rear_on_ice_side = c[34usize];
        let rear_on_ice_holds = c[4usize];
        let multiplier_3 = lambda[3usize];
        let sum_5 = hold_rear_on_ice_side + rear_on_ice_holds * multiplier_3;
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = f64::sin_cos(seat_phi);
        let multiplier_0 = lambda[0usize];
        let multiplier_1 = lambda[1usize];
        let sum_16 = cos_seat_phi * multiplier_0 + sin_seat_phi * multiplier_1;
        let b = c[16usize];
        let multiplier_2 = lambda[2usize];
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = f64::sin_cos(bar_phi);
        let sum_27 = multiplier_0 * cos_bar_phi + multiplier_1 * sin_bar_phi;
        let d = c[17usize];
        let seat_omega = v[2usize];
        let seat_omega_squared = seat_omega * seat_omega;
        let acceleration_2 = a[2usize];
        let difference_35 = cos_seat_phi * acceleration_2
            - sin_seat_phi * seat_omega_squared;
        let bar_omega = v[5usize];
        let bar_omega_squared = bar_omega * bar_omega;
        let acceleration_5 = a[5usize];
        let difference_42 = cos_bar_phi * acceleration_5
            - sin_bar_phi * bar_omega_squared;
        let sum_46 = cos_seat_phi * seat_omega_squared + sin_seat_phi * acceleration_2;
        let sum_50 = cos_bar_phi * bar_omega_squared + sin_bar_phi * acceleration_5;
        let bar_vx = v[3usize];
        let acceleration_4 = a[4usize];
        let product_56 = sin_bar_phi * (acceleration_4 - bar_omega * bar_vx);
        let bar_vy = v[4usize];
        let acceleration_3 = a[3usize];
        let product_61 = cos_bar_phi * (bar_omega * bar_vy + acceleration_3);
        let seat_vx = v[0usize];
        let acceleration_1 = a[1usize];
        let product_67 = sin_seat_phi * (acceleration_1 - seat_omega * seat_vx);
        let seat_vy = v[1usize];
        let acceleration_0 = a[0usize];
        let product_72 = cos_seat_phi * (seat_omega * seat_vy + acceleration_0);
        let b_two = c[42usize];
        let seat_omega_b_two = seat_omega * b_two;
        let d_two = c[43usize];
        let bar_omega_d_two = bar_omega * d_two;
        let product_88 = rear_on_ice_holds * seat_omega;
        let sum_93 = cos_seat_phi * seat_vx + sin_seat_phi * seat_vy;
        by_q[0usize] = sum_5 * cos_seat_phi;
        by_q[1usize] = sum_5 * sin_seat_phi;
        by_q[2usize] = sum_16 * b;
        by_q[3usize] = multiplier_2 * cos_bar_phi;
        by_q[4usize] = multiplier_2 * sin_bar_phi;
        by_q[5usize] = sum_27 * d;
        by_q[6usize] = b * difference_35;
        by_q[7usize] = d * difference_42;
        by_q[8usize] = b * sum_46;
        by_q[9usize] = d * sum_50;
        by_q[10usize] = product_56 + product_61;
        by_q[11usize] = rear_on_ice_holds * (product_67 + product_72);
        by_v[0usize] = cos_seat_phi * seat_omega_b_two;
        by_v[1usize] = cos_bar_phi * bar_omega_d_two;
        by_v[2usize] = sin_seat_phi * seat_omega_b_two;
        by_v[3usize] = sin_bar_phi * bar_omega_d_two;
        by_v[4usize] = cos_bar_phi * bar_omega;
        by_v[5usize] = sin_bar_phi * bar_omega;
        by_v[6usize] = cos_bar_phi * bar_vx + sin_bar_phi * bar_vy;
        by_v[7usize] = cos_seat_phi * product_88;
        by_v[8usize] = sin_seat_phi * product_88;
        by_v[9usize] = rear_on_ice_holds * sum_93;
    }
    fn element_values(&self, c: &[f64], t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
        let c = ezy::array::<45usize, f64>(c);
        let q = ezy::array::<6usize, f64>(q);
        let v = ezy::array::<6usize, f64>(v);
        let out = ezy::array_mut::<17usize, f64>(out);
        let parameter_a = c[40usize];
        let parameter_c = c[32usize];
        let b = c[16usize];
        let d = c[17usize];
        let m0 = c[0usize];
        let omega = c[1usize];
        let cos_omega_t = f64::cos(omega * t);
        out[0usize] = -parameter_a;
        out[1usize] = 0f64;
        out[2usize] = parameter_c;
        out[3usize] = 0f64;
        out[4usize] = b;
        out[5usize] = 0f64;
        out[6usize] = -d;
        out[7usize] = 0f64;
        out[8usize] = parameter_c;
        out[9usize] = 0f64;
        out[10usize] = 1f64;
        out[11usize] = 0f64;
        out[12usize] = -parameter_a;
        out[13usize] = 0f64;
        out[14usize] = 1f64;
        out[15usize] = 0f64;
        out[16usize] = m0 * cos_omega_t;
    }
    fn element_powers(&self, c: &[f64], t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
        let c = ezy::array::<45usize, f64>(c);
        let q = ezy::array::<6usize, f64>(q);
        let v = ezy::array::<6usize, f64>(v);
        let out = ezy::array_mut::<2usize, f64>(out);
        let seat_omega = v[2usize];
        let bar_omega = v[5usize];
        let omega = c[1usize];
        let cos_omega_t = f64::cos(omega * t);
        let m0 = c[0usize];
        let seat_vx = v[0usize];
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = f64::sin_cos(seat_phi);
        let seat_vy = v[1usize];
        let difference_19 = seat_vx * sin_seat_phi - seat_vy * cos_seat_phi;
        let hold_rear_on_ice_side = c[34usize];
        let hold_rear_on_ice_side_a = c[2usize];
        out[0usize] = (seat_omega - bar_omega) * cos_omega_t * m0;
        out[1usize] = difference_19 * hold_rear_on_ice_side
            + seat_omega * hold_rear_on_ice_side_a;
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
            ezy::ElementInfo {
                kind: "skate",
                name: ezy::Name::Borrowed("rear_on_ice"),
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
                settings: &[("limit", "hold")],
                load: ::core::option::Option::None,
            },
            ezy::ElementInfo {
                kind: "torque",
                name: ezy::Name::Borrowed(""),
                points: ezy::List::Borrowed(&[]),
                directions: ezy::List::Borrowed(&[]),
                bodies: ezy::List::Borrowed(
                    &[
                        ::core::option::Option::Some(0usize),
                        ::core::option::Option::Some(1usize),
                    ],
                ),
                settings: &[],
                load: ::core::option::Option::Some((0usize, ezy::LoadKind::Torque)),
            },
        ];
        ezy::List::Borrowed(ELEMENTS)
    }
    fn force_elements(&self) -> &'static [ezy::ForceElement] {
        &[
            ezy::ForceElement {
                name: "torque seat ~ bar",
                kind: "torque",
                effect: ::core::option::Option::Some("pump"),
                has_potential: false,
                does_work: true,
            },
            ezy::ForceElement {
                name: "skate rear_on_ice",
                kind: "skate",
                effect: ::core::option::Option::Some("ice"),
                has_potential: false,
                does_work: true,
            },
        ]
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
