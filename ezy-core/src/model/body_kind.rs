//! Kinds of bodies: how many positions and velocities each has, and how the ones follow the others.

use crate::scalar::Scalar;
use std::ops::Range;

/// What a body can do. A scene whose bodies are all planar does not list them ([`SceneInfo::kinds`](super::SceneInfo::kinds)).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum BodyKind {
    /// Moves in the plane: x, y, φ; vx, vy, ω.
    #[default]
    Planar,
    /// Moves in space: the centre of mass x, y, z and a unit quaternion s, i, j, k from the axes of the body to those of the ground, scalar first; the
    /// velocity of the centre in the axes of the ground, and the angular velocity in those of the body. These are the principal
    /// axes, so that M is diagonal; the torque −ω × Iω is a part of F.
    Spatial,
}

/// A position or a velocity of a body.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Component {
    /// Name behind that of the body.
    pub name: &'static str,
    /// Unit; 1 for parts of a quaternion.
    pub unit: &'static str,
}

impl Component {
    /// Whether it is an angle, or the rate of one.
    pub(crate) fn is_angle(&self) -> bool {
        matches!(self.unit, "rad" | "rad/s")
    }

    /// Whether it is a length, or the rate of one.
    pub(crate) fn is_length(&self) -> bool {
        matches!(self.unit, "m" | "m/s")
    }
}

/// Names and units of a table.
const fn all<const N: usize>(of: [(&'static str, &'static str); N]) -> [Component; N] {
    let mut table = [Component { name: "", unit: "" }; N];
    let mut i = 0;
    while i < N {
        table[i] = Component { name: of[i].0, unit: of[i].1 };
        i += 1;
    }
    table
}

const OF_PLANAR: ([Component; 3], [Component; 3]) =
    (all([("x", "m"), ("y", "m"), ("phi", "rad")]), all([("vx", "m/s"), ("vy", "m/s"), ("omega", "rad/s")]));

const OF_SPATIAL: ([Component; 7], [Component; 6]) = (
    all([("x", "m"), ("y", "m"), ("z", "m"), ("s", "1"), ("i", "1"), ("j", "1"), ("k", "1")]),
    all([
        ("vx", "m/s"),
        ("vy", "m/s"),
        ("vz", "m/s"),
        ("omega_x", "rad/s"),
        ("omega_y", "rad/s"),
        ("omega_z", "rad/s"),
    ]),
);

impl BodyKind {
    /// Its positions, in the order of q.
    pub const fn positions(self) -> &'static [Component] {
        match self {
            Self::Planar => &OF_PLANAR.0,
            Self::Spatial => &OF_SPATIAL.0,
        }
    }

    /// Its velocities, in the order of v.
    pub const fn velocities(self) -> &'static [Component] {
        match self {
            Self::Planar => &OF_PLANAR.1,
            Self::Spatial => &OF_SPATIAL.1,
        }
    }

    /// q' = N(q) v.
    fn position_rates<T: Scalar>(self, q: &[T], v: &[T], out: &mut [T]) {
        match (self, q, v) {
            (Self::Spatial, &[.., s, i, j, k], &[vx, vy, vz, wx, wy, wz]) => {
                let [s, i, j, k] = quaternion_rate([s, i, j, k], [wx, wy, wz]);
                out.copy_from_slice(&[vx, vy, vz, s, i, j, k]);
            }
            _ => out.copy_from_slice(v),
        }
    }

    /// Moves `q` by the displacement `delta`, small and in the axes of the velocities; a quaternion keeps unit length.
    fn retract<T: Scalar>(self, q: &mut [T], delta: &[T]) {
        match (self, &mut *q, delta) {
            (Self::Spatial, &mut [.., s, i, j, k], &[x, y, z, wx, wy, wz]) => {
                let [s, i, j, k] = quaternion_rate([s, i, j, k], [wx, wy, wz]);
                add(q, &[x, y, z, s, i, j, k]);
                self.normalize(q);
            }
            _ => add(q, delta),
        }
    }

    /// Brings a quaternion back to unit length.
    fn normalize<T: Scalar>(self, q: &mut [T]) {
        if let (Self::Spatial, [.., s, i, j, k]) = (self, q) {
            let length = (*s * *s + *i * *i + *j * *j + *k * *k).sqrt();
            [s, i, j, k].into_iter().for_each(|part| *part = *part / length);
        }
    }

    /// The coordinate that moves with each velocity; of a turn in space the part of the quaternion along its axis.
    const fn coordinates_moved(self) -> &'static [usize] {
        match self {
            Self::Planar => &[0, 1, 2],
            Self::Spatial => &[0, 1, 2, 4, 5, 6],
        }
    }
}

/// ½ p ∘ (0, ω).
fn quaternion_rate<T: Scalar>([s, i, j, k]: [T; 4], [x, y, z]: [T; 3]) -> [T; 4] {
    let half = T::from_f64(0.5);
    [
        -(half * (i * x + j * y + k * z)),
        half * (s * x + j * z - k * y),
        half * (s * y + k * x - i * z),
        half * (s * z + i * y - j * x),
    ]
}

fn add<T: Scalar>(q: &mut [T], by: &[T]) {
    q.iter_mut().zip(by).for_each(|(q, by)| *q = *q + *by);
}

/// The bodies of a scene, each with the places of its positions and of its velocities.
fn places(kinds: &[BodyKind]) -> impl Iterator<Item = (BodyKind, Range<usize>, Range<usize>)> + '_ {
    let mut next = (0, 0);
    kinds.iter().map(move |&kind| {
        let first = next;
        next = (first.0 + kind.positions().len(), first.1 + kind.velocities().len());
        (kind, first.0..next.0, first.1..next.1)
    })
}

/// q' = N(q) v of all bodies; these are their kinds, none where all are planar.
#[inline]
pub(crate) fn position_rates<T: Scalar>(kinds: &[BodyKind], q: &[T], v: &[T], out: &mut [T]) {
    if kinds.is_empty() {
        out.copy_from_slice(v);
    }
    for (kind, of_q, of_v) in places(kinds) {
        kind.position_rates(&q[of_q.clone()], &v[of_v], &mut out[of_q]);
    }
}

/// Moves positions by a small displacement in the axes of the velocities.
#[inline]
pub(crate) fn retract<T: Scalar>(kinds: &[BodyKind], q: &mut [T], delta: &[T]) {
    if kinds.is_empty() {
        add(q, delta);
    }
    for (kind, of_q, of_v) in places(kinds) {
        kind.retract(&mut q[of_q], &delta[of_v]);
    }
}

/// Brings quaternions back to unit length.
#[inline]
pub(crate) fn normalize<T: Scalar>(kinds: &[BodyKind], q: &mut [T]) {
    for (kind, of_q, _) in places(kinds) {
        kind.normalize(&mut q[of_q]);
    }
}

/// Sets quaternions to those of bodies whose axes are those of the ground.
pub(crate) fn set_upright(kinds: &[BodyKind], q: &mut [f64]) {
    for (kind, of_q, _) in places(kinds) {
        if let (BodyKind::Spatial, [.., s, i, j, k]) = (kind, &mut q[of_q]) {
            [*s, *i, *j, *k] = [1.0, 0.0, 0.0, 0.0];
        }
    }
}

/// The first body whose quaternion is zero, by its place among the bodies.
pub(crate) fn without_attitude(kinds: &[BodyKind], q: &[f64]) -> Option<usize> {
    places(kinds).position(|(kind, of_q, _)| match (kind, &q[of_q]) {
        (BodyKind::Spatial, [.., s, i, j, k]) => [s, i, j, k].into_iter().all(|part| *part == 0.0),
        _ => false,
    })
}

/// The coordinate that moves with each of `n_v` velocities.
pub(crate) fn coordinates_moved(kinds: &[BodyKind], n_v: usize) -> Vec<usize> {
    if kinds.is_empty() {
        return (0..n_v).collect();
    }
    let of_body =
        |(kind, of_q, _): (BodyKind, Range<usize>, _)| kind.coordinates_moved().iter().map(move |i| of_q.start + i);
    places(kinds).flat_map(of_body).collect()
}

/// Along which velocities given coordinates (`n_q`) are held: a quaternion in all its turns where any part of it is given.
pub(crate) fn held(kinds: &[BodyKind], given: &[bool]) -> Vec<bool> {
    if kinds.is_empty() {
        return given.to_vec();
    }
    let of_body = |(kind, of_q, _): (BodyKind, Range<usize>, _)| {
        let given = &given[of_q];
        match (kind, given) {
            (BodyKind::Spatial, &[x, y, z, ref quaternion @ ..]) => {
                let turns = quaternion.contains(&true);
                vec![x, y, z, turns, turns, turns]
            }
            _ => given.to_vec(),
        }
    };
    places(kinds).flat_map(of_body).collect()
}
