#[automatically_derived]
impl ezy::Derived for Swing {
    fn count(&self, index: usize) -> usize {
        match index {
            0usize => self.n,
            _ => 0,
        }
    }
    fn set_count(&mut self, index: usize, value: usize) {
        match index {
            0usize => self.n = value,
            _ => {}
        }
    }
    fn jacobian_places(&self) -> ::core::option::Option<ezy::JacobianPlaces> {
        let first_link: i64 = 0;
        let n_q = ezy::Scene::info(self).n_coordinates();
        let mut places = ezy::JacobianPlaces::default();
        let mut place = 0;
        {
            let slots: [usize; 1] = [3 * (first_link + 0) as usize];
            places
                .by_q
                .extend_from_slice(
                    &[
                        (slots[0] + 2, slots[0] + 2),
                        (n_q + place + 0usize, slots[0] + 2),
                        (n_q + place + 1usize, slots[0] + 2),
                    ],
                );
            places
                .by_v
                .extend_from_slice(
                    &[
                        (n_q + place + 0usize, slots[0] + 2),
                        (n_q + place + 1usize, slots[0] + 2),
                    ],
                );
            place += 2usize;
        }
        for at_i in 1..(self.n as i64) {
            let slots: [usize; 2] = [
                3 * (first_link + (at_i - 1)) as usize,
                3 * (first_link + at_i) as usize,
            ];
            places
                .by_q
                .extend_from_slice(
                    &[
                        (slots[0] + 2, slots[0] + 2),
                        (slots[1] + 2, slots[1] + 2),
                        (n_q + place + 0usize, slots[0] + 2),
                        (n_q + place + 0usize, slots[1] + 2),
                        (n_q + place + 1usize, slots[0] + 2),
                        (n_q + place + 1usize, slots[1] + 2),
                    ],
                );
            places
                .by_v
                .extend_from_slice(
                    &[
                        (n_q + place + 0usize, slots[0] + 2),
                        (n_q + place + 0usize, slots[1] + 2),
                        (n_q + place + 1usize, slots[0] + 2),
                        (n_q + place + 1usize, slots[1] + 2),
                    ],
                );
            place += 2usize;
        }
        for at_i in 0..(self.n as i64) {
            let slots: [usize; 1] = [3 * (first_link + at_i) as usize];
            places.by_q.extend_from_slice(&[]);
            places.by_v.extend_from_slice(&[]);
            place += 0usize;
        }
        ::core::option::Option::Some(places)
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
        let first_link: i64 = 0;
        let mut place_q = 0;
        let mut place_v = 0;
        let mut row_place = 0;
        {
            let slots: [usize; 1] = [3 * (first_link + 0) as usize];
            let multiplier_0 = lambda[row_place + 0];
            let link_0_phi = q[slots[0] + 2];
            let (sin_link_0_phi, cos_link_0_phi) = f64::sin_cos(link_0_phi);
            let multiplier_1 = lambda[row_place + 1];
            let sum_9 = multiplier_0 * cos_link_0_phi + multiplier_1 * sin_link_0_phi;
            let l_over_two = c[2usize];
            let link_0_omega = v[slots[0] + 2];
            let link_0_omega_squared = link_0_omega * link_0_omega;
            let acceleration_8 = a[slots[0] + 2];
            let difference_17 = cos_link_0_phi * acceleration_8
                - sin_link_0_phi * link_0_omega_squared;
            let sum_21 = cos_link_0_phi * link_0_omega_squared
                + sin_link_0_phi * acceleration_8;
            let l = c[6usize];
            let link_0_omega_l = link_0_omega * l;
            by_q[place_q] = sum_9 * l_over_two;
            place_q += 1;
            by_q[place_q] = l_over_two * difference_17;
            place_q += 1;
            by_q[place_q] = l_over_two * sum_21;
            place_q += 1;
            by_v[place_v] = cos_link_0_phi * link_0_omega_l;
            place_v += 1;
            by_v[place_v] = sin_link_0_phi * link_0_omega_l;
            place_v += 1;
            row_place += 2usize;
        }
        for at_i in 1..(self.n as i64) {
            let slots: [usize; 2] = [
                3 * (first_link + (at_i - 1)) as usize,
                3 * (first_link + at_i) as usize,
            ];
            let multiplier_0 = lambda[row_place + 0];
            let link_i_1_phi = q[slots[0] + 2];
            let (sin_link_i_1_phi, cos_link_i_1_phi) = f64::sin_cos(link_i_1_phi);
            let multiplier_1 = lambda[row_place + 1];
            let sum_9 = multiplier_0 * cos_link_i_1_phi
                + multiplier_1 * sin_link_i_1_phi;
            let l_over_two = c[2usize];
            let link_i_phi = q[slots[1] + 2];
            let (sin_link_i_phi, cos_link_i_phi) = f64::sin_cos(link_i_phi);
            let sum_17 = multiplier_0 * cos_link_i_phi + multiplier_1 * sin_link_i_phi;
            let link_i_1_omega = v[slots[0] + 2];
            let link_i_1_omega_squared = link_i_1_omega * link_i_1_omega;
            let acceleration_11 = a[slots[0] + 2];
            let difference_24 = cos_link_i_1_phi * acceleration_11
                - sin_link_i_1_phi * link_i_1_omega_squared;
            let link_i_omega = v[slots[1] + 2];
            let link_i_omega_squared = link_i_omega * link_i_omega;
            let acceleration_14 = a[slots[1] + 2];
            let difference_31 = cos_link_i_phi * acceleration_14
                - sin_link_i_phi * link_i_omega_squared;
            let sum_35 = cos_link_i_1_phi * link_i_1_omega_squared
                + sin_link_i_1_phi * acceleration_11;
            let sum_39 = cos_link_i_phi * link_i_omega_squared
                + sin_link_i_phi * acceleration_14;
            let l = c[6usize];
            let link_i_1_omega_l = link_i_1_omega * l;
            let link_i_omega_l = link_i_omega * l;
            by_q[place_q] = sum_9 * l_over_two;
            place_q += 1;
            by_q[place_q] = l_over_two * sum_17;
            place_q += 1;
            by_q[place_q] = l_over_two * difference_24;
            place_q += 1;
            by_q[place_q] = l_over_two * difference_31;
            place_q += 1;
            by_q[place_q] = l_over_two * sum_35;
            place_q += 1;
            by_q[place_q] = l_over_two * sum_39;
            place_q += 1;
            by_v[place_v] = cos_link_i_1_phi * link_i_1_omega_l;
            place_v += 1;
            by_v[place_v] = cos_link_i_phi * link_i_omega_l;
            place_v += 1;
            by_v[place_v] = sin_link_i_1_phi * link_i_1_omega_l;
            place_v += 1;
            by_v[place_v] = sin_link_i_phi * link_i_omega_l;
            place_v += 1;
            row_place += 2usize;
        }
        for at_i in 0..(self.n as i64) {
            let slots: [usize; 1] = [3 * (first_link + at_i) as usize];
        }
    }
    fn element_values(&self, c: &[f64], t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
        let first_link: i64 = 0;
        let mut place = 0;
        {
            let slots: [usize; 1] = [3 * (first_link + ((self.n as i64) - 1)) as usize];
            let l_over_two = c[2usize];
            out[place] = l_over_two;
            place += 1;
            out[place] = 0f64;
            place += 1;
        }
        {
            let slots: [usize; 1] = [3 * (first_link + 0) as usize];
            let l_over_two = c[2usize];
            out[place] = 0f64;
            place += 1;
            out[place] = 0f64;
            place += 1;
            out[place] = -l_over_two;
            place += 1;
            out[place] = 0f64;
            place += 1;
        }
        for at_i in 1..(self.n as i64) {
            let slots: [usize; 2] = [
                3 * (first_link + (at_i - 1)) as usize,
                3 * (first_link + at_i) as usize,
            ];
            let l_over_two = c[2usize];
            out[place] = l_over_two;
            place += 1;
            out[place] = 0f64;
            place += 1;
            out[place] = -l_over_two;
            place += 1;
            out[place] = 0f64;
            place += 1;
        }
        for at_i in 0..(self.n as i64) {
            let slots: [usize; 1] = [3 * (first_link + at_i) as usize];
            out[place] = 0f64;
            place += 1;
        }
    }
    fn element_powers(&self, c: &[f64], t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
        let first_link: i64 = 0;
        out.fill(0f64);
        for at_i in 0..(self.n as i64) {
            let slots: [usize; 1] = [3 * (first_link + at_i) as usize];
            let m_g = c[3usize];
            let link_i_vy = v[slots[0] + 1];
            out[0usize] += -(m_g * link_i_vy);
        }
    }
    fn elements(&self) -> ezy::List<ezy::ElementInfo> {
        let first_link: i64 = 0;
        let mut all = ::std::vec::Vec::new();
        {
            let slots: [usize; 1] = [3 * (first_link + ((self.n as i64) - 1)) as usize];
            all.push(ezy::ElementInfo {
                kind: "point",
                name: ezy::member("tip", &[], ""),
                points: ezy::List::Owned(
                    ::std::vec![
                        ezy::LocalVector { body :
                        ::core::option::Option::Some(slots[0usize] / 3usize), text :
                        ["l/2", "0"] }
                    ],
                ),
                directions: ezy::List::Owned(::std::vec![]),
                bodies: ezy::List::Owned(::std::vec![]),
                settings: &[],
                load: ::core::option::Option::None,
            });
        }
        {
            let slots: [usize; 1] = [3 * (first_link + 0) as usize];
            all.push(ezy::ElementInfo {
                kind: "hinge",
                name: ezy::member("top", &[], ""),
                points: ezy::List::Owned(
                    ::std::vec![
                        ezy::LocalVector { body : ::core::option::Option::None, text :
                        ["0", "0"] }, ezy::LocalVector { body :
                        ::core::option::Option::Some(slots[0usize] / 3usize), text :
                        ["-l/2", "0"] }
                    ],
                ),
                directions: ezy::List::Owned(::std::vec![]),
                bodies: ezy::List::Owned(::std::vec![]),
                settings: &[],
                load: ::core::option::Option::None,
            });
        }
        for at_i in 1..(self.n as i64) {
            let slots: [usize; 2] = [
                3 * (first_link + (at_i - 1)) as usize,
                3 * (first_link + at_i) as usize,
            ];
            all.push(ezy::ElementInfo {
                kind: "hinge",
                name: ezy::member("pin", &[at_i], ""),
                points: ezy::List::Owned(
                    ::std::vec![
                        ezy::LocalVector { body :
                        ::core::option::Option::Some(slots[0usize] / 3usize), text :
                        ["l/2", "0"] }, ezy::LocalVector { body :
                        ::core::option::Option::Some(slots[1usize] / 3usize), text :
                        ["-l/2", "0"] }
                    ],
                ),
                directions: ezy::List::Owned(::std::vec![]),
                bodies: ezy::List::Owned(::std::vec![]),
                settings: &[],
                load: ::core::option::Option::None,
            });
        }
        for at_i in 0..(self.n as i64) {
            let slots: [usize; 1] = [3 * (first_link + at_i) as usize];
            all.push(ezy::ElementInfo {
                kind: "gravity",
                name: ezy::member("", &[at_i], ""),
                points: ezy::List::Owned(::std::vec![]),
                directions: ezy::List::Owned(::std::vec![]),
                bodies: ezy::List::Owned(
                    ::std::vec![::core::option::Option::Some(slots[0usize] / 3usize)],
                ),
                settings: &[],
                load: ::core::option::Option::Some((
                    slots[0usize] / 3usize,
                    ezy::LoadKind::Torque,
                )),
            });
        }
        ezy::List::Owned(all)
    }
    fn force_elements(&self) -> &'static [ezy::ForceElement] {
        &[
            ezy::ForceElement {
                name: "gravity",
                kind: "gravity",
                effect: ::core::option::Option::None,
                has_potential: true,
                does_work: false,
            },
        ]
    }
    ezy::access_to_numbers! {}
    fn series(&self) -> ::core::option::Option<&dyn ezy::Series<f64>> {
        ::core::option::Option::Some(self)
    }
    fn precise(&self) -> ::core::option::Option<&dyn ezy::PreciseScene> {
        ::core::option::Option::Some(self)
    }
}
