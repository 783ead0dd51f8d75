//! Numbers and names, bodies and points, arrays.

ezy_core::model! {
    pub model Param {
        param l: mm = 300;
        param tilt: deg = 20;
        body bar { mass: 1, inertia: 0.01 }
        hinge pin: ground(0, 0) ~ bar(-l/2, 0);
        gravity (0, -9.81);
        start aside { bar angle tilt; at rest; }
        scene swing { start aside; until 1 s; }
    }
}

ezy_core::model! {
    pub model Named {
        param k: N/m^2 = 3;
        body cart { mass: 2, inertia: 1 }
        slider rail: ground(0, 0) ~ cart(0, 0) along ground(1, 0);
        let stretch = cart.x - 1 m;
        force at cart(0, 0): (-k*stretch*abs(stretch), 0);
        start aside { cart at (1.5, 0); at rest; }
        scene swing { start aside; until 1 s; }
    }
}

ezy_core::model! {
    pub model Count {
        count n = 5;
        body link[n] { mass: 1, inertia: 1/12 }
        hinge top: ground(0, 0) ~ link[0](-0.5, 0);
        for i in 1..n { hinge pin[i]: link[i-1](0.5, 0) ~ link[i](-0.5, 0); }
        gravity (0, -9.81);
        start level { for i in 0..n { link[i] angle -0.1*i; } at rest; }
        scene swing { start level; until 1 s; }
    }
}

ezy_core::model! {
    pub model Input {
        body cart { mass: 2, inertia: 1 }
        slider rail: ground(0, 0) ~ cart(0, 0) along ground(1, 0);
        input push: N = 1;
        force at cart(0, 0): (push, 0);
        start here { cart at (0, 0); at rest; }
        scene pushed { start here; until 2 s; }
    }
}

ezy_core::model! {
    pub model State {
        param u: V = 12;
        param R: ohm = 0.5;
        param L: mH = 2;
        param k: N*m/A = 0.05;
        body wheel { mass: 1, inertia: 2e-3 }
        hinge axle: ground(0, 0) ~ wheel(0, 0);
        /// current of the armature
        state current: A = 0 rate (u - R*current - k*wheel.omega)/L;
        torque wheel: k*current;
        output heat: W = R*current^2;
        start standing { at rest; }
        scene spun_up { start standing; until 2 s; }
    }
}

ezy_core::model! {
    pub model Output {
        body ball { mass: 1, inertia: 1 }
        gravity (0, -9.81);
        output speed: m/s = norm(ball.v);
        start thrown { ball at (0, 0) velocity (3, 4); }
        scene flight { start thrown; until 1 s; }
    }
}

ezy_core::model! {
    pub model Body {
        param a: m = 0.6;
        param m: kg = 2;
        body plate { mass: m, inertia: m*a^2/6 }
        point A = plate(-a/2, -a/2);
        point B = plate(a/2, -a/2);
        point C = plate(a/2, a/2);
        point D = plate(-a/2, a/2);
        start turning { plate at (0, 0) angle 0.3 velocity (1, 0) rate 2; }
        scene flight { start turning; until 1 s; }
    }
}

ezy_core::model! {
    pub model Point {
        param l: m = 1;
        body bar { mass: 1, inertia: 1/12 }
        point tip = bar(l/2, 0);
        hinge pin: ground(0, 0) ~ bar(-l/2, 0);
        gravity (0, -9.81);
        output height: m = tip.y;
        start level { bar angle 0.4; at rest; }
        scene swing { start level; until 1 s; }
    }
}

ezy_core::model! {
    pub model Repeated {
        body link[3] { mass: 1, inertia: 1/12 }
        hinge top: ground(0, 0) ~ link[0](-0.5, 0);
        for i in 1..3 { hinge pin[i]: link[i-1](0.5, 0) ~ link[i](-0.5, 0); }
        gravity (0, -9.81);
        start level { for i in 0..3 { link[i] angle -0.4*i; } at rest; }
        scene swing { start level; until 1 s; }
    }
}
