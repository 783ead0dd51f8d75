#[automatically_derived]
impl<T: ezy::Scalar> ezy::Equations<T> for self::Swing {
    fn constants(&self, parameters: &[T], c: &mut [T]) {
        let parameters = ezy::array::<3usize, T>(parameters);
        let c = ezy::array_mut::<7usize, T>(c);
        let parameter_m = parameters[1usize];
        let l = parameters[0usize];
        let l_squared = l * l;
        let m_l_squared = parameter_m * l_squared;
        let k9 = m_l_squared / T::from_f64(12f64);
        let g = parameters[2usize];
        let m_g = parameter_m * g;
        let l_over_two = l / T::from_f64(2f64);
        let n = T::from_f64((self.n as i64) as f64);
        let n_l = n * l;
        let one_over_n_l = T::from_f64(1f64) / n_l;
        let k17 = l_over_two / n_l;
        c[0usize] = parameter_m;
        c[1usize] = k9;
        c[2usize] = l_over_two;
        c[3usize] = m_g;
        c[4usize] = one_over_n_l;
        c[5usize] = k17;
        c[6usize] = l;
    }
    fn mass_matrix(&self, c: &[T], out: &mut [T]) {
        let mut place = 0;
        for at_i in 0..(self.n as i64) {
            let parameter_m = c[0usize];
            let k9 = c[1usize];
            out[place] = parameter_m;
            place += 1;
            out[place] = parameter_m;
            place += 1;
            out[place] = k9;
            place += 1;
        }
    }
    fn position_constraint_with_sines(
        &self,
        c: &[T],
        t: T,
        q: &[T],
        sines: &[[T; 2]],
        out: &mut [T],
    ) {
        let first_link: i64 = 0;
        let mut place = 0;
        {
            let slots: [usize; 1] = [3 * (first_link + 0) as usize];
            let link_0_x = q[slots[0] + 0];
            let l_over_two = c[2usize];
            let [sin_link_0_phi, cos_link_0_phi] = sines[slots[0] / 3];
            let link_0_y = q[slots[0] + 1];
            out[place] = T::fused(l_over_two, cos_link_0_phi, -link_0_x);
            place += 1;
            out[place] = T::fused(l_over_two, sin_link_0_phi, -link_0_y);
            place += 1;
        }
        for at_i in 1..(self.n as i64) {
            let slots: [usize; 2] = [
                3 * (first_link + (at_i - 1)) as usize,
                3 * (first_link + at_i) as usize,
            ];
            let [sin_link_i_1_phi, cos_link_i_1_phi] = sines[slots[0] / 3];
            let [sin_link_i_phi, cos_link_i_phi] = sines[slots[1] / 3];
            let l_over_two = c[2usize];
            let link_i_1_x = q[slots[0] + 0];
            let link_i_x = q[slots[1] + 0];
            let link_i_1_y = q[slots[0] + 1];
            let link_i_y = q[slots[1] + 1];
            out[place] = T::fused(
                cos_link_i_1_phi + cos_link_i_phi,
                l_over_two,
                link_i_1_x,
            ) - link_i_x;
            place += 1;
            out[place] = T::fused(
                l_over_two,
                sin_link_i_1_phi + sin_link_i_phi,
                link_i_1_y,
            ) - link_i_y;
            place += 1;
        }
    }
    fn position_constraint(&self, c: &[T], t: T, q: &[T], out: &mut [T]) {
        self.position_constraint_with_sines(c, t, q, &ezy::sines(q), out);
    }
    fn velocity_constraint_with_sines(
        &self,
        c: &[T],
        t: T,
        q: &[T],
        v: &[T],
        sines: &[[T; 2]],
        out: &mut [T],
    ) {
        let first_link: i64 = 0;
        let mut place = 0;
        {
            let slots: [usize; 1] = [3 * (first_link + 0) as usize];
            let link_0_vx = v[slots[0] + 0];
            let l_over_two = c[2usize];
            let link_0_omega = v[slots[0] + 2];
            let l_over_two_link_0_omega = l_over_two * link_0_omega;
            let [sin_link_0_phi, cos_link_0_phi] = sines[slots[0] / 3];
            let link_0_vy = v[slots[0] + 1];
            out[place] = -T::fused(l_over_two_link_0_omega, sin_link_0_phi, link_0_vx);
            place += 1;
            out[place] = T::fused(l_over_two_link_0_omega, cos_link_0_phi, -link_0_vy);
            place += 1;
        }
        for at_i in 1..(self.n as i64) {
            let slots: [usize; 2] = [
                3 * (first_link + (at_i - 1)) as usize,
                3 * (first_link + at_i) as usize,
            ];
            let link_i_1_omega = v[slots[0] + 2];
            let [sin_link_i_1_phi, cos_link_i_1_phi] = sines[slots[0] / 3];
            let link_i_omega = v[slots[1] + 2];
            let [sin_link_i_phi, cos_link_i_phi] = sines[slots[1] / 3];
            let l_over_two = c[2usize];
            let link_i_1_vx = v[slots[0] + 0];
            let difference_14 = T::fused(
                -T::fused(
                    link_i_omega,
                    sin_link_i_phi,
                    link_i_1_omega * sin_link_i_1_phi,
                ),
                l_over_two,
                link_i_1_vx,
            );
            let link_i_vx = v[slots[1] + 0];
            let link_i_1_vy = v[slots[0] + 1];
            let sum_24 = T::fused(
                l_over_two,
                T::fused(
                    link_i_omega,
                    cos_link_i_phi,
                    link_i_1_omega * cos_link_i_1_phi,
                ),
                link_i_1_vy,
            );
            let link_i_vy = v[slots[1] + 1];
            out[place] = difference_14 - link_i_vx;
            place += 1;
            out[place] = sum_24 - link_i_vy;
            place += 1;
        }
    }
    fn velocity_constraint(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
        self.velocity_constraint_with_sines(c, t, q, v, &ezy::sines(q), out);
    }
    fn velocity_jacobian_with_sines(
        &self,
        c: &[T],
        t: T,
        q: &[T],
        sines: &[[T; 2]],
        out: &mut [T],
    ) {
        let first_link: i64 = 0;
        let mut place = 0;
        {
            let slots: [usize; 1] = [3 * (first_link + 0) as usize];
            let l_over_two = c[2usize];
            let [sin_link_0_phi, cos_link_0_phi] = sines[slots[0] / 3];
            out[place] = -T::from_f64(1f64);
            place += 1;
            out[place] = -(l_over_two * sin_link_0_phi);
            place += 1;
            out[place] = -T::from_f64(1f64);
            place += 1;
            out[place] = l_over_two * cos_link_0_phi;
            place += 1;
        }
        for at_i in 1..(self.n as i64) {
            let slots: [usize; 2] = [
                3 * (first_link + (at_i - 1)) as usize,
                3 * (first_link + at_i) as usize,
            ];
            let l_over_two = c[2usize];
            let [sin_link_i_1_phi, cos_link_i_1_phi] = sines[slots[0] / 3];
            let [sin_link_i_phi, cos_link_i_phi] = sines[slots[1] / 3];
            out[place] = T::from_f64(1f64);
            place += 1;
            out[place] = -(l_over_two * sin_link_i_1_phi);
            place += 1;
            out[place] = -T::from_f64(1f64);
            place += 1;
            out[place] = -(l_over_two * sin_link_i_phi);
            place += 1;
            out[place] = T::from_f64(1f64);
            place += 1;
            out[place] = l_over_two * cos_link_i_1_phi;
            place += 1;
            out[place] = -T::from_f64(1f64);
            place += 1;
            out[place] = l_over_two * cos_link_i_phi;
            place += 1;
        }
    }
    fn velocity_jacobian(&self, c: &[T], t: T, q: &[T], out: &mut [T]) {
        self.velocity_jacobian_with_sines(c, t, q, &ezy::sines(q), out);
    }
    fn convective_term_with_sines(
        &self,
        c: &[T],
        t: T,
        q: &[T],
        v: &[T],
        sines: &[[T; 2]],
        out: &mut [T],
    ) {
        let first_link: i64 = 0;
        let mut place = 0;
        {
            let slots: [usize; 1] = [3 * (first_link + 0) as usize];
            let l_over_two = c[2usize];
            let link_0_omega = v[slots[0] + 2];
            let product_3 = link_0_omega * (l_over_two * link_0_omega);
            let [sin_link_0_phi, cos_link_0_phi] = sines[slots[0] / 3];
            out[place] = -(product_3 * cos_link_0_phi);
            place += 1;
            out[place] = -(product_3 * sin_link_0_phi);
            place += 1;
        }
        for at_i in 1..(self.n as i64) {
            let slots: [usize; 2] = [
                3 * (first_link + (at_i - 1)) as usize,
                3 * (first_link + at_i) as usize,
            ];
            let link_i_1_omega = v[slots[0] + 2];
            let link_i_1_omega_squared = link_i_1_omega * link_i_1_omega;
            let [sin_link_i_1_phi, cos_link_i_1_phi] = sines[slots[0] / 3];
            let link_i_omega = v[slots[1] + 2];
            let link_i_omega_squared = link_i_omega * link_i_omega;
            let [sin_link_i_phi, cos_link_i_phi] = sines[slots[1] / 3];
            let l_over_two = c[2usize];
            let product_14 = T::fused(
                link_i_omega_squared,
                cos_link_i_phi,
                link_i_1_omega_squared * cos_link_i_1_phi,
            ) * l_over_two;
            let product_20 = l_over_two
                * T::fused(
                    link_i_omega_squared,
                    sin_link_i_phi,
                    link_i_1_omega_squared * sin_link_i_1_phi,
                );
            out[place] = -product_14;
            place += 1;
            out[place] = -product_20;
            place += 1;
        }
    }
    fn convective_term(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
        self.convective_term_with_sines(c, t, q, v, &ezy::sines(q), out);
    }
    fn applied_force(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
        let first_link: i64 = 0;
        out.fill(T::from_f64(0f64));
        for at_i in 0..(self.n as i64) {
            let slots: [usize; 1] = [3 * (first_link + at_i) as usize];
            let m_g = c[3usize];
            out[slots[0] + 1] = out[slots[0] + 1] + -m_g;
        }
    }
    fn outputs(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
        let first_link: i64 = 0;
        let mut place = 0;
        {
            let slots: [usize; 1] = [3 * (first_link + ((self.n as i64) - 1)) as usize];
            let one_over_n_l = c[4usize];
            let link_n_1_y = q[slots[0] + 1];
            let k17 = c[5usize];
            let link_n_1_phi = q[slots[0] + 2];
            let sin_link_n_1_phi = T::sin(link_n_1_phi);
            out[place] = -T::fused(k17, sin_link_n_1_phi, one_over_n_l * link_n_1_y);
            place += 1;
        }
    }
    fn takes_sines(&self) -> bool {
        true
    }
}
