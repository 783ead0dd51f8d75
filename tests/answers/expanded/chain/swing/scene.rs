#[automatically_derived]
impl ezy::Scene for Swing {
    fn info(&self) -> ::std::sync::Arc<ezy::SceneInfo> {
        static KNOWN: ezy::Known = ezy::Known::new();
        let scene = self.clone();
        KNOWN.info(&Self::FIXED, &[self.n], move |layout| scene.describe(layout))
    }
    fn parameter(&self, index: usize) -> f64 {
        match index {
            0usize => self.l,
            1usize => self.m,
            2usize => self.g,
            _ => f64::NAN,
        }
    }
    fn set_parameter(&mut self, index: usize, value: f64) {
        match index {
            0usize => self.l = value,
            1usize => self.m = value,
            2usize => self.g = value,
            _ => {}
        }
    }
    fn power(
        &self,
        c: &[f64],
        t: f64,
        q: &[f64],
        v: &[f64],
        lambda: &[f64],
        out: &mut [f64],
    ) {
        out.fill(0f64);
    }
    fn points(&self, c: &[f64], t: f64, q: &[f64], out: &mut [f64]) {
        let first_link: i64 = 0;
        let mut place = 0;
        {
            out[place] = 0f64;
            place += 1;
            out[place] = 0f64;
            place += 1;
        }
        {
            let slots: [usize; 1] = [3 * (first_link + ((self.n as i64) - 1)) as usize];
            let link_n_1_x = q[slots[0] + 0];
            let l_over_two = c[2usize];
            let link_n_1_phi = q[slots[0] + 2];
            let (sin_link_n_1_phi, cos_link_n_1_phi) = f64::sin_cos(link_n_1_phi);
            let link_n_1_y = q[slots[0] + 1];
            out[place] = link_n_1_x + l_over_two * cos_link_n_1_phi;
            place += 1;
            out[place] = link_n_1_y + l_over_two * sin_link_n_1_phi;
            place += 1;
        }
        for at_i in 1..(self.n as i64) {
            let slots: [usize; 1] = [3 * (first_link + (at_i - 1)) as usize];
            let link_i_1_x = q[slots[0] + 0];
            let l_over_two = c[2usize];
            let link_i_1_phi = q[slots[0] + 2];
            let (sin_link_i_1_phi, cos_link_i_1_phi) = f64::sin_cos(link_i_1_phi);
            let link_i_1_y = q[slots[0] + 1];
            out[place] = link_i_1_x + l_over_two * cos_link_i_1_phi;
            place += 1;
            out[place] = link_i_1_y + l_over_two * sin_link_i_1_phi;
            place += 1;
        }
    }
    fn potential_energy(&self, c: &[f64], t: f64, q: &[f64]) -> f64 {
        let first_link: i64 = 0;
        let mut total = 0f64;
        for at_i in 0..(self.n as i64) {
            let slots: [usize; 1] = [3 * (first_link + at_i) as usize];
            let m_g = c[3usize];
            let link_i_y = q[slots[0] + 1];
            total += m_g * link_i_y;
        }
        total
    }
    fn start(&self, c: &[f64], start: &mut ezy::Start) {
        let first_link: i64 = 0;
        for at_i in 0..(self.n as i64) {
            let slots: [usize; 1] = [3 * (first_link + at_i) as usize];
            start.give_position(slots[0] + 2, 0f64);
        }
    }
}
