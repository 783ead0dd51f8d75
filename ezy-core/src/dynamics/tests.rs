//! Mechanisms for the tests of this layer.

crate::model! {
    /// A four-bar linkage with a coupler of 3 m.
    pub model Linkage {
        body crank { mass: 1, inertia: 0.1 }
        body coupler { mass: 1, inertia: 1 }
        body rocker { mass: 1, inertia: 0.5 }
        hinge A: ground(0, 0) ~ crank(0, 0);
        hinge B: crank(1, 0) ~ coupler(-1.5, 0);
        hinge C: coupler(1.5, 0) ~ rocker(2, 0);
        hinge D: ground(3, 0) ~ rocker(0, 0);
        start turning { crank angle 1 rate 1; coupler near angle 0.3; rocker near angle 1.5; }
        scene turns { start turning; until 1 s; }
    }
}

crate::model! {
    /// Rods in a row.
    pub model Row {
        count n = 20;
        body rods[n] { mass: 1, inertia: 1/12 }
        hinge top: ground(0, 0) ~ rods[0](-0.5 m, 0);
        for i in 1..n {
            hinge pins[i]: rods[i-1](0.5 m, 0) ~ rods[i](-0.5 m, 0);
        }
        start level { for i in 0..n { rods[i] angle 0; } at rest; }
        scene swings { start level; until 1 s; }
    }
}
