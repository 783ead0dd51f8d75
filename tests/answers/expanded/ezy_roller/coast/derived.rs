#[automatically_derived]
impl ezy::Derived for Coast {
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
        let c = ezy::array::<46usize, T>(c);
        let q = ezy::array::<6usize, T>(q);
        let v = ezy::array::<6usize, T>(v);
        let out = ezy::array_mut::<20usize, T>(out);
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
        let difference_18 = T::fused(
            -d_bar_omega,
            sin_bar_phi,
            T::fused(-b_seat_omega, sin_seat_phi, seat_vx) - bar_vx,
        );
        let seat_vy = v[1usize];
        let bar_vy = v[4usize];
        let sum_27 = T::fused(
            d_bar_omega,
            cos_bar_phi,
            T::fused(b_seat_omega, cos_seat_phi, seat_vy - bar_vy),
        );
        let parameter_a = c[21usize];
        let projection_right_side_rear = T::fused(
            seat_vy,
            cos_seat_phi,
            -T::fused(seat_vx, sin_seat_phi, seat_omega * parameter_a),
        );
        let parameter_c = c[22usize];
        let projection_right_side_front = T::fused(
            bar_vy,
            cos_bar_phi,
            T::fused(-bar_vx, sin_bar_phi, bar_omega * parameter_c),
        );
        let k42 = c[0usize];
        let k47 = c[1usize];
        let sum_46 = T::fused(
            cos_bar_phi,
            cos_bar_phi * k47,
            cos_seat_phi * (cos_seat_phi * k42),
        );
        let k46 = c[2usize];
        let A_B_x_B_x = sum_46 + k46;
        let A_B_x_B_y = T::fused(
            cos_bar_phi,
            sin_bar_phi * k47,
            cos_seat_phi * (sin_seat_phi * k42),
        );
        let one_over_m1_plus_one_over_m2 = c[3usize];
        let A_B_y_B_y = one_over_m1_plus_one_over_m2 - sum_46;
        let k39 = c[6usize];
        let product_57 = projection_right_side_rear * k39;
        let k44 = c[7usize];
        let product_61 = projection_right_side_front * k44;
        let right_side_B_x = T::fused(
            -sin_bar_phi,
            product_61,
            T::fused(-sin_seat_phi, product_57, difference_18),
        );
        let right_side_B_y = T::fused(
            cos_bar_phi,
            product_61,
            T::fused(cos_seat_phi, product_57, sum_27),
        );
        let pivot_B_x_B_y = T::fused(-A_B_x_B_y, A_B_x_B_y, A_B_x_B_x * A_B_y_B_y);
        let one_over_pivot_B_x_B_y = T::from_f64(1f64) / pivot_B_x_B_y;
        let projection_lambda_B_x = one_over_pivot_B_x_B_y
            * T::fused(-A_B_x_B_y, right_side_B_y, A_B_y_B_y * right_side_B_x);
        let projection_lambda_B_y = one_over_pivot_B_x_B_y
            * T::fused(-A_B_x_B_y, right_side_B_x, A_B_x_B_x * right_side_B_y);
        let difference_82 = T::fused(
            -sin_bar_phi,
            projection_lambda_B_x,
            cos_bar_phi * projection_lambda_B_y,
        );
        let k43 = c[8usize];
        let projection_lambda_front = T::fused(
            projection_right_side_front,
            k43,
            k44 * difference_82,
        );
        let difference_89 = T::fused(
            -sin_seat_phi,
            projection_lambda_B_x,
            cos_seat_phi * projection_lambda_B_y,
        );
        let k38 = c[9usize];
        let projection_lambda_rear = T::fused(
            projection_right_side_rear,
            k38,
            k39 * difference_89,
        );
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
        let projected_seat_vx = T::fused(
            T::fused(sin_seat_phi, projection_lambda_rear, -projection_lambda_B_x),
            one_over_m1,
            seat_vx,
        );
        let projected_seat_vy = T::fused(
            -one_over_m1,
            T::fused(cos_seat_phi, projection_lambda_rear, projection_lambda_B_y),
            seat_vy,
        );
        let projected_seat_omega = seat_omega
            + T::fused(-difference_89, b_over_i1, projection_lambda_rear * a_over_i1);
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
            - T::fused(projection_lambda_front, c_over_i2, difference_82 * d_over_i2);
        let minus_right_side_rear = projected_seat_omega
            * T::fused(
                sin_seat_phi,
                projected_seat_vy,
                cos_seat_phi * projected_seat_vx,
            );
        let minus_right_side_front = projected_bar_omega
            * T::fused(sin_bar_phi, projected_bar_vy, cos_bar_phi * projected_bar_vx);
        let product_138 = projected_seat_omega * (b * projected_seat_omega);
        let product_141 = projected_bar_omega * (d * projected_bar_omega);
        let k39_minus_right_side_rear = k39 * minus_right_side_rear;
        let difference_146 = T::fused(
            sin_seat_phi,
            k39_minus_right_side_rear,
            -T::fused(cos_bar_phi, product_141, cos_seat_phi * product_138),
        );
        let k44_minus_right_side_front = k44 * minus_right_side_front;
        let right_side_B_x_ = T::fused(
            sin_bar_phi,
            k44_minus_right_side_front,
            difference_146,
        );
        let sum_154 = T::fused(
            cos_seat_phi,
            k39_minus_right_side_rear,
            T::fused(sin_bar_phi, product_141, sin_seat_phi * product_138),
        );
        let minus_right_side_B_y = T::fused(
            cos_bar_phi,
            k44_minus_right_side_front,
            sum_154,
        );
        let lambda_B_x = one_over_pivot_B_x_B_y
            * T::fused(A_B_x_B_y, minus_right_side_B_y, A_B_y_B_y * right_side_B_x_);
        let minus_lambda_B_y = one_over_pivot_B_x_B_y
            * T::fused(A_B_x_B_x, minus_right_side_B_y, A_B_x_B_y * right_side_B_x_);
        let sum_167 = T::fused(cos_bar_phi, minus_lambda_B_y, sin_bar_phi * lambda_B_x);
        let minus_lambda_front = T::fused(k43, minus_right_side_front, k44 * sum_167);
        let sum_173 = T::fused(
            cos_seat_phi,
            minus_lambda_B_y,
            sin_seat_phi * lambda_B_x,
        );
        let minus_lambda_rear = T::fused(k38, minus_right_side_rear, k39 * sum_173);
        out[0usize] = difference_18;
        out[1usize] = sum_27;
        out[2usize] = projection_right_side_rear;
        out[3usize] = projection_right_side_front;
        out[4usize] = projected_seat_vx;
        out[5usize] = projected_seat_vy;
        out[6usize] = projected_seat_omega;
        out[7usize] = projected_bar_vx;
        out[8usize] = projected_bar_vy;
        out[9usize] = projected_bar_omega;
        out[10usize] = -(one_over_m1
            * T::fused(sin_seat_phi, minus_lambda_rear, lambda_B_x));
        out[11usize] = one_over_m1
            * T::fused(cos_seat_phi, minus_lambda_rear, minus_lambda_B_y);
        out[12usize] = T::fused(-a_over_i1, minus_lambda_rear, b_over_i1 * sum_173);
        out[13usize] = one_over_m2
            * T::fused(-sin_bar_phi, minus_lambda_front, lambda_B_x);
        out[14usize] = one_over_m2
            * T::fused(cos_bar_phi, minus_lambda_front, -minus_lambda_B_y);
        out[15usize] = T::fused(c_over_i2, minus_lambda_front, d_over_i2 * sum_167);
        out[16usize] = lambda_B_x;
        out[17usize] = -minus_lambda_B_y;
        out[18usize] = -minus_lambda_rear;
        out[19usize] = -minus_lambda_front;
        ezy::Pivots::new()
            .see(&[2usize], T::least_ratio(k34, k53))
            .see(&[3usize], T::least_ratio(k37, k54))
            .see(&[0usize, 1usize], T::least_ratio(pivot_B_x_B_y, k57))
    }
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
        let c = ezy::array::<46usize, f64>(c);
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
        let c = ezy::array::<46usize, f64>(c);
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
    fn in_quasi_velocities(
        &self,
    ) -> ::core::option::Option<&dyn ezy::EquationsInQuasiVelocities> {
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
