//! The wheeled snake against momenta and against its equations in three coordinates.

use ezy_core::prelude::*;
use ezy_core_tests::simulation;
use ezy_models::wheeled_snake;
use nalgebra::{Matrix3, Vector3};

const N: usize = 10;

/// RK4 at 5 ms in both formulations, with a wave of 2 rad/s: (ωh)⁴/120 of 20 rad, some ten times.
const TWO_ROUTES: f64 = 1e-8;

/// A link's coordinates with their time derivative and second derivative, of which those of the head are free:
/// `acceleration + jacobian · (ẍ, ÿ, φ̈ of the head)`.
struct Link {
    position: Vector3<f64>,
    velocity: Vector3<f64>,
    acceleration: Vector3<f64>,
    jacobian: Matrix3<f64>,
}

/// All links from the head's coordinates and velocities, with the angles of the joints prescribed.
fn links(s: &wheeled_snake::Crawling, t: f64, head: &[f64; 6]) -> Vec<Link> {
    let mut links: Vec<Link> = Vec::new();
    let [mut angle, mut rate, mut rest] = [head[2], head[5], 0.0];
    // the end of the last link, behind which the next one begins
    let mut end = [Vector3::zeros(); 2];
    let (mut end_acceleration, mut end_jacobian) = (Vector3::zeros(), Matrix3::zeros());
    for k in 0..N {
        if k > 0 {
            let phase = s.omega * t - (k - 1) as f64 * s.beta;
            // φ of the next link is φ of the last plus the joint's angle
            angle += s.amplitude * phase.sin();
            rate += s.amplitude * s.omega * phase.cos();
            rest -= s.amplitude * s.omega * s.omega * phase.sin();
        }
        let (sin, cos) = angle.sin_cos();
        // half a link, along and turned by 90 degrees
        let (e, n) = (Vector3::new(cos, sin, 0.0) * s.l / 2.0, Vector3::new(-sin, cos, 0.0) * s.l / 2.0);
        let turning = n * rest - e * rate * rate;
        if k == 0 {
            end = [Vector3::new(head[0], head[1], 0.0) + e, Vector3::new(head[3], head[4], 0.0) + n * rate];
            end_acceleration = turning;
            end_jacobian = Matrix3::identity();
            end_jacobian[(2, 2)] = 0.0;
            end_jacobian.set_column(2, &n);
        }
        let mut column = n;
        column[2] = 0.0;
        let mut jacobian = end_jacobian;
        let turned = jacobian.column(2) - column;
        jacobian.set_column(2, &turned);
        jacobian.set_row(2, &Vector3::new(0.0, 0.0, 1.0).transpose());
        let (position, velocity, acceleration) = (end[0] - e, end[1] - n * rate, end_acceleration - turning);
        links.push(Link {
            position: Vector3::new(position[0], position[1], angle),
            velocity: Vector3::new(velocity[0], velocity[1], rate),
            acceleration: Vector3::new(acceleration[0], acceleration[1], rest),
            jacobian,
        });
        end = [position - e, velocity - n * rate];
        end_acceleration = acceleration - turning;
        let turned = jacobian.column(2) - column;
        end_jacobian = jacobian;
        end_jacobian.set_column(2, &turned);
        end_jacobian[(2, 2)] = 0.0;
    }
    links
}

/// Σ Jᵀ (M a − F) = 0, solved for the head.
fn rates(s: &wheeled_snake::Crawling, t: f64, head: &[f64; 6]) -> [f64; 6] {
    let mass = Matrix3::from_diagonal(&Vector3::new(s.m, s.m, s.i));
    let (mut lhs, mut rhs) = (Matrix3::zeros(), Vector3::zeros());
    for link in links(s, t, head) {
        let (sin, cos) = link.position[2].sin_cos();
        let (e, n) = (Vector3::new(cos, sin, 0.0), Vector3::new(-sin, cos, 0.0));
        let force = -e * s.along * e.dot(&link.velocity) - n * s.across * n.dot(&link.velocity);
        lhs += link.jacobian.transpose() * mass * link.jacobian;
        rhs += link.jacobian.transpose() * (force - mass * link.acceleration);
    }
    let a = lhs.lu().solve(&rhs).expect("a positive mass matrix");
    [head[3], head[4], head[5], a[0], a[1], a[2]]
}

#[test]
fn cross_crawling_snake_against_three_coordinates() {
    let scene = wheeled_snake::Crawling::default();
    let (step, n_steps) = (5e-3, 400);
    let run = simulation(&scene).method(Method::rk4(step)).until(step * n_steps as f64).run().unwrap();
    let (q, v) = (run.first().coordinates, run.first().velocities);
    let mut head = [q[0], q[1], q[2], v[0], v[1], v[2]];
    for k in 0..n_steps {
        head = crate::scenes::rk4(|t, head| rates(&scene, t, head), step * k as f64, &head, step);
    }
    let all: Vec<f64> = links(&scene, run.last().t, &head)
        .iter()
        .flat_map(|link| link.position.iter().copied().collect::<Vec<_>>())
        .collect();
    let error = crate::scenes::distance(run.last().coordinates, &all);
    assert!(error <= TWO_ROUTES, "{error:.1e}");
}

/// RK4 at 5 ms; the links move with 0.1 kg·m/s each.
const MOMENTUM: f64 = 1e-9;

#[test]
fn invariant_floating_snake_has_no_momentum() {
    let scene = wheeled_snake::Floating::default();
    let run = simulation(&scene).method(Method::rk4(5e-3)).until(2.0).every(0.2).run().unwrap();
    for s in run.samples() {
        let mut momentum = [0.0; 3];
        for (q, v) in s.coordinates.chunks(3).zip(s.velocities.chunks(3)) {
            momentum[0] += scene.m * v[0];
            momentum[1] += scene.m * v[1];
            momentum[2] += scene.m * (q[0] * v[1] - q[1] * v[0]) + scene.i * v[2];
        }
        assert!(momentum.iter().all(|p| p.abs() <= MOMENTUM), "{momentum:?} at {} s", s.t);
    }
}

/// RK4 at 1 ms on muscles that relax within 0.1 s; J.
const ENERGY: f64 = 1e-8;

#[test]
fn invariant_slithering_snake_moves_ahead_on_the_work_of_its_muscles() {
    let scene = wheeled_snake::Slithering::default();
    let run = simulation(&scene).method(Method::rk4(1e-3)).until(5.0).every(1.0).work().run().unwrap();
    assert!(run.outcome.reached_end(), "{}", run.outcome);
    for s in run.samples() {
        assert!(s.energy.balance.abs() <= ENERGY, "{:.1e} J at {} s", s.energy.balance, s.t);
    }
    let [first, last] = [run.first(), run.last()].map(|s| [s.coordinates[0], s.coordinates[1]]);
    let moved = (last[0] - first[0]).hypot(last[1] - first[1]);
    assert!(moved > 5.0 * scene.l, "{moved} m");
}
