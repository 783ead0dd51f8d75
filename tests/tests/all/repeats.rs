//! Counts, arrays and `for` in the model language: every construct once, faults of counts at run time.

use crate::scenes::assert_checks;
use ezy_core::dynamics::SystemError;
use ezy_core::model::LayoutFault;
use ezy_core::prelude::*;
use ezy_core_tests::{simulation, system_of};

model! {
    /// A hub with spokes, a train of carts behind it, sledges on a grid.
    model Everything {
        count n = 3;
        count m = 2;
        param l: m = 0.7;
        param k: N/m = 20.0;
        param c: N*s/m = 0.3;
        input push: N = 1.5;

        body spoke[n] { mass: 1.0 + 1.0/n, inertia: 0.1 }
        body hub { mass: 5.0, inertia: 0.4 }
        body cart[n+1] { mass: 0.5, inertia: 0.05 }
        body sledge[n, m] { mass: 2.0, inertia: 0.2 }

        hinge axle: ground(0, 0) ~ hub(0, 0);
        for i in 0..n {
            hinge rim[i]: hub(l*cos(2*pi*i/n), l*sin(2*pi*i/n)) ~ spoke[i](-l/2, 0);
            point end[i] = spoke[i](l/2, 0.1*i);
            torsion hub ~ spoke[i]: stiffness 3 + i, angle 0.1*i;
        }
        hinge coupling: ground(3, 0) ~ cart[0](l, 0);
        for i in 1..n+1 { hinge pin[i]: cart[i-1](-l, 0) ~ cart[i](l, 0); }
        for i in 1..n+1 { skate wheel[i]: at cart[i](-0.2, 0) along cart[i](1, 0); }
        for i in 0..n {
            for j in 0..m {
                skate blade[i, j]: at sledge[i, j](0.1*j, 0) along sledge[i, j](1, i);
                spring sledge[i, j](0, 0) ~ ground(i, j): stiffness k, length 0.2, damping c;
            }
        }
        for i in 1..n { for j in 0..m { spring sledge[i-1, j](0.1, 0) ~ sledge[i, j](-0.1, 0): stiffness k, length l; } }
        gravity (0, -9.81);
        force at end[n-1]: (push, -c * end[0].vy);

        output spread = end[n-1].r - end[0].r;
        for i in 1..n+1 { output bend[i]: deg = pin[i].angle; }

        effect motors {
            param w: rad/s = 2.0;
            for i in 0..n { drive turn[i]: rim[i].angle = 0.2 * sin(w * t) * (i + 1) + 2*pi*i/n; }
        }
        effect loose { release blade; }

        start spread_out {
            for i in 0..n { spoke[i] angle 2*pi*i/n; }
            for i in 0..n+1 { cart[i] angle 0.1*i; }
            for i in 0..n { for j in 0..m { sledge[i, j] at (i + 0.3, j) angle 0.4; } }
            cart[0] rate 0.5;
        }
        scene all { start spread_out; until 0.2 s; }
        scene driven { start spread_out; until 0.2 s; with motors, loose; }
    }
}

model! {
    /// A member that not every count has.
    model Sixth {
        count n = 6;
        body link[n] { mass: 1, inertia: 1 }
        for i in 0..n { hinge pin[i]: ground(i, 0) ~ link[i](1, 0); }
        rod last: link[5](0, 0) ~ link[0](0, 0) length 5;
        start s { at rest; }
        scene run { start s; until 1 s; }
    }
}

model! {
    /// Rows that refer to one member by two indices in their first pass.
    model Twice {
        count n = 4;
        param k = 1.0;
        body bead[n] { mass: 1, inertia: 0.1 }
        for i in 1..n {
            constraint level[i]: bead[i].y = 0.5 * (bead[i-1].y + k * bead[0].y^2);
            spring bead[i](0, 0.1) ~ bead[0](0.2, 0): stiffness 3, length 0.1;
            torque bead[i] ~ bead[i-1]: -k * bead[0].omega;
        }
        for i in 0..n { drag at bead[i](0, 0): linear 0.1; force at bead[0](0, i): (1, k * bead[i].vx); }
        start s { for i in 1..n { bead[i] at (i, _); } bead[0] velocity (0.1, 0.2); }
        scene run { start s; until 0.5 s; }
    }
}

model! {
    /// Members by indices that divide.
    model Halves {
        count n = 5;
        body bead[n] { mass: 1, inertia: 1 }
        force at bead[n/2](0, 0): (1, 0);
        for i in 0..n { force at bead[(i+1)/3](0, 0): (0, 1); }
        start s { at rest; }
        scene run { start s; until 1 s; }
    }
}

#[test]
fn analytic_indices_that_divide_are_rounded_down() {
    for n in 1..8 {
        let run = simulation(&halves::Run { n }).method(Method::rk4(1e-3)).run().unwrap();
        let a = run.last().accelerations;
        for member in 0..n {
            let above = (0..n).filter(|i| (i + 1) / 3 == member).count();
            let expected = [f64::from(u8::from(member == n / 2)), above as f64];
            assert_eq!(a[3 * member..3 * member + 2], expected, "bead[{member}] of {n}");
        }
    }
}

#[test]
fn fd_members_met_twice_in_a_row_count_twice() {
    for n in [2, 4] {
        assert_checks(&twice::Run { n, ..Default::default() });
    }
}

#[test]
fn fd_every_construct_passes_the_checks_at_several_counts() {
    for (n, m) in [(1, 1), (2, 2)] {
        let scenes: [&dyn Scene; 2] =
            [&everything::All { n, m, ..Default::default() }, &everything::Driven { n, m, ..Default::default() }];
        for scene in scenes {
            assert_checks(scene);
        }
    }
}

#[test]
fn analytic_names_and_sizes_follow_the_counts() {
    let info = everything::All { n: 2, m: 3, ..Default::default() }.info();
    assert_eq!(info.bodies.len(), 2 + 1 + 3 + 6);
    assert_eq!((&*info.bodies[2], &*info.bodies[6], &*info.bodies[11]), ("hub", "sledge[0,0]", "sledge[1,2]"));
    assert_eq!(info.n_position_rows, 2 * (1 + 2 + 1 + 2));
    assert_eq!(info.rows[info.n_position_rows + 2].name, "blade[0,0]");
    let outputs: Vec<&str> = info.outputs.iter().map(|output| &*output.name).collect();
    assert_eq!(outputs, ["spread.x", "spread.y", "bend[1]", "bend[2]"]);
    assert!(info.points.iter().any(|point| point.name == "end[1]" && point.body == Some(1)));
    let driven = everything::Driven { n: 2, m: 3, ..Default::default() }.info();
    assert!(!driven.rows.iter().any(|row| row.name.starts_with("blade")));
    assert_eq!(
        driven.effects.iter().map(|effect| effect.name).collect::<Vec<_>>(),
        ["model", "motors", "loose", "drives"]
    );
}

#[test]
fn analytic_gravity_acts_on_every_member() {
    let scene = everything::All { n: 2, m: 1, ..Default::default() };
    let system = system_of(&scene, Backend::Auto).unwrap();
    let info = system.info();
    let mut force = vec![0.0; info.n_coordinates()];
    let zero = vec![0.0; info.n_coordinates()];
    scene.applied_force(system.fixed(), 0.0, &zero, &zero, &mut force);
    let other = [force[3 * 2 + 1], force[3 * 3 + 1]];
    assert_eq!(other, [-5.0 * 9.81, -0.5 * 9.81]);
    assert!(system.potential_energy(0.0, &zero).is_finite());
}

#[test]
fn invariant_member_that_a_count_lacks_is_named() {
    let fault = match system_of(&sixth::Run { n: 5 }, Backend::Auto).err() {
        Some(SystemError::Layout(fault)) => fault,
        other => panic!("{other:?}"),
    };
    assert_eq!(
        fault,
        LayoutFault::IndexOutOfRange { item: "rod `last`".to_owned(), array: "link", index: 5, length: 5 }
    );
    assert_eq!(
        fault.to_string(),
        "rod `last` uses `link` at the index 5, but its indices go from 0 to 4: change the range of the `for`, the index \
         or the count"
    );
    assert!(system_of(&sixth::Run { n: 7 }, Backend::Auto).is_ok());
}
