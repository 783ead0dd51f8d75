#[automatically_derived]
impl ezy::Scene for Coast {
    fn info(&self) -> ::std::sync::Arc<ezy::SceneInfo> {
        static INFO: ::std::sync::LazyLock<::std::sync::Arc<ezy::SceneInfo>> = ::std::sync::LazyLock::new(||
        ::std::sync::Arc::new(Coast::INFO));
        ::std::sync::Arc::clone(&INFO)
    }
    fn parameter(&self, index: usize) -> f64 {
        match index {
            0usize => self.a,
            1usize => self.b,
            2usize => self.c,
            3usize => self.d,
            4usize => self.m1,
            5usize => self.i1,
            6usize => self.m2,
            7usize => self.i2,
            _ => f64::NAN,
        }
    }
    fn set_parameter(&mut self, index: usize, value: f64) {
        match index {
            0usize => self.a = value,
            1usize => self.b = value,
            2usize => self.c = value,
            3usize => self.d = value,
            4usize => self.m1 = value,
            5usize => self.i1 = value,
            6usize => self.m2 = value,
            7usize => self.i2 = value,
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
        ezy::Powers::powers(self, c, t, q, v, lambda, out);
    }
    fn points(&self, c: &[f64], t: f64, q: &[f64], out: &mut [f64]) {
        let c = ezy::array::<46usize, f64>(c);
        let q = ezy::array::<6usize, f64>(q);
        let out = ezy::array_mut::<6usize, f64>(out);
        let seat_x = q[0usize];
        let parameter_a = c[21usize];
        let seat_phi = q[2usize];
        let (sin_seat_phi, cos_seat_phi) = f64::sin_cos(seat_phi);
        let seat_y = q[1usize];
        let bar_x = q[3usize];
        let parameter_c = c[22usize];
        let bar_phi = q[5usize];
        let (sin_bar_phi, cos_bar_phi) = f64::sin_cos(bar_phi);
        let bar_y = q[4usize];
        let b = c[4usize];
        out[0usize] = seat_x - parameter_a * cos_seat_phi;
        out[1usize] = seat_y - parameter_a * sin_seat_phi;
        out[2usize] = bar_x + parameter_c * cos_bar_phi;
        out[3usize] = bar_y + parameter_c * sin_bar_phi;
        out[4usize] = seat_x + cos_seat_phi * b;
        out[5usize] = seat_y + sin_seat_phi * b;
    }
    fn potential_energy(&self, c: &[f64], t: f64, q: &[f64]) -> f64 {
        0f64
    }
    fn start(&self, c: &[f64], start: &mut ezy::Start) {
        let c = ezy::array::<46usize, f64>(c);
        let parameter_a = c[21usize];
        let pi_over_two = c[29usize];
        start.give_position(0usize, parameter_a);
        start.give_position(1usize, 0f64);
        start.give_position(2usize, 0f64);
        start.give_position(5usize, pi_over_two);
        start.give_velocity(0usize, 1f64);
        start.give_velocity(2usize, 0f64);
    }
}
